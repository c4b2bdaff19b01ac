# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the panels of further studies share: asked above, found in tables below, kept in the document, reported.

A study runs in the background on a copy of the machine.  What it found is kept as one undo step in the machine's
Study object (`document.studies`) and shown again when the panel is opened next; a panel fills its tables from that data
alone.  `forget` is called when something else is asked.
"""

from __future__ import annotations

from ..core.refusal import Refused
from ..core.workspace import Cancelled
from ..document import extract, refresh, studies
from ..formats import study_files
from . import live, messages, pointers
from .bars import BAR, BarDelegate
from .copying import copyable
from .panel import Panel
from .panel import show as show_panel
from .qt import Qt, QtGui, translate
from .ranking import NumericItem

KEY = Qt.UserRole + 2  # in column 0: what a row is about


class StudyPanel(Panel):
    """Base.  A panel gives `study` (the verb), `title`, `icon`, `name`, `guide`, and the methods below.

    data : what is shown, as in the verb's JSON file; None before the study ran and after something else was asked.
    found : the result of the study, where it ran in this panel.
    """

    study = title = icon = name = ""
    standard = ("Close",)

    def __init__(self, machine):
        self.machine, self.document = machine, machine.Document
        self.core = extract.core_machine(machine)  # refuses before anything is opened
        self.data = self.found = None
        self.quiet = False
        self.make_form(self.name, self.headline(), self.icon)
        page = QtGui.QVBoxLayout(self.form)
        page.addLayout(self.asked())
        self.grows = self.tables()
        page.addWidget(self.grows)
        self.summary = QtGui.QLabel()
        self.summary.setObjectName(f"{self.name}Summary")
        self.summary.setWordWrap(True)
        page.addWidget(self.summary)
        page.addLayout(self._buttons())
        self.recall()

    # -- what a panel gives ------------------------------------------------------------------------------------------
    def headline(self) -> str:
        """The title of the panel."""
        raise NotImplementedError

    def asked(self):
        """The layout of the fields above the tables."""
        raise NotImplementedError

    def tables(self):
        """The widget that shows what was found."""
        raise NotImplementedError

    def buttons(self) -> list:
        """(text, tool tip, function, name of the attribute) of further buttons."""
        return []

    def settings(self) -> dict:
        """What is asked, as JSON holds it."""
        raise NotImplementedError

    def show_settings(self, settings: dict) -> None:
        """Fill the fields with what was asked."""
        raise NotImplementedError

    def work(self):
        """(function(progress) -> result, what the progress dialog says); the function touches no document."""
        raise NotImplementedError

    def plain(self, found) -> dict:
        """The data of a result, as in the verb's JSON file."""
        raise NotImplementedError

    def files(self, found) -> dict:
        """Name -> text of the files of a result."""
        raise NotImplementedError

    def outdated(self, settings: dict) -> bool:
        """Whether what was asked has changed in a way that `Stale` does not know."""
        return False

    def clear(self) -> None:
        """Empty the tables."""
        raise NotImplementedError

    def fill(self, data: dict) -> None:
        """Show data in the tables."""
        raise NotImplementedError

    def invitation(self) -> str:
        """What the panel says before there is an answer."""
        raise NotImplementedError

    def words(self, data: dict) -> str:
        """The answer in a few sentences."""
        raise NotImplementedError

    def point(self) -> None:
        """Draw in the view what the tables show."""

    def enable(self) -> None:
        """Switch the further buttons."""

    # -- the study ---------------------------------------------------------------------------------------------------
    def _buttons(self):
        row = QtGui.QHBoxLayout()
        self.compute_button = QtGui.QPushButton(translate("Sens", "Compute"))
        self.compute_button.clicked.connect(self.compute)
        row.addWidget(self.compute_button)
        for text, tip, run, attribute in self.buttons():
            button = QtGui.QPushButton(text)
            button.setToolTip(tip)
            button.clicked.connect(run)
            setattr(self, attribute, button)
            row.addWidget(button)
        self.report_button = QtGui.QPushButton(translate("Sens", "Report…"))
        self.report_button.setToolTip(translate("Sens", "Writes what was found as a page, and as JSON and CSV"))
        self.report_button.clicked.connect(self.ask_report)
        row.addWidget(self.report_button)
        return row

    def recall(self) -> None:
        """Show what the document keeps of this study."""
        obj = studies.study_of(self.machine, self.study)
        if obj is None:
            self.forget()
            return
        settings, data = studies.read(obj)
        self.quiet = True
        self.show_settings(settings)
        self.quiet = False
        self.show(data, stale=obj.Stale or self.outdated(settings))

    def forget(self, *_) -> None:
        """Something else is asked: the last answer goes from the panel."""
        if self.quiet:
            return
        self.data = self.found = None
        self.clear()
        self.summary.setText(self.invitation())
        self._enable()

    def _enable(self) -> None:
        self.report_button.setEnabled(self.data is not None)
        self.enable()
        self.point()

    def show(self, data: dict, stale: bool = False) -> None:
        """Show what was found.  stale : the machine has changed since."""
        self.data = data
        self.clear()
        self.fill(data)
        text = self.words(data)
        if stale:
            text = f"<b>{translate('Sens', 'The machine has changed since: compute again.')}</b><br>{text}"
        self.summary.setText(text)
        self._enable()

    def compute(self, *_) -> bool:
        """Run the study, keep it in the document as one undo step and show it; whether it went through."""
        self.forget()
        try:
            self.core = extract.core_machine(self.machine)
            function, title = self.work()
            found = live.in_background(function, title)
        except Refused as error:
            self.summary.setText(messages.words(error))
            return False
        except Cancelled:
            self.summary.setText(translate("Sens", "Cancelled; nothing was changed"))
            return False
        data, core = self.plain(found), self.core

        def change():
            studies.store(self.machine, self.study, self.settings(), data, core, self.headline())

        if not messages.change(self.document, self.headline(), change):
            return False
        self.found = found
        self.show(data)
        return True

    def change(self, name: str, function) -> bool:
        """Change the document by function() as one undo step; what is shown is then out of date."""
        if not messages.change(self.document, name, function):
            return False
        self.look_again()
        return True

    def look_again(self) -> None:
        """Take the machine as it is now; whether what is kept is out of date is determined again."""
        refresh.refresh(self.machine)
        self.core = extract.core_machine(self.machine)

    def ask_report(self, *_) -> list:
        """Ask for a folder and write the files of the study there; returns their paths."""
        folder = messages.ask_folder(translate("Sens", "Folder for the report"))
        if not folder or self.data is None or (self.found is None and not self.compute()):
            return []
        files = self.files(self.found)
        if not messages.may_write(folder, files):
            return []
        try:
            paths = study_files.write_set(folder, self.study, files)
        except Refused as error:
            messages.show(messages.words(error))
            return []
        messages.written(paths)
        return paths

    def leave(self) -> None:
        pointers.clear(self.machine)


