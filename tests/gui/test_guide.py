# SPDX-License-Identifier: LGPL-2.1-or-later
"""Help without a network: the guide opens at the section of a command, from the menu, by F1 and by What's This."""

from __future__ import annotations

import pytest

from sensworkbench.gui import guide, state
from sensworkbench.gui.command import REGISTRY
from sensworkbench.gui.qt import Qt, QtCore, QtGui, main_window, pump

from .conftest import run
from .test_commands import click


@pytest.fixture(autouse=True)
def closed():
    yield
    found = main_window().findChild(QtGui.QWidget, guide.NAME)
    if found is not None:
        found.close()
        pump(20)


def test_the_guide_opens_at_the_section_of_every_command(workbench):
    for command in REGISTRY.values():
        found = guide.show(command.guide)
        assert found.section() == command.guide, command.name
    run("Sens_Guide")
    assert found.isVisible() and found.section() == "A review, step by step"
    assert "Abbe offset" in found.text.toPlainText()


def press(widget, key) -> None:
    for kind in (QtCore.QEvent.ShortcutOverride, QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
        QtGui.QApplication.sendEvent(widget, QtGui.QKeyEvent(kind, key, Qt.NoModifier))


def test_f1_in_a_panel_shows_its_section(machine, machine_doc):
    run("Sens_Tolerances")
    press(state.of(machine_doc).panel.form, Qt.Key_F1)
    found = main_window().findChild(QtGui.QWidget, guide.NAME)
    assert found.isVisible() and found.section() == "2. Tolerances"
    click("Cancel")


def test_whats_this_on_a_command_shows_its_section(workbench):
    event = QtGui.QWhatsThisClickedEvent("Sens_Jog")
    assert QtGui.QApplication.sendEvent(main_window(), event)
    found = main_window().findChild(QtGui.QWidget, guide.NAME)
    assert found is not None and found.section() == "5. Jog"


def test_links_between_pages_are_followed(workbench):
    found = guide.show()
    found._followed(QtCore.QUrl("tracing.md#the-words"))
    assert (found.page, found.section()) == ("tracing.md", "The words")
    assert not found.open("../secret.md") and not found.open("nowhere.md")
