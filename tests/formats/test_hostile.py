# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that were made to do harm: each is read rightly or refused in one short message, and in time."""

from __future__ import annotations

import json
import os
import time
import tracemalloc

import numpy as np
import pytest

from sensworkbench import cli
from sensworkbench.closedloop.readings import Readings
from sensworkbench.core.refusal import Refused
from sensworkbench.formats import csv_table, files, json_text, machine_json, readings_conventions, readings_csv
from sensworkbench.formats.exchange.known import etalon, fcm, isg
from sensworkbench.studies.places import within_travel

from .support import golden, write

POSITIONS = "x_mm,y_mm,z_mm,t_s\n1,2,-3,0\n5,6,-7,1\n"


def table(tmp_path, text):
    path = tmp_path / "p.csv"
    path.write_text(text, encoding="utf-8")
    return path


@pytest.mark.parametrize("comment", ["# a" + 100_000 * " " + "x", "# " + 100_000 * "a ", "#" + 100_000 * " :"])
def test_a_long_comment_takes_no_time(tmp_path, comment):
    path = table(tmp_path, comment + "\n" + POSITIONS)
    start = time.process_time()
    assert readings_csv.load_positions(path).points == 2
    assert time.process_time() - start < 1


@pytest.mark.parametrize(
    ("comment", "found"),
    [("sign: error", "sign"), ("Sign  = error", "sign"), ("squareness sign = right handed", "squareness_sign"),
     ("frame:", ""), ("nothing", ""), ("remark: sign: error", "")],
)  # fmt: skip
def test_a_comment_is_cut_at_its_first_colon_or_equals_sign(comment, found):
    assert readings_conventions.question(comment) == found


@pytest.mark.parametrize("line", ["# sign: ,", "# frame: , ,", "# positions: ,"])
def test_an_answer_of_commas_is_refused(tmp_path, line):
    with pytest.raises(Refused) as refused:
        readings_csv.load_positions(table(tmp_path, line + "\n" + POSITIONS))
    assert refused.value.code == "statement-answer" and "line 1" in refused.value.where


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ("[" * 100_000, "deeper"),
        ('{"z_mm": ' + 5000 * "1" + "}", "digits"),
        ('{"z_mm": 1' + 399 * "0" + "}", "range"),
        ('{"z_mm": 1e999}', "range"),
        ('{"z_mm": NaN}', "NaN"),
        ('{"temp_a_C": NaN}', "NaN"),
        ('{"z_mm": 1, "z_mm": 2}', "twice"),
        ('{"z_mm": 1e200}', r"at most 1e\+15"),
        ('{"z_mm": 1e14}', "too large for z"),
        ('{"z_mm": true}', "cannot stand"),
        ('{"ignore": 5}', "ignore"),
        ('{"header": {"sign": 5}}', "header"),
        ('{"header": {"sign": ","}}', "no answer"),
        ('{"header": {"colour": "red"}}', "no question"),
    ],
)
def test_a_mapping_is_read_as_strictly_as_any_file(tmp_path, text, word):
    mapping = write(tmp_path / "map.json", text)
    positions = table(tmp_path, "x_mm,y_mm\n1,2\n3,4\n")
    with pytest.raises(Refused, match=word) as refused:
        readings_csv.load_positions(positions, readings_csv.load_mapping(mapping))
    assert len(refused.value.message) <= 300 + 2 * len(str(tmp_path))


@pytest.mark.parametrize(
    ("row", "code"),
    [
        ("1e300,2,3,1,1,1,.5", "number-too-large"),
        ("1,2,3,1e300,1,1,.5", "number-too-large"),
        ("1,2,3,1,1,1,1e-300", "uncertainty-too-small"),
        ("1,2,3,1,1,1,1e300", "number-too-large"),
    ],
)
def test_lengths_out_of_this_world_are_refused(tmp_path, row, code):
    text = "x_mm,y_mm,z_mm,ex_um,ey_um,ez_um,u_um\n" + 12 * "1,2,3,1,1,1,.5\n" + row + "\n"
    with pytest.raises(Refused) as refused:
        readings_csv.load(table(tmp_path, text))
    assert refused.value.code == code and "line 14, column" in refused.value.where


