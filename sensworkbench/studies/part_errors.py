# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine's errors along a path, as columns: what each error and effect moves the cutting point by.

Fitted machines have known functions and effects.  Of a machine with tolerances only, each error of an axis line, of
spindle and workpiece, each effect and each source has one unknown value for the whole part.  Each error motion of a
joint is an unknown smooth function of its position, X = mu + sigma/sqrt(m) Σ_k (a_k cos k pi s + b_k sin k pi s),
k = 1..m, s = 0..1 over the travel, m its declared degree: its variance is that of the tolerance at every position, as
in a sensitivity study, and its straightness is seen by a feature as one.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from statistics import NormalDist

import numpy as np

from ..core.distributions import Tolerance, moments
from ..core.fitted import DECLARED, EFFECT, FittedModel
from ..core.machine import Machine
from ..core.shapes import to_domain
from ..core.synthesis import omega
from ..core.toolpath import ToolPath
from ..core.workspace import error_table

CHUNK = 16_384  # points at a time
MOST_TERMS = 12  # of an unknown function


def chunks(rows, size: int = CHUNK):
    """Pieces of an array of row numbers."""
    for begin in range(0, len(rows), size):
        yield rows[begin : begin + size]


@dataclass(frozen=True)
class _Function:
    """A fitted quantity along the path.  values : rows -> (k, m) what its coefficients (m,) multiply; u : (m,)."""

    label: str
    symbol: str
    values: Callable
    coefficients: np.ndarray
    u: np.ndarray
    constant: bool = False


class FittedErrors:
    """Errors of a fitted machine, with its enabled effects, without the alignment of the set-up that measured it.

    labels, owners : (K,) symbol or name of effect, and body.  known_u : whether uncertainties are known.
    """

    tolerances = False

    def __init__(self, machine: Machine, path: ToolPath):
        self.machine, self.path = machine, path
        fitted = machine.fitted or FittedModel()
        functions = [self._declared(fitted, s) for s in fitted.symbols]
        for effect in machine.effects:
            if effect.enabled and effect.coefficients:
                values = effect.shape.vectors(effect.driver, path.columns, f"effect {effect.name!r}")
                u = [np.nan if v is None else v for v in effect.u or (None,) * len(effect.coefficients)]
                of = _Function(
                    effect.name, effect.component, values.__getitem__, np.array(effect.coefficients), np.array(u)
                )
                functions.append(of)
        self.functions = functions
        self.labels = tuple(f.label for f in functions)
        self.owners = tuple(machine.component(f.symbol).body for f in functions)
        self.symbols = tuple(dict.fromkeys(f.symbol for f in functions))
        self._column = [self.symbols.index(f.symbol) for f in functions]
        u = np.concatenate([f.u for f in functions]) if functions else np.empty(0)
        self.factor = self._factor(fitted, np.where(np.isfinite(u), u, 0.0))
        self.known_u = bool(np.isfinite(u).any()) or fitted.uncertainty is not None

    def _factor(self, fitted: FittedModel, u: np.ndarray) -> np.ndarray:
        """(N, r) of the covariance of the coefficients, factor times its transpose: that of the fit where the machine
        states it, and independent uncertainties of the others."""
        known = fitted.uncertainty
        if known is None:
            return np.diag(u)
        matrix, at, constants = known.matrix(), {}, {}
        for i, key in enumerate(known.parameters):
            if key[0] == DECLARED or (key[0] == EFFECT and len(key) == 4):
                at[key[1], key[-1]] = constants[key[1]] = i
        rows = [
            constants.get(f.label) if f.constant else at.get((f.label, j))
            for f in self.functions
            for j in range(len(f.coefficients))
        ]
        own = [i for i, row in enumerate(rows) if row is None]
        out = np.zeros((len(rows), matrix.shape[1] + len(own)))
        for i, row in enumerate(rows):
            if row is not None:
                out[i, : matrix.shape[1]] = matrix[row]
        out[own, matrix.shape[1] + np.arange(len(own))] = u[own]
        return out

    def _declared(self, fitted, symbol: str) -> _Function:
        """A fitted error: Legendre polynomials of its joint's position, or a constant."""
        series = fitted.series.get(symbol)
        if series is None:
            constant = fitted.constants[symbol]
            u = np.nan if constant.u is None else constant.u
            return _Function(
                symbol, symbol, lambda rows: np.ones((len(rows), 1)), np.array([constant.value]), np.array([u]), True
            )
        body = self.machine.component(symbol).body
        joint, column = self.machine.joint(body), self.machine.names.index(body)
        degree = len(series.coefficients) - 1

        def values(rows):
            position = to_domain(joint.to_shown(self.path.q[rows, column]), series.domain)
            return np.polynomial.legendre.legvander(position, degree)

        u = [np.nan if v is None else v for v in series.u] or [np.nan] * (degree + 1)
        return _Function(symbol, symbol, values, np.array(series.coefficients), np.array(u, dtype=float))

    def _omega(self, rows) -> np.ndarray:
        return omega(self.machine, self.symbols, self.path.q[rows], self.path.contact[rows])

    def error(self, rows) -> np.ndarray:
        """(k, 3) mm at the points `rows`, actual less commanded."""
        values = np.zeros((len(rows), len(self.symbols)))
        for j, f in zip(self._column, self.functions):
            values[:, j] += f.values(rows) @ f.coefficients
        return np.einsum("pan,pn->pa", self._omega(rows), values)

    def contributions(self, rows) -> np.ndarray:
        """(k, 3, K) mm of each label."""
        matrix = self._omega(rows)
        out = np.empty((len(rows), 3, len(self.functions)))
        for k, (j, f) in enumerate(zip(self._column, self.functions)):
            out[:, :, k] = matrix[:, :, j] * (f.values(rows) @ f.coefficients)[:, None]
        return out

    def parameters(self, rows) -> np.ndarray:
        """(k, 3, N) mm per unit of each fitted coefficient, in the order of `factor` (N, r)."""
        matrix = self._omega(rows)
        parts = [matrix[:, :, j, None] * f.values(rows)[:, None, :] for j, f in zip(self._column, self.functions)]
        return np.concatenate(parts, axis=2)


