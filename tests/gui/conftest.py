# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fixtures for tests in a real FreeCAD window; without one these tests are skipped (tests/run_in_freecad.py --gui)."""

from __future__ import annotations

import os
import sys
from contextlib import contextmanager
from pathlib import Path

import pytest

try:
    import FreeCAD as App

    WINDOW = bool(App.GuiUp)
except ImportError:
    App, WINDOW = None, False

if not WINDOW:
    collect_ignore_glob = ["test_*.py"]

SCREENS = Path(__file__).resolve().parents[2] / "build" / "screens"


def pytest_collection_modifyitems(items):
    for item in items:
        if "tests/gui" in str(item.fspath).replace("\\", "/"):
            item.add_marker(pytest.mark.gui)


def report_view():
    """FreeCAD's Report view, where its errors and those of Python slots are written."""
    from sensworkbench.gui.qt import QtGui, main_window

    return [w for w in main_window().findChildren(QtGui.QTextEdit) if "eport" in w.objectName()]


@pytest.fixture(autouse=True)
def clean_log():
    """Every test fails when an exception went to the log, or Qt complained."""
    from sensworkbench.gui.qt import QtCore, pump

    caught = []
    hook, sys.excepthook = sys.excepthook, lambda kind, value, trace: caught.append(f"{kind.__name__}: {value}")
    handler = QtCore.qInstallMessageHandler(
        lambda kind, _context, text: caught.append(f"Qt: {text}") if "Warning" in str(kind) or "Critical" in str(kind)
        else None
    )  # fmt: skip
    for view in report_view():
        view.clear()
    yield caught
    pump(30)
    QtCore.qInstallMessageHandler(handler)
    sys.excepthook = hook
    logged = "\n".join(view.toPlainText() for view in report_view())
    noise = (
        "propagateSizeHints",
        "XDG_RUNTIME_DIR",
        "QStandardPaths",
        "plugin does not support",
        "SetInputFocus",
        "scrollContentsBy",
    )
    caught = [c for c in caught if not any(n in c for n in noise)]
    assert not caught, caught
    assert "Traceback" not in logged, logged


@pytest.fixture
def doc():
    document = App.newDocument("Review")
    document.UndoMode = 1
    yield document
    _close_all()


@pytest.fixture
def workbench():
    import FreeCADGui as Gui

    from sensworkbench.gui.qt import QtGui, main_window

    Gui.activateWorkbench("SensWorkbench")
    for dock in main_window().findChildren(QtGui.QDockWidget):
        if dock.objectName() in ("Python console", "Report view", "Selection view"):
            dock.hide()
        if dock.objectName() in ("Combo View", "Model"):
            dock.show()
    return Gui.activeWorkbench()


@pytest.fixture(scope="session")
def example_file(tmp_path_factory):
    """The vertical machining centre as a file: opening it is faster than building it."""
    from sensworkbench.document.examples import make_example
    from sensworkbench.gui.qt import pump

    path = str(tmp_path_factory.mktemp("example") / "XYFZ.FCStd")
    document = App.newDocument("Example")
    make_example(document, "XYFZ")
    document.recompute()
    pump(50)
    document.saveAs(path)
    App.closeDocument(document.Name)
    return path


@pytest.fixture
def machine(workbench, example_file):
    """The vertical machining centre, in view."""
    from sensworkbench.document import tree
    from sensworkbench.gui.qt import pump

    document = App.openDocument(example_file)
    document.UndoMode = 1
    pump(50)
    look(document)
    yield tree.machine_of(document)
    _close_all()


@pytest.fixture
def machine_doc(machine):
    return machine.Document


def _close_all():
    import FreeCADGui as Gui

    from sensworkbench.gui import review
    from sensworkbench.gui.qt import pump

    Gui.Control.closeDialog()
    review.hide()
    close_messages()
    for name in list(App.listDocuments()):
        App.closeDocument(name)
    pump(20)


