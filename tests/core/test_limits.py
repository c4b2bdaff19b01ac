# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quantiles of the error: closed forms of chi and normal laws, scipy's noncentral chi-square, samples of our own, and
contributions by differences."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats

from sensworkbench.core import limits, workspace
from sensworkbench.core.distributions import DISTRIBUTIONS, Tolerance, moments
from sensworkbench.core.limits import RandomError, sample
from sensworkbench.core.objectives import Quantile, from_json
from sensworkbench.core.refusal import Refused
from sensworkbench.core.synthesis import omega
from sensworkbench.formats import machine_json
from tests.formats.support import ROOT

VMC = machine_json.load(ROOT / "resources" / "examples" / "vertical_machining_centre.json")


def normal(sigma: float, mean: float = 0.0) -> Tolerance:
    return Tolerance(mean - 3 * sigma, mean + 3 * sigma, "normal")


@pytest.mark.parametrize("level", [0.05, 0.5, 0.95, 0.999])
def test_equal_normal_errors_have_the_quantiles_of_chi(level):
    found = RandomError(np.eye(3), [normal(2.0)] * 3).quantile(level)
    assert found.value == pytest.approx(2 * stats.chi(3).ppf(level), rel=1e-9)
    assert found.contributions == pytest.approx([1 / 3] * 3, abs=1e-9)


def test_means_give_the_noncentral_chi_square():
    mean = np.array([1.0, -2.0, 0.5])
    of = RandomError(np.eye(3), [normal(1.0, m) for m in mean])
    for r in (0.5, 2.0, 4.0):
        expected = stats.ncx2(3, float(mean @ mean)).cdf(r * r)
        assert of.probability(r)[0] == pytest.approx(expected, abs=1e-9)


def test_one_direction_alone_is_the_half_normal_law():
    of = RandomError(np.array([[1.0, 2.0], [0.0, 0.0], [0.0, 0.0]]), [normal(1.0), normal(1.0)])
    found = of.quantile(0.95)
    assert found.value == pytest.approx(np.sqrt(5) * stats.norm.ppf(0.975), rel=1e-6)
    assert found.contributions == pytest.approx([0.2, 0.8], abs=1e-5)


def test_directions_of_very_different_size_agree_with_a_sample():
    rng = np.random.default_rng(3)
    columns = rng.normal(size=(3, 6)) * np.array([[1.0], [0.03], [0.3]])
    laws = [normal(s, m) for s, m in zip(rng.random(6) + 0.5, rng.normal(size=6))]
    of = RandomError(columns, laws)
    table = moments(laws)
    x = rng.normal(table.mean[:, None], np.sqrt(table.var)[:, None], (6, 2_000_000))
    size = np.linalg.norm(columns @ x, axis=0)
    for level in (0.5, 0.95, 0.99):
        r = of.value(level)
        assert abs((size <= r).mean() - level) < 5 * np.sqrt(level * (1 - level) / size.size)


def contribution_by_differences(columns, laws, weights, level, i, step=1e-3):
    def of(k):
        law = laws[i]
        moved = Tolerance(law.lower * k, law.upper * k, law.distribution)  # its mean grows with it
        return RandomError(columns, [*laws[:i], moved, *laws[i + 1 :]], weights).value(level)

    return (np.log(of(1 + step)) - np.log(of(1 - step))) / (np.log1p(step) - np.log1p(-step))


def test_contributions_are_derivatives_and_add_to_one():
    positions = workspace.quadrature(VMC, 2)
    table = workspace.error_table(VMC)
    columns = table.mixed(omega(VMC, table.symbols, positions.q))
    laws = [Tolerance(law.lower, law.upper, "normal") for law in table.laws]
    laws[0] = normal(1e-3, 4e-3)
    found = RandomError(columns, laws, positions.weights).quantile(0.95)
    assert found.contributions.sum() == pytest.approx(1, abs=1e-12)
    for i in (0, 3, 10):
        expected = contribution_by_differences(columns, laws, positions.weights, 0.95, i)
        assert found.contributions[i] == pytest.approx(expected, abs=2e-6)


def test_sampled_and_computed_agree_within_the_stated_error():
    positions = workspace.quadrature(VMC, 2)
    table = workspace.error_table(VMC)
    columns = table.mixed(omega(VMC, table.symbols, positions.q))
    laws = [Tolerance(law.lower, law.upper, "normal") for law in table.laws]
    computed = RandomError(columns, laws, positions.weights).quantile(0.95)
    sampled = limits._Sampled(columns, positions.weights, sample(laws))
    error = sampled.error(0.95)
    assert abs(sampled.quantile(0.95) - computed.value) < 4 * error
    assert error < 0.01 * computed.value
    assert np.abs(sampled.contributions(computed.value) - computed.contributions).max() < 0.02


@pytest.mark.parametrize("name", DISTRIBUTIONS)
def test_samples_have_the_moments_of_their_law(name):
    law = Tolerance(-2.0, 4.0, name)
    x = sample([law], 2**16)[0]
    mean, var, _, fourth = law.moments
    assert x.mean() == pytest.approx(mean, abs=2e-3)
    assert x.var() == pytest.approx(var, rel=2e-3, abs=1e-12)
    assert ((x - mean) ** 4).mean() == pytest.approx(fourth, rel=2e-2, abs=1e-12)


def test_a_nearly_flat_truncated_normal_law_is_flat():
    x = Tolerance(-1.0, 1.0, "truncated_normal", 1e4).inverse(np.array([0.25, 0.5, 0.75]))
    assert x == pytest.approx([-0.5, 0, 0.5], abs=1e-6)


def test_the_objective_gives_contributions_and_no_shares():
    found = workspace.sensitivity(VMC, workspace.quadrature(VMC, 2), Quantile(level=0.9), estimate=False)
    assert found.first == pytest.approx(found.total) and found.total.sum() == pytest.approx(1)
    assert found.component_total.sum() == pytest.approx(1)
    assert not found.objective.has_shares and from_json(found.objective.to_json()) == found.objective
    mean = workspace.sensitivity(VMC, workspace.quadrature(VMC, 2), estimate=False)
    assert 1 < found.mean_square / np.sqrt(mean.mean_square) < 2  # the 90 % quantile over the rms


@pytest.mark.parametrize("level", [0, 1, True, "x", 1.5, float("nan")])
def test_a_level_that_is_none_is_refused(level):
    with pytest.raises(Refused) as refused:
        from_json({"name": "quantile", "level": level})
    assert refused.value.code == "objective-level"
