# SPDX-License-Identifier: LGPL-2.1-or-later
"""The law of propagation against examples H.1 and H.2 of JCGM 100:2008, to the printed digits."""

from __future__ import annotations

import math

import numpy as np
import pytest

from sensworkbench.core.propagation import (
    combined,
    coverage_factor,
    derivatives,
    effective_freedom,
    factor_of,
    propagated,
    second_order,
)


# -- H.1: end-gauge calibration ----------------------------------------------------------------------------------------
def length(x):
    """Eq. (H.3), nm: standard, difference, its expansion coefficient (1/K), temperature, and their differences."""
    standard, difference, expansion, d_expansion, temperature, d_temperature = x
    return standard + difference - standard * (d_expansion * temperature + expansion * d_temperature)


H1 = [50.000623e6, 215.0, 11.5e-6, 0.0, -0.1, 0.0]
D_U = [5.8, 3.9, 6.7]  # nm: repeated observations, comparator random and systematic (H.1.3.2)
ROOT = math.sqrt(3)  # of rectangular laws; the temperature varies by 0.2 and cyclically by 0.5 degC (H.1.3.4)
H1_U = [25.0, math.hypot(*D_U), 2e-6 / ROOT, 1e-6 / ROOT, math.hypot(0.2, 0.5 / math.sqrt(2)), 0.05 / ROOT]


def test_h1_length_and_combined_uncertainty():
    value, covariance = combined(length, H1, np.diag(np.square(H1_U)))
    assert value[0] * 1e-6 == pytest.approx(50.000838, abs=5e-7)
    assert math.sqrt(covariance[0, 0]) == pytest.approx(32, abs=0.5)
    assert H1_U[1] == pytest.approx(9.7, abs=0.05)
    contributions = np.abs(derivatives(length, H1, H1_U)[0] * H1_U)
    assert contributions.round(1).tolist() == pytest.approx([25.0, 9.7, 0.0, 2.9, 0.0, 16.7], abs=0.11)


def test_h1_terms_of_second_order():
    """H.1.7: the products of difference of expansion and temperature, 11.7 nm, and 1.7 nm; together 34 nm."""
    first = combined(length, H1, np.diag(np.square(H1_U)))[1][0, 0]
    more = second_order(length, H1, H1_U)
    assert math.sqrt(more) == pytest.approx(math.hypot(11.7, 1.7), abs=0.1)
    assert math.sqrt(first + more) == pytest.approx(34, abs=0.5)


def test_h1_effective_degrees_of_freedom_and_expanded_uncertainty():
    """H.1.6: u(d) has 25.6 degrees of freedom, u_c has 16.7, of which 16 are taken; t is 2.92, U 93 nm."""
    own = effective_freedom(D_U, [24, 5, 8])
    assert own == pytest.approx(25.6, abs=0.35)
    whole = effective_freedom([25, 9.7, 2.9, 16.6], [18, 25.6, 50, 2])
    assert int(whole) == 16
    assert coverage_factor(0.99, 16) == pytest.approx(2.92, abs=0.005)
    u = math.sqrt(combined(length, H1, np.diag(np.square(H1_U)))[1][0, 0])
    assert coverage_factor(0.99, 16) * round(u) == pytest.approx(93, abs=0.5)  # the GUM multiplies 32 nm


# -- H.2: resistance and reactance -------------------------------------------------------------------------------------
OBSERVED = np.array([
    [5.007, 19.663e-3, 1.0456], [4.994, 19.639e-3, 1.0438], [5.005, 19.640e-3, 1.0468],
    [4.990, 19.685e-3, 1.0428], [4.999, 19.678e-3, 1.0433],
])  # fmt: skip  # V, A, rad


def impedance(x):
    """Eq. (H.7): R, X, Z in ohm."""
    voltage, current, phase = x
    z = voltage / current
    return np.array([z * math.cos(phase), z * math.sin(phase), z])


def test_h2_resistance_reactance_and_impedance_with_their_correlations():
    mean = OBSERVED.mean(axis=0)
    covariance = np.cov(OBSERVED.T) / len(OBSERVED)
    s = np.sqrt(np.diag(covariance))
    assert s == pytest.approx([0.0032, 0.0095e-3, 0.00075], rel=0.02)
    r = covariance / np.outer(s, s)
    assert [r[0, 1], r[0, 2], r[1, 2]] == pytest.approx([-0.36, 0.86, -0.65], abs=0.006)
    value, found = combined(impedance, mean, covariance)
    u = np.sqrt(np.diag(found))
    assert value == pytest.approx([127.732, 219.847, 254.260], abs=5e-4)
    assert u == pytest.approx([0.071, 0.295, 0.236], abs=6e-4)
    r = found / np.outer(u, u)
    assert [r[0, 1], r[0, 2], r[1, 2]] == pytest.approx([-0.588, -0.485, 0.993], abs=6e-4)
    jacobian = derivatives(impedance, mean, s)
    assert propagated(jacobian, factor_of(covariance)) == pytest.approx(u, rel=1e-9)


# -- coverage factors (JCGM 100, table G.2) ----------------------------------------------------------------------------
@pytest.mark.parametrize(
    ("freedom", "p", "k"),
    [
        (1, 0.9545, 13.97),
        (2, 0.95, 4.30),
        (5, 0.9973, 5.51),
        (10, 0.99, 3.17),
        (20, 0.9545, 2.13),
        (math.inf, 0.99, 2.576),
    ],
)
def test_coverage_factors_are_those_of_table_g2(freedom, p, k):
    assert coverage_factor(p, freedom) == pytest.approx(k, abs=6e-3)


def test_degrees_of_freedom_of_exact_inputs_are_without_limit():
    assert effective_freedom([3.0, 4.0], [math.inf, math.inf]) == math.inf


def test_derivatives_are_taken_over_a_tenth_of_a_standard_uncertainty():
    found = derivatives(lambda x: np.array([x[0] ** 3, x[1]]), [2.0, 1.0], [0.5, 0.0])
    assert found[0, 0] == pytest.approx(3 * 4 + 0.05**2, rel=1e-9)  # the cubic term shows the step
    assert found.tolist()[1] == [0.0, 0.0] and found[0, 1] == 0.0  # an input without uncertainty is not moved


@pytest.mark.parametrize("order", [(0, 1), (1, 0)])
def test_terms_of_second_order_of_a_polynomial(order):
    """f = 2x + 3xy + 4xy^2 + 5y^2: f_xy = 3 + 8y, f_yy = 8x + 10, f_xyy = 8, by hand."""
    x, y, ux, uy = 0.7, -1.3, 0.2, 0.4
    place, u = np.array([x, y])[list(order)], np.array([ux, uy])[list(order)]

    def f(v):
        a, b = v[order[0]], v[order[1]]
        return 2 * a + 3 * a * b + 4 * a * b**2 + 5 * b**2

    own = (8 * x + 10) ** 2 / 2 * uy**4
    mixed = ((3 + 8 * y) ** 2 + (2 + 3 * y + 4 * y**2) * 8) * ux**2 * uy**2
    assert second_order(f, place, u) == pytest.approx(own + mixed, rel=1e-9)
    cubic = second_order(lambda v: v[0] ** 3, [2.0], [0.1])
    slope = 3 * 4 * 0.1 + 0.1**3  # over one standard uncertainty to either side
    assert cubic == pytest.approx((6 * 2 * 0.01) ** 2 / 2 + slope * 6 * 0.001, rel=1e-9)
