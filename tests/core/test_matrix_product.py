# SPDX-License-Identifier: LGPL-2.1-or-later
"""The linear synthesis against the exact product of homogeneous matrices, for every serial chain of three axes.

The matrices are built here from matrix exponentials (`support.matrix_product_error`), apart from the library's own.
"""

from __future__ import annotations

import numpy as np
import pytest
from numpy.testing import assert_allclose

from sensworkbench.core import synthesis
from sensworkbench.core.errors import COMPONENTS
from tests.core.support import CHAINS, CONVENTIONS, UM, URAD, machine, matrix_product_error, random_machine

SYMBOLS = list(COMPONENTS)


def random_errors(rng, symbols=SYMBOLS, size=1.0):
    """5 um and 20 urad, one standard deviation."""
    return {s: size * rng.normal() * (20 * URAD if COMPONENTS[s].angular else 5 * UM) for s in symbols}


def scaled(values, ratio):
    return {s: v * ratio for s, v in values.items()}


def random_case(code, squareness, skew_deg=3.0):
    rng = np.random.default_rng(CHAINS.index(code) + 100 * (squareness == "carried"))
    m = random_machine(rng, code, squareness, skew_deg)
    q = rng.uniform(-300, 300, (3, 3))
    offset = rng.uniform(-100, 100, (3, 3))
    return m, q, offset, random_errors(rng)


def test_there_are_24_chains():
    assert len(set(CHAINS)) == 24


@pytest.mark.parametrize("squareness", CONVENTIONS)
@pytest.mark.parametrize("code", CHAINS)
def test_linear_synthesis_is_the_derivative_of_the_matrix_product(code, squareness):
    """A central difference of the exact product leaves third order only: agreement to a picometre at a tenth size."""
    m, q, offset, values = random_case(code, squareness)
    step = 0.1
    linear_t = synthesis.volumetric_error(m, values, q, offset)
    linear_r = synthesis.volumetric_error(m, values, q, offset, output="orientation")
    for p in range(len(q)):
        plus = matrix_product_error(m, scaled(values, step), q[p], offset[p])
        minus = matrix_product_error(m, scaled(values, -step), q[p], offset[p])
        assert_allclose((plus[0] - minus[0]) / (2 * step), linear_t[p], atol=1e-9)
        assert_allclose((plus[1] - minus[1]) / (2 * step), linear_r[p], atol=1e-12)
    assert np.abs(linear_t).max() > 1e-3  # and there was something to agree about


@pytest.mark.parametrize("squareness", CONVENTIONS)
@pytest.mark.parametrize("code", CHAINS)
def test_library_matrix_product_is_the_same_matrix_product(code, squareness):
    m, q, offset, values = random_case(code, squareness)
    position, orientation = synthesis.exact_error(m, values, q, offset)
    for p in range(len(q)):
        t, r = matrix_product_error(m, values, q[p], offset[p])
        assert_allclose(position[p], t, atol=1e-11)
        assert_allclose(orientation[p], r, atol=1e-15)


@pytest.mark.parametrize("code", CHAINS)
def test_second_order_is_a_few_nanometres_at_usual_sizes(code):
    """21 errors of 5 um and 20 urad, +-300 mm, references at 0: the exact product differs by nanometres."""
    rng = np.random.default_rng(5)
    q = rng.uniform(-300, 300, (400, 3))
    declared = [s for s, c in COMPONENTS.items() if c.body in "XYZ"]
    scale = np.array([20 * URAD if COMPONENTS[s].angular else 5 * UM for s in declared])
    values = dict(zip(declared, (rng.normal(size=(400, len(declared))) * scale).T))
    m = machine(code)
    difference = synthesis.volumetric_error(m, values, q) - synthesis.exact_error(m, values, q)[0]
    rms = np.sqrt((difference**2).sum(axis=1).mean())
    assert 1e-8 < rms < 2.4e-6
    assert np.abs(difference).max() < 6e-6


@pytest.mark.parametrize("squareness", CONVENTIONS)
@pytest.mark.parametrize("symbol", SYMBOLS)
def test_each_column_of_omega_is_one_small_motion(symbol, squareness):
    """One error at a time, on one machine with axes on both sides: a wrong sign cannot hide behind another."""
    m = random_machine(np.random.default_rng(11), "XYFZ", squareness)
    q = np.array([170.0, -120.0, 80.0])
    unit = 1e-7
    plus, minus = (matrix_product_error(m, {symbol: s * unit}, q) for s in (1, -1))
    column = synthesis.omega(m, [symbol], q)[0, :, 0]
    turn = synthesis.omega(m, [symbol], q, output="orientation")[0, :, 0]
    assert_allclose((plus[0] - minus[0]) / (2 * unit), column, atol=1e-5)  # of arms of some 100 mm per rad
    assert_allclose((plus[1] - minus[1]) / (2 * unit), turn, atol=1e-9)


def test_straightness_and_positioning_move_the_tool_by_themselves():
    omega = synthesis.omega(machine("XYFZ"), ["EXX", "EYX", "EZX"], (1.0, 2.0, 3.0))[0]
    assert_allclose(omega, np.eye(3))


def test_omega_is_laid_out_position_last():
    omega = synthesis.omega(machine("XYFZ"), SYMBOLS, np.zeros((50, 3)))
    assert omega.shape == (50, 3, len(SYMBOLS))
    assert omega.transpose(1, 2, 0).flags.c_contiguous


def test_tool_offset_lengthens_every_lever_arm_alike():
    m = machine("YFXZ", references={"X": (1, 2, 3)})
    q = np.array([[10.0, 20.0, 30.0], [-40.0, 50.0, -60.0]])
    offset = np.array([[5.0, -6.0, 7.0], [0.0, 8.0, 0.0]])
    plain, longer = m.lever_arms(q), m.lever_arms(q, offset)
    for body in "XYZTW":
        assert_allclose(longer[body] - plain[body], offset)


def test_abbe_offset_is_the_functional_point_minus_the_reference_where_both_are():
    """XYFZ: the table moves by -x, -y against the head; the head moves by z."""
    references = {"X": (10, 20, 30), "Y": (-40, 50, -60), "Z": (70, -80, 90)}
    m = machine("XYFZ", (1, 2, -150), references, workpiece_reference=(5, 6, 7))
    x, y, z = q = (200.0, 150.0, -100.0)
    point = np.array([1, 2, -150 + z])
    arms = m.lever_arms(q)
    assert_allclose(arms["Z"][0], point - (70, -80, 90 + z))
    assert_allclose(arms["Y"][0], point - (-40, 50 - y, -60))
    assert_allclose(arms["X"][0], point - (10 - x, 20 - y, 30))
    assert_allclose(arms["W"][0], point - (5 - x, 6 - y, 7))
    assert_allclose(arms["T"][0], (0, 0, 0))
