# SPDX-License-Identifier: LGPL-2.1-or-later
"""A driver that nobody logged: noise shaped like one body's motion.

If one body moves at random from reading to reading, the components of each reading's residual are correlated along that
body's lever arm, and their spread follows its length (times a place, where the motion grows along an axis).  The first
test uses products between different components only, so unequal noise of the sensors does not imitate it; the second
compares spreads within one direction of sensing.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .design import ALL_SYMBOLS
from .scan import Rows

CLIP = 3.0
MARGIN = 1.25


@dataclass(frozen=True)
class Unlogged:
    """symbol, rms of the motion (mm or rad; per mm of `place` if there is one), family-wise p, size: rms shown per
    reading over its noise, place: "" or the axis position that the motion is proportional to."""

    symbol: str
    rms: float
    p: float
    size: float
    place: str = ""


def _p_value(observed: float, null: np.ndarray) -> float:
    """Share of null maxima at least as large, but .05 at least where the largest of them comes within a quarter: a name
    that nobody can check against a column needs more than the one in a hundred that chance allows."""
    share = float((1 + np.count_nonzero(null >= observed)) / (len(null) + 1))
    return share if observed > MARGIN * float(null.max()) else max(share, 0.05)


def _cross(rows: Rows, residual) -> np.ndarray:
    """(C,) sum over points of the cross products of lever x residual."""
    x = rows.lever * residual[:, None]
    return (rows.gather(x) ** 2 - rows.gather(x**2)).sum(axis=0)


def unlogged_driver(rows: Rows, count: int = 199, seed: int = 0) -> Unlogged | None:
    """The component whose random motion the residual shows most, or None where points hold one reading each.

    Residuals beyond three times their noise are drawn in, so that a few points do not make a motion.
    """
    residual = np.clip(rows.residual, -CLIP, CLIP)
    g2 = rows.lever**2
    weight = (rows.gather(g2) ** 2 - rows.gather(g2**2)).sum(axis=0)
    usable = weight > 1e-6 * max(float(weight.max(initial=0.0)), 1e-300)
    if not usable.any():
        return None
    scale = np.where(usable, np.sqrt(np.where(usable, weight, 1.0)), np.inf)
    observed = _cross(rows, residual) / scale
    rng = np.random.default_rng(seed)
    null = np.empty(count)
    for i in range(count):
        null[i] = (_cross(rows, residual * rng.choice((-1.0, 1.0), len(rows.residual))) / scale).max()
    best = int(np.argmax(observed))
    if observed[best] <= 0:
        return None
    variance = observed[best] / scale[best]
    power = float((g2[:, best]).sum() / max(np.count_nonzero(rows.lever.any(axis=1)), 1))
    p = _p_value(observed[best], null)
    return Unlogged(ALL_SYMBOLS[best], float(np.sqrt(max(variance, 0.0))), p, float(np.sqrt(max(variance, 0) * power)))


def uneven_noise(rows: Rows, q, kind, count: int = 199, seed: int = 0) -> Unlogged | None:
    """The component (times x, y, z or nothing) whose lever the spread of the residual follows most.

    q : (P, 3) positions.  kind : (R,) direction of sensing; squares are compared within each.  The null permutes them.
    """
    used = rows.lever.any(axis=1)
    point = np.repeat(np.arange(len(rows.start)), np.diff(np.r_[rows.start, len(rows.residual)]))
    places = [("", np.ones(len(q)))] + [(n, q[:, i]) for i, n in enumerate("xyz")]
    kinds = [np.flatnonzero(used & (kind == k)) for k in np.unique(kind)]
    kinds = [k for k in kinds if len(k) > 30]
    if not kinds:
        return None
    rows_used = np.concatenate(kinds)
    follow, labels = [], []
    for name, place in places:
        power = rows.lever**2 * (place[point] ** 2)[:, None]
        for part in kinds:
            power[part] -= power[part].mean(axis=0)
        follow.append(power[rows_used])
        labels += [(s, name) for s in ALL_SYMBOLS]
    x = np.concatenate(follow, axis=1)
    norm = np.sqrt((x**2).sum(axis=0))
    good = norm > 1e-9 * max(float(norm.max(initial=0.0)), 1e-300)
    if not good.any() or float(norm.max()) < 1e-9:
        return None
    x = np.where(good, x / np.where(good, norm, 1.0), 0.0)
    square = np.clip(rows.residual, -CLIP, CLIP) ** 2
    centred = [square[part] - square[part].mean() for part in kinds]
    observed = x.T @ np.concatenate(centred)
    rng = np.random.default_rng(seed)
    null = np.array([(x.T @ np.concatenate([rng.permutation(c) for c in centred])).max() for _ in range(count)])
    best = int(np.argmax(observed))
    p = _p_value(observed[best], null)
    if not good[best]:
        return None
    variance = max(float(observed[best] / norm[best]), 0.0)
    symbol, name = labels[best]
    place = dict(places)[name]
    power = float((rows.lever[rows_used, ALL_SYMBOLS.index(symbol)] ** 2 * place[point[rows_used]] ** 2).mean())
    return Unlogged(symbol, float(np.sqrt(variance)), p, float(np.sqrt(variance * power)), name)
