# SPDX-License-Identifier: LGPL-2.1-or-later
"""The prediction study: the error at new places and conditions, and where that leaves what the fit has seen."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..closedloop import predict
from ..closedloop.readings import Readings
from ..core.machine import Machine
from .places import within_travel


@dataclass(frozen=True)
class PredictRequest:
    """alignment : include the fitted alignment of the set-up and the offsets of runs and tools."""

    alignment: bool = True


@dataclass(frozen=True)
class PredictResult:
    """error : (P, 3) mm, actual minus commanded.  extrapolated : (P,) whether a place lies outside the fit's ranges.

    u : (P, 3) mm standard uncertainty of the error, which is systematic: a new reading scatters about it besides.  NaN
    where the machine's file states no covariance.
    """

    error: np.ndarray
    extrapolated: np.ndarray
    u: np.ndarray

    @property
    def u_known(self) -> bool:
        """Whether the machine states the covariance of what was fitted."""
        return bool(np.isfinite(self.u).all())


def predict_study(machine: Machine, positions: Readings, request: PredictRequest = PredictRequest()) -> PredictResult:
    """The error of a fitted machine at `positions`.  Refuses a machine without fitted errors, missing columns,
    and positions that cannot be those of the machine.
    """
    within_travel(machine, positions)
    error = predict.predict(machine, positions, alignment=request.alignment)
    u = predict.uncertainty(machine, positions, alignment=request.alignment)
    if u is None:
        u = np.full_like(error, np.nan)
    return PredictResult(error, predict.extrapolated(machine, positions), u)
