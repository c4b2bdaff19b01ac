# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shapley effects of Y = TᵀWT for correlated normal inputs: the share of V(Y) that each group of errors contributes.

With X ~ N(mu, Sigma), Y = XᵀAX, A = OmegaᵀW Omega and C_u = Sigma_.u Sigma_u⁺ Sigma_u. (the covariance explained by the
errors u), V(E[Y|X_u]) = 2 tr((W M_u)²) + 4 tᵀ M_u t  with  M_u = Omega C_u Omegaᵀ (3x3) and t = W Omega mu.
The value of a group is its mean gain over all orders in which groups can become known (Owen 2014; Song, Nelson & Staum
2016); they add up to V(Y).  For independent inputs this is (S + S^T)/2 of each, since nothing exists above pairs.
"""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass

import numpy as np

from ..messages import Refused

MOST_GROUPS = 12  # 4096 subsets
NEGATIVE = 1e-10  # of the largest eigenvalue: a covariance may be this far from positive by rounding


@dataclass(frozen=True)
class Shares:
    """shares (P, G), adding to 1 where V(Y) > 0; first (P, G): V(E[Y|X_g])/V; total (P, G): 1 - V(E[Y|X_~g])/V; mean
    and variance (P,): E[Y], V(Y)."""

    shares: np.ndarray
    first: np.ndarray
    total: np.ndarray
    mean: np.ndarray
    variance: np.ndarray


def checked_covariance(covariance, inputs: int, where: str = "covariance") -> np.ndarray:
    """(n, n) symmetric covariance; refuses a matrix that is none, with the nearest remedy."""
    covariance = np.asarray(covariance, dtype=float)
    if covariance.shape != (inputs, inputs):
        raise Refused("covariance-shape", where, shape=str(covariance.shape), inputs=inputs)
    if not np.all(np.isfinite(covariance)):
        raise Refused("covariance-not-finite", where)
    size = float(np.abs(covariance).max(initial=0.0))
    difference = float(np.abs(covariance - covariance.T).max(initial=0.0))
    if difference > 1e-9 * size:
        i, j = np.unravel_index(np.argmax(np.abs(covariance - covariance.T)), covariance.shape)
        raise Refused("covariance-not-symmetric", where, row=int(i) + 1, column=int(j) + 1)
    covariance = (covariance + covariance.T) / 2
    deviation = np.sqrt(np.maximum(np.diag(covariance), 0.0))
    for i in range(inputs):
        if covariance[i, i] < 0:
            raise Refused("covariance-negative-variance", where, row=i + 1, value=float(covariance[i, i]))
    for i, j in zip(*np.triu_indices(inputs, 1)):
        limit = deviation[i] * deviation[j]
        if abs(covariance[i, j]) > limit * (1 + 1e-9):
            raise Refused(
                "covariance-correlation", where, row=int(i) + 1, column=int(j) + 1,
                value=float(covariance[i, j]), limit=float(limit),
            )  # fmt: skip
    scale = np.where(deviation > 0, deviation, 1.0)
    lowest = float(np.linalg.eigvalsh(covariance / np.outer(scale, scale))[0]) if inputs else 0.0
    if lowest < -NEGATIVE * max(inputs, 1):
        raise Refused("covariance-not-positive", where, lowest=lowest, shrink=1 / (1 - lowest))
    return covariance


def _told(covariance: np.ndarray, members) -> np.ndarray:
    """(n, k) a root of C_u, the covariance of E[X | X_u]: C_u is it times its transpose."""
    block = covariance[np.ix_(members, members)]
    deviation = np.sqrt(np.diag(block))
    scale = np.where(deviation > 0, deviation, 1.0)
    correlation, across = block / np.outer(scale, scale), covariance[:, members] / scale
    try:
        lower = np.linalg.cholesky(correlation)
        if lower.diagonal().min(initial=1.0) > 1e-5:
            return np.linalg.solve(lower, across.T).T
    except np.linalg.LinAlgError:
        pass
    values, vectors = np.linalg.eigh(correlation)  # singular: errors that follow each other exactly
    keep = values > 1e-12 * max(values[-1], 0.0)
    return across @ (vectors[:, keep] / np.sqrt(values[keep]))


def gaussian_shares(omega, mean, covariance, groups, weights=None, beside: int | None = None) -> Shares:
    """Shapley effects of groups of correlated normal errors for Y = sum_a w_a T_a².

    omega : (P, 3, n) or (3, n).  mean : (n,).  covariance : (n, n).  groups : lists of columns that partition the
    inputs, at most MOST_GROUPS.  weights : (3,), default ones.  beside : number of a group that is known before all
    others or after all of them, each in half of the orders: the others then divide among them what they have together
    (Owen 1977, a union of players).
    """
    omega = np.asarray(omega, dtype=float)
    omega = omega[None] if omega.ndim == 2 else omega
    count, rows, n = omega.shape
    groups = [list(g) for g in groups]
    if sorted(i for g in groups for i in g) != list(range(n)):
        raise Refused("groups-no-partition", "groups", inputs=n)
    if len(groups) > MOST_GROUPS:
        raise Refused("groups-too-many", "groups", count=len(groups), most=MOST_GROUPS)
    covariance, mean = checked_covariance(covariance, n), np.asarray(mean, dtype=float)
    root = np.ones(rows) if weights is None else np.sqrt(np.asarray(weights, dtype=float))
    w = root[None, :, None] * omega  # W½ Omega
    middle = w @ mean  # (P, rows)
    g = len(groups)
    worth = np.zeros((1 << g, count))
    for mask in range(1, 1 << g):
        members = [i for k in range(g) if mask >> k & 1 for i in groups[k]]
        root = w @ _told(covariance, members)
        m = root @ root.transpose(0, 2, 1)
        along = np.einsum("pa,pak->pk", middle, root)
        worth[mask] = 2 * np.einsum("pab,pab->p", m, m) + 4 * np.einsum("pk,pk->p", along, along)
    variance = worth[-1]
    shares = _shapley(worth, list(range(g)), count) if beside is None else _union(worth, beside, count)
    with np.errstate(divide="ignore"):
        scale = np.where(variance > 0, 1 / variance, 0.0)[:, None]
    everything = (1 << g) - 1
    first = np.stack([worth[1 << k] for k in range(g)], axis=1) * scale
    total = (variance[:, None] - np.stack([worth[everything ^ (1 << k)] for k in range(g)], axis=1)) * scale
    expected = np.einsum("pai,ij,paj->p", w, covariance, w, optimize=True) + (middle**2).sum(axis=1)
    return Shares(shares * scale, first, total, expected, variance)


def _shapley(worth, players, count: int) -> np.ndarray:
    """(count, len(players)) Shapley values.  worth : of every set of groups, as bits, (2^g, count)."""
    out, g = np.zeros((count, len(players))), len(players)
    for size in range(g):
        weight = math.factorial(size) * math.factorial(g - size - 1) / math.factorial(g)
        for chosen in itertools.combinations(range(g), size):
            mask = sum(1 << players[k] for k in chosen)
            for k in set(range(g)) - set(chosen):
                out[:, k] += weight * (worth[mask | 1 << players[k]] - worth[mask])
    return out


def _union(worth, beside: int, count: int) -> np.ndarray:
    """(count, g) shares where all groups but `beside` are one union of players."""
    g = len(worth).bit_length() - 1
    members = [k for k in range(g) if k != beside]
    game = worth.copy()
    for mask in range(1 << g):
        if not mask >> beside & 1:
            game[mask] = (worth[mask] + worth[mask | 1 << beside] - worth[1 << beside]) / 2
    out = np.zeros((count, g))
    out[:, members] = _shapley(game, members, count)
    out[:, beside] = worth[-1] - out.sum(axis=1)
    return out
