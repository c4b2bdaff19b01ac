# SPDX-License-Identifier: LGPL-2.1-or-later
"""From moves or points to the path that a part study judges: where the tool cuts, when, and under which conditions."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from ..closedloop.readings import Readings
from ..core.driver import TIME
from ..core.machine import Machine
from ..core.refusal import Refused
from ..core.toolpath import MOST_POINTS, RAPID, STEP_MM, Moves, ToolPath, counts, directions_of, sample

RAPID_MM_MIN = 10_000.0
BLOCK = "block"


@dataclass(frozen=True)
class Conditions:
    """Condition columns over time or over the lines of the program, held from each row to the next.

    at : (C,) s or line numbers, increasing.  by : "t" or "block".  columns : name -> (C,) in internal units.  held :
    name -> value of columns that keep one value.
    """

    at: np.ndarray = field(default_factory=lambda: np.empty(0))
    by: str = TIME
    columns: Mapping[str, np.ndarray] = field(default_factory=dict)
    held: Mapping[str, float] = field(default_factory=dict)

    def over(self, t, block) -> dict[str, np.ndarray]:
        """name -> (P,) values at times t (P,) s and lines block (P,).  Before the first row its values hold."""
        out = {name: np.full(len(block), value) for name, value in self.held.items()}
        if not self.columns:
            return out
        if self.by == TIME and t is None:
            raise Refused("part-no-time", "conditions")
        where = np.searchsorted(self.at, t if self.by == TIME else block, side="right") - 1
        return {name: values[np.maximum(where, 0)] for name, values in self.columns.items()} | out


def of_moves(
    machine: Machine,
    moves: Moves,
    conditions: Conditions = Conditions(),
    features: Mapping[str, Sequence[int]] | None = None,
    step: float = STEP_MM,
    most: int = MOST_POINTS,
    rapid: float = RAPID_MM_MIN,
    number: np.ndarray | None = None,
) -> tuple[ToolPath, float]:
    """(path, step used) of moves.  features : name -> rows of the moves that make it.  rapid : mm/min, for the time.
    number : (M,) intervals of each move, instead of those of `step`."""
    if number is None:
        number, step = counts(moves, step, most)
    of_feature = {n: np.asarray(sorted(rows), dtype=int) for n, rows in (features or {}).items()}
    fresh = [int(r) for rows in of_feature.values() for r in rows[np.diff(rows, prepend=-5) != 1]]
    found = sample(moves, number, rapid, [r for r in fresh if moves.kind[r] != RAPID])
    m = found.move
    cutting = moves.kind[m] != RAPID
    known = machine.axes
    directions = np.stack([machine.directions[k] if k in known else unit for k, unit in zip("XYZ", np.eye(3))])
    normal = found.normal @ directions
    tip = -moves.length[m][:, None] * directions[2]
    contact = tip - np.where(np.isfinite(normal), moves.radius[m][:, None] * normal, 0.0)
    columns = _columns(machine, found.q, np.where(cutting, moves.feed[m], rapid), moves.spindle[m], found.t)
    columns |= conditions.over(found.t, moves.block[m])
    labels = {}
    for name, rows in of_feature.items():
        chosen = np.zeros(len(moves), dtype=bool)
        chosen[rows] = True
        labels[name] = np.flatnonzero(chosen[m] & cutting & (np.isfinite(normal[:, 0]) | (moves.side[m] == 0)))
    path = ToolPath(
        q=found.q,
        line=moves.block[m],
        cutting=cutting,
        normal=normal,
        tip=tip,
        contact=contact,
        written=found.contour - moves.shift[m],
        columns=columns,
        labels=labels,
        move=m,
        fraction=found.fraction,
    )
    return path, step


def _columns(machine: Machine, q, feed, spindle, t) -> dict[str, np.ndarray]:
    columns = {j.column: j.to_shown(q[:, i]) for i, j in enumerate(machine.joints)}
    sense = directions_of(q)
    columns |= {f"dir_{j.column}": sense[:, i] for i, j in enumerate(machine.joints)}
    columns |= {"feed": feed, "spindle": spindle}
    return columns | ({} if t is None else {TIME: t})


def of_points(
    machine: Machine,
    positions: Readings,
    normal: np.ndarray | None,
    labels: Mapping[str, np.ndarray],
    conditions: Conditions = Conditions(),
    radius: float = 0.0,
) -> ToolPath:
    """The path of points, in their order.  normal : (P, 3) outward, NaN where not known, or None.  labels : feature ->
    rows.  radius : of a ball whose tip the points are: the point that cuts is half a ball nearer to the surface."""
    q, given = positions.q, dict(positions.columns)
    senses = directions_of(q)
    columns = {f"dir_{j.column}": senses[:, i] for i, j in enumerate(machine.joints)}
    if TIME not in given and "feed" in given:
        if not (given["feed"] > 0).all():
            row = int(np.argmin(given["feed"] > 0))
            raise Refused("gcode-no-feed", f"line {int(positions.line[row])}")
        length = np.linalg.norm(np.diff(q, axis=0), axis=1)
        columns[TIME] = np.concatenate([[0.0], np.cumsum(60 * length / given["feed"][1:])])
    columns |= given
    columns |= conditions.over(columns.get(TIME), positions.line)
    tip = np.zeros((len(q), 3)) if positions.tool_offset is None else positions.tool_offset
    if normal is None:
        normal = np.full((len(q), 3), np.nan)
    contact = tip
    if radius:
        up = machine.directions[machine.tool_chain[-1]] if machine.tool_chain else np.array([0.0, 0.0, 1.0])
        contact = tip + np.where(np.isfinite(normal), radius * (up - normal), 0.0)
    return ToolPath(
        q=q,
        line=positions.line,
        cutting=np.ones(len(q), dtype=bool),
        normal=normal,
        tip=tip,
        contact=contact,
        written=q,
        columns=columns,
        labels=labels,
    )
