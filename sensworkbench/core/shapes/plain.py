# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shapes that are functions of their driver: linear, reversal, approach, step, power, periodic, polynomial."""

from __future__ import annotations

import itertools

import numpy as np

from ..driver import DIRECTIONS, POSITIONS, TIME, Driver
from ..parameters import NUMBER, Evenly, Interval, Levels, Logarithmic, Parameter, Reciprocal
from .base import Shape, register
from .functions import geometric, legendre, periods

MAX_DEGREE = 30


@register
class Linear(Shape):
    """v"""

    name = "linear"
    proportional = tabulable = True

    def basis(self, v, t):
        return v[:, None]

    @property
    def unit_power(self) -> float:
        return 1.0

    def extremes(self, coefficients, low, high):
        ends = float(coefficients[0]) * low, float(coefficients[0]) * high
        return min(ends), max(ends)

    @classmethod
    def scan(cls, seen):
        names, place = seen.names, seen.places
        for a in names:
            if a not in DIRECTIONS:
                yield Driver((a,)), cls()
        for a, b in itertools.combinations_with_replacement(names, 2):
            if a == b and (a in seen.two_level or a in DIRECTIONS):
                continue
            if a != b and all(n == TIME or n.startswith("temp_") for n in (a, b)):
                continue  # temperatures and time multiply nothing on a machine
            yield Driver((a, b)), cls()
        for a in names:
            for b, c in itertools.combinations_with_replacement(place, 2):
                yield Driver((a, b, c)), cls()
        for a, b in itertools.product(seen.directions, names):
            for c in place:
                if b not in place and b not in DIRECTIONS:
                    yield Driver((a, b, c)), cls()

    def joined(self, driver, other, other_driver, columns):
        return Polynomial.of_powers(driver, self, other_driver, other, columns)


@register
class Reversal(Linear):
    """v of a direction column: -1, 0 or +1"""

    name = "reversal"
    tabulable = False

    @property
    def unit_power(self) -> float:
        return 0.0

    @classmethod
    def scan(cls, seen):
        for a in seen.directions:
            yield Driver((a,)), cls()

    def joined(self, driver, other, other_driver, columns):
        return None


@register
class Approach(Shape):
    """1 - exp(-v/tau)"""

    name = "approach"
    prior = -6.0  # every machine warms up
    warm_up = settles = True
    tau = Parameter(above=0.0, search=Logarithmic(1.7))

    def basis(self, v, t):
        return (1 - np.exp(-v / self.tau))[:, None]

    @classmethod
    def scan(cls, seen):
        if TIME in seen.names:
            span = seen.span(TIME)
            for tau in geometric(span / 60, span * 1.5, 12):
                yield Driver((TIME,)), cls(tau=tau)


@register
class Step(Shape):
    """1 where v > at, else 0"""

    name = "step"
    compared = False
    sudden = True
    at = Parameter(search=Levels(), absolute=True)

    def basis(self, v, t):
        return (v > self.at).astype(float)[:, None]

    @classmethod
    def scan(cls, seen):
        for a in seen.many_levels:
            if a in POSITIONS or a == TIME:
                v = np.unique(seen.columns[a])
                for at in np.quantile(v, np.linspace(0.04, 0.96, 47 if a == TIME else 23), method="lower"):
                    yield Driver((a,)), cls(at=float(at))


@register
class Power(Shape):
    """sign(v) |v|^exponent"""

    name = "power"
    compared = False
    prior = 2.0
    tabulable = True
    exponent = Parameter(NUMBER, above=0.0, most=20.0, search=Evenly(0.5, 0.6, 0.25))

    def basis(self, v, t):
        return (np.sign(v) * np.abs(v) ** self.exponent)[:, None]

    @property
    def unit_power(self) -> float:
        return self.exponent

    @classmethod
    def scan(cls, seen):
        few = [n for n in seen.names if n not in (*seen.many_levels, *seen.two_level, *DIRECTIONS)]
        for a in [*seen.many_levels, *few]:
            if a not in POSITIONS:
                for exponent in (0.5, 1.5, 2.0, 3.0):
                    yield Driver((a,)), cls(exponent=exponent)


@register
class Periodic(Shape):
    """sin(2 pi v/period), cos(2 pi v/period)"""

    name = "periodic"
    compared = False
    wave = tabulable = True
    period = Parameter(above=0.0, search=Reciprocal(0.35))

    @property
    def size(self) -> int:
        return 2

    def basis(self, v, t):
        phase = 2 * np.pi * v / self.period
        return np.column_stack([np.sin(phase), np.cos(phase)])

    def extremes(self, coefficients, low, high):
        if high - low >= self.period:
            most = float(np.hypot(*coefficients))
            return -most, most
        return super().extremes(coefficients, low, high)

    @classmethod
    def scan(cls, seen):
        for a in seen.places:
            for period in periods(seen.columns[a]):
                yield Driver((a,)), cls(period=period)

    def resolved(self, other: Periodic, span: float) -> bool:
        """Can a travel of length `span` tell the two periods apart?  Nearer ones are one wave whose height and phase
        change along it.
        """
        return abs(1 / self.period - 1 / other.period) * span >= 1.0

    def joined(self, driver, other, other_driver, columns):
        if driver != other_driver or not isinstance(other, Periodic):
            return None
        return None if self.resolved(other, float(np.ptp(driver.values(columns)))) else (driver, self)


@register
class Polynomial(Shape):
    """Legendre P1 .. Pn of v mapped from `domain` to [-1, 1], n = degree"""

    name = "polynomial"
    series = tabulable = True
    scanned = False  # too many to stand in the bank
    degree = Parameter(NUMBER, least=1, most=MAX_DEGREE, whole=True)
    domain = Interval(absolute=True)

    @property
    def size(self) -> int:
        return self.degree

    def basis(self, v, t):
        return legendre(v, self.degree, self.domain)

    @classmethod
    def scan(cls, seen):
        for name in seen.names:
            v = seen.columns[name]
            levels = len(np.unique(v))
            if name in DIRECTIONS or levels < 4:
                continue
            for degree in (2, 3):
                if levels > degree:
                    yield Driver((name,)), cls(degree=degree, domain=(float(v.min()), float(v.max())))

    def joined(self, driver, other, other_driver, columns):
        return self.of_powers(driver, self, other_driver, other, columns)

    @classmethod
    def of_powers(cls, driver, shape, other_driver, other, columns) -> tuple[Driver, Shape] | None:
        """The polynomial of two powers or polynomials of one column; None for any others."""
        names = {*driver.names, *other_driver.names}
        if len(names) != 1 or not {type(shape), type(other)} <= {Linear, cls}:
            return None
        v = columns[next(iter(names))]
        degrees = [s.degree if isinstance(s, cls) else d.factors for d, s in ((driver, shape), (other_driver, other))]
        return Driver(tuple(names)), cls(degree=max(*degrees, 2), domain=(float(v.min()), float(v.max())))
