# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a set of readings cannot show, however it is fitted: one run, runs of one place, columns of one value, few runs.

Each is a sentence that says what can and cannot be concluded, and how many runs a name would need.
"""

from __future__ import annotations

import math
from collections import Counter

import numpy as np

from ..core.driver import DIRECTIONS, POSITIONS, TIME
from ..messages import Message
from .bank import useful_columns
from .exchange import constant_in_runs
from .readings import Readings
from .settings import TraceSettings


def input_remarks(readings: Readings, settings: TraceSettings) -> tuple[Message, ...]:
    """The remarks on readings whose alignment is settled (see `declared.aligned`)."""
    out = []
    varying = set(useful_columns(readings))
    one_level = [n for n in readings.columns if n not in varying and n not in (*POSITIONS, TIME)]
    if one_level:
        out.append(Message("input-one-level", columns=one_level))
    if readings.run is None:
        return tuple(out)
    count = Counter(str(r) for r in readings.run)
    if len(count) == 1:
        return (*out, Message("input-one-run"))
    single = sorted(label for label, n in count.items() if n == 1)
    if single and readings.alignment in ("offset per run", "per run"):
        out.append(Message("input-runs-of-one", count=len(single), runs=len(count)))
    few = [n for n in constant_in_runs(readings) if n not in DIRECTIONS and smallest_p(readings, n) > settings.alpha]
    if few:
        smallest = min(smallest_p(readings, n) for n in few)
        needed = {"different": runs_needed(settings.alpha, False), "levels": runs_needed(settings.alpha, True)}
        out.append(Message("input-few-runs", columns=few, runs=len(count), p=smallest, alpha=settings.alpha, **needed))
    return tuple(out)


def smallest_p(readings: Readings, name: str) -> float:
    """The smallest p that exchanges of whole runs can give a column that is constant within each run.

    Orders of the runs that give the column as it is, or turned about its mean, explain as much: their share of all
    orders.
    """
    labels = np.array([str(r) for r in readings.run])
    v = np.array([readings.columns[name][labels == label][0] for label in sorted(set(labels.tolist()))])
    v = np.round((v - v.mean()) / max(float(np.abs(v - v.mean()).max()), 1e-300), 6) + 0.0
    levels = Counter(v.tolist())
    alike = math.prod(math.factorial(n) for n in levels.values())
    turned = Counter((0.0 - v).tolist()) == levels
    return min((2 if turned else 1) * alike / math.factorial(len(v)), 1.0)


def runs_needed(alpha: float, two_levels: bool) -> int:
    """The smallest number of runs whose exchanges allow p <= alpha: of a column that has two values, or another in each
    run (at uneven steps).
    """
    runs = 2
    while True:
        if two_levels:
            smallest = (2 if runs % 2 == 0 else 1) / math.comb(runs, runs // 2)
        else:
            smallest = 1 / math.factorial(runs)
        if smallest <= alpha:
            return runs
        runs += 1
