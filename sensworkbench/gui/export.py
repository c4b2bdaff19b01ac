# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of a stored result: HTML with a picture of the view, JSON, CSV; and the picture alone."""

from __future__ import annotations

import os
import tempfile
from contextlib import contextmanager
from pathlib import Path

from ..core.refusal import Refused
from ..document import extract, results, tree
from ..formats import study_files
from ..studies.sensitivity import completed
from . import messages, settings, state
from .command import Command, Where, command
from .current import current_machine
from .qt import QT_TRANSLATE_NOOP, pump, translate

PICTURE = "view.png"
FILES = ("report.html", "sensitivity.json", "sensitivity.csv", PICTURE)


def view_of(doc):
    """A 3D view of a document, or None."""
    import FreeCADGui as Gui

    views = Gui.getDocument(doc.Name).mdiViewsOfType("Gui::View3DInventor")
    return views[0] if views else None


def picture(doc, width: int = 1600, height: int = 1100, background: str = "White") -> bytes | None:
    """PNG of the 3D view with its legend, or None without a view.  What is selected does not show in it."""
    view = view_of(doc)
    if view is None:
        return None
    pump()
    handle, path = tempfile.mkstemp(suffix=".png")
    os.close(handle)
    try:
        with unselected(doc):
            view.saveImage(path, width, height, background)
        return Path(path).read_bytes()
    finally:
        os.unlink(path)


@contextmanager
def unselected(doc):
    """Nothing of a document is selected inside, so that each part has the colour of its index; then it is again."""
    import FreeCADGui as Gui

    kept = [(s.Object.Name, sub) for s in Gui.Selection.getSelectionEx(doc.Name, 0)
            for sub in s.SubElementNames or ("",)]  # fmt: skip
    if not kept:
        yield
        return
    with state.quietly(doc):
        Gui.Selection.clearSelection(doc.Name)
        pump()
        try:
            yield
        finally:
            for name, sub in kept:
                Gui.Selection.addSelection(doc.Name, name, sub)


def export(machine, folder) -> list[Path]:
    """Write report.html, sensitivity.json, sensitivity.csv and view.png; returns their paths."""
    result = tree.sensitivity_of(machine)
    if result is None or not result.Symbols:
        raise Refused("gui-no-result", machine.Label)
    if result.Stale:
        raise Refused("gui-result-stale", result.Label)
    core = extract.core_machine(machine)
    png = picture(machine.Document)
    study = completed(core, results.load(machine, result))
    files = study_files.sensitivity_files(study, settings.get("AngleUnit"), png, messages.language())
    if png is not None:
        files[PICTURE] = png
    return study_files.write_set(folder, "sensitivity", files)


def ask_and_export(machine) -> None:
    """Ask for a folder and write the report of a machine's result to it."""
    folder = messages.ask_folder(translate("Sens", "Folder for the report"))
    if folder and messages.may_write(folder, FILES):
        messages.written(export(machine, folder))


def save_picture(doc) -> None:
    """Ask for a name and save the view with its legend."""
    path = messages.ask_save(translate("Sens", "Save picture"), "PNG (*.png)", "sensitivity.png")
    if path:
        from ..formats.files import write_bytes

        content = picture(doc)
        if content is None:
            raise Refused("gui-no-view", doc.Label)
        write_bytes(path, content)
        messages.status(translate("Sens", "Written: {files}").format(files=path))


@command
class Report(Command):
    name = "Sens_Report"
    keys = "Y, P"
    menu_text = QT_TRANSLATE_NOOP("Sens_Report", "Export Report…")
    tip = QT_TRANSLATE_NOOP("Sens_Report", "Writes the ranking as HTML with a picture of the view, and as JSON and CSV")
    needs, guide = "result", "7. Take it with you"
    where = Where("files", 10, tree=("Sensitivity",))

    def run(self):
        ask_and_export(current_machine())
