# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where to move what: derivatives against differences, places against a general optimiser, an Abbe case by hand."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest
from scipy import optimize

from sensworkbench import cli
from sensworkbench.core import workspace
from sensworkbench.core.distributions import Tolerance
from sensworkbench.core.joints import Joint
from sensworkbench.core.machine import Machine
from sensworkbench.formats import costs_csv, machine_json
from sensworkbench.studies.moves import best_in_box, mean_square, moved, moves_study, points_of
from tests.formats.support import ROOT
from tests.formats.test_schemas import faults

EXAMPLES = ROOT / "resources" / "examples"
VMC = machine_json.load(EXAMPLES / "vertical_machining_centre.json")


def test_the_scale_of_an_axis_wants_to_be_at_the_height_of_the_tool():
    """One axis X that pitches about y: its error along x is EBX times the height of the tool over the scale."""
    x = Joint("X", "linear", (1, 0, 0), (0, 0, -30.0), (-100, 100))
    still = {s: Tolerance(0, 0) for s in ("EXX", "EYX", "EZX", "EAX", "ECX", "EXT", "EYT", "EZT", "B0X", "C0X")}
    machine = Machine("one", (), ("X",), (x,), (0, 0, 20.0), tolerances={**still, "EBX": Tolerance(-1e-4, 1e-4)})
    variance, arm = 1e-8 / 3, 50.0
    height = 2 * variance * arm
    found = {p.name: p for p in moves_study(machine, 10).points}
    assert found["X"].changes[2].mean_square == pytest.approx(-height, rel=1e-12)
    assert found["tool_point"].changes[2].mean_square == pytest.approx(height, rel=1e-12)
    assert found["X"].best == pytest.approx([0, 0, 10])
    assert found["X"].rms_best == pytest.approx(40 * variance**0.5)
    far = {p.name: p for p in moves_study(machine, 80).points}
    assert far["X"].best == pytest.approx([0, 0, 50])
    assert far["X"].rms_best == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize("example", ["vertical_machining_centre", "lathe", "rotary_table"])
def test_derivatives_agree_with_differences_of_the_sensitivity(example):
    machine = machine_json.load(EXAMPLES / f"{example}.json")
    result = moves_study(machine)

    def judged(other):
        found = workspace.sensitivity(other, workspace.quadrature(other, 4), estimate=False)
        return np.array([found.mean_square, found.variance, *found.component_share])

    bodies = workspace.sensitivity(machine, workspace.quadrature(machine, 4), estimate=False).bodies
    middle = judged(machine)
    for point in result.points:
        for axis in range(3):
            step = np.zeros(3)
            step[axis] = 0.05
            plus, minus = (judged(moved(machine, {point.name: s * step})) for s in (1, -1))
            slope = (plus - minus) / 0.1
            change = point.changes[axis]
            mine = np.array([change.mean_square, change.variance, *(change.shares[b] for b in bodies)])
            assert mine == pytest.approx(slope, abs=1e-8 * max(abs(middle)), rel=1e-5), (point.name, axis)
            assert mine[0] * 1e6 == pytest.approx(slope[0] * 1e6, abs=1e-8)


def test_the_mean_square_is_a_quadratic_function_of_all_points():
    rng = np.random.default_rng(4)
    names = list(points_of(VMC))
    way = {n: rng.normal(size=3) * 30 for n in names}
    at = [mean_square(moved(VMC, {n: k * w for n, w in way.items()})) for k in range(-2, 3)]
    assert np.diff(at, 3) == pytest.approx(0, abs=1e-13) and abs(np.diff(at, 2)).min() > 1e-7


def test_travel_ends_agree_with_differences():
    result = {t.name: t for t in moves_study(VMC).travel}

    def with_end(end, by):
        span = list(VMC.joint("Z").span)
        span[end] += by
        joints = tuple(replace(j, travel=tuple(span)) if j.name == "Z" else j for j in VMC.joints)
        return mean_square(replace(VMC, joints=joints))

    for end, change in enumerate((result["Z"].low, result["Z"].high)):
        slope = (with_end(end, 0.5) - with_end(end, -0.5)) / 1.0
        assert change.mean_square == pytest.approx(slope, rel=1e-9)


def test_the_best_place_is_that_of_a_general_optimiser():
    rng = np.random.default_rng(6)
    for count in (1, 3, 6):
        root = rng.normal(size=(count, count + 1))
        hessian, gradient = root @ root.T, rng.normal(size=count) * 5
        mine = best_in_box(gradient, hessian, 1.0)
        other = optimize.minimize(
            lambda x, g=gradient, h=hessian: g @ x + x @ h @ x / 2, np.zeros(count), bounds=[(-1, 1)] * count, tol=1e-12
        )
        assert gradient @ mine + mine @ hessian @ mine / 2 <= other.fun + 1e-8
    assert best_in_box(np.zeros(3), np.zeros((3, 3)), 1.0).tolist() == [0, 0, 0]


def test_a_box_may_have_three_sides(tmp_path):
    wide = {p.name: p for p in moves_study(VMC, (0, 0, 30)).points}
    narrow = {p.name: p for p in moves_study(VMC, 30).points}
    assert np.all(wide["Z"].best[:2] == 0) and abs(wide["Z"].best[2]) == pytest.approx(30)
    assert narrow["Z"].rms_best < wide["Z"].rms_best < mean_square(VMC) ** 0.5
    out = str(tmp_path / "one")
    words = ["moves", str(EXAMPLES / "vertical_machining_centre.json"), "--out", out, "--within"]
    assert cli.main([*words, "0,0,30"]) == 0
    data = json.loads((tmp_path / "one" / "moves.json").read_text(encoding="utf-8"))
    assert faults("moves", data) == [] and data["within_mm"] == [0, 0, 30]
    for wrong in ("0,0,0", "1,2", "1,-2,3", "a,b,c"):
        assert cli.main([*words, wrong]) == 2


def test_orders_are_all_and_the_machine_is_one_of_them():
    result = moves_study(VMC, costs=costs_csv.load(EXAMPLES / "costs.csv", VMC))
    found = {o.structure: o.rms for o in result.orders}
    assert len(found) == 24 and found[VMC.structure] == pytest.approx(result.mean_square**0.5)
    assert result.rms_together <= min(p.rms_best for p in result.points if p.name != "tool_point")
    assert result.step is not None and all(p.worth is not None for p in result.points)


def test_the_verb_writes_files_that_follow_the_schema(tmp_path):
    for example, more in (("vertical_machining_centre", ["--costs", str(EXAMPLES / "costs.csv")]), ("trunnion", [])):
        out = tmp_path / example
        words = ["moves", str(EXAMPLES / f"{example}.json"), "--within", "20", "--out", str(out), "--language", "ko"]
        assert cli.main([*words, *more]) == 0
        data = json.loads((out / "moves.json").read_text(encoding="utf-8"))
        assert faults("moves", data) == []
        assert all(abs(v) <= 20 for p in data["points"] for v in p["best_move_mm"])
        assert "옮길" in (out / "report.html").read_text(encoding="utf-8")
    assert cli.main(["moves", str(EXAMPLES / "lathe.json"), "--within", "0", "--out", str(tmp_path / "no")]) == 2
    assert not (tmp_path / "no").exists()
