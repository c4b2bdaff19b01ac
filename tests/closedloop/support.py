# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measured machines for the tests: tests/simulator's exact product on one side, the package on the other."""

from __future__ import annotations

import json
import tempfile
from pathlib import Path

import numpy as np

from sensworkbench.closedloop.readings import Readings
from sensworkbench.core.machine import Machine
from sensworkbench.formats import machine_json, readings_csv, trace_json
from tests import simulator
from tests.simulator import kinematics

TRAVEL = {k: (-300.0, 300.0) for k in "XYZ"}
ORIGIN = {k: (0.0, 0.0, 0.0) for k in "XYZ"}
APART = {"X": (30.0, -180.0, 200.0), "Y": (-60.0, -200.0, 100.0), "Z": (15.0, 100.0, 600.0)}


def both(code="FXYZ", tool_point=(0.0, 0.0, -150.0), reference=None, travel=None) -> tuple:
    """The same machine twice: the simulator's and the package's, read from the simulator's machine.json."""
    simulated = kinematics.Machine(code, reference or ORIGIN, travel or TRAVEL, tuple(tool_point))
    return simulated, machine_json.loads(json.dumps(simulated.as_dict()))


def grid(side: int = 5, half: float = 300.0) -> np.ndarray:
    """(side^3, 3) regular grid."""
    line = np.linspace(-half, half, side)
    return np.stack(np.meshgrid(line, line, line, indexing="ij"), axis=-1).reshape(-1, 3)


def scattered(count: int, seed: int = 0, half: float = 300.0) -> np.ndarray:
    return np.random.default_rng(seed).uniform(-half, half, (count, 3))


def declared_values(simulated, q, seed: int = 0, size: float = 1.0) -> dict:
    """Cubic errors of a few um and urad at positions q (no constants, no slopes of straightness), and squareness."""
    rng = np.random.default_rng(seed)
    values = {name: size * float(rng.normal()) * 12e-6 for name in kinematics.SQUARENESS}
    for axis in "XYZ":
        low, high = simulated.travel[axis]
        u = (2 * q[:, "XYZ".index(axis)] - low - high) / (high - low)
        for motion in "XYZABC":
            coefficient = size * rng.normal(size=4) * (1.2e-3 if motion in "XYZ" else 6e-6) * [0, 1, 0.8, 0.5]
            if motion in "XYZ" and motion != axis:
                coefficient[1] = 0.0
            values[f"E{motion}{axis}"] = np.polynomial.legendre.legval(u, coefficient)
    return values


def measured(simulated, q, extra=None, columns=None, noise=0.0, seed=0, tool=0.0, size=1.0, **more) -> Readings:
    """Vector readings (mm) of the exact product: declared errors, `extra` (symbol -> mm or rad) and white noise."""
    values = declared_values(simulated, q, seed, size)
    for name, v in (extra or {}).items():
        values[name] = values.get(name, 0.0) + v
    error = kinematics.exact_error(simulated, q, values, tool)
    error = error + noise * np.random.default_rng([seed, 1]).normal(size=q.shape)
    offset = None if np.ndim(tool) == 0 else np.broadcast_to(tool, q.shape)
    return Readings.from_vectors(q, error, columns, tool_offset=offset, **more)


def session(count: int, seed: int = 0) -> dict:
    """Columns of a session: time, two temperatures and directions drawn at random."""
    rng = np.random.default_rng([seed, 2])
    t = 10.0 * np.arange(count)
    return {
        "t": t,
        "dir_x": rng.choice([-1.0, 1.0], count),
        "temp_column": 3 * np.sin(t / t[-1] * 9.0) + 0.3 * np.sin(t / t[-1] * 53.0),
        "temp_ambient": np.cos(t / t[-1] * 17.0 + 1.0),
    }


def from_case(case) -> tuple[Machine, Readings, Readings]:
    """A simulated case through the files of the specification: machine, readings, positions."""
    with tempfile.TemporaryDirectory() as folder:
        simulator.write_case(folder, case)
        return from_folder(Path(folder))


def from_folder(folder: Path) -> tuple[Machine, Readings, Readings]:
    return (
        machine_json.load(folder / "machine.json"),
        readings_csv.load(folder / "measured.csv"),
        readings_csv.load_positions(folder / "positions.csv"),
    )


def rms_um(difference_mm) -> float:
    """rms of the 3-D vectors (P, 3) mm, in um."""
    return 1e3 * float(np.sqrt((np.asarray(difference_mm) ** 2).sum(axis=1).mean()))


def least_squares(matrix, value) -> tuple[np.ndarray, float]:
    """(coefficients, sum of squared residuals) of numpy.linalg.lstsq with columns of length 1; minimum norm."""
    size = np.maximum(np.linalg.norm(matrix, axis=0), 1e-300)
    solution = np.linalg.lstsq(matrix / size, value, rcond=1e-9)[0]
    left = value - (matrix / size) @ solution
    return solution / size, float(left @ left)


def report_of(result) -> dict:
    """trace.json of a trace, as plain data."""
    return trace_json.to_dict(result)
