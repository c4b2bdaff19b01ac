# SPDX-License-Identifier: LGPL-2.1-or-later
"""Estimates of the final model of a trace with their uncertainty: coefficients, parameters, amplitudes, predictions.

Parameters of shapes that were searched for are profiled: their derivatives stand in the Jacobian beside the
coefficients, so that each carries the uncertainty of the others.  A threshold has no derivative: the chi-square of the
values beside it weighs them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ..core.effects import Effect
from ..core.errors import component
from ..core.fitted import ALIGNMENT, DECLARED, EFFECT, RUN, TOOL, OtherName, Uncertainty, uncertainty_of
from ..core.parameters import Levels
from ..core.propagation import propagated
from ..core.synthesis import omega
from . import design
from .effects import to_effect
from .fit import Fit
from .problem import State
from .scan import exact_gain
from .search import ScoredTerm
from .sources import common_sources
from .uncertainty import Spread, expected, settled, spread, triangle, with_effects

ROUNDS = 3  # of steps of the derivatives: as wide as the uncertainty that they give
MOST_OTHERS = 4  # names beside one effect that count
BESIDE = 40  # levels to either side of a threshold that are weighed


@dataclass(frozen=True)
class Estimates:
    """state : with the names that are kept.  full : fit of `model`, its open directions settled (see `settled`)."""

    state: State
    full: Fit
    model: tuple[ScoredTerm, ...]

    @property
    def _columns(self):
        return self.state.problem.readings.columns

    @cached_property
    def searched(self) -> list[tuple[int, str]]:
        """(number in the model, parameter) of each that was searched for, thresholds left out."""
        return [
            (i, key)
            for i, c in enumerate(self.model)
            for key in c.shape.fitted
            if not isinstance(c.shape.parameters[key].search, Levels)
        ]

    @cached_property
    def blocks(self) -> list[slice]:
        """The coefficients of each member of the model."""
        at, out = len(self.full.design.terms), []
        for c in self.model:
            out.append(slice(at, at + c.shape.size))
            at += c.shape.size
        return out

    @cached_property
    def _steps_and_spread(self) -> tuple[dict, Spread]:
        problem, first = self.state.problem, len(self.full.coefficients)
        effects = problem.columns_of(self.model)
        prior = expected(problem.machine, problem.design)
        steps, widths = {}, []
        for i, key in self.searched:
            c = self.model[i]
            value = c.shape.values[key]
            span = float(np.ptp(c.driver.values(self._columns)))
            steps[i, key] = c.shape.parameters[key].search.step(value, span)
            widths.append(max(abs(value), 1e-9))
        found = None
        for _ in range(ROUNDS if self.searched else 1):
            slopes = [self._slope(i, key, steps[i, key]) for i, key in self.searched]
            extra = np.stack(slopes, axis=1) if slopes else None
            wide = with_effects(prior, self.full.extra, widths)
            known = None if found is None else found.noise
            found = spread(self.full, problem.readings, effects, extra, wide, known, common_sources(problem.readings))
            for j, (i, key) in enumerate(self.searched):
                u = float(np.sqrt((found.factor[first + j] ** 2).sum()))
                c = self.model[i]
                usual = c.shape.parameters[key].search.step(
                    c.shape.values[key], float(np.ptp(c.driver.values(self._columns)))
                )
                steps[i, key] = float(np.clip(u, 0.25 * usual, 10 * usual))
        return steps, found

    def _slope(self, i: int, key: str, step: float) -> np.ndarray:
        """(R,) derivative of the readings by a parameter."""
        c, problem = self.model[i], self.state.problem
        motion = c.regressor.slope(self._columns, c.coefficients, key, step)
        return problem.design.lever[:, c.index] * motion[problem.readings.point]

    @property
    def spread(self) -> Spread:
        """Covariance of terms, coefficients of effects, and what was searched for (`searched`), in this order."""
        return self._steps_and_spread[1]

    @cached_property
    def thresholds(self) -> dict[tuple[int, str], tuple[float, np.ndarray]]:
        """(number, parameter) of a threshold -> (its standard uncertainty, (m,) what it adds to the coefficients').

        The values between which it may lie are weighed by exp(-chi-square / 2); within each gap any is as good.
        """
        out = {}
        for i, c in enumerate(self.model):
            for key in c.shape.fitted:
                if isinstance(c.shape.parameters[key].search, Levels):
                    out[i, key] = self._threshold(i, c, key)
        return out

    def _threshold(self, i: int, c: ScoredTerm, key: str) -> tuple[float, np.ndarray]:
        others = [m for j, m in enumerate(self.model) if j != i]
        rows = self.state.rows_with(self.full, others)
        values = np.unique(c.driver.values(self._columns))
        at = int(np.searchsorted(values, c.shape.values[key]))
        low, high = max(at - BESIDE, 1), min(at + BESIDE, len(values) - 1)
        middle, width, gain, found = [], [], [], []
        for k in range(low, high + 1):
            middle.append((values[k - 1] + values[k]) / 2)
            width.append(values[k] - values[k - 1])
            vectors = c.regressor.having(**{key: float(middle[-1])}).vectors(self._columns)
            g, coefficients, _ = exact_gain(rows, c.index, vectors)
            gain.append(g)
            found.append(coefficients)
        middle, width, gain, found = map(np.array, (middle, width, gain, found))
        weight = width * np.exp((gain - gain.max()) / 2)
        weight = weight / weight.sum()
        about = c.shape.values[key]
        u = float(np.sqrt(weight @ ((middle - about) ** 2 + width**2 / 12)))
        best = found[int(np.argmax(gain))]
        return u, np.sqrt(weight @ (found - best) ** 2)

    # -- what is said of effects ---------------------------------------------------------------------------------------
    def coefficient_covariance(self, i: int) -> np.ndarray:
        """(m, m) covariance of the coefficients of a member of the model."""
        factor = self.spread.factor[self.blocks[i]]
        out = factor @ factor.T
        for (j, _), (_, more) in self.thresholds.items():
            if j == i:
                out = out + np.diag(more**2)
        return out

    def parameter_u(self, i: int) -> dict[str, float]:
        """parameter -> standard uncertainty, of those of a member of the model that were searched for."""
        first = len(self.full.coefficients)
        out = {
            key: float(np.sqrt((self.spread.factor[first + j] ** 2).sum()))
            for j, (k, key) in enumerate(self.searched)
            if k == i
        }
        return out | {key: u for (k, key), (u, _) in self.thresholds.items() if k == i}

    def amplitude(self, i: int) -> tuple[float, float]:
        """(3-D rms over the points, its standard uncertainty) of a member of the model, mm."""
        c, problem = self.model[i], self.state.problem
        column = omega(problem.machine, [c.symbol], problem.readings.q, problem.readings.tool_offset)[:, :, 0]
        weight = (column**2).sum(axis=1)
        vectors = c.vectors(self._columns)
        motion = vectors @ c.coefficients
        size = float(np.sqrt(weight @ motion**2 / len(motion)))
        if size == 0:
            return 0.0, 0.0
        first, steps = len(self.full.coefficients), self._steps_and_spread[0]
        rows, slopes = [*range(self.blocks[i].start, self.blocks[i].stop)], [vectors]
        for j, (k, key) in enumerate(self.searched):
            if k == i:
                rows.append(first + j)
                slopes.append(c.regressor.slope(self._columns, c.coefficients, key, steps[k, key])[:, None])
        gradient = (weight * motion) @ np.concatenate(slopes, axis=1) / (size * len(motion))
        return size, float(propagated(gradient, self.spread.factor[rows]))

    # -- what a machine keeps ------------------------------------------------------------------------------------------
    def stored(self, effects: Sequence[Effect], around) -> Uncertainty:
        """The uncertainty of the machine that holds `effects`, one for each member of the model.

        around : for each named effect, the rivals with their terms (see `rivals.rivals`).
        """
        keys, maps = self._keys(effects)
        others = [o for i, near in enumerate(around) for o in self._others(i, near, len(keys), maps)]
        whole = triangle(
            np.concatenate([self._expanded(self.spread.factor, keys, maps), self._apart(keys, effects)], axis=1)
        )
        return uncertainty_of(keys, whole, others)

    def parts(self, effects: Sequence[Effect], others: Sequence[OtherName]) -> dict[str, Uncertainty]:
        """source -> the part of the uncertainty that it makes; see `sources.budget`.  others : of `stored`."""
        keys, maps = self._keys(effects)
        found = self.spread
        alone = self._set_up_known
        out = {
            "noise": np.concatenate([self._expanded(alone, keys, maps), self._apart(keys, effects)], axis=1),
            "noise and alignment": np.concatenate(
                [self._expanded(found.data, keys, maps), self._apart(keys, effects)], axis=1
            ),
            **{name: self._expanded(c[:, None], keys, maps) for name, c in found.common.items()},
            "undetermined": self._expanded(found.open, keys, maps),
        }
        found = {name: uncertainty_of(keys, factor) for name, factor in out.items()}
        return found | {"rivals": uncertainty_of(keys, np.zeros((len(keys), 1)), others)}

    @cached_property
    def _set_up_known(self) -> np.ndarray:
        """(n, r) factor by the noise alone, if alignment and offsets of runs and tools were known."""
        problem, found, terms = self.state.problem, self.spread, self.full.design.terms
        keep = np.array([t.group == DECLARED for t in terms])
        design_ = replace(self.full.design, matrix=self.full.design.matrix * keep)
        slopes = [self._slope(i, key, self._steps_and_spread[0][i, key]) for i, key in self.searched]
        extra = np.stack(slopes, axis=1) if slopes else None
        full = replace(self.full, design=design_)
        known = spread(full, problem.readings, problem.columns_of(self.model), extra, None, found.noise)
        return known.data

    def _keys(self, effects: Sequence[Effect]) -> tuple[list[tuple], list[np.ndarray]]:
        """(keys of all parameters as a machine keeps them, maps from those of the fit: terms, then each effect's)."""
        count = len(self.full.design.terms)
        keys, maps = [_key(t) for t in self.full.design.terms], [np.eye(count)]
        for c, effect in zip(self.model, effects):
            wide = np.stack([np.asarray(c.shape.stored(e, np.eye(len(e)))[1]) for e in np.eye(c.shape.size)], axis=1)
            keys += [(EFFECT, effect.name, effect.component, j) for j in range(len(wide))]
            maps.append(wide)
        keys += [(EFFECT, effects[i].name, key) for i, key in (*self.searched, *self.thresholds)]
        return keys, maps

    def _expanded(self, factor, keys, maps) -> np.ndarray:
        """(len(keys), k) rows of a machine's parameters, of a factor (n, k) of those of the fit."""
        first, count = len(self.full.coefficients), len(self.full.design.terms)
        rows = [m @ factor[s] for m, s in zip(maps, [slice(0, count), *self.blocks])]
        rows.append(factor[first : first + len(self.searched)])
        whole = np.concatenate(rows)
        return np.concatenate([whole, np.zeros((len(keys) - len(whole), factor.shape[1]))])

    def _apart(self, keys, effects) -> np.ndarray:
        """(len(keys), m) what thresholds add, each independent."""
        at = {key: n for n, key in enumerate(keys)}
        more = []
        for (i, key), (u, extra) in self.thresholds.items():
            own = effects[i]
            more.append((at[EFFECT, own.name, key], u))
            more += [(at[EFFECT, own.name, own.component, j], v) for j, v in enumerate(extra) if v > 0]
        out = np.zeros((len(keys), len(more)))
        for column, (n, value) in enumerate(more):
            out[n, column] = value
        return out

    def term_u(self, known: Uncertainty) -> np.ndarray:
        """(terms,) standard uncertainty of each, the choice among names included; NaN where it is not determined."""
        count = len(self.full.design.terms)
        more = sum((o.weight * np.array(o.changes[:count]) ** 2 for o in known.others), np.zeros(count))
        return np.sqrt(self.spread.u[:count] ** 2 + more)

    def weights(self, i: int, around) -> list[tuple[ScoredTerm, float]]:
        """(rival, its probability) of the most probable rivals of a named effect.

        Odds are exp(-(loss of chi-square + difference of the preferences) / 2); see `prior`.
        """
        own = self.model[i]
        odds = [
            (c, float(np.exp(-(max(r.loss, 0.0) + max(c.handicap - own.handicap, 0.0)) / 2)))
            for r, c in around
            if not (r.same and _moves_alike(c.symbol, own.symbol))
        ]
        total = 1 + sum(o for _, o in odds)
        ranked = sorted(((c, o / total) for c, o in odds), key=lambda item: -item[1])
        return [(c, w) for c, w in ranked[:MOST_OTHERS] if w > self.state.settings.other_weight]

    def exchanged(self, i: int, other: ScoredTerm) -> Fit:
        """The fit with another term in the place of a member of the model."""
        model = [other if j == i else c for j, c in enumerate(self.model)]
        problem = self.state.problem
        return settled(self.state.fit_with(model), problem.machine, problem.readings, problem.columns_of(model))

    def _others(self, i: int, around, count: int, maps) -> list[OtherName]:
        out, terms = [], len(self.full.design.terms)
        for c, weight in self.weights(i, around):
            other = self.exchanged(i, c)
            at, parts, own = terms, [other.coefficients[:terms] - self.full.coefficients[:terms]], None
            for j, (m, wide) in enumerate(zip(self.model, maps[1:])):
                width = c.shape.size if j == i else m.shape.size
                values = other.coefficients[at : at + width]
                at += width
                if j == i:
                    own = values
                    parts.append(-wide @ self.full.coefficients[self.blocks[j]])
                else:
                    parts.append(wide @ (values - self.full.coefficients[self.blocks[j]]))
            changes = np.concatenate(parts)
            changes = np.concatenate([changes, np.zeros(count - len(changes))])
            term = replace(c, coefficients=own)
            name = f"{c.symbol} by {c.driver}"
            effect = to_effect(name, term, np.zeros((len(own), len(own))), {}, self.state.problem.readings.units)
            out.append(OtherName(replace(effect, u=None), weight, tuple(changes)))
        return out


def _moves_alike(a: str, b: str) -> bool:
    """Whether two components are translations along one axis: no reading ever tells these apart."""
    one, two = component(a), component(b)
    return not one.angular and not two.angular and one.axis == two.axis


def _key(term: design.Term) -> tuple:
    if term.group == DECLARED:
        return DECLARED, term.symbol, term.order
    if term.group == RUN:
        return RUN, term.symbol, design.ALIGNMENT[term.order]
    if term.group == TOOL:
        return TOOL, int(term.symbol) - 1, term.order
    return ALIGNMENT, term.symbol
