# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page under Edit > Preferences > Sens.  It shows and stores `settings`; its defaults are those of the code."""

from __future__ import annotations

from . import settings
from .qt import Qt, QtGui, translate


class PreferencePage:
    """A preference page: FreeCAD calls loadSettings and saveSettings and shows `form`."""

    def __init__(self, parent=None):
        self.form = QtGui.QWidget()
        self.form.setObjectName("SensPreferences")
        self.form.setWindowTitle(translate("Sens", "General"))
        page = QtGui.QVBoxLayout(self.form)
        colours = QtGui.QGroupBox(translate("Sens", "Colours and legend of new results"))
        rows = QtGui.QFormLayout(colours)
        self.colour_map = combo(
            [
                ("viridis", translate("Sens", "Viridis (purple to yellow)")),
                ("cividis", translate("Sens", "Cividis (blue to yellow)")),
                ("magma", translate("Sens", "Magma (black to pale yellow)")),
            ]
        )
        self.colour_by = combo(colour_by_choices())
        self.corner = combo(corner_choices())
        self.automatic = QtGui.QCheckBox(translate("Sens", "From 0 to just above the largest index"))
        self.lower, self.upper = number_box(0, 1), number_box(0, 1)
        ends = QtGui.QHBoxLayout()
        for label, box in ((translate("Sens", "from"), self.lower), (translate("Sens", "to"), self.upper)):
            ends.addWidget(QtGui.QLabel(label))
            ends.addWidget(box)
        ends.addStretch(1)
        self.automatic.toggled.connect(self._ranges)
        rows.addRow(translate("Sens", "Colour map"), self.colour_map)
        rows.addRow(translate("Sens", "Parts show"), self.colour_by)
        rows.addRow(translate("Sens", "Range"), self.automatic)
        rows.addRow("", ends)
        rows.addRow(translate("Sens", "Legend"), self.corner)
        numbers = QtGui.QGroupBox(translate("Sens", "Computing"))
        rows = QtGui.QFormLayout(numbers)
        self.aggregate = combo(aggregate_choices()[:2])
        self.order, self.grid = QtGui.QSpinBox(), QtGui.QSpinBox()
        self.order.setRange(1, 60)
        self.grid.setRange(2, 120)
        self.live = QtGui.QCheckBox(translate("Sens", "Recolour at once when the machine changes"))
        rows.addRow(translate("Sens", "Positions of a new machine"), self.aggregate)
        rows.addRow(translate("Sens", "Quadrature, positions per axis"), self.order)
        rows.addRow(translate("Sens", "Grid, positions per axis"), self.grid)
        rows.addRow("", self.live)
        units = QtGui.QGroupBox(translate("Sens", "Units"))
        rows = QtGui.QFormLayout(units)
        self.angle = combo([("urad", "µrad"), ("arcsec", translate("Sens", "arc seconds (″)"))])
        rows.addRow(translate("Sens", "Angles, and those of new tolerance tables"), self.angle)
        for box in (colours, numbers, units):
            page.addWidget(box)
        page.addStretch(1)
        self._fields = {
            "ColourMap": self.colour_map, "ColourBy": self.colour_by, "LegendCorner": self.corner,
            "AutomaticRange": self.automatic, "RangeLower": self.lower, "RangeUpper": self.upper,
            "Aggregate": self.aggregate, "Order": self.order, "Grid": self.grid, "Live": self.live,
            "AngleUnit": self.angle,
        }  # fmt: skip

    def _ranges(self, automatic: bool):
        self.lower.setEnabled(not automatic)
        self.upper.setEnabled(not automatic)

    def loadSettings(self):
        for name, field in self._fields.items():
            write_field(field, settings.get(name))
        self._ranges(self.automatic.isChecked())

    def saveSettings(self):
        for name, field in self._fields.items():
            settings.put(name, read_field(field))


# -- fields that several panels use ----------------------------------------------------------------------------------
def colour_by_choices():
    """Return (stored value, text) of each index that colours can show."""
    return [
        ("Share", translate("Sens", "Share of the variance; all shares add to 1")),
        ("Mean", translate("Sens", "Total index, mean over the positions")),
        ("Largest", translate("Sens", "Total index, largest over the positions")),
        ("Variance weighted", translate("Sens", "Total index, weighted by the variance")),
        ("First order", translate("Sens", "First-order index, mean over the positions")),
    ]


