# SPDX-License-Identifier: LGPL-2.1-or-later
"""A machine out of an assembly: who is who, where, how far it goes, and what follows when the solver moves a part."""

from __future__ import annotations

import FreeCAD as App
import numpy as np
import pytest

from sensworkbench.core import workspace
from sensworkbench.core.refusal import Refused
from sensworkbench.document import assembly as from_assembly
from sensworkbench.document import drive, extract, results, told, tree

from .assemblies import PLACES, SLIDERS, TIP, ground, group_of, join, limit, new_assembly, slider_machine
from .blocks import TURNED, block, close, golden_machine, point

pytestmark = pytest.mark.needs("assembly")

V, P, R = App.Vector, App.Placement, App.Rotation


@pytest.fixture
def made(doc):
    """(assembly, parts, joints, machine) of the golden machine, joined by sliders."""
    assembly, parts, joints = slider_machine(doc)
    machine = from_assembly.machine_from_assembly(
        doc, assembly, tool=parts["Head"], tool_point=point(doc, "Tip", TIP, assembly)
    )
    return assembly, parts, joints, machine


def named(machine, body):
    return [p.object.Name for p in tree.parts_of(machine, body)]


def test_joints_say_who_is_who_where_and_how_far(made):
    _, _, _, machine = made
    assert machine.Problem == "" and machine.Structure == "XYFZ"
    assert (machine.WorkpieceChain, machine.ToolChain) == (["Y", "X"], ["Z"])
    assert {b: named(machine, b) for b in "FXYZ"} == {"F": ["Bed"], "X": ["Table"], "Y": ["Saddle"], "Z": ["Head"]}
    for name, direction, at in (("X", (1, 0, 0), (30, -180, 200)), ("Y", (0, 1, 0), (-60, -200, 100)),
                                ("Z", (0, 0, 1), (15, 100, 600))):  # fmt: skip
        axis = tree.axis_of(machine, name)
        assert close(axis.Direction, direction) and close(axis.ReferencePoint, at), name
        assert (axis.TravelLower.Value, axis.TravelUpper.Value) == (-300, 300)
        assert axis.Position.Value == 0
        assert f"Slider {name}" in told.words(axis.DirectionFrom) and f"Slider {name}" in told.words(axis.ReferenceFrom)


def test_indices_are_those_of_the_same_machine_without_joints(doc, made):
    other = App.newDocument("SensTestOther")
    try:
        plain = results.compute(golden_machine(other))
        found = results.compute(made[3])
        known = dict(zip(plain.Symbols, plain.Total))
        for symbol, total in zip(found.Symbols, found.Total):
            assert total == pytest.approx(known[symbol], rel=1e-9, abs=1e-12), symbol
    finally:
        App.closeDocument(other.Name)


def test_an_assembly_that_is_turned_and_moved_has_the_same_indices(made):
    assembly, _, _, machine = made
    before = list(results.compute(machine).Total)
    assembly.Placement = TURNED
    assembly.Document.recompute()
    assert close(tree.axis_of(machine, "X").Direction, TURNED.Rotation.multVec(V(1, 0, 0)))
    assert machine.Problem == ""
    np.testing.assert_allclose(list(results.compute(machine).Total), before, rtol=1e-7, atol=1e-12)


@pytest.mark.parametrize("name, body, step", [("Slider Z", "Z", (0, 0, 40)), ("Slider X", "X", (-25, 0, 0))])
def test_a_drag_along_a_slider_is_a_jog(made, name, body, step):
    """The carriage has moved, the machine has not: Position and Abbe offsets follow, the indices stay valid."""
    assembly, parts, joints, machine = made
    found = results.compute(machine)
    before = extract.core_machine(machine)
    moved = {"Slider Z": ["Head"], "Slider X": ["Table"]}[name]
    for part in moved:
        parts[part].Placement.Base += V(*step)
    if body == "Z":
        machine.Document.getObject("Tip").Placement.Base += V(*step)
    assert assembly.solve() == 0
    machine.Document.recompute()
    axis = tree.axis_of(machine, body)
    along = sum(s * u for s, u in zip(step, axis.Direction))
    expected = along if body == "Z" else -along  # the table moves against the tool
    assert axis.Position.Value == pytest.approx(expected, abs=1e-6)
    assert machine.Problem == "" and not found.Stale
    assert "Touched" not in axis.State
    after = extract.core_machine(machine)
    for one, other in zip(before.axes.values(), after.axes.values()):
        np.testing.assert_allclose(one.reference, other.reference, atol=1e-6)
    np.testing.assert_allclose(before.tool_point, after.tool_point, atol=1e-6)
    offset = tree.axis_of(machine, "Y").AbbeOffset
    at_home = V(*before.tool_point) - V(*before.axes["Y"].reference)
    assert close(offset, at_home + (V(*step) if body == "Z" else V()), 1e-6)


