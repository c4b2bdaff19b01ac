# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shares add up to one and agree with the definition: by enumeration of all orders, by sampling, by exact fractions."""

from __future__ import annotations

import itertools
import math
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

from sensworkbench.core import workspace
from sensworkbench.core.distributions import Tolerance, moments
from sensworkbench.core.objectives import objective
from sensworkbench.core.refusal import Refused
from sensworkbench.core.shapley import checked_covariance, gaussian_shares
from sensworkbench.core.sobol import group_indices, indices
from sensworkbench.core.sources import Source
from tests.core.support import UM, URAD, c_frame


def covariance(rng, n, rank=None):
    root = rng.normal(size=(n, rank or n))
    return root @ root.T


# -- independent errors ------------------------------------------------------------------------------------------------
def test_shares_of_the_exact_example_are_its_fractions():
    """T1 = X1 - X2/5, T2 = X2/10 + X3: S and S^T as exact fractions; the share is their mean."""
    omega = np.array([[1, -0.2, 0], [0, 0.1, 1], [0, 0, 0]])
    found = indices(omega, moments([Tolerance(-w, w) for w in (1, 20, 5)]))
    first = [Fraction(1, 1606), Fraction(200, 803), Fraction(625, 1606)]
    total = [Fraction(81, 1606), Fraction(490, 803), Fraction(1125, 1606)]
    share = [(a + b) / 2 for a, b in zip(first, total)]
    assert sum(share) == 1
    assert (found.first[0] + found.total[0]) / 2 == pytest.approx([float(s) for s in share], abs=1e-15)


@pytest.mark.parametrize("signed", [False, True])
def test_shares_of_a_machine_add_up_to_one(signed):
    found = workspace.sensitivity(c_frame(), objective=objective(signed=signed))
    assert found.share.sum() == pytest.approx(1, abs=1e-12)
    assert found.component_share.sum() == pytest.approx(1, abs=1e-12)
    assert np.all(found.share >= 0)


def test_the_share_of_a_component_is_the_sum_of_its_members_shares():
    """True because nothing exists above pairs; for higher orders groups would have shares of their own."""
    found = workspace.sensitivity(c_frame(), workspace.quadrature(c_frame(), 3))
    for body, share in zip(found.bodies, found.component_share):
        members = [i for i, owner in enumerate(found.owners) if owner == body]
        assert share == pytest.approx(found.share[members].sum(), abs=1e-12)


# -- correlated normal errors ------------------------------------------------------------------------------------------
def by_definition(omega, mean, cov, groups, weights):
    """Mean marginal gain over all orders, with V(E[Y|X_u]) from conditional means and covariances of normals."""
    a = omega.T @ np.diag(weights) @ omega

    def worth(u):
        members = [i for g in u for i in groups[g]]
        if not members:
            return 0.0
        k = cov[:, members] @ np.linalg.pinv(cov[np.ix_(members, members)], rcond=1e-10)
        b, c = k.T @ a @ k, 2 * k.T @ a @ mean
        inner = cov[np.ix_(members, members)]
        return 2 * np.trace(b @ inner @ b @ inner) + c @ inner @ c

    shares = np.zeros(len(groups))
    for order in itertools.permutations(range(len(groups))):
        for i, g in enumerate(order):
            shares[g] += worth(order[: i + 1]) - worth(order[:i])
    return shares / math.factorial(len(groups)) / worth(tuple(range(len(groups))))


@pytest.mark.parametrize("rank", [None, 3])
@pytest.mark.parametrize("seed", range(4))
def test_shapley_effects_are_those_of_the_definition(seed, rank):
    rng = np.random.default_rng(seed)
    n, groups = 7, [[0, 1], [2], [3, 4, 5], [6]]
    omega, mean, cov = rng.normal(size=(3, n)), rng.normal(size=n), covariance(rng, n, rank)
    weights = rng.uniform(0.2, 2, 3)
    found = gaussian_shares(omega, mean, cov, groups, weights)
    assert found.shares[0] == pytest.approx(by_definition(omega, mean, cov, groups, weights), abs=1e-9)
    assert found.shares.sum() == pytest.approx(1, abs=1e-12)


def test_independent_normals_have_the_shares_of_the_closed_form():
    rng = np.random.default_rng(3)
    laws = [Tolerance(-w, 2 * w, "normal") for w in rng.uniform(1, 3, 6)]
    law, omega = moments(laws), rng.normal(size=(5, 3, 6))
    groups = [[0, 1], [2, 3, 4], [5]]
    found = gaussian_shares(omega, law.mean, np.diag(law.var), groups)
    known = group_indices(omega, law, groups)
    assert found.shares == pytest.approx((known.first + known.total) / 2, abs=1e-12)
    assert found.first == pytest.approx(known.first, abs=1e-12) and found.total == pytest.approx(known.total, abs=1e-12)
    assert found.mean == pytest.approx(known.mean) and found.variance == pytest.approx(known.variance)


def test_mean_and_variance_agree_with_sampling():
    rng = np.random.default_rng(4)
    omega, mean, cov = rng.normal(size=(3, 5)), rng.normal(size=5), covariance(rng, 5)
    found = gaussian_shares(omega, mean, cov, [[0, 1, 2], [3, 4]])
    y = ((rng.multivariate_normal(mean, cov, 400_000) @ omega.T) ** 2).sum(axis=1)
    assert found.mean[0] == pytest.approx(y.mean(), rel=5 * y.std() / y.mean() / math.sqrt(len(y)))
    spread = ((y - y.mean()) ** 2).std() / math.sqrt(len(y))
    assert found.variance[0] == pytest.approx(y.var(), abs=5 * spread)


