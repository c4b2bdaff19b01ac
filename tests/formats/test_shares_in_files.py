# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shares and sources reach the files of a sensitivity study: JSON, table and page."""

from __future__ import annotations

import csv
import json
from dataclasses import replace
from pathlib import Path

import pytest

from sensworkbench import cli
from sensworkbench.core.distributions import Tolerance
from sensworkbench.core.sources import Source
from sensworkbench.formats import machine_json

EXAMPLE = Path(__file__).resolve().parents[2] / "resources" / "examples" / "vertical_machining_centre.json"


@pytest.fixture
def written(tmp_path):
    rail = Source("rail", Tolerance(-1.0, 1.0), {"EXX": 4e-3, "EBX": 1.5e-5})
    room = Source("room", Tolerance(-2.0, 2.0), {"EXX": 1e-3, "EYY": 1.5e-3})
    machine = machine_json.load(EXAMPLE)
    own = {s: t for s, t in machine.tolerances.items() if s not in ("EXX", "EBX", "EYY")}
    machine = replace(machine, sources=(rail, room), tolerances=own)
    machine_json.save(machine, tmp_path / "m.json")
    assert cli.main(["sensitivity", str(tmp_path / "m.json"), "--grid", "2", "--out", str(tmp_path / "out")]) == 0
    return tmp_path / "out"


def test_shares_add_up_to_one_in_every_file(written):
    data = json.loads((written / "sensitivity.json").read_text(encoding="utf-8"))
    for table in ("errors", "components"):
        assert sum(row["share"] for row in data[table]) == pytest.approx(1, abs=1e-12)
    with (written / "sensitivity.csv").open(encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert sum(float(row["share"]) for row in rows) == pytest.approx(1, abs=1e-9)
    assert "<th" in (page := (written / "report.html").read_text(encoding="utf-8")) and ">Share<" in page


def test_a_source_is_a_row_of_its_own_and_what_follows_it_is_none(written):
    data = json.loads((written / "sensitivity.json").read_text(encoding="utf-8"))
    rows = {row["symbol"]: row for row in data["errors"]}
    assert (rows["rail"]["owner"], rows["rail"]["unit"], rows["rail"]["upper"]) == ("X", "1", 1.0)
    assert rows["room"]["owner"] == "room" and {"EXX", "EYY", "EBX"}.isdisjoint(rows)
    assert {c["body"] for c in data["components"]} >= {"X", "Y", "Z", "room"}
    assert "common source of EXX, EBX" in (written / "report.html").read_text(encoding="utf-8")
