# SPDX-License-Identifier: LGPL-2.1-or-later
"""Qt as FreeCAD offers it, on Qt 5 and Qt 6 alike.

Only FreeCAD's own `PySide` is imported.  Its QtGui re-exports the widgets on every version, while QtWidgets is missing
on older ones, so everything is reached through QtGui.
"""

from __future__ import annotations

from contextlib import contextmanager

import FreeCAD as App
from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:  # FreeCAD 0.20: the widgets are in QtGui
    QtWidgets = QtGui

Qt = QtCore.Qt
Signal = QtCore.Signal

translate = App.Qt.translate


def QT_TRANSLATE_NOOP(context, text):
    """Mark a text for translation and return it as it is."""
    return text


def run(loop) -> object:
    """Run a dialog or event loop: `exec` is what newer versions want, `exec_` is all that older ones have."""
    return loop.exec() if hasattr(loop, "exec") else loop.exec_()


def main_window():
    """Return FreeCAD's main window."""
    import FreeCADGui as Gui

    return Gui.getMainWindow()


def buttons(*names: str):
    """Standard buttons by name for a task panel's `getStandardButtons`: an enum on Qt 6, an int on Qt 5."""
    box = QtGui.QDialogButtonBox
    flags = getattr(box, names[0])
    for name in names[1:]:
        flags = flags | getattr(box, name)
    try:
        return int(flags)
    except TypeError:
        return flags


@contextmanager
def busy_cursor():
    """A busy cursor from the first tenth of a second on, until the work is done or a panel or message is shown."""
    application = QtGui.QApplication
    if application.overrideCursor() is not None:
        yield
        return
    # a timer would fire only when the work is over: the cursor is set at once, and the screen shows it after a moment
    application.setOverrideCursor(QtGui.QCursor(Qt.WaitCursor))
    try:
        yield
    finally:
        if application.overrideCursor() is not None:
            application.restoreOverrideCursor()


@contextmanager
def usual_cursor():
    """The usual cursor inside, for dialogs that stop the work that a busy cursor was shown for."""
    application = QtGui.QApplication
    shape = application.overrideCursor()
    if shape is not None:
        shape = QtGui.QCursor(shape)
        application.restoreOverrideCursor()
    try:
        yield
    finally:
        if shape is not None:
            application.setOverrideCursor(shape)


def later(function, milliseconds: int = 0) -> None:
    """Call `function` once from the event loop."""
    QtCore.QTimer.singleShot(milliseconds, function)


class _Post(QtCore.QObject):
    due = Signal(object)

    def __init__(self):
        super().__init__()
        self.due.connect(self.call, Qt.QueuedConnection)

    def call(self, function):
        function()


_post = _Post()


def soon(function) -> None:
    """Call `function` once from the event loop, before anything is painted again.

    Unlike a timer, a posted event comes before Qt's requests to paint, so what it changes is in the same picture.
    """
    _post.due.emit(function)


def pump(milliseconds: int = 0) -> None:
    """Let the window work off what is waiting, for at least so long."""
    clock = QtCore.QElapsedTimer()
    clock.start()
    QtGui.QApplication.processEvents()
    while clock.elapsed() < milliseconds:
        QtGui.QApplication.processEvents()


def dark() -> bool:
    """True where the window's theme is dark."""
    return QtGui.QApplication.palette().color(QtGui.QPalette.Window).lightness() < 128
