# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tolerance allocation: the cheapest tolerances whose mean square error stays below a limit, shown by its dual.

E[Y] at a position is m + sum_i A_ii var_i, linear in the variances.  With a cost that falls convexly in the variance
(c / w^k of the half width w) the problem is convex and its Lagrange dual is solved error by error, so that a lower
bound stands beside every answer; with grades to choose from, that bound guides branch and bound.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from ..messages import Refused
from .units import um

GAP = 1e-7  # relative distance of cost and bound at which the convex problem is solved
ROUNDS = 60  # of adding the worst position
SWEEPS = 200  # over the prices of the positions
BRANCHES = 20_000


@dataclass(frozen=True)
class PowerCost:
    """Cost c / w^k of a half width w in [lower, upper] (mm or rad; currency of c).  k > 0."""

    c: float
    k: float
    lower: float
    upper: float

    def __post_init__(self):
        if not (self.c >= 0 and self.k > 0 and 0 < self.lower <= self.upper < np.inf):
            raise Refused("cost-power-invalid", c=self.c, k=self.k, lower=self.lower, upper=self.upper)

    def cost(self, w: float) -> float:
        """Cost of the half width w."""
        return self.c / w**self.k

    def best(self, price: float) -> float:
        """The half width that minimises c / w^k + price * w²."""
        if price <= 0:
            return self.upper
        return float(np.clip((self.k * self.c / (2 * price)) ** (1 / (self.k + 2)), self.lower, self.upper))


@dataclass(frozen=True)
class Grade:
    """A grade that can be bought: half width w (mm or rad) and its cost."""

    name: str
    w: float
    cost: float


@dataclass(frozen=True)
class GradeCost:
    """A choice of grades."""

    grades: tuple[Grade, ...]

    def __post_init__(self):
        if not self.grades or any(not (g.w > 0 and np.isfinite(g.w) and np.isfinite(g.cost)) for g in self.grades):
            raise Refused("cost-grades-invalid")
        object.__setattr__(self, "grades", tuple(sorted(self.grades, key=lambda g: (g.w, g.cost))))

    def best(self, price: float, allowed: Sequence[int]) -> int:
        """The allowed grade that minimises cost + price * w²."""
        return min(allowed, key=lambda i: self.grades[i].cost + price * self.grades[i].w ** 2)


Cost = PowerCost | GradeCost


@dataclass(frozen=True)
class Problem:
    """What is to be met: load (P, n) mean square error at P places per squared half width; fixed (P,) what stays
    whatever is chosen; limit (P,), mean square error.  costs (n)."""

    load: np.ndarray
    fixed: np.ndarray
    limit: np.ndarray
    costs: tuple[Cost, ...]

    def room(self) -> np.ndarray:
        """(P,) what the chosen tolerances may add."""
        return self.limit - self.fixed

    def error(self, widths) -> np.ndarray:
        """(P,) mean square error with these half widths (n,)."""
        return self.fixed + self.load @ np.square(widths)


@dataclass(frozen=True)
class Allocation:
    """widths (n,) half widths; grades (n): number of the grade, or None; cost of each (n,) and in all; bound: no choice
    that meets the limits costs less; error (P,) mean square; prices (P,): cost per unit of each limit (the dual)."""

    widths: np.ndarray
    grades: tuple[int | None, ...]
    costs: np.ndarray
    bound: float
    error: np.ndarray
    prices: np.ndarray

    @property
    def cost(self) -> float:
        """Sum of the costs of all tolerances."""
        return float(self.costs.sum())

    @property
    def gap(self) -> float:
        """Relative distance between the cost and the bound."""
        return (self.cost - self.bound) / max(abs(self.cost), 1e-300)


