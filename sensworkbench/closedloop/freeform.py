# SPDX-License-Identifier: LGPL-2.1-or-later
"""Smooth free forms: a component driven by any smooth function of one or two columns.

They answer two questions: does the residual hold structure at all (and on which columns), and does a named shape leave
something on the same component and columns?  A free form locates; it never names.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np

from ..core.driver import Driver
from ..core.shapes import Regressor, Shape
from .bank import log_tail, useful_columns
from .scan import Rows


@dataclass(frozen=True)
class FreeForm:
    """A free form of one or two columns: `columns`, vectors (P, m), `orders` per vector, `domains` per column."""

    columns: tuple[str, ...]
    vectors: np.ndarray
    orders: tuple[tuple[int, ...], ...]
    domains: tuple[tuple[float, float, int], ...]


def free_form(columns, names, degree: int, domains=None) -> FreeForm:
    """Legendre products of the named columns up to a total degree; columns of few levels get fewer orders.

    domains : (lowest, highest, levels) per column, from the readings it was made for (default: these); beyond them a
    free form is held at its edge, since it knows nothing there.
    """
    names = tuple(names)
    if domains is None:
        domains = tuple(
            (float(np.min(columns[n])), float(np.max(columns[n])), int(len(np.unique(columns[n])))) for n in names
        )
    tables, limits = [], []
    for name, (low, high, levels) in zip(names, domains):
        limits.append(min(degree, levels - 1))
        x = np.clip((2 * np.asarray(columns[name], dtype=float) - low - high) / (high - low), -1, 1)
        tables.append(np.polynomial.legendre.legvander(x, limits[-1]))
    orders, vectors = [], []
    for combination in itertools.product(*[range(n + 1) for n in limits]):
        if 0 < sum(combination) <= degree:
            orders.append(combination)
            product = np.ones(len(tables[0]))
            for table, order in zip(tables, combination):
                product = product * table[:, order]
            vectors.append(product)
    return FreeForm(names, np.stack(vectors, axis=1), tuple(orders), tuple(tuple(d) for d in domains))


class LegendreForm(Shape):
    """Legendre products of the driver's columns (`free_form`): replaces a shape during a trace; never stored."""

    name = "free form"
    free = True
    scanned = False

    def __init__(self, degree: int, domains, count: int):
        super().__init__()
        self.degree, self.domains, self.count = degree, domains, count

    @property
    def size(self) -> int:
        return self.count

    def vectors(self, driver, columns, where=""):
        return free_form(columns, driver.columns, self.degree, self.domains).vectors


def free_regressor(names, columns, degree: int) -> Regressor:
    """Return a free form of these columns that can be fitted together with effects (never a name)."""
    driver = Driver(tuple(names))
    form = free_form(columns, driver.columns, degree)
    return Regressor(driver, LegendreForm(degree, form.domains, form.vectors.shape[1]))


def subspace_gain(rows: Rows, component: int, vectors) -> tuple[float, int]:
    """(drop of chi-square, dimensions) when a component driven by `vectors` (P, m) joins the weighted model."""
    x = rows.white(rows.lever[:, [component]] * vectors[rows.point])
    total = np.sqrt((x**2).sum(axis=0))
    good = total > 1e-12 * max(float(total.max(initial=0.0)), 1e-300)
    if not good.any():
        return 0.0, 0
    x = x[:, good] / total[good]
    x = x - rows.ortho @ (rows.ortho.T @ x)
    values, vectors_ = np.linalg.eigh(x.T @ x)
    keep = values > rows.settings.free_kept
    if not keep.any():
        return 0.0, 0
    basis = vectors_[:, keep] / np.sqrt(values[keep])
    score = basis.T @ (x.T @ rows.residual)
    return float(score @ score), int(keep.sum())


def normal_score(gain: float, dims: int) -> float:
    """Wilson-Hilferty: chi-square on `dims` degrees of freedom as standard deviations of a normal variate."""
    if dims == 0:
        return 0.0
    spread = 2 / (9 * dims)
    return ((gain / dims) ** (1 / 3) - (1 - spread)) / spread**0.5


def f_score(gain: float, dims: int, chi2: float, dof: float) -> float:
    """A gain of `dims` coefficients beside a chi-square that is left, on `dof` degrees of freedom, as standard
    deviations of a normal variate: Wilson-Hilferty for the F distribution, good from 3 degrees of freedom on.
    """
    if dims == 0:
        return 0.0
    ratio = (gain / dims) / max(chi2 / dof, 1e-300)
    own, other = 2 / (9 * dims), 2 / (9 * dof)
    root = ratio ** (1 / 3)
    return ((1 - other) * root - (1 - own)) / (own + other * root**2) ** 0.5


