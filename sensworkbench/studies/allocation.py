# SPDX-License-Identifier: LGPL-2.1-or-later
"""The allocation study: the cheapest tolerances with which a machine meets a target, and what each step of the target
costs.

Targets: the mean square (or rms) of the volumetric error over the workspace, the rms at its worst place, or a quantile
of the error over workspace and machines.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from ..core import workspace
from ..core.allocation import Allocation, Cost, GradeCost, Problem, allocate
from ..core.allocation_front import front
from ..core.distributions import Tolerance, moments
from ..core.limits import normal
from ..core.machine import Machine
from ..core.normal_bound import largest_ratio
from ..core.refusal import Refused
from ..core.sobol import indices
from ..core.synthesis import omega
from ..core.units import mm, um
from .limits import quantile_um

Progress = Callable[[float], bool]
TARGETS = ("mean_square", "rms", "worst", "quantile")
WORST_GRID = 5  # positions per joint, corners included, over which the worst place is looked for
FRONT = 50
STEPS = 24  # of the search for a quantile
NEAR = 1e-4  # relative distance of a quantile from its target at which the search ends
_UNIFORM = 1 / 3  # variance per squared half width


@dataclass(frozen=True)
class Target:
    """kind : "mean_square" (um²), "rms" (um; of the mean square over the workspace), "worst" (um; rms at the worst
    place) or "quantile" (um; of |T| over workspace and machines, at `level`).  value : in that unit."""

    kind: str
    value: float
    level: float = 0.95

    def __post_init__(self):
        if self.kind not in TARGETS:
            raise Refused("target-unknown", "--target", kind=repr(self.kind)[:60], known=list(TARGETS))
        if not (0 < self.value < 1e12):
            raise Refused("target-invalid", "--target", value=self.value)
        if not 0.5 <= self.level <= 0.9999:
            raise Refused("target-level", "--target", level=self.level)

    @property
    def mean_square(self) -> float:
        """The limit of the mean square, mm²."""
        return mm(mm(self.value if self.kind == "mean_square" else self.value**2))

    def scaled(self, ratio: float) -> Target:
        """The target with its rms times `ratio`."""
        return replace(self, value=self.value * (ratio**2 if self.kind == "mean_square" else ratio))


@dataclass(frozen=True)
class Choice:
    """One error.  before, after : its tolerances.  grade : name of the one that was chosen ("" for a curve).  cost :
    after."""

    symbol: str
    before: Tolerance
    after: Tolerance
    grade: str
    cost: float


@dataclass(frozen=True)
class FrontPoint:
    """rms (um) of the target, its cost and the bound below which no choice costs."""

    rms_um: float
    cost: float
    bound: float


@dataclass(frozen=True)
class AllocationResult:
    """machine : with the allocated tolerances.  rms before and after, um: over the workspace and at the worst place.
    quantile_um : before and after, where it is the target.  normal_bound : then the bound that would hold if every
    error were normal with the same variance (the proved one, if all are)."""

    machine: Machine
    target: Target
    choices: tuple[Choice, ...]
    allocation: Allocation
    rms_before_um: float
    rms_after_um: float
    worst_before_um: float
    worst_after_um: float
    front: tuple[FrontPoint, ...]
    quantile_um: tuple[float, float] | None = None
    normal_bound: float | None = None


def _places(machine: Machine, target: Target):
    """Positions and the weights by which their mean squares become the rows that are limited: (q, (rows, P))."""
    if target.kind == "worst":
        count = WORST_GRID if WORST_GRID ** len(machine.joints) <= 4000 else 3
        q = workspace.grid(machine, count).q
        return q, np.eye(len(q))
    positions = workspace.quadrature(machine, 4) if len(machine.joints) <= 5 else workspace.default_positions(machine)
    return positions.q, positions.weights[None, :]


def problem_of(machine: Machine, target: Target, costs: Mapping[str, Cost]) -> tuple[Problem, list[str]]:
    """The problem of core.allocation for the errors that have a cost, and their symbols; the rest stays as it is."""
    table = workspace.error_table(machine)
    symbols = [s for s in table.labels if s in costs]
    for symbol in costs:
        if symbol not in table.labels:
            raise Refused("cost-of-no-error", "costs", symbol=symbol)
    q, rows = _places(machine, target)
    matrix = table.mixed(omega(machine, table.symbols, q))
    law = moments(table.laws)
    squared = rows @ np.einsum("pan,pan->pn", matrix, matrix)  # A_ii
    middle = rows @ np.square(matrix @ law.mean).sum(axis=1)
    chosen = [table.labels.index(s) for s in symbols]
    others = [i for i in range(len(table.labels)) if i not in chosen]
    fixed = middle + squared[:, others] @ law.var[others]
    load = squared[:, chosen] * [_per_square(table.laws[i]) for i in chosen]
    limit = np.full(len(load), target.mean_square)
    if np.any(fixed >= limit):
        raise Refused("target-below-fixed", "--target", fixed=float(um(np.sqrt(fixed.max()))))
    return Problem(load, fixed, limit, tuple(costs[s] for s in symbols)), symbols


def _per_square(law: Tolerance) -> float:
    """Variance per squared half width of a law of this kind."""
    half = (law.upper - law.lower) / 2
    if half <= 0 or law.distribution == "point":
        return _UNIFORM
    return law.moments[1] / half**2


def allocation_study(
    machine: Machine, target: Target, costs: Mapping[str, Cost], progress: Progress | None = None
) -> AllocationResult:
    """The cheapest tolerances for `target`.  costs : symbol -> cost, widths in mm or rad.

    Refuses a target that the tightest tolerances do not meet.  progress : as everywhere.
    """
    tell = progress or (lambda part: True)
    if target.kind == "quantile":
        problem, symbols, found, normal_bound = _for_quantile(machine, target, costs, lambda part: tell(0.4 * part))
    else:
        normal_bound = None
        problem, symbols = problem_of(machine, target, costs)
        found = allocate(problem)
    if not tell(0.4):
        raise workspace.Cancelled("cancelled")
    choices = _choices(machine, symbols, costs, found)
    after = _with(machine, choices)
    front = _front(problem, lambda part: tell(0.4 + 0.6 * part))
    quantiles = None
    if target.kind == "quantile":
        quantiles = quantile_um(machine, target.level), quantile_um(after, target.level)
    return AllocationResult(
        after, target, choices, found,
        _rms_um(machine, Target("rms", 1)), _rms_um(after, Target("rms", 1)),
        _rms_um(machine, Target("worst", 1)), _rms_um(after, Target("worst", 1)), front, quantiles, normal_bound,
    )  # fmt: skip


def _choices(machine: Machine, symbols, costs, found: Allocation) -> tuple[Choice, ...]:
    before, choices = machine.all_tolerances, []
    for i, symbol in enumerate(symbols):
        law, width = before[symbol], float(found.widths[i])
        grade = "" if found.grades[i] is None else costs[symbol].grades[found.grades[i]].name
        choices.append(Choice(symbol, law, _with_half(law, width), grade, float(found.costs[i])))
    return tuple(choices)


def _with(machine: Machine, choices) -> Machine:
    return replace(machine, tolerances=dict(machine.tolerances) | {c.symbol: c.after for c in choices})


# -- a quantile as target ----------------------------------------------------------------------------------------------
def _for_quantile(machine: Machine, target: Target, costs, tell: Progress):
    """(problem, symbols, allocation, bound if normal) of the loosest mean square whose cheapest tolerances keep the
    quantile.

    The quantile is no convex function of the widths, so the answer is feasible and not proved the cheapest.  Its bound
    is: no tolerances whose mean square exceeds `_largest_mean_square` keep the quantile.
    """
    widest, if_normal = _largest_mean_square(machine, target, costs)
    problem, symbols = problem_of(machine, Target("rms", float(um(np.sqrt(widest)))), costs)
    bound = allocate(problem).bound
    tightest = problem.error(np.array([c.grades[0].w if isinstance(c, GradeCost) else c.lower for c in problem.costs]))

    def tried(square: float) -> tuple[float, Allocation]:
        found = allocate(replace(problem, limit=np.full(1, square)))
        return quantile_um(_with(machine, _choices(machine, symbols, costs, found)), target.level), found

    low, high, square, best = float(tightest.max()) * (1 + 1e-9), widest, widest, None
    for step in range(STEPS):
        value, found = tried(square)
        if value <= target.value:
            low = square
            best = found if best is None or found.cost <= best.cost else best
            if value >= target.value * (1 - NEAR) or square == widest:
                break
        elif square == low:
            raise Refused("allocation-out-of-reach", "--target", best=value, limit=target.value)
        else:
            high = square
        if high < low * (1 + NEAR) and best is not None:
            break
        aimed = square * (target.value * (1 - NEAR / 2) / value) ** 2  # the quantile grows like the rms
        inside = low * (1 + NEAR / 10) < aimed < high * (1 - NEAR / 10) and step < STEPS // 2
        square = aimed if inside else low if best is None and step >= 2 else float(np.sqrt(low * high))
        if not tell((step + 1) / STEPS):
            raise workspace.Cancelled("cancelled")
    loosest = replace(problem, limit=np.full(1, if_normal)) if if_normal is not None else None
    tighter = None if loosest is None else min(_bound(loosest, best.cost), best.cost)
    return replace(problem, limit=best.error.copy()), symbols, replace(best, bound=min(bound, best.cost)), tighter


def _bound(problem: Problem, cost: float) -> float:
    """The bound of a problem; `cost` where its limit is out of reach, so that what was found is the tightest."""
    try:
        return allocate(problem).bound
    except Refused:
        return cost


def _largest_mean_square(machine: Machine, target: Target, costs) -> tuple[float, float | None]:
    """(a mean square (mm²) that no tolerances exceed which keep the quantile; the same if all errors were normal, None
    where their means are not zero).

    Of normal errors `core.normal_bound` is the tighter.  Of others: Paley & Zygmund: P(Y > t E[Y]) >= (1 - t)² E[Y]² /
    E[Y²].  No law here has more than the kurtosis of the normal one, so E[Y²] <= 3 E[Y]² at a place, and <= 3 k E[Y]²
    over places whose mean squares are at most k times their mean.
    """
    loosest = replace(target, kind="rms", value=1e6)
    problem, _ = problem_of(machine, loosest, costs)
    places, _ = problem_of(machine, replace(loosest, kind="worst"), costs)
    loads = np.concatenate([places.load, places.fixed[:, None]], axis=1)
    means = np.append(problem.load[0], problem.fixed[0])
    ratio = np.divide(loads, means, out=np.zeros_like(loads), where=means > 0).max()
    share = np.sqrt(3 * ratio * (1 - target.level))
    largest = float(problem.error(np.array([
        c.grades[-1].w if isinstance(c, GradeCost) else c.upper for c in problem.costs
    ]))[0])  # fmt: skip
    largest, limit = largest * (1 + 1e-9), mm(mm(target.value**2))
    known = min(largest, limit / (1 - share)) if share < 1 else largest
    laws = workspace.error_table(machine).laws
    if np.any(moments(laws).mean):
        return known, None
    if_normal = min(largest, limit * largest_ratio(target.level, most=float(ratio)))
    return (min(known, if_normal) if normal(laws) else known), if_normal


def _with_half(law: Tolerance, half: float) -> Tolerance:
    """The law about the same middle with another half width."""
    middle, old = (law.lower + law.upper) / 2, (law.upper - law.lower) / 2
    if old <= 0 or law.distribution == "point":
        return Tolerance(middle - half, middle + half)
    sigma = None if law.sigma is None else law.sigma * half / old
    return Tolerance(middle - half, middle + half, law.distribution, sigma)


def _rms_um(machine: Machine, target: Target) -> float:
    q, rows = _places(machine, target)
    table = workspace.error_table(machine)
    found = indices(table.mixed(omega(machine, table.symbols, q)), moments(table.laws))
    return float(um(np.sqrt((rows @ found.mean).max())))


def _front(problem: Problem, tell: Progress) -> tuple[FrontPoint, ...]:
    """Cost over the target, from just above what can be reached to where the loosest tolerances do."""
    widths = np.array([
        (c.grades[0].w, c.grades[-1].w) if isinstance(c, GradeCost) else (c.lower, c.upper) for c in problem.costs
    ])  # fmt: skip
    low, high = (np.sqrt(problem.error(w).max()) for w in widths.T)
    targets = np.geomspace(low * 1.001, max(high, low * 1.002), FRONT)

    def told(part: float) -> bool:
        if not tell(part):
            raise workspace.Cancelled("cancelled")
        return True

    found = front(problem, np.square(targets), told)
    return tuple(FrontPoint(float(um(rms)), cost, bound) for rms, (cost, bound) in zip(targets, found))
