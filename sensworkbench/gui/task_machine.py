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
from ..core.workspace import Cancelled
from ..document import factory, geometry, paths, refresh, tips, tree
from ..document.base import kind_of
from ..document.objects import DIRECTION_CHOICES, REFERENCE_CHOICES
from ..document.propose import building, engine
from . import messages, pointers, proposal, settings
from .command import Command, Where, command
from .current import current_machine
from .panel import Panel
from .panel import rows as form_rows
from .panel import show as show_panel
from .preferences import combo, number_box, read_field, write_field
from .proposal_note import ProposalNote, watch
from .qt import QT_TRANSLATE_NOOP, Qt, QtGui, translate
from .sources import Source, along_choices, reference_choices, source_words, vector_words
from .texts import body_kind, point_text

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
        self.machine, self.document = machine, machine.Document
        self.names = tree.joint_names(tree.bodies(machine)) or AXES
        self.bodies = ("F", *self.names, "T", "W")
        self.body = body or "F"
        self._quiet = False
        self.end_of = False  # an end was taken where a side was pointed at
        self.make_form("SensMachine", machine.Label, "SensWorkbench")
        layout = QtGui.QVBoxLayout(self.form)
        self.guess = ProposalNote(proposed or proposal.Shown(), self._answered)
        layout.addWidget(self.guess)
        self.note = QtGui.QLabel()  # at the top: what is missing is seen without scrolling
        self.note.setObjectName("SensNote")
        self.note.setWordWrap(True)
        layout.addWidget(self.note)
        layout.addWidget(self._chains())
        layout.addWidget(self._bodies())
        layout.addWidget(self._page())
        layout.addStretch(1)
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

    def _answered(self, name: str, value) -> None:
        """A question was answered: weigh the rest again, and build the machine anew from it."""
        doc, found = self.document, self.guess.proposal.found
        pointers.clear(self.machine)
        label = self.machine.Label
        building.unbuild(doc, found)
        found = engine.again(found, self.guess.answers)
        self.machine, shown = proposal.make(doc, found, label)
        settings.give(self.machine)
        self.names = tree.joint_names(tree.bodies(self.machine)) or AXES
        self.bodies = ("F", *self.names, "T", "W")
        self._quiet = True
        self.structure.clear()
        for code in self._structures():
            self.structure.addItem(code, code)
        self.table.clear()
        self._fill_bodies()
        self._quiet = False
        self.body = "F"
        self.guess.renew(shown)
        self.show()

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
        self.suggested = self.guess.directions_box(self._take_suggested)
        if self.suggested is not None:
            rows.addRow(translate("Sens", "Suggested"), self.suggested)
        self.reference = Source(self._take_reference, lambda: self._set_source("ReferenceSource", None))
        self.at = combo(list(zip(REFERENCE_CHOICES, reference_choices())))
        self.at.currentIndexChanged.connect(lambda *_: self._set_on_body("ReferenceAt", read_field(self.at)))
        rows.addRow(translate("Sens", "Reference from"), self.reference)
        rows.addRow("", self.at)
        self.lower, self.upper = (number_box(-1e6, 1e6, 3, 10, " mm") for _ in range(2))
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
        self._axis_only = [self.direction, self.along, self.reverse, self.lower, self.upper]
        self._axis_only += [self.suggested] if self.suggested is not None else []
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
        finally:
            self._quiet = False
        pointers.forget(machine)
        if self.body != "F":
            pointers.show(machine, [self.body], tool=True)
        else:  # a proposal begins with all of its axes in view
            pointers.show(machine, self.names if self.guess.given else [], tool=True)

    def _found_words(self, owner) -> str:
        if self.body == "F" or owner is None or self.machine.Problem:
            return ""
        lines = []
        if self.body in self.names:
            words = translate("Sens", "Direction: {vector} ({source})")
            source = messages.stored(owner.DirectionFrom)
            lines.append(words.format(vector=vector_words(owner.Direction, 4), source=source))
        words = translate("Sens", "Reference point: {vector} mm ({source})")
        source = messages.stored(owner.ReferenceFrom)
        lines.append(words.format(vector=vector_words(owner.ReferencePoint, 2), source=source))
        offset = " ".join(f"{k.lower()} {getattr(owner, f'AbbeOffset{k}').Value:.2f}" for k in "XYZ")
        lines.append(translate("Sens", "Abbe offset here: {offset} mm").format(offset=offset))
        return "\n".join(lines)

    def _skew_words(self) -> str:
        machine = self.machine
        skew = {pair: float(angle) for pair, angle in machine.Skew.items()}
        off = [f"{pair} {angle:+.3f}°" for pair, angle in skew.items() if abs(angle) > 1e-6]
        return translate("Sens", "Not square as designed: {pairs}").format(pairs=", ".join(off)) if off else ""

    # -- changing ----------------------------------------------------------------------------------------------------
    def _body_chosen(self, item, *_):
        if not self._quiet and item is not None:
            self.body = item.data(0, Qt.UserRole)
            self.guess.look_at(self.body)
            self.show()
            self.guess.light_up(self.machine, self.body)

    def _try(self, function) -> None:
        """Change something; a refusal is shown and everything else stays."""
        if self._quiet:
            return
        try:
            function()
        except Refused as error:
            self.show()
            self.note.setText(messages.words(error))
            self.note.setVisible(True)
            return
        self.show()

    def _set(self, name, value):
        if not self._quiet and getattr(self.machine, name) != value:
            self._try(lambda: setattr(self.machine, name, value))

    def _set_on_body(self, name, value):
        owner = self.owner
        if not self._quiet and owner is not None and hasattr(owner, name):
            self.guess.drop(self.body, name)
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
            workpiece, tool = structure_chains(read_field(self.structure))
            self.guess.drop("structure")
            self.machine.WorkpieceChain, self.machine.ToolChain = list(workpiece), list(tool)

        self._try(change)

    def take_parts(self, *_, keep: bool = False) -> None:
        """The selected parts become the chosen component, or are added to it."""
        chosen = [link for link in proposal.selected_links() if not kind_of(link[0])]
        if not chosen:
            self.note.setText(translate("Sens", "Select one or more parts in the view or the tree first."))
            self.note.setVisible(True)
            return
        self.set_parts(([*self.links(self.body)] if keep else []) + chosen)

    def set_parts(self, links) -> None:
        """Make these links the parts of the chosen body."""

        def change():
            value = paths.as_links(links)
            self._take_from_others(paths.places(value))
            self.guess.drop(self.body, "Parts")
            self.guess.told(f"body:{self.body}", links)
            if self.body == "F":
                self.machine.Bed = value
                return
            owner = self.owner or factory.make_body(self.machine, self.body)
            self._forget_direction(owner)
            owner.Parts = value

        self._try(change)

    def _take_from_others(self, chosen) -> None:
        """A part that is given to one component leaves the others."""
        keys = {where.key for where in chosen}
        for body in self.bodies:
            owner = self.machine if body == "F" else tree.body_of(self.machine, body)
            if body == self.body or owner is None:
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
        def change():
            found = tips.tip(self._one(), *self._tool())
            self.machine.ToolPoint = found.link
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
            words = translate("Sens", "The tool reaches {length} mm past this point.")
            lines.append(words.format(length=f"{found.beyond:.1f}"))
        return "\n".join(lines)

    def _take_direction(self):
        self._try(lambda: self._put_source("DirectionSource", self._one()))

    def _take_reference(self):
        self._try(lambda: self._put_source("ReferenceSource", self._one()))

    def _set_source(self, name, value):
        self._try(lambda: self._put_source(name, value))

    def _put_source(self, name, value):
        owner = self.owner
        if owner is None and self.body in ("T", "W"):
            owner = factory.make_body(self.machine, self.body)
        if owner is not None and hasattr(owner, name):
            setattr(owner, name, value)
            self.guess.drop(self.body, name)
            self.document.recompute()
            self._told(name)

    def _take_suggested(self, axis) -> None:
        """One of the directions that the geometry suggests becomes that of the chosen axis."""

        def change():
            self.owner.DirectionSource, self.owner.DirectionAlong = paths.as_sub(axis.source), DIRECTION_CHOICES[0]
            self.owner.Reverse = axis.reverse
            self.guess.drop(self.body, "DirectionSource", axis.why)

        if self.body in self.names:
            self._try(change)

    # -- the panel ---------------------------------------------------------------------------------------------------
    def accept(self):
        self.document.recompute()
        problem = refresh.problem_text(self.machine, messages.language())
        if problem:
            messages.show(problem + "\n\n" + translate("Sens", "Correct it, or press Cancel."))
            return False
        self.close()
        self.document.commitTransaction()
        return True

    def leave(self):
        self.guess.release()
        pointers.clear(self.machine)

    def reject(self):
        self.close()
        self.document.abortTransaction()
        self.document.recompute()
        return True


def new_machine(doc):
    """Propose a machine for the selection (or the document) in a transaction and open the panel; None if stopped.

    Refuses a document without parts.
    """
    if not proposal.selected_links() and not proposal.candidates(doc):
        raise Refused("gui-no-parts", doc.Label)
    doc.openTransaction(translate("Sens", "Machine from selection"))
    try:
        with watch() as progress:
            found = engine.propose(doc, proposal.selected_links(), progress=progress)
        machine, shown = proposal.make(doc, found, translate("Sens", "Machine"))
        settings.give(machine)
        panel = TaskMachine(machine, proposed=shown)
    except Cancelled:
        doc.abortTransaction()
        messages.status(translate("Sens", "Cancelled; nothing was changed"))
        return None
    except Refused:
        doc.abortTransaction()
        raise
    show_panel(panel, doc)
    return panel


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
