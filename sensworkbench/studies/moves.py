# SPDX-License-Identifier: LGPL-2.1-or-later
"""The study of moves: where a scale, a guide or the tool should be, and in which order the axes should be stacked.

Every column of Omega is affine in every point of the machine and in the position of every linear joint.  So the mean
square E[Y] is a quadratic function of all points together, and V(Y) a polynomial of degree four in each: central
differences of sixth order give their exact derivatives, whatever the step, and the best place within a box is that of a
convex quadratic function.  Shares, and the travel of rotary joints, are smooth: the same differences give them to about
ten digits.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..core import workspace
from ..core.allocation import Cost, GradeCost, PowerCost
from ..core.distributions import moments
from ..core.machine import Machine
from ..core.refusal import Refused
from ..core.synthesis import omega
from ..core.units import mm, um
from ..core.workspace import Cancelled, error_table

Progress = Callable[[float], bool]
STEP = {"mm": 10.0, "rad": 0.01}  # of the differences
STENCIL = ((1, 3 / 4), (2, -3 / 20), (3, 1 / 60))  # of a first derivative, sixth order
SWEEPS = 200  # of the coordinates of the box
MOST_ORDERS = 4  # joints of which all orders are tried
TOOL, SPINDLE, WORKPIECE = "tool_point", "spindle_reference", "workpiece_reference"


@dataclass(frozen=True)
class Change:
    """Derivative of the mean square (mm² per mm or rad), of the variance (mm⁴ per mm or rad) and of shares."""

    mean_square: float
    variance: float
    shares: Mapping[str, float]


@dataclass(frozen=True)
class PointMoves:
    """One point of the machine: name of the joint, or TOOL, SPINDLE, WORKPIECE.  at (3,): mm, frame of the file.

    changes : by x, y and z.  best (3,): the move within the box that makes the mean square smallest, alone; rms_best:
    the rms then, mm.  worth (3,): what a change of the mean square by a move of 1 mm costs at the cheapest tolerance,
    or None without costs.
    """

    name: str
    at: np.ndarray
    changes: tuple[Change, Change, Change]
    best: np.ndarray
    rms_best: float
    worth: np.ndarray | None = None


@dataclass(frozen=True)
class TravelMoves:
    """Derivatives by the lower and the upper end of a joint's travel; per mm or rad."""

    name: str
    low: Change
    high: Change


@dataclass(frozen=True)
class Order:
    """A structure of the same parts, and its rms over the workspace, mm."""

    structure: str
    rms: float


@dataclass(frozen=True)
class ToleranceStep:
    """Where less mean square costs least among the tolerances.  price : per mm², at the present width."""

    symbol: str
    price: float


@dataclass(frozen=True)
class MovesResult:
    """machine; mean_square (mm²) and variance (mm⁴) over the workspace; within (mm): half sides of the box of `best`
    along x, y and z; together : point -> move (3,) with all points moved, and the rms (mm) then.  step : where costs
    are given."""

    machine: Machine
    mean_square: float
    variance: float
    within: tuple[float, float, float]
    points: tuple[PointMoves, ...]
    travel: tuple[TravelMoves, ...]
    together: Mapping[str, np.ndarray]
    rms_together: float
    orders: tuple[Order, ...]
    step: ToleranceStep | None = None


# -- points of a machine -----------------------------------------------------------------------------------------------
def points_of(machine: Machine) -> dict[str, np.ndarray]:
    """name -> (3,) mm, frame of the file: the reference (or a point on the axis) of every joint, the tool point, and
    the references of spindle and workpiece where the machine states them."""
    found = {j.name: np.array(j.point, dtype=float) for j in machine.joints}
    for name in (TOOL, SPINDLE, WORKPIECE):
        if getattr(machine, name) is not None:
            found[name] = np.array(getattr(machine, name), dtype=float)
    return found


def moved(machine: Machine, moves: Mapping[str, np.ndarray]) -> Machine:
    """The machine with points moved by (3,) mm each."""
    joints = tuple(
        replace(j, point=tuple(np.array(j.point) + moves[j.name])) if j.name in moves else j for j in machine.joints
    )
    others = {
        n: tuple(np.array(getattr(machine, n)) + moves[n]) for n in (TOOL, SPINDLE, WORKPIECE) if n in moves
    }  # fmt: skip
    return replace(machine, joints=joints, **others)


