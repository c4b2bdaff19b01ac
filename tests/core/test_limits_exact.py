# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quantiles of the error, part by part: integrals over a ball by another rule, mixtures of places, samples counted one
by one."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy import optimize, stats

from sensworkbench.core import limits
from sensworkbench.core.distributions import Tolerance
from sensworkbench.core.limits import RandomError, _ball, _Normal, _Sampled, sample


def normal(sigma: float, mean: float = 0.0) -> Tolerance:
    return Tolerance(mean - 3 * sigma, mean + 3 * sigma, "normal")


def integrals(m, s, r, order=56):
    """(mass, slope, curvature) of the ball in spherical coordinates, from derivatives of the density itself."""
    x, w = np.polynomial.legendre.leggauss(order)
    size, cosine = (x + 1) / 2 * r, x
    around = 2 * np.pi * np.arange(order) / order
    rho, c, phi = np.meshgrid(size, cosine, around, indexing="ij")
    weight = (w / 2 * r)[:, None, None] * w[None, :, None] * np.full(order, 2 * np.pi / order) * rho**2
    sine = np.sqrt(1 - c * c)
    t = np.stack([rho * sine * np.cos(phi), rho * sine * np.sin(phi), rho * c])
    z = (t - np.reshape(m, (3, 1, 1, 1))) / np.reshape(s, (3, 1, 1, 1))
    density = weight * np.exp(-(z**2).sum(axis=0) / 2) / ((2 * np.pi) ** 1.5 * np.prod(s))
    by = z / np.reshape(s, (3, 1, 1, 1))
    slope = np.array([(density * b).sum() for b in by])
    curvature = np.array([[(density * a * b).sum() for b in by] for a in by])
    return density.sum(), slope, curvature - np.diag(density.sum() / np.square(s))


@pytest.mark.parametrize(
    ("m", "s", "r"),
    [
        ((0.0, 0.0, 0.0), (1.0, 0.9, 0.8), 1.3),
        ((0.4, -0.7, 0.2), (1.5, 1.1, 0.7), 2.0),
        ((-1.0, 0.5, 0.9), (2.0, 0.8, 0.6), 0.9),
        ((0.3, 0.2, -2.5), (1.0, 0.7, 0.5), 2.2),
    ],
)
def test_integrals_over_a_ball_and_their_derivatives(m, s, r):
    found = _ball(np.array(m), np.array(s), r)
    mass, slope, curvature = integrals(m, s, r)
    assert found.mass == pytest.approx(mass, rel=1e-11)
    assert_allclose(found.slope, slope, atol=1e-11)
    assert_allclose(found.curvature, curvature, atol=1e-10)
    plain = _ball(np.array(m), np.array(s), r, derivatives=False)
    assert plain.mass == pytest.approx(mass, rel=1e-11)
    assert plain.slope.tolist() == [0, 0, 0] and plain.curvature.tolist() == [[0, 0, 0]] * 3


def test_the_integral_of_a_thin_ball_far_from_the_mean_keeps_its_digits():
    """One wide and two narrow directions: beyond the reach of eight deviations nothing is left out."""
    m, s = np.array([0.5, 0.02, -0.01]), np.array([1.0, 1e-2, 1e-3])
    found = _ball(m, s, 1.0, derivatives=False).mass
    t2, w2 = np.polynomial.hermite_e.hermegauss(40)
    mass = 0.0
    for a, wa in zip(t2, w2):
        for b, wb in zip(t2, w2):
            half = math.sqrt(max(1 - (m[1] + s[1] * a) ** 2 - (m[2] + s[2] * b) ** 2, 0))
            mass += wa * wb / (2 * np.pi) * (stats.norm.cdf(half, 0.5) - stats.norm.cdf(-half, 0.5))
    assert found == pytest.approx(mass, rel=1e-9)


def mixture():
    """Three places: two at which T varies, one at which it is (0, 0, 2) whatever the machine."""
    columns = np.zeros((3, 3, 4))
    columns[0][:, :3] = np.eye(3)
    columns[1][:, :3] = 3 * np.eye(3)
    columns[2][:, 3] = (0, 0, 2.0)
    laws = [normal(1.0), normal(1.0), normal(1.0), Tolerance(1.0, 1.0, "point")]
    return RandomError(columns, laws, [0.5, 0.3, 0.2])


