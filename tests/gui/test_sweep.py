# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that tries many designs: the files of the verb, a table, the front, and a run that can be cancelled."""

from __future__ import annotations

import csv
import json
import subprocess
import sys

import FreeCAD as App
import pytest

from sensworkbench.core.workspace import Cancelled
from sensworkbench.formats import sweep_files
from sensworkbench.gui import live, task_sweep
from sensworkbench.gui.files import ROOT
from sensworkbench.gui.preferences import write_field
from sensworkbench.gui.qt import pump
from sensworkbench.gui.task_study import KEY

from .conftest import close_messages, differences, messages, screenshot, state, study


@pytest.fixture
def panel(machine):
    with study(task_sweep.open_panel, machine) as made:
        yield made


def ask(panel):
    panel.add("joints.Z.point.2")
    panel.add("tolerances.EAX.upper")
    panel.asked.item(0, task_sweep.STEPS).setText("4")
    panel.asked.item(1, task_sweep.LOW).setText("10; 20; 40")
    return panel


def test_table_front_and_files_are_those_of_the_verb(panel, machine, machine_doc, tmp_path):
    before = state(machine_doc)
    assert ask(panel).run(tmp_path / "designs"), panel.summary.text()
    assert differences(before, state(machine_doc)) == []
    folder = tmp_path / "designs"
    assert {p.name for p in folder.iterdir()} >= {
        "sweep.json",
        "machine.json",
        "results.csv",
        "pareto.csv",
        "report.html",
    }
    assert panel.table.topLevelItemCount() == 12 and not (folder / sweep_files.PARTIAL).exists()
    with (folder / "pareto.csv").open(encoding="utf-8") as stream:
        best = {r["variant"] for r in csv.DictReader(stream)}
    bold = {i.data(0, KEY) for i in items(panel.table) if i.font(0).bold()}
    assert best == bold == panel.front and best
    program = sys.executable if "python" in sys.executable else "python3"
    words = ["-m", "sensworkbench", "sweep", str(folder / "sweep.json"), "--out", str(tmp_path / "verb")]
    subprocess.run([program, *words], cwd=ROOT, check=True, capture_output=True)
    for name in ("results.csv", "pareto.csv"):
        assert (tmp_path / "verb" / name).read_bytes() == (folder / name).read_bytes()
    screenshot("sweep-variants")
    items(panel.table)[5].setSelected(True)
    panel.tabs.setCurrentIndex(2)
    pump(60)
    image = panel._painted(360, 300)
    colours = {image.pixel(x, y) for x in range(0, 360, 2) for y in range(0, 300, 2)}
    assert len(colours) > 20
    screenshot("sweep-picture")


def items(view):
    return [view.topLevelItem(i) for i in range(view.topLevelItemCount())]


def test_a_cancelled_run_goes_on_where_it_ended(panel, tmp_path, monkeypatch):
    ask(panel)
    calls = []

    def cancelled(function, title, patience=0.3):
        def tell(part):
            calls.append(part)
            return part < 0.4

        return function(tell)

    monkeypatch.setattr(live, "in_background", cancelled)
    assert not panel.run(tmp_path) and "Cancelled" in panel.summary.text()
    kept = (tmp_path / sweep_files.PARTIAL).read_text(encoding="utf-8").splitlines()
    assert 2 <= len(kept) < 12 and not (tmp_path / "results.csv").exists()
    titles = []

    def through(function, title, patience=0.3):
        titles.append(title)
        return function(lambda part: True)

    monkeypatch.setattr(live, "in_background", through)
    again = task_sweep.TaskSweep(panel.machine)
    again.open_spec(tmp_path / "sweep.json")
    assert again.asked.rowCount() == 2 and again.run(tmp_path)
    assert f"{len(kept) - 1} of them" in titles[0]
    rows = (tmp_path / "results.csv").read_text(encoding="utf-8").splitlines()
    assert rows[1 : len(kept)] == kept[1:] and len(rows) == 13
    assert issubclass(Cancelled, Exception)


def test_workers_write_the_same_bytes(panel, tmp_path):
    ask(panel).run(tmp_path / "one")
    panel.workers.setValue(2)
    assert panel.run(tmp_path / "two"), panel.summary.text()
    assert (tmp_path / "one" / "results.csv").read_bytes() == (tmp_path / "two" / "results.csv").read_bytes()


def test_cells_of_the_document_are_varied_in_processes_and_the_document_stays(panel, machine_doc, tmp_path):
    sheet = machine_doc.addObject("Spreadsheet::Sheet", "Design")
    sheet.set("A1", "=40 mm")
    sheet.setAlias("A1", "raise_head")
    machine_doc.recompute()
    point = machine_doc.getObject(panel.machine.Name).ToolPoint
    point = point[0] if isinstance(point, (tuple, list)) else point
    point.setExpression("Placement.Base.z", f"Design.raise_head + {point.Placement.Base.z - 40!r} mm")
    machine_doc.recompute()
    write_field(panel.of, task_sweep.DOCUMENT)
    assert "Design.raise_head" in panel.paths()
    panel.add("Design.raise_head")
    assert panel.asked.rowCount() == 1 and panel._text(0, task_sweep.LOW) == "32"
    panel.asked.item(0, task_sweep.STEPS).setText("3")
    before = state(machine_doc)
    assert panel.run(tmp_path), panel.summary.text()
    assert differences(before, state(machine_doc)) == [] and sheet.getContents("A1").replace(" ", "") == "=40mm"
    errors = [float(row[panel.names.index("rms")]) for row in panel.rows]
    assert len(set(errors)) == 3 and errors[1] == pytest.approx(19.4007, rel=1e-4)  # of the example as it is
    assert panel.table.topLevelItemCount() == 3 and (tmp_path / "XYFZ.FCStd").is_file()
    assert json.loads((tmp_path / "sweep.json").read_text(encoding="utf-8"))["machine"].endswith(".FCStd")


def test_what_leads_nowhere_is_said(panel, tmp_path):
    panel.add("joints.Q.point.0")
    assert messages() and panel.asked.rowCount() == 0
    close_messages()
    assert not panel.run_button.isEnabled()
    ask(panel)
    panel.asked.item(0, task_sweep.HIGH).setText("far")
    assert not panel.run(tmp_path) and "far" in panel.summary.text()
    assert not (tmp_path / "results.csv").exists()
    assert App.ActiveDocument is not None
