# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that plans a measurement: what each error will be known to, and what more readings would buy."""

from __future__ import annotations

import json

import pytest

from sensworkbench.document import extract, studies
from sensworkbench.formats import plan_json
from sensworkbench.gui import messages as window
from sensworkbench.gui import task_plan
from sensworkbench.gui.files import RESOURCES
from sensworkbench.studies.plan import PlanRequest, plan_study

from .conftest import close_messages, messages, rows, screenshot, study

GRID = f"{RESOURCES}/examples/plan_grid.csv"


@pytest.fixture
def panel(machine):
    with study(task_plan.open_panel, machine) as made:
        yield made


def test_it_shows_what_the_study_finds_and_the_document_keeps_it(panel, machine):
    panel.count.setValue(60)
    panel.noise.setValue(2.0)
    assert panel.compute(), panel.summary.text()
    core = extract.core_machine(machine)
    known = plan_json.to_dict(plan_study(core, None, PlanRequest(2.0, 60)))
    shown = rows(panel.errors)
    assert set(shown) == {e["symbol"] for e in known["errors"]} and len(shown) > 15
    for entry in known["errors"]:
        item = shown[entry["symbol"]]
        for column, key in enumerate(("u", "u_another_tool", "u_another_run"), start=1):
            if entry[key] is None:
                assert "determined" in item.text(column)
            else:
                assert item.text(column).split()[0] == f"{entry[key]:.2g}", (entry, key)
    assert panel.advice.topLevelItemCount() == len(known["advice"])
    screenshot("plan")
    kept = studies.study_of(machine, "plan")
    settings, data = studies.read(kept)
    assert settings["suggest"] == 60 and data["errors"] == json.loads(json.dumps(known["errors"]))
    panel.noise.setValue(1.0)
    assert panel.data is None and not panel.errors.topLevelItemCount()


def test_a_table_of_places_is_planned_and_the_files_are_those_of_the_verb(panel, tmp_path, monkeypatch):
    panel.load_places(GRID)
    assert panel.file.text() == "plan_grid.csv" and panel.count.isHidden()
    assert panel.compute(), panel.summary.text()
    assert panel.data["judged"] == "given"
    sensed = panel.errors.isColumnHidden(4)
    assert sensed == ("u_another_sensor" not in panel.data["errors"][0])
    monkeypatch.setattr(window, "ask_folder", lambda _title: str(tmp_path))
    written = {p.name for p in panel.ask_report()}
    assert written >= {"plan.json", "report.html", "candidates.csv"}
    close_messages()
    assert json.loads((tmp_path / "plan.json").read_text(encoding="utf-8"))["errors"] == panel.data["errors"]


def test_a_table_that_is_no_plan_is_refused_and_the_choice_stays(panel, tmp_path):
    path = tmp_path / "places.csv"
    path.write_text("a,b\n1,2\n", encoding="utf-8")
    panel.load_places(path)
    assert messages() and panel.path == ""
    close_messages()
