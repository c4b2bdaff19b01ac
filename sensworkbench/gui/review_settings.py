# SPDX-License-Identifier: LGPL-2.1-or-later
"""Settings of an analysis and of its display: objective, positions, squareness; colours, range and legend.

Each change is one undo step.  A change of the analysis computes the indices again at once; a change of the display only
recolours.
"""

from __future__ import annotations

import itertools

from ..core.machine import MOST_JOINTS
from ..core.refusal import Refused
from ..document import extract, told, tree
from . import display, messages
from .colormap import MAPS
from .looks import POINTS, map_forms, sliced
from .objective_form import ObjectiveForm
from .preferences import (
    aggregate_choices,
    colour_by_choices,
    combo,
    corner_choices,
    length_box,
    number_box,
    read_field,
    write_field,
)
from .qt import Qt, QtGui, translate

STEPS = 200  # of the slider of a slice


def _plain(value):
    """The number of a length, anything else as it is."""
    return getattr(value, "Value", value)


class Settings(QtGui.QScrollArea):
    """The tab that sets objective, positions and squareness of a machine, and how its result is shown."""

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setWidgetResizable(True)
        self.setFrameShape(QtGui.QFrame.NoFrame)
        body = QtGui.QWidget()
        self.setWidget(body)
        page = QtGui.QVBoxLayout(body)
        page.setContentsMargins(2, 6, 2, 2)
        self.machine = self.result = None
        self._quiet = False
        page.addWidget(self._objective())
        page.addWidget(self._look())
        page.addStretch(1)

    def _objective(self):
        group = QtGui.QGroupBox(translate("Sens", "What is judged"))
        rows = QtGui.QFormLayout(group)
        self.objective = ObjectiveForm()
        self.aggregate = combo(aggregate_choices())
        self.count = QtGui.QSpinBox()
        self.count.setRange(1, 120)
        self.count.setToolTip(translate("Sens", "Positions per axis"))
        self.at = [length_box(-1e5, 1e5) for _ in range(MOST_JOINTS)]
        at = QtGui.QHBoxLayout()
        for box in self.at:
            at.addWidget(box, 1)
        self.squareness = combo([
            ("direction", translate("Sens", "tilts the motion (ISO 230-1)")),
            ("carried", translate("Sens", "also turns what the guide carries")),
        ])  # fmt: skip
        rows.addRow(self.objective)
        rows.addRow(translate("Sens", "Positions"), self.aggregate)
        rows.addRow(translate("Sens", "Per axis"), self.count)
        rows.addRow(translate("Sens", "Position"), at)
        rows.addRow(translate("Sens", "Squareness"), self.squareness)
        self.apply = QtGui.QPushButton(translate("Sens", "Compute"))
        self.apply.setObjectName("SensApplySettings")
        self.apply.clicked.connect(self.compute)
        rows.addRow("", self.apply)
        self.aggregate.currentIndexChanged.connect(self._kinds)
        return group

    def _look(self):
        group = QtGui.QGroupBox(translate("Sens", "How it is shown"))
        rows = QtGui.QFormLayout(group)
        self.colour_by = combo(colour_by_choices())
        self.colour_map = combo([(name, name.capitalize()) for name in MAPS])
        self.automatic = QtGui.QCheckBox(translate("Sens", "Automatic"))
        self.automatic.setToolTip(
            translate("Sens", "From 0 to just above the largest index; otherwise the range sticks")
        )
        self.lower, self.upper = number_box(0, 1e6), number_box(0, 1e6)
        ends = QtGui.QHBoxLayout()
        ends.addWidget(self.automatic)
        ends.addWidget(self.lower, 1)
        ends.addWidget(QtGui.QLabel("…"))
        ends.addWidget(self.upper, 1)
        self.whole = QtGui.QToolButton()
        self.whole.setText("0…1")
        self.whole.setToolTip(translate("Sens", "From 0 to 1, so that every machine has the same colours"))
        self.whole.clicked.connect(self.set_whole)
        ends.addWidget(self.whole)
        self.legend = QtGui.QCheckBox(translate("Sens", "Show"))
        self.corner = combo(corner_choices())
        legend = QtGui.QHBoxLayout()
        legend.addWidget(self.legend)
        legend.addWidget(self.corner, 1)
        self.map = QtGui.QCheckBox(translate("Sens", "Show"))
        self.map_shows = combo([
            ("Expected", translate("Sens", "Expected error √E[Y]")),
            ("Upper estimate", translate("Sens", "Upper estimate √(E[Y] + 2√V(Y))")),
        ])  # fmt: skip
        self.map_as = combo([(POINTS, translate("Sens", "Points"))])  # the slices are those of the machine
        self.map_slider = QtGui.QSlider(Qt.Horizontal)
        self.map_slider.setRange(0, STEPS)
        self.map_slider.setToolTip(translate("Sens", "Moves the slice along its axis"))
        self.map_slider.valueChanged.connect(self._slid)
        self.map_slider.sliderReleased.connect(lambda: self._slid(self.map_slider.value()))
        self.map_at = length_box(-1e5, 1e5, 1)
        shows = QtGui.QHBoxLayout()
        shows.addWidget(self.map)
        shows.addWidget(self.map_shows, 1)
        slices = QtGui.QHBoxLayout()
        slices.addWidget(self.map_as)
        slices.addWidget(self.map_slider, 1)
        slices.addWidget(self.map_at)
        rows.addRow(translate("Sens", "Parts show"), self.colour_by)
        rows.addRow(translate("Sens", "Colour map"), self.colour_map)
        rows.addRow(translate("Sens", "Range"), ends)
        rows.addRow(translate("Sens", "Legend"), legend)
        rows.addRow(translate("Sens", "Error map"), shows)
        rows.addRow("", slices)
        self._fields = {
            "ColourBy": self.colour_by, "ColourMap": self.colour_map, "AutomaticRange": self.automatic,
            "RangeLower": self.lower, "RangeUpper": self.upper, "ShowLegend": self.legend,
            "LegendCorner": self.corner, "ShowErrorMap": self.map,
            "ErrorMapShows": self.map_shows, "ErrorMapAs": self.map_as, "ErrorMapAt": self.map_at,
        }  # fmt: skip
        for name, field in self._fields.items():
            if isinstance(field, QtGui.QComboBox):
                field.currentIndexChanged.connect(lambda *_, n=name: self._look_changed(n))
            elif isinstance(field, QtGui.QCheckBox):
                field.toggled.connect(lambda *_, n=name: self._look_changed(n))
            else:
                field.setKeyboardTracking(False)
                field.valueChanged.connect(lambda *_, n=name: self._look_changed(n))
        return group

    def _kinds(self, *_):
        kind = read_field(self.aggregate)
        self.count.setEnabled(kind != "at")
        for box in self.at:
            box.setEnabled(kind == "at")
        if self.machine is not None and kind != "at" and not self._quiet:
            self.count.setValue(self.machine.Grid if kind == "grid" else self.machine.Order)

    def show_machine(self, machine, result) -> None:
        """Fill the fields from a machine and its result."""
        self.machine, self.result = machine, result
        self.setEnabled(machine is not None)
        if machine is None:
            return
        self._quiet = True
        try:
            self._show_objective(machine)
            write_field(self.aggregate, machine.Aggregate)
            self.count.setValue(machine.Grid if machine.Aggregate == "grid" else machine.Order)
            axes = tree.joint_names(tree.bodies(machine))
            for box, name in itertools.zip_longest(self.at, axes):
                box.setVisible(name is not None)
                box.setPrefix("" if name is None else f"{name} ")
            for box, value in zip(self.at, machine.At or [0.0] * len(axes)):
                box.setValue(value)
            write_field(self.squareness, machine.Squareness)
            self._kinds()
            view = result.ViewObject if result is not None else None
            self._offer_slices(machine)
            known = view is not None and all(hasattr(view, name) for name in self._fields)
            for name, field in self._fields.items():
                field.setEnabled(known)
                if known:
                    write_field(field, _plain(getattr(view, name)))
            if known:
                self._show_slice(view)
                shown = display.scale(result)
                self.lower.setEnabled(not view.AutomaticRange)
                self.upper.setEnabled(not view.AutomaticRange)
                if view.AutomaticRange:
                    self.lower.setValue(shown.lower)
                    self.upper.setValue(shown.upper)
        finally:
            self._quiet = False

    def _offer_slices(self, machine) -> None:
        """The forms of the map: points, and a slice for each axis that moves along a line."""
        words = translate("Sens", "Slice at {axis}")
        forms = map_forms(display.sliding_axes(machine))
        if forms != [self.map_as.itemData(i) for i in range(self.map_as.count())]:
            self.map_as.clear()
            for form in forms:
                self.map_as.addItem(
                    words.format(axis=sliced(form)) if sliced(form) else translate("Sens", "Points"), form
                )

    def _show_objective(self, machine) -> None:
        """The objective of the machine; the fields stay as they are where it is not registered here."""
        try:
            self.objective.show_objective(extract.objective(machine))
        except Refused as error:
            messages.status(messages.words(error))

    def _show_slice(self, view) -> None:
        """The slider for the sliced axis; nothing to slide for points."""
        axis = tree.axis_of(self.machine, sliced(view.ErrorMapAs)) if view.ErrorMapAs != POINTS else None
        for field in (self.map_slider, self.map_at):
            field.setEnabled(axis is not None)
        if axis is not None:  # a slice along an axis that this machine has not is shown as points
            low, high = axis.TravelLower.Value, axis.TravelUpper.Value
            self.map_at.setRange(low, high)
            self.map_at.setValue(view.ErrorMapAt.Value)
            self.map_slider.setValue(int(round(STEPS * (self.map_at.value() - low) / (high - low))))

    def _slid(self, step: int) -> None:
        """The slice follows the slider; the document takes the position when the slider is let go."""
        if self._quiet or self.result is None:
            return
        low, high = self.map_at.minimum(), self.map_at.maximum()
        self._quiet = True
        self.map_at.setValue(round(low + (high - low) * step / STEPS, 1))
        self._quiet = False
        if self.map_slider.isSliderDown():
            display.show_map(self.machine, self.result, self.map_at.value())
        else:
            self._look_changed("ErrorMapAt")

    def compute(self) -> None:
        """Write the objective and compute again: one undo step."""
        machine = self.machine
        if machine is None:
            return

        def change():
            machine.Objective = told.objective_text(self.objective.objective())
            for name, field in (("Aggregate", self.aggregate), ("Squareness", self.squareness)):
                if getattr(machine, name) != read_field(field):
                    setattr(machine, name, read_field(field))
            machine.At = [b.value() for b in self.at[: len(tree.joint_names(tree.bodies(machine)))]]
            if read_field(self.aggregate) != "at":
                setattr(machine, "Grid" if read_field(self.aggregate) == "grid" else "Order", self.count.value())
            display.compute_and_colour(machine)

        messages.change(machine.Document, translate("Sens", "Sensitivity"), change)

    def set_whole(self, *_) -> None:
        """Colours from 0 to 1, as one undo step."""
        if self.result is None:
            return
        result, view = self.result, self.result.ViewObject

        def change():
            view.AutomaticRange, view.RangeLower, view.RangeUpper = False, 0.0, 1.0
            display.update(result)

        messages.change(result.Document, translate("Sens", "Look of the result"), change)
        self.show_machine(self.machine, result)

    def _look_changed(self, name: str) -> None:
        if self._quiet or self.result is None:
            return
        result, view = self.result, self.result.ViewObject
        value = read_field(self._fields[name])
        if _plain(getattr(view, name)) == value:
            return

        def change():
            if name == "AutomaticRange" and not value:
                shown = display.scale(result)  # by hand from where the automatic range stood
                view.RangeLower, view.RangeUpper = shown.lower, shown.upper
            if name == "ErrorMapAs" and value not in view.getEnumerationsOfProperty(name):  # of an earlier version
                view.ErrorMapAs = map_forms(display.sliding_axes(self.machine))
            setattr(view, name, value)
            if name == "LegendCorner" and hasattr(view, "LegendPlace"):
                view.LegendPlace = (0, 0, 0)  # in the corner itself
            display.update(result)

        messages.change(result.Document, translate("Sens", "Look of the result"), change)
        self.show_machine(self.machine, result)
