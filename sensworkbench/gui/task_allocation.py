# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that finds the cheapest tolerances for a target: each before and after, a button to apply, one to undo.

The study (`studies.allocation`) runs in the background on a copy; the document changes only with Apply.
"""

from __future__ import annotations

from ..core.allocation import PowerCost
from ..core.refusal import Refused
from ..core.workspace import Cancelled
from ..document import extract, factory, tables, tree
from ..document.tables import read_units
from ..formats import allocation_json, costs_csv, grade_catalogue, study_files
from ..studies.allocation import AllocationResult, Target, allocation_study
from . import display, live, messages, pointers
from .command import Command, Where, command
from .copying import copyable
from .current import current_machine
from .panel import Panel
from .panel import rows as form_rows
from .panel import show as show_panel
from .preferences import combo, number_box, read_field
from .prices import Prices
from .qt import QT_TRANSLATE_NOOP, Qt, QtGui, translate
from .ranking import NumericItem
from .texts import limits, meaning

ERROR, BEFORE, AFTER, COST, GRADE, MEANING = range(6)
SYMBOL, BODY = Qt.UserRole + 2, Qt.UserRole + 3
WIDEST = {ERROR: 80, BEFORE: 90, AFTER: 90, MEANING: 150}  # pixels; the tool tip says the rest
TIGHTEST, LOOSEST = 0.1, 4.0  # of the present half width, where no prices are given


def targets():
    """Return (kind, text) of the targets that are offered."""
    return [
        ("rms", translate("Sens", "rms over the workspace")),
        ("worst", translate("Sens", "rms at the worst place")),
        ("quantile", translate("Sens", "95 % of all errors below")),
    ]


def present_costs(core) -> dict[str, PowerCost]:
    """Prices where none are given: each tolerance costs 1 as it is, half of it costs 2, twice as much costs ½."""
    found = {}
    for symbol, law in core.all_tolerances.items():
        half = (law.upper - law.lower) / 2
        if half > 0:
            found[symbol] = PowerCost(half, 1.0, TIGHTEST * half, LOOSEST * half)
    return found


class TaskAllocation(Prices, Panel):
    """The panel; `found` is the result of the study, None before it and after a change of what is asked."""

    guide = "2. Tolerances"
    standard = ("Close",)

    def __init__(self, machine):
        self.machine, self.document = machine, machine.Document
        self.core = extract.core_machine(machine)  # refuses before anything is opened
        self.costs, self.found, self.undo_name = present_costs(self.core), None, ""
        self.make_form("SensAllocation", translate("Sens", "Allocate tolerances"), "Sens_Allocate")
        page = QtGui.QVBoxLayout(self.form)
        page.addLayout(self._asked())
        self.table = self.grows = self._table()
        page.addWidget(self.table)
        self.summary = QtGui.QLabel()
        self.summary.setObjectName("SensAllocationSummary")
        self.summary.setWordWrap(True)
        page.addWidget(self.summary)
        page.addLayout(self._buttons())
        self.forget()

    def _asked(self):
        rows = form_rows()
        self.kind = combo(targets())
        self.value = number_box(0.001, 1e6, 3, 1.0, " µm")
        self.value.setToolTip(translate("Sens", "The error that the tolerances together may cause"))
        self.value.setValue(self._proposed())
        self.prices = QtGui.QLabel(translate("Sens", "halving a tolerance doubles its cost"))
        self.prices.setWordWrap(True)
        load = QtGui.QToolButton()
        load.setText(translate("Sens", "From file…"))
        load.setToolTip(translate("Sens", "Reads prices: symbol, kind, c, k, lower, upper, or grades (see Allocation)"))
        load.clicked.connect(self.ask_costs)
        row = QtGui.QHBoxLayout()
        self.catalogue = QtGui.QToolButton()
        self.catalogue.setText(translate("Sens", "Catalogue"))
        self.catalogue.setToolTip(
            translate(
                "Sens", "Grades of guides, screws and scales for straightness and positioning; the rest as before"
            )
        )
        self.catalogue.clicked.connect(self.load_catalogue)
        row.addWidget(self.prices, 1)
        row.addWidget(self.catalogue)
        row.addWidget(load)
        rows.addRow(translate("Sens", "Target"), self.kind)
        self.compute_button = QtGui.QPushButton(translate("Sens", "Allocate"))
        self.compute_button.clicked.connect(self.compute)
        limit = QtGui.QHBoxLayout()
        limit.addWidget(self.value, 1)
        limit.addWidget(self.compute_button)
        rows.addRow(translate("Sens", "Cost"), row)
        rows.addRow(translate("Sens", "at most"), limit)
        self.kind.currentIndexChanged.connect(self.forget)
        self.value.valueChanged.connect(self.forget)
        return rows

    def _table(self):
        table = QtGui.QTreeWidget()
        table.setObjectName("SensAllocated")
        table.setRootIsDecorated(False)
        table.setAlternatingRowColors(True)
        table.setUniformRowHeights(True)
        table.setSelectionMode(QtGui.QAbstractItemView.ExtendedSelection)
        table.setHeaderLabels([
            translate("Sens", "Error"), translate("Sens", "Now"), translate("Sens", "Then"), translate("Sens", "Cost"),
            translate("Sens", "Grade"), translate("Sens", "Meaning"),
        ])  # fmt: skip
        table.setSortingEnabled(True)
        table.sortByColumn(COST, Qt.DescendingOrder)
        table.itemSelectionChanged.connect(self._point)
        copyable(table, "allocation.csv")
        return table

    def _buttons(self):
        row = QtGui.QHBoxLayout()
        self.apply_button = QtGui.QPushButton(translate("Sens", "Apply"))
        self.apply_button.setToolTip(translate("Sens", "Writes the tolerances to the machine, one undo step"))
        self.undo_button = QtGui.QPushButton(translate("Sens", "Undo"))
        self.undo_button.setToolTip(translate("Sens", "Gives the machine its former tolerances back"))
        self.report_button = QtGui.QPushButton(translate("Sens", "Report…"))
        self.report_button.setToolTip(translate("Sens", "Writes the tolerances, what other targets cost, and a report"))
        for button, run in (
            (self.apply_button, self.apply), (self.undo_button, self.undo), (self.report_button, self.ask_report),
        ):  # fmt: skip
            button.clicked.connect(run)
            row.addWidget(button)
        return row

    def _proposed(self) -> float:
        """Three quarters of the present rms over the workspace, µm, where it is known; else 10."""
        result = tree.sensitivity_of(self.machine)
        if result is None or result.MeanSquare <= 0 or result.Stale:
            return 10.0
        objective = extract.objective(self.machine)
        return 10.0 if objective.power != 2 else float(f"{0.75 * objective.size_shown(result.MeanSquare):.2g}")

    # -- the study ---------------------------------------------------------------------------------------------------
    def forget(self, *_) -> None:
        """Something else is asked: the last answer goes."""
        self.found = None
        self.table.clear()
        self.summary.setText(translate("Sens", "Finds the cheapest tolerances that meet the target."))
        self._enable()

    def _enable(self) -> None:
        self.apply_button.setEnabled(self.found is not None and not self._applied())
        self.report_button.setEnabled(self.found is not None)
        self.undo_button.setEnabled(self._applied())

    def _applied(self) -> bool:
        """Whether the last step of the document is that of Apply."""
        names = self.document.UndoNames
        return bool(self.undo_name) and bool(names) and names[0] == self.undo_name

    def load_catalogue(self, *_) -> None:
        """Offer the grades of the catalogue for the errors that it holds; the others keep their curve."""
        try:
            self.costs = present_costs(self.core) | costs_csv.load(grade_catalogue.SHIPPED, self.core)
        except Refused as error:
            messages.show(messages.words(error))
            return
        self.prices.setText(translate("Sens", "catalogue, relative costs"))
        self.prices.setToolTip(str(grade_catalogue.SHIPPED))
        self.forget()

    def compute(self, *_) -> None:
        """Run the study and show its tolerances beside the present ones."""
        self.forget()
        core, costs = self.core, self.costs
        try:
            target = Target(read_field(self.kind), self.value.value())
            self.found = live.in_background(
                lambda progress: allocation_study(core, target, costs, progress),
                translate("Sens", "Allocating {n} tolerances").format(n=len(costs)),
            )
        except Refused as error:
            self.summary.setText(messages.words(error))
        except Cancelled:
            self.summary.setText(translate("Sens", "Cancelled; nothing was changed"))
        else:
            self._fill(self.found)
        self._enable()

    def _fill(self, found: AllocationResult) -> None:
        units = read_units(self.machine)
        self.table.setSortingEnabled(False)
        for choice in found.choices:
            c = self.core.component(choice.symbol)
            unit = units.get(choice.symbol) or c.unit
            item = NumericItem(self.table)
            texts = (
                choice.symbol, limits(choice.before.lower, choice.before.upper, unit, c.angular, 3),
                limits(choice.after.lower, choice.after.upper, unit, c.angular, 3), f"{choice.cost:.3g}",
                choice.grade, meaning(self.machine, choice.symbol, {c.symbol: c}),
            )  # fmt: skip
            widths = [law.upper - law.lower for law in (choice.before, choice.after)]
            for column, text in enumerate(texts):
                item.setText(column, text)
                item.setToolTip(column, text)
                if column == AFTER and abs(widths[1] - widths[0]) > 1e-3 * widths[0]:
                    font = item.font(column)
                    font.setBold(True)
                    item.setFont(column, font)
            item.setData(ERROR, SYMBOL, choice.symbol)
            item.setData(ERROR, BODY, c.body)
            for column, value in zip((BEFORE, AFTER, COST), (*widths, choice.cost)):
                item.setData(column, Qt.UserRole, float(value))
                item.setTextAlignment(column, Qt.AlignRight | Qt.AlignVCenter)
        self.table.setSortingEnabled(True)
        for column in range(MEANING + 1):
            self.table.resizeColumnToContents(column)
            self.table.setColumnWidth(column, min(WIDEST.get(column, 70), self.table.columnWidth(column) + 4))
        self.table.setColumnHidden(GRADE, not any(c.grade for c in found.choices))
        self.summary.setText(self._words(found))

    def _words(self, found: AllocationResult) -> str:
        words = translate("Sens", "Cost {cost}; nothing cheaper than {bound} meets the target.")
        lines = [words.format(cost=f"{found.allocation.cost:.4g}", bound=f"{found.allocation.bound:.4g}")]
        if found.normal_bound is not None and found.normal_bound > found.allocation.bound:
            words = translate("Sens", "Were all errors normal, nothing would be cheaper than {bound}.")
            lines.append(words.format(bound=f"{found.normal_bound:.4g}"))
        words = translate("Sens", "rms {before} → {after} µm, at the worst place {worst_before} → {worst_after} µm.")
        values = {
            "before": found.rms_before_um, "after": found.rms_after_um,
            "worst_before": found.worst_before_um, "worst_after": found.worst_after_um,
        }  # fmt: skip
        lines.append(words.format(**{k: f"{v:.3g}" for k, v in values.items()}))
        if found.quantile_um is not None:
            words = translate("Sens", "95 % of all errors below {before} → {after} µm.")
            lines.append(words.format(before=f"{found.quantile_um[0]:.3g}", after=f"{found.quantile_um[1]:.3g}"))
        return " ".join(lines)

    def _point(self) -> None:
        """The bodies of the selected rows are pointed at in the view."""
        bodies = dict.fromkeys(item.data(ERROR, BODY) for item in self.table.selectedItems())
        pointers.show(self.machine, list(bodies))

    # -- the document ------------------------------------------------------------------------------------------------
    def apply(self, *_) -> None:
        """Write the tolerances to the machine and compute its result again where it has one: one undo step."""
        machine, found = self.machine, self.found
        if found is None:
            return
        name = translate("Sens", "Allocate tolerances")

        def change():
            after = {c.symbol: c.after for c in found.choices}
            factory.set_tolerances(machine, tables.read_tolerances(machine) | after, read_units(machine))
            result = tree.sensitivity_of(machine)
            if result is not None and result.Coloured:
                display.compute_and_colour(machine)

        if messages.change(self.document, name, change):
            self.undo_name = name
            messages.status(translate("Sens", "The tolerances are those of the table; Undo gives the former ones back"))
        self._enable()

    def undo(self, *_) -> None:
        """Take the step of Apply back."""
        if self._applied():
            self.document.undo()
            self.document.recompute()
        self._enable()

    def ask_report(self, *_) -> list:
        """Ask for a folder and write allocation.json, the tolerances, the front and the report; returns their paths."""
        folder = messages.ask_folder(translate("Sens", "Folder for the report"))
        if not folder or self.found is None:
            return []
        files = allocation_json.files(self.found, messages.language())
        if not messages.may_write(folder, files):
            return []
        try:
            paths = study_files.write_set(folder, "allocate", files)
        except Refused as error:
            messages.show(messages.words(error))
            return []
        messages.written(paths)
        return paths

    def leave(self) -> None:
        pointers.clear(self.machine)


def open_panel(machine) -> TaskAllocation:
    """Open the panel for a machine."""
    panel = TaskAllocation(machine)
    show_panel(panel, machine.Document)
    return panel


@command
class Allocate(Command):
    name = "Sens_Allocate"
    keys = "Y, A"
    menu_text = QT_TRANSLATE_NOOP("Sens_Allocate", "Allocate Tolerances…")
    tip = QT_TRANSLATE_NOOP("Sens_Allocate", "Finds the cheapest tolerances that meet a target, and applies them")
    guide = TaskAllocation.guide
    where = Where("analysis", 60, tree=("Machine", "Tolerances"))

    def run(self):
        open_panel(current_machine())
