# SPDX-License-Identifier: LGPL-2.1-or-later
"""The predicted error over the workspace before compensation and after it, by the program's own predictor.

Positions are a grid over the travel, each approached from both sides.  A constant shift is not counted, before or
after: setting the work offset takes it up, and tables move it when they are zeroed somewhere else.  Effects that need
other columns (temperatures, time, loads) are left out of both figures and named, since a workspace has no temperature.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from sensworkbench.closedloop.predict import predict
from sensworkbench.closedloop.readings import Readings
from sensworkbench.core.errors import AXES
from sensworkbench.core.fitted import FittedModel
from sensworkbench.core.machine import Machine

from .axis_tables import correction
from .coverage import DIRECTION, POSITION, after_compensation

GRID = 7


@dataclass(frozen=True)
class Remaining:
    """rms and largest length of the error vector, um, before and after; left_out : effects in neither figure."""

    rms_before_um: float
    max_before_um: float
    rms_after_um: float
    max_after_um: float
    left_out: tuple[str, ...]


def workspace(machine: Machine, count: int = GRID) -> Readings:
    """count³ positions over the travel, each with all directions of approach + and -, without readings."""
    axes = [np.linspace(*machine.axes[k].travel, count) for k in AXES]
    q = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    q = np.concatenate([q, q])
    direction = np.repeat([1.0, -1.0], len(q) // 2)
    columns = {name: direction for name in DIRECTION}
    return Readings.from_vectors(q, np.full_like(q, np.nan), columns)


def remaining(machine: Machine, fmt: str, positions: Readings | None = None, tables=None) -> Remaining:
    """The error that the tables of `fmt` leave, in the machine's own frame (the set-up's alignment is left out).

    positions : places and conditions to judge at; without them the workspace grid.  tables : axis tables to judge
    instead of what the format could hold at best.
    """
    left_out: tuple[str, ...] = ()
    if positions is None:
        positions = workspace(machine)
        known = {*POSITION, *DIRECTION}
        left_out = tuple(e.name for e in machine.effects if e.enabled and not set(e.columns) <= known)
    effects = tuple(replace(e, enabled=False) if e.name in left_out else e for e in machine.effects)
    machine = replace(machine, effects=effects, fitted=machine.fitted or FittedModel())
    before = predict(machine, positions, alignment=False)
    if tables is None:
        after = predict(after_compensation(machine, fmt), positions, alignment=False)
    else:
        none = np.zeros(positions.points)
        direction = np.stack([positions.columns.get(name, none) for name in DIRECTION], axis=1)
        after = before - correction(machine, tables, positions.q, direction)
    figures = []
    for error in (before, after):
        length = np.linalg.norm(error - error.mean(axis=0), axis=1) * 1e3
        figures += [float(np.sqrt((length**2).mean())), float(length.max())]
    return Remaining(*figures, left_out)
