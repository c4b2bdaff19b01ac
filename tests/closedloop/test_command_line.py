# SPDX-License-Identifier: LGPL-2.1-or-later
"""`trace` and `predict` as a user runs them: processes, files of the specification, exit status."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from tests.simulator import make_case, write_case

ROOT = Path(__file__).resolve().parents[2]
TOP = {
    "format", "version", "verdict", "floor", "effects", "error", "noise", "identifiability", "depends_on",
    "not_testable", "not_identifiable", "next_measurements", "sensitivity_shift",
}  # fmt: skip


def command(*words) -> subprocess.CompletedProcess:
    """`python -m sensworkbench WORDS`."""
    variables = dict(os.environ, PYTHONPATH=str(ROOT), OMP_NUM_THREADS="1")
    line = [sys.executable, "-m", "sensworkbench", *map(str, words)]
    return subprocess.run(line, env=variables, capture_output=True, text=True, timeout=300, encoding="utf-8")


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    """A backlash with rivals (every body's EX moves alike), its files, its trace and its prediction."""
    folder = tmp_path_factory.mktemp("case")
    case = make_case(20061, "backlash", 1, "XYFZ", "random", count=300, extras=False)
    write_case(folder, case)
    run = command("trace", folder / "machine.json", folder / "measured.csv", "--out", folder / "out")
    assert (run.returncode, run.stderr) == (0, "")
    assert run.stdout.splitlines()[0] == "explained"
    words = (folder / "out" / "machine_augmented.json", folder / "positions.csv", "--out", folder / "predicted.csv")
    run = command("predict", *words)
    assert (run.returncode, run.stderr) == (0, "")
    return folder


@pytest.fixture(scope="module")
def report(folder) -> dict:
    return json.loads((folder / "out" / "trace.json").read_text(encoding="utf-8"))


def number(value) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool) and np.isfinite(value)


def test_the_top_of_trace_json(report):
    assert set(report) >= TOP
    assert (report["format"], report["version"], report["floor"]) == ("sens-trace", 1, 0.2)
    assert report["verdict"] in ("nothing_to_explain", "explained", "partly_explained", "unexplained")


def test_an_effect_in_trace_json(report):
    assert report["effects"]
    for effect in report["effects"]:
        assert all(isinstance(effect[k], str) and effect[k] for k in ("name", "component", "driver", "shape"))
        assert number(effect["amplitude_um"]) and effect["amplitude_um"] > 0
        assert 0 < effect["p_familywise"] < 0.01 and 0.8 <= effect["selection_frequency"] <= 1
        for key, entry in effect["parameters"].items():
            assert "value" in entry, key
        coefficient = effect["parameters"]["coefficient"]
        assert coefficient["unit"] in ("um", "urad") and 0 < coefficient["u"] < abs(coefficient["value"])
        assert effect["rivals"]
        for rival in effect["rivals"]:
            assert set(rival) == {"component", "driver", "shape", "why", "why_message"}
            assert all(isinstance(v, str) and v for k, v in rival.items() if k != "why_message")


def test_the_errors_before_and_after_in_trace_json(report):
    for name in ("uncorrected", "declared", "augmented"):
        for part in ("in_sample", "held_out"):
            assert all(number(report["error"][name][part][k]) for k in ("rms_um", "p95_um", "max_um"))


def test_the_rest_of_trace_json(report):
    assert set(report["noise"]) >= {"stated_um", "pure_error_um", "residual_um"}
    assert report["noise"]["stated_um"] is None and number(report["noise"]["residual_um"])
    known = report["identifiability"]
    assert isinstance(known["columns"], int) and isinstance(known["rank"], int) and known["rank"] < known["columns"]
    assert known["null_space"] and all(isinstance(w, str) for w in known["null_space"])
    assert report["depends_on"] and all(set(d) == {"column", "p"} for d in report["depends_on"])
    assert all(set(e) == {"effect", "effect_message", "needs"} for e in report["not_testable"])
    assert all(isinstance(w, str) for w in report["not_identifiable"])
    assert report["next_measurements"]
    for entry in report["next_measurements"]:
        assert set(entry) == {"separates", "separates_messages", "do", "do_message", "predicted_difference_um"}
        assert len(entry["separates"]) >= 1 and entry["do"] and number(entry["predicted_difference_um"])
    assert isinstance(report["sensitivity_shift"], list)


