# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line as a process of its own where FreeCAD cannot be imported: numbers, files, exit status, refusals."""

from __future__ import annotations

import csv
import json
import math

import pytest

from sensworkbench import __version__, cli

from .support import command, golden, write
from .test_machine_json import BAD

# SPEC: the paper's tolerances at q = (200, 150, -100), FXYZ, tool vector (0, 0, -150): symbol -> (S or None, S^T)
TABLE = {
    "EAX": (0.0144, 0.1874),
    **dict.fromkeys(("EXY", "EBX", "EBY", "EXZ"), (0.0078, 0.1801)),
    **dict.fromkeys(("EAY", "EYZ", "EYX"), (0.0078, 0.1522)),
    **dict.fromkeys(("ECX", "EBZ", "C0Y"), (0.0010, 0.0720)),
    **dict.fromkeys(("EZX", "EZY"), (None, 0.0625)),
    "EAZ": (None, 0.0619),
    **dict.fromkeys(("B0Z", "EXT"), (None, 0.0330)),
    **dict.fromkeys(("A0Z", "EYT"), (None, 0.0285)),
    "EXX": (None, 0.0084),
    "EYY": (None, 0.0073),
    "EZZ": (None, 0.0037),
    "EZT": (None, 0.0009),
    **dict.fromkeys(("ECY", "ECZ"), (0.0, 0.0)),
}


@pytest.fixture
def place(tmp_path):
    """A folder with the golden machine in it, and one for the import block."""
    (tmp_path / "block").mkdir()
    (tmp_path / "work").mkdir()
    write(tmp_path / "work" / "m.json", golden())

    def run(*words, **environment):
        return command(*words, cwd=tmp_path / "work", block=tmp_path / "block", **environment)

    run.folder = tmp_path / "work"
    return run


def result(folder) -> dict:
    return json.loads((folder / "sensitivity.json").read_text(encoding="utf-8"))


@pytest.mark.parametrize("words", [("--at", "200,150,-100"), ("--at=200,150,-100",)])
def test_the_numbers_of_the_specification(place, words):
    run = place("sensitivity", "m.json", "--out", "out", *words)
    assert (run.returncode, run.stderr) == (0, "")
    data = result(place.folder / "out")
    assert (data["format"], data["version"]) == ("sens-sensitivity", 1)
    assert (data["aggregate"], data["points"], data["estimated_error"]) == ("at", [200, 150, -100], None)
    assert data["mean_square_um2"] == pytest.approx(104.75, rel=1e-9)
    assert data["variance_um4"] == pytest.approx(7154.85, rel=1e-9)
    found = {e["symbol"]: e for e in data["errors"]}
    assert set(found) == set(TABLE)
    for symbol, (first, total) in TABLE.items():
        assert found[symbol]["total"] == pytest.approx(total, abs=5.1e-5), symbol
        assert found[symbol]["total_max"] == found[symbol]["total"]
        if first is not None:
            assert found[symbol]["first"] == pytest.approx(first, abs=5.1e-5), symbol
    assert sum(e["first"] for e in data["errors"]) == pytest.approx(0.0891, abs=5e-5)
    assert found["EAX"].items() >= {"unit": "urad", "lower": -20, "upper": 20, "owner": "X"}.items()
    assert found["EXX"].items() >= {"unit": "um", "lower": -1, "upper": 1, "distribution": "uniform"}.items()
    totals = [e["total"] for e in data["errors"]]
    assert totals == sorted(totals, reverse=True) or max(b - a for a, b in zip(totals, totals[1:])) < 1e-12


def test_a_position_may_begin_with_a_minus_sign(place):
    both = []
    for words in (("--at", "-10,5,3"), ("--at=-10,5,3",)):
        assert place("sensitivity", "m.json", "--out", "out", *words).returncode == 0
        both.append(result(place.folder / "out"))
    assert both[0] == both[1]
    assert both[0]["points"] == [-10, 5, 3]


