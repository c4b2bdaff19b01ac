# SPDX-License-Identifier: LGPL-2.1-or-later
"""Indices over the workspace: which component spoils the accuracy, on the whole (Park & Yang 2012 eq. 19).

The mean of S^T is an integral of a smooth rational function of the joint positions, so Gauss-Legendre quadrature
reaches six digits with a few positions per joint; the paper's sum over a grid, divided by the number of points, is
available too.  If a product of so many joints is too large, a low-discrepancy set with an estimate of its error is
used.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace

import numpy as np

from .distributions import Tolerance, moments
from .machine import Machine
from .objectives import MeanSquare, Objective
from .refusal import Refused
from .sources import ErrorTable, mixing_matrix
from .synthesis import ORIENTATION, omega

CHUNK = 4096
MAX_POINTS = 2_000_000
MAX_PER_JOINT = 2_000  # the nodes of a quadrature are eigenvalues: their cost is cubic
DEFAULT_ORDER = 8
DEFAULT_GRID = 5
AFFORDABLE = 40_000  # positions of a default quadrature: five joints
FEW_ORDER, MOST_JOINTS, FEW = 4, 4, 256
REPLICATES = 8  # shifted copies of a low-discrepancy set, whose scatter is its error
PRIMES = (2, 3, 5, 7, 11, 13)


@dataclass(frozen=True)
class Positions:
    """Where the indices are taken: q (P, n) mm or rad with weights (P,) adding to 1; `counts` per joint (or (P,) of a
    low-discrepancy set); `kind`: "quadrature", "grid", "at" or "low_discrepancy"."""

    q: np.ndarray
    weights: np.ndarray
    counts: tuple[int, ...]
    kind: str


def _product(machine: Machine, nodes, weights, counts, kind) -> Positions:
    low, high = machine.travel.T
    axes = [(high[i] + low[i]) / 2 + (high[i] - low[i]) / 2 * nodes[i] for i in range(len(low))]
    q = np.stack([g.ravel() for g in np.meshgrid(*axes, indexing="ij")], axis=1)
    w = weights[0]
    for other in weights[1:]:
        w = np.multiply.outer(w, other)
    w = np.ravel(w)
    return Positions(q, w / w.sum(), tuple(counts), kind)


def _counts(machine: Machine, counts, least: int) -> tuple[int, ...]:
    joints = len(machine.joints)
    counts = (counts,) * joints if np.isscalar(counts) else tuple(counts)
    if len(counts) != joints or any(int(c) != c or c < least for c in counts):
        raise Refused("positions-count-invalid", "positions", counts=str(counts)[:60], joints=joints, least=least)
    product = np.prod(counts, dtype=float)
    if product > MAX_POINTS or max(counts) > MAX_PER_JOINT:
        raise Refused("positions-too-many", "positions", count=product, limit=MAX_POINTS, each=MAX_PER_JOINT)
    return tuple(int(c) for c in counts)


def quadrature(machine: Machine, order=DEFAULT_ORDER) -> Positions:
    """Gauss-Legendre positions over the travel, `order` per joint (an int or one per joint).

    An endless joint has equal steps of a turn instead, the rule of highest order for what repeats itself.
    """
    counts = _counts(machine, order, 1)
    rules = [
        _turn(c) if j.travel is None else np.polynomial.legendre.leggauss(c) for j, c in zip(machine.joints, counts)
    ]
    return _product(machine, [r[0] for r in rules], [r[1] for r in rules], counts, "quadrature")


def _turn(count: int) -> tuple[np.ndarray, np.ndarray]:
    """Nodes in [-1, 1] and weights of the midpoint rule."""
    return (2 * np.arange(count) + 1) / count - 1, np.ones(count)


def default_order(machine: Machine) -> tuple[int, ...]:
    """DEFAULT_ORDER per linear joint, and more per rotary joint, over which errors turn, as far as is affordable."""
    turning = sum(not j.slides for j in machine.joints)
    left = AFFORDABLE / DEFAULT_ORDER ** (len(machine.joints) - turning)
    more = next((c for c in (32, 24, 16, 12) if c**turning <= left), DEFAULT_ORDER)
    return tuple(DEFAULT_ORDER if j.slides else more for j in machine.joints)


def grid(machine: Machine, count=DEFAULT_GRID) -> Positions:
    """The paper's regular grid over the travel with its end points, all positions weighing the same."""
    counts = _counts(machine, count, 2)
    return _product(machine, [np.linspace(-1, 1, c) for c in counts], [np.ones(c) for c in counts], counts, "grid")


