# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parameters of shapes: meaning, bounds, and how an unknown value is found by a search.

A shape declares its parameters as class attributes; on an instance the attribute is the value.  A parameter with a
`search` is fitted to readings, from a start on the grid of the shape; the others are chosen with the shape.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from .refusal import Refused

LARGEST = 1e12  # of any parameter, in its internal unit
DRIVER, TIME_UNIT, NUMBER = "driver", "s", ""
COLUMNS = "columns"  # the unit of the driver of one column; of several, each counts in its internal unit


# -- searches --------------------------------------------------------------------------------------------------------
@dataclass(frozen=True)
class Logarithmic:
    """A positive number, searched on a scale of ratios.

    ratio : how far to either side of the start.  starts : (lowest, highest, number) of more starts, as shares of the
    driver's span, where the gain has several maxima.  longest : upper limit in spans of time, or None.
    """

    ratio: float
    starts: tuple[float, float, int] | None = None
    longest: float | None = None

    forth, back = staticmethod(math.log), staticmethod(math.exp)

    def further_starts(self, span: float) -> list[float]:
        """More values to start from, for a driver of this span."""
        if self.starts is None:
            return []
        low, high, count = self.starts
        return [float(v) for v in np.geomspace(span * low, span * high, count)]

    def bounds(self, start: float, span: float, session: float | None) -> tuple[float, float]:
        """Ends of the search, on its own scale.  span : of the driver; session : of time, where there is one."""
        high = start * self.ratio
        if self.longest is not None and session is not None:
            high = min(high, max(start, self.longest * session))
        return math.log(start / self.ratio), math.log(high)

    def step(self, value: float, span: float) -> float:
        """Step of a finite difference."""
        return 0.02 * value


@dataclass(frozen=True)
class Reciprocal:
    """A period, searched by its frequency within `reach` / span of the driver."""

    reach: float

    @staticmethod
    def forth(value: float) -> float:
        """Return the value on the scale of the search: its reciprocal, the frequency."""
        return 1 / value

    back = forth

    def further_starts(self, span: float) -> list[float]:
        """Return no further starts: the grid of the shape is fine enough."""
        return []

    def bounds(self, start: float, span: float, session: float | None) -> tuple[float, float]:
        """Return the ends of the search as frequencies, `reach` / span to either side of the start."""
        reach = self.reach / span
        return 1 / start - reach, 1 / start + reach

    def step(self, value: float, span: float) -> float:
        """Return the step of a finite difference: 2 % of the value's share of the span."""
        return 0.02 * value**2 / span


@dataclass(frozen=True)
class Evenly:
    """A number, searched from `below` less than the start (but not under `least`) to `above` more."""

    below: float
    above: float
    least: float

    @staticmethod
    def forth(value: float) -> float:
        """Return the value on the scale of the search: itself."""
        return value

    back = forth

    def further_starts(self, span: float) -> list[float]:
        """Return no further starts."""
        return []

    def bounds(self, start: float, span: float, session: float | None) -> tuple[float, float]:
        """Return the ends of the search, `below` under and `above` over the start."""
        return max(self.least, start - self.below), start + self.above

    def step(self, value: float, span: float) -> float:
        """Return the step of a finite difference: 2 % of the value."""
        return 0.02 * value


@dataclass(frozen=True)
class Levels:
    """A threshold: only between two values that the driver takes does the fit change."""


# -- parameters ------------------------------------------------------------------------------------------------------
class Parameter:
    """One number of a shape, with its unit and bounds.

    unit : "driver" (the driver's unit), "s", or "" (a pure number).  above : excluded lower bound; least, most :
    included bounds.  default : value where none is stated (None: it must be stated).  whole : a whole number.
    search : how a fit finds it, or None where it is not fitted.  absolute : a value of the driver, no difference: a
    temperature in degrees counts from 20 degC.
    """

    size: int | None = 1  # how many numbers stand for it in a file; None: any

    def __init__(
        self,
        unit=DRIVER,
        *,
        above=None,
        least=-LARGEST,
        most=LARGEST,
        default=None,
        whole=False,
        search=None,
        absolute=False,
    ):
        self.unit, self.above, self.least, self.most = unit, above, least, most
        self.default, self.whole, self.search, self.absolute = default, whole, search, absolute
        self.name = ""

    def __set_name__(self, owner, name):
        self.name = name

    def __get__(self, instance, owner=None):
        return self if instance is None else instance.values[self.name]

    def __set__(self, instance, value):
        raise AttributeError("a shape does not change")

    def _one(self, value) -> float:
        try:
            value = float(value)
        except (TypeError, ValueError, OverflowError):
            raise Refused("parameter-no-number", name=self.name) from None
        if not math.isfinite(value):
            raise Refused("parameter-not-finite", name=self.name)
        if self.above is not None and not value > self.above:
            raise Refused("parameter-not-above", name=self.name, value=value, above=self.above)
        if not self.least <= value <= self.most:
            raise Refused("parameter-out-of-range", name=self.name, value=value, least=self.least, most=self.most)
        if self.whole and value != int(value):
            raise Refused("parameter-not-whole", name=self.name, value=value)
        return int(value) if self.whole else value

    def unit_of(self, driver, driver_unit: str | None) -> str | None:
        """The internal unit of its values, given the driver and its unit (None: not known yet)."""
        if self.unit == DRIVER or (self.unit == COLUMNS and driver.factors == 1):
            return driver_unit
        return "" if self.unit == COLUMNS else self.unit

    def check(self, value):
        """`value` as the shape keeps it; refuses what is out of bounds."""
        return self._one(value)

    def of_numbers(self, numbers):
        """The value of a list of numbers as a file holds it; refuses a wrong count."""
        if self.size is not None and len(numbers) != self.size:
            raise Refused("parameter-count", name=self.name, count=len(numbers), size=self.size)
        return self.check(numbers[0])

    def numbers(self, value) -> list:
        """The numbers of a value, in the order of a file."""
        return [value]


class Interval(Parameter):
    """Two numbers, the first below the second."""

    size = 2

    def check(self, value):
        try:
            low, high = value
        except (TypeError, ValueError):
            raise Refused("parameter-count", name=self.name, count=1, size=2) from None
        low, high = self._one(low), self._one(high)
        if not high - low > 1e-9 * max(abs(low), abs(high)) or not high - low > 1e-150:
            raise Refused("parameter-no-length", name=self.name, low=low, high=high)
        return low, high

    def of_numbers(self, numbers):
        if len(numbers) != 2:
            raise Refused("parameter-count", name=self.name, count=len(numbers), size=2)
        return self.check(numbers)

    def numbers(self, value) -> list:
        return list(value)


class Wholes(Parameter):
    """Some whole numbers, one for each column of the driver."""

    size = None

    def __init__(self, **bounds):
        super().__init__(NUMBER, whole=True, **bounds)

    def check(self, value):
        return tuple(self._one(v) for v in value)

    of_numbers = check

    def numbers(self, value) -> list:
        return list(value)


class Intervals(Interval):
    """Some intervals, one for each column of the driver; a file holds them one after another."""

    size = None

    def __init__(self, **bounds):
        super().__init__(COLUMNS, **bounds)

    def check(self, value):
        return tuple(Interval.check(self, pair) for pair in value)

    def of_numbers(self, numbers):
        if len(numbers) % 2:
            raise Refused("parameter-count", name=self.name, count=len(numbers), size=len(numbers) + 1)
        return self.check(list(zip(numbers[::2], numbers[1::2])))

    def numbers(self, value) -> list:
        return [v for pair in value for v in pair]
