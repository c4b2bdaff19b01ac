# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results that can be verified, lists of runs that go on, and verbs that are stopped at every step of their writing."""

from __future__ import annotations

import csv
import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from sensworkbench import cli
from sensworkbench.formats import (
    file_sets,
    files,
    machine_json,
    manifest,
    operations,
    part_files,
    provenance,
    sweep_files,
    sweep_run,
)
from sensworkbench.studies.sweep import FileJudge, run_sweep
from tests.formats.support import golden, write
from tests.formats.test_exchange_fcm import mill
from tests.formats.test_file_sets import Injector, Stopped, hidden

ROOT = Path(__file__).resolve().parents[2]
FITTED = {
    "EXX": {"basis": "legendre", "domain": [-300, 300], "coefficients": [1, 2, 0.5], "unit": "um"},
    "EYY": {"basis": "legendre", "domain": [-200, 200], "coefficients": [0, 1, -1], "unit": "um"},
    "C0Y": {"value": 12, "unit": "urad"},
}


@pytest.fixture
def place(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write(tmp_path / "m.json", golden())
    write(tmp_path / "f.json", golden(fitted=FITTED))
    write(tmp_path / "bad.json", golden(axes__X__travel=[1, 1]))
    q = np.random.default_rng(2).uniform((-300, -200, -250), (300, 200, 50), (40, 3))
    rows = "".join(",".join(f"{v:.3f}" for v in row) + "\n" for row in q)
    write(tmp_path / "p.csv", "x_mm,y_mm,z_mm\n" + rows)
    return tmp_path


VERBS = {
    "sensitivity": (["sensitivity", "m.json", "--at", "10,-5,3"], "o"),
    "plan": (["plan", "m.json", "p.csv"], "o"),
    "predict": (["predict", "f.json", "p.csv"], "o/predicted.csv"),
    "convert": (["convert", "f.json", "--to", "siemens"], "o"),
    "import-errors": (["import-errors", "m.json", "isg.csv", "--from", "isg"], "o/back.json"),
    "import-machine": (["import-machine", "mill.fcm"], "o/mill.json"),
    "trace": (["trace", "m.json", "r.csv", "--permutations", "199"], "o"),
    "allocate": (["allocate", "m.json", "--target", "rms=12", "--costs", "costs.csv"], "o"),
    "sweep": (["sweep", "sweep.json"], "o"),
    "limits": (["limits", "m.json"], "o"),
    "moves": (["moves", "m.json", "--within", "5"], "o"),
    "correlated": (["correlated", "m.json", "--covariance", "covariance.csv"], "o"),
    "fleet": (["fleet", "machines", "--permutations", "199"], "o"),
    "part": (["part", "f.json", "p.nc", "--work-offset=G54=0,0,0"], "o"),
    "part --correct": (["part", "f.json", "p.nc", "--work-offset=G54=0,0,0", "--correct", "o/better.nc"], "o"),
    "part --correct beside": (["part", "f.json", "p.nc", "--work-offset=G54=0,0,0", "--correct=better.nc"], "o"),
}
PROGRAM = "G21 G17 G90 G54\nG0 X60 Y20 Z-20\n(feature: circle, roundness)\nG3 I-50 F500\n(feature: end)\n"
SWEEP = {
    "machine": "m.json",
    "parameters": [{"path": "tool_point.2", "values": [-150, -120, -100]}],
    "design": "full",
    "outputs": ["rms", "share.X"],
}


def given(name) -> None:
    """The files that a verb reads beside those of `place`."""
    if name == "import-errors":
        write(Path("isg.csv"), "X EXX\n-300 0\n-100 0.001\n100 0.002\n200 0.001\n300 0.002\n")
    if name == "import-machine":
        write(Path("mill.fcm"), mill())
    if name in ("trace", "fleet"):
        rows = Path("p.csv").read_text(encoding="utf-8").splitlines()[1:]
        e = np.random.default_rng(3).normal(0, 1, (len(rows), 3))
        table = "".join(f"{row},{a:.3f},{b:.3f},{c:.3f}\n" for row, (a, b, c) in zip(rows, e))
        write(Path("r.csv"), "x_mm,y_mm,z_mm,ex_um,ey_um,ez_um\n" + table)
    if name == "allocate":
        rows = "".join(f"{s},power,10,1,0.5,40\n" for s in ("EXX", "EAX", "EBX", "C0Y"))
        write(Path("costs.csv"), "symbol,kind,c,k,lower,upper\n" + rows)
    if name == "sweep":
        write(Path("sweep.json"), SWEEP)
    if name == "correlated":
        write(Path("covariance.csv"), "symbol,EXX,EAX\nEXX,4,1\nEAX,1,9\n")
    if name == "fleet":
        for machine in ("a", "b"):
            Path("machines", machine).mkdir(parents=True, exist_ok=True)
            write(Path("machines", machine, "machine.json"), golden())
            write(Path("machines", machine, "measured.csv"), Path("r.csv").read_text(encoding="utf-8"))
    if name.startswith("part"):
        write(Path("p.nc"), PROGRAM)


def do(name, *more) -> int:
    words, out = VERBS[name]
    given(name)
    return cli.main([*words, f"--out={out}", *more])


# -- verify ------------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("name", VERBS)
def test_results_come_out_the_same_again(place, capsys, name):
    assert do(name) == 0
    capsys.readouterr()
    assert cli.main(["verify", VERBS[name][1]]) == 0, capsys.readouterr()
    said = capsys.readouterr().out
    assert "come out the same again" in said and said.rstrip().endswith("verified")


def whole_sets(place) -> list[Path]:
    """The files that the verb wrote, without manifests."""
    found = [place / n for n in seen(place) if n.startswith(("o/", "better.nc")) and not n.endswith("manifest.json")]
    return sorted(found)


@pytest.mark.parametrize("name", VERBS)
def test_a_byte_that_changed_is_named_in_every_file_and_input_of_every_verb(place, capsys, name):
    assert do(name) == 0
    results, first = whole_sets(place), json.loads(stated(name).read_text(encoding="utf-8"))["sets"][0]
    inputs = [i["path"] for i in first["inputs"]]
    assert results and inputs
    for path in results:
        data = path.read_bytes()
        path.write_bytes(data[:-2] + bytes([data[-2] ^ 1]) + data[-1:])
        capsys.readouterr()
        assert cli.main(["verify", VERBS[name][1], "--sums-only"]) == 2
        assert f"changed: {path.relative_to(place)} is not the file" in capsys.readouterr().out
        assert path.read_bytes() != data  # and it is left as it was found
        path.write_bytes(data)
    for path in map(Path, inputs):
        data = path.read_bytes()
        path.write_bytes(data + b"\n")
        assert cli.main(["verify", VERBS[name][1]]) == 2
        assert f"changed: the input {path} is not the file" in capsys.readouterr().out
        path.write_bytes(data)
    assert cli.main(["verify", VERBS[name][1], "--sums-only"]) == 0


def test_verify_writes_nothing_and_names_a_further_file_that_differs(place, capsys):
    name = "part --correct beside"
    assert do(name) == 0
    assert do(name) == 0  # what the folder stated before is no input
    assert cli.main(["verify", "better.nc"]) == 0
    data = Path("better.nc").read_bytes()
    changed = data.replace(b"G1", b"G0", 1)
    Path("better.nc").write_bytes(changed)
    for result in ("o", "better.nc"):
        capsys.readouterr()
        assert cli.main(["verify", result]) == 2
        said = capsys.readouterr().out
        assert "changed: better.nc is not" in said and "differs: better.nc: line" in said
        assert Path("better.nc").read_bytes() == changed
    assert cli.main([*VERBS[name][0], "--out=other", "--step=2"]) == 0
    assert cli.main(["verify", "o", "--sums-only"]) == 2
    assert "changed: better.nc is of another run" in capsys.readouterr().out
    Path("better.nc").unlink()
    assert cli.main(["verify", "o"]) == 2 and "missing: better.nc" in capsys.readouterr().out


def test_a_fleet_is_verified_from_another_folder(place, capsys, monkeypatch):
    assert do("fleet") == 0
    (place / "elsewhere").mkdir()
    monkeypatch.chdir(place / "elsewhere")
    assert cli.main(["verify", "../o"]) == 0, capsys.readouterr()
    write(place / "machines" / "b" / "measured.csv", "x_mm\n")
    assert cli.main(["verify", "../o"]) == 2
    assert "machines/b/measured.csv is not the file that was read" in capsys.readouterr().out


def stated(name) -> Path:
    """The manifest of a verb's results."""
    out = Path(VERBS[name][1])
    return out.with_name(manifest.name_of(out.name)) if out.suffix else out / manifest.NAME


def test_what_differs_is_named(place, capsys):
    do("sensitivity")
    capsys.readouterr()
    data = json.loads((place / "o" / "sensitivity.json").read_text(encoding="utf-8"))
    data["errors"][0]["total"] *= 1.001
    write(place / "o" / "sensitivity.json", data)
    assert cli.main(["verify", "o"]) == 2
    said = capsys.readouterr().out
    assert "changed: o/sensitivity.json" in said and "errors[0].total" in said


def test_a_changed_or_missing_input_is_named(place, capsys):
    do("sensitivity")
    write(place / "m.json", golden(name="other"))
    assert cli.main(["verify", "o"]) == 2
    assert "changed: the input m.json" in capsys.readouterr().out
    (place / "m.json").unlink()
    assert cli.main(["verify", "o"]) == 2
    assert "missing: the input m.json" in capsys.readouterr().out


def test_a_missing_file_is_named(place, capsys):
    do("sensitivity")
    (place / "o" / "report.html").unlink()
    assert cli.main(["verify", "o", "--sums-only"]) == 2
    assert "missing: o/report.html" in capsys.readouterr().out


def test_results_of_another_version_are_verified_and_the_version_said(place, capsys):
    do("sensitivity")
    path = place / "o" / "manifest.json"
    write(path, path.read_text(encoding="utf-8").replace(manifest.MADE_BY, "Sens Workbench 0.0.9"))
    assert cli.main(["verify", "o"]) == 0
    assert "made by Sens Workbench 0.0.9" in capsys.readouterr().out


INPUTS = {"sensitivity": ["m.json"], "trace": ["m.json", "r.csv"], "predict": ["f.json", "p.csv"]}


@pytest.mark.parametrize("name", INPUTS)
def test_a_result_without_manifest_is_computed_again_from_what_is_named(place, capsys, name):
    assert do(name) == 0
    for path in (place / "o").glob("*manifest.json"):
        path.unlink()
    words = ["verify", "o", *(f"--input={path}" for path in INPUTS[name])]
    assert cli.main(words) == 0, capsys.readouterr()
    said = capsys.readouterr().out
    assert "without manifest" in said and "comes out the same again" in said and said.rstrip().endswith("verified")
    assert cli.main([*words, "--input=m.json"]) == 2
    assert "with --input" in capsys.readouterr().err
    names = ("sensitivity.json", "trace.json", "predicted.csv")
    file = next(place / "o" / n for n in names if (place / "o" / n).exists())
    text = file.read_text(encoding="utf-8")
    digit = max(i for i, c in enumerate(text) if c in "12345678" and text[i - 1] == ".")
    write(file, text[:digit] + str(int(text[digit]) + 1) + text[digit + 1 :])
    assert cli.main(words) == 2
    assert f"differs: {file.name}: " in capsys.readouterr().out


@pytest.mark.parametrize(
    "options",
    [
        ["--grid", "2,3,2", "--signed", "--weights", "1,-0.5,0"],
        ["--quadrature", "3", "--squareness", "carried", "--angle-unit", "arcsec"],
        ["--at=-10,5,3", "--output", "orientation"],
        ["--low-discrepancy", "64"],
    ],
)
def test_the_settings_that_a_result_states_are_enough_to_repeat_it(place, capsys, options):
    assert cli.main(["sensitivity", "m.json", "--out", "o", *options]) == 0
    assert cli.main(["verify", "o/sensitivity.json", "--input", "m.json"]) == 0, capsys.readouterr()


def test_what_an_older_version_did_not_write_is_no_difference(place, capsys):
    do("sensitivity")
    data = json.loads((place / "o" / "sensitivity.json").read_text(encoding="utf-8"))
    for error in data["errors"]:
        del error["share"]
    write(place / "old.json", data)
    assert cli.main(["verify", "old.json", "--input", "m.json"]) == 0
    assert (
        f"note: old.json: {len(data['errors'])} entries that the older version did not write" in capsys.readouterr().out
    )


def test_a_result_that_does_not_say_how_it_was_made_is_refused(place, capsys):
    assert cli.main(["verify", "m.json", "--input", "m.json"]) == 2
    assert "says how it was made" in capsys.readouterr().err


@pytest.mark.parametrize("name", ["nothing", "old", "m.json"])
def test_a_result_without_manifest_is_refused(place, capsys, name):
    (place / "old").mkdir()
    assert cli.main(["verify", name]) == 2
    assert capsys.readouterr().err.count("\n") == 1


def test_verify_finishes_what_a_stopped_run_left(place, capsys):
    do("sensitivity")
    before = (place / "o" / "sensitivity.json").read_bytes()
    words = ["sensitivity", "m.json", "--at", "100,5,3", "--out", "o"]
    code = (
        "import os, sys\nfrom sensworkbench.formats import operations\n"
        "class Dies(operations.Operations):\n"
        "    def replace(self, source, target):\n"
        "        super().replace(source, target)\n"
        "        if str(target).endswith('report.html') and '.sens-' not in str(target): os._exit(137)\n"
        "from sensworkbench import cli\n"
        "with operations.replaced(Dies()): sys.exit(cli.main(sys.argv[1:]))\n"
    )
    environment = dict(os.environ, PYTHONPATH=str(ROOT))
    done = subprocess.run([sys.executable, "-c", code, *words], cwd=place, env=environment, timeout=120)
    assert done.returncode == 137 and file_sets.pending(place / "o")
    assert cli.main(["verify", "o"]) == 0, capsys.readouterr()
    assert not file_sets.pending(place / "o") and not hidden(place)
    assert (place / "o" / "sensitivity.json").read_bytes() != before


# -- batch -------------------------------------------------------------------------------------------------------------
LIST = """name,verb,machine,at,positions,to,signed
good,sensitivity,m.json,"1,2,3",,,yes
bad,sensitivity,bad.json,,,,
next,convert,f.json,,,isg,
last,predict,f.json,,p.csv,,
odd,predict,f.json,"1,2,3",p.csv,,
"""


def summary(folder) -> dict:
    with open(folder / "summary.csv", encoding="utf-8", newline="") as stream:
        return {row["name"]: row for row in csv.DictReader(stream)}


def test_a_bad_row_does_not_stop_the_rest(place, capsys):
    write(place / "list.csv", LIST)
    assert cli.main(["batch", "list.csv", "--out", "all"]) == 0
    rows = summary(place / "all")
    states = {n: r["status"] for n, r in rows.items()}
    assert states == {"good": "done", "bad": "refused", "next": "done", "last": "done", "odd": "refused"}
    assert "bad.json, line" in rows["bad"]["message"] and "no argument or option of predict" in rows["odd"]["message"]
    assert (place / "all" / "last" / "predicted.csv").exists() and (place / "all" / "good" / "report.html").exists()
    assert not (place / "all" / "bad").exists()
    assert cli.main(["verify", "all/good"]) == 0


def test_a_list_goes_on_where_it_was(place):
    write(place / "list.csv", LIST)
    assert cli.main(["batch", "list.csv", "--out", "all"]) == 0
    stamp = (place / "all" / "good" / "report.html").stat().st_mtime_ns
    write(place / "f.json", golden(fitted=FITTED, name="changed"))
    assert cli.main(["batch", "list.csv", "--out", "all", "--resume"]) == 0
    states = {n: r["status"] for n, r in summary(place / "all").items()}
    assert states == {"good": "as before", "bad": "refused", "next": "done", "last": "done", "odd": "refused"}
    assert (place / "all" / "good" / "report.html").stat().st_mtime_ns == stamp


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("verb,machine\nsensitivity,m.json\n", '"name" is missing'),
        ("name,machine\na,m.json\n", '"verb" is missing'),
        ("name,verb\n../a,sensitivity\n", "cannot name a folder"),
        ("name,verb\na,sensitivity\nA,plan\n", "stands twice"),
        ("name,verb\na,demo\n", "no verb of a list"),
        ("name,verb\n", "no rows"),
    ],
)
def test_a_list_that_is_none_is_refused(place, capsys, text, code):
    write(place / "list.csv", text)
    assert cli.main(["batch", "list.csv", "--out", "all"]) == 2
    assert code in capsys.readouterr().err and not (place / "all").exists()


