# SPDX-License-Identifier: LGPL-2.1-or-later
"""Evidence that respects order: whole blocks left out, half-samples of blocks, sign flips of whole blocks.

Neighbouring readings share slow drifts and roughness, so nothing here ever splits them: a block is a run of readings
taken one after another.  Held-out errors and half-sample fits come from Gram matrices summed per block.
"""

from __future__ import annotations

import numpy as np

from .readings import Readings


def blocks(readings: Readings, target: int = 30) -> np.ndarray:
    """(P,) block number of each point: contiguous in order, never across a run, about `target` in all (8 at least)."""
    count = readings.points
    size = max(4, int(np.ceil(count / target)))
    if readings.run is None:
        label = np.zeros(count, dtype=int)
    else:
        runs = np.array([str(r) for r in readings.run])
        label = np.cumsum(np.r_[0, (runs[1:] != runs[:-1]).astype(int)])
    out = np.empty(count, dtype=int)
    number = 0
    for part in np.unique(label):
        rows = np.flatnonzero(label == part)
        pieces = max(1, round(len(rows) / size))
        out[rows] = number + (np.arange(len(rows)) * pieces) // len(rows)
        number += pieces
    return out


def flips(block: np.ndarray, count: int, seed: int) -> np.ndarray:
    """(count, blocks) signs, one for each whole block: index by the block numbers of rows to turn them."""
    rng = np.random.default_rng(seed)
    return rng.integers(0, 2, size=(count, int(block.max()) + 1), dtype=np.int8) * 2 - 1


def p_value(observed: float, null: np.ndarray) -> float:
    """Share of null maxima at least as large, never below 1/(B + 1)."""
    return float((1 + np.count_nonzero(null >= observed)) / (len(null) + 1))


