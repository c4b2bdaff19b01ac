# SPDX-License-Identifier: LGPL-2.1-or-later
"""Variants of a document: cells and properties, recomputed by FreeCAD, judged as the machine that they make."""

from __future__ import annotations

import csv
import json
import os
import subprocess
import sys
from pathlib import Path

import FreeCAD as App
import pytest

from sensworkbench import cli
from sensworkbench.core import workspace
from sensworkbench.core.refusal import Refused
from sensworkbench.document import sweeping
from sensworkbench.document.extract import core_machine

from .blocks import golden_machine

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def saved(doc, tmp_path):
    """A machine whose scale of Z is as high as a cell says, and a folder of its own."""
    golden_machine(doc, "XYFZ")
    sheet = doc.addObject("Spreadsheet::Sheet", "Sheet")
    sheet.set("B2", "=0 mm")
    sheet.setAlias("B2", "reach")
    sheet.set("B3", "a word")
    bed = doc.getObject("Bed")
    bed.addProperty("App::PropertyLength", "Spare")
    bed.setExpression("Spare", "Sheet.reach + 1 mm")
    doc.getObject("RefZ").setExpression("Placement.Base.z", "Sheet.reach + 600 mm")
    doc.recompute()
    names = {"part": "Bed", "head": "RefX"}
    path = tmp_path / "machine.FCStd"
    doc.saveCopy(str(path))
    return path, names


def spec(folder, parameters, **more):
    data = {"machine": "machine.FCStd", "parameters": parameters, "outputs": ["rms", "share.X"]} | more
    path = folder / "spec.json"
    path.write_text(json.dumps(data), encoding="utf-8")
    return path


def table(folder):
    with open(folder / "results.csv", encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


def test_each_variant_is_the_machine_that_the_document_then_holds(saved, tmp_path):
    path, names = saved
    place = f"{names['head']}.Placement.Base.z"
    parameters = [{"path": place, "values": [0.0, 40.0]}, {"path": "Sheet.reach", "values": [0.0, 80.0]}]
    assert cli.main(["sweep", str(spec(tmp_path, parameters)), "--out", str(tmp_path / "out")]) == 0
    rows = table(tmp_path / "out")
    assert len(rows) == 4 and not any(r["refused"] for r in rows) and len({r["rms"] for r in rows}) == 4
    document = App.openDocument(str(path))
    try:
        from sensworkbench.document.tree import machine_of

        for row in rows:
            sweeping.place(document, place)(float(row[place]))
            document.Sheet.set("B2", f"={row['Sheet.reach']} mm")
            document.recompute()
            alone = workspace.sensitivity(core_machine(machine_of(document)), estimate=False)
            assert float(row["rms"]) == pytest.approx(1e3 * alone.mean_square**0.5, rel=1e-12)
    finally:
        App.closeDocument(document.Name)


def test_a_cell_keeps_its_unit_and_what_follows_it_follows(saved):
    path, names = saved
    document = App.openDocument(str(path))
    try:
        sweeping.place(document, "Sheet.reach")(25.0)
        document.recompute()
        assert document.Sheet.get("B2") == App.Units.Quantity("25 mm")
        assert float(document.getObject(names["part"]).Spare) == pytest.approx(26)
        sweeping.place(document, "Sheet.B2")(3.0)
        document.recompute()
        assert float(document.getObject(names["part"]).Spare) == pytest.approx(4)
    finally:
        App.closeDocument(document.Name)


@pytest.mark.parametrize(
    ("path", "code"),
    [
        ("Nothing.Length", "sweep-object"),
        ("Sheet", "sweep-object"),
        ("Sheet.nowhere", "sweep-cell"),
        ("Sheet.B3", "sweep-no-value"),
        ("{part}.Nonsense", "sweep-property"),
        ("{part}.Label", "sweep-no-value"),
        ("{part}.Spare", "sweep-expression"),
    ],
)
def test_paths_that_lead_nowhere_are_refused_before_anything_is_written(saved, tmp_path, path, code):
    file, names = saved
    with pytest.raises(Refused) as refused:
        sweeping.DocumentJudge(file, [path.format(**names)], ["rms"])
    assert refused.value.code == code
    words = spec(tmp_path, [{"path": path.format(**names), "values": [1.0]}])
    assert cli.main(["sweep", str(words), "--out", str(tmp_path / "out")]) == 2
    assert not (tmp_path / "out").exists()


def test_plain_python_sends_variants_to_freecad_and_the_table_is_the_same(saved, tmp_path):
    _, names = saved
    place = f"{names['head']}.Placement.Base.z"
    path = spec(tmp_path, [{"path": place, "range": [0.0, 40.0, 20]}])
    assert cli.main(["sweep", str(path), "--out", str(tmp_path / "inside")]) == 0
    environment = {k: v for k, v in os.environ.items() if not k.startswith("SENS_HANDOFF")}
    python = next(p for p in (sys.executable, "/usr/bin/python3", "/usr/bin/python") if "python" in Path(p).name)
    done = subprocess.run(
        [python, "-m", "sensworkbench", "sweep", str(path), "--out", str(tmp_path / "outside"), "--workers", "2"],
        cwd=ROOT,
        env=environment | {"PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        timeout=300,
    )
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "outside" / "results.csv").read_bytes() == (tmp_path / "inside" / "results.csv").read_bytes()
