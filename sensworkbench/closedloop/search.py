# SPDX-License-Identifier: LGPL-2.1-or-later
"""Search: the candidates that explain most of what a fit leaves, with their unknown parameters refined.

Among candidates that explain the same, the plainer one is preferred: the body's own axis, a logged column before time,
the simpler shape, fewer factors.  The preference is a handicap in chi-square, so that data can overrule it.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from ..core.drivers import legendre
from ..core.errors import ROTATION, SQUARENESS, TRANSLATION, component
from .bank import DIRECTIONS, POSITIONS, Shape
from .design import ALL_SYMBOLS
from .freeform import free_form
from .scan import MIN_VISIBLE, Rows, Scanner, exact_gain
from .surface import Surface, bump_features

PER_PARAMETER = 7.0  # handicap of each further number fitted: about ln(number of readings)


@dataclass(frozen=True)
class Candidate:
    """component x driver x shape with what it explains.

    symbol, shape; gain: drop of chi-square; coefficients (m,) mm or rad per driver unit; visible: share that the
    declared model cannot imitate; handicap: preference in chi-square units.
    """

    symbol: str
    shape: Shape
    gain: float
    coefficients: np.ndarray
    visible: float
    handicap: float

    @property
    def score(self) -> float:
        return self.gain - self.handicap

    @property
    def key(self) -> tuple[str, str, str]:
        return self.symbol, self.shape.driver, self.shape.shape

    @property
    def index(self) -> int:
        return ALL_SYMBOLS.index(self.symbol)


def vectors_of(shape: Shape, columns) -> np.ndarray:
    """(P, m) columns of a shape; a polynomial's are Legendre P1..Pn over its domain."""
    if shape.shape == "smooth":
        p = shape.parameters
        if "bumps" in p:
            features = bump_features(columns, shape.driver.split("*"), p["bumps"], p["domains"])
            return features @ p["mix"] if "mix" in p else features
        return free_form(columns, tuple(shape.driver.split("*")), p["degree"], p.get("domains")).vectors
    if shape.shape == "polynomial":
        v = np.ones(len(next(iter(columns.values()))))
        for name in shape.driver.split("*"):
            v = v * columns[name]
        return legendre(v, int(shape.parameters["degree"]), shape.parameters["domain"])
    return shape.vectors(columns)


def axes_of(driver: str) -> set[str]:
    """The machine axes that a driver speaks of: x, dir_x and temp_scale_x speak of X."""
    found = set()
    for name in driver.split("*"):
        last = name.rsplit("_", 1)[-1]
        if last in ("x", "y", "z"):
            found.add(last.upper())
    return found


def handicap(symbol: str, shape: Shape) -> float:
    """How far `component x driver x shape` stands behind the plainest reading of the same data, in chi-square."""
    c = component(symbol)
    cost = PER_PARAMETER * (shape.profiled + max(shape.width - 1, 0))
    if shape.shape == "polynomial":
        cost += PER_PARAMETER * (shape.parameters["degree"] - 1)
    cost += 2.0 * (shape.factors - 1)
    if "t" in shape.driver.split("*"):
        cost += 2.0
    if len(set(shape.driver.split("*"))) < shape.factors:
        cost += 0.5
    if shape.shape in ("power", "hysteresis"):
        cost += 2.0
    if shape.shape == "polynomial" and shape.driver.startswith("temp_"):
        cost += 8.0  # expansion is linear
    if shape.shape == "approach":
        cost -= 6.0  # every machine warms up
    axes = axes_of(shape.driver)
    if c.kind == SQUARENESS:
        cost += 3.5  # its lever holds the axis position: one more factor
    if axes and c.body not in axes:
        cost += 3.0
    if len(axes) > 1 and set(shape.driver.split("*")) - set(POSITIONS):
        cost += 1.0  # the scale of one axis with the place along another
    growth = shape.shape in ("approach", "lag") and c.kind == TRANSLATION and not axes
    slipped = shape.shape == "step" and shape.driver == "t"
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


