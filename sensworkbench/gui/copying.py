# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables out of the window: Ctrl+C copies the chosen rows (all where none is chosen), the context menu also saves CSV.

Columns go out in the order in which they are shown, separated by tabs for a spreadsheet, by commas in a file.
"""

from __future__ import annotations

import csv
import io

from ..core.refusal import Refused
from ..formats.files import write_text
from . import messages
from .qt import Qt, QtGui, translate


def content(view, *, everything: bool = False) -> list[list[str]]:
    """Head and rows of a table or list view as texts; the chosen rows, or all."""
    model, header = view.model(), _header(view)
    count = model.columnCount()
    order = sorted(range(count), key=header.visualIndex)
    shown = [c for c in order if not header.isSectionHidden(c)]
    chosen = sorted({i.row() for i in view.selectionModel().selectedIndexes()})
    rows = chosen if chosen and not everything else range(model.rowCount())
    head = [str(model.headerData(c, Qt.Horizontal) or "") for c in shown]
    return [head, *([_text(model.index(r, c)) for c in shown] for r in rows)]


def _header(view):
    return view.header() if hasattr(view, "header") else view.horizontalHeader()


def _text(index) -> str:
    """What a cell says; where a bar is painted the number is its tool tip or value."""
    text = index.data(Qt.DisplayRole)
    if text in (None, ""):
        text = index.data(Qt.UserRole)
    return f"{text:.6g}" if isinstance(text, float) else "" if text is None else str(text)


def copy(view) -> None:
    """Put the chosen rows on the clipboard."""
    lines = ["\t".join(row) for row in content(view)]
    QtGui.QApplication.clipboard().setText("\n".join(lines) + "\n")
    messages.status(translate("Sens", "{n} rows copied").format(n=len(lines) - 1))


def csv_text(view) -> str:
    """All rows as CSV."""
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerows(content(view, everything=True))
    return out.getvalue()


def ask_and_save(view, name: str) -> None:
    """Ask for a file and write all rows."""
    path = messages.ask_save(translate("Sens", "Save table"), "CSV (*.csv)", name)
    if path:
        try:
            write_text(path, csv_text(view))
        except Refused as error:
            messages.show(messages.words(error))
            return
        messages.status(translate("Sens", "Written: {files}").format(files=path))


def copyable(view, name: str) -> None:
    """Give a view the actions Copy (Ctrl+C) and Save as CSV.  name : of the file that is proposed."""
    for text, keys, run in (
        (translate("Sens", "Copy"), QtGui.QKeySequence.Copy, lambda *_: copy(view)),
        (translate("Sens", "Save as CSV…"), None, lambda *_: ask_and_save(view, name)),
    ):
        action = QtGui.QAction(text, view)
        if keys is not None:
            action.setShortcut(QtGui.QKeySequence(keys))
            action.setShortcutContext(Qt.WidgetShortcut)
        action.triggered.connect(run)
        view.addAction(action)
    view.setContextMenuPolicy(Qt.ActionsContextMenu)