# -- every verb, stopped or refused at every operation -----------------------------------------------------------------
def seen(folder: Path) -> dict[str, bytes]:
    files = (p for p in folder.rglob("*") if p.is_file()) if folder.exists() else ()
    return {str(p.relative_to(folder)): p.read_bytes() for p in files if ".sens-" not in str(p)}


def ready(name, place, monkeypatch):
    """Results of a verb as texts, to be written again and again without computing them."""
    assert do(name) == 0
    texts = {n: b for n, b in seen(place / "o").items() if not n.endswith("manifest.json")}
    single = Path(VERBS[name][1]).suffix != ""

    def again(folder, change: bytes):
        from sensworkbench.formats import files

        for_one = [n for n in texts if single]
        if single:
            with file_sets.staged_file(folder / for_one[0], name) as work:
                files.write_bytes(work, texts[for_one[0]] + change)
        else:
            with file_sets.staged(folder, name) as work:
                for n, data in texts.items():
                    files.write_bytes(work / n, data if n.endswith(".html") else data + change)

    return again


@pytest.mark.parametrize("name", VERBS)
@pytest.mark.parametrize("how", ["kill", "fail"])
def test_a_verb_stopped_at_every_operation_leaves_the_old_set_or_the_new(place, monkeypatch, name, how):
    again = ready(name, place, monkeypatch)
    counter = Injector(0, "")
    again(place / "count", b"")
    with operations.replaced(counter):
        again(place / "count", b"\n")
    new = seen(place / "count")
    for at in range(1, counter.count + 1):
        folder = place / f"{how}{at}"
        again(folder, b"")
        old = seen(folder)
        try:
            with operations.replaced(Injector(at, how)):
                again(folder, b"\n")
        except (Stopped, cli.program.Refused):
            pass
        file_sets.recover(folder)
        file_sets.recover(place)
        assert seen(folder) in (old, new), at
        assert not hidden(place), at


