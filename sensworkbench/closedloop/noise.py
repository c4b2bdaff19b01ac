# SPDX-License-Identifier: LGPL-2.1-or-later
"""Noise that remembers: a first-order autoregressive model per direction of sensing, along the order of the readings.

Residual e of a reading and f of the one before it in the same direction are correlated by phi; (e - phi f)/sqrt(1 -
phi^2) is white and as large as e.  Whole runs are independent of each other.  A fit of whitened rows is generalised
least squares (Cochrane and Orcutt 1949; Prais and Winsten 1954 for the first reading of a run).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .readings import Readings

NOISELESS = 1e-3  # of the variance of a reading: of residuals smaller than that the correlation says nothing


@dataclass(frozen=True)
class Memory:
    """Whitening of weighted rows.

    before : (R,) row before each one in its direction and run, -1 where there is none.  phi : (R,) correlation with it.
    """

    before: np.ndarray
    phi: np.ndarray

    def _parts(self):
        has = self.before >= 0
        scale = 1 / np.sqrt(1 - self.phi**2)
        return has, scale, np.where(has, self.phi * scale, 0.0)

    def forward(self, x) -> np.ndarray:
        """L x: rows (R,) or (R, m) whitened."""
        has, scale, other = self._parts()
        wide = (slice(None), None) if x.ndim > 1 else slice(None)
        return scale[wide] * x - other[wide] * np.where(has[wide], x[self.before], 0.0)

    def back(self, x) -> np.ndarray:
        """Transpose of L times x, (R,) or (R, m)."""
        has, scale, other = self._parts()
        wide = (slice(None), None) if x.ndim > 1 else slice(None)
        out = scale[wide] * x
        rows = np.flatnonzero(has)
        np.subtract.at(out, self.before[rows], (other[wide] * x)[rows])
        return out

    def solve(self, x) -> np.ndarray:
        """Inverse of L times x: whitened rows as they were."""
        has, scale, other = self._parts()
        out = x / (scale if x.ndim == 1 else scale[:, None])
        factor = (other / scale).tolist()
        before = self.before.tolist()
        for i in np.flatnonzero(has).tolist():  # a row stands behind the one before it
            out[i] += factor[i] * out[before[i]]
        return out

    def thinned(self, keep) -> Memory:
        """The whitening of some rows, keep (R,) bool: correlations multiply along the rows between."""
        before, phi = self.before[keep].copy(), self.phi[keep].copy()
        while True:
            between = (before >= 0) & ~keep[before]
            if not between.any():
                break
            phi[between] *= self.phi[before[between]]
            before[between] = self.before[before[between]]
        number = np.cumsum(keep) - 1
        return Memory(np.where(before >= 0, number[before], -1), np.where(before >= 0, phi, 0.0))

    @property
    def diagonal(self) -> np.ndarray:
        """(R,) diagonal of LᵀL."""
        _, scale, other = self._parts()
        out = scale**2
        rows = np.flatnonzero(self.before >= 0)
        np.add.at(out, self.before[rows], other[rows] ** 2)
        return out

    @property
    def neighbours(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """(rows, the rows before them, entries of LᵀL between the two)."""
        _, scale, other = self._parts()
        rows = np.flatnonzero(self.before >= 0)
        return rows, self.before[rows], -(scale * other)[rows]


def duration(phi: float) -> float:
    """The number of readings that count as one: the variance of a mean is so many times that of white noise."""
    return (1 + phi) / (1 - phi)


def _before(kind, run_of_row, use) -> np.ndarray:
    before = np.full(len(kind), -1)
    for k in np.unique(kind):
        rows = np.flatnonzero((kind == k) & use)
        same = run_of_row[rows[1:]] == run_of_row[rows[:-1]]
        before[rows[1:][same]] = rows[:-1][same]
    return before


def _runs(readings: Readings) -> np.ndarray:
    """(R,) number of the run of each row."""
    if readings.run is None:
        return np.zeros(readings.rows, dtype=int)
    _, number = np.unique([str(r) for r in readings.run], return_inverse=True)
    return number[readings.point]


def memory_of(readings: Readings, correlations, use) -> Memory | None:
    """The whitening for correlations per direction {kind: phi}; rows without `use` (R,) are skipped.

    Across rows that are left out the correlation falls with the number of readings between.  None: nothing remembers.
    """
    if not any(correlations.values()):
        return None
    before = _before(readings.kind, _runs(readings), use)
    table = np.array([correlations.get(k, 0.0) for k in range(int(readings.kind.max()) + 1)])
    gap = readings.point - readings.point[np.where(before >= 0, before, 0)]
    phi = np.where(before >= 0, table[readings.kind] ** np.maximum(gap, 1), 0.0)
    return Memory(before, phi)


def lagged(fitted, readings: Readings, lag: int) -> dict[int, float]:
    """kind -> correlation of the weighted residual with that `lag` readings before, in a run; outliers are skipped."""
    r = fitted.residual * fitted.weight
    run = _runs(readings)
    out = {}
    for k in np.unique(readings.kind).tolist():
        rows = np.flatnonzero((readings.kind == k) & (fitted.weight > 0))
        below = float(r[rows] @ r[rows]) + NOISELESS * len(rows)
        a, b = rows[lag:], rows[:-lag]
        same = run[a] == run[b]
        out[k] = float(r[a[same]] @ r[b[same]]) / below if below > 0 and same.any() else 0.0
    return out


def slow_drift(fitted, readings: Readings, settings, least=None, score=None) -> int | None:
    """The number of readings over which residuals are still alike, where that is too long to be noise; else None.

    Judged by the correlation of each reading with the one a twentieth of the readings (five at least) before it, per
    direction: noise of short memory has forgotten by then, and what has not is a drift that is there once.  least,
    score : other limits than those of the settings, a correlation and standard errors.
    """
    least, score = settings.remembers if least is None else least, settings.drift_score if score is None else score
    points = readings.points
    lag = max(settings.drift_least, round(settings.drift * points))
    for k, found in lagged(fitted, readings, lag).items():
        count = int(np.count_nonzero((readings.kind == k) & (fitted.weight > 0)))
        limit = max(least, score / np.sqrt(max(count - lag, 1)))
        if found > limit:
            return lag
    return None


def correlation(fitted, readings: Readings, settings) -> dict[int, float]:
    """Return kind -> correlation of successive residuals that is to be modelled; 0 if it is not significant, or small.

    Judged per direction: one that drifts is not diluted by two that do not.  What the fitted parameters take from the
    correlation is added again (Marriott and Pope 1954, and the share of the degrees of freedom).
    """
    out = {}
    used = max(int(np.count_nonzero(fitted.weight)), 1)
    share = used / max(fitted.dof, 0.5 * used)
    for k, first in lagged(fitted, readings, 1).items():
        count = int(np.count_nonzero((readings.kind == k) & (fitted.weight > 0)))
        certain = first * np.sqrt(max(count, 1)) > settings.memory_score
        whole = first * share + (1 + 3 * first) / max(count, 10)
        out[k] = min(whole, settings.memory_most) if first > settings.memory_least and certain else 0.0
    return out