def mean_square(machine: Machine) -> float:
    """E[Y] over the workspace, mm²."""
    table, where = error_table(machine), workspace.few_positions(machine)
    matrix = table.mixed(omega(machine, table.symbols, where.q))
    law = moments(table.laws)
    each = np.einsum("pan,pan,n->p", matrix, matrix, law.var) + np.square(matrix @ law.mean).sum(axis=1)
    return float(where.weights @ each)


def _judged(machine: Machine) -> np.ndarray:
    """(2 + components,) mean square, variance and shares of the components."""
    found = workspace.sensitivity(machine, workspace.few_positions(machine), estimate=False)
    share = dict(zip(found.bodies, found.component_share))
    return np.array([found.mean_square, found.variance, *(share.get(b, 0.0) for b in machine.bodies)])


def derivative(of: Callable[[float], np.ndarray], step: float) -> np.ndarray:
    """Derivative at 0 by central differences of sixth order: exact for polynomials up to degree six."""
    return sum(w * (of(k * step) - of(-k * step)) for k, w in STENCIL) / step


def _change(machine: Machine, of: Callable[[float], Machine], unit: str) -> Change:
    found = derivative(lambda d: _judged(of(d)), STEP[unit])
    return Change(float(found[0]), float(found[1]), dict(zip(machine.bodies, found[2:].tolist())))


# -- the best place within a box ---------------------------------------------------------------------------------------
def _quadratic(machine: Machine, names) -> tuple[np.ndarray, np.ndarray]:
    """(gradient, Hessian) of the mean square by the coordinates of the points `names`, three each."""
    step, count = STEP["mm"], 3 * len(names)

    def at(*steps) -> float:
        shift = np.zeros(count)
        for i, d in steps:
            shift[i] += d
        return mean_square(moved(machine, dict(zip(names, shift.reshape(-1, 3)))))

    middle = at()
    plus, minus = [at((i, step)) for i in range(count)], [at((i, -step)) for i in range(count)]
    gradient = np.array([(p - m) / (2 * step) for p, m in zip(plus, minus)])
    hessian = np.diag([(p - 2 * middle + m) / step**2 for p, m in zip(plus, minus)])
    for i, j in itertools.combinations(range(count), 2):
        both = at((i, step), (j, step))
        hessian[i, j] = hessian[j, i] = (both - plus[i] - plus[j] + middle) / step**2
    return gradient, hessian


def best_in_box(gradient: np.ndarray, hessian: np.ndarray, within) -> np.ndarray:
    """The move in [-within, within] per coordinate that minimises gᵀx + xᵀHx/2, H positive semidefinite.

    within : of all coordinates, or one number for each.

    Coordinate by coordinate, which for a convex function over a box ends in its minimum; a coordinate that changes
    nothing stays.
    """
    x = np.zeros(len(gradient))
    sides = np.broadcast_to(np.asarray(within, dtype=float), x.shape)
    widest = float(sides.max(initial=0.0))
    flat = 1e-12 * max(float(np.abs(hessian).max(initial=0.0)), 1e-300)
    for _ in range(SWEEPS):
        before = x.copy()
        for i in range(len(x)):
            slope = gradient[i] + hessian[i] @ x - hessian[i, i] * x[i]
            if hessian[i, i] > flat:
                x[i] = np.clip(-slope / hessian[i, i], -sides[i], sides[i])
            elif abs(slope) > flat * widest:
                x[i] = -sides[i] * np.sign(slope)
        if np.abs(x - before).max(initial=0.0) < 1e-9 * widest:
            break
    return np.where(np.abs(x) < 1e-9 * widest, 0.0, x)


