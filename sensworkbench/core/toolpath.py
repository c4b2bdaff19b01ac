# SPDX-License-Identifier: LGPL-2.1-or-later
"""A tool path: moves as a controller makes them (rapid, line, arc, helix), and the points at which a part is judged.

Positions are those of the machine's joints, mm and rad.  A move that is compensated for the cutter's radius runs along
the contour of the part: its tip is the contour point and the radius along the normal.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

RAPID, LINE, ARC = 0, 1, 2
STEP_MM, MOST_POINTS = 1.0, 1_000_000
LEAST_OF_TURN = 64  # points of a full circle
_PLANES = ((1, 2), (2, 0), (0, 1))  # first and second axis of the plane square to X, Y, Z: G19, G18, G17


@dataclass(frozen=True)
class Moves:
    """M moves of a machine with J joints, in the order of the program.

    kind (M,): RAPID, LINE or ARC.  begin, end : (M, J) of the contour, mm or rad; known (M,): whether the beginning is.
    centre : (M, 3) of an arc, along X, Y, Z; plane (M,): the axis square to it; sweep (M,): its angle, rad, counter-
    clockwise about that axis positive.  feed : (M,) mm/min, NaN of a rapid.  dwell : (M,) s after it.  spindle : (M,)
    rpm.  block : (M,) line of the program, from 1.  shift : (M, J) position less the coordinates of the program.
    length : (M,) mm by which the tip stands beyond the tool point.  side : (M,) +1 where the tool is left of the path,
    -1 right, 0 on it; radius : (M,) of the cutter, mm; surface : (M,) whether it makes surface.
    xyz : for X, Y, Z the column of the joint, or -1.
    """

    kind: np.ndarray
    begin: np.ndarray
    end: np.ndarray
    known: np.ndarray
    centre: np.ndarray
    plane: np.ndarray
    sweep: np.ndarray
    feed: np.ndarray
    dwell: np.ndarray
    spindle: np.ndarray
    block: np.ndarray
    shift: np.ndarray
    length: np.ndarray
    side: np.ndarray
    radius: np.ndarray
    surface: np.ndarray
    xyz: tuple[int, int, int] = (0, 1, 2)

    def __len__(self) -> int:
        return len(self.kind)

    def lengths(self) -> np.ndarray:
        """(M,) length of each move along linear joints, mm; 0 where its beginning is not known."""
        ends = np.where(self.known[:, None], self.end - self.begin, 0.0)
        straight = np.linalg.norm(ends[:, [i for i in self.xyz if i >= 0]], axis=1)
        rotary = np.linalg.norm(ends, axis=1)
        arc = self.kind == ARC
        radius = self._radii()[0]
        rise = np.zeros(len(self))
        for axis in range(3):
            if self.xyz[axis] >= 0:
                rise = np.where(self.plane == axis, ends[:, self.xyz[axis]], rise)
        turned = np.hypot(radius * self.sweep, rise)
        return np.where(arc, turned, np.where(straight > 0, straight, rotary))

    def _radii(self) -> tuple[np.ndarray, np.ndarray]:
        """(M,) radius of each arc at its beginning and at its end; 0 of other moves."""
        found = np.zeros((2, len(self)))
        for axis, (a, b) in enumerate(_PLANES):
            if self.xyz[a] < 0 or self.xyz[b] < 0:
                continue
            mask = (self.kind == ARC) & (self.plane == axis)
            for row, place in zip(found, (self.begin, self.end)):
                row[mask] = np.hypot(
                    place[mask, self.xyz[a]] - self.centre[mask, a], place[mask, self.xyz[b]] - self.centre[mask, b]
                )
        return found[0], found[1]


@dataclass(frozen=True)
class ToolPath:
    """P points of a path.

    q : (P, J) positions of the joints, mm or rad.  line : (P,) line of the file.  cutting : (P,) whether it cuts.
    normal : (P, 3) outward normal of the surface in the machine frame, NaN where it is not known.  tip : (P, 3) tip
    less the machine's tool point, and contact : (P, 3) point that cuts less the tool point, mm, machine frame.
    written : (P, J) coordinates as the file writes them.  columns : driver columns (P,) in internal units.
    labels : feature -> rows.  move, fraction : (P,) of moves, where the path has moves.
    """

    q: np.ndarray
    line: np.ndarray
    cutting: np.ndarray
    normal: np.ndarray
    tip: np.ndarray
    contact: np.ndarray
    written: np.ndarray
    columns: Mapping[str, np.ndarray]
    labels: Mapping[str, np.ndarray] = field(default_factory=dict)
    move: np.ndarray | None = None
    fraction: np.ndarray | None = None

    @property
    def points(self) -> int:
        """Number of points."""
        return len(self.q)


def counts(moves: Moves, step: float = STEP_MM, most: int = MOST_POINTS) -> tuple[np.ndarray, float]:
    """((M,) intervals of each move, step): one for a rapid, so many of `step` mm for the others.

    The step grows until there are no more than `most` points.  A full circle has a multiple of 8 intervals.
    """
    length, turn = moves.lengths(), np.abs(moves.sweep) / (2 * np.pi)
    cuts, arc = moves.kind != RAPID, moves.kind == ARC
    while True:
        number = np.where(cuts, np.maximum(np.ceil(length / step - 1e-9), 1), 1)
        per_turn = np.divide(length, np.maximum(turn, 1e-12) * 8 * step, out=np.zeros(len(moves)), where=arc)
        per_turn = np.maximum(8 * np.ceil(np.minimum(per_turn, 1e9)), LEAST_OF_TURN)
        number = np.where(arc, np.maximum(np.ceil(turn * per_turn - 1e-9), 1), number)
        if number.sum() <= most or step > 1e6:
            return number.astype(int), step
        step *= 1.25 * max(1.0, number.sum() / most / 2)


def directions_of(q) -> np.ndarray:
    """(P, J) sense in which each joint moved last to reach each point, -1, 0 (not yet) or +1."""
    q = np.asarray(q, dtype=float)
    sense = np.zeros(q.shape)
    if len(q) > 1:
        change = np.diff(q, axis=0)
        sense[1:] = np.where(np.abs(change) > 1e-9, np.sign(change), 0.0)
    row = np.arange(len(q))[:, None]
    last = np.maximum.accumulate(np.where(sense != 0, row, -1), axis=0)
    return np.where(last >= 0, np.take_along_axis(sense, np.maximum(last, 0), axis=0), 0.0)


@dataclass(frozen=True)
class Samples:
    """Points of moves.  q, contour : (P, J) of the tip and of the contour.  move, fraction : (P,).  normal : (P, 3)
    outward normal along X, Y, Z where the side of the cutter is known, else NaN.  t : (P,) s from the beginning."""

    q: np.ndarray
    contour: np.ndarray
    move: np.ndarray
    fraction: np.ndarray
    normal: np.ndarray
    t: np.ndarray


def sample(moves: Moves, number, rapid: float, fresh=()) -> Samples:
    """Points of moves with `number` (M,) equal intervals each.

    rapid : mm/min of rapids, which only the time needs.  fresh : rows of moves whose beginning is a point of its own:
    the first of a feature; so is every beginning of cutting.  Where the beginning is not known there is only the end.
    """
    count = len(moves)
    cuts = moves.kind != RAPID
    first = np.zeros(count, dtype=bool)
    first[1:] = cuts[1:] & (~cuts[:-1] | (moves.side[1:] != moves.side[:-1]))
    first[list(fresh)] = True
    first[:1] = True
    first &= moves.known
    points = number + first
    move = np.repeat(np.arange(count), points)
    within = np.arange(len(move)) - np.repeat(np.cumsum(points) - points, points)
    fraction = (within + 1 - first[move]) / number[move]
    contour, tangent = _places(moves, move, fraction)
    q, normal = contour.copy(), np.full((len(move), 3), np.nan)
    sided = np.flatnonzero(moves.side[move] != 0)
    if len(sided):
        m = move[sided]
        left = np.zeros((len(sided), 3))
        for axis, (a, b) in enumerate(_PLANES):
            mask = moves.plane[m] == axis
            left[mask, a], left[mask, b] = -tangent[sided[mask], b], tangent[sided[mask], a]
        size = np.linalg.norm(left, axis=1)
        left = left / np.where(size > 0, size, 1.0)[:, None] * moves.side[m][:, None]
        plain = moves.surface[m] & (size > 0)
        normal[sided[plain]] = left[plain]
        for axis in range(3):
            if moves.xyz[axis] >= 0:
                q[sided, moves.xyz[axis]] += np.where(size > 0, moves.radius[m], 0.0) * left[:, axis]
    length = moves.lengths()
    speed = np.where(cuts, moves.feed, rapid)
    lasts = 60 * np.divide(length, speed, out=np.zeros(count), where=speed > 0)
    begins = np.cumsum(lasts + moves.dwell) - (lasts + moves.dwell)
    return Samples(q, contour, move, fraction, normal, begins[move] + fraction * lasts[move])


def _places(moves: Moves, move, fraction) -> tuple[np.ndarray, np.ndarray]:
    """((P, J) contour, (P, 3) direction of motion along X, Y, Z, not of unit length)."""
    begin = np.where(moves.known[:, None], moves.begin, moves.end)
    change = (moves.end - begin)[move]
    place = begin[move] + fraction[:, None] * change
    at_end = fraction >= 1.0
    place[at_end] = moves.end[move[at_end]]
    tangent = np.zeros((len(move), 3))
    for axis in range(3):
        if moves.xyz[axis] >= 0:
            tangent[:, axis] = change[:, moves.xyz[axis]]
    radius_0, radius_1 = moves._radii()
    for axis, (a, b) in enumerate(_PLANES):
        rows = np.flatnonzero((moves.kind[move] == ARC) & (moves.plane[move] == axis))
        if not len(rows):
            continue
        m, f = move[rows], fraction[rows]
        i, j = moves.xyz[a], moves.xyz[b]
        start = np.arctan2(begin[m, j] - moves.centre[m, b], begin[m, i] - moves.centre[m, a])
        angle = start + f * moves.sweep[m]
        radius = radius_0[m] + f * (radius_1[m] - radius_0[m])
        inner = f < 1.0
        place[rows[inner], i] = (moves.centre[m, a] + radius * np.cos(angle))[inner]
        place[rows[inner], j] = (moves.centre[m, b] + radius * np.sin(angle))[inner]
        sense = np.sign(moves.sweep[m])
        tangent[rows, a], tangent[rows, b] = -sense * np.sin(angle), sense * np.cos(angle)
    return place, tangent
