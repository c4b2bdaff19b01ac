# SPDX-License-Identifier: LGPL-2.1-or-later
"""A machine file is read back equal, and whatever is wrong in one is refused with its line and path."""

from __future__ import annotations

import json
import random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensworkbench.core.distributions import Tolerance
from sensworkbench.core.effects import Effect
from sensworkbench.core.joints import linear
from sensworkbench.core.machine import Machine
from sensworkbench.core.refusal import Refused
from sensworkbench.core.shapes import Linear
from sensworkbench.formats import machine_json

from .support import ROOT, golden

UM, URAD, ARCSEC = 1e-3, 1e-6, 4.84813681109536e-06


def refusal(data) -> str:
    text = data if isinstance(data, str) else json.dumps(data, indent=1)
    with pytest.raises(Refused) as caught:
        machine_json.loads(text, "m.json")
    return caught.value.message


def test_what_is_missing_takes_the_default():
    machine = machine_json.loads(json.dumps(golden()))
    assert machine.structure == "FXYZ"
    assert machine.squareness == "direction"
    assert machine.spindle_reference is None and machine.workpiece_reference is None
    assert machine.all_tolerances["EXX"] == Tolerance(-1 * UM, 1 * UM)
    assert machine.declared_degree("EAX") == 3 and machine.declared_degree("C0Y") == 1


def test_tolerances_carry_their_unit():
    table = {
        "EXX": {"lower": -1, "upper": 3, "unit": "um", "distribution": "triangular"},
        "EAX": {"lower": -2, "upper": 2, "unit": "arcsec"},
        "E_C0Y": {"lower": -5, "upper": 5, "unit": "um/m"},
        "delta_xy": {"lower": 0, "upper": 0.001, "unit": "mm", "distribution": "normal", "sigma": 0.0002},
    }
    machine = machine_json.loads(json.dumps(golden(tolerances=table)))
    assert machine.tolerances["EXX"] == Tolerance(-1 * UM, 3 * UM, "triangular")
    assert machine.tolerances["EAX"].upper == pytest.approx(2 * ARCSEC, rel=1e-14)
    assert machine.tolerances["C0Y"].upper == pytest.approx(5 * URAD, rel=1e-14)
    assert machine.tolerances["EXY"].sigma == 0.0002


def test_declared_none_and_degree_nought_are_the_same():
    declared = {
        "EXX": {"shape": "none"},
        "EYX": {"shape": "polynomial", "degree": 0},
        "EZX": {"shape": "polynomial", "degree": 5},
        "C0Y": {"shape": "none"},
    }
    machine = machine_json.loads(json.dumps(golden(declared=declared)))
    assert [machine.declared_degree(s) for s in ("EXX", "EYX", "EZX", "C0Y", "A0Z")] == [0, 0, 5, 0, 1]


FITTED = {
    "EXX": {
        "basis": "legendre",
        "domain": [-300.0, 300.0],
        "coefficients": [1.5, -0.25, 0.125],
        "unit": "um",
        "u": [0.1, 0.1, None],
    },
    "C0Y": {"value": 12.5, "unit": "urad", "u": 0.4},
    "alignment": {"EXW": {"value": 3.25, "unit": "um", "u": None}, "ECW": {"value": -4.0, "unit": "urad", "u": 1.0}},
    "runs": {"1": [0.5, 0.0, -0.5], "=2": [0.0, 0.0, 0.0]},
    "covariance": "fit.npz",
}
EFFECTS = [
    {
        "name": "column bends",
        "component": "EAZ",
        "driver": "temp_column",
        "shape": "lag",
        "parameters": {
            "coefficient": {"value": 6.5, "unit": "urad/K", "u": 0.2},
            "tau": {"value": 1800.0, "unit": "s", "u": None},
            "extent": {"value": [-3.0, 12.0], "unit": "urad"},
        },
        "enabled": False,
    }
]


def test_fitted_errors_and_effects_are_read_in_mm_and_rad_and_written_as_they_stand():
    first = machine_json.loads(json.dumps(golden(fitted=FITTED, effects=EFFECTS, **{"x-shop": {"id": [1, None, "a"]}})))
    assert first.fitted.series["EXX"].coefficients == pytest.approx((1.5e-3, -0.25e-3, 0.125e-3), rel=1e-15)
    assert first.fitted.series["EXX"].u[2] is None
    assert first.fitted.constants["C0Y"].u == pytest.approx(0.4e-6)
    assert first.fitted.alignment["EXW"].value == pytest.approx(3.25e-3)
    assert first.fitted.runs["1"]["EZW"].value == pytest.approx(-0.5e-3)
    assert first.effects[0].shape.tau == 1800.0
    assert not first.effects[0].enabled
    assert first.extra == {"x-shop": {"id": [1, None, "a"]}}
    written = json.loads(machine_json.dumps(first))
    assert written["effects"] == EFFECTS and written["fitted"] == FITTED and written["x-shop"]["id"] == [1, None, "a"]
    assert machine_json.loads(machine_json.dumps(first)) == first


