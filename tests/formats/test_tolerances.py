# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tolerance tables are read back equal, in um, urad or arcsec, and every finding names its line and column."""

from __future__ import annotations

import json
import math

import pytest

from sensworkbench.core.distributions import Tolerance, with_defaults
from sensworkbench.core.refusal import Refused
from sensworkbench.formats import tolerances

from .support import golden, write

TABLE = with_defaults({}) | {
    "EXX": Tolerance(-1e-3, 3.3e-3, "triangular"),
    "EAT": Tolerance(-7e-6, 7e-6, "truncated_normal", 2.1e-6),
    "ECW": Tolerance(1e-6, 1e-6, "point"),
}


@pytest.mark.parametrize("angle_unit", ["urad", "arcsec"])
@pytest.mark.parametrize("ending", ["csv", "json"])
def test_a_table_written_and_read_again_is_equal(tmp_path, ending, angle_unit):
    path = tmp_path / f"t.{ending}"
    tolerances.save(TABLE, path, angle_unit)
    assert tolerances.load(path) == TABLE
    assert angle_unit in path.read_text(encoding="utf-8")


def test_a_spreadsheet_of_a_continental_office_is_understood():
    text = "# shop 7\nSymbol;Lower;Upper;Unit\nEXX;-1,5;1,5;um\nEAX;-2;2 arcsec;\nE_C0Y;0;0,02;mm/m\n"
    found = tolerances.loads_csv(text)
    assert found["EXX"] == Tolerance(-1.5e-3, 1.5e-3)
    assert found["EAX"].lower == pytest.approx(-2e-6) and found["EAX"].upper == pytest.approx(2 / 3600 * math.pi / 180)
    assert found["C0Y"].upper == pytest.approx(20e-6)


def test_a_machine_file_serves_as_a_table_of_tolerances(tmp_path):
    path = write(tmp_path / "m.json", golden(tolerances={"EXX": {"lower": -9, "upper": 9, "unit": "um"}}))
    found = tolerances.load(path)
    assert list(found) == ["EXX"] and found["EXX"].upper == pytest.approx(9e-3, rel=1e-15)


def test_all_findings_are_listed_with_line_and_column():
    rows = ["EXX,1,0,um", "EQX,1,2,um", "# remark", "EAX,1,2,um", "EYY,nan,1,um", "EZZ,,1,um", "EZX,0,1,um"]
    text = "\n".join(["symbol,lower,upper,unit", *rows])
    with pytest.raises(Refused) as caught:
        tolerances.loads_csv(text, "t.csv")
    assert caught.value.message == (
        "t.csv, line 2, column upper: upper limit 0 is below lower limit 1. Exchange the two limits. 4 more findings: "
        "line 3, column symbol, line 5, column lower, line 6, column lower, line 7, column lower."
    )


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ('symbol,lower,upper\nEXX,0,"1,000"\n', "decimal-comma"),
        ("symbol;lower;upper\nEXX;-0,5;0,5\nEYY;0.5;1\n", "decimal-mixed"),
    ],
)
def test_a_decimal_sign_that_may_be_another_is_refused(text, code):
    with pytest.raises(Refused) as caught:
        tolerances.loads_csv(text, "t.csv")
    assert caught.value.code == code


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", ["empty"]),
        ("symbol,lower,upper\n", ["no tolerance"]),
        ("symbol,lower\nEXX,1", ["line 1", '"upper" is missing']),
        ("symbol,lower,upper,colour\n", ["line 1", "colour"]),
        ("symbol,lower,lower,upper\n", ["line 1", "twice"]),
        ("symbol,lower,upper\nEXX,0,1\nE_XX,0,1\n", ["line 3", "E_XX"]),
        ("symbol,lower,upper\nC0Y,0,1\nE_C0Y,0,1\n", ["line 3", "C0Y stands twice"]),
        ("symbol,lower,upper\nEXX,0,1,2\n", ["line 2", "4 cells"]),
        ("symbol,lower,upper\nEXX,0,1e999\n", ["line 2", "column upper", "finite"]),
        ("symbol,lower,upper,distribution\nEXX,0,1,cauchy\n", ["line 2", "column distribution", "cauchy"]),
        ("symbol,lower,upper,distribution,sigma\nEXX,0,1,normal,-1\n", ["line 2", "column sigma"]),
        ('{"format": "sens-tolerances", "version": 1}', ["tolerances"]),
        ('{"format": "sens-tolerances", "version": 9, "tolerances": {}}', ["version"]),
        (json.dumps(golden()), ["no tolerances"]),
        ("{}", ["not tolerances"]),
    ],
)
def test_bad_tables_are_refused(tmp_path, text, words):
    path = write(tmp_path / "t.txt", text)
    with pytest.raises(Refused) as caught:
        tolerances.load(path)
    assert caught.value.message.startswith(str(path))
    for word in words:
        assert word in caught.value.message
