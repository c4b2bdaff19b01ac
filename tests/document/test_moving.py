# SPDX-License-Identifier: LGPL-2.1-or-later
"""Jogging moves a carriage and all that it carries, once, exactly, and can be undone."""

from __future__ import annotations

import json

import pytest

from sensworkbench.core.objectives import MeanSquare, Signed
from sensworkbench.core.refusal import Refused
from sensworkbench.document import extract, jog, objects, refresh, results, tree

from .blocks import REFERENCES, TURNED, P, R, V, block, close, golden_machine

MOVING = ("CarriageX", "CarriageY", "CarriageZ", "Spindle", "Part", "Tip", "RefX", "RefY", "RefZ", "Bed")


def stand(doc):
    return {name: P(doc.getObject(name).Placement) for name in MOVING}


def moved(doc, before):
    return {n: doc.getObject(n).Placement.Base - p.Base for n, p in before.items()}


def test_each_body_moves_with_its_chain_and_its_side(doc):
    machine = golden_machine(doc, "XYFZ")
    before = stand(doc)
    jog.jog(machine, {"X": 50, "Y": 20, "Z": -30})
    by = moved(doc, before)
    assert close(by["CarriageY"], (0, -20, 0))  # the saddle: workpiece side
    assert close(by["CarriageX"], (-50, -20, 0)) and close(by["Part"], (-50, -20, 0))
    assert close(by["CarriageZ"], (0, 0, -30)) and close(by["Spindle"], (0, 0, -30)) and close(by["Tip"], (0, 0, -30))
    assert close(by["Bed"], (0, 0, 0))
    assert close(by["RefX"], by["CarriageX"]) and close(by["RefY"], by["CarriageY"])


def test_home_is_computed_back_from_where_the_parts_stand(doc):
    machine = golden_machine(doc, "FXYZ")
    home = extract.core_machine(machine)
    jog.jog(machine, {"X": 123.4, "Y": -56.7, "Z": 8.9})
    doc.recompute()
    away = extract.core_machine(machine)
    assert close(away.tool_point, home.tool_point)
    for name in "XYZ":
        assert close(away.axes[name].reference, home.axes[name].reference)
    assert extract.current_position(machine).tolist() == [123.4, -56.7, 8.9]
    assert extract.core_machine(machine).structure == "FXYZ"


def test_a_hundred_jogs_end_exactly_where_they_began(doc):
    machine = golden_machine(doc, "YFXZ")
    doc.getObject("CarriageX").Placement.Rotation = R(V(0, 0, 1), 0.3)
    before = stand(doc)
    for i in range(100):
        jog.jog(machine, {"X": (i * 37.7) % 200 - 100, "Y": (i * 11.3) % 150, "Z": -(i * 3.1) % 99})
    jog.home(machine)
    for name, placement in before.items():
        assert doc.getObject(name).Placement.Base == placement.Base
        assert doc.getObject(name).Placement.Rotation.Q == placement.Rotation.Q
    assert list(machine.HomeObjects) == []


def test_a_part_moved_by_hand_while_away_from_home_keeps_its_new_place(doc):
    machine = golden_machine(doc, "FXYZ")
    jog.jog(machine, {"X": 50})
    doc.getObject("CarriageX").Placement.Base += V(0, 0, 7)
    doc.recompute()
    jog.home(machine)
    assert close(doc.getObject("CarriageX").Placement.Base, V(*REFERENCES["X"]) + V(0, 0, 7))


def test_parts_in_a_turned_container_move_along_the_machines_axes(doc):
    hall = doc.addObject("App::Part", "Hall")
    hall.Placement = TURNED
    machine = golden_machine(doc, "FXYZ", parent=hall)
    before = stand(doc)
    jog.jog(machine, {"Y": 40})
    by = moved(doc, before)
    assert close(by["CarriageY"], (0, 40, 0)) and close(by["CarriageX"], (0, 0, 0))  # in the hall's own coordinates
    assert close(hall.Placement.Base, TURNED.Base)


def test_a_carriage_nested_in_what_carries_it_is_moved_once(doc):
    machine = golden_machine(doc, "FXYZ")
    bridge = doc.addObject("App::Part", "Bridge")
    slide = doc.addObject("App::Part", "Slide")
    bridge.addObject(slide)
    slide.Placement.Rotation = R(V(0, 0, 1), 90)
    block(doc, "BridgeBlock", parent=bridge)
    block(doc, "SlideBlock", parent=slide)
    tree.axis_of(machine, "X").Parts = [(bridge, "")]
    y = tree.axis_of(machine, "Y")
    y.Parts, y.DirectionAlong = [(bridge, "Slide.")], "Local X"  # turned by 90 degrees
    doc.recompute()
    assert machine.Problem == ""
    jog.jog(machine, {"X": 10, "Y": 30})
    assert close(bridge.Placement.Base, (10, 0, 0))
    assert close(slide.Placement.Base, (0, 30, 0))  # in the bridge: its own 30 only


def test_writing_the_position_jogs_and_one_undo_brings_all_back(doc):
    machine = golden_machine(doc, "XYFZ")
    before = stand(doc)
    axis = tree.axis_of(machine, "Y")
    doc.openTransaction("Jog")
    axis.Position = 25
    doc.commitTransaction()
    assert close(moved(doc, before)["Part"], (0, -25, 0))
    doc.undo()
    doc.recompute()
    assert all(by.Length == 0 for by in moved(doc, before).values())
    assert axis.Position.Value == 0 and axis.StandsAt == 0 and machine.Problem == ""
    doc.redo()
    doc.recompute()
    assert close(moved(doc, before)["Part"], (0, -25, 0)) and axis.StandsAt == 25 and machine.Problem == ""


