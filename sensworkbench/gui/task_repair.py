# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that lists the problems of the objects of a document and repairs those that can be repaired, in one undo
step.

A problem that only the user can solve remains in the list with what to do.  A document that was opened with damaged
objects reports it once, and its objects show it in the tree.
"""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui

from ..document import repair
from ..document.base import alive
from . import messages
from .command import Command, Where, command
from .panel import Panel
from .panel import show as show_panel
from .qt import QT_TRANSLATE_NOOP, Qt, QtGui, main_window, translate
from .viewproviders import dress


class TaskRepair(Panel):
    """The panel; `findings` is what is wrong now."""

    guide = "Good to know"
    standard = ("Close",)

    def __init__(self, doc):
        self.document = doc
        self.findings: list[repair.Problem] = []
        self.make_form("SensRepair", translate("Sens", "Repair machine"), "Sens_Repair")
        page = QtGui.QVBoxLayout(self.form)
        self.note = QtGui.QLabel()
        self.note.setObjectName("SensNote")
        self.note.setWordWrap(True)
        page.addWidget(self.note)
        self.table = QtGui.QListWidget()
        self.table.setObjectName("SensFindings")
        self.table.setWordWrap(True)
        self.table.setAlternatingRowColors(True)
        self.table.setHorizontalScrollBarPolicy(Qt.ScrollBarAlwaysOff)
        self.table.setMinimumHeight(150)
        self.grows = self.table
        self.table.itemSelectionChanged.connect(self._point)
        page.addWidget(self.table, 1)
        self.mend = QtGui.QPushButton(translate("Sens", "Repair"))
        self.mend.setToolTip(translate("Sens", "Mends every row with a tick, as one undo step"))
        self.mend.clicked.connect(self.repair)
        page.addWidget(self.mend)
        self.show()

    def show(self, done: int = 0) -> None:
        """Examine the document and list what is found; done : how many findings were mended just now."""
        self.findings = repair.examine(self.document)
        mendable = sum(finding.mendable for finding in self.findings)
        lines = [translate("Sens", "{count} repaired. Undo takes it back.").format(count=done)] if done else []
        if not self.findings:
            lines.append(translate("Sens", "Nothing is wrong with the machine's objects."))
        if mendable:
            lines.append(translate("Sens", "{count} can be repaired; values that are there are kept.").format(
                count=mendable))  # fmt: skip
        if len(self.findings) > mendable:
            lines.append(translate("Sens", "{count} only you can settle; each row says how.").format(
                count=len(self.findings) - mendable))  # fmt: skip
        self.note.setText("\n".join(lines))
        self.mend.setEnabled(bool(mendable))
        style = self.form.style()
        ticks = {
            True: style.standardIcon(QtGui.QStyle.SP_DialogApplyButton),
            False: style.standardIcon(QtGui.QStyle.SP_MessageBoxWarning),
        }
        self.table.clear()
        for finding in self.findings:
            item = QtGui.QListWidgetItem(ticks[finding.mendable], finding.text(messages.language()))
            item.setToolTip(f"{finding.obj.Name}: {messages.words(finding.refusal)}")
            self.table.addItem(item)

    def repair(self, *_) -> None:
        """Mend what can be mended."""
        found = []
        before = len(self.findings)
        if messages.change(
            self.document, translate("Sens", "Repair machine"), lambda: found.extend(repair.repair(self.document))
        ):
            redress(self.document)
            self.show()
            self.show(max(0, before - len(self.findings)))

    def _point(self) -> None:
        """Select the object of the chosen row in the tree."""
        rows = {index.row() for index in self.table.selectedIndexes()}
        Gui.Selection.clearSelection()
        for row in rows:
            Gui.Selection.addSelection(self.findings[row].obj)


def redress(doc) -> None:
    """Give every object of ours its view provider, damaged ones too, so that the tree shows how they are."""
    for obj in doc.Objects:
        if hasattr(obj, "SensType"):
            dress(obj)


def open_panel(doc):
    """Open the panel for a document."""
    panel = TaskRepair(doc)
    show_panel(panel, doc)
    Gui.Selection.clearSelection()
    return panel


def announce(doc):
    """Report that a document was opened with damaged objects, if they can be repaired; return the message or None."""
    found = [f for f in repair.examine(doc) if f.mendable]
    if not found:
        return None
    if any(not alive(f.obj) for f in found):
        redress(doc)
    for finding in found:
        App.Console.PrintWarning(f"{finding.message}\n")
    text = translate("Sens", "{count} objects of Sens Workbench in “{name}” are damaged, such as:").format(
        count=len({f.obj.Name for f in found}), name=doc.Label
    )
    lines = [text, f"{found[0].obj.Label}: {found[0].what}.", ""]
    lines.append(translate("Sens", "Sens > Repair Machine… lists all of them and mends them. Their data are kept."))
    box = messages.show("\n".join(lines))
    button = box.addButton(translate("Sens", "Repair Machine…"), QtGui.QMessageBox.ActionRole)
    button.setObjectName("SensRepairNow")
    button.clicked.connect(lambda *_, name=doc.Name: _open_for(name))
    return box


def _open_for(name: str) -> None:
    if name in App.listDocuments() and not Gui.Control.activeDialog():
        App.setActiveDocument(name)
        open_panel(App.getDocument(name))
        main_window().activateWindow()


@command
class Repair(Command):
    name = "Sens_Repair"
    menu_text = QT_TRANSLATE_NOOP("Sens_Repair", "Repair Machine…")
    tip = QT_TRANSLATE_NOOP(
        "Sens_Repair", "Says what is wrong with the objects of a machine and mends what can be mended"
    )
    needs, guide = "document", TaskRepair.guide
    where = Where("machine", 60, toolbar=False)

    def ready(self):
        return repair.present(App.ActiveDocument)

    def run(self):
        open_panel(App.ActiveDocument)
