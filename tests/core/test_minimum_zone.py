# SPDX-License-Identifier: LGPL-2.1-or-later
"""Minimum zones against values worked by hand and against another linear-programming solver."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import optimize

from sensworkbench.core.minimum_zone import smallest_tube, smallest_zone


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
