# SPDX-License-Identifier: LGPL-2.1-or-later
"""`allocate`: what it writes meets its target when judged again; bad costs and targets are refused in place."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import pytest

from sensworkbench import cli
from sensworkbench.core.refusal import Refused
from sensworkbench.formats import costs_csv, machine_json

EXAMPLES = Path(__file__).resolve().parents[2] / "resources" / "examples"
MACHINE, COSTS = EXAMPLES / "vertical_machining_centre.json", EXAMPLES / "costs.csv"


def allocated(tmp_path, target, machine=MACHINE, costs=COSTS):
    words = ["allocate", str(machine), "--target", target, "--costs", str(costs), "--out", str(tmp_path / "out")]
    return cli.main(words), tmp_path / "out"


def test_the_allocated_tolerances_meet_the_target_in_a_sensitivity_of_their_own(tmp_path):
    status, out = allocated(tmp_path, "rms=12")
    assert status == 0
    again = ["sensitivity", str(MACHINE), "--tolerances", str(out / "tolerances.csv"), "--out", str(tmp_path / "s")]
    assert cli.main(again) == 0
    found = json.loads((tmp_path / "s" / "sensitivity.json").read_text(encoding="utf-8"))
    assert found["mean_square_um2"] == pytest.approx(144, rel=1e-4) and found["mean_square_um2"] <= 144 * (1 + 1e-6)
    data = json.loads((out / "allocation.json").read_text(encoding="utf-8"))
    assert data["rms_um"]["after"] == pytest.approx(12, rel=1e-4) and 0 <= data["gap"] < 1e-6
    assert data["cost"] == pytest.approx(sum(e["cost"] for e in data["errors"]))
    assert {e["grade"] for e in data["errors"] if e["symbol"] in ("C0Y", "A0Z", "B0Z")} <= {"SP", "P", "H", "C"}


def test_the_worst_place_and_the_mean_square_are_targets_too(tmp_path):
    status, out = allocated(tmp_path, "worst=20")
    assert status == 0
    assert json.loads((out / "allocation.json").read_text(encoding="utf-8"))["worst_rms_um"]["after"] <= 20 * (1 + 1e-9)
    assert allocated(tmp_path, "mean_square=144")[0] == 0


def test_the_front_falls_and_never_lies_below_its_bound(tmp_path):
    _, out = allocated(tmp_path, "rms=12")
    with (out / "front.csv").open(encoding="utf-8", newline="") as stream:
        rows = [{k: float(v) for k, v in row.items()} for row in csv.DictReader(stream)]
    assert len(rows) >= 10 and all(a["cost"] > b["cost"] for a, b in zip(rows, rows[1:]))
    assert all(r["bound"] <= r["cost"] * (1 + 1e-9) for r in rows)


@pytest.mark.parametrize(
    "language, word", [("en", "Tolerance allocation"), ("de", "Toleranzzuteilung"), ("ko", "공차 배분")]
)
def test_the_page_speaks_three_languages(tmp_path, language, word):
    words = ["allocate", str(MACHINE), "--target", "rms=12", "--costs", str(COSTS), "--out", str(tmp_path / "out")]
    assert cli.main([*words, "--language", language]) == 0
    assert word in (tmp_path / "out" / "report.html").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    "target, code",
    [
        ("rms=2", "out of reach"),
        ("rms=0.01", "have no cost"),
        ("rms", "not a target"),
        ("speed=3", "unknown target"),
        ("rms=-1", "cannot be met"),
    ],
)
def test_targets_that_cannot_be_are_refused(tmp_path, capsys, target, code):
    status, out = allocated(tmp_path, target)
    assert status == 2 and code in capsys.readouterr().err and not out.exists()


@pytest.mark.parametrize(
    "text, code",
    [
        ("symbol,kind,c,k,lower,upper\nEXX,power,1,1,0,5\n", "cost-power-invalid"),
        ("symbol,kind,c,k,lower,upper\nEXX,power,x,1,1,5\n", "cost-not-a-number"),
        ("symbol,kind,c,k,lower,upper\nEXX,power,nan,1,1,5\n", "cost-not-a-number"),
        ("symbol,kind,c,k,lower,upper\nEXX,steps,1,1,1,5\n", "cost-kind"),
        ("symbol,kind,c,k,lower,upper\nEXQ,power,1,1,1,5\n", "component-unknown"),
        ("symbol,kind,c,k,lower,upper\nEXX,power,1,1,1,5\nEXX,power,1,1,1,5\n", "cost-twice"),
        ("symbol,kind,grade,w,cost\nEXX,grades,P,0,5\n", "cost-grades-invalid"),
        ("symbol,kind,price\nEXX,power,5\n", "cost-column"),
        ("symbol,c\nEXX,5\n", "cost-column-missing"),
        ("symbol,kind,c,k,lower,upper\n", "cost-none"),
    ],
)
def test_bad_costs_are_refused_with_their_place(tmp_path, text, code):
    path = tmp_path / "costs.csv"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(Refused) as refused:
        costs_csv.load(path, machine_json.load(MACHINE))
    assert refused.value.code == code and "costs.csv" in refused.value.where


def test_a_rotary_error_can_be_bought_too(tmp_path):
    costs = tmp_path / "costs.csv"
    costs.write_text("symbol,kind,c,k,lower,upper\nA0C,power,100,1,1,30\nX0C,power,50,1,1,20\n", encoding="utf-8")
    status, out = allocated(tmp_path, "rms=21", EXAMPLES / "trunnion.json", costs)
    assert status == 0 and "X0C" in (out / "tolerances.csv").read_text(encoding="utf-8")
