# SPDX-License-Identifier: LGPL-2.1-or-later
"""What users of other programs expect: copy, a scale that stays, a question before overwriting, typed trials."""

from __future__ import annotations

import csv
import io

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import pytest

from sensworkbench.document import factory, tables, tree
from sensworkbench.formats.effects_json import of_parameters
from sensworkbench.gui import copying, display, export, review, texts
from sensworkbench.gui import messages as window
from sensworkbench.gui.qt import QtGui, main_window, pump
from sensworkbench.gui.state import of as state_of
from sensworkbench.gui.whatif import ERROR, SYMBOL

from .conftest import run


@pytest.fixture
def dock(machine):
    run("Sens_Sensitivity")
    return review.dock()


def test_the_ranking_is_copied_and_saved_as_csv(dock, machine, monkeypatch, tmp_path):
    table = dock.ranking.table
    dock.ranking.items()[2].setSelected(True)
    copying.copy(table)
    lines = QtGui.QApplication.clipboard().text().splitlines()
    assert len(lines) == 2 and lines[0].split("\t")[:5] == ["#", "Error", "Share", "Meaning", "Sᵀ"]
    symbol, share, _, total = lines[1].split("\t")[1:5]
    result = tree.sensitivity_of(machine)
    at = list(result.Symbols).index(symbol)
    assert float(total) == pytest.approx(result.Total[at], abs=5e-5)
    assert float(share) == pytest.approx((result.First[at] + result.Total[at]) / 2, rel=1e-5)
    path = tmp_path / "ranking.csv"
    monkeypatch.setattr(window, "ask_save", lambda *_: str(path))
    copying.ask_and_save(table, "ranking.csv")
    rows = list(csv.reader(io.StringIO(path.read_text(encoding="utf-8"))))
    assert len(rows) == 25 and {r[1] for r in rows[1:]} == set(result.Symbols)
    keys = [a.shortcut().toString() for a in table.actions()]
    assert "Ctrl+C" in keys


def test_effects_stand_in_the_ranking_by_component_and_driver(dock, machine, machine_doc):
    name = "thermal bending of the structure: Z carriage, rotation about X, driven by temp_column"
    parameters = {"coefficient": {"value": 2.5, "unit": "urad/K", "u": 0.1}, "extent": {"value": [-5.0, 12.5]}}
    factory.make_effect(machine, of_parameters(name, "EAZ", "temp_column", "linear", parameters))
    machine.touch()
    machine_doc.recompute()
    run("Sens_Sensitivity")
    assert texts.short_name(machine, name) == "EAZ × temp_column" and texts.meaning(machine, name) == name
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(next(e for e in tree.effects_of(machine) if e.Label == name))
    pump(30)
    assert [i.text(1) for i in dock.ranking.table.selectedItems()] == ["EAZ × temp_column"]
    for column in range(7):
        width = dock.ranking.table.columnWidth(column)
        assert width <= 135, (column, width)
    view = dock.ranking.table
    seen = view.header().sectionViewportPosition(2) + view.columnWidth(2)
    assert seen <= view.viewport().width()  # the total index is in sight


def test_a_typed_tolerance_and_a_limit_that_is_passed_or_failed(dock, machine):
    tab = dock.what_if
    item = next(tab.table.topLevelItem(i) for i in range(24) if tab.table.topLevelItem(i).data(ERROR, SYMBOL) == "EAZ")
    item.setSelected(True)
    tab.value.setText("±2 arcsec")
    tab.set_value()
    half = tables.read_tolerances(machine)["EAZ"].upper
    assert tab.changes["EAZ"] == pytest.approx(2 * np.pi / 180 / 3600 / half)
    tab.allowed.setValue(10.0)
    assert "fails" in tab.summary.text()
    tab.allowed.setValue(100.0)
    assert "passes" in tab.summary.text()
    tab.value.setText("seven")
    tab.set_value()
    assert "not a number" in tab.summary.text()
    tab.allowed.setValue(0.0)
    tab.reset()


def test_rows_of_what_if_point_at_their_parts(dock, machine):
    tab = dock.what_if
    item = next(tab.table.topLevelItem(i) for i in range(24) if tab.table.topLevelItem(i).data(ERROR, SYMBOL) == "EBY")
    item.setSelected(True)
    pump(20)
    assert machine.ViewObject.Proxy.arrows.outlined
    assert Gui.Selection.getSelection() == [tree.axis_of(machine, "Y")]


