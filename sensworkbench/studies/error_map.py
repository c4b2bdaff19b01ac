# SPDX-License-Identifier: LGPL-2.1-or-later
"""The map of the error: the expected volumetric error, or an upper estimate of it, over the workspace or a slice."""

from __future__ import annotations

import numpy as np

from ..core.distributions import moments
from ..core.machine import Machine
from ..core.objectives import Objective
from ..core.synthesis import omega
from ..core.workspace import error_table

COUNT = 7  # points per joint
FINE = 25  # nodes of a slice per joint


def spanning(machine: Machine) -> tuple[int, ...]:
    """Numbers of the joints that span the workspace: the first three that slide, else the first three."""
    slides = [i for i, joint in enumerate(machine.joints) if joint.slides]
    return tuple((slides or range(len(machine.joints)))[:3])


def map_positions(machine: Machine, sliced: int | None = None, at: float = 0.0) -> np.ndarray:
    """Return (P, n) positions of the joints that span the workspace: COUNT per joint, or FINE per joint of a slice.

    sliced : number of the joint that is held at `at` (mm or rad, limited to its travel).  Joints that do not span the
    workspace stand at the middle of their travel.
    """
    nodes = [np.array([(a + b) / 2]) for a, b in machine.travel]
    for i in spanning(machine):
        nodes[i] = np.linspace(*machine.travel[i], COUNT if sliced is None else FINE)
    if sliced is not None:
        low, high = machine.travel[sliced]
        nodes[sliced] = np.array([min(max(at, low), high)])
    return np.stack([g.ravel() for g in np.meshgrid(*nodes, indexing="ij")], axis=1)


def map_errors(machine: Machine, objective: Objective, q: np.ndarray, upper: bool = False) -> np.ndarray:
    """(P,) the expected size of the error at positions q (P, n), or with `upper` an upper estimate; mm (rad).

    Of a sum of squares Y: sqrt(E[Y]), and sqrt(E[Y] + 2 sqrt(V(Y))).
    """
    _, columns, _, laws = error_table(machine)
    found = objective.indices(omega(machine, columns, q, output=objective.output), moments(laws))
    return objective.upper(found) if upper else objective.expected(found)
