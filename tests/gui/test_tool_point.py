# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tool point is shown with its coordinates and a mark, and the side of a spindle stands for its far end."""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui
import pytest

from sensworkbench.document import paths, tips, tree
from sensworkbench.gui.qt import pump
from sensworkbench.gui.task_machine import new_machine

from .test_commands import click
from .test_panels import loose_parts


@pytest.fixture
def spindle(doc, workbench):
    """A machine's parts with a spindle of radius 20 that hangs from the headstock, z 180 to 300, and no tool tip."""
    parts = loose_parts(doc)
    doc.removeObject("TCP")
    doc.removeObject(parts["Spindle"].Name)
    turned = doc.addObject("Part::Cylinder", "Spindle")
    turned.Radius, turned.Height = 20, 120
    turned.Placement.Base = App.Vector(60, 250, 180)
    doc.recompute()
    return turned


def element(obj, kind: str, z: float) -> str:
    """The flat face, side face or circle of a cylinder whose middle is at a height."""
    for number, shape in enumerate(getattr(obj.Shape, kind), start=1):
        if abs(shape.CenterOfMass.z - z) < 1e-6 and (kind != "Edges" or hasattr(shape.Curve, "Center")):
            return f"{kind[:-1]}{number}"
    raise AssertionError((kind, z))


def take(panel, obj, sub):
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(obj.Document.Name, obj.Name, sub)
    panel.tool_point.take.click()


def test_the_side_of_a_spindle_gives_the_middle_of_its_far_end(spindle):
    doc = spindle.Document
    panel = new_machine(doc)
    take(panel, spindle, element(spindle, "Faces", 240.0))
    machine = tree.machine_of(doc)
    assert machine.FunctionalPoint == App.Vector(60, 250, 180)
    assert machine.ToolPoint[1] == [element(spindle, "Edges", 180.0)]
    assert "x 60.00   y 250.00   z 180.00 mm" in panel.tool_words.text() and "far end" in panel.tool_words.text()
    marks = [a for a in machine.ViewObject.Proxy.arrows.shown if "Tool point" in a.text]
    assert [(m.start, m.end) for m in marks] == [((60, 250, 180), (60, 250, 180))]
    click("Cancel")


def test_a_rim_inside_the_head_is_taken_with_a_word(spindle):
    panel = new_machine(spindle.Document)
    take(panel, spindle, element(spindle, "Edges", 300.0))
    assert tree.machine_of(spindle.Document).FunctionalPoint.z == 300.0  # as chosen
    assert "reaches 120.0 mm past" in panel.tool_words.text()
    take(panel, spindle, element(spindle, "Edges", 180.0))
    assert "reaches" not in panel.tool_words.text()
    click("Cancel")


def test_the_coordinates_follow_a_part_that_moved(spindle):
    panel = new_machine(spindle.Document)
    take(panel, spindle, element(spindle, "Faces", 180.0))
    assert "z 180.00" in panel.tool_words.text() and "far end" not in panel.tool_words.text()
    spindle.Placement.Base.z = 175
    panel.show()
    pump(20)
    assert "z 175.00" in panel.tool_words.text()
    click("Cancel")


@pytest.mark.parametrize("carrier, z", [(App.Vector(0, 0, 500), 0.0), (App.Vector(0, 0, -500), 50.0), (None, 0.0)])
def test_the_far_end_is_the_one_away_from_what_carries_the_tool(doc, workbench, carrier, z):
    turned = doc.addObject("Part::Cylinder", "Tool")
    turned.Radius, turned.Height = 5, 50
    doc.recompute()
    found = tips.tip((turned, element(turned, "Faces", 25.0)), carrier)
    assert found.point == App.Vector(0, 0, z) and found.moved
    assert paths.place(found.link).shape().Curve.Center == App.Vector(0, 0, z)


def test_a_cone_and_a_turned_cylinder(doc, workbench):
    drill = doc.addObject("Part::Cone", "Drill")
    drill.Radius1, drill.Radius2, drill.Height = 2, 8, 40
    drill.Placement = App.Placement(App.Vector(10, 0, 0), App.Rotation(App.Vector(0, 1, 0), 30))
    doc.recompute()
    side = next(i for i, f in enumerate(drill.Shape.Faces, start=1) if "Cone" in str(type(f.Surface)))
    found = tips.tip((drill, f"Face{side}"), App.Vector(drill.Placement.multVec(App.Vector(0, 0, 200))))
    assert (found.point - App.Vector(10, 0, 0)).Length < 1e-9 and found.beyond < 1e-6
