# SPDX-License-Identifier: LGPL-2.1-or-later
"""Elements of a part from turned and shifted exact points; their maps against rigid motions of these points."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from sensworkbench.core import elements, features
from sensworkbench.core.elements import CIRCLE, CYLINDER, LINE, PLANE, POINT, Element
from sensworkbench.core.refusal import Refused

CENTRE = np.array([30.0, -20.0, 7.0])
TURNS = [Rotation.from_rotvec(v).as_matrix() for v in ((0, 0, 0), (0.3, -0.5, 0.2), (1.2, 0.4, -2.0))]


def shape(kind, turn):
    """(points, outward normals or None) of an element about CENTRE, whose axis is `turn` z."""
    around = np.linspace(0, 2 * np.pi, 12, endpoint=False)
    ring = np.stack([np.cos(around), np.sin(around), 0 * around], axis=1)
    if kind == POINT:
        local, normals = np.zeros((3, 3)), None
    elif kind == LINE:
        local, normals = np.array([[0, 0, h] for h in (-9.0, -2.0, 4.0, 7.0)]), None
    elif kind == CIRCLE:
        local, normals = 5 * ring, ring
    elif kind == PLANE:
        local = np.array([[x, y, 0] for x in (-8.0, 0.0, 3.0) for y in (-2.0, 1.0, 2.0)])
        normals = np.tile([0.0, 0.0, 1.0], (9, 1))
    else:
        local = np.concatenate([5 * ring + [0, 0, h] for h in (-6.0, 1.0, 6.0)])
        normals = np.tile(ring, (3, 1))
    return CENTRE + local @ turn.T, None if normals is None else normals @ turn.T


@pytest.mark.parametrize("turn", TURNS)
@pytest.mark.parametrize("kind", [POINT, LINE, CIRCLE, PLANE, CYLINDER])
def test_an_element_is_recognised_however_it_stands(kind, turn):
    points, normals = shape(kind, turn)
    found = elements.recognise(points, normals)
    assert found.kind == kind and found.off < 1e-9
    middle = CENTRE if kind in (POINT, CIRCLE, CYLINDER) else points.mean(axis=0)
    assert_allclose(found.centre, middle, atol=1e-9)
    assert found.radius == pytest.approx(5.0 if kind in (CIRCLE, CYLINDER) else 0.0, abs=1e-9)
    if kind == POINT:
        assert found.axis.tolist() == [0, 0, 0]
        return
    assert abs(found.axis @ turn[:, 2]) == pytest.approx(1.0, abs=1e-9)
    first, second = found.across()
    assert_allclose(np.cross(first, second), found.axis, atol=1e-12)
    assert_allclose([first @ first, second @ second, first @ second], [1, 1, 0], atol=1e-12)
    assert found.axis[np.argmax(np.abs(np.round(found.axis, 9)))] > 0 or kind == CYLINDER
    if kind in (CIRCLE, CYLINDER):
        assert_allclose(found.radial(points), normals, atol=1e-9)
    moved = points.copy()
    moved[-1] += 1.9e-3 * (normals[-1] if normals is not None else turn[:, 0])
    assert elements.recognise(moved, normals).kind == kind or kind == LINE
    moved[-1] += 0.2 * (normals[-1] if normals is not None else turn[:, 0])
    with_fault = {POINT: LINE, LINE: PLANE, CIRCLE: PLANE}.get(kind)
    if with_fault:
        assert elements.recognise(moved, normals).kind == with_fault
    else:
        with pytest.raises(Refused) as refused:
            elements.recognise(moved[:, [2, 0, 1]] if kind == CYLINDER else moved, normals)
        assert refused.value.fields["limit"] == pytest.approx(2.0) and refused.value.fields["off"] > 2.0


def test_four_points_of_a_square_are_a_plane_and_five_of_a_circle_a_circle():
    square = np.array([[1.0, 1, 0], [1, -1, 0], [-1, -1, 0], [-1, 1, 0]])
    assert elements.recognise(square).kind == PLANE
    five = np.array([[np.cos(a), np.sin(a), 0] for a in range(5)])
    assert elements.recognise(five).kind == CIRCLE
    assert elements.recognise(five, np.tile([0, 0, 1.0], (5, 1))).kind == PLANE  # a face of five points on a circle


def test_an_element_that_is_asked_for_has_enough_points_on_it():
    points, normals = shape(CYLINDER, TURNS[1])
    assert elements.made(CYLINDER, points, normals, "f", "k").radius == pytest.approx(5.0)
    for kind, fewest in ((POINT, 1), (LINE, 2), (CIRCLE, 3), (PLANE, 3), (CYLINDER, 6)):
        points, normals = shape(kind, TURNS[1])
        few = np.repeat(points[: fewest - 1], 9, axis=0) if fewest > 1 else points[:0]
        if fewest > 1:
            with pytest.raises(Refused) as refused:
                elements.made(kind, few, None, "f", "k")
            assert refused.value.fields["fewest"] == fewest and refused.value.fields["count"] == fewest - 1
        assert elements.made(kind, points, normals, "f", "k").kind == kind
    with pytest.raises(Refused) as refused:
        elements.made(LINE, np.array([[0, 0, 0], [1, 0, 0], [2, 0.1, 0.0]]), None, "f", "k")
    assert refused.value.code == "feature-not-on-element"


CASES = [POINT, LINE, "line on a face", CIRCLE, "bore", PLANE, "underside", CYLINDER]


def surface(case, turn):
    """(surface, determined directions of its place, of its rotation or None)."""
    kind = {"line on a face": LINE, "bore": CIRCLE, "underside": PLANE}.get(case, case)
    points, normals = shape(kind, turn)
    if case == "line on a face":
        normals = np.tile(turn[:, 0], (len(points), 1))
    if case in ("bore", "underside"):
        normals = -normals
    made = features.surface("f", points, normals)
    x, y, z = turn.T
    across = np.outer(x, x) + np.outer(y, y)
    place = {POINT: np.eye(3), "line on a face": np.outer(x, x), PLANE: np.outer(z, z), "underside": np.outer(z, z)}
    turned = {LINE: across, "line on a face": np.outer(y, y), PLANE: across, "underside": across, CYLINDER: across}
    return made, place.get(case, across), turned.get(case)


@pytest.mark.parametrize("turn", TURNS)
@pytest.mark.parametrize("case", CASES)
def test_place_and_rotation_of_a_rigid_motion_are_found_in_its_departures(case, turn):
    made, place, turned = surface(case, turn)
    rng = np.random.default_rng(1)
    for _ in range(3):
        shift, about = rng.normal(size=(2, 3)) * 1e-3
        error = shift + np.cross(about, made.points - made.element.centre)
        if case == POINT:
            error = np.tile(shift, (len(made.points), 1))
        d = made.departures(error)
        assert len(d) == made.width * len(made.points) == made.columns.shape[0]
        c = features.coefficients(made, d)
        assert_allclose(made.columns @ c, d, atol=1e-15)  # nothing of a rigid motion is form
        assert_allclose(made.place @ c, place @ shift, atol=1e-13)
        if turned is None:
            with pytest.raises(Refused):
                _ = made.tilt
        else:
            turn_of, free = made.tilt
            assert_allclose(turn_of @ c, turned @ about, atol=1e-13)
            assert_allclose(turned @ free, 0, atol=1e-12)
            assert np.linalg.matrix_rank(np.hstack([turned, free])) == 3
    some = made.departures(error[1:3], slice(1, 3))
    assert_allclose(some, d[made.width : 3 * made.width], atol=1e-18)


def test_departures_are_outwards():
    for case, sense in ((CIRCLE, 1), ("bore", -1), (CYLINDER, 1)):
        made, _, _ = surface(case, TURNS[1])
        grown = made.element.radial(made.points) * 1e-3
        assert_allclose(made.departures(grown), sense * 1e-3, atol=1e-12)
    for case, sense in ((PLANE, 1), ("underside", -1)):
        made, _, _ = surface(case, TURNS[2])
        lifted = np.tile(TURNS[2][:, 2], (9, 1))
        assert_allclose(made.departures(lifted), sense, atol=1e-12)


def judged(kind, made, error, datum=None, turn=None, place=None):
    found = features.feature("f", kind, made, datum)
    return features.judge(found, made.departures(error), turn, place)


@pytest.mark.parametrize(
    ("kind", "case"),
    [("straightness", "line on a face"), ("flatness", PLANE), ("roundness", CIRCLE), ("cylindricity", CYLINDER)],
)
def test_form_is_the_spread_that_is_left_by_every_rigid_motion_and_size(kind, case):
    """One point out by h: the zone cannot be wider than h and the least-squares remainder follows from its own hat."""
    made, _, _ = surface(case, TURNS[1])
    n = len(made.points)
    h = 4e-3 * (np.arange(n) == 1)
    d = made.columns @ np.linspace(1, 2, made.columns.shape[1]) * 1e-3 + h
    found = features.judge(features.feature("f", kind, made), d)
    left = h - made.columns @ np.linalg.pinv(made.columns) @ h
    assert found.least_squares == pytest.approx(np.ptp(left), rel=1e-9)
    assert 0.3 * np.ptp(left) < found.value <= np.ptp(left) * (1 + 1e-9) and found.worst == np.argmax(np.abs(left))
    assert found.weights @ d[found.points] == pytest.approx(found.value, rel=1e-9)


def test_straightness_of_an_axis_is_a_tube():
    made, _, _ = surface(LINE, TURNS[1])
    d = np.zeros((4, 2))
    d[1] = 3e-3, 4e-3
    found = features.judge(features.feature("f", "straightness", made), d.ravel())
    basis = np.stack([np.ones(4), (made.points - made.element.centre) @ made.element.axis], axis=1)
    left = d - basis @ np.linalg.pinv(basis) @ d
    assert found.least_squares == pytest.approx(2 * np.hypot(*left.T).max(), rel=1e-9)
    assert 0.5 * found.least_squares < found.value <= found.least_squares * (1 + 1e-9)


def test_position_is_twice_the_way_and_distance_is_signed_along_the_line_between():
    hole, _, _ = surface(CIRCLE, TURNS[0])
    found = judged("position", hole, np.zeros((12, 3)), place=np.array([3e-3, 4e-3, 9.0]))
    assert found.value == pytest.approx(10e-3) and found.direction == pytest.approx([1.2, 1.6, 0])
    still = judged("position", hole, np.zeros((12, 3)), place=np.zeros(3))
    assert still.value == 0.0 and np.linalg.norm(still.direction) == pytest.approx(2.0)
    points, normals = shape(CIRCLE, TURNS[0])
    other = features.surface("d", points + [30.0, 40.0, 0], normals)
    for made, datum, sense in ((other, hole, 1), (hole, other, -1)):
        apart = judged("distance", made, np.zeros((12, 3)), datum, place=np.array([6e-3, 0, 0]))
        assert apart.value == apart.least_squares == pytest.approx(sense * 3.6e-3)
        assert apart.direction == pytest.approx(sense * np.array([0.6, 0.8, 0]))
    with pytest.raises(Refused):
        features.feature("f", "distance", hole, hole)
    face, _, _ = surface(PLANE, TURNS[0])
    upper = features.surface("u", face.points + [1.0, 1.0, 50.0], face.normals)
    for made, datum, sense in ((upper, face, 1), (face, upper, -1)):
        found = judged("distance", made, np.zeros((9, 3)), datum, place=np.array([5.0, 5.0, 2e-3]))
        assert found.value == pytest.approx(sense * 2e-3)


def test_orientation_takes_the_rotation_of_its_datum_away_and_leaves_its_own_place():
    for kind, made, datum in (
        ("parallelism", surface(PLANE, TURNS[1])[0], surface(PLANE, TURNS[1])[0]),
        ("parallelism", surface(CYLINDER, TURNS[1])[0], surface(LINE, TURNS[1])[0]),
        ("perpendicularity", surface(CYLINDER, TURNS[1])[0], surface(PLANE, TURNS[1])[0]),
        ("perpendicularity", surface(LINE, TURNS[1])[0], surface(PLANE, TURNS[1])[0]),
        ("parallelism", surface("line on a face", TURNS[1])[0], surface(LINE, TURNS[1])[0]),
    ):
        about = np.array([2e-4, -1e-4, 3e-4])
        error = np.array([1e-3, 2e-3, -1e-3]) + np.cross(about, made.points - made.element.centre)
        together = judged(kind, made, error, datum, turn=about)
        assert together.value == pytest.approx(0.0, abs=1e-12) and together.least_squares < 1e-12
        alone = judged(kind, made, error, datum, turn=np.zeros(3))
        assert alone.value > 1e-4
    with pytest.raises(Refused) as refused:
        features.feature("f", "perpendicularity", surface(PLANE, TURNS[1])[0], surface(PLANE, TURNS[1])[0])
    assert refused.value.code == "feature-not-so" and refused.value.fields["angle"] == pytest.approx(90.0)
    slightly = Rotation.from_rotvec([0.049, 0, 0]).as_matrix()
    features.feature("f", "parallelism", surface(PLANE, slightly)[0], surface(PLANE, TURNS[0])[0])
    more = Rotation.from_rotvec([0.051, 0, 0]).as_matrix()
    with pytest.raises(Refused):
        features.feature("f", "parallelism", surface(PLANE, more)[0], surface(PLANE, TURNS[0])[0])


def test_every_kind_of_tolerance_has_its_elements_fewest_points_and_datum():
    axis = {LINE: 2, PLANE: 3, CYLINDER: 6}
    places = {POINT: 1, LINE: 2, CIRCLE: 3, PLANE: 3, CYLINDER: 6}
    want = {
        "straightness": ("form", {LINE: 3}, ""), "flatness": ("form", {PLANE: 4}, ""),
        "roundness": ("form", {CIRCLE: 4}, ""), "cylindricity": ("form", {CYLINDER: 6}, ""),
        "parallelism": ("orientation", axis, "needed"), "perpendicularity": ("orientation", axis, "needed"),
        "position": ("place", places, "may"), "distance": ("place", places, "needed"),
    }  # fmt: skip
    assert {k: (v.group, dict(v.elements), v.datum) for k, v in features.KINDS.items()} == want
    few = features.surface("f", np.eye(3) * 5, element=Element(PLANE, np.full(3, 5 / 3), np.ones(3) / np.sqrt(3)))
    with pytest.raises(Refused) as refused:
        features.feature("f", "flatness", few)
    assert refused.value.fields["count"] == 3 and refused.value.fields["fewest"] == 4
    for kind, made in (("parallelism", surface(PLANE, TURNS[0])[0]), ("distance", surface(POINT, TURNS[0])[0])):
        with pytest.raises(Refused) as refused:
            features.feature("f", kind, made)
        assert refused.value.code == "feature-without-datum"
    with pytest.raises(Refused) as refused:
        features.feature("f", "flatness", surface(CIRCLE, TURNS[0])[0])
    assert refused.value.code == "feature-element"
