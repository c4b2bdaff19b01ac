# SPDX-License-Identifier: LGPL-2.1-or-later
"""The simulator that judges the tracer, itself judged: by the specification's golden numbers, by its first-order
formula and by the given cases, whose stated bounds its own fit must reproduce.  It imports nothing of the package.
"""

from __future__ import annotations

import json
import re
import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from simulator import CODES, KINDS, NAMELESS, PLANS, make_case, read_case, write_case
from simulator.effects import driver_table, lag, play
from simulator.kinematics import COMPONENTS, SQUARENESS, Machine, exact_error, from_dict, linear_error
from simulator.oracle import complement, declared_columns
from simulator.plans import directions, places

UM = {"EXX": 1, "EYX": 5, "EZX": -3, "EXY": 4, "EYY": -1, "EZY": 2, "EXZ": -2, "EYZ": 3, "EZZ": 0.5}
URAD = {"EAX": 10, "EBX": -15, "ECX": 20, "EAY": -5, "EBY": 12, "ECY": 8, "EAZ": 6, "EBZ": -9, "ECZ": 4}
URAD |= {"C0Y": 20, "A0Z": -15, "B0Z": 10}
GOLDEN = {k: v * 1e-3 for k, v in UM.items()} | {k: v * 1e-6 for k, v in URAD.items()}
AT_ORIGIN = {k: (0, 0, 0) for k in "XYZ"}
APART = {"X": (30, -180, 200), "Y": (-60, -200, 100), "Z": (15, 100, 600)}
TRAVEL = {k: (-300, 300) for k in "XYZ"}


@pytest.mark.parametrize(
    ("code", "reference", "expected"),
    [
        ("FXYZ", AT_ORIGIN, (-1.260, 7.970, 0.900)),
        ("YFXZ", AT_ORIGIN, (0.540, 9.570, -3.750)),
        ("XYFZ", AT_ORIGIN, (-2.460, 11.970, 3.150)),
        ("XFYZ", AT_ORIGIN, (-1.260, 11.970, 3.900)),
        ("FXYZ", APART, (1.140, 12.890, -0.205)),
        ("YFXZ", APART, (2.940, 14.490, -4.855)),
        ("XYFZ", APART, (-0.060, 16.890, 2.045)),
        ("XFYZ", APART, (1.140, 16.890, 2.795)),
    ],
)
def test_the_matrix_product_meets_the_golden_points(code, reference, expected):
    machine = Machine(code, reference, TRAVEL, (10, -20, -150))
    at = np.array([[200.0, 150.0, -100.0]])
    assert 1e3 * linear_error(machine, at, GOLDEN)[0] == pytest.approx(expected, abs=1e-9)
    assert 1e3 * exact_error(machine, at, GOLDEN)[0] == pytest.approx(expected, abs=2.5e-3)


@pytest.mark.parametrize("code", CODES)
def test_every_serial_chain_agrees_with_the_first_order_formula_to_second_order(code):
    rng = np.random.default_rng(3)
    machine = Machine(code, {k: rng.uniform(-300, 300, 3) for k in "XYZ"}, TRAVEL, (10, -20, -150))
    q, tool = rng.uniform(-300, 300, (40, 3)), rng.uniform(-50, 50, (40, 3))
    values = {n: rng.normal(size=40) * (5e-3 if n[1] in "XYZ" else 2e-5) for n in COMPONENTS}
    values |= {n: rng.normal() * 2e-5 for n in SQUARENESS}
    apart = lambda s: np.abs(  # noqa: E731
        exact_error(machine, q, {k: s * v for k, v in values.items()}, tool)
        - linear_error(machine, q, {k: s * v for k, v in values.items()}, tool)
    ).max()
    assert apart(1.0) < 1e-4
    assert apart(0.1) < apart(1.0) / 60  # what is left shrinks with the square


def test_the_tool_and_the_workpiece_turn_about_their_own_references():
    machine = Machine("YFXZ", APART, TRAVEL, (10, -20, 300))
    q = np.array([[50.0, -70.0, 20.0]])
    assert exact_error(machine, q, {"EBT": 1e-6})[0] == pytest.approx(0, abs=1e-12)
    assert exact_error(machine, q, {"EBT": 1e-6}, (0, 0, 100.0))[0] == pytest.approx((1e-4, 0, 0), abs=1e-9)
    assert exact_error(machine, q, {"ECW": 1e-6})[0] == pytest.approx((9e-5, 6e-5, 0), abs=1e-9)


def test_the_same_seed_gives_the_same_case_and_another_seed_another():
    first, again, other = make_case(5, "lag", 2), make_case(5, "lag", 2), make_case(6, "lag", 2)
    assert np.array_equal(first.reading, again.reading)
    assert first.truth == again.truth
    assert first.truth != other.truth


