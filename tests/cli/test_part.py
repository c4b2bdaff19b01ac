# SPDX-License-Identifier: LGPL-2.1-or-later
"""`part`: exit statuses, files, refusals, and what part.json says."""

from __future__ import annotations

import json

import numpy as np
import pytest

from sensworkbench.cli.program import main
from tests.formats.support import golden, write
from tests.formats.test_schemas import faults

HEAD = "G21 G17 G90 G54\nG0 X60 Y20 Z5\nG1 Z-10 F300\n"
CIRCLE = "(feature: circle, roundness)\nG3 I-50 F500\n(feature: end)\nG0 Z5\n"


@pytest.fixture
def machine(tmp_path):
    fitted = {"C0Y": {"value": 20, "unit": "urad", "u": 1}}
    return write(tmp_path / "machine.json", golden(fitted=fitted, tool_point=[0, 0, -150]))


def run(machine, path, *more, status=0):
    out = machine.parent / "out"
    assert main(["part", str(machine), str(path), "--out", str(out), *map(str, more)]) == status
    if status:
        assert not out.exists()
        return None
    data = json.loads((out / "part.json").read_text(encoding="utf-8"))
    assert faults("part", data) == []
    assert {p.name for p in out.iterdir()} >= {
        "part.json",
        "features.csv",
        "points.csv",
        "report.html",
        "manifest.json",
    }
    return data


def test_a_program_gives_the_roundness_of_its_circle(machine, tmp_path):
    path = write(tmp_path / "p.nc", HEAD + CIRCLE + "M88\n")
    data = run(machine, path, "--work-offset", "G54=0,0,0", "--limit", "circle=0.9")
    circle = data["features"][0]
    assert circle["value_um"] == pytest.approx(50 * 20e-3, rel=1e-8) and circle["shares"] == {"C0Y": 1.0}
    assert circle["limit_um"] == 0.9 and circle["within"] is False and circle["u_um"] == pytest.approx(0.05)
    assert data["unread_words"] == [{"word": "M88", "line": 8, "count": 1}] and data["outside_travel"] == []
    assert main(["verify", str(machine.parent / "out")]) == 0


def test_blocks_outside_the_travel_are_named_with_their_excess(machine, tmp_path, capsys):
    path = write(tmp_path / "p.nc", HEAD + "G1 X310 F500\nG1 Y-205.5\n")
    found = run(machine, path, "--work-offset", "G54=0,0,0")["outside_travel"]
    assert [(o["line"], o["joint"], o["by"]) for o in found] == [(4, "X", 10.0), (5, "X", 10.0), (5, "Y", 5.5)]
    assert "2 blocks leave the travel" in capsys.readouterr().err


def test_a_limit_or_a_solid_without_what_it_is_for_is_refused(machine, tmp_path, capsys):
    path = write(tmp_path / "p.nc", HEAD + "G1 X10\n")
    run(machine, path, "--work-offset", "G54=0,0,0", "--limit", "circle=1", status=2)
    assert "no features" in capsys.readouterr().err
    run(machine, path, "--work-offset", "G54=0,0,0", "--model", "Plate", status=2)
    assert "no document" in capsys.readouterr().err


def test_as_many_points_are_asked_for_as_the_kind_needs(machine, tmp_path, capsys):
    path = write(tmp_path / "p.nc", HEAD + "(feature: a, roundness)\nG1 X61\n(feature: end)\n")
    run(machine, path, "--work-offset", "G54=0,0,0", status=2)
    assert "at least 4" in capsys.readouterr().err


def test_features_and_offsets_of_a_file(machine, tmp_path):
    path = write(tmp_path / "p.nc", "N1 G0 X60 Y20 Z5\nN2 G1 Z-10 F300\nN3 G3 I-50\nN4 G0 Z5\n")
    features = {
        "format": "sens-features", "version": 1, "work_offsets": {"G54": [0, 0, 0]},
        "features": [{"name": "by line", "kind": "roundness", "lines": [3, 3], "limit_um": 5},
                     {"name": "by block", "blocks": [3, 3]},
                     {"name": "place", "of": "by line", "kind": "position"}],
    }  # fmt: skip
    assert faults("features", features) == []
    data = run(machine, path, "--features", write(tmp_path / "features.json", features))
    assert [f["kind"] for f in data["features"]] == ["roundness", "roundness", "position"]
    assert data["features"][1]["value_um"] == pytest.approx(1.0) and data["features"][0]["within"] is True
    assert data["features"][2]["value_um"] == pytest.approx(2 * 20 * 20e-3)  # C0Y moves the centre by 20 mm of y