def test_the_files_are_strict_json_with_no_nan_in_them(folder):
    def refuse(word):
        raise ValueError(word)

    for name in ("trace.json", "machine_augmented.json"):
        json.loads((folder / "out" / name).read_text(encoding="utf-8"), parse_constant=refuse)


def test_the_augmented_machine_is_the_input_with_fitted_errors_and_effects(folder, report):
    before = json.loads((folder / "machine.json").read_text(encoding="utf-8"))
    after = json.loads((folder / "out" / "machine_augmented.json").read_text(encoding="utf-8"))
    for key in ("format", "version", "name", "workpiece_chain", "tool_chain", "tool_point"):
        assert after[key] == before[key]
    fitted = after["fitted"]
    assert set(fitted["EXX"]) >= {"basis", "domain", "coefficients", "unit", "u"}
    assert fitted["EXX"]["basis"] == "legendre" and fitted["EXX"]["coefficients"][0] == 0
    assert set(fitted["C0Y"]) >= {"value", "unit", "u"}
    assert set(fitted["alignment"]) == {"EXW", "EYW", "EZW", "EAW", "EBW", "ECW"}
    [effect] = after["effects"]
    assert set(effect) == {"name", "component", "driver", "shape", "parameters", "enabled"}
    assert [effect[k] for k in ("name", "component", "driver", "shape")] == [
        report["effects"][0][k] for k in ("name", "component", "driver", "shape")
    ]
    assert effect["enabled"] is True


def test_the_prediction_keeps_the_rows_and_comes_within_the_noise(folder):
    given = (folder / "positions.csv").read_text(encoding="utf-8").splitlines()
    lines = [r for r in (folder / "predicted.csv").read_text(encoding="utf-8").splitlines() if not r.startswith("#")]
    head = lines[0].split(",")
    assert head[: len(given[0].split(","))] == given[0].split(",")
    assert head[len(given[0].split(",")) :] == [
        *("ex_um", "ey_um", "ez_um"),
        *("u_ex_um", "u_ey_um", "u_ez_um"),
        "extrapolated",
    ]
    assert len(lines) == len(given)
    table = np.array([[float(v) for v in r.split(",")] for r in lines[1:]])
    truth = np.loadtxt(folder / "positions_truth_um.csv", delimiter=",")
    known = json.loads((folder / "truth.json").read_text(encoding="utf-8"))
    error, u = table[:, -7:-4], table[:, -4:-1]
    off = np.sqrt(((error - truth) ** 2).sum(axis=1).mean())
    assert off <= 1.2 * known["fresh_bound_um"]
    assert 0.4 < off / np.sqrt((u**2).sum(axis=1).mean()) < 2.5  # one machine: its parameters are off together
    assert set(table[:, -1]) <= {0.0, 1.0}


def refused(run, *words) -> bool:
    """Exit status 2, one line on stderr that holds the words, no traceback."""
    assert run.returncode == 2, run.stderr
    assert "Traceback" not in run.stderr and run.stderr.strip().count("\n") == 0
    return all(w in run.stderr for w in words)


def spoil(folder, tmp_path, line: int, column: str, value: str) -> Path:
    """measured.csv with one cell replaced."""
    rows = [r.split(",") for r in (folder / "measured.csv").read_text(encoding="utf-8").splitlines()]
    rows[line - 1][rows[0].index(column)] = value
    path = tmp_path / "spoiled.csv"
    path.write_text("\n".join(",".join(r) for r in rows) + "\n", encoding="utf-8")
    return path


