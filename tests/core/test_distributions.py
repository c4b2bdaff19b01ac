# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moments of the tolerance distributions against numerical integration of scipy's densities."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose
from scipy import integrate, stats

from sensworkbench.core.distributions import (
    DISTRIBUTIONS,
    Tolerance,
    moments,
    paper_tolerance,
    with_defaults,
)
from sensworkbench.core.errors import COMPONENTS, PAPER_SYMBOLS
from sensworkbench.core.refusal import Refused


def scipy_law(tolerance: Tolerance):
    low, width = tolerance.lower, tolerance.upper - tolerance.lower
    middle = low + width / 2
    if tolerance.distribution == "uniform":
        return stats.uniform(low, width)
    if tolerance.distribution == "triangular":
        return stats.triang(0.5, low, width)
    if tolerance.distribution == "u_shaped":
        return stats.arcsine(low, width)
    if tolerance.distribution == "normal":
        return stats.norm(middle, tolerance.sigma or width / 6)
    sigma = tolerance.sigma or width / 4
    return stats.truncnorm(-width / 2 / sigma, width / 2 / sigma, middle, sigma)


def integrated_moments(tolerance: Tolerance):
    """Mean and central moments as integrals over probability, which tames the poles of the arcsine density."""
    law = scipy_law(tolerance)

    def expectation(f):
        # p = (1 - cos t)/2: smooth at both ends for every law here
        value, _ = integrate.quad(
            lambda t: f(law.ppf((1 - math.cos(t)) / 2)) * math.sin(t) / 2, 0, math.pi, epsabs=0, epsrel=1e-11, limit=400
        )
        return value

    mean = law.median()  # every law here is symmetric
    unit = law.std()
    return mean, *(unit**k * expectation(lambda x, k=k: ((x - mean) / unit) ** k) for k in (2, 4))


CASES = [
    Tolerance(-1.0, 1.0, "uniform"),
    Tolerance(2.0, 7.0, "uniform"),
    Tolerance(-3.0, -1.0, "triangular"),
    Tolerance(-10.0, 30.0, "u_shaped"),
    Tolerance(-6.0, 6.0, "normal"),
    Tolerance(0.0, 1.0, "normal", sigma=4.0),
    Tolerance(-1.0, 5.0, "truncated_normal"),
    Tolerance(-1.0, 1.0, "truncated_normal", sigma=0.2),
    Tolerance(-1.0, 1.0, "truncated_normal", sigma=1.0),
    Tolerance(-1.0, 1.0, "truncated_normal", sigma=15.0),
    Tolerance(-2e-5, 2e-5, "truncated_normal"),
]


@pytest.mark.parametrize("tolerance", CASES, ids=lambda t: f"{t.distribution}-{t.lower:g}-{t.upper:g}-{t.sigma}")
def test_moments_are_those_of_the_density(tolerance):
    mean, var, fourth = integrated_moments(tolerance)
    found = tolerance.moments
    assert found[0] == pytest.approx(mean, rel=1e-12, abs=1e-12)
    assert_allclose([found[1], found[3]], [var, fourth], rtol=1e-7)
    assert found[2] == 0.0


def test_every_distribution_is_among_the_cases():
    assert {t.distribution for t in CASES} | {"point"} == set(DISTRIBUTIONS)


@pytest.mark.parametrize("ratio", np.geomspace(1e-6, 50, 40))
def test_truncated_normal_keeps_its_digits_however_flat_or_sharp(ratio):
    """Half-width over sigma from 1e-6 (uniform) to 50 (untruncated): no cancellation, no jump."""
    _, var, _, fourth = Tolerance(-1.0, 1.0, "truncated_normal", sigma=1 / ratio).moments
    law = stats.truncnorm(-ratio, ratio, 0, 1 / ratio)

    def integral(k):
        # exp(-x²/2 sigma²) by Gauss-Legendre on pieces of a sigma
        edges = np.linspace(0, 1, 2 + int(ratio))
        nodes, w = np.polynomial.legendre.leggauss(20)
        x = (edges[:-1, None] + edges[1:, None]) / 2 + np.diff(edges)[:, None] / 2 * nodes
        p = np.exp(-((x * ratio) ** 2) / 2) * w * np.diff(edges)[:, None] / 2
        return (x**k * p).sum() / p.sum()

    assert var == pytest.approx(integral(2), rel=1e-12)
    assert fourth == pytest.approx(integral(4), rel=1e-12)
    if ratio > 0.1:
        assert var == pytest.approx(law.var(), rel=1e-6)


@settings(max_examples=60, deadline=None)
@given(
    lower=st.floats(-1e3, 1e3),
    width=st.one_of(st.just(0.0), st.floats(1e-3, 1e3)),
    name=st.sampled_from(DISTRIBUTIONS),
    shift=st.floats(-100, 100),
)
def test_moments_are_possible_and_shift_moves_only_the_mean(lower, width, name, shift):
    t = Tolerance(lower, lower + width, name)
    mean, var, third, fourth = t.moments
    assert var >= 0 and third == 0
    assert fourth >= var**2 * (1 - 1e-12)  # Jensen: V(U²) is not negative
    moved = Tolerance(lower + shift, lower + width + shift, name).moments
    assert moved[0] == pytest.approx(mean + shift, abs=1e-9)
    assert moved[1] == pytest.approx(var, rel=1e-6, abs=1e-9)


