# SPDX-License-Identifier: LGPL-2.1-or-later
"""Indices over the workspace: which component spoils the accuracy, on the whole (Park & Yang 2012 eq. 19).

The mean of S^T is an integral of a smooth rational function of (x, y, z), so Gauss-Legendre quadrature reaches six
digits with a few hundred positions; the paper's sum over a grid, divided by the number of points, is offered beside it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace

import numpy as np

from . import sobol
from .distributions import Tolerance, moments
from .errors import BODIES, SQUARENESS, component
from .machine import Machine
from .refusal import Refused
from .synthesis import ORIENTATION, POSITION, omega

CHUNK = 4096
MAX_POINTS = 2_000_000
DEFAULT_ORDER = 8
DEFAULT_GRID = 5


@dataclass(frozen=True)
class Objective:
    """What is judged: Y = sum_a w_a T_a² (or R_a² with output "orientation"), or the signed sum_a w_a T_a."""

    output: str = POSITION
    weights: tuple[float, float, float] = (1.0, 1.0, 1.0)
    signed: bool = False

    def __post_init__(self):
        if self.output not in (POSITION, ORIENTATION):
            raise Refused(f"unknown output {self.output!r}", "objective", 'Use "position" or "orientation".')
        weights = tuple(float(w) for w in self.weights)
        if len(weights) != 3 or not np.all(np.isfinite(weights)) or not any(weights):
            raise Refused(f"weights {list(weights)} are not three finite numbers, one of them not 0", "objective")
        if not self.signed and min(weights) < 0:
            raise Refused("weights of squared components must not be negative", "objective")
        object.__setattr__(self, "weights", weights)


@dataclass(frozen=True)
class Positions:
    """Where the indices are taken: q (P, 3) mm with weights (P,) adding to 1; `counts` per axis; `kind`."""

    q: np.ndarray
    weights: np.ndarray
    counts: tuple[int, int, int]
    kind: str  # "quadrature", "grid", "at"


def _product(machine: Machine, nodes, weights, counts, kind) -> Positions:
    low, high = machine.travel.T
    axes = [(high[i] + low[i]) / 2 + (high[i] - low[i]) / 2 * nodes[i] for i in range(3)]
    q = np.stack([g.ravel() for g in np.meshgrid(*axes, indexing="ij")], axis=1)
    w = np.einsum("i,j,k->ijk", *weights).ravel()
    return Positions(q, w / w.sum(), tuple(counts), kind)


def _counts(counts, least: int) -> tuple[int, int, int]:
    counts = (counts,) * 3 if np.isscalar(counts) else tuple(counts)
    if len(counts) != 3 or any(int(c) != c or c < least for c in counts):
        raise Refused(f"{counts} is not a number of positions per axis", "positions", f"Give at least {least}.")
    product = np.prod(counts, dtype=float)
    if product > MAX_POINTS:
        raise Refused(f"{product:.0f} positions are too many", "positions", f"Stay below {MAX_POINTS}.")
    return tuple(int(c) for c in counts)


def quadrature(machine: Machine, order=DEFAULT_ORDER) -> Positions:
    """Gauss-Legendre positions over the travel, `order` per axis (an int or three)."""
    counts = _counts(order, 1)
    rules = [np.polynomial.legendre.leggauss(c) for c in counts]
    return _product(machine, [r[0] for r in rules], [r[1] for r in rules], counts, "quadrature")


def grid(machine: Machine, count=DEFAULT_GRID) -> Positions:
    """The paper's regular grid over the travel with its end points, all positions weighing the same."""
    counts = _counts(count, 2)
    return _product(machine, [np.linspace(-1, 1, c) for c in counts], [np.ones(c) for c in counts], counts, "grid")


def at(machine: Machine, position) -> Positions:
    """One position."""
    q = np.asarray(position, dtype=float).reshape(1, 3)
    if not np.all(np.isfinite(q)):
        raise Refused(f"position {q[0].tolist()} is not finite", "--at", "Give X,Y,Z in mm.")
    return Positions(q, np.ones(1), (1, 1, 1), "at")


@dataclass(frozen=True)
class Sensitivity:
    """Indices of a machine over positions.

    symbols (n), owners (n); first, total, total_max (n,): means over the positions and largest value; first_vw,
    total_vw: the same means weighted by V(Y).  bodies (g); component_first, component_total, component_total_max,
    component_total_vw (g,): group indices of each component.  mean_square E[Y], variance V(Y): mean over the
    positions (mm², mm⁴; rad², rad⁴ for orientation; mm, mm² when signed).  estimated_error: largest difference of
    `total` between this quadrature and one of two orders less (None for a grid or one position).
    """

    symbols: tuple[str, ...]
    owners: tuple[str, ...]
    first: np.ndarray
    total: np.ndarray
    total_max: np.ndarray
    first_vw: np.ndarray
    total_vw: np.ndarray
    bodies: tuple[str, ...]
    component_first: np.ndarray
    component_total: np.ndarray
    component_total_max: np.ndarray
    component_total_vw: np.ndarray
    mean_square: float
    variance: float
    positions: Positions
    objective: Objective = field(default_factory=Objective)
    estimated_error: float | None = None


