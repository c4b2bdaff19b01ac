# SPDX-License-Identifier: LGPL-2.1-or-later
"""What commands work on: the machine, readings, trace or effect that is selected, else the only or the newest one."""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui

from ..core.refusal import Refused
from ..document import tree
from ..document.base import kind_of


def machines() -> list:
    """The machines of the active document; cheap enough to be asked whenever a menu is updated."""
    doc = App.ActiveDocument
    if doc is None:
        return []
    return [o for o in doc.findObjects("App::DocumentObjectGroup") if kind_of(o) == "Machine"]


def current_machine():
    """The selected machine (or that of the selected axis, table or result), else the only one; refuses otherwise."""
    for obj in Gui.Selection.getSelection():
        machine = obj if kind_of(obj) == "Machine" else tree.owner_machine(obj) if kind_of(obj) else None
        if machine is not None:
            return machine
    return tree.machine_of(App.ActiveDocument)


def tables() -> list:
    """Readings objects of the active document."""
    return [t for m in machines() for t in tree.readings_of(m)]


def traces() -> list:
    """Trace objects of the active document."""
    return [t for m in machines() for t in tree.traces_of(m)]


def results() -> list:
    """Sensitivity objects of the active document."""
    return [r for m in machines() if (r := tree.sensitivity_of(m)) is not None]


def selected(kind: str):
    """The selected object of a kind, or None."""
    return next((o for o in Gui.Selection.getSelection() if kind_of(o) == kind), None)


def current_table():
    """The selected readings (or those of the selected trace), else the newest of the machine; refuses otherwise."""
    chosen, trace = selected("Readings"), selected("Trace")
    if chosen is None and trace is not None:
        chosen = trace.Readings
    if chosen is None:
        found = tree.readings_of(current_machine())
        if not found:
            raise Refused("gui-no-readings", current_machine().Label)
        chosen = found[-1]
    return chosen


def current_trace():
    """The selected trace (or that of the selected readings), else the newest of the machine; refuses otherwise."""
    chosen, table = selected("Trace"), selected("Readings")
    if chosen is None and table is not None:
        chosen = tree.trace_of(table)
    if chosen is None:
        found = tree.traces_of(current_machine())
        if not found:
            raise Refused("gui-no-trace", current_machine().Label)
        chosen = found[-1]
    return chosen