def test_driving_the_sliders_is_a_drag_to_given_positions(made):
    """All three axes at once, and back: each stands where it was asked, indices over the travel stay valid."""
    assembly, parts, _, machine = made
    found = results.compute(machine)
    home = {name: part.Placement.copy() for name, part in parts.items()}
    assert drive.held_by_sliders(machine)
    asked = {"X": 60.0, "Y": -35.0, "Z": 120.0}
    drive.drive(machine, asked)
    machine.Document.recompute()
    for name, value in asked.items():
        assert tree.axis_of(machine, name).Position.Value == pytest.approx(value, abs=1e-6)
    assert machine.Problem == "" and not found.Stale
    u = {name: tree.axis_of(machine, name).Direction for name in "XYZ"}
    expected = {"Bed": V(), "Head": u["Z"] * 120, "Saddle": u["Y"] * 35, "Table": u["Y"] * 35 - u["X"] * 60}
    for name, shift in expected.items():
        assert close(parts[name].Placement.Base - home[name].Base, shift, 1e-6), name
    drive.drive(machine, {"X": 0.0, "Y": 0.0, "Z": 0.0})
    for name, part in parts.items():
        assert close(part.Placement.Base, home[name].Base, 1e-6), name


def test_what_the_assembly_does_not_allow_is_refused_and_nothing_has_moved(made):
    assembly, parts, joints, machine = made
    home = {name: part.Placement.copy() for name, part in parts.items()}
    with pytest.raises(Refused, match="outside the travel"):
        drive.drive(machine, {"X": 1e4})
    fixed = join(assembly, "Fixed", "Clamp", parts["Bed"], parts["Head"])
    machine.Document.recompute()
    with pytest.raises(Refused, match="does not let Slider Z go"):
        drive.drive(machine, {"Z": 50.0})
    machine.Document.removeObject(fixed.Name)
    ground(assembly, parts["Head"])
    machine.Document.recompute()
    with pytest.raises(Refused, match="'Head' is grounded"):
        drive.drive(machine, {"Z": 50.0})
    for name, part in parts.items():
        assert close(part.Placement.Base, home[name].Base, 1e-9), name


def test_a_drag_moves_the_indices_at_the_current_position(made):
    assembly, parts, _, machine = made
    core = extract.core_machine(machine)
    at_home = workspace.sensitivity(core, workspace.at(core, extract.current_position(machine)))
    for obj in (parts["Head"], machine.Document.getObject("Tip")):
        obj.Placement.Base += V(0, 0, -120)
    assembly.solve()
    assembly.Document.recompute()
    core = extract.core_machine(machine)
    below = workspace.sensitivity(core, workspace.at(core, extract.current_position(machine)))
    assert abs(below.total - at_home.total).max() > 1e-3


def test_what_changes_the_machine_makes_the_result_stale_and_compute_mends_it(made):
    assembly, _, joints, machine = made
    found = results.compute(machine)
    old = list(found.Total)
    tip = machine.Document.getObject("Tip")
    tip.Placement.Base += V(0, 0, -60)  # a longer tool
    assembly.Document.recompute()
    assert found.Stale
    assert list(results.compute(machine).Total) != old and not found.Stale
    joints["Slider X"].LengthMax = 120  # limits were read when the machine was made
    assembly.Document.recompute()
    assert not found.Stale