def corner_choices():
    """Return (stored value, text) of each corner of the view."""
    return [
        ("Upper left", translate("Sens", "Upper left")),
        ("Upper right", translate("Sens", "Upper right")),
        ("Lower left", translate("Sens", "Lower left")),
        ("Lower right", translate("Sens", "Lower right")),
    ]


def aggregate_choices():
    """Return (stored value, text) of each way to choose positions."""
    return [
        ("quadrature", translate("Sens", "Workspace, Gauss-Legendre quadrature")),
        ("grid", translate("Sens", "Workspace, regular grid")),
        ("at", translate("Sens", "One position")),
    ]


def combo(choices):
    """A combo box whose entries carry a value: [(value, text)]."""
    box = QtGui.QComboBox()
    box.setSizeAdjustPolicy(QtGui.QComboBox.AdjustToMinimumContentsLengthWithIcon)
    box.setMinimumContentsLength(max(3, min(16, max(len(text) for _, text in choices))))
    for value, text in choices:
        box.addItem(text, value)
    return box


def number_box(low: float, high: float, decimals: int = 3, step: float = 0.05, suffix: str = ""):
    """Return a spin box for numbers from `low` to `high`."""
    box = QtGui.QDoubleSpinBox()
    box.setDecimals(decimals)
    box.setRange(low, high)
    box.setSingleStep(step)
    box.setSuffix(suffix)
    box.setAlignment(Qt.AlignRight)
    box.setMinimumWidth(64)  # Qt would make room for the longest possible number
    return box


class LengthBox(QtGui.QDoubleSpinBox):
    """A field for a length: its value is in mm, it shows and reads the unit that FreeCAD's preferences want."""

    def __init__(self, low: float, high: float, decimals: int, step: float):
        super().__init__()
        self._asked = decimals, step
        self._take_unit()
        self.setRange(low, high)
        self.setSuffix(f" {self.unit}")
        self.setAlignment(Qt.AlignRight)
        self.setMinimumWidth(64)

    def _take_unit(self) -> None:
        self.unit, self.size = settings.length_unit()
        (decimals, step), metric = self._asked, self.unit == "mm"
        self.setDecimals(decimals if metric else decimals + 2)
        self.setSingleStep(step if metric else self.size * max(0.05, round(step / self.size, 1)))

    def showEvent(self, event):
        """Qt: the preferences may have changed since it was shown last."""
        if (self.unit, self.size) != settings.length_unit():
            self._take_unit()
            if self.suffix():
                self.setSuffix(f" {self.unit}")
        super().showEvent(event)

    def textFromValue(self, value):
        """Qt: the number without its unit."""
        return (
            self.locale()
            .toString(value / self.size, "f", self.decimals())
            .replace(self.locale().groupSeparator() or "\0", "")
        )

    def valueFromText(self, text):
        """Qt: the length in mm of a text, its unit apart."""
        number, good = self.locale().toDouble(
            text.removeprefix(self.prefix()).replace(self.suffix() or "\0", "").strip()
        )
        return number * self.size if good else self.value()


def length_box(low: float, high: float, decimals: int = 3, step: float = 10.0) -> LengthBox:
    """A field for a length; low, high, step and its value are in mm."""
    return LengthBox(low, high, decimals, step)


def read_field(field):
    """Return the value of a combo box, check box or spin box."""
    if isinstance(field, QtGui.QComboBox):
        return field.itemData(field.currentIndex())
    return field.isChecked() if isinstance(field, QtGui.QCheckBox) else field.value()


def write_field(field, value) -> None:
    """Set the value of a combo box, check box or spin box."""
    if isinstance(field, QtGui.QComboBox):
        field.setCurrentIndex(max(0, field.findData(value)))
    elif isinstance(field, QtGui.QCheckBox):
        field.setChecked(bool(value))
    else:
        field.setValue(value)
