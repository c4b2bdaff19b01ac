# SPDX-License-Identifier: LGPL-2.1-or-later
"""How large the error may become: P(|T| <= r) over random machines, its quantiles, and what makes them.

For normal laws T is normal, and P(|T| <= r) is an integral over a ball: in the principal axes of the covariance of T
the widest direction is integrated in closed form and the two others by Gauss-Legendre quadrature.  For other laws the
machines are sampled (Latin hypercube, seeded), and a standard error is stated.

The contribution of an input to a quantile r of |T| is d ln r / d ln(scale of the input).  |T| grows in proportion to
all inputs together, so the contributions add to one (Euler's theorem for homogeneous functions); with samples they are
E[T·Omega_i X_i | |T| = r] / r².
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .distributions import Tolerance

ORDER = 40  # nodes in each of two directions; half as many states the error
REACH = 8.5  # standard deviations that are integrated: the rest is 2e-17
SAMPLES, LEAST_SAMPLES = 65_536, 4096
MOST_NUMBERS = 2**23  # places times machines that are held at once
REPLICATES = 16  # independent parts of the sample, whose scatter is its error
WINDOW = 0.02  # of r: machines so near to it show what makes it
SEED = 2012
_erf = np.frompyfunc(math.erf, 1, 1)


def normal(laws: Sequence[Tolerance]) -> bool:
    """Whether every input that varies is normal."""
    return all(law.distribution in ("normal", "point") or law.upper == law.lower for law in laws)


@dataclass(frozen=True)
class Quantile:
    """value (mm or rad) with its standard error (0: computed), and contributions (n,) of the inputs, adding to 1."""

    value: float
    error: float
    contributions: np.ndarray


# -- normal laws -------------------------------------------------------------------------------------------------------
def _cumulative(z: np.ndarray) -> np.ndarray:
    return 0.5 * (1 + _erf(z / math.sqrt(2)).astype(float))


def _density(z: np.ndarray) -> np.ndarray:
    return np.exp(-z * z / 2) / math.sqrt(2 * math.pi)


@dataclass(frozen=True)
class _Ball:
    """Integrals over |t| <= r of a normal density with means m and deviations s (3,), the largest first.

    mass : P(|t| <= r).  slope (3,): its derivative by the means.  curvature (3, 3): its second derivative by them.
    """

    mass: float
    slope: np.ndarray
    curvature: np.ndarray


def _ball(m: np.ndarray, s: np.ndarray, r: float, order: int = ORDER, derivatives: bool = True) -> _Ball:
    x, w = np.polynomial.legendre.leggauss(order)
    t3, w3 = _on_sphere(m[2], s[2], np.array([r]), x, w)
    rho = np.sqrt(np.maximum(r * r - t3[0] ** 2, 0.0))
    t2, w2 = _on_sphere(m[1], s[1], rho, x, w)
    half = np.sqrt(np.maximum(rho[:, None] ** 2 - t2**2, 0.0))
    above, below = (half - m[0]) / s[0], (-half - m[0]) / s[0]
    z2, z3 = (t2 - m[1]) / s[1], (t3[0] - m[2]) / s[2]
    outer, inner = w3[0] * _density(z3) / s[2], w2 * _density(z2) / s[1]
    whole = _cumulative(above) - _cumulative(below)
    mass = float(outer @ (inner * whole).sum(axis=1))
    if not derivatives:
        return _Ball(mass, np.zeros(3), np.zeros((3, 3)))
    first = -(_density(above) - _density(below))
    second = -(above * _density(above) - below * _density(below))
    z = {(k, j): None for k in range(3) for j in range(3)}
    weight2, weight3 = (np.ones_like(z2), z2, z2**2 - 1), (np.ones_like(z3), z3, z3**2 - 1)
    along = (whole, first, second)
    for k in range(3):
        for j in range(3 - k):
            z[k, j] = (inner * weight2[j] * along[k]).sum(axis=1)

    def integral(k, j, i):
        return float(outer @ (weight3[i] * z[k, j])) / (s[0] ** k * s[1] ** j * s[2] ** i)

    slope = np.array([integral(1, 0, 0), integral(0, 1, 0), integral(0, 0, 1)])
    curvature = np.array([
        [integral(2, 0, 0), integral(1, 1, 0), integral(1, 0, 1)],
        [integral(1, 1, 0), integral(0, 2, 0), integral(0, 1, 1)],
        [integral(1, 0, 1), integral(0, 1, 1), integral(0, 0, 2)],
    ])  # fmt: skip
    return _Ball(mass, slope, curvature)


def _on_sphere(mean: float, deviation: float, radius: np.ndarray, x, w):
    """Nodes and weights (K, order) over [-radius, radius] (K,), no farther than REACH deviations from the mean.

    t = radius sin(angle): the integrand then is smooth at the ends too.
    """
    safe = np.where(radius > 0, radius, 1.0)
    low = np.clip((mean - REACH * deviation) / safe, -1, 1)
    high = np.clip((mean + REACH * deviation) / safe, -1, 1)
    a, b = np.arcsin(low)[:, None], np.arcsin(high)[:, None]
    angle = (a + b) / 2 + (b - a) / 2 * x
    return radius[:, None] * np.sin(angle), (b - a) / 2 * w * radius[:, None] * np.cos(angle)


@dataclass(frozen=True)
class _Place:
    """One place in the principal axes of its covariance: columns (3, n) turned, means (3,), deviations (3,)."""

    columns: np.ndarray
    means: np.ndarray
    deviations: np.ndarray


def _place(columns: np.ndarray, mean: np.ndarray, var: np.ndarray) -> _Place | None:
    """None where nothing varies."""
    values, vectors = np.linalg.eigh((columns * var) @ columns.T)
    values, vectors = values[::-1], vectors[:, ::-1]
    if values[0] <= 0:
        return None
    turned = vectors.T @ columns
    return _Place(turned, turned @ mean, np.sqrt(np.maximum(values, values[0] * 1e-14)))


def _shift(place: _Place) -> float:
    return float(np.linalg.norm(place.means))


class _Normal:
    """The mixture of normal T over places with weights."""

    def __init__(self, columns: np.ndarray, weights: np.ndarray, mean: np.ndarray, var: np.ndarray):
        self.mean, self.var = mean, var
        found = [_place(c, mean, var) for c in columns]
        self.fixed = [(w, float(np.linalg.norm(c @ mean))) for c, w, p in zip(columns, weights, found) if p is None]
        self.places = [(w, p) for w, p in zip(weights, found) if p is not None]

    def probability(self, r: float, order: int = ORDER) -> float:
        """P(|T| <= r)."""
        if r <= 0:
            return 0.0
        still = sum(w for w, size in self.fixed if size <= r)
        return still + sum(w * _ball(p.means, p.deviations, r, order, False).mass for w, p in self.places)

    def quantile(self, level: float) -> float:
        """r with P(|T| <= r) = level, by bisection to a bracket and then the Illinois rule."""
        high = max((_shift(p) + 3 * float(np.linalg.norm(p.deviations)) for _, p in self.places), default=0.0)
        high = max(high, *(size for _, size in self.fixed), 0.0) if self.fixed else high
        while self.probability(high) < level:
            high *= 1.5
        low, below, above = 0.0, -level, self.probability(high) - level
        side = 0
        for _ in range(60):
            middle = high - above * (high - low) / (above - below)
            value = self.probability(middle) - level
            if abs(value) < 1e-13 or high - low < 1e-13 * high:
                return middle
            if value > 0:
                high, above = middle, value
                below = below / 2 if side == 1 else below
                side = 1
            else:
                low, below = middle, value
                above = above / 2 if side == -1 else above
                side = -1
        return (low + high) / 2

    def error(self, level: float) -> float:
        """Error of `quantile` by that of the integral: what a change of the level by it would change."""
        r = self.quantile(level)
        off = abs(self.probability(r) - self.probability(r, ORDER * 3 // 4))
        return abs(self.quantile(min(level + off, 1 - 1e-12)) - r) if off > 1e-12 else 0.0

    def contributions(self, r: float) -> np.ndarray:
        """(n,) contributions to the quantile r."""
        total = np.zeros(len(self.var))
        for w, place in self.places:
            ball = _ball(place.means, place.deviations, r)
            c = place.columns
            # dP/d(covariance) = curvature / 2; the covariance grows by 2 var_i c_i c_iᵀ per d ln(scale of i)
            total -= w * self.var * np.einsum("an,ab,bn->n", c, ball.curvature, c)
            total -= w * self.mean * (ball.slope @ c)
        return total / total.sum() if total.sum() else total


# -- other laws --------------------------------------------------------------------------------------------------------
def sample(laws: Sequence[Tolerance], count: int = SAMPLES, seed: int = SEED) -> np.ndarray:
    """(n, count) random machines: a Latin hypercube in each of REPLICATES equal parts."""
    rng, each = np.random.default_rng(seed), count // REPLICATES
    out = np.empty((len(laws), each * REPLICATES))
    for i, law in enumerate(laws):
        ranks = np.concatenate([rng.permutation(each) for _ in range(REPLICATES)])
        out[i] = law.inverse((ranks + rng.random(len(ranks))) / each)
    return out


class _Sampled:
    """|T| of sampled machines x (n, N) at every place: size (P, N)."""

    def __init__(self, columns: np.ndarray, weights: np.ndarray, x: np.ndarray):
        self.columns, self.weights, self.x = columns, weights, x
        self.size = np.empty((len(columns), x.shape[1]))
        for row, c in zip(self.size, columns):
            t = c @ x
            np.sqrt(np.einsum("as,as->s", t, t), out=row)
        self.part = np.arange(x.shape[1]) * REPLICATES // x.shape[1]

    def probability(self, r: float) -> float:
        """P(|T| <= r)."""
        return float(self.weights @ (self.size <= r).mean(axis=1))

    def probability_error(self, r: float) -> float:
        """Its standard error."""
        parts = [float(self.weights @ (self.size[:, self.part == k] <= r).mean(axis=1)) for k in range(REPLICATES)]
        return float(np.std(parts, ddof=1) / math.sqrt(REPLICATES))

    def quantile(self, level: float, chosen=slice(None)) -> float:
        """r with P(|T| <= r) = level."""
        size = self.size[:, chosen]
        if len(size) == 1:
            return float(np.quantile(size[0], level))
        flat, weight = size.ravel(), np.repeat(self.weights, size.shape[1])
        order = np.argsort(flat)
        share = np.cumsum(weight[order])
        return float(flat[order][min(int(np.searchsorted(share, level * share[-1])), len(flat) - 1)])

    def error(self, level: float) -> float:
        """Standard error of `quantile`."""
        parts = [self.quantile(level, self.part == k) for k in range(REPLICATES)]
        return float(np.std(parts, ddof=1) / math.sqrt(REPLICATES))

    def contributions(self, r: float) -> np.ndarray:
        """(n,) contributions to the quantile r, of the machines that are within WINDOW of it."""
        total = np.zeros(len(self.x))
        for w, columns, size in zip(self.weights, self.columns, self.size):
            near = np.abs(size - r) <= WINDOW * r
            if near.any():
                x = self.x[:, near]
                total += w * np.einsum("an,as,ns->n", columns, columns @ x, x, optimize=True)
        return total / total.sum() if total.sum() else total


# -- either ------------------------------------------------------------------------------------------------------------
class RandomError:
    """|T| over random machines and over places.

    columns (P, 3, n): weighted Omega.  laws (n).  weights (P,): of the places, adding to 1.  machines (n, N): sampled
    ones, for laws that are not normal (default: `sample` of as many as MOST_NUMBERS allows).
    """

    def __init__(self, columns, laws: Sequence[Tolerance], weights=None, machines=None):
        columns = np.asarray(columns, dtype=float)
        columns = columns[None] if columns.ndim == 2 else columns
        weights = np.full(len(columns), 1 / len(columns)) if weights is None else np.asarray(weights, dtype=float)
        self.computed = normal(laws)
        if self.computed:
            table = np.array([law.moments for law in laws], dtype=float).reshape(-1, 4)
            self._of = _Normal(columns, weights, table[:, 0], table[:, 1])
        else:
            if machines is None:
                machines = sample(laws, max(LEAST_SAMPLES, min(SAMPLES, MOST_NUMBERS // len(columns))))
            self._of = _Sampled(columns, weights, machines)

    def probability(self, r: float) -> tuple[float, float]:
        """(P(|T| <= r), its error): of the quadrature for normal laws, else one standard error of the sample."""
        found = self._of.probability(r)
        if self.computed:
            return found, abs(found - self._of.probability(r, ORDER * 3 // 4))
        return found, self._of.probability_error(r)

    def quantile(self, level: float, error: bool = True) -> Quantile:
        """The quantile of |T|: its value, error (if asked for) and contributions."""
        value = self._of.quantile(level)
        return Quantile(value, self._of.error(level) if error else 0.0, self._of.contributions(value))

    def value(self, level: float) -> float:
        """The quantile of |T| alone."""
        return self._of.quantile(level)
