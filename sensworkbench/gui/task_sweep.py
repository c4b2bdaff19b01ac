# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that tries many designs: numbers of the machine, or cells and properties of the document, over ranges.

It writes a specification and what `sweep` writes for it into a folder, and shows the table, the Pareto front and
parallel coordinates.  A run that was cancelled goes on from where it ended.
"""

from __future__ import annotations

import contextlib
import csv
import json
import re
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

import FreeCADGui as Gui

from ..core.refusal import Refused
from ..core.workspace import Cancelled
from ..document import extract, sweeping
from ..document.base import kind_of
from ..document.sweep_workers import WorkerEnded, WorkerJudge
from ..formats import machine_json, provenance, sweep_files, sweep_run
from ..studies.sweep import OUTPUTS, FileJudge, run_sweep
from . import live, messages, plots
from .command import Command, Where, command
from .current import current_machine
from .panel import Panel, rows
from .panel import show as show_panel
from .preferences import combo, read_field, write_field
from .qt import QT_TRANSLATE_NOOP, Qt, QtGui, translate
from .task_study import KEY, add_row, fit_columns, table

SPEC, MACHINE = "sweep.json", "machine.json"
FIELDS, DOCUMENT = "fields", "document"
PATH, LOW, HIGH, STEPS = range(4)  # columns of the parameters
MOST_ROWS = 2000  # variants that the table shows
MOST_WORKERS = 16
CHUNKS = 16  # that a run has at least, so that Cancel is answered
USUAL_COUNT = 64
REACH_MM = 100.0  # about the present place of a point, where no range is given
WHOLE = 0.2  # of the present value of anything else


class TaskSweep(Panel):
    """The panel.  folder : of the files, "" until a run.  names, rows : columns of the table and its variants."""

    guide = "4. What if"
    standard = ("Close",)

    def __init__(self, machine):
        self.machine, self.document = machine, machine.Document
        self.core = extract.core_machine(machine)  # refuses before anything is opened
        self.folder, self.names, self.rows, self.front = "", [], [], set()
        self.make_form("SensSweep", translate("Sens", "Try many designs"), "Sens_Sweep")
        page = QtGui.QVBoxLayout(self.form)
        page.addLayout(self._asked())
        self.tabs = self.grows = QtGui.QTabWidget()
        self.tabs.setObjectName("SensSweepTabs")
        self.tabs.addTab(self._parameters(), translate("Sens", "Parameters"))
        self.table = table("SensVariants", [], "variants.csv", self._draw, 0)
        self.table.header().setSortIndicator(0, Qt.AscendingOrder)
        self.tabs.addTab(self.table, translate("Sens", "Variants"))
        self.picture = Picture(self._painted)
        self.tabs.addTab(self.picture, translate("Sens", "Picture"))
        page.addWidget(self.tabs)
        self.summary = QtGui.QLabel()
        self.summary.setObjectName("SensSweepSummary")
        self.summary.setWordWrap(True)
        page.addWidget(self.summary)
        page.addLayout(self._buttons())
        self.forget()

    # -- what is asked -----------------------------------------------------------------------------------------------
    def _asked(self):
        form = rows()
        self.of = combo([
            (FIELDS, translate("Sens", "numbers of the machine")), (DOCUMENT, translate("Sens", "cells, properties")),
        ])  # fmt: skip
        self.of.setToolTip(translate("Sens", "Cells of spreadsheets and properties: FreeCAD recomputes each variant"))
        self.design = combo([
            ("full", translate("Sens", "every combination")), ("lhs", translate("Sens", "Latin hypercube")),
            ("sobol", translate("Sens", "Sobol' points")), ("list", translate("Sens", "a list")),
        ])  # fmt: skip
        self.count = QtGui.QSpinBox()
        self.count.setRange(1, 10_000_000)
        self.count.setValue(USUAL_COUNT)
        self.count.setToolTip(translate("Sens", "Number of variants"))
        self.outputs = QtGui.QToolButton()
        self.outputs.setPopupMode(QtGui.QToolButton.InstantPopup)
        self.outputs.setToolTip(translate("Sens", "What is computed for each variant"))
        menu = QtGui.QMenu(self.outputs)
        for name in (*OUTPUTS, *(f"share.{body}" for body in self.core.bodies)):
            action = menu.addAction(name)
            action.setCheckable(True)
            action.setChecked(name in ("rms", "worst_rms"))
            action.toggled.connect(self._outputs_chosen)
        self.outputs.setMenu(menu)
        self.workers = QtGui.QSpinBox()
        self.workers.setRange(1, MOST_WORKERS)
        self.workers.setToolTip(translate("Sens", "FreeCAD processes that compute variants beside each other"))
        row = QtGui.QHBoxLayout()
        row.addWidget(self.design, 1)
        row.addWidget(self.count)
        more = QtGui.QHBoxLayout()
        more.addWidget(self.outputs, 1)
        more.addWidget(QtGui.QLabel(translate("Sens", "Workers")))
        more.addWidget(self.workers)
        form.addRow(translate("Sens", "Vary"), self.of)
        form.addRow(translate("Sens", "Design"), row)
        form.addRow(translate("Sens", "Compute"), more)
        self.of.currentIndexChanged.connect(self._of_chosen)
        self.design.currentIndexChanged.connect(self._design_chosen)
        self.count.valueChanged.connect(self.forget)
        return form

    def _parameters(self):
        page = QtGui.QWidget()
        column = QtGui.QVBoxLayout(page)
        column.setContentsMargins(0, 4, 0, 0)
        row = QtGui.QHBoxLayout()
        self.path = QtGui.QComboBox()
        self.path.setEditable(True)
        self.path.setSizeAdjustPolicy(QtGui.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        self.path.setMinimumContentsLength(12)
        self.path.setToolTip(
            translate("Sens", "Where the number stands: joints.Z.point.2, Spreadsheet.reach, Box.Length")
        )
        add, remove = QtGui.QToolButton(), QtGui.QToolButton()
        add.setText(translate("Sens", "Add"))
        remove.setText(translate("Sens", "Remove"))
        add.clicked.connect(lambda *_: self.add(self.path.currentText()))
        remove.clicked.connect(self._remove)
        row.addWidget(self.path, 1)
        row.addWidget(add)
        row.addWidget(remove)
        column.addLayout(row)
        self.asked = QtGui.QTableWidget(0, 4)
        self.asked.setObjectName("SensParameters")
        self.asked.verticalHeader().hide()
        self.asked.itemChanged.connect(self.forget)
        column.addWidget(self.asked)
        self._of_chosen()
        self._design_chosen()
        self._outputs_chosen()
        return page

    def _buttons(self):
        row = QtGui.QHBoxLayout()
        self.run_button, self.open_button = QtGui.QPushButton(), QtGui.QPushButton()
        self.report_button = QtGui.QPushButton()
        for button, text, tip, run in (
            (self.run_button, translate("Sens", "Run…"),
             translate("Sens", "Computes every variant; asks for the folder of the files"), self.ask_and_run),
            (self.open_button, translate("Sens", "Open…"),
             translate("Sens", "Reads a sweep.json, to change it or to go on where it was cancelled"), self.ask_open),
            (self.report_button, translate("Sens", "Report"),
             translate("Sens", "Opens the page with all variants and the Pareto front"), self.open_report),
        ):  # fmt: skip
            button.setText(text)
            button.setToolTip(tip)
            button.clicked.connect(run)
            row.addWidget(button)
        return row

    def _of_chosen(self, *_) -> None:
        self.path.clear()
        self.path.addItems(self.paths())
        self.asked.setRowCount(0)
        self.forget()

    def _design_chosen(self, *_) -> None:
        design = read_field(self.design)
        self.count.setVisible(design in ("lhs", "sobol"))
        values = translate("Sens", "Values") if design == "list" else translate("Sens", "From")
        heads = [translate("Sens", "Parameter"), values, translate("Sens", "Up to"), translate("Sens", "Steps")]
        self.asked.setHorizontalHeaderLabels(heads)
        self.asked.setColumnHidden(HIGH, design == "list")
        self.asked.setColumnHidden(STEPS, design != "full")
        for column, width in enumerate((140, 62, 62, 48)):
            self.asked.setColumnWidth(column, width)
        self.asked.horizontalHeader().setStretchLastSection(design != "full")
        self.forget()

    def _outputs_chosen(self, *_) -> None:
        text = ", ".join(self.chosen_outputs()) or translate("Sens", "nothing")
        self.outputs.setText(text if len(text) < 26 else text[:24] + "…")
        self.forget()

    def chosen_outputs(self) -> list[str]:
        """Names of the outputs with a tick."""
        return [a.text() for a in self.outputs.menu().actions() if a.isChecked()]

    def paths(self) -> list[str]:
        """Paths that are offered: numbers of the machine's file, or cells and properties of the document."""
        if read_field(self.of) == FIELDS:
            found = [f"joints.{j.name}.point.{i}" for j in self.core.joints for i in range(3)]
            found += [f"joints.{j.name}.travel.{i}" for j in self.core.joints if j.travel is not None for i in range(2)]
            found += [f"tool_point.{i}" for i in range(3)]
            return found + [f"tolerances.{s}.upper" for s in self.core.all_tolerances]
        found = []
        for sheet in self.document.findObjects("Spreadsheet::Sheet"):
            found += [f"{sheet.Name}.{cell}" for cell in _cells(sheet)]
        for obj in Gui.Selection.getSelection(self.document.Name):
            if not kind_of(obj):
                found += [f"{obj.Name}.{p}" for p in obj.PropertiesList if _numeric(obj, p)]
                if "Placement" in obj.PropertiesList:
                    found += [f"{obj.Name}.Placement.Base.{axis}" for axis in "xyz"]
        return found

    def add(self, path: str) -> None:
        """Add a parameter, with a range about its present value."""
        path = path.strip()
        if not path or any(self._text(r, PATH) == path for r in range(self.asked.rowCount())):
            return
        try:
            value = self._value(path)
        except Refused as error:
            messages.show(messages.words(error))
            return
        if re.search(r"\.(point|travel)\.\d$|^tool_point|\.Placement\.", path):
            low, high = value - REACH_MM, value + REACH_MM
        elif path.startswith("tolerances."):
            low, high = value / 2, value * 2
        else:
            low, high = sorted((value * (1 - WHOLE), value * (1 + WHOLE))) if value else (0.0, 1.0)
        if read_field(self.design) == "list":
            texts = [path, "; ".join(f"{v:.6g}" for v in (low, value, high)), "", ""]
        else:
            texts = [path, f"{low:.6g}", f"{high:.6g}", "5"]
        self.add_row(texts)

    def add_row(self, texts) -> None:
        """Add a parameter as it stands in the table: path, from, to, steps."""
        row = self.asked.rowCount()
        self.asked.insertRow(row)
        for column, text in enumerate(texts):
            item = QtGui.QTableWidgetItem(text)
            if column == PATH:
                item.setFlags(item.flags() & ~Qt.ItemIsEditable)
                item.setToolTip(text)
            self.asked.setItem(row, column, item)
        self.forget()

    def _remove(self, *_) -> None:
        for row in sorted({i.row() for i in self.asked.selectedItems()}, reverse=True):
            self.asked.removeRow(row)
        self.forget()

    def _text(self, row: int, column: int) -> str:
        item = self.asked.item(row, column)
        return item.text().strip() if item is not None else ""

    def _value(self, path: str) -> float:
        """The present value at a path; refuses one that leads to no number."""
        if read_field(self.of) == FIELDS:
            from ..studies.sweep import place_of

            holder, key = place_of(self._data(), path)
            return float(holder[key])
        sweeping.place(self.document, path)
        return sweeping.value(self.document, path)

    def _data(self) -> dict:
        return machine_json.to_dict(replace(self.core, version=2, tolerances=self.core.all_tolerances))

    # -- the specification -------------------------------------------------------------------------------------------
    def spec(self, machine: str) -> dict:
        """The specification as `sweep` reads it.  machine : name of the file beside it."""
        design = read_field(self.design)
        parameters = []
        for row in range(self.asked.rowCount()):
            entry = {"path": self._text(row, PATH)}
            first = self._text(row, LOW)
            if ";" in first or design == "list":
                entry["values"] = [_number(t, row) for t in first.split(";") if t.strip()]
            else:
                entry["range"] = [_number(first, row), _number(self._text(row, HIGH), row)]
                if design == "full":
                    entry["range"].append(int(_number(self._text(row, STEPS), row)))
            parameters.append(entry)
        data = {"machine": machine, "parameters": parameters, "design": design, "outputs": self.chosen_outputs()}
        return data | ({"n": self.count.value(), "seed": 0} if design in ("lhs", "sobol") else {})

    def ask_open(self, *_) -> None:
        """Ask for a specification and show it."""
        path = messages.ask_open(translate("Sens", "Specification of a sweep"), "JSON (*.json)")
        if path:
            self.open_spec(path)

    def open_spec(self, path) -> None:
        """Show a specification; its folder is proposed for the next run."""
        try:
            sweep = sweep_files.load(path)
        except Refused as error:
            messages.show(messages.words(error))
            return
        data = json.loads(Path(path).read_text(encoding="utf-8"))
        write_field(self.of, DOCUMENT if sweep.document else FIELDS)
        write_field(self.design, sweep.design)
        if sweep.count:
            self.count.setValue(sweep.count)
        for action in self.outputs.menu().actions():
            action.setChecked(action.text() in sweep.outputs)
        self.asked.setRowCount(0)
        for entry in data["parameters"]:
            if "values" in entry:
                texts = ["; ".join(f"{v:.12g}" for v in entry["values"]), "", ""]
            else:
                texts = [f"{v:.12g}" for v in entry["range"]] + [""]
            self.add_row([entry["path"], *texts[:3]])
        self.folder = str(Path(path).parent)
        self.show_results()

    # -- the run -----------------------------------------------------------------------------------------------------
    def forget(self, *_) -> None:
        """Something else is asked: what was found goes from the panel, and stays in its folder."""
        if not hasattr(self, "run_button"):
            return
        self.rows, self.front = [], set()
        self.table.clear()
        self.picture.update()
        self.summary.setText(
            translate("Sens", "Computes the machine in many variants and shows which of them are best.")
        )
        self._enable()

    def _enable(self) -> None:
        self.run_button.setEnabled(self.asked.rowCount() > 0 and bool(self.chosen_outputs()))
        self.report_button.setEnabled(bool(self.rows) and (Path(self.folder) / "report.html").is_file())

    def ask_and_run(self, *_) -> None:
        """Ask for a folder, that of the last run unless there was none, and run."""
        folder = messages.ask_folder(translate("Sens", "Folder for the variants"))
        if folder:
            self.run(folder)

    def run(self, folder) -> bool:
        """Compute every variant, or those that an interrupted run of the same lacks; whether it went through."""
        self.forget()
        self.folder = str(folder)
        try:
            self._check()
            words, workers, language = self._prepare(Path(folder)), self.workers.value(), messages.language()
            sweep = sweep_files.load(words)
            done = sweep_files.kept(folder, sweep)
            title = translate("Sens", "Computing {n} variants").format(n=sweep.size())
            if done:
                title += "\n" + translate("Sens", "{n} of them are there already").format(n=len(done))
            live.in_background(lambda tell: _swept(words, done, workers, language, tell), title)
        except Refused as error:
            self.summary.setText(messages.words(error))
            return False
        except Cancelled:
            text = translate("Sens", "Cancelled. Run… with the same folder goes on from there.")
            self.summary.setText(text)
            return False
        except WorkerEnded:
            self.summary.setText(
                translate("Sens", "A FreeCAD process ended without an answer; the report view may say why.")
            )
            return False
        self.show_results()
        return True

    def _check(self) -> None:
        """Refuse paths of the document that lead nowhere."""
        if read_field(self.of) == DOCUMENT:
            for row in range(self.asked.rowCount()):
                sweeping.place(self.document, self._text(row, PATH))

    def _prepare(self, folder: Path) -> Path:
        """Write machine or document and the specification into the folder; returns the path of the latter."""
        folder.mkdir(parents=True, exist_ok=True)
        if read_field(self.of) == FIELDS:
            machine = MACHINE
            _put(folder / machine, machine_json.dumps(replace(self.core, version=2)))
        else:
            saved = self.document.FileName
            changed = Gui.getDocument(self.document.Name).Modified
            if saved and not changed:
                machine = saved
            else:
                machine = f"{self.document.Name}.FCStd"
                self.document.saveCopy(str(folder / machine))
        _put(folder / SPEC, json.dumps(self.spec(machine), indent=1) + "\n")
        return folder / SPEC

    # -- what was found ----------------------------------------------------------------------------------------------
    def show_results(self) -> None:
        """Show the table of the folder, if it is there."""
        path = Path(self.folder) / sweep_files.RESULTS
        if not path.is_file():
            self._enable()
            return
        with path.open(encoding="utf-8", newline="") as stream:
            reader = csv.reader(stream)
            self.names = next(reader)[:-1]
            self.rows, refused, count = [], 0, 0
            for row in reader:
                count += 1
                refused += bool(row[-1])
                if len(self.rows) < MOST_ROWS:
                    self.rows.append(row)
        with (Path(self.folder) / sweep_files.PARETO).open(encoding="utf-8", newline="") as stream:
            self.front = {row[0] for row in list(csv.reader(stream))[1:]}
        self._fill()
        words = translate("Sens", "{n} variants, {best} on the Pareto front (bold), {refused} refused. Files: {folder}")
        text = words.format(n=count, best=len(self.front), refused=refused, folder=Path(self.folder).name)
        if count > len(self.rows):
            text += " " + translate("Sens", "The first {n} are shown.").format(n=len(self.rows))
        self.summary.setText(text)
        self.summary.setToolTip(str(self.folder))
        self.tabs.setCurrentIndex(1)
        self._enable()

    def _fill(self) -> None:
        view = self.table
        view.setSortingEnabled(False)
        view.clear()
        view.setColumnCount(len(self.names))
        view.setHeaderLabels(["#", *(_short(n) for n in self.names[1:])])
        for i, name in enumerate(self.names):
            view.headerItem().setToolTip(i, name)
        for row in self.rows:
            values = {i: float(v) for i, v in enumerate(row[:-1]) if v}
            texts = [row[0], *(f"{float(v):.4g}" if v else "–" for v in row[1:-1])]
            tips = {i: row[-1] for i in range(len(texts))} if row[-1] else {}
            add_row(view, texts, values, row[0], bold=row[0] in self.front, tips=tips)
        view.setSortingEnabled(True)
        fit_columns(view, {i: 88 for i in range(1, len(self.names))})
        self._draw()

    def _draw(self, *_) -> None:
        self.picture.update()

    def _painted(self, width: int, height: int):
        """The picture: every variant a line, the front and the chosen ones on top."""
        good = [r for r in self.rows if not r[-1]]
        if not good or len(self.names) < 3:
            return None
        numbers = [[float(v) for v in r[1:-1]] for r in good]
        chosen = {i.data(0, KEY) for i in self.table.selectedItems()}
        return plots.parallel(
            width, height, self.names[1:], numbers, [r[0] in self.front for r in good], [r[0] in chosen for r in good],
            [translate("Sens", "variants"), translate("Sens", "Pareto front"), translate("Sens", "chosen")],
            self.form.palette(),
        )  # fmt: skip

    def open_report(self, *_) -> None:
        """Open the page of the run."""
        from .qt import QtCore

        QtGui.QDesktopServices.openUrl(QtCore.QUrl.fromLocalFile(str(Path(self.folder) / "report.html")))