def test_an_error_that_follows_another_shares_its_worth():
    """Two copies of one cause are worth the same, whatever each is called."""
    cov = np.array([[1.0, 1, 0], [1, 1, 0], [0, 0, 1]])
    found = gaussian_shares(np.diag([1.0, 0, 1]), np.zeros(3), cov, [[0], [1], [2]])
    assert found.shares[0] == pytest.approx([0.25, 0.25, 0.5], abs=1e-12)


@pytest.mark.parametrize(
    "matrix, code",
    [
        (np.eye(2), "covariance-shape"),
        (np.diag([1, np.nan, 1]), "covariance-not-finite"),
        (np.array([[1, 0.5, 0], [0.2, 1, 0], [0, 0, 1]]), "covariance-not-symmetric"),
        (np.diag([1.0, -1, 1]), "covariance-negative-variance"),
        (np.array([[1, 2, 0], [2, 1, 0], [0, 0, 1.0]]), "covariance-correlation"),
        (np.array([[1, 0.9, -0.9], [0.9, 1, 0.9], [-0.9, 0.9, 1]]), "covariance-not-positive"),
    ],
)
def test_a_matrix_that_is_no_covariance_is_refused_with_a_remedy(matrix, code):
    with pytest.raises(Refused) as refused:
        checked_covariance(matrix, 3)
    assert refused.value.code == code and refused.value.do
    if code == "covariance-not-positive":  # the remedy works
        shrunk = np.where(np.eye(3, dtype=bool), matrix, matrix * refused.value.fields["shrink"])
        assert checked_covariance(shrunk, 3) is not None


# -- sources -----------------------------------------------------------------------------------------------------------
RAIL = Source("rail", Tolerance(-1, 1), {"EXX": 4 * UM, "EAX": -15 * URAD, "EBX": 5 * URAD})
ROOM = Source("room", Tolerance(-2, 2, "normal"), {"EXX": 1 * UM, "EYY": 1.5 * UM, "EZZ": 0.8 * UM})


def test_a_source_is_one_input_whose_column_is_the_sum_of_what_it_moves():
    m = replace(c_frame(), sources=(RAIL, ROOM))
    table = workspace.error_table(m)
    assert table.labels[-2:] == ("rail", "room") and table.owners[-2:] == ("X", "room")
    assert not {"EXX", "EAX", "EBX", "EYY", "EZZ"} & set(table.labels)  # they have no tolerance of their own left
    q = np.array([[10.0, -50.0, -30.0]])
    from sensworkbench.core.synthesis import omega

    whole = table.mixed(omega(m, table.symbols, q))[0]
    alone = omega(m, list(RAIL.factors), q)[0]
    assert whole[:, -2] == pytest.approx(alone @ np.array(list(RAIL.factors.values())), abs=1e-15)


def test_a_stated_tolerance_of_a_followed_error_is_an_independent_part():
    m = replace(c_frame(), sources=(RAIL,), tolerances={"EXX": Tolerance(-1 * UM, 1 * UM)})
    assert "EXX" in workspace.error_table(m).labels


@pytest.mark.parametrize("signed", [False, True])
def test_indices_with_sources_agree_with_sampling_of_machines(signed):
    m = replace(c_frame(), sources=(RAIL, ROOM))
    q = np.array([100.0, -80.0, -120.0])
    found = workspace.sensitivity(m, workspace.at(m, q), objective(signed=signed))
    assert found.share.sum() == pytest.approx(1, abs=1e-12) and found.component_share.sum() == pytest.approx(1)
    rng = np.random.default_rng(8)
    table = workspace.error_table(m)
    n = 200_000
    s = np.stack([
        rng.uniform(t.lower, t.upper, n) if t.distribution == "uniform" else rng.normal(0, t.moments[1] ** 0.5, n)
        for t in table.laws
    ])  # fmt: skip
    from sensworkbench.core.synthesis import omega

    error = omega(m, table.symbols, q)[0] @ (table.mixing @ s)
    y = error.sum(axis=0) if signed else (error**2).sum(axis=0)
    assert found.mean_square == pytest.approx(y.mean(), abs=5 * y.std() / math.sqrt(n))
    assert found.variance == pytest.approx(y.var(), rel=0.03)


def test_a_source_of_one_error_is_that_error():
    m = c_frame()
    one = replace(m, sources=(Source("pitch", Tolerance(-1, 1), {"EBX": 20 * URAD}),))
    a, b = (workspace.sensitivity(x, workspace.quadrature(x, 3)) for x in (m, one))
    before = dict(zip(a.symbols, a.total)) | {"pitch": a.total[a.symbols.index("EBX")]}
    for symbol, total in zip(b.symbols, b.total):
        assert total == pytest.approx(before[symbol], abs=1e-13)


@pytest.mark.parametrize(
    "sources, code",
    [
        ((RAIL, RAIL), "source-name-taken"),
        ((Source("X", Tolerance(0, 1), {"EXX": 1.0}),), "source-name-taken"),
        ((Source("s", Tolerance(0, 1), {"EXC": 1.0}),), "component-unknown"),
    ],
)
def test_sources_that_cannot_be_are_refused(sources, code):
    with pytest.raises(Refused) as refused:
        replace(c_frame(), sources=sources)
    assert refused.value.code == code
