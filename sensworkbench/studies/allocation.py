# SPDX-License-Identifier: LGPL-2.1-or-later
"""The allocation study: the cheapest tolerances with which a machine meets a target, and what each step of the target
costs.

Targets: the mean square (or rms) of the volumetric error over the workspace, or the rms at its worst place.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from ..core import workspace
from ..core.allocation import Allocation, Cost, GradeCost, PowerCost, Problem, allocate
from ..core.distributions import Tolerance, moments
from ..core.machine import Machine
from ..core.refusal import Refused
from ..core.sobol import indices
from ..core.synthesis import omega
from ..core.units import mm, um

Progress = Callable[[float], bool]
TARGETS = ("mean_square", "rms", "worst")
WORST_GRID = 5  # positions per joint, corners included, over which the worst place is looked for
FRONT = 50
_UNIFORM = 1 / 3  # variance per squared half width


@dataclass(frozen=True)
class Target:
    """kind : "mean_square" (um²), "rms" (um; of the mean square over the workspace) or "worst" (um; rms at the worst
    place).  value : in that unit."""

    kind: str
    value: float

    def __post_init__(self):
        if self.kind not in TARGETS:
            raise Refused("target-unknown", "--target", kind=repr(self.kind)[:60], known=list(TARGETS))
        if not (0 < self.value < 1e12):
            raise Refused("target-invalid", "--target", value=self.value)

    @property
    def mean_square(self) -> float:
        """The limit of the mean square, mm²."""
        return mm(mm(self.value if self.kind == "mean_square" else self.value**2))

    def scaled(self, ratio: float) -> Target:
        """The target with its rms times `ratio`."""
        return Target(self.kind, self.value * (ratio**2 if self.kind == "mean_square" else ratio))


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
    """machine : with the allocated tolerances.  rms before and after, um: over the workspace and at the worst place."""

    machine: Machine
    target: Target
    choices: tuple[Choice, ...]
    allocation: Allocation
    rms_before_um: float
    rms_after_um: float
    worst_before_um: float
    worst_after_um: float
    front: tuple[FrontPoint, ...]


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
    problem, symbols = problem_of(machine, target, costs)
    found = allocate(problem)
    if not tell(0.4):
        raise workspace.Cancelled("cancelled")
    before, choices = machine.all_tolerances, []
    for i, symbol in enumerate(symbols):
        law, width = before[symbol], float(found.widths[i])
        grade = "" if found.grades[i] is None else costs[symbol].grades[found.grades[i]].name
        choices.append(Choice(symbol, law, _with_half(law, width), grade, float(found.costs[i])))
    after = replace(machine, tolerances=dict(machine.tolerances) | {c.symbol: c.after for c in choices})
    front = _front(problem, lambda part: tell(0.4 + 0.6 * part))
    return AllocationResult(
        after, target, tuple(choices), found,
        _rms_um(machine, Target("rms", 1)), _rms_um(after, Target("rms", 1)),
        _rms_um(machine, Target("worst", 1)), _rms_um(after, Target("worst", 1)), front,
    )  # fmt: skip


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
    curves = all(isinstance(c, PowerCost) for c in problem.costs)
    out = []
    for i, rms in enumerate(np.geomspace(low * 1.001, max(high, low * 1.002), FRONT if curves else FRONT // 5)):
        found = allocate(replace(problem, limit=np.full(len(problem.limit), rms**2)))
        out.append(FrontPoint(float(um(rms)), found.cost, found.bound))
        if not tell((i + 1) / FRONT):
            raise workspace.Cancelled("cancelled")
    return tuple(out)
