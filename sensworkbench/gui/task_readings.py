# SPDX-License-Identifier: LGPL-2.1-or-later
"""The import panel: the meaning of each column of a table, the sign questions that it leaves open, and remarks.

Columns of our own grammar are recognised, foreign ones are guessed and can be corrected.  The table is read again at
every change, so that remarks and refusals with their lines are shown before anything is imported.
"""

from __future__ import annotations

import json
from pathlib import Path

from ..core.refusal import Refused
from ..document import closed_loop, tree
from ..formats import column_guess, csv_table, readings_csv
from ..formats.column_guess import DRIVER, IGNORE, Guess
from ..formats.readings_conventions import ANSWERS, question
from . import messages
from .command import Command, Where, command
from .current import current_machine, current_table
from .panel import Panel
from .panel import rows as form_rows
from .panel import show as show_panel
from .preferences import combo, length_box
from .qt import QT_TRANSLATE_NOOP, QtCore, QtGui, translate

COLUMN, USE, UNIT, VALUE = range(4)
ASKED = ("sign", "frame", "positions")


class TaskReadings(Panel):
    """The panel for one file.  `mapping()` is the present choice of columns; `readings` its result, None if refused.

    imported : the Readings object whose columns are chosen again; None: the file is imported.
    """

    guide = "8. Close the loop: readings in, the missing effect out"

    def __init__(self, machine, path, imported=None):
        self.machine, self.path, self.imported = machine, Path(path), imported
        self.table = csv_table.read(self.path)  # refuses before anything is opened
        self.guesses, before = column_guess.guesses(self.table.names), ({}, {})
        if imported is not None:
            self.guesses, *before = column_guess.from_mapping(self.table.names, json.loads(imported.Mapping))
        self.stated = {question(text): line for line, text in self.table.comments if question(text)}
        self.readings = None
        self._timer = QtCore.QTimer()
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self.check)
        self.make_form(
            "SensReadings", translate("Sens", "Import {name}").format(name=self._name()), "Sens_ImportReadings"
        )
        layout = QtGui.QVBoxLayout(self.form)
        layout.addWidget(QtGui.QLabel(translate("Sens", "What each column of the table is:")))
        self.columns = self._columns()
        layout.addWidget(self.columns)
        layout.addWidget(self._constants())
        layout.addWidget(self._questions())
        self.note = QtGui.QLabel()
        self.note.setObjectName("SensReadingsNote")
        self.note.setWordWrap(True)
        layout.addWidget(self.note)
        layout.addWidget(QtGui.QLabel(translate("Sens", "Noticed while reading:")))
        self.remarks = QtGui.QListWidget()
        self.remarks.setObjectName("SensFindings")
        self.remarks.setWordWrap(True)
        self.remarks.setFixedHeight(72)
        layout.addWidget(self.remarks)
        self.save = QtGui.QPushButton(translate("Sens", "Save mapping…"))
        self.save.setToolTip(translate("Sens", "Writes these choices to a file for the command line's --mapping"))
        self.save.clicked.connect(self.save_mapping)
        row = QtGui.QHBoxLayout()
        row.addStretch(1)
        row.addWidget(self.save)
        layout.addLayout(row)
        self._restore(*before)
        self.check()

    def _name(self) -> str:
        """The file as the user knows it."""
        return self.path.name if self.imported is None else self.imported.Source

    def _restore(self, constants: dict, answers: dict) -> None:
        """Fill in what was chosen before."""
        for axis, field in self.constants.items():
            field.setValue(constants.get(f"{axis}_mm", 0.0))
        for key, field in self.answers.items():
            field.setCurrentIndex(max(0, field.findData(answers.get(key, ""))))

    # -- the form ----------------------------------------------------------------------------------------------------
    def _columns(self):
        table = QtGui.QTableWidget(len(self.table.names), 4)
        table.setObjectName("SensColumns")
        table.setHorizontalHeaderLabels([
            translate("Sens", "Column"), translate("Sens", "Taken as"), translate("Sens", "Unit"),
            translate("Sens", "First"),
        ])  # fmt: skip
        table.verticalHeader().hide()
        table.verticalHeader().setDefaultSectionSize(26)
        table.setEditTriggers(QtGui.QAbstractItemView.NoEditTriggers)
        table.setSelectionMode(QtGui.QAbstractItemView.NoSelection)
        table.setMinimumHeight(150)
        table.setHorizontalScrollMode(QtGui.QAbstractItemView.ScrollPerPixel)
        # the themes of FreeCAD give a combo box wide margins, which leave no room for its text in a cell
        table.setStyleSheet("QComboBox { padding: 0px 2px; margin: 0px; min-width: 0px; border-width: 0px; }")
        self.uses, self.units = [], []
        for row, (written, found) in enumerate(zip(self.table.names, self.guesses)):
            cells = self.table.cells[row][:5]
            for column, text in ((COLUMN, written), (VALUE, cells[0] if cells else "")):
                item = QtGui.QTableWidgetItem(text)
                item.setToolTip(", ".join([written, *cells]) if column == COLUMN else ", ".join(cells))
                table.setItem(row, column, item)
            use = combo([(kind, use_name(kind)) for kind in column_guess.CHOICES])
            use.setCurrentIndex(use.findData(found.kind))
            unit = combo([("", "–")])
            self.uses.append(use)
            self.units.append(unit)
            self._offer_units(row, found.unit)
            use.currentIndexChanged.connect(lambda _i, r=row: self._used(r))
            unit.currentIndexChanged.connect(self._later)
            table.setCellWidget(row, USE, use)
            table.setCellWidget(row, UNIT, unit)
        table.resizeColumnsToContents()
        for column, most in ((COLUMN, 92), (VALUE, 70)):
            table.setColumnWidth(column, min(most, table.columnWidth(column)))
        self.grows, self.tallest = table, 26 * (len(self.table.names) + 1) + 24
        return table

    def _widen(self) -> None:
        """Make the columns of choices as wide as what is chosen, so that it can be read."""
        for column, boxes in ((USE, self.uses), (UNIT, self.units)):
            wide = max((b.fontMetrics().boundingRect(b.currentText()).width() for b in boxes), default=0)
            self.columns.setColumnWidth(column, wide + 40)

    def _constants(self):
        """What to take for a coordinate that no column holds."""
        box = QtGui.QWidget()
        rows = form_rows(box)
        rows.setContentsMargins(0, 0, 0, 0)
        self.constants, self._labels = {}, {}
        for axis in "xyz":
            number = length_box(-1e6, 1e6)
            number.valueChanged.connect(self._later)
            label = QtGui.QLabel(translate("Sens", "{axis} is in no column; it stood at").format(axis=axis.upper()))
            rows.addRow(label, number)
            self.constants[axis], self._labels[axis] = number, label
        return box

    def _questions(self):
        box = QtGui.QGroupBox(translate("Sens", "What the readings mean"))
        rows = QtGui.QVBoxLayout(box)
        self.answers = {}
        for key in ASKED:
            text, choices, tip = question_words(key)
            label = QtGui.QLabel(text)
            label.setWordWrap(True)
            rows.addWidget(label)
            if key in self.stated:
                said = QtGui.QLabel(translate("Sens", "The file says so in line {line}.").format(line=self.stated[key]))
                said.setEnabled(False)
                rows.addWidget(said)
                continue
            field = combo([("", translate("Sens", "– please answer –")), *choices])
            field.setObjectName(f"SensAnswer_{key}")
            field.setToolTip(tip)
            field.setSizePolicy(QtGui.QSizePolicy.Expanding, QtGui.QSizePolicy.Fixed)
            field.currentIndexChanged.connect(self._later)
            rows.addWidget(field)
            self.answers[key] = field
        return box

    def _offer_units(self, row: int, chosen: str = "") -> None:
        kind = data(self.uses[row])
        known = column_guess.units_of(kind)
        unit = self.units[row]
        unit.blockSignals(True)
        unit.clear()
        for name in known or ("",):
            unit.addItem(unit_name(name), name)
        unit.setCurrentIndex(max(0, unit.findData(chosen)))
        unit.setEnabled(bool(known))
        unit.blockSignals(False)

    def _used(self, row: int) -> None:
        self._offer_units(row)
        self._later()

    def _later(self, *_) -> None:
        self._timer.start(250)

    # -- what it says ------------------------------------------------------------------------------------------------
    def chosen(self) -> list[Guess]:
        """What each column is taken for now."""
        found = []
        for written, before, use, unit in zip(self.table.names, self.guesses, self.uses, self.units):
            kind = data(use)
            name = ""
            if kind in column_guess.FAMILIES:
                name = before.name if before.kind == kind else column_guess.slug(written)
            found.append(Guess(kind, name, data(unit) if kind not in (DRIVER, IGNORE) else ""))
        return found

    def missing(self) -> list[str]:
        """Coordinates that no column holds."""
        held = {g.kind for g in self.chosen()}
        return [a for a in "xyz" if a not in held]

    def mapping(self) -> dict:
        """The mapping as chosen; refuses two columns for the same."""
        constants = {f"{a}_mm": self.constants[a].value() for a in self.missing()}
        answers = {key: data(field) for key, field in self.answers.items() if data(field)}
        return column_guess.mapping(self.table.names, self.chosen(), constants, answers)

    def unanswered(self) -> list[str]:
        """Return the sign questions that have no answer yet."""
        return [key for key, field in self.answers.items() if not data(field)]

    def check(self) -> None:
        """Read the table as chosen and show what came of it."""
        self._timer.stop()
        self._widen()
        missing = self.missing()
        for axis, field in self.constants.items():
            for widget in (field, self._labels[axis]):
                widget.setVisible(axis in missing)
        self.remarks.clear()
        self.readings = None
        self.problem = ""
        try:
            self.readings = readings_csv.load(self.path, self.mapping())
        except Refused as error:
            self.problem = messages.words(error)
        if self.problem:
            self._say(self.problem, bad=True)
            return
        for f in self.readings.remarks:
            item = QtGui.QListWidgetItem(closed_loop.finding_message(f).text(messages.language()))
            kind = QtGui.QStyle.SP_MessageBoxInformation if f.severity == "info" else QtGui.QStyle.SP_MessageBoxWarning
            item.setIcon(self.form.style().standardIcon(kind))
            self.remarks.addItem(item)
        words = translate("Sens", "{rows} readings at {points} places").format(
            rows=self.readings.rows, points=self.readings.points
        )
        if self.unanswered():
            self._say(translate("Sens", "{found}. Please answer the questions above.").format(found=words), bad=True)
        else:
            self._say(words + ".")

    def _say(self, text: str, bad: bool = False) -> None:
        self.note.setText(text)
        self.note.setStyleSheet("color: #b03a2e; font-weight: bold" if bad else "font-weight: bold")

    def save_mapping(self) -> None:
        """Ask for a file and write the mapping of the columns to it."""
        from ..formats.files import write_text

        try:
            text = json.dumps(self.mapping(), indent=1, ensure_ascii=False)
            path = messages.ask_save(translate("Sens", "Save mapping"), "JSON (*.json)", "mapping.json")
            if path:
                write_text(path, text + "\n")
        except Refused as error:
            messages.show(messages.words(error))

    # -- the panel ---------------------------------------------------------------------------------------------------
    def accept(self):
        if self._timer.isActive() or self.readings is None:
            self.check()
        if self.readings is None:
            messages.show(self.problem)
            return False
        if self.unanswered():
            messages.show(
                translate("Sens", "The file does not say what its signs mean. Answer the questions, then import.")
            )
            return False
        mapping = self.mapping()
        doc = self.machine.Document

        def change():
            if self.imported is None:
                closed_loop.make_readings(self.machine, self.path, mapping)
            else:
                closed_loop.map_again(self.imported, mapping)

        done = messages.change(doc, translate("Sens", "Import readings"), change)
        if done:
            self.close()
            messages.status(self.note.text())
        return done

    def leave(self):
        self._timer.stop()


