# SPDX-License-Identifier: LGPL-2.1-or-later
"""Placements become lever arms, wherever in the tree the parts stand."""

from __future__ import annotations

import FreeCAD as App
import numpy as np
import pytest

from sensworkbench.core import synthesis, workspace
from sensworkbench.core.refusal import Refused
from sensworkbench.document import extract, jog, results, told, tree
from sensworkbench.document.base import numbers

from .blocks import REFERENCES, TOOL, TURNED, P, R, V, block, close, golden_machine, point

UM, URAD = 1e-3, 1e-6
ERRORS = {
    "EXX": 1 * UM, "EYX": 5 * UM, "EZX": -3 * UM, "EXY": 4 * UM, "EYY": -1 * UM, "EZY": 2 * UM, "EXZ": -2 * UM,
    "EYZ": 3 * UM, "EZZ": 0.5 * UM, "EAX": 10 * URAD, "EBX": -15 * URAD, "ECX": 20 * URAD, "EAY": -5 * URAD,
    "EBY": 12 * URAD, "ECY": 8 * URAD, "EAZ": 6 * URAD, "EBZ": -9 * URAD, "ECZ": 4 * URAD, "C0Y": 20 * URAD,
    "A0Z": -15 * URAD, "B0Z": 10 * URAD,
}  # fmt: skip
GOLDEN = {
    "FXYZ": (1.140, 12.890, -0.205), "YFXZ": (2.940, 14.490, -4.855), "XYFZ": (-0.060, 16.890, 2.045),
    "XFYZ": (1.140, 16.890, 2.795),
}  # fmt: skip


@pytest.mark.parametrize("code", GOLDEN)
def test_a_machine_of_parts_gives_the_golden_volumetric_error(doc, code):
    machine = golden_machine(doc, code)
    assert machine.Problem == ""
    assert machine.Structure == code
    error = synthesis.volumetric_error(extract.core_machine(machine), ERRORS, [[200, 150, -100]])
    np.testing.assert_allclose(error[0] * 1e3, GOLDEN[code], atol=5e-7)


def test_the_abbe_offset_is_tool_point_minus_reference_where_they_stand(doc):
    machine = golden_machine(doc, "XYFZ")
    z = tree.axis_of(machine, "Z")
    assert close(z.AbbeOffset, V(*TOOL) - V(*REFERENCES["Z"]))
    jog.jog(machine, {"X": 200, "Y": 150, "Z": -100})
    doc.recompute()
    assert close(z.AbbeOffset, V(*TOOL) - V(*REFERENCES["Z"]))  # both ride on Z
    x = tree.axis_of(machine, "X")  # the table moves by -200 and -150, the tool by -100
    assert close(x.AbbeOffset, V(*TOOL) + V(0, 0, -100) - (V(*REFERENCES["X"]) - V(200, 150, 0)))
    assert x.AbbeOffsetX.Value == pytest.approx(10 - 30 + 200)
    tip, reference = doc.getObject("Tip").Placement.Base, doc.getObject("RefX").Placement.Base
    assert close(x.AbbeOffset, tip - reference)  # and the parts really stand there


@pytest.mark.parametrize("code", GOLDEN)
def test_a_machine_turned_and_shifted_as_a_whole_has_the_same_indices(doc, code):
    straight = results.compute(golden_machine(doc, code))
    part = doc.addObject("App::Part", "Hall")
    inner = doc.addObject("App::Part", "Cell")
    part.addObject(inner)
    part.Placement, inner.Placement = TURNED, P(V(5, 6, 7), R(V(0, 1, 1), 100))
    turned_machine = golden_machine(doc, code, parent=inner)
    assert turned_machine.Problem == ""
    u = numbers(tree.axis_of(turned_machine, "X").Direction)
    assert close(u, (part.Placement * inner.Placement).Rotation.multVec(V(1, 0, 0)))
    turned = results.compute(turned_machine)
    np.testing.assert_allclose(turned.Total, straight.Total, atol=1e-9)
    np.testing.assert_allclose(turned.First, straight.First, atol=1e-9)
    assert turned.MeanSquare == pytest.approx(straight.MeanSquare, rel=1e-9)
    assert tree.axis_of(turned_machine, "Y").AbbeOffsetX.Value == pytest.approx(10 + 60)


def test_moving_the_whole_machine_does_not_make_results_stale_but_moving_a_reference_does(doc):
    part = doc.addObject("App::Part", "Hall")
    machine = golden_machine(doc, parent=part)
    found = results.compute(machine)
    part.Placement = TURNED
    doc.recompute()
    assert not found.Stale
    doc.getObject("RefX").Placement.Base += V(0, 0, 1)
    doc.recompute()
    assert found.Stale
    assert extract.core_machine(machine).axes["X"].reference != REFERENCES["X"]