def test_the_range_of_colours_stays_until_it_is_computed_anew(dock, machine, machine_doc):
    result = tree.sensitivity_of(machine)
    before = display.scale(result)
    found = tables.read_tolerances(machine)
    wide = found | {s: t.scaled(1.3) for s, t in found.items() if s == "EAZ"}
    machine_doc.openTransaction("edit")
    factory.set_tolerances(machine, wide)
    machine.touch()
    machine_doc.recompute()
    machine_doc.commitTransaction()
    pump(200)
    assert not result.Stale and max(display.values(result).values()) > 0.4 * before.upper
    assert display.scale(result).upper == before.upper
    run("Sens_Sensitivity")
    assert state_of(machine_doc).ranges


def test_slices_of_the_error_map_share_one_scale(dock, machine):
    view = tree.sensitivity_of(machine).ViewObject
    view.ShowErrorMap = True
    view.ErrorMapAs = "Slice Z"
    scales = []
    for at in (-150.0, 150.0):
        view.ErrorMapAt = at
        pump(60)
        scale = view.Proxy.map.drawn[1]
        scales.append((scale.lower, scale.upper))
    assert scales[0] == scales[1] and scales[0][0] < scales[0][1]
    assert view.Proxy.map.drawn[1].name != view.ColourMap  # yellow is a share here, a length there


def test_nothing_is_overwritten_without_a_question(dock, machine, monkeypatch, tmp_path):
    monkeypatch.setattr(window, "ask_folder", lambda _title: str(tmp_path))
    export.ask_and_export(machine)
    close_written()
    first = (tmp_path / "report.html").stat().st_mtime_ns
    asked = []
    monkeypatch.setattr(window, "run", lambda box: asked.append(box.text()) or QtGui.QMessageBox.No)
    export.ask_and_export(machine)
    assert "report.html" in asked[0] and (tmp_path / "report.html").stat().st_mtime_ns == first
    monkeypatch.setattr(window, "run", lambda box: QtGui.QMessageBox.Yes)
    export.ask_and_export(machine)
    assert (tmp_path / "report.html").stat().st_mtime_ns > first
    close_written()


def close_written():
    boxes = main_window().findChildren(QtGui.QMessageBox, "SensWritten")
    assert boxes and "report.html" in boxes[0].text()
    for box in boxes:
        box.close()
    pump(20)


def test_original_colours_come_and_go(dock, machine):
    result = tree.sensitivity_of(machine)
    run("Sens_OriginalColours")
    assert not result.Coloured
    run("Sens_OriginalColours")
    pump(50)
    assert result.Coloured


def test_lengths_follow_the_units_of_freecad(machine):
    import FreeCAD as App

    assert texts.length(612.84) == "612.8 mm" and texts.fixed(-0.01, 1) == "0.0"
    old = App.Units.getSchema() if hasattr(App.Units, "getSchema") else 0
    App.Units.setSchema(3)  # inches
    try:
        assert texts.length(25.4) == "1.000 in"
        assert texts.point_text((25.4, 0.0, -50.8)) == "x 1.000   y 0.000   z -2.000 in"
    finally:
        App.Units.setSchema(old)


@pytest.mark.parametrize("schema, shown, typed, lies", [(0, "120.5", "80", 80.0), (3, "4.74", "2", 50.8)])
def test_lengths_are_shown_and_read_as_the_preferences_say(machine, schema, shown, typed, lies):
    from sensworkbench.gui.preferences import length_box
    from sensworkbench.gui.texts import span_text

    App.Units.setSchema(schema)
    try:
        box = length_box(-500.0, 500.0, 1)
        box.setValue(120.5)
        assert box.value() == 120.5 and box.cleanText().startswith(shown)
        assert box.suffix() == (" mm" if schema == 0 else " in")
        box.lineEdit().setText(typed + box.suffix())
        box.interpretText()
        assert box.value() == pytest.approx(lies)
        assert span_text(-50.8, 127) == ("-50.8 … 127 mm" if schema == 0 else "-2 … 5 in")
    finally:
        App.Units.setSchema(0)
