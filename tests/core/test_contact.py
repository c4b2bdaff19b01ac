# SPDX-License-Identifier: LGPL-2.1-or-later
"""The point that cuts: where flat, ball and toroidal cutters touch planes and cylinders, against closed forms."""

from __future__ import annotations

import numpy as np
import pytest

from sensworkbench.core.contact import Cutter, Face, contact
from sensworkbench.core.elements import CYLINDER, PLANE

UP = np.array([0.0, 0.0, 1.0])
R = 6.0


def plane(normal, point=(0, 0, 0), **more):
    n = np.asarray(normal, dtype=float)
    return Face("f", PLANE, np.asarray(point, dtype=float), n / np.linalg.norm(n), **more)


@pytest.mark.parametrize("angle", [5, 30, 60, 85])
@pytest.mark.parametrize("corner", [0.0, 1.5, R])
def test_a_slope_is_cut_where_the_cutter_is_tangent_to_it(angle, corner):
    """The tip stands over the contact by r(1 - cos) and beside it by (R - r) + r sin: the torus in its own plane."""
    a = np.radians(angle)
    face = plane((np.sin(a), 0, np.cos(a)))
    cut = 3.0 * np.array([np.cos(a), 0, -np.sin(a)]) + (0, 7, 0)  # a point of the slope
    tip = cut + np.array([(R - corner) + corner * np.sin(a), 0, -corner * (1 - np.cos(a))])
    found = contact(face, tip[None] + [[0, 0, 0], [0, 0, 1.0]], Cutter(R, corner), UP)
    assert found.rows.tolist() == [0]  # a millimetre higher it cuts nothing
    assert found.points[0] == pytest.approx(cut, abs=1e-12)
    assert found.normals[0] == pytest.approx(face.axis, abs=1e-12)


def test_a_ball_on_a_flat_cuts_with_its_tip_and_on_a_wall_with_its_equator():
    tips = np.array([[10.0, 5, 0], [0, 0, 0]])
    assert contact(plane(UP), tips, Cutter(R, R), UP).points == pytest.approx(tips)
    found = contact(plane((-1, 0, 0), (R, 0, 0)), tips, Cutter(R, R), UP)
    assert found.rows.tolist() == [1] and found.points[0] == pytest.approx([R, 0, R])


@pytest.mark.parametrize("sense", [1, -1])
def test_the_wall_of_a_boss_or_bore_is_cut_one_radius_from_the_tip(sense):
    turn = np.linspace(0, 2 * np.pi, 37)
    away = np.stack([np.cos(turn), np.sin(turn), 0 * turn], axis=1)
    face = Face(
        "f", CYLINDER, np.array([40.0, 30, 0]), UP, 20.0, sense, corners=np.array([[20, 10, -5], [60, 50, 5.0]])
    )
    tips = np.array([40.0, 30, -2]) + (20 + sense * R) * away
    found = contact(face, tips, Cutter(R), UP)
    assert len(found.rows) == 37 and found.normals == pytest.approx(sense * away)
    assert found.points == pytest.approx(np.array([40.0, 30, -2]) + 20 * away)
    assert len(contact(face, tips, Cutter(R - 0.1), UP).rows) == 0  # another cutter leaves a tenth


def test_a_wall_that_ends_above_the_tip_is_cut_by_the_side_at_its_lower_edge():
    face = plane((0, 1, 0), corners=np.array([[-9.0, 0, -10], [9, 0, 0]]))
    found = contact(face, [[0, R, -11.0], [0, R, -4], [0, R, -10 - 3 * R]], Cutter(R), UP)
    assert found.points[:2] == pytest.approx(np.array([[0, 0, -10.0], [0, 0, -4]]))
    assert 2 not in found.rows or found.points[2, 2] < -10  # too far below: not on the face


def test_a_ball_over_a_lying_cylinder_cuts_along_its_radius():
    rho, a = 15.0, np.radians(np.linspace(-80, 80, 17))
    out = np.stack([0 * a, np.sin(a), np.cos(a)], axis=1)
    face = Face("f", CYLINDER, np.zeros(3), np.array([1.0, 0, 0]), rho)
    found = contact(face, (rho + R) * out - R * UP, Cutter(R, R), UP)
    assert found.points == pytest.approx(rho * out, abs=1e-12) and found.normals == pytest.approx(out, abs=1e-12)
    groove = Face("f", CYLINDER, np.zeros(3), np.array([1.0, 0, 0]), rho, -1)
    found = contact(groove, -(rho - R) * out - R * UP, Cutter(R, R), UP)
    assert found.points == pytest.approx(-rho * out, abs=1e-12) and found.normals == pytest.approx(out, abs=1e-12)


def test_a_flat_end_on_a_lying_cylinder_cuts_with_its_edge():
    rho, a = 15.0, np.radians(np.array([20.0, 45, 70]))
    cut = rho * np.stack([0 * a, np.sin(a), np.cos(a)], axis=1)
    face = Face("f", CYLINDER, np.zeros(3), np.array([1.0, 0, 0]), rho)
    found = contact(face, cut + [0, R, 0], Cutter(R), UP)
    assert found.points == pytest.approx(cut, abs=1e-6)


def test_a_hole_is_made_along_its_axis_by_the_tool_of_its_radius_only():
    face = Face("f", CYLINDER, np.zeros(3), UP, 4.0, -1, corners=np.array([[-4, -4, -20], [4, 4, 0.0]]))
    tips = np.array([[0, 0, 5.0], [0, 0, -3], [0, 0, -20], [0, 0, -25]])
    found = contact(face, tips, Cutter(4.0, drill=True), UP)
    assert found.axial and found.rows.tolist() == [1, 2] and np.isnan(found.normals).all()
    assert len(contact(face, tips, Cutter(3.0, drill=True), UP).rows) == 0


def test_the_end_of_a_cutter_reaches_a_ledge_beside_its_middle():
    face = plane(UP, inside=lambda p: np.abs(p[:, 0]) <= 1.0, corners=np.array([[-1.0, -50, 0], [1, 50, 0]]))
    found = contact(face, [[4.0, 0, 0], [9.0, 0, 0], [0.5, 0, 0]], Cutter(R), UP)
    assert found.rows.tolist() == [0, 2] and np.abs(found.points[:, 0]).max() <= 1.0


def test_faces_that_look_down_are_cut_by_nothing_from_above():
    assert len(contact(plane((0, 0.1, -1)), [[0, 0, 0.0]], Cutter(R, R), UP).rows) == 0