@pytest.mark.parametrize("how", ["kill", "fail"])
def test_a_corrected_program_elsewhere_and_the_folder_are_each_whole_and_verify_tells_of_two_runs(
    place, monkeypatch, capsys, how
):
    given("part")
    options = part_files.Options(offsets=("G54=0,0,0",), correct="better.nc")

    def made(coefficient):
        fitted = FITTED | {"C0Y": {"value": coefficient, "unit": "urad"}}
        job = part_files.read(machine_json.loads(json.dumps(golden(fitted=fitted))), "p.nc", options)
        return job, part_files.judged(job)

    sets, programs, texts = [made(12), made(40)], {}, {}
    for job, result in sets:
        programs[id(job)] = part_files.corrected(job)
        texts[id(job)] = part_files.files(job, result, "en", programs[id(job)][1])
    monkeypatch.setattr(part_files, "corrected", lambda job: programs[id(job)])
    monkeypatch.setattr(part_files, "files", lambda job, *_: texts[id(job)])

    def again(job, result):
        with provenance.running("part", ["part", "f.json", "p.nc", "--correct", "better.nc"]):
            provenance.note_input("f.json", programs[id(job)][0])
            part_files.write(place / "o", job, result)

    def found():
        folder = {k: v for k, v in seen(place).items() if k.startswith("o/")}
        return folder, {k: v for k, v in seen(place).items() if k.startswith("better.nc")}

    again(*sets[0])
    old = found()
    counter = Injector(0, "")
    with operations.replaced(counter):
        again(*sets[1])
    new, mixed = found(), 0
    assert old[0] != new[0] and old[1] != new[1]
    for at in range(1, counter.count + 1):
        again(*sets[0])
        try:
            with operations.replaced(Injector(at, how)):
                again(*sets[1])
        except (Stopped, cli.program.Refused):
            pass
        file_sets.recover(place / "o")
        file_sets.recover(place)
        folder, program = found()
        assert folder in (old[0], new[0]) and program in (old[1], new[1]), at
        assert not hidden(place), at
        if (folder, program) not in (old, new):
            mixed += 1
            capsys.readouterr()
            assert cli.main(["verify", "o", "--sums-only"]) == 2
            assert "changed: better.nc is of another run" in capsys.readouterr().out, at
    assert mixed  # two folders do not change as one: docs/formats.md


