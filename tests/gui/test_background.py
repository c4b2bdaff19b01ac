# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long work beside the window: it can be cancelled, and nothing of the window is deleted in its thread."""

from __future__ import annotations

import gc
import threading
import time

import pytest

from sensworkbench.core.workspace import Cancelled
from sensworkbench.gui import live
from sensworkbench.gui.qt import QtCore, QtGui, main_window, pump

from .conftest import close_messages, differences, messages, report_view, run, state


def test_long_work_can_be_cancelled_and_keeps_the_old_result(machine, machine_doc):
    run("Sens_Sensitivity")
    before = state(machine_doc)
    ticks = []
    timer = QtCore.QTimer()
    timer.timeout.connect(lambda: ticks.append(1))
    timer.start(20)
    # a dialog that has done its work, as after any computation on a busy machine, must not be the one that is found
    assert live.in_background(lambda progress: time.sleep(0.6), "Computing") is None
    QtCore.QTimer.singleShot(700, lambda: main_window().findChild(QtGui.QProgressDialog, "SensProgress").cancel())

    def endless(progress):
        end = time.monotonic() + 60
        while progress(0.5):
            assert time.monotonic() < end, "Cancel does not reach the work"
            time.sleep(0.01)
        raise Cancelled("cancelled")

    with pytest.raises(Cancelled):
        live.in_background(endless, "Computing")
    assert len(ticks) > 5  # the window went on living
    assert differences(before, state(machine_doc)) == []


def test_dropped_windows_are_deleted_in_the_event_loop_only(workbench):
    deleted_in = []

    class Panel:
        def __init__(self):
            self.form, self.circle = QtGui.QWidget(), self
            self.form.show()

        def __del__(self):
            deleted_in.append(threading.current_thread())

    def work(panel):
        def function(progress):
            assert panel is None or panel.form
            return len([[i] for i in range(200_000)])  # enough new objects to have garbage collected

        return function

    gc.collect()
    for _ in range(2):
        Panel()
        assert live.in_background(work(Panel()), "Computing") == 200_000
    pump(30)
    assert gc.isenabled()
    gc.collect()
    pump(30)
    assert deleted_in == [threading.main_thread()] * 4


@pytest.mark.parametrize("stage, begins", [("trace", "The trace stopped:"), ("fit", "The fit stopped:")])
def test_an_error_of_background_work_is_said_in_the_panel(machine, machine_doc, tmp_path, monkeypatch, stage, begins):
    from sensworkbench.closedloop import declared
    from sensworkbench.closedloop import trace as tracing
    from sensworkbench.document import closed_loop, extract
    from sensworkbench.gui.task_trace import open_panel

    from ..document import simulated

    def fails(*_, **__):
        raise IndexError("size 42000 is different from 12000")

    module, name = (tracing, "trace") if stage == "trace" else (declared, "declared_fit")
    monkeypatch.setattr(module, name, fails)
    rows = simulated.table(extract.core_machine(machine))
    table = closed_loop.make_readings(machine, simulated.write(tmp_path / "measured.csv", rows))
    before = state(machine_doc)
    panel = open_panel(table, start=stage == "trace")
    end = time.monotonic() + 60
    while not panel.note.text().startswith(begins):
        assert time.monotonic() < end, panel.note.text()
        pump(20)
    assert "size 42000 is different from 12000" in panel.note.text()
    assert panel.task is None and panel.run.isEnabled()
    end = time.monotonic() + 10  # lines of other threads come late
    while "IndexError" not in "\n".join(view.toPlainText() for view in report_view()):
        assert time.monotonic() < end
        pump(20)
    assert "Traceback" in "\n".join(view.toPlainText() for view in report_view())
    for view in report_view():
        view.clear()
    assert differences(before, state(machine_doc)) == []
    panel.reject()


def test_a_command_that_ends_in_a_defect_says_so(machine, machine_doc, monkeypatch):
    from sensworkbench.core import workspace

    before = state(machine_doc)
    monkeypatch.setattr(workspace, "sensitivity", lambda *_, **__: 1 / 0)
    run("Sens_Sensitivity")
    assert any("Sensitivity stopped: ZeroDivisionError" in m for m in messages())
    close_messages()
    pump(50)
    for view in report_view():
        view.clear()
    assert differences(before, state(machine_doc)) == []


def test_garbage_is_collected_while_a_task_runs_and_never_in_its_thread(workbench):
    collected = []

    class Circle:
        def __init__(self):
            self.itself = self

        def __del__(self):
            collected.append(threading.current_thread())

    go_on = threading.Event()

    def work(progress):
        while not go_on.wait(0.01):
            assert [[i] for i in range(20_000)]
        return True

    task = live.Task(work)
    task.thread.start()
    Circle()
    end = time.monotonic() + 20
    while not collected:
        assert time.monotonic() < end, "nothing is collected while a task runs"
        pump(50)
        assert len([Circle for _ in range(20_000)]) == 20_000
    assert task.thread.is_alive() and collected[0] is threading.main_thread()
    go_on.set()
    task.thread.join()
    pump(50)
    assert gc.isenabled()


def test_two_tasks_at_once_leave_the_collector_on(workbench):
    first, second = threading.Event(), threading.Event()
    tasks = [live.Task(lambda _p, e=e: e.wait(20)) for e in (first, second)]
    for task in tasks:
        task.thread.start()
    for task, event in zip(tasks, (first, second)):
        event.set()
        task.thread.join()
        pump(50)
    assert gc.isenabled()
