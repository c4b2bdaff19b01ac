# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tolerances and the four moments of their distributions - all that the exact indices need of an input.

The exact variance decomposition of Y = XᵀAX (see `sobol`) takes the mean and the central moments 2, 3, 4 of each
independent input, whatever its distribution.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from statistics import NormalDist

import numpy as np

from .errors import COMPONENTS, PAPER_SYMBOLS, Component, component
from .refusal import Refused

UM, URAD = 1e-3, 1e-6  # in mm and rad
LARGEST = 1e6  # mm or rad: a kilometre is no tolerance, and fourth powers must stay finite

DISTRIBUTIONS = ("uniform", "normal", "truncated_normal", "triangular", "u_shaped", "point")


def _flat_normal_integral(a: float, k: int) -> float:
    """Integral of u^k exp(-a u²) over 0 <= u <= 1, for a <= 1/2, by the series of the exponential."""
    return sum((-a) ** n / (math.factorial(n) * (2 * n + k + 1)) for n in range(16))


_inverse_normal = np.vectorize(NormalDist().inv_cdf, otypes=[float])


@dataclass(frozen=True)
class Tolerance:
    """Limits of one error and how it is distributed between them (mm or rad).

    uniform : flat between the limits (the paper's choice).
    normal : mean half way, limits at +-3 standard deviations (or `sigma`); not cut off.
    truncated_normal : normal with `sigma` (default a quarter of the width) cut off at the limits.
    triangular : peak half way.  u_shaped : arcsine, the law of a sinusoid sampled at random.
    point : a known constant, the middle of the limits; no variance.
    """

    lower: float
    upper: float
    distribution: str = "uniform"
    sigma: float | None = None

    def __post_init__(self):
        values = [self.lower, self.upper] + ([] if self.sigma is None else [self.sigma])
        for value in values:
            if isinstance(value, bool) or not isinstance(value, (int, float, np.floating, np.integer)):
                raise Refused("tolerance-not-a-number", value=repr(value))
            if not math.isfinite(value):
                raise Refused("tolerance-not-finite", value=value)
            if abs(value) > LARGEST:
                raise Refused("tolerance-too-large", value=value)
        if self.upper < self.lower:
            raise Refused("tolerance-limits-reversed", lower=self.lower, upper=self.upper)
        if self.distribution not in DISTRIBUTIONS:
            raise Refused("distribution-unknown", name=repr(self.distribution), known=DISTRIBUTIONS)
        if self.sigma is not None:
            if self.distribution not in ("normal", "truncated_normal"):
                raise Refused("distribution-without-sigma", name=self.distribution)
            if self.sigma <= 0:
                raise Refused("sigma-not-positive", sigma=self.sigma)

    @property
    def moments(self) -> tuple[float, float, float, float]:
        """(mean, variance, third central moment, fourth central moment)."""
        middle, width = (self.lower + self.upper) / 2, self.upper - self.lower
        if width**2 == 0 or self.distribution == "point":
            return middle, 0.0, 0.0, 0.0
        if self.distribution == "uniform":
            return middle, width**2 / 12, 0.0, width**4 / 80
        if self.distribution == "triangular":
            return middle, width**2 / 24, 0.0, width**4 / 240
        if self.distribution == "u_shaped":
            return middle, width**2 / 8, 0.0, width**4 * 3 / 128
        if self.distribution == "normal":
            sigma = self.sigma or width / 6
            return middle, sigma**2, 0.0, 3 * sigma**4
        sigma = self.sigma or width / 4
        c = width / 2 / sigma  # cut at +-c standard deviations
        if c < 1:  # nearly flat: the closed form cancels, the series of exp does not
            mass, second, fourth = (_flat_normal_integral(c * c / 2, k) for k in (0, 2, 4))
            return middle, (width / 2) ** 2 * second / mass, 0.0, (width / 2) ** 4 * fourth / mass
        if c > 40:  # nothing is cut off
            return middle, sigma**2, 0.0, 3 * sigma**4
        density = math.exp(-c * c / 2) / math.sqrt(2 * math.pi)
        mass = math.erf(c / math.sqrt(2))
        second = 1 - 2 * c * density / mass
        fourth = 3 * second - 2 * c**3 * density / mass
        return middle, sigma**2 * second, 0.0, sigma**4 * fourth

    def inverse(self, share: np.ndarray) -> np.ndarray:
        """Values below which the law lies with probability `share`, in (0, 1); mm or rad."""
        middle, half = (self.lower + self.upper) / 2, (self.upper - self.lower) / 2
        share = np.asarray(share, dtype=float)
        if half == 0 or self.distribution == "point":
            return np.full(share.shape, middle)
        if self.distribution == "uniform":
            return middle + half * (2 * share - 1)
        if self.distribution == "triangular":
            side = np.where(share < 0.5, np.sqrt(2 * np.minimum(share, 0.5)) - 1, 1 - np.sqrt(2 * (1 - share)))
            return middle + half * side
        if self.distribution == "u_shaped":
            return middle - half * np.cos(np.pi * share)
        normal = NormalDist()
        if self.distribution == "normal":
            return middle + (self.sigma or half / 3) * _inverse_normal(share)
        sigma = self.sigma or half / 2
        low = normal.cdf(-half / sigma)
        inside = low + (1 - 2 * low) * share
        if half < sigma * 1e-3:  # flat
            return middle + half * (2 * share - 1)
        return middle + np.clip(sigma * _inverse_normal(inside), -half, half)

    def scaled(self, ratio: float) -> Tolerance:
        """The same law about the same middle with its width times `ratio` (0 freezes the error)."""
        middle, half = (self.lower + self.upper) / 2, (self.upper - self.lower) / 2 * ratio
        sigma = self.sigma * ratio if self.sigma and ratio > 0 else None
        return Tolerance(middle - half, middle + half, self.distribution, sigma)


