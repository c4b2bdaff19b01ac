# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables that shift one axis by the position of one axis: what LinuxCNC, Heidenhain and Siemens controllers run.

The value is the *error* of the output axis, actual minus commanded tool position along its positive direction (ISO
sign, tool relative to workpiece, on both sides of the machine), mm; each writer turns it into what its controller
expects.  Tables hold the translations of the model, or (`through`) the whole error along the three lines through a
point, as a laser would measure it there.  Steps are halved until
linear interpolation is good to `TABLE_GOAL_MM`, or the controller's table is full.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from sensworkbench.closedloop.predict import predict
from sensworkbench.closedloop.readings import Readings
from sensworkbench.core.errors import AXES, SQUARENESS_SYMBOLS, component
from sensworkbench.core.fitted import FittedModel
from sensworkbench.core.machine import Machine

from .coverage import DIRECTION, Coverage, Drive, drive, line_obstacle
from .series import as_direction, series, squareness

TABLE_GOAL_MM = 2e-5
NOTHING_MM = 1e-8  # a table whose largest value is below this is not written


@dataclass(frozen=True)
class AxisTable:
    """Error of axis `output`, mm, where axis `source` is at `position` (n,) mm, moving up (`plus`) or down (`minus`).

    interpolation : largest error of linear interpolation between the points, mm.
    """

    source: str
    output: str
    position: np.ndarray
    plus: np.ndarray
    minus: np.ndarray
    interpolation: float

    @property
    def reverses(self) -> bool:
        """Whether the values differ between the two directions of travel."""
        return not np.array_equal(self.plus, self.minus)


def axis_tables(machine: Machine, coverage: Coverage, limit: int, through=None) -> dict[tuple[str, str], AxisTable]:
    """(source axis, output axis) -> table of everything that `coverage` lists; at most `limit` points each.

    through : (3,) programmed position, mm: the tables then hold the whole error along the lines through it.
    """
    machine = as_direction(machine)
    if through is None:
        parts = _contributions(machine, coverage)
    else:
        parts = _lines(machine, coverage.format, np.asarray(through, dtype=float))
    tables = {}
    for source in AXES:
        pairs = [(s, o) for s, o in parts if s == source]
        for pair in pairs:
            tables[pair] = _sampled(pair, parts[pair], machine.axes[source].travel, limit)
    return tables


def _contributions(machine: Machine, coverage: Coverage) -> dict[tuple[str, str], list[Callable]]:
    parts: dict[tuple[str, str], list[Callable]] = {}
    u = machine.directions
    # along the machine frame -> along the positive direction of the output axis, which may count the other way
    sign = {k: float(np.sign(u[k][i])) for i, k in enumerate(AXES)}

    def add(source, output, function):
        parts.setdefault((source, output), []).append(lambda q, d: sign[output] * function(q, d))

    for symbol in coverage.symbols:
        c = component(symbol)
        if symbol in SQUARENESS_SYMBOLS:
            turn = np.zeros(3)
            turn[c.axis] = squareness(machine, symbol)
            slope = np.cross(turn, u[c.body])
            for i, output in enumerate(AXES):
                if abs(slope[i]) > 0.1 * abs(turn[c.axis]):  # the rest is a skew of the design, second order
                    add(c.body, output, lambda q, d, s=slope[i]: s * q)
        else:
            add(c.body, AXES[c.axis], lambda q, d, f=series(machine, symbol): f(q))
    for effect in machine.effects:
        if effect.enabled and effect.name in coverage.effects:
            at = drive(effect)
            source = at.direction or at.axes[0]
            add(source, AXES[component(effect.component).axis], lambda q, d, e=effect, s=source: _effect(e, s, q, d))
    return parts


def _lines(machine: Machine, fmt: str, through) -> dict[tuple[str, str], list[Callable]]:
    """Return the whole error along the line of each axis through a point; the error at the point is in each axis's own
    table.

    Reversals of the other axes are taken at their mean; effects that no table of positions can hold are omitted.
    """
    known = tuple(e for e in machine.effects if isinstance(drive(e), Drive))
    machine = replace(machine, effects=known, fitted=machine.fitted or FittedModel())
    u = machine.directions

    def error(q, direction):
        columns = dict(zip(DIRECTION, direction.T, strict=True))
        places = Readings.from_vectors(q, np.full_like(q, np.nan), columns)
        return predict(machine, places, alignment=False)

    at = error(through[None], np.zeros((1, 3)))[0]
    parts: dict[tuple[str, str], list[Callable]] = {}
    for i, source in enumerate(AXES):
        for output in AXES:
            if line_obstacle(fmt, source, output, False):
                continue
            reverses = not line_obstacle(fmt, source, output, True)

            def along(q, d, i=i, output=output, reverses=reverses, own=source == output):
                line = np.repeat(through[None], len(q), axis=0)
                line[:, i] = q
                direction = np.zeros_like(line)
                direction[:, i] = d if reverses else 0.0
                return (error(line, direction) - (0.0 if own else at)) @ u[output]

            probe = machine.axes[source].travel
            grid = np.linspace(*probe, 17)
            if max(np.abs(along(grid, d)).max() for d in (1.0, -1.0)) > NOTHING_MM:
                parts[source, output] = [along]
    return parts


def correction(machine: Machine, tables: dict[tuple[str, str], AxisTable], q, direction) -> np.ndarray:
    """(P, 3) mm in the machine frame: what the tables take out at q (P, 3) mm, approached by direction (P, 3)."""
    q, direction = np.asarray(q, dtype=float), np.asarray(direction, dtype=float)
    u, out = machine.directions, np.zeros_like(q)
    for (source, output), table in tables.items():
        i = AXES.index(source)
        plus, minus = (np.interp(q[:, i], table.position, v) for v in (table.plus, table.minus))
        out += np.where(direction[:, i] < 0, minus, plus)[:, None] * u[output]
    return out


def _effect(effect, source, q, direction):
    name = source.lower()
    return effect.values({name: q, f"dir_{name}": np.full_like(q, direction)})


def _sampled(pair, functions, travel, limit: int) -> AxisTable:
    def value(q, direction):
        return sum((f(q, direction) for f in functions), np.zeros_like(q))

    low, high = travel
    count = 3
    while True:
        position = np.linspace(low, high, count)
        between = np.linspace(low, high, 8 * (count - 1) + 1)
        plus, minus = value(position, 1.0), value(position, -1.0)
        worst = max(
            float(np.abs(np.interp(between, position, table) - value(between, d)).max())
            for table, d in ((plus, 1.0), (minus, -1.0))
        )
        if worst <= TABLE_GOAL_MM or count >= limit:
            break
        count = min(2 * count - 1, limit)
    return AxisTable(*pair, position, plus, minus, worst)
