# SPDX-License-Identifier: LGPL-2.1-or-later
"""Search: the candidates that explain most of what a fit leaves, with their unknown parameters refined.

Among candidates that explain the same, the plainer one is preferred: the body's own axis, a logged column before time,
the simpler shape, fewer factors.  The preference is a handicap in chi-square, so that data can overrule it.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ..core.driver import POSITIONS, TIME, Driver
from ..core.errors import ROTATION, SQUARENESS, TRANSLATION, component
from ..core.parameters import Levels
from ..core.shapes import Regressor, Shape
from .bank import beside
from .design import ALL_SYMBOLS
from .scan import MIN_VISIBLE, Rows, Scanner, exact_gain
from .surface import Surface

PER_PARAMETER = 7.0  # handicap of each further number fitted: about ln(number of readings)


@dataclass(frozen=True)
class Candidate:
    """component x driver x shape with what it explains.

    symbol, regressor (driver and shape); gain: drop of chi-square; coefficients (m,) mm or rad per driver unit;
    visible: share that the declared model cannot imitate; handicap: preference in chi-square units.
    """

    symbol: str
    regressor: Regressor
    gain: float
    coefficients: np.ndarray
    visible: float
    handicap: float

    @property
    def score(self) -> float:
        return self.gain - self.handicap

    @property
    def key(self) -> tuple[str, str, str]:
        return self.symbol, *self.regressor.key

    @property
    def driver(self) -> Driver:
        return self.regressor.driver

    @property
    def shape(self) -> Shape:
        return self.regressor.shape

    def vectors(self, columns) -> np.ndarray:
        """(P, m) what the coefficients multiply."""
        return self.regressor.vectors(columns)

    @property
    def index(self) -> int:
        return ALL_SYMBOLS.index(self.symbol)


def handicap(symbol: str, regressor: Regressor) -> float:
    """How far `component x driver x shape` stands behind the plainest reading of the same data, in chi-square."""
    c, driver, shape = component(symbol), regressor.driver, regressor.shape
    cost = PER_PARAMETER * shape.complexity + shape.prior
    cost += 2.0 * (driver.factors - 1)
    if TIME in driver:
        cost += 2.0
    if driver.repeats:
        cost += 0.5
    if shape.series and driver.columns[0].startswith("temp_"):
        cost += 8.0  # expansion is linear
    axes = driver.axes
    if c.kind == SQUARENESS:
        cost += 3.5  # its lever holds the axis position: one more factor
    if axes and c.body not in axes:
        cost += 3.0
    if len(axes) > 1 and set(driver.columns) - set(POSITIONS):
        cost += 1.0  # the scale of one axis with the place along another
    growth = shape.settles and c.kind == TRANSLATION and not axes
    slipped = shape.sudden and driver.columns == (TIME,)
    if c.body == "T":
        cost += 0.6 if not (growth and c.axis == 2) else 0.0
    elif c.body == "W":
        cost += 0.8 if not slipped else 0.0
    elif growth or slipped:
        cost += 0.5
    if c.kind == TRANSLATION and "XYZ"[c.axis] != c.body:
        cost += 0.3
    elif c.kind == TRANSLATION and axes == {c.body}:
        cost -= 3.0  # an axis along itself, by its own scale, place or direction
    if c.kind == ROTATION and axes and "XYZ"[c.axis] in axes and c.body in axes:
        cost += 0.05
    return cost + 0.01 * "XYZTW".index(c.body)


def _candidate(rows: Rows, symbol: str, regressor: Regressor, columns) -> Candidate:
    gain, coefficients, visible = exact_gain(rows, ALL_SYMBOLS.index(symbol), regressor.vectors(columns))
    return Candidate(symbol, regressor, gain, coefficients, visible, handicap(symbol, regressor))


def _golden(f: Callable[[float], float], low: float, high: float, steps: int = 24) -> float:
    ratio = (math.sqrt(5) - 1) / 2
    a, b = low, high
    c, d = b - ratio * (b - a), a + ratio * (b - a)
    fc, fd = f(c), f(d)
    for _ in range(steps):
        if fc > fd:
            b, d, fd = d, c, fc
            c = b - ratio * (b - a)
            fc = f(c)
        else:
            a, c, fc = c, d, fd
            d = a + ratio * (b - a)
            fd = f(d)
    return (a + b) / 2


def refine(rows: Rows, candidate: Candidate, columns, steps: int = 24) -> Candidate:
    """The same candidate with the unknown parameters of its shape at their best, one after another."""
    for name in candidate.shape.fitted:
        candidate = _refined(rows, candidate, name, columns, steps)
    return candidate


def _refined(rows: Rows, candidate: Candidate, name: str, columns, steps: int) -> Candidate:
    regressor = candidate.regressor
    search, start = regressor.shape.parameters[name].search, regressor.shape.values[name]

    def at(value) -> Candidate:
        return _candidate(rows, candidate.symbol, regressor.having(**{name: value}), columns)

    def seen(value) -> float:
        """Gain, where enough of the shape shows beside the declared model: a fit of the rest is a fit of noise."""
        c = at(value)
        return c.gain if c.visible > MIN_VISIBLE else 0.0

    candidate = at(start)  # its gain beside the model of these rows
    driven = regressor.driver.values(columns)
    if isinstance(search, Levels):
        return _threshold(candidate, name, np.unique(driven), at)
    span = float(np.ptp(driven))
    more = search.further_starts(span)
    if more:
        start = max([start, *more], key=seen)
    session = float(np.ptp(columns[TIME])) if TIME in columns else None
    low, high = search.bounds(start, span, session)
    better = at(float(search.back(_golden(lambda s: seen(search.back(s)), low, high, steps))))
    return better if better.gain > candidate.gain and better.visible > MIN_VISIBLE else candidate


def _threshold(candidate: Candidate, name: str, values, at: Callable[[float], Candidate]) -> Candidate:
    """The candidate with the parameter `name` half way between two of the driver's values (sorted), at its best."""
    near = int(np.searchsorted(values, candidate.shape.values[name]))
    reach = max(3, len(values) // 30)
    window = values[max(0, near - reach) : near + reach + 2]
    trial = list(window) if len(window) <= 24 else list(window[:: len(window) // 24 + 1])
    best = max([candidate] + [at(float(v)) for v in trial], key=lambda c: c.gain)
    if len(trial) < len(window):
        near = int(np.searchsorted(values, best.shape.values[name]))
        best = max([best] + [at(float(v)) for v in values[max(0, near - 6) : near + 7]], key=lambda c: c.gain)
    instant = best.shape.values[name]  # half way to the next reading: nothing tells them apart
    after = values[values > instant]
    return at(float((instant + after[0]) / 2)) if len(after) else best


def merged(a: Candidate, b: Candidate, columns) -> Candidate | None:
    """One candidate for two on one component that are parts of one (see `Shape.joined`).  None for any others."""
    one = a.regressor.joined(b.regressor, columns) if a.symbol == b.symbol else None
    if one is None:
        return None
    same = next((c for c in (a, b) if c.regressor == one), None)
    return same or Candidate(a.symbol, one, 0.0, np.zeros(0), 1.0, handicap(a.symbol, one))


def tried_beside(rows: Rows, symbols, columns, names) -> list[Candidate]:
    """Candidates of the shapes that are too many to stand in the bank, on some components."""
    regressors = beside(columns, names)
    return [_candidate(rows, symbol, r, columns) for symbol in symbols for r in regressors]


def search(
    rows: Rows,
    readings,
    scanner: Scanner,
    names,
    groups,
    keep: int = 60,
    within: float = 60.0,
    minimum: float = 12.0,
    inflation: float = 1.0,
) -> list[Candidate]:
    """Best candidates first (by gain less handicap), one per motion, driver and shape, parameters refined.

    groups : components that show alike, per place of the scanner; the plainest of them carries the candidate.
    inflation : of the variance, where the noise itself is correlated from reading to reading; gains are divided by it.
    """
    columns = readings.columns
    scores = scanner.scores()
    flat = np.argsort(-scores.tail, axis=None)[: 40 * keep]
    found: dict[tuple, Candidate] = {}
    for i in flat:
        k, g = np.unravel_index(i, scores.tail.shape)
        if scores.gain[k, g] < minimum * inflation:
            break
        regressor = scores.shapes[k]
        key = (int(g), *regressor.key)
        if key in found:
            continue
        symbol = min((ALL_SYMBOLS[c] for c in groups[g]), key=lambda s, r=regressor: handicap(s, r))
        found[key] = _candidate(rows, symbol, regressor, columns)
        if len(found) >= 3 * keep:
            break
    if not found:
        return []

    def score(c: Candidate) -> float:
        return c.gain / inflation - c.handicap

    ranked = sorted(found.values(), key=lambda c: -score(c))
    best = score(ranked[0])
    near = [c for c in ranked if score(c) > best - max(within, 0.3 * abs(best))][:keep]
    near += tried_beside(rows, list(dict.fromkeys(c.symbol for c in near))[:12], columns, names)
    out = []
    refined = 0
    for c in sorted(near, key=lambda c: -score(c)):
        if c.shape.fitted and refined < 30:
            c = refine(rows, c, columns, 16)
            refined += 1
        out.append(c)
    return sorted((c for c in out if c.visible > MIN_VISIBLE), key=lambda c: -score(c))


def surface_candidate(s: Surface) -> Candidate:
    """A surface as a candidate (without a name); a shift is put on the body that its columns speak of."""
    symbol = ALL_SYMBOLS[s.component]
    c = component(symbol)
    if not c.angular:
        bodies = [b for b in "XYZ" if b in Driver(s.columns).axes]
        body = symbol[1] if symbol[1] in bodies or not bodies else bodies[0]
        symbol = f"E{symbol[1]}{body}"
    return Candidate(symbol, s.regressor(), s.gain, np.zeros(s.mix.shape[1]), 1.0, 0.0)


def same_place(a: Candidate, b: Candidate) -> bool:
    """Do two candidates move the same body part in the same way by a common column?"""
    ca, cb = component(a.symbol), component(b.symbol)
    alike = a.symbol == b.symbol or (not ca.angular and not cb.angular and ca.axis == cb.axis)
    return alike and bool(set(a.driver.columns) & set(b.driver.columns))
