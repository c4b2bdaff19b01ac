# SPDX-License-Identifier: LGPL-2.1-or-later
"""Indices over the workspace: what the means mean, how fast quadrature converges, how honest its error estimate is."""

from __future__ import annotations

import itertools
from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from sensworkbench.core import sobol, synthesis, workspace
from sensworkbench.core.distributions import Tolerance, moments
from sensworkbench.core.effects import Effect
from sensworkbench.core.errors import PAPER_SYMBOLS
from sensworkbench.core.objectives import objective as Objective
from sensworkbench.core.refusal import Refused
from sensworkbench.core.shapes import Linear
from tests.core.support import CONVENTIONS, UM, URAD, c_frame, machine

POINT = Tolerance(0.0, 0.0)
FROZEN = dict.fromkeys(PAPER_SYMBOLS, POINT)


def total(m, positions, **more):
    return workspace.sensitivity(m, positions, **more).total


@pytest.fixture(scope="module")
def truth():
    m = c_frame()
    return total(m, workspace.quadrature(m, 20), estimate=False)


def off(m, positions, truth):
    return np.abs(total(m, positions, estimate=False) - truth).max()


# -- quadrature and grid --------------------------------------------------------------
def test_truth_does_not_depend_on_the_order_it_was_taken_at(truth):
    m = c_frame()
    assert off(m, workspace.quadrature(m, 16), truth) < 1e-14


def test_five_gauss_positions_per_axis_give_six_digits_and_eight_give_nine(truth):
    m = c_frame()
    assert off(m, workspace.quadrature(m, 5), truth) < 1e-6
    assert off(m, workspace.quadrature(m, 8), truth) < 4e-10


def test_the_plain_grid_counts_its_end_points_too_much(truth):
    m = c_frame()
    fine, coarse = off(m, workspace.grid(m, 21), truth), off(m, workspace.grid(m, 11), truth)
    assert 4e-3 < fine < 7e-3
    assert coarse / fine == pytest.approx(2, rel=0.15)  # first order in the spacing


@pytest.mark.parametrize("squareness", CONVENTIONS)
@pytest.mark.parametrize("order", [3, 4, 5, 6, 8])
@pytest.mark.parametrize("code", ["FXYZ", "XYFZ", "YFXZ"])
def test_estimated_error_is_an_upper_bound_and_shrinks(code, order, squareness):
    m = c_frame(code=code, squareness=squareness)
    exact = total(m, workspace.quadrature(m, 18), estimate=False)
    found = workspace.sensitivity(m, workspace.quadrature(m, order))
    actual = np.abs(found.total - exact).max()
    assert actual <= found.estimated_error
    if order > 3:
        before = workspace.sensitivity(m, workspace.quadrature(m, order - 1)).estimated_error
        assert found.estimated_error < before / 2


def test_default_is_quadrature_that_states_its_error():
    found = workspace.sensitivity(c_frame())
    assert found.positions.kind == "quadrature" and found.positions.counts == (8, 8, 8)
    assert 0 < found.estimated_error < 1e-7


def test_grid_and_single_position_state_no_error():
    m = c_frame()
    assert workspace.sensitivity(m, workspace.grid(m, 3)).estimated_error is None
    assert workspace.sensitivity(m, workspace.at(m, (1, 2, 3))).estimated_error is None


def test_quadrature_integrates_polynomials_over_the_travel():
    m = c_frame()
    p = workspace.quadrature(m, (3, 4, 5))
    assert p.counts == (3, 4, 5) and len(p.q) == 60
    low, high = m.travel.T
    for powers in itertools.product((0, 1, 2, 3), repeat=3):
        exact = np.prod([(h ** (k + 1) - l ** (k + 1)) / (k + 1) / (h - l) for k, l, h in zip(powers, low, high)])
        scale = np.prod([max(abs(l), abs(h)) ** k for k, l, h in zip(powers, low, high)])
        found = p.weights @ np.prod(p.q ** np.array(powers), axis=1)
        assert found == pytest.approx(exact, abs=1e-13 * scale)


def test_grid_has_its_end_points_and_weighs_all_positions_alike():
    m = c_frame()
    p = workspace.grid(m, (2, 3, 5))
    assert_allclose(p.weights, 1 / 30)
    assert_allclose([p.q.min(axis=0), p.q.max(axis=0)], m.travel.T)
    assert len(np.unique(p.q, axis=0)) == 30


# -- what the numbers are --------------------------------------------------------------
def one_by_one(m, q, objective=Objective()):
    law = moments(m.all_tolerances.values())
    symbols = list(m.all_tolerances)
    return [sobol.indices(synthesis.omega(m, symbols, p, output=objective.output), law, objective.weights) for p in q]


