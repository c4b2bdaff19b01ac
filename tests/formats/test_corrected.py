# SPDX-License-Identifier: LGPL-2.1-or-later
"""The corrected program: machined by the exact product it leaves little, and everything else stays byte for byte."""

from __future__ import annotations

import json

import numpy as np
import pytest

from sensworkbench.core.synthesis import exact_error
from sensworkbench.core.toolpath import counts, sample
from sensworkbench.formats import gcode, machine_json, part_files

from .support import ROOT, golden, write
from .test_gcode import ZERO

EXAMPLE = ROOT / "resources" / "examples"
PIECE, FEATURES = EXAMPLE / "part" / "test_piece.nc", EXAMPLE / "part" / "features.json"


def fitted_machine(seed=0):
    data = json.loads((EXAMPLE / "vertical_machining_centre.json").read_text(encoding="utf-8"))
    rng, fitted = np.random.default_rng(seed), {}
    for k in "XYZ":
        for i, motion in enumerate("XYZABC"):
            size = rng.normal(size=3) * (3 if i < 3 else 8)
            fitted[f"E{motion}{k}"] = {"basis": "legendre", "domain": [-250, 250], "coefficients": [0, *size],
                                       "unit": "um" if i < 3 else "urad", "u": [0, 0.1, 0.1, 0.1]}  # fmt: skip
    fitted |= {s: {"value": v, "unit": "urad", "u": 1} for s, v in (("C0Y", 15), ("A0Z", -12), ("B0Z", 9))}
    return machine_json.loads(json.dumps(data | {"fitted": fitted}), "m")


def made(machine, program):
    """(move, normal, nominal surface point, made point) of the compensated moves, by the exact product."""
    moves = program.moves
    found = sample(moves, counts(moves, 2.0)[0], 1e4)
    rows = np.isfinite(found.normal[:, 0])
    m = found.move[rows]
    tip = -moves.length[m][:, None] * np.array([0, 0, 1.0]) - moves.radius[m][:, None] * found.normal[rows]
    shown = {
        s: machine.fitted.values(s, found.q[rows][:, "XYZ".index(machine.component(s).body)])
        for s in machine.fitted.symbols
    }
    error, _ = exact_error(machine, shown, found.q[rows], tip)
    return moves.block[m], found.normal[rows], found.contour[rows], found.contour[rows] + error


@pytest.fixture(scope="module")
def piece():
    machine = fitted_machine()
    job = part_files.read(machine, PIECE, part_files.Options(features=str(FEATURES), correct="out.nc"))
    data, said = part_files.corrected(job)
    again = gcode.loads(data, "out.nc", machine.joints, gcode.Settings({"G54": (0.0, 0.0, 0.0)}, {
        1: gcode.Tool(0.0, 10.0), 2: gcode.Tool(25.0, 4.0)}))  # fmt: skip
    return machine, job, data, said, again


def test_the_circle_that_the_machine_then_makes_is_round(piece):
    machine, job, _, _, again = piece

    def departures(program):
        _, _, nominal, real = made(machine, program)
        rows = (np.abs(np.hypot(nominal[:, 0], nominal[:, 1]) - 54) < 0.1) & (np.abs(nominal[:, 2] + 20) < 0.1)
        assert rows.sum() > 60
        return np.hypot(real[rows, 0], real[rows, 1]) - 54, real[rows, 2] + 20

    before, after = (np.sqrt(sum((d**2).mean() for d in departures(p))) for p in (job.program, again))
    assert before > 3e-3 and after < 0.05 * before


def test_the_sides_that_the_machine_then_makes_are_in_place(piece):
    machine, job, _, _, again = piece
    for axis, place in ((0, -80), (1, 80), (0, 80), (1, -80)):
        sizes = []
        for program in (job.program, again):
            _, normal, nominal, real = made(machine, program)
            rows = (np.abs(nominal[:, axis] - place) < 0.1) & (np.abs(nominal[:, 2] + 50) < 0.1)
            rows &= np.abs(normal[:, axis]) > 0.99
            sizes.append(np.sqrt(((real[rows, axis] - place) ** 2).mean()))
        assert sizes[1] < max(0.05 * sizes[0], 2e-4), (axis, place, sizes)


