# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points of a tool path against a loop over its moves written from their meaning, move by move with complex numbers."""

from __future__ import annotations

import cmath
import math

import numpy as np
import pytest
from numpy.testing import assert_allclose

from sensworkbench.core import toolpath
from sensworkbench.core.toolpath import ARC, LINE, RAPID, Moves, ToolPath, counts, directions_of, sample

PLANES = {0: (1, 2), 1: (2, 0), 2: (0, 1)}  # square to X: Y to Z; square to Y: Z to X; square to Z: X to Y


def path(rows, joints=3, xyz=(0, 1, 2)) -> Moves:
    """Moves from dictionaries; what is not said is a line at feed 600 on the contour."""
    usual = {
        "kind": LINE, "begin": (0.0,) * joints, "end": (0.0,) * joints, "known": True, "centre": (0.0,) * 3, "plane": 2,
        "sweep": 0.0, "feed": 600.0, "dwell": 0.0, "spindle": 0.0, "block": 1, "shift": (0.0,) * joints, "length": 0.0,
        "side": 0, "radius": 0.0, "surface": True,
    }  # fmt: skip
    return Moves(**{k: np.array([r.get(k, v) for r in rows]) for k, v in usual.items()}, xyz=xyz)


def arc(plane, centre, start, end_radius, sweep, rise, **more):
    """An arc that begins at `start` (in its plane, beside the centre) and ends after `sweep` at `end_radius`."""
    a, b = PLANES[plane]
    z0 = complex(*start)
    z1 = end_radius * cmath.exp(1j * (cmath.phase(z0) + sweep))
    begin, end = np.array(centre, dtype=float), np.array(centre, dtype=float)
    begin[a] += z0.real
    begin[b] += z0.imag
    end[a] += z1.real
    end[b] += z1.imag
    end[plane] += rise
    return {"kind": ARC, "begin": begin, "end": end, "centre": centre, "plane": plane, "sweep": sweep} | more


def one_point(m: Moves, k: int, f: float):
    """(contour along X, Y, Z, direction of motion of unit length or zeros) of move k at the fraction f, all known."""
    begin, end = m.begin[k].copy(), m.end[k]
    if m.kind[k] != ARC:
        place, along = begin + f * (end - begin), end - begin
    else:
        a, b = PLANES[int(m.plane[k])]
        centre = complex(m.centre[k, a], m.centre[k, b])
        z0, z1 = complex(begin[a], begin[b]) - centre, complex(end[a], end[b]) - centre
        radius = (1 - f) * abs(z0) + f * abs(z1)
        z = radius * cmath.exp(1j * (cmath.phase(z0) + f * m.sweep[k]))
        place, along = begin + f * (end - begin), end - begin
        place[a], place[b] = (z + centre).real, (z + centre).imag
        turning = 1j * z / abs(z) * math.copysign(1, m.sweep[k])
        along[a], along[b] = turning.real, turning.imag
    size = np.linalg.norm(along)
    return place, along / size if size else along


MIXED = [
    {"kind": RAPID, "end": (10, 0, 5), "feed": math.nan, "known": False},
    {"begin": (10, 0, 5), "end": (10, 0, 0), "feed": 100.0, "dwell": 1.5},
    {"begin": (10, 0, 0), "end": (10, 30, 0), "side": 1, "radius": 4.0},
    arc(2, (0, 30, 0), (10, 0), 10.0, math.pi / 2, 0.0, side=1, radius=4.0),
    arc(2, (0, 30, 0), (0, 10), 12.0, -2.0, 3.0, side=-1, radius=2.5, surface=False, dwell=0.25),
    arc(0, (3, 2, 1), (0, -5), 5.0, 4.0, -2.0, side=-1, radius=1.0),
    arc(1, (3, 2, 1), (4, 3), 5.0, -1.0, 0.0, side=1, radius=1.0, feed=50.0),
    {"kind": RAPID, "begin": (0, 0, 0), "end": (0, 0, 50), "feed": math.nan, "dwell": 2.0},
    {"begin": (0, 0, 50), "end": (0, 0, 50), "side": 1, "radius": 3.0},
    {"begin": (0, 0, 50), "end": (6, 8, 50), "plane": 0, "side": -1, "radius": 3.0},
    {"begin": (6, 8, 50), "end": (6, 8, 20), "plane": 1, "side": -1, "radius": 3.0},
]  # fmt: skip


def lengths(m: Moves) -> list[float]:
    """Lengths of 20,000 chords of each move whose beginning is known."""
    out = []
    for k in range(len(m)):
        points = [one_point(m, k, f)[0] for f in np.linspace(0, 1, 20_001 if m.kind[k] == ARC else 2)]
        out.append(float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum()) if m.known[k] else 0.0)
    return out


