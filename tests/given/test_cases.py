# SPDX-License-Identifier: LGPL-2.1-or-later
"""The six given cases with a known answer: verdict, names, prediction, and the bound that a prediction is held to."""

from __future__ import annotations

import numpy as np
import pytest

from sensworkbench.closedloop.predict import predict
from sensworkbench.closedloop.trace import trace
from sensworkbench.formats import machine_json, readings_csv
from tests.closedloop.judging import LIMIT, names_exactly, said, triple
from tests.closedloop.support import from_folder, report_of, rms_um
from tests.simulator import read_case
from tests.simulator.effects import Effect, driver_table
from tests.simulator.kinematics import from_dict
from tests.simulator.oracle import declared_columns, effect_columns, oracle_prediction, solve

from .support import DATA


@pytest.fixture(scope="module")
def given():
    """Traces of the given cases, made when first asked for."""
    kept = {}

    def traced(name):
        if name not in kept:
            machine, readings, positions = from_folder(DATA / f"case-{name}")
            outcome = trace(machine, readings, seed=1)
            kept[name] = outcome, predict(outcome.machine, positions), read_case(DATA / f"case-{name}")
        return kept[name]

    return traced


def side(columns):
    """(positions, table of columns, their scales, tool offsets, runs, set-ups) of readings or of fresh places."""
    table = driver_table(columns)
    q = np.stack([table[k] for k in "xyz"], axis=1)
    return q, table, {k: (v.min(), v.max()) for k, v in table.items()}, np.zeros_like(q), None, ()


def derived_bound(case) -> float:
    """rms (um) at the fresh places of the fit that knows the effects; gross outliers left out as it finds them."""
    machine = from_dict(case.machine)

    known = [Effect(e["component"], e["driver"], e["shape"]) for e in case.truth["effects"]]
    here, fresh = side(case.columns), side(case.fresh)
    columns = np.hstack([declared_columns(machine, here[0])] + [effect_columns(machine, e, *here[:4]) for e in known])
    keep = np.ones(len(case.reading), dtype=bool)
    for _ in range(4):
        rows = np.repeat(keep, 3)
        left = case.reading.ravel() - columns @ solve(columns[rows], case.reading.ravel()[rows])
        keep = (np.abs(left) < 5 * np.sqrt(np.mean(left[rows] ** 2))).reshape(-1, 3).all(axis=1)
    guess = oracle_prediction(machine, known, here, case.reading / 1e3, fresh, keep)
    return rms_um(guess - case.fresh_truth / 1e3)


@pytest.mark.parametrize("name", "ABCDEF")
def test_the_verdict_of_a_given_case_is_right(given, name):
    outcome, _, case = given(name)
    expected = "unexplained" if case.truth["kind"] == "odd" else "explained"
    if not case.truth["effects"]:
        expected = "nothing_to_explain"
    assert report_of(outcome)["verdict"] == expected


@pytest.mark.parametrize("name", "ABCDE")
def test_the_effects_of_a_given_case_are_named(given, name):
    outcome, _, case = given(name)
    assert names_exactly(said(report_of(outcome)), case.truth["effects"])
    assert {triple(e) for e in report_of(outcome)["effects"]} == {triple(e) for e in case.truth["effects"]}


def test_of_an_odd_shape_only_the_columns_are_told(given):
    outcome, _, case = given("F")
    assert report_of(outcome)["effects"] == []
    found = {d["column"] for d in report_of(outcome)["depends_on"] if d["p"] < 0.01}
    assert found == {c for e in case.truth["effects"] for c in e["driver"].split("*")}
    assert report_of(outcome)["remainder"]["words"] == "structure above the floor that no named effect explains"


@pytest.mark.parametrize("name", "ABCDE")
def test_the_prediction_of_a_given_case_is_as_good_as_knowing_the_effect(given, name):
    _, guess, case = given(name)
    bound = derived_bound(case)
    assert bound == pytest.approx(case.truth["fresh_bound_um"], rel=0.03)
    assert rms_um(guess - case.fresh_truth / 1e3) <= LIMIT * case.truth["fresh_bound_um"]


def test_outliers_and_roughness_of_a_given_case_are_listed_and_left_unnamed(given):
    outcome, _, case = given("E")
    assert len(report_of(outcome)["outliers"]) == pytest.approx(case.truth["outliers"], abs=2)
    assert len(report_of(outcome)["effects"]) == 1


@pytest.mark.parametrize("name", "ABCD")
def test_the_bound_of_the_given_cases_is_met_by_the_fit_that_knows_the_effect(name):
    case = read_case(DATA / f"case-{name}")
    known = [Effect(e["component"], e["driver"], e["shape"]) for e in case.truth["effects"]]
    keep = np.ones(len(case.reading), dtype=bool)
    machine = from_dict(case.machine)
    guess = oracle_prediction(machine, known, side(case.columns), case.reading / 1e3, side(case.fresh), keep)
    error = np.sqrt(np.mean(np.sum((1e3 * guess - case.fresh_truth) ** 2, axis=1)))
    assert error == pytest.approx(case.truth["fresh_bound_um"], rel=0.005)


@pytest.mark.parametrize("case", "ABCDEF")
def test_the_cases_with_a_known_answer_are_read_whole(case):
    folder = DATA / f"case-{case}"
    raw = np.genfromtxt(folder / "measured.csv", delimiter=",", names=True)
    readings = readings_csv.load(folder / "measured.csv")
    assert np.allclose(readings.value.reshape(-1, 3)[:, 0], raw["ex_um"] * 1e-3, rtol=0, atol=1e-15)
    assert np.allclose(readings.columns["temp_column"], raw["temp_column_C"] - 20, rtol=0, atol=1e-12)
    assert np.array_equal(readings.columns["dir_y"], raw["dir_y"])
    assert not [f for f in readings.remarks if f.severity != "info"]
    assert readings_csv.load_positions(folder / "positions.csv").points == len(raw)


def test_the_machines_of_the_given_cases_are_read():
    cases = sorted(DATA.glob("case-*/machine.json"))
    assert len(cases) == 6
    assert all(machine_json.load(p).declared_degree("EXX") == 3 for p in cases)
