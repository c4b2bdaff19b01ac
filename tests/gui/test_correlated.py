# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of correlated tolerances: sources declared, changed and removed; a covariance, or the reason against it."""

from __future__ import annotations

from pathlib import Path

import pytest

from sensworkbench.core.fitted import DECLARED, Constant, FittedModel, uncertainty_of
from sensworkbench.document import base, extract, studies, tables, tree
from sensworkbench.formats import correlated_files, fitted_json
from sensworkbench.gui import messages as window
from sensworkbench.gui import review, task_correlated
from sensworkbench.gui.files import RESOURCES
from sensworkbench.gui.qt import Qt, pump
from sensworkbench.studies.correlated import correlated_study

from .conftest import close_messages, differences, messages, rows, screenshot, state, study

TRACED = Path(__file__).resolve().parents[1] / "data" / "schema-1-traced.FCStd"


@pytest.fixture
def panel(machine, machine_doc):
    with study(task_correlated.open_panel, machine) as made:
        yield made


def tick(panel, symbol, factor=None):
    item = rows(panel.factors)[symbol]
    item.setCheckState(task_correlated.ERROR, Qt.Checked)
    if factor is not None:
        item.setText(task_correlated.FACTOR, factor)
    return item


def declare_rail(panel):
    panel.new()
    panel.title.setText("rail of Y")
    tick(panel, "EZY")
    tick(panel, "EAY", "-12 µrad")
    assert panel.declare()
    pump(60)


def test_a_source_is_declared_in_one_step_and_ranked(panel, machine, machine_doc):
    before, undos = state(machine_doc), machine_doc.UndoCount
    half = tables.read_tolerances(machine)["EZY"].upper
    declare_rail(panel)
    assert machine_doc.UndoCount == undos + 1
    (source,) = extract.core_machine(machine).sources
    assert source.name == "rail of Y" and source.factors == pytest.approx({"EZY": half, "EAY": -12e-6})
    assert "EZY" not in tables.read_tolerances(machine)
    result = tree.sensitivity_of(machine)
    assert not result.Stale and "rail of Y" in result.Symbols
    share = (result.First[-1] + result.Total[-1]) / 2
    assert rows(panel.list)["rail of Y"].text(task_correlated.SHARE) == f"{100 * share:.1f} %"
    ranking = review.dock().ranking
    shown = {item.text(1): item for item in ranking.items()}
    assert "EZY" in shown["rail of Y"].text(7) and "EAY" in shown["rail of Y"].text(7)
    screenshot("correlated")
    machine_doc.undo()
    pump(100)
    assert differences(before, state(machine_doc)) == []


def test_a_source_is_changed_and_removed_in_one_step_each(panel, machine, machine_doc):
    declare_rail(panel)
    rows(panel.list)["rail of Y"].setSelected(True)
    pump(30)
    assert panel.title.text() == "rail of Y" and panel.remove_button.isEnabled()
    undos = machine_doc.UndoCount
    rows(panel.factors)["EZY"].setCheckState(task_correlated.ERROR, Qt.Unchecked)
    panel.title.setText("guide of Y")
    assert panel.declare() and machine_doc.UndoCount == undos + 1
    (source,) = extract.core_machine(machine).sources
    assert source.name == "guide of Y" and list(source.factors) == ["EAY"]
    assert tables.read_tolerances(machine)["EZY"].upper == pytest.approx(5e-3)
    panel.remove()
    assert machine_doc.UndoCount == undos + 2 and not extract.core_machine(machine).sources
    assert tables.read_tolerances(machine)["EAY"].upper == pytest.approx(12e-6)
    assert not rows(panel.list) and not panel.remove_button.isEnabled()


def test_what_is_wrong_with_a_source_is_said(panel, machine, machine_doc):
    before = state(machine_doc)
    for title, symbol, factor in (("", "EXX", "1"), ("EXX", "EXX", "1"), ("a", None, ""), ("a", "EXX", "three")):
        panel.new()
        panel.title.setText(title)
        if symbol:
            tick(panel, symbol, factor)
        assert not panel.declare() and messages()
        close_messages()
    assert differences(before, state(machine_doc)) == []


def test_shares_for_a_covariance_are_those_of_the_study(panel, machine, monkeypatch, tmp_path):
    panel.tabs.setCurrentIndex(1)
    assert not panel.compute() and "covariance" in panel.summary.text()  # neither a file nor a fit
    path = f"{RESOURCES}/examples/covariance.csv"
    panel.load_covariance(path)
    assert panel.compute()
    core = extract.core_machine(machine)
    known = correlated_files.to_dict(correlated_study(core, correlated_files.load(path, core)))
    assert panel.data == known == studies.read(studies.study_of(machine, "correlated"))[1]
    first = panel.shares.topLevelItem(0)
    assert first.data(task_correlated.PART, Qt.UserRole) == pytest.approx(known["components"][0]["share"])
    screenshot("covariance")
    monkeypatch.setattr(window, "ask_folder", lambda _title: str(tmp_path))
    assert {p.name for p in panel.ask_report()} == {"correlated.json", "correlated.csv", "report.html"}
    close_messages()


def test_a_matrix_that_is_no_covariance_is_refused_with_a_remedy(panel, tmp_path):
    path = tmp_path / "wrong.csv"
    path.write_text("symbol,EXX,EYX,EZX\nEXX,1,.9,-.9\nEYX,.9,1,.9\nEZX,-.9,.9,1\n", encoding="utf-8")
    panel.load_covariance(path)
    assert "contradict" in messages()[0] and panel.covariance is None and panel.path == ""
    close_messages()


def test_the_covariance_of_a_fit_says_what_to_measure_next(machine, machine_doc):
    known = uncertainty_of([(DECLARED, "C0Y", 1), (DECLARED, "A0Z", 1)], [[1e-6, 0.0], [2e-6, 3e-6]])
    fitted = FittedModel(constants={"C0Y": Constant(1e-5), "A0Z": Constant(-2e-5)}, uncertainty=known)
    machine_doc.openTransaction("fit")
    base.put(machine, "Fitted", fitted_json.dumps(fitted))
    machine.touch()
    machine_doc.recompute()
    machine_doc.commitTransaction()
    made = task_correlated.open_panel(machine)
    made.tabs.setCurrentIndex(1)
    assert "fit" in made.given.text() and made.compute()
    study = correlated_study(extract.core_machine(machine))
    assert made.data == correlated_files.to_dict(study) and study.of_fit
    first = made.data["components"][0]
    assert first["body"] == "Z" and f"Measure Axis Z further: it holds {100 * first['share']:.0f} %" in (
        made.summary.text()
    )
    made.close()
    wider = uncertainty_of([(DECLARED, "C0Y", 1)], [[9e-6]])
    base.put(machine, "Fitted", fitted_json.dumps(FittedModel(constants=fitted.constants, uncertainty=wider)))
    machine.touch()
    machine_doc.recompute()
    made = task_correlated.open_panel(machine)
    made.tabs.setCurrentIndex(1)
    assert made.outdated(studies.read(studies.study_of(machine, "correlated"))[0])
    made.close()
