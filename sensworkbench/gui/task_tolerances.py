# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tolerance panel: limits and distribution of every error in a table; OK writes them as one undo step.

Limits may be typed with decimal comma or point and with a unit of their own ("12,5 arcsec"); what cannot be read stays
in its cell, is marked, and holds OK back.
"""

from __future__ import annotations

from ..core.distributions import DISTRIBUTIONS, Tolerance, paper_tolerance
from ..core.errors import Component
from ..core.refusal import Refused
from ..core.units import parse, shown
from ..document import factory, refresh, tables
from ..formats import tolerances as files
from . import messages, settings
from .command import Command, Where, command
from .copying import copyable
from .current import current_machine
from .panel import Panel
from .panel import show as show_panel
from .preferences import combo
from .qt import QT_TRANSLATE_NOOP, Qt, QtCore, QtGui, translate
from .texts import body_name, distribution_name, error_meaning, plain, unit_sign

SYMBOL, LOWER, UPPER, UNIT, LAW, OWNER, MEANING = range(7)
try:
    RIGHT = int(Qt.AlignRight | Qt.AlignVCenter)  # Qt 5 takes nothing else from a model
except TypeError:
    RIGHT = Qt.AlignRight | Qt.AlignVCenter
UNITS = {True: ("urad", "arcsec", "mrad", "deg"), False: ("um", "nm", "mm")}


class Row:
    """One error while it is edited: texts of the limits as typed, unit, distribution."""

    def __init__(self, component: Component, tolerance: Tolerance, unit: str):
        self.symbol, self.component = component.symbol, component
        self.unit, self.distribution, self.sigma = unit, tolerance.distribution, tolerance.sigma
        self.values = {LOWER: tolerance.lower, UPPER: tolerance.upper}  # mm or rad
        self.texts: dict[int, str] = {}  # what was typed and could not be read

    def text(self, column: int) -> str:
        """Return the text of a cell: as typed while it cannot be read, otherwise its value."""
        if column in self.texts:
            return self.texts[column]
        return plain(shown(self.values[column], self.unit, angular=self.component.angular))

    def enter(self, column: int, text: str) -> None:
        """Store what was typed into a cell."""
        try:
            self.values[column] = parse(text, angular=self.component.angular, default_unit=self.unit, where=self.symbol)
            self.texts.pop(column, None)
        except Refused:
            self.texts[column] = text

    def tolerance(self) -> Tolerance:
        """The tolerance, or a refusal that names the error."""
        for column in (LOWER, UPPER):
            if column in self.texts:
                parse(self.texts[column], angular=self.component.angular, default_unit=self.unit, where=self.symbol)
        sigma = self.sigma if self.distribution in ("normal", "truncated_normal") else None
        try:
            return Tolerance(self.values[LOWER], self.values[UPPER], self.distribution, sigma)
        except Refused as error:
            if self.values[UPPER] < self.values[LOWER]:
                raise Refused("gui-limits-reversed", self.symbol) from None
            raise error.at(self.symbol) from None

    def problem(self) -> str:
        """Return why the row cannot be used, or ""."""
        try:
            self.tolerance()
        except Refused as error:
            return messages.words(error)
        return ""


class ToleranceModel(QtCore.QAbstractTableModel):
    """The table behind the panel; nothing here touches the document."""

    def __init__(self, machine, tolerances: dict[str, Tolerance], units: dict[str, str]):
        super().__init__()
        self.machine = machine
        self.rows: list[Row] = []
        self.load(tolerances, units)

    def load(self, tolerances, units) -> None:
        """Fill the table from tolerances and their units; errors that are absent have the limits 0."""
        self.beginResetModel()
        self.known = refresh.components(self.machine)
        full = factory.with_usual(self.machine, {s: t for s, t in tolerances.items() if s in self.known})
        nothing = Tolerance(0.0, 0.0)
        self.rows = [Row(c, full.get(s, nothing), units.get(s) or default_unit(c)) for s, c in self.known.items()]
        bodies = list(dict.fromkeys(c.body for c in self.known.values()))
        self.rows.sort(key=lambda r: bodies.index(r.component.body))
        self.endResetModel()

    def rowCount(self, parent=None):
        return len(self.rows)

    def columnCount(self, parent=None):
        return 7

    def headerData(self, section, orientation, role=Qt.DisplayRole):
        if role != Qt.DisplayRole or orientation != Qt.Horizontal:
            return None
        return (
            translate("Sens", "Error"),
            translate("Sens", "Lower"),
            translate("Sens", "Upper"),
            translate("Sens", "Unit"),
            translate("Sens", "Distribution"),
            translate("Sens", "Component"),
            translate("Sens", "Meaning"),
        )[section]

    def flags(self, index):
        base = Qt.ItemIsEnabled | Qt.ItemIsSelectable
        return base | Qt.ItemIsEditable if index.column() in (LOWER, UPPER, UNIT, LAW) else base

    def data(self, index, role=Qt.DisplayRole):
        row, column = self.rows[index.row()], index.column()
        if role in (Qt.DisplayRole, Qt.EditRole):
            if column == SYMBOL:
                return row.symbol
            if column == MEANING:
                return error_meaning(row.symbol, self.known)
            if column == OWNER:
                return body_name(self.machine, row.component.body)
            if column in (LOWER, UPPER):
                return row.text(column)
            if column == UNIT:
                return unit_sign(row.unit) if role == Qt.DisplayRole else row.unit
            return distribution_name(row.distribution) if role == Qt.DisplayRole else row.distribution
        problem = row.problem() if column in (LOWER, UPPER) else ""
        if role == Qt.BackgroundRole and problem:
            return QtGui.QBrush(QtGui.QColor(200, 60, 50, 110))
        if role == Qt.ToolTipRole:
            words = f"{row.symbol}: {error_meaning(row.symbol)}, {body_name(self.machine, row.component.body)}"
            return problem or (f"{words} ({row.component.alias})" if row.component.alias else words)
        if role == Qt.TextAlignmentRole and column in (LOWER, UPPER):
            return RIGHT
        if role == Qt.FontRole and column == SYMBOL:
            font = QtGui.QFont()
            font.setBold(True)
            return font
        return None

    def setData(self, index, value, role=Qt.EditRole):
        if role != Qt.EditRole:
            return False
        row, column = self.rows[index.row()], index.column()
        if column in (LOWER, UPPER):
            row.enter(column, str(value))
        elif column == UNIT:
            row.unit = value
            row.texts.clear()
        else:
            row.distribution = value
        self.changed(index.row())
        return True

    def changed(self, row: int) -> None:
        """Redraw a row."""
        self.dataChanged.emit(self.index(row, 0), self.index(row, 6))

    def problem(self) -> str:
        """Return the first row's problem, or ""."""
        return next((p for p in (r.problem() for r in self.rows) if p), "")

    def result(self) -> tuple[dict[str, Tolerance], dict[str, str]]:
        """(tolerances, units); refuses the first row that cannot be read; leaves out zeros beyond the usual 24."""
        found = {r.symbol: r.tolerance() for r in self.rows}
        usual = factory.with_usual(self.machine, {})
        kept = {s: t for s, t in found.items() if s in usual or t.lower or t.upper}
        return kept, {r.symbol: r.unit for r in self.rows if r.symbol in kept}


