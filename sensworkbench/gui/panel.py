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
from .qt import Qt, QtCore, QtGui, buttons, later, main_window

MARGIN = 14  # pixels of FreeCAD's frame below a panel
NARROWEST, WIDEST = 320, 480  # pixels for a panel beside the 3D view, unless its own form asks for less


class Panel:
    """Base of the task panels.

    standard : names of its buttons.  holds_transaction : it works inside an open one.  guide : the section of the guide
    that F1 shows.  grows : the table or text that takes the height that the other controls leave; `tallest` : its
    greatest useful height in pixels.
    """

    guide = ""
    standard = ("Ok", "Cancel")
    holds_transaction = False
    form = grows = None
    tallest = 900

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
    area = scroll_area(panel.form)
    if panel.grows is not None and area is not None:
        Filler(area, panel.form, panel.grows, panel.tallest)
    elif area is not None:
        Whole(panel.form)


def rows(parent=None):
    """A form of labelled rows, no wider than it must be: a field too long for its label's line stands below it."""
    form = QtGui.QFormLayout(parent) if parent is not None else QtGui.QFormLayout()
    form.setRowWrapPolicy(QtGui.QFormLayout.WrapLongRows)
    form.setFieldGrowthPolicy(QtGui.QFormLayout.AllNonFixedFieldsGrow)
    return form


def scroll_area(form):
    """The scroll area in which FreeCAD shows a panel, or None."""
    widget = form.parentWidget()
    while widget is not None and not isinstance(widget, QtGui.QScrollArea):
        widget = widget.parentWidget()
    return widget


class Filler(QtCore.QObject):
    """Keeps one widget of a panel as high as leaves everything else in view, and never lower than it can be used."""

    LOWEST = 150

    def __init__(self, area, form, widget, tallest: int):
        super().__init__(form)
        self.area, self.form, self.widget, self.tallest = area, form, widget, tallest
        area.viewport().installEventFilter(self)
        form.installEventFilter(self)
        later(self.fit)

    def eventFilter(self, watched, event):
        if event.type() in (QtCore.QEvent.Resize, QtCore.QEvent.LayoutRequest):
            later(self.fit)
        return False

    def fit(self) -> None:
        """Give the widget what the viewport has left beside FreeCAD's header and the panel's other controls."""
        try:
            content, layout = self.area.widget(), self.form.layout()
            fixed = self.widget.minimumHeight() == self.widget.maximumHeight()
            own = self.widget.height() if fixed else self.widget.sizeHint().height()
            others = layout.totalHeightForWidth(self.form.width()) if layout.hasHeightForWidth() else -1
            others = (others if others > 0 else layout.totalSizeHint().height()) - own
            header = self.form.mapTo(content, self.form.rect().topLeft()).y()
            room = self.area.viewport().height() - header - others - MARGIN
            height = min(max(room, self.LOWEST), self.tallest)
            if others >= 0 and (height != own or not fixed):
                self.widget.setFixedHeight(height)
        except RuntimeError:  # the panel is gone
            return


class Whole(QtCore.QObject):
    """Keeps a panel as high as its controls need at its width: texts that wrap are not asked for by FreeCAD."""

    def __init__(self, form):
        super().__init__(form)
        self.form = form
        form.installEventFilter(self)
        later(self.fit)

    def eventFilter(self, watched, event):
        if event.type() in (QtCore.QEvent.Resize, QtCore.QEvent.LayoutRequest):
            later(self.fit)
        return False

    def fit(self) -> None:
        """As high as the layout needs."""
        try:
            layout = self.form.layout()
            needed = layout.totalHeightForWidth(self.form.width()) if layout.hasHeightForWidth() else 0
            if needed > 0 and needed != self.form.minimumHeight():
                self.form.setMinimumHeight(needed)
        except RuntimeError:  # the panel is gone
            return


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
