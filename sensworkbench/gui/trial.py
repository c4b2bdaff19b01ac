# SPDX-License-Identifier: LGPL-2.1-or-later
"""A machine moves before anything is computed: a slider drags one axis within its travel, a button drives all of them.

Whatever was moved goes back to where it stood as soon as the slider is let go of: the document does not change.
"""

from __future__ import annotations

import math

import FreeCAD as App

from ..core.refusal import Refused
from ..document import drive, extract, jog, tree
from . import state
from .qt import Qt, QtCore, QtGui, translate

STEPS = 200  # of the slider
FRAMES = 24  # of one axis that goes to both ends and back
PAUSE = 40  # milliseconds between two frames
BACK = 900  # milliseconds after a change by keyboard or wheel until the axis goes back


class Trial(QtGui.QWidget):
    """A slider and a button.  machine() : the machine; axis() : the chosen axis or ""; say(text) : shows a refusal."""

    def __init__(self, machine, axis, say):
        super().__init__()
        self.machine, self.axis, self.say = machine, axis, say
        self.stood, self._quiet, self._left = None, False, []
        self.slider = QtGui.QSlider(Qt.Horizontal)
        self.slider.setRange(0, STEPS)
        self.slider.setToolTip(translate("Sens", "Moves the axis within its travel; it goes back when you let go"))
        self.slider.valueChanged.connect(self._dragged)
        self.slider.sliderReleased.connect(self.back)
        self.all = QtGui.QToolButton()
        self.all.setText("▶ " + translate("Sens", "All axes"))
        self.all.setToolTip(translate("Sens", "Moves one axis after the other to the ends of its travel and back"))
        self.all.clicked.connect(self.play)
        row = QtGui.QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(QtGui.QLabel(translate("Sens", "Try it")))
        row.addWidget(self.slider, 1)
        row.addWidget(self.all)
        self._timer, self._home = QtCore.QTimer(self), QtCore.QTimer(self)
        self._timer.timeout.connect(self._frame)
        self._home.setSingleShot(True)
        self._home.timeout.connect(self.back)

    def show_axis(self) -> None:
        """The slider stands where the chosen axis stands."""
        span = self._span(self.axis())
        self.slider.setEnabled(span is not None)
        if span is not None:
            low, high, at = span
            self._quiet = True
            self.slider.setValue(round(STEPS * (at - low) / (high - low)))
            self._quiet = False

    def _span(self, name: str):
        axis = tree.axis_of(self.machine(), name) if name else None
        if axis is None or axis.Kind != "linear" or axis.TravelUpper.Value <= axis.TravelLower.Value:
            return None
        return axis.TravelLower.Value, axis.TravelUpper.Value, axis.Position.Value

    def _dragged(self, value: int) -> None:
        span = self._span(self.axis())
        if self._quiet or span is None or self._timer.isActive():
            return
        low, high, _ = span
        self.move({self.axis(): low + (high - low) * value / STEPS})
        if not self.slider.isSliderDown():
            self._home.start(BACK)

    def move(self, position: dict[str, float]) -> bool:
        """Put axes somewhere; false where something holds them, which is said."""
        machine = self.machine()
        try:
            if self.stood is None:
                self.stood = dict(extract.survey(machine).at)
            with state.quietly(machine.Document):
                self._put(machine, position)
        except Refused as error:
            from . import messages

            self._timer.stop()
            self.say(messages.words(error))
            return False
        return True

    @staticmethod
    def _put(machine, position) -> None:
        (drive.drive if drive.held_by_sliders(machine) else jog.jog)(machine, position)
        machine.Document.recompute()

    def back(self) -> None:
        """Everything back to where it stood."""
        self._home.stop()
        self._timer.stop()
        self._left = []
        stood, self.stood = self.stood, None
        if stood is not None:
            try:
                self._put(self.machine(), stood)
            except (Refused, ReferenceError):
                App.Console.PrintLog("Sens Workbench: the axes are not back\n")
        self.show_axis()

    def play(self, *_) -> None:
        """One axis after the other goes to both ends of its travel and back; pressed again, they stop."""
        going = self._timer.isActive()
        self.back()
        names = [n for n in (*self.machine().WorkpieceChain, *self.machine().ToolChain) if self._span(n)]
        self._left = [] if going else [(name, k) for name in names for k in range(1, FRAMES + 1)]
        if self._left:
            self._timer.start(PAUSE)

    def _frame(self) -> None:
        if not self._left:
            self.back()
            return
        name, k = self._left.pop(0)
        low, high, _ = self._span(name)
        at = (self.stood or extract.survey(self.machine()).at)[name]
        turn = math.sin(2 * math.pi * k / FRAMES)  # up to one end, down to the other, and back
        self.move({name: at + turn * ((high - at) if turn > 0 else (at - low)) if k < FRAMES else at})

    def stop(self) -> None:
        """Stop the timers; touches no document."""
        self._timer.stop()
        self._home.stop()
        self._left = []
