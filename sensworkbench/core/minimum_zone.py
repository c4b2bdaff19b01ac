# SPDX-License-Identifier: LGPL-2.1-or-later
"""Minimum zones (ISO 1101) of departures that are small beside the feature: exact linear programs, solved by exchange.

With departures d from the nominal feature and the columns B of its free position and size, the zone is the smallest
2 E with |d - B c| <= E.  Its dual chooses a few touching points with weights, Σ y B = 0 and Σ |y| = 1, so that the
width is 2 Σ y d; these weights are also the derivative of the width.  (Chebyshev approximation; Stiefel's exchange is
the simplex method on the dual.)
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

_RANK = 1e-10  # of a column, relative to the largest: below it depends on the others
_PATIENCE = 60  # steps without progress, after which the rule is one that cannot cycle
_MOST = 20_000  # steps
_MOST_DIRECTIONS = 4000  # of a tube


@dataclass(frozen=True)
class Zone:
    """The smallest zone.

    width : of the zone, in the unit of the departures.  points : (k,) rows that touch it.  weights : (k,) or (k, m)
    derivative of the width by the departures of these rows; the width is their sum of products.  fit : (p,)
    coefficients of the free columns in the middle of the zone.
    """

    width: float
    points: np.ndarray
    weights: np.ndarray
    fit: np.ndarray


def independent(columns) -> tuple[np.ndarray, np.ndarray]:
    """(B, back) of columns (n, p): B (n, r) spans the same space with columns of rms 1 that are square to each other,
    and B = columns @ back, (p, r)."""
    columns = np.asarray(columns, dtype=float)
    scale = np.sqrt((columns**2).mean(axis=0))
    scale = np.where(scale > 0, scale, 1.0)
    _, sizes, axes = np.linalg.svd(columns / scale, full_matrices=False)
    keep = sizes > _RANK * sizes.max(initial=0.0)
    back = axes[keep].T / sizes[keep] * np.sqrt(len(columns)) / scale[:, None]
    return columns @ back, back


def smallest_zone(columns, departures) -> Zone:
    """The zone of departures (n,) whose free columns are (n, p): straightness, flatness, roundness, cylindricity."""
    d = np.asarray(departures, dtype=float)
    basis, back = independent(columns)
    n = len(d)
    bound, c, rows, weights = _least_bound(np.concatenate([basis, -basis]), np.concatenate([d, -d]))
    signed = np.where(rows < n, weights, -weights)
    return Zone(2 * bound, rows % n, 2 * signed, back @ c)


def smallest_tube(columns, departures) -> Zone:
    """The diameter of the smallest tube about departures (n, 2) across a line; each direction has its free columns
    (n, p): the straightness of an axis.

    Solved by cutting planes: each step is an exact linear program of the directions found so far.
    """
    d = np.asarray(departures, dtype=float)
    basis, back = independent(columns)
    n, p = basis.shape
    seen = {}
    at = np.argmax(np.hypot(*d.T))
    new = [(int(at), 0.0), (int(at), np.pi)]
    # every step bounds the four sides of some points too, so that the program has a solution
    far, spread = np.argsort(np.hypot(*d.T))[-16:], np.linspace(0, n - 1, 64).astype(int)
    corners = np.union1d(far, spread)
    sides = np.repeat([(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)], len(corners), axis=0)
    while True:
        for i, angle in new:
            seen[i, angle] = (np.cos(angle), np.sin(angle))
        u = np.concatenate([list(seen.values()), sides])
        places = np.concatenate([[i for i, _ in seen], np.tile(corners, 4)])
        rows = np.concatenate([u[:, :1] * basis[places], u[:, 1:] * basis[places]], axis=1)
        radius, c, used, weights = _least_bound(rows, (u * d[places]).sum(axis=1))
        rest = d - np.stack([basis @ c[:p], basis @ c[p:]], axis=1)
        size = np.hypot(*rest.T)
        over = np.flatnonzero(size > radius * (1 + 1e-12) + 1e-300)
        worst = over[np.argsort(size[over])[-8:]]
        new = [(int(i), float(np.arctan2(rest[i, 1], rest[i, 0]))) for i in worst]
        if all(key in seen for key in new) or len(seen) > _MOST_DIRECTIONS:
            return Zone(2 * radius, places[used], 2 * weights[:, None] * u[used], back @ np.stack([c[:p], c[p:]], 1))


def _least_bound(rows: np.ndarray, heights: np.ndarray):
    """(E, c, touching rows, weights) of the least E with heights - rows @ c <= E; rows (k, p), heights (k,).

    Simplex method on the dual: the weights y >= 0 of p + 1 rows with Σ y rows = 0 and Σ y = 1.  It begins with helping
    columns of a high price, which leave.
    """
    p = rows.shape[1]
    largest = float(np.abs(heights).max())
    if largest == 0.0 or p == 0:
        at = int(np.argmax(heights))
        return float(heights[at]), np.zeros(p), np.array([at]), np.array([1.0])
    price = 1e7 * largest
    first = int(np.argmax(heights))
    signs = np.where(rows[first] > 0, -1.0, 1.0)
    matrix = np.zeros((p + 1, p + 1))  # columns of the present choice
    matrix[:p, 0], matrix[p, 0] = rows[first], 1.0
    matrix[np.arange(p), np.arange(1, p + 1)] = signs
    names = np.concatenate([[first], -np.arange(1, p + 1)])  # below zero: helping columns
    cost = np.concatenate([[heights[first]], np.full(p, -price)])
    right = np.zeros(p + 1)
    right[p] = 1.0
    best, since, slack = -np.inf, 0, 4e-14 * largest
    for _ in range(_MOST):
        multipliers = np.linalg.solve(matrix.T, cost)
        weights = np.linalg.solve(matrix, right)
        over = heights - rows @ multipliers[:p] - multipliers[p]
        over[names[names >= 0]] = -np.inf  # of the choice itself: 0 but for rounding
        enter = int(np.argmax(over))
        if over[enter] <= slack:
            break
        value = float(cost @ weights)
        since = 0 if value > best + slack else since + 1
        best = max(best, value)
        if since > _PATIENCE:  # Bland's rule
            enter = int(np.argmax(over > slack))
        column = np.append(rows[enter], 1.0)
        step = np.linalg.solve(matrix, column)
        falls = step > 1e-12 * max(1.0, np.abs(step).max())
        if not falls.any():
            break
        ratio = np.full(p + 1, np.inf)
        ratio[falls] = np.maximum(weights[falls], 0.0) / step[falls]
        ties = np.flatnonzero(ratio <= ratio.min() + 1e-15)
        if since > _PATIENCE:
            leave = ties[np.argmin(names[ties])]
        else:  # a helping column first, else the safest pivot
            helping = ties[names[ties] < 0]
            leave = helping[0] if len(helping) else ties[np.argmax(step[ties])]
        matrix[:, leave], names[leave], cost[leave] = column, enter, heights[enter]
    real = (names >= 0) & (weights > 0)
    bound = float(cost[real] @ weights[real])
    return bound, multipliers[:p], names[real], weights[real]
