# SPDX-License-Identifier: LGPL-2.1-or-later
"""The least squares of the fit against certified values: NIST StRD linear regression sets, and GUM example H.3.

The data and certified values are those of NIST's Statistical Reference Datasets (public domain) and of JCGM 100:2008,
H.3.  What the fit calls determined agrees to nine digits; what it cannot determine at its condition limit, it says.
"""

from __future__ import annotations

import numpy as np
import pytest

from sensworkbench.closedloop.fit import RANK_TOLERANCE, basis, solution

LONGLEY = np.array([
    [60323, 83.0, 234289, 2356, 1590, 107608, 1947], [61122, 88.5, 259426, 2325, 1456, 108632, 1948],
    [60171, 88.2, 258054, 3682, 1616, 109773, 1949], [61187, 89.5, 284599, 3351, 1650, 110929, 1950],
    [63221, 96.2, 328975, 2099, 3099, 112075, 1951], [63639, 98.1, 346999, 1932, 3594, 113270, 1952],
    [64989, 99.0, 365385, 1870, 3547, 115094, 1953], [63761, 100.0, 363112, 3578, 3350, 116219, 1954],
    [66019, 101.2, 397469, 2904, 3048, 117388, 1955], [67857, 104.6, 419180, 2822, 2857, 118734, 1956],
    [68169, 108.4, 442769, 2936, 2798, 120445, 1957], [66513, 110.8, 444546, 4681, 2637, 121950, 1958],
    [68655, 112.6, 482704, 3813, 2552, 123366, 1959], [69564, 114.2, 502601, 3931, 2514, 125368, 1960],
    [69331, 115.7, 518173, 4806, 2572, 127852, 1961], [70551, 116.9, 554894, 4007, 2827, 130081, 1962],
])  # fmt: skip
PONTIUS = np.array([
    .11019, .21956, .32949, .43899, .54803, .65694, .76562, .87487, .98292, 1.09146, 1.20001, 1.30822, 1.41599, 1.52399,
    1.63194, 1.73947, 1.84646, 1.95392, 2.06128, 2.16844, .11052, .22018, .32939, .43886, .54798, .65739, .76596,
    .87474, .98300, 1.09150, 1.20004, 1.30818, 1.41613, 1.52408, 1.63159, 1.73965, 1.84696, 1.95445, 2.06177, 2.16829,
])  # fmt: skip
LOAD = np.tile(150000.0 * np.arange(1, 21), 2)
X = np.arange(21.0)
# what Wampler added to the quintic of set 1 in sets 3, 4 (times 100) and 5 (times 10,000)
ADDED = np.array([
    759, -2048, 2048, -2048, 2523, -2048, 2048, -2048, 1838, -2048, 2048, -2048, 1838, -2048, 2048, -2048, 2523, -2048,
    2048, -2048, 759.0,
])  # fmt: skip
QUINTIC = X[:, None] ** np.arange(6)
SD_3 = np.array([2152.32624678170, 2363.55173469681, 779.343524331583, 101.475507550350, 5.64566512170752,
                 0.112324854679312])  # fmt: skip

SETS = {
    "Longley": (
        np.column_stack([np.ones(16), LONGLEY[:, 1:]]), LONGLEY[:, 0],
        [-3482258.63459582, 15.0618722713733, -0.358191792925910e-1, -2.02022980381683, -1.03322686717359,
         -0.511041056535807e-1, 1829.15146461355],
        [890420.383607373, 84.9149257747669, 0.334910077722432e-1, 0.488399681651699, 0.214274163161675,
         0.226073200069370, 455.478499142212], 9,
    ),
    "NoInt1": (np.arange(60.0, 71)[:, None], np.arange(130.0, 141), [2.07438016528926], [0.165289256198347e-1], 9),
    "NoInt2": (np.arange(4.0, 7)[:, None], np.array([3.0, 4, 4]), [0.727272727272727], [0.420827318078432e-1], 9),
    "Pontius": (
        LOAD[:, None] ** np.arange(3), PONTIUS,
        [0.673565789473684e-3, 0.732059160401003e-6, -0.316081871345029e-14],
        [0.107938612033077e-3, 0.157817399981659e-9, 0.486652849992036e-16], 9,
    ),
    "Wampler1": (QUINTIC, QUINTIC.sum(axis=1), np.ones(6), np.zeros(6), 9),
    "Wampler2": (QUINTIC, QUINTIC @ 0.1 ** np.arange(6), 0.1 ** np.arange(6), np.zeros(6), 9),
    "Wampler3": (QUINTIC, QUINTIC.sum(axis=1) + ADDED, np.ones(6), SD_3, 9),
    "Wampler4": (QUINTIC, QUINTIC.sum(axis=1) + 100 * ADDED, np.ones(6), 100 * SD_3, 9),
    "Wampler5": (QUINTIC, QUINTIC.sum(axis=1) + 1e4 * ADDED, np.ones(6), 1e4 * SD_3, 9),
}  # fmt: skip


