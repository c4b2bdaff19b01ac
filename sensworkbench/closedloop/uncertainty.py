# SPDX-License-Identifier: LGPL-2.1-or-later
"""Covariance of everything that a fit finds: coefficients, and the parameters of shapes that were searched for.

The estimate is generalised least squares, linear in the coefficients and, about its optimum, in the parameters; so the
covariance is F B Fᵀ, with F of the whole Jacobian and B of the noise as the residuals show it, its memory included (the
"sandwich": right also where the weights of the fit are not those of the noise).  What the readings do not determine
has the variance that the machine's tolerances leave to it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from ..core.machine import Machine
from ..core.propagation import factor_of
from .design import Design
from .fit import Fit, basis
from .readings import Readings
from .settings import TraceSettings

FREE_LENGTH, FREE_ANGLE = 1.0, 1e-3  # mm, rad: of a set-up that nothing is known of
SMALLEST = 1e-9  # mm or rad: of an error whose tolerance is zero
LAGS = 40
EXACT = 3000  # rows up to which the share that a fit takes from a correlation is computed, not estimated
DECAYS = (0.2, 0.4, 0.6, 0.7, 0.8, 0.87, 0.92, 0.95, 0.97, 0.985, 0.995)


@dataclass(frozen=True)
class NoiseModel:
    """Noise of whitened rows, per direction of sensing: variance, and correlation share * decay^lag.

    error : standard uncertainty of the decay, where it is known.
    """

    variance: dict[int, float]
    share: dict[int, float]
    decay: dict[int, float]
    error: dict[int, float]


@dataclass(frozen=True)
class Spread:
    """Covariance of n parameters as two factors: data (n, r) what the noise does, open (n, k) what tolerances leave.

    shift (n,): what the tolerances add to a minimum-norm estimate, along what the readings do not determine; zero
    where nothing is open.  determined (n,) bool.  common: source -> (n,) what one standard uncertainty of it, common
    to all readings, does to the parameters.
    """

    data: np.ndarray
    open: np.ndarray
    shift: np.ndarray
    determined: np.ndarray
    noise: NoiseModel
    common: Mapping[str, np.ndarray]

    @property
    def factor(self) -> np.ndarray:
        """(n, r + k + s): the covariance is this times its transpose."""
        return np.concatenate([self.data, *(c[:, None] for c in self.common.values()), self.open], axis=1)

    @property
    def u(self) -> np.ndarray:
        """(n,) standard uncertainty by the readings; NaN where they do not determine the parameter."""
        square = (self.data**2).sum(axis=1) + sum(c**2 for c in self.common.values())
        return np.where(self.determined, np.sqrt(square), np.nan)


# -- what the tolerances say -------------------------------------------------------------------------------------------
def expected(machine: Machine, design: Design) -> tuple[np.ndarray, np.ndarray]:
    """(mean (n,), standard deviation (n,)) of each term before anything is read, mm or rad.

    An error function varies over its travel as its tolerance does, in equal parts by each Legendre term; the set-up is
    all but free.
    """
    tolerances = machine.all_tolerances
    count: dict[str, int] = {}
    for term in design.terms:
        if term.group == "declared":
            count[term.symbol] = count.get(term.symbol, 0) + 1
    mean, deviation = np.zeros(len(design.terms)), np.zeros(len(design.terms))
    for i, term in enumerate(design.terms):
        tolerance = tolerances.get(term.symbol) if term.group == "declared" else None
        if tolerance is None:
            deviation[i] = FREE_ANGLE if term.angular else FREE_LENGTH
            continue
        middle, variance, *_ = tolerance.moments
        mean[i] = middle if term.order == 0 else 0.0
        deviation[i] = max(float(np.sqrt(variance * (2 * term.order + 1) / count[term.symbol])), SMALLEST)
    return mean, deviation


# -- noise of what is left ---------------------------------------------------------------------------------------------
@dataclass(frozen=True)
class _Line:
    """The rows of one direction of sensing in their order.

    rows (N,): their numbers.  gap (N,): readings since the row before, 0 where a run begins.
    """

    rows: np.ndarray
    gap: np.ndarray

    def correlated(self, x, decay: float) -> np.ndarray:
        """V x (N, m), V the correlation decay^|i - j| of rows of one run: a recursion in either direction."""
        factor = np.where(self.gap > 0, np.sign(decay) ** self.gap * abs(decay) ** self.gap, 0.0)
        behind = _recursion(x, factor)
        ahead = _recursion(x[::-1], np.r_[0.0, factor[1:][::-1]])[::-1]
        return behind + ahead - x

    def lagged(self, a, b) -> float:
        """Sum of a_i b_(i+1), row by row (N, m), over rows of one run."""
        same = self.gap[1:] > 0
        return float((a[:-1][same] * b[1:][same]).sum())


def _recursion(x, factor) -> np.ndarray:
    """y (N, m) with y_i = x_i + factor_i y_(i-1), by doubling the step."""
    y, c, step = np.array(x, dtype=float), np.array(factor, dtype=float), 1
    while step < len(y) and np.abs(c).max() > 1e-12:
        y[step:] += c[step:, None] * y[:-step]
        c[step:] = c[step:] * c[:-step]
        c[:step] = 0.0
        step *= 2
    return y


def _lines(fitted: Fit, readings: Readings) -> dict[int, _Line]:
    """direction of sensing -> the rows that are in use."""
    if readings.run is None:
        run = np.zeros(readings.points, dtype=int)
    else:
        run = np.unique([str(r) for r in readings.run], return_inverse=True)[1].ravel()
    out = {}
    for kind in np.unique(readings.kind).tolist():
        rows = np.flatnonzero((readings.kind == kind) & (fitted.weight > 0))
        point = readings.point[rows]
        gap = np.r_[0, np.diff(point)]
        gap[1:][np.diff(run[point]) != 0] = 0
        out[kind] = _Line(rows, gap)
    return out


def _correlations(r, line: _Line, count: int) -> np.ndarray:
    """(count,) correlations of r (N,) at lags 1 .. count within runs."""
    below = max(float(r @ r), 1e-300)
    number = np.cumsum(line.gap == 0)
    out = np.zeros(count)
    for lag in range(1, count + 1):
        same = number[lag:] == number[:-lag]
        out[lag - 1] = float(r[lag:][same] @ r[:-lag][same]) / below
    return out


def _drift(found, count: int) -> tuple[float, float] | None:
    """(share, decay) of a slow drift under white noise whose correlations are share * decay^lag; None: no drift.

    found (K,): correlations of `count` residuals.  It is one where many lags are correlated.
    """
    if (found > 2 / np.sqrt(max(count, 1))).sum() < max(3, 0.2 * len(found)):
        return None
    lag, best = np.arange(1, len(found) + 1), (np.inf, 1.0, 0.0)
    for decay in DECAYS:
        power = decay**lag
        share = float(np.clip(power @ found / (power @ power), 0.0, 1.0))
        best = min(best, (float(((found - share * power) ** 2).sum()), share, decay))
    return best[1:]


def _memory(q, r, line: _Line, others, s: TraceSettings) -> tuple[float, float]:
    """(correlation of successive errors whose residuals r (N,) have the correlation that is observed, its u).

    A fit takes a part of it: r = (I - H) e, with H = Q Qᵀ.  q (N, m): the rows of Q; others (m, m): Qᵀ V Q of the other
    directions.
    """
    observed = line.lagged(r[:, None], r[:, None]) / max(float(r @ r), 1e-300)
    size = len(r)
    plain = np.where(line.gap[1:] > 0, line.gap[1:], np.inf)

    def expectation(decay: float) -> float:
        turned = line.correlated(q, decay)
        inner = others + q.T @ turned
        mixed = q @ inner
        square = size - 2 * float((q * turned).sum()) + float((mixed * q).sum())
        pure = float((np.sign(decay) ** plain * abs(decay) ** plain)[np.isfinite(plain)].sum())
        next_one = pure - line.lagged(q, turned) - line.lagged(turned, q) + line.lagged(mixed, q)
        return next_one / max(square, 0.1 * size)

    low, high = s.memory_negative, s.memory_most
    for _ in range(9 if observed > expectation(low) else 0):
        middle = (low + high) / 2
        low, high = (middle, high) if expectation(middle) < observed else (low, middle)
    found = (low + high) / 2 if high < s.memory_most or low > s.memory_negative else low
    slope = (expectation(min(found + 0.03, s.memory_most)) - expectation(found - 0.03)) / 0.06
    return found, float(np.sqrt((1 - found**2) / size) / max(slope, 0.2))


def _averaged(line: _Line, q, decay: float, error: float, s: TraceSettings) -> np.ndarray:
    """(m, m) Qᵀ V Q, averaged over a correlation that is known to a standard uncertainty."""
    aside = np.sqrt(2) * error
    out = q.T @ line.correlated(q, decay)
    if aside < s.memory_negligible:
        return out
    ends = [
        q.T @ line.correlated(q, float(np.clip(decay + side * aside, s.memory_negative, s.memory_most)))
        for side in (-1, 1)
    ]
    return out / 2 + (ends[0] + ends[1]) / 4


def _correlation(q, r, line: _Line, others, s: TraceSettings) -> tuple[float, float, float]:
    """(share, decay, its standard uncertainty) of the noise whose residuals are r (N,); see `_memory`.

    A negative correlation counts only beyond 2.5 standard errors.
    """
    count = len(r)
    if count < s.memory_rows:
        return 0.0, 0.0, 0.0
    found = _correlations(r, line, int(min(LAGS, max(count // 5, 1))))
    left = max(count - float((q**2).sum()), 0.1 * count)
    drift = _drift(found * count / left + (1 + 3 * max(found[0], 0.0)) / count, count)
    if drift is not None:
        return (*drift, 0.0)
    first, error = found[0] * count / left + 1 / count, 1 / np.sqrt(count)
    if count <= EXACT:
        first, error = _memory(q, r, line, others, s)
    if -s.negative_score * error < first < 0:
        return 0.0, 0.0, 0.0
    return 1.0, float(np.clip(first, s.memory_negative, s.memory_most)), error


def noise_model(fitted: Fit, readings: Readings, ortho, known: NoiseModel | None = None):
    """(`NoiseModel` of the whitened rows, (m, m) sum over directions of Qᵀ V Q) for an orthonormal basis Q (R, m).

    Variance and correlation are those whose residuals look as those of the fit do: what a fit takes from correlated
    noise is counted.  known : correlations of it are used instead.
    """
    settings, residual = fitted.settings, fitted.white(fitted.residual)
    noise = NoiseModel({}, {}, {}, {})
    lines = _lines(fitted, readings)
    plain = {k: ortho[line.rows].T @ ortho[line.rows] for k, line in lines.items()}
    whole = sum(plain.values())
    total = np.zeros((ortho.shape[1], ortho.shape[1]))
    for kind, line in lines.items():
        inner, count = plain[kind], len(line.rows)
        q, r = ortho[line.rows], residual[line.rows]
        if known is None:
            share, decay, error = _correlation(q, r, line, whole - inner, settings)
        else:
            share, decay, error = known.share[kind], known.decay[kind], known.error[kind]
        if abs(share * decay) > settings.memory_negligible:
            inner = (1 - share) * inner + share * _averaged(line, q, decay, error, settings)
        else:
            share = decay = 0.0
        free = max(count - float(np.trace(inner)), 0.1 * count)
        noise.variance[kind] = float(r @ r) / free if count >= settings.memory_rows else 1.0
        noise.share[kind], noise.decay[kind], noise.error[kind] = share, decay, error
        total += noise.variance[kind] * inner
    return noise, (total + total.T) / 2


# -- the covariance ----------------------------------------------------------------------------------------------------
def spread(fitted: Fit, readings: Readings, effects=None, extra=None, prior=None, noise=None, common=None) -> Spread:
    """The covariance of the coefficients of a fit, and of parameters that were searched for.

    effects : (R, m) columns of the effects in the fit.  extra : (R, d) derivatives of the readings by the parameters,
    after the coefficients in what is returned.  prior : (mean, standard deviation), each (n + d,), of the parameters
    before anything was read; they decide what the readings do not determine (None: it stays out).
    noise : a `NoiseModel` whose correlations are used (None: those of the residuals).  common : source -> (R,) mm what
    one standard uncertainty of it does to the readings.
    """
    parts = [fitted.design.matrix]
    parts += [p for p in (effects, extra) if p is not None and p.shape[1]]
    matrix = np.concatenate(parts, axis=1) if len(parts) > 1 else parts[0]
    b = basis(fitted.white(matrix))
    n = matrix.shape[1]
    finite = np.isfinite(b.scale)
    scale = np.where(finite, b.scale, 1.0)
    rows = (b.v / b.s) / scale[:, None]
    noise, inner = noise_model(fitted, readings, b.ortho, noise)
    common = common or {}
    turned = [rows @ (b.ortho.T @ fitted.white(field)) for field in common.values()]
    data = np.column_stack([*turned, rows @ factor_of(inner)])
    determined = (1 - (b.v**2).sum(axis=1) < 1e-6) & finite
    open_part, shift = np.zeros((n, 0)), np.zeros(n)
    if b.rank < n:
        estimate = np.zeros(n)
        known = min(len(fitted.coefficients), n)
        estimate[:known] = fitted.coefficients[:known]
        data, open_part, shift = _settled(b.v, scale, data, estimate, prior)
    moved = {name: data[:, i] for i, name in enumerate(common)}
    return Spread(data[:, len(moved) :], open_part, shift, determined, noise, moved)


def _settled(v, scale, data, estimate, prior):
    """(data factor, open factor, shift of the estimate) with the tolerances deciding what is open.

    Of all parameters that fit the readings equally well the most probable are taken; their spread along the open
    directions N is N (Nᵀ P⁻¹ N)⁻¹ Nᵀ.
    """
    n = len(scale)
    if prior is None:
        return data, np.zeros((n, 0)), np.zeros(n)
    mean, deviation = prior
    full = np.linalg.svd(v, full_matrices=True)[0]
    null = full[:, v.shape[1] :] / scale[:, None]
    weighed = null / deviation[:, None]  # P^(-1/2) N
    q, _ = np.linalg.qr(weighed / np.maximum(np.linalg.norm(weighed, axis=0), 1e-300))
    open_part = deviation[:, None] * q  # its product with its transpose is N (Nᵀ P⁻¹ N)⁻¹ Nᵀ

    def project(x):
        return x - open_part @ (q.T @ (x / (deviation if x.ndim == 1 else deviation[:, None])))

    moved = mean + project(estimate - mean)
    return project(data), open_part, moved - estimate


def settled(fitted: Fit, machine: Machine, readings: Readings, effects=None) -> Fit:
    """The fit with the most probable by the machine's tolerances of all coefficients that fit the readings equally
    well.  effects : (R, m) their columns in the fit.  Residuals stay: no reading sees what is open.
    """
    if fitted.basis.rank == len(fitted.coefficients):
        return fitted
    found = spread(fitted, readings, effects, None, with_effects(expected(machine, fitted.design), fitted.extra))
    return replace(fitted, coefficients=fitted.coefficients + found.shift)


def with_effects(prior, count: int, further=()) -> tuple[np.ndarray, np.ndarray]:
    """The prior (mean, deviation) of the terms, of `count` coefficients of effects (all but free), and of more."""
    mean, deviation = prior
    more = np.concatenate([np.full(count, FREE_LENGTH), np.asarray(further, dtype=float)])
    return np.concatenate([mean, np.zeros(len(more))]), np.concatenate([deviation, more])


def triangle(factor) -> np.ndarray:
    """(n, min(n, k)) lower trapezoid with the same product with its transpose as `factor` (n, k)."""
    n, k = factor.shape
    if k == 0:
        return np.zeros((n, 0))
    size = np.sqrt((factor**2).sum(axis=1))
    size = np.where(size > 0, size, 1.0)
    r = np.linalg.qr((factor / size[:, None]).T, mode="r")  # (min(n, k), n)
    signs = np.where(np.diag(r) < 0, -1.0, 1.0)
    return (signs[:, None] * r).T * size[:, None]
