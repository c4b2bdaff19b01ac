# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that turns an assembly with sliders into a machine: which side carries the tool, and where its tip is.

It only reads the joints; the machine is made with OK, as one undo step.
"""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui

from ..core.refusal import Refused
from ..document import assembly as reader
from ..document import extract, geometry, joints, paths, tips
from . import messages, settings
from .command import Command, Where, command
from .panel import Panel
from .panel import rows as form_rows
from .panel import show as show_panel
from .preferences import combo
from .qt import QT_TRANSLATE_NOOP, QtGui, translate
from .sources import vector_words
from .texts import length, point_text


def found(doc) -> list:
    """Assemblies of a document; cheap where there is none, for it is asked whenever a menu is updated."""
    if doc is None or not any(o.TypeId in ("Assembly::AssemblyObject", "App::Link") for o in doc.Objects):
        return []
    return reader.assemblies(doc)


class TaskAssembly(Panel):
    """The panel; `reading` is the model of the assembly made from its joints."""

    guide = "1. A machine"

    def __init__(self, doc, chosen=None):
        self.doc, self.assemblies = doc, found(doc)
        if not self.assemblies:
            raise Refused("gui-no-assembly", doc.Label)
        self.tool_point, self.tip = None, None
        self.reading = None
        self.make_form("SensAssembly", translate("Sens", "Machine from assembly"), "Sens_MachineFromAssembly")
        page = QtGui.QVBoxLayout(self.form)
        rows = form_rows()
        self.which = combo([(o.Name, o.Label) for o in self.assemblies])
        self.side = QtGui.QComboBox()
        self.side.setToolTip(translate("Sens", "The sliders between bed and tool; the others carry the workpiece"))
        self.point = QtGui.QLabel()
        self.point.setWordWrap(True)
        self.take = QtGui.QPushButton(translate("Sens", "Take"))
        self.take.setToolTip(translate("Sens", "Select a coordinate system, vertex, edge or face at the tool's tip"))
        self.take.clicked.connect(self.take_point)
        line = QtGui.QHBoxLayout()
        line.addWidget(self.point, 1)
        line.addWidget(self.take)
        rows.addRow(translate("Sens", "Assembly"), self.which)
        rows.addRow(translate("Sens", "The tool is carried by"), self.side)
        rows.addRow(translate("Sens", "Tool point"), line)
        page.addLayout(rows)
        self.note = QtGui.QLabel()
        self.note.setObjectName("SensNote")
        self.note.setWordWrap(True)
        page.addWidget(self.note)
        page.addStretch(1)
        if chosen is not None:
            self.which.setCurrentIndex(max(0, self.which.findData(chosen.Name)))
        self.which.currentIndexChanged.connect(self.read)
        self.side.currentIndexChanged.connect(self.show)
        self.read()

    def read(self, *_) -> None:
        """Read the chosen assembly; a refusal is shown in the note and disables OK."""
        self.side.blockSignals(True)
        self.side.clear()
        self.reading = None
        try:
            reading = reader.read(self.doc.getObject(self.which.itemData(self.which.currentIndex())))
            reader.name_axes(reading)
            work, tool = reader.sides(reading)
            self.reading, self.branches = reading, (tool, work)
            for branch in self.branches:
                words = ", ".join(s.joint.object.Label for s in branch)
                self.side.addItem(words or translate("Sens", "the bed (no slider)"))
        except Refused as error:
            self.note.setText(messages.words(error))
        self.side.blockSignals(False)
        if self.reading is not None:
            self.show()

    def show(self, *_) -> None:
        """The structure that follows from the choice, the axes, and what was left out."""
        if self.reading is None:
            return
        tool, work = self._chosen()
        code = "".join(s.axis for s in reversed(work)) + "F" + "".join(s.axis for s in tool)
        lines = [translate("Sens", "Structure: {code}").format(code=code)]
        for slider in sorted(self.reading.sliders, key=lambda s: s.axis):
            u = joints.direction(slider.joint)
            lines.append(f"{slider.axis}: {slider.joint.object.Label} {vector_words(u, 3)}")
        if self.reading.left_out:
            names = ", ".join(p.label for p in self.reading.left_out)
            lines.append(translate("Sens", "Held by nothing, left out: {names}").format(names=names))
        self.note.setText("\n".join([*lines, *self.reading.notes]))
        where = self.tool_point
        if not where:
            self.point.setText(translate("Sens", "a coordinate system named TCP or tool tip, if there is one"))
            return
        point = self.tip.point
        words = [" ".join(p for p in (where[0].Label, where[1].split(".")[-1]) if p)]
        words.append(point_text(point, 2))
        if self.tip.moved:
            words.append(translate("Sens", "The middle of the far end was taken for the side."))
        if self.tip.beyond > 0.5:
            text = translate("Sens", "The tool reaches {length} past this point.")
            words.append(text.format(length=length(self.tip.beyond)))
        self.point.setText("\n".join(words))

    def _chosen(self):
        """(tool side, workpiece side)."""
        first, second = self.branches
        return (second, first) if self.side.currentIndex() == 1 else (first, second)

    def take_point(self) -> None:
        """Use the selected point, edge or face as the tool point."""
        picked = Gui.Selection.getSelectionEx("", 0)
        if not picked:
            self.note.setText(translate("Sens", "Select a coordinate system, vertex, edge or face at the tool's tip"))
            return
        subs = picked[0].SubElementNames
        try:
            self.tip = tips.tip((picked[0].Object, subs[0] if subs else ""), self._carrier(picked[0]))
        except Refused as error:
            self.note.setText(messages.words(error))
            return
        self.tool_point = (self.tip.link[0], self.tip.link[1][0])
        self.show()

    def _carrier(self, picked):
        """A point of what carries the tool, the picked part apart; None where there is nothing else."""
        if self.reading is None:
            return None
        tool, _ = self._chosen()
        group = self.reading.groups[tool[-1].outer if tool else self.reading.bed]
        chosen = paths.place((picked.Object, picked.SubElementNames[0] if picked.SubElementNames else ""))
        others = [p for p in group.parts if p.key != chosen.key[: len(p.key)]]
        return geometry.centre_of_mass(others)

    def make(self):
        """Make the machine as chosen.  The caller opens the transaction."""
        tool, _ = self._chosen()
        group = self.reading.groups[tool[-1].outer if tool else self.reading.bed]
        machine = reader.machine_from_assembly(self.doc, self.reading, tool=group.parts[0], tool_point=self.tool_point)
        settings.give(machine)
        return machine

    def accept(self):
        if self.reading is None:
            messages.show(self.note.text())
            return False

        def make():
            machine = self.make()
            self.doc.recompute()
            extract.core_machine(machine)  # what is missing is refused: the panel stays, and the document as it was

        if not messages.change(self.doc, translate("Sens", "Machine from assembly"), make):
            return False
        self.close()
        return True


def open_panel(doc=None):
    """Open the panel for the selected assembly, or the first one of the document."""
    doc = doc or App.ActiveDocument
    names = {o.Name for o in found(doc)}
    chosen = next((o for o in Gui.Selection.getSelection() if o.Name in names), None)
    panel = TaskAssembly(doc, chosen)
    show_panel(panel, doc)
    return panel


@command
class MachineFromAssembly(Command):
    name = "Sens_MachineFromAssembly"
    menu_text = QT_TRANSLATE_NOOP("Sens_MachineFromAssembly", "Machine from Assembly…")
    tip = QT_TRANSLATE_NOOP("Sens_MachineFromAssembly", "Makes a machine from an assembly: its sliders are the axes")
    needs, guide = "document", TaskAssembly.guide
    where = Where("machine", 20)

    def ready(self):
        return bool(found(App.ActiveDocument))

    def run(self):
        open_panel()
