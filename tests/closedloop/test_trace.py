# SPDX-License-Identifier: LGPL-2.1-or-later
"""The whole trace on small machines: what it says, what it refuses, and that it leaves its inputs alone."""

from __future__ import annotations

import copy
import json
from dataclasses import replace

import numpy as np
import pytest

from sensworkbench.closedloop.naming import stand_in
from sensworkbench.closedloop.predict import predict
from sensworkbench.closedloop.readings import Readings
from sensworkbench.closedloop.search import ScoredTerm
from sensworkbench.closedloop.trace import trace
from sensworkbench.core.refusal import Refused
from sensworkbench.core.shapes import Regressor
from sensworkbench.core.workspace import Cancelled
from sensworkbench.formats import machine_json, readings_csv
from tests.simulator import make_case, write_case

from .support import both, measured, report_of, rms_um, scattered, session

NOISE = 0.3e-3
BEND = 5e-6  # rad per kelvin of the column
TOOLS = np.array([(0.0, 0.0, 0.0), (70.0, 0.0, -60.0), (0.0, 70.0, -120.0)])


def column_bend(count=200, seed=1, bend=BEND, **more):
    """Machine and readings of a column that turns about X with its temperature."""
    simulated, machine = both("XYFZ", (10, -20, -150))
    columns = session(count, seed)
    effect = {"EAZ": bend * columns["temp_column"]}
    return machine, measured(simulated, scattered(count, seed), effect, columns, NOISE, seed=seed, **more)


def named(outcome) -> list[tuple[str, str, str]]:
    return [(e["component"], e["driver"], e["shape"]) for e in report_of(outcome)["effects"]]


def text(outcome) -> str:
    return json.dumps(report_of(outcome), sort_keys=True)


@pytest.fixture(scope="module")
def bent():
    machine, readings = column_bend()
    return machine, readings, trace(machine, readings, seed=1)


def is_the_bend(outcome, **tolerance) -> bool:
    """Is the bending column named, alone, with a coefficient as sure as stated?"""
    [effect] = report_of(outcome)["effects"]
    c = effect["parameters"]["coefficient"]
    assert (effect["component"], effect["driver"], effect["shape"]) == ("EAZ", "temp_column", "linear")
    assert c["unit"] == "urad/K"
    return abs(c["value"] - 1e6 * BEND) < 4 * c["u"] < 0.5


def test_a_bending_column_is_explained(bent):
    _, _, outcome = bent
    assert report_of(outcome)["verdict"] == "explained"
    assert is_the_bend(outcome)
    [effect] = report_of(outcome)["effects"]
    assert effect["p_familywise"] < 0.01 and effect["selection_frequency"] >= 0.9
    assert "thermal bending" in effect["name"]


def test_the_amplitude_is_the_rms_of_the_effect_over_the_readings(bent):
    machine, readings, outcome = bent
    motion = predict(outcome.machine, readings) - predict(outcome.machine, readings, effects=False)
    assert report_of(outcome)["effects"][0]["amplitude_um"] == pytest.approx(rms_um(motion), rel=1e-6)


def test_before_and_after_are_judged_on_readings_that_took_no_part(bent):
    _, readings, outcome = bent
    error = report_of(outcome)["error"]
    for name in ("uncorrected", "declared", "augmented"):
        inside, outside = error[name]["in_sample"], error[name]["held_out"]
        assert inside["rms_um"] <= inside["p95_um"] <= inside["max_um"]
        assert inside["rms_um"] < outside["rms_um"]
        low, high = outside["rms_interval_um"]
        assert low < outside["rms_um"] < high
    rms = [error[n]["held_out"]["rms_um"] for n in ("uncorrected", "declared", "augmented")]
    assert rms[2] < 0.5 * rms[1] < rms[0]
    freedom = 1 - 45 / readings.rows
    assert error["augmented"]["in_sample"]["rms_um"] == pytest.approx(1e3 * NOISE * np.sqrt(3 * freedom), rel=0.1)
    assert report_of(outcome)["noise"]["residual_um"] == pytest.approx(1e3 * NOISE, rel=0.1)
    assert report_of(outcome)["noise"]["stated_um"] is None


def test_the_residuals_belong_to_the_metrics(bent):
    _, readings, outcome = bent
    for name in ("uncorrected", "declared", "augmented"):
        for key, part in ((name, "in_sample"), (name + "_held_out", "held_out")):
            square = np.bincount(readings.point, weights=outcome.residuals[key] ** 2)
            assert np.sqrt(square.mean()) == pytest.approx(report_of(outcome)["error"][name][part]["rms_um"], rel=1e-9)