def table(name: str, heads, file: str, chosen=None, sort: int | None = None):
    """A table of a study.  heads : texts of the columns.  file : name that is proposed when it is saved as CSV.

    chosen : called when the selection changes.  sort : the column by which it is sorted, the largest first.
    """
    view = QtGui.QTreeWidget()
    view.setObjectName(name)
    view.setRootIsDecorated(False)
    view.setAlternatingRowColors(True)
    view.setUniformRowHeights(True)
    view.setHeaderLabels(list(heads))
    if sort is not None:
        view.setSortingEnabled(True)
        view.sortByColumn(sort, Qt.DescendingOrder)
    if chosen is not None:
        view.itemSelectionChanged.connect(chosen)
    copyable(view, file)
    return view


def add_row(view, texts, values=(), key=None, *, bold: bool = False, tips=(), bar=None):
    """Add a row.  values : column -> number, right-aligned and sorted by.  key : what it is about, in column 0.

    tips : tool tips of columns, else their texts.  bar : (column, value, largest, colour) of a bar.
    """
    item = NumericItem(view)
    values, tips = dict(values), dict(tips)
    for column, text in enumerate(texts):
        item.setText(column, text)
        item.setToolTip(column, tips.get(column, text))
        if bold:
            font = item.font(column)
            font.setBold(True)
            item.setFont(column, font)
    for column, value in values.items():
        item.setData(column, Qt.UserRole, float(value))
        item.setTextAlignment(column, Qt.AlignRight | Qt.AlignVCenter)
    if bar is not None:
        column, value, largest, colour = bar
        item.setData(column, BAR, (float(value), float(largest), colour))
    item.setData(0, KEY, key)
    return item


def fit_columns(view, widest=()) -> None:
    """Make columns as wide as their texts, those of `widest` (column -> pixels) no wider."""
    widest = dict(widest)
    for column in range(view.columnCount()):
        view.resizeColumnToContents(column)
        view.setColumnWidth(column, min(view.columnWidth(column) + (4 if column else 0), widest.get(column, 400)))


def with_bars(view, column: int) -> None:
    """Paint the values of a column as bars."""
    view.setItemDelegateForColumn(column, BarDelegate(view))


def opened(panel):
    """Show a panel; returns it."""
    show_panel(panel, panel.document)
    return panel
