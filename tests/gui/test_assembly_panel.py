# SPDX-License-Identifier: LGPL-2.1-or-later
"""An assembly with three sliders becomes a machine through its panel; without one the command is greyed."""

from __future__ import annotations

import pytest

from sensworkbench.document import tree
from sensworkbench.gui.qt import pump

from ..document import assemblies
from .conftest import differences, look, run, screenshot, state
from .test_commands import active, click


def test_greyed_without_an_assembly(machine):
    assert not active("Sens_MachineFromAssembly")


@pytest.mark.needs("assembly")
class TestAssembly:
    @pytest.fixture
    def assembly(self, doc, workbench):
        made, parts, _ = assemblies.slider_machine(doc)
        look(doc)
        pump(50)
        return made, parts

    def test_ok_makes_a_machine_as_one_undo_step(self, doc, assembly):
        import FreeCADGui as Gui

        _, parts = assembly
        assert active("Sens_MachineFromAssembly")
        before, undos = state(doc), doc.UndoCount
        run("Sens_MachineFromAssembly")
        from sensworkbench.gui.task_assembly import TaskAssembly

        panel = TaskAssembly(doc)
        assert "Structure: XYFZ" in panel.note.text()
        panel.side.setCurrentIndex(1)
        assert "Structure: ZFYX" in panel.note.text()
        assert differences(before, state(doc)) == []
        screenshot("assembly")
        click("Cancel")
        assert differences(before, state(doc)) == [] and doc.UndoCount == undos
        Gui.Selection.clearSelection()
        panel = TaskAssembly(doc)
        Gui.Control.showDialog(panel)
        Gui.Selection.addSelection(doc.Name, assembly[0].Name, f"{parts['Head'].Name}.Vertex1")
        panel.take.click()
        click("Ok")
        machine = tree.machine_of(doc)
        assert machine.Structure == "XYFZ" and not machine.Problem, machine.Problem
        assert doc.UndoCount == undos + 1
        run("Sens_Sensitivity")
        assert tree.sensitivity_of(machine).Total

    def test_jogging_drives_the_sliders_and_says_what_they_do_not_allow(self, doc, assembly):
        import FreeCADGui as Gui

        from sensworkbench.gui.task_jog import TaskJog

        parts = assembly[1]
        Gui.Selection.clearSelection()
        from sensworkbench.gui.task_assembly import TaskAssembly

        panel = TaskAssembly(doc)
        panel.tool_point = (assembly[0], f"{parts['Head'].Name}.Vertex1")
        Gui.Control.showDialog(panel)
        click("Ok")
        machine = tree.machine_of(doc)
        home, undos = parts["Head"].Placement.Base, doc.UndoCount
        jog = TaskJog(machine)
        Gui.Control.showDialog(jog)
        jog.numbers["Z"].setValue(75.0)
        pump(30)
        assert jog.note.text() == "" and (parts["Head"].Placement.Base - home).Length == pytest.approx(75, abs=1e-6)
        assert tree.axis_of(machine, "Z").Position.Value == pytest.approx(75, abs=1e-6)
        screenshot("assembly-jog")
        click("Ok")
        assert doc.UndoCount == undos + 1
        doc.undo()
        pump(60)
        assert (parts["Head"].Placement.Base - home).Length == pytest.approx(0, abs=1e-6)
        assemblies.ground(assembly[0], parts["Head"])
        doc.recompute()
        jog = TaskJog(machine)
        Gui.Control.showDialog(jog)
        jog.numbers["Z"].setValue(40.0)
        pump(30)
        assert "'Head' is grounded" in jog.note.text() and jog.numbers["Z"].value() == pytest.approx(0, abs=1e-3)
        click("Cancel")
        assert (parts["Head"].Placement.Base - home).Length == pytest.approx(0, abs=1e-6)
