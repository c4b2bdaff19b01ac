# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exact variance-based indices of Y = TᵀWT with T = Omega X, X independent (Park & Yang 2012, corrected).

Y = XᵀAX with A = OmegaᵀW Omega, X = mu + U, b = 2 A mu:
V_i = b_i² var_i + A_ii² (fourth_i - var_i²) + 2 b_i A_ii third_i,   V_ij = 4 A_ij² var_i var_j,   V = sum V_i + sum V_ij,
and nothing of higher order.  With M = Omega diag(var) Omegaᵀ (3x3), sum_j A_ij² var_j = Omega_iᵀ W M W Omega_i, so A is
never formed and the cost is linear in the number of errors.  The paper's own eq. (18) is kept, for comparison only.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .distributions import Moments
from .refusal import Refused

CHUNK = 2048  # positions at a time: the working set stays in cache


@dataclass(frozen=True)
class Indices:
    """Indices at P positions: `first`, `total` (P, n); `mean` = E[Y] and `variance` = V(Y) (P,).

    Where V(Y) = 0 every index is 0.  Units of mean and variance follow Omega (mm², mm⁴ for Y = |T|²).
    """

    first: np.ndarray
    total: np.ndarray
    mean: np.ndarray
    variance: np.ndarray


def _weighted(omega, weights) -> np.ndarray:
    """(3, n, P) view of Omega scaled by the square root of the weights."""
    omega = np.asarray(omega, dtype=float)
    if omega.ndim == 2:
        omega = omega[None]
    weights = np.ones(omega.shape[1]) if weights is None else np.asarray(weights, dtype=float)
    if weights.shape != (omega.shape[1],) or not np.all(np.isfinite(weights)) or np.any(weights < 0):
        raise Refused("weights must be finite and not negative, one per component", "weights")
    if not weights.any():
        raise Refused("all weights are zero: nothing is left of the objective", "weights", "Keep one component.")
    view = omega.transpose(1, 2, 0)
    return view if np.all(weights == 1) else np.sqrt(weights)[:, None, None] * view


def _safe(numerator, variance):
    with np.errstate(divide="ignore", invalid="ignore"):
        out = numerator / variance
    return np.where(variance > 0, out, 0.0)


def indices(omega, moments: Moments, weights=None) -> Indices:
    """First-order and total indices of every error for Y = sum_a w_a T_a².

    omega : (P, 3, n) or (3, n).  moments : of the n inputs.  weights : (3,), default ones.
    """
    a = _weighted(omega, weights)
    rows, n, count = a.shape
    first, total = np.empty((n, count)), np.empty((n, count))
    mean, variance = np.empty(count), np.empty(count)
    var = moments.var[:, None]
    excess = (moments.fourth - moments.var**2)[:, None]
    centred = not moments.mean.any()
    skewed = bool(moments.third.any())
    for start in range(0, count, CHUNK):
        block = slice(start, start + CHUNK)
        w = np.ascontiguousarray(a[:, :, block])
        squared = np.einsum("anp,anp->np", w, w)  # A_ii
        scaled = w * var
        m = np.einsum("anp,bnp->abp", scaled, w)
        spread = np.zeros_like(squared)  # sum_j A_ij² var_j
        for i in range(rows):
            half = np.einsum("bp,bnp->np", m[i], w)
            spread += half * w[i]
        own = squared * squared
        interaction = (spread - own * var) * (4 * var)
        single = own * excess
        trace = np.einsum("aap->p", m)
        if not centred:
            t = np.einsum("anp,n->ap", w, moments.mean)
            b = 2 * np.einsum("anp,ap->np", w, t)
            single = single + b * b * var
            if skewed:
                single = single + 2 * b * squared * moments.third[:, None]
            trace = trace + np.einsum("ap,ap->p", t, t)
        v = single.sum(axis=0) + 0.5 * interaction.sum(axis=0)
        scale = np.where(v > 0, 1 / np.where(v > 0, v, 1.0), 0.0)
        np.multiply(single, scale, out=first[:, block])
        single += interaction
        np.multiply(single, scale, out=total[:, block])
        mean[block], variance[block] = trace, v
    return Indices(first.T, total.T, mean, variance)