def test_the_same_seed_says_the_same_to_the_last_digit_and_another_seed_the_same_in_words(bent):
    machine, readings, outcome = bent
    assert text(trace(machine, readings, seed=1)) == text(outcome)
    other = trace(machine, readings, seed=2)
    assert report_of(other)["verdict"] == "explained" and is_the_bend(other)


def test_the_inputs_are_left_as_they_were(bent):
    machine, readings, _ = bent
    fresh_machine, fresh = column_bend()
    assert machine == fresh_machine
    assert np.array_equal(readings.value, fresh.value) and np.array_equal(readings.q, fresh.q)
    assert all(np.array_equal(readings.columns[k], fresh.columns[k]) for k in fresh.columns)


@pytest.mark.parametrize("after", [1, 2, 4])
def test_a_cancelled_trace_changes_nothing(after):
    machine, readings = column_bend()
    before = copy.deepcopy((machine, readings.value, dict(readings.columns)))
    told = []

    def stop(fraction, words):
        told.append(fraction)
        return len(told) < after

    with pytest.raises(Cancelled):
        trace(machine, readings, progress=stop)
    assert len(told) == after and told == sorted(told)
    assert machine == before[0] and np.array_equal(readings.value, before[1])
    assert all(np.array_equal(readings.columns[k], v) for k, v in before[2].items())


def test_nothing_is_named_where_there_is_nothing():
    machine, readings = column_bend(bend=0.0, seed=3)
    outcome = trace(machine, readings, seed=3)
    assert (report_of(outcome)["verdict"], report_of(outcome)["effects"]) == ("nothing_to_explain", [])
    assert report_of(outcome)["depends_on"] == []
    assert outcome.machine.effects == ()


def test_an_effect_that_the_machine_knows_already_is_traced_no_second_time(bent):
    _, readings, outcome = bent
    again = trace(replace(outcome.machine, fitted=None), readings, seed=1)
    assert (report_of(again)["verdict"], report_of(again)["effects"]) == ("nothing_to_explain", [])
    assert again.machine.effects == outcome.machine.effects
    assert predict(again.machine, readings) == pytest.approx(predict(outcome.machine, readings), abs=0.1e-3)


def test_a_stated_uncertainty_is_evidence(bent):
    """More scatter than stated withholds `explained`; less is a remark; what is right is neither."""
    machine, readings, _ = bent
    for factor, verdict, code in (
        (0.4, "partly_explained", "noise-more-than-stated"),
        (1.0, "explained", None),
        (2.5, "explained", "noise-less-than-stated"),
    ):
        outcome = trace(machine, replace(readings, u=np.full(readings.rows, factor * NOISE)), seed=1)
        assert report_of(outcome)["verdict"] == verdict and is_the_bend(outcome)
        assert {m.code for m in outcome.noise.remarks} == ({code} if code else set())
        assert all(r == pytest.approx(1 / factor**2, rel=0.25) for r in outcome.noise.ratio.values())
        assert report_of(outcome)["noise"]["stated_um"] == pytest.approx(1e3 * factor * NOISE)
        assert report_of(outcome)["noise"]["residual_um"] == pytest.approx(1e3 * NOISE, rel=0.1)