def look(doc):
    """Show the document isometrically; returns the view."""
    import FreeCADGui as Gui

    view = Gui.getDocument(doc.Name).mdiViewsOfType("Gui::View3DInventor")[0]
    if hasattr(view, "setAnimationEnabled"):
        view.setAnimationEnabled(False)
    view.viewIsometric()
    view.fitAll()
    return view


def run(command: str):
    """What a click on the command does."""
    import FreeCADGui as Gui

    from sensworkbench.gui.qt import pump

    Gui.runCommand(command, 0)
    pump(30)


def messages():
    """Texts of the messages that stand on the screen."""
    from sensworkbench.gui.qt import QtGui, main_window

    boxes = main_window().findChildren(QtGui.QMessageBox, "SensMessage")
    return [b.text() for b in boxes if b.isVisible()]


def close_messages():
    from sensworkbench.gui.qt import QtGui, main_window, pump

    for name in ("SensMessage", "SensWritten"):
        for box in main_window().findChildren(QtGui.QMessageBox, name):
            box.close()
    pump(10)


def screenshot(name: str) -> Path:
    """The whole screen into build/screens, named after FreeCAD's version."""
    from sensworkbench.gui.qt import QtGui, pump

    pump(120)
    SCREENS.mkdir(parents=True, exist_ok=True)
    version = ".".join(App.Version()[:2])
    path = SCREENS / f"{version}-{name}.png"
    QtGui.QApplication.primaryScreen().grabWindow(0).save(str(path))
    return path


def picture(doc, width=800, height=600, background="White"):
    """The saved picture of the 3D view as a QImage."""
    from sensworkbench.gui.qt import QtGui, pump

    pump(30)
    path = os.path.join(App.getTempPath(), f"sens-{os.getpid()}.png")
    look(doc).saveImage(path, width, height, background)
    image = QtGui.QImage(path)
    os.unlink(path)
    assert not image.isNull()
    return image


def state(doc) -> dict:
    """Everything that Cancel and undo must bring back: objects, their properties, and how they look."""
    from sensworkbench.gui import colours

    found = {}
    for obj in doc.Objects:
        values = {
            p: repr(plain(getattr(obj, p))) for p in obj.PropertiesList if p not in ("Proxy", "Shape", "Visibility")
        }
        if colours._can(obj):
            values["look"] = repr(rounded(colours.read(obj)))
        found[obj.Name] = values
    return found


def plain(value):
    """A property's value without addresses in its text."""
    if isinstance(value, (list, tuple)):
        return [plain(v) for v in value]
    if hasattr(value, "TypeId") and hasattr(value, "Name"):
        return value.Name
    return str(value)


def rounded(value):
    if isinstance(value, float):
        return round(value, 4)
    if isinstance(value, dict):
        return {k: rounded(v) for k, v in value.items()}
    if isinstance(value, (list, tuple)):
        return [rounded(v) for v in value]
    return value


def differences(before: dict, after: dict) -> list[str]:
    """What is not the same, in words."""
    found = [f"{n} is new" for n in after if n not in before] + [f"{n} is gone" for n in before if n not in after]
    for name in before:
        for prop, value in before[name].items():
            if name in after and after[name].get(prop) != value:
                found.append(f"{name}.{prop}: {value[:120]} -> {str(after[name].get(prop))[:120]}")
    return found


@contextmanager
def study(open_panel, machine):
    """The panel of a study beside the ranking of the machine; closed afterwards."""
    import FreeCADGui as Gui

    from sensworkbench.gui.qt import pump

    run("Sens_Sensitivity")
    made = open_panel(machine)
    pump(60)
    yield made
    Gui.Control.closeDialog()
    pump(60)


def rows(view):
    """The rows of a study's table by the key that each carries."""
    from sensworkbench.gui.task_study import KEY

    items = [view.topLevelItem(i) for i in range(view.topLevelItemCount())]
    return {item.data(0, KEY): item for item in items}