def _candidate(rows: Rows, symbol: str, shape: Shape, columns) -> Candidate:
    gain, coefficients, visible = exact_gain(rows, ALL_SYMBOLS.index(symbol), vectors_of(shape, columns))
    return Candidate(symbol, shape, gain, coefficients, visible, handicap(symbol, shape))


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
    """The same candidate with its period, time constant, instant, width or exponent at its best."""
    shape = candidate.shape
    name = next((k for k in ("tau", "period", "at", "exponent", "width") if k in shape.parameters), None)
    if name is None:
        return candidate
    start = shape.parameters[name]

    def at(value):
        return _candidate(rows, candidate.symbol, replace(shape, parameters={**shape.parameters, name: value}), columns)

    def seen(value) -> float:
        """Gain, where enough of the shape shows beside the declared model: a fit of the rest is a fit of noise."""
        c = at(value)
        return c.gain if c.visible > MIN_VISIBLE else 0.0

    candidate = at(start)  # its gain beside the model of these rows

    if name == "at":
        values = np.unique(columns[shape.driver])
        near = int(np.searchsorted(values, start))
        reach = max(3, len(values) // 30)
        window = values[max(0, near - reach) : near + reach + 2]
        trial = list(window) if len(window) <= 24 else list(window[:: len(window) // 24 + 1])
        best = max([candidate] + [at(float(v)) for v in trial], key=lambda c: c.gain)
        if len(trial) < len(window):
            near = int(np.searchsorted(values, best.shape.parameters["at"]))
            best = max([best] + [at(float(v)) for v in values[max(0, near - 6) : near + 7]], key=lambda c: c.gain)
        instant = best.shape.parameters["at"]  # half way to the next reading: nothing tells them apart
        after = values[values > instant]
        return at(float((instant + after[0]) / 2)) if len(after) else best
    if name == "period":
        span = float(np.ptp(columns[shape.driver]))
        reach = 0.35 / span
        found = 1 / _golden(lambda f: seen(1 / f), 1 / start - reach, 1 / start + reach, steps)
    elif name == "exponent":
        found = _golden(seen, max(0.25, start - 0.5), start + 0.6, steps)
    else:
        ratio = 1.7 if name == "tau" else 2.5
        if name == "width":  # steps of a grid make several maxima: look at all of them first
            span = float(np.ptp(columns[shape.driver]))
            ratio, grid = 1.25, np.geomspace(span / 400, span / 5, 20)
            start = max([start, *map(float, grid)], key=seen)
        high = start * ratio
        if name == "tau" and shape.shape == "lag":  # a memory of much more than the session is a trend of time
            high = min(high, max(start, 1.5 * float(np.ptp(columns["t"]))))
        found = math.exp(_golden(lambda v: seen(math.exp(v)), math.log(start / ratio), math.log(high), steps))
    better = at(float(found))
    return better if better.gain > candidate.gain and better.visible > MIN_VISIBLE else candidate


def merged(a: Candidate, b: Candidate, columns) -> Candidate | None:
    """One candidate for two on one component: a polynomial for two powers of a column, a hysteresis for a reversal and
    a hysteresis of one axis.  None for any others."""
    if a.symbol != b.symbol:
        return None
    lossy = next((c for c in (a, b) if c.shape.shape == "hysteresis"), None)
    if lossy and {a.shape.driver, b.shape.driver} == {lossy.shape.driver, f"dir_{lossy.shape.driver}"}:
        return lossy
    names = set(a.shape.driver.split("*")) | set(b.shape.driver.split("*"))
    if len(names) != 1 or not {a.shape.shape, b.shape.shape} <= {"linear", "polynomial"}:
        return None
    name = names.pop()
    v = columns[name]
    degree = max(int(c.shape.parameters.get("degree", c.shape.factors)) for c in (a, b))
    domain = (float(v.min()), float(v.max()))
    shape = Shape(name, "polynomial", {"degree": max(degree, 2), "domain": domain})
    return Candidate(a.symbol, shape, 0.0, np.zeros(0), 1.0, handicap(a.symbol, shape))


def polynomials(rows: Rows, symbols, columns, names) -> list[Candidate]:
    """Polynomials of one column on some components: too many to stand in the bank."""
    out = []
    for symbol in symbols:
        for name in names:
            levels = len(np.unique(columns[name]))
            if name in DIRECTIONS or levels < 4:
                continue
            v = columns[name]
            domain = (float(v.min()), float(v.max()))
            for degree in (2, 3):
                if levels > degree:
                    shape = Shape(name, "polynomial", {"degree": degree, "domain": domain})
                    out.append(_candidate(rows, symbol, shape, columns))
    return out


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
        shape = scores.shapes[k]
        key = (int(g), shape.driver, shape.shape)
        if key in found:
            continue
        symbol = min((ALL_SYMBOLS[c] for c in groups[g]), key=lambda s, shape=shape: handicap(s, shape))
        found[key] = _candidate(rows, symbol, shape, columns)
        if len(found) >= 3 * keep:
            break
    if not found:
        return []

    def score(c: Candidate) -> float:
        return c.gain / inflation - c.handicap

    ranked = sorted(found.values(), key=lambda c: -score(c))
    best = score(ranked[0])
    near = [c for c in ranked if score(c) > best - max(within, 0.3 * abs(best))][:keep]
    near += polynomials(rows, list(dict.fromkeys(c.symbol for c in near))[:12], columns, names)
    out = []
    refined = 0
    for c in sorted(near, key=lambda c: -score(c)):
        if c.shape.profiled and refined < 30:
            c = refine(rows, c, columns, 16)
            refined += 1
        out.append(c)
    return sorted((c for c in out if c.visible > MIN_VISIBLE), key=lambda c: -score(c))


def surface_candidate(s: Surface) -> Candidate:
    """A surface as a candidate (without a name); a shift is put on the body that its columns speak of."""
    symbol = ALL_SYMBOLS[s.component]
    c = component(symbol)
    if not c.angular:
        bodies = [b for b in "XYZ" if b in axes_of("*".join(s.columns))]
        body = symbol[1] if symbol[1] in bodies or not bodies else bodies[0]
        symbol = f"E{symbol[1]}{body}"
    return Candidate(symbol, s.shape(), s.gain, np.zeros(s.mix.shape[1]), 1.0, 0.0)


def same_place(a: Candidate, b: Candidate) -> bool:
    """Do two candidates move the same body part in the same way by a common column?"""
    ca, cb = component(a.symbol), component(b.symbol)
    alike = a.symbol == b.symbol or (not ca.angular and not cb.angular and ca.axis == cb.axis)
    return alike and bool(set(a.shape.driver.split("*")) & set(b.shape.driver.split("*")))
