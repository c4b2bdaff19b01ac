# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moments of the tolerances, by integration of their densities, and indices from the matrix A written out in full.

Y = XᵀAX (or the sum aᵀX of a signed objective), X = mu + U independent.  E(Y | X_i) is a polynomial of degree 2 in U_i,
whose variance needs four moments; U_i U_j with i < j are the only other terms.
"""

from __future__ import annotations

from mpmath import mp, mpf

SIZES = {"um": mpf(1), "mm": mpf(1000), "nm": mpf(1) / 1000, "urad": mpf(1), "mrad": mpf(1000), "rad": mpf(10) ** 6}


def size_of(unit):
    """um or urad per unit."""
    if unit == "arcsec":
        return mp.pi / 648000 * 10**6
    return SIZES[unit]


def moments(tolerance):
    """(mean, variance, third, fourth central moment) in um or urad, from the density."""
    scale = size_of(tolerance["unit"])
    low, high = tolerance["lower"] * scale, tolerance["upper"] * scale
    middle, half = (low + high) / 2, (high - low) / 2
    law = tolerance.get("distribution", "uniform")
    if half == 0 or law == "point":
        return middle, mpf(0), mpf(0), mpf(0)
    if law == "u_shaped":  # x = half sin t, t uniform
        return (middle, *(mp.quad(lambda t, k=k: (half * mp.sin(t)) ** k / mp.pi, [-mp.pi / 2, 0, mp.pi / 2])
                          for k in (2, 3, 4)))  # fmt: skip
    sigma = tolerance["sigma"] * scale if "sigma" in tolerance else half / (3 if law == "normal" else 2)
    density = {
        "uniform": lambda x: mpf(1),
        "triangular": lambda x: 1 - abs(x),
        "normal": lambda x: mp.exp(-((x * half / sigma) ** 2) / 2),
        "truncated_normal": lambda x: mp.exp(-((x * half / sigma) ** 2) / 2),
    }[law]
    reach = mpf(18) * sigma / half if law == "normal" else mpf(1)  # exp(-162) is below 1e-70
    cuts = [reach * i / 4 for i in range(-4, 5)]
    mass = mp.quad(density, cuts)
    central = [mp.quad(lambda x, k=k: x**k * density(x), cuts) / mass * half**k for k in (2, 3, 4)]
    return (middle, *central)


class Objective:
    """Y at one position: `weights` of the components of T or R; `signed`: their sum, else the sum of squares."""

    def __init__(self, columns, laws, weights, signed):
        n = len(columns)
        self.mean, var, third, fourth = (list(v) for v in zip(*laws))
        if signed:
            row = [sum(w * c for w, c in zip(weights, column)) for column in columns]
            self.single = [r * r * v for r, v in zip(row, var)]
            self.pair = {}
            self.expected = sum(r * m for r, m in zip(row, self.mean))
        else:
            a = [[sum(w * x * y for w, x, y in zip(weights, columns[i], columns[j])) for j in range(n)]
                 for i in range(n)]  # fmt: skip
            b = [2 * sum(a[i][j] * self.mean[j] for j in range(n)) for i in range(n)]
            self.single = [
                b[i] ** 2 * var[i] + 2 * b[i] * a[i][i] * third[i] + a[i][i] ** 2 * (fourth[i] - var[i] ** 2)
                for i in range(n)
            ]
            self.pair = {(i, j): (2 * a[i][j]) ** 2 * var[i] * var[j] for i in range(n) for j in range(i)}
            self.expected = sum(b[i] * self.mean[i] / 2 + a[i][i] * var[i] for i in range(n))
        self.variance = sum(self.single) + sum(self.pair.values())

    def each(self):
        """(first-order, total) index of every error."""
        touching = list(self.single)
        for (i, j), v in self.pair.items():
            touching[i] += v
            touching[j] += v
        return [(s / self.variance, t / self.variance) for s, t in zip(self.single, touching)]

    def group(self, members):
        """(closed first-order, total) index of a set of errors."""
        inside, members = mpf(0), set(members)
        touching = alone = sum(self.single[i] for i in members)
        for (i, j), v in self.pair.items():
            if i in members and j in members:
                inside += v
            if i in members or j in members:
                touching += v
        return (alone + inside) / self.variance, touching / self.variance
