# SPDX-License-Identifier: LGPL-2.1-or-later
"""How large the mean square of a normal error can be while a quantile of its size is kept.

At a place T is normal with mean zero and a covariance of trace m.  P(|T| > u) depends on m / u² and on how m is split
between the three principal axes; g(x) is the least of it over all splits, x = m / u².  Over places with mean squares
x_p the part beyond u is at least the mean of g(x_p), and that is at least the convex minorant of g at the mean of x_p
(Jensen).  So a quantile that is kept bounds the mean square over the workspace.
"""

from __future__ import annotations

import functools
import itertools

import numpy as np

from .limits import _ball

PARTS = 6  # the splits are multiples of one in so many
ORDER = 24  # of the integrals: errors below 1e-9 here
LARGEST, COUNT = 6.0, 121  # the grid of x
SAFE = 5e-3  # relative: what the grids of x and of the splits may miss, several times over


@functools.cache
def _least_beyond() -> tuple[np.ndarray, np.ndarray]:
    """(x, g): the grid, which begins at 0, and the least part beyond u over the splits."""
    splits = [
        np.array([a, b, PARTS - a - b]) / PARTS
        for a, b in itertools.product(range(PARTS + 1), repeat=2)
        if a >= b >= PARTS - a - b >= 0
    ]
    x = np.linspace(0, np.sqrt(LARGEST), COUNT) ** 2
    g = np.zeros(COUNT)
    for i, ratio in enumerate(x[1:], start=1):
        deviations = [np.sqrt(np.maximum(ratio * split, ratio * 1e-12)) for split in splits]
        g[i] = 1 - max(_ball(np.zeros(3), s, 1.0, ORDER, derivatives=False).mass for s in deviations)
    return x, np.maximum(g, 0.0)


def largest_ratio(level: float, least: float = 0.0, most: float = np.inf) -> float:
    """The largest mean square over the workspace, in squares of the quantile at `level`, of normal errors of mean zero.

    least, most : the mean square of any place is that of the workspace times least to most.  Infinite where nothing
    follows.
    """
    x, g = _least_beyond()
    beyond, found = 1 - level, np.inf

    def kept(ratio: float) -> bool:
        return _minorant(x, g, ratio, least * ratio, min(most * ratio, x[-1])) <= beyond

    low = 0.0
    for ratio in x[:0:-1].tolist():
        if kept(ratio):
            low = ratio
            break
        found = ratio
    for _ in range(20 if np.isfinite(found) else 0):
        middle = (low + found) / 2
        low, found = (middle, found) if kept(middle) else (low, middle)
    return found * (1 + SAFE)


def _minorant(x, g, at: float, low: float, high: float) -> float:
    """The convex minorant of g on [low, high] at a place in it."""
    inside = (x > low) & (x < high)
    xs = np.concatenate([[low], x[inside], [max(high, low)]])
    gs = np.interp(xs, x, g)
    hull: list[int] = []
    for i in range(len(xs)):
        while len(hull) > 1 and (gs[hull[-1]] - gs[hull[-2]]) * (xs[i] - xs[hull[-2]]) >= (gs[i] - gs[hull[-2]]) * (
            xs[hull[-1]] - xs[hull[-2]]
        ):
            hull.pop()
        hull.append(i)
    return float(np.interp(at, xs[hull], gs[hull]))
