# SPDX-License-Identifier: LGPL-2.1-or-later
"""The closed loop in the window: a foreign table in, fit, trace, the effect added, arrows of the rest, the report."""

from __future__ import annotations

import time

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import pytest

from sensworkbench.closedloop.trace import trace
from sensworkbench.document import closed_loop, extract, tree
from sensworkbench.formats import readings_csv
from sensworkbench.gui import colours, residuals, task_trace
from sensworkbench.gui import messages as gui_messages
from sensworkbench.gui.qt import QtGui, pump
from sensworkbench.gui.state import of as state_of
from sensworkbench.gui.task_readings import COLUMN, TaskReadings, data, import_readings

from ..document import simulated
from .conftest import close_messages, differences, look, messages, picture, rounded, run, screenshot, state
from .test_commands import active, click
from .test_panels import width  # noqa: F401 - room for the task panel

LOOP = {"Sens_Fit", "Sens_Trace", "Sens_AddEffect", "Sens_Residuals", "Sens_TraceReport", "Sens_Tables"}


@pytest.fixture
def measured(machine, tmp_path):
    return simulated.write(tmp_path / "measured.csv", simulated.table(extract.core_machine(machine)))


@pytest.fixture
def foreign(machine, tmp_path):
    """The same table as another program writes it: own names, semicolons, minutes, no word on signs."""
    rows = simulated.table(extract.core_machine(machine))
    rows[:, 3] /= 60
    names = ("Pos X [mm]", "Pos Y [mm]", "Pos Z [mm]", "Time (min)", "Temp Column [°C]", "Temp Ambient [°C]",
             "Error X [µm]", "Error Y [µm]", "Error Z [µm]")  # fmt: skip
    return simulated.write(tmp_path / "foreign.csv", rows, names, answers=(), separator=";")


_outcomes: dict = {}


@pytest.fixture
def traced(machine, measured):
    """(readings object, trace object); the search itself runs once for all tests, on the same machine."""
    core = extract.core_machine(machine)
    if not _outcomes:
        _outcomes["one"] = trace(core, readings_csv.load(measured))
    made = []

    def change():
        table = closed_loop.make_readings(machine, measured)
        made.extend((table, closed_loop.make_trace(machine, table, _outcomes["one"], core)))

    gui_messages.change(machine.Document, "Trace", change)
    pump(60)
    return made


def wait(panel, seconds: float = 240.0) -> None:
    """Let the window live until the panel's thread is done."""
    end = time.monotonic() + seconds
    while panel.task is not None and time.monotonic() < end:
        pump(40)
    assert panel.task is None, "still running"


def text(panel, page: str) -> str:
    return panel.pages[page].toPlainText()


def choose(field, value) -> None:
    field.setCurrentIndex(field.findData(value))


# -- readings ----------------------------------------------------------------------------------------------------------
def test_greyed_until_there_is_something_to_work_on(machine, measured):
    assert active("Sens_ImportReadings") and not any(active(n) for n in LOOP | {"Sens_SwitchEffect"})
    closed_loop.make_readings(machine, measured)
    assert {n for n in LOOP if active(n)} == {"Sens_Fit", "Sens_Trace"}


def test_a_foreign_table_is_understood_and_its_signs_are_asked(machine, machine_doc, foreign):
    undos = machine_doc.UndoCount
    panel = import_readings(machine, foreign)
    assert [g.column for g in panel.chosen()] == [
        "x_mm", "y_mm", "z_mm", "t_min", "temp_column_C", "temp_ambient_C", "ex_um", "ey_um", "ez_um"
    ]  # fmt: skip
    assert panel.columns.item(0, COLUMN).text() == "Pos X [mm]"
    screenshot("readings-asked")
    assert not panel.accept()
    assert any("signs" in m for m in messages())
    close_messages()
    assert not tree.readings_of(machine) and Gui.Control.activeDialog()
    choose(panel.answers["sign"], "compensation")
    choose(panel.answers["frame"], "tool_relative_to_workpiece")
    choose(panel.answers["positions"], "programmed")
    pump(400)
    assert any("sign of the readings is turned" in panel.remarks.item(i).text() for i in range(panel.remarks.count()))
    screenshot("readings")
    click("Ok")
    (table,) = tree.readings_of(machine)
    assert table.Rows == 480 and machine_doc.UndoCount == undos + 1
    assert "temp_column (K)" in table.Columns and "t (s)" in table.Columns
    rows = simulated.table(extract.core_machine(machine))
    np.testing.assert_allclose(closed_loop.read(table).value, -rows[:, 6:].ravel() * 1e-3, atol=1e-7)


