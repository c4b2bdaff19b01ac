# SPDX-License-Identifier: LGPL-2.1-or-later
"""The look at a document's shapes: a machine panel opens within a second, and is used while the rest is looked at.

The look runs in FreeCAD's own thread, for documents stand no other; between its steps the window works off what
the person does.  Cancel in the panel stops the look and keeps what is known by then.
"""

from __future__ import annotations

import time

from ..core.workspace import Cancelled
from ..document.propose import engine
from ..document.propose.found import Found
from ..document.propose.reading import Document
from .qt import QtGui, usual_cursor

PATIENCE = 0.8  # s before the panel is opened on what is known
TURN = 0.1  # s of looking between two turns of the event loop, at least
SHARE = 3.0  # and so many times what the last turn took: a scene that is slow to draw must not stop the look


class Look:
    """One look.  open_panel(found) : makes and shows the panel; called once, early or at the end."""

    def __init__(self, open_panel):
        self._open, self.panel = open_panel, None
        self._start = self._turned = time.monotonic()
        self._took = 0.0  # s of the last turn
        self._names = None  # what names alone say, once they are read

    def run(self, doc, selection):
        """Look, and return the panel; None where it was closed meanwhile."""
        try:
            found = engine.propose(doc, selection, progress=self.step, early=self.read)
        except Cancelled:
            if self.panel is not None and not self.panel.over:
                self.panel.looked(None)
            return None if self.panel is None or self.panel.over else self.panel
        if self.panel is None:
            self.panel = self._open(found)
        elif not self.panel.over:
            self.panel.looked(found)
        return None if self.panel.over else self.panel

    def read(self, names) -> None:
        """The parts are read: what their names say is shown until their shapes are known."""
        self._names = names
        if self.panel is not None and not self.panel.over:
            found = names(self.panel.guess.answers)
            if found.axes:  # else the panel shows as much already
                self.panel.looked(found, last=False)

    def step(self, done: float, total: float) -> bool:
        """`progress` of the engine: true where the person stopped the look, or the panel is gone."""
        now = time.monotonic()
        if self.panel is None and now - self._start > PATIENCE:
            with usual_cursor():
                self.panel = self._open(self._names() if self._names is not None else Found(document=Document([])))
                self.panel.guess.look(0.0)
                QtGui.QApplication.processEvents()
        elif self.panel is not None and now - self._turned > max(TURN, SHARE * self._took) and not self.panel.over:
            self.panel.guess.look(done / max(total, 1))
            with usual_cursor():
                QtGui.QApplication.processEvents()
        else:
            return False
        self._turned = time.monotonic()
        self._took = self._turned - now
        return self.panel.over or self.panel.guess.stopped