def of_mixture(r):
    return 0.5 * stats.chi(3).cdf(r) + 0.3 * stats.chi(3).cdf(r / 3) + 0.2 * (r >= 2)


def test_a_place_where_nothing_varies_counts_whole_or_not_at_all():
    of = mixture()
    for r in (0.5, 1.999, 2.0, 2.001, 5.0):
        assert of.probability(r)[0] == pytest.approx(of_mixture(r), abs=1e-10)
    assert of.probability(0.0)[0] == 0.0 and of.probability(-1.0)[0] == 0.0
    for level in (0.1, 0.7, 0.95, 0.999):
        found = of.quantile(level)
        assert found.value == pytest.approx(optimize.brentq(lambda r, p: of_mixture(r) - p, 0.01, 30, level, 1e-14))
        assert found.contributions == pytest.approx([1 / 3, 1 / 3, 1 / 3, 0], abs=1e-7)
    assert of.value(0.45) == pytest.approx(2.0, abs=1e-9)  # the step there jumps from .28 to .48


def test_a_machine_that_only_has_constant_errors_has_them_as_quantiles():
    of = RandomError(np.array([[3.0], [0.0], [4.0]]), [Tolerance(2.0, 2.0, "point")])
    assert of.computed and of.value(0.3) == pytest.approx(10.0, rel=1e-9)
    assert of.quantile(0.3).contributions.tolist() == [0.0]


def test_the_first_bracket_holds_means_far_outside_the_scatter():
    of = RandomError(np.eye(3), [normal(1e-3, 50.0), normal(1e-3), normal(1e-3)])
    assert of.value(0.5) == pytest.approx(50.0, abs=1e-6)
    assert of.value(0.99) == pytest.approx(50.0 + 1e-3 * stats.norm.ppf(0.99), abs=1e-6)


def test_which_laws_are_computed():
    assert limits.normal([normal(1.0), Tolerance(0, 1, "point"), Tolerance(2.0, 2.0, "uniform")])
    assert not limits.normal([normal(1.0), Tolerance(0, 1, "uniform")])


def test_the_error_of_a_computed_quantile_is_that_of_its_integral():
    """A ball beside the mean, cut by narrow directions: 30 and 40 nodes differ, and the quantile by as much."""
    columns, laws = np.diag([1.0, 0.3, 0.1]), [normal(1.0, 0.5), normal(1.0, 2.0), normal(1.0, 5.0)]
    of = _Normal(columns[None], np.ones(1), np.array([0.5, 2.0, 5.0]), np.ones(3))
    whole = RandomError(columns, laws)
    for level in (0.2, 0.9):
        r = of.quantile(level)
        off = abs(of.probability(r) - of.probability(r, 30))
        assert whole.probability(r) == (of.probability(r), off)
        assert whole.quantile(level).error == of.error(level) and whole.quantile(level, error=False).error == 0.0
        if off <= 1e-12:
            assert of.error(level) == 0.0
        else:
            slope = (of.probability(r * 1.0001) - of.probability(r * 0.9999)) / (0.0002 * r)
            assert of.error(level) == pytest.approx(off / slope, rel=0.1)


def test_a_coarse_integral_has_an_error():
    of = _Normal(np.diag([1.0, 0.9, 0.02])[None], np.ones(1), np.array([0.0, 1.0, 0.0]), np.ones(3))
    coarse = limits.ORDER
    try:
        limits.ORDER = 8
        r = of.quantile(0.3)
        off = abs(of.probability(r) - of.probability(r, 6))
        assert off > 1e-9 and of.error(0.3) > 0
    finally:
        limits.ORDER = coarse


# -- samples -----------------------------------------------------------------------------------------------------------
def test_each_part_of_the_sample_is_a_latin_hypercube():
    laws = [Tolerance(0.0, 1.0), Tolerance(-1.0, 3.0)]
    x = sample(laws, 16 * 50 + 3, seed=7)
    assert x.shape == (2, 800)
    for row, law in zip(x, laws):
        share = (row - law.lower) / (law.upper - law.lower)
        for part in share.reshape(16, 50):
            assert sorted(np.floor(part * 50).astype(int)) == list(range(50))
    orders = np.argsort(x.reshape(2, 16, 50), axis=2)
    assert len({tuple(o) for row in orders for o in row}) == 32  # no part and no error in the order of another
    assert sample(laws, 160, 1).tolist() == sample(laws, 160, 1).tolist() != sample(laws, 160, 2).tolist()
    assert sample(laws).shape == (2, limits.SAMPLES)


