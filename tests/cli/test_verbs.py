# SPDX-License-Identifier: LGPL-2.1-or-later
"""The verbs as a registry, and how the program ends: interrupted, without a reader, with a defect."""

from __future__ import annotations

import importlib
import os
import re
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from sensworkbench import cli
from sensworkbench.cli import program, verbs

ROOT = Path(__file__).resolve().parents[2]
MACHINE = ROOT / "resources" / "examples" / "vertical_machining_centre.json"

GREET = '''"""`greet NAME`."""
HELP = "says a friendly word"
FILES = "nothing"


def add(parser):
    parser.add_argument("name")


def run(arguments):
    print("good morning", arguments.name)
    return 0
'''


@pytest.fixture
def greet(tmp_path, monkeypatch):
    """A throw-away verb: one more module in the package of verbs, and nothing else."""
    (tmp_path / "greet_twice.py").write_text(GREET, encoding="utf-8")
    monkeypatch.setattr(verbs, "__path__", [*verbs.__path__, str(tmp_path)])
    importlib.invalidate_caches()
    yield "greet-twice"
    sys.modules.pop("sensworkbench.cli.verbs.greet_twice", None)


def test_a_new_verb_is_one_module(greet, capsys):
    assert greet in verbs.names()
    assert cli.main([greet, "Ada"]) == 0
    assert capsys.readouterr().out == "good morning Ada\n"
    assert cli.main(["--help"]) == 0
    assert "says a friendly word" in capsys.readouterr().out
    assert cli.main([greet, "Ada", "--loud"]) == 2
    assert f"| [`{greet}`](#{greet}) | says a friendly word | nothing |" in program.table()


def test_the_table_of_the_documentation_is_the_registry():
    text = (ROOT / "docs" / "command-line.md").read_text(encoding="utf-8")
    assert program.table() in text, "run tools/tables.py"


def test_every_verb_says_what_it_is():
    assert len(verbs.names()) >= 8
    for name in verbs.names():
        module = verbs.load(name)
        assert module.HELP and module.FILES and callable(module.add) and callable(module.run), name
        assert re.match(f"`{name} ", module.__doc__), name


def test_help_needs_no_numpy():
    code = "import sys; sys.modules['numpy'] = None; from sensworkbench.cli import main; sys.exit(main(['--help']))"
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, timeout=60)
    assert done.returncode == 0 and "sensitivity" in done.stdout, done.stderr


# -- ends --------------------------------------------------------------------------------------------------------------
def test_an_interrupted_run_ends_with_130_and_one_line(monkeypatch, capsys, tmp_path):
    def interrupted(arguments):
        raise KeyboardInterrupt

    monkeypatch.setattr(verbs.load("sensitivity"), "run", interrupted)
    assert cli.main(["sensitivity", str(MACHINE), "--out", str(tmp_path / "o")]) == 130
    assert capsys.readouterr().err.count("\n") == 1


@pytest.mark.skipif(os.name != "posix", reason="signals of POSIX")
def test_a_signal_at_any_instant_ends_without_a_traceback(tmp_path):
    for delay in (0.02, 0.06, 0.1, 0.2, 0.4):
        line = [sys.executable, "-m", "sensworkbench", "sensitivity", str(MACHINE), "--out", str(tmp_path / "o")]
        process = subprocess.Popen(line, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        try:
            process.wait(delay)
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGINT)
        error = process.communicate(timeout=60)[1]
        started = "site" not in error and "runpy" not in error  # Python itself, before the program
        assert not started or process.returncode in (0, 130, -signal.SIGINT), error
        assert not started or "sensworkbench" not in error, error


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs /dev/full")
def test_nobody_needs_to_read_what_is_said(tmp_path):
    line = f'"{sys.executable}" -m sensworkbench sensitivity "{MACHINE}" --at 0,0,0 --out "{tmp_path}/o"'
    for end in (">&-", "> /dev/full", "| true"):
        done = subprocess.run(
            ["bash", "-o", "pipefail", "-c", f"{line} {end}"], cwd=ROOT, capture_output=True, text=True, timeout=60
        )
        assert (done.returncode, done.stderr) == (0, ""), end
        assert (tmp_path / "o" / "sensitivity.json").exists()


def test_a_value_may_begin_with_a_minus_sign_after_any_option():
    words = program.parser().parse_args(program._joined(["sensitivity", "m", "--out", "o", "--weights", "-1,0,.5"]))
    assert words.weights == (-1, 0, 0.5)
    assert program._joined(["predict", "m", "--no-alignment", "--out", "x"])[2:] == ["--no-alignment", "--out", "x"]


@pytest.mark.parametrize("value", ["nan,0,0", "inf,0,0", "0,-inf,0"])
@pytest.mark.parametrize("option", [("sensitivity", "--at"), ("convert", "--through"), ("sensitivity", "--weights")])
def test_positions_and_weights_are_finite(option, value, tmp_path, capsys):
    words = [option[0], str(MACHINE), "--out", str(tmp_path / "o"), option[1], value]
    assert cli.main(words + (["--to", "siemens"] if option[0] == "convert" else [])) == 2
    assert "finite" in capsys.readouterr().err
    assert not (tmp_path / "o").exists()
