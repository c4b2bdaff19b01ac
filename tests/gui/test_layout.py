# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every panel fits the place it stands in: nothing is cut, the first and the last control can be seen.

`make screens` runs this file for screens of several sizes, in both themes, and leaves the pictures in build/screens.
"""

from __future__ import annotations

import os
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import pytest

from sensworkbench.document import extract, tree
from sensworkbench.gui import review, task_machine, task_readings, task_tables, task_trace
from sensworkbench.gui.panel import Filler
from sensworkbench.gui.qt import Qt, QtGui, main_window, pump
from sensworkbench.gui.state import of as state_of

from ..document import simulated
from .conftest import look, run, screenshot
from .test_panels import loose_parts

TRACED = Path(__file__).resolve().parents[1] / "data" / "schema-1-traced.FCStd"
OVERLAY = 388  # pixels that FreeCAD 1.1 gives to Tasks beside the 3D view
LANGUAGES = ("English", "German", "Korean")


def name_of(what: str) -> str:
    size = os.environ.get("SENS_SCREEN", "1280x1024")
    return "-".join(filter(None, [what, size, os.environ.get("SENS_THEME", ""), os.environ.get("QT_SCALE_FACTOR", "")]))


@pytest.fixture(autouse=True)
def whole_screen(workbench):
    """The window as large as the screen, Tasks as wide as FreeCAD 1.1 makes it."""
    window = main_window()
    window.setGeometry(QtGui.QApplication.primaryScreen().availableGeometry())
    pump(50)
    docks = [d for d in window.findChildren(QtGui.QDockWidget) if d.objectName() in ("Combo View", "Tasks")]
    if docks:
        window.resizeDocks(docks[:1], [OVERLAY], Qt.Horizontal)
    pump(50)
    forget_dock()
    yield
    Gui.setLocale("English")
    forget_dock()


def forget_dock():
    """The review is made anew, in the language of the window."""
    found = review.existing()
    if found is not None:
        found.close()
        found.setParent(None)
        found.deleteLater()
        pump(20)


def cut(form) -> list[str]:
    """What is too narrow for its text or hangs out of the panel, in words."""
    found = []
    for widget in form.findChildren(QtGui.QWidget):
        if not widget.isVisible():
            continue
        if isinstance(widget, (QtGui.QPushButton, QtGui.QCheckBox)):
            wanted, text = widget.minimumSizeHint().width(), widget.text()
        elif isinstance(widget, QtGui.QComboBox):
            text = widget.currentText()
            wanted = widget.fontMetrics().boundingRect(text).width() + 40
        elif isinstance(widget, QtGui.QLabel) and not widget.wordWrap() and widget.text():
            wanted, text = widget.minimumSizeHint().width(), widget.text()
        else:
            continue
        if widget.width() < wanted - 2:
            found.append(f"{type(widget).__name__} {text!r}: {widget.width()} of {wanted} pixels")
        right = widget.mapTo(form, widget.rect().topRight()).x()
        if right > form.width():
            found.append(f"{type(widget).__name__} {text!r}: ends {right - form.width()} pixels outside the panel")
    return found


def scroll_of(form):
    """The scroll area in which FreeCAD shows a panel."""
    widget = form.parentWidget()
    while widget is not None and not isinstance(widget, QtGui.QScrollArea):
        widget = widget.parentWidget()
    return widget


def check(form, what: str) -> None:
    pump(250)
    screenshot(name_of(what))
    area = scroll_of(form)
    assert area is not None
    assert form.width() <= area.viewport().width(), (what, form.width(), area.viewport().width())
    assert cut(form) == []
    bar, grows = area.verticalScrollBar(), state_of(App.ActiveDocument).panel.grows
    # on a small screen the panel scrolls, once the table in it is as low as it can be used
    assert bar.maximum() == 0 or (bar.isVisible() and (grows is None or grows.height() == Filler.LOWEST)), what


@pytest.fixture(params=LANGUAGES)
def language(request):
    Gui.setLocale(request.param)
    yield request.param
    Gui.setLocale("English")


COMMANDS = [
    "Sens_EditMachine",
    "Sens_Tolerances",
    "Sens_Jog",
    "Sens_Allocate",
    "Sens_Moves",
    "Sens_Limits",
    "Sens_Plan",
    "Sens_Correlated",
    "Sens_Sweep",
    "Sens_Fleet",
]


@pytest.mark.parametrize("command", COMMANDS)
def test_panels_of_a_machine(machine, machine_doc, language, command):
    run("Sens_Sensitivity")
    review.hide()
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(tree.axis_of(machine, "Z"))
    run(command)
    check(state_of(machine_doc).panel.form, f"{command[5:]}-{language}")


def test_a_new_machine_from_parts(doc, workbench, language):
    loose_parts(doc)
    panel = task_machine.new_machine(doc)
    panel.table.setCurrentItem(panel.table.topLevelItem(3))
    check(panel.form, f"NewMachine-{language}")


def test_the_import(machine, machine_doc, language, tmp_path):
    rows = simulated.table(extract.core_machine(machine))
    path = simulated.write(tmp_path / "measured.csv", rows)
    text = path.read_text(encoding="utf-8")
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    panel = task_readings.import_readings(machine, path)
    check(panel.form, f"ImportReadings-{language}")
    for use, unit in zip(panel.uses, panel.units):
        for box in (use, unit):
            wanted = box.fontMetrics().boundingRect(box.currentText()).width() + 22
            assert box.width() >= wanted, (box.currentText(), box.width(), wanted)


@pytest.fixture
def traced(workbench):
    document = App.openDocument(str(TRACED))
    pump(100)
    look(document)
    yield tree.machine_of(document)
    App.closeDocument(document.Name)


def test_the_trace_and_its_tables(traced, language):
    table = tree.readings_of(traced)[0]
    panel = task_trace.open_panel(table)
    while panel.task is not None:
        pump(50)
    for page in ("Result", "Findings", "Fit"):
        panel.tabs.setCurrentWidget(panel.pages[page])
        check(panel.form, f"Trace{page}-{language}")
    panel.reject()
    pump(50)
    if traced.Fitted:
        panel = task_tables.open_panel(traced)
        check(panel.form, f"Tables-{language}")
        panel.reject()


def test_the_review(machine, machine_doc, language):
    run("Sens_Sensitivity")
    dock = review.dock()
    for tab, what in enumerate(("Errors", "Components", "WhatIf", "Settings")):
        dock.tabs.setCurrentIndex(tab)
        pump(100)
        screenshot(name_of(f"Review{what}-{language}"))
        assert [c for c in cut(dock.widget()) if "outside" not in c] == [], what
    dock.tabs.setCurrentIndex(0)
