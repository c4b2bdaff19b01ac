# SPDX-License-Identifier: LGPL-2.1-or-later
"""Readings of a machine in a document: the exact product of matrices, with a column that bends as it warms up."""

from __future__ import annotations

import csv

import numpy as np

from sensworkbench import demo

COEFFICIENT = demo.BEND_URAD_PER_K
NAMES = ("x_mm", "y_mm", "z_mm", "t_s", "temp_column_C", "temp_ambient_C", "ex_um", "ey_um", "ez_um")
ANSWERS = ("sign: error", "frame: tool_relative_to_workpiece", "positions: programmed")


def table(core, count: int = 160, seed: int = 5, bend: bool = True) -> np.ndarray:
    """(count, 9) rows of NAMES for a core machine; with `bend` EAZ is driven by temp_column, 6 urad/K."""
    rng = np.random.default_rng(seed)
    errors = demo.simulated_errors(core, rng)
    squareness = {s: float(v) for s, v in zip(("C0Y", "A0Z", "B0Z"), rng.normal(size=3) * 10e-6)}
    low, high = core.travel.T
    q = low + (high - low) * rng.random((count, 3))
    t = 20.0 * np.arange(count)
    column = 4 * (1 - np.exp(-t / 900)) + 1.5 * np.sin(t / 150)
    ambient = 0.6 * np.sin(t / 700)
    error = 1e3 * demo.simulate(core, errors, squareness, q, column, bend) + 0.4 * rng.normal(size=q.shape)
    return np.column_stack([q, t, 20 + column, 20 + ambient, error])


def write(path, rows, names=NAMES, answers=ANSWERS, separator=","):
    with open(path, "w", encoding="utf-8", newline="") as stream:
        stream.writelines(f"# {a}\n" for a in answers)
        writer = csv.writer(stream, lineterminator="\n", delimiter=separator)
        writer.writerow(names)
        writer.writerows([f"{v:.4f}" for v in row] for row in rows)
    return path
