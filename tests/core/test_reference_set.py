# SPDX-License-Identifier: LGPL-2.1-or-later
"""resources/reference: our numbers beside those computed with 60 digits by code that shares nothing with the package.

Also held here: the reference's own indices against a plain enumeration, and its files against their schemas.
"""

from __future__ import annotations

import ast
import copy
import itertools
import json
import sys
from dataclasses import replace

import pytest
from jsonschema import Draft202012Validator

from sensworkbench.formats import machine_json
from tests.formats.support import ROOT

sys.path.insert(0, str(ROOT / "tools"))

import reference_answers
import score_reference

FOLDER = ROOT / "resources" / "reference"
REFERENCES = score_reference.references()


@pytest.fixture(scope="module")
def ours() -> dict:
    return reference_answers.answers(FOLDER)


def test_there_are_sixty_machines_of_all_sorts():
    machines = [json.loads((FOLDER / name).read_text(encoding="utf-8")) for name in REFERENCES]
    assert len(machines) == 60
    codes = {"".join(reversed(m["workpiece_chain"])) + "F" + "".join(m["tool_chain"]) for m in machines}
    three = {"".join(o[:k]) + "F" + "".join(o[k:]) for o in itertools.permutations("XYZ") for k in range(4)}
    assert three <= codes
    laws = {t["distribution"] for m in machines for t in m["tolerances"].values()}
    assert laws == {"uniform", "normal", "truncated_normal", "triangular", "u_shaped", "point"}
    joints = [m.get("joints", []) for m in machines]
    assert sum(sum(j["kind"] == "rotary" for j in each) == 2 for each in joints) >= 10
    assert {m["squareness"] for m in machines} == {"direction", "carried"}
    assert sum(p.stat().st_size for p in FOLDER.iterdir()) < 2_000_000


def test_the_set_holds_sources_effects_endless_joints_and_left_handed_machines():
    machines = [machine_json.load(FOLDER / name) for name in REFERENCES]
    assert sum(any(j.travel is None for j in m.joints) for m in machines) >= 4
    assert sum(m.left_handed for m in machines) >= 2
    assert sum(len(m.sources) for m in machines) >= 10
    shapes = {e.shape.name for m in machines for e in m.effects if e.enabled and e.range is not None}
    assert shapes == {"linear", "reversal", "approach", "power", "step", "periodic", "lag"}
    for name, machine in zip(REFERENCES, machines):
        ranked = {e.name for e in machine.effects if e.enabled and e.range is not None}
        named = {*ranked, *(s.name for s in machine.sources)}
        assert set(REFERENCES[name]["inputs"]) == {*machine.all_tolerances, *named}
        for case in REFERENCES[name]["cases"]:
            assert named <= set(case["errors"])
    single = [s for m in machines for s in m.sources if len({m.component(c).body for c in s.factors}) == 1]
    assert 0 < len(single) < sum(len(m.sources) for m in machines)  # of one body, and of several


@pytest.mark.parametrize(
    ("name", "change"), [("54", {"sources": ()}), ("57", {"effects": ()}), ("60", {"sources": ()})]
)
def test_a_program_without_sources_or_effects_is_outside(name, change):
    name += ".machine.json"
    machine = replace(machine_json.load(FOLDER / name), **change)
    found = score_reference.score({name: reference_answers.answer(machine, REFERENCES[name])})[name]
    assert found["indices"].outside > 10
    assert found["indices"].missing > 0


@pytest.mark.parametrize("name", REFERENCES)
def test_every_number_is_within_the_tolerance(ours, name):
    found = score_reference.score(ours)[name]
    assert set(found) == {"indices", "moments", "errors"}
    assert all((s.missing, s.outside) == (0, 0) for s in found.values()), found


def test_a_number_that_is_off_or_missing_is_counted(ours):
    wrong = copy.deepcopy(ours)
    errors = wrong["07.machine.json"]["cases"][0]["errors"]
    largest = max(errors, key=lambda s: errors[s]["total"])
    errors[largest]["total"] *= 1 + 3e-12
    del wrong["08.machine.json"]["volumetric"][0]["error_um"]
    wrong["09.machine.json"]["cases"][1]["mean"] = float("nan")
    found = score_reference.score(wrong)
    assert found["07.machine.json"]["indices"].outside == 1
    assert found["07.machine.json"]["indices"].where == f"cases.0.errors.{largest}.total"
    assert found["08.machine.json"]["errors"].missing == 3
    assert found["09.machine.json"]["moments"].outside == 1


def test_the_command_tells_by_its_status(tmp_path, ours, monkeypatch, capsys):
    path = tmp_path / "answers.json"
    path.write_text(json.dumps({"machines": ours}), encoding="utf-8")
    monkeypatch.setattr(sys, "argv", ["score_reference.py", str(path)])
    assert score_reference.main() == 0
    assert "60 machines, 0 missing or outside" in capsys.readouterr().out
    path.write_text(json.dumps({"machines": {}}), encoding="utf-8")
    assert score_reference.main() == 1


def test_files_and_answers_follow_their_schemas(ours):
    schemas = {
        k: json.loads((FOLDER / f"{k}.schema.json").read_text(encoding="utf-8")) for k in ("reference", "answers")
    }
    for schema in schemas.values():
        Draft202012Validator.check_schema(schema)
    check = Draft202012Validator(schemas["reference"])
    assert [e.message for data in REFERENCES.values() for e in check.iter_errors(data)] == []
    assert not check.is_valid(REFERENCES["01.machine.json"] | {"more": 1})
    answer = {"format": "sens-reference-answers", "version": 1, "program": "ours", "machines": ours}
    assert [e.message for e in Draft202012Validator(schemas["answers"]).iter_errors(answer)] == []


