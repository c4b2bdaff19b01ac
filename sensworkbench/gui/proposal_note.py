# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the machine panel says of a proposal: that it is one, why each piece of it, and what was not looked at yet.

A reason is dropped as soon as the user chooses otherwise: nothing that was guessed passes for something that was given.
"""

from __future__ import annotations

from contextlib import contextmanager

from ..core.workspace import Cancelled
from ..messages import Message
from . import pointers
from .preferences import combo
from .proposal import Shown, language, selected_links
from .qt import Qt, QtGui, main_window, translate
from .sources import vector_words
from .texts import body_kind

PIECES = {  # property -> the piece of a reason that speaks of it
    "Parts": "parts", "DirectionSource": "direction", "DirectionAlong": "direction", "Reverse": "direction",
    "ReferenceSource": "reference", "ReferenceAt": "reference", "TravelLower": "travel", "TravelUpper": "travel",
}  # fmt: skip


class ProposalNote(QtGui.QFrame):
    """A box at the top of the panel: the reasons, and one question at a time; hidden where nothing was proposed.

    answers : what the person has said so far, as `engine.again` takes it.  answer(name, value) : called with each.
    """

    def __init__(self, shown: Shown, answer):
        super().__init__()
        self.answers, self._answer = {}, answer
        self.setObjectName("SensProposalBox")
        self.setStyleSheet("#SensProposalBox { background: #fff3c4; border: 1px solid #d9a400 }")
        page = QtGui.QVBoxLayout(self)
        page.setContentsMargins(5, 5, 5, 5)
        self.label, self.question = QtGui.QLabel(), QtGui.QLabel()
        for label, name in ((self.label, "SensProposal"), (self.question, "SensQuestion")):
            label.setObjectName(name)
            label.setWordWrap(True)
            label.setTextFormat(Qt.RichText)
            label.setStyleSheet("color: #2b2b2b")
            page.addWidget(label)
        self.buttons = QtGui.QVBoxLayout()
        page.addLayout(self.buttons)
        self.lit = set()
        self.renew(shown)

    def renew(self, shown: Shown) -> None:
        """Another proposal, after an answer."""
        self.proposal = shown
        self.given = shown.found is not None
        self.reasons = {subject: list(pieces) for subject, pieces in shown.reasons.items()}
        self.body = "F"
        self.waiting = list(shown.bodies)
        self.setVisible(self.given)
        self._write()
        self._ask()

    def text(self) -> str:
        """What the box says."""
        return self.label.text()

    def told(self, name: str, value) -> None:
        """The person has chosen in the panel itself: it counts as an answer in what is weighed later."""
        self.answers[name] = value
        if self.asked is not None and self.asked.name == name:
            self._ask()

    # -- the question ------------------------------------------------------------------------------------------------
    def _ask(self) -> None:
        while self.buttons.count():
            widget = self.buttons.takeAt(0).widget()
            widget.setParent(None)
            widget.deleteLater()
        open_ = [q for q in self.proposal.found.questions if q.name not in self.answers] if self.given else []
        self.asked = open_[0] if open_ else None
        self.question.setVisible(self.asked is not None)
        if self.asked is None:
            return
        question = self.asked
        self.question.setText(f"<b>{_safe(question.message.text(language()))}</b>")
        if question.kind in ("part", "parts"):
            self._button(Message("propose-panel-answer"), self.take)
            if question.name == "bed" and self.proposal.found.bodies.get("F"):
                units = self.proposal.found.bodies["F"]
                part = max(units, key=lambda u: u.bulk)
                self._button(Message("propose-choice-yes"), lambda: self._say("bed", part))
        elif question.kind == "travel":
            name = question.name.partition(":")[2]
            travel = self.proposal.found.axes[name].travel
            self._button(Message("propose-panel-keep"), lambda: self._say(question.name, travel))
        for value, message in question.choices:
            self._button(message, lambda v=value: self._say(question.name, v))

    def _button(self, message: Message, press) -> None:
        button = QtGui.QPushButton(message.text(language()))
        button.setObjectName("SensAnswer")
        button.clicked.connect(lambda *_: press())
        self.buttons.addWidget(button)

    def take(self) -> None:
        """The selected parts answer the question."""
        links = [link for link in selected_links() if link not in self.lit]
        if self.asked is None:
            return
        if not links:
            self.question.setText(_safe(Message("propose-panel-select").text(language())))
            return
        self._say(self.asked.name, links)

    def _say(self, name: str, value) -> None:
        self.answers[name] = value
        self._answer(name, value)

    # -- the reasons -------------------------------------------------------------------------------------------------
    def look_at(self, body: str) -> None:
        """The user turns to this component, and has seen the one before."""
        self.waiting = [b for b in self.waiting if b not in (body, self.body)]
        self.body = body
        self._write()

    def drop(self, subject: str, name: str = "", instead: str = "") -> None:
        """The user has chosen himself: the reason for the old choice no longer holds."""
        word = PIECES.get(name, "")
        kept = [piece for piece in self.reasons.get(subject, ()) if word and piece[0] != word]
        if subject == "F" or not word:
            kept = []
        if instead:
            kept.insert(0, (word, instead))
        self.reasons[subject] = kept
        self._write()

    def light_up(self, machine, body: str) -> None:
        """Select the component's parts in the view, to be checked, unless the user has selected others."""
        import FreeCADGui as Gui

        if not self.given or set(selected_links()) - self.lit:
            return
        if machine.Problem and body not in self.proposal.bodies:
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
        if not self.given or body not in self.proposal.bodies:
            return QtGui.QIcon()
        kind = QtGui.QStyle.SP_MessageBoxQuestion if body in self.waiting else QtGui.QStyle.SP_DialogApplyButton
        return self.style().standardIcon(kind)

    def _write(self) -> None:
        if not self.given:
            return
        found = self.proposal.found
        head = Message("propose-panel-check" if found.axes else "propose-panel-nothing")
        lines = [f"<b>{_safe(head.text(language()))}</b>"]
        for subject, title in (
            ("structure", translate("Sens", "Structure")), ("tool point", translate("Sens", "Tool point")),
        ):  # fmt: skip
            for _, piece in self.reasons.get(subject, ()):
                lines.append(f"{title}: {_words(piece)}")
        if self.reasons.get(self.body):
            lines.append(f"<b>{_safe(body_kind(self.body))}</b>")
            lines += [f"• {_words(piece)}" for _, piece in self.reasons[self.body]]
        lines += [_words(note) for note in self.proposal.notes]
        if self.waiting:
            names = ", ".join(body_kind(b) for b in self.waiting)
            lines.append(translate("Sens", "Not looked at yet: {names}").format(names=_safe(names)))
        self.label.setText("<br>".join(lines))

    def directions_box(self, take):
        """A choice of all directions that the geometry suggests, or None; `take(AxisProposal)` answers it."""
        found = self.proposal.directions
        if not found:
            return None
        texts = [f"{vector_words(a.direction, 3)}  {a.why.text(language())}" for a in found]
        box = combo([(-1, translate("Sens", "Choose …")), *enumerate(texts)])
        box.setToolTip(translate("Sens", "Directions of rails, screws and long edges, the longest first"))

        def chosen(row):
            if row > 0:
                take(found[row - 1])
                box.setCurrentIndex(0)

        box.activated.connect(chosen)
        return box


def _words(piece) -> str:
    return _safe(piece.text(language()) if isinstance(piece, Message) else str(piece))


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