FITTED = {"EXX": {"basis": "legendre", "domain": [-300, 300], "coefficients": [1, 2], "unit": "um"}}
OVERFLOWING = {
    "coefficients": golden(fitted={"EXX": {**FITTED["EXX"], "coefficients": [1e308, 1e308]}}),
    "a short domain": golden(fitted={"EXX": {**FITTED["EXX"], "domain": [0, 1e-320]}}),
    "an effect": golden(
        fitted=FITTED,
        effects=[
            {
                "name": "e",
                "component": "EXX",
                "driver": "*".join(200 * ["x"]),
                "shape": "linear",
                "parameters": {"coefficient": {"value": 1}},
            }
        ],
    ),
}


@pytest.mark.parametrize("case", OVERFLOWING)
def test_a_prediction_that_is_no_number_is_refused(tmp_path, capsys, case):
    machine = write(tmp_path / "m.json", OVERFLOWING[case])
    positions = table(tmp_path, "x_mm,y_mm,z_mm\n1,1,1\n299,100,3\n")
    with np.errstate(all="raise"):
        status = cli.main(["predict", str(machine), str(positions), "--out", str(tmp_path / "out.csv")])
    said = capsys.readouterr()
    assert status == 2, said
    assert not (tmp_path / "out.csv").exists()


def test_the_finite_prediction_is_written(tmp_path, capsys):
    machine = write(tmp_path / "m.json", golden(fitted=FITTED))
    positions = table(tmp_path, "x_mm,y_mm,z_mm\n1,1,1\n299,100,3\n")
    assert cli.main(["predict", str(machine), str(positions), "--out", str(tmp_path / "out.csv")]) == 0
    assert json.dumps(readings_csv.load_positions(tmp_path / "out.csv").points) == "2"


# -- size --------------------------------------------------------------------------------------------------------------
def test_a_table_of_thirty_thousand_columns_is_read_in_time(tmp_path):
    names = ["x_mm", "y_mm", "z_mm", *(f"c{i}" for i in range(30_000))]
    path = table(tmp_path, "\n".join(",".join(row) for row in (names, ["1"] * len(names), ["2"] * len(names))))
    start = time.process_time()
    assert len(readings_csv.load_positions(path).columns) == 30_003
    assert time.process_time() - start < 20


@pytest.mark.parametrize("row", ["1,2,3\n", "1,2,3,a\n"])
def test_a_table_of_short_rows_takes_twenty_times_its_size(tmp_path, row):
    """The shortest rows are the dearest: each takes a place, a line number and the cells of its columns."""
    head = "x_mm,y_mm,z_mm" + ",c" * (row.count(",") - 2) + "\n"
    peaks = []
    for count in (100_000, 300_000):
        path = table(tmp_path, head + count * row)
        tracemalloc.start()
        try:
            assert readings_csv.load_positions(path).points == count
            peaks.append(tracemalloc.get_traced_memory()[1])
        finally:
            tracemalloc.stop()
    assert (peaks[1] - peaks[0]) / (200_000 * len(row)) < 20


@pytest.mark.parametrize("separator", [",", ";", "\t"])
def test_plain_rows_are_read_as_rows_that_need_care(separator):
    """Rows without blanks and quotes are cut in one piece: the same table with them is the same table."""
    rng = np.random.default_rng(len(separator) + ord(separator))
    rows = [[f"{a:.3f}", *(f"{v:.3f}" if v > -2 else "" for v in more)] for a, *more in rng.normal(size=(60_000, 3))]
    rows[777] = ["1e3", "x", "nan"]
    plain = "\n".join(separator.join(row) for row in (["a", "b", "c"], *rows)) + "\n"
    careful = "\n".join(separator.join(f'"{cell}"' for cell in row) for row in (["a", "b", "c"], *rows))
    want, found = csv_table.parse(careful, "t"), csv_table.parse(plain, "t")
    assert found.rows == want.rows == 60_000 and found.line[-1] == 60_001
    assert [found.cells[j] for j in range(3)] == [want.cells[j] for j in range(3)] == [list(c) for c in zip(*rows)]
    assert found.first_bad(1) == 777 and found.first_bad(0) is None
    lines = plain.split("\n")
    for changed, code in (("1" + separator + "2", "table-ragged"), ('1;2,3\t"4', "cell-over-line-end")):
        broken = "\n".join([*lines[:50_000], changed, *lines[50_000:]])
        with pytest.raises(Refused) as refused:
            csv_table.parse(broken, "t")
        assert refused.value.code in (code, "table-ragged") and "line 50001" in str(refused.value)
    for extra in ("#note", separator * 2, "", "  ", " # note"):
        assert csv_table.parse("\n".join([*lines[:50_000], extra, *lines[50_000:]]), "t").rows == 60_000


