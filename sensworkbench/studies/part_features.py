# SPDX-License-Identifier: LGPL-2.1-or-later
"""Features of a part under a machine's errors: value, uncertainty and the share of every error and effect.

A share is the signed projection of what one error does to the feature on what all do together, in its mean square,
after the columns that the tolerance leaves free are fitted by least squares: <R_i, R> / <R, R>; of tolerances its
expectation.  Shares add to one.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from ..core.features import PLACE, Feature, Surface, judge
from ..core.minimum_zone import independent
from .part_errors import FittedErrors, TolerancedErrors, chunks

DRAWS, DRAWN_POINTS = 256, 400  # of a tolerance's value; points of a feature that are drawn
LEVEL = 0.95
NOTHING = 1e-12  # share that is rounding


@dataclass(frozen=True)
class FeatureFound:
    """A feature's outcome, mm.

    value : as fitted, or expected from tolerances.  u : standard uncertainty, of tolerances the standard deviation;
    None where none is known.  least_squares : the value by least squares.  rms : root mean square of the departures
    after least squares, exact.  quantile : of the value, of tolerances only.  shares : (K,) adding to 1, or zeros where
    there is no departure.  worst : row of the path.  points : number of them.  element : of the nominal geometry.
    """

    feature: Feature
    value: float
    u: float | None
    least_squares: float
    rms: float
    quantile: float | None
    shares: np.ndarray
    worst: int
    points: int


class _Sums:
    """Sums over the points of a surface: of its columns and of the departures that each of K columns makes.

    columns : (n m, r) of the surface.  By `add` over chunks: X^T A (r, K) and A^T b (K,), where b is the sum of all
    columns (`together`) or each column itself.
    """

    def __init__(self, columns: np.ndarray, width: int, count: int, together: bool):
        self.columns, self.width, self.together = columns, width, together
        self.of_columns = np.zeros((columns.shape[1], count))
        self.products = np.zeros(count)

    def add(self, rows: slice, departures: np.ndarray) -> None:
        x = self.columns[rows.start * self.width : rows.stop * self.width]
        self.of_columns += x.T @ departures
        other = departures.sum(axis=1, keepdims=True) if self.together else departures
        self.products += np.einsum("pk,pk->k", departures, np.broadcast_to(other, departures.shape))


def _sums(surface: Surface, rows, columns, together: bool, make: Callable, count: int) -> _Sums:
    sums, at = _Sums(columns, surface.width, count, together), 0
    for part in chunks(rows):
        here = slice(at, at + len(part))
        sums.add(here, surface.departures(make(part), here))
        at = here.stop
    return sums


def _own(surface: Surface, rows, make: Callable, count: int) -> np.ndarray:
    """(p, K) least-squares coefficients of a surface's own columns in what each of K columns does to it."""
    basis, back = independent(surface.columns)
    found = _sums(surface, rows, basis, True, make, count)
    return back @ found.of_columns / len(basis)


def evaluate(
    found: Feature, rows: np.ndarray, datum_rows: np.ndarray | None, errors: FittedErrors | TolerancedErrors
) -> FeatureFound:
    """The outcome of a feature whose surface is made by the points `rows` of the path."""
    make = errors.columns if errors.tolerances else errors.contributions
    count = len(errors.of) if errors.tolerances else len(errors.labels)
    state = _State(found, rows, datum_rows, make, count, not errors.tolerances)
    if errors.tolerances:
        return _expected(state, errors)
    return _fitted(state, errors)


class _State:
    """Linear maps of a feature for K columns: turns (3, K) of the datum, places (3, K), inner products (K,)."""

    def __init__(self, found: Feature, rows, datum_rows, make, count: int, together: bool):
        self.found, self.rows, self.datum_rows, self.together = found, rows, datum_rows, together
        surface, datum = found.surface, found.datum
        self.turns = self.places = None
        if found.kind.group == PLACE:
            self.places = self.place_of(make, count)
            v = found.along.T @ self.places
            other = v.sum(axis=1, keepdims=True) if together else v
            self.inner, self.samples = (v * other).sum(axis=0), 1
            return
        basis, _ = independent(found.free)
        tilting = np.zeros((len(basis), 0)) if found.tilting is None else found.tilting
        sums = _sums(surface, rows, np.concatenate([basis, tilting], axis=1), together, make, count)
        f = basis.shape[1]
        own, arms = sums.of_columns[:f], sums.of_columns[f:]
        inner = sums.products
        if found.tilting is not None:
            self.turns = datum.tilt[0] @ _own(datum, datum_rows, make, count)
            square, cross = tilting.T @ tilting, basis.T @ tilting
            total = (lambda a: a.sum(axis=1, keepdims=True)) if together else (lambda a: a)
            turns = self.turns
            inner = inner - (turns * total(arms)).sum(axis=0) - (total(turns) * arms).sum(axis=0)
            inner = inner + (turns * (square @ total(turns))).sum(axis=0)
            own = own - cross @ turns
        other = own.sum(axis=1, keepdims=True) if together else own
        self.inner = inner - (own * other).sum(axis=0) / len(basis)
        self.samples = len(basis)

    def place_of(self, make, count: int) -> np.ndarray:
        """(3, K) place of the surface less that of its datum."""
        surface, datum = self.found.surface, self.found.datum
        place = surface.place @ _own(surface, self.rows, make, count)
        if datum is not None:
            place = place - datum.place @ _own(datum, self.datum_rows, make, count)
        return place

    def shares(self, by_label: np.ndarray) -> np.ndarray:
        """`by_label` (K,) as shares that add to one; zeros where nothing departs."""
        total = float(by_label.sum())
        if not total > 1e-30:
            return np.zeros(len(by_label))
        found = by_label / total
        return np.where(np.abs(found) < NOTHING, 0.0, found)


