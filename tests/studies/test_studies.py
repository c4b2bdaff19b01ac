# SPDX-License-Identifier: LGPL-2.1-or-later
"""Studies are functions from a request to a result; what they add to the core's numbers is right."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from sensworkbench.core import workspace
from sensworkbench.core.distributions import Tolerance
from sensworkbench.core.objectives import MeanSquare, Signed
from sensworkbench.core.refusal import Refused
from sensworkbench.core.synthesis import omega
from sensworkbench.core.workspace import Cancelled
from sensworkbench.formats import machine_json
from sensworkbench.studies.error_map import map_errors, map_positions, spanning
from sensworkbench.studies.plan import PlanRequest, plan_study
from sensworkbench.studies.sensitivity import KINDS, SensitivityRequest, kind_of, sensitivity_study

EXAMPLES = Path(__file__).resolve().parents[2] / "resources" / "examples"


@pytest.fixture(scope="module")
def machine():
    return machine_json.load(EXAMPLES / "vertical_machining_centre.json")


def sampled(machine, q, objective, count=200_000):
    """Y of `count` sampled machines at one position."""
    _, columns, _, laws = workspace.error_table(machine)
    random = np.random.default_rng(4)
    assert all(law.distribution == "uniform" for law in laws)
    x = np.array([random.uniform(law.lower, law.upper, count) for law in laws])
    t = omega(machine, columns, q, output=objective.output)[0] @ x
    weights = np.array(objective.weights)
    return weights @ t if objective.power == 1 else weights @ t**2


@pytest.mark.parametrize("objective", [MeanSquare(), Signed(weights=(1, 0, -2))])
def test_the_map_shows_the_error_of_sampled_machines(machine, objective):
    q = np.array([[100.0, -50.0, 80.0]])
    y = sampled(machine, q, objective)
    expected = np.sqrt((y**2).mean()) if objective.power == 1 else np.sqrt(y.mean())
    upper = abs(y.mean()) + 2 * y.std() if objective.power == 1 else np.sqrt(y.mean() + 2 * y.std())
    assert map_errors(machine, objective, q)[0] == pytest.approx(expected, rel=0.01)
    assert map_errors(machine, objective, q, upper=True)[0] == pytest.approx(upper, rel=0.02)


def test_a_slice_stands_still_in_one_joint_and_stays_within_its_travel(machine):
    low, high = machine.travel[1]
    q = map_positions(machine, sliced=1, at=high + 100)
    assert q.shape == (625, 3) and (q[:, 1] == high).all() and np.ptp(q[:, 0]) == np.ptp(machine.travel[0])
    assert map_positions(machine).shape == (343, 3)


MAPPED = [("lathe", 49, 25), ("trunnion", 343, 625), ("rotary_table", 7, 1)]


@pytest.mark.parametrize("name, points, slice_points", MAPPED)
def test_the_map_covers_what_spans_the_workspace(name, points, slice_points):
    machine = machine_json.load(EXAMPLES / f"{name}.json")
    q = map_positions(machine)
    moving = [i for i in range(q.shape[1]) if np.ptp(q[:, i]) > 0]
    assert len(q) == points and tuple(moving) == spanning(machine)
    assert len(map_positions(machine, moving[0], machine.travel[moving[0]].mean())) == slice_points


def test_the_indices_of_a_kind_are_those_of_sampled_machines(machine):
    """Total index of a kind: 1 - V(E(Y | all others)) / V, here by the pick-and-freeze estimate on the same samples."""
    where = (100.0, -50.0, 80.0)
    study = sensitivity_study(machine, SensitivityRequest(at=where))
    labels, columns, _, laws = workspace.error_table(machine)
    random = np.random.default_rng(1)
    a, b = (np.array([random.uniform(law.lower, law.upper, 200_000) for law in laws]) for _ in "ab")
    matrix = omega(machine, columns, np.array([where]))[0]
    y = lambda x: ((matrix @ x) ** 2).sum(axis=0)  # noqa: E731
    kinds = np.array([kind_of(machine, *pair) for pair in zip(labels, columns)])
    assert set(kinds) <= set(KINDS)
    for kind, share in study.conventions[machine.squareness].kinds.items():
        mixed = np.where((kinds == kind)[:, None], b, a)
        total = 0.5 * ((y(a) - y(mixed)) ** 2).mean() / y(a).var()
        assert share.total == pytest.approx(total, abs=0.01), kind


def test_both_conventions_stand_side_by_side_and_the_finding_says_which_error_leads(machine):
    study = sensitivity_study(machine, SensitivityRequest(quadrature=3))
    assert set(study.conventions) == {"direction", "carried"}
    leader = study.conventions["carried"].finding[0]
    found = study.conventions["carried"].sensitivity
    assert leader.code == "finding-leader" and leader.fields["symbol"] == found.symbols[int(np.argmax(found.total))]
    alone = sensitivity_study(machine, SensitivityRequest(quadrature=3, squareness="carried"))
    assert alone.sensitivity.total == pytest.approx(found.total, abs=1e-14)


def test_a_study_can_be_cancelled_and_tells_how_far_it_is(machine):
    told = []
    sensitivity_study(machine, SensitivityRequest(grid=20), progress=lambda part: told.append(part) or True)
    assert told == sorted(told) and told[-1] == 1.0 and len(told) > 1
    with pytest.raises(Cancelled):
        sensitivity_study(machine, SensitivityRequest(grid=20), progress=lambda part: False)


def test_a_plan_study_needs_a_plan_or_a_number(machine):
    with pytest.raises(Refused) as refused:
        plan_study(machine, None)
    assert refused.value.code == "plan-missing"
    with pytest.raises(Refused) as refused:
        plan_study(machine, None, PlanRequest(suggest=3))
    assert refused.value.code == "plan-size" and refused.value.fields["count"] == 3


def test_a_left_handed_machine_with_limits_about_something_else_than_zero_is_warned_of(machine):
    """Its indices depend on how it stands in the file: the signs of its frame are those nearest to the file's axes."""
    joints = [replace(j, direction=tuple(-v for v in j.direction)) if j.name == "Z" else j for j in machine.joints]
    lopsided = {"EYX": Tolerance(0.0, 0.01), "EBX": Tolerance(0.0, 2e-5)}
    left = replace(machine, joints=joints, tolerances=lopsided)
    request = SensitivityRequest(at=(0.0, 0.0, 0.0))
    assert [m.code for m in sensitivity_study(left, request).remarks] == ["frame-left-handed"]
    assert (
        sensitivity_study(
            replace(left, tolerances={s: Tolerance(-0.01, 0.01) for s in machine.all_tolerances}), request
        ).remarks
        == ()
    )
    assert sensitivity_study(replace(machine, tolerances=lopsided), request).remarks == ()