finite = st.floats(-2000, 2000, allow_nan=False).map(lambda v: 0.0 if abs(v) < 1e-9 else v)
triple = st.tuples(finite, finite, finite)


@st.composite
def machines(draw) -> Machine:
    code = draw(st.permutations(["X", "Y", "Z"]))
    split = draw(st.integers(0, 3))
    skew = st.floats(-0.04, 0.04)

    def direction(i):
        v = [draw(skew) for _ in range(3)]
        v[i] = 1.0
        length = sum(x * x for x in v) ** 0.5
        return tuple(x / length for x in v)

    axes = {}
    for i, name in enumerate("XYZ"):
        low = draw(finite)
        axes[name] = linear(name, direction(i), draw(triple), (low, low + draw(st.floats(0.1, 3000))))
    laws = st.sampled_from(["uniform", "normal", "truncated_normal", "triangular", "u_shaped", "point"])
    table = {}
    for symbol in draw(st.lists(st.sampled_from(["EXX", "EAX", "C0Y", "EXT", "ECW"]), unique=True)):
        low = draw(st.floats(-1e-2, 1e-2))
        law = draw(laws)
        sigma = draw(st.none() | st.floats(1e-6, 1e-3)) if "normal" in law else None
        table[symbol] = Tolerance(low, low + draw(st.floats(0, 1e-2)), law, sigma)
    return Machine(
        name=draw(st.text(max_size=12).filter(lambda t: not any("\ud800" <= c <= "\udfff" for c in t))),
        workpiece_chain=tuple(code[:split]),
        tool_chain=tuple(code[split:]),
        joints=axes,
        tool_point=draw(triple),
        spindle_reference=draw(st.none() | triple),
        workpiece_reference=draw(st.none() | triple),
        squareness=draw(st.sampled_from(["direction", "carried"])),
        tolerances=table,
        declared=draw(st.dictionaries(st.sampled_from(["EXX", "EBZ"]), st.integers(0, 9))),
        effects=(Effect("e", "EXX", "temp_a*x", Linear(), (draw(finite),)),),
        extra={"x-note": draw(st.none() | finite)},
    )


@settings(max_examples=150, deadline=None)
@given(machines())
def test_a_machine_written_and_read_again_is_equal(machine):
    again = machine_json.loads(machine_json.dumps(machine))
    assert again == machine
    assert machine_json.dumps(again) == machine_json.dumps(machine)


def test_directions_keep_their_last_bit():
    rng = random.Random(3)
    for _ in range(500):
        u = [1.0, rng.uniform(-0.05, 0.05), rng.uniform(-0.05, 0.05)]
        length = sum(v * v for v in u) ** 0.5
        machine = machine_json.loads(json.dumps(golden(axes__X__direction=[v / length for v in u])))
        assert machine_json.loads(machine_json.dumps(machine)) == machine


def test_saving_replaces_the_file_in_one_step_and_leaves_nothing_else(tmp_path):
    machine = machine_json.loads(json.dumps(golden()))
    target = tmp_path / "m.json"
    target.write_text("old")
    machine_json.save(machine, target)
    assert machine_json.load(target) == machine
    assert [p.name for p in tmp_path.iterdir()] == ["m.json"]


def test_the_example_machines_are_readable():
    examples = sorted((ROOT / "resources" / "examples").glob("*.json"))
    assert {machine_json.load(p).structure for p in examples} >= {"FXYZ", "XYFZ", "YFXZ"}


