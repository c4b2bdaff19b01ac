# SPDX-License-Identifier: LGPL-2.1-or-later
"""The declared model of a set of readings: its columns are the matrix product's, and what it cannot see it says."""

from __future__ import annotations

import re

import numpy as np
import pytest

from sensworkbench.closedloop.design import ALL_SYMBOLS, design, lever_columns
from sensworkbench.closedloop.fit import basis, fit, null_space
from sensworkbench.closedloop.readings import Readings
from tests.simulator import CODES
from tests.simulator.kinematics import COMPONENTS, SQUARENESS, exact_error

from .support import APART, both, grid, scattered

ONE_SHORT = ((0.0, 0.0, 0.0),)
TWO = ((0.0, 0.0, 50.0), (0.0, 0.0, -100.0))  # from a tool point 150 mm below the reference: lengths 100 and 250
THREE = ((0.0, 0.0, 0.0), (80.0, 0.0, -60.0), (0.0, 80.0, -120.0))  # not on one line


def readings_with(tools, side=5) -> Readings:
    """A grid measured once with each tool, noiseless zeros: only the plan matters."""
    q = np.concatenate([grid(side)] * len(tools))
    offset = np.repeat(np.array(tools), side**3, axis=0)
    return Readings.from_vectors(q, np.zeros_like(q), tool_offset=offset)


def ranks(code, tools, tool_point=(0, 0, -150)) -> tuple[int, int]:
    """(declared coefficients, how many of them show beside alignment and tool offsets)."""
    _, machine = both(code, tool_point)
    model = design(machine, readings_with(tools))
    declared = np.array([t.group == "declared" for t in model.terms])
    one = np.ones(len(model.matrix))
    return int(declared.sum()), basis(model.matrix, one).rank - basis(model.matrix[:, ~declared], one).rank


@pytest.mark.parametrize("code", CODES)
def test_every_column_is_what_the_exact_product_does_with_a_small_error(code):
    simulated, machine = both(code, (10, -20, -150), APART)
    q, tool = scattered(30, 1), scattered(30, 2, 60.0)
    rows = Readings.from_vectors(q, np.zeros_like(q), tool_offset=tool)
    lever = lever_columns(machine, rows)
    for symbol in (*COMPONENTS, *SQUARENESS):
        tiny = 1e-6 if symbol[1] in "XYZ" else 1e-9  # mm, rad
        shown = exact_error(simulated, q, {symbol: tiny}, tool).ravel() / tiny
        assert lever[:, ALL_SYMBOLS.index(symbol)] == pytest.approx(shown, abs=2e-3), symbol


@pytest.mark.parametrize("code", ["FXYZ", "XYFZ", "YFXZ", "XFZY"])
def test_the_declared_model_times_its_coefficients_is_the_exact_product_to_second_order(code):
    simulated, machine = both(code, (10, -20, -150), APART)
    q = grid()
    model = design(machine, Readings.from_vectors(q, np.zeros_like(q)))
    rng = np.random.default_rng(4)
    theta = np.zeros(len(model.terms))
    values: dict = {}
    for i, term in enumerate(model.terms):
        if term.symbol in ("C0Y", "B0Z", "A0Z") or term.symbol[1] in "ABC":
            theta[i] = rng.normal() * 20e-6
        else:
            theta[i] = rng.normal() * 5e-3
        shape = 1.0
        if term.order:
            u = q[:, "XYZ".index(term.symbol[2])] / 300
            shape = np.polynomial.legendre.legval(u, np.eye(term.order + 1)[term.order])
        values[term.symbol] = values.get(term.symbol, 0.0) + theta[i] * shape
    difference = (model.matrix @ theta).reshape(-1, 3) - exact_error(simulated, q, values)
    assert np.sqrt((difference**2).mean()) < 50e-6  # 50 nm: angles add up to 100 urad here
    half = (model.matrix @ theta / 10).reshape(-1, 3)
    half = half - exact_error(simulated, q, {k: v / 10 for k, v in values.items()})
    assert np.abs(half).max() < np.abs(difference).max() / 60  # and it shrinks with the square


@pytest.mark.parametrize(
    ("code", "none", "one", "two", "three"),
    [("FXYZ", 39, 39, 45, 51), ("XYFZ", 40, 40, 46, 51), ("YFXZ", 39, 39, 45, 51)],
)
def test_one_tool_never_shows_all_errors_and_three_off_one_line_do(code, none, one, two, three):
    assert ranks(code, ONE_SHORT, (0, 0, 0)) == (51, none)
    assert ranks(code, ONE_SHORT) == (51, one)
    assert ranks(code, TWO) == (51, two)
    assert ranks(code, THREE) == (51, three)


def named(words) -> set[str]:
    return {m for w in words for m in re.findall(r"\b(?:E[XYZABC][XYZTW]|C0Y|B0Z|A0Z)\b", w)}


def test_a_tool_at_the_reference_points_hides_the_angles_of_the_last_axes():
    _, machine = both("FXYZ", (0, 0, 0))
    rows = readings_with(ONE_SHORT)
    words = [str(m) for m in null_space(fit(design(machine, rows), rows), rows)]
    assert len(words) == 12  # 51 - 39
    assert all("does not show" in w and "second tool" in w for w in words)
    assert named(words) == {"EAZ", "EBZ", "ECZ", "ECY"}


def test_a_tool_along_z_confuses_angles_of_z_with_straightness_and_squareness():
    _, machine = both("FXYZ")
    rows = readings_with(ONE_SHORT)
    words = [str(m) for m in null_space(fit(design(machine, rows), rows), rows)]
    assert sum("does not show" in w for w in words) == 6
    assert named(w for w in words if "does not show" in w) == {"ECY", "ECZ"}
    pairs = sorted(sorted(named([w])) for w in words if "cannot be told apart" in w)
    assert pairs == sorted([["A0Z", "EAZ"], ["B0Z", "EBZ"], *[["EAZ", "EYZ"]] * 2, *[["EBZ", "EXZ"]] * 2])


@pytest.mark.parametrize("code", ["FXYZ", "XYFZ", "YFXZ"])
def test_what_is_said_to_hide_indeed_shows_nowhere_and_gets_no_uncertainty(code):
    _, machine = both(code)
    rows = readings_with(TWO)
    found = fit(design(machine, rows), rows)
    size = np.linalg.norm(found.design.matrix, axis=0)
    shown = (found.design.matrix / np.where(size > 0, size, 1.0)) @ found.null_space  # columns of length 1
    assert np.linalg.norm(shown, axis=0) == pytest.approx(0, abs=1e-9)
    hidden = np.abs(found.null_space).max(axis=1) > 1e-6
    assert hidden.any() and not (hidden & found.determined).any()
    assert np.array_equal(~hidden, found.determined)
    assert not np.diag(found.covariance)[hidden].any()
    assert found.null_space.shape[1] == len(found.coefficients) - found.basis.rank


def test_with_three_tools_nothing_is_left_to_say():
    _, machine = both("XYFZ")
    rows = readings_with(THREE)
    found = fit(design(machine, rows), rows)
    assert null_space(found, rows) == []
    assert found.determined.all()


def test_the_condition_number_grows_as_tools_come_together():
    _, machine = both("FXYZ")
    condition = [
        fit(design(machine, rows), rows).basis.condition
        for rows in (readings_with(tuple((s * x, s * y, s * z) for x, y, z in THREE)) for s in (1.0, 0.1))
    ]
    assert condition[1] > 5 * condition[0]