class Picture(QtGui.QWidget):
    """A widget that shows what `paint(width, height)` gives, a QImage or None."""

    def __init__(self, paint):
        super().__init__()
        self.paint = paint
        self.setMinimumHeight(120)

    def paintEvent(self, _event):
        image = self.paint(self.width(), self.height())
        if image is not None:
            pen = QtGui.QPainter(self)
            pen.drawImage(0, 0, image)
            pen.end()


def _swept(spec: Path, done, workers: int, language: str, tell):
    """Judge and write the variants of a specification that are not `done`; touches no open document."""
    with provenance.running("sweep", [str(spec)]), contextlib.ExitStack() as stack:
        sweep = sweep_files.load(spec)
        left, pool = max(1, sweep.size() - len(done)), None
        chunk = max(1, min(sweep_run.chunk_of(left, workers), -(-left // (CHUNKS * workers))))
        if sweep.document or workers > 1:
            judge, chunk = WorkerJudge(spec), max(chunk, 8)
            pool = ThreadPoolExecutor(workers)
            stack.callback(pool.shutdown, True, cancel_futures=True)
        else:
            judge = FileJudge(sweep_files.machine_of, sweep.data, sweep.paths, sweep.outputs)
        judged = run_sweep(sweep, judge, pool, workers, len(done), tell, chunk)
        return sweep_run.write(spec.parent, sweep, done, judged, language)


def _put(path: Path, text: str) -> None:
    """Write a file unless it holds this text already."""
    if not path.is_file() or path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8", newline="\n")


def _number(text: str, row: int) -> float:
    try:
        return float(text.strip().replace(",", "."))
    except ValueError:
        raise Refused("sweep-not-a-number", f"parameters, {row + 1}", text=repr(text)[:40]) from None


def _short(path: str) -> str:
    """A path without its first step, which all paths of a kind share."""
    return path.split(".", 1)[1] if path.startswith(("joints.", "tolerances.")) else path


def _cells(sheet) -> list[str]:
    """Aliases, else addresses, of the cells that hold a number."""
    found = []
    for cell in sorted(p for p in sheet.PropertiesList if re.fullmatch(r"[A-Z]{1,2}[0-9]{1,5}", p)):
        if not isinstance(getattr(sheet, cell), str):
            found.append(sheet.getAlias(cell) or cell)
    return found


def _numeric(obj, name: str) -> bool:
    return obj.getTypeIdOfProperty(name) in (
        "App::PropertyLength", "App::PropertyDistance", "App::PropertyFloat", "App::PropertyAngle",
        "App::PropertyQuantityConstraint", "App::PropertyFloatConstraint", "App::PropertyInteger",
    )  # fmt: skip


def open_panel(machine) -> TaskSweep:
    """Open the panel for a machine."""
    panel = TaskSweep(machine)
    show_panel(panel, machine.Document)
    return panel


@command
class Sweep(Command):
    name = "Sens_Sweep"
    menu_text = QT_TRANSLATE_NOOP("Sens_Sweep", "Try Many Designs…")
    tip = QT_TRANSLATE_NOOP(
        "Sens_Sweep", "Computes the machine in many variants: table, Pareto front, parallel coordinates"
    )
    guide = TaskSweep.guide
    where = Where("analysis", 75, tree=("Machine",))

    def run(self):
        open_panel(current_machine())