def test_moving_a_part_moves_what_was_taken_from_it(doc):
    machine = golden_machine(doc)
    x = tree.axis_of(machine, "X")
    x.ReferenceSource = (doc.getObject("CarriageX"), ["Face6"])  # the top of a 20 mm cube at REFERENCES
    doc.recompute()
    before = V(x.ReferencePoint)
    assert close(before, V(*REFERENCES["X"]) + V(10, 10, 20))
    doc.getObject("CarriageX").Placement.Base += V(1, 2, 3)
    doc.recompute()
    assert close(x.ReferencePoint, before + V(1, 2, 3))


def test_the_same_part_linked_twice_stands_in_two_places(doc):
    carriage = doc.addObject("App::Part", "Carriage")
    body = block(doc, "Block", (1, 2, 3), parent=carriage)
    top = doc.addObject("App::Part", "Top")
    links = []
    for name, at in (("LinkX", (100, 0, 0)), ("LinkY", (0, 200, 0))):
        link = doc.addObject("App::Link", name)
        link.LinkedObject = carriage
        link.Placement = P(V(*at), R(V(0, 0, 1), 90 if name == "LinkY" else 0))
        top.addObject(link)
        links.append(link)
    top.Placement = P(V(0, 0, 50), R())
    machine = golden_machine(doc)
    x, y = tree.axis_of(machine, "X"), tree.axis_of(machine, "Y")
    x.Parts, x.ReferenceSource = [(top, "LinkX.")], (top, ["LinkX.Block."])
    y.Parts, y.ReferenceSource = [(top, "LinkY.")], (top, ["LinkY.Block."])
    x.ReferenceAt = y.ReferenceAt = "Placement"
    y.DirectionAlong = "Local X"  # its link is turned by 90 degrees
    doc.recompute()
    assert machine.Problem == ""
    assert close(x.ReferencePoint, (101, 2, 53))
    assert close(y.ReferencePoint, (-2, 201, 53))  # turned by 90 degrees
    jog.jog(machine, {"X": 10, "Y": 20})
    doc.recompute()
    assert close(links[0].Placement.Base, (90, -20, 0)) and close(links[1].Placement.Base, (0, 180, 0))
    assert close(body.Placement.Base, (1, 2, 3))  # the shared original stays
    assert close(x.ReferencePoint, (101, 2, 53))


def test_a_part_of_another_document_counts_where_its_link_stands(doc, tmp_path):
    other = App.newDocument("Library")
    try:
        part = other.addObject("App::Part", "Saddle")
        block(other, "Casting", (7, 0, 0), parent=part)
        other.recompute()
        other.saveAs(str(tmp_path / "library.FCStd"))
        doc.saveAs(str(tmp_path / "machine.FCStd"))
        link = doc.addObject("App::Link", "SaddleLink")
        link.LinkedObject = part
        link.Placement = P(V(0, 300, 0), R(V(0, 0, 1), 90))
        machine = golden_machine(doc)
        y = tree.axis_of(machine, "Y")
        y.Parts, y.ReferenceSource = [(link, "")], (link, ["Casting."])
        y.ReferenceAt, y.DirectionAlong = "Placement", "Local X"
        doc.recompute()
        assert machine.Problem == ""
        assert close(y.ReferencePoint, (0, 307, 0))
        part.getObject("Casting").Placement.Base = V(8, 0, 0)
        other.recompute()
        doc.recompute()
        assert close(y.ReferencePoint, (0, 308, 0))
    finally:
        App.closeDocument(other.Name)


def test_directions_from_edges_faces_datums_and_local_axes(doc):
    machine = golden_machine(doc)
    x = tree.axis_of(machine, "X")
    rail = doc.addObject("Part::Cylinder", "Rail")
    rail.Placement = P(V(0, 0, 0), R(V(0, 1, 0), 90))
    line = doc.addObject("PartDesign::Line", "DatumLine")
    line.Placement = P(V(), R(V(0, 1, 0), 90))
    slab = block(doc, "Slab")
    doc.recompute()
    for source in ((rail, ["Face1"]), (rail, ["Edge2"]), (line, [""]), (slab, ["Face2"])):
        x.DirectionSource = source
        doc.recompute()
        assert machine.Problem == "", source
        assert abs(x.Direction.x) == pytest.approx(1), (source, x.Direction)
    x.DirectionSource, x.DirectionAlong = (rail, [""]), "Local Z"
    doc.recompute()
    assert close(x.Direction, (1, 0, 0)) and told.words(x.DirectionFrom) == "local Z of Rail"
    x.Reverse = True
    doc.recompute()
    assert close(x.Direction, (-1, 0, 0))