@pytest.mark.parametrize("output", ["position", "orientation"])
def test_means_maximum_and_variance_weighted_mean_are_those_of_the_positions(output):
    m = c_frame(squareness="carried", tolerances={"EBX": Tolerance(-5 * URAD, 40 * URAD)})
    objective = Objective(output, (1.0, 2.0, 0.5))
    p = workspace.grid(m, (3, 2, 4))
    found = workspace.sensitivity(m, p, objective)
    each = one_by_one(m, p.q, objective)
    first, total_ = (np.array([getattr(e, k)[0] for e in each]) for k in ("first", "total"))
    variance = np.array([e.variance[0] for e in each])
    assert_allclose(found.first, first.mean(axis=0), rtol=1e-10, atol=1e-14)
    assert_allclose(found.total, total_.mean(axis=0), rtol=1e-10, atol=1e-14)
    assert_allclose(found.total_max, total_.max(axis=0), rtol=1e-10, atol=1e-14)
    assert_allclose(found.total_vw, variance @ total_ / variance.sum(), rtol=1e-10, atol=1e-14)
    assert_allclose(found.first_vw, variance @ first / variance.sum(), rtol=1e-10, atol=1e-14)
    assert found.variance == pytest.approx(variance.mean())
    assert found.mean_square == pytest.approx(np.mean([e.mean[0] for e in each]))


def test_many_positions_are_taken_in_pieces_without_a_seam():
    m = c_frame()
    p = workspace.grid(m, (17, 17, 17))
    assert len(p.q) > workspace.CHUNK
    symbols = list(m.all_tolerances)
    law = moments(m.all_tolerances.values())
    whole = sobol.indices(synthesis.omega(m, symbols, p.q), law)
    found = workspace.sensitivity(m, p)
    assert_allclose(found.first, whole.first.mean(axis=0), rtol=1e-11, atol=1e-15)
    assert_allclose(found.total, whole.total.mean(axis=0), rtol=1e-11, atol=1e-15)
    assert_allclose(found.total_max, whole.total.max(axis=0), rtol=1e-11, atol=1e-15)
    assert found.variance == pytest.approx(whole.variance.mean(), rel=1e-12)


def test_components_own_their_errors_and_squareness_belongs_to_the_later_axis():
    found = workspace.sensitivity(c_frame(), workspace.quadrature(c_frame(), 2))
    owners = dict(zip(found.symbols, found.owners))
    assert found.bodies == ("X", "Y", "Z", "T")
    assert (owners["EAX"], owners["C0Y"], owners["A0Z"], owners["B0Z"], owners["EXT"]) == ("X", "Y", "Z", "Z", "T")
    for body, group in zip(found.bodies, found.component_total):
        members = found.total[[o == body for o in found.owners]]
        assert members.max() - 1e-12 <= group <= members.sum() + 1e-12


def test_dropping_a_component_drops_what_only_moves_along_it():
    """Without the x component the X positioning error is of no account."""
    m = c_frame()
    p = workspace.quadrature(m, 2)
    found = workspace.sensitivity(m, p, Objective(weights=(0, 1, 1)), estimate=False)
    table = dict(zip(found.symbols, found.total))
    assert table["EXX"] == table["EXY"] == table["EXZ"] == table["EXT"] == table["B0Z"] == 0
    assert table["EAZ"] > 0.01


def test_signed_component_has_first_equal_total_adding_to_one():
    m = c_frame()
    found = workspace.sensitivity(m, workspace.quadrature(m, 3), Objective(weights=(0, 0, -1), signed=True))
    assert_allclose(found.first, found.total)
    assert found.total.sum() == pytest.approx(1)
    assert found.component_total.sum() == pytest.approx(1)
    low, high = zip(*[(t.lower, t.upper) for t in m.all_tolerances.values()])
    row = synthesis.omega(m, found.symbols, workspace.quadrature(m, 3).q)[:, 2]
    by_hand = workspace.quadrature(m, 3).weights @ ((row * (np.array(high) - low)) ** 2).sum(axis=1) / 12
    assert found.variance == pytest.approx(by_hand)


def test_orientation_is_the_same_everywhere_and_only_angles_matter():
    m = c_frame()
    found = workspace.sensitivity(m, workspace.grid(m, 2), Objective("orientation"))
    assert_allclose(found.total, found.total_max, rtol=1e-12)
    turning = {s for s, v in zip(found.symbols, found.total) if v > 0}
    assert turning == {f"E{a}{k}" for a in "ABC" for k in "XYZ"}
    carried = c_frame(squareness="carried")
    found = workspace.sensitivity(carried, workspace.grid(carried, 2), Objective("orientation"))
    assert {"C0Y", "A0Z", "B0Z"} <= {s for s, v in zip(found.symbols, found.total) if v > 0}


