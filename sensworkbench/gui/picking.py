# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clicks on parts in the 3D view or the tree, handed on as soon as FreeCAD is done with the selection."""

from __future__ import annotations

import FreeCADGui as Gui

from . import state
from .proposal import selected_links
from .qt import later


class Picks:
    """Calls chosen(links) after each click that selects something.  What the program itself selects is no click."""

    def __init__(self, document, chosen):
        self._document, self._chosen, self._due = document.Name, chosen, False
        Gui.Selection.addObserver(self)

    def stop(self) -> None:
        """Answer no more clicks."""
        if self._chosen is not None:
            self._chosen = None
            Gui.Selection.removeObserver(self)

    def addSelection(self, document, name, sub, point):
        """FreeCAD: something was selected."""
        if not self._due and self._chosen is not None and not state.of(self._document).quiet:
            self._due = True
            later(self._hand_on)

    def setSelection(self, document):
        """FreeCAD: the selection was replaced, as a click in the tree does."""
        self.addSelection(document, "", "", None)

    def _hand_on(self):
        self._due = False
        links = selected_links() if self._chosen is not None else []
        if links:
            self._chosen(links)
