# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that allocates tolerances: before and after, applied and taken back by one click each."""

from __future__ import annotations

import pytest

from sensworkbench.document import extract, tables, tree
from sensworkbench.gui import messages as window
from sensworkbench.gui import task_allocation
from sensworkbench.gui.qt import pump
from sensworkbench.studies.allocation import Target, allocation_study

from .conftest import close_messages, differences, messages, screenshot, state, study


@pytest.fixture
def panel(machine, machine_doc):
    with study(task_allocation.open_panel, machine) as made:
        yield made


def test_it_shows_what_the_study_finds(panel, machine):
    target = panel.value.value()
    assert 0 < target < extract.objective(machine).size_shown(tree.sensitivity_of(machine).MeanSquare)
    panel.compute()
    core = extract.core_machine(machine)
    known = allocation_study(core, Target("rms", target), task_allocation.present_costs(core))
    assert panel.table.topLevelItemCount() == len(known.choices) == 24
    shown = {panel.table.topLevelItem(i).text(task_allocation.ERROR): panel.table.topLevelItem(i) for i in range(24)}
    for choice in known.choices:
        width = shown[choice.symbol].data(task_allocation.AFTER, task_allocation.Qt.UserRole)
        assert width == pytest.approx(choice.after.upper - choice.after.lower, rel=1e-6)
    assert f"{known.rms_before_um:.3g} → {known.rms_after_um:.3g}" in panel.summary.text()
    assert known.rms_after_um == pytest.approx(target, rel=1e-3)
    screenshot("allocation")
    panel.value.setValue(target * 1.1)  # another question: the old answer is gone
    assert panel.found is None and panel.table.topLevelItemCount() == 0 and not panel.apply_button.isEnabled()


def test_one_click_applies_and_one_takes_back(panel, machine, machine_doc):
    before, undos = state(machine_doc), machine_doc.UndoCount
    mean_square = tree.sensitivity_of(machine).MeanSquare
    panel.compute()
    assert differences(before, state(machine_doc)) == []
    panel.apply_button.click()
    pump(60)
    assert machine_doc.UndoCount == undos + 1 and not panel.apply_button.isEnabled()
    found = tables.read_tolerances(machine)
    for choice in panel.found.choices:
        assert found[choice.symbol].upper == pytest.approx(choice.after.upper, rel=1e-9)
    result = tree.sensitivity_of(machine)
    assert not result.Stale and result.MeanSquare < mean_square
    panel.undo_button.click()
    pump(100)
    assert differences(before, state(machine_doc)) == [] and panel.apply_button.isEnabled()


def test_what_cannot_be_met_is_said_in_the_panel(panel, monkeypatch):
    panel.value.setValue(0.001)
    panel.compute()
    assert panel.found is None and panel.summary.text().strip() and panel.table.topLevelItemCount() == 0
    assert not panel.apply_button.isEnabled() and not messages()


def test_prices_of_a_file_are_used_and_its_faults_are_said(panel, tmp_path, monkeypatch):
    path = tmp_path / "prices.csv"
    path.write_text("symbol,kind,grade,w,cost\nEAZ,grades,coarse,20,1\nEAZ,grades,fine,2,5\n", encoding="utf-8")
    panel.load_costs(path)
    assert list(panel.costs) == ["EAZ"] and panel.prices.text() == "prices.csv"
    panel.value.setValue(1000.0)
    panel.compute()
    assert [c.grade for c in panel.found.choices] == ["coarse"]
    monkeypatch.setattr(window, "ask_folder", lambda _title: str(tmp_path))
    assert {p.name for p in panel.ask_report()} >= {"allocation.json", "tolerances.csv", "report.html"}
    close_messages()
    path.write_text("symbol,kind\nNOSUCH,power\n", encoding="utf-8")
    panel.load_costs(path)
    assert messages()
    close_messages()
    assert list(panel.costs) == ["EAZ"]


def test_the_catalogue_offers_grades_where_it_has_them(panel):
    panel.catalogue.click()
    panel.compute()
    grades = {c.symbol: c.grade for c in panel.found.choices}
    assert len(grades) == 24 and grades["EYX"].startswith("guide ") and not grades["EAZ"]
    assert grades["EXX"].startswith(("screw ", "scale "))
    assert not panel.table.isColumnHidden(task_allocation.GRADE) and "catalogue" in panel.prices.text()
    shown = {panel.table.topLevelItem(i).text(task_allocation.GRADE) for i in range(24)}
    assert grades["EYX"] in shown
    screenshot("allocation-catalogue")
