# SPDX-License-Identifier: LGPL-2.1-or-later
"""The predicted error over the workspace before compensation and after it, by the program's own predictor.

Positions are a grid over the travel, each approached from both sides.  A constant shift is not counted, before or
after: setting the work offset takes it up, and tables move it when they are zeroed somewhere else.  Effects that need
other columns (temperatures, time, loads) are left out of both figures and named, since a workspace has no temperature.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..closedloop.predict import predict
from ..closedloop.readings import Readings
from ..core.fitted import FittedModel
from ..core.machine import Machine
from ..core.units import um
from .axis_tables import correction, readings_at
from .coverage import Holder, after_compensation

GRID, COARSE = 7, 4  # positions per joint; of more than three joints


@dataclass(frozen=True)
class Remaining:
    """rms and largest length of the error vector, um, before and after; left_out : effects in neither figure."""

    rms_before_um: float
    max_before_um: float
    rms_after_um: float
    max_after_um: float
    left_out: tuple[str, ...]


def workspace(machine: Machine, count: int | None = None) -> Readings:
    """`count` positions per joint over the travel, each with all directions of approach + and -, without readings."""
    count = count or (GRID if len(machine.joints) <= 3 else COARSE)
    nodes = [np.linspace(*j.span, count) for j in machine.joints]
    q = np.stack([g.ravel() for g in np.meshgrid(*nodes, indexing="ij")], axis=1)
    q = np.concatenate([q, q])
    sense = np.repeat([1.0, -1.0], len(q) // 2)
    return readings_at(machine, q, np.repeat(sense[:, None], len(machine.joints), axis=1))


def remaining(machine: Machine, holder: Holder, positions: Readings | None = None, tables=None) -> Remaining:
    """The error that the tables of a format leave, in the machine's own frame (the set-up's alignment is left out).

    positions : places and conditions to judge at; without them the workspace grid.  tables : axis tables to judge
    instead of what the format could hold at best.
    """
    left_out: tuple[str, ...] = ()
    known = {j.column for j in machine.joints} | {f"dir_{j.column}" for j in machine.joints}
    if positions is None:
        positions = workspace(machine)
        left_out = tuple(e.name for e in machine.effects if e.enabled and not set(e.columns) <= known)
    effects = tuple(replace(e, enabled=False) if e.name in left_out else e for e in machine.effects)
    machine = replace(machine, effects=effects, fitted=machine.fitted or FittedModel())
    before = predict(machine, positions, alignment=False)
    if tables is None:
        after = predict(after_compensation(machine, holder), positions, alignment=False)
    else:
        none = np.zeros(positions.points)
        names = [f"dir_{j.column}" for j in machine.joints]
        direction = np.stack([positions.columns.get(name, none) for name in names], axis=1)
        after = before - correction(machine, tables, positions.q, direction)
    figures = []
    for error in (before, after):
        length = um(np.linalg.norm(error - error.mean(axis=0), axis=1))
        figures += [float(np.sqrt((length**2).mean())), float(length.max())]
    return Remaining(*figures, left_out)