def allocate(problem: Problem, progress: Callable[[float], bool] | None = None, branches: int = BRANCHES) -> Allocation:
    """The cheapest choice that meets every limit.  Refuses where even the tightest tolerances do not.

    progress : called with the part done, for grades; a false answer ends the search with the best choice so far, whose
    gap says how far it may be from the cheapest; so do more than `branches` parts of the search.
    """
    tightest = np.array([c.grades[0].w if isinstance(c, GradeCost) else c.lower for c in problem.costs])
    missing = problem.error(tightest) - problem.limit
    if missing.max() > 1e-12 * np.abs(problem.limit).max():
        worst = int(np.argmax(missing))
        raise Refused(
            "allocation-out-of-reach",
            best=float(um(np.sqrt(problem.error(tightest)[worst]))), limit=float(um(np.sqrt(problem.limit[worst]))),
        )  # fmt: skip
    choices = [tuple(range(len(c.grades))) if isinstance(c, GradeCost) else None for c in problem.costs]
    if all(c is None for c in choices):
        return _continuous(problem)
    return _branch_and_bound(problem, choices, progress, branches)


# -- the dual ----------------------------------------------------------------------------------------------------------
class _Dual:
    """min over the widths of cost + sum_p price_p (load_p w² - room_p): concave in the prices, solved per error.

    choices (n): numbers of the grades that are allowed, or None for a curve.
    """

    def __init__(self, problem: Problem, choices):
        self.problem, self.choices = problem, choices
        self.room = problem.room()
        costs = problem.costs
        self.curves = np.array([i for i, a in enumerate(choices) if a is None], dtype=int)
        self.c, self.k, self.lower, self.upper = (
            np.array([getattr(costs[i], name) for i in self.curves]) for name in ("c", "k", "lower", "upper")
        )
        self.graded = np.array([i for i, a in enumerate(choices) if a is not None], dtype=int)
        most = max((len(choices[i]) for i in self.graded), default=0)
        shape = (len(self.graded), most)
        self.number, self.price = np.zeros(shape, dtype=int), np.full(shape, np.inf)
        self.width = np.zeros(shape)
        for row, i in enumerate(self.graded):
            for column, g in enumerate(choices[i]):
                grade = costs[i].grades[g]
                self.number[row, column] = g
                self.width[row, column], self.price[row, column] = grade.w, grade.cost
        self.square = self.width**2

    def at(self, rows, prices):
        """(value, half widths, grades) at prices of the places `rows`; the hull of grades is taken."""
        weights = prices @ self.problem.load[rows]
        widths, grades = np.empty(len(weights)), [None] * len(weights)
        value = -float(prices @ self.room[rows])
        if len(self.curves):
            w = weights[self.curves]
            with np.errstate(divide="ignore", over="ignore", invalid="ignore"):
                found = (self.k * self.c / (2 * np.maximum(w, 0))) ** (1 / (self.k + 2))
            found = np.where(w > 0, np.clip(found, self.lower, self.upper), self.upper)
            widths[self.curves] = found
            value += float((self.c / found**self.k + w * found**2).sum())
        if len(self.graded):
            worth = self.price + weights[self.graded][:, None] * self.square
            best = worth.argmin(axis=1)
            every = np.arange(len(best))
            value += float(worth[every, best].sum())
            for i, g in zip(self.graded.tolist(), self.number[every, best].tolist()):
                grades[i] = g
            widths[self.graded] = self.width[every, best]
        return value, widths, grades


def _maximised(dual: _Dual, rows, start, sweeps: int = SWEEPS) -> tuple[float, np.ndarray, np.ndarray, list]:
    """Prices (>= 0) that maximise the dual over the places `rows`, coordinate by coordinate with a bisection each."""
    prices = np.array(start, dtype=float)
    load, room = dual.problem.load[rows], dual.room[rows]
    best = dual.at(rows, prices)
    for _ in range(sweeps):
        before = best[0]
        for p in range(len(rows)):
            prices[p] = _bisected(dual, rows, prices, p, load[p], room[p])
        best = dual.at(rows, prices)
        if len(rows) == 1 or best[0] - before <= 1e-3 * GAP * max(abs(best[0]), 1e-300):
            break
        prices, best = _newton(dual, rows, prices, best)
    return best[0], prices, best[1], best[2]