def test_what_the_file_states_is_not_asked(machine, measured):
    panel = TaskReadings(machine, measured)
    assert not panel.answers and not panel.unanswered()
    assert panel.readings.rows == 480


def test_a_coordinate_without_a_column_is_given_by_hand(machine, tmp_path):
    rows = simulated.table(extract.core_machine(machine))
    path = simulated.write(tmp_path / "plane.csv", np.delete(rows, 2, axis=1), np.delete(simulated.NAMES, 2).tolist())
    panel = TaskReadings(machine, path)
    assert panel.missing() == ["z"]
    panel.constants["z"].setValue(42.5)
    panel.check()
    assert set(panel.readings.q[:, 2]) == {42.5}


def test_a_broken_cell_is_named_and_holds_ok_back(machine, tmp_path, measured):
    lines = measured.read_text(encoding="utf-8").splitlines()
    lines[30] = lines[30].replace(lines[30].split(",")[6], "oops")
    measured.write_text("\n".join(lines), encoding="utf-8")
    before = state(machine.Document)
    panel = import_readings(machine, measured)
    assert "line 31, column 7" in panel.note.text()
    assert not panel.accept()
    assert any("line 31" in m for m in messages())
    close_messages()
    click("Cancel")
    assert differences(before, state(machine.Document)) == []


def test_two_columns_for_the_same_are_refused(machine, foreign):
    panel = TaskReadings(machine, foreign)
    choose(panel.uses[1], "x")
    panel.check()
    assert "two columns" in panel.note.text()
    choose(panel.uses[1], "ignore")
    panel.check()
    assert panel.missing() == ["y"] and panel.mapping()["ignore"] == ["Pos Y [mm]"]
    assert data(panel.units[0]) == "mm"


def test_the_columns_of_imported_readings_are_chosen_again(machine, machine_doc, foreign):
    first = TaskReadings(machine, foreign)
    for key, value in (
        ("sign", "compensation"), ("frame", "tool_relative_to_workpiece"), ("positions", "programmed")
    ):  # fmt: skip
        choose(first.answers[key], value)
    table = closed_loop.make_readings(machine, foreign, first.mapping())
    machine_doc.recompute()
    wanted, undos = first.mapping(), machine_doc.UndoCount
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(table)
    run("Sens_EditReadings")
    panel = _panel()
    assert panel.imported == table and panel.mapping() == wanted and not panel.unanswered()
    choose(panel.uses[5], "ignore")  # the temperature of the room
    choose(panel.answers["sign"], "error")
    pump(400)
    click("Ok")
    assert tree.readings_of(machine) == [table] and machine_doc.UndoCount == undos + 1
    assert not any(c.startswith("temp_ambient") for c in table.Columns) and "temp_column (K)" in table.Columns
    rows = simulated.table(extract.core_machine(machine))
    np.testing.assert_allclose(closed_loop.read(table).value, rows[:, 6:].ravel() * 1e-3, atol=1e-7)
    machine_doc.undo()
    pump(60)
    assert any(c.startswith("temp_ambient") for c in table.Columns)