def group_indices(omega, moments: Moments, groups, weights=None) -> Indices:
    """Closed first-order and total indices of groups of errors (a group counts every V_i and V_ij it touches once).

    groups : list of G index lists.  Returns `first`, `total` of shape (P, G); `first` is V(E(Y|X_group))/V.
    """
    a = _weighted(omega, weights)
    count = a.shape[2]
    var = moments.var[:, None]
    squared = np.einsum("anp,anp->np", a, a)
    m = np.einsum("anp,bnp->abp", a * var, a)
    t = np.einsum("anp,n->ap", a, moments.mean)
    b = 2 * np.einsum("anp,ap->np", a, t)
    single = b * b * var + squared**2 * (moments.fourth - moments.var**2)[:, None]
    single += 2 * b * squared * moments.third[:, None]
    own = (squared * var) ** 2
    all_pairs = 2 * (np.einsum("abp,abp->p", m, m) - own.sum(axis=0))
    variance = single.sum(axis=0) + all_pairs
    first, total = np.empty((count, len(groups))), np.empty((count, len(groups)))
    for g, members in enumerate(groups):
        members = list(members)
        part = np.einsum("anp,bnp->abp", a[:, members] * var[members], a[:, members])
        inside = 2 * (np.einsum("abp,abp->p", part, part) - own[members].sum(axis=0))
        across = 4 * np.einsum("abp,abp->p", part, m - part)
        alone = single[members].sum(axis=0) + inside
        first[:, g] = _safe(alone, variance)
        total[:, g] = _safe(alone + across, variance)
    mean = np.einsum("aap->p", m) + np.einsum("ap,ap->p", t, t)
    return Indices(first, total, mean, variance)


def signed_indices(omega, moments: Moments, weights) -> Indices:
    """Indices of the signed linear output Y = sum_a w_a T_a: S = S^T and they add to one.

    weights : (3,), any sign.  mean and variance in mm and mm².
    """
    omega = np.asarray(omega, dtype=float)
    if omega.ndim == 2:
        omega = omega[None]
    row = np.einsum("pan,a->pn", omega, np.asarray(weights, dtype=float))
    parts = row**2 * moments.var
    variance = parts.sum(axis=1)
    share = _safe(parts, variance[:, None])
    return Indices(share, share.copy(), row @ moments.mean, variance)


def signed_group_indices(omega, moments: Moments, groups, weights) -> Indices:
    """`signed_indices` of groups: sums of the members' shares."""
    single = signed_indices(omega, moments, weights)
    share = np.stack([single.first[:, list(g)].sum(axis=1) for g in groups], axis=1)
    return Indices(share, share.copy(), single.mean, single.variance)


# -- the paper as printed, for comparison only -------------------------------------------------------------------
def paper_power_moments(coefficients, lower, upper) -> np.ndarray:
    """(4,) E[(sum Omega_i X_i)^l], l = 1..4, by the paper's H and G recursions (eqs. 9-13), X_i uniform.

    These are right, and serve as a cross-check of the four moments.
    """
    coefficients, lower, upper = (np.asarray(x, dtype=float) for x in (coefficients, lower, upper))
    g = np.zeros(5)  # G^0..G^4 of the empty sum
    g[0] = 1.0
    for c, low, up in zip(coefficients[::-1], lower[::-1], upper[::-1]):
        h = [c**j * sum(up ** (j - p) * low**p for p in range(j + 1)) for j in range(5)]
        g = np.array(
            [
                1.0,
                h[1] / 2 + g[1],
                h[2] / 3 + h[1] * g[1] + g[2],
                h[3] / 4 + h[2] * g[1] + 1.5 * h[1] * g[2] + g[3],
                h[4] / 5 + h[3] * g[1] + 2 * h[2] * g[2] + 2 * h[1] * g[3] + g[4],
            ]
        )
    return g[1:]


def paper_eq18(omega, lower, upper) -> tuple[np.ndarray, float]:
    """Eq. (18) exactly as printed: ("S^T" (n,), V(Y) by eq. (15a)).  For comparison only: it is wrong three times.

    It subtracts V(E(Y|X_j)) where V(E(Y|X_~j)) belongs, drops the covariances of T4², T5², T6², and lacks the factor 2
    of the cross term in (16a).  omega : (3, n); lower, upper : (n,) limits of uniform inputs.
    """
    omega, lower, upper = (np.asarray(x, dtype=float) for x in (omega, lower, upper))
    n = omega.shape[1]
    variance, numerator = 0.0, np.zeros(n)
    for row in omega:
        g = paper_power_moments(row, lower, upper)
        variance += g[3] - g[1] ** 2
        for j in range(n):
            rest = np.arange(n) != j
            g1 = paper_power_moments(row[rest], lower[rest], upper[rest])[0]
            own = paper_power_moments(row[[j]], lower[[j]], upper[[j]])
            numerator[j] += own[3] - own[1] ** 2 + g1**2 * (own[1] - own[0] ** 2) + 2 * g1 * (own[2] - own[0] * own[1])
    return 1 - numerator / variance, float(variance)
