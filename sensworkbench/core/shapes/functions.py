# SPDX-License-Identifier: LGPL-2.1-or-later
"""The functions that shapes are made of, each for an array of driver values."""

from __future__ import annotations

import numpy as np

FORGOTTEN = 1e-18  # of an earlier state: less changes no digit


def to_domain(v, domain) -> np.ndarray:
    """Map [lo, hi] to [-1, 1]."""
    low, high = domain
    return (2 * np.asarray(v, dtype=float) - low - high) / (high - low)


def legendre(v, degree: int, domain, start: int = 1) -> np.ndarray:
    """(P, degree - start + 1) Legendre P_start .. P_degree of v mapped from `domain` to [-1, 1]."""
    return np.polynomial.legendre.legvander(to_domain(v, domain), degree)[:, start:]


def lag(v, t, tau: float, state0: float = 0.0) -> np.ndarray:
    """(P,) first-order lag y' = (v - y)/tau, rows in time order, v held over each interval at its end value.

    v, t : (P,).  y = state0 at the first row.  A row whose time does not advance keeps the state.
    """
    v, t = np.asarray(v, dtype=float), np.asarray(t, dtype=float)
    keep = np.exp(-np.maximum(np.diff(t), 0.0) / tau)
    if not len(v):
        return np.empty(0)
    kept, y = np.r_[1.0, keep], np.r_[float(state0), (1 - keep) * v[1:]]  # y_i = kept_i y_(i-1) + what is new
    apart = 1
    while apart < len(y) and kept[apart:].max() > FORGOTTEN:  # each pass joins twice as many rows
        y[apart:] += kept[apart:] * y[:-apart]
        kept[apart:] *= kept[:-apart].copy()
        apart *= 2
    return y


def hysteresis(v, width: float) -> np.ndarray:
    """(P,) v minus the play (backlash) operator of half-width `width` on v, in units of v.

    The play starts at 0 and follows v; the difference saturates at +-width after each reversal.
    """
    v = np.asarray(v, dtype=float)
    values = v.tolist()
    state = values[0] if values else 0.0
    y = []
    for x in values:
        if state < x - width:
            state = x - width
        elif state > x + width:
            state = x + width
        y.append(x - state)
    return np.array(y)


def bump_features(columns, names, bumps, domains) -> np.ndarray:
    """(P, product of bumps) Gaussian bumps; a column beyond its domain is held at the edge."""
    out = None
    for name, count, (low, high) in zip(names, bumps, domains, strict=True):
        x = np.clip((np.asarray(columns[name], dtype=float) - low) / (high - low), 0.0, 1.0)
        centres = np.linspace(0, 1, count)
        width = 1.0 / max(count - 1, 1)
        table = np.exp(-0.5 * ((x[:, None] - centres) / width) ** 2)
        out = table if out is None else (out[:, :, None] * table[:, None, :]).reshape(len(x), -1)
    return out


def periods(v: np.ndarray, oversample: float = 3.0, limit: int = 900) -> list[float]:
    """Periods to try on positions v: from the span down to 2.5 mm, or to twice the step of a regular grid."""
    values = np.unique(np.round(v, 4))
    if len(values) < 6:
        return []
    gaps = np.diff(values)
    span = float(np.ptp(values))
    regular = float(np.ptp(gaps)) < 0.02 * float(gaps.mean())
    shortest = 2.0 * float(gaps.mean()) if regular else max(2.5, span / 300)
    high, low = 1 / shortest, (0.4 if regular else 1.25) / span
    count = int(min(limit, max(0, (high - low) * span * oversample)))
    return [float(1 / f) for f in np.linspace(low, high, count)] if count else []


def geometric(low: float, high: float, count: int) -> list[float]:
    """`count` values from low to high in equal ratios."""
    return [float(v) for v in np.geomspace(low, high, count)]
