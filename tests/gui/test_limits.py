# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of limits: the numbers of the study, passed or failed, drawn where they arise, kept with the document."""

from __future__ import annotations

import numpy as np
import pytest

from sensworkbench.core.distributions import Tolerance
from sensworkbench.document import extract, factory, studies, tables
from sensworkbench.formats import limits_json
from sensworkbench.gui import messages as window
from sensworkbench.gui import task_limits
from sensworkbench.gui.qt import pump
from sensworkbench.studies.limits import limits_study

from .conftest import close_messages, rows, screenshot, study


@pytest.fixture
def panel(machine, machine_doc):
    with study(task_limits.open_panel, machine) as made:
        yield made


def test_it_shows_what_the_study_finds_and_judges_it(panel, machine):
    panel.allowed.setValue(35.0)
    assert panel.compute()
    known = limits_json.to_dict(limits_study(extract.core_machine(machine), 0.95, (35.0,)))
    shown = rows(panel.figures)
    for figure in known["figures"]:
        row = shown[figure["name"]]
        assert row.text(task_limits.HALF) == f"{figure['median_um']:.1f}"
        assert row.text(task_limits.LEVEL) == f"{figure['quantile_um']:.1f}"
        assert row.text(task_limits.JUDGED) == ("passes" if figure["quantile_um"] <= 35 else "fails")
    assert shown["quantile"].text(task_limits.JUDGED) == "passes" and shown["worst"].text(task_limits.JUDGED) == "fails"
    assert f"{100 * known['beyond'][0]['probability']:.3g} %" in panel.summary.text()
    assert "tandard error" in panel.summary.text()  # sampled, because the laws are uniform
    assert studies.read(studies.study_of(machine, "limits")) == (panel.settings(), panel.data)
    screenshot("limits")
    panel.tabs.setCurrentIndex(1)
    pump(50)
    parts = [panel.makers.topLevelItem(i) for i in range(panel.makers.topLevelItemCount())]
    assert [p.text(0) for p in parts if p.text(0) in ("EBY", "EAY", "EAX")] == ["EBY", "EAY", "EAX"]
    parts[0].setSelected(True)
    screenshot("limits-contributions")


def test_normal_laws_are_computed_without_sampling(panel, machine, machine_doc):
    machine_doc.openTransaction("normal")
    found = {s: Tolerance(t.lower, t.upper, "normal") for s, t in tables.read_tolerances(machine).items()}
    factory.set_tolerances(machine, found)
    machine.touch()
    machine_doc.recompute()
    machine_doc.commitTransaction()
    assert panel.compute() and panel.data["method"] == "computed"
    assert "integration" in panel.summary.text()


def test_the_worst_place_and_the_diagonals_are_drawn_where_the_tool_is_then(panel, machine):
    panel.compute()
    core = extract.core_machine(machine)
    (mark,) = machine.ViewObject.Proxy.arrows.shown
    at = [j.from_shown(v) for j, v in zip(core.joints, panel.data["worst"]["at"])]
    assert mark.start == pytest.approx(tuple(core.tool_position([at])[0])) and mark.start == mark.end
    rows(panel.figures)["D2"].setSelected(True)
    pump(30)
    (line,) = machine.ViewObject.Proxy.arrows.shown
    span = np.ptp(core.travel, axis=1)
    assert np.abs(np.subtract(line.end, line.start)) == pytest.approx(span)
    panel.close()
    assert not machine.ViewObject.Proxy.arrows.shown


def test_a_change_makes_it_stale_and_undo_fresh_again(panel, machine, machine_doc):
    panel.compute()
    shown = panel.summary.text()
    panel.close()
    pump(60)
    found = tables.read_tolerances(machine)
    machine_doc.openTransaction("wider")
    factory.set_tolerances(machine, found | {"EBY": found["EBY"].scaled(2)})
    machine.touch()
    machine_doc.recompute()
    machine_doc.commitTransaction()
    obj = studies.study_of(machine, "limits")
    assert obj.Stale
    again = task_limits.open_panel(machine)
    assert "changed since" in again.summary.text()
    again.close()
    machine_doc.undo()
    pump(60)
    assert not obj.Stale
    again = task_limits.open_panel(machine)
    assert again.summary.text() == shown
    again.close()


def test_limits_are_typed_in_the_units_of_freecad(panel, machine):
    import FreeCAD as App

    panel.allowed.setValue(40.0)
    panel.compute()
    value = panel.data["quantile_um"]
    panel.close()
    old = App.Units.getSchema() if hasattr(App.Units, "getSchema") else 0
    App.Units.setSchema(3)  # inches
    try:
        again = task_limits.open_panel(machine)
        assert again.allowed.suffix().strip() == "µin" and again.allowed.value() == pytest.approx(40 / 0.0254, rel=1e-4)
        assert rows(again.figures)["quantile"].text(task_limits.LEVEL) == f"{value / 0.0254:.0f}"
        again.close()
    finally:
        App.Units.setSchema(old)


def test_the_report_is_that_of_the_verb(panel, monkeypatch, tmp_path):
    panel.compute()
    monkeypatch.setattr(window, "ask_folder", lambda _title: str(tmp_path))
    assert {p.name for p in panel.ask_report()} == {"limits.json", "contributions.csv", "report.html"}
    close_messages()
