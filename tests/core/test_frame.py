# SPDX-License-Identifier: LGPL-2.1-or-later
"""What must not matter (where the machine stands, which way an axis counts) and what directions are accepted."""

from __future__ import annotations

import math
import re
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from sensworkbench.core import synthesis, workspace
from sensworkbench.core.distributions import Tolerance
from sensworkbench.core.errors import AXES, PAPER_SYMBOLS
from sensworkbench.core.joints import linear
from sensworkbench.core.machine import Machine, structure_chains
from sensworkbench.core.refusal import Refused
from tests.core.support import CHAINS, CONVENTIONS, UM, URAD, c_frame, machine, random_machine, turned

SEEDS = st.integers(0, 2**32 - 1)
FEW = settings(max_examples=30, deadline=None)
LOPSIDED = {
    "EXX": Tolerance(-1 * UM, 3 * UM),
    "EBY": Tolerance(-5 * URAD, 30 * URAD, "triangular"),
    "C0Y": Tolerance(0.0, 25 * URAD),
    "EAW": Tolerance(-10 * URAD, 4 * URAD),
    "ECT": Tolerance(0.0, 9 * URAD, "normal"),
}


def compare(one, other, rtol=1e-8):
    for key in ("first", "total", "total_max", "total_vw", "component_first", "component_total"):
        assert_allclose(getattr(one, key), getattr(other, key), rtol=rtol, atol=1e-12, err_msg=key)
    assert other.variance == pytest.approx(one.variance, rel=1e-8)
    assert other.mean_square == pytest.approx(one.mean_square, rel=1e-8)


def small(m):
    return workspace.sensitivity(m, workspace.quadrature(m, 2), estimate=False)


@FEW
@given(seed=SEEDS, code=st.sampled_from(CHAINS), squareness=st.sampled_from(CONVENTIONS))
def test_machine_turned_and_shifted_as_a_whole_has_the_same_indices(seed, code, squareness):
    rng = np.random.default_rng(seed)
    m = replace(random_machine(rng, code, squareness), tolerances=LOPSIDED)
    rotation = Rotation.random(random_state=seed % 2**31).as_matrix()
    compare(small(m), small(turned(m, rotation, rng.uniform(-5000, 5000, 3))))


@FEW
@given(seed=SEEDS, code=st.sampled_from(CHAINS))
def test_omega_itself_does_not_see_where_the_machine_stands(seed, code):
    rng = np.random.default_rng(seed)
    m = random_machine(rng, code, "direction")
    elsewhere = turned(m, Rotation.random(random_state=seed % 2**31).as_matrix(), rng.uniform(-5000, 5000, 3))
    q = rng.uniform(-300, 300, (4, 3))
    assert_allclose(synthesis.omega(elsewhere, PAPER_SYMBOLS, q), synthesis.omega(m, PAPER_SYMBOLS, q), atol=1e-8)


def reversed_axis(m: Machine, k: str) -> Machine:
    """The same machine with axis k counting the other way."""
    axis = m.axes[k]
    low, high = axis.travel
    flipped = replace(axis, direction=tuple(-np.array(axis.direction)), travel=(-high, -low))
    return replace(m, joints=[flipped if j.name == k else j for j in m.joints])


@pytest.mark.parametrize("squareness", CONVENTIONS)
@pytest.mark.parametrize("k", AXES)
@pytest.mark.parametrize("code", ["FXYZ", "XYFZ", "YFXZ"])
def test_axis_that_counts_backwards_gives_the_same_indices_and_the_same_frame(code, k, squareness):
    m = machine(code, (10, -20, -150), {"X": (0, -180, 200), "Z": (15, 100, 600)}, squareness=squareness)
    other = reversed_axis(m, k)
    assert_allclose(other.frame, m.frame, atol=1e-15)
    compare(small(m), small(other))


@pytest.mark.parametrize("k", AXES)
def test_left_handed_machine_with_even_tolerances_may_stand_anywhere(k):
    m = reversed_axis(c_frame(), k)
    for seed in range(4):
        rotation = Rotation.random(random_state=seed).as_matrix()
        compare(small(m), small(turned(m, rotation, np.array([100.0, -200.0, 300.0]))))


@FEW
@given(seed=SEEDS)
def test_frame_is_right_handed_and_orthonormal_with_x_along_the_x_axis(seed):
    rng = np.random.default_rng(seed)
    m = random_machine(rng, "XYFZ", "direction", skew_deg=4)
    m = turned(m, Rotation.random(random_state=seed % 2**31).as_matrix(), np.zeros(3))
    frame = m.frame
    assert_allclose(frame.T @ frame, np.eye(3), atol=1e-12)
    assert np.linalg.det(frame) == pytest.approx(1.0)
    assert_allclose(frame[:, 0], m.axes["X"].direction, atol=1e-12)
    assert frame[:, 1] @ np.array(m.axes["Y"].direction) > 0.99


