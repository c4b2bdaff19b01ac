# SPDX-License-Identifier: LGPL-2.1-or-later
"""Allocation against closed forms, scipy's own solvers and enumeration of all grades."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from scipy.optimize import minimize

from sensworkbench.core import allocation_front
from sensworkbench.core.allocation import Grade, GradeCost, PowerCost, Problem, allocate
from sensworkbench.core.refusal import Refused


def problem(rng, n=6, places=1, k=None, tight=0.3):
    load = rng.uniform(0.1, 2, (places, n))
    costs = tuple(PowerCost(rng.uniform(1, 5), k or rng.uniform(0.5, 3), 1e-3, 10.0) for _ in range(n))
    return Problem(load, np.zeros(places), np.full(places, tight), costs)


def test_one_limit_and_one_power_is_the_known_rule():
    """For c/w^k and one limit, w is proportional to (c/A)^(1/(k+2)) (Lagrange)."""
    p = problem(np.random.default_rng(1), k=1.0)
    found = allocate(p)
    ratio = found.widths / np.array([(c.c / a) ** (1 / 3) for c, a in zip(p.costs, p.load[0])])
    assert ratio == pytest.approx(np.full(len(ratio), ratio[0]), rel=1e-6)
    assert found.error[0] == pytest.approx(0.3, rel=1e-6) and found.error[0] <= 0.3
    assert abs(found.gap) < 1e-6


@pytest.mark.parametrize("places", [1, 4, 27])
@pytest.mark.parametrize("seed", range(3))
def test_cost_and_bound_meet_and_no_other_solver_does_better(seed, places):
    p = problem(np.random.default_rng(seed), places=places)
    found = allocate(p)
    assert np.all(found.error <= p.limit * (1 + 1e-12))
    assert -1e-9 < found.gap < 1e-6
    start = np.log(found.widths * 0.8)
    other = minimize(
        lambda x: sum(c.cost(w) for c, w in zip(p.costs, np.exp(x))), start, method="SLSQP",
        constraints={"type": "ineq", "fun": lambda x: p.limit - p.error(np.exp(x))},
        bounds=[(np.log(1e-3), np.log(10.0))] * len(start), options={"maxiter": 500, "ftol": 1e-12},
    )  # fmt: skip
    assert found.cost <= other.fun * (1 + 1e-6)


def test_limits_of_the_widths_hold_and_what_is_free_costs_least():
    costs = (PowerCost(1.0, 1.0, 0.5, 0.6), PowerCost(1.0, 1.0, 0.01, 3.0))
    found = allocate(Problem(np.array([[1.0, 1.0]]), np.zeros(1), np.array([2.0]), costs))
    assert found.widths[0] == pytest.approx(0.6) and found.widths[1] == pytest.approx(np.sqrt(2 - 0.36), rel=1e-6)
    free = allocate(Problem(np.array([[1.0, 1.0]]), np.zeros(1), np.array([100.0]), costs))
    assert free.widths == pytest.approx([0.6, 3.0]) and free.prices == pytest.approx([0.0])


def test_what_cannot_be_met_is_refused_with_what_can():
    p = problem(np.random.default_rng(2), tight=1e-9)
    with pytest.raises(Refused) as refused:
        allocate(p)
    assert refused.value.code == "allocation-out-of-reach" and refused.value.fields["best"] > 0


# -- grades ------------------------------------------------------------------------------------------------------------
def grades(rng, n, places=1, count=4):
    costs = tuple(
        GradeCost(tuple(Grade(f"C{w}", w, 10 / w * rng.uniform(0.7, 1.3)) for w in (0.1, 0.2, 0.4, 0.8)[:count]))
        for _ in range(n)
    )  # fmt: skip
    return Problem(rng.uniform(0.1, 2, (places, n)), np.zeros(places), np.full(places, 0.35), costs)


def enumerated(p):
    best = np.inf
    for choice in itertools.product(*(range(len(c.grades)) for c in p.costs)):
        widths = np.array([c.grades[g].w for c, g in zip(p.costs, choice)])
        if np.all(p.error(widths) <= p.limit):
            best = min(best, sum(c.grades[g].cost for c, g in zip(p.costs, choice)))
    return best


@pytest.mark.parametrize("places", [1, 5])
@pytest.mark.parametrize("seed", range(6))
def test_grades_are_the_cheapest_of_all_choices(seed, places):
    p = grades(np.random.default_rng(seed), 6, places)
    found = allocate(p)
    assert np.all(found.error <= p.limit)
    assert found.cost == pytest.approx(enumerated(p), rel=1e-9)
    assert found.gap <= 1e-6


def test_grades_beside_curves():
    rng = np.random.default_rng(7)
    g, curve = grades(rng, 4), problem(rng, n=3)
    p = Problem(np.hstack([g.load, curve.load]), np.zeros(1), np.array([0.6]), (*g.costs, *curve.costs))
    found = allocate(p)
    assert np.all(found.error <= p.limit * (1 + 1e-12))
    best = np.inf
    for choice in itertools.product(range(4), repeat=4):
        used = sum(p.load[0, i] * p.costs[i].grades[c].w ** 2 for i, c in enumerate(choice))
        if used < 0.6:
            rest = Problem(curve.load, np.array([used]), np.array([0.6]), curve.costs)
            try:
                best = min(best, allocate(rest).cost + sum(p.costs[i].grades[c].cost for i, c in enumerate(choice)))
            except Refused:
                continue
    assert found.cost <= best * (1 + 1e-5)


def test_twenty_four_errors_and_worst_place_of_125_are_solved_with_their_gap():
    rng = np.random.default_rng(9)
    p = problem(rng, n=24, places=125, tight=1.0)
    found = allocate(p)
    assert np.all(found.error <= p.limit * (1 + 1e-12)) and found.gap < 1e-6


# -- what other limits cost --------------------------------------------------------------------------------------------
def rising(p, count):
    """Limits from just above the tightest choice to the widest."""
    ends = [
        [c.grades[i].w if isinstance(c, GradeCost) else (c.lower, c.upper)[i] for c in p.costs] for i in (0, -1)
    ]  # fmt: skip
    low, high = (float(p.error(np.array(widths)).max()) for widths in ends)
    return np.geomspace(low * 1.001, high, count)


@pytest.mark.parametrize("places", [1, 5])
@pytest.mark.parametrize("few", [1, 10**9])
def test_the_front_of_grades_lies_between_its_bound_and_the_cheapest_of_all_choices(places, few, monkeypatch):
    monkeypatch.setattr(allocation_front, "FEW", few)  # with few = 1 no limit is searched to the end
    p = grades(np.random.default_rng(4), 6, places)
    limits = rising(p, 15)
    found = allocation_front.front(p, limits)
    gaps = []
    for limit, (cost, bound) in zip(limits, found):
        cheapest = enumerated(Problem(p.load, p.fixed, np.full(places, limit), p.costs))
        assert bound <= cheapest * (1 + 1e-9) and cheapest <= cost * (1 + 1e-9)
        gaps.append(cost / cheapest - 1)
    assert max(gaps) < (1e-6 if few > 1 or places == 1 else 0.2)
    costs = [c for c, _ in found]
    assert costs == sorted(costs, reverse=True)


@pytest.mark.parametrize("places", [1, 27])
def test_fifty_limits_of_twenty_four_errors_with_four_grades_each_take_less_than_a_second(places):
    import time

    p = grades(np.random.default_rng(5), 24, places)
    limits = rising(p, 50)
    times = []
    for _ in range(2):
        start = time.process_time()
        found = allocation_front.front(p, limits)
        times.append(time.process_time() - start)
    assert len(found) == 50 and all(b <= c for c, b in found)
    assert max(1 - b / c for c, b in found) < (0.03 if places == 1 else 0.15)
    assert min(times) < 1.0


def test_curves_beside_many_grades_are_the_cheapest_for_the_grades_that_were_chosen():
    rng = np.random.default_rng(8)
    g, curve = grades(rng, 12), problem(rng, n=4)
    p = Problem(np.hstack([g.load, curve.load]), np.zeros(1), np.array([1.5]), (*g.costs, *curve.costs))
    limits = rising(p, 12)[3:]
    for limit, (cost, bound) in zip(limits, allocation_front.front(p, limits)):
        best = allocate(Problem(p.load, p.fixed, np.array([limit]), p.costs), branches=300)
        assert best.bound * (1 - 1e-9) <= cost <= best.cost * 1.1 and bound <= best.cost * (1 + 1e-9)