def test_the_default_direction_is_the_local_axis_of_the_same_name_and_the_reference_the_centre_of_mass(doc):
    machine = golden_machine(doc)
    y = tree.axis_of(machine, "Y")
    y.ReferenceSource = None
    doc.recompute()
    assert close(y.Direction, (0, 1, 0)) and told.words(y.DirectionFrom) == "local Y of CarriageY"
    assert close(y.ReferencePoint, V(*REFERENCES["Y"]) + V(10, 10, 10))
    assert told.words(y.ReferenceFrom) == "centre of mass of CarriageY"
    doc.getObject("CarriageY").Placement = P(V(1, 2, 3), R(V(0, 0, 1), 1))
    doc.recompute()
    assert close(y.ReferencePoint, doc.getObject("CarriageY").Shape.CenterOfMass)
    doc.getObject("CarriageY").Length = 40
    doc.recompute()
    assert close(y.ReferencePoint, doc.getObject("CarriageY").Shape.CenterOfMass)


def test_the_centre_of_mass_of_a_carriage_of_several_parts_weighs_them(doc):
    machine = golden_machine(doc)
    pair = doc.addObject("App::Part", "Pair")
    block(doc, "Small", (0, 0, 0), 10, pair)
    large = block(doc, "Large", (100, 0, 0), 20, pair)
    hole = doc.addObject("Part::Cut", "Bored")  # what a feature of the container has consumed does not count twice
    hole.Base, hole.Tool = large, block(doc, "Drill", (100, 0, 0), 10, pair)
    pair.addObject(hole)
    x = tree.axis_of(machine, "X")
    x.Parts, x.ReferenceSource = [(pair, "")], None
    doc.recompute()
    masses = [(V(5, 5, 5), 1000), (V(110, 10, 10), 8000), (V(105, 5, 5), -1000)]
    expected = sum((c * m for c, m in masses), V()) * (1 / 8000)
    assert close(x.ReferencePoint, expected, 1e-6)


def test_bodies_folders_and_origin_axes(doc):
    machine = golden_machine(doc)
    body = doc.addObject("PartDesign::Body", "Carrier")
    box = body.newObject("PartDesign::AdditiveBox", "Pad")
    body.Placement = P(V(0, 0, 30), R(V(0, 0, 1), 90))
    folder = doc.addObject("App::DocumentObjectGroup", "Folder")
    extra = block(doc, "Extra", (1, 1, 1))
    folder.addObject(body)
    folder.addObject(extra)
    doc.recompute()
    x = tree.axis_of(machine, "X")
    x.Parts = [(folder, "")]
    origin = body.Origin
    y_axis = next(o for o in origin.OriginFeatures if o.Name.startswith("Y_Axis"))
    plane = next(o for o in origin.OriginFeatures if o.Name.startswith("XZ_Plane"))
    for source, sign in ((y_axis, -1), (plane, None)):  # both along the body's local y, which points to -x
        x.DirectionSource = (body, [f"{origin.Name}.{source.Name}."])
        doc.recompute()
        assert machine.Problem == ""
        assert abs(x.Direction.x) == pytest.approx(1)
        assert sign is None or x.Direction.x == pytest.approx(sign)
    x.DirectionSource = None
    x.DirectionAlong, x.Reverse = "Local Y", True
    doc.recompute()
    names = {w.object.Name for w in tree.parts_of(machine, "X")}
    assert names == {"Carrier", "Extra"}
    assert tree.owner_of(machine, box) == "X" and tree.owner_of(machine, body, "Pad.Face1") == "X"
    assert tree.owner_of(machine, doc.getObject("Bed")) == "F"
    jog.jog(machine, {"X": 5})
    assert close(body.Placement.Base, (-5, 0, 30)) and close(extra.Placement.Base, (-4, 1, 1))
    assert close(box.Placement.Base, (0, 0, 0))


def test_a_skew_of_less_than_five_degrees_is_reported(doc):
    machine = golden_machine(doc)
    doc.getObject("CarriageY").Placement.Rotation = R(V(0, 0, 1), 2)
    doc.recompute()
    assert machine.Problem == "" and float(machine.Skew["XY"]) == pytest.approx(2)


# -- refusals --------------------------------------------------------------------------------------------------------
def _skewed(doc, machine):
    doc.getObject("CarriageY").Placement.Rotation = R(V(0, 0, 1), 6)


def _parallel(doc, machine):
    tree.axis_of(machine, "Y").DirectionAlong = "Local X"


def _twice(doc, machine):
    tree.axis_of(machine, "Y").Parts = [(doc.getObject("CarriageX"), "")]


def _no_tool_point(doc, machine):
    machine.ToolPoint = None


def _not_in_a_chain(doc, machine):
    machine.ToolChain = []


def _no_carriage(doc, machine):
    tree.axis_of(machine, "Z").Parts = []


