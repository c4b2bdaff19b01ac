# SPDX-License-Identifier: LGPL-2.1-or-later
"""The exact indices against SALib (sampling, within its own stated error) and OpenTURNS (degree-2 chaos, to 1e-10)."""

from __future__ import annotations

import numpy as np
import openturns as ot
import pytest
from numpy.testing import assert_allclose
from SALib.analyze import sobol as analyze
from SALib.sample import sobol as sample

from sensworkbench.core import sobol, synthesis
from sensworkbench.core.distributions import Tolerance, moments, paper_tolerance
from sensworkbench.core.errors import PAPER_SYMBOLS
from tests.core.support import c_frame, uniform


def squared_length(omega, x):
    """(N,) |Omega x|² of the rows of x."""
    return ((x @ omega.T) ** 2).sum(axis=1)


# -- SALib --------------------------------------------------------------
def salib_estimate(omega, lower, upper, samples, seed=1):
    """(S, its standard error, S^T, its standard error) by Saltelli's scheme on a Sobol sequence."""
    n = len(lower)
    problem = {"num_vars": n, "names": [f"X{i}" for i in range(n)], "bounds": np.c_[lower, upper].tolist()}
    x = sample.sample(problem, samples, calc_second_order=False, seed=seed)
    y = squared_length(omega, x)
    # Saltelli's estimator of S is noisy for outputs far from zero mean
    found = analyze.analyze(problem, y - y.mean(), calc_second_order=False, seed=seed)
    return found["S1"], found["S1_conf"] / 1.96, found["ST"], found["ST_conf"] / 1.96


def problem(seed, n=6, symmetric=False):
    rng = np.random.default_rng(seed)
    half = rng.uniform(0.5, 2, n)
    middle = np.zeros(n) if symmetric else rng.uniform(-1, 1, n)
    return rng.normal(size=(3, n)), middle - half, middle + half


@pytest.mark.parametrize("seed", range(4))
def test_salib_agrees_within_its_sampling_error(seed):
    omega, lower, upper = problem(seed, symmetric=seed % 2 == 0)
    exact = sobol.indices(omega, moments(uniform(lower, upper)))
    s, s_error, st, st_error = salib_estimate(omega, lower, upper, 2**12)
    assert max(s_error.max(), st_error.max()) < 0.03, "the sample is large enough to say something"
    first = (s - exact.first[0]) / s_error
    total = (st - exact.total[0]) / st_error
    shown = f"in standard errors of SALib: S {np.round(first, 2)}, S^T {np.round(total, 2)}; errors {st_error}"
    assert np.abs(first).max() < 4 and np.abs(total).max() < 4, shown
    assert np.sqrt(np.mean(np.r_[first, total] ** 2)) < 1.5, shown


def test_salib_tells_the_printed_equation_18_from_the_total_index():
    """The same comparison fails by far where it should: it has the power to see a wrong formula."""
    omega, lower, upper = problem(0, symmetric=True)
    printed, _ = sobol.paper_eq18(omega, lower, upper)
    _, _, st, st_error = salib_estimate(omega, lower, upper, 2**12)
    assert np.abs((st - printed) / st_error).max() > 20


# -- OpenTURNS --------------------------------------------------------------
def openturns_law(tolerance: Tolerance):
    low, high = tolerance.lower, tolerance.upper
    return {
        "uniform": lambda: ot.Uniform(low, high),
        "triangular": lambda: ot.Triangular(low, (low + high) / 2, high),
        "normal": lambda: ot.Normal((low + high) / 2, (high - low) / 6),
        "truncated_normal": lambda: ot.TruncatedNormal((low + high) / 2, (high - low) / 4, low, high),
        "u_shaped": lambda: ot.Arcsine(low, high),
    }[tolerance.distribution]()


def openturns_chaos(omega, tolerances):
    """Sobol indices of a degree-2 polynomial chaos, exact for a quadratic form up to rounding."""
    n = len(tolerances)
    laws = [openturns_law(t) for t in tolerances]
    law = ot.JointDistribution(laws)
    enumerate_ = ot.LinearEnumerateFunction(n)
    families = [ot.StandardDistributionPolynomialFactory(one) for one in laws]
    basis = ot.OrthogonalProductPolynomialFactory(families, enumerate_)
    size = enumerate_.getStrataCumulatedCardinal(2)
    ot.RandomGenerator.SetSeed(7)
    x = ot.LHSExperiment(law, 4 * size).generate()
    y = ot.Sample(squared_length(omega, np.array(x))[:, None])
    fixed, least_squares = ot.FixedStrategy(basis, size), ot.LeastSquaresStrategy()
    chaos = ot.FunctionalChaosAlgorithm(x, y, law, fixed, least_squares)
    chaos.run()
    return ot.FunctionalChaosSobolIndices(chaos.getResult())


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("law", ["uniform", "normal", "triangular", "truncated_normal", "u_shaped", "mixed"])
def test_openturns_chaos_agrees_to_ten_digits(law, seed):
    omega, lower, upper = problem(seed + 50)
    names = ["uniform", "normal", "triangular", "truncated_normal", "u_shaped", "uniform"]
    tolerances = [
        Tolerance(float(a), float(b), names[i] if law == "mixed" else law) for i, (a, b) in enumerate(zip(lower, upper))
    ]
    chaos = openturns_chaos(omega, tolerances)
    exact = sobol.indices(omega, moments(tolerances))
    n = len(tolerances)
    assert_allclose(exact.first[0], [chaos.getSobolIndex(i) for i in range(n)], atol=1e-10, rtol=0)
    assert_allclose(exact.total[0], [chaos.getSobolTotalIndex(i) for i in range(n)], atol=1e-10, rtol=0)


def test_openturns_agrees_on_groups():
    omega, lower, upper = problem(60)
    tolerances = uniform(lower, upper)
    chaos = openturns_chaos(omega, tolerances)
    groups = [[0, 1], [2, 4, 5], [3]]
    exact = sobol.group_indices(omega, moments(tolerances), groups)
    assert_allclose(exact.total[0], [chaos.getSobolGroupedTotalIndex(g) for g in groups], atol=1e-10, rtol=0)
    assert_allclose(exact.first[0], [chaos.getSobolGroupedIndex(g) for g in groups], atol=1e-10, rtol=0)


def test_openturns_agrees_on_a_real_machine_with_24_errors():
    """Omega of a C-frame machine in um and urad, so that chaos and closed form see numbers near one."""
    omega = synthesis.omega(c_frame(), PAPER_SYMBOLS, (200.0, -150.0, -100.0))[0]
    tolerances = [paper_tolerance(s) for s in PAPER_SYMBOLS]
    width = np.array([t.upper for t in tolerances])
    in_um = omega * width * 1e3
    unit = uniform(-np.ones(24), np.ones(24))
    chaos = openturns_chaos(in_um, unit)
    exact = sobol.indices(omega, moments(tolerances))
    assert_allclose(exact.first[0], [chaos.getSobolIndex(i) for i in range(24)], atol=1e-10, rtol=0)
    assert_allclose(exact.total[0], [chaos.getSobolTotalIndex(i) for i in range(24)], atol=1e-10, rtol=0)