@pytest.mark.parametrize("kind", NAMELESS)
def test_a_shape_without_a_name_is_known_to_the_fit_that_states_the_bound(kind):
    case = make_case(11, kind, 1, count=220, extras=False, with_rivals=False)
    effect = case.truth["effects"][0]
    assert effect["shape"] == kind and effect["visible_rms_over_sigma"] > 2
    assert case.truth["fresh_bound_um"] < 1.5 * case.truth["sigma_um"] < case.truth["effect_rms_um"]


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_of_case_states_an_answer_that_its_readings_can_show(kind):
    case = make_case(11, kind, 3 if kind == "odd" else 1, extras=False)
    truth = case.truth
    assert case.reading.shape == case.fresh_truth.shape == (truth["N"], 3)
    assert not set(truth["missing"]) & (set(case.columns) | set(case.fresh))
    assert (kind == "missing") == bool(truth["missing"])
    assert truth["expect"]
    for effect in truth["effects"]:
        assert effect["visible_rms_over_sigma"] > 0.3
        named = {k: effect[k] for k in ("component", "driver", "shape")}
        assert truth["missing"] or named in effect["equals"]


@pytest.mark.parametrize("plan", PLANS)
def test_on_a_null_case_the_declared_fit_leaves_the_stated_noise(plan):
    case = make_case(3, "none", 1, "XFYZ", plan, extras=False)
    machine = from_dict(case.machine)
    q = np.stack([case.columns[f"{k}_mm"] for k in "xyz"], axis=1)
    columns = declared_columns(machine, q)
    left = complement(columns)(case.reading.ravel())
    freedom = left.size - np.linalg.matrix_rank(columns / np.linalg.norm(columns, axis=0), tol=1e-9)
    assert np.sqrt(left @ left / freedom) == pytest.approx(case.truth["sigma_um"], rel=4 / np.sqrt(2 * freedom))


@pytest.mark.parametrize("plan", PLANS)
def test_plans_go_out_and_come_back_so_that_directions_vary(plan):
    q = places(plan, TRAVEL, np.random.default_rng(1), 600)
    moved = directions(q)
    assert np.abs(q).max() <= 300
    assert set(np.unique(moved)) == {-1.0, 1.0}
    assert np.all(np.abs(moved.mean(axis=0)) < 0.5)
    if plan != "random":
        half = len(q) // 2
        repeated = {tuple(p) for p in np.round(q, 6)}
        assert len(repeated) <= half + 1


def test_memory_shapes_by_hand():
    assert lag(np.array([1.0, 1, 1]), np.array([0.0, 2, 4]), 2.0) == pytest.approx([0, 1 - np.exp(-1), 1 - np.exp(-2)])
    assert play(np.array([0.0, 5, 5.5, 5, 0]), 1.0) == pytest.approx([0, 1, 1, 0.5, -1])
    assert set(driver_table({"t_s": 0, "feed_mm_min": 0, "load_table_kg": 0, "spindle_rpm": 0, "x_mm": 0})) == {
        "t",
        "feed",
        "load_table",
        "spindle",
        "x",
    }


def test_a_written_case_reads_back(tmp_path):
    case = make_case(2, "two", 2)
    write_case(tmp_path, case)
    back = read_case(tmp_path)
    assert back.truth == case.truth
    assert list(back.columns) == list(case.columns)
    assert back.reading == pytest.approx(case.reading, abs=6e-5)
    header = (tmp_path / "measured.csv").read_text().splitlines()[0]
    assert header.startswith("x_mm,y_mm,z_mm,t_s,dir_x,dir_y,dir_z,temp_ambient_C")
    assert header.endswith("ex_um,ey_um,ez_um")
    assert json.loads((tmp_path / "machine.json").read_text())["format"] == "sens-machine"


def test_a_coarse_regular_grid_aliases_a_short_period_and_random_places_do_not():
    free = [make_case(s, "cyclic", 1, plan="random", extras=False).truth["effects"][0] for s in range(4)]
    bound = [make_case(s, "cyclic", 1, plan="grid", extras=False).truth["effects"][0] for s in range(4)]
    assert not any(e["alias_periods"] for e in free)
    assert all(e["alias_periods"] for e in bound if e["parameters"]["period"] < 30)
    assert any(e["alias_periods"] for e in bound)


def test_outliers_are_as_many_and_as_gross_as_said():
    case = make_case(4, "none", 2, sigma_um=0.4)
    calm = make_case(4, "none", 1, sigma_um=0.4)
    assert calm.truth["outliers"] == 0
    assert 0 < case.truth["outliers"] == len(case.truth["outlier_rows"]) < 0.04 * case.truth["N"]


def test_the_simulator_shares_no_code_with_the_package():
    for source in (Path(__file__).resolve().parents[1] / "simulator").glob("*.py"):
        assert not re.search(r"^\s*(import|from)\s+sensworkbench", source.read_text(encoding="utf-8"), re.MULTILINE)
