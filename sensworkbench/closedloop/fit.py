# SPDX-License-Identifier: LGPL-2.1-or-later
"""Declared fit: weighted, robust least squares, with rank, condition and the null space in words.

Gross outliers are found by a redescending step (Tukey's biweight, then a hard limit on the studentised residual) and
listed; noise is estimated per direction of sensing where it is not stated.  A parameter that the readings do not
determine gets a minimum-norm value for prediction and no uncertainty: it is not reported.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..messages import Message
from .design import Design
from .noise import Memory, correlation, memory_of
from .readings import Readings
from .settings import DEFAULT, TraceSettings

__all__ = ["Basis", "Fit", "basis", "correlation", "fit", "null_space", "robust_scale"]

RANK_TOLERANCE = 1e-6
NOTHING = 1e-15  # length of a column over the longest: less is what rounding leaves of a zero
REFINED = 300.0  # condition from which a solution is refined
MAD = 1.482602218505602


def robust_scale(r) -> float:
    """Normal-consistent median absolute deviation about zero."""
    return float(MAD * np.median(np.abs(r))) if len(r) else 0.0


@dataclass(frozen=True)
class Basis:
    """Orthonormal basis of the weighted design: ortho (R, rank), v (n, rank), s (rank,): columns = ortho s vᵀ."""

    ortho: np.ndarray
    s: np.ndarray
    v: np.ndarray
    scale: np.ndarray
    condition: float

    @property
    def rank(self) -> int:
        """Number of parameters, or combinations of them, that the readings determine."""
        return self.ortho.shape[1]


def _lengths(scale) -> np.ndarray:
    """Lengths of columns, infinite where only rounding is left of one."""
    return np.where(scale <= NOTHING * max(scale.max(initial=0.0), 1e-300), np.inf, scale)


def basis(matrix, weight=None) -> Basis:
    """Column-scaled SVD of the design (R, n); weight (R,) multiplies rows (None: they are weighted already).

    Twice through the Gram matrix (the second pass restores orthogonality to rounding): for tall designs many times
    faster than Householder, and exact enough where singular values span less than 1/RANK_TOLERANCE.
    """
    x = matrix if weight is None else matrix * weight[:, None]
    gram = x.T @ x
    scale = _lengths(np.sqrt(np.diag(gram)))
    values, vectors = np.linalg.eigh(gram / scale / scale[:, None])
    keep = values > RANK_TOLERANCE**2 * values[-1]
    root = np.sqrt(values[keep])
    q = x @ (vectors[:, keep] / root / scale[:, None])
    lower = np.linalg.cholesky(q.T @ q)  # nearly the identity
    u, s, vt = np.linalg.svd(lower.T @ (root[:, None] * vectors[:, keep].T), full_matrices=False)
    return Basis(q @ np.linalg.solve(lower.T, u), s, vt.T, scale, float(s[0] / s[-1]) if len(s) else 1.0)


def solution(b: Basis, weighted, target) -> np.ndarray:
    """(n,) minimum-norm least squares solution of the weighted (whitened) design (R, n) that `b` is the basis of.

    An ill-conditioned design is refined twice (Bjorck 1967): coefficients and residual together, with sums in the
    longest floating point number that the machine has.
    """
    z = (b.v / b.s) @ (b.ortho.T @ target)
    if b.condition <= REFINED:
        return z / b.scale
    finite = np.isfinite(b.scale)
    x = np.where(finite, weighted, 0.0).astype(np.longdouble) / np.where(finite, b.scale, 1.0)
    wanted, z = np.asarray(target, dtype=np.longdouble), z.astype(np.longdouble)
    residual = wanted - x @ z
    for _ in range(2):
        short, across = wanted - residual - x @ z, -(x.T @ residual)
        step = (b.v / b.s) @ (b.ortho.T @ short.astype(float) - (b.v.T @ across.astype(float)) / b.s)
        z = z + step
        residual = residual + short - x @ step.astype(np.longdouble)
    return (z / np.where(finite, b.scale, np.inf)).astype(float)


@dataclass(frozen=True)
class _Quick:
    """A fit by the normal equations: enough to weigh readings, many times faster than the SVD.

    residual (R,), not weighted.  rank.  columns (R, n), weighted; columns @ root is orthonormal.
    """

    residual: np.ndarray
    rank: int
    columns: np.ndarray
    root: np.ndarray

    def leverage(self, rows) -> np.ndarray:
        """(k,) of some rows (numbers)."""
        return self.spread(self.columns[rows])

    def spread(self, columns) -> np.ndarray:
        """(k,) variance of what the fit predicts for weighted rows (k, n), over that of the noise."""
        q = columns @ self.root
        return np.einsum("ri,ri->r", q, q)


def _quick(matrix, weight, y) -> _Quick:
    x = matrix * weight[:, None]
    gram = x.T @ x
    scale = _lengths(np.sqrt(np.diag(gram)))
    values, vectors = np.linalg.eigh(gram / scale / scale[:, None])
    keep = values > 1e-12 * values[-1]
    root = vectors[:, keep] / np.sqrt(values[keep]) / scale[:, None]
    theta = root @ (root.T @ (x.T @ (y * weight)))
    return _Quick(y - matrix @ theta, int(keep.sum()), x, root)


@dataclass(eq=False)
class Fit:
    """A weighted fit.

    coefficients (n,), mm or rad; determined (n,) bool; covariance (n, n) of the determined part (zero elsewhere).
    residual (R,) mm; sigma (R,) mm: noise of each reading as used; weight (R,): 1/sigma, 0 for outliers; outliers (R,)
    bool; noise: kind -> sigma mm; basis of the whitened rows; null_space (n, k), reduced; dof; memory of the noise;
    settings that it was made with.
    """

    design: Design
    coefficients: np.ndarray
    determined: np.ndarray
    covariance: np.ndarray
    residual: np.ndarray
    sigma: np.ndarray
    weight: np.ndarray
    outliers: np.ndarray
    noise: dict
    basis: Basis
    null_space: np.ndarray
    extra: int  # columns appended for effects
    dof: float
    memory: Memory | None = None
    settings: TraceSettings = DEFAULT

    def white(self, x) -> np.ndarray:
        """Rows (R,) or (R, m) over their noise, its memory taken out: white and of variance 1 where x is noise."""
        y = x * (self.weight if x.ndim == 1 else self.weight[:, None])
        return y if self.memory is None else self.memory.forward(y)

    @property
    def chi2(self) -> float:
        """Sum of the squared residuals, each divided by its standard uncertainty."""
        return float((self.white(self.residual) ** 2).sum())


def _noise(residual, readings: Readings, good, loss: float, stated, least: float) -> tuple[np.ndarray, dict]:
    """Noise of each row: the stated one, scaled if it is wrong, else the robust spread of its kind of sensing."""
    sigma = np.empty(len(residual))
    table = {}
    for kind in np.unique(readings.kind):
        rows = readings.kind == kind
        use = rows & good
        spread = float(np.sqrt((residual[use] ** 2).mean())) if use.sum() > 3 else robust_scale(residual[rows])
        spread = max(spread * loss, least)
        if stated is not None and np.isfinite(stated[rows]).all():
            ratio = float(np.sqrt(((residual[use] / stated[use]) ** 2).mean())) * loss if use.any() else 1.0
            sigma[rows] = np.maximum(stated[rows] * ratio, least)
        else:
            sigma[rows] = spread
        table[int(kind)] = float(np.sqrt((sigma[rows] ** 2).mean()))
    return sigma, table


def _crowded(outliers, readings: Readings, s: TraceSettings) -> np.ndarray:
    """(R,) bool: the flagged rows that are kept as signal, because they are too many or too close for outliers.

    All, where they are more than a tenth of the points.  Those that follow each other in time (three in a row), or that
    crowd in some column: of the readings in a stretch that holds most of them, at least a third are flagged.  (A column
    of few levels, such as a load that is on or off, brings its readings back with the effect that explains them.)
    """
    bad = np.bincount(readings.point, weights=outliers, minlength=readings.points) > 0
    count = int(bad.sum())
    if bad.mean() > s.crowd:
        return outliers.copy()
    kept = _streaks(bad, s.streak)
    if count >= s.crowd_least:
        for v in readings.columns.values():
            if np.ptp(v) > 0 and len(np.unique(v)) > s.few_levels:
                low, high = np.quantile(v[bad], [0.1, 0.9])
                inside = (v >= low) & (v <= high)
                if bad[inside].mean() > s.crowd_flagged and inside.mean() < s.crowd_stretch:
                    kept |= bad & inside
    return outliers & kept[readings.point]


def _streaks(bad, least: int) -> np.ndarray:
    """(P,) bool: flagged points of three or more in a row; one that is not flagged does not end a longer row."""
    edges = np.flatnonzero(np.diff(np.r_[0, bad.astype(int), 0]))
    kept = np.zeros(len(bad), dtype=bool)
    for a, b in zip(edges[::2], edges[1::2]):
        if b - a >= least:
            kept[a:b] = True
    if kept.any():  # what is flagged right beside a row belongs to it
        near = np.convolve(kept, np.ones(11), mode="same") > 0
        kept |= bad & near
    return kept


def _robust_start(matrix, y, weight, stated, readings: Readings, s: TraceSettings):
    """(sigma, good) after three steps of Tukey's biweight, whose scale is the median of each kind of sensing."""
    count = len(y)
    robust = np.ones(count)
    for _ in range(3):
        found = _quick(matrix, weight * np.sqrt(robust), y)
        residual, loss = found.residual, np.sqrt(count / max(count - found.rank, 1))
        known = np.ones(count) if stated is None else np.where(np.isfinite(stated), stated, 1)
        sigma = np.empty(count)
        for kind in np.unique(readings.kind):
            rows = readings.kind == kind
            scale = robust_scale(residual[rows] / known[rows]) * loss
            sigma[rows] = np.maximum(max(scale, 1e-9) * known[rows], s.least_noise)
        z = residual / sigma
        robust = np.where(np.abs(z) < s.biweight, (1 - (z / s.biweight) ** 2) ** 2, 0.0)
        weight = 1 / sigma
    return sigma, robust


