# SPDX-License-Identifier: LGPL-2.1-or-later
"""The bank: every column and product of columns, through every shape, as regressors over the points.

A candidate effect is component x driver x shape; the bank holds the driver x shape part, so that all components are
scored against it with one matrix product (see `scan`).  Each shape defines with which drivers and starts of its unknown
parameters it is tried; they are refined later.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from ..core.shapes import SHAPES, Regressor, Varying


def useful_columns(readings) -> list[str]:
    """Driver columns that vary; a column that is constant in the readings drives nothing."""
    names = []
    for name, v in readings.columns.items():
        if len(v) and np.isfinite(v).all() and np.ptp(v) > 1e-9 * max(1.0, float(np.abs(v).max())):
            names.append(name)
    return names


def _regressors(columns, names, scanned: bool) -> Iterator[Regressor]:
    seen = Varying(columns, names)
    for shape in SHAPES.values():
        if shape.scanned == scanned:
            for driver, start in shape.scan(seen):
                yield Regressor(driver, start)


def bank(readings) -> list[Regressor]:
    """All driver x shape entries for these readings, each once; of one or two columns each."""
    return list(dict.fromkeys(_regressors(readings.columns, useful_columns(readings), True)))


def beside(columns, names) -> list[Regressor]:
    """Return the regressors of shapes that are too many, or have too many columns, for the bank."""
    return list(dict.fromkeys(_regressors(columns, names, False)))


def log_tail(x, width: int):
    """-log10 of the chi-square tail beyond x for 1 or 2 degrees of freedom; comparable between widths."""
    x = np.maximum(x, 1e-12)
    if width == 2:
        return x / (2 * math.log(10))
    # Mills ratio, good to a few per cent for any x: erfc(s) = exp(-s²) f(s)
    s = np.sqrt(x / 2)
    f = 2 / (math.sqrt(math.pi) * (s + np.sqrt(s * s + 4 / math.pi)))
    return (x / 2 - np.log(f)) / math.log(10)
