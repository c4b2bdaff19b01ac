# SPDX-License-Identifier: LGPL-2.1-or-later
"""The study of limits, as a user runs it, against formulas worked by hand and a direct sample."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest

from sensworkbench import cli
from sensworkbench.core.distributions import Tolerance
from sensworkbench.core.synthesis import volumetric_error
from sensworkbench.formats import machine_json
from sensworkbench.studies.limits import limits_study, quantile_um
from tests.formats.support import ROOT
from tests.formats.test_schemas import faults

MACHINE = ROOT / "resources" / "examples" / "vertical_machining_centre.json"
VMC = machine_json.load(MACHINE)


def only(**laws):
    """The machine with these errors alone."""
    still = {s: Tolerance(0.0, 0.0) for s in VMC.all_tolerances}
    return replace(VMC, tolerances=still | laws)


def test_one_scale_error_has_its_own_quantile_everywhere():
    found = limits_study(only(EXX=Tolerance(-2e-3, 2e-3)), 0.9, (1.0,))
    assert found.quantile == pytest.approx(1.8, abs=4 * found.error)  # uniform: 90 % of |x| is below 0.9 of the limit
    assert found.beyond[0][1] == pytest.approx(0.5, abs=0.01)
    assert found.errors[0].name == "EXX" and found.errors[0].value == pytest.approx(1)
    assert all(f.upper == pytest.approx(0, abs=1e-12) for f in found.figures)  # a constant has no range


def test_the_range_of_a_roll_is_its_lever_arm_over_the_travel():
    """ECX turns the table about z: y error = ECX (x_tip - x_ref), and its range over the travel of the arm."""
    angle = 20e-6
    machine = only(ECX=Tolerance(angle, angle))
    found = {f.name: f for f in limits_study(replace(machine, tolerances={**machine.tolerances,
             "EXX": Tolerance(-1e-9, 1e-9)}), 0.95).figures}  # fmt: skip
    corners = np.array(np.meshgrid(*machine.travel)).reshape(3, -1).T
    error = volumetric_error(machine, {"ECX": angle}, corners) * 1e3
    for axis, name in enumerate(("V_X", "V_Y", "V_Z")):
        assert found[name].median == pytest.approx(np.ptp(error[:, axis]), abs=1e-6)
    assert found["V_XYZ"].upper == pytest.approx(max(np.ptp(error, axis=0)), abs=1e-6)


def test_a_direct_sample_of_machines_and_places_agrees():
    rng, count = np.random.default_rng(8), 40_000
    laws = VMC.all_tolerances
    q = rng.uniform(*VMC.travel.T, (count, 3))
    values = {s: rng.uniform(law.lower, law.upper, count) for s, law in laws.items()}
    size = np.linalg.norm(volumetric_error(VMC, values, q), axis=1) * 1e3
    found = limits_study(VMC, 0.95, (25.0,))
    assert found.quantile == pytest.approx(np.quantile(size, 0.95), rel=0.015)
    assert found.beyond[0][1] == pytest.approx((size > 25).mean(), abs=0.012)
    assert found.worst > found.quantile and quantile_um(VMC, 0.95) == pytest.approx(found.quantile)
    assert sum(c.value for c in found.errors) == pytest.approx(1)
    assert sum(c.value for c in found.components) == pytest.approx(1)


@pytest.mark.parametrize("example", ["vertical_machining_centre", "lathe", "rotary_table", "trunnion"])
def test_the_verb_writes_files_that_follow_the_schema(tmp_path, example):
    machine = str(ROOT / "resources" / "examples" / f"{example}.json")
    words = ["limits", machine, "--limit", "10", "--limit", "40", "--out", str(tmp_path)]
    assert cli.main([*words, "--language", "de"]) == 0
    data = json.loads((tmp_path / "limits.json").read_text(encoding="utf-8"))
    assert faults("limits", data) == [] and len(data["beyond"]) == 2
    assert data["beyond"][0]["probability"] >= data["beyond"][1]["probability"]
    assert "Wie groß" in (tmp_path / "report.html").read_text(encoding="utf-8")


@pytest.mark.parametrize("words", [["--level", "1.5"], ["--limit", "-3"], ["--level", "nan"]])
def test_bad_input_is_refused_and_nothing_is_written(tmp_path, words, capsys):
    assert cli.main(["limits", str(MACHINE), "--out", str(tmp_path / "out"), *words]) == 2
    assert not (tmp_path / "out").exists() and capsys.readouterr().err


def test_the_objective_is_known_to_the_sensitivity_study(tmp_path):
    words = [
        "sensitivity",
        str(MACHINE),
        "--objective",
        "quantile:level=0.9",
        "--quadrature",
        "2",
        "--out",
        str(tmp_path),
    ]
    assert cli.main(words) == 0
    data = json.loads((tmp_path / "sensitivity.json").read_text(encoding="utf-8"))
    assert faults("sensitivity", data) == []
    assert all(e["share"] is None for e in data["errors"] + data["components"])
    assert "ln Y" in data["conventions"]["first"] and data["settings"]["objective"].startswith("Q0.9")
    assert sum(e["total"] for e in data["errors"]) == pytest.approx(1)


# -- a quantile as the target of an allocation -------------------------------------------------------------------------
def test_tolerances_bought_for_a_quantile_keep_it(tmp_path):
    words = ["allocate", str(MACHINE), "--costs", str(ROOT / "resources" / "examples" / "costs.csv")]
    assert cli.main([*words, "--target", "quantile=0.95:25", "--out", str(tmp_path)]) == 0
    data = json.loads((tmp_path / "allocation.json").read_text(encoding="utf-8"))
    assert faults("allocation", data) == [] and data["target"]["level"] == 0.95
    bought = machine_json.load(tmp_path / "machine.json")
    assert 24.9 < quantile_um(bought, 0.95) <= 25 and data["quantile_um"]["after"] == pytest.approx(
        quantile_um(bought, 0.95), rel=1e-6
    )
    assert 0 < data["bound"] <= data["cost"]
    # the bound is one: tolerances that keep the quantile by other means are no cheaper than it
    tighter = tmp_path / "tighter"
    assert cli.main([*words, "--target", "worst=18", "--out", str(tighter)]) == 0
    other = json.loads((tighter / "allocation.json").read_text(encoding="utf-8"))
    if quantile_um(machine_json.load(tighter / "machine.json"), 0.95) <= 25:
        assert other["cost"] >= data["bound"]


def test_normal_errors_have_a_bound_near_the_answer_and_no_other_tolerances_undercut_it():
    from sensworkbench.core.allocation import PowerCost
    from sensworkbench.core.distributions import Tolerance
    from sensworkbench.studies.allocation import Target, allocation_study

    machine = machine_json.load(MACHINE)
    laws = {s: Tolerance(t.lower, t.upper, "normal", t.upper / 3) for s, t in machine.all_tolerances.items()
            if t.upper > 0}  # fmt: skip
    machine = replace(machine, tolerances=dict(machine.tolerances) | laws)
    costs = {s: PowerCost(t.upper, 1.0, 0.1 * t.upper, 4 * t.upper) for s, t in laws.items()}
    limit = 0.8 * quantile_um(machine, 0.95)
    found = allocation_study(machine, Target("quantile", limit, 0.95), costs)
    assert quantile_um(found.machine, 0.95) <= limit
    assert found.normal_bound == pytest.approx(found.allocation.bound) and 0 < found.allocation.gap < 0.25
    rng = np.random.default_rng(2)
    for _ in range(4):  # other tolerances about the answer that keep the quantile as well
        scale = {c.symbol: np.exp(0.3 * rng.standard_normal()) for c in found.choices}
        other = {c.symbol: c.after.scaled(scale[c.symbol]) for c in found.choices}
        size = quantile_um(replace(machine, tolerances=dict(machine.tolerances) | other), 0.95) / limit
        cost = sum(costs[s].cost(t.upper / size) for s, t in other.items())
        assert cost >= found.allocation.bound


@pytest.mark.parametrize("target", ["quantile=0.95:0.01", "quantile=2:20", "quantile=20", "quantile=0.95:x"])
def test_a_quantile_that_cannot_be_met_is_refused(tmp_path, target, capsys):
    words = ["allocate", str(MACHINE), "--costs", str(ROOT / "resources" / "examples" / "costs.csv")]
    assert cli.main([*words, "--target", target, "--out", str(tmp_path / "out")]) == 2
    assert not (tmp_path / "out").exists() and capsys.readouterr().err