def _weigh(matrix, y, weight, robust, stated, readings: Readings, signal, s: TraceSettings):
    """(sigma, noise, good): noise from the mean square of the rows that are kept, until these no longer change.

    signal : (R,) bool, rows that are kept whatever they are.
    """
    good, noise = robust > 0, {}
    for step in range(9):
        found = _quick(matrix, weight * np.sqrt(robust), y)
        kept, previous = good.sum(), good
        sigma, noise = _noise(
            found.residual, readings, good, np.sqrt(kept / max(kept - found.rank, 1)), stated, s.least_noise
        )
        z = np.abs(found.residual / sigma)
        far = np.flatnonzero(z >= s.outlier * np.sqrt(s.least_free))  # the others are good whatever their leverage
        free = np.maximum(1 - found.leverage(far), s.least_free)
        out = ~good[far]  # predicted by the others: far above 1 where the model is extrapolated to them
        free[out] = 1 + found.spread(matrix[far[out]] * weight[far[out], None])
        z[far] /= np.sqrt(free)
        good = (z < s.outlier) | signal
        robust = good.astype(float)
        weight = 1 / sigma
        if step > 0 and np.array_equal(good, previous):
            break
    return sigma, noise, good


def fit(
    design: Design,
    readings: Readings,
    effects: np.ndarray | None = None,
    start=None,
    memory=None,
    settings: TraceSettings = DEFAULT,
) -> Fit:
    """Robust weighted least squares of the declared design and `effects` (R, m) appended columns.

    start : an earlier Fit whose noise starts the iteration.  memory : kind -> correlation of successive residuals, or
    None; the last step is then generalised least squares.  Outliers are decided afresh each time, so a row that an
    effect explains is admitted again; where they crowd, they are structure, and the fit is plain least squares.
    """
    matrix = design.matrix if effects is None else np.concatenate([design.matrix, effects], axis=1)
    y = readings.value
    stated = readings.u if np.isfinite(readings.u).any() else None
    count, n = matrix.shape
    first = np.ones(count) if start is None else np.where(start.sigma > 0, 1 / start.sigma, 0.0)
    if start is None and stated is not None and np.isfinite(stated).all():
        first = 1 / np.maximum(stated, 1e-9)
    sigma, robust = _robust_start(matrix, y, first, stated, readings, settings)
    signal = np.zeros(count, dtype=bool)
    sigma, noise, good = _weigh(matrix, y, 1 / sigma, robust, stated, readings, signal, settings)
    for _ in range(4):
        crowd = _crowded(~good, readings, settings)
        if not crowd.any():
            break
        signal |= crowd
        sigma, noise, good = _weigh(
            matrix, y, 1 / sigma, np.maximum(good, signal).astype(float), stated, readings, signal, settings
        )
    w = good / sigma
    whitening = None if not memory else memory_of(readings, memory, good)
    weighted, target = matrix * w[:, None], y * w
    if whitening is not None:
        weighted, target = whitening.forward(weighted), whitening.forward(target)
    b = basis(weighted)
    theta = solution(b, weighted, target)
    residual = y - matrix @ theta
    rows_of_v = b.v / b.s
    scale = np.where(np.isfinite(b.scale), b.scale, 1.0)
    covariance = (rows_of_v @ rows_of_v.T) / np.outer(scale, scale)
    missing = 1 - (b.v**2).sum(axis=1)
    determined = (missing < 1e-6) & np.isfinite(b.scale)
    covariance[:, ~determined] = covariance[~determined, :] = 0.0
    return Fit(
        design=design,
        coefficients=theta,
        determined=determined,
        covariance=covariance,
        residual=residual,
        sigma=sigma,
        weight=w,
        outliers=~good,
        noise=noise,
        basis=b,
        null_space=_null_space(b, n),
        extra=0 if effects is None else effects.shape[1],
        dof=float(good.sum() - b.rank),
        memory=whitening,
        settings=settings,
    )


