# SPDX-License-Identifier: LGPL-2.1-or-later
"""The trace study: from readings to the effects that the model lacks, and the values that its pictures show."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from ..closedloop.readings import Readings
from ..closedloop.result import TraceEvidence, TraceResult
from ..closedloop.trace import trace
from ..core.effects import Effect
from ..core.errors import component
from ..core.machine import Machine
from ..core.refusal import Refused
from ..core.synthesis import omega
from ..core.units import mm
from .places import within_travel

FEWEST, MOST = 199, 9999  # permutations
SHORT_ARM = 1 / 3  # of the longest column of Omega: readings below it say little about a component


@dataclass(frozen=True)
class TraceRequest:
    """seed : of permutations and half-samples.  permutations : behind each p, FEWEST to MOST.

    alignment : of the set-up, "once", "offset per run" or "per run", in place of what the readings state; "": as they
    state.
    """

    seed: int = 0
    permutations: int = FEWEST
    alignment: str = ""


def trace_study(
    machine: Machine,
    readings: Readings,
    request: TraceRequest = TraceRequest(),
    progress: Callable[[float], bool] | None = None,
) -> TraceResult:
    """What the readings show that the declared model lacks.

    progress : called with the part that is done, 0 to 1; a false answer cancels.  Refuses a number of permutations
    that is out of range, readings that are too few, and positions that cannot be those of
    the machine.
    """
    if not FEWEST <= request.permutations <= MOST:
        count = request.permutations
        raise Refused("trace-permutations", "--permutations", count=count, least=FEWEST, most=MOST)
    if request.alignment:
        readings = replace(readings, alignment=request.alignment)
    readings = within_travel(machine, readings)
    return trace(machine, readings, seed=request.seed, permutations=request.permutations, progress=progress)


def component_values(effect: Effect, outcome: TraceEvidence | TraceResult) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return (driver, value that the readings require, fitted value), each (P',), in driver units and um or urad.

    The required value is the effect plus the projection of the full model's residual on its column of Omega.  Points
    whose column is shorter than SHORT_ARM of the longest, and outliers, are not returned.
    """
    readings = outcome.readings
    matrix = omega(outcome.machine, [effect.component], readings.q, readings.tool_offset)[:, :, 0]
    along = np.einsum("ra,ra->r", matrix[readings.point], readings.sense) * outcome.residuals["used"]
    size = np.bincount(readings.point, weights=along**2, minlength=readings.points)
    rest = mm(along * outcome.residuals["augmented"])
    with np.errstate(divide="ignore", invalid="ignore"):
        rest = np.bincount(readings.point, weights=rest, minlength=readings.points) / size
    keep = size > size.max() * SHORT_ARM**2
    motion = effect.values(readings.columns)
    c, driver = component(effect.component), effect.driver.values(readings.columns)
    return driver[keep], c.to_shown((motion + rest)[keep]), c.to_shown(motion[keep])


def point_vectors(outcome: TraceEvidence | TraceResult, name: str) -> np.ndarray:
    """(P, 3) um: the residual `name` of every point as a vector (sum of its readings along their directions)."""
    readings = outcome.readings
    vectors = np.zeros((readings.points, 3))
    np.add.at(vectors, readings.point, (outcome.residuals[name] * outcome.residuals["used"])[:, None] * readings.sense)
    return vectors
