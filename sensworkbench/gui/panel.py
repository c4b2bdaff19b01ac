# SPDX-License-Identifier: LGPL-2.1-or-later
"""What every task panel shares: how it is shown, fills the height that there is, offers help, and is closed.

FreeCAD keeps a panel open whose document was closed, and greys every command until it is closed.  A panel that holds a
transaction (`holds_transaction`) is closed by undo and redo too: its transaction is over, so Cancel could take nothing
back.
"""

from __future__ import annotations

import FreeCADGui as Gui

from . import state
from .files import icon_path
from .guide import HelpKey
from .qt import Qt, QtGui, buttons, later, main_window

NARROWEST, WIDEST = 320, 480  # pixels for a panel beside the 3D view, unless its own form asks for less


class Panel:
    """Base of the task panels.

    standard : names of its buttons.  holds_transaction : it works inside an open one.  guide : the section of the guide
    that F1 shows.
    """

    guide = ""
    standard = ("Ok", "Cancel")
    holds_transaction = False
    form = None

    def make_form(self, name: str, title: str, icon: str):
        """The panel's empty widget."""
        self.form = QtGui.QWidget()
        self.form.setObjectName(name)
        self.form.setWindowTitle(title)
        self.form.setWindowIcon(QtGui.QIcon(icon_path(icon)))
        HelpKey(self.form, self.guide)
        return self.form

    def getStandardButtons(self):
        return buttons(*self.standard)

    def leave(self) -> None:
        """Stop timers and clear the view; called however the panel is closed, and touches no document."""

    def close(self) -> None:
        """Leave, and let FreeCAD take the panel away."""
        self.leave()
        Gui.Control.closeDialog()

    def reject(self):
        """Cancel or Close was pressed."""
        self.close()
        return True


def show(panel, doc) -> None:
    """Show a task panel that works on a document."""
    Gui.Control.showDialog(panel)
    state.of(doc).panel = panel
    make_wide(panel.form)


def make_wide(form) -> None:
    """Widen the dock that holds a panel where it is too narrow; an overlay keeps the width that FreeCAD gives it."""
    dock = form.parentWidget()
    while dock is not None and not isinstance(dock, QtGui.QDockWidget):
        dock = dock.parentWidget()
    if dock is None or dock.isFloating() or overlaid(dock):
        return
    wanted = min(max(form.sizeHint().width() + 70, NARROWEST), WIDEST, main_window().width() // 3)
    if dock.width() < wanted:
        main_window().resizeDocks([dock], [wanted], Qt.Horizontal)


def overlaid(widget) -> bool:
    """Whether a widget lies over the 3D view."""
    while widget is not None:
        if "Overlay" in widget.metaObject().className():
            return True
        widget = widget.parentWidget()
    return False


def document_gone(name: str) -> None:
    """Close the panel of a document that is being closed."""
    _close_soon(state.of(name))


def undone(name: str) -> None:
    """Close the panel whose transaction undo or redo has ended."""
    found = state.of(name)
    if getattr(found.panel, "holds_transaction", False):
        _close_soon(found)


def _close_soon(found) -> None:
    panel, found.panel = found.panel, None
    if panel is None or panel.form is None:  # FreeCAD has closed it
        return
    panel.leave()

    def close():
        if panel.form is not None:
            Gui.Control.closeDialog()

    later(close)
