# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether positions can be those of this machine: a remark where its joints cannot go, a refusal of a wrong unit."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..closedloop.readings import Readings, Remark
from ..core.machine import Machine
from ..core.refusal import Refused
from ..messages import Message

NEARLY_ALL = 0.8  # of the places, from which far ones are a wrong unit and no slip of single rows


def within_travel(machine: Machine, readings: Readings) -> Readings:
    """The readings, with a warning where the joints cannot go there.

    Refuses positions of which nearly all lie outside by more than the travel itself: their unit is not the stated one.
    """
    low, high = machine.travel.T
    beyond = np.maximum(low - readings.q, readings.q - high)
    beyond[:, [machine.joint(name).travel is None for name in machine.names]] = 0.0  # endless
    outside = np.flatnonzero((beyond > 1e-6).any(axis=1))
    if not len(outside):
        return readings
    line = int(readings.line[outside[0]]) if readings.line is not None else 0
    far = (beyond > high - low).any(axis=1)
    if far.mean() >= NEARLY_ALL:
        ratio = np.abs(readings.q).max(axis=0) / np.maximum(np.abs(low), np.abs(high))
        joint = machine.names[int(np.argmax(ratio))]
        where = f"line {line}" if line else "positions"
        raise Refused("positions-not-of-machine", where, joint=joint, times=float(ratio.max()), count=int(far.sum()))
    text = Message("remark-outside-travel", count=len(outside), line=line)
    return replace(readings, remarks=(Remark("warning", "outside-travel", text, line), *readings.remarks))
