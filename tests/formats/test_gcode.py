# SPDX-License-Identifier: LGPL-2.1-or-later
"""G-code: moves, arcs, cycles, compensation, offsets; what is listed, and what is refused with its line."""

from __future__ import annotations

import time

import numpy as np
import pytest

from sensworkbench.core.refusal import Refused
from sensworkbench.core.toolpath import ARC, LINE, RAPID, counts, sample
from sensworkbench.formats import gcode, machine_json
from sensworkbench.formats.gcode import Settings, Tool

from .support import ROOT

JOINTS = machine_json.load(ROOT / "resources" / "examples" / "vertical_machining_centre.json").joints
ZERO = Settings({"G54": (0.0, 0.0, 0.0), "G55": (10.0, 20.0, 30.0)}, {1: Tool(2.0, 5.0), 2: Tool(None, 3.0)})
START = "G21 G90 G54 G17\nG0 X0 Y0 Z5\nG1 Z0 F100\n"


def read(text: str, settings=ZERO) -> gcode.Program:
    return gcode.loads(text.encode("latin-1"), "p.nc", JOINTS, settings)


def last(text: str):
    return read(START + text).moves.end[-1]


def points(text: str, step=1.0):
    moves = read(START + text).moves
    number, _ = counts(moves, step)
    return moves, sample(moves, number, 1e4)


def test_lines_are_absolute_or_incremental_in_mm_or_inches():
    assert last("G1 X10 Y-2.5") == pytest.approx([10, -2.5, 0])
    assert last("G91 G1 X10\nX10 Z1.") == pytest.approx([20, 0, 1])
    assert last("G20 G1 X1 F4") == pytest.approx([25.4, 0, 0])
    assert read(START + "G20 G1 X1 F4").moves.feed[-1] == pytest.approx(4 * 25.4)
    assert last("N10 (to the right) G01X1.5Y2;end") == pytest.approx([1.5, 2, 0])


def test_offsets_are_of_the_system_of_the_program_and_of_the_machine():
    assert last("G55 G1 X1 Y1 Z1") == pytest.approx([11, 21, 31])
    assert last("G0 G53 X7") == pytest.approx([7, 0, 0])
    assert last("G10 L2 P3 X100 Y0 Z0\nG56 G1 X1") == pytest.approx([101, 0, 0])
    moves = read(START + "G43 H1 G1 Z0 X3").moves
    assert moves.end[-1] == pytest.approx([3, 0, 2]) and moves.length[-1] == 2 and moves.shift[-1][2] == 2


def test_arcs_run_the_short_or_the_long_way_round():
    moves, found = points("G2 X10 Y-10 J-10")  # clockwise about (0, -10): a quarter
    assert moves.sweep[-1] == pytest.approx(-np.pi / 2)
    assert np.hypot(found.q[-20:, 0], found.q[-20:, 1] + 10) == pytest.approx(10)
    assert points("G3 X10 Y-10 J-10")[0].sweep[-1] == pytest.approx(1.5 * np.pi)
    assert points("G2 X10 Y-10 R10")[0].sweep[-1] == pytest.approx(-np.pi / 2)
    assert points("G2 X10 Y-10 R-10")[0].sweep[-1] == pytest.approx(-1.5 * np.pi)
    assert points("G3 I-10")[0].sweep[-1] == pytest.approx(2 * np.pi)
    assert points("G90.1\nG3 X10 Y10 I10 J0")[0].sweep[-1] == pytest.approx(1.5 * np.pi)


def test_arcs_in_the_other_planes_turn_about_their_axes():
    moves, found = points("G18 G2 X10 Z-10 I0 K-10")  # G18: from Z to X, clockwise about +Y
    assert moves.plane[-1] == 1 and found.q[-1] == pytest.approx([10, 0, -10])
    assert np.hypot(found.q[-9:, 0], found.q[-9:, 2] + 10) == pytest.approx(10)
    moves, found = points("G19 G3 Y10 Z10 J0 K10")
    assert moves.plane[-1] == 0 and np.hypot(found.q[-9:, 1], found.q[-9:, 2] - 10) == pytest.approx(10)


def test_a_helix_climbs_evenly_and_its_length_counts():
    moves, found = points("G3 X0 Y0 Z-6 I-10")
    rows = found.move == len(moves) - 1
    assert np.allclose(found.q[rows, 2], -6 * found.fraction[rows])
    assert moves.lengths()[-1] == pytest.approx(np.hypot(2 * np.pi * 10, 6))
    assert found.t[-1] - found.t[~rows][-1] == pytest.approx(60 * np.hypot(2 * np.pi * 10, 6) / 100)


def test_a_full_circle_has_its_diagonals_among_its_points():
    _, found = points("G3 I-10", step=3.0)
    angle = np.degrees(np.arctan2(found.q[:, 1], found.q[:, 0] + 10)) % 90
    assert np.abs(angle - 45).min() < 1e-9


