# SPDX-License-Identifier: LGPL-2.1-or-later
"""Minimum zones against values worked by hand and against another linear-programming solver."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import optimize

from sensworkbench.core import minimum_zone
from sensworkbench.core.minimum_zone import independent, smallest_tube, smallest_zone


def zone_by_program(columns, d) -> float:
    n, p = columns.shape
    rows = np.block([[-columns, -np.ones((n, 1))], [columns, -np.ones((n, 1))]])
    cost, bounds = np.append(np.zeros(p), 1.0), [(None, None)] * p + [(0, None)]
    return 2 * optimize.linprog(cost, A_ub=rows, b_ub=np.concatenate([-d, d]), bounds=bounds, method="highs").fun


def test_three_points_of_a_line_by_hand():
    columns = np.array([[1.0, 0.0], [1.0, 1.0], [1.0, 2.0]])
    zone = smallest_zone(columns, np.array([0.0, 1.0, 0.0]))
    assert zone.width == pytest.approx(1.0, rel=1e-12)  # parallel to the two ends, the third touches
    assert zone.fit == pytest.approx([0.5, 0.0], abs=1e-12)


def test_four_corners_of_a_twisted_plane_by_hand():
    columns = np.array([[1.0, x, y] for x in (-1, 1) for y in (-1, 1)])
    assert smallest_zone(columns, columns[:, 1] * columns[:, 2]).width == pytest.approx(2.0, rel=1e-12)


@pytest.mark.parametrize("points, free", [(5, 2), (60, 3), (300, 5), (2000, 3)])
def test_zones_are_those_of_another_solver(points, free):
    rng = np.random.default_rng(points)
    columns = np.concatenate([np.ones((points, 1)), 100 * rng.normal(size=(points, free - 1))], axis=1)
    d = 1e-3 * rng.normal(size=points)
    zone = smallest_zone(columns, d)
    assert zone.width == pytest.approx(zone_by_program(columns, d), rel=1e-9)
    assert np.ptp(d - columns @ zone.fit) == pytest.approx(zone.width, rel=1e-9)


def test_zones_of_grids_with_many_ties_are_those_of_another_solver():
    x, y = (g.ravel().astype(float) for g in np.meshgrid(np.arange(30), np.arange(7)))
    columns = np.stack([np.ones_like(x), x, y], axis=1)
    for d in (np.sign(x - 12.5), x * y, (x % 2) - (y % 3), np.zeros_like(x)):
        assert smallest_zone(columns, d).width == pytest.approx(zone_by_program(columns, d), rel=1e-9, abs=1e-15)


def test_the_weights_are_the_derivative_of_the_width():
    rng = np.random.default_rng(4)
    t = np.linspace(0, 6, 80)
    columns, d = np.stack([np.ones_like(t), np.cos(t), np.sin(t)], axis=1), rng.normal(size=80)
    zone, change = smallest_zone(columns, d), 1e-7 * rng.normal(size=80)
    moved = smallest_zone(columns, d + change).width - zone.width
    assert moved == pytest.approx(float(zone.weights @ change[zone.points]), rel=1e-5)
    assert zone.width == pytest.approx(float(zone.weights @ d[zone.points]), rel=1e-12)


def test_a_tube_about_a_helix_has_its_diameter_and_holds_every_point():
    t = np.linspace(0, 8 * np.pi, 4 * 36 + 1)
    columns = np.stack([np.ones_like(t), t - t.mean()], axis=1)
    slope, offset = np.array([2e-4, -1e-4]), np.array([0.02, 0.01])
    d = 0.005 * np.stack([np.cos(t), np.sin(t)], axis=1) + np.outer(t, slope) + offset
    zone = smallest_tube(columns, d)
    rest = np.hypot(*(d - columns @ zone.fit).T)
    assert 2 * rest.max() == pytest.approx(zone.width, rel=1e-9)
    assert zone.width <= 0.01 * (1 + 1e-9) and zone.width > 0.0099


# -- the program itself ------------------------------------------------------------------------------------------------
def programs(count=40):
    for seed in range(count):
        rng = np.random.default_rng(seed)
        k, p = int(rng.integers(8, 400)), int(rng.integers(1, 5))
        rows = rng.normal(size=(k, p))
        if seed % 3 == 0:
            rows[:, 0] = 1.0 * (rng.random(k) < 0.5) - 0.5
        heights = rng.normal(size=k) if seed % 4 else np.round(2 * rng.normal(size=k)) / 2
        yield np.concatenate([rows, -rows]), np.concatenate([heights, -heights])


def certified(rows, heights, found):
    """The bound holds for all rows, and weights >= 0 with sum 1 and none along the columns prove that none is lower."""
    bound, c, used, weights = found
    size = np.abs(heights).max()
    assert (heights - rows @ c).max() <= bound + 1e-12 * size
    assert (weights > 0).all() and len(set(used)) == len(used)
    assert weights.sum() == pytest.approx(1.0, abs=1e-11)
    assert weights @ rows[used] == pytest.approx(np.zeros(rows.shape[1]), abs=1e-10)
    assert weights @ heights[used] == pytest.approx(bound, abs=1e-12 * size)


@pytest.mark.parametrize("patience", [60, -1], ids=["usual", "the rule that cannot cycle"])
def test_bound_and_weights_prove_each_other(monkeypatch, patience):
    monkeypatch.setattr(minimum_zone, "_PATIENCE", patience)
    for rows, heights in programs():
        certified(rows, heights, minimum_zone._least_bound(rows, heights))


def test_a_smooth_curve_sampled_finely_is_solved_to_the_last_digits():
    """The best cubic of degree 2 on 40,001 points leaves T3 / 4: width 1/2."""
    x = np.linspace(-1, 1, 40_001)
    columns = np.stack([np.ones_like(x), x, x**2], axis=1)
    zone = smallest_zone(columns, x**3)
    assert zone.width == pytest.approx(0.5, rel=1e-12) and zone.fit == pytest.approx([0, 0.75, 0], abs=1e-12)
    certified_zone(columns, x**3 + 0.3 * np.sin(5 * x))
    certified_zone(columns * [1e3, 1e-4, 1.0], 1e-6 * np.exp(x))


def certified_zone(columns, d):
    zone = smallest_zone(columns, d)
    assert np.ptp(d - columns @ zone.fit) == pytest.approx(zone.width, rel=1e-10)
    assert float(zone.weights @ d[zone.points]) == pytest.approx(zone.width, rel=1e-11)
    assert np.abs(zone.weights).sum() == pytest.approx(2.0, rel=1e-11)


def test_nothing_free_and_nothing_to_fit():
    free = np.zeros((3, 0))
    zone = smallest_zone(free, np.array([1.0, -3.0, 2.0]))
    assert zone.width == 6.0 and zone.points.tolist() == [1] and zone.weights.tolist() == [-2.0] and len(zone.fit) == 0
    zone = smallest_zone(np.ones((3, 1)), np.zeros(3))
    assert zone.width == 0.0 and zone.fit.tolist() == [0.0] and zone.weights.tolist() == [2.0]
    bound, c, used, weights = minimum_zone._least_bound(np.zeros((3, 0)), np.array([1.0, 3.0, 2.0]))
    assert (bound, used.tolist(), weights.tolist(), c.shape) == (3.0, [1], [1.0], (0,))


def test_a_small_number_of_steps_ends_with_a_bound_of_the_points_so_far(monkeypatch):
    monkeypatch.setattr(minimum_zone, "_MOST", 3)
    rng = np.random.default_rng(2)
    columns, d = rng.normal(size=(500, 4)), rng.normal(size=500)
    assert smallest_zone(columns, d).width <= zone_by_program(columns, d) * (1 + 1e-12)


def test_columns_that_depend_on_others_are_left_out():
    x = np.linspace(0, 1, 9)
    for small, rank in ((1e-7, 3), (1e-13, 2)):
        columns = np.stack([1e3 * np.ones(9), x, x + 1 + small * x**2, 0 * x], axis=1)
        basis, back = independent(columns)
        assert basis.shape == (9, rank) and back.shape == (4, rank)
        assert basis == pytest.approx(columns @ back, abs=1e-6)
        assert basis.T @ basis / 9 == pytest.approx(np.eye(rank), abs=1e-5)
    basis, _ = independent(np.stack([2.0 * np.ones(4), np.array([1.0, -1, 1, -1])], axis=1))
    assert np.abs(basis) == pytest.approx(np.ones((4, 2)))


# -- tubes -------------------------------------------------------------------------------------------------------------
def tube_by_directions(columns, d, count=1440) -> tuple[float, float]:
    """(at least, at most) the diameter: a linear program in which each point keeps below `count` tangents."""
    n, p = columns.shape
    angle = 2 * np.pi * np.arange(count) / count
    rows, heights = [], []
    for a in angle:
        u = np.cos(a), np.sin(a)
        rows.append(np.hstack([-u[0] * columns, -u[1] * columns, -np.ones((n, 1))]))
        heights.append(-(d @ u))
    bounds = [(None, None)] * (2 * p) + [(0, None)]
    least = 2 * optimize.linprog(
        np.append(np.zeros(2 * p), 1.0), A_ub=np.vstack(rows), b_ub=np.concatenate(heights), bounds=bounds,
        method="highs",
    ).fun  # fmt: skip
    return least, least / np.cos(np.pi / count)


@pytest.mark.parametrize("n", [3, 20, 150])
@pytest.mark.parametrize("seed", range(3))
def test_tubes_are_those_of_another_solver_and_their_weights_prove_them(n, seed):
    rng = np.random.default_rng(seed)
    t = np.sort(rng.uniform(-5, 5, n))
    columns = np.stack([np.ones(n), t], axis=1)
    d = rng.normal(size=(n, 2)) * [1.0, 0.4] + np.outer(t, [0.3, -0.2]) + 7.0
    zone = smallest_tube(columns, d)
    least, most = tube_by_directions(columns, d, 240 if n > 20 else 720)
    assert least * (1 - 1e-9) <= zone.width <= most * (1 + 1e-9)
    size = np.hypot(*(d - columns @ zone.fit).T)
    assert 2 * size.max() == pytest.approx(zone.width, rel=1e-9)
    assert (zone.weights * d[zone.points]).sum() == pytest.approx(zone.width, rel=1e-9)
    assert zone.weights.T @ columns[zone.points] == pytest.approx(np.zeros((2, 2)), abs=1e-8)
    assert size[zone.points] == pytest.approx(np.full(len(zone.points), zone.width / 2), rel=1e-6)
    change = 1e-6 * rng.normal(size=(n, 2))
    moved = smallest_tube(columns, d + change).width - zone.width
    assert moved == pytest.approx((zone.weights * change[zone.points]).sum(), rel=1e-3, abs=1e-10)


def test_tubes_by_hand():
    ones = np.ones((4, 1))
    square = np.array([[3.0, 1.0], [5.0, 1.0], [3.0, 3.0], [5.0, 3.0]])
    zone = smallest_tube(ones, square)
    assert zone.width == pytest.approx(2 * np.sqrt(2), rel=1e-12) and zone.fit[0] == pytest.approx([4.0, 2.0])
    two = smallest_tube(np.ones((3, 1)), np.array([[0.0, 0.0], [6.0, 8.0], [3.0, 4.5]]))
    assert two.width == pytest.approx(10.0, rel=1e-12) and set(two.points) == {0, 1}
    assert two.fit[0] == pytest.approx([3.0, 4.0], abs=1e-5)  # the width grows with the square of its departure
    line = np.stack([np.ones(5), np.arange(5.0)], axis=1)
    straight = smallest_tube(line, line @ np.array([[1.0, 2.0], [0.5, -0.25]]))
    assert straight.width == pytest.approx(0.0, abs=1e-12)
    assert straight.fit == pytest.approx(np.array([[1.0, 2.0], [0.5, -0.25]]), abs=1e-12)


def test_a_tube_of_many_points_on_a_circle_ends(monkeypatch):
    """Every point of the circle touches; with few directions allowed the answer is a little too small at most."""
    angle = np.linspace(0, 2 * np.pi, 500, endpoint=False)
    d = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    assert smallest_tube(np.ones((500, 1)), d).width == pytest.approx(2.0, rel=1e-9)
    monkeypatch.setattr(minimum_zone, "_MOST_DIRECTIONS", 2)
    rough = smallest_tube(np.stack([np.ones(500), angle], axis=1), d * [1.0, 0.5]).width
    monkeypatch.undo()
    fine = smallest_tube(np.stack([np.ones(500), angle], axis=1), d * [1.0, 0.5]).width
    assert 0.5 * fine < rough <= fine * (1 + 1e-9)
