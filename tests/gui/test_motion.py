# SPDX-License-Identifier: LGPL-2.1-or-later
"""Show Motion: copies of the parts move in the view, the document does not, and nothing remains after Close."""

from __future__ import annotations

import numpy as np
import pytest

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
    assert [p.name for p in written] == ["motion_00.png", "motion_01.png", "motion_02.png"] and FRAMES == 24
    assert len({p.read_bytes() for p in written}) == 3
