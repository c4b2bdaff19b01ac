# SPDX-License-Identifier: LGPL-2.1-or-later
"""Score every component x driver x shape at once, each with the declared model refitted together with it.

With the weighted declared model projected out (M = I - QQᵀ), a candidate column c lowers chi-square by (cᵀMr)²/(cᵀMc)
exactly.  c is lever arm x driver, so cᵀMr for all candidates is one product of the driver bank with residuals gathered
per point, and cᵀMc needs the driver bank against Q alone: no candidate is ever refitted on its own.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from ..core.shapes import Regressor
from .bank import log_tail
from .noise import Memory
from .settings import DEFAULT, TraceSettings

CHUNK = 512  # bank entries at a time
MOST_KEPT = 160 * 2**20  # bytes of sums per point; beyond, those of other components are forgotten


@dataclass(frozen=True)
class Rows:
    """Weighted rows grouped by point.

    lever (R, C), times weight.  residual (R,): whitened, orthogonal to the model.  start (P,): first row of each point.
    ortho (R, m): orthonormal basis of the whitened model.  memory : of the noise, or None where it is white; then
    whitened means weighted.  middle : position column -> middle of the travel, where that is not 0 (see `whole`).
    settings : the thresholds of the trace.
    """

    lever: np.ndarray
    residual: np.ndarray
    start: np.ndarray
    ortho: np.ndarray
    memory: Memory | None = None
    middle: Mapping[str, float] = field(default_factory=dict)
    settings: TraceSettings = DEFAULT
    kept: dict = field(default_factory=dict, repr=False, compare=False)
    made: dict = field(default_factory=dict, repr=False, compare=False)

    def once(self, name: str, make):
        """What `make` returns, made at the first call."""
        if name not in self.made:
            self.made[name] = make()
        return self.made[name]

    def gather(self, x) -> np.ndarray:
        """(P, ...) sums over the rows of each point."""
        each = self.each
        if each is None:
            return np.add.reduceat(x, self.start, axis=0)
        total = x[::each].copy()
        for k in range(1, each):
            total += x[k::each]
        return total

    @cached_property
    def each(self) -> int | None:
        """The number of rows of every point, or None where they differ."""
        count = len(self.residual) // max(len(self.start), 1)
        same = count * len(self.start) == len(self.residual) and np.array_equal(
            self.start, count * np.arange(len(self.start))
        )
        return count if same else None

    def white(self, x) -> np.ndarray:
        """Weighted rows (R,) or (R, m) whitened."""
        return x if self.memory is None else self.memory.forward(x)

    def pulled(self, x) -> np.ndarray:
        """Whitened rows (R,) or (R, m) as what weighted columns are multiplied with: (white c)ᵀ x = cᵀ pulled(x)."""
        return x if self.memory is None else self.memory.back(x)

    @cached_property
    def used(self) -> int:
        """Number of rows that are no outliers."""
        return max(int(self.lever.any(axis=1).sum()), 1)

    @cached_property
    def point(self) -> np.ndarray:
        """(R,) point of each row."""
        return np.repeat(np.arange(len(self.start)), np.diff(np.r_[self.start, len(self.residual)]))

    @cached_property
    def pairs(self) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray] | None:
        """(first point, second point, row, row before, entry of the inverse covariance), or None for white noise."""
        if self.memory is None:
            return None
        rows, before, entry = self.memory.neighbours
        return self.point[before], self.point[rows], rows, before, entry

    def squares(self, lever) -> np.ndarray:
        """(P, C) what the square of a driver's value at each point counts, for weighted columns lever (R, C)."""
        x = lever**2 if self.memory is None else lever**2 * self.memory.diagonal[:, None]
        return self.gather(x)

    def crossed(self, lever) -> tuple[np.ndarray, np.ndarray, np.ndarray] | None:
        """(first point, second point, (pairs, C) what the product of the driver's values there counts), or None."""
        if self.pairs is None:
            return None
        first, second, row, before, entry = self.pairs
        value = entry[:, None] * lever[row] * lever[before]
        where, owner = np.unique(first * len(self.start) + second, return_inverse=True)
        total = np.zeros((len(where), lever.shape[1]))
        np.add.at(total, owner.ravel(), value)
        return where // len(self.start), where % len(self.start), total

    def inner(self, component: int, vectors) -> np.ndarray:
        """(m, m) inner products of a component times driver columns (P, m), before the model is taken out."""
        squares, crossed = self.per_point(component)[1], self.kept[component][3]
        out = (vectors * squares[:, None]).T @ vectors
        if crossed is not None:
            first, second, value = crossed
            part = (vectors[first] * value).T @ vectors[second]
            out = out + part + part.T
        return out

    def flipped(self, signs) -> np.ndarray:
        """(B, R) residuals with their signs turned, projected.

        Each is enlarged first by what the model took from its variance, its leverage (wild bootstrap: Davidson
        and Flachaire 2008): else a candidate that rests on rows of high leverage has a null that is too small.
        """
        left = np.maximum(1.0 - (self.ortho**2).sum(axis=1), self.settings.least_free)
        turned = signs * (self.residual / np.sqrt(left))
        turned -= (turned @ self.ortho) @ self.ortho.T
        return turned

    def thinned(self, points) -> Rows:
        """The rows of some points (sorted indices) alone, with a basis and residuals of their own: those of all rows
        are orthogonal to the model over all rows only, and what is nearly hidden would enlarge the rest.
        """
        size = np.diff(np.r_[self.start, len(self.residual)])
        keep = np.zeros(len(self.start), dtype=bool)
        keep[points] = True
        mask = np.repeat(keep, size)
        memory, residual, ortho = None, self.residual[mask], self.ortho[mask]
        if self.memory is not None:
            memory = self.memory.thinned(mask)
            residual = memory.forward(self.memory.solve(self.residual)[mask])
            ortho = memory.forward(self.memory.solve(self.ortho)[mask])
        ortho, r = np.linalg.qr(ortho)
        ortho = ortho[:, np.abs(np.diag(r)) > 1e-9]
        start = np.r_[0, np.cumsum(size[keep])[:-1]]
        return Rows(
            self.lever[mask], residual - ortho @ (ortho.T @ residual), start, ortho, memory, self.middle, self.settings
        )

    def per_point(self, component: int):
        """(model (P, m), squares (P,), residual (P,), pairs) of one component, summed over each point's rows; kept."""
        if component not in self.kept:
            if (len(self.kept) + 1) * len(self.start) * self.ortho.shape[1] * 8 > MOST_KEPT:
                self.kept.clear()
            lever = np.ascontiguousarray(self.lever[:, component])
            self.kept[component] = (
                self.gathered(lever),
                self.squares(lever[:, None])[:, 0],
                self.gather(lever * self._pulled_residual),
                self.crossed(lever[:, None]),
            )
        return self.kept[component]

    def gathered(self, lever) -> np.ndarray:
        """(P, m) sums over each point's rows of the pulled model times lever (R,)."""
        each = self.each
        if each is None:
            return self.gather(self._pulled_ortho * lever[:, None])
        points = len(self.start)
        parts = self._pulled_ortho.reshape(points, each, -1)
        return np.matmul(lever.reshape(points, 1, each), parts)[:, 0, :]

    @cached_property
    def _pulled_residual(self) -> np.ndarray:
        return self.pulled(self.residual - self.ortho @ (self.ortho.T @ self.residual))

    @cached_property
    def _pulled_ortho(self) -> np.ndarray:
        return self.pulled(self.ortho)