# -- skew --------------------------------------------------------------
def skewed(pair: str, angle_deg: float) -> dict:
    """Directions in which the second axis of `pair` leans by `angle_deg` towards the first."""
    a = math.radians(angle_deg)
    u = dict(zip(AXES, np.eye(3)))
    first, second = pair
    return {second: math.cos(a) * u[second] + math.sin(a) * u[first]}


@FEW
@given(pair=st.sampled_from(["XY", "XZ", "YZ"]), angle=st.floats(-4.99, 4.99))
def test_skew_below_five_degrees_works_and_is_reported(pair, angle):
    m = machine("XYFZ", directions=skewed(pair, angle))
    report = m.skew_deg
    assert report[pair] == pytest.approx(-angle, abs=1e-9)
    assert all(abs(v) < 1e-9 for k, v in report.items() if k != pair)
    assert np.isfinite(small(m).total).all()


@FEW
@given(pair=st.sampled_from(["XY", "XZ", "YZ"]), angle=st.floats(5.01, 80), sign=st.sampled_from([-1, 1]))
def test_more_than_five_degrees_is_refused_with_the_names_of_both_axes(pair, angle, sign):
    with pytest.raises(Refused) as refusal:
        machine("XYFZ", directions=skewed(pair, sign * angle))
    message = refusal.value.message
    assert refusal.value.code == "machine-axes-not-square" and "5 from square" in message
    assert f"axes {pair[0]}, {pair[1]}, direction" in refusal.value.where and refusal.value.do


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("pair", ["XY", "XZ", "YZ"])
def test_parallel_axes_are_refused_as_parallel(pair, sign):
    u = dict(zip(AXES, np.eye(3)))
    with pytest.raises(Refused, match=f"axes {pair[0]} and {pair[1]} are parallel"):
        machine("XYFZ", directions={pair[1]: sign * u[pair[0]]})


def test_skew_is_taken_into_the_model():
    """With Z leaning by 3 degrees the squareness column follows the real direction: q s x u."""
    m = machine("FXYZ", directions=skewed("YZ", 3.0))
    u = np.array([0, math.sin(math.radians(3)), math.cos(math.radians(3))])
    found = synthesis.omega(m, ["A0Z", "B0Z"], (0.0, 0.0, 100.0))[0]
    assert_allclose(found[:, 0], 100 * np.cross((1, 0, 0), u), atol=1e-12)
    assert_allclose(found[:, 1], 100 * np.cross((0, 1, 0), u), atol=1e-12)


# -- chains --------------------------------------------------------------
@FEW
@given(code=st.sampled_from(CHAINS))
def test_structure_code_and_chains_say_the_same(code):
    workpiece, tool = structure_chains(code)
    assert machine(code).structure == code
    assert tool == tuple(code.split("F")[1])
    assert workpiece == tuple(reversed(code.split("F")[0]))


def test_xyfz_is_a_table_on_a_saddle():
    assert structure_chains("XYFZ") == (("Y", "X"), ("Z",))


@settings(max_examples=200)
@given(text=st.text(max_size=6))
def test_anything_else_is_not_a_structure_code(text):
    letters = text.strip().upper()
    names = re.findall("[A-Z][0-9]?", letters)
    assume("".join(names) != letters or names.count("F") != 1 or len(names) < 2 or len(set(names)) < len(names))
    with pytest.raises(Refused, match="is not a structure code"):
        structure_chains(text)


def test_direction_is_made_a_unit_vector_within_a_thousandth():
    axis = linear("X", (1.0005, 0, 0), (0, 0, 0), (0, 1))
    assert axis.direction == pytest.approx((1, 0, 0), abs=1e-15)


def test_a_left_handed_machine_says_that_its_frame_is_the_nearest_to_the_file():
    m = c_frame()
    assert not m.left_handed
    for k in AXES:
        other = reversed_axis(m, k)
        assert other.left_handed
        for seed in range(3):
            rotation = Rotation.random(random_state=seed).as_matrix()
            assert turned(other, rotation, np.zeros(3)).left_handed
            assert not turned(m, rotation, np.zeros(3)).left_handed
    assert not reversed_axis(reversed_axis(m, "X"), "Z").left_handed