def fitted(matrix, y):
    """Coefficients and their standard uncertainties as the fit computes them."""
    b = basis(matrix)
    coefficients = solution(b, matrix, y)
    residual = y - matrix @ coefficients
    spread = np.sqrt((residual**2).sum() / max(len(y) - matrix.shape[1], 1))
    u = spread * np.sqrt(((b.v / b.s) ** 2).sum(axis=1)) / b.scale
    return b, coefficients, u, spread


def digits(found, certified) -> float:
    """Correct significant digits, NIST's log relative error, of the worst value."""
    certified = np.asarray(certified, dtype=float)
    error = np.abs(found - certified) / np.where(certified == 0, 1, np.abs(certified))
    return float(-np.log10(max(error.max(), 1e-16)))


@pytest.mark.parametrize("name", SETS)
def test_certified_values_are_met_to_nine_digits(name):
    matrix, y, coefficients, deviations, wanted = SETS[name]
    b, found, u, _ = fitted(matrix, y)
    assert b.rank == matrix.shape[1]
    assert digits(found, coefficients) >= wanted
    if np.any(deviations):
        assert digits(u, deviations) >= wanted
    else:
        assert np.abs(u).max() < 1e-6


def test_the_data_typed_here_are_nists():
    """Wampler's additions keep the coefficients at one only if they are orthogonal to all powers to the fifth."""
    assert np.abs(QUINTIC.T @ ADDED).max() == 0


def test_a_polynomial_of_tenth_degree_on_raw_powers_is_refused_by_its_condition():
    """As NIST's Filip set, whose condition of 1.8e15 no double can bear: the rank is said to be less than eleven."""
    x = np.linspace(-8.8, -3.1, 82)
    b = basis(x[:, None] ** np.arange(11))
    assert b.rank < 11 and RANK_TOLERANCE >= 1e-8


def test_gum_h3_calibration_of_a_thermometer():
    """JCGM 100:2008, H.3: corrections b = y1 + y2 (t - 20 degC), their uncertainties, correlation and b(30 degC)."""
    t = np.array([21.521, 22.012, 22.512, 23.003, 23.507, 23.999, 24.513, 25.002, 25.503, 26.010, 26.511])
    b = np.array([-0.171, -0.169, -0.166, -0.159, -0.164, -0.165, -0.156, -0.157, -0.159, -0.161, -0.160])
    matrix = np.column_stack([np.ones(11), t - 20])
    form, found, u, spread = fitted(matrix, b)
    assert found.round(5) == pytest.approx([-0.1712, 0.00218], abs=5e-5)
    assert u == pytest.approx([0.0029, 0.00067], abs=5e-5) and spread == pytest.approx(0.0035, abs=5e-5)
    covariance = spread**2 * (form.v / form.s**2) @ form.v.T / np.outer(form.scale, form.scale)
    assert covariance[0, 1] / np.prod(u) == pytest.approx(-0.930, abs=5e-4)
    at = np.array([1.0, 10.0])
    assert at @ found == pytest.approx(-0.1494, abs=5e-5)
    assert np.sqrt(at @ covariance @ at) == pytest.approx(0.0041, abs=5e-5)