def _no_axis(doc, machine):
    doc.removeObject(tree.axis_of(machine, "Z").Name)


def _wrong_container(doc, machine):
    part = doc.addObject("App::Part", "Column")
    part.addObject(doc.getObject("CarriageZ"))
    tree.axis_of(machine, "X").Parts = [(part, "")]
    tree.axis_of(machine, "Z").Parts = [(part, "CarriageZ.")]


def _no_travel(doc, machine):
    x = tree.axis_of(machine, "X")
    x.TravelLower = x.TravelUpper = 5


def _part_deleted(doc, machine):
    part = doc.addObject("App::Part", "Holder")
    part.addObject(doc.getObject("CarriageZ"))
    tree.axis_of(machine, "Z").Parts = [(part, "CarriageZ.")]
    part.removeObject(doc.getObject("CarriageZ"))
    doc.removeObject("CarriageZ")


def _edge_lost(doc, machine):
    tree.axis_of(machine, "X").DirectionSource = (doc.getObject("Bed"), ["Edge99"])


def _no_direction(doc, machine):
    tree.axis_of(machine, "X").DirectionSource = (doc.getObject("Bed"), ["Vertex1"])


@pytest.mark.parametrize(
    ("spoil", "code", "words"),
    [
        (_edge_lost, "part-element-gone", ("Axis X", "Bed")),
        (_no_direction, None, ("Axis X", "Bed Vertex1", "gives no direction")),
        (_skewed, "directions-not-square", ("X", "Y", "CarriageX", "CarriageY")),
        (_parallel, "directions-parallel", ("X", "Y", "CarriageY")),
        (_twice, "part-in-two-bodies", ("CarriageX", "Axis X", "Axis Y")),
        (_no_tool_point, "tool-point-missing", ("Golden",)),
        (_not_in_a_chain, "chain-joint-missing", ("Golden", "Z")),
        (_no_carriage, "axis-without-carriage", ("Golden", "Axis Z")),
        (_no_axis, "axis-object-missing", ("Golden", "Z")),
        (_wrong_container, "part-inside-another-body", ("CarriageZ", "Axis Z", "Axis X")),
        (_no_travel, "travel-without-length", ("Axis X",)),
        (_part_deleted, "part-path-dead", ("Holder", "CarriageZ")),
    ],
)
def test_what_is_no_machine_is_refused_by_name(doc, spoil, code, words):
    machine = golden_machine(doc)
    spoil(doc, machine)
    doc.recompute()
    with pytest.raises(Refused) as refusal:
        extract.core_machine(machine)
    assert code in (refusal.value.code, None)
    for word in words:
        assert word in refusal.value.message
    assert machine.Problem == refusal.value.message


def test_a_part_without_a_shape_yet_stands_where_its_placement_is(doc):
    machine = golden_machine(doc)
    empty = doc.addObject("Part::Feature", "Imported")
    empty.Placement.Base = V(1, 2, 3)
    x = tree.axis_of(machine, "X")
    x.Parts, x.ReferenceSource = [(empty, "")], None
    doc.recompute()
    assert machine.Problem == "" and close(x.ReferencePoint, (1, 2, 3))


def test_a_document_without_a_machine_is_refused(doc):
    with pytest.raises(Refused, match="holds no machine"):
        tree.machine_of(doc)


def test_indices_of_the_document_are_those_of_the_core(doc):
    machine = golden_machine(doc, "FXYZ", references=dict.fromkeys("XYZ", (0, 0, 0)), tool=(0, 0, -150))
    machine.Aggregate, machine.At = "at", [200, 150, -100]
    for obj in (doc.getObject(f"Ref{n}") for n in "XYZ"):
        assert close(obj.Placement.Base, (0, 0, 0))
    found = results.compute(machine)
    table = dict(zip(found.Symbols, found.Total))
    assert found.MeanSquare == pytest.approx(1.047500e-4, rel=1e-6)
    assert found.Variance == pytest.approx(7.154850e-9, rel=1e-6)
    for symbol, total in {"EAX": 0.1874, "EXY": 0.1801, "EZX": 0.0625, "EZT": 0.0009, "ECZ": 0}.items():
        assert table[symbol] == pytest.approx(total, abs=5e-5)
    back = results.load(machine, found)
    assert isinstance(back, workspace.Sensitivity) and not found.Stale
    np.testing.assert_array_equal(back.total, found.Total)


def test_loose_points_ride_with_the_body_that_names_them(doc):
    machine = golden_machine(doc)
    assert point(doc, "Elsewhere", (1, 1, 1)) is not None
    jog.jog(machine, {"Z": 120})
    assert close(doc.getObject("Tip").Placement.Base, V(*TOOL) + V(0, 0, 120))
    assert close(doc.getObject("Elsewhere").Placement.Base, (1, 1, 1))
