# SPDX-License-Identifier: LGPL-2.1-or-later
"""Taking over a document that was just opened, or made or computed without a window.

A document saved without a window has no view data: FreeCAD opens it with everything hidden and grey.  Where the machine
says so (`ViewPending`) its parts are shown, given the colours they were made with, then those of the result.
"""

from __future__ import annotations

import FreeCAD as App

from ..core.refusal import Refused
from ..document import refresh, tree
from ..document.base import alive, kind_of
from . import colours, display
from .qt import later
from .viewproviders import dress


def adopt(doc) -> None:
    """Give all objects view providers, complete what a batch run left pending, show colours and legends."""
    for obj in doc.Objects:
        if kind_of(obj) and alive(obj):
            dress(obj)
    modified = _modified(doc)
    for machine in tree.machines(doc):
        if alive(machine) and machine.ViewPending:
            _bring_up(machine)
        if alive(machine) and machine.Unseen:
            for obj in filter(None, map(doc.getObject, machine.Unseen)):
                obj.ViewObject.Visibility = True
            machine.Unseen = []
    for result in display.results(doc):
        display.update(result)
    if modified is False:
        _set_modified(doc, False)


def _bring_up(machine) -> None:
    doc = machine.Document
    shown = set()
    for body in (tree.BED, *tree.bodies(machine)):
        try:
            parts = tree.parts_of(machine, body)
        except Refused:
            continue
        for where in parts:
            for obj in where.chain:
                shown.add(obj.Name) if obj.Document == doc else None
            for leaf in colours.paths.leaves(where):
                shown.update(o.Name for o in leaf.chain if o.Document == doc)
    for obj in doc.Objects:
        view = obj.ViewObject
        if view is not None and (kind_of(obj) or obj.Name in shown):
            view.Visibility = True
    for name, text in dict(machine.PartColours).items():
        obj = doc.getObject(name)
        colour = _hex(text)
        if obj is not None and colour and hasattr(obj.ViewObject, "ShapeColor"):
            colours.paint(obj, colour)
    for result in display.results(doc):
        if result.Coloured and tree.owner_machine(result) == machine:
            display.update(result)
    machine.ViewPending = False


def _hex(text: str):
    text = text.strip().lstrip("#")
    if len(text) != 6:
        return None
    try:
        return tuple(int(text[i : i + 2], 16) / 255 for i in (0, 2, 4))
    except ValueError:
        return None


def _modified(doc):
    import FreeCADGui as Gui

    return getattr(Gui.getDocument(doc.Name), "Modified", None)


def _set_modified(doc, value: bool) -> None:
    import FreeCADGui as Gui

    try:
        Gui.getDocument(doc.Name).Modified = value
    except AttributeError:  # read-only on FreeCAD 0.20: the document then counts as changed
        return


def settle(name: str) -> None:
    """After undo or redo: determine again which results are out of date, and update the display."""

    def run():
        if name not in App.listDocuments():
            return
        doc = App.getDocument(name)
        for machine in tree.machines(doc):
            if alive(machine):
                refresh.refresh(machine)
        for result in display.results(doc):
            display.update(result)

    later(run)
