# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel that is open: shown wide enough to be read, and closed when what it works on is gone.

FreeCAD keeps a panel open whose document was closed, and greys every command until it is closed.  A panel that holds a
transaction (`holds_transaction`) is closed by undo and redo too: its transaction is over, so Cancel could take nothing
back.  A panel may have `leave()`, called before it is closed so, which stops its timers and touches no document.
"""

from __future__ import annotations

from .qt import Qt, QtGui, later, main_window

NARROWEST, WIDEST = 320, 480  # pixels for a panel beside the 3D view, unless its own form asks for less

_open: list = []  # the panel that was opened last, with the name of its document


def show(panel, doc) -> None:
    """Show a task panel that works on a document."""
    import FreeCADGui as Gui

    Gui.Control.showDialog(panel)
    _open[:] = [(panel, doc.Name)]
    make_wide(panel.form)


def make_wide(form) -> None:
    """Widen the dock that holds a panel where it is too narrow; an overlay keeps the width that FreeCAD gives it."""
    dock = form.parentWidget()
    while dock is not None and not isinstance(dock, QtGui.QDockWidget):
        dock = dock.parentWidget()
    if dock is None or dock.isFloating() or _overlaid(dock):
        return
    wanted = min(max(form.sizeHint().width() + 70, NARROWEST), WIDEST, main_window().width() // 3)
    if dock.width() < wanted:
        main_window().resizeDocks([dock], [wanted], Qt.Horizontal)


def _overlaid(widget) -> bool:
    while widget is not None:
        if "Overlay" in widget.metaObject().className():
            return True
        widget = widget.parentWidget()
    return False


def document_gone(name: str) -> None:
    """Close the panel of a document that is being closed."""
    if _open and _open[0][1] == name:
        _close_soon()


def undone(name: str) -> None:
    """Close the panel whose transaction undo or redo has ended."""
    if _open and _open[0][1] == name and getattr(_open[0][0], "holds_transaction", False):
        _close_soon()


def _close_soon() -> None:
    import FreeCADGui as Gui

    panel, _ = _open.pop()
    if panel.form is None:  # FreeCAD has closed it
        return
    if hasattr(panel, "leave"):
        panel.leave()

    def close():
        if panel.form is not None:
            Gui.Control.closeDialog()

    later(close)