# -- fit and trace -----------------------------------------------------------------------------------------------------
def test_fit_then_trace_then_undo(machine, machine_doc, measured):
    closed_loop.make_readings(machine, measured)
    machine_doc.recompute()
    undos = machine_doc.UndoCount
    run("Sens_Fit")
    panel = _panel()
    wait(panel)
    assert "cannot be told apart" in text(panel, "Fit")
    assert "Not traced yet" in text(panel, "Result")
    assert not panel.add.isEnabled() and not panel.report.isEnabled()
    screenshot("trace-fit")
    panel.run.click()
    assert panel.stop.isVisible() and not active("Sens_Tolerances")
    pump(800)
    screenshot("trace-running")
    wait(panel)
    found = tree.trace_of(panel.table)
    assert found.Verdict == "explained" and machine_doc.UndoCount == undos + 1
    assert "Explained" in text(panel, "Result") and "temp_column" in text(panel, "Result")
    machine_doc.undo()
    pump(task_trace.WATCH + 200)
    assert tree.trace_of(panel.table) is None and "Not traced yet" in text(panel, "Result")
    click("Close")


def test_cancel_leaves_the_old_result(machine, machine_doc, traced):
    report, undos = traced[1].Report, machine_doc.UndoCount
    run("Sens_Trace")
    panel = _panel()
    wait(panel)
    panel.start()
    pump(150)
    panel.stop.click()
    assert panel.task is None and "Cancelled" in panel.note.text()
    pump(300)
    assert traced[1].Report == report and machine_doc.UndoCount == undos
    click("Close")


def test_closing_the_panel_stops_the_search(machine, machine_doc, measured):
    table = closed_loop.make_readings(machine, measured)
    panel = task_trace.open_panel(table)
    wait(panel)
    panel.start()
    task = panel.task
    click("Close")
    assert task.cancelled and not Gui.Control.activeDialog()
    task.thread.join(60)
    pump(200)
    assert tree.trace_of(table) is None