def test_a_table_of_points_names_its_features_and_kinds(machine, tmp_path):
    turn = np.arange(360) * np.pi / 180
    rows = [f"{10 + 50 * np.cos(a):.9f},{20 + 50 * np.sin(a):.9f},-10,bore,roundness,2" for a in turn]
    rows += [f"{x},{y},0,top,," for x in range(-50, 51, 10) for y in range(-20, 21, 10)]
    text = "x_mm,y_mm,z_mm,feature,kind,limit_um\n" + "\n".join(rows) + "\n"
    found = run(machine, write(tmp_path / "p.csv", text))["features"]
    assert [(f["name"], f["kind"]) for f in found] == [("bore", "roundness"), ("top", "flatness")]
    assert found[0]["value_um"] == pytest.approx(1.0, rel=1e-7) and found[1]["value_um"] == pytest.approx(0, abs=1e-9)
    assert found[0]["limit_um"] == 2 and found[1]["limit_um"] is None


def test_conditions_are_held_in_between(tmp_path):
    effect = {"name": "growth", "component": "EZT", "driver": "temp_column", "shape": "linear",
              "parameters": {"coefficient": {"value": 2.0, "unit": "um/K"}}, "enabled": True}  # fmt: skip
    machine = write(tmp_path / "machine.json", golden(fitted={"C0Y": {"value": 0, "unit": "urad"}}, effects=[effect]))
    path = write(tmp_path / "p.nc", HEAD + "G1 X0 F600\nG1 Y0\nG1 X10\n")
    run(machine, path, "--work-offset", "G54=0,0,0", status=2)
    conditions = write(tmp_path / "c.csv", "block,temp_column_C\n1,20\n5,23\n")
    data = run(machine, path, "--work-offset", "G54=0,0,0", "--conditions", conditions)
    assert data["error"]["max_um"] == pytest.approx(6) and data["error"]["worst_line"] == 5
    held = run(machine, path, "--work-offset", "G54=0,0,0", "--hold", "temp_column_C=21")
    assert held["error"]["rms_um"] == pytest.approx(2)


@pytest.mark.parametrize(
    "text, words, said",
    [
        (HEAD + "G2 X1\n", ["--work-offset", "G54=0,0,0"], "line 4"),
        (HEAD, [], "the work offset of G54 is not known"),
        (HEAD.replace("F300", "F0"), ["--work-offset", "G54=0,0,0"], "no feed"),
        (HEAD + CIRCLE, ["--work-offset", "G54=0,0"], "3 finite numbers"),
        (HEAD + CIRCLE, ["--work-offset", "G99=0,0,0"], "coordinate system"),
        (HEAD + CIRCLE, ["--work-offset", "G54=0,0,0", "--limit", "none=3"], "no feature"),
        (HEAD + CIRCLE, ["--work-offset", "G54=0,0,0", "--hold", "temp_column=3"], "unit"),
        (HEAD + "(feature: a, roundness)\nG1 X3\n", ["--work-offset", "G54=0,0,0"], "feature 'a'"),
    ],
)
def test_bad_input_is_refused_in_words_and_writes_nothing(machine, tmp_path, capsys, text, words, said):
    run(machine, write(tmp_path / "p.nc", text), *words, status=2)
    assert said in capsys.readouterr().err


def test_reports_are_in_three_languages(machine, tmp_path):
    path = write(tmp_path / "p.nc", HEAD + CIRCLE)
    seen = set()
    for language in ("en", "de", "ko"):
        run(machine, path, "--work-offset", "G54=0,0,0", "--language", language)
        text = (machine.parent / "out" / "report.html").read_text(encoding="utf-8")
        assert f'lang="{language}"' in text and "part-" not in text.partition("<main>")[2].replace("c1-", "")
        seen.add(text)
    assert len(seen) == 3
