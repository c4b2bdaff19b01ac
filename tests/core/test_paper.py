# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paper's formulas: the H and G recursions are right; eq. (18) as printed is wrong in the three stated ways."""

from __future__ import annotations

import math
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from benchmarks import paper_comparison
from sensworkbench.core import sobol, synthesis, workspace
from sensworkbench.core.distributions import moments, paper_tolerance
from sensworkbench.core.errors import PAPER_SYMBOLS
from tests.core.support import decomposition, machine, uniform

SMALL = np.array([[1, -1 / 5, 0], [0, 1 / 10, 1], [0, 0, 0]])
SYMMETRIC, LOPSIDED = ((-1, -20, -5), (1, 20, 5)), ((0, -10, -5), (2, 30, 5))
SEEDS = st.integers(0, 2**32 - 1)


def exact_power_moment(coefficients, lower, upper, power):
    """E[(sum c X)^power] in fractions, by the multinomial theorem and E[X^k] = (u^(k+1) - l^(k+1))/((k+1)(u - l))."""
    if not coefficients:
        return Fraction(int(power == 0))
    c, low, up = (Fraction(v[0]) for v in (coefficients, lower, upper))
    return sum(
        math.comb(power, k)
        * c**k
        * (up ** (k + 1) - low ** (k + 1))
        / ((k + 1) * (up - low))
        * exact_power_moment(coefficients[1:], lower[1:], upper[1:], power - k)
        for k in range(power + 1)
    )


@settings(max_examples=40, deadline=None)
@given(rows=st.lists(st.tuples(st.integers(-9, 9), st.integers(-9, 9), st.integers(1, 9)), min_size=1, max_size=5))
def test_h_and_g_recursions_give_the_four_moments(rows):
    c, low, width = zip(*rows)
    up = [a + w for a, w in zip(low, width)]
    exact = [float(exact_power_moment(list(c), list(low), up, k)) for k in (1, 2, 3, 4)]
    scale = sum(abs(a) * max(abs(b), abs(d)) for a, b, d in zip(c, low, up)) + 1
    found = sobol.paper_power_moments(c, low, up)
    for k in range(4):
        assert found[k] == pytest.approx(exact[k], abs=1e-12 * scale ** (k + 1))


@settings(max_examples=40, deadline=None)
@given(seed=SEEDS, n=st.integers(1, 12))
def test_recursions_agree_with_the_closed_form_for_a_single_component(seed, n):
    """For Y = T4² both ways must give the same E[Y] and V(Y): eq. (17) is right for one component."""
    rng = np.random.default_rng(seed)
    omega = np.zeros((3, n))
    omega[0] = rng.normal(size=n)
    lower = rng.uniform(-2, 1, n)
    upper = lower + rng.uniform(0.1, 2, n)
    found = sobol.indices(omega, moments(uniform(lower, upper)))
    g = sobol.paper_power_moments(omega[0], lower, upper)
    assert found.mean[0] == pytest.approx(g[1], rel=1e-10)
    assert found.variance[0] == pytest.approx(g[3] - g[1] ** 2, rel=1e-8)


# -- eq. (18) as printed --------------------------------------------------------------
def test_eq_15a_drops_the_covariances():
    printed, variance = sobol.paper_eq18(SMALL, *SYMMETRIC)
    assert variance == pytest.approx(float(Fraction(5912, 45)), rel=1e-12)
    right = sobol.indices(SMALL, moments(uniform(*SYMMETRIC))).variance[0]
    assert right - variance == pytest.approx(float(Fraction(6424 - 5912, 45)))
    # the difference is 2 Cov(T4², T5²), which X2 alone makes: 2 (1/25)(1/100) V(X2²), V(X2²) = 4/45 20^4
    assert right - variance == pytest.approx(2 / 2500 * 4 / 45 * 20**4)


def printed_numerator(single_row, j, lower, upper, cross):
    """V(E(T²|X_j)) from E(T²|X_j) = G² + cross G¹ Omega X_j + (Omega X_j)², integrated numerically over X_j."""
    rest = [i for i in range(len(single_row)) if i != j]
    g1 = sum(single_row[i] * (lower[i] + upper[i]) / 2 for i in rest)
    nodes, w = np.polynomial.legendre.leggauss(8)
    x = (lower[j] + upper[j]) / 2 + (upper[j] - lower[j]) / 2 * nodes
    y = cross * g1 * single_row[j] * x + (single_row[j] * x) ** 2
    mean = w @ y / 2
    return w @ (y - mean) ** 2 / 2


@pytest.mark.parametrize("lower, upper", [SYMMETRIC, LOPSIDED], ids=["symmetric", "asymmetric"])
def test_eq_18_as_printed_subtracts_the_first_order_variance_with_half_the_cross_term(lower, upper):
    """1 - sum_a V(E(T_a²|X_j)) / sum_a V(T_a²), with G¹ where 2 G¹ belongs: that is what is printed, and no more."""
    printed, variance = sobol.paper_eq18(SMALL, lower, upper)
    for j in range(3):
        numerator = sum(printed_numerator(row, j, lower, upper, cross=1) for row in SMALL)
        assert printed[j] == pytest.approx(1 - numerator / variance, rel=1e-12)