def normal_tail(gain: float, dims: int) -> float:
    """-log10 of the chi-square tail on `dims` degrees of freedom."""
    if dims == 2:
        return float(log_tail(np.array(gain), 2))
    z = max(normal_score(gain, dims), 0.0)
    return float(log_tail(np.array(z * z), 1))


@dataclass(frozen=True)
class FreeFormTest:
    """What free forms of any two columns find: the best `component` index, `columns`, gain, dims and family-wise p."""

    component: int
    columns: tuple[str, ...]
    gain: float
    dims: int
    p: float
    excess: float  # gain beyond what noise alone gives: chi-square units
    score: float = 0.0  # as standard deviations of a normal variate

    def size(self, used: int) -> float:
        """rms per reading in units of its noise."""
        return float(np.sqrt(max(self.excess, 0.0) / used))


class FreeScan:
    """Free forms of every pair of columns on every component, whitened once; then any residual is one product.

    The forms share their functions of one column: each different function is a column of `table` (P, n), and a form is
    a set of them with a small matrix that makes them orthonormal beside the model.
    """

    def __init__(self, rows: Rows, readings, names=None, components=None):
        self.rows = rows
        self.names = names if names is not None else useful_columns(readings)
        self.components = range(rows.lever.shape[1]) if components is None else components
        self.sets = [(a,) for a in self.names] + list(itertools.combinations(self.names, 2))
        known: dict[tuple, int] = {}
        table, self.places = [], []
        for names_ in self.sets:
            form = free_form(readings.columns, names_, rows.settings.free_more)
            keys = [tuple((n, o) for n, o in zip(names_, orders) if o) for orders in form.orders]
            for key, vector in zip(keys, form.vectors.T):
                if key not in known:
                    known[key] = len(table)
                    table.append(vector)
            self.places.append(np.array([known[key] for key in keys], dtype=int))
        self.table = np.stack(table, axis=1) if table else np.zeros((len(rows.start), 0))
        self.roots, self.owner = [], []
        for c in self.components:
            shown = self.table.T @ rows.per_point(c)[0]
            for k, place in enumerate(self.places):
                inner = rows.inner(c, self.table[:, place])
                size = np.sqrt(np.maximum(np.diag(inner), 1e-300))
                beside = inner - shown[place] @ shown[place].T
                values, vectors = np.linalg.eigh(beside / np.outer(size, size))
                keep = values > rows.settings.free_shown
                if keep.any() and size.max() > 1e-9:
                    self.roots.append((vectors[:, keep] / np.sqrt(values[keep])) / size[:, None])
                    self.owner.append((k, c, int(keep.sum())))

    def _gains(self, residuals) -> np.ndarray:
        """residuals (n, R) of n cases, projected.  Returns (n, entries) drops of chi-square."""
        rows, out = self.rows, np.empty((len(residuals), len(self.owner)))
        pulled = [rows.pulled(r) for r in residuals]
        for c in self.components:
            h = np.stack([rows.gather(rows.lever[:, c] * r) for r in pulled])
            across = h @ self.table  # (n, functions)
            for i, (k, of, _) in enumerate(self.owner):
                if of == c:
                    out[:, i] = ((across[:, self.places[k]] @ self.roots[i]) ** 2).sum(axis=1)
        return out

    def _tails(self, gains) -> np.ndarray:
        dims = np.array([d for _, _, d in self.owner], dtype=float)
        # Wilson-Hilferty: the cube root of chi-square over its dimension is nearly normal
        spread = 2 / (9 * dims)
        return ((gains / dims) ** (1 / 3) - (1 - spread)) / np.sqrt(spread)

    def best(self, signs) -> tuple[list[FreeFormTest], np.ndarray]:
        """Entries by strength, strongest first (top 40), with family-wise p from sign flips; and the null maxima."""
        rows = self.rows
        if not self.owner:
            return [], np.zeros(0)
        null = self._tails(self._gains(rows.flipped(signs))).max(axis=1)
        gains = self._gains(rows.residual[None])[0]
        tails = self._tails(gains[None])[0]
        found = []
        for i in np.argsort(-tails)[:40]:
            k, c, dims = self.owner[i]
            p = float((1 + np.count_nonzero(null >= tails[i])) / (len(null) + 1))
            excess = float(gains[i] - dims)
            found.append(FreeFormTest(c, self.sets[k], float(gains[i]), dims, p, excess, float(tails[i])))
        return found, null