@dataclass(frozen=True)
class Moments:
    """Moments of n independent inputs: `mean`, `var`, `third`, `fourth` (central), each of shape (n,).

    laws (n): what they are the moments of, for objectives that need more than moments; empty where nobody knows.
    """

    mean: np.ndarray
    var: np.ndarray
    third: np.ndarray
    fourth: np.ndarray
    laws: tuple[Tolerance, ...] = ()


def moments(tolerances) -> Moments:
    """`Moments` of a sequence of `Tolerance`."""
    laws = tuple(tolerances)
    table = np.array([t.moments for t in laws], dtype=float).reshape(-1, 4)
    return Moments(*np.ascontiguousarray(table.T), laws)


def paper_tolerance(symbol: str) -> Tolerance:
    """Park & Yang 2012 section 4, uniform: straightness +-5 um, linear displacement +-1 um, spindle axial +-0.5 and
    radial +-2 um, the nine angles and three squareness errors +-20 urad; spindle angles and workpiece zero."""
    return paper_tolerance_of(component(symbol))


def paper_tolerance_of(c: Component) -> Tolerance:
    """`paper_tolerance` of a component: +-1 um along a linear joint's own axis, +-5 um across it, +-20 urad."""
    if c.body == "W" or (c.body == "T" and c.angular):
        half = 0.0
    elif c.angular:
        half = 20 * URAD
    elif c.body == "T":
        half = (0.5 if c.axis == 2 else 2) * UM
    else:
        half = (1 if c.axis == c.along else 5) * UM
    return Tolerance(-half, half, "uniform")


def with_defaults(given: dict[str, Tolerance]) -> dict[str, Tolerance]:
    """The tolerances of a machine: the paper's 24, overridden and extended by `given`.  Order: ISO, then extras."""
    table = {s: given.get(s, paper_tolerance(s)) for s in PAPER_SYMBOLS}
    table |= {s: given[s] for s in COMPONENTS if s in given and s not in table}
    return table