def data(field):
    """Return the value of the chosen entry of a combo box."""
    return field.itemData(field.currentIndex())


def unit_name(unit: str) -> str:
    """Return a unit as the panel shows it: `um` is µm."""
    return {
        "um": "µm", "C": "°C", "F": "°F", "mm_min": "mm/min", "m_min": "m/min", "mm_s": "mm/s", "m_s": "m/s",
        "um_s": "µm/s", "in_min": "in/min", "in_s": "in/s", "1_min": "1/min", "1_s": "1/s", "rad_s": "rad/s",
        "deg_s": "°/s", "": "–",
    }.get(unit, unit)  # fmt: skip


def use_name(kind: str) -> str:
    """What a column may be, in words."""
    if kind[-1] in "xyz" and kind not in ("temp_", "load_"):
        axis = kind[-1].upper()
        words = {
            "": translate("Sens", "position {axis}"), "e": translate("Sens", "error along {axis}"),
            "n": translate("Sens", "direction of sensing {axis}"), "dir_": translate("Sens", "approach along {axis}"),
            "tool_d": translate("Sens", "tool offset {axis}"),
            "u_e": translate("Sens", "uncertainty of the error along {axis}"),
        }  # fmt: skip
        return words[kind[:-1]].format(axis=axis)
    return {
        "reading": translate("Sens", "reading along its direction"), "u": translate("Sens", "standard uncertainty"),
        "run": translate("Sens", "run"), "t": translate("Sens", "time"), "feed": translate("Sens", "feed"),
        "spindle": translate("Sens", "spindle speed"), "temp_": translate("Sens", "temperature"),
        "load_": translate("Sens", "load"), DRIVER: translate("Sens", "driver, as it is"),
        IGNORE: translate("Sens", "ignored"),
    }[kind]  # fmt: skip


