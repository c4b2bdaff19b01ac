# SPDX-License-Identifier: LGPL-2.1-or-later
"""The path that a machine has to be told so that the part comes out as programmed: points moved against the error.

The error changes by about 1e-5 of a displacement, so that one step leaves nothing of note.  Arcs become lines, and long
lines several, so that neither the arc nor the error between two points is missed by more than the tolerance.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..core.features import Feature, coefficients, judge
from ..core.machine import Machine
from ..core.refusal import Refused
from ..core.toolpath import ARC, LINE, MOST_POINTS, Moves, ToolPath, counts
from .part import errors_of
from .part_errors import chunks
from .part_path import RAPID_MM_MIN, Conditions, of_moves

LOOK_MM = 2.0  # distance at which the error along a line is looked at
TOLERANCE_MM, LIMIT_MM = 2e-4, 0.1


@dataclass(frozen=True)
class Correction:
    """What becomes of M moves.

    points : per move (k, J) ends of its pieces, mm or rad, of the contour; fractions : (k,) of the move at each.
    largest : mm, largest shift.  clipped : number of points at which the limit cut the shift.  before, after : (P, 3)
    mm, error and remainder at the points of `path`, by the functions that were used.
    """

    points: Sequence[np.ndarray]
    fractions: Sequence[np.ndarray]
    largest: float
    clipped: int
    before: np.ndarray
    after: np.ndarray
    path: ToolPath

    @property
    def pieces(self) -> int:
        """Number of pieces of all moves."""
        return sum(len(p) for p in self.points)


def correction(
    machine: Machine,
    moves: Moves,
    kept,
    conditions: Conditions = Conditions(),
    tolerance: float = TOLERANCE_MM,
    limit: float = LIMIT_MM,
    features: Mapping[str, Sequence[int]] | None = None,
    rapid: float = RAPID_MM_MIN,
    assign: Callable[[ToolPath], ToolPath] | None = None,
) -> Correction:
    """The moves corrected for the fitted errors and effects of a machine.

    kept : (M,) moves that stay as they are.  tolerance : mm.  limit : mm, no point is moved further.
    assign : of the path by which the correction is judged: its points to the faces that they cut.
    Refuses machines with rotary joints or without X, Y, Z, and machines of which nothing is fitted.
    """
    if min(moves.xyz) < 0 or not all(j.slides for j in machine.joints):
        raise Refused("part-correct-axes", machine.name, known=list(machine.names))
    number = _number(moves, tolerance)
    path, _ = of_moves(machine, moves, conditions, rapid=rapid, number=number)
    back = np.linalg.inv(np.stack([machine.directions[k] for k in "XYZ"], axis=1))
    moved = np.zeros((path.points, len(machine.joints)))
    shift = -_errors(machine, path) @ back.T
    size = np.linalg.norm(shift, axis=1)
    over = size > limit
    shift[over] *= (limit / size[over])[:, None]
    moved[:, list(moves.xyz)] = shift
    moved[np.asarray(kept)[path.move]] = 0.0
    contour = path.written + moves.shift[path.move]
    begins = np.searchsorted(path.move, np.arange(len(moves) + 1))
    points, fractions = [], []
    for m in range(len(moves)):
        rows = np.arange(begins[m], begins[m + 1])
        if path.fraction[rows[0]] == 0.0 and len(rows) > 1:
            first, rows = moved[rows[0]], rows[1:]
        else:
            first = moved[rows[0] - 1] if rows[0] else moved[rows[0]]
        if moves.kind[m] == LINE and len(rows) > 1:
            rows = rows[_needed(path.fraction[rows], np.vstack([first, moved[rows]]), tolerance)]
        points.append(contour[rows] + moved[rows])
        fractions.append(path.fraction[rows])
    twice, _ = of_moves(machine, moves, conditions, features, rapid=rapid, number=2 * number)
    twice = twice if assign is None else assign(twice)
    before, after = left_by(lambda p: _errors(machine, p), machine, moves, twice, points, fractions)
    return Correction(points, fractions, float(np.minimum(size, limit).max()), int(over.sum()), before, after, twice)


def _number(moves: Moves, tolerance: float) -> np.ndarray:
    """(M,) pieces at which the error is looked at: lines every LOOK_MM, arcs so that their chords are within half of
    the tolerance."""
    number, _ = counts(moves, LOOK_MM, MOST_POINTS)
    radius = np.maximum(*moves._radii())
    angle = 2 * np.arccos(np.clip(1 - tolerance / 2 / np.maximum(radius, tolerance), -1, 1))
    arcs = np.maximum(np.ceil(np.abs(moves.sweep) / angle), number).astype(int)
    number = np.where(moves.kind == ARC, arcs, number)
    if number.sum() > MOST_POINTS:
        raise Refused("part-correct-too-many", "--correct-tolerance", count=int(number.sum()), limit=MOST_POINTS)
    return number


def _errors(machine: Machine, path: ToolPath) -> np.ndarray:
    errors = errors_of(machine, path, "fitted")
    out = np.empty((path.points, 3))
    for part in chunks(np.arange(path.points)):
        out[part] = errors.error(part)
    return out


def _needed(fraction, values, tolerance: float) -> np.ndarray:
    """Rows of a line's points (without its beginning) between which `values` (k + 1, J), beginning first, are linear to
    within half of the tolerance."""
    at = np.concatenate([[0.0], fraction])
    keep, todo = {len(at) - 1}, [(0, len(at) - 1)]
    while todo:
        low, high = todo.pop()
        if high - low < 2:
            continue
        part = (at[low : high + 1] - at[low]) / (at[high] - at[low])
        off = values[low : high + 1] - values[low] - part[:, None] * (values[high] - values[low])
        sizes = np.linalg.norm(off, axis=1)
        worst = int(np.argmax(sizes))
        if sizes[worst] > tolerance / 2:
            keep.add(low + worst)
            todo += [(low, low + worst), (low + worst, high)]
    return np.array(sorted(keep)) - 1


def left_by(
    error_of: Callable[[ToolPath], np.ndarray], machine: Machine, moves: Moves, path: ToolPath, points, fractions
) -> tuple[np.ndarray, np.ndarray]:
    """(error, what is left of it), (P, 3) mm each, at the points of a path with the corrected ends of the pieces.

    error_of : path -> (P, 3) mm; another one than that of the correction shows what a machine leaves that is otherwise.
    """
    before = error_of(path)
    contour = path.written + moves.shift[path.move]
    new = contour.copy()
    begins = np.searchsorted(path.move, np.arange(len(moves) + 1))
    last = None
    for m in range(len(moves)):
        rows = slice(begins[m], begins[m + 1])
        ends, at = points[m], fractions[m]
        start = last if last is not None and moves.known[m] else ends[0]
        at, ends = np.concatenate([[0.0], at]), np.vstack([start, ends])
        for j in moves.xyz:
            new[rows, j] = np.interp(path.fraction[rows], at, ends[:, j])
        last = ends[-1]
    moved = new - contour
    shown = {j.column: j.to_shown(path.q[:, i] + moved[:, i]) for i, j in enumerate(machine.joints)}
    again = replace(path, q=path.q + moved, columns=dict(path.columns) | shown)
    directions = np.stack([machine.directions[k] for k in "XYZ"])
    return before, moved[:, list(moves.xyz)] @ directions + error_of(again)


def known_uncertainty(machine: Machine, path: ToolPath) -> float | None:
    """Root mean square over the cutting points of the standard uncertainty of the fitted functions, mm; None where no
    uncertainty is known."""
    errors = errors_of(machine, path, "fitted")
    if not errors.known_u:
        return None
    rows = np.flatnonzero(path.cutting)
    rows = rows[np.unique(np.linspace(0, len(rows) - 1, 500).astype(int))]
    return float(np.sqrt(((errors.parameters(rows) @ errors.factor) ** 2).sum(axis=(1, 2)).mean()))


def value_under(found: Feature, path: ToolPath, error) -> float:
    """The value of a feature (mm) where its points are displaced by `error` (P, 3) mm."""
    surface, datum = found.surface, found.datum
    departures = surface.departures(error[path.labels[surface.name]])
    turn = place = None
    if found.along is not None:
        place = surface.place @ coefficients(surface, departures)
    if datum is not None:
        own = coefficients(datum, datum.departures(error[path.labels[datum.name]]))
        if place is None:
            turn = datum.tilt[0] @ own
        else:
            place = place - datum.place @ own
    return judge(found, departures, turn, place).value
