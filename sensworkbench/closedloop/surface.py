# SPDX-License-Identifier: LGPL-2.1-or-later
"""A smooth surface over one or two columns, to locate what no shape explains and to predict it - never to name it.

Gaussian bumps on a grid over the columns, on one component, with a common prior on their heights; the evidence
(marginal likelihood) chooses component, columns and resolution, so that wide and narrow features compete fairly.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np

from ..core.driver import Driver
from ..core.shapes import Regressor, Smooth, bump_features
from .scan import Rows

PRIORS = 4.0 ** np.arange(-6, 10)  # ratio of prior to noise, in units of the mean information of a bump


@dataclass(frozen=True)
class Surface:
    """component (index), columns, bumps per column, domains ((low, high), ...), evidence (nats), gain and freedom."""

    component: int
    columns: tuple[str, ...]
    bumps: tuple[int, ...]
    domains: tuple[tuple[float, float], ...]
    evidence: float
    gain: float
    freedom: float
    mix: np.ndarray  # (features, k) directions that the readings determine

    def regressor(self) -> Regressor:
        """As what the tracer can fit and the machine can store."""
        order = np.argsort(self.columns, kind="stable")  # a driver's columns are sorted, and with them the bumps
        bumps, domains = (tuple(values[i] for i in order) for values in (self.bumps, self.domains))
        mix = self.mix.reshape(*self.bumps, -1).transpose(*order, len(order)).reshape(self.mix.shape)
        return Regressor(Driver(self.columns), Smooth(mix=mix, bumps=bumps, domains=domains))


def _fit(rows: Rows, component: int, features):
    """Eigen-decomposition of the projected information: (values, vectors, scores)."""
    across, _, residual, _ = rows.per_point(component)
    inner = rows.inner(component, features)
    shown = features.T @ across
    values, vectors = np.linalg.eigh(inner - shown @ shown.T)
    values = np.maximum(values, 0.0)
    return values, vectors, vectors.T @ (features.T @ residual)


def _evidence(values, scores):
    """(best log evidence against no surface, prior variance)."""
    mean = float(values.mean())
    if mean <= 0:
        return 0.0, 0.0
    a = PRIORS[:, None] / mean
    nats = 0.5 * (a * scores**2 / (1 + a * values) - np.log1p(a * values)).sum(axis=1)
    k = int(np.argmax(nats))
    return float(nats[k]), float(a[k, 0])


def _counts(rows: Rows, columns, name, wanted: int) -> int:
    levels = len(np.unique(columns[name]))
    return levels if levels <= rows.settings.few_levels else min(wanted, levels)


def _domain(columns, name):
    v = columns[name]
    return float(np.min(v)), float(np.max(v))


def surface(rows: Rows, columns, component: int, names, wanted) -> Surface:
    """The surface of one component over the named columns at a resolution (bumps per column)."""
    bumps = tuple(_counts(rows, columns, n, w) for n, w in zip(names, wanted, strict=True))
    domains = tuple(_domain(columns, n) for n in names)
    features = bump_features(columns, names, bumps, domains)
    values, vectors, scores = _fit(rows, component, features)
    nats, prior = _evidence(values, scores)
    keep = prior * values > 1.0
    gain = float((scores[keep] ** 2 / np.where(values[keep] > 0, values[keep], 1.0)).sum())
    return Surface(component, tuple(names), bumps, domains, nats, gain, float(keep.sum()), vectors[:, keep])


def sharpen(rows: Rows, columns, found: Surface) -> Surface:
    """The same component and columns at the resolution that these rows, with their noise now known, support."""
    s = rows.settings
    grid = itertools.product((*s.bumps, s.bumps_fine), repeat=len(found.columns))
    tried = [
        surface(rows, columns, found.component, found.columns, wanted)
        for wanted in grid
        if np.prod(wanted) <= s.bumps_sharp
    ]
    return max(tried, key=lambda t: t.evidence)


def separable(rows: Rows, columns, found: Surface, rounds: int = 12) -> Surface | None:
    """The surface as one profile along each column, multiplied - if so little freedom explains it as well (BIC).

    Where readings leave gaps between lines, two profiles still predict; a free surface does not.
    """
    if len(found.columns) != 2:
        return None
    best: tuple[float, Surface] | None = None
    penalty = np.log(len(rows.residual))
    for wanted in itertools.product(rows.settings.profile_bumps, repeat=2):
        bumps = tuple(_counts(rows, columns, n, w) for n, w in zip(found.columns, wanted, strict=True))
        tables = [bump_features(columns, (n,), (b,), (d,)) for n, b, d in zip(found.columns, bumps, found.domains)]
        start = _start(rows, found, columns, tables)
        if start is None:
            continue
        profiles, freedom, gain = list(start), [0.0, 0.0], 0.0
        for _ in range(rounds):
            previous = gain
            for i in (0, 1):
                other = tables[1 - i] @ profiles[1 - i]
                values, vectors, scores = _fit(rows, found.component, tables[i] * other[:, None])
                _, prior = _evidence(values, scores)
                profiles[i] = vectors @ (prior * scores / (1 + prior * values))
                freedom[i] = float((prior * values / (1 + prior * values)).sum())
                gain = float((scores**2 * prior * (2 + prior * values) / (1 + prior * values) ** 2).sum())
            if abs(gain - previous) < rows.settings.profile_settled * max(gain, 1.0):
                break
        mix = np.outer(*profiles).reshape(-1, 1)
        score = gain - penalty * sum(freedom)
        if np.all(np.isfinite(mix)) and (best is None or score > best[0]):
            mix = mix / max(float(np.abs(mix).max()), 1e-300)
            args = (found.component, found.columns, bumps, found.domains, found.evidence, gain, sum(freedom), mix)
            best = (score, Surface(*args))
    if best is None or best[0] < found.gain - penalty * found.freedom:
        return None
    return best[1]


def _start(rows: Rows, found: Surface, columns, tables):
    """Profiles to begin with: the leading singular vectors of the surface, put on other bumps."""
    features = bump_features(columns, found.columns, found.bumps, found.domains)
    values, vectors, scores = _fit(rows, found.component, features)
    _, prior = _evidence(values, scores)
    heights = (vectors @ (prior * scores / (1 + prior * values))).reshape(found.bumps)
    u, s, vt = np.linalg.svd(heights)
    if s[0] <= 0:
        return None
    out = []
    for table, own, name, count, domain in zip(
        tables, (u[:, 0] * s[0], vt[0]), found.columns, found.bumps, found.domains, strict=True
    ):
        profile = bump_features(columns, (name,), (count,), (domain,)) @ own
        out.append(np.linalg.lstsq(table, profile, rcond=1e-6)[0])
    return out


def locate(rows: Rows, readings, names, components) -> list[Surface]:
    """Surfaces by evidence, best first: all single columns and pairs at one resolution, the leaders of both at several.

    A second column must be worth its while: slow columns and directions of approach go together in most plans, and a
    surface of two of them predicts nothing where they part.
    """
    columns, settings = readings.columns, rows.settings
    sets = [(a,) for a in names] + list(itertools.combinations(names, 2))
    coarse = []
    for group in sets:
        wanted = (settings.bumps_coarse,) * len(group) if len(group) > 1 else (2 * settings.bumps_coarse,)
        bumps = tuple(_counts(rows, columns, n, w) for n, w in zip(group, wanted, strict=True))
        features = bump_features(columns, group, bumps, tuple(_domain(columns, n) for n in group))
        for c in components:
            values, _, scores = _fit(rows, c, features)
            coarse.append((_evidence(values, scores)[0], c, group))
    coarse.sort(key=lambda item: -item[0])
    best = coarse[0][0] if coarse else 0.0
    leaders = [[item for item in coarse if len(item[2]) == size][: settings.located] for size in (1, 2)]
    found = []
    for nats, c, group in [item for part in leaders for item in part]:
        if nats < settings.located_share * best:
            continue
        if len(group) == 1:
            grid = [(r,) for r in (*settings.bumps, settings.bumps_fine)]
        else:
            grid = [g for g in itertools.product(settings.bumps, repeat=2) if g[0] * g[1] <= settings.bumps_most]
        found.append(max((surface(rows, columns, c, group, w) for w in grid), key=lambda s: s.evidence))
    return sorted(found, key=lambda s: settings.detectable * (len(s.columns) - 1) - s.evidence)
