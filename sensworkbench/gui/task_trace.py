# SPDX-License-Identifier: LGPL-2.1-or-later
"""The trace panel: fit of the declared errors first, then the search for what they lack, then what was found.

Fit and trace run in a thread on plain data; the thread touches no document.  Cancel leaves the old result; what is
found is stored as one undo step.
"""

from __future__ import annotations

import FreeCAD as App

from ..core.refusal import Refused
from ..core.workspace import Cancelled
from ..document import closed_loop, extract, tree
from ..document.tree import added_effects
from . import messages, residuals, trace_pages
from .command import Command, Where, command
from .current import current_table, current_trace
from .live import Task
from .panel import Panel
from .panel import show as show_panel
from .preferences import combo
from .qt import QT_TRANSLATE_NOOP, QtCore, QtGui, translate
from .task_motion import stills

POLL, WATCH = 60, 600  # milliseconds
TRACE_FILES = ("trace.json", "report.html", "machine_augmented.json")


class TaskTrace(Panel):
    """The panel.  `table` : the Readings object.  With `start` a trace that is missing or out of date is begun."""

    guide = "8. Close the loop: readings in, the missing effect out"
    standard = ("Close",)

    def __init__(self, machine, table, start: bool = False):
        self.machine, self.table, self.document = machine, table, machine.Document.Name
        self.core = extract.core_machine(machine)  # refuses before anything is opened
        self.readings = closed_loop.read(table)
        self.task, self._then, self._words, self._shown = None, None, "", ()
        self.form = self._form()
        self._poll, self._watch = QtCore.QTimer(), QtCore.QTimer()
        self._poll.timeout.connect(self._look)
        self._watch.timeout.connect(self._sync)
        self._watch.start(WATCH)
        self._sync()
        self._for_trace = start  # the fit alone was asked for: its page is shown, also beside an older trace
        self._start_when_fitted = start and (self.trace is None or self.trace.Stale)
        self.fit()

    @property
    def trace(self):
        """The Trace object of the readings, or None."""
        return tree.trace_of(self.table)

    # -- the form ----------------------------------------------------------------------------------------------------
    def _form(self):
        title = translate("Sens", "Trace of {name}").format(name=self.table.Label)
        form = self.make_form("SensTrace", title, "Sens_Trace")
        layout = QtGui.QVBoxLayout(form)
        words = translate("Sens", "{file}: {rows} readings at {points} places").format(
            file=self.table.Source, rows=self.readings.rows, points=self.readings.points
        )
        label = QtGui.QLabel(words)
        label.setWordWrap(True)
        label.setToolTip(
            "\n".join(messages.stored(f) for f in self.table.Findings)
            or translate("Sens", "Nothing was noticed while reading")
        )
        layout.addWidget(label)
        row = QtGui.QHBoxLayout()
        self.run = QtGui.QPushButton(QtGui.QIcon(messages.icon("Sens_Trace")), translate("Sens", "Trace"))
        self.run.setToolTip(translate("Sens", "Searches for an effect that explains what the declared errors leave"))
        self.run.clicked.connect(self.start)
        self.progress = QtGui.QProgressBar()
        self.progress.setRange(0, 1000)
        self.progress.setTextVisible(False)
        policy = self.progress.sizePolicy()
        policy.setRetainSizeWhenHidden(True)  # Trace and Cancel keep their places: a late click hits neither wrongly
        self.progress.setSizePolicy(policy)
        self.stop = QtGui.QPushButton(translate("Sens", "Cancel"))
        self.stop.setObjectName("SensTraceCancel")
        self.stop.setToolTip(translate("Sens", "Stops; the old result stays"))
        self.stop.clicked.connect(self.cancel)
        row.addWidget(self.run)
        row.addWidget(self.progress, 1)
        row.addWidget(self.stop)
        layout.addLayout(row)
        self.note = QtGui.QLabel()
        self.note.setWordWrap(True)
        layout.addWidget(self.note)
        self.tabs = QtGui.QTabWidget()
        self.tabs.setDocumentMode(True)
        self.tabs.setUsesScrollButtons(True)
        titles = (translate("Sens", "Result"), translate("Sens", "Findings"), translate("Sens", "Before/after"),
                  translate("Sens", "Next"), translate("Sens", "Fit"))  # fmt: skip
        self.pages = {}
        for name, title in zip(trace_pages.PAGES, titles):
            self.pages[name] = trace_pages.Page(name)
            self.tabs.addTab(self.pages[name], title)
        self.tabs.setMinimumHeight(150)
        self.grows = self.tabs
        layout.addWidget(self.tabs, 1)
        layout.addLayout(self._actions())
        return form

    def _actions(self):
        grid = QtGui.QGridLayout()
        self.add = QtGui.QPushButton(QtGui.QIcon(messages.icon("Sens_AddEffect")), "")
        self.add.clicked.connect(self.add_or_remove)
        self.report = QtGui.QPushButton(QtGui.QIcon(messages.icon("Sens_TraceReport")), translate("Sens", "Report…"))
        self.report.setToolTip(translate("Sens", "Writes trace.json, report.html and the augmented machine"))
        self.report.clicked.connect(self.write_report)
        self.show_arrows = combo([
            (residuals.OFF, translate("Sens", "off")), (residuals.SHOW_BEFORE, translate("Sens", "before")),
            (residuals.SHOW_AFTER, translate("Sens", "after")), (residuals.BOTH, translate("Sens", "before and after")),
        ])  # fmt: skip
        self.show_arrows.setToolTip(translate("Sens", "Residuals as arrows in the workspace, all on one scale"))
        self.show_arrows.currentIndexChanged.connect(self._arrows)
        self.zoom = QtGui.QPushButton(translate("Sens", "Zoom"))
        self.zoom.setToolTip(translate("Sens", "Fits the view to the residuals"))
        self.zoom.clicked.connect(lambda *_: zoom_to(self.trace))
        grid.addWidget(self.add, 0, 0, 1, 2)
        grid.addWidget(self.report, 0, 2)
        self.show_arrows.setMinimumContentsLength(6)
        grid.addWidget(QtGui.QLabel(translate("Sens", "Residuals")), 1, 0)
        grid.addWidget(self.show_arrows, 1, 1)
        grid.addWidget(self.zoom, 1, 2)
        grid.setColumnStretch(1, 1)
        return grid

    # -- running -----------------------------------------------------------------------------------------------------
    def _begin(self, function, then, words: str) -> None:
        self._then, self._words = then, words
        self.note.setStyleSheet("")
        self.task = Task(function)
        self.task.thread.start()
        self._poll.start(POLL)
        self._sync()

    def fit(self) -> None:
        """Fit the declared errors alone."""
        core, readings = self.core, self.readings

        def work(_progress):
            from ..closedloop.declared import declared_fit, fit_summary

            return fit_summary(declared_fit(core, readings), readings)

        self._begin(work, self._fitted, translate("Sens", "Fitting the declared errors"))

    def _fitted(self, fit) -> None:
        self.pages["Fit"].show_page(trace_pages.fit_page(fit))
        if self.trace is None or not self._for_trace:
            self.tabs.setCurrentWidget(self.pages["Fit"])
        if self._start_when_fitted:
            self._start_when_fitted = False
            self.start()

    def start(self) -> None:
        """Begin a trace of the machine as it is now."""
        if self.task is not None:
            return
        try:
            self.core = extract.core_machine(self.machine)
        except Refused as error:
            self.note.setText(messages.words(error))
            return
        core, readings = self.core, self.readings

        def work(progress):
            from ..closedloop.trace import trace

            def tell(fraction, words):
                self._words = words
                return progress(fraction)

            return trace(core, readings, progress=tell)

        self._begin(work, self._traced, translate("Sens", "Searching"))

    def _traced(self, outcome) -> None:
        core = self.core
        messages.change(
            self.machine.Document, translate("Sens", "Trace"),
            lambda: closed_loop.make_trace(self.machine, self.table, outcome, core),
        )  # fmt: skip
        self._sync()
        self.tabs.setCurrentWidget(self.pages["Result"])

    def cancel(self) -> None:
        """Stop what runs; the thread ends at its next step, and what it finds is dropped."""
        if self.task is not None:
            self.task.cancelled = True
            self._end()
            self.note.setText(translate("Sens", "Cancelled; nothing was changed"))

    def _end(self):
        self._poll.stop()
        self.task = None
        self._start_when_fitted = False
        self._sync()

    def _look(self) -> None:
        task = self.task
        if task is None or self.form is None or self.document not in App.listDocuments():
            self.leave()
            return
        if task.thread.is_alive():
            self.progress.setValue(int(1000 * task.fraction))
            self.note.setText(f"{self._words}…")
            return
        then, start = self._then, self._start_when_fitted
        self._end()
        self._start_when_fitted = start
        self.note.setText("")
        if isinstance(task.error, (Refused, Cancelled)):
            said = isinstance(task.error, Refused)
            words = messages.words(task.error) if said else translate("Sens", "Cancelled; nothing was changed")
            self.note.setText(words)
        elif task.error is not None:
            messages.log(task.error)
            self._stopped(task.error)
        else:
            then(task.result)

    def _stopped(self, error: Exception) -> None:
        """Say in the panel that the work ended in a defect of the program, and where its details are."""
        words = translate("Sens", "The trace stopped: {error}. Nothing was changed. The report view holds the details; "
                                  "please send them in with the readings.")  # fmt: skip
        if self._then == self._fitted:
            words = translate("Sens", "The fit stopped: {error}. The report view holds the details; "
                                      "please send them in with the readings.")  # fmt: skip
        self.note.setText(words.format(error=f"{type(error).__name__}: {error}".rstrip(".")))
        self.note.setStyleSheet("color: #c0392b")

    # -- showing -----------------------------------------------------------------------------------------------------
    def _sync(self) -> None:
        """Bring buttons and pages up to date with the document, also after undo."""
        if self.form is None or self.document not in App.listDocuments():  # FreeCAD closed the panel
            self.leave()
            return
        if self.table not in App.getDocument(self.document).Objects:
            self.form.setEnabled(False)
            return
        self.form.setEnabled(True)
        busy, trace = self.task is not None, self.trace
        made = added_effects(trace) if trace is not None else []
        self.run.setEnabled(not busy)
        self.stop.setEnabled(busy)
        self.progress.setVisible(busy)
        if not busy:
            self.progress.setValue(0)
        self.add.setText(translate("Sens", "Remove effects") if made else translate("Sens", "Add effects"))
        self.add.setToolTip(
            translate("Sens", "Takes the found effects out of the machine again")
            if made
            else translate("Sens", "Makes the found effects objects under their bodies, one undo step")
        )
        self.add.setEnabled(not busy and trace is not None and (bool(made) or closed_loop.can_add(trace)))
        self.report.setEnabled(not busy and trace is not None)
        self.show_arrows.setEnabled(trace is not None)
        shown = trace.ViewObject.ShowResiduals if trace is not None else residuals.OFF
        self.zoom.setEnabled(shown != residuals.OFF)
        if self.show_arrows.itemData(self.show_arrows.currentIndex()) != shown:
            self.show_arrows.blockSignals(True)
            self.show_arrows.setCurrentIndex(self.show_arrows.findData(shown))
            self.show_arrows.blockSignals(False)
        self._show(trace, busy)

    def _show(self, trace, busy: bool) -> None:
        if trace is not None and trace.Stale and not busy:
            self.note.setText(translate("Sens", "The machine has changed since this trace. Trace again."))
        state = None if trace is None else (trace.Name, hash(trace.Report))
        if state == self._shown:
            return
        self._shown = state
        if trace is None:
            for name in ("Result", "Findings", "BeforeAfter", "Next"):
                words = translate("Sens", "Not traced yet.")
                self.pages[name].show_page(lambda page, words=words: trace_pages.paragraph(words))
            return
        outcome, report = None, closed_loop.report_of(trace)
        try:
            outcome = closed_loop.evidence_of(trace)
        except Refused as error:
            self.note.setText(messages.words(error))
        self.pages["Result"].show_page(trace_pages.result_page(report, self.machine))
        self.pages["Findings"].show_page(trace_pages.findings_page(report, outcome))
        self.pages["BeforeAfter"].show_page(trace_pages.before_after_page(report, outcome))
        self.pages["Next"].show_page(trace_pages.next_page(report))

    # -- what the buttons do -----------------------------------------------------------------------------------------
    def add_or_remove(self) -> None:
        """Add the found effects to the machine, or remove them if they have been added."""
        trace = self.trace
        if added_effects(trace):
            messages.change(
                self.machine.Document, translate("Sens", "Remove effects"), lambda: closed_loop.remove_effects(trace)
            )
        else:
            add_effects(trace)
        self._sync()

    def write_report(self) -> None:
        """Ask for a folder and write the report of the trace."""
        try:
            ask_and_write(self.trace)
        except Refused as error:
            messages.show(messages.words(error))

    def _arrows(self, _index) -> None:
        trace = self.trace
        if trace is not None:
            show_residuals(trace, self.show_arrows.itemData(self.show_arrows.currentIndex()))
            self._sync()

    # -- the panel ---------------------------------------------------------------------------------------------------
    def leave(self) -> None:
        self._watch.stop()
        self._poll.stop()
        if self.task is not None:
            self.task.cancelled = True
            self.task = None


