# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shapes that FreeCAD cannot name, damaged ones and converted ones are asked without an exception."""

from __future__ import annotations

import FreeCAD as App
import Part
import pytest

from sensworkbench.core.refusal import Refused
from sensworkbench.document import curves, factory, geometry
from sensworkbench.document.paths import place
from sensworkbench.document.propose import suggestions

from .machines import offset_block

V = App.Vector


HOSTILE = {
    "ball": lambda: Part.makeSphere(5),
    "tip": lambda: Part.makeCone(5, 0, 20),
    "offset curve": offset_block,
    "offset surface": lambda: Part.makeBox(10, 20, 300).makeOffsetShape(2, 0.01),
    "splines": lambda: Part.makeBox(10, 20, 300).toNurbs(),
    "round splines": lambda: Part.makeCylinder(8, 300).toNurbs(),
    "ellipse": lambda: Part.Face(Part.Wire(Part.Ellipse(V(0, 0, 0), 20, 10).toShape())).extrude(V(0, 0, 50)),
    "torus": lambda: Part.makeTorus(30, 5),
}


@pytest.mark.parametrize("kind", HOSTILE)
def test_no_shape_is_asked_in_vain(doc, kind):
    shape = HOSTILE[kind]()
    obj = doc.addObject("Part::Feature", "Hostile")
    obj.Shape = shape
    for edge in shape.Edges:
        curves.line(edge), curves.circle(edge)
    for face in shape.Faces:
        curves.plane(face), curves.cylinder(face)
    suggestions.propose_axes([obj])
    for n in range(1, len(shape.Edges) + 1):
        try:
            geometry.direction(place((obj, f"Edge{n}")), "Automatic", "X")
        except Refused:
            pass
        try:
            geometry.point(place((obj, f"Edge{n}")), "Automatic")
        except Refused:
            pass
    rod = doc.addObject("Part::Feature", "Rod")
    rod.Shape = Part.makeBox(20, 20, 900)
    assert suggestions.propose_axes([obj, rod])[0].length == pytest.approx(900)


def test_null_and_endless_shapes_answer_nothing():
    for shape in (Part.Shape(), Part.Face(), Part.Edge() if hasattr(Part, "Edge") else Part.Shape(), None, 3):
        assert curves.curve(shape) is None and curves.surface(shape) is None
        assert curves.line(shape) is None and curves.plane(shape) is None and curves.cylinder(shape) is None
        assert curves.parts(shape, "Edges") == [] and curves.box(shape) is None and curves.number(shape, "Area") == 0
    assert curves.box(Part.Plane().toShape()) is None


def test_planes_cylinders_and_lines_are_known_as_splines_too():
    block = Part.makeBox(10, 20, 300).toNurbs()
    normals = sorted(tuple(round(v, 6) + 0.0 for v in curves.plane(f)) for f in block.Faces)
    assert normals == sorted([(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)])
    assert sum(curves.line(e) is not None for e in block.Edges) == len(block.Edges)
    bar = Part.makeCylinder(8, 300, V(1, 2, 3), V(0, 1, 0)).toNurbs()
    found = [c for f in bar.Faces if (c := curves.cylinder(f)) is not None]
    assert len(found) == 1
    centre, axis, radius, outside = found[0]
    assert radius == pytest.approx(8) and abs(axis.y) == pytest.approx(1) and outside
    assert (centre.x, centre.z) == (pytest.approx(1), pytest.approx(3))
    bore = Part.makeBox(30, 30, 30).cut(Part.makeCylinder(8, 30, V(15, 15, 0)))
    assert [c[3] for f in bore.Faces if (c := curves.cylinder(f)) is not None] == [False]
    assert all(curves.line(e) is None for e in Part.makeCircle(5).Edges)


def test_a_direction_from_a_degenerated_edge_is_refused_in_words(doc):
    ball = doc.addObject("Part::Sphere", "Ball")
    doc.recompute()
    machine = factory.make_machine(doc)
    axis = factory.make_axis(machine, "X", [ball])
    degenerated = next(n for n, e in enumerate(ball.Shape.Edges, 1) if e.Degenerated)
    with pytest.raises(Refused):
        geometry.direction(place((ball, f"Edge{degenerated}")), "Automatic", "X")
    axis.DirectionSource = (ball, [f"Edge{degenerated}"])
    doc.recompute()
    assert machine.Problem
