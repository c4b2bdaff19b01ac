# SPDX-License-Identifier: LGPL-2.1-or-later
"""The jog panel: a slider and a number for each axis; parts, Abbe offsets and indices at the position follow at once.

The whole jog is one undo step; Cancel puts the parts back.
"""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np

from ..core import workspace
from ..core.refusal import Refused
from ..document import drive, extract, tree
from ..document import jog as moving
from ..document.kinematics import moved_back
from . import colours, display, messages, pointers, state
from .command import Command, Where, command
from .current import current_machine
from .panel import Panel
from .panel import show as show_panel
from .preferences import length_box
from .qt import QT_TRANSLATE_NOOP, Qt, QtCore, QtGui, translate
from .texts import body_name, fixed, length, length_unit, span_text

STEPS = 1000
NEAR = 0.01  # mm from the clicked point that count as reached


class TaskJog(Panel):
    """The panel.  `position` holds the positions of the axes."""

    guide = "5. Jog"
    holds_transaction = True

    def __init__(self, machine):
        self.machine = machine
        self.document = machine.Document
        found = extract.survey(machine)  # refuses before anything is opened
        self.position = found.at
        self.names, self.bodies = found.core.names, found.core.bodies
        self.held = drive.held_by_sliders(machine)
        self.core = None
        self.ranges = dict(state.of(machine.Document).ranges)  # of colours, as they are again when the panel is closed
        self._sized = False
        self.document.openTransaction(translate("Sens", "Jog"))
        self._timer = QtCore.QTimer()
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._move)
        self._quiet = False
        self.make_form("SensJog", translate("Sens", "Jog {name}").format(name=machine.Label), "Sens_Jog")
        layout = QtGui.QVBoxLayout(self.form)
        layout.addWidget(self._axes())
        self.follow = QtGui.QCheckBox(translate("Sens", "Colour by the indices at this position"))
        self.follow.setToolTip(translate("Sens", "Recolours while the axes move; off: the colours of the result stay"))
        result = tree.sensitivity_of(machine)
        self.follow.setChecked(result is not None and bool(result.Coloured))
        self.follow.setEnabled(result is not None and bool(result.Coloured))
        self.follow.toggled.connect(lambda *_: self._timer.start(0))
        layout.addWidget(self.follow)
        self.table = self.grows = self._table()
        layout.addWidget(self.table)
        self.note = QtGui.QLabel()
        self.note.setWordWrap(True)
        layout.addWidget(self.note)
        layout.addStretch(1)
        self._show()

    def _axes(self):
        box = QtGui.QWidget()
        grid = QtGui.QGridLayout(box)
        grid.setContentsMargins(0, 0, 0, 0)
        self.sliders, self.numbers = {}, {}
        for i, name in enumerate(self.names):
            axis = tree.axis_of(self.machine, name)
            low, high = axis.TravelLower.Value, axis.TravelUpper.Value
            slider = QtGui.QSlider(Qt.Horizontal)
            slider.setRange(0, STEPS)
            slider.setPageStep(STEPS // 20)
            slider.setToolTip(span_text(low, high))
            number = length_box(low, high, 3, max(1.0, round((high - low) / 100)))
            number.setKeyboardTracking(False)
            number.setToolTip(span_text(low, high))
            grid.addWidget(QtGui.QLabel(axis.Label), i, 0)
            grid.addWidget(slider, i, 1)
            grid.addWidget(number, i, 2)
            slider.valueChanged.connect(lambda v, n=name, a=low, b=high: self.go(n, a + (b - a) * v / STEPS))
            number.valueChanged.connect(lambda v, n=name: self.go(n, v))
            self.sliders[name], self.numbers[name] = slider, number
        grid.setColumnStretch(1, 1)
        row = QtGui.QHBoxLayout()
        self.home = QtGui.QPushButton(translate("Sens", "Home"))
        self.home.setToolTip(translate("Sens", "All axes to 0"))
        self.home.clicked.connect(self.go_home)
        self.to_point = QtGui.QPushButton(translate("Sens", "To clicked point"))
        self.to_point.setToolTip(translate("Sens", "Moves the tool to the place that was clicked in the 3D view"))
        self.to_point.clicked.connect(self.go_to_clicked)
        row.addStretch(1)
        row.addWidget(self.to_point)
        row.addWidget(self.home)
        grid.addLayout(row, len(self.names), 0, 1, 3)
        return box

    def _table(self):
        table = QtGui.QTableWidget(len(self.bodies), 6)
        table.setObjectName("SensOffsets")
        table.setHorizontalHeaderLabels([
            translate("Sens", "Abbe offset / {unit}").format(unit=length_unit()[0]), "x", "y", "z", "|r|",
            display.symbol(tree.sensitivity_of(self.machine)),
        ])  # fmt: skip
        table.verticalHeader().hide()
        table.setEditTriggers(QtGui.QAbstractItemView.NoEditTriggers)
        table.setSelectionBehavior(QtGui.QAbstractItemView.SelectRows)
        table.setAlternatingRowColors(True)
        table.verticalHeader().setDefaultSectionSize(22)
        table.setMinimumHeight(150)
        self.tallest = 24 * len(self.bodies) + 40
        table.itemSelectionChanged.connect(self._point)
        return table

    # -- moving ------------------------------------------------------------------------------------------------------
    def go(self, name: str, value: float) -> None:
        """Drive one axis; the parts follow before Qt paints the slider, so that both are seen in one frame."""
        if self._quiet:
            return
        self.position[name] = value
        self._timer.stop()
        self._move()

    def _put(self, name):
        axis = tree.axis_of(self.machine, name)
        low, high = axis.TravelLower.Value, axis.TravelUpper.Value
        self.numbers[name].setValue(self.position[name])
        self.sliders[name].setValue(int(round(STEPS * (self.position[name] - low) / (high - low))))

    def go_home(self) -> None:
        """Move every axis to 0, or to the end of its travel nearest to it."""
        for name in self.names:
            box = self.numbers[name]
            self.position[name] = min(max(0.0, box.minimum()), box.maximum())
        self._move()

    def go_to_clicked(self, *_) -> None:
        """Move the tool point to the place that was clicked in the view, or as near to it as the travel allows."""
        picked = [p for s in Gui.Selection.getSelectionEx(self.document.Name, 0) for p in s.PickedPoints]
        if not picked:
            self.note.setText(translate("Sens", "Click the place in the 3D view first."))
            return
        try:
            found = extract.survey(self.machine)
        except Refused as error:
            self.note.setText(messages.words(error))
            return
        where = moved_back(found.displacements["W"], App.Placement(picked[-1], App.Rotation())).Base
        left = self.go_to(found.core, tuple(where))
        if left > NEAR:
            words = translate("Sens", "The travel ends {distance} from the clicked point.")
            self.note.setText(words.format(distance=length(left)))

    def go_to(self, core, place) -> float:
        """Move the tool point to a place over the workpiece (as that is with all axes at 0), mm; returns how far from
        it the tool point is then.
        """
        start = np.zeros(len(self.names))
        base = core.tool_position([start])[0]
        columns = np.stack([core.tool_position([row])[0] - base for row in np.eye(len(self.names))], axis=1)
        q = np.linalg.lstsq(columns, np.array(place) - base, rcond=None)[0]
        boxes = [self.numbers[name] for name in self.names]
        q = np.clip(q, [b.minimum() for b in boxes], [b.maximum() for b in boxes])
        self.position = dict(zip(self.names, q.tolist()))
        self._move()
        return float(np.linalg.norm(core.tool_position([q])[0] - np.array(place)))

    def _move(self) -> None:
        try:
            # what slider joints hold is moved as a drag in the assembly moves it
            (drive.drive if self.held else moving.jog)(self.machine, self.position)
            self.document.recompute()
            self.note.setText("")
        except Refused as error:
            self.note.setText(messages.words(error))
            self.position = extract.stands_at(self.machine)
        self._show()

    def _show(self) -> None:
        self._quiet = True
        for name in self.names:
            self._put(name)
        self._quiet = False
        totals = self._indices()
        unit, size = length_unit()
        digits = 1 if unit == "mm" else 3
        for i, body in enumerate(self.bodies):
            obj = tree.body_of(self.machine, body)
            values = [getattr(obj, f"AbbeOffset{k}").Value for k in "XYZ"] if obj is not None else [None] * 3
            far = obj.AbbeOffset.Length if obj is not None else None
            texts = [body_name(self.machine, body)] + [
                "" if v is None else fixed(v / size, digits) for v in (*values, far)
            ]
            texts.append(f"{totals[body]:.3f}" if body in totals else "–")
            for column, text in enumerate(texts):
                item = self.table.item(i, column)
                if item is None:
                    item = QtGui.QTableWidgetItem()
                    if column:
                        item.setTextAlignment(Qt.AlignRight | Qt.AlignVCenter)
                    self.table.setItem(i, column, item)
                if item.text() != text:
                    item.setText(text)
        if not self._sized:  # measuring every cell takes longer than moving the machine
            self._sized = True
            self.table.resizeColumnsToContents()
            self.table.setColumnWidth(0, min(110, self.table.columnWidth(0)))
            for column in range(1, 6):
                self.table.setColumnWidth(column, max(47, self.table.columnWidth(column)))
        self._point()
        display.ask_for_frame()

    def _indices(self) -> dict[str, float]:
        """Index of each component at the position; the parts take it as colour where that is asked for."""
        try:
            if self.core is None:
                self.core = extract.core_machine(self.machine)  # at home: jogging does not change it
            where = workspace.at(self.core, [self.position[n] for n in self.names])
            found = workspace.sensitivity(self.core, where, extract.objective(self.machine), estimate=False)
        except Refused as error:
            self.note.setText(messages.words(error))
            return {}
        result = tree.sensitivity_of(self.machine)
        totals = display.values_at(result, found)
        if result is not None and result.Coloured:
            view = result.ViewObject
            if self.follow.isChecked():
                scale = display.scale(result) if not view.AutomaticRange else display.lasting(result, totals.values())
                colours.apply(self.machine, result, totals, scale)
                view.Proxy.legend.show(display.position_legend(self.machine, result, totals, self.position), scale,
                                       view.LegendCorner)  # fmt: skip
            else:
                display.update(result)
        return totals

    def _point(self) -> None:
        rows = {i.row() for i in self.table.selectedIndexes()}
        pointers.show(self.machine, [self.bodies[r] for r in sorted(rows)] or list(self.names), detail=bool(rows))

    # -- the panel ---------------------------------------------------------------------------------------------------
    def leave(self):
        self._timer.stop()
        state.of(self.machine.Document).ranges.update(self.ranges)
        pointers.clear(self.machine)

    def close(self) -> None:
        self.leave()
        result = tree.sensitivity_of(self.machine)
        if result is not None:
            display.update(result)
        Gui.Control.closeDialog()

    def accept(self):
        if self._timer.isActive():
            self._timer.stop()
            self._move()
        self.close()
        self.document.recompute()
        self.document.commitTransaction()
        return True

    def reject(self):
        self.close()
        self.document.abortTransaction()
        self.document.recompute()
        return True


def jog(machine):
    """Open the panel for a machine."""
    panel = TaskJog(machine)
    show_panel(panel, machine.Document)
    return panel


@command
class Jog(Command):
    name = "Sens_Jog"
    keys = "Y, J"
    menu_text = QT_TRANSLATE_NOOP("Sens_Jog", "Jog…")
    tip = QT_TRANSLATE_NOOP("Sens_Jog", "Moves the axes and all they carry; shows the Abbe offsets as arrows")
    guide = TaskJog.guide
    where = Where("analysis", 30, tree=("Machine", "Axis"))

    def run(self):
        jog(current_machine())
