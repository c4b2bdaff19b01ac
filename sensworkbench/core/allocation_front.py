# SPDX-License-Identifier: LGPL-2.1-or-later
"""What other limits cost: for each of many limits the cost of a choice that meets it, and a bound below all of them.

Few choices of grades are searched as in `allocation`.  With many, the search of every limit would be too long: where
one limit is to be met, the knapsack problem is solved with the error counted in whole steps, rounded up (a choice that
meets the limit) and rounded down (a bound); where there are more limits, the dual gives the bound, and its choice is
repaired.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from .allocation import GradeCost, Problem, _Dual, _repaired, _solved, allocate

FEW = 300  # choices of grades that are searched for every limit
STEPS = 10_000  # of the error that may be added
BRANCHES = 6  # parts of the search with which a gap larger than NEAR is made smaller
NEAR = 0.01
ROUNDS, SWEEPS = 3, 2  # of the dual where several limits are to be met


def front(
    problem: Problem, squares: Sequence[float], tell: Callable[[float], bool] | None = None
) -> list[tuple[float, float]]:
    """(cost, bound) for each of the limits `squares` (mean square, the same at all places), which must rise.

    tell : called with the part done; a false answer ends it with what there is.  Refuses a limit that cannot be met.
    """
    choices = [tuple(range(len(c.grades))) if isinstance(c, GradeCost) else None for c in problem.costs]
    few = math.prod(len(c) for c in choices if c is not None) <= FEW
    table = _Dual(problem, choices)
    found = []
    for i, square in enumerate(squares):
        one = replace(problem, limit=np.full(len(problem.limit), float(square)))
        if few:
            best = allocate(one)
            found.append((best.cost, best.bound))
        else:
            found.append(_estimated(one, choices, table))
        if tell is not None and not tell((i + 1) / len(squares)):
            break
    costs = np.minimum.accumulate([c for c, _ in found])  # what meets a tighter limit meets a looser one
    bounds = np.maximum.accumulate([b for _, b in found][::-1])[::-1]
    return [(float(c), min(float(b), float(c))) for c, b in zip(costs, bounds)]


def _estimated(problem: Problem, choices, table: _Dual) -> tuple[float, float]:
    """(cost of a choice that meets the limits, bound)."""
    single = len(problem.limit) == 1
    bound, _, widths, grades = _solved(problem, choices) if single else _solved(problem, choices, ROUNDS, SWEEPS)
    found = _repaired(problem, choices, widths, grades)
    if found is None:
        cost = allocate(problem).cost
        found = (cost, widths, grades)
    found = _loosened(problem, table, found)
    if len(table.curves):
        cost = min(found[0], _curves(problem, table, found))
    else:
        cost = found[0]
    if single and not len(table.curves):
        cost = min(cost, _knapsack(problem, table, np.ceil))
        bound = max(bound, _knapsack(problem, table, np.floor))
    if single and cost - bound > NEAR * abs(cost):
        searched = allocate(problem, branches=BRANCHES)
        cost, bound = min(cost, searched.cost), max(bound, searched.bound)
    return cost, bound


def _loosened(problem: Problem, table: _Dual, found):
    """(cost, widths, grades) with grades loosened, that which saves most first, as long as every limit is met."""
    cost, widths, grades = found[0], found[1].copy(), list(found[2])
    graded = table.graded
    if not len(graded):
        return found
    load, every = problem.load[:, graded], np.arange(len(graded))
    column = np.array([int(np.flatnonzero(table.number[r] == grades[i])[0]) for r, i in enumerate(graded)])
    while True:
        room = problem.limit - problem.error(widths)
        saved = table.price[every, column][:, None] - table.price
        more = load[:, :, None] * (table.square - table.square[every, column][:, None])
        fits = (more <= room[:, None, None]).all(axis=0) & (saved > 0)
        if not fits.any():
            return cost, widths, grades
        r, g = np.unravel_index(int(np.where(fits, saved, -1.0).argmax()), saved.shape)
        cost, column[r] = cost - float(saved[r, g]), g
        i = int(graded[r])
        grades[i], widths[i] = int(table.number[r, g]), table.width[r, g]


def _curves(problem: Problem, table: _Dual, found) -> float:
    """Cost with these grades and the cheapest widths of the curves beside them."""
    _, widths, _ = found
    graded, curves = table.graded, table.curves
    fixed = problem.fixed + problem.load[:, graded] @ np.square(widths[graded])
    rest = Problem(problem.load[:, curves], fixed, problem.limit, tuple(problem.costs[i] for i in curves))
    bought = sum(problem.costs[i].grades[found[2][i]].cost for i in graded)
    return float(bought) + allocate(rest).cost


def _knapsack(problem: Problem, table: _Dual, rounded) -> float:
    """The least cost with the error of every grade rounded to whole steps of the limit; inf where none meets it."""
    room = float(problem.room()[0])
    used = problem.load[0][table.graded][:, None] * table.square
    needs = rounded(used / room * STEPS * (1 - 1e-12 if rounded is np.floor else 1 + 1e-12))
    least = np.zeros(STEPS + 1)  # the least cost with at most so many steps
    for need, price in zip(needs, table.price):
        after = np.full(STEPS + 1, np.inf)
        for n, p in zip(need.tolist(), price.tolist()):
            if n <= STEPS and p < np.inf:
                n = int(n)
                np.minimum(after[n:], least[: STEPS + 1 - n] + p, out=after[n:])
        least = after
    return float(least[-1])
