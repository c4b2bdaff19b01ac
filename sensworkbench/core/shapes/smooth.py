# SPDX-License-Identifier: LGPL-2.1-or-later
"""The smooth free form: it locates and predicts what no shape explains, and never names it."""

from __future__ import annotations

import numpy as np

from ..parameters import Intervals, Wholes
from ..refusal import Refused
from .base import Shape, register
from .functions import bump_features

MOST_BUMPS = 2000  # features of one form; the search stays far below


@register
class Smooth(Shape):
    """Gaussian bumps on a grid over the columns of the driver, not over their product; held beyond `domains`

    mix : (product of bumps, m) combinations that readings determine, while it is fitted; None: all bumps.
    """

    name = "smooth"
    free = tabulable = True
    scanned = False
    bumps = Wholes(least=1, most=200)
    domains = Intervals()

    def __init__(self, mix=None, **values):
        super().__init__(**values)
        self.mix = mix
        count = int(np.prod(self.bumps, dtype=float))
        if not 1 <= count <= MOST_BUMPS:
            raise Refused("smooth-bumps", count=count, most=MOST_BUMPS)
        if len(self.bumps) != len(self.domains):
            raise Refused("smooth-columns", bumps=len(self.bumps), domains=len(self.domains))

    def __eq__(self, other) -> bool:
        return super().__eq__(other) and np.array_equal(self.mix, other.mix)

    __hash__ = Shape.__hash__

    @property
    def size(self) -> int:
        return int(np.prod(self.bumps)) if self.mix is None else self.mix.shape[1]

    def check_driver(self, driver):
        if driver.factors != len(self.bumps):
            raise Refused("smooth-columns", bumps=len(self.bumps), domains=driver.factors)

    def in_order(self, order, coefficients, u):
        if list(order) == sorted(order) or len(order) != len(self.bumps):
            return self, coefficients, u

        def turned(values):
            table = np.array(values, dtype=object).reshape(self.bumps)
            return tuple(table.transpose(order).ravel())

        bumps, domains = (tuple(values[i] for i in order) for values in (self.bumps, self.domains))
        return (
            Smooth(bumps=bumps, domains=domains),
            turned(coefficients) if coefficients else coefficients,
            turned(u) if u else u,
        )

    def vectors(self, driver, columns, where=""):
        self.check_driver(driver)
        driver.values(columns, where)
        features = bump_features(columns, driver.columns, self.bumps, self.domains)
        return features if self.mix is None else features @ self.mix

    def extremes(self, coefficients, low, high):
        names = [str(i) for i in range(len(self.bumps))]
        side = max(2, int(4000 ** (1 / len(names))))
        lines = [np.linspace(a, b, side) for a, b in self.domains]
        grid = dict(zip(names, (g.ravel() for g in np.meshgrid(*lines, indexing="ij")), strict=True))
        values = bump_features(grid, names, self.bumps, self.domains) @ np.asarray(coefficients, dtype=float)
        return float(values.min()), float(values.max())

    def stored(self, coefficients, covariance):
        if self.mix is None:
            return self, coefficients, covariance
        return Smooth(**self.values), self.mix @ coefficients, self.mix @ covariance @ self.mix.T