def default_unit(component: Component) -> str:
    """Return the unit in which an error is shown if the document does not state one."""
    return settings.get("AngleUnit") if component.angular else "um"


class Choice(QtGui.QStyledItemDelegate):
    """Combo boxes for unit and distribution."""

    def createEditor(self, parent, option, index):
        row = index.model().rows[index.row()]
        if index.column() == UNIT:
            box = combo([(u, unit_sign(u)) for u in UNITS[row.component.angular]])
        else:
            box = combo([(d, distribution_name(d)) for d in DISTRIBUTIONS])
        box.setParent(parent)
        return box

    def setEditorData(self, editor, index):
        editor.setCurrentIndex(max(0, editor.findData(index.data(Qt.EditRole))))

    def setModelData(self, editor, model, index):
        model.setData(index, editor.itemData(editor.currentIndex()))


class TaskTolerances(Panel):
    """The panel."""

    guide = "2. Tolerances"

    def __init__(self, machine):
        self.machine = machine
        self.model = ToleranceModel(machine, tables.read_tolerances(machine), tables.read_units(machine))
        self.make_form(
            "SensTolerances", translate("Sens", "Tolerances of {name}").format(name=machine.Label), "Sens_Tolerances"
        )
        layout = QtGui.QVBoxLayout(self.form)
        hint = QtGui.QLabel(
            translate("Sens", "Type limits with decimal point or comma, a unit may follow: 12,5 arcsec.")
        )
        hint.setWordWrap(True)
        layout.addWidget(hint)
        self.table = QtGui.QTableView()
        self.table.setModel(self.model)
        self.delegate = Choice()
        self.table.setItemDelegateForColumn(UNIT, self.delegate)
        self.table.setItemDelegateForColumn(LAW, self.delegate)
        self.table.setAlternatingRowColors(True)
        self.table.verticalHeader().hide()
        self.table.verticalHeader().setDefaultSectionSize(24)
        self.grows, self.tallest = self.table, 24 * (len(self.model.rows) + 2)
        self.table.setMinimumHeight(150)
        self.table.setEditTriggers(QtGui.QAbstractItemView.AllEditTriggers)
        self.table.setTabKeyNavigation(True)
        self.table.resizeColumnsToContents()
        for column in (LOWER, UPPER):
            self.table.setColumnWidth(column, 54)
        self.table.setColumnWidth(MEANING, min(116, self.table.columnWidth(MEANING)))
        self.table.horizontalHeader().moveSection(MEANING, 1)  # what a code means stands beside it
        self.table.setHorizontalScrollMode(QtGui.QAbstractItemView.ScrollPerPixel)
        copyable(self.table, "tolerances.csv")
        layout.addWidget(self.table, 1)
        row = QtGui.QHBoxLayout()
        self.value = QtGui.QLineEdit()
        self.value.setPlaceholderText(translate("Sens", "for example 5 or 10 arcsec"))
        self.value.setToolTip(translate("Sens", "Gives the selected errors the limits ± this value"))
        self.apply = QtGui.QPushButton(translate("Sens", "Set ± for selected"))
        self.apply.clicked.connect(self.set_selected)
        row.addWidget(QtGui.QLabel("±"))
        row.addWidget(self.value, 1)
        row.addWidget(self.apply)
        layout.addLayout(row)
        row = QtGui.QHBoxLayout()
        self.angle = combo([("urad", "µrad"), ("arcsec", "″")])
        self.angle.setToolTip(translate("Sens", "Unit in which all angles are shown"))
        self.angle.setCurrentIndex(self.angle.findData(self._angle_unit()))
        self.angle.currentIndexChanged.connect(self.set_angle_unit)
        row.addWidget(QtGui.QLabel(translate("Sens", "Angles in")))
        row.addWidget(self.angle)
        row.addStretch(1)
        layout.addLayout(row)
        row = QtGui.QHBoxLayout()
        for text, tip, slot in (
            (translate("Sens", "Import…"), translate("Sens", "Reads tolerances from CSV or JSON"), self.ask_import),
            (translate("Sens", "Export…"), translate("Sens", "Writes tolerances as CSV or JSON"), self.ask_export),
            (translate("Sens", "Defaults"), translate("Sens", "Park & Yang's values for all errors"), self.defaults),
        ):
            button = QtGui.QPushButton(text)
            button.setToolTip(tip)
            button.clicked.connect(slot)
            row.addWidget(button)
        layout.addLayout(row)
        self.note = QtGui.QLabel()
        self.note.setObjectName("SensNote")
        self.note.setWordWrap(True)
        layout.addWidget(self.note)
        self.model.dataChanged.connect(lambda *_: self.check())

    def _angle_unit(self) -> str:
        found = [r.unit for r in self.model.rows if r.component.angular]
        return max(("urad", "arcsec"), key=found.count)

    def check(self) -> bool:
        """Show the first problem of the table; return whether there is none."""
        problem = self.model.problem()
        self.note.setText(problem)
        self.note.setStyleSheet("color: #c0392b" if problem else "")
        return not problem

    def set_selected(self) -> None:
        """Give the selected errors the limits ± the typed value."""
        text = self.value.text().strip().lstrip("±")
        rows = sorted({i.row() for i in self.table.selectionModel().selectedIndexes()})
        if not text or not rows:
            self.note.setText(translate("Sens", "Type a value and select the errors that take it."))
            return
        try:
            for i in rows:
                row = self.model.rows[i]
                value = abs(parse(text, angular=row.component.angular, default_unit=row.unit, where=row.symbol))
                row.values = {LOWER: -value, UPPER: value}
                row.texts.clear()
                self.model.changed(i)
        except Refused as error:
            self.note.setText(messages.words(error))

    def set_angle_unit(self, *_) -> None:
        """Show all angles in the chosen unit."""
        unit = self.angle.itemData(self.angle.currentIndex())
        for i, row in enumerate(self.model.rows):
            if row.component.angular:
                row.unit = unit
                self.model.changed(i)

    def defaults(self) -> None:
        """Set the tolerances of the paper."""
        for i, row in enumerate(self.model.rows):
            tolerance = paper_tolerance(row.symbol)
            row.values, row.distribution, row.sigma = {LOWER: tolerance.lower, UPPER: tolerance.upper}, "uniform", None
            row.texts.clear()
            self.model.changed(i)

    def read_file(self, path: str) -> bool:
        """Read a tolerance table into the panel; return whether it could be read."""
        try:
            found = files.load(path)
        except Refused as error:
            messages.show(messages.words(error))
            return False
        for i, row in enumerate(self.model.rows):
            if row.symbol in found:
                tolerance = found[row.symbol]
                row.values = {LOWER: tolerance.lower, UPPER: tolerance.upper}
                row.distribution, row.sigma = tolerance.distribution, tolerance.sigma
                row.texts.clear()
                self.model.changed(i)
        self.note.setText(translate("Sens", "{n} errors read.").format(n=len(found)))
        return True

    def write_file(self, path: str) -> bool:
        """Write the table to a file; return whether it could be written."""
        try:
            files.save(self.model.result()[0], path, self.angle.itemData(self.angle.currentIndex()))
        except Refused as error:
            messages.show(messages.words(error))
            return False
        return True

    def ask_import(self):
        """Ask for a file and read it."""
        path = messages.ask_open(translate("Sens", "Import tolerances"), "CSV, JSON (*.csv *.json)")
        if path:
            self.read_file(path)

    def ask_export(self):
        """Ask for a file and write it."""
        path = messages.ask_save(translate("Sens", "Export tolerances"), "CSV (*.csv);;JSON (*.json)", "tolerances.csv")
        if path:
            self.write_file(path)

    def accept(self):
        try:
            tolerances, units = self.model.result()
        except Refused as error:
            self.check()
            messages.show(messages.words(error))
            return False
        machine = self.machine

        def write():
            factory.set_tolerances(machine, tolerances, units)
            machine.touch()

        if not messages.change(machine.Document, translate("Sens", "Tolerances"), write):
            return False
        self.close()
        return True

    def leave(self):
        self.table.setModel(None)  # its rows name parts of the machine


def edit_tolerances(machine):
    """Open the panel for a machine."""
    panel = TaskTolerances(machine)
    show_panel(panel, machine.Document)
    return panel


@command
class Tolerances(Command):
    name = "Sens_Tolerances"
    keys = "Y, T"
    menu_text = QT_TRANSLATE_NOOP("Sens_Tolerances", "Tolerances…")
    tip = QT_TRANSLATE_NOOP("Sens_Tolerances", "Edits limits and distribution of every error in a table")
    guide = TaskTolerances.guide
    where = Where("machine", 50, tree=("Machine",), double=("Tolerances",))

    def run(self):
        edit_tolerances(current_machine())