def test_cycles_drill_with_rapids_feeds_and_returns():
    moves = read(START + "G0 Z20\nG98 G81 X10 Y5 Z-8 R2 F50\nX20\nG99 X30\nG80\nG0 X0").moves
    feeds = moves.kind == LINE
    assert moves.end[feeds][1:] == pytest.approx(np.array([[10, 5, -8], [20, 5, -8], [30, 5, -8]]))
    assert [tuple(e) for e in moves.end[-2:]] == [(30, 5, 2), (0, 5, 2)]  # G99 goes back to R only
    assert (30, 5, 20) in [tuple(e) for e in moves.end]  # at the initial height after G98
    bored = read(START + "G0 Z20\nG85 X1 Y1 Z-3 R2 F50").moves
    assert bored.kind[-3:].tolist() == [LINE, LINE, RAPID] and bored.end[-3:, 2].tolist() == [-3, 2, 20]
    three = read(START + "G0 Z20\nG91 G81 X10 Z-5 R-18 L3 F50").moves
    assert three.end[three.kind == LINE][1:, 0].tolist() == [10, 20, 30]


def test_the_cutter_stands_beside_the_contour_and_its_normal_is_known():
    moves, found = points("G41 D1 G1 X10 Y0\nX30\nG3 X30 Y20 J10\nG40 G1 X0")
    straight = found.move == 3
    assert np.allclose(found.q[straight][:, 1], 5) and np.allclose(found.normal[straight], [0, 1, 0])
    round_ = found.move == 4
    assert np.hypot(found.q[round_, 0] - 30, found.q[round_, 1] - 10) == pytest.approx(5)
    assert np.isnan(found.normal[found.move == 2]).all()  # the way in makes no surface
    right = points("G42 D1 G1 X10 Y0\nX30")[1]
    assert np.allclose(right.normal[right.move == 3], [0, -1, 0])


def test_words_without_a_meaning_are_listed_with_line_and_count():
    found = read("%\nO1000\n" + START + "M88 G1 X1\nM88 X2 E4\nG187 P2\n(a comment)\nX3 M30\n%")
    wanted = (("O1000", 2, 1), ("M88", 6, 2), ("E4", 7, 1), ("G187", 8, 1), ("P", 8, 1))
    assert found.unread == wanted
    assert found.assumed == ()
    assert read("G0 X0 Y0 Z0\nG1 X1 F9").assumed == ("G21", "G90", "G17", "G54")


@pytest.mark.parametrize(
    "text, code, line",
    [
        (START + "G2 X10", "gcode-arc-without-centre", 4),
        (START + "G2 X10 I3", "gcode-arc-radii", 4),
        (START + "G2 X10 R2", "gcode-arc-radius", 4),
        ("G0 X0 Y0 Z0\nG1 X5", "gcode-no-feed", 2),
        ("G0 X0 Y0 Z0\nG1 X5 F0", "gcode-no-feed", 2),
        ("G0 X0 Y0\nG1 X5 F100", "gcode-place-unknown", 2),
        ("G91 G0 X5", "gcode-place-unknown", 1),
        ("G56 G0 X0", "gcode-no-work-offset", 1),
        ("X5 Y5", "gcode-no-motion", 1),
        (START + "G28 Z0\nG1 X5", "gcode-place-unknown", 5),
        (START + "G68 R30", "gcode-moves-otherwise", 4),
        (START + "G92 X0", "gcode-moves-otherwise", 4),
        (START + "#1=5", "gcode-expression", 4),
        (START + "G1 X[1+2]", "gcode-expression", 4),
        (START + "O100 sub", "gcode-word-without-number", 4),
        (START + "M98 P5", "gcode-subprogram", 4),
        (START + "G1 A5", "gcode-axis-missing", 4),
        (START + "G1 X1 X2", "gcode-word-twice", 4),
        (START + "G41 D9 G1 X5", "gcode-cutter-without-radius", 4),
        (START + "G41 D1 G1 X5\nG3 X9 Y0 I2", "gcode-cutter-too-large", 5),
        (START + "G81 X5", "gcode-cycle-incomplete", 4),
        (START + "G1 X99999999", "gcode-number-too-large", 4),
        (START + "G1 X5 & Y6", "gcode-character", 4),
        ("(nothing)\n", "gcode-no-moves", 0),
    ],
)
def test_what_would_be_a_guess_is_refused_with_its_line(text, code, line):
    with pytest.raises(Refused) as refused:
        read(text)
    assert refused.value.code == code and refused.value.do
    assert refused.value.where == (f"p.nc, line {line}" if line else "p.nc")


def test_blocks_know_their_bytes():
    text = START + "(\xfc) G1 X5\r\nX6\n"
    found = read(text)
    data = text.encode("latin-1")
    begin, end = found.lines[found.moves.block[-1] - 1]
    assert data[begin:end] == b"X6"
    begin, end = found.lines[found.moves.block[-2] - 1]
    assert data[begin:end] == b"(\xfc) G1 X5\r"


def test_time_grows_with_the_size_of_the_program():
    def seconds(count):
        text = START + "".join(f"G1 X{i % 97} Y{i % 89}.5\n" for i in range(count))
        begin = time.process_time()
        moves = read(text).moves
        sample(moves, counts(moves)[0], 1e4)
        return time.process_time() - begin

    few, many = (min(seconds(count) for _ in range(3)) for count in (5_000, 40_000))
    assert many < 24 * few  # 8 times as many blocks; time that grows with the square would be 64 times as long


def test_arcs_of_kind_arc_are_told_from_lines():
    assert read(START + "G2 X10 Y-10 J-10\nG1 X0").moves.kind.tolist()[-2:] == [ARC, LINE]
