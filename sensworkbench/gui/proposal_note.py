# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the machine panel says of a proposal: that it is one, why each piece of it, and what was not looked at yet.

A reason is dropped as soon as the user chooses otherwise: nothing that was guessed passes for something that was given.
"""

from __future__ import annotations

from ..document.propose.pinned import pins
from ..messages import Message
from . import pointers
from .preferences import length_box
from .proposal import Shown, language, selected_links
from .qt import Qt, QtGui, translate
from .texts import body_kind

PIECES = {  # property -> the piece of a reason that speaks of it
    "Parts": "parts", "DirectionSource": "direction", "DirectionAlong": "direction", "Reverse": "direction",
    "ReferenceSource": "reference", "ReferenceAt": "reference", "TravelLower": "travel", "TravelUpper": "travel",
}  # fmt: skip


class ProposalNote(QtGui.QFrame):
    """A box at the top of the panel: one question at a time, and the reasons; hidden where nothing was proposed.

    answers : what the person has said so far, as `engine.again` takes it.  answer() : called after each change of them.
    A question for a part is answered by a click on it, as long as it is `armed`.
    """

    def __init__(self, shown: Shown, answer):
        super().__init__()
        self.answers, self._answer = {}, answer
        self.said: list[str] = []  # names of the questions that were answered here, in order
        self.later: list[str] = []  # names of those that were put off
        self.armed = self.stopped = False
        self.setObjectName("SensProposalBox")
        self.setStyleSheet("#SensProposalBox { background: #fff3c4; border: 1px solid #d9a400 }")
        page = QtGui.QVBoxLayout(self)
        page.setContentsMargins(5, 5, 5, 5)
        page.setSpacing(3)
        self.looking = self._looking()
        page.addWidget(self.looking)
        self.question = self._label(page, "SensQuestion")
        self.hint = self._label(page, "SensHint")
        self.hint.linkActivated.connect(self.arm)
        self.fields = QtGui.QWidget()
        self._fields = QtGui.QHBoxLayout(self.fields)
        self._fields.setContentsMargins(0, 0, 0, 0)
        page.addWidget(self.fields)
        self.buttons = QtGui.QGridLayout()
        page.addLayout(self.buttons)
        self.label = self._label(page, "SensProposal")
        self.lit = set()
        self.renew(shown)

    @staticmethod
    def _label(page, name: str):
        label = QtGui.QLabel()
        label.setObjectName(name)
        label.setWordWrap(True)
        label.setTextFormat(Qt.RichText)
        label.setStyleSheet("color: #2b2b2b")
        page.addWidget(label)
        return label

    def _looking(self):
        box = QtGui.QWidget()
        row = QtGui.QHBoxLayout(box)
        row.setContentsMargins(0, 0, 0, 0)
        self.bar = QtGui.QProgressBar()
        self.bar.setObjectName("SensLooking")
        self.bar.setRange(0, 1000)
        self.bar.setFormat(translate("Sens", "Looking at shapes: %p %"))
        stop = QtGui.QPushButton(translate("Sens", "Cancel"))
        stop.setObjectName("SensStopLooking")
        stop.setToolTip(translate("Sens", "Stops the look and keeps what is known by now"))
        stop.clicked.connect(self._stop)
        row.addWidget(self.bar, 1)
        row.addWidget(stop)
        box.hide()
        return box

    def _stop(self, *_) -> None:
        self.stopped = True

    def look(self, fraction: float | None) -> None:
        """How far the look at the shapes is; None: it is over."""
        self.looking.setVisible(fraction is not None)
        self.bar.setValue(int(1000 * (fraction or 0.0)))
        if fraction is None or not self.asked:
            self._write()

    def renew(self, shown: Shown) -> None:
        """Another proposal, after an answer."""
        self.proposal = shown
        self.given = shown.found is not None
        self.reasons = {subject: list(pieces) for subject, pieces in shown.reasons.items()}
        self.body = "F"
        self.waiting = list(shown.bodies)
        self.setVisible(self.given)
        self._ask()
        self._write()

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
        for layout in (self.buttons, self._fields):
            while layout.count():
                widget = layout.takeAt(0).widget()
                if widget is not None:
                    widget.setObjectName("")  # gone as soon as its own click is over
                    widget.hide()
                    widget.deleteLater()
        open_ = [q for q in self.proposal.found.questions if q.name not in self.answers] if self.given else []
        self.asked = next((q for q in open_ if q.name not in self.later), None)
        self.armed = self.asked is not None and self.asked.kind in ("part", "parts")
        self.question.setVisible(self.asked is not None)
        self.fields.setVisible(self.asked is not None and self.asked.kind == "travel")
        if self.asked is not None:
            self._offer(self.asked)
        if self.said:
            undo = self._button(translate("Sens", "Undo answer"), self.undo)
            undo.setObjectName("SensUndoAnswer")
        self._hint()

    def _offer(self, question) -> None:
        """The buttons of a question."""
        words = _safe(question.message.text(language()))
        self.question.setText(f"<b>{words}</b>")
        if question.name == "bed" and self.proposal.found.bodies.get("F"):
            part = max(self.proposal.found.bodies["F"], key=lambda u: u.bulk)
            self._button(Message("propose-choice-yes").text(language()), lambda: self._say("bed", part))
        elif question.kind == "travel":
            name = question.name.partition(":")[2]
            low, high = (length_box(-1e6, 1e6, 1) for _ in range(2))
            for box, value in zip((low, high), self.proposal.found.axes[name].travel):
                box.setValue(value)
                self._fields.addWidget(box, 1)
            self._fields.insertWidget(1, QtGui.QLabel("…"))
            words = Message("propose-panel-keep").text(language())
            keep = self._button(words, lambda: self._say(question.name, (low.value(), high.value())))

            def valid(*_):
                keep.setEnabled(low.value() < high.value())

            low.valueChanged.connect(valid)
            high.valueChanged.connect(valid)
        for value, message in question.choices:
            self._button(message.text(language()), lambda v=value: self._say(question.name, v))
        skip = self._button(translate("Sens", "Skip"), self.skip)
        skip.setObjectName("SensSkip")
        skip.setToolTip(translate("Sens", "Leaves the question open"))

    def _button(self, text: str, press):
        button = QtGui.QPushButton(text)
        button.setObjectName("SensAnswer")
        button.clicked.connect(lambda *_: press())
        count = self.buttons.count()
        columns = 3 if max(len(text), *(len(b.text()) for b in self._shown_buttons()), 0) < 16 else 2
        self.buttons.addWidget(button, count // columns, count % columns)
        return button

    def _shown_buttons(self) -> list:
        return [self.buttons.itemAt(i).widget() for i in range(self.buttons.count())]

    def _hint(self) -> None:
        part = self.asked is not None and self.asked.kind in ("part", "parts")
        self.hint.setVisible(part)
        if part and self.armed:
            self.hint.setText(translate("Sens", "Click it in the 3D view or the tree."))
        elif part:
            link = translate("Sens", "Answer by a click")
            self.hint.setText(f'<a href="arm">{link}</a>')

    def arm(self, *_) -> None:
        """The next click on a part answers the question."""
        self.armed = self.asked is not None
        self._hint()

    def disarm(self) -> None:
        """Clicks are meant for something else; the question stays."""
        self.armed = False
        self._hint()

    def skip(self) -> None:
        """Leave the question open, and go on to the next."""
        if self.asked is not None:
            self.later.append(self.asked.name)
            self._ask()

    def clicked(self, links) -> bool:
        """Parts were clicked in the view: whether that answers the question."""
        links = [link for link in links if link not in self.lit]
        if not self.armed or self.asked is None or not links:
            return False
        if not pins(self.proposal.found.document, {self.asked.name: links}, self.asked.name):
            return False  # no part of the machine
        self._say(self.asked.name, links)
        return True

    def _say(self, name: str, value) -> None:
        self.answers[name] = value
        self.said.append(name)
        self._answer()

    def undo(self) -> None:
        """Take the last answer back: its question is asked again."""
        if self.said:
            self.answers.pop(self.said.pop(), None)
            self._answer()

    @property
    def axis(self) -> str:
        """The axis that the question is about, or ""."""
        kind, _, name = self.asked.name.partition(":") if self.asked is not None else ("", "", "")
        return name if kind in ("travel", "direction") else ""

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
        looking = not self.looking.isHidden() and not found.axes
        head = Message(
            "propose-panel-looking" if looking else "propose-panel-check" if found.axes else "propose-panel-nothing"
        )
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


def _words(piece) -> str:
    return _safe(piece.text(language()) if isinstance(piece, Message) else str(piece))


def _safe(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;")