def test_quadrature_is_the_default_and_states_its_error(place):
    run = place("sensitivity", "m.json", "--out", "out")
    data = result(place.folder / "out")
    assert run.returncode == 0
    assert (data["aggregate"], data["points"]) == ("quadrature", [8, 8, 8])
    assert 0 <= data["estimated_error"] < 1e-4
    assert place("sensitivity", "m.json", "--out", "finer", "--quadrature", "14").returncode == 0
    finer = {e["symbol"]: e["total"] for e in result(place.folder / "finer")["errors"]}
    assert max(abs(e["total"] - finer[e["symbol"]]) for e in data["errors"]) <= 3 * data["estimated_error"]


def test_a_grid_is_the_mean_over_its_points(place):
    assert place("sensitivity", "m.json", "--out", "grid", "--grid", "2").returncode == 0
    data = result(place.folder / "grid")
    assert (data["aggregate"], data["points"]) == ("grid", [2, 2, 2])
    mean, largest = dict.fromkeys(TABLE, 0.0), dict.fromkeys(TABLE, 0.0)
    from sensworkbench.core import workspace
    from sensworkbench.formats import machine_json

    machine = machine_json.load(place.folder / "m.json")
    for corner in [(x, y, z) for x in (-300, 300) for y in (-200, 200) for z in (-250, 50)]:
        one = workspace.sensitivity(machine, workspace.at(machine, corner))
        for symbol, total in zip(one.symbols, one.total):
            mean[symbol] += total / 8
            largest[symbol] = max(largest[symbol], total)
    for e in data["errors"]:
        assert e["total"] == pytest.approx(mean[e["symbol"]], abs=1e-12)
        assert e["total_max"] == pytest.approx(largest[e["symbol"]], abs=1e-12)


def test_weights_leave_a_component_out(place):
    assert place("sensitivity", "m.json", "--out", "out", "--at", "200,150,-100", "--weights", "1,1,0").returncode == 0
    data = result(place.folder / "out")
    found = {e["symbol"]: e["total"] for e in data["errors"]}
    assert found["EZX"] == found["EZT"] == 0 < found["EXX"]
    assert data["settings"]["objective"] == "T4² + T5²"


def test_one_signed_component_has_indices_that_add_to_one(place):
    words = ("--at", "200,150,-100", "--weights", "0,0,-1", "--signed")
    assert place("sensitivity", "m.json", "--out", "out", *words).returncode == 0
    data = result(place.folder / "out")
    assert sum(e["first"] for e in data["errors"]) == pytest.approx(1, abs=1e-12)
    assert all(e["first"] == e["total"] for e in data["errors"])
    assert data["mean_square_um2"] is None and data["variance_um2"] > 0


def test_orientation_has_its_own_units_and_only_angles(place):
    assert place("sensitivity", "m.json", "--out", "out", "--output", "orientation").returncode == 0
    data = result(place.folder / "out")
    assert data["mean_square_um2"] is None
    assert data["mean_square_urad2"] == pytest.approx(9 * 400 / 3, rel=1e-9)  # nine angles of +-20 urad
    moving = {e["symbol"] for e in data["errors"] if e["total"] > 0}
    assert moving == {f"E{a}{b}" for a in "ABC" for b in "XYZ"}


def test_the_squareness_convention_can_be_overridden(place):
    write(place.folder / "carried.json", golden(squareness="carried"))
    place("sensitivity", "m.json", "--out", "a", "--squareness", "carried")
    place("sensitivity", "carried.json", "--out", "b")
    place("sensitivity", "m.json", "--out", "c")
    a, b, c = (result(place.folder / x) for x in "abc")
    assert a["errors"] == b["errors"] != c["errors"]
    assert a["squareness_conventions"]["carried"]["total"] == {e["symbol"]: e["total"] for e in a["errors"]}
    assert a["squareness_conventions"]["direction"]["total"] == {e["symbol"]: e["total"] for e in c["errors"]}
    assert a["conventions"]["squareness"] != c["conventions"]["squareness"]


def test_angles_can_be_shown_in_arcseconds(place):
    place("sensitivity", "m.json", "--out", "out", "--at", "0,0,0", "--angle-unit", "arcsec")
    found = {e["symbol"]: e for e in result(place.folder / "out")["errors"]}
    assert found["EAX"]["unit"] == "arcsec"
    assert found["EAX"]["upper"] == pytest.approx(20e-6 * 180 / math.pi * 3600, rel=1e-11)


