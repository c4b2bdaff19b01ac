# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whole cases with a known answer: the given ones, and simulated ones of every sort - verdict, names, prediction.

The truth may stand among the rivals that "leave the same trace": then the readings hold no difference.  Predictions are
judged against the fit that knows the effects' forms and must still estimate everything else.
"""

from __future__ import annotations

import json

import numpy as np
import pytest

from sensworkbench.closedloop.predict import predict
from sensworkbench.closedloop.trace import trace
from tests.simulator import make_case, read_case
from tests.simulator.effects import Effect, driver_table
from tests.simulator.kinematics import from_dict
from tests.simulator.oracle import declared_columns, effect_columns, oracle_prediction, solve

from .support import DATA, from_case, from_folder, rms_um

LIMIT = 1.2  # times the bound


def triple(entry) -> tuple[str, str, str]:
    """Component, driver, shape; a sign of travel is a reversal or linear in it, as you like."""
    shape = "linear" if entry["shape"] == "reversal" else entry["shape"]
    return entry["component"], "*".join(sorted(entry["driver"].split("*"))), shape


def said(report) -> list[set]:
    """Per finding: its own name and those of the rivals that leave the very same trace."""
    return [{triple(e)} | {triple(r) for r in e["rivals"] if "same trace" in r["why"]} for e in report["effects"]]


def listed(report) -> list[set]:
    """Per finding: its own name and all of its rivals'."""
    return [{triple(e)} | {triple(r) for r in e["rivals"]} for e in report["effects"]]


def names_exactly(sets, truths) -> bool:
    """Does every finding answer to one true effect, and every effect to one finding?"""
    left = [triple(t) for t in truths]
    for names in sets:
        hit = [t for t in left if t in names]
        if not hit:
            return False
        left.remove(hit[0])
    return not left


# -- the given cases ---------------------------------------------------------------------------------------------------
@pytest.fixture(scope="module")
def given():
    """Traces of the given cases, made when first asked for."""
    kept = {}

    def traced(name):
        folder = DATA / f"case-{name}"
        if not folder.is_dir():
            pytest.skip(f"the measured-data case {name} is not here")
        if name not in kept:
            machine, readings, positions = from_folder(folder)
            outcome = trace(machine, readings, seed=1)
            kept[name] = outcome, predict(outcome.machine, positions), read_case(folder)
        return kept[name]

    return traced


def derived_bound(case) -> float:
    """rms (um) at the fresh places of the fit that knows the effects; gross outliers left out as it finds them."""
    machine = from_dict(case.machine)

    def side(columns):
        table = driver_table(columns)
        q = np.stack([table[k] for k in "xyz"], axis=1)
        return q, table, {k: (v.min(), v.max()) for k, v in table.items()}, np.zeros_like(q), None, ()

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
    assert outcome.report["verdict"] == expected


@pytest.mark.parametrize("name", "ABCDE")
def test_the_effects_of_a_given_case_are_named(given, name):
    outcome, _, case = given(name)
    assert names_exactly(said(outcome.report), case.truth["effects"])
    assert {triple(e) for e in outcome.report["effects"]} == {triple(e) for e in case.truth["effects"]}


def test_of_an_odd_shape_only_the_columns_are_told(given):
    outcome, _, case = given("F")
    assert outcome.report["effects"] == []
    found = {d["column"] for d in outcome.report["depends_on"] if d["p"] < 0.01}
    assert found == {c for e in case.truth["effects"] for c in e["driver"].split("*")}
    assert outcome.report["remainder"]["words"] == "structure above the floor that no named effect explains"


@pytest.mark.parametrize("name", "ABCDE")
def test_the_prediction_of_a_given_case_is_as_good_as_knowing_the_effect(given, name):
    _, guess, case = given(name)
    bound = derived_bound(case)
    assert bound == pytest.approx(case.truth["fresh_bound_um"], rel=0.03)
    assert rms_um(guess - case.fresh_truth / 1e3) <= LIMIT * case.truth["fresh_bound_um"]


def test_outliers_and_roughness_of_a_given_case_are_listed_and_left_unnamed(given):
    outcome, _, case = given("E")
    assert len(outcome.report["outliers"]) == pytest.approx(case.truth["outliers"], abs=2)
    assert len(outcome.report["effects"]) == 1


