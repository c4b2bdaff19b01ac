# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that writes a machine's fitted errors as the tables of a controller.

Before anything is written it shows the statement: what the chosen format holds, what it cannot hold, and the predicted
error before and after.  It changes nothing in the document.
"""

from __future__ import annotations

from pathlib import Path

from ..core.refusal import Refused
from ..document import extract
from ..formats.exchange import convert, known
from . import messages
from .command import Command, Where, command
from .current import current_machine
from .panel import Panel
from .panel import show as show_panel
from .preferences import combo
from .qt import QT_TRANSLATE_NOOP, QtGui, translate


class TaskTables(Panel):
    """The panel; `written` is what would be written in the chosen format, None where that is refused."""

    guide = "8. Close the loop: readings in, the missing effect out"
    standard = ("Close",)

    def __init__(self, machine):
        self.core = extract.core_machine(machine)  # refuses before anything is opened
        if self.core.fitted is None:
            raise Refused("gui-no-fitted-errors", machine.Label)
        self.written = None
        self.make_form(
            "SensTables", translate("Sens", "Compensation tables of {name}").format(name=machine.Label), "Sens_Tables"
        )
        page = QtGui.QVBoxLayout(self.form)
        row = QtGui.QHBoxLayout()
        row.addWidget(QtGui.QLabel(translate("Sens", "Format")))
        self.format = combo([(f.name, f.title) for f in known.every() if f.takes_positions])
        self.format.setObjectName("SensTableFormat")
        row.addWidget(self.format, 1)
        page.addLayout(row)
        page.addWidget(QtGui.QLabel(translate("Sens", "What these files hold, and what they cannot:")))
        self.statement = QtGui.QPlainTextEdit()
        self.statement.setObjectName("SensStatement")
        self.statement.setReadOnly(True)
        self.statement.setMinimumHeight(150)
        self.grows = self.statement
        page.addWidget(self.statement, 1)
        self.write = QtGui.QPushButton(QtGui.QIcon(messages.icon("Sens_Tables")), translate("Sens", "Write files…"))
        self.write.setToolTip(translate("Sens", "Writes the tables and this statement into a folder"))
        self.write.clicked.connect(self.ask_and_write)
        page.addWidget(self.write)
        self.format.currentIndexChanged.connect(self.show)
        self.show()

    def show(self, *_) -> None:
        """State what the chosen format holds, or why it can hold nothing of this machine."""
        self.written = None
        try:
            self.written = convert.write(self.core, self._chosen())
            text = convert.statement(self.core, self.written, language=messages.language())
        except Refused as error:
            text = messages.words(error)
        self.statement.setPlainText(text)
        self.write.setEnabled(self.written is not None)

    def _chosen(self) -> str:
        return self.format.itemData(self.format.currentIndex())

    def ask_and_write(self, *_) -> list[Path]:
        """Ask for a folder and write the files and statement.txt, all or none; returns their paths."""
        folder = messages.ask_folder(translate("Sens", "Folder for the compensation tables"))
        if not folder or self.written is None:
            return []
        if not messages.may_write(folder, (*self.written.files, convert.STATEMENT)):
            return []
        try:
            written = convert.convert(self.core, self._chosen(), folder, language=messages.language())
        except Refused as error:
            messages.show(messages.words(error))
            return []
        paths = [Path(folder) / name for name in (*written.files, convert.STATEMENT)]
        messages.written(paths)
        return paths


def open_panel(machine) -> TaskTables:
    """Open the panel for a machine with fitted errors."""
    panel = TaskTables(machine)
    show_panel(panel, machine.Document)
    return panel


@command
class Tables(Command):
    name = "Sens_Tables"
    menu_text = QT_TRANSLATE_NOOP("Sens_Tables", "Export Compensation Tables…")
    tip = QT_TRANSLATE_NOOP(
        "Sens_Tables", "Writes the fitted errors as tables of a controller, and states what they cannot hold"
    )
    needs, guide = "fitted", TaskTables.guide
    where = Where("loop", 80)

    def run(self):
        open_panel(current_machine())