def test_traced_effect_takes_part_with_the_range_it_reached():
    """An effect that swings EAZ by +-20 urad counts exactly like the declared EAZ of +-20 urad."""
    effect = Effect("column bends", "EAZ", "temp_column", Linear(), (5e-6,), reach=(-20e-6, 20e-6))
    m = c_frame(effects=(effect,))
    found = workspace.sensitivity(m, workspace.quadrature(m, 3), estimate=False)
    table = dict(zip(found.symbols, found.total))
    assert table["column bends"] == pytest.approx(table["EAZ"], rel=1e-12) and table["EAZ"] > 0.01
    assert dict(zip(found.symbols, found.owners))["column bends"] == "Z"
    off_ = workspace.sensitivity(replace(m, effects=(replace(effect, enabled=False),)), workspace.quadrature(m, 3))
    assert "column bends" not in off_.symbols


# -- refusals and cancelling --------------------------------------------------------------
def test_zero_variance_everywhere_is_refused():
    m = c_frame(tolerances=FROZEN)
    with pytest.raises(Refused, match="nothing varies") as refusal:
        workspace.sensitivity(m, workspace.quadrature(m, 2))
    assert refusal.value.where == "tolerances" and refusal.value.do


def test_objective_that_nothing_moves_is_refused():
    """Only EXX varies, and only the y component is judged."""
    m = c_frame(tolerances=FROZEN | {"EXX": Tolerance(-1 * UM, 1 * UM)})
    with pytest.raises(Refused, match="nothing varies"):
        workspace.sensitivity(m, workspace.quadrature(m, 2), Objective(weights=(0, 1, 0)))
    only = workspace.sensitivity(m, workspace.quadrature(m, 2))
    assert_allclose(only.total, [s == "EXX" for s in only.symbols])


def test_variance_at_some_positions_only_is_enough():
    """A lever arm that is 0 at one position: indices are 0 there and the mean counts it."""
    m = machine("FXYZ", (0, 0, 0), tolerances=FROZEN | {"C0Y": Tolerance(-1 * URAD, 1 * URAD)})
    p = workspace.Positions(np.array([[0, 0, 0], [0, 100.0, 0]]), np.array([0.5, 0.5]), (2, 1, 1), "grid")
    found = workspace.sensitivity(m, p)
    table = dict(zip(found.symbols, found.total))
    assert table["C0Y"] == pytest.approx(0.5)
    assert dict(zip(found.symbols, found.total_vw))["C0Y"] == pytest.approx(1.0)


@pytest.mark.parametrize(
    "weights, signed, words",
    [
        ((0, 0, 0), False, "one of them not 0"),
        ((1, 1), False, "not three finite numbers"),
        ((1, np.nan, 1), False, "not three finite numbers"),
        ((1, np.inf, 1), True, "not three finite numbers"),
        ((1, -1, 0), False, "must not be negative"),
    ],
)
def test_impossible_objectives_are_refused(weights, signed, words):
    with pytest.raises(Refused, match=words) as refusal:
        Objective(weights=weights, signed=signed)
    assert refusal.value.where == "objective"


def test_unknown_output_is_refused():
    with pytest.raises(Refused, match="unknown output 'speed'"):
        Objective("speed")


@pytest.mark.parametrize("count", [0, -3, 2.5, (3, 3), (3, 3, 0), 1000])
def test_impossible_numbers_of_positions_are_refused(count):
    for make in (workspace.quadrature, workspace.grid):
        with pytest.raises(Refused) as refusal:
            make(c_frame(), count)
        assert refusal.value.where == "positions"


def test_grid_of_one_point_per_axis_is_refused_but_one_gauss_position_is_the_middle():
    m = c_frame()
    with pytest.raises(Refused, match="Give at least 2"):
        workspace.grid(m, 1)
    assert_allclose(workspace.quadrature(m, 1).q, [m.travel.mean(axis=1)])


@pytest.mark.parametrize("position", [(np.nan, 0, 0), (0, np.inf, 0)])
def test_position_that_is_not_finite_is_refused(position):
    with pytest.raises(Refused, match="is not finite"):
        workspace.at(c_frame(), position)


def test_cancel_stops_at_once_and_progress_runs_from_0_to_1():
    m = c_frame()
    seen = []
    workspace.sensitivity(m, workspace.quadrature(m, 17), progress=lambda part: seen.append(part) or True)
    assert seen == sorted(seen) and seen[-1] == 1.0 and len(seen) >= 3 and seen[0] < 1
    calls = []
    with pytest.raises(workspace.Cancelled):
        workspace.sensitivity(m, workspace.quadrature(m, 17), progress=lambda part: calls.append(part))
    assert len(calls) == 1