def test_a_file_longer_than_it_says_is_read_whole(tmp_path, monkeypatch):
    path = table(tmp_path, POSITIONS)
    real = os.fstat

    class Shorter:
        def __init__(self, info):
            self.st_mode, self.st_size = info.st_mode, 3

    monkeypatch.setattr(files.os, "fstat", lambda handle: Shorter(real(handle)))
    assert files.read_bytes(path, 1000) == POSITIONS.encode()
    with pytest.raises(Refused, match="larger"):
        files.read_bytes(path, 10)


def test_the_time_for_a_table_grows_with_its_size(tmp_path):
    took = []
    for count in (20_000, 200_000):
        path = table(tmp_path, "x_mm,y_mm,z_mm\n" + count * "1,2,3\n")
        start = time.process_time()
        assert readings_csv.load_positions(path).points == count
        took.append(time.process_time() - start)
    assert took[1] < 30 * took[0] + 1


@pytest.mark.parametrize(
    ("text", "code"),
    [
        (",".join(f"c{i}" for i in range(100_001)) + "\n", "table-too-wide"),
        ('x_mm,y_mm,z_mm\n1,2,"3\n4,5,6\n', "cell-over-line-end"),
        ('x_mm,y_mm,z_mm\n1,2,"3', "cell-over-line-end"),
        ("x_mm,y_mm,z_mm\n1,2," + 200_000 * "3" + "\n", "table-cell"),
        ("x_mm,y_mm,z_mm\n1,2," + 5_000 * "a" + "\n", "cell-not-a-number"),
        ("x_mm;y_mm;z_mm\n1,000;2;3\n999.5;2;3\n", "decimal-mixed"),
        ("x_mm,y_mm,z_mm\n1_000,2,3\n", "cell-not-a-number"),
    ],
)
def test_a_table_is_refused_in_few_words(tmp_path, text, code):
    with pytest.raises(Refused) as refused:
        readings_csv.load_positions(table(tmp_path, text))
    assert refused.value.code == code
    assert len(refused.value.message) <= 300 + len(str(tmp_path))


def test_two_decimal_signs_in_two_columns_are_said(tmp_path):
    found = readings_csv.load_positions(table(tmp_path, "x_mm;y_mm;z_mm\n1,5;2.5;3\n2,5;3.5;3\n"))
    assert found.q.tolist() == [[1.5, 2.5, 3], [2.5, 3.5, 3]]
    assert "decimal-signs" in {f.code for f in found.remarks}


LARGE = {
    "a list": '{"x-a": [' + ",".join(["1"] * 400_000) + "]}",
    "a million brackets": 2_000_000 * "[",
    "a late twin": "{" + ",\n".join(f'"x-{i}":{i}' for i in range(200_000)) + ',\n"x-5": 1}',
    "a late word": "[" + ",\n".join(["1"] * 800_000) + ",\nNaN]",
    "a late fault": "[" + ",\n".join(["1"] * 800_000) + ",,]",
}


@pytest.mark.parametrize("case", LARGE)
def test_a_large_json_text_takes_seconds_and_a_fault_in_it_has_a_line(case):
    start = time.process_time()
    try:
        json_text.parse(LARGE[case], "large.json")
    except Refused as refused:
        assert case != "a list"
        assert case == "a million brackets" or "large.json, line" in refused.where
        assert len(refused.message) <= 300
    else:
        assert case == "a list"
    assert time.process_time() - start < 10


def test_both_parsers_of_json_agree():
    texts = [
        '{"a": [1, 2.5, -0, 1e3, true, false, null, "é\\u00e9\\ud83d\\ude00"], "b": {"c": {}}}',
        " [ ] ",
        "9007199254740993",
    ]
    for text in texts:
        assert json_text.parse(text).value == json_text._parse_slowly(text, "").value
    place = json_text.parse('{"a": [1,\n2,\n{"b":\n5}]}', "t")
    assert place["a"].elements()[2]["b"].where == "t, line 3, a[2].b"
    assert place["a"].elements()[1].where == "t, line 2, a[1]"


