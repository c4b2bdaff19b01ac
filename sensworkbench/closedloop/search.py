# SPDX-License-Identifier: LGPL-2.1-or-later
"""Search: the candidates that explain most of what a fit leaves, with their unknown parameters refined.

Among candidates that explain the same, the plainer one is preferred: the body's own axis, a logged column before time,
the simpler shape, fewer factors (see `prior`).  The preference is a handicap in chi-square, which data can overrule.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ..core.driver import TIME, Driver
from ..core.errors import component
from ..core.parameters import Levels
from ..core.shapes import Regressor, Shape
from .bank import beside
from .design import ALL_SYMBOLS
from .prior import handicap
from .scan import Rows, Scanner, exact_gain, whole
from .surface import Surface


@dataclass(frozen=True)
class ScoredTerm:
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
        """Gain in chi-square less the handicap."""
        return self.gain - self.handicap

    @property
    def key(self) -> tuple[str, str, str]:
        """Component, driver and shape as text."""
        return self.symbol, *self.regressor.key

    @property
    def driver(self) -> Driver:
        """Its driver."""
        return self.regressor.driver

    @property
    def shape(self) -> Shape:
        """Its shape."""
        return self.regressor.shape

    def vectors(self, columns) -> np.ndarray:
        """(P, m) what the coefficients multiply."""
        return self.regressor.vectors(columns)

    @property
    def index(self) -> int:
        """Number of its component in `ALL_SYMBOLS`."""
        return ALL_SYMBOLS.index(self.symbol)


def scored(rows: Rows, symbol: str, regressor: Regressor, columns) -> ScoredTerm:
    """The term of a component and a driver through a shape beside the model of `rows`."""
    vectors = regressor.vectors(columns)
    gain, coefficients, visible = exact_gain(rows, ALL_SYMBOLS.index(symbol), vectors)
    shifted = whole(regressor, columns, rows.middle)
    if shifted is not None:
        share = float((shifted**2).mean()) / max(float((vectors**2).mean()), 1e-300)
        visible = min(visible / max(share, 1e-12), 1.0)
    return ScoredTerm(symbol, regressor, gain, coefficients, visible, handicap(symbol, regressor))


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


def refine(rows: Rows, candidate: ScoredTerm, columns, steps: int = 24) -> ScoredTerm:
    """The same candidate with the unknown parameters of its shape at their best, one after another."""
    for name in candidate.shape.fitted:
        candidate = _refined(rows, candidate, name, columns, steps)
    return candidate


def _refined(rows: Rows, candidate: ScoredTerm, name: str, columns, steps: int) -> ScoredTerm:
    regressor = candidate.regressor
    search, start = regressor.shape.parameters[name].search, regressor.shape.values[name]

    def at(value) -> ScoredTerm:
        return scored(rows, candidate.symbol, regressor.having(**{name: value}), columns)

    def seen(value) -> float:
        """Gain, where enough of the shape shows beside the declared model: a fit of the rest is a fit of noise."""
        c = at(value)
        return c.gain if c.visible > rows.settings.scan_visible else 0.0

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
    return better if better.gain > candidate.gain and better.visible > rows.settings.scan_visible else candidate


def _threshold(candidate: ScoredTerm, name: str, values, at: Callable[[float], ScoredTerm]) -> ScoredTerm:
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


def merged(a: ScoredTerm, b: ScoredTerm, columns) -> ScoredTerm | None:
    """One candidate for two on one component that are parts of one (see `Shape.joined`).  None for any others."""
    one = a.regressor.joined(b.regressor, columns) if a.symbol == b.symbol else None
    if one is None:
        return None
    same = next((c for c in (a, b) if c.regressor == one), None)
    return same or ScoredTerm(a.symbol, one, 0.0, np.zeros(0), 1.0, handicap(a.symbol, one))


def tried_beside(rows: Rows, symbols, columns, names) -> list[ScoredTerm]:
    """Return candidates of the shapes that are too many for the bank, on some components."""
    regressors = beside(columns, names)
    return [scored(rows, symbol, r, columns) for symbol in symbols for r in regressors]


def search(
    rows: Rows,
    readings,
    scanner: Scanner,
    names,
    groups,
    keep: int | None = None,
    inflation: float = 1.0,
) -> list[ScoredTerm]:
    """Return the best candidates first (by gain less handicap), one per motion, driver and shape, parameters refined.

    groups : components with the same effect on the readings, per place of the scanner; the simplest of them carries the
    candidate.  inflation : of the variance, where the noise itself is correlated from reading to reading; gains are
    divided by it.  keep : how many are looked at (default: `found` of the settings).
    """
    columns, s = readings.columns, rows.settings
    keep = keep or s.found
    scores = scanner.scores()
    flat = np.argsort(-scores.tail, axis=None)[: 40 * keep]
    chosen: dict[tuple, tuple[str, Regressor]] = {}
    for i in flat:
        k, g = np.unravel_index(i, scores.tail.shape)
        if scores.gain[k, g] < s.found_least * inflation:
            break
        regressor = scores.shapes[k]
        key = (int(g), *regressor.key)
        if key in chosen:
            continue
        symbol = min((ALL_SYMBOLS[c] for c in groups[g]), key=lambda name, r=regressor: handicap(name, r))
        chosen[key] = symbol, regressor
        if len(chosen) >= 3 * keep:
            break
    if not chosen:
        return []
    terms: dict[tuple, ScoredTerm] = {}
    for key in sorted(chosen, key=lambda k: chosen[k][0]):  # one component after another: see `Rows.per_point`
        terms[key] = scored(rows, *chosen[key], columns)
    found = [terms[key] for key in chosen]

    def score(c: ScoredTerm) -> float:
        return c.gain / inflation - c.handicap

    ranked = sorted(found, key=lambda c: -score(c))
    best = score(ranked[0])
    near = [c for c in ranked if score(c) > best - max(s.found_range, s.found_share * abs(best))][:keep]
    near += tried_beside(rows, list(dict.fromkeys(c.symbol for c in near))[: s.found_components], columns, names)
    out = []
    refined = 0
    for c in sorted(near, key=lambda c: -score(c)):
        if c.shape.fitted and refined < s.refined:
            c = refine(rows, c, columns, 16)
            refined += 1
        out.append(c)
    return sorted((c for c in out if c.visible > s.scan_visible), key=lambda c: -score(c))


def surface_candidate(s: Surface) -> ScoredTerm:
    """Return a surface as a candidate (without a name); a shift is assigned to the body that its columns belong to."""
    symbol = ALL_SYMBOLS[s.component]
    c = component(symbol)
    if not c.angular:
        bodies = [b for b in "XYZ" if b in Driver(s.columns).axes]
        body = symbol[1] if symbol[1] in bodies or not bodies else bodies[0]
        symbol = f"E{symbol[1]}{body}"
    return ScoredTerm(symbol, s.regressor(), s.gain, np.zeros(s.mix.shape[1]), 1.0, 0.0)


def same_place(a: ScoredTerm, b: ScoredTerm) -> bool:
    """Do two candidates move the same body part in the same way by a common column?"""
    ca, cb = component(a.symbol), component(b.symbol)
    alike = a.symbol == b.symbol or (not ca.angular and not cb.angular and ca.axis == cb.axis)
    return alike and bool(set(a.driver.columns) & set(b.driver.columns))