def test_runs_and_several_tools_leave_the_verdict_as_it_is():
    simulated, machine = both("XYFZ", (10, -20, -150))
    columns = session(240, 5)
    tool, run = TOOLS[np.arange(240) // 80], np.arange(240) // 60 + 1
    bend = {"EAZ": BEND * columns["temp_column"]}
    readings = measured(simulated, scattered(240, 5), bend, columns, NOISE, seed=5, tool=tool, run=run)
    moved = np.array([(0, 0, 0), (6e-3, -3e-3, 2e-3), (-5e-3, 1e-3, 4e-3), (2e-3, 2e-3, 2e-3)])[run - 1]
    outcome = trace(machine, replace(readings, value=readings.value + moved.ravel()), seed=5)
    assert report_of(outcome)["verdict"] == "explained" and is_the_bend(outcome)
    assert set(outcome.machine.fitted.runs) == {"1", "2", "3", "4"}
    assert report_of(outcome)["identifiability"]["rank"] > 45


def as_laser(readings: Readings, seed: int) -> Readings:
    """One reading a point, along a body diagonal or an axis: what a laser on a step diagonal sees."""
    ways = np.array([(1, 1, 1), (1, 1, -1), (1, -1, 1), (1, -1, -1), (3**0.5, 0, 0), (0, 3**0.5, 0), (0, 0, 3**0.5)])
    unit = ways[np.random.default_rng(seed).integers(len(ways), size=readings.points)] / 3**0.5
    value = (unit * readings.value.reshape(-1, 3)).sum(axis=1)
    count = readings.points
    nothing = np.full(count, np.nan)
    return replace(readings, point=np.arange(count), sense=unit, value=value, u=nothing, kind=np.full(count, 3))


def test_readings_along_diagonals_are_traced_like_vectors():
    machine, readings = column_bend(500, 6)
    outcome = trace(machine, as_laser(readings, 6), seed=6)
    assert report_of(outcome)["verdict"] == "explained" and is_the_bend(outcome)
    assert set(report_of(outcome)["noise"]["per_direction_um"]) == {"*"}


@pytest.mark.parametrize("size", [2.0, 8.0])
def test_a_direction_with_the_wrong_sign_is_pointed_out(size):
    simulated, machine = both("XYFZ", (10, -20, -150))
    readings = measured(simulated, scattered(200, 1), noise=NOISE, seed=1, size=size)
    warned = lambda r: [  # noqa: E731
        f["message"] for f in report_of(trace(machine, r, seed=1))["findings"] if f["code"] == "flipped-sign"
    ]
    assert warned(readings) == []
    [message] = warned(replace(readings, value=np.where(readings.kind == 1, -readings.value, readings.value)))
    assert "ey" in message


def simulated_case(tmp_path, *what):
    write_case(tmp_path, make_case(*what))
    return machine_json.load(tmp_path / "machine.json"), readings_csv.load(tmp_path / "measured.csv")


def test_a_strong_effect_is_not_taken_for_a_wrong_sign(tmp_path):
    machine, readings = simulated_case(tmp_path, 200042, "overhang", 1)  # the declared model alone prefers -ez
    outcome = trace(machine, readings, seed=1)
    assert report_of(outcome)["verdict"] == "explained"
    assert report_of(outcome)["error"]["augmented"]["in_sample"]["rms_um"] < 1.6


def test_a_wrong_sign_is_pointed_out_beside_an_effect(tmp_path):
    machine, readings = simulated_case(tmp_path, 31012, "following", 1)
    assert report_of(trace(machine, readings, seed=1))["verdict"] == "explained"
    turned = replace(readings, value=np.where(readings.kind == 2, -readings.value, readings.value))
    report = report_of(trace(machine, turned, seed=1))
    assert report["effects"] == [] and report["verdict"] == "unexplained"
    [message] = [f["message"] for f in report["findings"] if f["code"] == "flipped-sign"]
    assert "the sign of ez" in message


def candidate(symbol, driver, shape="linear", **parameters) -> ScoredTerm:
    return ScoredTerm(symbol, Regressor.make(driver, shape, **parameters), 100.0, np.ones(1), 1.0, 0.0)


def test_pieces_of_slow_columns_are_no_names_but_one_temperature_is():
    t = np.linspace(0, 9000, 300)
    columns = {"x": np.tile([-1.0, 1.0], 150), "t": t, "temp_a": t / 1000, "temp_b": np.sqrt(t), "spindle": t > 3000}
    said = lambda c, *others: getattr(stand_in(c, others, columns, list(columns)), "code", "")  # noqa: E731
    lag = candidate("EYX", "temp_a", "lag", tau=900.0)
    assert said(lag) == said(lag, candidate("EYX", "t", "step", at=3000.0)) == ""
    assert said(candidate("EYX", "temp_a"), candidate("EYX", "temp_b")) == ""  # two causes, each in proportion
    assert said(candidate("EYX", "temp_a"), candidate("EYX", "t", "approach", tau=300.0)) == ""  # and a warm-up
    bent = candidate("EYZ", "temp_b", "power", exponent=1.4)  # both shift along Y
    assert stand_in(lag, [bent], columns, list(columns)).fields == {"columns": ["temp_a", "temp_b"]}
    assert said(lag, bent) == said(bent, lag) == "refused-pieces"
    assert said(lag, candidate("EYX", "temp_b")) == "refused-pieces"
    assert said(lag, candidate("EYX", "t", "polynomial", degree=2, domain=(0.0, 9000.0))) == "refused-pieces"
    assert said(lag, candidate("EXX", "temp_b", "power", exponent=1.4)) == ""  # another motion
    assert said(lag, candidate("EYX", "spindle*temp_b", "lag", tau=90.0)) == ""  # with the spindle: another cause
    assert said(lag, candidate("EYX", "spindle*spindle", "lag", tau=300.0)) == ""  # a spindle is no temperature
    assert said(candidate("EAX", "temp_a", "polynomial", degree=3, domain=(0.0, 9.0))) == "refused-bent"
    scales = {**columns, "temp_scale_y": np.sin(t / 3000)}
    other = lambda c, table: getattr(stand_in(c, [], table, list(table)), "code", "")  # noqa: E731
    assert other(candidate("EYY", "temp_scale_y*x"), scales) == ""
    assert other(candidate("EXX", "temp_scale_y*x"), scales) == "refused-other-axis"
    assert other(candidate("EXX", "temp_scale_y*x"), {**scales, "temp_scale_x": 0 * t}) == ""
    assert other(candidate("EXW", "temp_scale_y"), scales) == ""  # the workpiece has no scale of its own


def test_what_other_temperatures_piece_together_gets_no_name(tmp_path):
    machine, readings = simulated_case(tmp_path, 41003, "missing", 1)  # the column that bends is hidden
    report = report_of(trace(machine, readings, seed=1))
    assert report["verdict"] == "unexplained" and report["effects"] == []
    assert all("not logged" in r["why"] for r in report["refused_names"]) and len(report["refused_names"]) == 2


def test_outliers_are_listed_by_their_line(bent):
    machine, readings, _ = bent
    value = readings.value.copy()
    value[[30, 301]] += 25e-3
    outcome = trace(machine, replace(readings, value=value), seed=1)
    assert report_of(outcome)["verdict"] == "explained" and is_the_bend(outcome)
    assert [o["line"] for o in report_of(outcome)["outliers"]] == [readings.line[10], readings.line[100]]
    assert report_of(outcome)["outliers"][0]["position_mm"] == readings.q[10].tolist()


def test_replicates_give_the_pure_error():
    simulated, machine = both("XYFZ", (10, -20, -150))
    q = np.repeat(scattered(70, 8), 3, axis=0)
    outcome = trace(machine, measured(simulated, q, noise=NOISE, seed=8), seed=8)
    assert report_of(outcome)["verdict"] == "nothing_to_explain"
    assert report_of(outcome)["noise"]["pure_error_um"] == pytest.approx(1e3 * NOISE, rel=0.1)


def test_what_lacks_its_column_is_not_testable_and_says_what_it_needs(bent):
    _, _, outcome = bent
    needs = {e["effect"]: e["needs"] for e in report_of(outcome)["not_testable"]}
    assert needs["deflection under the moved mass"] == "load_<name>_kg"
    assert "feed_mm_min" in needs["following error with feed and direction"]
    assert not any("temp" in n for n in needs.values())


def test_a_tilt_that_the_declared_angle_imitates_is_not_identifiable(bent):
    _, _, outcome = bent
    assert report_of(outcome)["not_identifiable"]
    assert all("driven by" in w and "would show" in w for w in report_of(outcome)["not_identifiable"])


def test_the_sensitivity_afterwards_holds_the_effect(bent):
    _, _, outcome = bent
    rows = {r["symbol"]: r for r in report_of(outcome)["sensitivity_shift"]}
    name = report_of(outcome)["effects"][0]["name"]
    assert rows[name]["before"] is None and rows[name]["after"] > 0


@pytest.mark.parametrize("count", [3, 12])
def test_too_few_readings_are_refused(count):
    machine, readings = column_bend(200)
    with pytest.raises(Refused, match="readings"):
        trace(machine, readings.select(np.arange(count)))


@pytest.mark.parametrize("count", [4200, 14000])
def test_a_screw_is_found_where_a_scan_looks_at_some_points_only(count):
    _, machine = both("FXYZ")
    rng = np.random.default_rng(count)
    q = np.zeros((count, 3))
    q[:, 0] = rng.uniform(-300, 300, count)
    error = np.full((count, 3), np.nan)
    error[:, 0] = 1.5e-3 * np.sin(2 * np.pi * q[:, 0] / 10) + NOISE * rng.normal(size=count)
    report = report_of(trace(machine, Readings.from_vectors(q, error), seed=1, permutations=119))
    [found] = report["effects"]
    assert (report["verdict"], found["component"], found["shape"]) == ("explained", "EXX", "periodic")
    assert found["parameters"]["period"]["value"] == pytest.approx(10.0, abs=0.01)