def test_lengths_are_those_of_the_curves():
    rows = [r for r in MIXED if not (r.get("kind") == ARC and r.get("sweep") == -2.0)]  # that one is a spiral
    m = path(rows)
    assert_allclose(m.lengths(), lengths(m), rtol=1e-8)


def test_the_length_of_a_spiral_is_counted_at_its_first_radius():
    m = path([arc(2, (0, 30, 0), (0, 10), 12.0, -2.0, 3.0)])
    assert m.lengths()[0] == pytest.approx(math.hypot(20.0, 3.0), rel=1e-14)


def test_a_turn_of_a_rotary_joint_alone_has_its_angle_as_length():
    m = path([{"end": (0, 0, 0, 2.0, 1.5)}, {"end": (3, 4, 0, 2.0, 1.5)}], 5)
    assert m.lengths().tolist() == [2.5, 5.0]


def test_points_are_those_of_a_loop_over_the_moves():
    m = path(MIXED)
    number = np.array([1, 3, 6, 5, 7, 8, 4, 1, 1, 2, 3])
    found = sample(m, number, 3000.0, fresh=(5,))
    own = {1, 2, 4, 5, 6, 8, 9}  # cutting begins, the cutter changes side, or it is asked for (5)
    row, clock, speed = 0, 0.0, {RAPID: 3000.0}
    sizes = lengths(m)
    sizes[4] = m.lengths()[4]
    for k in range(len(m)):
        lasts = 60 * sizes[k] / speed.get(int(m.kind[k]), m.feed[k])
        fractions = [i / number[k] for i in range(0 if k in own else 1, number[k] + 1)]
        for f in fractions:
            place, along = one_point(m, k, f if m.known[k] else 1.0)
            assert found.move[row] == k and found.fraction[row] == pytest.approx(f, abs=1e-15)
            assert_allclose(found.contour[row], place, atol=1e-12)
            tip, normal = place.copy(), np.full(3, math.nan)
            if m.side[k]:
                a, b = PLANES[int(m.plane[k])]
                left = np.zeros(3)
                left[a], left[b] = -along[b], along[a]
                if left.any():
                    left *= m.side[k] / np.linalg.norm(left)
                    tip = place + m.radius[k] * left
                    normal = left if m.surface[k] else normal
            assert_allclose(found.q[row], tip, atol=1e-12)
            assert_allclose(found.normal[row], normal, atol=1e-12)
            assert found.t[row] == pytest.approx(clock + f * lasts, rel=1e-8, abs=1e-12)
            row += 1
        clock += lasts + m.dwell[k]
    assert row == len(found.move)


def test_the_last_point_of_a_move_is_its_end_to_the_last_bit():
    end = (0.1 + 0.2, 7.3, -1.0)
    rows = [
        {"begin": (1.1, 2.2, 3.3), "end": end},
        {"kind": ARC, "begin": (1.0, 0.0, 0.0), "end": (-1e-4, 1.0001, 0.3), "centre": (0, 0, 0), "sweep": math.pi / 2},
    ]
    m = path(rows)
    found = sample(m, np.array([3, 3]), 1.0)
    assert found.contour[3].tolist() == list(end) and found.contour[-1].tolist() == [-1e-4, 1.0001, 0.3]
    assert found.fraction.tolist() == [0, 1 / 3, 2 / 3, 1, 1 / 3, 2 / 3, 1]


def test_an_unknown_beginning_gives_the_end_alone_and_takes_no_time():
    m = path(
        [{"known": False, "end": (5.0, 6.0, 7.0), "begin": (math.nan,) * 3}, {"begin": (5, 6, 7), "end": (5, 6, 17)}]
    )
    found = sample(m, np.array([1, 2]), 1.0, fresh=(0, 1))
    assert found.q.tolist() == [[5, 6, 7], [5, 6, 7], [5, 6, 12], [5, 6, 17]]
    assert found.t == pytest.approx([0, 0, 0.5, 1.0]) and found.move.tolist() == [0, 1, 1, 1]
    assert m.lengths().tolist() == [0.0, 10.0]


@pytest.mark.parametrize("xyz", [(2, 0, 1), (4, 3, 1)])
def test_joints_may_stand_in_any_order(xyz):
    straight = path(MIXED)
    count = max(xyz) + 1

    def put(table):
        out = np.zeros((len(table), count))
        out[:, list(xyz)] = table
        return out

    other = Moves(**{**straight.__dict__, "begin": put(straight.begin), "end": put(straight.end), "xyz": xyz})
    number = np.full(len(straight), 3)
    a, b = sample(straight, number, 3000.0), sample(other, number, 3000.0)
    assert_allclose(b.q[:, list(xyz)], a.q, atol=1e-14)
    assert_allclose(b.normal, a.normal, atol=1e-14)
    assert_allclose(b.t, a.t, rtol=1e-14)
    assert_allclose(other.lengths(), straight.lengths(), rtol=1e-14)