def test_the_pages_say_what_was_found(machine, traced, tmp_path, monkeypatch):
    run("Sens_Trace")
    panel = _panel()
    wait(panel)
    for name in panel.pages:
        panel.tabs.setCurrentWidget(panel.pages[name])
        pump(60)
        screenshot(f"trace-{name.lower()}")
        bar = panel.pages[name].verticalScrollBar()
        if bar.maximum() > 0:
            bar.setValue(bar.maximum())
            screenshot(f"trace-{name.lower()}-end")
    assert "EAZ" in text(panel, "Findings") and "µrad/K" in text(panel, "Findings")
    assert "p = " in text(panel, "Findings") and "half-samples" in text(panel, "Findings")
    assert "took no part in the fit" in text(panel, "BeforeAfter")
    assert "Not testable" in text(panel, "Next")
    assert panel.pages["Findings"]._pictures == 1 and panel.pages["BeforeAfter"]._pictures == 1
    monkeypatch.setattr(gui_messages, "ask_folder", lambda title: str(tmp_path / "out"))
    panel.report.click()
    assert {p.name for p in (tmp_path / "out").iterdir()} == {
        "trace.json", "report.html", "machine_augmented.json", "covariance.npz", "manifest.json"
    }  # fmt: skip
    close_messages()
    assert '<html lang="en">' in (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    monkeypatch.setattr(gui_messages, "ask_folder", lambda title: str(tmp_path / "german"))
    Gui.setLocale("German")
    try:
        panel.report.click()
        close_messages()
    finally:
        Gui.setLocale("English")
    report = (tmp_path / "german" / "report.html").read_text(encoding="utf-8")
    assert '<html lang="de">' in report and "<h2>Befunde</h2>" in report and "<h2>Findings</h2>" not in report
    click("Close")


def test_text_from_a_file_is_not_taken_for_markup(machine, traced):
    from sensworkbench.gui import trace_pages

    report = closed_loop.report_of(traced[1])
    report["effects"][0]["name"] = "<h1>big</h1><img src='x'>"
    del report["effects"][0]["name_message"]  # as in a file of an earlier version, whose words are shown as they are
    page = trace_pages.Page("Result")
    page.show_page(trace_pages.result_page(report, machine))
    assert "<h1>big</h1>" in page.toPlainText()


def _panel():
    """The panel that the last command opened."""
    return state_of(App.ActiveDocument).panel


# -- effects -----------------------------------------------------------------------------------------------------------
def test_effects_are_added_switched_off_and_removed(machine, machine_doc, traced):
    run("Sens_Sensitivity")
    pump(100)
    result = tree.sensitivity_of(machine)
    names = list(result.Symbols)
    before, undos = state(machine_doc), machine_doc.UndoCount
    run("Sens_AddEffect")
    pump(300)
    (effect,) = tree.effects_of(machine)
    assert machine_doc.UndoCount == undos + 1 and not active("Sens_AddEffect")
    assert effect.Label in result.Symbols  # coloured parts are computed again at once
    screenshot("effect-added")
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(effect)
    assert active("Sens_SwitchEffect")
    run("Sens_SwitchEffect")
    pump(300)
    assert not effect.Enabled and list(result.Symbols) == names
    run("Sens_SwitchEffect")
    pump(300)
    assert effect.Enabled and effect.Label in result.Symbols
    panel = task_trace.open_panel(traced[0])
    wait(panel)
    assert panel.add.text() == "Remove effects"
    panel.add.click()
    pump(300)
    assert not tree.effects_of(machine) and list(result.Symbols) == names
    click("Close")
    for _ in range(4):
        machine_doc.undo()
        pump(200)
    pump(400)
    after = [d for d in differences(before, state(machine_doc)) if "Sensitivity" not in d]
    assert after == [] and active("Sens_AddEffect")


# -- residuals ---------------------------------------------------------------------------------------------------------
def area(image, colour) -> int:
    """Pixels of about this colour."""
    count = 0
    for x in range(0, image.width(), 2):
        for y in range(0, image.height(), 2):
            seen = QtGui.QColor(image.pixel(x, y)).getRgbF()[:3]
            count += max(abs(a - b) for a, b in zip(seen, colour)) < 0.06
    return count


def camera(doc) -> float:
    """Height of what the view shows, mm."""
    return Gui.getDocument(doc.Name).activeView().getCameraNode().height.getValue()


def test_residuals_are_drawn_on_one_scale_and_go_again(machine, machine_doc, traced):
    plain = picture(machine_doc)
    run("Sens_Residuals")
    pump(150)
    view = traced[1].ViewObject
    arrows = view.Proxy.arrows
    assert view.ShowResiduals == residuals.BOTH and arrows.key.shown
    assert arrows.counts == {"Before": 160, "After": 160}
    both = picture(machine_doc)
    screenshot("residuals")
    before, after = area(both, residuals.BEFORE), area(both, residuals.AFTER)
    assert before > area(plain, residuals.BEFORE) + 200 and after > area(plain, residuals.AFTER) + 50
    height = camera(machine_doc)
    task_trace.zoom_to(traced[1])
    pump(600)
    assert camera(machine_doc) < 0.6 * height
    screenshot("residuals-near")
    view.ShowResiduals = "After"
    pump(150)
    assert area(picture(machine_doc), residuals.BEFORE) < before / 4
    screenshot("residuals-after")
    run("Sens_Residuals")
    pump(150)
    assert view.ShowResiduals == residuals.OFF and not arrows.key.shown
    assert picture(machine_doc) == plain
    machine_doc.undo()
    pump(150)
    assert view.ShowResiduals == "After" or machine_doc.RedoCount


def test_residuals_stand_where_the_tool_was_and_point_along_the_error(machine, traced):
    core = extract.core_machine(machine)
    q = np.array([[0.0, 0, 0], [10.0, -20.0, 30.0]])
    where = residuals.places(core, q)
    np.testing.assert_allclose(where[0], core.tool_point)
    np.testing.assert_allclose((where[1] - where[0]) @ core.frame, q[1], atol=1e-9)  # square axes
    points, faces = residuals.mesh(np.zeros((1, 3)), np.array([[0.0, 0.0, 5.0]]), 0.2)
    assert points[:, 2].max() == pytest.approx(5.0) and points[:, 2].min() == pytest.approx(0.0)
    assert faces.max() == len(points) - 1 and np.abs(points[:, :2]).max() < 1.0


def test_saved_and_opened_again_the_arrows_are_there(machine, machine_doc, traced, tmp_path):
    import FreeCAD as App

    run("Sens_Residuals")
    pump(100)
    path = str(tmp_path / "kept.FCStd")
    machine_doc.saveCopy(path)
    opened = App.openDocument(path)
    pump(300)
    (found,) = tree.traces_of(tree.machine_of(opened))
    assert found.ViewObject.ShowResiduals == residuals.BOTH
    assert found.ViewObject.Proxy.arrows.counts["Before"] == 160
    assert found.ViewObject.Proxy.doubleClicked(found.ViewObject)
    panel = _panel()
    wait(panel)
    assert "Explained" in text(panel, "Result")
    click("Close")


def test_an_augmented_document_from_a_batch_run_opens_with_colours_and_effect(machine, machine_doc, traced, tmp_path):
    """What the command line writes for a document, opened in the window."""
    import FreeCAD as App

    from sensworkbench.document import batch

    run("Sens_Sensitivity")
    pump(100)
    source, out = tmp_path / "machine.FCStd", tmp_path / "augmented.FCStd"
    machine_doc.saveCopy(str(source))
    with batch.open_document(source) as copy:
        batch.write_augmented(copy, out, _outcomes["one"].machine)
    opened = App.openDocument(str(out))
    pump(300)
    look(opened)
    found = tree.machine_of(opened)
    (effect,) = tree.effects_of(found)
    assert (effect.Component, effect.Enabled) == ("EAZ", True) and effect.ViewObject.Visibility
    assert tree.sensitivity_of(found).Coloured
    assert effect.Label in tree.sensitivity_of(found).Symbols  # computed again at once, with the effect in it
    seen = {one.Name: (one.ViewObject.Visibility, colours.read(one)) for one in opened.Objects if colours._can(one)}
    assert len(seen) > 20
    for name, (visible, _) in seen.items():
        assert visible == machine_doc.getObject(name).ViewObject.Visibility, name
    assert len({repr(rounded(colour)) for _, colour in seen.values()}) > 4
    screenshot("augmented-document")


# -- tables of a controller --------------------------------------------------------------------------------------------
def test_tables_are_written_once_errors_are_fitted(machine, machine_doc, traced, tmp_path, monkeypatch):
    from sensworkbench.formats.exchange import known
    from sensworkbench.gui import task_tables

    assert not active("Sens_Tables")
    task_trace.add_effects(traced[1])
    assert active("Sens_Tables")
    before, undos = state(machine_doc), machine_doc.UndoCount
    run("Sens_Tables")
    panel = state_of(App.ActiveDocument).panel
    assert isinstance(panel, task_tables.TaskTables)
    for name in (f.name for f in known.every() if f.takes_positions):
        choose(panel.format, name)
        said = panel.statement.toPlainText()
        assert "after compensation" in said and "temp_column" in said  # what no table of positions can hold is named
        folder = tmp_path / name
        monkeypatch.setattr(gui_messages, "ask_folder", lambda _title, folder=folder: str(folder))
        panel.write.click()
        assert {p.name for p in folder.iterdir()} == {*panel.written.files, "statement.txt", "manifest.json"}
        close_messages()
        assert (folder / "statement.txt").read_text(encoding="utf-8").rstrip() == said.rstrip()
    screenshot("tables")
    monkeypatch.setattr(gui_messages, "ask_folder", lambda _title: "")
    assert panel.ask_and_write() == []
    click("Close")
    assert differences(before, state(machine_doc)) == [] and machine_doc.UndoCount == undos
