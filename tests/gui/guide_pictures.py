# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of the guide whose panels need more than a test shows.  They are made by `make pictures`, into docs/images.

    .venv/bin/python tests/run_in_freecad.py --gui -q tests/gui/guide_pictures.py

pytest collects this file only where it is named.
"""

from __future__ import annotations

from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import pytest

from sensworkbench.document import closed_loop, extract
from sensworkbench.gui import review, task_machine, task_readings, task_trace
from sensworkbench.gui.qt import QtGui, pump
from sensworkbench.gui.state import of as state_of

from ..document import simulated
from ..document.machines.plain import wooden_router
from . import conftest
from .conftest import look, run
from .test_layout import whole_screen  # noqa: F401 - as wide as on a user's screen

IMAGES = Path(__file__).resolve().parents[2] / "docs" / "images"


def save(name: str, monkeypatch) -> None:
    """The whole window as it is on the screen."""
    monkeypatch.setattr(conftest, "SCREENS", IMAGES / "made")
    pump(400)
    made = conftest.screenshot(name)
    assert (
        QtGui.QImage(str(made))
        .convertToFormat(QtGui.QImage.Format_RGB888)
        .save(str(IMAGES / f"guide-{name}.png"), None, 10)
    )
    made.unlink()
    made.parent.rmdir()


@pytest.fixture
def readings(machine, tmp_path):
    """Readings of the example machine, with the column bent by its temperature."""
    rows = simulated.table(extract.core_machine(machine))
    return closed_loop.make_readings(machine, simulated.write(tmp_path / "measured.csv", rows))


@pytest.fixture
def panel(readings):
    """The panel of a finished trace."""
    made = task_trace.open_panel(readings)
    for begin in (lambda: None, made.start):  # the declared errors are fitted first
        begin()
        while made.task is not None:
            pump(50)
    assert made.trace is not None
    yield made


def test_machine(doc, workbench, tmp_path, monkeypatch):
    wooden_router(doc, tmp_path)
    App.setActiveDocument(doc.Name)
    shown = task_machine.new_machine(doc)
    shown.table.setCurrentItem(shown.table.topLevelItem(1 + shown.names.index("Y")))
    Gui.Selection.clearSelection()
    look(doc)
    save("machine", monkeypatch)
    Gui.Control.closeDialog()
    for name in list(App.listDocuments()):
        App.closeDocument(name)


def test_tolerances(machine, monkeypatch):
    run("Sens_Sensitivity")
    review.hide()
    run("Sens_Tolerances")
    save("tolerances", monkeypatch)


def test_jog(machine, monkeypatch):
    run("Sens_Sensitivity")
    review.hide()
    run("Sens_Jog")
    panel = state_of(machine.Document).panel
    panel.go("X", 120.0)
    panel.go("Z", -80.0)
    save("jog", monkeypatch)


def test_error_map(machine, monkeypatch):
    run("Sens_Sensitivity")
    review.hide()
    run("Sens_ErrorMap")
    look(machine.Document)
    save("error-map", monkeypatch)


def test_readings(machine, tmp_path, monkeypatch):
    rows = simulated.table(extract.core_machine(machine))
    path = simulated.write(tmp_path / "measured.csv", rows)
    lines = [x for x in path.read_text(encoding="utf-8").splitlines() if not x.startswith("#")]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    task_readings.import_readings(machine, path)
    save("readings", monkeypatch)


def test_trace(panel, monkeypatch):
    panel.tabs.setCurrentWidget(panel.pages["Findings"])
    bar = panel.pages["Findings"].verticalScrollBar()
    bar.setValue(bar.maximum() // 3)
    save("trace", monkeypatch)


def test_residuals(panel, monkeypatch):
    panel.show_arrows.setCurrentIndex(3)
    panel.tabs.setCurrentWidget(panel.pages["BeforeAfter"])
    save("residuals", monkeypatch)