def test_missing_factor_2_matters_only_for_asymmetric_tolerances():
    for (lower, upper), matters in ((SYMMETRIC, False), (LOPSIDED, True)):
        half = [sum(printed_numerator(row, j, lower, upper, 1) for row in SMALL) for j in range(3)]
        whole = [sum(printed_numerator(row, j, lower, upper, 2) for row in SMALL) for j in range(3)]
        assert np.allclose(half, whole, rtol=1e-12) != matters


@settings(max_examples=30, deadline=None)
@given(seed=SEEDS, n=st.integers(2, 8))
def test_without_shared_inputs_and_asymmetry_the_printed_index_is_one_minus_first_order(seed, n):
    """One component, zero means: two of the three faults vanish, and what is left is 1 - S_j, not S_j^T."""
    rng = np.random.default_rng(seed)
    omega = np.zeros((3, n))
    omega[1] = rng.normal(size=n)
    half = rng.uniform(0.5, 2, n)
    printed, _ = sobol.paper_eq18(omega, -half, half)
    right = sobol.indices(omega, moments(uniform(-half, half)))
    assert_allclose(printed, 1 - right.first[0], atol=1e-12)
    # and 1 - S_j is the total index of everything but j
    for j in range(n):
        others = sobol.group_indices(omega, moments(uniform(-half, half)), [[i for i in range(n) if i != j]])
        assert printed[j] == pytest.approx(others.total[0, 0], abs=1e-12)


def test_printed_index_ranks_backwards_on_the_paper_tolerances():
    """0.98 to 1.00 for every error, the most harmless highest."""
    q = (200, 150, -100)
    omega = synthesis.omega(machine("FXYZ"), PAPER_SYMBOLS, q)[0]
    tolerances = [paper_tolerance(s) for s in PAPER_SYMBOLS]
    printed, variance = sobol.paper_eq18(omega, [t.lower for t in tolerances], [t.upper for t in tolerances])
    right = sobol.indices(omega, moments(tolerances))
    assert printed.min() > 0.98 and printed.max() <= 1
    order = np.argsort(right.total[0])
    assert printed[order[-1]] == printed.min() and printed[order[0]] == printed.max()
    assert variance / right.variance[0] == pytest.approx(0.9944, abs=5e-5)


def test_right_total_index_is_one_minus_the_variance_of_the_mean_given_all_others():
    """S_j^T = 1 - V(E(Y|X_~j))/V: checked by integrating X_j out numerically."""
    lower, upper = (np.array(v, dtype=float) for v in LOPSIDED)
    law = moments(uniform(lower, upper))
    single, pair, _ = decomposition(SMALL, law)
    found = sobol.indices(SMALL, law)
    nodes, w = np.polynomial.legendre.leggauss(5)
    grid = np.stack(np.meshgrid(*[(a + b) / 2 + (b - a) / 2 * nodes for a, b in zip(lower, upper)], indexing="ij"))
    y = ((np.tensordot(SMALL, grid, axes=1)) ** 2).sum(axis=0)
    weight = np.einsum("i,j,k->ijk", w, w, w) / 8
    variance = (weight * y**2).sum() - (weight * y).sum() ** 2
    assert variance == pytest.approx(found.variance[0], rel=1e-12)
    for j in range(3):
        given_others = np.tensordot(w / 2, np.moveaxis(y, j, 0), axes=1)
        others = weight.sum(axis=j)
        v = (others * given_others**2).sum() - (others * given_others).sum() ** 2
        assert found.total[0, j] == pytest.approx(1 - v / variance, rel=1e-10)


# -- the paper's finding --------------------------------------------------------------------------------------------
@pytest.fixture(scope="module")
def over_the_workspace():
    found = {c: workspace.sensitivity(paper_comparison.machine(c)) for c in ("direction", "carried")}
    return {c: dict(zip(f.symbols, f.total)) for c, f in found.items()}


def test_carried_squareness_of_z_to_y_comes_first(over_the_workspace):
    table = over_the_workspace["carried"]
    assert max(table, key=table.get) == "A0Z"
    assert table["A0Z"] == pytest.approx(0.25, abs=0.01)


def test_squareness_as_direction_stays_below_straightness(over_the_workspace):
    table = over_the_workspace["direction"]
    largest = max(table[s] for s in paper_comparison.SQUARENESS)
    assert largest < min(table[s] for s in paper_comparison.STRAIGHTNESS)


@pytest.mark.parametrize("convention", ["direction", "carried"])
def test_angles_dominate_and_linear_displacement_and_spindle_hardly_matter(over_the_workspace, convention):
    table = over_the_workspace[convention]
    small = max(table[s] for s in ("EXX", "EYY", "EZZ", "EXT", "EYT", "EZT"))
    angles = [table[s] for s in paper_comparison.KINDS["angular"]]
    assert small < 0.02 < 0.1 < np.mean(angles)
    assert max(angles) > max(table[s] for s in paper_comparison.STRAIGHTNESS)


def test_documentation_quotes_what_the_comparison_prints():
    """docs/theory.md shows the printed tables word for word."""
    text = (Path(__file__).resolve().parents[2] / "docs" / "theory.md").read_text(encoding="utf-8")
    for part in (paper_comparison.small_problem, paper_comparison.at_a_position, paper_comparison.finding):
        for line in part():
            if "estimated error" not in line:
                assert line.rstrip() in text, line