def test_a_lathe_without_y_turns_its_arcs_square_to_y_alone():
    """Joints X and Z: an arc square to Y is one, the others have no plane on such a machine."""
    rows = [
        {"kind": ARC, "begin": (3.0, 4.0), "end": (-4.0, 3.0), "centre": (0, 0, 0), "plane": 1, "sweep": -math.pi / 2},
        {"begin": (-4.0, 3.0), "end": (-4.0, 0.0)},
    ]
    m = path(rows, 2, (0, -1, 1))
    found = sample(m, np.array([2, 1]), 1.0)
    assert m.lengths() == pytest.approx([2.5 * math.pi, 3.0])
    quarter = cmath.exp(1j * (cmath.phase(4 + 3j) - math.pi / 4)) * 5  # Z first, then X
    assert found.q[1] == pytest.approx([quarter.imag, quarter.real])
    flat = path([rows[0] | {"plane": 2}, rows[0] | {"plane": 0}], 2, (0, -1, 1))
    assert flat.lengths().tolist() == [1.0, 7.0]  # no radius; the rise along Z, and along X


# -- how many points ---------------------------------------------------------------------------------------------------
def test_lines_are_cut_into_steps_and_rapids_are_not():
    ends = [(10.0, 0, 0), (10.5, 0, 0), (0, 0.2, 0), (0, 0, 0), (0, 0, 3.0 + 1e-12)]
    m = path([{"end": e} for e in ends] + [{"kind": RAPID, "end": (100, 0, 0)}])
    number, step = counts(m)
    assert number.tolist() == [10, 11, 1, 1, 3, 1] and step == toolpath.STEP_MM == 1.0
    assert counts(m, 0.1)[0].tolist() == [100, 105, 2, 1, 30, 1] and number.dtype.kind == "i"


def test_arcs_are_cut_into_a_multiple_of_eight_per_turn():
    def of(radius, sweep, rise=0.0, step=1.0):
        return int(counts(path([arc(2, (0, 0, 0), (radius, 0), radius, sweep, rise)]), step)[0][0])

    assert of(1.0, math.pi / 2) == 16 and of(1.0, -2 * math.pi) == 64  # never less than 64 to a turn
    assert of(100.0, 2 * math.pi) == 632 and of(100.0, -math.pi) == 316  # 628.3 mm, up to a multiple of 8
    assert of(0.0, 0.0) == 1 and of(100.0, 0.001) == 1
    assert of(100.0, 2 * math.pi, 700.0) == 8 * math.ceil(math.hypot(200 * math.pi, 700.0) / 8)
    assert of(100.0, 4 * math.pi, step=0.5) == 2 * 1264


@pytest.mark.parametrize("length", [1e3, 5e3, 1e6])
def test_the_step_grows_until_there_are_few_enough_points(length):
    m = path([{"end": (length, 0, 0)}, {"end": (0, length, 0)}])
    number, step = counts(m, most=1000)
    assert 1000 / 1.3 < number.sum() <= 1000
    assert number.tolist() == [math.ceil(length / step - 1e-9)] * 2
    assert counts(m, most=int(2 * length))[1] == 1.0 and counts(m, most=int(2 * length) - 1)[1] > 1.0


def test_more_moves_than_points_end():
    number, step = counts(path([{"end": (1, 0, 0)}] * 40), most=39)
    assert number.tolist() == [1] * 40 and step > 1e6


# -- senses of motion --------------------------------------------------------------------------------------------------
def test_directions_are_those_of_the_last_motion():
    rng = np.random.default_rng(5)
    q = np.cumsum(rng.integers(-1, 2, size=(60, 3)) * 0.25, axis=0)
    q[10:14] += np.array([1e-10, 0, 0]) * np.arange(4)[:, None]  # less than a millionth of a mm is no motion
    want, last = np.zeros(q.shape), np.zeros(3)
    for i in range(1, len(q)):
        for j in range(3):
            change = q[i, j] - q[i - 1, j]
            if abs(change) > 1e-9:
                last[j] = math.copysign(1, change)
        want[i] = last
    assert directions_of(q).tolist() == want.tolist()
    assert directions_of([[1.0, 2.0]]).tolist() == [[0, 0]] and directions_of(np.empty((0, 2))).shape == (0, 2)
    assert directions_of([[0.0], [0.5], [0.5], [0.0]])[:, 0].tolist() == [0, 1, 1, -1]


def test_a_path_has_as_many_points_as_rows():
    nothing = np.zeros((4, 3))
    made = ToolPath(nothing, np.arange(4), np.ones(4, dtype=bool), nothing, nothing, nothing, nothing, {})
    assert made.points == 4 and made.labels == {} and len(path(MIXED)) == 11
