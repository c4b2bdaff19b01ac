# SPDX-License-Identifier: LGPL-2.1-or-later
"""A direction of sensing with the wrong sign: found before anything is traced, because effects would absorb it.

The components of an error share the carriages' rotations, so one direction read with the opposite sign spoils the fit
of all three.  A direction that shares none (x on a gantry whose x motion nothing else sees) cannot be checked so.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..core.machine import Machine
from .design import design
from .fit import Fit, fit
from .readings import Readings

LEAST = 25.0  # log-likelihood that turning a sign must gain
SHARE = 0.05  # and per reading of the directions together


def likelihood(readings: Readings, fitted: Fit) -> float:
    """Log-likelihood of a fit whose noise is estimated for each direction of sensing, up to a constant."""
    kinds, counts = np.unique(readings.kind, return_counts=True)
    return -sum(n * np.log(fitted.noise[k]) for k, n in zip(kinds.tolist(), counts.tolist(), strict=True))


def turned(readings: Readings, kind: int) -> Readings:
    """The readings with one direction of sensing read with the opposite sign."""
    return replace(readings, value=np.where(readings.kind == kind, -readings.value, readings.value))


def checkable(readings: Readings) -> list[int]:
    """The directions of sensing that can be held against each other: all three, or none."""
    kinds = np.unique(readings.kind).tolist()
    return kinds if kinds == [0, 1, 2] else []


def flipped_directions(machine: Machine, readings: Readings, declared: Fit) -> list[int]:
    """Directions of sensing (0, 1, 2) that fit the declared model much better with their sign turned; one at most.

    A strong undeclared effect can look the same: what effects explain on either side must still decide.
    """
    kinds = checkable(readings)
    if not kinds:
        return []
    reference = likelihood(readings, declared)
    gains = {}
    for kind in kinds:
        other = turned(readings, kind)
        gains[kind] = likelihood(other, fit(design(machine, other), other)) - reference
    best = max(gains, key=lambda k: gains[k])
    return [best] if gains[best] > max(LEAST, SHARE * readings.rows) else []


def flipped_findings(kinds) -> list[dict]:
    return [
        {
            "severity": "warning",
            "code": "flipped-sign",
            "message": f"with the sign of e{'xyz'[kind]} turned the declared model fits much better: nothing is traced "
            "until the sign is settled; turn it, or state the convention in the header",
            "line": 0,
        }
        for kind in kinds
    ]
