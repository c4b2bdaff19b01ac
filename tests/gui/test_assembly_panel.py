# SPDX-License-Identifier: LGPL-2.1-or-later
"""An assembly with three sliders becomes a machine through its panel; without one the command is greyed."""

from __future__ import annotations

import pytest

from sensworkbench.document import factory
from sensworkbench.gui.qt import pump

from ..document import assemblies
from .conftest import differences, look, run, screenshot, state
from .test_commands import active, click


def test_greyed_without_an_assembly(machine):
    assert not active("Sens_MachineFromAssembly")


@pytest.mark.skipif(not assemblies.available(), reason="FreeCAD without the Assembly workbench")
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
        machine = factory.machine_of(doc)
        assert machine.Structure == "XYFZ" and not machine.Problem, machine.Problem
        assert doc.UndoCount == undos + 1
        run("Sens_Sensitivity")
        assert factory.sensitivity_of(machine).Total
