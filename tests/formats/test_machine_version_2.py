# SPDX-License-Identifier: LGPL-2.1-or-later
"""machine.json version 2: joints of both kinds; what is read is written as it was; version 1 is equal to before."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from sensworkbench.closedloop import predict
from sensworkbench.core import workspace
from sensworkbench.core.fitted import Constant, FittedModel, Series
from sensworkbench.core.refusal import Refused
from sensworkbench.core.synthesis import omega
from sensworkbench.formats import machine_json, readings_csv

EXAMPLES = Path(__file__).resolve().parents[2] / "resources" / "examples"


def data(name="trunnion") -> dict:
    return json.loads((EXAMPLES / f"{name}.json").read_text(encoding="utf-8"))


def read(changed: dict):
    return machine_json.loads(json.dumps(changed), "m.json")


@pytest.mark.parametrize("name", ["trunnion", "lathe", "rotary_table"])
def test_an_example_is_equal_to_itself_after_writing_and_reading(name):
    machine = machine_json.load(EXAMPLES / f"{name}.json")
    again = machine_json.loads(machine_json.dumps(machine))
    assert again == machine
    written = machine_json.to_dict(machine)
    assert written["version"] == 2 and written["joints"] == data(name)["joints"]


def test_degrees_of_the_file_are_radians_inside():
    a, c = machine_json.load(EXAMPLES / "trunnion.json").joints[3:]
    assert a.travel == pytest.approx((-2 * math.pi / 3, math.pi / 6)) and a.unit == "deg"
    assert c.travel is None and c.span == (-math.pi, math.pi)


def test_structure_and_order_of_positions_follow_the_file():
    machine = machine_json.load(EXAMPLES / "trunnion.json")
    assert machine.structure == "CAYFXZ" and machine.names == ("X", "Y", "Z", "A", "C")
    assert machine_json.load(EXAMPLES / "lathe.json").structure == "FZX"


@pytest.mark.parametrize("code", ["vertical_machining_centre"])
def test_a_version_1_machine_lifted_to_version_2_has_the_same_numbers(code):
    one = machine_json.load(EXAMPLES / f"{code}.json")
    two = machine_json.loads(machine_json.dumps(replace(one, version=2)))
    assert machine_json.to_dict(two)["version"] == 2
    assert replace(two, version=1) == one
    q = np.array([[10.0, -20.0, 30.0]])
    symbols = [c.symbol for c in one.components]
    assert np.array_equal(omega(one, symbols, q), omega(two, symbols, q))


def test_fitted_values_of_rotary_errors_carry_their_units():
    machine = machine_json.load(EXAMPLES / "trunnion.json")
    fitted = FittedModel(
        series={"EXC": Series((-180.0, 180.0), (0.0, 2e-3))},
        constants={"X0C": Constant(5e-3, 1e-4), "A0C": Constant(2e-5)},
    )
    text = machine_json.dumps(replace(machine, fitted=fitted))
    assert machine_json.loads(text).fitted == fitted
    shown = json.loads(text)["fitted"]
    assert (shown["X0C"]["value"], shown["X0C"]["unit"]) == (5.0, "um")
    assert shown["A0C"]["value"] == pytest.approx(20.0) and shown["A0C"]["unit"] == "urad"


def test_what_version_1_cannot_hold_is_written_as_version_2():
    machine = machine_json.load(EXAMPLES / "lathe.json")
    assert machine_json.to_dict(replace(machine, version=1))["version"] == 2


def without(d, *keys):
    return {k: v for k, v in d.items() if k not in keys}


def joint(number, **changes):
    d = data()
    d["joints"][number] |= changes
    return d


BAD = {
    "axes of version 1": (lambda: data() | {"axes": {}}, "axes: this key is not known"),
    "joints in version 1": (lambda: data() | {"version": 1}, "axes"),
    "another kind": (lambda: joint(3, kind="spherical"), "spherical"),
    "endless linear": (lambda: joint(0, travel=None), "joints[0].travel"),
    "a length for an angle": (lambda: joint(3, unit="mm"), "joints[3].unit"),
    "an angle for a length": (lambda: joint(0, unit="deg"), "joints[0].unit"),
    "a name that is taken": (lambda: joint(4, name="T"), "T the tool"),
    "one name twice": (lambda: joint(4, name="A"), "twice"),
    "a chain with a stranger": (lambda: data() | {"tool_chain": ["X", "Z", "B"]}, "'B'"),
    "a joint in no chain": (lambda: data() | {"tool_chain": ["X"]}, "Z is in neither chain"),
    "an error of no joint": (lambda: data() | {"tolerances": {"X0B": {"lower": 0, "upper": 1}}}, "tolerances.X0B"),
    "a squareness of the primary axis": (lambda: data() | {"declared": {"C0X": {"shape": "none"}}}, "declared.C0X"),
    "an angle limit of a position": (
        lambda: data() | {"tolerances": {"X0C": {"lower": 0, "upper": 1, "unit": "urad"}}},
        "tolerances.X0C.unit",
    ),
    "a frame of one axis": (lambda: data() | {"frame": {"primary": "X", "secondary": "X"}}, "frame"),
    "a boolean version": (lambda: data() | {"version": True}, "version"),
    "no joints": (lambda: data() | {"joints": [], "workpiece_chain": [], "tool_chain": []}, "0 axes"),
    "seven joints": (
        lambda: (
            data()
            | {
                "joints": [data()["joints"][0] | {"name": f"X{i}"} for i in range(7)],
                "workpiece_chain": [],
                "tool_chain": [f"X{i}" for i in range(7)],
                "tolerances": {},
            }
        ),
        "7 axes",
    ),
}


@pytest.mark.parametrize("case", BAD)
def test_bad_joints_are_refused_with_their_place(case):
    make, words = BAD[case]
    with pytest.raises(Refused) as refused:
        read(make())
    assert refused.value.message.startswith("m.json") and words in refused.value.message


def test_a_sensitivity_of_each_example_adds_up():
    for name in ("trunnion", "lathe", "rotary_table"):
        machine = machine_json.load(EXAMPLES / f"{name}.json")
        found = workspace.sensitivity(machine, workspace.quadrature(machine, 3), estimate=False)
        # exact: sum of first and total is 2 where nothing of higher than second order is
        assert np.sum(found.first + found.total) == pytest.approx(2.0, abs=1e-9)
        assert set(found.bodies) <= set(machine.bodies)


# -- places of n joints ------------------------------------------------------------------------------------------------
def positions(tmp_path, text, machine):
    path = tmp_path / "positions.csv"
    path.write_text(text, encoding="utf-8")
    return readings_csv.load_positions(path, joints=machine.joints)


def test_positions_of_five_joints_are_read_in_their_units(tmp_path):
    machine = machine_json.load(EXAMPLES / "trunnion.json")
    found = positions(tmp_path, "x_mm,y_mm,z_mm,a_deg,c_rad\n10,20,30,-90,1\n", machine)
    assert found.q == pytest.approx(np.array([[10, 20, 30, -math.pi / 2, 1]]))
    assert found.columns["a"][0] == pytest.approx(-90) and found.columns["c"][0] == pytest.approx(math.degrees(1))
    assert (found.units["a"], found.units["x"]) == ("deg", "mm")


@pytest.mark.parametrize("text", ["x_mm,y_mm,z_mm,a_deg\n1,2,3,4\n", "x_mm,y_mm,z_mm,a_deg,c_mm\n1,2,3,4,5\n"])
def test_a_joint_without_a_column_or_in_another_unit_is_refused(tmp_path, text):
    machine = machine_json.load(EXAMPLES / "trunnion.json")
    with pytest.raises(Refused) as refused:
        positions(tmp_path, text, machine)
    assert "c_" in refused.value.message and "positions.csv, line 1" in refused.value.where


def test_predicted_errors_of_a_five_axis_machine_are_omega_times_what_was_fitted(tmp_path):
    machine = machine_json.load(EXAMPLES / "trunnion.json")
    fitted = FittedModel(
        series={"EXC": Series((-180.0, 180.0), (0.0, 2e-3))}, constants={"X0C": Constant(5e-3), "A0C": Constant(2e-5)}
    )
    known = replace(machine, fitted=fitted)
    places = positions(tmp_path, "x_mm,y_mm,z_mm,a_deg,c_deg\n10,20,30,-60,90\n-100,0,50,10,-45\n", machine)
    values = np.array([[2e-3 * 90 / 180, 5e-3, 2e-5], [2e-3 * -45 / 180, 5e-3, 2e-5]])
    expected = np.einsum("pan,pn->pa", omega(machine, ["EXC", "X0C", "A0C"], places.q), values)
    assert predict.predict(known, places) == pytest.approx(expected, abs=1e-12)


# -- sources ---------------------------------------------------------------------------------------------------------
SOURCES = [
    {"name": "rail", "distribution": "uniform", "lower": -1, "upper": 1,
     "factors": {"EXX": {"value": 4.0, "unit": "um"}, "EAX": {"value": -0.3, "unit": "urad"}}},
    {"name": "room", "distribution": "normal", "sigma": 1.5, "factors": {"EYY": {"value": 1, "unit": "mm"}}},
]  # fmt: skip


def test_sources_are_read_in_mm_and_rad_and_written_as_they_were():
    machine = read(data() | {"sources": SOURCES})
    rail, room = machine.sources
    assert dict(rail.factors) == {"EXX": 4.0 * 1e-3, "EAX": -0.3 * 1e-6} and dict(room.factors) == {"EYY": 1.0}
    assert room.law.moments[1] == pytest.approx(1.5**2)
    assert machine_json.loads(machine_json.dumps(machine)) == machine
    assert machine_json.to_dict(machine)["sources"][0] == SOURCES[0]


@pytest.mark.parametrize(
    "change, place",
    [
        ({"factors": {}}, "sources"),
        ({"factors": {"EXQ": {"value": 1}}}, "sources[0].factors.EXQ"),
        ({"factors": {"EXX": {"value": 1, "unit": "urad"}}}, "sources[0].factors.EXX.unit"),
        ({"name": "room"}, "sources"),
        ({"lower": 2}, "sources[0]"),
        ({"upper": None}, "sources[0].upper"),
    ],
)
def test_bad_sources_are_refused_with_their_place(change, place):
    with pytest.raises(Refused) as refused:
        read(data() | {"sources": [SOURCES[0] | change, SOURCES[1]]})
    assert place in refused.value.where
