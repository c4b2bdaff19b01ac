# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is said of readings that cannot show much: one run, runs of one place, columns of one value, few runs."""

from __future__ import annotations

import itertools
from dataclasses import replace

import numpy as np
import pytest

from sensworkbench.closedloop.input_remarks import input_remarks, runs_needed, smallest_p
from sensworkbench.closedloop.settings import DEFAULT
from sensworkbench.closedloop.trace import trace
from sensworkbench.core.refusal import Refused

from .support import both, measured, scattered, session

SIMULATED, MACHINE = both()
PLAIN = measured(SIMULATED, scattered(120, 3), columns=session(120, 1), noise=0.4e-3, seed=2)


def with_runs(labels, **columns):
    """The readings in runs, whose labels (120,) these are, with more columns."""
    return replace(PLAIN, run=np.asarray(labels).astype(str), columns={**PLAIN.columns, **columns})


def codes(readings) -> list[str]:
    return [m.code for m in input_remarks(readings, DEFAULT)]


def test_of_a_column_with_one_value_it_is_said_that_nothing_can_be_concluded():
    readings = replace(PLAIN, columns={**PLAIN.columns, "temp_column": np.full(120, 1.3)})
    [remark] = input_remarks(readings, DEFAULT)
    assert (remark.code, remark.fields["columns"]) == ("input-one-level", ["temp_column"])
    assert codes(PLAIN) == []


def test_of_one_run_it_is_said_that_another_set_up_is_unknown():
    assert codes(with_runs(["a"] * 120)) == ["input-one-run"]
    assert "input-one-run" in [m.code for m in trace(MACHINE, with_runs(["a"] * 120)).remarks]


def test_runs_of_one_place_are_refused_with_the_header_that_helps():
    with pytest.raises(Refused) as refused:
        trace(MACHINE, with_runs(range(120)))
    assert refused.value.code == "fit-runs-of-one"
    assert refused.value.fields["single"] == 120 and "alignment: once" in str(refused.value)


def test_a_run_of_one_place_among_others_is_remarked():
    labels = np.where(np.arange(120) == 60, "2", "1")
    assert codes(replace(with_runs(labels), alignment="offset per run")) == ["input-runs-of-one"]
    assert codes(replace(with_runs(labels), alignment="once")) == []


@pytest.mark.parametrize("values", [(0, 1, 3), (0, 1, 2), (0, 1, 1), (0, 1, 0, 1), (0, 2, 3, 7), (5, 1, 1, 3)])
def test_the_smallest_p_is_the_share_of_the_exchanges_that_change_nothing(values):
    v = np.array(values, dtype=float)
    run = np.arange(120) * len(v) // 120
    readings = with_runs(run, temp_frame=v[run])
    centred = v - v.mean()
    orders = [centred[list(o)] for o in itertools.permutations(range(len(v)))]
    same = sum(np.allclose(o, centred) or np.allclose(o, -centred) for o in orders)
    assert smallest_p(readings, "temp_frame") == pytest.approx(same / len(orders))


def test_few_runs_are_told_how_many_a_name_would_need():
    run = np.arange(120) * 3 // 120
    [remark] = input_remarks(with_runs(run, temp_frame=np.array([0.0, 1.0, 4.0])[run]), DEFAULT)
    assert remark.code == "input-few-runs" and remark.fields["p"] == pytest.approx(1 / 6)
    assert (remark.fields["different"], remark.fields["levels"]) == (5, 9)
    run = np.arange(120) * 5 // 120
    assert codes(with_runs(run, temp_frame=np.array([0.0, 1.0, 4.0, 9.0, 2.5])[run])) == []


def test_the_number_of_runs_follows_the_rate():
    assert [runs_needed(a, False) for a in (0.2, 0.05, 0.01, 0.001)] == [3, 4, 5, 7]
    assert [runs_needed(a, True) for a in (0.2, 0.05, 0.01)] == [5, 7, 9]