# -- the study ---------------------------------------------------------------------------------------------------------
def moves_study(
    machine: Machine,
    within: float | Sequence[float] = 50.0,
    costs: Mapping[str, Cost] | None = None,
    progress: Progress | None = None,
) -> MovesResult:
    """Derivatives by every point and travel, the best places within a box, and the best order of the axes.

    within : half side of the box, mm, or one for each of x, y and z (0: no move along it).  costs : of tolerances,
    widths in mm or rad.  progress : called with the part done; false cancels.  Refuses a box that is not above zero.
    """
    sides = np.broadcast_to(np.asarray(within, dtype=float), 3)
    if not (np.all(sides >= 0) and 0 < sides.max() < 1e6):
        raise Refused("moves-box", "--within", within=box_text(sides))
    names = list(points_of(machine))
    work, done = 2 * len(names) + len(machine.joints) + 2, itertools.count(1)

    def tell():
        if progress is not None and not progress(next(done) / work):
            raise Cancelled("cancelled")

    step = None if costs is None else cheapest_step(machine, costs)
    present = mean_square(machine)
    points = []
    for name, at in points_of(machine).items():
        changes = tuple(
            _change(machine, lambda d, n=name, a=axis: moved(machine, {n: d * np.eye(3)[a]}), "mm") for axis in range(3)
        )
        tell()
        best = best_in_box(*_quadratic(machine, [name]), sides)
        worth = None if step is None else step.price * np.abs([c.mean_square for c in changes])
        rms = float(np.sqrt(mean_square(moved(machine, {name: best}))))
        points.append(PointMoves(name, at, changes, best, rms, worth))
        tell()
    travel = []
    for joint in machine.joints:
        if joint.travel is not None:
            low, high = (
                _change(
                    machine, lambda d, j=joint, e=end: _with_travel(machine, j, e, d), "mm" if joint.slides else "rad"
                )
                for end in (0, 1)
            )
            travel.append(TravelMoves(joint.name, low, high))
        tell()
    free = [n for n in names if n != TOOL]
    all_best = best_in_box(*_quadratic(machine, free), np.tile(sides, len(free))).reshape(-1, 3)
    together = dict(zip(free, all_best))
    tell()
    found = _judged(machine)
    result = MovesResult(
        machine, present, float(found[1]), tuple(sides.tolist()), tuple(points), tuple(travel), together,
        float(np.sqrt(mean_square(moved(machine, together)))), orders(machine), step,
    )  # fmt: skip
    tell()
    return result


def _with_travel(machine: Machine, joint, end: int, by: float) -> Machine:
    span = list(joint.span)
    span[end] += by
    joints = tuple(replace(j, travel=tuple(span)) if j.name == joint.name else j for j in machine.joints)
    return replace(machine, joints=joints)


def orders(machine: Machine) -> tuple[Order, ...]:
    """All structures of the same joints, with the same points, the smallest rms first."""
    if len(machine.joints) > MOST_ORDERS:
        return ()
    found = []
    for chain in itertools.permutations(machine.names):
        for k in range(len(chain) + 1):
            other = replace(machine, workpiece_chain=tuple(reversed(chain[:k])), tool_chain=chain[k:])
            found.append(Order(other.structure, float(np.sqrt(mean_square(other)))))
    return tuple(sorted(found, key=lambda o: (round(o.rms, 12), o.structure)))


def cheapest_step(machine: Machine, costs: Mapping[str, Cost]) -> ToleranceStep | None:
    """The tolerance at which less mean square costs least: cost per mm², for a small step or the next grade."""
    table, where = error_table(machine), workspace.few_positions(machine)
    matrix = table.mixed(omega(machine, table.symbols, where.q))
    squared = where.weights @ np.einsum("pan,pan->pn", matrix, matrix)
    best = None
    for symbol, cost in costs.items():
        if symbol not in table.labels:
            raise Refused("cost-of-no-error", "costs", symbol=symbol)
        i = table.labels.index(symbol)
        law = table.laws[i]
        half, load = (law.upper - law.lower) / 2, squared[i]
        per_square = law.moments[1] / half**2 if half > 0 else 0.0  # variance per squared half width
        price = _price(cost, half, load * per_square)
        if price is not None and (best is None or price < best.price):
            best = ToleranceStep(symbol, price)
    return best


def _price(cost: Cost, half: float, load: float) -> float | None:
    """Cost per mm² of mean square (load * half²) of a tighter tolerance; None where there is none."""
    if load <= 0:
        return None
    if isinstance(cost, PowerCost):
        return cost.k * cost.c / (2 * load * half ** (cost.k + 2)) if half > cost.lower else None
    assert isinstance(cost, GradeCost)
    now = [g for g in cost.grades if g.w >= half]
    tighter = [g for g in cost.grades if g.w < half]
    if not tighter:
        return None
    paid = min((g.cost for g in now), default=0.0)
    return min(max(g.cost - paid, 0.0) / (load * (half**2 - g.w**2)) for g in tighter)


def box_text(sides) -> str:
    """Half sides of a box as text: `50`, or `0, 0, 100` where they differ."""
    texts = [f"{v:g}" for v in sides]
    return texts[0] if len(set(texts)) == 1 else ", ".join(texts)


def per_mm_percent(result: MovesResult, change: Change) -> float:
    """Change of the mean square per mm (or rad), in per cent of it."""
    return 100 * change.mean_square / result.mean_square


def um2(value: float) -> float:
    """mm² as um²."""
    return um(um(value))


def per_um2(price: float) -> float:
    """A price per mm² as one per um²."""
    return mm(mm(price))
