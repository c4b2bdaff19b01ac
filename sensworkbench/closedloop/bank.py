# SPDX-License-Identifier: LGPL-2.1-or-later
"""The bank of drivers: every column and product of columns, through every shape, as vectors over the points.

A candidate effect is component x driver x shape; the bank holds the driver x shape part, so that all components are
scored against it with one matrix product (see `scan`).  Unknown periods, time constants, instants, widths and exponents
stand on a grid here and are refined later.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from ..core import drivers
from ..core.drivers import driver_name

POSITIONS = ("x", "y", "z")
DIRECTIONS = ("dir_x", "dir_y", "dir_z")


@dataclass(frozen=True)
class Shape:
    """A driver through a shape: `driver` (canonical name), `shape`, its parameters, and how many numbers were profiled.

    width : 1, or 2 for sin and cos of a period.
    """

    driver: str
    shape: str
    parameters: Mapping[str, float] = field(default_factory=dict)
    width: int = 1

    @property
    def columns(self) -> tuple[str, ...]:
        return tuple(dict.fromkeys(self.driver.split("*"))) + (("t",) if self.shape == "lag" else ())

    @property
    def profiled(self) -> int:
        return sum(k in ("tau", "period", "at", "exponent", "width") for k in self.parameters)

    @property
    def factors(self) -> int:
        return len(self.driver.split("*"))

    def vectors(self, columns) -> np.ndarray:
        """(P, width) the columns that the coefficients multiply."""
        effect = drivers.Effect(
            "", "EXX", self.driver, self.shape, {k: {"value": v} for k, v in self.parameters.items()}
        )
        return drivers.shape_basis(effect, columns)


def useful_columns(readings) -> list[str]:
    """Driver columns that vary; a column that is constant in the readings drives nothing."""
    names = []
    for name, v in readings.columns.items():
        if len(v) and np.isfinite(v).all() and np.ptp(v) > 1e-9 * max(1.0, float(np.abs(v).max())):
            names.append(name)
    return names


def _grid(low: float, high: float, count: int) -> list[float]:
    return [float(v) for v in np.geomspace(low, high, count)]


def periods(v: np.ndarray, oversample: float = 3.0, limit: int = 900) -> list[float]:
    """Periods to try on positions v: from the span down to 2.5 mm, or to twice the step of a regular grid."""
    values = np.unique(np.round(v, 4))
    if len(values) < 6:
        return []
    gaps = np.diff(values)
    span = float(np.ptp(values))
    regular = float(np.ptp(gaps)) < 0.02 * float(gaps.mean())
    shortest = 2.0 * float(gaps.mean()) if regular else max(2.5, span / 300)
    high, low = 1 / shortest, (0.4 if regular else 1.25) / span
    count = int(min(limit, max(0, (high - low) * span * oversample)))
    return [float(1 / f) for f in np.linspace(low, high, count)] if count else []


def persistent(v: np.ndarray) -> bool:
    """Does a column keep its value from one reading to the next?  A lag of one that jumps is a trend in disguise."""
    return float(np.mean(np.diff(v) ** 2)) < float(np.var(v))


def bank(readings) -> list[Shape]:
    """All driver x shape entries for these readings."""
    names = useful_columns(readings)
    columns = readings.columns
    two_level = {n for n in names if len(np.unique(columns[n])) <= 2}
    found: dict[tuple, Shape] = {}

    def put(shape: Shape):
        found.setdefault((shape.driver, shape.shape, tuple(shape.parameters.items())), shape)

    for a in names:
        put(Shape(a, "reversal" if a in DIRECTIONS else "linear"))
    for a, b in itertools.combinations_with_replacement(names, 2):
        if a == b and (a in two_level or a in DIRECTIONS):
            continue
        if a != b and all(n == "t" or n.startswith("temp_") for n in (a, b)):
            continue  # temperatures and time multiply nothing on a machine
        put(Shape(driver_name((a, b)), "linear"))
    place = [n for n in POSITIONS if n in names]
    for a in names:
        for b, c in itertools.combinations_with_replacement(place, 2):
            put(Shape(driver_name((a, b, c)), "linear"))
    for a, b in itertools.product([n for n in DIRECTIONS if n in names], names):
        for c in place:
            if b not in place and b not in DIRECTIONS:
                put(Shape(driver_name((a, b, c)), "linear"))
    smooth = [n for n in names if n not in DIRECTIONS and len(np.unique(columns[n])) > 4]
    if "t" in names:
        t = columns["t"]
        span = float(np.ptp(t))
        for tau in _grid(span / 60, span * 1.5, 12):
            put(Shape("t", "approach", {"tau": tau}))
        memory = [n for n in names if n not in POSITIONS + DIRECTIONS + ("t",) and persistent(columns[n])]
        sources = memory + [driver_name((n, n)) for n in memory if n.startswith("spindle")]
        for source in sources:
            for tau in _grid(span / 100, span * 1.5, 12):
                put(Shape(source, "lag", {"tau": tau}))
    for a in [n for n in smooth if n in POSITIONS or n == "t"]:
        v = np.unique(columns[a])
        for at in np.quantile(v, np.linspace(0.04, 0.96, 47 if a == "t" else 23), method="lower"):
            put(Shape(a, "step", {"at": float(at)}))
    for a in smooth + [n for n in names if n not in smooth and n not in two_level and n not in DIRECTIONS]:
        if a in POSITIONS:
            continue
        for exponent in (0.5, 1.5, 2.0, 3.0):
            put(Shape(a, "power", {"exponent": exponent}))
    for a in place:
        span = float(np.ptp(columns[a]))
        for width in (span / 200, span / 50, span / 20, span / 8):
            put(Shape(a, "hysteresis", {"width": width}))
    for a in place:
        for period in periods(columns[a]):
            put(Shape(a, "periodic", {"period": period}, width=2))
    return list(found.values())


def log_tail(x, width: int):
    """-log10 of the chi-square tail beyond x for 1 or 2 degrees of freedom; comparable between widths."""
    x = np.maximum(x, 1e-12)
    if width == 2:
        return x / (2 * math.log(10))
    # Mills ratio, good to a few per cent for any x: erfc(s) = exp(-s²) f(s)
    s = np.sqrt(x / 2)
    f = 2 / (math.sqrt(math.pi) * (s + np.sqrt(s * s + 4 / math.pi)))
    return (x / 2 - np.log(f)) / math.log(10)
