# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machines of one or two axes and of other names: surveyed, judged, jogged and saved as those of X, Y and Z are."""

from __future__ import annotations

import json
import math

import FreeCAD as App
import numpy as np
import pytest

from sensworkbench.core import workspace
from sensworkbench.core.distributions import Tolerance
from sensworkbench.core.effects import Effect
from sensworkbench.core.joints import linear
from sensworkbench.core.machine import Machine
from sensworkbench.core.shapes import SHAPES
from sensworkbench.document import base, extract, factory, jog, kinematics, refresh, repair, results, tables, tree
from sensworkbench.messages import Refused

from .blocks import V, block, close, golden_machine, point

POINTS = {"Z": (0, -200, 50), "X": (120, -150, 90)}


def lathe_of(doc, names=("Z", "X")):
    """A lathe: the spindle with the workpiece on the bed, the turret on two slides, the second on the first."""
    first, second = names
    machine = factory.make_machine(
        doc, [], [first, second], bed=[block(doc, "Bed", (0, 0, -300))], tool_point=point(doc, "Tip", (40, 0, 10)),
        label="Lathe",
    )  # fmt: skip
    for name, at, along in ((first, POINTS["Z"], "Local Z"), (second, POINTS["X"], "Local X")):
        carriage = block(doc, f"Slide{name}", at)
        factory.make_axis(
            machine, name, [carriage], travel=(-100, 200), along=along, reference=point(doc, f"Ref{name}", at)
        )
    factory.make_body(machine, "T", [block(doc, "Turret", (40, 0, 0))])
    factory.make_body(machine, "W", [block(doc, "Chuck", (0, 0, -50))])
    doc.recompute()
    return machine


@pytest.fixture
def lathe(doc):
    return lathe_of(doc)


def described(machine, **more):
    """The same lathe, written down for the core."""
    found = extract.core_machine(machine)
    joints = (linear("X", (1, 0, 0), POINTS["X"], (-100, 200)), linear("Z", (0, 0, 1), POINTS["Z"], (-100, 200)))
    ends = {"spindle_reference": found.spindle_reference, "workpiece_reference": found.workpiece_reference}
    return Machine("Lathe", (), ("Z", "X"), joints, (40.0, 0.0, 10.0), **ends, **more)


def test_a_lathe_is_surveyed_by_its_own_axes(lathe):
    core = extract.core_machine(lathe)
    assert lathe.Problem == "" and lathe.Structure == "FZX" and core.names == ("X", "Z")
    assert core == described(lathe)
    assert close(tree.axis_of(lathe, "X").AbbeOffset, V(40, 0, 10) - V(*POINTS["X"]))
    assert dict(lathe.Skew) == {"XZ": "0.0"}


def test_the_indices_of_a_lathe_are_those_of_the_core(lathe):
    found = results.compute(lathe)
    expected = workspace.sensitivity(described(lathe))
    assert list(found.Symbols) == list(expected.symbols) and "EXY" not in found.Symbols
    np.testing.assert_allclose(found.Total, expected.total, rtol=1e-12)
    np.testing.assert_allclose(results.load(lathe, found).component_total, expected.component_total, rtol=1e-12)
    assert list(found.Points) == [8, 8] and not found.Stale
    lathe.Aggregate, lathe.At = "at", [50.0, 120.0]
    at = results.compute(lathe)
    expected = workspace.sensitivity(described(lathe), workspace.at(described(lathe), [50.0, 120.0]))
    np.testing.assert_allclose(at.Total, expected.total, rtol=1e-12)
    lathe.At = [50.0, 120.0, 0.0]
    with pytest.raises(Refused) as refusal:
        results.compute(lathe)
    assert refusal.value.code == "position-count-wrong" and refusal.value.fields["names"] == ["X", "Z"]


def test_tolerances_of_a_lathe_are_its_own(lathe):
    own = {c.symbol for c in extract.core_machine(lathe).components}
    assert extract.core_machine(lathe).all_tolerances == described(lathe).all_tolerances
    factory.set_tolerances(lathe, {"EXX": Tolerance(-0.004, 0.004)}, {"EAZ": "arcsec"})
    table = tree.tolerances_of(lathe)
    assert set(table.Symbols) <= own and "EXX" in table.Symbols
    assert extract.core_machine(lathe).all_tolerances["EXX"].upper == 0.004
    assert tables.read_units(lathe)["EAZ"] == "arcsec"
    with pytest.raises(Refused):
        factory.set_tolerances(lathe, {"EXY": Tolerance(-0.004, 0.004)})
    assert repair.examine(lathe.Document) == []


def test_rows_for_an_axis_that_a_machine_has_not_are_left_out(lathe):
    tables.write_tolerances(tree.tolerances_of(lathe), {"EXY": Tolerance(-1.0, 1.0), "EXX": Tolerance(-2e-3, 2e-3)})
    found = extract.core_machine(lathe).tolerances
    assert "EXY" not in found and found["EXX"].upper == 2e-3