RATIOS = st.one_of(st.just(0.0), st.floats(1e-3, 4))


@settings(max_examples=60, deadline=None)
@given(name=st.sampled_from(DISTRIBUTIONS), ratio=RATIOS, sigma=st.one_of(st.none(), st.floats(0.1, 3)))
def test_scaling_a_tolerance_scales_its_moments_about_the_same_middle(name, ratio, sigma):
    t = Tolerance(-1.0, 4.0, name, sigma if "normal" in name else None)
    mean, var, _, fourth = t.moments
    found = t.scaled(ratio).moments
    assert found[0] == pytest.approx(mean)
    assert found[1] == pytest.approx(var * ratio**2, rel=1e-9, abs=1e-300)
    assert found[3] == pytest.approx(fourth * ratio**4, rel=1e-9, abs=1e-300)


def test_point_is_known():
    assert Tolerance(1.0, 3.0, "point").moments == (2.0, 0.0, 0.0, 0.0)
    assert Tolerance(2.0, 2.0, "normal").moments == (2.0, 0.0, 0.0, 0.0)


@pytest.mark.parametrize("name", DISTRIBUTIONS)
def test_absurdly_narrow_laws_have_finite_moments(name):
    """Denormal widths and standard deviations underflow to nothing instead of dividing by zero."""
    assert Tolerance(0.0, 5e-324, name).moments[1:] == (0.0, 0.0, 0.0)
    if "normal" in name:
        assert Tolerance(-1.0, 1.0, name, sigma=5e-324).moments == (0.0, 0.0, 0.0, 0.0)


def test_moments_of_many_are_arrays_in_order():
    law = moments([Tolerance(0.0, 2.0), Tolerance(-1.0, 1.0, "u_shaped")])
    assert_allclose(law.mean, [1, 0])
    assert_allclose(law.var, [1 / 3, 1 / 2])
    assert_allclose(law.fourth, [1 / 5, 3 / 8])


def test_paper_tolerances():
    """Straightness +-5 um, positioning +-1, spindle axial +-.5 and radial +-2 um, angles and squareness +-20 urad."""
    half = {s: paper_tolerance(s).upper for s in COMPONENTS}
    assert all(paper_tolerance(s).lower == -h and paper_tolerance(s).distribution == "uniform" for s, h in half.items())
    assert {half[s] for s in ("EYX", "EZX", "EXY", "EZY", "EXZ", "EYZ")} == {5e-3}
    assert {half[s] for s in ("EXX", "EYY", "EZZ")} == {1e-3}
    assert (half["EXT"], half["EYT"], half["EZT"]) == (2e-3, 2e-3, 0.5e-3)
    assert all(half[s] == pytest.approx(2e-5) for s, c in COMPONENTS.items() if c.angular and c.body in "XYZ")
    assert all(half[s] == 0 for s, c in COMPONENTS.items() if c.body == "W" or (c.body == "T" and c.angular))


def test_defaults_are_the_24_errors_of_the_paper_and_what_is_given_besides():
    given_ = {"EXX": Tolerance(-1.0, 2.0), "EXW": Tolerance(0.0, 1.0)}
    table = with_defaults(given_)
    assert list(table) == [*PAPER_SYMBOLS, "EXW"] and len(table) == 25
    assert table["EXX"] == given_["EXX"] and table["EAX"] == paper_tolerance("EAX")


# -- refusals --------------------------------------------------------------
@pytest.mark.parametrize(
    "arguments, code",
    [
        ((math.nan, 1.0), "tolerance-not-finite"),
        ((0.0, math.inf), "tolerance-not-finite"),
        ((-math.inf, 0.0), "tolerance-not-finite"),
        ((0.0, 1e300), "tolerance-too-large"),
        ((0.0, 1.0, "normal", 1e300), "tolerance-too-large"),
        ((2.0, 1.0), "tolerance-limits-reversed"),
        (("1", 2.0), "tolerance-not-a-number"),
        ((True, 2.0), "tolerance-not-a-number"),
        ((None, 2.0), "tolerance-not-a-number"),
        ((0.0, 1.0, "gauss"), "distribution-unknown"),
        ((0.0, 1.0, "uniform", 0.2), "distribution-without-sigma"),
        ((0.0, 1.0, "normal", 0.0), "sigma-not-positive"),
        ((0.0, 1.0, "normal", -1.0), "sigma-not-positive"),
        ((0.0, 1.0, "truncated_normal", math.nan), "tolerance-not-finite"),
    ],
)
def test_impossible_tolerances_are_refused(arguments, code):
    with pytest.raises(Refused) as refused:
        Tolerance(*arguments)
    assert refused.value.code == code
