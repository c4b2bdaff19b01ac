# SPDX-License-Identifier: LGPL-2.1-or-later
"""The verbs on machines of other joints: five axes, a lathe, a rotary table alone."""

from __future__ import annotations

import csv
import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from sensworkbench import cli
from sensworkbench.core.fitted import Constant, FittedModel, Series
from sensworkbench.core.synthesis import omega
from sensworkbench.formats import machine_json

EXAMPLES = Path(__file__).resolve().parents[2] / "resources" / "examples"
OTHERS = ("trunnion", "lathe", "rotary_table")


def joints_of(name: str):
    return machine_json.load(EXAMPLES / f"{name}.json").joints


def middle(joints) -> list[float]:
    """A position within the travel, in the units of the file, not the middle itself."""
    return [j.to_shown(0.6 * j.span[0] + 0.4 * j.span[1]) for j in joints]


def result(folder: Path) -> dict:
    return json.loads((folder / "sensitivity.json").read_text(encoding="utf-8"))


@pytest.mark.parametrize("name", OTHERS)
def test_sensitivity_takes_one_value_per_joint_and_writes_it_back(name, tmp_path):
    joints = joints_of(name)
    position = middle(joints)
    words = ["sensitivity", str(EXAMPLES / f"{name}.json"), "--out", str(tmp_path), "--at"]
    assert cli.main([*words, ",".join(f"{v:.6f}" for v in position)]) == 0
    data = result(tmp_path)
    assert data["points"] == pytest.approx(position, abs=1e-6) and data["aggregate"] == "at"
    assert [j["name"] for j in data["settings"]["joints"]] == [j.name for j in joints]
    assert [j["unit"] for j in data["settings"]["joints"]] == [j.unit for j in joints]
    rows = list(csv.DictReader((tmp_path / "sensitivity.csv").open(encoding="utf-8", newline="")))
    assert [r["symbol"] for r in rows] == [e["symbol"] for e in data["errors"]]
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert all(f"{j.name} {v:g}" in page for j, v in zip(joints, data["points"]))


@pytest.mark.parametrize("name", OTHERS)
def test_the_indices_at_a_position_are_those_of_sampled_errors(name, tmp_path):
    machine = machine_json.load(EXAMPLES / f"{name}.json")
    position = middle(machine.joints)
    words = ["sensitivity", str(EXAMPLES / f"{name}.json"), "--out", str(tmp_path), "--at"]
    assert cli.main([*words, ",".join(f"{v:.9f}" for v in position)]) == 0
    q = np.array([[j.from_shown(v) for j, v in zip(machine.joints, position)]])
    laws = machine.all_tolerances
    random = np.random.default_rng(3)
    a, b = (np.array([random.uniform(t.lower, t.upper, 100_000) for t in laws.values()]) for _ in "ab")
    matrix = omega(machine, list(laws), q)[0]
    y = lambda x: ((matrix @ x) ** 2).sum(axis=0)  # noqa: E731
    assert all(t.distribution == "uniform" for t in laws.values())
    totals = {e["symbol"]: e["total"] for e in result(tmp_path)["errors"]}
    for i, symbol in enumerate(laws):
        mixed = a.copy()
        mixed[i] = b[i]
        assert totals[symbol] == pytest.approx(0.5 * ((y(a) - y(mixed)) ** 2).mean() / y(a).var(), abs=0.02), symbol


@pytest.mark.parametrize("name", OTHERS)
def test_means_over_the_travel_agree_whichever_way_they_are_taken(name, tmp_path):
    totals = {}
    count = len(joints_of(name))
    order = 16 if count == 1 else 5  # over a whole turn
    for key, option in {
        "quadrature": ["--quadrature", str(order)],
        "low_discrepancy": ["--low-discrepancy", "8192"],
    }.items():
        out = tmp_path / key
        assert cli.main(["sensitivity", str(EXAMPLES / f"{name}.json"), "--out", str(out), *option]) == 0
        data = result(out)
        assert data["aggregate"] == key and 0 <= data["estimated_error"] < 0.01
        assert data["points"] == ([order] * count if key == "quadrature" else 8192)
        totals[key] = {e["symbol"]: e["total"] for e in data["errors"]}
    for symbol, total in totals["quadrature"].items():
        assert totals["low_discrepancy"][symbol] == pytest.approx(total, abs=0.01), symbol


def test_a_position_of_another_length_is_refused_with_the_names(tmp_path, capsys):
    words = ["sensitivity", str(EXAMPLES / "trunnion.json"), "--out", str(tmp_path / "o"), "--at", "0,0,0"]
    assert cli.main(words) == 2
    said = capsys.readouterr().err
    assert all(j.name in said for j in joints_of("trunnion")) and not (tmp_path / "o").exists()


@pytest.mark.parametrize("name", OTHERS)
def test_predict_reads_a_column_per_joint_and_answers_by_omega(name, tmp_path):
    machine = machine_json.load(EXAMPLES / f"{name}.json")
    joint = machine.joints[-1]
    low, high = (joint.to_shown(v) for v in joint.span)
    symbol, line = f"EX{joint.name}", machine.line_symbols[-1]
    series = {symbol: Series((low, high), (0.0, 0.004))}
    machine = replace(machine, fitted=FittedModel(series=series, constants={line: Constant(3e-6)}))
    machine_json.save(machine, tmp_path / "m.json")
    position = middle(machine.joints)
    names = [f"{j.column}_{j.unit}" for j in machine.joints]
    table = ",".join(names) + "\n" + ",".join(f"{v:.9f}" for v in position) + "\n"
    (tmp_path / "p.csv").write_text(table, encoding="utf-8")
    words = ["predict", str(tmp_path / "m.json"), str(tmp_path / "p.csv"), "--out", str(tmp_path / "predicted.csv")]
    assert cli.main(words) == 0
    row = next(csv.DictReader((tmp_path / "predicted.csv").open(encoding="utf-8", newline="")))
    q = np.array([[j.from_shown(v) for j, v in zip(machine.joints, position)]])
    value = 0.004 * (2 * position[-1] - low - high) / (high - low)
    wanted = omega(machine, [symbol, line], q)[0] @ [value, 3e-6] * 1e3
    assert [float(row[f"e{a}_um"]) for a in "xyz"] == pytest.approx(wanted, abs=2e-6)
    (tmp_path / "p.csv").write_text(table.replace(names[-1], "other_s"), encoding="utf-8")
    assert cli.main(words) == 2


@pytest.mark.parametrize("language", ["de", "ko"])
@pytest.mark.parametrize("name", ["trunnion", "vertical_machining_centre"])
def test_the_report_speaks_the_language_that_is_asked_for(name, language, tmp_path):
    import re

    texts = []
    for code in ("en", language):
        words = ["sensitivity", str(EXAMPLES / f"{name}.json"), "--quadrature", "3", "--language", code]
        assert cli.main([*words, "--out", str(tmp_path / code)]) == 0
        page = (tmp_path / code / "report.html").read_text(encoding="utf-8")
        assert f'<html lang="{code}">' in page
        page = re.sub(r"<style>.*?</style>|<svg.*?</svg>", "", page, flags=re.DOTALL)
        texts.append({t.strip() for t in re.findall(r">([^<]+)<", page) if len(t.split()) > 3})
    same = texts[0] & texts[1]
    assert not [t for t in same if not re.search(r"[Σ=]|\d", t)], same
    one, other = (result(tmp_path / code) for code in ("en", language))
    assert one == other  # files for programs stay English
