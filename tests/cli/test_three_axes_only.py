# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machines whose readings cannot be traced yet are refused in words, and nothing is written."""

from __future__ import annotations

from pathlib import Path

import pytest

from sensworkbench import cli

EXAMPLES = Path(__file__).resolve().parents[2] / "resources" / "examples"
HEADS = {"trunnion": "x_mm,y_mm,z_mm,a_deg,c_deg", "lathe": "x_mm,z_mm", "rotary_table": "c_deg"}


@pytest.mark.parametrize("verb", ["trace", "plan"])
@pytest.mark.parametrize("name", HEADS)
def test_readings_of_other_machines_are_refused_in_words(tmp_path, capsys, name, verb):
    width = HEADS[name].count(",") + 1
    rows = [",".join(str((7 * i + 3 * j) % 20 - 10) for j in range(width)) + f",{i % 5}" for i in range(40)]
    table = tmp_path / "measured.csv"
    table.write_text(f"{HEADS[name]},ex_um\n" + "\n".join(rows) + "\n", encoding="utf-8")
    out = tmp_path / "out"
    assert cli.main([verb, str(EXAMPLES / f"{name}.json"), str(table), "--out", str(out)]) == 2
    assert "three linear axes X, Y, Z only" in capsys.readouterr().err and not out.exists()
