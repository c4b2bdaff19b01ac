# SPDX-License-Identifier: LGPL-2.1-or-later
"""What if: halve a tolerance, fix an error, change a weight, move a scale; the new ranking is shown next to the old
one.

Everything here works on a copy of the machine in memory; the document changes only with Apply, as one undo step.
"""

from __future__ import annotations

from dataclasses import replace

import FreeCAD as App

from ..core import workspace
from ..core.refusal import Refused
from ..core.units import parse
from ..document import extract, factory, results, tables, told, tree
from ..document.refresh import components
from . import display, live, messages, state
from .bars import percent
from .copying import copyable
from .preferences import combo, length_box, number_box
from .qt import Qt, QtGui, Signal, translate
from .ranking import NumericItem, angular
from .scenarios import Scenario, ScenarioList
from .texts import (
    body_name,
    length_unit,
    limits,
    mean_name,
    meaning,
    plain,
    point_text,
    short_name,
    shown_size,
)

ERROR, FACTOR, BEFORE, AFTER, MOVE, NEW, OWNER, MEANING = range(8)
SYMBOL = Qt.UserRole + 2  # the error of a row, its component in the column of components
WIDEST = {ERROR: 90, FACTOR: 90, MEANING: 130, OWNER: 110, NEW: 80}  # pixels; the tool tip says the rest


def factors():
    """Return (factor, text) of each change of a tolerance that can be tried."""
    return [
        (1.0, translate("Sens", "as it is")),
        (0.5, translate("Sens", "halved")),
        (0.25, translate("Sens", "a quarter")),
        (0.0, translate("Sens", "frozen")),
        (2.0, translate("Sens", "doubled")),
    ]


