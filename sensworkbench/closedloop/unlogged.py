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
from .settings import DEFAULT, TraceSettings


@dataclass(frozen=True)
class Unlogged:
    """A body that moves at random from reading to reading.

    symbol; rms of the motion (mm or rad; per mm of `place` if there is one); p: family-wise; size: rms shown per
    reading over its noise; selection: share of half-samples of points that choose it; place: "" or the axis position
    that the motion is proportional to.
    """

    symbol: str
    rms: float
    p: float
    size: float
    selection: float
    place: str = ""


def _p_value(observed: float, null: np.ndarray, settings: TraceSettings) -> float:
    """Share of null maxima at least as large, but .05 at least where the largest of them comes near.

    A name that nobody can check against a column needs more than the one in a hundred that chance allows.
    """
    share = float((1 + np.count_nonzero(null >= observed)) / (len(null) + 1))
    return share if observed > settings.unlogged_margin * float(null.max()) else max(share, settings.unlogged_near)


def _halves(parts, scale, best: int, settings: TraceSettings, seed: int) -> float:
    """Share of half-samples of points in which entry `best` is the largest; parts (P, C) sum to the statistic."""
    rng = np.random.default_rng(seed + 2)
    count = len(parts)
    hits = 0
    for _ in range(settings.halves):
        half = parts[rng.permutation(count)[: count // 2]].sum(axis=0) / scale
        hits += bool(half[best] > 0 and half[best] >= (1 - 1e-9) * half.max())
    return hits / settings.halves


def _pairs(rows: Rows) -> tuple[np.ndarray, np.ndarray]:
    """(first, second) rows of every two of the same point."""
    size = np.diff(np.r_[rows.start, len(rows.residual)])
    rank = np.arange(len(rows.residual)) - rows.start[rows.point]
    found = [np.flatnonzero(rank + apart < size[rows.point]) for apart in range(1, int(size.max(initial=1)))]
    first = np.concatenate([np.zeros(0, dtype=int), *found])
    return first, first + np.repeat(np.arange(1, len(found) + 1), [len(f) for f in found])


def _of_points(point, product, count: int) -> np.ndarray:
    """(count, C) sums of the products of pairs over the points that they belong to."""
    return np.stack([np.bincount(point, weights=p, minlength=count) for p in product.T], axis=1)


def unlogged_driver(rows: Rows, settings: TraceSettings = DEFAULT, count: int = 199, seed: int = 0) -> Unlogged | None:
    """The component whose random motion the residual shows most, or None where points hold one reading each.

    Residuals beyond three times their noise are drawn in, so that a few points do not make a motion.
    """
    clip = settings.unlogged_clip
    residual = np.clip(rows.residual, -clip, clip)
    first, second = _pairs(rows)
    g2 = rows.lever**2
    weight = (rows.gather(g2) ** 2 - rows.gather(g2**2)).sum(axis=0)
    usable = weight > 1e-6 * max(float(weight.max(initial=0.0)), 1e-300)
    if not usable.any():
        return None
    scale = np.where(usable, np.sqrt(np.where(usable, weight, 1.0)), np.inf)
    product = 2 * rows.lever[first] * rows.lever[second] * (residual[first] * residual[second])[:, None]
    observed = product.sum(axis=0) / scale
    rng = np.random.default_rng(seed)
    null = np.empty(count)
    for i in range(count):
        turned = rng.choice((-1.0, 1.0), len(rows.residual))
        null[i] = ((turned[first] * turned[second]) @ product / scale).max()
    best = int(np.argmax(observed))
    if observed[best] <= 0:
        return None
    variance = observed[best] / scale[best]
    power = float(g2[:, best].sum() / rows.used)
    return Unlogged(
        symbol=ALL_SYMBOLS[best],
        rms=float(np.sqrt(max(variance, 0.0))),
        p=_p_value(observed[best], null, settings),
        size=float(np.sqrt(max(variance, 0) * power)),
        selection=_halves(_of_points(rows.point[first], product, len(rows.start)), scale, best, settings, seed),
    )


def uneven_noise(rows: Rows, q, kind, settings: TraceSettings = DEFAULT, count: int = 199, seed: int = 0):
    """Return the component (times x, y, z or nothing) whose lever the spread of the residual follows, or None.

    q : (P, n) positions.  kind : (R,) direction of sensing; squares are compared within each, and the null permutes
    them.  Noise may be uneven for many reasons: the spread must follow the lever in each of two directions at least,
    and no smooth change of the spread over the places may remain.
    """
    used = rows.lever.any(axis=1)
    kinds = [np.flatnonzero(used & (kind == k)) for k in np.unique(kind)]
    kinds = [k for k in kinds if len(k) > settings.unlogged_least]
    if len(kinds) < 2:
        return None
    point, chosen = rows.point, np.concatenate(kinds)
    follow, labels = [], []
    for name, place in [("", np.ones(len(q)))] + [(n, q[:, i]) for i, n in enumerate("xyz"[: q.shape[1]])]:
        power = rows.lever**2 * (place[point] ** 2)[:, None]
        for part in kinds:
            power[part] -= power[part].mean(axis=0)
        follow.append(power[chosen])
        labels += [(s, name, place) for s in ALL_SYMBOLS[: rows.lever.shape[1]]]
    x = np.concatenate(follow, axis=1)
    norm = np.sqrt((x**2).sum(axis=0))
    good = norm > 1e-9 * max(float(norm.max(initial=0.0)), 1e-300)
    if not good.any() or float(norm.max()) < 1e-9:
        return None
    x = np.where(good, x / np.where(good, norm, 1.0), 0.0)
    square = np.clip(rows.residual, -settings.unlogged_clip, settings.unlogged_clip) ** 2
    centred = [square[part] - square[part].mean() for part in kinds]
    y = np.concatenate(centred)
    observed = x.T @ y
    rng = np.random.default_rng(seed)
    shuffled = [np.concatenate([rng.permutation(c) for c in centred]) for _ in range(count)]
    null = np.array([(x.T @ s).max() for s in shuffled])
    best = int(np.argmax(observed))
    p = _p_value(observed[best], null, settings)
    edges = np.cumsum([0, *(len(k) for k in kinds)])
    slices = [slice(a, b) for a, b in zip(edges[:-1], edges[1:])]
    if not good[best] or not _of_the_lever(x[:, best], y, shuffled, slices, q[point[chosen]], settings):
        return None
    variance = max(float(observed[best] / norm[best]), 0.0)
    symbol, name, place = labels[best]
    power = float((rows.lever[chosen, ALL_SYMBOLS.index(symbol)] ** 2 * place[point[chosen]] ** 2).mean())
    again = _halves(_of_points(point[chosen], x * y[:, None], len(q)), np.ones(x.shape[1]), best, settings, seed)
    return Unlogged(symbol, float(np.sqrt(variance)), p, float(np.sqrt(variance * power)), again, name)


def _of_the_lever(x, y, shuffled, slices, q, settings: TraceSettings) -> bool:
    """Return whether the spread y (rows,) follows the lever x (rows,) in two directions at least, with nothing
    remaining.
    """
    strength = np.array([float((x[s] ** 2).sum()) for s in slices])
    follows = 0
    for s, size in zip(slices, strength):
        if size > settings.unlogged_shows * strength.max():
            null = np.array([float(x[s] @ z[s]) for z in shuffled])
            follows += bool(np.mean(null >= float(x[s] @ y[s])) < settings.unlogged_follows)
            if follows == 0 and size > settings.unlogged_must * strength.max():
                return False
    if follows < 2:
        return False
    unit = (q - q.mean(axis=0)) / np.where(q.std(axis=0) > 0, q.std(axis=0), 1.0)
    columns = [unit, unit**2] + [unit[:, [i]] * unit[:, i + 1 :] for i in range(q.shape[1] - 1)]
    table = np.concatenate(columns, axis=1)
    wide = np.zeros((len(y), table.shape[1] * len(slices)))
    for k, s in enumerate(slices):
        wide[s, k * table.shape[1] : (k + 1) * table.shape[1]] = table[s] - table[s].mean(axis=0)
    wide -= np.outer(x, x @ wide)
    u, d, _ = np.linalg.svd(wide, full_matrices=False)
    u = u[:, d > 1e-6 * d[0]] if len(d) and d[0] > 0 else u[:, :0]
    left = float(((u.T @ (y - x * (x @ y))) ** 2).sum())
    null = np.array([float(((u.T @ (z - x * (x @ z))) ** 2).sum()) for z in shuffled])
    return float(np.mean(null >= left)) > settings.unlogged_other
