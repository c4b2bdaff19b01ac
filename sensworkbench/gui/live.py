# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recolouring at once: when a machine with coloured parts has changed, its indices are computed again.

Several changes in a row are answered once, when the event loop is idle.  Long computations run in a thread that
touches no document, with a progress bar and Cancel; cancelling leaves the old result, marked stale.
"""

from __future__ import annotations

import gc
import threading

import FreeCAD as App

from ..core import workspace
from ..core.refusal import Refused
from ..document import extract, results, tree
from . import settings, state
from .qt import Qt, QtCore, QtGui, later, main_window, run, soon, translate, usual_cursor

LIVE_POINTS = 2000  # more positions than these are computed on command only


def wake(machine) -> None:
    """Compute again soon, unless the user switched that off."""
    document, name = machine.Document.Name, machine.Name
    answering = state.of(document).answering
    if settings.get("Live") and not machine.Problem and name not in answering:
        answering.add(name)
        later(lambda: _answer(document, name))


def _answer(document: str, name: str) -> None:
    if document in App.listDocuments():
        state.of(document).answering.discard(name)
    machine = App.getDocument(document).getObject(name) if document in App.listDocuments() else None
    result = tree.sensitivity_of(machine) if machine is not None else None
    if result is not None:
        answer(machine, result)


def answer(machine, result) -> bool:
    """Compute a stale coloured result again at once; False where that is not wanted, takes long or is refused."""
    if not (settings.get("Live") and result.Stale and result.Coloured) or machine.Problem:
        return False
    try:
        results.compute_at_once(machine, LIVE_POINTS)
    except Refused:
        return False  # the machine's Problem and the legend say that the result is out of date
    return not result.Stale


THREAD = "sens-task"  # name of every thread that runs a Task
COLLECT = 200  # milliseconds between two looks at what Python has to collect while a task runs


class Task:
    """A function in a thread of its own, to be started at once.  It is handed `progress`; a false return means stop.

    Windows and timers that were dropped must not be deleted in the thread: Qt crashes.  Python collects garbage in
    whichever thread makes the next object, so while a task runs this is done by a timer of the event loop
    instead; and the function, with all that it refers to, is let go in the event loop.
    """

    def __init__(self, function):
        self.fraction, self.cancelled, self.result, self.error = 0.0, False, None, None
        self._function = function
        self.thread = threading.Thread(target=self._run, daemon=True, name=THREAD)
        self._turn = 0
        self._collector = QtCore.QTimer()
        self._collector.timeout.connect(self._collect)
        self._collector.start(COLLECT)
        gc.disable()

    def progress(self, fraction: float) -> bool:
        """Store the finished share; return False when the work has been cancelled."""
        self.fraction = fraction
        return not self.cancelled

    def _run(self):
        try:
            self.result = self._function(self.progress)
        except Exception as error:  # noqa: BLE001 - handed to the event loop, which raises it there
            self.error = error
        soon(self._done)

    def _collect(self) -> None:
        """What Python would have collected by now: the youngest objects each time, the older ones less often."""
        self._turn += 1
        gc.collect(2 if self._turn % 50 == 0 else 1 if self._turn % 10 == 0 else 0)

    def _done(self):
        self.thread.join()
        self._collector.stop()
        self._function = None
        if not any(t.name == THREAD for t in threading.enumerate()):
            gc.enable()


def in_background(function, title: str, patience: float = 0.3):
    """Run function(progress) off the event loop and return its result; a dialog with Cancel shows after `patience` s.

    Raises what the function raises, and `workspace.Cancelled` when the user cancels.  Touches no document itself.
    """
    task = Task(function)
    task.thread.start()
    task.thread.join(patience)
    if task.thread.is_alive():
        _wait(task, title)
    task.thread.join()
    if task.error is not None:
        raise task.error
    return task.result


def _wait(task: Task, title: str) -> None:
    dialog = QtGui.QProgressDialog(title, translate("Sens", "Cancel"), 0, 1000, main_window())
    dialog.setObjectName("SensProgress")
    dialog.setWindowTitle("Sens Workbench")
    dialog.setWindowModality(Qt.ApplicationModal)
    dialog.setMinimumDuration(0)
    dialog.setAutoClose(False)
    dialog.setAutoReset(False)
    loop = QtCore.QEventLoop()
    timer = QtCore.QTimer()

    def look():
        if not task.thread.is_alive():
            loop.quit()
        elif dialog.wasCanceled():
            cancel()
        else:
            dialog.setValue(int(1000 * task.fraction))

    def cancel():
        task.cancelled = True
        dialog.setLabelText(translate("Sens", "Stopping…"))

    dialog.canceled.connect(cancel)
    timer.timeout.connect(look)
    timer.start(40)
    dialog.show()
    with usual_cursor():
        run(loop)
    timer.stop()
    dialog.close()
    dialog.setParent(None)  # deleted when the outermost event loop gets to it: no one finds it until then
    dialog.deleteLater()


def compute(machine):
    """Compute a machine's indices with progress and Cancel, store and return the Sensitivity object.

    Raises `Refused` or `workspace.Cancelled`; nothing is changed then.
    """
    core = extract.core_machine(machine)
    positions, objective = extract.positions(machine, core), extract.objective(machine)
    found = in_background(
        lambda progress: workspace.sensitivity(core, positions, objective, progress),
        translate("Sens", "Computing the indices at {n} positions").format(n=len(positions.q)),
    )
    return results.store(machine, found, core)