def question_words(key: str) -> tuple[str, list[tuple[str, str]], str]:
    """(question, [(answer, words)], explanation)."""
    words = {
        "sign": (
            translate("Sens", "The readings are"),
            (
                translate("Sens", "errors: actual minus commanded"),
                translate("Sens", "compensation values: commanded minus actual"),
            ),
            translate("Sens", "A machine that goes 3 µm too far has an error of +3 µm and a compensation of −3 µm"),
        ),
        "frame": (
            translate("Sens", "They are the motion of"),
            (
                translate("Sens", "the tool relative to the workpiece"),
                translate("Sens", "the table relative to the tool"),
            ),
            translate("Sens", "When a table moves to +X, the tool moves to −X on the workpiece"),
        ),
        "positions": (
            translate("Sens", "The positions are"),
            (
                translate("Sens", "as programmed"),
                translate("Sens", "of the table, X and Y counted its way"),
            ),
            translate("Sens", "Programmed positions are those of the tool on the workpiece"),
        ),
    }[key]
    text, names, tip = words
    values = list(ANSWERS[key])
    if key == "positions":
        values[1] = "table X Y"
    return text, list(zip(values, names)), tip


def import_readings(machine, path, imported=None):
    """Open the panel for a file, or for a Readings object that was imported."""
    panel = TaskReadings(machine, path, imported)
    show_panel(panel, machine.Document)
    return panel