def test_positions_and_limits_count_as_the_sliders_do(doc):
    """Home is where the joints stand at 0; a table's slider counts against the machine's axis."""
    assembly, parts, joints = slider_machine(doc, limits={"Slider X": (-100, 250), "Slider Z": (-50, 400)})
    for part, step in (("Table", (30, 0, 0)), ("Head", (0, 0, 12))):
        parts[part].Placement.Base += V(*step)
    doc.recompute()
    machine = from_assembly.machine_from_assembly(doc, assembly, tool=parts["Head"], tool_point=parts["Head"])
    x, z = (tree.axis_of(machine, n) for n in "XZ")
    assert (x.TravelLower.Value, x.TravelUpper.Value, x.Position.Value) == pytest.approx((-250, 100, -30))
    assert (z.TravelLower.Value, z.TravelUpper.Value, z.Position.Value) == pytest.approx((-50, 400, 12))
    assert close(x.ReferencePoint, SLIDERS["Slider X"][2]) and close(z.ReferencePoint, SLIDERS["Slider Z"][2])


def test_a_slider_without_limits_gets_a_travel_that_says_so(doc):
    assembly, parts, joints = slider_machine(doc)
    joints["Slider Y"].EnableLengthMax = False
    reading = from_assembly.read(assembly)
    machine = from_assembly.machine_from_assembly(doc, reading, tool=parts["Head"], travel={"X": (-10, 20)})
    y, x = tree.axis_of(machine, "Y"), tree.axis_of(machine, "X")
    assert (y.TravelLower.Value, y.TravelUpper.Value) == (-100, 100)
    assert (x.TravelLower.Value, x.TravelUpper.Value) == (-10, 20)
    assert any("Slider Y" in note for note in reading.notes)
    assert "tool point" in machine.Problem


def test_which_side_carries_the_tool_is_stated_or_proposed(doc):
    assembly, parts, _ = slider_machine(doc)
    structure = {}
    for key, options in {"names": {}, "tool": {"tool": parts["Head"]}, "work": {"workpiece": (assembly, "Table.")},
                         "turned": {"tool": parts["Table"]}}.items():  # fmt: skip
        reading = from_assembly.read(assembly)
        from_assembly.name_axes(reading)
        structure[key] = [[s.axis for s in side] for side in from_assembly.sides(reading, **options)]
    assert structure["names"] == structure["tool"] == structure["work"] == [["Y", "X"], ["Z"]]
    assert structure["turned"] == [["Z"], ["Y", "X"]]
    with pytest.raises(Refused, match="Bed"):
        from_assembly.sides(reading, tool=parts["Bed"])


def test_a_joint_turned_round_or_listed_the_other_way_is_the_same_axis(doc):
    sliders = {
        "A": ("Saddle", "Bed", (-60, -200, 100), (0, -1, 0)),
        "B": ("Table", "Saddle", (30, -180, 200), (1, 0, 0)),
        "C": ("Bed", "Head", (15, 100, 600), (0, 0, -1)),
    }
    assembly, parts, _ = slider_machine(doc, sliders=sliders, limits={"A": (-10, 20), "B": (-30, 40), "C": (-50, 60)})
    machine = from_assembly.machine_from_assembly(doc, assembly, tool=parts["Head"], tool_point=parts["Head"])
    assert machine.Structure == "XYFZ"
    axes = {n: tree.axis_of(machine, n) for n in "XYZ"}
    for n, u in zip("XYZ", ((1, 0, 0), (0, 1, 0), (0, 0, 1))):
        assert close(axes[n].Direction, u)
    # A: side 2 is the bed, so the saddle moves along +Y with growing distance; a workpiece side counts against that
    assert (axes["Y"].TravelLower.Value, axes["Y"].TravelUpper.Value) == (-20, 10)
    assert (axes["X"].TravelLower.Value, axes["X"].TravelUpper.Value) == (-30, 40)
    assert (axes["Z"].TravelLower.Value, axes["Z"].TravelUpper.Value) == (-60, 50)
    for part, step, n, q in (("Saddle", (0, 7, 0), "Y", -7), ("Head", (0, 0, 9), "Z", 9)):
        parts[part].Placement.Base += V(*step)
        if part == "Saddle":
            parts["Table"].Placement.Base += V(*step)
        doc.recompute()
        assert axes[n].Position.Value == pytest.approx(q)