def test_the_csv_says_the_same_as_the_json(place):
    place("sensitivity", "m.json", "--out", "out", "--at", "200,150,-100")
    with open(place.folder / "out" / "sensitivity.csv", encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    for row, error in zip(rows, result(place.folder / "out")["errors"], strict=True):
        assert row["symbol"] == error["symbol"]
        assert float(row["first"]) == error["first"] and float(row["total"]) == error["total"]


def test_names_in_a_table_never_become_formulas(place):
    effect = {
        "name": "=HYPERLINK(1)",
        "component": "EAZ",
        "driver": "temp_column",
        "shape": "linear",
        "parameters": {"coefficient": {"value": 1, "unit": "urad/K"}, "extent": {"value": [-30, 30], "unit": "urad"}},
    }
    write(place.folder / "e.json", golden(effects=[effect]))
    assert place("sensitivity", "e.json", "--out", "out").returncode == 0
    text = (place.folder / "out" / "sensitivity.csv").read_text(encoding="utf-8")
    assert "'=HYPERLINK(1)" in text and ",=HYPERLINK" not in text


def test_the_same_run_gives_the_same_files(place):
    texts = []
    for name in "ab":
        place("sensitivity", "m.json", "--out", name)
        texts.append([(place.folder / name / f).read_bytes() for f in ("sensitivity.json", "sensitivity.csv")])
    assert texts[0] == texts[1]


def test_files_of_other_names_stay_where_they_are(place):
    (place.folder / "out").mkdir()
    write(place.folder / "out" / "notes.txt", "mine")
    assert place("sensitivity", "m.json", "--out", "out").returncode == 0
    names = {p.name for p in (place.folder / "out").iterdir()}
    assert names == {"notes.txt", "manifest.json", "sensitivity.json", "sensitivity.csv", "report.html"}
    assert {p.name for p in place.folder.iterdir()} == {"m.json", "out"}


def test_it_runs_without_matplotlib_and_the_report_keeps_its_tables(place):
    block = place.folder.parent / "block"
    (block / "matplotlib").mkdir()
    (block / "matplotlib" / "__init__.py").write_text("raise ImportError('broken')\n")
    run = place("sensitivity", "m.json", "--out", "out")
    assert run.returncode == 0, run.stderr
    page = (place.folder / "out" / "report.html").read_text(encoding="utf-8")
    assert "<svg" not in page and page.count("<table") >= 5


# -- refusals --------------------------------------------------------------------------------------------------------
def in_process(folder, capsys, *words) -> str:
    """One refused command: exit status 2, one message, nothing written."""
    before = {p: p.read_bytes() for p in folder.rglob("*") if p.is_file()}
    status = cli.main([str(w) for w in words])
    caught = capsys.readouterr()
    assert (status, caught.out) == (2, ""), caught.err
    assert "Traceback" not in caught.err and caught.err.count("\n") == 1
    assert {p: p.read_bytes() for p in folder.rglob("*") if p.is_file()} == before
    assert not any(p.is_dir() for p in folder.iterdir())
    return caught.err


@pytest.mark.parametrize("case", BAD, ids=list(BAD))
def test_bad_machines_are_refused_and_nothing_is_written(case, tmp_path, capsys):
    data, words = BAD[case]
    path = write(tmp_path / "m.json", data)
    message = in_process(tmp_path, capsys, "sensitivity", path, "--out", tmp_path / "out")
    assert message.startswith(str(path))
    for word in words:
        assert word in message


def test_zero_variance_everywhere_is_refused(tmp_path, capsys):
    zero = {s: {"lower": 0, "upper": 0, "unit": "urad" if s[1] in "ABC0" or s[0] != "E" else "um"} for s in TABLE}
    path = write(tmp_path / "m.json", golden(tolerances=zero))
    assert "variance" in in_process(tmp_path, capsys, "sensitivity", path, "--out", tmp_path / "out")


@pytest.mark.parametrize(
    ("words", "word"),
    [
        ((), "VERB"),
        (("sensitivty", "m.json"), "sensitivty"),
        (("sensitivity", "m.json"), "--out"),
        (("sensitivity", "m.json", "--out", "out", "--at", "1,2"), "X, Y, Z"),
        (("sensitivity", "m.json", "--out", "out", "--at", "1,2,x"), "not numbers"),
        (("sensitivity", "m.json", "--out", "out", "--at", "nan,0,0"), "finite"),
        (("sensitivity", "m.json", "--out", "out", "--at", "inf,0,0"), "finite"),
        (("sensitivity", "m.json", "--out", "out", "--at", "0,0,0", "--grid", "3"), "--grid"),
        (("sensitivity", "m.json", "--out", "out", "--grid", "0"), "0"),
        (("sensitivity", "m.json", "--out", "out", "--grid", "1"), "2"),
        (("sensitivity", "m.json", "--out", "out", "--grid", "9999"), "too many"),
        (("sensitivity", "m.json", "--out", "out", "--weights", "0,0,0"), "weights"),
        (("sensitivity", "m.json", "--out", "out", "--weights", "-1,0,0"), "weights"),
        (("sensitivity", "m.json", "--out", "out", "--weights", "nan,1,1"), "weights"),
        (("sensitivity", "m.json", "--out", "out", "--output", "colour"), "colour"),
        (("sensitivity", "m.json", "--out", "out", "--sqareness", "carried"), "--sqareness"),
        (("sensitivity", "m.json", "--out", "m.json"), "m.json"),
        (("sensitivity", "none.json", "--out", "out"), "none.json"),
        (("sensitivity", "none.FCStd", "--out", "out"), "none.FCStd"),
        (("sensitivity", "m.json", "--out", "out", "--picture", "m.json"), "PNG"),
        (("sensitivity", "m.json", "--out", "out", "--tolerances", "none.csv"), "none.csv"),
    ],
)
def test_bad_options_are_refused(words, word, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write(tmp_path / "m.json", golden())
    assert word in in_process(tmp_path, capsys, *words)


def test_a_refusal_of_the_process_is_one_message_and_status_two(place):
    write(place.folder / "bad.json", golden(axes__X__travel=[1, 1]))
    run = place("sensitivity", "bad.json", "--out", "a/b/out")
    assert run.returncode == 2
    assert run.stdout == ""
    assert run.stderr.startswith("bad.json, line ") and "axes.X.travel" in run.stderr and run.stderr.count("\n") == 1
    assert not (place.folder / "a").exists()


def test_a_folder_that_cannot_be_made_is_refused_and_leaves_nothing(place):
    run = place("sensitivity", "m.json", "--out", "m.json/out")
    assert run.returncode == 2 and "m.json" in run.stderr
    assert {p.name for p in place.folder.iterdir()} == {"m.json"}


def test_a_defect_is_status_one_with_a_short_message(tmp_path, capsys, monkeypatch):
    from sensworkbench.core import workspace

    def broken(*_, **__):
        raise ZeroDivisionError("deep inside")

    monkeypatch.setattr(workspace, "sensitivity", broken)
    monkeypatch.delenv("SENS_DEBUG", raising=False)
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    monkeypatch.setattr("tempfile.tempdir", None)
    path = write(tmp_path / "m.json", golden())
    assert cli.main(["sensitivity", str(path), "--out", str(tmp_path / "out")]) == 1
    message = capsys.readouterr().err
    assert "defect" in message and "ZeroDivisionError" in message and "Traceback" not in message
    log = message.rpartition("details are in ")[2].strip().rstrip(".")
    with open(log, encoding="utf-8") as stream:
        assert "deep inside" in stream.read()
    assert not (tmp_path / "out").exists()


def test_help_and_version_are_no_refusals(capsys):
    assert cli.main(["--version"]) == 0
    assert __version__ in capsys.readouterr().out
    assert cli.main(["sensitivity", "--help"]) == 0
    assert "--quadrature" in capsys.readouterr().out