# -- the reference itself ----------------------------------------------------------------------------------------------
def test_the_reference_imports_nothing_of_the_package():
    for path in (ROOT / "tools" / "reference_set").glob("*.py"):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        names = [n.module or "" for n in ast.walk(tree) if isinstance(n, ast.ImportFrom)]
        names += [a.name for n in ast.walk(tree) if isinstance(n, ast.Import) for a in n.names]
        assert not [n for n in names if n.startswith(("sensworkbench", "numpy", "scipy"))], path


def test_a_machine_computed_again_with_other_digits_gives_the_files():
    from mpmath import mp, mpf
    from reference_set import kinematics, make

    path = FOLDER / "45.machine.json"  # the smallest
    stated = json.loads(path.with_name("45.reference.json").read_text(), parse_float=mpf, parse_int=mpf)
    before = mp.dps, kinematics.STEP
    try:
        mp.dps, kinematics.STEP = 100, mpf(10) ** -33
        assert make.difference(make.reference(path, 45), stated) < mpf(10) ** -28
    finally:
        mp.dps, kinematics.STEP = before


def test_indices_of_the_reference_are_those_of_an_enumeration():
    """Three values with the masses of Gauss's rule have all the moments of a uniform law that Y² asks for."""
    from mpmath import mp, mpf
    from reference_set.indices import Objective, moments

    columns = [[1, 0, mpf(-1) / 3], [mpf(2) / 5, -1, 0], [0, mpf(3) / 2, 1]]
    limits = [(-1, 1), (-2, 5), (0, 3)]
    laws = [moments({"lower": mpf(a), "upper": mpf(b), "unit": "um"}) for a, b in limits]
    nodes = [(-mp.sqrt(mpf(3) / 5), mpf(5) / 18), (mpf(0), mpf(8) / 18), (mp.sqrt(mpf(3) / 5), mpf(5) / 18)]
    weights = [1, 2, mpf(1) / 2]
    values = {}
    for picked in itertools.product(range(3), repeat=3):
        x = [mpf(a + b) / 2 + mpf(b - a) / 2 * nodes[k][0] for k, (a, b) in zip(picked, limits)]
        t = [sum(c[a] * v for c, v in zip(columns, x)) for a in range(3)]
        mass = mp.fprod(nodes[k][1] for k in picked)
        values[picked] = mass, sum(w * v * v for w, v in zip(weights, t))

    def variance_of_mean(known):
        """V(E(Y | X_known)) by enumeration."""
        groups = {}
        for picked, (mass, y) in values.items():
            row = groups.setdefault(tuple(picked[i] for i in known), [0, 0])
            row[0] += mass
            row[1] += mass * y
        mean = sum(m * y for m, y in values.values())
        return sum(m * (s / m - mean) ** 2 for m, s in groups.values())

    found = Objective(columns, laws, weights, signed=False)
    variance = variance_of_mean((0, 1, 2))
    assert abs(found.variance / variance - 1) < 1e-60
    for members in ([0], [1], [2], [0, 2]):
        rest = [i for i in range(3) if i not in members]
        first, total = found.group(members)
        assert abs(first - variance_of_mean(members) / variance) < 1e-60
        assert abs(total - 1 + variance_of_mean(rest) / variance) < 1e-60


def test_ranges_of_effects_of_the_reference_are_those_computed_by_hand():
    from mpmath import mp, mpf
    from reference_set.inputs import component_range

    data = json.loads((FOLDER / "58.machine.json").read_text(encoding="utf-8"), parse_float=mpf, parse_int=mpf)
    found = {e["name"]: component_range(e, data) for e in data["effects"]}
    arcsec = mp.pi / mpf("0.648")
    assert found.pop("not known") is None
    wanted = {
        "backlash": (-2.5, 2.5),
        "turns": (-12.6 * arcsec, 12.6 * arcsec),  # 0.07 arcsec/deg over half a turn
        "column": (-6.2, 29.45),  # -2 K to 9.5 K
        "scale": (-10.35, 19.55),
        "growth": (0, 21 * (1 - mp.exp(-3))),
        "draw": (0, mpf("4e-6") * mpf(12000) * mp.sqrt(12000)),
        "slip": (-7, 0),
        "ball screw": (-mp.sqrt("1.93"), mp.sqrt("1.93")),
        "oil": (-17.1, 0.95),  # from the state at the start, -0.5 K
    }
    for name, span in wanted.items():
        assert [float(v) for v in found[name]] == pytest.approx([float(v) for v in span], rel=1e-14), name


def test_a_left_handed_machine_gets_the_right_handed_frame_nearest_to_that_of_the_file():
    """In 59 Z counts downwards and no axis of the frame changes its sense; in 60 X counts backwards, and x and z do."""
    from mpmath import mp
    from reference_set.kinematics import Machine

    for name, senses in (("59", [1, 1, -1]), ("60", [-1, 1, 1])):
        machine = Machine(FOLDER / f"{name}.machine.json")
        frame = mp.matrix(machine.frame)
        assert abs(mp.det(frame) - 1) < 1e-60
        assert all(frame[i, i] > 0.9 for i in range(3))
        along = [machine.joints[k].direction[i] for i, k in enumerate("XYZ")]
        assert [round(float(v)) for v in along] == senses
