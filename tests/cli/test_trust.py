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
from sensworkbench.formats import file_sets, files, manifest, operations
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
}
SWEEP = {
    "machine": "m.json",
    "parameters": [{"path": "tool_point.2", "values": [-150, -100]}],
    "design": "full",
    "outputs": ["rms", "share.X"],
}


def given(name) -> None:
    """The files that a verb reads beside those of `place`."""
    if name == "import-errors":
        write(Path("isg.csv"), "X EXX\n-300 0\n-100 0.001\n100 0.002\n200 0.001\n300 0.002\n")
    if name == "import-machine":
        write(Path("mill.fcm"), mill())
    if name == "trace":
        rows = Path("p.csv").read_text(encoding="utf-8").splitlines()[1:]
        e = np.random.default_rng(3).normal(0, 1, (len(rows), 3))
        table = "".join(f"{row},{a:.3f},{b:.3f},{c:.3f}\n" for row, (a, b, c) in zip(rows, e))
        write(Path("r.csv"), "x_mm,y_mm,z_mm,ex_um,ey_um,ez_um\n" + table)
    if name == "allocate":
        rows = "".join(f"{s},power,10,1,0.5,40\n" for s in ("EXX", "EAX", "EBX", "C0Y"))
        write(Path("costs.csv"), "symbol,kind,c,k,lower,upper\n" + rows)
    if name == "sweep":
        write(Path("sweep.json"), SWEEP)


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