def test_a_lathe_is_jogged(lathe):
    doc = lathe.Document
    before = extract.core_machine(lathe)
    assert jog.jog(lathe, {"Z": 60.0}) == {"X": 0.0, "Z": 60.0}
    assert jog.jog(lathe, {"X": -25.5}) == {"X": -25.5, "Z": 60.0}
    doc.recompute()
    assert close(doc.getObject("SlideX").Placement.Base, V(*POINTS["X"]) + V(-25.5, 0, 60))
    assert close(doc.getObject("Chuck").Placement.Base, (0, 0, -50))
    assert lathe.Problem == "" and extract.core_machine(lathe) == before
    tree.axis_of(lathe, "Z").Position = 0.0
    jog.home(lathe)
    assert close(doc.getObject("SlideX").Placement.Base, POINTS["X"], 0.0)
    with pytest.raises(Refused) as refusal:
        jog.jog(lathe, {"Y": 1.0})
    assert refusal.value.code == "jog-axis-unknown" and refusal.value.fields["known"] == ["X", "Z"]
    with pytest.raises(Refused) as refusal:
        jog.jog(lathe, {"X": 201.0})
    assert (refusal.value.code, refusal.value.fields["high"]) == ("jog-outside-travel", 200.0)


def test_a_lathe_is_there_again_after_saving(lathe, tmp_path):
    jog.jog(lathe, {"Z": 60.0})
    lathe.Document.recompute()
    core, total = extract.core_machine(lathe), list(results.compute(lathe).Total)
    path = tmp_path / "lathe.FCStd"
    lathe.Document.saveCopy(str(path))
    opened = App.openDocument(str(path))
    try:
        machine = tree.machine_of(opened)
        assert extract.core_machine(machine) == core
        found = tree.sensitivity_of(machine)
        assert list(found.Total) == total and not found.Stale
        jog.home(machine)
        assert close(opened.getObject("SlideX").Placement.Base, POINTS["X"])
    finally:
        App.closeDocument(opened.Name)


def test_axes_may_have_other_names_and_stand_in_any_order(doc):
    machine = lathe_of(doc, ("V", "W1"))
    assert machine.Problem == "" and machine.Structure == "FVW1"
    assert extract.core_machine(machine).names == ("V", "W1")
    found = results.compute(machine)
    assert {"EXV", "EAW1"} <= set(found.Symbols) and set(found.Bodies) == {"V", "W1", "T"}
    for name in ("T", "x", "X12", ""):
        with pytest.raises(Refused):
            factory.make_axis(machine, name)


def test_one_axis_is_a_machine(doc):
    machine = factory.make_machine(doc, ["X"], [], bed=[block(doc, "Bed")], tool_point=point(doc, "Tip", (0, 0, 100)))
    factory.make_axis(machine, "X", [block(doc, "Table", (0, 0, 30))], travel=(0, 400))
    doc.recompute()
    assert machine.Problem == "" and machine.Structure == "XF"
    found = results.compute(machine)
    assert set(found.Bodies) == {"X", "T"} and list(found.Points) == [8]
    jog.jog(machine, {"X": 10.0})
    assert close(doc.getObject("Table").Placement.Base, (-10, 0, 30))


def test_a_problem_is_said_in_the_language_that_is_asked_for(lathe):
    lathe.ToolPoint = None
    lathe.Document.recompute()
    assert refresh.problem_text(lathe) == lathe.Problem != ""
    assert "Werkzeugpunkt" in refresh.problem_text(lathe, "de")
    lathe.ToolPoint = (lathe.Document.getObject("Tip"), [""])
    lathe.Document.recompute()
    assert refresh.problem_text(lathe, "de") == lathe.Problem == ""


def test_a_rotary_axis_is_refused_by_name_until_documents_hold_them(lathe):
    tree.axis_of(lathe, "X").Kind = "rotary"
    with pytest.raises(Refused) as refusal:
        extract.core_machine(lathe)
    assert refusal.value.code == "axis-kind-not-in-documents" and refusal.value.fields["axis"] == "Axis X"


# -- effects without a range ------------------------------------------------------------------------------------------
def test_an_enabled_effect_without_extent_is_listed_and_ranked_once_it_has_one(doc, tmp_path):
    machine = golden_machine(doc)
    effect = Effect("column tilts", "EAZ", "temp_column", SHAPES["linear"](), (2.5e-6,))
    made = factory.make_effect(machine, effect)
    doc.recompute()
    found = results.compute(machine)
    assert list(found.WithoutExtent) == ["column tilts"] and "column tilts" not in found.Symbols
    assert results.load(machine, found).without_extent == ("column tilts",)
    made.Extent = [-2.0, 4.0]
    doc.recompute()
    assert found.Stale
    found = results.compute(machine)
    row = list(found.Symbols).index("column tilts")
    assert not found.WithoutExtent and (found.Lower[row], found.Upper[row]) == pytest.approx((-5e-6, 10e-6))
    again = extract.core_machine(machine).effects[0]
    assert again.extent == (-2.0, 4.0) and again.coefficients == pytest.approx((2.5e-6,))
    made.Extent = [1.0]
    assert refused(machine).code == "effect-extent-count"