class TolerancedErrors:
    """Errors of a machine of which only tolerances are known; see the head of this module.

    labels, owners : (K,); of : (C,) label of each column; variance : (C,) of its factor.
    """

    tolerances = True

    def __init__(self, machine: Machine, path: ToolPath):
        self.machine, self.path = machine, path
        table = error_table(machine)
        self.table, self.symbols = table, table.symbols
        law = moments(table.laws)
        self.law, self.labels, self.owners = law, table.labels, table.owners
        self.terms = [self._terms(c, v) for c, v in zip(table.columns, law.var)]
        count = [2 * m if m else 1 for m in self.terms]
        self.of = np.repeat(np.arange(len(count)), count)
        each = np.repeat([1.0 / m if m else 1.0 for m in self.terms], count)
        self.variance = law.var[self.of] * each
        self.without_extent = table.without_extent

    def _terms(self, symbol: str, variance: float) -> int:
        """Number of waves of an unknown function; 0 where there is one value for the whole part."""
        if not symbol or variance == 0:
            return 0
        c = self.machine.component(symbol)
        if c.line or c.body in ("T", "W"):
            return 0
        return min(self.machine.declared_degree(symbol), MOST_TERMS)

    def _mixed(self, rows) -> np.ndarray:
        return self.table.mixed(omega(self.machine, self.symbols, self.path.q[rows], self.path.contact[rows]))

    def columns(self, rows) -> np.ndarray:
        """(k, 3, C) mm (per factor of unit variance times its standard deviation: see `variance`)."""
        matrix = self._mixed(rows)
        out = np.empty((len(rows), 3, len(self.of)))
        at, waves = 0, {}
        for i, terms in enumerate(self.terms):
            if not terms:
                out[:, :, at] = matrix[:, :, i]
                at += 1
                continue
            body = self.machine.component(self.table.columns[i]).body
            if (body, terms) not in waves:
                j = self.machine.names.index(body)
                low, high = self.machine.joints[j].span
                angle = np.pi * np.arange(1, terms + 1) * ((self.path.q[rows, j] - low) / (high - low))[:, None]
                waves[body, terms] = np.concatenate([np.cos(angle), np.sin(angle)], axis=1)
            out[:, :, at : at + 2 * terms] = matrix[:, :, i, None] * waves[body, terms][:, None, :]
            at += 2 * terms
        return out

    def means(self, rows) -> np.ndarray:
        """(k, 3, K) mm by the mean of each label."""
        return self._mixed(rows) * self.law.mean

    def pointwise(self, rows) -> tuple[np.ndarray, np.ndarray]:
        """(E, V): (k,) exact mean and variance of the squared length of the error, mm² and mm⁴."""
        w, law = self._mixed(rows), self.law
        squared = np.einsum("pan,pan->pn", w, w)
        m = np.einsum("pan,n,pbn->pab", w, law.var, w, optimize=True)
        middle = w @ law.mean
        b = 2 * np.einsum("pa,pan->pn", middle, w)
        mean = np.trace(m, axis1=1, axis2=2) + (middle**2).sum(axis=1)
        variance = squared**2 @ (law.fourth - 3 * law.var**2) + 2 * (m**2).sum(axis=(1, 2))
        variance += (b**2) @ law.var + 2 * (b * squared) @ law.third
        return mean, np.maximum(variance, 0.0)

    def draws(self, number: int, seed: int = 0) -> np.ndarray:
        """(number, C) factors of the columns, stratified, without their means; the waves are normal."""
        rng = np.random.default_rng(seed)
        out = np.empty((number, len(self.of)))
        for c, label in enumerate(self.of):
            level = (rng.permutation(number) + 0.5) / number
            if self.terms[label]:
                out[:, c] = normal_levels(level) * np.sqrt(self.variance[c])
            else:
                out[:, c] = quantiles(self.table.laws[label], level, rng) - self.law.mean[label]
        return out

    def values(self, number: int, seed: int = 1) -> np.ndarray:
        """(number, K) independent values of each label at one position."""
        rng = np.random.default_rng(seed)
        laws = self.table.laws
        return np.stack([quantiles(law, rng.permutation(number) / number + 0.5 / number, rng) for law in laws], axis=1)


def normal_levels(level) -> np.ndarray:
    """Quantiles of the standard normal law."""
    inverse = NormalDist().inv_cdf
    return np.array([inverse(float(v)) for v in level])


def quantiles(law: Tolerance, level, rng) -> np.ndarray:
    """Values of a tolerance's law at the levels (n,) in (0, 1)."""
    middle, half = (law.lower + law.upper) / 2, (law.upper - law.lower) / 2
    if law.distribution == "point" or half == 0:
        return np.full(len(level), middle)
    if law.distribution == "uniform":
        return middle + half * (2 * level - 1)
    if law.distribution == "triangular":
        far = 1 - np.sqrt(2 * np.minimum(level, 1 - level))
        return middle + half * np.sign(level - 0.5) * far
    if law.distribution == "u_shaped":
        return middle - half * np.cos(np.pi * level)
    if law.distribution == "normal":
        return middle + (law.sigma or half / 3) * normal_levels(level)
    sigma, normal = law.sigma or half / 2, NormalDist()
    low, high = normal.cdf(-half / sigma), normal.cdf(half / sigma)
    return middle + sigma * normal_levels(low + (high - low) * level)