def error_table(machine: Machine):
    """(labels, columns, owners, tolerances) of everything that varies: the tolerances, then the enabled effects.

    columns : the ISO symbol whose column of Omega each entry uses.  An effect's law is uniform between the extremes it
    reached on the readings (`driver_range` times its coefficient).
    """
    tolerances = machine.all_tolerances
    labels, columns = list(tolerances), list(tolerances)
    laws = list(tolerances.values())
    for effect in machine.effects:
        if effect.enabled and "extent" in effect.parameters:
            low, high = effect.parameter("extent")
            scale = 1e-6 if component(effect.component).angular else 1e-3
            labels.append(effect.name)
            columns.append(effect.component)
            laws.append(Tolerance(low * scale, high * scale))
    owners = [component(c).body for c in columns]
    return labels, columns, owners, laws


def sensitivity(
    machine: Machine,
    positions: Positions | None = None,
    objective: Objective = Objective(),
    progress: Callable[[float], bool] | None = None,
    estimate: bool = True,
) -> Sensitivity:
    """Exact indices of every error and component over `positions` (default: quadrature of order 8).

    progress : called with the fraction done; a false return cancels (raises `Cancelled`).
    estimate : for a quadrature, repeat it two orders lower to state `estimated_error`.
    Refuses when nothing varies anywhere.
    """
    positions = quadrature(machine) if positions is None else positions
    count, lower = len(positions.q), None
    if estimate and positions.kind == "quadrature" and max(positions.counts) > 1:
        lower = quadrature(machine, [max(1, c - 2) for c in positions.counts])
    everything = count + (0 if lower is None else len(lower.q))
    labels, columns, owners, laws = error_table(machine)
    if objective.output == ORIENTATION and not any(
        component(c).angular and (component(c).kind != SQUARENESS or machine.squareness == "carried") for c in columns
    ):
        raise Refused("no error turns the tool", "objective", "Choose the position output.")
    law = moments(laws)
    bodies = tuple(b for b in BODIES if b in owners)
    groups = [[i for i, o in enumerate(owners) if o == b] for b in bodies]
    n, g = len(labels), len(bodies)
    of_errors = ("first", "total", "first_vw", "total_vw", "total_max")
    of_components = ("component_first", "component_total", "component_total_max", "component_total_vw")
    sums = {k: np.zeros(n) for k in of_errors} | {k: np.zeros(g) for k in of_components}
    mean_square = variance = 0.0
    for start in range(0, count, CHUNK):
        block = slice(start, start + CHUNK)
        matrix = omega(machine, columns, positions.q[block], output=objective.output)
        if objective.signed:
            one = sobol.signed_indices(matrix, law, objective.weights)
            many = sobol.signed_group_indices(matrix, law, groups, objective.weights)
        else:
            one = sobol.indices(matrix, law, objective.weights)
            many = sobol.group_indices(matrix, law, groups, objective.weights)
        w = positions.weights[block]
        wv = w * one.variance
        sums["first"] += w @ one.first
        sums["total"] += w @ one.total
        sums["first_vw"] += wv @ one.first
        sums["total_vw"] += wv @ one.total
        np.maximum(sums["total_max"], one.total.max(axis=0), out=sums["total_max"])
        sums["component_first"] += w @ many.first
        sums["component_total"] += w @ many.total
        sums["component_total_vw"] += wv @ many.total
        np.maximum(sums["component_total_max"], many.total.max(axis=0), out=sums["component_total_max"])
        mean_square += float(w @ one.mean)
        variance += float(wv.sum())
        if progress is not None and not progress(min(count, start + CHUNK) / everything):
            raise Cancelled("cancelled")
    if variance <= 0:
        raise Refused(
            "nothing varies: the objective has no variance at any position",
            "tolerances",
            "Give at least one error limits that differ, and keep a component that it moves.",
        )
    for key in ("first_vw", "total_vw", "component_total_vw"):
        sums[key] = sums[key] / variance
    result = Sensitivity(
        symbols=tuple(labels),
        owners=tuple(owners),
        bodies=bodies,
        mean_square=mean_square,
        variance=variance,
        positions=positions,
        objective=objective,
        **sums,
    )
    if lower is not None:
        rest = None if progress is None else lambda part: progress((count + part * len(lower.q)) / everything)
        other = sensitivity(machine, lower, objective, rest, estimate=False)
        result = replace(result, estimated_error=float(np.abs(other.total - result.total).max()))
    return result


class Cancelled(Exception):
    """The user cancelled; nothing was changed."""
