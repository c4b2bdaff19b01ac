# SPDX-License-Identifier: LGPL-2.1-or-later
"""One clear message when something cannot be done, and one way to change a document: a transaction with a name."""

from __future__ import annotations

import traceback
from contextlib import contextmanager

import FreeCAD as App

from ..core.refusal import Refused
from ..core.workspace import Cancelled
from .qt import Qt, QtGui, main_window, translate, usual_cursor


def show(text: str, title: str = "Sens Workbench"):
    """A message that does not stop the event loop; returns the box."""
    box = QtGui.QMessageBox(QtGui.QMessageBox.Warning, title, text, QtGui.QMessageBox.Ok, main_window())
    box.setObjectName("SensMessage")
    box.setTextFormat(Qt.PlainText)
    box.setAttribute(Qt.WA_DeleteOnClose)
    box.open()
    return box


def refused(error: Refused, doc):
    """Show a refusal; where the document is damaged, with the command that mends it."""
    return show(error.message + repair_hint(doc))


def log(error: BaseException) -> None:
    """Write an exception that is a defect of the program, with where it came from, to the report view."""
    lines = traceback.format_exception(type(error), error, error.__traceback__)
    App.Console.PrintError("Sens Workbench: " + "".join(lines))


def stopped(error: Exception, what: str):
    """Show that a command ended in a defect of the program; the details go to the report view."""
    log(error)
    words = translate("Sens", "{what} stopped: {error}. Nothing was changed. The report view holds the details.")
    return show(words.format(what=what, error=f"{type(error).__name__}: {error}".rstrip(".")))


def repair_hint(doc) -> str:
    """A sentence that names Repair Machine where that would mend something, else ""."""
    from ..document import repair

    if doc is None or not any(finding.mendable for finding in repair.examine(doc)):
        return ""
    return "\n\n" + translate("Sens", "Objects of this document are damaged: Sens > Repair Machine… mends them.")


@contextmanager
def transaction(doc, name: str):
    """One undo step: everything inside, or nothing when it raises."""
    doc.openTransaction(name)
    try:
        yield
        doc.recompute()
    except BaseException:
        doc.abortTransaction()
        raise
    doc.commitTransaction()


def change(doc, name: str, function) -> bool:
    """Run function() as one undo step; a refusal becomes a message and leaves the document as it was."""
    try:
        with transaction(doc, name):
            function()
    except Refused as error:
        refused(error, doc)
        return False
    except Cancelled:
        status(translate("Sens", "Cancelled; nothing was changed"))
        return False
    except Exception as error:  # noqa: BLE001 - a defect: said where the person looks, and written to the report view
        stopped(error, name)
        return False
    return True


def status(text: str) -> None:
    """A line in the status bar for a few seconds."""
    if App.GuiUp:
        main_window().statusBar().showMessage(text, 6000)


def icon(name: str) -> str:
    """Return the path of an icon, by its name without `.svg`."""
    from .files import icon_path

    return icon_path(name)


def ask_open(title: str, kinds: str) -> str:
    """Path of a file to read, or ""."""
    with usual_cursor():
        return QtGui.QFileDialog.getOpenFileName(main_window(), title, "", kinds)[0]


def ask_save(title: str, kinds: str, name: str) -> str:
    """Path of a file to write, or ""."""
    with usual_cursor():
        return QtGui.QFileDialog.getSaveFileName(main_window(), title, name, kinds)[0]


def ask_folder(title: str) -> str:
    """Path of a folder, or ""."""
    with usual_cursor():
        return QtGui.QFileDialog.getExistingDirectory(main_window(), title)
