# SPDX-License-Identifier: LGPL-2.1-or-later
"""The order of readings: by time where a time is given, and the directions of approach that follow from an order."""

from __future__ import annotations

import numpy as np

STILL_MM = 1e-3  # positions that differ by less are the same place when a direction of approach is derived


def backwards(t) -> np.ndarray:
    """Rows behind which the time `t` (P,) runs backwards."""
    return np.flatnonzero(np.diff(t) < 0)


def time_order(t, run) -> tuple[np.ndarray | None, str]:
    """Return (stable order by time, remark) of rows that are not in it; (None, "") if they are, or have no time.

    The remark is "time-order", or "time-order-between-runs" where only a new run begins at an earlier time.
    """
    if t is None or np.all(np.diff(t) >= 0):
        return None, ""
    back = backwards(t)
    between = run is not None and np.all(run[back] != run[back + 1])
    return np.argsort(t, kind="stable"), "time-order-between-runs" if between else "time-order"


def approach_directions(position) -> np.ndarray:
    """(P,) -1, 0, +1: sign of the last move that changed `position` (P,) mm; 0 before the first move."""
    move = np.diff(np.asarray(position, dtype=float), prepend=position[0])
    sign = np.where(np.abs(move) > STILL_MM, np.sign(move), 0.0)
    last = np.maximum.accumulate(np.where(sign != 0, np.arange(len(sign)), 0))
    return sign[last]