def _fitted(state: _State, errors: FittedErrors) -> FeatureFound:
    found, surface = state.found, state.found.surface
    departures = np.concatenate([surface.departures(errors.error(p), s) for p, s in _pieces(state.rows)])
    turn = None if state.turns is None else state.turns.sum(axis=1)
    place = None if state.places is None else state.places.sum(axis=1)
    result = judge(found, departures, turn, place)
    total = float(state.inner.sum())
    return FeatureFound(
        feature=found,
        value=result.value,
        u=_uncertainty(state, result, errors),
        least_squares=result.least_squares,
        rms=float(np.sqrt(max(total, 0.0) / state.samples)),
        quantile=None,
        shares=state.shares(state.inner),
        worst=int(state.rows[result.worst]),
        points=len(state.rows),
    )


def _pieces(rows):
    at = 0
    for part in chunks(rows):
        yield part, slice(at, at + len(part))
        at += len(part)


def _uncertainty(state: _State, result, errors: FittedErrors) -> float | None:
    """Standard uncertainty of the value from the covariance of the fitted coefficients."""
    if not errors.known_u:
        return None
    found, surface, make, count = state.found, state.found.surface, errors.parameters, len(errors.factor)
    if result.direction is not None:
        slope = result.direction @ state.place_of(make, count)
    else:
        m = surface.width
        at, back = np.unique(result.points, return_inverse=True)
        each = surface.departures(make(state.rows[at]), at).reshape(len(at), m, count)
        weights = result.weights.reshape(len(result.points), m)
        slope = np.einsum("km,kmn->n", weights, each[back])
        if found.tilting is not None:
            turns = found.datum.tilt[0] @ _own(found.datum, state.datum_rows, make, count)
            arms = np.einsum("km,kmc->c", weights, found.tilting.reshape(-1, m, 3)[result.points])
            slope = slope - arms @ turns
    return float(np.sqrt(((slope @ errors.factor) ** 2).sum()))


def _expected(state: _State, errors: TolerancedErrors) -> FeatureFound:
    found, surface = state.found, state.found.surface
    labels = len(errors.labels)
    by_label = np.bincount(errors.of, state.inner * errors.variance, minlength=labels)
    mean_state = None
    if errors.law.mean.any():
        mean_state = _State(found, state.rows, state.datum_rows, errors.means, labels, True)
        by_label = by_label + mean_state.inner
    pick = np.unique(np.linspace(0, len(state.rows) - 1, DRAWN_POINTS).astype(int))
    factors = errors.draws(DRAWS)
    rows = state.rows[pick]
    drawn = surface.departures(errors.columns(rows), pick) @ factors.T
    turns = None if state.turns is None else state.turns @ factors.T
    places = None if state.places is None else state.places @ factors.T
    if mean_state is not None:
        drawn = drawn + surface.departures(errors.means(rows), pick).sum(axis=1)[:, None]
        turns = None if turns is None else turns + mean_state.turns.sum(axis=1)[:, None]
        places = None if places is None else places + mean_state.places.sum(axis=1)[:, None]
    thin = _thinned(found, pick)
    outcomes = [
        judge(thin, drawn[:, i], None if turns is None else turns[:, i], None if places is None else places[:, i])
        for i in range(DRAWS)
    ]
    values = np.array([o.value for o in outcomes])
    sizes = np.abs(values) if found.kind.name == "distance" else values
    worst = np.bincount([o.worst for o in outcomes], minlength=len(pick)).argmax()
    return FeatureFound(
        feature=found,
        value=float(values.mean()),
        u=float(values.std()),
        least_squares=float(np.mean([o.least_squares for o in outcomes])),
        rms=float(np.sqrt(max(float(by_label.sum()), 0.0) / state.samples)),
        quantile=float(np.quantile(sizes, LEVEL)),
        shares=state.shares(by_label),
        worst=int(rows[worst]),
        points=len(state.rows),
    )


def _thinned(found: Feature, pick) -> Feature:
    """The feature with some of its points only."""
    m, s = found.surface.width, found.surface
    at = (np.asarray(pick)[:, None] * m + np.arange(m)).ravel()
    few = replace(
        s,
        points=s.points[pick],
        normals=None if s.normals is None else s.normals[pick],
        directions=s.directions[pick],
        columns=s.columns[at],
    )
    tilting = None if found.tilting is None else found.tilting[at]
    return replace(found, surface=few, tilting=tilting, free=found.free[at])