class Torn(Injector):
    """Stops in the middle of a line that is added."""

    def append(self, stream, data):
        if self.count + 1 == self.at:
            stream.write(data[: len(data) // 2])
            stream.flush()
        super().append(stream, data)


@pytest.mark.parametrize("begun", [0, 2])
@pytest.mark.parametrize("how", ["kill", "torn", "fail"])
def test_a_sweep_stopped_at_every_operation_leaves_the_old_table_or_one_that_goes_on(place, monkeypatch, how, begun):
    given("sweep")
    write(place / "other.json", SWEEP | {"outputs": ["rms"]})
    sweeps = [sweep_files.load(name) for name in ("other.json", "sweep.json")]
    rows = [list(run_sweep(s, FileJudge(sweep_files.machine_of, s.data, s.paths, s.outputs))) for s in sweeps]
    monkeypatch.setattr(
        sweep_files, "summary", lambda s, partial, language: {"report.html": f"<html>{len(s.outputs)}</html>"}
    )

    def again(folder, which):
        done = sweep_files.kept(folder, sweeps[which]) if which else []
        return sweep_run.write(folder, sweeps[which], done, rows[which][len(done) :])

    def start(folder):
        again(folder, 0)
        if begun:
            first = "".join(sweep_files.line(sweeps[1], *row) for row in rows[1][:begun])
            write(folder / sweep_files.PARTIAL, f"# {sweep_files.identity(sweeps[1])}\n{first}")
        return table(folder)

    def table(folder):
        return {name: data for name, data in seen(folder).items() if name != sweep_files.PARTIAL}

    counter = Injector(0, "")
    start(place / "count")
    with operations.replaced(counter):
        again(place / "count", 1)
    new = table(place / "count")
    assert not (place / "count" / sweep_files.PARTIAL).exists() and len(rows[1]) > begun
    for at in range(1, counter.count + 1):
        folder = place / f"at{at}"
        old = start(folder)
        assert old != new
        try:
            with operations.replaced((Torn if how == "torn" else Injector)(at, "kill" if how == "torn" else how)):
                again(folder, 1)
        except (Stopped, cli.program.Refused):
            pass
        file_sets.recover(folder)
        assert table(folder) in (old, new), at
        if (folder / sweep_files.PARTIAL).exists():
            assert len(sweep_files.kept(folder, sweeps[1])) >= begun, at
        else:
            assert not begun or table(folder) == new, at
        again(folder, 1)
        assert table(folder) == new and not (folder / sweep_files.PARTIAL).exists(), at


@pytest.mark.parametrize("text", ["", "#", "# 0123"])
def test_a_table_that_was_stopped_in_its_first_line_is_begun_again_or_is_of_another_sweep(place, capsys, text):
    given("sweep")
    (place / "o").mkdir()
    write(place / "o" / sweep_files.PARTIAL, text)
    other = not f"# {sweep_files.identity(sweep_files.load('sweep.json'))}".startswith(text)
    assert cli.main(["sweep", "sweep.json", "--resume", "--out=o"]) == (2 if other else 0)
    assert ("another sweep" in capsys.readouterr().err) == other


def test_a_sweep_without_space_is_a_refusal(place, capsys):
    given("sweep")
    for at in range(1, 12):
        with operations.replaced(Injector(at, "fail")):
            assert cli.main(["sweep", "sweep.json", "--out=o"]) == 2, at
        said = capsys.readouterr().err
        assert "no space left" in said and said.count("\n") == 1, said


def test_a_full_disk_is_a_refusal_with_nothing_changed(place, capsys):
    do("sensitivity")
    before = seen(place / "o")
    for at in range(1, 9):
        with operations.replaced(Injector(at, "fail")):
            status = cli.main(["sensitivity", "m.json", "--at", "0,0,0", "--out", "o"])
        assert (status, seen(place / "o")) == (2, before), at
        said = capsys.readouterr().err
        assert "no space left" in said and "o: " in said and files.MARK not in said, said
    assert not hidden(place)


@pytest.mark.skipif(not Path("/bin/sh").exists(), reason="needs a shell")
def test_a_folder_that_was_deleted_under_the_program_is_a_refusal(place):
    line = (
        f'mkdir gone; cd gone; rmdir ../gone; "{sys.executable}" -m sensworkbench sensitivity "{place}/m.json" --out o'
    )
    environment = dict(os.environ, PYTHONPATH=str(ROOT))
    done = subprocess.run(["sh", "-c", line], cwd=place, env=environment, capture_output=True, text=True, timeout=120)
    assert done.returncode == 2 and "defect" not in done.stderr, done.stderr


def test_a_noise_below_anything_that_can_be_measured_is_refused(place, capsys):
    assert cli.main(["plan", "m.json", "p.csv", "--noise", "1e-300", "--out", "o"]) == 2
    assert "--noise" in capsys.readouterr().err


KILLED_DEMO = """
import os, signal
from sensworkbench import cli, demo
demo._window_command = lambda: ["freecad"]
demo.subprocess.run = lambda *words, **options: os.kill(os.getpid(), signal.SIGKILL)
cli.main(["demo", "--out", "o/demo"])
"""


def test_a_killed_demonstration_leaves_nothing_that_the_next_command_does_not_remove(place):
    (place / "tmp").mkdir()
    environment = os.environ | {"PYTHONPATH": str(ROOT), "TMPDIR": str(place / "tmp")}
    (place / "o").mkdir()
    done = subprocess.run([sys.executable, "-c", KILLED_DEMO], cwd=place, env=environment, timeout=120)
    assert done.returncode == -9
    [left] = (place / "o").glob(".sens-*/sens-demo-*/Mod/SensWorkbench")
    assert left.is_symlink() and left.samefile(ROOT)
    assert cli.main(["sensitivity", "m.json", "--at", "10,-5,3", "--out", "o/demo"]) == 0
    assert {p.name for p in (place / "o").iterdir()} == {"demo"} and list((place / "tmp").iterdir()) == []
    assert (ROOT / "InitGui.py").is_file()  # the link went, not what it led to
