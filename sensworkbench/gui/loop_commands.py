# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the closed loop, in the order of the work: readings, fit, trace, effects, residuals, files."""

from __future__ import annotations

import FreeCADGui as Gui

from ..core.refusal import Refused
from ..document import closed_loop, factory
from ..document.base import kind_of
from . import messages
from .command import QT_TRANSLATE_NOOP, Command, current_machine, machines
from .qt import translate


def tables() -> list:
    """Readings objects of the active document."""
    return [t for m in machines() for t in closed_loop.readings_of(m)]


def traces() -> list:
    return [t for m in machines() for t in closed_loop.traces_of(m)]


def selected(kind: str):
    return next((o for o in Gui.Selection.getSelection() if kind_of(o) == kind), None)


def current_table():
    """The selected readings (or those of the selected trace), else the newest of the machine; refuses otherwise."""
    chosen, trace = selected("Readings"), selected("Trace")
    if chosen is None and trace is not None:
        chosen = trace.Readings
    if chosen is None:
        found = closed_loop.readings_of(current_machine())
        if not found:
            raise Refused(
                translate("Sens", "there are no readings yet"), current_machine().Label,
                translate("Sens", "Import readings first."),
            )  # fmt: skip
        chosen = found[-1]
    return chosen


def current_trace():
    """The selected trace (or that of the selected readings), else the newest of the machine; refuses otherwise."""
    chosen, table = selected("Trace"), selected("Readings")
    if chosen is None and table is not None:
        chosen = closed_loop.trace_of(table)
    if chosen is None:
        found = closed_loop.traces_of(current_machine())
        if not found:
            raise Refused(
                translate("Sens", "nothing has been traced yet"), current_machine().Label,
                translate("Sens", "Trace the readings first."),
            )  # fmt: skip
        chosen = found[-1]
    return chosen


class ImportReadings(Command):
    name = "Sens_ImportReadings"
    menu_text = QT_TRANSLATE_NOOP("Sens_ImportReadings", "Import Readings…")
    tip = QT_TRANSLATE_NOOP(
        "Sens_ImportReadings", "Reads a table of measured errors: laser, ballbar, diagonals, tracker or probe"
    )

    def run(self):
        from .task_readings import import_readings

        machine = current_machine()
        path = messages.ask_open(
            translate("Sens", "Import readings"), translate("Sens", "Tables (*.csv *.txt *.tsv);;All files (*)")
        )
        if path:
            import_readings(machine, path)


class Fit(Command):
    name = "Sens_Fit"
    menu_text = QT_TRANSLATE_NOOP("Sens_Fit", "Fit Declared Errors…")
    tip = QT_TRANSLATE_NOOP(
        "Sens_Fit", "Fits the declared errors to the readings: what they explain, and what the plan cannot tell apart"
    )
    start = False

    def ready(self):
        return bool(tables())

    def run(self):
        from .task_trace import open_panel

        open_panel(current_table(), self.start)


class Trace(Fit):
    name = "Sens_Trace"
    menu_text = QT_TRANSLATE_NOOP("Sens_Trace", "Trace…")
    tip = QT_TRANSLATE_NOOP("Sens_Trace", "Searches for the effect that explains what the declared errors leave over")
    start = True


class AddEffect(Command):
    name = "Sens_AddEffect"
    menu_text = QT_TRANSLATE_NOOP("Sens_AddEffect", "Add Effects")
    tip = QT_TRANSLATE_NOOP("Sens_AddEffect", "Adds the found effects to the machine, each under its body")

    def ready(self):
        return any(closed_loop.can_add(t) for t in traces())

    def run(self):
        from .task_trace import add_effects

        add_effects(current_trace())


class SwitchEffect(Command):
    name = "Sens_SwitchEffect"
    menu_text = QT_TRANSLATE_NOOP("Sens_SwitchEffect", "Effect On or Off")
    tip = QT_TRANSLATE_NOOP("Sens_SwitchEffect", "Switches the selected effect off, or on again")

    def ready(self):
        return bool(machines()) and selected("Effect") is not None

    def run(self):
        effect = selected("Effect")
        if effect is None:
            raise Refused(translate("Sens", "no effect is selected"))
        machine = factory.owner_machine(effect)

        def change():
            effect.Enabled = not effect.Enabled
            machine.touch()

        messages.change(effect.Document, translate("Sens", "Effect on or off"), change)


class Residuals(Command):
    name = "Sens_Residuals"
    menu_text = QT_TRANSLATE_NOOP("Sens_Residuals", "Residuals")
    tip = QT_TRANSLATE_NOOP(
        "Sens_Residuals", "Shows the residuals before and after as arrows in the workspace, or hides them"
    )

    def ready(self):
        return bool(traces())

    def run(self):
        from . import residuals
        from .task_trace import show_residuals

        trace = current_trace()
        hidden = trace.ViewObject.ShowResiduals == residuals.OFF
        show_residuals(trace, residuals.BOTH if hidden else residuals.OFF)


class TraceReport(Command):
    name = "Sens_TraceReport"
    menu_text = QT_TRANSLATE_NOOP("Sens_TraceReport", "Export Trace Report…")
    tip = QT_TRANSLATE_NOOP("Sens_TraceReport", "Writes what was found as HTML and JSON, with the augmented machine")

    def ready(self):
        return any(t.Readings is not None for t in traces())

    def run(self):
        from .task_trace import ask_and_write

        ask_and_write(current_trace())


class Tables(Command):
    name = "Sens_Tables"
    menu_text = QT_TRANSLATE_NOOP("Sens_Tables", "Export Compensation Tables…")
    tip = QT_TRANSLATE_NOOP(
        "Sens_Tables", "Writes the fitted errors as tables of a controller, and states what they cannot hold"
    )

    def ready(self):
        return any(m.Fitted for m in machines())

    def run(self):
        from .task_tables import open_panel

        open_panel(current_machine())


COMMANDS = (ImportReadings, Fit, Trace, AddEffect, SwitchEffect, Residuals, TraceReport, Tables)


def names() -> list[str]:
    return [c.name for c in COMMANDS]