# -- what commands share with the panel --------------------------------------------------------------------------------
def add_effects(trace) -> bool:
    """Make the found effects objects, as one undo step."""
    doc = trace.Document
    return messages.change(doc, translate("Sens", "Add effects"), lambda: closed_loop.add_effects(trace))


def show_residuals(trace, what: str) -> None:
    """Draw residuals before, after, both, or none, as one undo step."""

    def change():
        trace.ViewObject.ShowResiduals = what
        trace.ViewObject.Visibility = True

    messages.change(trace.Document, translate("Sens", "Residuals"), change)


def zoom_to(trace) -> None:
    """Fit the view to the residuals of a trace."""
    import FreeCADGui as Gui

    if trace is not None:
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(trace)
        Gui.SendMsgToActiveView("ViewSelection")
        Gui.Selection.clearSelection()


def ask_and_write(trace) -> list:
    """Ask for a folder and write trace.json, report.html and the augmented machine; returns the paths."""
    from ..formats import study_files

    folder = messages.ask_folder(translate("Sens", "Folder for the trace"))
    if not folder or not messages.may_write(folder, TRACE_FILES):
        return []
    report, evidence = closed_loop.report_of(trace), closed_loop.evidence_of(trace)
    found = [name for e in report.get("effects", ()) for name in (e.get("name"), e.get("component")) if name]
    moving = stills(tree.owner_machine(trace), found)
    paths = study_files.write_saved_trace(folder, report, evidence, language=messages.language(), motion=moving)
    messages.written(paths)
    return paths