def test_fixed_parts_are_one_body_turning_ones_ride_and_loose_ones_are_named(doc):
    assembly, parts, _ = slider_machine(doc)
    motor, spindle, loose = (block(doc, n, (0, 0, 700), parent=assembly) for n in ("Motor", "Cutter", "Bracket"))
    join(assembly, "Fixed", "Bolts", parts["Head"], motor)
    join(assembly, "Revolute", "Bearing", motor, spindle)
    reading = from_assembly.read(assembly)
    machine = from_assembly.machine_from_assembly(doc, reading, tool_point=spindle)
    assert sorted(named(machine, "Z")) == ["Cutter", "Head", "Motor"]
    assert [p.object for p in reading.left_out] == [loose] and any("Bracket" in n for n in reading.notes)
    assert machine.Structure == "XYFZ"


def test_two_rails_of_one_axis_are_one_slider(doc):
    assembly, parts, joints = slider_machine(doc)
    join(assembly, "Slider", "Slider Y left", parts["Bed"], parts["Saddle"], (200, -200, 100), (0, -1, 0))
    assert len(from_assembly.read(assembly).sliders) == 3


def test_a_tool_point_inside_a_part_is_found_by_its_name(doc):
    assembly = new_assembly(doc)
    head = assembly.newObject("App::Part", "Head")
    block(doc, "Casting", (15, 100, 600), parent=head)
    tcp = point(doc, "TCP", TIP, head)
    assembly, parts, _ = slider_machine(doc, assembly, {"Head": head})
    machine = from_assembly.machine_from_assembly(doc, assembly)
    assert machine.ToolPoint[0] == assembly and machine.ToolPoint[1] == ("Head.TCP.",) or \
        list(machine.ToolPoint[1]) == [f"Head.{tcp.Name}."]  # fmt: skip
    assert machine.Problem == "" and close(machine.FunctionalPoint, TIP)


def test_links_and_bodies_as_carriages(doc):
    unit = doc.addObject("App::Part", "Unit")
    block(doc, "UnitBlock", parent=unit)
    assembly = new_assembly(doc)
    saddle = assembly.newObject("App::Link", "Saddle")
    saddle.LinkedObject = unit
    saddle.Placement.Base = V(-60, -200, 100)
    table = assembly.newObject("PartDesign::Body", "Table")
    pad = table.newObject("PartDesign::AdditiveBox", "Pad")
    pad.Length = pad.Width = pad.Height = 20
    table.Placement.Base = V(30, -180, 200)
    assembly, parts, _ = slider_machine(doc, assembly, {"Saddle": saddle, "Table": table})
    machine = from_assembly.machine_from_assembly(doc, assembly, tool=parts["Head"], tool_point=parts["Head"])
    assert machine.Problem == "" and machine.Structure == "XYFZ"
    assert (named(machine, "Y"), named(machine, "X")) == (["Saddle"], ["Table"])
    saddle.Placement.Base += V(0, 11, 0)
    table.Placement.Base += V(0, 11, 0)
    doc.recompute()
    assert tree.axis_of(machine, "Y").Position.Value == pytest.approx(-11)


def test_a_reference_deep_inside_a_part_means_the_whole_part(doc):
    assembly = new_assembly(doc)
    head = assembly.newObject("App::Part", "Head")
    head.Placement.Base = V(15, 100, 0)
    block(doc, "Casting", (0, 0, 600), parent=head)
    sliders = {k: v for k, v in SLIDERS.items() if k != "Slider Z"}
    assembly, parts, _ = slider_machine(doc, assembly, {"Head": head}, sliders)
    join(assembly, "Slider", "Slider Z", parts["Bed"], head, (15, 100, 600), (0, 0, 1), ("", "Casting."))
    machine = from_assembly.machine_from_assembly(doc, assembly, tool=head, tool_point=head)
    assert named(machine, "Z") == ["Head"]
    assert close(tree.axis_of(machine, "Z").ReferencePoint, (15, 100, 600))