@command
class ImportReadings(Command):
    name = "Sens_ImportReadings"
    keys = "Y, I"
    menu_text = QT_TRANSLATE_NOOP("Sens_ImportReadings", "Import Readings…")
    tip = QT_TRANSLATE_NOOP(
        "Sens_ImportReadings", "Reads a table of measured errors: laser, ballbar, diagonals, tracker or probe"
    )
    guide = TaskReadings.guide
    where = Where("loop", 10)

    def run(self):
        machine = current_machine()
        path = messages.ask_open(
            translate("Sens", "Import readings"), translate("Sens", "Tables (*.csv *.txt *.tsv);;All files (*)")
        )
        if path:
            import_readings(machine, path)


@command
class EditReadings(Command):
    name = "Sens_EditReadings"
    menu_text = QT_TRANSLATE_NOOP("Sens_EditReadings", "Columns of the Readings…")
    tip = QT_TRANSLATE_NOOP("Sens_EditReadings", "Changes what the columns of an imported table are taken for")
    icon = "Sens_ImportReadings"
    needs, guide = "readings", TaskReadings.guide
    where = Where("loop", 15, toolbar=False, tree=("Readings",))

    def run(self):
        table = current_table()
        if not table.Table or not Path(table.Table).is_file():
            raise Refused("readings-table-missing", table.Label)
        import_readings(tree.owner_machine(table), table.Table, table)
