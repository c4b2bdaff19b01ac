# SPDX-License-Identifier: LGPL-2.1-or-later
"""The guide in a window of its own, at the section of a command: from the menu, by F1 in a panel, by What's This.

The pages are those of docs/, as they were installed; no network and no browser is needed.
"""

from __future__ import annotations

import os

from .command import Command, Where, command
from .files import ROOT, icon_path
from .qt import QT_TRANSLATE_NOOP, Qt, QtCore, QtGui, main_window, translate

DOCS = os.path.join(ROOT, "docs")
NAME, FIRST = "SensGuide", "guide.md"


class GuideWindow(QtGui.QWidget):
    """A page of the documentation; links between pages and sections are followed inside."""

    def __init__(self, parent):
        super().__init__(parent, Qt.Window)
        self.setObjectName(NAME)
        self.setWindowTitle(translate("Sens", "Guide of Sens Workbench"))
        self.setWindowIcon(QtGui.QIcon(icon_path("SensWorkbench")))
        layout = QtGui.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        self.text = QtGui.QTextBrowser()
        self.text.setSearchPaths([DOCS])
        self.text.setOpenLinks(False)
        self.text.document().setDocumentMargin(12)
        self.text.anchorClicked.connect(self._followed)
        layout.addWidget(self.text)
        self.page = ""
        self.resize(860, 760)

    def open(self, page: str, section: str = "") -> bool:
        """Show a page of docs/ at a section (its heading, or the heading's address); False where it is not there."""
        path = os.path.join(DOCS, page)
        if not os.path.isfile(path):
            return False
        if page != self.page:
            with open(path, encoding="utf-8") as file:
                self.text.setMarkdown(file.read())
            self.page = page
        return self._scroll(section)

    def section(self) -> str:
        """The heading at which the page stands."""
        return self.text.textCursor().block().text()

    def _scroll(self, section: str) -> bool:
        cursor = self.text.textCursor()
        cursor.movePosition(QtGui.QTextCursor.Start)
        block = self.text.document().begin()
        while section and block.isValid():
            if block.blockFormat().headingLevel() and section in (block.text(), address(block.text())):
                cursor.setPosition(block.position())
                break
            block = block.next()
        self.text.moveCursor(QtGui.QTextCursor.End)  # so that the heading ends up at the top
        self.text.setTextCursor(cursor)
        self.text.ensureCursorVisible()
        return not section or block.isValid()

    def _followed(self, url) -> None:
        page, _, section = url.toString().partition("#")
        if url.scheme() in ("http", "https"):
            QtGui.QDesktopServices.openUrl(url)
        elif page.endswith(".md") or not page:
            self.open(page or self.page, section)


def address(heading: str) -> str:
    """The part of a link that leads to a heading: "2. Tolerances" is "2-tolerances"."""
    kept = "".join(c for c in heading.lower() if c.isalnum() or c in " -_")
    return kept.replace(" ", "-")


def show(section: str = "", page: str = FIRST) -> GuideWindow:
    """Show the guide at a section."""
    found = main_window().findChild(QtGui.QWidget, NAME) or GuideWindow(main_window())
    found.open(page, section)
    found.show()
    found.raise_()
    found.activateWindow()
    return found


class HelpKey(QtCore.QObject):
    """F1 inside a widget shows a section of the guide."""

    def __init__(self, widget, section: str):
        super().__init__(widget)
        self.section = section
        widget.installEventFilter(self)

    def eventFilter(self, watched, event):
        kind = event.type()
        if kind in (QtCore.QEvent.ShortcutOverride, QtCore.QEvent.KeyPress) and event.key() == Qt.Key_F1:
            event.accept()
            if kind == QtCore.QEvent.KeyPress:
                show(self.section)
            return True
        return False


@command
class Guide(Command):
    name = "Sens_Guide"
    menu_text = QT_TRANSLATE_NOOP("Sens_Guide", "Guide")
    tip = QT_TRANSLATE_NOOP("Sens_Guide", "Shows the guide; in a panel of Sens Workbench F1 shows the section about it")
    icon, needs, guide, beside = "SensWorkbench", "nothing", "A review, step by step", True
    where = Where("help", 10, toolbar=False)

    def run(self):
        show()
