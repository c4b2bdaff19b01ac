# SPDX-License-Identifier: LGPL-2.1-or-later
"""A damaged machine says so when it is opened, in the tree and in every refusal, and one command mends it."""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui
import pytest

from sensworkbench.document import base, repair, tree
from sensworkbench.gui.qt import QtGui, main_window, pump
from sensworkbench.gui.task_repair import open_panel

from .conftest import close_messages, differences, look, messages, picture, run, screenshot, state
from .test_commands import active, click


def open_form():
    """The panel of the repair that stands on the screen, or None."""
    return next((w for w in main_window().findChildren(QtGui.QWidget, "SensRepair") if w.isVisible()), None)


def shown(form) -> list[str]:
    table = form.findChild(QtGui.QListWidget, "SensFindings")
    return [table.item(r).text() for r in range(table.count())]


def entries(obj) -> list[str]:
    menu = QtGui.QMenu()
    obj.ViewObject.Proxy.setupContextMenu(obj.ViewObject, menu)
    return [a.text() for a in menu.actions()]


@pytest.fixture
def damaged(machine, tmp_path):
    """The machine as it is opened again after FreeCAD saved it without the add-on; its tolerance table is cut off."""
    run("Sens_Sensitivity")
    pump(100)
    doc = machine.Document
    table = tree.tolerances_of(machine)
    table.Lower = list(table.Lower)[:5]
    for obj in doc.Objects:
        if base.kind_of(obj):
            obj.Proxy = None
            obj.ViewObject.Proxy = None
    path = str(tmp_path / "damaged.FCStd")
    doc.saveAs(path)
    App.closeDocument(doc.Name)
    pump(50)
    opened = App.openDocument(path)
    opened.UndoMode = 1
    pump(400)
    look(opened)
    return tree.machine_of(opened)


def test_a_sound_machine_has_nothing_to_repair(machine, machine_doc):
    assert active("Sens_Repair")
    before, undos = state(machine_doc), machine_doc.UndoCount
    run("Sens_Repair")
    form = open_form()
    assert shown(form) == []
    assert "Nothing is wrong" in form.findChild(QtGui.QLabel, "SensNote").text()
    assert not next(b for b in form.findChildren(QtGui.QPushButton)).isEnabled()
    assert not active("Sens_Repair")
    click("Close")
    assert differences(before, state(machine_doc)) == [] and machine_doc.UndoCount == undos
    assert not any("Repair" in text for text in entries(machine))


def test_greyed_where_there_is_nothing_to_examine(doc, workbench):
    doc.addObject("Part::Box", "Box")
    doc.addObject("App::FeaturePython", "Foreign")
    assert not active("Sens_Repair")


def test_a_damaged_document_says_so_once_and_opens_the_repair(damaged):
    assert len(messages()) == 1
    assert "Axis" in messages()[0] or "Machine" in messages()[0]
    assert "Repair Machine…" in messages()[0]
    screenshot("repair-message")
    button = next(b for b in main_window().findChildren(QtGui.QPushButton, "SensRepairNow") if b.isVisible())
    button.click()
    pump(60)
    assert open_form() is not None and messages() == []
    click("Close")
    App.setActiveDocument(damaged.Document.Name)
    pump(60)
    assert messages() == []


def test_damaged_objects_show_it_in_the_tree_and_offer_the_repair(damaged):
    close_messages()
    doc = damaged.Document
    axis = tree.axis_of(damaged, "X")
    sick = axis.ViewObject.Icon.pixmap(32, 32).toImage()
    for obj in (damaged, axis, tree.tolerances_of(damaged), tree.body_of(damaged, "T")):
        assert not base.alive(obj)
        assert any("Repair" in text for text in entries(obj)), obj.Label
    assert axis.ViewObject.Proxy.doubleClicked(axis.ViewObject)
    pump(60)
    rows = shown(open_form())
    assert {row.split(":")[0] for row in rows} >= {damaged.Label, "Axis X", "Tolerances"}
    assert any(row.startswith("Tolerances: its lists differ in length") for row in rows)
    assert any(row.startswith("Axis X: it was saved without Sens Workbench") for row in rows)
    screenshot("repair")
    undos = doc.UndoCount
    next(b for b in open_form().findChildren(QtGui.QPushButton)).click()
    pump(100)
    assert shown(open_form()) == [] and repair.examine(doc) == []
    assert f"{len(rows)} repaired" in open_form().findChild(QtGui.QLabel, "SensNote").text()
    assert doc.UndoCount == undos + 1
    screenshot("repair-done")
    click("Close")
    assert axis.ViewObject.Icon.pixmap(32, 32).toImage() != sick
    assert "Repair" not in " ".join(entries(axis))
    axis.Position = 30.0
    assert axis.StandsAt == 30.0


def test_a_repaired_result_shows_its_colours_and_legend_again(damaged):
    close_messages()
    result = tree.sensitivity_of(damaged)
    open_panel(damaged.Document).mend.click()
    click("Close")
    run("Sens_Sensitivity")
    assert messages() == [] and not result.Stale and result.Coloured
    with_legend = picture(damaged.Document)
    result.ViewObject.Visibility = False
    pump(100)
    assert picture(damaged.Document) != with_legend
    result.ViewObject.Visibility = True
    pump(100)
    assert picture(damaged.Document) == with_legend
    screenshot("repair-legend")


def test_undo_of_a_repair_brings_the_damage_back_and_redo_mends_it(machine):
    doc = machine.Document
    table = tree.tolerances_of(machine)
    kept = list(table.Upper)
    table.Lower = list(table.Lower)[:5]
    machine.removeProperty("Order")
    found = [f.message for f in repair.examine(doc)]
    panel = open_panel(doc)
    panel.mend.click()
    pump(60)
    click("Close")
    assert repair.examine(doc) == [] and machine.Order == 8
    doc.undo()
    pump(100)
    assert [f.message for f in repair.examine(doc)] == found and list(table.Upper) == kept
    doc.redo()
    pump(100)
    assert repair.examine(doc) == []


def test_a_refusal_names_the_command_where_it_would_help(machine):
    table = tree.tolerances_of(machine)
    table.Lower = list(table.Lower)[:5]
    machine.Document.recompute()
    run("Sens_Sensitivity")
    assert len(messages()) == 1 and "Repair Machine…" in messages()[0]
    close_messages()
    repair.repair(machine.Document)
    machine.ToolPoint = None
    machine.Document.recompute()
    run("Sens_Sensitivity")
    assert "tool point is missing" in messages()[0] and "Repair Machine" not in messages()[0]
    close_messages()


def test_what_only_the_user_can_settle_stays_in_the_list_and_selects_its_object(machine):
    machine.ToolPoint = None
    machine.Document.recompute()
    panel = open_panel(machine.Document)
    assert not panel.mend.isEnabled() and "only you can settle" in panel.note.text()
    row = shown(panel.form).index(f"{machine.Label}: its tool point is missing. Choose a point at the tool's tip.")
    panel.table.setCurrentRow(row)
    assert Gui.Selection.getSelection() == [machine]
    click("Close")
    texts = entries(machine)
    assert texts[0].startswith("Edit") and "Repair" in texts[-1]  # a double click still edits