def _newton(dual: _Dual, rows, prices, best):
    """Newton steps on the dual over the prices above zero, halved until they gain.

    The square v of the half width of a curve falls by v / ((k/2 + 1) price) per unit of its price.
    """
    load, room = dual.problem.load[rows], dual.room[rows]
    for _ in range(30):
        widths = best[1]
        weights, v = prices @ load, np.square(widths)
        slope = np.zeros(len(v))
        for i, cost in enumerate(dual.problem.costs):
            if dual.choices[i] is None and cost.lower < widths[i] < cost.upper and weights[i] > 0:
                slope[i] = v[i] / ((cost.k / 2 + 1) * weights[i])
        gradient = load @ v - room
        free = np.flatnonzero((prices > 0) | (gradient > 0))
        if not len(free) or not slope.any():
            break
        hessian = (load[free] * slope) @ load[free].T
        step = np.zeros(len(prices))
        step[free] = np.linalg.lstsq(hessian, gradient[free], rcond=1e-12)[0]
        for _ in range(30):
            trial = np.maximum(prices + step, 0.0)
            found = dual.at(rows, trial)
            if found[0] >= best[0]:
                break
            step /= 2
        else:
            break
        gained = found[0] - best[0]
        prices, best = trial, found
        if gained <= 1e-4 * GAP * max(abs(best[0]), 1e-300):
            break
    return prices, best


def _bisected(dual, rows, prices, p, load, room) -> float:
    """The price of one place at which its limit is just met (0 where it is met for nothing)."""

    def excess(price):
        trial = prices.copy()
        trial[p] = price
        return float(load @ np.square(dual.at(rows, trial)[1])) - room

    if excess(0.0) <= 0:
        return 0.0
    high = max(prices[p], 1.0)
    for _ in range(400):
        if excess(high) <= 0:
            break
        high *= 4
    low = 0.0
    for _ in range(200):
        middle = (low + high) / 2 if low == 0 or high / low > 4 else np.sqrt(low * high)
        if middle in (low, high):
            break
        low, high = (low, middle) if excess(middle) <= 0 else (middle, high)
    return high


def _solved(problem: Problem, choices, rounds: int = ROUNDS, sweeps: int = SWEEPS):
    """(bound, prices (P,), widths, grades) of the relaxed problem: places are added as they are violated most.

    Fewer rounds and sweeps give a bound that is lower than need be.
    """
    dual = _Dual(problem, choices)
    rows, prices = [], np.zeros(0)
    value, widths, grades = dual.at(np.array([], dtype=int), prices)
    for _ in range(rounds):
        excess = (problem.error(widths) - problem.limit) / np.maximum(np.abs(dual.room), 1e-300)
        worst = int(np.argmax(excess))
        if excess[worst] <= GAP or worst in rows:
            break
        rows.append(worst)
        value, prices, widths, grades = _maximised(dual, np.array(rows), np.append(prices, 0.0), sweeps)
    full = np.zeros(len(problem.limit))
    full[rows] = prices
    return value, full, widths, grades


def _continuous(problem: Problem) -> Allocation:
    bound, prices, widths, _ = _solved(problem, [None] * len(problem.costs))
    widths = _tightened(problem, widths)
    costs = np.array([c.cost(w) for c, w in zip(problem.costs, widths)])
    return Allocation(widths, (None,) * len(widths), costs, bound, problem.error(widths), prices)


def _tightened(problem: Problem, widths) -> np.ndarray:
    """Half widths scaled down, none below its lower limit, until every limit is met."""
    low = np.array([c.lower if isinstance(c, PowerCost) else np.inf for c in problem.costs])
    low = np.minimum(low, widths)

    def scaled(s):
        return np.maximum(low, s * widths)

    if np.all(problem.error(widths) <= problem.limit):
        return widths
    good, bad = 0.0, 1.0
    for _ in range(60):
        middle = (good + bad) / 2
        good, bad = (middle, bad) if np.all(problem.error(scaled(middle)) <= problem.limit) else (good, middle)
    return scaled(good)