BAD = {
    "not JSON at all": ("hello", ["m.json, line 1"]),
    "nothing": ("  \n", ["m.json", "empty"]),
    "a list": ("[]", ["line 1", "not a machine"]),
    "another format": (golden(format="other"), ["sens-machine"]),
    "another version": (golden(version=3), ["version 3", "line 3"]),
    "an unknown key": (golden(tool_pont=[0, 0, 0]), ["tool_pont", "line"]),
    "an unknown key deep inside": (golden(axes__X__refrence=[0, 0, 0]), ["axes.X.refrence", "line"]),
    "an x- key inside a table of errors": (golden(tolerances={"x-a": 1}), ["tolerances.x-a"]),
    "NaN": (json.dumps(golden(tool_point=[0, float("nan"), 0])), ["tool_point[1]", "NaN", "finite"]),
    "Infinity": (json.dumps(golden(axes__X__travel=[0, float("inf")])), ["axes.X.travel[1]", "Infinity"]),
    "minus Infinity": (json.dumps(golden(axes__X__travel=[-float("inf"), 0])), ["axes.X.travel[0]", "-Infinity"]),
    "1e999": (json.dumps(golden()).replace("-150", "1e999"), ["tool_point[2]", "range"]),
    "a number of a thousand digits": (json.dumps(golden()).replace("-150", "9" * 1000), ["tool_point[2]", "digits"]),
    "a truth value for a number": (golden(tool_point=[True, 0, 0]), ["tool_point[0]", "true"]),
    "a text for a number": (golden(tool_point=["1", 0, 0]), ["tool_point[0]"]),
    "two numbers for a point": (golden(tool_point=[0, 0]), ["tool_point", "3"]),
    "an unknown symbol": (golden(tolerances={"EQX": {"lower": 0, "upper": 1}}), ["tolerances.EQX", "EQX"]),
    "the same error twice": (
        golden(tolerances={"C0Y": {"lower": 0, "upper": 1}, "E_C0Y": {"lower": 0, "upper": 1}}),
        ["tolerances.E_C0Y", "same error"],
    ),
    "an unknown unit": (
        golden(tolerances={"EXX": {"lower": 0, "upper": 1, "unit": "parsec"}}),
        ["tolerances.EXX.unit", "parsec"],
    ),
    "an angle in um": (
        golden(tolerances={"EAX": {"lower": 0, "upper": 1, "unit": "um"}}),
        ["tolerances.EAX.unit", "angle"],
    ),
    "upper below lower": (
        golden(tolerances={"EXX": {"lower": 2, "upper": 1, "unit": "um"}}),
        ["tolerances.EXX.upper", "below", "line"],
    ),
    "an unknown distribution": (
        golden(tolerances={"EXX": {"lower": 0, "upper": 1, "distribution": "cauchy"}}),
        ["tolerances.EXX.distribution", "cauchy"],
    ),
    "a limit missing": (golden(tolerances={"EXX": {"lower": 0}}), ["tolerances.EXX", "upper"]),
    "travel of zero length": (golden(axes__Y__travel=[5, 5]), ["axes.Y.travel", "no length", "line"]),
    "travel the wrong way round": (golden(axes__Y__travel=[5, -5]), ["axes.Y.travel"]),
    "a direction that is no unit vector": (golden(axes__Z__direction=[0, 0, 2]), ["axes.Z.direction", "length 2"]),
    "a direction of nought": (golden(axes__Z__direction=[0, 0, 0]), ["axes.Z.direction", "length 0"]),
    "parallel axes": (golden(axes__Y__direction=[1, 0, 0]), ["X", "Y", "parallel"]),
    "axes six degrees from square": (
        golden(axes__Y__direction=[0.10452846326765346, 0.9945218953682733, 0]),
        ["X", "Y", "84.00"],
    ),
    "a carriage in both chains": (golden(workpiece_chain=["X"]), ["chain", "X", "twice"]),
    "a carriage in no chain": (golden(tool_chain=["X", "Y"]), ["Z", "chain"]),
    "an unknown axis in a chain": (golden(tool_chain=["X", "Y", "A"]), ["tool_chain[2]", '"A"']),
    "a missing axis": ({**golden(), "axes": {}}, ["axes", '"X" is missing']),
    "no tool point": ({k: v for k, v in golden().items() if k != "tool_point"}, ['"tool_point" is missing']),
    "an unknown convention": (golden(squareness="skewed"), ["squareness", "skewed"]),
    "a degree that is no number": (
        golden(declared={"EXX": {"shape": "polynomial", "degree": 2.5}}),
        ["declared.EXX.degree"],
    ),
    "a declared shape nobody knows": (golden(declared={"EXX": {"shape": "spline"}}), ["declared.EXX.shape", "spline"]),
    "a declared spindle error": (golden(declared={"EXT": {"shape": "polynomial"}}), ["declared.EXT"]),
    "a path for a covariance": (golden(fitted={"covariance": "../../x.npz"}), ["fitted.covariance", "npz"]),
    "a pickle for a covariance": (golden(fitted={"covariance": "x.pkl"}), ["fitted.covariance"]),
    "fitted without a domain": (
        golden(fitted={"EXX": {"basis": "legendre", "domain": [1, 1], "coefficients": [1], "unit": "um"}}),
        ["fitted.EXX.domain"],
    ),
    "fitted without coefficients": (
        golden(fitted={"EXX": {"basis": "legendre", "domain": [0, 1], "coefficients": [], "unit": "um"}}),
        ["fitted.EXX.coefficients"],
    ),
    "a list for squareness": (golden(fitted={"C0Y": {"value": [1, 2]}}), ["fitted.C0Y.value"]),
    "an angle for a shift": (
        golden(fitted={"alignment": {"EXW": {"value": 1, "unit": "urad"}}}),
        ["fitted.alignment.EXW.unit"],
    ),
    "ranges that are none": (golden(fitted={"x-ranges": 5}), ["fitted.x-ranges"]),
    "a range of text": (golden(fitted={"x-ranges": {"x": "ab"}}), ["fitted.x-ranges.x"]),
    "a range without an end": (golden(fitted={"x-ranges": {"x": [1]}}), ["fitted.x-ranges.x"]),
    "a range turned round": (golden(fitted={"x-ranges": {"x": [2, 1]}}), ["fitted.x-ranges.x", "2"]),
    "tools that are none": (golden(fitted={"x-tools": 5}), ["fitted.x-tools"]),
    "a tool without its error": (golden(fitted={"x-tools": [{"offset_mm": [0, 0, 1]}]}), ["fitted.x-tools[0]"]),
    "a run of text": (golden(fitted={"runs": {"1": "a"}}), ["fitted.runs.1"]),
    "uncertainties that do not match": (
        golden(fitted={"EXX": {"basis": "legendre", "domain": [0, 1], "coefficients": [1], "unit": "um", "u": [1, 1]}}),
        ["fitted.EXX.u"],
    ),
    "an effect of no shape": (golden(effects=[{**EFFECTS[0], "shape": "magic"}]), ["effects[0].shape", "magic"]),
    "an effect on no component": (golden(effects=[{**EFFECTS[0], "component": "E"}]), ["effects[0].component"]),
    "an effect with no driver": (golden(effects=[{**EFFECTS[0], "driver": "a**b"}]), ["effects[0].driver"]),
    "two effects of one name": (golden(effects=EFFECTS * 2), ["effects[1].name"]),
    "an effect's parameter that is a text": (
        golden(effects=[{**EFFECTS[0], "parameters": {"tau": {"value": "1"}}}]),
        ["effects[0].parameters.tau.value"],
    ),
    "a key twice": ('{"format": "sens-machine",\n"format": "sens-machine"}', ["line 2", "format", "twice", "line 1"]),
    "nesting without end": ("[" * 100_000, ["nested"]),
    "half a character": ('{"format": "sens-machine", "name": "\\ud800"}', ["name", "character"]),
    "text behind the end": (json.dumps(golden()) + "x", ["after the end"]),
    "a line end in a text": ('{"format": "a\nb"}', ["line 1"]),
}


