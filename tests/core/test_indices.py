# SPDX-License-Identifier: LGPL-2.1-or-later
"""Indices at linear cost against the decomposition written out with A, and what must hold of any indices."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from sensworkbench.core import sobol
from sensworkbench.core.distributions import Moments, moments
from sensworkbench.core.refusal import Refused
from tests.core.support import decomposition, random_law, uniform

SEEDS = st.integers(0, 2**32 - 1)
MANY = settings(max_examples=80, deadline=None)
WEIGHTS = st.sampled_from([(1.0, 1.0, 1.0), (1.0, 0.0, 1.0), (0.0, 0.0, 3.0), (0.5, 2.0, 7.0)])


def random_problem(seed, n, count=3, skewed=True):
    rng = np.random.default_rng(seed)
    return rng.normal(size=(count, 3, n)) * rng.uniform(0.1, 10, n), random_law(rng, n, skewed), rng


@MANY
@given(seed=SEEDS, n=st.integers(1, 12), weights=WEIGHTS, skewed=st.booleans())
def test_first_and_total_are_those_of_the_written_out_decomposition(seed, n, weights, skewed):
    omega, law, _ = random_problem(seed, n, skewed=skewed)
    found = sobol.indices(omega, law, weights)
    for p in range(len(omega)):
        single, pair, mean = decomposition(omega[p], law, weights)
        variance = single.sum() + pair.sum() / 2
        assert found.variance[p] == pytest.approx(variance, rel=1e-10)
        assert found.mean[p] == pytest.approx(mean, rel=1e-10)
        assert_allclose(found.first[p], single / variance, rtol=1e-9, atol=1e-12)
        assert_allclose(found.total[p], (single + pair.sum(axis=1)) / variance, rtol=1e-9, atol=1e-12)


@MANY
@given(seed=SEEDS, n=st.integers(2, 10), weights=WEIGHTS, cuts=st.integers(1, 4))
def test_group_indices_count_what_touches_the_group_once(seed, n, weights, cuts):
    omega, law, rng = random_problem(seed, n)
    owner = rng.integers(0, cuts, n)
    groups = [np.flatnonzero(owner == g).tolist() for g in range(cuts) if np.any(owner == g)]
    found = sobol.group_indices(omega, law, groups, weights)
    for p in range(len(omega)):
        single, pair, mean = decomposition(omega[p], law, weights)
        variance = single.sum() + pair.sum() / 2
        assert found.variance[p] == pytest.approx(variance, rel=1e-10)
        assert found.mean[p] == pytest.approx(mean, rel=1e-10)
        for g, members in enumerate(groups):
            inside = pair[np.ix_(members, members)].sum() / 2
            others = [i for i in range(n) if i not in members]
            across = pair[np.ix_(members, others)].sum()
            closed = single[members].sum() + inside
            assert found.first[p, g] == pytest.approx(closed / variance, rel=1e-9, abs=1e-12)
            assert found.total[p, g] == pytest.approx((closed + across) / variance, rel=1e-9, abs=1e-12)


@MANY
@given(seed=SEEDS, n=st.integers(1, 9))
def test_groups_of_one_are_the_errors_and_the_group_of_all_is_everything(seed, n):
    omega, law, _ = random_problem(seed, n)
    each = sobol.group_indices(omega, law, [[i] for i in range(n)])
    single = sobol.indices(omega, law)
    assert_allclose(each.first, single.first, rtol=1e-9, atol=1e-12)
    assert_allclose(each.total, single.total, rtol=1e-9, atol=1e-12)
    everything = sobol.group_indices(omega, law, [range(n)])
    assert_allclose(everything.first, 1, rtol=1e-12)
    assert_allclose(everything.total, 1, rtol=1e-12)


def test_total_of_a_group_is_not_the_sum_of_its_members():
    omega, law, _ = random_problem(4, 6, skewed=False)
    group = sobol.group_indices(omega, law, [[0, 1, 2], [3, 4, 5]]).total
    single = sobol.indices(omega, law).total
    assert (group[:, 0] < single[:, :3].sum(axis=1) - 0.005).all()
    # first of one group and total of all others share the variance between them
    first = sobol.group_indices(omega, law, [[0, 1, 2], [3, 4, 5]]).first
    assert_allclose(first[:, 0] + group[:, 1], 1, rtol=1e-12)


@MANY
@given(seed=SEEDS, n=st.integers(1, 12))
def test_indices_are_shares(seed, n):
    omega, law, _ = random_problem(seed, n)
    found = sobol.indices(omega, law)
    slack = 1e-12
    assert (found.first >= -slack).all() and (found.total >= found.first - slack).all()
    assert (found.total <= 1 + slack).all()
    assert (found.first.sum(axis=1) <= 1 + slack).all() and (found.total.sum(axis=1) >= 1 - slack).all()
    # nothing of third order: each interaction is counted in exactly two totals
    assert_allclose(found.first.sum(axis=1) + found.total.sum(axis=1), 2, rtol=1e-10)


@MANY
@given(seed=SEEDS, n=st.integers(2, 8))
def test_turning_the_axes_of_the_error_vector_changes_nothing(seed, n):
    """|T|² does not know the frame: Omega -> Q Omega."""
    omega, law, rng = random_problem(seed, n)
    turn, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    one, other = sobol.indices(omega, law), sobol.indices(turn @ omega, law)
    assert_allclose(one.total, other.total, rtol=1e-9, atol=1e-12)
    assert_allclose(one.first, other.first, rtol=1e-9, atol=1e-12)


@MANY
@given(seed=SEEDS, n=st.integers(1, 8), factor=st.floats(1e-6, 1e6))
def test_units_do_not_matter(seed, n, factor):
    omega, law, _ = random_problem(seed, n)
    one, other = sobol.indices(omega, law), sobol.indices(omega * factor, law)
    assert_allclose(one.total, other.total, rtol=1e-9, atol=1e-12)
    assert_allclose(other.variance, one.variance * factor**4, rtol=1e-9)


def test_error_without_variance_or_without_lever_has_no_index():
    omega, law, _ = random_problem(8, 5)
    omega[:, :, 1] = 0
    law.var[2] = law.third[2] = law.fourth[2] = 0
    found = sobol.indices(omega, law)
    assert_allclose(found.total[:, [1, 2]], 0, atol=1e-15)
    assert (found.total[:, [0, 3, 4]] > 0).all()


def test_known_constant_still_acts_through_its_mean():
    """X2 fixed at 3: Y = (X1 + 3)² has V = 36 var + V(U²), where X1 alone would have V(U²)."""
    law = moments(uniform([-1, 3], [1, 3]))
    found = sobol.indices(np.array([[1.0, 1.0], [0, 0], [0, 0]]), law)
    assert found.variance[0] == pytest.approx(36 / 3 + (1 / 5 - 1 / 9))
    assert_allclose(found.total[0], [1, 0], atol=1e-15)


def test_where_nothing_varies_every_index_is_zero_and_no_warning_is_given():
    omega, law, _ = random_problem(9, 4)
    omega[1] = 0
    with np.errstate(all="raise"):
        found = sobol.indices(omega, law)
        group = sobol.group_indices(omega, law, [[0, 1], [2, 3]])
    assert found.variance[1] == 0 and not found.first[1].any() and not found.total[1].any()
    assert not group.total[1].any() and (group.total[0] > 0).all()


@pytest.mark.parametrize("count", [1, sobol.CHUNK - 1, sobol.CHUNK, sobol.CHUNK + 1, 2 * sobol.CHUNK + 37])
@pytest.mark.parametrize("skewed", [False, True])
def test_chunks_and_memory_layout_do_not_show(count, skewed):
    omega, law, _ = random_problem(10, 5, count, skewed)
    position_last = np.ascontiguousarray(omega.transpose(1, 2, 0)).transpose(2, 0, 1)
    whole, view = sobol.indices(omega, law), sobol.indices(position_last, law)
    for p in {0, count // 2, count - 1}:
        one = sobol.indices(omega[p], law)
        for found in (whole, view):
            assert_allclose(found.first[p], one.first[0], rtol=1e-11, atol=1e-14)
            assert_allclose(found.total[p], one.total[0], rtol=1e-11, atol=1e-14)
            assert found.variance[p] == pytest.approx(one.variance[0], rel=1e-11)
    groups = sobol.group_indices(position_last, law, [[0, 1], [2, 3, 4]])
    assert_allclose(groups.total[-1], sobol.group_indices(omega[-1], law, [[0, 1], [2, 3, 4]]).total[0], rtol=1e-10)


def test_weights_are_those_of_the_squared_components():
    omega, law, _ = random_problem(11, 6)
    by_hand = sobol.indices(omega * np.sqrt([[2.0], [0.0], [5.0]]), law)
    found = sobol.indices(omega, law, (2.0, 0.0, 5.0))
    assert_allclose(found.total, by_hand.total, rtol=1e-12)
    one = sobol.indices(omega[:, 1:2], law)  # a single squared component may be given by itself
    assert_allclose(sobol.indices(omega, law, (0, 4.0, 0)).total, one.total, rtol=1e-10, atol=1e-14)


@MANY
@given(seed=SEEDS, n=st.integers(1, 9))
def test_signed_output_is_linear_first_equals_total_and_they_add_to_one(seed, n):
    omega, law, rng = random_problem(seed, n)
    weights = rng.normal(size=3)
    found = sobol.signed_indices(omega, law, weights)
    row = np.einsum("a,pan->pn", weights, omega)
    assert_allclose(found.first.sum(axis=1), 1, rtol=1e-12)
    assert_allclose(found.first, found.total)
    assert_allclose(found.first * found.variance[:, None], row**2 * law.var, rtol=1e-9)
    assert_allclose(found.mean, row @ law.mean, rtol=1e-9, atol=1e-9)
    groups = sobol.signed_group_indices(omega, law, [list(range(n // 2)), list(range(n // 2, n))], weights)
    assert_allclose(groups.first.sum(axis=1), 1, rtol=1e-12)
    assert_allclose(groups.total[:, 1], found.total[:, n // 2 :].sum(axis=1), rtol=1e-12)


@pytest.mark.parametrize(
    "weights, words",
    [
        ((0, 0, 0), "all weights are zero"),
        ((1, -1, 1), "weights must be finite and not negative"),
        ((1, np.nan, 1), "weights must be finite and not negative"),
        ((1, np.inf, 1), "weights must be finite and not negative"),
        ((1, 1), "one per component"),
    ],
)
def test_impossible_weights_are_refused(weights, words):
    omega, law, _ = random_problem(12, 3)
    for function in (sobol.indices, lambda o, m, w: sobol.group_indices(o, m, [[0]], w)):
        with pytest.raises(Refused, match=words) as refusal:
            function(omega, law, weights)
        assert refusal.value.where == "weights"


@pytest.mark.parametrize("weights", [(0, 0, 0), (np.nan, 1, 1), (1, 1)])
def test_impossible_signed_weights_are_refused(weights):
    omega, law, _ = random_problem(12, 3)
    with pytest.raises(Refused, match="weights"):
        sobol.signed_indices(omega, law, weights)


def test_omega_of_other_inputs_is_refused():
    law = Moments(*np.ones((4, 5)))
    for function in (sobol.indices, lambda o, m: sobol.group_indices(o, m, [[0]])):
        with pytest.raises(Refused, match="there are 5 inputs"):
            function(np.ones((2, 3, 4)), law)