def test_the_report_says_what_is_left(piece):
    _, _, _, said, _ = piece
    assert said["after_um"] < 0.05 * said["before_um"] and said["clipped"] == 0 and said["largest_um"] < 100
    assert said["uncertainty_um"] > 0.1
    left = {f["name"]: (f["before_um"], f["after_um"]) for f in said["features"]}
    assert left["circle"][0] > 1 and left["circle"][1] < 0.3
    tables = {t["format"]: t["after_um"] for t in said["tables"]}
    assert tables and all(v >= 0 for v in tables.values())


def test_what_does_not_move_stays_byte_for_byte(piece):
    _, job, data, _, again = piece
    original = PIECE.read_bytes().split(b"\n")
    lines = data.split(b"\n")
    blocks = set(job.program.moves.block)
    still = [line for n, line in enumerate(original, start=1) if n not in blocks]
    rest = iter(lines)
    assert all(line in rest for line in still)  # in their order
    assert set(again.moves.feed[~np.isnan(again.moves.feed)]) <= set(job.program.moves.feed)
    for n in blocks:
        word = original[n - 1].split()[0]
        assert any(line.startswith(word + b" ") for line in lines), word  # every block keeps its number


def test_no_point_moves_beyond_the_limit():
    machine = fitted_machine()
    options = part_files.Options(features=str(FEATURES), correct="out.nc", correct_limit=2e-3)
    job = part_files.read(machine, PIECE, options)
    data, said = part_files.corrected(job)
    again = gcode.loads(data, "out.nc", machine.joints, part_files.features_json.settings_for(
        part_files.features_json.load(FEATURES, machine.joints), {}, {}))  # fmt: skip
    assert said["largest_um"] == 2 and said["clipped"] > 0
    ends = {tuple(np.round(e, 1)) for e in job.program.moves.end}
    reached = np.array([e for e in again.moves.end if tuple(np.round(e, 1)) in ends])
    nearest = [np.abs(job.program.moves.end - e).max(axis=1).min() for e in reached]
    assert max(nearest) <= 2e-3 + 1e-4  # and the last digit that is written


def test_units_increments_and_line_ends_are_kept():
    machine = machine_json.loads(json.dumps(golden(fitted={"C0Y": {"value": 1000, "unit": "urad"}})), "m")
    text = "G20 G90 G54\r\nG0 X1 Y1 Z1 (über)\r\nG91 G1 X1 F10 M9\r\nG1 Y2\r\nG3 X1 Y0 I.5 M5\r\nG53 G0 Z0\r\n"
    program = gcode.loads(text.encode("latin-1"), "p.nc", machine.joints, ZERO)
    from sensworkbench.studies.part_correct import correction

    found = correction(machine, program.moves, gcode.kept(program), limit=10.0)
    data = gcode.written(program, found.points)
    lines = data.split(b"\r\n")
    assert lines[1].startswith(b"G0 X") and lines[1].endswith("(über)".encode("latin-1")) and b"\n" not in lines[1]
    assert lines[-2] == b"G53 G0 Z0" and lines[-3].endswith(b"M5") and lines[2].endswith(b"F10 M9")
    again = gcode.loads(data, "p.nc", machine.joints, ZERO)
    want = program.moves.end[program.moves.kind < 2][:3].copy()
    want[:, 0] += 1e-3 * want[:, 1]  # C0Y moves the tool by -C0Y y along x
    assert again.moves.end[:3] == pytest.approx(want, abs=3e-4)


def test_the_command_line_writes_the_program(tmp_path):
    from sensworkbench.cli.program import main

    machine = write(tmp_path / "m.json", machine_json.dumps(fitted_machine()))
    words = ["part", str(machine), str(PIECE), "--features", str(FEATURES), "--out", str(tmp_path / "out")]
    assert main([*words, "--correct", str(tmp_path / "new.nc")]) == 0
    data = json.loads((tmp_path / "out" / "part.json").read_text(encoding="utf-8"))
    assert data["correction"]["file"] == "new.nc" and (tmp_path / "new.nc").stat().st_size > 10_000
    assert main([*words, "--correct", str(PIECE)]) == 2
    assert main([*words, "--correct", str(tmp_path / "new.nc"), "--errors", "tolerances"]) == 2