# -- tables and machines of other systems ------------------------------------------------------------------------------
ISG = "X EXX\n-200 0\n0 0.001\n200 {}\n"
ETALON = "[EXX]\nGridpoints = {{\n-200 0\n200 {}\n}}\n"


@pytest.mark.parametrize("value", ["1_0", "nan", "inf", "1e308", "-1e308", 5000 * "9", 3000 * "a"])
@pytest.mark.parametrize(("module", "text"), [(isg, ISG), (etalon, ETALON)], ids=["isg", "etalon"])
def test_numbers_of_other_systems_are_read_as_a_person_would(module, text, value):
    assert module.loads(text.format("0.002"), "t").tables
    with pytest.raises(Refused) as refused:
        module.loads(text.format(value), "t")
    assert len(refused.value.message) <= 300 and "line 4" in refused.value.where


AXIS = {"type": "linear", "role": "head_linear", "joint": {"origin": [0, 0, 0], "axis": [1, 0, 0]}}
DIRECTIONS = {"X": [1, 0, 0], "Y": [0, 1, 0], "Z": [0, 0, 1]}


def fcm_text(change) -> str:
    axes = {
        k: AXIS | {"joint": {"origin": [0, 0, 0], "axis": d}, "sequence": i}
        for i, (k, d) in enumerate(DIRECTIONS.items())
    }
    data = {"machine": {"name": "m", "axes": axes}, "version": 1}
    change(data["machine"])
    return json.dumps(data)


CHANGES = {
    "limits are a number": lambda m: m["axes"]["X"].update(limits=5),
    "limits are null": lambda m: m["axes"]["X"].update(limits=None),
    "a role is a list": lambda m: m["axes"]["X"].update(role=[]),
    "a role is an object": lambda m: m["axes"]["X"].update(role={}),
    "units are a list": lambda m: m.update(units=[]),
    "an axis twice": lambda m: m["axes"].update(x=m["axes"]["X"]),
    "a travel out of this world": lambda m: m["axes"]["X"].update(limits={"min": -1e308, "max": 1e308}),
    "an origin out of this world": lambda m: m["axes"]["X"].update(joint={"origin": [1e308, 0, 0], "axis": [1, 0, 0]}),
    "a long axis": lambda m: m["axes"]["X"].update(joint={"origin": [0, 0, 0], "axis": [1e308, 1e308, 0]}),
    "a parent of itself": lambda m: m["axes"]["X"].update(parent=["X"]),
    "a sequence out of this world": lambda m: m["axes"]["X"].update(sequence=1e308),
}


@pytest.mark.parametrize("change", CHANGES)
def test_a_spoiled_machine_of_another_system_is_refused_or_read(change):
    try:
        machine, _ = fcm.loads(fcm_text(CHANGES[change]), "m.fcm")
    except Refused as refused:
        assert len(refused.message) <= 300
    else:
        assert change in ("a parent of itself", "a sequence out of this world")
        assert np.isfinite(machine.travel).all()


# -- places that cannot be those of the machine ------------------------------------------------------------------------
@pytest.mark.parametrize("factor", [10, 25.4, 1000])
def test_positions_in_another_unit_are_refused(tmp_path, capsys, factor):
    machine = write(tmp_path / "m.json", golden(fitted=FITTED))
    rng = np.random.default_rng(1)
    q = rng.uniform((-300, -200, -250), (300, 200, 50), (60, 3)) * factor
    lines = ["x_mm,y_mm,z_mm,ex_um,ey_um,ez_um", *(",".join(f"{v:.4f}" for v in (*row, 1, 2, 3)) for row in q)]
    path = table(tmp_path, "\n".join(lines) + "\n")
    for words in (["trace"], ["predict"], ["plan"]):
        assert cli.main([*words, str(machine), str(path), "--out", str(tmp_path / "o")]) == 2
        said = capsys.readouterr().err
        assert "times as far" in said and "line 2" in said and "p.csv" in said and len(said) < 300 + len(str(path))
    assert not (tmp_path / "o").exists()


def test_some_positions_outside_are_only_said():
    machine = machine_json.loads(json.dumps(golden()), "m.json")
    q = np.zeros((10, 3))
    q[:3] = 5000
    none = np.empty(0, dtype=int)
    rows = Readings(q=q, point=none, sense=np.empty((0, 3)), value=np.empty(0), u=np.empty(0), kind=none, columns={})
    assert [f.code for f in within_travel(machine, rows).remarks] == ["outside-travel"]
