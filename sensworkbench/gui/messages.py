# SPDX-License-Identifier: LGPL-2.1-or-later
"""One clear message when something cannot be done, and one way to change a document: a transaction with a name."""

from __future__ import annotations

import traceback
from contextlib import contextmanager
from pathlib import Path

import FreeCAD as App

from ..core.refusal import Refused
from ..core.workspace import Cancelled
from ..document import told
from .qt import Qt, QtCore, QtGui, main_window, run, translate, usual_cursor


def show(text: str, title: str = "Sens Workbench"):
    """A message that does not stop the event loop; returns the box."""
    box = QtGui.QMessageBox(QtGui.QMessageBox.Warning, title, text, QtGui.QMessageBox.Ok, main_window())
    box.setObjectName("SensMessage")
    box.setTextFormat(Qt.PlainText)
    box.setAttribute(Qt.WA_DeleteOnClose)
    box.open()
    return box


def language() -> str:
    """The language that the labels of the window are in, as the tables of messages name it."""
    return translate("Sens", "en")  # "de" in the German table, "ko" in the Korean one


def words(found) -> str:
    """A refusal or message in the language of the window."""
    return found.text(language())


def stored(text: str) -> str:
    """The sentence of a property that holds code and fields (`document.told`), in the language of the window."""
    return told.words(text, language())


def refused(error: Refused, doc):
    """Show a refusal; where the document is damaged, with the command that mends it."""
    return show(words(error) + repair_hint(doc))


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


def may_write(folder, names) -> bool:
    """True where none of the files is there yet, or the user lets them be overwritten."""
    there = [n for n in names if (Path(folder) / n).exists()]
    if not there:
        return True
    text = translate("Sens", "{folder} holds {files} already. Overwrite?").format(folder=folder, files=", ".join(there))
    buttons = QtGui.QMessageBox.Yes | QtGui.QMessageBox.No
    box = QtGui.QMessageBox(QtGui.QMessageBox.Question, "Sens Workbench", text, buttons, main_window())
    box.setObjectName("SensOverwrite")
    box.setTextFormat(Qt.PlainText)
    with usual_cursor():
        return run(box) == QtGui.QMessageBox.Yes


def written(paths) -> None:
    """Say what was written, in the status bar and in a message that opens a page or the folder."""
    paths = [Path(p) for p in paths]
    status(translate("Sens", "Written: {files}").format(files=", ".join(str(p) for p in paths)))
    if not paths:
        return
    page = next((p for p in paths if p.suffix == ".html"), paths[0].parent)
    lines = [translate("Sens", "Written to {folder}:").format(folder=paths[0].parent), *(p.name for p in paths)]
    box = QtGui.QMessageBox(QtGui.QMessageBox.Information, "Sens Workbench", "\n".join(lines),
                            QtGui.QMessageBox.Close, main_window())  # fmt: skip
    box.setObjectName("SensWritten")
    box.setTextFormat(Qt.PlainText)
    box.setAttribute(Qt.WA_DeleteOnClose)
    words = translate("Sens", "Open the report") if page.suffix else translate("Sens", "Open the folder")
    open_it = box.addButton(words, QtGui.QMessageBox.ActionRole)
    open_it.clicked.connect(lambda *_: QtGui.QDesktopServices.openUrl(QtCore.QUrl.fromLocalFile(str(page))))
    box.open()


def ask_folder(title: str) -> str:
    """Path of a folder, or ""."""
    with usual_cursor():
        return QtGui.QFileDialog.getExistingDirectory(main_window(), title)
