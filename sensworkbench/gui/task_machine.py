# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine panel: which part is the bed, which carries X, Y, Z, spindle and workpiece; chains, directions, points.

It works on the objects themselves inside one transaction, so that directions, reference points and Abbe offsets show at
once in the panel and as arrows; OK keeps them as one undo step, Cancel leaves the document as it was.
"""

from __future__ import annotations

import itertools

import FreeCAD as App
import FreeCADGui as Gui

from ..core.errors import AXES
from ..core.machine import structure_chains
from ..core.refusal import Refused
from ..document import factory, geometry, paths, refresh, tips, tree
from ..document.base import kind_of
from ..document.objects import DIRECTION_CHOICES, REFERENCE_CHOICES
from ..document.propose import building, engine
from . import messages, pointers, proposal, settings, state
from .command import Command, Where, command
from .current import current_machine
from .looking import Look
from .panel import Panel
from .panel import rows as form_rows
from .panel import show as show_panel
from .picking import Picks
from .preferences import combo, length_box, read_field, write_field
from .proposal_note import ProposalNote
from .qt import QT_TRANSLATE_NOOP, Qt, QtGui, translate
from .sources import Source, along_choices, reference_choices, source_words, vector_words
from .texts import body_kind, length, point_text
from .trial import Trial

MOST_LISTED = 4  # axes: of more the structures are too many for a list


def structure_of(machine) -> str:
    """Return the structure code of a machine object, such as XYFZ."""
    return "".join(reversed(machine.WorkpieceChain)) + "F" + "".join(machine.ToolChain)


def structure_words(code: str) -> str:
    """bed → Y → X → workpiece   |   bed → Z → tool."""
    workpiece, tool = structure_chains(code)
    bed, arrow = translate("Sens", "bed"), " → "
    left = arrow.join([bed, *workpiece, translate("Sens", "workpiece")])
    return left + "\n" + arrow.join([bed, *tool, translate("Sens", "tool")])


def words_of(links) -> str:
    """Labels of linked parts."""
    try:
        return ", ".join(w.label for w in paths.places(links))
    except Refused as error:
        return messages.words(error)


class TaskMachine(Panel):
    """The panel; its transaction is open when it is made.  proposed : what was guessed, to be checked, or None."""

    guide = "1. A machine"
    holds_transaction = True

    def __init__(self, machine, body: str | None = None, proposed: proposal.Shown | None = None):
        self.machine, self.document, self._name = machine, machine.Document, machine.Document.Name
        self.names = tree.joint_names(tree.bodies(machine)) or AXES
        self.bodies = ("F", *self.names, "T", "W")
        self.body = body or "F"
        self._quiet = False
        self.over = False  # the panel was closed
        self.mine: dict[tuple, object] = {}  # (body, property) -> what the person has chosen in the panel
        self.awaited = None  # what the next click in the view is for: a function, or None
        self.end_of = False  # an end was taken where a side was pointed at
        self.make_form("SensMachine", machine.Label, "SensWorkbench")
        layout = QtGui.QVBoxLayout(self.form)
        self.guess = ProposalNote(proposed or proposal.Shown(), self._answered)
        layout.addWidget(self.guess)
        self.note = QtGui.QLabel()  # at the top: what is missing is seen without scrolling
        self.note.setObjectName("SensNote")
        self.note.setWordWrap(True)
        layout.addWidget(self.note)
        self.trial = Trial(lambda: self.machine, lambda: self.body if self.body in self.names else "", self._say)
        layout.addWidget(self.trial)
        layout.addWidget(self._chains())
        layout.addWidget(self._bodies())
        layout.addWidget(self._page())
        layout.addStretch(1)
        self.picks = Picks(self.document, self._clicked)
        self.show()

    def _structures(self) -> list[str]:
        """Structure codes to choose from: every order of the bed and the axes, or that of the machine alone."""
        if len(self.names) > MOST_LISTED:
            return [structure_of(self.machine)]
        return ["".join(p) for p in itertools.permutations(("F", *self.names))]

    # -- parts of the panel ------------------------------------------------------------------------------------------
    def _chains(self):
        group = QtGui.QGroupBox(translate("Sens", "Structure (workpiece → tool, F: bed)"))
        rows = form_rows(group)
        self.structure = combo([(code, code) for code in self._structures()])
        self.structure.setToolTip(translate("Sens", "XYFZ: table X on saddle Y; the spindle moves along Z"))
        self.structure.currentIndexChanged.connect(self._structure_changed)
        self.chain_words = QtGui.QLabel()
        self.squareness = combo([
            ("direction", translate("Sens", "tilts the motion (ISO 230-1)")),
            ("carried", translate("Sens", "also turns what the guide carries")),
        ])  # fmt: skip
        self.squareness.currentIndexChanged.connect(lambda *_: self._set("Squareness", read_field(self.squareness)))
        self.tool_point = Source(self._take_tool_point, None)
        rows.addRow(translate("Sens", "Structure"), self.structure)
        rows.addRow("", self.chain_words)
        self.tool_words = QtGui.QLabel()
        self.tool_words.setObjectName("SensToolPoint")
        self.tool_words.setWordWrap(True)
        self.tool_words.setTextInteractionFlags(Qt.TextSelectableByMouse)
        rows.addRow(translate("Sens", "Tool point"), self.tool_point)
        rows.addRow("", self.tool_words)
        rows.addRow(translate("Sens", "Squareness"), self.squareness)
        return group

    # -- the proposal ------------------------------------------------------------------------------------------------
    def _answered(self) -> None:
        """Answers have changed: weigh the rest again, and build the machine anew from it."""
        found = self.guess.proposal.found
        if found.state is not None:
            self._rebuild(engine.again(found, self.guess.answers))

    def looked(self, found, *, last: bool = True) -> None:
        """More is known of the document: fill it in, what the person has said stays.  None: the look was stopped."""
        if last:
            self.guess.look(None)
        if found is not None:
            self._rebuild(engine.again(found, self.guess.answers) if last and self.guess.answers else found)

    def _rebuild(self, found) -> None:
        """The machine of another proposal in place of this one, with all that the person has chosen."""
        doc, body = self.document, self.body
        self.trial.back()
        pointers.clear(self.machine)
        label = self.machine.Label
        with state.quietly(doc):
            building.unbuild(doc, self.guess.proposal.found)
            self.machine, shown = proposal.make(doc, found, label)
            settings.give(self.machine)
            self._put_back()
        self.names = tree.joint_names(tree.bodies(self.machine)) or AXES
        self.bodies = ("F", *self.names, "T", "W")
        self._quiet = True
        self.structure.clear()
        for code in self._structures():
            self.structure.addItem(code, code)
        self.table.clear()
        self._fill_bodies()
        self._quiet = False
        self.body = body if body in self.bodies else "F"
        self.guess.renew(shown)
        self._suggest()
        for chosen, name in self.mine:
            subject = {"ToolPoint": "tool point", "Structure": "structure"}.get(name, chosen)
            self.guess.drop(subject, name)
        self.show()

    def _put_back(self) -> None:
        """What the person has chosen in the panel, on a machine that was made anew."""
        for (body, name), value in self.mine.items():
            owner = self.machine if body == "F" else tree.body_of(self.machine, body)
            if owner is None and body in ("T", "W"):
                owner = factory.make_body(self.machine, body)
            try:
                if name == "Structure":
                    self._chain(value)
                elif name == "Parts":
                    self._take_from_others(body, paths.places(value))
                    setattr(owner, "Bed" if body == "F" else "Parts", value)
                elif owner is not None:
                    setattr(owner, name, value)
            except Refused as error:
                messages.status(messages.words(error))

    def _chain(self, code: str) -> None:
        """Another order of bed and axes, where the machine has these axes."""
        workpiece, tool = structure_chains(code)
        if sorted((*workpiece, *tool)) == sorted((*self.machine.WorkpieceChain, *self.machine.ToolChain)):
            self.machine.WorkpieceChain, self.machine.ToolChain = list(workpiece), list(tool)

    def _clicked(self, links) -> None:
        """Parts were clicked in the view: they answer what was waited for, or the question."""
        awaited, self.awaited = self.awaited, None
        links = [link for link in links if not kind_of(link[0])]
        if awaited is not None and links:
            awaited()
        elif self.guess.clicked(links):
            with state.quietly(self.document):
                Gui.Selection.clearSelection()

    def _await(self, function) -> bool:
        """Whether nothing is selected, so that the next click in the view is for this."""
        if [link for link in proposal.selected_links() if not kind_of(link[0]) and link not in self.guess.lit]:
            return False
        self.awaited = function
        self.guess.disarm()
        self.note.setText(translate("Sens", "Click it in the 3D view or the tree."))
        self.note.setStyleSheet("")
        self.note.setVisible(True)
        return True

    def _suggest(self) -> None:
        """Fill the choice of the directions that the geometry suggests."""
        found = self.guess.proposal.directions
        texts = [f"{vector_words(a.direction, 3)}  {a.why.text(proposal.language())}" for a in found]
        self.suggested.clear()
        self.suggested.addItem(translate("Sens", "Choose …"), -1)
        for row, text in enumerate(texts):
            self.suggested.addItem(text, row)
        for widget in (self.suggested, self.suggested_label):
            widget.setVisible(bool(found))

    def _fill_bodies(self) -> None:
        for body in self.bodies:
            item = QtGui.QTreeWidgetItem(self.table, [body_kind(body), ""])
            item.setData(0, Qt.UserRole, body)

    def _bodies(self):
        self.table = QtGui.QTreeWidget()
        self.table.setObjectName("SensBodies")
        self.table.setRootIsDecorated(False)
        self.table.setUniformRowHeights(True)
        self.table.setHeaderLabels([translate("Sens", "Component"), translate("Sens", "Parts")])
        self._fill_bodies()
        rows = len(self.bodies) * max(18, self.table.sizeHintForRow(0))
        self.table.setFixedHeight(rows + self.table.header().sizeHint().height() + 2 * self.table.frameWidth() + 4)
        self.table.resizeColumnToContents(0)
        self.table.currentItemChanged.connect(self._body_chosen)
        return self.table

    def _page(self):
        self.page = QtGui.QGroupBox()
        rows = form_rows(self.page)
        self.take = QtGui.QToolButton()
        self.take.setText(translate("Sens", "Take selection"))
        self.take.setToolTip(translate("Sens", "The parts selected in the view or the tree become this component"))
        self.take.clicked.connect(self.take_parts)
        self.add = QtGui.QToolButton()
        self.add.setText(translate("Sens", "Add"))
        self.add.setToolTip(translate("Sens", "Adds the selected parts"))
        self.add.clicked.connect(lambda *_: self.take_parts(keep=True))
        self.clear = QtGui.QToolButton()
        self.clear.setText(translate("Sens", "Clear"))
        self.clear.clicked.connect(lambda *_: self.set_parts([]))
        row = QtGui.QHBoxLayout()
        for button in (self.take, self.add, self.clear):
            button.setSizePolicy(QtGui.QSizePolicy.Minimum, QtGui.QSizePolicy.Fixed)
            row.addWidget(button)
        row.addStretch(1)
        rows.addRow(translate("Sens", "Parts"), row)
        self.direction = Source(self._take_direction, lambda: self._set_source("DirectionSource", None))
        self.along = combo(list(zip(DIRECTION_CHOICES, along_choices())))
        self.along.currentIndexChanged.connect(lambda *_: self._set_on_body("DirectionAlong", read_field(self.along)))
        self.reverse = QtGui.QCheckBox(translate("Sens", "Reversed"))
        self.reverse.toggled.connect(lambda v: self._set_on_body("Reverse", bool(v)))
        line = QtGui.QHBoxLayout()
        line.addWidget(self.along, 1)
        line.addWidget(self.reverse)
        rows.addRow(translate("Sens", "Direction from"), self.direction)
        rows.addRow("", line)
        self.suggested = combo([(-1, translate("Sens", "Choose …"))])
        self.suggested.setMinimumContentsLength(16)
        self.suggested.setToolTip(translate("Sens", "Directions of rails, screws and long edges, the longest first"))
        self.suggested.activated.connect(self._suggestion_chosen)
        self.suggested_label = QtGui.QLabel(translate("Sens", "Suggested"))
        rows.addRow(self.suggested_label, self.suggested)
        self._suggest()
        self.reference = Source(self._take_reference, lambda: self._set_source("ReferenceSource", None))
        self.at = combo(list(zip(REFERENCE_CHOICES, reference_choices())))
        self.at.currentIndexChanged.connect(lambda *_: self._set_on_body("ReferenceAt", read_field(self.at)))
        rows.addRow(translate("Sens", "Reference from"), self.reference)
        rows.addRow("", self.at)
        self.lower, self.upper = (length_box(-1e6, 1e6) for _ in range(2))
        for box in (self.lower, self.upper):
            box.setMinimumWidth(60)
        for box, name in ((self.lower, "TravelLower"), (self.upper, "TravelUpper")):
            box.setKeyboardTracking(False)
            box.valueChanged.connect(lambda v, n=name: self._set_on_body(n, float(v)))
        line = QtGui.QHBoxLayout()
        line.addWidget(self.lower, 1)
        line.addWidget(QtGui.QLabel("…"))
        line.addWidget(self.upper, 1)
        rows.addRow(translate("Sens", "Travel"), line)
        self.found = QtGui.QLabel()
        self.found.setWordWrap(True)
        self.found.setTextInteractionFlags(Qt.TextSelectableByMouse)
        rows.addRow(self.found)
        self._axis_only = [self.direction, self.along, self.reverse, self.suggested, self.lower, self.upper]
        self._body_only = [self.reference, self.at]
        return self.page

    # -- showing -----------------------------------------------------------------------------------------------------
    @property
    def owner(self):
        """The object of the chosen component (the machine for the bed), or None where it is not made yet."""
        return self.machine if self.body == "F" else tree.body_of(self.machine, self.body)

    def links(self, body: str):
        """Return the links to the parts of a body."""
        owner = self.machine if body == "F" else tree.body_of(self.machine, body)
        return [] if owner is None else owner.Bed if body == "F" else owner.Parts

    def show(self) -> None:
        """Recompute the machine and show everything as it is now."""
        self.document.recompute()
        refresh.refresh(self.machine)
        machine, owner = self.machine, self.owner
        self._quiet = True
        try:
            code = structure_of(machine)
            self.structure.setCurrentIndex(self.structure.findData(code))
            self.chain_words.setText(structure_words(code) if self.structure.currentIndex() >= 0 else "")
            write_field(self.squareness, machine.Squareness)
            self.tool_point.show(source_words(machine.ToolPoint), bool(machine.ToolPoint))
            self.tool_words.setText(self._tool_words())
            for i in range(self.table.topLevelItemCount()):
                item = self.table.topLevelItem(i)
                body = item.data(0, Qt.UserRole)
                item.setText(1, words_of(self.links(body)) or translate("Sens", "(none)"))
                item.setToolTip(1, item.text(1))
                item.setIcon(0, self.guess.icon(body))
                if body == self.body:
                    self.table.setCurrentItem(item)
            self.page.setTitle(body_kind(self.body))
            axis = self.body in self.names
            for field in self._axis_only:
                field.setEnabled(axis)
            for field in self._body_only:
                field.setEnabled(self.body != "F")
            if axis:
                self.direction.show(
                    source_words(owner.DirectionSource, translate("Sens", "the first part")),
                    bool(owner.DirectionSource),
                )
                write_field(self.along, owner.DirectionAlong)
                self.reverse.setChecked(owner.Reverse)
                self.lower.setValue(owner.TravelLower.Value)
                self.upper.setValue(owner.TravelUpper.Value)
            else:
                self.direction.show("", False)
            if self.body != "F" and owner is not None:
                self.reference.show(
                    source_words(owner.ReferenceSource, translate("Sens", "the parts")), bool(owner.ReferenceSource)
                )
                write_field(self.at, owner.ReferenceAt)
            else:
                self.reference.show("", False)
            self.found.setText(self._found_words(owner))
            self.note.setText(refresh.problem_text(machine, messages.language()) or self._skew_words())
            self.note.setStyleSheet("color: #c0392b" if machine.Problem else "")
            self.note.setVisible(bool(self.note.text()))
            self.trial.show_axis()
        finally:
            self._quiet = False
        pointers.forget(machine)
        if self.body != "F":
            pointers.show(machine, [self.body], tool=True)
        else:  # a proposal begins with all of its axes in view, or the one that is asked about
            axes = [self.guess.axis] if self.guess.axis in self.names else self.names if self.guess.given else []
            pointers.show(machine, axes, tool=True, offsets=False)

    def _say(self, text: str) -> None:
        """A sentence in the line for what is missing."""
        self.note.setText(text)
        self.note.setVisible(True)

    def _found_words(self, owner) -> str:
        if self.body == "F" or owner is None or self.machine.Problem:
            return ""
        lines = []
        if self.body in self.names:
            words = translate("Sens", "Direction: {vector} ({source})")
            source = messages.stored(owner.DirectionFrom)
            lines.append(words.format(vector=vector_words(owner.Direction, 4), source=source))
        words = translate("Sens", "Reference point: {vector} ({source})")
        source = messages.stored(owner.ReferenceFrom)
        lines.append(words.format(vector=point_text(owner.ReferencePoint, 2), source=source))
        offset = point_text([getattr(owner, f"AbbeOffset{k}").Value for k in "XYZ"], 2)
        lines.append(translate("Sens", "Abbe offset here: {offset}").format(offset=offset))
        return "\n".join(lines)

    def _skew_words(self) -> str:
        machine = self.machine
        skew = {pair: float(angle) for pair, angle in machine.Skew.items()}
        off = [f"{pair} {angle:+.3f}°" for pair, angle in skew.items() if abs(angle) > 5e-4]
        return translate("Sens", "Not square as designed: {pairs}").format(pairs=", ".join(off)) if off else ""

    # -- changing ----------------------------------------------------------------------------------------------------
    def _body_chosen(self, item, *_):
        if not self._quiet and item is not None:
            self.trial.back()
            self.body = item.data(0, Qt.UserRole)
            self.awaited = None
            self.guess.disarm()
            self.guess.look_at(self.body)
            self.show()
            with state.quietly(self.document):
                self.guess.light_up(self.machine, self.body)

    def _try(self, function) -> None:
        """Change something; a refusal is shown and everything else stays."""
        if self._quiet:
            return
        self.trial.back()
        try:
            function()
        except Refused as error:
            self.show()
            self._say(messages.words(error))
            return
        self.show()

    def _set(self, name, value):
        if not self._quiet and getattr(self.machine, name) != value:
            self.mine["F", name] = value
            self._try(lambda: setattr(self.machine, name, value))

    def _set_on_body(self, name, value):
        owner = self.owner
        if not self._quiet and owner is not None and hasattr(owner, name):
            self.guess.drop(self.body, name)
            self.mine[self.body, name] = value
            self._try(lambda: setattr(owner, name, value))
            self._told(name)

    def _told(self, name: str) -> None:
        """What a person sets here counts as an answer in what is weighed later."""
        owner = self.owner
        if self.body not in AXES or owner is None:
            return
        if name in ("TravelLower", "TravelUpper"):
            self.guess.told(f"travel:{self.body}", (owner.TravelLower.Value, owner.TravelUpper.Value))
        elif name in ("DirectionSource", "DirectionAlong", "Reverse") and not self.machine.Problem:
            self.guess.told(f"direction:{self.body}", tuple(owner.Direction))

    def _structure_changed(self, *_):
        def change():
            self.guess.drop("structure")
            self.mine["F", "Structure"] = read_field(self.structure)
            self._chain(self.mine["F", "Structure"])

        self._try(change)

    def take_parts(self, *_, keep: bool = False) -> None:
        """The selected parts become the chosen component, or are added to it."""
        chosen = [link for link in proposal.selected_links() if not kind_of(link[0])]
        if not chosen:
            self._await(lambda: self.take_parts(keep=keep))
            return
        self.set_parts(([*self.links(self.body)] if keep else []) + chosen)

    def set_parts(self, links) -> None:
        """Make these links the parts of the chosen body."""

        def change():
            value = paths.as_links(links)
            self._take_from_others(self.body, paths.places(value))
            self.mine[self.body, "Parts"] = value
            self.guess.drop(self.body, "Parts")
            self.guess.told(f"body:{self.body}", links)
            if self.body == "F":
                self.machine.Bed = value
                return
            owner = self.owner or factory.make_body(self.machine, self.body)
            self._forget_direction(owner)
            owner.Parts = value

        self._try(change)

    def _take_from_others(self, receiver: str, chosen) -> None:
        """A part that is given to one component leaves the others."""
        keys = {where.key for where in chosen}
        for body in ("F", *tree.joint_names(tree.bodies(self.machine)), "T", "W"):
            owner = self.machine if body == "F" else tree.body_of(self.machine, body)
            if body == receiver or owner is None:
                continue
            before = paths.places(self.links(body))
            kept = [w for w in before if not any(w.key[:n] in keys for n in range(1, len(w.key) + 1))]
            if len(kept) < len(before):
                setattr(owner, "Bed" if body == "F" else "Parts", paths.as_links(kept))

    def _forget_direction(self, owner) -> None:
        """A direction that was proposed on the parts of before goes with them."""
        source = paths.place(owner.DirectionSource) if getattr(owner, "DirectionSource", None) else None
        if source is None or f"direction:{self.body}" in self.guess.answers or not self.guess.given:
            return
        if any(source.key[: len(part.key)] == part.key for part in paths.places(owner.Parts)):
            owner.DirectionSource = None
            self.guess.drop(self.body, "DirectionSource")

    def _one(self):
        chosen = [link for link in proposal.selected_links() if not kind_of(link[0])]
        if len(chosen) != 1:
            raise Refused("gui-select-one-geometry")
        return paths.as_sub(chosen[0])

    def _take_tool_point(self):
        if self._await(self._take_tool_point):
            return

        def change():
            found = tips.tip(self._one(), *self._tool())
            self.machine.ToolPoint = self.mine["F", "ToolPoint"] = found.link
            self.end_of = found.moved
            self.guess.drop("tool point")

        self._try(change)

    def _tool(self):
        """(a point of what carries the tool or None, the parts of the tool)."""
        carrier = next((links for b in (*reversed(list(self.machine.ToolChain)), "F") if (links := self.links(b))), [])
        return geometry.centre_of_mass(paths.places(carrier)), paths.places(self.links("T"))

    def _tool_words(self) -> str:
        """Where the tool point is, that it is the end of what was pointed at, and what reaches past it."""
        if not self.machine.ToolPoint:
            return ""
        try:
            found = tips.tip(self.machine.ToolPoint, *self._tool())
            where, _ = geometry.point(paths.place(self.machine.ToolPoint), "Automatic")
        except Refused as error:
            return messages.words(error)
        lines = [point_text(where, 2)]
        if self.end_of:
            lines.append(translate("Sens", "The middle of the far end was taken for the side."))
        if found.moved:  # of a file from before the end was taken
            lines.append(translate("Sens", "This is the middle of a side, not its end: take it again."))
        elif found.beyond > 0.5:
            words = translate("Sens", "The tool reaches {length} past this point.")
            lines.append(words.format(length=length(found.beyond)))
        return "\n".join(lines)

    def _take_direction(self):
        if not self._await(self._take_direction):
            self._try(lambda: self._put_source("DirectionSource", self._one()))

    def _take_reference(self):
        if not self._await(self._take_reference):
            self._try(lambda: self._put_source("ReferenceSource", self._one()))

    def _set_source(self, name, value):
        self._try(lambda: self._put_source(name, value))

    def _put_source(self, name, value):
        owner = self.owner
        if owner is None and self.body in ("T", "W"):
            owner = factory.make_body(self.machine, self.body)
        if owner is not None and hasattr(owner, name):
            setattr(owner, name, value)
            self.mine[self.body, name] = value
            self.guess.drop(self.body, name)
            self.document.recompute()
            self._told(name)

    def _suggestion_chosen(self, row: int) -> None:
        if row > 0:
            self._take_suggested(self.guess.proposal.directions[row - 1])
            self.suggested.setCurrentIndex(0)

    def _take_suggested(self, axis) -> None:
        """One of the directions that the geometry suggests becomes that of the chosen axis."""

        def change():
            chosen = {"DirectionSource": paths.as_sub(axis.source), "DirectionAlong": DIRECTION_CHOICES[0],
                      "Reverse": axis.reverse}  # fmt: skip
            for name, value in chosen.items():
                setattr(self.owner, name, value)
                self.mine[self.body, name] = value
            self.guess.drop(self.body, "DirectionSource", axis.why)

        if self.body in self.names:
            self._try(change)

    # -- the panel ---------------------------------------------------------------------------------------------------
    def accept(self):
        self.trial.back()
        self.document.recompute()
        problem = refresh.problem_text(self.machine, messages.language())
        if problem:
            messages.show(problem + "\n\n" + translate("Sens", "Correct it, or press Cancel."))
            return False
        self.close()
        self.document.commitTransaction()
        return True

    def leave(self):
        self.over = True
        self.trial.stop()
        self.picks.stop()
        with state.quietly(self._name):
            self.guess.release()
        pointers.clear(self.machine)

    def reject(self):
        self.close()
        self.document.abortTransaction()
        self.document.recompute()
        return True


def new_machine(doc):
    """Propose a machine for the selection (or the document) in a transaction and open the panel; None if it was closed.

    What takes more than a second to look at is looked at behind the open panel.  Refuses a document without parts.
    """
    selected = proposal.selected_links()
    if not selected and not proposal.candidates(doc):
        raise Refused("gui-no-parts", doc.Label)
    doc.openTransaction(translate("Sens", "Machine from selection"))

    def open_panel(found):
        machine, shown = proposal.make(doc, found, translate("Sens", "Machine"))
        settings.give(machine)
        panel = TaskMachine(machine, proposed=shown)
        show_panel(panel, doc)
        return panel

    look = Look(open_panel)
    try:
        return look.run(doc, selected)
    except BaseException:
        if look.panel is None:
            doc.abortTransaction()
        raise


def edit_machine(machine, body: str | None = None):
    """Open the panel for a machine, on one of its components."""
    machine.Document.openTransaction(translate("Sens", "Edit machine"))
    panel = TaskMachine(machine, body)
    show_panel(panel, machine.Document)
    return panel


@command
class NewMachine(Command):
    name = "Sens_Machine"
    menu_text = QT_TRANSLATE_NOOP("Sens_Machine", "Machine from Selection…")
    tip = QT_TRANSLATE_NOOP(
        "Sens_Machine", "Makes a machine from parts: which is the bed, and which carries X, Y, Z, spindle and table"
    )
    needs, guide = "document", TaskMachine.guide
    where = Where("machine", 10)

    def run(self):
        new_machine(App.ActiveDocument)


@command
class EditMachine(Command):
    name = "Sens_EditMachine"
    keys = "Y, E"
    menu_text = QT_TRANSLATE_NOOP("Sens_EditMachine", "Edit Machine…")
    tip = QT_TRANSLATE_NOOP("Sens_EditMachine", "Changes chains, carriages, directions, reference points and travel")
    guide = TaskMachine.guide
    where = Where("machine", 40, tree=("Machine", "Axis", "Body"), double=("Machine", "Axis", "Body"))

    def run(self):
        chosen = [o for o in Gui.Selection.getSelection() if kind_of(o) in ("Axis", "Body")]
        body = getattr(chosen[0], "Axis", None) or getattr(chosen[0], "Body", None) if chosen else None
        edit_machine(current_machine(), body)
