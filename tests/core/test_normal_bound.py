# SPDX-License-Identifier: LGPL-2.1-or-later
"""How large a mean square can be while a quantile is kept: against exact quantiles of normal errors of any shape."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats

from sensworkbench.core.distributions import Tolerance
from sensworkbench.core.limits import RandomError
from sensworkbench.core.normal_bound import SAFE, largest_ratio


@pytest.mark.parametrize("level", [0.8, 0.9, 0.95, 0.99])
def test_at_one_place_it_is_that_of_the_split_with_the_lightest_tail(level):
    """Of Q = sum of lambda Z², lambda adding to 1, the quantile at a high level is least for three equal parts."""
    known = max(n / stats.chi2(n).ppf(level) for n in (1, 2, 3))
    found = largest_ratio(level, 1.0, 1.0)
    assert known <= found <= known * (1 + 3 * SAFE if level >= 0.9 else 1.05)  # other splits matter at 0.8


def test_no_machine_of_normal_errors_has_more_mean_square_than_the_bound():
    """Random covariances at random places: the mean square over the square of the quantile stays below."""
    rng = np.random.default_rng(6)
    for level in (0.9, 0.95, 0.99):
        highest = 0.0
        for _ in range(25):
            places, n = rng.integers(1, 6), rng.integers(1, 7)
            columns = rng.standard_normal((places, 3, n)) * rng.uniform(0.05, 1, (1, 3, n)) ** 2
            weights = rng.dirichlet(np.ones(places))
            laws = [Tolerance(-3.0, 3.0, "normal", 1.0)] * n
            squares = np.einsum("pan,pan->p", columns, columns)
            mean = float(weights @ squares)
            found = RandomError(columns, laws, weights).quantile(level).value
            limit = largest_ratio(level, squares.min() / mean, squares.max() / mean)
            assert mean / found**2 <= limit, (level, places, n)
            highest = max(highest, mean / found**2 / limit)
        assert highest > 0.8  # it is not far from what occurs


def test_the_more_places_may_differ_the_less_is_known():
    ratios = [largest_ratio(0.95, 1 / k, k) for k in (1.0, 2.0, 4.0, 8.0)]
    assert ratios == sorted(ratios) and largest_ratio(0.0) == np.inf
