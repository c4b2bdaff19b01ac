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
from typing import Protocol

import numpy as np

from ..closedloop.predict import predict
from ..closedloop.readings import Readings
from ..core.fitted import FittedModel
from ..core.machine import Machine
from ..messages import Message
from .coverage import Coverage, Drive, along, drive, table_axes
from .fitted_errors import as_direction, line_error, series

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


class Shifter(Protocol):
    """A format of axis tables as this study sees it.  limit : points of a table."""

    limit: int

    def shifts(self, source: str, output: str, reverses: bool) -> Message | None:
        """Why it has no table that shifts `output` by the position (and direction) of `source`; None where it has."""


def axis_tables(
    machine: Machine, coverage: Coverage, shifter: Shifter, through=None
) -> dict[tuple[str, str], AxisTable]:
    """(source axis, output axis) -> table of everything that `coverage` lists.

    through : a value per joint, mm or rad: the tables then hold the whole error along the lines through it.
    """
    machine = as_direction(machine)
    if through is None:
        parts = _contributions(machine, coverage)
    else:
        parts = _lines(machine, shifter, np.asarray(through, dtype=float))
    tables = {}
    for source in table_axes(machine):
        for pair in [(s, o) for s, o in parts if s == source]:
            tables[pair] = _sampled(pair, parts[pair], machine.joint(source).span, shifter.limit)
    return tables


def _contributions(machine: Machine, coverage: Coverage) -> dict[tuple[str, str], list[Callable]]:
    parts: dict[tuple[str, str], list[Callable]] = {}
    u = machine.directions
    axis_of = {k: machine.component(f"EX{k}").along for k in table_axes(machine)}
    # along the machine frame -> along the positive direction of the output axis, which may count the other way
    sign = {k: float(np.sign(u[k][i])) for k, i in axis_of.items()}

    def add(source, output, function):
        parts.setdefault((source, output), []).append(lambda q, d: sign[output] * function(q, d))

    for symbol in coverage.symbols:
        c = machine.component(symbol)
        if c.line:
            turn = np.zeros(3)
            turn[c.axis] = line_error(machine, symbol)
            slope = np.cross(turn, u[c.body])
            for output, i in axis_of.items():
                if abs(slope[i]) > 0.1 * abs(turn[c.axis]):  # the rest is a skew of the design, second order
                    add(c.body, output, lambda q, d, s=slope[i]: s * q)
        else:
            add(c.body, along(machine, c.axis), lambda q, d, f=series(machine, symbol): f(q))
    for effect in machine.effects:
        if effect.enabled and effect.name in coverage.effects:
            at = drive(machine, effect)
            source, output = at.direction or at.axes[0], along(machine, machine.component(effect.component).axis)
            add(source, output, lambda q, d, e=effect, s=source: _effect(machine, e, s, q, d))
    return parts


def _lines(machine: Machine, shifter: Shifter, through) -> dict[tuple[str, str], list[Callable]]:
    """Return the whole error along the line of each axis through a point; the error at the point is in each axis's own
    table.

    Reversals of the other axes are taken at their mean; effects that no table of positions can hold are omitted.
    """
    known = tuple(e for e in machine.effects if isinstance(drive(machine, e), Drive))
    machine = replace(machine, effects=known, fitted=machine.fitted or FittedModel())
    axes, u = table_axes(machine), _output_directions(machine, through[None])

    def error(q, direction):
        places = readings_at(machine, q, direction)
        return predict(machine, places, alignment=False)

    at = error(through[None], np.zeros((1, len(through))))[0]
    parts: dict[tuple[str, str], list[Callable]] = {}
    for source in axes:
        i = machine.names.index(source)
        for output in axes:
            if shifter.shifts(source, output, False) is not None:
                continue
            reverses = shifter.shifts(source, output, True) is None

            def along_line(q, d, i=i, output=output, reverses=reverses, own=source == output):
                line = np.repeat(through[None], len(q), axis=0)
                line[:, i] = q
                direction = np.zeros_like(line)
                direction[:, i] = d if reverses else 0.0
                return (error(line, direction) - (0.0 if own else at)) @ u[output][0]

            grid = np.linspace(*machine.joint(source).span, 17)
            if max(np.abs(along_line(grid, d)).max() for d in (1.0, -1.0)) > NOTHING_MM:
                parts[source, output] = [along_line]
    return parts


def readings_at(machine: Machine, q, direction) -> Readings:
    """Positions q (P, n) mm or rad, approached by direction (P, n), without readings."""
    columns = {f"dir_{j.column}": direction[:, i] for i, j in enumerate(machine.joints)}
    for i, j in enumerate(machine.joints):
        columns[j.column] = j.to_shown(q[:, i])
    return Readings.from_vectors(q, np.full((len(q), 3), np.nan), columns)


def _output_directions(machine: Machine, q) -> dict[str, np.ndarray]:
    """Axis -> (P, 3) its direction as the workpiece sees it at q (P, n); rotary joints before it turn it."""
    poses = machine.carriers(q)
    found = {}
    for name in table_axes(machine):
        turned = poses["W"].back(poses[name].turn(machine.directions[name]))
        found[name] = np.broadcast_to(np.reshape(turned, (3, -1)).T, (len(q), 3))
    return found


def correction(machine: Machine, tables: dict[tuple[str, str], AxisTable], q, direction) -> np.ndarray:
    """(P, 3) mm in the workpiece's frame: what the tables take out at q (P, n), approached by direction (P, n)."""
    q, direction = np.asarray(q, dtype=float), np.asarray(direction, dtype=float)
    u, out = _output_directions(machine, q), np.zeros((len(q), 3))
    for (source, output), table in tables.items():
        i = machine.names.index(source)
        plus, minus = (np.interp(q[:, i], table.position, v) for v in (table.plus, table.minus))
        out += np.where(direction[:, i] < 0, minus, plus)[:, None] * u[output]
    return out


def _effect(machine, effect, source, q, direction):
    name = machine.joint(source).column
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
