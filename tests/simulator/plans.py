# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where and under which conditions a simulated machine is measured: places in the order of measuring, and the columns
that a session logs with them.  Temperatures are in degC, as in the file.
"""

from __future__ import annotations

import itertools
import math

import numpy as np

PLANS = ("grid", "lines", "diagonals", "random")


def _out_and_back(start, stop, count: int) -> np.ndarray:
    out = np.linspace(start, stop, count)
    return np.concatenate([out, out[::-1]])


def places(plan: str, travel: dict, rng: np.random.Generator, count: int) -> np.ndarray:
    """(N, 3) mm in the order of measuring; N is near `count`, as the plan allows."""
    low, high = np.array([travel[k] for k in "XYZ"], dtype=float).T
    if plan == "random":
        return low + (high - low) * rng.random((count, 3))
    if plan == "grid":
        side = max(5, round((count / 2) ** (1 / 3)))
        nodes = itertools.product(*[np.linspace(a, b, side) for a, b in zip(low, high)])
        out = np.array(list(nodes))
        return np.concatenate([out, out[::-1]])
    signs = [np.array([1.0, b, c]) for b in (1, -1) for c in (1, -1)]
    centre, half = (low + high) / 2, (high - low) / 2
    body = [(centre - half * s, centre + half * s) for s in signs]
    if plan == "lines":
        per = max(5, round(count / 56))
        lines = []
        for axis in range(3):
            for _ in range(8):
                start = low + (high - low) * rng.random(3)
                stop = start.copy()
                start[axis], stop[axis] = low[axis], high[axis]
                lines.append((start, stop))
        lines += body
    elif plan == "diagonals":
        lines = list(body)
        for axis in range(3):
            others = [k for k in range(3) if k != axis]
            for level in (-1.0, 1.0):
                for sign in (1.0, -1.0):
                    s = np.zeros(3)
                    s[others[0]], s[others[1]] = 1.0, sign
                    fixed = np.zeros(3)
                    fixed[axis] = level
                    lines.append((centre + half * (fixed - s), centre + half * (fixed + s)))
        per = max(7, round(count / (2 * len(lines))))
    else:
        raise ValueError(f"unknown plan {plan!r}; use one of {PLANS}")
    return np.concatenate([_out_and_back(a, b, per) for a, b in lines])


def directions(q: np.ndarray) -> np.ndarray:
    """(N, 3) sign of the last move of each axis; +1 before the first."""
    moved = np.sign(np.diff(q, axis=0, prepend=q[:1] - 1.0))
    for i in range(1, len(moved)):
        moved[i] = np.where(moved[i] == 0, moved[i - 1], moved[i])
    return moved


def conditions(count: int, rng: np.random.Generator, *, spindle: bool = False) -> dict:
    """Time and temperatures of a session of `count` readings, about 11 s apart: smooth curves that part in time."""
    t = np.round(np.cumsum(rng.uniform(8.0, 14.0, count)), 3)
    span = t[-1]
    wave = lambda period: np.sin(2 * math.pi * t / period + rng.uniform(0, 2 * math.pi))  # noqa: E731
    warm = 4 * (1 - np.exp(-t / (0.45 * span)))
    columns = {
        "t_s": t,
        "temp_ambient_C": 20 + 1.2 * wave(rng.uniform(4500, 6500)),
        "temp_scale_x_C": 20 + warm + 0.5 * wave(span * rng.uniform(0.7, 1.2)),
        "temp_scale_y_C": 20 + 0.85 * warm + 0.6 * wave(span * rng.uniform(0.4, 0.9)),
    }
    if rng.random() < 0.5:  # two sensors on one source, as happens
        columns["temp_scale_z_C"] = 20 + 0.6 * (columns["temp_scale_x_C"] - 20)
    else:
        columns["temp_scale_z_C"] = 20 + 0.5 * warm + 0.5 * wave(span * rng.uniform(0.5, 1.1))
    columns["temp_column_C"] = 20.2 + 3 * wave(span * rng.uniform(0.65, 0.85))
    if spindle:
        program = rng.choice([0.0, 2000.0, 4000.0, 8000.0, 12000.0], size=12)
        program[0] = rng.choice([4000.0, 8000.0])
        columns["spindle_rpm"] = program[np.minimum((12 * t / (span + 1)).astype(int), 11)]
    return {k: np.round(v, 3) for k, v in columns.items()}


def vary(count: int, rng: np.random.Generator, many_feeds: bool) -> dict:
    """Feed and load of every reading."""
    feed = rng.choice([500.0, 2000.0, 6000.0], size=count) if many_feeds else np.full(count, 2000.0)
    return {"feed_mm_min": feed, "load_table_kg": rng.choice([0.0, 150.0, 400.0], size=count)}