# -- grades ------------------------------------------------------------------------------------------------------------
def _branch_and_bound(problem: Problem, choices, progress, branches: int) -> Allocation:
    """Depth first, the cheaper side first; what the dual says cannot beat the best choice so far is left out."""
    best: tuple[float, np.ndarray, list] | None = None
    root = _solved(problem, choices)
    stack, visited, open_bounds = [(root[0], choices, root)], 0, []
    while stack:
        bound, allowed, (_, prices, widths, grades) = stack.pop()
        if best is not None and bound >= best[0] - GAP * abs(best[0]):
            continue
        visited += 1
        stopped = progress is not None and visited % 50 == 0 and not progress(visited / branches)
        if best is not None and (visited > branches or stopped):
            open_bounds = [bound, *(b for b, _, _ in stack)]
            break
        candidate = _repaired(problem, allowed, widths, grades)
        if candidate is not None and (best is None or candidate[0] < best[0]):
            best = candidate
            if bound >= best[0] - GAP * abs(best[0]):
                continue
        split = _split(problem, allowed, prices, grades)
        if split is None:
            continue
        children = []
        for part in split:
            i, keep = part
            child = list(allowed)
            child[i] = keep
            tight = np.array([
                c.lower if a is None else c.grades[a[0]].w for c, a in zip(problem.costs, child)
            ])  # fmt: skip
            if np.any(problem.error(tight) > problem.limit * (1 + 1e-12)):
                continue
            solved = _solved(problem, child)
            children.append((solved[0], child, solved))
        stack += sorted(children, key=lambda c: -c[0])  # the lowest bound is taken next
    bound = min([best[0] * (1 - GAP), *open_bounds])  # what was left out could be better by no more than that
    widths, grades = best[1], best[2]
    costs = np.array([
        c.cost(w) if g is None else c.grades[g].cost for c, w, g in zip(problem.costs, widths, grades)
    ])  # fmt: skip
    return Allocation(widths, tuple(grades), costs, bound, problem.error(widths), root[1])


def _repaired(problem: Problem, allowed, widths, grades):
    """(cost, widths, grades) of a choice that meets the limits: the widest grade is tightened where it buys most."""
    table = _Dual(problem, allowed)
    widths, grades, graded = widths.copy(), list(grades), table.graded
    if len(graded):
        load, every = problem.load[:, graded], np.arange(len(graded))
        column = np.array([int(np.flatnonzero(table.number[r] == grades[i])[0]) for r, i in enumerate(graded)])
        there = np.isfinite(table.price)
        while True:
            excess = np.maximum(problem.error(widths) - problem.limit, 0)
            if not excess.any():
                break
            narrower = widths[graded, None] ** 2 - table.square
            rows = np.flatnonzero(excess)
            less = np.minimum(load[rows, :, None] * narrower, excess[rows, None, None]).sum(axis=0)
            dearer = np.maximum(table.price - table.price[every, column][:, None], 1e-300)
            worth = np.where(there & (narrower > 0) & (less > 0), less / dearer, -1.0)
            if worth.max(initial=-1.0) <= 0:
                break
            r, g = np.unravel_index(int(worth.argmax()), worth.shape)
            i, column[r] = int(graded[r]), g
            grades[i], widths[i] = int(table.number[r, g]), table.width[r, g]
    if np.any(problem.error(widths) > problem.limit):
        widths = _tightened(problem, widths)
        if np.any(problem.error(widths) > problem.limit * (1 + 1e-12)):
            return None
    total = sum(
        c.cost(w) if g is None else c.grades[g].cost for c, w, g in zip(problem.costs, widths, grades)
    )  # fmt: skip
    return total, widths, grades


def _split(problem: Problem, allowed, prices, grades):
    """Two parts of the choices of one error, or None where nothing is left to choose: that error whose two best grades
    at these prices are nearest in worth and farthest in effect."""
    weights = prices @ problem.load
    best, where = -1.0, None
    for i, cost in enumerate(problem.costs):
        if allowed[i] is None or len(allowed[i]) < 2:
            continue
        worth = sorted((cost.grades[g].cost + weights[i] * cost.grades[g].w ** 2, g) for g in allowed[i])
        (a, ga), (b, gb) = worth[:2]
        effect = weights[i] * abs(cost.grades[ga].w ** 2 - cost.grades[gb].w ** 2)
        score = effect / (b - a + 1e-9 * abs(a) + 1e-300)
        if score > best:
            best, where = score, (i, min(ga, gb))
    if where is None:
        return None
    i, g = where
    return [(i, tuple(x for x in allowed[i] if x <= g)), (i, tuple(x for x in allowed[i] if x > g))]