# -- simulated cases ---------------------------------------------------------------------------------------------------
NAMED = [  # seed, kind, level, structure, plan, readings
    (20011, "column_bend", 1, "FXYZ", "random", 300),
    (20012, "backlash", 1, "XYFZ", "lines", 400),
    (20013, "thermal_scale", 2, "YFXZ", "random", 500),
    (20014, "step", 1, "XFYZ", "lines", 400),
    (20015, "cyclic", 1, "FXYZ", "random", 400),
    (20016, "spindle_growth", 1, "XYFZ", "random", 400),
    (20017, "mass", 1, "YXFZ", "random", 300),
    (20018, "lag", 1, "XYFZ", "random", 400),
    (20019, "two", 1, "FXYZ", "random", 400),
    (20020, "hysteresis", 1, "XYFZ", "lines", 500),
]
QUIET = [
    (20031, "none", 1, "XYFZ", "grid", 300),
    (20032, "none", 2, "FXYZ", "lines", 400),
    (20033, "none", 2, "YFXZ", "random", 300),
    (20034, "none", 1, "XFYZ", "diagonals", 400),
]


@pytest.fixture(scope="module")
def simulated():
    """Traces of simulated cases, made when first asked for."""
    kept = {}

    def traced(seed, kind, level, structure, plan, count):
        if seed not in kept:
            case = make_case(seed, kind, level, structure, plan, count=count, extras=False)
            machine, readings, positions = from_case(case)
            outcome = trace(machine, readings, seed=seed)
            kept[seed] = outcome, predict(outcome.machine, positions), case
        return kept[seed]

    return traced


def label(case) -> str:
    return f"{case[1]}-{case[0]}"


@pytest.mark.parametrize("setting", NAMED, ids=label)
def test_a_simulated_effect_is_explained_by_its_name(simulated, setting):
    outcome, _, case = simulated(*setting)
    assert outcome.report["verdict"] == "explained"
    truths = [[e, *e.get("equals", ())] for e in case.truth["effects"]]
    assert len(outcome.report["effects"]) == len(truths)
    for names in listed(outcome.report):  # the truth is what is named, or stands among what cannot be told from it
        assert any(triple(e) in names for group in truths for e in group)


@pytest.mark.parametrize("setting", NAMED, ids=label)
def test_a_simulated_machine_is_predicted_as_well_as_by_knowing_the_effect(simulated, setting):
    _, guess, case = simulated(*setting)
    if any(e.get("alias_periods") for e in case.truth["effects"]):
        pytest.skip("the plan aliases this period: it is judged on saying so")
    assert rms_um(guess - case.fresh_truth / 1e3) <= LIMIT * case.truth["fresh_bound_um"]


@pytest.mark.parametrize("setting", QUIET, ids=label)
def test_nothing_is_named_on_a_machine_without_an_effect(simulated, setting):
    outcome, guess, case = simulated(*setting)
    assert (outcome.report["verdict"], outcome.report["effects"]) == ("nothing_to_explain", [])
    assert rms_um(guess - case.fresh_truth / 1e3) <= LIMIT * case.truth["fresh_bound_um"]


def test_a_column_that_nobody_logged_is_never_explained(simulated):
    outcome, _, case = simulated(20041, "missing", 1, "XYFZ", "random", 400)
    assert case.truth["missing"]
    assert outcome.report["verdict"] in ("unexplained", "partly_explained")
    for effect in outcome.report["effects"]:
        assert "t" in effect["driver"].split("*") or effect["shape"] == "random"


def test_a_driver_that_jumps_from_reading_to_reading_shows_as_one_body_s_motion(simulated):
    outcome, _, case = simulated(20042, "unlogged", 1, "XYFZ", "random", 400)
    assert outcome.report["verdict"] == "partly_explained"
    [effect] = outcome.report["effects"]
    assert effect["component"] == case.truth["unlogged"]["component"]


def test_the_size_of_a_motion_that_jumps_is_its_rms_over_the_readings(simulated):
    outcome, _, case = simulated(20042, "unlogged", 1, "XYFZ", "random", 400)
    [effect] = outcome.report["effects"]
    assert effect["amplitude_um"] == pytest.approx(case.truth["unlogged"]["rms_3d_um"], rel=0.25)


def test_an_odd_shape_is_located_and_keeps_no_name(simulated):
    outcome, _, case = simulated(20043, "odd", 3, "FXYZ", "random", 400)
    assert outcome.report["verdict"] in ("unexplained", "partly_explained")
    assert all(e["shape"] in ("smooth", "random") for e in outcome.report["effects"])
    found = {d["column"] for d in outcome.report["depends_on"] if d["p"] < 0.01}
    assert found & {c for e in case.truth["effects"] for c in e["driver"].split("*")}


def test_a_period_that_the_grid_aliases_is_said_to_be_aliased(simulated):
    outcome, _, case = simulated(20044, "cyclic", 1, "FXYZ", "grid", 432)
    [truth] = case.truth["effects"]
    assert truth["alias_periods"]
    for effect in outcome.report["effects"]:
        if effect["shape"] == "periodic":
            assert "aliased" in effect["note"] and effect["alias_periods"]
    assert "alias" in json.dumps(outcome.report)