def whole(regressor: Regressor, columns, middle: Mapping[str, float]) -> np.ndarray | None:
    """(P, m) the columns with places and temperatures counted from their middle, or None: as they are.

    How much of a candidate is visible beside the declared model must not depend on where the coordinates begin, nor on
    how far from 20 °C the shop was.
    """
    if not regressor.shape.proportional or not set(regressor.driver.columns) & set(middle):
        return None
    return regressor.vectors({**columns, **{n: columns[n] - m for n, m in middle.items() if n in columns}})


@dataclass
class Scores:
    """Per bank entry and component: gain = drop of chi-square; visible = share not imitated; power = mean square shown.

    gain, visible, power : (K, C).  tail : (K, C) -log10 of the single-candidate p.  shapes : the K entries.
    """

    shapes: list[Regressor]
    gain: np.ndarray
    visible: np.ndarray
    tail: np.ndarray


class Scanner:
    """Prepared products of a bank with one set of rows; `scores(residual)` is then cheap."""

    def __init__(self, rows: Rows, shapes: list[Regressor], places=None, v=None, columns=None, wholes=None):
        """places : component numbers to score (default all); components that move alike need one number only.

        v : what `regressors` returns for the points of `rows`; else it is made from `columns`.  wholes : what `wholes`
        returns for them, or None.
        """
        self.rows, self.shapes = rows, shapes
        self.places = np.arange(rows.lever.shape[1]) if places is None else np.asarray(places)
        self.lever = rows.lever if places is None else np.ascontiguousarray(rows.lever[:, self.places])
        self.width = np.array([s.size for s in shapes], dtype=int)
        self.v = self.regressors(shapes, columns) if v is None else v
        self.first = np.cumsum(np.r_[0, self.width[:-1]]) if len(shapes) else np.zeros(0, int)
        self._denominators(wholes)
        self._null: tuple = (None, None)

    @staticmethod
    def wholes(shapes: list[Regressor], columns, middle, points=None) -> np.ndarray | None:
        """(K,) mean square of each entry's `whole` over that of the entry itself; None where nothing differs."""
        if not middle:
            return None
        if points is not None:  # none of these remembers
            columns = {n: x[points] for n, x in columns.items()}
        out = np.ones(len(shapes))
        for k, shape in enumerate(shapes):
            shifted = whole(shape, columns, middle)
            if shifted is not None:
                b = max(float((shape.vectors(columns) ** 2).mean()), 1e-300)
                out[k] = max(float((shifted**2).mean()) / b, 1e-12)
        return out

    @staticmethod
    def regressors(shapes: list[Regressor], columns, points=None) -> np.ndarray:
        """(sum of sizes, P) the driver columns of all entries at rms 1, for some `points` of the columns or all."""
        some = columns if points is None else {n: x[points] for n, x in columns.items()}
        vectors = []
        for shape in shapes:  # what remembers needs the rows between
            if shape.shape.memory and points is not None:
                vectors.append(shape.vectors(columns)[points])
            else:
                vectors.append(shape.vectors(some))
        count = len(next(iter(columns.values()))) if points is None else len(points)
        v = np.concatenate(vectors, axis=1).T if vectors else np.zeros((0, count))
        scale = np.sqrt((v**2).mean(axis=1, keepdims=True))
        return np.ascontiguousarray(v / np.where(scale > 0, scale, 1.0))

    def _denominators(self, wholes):
        rows = self.rows
        squares, crossed = rows.squares(self.lever), rows.crossed(self.lever)  # (P, C)
        components = self.lever.shape[1]
        total = (self.v**2) @ squares
        pairs = self.first[self.width == 2]
        cross = np.zeros((len(pairs), components))
        if len(pairs):
            cross = (self.v[pairs] * self.v[pairs + 1]) @ squares
        if crossed is not None:
            a, b, value = crossed
            for k in range(0, len(self.v), CHUNK):
                part = self.v[k : k + CHUNK]
                total[k : k + CHUNK] += 2 * ((part[:, a] * part[:, b]) @ value)
            for k in range(0, len(pairs), CHUNK):
                one, two = self.v[pairs[k : k + CHUNK]], self.v[pairs[k : k + CHUNK] + 1]
                cross[k : k + CHUNK] += (one[:, a] * two[:, b] + one[:, b] * two[:, a]) @ value
        shown = total.copy()
        for c in range(components):
            a = rows.gathered(np.ascontiguousarray(self.lever[:, c]))  # (P, m)
            projected = self.v @ a
            shown[:, c] -= (projected**2).sum(axis=1)
            if len(pairs):
                cross[:, c] -= (projected[pairs] * projected[pairs + 1]).sum(axis=1)
        self.shown = np.maximum(shown, 0.0)
        share = self.shown / np.where(total > 0, total, 1.0)
        self.cross = cross
        self.pairs = pairs
        self.share = share
        one = self.first
        self.visible = share[one].copy()
        two = self.width == 2
        self.visible[two] = np.minimum(share[pairs], share[pairs + 1])
        if wholes is not None:
            self.visible = np.minimum(self.visible / wholes[:, None], 1.0)
        largest = total.max(initial=0.0)
        self.valid = (self.visible > rows.settings.scan_visible) & (total[one] > 1e-10 * largest)

    def gains(self, h) -> np.ndarray:
        """(K, C) drop of chi-square for residuals gathered as h (P, C), already projected."""
        num = self.v @ h
        gain = np.where(self.valid, num[self.first] ** 2 / np.where(self.valid, self.shown[self.first], 1.0), 0.0)
        if len(self.pairs):
            p = self.pairs
            a, d, b = self.shown[p], self.shown[p + 1], self.cross
            det = a * d - b * b
            ok = det > self.rows.settings.pair_differs * a * d
            n1, n2 = num[p], num[p + 1]
            both = (d * n1**2 - 2 * b * n1 * n2 + a * n2**2) / np.where(ok, det, 1.0)
            two = self.width == 2
            gain[two] = np.where(ok & self.valid[two], both, gain[two])
        return gain

    def scores(self, residual=None) -> Scores:
        """Return the drop of chi-square of every candidate, for the residual of the rows or another one (R,)."""
        rows = self.rows
        r = rows.residual if residual is None else residual
        r = r - rows.ortho @ (rows.ortho.T @ r)
        gain = self.gains(rows.gather(self.lever * rows.pulled(r)[:, None]))
        tail = np.where((self.width == 2)[:, None], log_tail(gain, 2), log_tail(gain, 1))
        return Scores(self.shapes, gain, self.visible, np.where(self.valid, tail, 0.0))

    def null_maxima(self, signs, batch: int = 32) -> np.ndarray:
        """(B,) largest tail over all candidates under sign flips (B, R) of the residuals; computed once.

        Gains are counted in the noise that the flipped residuals show (`free_of_scale`): what the best of many
        candidates took from the residuals is missing in the noise that a fit with it states.
        """
        if self._null[0] is not signs:
            self._null = signs, self._null_maxima(signs, batch)
        return self._null[1]

    def _null_maxima(self, signs, batch: int) -> np.ndarray:
        rows = self.rows
        p, components = len(rows.start), self.lever.shape[1]
        v = self.v.astype(np.float32)
        one = self.first
        inverse = np.where(self.valid, 1.0 / np.where(self.valid, self.shown[one], 1.0), 0.0).astype(np.float32)
        single = self.width == 1
        pairs = self.pairs
        a, d, b = self.shown[pairs], self.shown[pairs + 1], self.cross
        det = a * d - b * b
        ok = (det > rows.settings.pair_differs * a * d) & self.valid[self.width == 2]
        scale = np.where(ok, 1.0 / np.where(ok, det, 1.0), 0.0)
        ca, cb, cd = (x.astype(np.float32) for x in (a * scale, 2 * b * scale, d * scale))
        out = np.empty(len(signs))
        flipped = rows.flipped(signs)
        noise = np.maximum((flipped**2).sum(axis=1), 1e-300) / max(rows.used - rows.ortho.shape[1], 1)
        for begin in range(0, len(signs), batch):
            block = flipped[begin : begin + batch]
            h = np.empty((p, len(block), components), dtype=np.float32)
            for j, r in enumerate(block):
                h[:, j] = rows.gather(self.lever * rows.pulled(r)[:, None])
            best1 = np.zeros(len(block))
            best2 = np.zeros(len(block))
            for k in range(0, len(v), CHUNK * 2):
                num = (v[k : k + CHUNK * 2] @ h.reshape(p, -1)).reshape(-1, len(block), components)
                here = np.flatnonzero(single & (one >= k) & (one < k + CHUNK * 2))
                if len(here):
                    x = num[one[here] - k]
                    best1 = np.maximum(best1, (x * x * inverse[here][:, None, :]).max(axis=(0, 2)))
                inside = np.flatnonzero((pairs >= k) & (pairs + 1 < min(k + CHUNK * 2, len(v))))
                if len(inside):
                    n1, n2 = num[pairs[inside] - k], num[pairs[inside] + 1 - k]
                    x = cd[inside][:, None] * n1**2 - cb[inside][:, None] * n1 * n2 + ca[inside][:, None] * n2**2
                    best2 = np.maximum(best2, x.max(axis=(0, 2)))
            unit = noise[begin : begin + len(block)]
            out[begin : begin + len(block)] = np.maximum(log_tail(best1 / unit, 1), log_tail(best2 / unit, 2))
        return out


def free_of_scale(gain, chi2: float, dof: float, dims: int = 1):
    """A gain (drop of chi-square) of `dims` coefficients in units of the noise that a fit without it shows, as the F
    statistic is.

    chi2, dof : of the fit with it.
    """
    return gain * (dof + dims) / np.maximum(chi2 + gain, 1e-300)


def exact_gain(rows: Rows, component: int, vectors) -> tuple[float, np.ndarray, float]:
    """(drop of chi-square, coefficients, visible share) of one component x driver columns (P, m), projected exactly."""
    across, _, residual, _ = rows.per_point(component)
    inner = rows.inner(component, vectors)
    shown = vectors.T @ across
    gram = inner - shown @ shown.T
    right = vectors.T @ residual
    total = np.diag(inner)
    size = np.sqrt(np.maximum(np.diag(gram), 1e-14 * np.maximum(total, 1e-300)))
    solution, *_ = np.linalg.lstsq(gram / np.outer(size, size), right / size, rcond=1e-9)
    coefficients = solution / size
    share = float((np.diag(gram) / np.where(total > 0, total, 1.0)).min())
    return float(right @ coefficients), coefficients, share
