# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exact variance-based indices of Y = TᵀWT with T = Omega X, X independent (Park & Yang 2012, corrected).

Y = XᵀAX with A = OmegaᵀW Omega, X = mu + U, b = 2 A mu:
V_i = b_i² var_i + A_ii² (fourth_i - var_i²) + 2 b_i A_ii third_i,  V_ij = 4 A_ij² var_i var_j,  V = sum V_i + sum V_ij,
and nothing of higher order.  With M = Omega diag(var) Omegaᵀ (3x3), sum_j A_ij² var_j = Omega_iᵀ W M W Omega_i, so A is
never formed and the cost is linear in the number of errors.  The paper's own eq. (18) is kept, for comparison only.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .distributions import Moments
from .refusal import Refused

CHUNK = 4096  # positions at a time: the working set stays in cache


@dataclass(frozen=True)
class Indices:
    """Indices at P positions: `first`, `total` (P, n); `mean` = E[Y] and `variance` = V(Y) (P,).

    Where V(Y) = 0 every index is 0.  Units of mean and variance follow Omega (mm², mm⁴ for Y = |T|²).
    """

    first: np.ndarray
    total: np.ndarray
    mean: np.ndarray
    variance: np.ndarray


def _stack(omega, inputs: int) -> np.ndarray:
    """(P, rows, n) of (P, rows, n) or (rows, n); refuses another number of columns than there are inputs."""
    omega = np.asarray(omega, dtype=float)
    if omega.ndim == 2:
        omega = omega[None]
    if omega.ndim != 3 or omega.shape[2] != inputs:
        raise Refused("omega-shape", "Omega", shape=str(omega.shape), inputs=inputs)
    return omega


def _root_weights(weights, rows: int):
    """(rows, 1, 1) square roots of the weights, or None where all are one."""
    if weights is None:
        return None
    weights = np.asarray(weights, dtype=float)
    if weights.shape != (rows,) or not np.all(np.isfinite(weights)) or np.any(weights < 0):
        raise Refused("weights-not-finite", "weights")
    if not weights.any():
        raise Refused("weights-all-zero", "weights")
    return None if np.all(weights == 1) else np.sqrt(weights)[:, None, None]


def _blocks(omega, weights):
    """Yield (slice of positions, weighted Omega of that slice as (rows, n, size)), at most CHUNK positions each.

    The positions are last and contiguous: a view where Omega is laid out so (see `synthesis.omega`), else a copy.
    """
    root = _root_weights(weights, omega.shape[1])
    positions_last = omega.transpose(1, 2, 0)
    for start in range(0, len(omega), CHUNK):
        block = slice(start, min(start + CHUNK, len(omega)))
        w = positions_last[:, :, block]
        if root is not None:
            w = root * w
        yield block, (w if w.strides[2] == w.itemsize else np.ascontiguousarray(w))


def _reciprocal(variance):
    """1/V, and 0 where nothing varies: every index is 0 there."""
    with np.errstate(divide="ignore"):
        return np.where(variance > 0, 1 / variance, 0.0)