@pytest.mark.parametrize("kind", ["assembly", "link", "other document"])
def test_axes_inside_a_sub_assembly_count(doc, kind, tmp_path):
    """The cross table is an assembly of its own: bed, saddle and table; the machine joins its bed and the head."""
    where = App.newDocument("SensTestUnit") if kind == "other document" else doc
    try:
        assembly = new_assembly(doc)
        cross = new_assembly(where, "CrossTable", assembly if kind == "assembly" else None)
        parts = {n: block(where, n, at, parent=cross) for n, at in
                 (("Bed", (0, 0, -500)), ("Saddle", (-60, -200, 100)), ("Table", (30, -180, 200)))}  # fmt: skip
        where.recompute()
        ground(cross, parts["Bed"])
        for name in ("Slider Y", "Slider X"):
            one, other, origin, direction = SLIDERS[name]
            limit(join(cross, "Slider", name, parts[one], parts[other], origin, direction), -300, 300)
        unit = cross
        if kind != "assembly":
            if kind == "other document":
                where.saveAs(str(tmp_path / "unit.FCStd"))
                doc.saveAs(str(tmp_path / "machine.FCStd"))
            unit = assembly.newObject("App::Link", "Unit")
            unit.LinkedObject = cross
        head = block(doc, "Head", (15, 100, 600), parent=assembly)
        unit.Placement.Base = V(1000, 0, 0)
        head.Placement.Base += V(1000, 0, 0)
        doc.recompute()
        ground(assembly, unit)
        limit(join(assembly, "Slider", "Slider Z", unit, head, (1015, 100, 600), (0, 0, 1), ("Bed.", "")), -300, 300)
        doc.recompute()
        machine = from_assembly.machine_from_assembly(doc, assembly, tool=head, tool_point=head)
        assert machine.Problem == "" and machine.Structure == "XYFZ"
        assert {b: named(machine, b) for b in "FXYZ"} == {"F": ["Bed"], "X": ["Table"], "Y": ["Saddle"], "Z": ["Head"]}
        assert close(tree.axis_of(machine, "X").ReferencePoint, (1030, -180, 200))
        assert close(tree.axis_of(machine, "Z").ReferencePoint, (1015, 100, 600))
        parts["Table"].Placement.Base += V(13, 0, 0)
        where.recompute()
        doc.recompute()
        machine.touch()
        doc.recompute()
        assert tree.axis_of(machine, "X").Position.Value == pytest.approx(-13)
        assert close(tree.axis_of(machine, "X").ReferencePoint, (1030, -180, 200))
    finally:
        if where is not doc:
            App.closeDocument(where.Name)


def test_a_flexible_link_to_an_assembly_is_walked_and_a_rigid_one_refused_by_name(doc, tmp_path):
    where = App.newDocument("SensTestUnit")
    try:
        cross = new_assembly(where, "CrossTable")
        parts = {n: block(where, n, PLACES[n], parent=cross) for n in ("Bed", "Saddle", "Table")}
        where.recompute()
        ground(cross, parts["Bed"])
        for name in ("Slider Y", "Slider X"):
            one, other, origin, direction = SLIDERS[name]
            limit(join(cross, "Slider", name, parts[one], parts[other], origin, direction), -300, 300)
        where.saveAs(str(tmp_path / "unit.FCStd"))
        doc.saveAs(str(tmp_path / "machine.FCStd"))
        assembly = new_assembly(doc)
        unit = assembly.newObject("Assembly::AssemblyLink", "Unit")
        unit.LinkedObject = cross
        head = block(doc, "Head", PLACES["Head"], parent=assembly)
        doc.recompute()
        ground(assembly, unit)
        slider = join(assembly, "Slider", "Slider Z", unit, head, *SLIDERS["Slider Z"][2:])
        limit(slider, -300, 300)
        unit.Rigid = True
        doc.recompute()
        with pytest.raises(Refused, match="Unit.*rigid"):
            from_assembly.read(assembly)
        unit.Rigid = False
        doc.recompute()
        bed = next(o for o in unit.Group if o.Label.startswith("Bed"))
        if not any(hasattr(o, "ObjectToGround") for o in group_of(assembly).Group):  # 1.1 takes it away
            ground(assembly, bed)
        doc.removeObject(slider.Name)
        flexible = join(assembly, "Slider", "Slider Z", bed, head, *SLIDERS["Slider Z"][2:])
        limit(flexible, -300, 300)
        doc.recompute()
        machine = from_assembly.machine_from_assembly(doc, assembly, tool=head, tool_point=head)
        assert machine.Problem == "" and machine.Structure == "XYFZ"
        assert {b: named(machine, b) for b in "FXYZ"} == {"F": ["Bed"], "X": ["Table"], "Y": ["Saddle"], "Z": ["Head"]}
        assert close(tree.axis_of(machine, "X").ReferencePoint, PLACES["Table"])
    finally:
        App.closeDocument(where.Name)


