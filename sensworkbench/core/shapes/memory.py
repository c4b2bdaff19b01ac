# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shapes with memory: what they give depends on the rows before."""

from __future__ import annotations

from ..driver import TIME, Driver
from ..parameters import TIME_UNIT, Logarithmic, Parameter
from .base import Shape, register
from .functions import geometric, hysteresis, lag


@register
class Lag(Shape):
    """y of y' = (v - y)/tau, y = state0 at the first row"""

    name = "lag"
    needs_time = memory = settles = True
    tau = Parameter(TIME_UNIT, above=0.0, search=Logarithmic(1.7, longest=1.5))  # longer is a trend of time
    state0 = Parameter(default=0.0, absolute=True)

    def basis(self, v, t):
        return lag(v, t, self.tau, self.state0)[:, None]

    @property
    def unit_power(self) -> float:
        return 1.0

    def extremes(self, coefficients, low, high):
        ends = [float(coefficients[0]) * v for v in (min(low, self.state0), max(high, self.state0))]
        return min(ends), max(ends)

    @classmethod
    def scan(cls, seen):
        if TIME not in seen.names:
            return
        span, memory = seen.span(TIME), seen.remembered
        for source in [(n,) for n in memory] + [(n, n) for n in memory if n.startswith("spindle")]:
            for tau in geometric(span / 100, span * 1.5, 12):
                yield Driver(source), cls(tau=tau)


@register
class Hysteresis(Shape):
    """v less the play of half-width `width` on v (see `hysteresis`)"""

    name = "hysteresis"
    prior = 2.0
    memory = play = True
    # steps of a grid of places make several maxima: all are looked at first
    width = Parameter(above=0.0, search=Logarithmic(1.25, starts=(1 / 400, 1 / 5, 20)))

    def basis(self, v, t):
        return hysteresis(v, self.width)[:, None]

    @property
    def unit_power(self) -> float:
        return 1.0

    @property
    def saturation(self) -> float:
        return self.width

    def extremes(self, coefficients, low, high):
        most = abs(float(coefficients[0])) * min(self.width, high - low)
        return -most, most

    @classmethod
    def scan(cls, seen):
        for a in seen.places:
            for part in (200, 50, 20, 8):
                yield Driver((a,)), cls(width=seen.span(a) / part)

    def joined(self, driver, other, other_driver, columns):
        if {str(driver), str(other_driver)} == {str(driver), f"dir_{driver}"}:
            return driver, self
        return None
