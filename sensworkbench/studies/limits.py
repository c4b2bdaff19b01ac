# SPDX-License-Identifier: LGPL-2.1-or-later
"""The study of limits: how large the error of a machine within its tolerances may become, and what makes it large.

Over random machines and all places of the workspace: quantiles of |T| and P(|T| > limit); at every place, so that the
worst is known; and the figures that a measured machine is judged by: the ranges of the three components over the
workspace (volumetric accuracy V_XYZ of ISO 230-1) and of the deviation along the four body diagonals (ISO 230-6).
"""

from __future__ import annotations

import itertools
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ..core import limits, workspace
from ..core.machine import Machine
from ..core.objectives import MeanSquare, Objective
from ..core.refusal import Refused
from ..core.synthesis import omega
from ..core.units import mm, um
from ..core.workspace import Cancelled, error_table

Progress = Callable[[float], bool]
GRID = 5  # positions per joint of the ranges, end points included
DIAGONAL = 11  # positions on a body diagonal
MACHINES = 4096  # of which the ranges are taken


@dataclass(frozen=True)
class Contribution:
    """How much an error or component makes of a quantile: d ln quantile / d ln(its tolerance)."""

    name: str
    value: float


@dataclass(frozen=True)
class Figure:
    """A figure of a random machine, um: its median and its quantile at the level of the study."""

    name: str
    median: float
    upper: float


@dataclass(frozen=True)
class LimitsResult:
    """quantile of |T| (um) at `level` over workspace and machines with its error; beyond: (limit um, P(|T| > limit),
    its error) each; worst_at (n,) mm or rad and worst (um): the place with the largest quantile.  errors, components:
    contributions, largest first, adding to one.  computed : False where machines were sampled.
    """

    machine: Machine
    level: float
    quantile: float
    error: float
    beyond: tuple[tuple[float, float, float], ...]
    worst: float
    worst_at: np.ndarray
    errors: tuple[Contribution, ...]
    components: tuple[Contribution, ...]
    figures: tuple[Figure, ...]
    computed: bool


def columns(machine: Machine, q: np.ndarray, objective: Objective = MeanSquare()) -> np.ndarray:
    """(P, 3, n) weighted Omega of everything that varies."""
    table = error_table(machine)
    matrix = table.mixed(omega(machine, table.symbols, q, output=objective.output))
    return matrix * np.sqrt(np.asarray(objective.weights))[:, None]


def limits_study(
    machine: Machine, level: float = 0.95, allowed: tuple[float, ...] = (), progress: Progress | None = None
) -> LimitsResult:
    """Quantile, probabilities and figures of random machines.

    level : of the quantiles.  allowed : limits of |T|, um.  progress : called with the part done; false cancels.
    Refuses a level outside 0.01 … 0.9999, limits that are not above zero, and a machine of which nothing varies.
    """
    if not 0.01 <= level <= 0.9999:
        raise Refused("objective-level", "--level", level=repr(level)[:40])
    if any(not 0 < limit < 1e9 for limit in allowed):
        raise Refused("limits-not-positive", "--limit")
    tell = _teller(progress)
    table, where = error_table(machine), workspace.few_positions(machine)
    matrix = columns(machine, where.q)
    found = limits.RandomError(matrix, table.laws, where.weights)
    tell(0.2)
    quantile = found.quantile(level)
    if not quantile.contributions.any():
        raise Refused("objective-nothing-varies", "tolerances")
    beyond = []
    for limit in allowed:
        inside, error = found.probability(mm(limit))
        beyond.append((limit, 1 - inside, error))
    tell(0.4)
    corners = workspace.grid(machine, 3) if len(machine.joints) <= 4 else where
    worst, worst_at = _worst(machine, table.laws, corners.q, level)
    tell(0.7)
    figures = _figures(machine, table.laws, level) if len(machine.joints) <= 4 else ()
    tell(1.0)
    return LimitsResult(
        machine, level, um(quantile.value), um(quantile.error), tuple(beyond), um(worst), worst_at,
        _ranked(zip(table.labels, quantile.contributions)),
        _ranked(_of_components(machine, table.owners, quantile.contributions)), figures, found.computed,
    )  # fmt: skip


def _teller(progress: Progress | None):
    def tell(part: float) -> None:
        if progress is not None and not progress(part):
            raise Cancelled("cancelled")

    return tell


def _ranked(pairs) -> tuple[Contribution, ...]:
    return tuple(sorted((Contribution(n, float(v)) for n, v in pairs), key=lambda c: -c.value))


def _of_components(machine: Machine, owners, values):
    names = (*machine.bodies, *(s.name for s in machine.sources))
    return [(b, sum(v for o, v in zip(owners, values) if o == b)) for b in names if b in owners]


def _worst(machine: Machine, laws, q: np.ndarray, level: float) -> tuple[float, np.ndarray]:
    """(largest quantile over the places, its place)."""
    machines = None if limits.normal(laws) else limits.sample(laws, limits.SAMPLES // 4)
    matrix = columns(machine, q)
    values = [limits.RandomError(one, laws, machines=machines).value(level) for one in matrix]
    at = int(np.argmax(values))
    return values[at], q[at]


def _figures(machine: Machine, laws, level: float) -> tuple[Figure, ...]:
    """V_X, V_Y, V_Z and their largest, V_XYZ; the ranges along the body diagonals and their largest, E_D."""
    x = limits.sample(laws, MACHINES)
    grid = columns(machine, workspace.grid(machine, GRID).q)
    axes = np.stack([np.ptp(np.einsum("pn,ns->ps", grid[:, a], x), axis=0) for a in range(3)])
    rows = {f"V_{n}": v for n, v in zip("XYZ", axes)} | {"V_XYZ": axes.max(axis=0)}
    ranges = [_along(machine, x, *ends) for ends in diagonals(machine)]
    rows |= {f"D{i}": r for i, r in enumerate(ranges, start=1)}
    if ranges:
        rows["E_D"] = np.max(ranges, axis=0)
    return tuple(Figure(n, um(float(np.median(v))), um(float(np.quantile(v, level)))) for n, v in rows.items())


def diagonals(machine: Machine):
    """(from, to) of the body diagonals of a machine with three linear joints; none otherwise."""
    if len(machine.joints) != 3 or not all(j.slides for j in machine.joints):
        return
    low, high = machine.travel.T
    for signs in itertools.product((False, True), repeat=2):
        flip = np.array([False, *signs])
        yield np.where(flip, high, low), np.where(flip, low, high)


def _along(machine: Machine, x: np.ndarray, start: np.ndarray, end: np.ndarray) -> np.ndarray:
    """(machines,) range of the deviation along the diagonal from `start` to `end`."""
    part = np.linspace(0, 1, DIAGONAL)[:, None]
    q = start + part * (end - start)
    place = machine.tool_position(q)
    direction = place[-1] - place[0]
    direction = direction / np.linalg.norm(direction)
    return np.ptp(np.einsum("a,pan,ns->ps", direction, columns(machine, q), x, optimize=True), axis=0)


def quantile_um(machine: Machine, level: float) -> float:
    """The quantile of |T| over workspace and machines, um."""
    where = workspace.few_positions(machine)
    return um(limits.RandomError(columns(machine, where.q), error_table(machine).laws, where.weights).value(level))