# -- what is no number ------------------------------------------------------------------------------------------------
def refused(machine):
    with pytest.raises(Refused) as refusal:
        results.compute(machine)
    return refusal.value


@pytest.mark.parametrize("value", [1e308, -1e308, math.inf, math.nan])
@pytest.mark.parametrize("spoil", ["Objective", "ReferenceOffset", "StandsAt", "TravelUpper"])
def test_indices_that_are_no_numbers_are_refused_with_their_place_and_never_stored(doc, spoil, value):
    machine = golden_machine(doc)
    stored = list(results.compute(machine).Total)
    axis = tree.axis_of(machine, "Z")
    if spoil == "Objective":
        machine.Objective = json.dumps({"name": "mean_square", "weights": [value, 1, 1]})
    elif spoil == "ReferenceOffset":
        axis.ReferenceOffset = V(value, 0, 0)
    else:
        setattr(axis, spoil, value)
    found = refused(machine)
    assert ("Golden" if spoil == "Objective" else "Axis Z") in found.where
    assert list(tree.sensitivity_of(machine).Total) == stored
    assert np.all(np.isfinite(tree.sensitivity_of(machine).Total))


def test_an_offset_that_is_no_number_is_a_finding(doc):
    machine = golden_machine(doc)
    axis = tree.axis_of(machine, "Z")
    axis.ReferenceOffset = V(math.nan, 0, 0)
    doc.recompute()
    assert "ReferenceOffset" in machine.Problem
    assert [(p.obj, p.refusal.code) for p in repair.examine(doc)] == [(axis, "problem-number-not-finite")]


@pytest.mark.parametrize("kind", ["Machine", "Axis", "Tolerances", "Sensitivity"])
def test_an_object_of_a_newer_schema_is_refused_by_name(doc, kind):
    machine = golden_machine(doc)
    results.compute(machine)
    obj = machine if kind == "Machine" else base.members(machine, kind)[0]
    obj.SchemaVersion = 999
    found = refused(machine)
    assert (found.code, found.fields["name"], found.fields["found"]) == ("document-newer-schema", obj.Label, 999)
    assert (obj, "problem-newer-schema") in [(p.obj, p.refusal.code) for p in repair.examine(doc)]
    obj.Proxy.onDocumentRestored(obj)
    assert obj.SchemaVersion == 999  # opening changes nothing


# -- one survey for a change ------------------------------------------------------------------------------------------
def test_a_change_is_surveyed_once(doc, monkeypatch):
    machine = golden_machine(doc)
    results.compute(machine)
    calls = []
    real = extract.survey
    monkeypatch.setattr(refresh, "survey", lambda m: calls.append(m) or real(m))
    tree.axis_of(machine, "Z").ReferenceOffset = V(0, 0, 25)
    doc.recompute()
    found = results.compute_at_once(machine, 10_000)
    assert len(calls) == 1 and not found.Stale
    assert list(found.Total) == list(results.compute(machine, estimate=False).Total)
    doc.recompute()
    assert refresh.latest(machine) is refresh.latest(machine)
    doc.getObject("RefZ").Placement = App.Placement(V(15, 100, 700), App.Rotation())
    moved = refresh.latest(machine)  # not recomputed yet: what was seen before does not count
    assert moved.core.joint("Z").point[2] == pytest.approx(725)


# -- placements ------------------------------------------------------------------------------------------------------
def test_displacements_are_those_of_the_core_also_where_a_joint_turns():
    """A trunnion: lever arms in the axes of the file are tool point minus reference point, both displaced."""
    from sensworkbench.core.joints import rotary

    joints = (
        linear("X", (1, 0, 0), (30, -180, 200), (-300, 300)),
        linear("Z", (0, 0, 1), (15, 100, 600), (-300, 300)),
        rotary("A", (1, 0, 0), (0, 0, -80)),
        rotary("C", (0, 0, 1), (5, 6, 0)),
    )
    core = Machine("t", ("X", "A", "C"), ("Z",), joints, (10, -20, -150), workpiece_reference=(1, 2, 3))
    q = {"X": 40.0, "Z": -25.0, "A": 0.6, "C": -1.1}
    where = kinematics.of_machine(core, q)
    arms = core.lever_arms([[q[n] for n in core.names]], frame="file")
    for body in (*core.names, "T", "W"):
        home = {"T": core.tool_point, "W": core.workpiece_reference}.get(body) or core.joint(body).point
        assert close(where["T"].multVec(V(*core.tool_point)) - where[body].multVec(V(*home)), arms[body][0], 1e-9)
    frame = App.Placement(V(3, 4, 5), App.Rotation(V(1, 1, 0), 30))
    for motion in (where["C"], where["T"]):
        part = App.Placement(V(7, 8, 9), App.Rotation(V(0, 1, 0), 20))
        seen = kinematics.seen_from(motion, frame)
        assert close((frame * kinematics.moved(seen, part)).Base, (motion * frame * part).Base)
        assert close(kinematics.moved_back(motion, kinematics.moved(motion, part)).Base, part.Base)
        assert kinematics.is_still(kinematics.relative_to_now(where["F"], where["F"]))
