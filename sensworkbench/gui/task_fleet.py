# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that traces the records of many machines: which effect recurs on which machine, in tables and a picture.

It works on a folder with one folder for each machine, and changes no document.
"""

from __future__ import annotations

from pathlib import Path

import FreeCAD as App

from ..core.refusal import Refused
from ..core.units import um
from ..core.workspace import Cancelled
from ..formats import fleet_files, provenance, study_files
from ..studies.fleet import RATE, FleetResult, fleet_study, median_um
from . import live, messages, plots
from .command import Command, Where, command
from .panel import Panel, rows
from .panel import show as show_panel
from .preferences import number_box
from .qt import QT_TRANSLATE_NOOP, QtGui, translate
from .task_study import KEY, add_row, fit_columns, table
from .task_sweep import Picture

MOST_COLUMNS = 8  # effects that the picture shows beside each other


class TaskFleet(Panel):
    """The panel.  folder : of the records.  found : the result, None before a run."""

    guide = "8. Close the loop: readings in, the missing effect out"
    standard = ("Close",)

    def __init__(self, document):
        self.document, self.folder, self.names = document, "", []
        self.found: FleetResult | None = None
        self.make_form("SensFleet", translate("Sens", "A fleet of machines"), "Sens_Fleet")
        page = QtGui.QVBoxLayout(self.form)
        page.addLayout(self._asked())
        self.tabs = self.grows = QtGui.QTabWidget()
        self.tabs.setObjectName("SensFleetTabs")
        heads = [
            translate("Sens", "Driven by"), translate("Sens", "Machines"), translate("Sens", "Median, µm"),
            translate("Sens", "Effect"),
        ]  # fmt: skip
        self.effects = table("SensRecurring", heads, "recurring.csv", self._draw, 1)
        heads = [translate("Sens", "Machine"), translate("Sens", "Verdict"), translate("Sens", "Effects"),
                 translate("Sens", "Error, µm")]  # fmt: skip
        self.machines = table("SensMembers", heads, "machines.csv")
        self.machines.headerItem().setToolTip(
            3, translate("Sens", "3-D rms of readings that took no part in the fit: declared → with the effects")
        )
        self.picture = Picture(self._painted)
        for widget, title in (
            (self.effects, translate("Sens", "What recurs")), (self.machines, translate("Sens", "Machines")),
            (self.picture, translate("Sens", "Picture")),
        ):  # fmt: skip
            self.tabs.addTab(widget, title)
        page.addWidget(self.tabs)
        self.summary = QtGui.QLabel()
        self.summary.setObjectName("SensFleetSummary")
        self.summary.setWordWrap(True)
        page.addWidget(self.summary)
        row = QtGui.QHBoxLayout()
        self.run_button = QtGui.QPushButton(translate("Sens", "Trace all"))
        self.run_button.clicked.connect(self.run)
        self.report_button = QtGui.QPushButton(translate("Sens", "Report…"))
        self.report_button.setToolTip(translate("Sens", "Writes what was found as a page, and as JSON and CSV"))
        self.report_button.clicked.connect(self.ask_report)
        row.addWidget(self.run_button)
        row.addWidget(self.report_button)
        page.addLayout(row)
        self.forget()

    def _asked(self):
        form, row = rows(), QtGui.QHBoxLayout()
        self.place = QtGui.QLabel()
        self.place.setWordWrap(True)
        choose = QtGui.QToolButton()
        choose.setText(translate("Sens", "Folder…"))
        choose.setToolTip(translate("Sens", "Holds a folder for each machine, with machine.json and measured.csv"))
        choose.clicked.connect(self.ask_folder)
        row.addWidget(self.place, 1)
        row.addWidget(choose)
        self.rate = number_box(0.1, 50, 1, 1.0, " %")
        self.rate.setValue(100 * RATE)
        self.rate.setToolTip(translate("Sens", "Share of false effects among those that stand (false discovery rate)"))
        self.rate.valueChanged.connect(self.forget)
        form.addRow(translate("Sens", "Records"), row)
        form.addRow(translate("Sens", "False names"), self.rate)
        return form

    # -- the study ---------------------------------------------------------------------------------------------------
    def forget(self, *_) -> None:
        """Something else is asked: the last answer goes."""
        self.found = None
        self.effects.clear()
        self.machines.clear()
        self.picture.update()
        if self.names:
            text = translate("Sens", "{n} machines in {folder}").format(
                n=len(self.names), folder=Path(self.folder).name
            )
        else:
            text = translate("Sens", "no folder yet")
        self.place.setText(text)
        self.summary.setText(translate("Sens", "Traces every record by the same rules: which effect recurs where."))
        self._enable()

    def _enable(self) -> None:
        self.run_button.setEnabled(bool(self.names))
        self.report_button.setEnabled(self.found is not None)

    def ask_folder(self, *_) -> None:
        """Ask for the folder of the records."""
        folder = messages.ask_folder(translate("Sens", "Folder of the fleet"))
        if folder:
            self.take(folder)

    def take(self, folder) -> None:
        """Take a folder; one without records is refused, and the one before stays."""
        try:
            names = fleet_files.members(folder)
        except Refused as error:
            messages.show(messages.words(error))
            return
        self.folder, self.names = str(folder), names
        self.forget()

    def run(self, *_) -> bool:
        """Trace all records; whether it went through."""
        self.forget()
        names, read, rate = self.names, fleet_files.Reader(self.folder), self.rate.value() / 100
        try:
            self.found = live.in_background(
                lambda tell: fleet_study(names, read, None, rate, progress=tell),
                translate("Sens", "Tracing {n} records").format(n=len(names)),
            )
        except Refused as error:
            self.summary.setText(messages.words(error))
            return False
        except Cancelled:
            self.summary.setText(translate("Sens", "Cancelled; nothing was changed"))
            return False
        self._fill(self.found)
        self._enable()
        return True

    def _fill(self, found: FleetResult) -> None:
        language = messages.language()
        for view in (self.effects, self.machines):
            view.setSortingEnabled(False)
        for effect in found.recurring:
            size = median_um(effect)
            texts = (f"{effect.component} · {effect.driver}", str(len(effect.machines)), f"{size:.3g}",
                     effect.title.text(language))  # fmt: skip
            where = "\n".join(effect.machines)
            add_row(self.effects, texts, {1: len(effect.machines), 2: size}, effect.machines, tips={1: where})
        for member in found.members:
            if member.refused:
                texts = (member.name, translate("Sens", "refused"), "", "")
                add_row(self.machines, texts, key=member.name, tips={1: member.refused})
                continue
            verdict = messages.words(_verdict(member.verdict))
            standing = [e.title.text(language) for e in member.effects if e.held]
            error = f"{member.declared:.3g} → {member.augmented:.3g}"
            texts = (member.name, verdict, str(len(standing)), error)
            add_row(self.machines, texts, {2: len(standing)}, member.name, tips={2: "\n".join(standing)})
        self.effects.setSortingEnabled(True)
        fit_columns(self.effects, {0: 130, 1: 75, 2: 80, 3: 400})
        fit_columns(self.machines, {0: 110, 1: 120})
        traced = [m for m in found.members if not m.refused]
        words = translate("Sens", "{n} records, {refused} refused; an effect stands on {some} machines.")
        words += " " + translate("Sens", "p up to {limit} stands; every p comes from {count} exchanges.")
        self.summary.setText(words.format(
            n=len(found.members), refused=len(found.members) - len(traced),
            some=sum(any(e.held for e in m.effects) for m in traced), limit=f"{found.limit:.2g}",
            count=found.permutations,
        ))  # fmt: skip
        self._draw()

    def _draw(self, *_) -> None:
        self.picture.update()

    def _painted(self, width: int, height: int):
        """The picture: machines downwards, effects to the right, a dot as large as the effect where it stands."""
        found = self.found
        if found is None or not found.recurring:
            return None
        shown = found.recurring[:MOST_COLUMNS]
        names = [m.name for m in found.members if not m.refused]
        sizes = [
            [um(e.amplitudes[e.machines.index(n)]) if n in e.machines else None for e in shown] for n in names
        ]  # fmt: skip
        chosen = {i.data(0, KEY) for i in self.effects.selectedItems()}
        marked = [e.machines in chosen for e in shown]
        heads = [f"{e.component} · {e.driver}" for e in shown]
        return plots.dots_table(width, height, names, heads, sizes, marked, "µm", self.form.palette())

    def ask_report(self, *_) -> list:
        """Ask for a folder and write the files of the verb there; returns their paths."""
        folder = messages.ask_folder(translate("Sens", "Folder for the report"))
        if not folder or self.found is None:
            return []
        files = fleet_files.files(self.found, messages.language())
        if not messages.may_write(folder, files):
            return []
        try:
            with provenance.running("fleet", [self.folder], self.found.seed):
                fleet_files.Reader(self.folder).note_inputs(self.names)
                paths = study_files.write_set(folder, "fleet", files)
        except Refused as error:
            messages.show(messages.words(error))
            return []
        messages.written(paths)
        return paths


def _verdict(verdict: str):
    from ..messages import Message

    return Message(f"tr-verdict-{verdict.replace('_', '-')}")


def open_panel(document) -> TaskFleet:
    """Open the panel beside a document."""
    panel = TaskFleet(document)
    show_panel(panel, document)
    return panel


@command
class Fleet(Command):
    name = "Sens_Fleet"
    menu_text = QT_TRANSLATE_NOOP("Sens_Fleet", "Fleet…")
    tip = QT_TRANSLATE_NOOP("Sens_Fleet", "Traces the records of many machines: which effect recurs on which machine")
    guide, needs = TaskFleet.guide, "document"
    where = Where("loop", 90, toolbar=False)

    def run(self):
        open_panel(App.ActiveDocument)