def test_a_link_to_a_whole_assembly_is_read_where_the_link_stands(doc):
    assembly, parts, _ = slider_machine(doc)
    link = doc.addObject("App::Link", "Copy")
    link.LinkedObject = assembly
    link.Placement = TURNED
    doc.recompute()
    machine = from_assembly.machine_from_assembly(doc, link, tool=(link, "Head."), tool_point=(link, "Head."))
    assert machine.Problem == "" and machine.Structure == "XYFZ"
    axis = tree.axis_of(machine, "Y")
    assert close(axis.Direction, TURNED.Rotation.multVec(V(0, 1, 0)) * (1 if axis.Direction.y > 0 else -1), 1e-9)
    assert close(axis.ReferencePoint, TURNED.multVec(V(-60, -200, 100)), 1e-9)


def test_saved_and_opened_again_it_still_follows_its_joints(doc, made, tmp_path):
    machine = made[3]
    before = list(results.compute(machine).Total)
    path = str(tmp_path / "assembly.FCStd")
    doc.saveCopy(path)
    again = App.openDocument(path)
    try:
        machine = tree.machine_of(again)
        again.recompute()
        assert machine.Problem == "" and not tree.sensitivity_of(machine).Stale
        again.getObject("Head").Placement.Base += V(0, 0, 21)
        again.recompute()
        assert tree.axis_of(machine, "Z").Position.Value == pytest.approx(21)
        assert list(tree.sensitivity_of(machine).Total) == before
    finally:
        App.closeDocument(again.Name)


# -- refusals --------------------------------------------------------------------------------------------------------
def refused(doc, assembly, match):
    before = len(doc.Objects)
    with pytest.raises(Refused, match=match) as refusal:
        from_assembly.machine_from_assembly(doc, assembly)
    assert refusal.value.do
    assert len(doc.Objects) == before


def test_what_is_no_assembly_is_refused_by_name(doc):
    refused(doc, block(doc, "Anvil"), "Anvil")


def test_an_empty_or_ungrounded_assembly_is_refused(doc):
    assembly = new_assembly(doc, "Empty")
    refused(doc, assembly, "Empty")
    assembly, _, _ = slider_machine(doc)
    doc.removeObject(next(o.Name for o in group_of(assembly).Group if hasattr(o, "ObjectToGround")))
    refused(doc, assembly, "grounded")


def test_missing_and_surplus_sliders_are_named(doc):
    assembly, parts, joints = slider_machine(doc)
    extra = block(doc, "Shuttle", (0, 0, 0), parent=assembly)
    surplus = join(assembly, "Slider", "Slider of the shuttle", parts["Bed"], extra)
    refused(doc, assembly, "4 slider joints.*shuttle")
    switch_off(surplus)
    assert len(from_assembly.read(assembly).sliders) == 3
    switch_off(joints["Slider Y"])
    refused(doc, assembly, "2 slider joints.*Slider X")
    for joint in joints.values():
        switch_off(joint)
    refused(doc, assembly, "no slider joint")


def switch_off(joint):
    if hasattr(joint, "Suppressed"):
        joint.Suppressed = True
    else:
        joint.Activated = False


def test_a_loop_of_sliders_and_three_carriages_on_the_bed_are_refused(doc):
    loop = {**SLIDERS, "Slider Z": ("Bed", "Table", (30, -180, 200), (0, 0, 1))}
    assembly, parts, _ = slider_machine(doc, sliders=loop)
    refused(doc, assembly, "closes a loop")


def test_three_carriages_on_the_bed_are_refused(doc):
    fan = {k: ("Bed", *v[1:]) for k, v in SLIDERS.items()}
    assembly, _, _ = slider_machine(doc, sliders=fan)
    refused(doc, assembly, "three carriages")


def test_a_slider_that_is_switched_off_later_is_reported_by_name(made):
    _, _, joints, machine = made
    switch_off(joints["Slider Z"])
    machine.touch()
    machine.Document.recompute()
    assert "Slider Z" in machine.Problem and "switched off" in machine.Problem
