# SPDX-License-Identifier: LGPL-2.1-or-later
"""The examples of docs/formats.md are files that the program reads, and no reader breaks on nonsense."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensworkbench.core.refusal import Refused
from sensworkbench.formats import csv_table, machine_json, readings_csv
from sensworkbench.formats.exchange.convert import write
from sensworkbench.formats.exchange.known import etalon, fcm, isg

PAGE = (Path(__file__).resolve().parents[2] / "docs" / "formats.md").read_text(encoding="utf-8")


def examples(language=""):
    return re.findall(rf"```{language}\n(.*?)```", PAGE, flags=re.DOTALL)


def example(start):
    return next(text for text in examples("(?:json)?") if text.startswith(start))


def test_the_machine_of_the_page_can_be_read_and_written_to_every_format():
    machine = machine_json.loads(example('{"format"'))
    assert machine.structure == "XYFZ" and machine.effects[0].name == "backlash"
    assert write(machine, "linuxcnc").coverage.effects == ("backlash",)


def test_the_five_axis_machine_of_the_page_is_read():
    machine = machine_json.loads(example('{"format": "sens-machine", "version": 2'))
    assert machine.names == ("X", "Y", "Z", "A", "C")
    assert [machine.joint(n).kind.name for n in machine.names] == ["linear"] * 3 + ["rotary"] * 2
    assert machine.joint("C").travel is None and machine.joint("A").travel[0] == pytest.approx(np.radians(-120))
    assert {"C0Y", "Y0A", "B0A", "X0C", "ECC"} <= {c.symbol for c in machine.components}


def test_the_readings_of_the_page_are_read(tmp_path):
    path = tmp_path / "measured.csv"
    path.write_text(example("# sign"), encoding="utf-8")
    readings = readings_csv.load(path)
    assert readings.points == 2 and readings.rows == 5
    assert readings.columns["temp_column"][0] == pytest.approx(2.28)
    assert "sign-assumed" not in {f.code for f in readings.remarks}


def test_the_mapping_and_the_tables_of_the_page_are_read():
    mapping = json.loads(example('{"t_s"'))
    assert readings_csv.check_mapping(mapping) == mapping
    read = isg.loads(example("// errors"))
    assert {t.symbol for t in read.tables} == {"EXX", "EYX", "EAX"} and read.constants["C0Y"] == 2e-5
    assert etalon.loads(example("[C0Y]")).tables[0].symbol == "EXX"


WORDS = ["x_mm", "y_mm", "z_mm", "ex_um", "nx", "reading_um", "dir_x", "t_s", "run", "u_um", "temp_a_C", "X", "EXX"]
WORDS += [
    "C0Y",
    "[EXX]",
    "VALUE = 1",
    "Gridpoints = {",
    "}",
    "#",
    "//",
    ",",
    ";",
    "\t",
    "\n",
    '"',
    "1",
    "-2.5",
    "nan",
    "1e400",
]
NONSENSE = st.one_of(st.text(max_size=80), st.lists(st.sampled_from(WORDS), max_size=40).map(" ".join),
                     st.lists(st.sampled_from(WORDS), max_size=40).map(",".join))  # fmt: skip


@settings(max_examples=400, deadline=None)
@given(NONSENSE)
def test_nonsense_is_refused_and_breaks_nothing(text):
    readers = [isg.loads, etalon.loads, fcm.loads]
    readers += [lambda t: readings_csv._Reader(csv_table.parse(t, "t"), None).readings()]
    readers += [lambda t: readings_csv._Reader(csv_table.parse(t, "t"), None).positions()]
    for reader in readers:
        try:
            reader(text)
        except Refused as refused:
            assert refused.message


CELL = st.sampled_from(["", "1", "-1", "0", "2.5", "nan", "inf", "a", "1e308", "-0", "1,5", " "])
NAMES = ["x_mm", "y_mm", "z_mm", "ex_um", "ey_mm", "nx", "ny", "nz", "reading_um", "dir_x", "t_s", "run", "u_um",
         "temp_a_F", "tool_dx_mm", "odd", "gap_um", "load_b_t"]  # fmt: skip


@settings(max_examples=300, deadline=None)
@given(st.lists(st.sampled_from(NAMES[3:]), unique=True, max_size=8), st.data())
def test_any_table_is_read_or_refused_and_rows_keep_their_points(names, data):
    names = NAMES[:3] + names
    rows = data.draw(st.lists(st.lists(CELL, min_size=len(names), max_size=len(names)), min_size=1, max_size=6))
    text = "\n".join(";".join(r) for r in [names, *rows])
    try:
        readings = readings_csv._Reader(csv_table.parse(text, "t"), None).readings()
    except Refused:
        return
    assert readings.rows >= readings.points > 0
    assert set(readings.point.tolist()) == set(range(readings.points))
    assert (readings.point[1:] >= readings.point[:-1]).all()
    assert all(len(v) == readings.points and np.isfinite(v).all() for v in readings.columns.values())
    assert np.isfinite(readings.value).all() and np.linalg.norm(readings.sense, axis=1) == pytest.approx(1)
