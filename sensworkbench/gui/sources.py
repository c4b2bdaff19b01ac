# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a direction, reference or tool point is taken from, as a line of the machine panel, and in words."""

from __future__ import annotations

from ..core.refusal import Refused
from ..document import paths
from . import messages
from .qt import QtGui, translate
from .texts import fixed


class Source(QtGui.QWidget):
    """A line that shows where something is taken from, with buttons to take the selection and to go back."""

    def __init__(self, take, reset):
        super().__init__()
        row = QtGui.QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        self.text = QtGui.QLineEdit()
        self.text.setReadOnly(True)
        self.text.setMinimumWidth(40)
        self.take = QtGui.QToolButton()
        self.take.setText(translate("Sens", "Take"))
        self.take.setToolTip(
            translate("Sens", "Takes the coordinate system, datum, edge, face or part that is selected")
        )
        self.take.clicked.connect(lambda *_: take())
        row.addWidget(self.text, 1)
        row.addWidget(self.take)
        self.reset = None
        if reset is not None:
            self.reset = QtGui.QToolButton()
            self.reset.setText("↺")
            self.reset.setToolTip(translate("Sens", "Back to the default"))
            self.reset.clicked.connect(lambda *_: reset())
            row.addWidget(self.reset)

    def show(self, words: str, given: bool) -> None:
        """Show in words what the source is.  given : it was chosen by the user and can be reset."""
        self.text.setText(words)
        self.text.setToolTip(words)
        if self.reset is not None:
            self.reset.setEnabled(given)


def along_choices():
    """Return the texts of the choices for a direction, in the order of the property's values."""
    return [
        translate("Sens", "Automatic"), translate("Sens", "its local X"), translate("Sens", "its local Y"),
        translate("Sens", "its local Z"),
    ]  # fmt: skip


def reference_choices():
    """Return the texts of the choices for a reference point, in the order of the property's values."""
    return [
        translate("Sens", "Automatic"),
        translate("Sens", "at its placement"),
        translate("Sens", "at its centre of mass"),
    ]


def source_words(source, otherwise: str = "") -> str:
    """Return label and element of a source, or what is used instead of it."""
    found = paths.place(source) if source else None
    if found is None:
        return otherwise
    try:
        return found.label
    except Refused as error:
        return messages.words(error)


def vector_words(v, digits: int) -> str:
    """Return a vector as text with this number of digits."""
    return "(" + ", ".join(fixed(x, digits) for x in (v.x, v.y, v.z)) + ")"
