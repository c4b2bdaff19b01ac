# SPDX-License-Identifier: LGPL-2.1-or-later
"""Show Motion: copies of the parts move in the view, the document does not, and nothing remains after Close."""

from __future__ import annotations

import numpy as np
import pytest

from sensworkbench.gui import gif
from sensworkbench.gui.command import REGISTRY
from sensworkbench.gui.qt import pump
from sensworkbench.gui.state import of as state_of
from sensworkbench.gui.task_motion import FRAMES, open_panel

from .conftest import differences, run, screenshot, state
from .test_commands import click


@pytest.fixture
def panel(machine):
    found = open_panel(machine, "EAZ")
    found._timer.stop()
    yield found
    if state_of(machine.Document).panel is not None:
        found.close()
    pump(30)


def test_the_command_opens_it_and_close_takes_everything_away(machine, machine_doc):
    graph = machine.ViewObject.RootNode
    before, children, undos = state(machine_doc), graph.getNumChildren(), machine_doc.UndoCount
    run("Sens_Motion")
    pump(200)
    assert graph.getNumChildren() == children + 1
    screenshot("motion")
    click("Close")
    assert graph.getNumChildren() == children and machine_doc.UndoCount == undos
    assert differences(before, state(machine_doc)) == []
    assert REGISTRY["Sens_Motion"].IsActive()


def test_the_head_turns_about_its_reference_and_the_tool_answers(panel, machine):
    panel.draw(1.0)
    angle = panel.ghost.transform.rotation.getValue().getAxisAngle()[1]
    assert angle == pytest.approx(panel.times * panel.moving.value, rel=1e-3)
    arm, answer = panel.arrows.shown
    moved = np.subtract(answer.end, answer.start)
    assert moved == pytest.approx(panel.times * panel.moving.answer, rel=1e-6)
    assert np.linalg.norm(moved) < 0.2 * panel.size and np.linalg.norm(moved) > 0.01 * panel.size
    # the turned lever arm ends where the answer says, but for the chord of the turn
    lever = np.subtract(arm.end, arm.start)
    assert moved == pytest.approx(np.cross(panel.times * panel.moving.turn, lever), rel=1e-6)
    panel.draw(0.0)
    assert panel.ghost.transform.rotation.getValue().getAxisAngle()[1] == pytest.approx(0)


def test_the_slider_changes_the_exaggeration_and_the_words(panel):
    usual, words = panel.times, panel.note.text()
    panel.slider.setValue(100)
    assert panel.times == pytest.approx(10 * usual) and panel.note.text() != words


def test_every_error_can_be_shown(panel):
    for i in range(panel.choice.count()):
        panel.choice.setCurrentIndex(i)
        assert panel.moving is not None and panel.ghost is not None, panel.choice.itemText(i)
        panel.draw(0.7)


def test_pictures_of_one_period_are_saved(panel, tmp_path, monkeypatch):
    from sensworkbench.gui import task_motion

    monkeypatch.setattr(task_motion, "FRAMES", 3)
    written = panel.save(tmp_path)
    assert [p.name for p in written[-3:]] == ["motion_00.png", "motion_01.png", "motion_02.png"] and FRAMES == 24
    assert len({p.read_bytes() for p in written}) == len(written)
    if gif.available():
        data = (tmp_path / "motion.gif").read_bytes()
        assert data[:6] == b"GIF89a" and data.count(b"\x21\xf9\x04") == 3  # a control block for each picture


def test_a_fitted_error_moves_along_the_tool_path(machine, machine_doc, monkeypatch):
    import dataclasses

    import Path

    from sensworkbench.core.fitted import Constant, FittedModel, Series
    from sensworkbench.gui import task_motion

    made = machine_doc.addObject("Path::Feature", "Line")
    made.Path = Path.Path([Path.Command("G0", {"X": -80.0, "Y": 0.0, "Z": 320.0}),
                           Path.Command("G1", {"X": 80.0, "Y": 0.0, "Z": 320.0, "F": 10.0})])  # fmt: skip
    survey = task_motion.extract.survey
    model = FittedModel({"EXX": Series((-250.0, 250.0), (0.0, 12e-3))}, {"C0Y": Constant(30e-6)})

    def fitted(one):
        found = survey(one)
        return dataclasses.replace(found, core=dataclasses.replace(found.core, fitted=model))

    monkeypatch.setattr(task_motion.extract, "survey", fitted)
    panel = open_panel(machine, "EXX")
    panel._timer.stop()
    try:
        assert panel.over.count() == 2
        panel.over.setCurrentIndex(1)
        assert panel.course is not None and panel.arrows.outlined, panel.note.text()
        panel.draw(-1.0)
        before = panel.ghost.transform.translation.getValue().getValue()
        panel.draw(1.0)
        after = panel.ghost.transform.translation.getValue().getValue()
        # the table of the example moves against its error: +-12 um * 80/250, times the exaggeration
        moved = 2 * 12e-3 * 80 / 250 * panel.times
        assert abs(after[0] - before[0]) == pytest.approx(moved, rel=1e-3)
        assert "s\n" in panel.arrows.shown[0].text
        screenshot("motion-path")
        panel.choice.setCurrentIndex([panel.choice.itemData(i) for i in range(panel.choice.count())].index("EAZ"))
        assert panel.course is None and panel.note.text()  # only its tolerance is known
    finally:
        panel.close()
        pump(30)
