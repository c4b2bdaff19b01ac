# SPDX-License-Identifier: LGPL-2.1-or-later
"""A driver that nobody logged: noise shaped like one body's motion.

If one body moves at random from reading to reading, the components of each reading's residual are correlated along that
body's lever arm.  Only the products between different components are used, so unequal noise of the sensors does not
imitate it, and the null is made by flipping the sign of every single reading.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .design import ALL_SYMBOLS
from .scan import Rows


@dataclass(frozen=True)
class Unlogged:
    """symbol, rms of the motion (mm or rad), p family-wise, share of chi-square: rms shown per reading over its noise."""

    symbol: str
    rms: float
    p: float
    size: float


def _cross(rows: Rows, residual) -> np.ndarray:
    """(C,) sum over points of the cross products of lever x residual."""
    x = rows.lever * residual[:, None]
    return (rows.gather(x) ** 2 - rows.gather(x**2)).sum(axis=0)


def unlogged_driver(rows: Rows, count: int = 199, seed: int = 0) -> Unlogged | None:
    """The component whose random motion the residual shows most, or None where points hold one reading each."""
    g2 = rows.lever**2
    weight = (rows.gather(g2) ** 2 - rows.gather(g2**2)).sum(axis=0)
    usable = weight > 1e-6 * max(float(weight.max(initial=0.0)), 1e-300)
    if not usable.any():
        return None
    scale = np.where(usable, np.sqrt(np.where(usable, weight, 1.0)), np.inf)
    observed = _cross(rows, rows.residual) / scale
    rng = np.random.default_rng(seed)
    null = np.empty(count)
    for i in range(count):
        null[i] = (_cross(rows, rows.residual * rng.choice((-1.0, 1.0), len(rows.residual))) / scale).max()
    best = int(np.argmax(observed))
    if observed[best] <= 0:
        return None
    variance = observed[best] / scale[best]
    power = float((g2[:, best]).sum() / max(np.count_nonzero(rows.lever.any(axis=1)), 1))
    p = float((1 + np.count_nonzero(null >= observed[best])) / (count + 1))
    return Unlogged(ALL_SYMBOLS[best], float(np.sqrt(max(variance, 0.0))), p, float(np.sqrt(max(variance, 0) * power)))