def indices(omega, moments: Moments, weights=None) -> Indices:
    """First-order and total indices of every error for Y = sum_a w_a T_a².

    omega : (P, 3, n) or (3, n).  moments : of the n inputs.  weights : (3,), default ones.

    Written for 10^6 positions: with the products P_ab = Omega_a Omega_b (a <= b), formed once per block,
    A_ii = sum_a P_aa, M_ab = sum_i var_i P_ab,i and sum_j A_ij² var_j = sum_ab M_ab P_ab,i; and since
    sum_i var_i sum_j A_ij² var_j = |M|², V(Y) is known before any index is, so each index is written once.
    """
    omega = _stack(omega, len(moments.var))
    count, rows, n = omega.shape
    first, total = np.empty((n, count)), np.empty((n, count))
    mean, variance = np.empty(count), np.empty(count)
    var = moments.var
    excess = moments.fourth - var**2  # V(U²)
    # V_i (centred) + sum_{j != i} V_ij = 4 var_i [sum_j A_ij² var_j + A_ii² (excess_i/(4 var_i) - var_i)]
    own = np.divide(excess, 4 * var, out=np.zeros(n), where=var > 0) - var
    centred = not moments.mean.any()

    pairs = [(a, a) for a in range(rows)] + [(a, b) for a in range(rows) for b in range(a + 1, rows)]
    occurs = np.array([1.0 if a == b else 2.0 for a, b in pairs])[:, None]  # P_ab stands for P_ba too
    size = 0
    for block, w in _blocks(omega, weights):
        if w.shape[2] != size:  # the first block, and the last one where it is shorter
            size = w.shape[2]
            planes, factors = np.empty((len(pairs) + 1, n, size)), np.empty((len(pairs) + 1, size))
            squared, bracket = np.empty((n, size)), np.empty((n, size))
            products, diagonal = planes[:-1], planes[:rows].reshape(rows, -1)
        for k, (a, b) in enumerate(pairs):
            np.multiply(w[a], w[b], out=products[k])
        np.matmul(np.ones(rows), diagonal, out=squared.reshape(-1))  # A_ii
        m = np.matmul(var, products)  # (pairs, size)
        mean[block] = m[:rows].sum(axis=0)
        linear = 0.0
        if not centred:
            middle = np.matmul(moments.mean, w)
            b = 2 * np.einsum("ap,anp->np", middle, w)
            linear = b * (b * var[:, None] + 2 * squared * moments.third[:, None])
            mean[block] += (middle**2).sum(axis=0)
        np.multiply(squared, squared, out=squared)  # A_ii²
        v = (excess - 2 * var**2) @ squared + 2 * (m * m * occurs).sum(axis=0)
        if not centred:
            v += linear.sum(axis=0)
        variance[block] = v
        scale = _reciprocal(v)
        factors[:-1], factors[-1] = m * occurs * scale, scale
        np.multiply(squared, own[:, None], out=planes[-1])
        np.einsum("kp,knp->np", factors, planes, out=bracket)
        np.multiply(bracket, 4 * var[:, None], out=total[:, block])
        squared *= scale
        np.multiply(squared, excess[:, None], out=first[:, block])
        if not centred:
            linear *= scale
            first[:, block] += linear
            total[:, block] += linear
    return Indices(first.T, total.T, mean, variance)


def _scatter(w, var) -> np.ndarray:
    """(rows, rows, P) M = sum_i var_i Omega_i Omega_iᵀ."""
    return np.einsum("anp,bnp->abp", w * var[:, None], w)


def group_indices(omega, moments: Moments, groups, weights=None) -> Indices:
    """Closed first-order and total indices of groups of errors (a group counts every V_i and V_ij it touches once).

    groups : list of G index lists.  Returns `first`, `total` of shape (P, G); `first` is V(E(Y|X_group))/V.
    """
    omega = _stack(omega, len(moments.var))
    count = len(omega)
    groups = [list(g) for g in groups]
    first, total = np.empty((count, len(groups))), np.empty((count, len(groups)))
    mean, variance = np.empty(count), np.empty(count)
    var, excess = moments.var, moments.fourth - moments.var**2
    for block, w in _blocks(omega, weights):
        squared = np.einsum("anp,anp->np", w, w)
        middle = np.matmul(moments.mean, w)
        b = 2 * np.einsum("ap,anp->np", middle, w)
        single = b * (b * var[:, None] + 2 * squared * moments.third[:, None]) + squared**2 * excess[:, None]
        own = (squared * var[:, None]) ** 2
        m = _scatter(w, var)
        pairs = 2 * (np.einsum("abp,abp->p", m, m) - own.sum(axis=0))
        variance[block] = v = single.sum(axis=0) + pairs
        mean[block] = np.einsum("aap->p", m) + (middle**2).sum(axis=0)
        scale = _reciprocal(v)
        for g, members in enumerate(groups):
            part = _scatter(w[:, members], var[members])
            inside = 2 * (np.einsum("abp,abp->p", part, part) - own[members].sum(axis=0))
            across = 4 * np.einsum("abp,abp->p", part, m - part)
            alone = single[members].sum(axis=0) + inside
            first[block, g] = alone * scale
            total[block, g] = (alone + across) * scale
    return Indices(first, total, mean, variance)


def signed_indices(omega, moments: Moments, weights) -> Indices:
    """Indices of the signed linear output Y = sum_a w_a T_a: S = S^T and they add to one.

    weights : (3,), any sign.  mean and variance in mm and mm².
    """
    omega = _stack(omega, len(moments.var))
    weights = np.asarray(weights, dtype=float)
    if weights.shape != (omega.shape[1],) or not np.all(np.isfinite(weights)) or not weights.any():
        raise Refused("weights-signed-invalid", "weights")
    row = np.einsum("pan,a->pn", omega, weights)
    parts = row**2 * moments.var
    variance = parts.sum(axis=1)
    share = parts * _reciprocal(variance)[:, None]
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
