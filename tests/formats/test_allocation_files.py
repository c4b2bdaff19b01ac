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

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "resources" / "examples"
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


# -- the catalogue of grades -------------------------------------------------------------------------------------------
def test_the_catalogue_offers_grades_for_the_travel_of_each_axis_and_says_where_they_are_printed():
    machine = machine_json.load(MACHINE)
    costs = costs_csv.load("catalogue", machine)
    assert set(costs) == {"EYX", "EZX", "EXY", "EZY", "EXZ", "EYZ", "EXX", "EYY", "EZZ"}
    travel = {j.name: float(j.travel[1] - j.travel[0]) for j in machine.joints}
    guide = {g.name: g for g in costs["EYX"].grades}
    assert set(guide) == {"guide C", "guide H", "guide P", "guide SP", "guide UP"}
    # 0.02 mm per metre for class C: half of it to each side
    assert guide["guide C"].w == pytest.approx(0.010 * travel["X"] / 1000)
    # without prices a grade costs as many times what the present tolerance costs as it is narrower
    assert guide["guide C"].cost == pytest.approx(0.005 / guide["guide C"].w)
    screw = {g.name: g.w for g in costs["EXX"].grades}
    assert screw["scale LIP 200 ±1"] == pytest.approx(0.001)
    order = [screw[f"screw {n}"] for n in ("C0", "C1", "C3", "C5", "C7")]
    assert order == sorted(order) and order[2] == pytest.approx(0.012 * travel["X"] / 300)
    with (ROOT / "resources" / "catalogue" / "grades.csv").open(encoding="utf-8") as stream:
        rows = list(csv.DictReader(line for line in stream if not line.startswith("#")))
    assert rows and all(len(r["source"]) > 20 and r["cost"] == "" for r in rows)


def test_prices_filled_into_a_copy_are_taken_and_other_errors_come_from_a_second_file(tmp_path, capsys):
    text = (ROOT / "resources" / "catalogue" / "grades.csv").read_text(encoding="utf-8")
    copy = tmp_path / "grades.csv"
    copy.write_text(text.replace(",,,\"", ",,50,\"").replace(
        "1000,,\"", "1000,80,\"").replace("300,,\"", "300,20,\""), encoding="utf-8")  # fmt: skip
    machine = machine_json.load(MACHINE)
    assert {g.cost for c in costs_csv.load(copy, machine).values() for g in c.grades} == {20.0, 50.0, 80.0}
    assert not costs_csv.unpriced(copy, machine) and costs_csv.unpriced("catalogue", machine)
    words = ["allocate", str(MACHINE), "--target", "rms=14", "--out", str(tmp_path / "out")]
    assert cli.main([*words, "--costs", str(copy), "--costs", str(COSTS)]) == 0
    assert "no money" not in capsys.readouterr().out
    data = json.loads((tmp_path / "out" / "allocation.json").read_text(encoding="utf-8"))
    found = {e["symbol"]: e["grade"] for e in data["errors"]}
    assert found["EYX"].startswith("guide") and found["EXX"] and found["EAX"] is None and found["C0Y"] in "SPHC"
    words[3] = "rms=18.5"
    assert cli.main([*words, "--costs", "catalogue"]) == 0 and "no money" in capsys.readouterr().out


@pytest.mark.parametrize(
    "row, code",
    [
        ("rope,C,0,100,6,,,x", "cost-kind"),
        ("guide,C,0,100,0,,,x", "cost-grades-invalid"),
        ("guide,C,100,50,6,,,x", "cost-grades-invalid"),
        ("guide,C,0,100,six,,,x", "cost-not-a-number"),
        ("guide,C,0,1,6,,,x", "cost-none"),
    ],
)
def test_a_bad_catalogue_is_refused_with_its_place(tmp_path, row, code):
    path = tmp_path / "grades.csv"
    path.write_text(f"family,grade,from_mm,to_mm,w_um,per_mm,cost,source\n{row}\n", encoding="utf-8")
    with pytest.raises(Refused) as refused:
        costs_csv.load(path, machine_json.load(MACHINE))
    assert refused.value.code == code and "grades.csv" in refused.value.where