def low_discrepancy(machine: Machine, count: int = REPLICATES * CHUNK) -> Positions:
    """A Halton set over the travel in REPLICATES randomly shifted copies (Cranley & Patterson 1976), `count` in all.

    The shifts are fixed, so that a result can be repeated.
    """
    joints = len(machine.joints)
    each = max(1, int(count) // REPLICATES)
    if each * REPLICATES > MAX_POINTS:
        raise Refused("positions-too-many", "positions", count=float(count), limit=MAX_POINTS, each=MAX_PER_JOINT)
    unit = np.column_stack([_radical_inverse(each, PRIMES[i]) for i in range(joints)])
    shifts = np.random.default_rng(2012).random((REPLICATES, 1, joints))
    q = ((unit + shifts) % 1.0).reshape(-1, joints)
    low, high = machine.travel.T
    total = each * REPLICATES
    return Positions(low + (high - low) * q, np.full(total, 1 / total), (total,), "low_discrepancy")


def _radical_inverse(count: int, base: int) -> np.ndarray:
    """(count,) digits of 1, 2, ... in `base`, mirrored at the point (van der Corput)."""
    left, out, scale = np.arange(1, count + 1), np.zeros(count), 1.0 / base
    while left.any():
        out += scale * (left % base)
        left = left // base
        scale /= base
    return out


def default_positions(machine: Machine) -> Positions:
    """Quadrature of `default_order` where that is affordable, else a low-discrepancy set."""
    order = default_order(machine)
    if np.prod(order) <= AFFORDABLE:
        return quadrature(machine, order)
    return low_discrepancy(machine)


def few_positions(machine: Machine) -> Positions:
    """A quadrature of FEW_ORDER per joint, or a set of FEW positions: for means that cost much at each."""
    if len(machine.joints) <= MOST_JOINTS:
        return quadrature(machine, FEW_ORDER)
    return low_discrepancy(machine, FEW)


def at(machine: Machine, position) -> Positions:
    """One position: one value per joint, mm or rad."""
    q = np.asarray(position, dtype=float).reshape(1, -1)
    if q.shape[1] != len(machine.joints):
        raise Refused("position-count-wrong", "--at", count=q.shape[1], names=list(machine.names))
    if not np.all(np.isfinite(q)):
        raise Refused("position-not-finite", "--at", position=str(q[0].tolist()))
    span = machine.travel[:, 1] - machine.travel[:, 0]
    for joint, value, reach in zip(machine.joints, q[0], span):
        if abs(value) > 1e3 * (reach + max(abs(v) for v in joint.span)):
            raise Refused("position-far-outside", "--at", name=joint.name, value=joint.to_shown(value), unit=joint.unit)
    return Positions(q, np.ones(1), (1,) * len(machine.joints), "at")


@dataclass(frozen=True)
class Sensitivity:
    """Indices of a machine over positions.

    symbols (n), owners (n); first, total, total_max (n,): means over the positions and largest value; first_vw,
    total_vw: the same means weighted by V(Y).  bodies (g); component_first, component_total, component_total_max,
    component_total_vw (g,): group indices of each component.  mean_square E[Y], variance V(Y): mean over the
    positions (mm², mm⁴; rad², rad⁴ for orientation; mm, mm² when signed).  estimated_error: largest difference of
    `total` between this quadrature and one of two orders less, or three standard errors of a low-discrepancy set
    (None for a grid or one position).  without_extent : enabled effects that take no part, see `error_table`.

    share (n,), component_share (g,): the part of V(Y) that is an input's or a component's own, mean over the positions;
    they add up to 1.  Nothing exists above pairs, so that these Shapley effects are (S + S^T)/2 (Owen 2014).
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
    objective: Objective = field(default_factory=MeanSquare)
    estimated_error: float | None = None
    without_extent: tuple[str, ...] = ()

    @property
    def share(self) -> np.ndarray:
        """(errors,) shares of the variance that add to one: (S + S^T) / 2, the Shapley effect of independent errors."""
        return (self.first + self.total) / 2

    @property
    def component_share(self) -> np.ndarray:
        """(components,) shares of the variance that add to one: (S + S^T) / 2 with the closed index S of the
        component.
        """
        return (self.component_first + self.component_total) / 2


def error_table(machine: Machine) -> ErrorTable:
    """Everything that varies: the tolerances, the enabled effects, the sources.

    An effect's law is uniform over the range of its component (`Effect.range`); one of which no range is known takes no
    part and is listed in `without_extent`.
    """
    tolerances = machine.all_tolerances
    labels, columns = list(tolerances), list(tolerances)
    laws = list(tolerances.values())
    without_extent = []
    for effect in machine.effects:
        if effect.enabled and effect.range is None:
            without_extent.append(effect.name)
        elif effect.enabled:
            labels.append(effect.name)
            columns.append(effect.component)
            laws.append(Tolerance(*effect.range))
    owners = [machine.component(c).body for c in columns]
    symbols, mixing = mixing_matrix(columns, machine.sources)
    for source in machine.sources:
        bodies = {machine.component(s).body for s in source.factors}
        labels.append(source.name)
        columns.append("")
        owners.append(bodies.pop() if len(bodies) == 1 else source.name)
        laws.append(source.law)
    return ErrorTable(tuple(labels), tuple(columns), tuple(owners), tuple(laws), symbols, mixing, tuple(without_extent))


def sensitivity(
    machine: Machine,
    positions: Positions | None = None,
    objective: Objective = MeanSquare(),
    progress: Callable[[float], bool] | None = None,
    estimate: bool = True,
) -> Sensitivity:
    """Exact indices of every error and component over `positions` (default: `default_positions`).

    progress : called with the fraction done; a false return cancels (raises `Cancelled`).
    estimate : for a quadrature, repeat it two orders lower to state `estimated_error`.
    Refuses when nothing varies anywhere.
    """
    positions = default_positions(machine) if positions is None else positions
    count, lower = len(positions.q), None
    if estimate and positions.kind == "quadrature" and max(positions.counts) > 1:
        lower = quadrature(machine, [max(1, c - 2) for c in positions.counts])
    everything = count + (0 if lower is None else len(lower.q))
    table = error_table(machine)
    labels, owners = table.labels, table.owners
    if (
        objective.output == ORIENTATION
        and not omega(machine, table.symbols, positions.q[:64], output=ORIENTATION).any()
    ):
        raise Refused("objective-nothing-turns", "objective")
    law = moments(table.laws)
    bodies = tuple(b for b in (*machine.bodies, *(s.name for s in machine.sources)) if b in owners)
    groups = [[i for i, o in enumerate(owners) if o == b] for b in bodies]
    n, g = len(labels), len(bodies)
    of_errors = ("first", "total", "first_vw", "total_vw", "total_max")
    of_components = ("component_first", "component_total", "component_total_max", "component_total_vw")
    sums = {k: np.zeros(n) for k in of_errors} | {k: np.zeros(g) for k in of_components}
    mean_square = variance = 0.0
    replicates = np.zeros((REPLICATES, n)) if estimate and positions.kind == "low_discrepancy" else None
    for replicate, block in _blocks(positions):
        matrix = table.mixed(omega(machine, table.symbols, positions.q[block], output=objective.output))
        one, many = objective.indices(matrix, law), objective.group_indices(matrix, law, groups)
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
        if replicates is not None:
            replicates[replicate] += REPLICATES * (w @ one.total)
        if progress is not None and not progress(block.stop / everything):
            raise Cancelled("cancelled")
    if not np.isfinite(variance) or not np.isfinite(mean_square):
        raise Refused("objective-overflow", "tolerances")
    if variance <= 0:
        raise Refused("objective-nothing-varies", "tolerances")
    for key in ("first_vw", "total_vw", "component_total_vw"):
        sums[key] = sums[key] / variance
    result = Sensitivity(
        symbols=labels,
        owners=owners,
        bodies=bodies,
        mean_square=mean_square,
        variance=variance,
        positions=positions,
        objective=objective,
        without_extent=table.without_extent,
        **sums,
    )
    if lower is not None:
        rest = None if progress is None else lambda part: progress((count + part * len(lower.q)) / everything)
        other = sensitivity(machine, lower, objective, rest, estimate=False)
        result = replace(result, estimated_error=float(np.abs(other.total - result.total).max()))
    if replicates is not None:
        scatter = replicates.std(axis=0, ddof=1) / np.sqrt(REPLICATES)
        result = replace(result, estimated_error=3 * float(scatter.max()))
    return result


def _blocks(positions: Positions):
    """(replicate, slice) of the positions, at most CHUNK each and each within one replicate."""
    count = len(positions.q)
    size = count // REPLICATES if positions.kind == "low_discrepancy" else count
    for number, first in enumerate(range(0, count, size)):
        for start in range(first, first + size, CHUNK):
            yield number, slice(start, min(start + CHUNK, first + size))


class Cancelled(Exception):
    """The user cancelled; nothing was changed."""
