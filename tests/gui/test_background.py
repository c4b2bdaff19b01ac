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

from .conftest import differences, run, state


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
