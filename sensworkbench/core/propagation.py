# SPDX-License-Identifier: LGPL-2.1-or-later
"""Law of propagation of uncertainty (JCGM 100:2008, clause 5 and annex G): correlated inputs, several outputs, terms of
second order, effective degrees of freedom and coverage factors.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from statistics import NormalDist

import numpy as np

Function = Callable[[np.ndarray], "np.ndarray | float"]


def propagated(jacobian, factor) -> np.ndarray:
    """(...,) standard uncertainties of outputs with derivatives (..., n) (JCGM 100, eq. 13).

    factor (n, k): times its transpose it is the covariance of the n inputs.
    """
    return np.linalg.norm(np.asarray(jacobian) @ np.asarray(factor), axis=-1)


def factor_of(covariance) -> np.ndarray:
    """(n, n) a square root of a covariance: times its transpose it is the matrix, which is symmetric, not negative."""
    values, vectors = np.linalg.eigh(covariance)
    return vectors * np.sqrt(np.maximum(values, 0.0))


def derivatives(f: Function, x: Sequence[float], u: Sequence[float]) -> np.ndarray:
    """(m, n) derivatives of f (n,) -> (m,) at x, over a tenth of a standard uncertainty to either side (5.1.3)."""
    x, steps = np.asarray(x, dtype=float), 0.1 * np.asarray(u, dtype=float)
    columns = []
    for i, h in enumerate(steps):
        side = np.zeros(len(x))
        side[i] = h
        ends = [np.atleast_1d(f(x + s * side)) for s in (-1, 1)]
        columns.append((ends[1] - ends[0]) / (2 * h) if h > 0 else np.zeros_like(ends[0]))
    return np.stack(columns, axis=1)


def combined(f: Function, x: Sequence[float], covariance) -> tuple[np.ndarray, np.ndarray]:
    """(values (m,), covariance (m, m)) of f at inputs x with their covariance (n, n), to first order."""
    u = np.sqrt(np.diag(covariance))
    slopes = derivatives(f, x, u) @ factor_of(covariance)
    return np.atleast_1d(f(np.asarray(x, dtype=float))), slopes @ slopes.T


def second_order(f: Function, x: Sequence[float], u: Sequence[float]) -> float:
    """Variance that terms of second order add for one output of independent inputs, symmetrically distributed:
    sum over i, j of (f_ij^2 / 2 + f_i f_ijj) u_i^2 u_j^2 (5.1.2, note).
    """
    x, u = np.asarray(x, dtype=float), np.asarray(u, dtype=float)

    def at(*moves) -> float:
        place = x.copy()
        for i, s in moves:
            place[i] += s * u[i]
        return float(np.atleast_1d(f(place))[0])

    n, total = len(x), 0.0
    middle = at()
    for i in range(n):  # in units of u: derivatives times the u of their inputs
        slope = (at((i, 1)) - at((i, -1))) / 2
        for j in range(n):
            if i == j:
                mixed = at((i, 1)) - 2 * middle + at((i, -1))
                third = (at((i, 2)) - 2 * at((i, 1)) + 2 * at((i, -1)) - at((i, -2))) / 2
            else:
                mixed = sum(s * t * at((i, s), (j, t)) for s in (-1, 1) for t in (-1, 1)) / 4
                curve = [at((i, s), (j, 1)) - 2 * at((i, s)) + at((i, s), (j, -1)) for s in (-1, 1)]
                third = (curve[1] - curve[0]) / 2
            total += mixed**2 / 2 + slope * third
    return total


def effective_freedom(contributions: Sequence[float], freedom: Sequence[float]) -> float:
    """Degrees of freedom of a combined uncertainty by Welch and Satterthwaite (G.4.1, eq. G.2b).

    contributions : standard uncertainties of the output by each input.  freedom : their degrees of freedom.
    """
    below = sum(c**4 / v for c, v in zip(contributions, freedom) if c)
    return sum(c**2 for c in contributions) ** 2 / below if below else math.inf


def coverage_factor(probability: float, freedom: float = math.inf) -> float:
    """k of an interval that holds `probability` of Student's distribution with `freedom` degrees of freedom (G.3.4)."""
    tail = (1 + probability) / 2
    if math.isinf(freedom):
        return NormalDist().inv_cdf(tail)
    low, high = 0.0, 1e4
    for _ in range(80):
        middle = (low + high) / 2
        low, high = (middle, high) if _student(middle, freedom) < tail else (low, middle)
    return (low + high) / 2


def _student(t: float, freedom: float) -> float:
    """Distribution of Student's t at t >= 0: an integral over the angle atan(t / sqrt(freedom)), Gauss-Legendre."""
    end = math.atan(t / math.sqrt(freedom))
    nodes, weights = np.polynomial.legendre.leggauss(96)
    angle = (nodes + 1) * end / 2
    area = float((weights * np.cos(angle) ** (freedom - 1)).sum() * end / 2)
    scale = math.lgamma((freedom + 1) / 2) - math.lgamma(freedom / 2) - math.log(math.pi) / 2
    return 0.5 + math.exp(scale) * area