def test_a_position_outside_the_travel_is_put_back(doc):
    machine = golden_machine(doc)
    axis = tree.axis_of(machine, "X")
    axis.Position = 5000
    assert axis.Position.Value == 0 and close(doc.getObject("CarriageX").Placement.Base, REFERENCES["X"])
    with pytest.raises(Refused, match="outside the travel"):
        jog.jog(machine, {"X": 5000})


def _by_expression(doc):
    doc.getObject("CarriageX").setExpression("Placement.Base.x", "30 mm")
    return "expression"


def _attached(doc):
    carriage = doc.getObject("CarriageX")
    carriage.addExtension("Part::AttachExtensionPython") if not hasattr(carriage, "MapMode") else None
    support = "AttachmentSupport" if hasattr(carriage, "AttachmentSupport") else "Support"
    setattr(carriage, support, [(doc.getObject("Bed"), "Face6")])
    carriage.MapMode = "FlatFace"
    return "attached"


@pytest.mark.parametrize("drive", [_by_expression, _attached])
def test_parts_that_something_else_drives_are_refused_and_nothing_moves(doc, drive):
    machine = golden_machine(doc, "XYFZ")
    word = drive(doc)
    doc.recompute()
    before = stand(doc)
    with pytest.raises(Refused) as refusal:
        jog.jog(machine, {"X": 10, "Z": 10})
    assert word in refusal.value.message and "CarriageX" in refusal.value.message
    assert all(by.Length == 0 for by in moved(doc, before).values())
    jog.jog(machine, {"Z": 10})  # what does not concern it still moves
    assert close(moved(doc, before)["Spindle"], (0, 0, 10))


def test_a_part_inside_a_link_is_refused_because_every_copy_would_move(doc):
    machine = golden_machine(doc)
    unit = doc.addObject("App::Part", "Unit")
    block(doc, "UnitBlock", parent=unit)
    link = doc.addObject("App::Link", "UnitLink")
    link.LinkedObject = unit
    doc.recompute()
    tree.axis_of(machine, "X").Parts = [(link, "UnitBlock.")]
    doc.recompute()
    with pytest.raises(Refused, match="UnitLink"):
        jog.jog(machine, {"X": 10})


@pytest.mark.needs("assembly")
def test_parts_held_by_a_joint_are_refused(doc):
    import JointObject as joints
    import UtilsAssembly as utilities

    assembly = doc.addObject("Assembly::AssemblyObject", "Assembly")
    assembly.Type = "Assembly"
    group = assembly.newObject("Assembly::JointGroup", "Joints")
    machine = golden_machine(doc, parent=assembly)
    joint = group.newObject("App::FeaturePython", "SliderX")
    joints.Joint(joint, joints.JointTypes.index("Slider"))
    joint.Detach1 = joint.Detach2 = True
    carriages = [doc.getObject("CarriageY"), doc.getObject("CarriageX")]
    for i, carriage in enumerate(carriages, 1):
        newer = hasattr(utilities, "getComponentReference")
        reference = [carriage, ["", ""]] if newer else [assembly, [carriage.Name + "."] * 2]
        setattr(joint, f"Reference{i}", reference)
    doc.recompute()
    before = stand(doc)
    with pytest.raises(Refused) as refusal:
        jog.jog(machine, {"X": 10})
    assert "SliderX" in refusal.value.message and "CarriageX" in refusal.value.message
    assert all(by.Length == 0 for by in moved(doc, before).values())


def test_a_position_by_expression_is_reported_because_a_recompute_moves_nothing(doc):
    machine = golden_machine(doc)
    before = stand(doc)
    tree.axis_of(machine, "X").setExpression("Position", "40 mm")
    doc.recompute()
    doc.recompute()
    assert "Axis X" in machine.Problem and "40" in machine.Problem
    assert all(by.Length == 0 for by in moved(doc, before).values())


# -- recompute -------------------------------------------------------------------------------------------------------
@pytest.fixture
def executions(monkeypatch):
    count = []
    original = objects.MachineObject.execute

    def counted(self, obj):
        count.append(obj.Name)
        return original(self, obj)

    monkeypatch.setattr(objects.MachineObject, "execute", counted)
    return count


def test_one_change_is_one_execution_and_results_cause_none(doc, executions):
    machine = golden_machine(doc)
    results.compute(machine)
    doc.recompute()
    executions.clear()
    doc.recompute()
    assert executions == []
    doc.getObject("RefX").Placement.Base += V(1, 0, 0)
    doc.recompute()
    assert len(executions) == 1
    assert not [o.Name for o in doc.Objects if "Touched" in o.State]
    executions.clear()
    results.compute(machine)
    refresh.refresh(machine)
    doc.recompute()
    assert len(executions) <= 1  # the Sensitivity object alone touches nothing
    executions.clear()
    doc.recompute()
    assert executions == []


def test_jogging_does_not_make_the_result_stale(doc):
    machine = golden_machine(doc)
    found = results.compute(machine)
    jog.jog(machine, {"X": 77.7, "Y": -33.3, "Z": 11.1})
    doc.recompute()
    assert machine.Problem == "" and not found.Stale


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("Squareness", "carried"),
        ("Objective", json.dumps(MeanSquare(weights=(1, 0, 1)).to_json())),
        ("Order", 4),
        ("Objective", json.dumps(Signed().to_json())),
    ],
)
def test_every_setting_that_counts_makes_the_result_stale(doc, name, value):
    machine = golden_machine(doc)
    found = results.compute(machine)
    assert not found.Stale
    setattr(machine, name, value)
    doc.recompute()
    assert found.Stale
    results.compute(machine)
    assert not found.Stale
