# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every command says what it is, is greyed where it cannot work, is one undo step, and leaves no trace on Cancel."""

from __future__ import annotations

import time
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import pytest

from sensworkbench.document import tree
from sensworkbench.gui import commands
from sensworkbench.gui.command import GROUPS, NEEDS, REGISTRY
from sensworkbench.gui.files import ROOT as FOLDER
from sensworkbench.gui.qt import QtGui, pump

from .conftest import close_messages, differences, messages, run, screenshot, state

ROOT = Path(FOLDER)


def needing(*kinds: str) -> list:
    """Names of the commands that need one of these; those behind the button of another one apart."""
    return [c.name for c in REGISTRY.values() if c.needs in kinds and c.name not in commands.inside()]


def active(name: str) -> bool:
    return bool(REGISTRY[name].IsActive())


def test_every_command_has_icon_text_tips_and_a_section_of_the_guide(workbench):
    guide = (ROOT / "docs" / "guide.md").read_text(encoding="utf-8")
    headings = {line.lstrip("# ") for line in guide.splitlines() if line.startswith("#")}
    keys = [c.keys for c in REGISTRY.values() if c.keys]
    assert len(set(keys)) == len(keys)
    for command in REGISTRY.values():
        found = command.GetResources()
        for key in ("MenuText", "ToolTip", "StatusTip", "WhatsThis"):
            assert found[key], (command.name, key)
        assert command.name.startswith("Sens_")
        drawn = QtGui.QIcon(found["Pixmap"]).pixmap(16, 16).toImage()
        assert len({drawn.pixel(x, y) for x in range(16) for y in range(16)}) > 2, command.name
        assert command.name in Gui.listCommands()
        assert command.guide in headings, command.name
        assert command.where.group in GROUPS and command.needs in NEEDS, command.name


def test_the_order_of_the_work_is_that_of_menu_and_toolbars(workbench):
    entries = [n for n in commands.menu() if n != "Separator"]
    assert len(set(entries)) == len(entries)
    assert set(entries) | commands.inside() == {c.name for c in REGISTRY.values() if not c.hidden}
    ranks = [(c.where.group, c.where.rank) for c in REGISTRY.values()]
    assert len(set(ranks)) == len(ranks)
    assert entries[0] == "Sens_Machine" and entries.index("Sens_Tolerances") < entries.index("Sens_Sensitivity")
    titles = [title for title, _ in commands.toolbars()]
    assert titles == ["Sens Machine", "Sens Analysis", "Sens Closed Loop"]
    assert all(n in entries for _, names in commands.toolbars() for n in names)


def test_the_table_of_commands_in_the_guide_is_that_of_the_registry(workbench):
    guide = (ROOT / "docs" / "guide.md").read_text(encoding="utf-8")
    assert commands.markdown() in guide, commands.markdown()


def test_without_a_document_only_examples_can_be_made(workbench):
    for name in list(App.listDocuments()):
        App.closeDocument(name)
    possible = {c.name for c in REGISTRY.values() if c.IsActive()}
    assert possible == {c.name for c in REGISTRY.values() if c.needs == "nothing"}
    assert {"Sens_Example", "Sens_ExampleXYFZ"} <= possible and "Sens_Machine" not in possible


def test_greyed_until_there_is_what_they_need(doc, workbench):
    assert active("Sens_Machine")
    assert not any(active(n) for kind in NEEDS if kind not in ("nothing", "document") for n in needing(kind))


def test_the_first_steps_are_offered_until_there_is_a_machine(doc, workbench):
    from sensworkbench.gui import first_steps

    box = first_steps.Begin()
    assert box.shouldShow() and set(box.commands) <= set(REGISTRY)
    run("Sens_ExampleXYFZ")
    assert not box.shouldShow()
    App.ActiveDocument.undo()
    assert box.shouldShow()


def test_with_a_machine(machine, machine_doc):
    assert all(active(n) for n in needing("machine"))
    assert not any(active(n) for n in needing("result", "colours"))
    run("Sens_Sensitivity")
    assert all(active(n) for n in needing("result", "colours"))


@pytest.mark.parametrize("command", ["Sens_Tolerances", "Sens_EditMachine", "Sens_Jog"])
def test_cancel_leaves_the_document_as_it_was(machine, machine_doc, command):
    run("Sens_Sensitivity")
    pump(50)
    before, undos = state(machine_doc), machine_doc.UndoCount
    run(command)
    panel = Gui.Control.activeTaskDialog() if hasattr(Gui.Control, "activeTaskDialog") else None
    assert Gui.Control.activeDialog(), panel
    assert not active("Sens_Tolerances")  # greyed while a panel is open
    run_reject()
    assert not Gui.Control.activeDialog()
    assert differences(before, state(machine_doc)) == []
    assert machine_doc.UndoCount == undos


def run_reject():
    """Click Cancel in the task panel."""
    click("Cancel")


def click(text: str) -> None:
    """Click a button of a panel or message; on a busy machine a panel takes a while to appear."""
    from sensworkbench.gui.qt import main_window

    end = time.monotonic() + 10
    while time.monotonic() < end:
        pump(60)
        for box in main_window().findChildren(QtGui.QDialogButtonBox):
            button = box.button(getattr(QtGui.QDialogButtonBox, text))
            if button is not None and button.isVisible():
                button.click()
                pump(80)
                return
    raise AssertionError(f"no visible {text} button")


@pytest.mark.parametrize("code", ["XYFZ", "FXYZ", "YFXZ"])
def test_an_example_is_one_undo_step(doc, workbench, code):
    run(f"Sens_Example{code}")
    machine = tree.machine_of(App.ActiveDocument)
    assert machine.Structure == code and not machine.Problem
    run("Sens_Sensitivity")
    screenshot(f"example-{code}")
    App.ActiveDocument.undo()
    App.ActiveDocument.undo()
    pump(50)
    assert not App.ActiveDocument.Objects


def test_a_document_without_a_machine_is_refused_with_one_message(doc, workbench):
    REGISTRY["Sens_Sensitivity"].Activated()
    assert len(messages()) == 1 and "holds no machine" in messages()[0]
    close_messages()
    assert not doc.Objects


def test_a_broken_machine_is_refused_and_stays(machine, machine_doc):
    machine.ToolPoint = None
    machine_doc.recompute()
    before = state(machine_doc)
    run("Sens_Sensitivity")
    assert any("tool point is missing" in m for m in messages())
    close_messages()
    assert differences(before, state(machine_doc)) == []


def own_icon(obj) -> bool:
    """Whether the tree shows our drawing, not the folder or block of FreeCAD's own groups and features."""
    shown = obj.ViewObject.Icon.pixmap(64, 64).toImage()
    plain = obj.Document.addObject(obj.TypeId, "Plain")
    bare = plain.ViewObject.Icon.pixmap(64, 64).toImage()
    obj.Document.removeObject(plain.Name)
    return not shown.isNull() and shown != bare


def test_double_click_and_context_menu_open_the_panel(machine, machine_doc):

    for obj in (machine, tree.axis_of(machine, "X"), tree.tolerances_of(machine), tree.body_of(machine, "T")):
        view = obj.ViewObject
        assert own_icon(obj), obj.Label
        menu = QtGui.QMenu()
        view.Proxy.setupContextMenu(view, menu)
        assert menu.actions() and all(a.text() for a in menu.actions())
        assert view.Proxy.doubleClicked(view)
        pump(40)
        assert Gui.Control.activeDialog()
        run_reject()
