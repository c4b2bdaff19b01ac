# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of a fleet: a folder of records, what recurs on which machine, and a bad record that stops nothing."""

from __future__ import annotations

import json

import FreeCADGui as Gui
import pytest

from sensworkbench.core.workspace import Cancelled
from sensworkbench.formats import fleet_files
from sensworkbench.gui import live, task_fleet
from sensworkbench.gui import messages as window
from sensworkbench.gui.qt import pump
from sensworkbench.studies.fleet import fleet_study

from ..simulator import make_case, write_case
from .conftest import close_messages, differences, messages, screenshot, state


@pytest.fixture(scope="module")
def fleet(tmp_path_factory):
    """Two machines whose column bends with its temperature, and a record that is broken."""
    folder = tmp_path_factory.mktemp("fleet")
    for seed in (12, 17):
        write_case(folder / f"bent{seed}", make_case(seed, "column_bend", structure="FYXZ", plan="grid", extras=False))
    write_case(folder / "broken", make_case(14, "none", plan="grid", extras=False))
    path = folder / "broken" / "measured.csv"
    path.write_text(path.read_text(encoding="utf-8").replace("e", "x"), encoding="utf-8")
    return folder


@pytest.fixture
def panel(machine, machine_doc):
    made = task_fleet.open_panel(machine_doc)
    pump(60)
    yield made
    Gui.Control.closeDialog()
    pump(60)


def items(view):
    return [view.topLevelItem(i) for i in range(view.topLevelItemCount())]


def test_what_recurs_is_shown_and_written_as_by_the_verb(panel, machine_doc, fleet, tmp_path, monkeypatch):
    before = state(machine_doc)
    panel.take(fleet)
    assert "3" in panel.place.text() and panel.run_button.isEnabled()
    assert panel.run(), panel.summary.text()
    known = fleet_study(fleet_files.members(fleet), fleet_files.Reader(str(fleet)))
    assert panel.found.recurring == known.recurring and known.recurring
    assert int(items(panel.effects)[0].text(1)) == len(known.recurring[0].machines) == 2
    rows = {i.text(0): i for i in items(panel.machines)}
    assert set(rows) == {"bent12", "bent17", "broken"} and "measured.csv" in rows["broken"].toolTip(1)
    screenshot("fleet")
    panel.tabs.setCurrentIndex(2)
    items(panel.effects)[0].setSelected(True)
    pump(60)
    image = panel._painted(360, 300)
    assert len({image.pixel(x, y) for x in range(0, 360, 2) for y in range(0, 300, 2)}) > 10
    screenshot("fleet-picture")
    monkeypatch.setattr(window, "ask_folder", lambda _title: str(tmp_path))
    assert {p.name for p in panel.ask_report()} >= {"fleet.json", "fleet.csv", "report.html"}
    close_messages()
    assert json.loads((tmp_path / "fleet.json").read_text(encoding="utf-8")) == json.loads(
        json.dumps(fleet_files.to_dict(known))
    )
    assert differences(before, state(machine_doc)) == []


def test_a_run_is_cancelled_inside_a_record(panel, fleet, monkeypatch):
    panel.take(fleet)
    told = []

    def cancelled(function, title, patience=0.3):
        def tell(part):
            told.append(part)
            return len(told) < 3

        return function(tell)

    monkeypatch.setattr(live, "in_background", cancelled)
    assert not panel.run() and "Cancelled" in panel.summary.text() and panel.found is None
    assert 0 < max(told) < 1 / 3 and issubclass(Cancelled, Exception)


def test_a_folder_without_records_is_refused(panel, tmp_path):
    panel.take(tmp_path)
    assert messages() and not panel.names and not panel.run_button.isEnabled()
    close_messages()
