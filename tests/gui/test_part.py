# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of a part: coloured faces, features, who makes them; nothing of the document changes, nothing remains."""

from __future__ import annotations

import dataclasses
import json

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import pytest

from sensworkbench.document import tree
from sensworkbench.gui import gif, task_part
from sensworkbench.gui import messages as window
from sensworkbench.gui.command import REGISTRY
from sensworkbench.gui.qt import QtGui, pump
from sensworkbench.gui.state import of as state_of
from tests.document.cam_jobs import make_job

from .conftest import close_messages, differences, look, messages, screenshot, state
from .test_commands import click

AT = (-60.0, -45.0, 98.0)


@pytest.fixture(scope="module")
def job_file(tmp_path_factory):
    from sensworkbench.document.examples import make_example

    path = str(tmp_path_factory.mktemp("part") / "Part.FCStd")
    document = App.newDocument("Part")
    make_example(document, "XYFZ")
    make_job(document, AT)
    document.recompute()
    for o in document.Objects:  # as CAM's own commands leave it
        if "PathFeature" in o.TypeId or hasattr(o, "ToolNumber"):
            o.ViewObject.Visibility = False
    pump(50)
    document.saveAs(path)
    App.closeDocument(document.Name)
    return path


@pytest.fixture
def job(workbench, job_file):
    document = App.openDocument(job_file)
    document.UndoMode = 1
    pump(50)
    look(document)
    yield tree.machine_of(document)
    Gui.Control.closeDialog()
    close_messages()
    App.closeDocument(document.Name)
    pump(20)


def fitted(core):
    """The same machine with a squareness and a scale that were measured."""
    from sensworkbench.core.fitted import Constant, FittedModel, Series

    model = FittedModel({"EXX": Series((-250.0, 250.0), (0.0, 12e-3), (0.0, 0.2e-3))}, {"C0Y": Constant(30e-6, 1e-6)})
    return dataclasses.replace(core, fitted=model)


@pytest.fixture
def panel(job, monkeypatch):
    extract = task_part.extract.core_machine
    monkeypatch.setattr(task_part.extract, "core_machine", lambda machine: fitted(extract(machine)))
    for dock in window.main_window().findChildren(QtGui.QDockWidget):
        if "eport" in dock.objectName():  # CAM opens it by what it says of a job that is made by a script
            dock.hide()
    found = task_part.open_panel(job, compute=False)
    yield found
    if state_of(job.Document).panel is not None:
        found.close()
    pump(30)


def test_faces_are_coloured_and_close_takes_everything_away(job, panel):
    graph, document = job.ViewObject.RootNode, job.Document
    undos, before = document.UndoCount, state(document)
    panel.compute()
    assert panel.found is not None, panel.words.text()
    assert panel.table.topLevelItemCount() == len(panel.found.result.features) > 10
    cut = [n for n, m in panel.scene.meshes.items() if m.value is not None]
    assert set(cut) == {f.name for f in panel.found.job.faced.faces}
    largest = max(float(np.abs(1e3 * panel.scene.meshes[n].value).max()) for n in cut)
    assert panel.scale.lower == -panel.scale.upper and panel.scale.upper >= 0.9 * largest
    pump(200)
    screenshot("part")
    children = graph.getNumChildren()
    click("Close")
    assert graph.getNumChildren() == children - 3 and document.UndoCount == undos
    shapes = " object at 0x"  # attributes of CAM and Sketcher that are another object at each look
    assert [d for d in differences(before, state(document)) if shapes not in d] == []
    assert all(o.ViewObject.SwitchNode.whichChild.getValue() != -1 for o in document.Objects
               if o.ViewObject.Visibility and o.isDerivedFrom("Part::Feature"))  # fmt: skip
    assert REGISTRY["Sens_Part"].IsActive()


def test_a_face_is_picked_in_the_view_and_shows_who_makes_it(job, panel):
    panel.compute()
    pump(100)
    size = panel._view.getSize()
    name = panel.scene.face_at(panel._view, (size[0] // 2, size[1] // 2))
    assert name in panel.scene.meshes
    bore = next(f.feature.surface.name for f in panel.found.result.features if f.feature.kind.name == "cylindricity")
    panel.choose(bore)
    assert panel.chosen == bore and panel.shares.topLevelItemCount() >= 1
    assert len(panel.mark.shown) == 1 and bore in panel.words.text()
    assert "C0Y" in panel._labels()
    panel._point(panel.shares.topLevelItem(0))
    pump(100)
    assert not panel.alone.isChecked() and job.ViewObject.Proxy.arrows.outlined
    screenshot("part-who")


def test_the_slider_draws_the_error_larger_and_the_ideal_part_stands_beside(job, panel):
    panel.compute()
    name = panel.found.job.faced.faces[0].name
    mesh, (_, _, coordinates) = panel.scene.meshes[name], panel.scene._nodes[name]
    for place in (0, 50, 80):
        panel.slider.setValue(place)
        drawn = np.array([tuple(p.getValue()) for p in coordinates.point.getValues()])
        assert drawn == pytest.approx(mesh.vertices + panel._times() * mesh.moved, abs=1e-3)
    assert panel._times() > 100
    panel.ideal.setChecked(True)
    pump(150)
    screenshot("part-shape")


def test_after_compensation_the_same_colours_show_little(job, panel):
    panel.compute()
    before = max(float(np.abs(f.value).max()) for f in panel.fields.values())
    scale = panel.scale
    panel.compensated.setChecked(True)
    pump(150)
    assert not messages(), messages()
    after = max(float(np.abs(f.value).max()) for f in panel.fields.values())
    assert after < 0.05 * before and panel.scale == scale
    assert panel.found.after and not panel.table.isColumnHidden(task_part.AFTER)
    screenshot("part-compensated")
    panel.compensated.setChecked(False)
    assert max(float(np.abs(f.value).max()) for f in panel.fields.values()) == pytest.approx(before)


def test_the_report_holds_the_picture(panel, tmp_path, monkeypatch):
    panel.compute()
    monkeypatch.setattr(window, "ask_folder", lambda _title: str(tmp_path))
    names = {p.name for p in panel.ask_report()}
    assert {"part.json", "report.html", "view.png"} <= names
    close_messages()
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert "data:image/png" in page and ("data:image/gif" in page) == gif.available()
    assert panel.machine.ViewObject.RootNode.findChild(panel.scene.root) >= 0 and panel.hidden._kept
    assert json.loads((tmp_path / "part.json").read_text(encoding="utf-8"))["features"]


def test_cancel_leaves_an_empty_panel_with_a_word(panel, monkeypatch):
    from sensworkbench.core.workspace import Cancelled

    def cancelled(*_):
        raise Cancelled("cancelled")

    monkeypatch.setattr(task_part.live, "in_background", cancelled)
    panel.compute()
    assert panel.found is None and panel.words.text() and not panel.report_button.isEnabled()


def test_without_a_path_the_command_is_not_offered(machine):
    assert not REGISTRY["Sens_Part"].IsActive()
