# SPDX-License-Identifier: LGPL-2.1-or-later
"""The study of the tracing: its cases are what they say they are, and its tables count right."""

from __future__ import annotations

import math

import numpy as np
import pytest

from benchmarks import study_designs, tracing_study
from sensworkbench.closedloop.design import design
from tests.closedloop.support import least_squares


@pytest.mark.parametrize("name", list(study_designs.DESIGNS))
def test_a_null_is_the_same_for_the_same_seed_and_holds_no_column_of_its_own(name):
    one, again, other = (study_designs.null(name, seed) for seed in (11, 11, 12))
    assert np.array_equal(one.readings.value, again.readings.value)
    assert not np.array_equal(one.readings.value[:20], other.readings.value[:20])
    assert not [c for c in one.readings.columns if c.startswith("_")]
    assert one.truth is None


@pytest.mark.parametrize("kind", list(study_designs.EFFECTS))
def test_an_effect_is_as_large_as_stated_beside_the_declared_model(kind):
    sizes = []
    for size in (1.3, 13.0):  # the same machine and noise need not come: each is judged on its own
        case = study_designs.with_effect(kind, size, 3)
        matrix = design(case.machine, case.readings).matrix
        left = least_squares(matrix, case.readings.value)[1] / (case.readings.rows - 57) / study_designs.SIGMA**2
        sizes.append(math.sqrt(max(left - 1, 0)))
    assert sizes[1] == pytest.approx(13.0, rel=0.12)
    assert sizes[0] == pytest.approx(1.3, rel=0.25)


def test_every_case_stands_once_in_the_list_of_jobs():
    jobs = tracing_study.jobs(5, 2, 100)
    assert len(jobs) == len(set(jobs)) == 5 * len(study_designs.DESIGNS) + 2 * len(study_designs.EFFECTS) * 8
    assert {seed for _, size, seed in jobs if not size} == set(range(100, 105))
    assert {seed for _, size, seed in jobs if size} == {100, 101}


def test_the_upper_limit_of_a_proportion_is_that_of_clopper_and_pearson():
    assert tracing_study.upper(0, 300) == pytest.approx(1 - 0.05 ** (1 / 300), rel=1e-9)
    assert tracing_study.upper(5, 100) == pytest.approx(0.1022528, abs=2e-6)  # beta quantile .95 of (6, 95)
    assert tracing_study.upper(4, 4) == 1.0


def test_the_size_found_in_half_of_the_runs():
    shares = {0.1: 0, 0.2: 2, 0.4: 8, 0.8: 10}
    rows = [{"size": s, "right": i < k} for s, k in shares.items() for i in range(10)]
    assert tracing_study.half_power(rows) == pytest.approx(0.2 * 2**0.5)
    assert math.isnan(tracing_study.half_power([{"size": 0.1, "right": False}]))


def test_a_known_form_is_found_where_its_chi_square_reaches_the_limit_over_all_candidates():
    size = tracing_study.known_form(25_000, 600, 1)
    assert size == pytest.approx(0.209, abs=0.002)  # 600 displacements, Bonferroni over 25,000 at .01


def test_a_study_that_was_stopped_goes_on(tmp_path, monkeypatch, capsys):
    done = []

    def fake(name, size, seed):
        done.append((name, size, seed))
        return {"case": name, "size": size, "seed": seed, "failed": "not computed", "seconds": 0.0}

    monkeypatch.setattr(tracing_study, "run", fake)
    arguments = ["--nulls", "2", "--each", "0", "--out", str(tmp_path / "study.jsonl")]
    assert tracing_study.main([*arguments, "--only", "white"]) == 0
    with (tmp_path / "study.jsonl").open("a", encoding="utf-8") as stream:
        stream.write('{"case": "white", "si')  # the line at which it was killed
    assert tracing_study.main(arguments) == 0
    assert len(done) == len(set(done)) == 2 * len(study_designs.DESIGNS)
    rows = tracing_study.read(tmp_path / "study.jsonl")
    assert len(rows) == len(done)
    assert "28 nulls, 0 effects, 28 failed" in tracing_study.report(rows)
    assert "28 failed" in capsys.readouterr().out
