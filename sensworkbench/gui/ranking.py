# SPDX-License-Identifier: LGPL-2.1-or-later
"""The ranked table of every error: tolerance, first-order and total index side by side, and who owns it."""

from __future__ import annotations

from ..core.errors import component
from ..core.refusal import Refused
from . import display
from .bars import BAR, BarDelegate, qcolour
from .qt import Qt, QtGui, Signal, translate
from .texts import body_name, distribution_name, error_meaning, limits

RANK, ERROR, TOTAL, FIRST, TOLERANCE, OWNER, MEANING = range(7)


class _Item(QtGui.QTreeWidgetItem):
    """Sorts numbers as numbers."""

    def __lt__(self, other):
        column = self.treeWidget().sortColumn()
        a, b = (i.data(column, Qt.UserRole) for i in (self, other))
        if a is not None and b is not None:
            return a < b
        return self.text(column) < other.text(column)


def angular(symbol: str) -> bool:
    try:
        return component(symbol).angular
    except Refused:
        return False


class Ranking(QtGui.QWidget):
    """`chosen` is emitted with the bodies of the chosen rows, when the user chooses them."""

    chosen = Signal(list)

    def __init__(self, parent=None):
        super().__init__(parent)
        layout = QtGui.QVBoxLayout(self)
        layout.setContentsMargins(0, 4, 0, 0)
        self.table = QtGui.QTreeWidget()
        self.table.setObjectName("SensRanking")
        self.table.setRootIsDecorated(False)
        self.table.setAlternatingRowColors(True)
        self.table.setUniformRowHeights(True)
        self.table.setSelectionMode(QtGui.QAbstractItemView.ExtendedSelection)
        self.table.setHeaderLabels([
            "#", translate("Sens", "Error"), "Sᵀ", "S", translate("Sens", "Tolerance"), translate("Sens", "Component"),
            translate("Sens", "Meaning"),
        ])  # fmt: skip
        tips = {
            FIRST: translate("Sens", "First-order index: the share of the variance that the error has by itself"),
            TOTAL: translate("Sens", "Total index: its share with all interactions. Bar: Sᵀ; dark inside: S"),
        }
        for column, tip in tips.items():
            self.table.headerItem().setToolTip(column, tip)
        self._delegate = BarDelegate()
        self.table.setItemDelegateForColumn(TOTAL, self._delegate)
        self.table.setSortingEnabled(True)
        self.table.sortByColumn(RANK, Qt.AscendingOrder)
        self.table.itemSelectionChanged.connect(self._selected)
        # what an error is stands beside its index: readable without scrolling in a narrow dock
        self.table.header().moveSection(self.table.header().visualIndex(MEANING), 3)
        self.table.setContextMenuPolicy(Qt.ActionsContextMenu)
        layout.addWidget(self.table)
        self._quiet = False
        self._sized = False

    def show_result(self, machine, result) -> None:
        kept = {i.text(ERROR) for i in self.table.selectedItems()}
        self._quiet = True
        self.table.setSortingEnabled(False)
        self.table.clear()
        if result is not None:
            self._fill(machine, result)
        self.table.setSortingEnabled(True)
        for item in self.items():
            item.setSelected(item.text(ERROR) in kept)
        self._quiet = False
        if result is not None and not self._sized:
            self._sized = True
            for column in range(MEANING + 1):
                self.table.resizeColumnToContents(column)
            self.table.setColumnWidth(TOTAL, 112)
            self.table.setColumnWidth(OWNER, min(110, self.table.columnWidth(OWNER)))

    def _fill(self, machine, result):
        scale, shown = display.scale(result), display.values(result)
        largest = max(result.Total, default=0.0)
        rows = sorted(
            zip(result.Symbols, result.Owners, result.Lower, result.Upper, result.Units, result.Distributions,
                result.First, result.Total),
            key=lambda r: -round(r[7], 12),
        )  # fmt: skip
        for rank, (symbol, owner, low, high, unit, law, first, total) in enumerate(rows, start=1):
            item = _Item(self.table)
            tolerance = limits(low, high, unit, unit not in ("um", "mm", "nm"))
            texts = (str(rank), symbol, "", f"{first:.4f}", tolerance, body_name(machine, owner), error_meaning(symbol))
            for column, text in enumerate(texts):
                item.setText(column, text)
                item.setToolTip(column, text if column != TOLERANCE else f"{text}, {distribution_name(law)}")
            for column, value in ((RANK, rank), (FIRST, first), (TOTAL, total), (TOLERANCE, high - low)):
                item.setData(column, Qt.UserRole, float(value))
            item.setTextAlignment(FIRST, Qt.AlignRight | Qt.AlignVCenter)
            item.setTextAlignment(RANK, Qt.AlignRight | Qt.AlignVCenter)
            item.setTextAlignment(TOLERANCE, Qt.AlignRight | Qt.AlignVCenter)
            item.setData(TOTAL, BAR, (first, total, largest, scale.colour(shown.get(owner))))
            item.setData(OWNER, Qt.UserRole + 2, owner)
            swatch = QtGui.QPixmap(12, 12)
            swatch.fill(qcolour(scale.colour(shown.get(owner))))
            item.setIcon(OWNER, QtGui.QIcon(swatch))

    def items(self):
        return [self.table.topLevelItem(i) for i in range(self.table.topLevelItemCount())]

    def bodies(self) -> list[str]:
        """Bodies of the chosen rows, each once."""
        return list(dict.fromkeys(i.data(OWNER, Qt.UserRole + 2) for i in self.table.selectedItems()))

    def _selected(self):
        if not self._quiet:
            self.chosen.emit(self.bodies())

    def choose_body(self, body: str) -> None:
        """Choose all errors of a body, without emitting."""
        self._quiet = True
        self.table.clearSelection()
        mine = [i for i in self.items() if i.data(OWNER, Qt.UserRole + 2) == body]
        for item in mine:
            item.setSelected(True)
        if mine:
            self.table.scrollToItem(mine[0])
        self._quiet = False
