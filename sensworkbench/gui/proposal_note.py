# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the machine panel says of a proposal: that it is one, why each piece of it, and what was not looked at yet.

A reason is dropped as soon as the user chooses otherwise: nothing that was guessed passes for something that was given.
"""

from __future__ import annotations

from contextlib import contextmanager

from ..core.workspace import Cancelled
from . import pointers
from .preferences import combo
from .proposal import BODIES, Proposal, selected_links
from .qt import Qt, QtGui, main_window, translate
from .sources import vector_words
from .texts import body_kind

PIECES = {  # property -> the word that begins its piece of a reason
    "Parts": "parts", "DirectionSource": "direction", "DirectionAlong": "direction", "Reverse": "direction",
    "ReferenceSource": "reference", "ReferenceAt": "reference", "TravelLower": "travel", "TravelUpper": "travel",
}  # fmt: skip


class ProposalNote(QtGui.QLabel):
    """A box at the top of the panel; hidden where nothing but names was looked at.  given : whether it is shown."""

    def __init__(self, found: Proposal):
        super().__init__()
        self.proposal, self.given = found, bool(found.reasons or found.notes)
        self.reasons = dict(found.reasons)
        self.body, self.lit = "F", set()
        self.waiting = [body for body in BODIES if found.parts[body]] if self.given else []
        self.setObjectName("SensProposal")
        self.setWordWrap(True)
        self.setTextFormat(Qt.RichText)
        self.setStyleSheet("QLabel { background: #fff3c4; color: #2b2b2b; border: 1px solid #d9a400; padding: 5px }")
        self.setVisible(self.given)
        self._write()

    def look_at(self, body: str) -> None:
        """The user turns to this component, and has seen the one before."""
        self.waiting = [b for b in self.waiting if b not in (body, self.body)]
        self.body = body
        self._write()

    def drop(self, subject: str, name: str = "", instead: str = "") -> None:
        """The user has chosen himself: the reason for the old choice no longer holds."""
        pieces = [p for p in self.reasons.get(subject, "").split("; ") if p]
        word = PIECES.get(name, "")
        kept = [p for p in pieces if word and not p.startswith(f"{word}:")]
        if subject == "F" or not word:
            kept = []
        if instead:
            kept.insert(0, f"{word}: {instead}")
        self.reasons[subject] = "; ".join(kept)
        self._write()

    def light_up(self, machine, body: str) -> None:
        """Select the component's parts in the view, to be checked, unless the user has selected others."""
        import FreeCADGui as Gui

        if not self.given or set(selected_links()) - self.lit:
            return
        if machine.Problem and not self.proposal.parts[body]:
            Gui.Selection.clearSelection()
        else:
            pointers.select_parts(machine, [body])
        self.lit = set(selected_links())

    def release(self) -> None:
        """Take back the selection that was only for looking."""
        import FreeCADGui as Gui

        if self.lit and not set(selected_links()) - self.lit:
            Gui.Selection.clearSelection()

    def icon(self, body: str):
        """A question mark for what was not looked at yet, a tick for what was; nothing without a proposal."""
        if not self.given or not self.proposal.parts[body]:
            return QtGui.QIcon()
        kind = QtGui.QStyle.SP_MessageBoxQuestion if body in self.waiting else QtGui.QStyle.SP_DialogApplyButton
        return self.style().standardIcon(kind)

    def _write(self) -> None:
        if self.proposal.geometry:
            lines = [translate("Sens", "Proposed from rails, screws and contacts: check everything.")]
        else:
            lines = [translate("Sens", "The geometry does not show which part is which: choose bed and carriages.")]
        lines[0] = f"<b>{lines[0]}</b>"
        for subject, title in (
            ("structure", translate("Sens", "Structure")), ("tool point", translate("Sens", "Tool point")),
        ):  # fmt: skip
            if self.reasons.get(subject):
                lines.append(f"{title}: {_safe(self.reasons[subject])}")
        if self.reasons.get(self.body):
            lines.append(f"<b>{_safe(body_kind(self.body))}</b>")
            lines += [f"• {_safe(piece)}" for piece in self.reasons[self.body].split("; ")]
        lines += [_safe(note) for note in self.proposal.notes]
        if self.waiting:
            names = ", ".join(body_kind(b) for b in self.waiting)
            lines.append(translate("Sens", "Not looked at yet: {names}").format(names=_safe(names)))
        self.setText("<br>".join(lines))

    def directions_box(self, take):
        """A choice of all directions that the geometry suggests, or None; `take(AxisProposal)` answers it."""
        found = self.proposal.directions
        if not found:
            return None
        texts = [f"{vector_words(a.direction, 3)}  {a.why}, {a.length:.0f} mm" for a in found]
        box = combo([(-1, translate("Sens", "Choose …")), *enumerate(texts)])
        box.setToolTip(translate("Sens", "Directions of rails, screws and long edges, the longest first"))

        def chosen(row):
            if row > 0:
                take(found[row - 1])
                box.setCurrentIndex(0)

        box.activated.connect(chosen)
        return box


def _safe(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;")


@contextmanager
def watch():
    """A progress(done, all) that shows a dialog with Cancel after a while, and raises Cancelled there."""
    dialog = QtGui.QProgressDialog(
        translate("Sens", "Looking for rails, screws, and what touches them…"), translate("Sens", "Cancel"), 0, 100,
        main_window(),
    )  # fmt: skip
    dialog.setObjectName("SensLooking")
    dialog.setWindowTitle("Sens Workbench")
    dialog.setWindowModality(Qt.ApplicationModal)
    dialog.setMinimumDuration(400)

    def progress(done: int, total: int) -> bool:
        dialog.setMaximum(max(1, total))
        dialog.setValue(done)
        QtGui.QApplication.processEvents()
        if dialog.wasCanceled():
            raise Cancelled
        return False

    try:
        yield progress
    finally:
        dialog.close()
        dialog.deleteLater()