class BlockGrams:
    """Gram matrices of weighted columns and readings per block.

    x (R, n) weighted columns, y (R,) weighted readings, block (R,) numbers.  Any subset of columns can then be fitted
    without some blocks and evaluated on them.
    """

    def __init__(self, x, y, block, offsets=None):
        """offsets (R, k): columns that are fitted to each block of its own in `held_out_within`."""
        self.count = int(block.max()) + 1
        n = x.shape[1]
        self.gram = np.empty((self.count, n, n))
        self.right = np.empty((self.count, n))
        self.square = np.empty(self.count)
        self.rows = np.bincount(block, minlength=self.count)
        self.within: list[tuple[np.ndarray, np.ndarray, float]] = []
        order = np.argsort(block, kind="stable")
        edges = np.r_[0, np.cumsum(self.rows)]
        for b in range(self.count):
            part = order[edges[b] : edges[b + 1]]
            xb, yb = x[part], y[part]
            self.gram[b], self.right[b], self.square[b] = xb.T @ xb, xb.T @ yb, yb @ yb
            if offsets is not None:
                u, s, _ = np.linalg.svd(offsets[part], full_matrices=False)
                u = u[:, s > 1e-9 * max(float(s.max(initial=0.0)), 1e-300)]
                xb, yb = xb - u @ (u.T @ xb), yb - u @ (u.T @ yb)
                self.within.append((xb.T @ xb, xb.T @ yb, float(yb @ yb)))
        self.scale = np.sqrt(np.maximum(np.einsum("bii->i", self.gram), 1e-300))

    def _solve(self, gram, right, columns):
        scale = self.scale[columns]
        a = gram[np.ix_(columns, columns)] / np.outer(scale, scale)
        values, vectors = np.linalg.eigh(a)
        keep = values > 1e-9 * values[-1]
        v = vectors[:, keep]
        return (v @ ((v.T @ (right[columns] / scale)) / values[keep])) / scale

    def held_out(self, columns) -> np.ndarray:
        """(B,) sum of squared weighted errors of each block, predicted by a fit of all the others."""
        columns = np.asarray(columns)
        total_gram, total_right = self.gram.sum(axis=0), self.right.sum(axis=0)
        out = np.empty(self.count)
        for b in range(self.count):
            beta = self._solve(total_gram - self.gram[b], total_right - self.right[b], columns)
            g = self.gram[b][np.ix_(columns, columns)]
            out[b] = self.square[b] - 2 * beta @ self.right[b][columns] + beta @ g @ beta
        return out

    def held_out_within(self, columns) -> np.ndarray:
        """(B,) the same where each block's own offsets are fitted to it first.

        What a far extrapolation of the model shifts as a whole is no error then; nor is anything that is constant
        within a block.
        """
        columns = np.asarray(columns)
        total_gram, total_right = self.gram.sum(axis=0), self.right.sum(axis=0)
        out = np.empty(self.count)
        for b in range(self.count):
            beta = self._solve(total_gram - self.gram[b], total_right - self.right[b], columns)
            gram, right, square = self.within[b]
            out[b] = square - 2 * beta @ right[columns] + beta @ gram[np.ix_(columns, columns)] @ beta
        return out

    def held_out_told(self, columns, base) -> np.ndarray:
        """(B,) squared errors as in `held_out`, on what the other blocks can tell of a block.

        The directions of a block's readings in which `base`, fitted to the others, predicts with a variance above that
        of the noise are fitted to the block itself first: its own offset and tilt, and far ends of a polynomial.  Take
        the same base where two models are compared.
        """
        columns, base = np.asarray(columns), np.asarray(base)
        total_gram, total_right = self.gram.sum(axis=0), self.right.sum(axis=0)
        scale = self.scale[base]
        out = np.empty(self.count)
        for b in range(self.count):
            beta = self._solve(total_gram - self.gram[b], total_right - self.right[b], columns)
            others = (total_gram - self.gram[b])[np.ix_(base, base)] / np.outer(scale, scale)
            values, vectors = np.linalg.eigh(others)
            root = vectors / np.sqrt(np.maximum(values, 1e-12 * values[-1])) / scale[:, None]
            variance, turn = np.linalg.eigh(root.T @ self.gram[b][np.ix_(base, base)] @ root)
            far = variance > 1.0
            across = ((root @ turn[:, far]) / np.sqrt(variance[far])).T  # rows: unit directions of the block's readings
            x, y = across @ self.gram[b][np.ix_(base, columns)], across @ self.right[b][base]
            gram = self.gram[b][np.ix_(columns, columns)] - x.T @ x
            right = self.right[b][columns] - x.T @ y
            out[b] = self.square[b] - y @ y - 2 * beta @ right + beta @ gram @ beta
        return out

    def half_gain(self, base, columns, use) -> float:
        """Drop of squared error on the other blocks when `columns` join `base`, both fitted on blocks `use` only."""
        gram, right = self.gram[use].sum(axis=0), self.right[use].sum(axis=0)
        rest = np.setdiff1d(np.arange(self.count), use)
        gram_out, right_out = self.gram[rest].sum(axis=0), self.right[rest].sum(axis=0)
        errors = []
        for part in (np.asarray(base), np.asarray([*base, *columns])):
            beta = self._solve(gram, right, part)
            errors.append(-2 * beta @ right_out[part] + beta @ gram_out[np.ix_(part, part)] @ beta)
        return float(errors[0] - errors[1])

    def left_out_coefficients(self) -> list[np.ndarray]:
        """Per block, the coefficients (n,) of a fit of all the others."""
        columns = np.arange(self.gram.shape[1])
        total_gram, total_right = self.gram.sum(axis=0), self.right.sum(axis=0)
        return [self._solve(total_gram - self.gram[b], total_right - self.right[b], columns) for b in range(self.count)]

    def gains(self, base, candidates, use) -> np.ndarray:
        """(S,) drop of chi-square on blocks `use` when each candidate's columns join `base`.

        candidates : list of lists of column numbers.
        """
        base = np.asarray(base)
        gram, right = self.gram[use].sum(axis=0), self.right[use].sum(axis=0)
        scale = self.scale
        a = gram[np.ix_(base, base)] / np.outer(scale[base], scale[base])
        values, vectors = np.linalg.eigh(a)
        keep = values > 1e-9 * values[-1]
        root = (vectors[:, keep] / np.sqrt(values[keep])).T / scale[base]  # rows: whitening of the base
        y = root @ right[base]
        every = np.concatenate([np.asarray(c, dtype=int) for c in candidates])
        z = root @ gram[np.ix_(base, every)]
        r = right[every] - z.T @ y
        square = gram[every, every] - (z**2).sum(axis=0)
        out, at = np.empty(len(candidates)), 0
        for i, columns in enumerate(candidates):
            own = slice(at, at + len(columns))
            at += len(columns)
            if len(columns) == 1:
                out[i] = r[own][0] ** 2 / square[own][0] if square[own][0] != 0 else 0.0
                continue
            g = gram[np.ix_(columns, columns)] - z[:, own].T @ z[:, own]
            out[i] = float(r[own] @ np.linalg.pinv(g, rcond=1e-8, hermitian=True) @ r[own])
        return out


def gain_statistics(without: np.ndarray, with_: np.ndarray) -> tuple[float, float]:
    """(total gain, its standard error) over blocks of held-out squared errors."""
    gain = without - with_
    return float(gain.sum()), float(np.sqrt(len(gain)) * gain.std(ddof=1)) if len(gain) > 1 else float("inf")


def no_worse(errors: np.ndarray, best: np.ndarray, within: float) -> bool:
    """Are held-out squared errors (B,) within some standard errors of the best ones?"""
    loss, spread = gain_statistics(errors, best)
    return loss <= within * spread
