# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that were made to do harm: each is read rightly or refused in one short message, and in time."""

from __future__ import annotations

import json
import time

import numpy as np
import pytest

from sensworkbench import cli
from sensworkbench.core.refusal import Refused
from sensworkbench.formats import readings_conventions, readings_csv

from .support import golden, write

POSITIONS = "x_mm,y_mm,z_mm,t_s\n1,2,-3,0\n5,6,-7,1\n"


def table(tmp_path, text):
    path = tmp_path / "p.csv"
    path.write_text(text, encoding="utf-8")
    return path


@pytest.mark.parametrize("comment", ["# a" + 100_000 * " " + "x", "# " + 100_000 * "a ", "#" + 100_000 * " :"])
def test_a_long_comment_takes_no_time(tmp_path, comment):
    path = table(tmp_path, comment + "\n" + POSITIONS)
    start = time.perf_counter()
    assert readings_csv.load_positions(path).points == 2
    assert time.perf_counter() - start < 1


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