def _null_space(b: Basis, n: int) -> np.ndarray:
    """(n, k) basis of the combinations that no reading sees, reduced so that each names few parameters."""
    if b.rank == n:
        return np.zeros((n, 0))
    full, _, _ = np.linalg.svd(b.v, full_matrices=True)
    null = full[:, b.rank :].T  # (k, n)
    row = 0
    for column in range(n - 1, -1, -1):  # from the last parameter: alignment takes the blame last
        if row == len(null):
            break
        pivot = row + int(np.argmax(np.abs(null[row:, column])))
        if abs(null[pivot, column]) < 1e-6:
            continue
        null[[row, pivot]] = null[[pivot, row]]
        null[row] /= null[row, column]
        others = np.arange(len(null)) != row
        null[others] -= np.outer(null[others, column], null[row])
        row += 1
    null[np.abs(null) < 1e-6] = 0.0
    return null.T


def null_space(fit: Fit, readings: Readings, settings: TraceSettings = DEFAULT) -> list[Message]:
    """What the readings do not determine: one message per combination, with the advice that fits what was sensed."""
    terms = fit.design.terms
    found = []
    for vector in fit.null_space[: len(terms)].T:
        share = np.round(np.abs(vector) / np.abs(vector).max(), 6)  # equal ones stand in the order of the terms
        strong = [i for i in np.argsort(-share, kind="stable") if share[i] > settings.null_named]
        names = list(dict.fromkeys(terms[i].title for i in strong))
        if names:
            found.append(_undetermined(names, readings, settings))
    return sorted(dict.fromkeys(found), key=str)


def _undetermined(names: list[str | Message], readings: Readings, settings: TraceSettings) -> Message:
    """One set of parameters that no reading separates.

    A second tool helps where whole vectors were read with one tool; where some directions of space were not sensed at
    all, they come first.
    """
    if len(names) == 1:
        code, fields = "null-unseen", {"name": names[0]}
    else:
        code, fields = "null-alike", {"names": names[:-1], "last": names[-1]}
    sensed = np.linalg.svd(readings.sense, compute_uv=False)
    if (sensed > settings.unsensed * sensed[0]).sum() < 3:
        return Message(f"{code}-direction", **fields)
    tools = 0 if readings.tool_offset is None else len(np.unique(np.round(readings.tool_offset, 4), axis=0))
    return Message(f"{code}-tool" if tools < 2 else code, **fields)
