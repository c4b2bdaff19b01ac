# SPDX-License-Identifier: LGPL-2.1-or-later
"""Allocation by what an optimum must meet: the conditions of Karush, Kuhn and Tucker for curves, the count of all
choices for grades, bounds that are never above the best choice, and the steps of the search worked by hand."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from sensworkbench.core import allocation
from sensworkbench.core.allocation import Allocation, Grade, GradeCost, PowerCost, Problem, allocate
from sensworkbench.core.refusal import Refused


def curves(seed, n=7, places=5, fixed=0.0):
    rng = np.random.default_rng(seed)
    load = rng.uniform(0.1, 2, (places, n)) * rng.uniform(0.3, 1, (places, 1))
    costs = tuple(PowerCost(rng.uniform(0.5, 5), rng.uniform(0.5, 3), 0.05, 0.9) for _ in range(n))
    return Problem(load, np.full(places, fixed), np.full(places, 0.3 + fixed), costs)


@pytest.mark.parametrize("fixed", [0.0, 0.7])
@pytest.mark.parametrize("seed", range(12))
def test_curves_meet_the_conditions_of_an_optimum(seed, fixed):
    p = curves(seed, places=1 + seed, fixed=fixed)
    found = allocate(p)
    assert (found.prices >= 0).all() and found.grades == (None,) * 7
    assert found.error == pytest.approx(fixed + p.load @ found.widths**2, rel=1e-12)
    assert (found.error <= p.limit * (1 + 1e-12)).all()
    slack = p.limit - found.error
    assert found.prices @ slack == pytest.approx(0, abs=1e-5 * found.cost)  # what is not needed has no price
    for i, (cost, w) in enumerate(zip(p.costs, found.widths)):
        falls, rises = cost.k * cost.c / w ** (cost.k + 1), 2 * w * float(found.prices @ p.load[:, i])
        if cost.lower * 1.0001 < w < cost.upper * 0.9999:
            assert falls == pytest.approx(rises, rel=1e-3)
        elif w <= cost.lower * 1.0001:
            assert rises >= falls * (1 - 1e-3)
        else:
            assert rises <= falls * (1 + 1e-3)
        assert found.costs[i] == pytest.approx(cost.c / w**cost.k, rel=1e-14)
    assert -1e-9 < found.gap < 1e-6 and found.bound <= found.cost * (1 + 1e-9)


def test_prices_are_what_a_smaller_limit_costs():
    p = curves(3, places=4)
    found, h = allocate(p), 1e-3
    for place in range(4):
        step = h * 0.3 * (np.arange(4) == place)
        more, less = (allocate(Problem(p.load, p.fixed, p.limit + s, p.costs)).cost for s in (step, -step))
        slope = (less - more) / (2 * h * 0.3)
        assert found.prices[place] == pytest.approx(slope, rel=2e-2, abs=2e-3 * found.prices.max())


def test_the_best_width_at_a_price_minimises_cost_and_error_together():
    cost, widths = PowerCost(2.0, 1.5, 0.1, 4.0), np.linspace(0.1, 4.0, 400_001)
    for price in (1e-6, 0.01, 0.7, 5.0, 1e6):
        total = 2.0 / widths**1.5 + price * widths**2
        assert cost.best(price) == pytest.approx(widths[np.argmin(total)], abs=2e-5)
    assert cost.best(0.0) == cost.best(-1.0) == 4.0 and cost.cost(4.0) == 0.25
    grades = GradeCost((Grade("a", 1.0, 9.0), Grade("b", 2.0, 5.0), Grade("c", 3.0, 1.0)))
    assert [grades.best(p, (0, 1, 2)) for p in (0.0, 0.79, 0.81, 1.34)] == [2, 2, 1, 0]
    assert grades.best(0.0, (0, 1)) == 1
    assert [g.name for g in GradeCost((Grade("x", 1.0, 3.0), Grade("y", 1.0, 2.0))).grades] == ["y", "x"]


def test_gap_and_room():
    made = Allocation(np.ones(2), (None, None), np.array([3.0, 5.0]), 6.0, np.zeros(1), np.zeros(1))
    assert made.cost == 8.0 and made.gap == 0.25
    free = Allocation(np.ones(1), (None,), np.zeros(1), 0.0, np.zeros(1), np.zeros(1))
    assert free.gap == 0.0
    p = Problem(np.array([[1.0, 2.0]]), np.array([0.5]), np.array([3.0]), ())
    assert p.room().tolist() == [2.5] and p.error([2.0, 3.0]).tolist() == [22.5]


def test_what_costs_nothing_is_left_as_wide_as_it_may_be():
    costs = (PowerCost(0.0, 1.0, 0.1, 2.0), PowerCost(1.0, 1.0, 0.1, 2.0))
    found = allocate(Problem(np.array([[0.01, 1.0]]), np.zeros(1), np.array([1.0]), costs))
    assert found.error[0] <= 1.0 and found.cost == pytest.approx(1.0, rel=6e-3)
    assert allocate(Problem(np.array([[0.0, 1.0]]), np.zeros(1), np.array([1.0]), costs)).cost == pytest.approx(1.0)


@pytest.mark.parametrize("scale", [1e-9, 1.0, 1e9])
def test_units_of_cost_do_not_move_the_widths(scale):
    p = curves(5)
    other = Problem(p.load, p.fixed, p.limit, tuple(PowerCost(scale * c.c, c.k, c.lower, c.upper) for c in p.costs))
    assert allocate(other).widths == pytest.approx(allocate(p).widths, rel=1e-5)
    assert allocate(other).prices == pytest.approx(scale * allocate(p).prices, rel=1e-3)


def test_a_limit_that_is_met_only_just_is_met():
    costs = (PowerCost(1.0, 1.0, 0.5, 2.0), PowerCost(1.0, 1.0, 0.5, 2.0))
    load = np.array([[1.0, 1.0], [2.0, 1.0]])
    found = allocate(Problem(load, np.zeros(2), np.array([0.5, 0.75]), costs))
    assert found.widths == pytest.approx([0.5, 0.5])
    with pytest.raises(Refused) as refused:
        allocate(Problem(load * 1e-6, np.zeros(2), np.array([0.5, 0.74]) * 1e-6, costs))
    assert refused.value.code == "allocation-out-of-reach"
    assert refused.value.fields["best"] == pytest.approx(1e3 * np.sqrt(0.75e-6))
    assert refused.value.fields["limit"] == pytest.approx(1e3 * np.sqrt(0.74e-6))


def test_scaling_down_stops_where_every_limit_is_met():
    costs = (PowerCost(1.0, 1.0, 0.8, 2.0), GradeCost((Grade("a", 0.5, 1.0),)), PowerCost(1.0, 1.0, 0.1, 2.0))
    p = Problem(np.eye(3)[2:] + np.eye(3)[:1] + np.eye(3)[1:2], np.zeros(1), np.array([1.25]), costs)
    found = allocation._tightened(p, np.array([1.0, 0.5, 1.0]))
    assert found == pytest.approx([0.8, 0.5, 0.6]) and p.error(found)[0] <= 1.25  # .64 + .25 + .36: the rest is w
    assert p.error(found)[0] == pytest.approx(1.25, rel=1e-12)
    wide = np.array([0.5, 0.5, 0.5])
    assert allocation._tightened(p, wide) is wide


# -- grades ------------------------------------------------------------------------------------------------------------
def graded(seed, n=6, places=3, fixed=0.1):
    rng = np.random.default_rng(seed)
    costs = []
    for _ in range(n):
        w = np.sort(rng.uniform(0.1, 0.9, int(rng.integers(1, 5))))
        costs.append(GradeCost(tuple(Grade(f"g{v:.3f}", v, rng.uniform(0.5, 1.5) / v) for v in w)))
    load = rng.uniform(0.1, 2, (places, n))
    tight = np.array([c.grades[0].w for c in costs])
    limit = fixed + (load @ tight**2).max() * rng.uniform(1.1, 4)
    return Problem(load, np.full(places, fixed), np.full(places, limit), tuple(costs))


def choices(p):
    """(cost, error) of every choice of grades."""
    for some in itertools.product(*(range(len(c.grades)) for c in p.costs)):
        picked = [c.grades[g] for c, g in zip(p.costs, some)]
        yield sum(g.cost for g in picked), p.fixed + p.load @ np.array([g.w**2 for g in picked])


def cheapest(p):
    return min(cost for cost, error in choices(p) if (error <= p.limit).all())


@pytest.mark.parametrize("seed", range(25))
def test_grades_of_any_width_and_cost_are_the_cheapest_of_all_choices(seed):
    p = graded(seed)
    found = allocate(p)
    assert found.cost == pytest.approx(cheapest(p), rel=2e-7)
    assert (found.error <= p.limit).all() and found.gap == pytest.approx(allocation.GAP, rel=1e-3)
    picked = [c.grades[g] for c, g in zip(p.costs, found.grades)]
    assert found.widths.tolist() == [g.w for g in picked] and found.costs.tolist() == [g.cost for g in picked]


@pytest.mark.parametrize("seed", range(8))
def test_grades_beside_curves_are_the_cheapest_of_all_choices(seed):
    g, c = graded(seed, 3, 2, 0.0), curves(seed, 2, 2)
    limit = g.limit + 0.3
    p = Problem(np.hstack([g.load, c.load]), np.zeros(2), limit, (*g.costs, *c.costs))
    best = np.inf
    for cost, error in choices(Problem(g.load, np.zeros(2), limit, g.costs)):
        try:
            best = min(best, cost + allocate(Problem(c.load, error, limit, c.costs)).cost)
        except Refused:
            continue
    found = allocate(p)
    assert found.cost == pytest.approx(best, rel=2e-6) and (found.error <= limit * (1 + 1e-12)).all()
    assert found.bound <= best * (1 + 1e-9)


@pytest.mark.parametrize("seed", range(6))
def test_a_search_that_is_ended_early_tells_how_far_it_may_be_from_the_best(seed, monkeypatch):
    p = graded(100 + seed, 7, 4)
    best = cheapest(p)
    monkeypatch.setattr(allocation, "BRANCHES", 1)
    found = allocate(p)
    assert found.bound <= best * (1 + 1e-12) <= found.cost * (1 + 1e-9) and (found.error <= p.limit).all()


def test_progress_is_told_and_can_end_the_search():
    load = np.random.default_rng(1).uniform(1, 2, 30)  # what an error costs is what it adds: all choices look alike
    costs = tuple(GradeCost((Grade("fine", 0.01, 1 + a), Grade("wide", 1.0, 1.0))) for a in load)
    p = Problem(load[None], np.zeros(1), np.array([0.47 * load.sum()]), costs)
    told = []
    found = allocate(p, lambda share: told.append(share) or len(told) < 3)
    assert told == pytest.approx([50 / 20_000, 100 / 20_000, 150 / 20_000])
    assert found.gap > allocation.GAP and found.bound < found.cost and (found.error <= p.limit).all()


def two(costs=((5.0, 1.0), (2.0, 1.0)), limit=5.5):
    """Two errors with load 1 and the grades of width 1 and 2 at these costs."""
    some = tuple(GradeCost((Grade("fine", 1.0, a), Grade("wide", 2.0, b))) for a, b in costs)
    return Problem(np.ones((1, 2)), np.zeros(1), np.array([limit]), some)


def repaired(p, allowed=((0, 1), (0, 1))):
    return allocation._repaired(p, allowed, np.array([2.0, 2.0]), [1, 1])


def test_a_choice_is_repaired_where_it_buys_most():
    total, widths, grades = repaired(two())  # both gain 2.5 of the 2.5 that are too much: the cheaper one is taken
    assert (total, widths.tolist(), grades) == (3.0, [2.0, 1.0], [1, 0])
    assert repaired(two(), ((0, 1), (1,)))[0] == 6.0  # the other grade is not allowed
    assert repaired(two(limit=2.0))[0] == 7.0 and repaired(two(limit=8.0))[0] == 2.0
    assert repaired(two(limit=1.9)) is None
    unequal = Problem(np.array([[1.0, 0.5]]), np.zeros(1), np.array([3.0]), two(((3.0, 1.0), (2.9, 1.0))).costs)
    assert repaired(unequal)[2] == [0, 1]  # 3 for 2 rather than 1.5 for 1.9


def test_the_split_is_where_two_grades_are_nearest_in_worth():
    p = two(((4.0, 1.0), (9.0, 1.0)))
    prices = np.array([1.1])  # worth of the grades: 5.1 and 5.4; 10.1 and 5.4
    assert allocation._split(p, ((0, 1), (0, 1)), prices, [0, 1]) == [(0, (0,)), (0, (1,))]
    assert allocation._split(p, ((0,), (0, 1)), prices, [0, 1]) == [(1, (0,)), (1, (1,))]
    assert allocation._split(p, ((0,), (1,)), prices, [0, 1]) is None
    three = GradeCost((Grade("a", 1.0, 9.0), Grade("b", 2.0, 5.0), Grade("c", 3.0, 1.0)))
    mixed = Problem(np.ones((1, 2)), np.zeros(1), np.ones(1), (PowerCost(1, 1, 1, 2), three))
    assert allocation._split(mixed, (None, (0, 1, 2)), np.array([0.8]), [None, 2]) == [(1, (0, 1)), (1, (2,))]
    assert allocation._split(mixed, (None, (0, 1, 2)), np.array([1.4]), [None, 2]) == [(1, (0,)), (1, (1, 2))]