@pytest.mark.parametrize(
    ("line", "column", "value", "words"),
    [
        (17, "ex_um", "abc", ("spoiled.csv", "17", "ex_um")),
        (5, "y_mm", "", ("spoiled.csv", "5", "y_mm")),
        (1, "x_mm", "x_furlong", ("spoiled.csv", "furlong")),
        (1, "x_mm", "place", ("spoiled.csv", "x_mm")),
    ],
)
def test_what_cannot_be_read_is_refused_with_its_place(folder, tmp_path, line, column, value, words):
    bad = spoil(folder, tmp_path, line, column, value)
    run = command("trace", folder / "machine.json", bad, "--out", tmp_path / "out")
    assert refused(run, *words)
    assert not (tmp_path / "out").exists()


def test_a_missing_file_and_a_machine_that_is_none_are_refused(folder, tmp_path):
    assert refused(command("trace", folder / "machine.json", tmp_path / "no.csv", "--out", tmp_path / "o"), "no.csv")
    assert refused(command("trace", tmp_path / "no.json", folder / "measured.csv", "--out", tmp_path / "o"), "no.json")
    (tmp_path / "m.json").write_text('{"format": "sens-machine", "version": 1, "nmae": "x"}', encoding="utf-8")
    run = command("trace", tmp_path / "m.json", folder / "measured.csv", "--out", tmp_path / "o")
    assert refused(run, "m.json")
    assert not (tmp_path / "o").exists()


def test_too_few_readings_are_refused(folder, tmp_path):
    rows = (folder / "measured.csv").read_text(encoding="utf-8").splitlines()[:12]
    (tmp_path / "few.csv").write_text("\n".join(rows) + "\n", encoding="utf-8")
    run = command("trace", folder / "machine.json", tmp_path / "few.csv", "--out", tmp_path / "out")
    assert refused(run, "readings")
    assert not (tmp_path / "out").exists()


def test_the_alignment_of_the_command_line_replaces_that_of_the_header(folder, tmp_path):
    rows = (folder / "measured.csv").read_text(encoding="utf-8").splitlines()
    at = next(i for i, row in enumerate(rows) if not row.startswith("#"))
    body = [f"{row},{1 + i // 100}" for i, row in enumerate(rows[at + 1 :])]
    text = ["# alignment: once", *rows[:at], rows[at] + ",run", *body]
    (tmp_path / "measured.csv").write_text("\n".join(text) + "\n", encoding="utf-8")
    for option, said in ((), "once"), (("--alignment", "offset-per-run"), "offset per run"):
        words = (folder / "machine.json", tmp_path / "measured.csv", "--out", tmp_path / "out", *option)
        assert command("trace", *words).returncode == 0
        assert json.loads((tmp_path / "out" / "trace.json").read_text(encoding="utf-8"))["alignment"] == said


def test_an_alignment_per_run_of_readings_without_runs_is_refused(folder, tmp_path):
    words = (folder / "machine.json", folder / "measured.csv", "--out", tmp_path / "out", "--alignment", "per-run")
    run = command("trace", *words)
    assert run.returncode == 2 and "no column run" in run.stderr and not (tmp_path / "out").exists()


def test_a_prediction_without_the_effect_s_column_is_refused(folder, report, tmp_path):
    column = report["effects"][0]["driver"]
    rows = [r.split(",") for r in (folder / "positions.csv").read_text(encoding="utf-8").splitlines()]
    gone = rows[0].index(column)
    (tmp_path / "p.csv").write_text(
        "\n".join(",".join(v for i, v in enumerate(r) if i != gone) for r in rows) + "\n", encoding="utf-8"
    )
    machine = folder / "out" / "machine_augmented.json"
    run = command("predict", machine, tmp_path / "p.csv", "--out", tmp_path / "predicted.csv")
    assert refused(run, column, "p.csv")
    assert not (tmp_path / "predicted.csv").exists()


def test_wrong_words_on_the_command_line_are_refused(tmp_path):
    run = command("trace")
    assert run.returncode == 2 and "Traceback" not in run.stderr