class WhatIf(QtGui.QWidget):
    """The page of the review.  `chosen` is emitted with the bodies of the rows that the user selects."""

    chosen = Signal(list)

    def __init__(self, parent=None):
        super().__init__(parent)
        layout = QtGui.QVBoxLayout(self)
        layout.setContentsMargins(0, 4, 0, 0)
        row = QtGui.QHBoxLayout()
        row.addWidget(QtGui.QLabel(translate("Sens", "Weights")))
        self.weights = [number_box(-1000, 1000, 2, 0.5) for _ in range(3)]
        for label, box in zip("XYZ", self.weights):
            row.addWidget(QtGui.QLabel(label))
            row.addWidget(box, 1)
            box.setKeyboardTracking(False)
            box.valueChanged.connect(self.compute)
        layout.addLayout(row)
        row = QtGui.QHBoxLayout()
        row.addWidget(QtGui.QLabel(translate("Sens", "Tolerance of the selected errors")))
        self.factor = combo(factors())
        self.set_button = QtGui.QPushButton(translate("Sens", "Set"))
        self.set_button.clicked.connect(self.set_selected)
        row.addWidget(self.factor, 1)
        row.addWidget(self.set_button)
        layout.addLayout(row)
        layout.addLayout(self._value_row())
        layout.addLayout(self._scale_row())
        self.table = QtGui.QTreeWidget()
        self.table.setObjectName("SensWhatIf")
        self.table.setRootIsDecorated(False)
        self.table.setAlternatingRowColors(True)
        self.table.setUniformRowHeights(True)
        self.table.setSelectionMode(QtGui.QAbstractItemView.ExtendedSelection)
        self.table.setHeaderLabels([
            translate("Sens", "Error"), translate("Sens", "Change"), translate("Sens", "Share now"),
            translate("Sens", "Share then"), translate("Sens", "Rank"), translate("Sens", "Tolerance"),
            translate("Sens", "Component"), translate("Sens", "Meaning"),
        ])  # fmt: skip
        self.table.setSortingEnabled(True)
        self.table.sortByColumn(AFTER, Qt.DescendingOrder)
        self.table.header().moveSection(self.table.header().visualIndex(MEANING), 5)
        self.table.itemSelectionChanged.connect(self._point)
        copyable(self.table, "what-if.csv")
        layout.addWidget(self.table, 1)
        self.summary = QtGui.QLabel()
        self.summary.setWordWrap(True)
        layout.addWidget(self.summary)
        self.scenarios = ScenarioList()
        self.scenarios.asked.connect(self.try_scenario)
        layout.addWidget(self.scenarios)
        row = QtGui.QHBoxLayout()
        self.keep_button = QtGui.QPushButton(translate("Sens", "Keep"))
        self.keep_button.setToolTip(translate("Sens", "Keeps what is tried in a list, to compare it with others"))
        self.keep_button.clicked.connect(self.keep)
        row.addWidget(self.keep_button)
        row.addStretch(1)
        self.reset_button = QtGui.QPushButton(translate("Sens", "Start over"))
        self.apply_button = QtGui.QPushButton(translate("Sens", "Apply"))
        self.apply_button.setToolTip(
            translate("Sens", "Writes the tolerances, weights and moved scales to the machine, one undo step")
        )
        self.reset_button.clicked.connect(self.reset)
        self.apply_button.clicked.connect(self.apply)
        row.addWidget(self.reset_button)
        row.addWidget(self.apply_button)
        layout.addLayout(row)
        self.machine = self.result = None
        self.changes: dict[str, float] = {}
        self.moved: dict[str, tuple[float, float, float]] = {}  # axis -> shift of its scale, mm
        self._print = ""
        self._quiet = False
        self.then = None

    def _value_row(self):
        """A limit typed for the selected errors, and the greatest error that is allowed."""
        row = QtGui.QHBoxLayout()
        self.value = QtGui.QLineEdit()
        self.value.setPlaceholderText(translate("Sens", "± 5 µm or 10 arcsec"))
        self.value.setToolTip(translate("Sens", "Tolerance of the selected errors, ± this value; Enter sets it"))
        self.value.returnPressed.connect(self.set_value)
        row.addWidget(self.value, 1)
        row.addWidget(QtGui.QLabel(translate("Sens", "Allowed")))
        self.allowed = number_box(0, 1e6, 1, 1.0, " µm")
        self.allowed.setSpecialValueText("–")
        self.allowed.setKeyboardTracking(False)
        self.allowed.setToolTip(translate("Sens", "Greatest error that is allowed; what is tried passes or fails it"))
        self.allowed.valueChanged.connect(self._judge)
        row.addWidget(self.allowed)
        return row

    def _judge(self, *_) -> None:
        """Another error is allowed: what passes it is said anew."""
        self.scenarios.show_scenarios(self._kept(), self.allowed.value())
        if self.then is not None:
            self._summarize()

    def set_value(self) -> None:
        """Give the selected errors the limits ± the typed value, a unit of its own included."""
        text = self.value.text().strip().lstrip("±").strip()
        rows = [item.data(ERROR, SYMBOL) for item in self.table.selectedItems()]
        if self.result is None or not text or not rows:
            self.summary.setText(translate("Sens", "Type a value and select the errors that take it."))
            return
        units = dict(zip(self.result.Symbols, self.result.Units))
        known = components(self.machine)
        laws, wanted = extract.core_machine(self.machine).all_tolerances, {}
        try:
            for symbol in rows:
                unit, is_angle = units.get(symbol) or "um", angular(symbol, known)
                half = abs(parse(text, angular=is_angle, default_unit=unit, where=symbol))
                now = laws[symbol].upper - laws[symbol].lower if symbol in laws else 0.0
                if now > 0:
                    wanted[symbol] = 2 * half / now
        except Refused as error:
            self.summary.setText(messages.words(error))
            return
        self.change(wanted)

    def _point(self) -> None:
        """The bodies of the selected rows are pointed at in the view."""
        if not self._quiet:
            self.chosen.emit(list(dict.fromkeys(i.data(OWNER, SYMBOL) for i in self.table.selectedItems())))

    def _scale_row(self):
        tip = translate("Sens", "Moves the reference point of an axis, where its scale is read, along X, Y, Z")
        row = QtGui.QHBoxLayout()
        row.addWidget(QtGui.QLabel(translate("Sens", "Move the scale of")))
        self.axis = combo([("X", "X")])  # the axes of the machine, once there is one
        self.axis.setToolTip(tip)
        self.axis.currentIndexChanged.connect(self._show_shift)
        row.addWidget(self.axis)
        self.shift = [length_box(-1e5, 1e5, 1) for _ in range(3)]
        for letter, box in zip("xyz", self.shift):
            box.setPrefix(f"{letter} ")
            box.setSuffix("")
            box.setToolTip(tip)
            box.setButtonSymbols(QtGui.QAbstractSpinBox.NoButtons)
            box.setKeyboardTracking(False)
            box.valueChanged.connect(self._shifted)
            row.addWidget(box, 1)
        row.addWidget(QtGui.QLabel(length_unit()[0]))
        return row

    def _show_shift(self, *_) -> None:
        self._quiet = True
        for box, value in zip(self.shift, self.moved.get(self.axis.itemData(self.axis.currentIndex()), (0.0,) * 3)):
            box.setValue(value)
        self._quiet = False

    def _shifted(self, *_) -> None:
        if not self._quiet:
            self.move_scale(self.axis.itemData(self.axis.currentIndex()), [box.value() for box in self.shift])

    def move_scale(self, name: str, offset) -> None:
        """Shift the reference point of an axis by three numbers, mm along the machine's X, Y, Z; zeros put it back."""
        offset = tuple(float(v) for v in offset)
        self.moved.pop(name, None)
        if any(offset):
            self.moved[name] = offset
        self.compute()

    def show_machine(self, machine, result) -> None:
        """Start from a result; what was tried is kept while the result is the same."""
        fresh = result.Inputs if result is not None else ""
        same = machine is self.machine and fresh == self._print
        before = self.machine
        self.machine, self.result, self._print = machine, result, fresh
        self.setEnabled(result is not None)
        self.scenarios.show_scenarios(self._kept(), self.allowed.value())
        names = () if machine is None else tree.joint_names(tree.bodies(machine))
        if names != tuple(self.axis.itemData(i) for i in range(self.axis.count())):
            self._quiet = True
            self.axis.clear()
            for name in names:
                self.axis.addItem(name, name)
            self._quiet = False
        if not same:
            if machine is not before:  # what was selected belonged to another machine
                self.table.clear()
            self.reset()

    def _kept(self) -> list[Scenario]:
        """The scenarios of the machine that is shown."""
        return (
            [] if self.machine is None else state.of(self.machine.Document).scenarios.setdefault(self.machine.Name, [])
        )

    def keep(self, *_) -> None:
        """Keep what is tried now beside the other scenarios."""
        if self.then is None:
            return
        unit, size = shown_size(self.then.objective, self.then.mean_square)
        words = [f"{short_name(self.machine, s)} × {plain(f)}" for s, f in self.changes.items()]
        words += [f"{name} ({point_text(by)})" for name, by in self.moved.items()]
        weights = tuple(box.value() for box in self.weights)
        if self._weights_changed():
            words.append(f"{translate('Sens', 'Weights')} {', '.join(map(plain, weights))}")
        told_words = ", ".join(words) or translate("Sens", "as it is")
        self._kept().append(Scenario(dict(self.changes), dict(self.moved), weights, size, unit, told_words))
        self.scenarios.show_scenarios(self._kept(), self.allowed.value())

    def try_scenario(self, scenario: Scenario) -> None:
        """Put the changes of a scenario back."""
        self.changes, self.moved = dict(scenario.changes), dict(scenario.moved)
        self._show_shift()
        self._quiet = True
        for box, value in zip(self.weights, scenario.weights):
            box.setValue(value)
        self._quiet = False
        self.compute()

    def reset(self, *_) -> None:
        """Take back all changes."""
        self.changes, self.moved = {}, {}
        self._show_shift()
        self._quiet = True
        if self.machine is not None:
            for box, value in zip(self.weights, self._set_weights()):
                box.setValue(value)
        self._quiet = False
        self.compute()

    def set_selected(self) -> None:
        """Apply the chosen factor to the selected errors."""
        factor = self.factor.itemData(self.factor.currentIndex())
        self.change({item.data(ERROR, SYMBOL): factor for item in self.table.selectedItems()})

    def change(self, factors_: dict[str, float]) -> None:
        """Multiply the tolerance widths of some errors (symbol -> factor; 1 puts it back, 0 freezes)."""
        for symbol, factor in factors_.items():
            if factor == 1.0:
                self.changes.pop(symbol, None)
            else:
                self.changes[symbol] = factor
        self.compute()

    def _tried(self):
        """(core machine, objective) with the changes."""
        core = extract.with_offsets(extract.core_machine(self.machine), self.moved)
        tolerances = core.all_tolerances
        tolerances |= {s: tolerances[s].scaled(f) for s, f in self.changes.items() if s in tolerances}
        objective = replace(extract.objective(self.machine), weights=tuple(b.value() for b in self.weights))
        return replace(core, tolerances=tolerances), objective

    def compute(self, *_) -> None:
        """Compute the ranking with the changes and show both."""
        if self._quiet:
            return
        quiet, self._quiet = self._quiet, True
        selected = {item.data(ERROR, SYMBOL) for item in self.table.selectedItems()}
        self.table.setSortingEnabled(False)
        self.table.clear()
        self.then = None
        try:
            if self.result is not None:
                core, objective = self._tried()
                then = self._indices(core, objective)
                self._fill(core, then)
                self.then = then
        except Refused as error:
            self.summary.setText(messages.words(error))
        except workspace.Cancelled:
            self.summary.setText(translate("Sens", "Cancelled; nothing was changed"))
        self.table.setSortingEnabled(True)
        for i in range(self.table.topLevelItemCount()):
            item = self.table.topLevelItem(i)
            item.setSelected(item.data(ERROR, SYMBOL) in selected)
        self._quiet = quiet
        self.apply_button.setEnabled(self.then is not None and self._changed())
        self.reset_button.setEnabled(self._changed())

    def _indices(self, core, objective):
        """The indices of what is tried; those of the result where nothing was changed yet."""
        if not self._changed():
            return results.load(self.machine, self.result)
        positions = extract.positions(self.machine, core)
        return live.in_background(
            lambda progress: workspace.sensitivity(core, positions, objective, progress, estimate=False),
            translate("Sens", "Computing the indices at {n} positions").format(n=len(positions.q)),
        )

    def _changed(self) -> bool:
        return bool(self.changes) or bool(self.moved) or self._weights_changed()

    def _weights_changed(self) -> bool:
        return self.machine is not None and any(
            abs(b.value() - w) > 1e-9 for b, w in zip(self.weights, self._set_weights())
        )

    def _set_weights(self) -> tuple[float, float, float]:
        """Weights of the machine's objective; ones where it is not registered here."""
        try:
            return extract.objective(self.machine).weights
        except Refused:
            return (1.0, 1.0, 1.0)

    def _fill(self, core, then) -> None:
        result = self.result
        now = dict(zip(result.Symbols, display.mean_of(result, ("First", "Total"))))
        units = dict(zip(result.Symbols, result.Units))
        after = dict(zip(then.symbols, then.share.tolist()))
        ranks = [
            {s: i for i, s in enumerate(sorted(table, key=lambda k: -round(table[k], 12)), start=1)}
            for table in (now, after)
        ]
        words, known = dict(factors()), {c.symbol: c for c in core.components}
        laws = core.all_tolerances
        for symbol, owner in zip(then.symbols, then.owners):
            item = NumericItem(self.table)
            factor = self.changes.get(symbol, 1.0)
            law = laws.get(symbol)
            is_angle = angular(symbol, known)
            unit = units.get(symbol) or ("urad" if is_angle else "um")
            before, here = ranks[0].get(symbol, 0), ranks[1][symbol]
            arrow = "" if before == here else " ▲" if here < before else " ▼"
            change = words.get(factor, f"× {factor:g}") if factor != 1.0 else ""
            if owner in self.moved and not change:
                change = translate("Sens", "scale moved")
            texts = (
                short_name(self.machine, symbol), change,
                percent(now.get(symbol, 0.0)), percent(after[symbol]), f"{before} → {here}{arrow}",
                limits(law.lower, law.upper, unit, is_angle) if law else "",
                body_name(self.machine, owner), meaning(self.machine, symbol, known),
            )  # fmt: skip
            for column, text in enumerate(texts):
                item.setText(column, text)
                item.setToolTip(column, text)
                if change:
                    font = item.font(column)
                    font.setBold(True)
                    item.setFont(column, font)
            item.setData(ERROR, SYMBOL, symbol)
            item.setData(OWNER, SYMBOL, owner)
            for column, value in ((BEFORE, now.get(symbol, 0.0)), (AFTER, after[symbol]), (MOVE, float(here))):
                item.setData(column, Qt.UserRole, float(value))
                item.setTextAlignment(column, Qt.AlignRight | Qt.AlignVCenter)
        for column in range(MEANING + 1):
            self.table.resizeColumnToContents(column)
        sorted_by = self.table.sortColumn()  # room for the arrow beside the title
        self.table.setColumnWidth(sorted_by, self.table.columnWidth(sorted_by) + 16)
        for column, most in WIDEST.items():
            self.table.setColumnWidth(column, min(most, self.table.columnWidth(column)))
        self.then = then
        self._summarize()

    def _summarize(self) -> None:
        self.summary.setText(self._words(self.then))

    def _words(self, then) -> str:
        (_, old), (unit, new) = (shown_size(then.objective, m) for m in (self.result.MeanSquare, then.mean_square))
        text = f"{mean_name(then.objective)}: {old:.3g} {unit} → <b>{new:.3g} {unit}</b>"
        if old > 0:
            text += f" ({100 * (new - old) / old:+.1f} %)"
        worst = max(zip(then.bodies, then.component_share.tolist()), key=lambda p: p[1])
        words = translate("Sens", "largest share then: {name}, {value}")
        text += " · " + words.format(name=body_name(self.machine, worst[0]), value=percent(worst[1]))
        limit = self.allowed.value()
        if limit > 0 and unit == "µm" and then.objective.power == 2:
            words = translate("Sens", "passes") if new <= limit else translate("Sens", "fails")
            colour = "#3f7d3a" if new <= limit else "#c0392b"
            text += f" · <b style='color:{colour}'>{words}</b> ({limit:g} µm)"
        for name, offset in self.moved.items():
            words = translate("Sens", "scale of {name} moved by {offset}")
            text += "<br>" + words.format(name=name, offset=point_text(offset))
        return text

    def apply(self) -> None:
        """Write what was tried to the document and compute it: one undo step."""
        machine = self.machine
        if machine is None or self.then is None:
            return
        try:
            core, objective = self._tried()
        except Refused as error:
            messages.show(messages.words(error))
            return

        def change():
            known = set(tables.read_tolerances(machine)) | set(self.changes)
            factory.set_tolerances(machine, {s: t for s, t in core.all_tolerances.items() if s in known})
            machine.Objective = told.objective_text(objective)
            for name, offset in self.moved.items():
                tree.axis_of(machine, name).ReferenceOffset += App.Vector(*offset)
            display.compute_and_colour(machine)

        if messages.change(machine.Document, translate("Sens", "Apply what-if"), change):
            self.changes, self.moved = {}, {}
            self._show_shift()
