# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whole cases with a known answer: simulated machines of every sort - verdict, names, prediction.

The truth may stand among the rivals that "leave the same trace": then the readings hold no difference.  Predictions are
judged against the fit that knows the effects' forms and must still estimate everything else.
"""

from __future__ import annotations

import json

import pytest

from .judging import LIMIT, listed, triple
from .support import report_of, rms_um

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


def label(case) -> str:
    return f"{case[1]}-{case[0]}"


@pytest.mark.parametrize("setting", NAMED, ids=label)
def test_a_simulated_effect_is_explained_by_its_name(simulated, setting):
    outcome, _, case = simulated(*setting)
    assert report_of(outcome)["verdict"] == "explained"
    truths = [[e, *e.get("equals", ())] for e in case.truth["effects"]]
    assert len(report_of(outcome)["effects"]) == len(truths)
    for names in listed(report_of(outcome)):  # the truth is what is named, or stands among what cannot be told from it
        assert any(triple(e) in names for group in truths for e in group)


@pytest.mark.parametrize("setting", NAMED, ids=label)
def test_a_simulated_machine_is_predicted_as_well_as_by_knowing_the_effect(simulated, setting):
    _, guess, case = simulated(*setting)
    assert not any(e.get("alias_periods") for e in case.truth["effects"])  # such a period has its own test, below
    assert rms_um(guess - case.fresh_truth / 1e3) <= LIMIT * case.truth["fresh_bound_um"]


@pytest.mark.parametrize("setting", QUIET, ids=label)
def test_nothing_is_named_on_a_machine_without_an_effect(simulated, setting):
    outcome, guess, case = simulated(*setting)
    assert (report_of(outcome)["verdict"], report_of(outcome)["effects"]) == ("nothing_to_explain", [])
    assert rms_um(guess - case.fresh_truth / 1e3) <= LIMIT * case.truth["fresh_bound_um"]


def test_a_column_that_nobody_logged_is_never_explained(simulated):
    outcome, _, case = simulated(20041, "missing", 1, "XYFZ", "random", 400)
    assert case.truth["missing"]
    assert report_of(outcome)["verdict"] in ("unexplained", "partly_explained")
    for effect in report_of(outcome)["effects"]:
        assert "t" in effect["driver"].split("*") or effect["shape"] == "random"


def test_a_driver_that_jumps_from_reading_to_reading_shows_as_one_body_s_motion(simulated):
    outcome, _, case = simulated(20042, "unlogged", 1, "XYFZ", "random", 400)
    assert report_of(outcome)["verdict"] == "partly_explained"
    [effect] = report_of(outcome)["effects"]
    assert effect["component"] == case.truth["unlogged"]["component"]


def test_the_size_of_a_motion_that_jumps_is_its_rms_over_the_readings(simulated):
    outcome, _, case = simulated(20042, "unlogged", 1, "XYFZ", "random", 400)
    [effect] = report_of(outcome)["effects"]
    assert effect["amplitude_um"] == pytest.approx(case.truth["unlogged"]["rms_3d_um"], rel=0.25)


def test_an_odd_shape_is_located_and_keeps_no_name(simulated):
    outcome, _, case = simulated(20043, "odd", 3, "FXYZ", "random", 400)
    assert report_of(outcome)["verdict"] in ("unexplained", "partly_explained")
    assert all(e["shape"] in ("smooth", "random") for e in report_of(outcome)["effects"])
    found = {d["column"] for d in report_of(outcome)["depends_on"] if d["p"] < 0.01}
    assert found & {c for e in case.truth["effects"] for c in e["driver"].split("*")}


def test_a_period_that_the_grid_aliases_is_said_to_be_aliased(simulated):
    outcome, _, case = simulated(20044, "cyclic", 1, "FXYZ", "grid", 432)
    [truth] = case.truth["effects"]
    assert truth["alias_periods"]
    for effect in report_of(outcome)["effects"]:
        if effect["shape"] == "periodic":
            assert "aliased" in effect["note"] and effect["alias_periods"]
    assert "alias" in json.dumps(report_of(outcome))


def test_gross_outliers_of_a_simulated_case_are_listed_and_left_unnamed(simulated):
    outcome, _, case = simulated(*NAMED[2])
    rows = case.truth["outlier_rows"]
    assert len(rows) > 3  # row 0 is line 2: a header, and lines count from 1
    assert [o["line"] for o in report_of(outcome)["outliers"]] == [row + 2 for row in rows]
    assert len(report_of(outcome)["effects"]) == len(case.truth["effects"])