def sampled(places=3, machines=640):
    rng = np.random.default_rng(11)
    columns, x = rng.normal(size=(places, 3, 5)), rng.normal(size=(5, machines))
    weights = np.array([0.2, 0.5, 0.3])[:places] if places > 1 else np.ones(1)
    return _Sampled(columns, weights, x), columns, weights, x


def sizes(columns, x):
    return np.array([[math.dist(c @ x[:, k], (0, 0, 0)) for k in range(x.shape[1])] for c in columns])


def test_a_sampled_probability_is_counted():
    of, columns, weights, x = sampled()
    size = sizes(columns, x)
    assert_allclose(of.size, size, rtol=1e-12)
    for r in (1.0, 3.0, float(size[1, 5])):
        inside = [sum(w for w, s in zip(weights, size[:, k]) if s <= r) for k in range(640)]
        assert of.probability(r) == pytest.approx(np.mean(inside), rel=1e-12)
        parts = [np.mean(inside[40 * k : 40 * k + 40]) for k in range(16)]
        error = math.sqrt(sum((p - np.mean(parts)) ** 2 for p in parts) / 15 / 16)
        assert of.probability_error(r) == pytest.approx(error, rel=1e-9)


def smallest(pairs, level):
    """The smallest value at which the summed weight of (value, weight) reaches the level."""
    whole, so_far = sum(w for _, w in pairs), 0.0
    for value, w in sorted(pairs):
        so_far += w
        if so_far >= level * whole - 1e-12:
            return value


def test_a_sampled_quantile_is_the_smallest_that_reaches_its_level():
    of, columns, weights, x = sampled()
    size = sizes(columns, x)
    pairs = [(size[p, k], weights[p]) for p in range(3) for k in range(640)]
    for level in (0.1037, 0.5023, 0.9511, 1.0):
        assert of.quantile(level) == pytest.approx(smallest(pairs, level), rel=1e-12)
    parts = [
        smallest([(size[p, k], weights[p]) for p in range(3) for k in range(40 * i, 40 * i + 40)], 0.9013)
        for i in range(16)
    ]
    assert of.error(0.9013) == pytest.approx(np.std(parts, ddof=1) / 4, rel=1e-9)
    one, columns, _, x = sampled(1)
    assert one.quantile(0.9) == pytest.approx(np.quantile(sizes(columns, x)[0], 0.9), rel=1e-12)


def test_sampled_contributions_are_means_over_machines_near_the_quantile():
    of, columns, weights, x = sampled()
    size, r = sizes(columns, x), 3.0
    total = np.zeros(5)
    for p in range(3):
        for k in range(640):
            if abs(size[p, k] - r) <= 0.02 * r:
                t = columns[p] @ x[:, k]
                total += weights[p] * (columns[p].T @ t) * x[:, k]
    assert_allclose(of.contributions(r), total / total.sum(), rtol=1e-11)
    assert of.contributions(1e6).tolist() == [0.0] * 5


def test_how_many_machines_are_sampled():
    laws = [Tolerance(-1, 1)]

    def machines(places):
        return RandomError(np.ones((places, 3, 1)), laws)._of.x.shape[1]

    assert (machines(1), machines(128), machines(256)) == (65_536, 65_536, 32_768)
    assert machines(4000) == 4096
    given = RandomError(np.ones((2, 3, 1)), laws, machines=np.array([[0.5, 1.0, -2.0]]))
    assert given.quantile(1.0, error=False).value == pytest.approx(2 * math.sqrt(3))
    assert not given.computed and given._of.weights.tolist() == [0.5, 0.5]
    found, error = RandomError(np.eye(3)[:, :1], laws).probability(0.3)
    assert found == pytest.approx(0.3, abs=1e-4) and 0 < error < 1e-4