def open_panel(table, start: bool = False):
    """Open the panel for a Readings object."""
    panel = TaskTrace(tree.owner_machine(table), table, start)
    show_panel(panel, table.Document)
    return panel


@command
class Fit(Command):
    name = "Sens_Fit"
    keys = "Y, F"
    menu_text = QT_TRANSLATE_NOOP("Sens_Fit", "Fit Declared Errors…")
    tip = QT_TRANSLATE_NOOP(
        "Sens_Fit", "Fits the declared errors to the readings: what they explain, and what the plan cannot tell apart"
    )
    needs, guide = "readings", TaskTrace.guide
    where = Where("loop", 20, double=("Readings",))
    start = False

    def run(self):
        open_panel(current_table(), self.start)


@command
class Trace(Fit):
    name = "Sens_Trace"
    keys = "Y, C"
    menu_text = QT_TRANSLATE_NOOP("Sens_Trace", "Trace…")
    tip = QT_TRANSLATE_NOOP("Sens_Trace", "Searches for the effect that explains what the declared errors leave over")
    where = Where("loop", 30, tree=("Readings",), double=("Trace",))
    start = True


@command
class AddEffect(Command):
    name = "Sens_AddEffect"
    menu_text = QT_TRANSLATE_NOOP("Sens_AddEffect", "Add Effects")
    tip = QT_TRANSLATE_NOOP("Sens_AddEffect", "Adds the found effects to the machine, each under its body")
    needs, guide = "effects found", TaskTrace.guide
    where = Where("loop", 40, tree=("Trace",))

    def run(self):
        add_effects(current_trace())


@command
class Residuals(Command):
    name = "Sens_Residuals"
    keys = "Y, D"
    menu_text = QT_TRANSLATE_NOOP("Sens_Residuals", "Residuals")
    tip = QT_TRANSLATE_NOOP(
        "Sens_Residuals", "Shows the residuals before and after as arrows in the workspace, or hides them"
    )
    needs, guide = "trace", TaskTrace.guide
    where = Where("loop", 60, tree=("Trace",))

    def run(self):
        trace = current_trace()
        hidden = trace.ViewObject.ShowResiduals == residuals.OFF
        show_residuals(trace, residuals.BOTH if hidden else residuals.OFF)


@command
class TraceReport(Command):
    name = "Sens_TraceReport"
    menu_text = QT_TRANSLATE_NOOP("Sens_TraceReport", "Export Trace Report…")
    tip = QT_TRANSLATE_NOOP("Sens_TraceReport", "Writes what was found as HTML and JSON, with the augmented machine")
    needs, guide = "trace", TaskTrace.guide
    where = Where("loop", 70, tree=("Trace",))

    def run(self):
        ask_and_write(current_trace())
