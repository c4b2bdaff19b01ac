# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rows that choose an objective: which of the registered ones, its output, its weights and its own parameters.

Everything comes from `core.objectives.OBJECTIVES`: a new objective appears here with the fields of its class.  Its
words are the messages `objective-name-NAME` and `objective-field-FIELD`, or the names themselves where there are none.
"""

from __future__ import annotations

from dataclasses import MISSING, fields

from ..core.objectives import OBJECTIVES, Objective, from_json
from ..core.synthesis import ORIENTATION, POSITION
from ..messages import Message
from ..messages.tables import known
from . import messages
from .preferences import combo, number_box, read_field, write_field
from .qt import QtGui, Signal, translate

COMMON = tuple(f.name for f in fields(Objective))  # what every objective has: output and weights


def words(code: str, name: str) -> str:
    """The text of a message, or the name in words where there is no such message."""
    return messages.words(Message(code)) if known(code) else name.replace("_", " ").capitalize()


def own_fields(name: str) -> list:
    """The fields of a registered objective that not every objective has."""
    return [f for f in fields(OBJECTIVES[name]) if f.name not in COMMON]


class ObjectiveForm(QtGui.QWidget):
    """Fields for an objective.  `objective()` gives it, `show_objective` fills them; `changed`: the user edited one."""

    changed = Signal()

    def __init__(self, parent=None):
        super().__init__(parent)
        self.rows = QtGui.QFormLayout(self)
        self.rows.setContentsMargins(0, 0, 0, 0)
        self.output = combo([
            (POSITION, translate("Sens", "Position of the tool")),
            (ORIENTATION, translate("Sens", "Orientation of the tool")),
        ])  # fmt: skip
        self.name = combo([(n, words(f"objective-name-{n.replace('_', '-')}", n)) for n in OBJECTIVES])
        self.name.setObjectName("SensObjective")
        self.weights = [number_box(-1000, 1000, 3, 0.5) for _ in range(3)]
        weights = QtGui.QHBoxLayout()
        tip = translate("Sens", "Weight of each component; 0 leaves it out (a groove does not care along its length)")
        for label, box in zip("XYZ", self.weights):
            weights.addWidget(QtGui.QLabel(label))
            weights.addWidget(box, 1)
            box.setToolTip(tip)
        self.rows.addRow(translate("Sens", "Output"), self.output)
        self.rows.addRow(translate("Sens", "Objective"), self.name)
        self.rows.addRow(translate("Sens", "Weights"), weights)
        self.own: dict = {}  # field of the chosen objective -> its editor
        self._fixed = self.rows.rowCount()
        self._make_own()
        self.name.currentIndexChanged.connect(lambda *_: self._make_own())
        for box in (self.output, self.name):
            box.currentIndexChanged.connect(lambda *_: self.changed.emit())
        for box in self.weights:
            box.setKeyboardTracking(False)
            box.valueChanged.connect(lambda *_: self.changed.emit())

    def _make_own(self) -> None:
        """The editors of the fields that only the chosen objective has."""
        while self.rows.rowCount() > self._fixed:
            self.rows.removeRow(self._fixed)
        self.own = {}
        for field in own_fields(read_field(self.name)):
            default = None if field.default is MISSING else field.default
            self.own[field.name] = editor = _editor(default)
            label = words(f"objective-field-{field.name.replace('_', '-')}", field.name)
            self.rows.addRow(label, editor)
            signal = editor.toggled if isinstance(default, bool) else None
            if signal is None:
                signal = editor.valueChanged if hasattr(editor, "valueChanged") else editor.editingFinished
            signal.connect(lambda *_: self.changed.emit())

    def show_objective(self, objective: Objective) -> None:
        """Fill the fields, without saying that something was changed."""
        self.blockSignals(True)
        data = objective.to_json()
        write_field(self.output, objective.output)
        write_field(self.name, objective.name)
        for box, value in zip(self.weights, objective.weights):
            box.setValue(value)
        for name, editor in self.own.items():
            _write(editor, data.get(name, getattr(objective, name)))
        self.blockSignals(False)

    def objective(self) -> Objective:
        """The objective of the fields; refuses values that it does not take."""
        data = {"name": read_field(self.name), "output": read_field(self.output)}
        data["weights"] = [box.value() for box in self.weights]
        return from_json(data | {name: _read(editor) for name, editor in self.own.items()})


def _editor(default):
    """What edits a value of the kind of `default`: check box, spin box or a line of text."""
    if isinstance(default, bool):
        editor = QtGui.QCheckBox()
    elif isinstance(default, int):
        editor = QtGui.QSpinBox()
        editor.setRange(-(10**9), 10**9)
    elif isinstance(default, str):
        editor = QtGui.QLineEdit()
    else:
        editor = number_box(-1e9, 1e9, 6, 0.05)
        editor.setKeyboardTracking(False)
    if default is not None:
        _write(editor, default)
    return editor


def _write(editor, value) -> None:
    if isinstance(editor, QtGui.QLineEdit):
        editor.setText(str(value))
    else:
        write_field(editor, value)


def _read(editor):
    return editor.text() if isinstance(editor, QtGui.QLineEdit) else read_field(editor)