@pytest.mark.parametrize("case", BAD, ids=list(BAD))
def test_bad_input_is_refused_with_its_place(case):
    data, words = BAD[case]
    message = refusal(data)
    assert message.startswith("m.json")
    for word in words:
        assert word in message


def test_the_line_is_that_of_the_entry():
    text = json.dumps(golden(tolerances={"EXX": {"lower": 2, "upper": 1, "unit": "um"}}), indent=1)
    line = next(n for n, words in enumerate(text.splitlines(), start=1) if '"upper"' in words)
    assert f"m.json, line {line}, tolerances.EXX.upper" in refusal(text)


def test_spoiled_files_never_end_in_anything_but_a_refusal():
    rng = random.Random(7)
    text = json.dumps(golden(fitted=FITTED, effects=EFFECTS, declared={"EXX": {"shape": "none"}}))
    pieces = ['"', "{", "}", "[", "]", ",", ":", "null", "NaN", "-", "1e400", '"\\u0000"', "true", "é", "\\", "0"]
    refused = 0
    for _ in range(1500):
        at = rng.randrange(len(text))
        spoiled = text[:at] + rng.choice(pieces) + text[at + rng.randrange(4) :]
        try:
            machine_json.loads(spoiled, "m.json")
        except Refused as error:
            refused += 1
            assert error.message.startswith("m.json")
    assert refused > 1000


def test_unreadable_files_are_refused(tmp_path):
    (tmp_path / "latin.json").write_bytes(b'{\n"name": "\xe9"}')
    (tmp_path / "huge.json").write_bytes(b" " * (17 * 2**20))
    for name, word in (("none.json", "no such file"), (".", "folder"), ("latin.json", "line 2"), ("huge.json", "MiB")):
        with pytest.raises(Refused, match=word):
            machine_json.load(tmp_path / name)
