# SPDX-License-Identifier: LGPL-2.1-or-later
"""The ranked table of every error: tolerance, first-order and total index side by side, and who owns it."""

from __future__ import annotations

from collections import Counter

from ..document.refresh import components
from . import display
from .bars import BAR, BarDelegate, qcolour
from .copying import copyable
from .qt import Qt, QtGui, Signal, translate
from .texts import body_name, distribution_name, limits, meaning, short_name

RANK, ERROR, SHARE, TOTAL, FIRST, TOLERANCE, OWNER, MEANING = range(8)


WIDEST = {ERROR: 90, MEANING: 130, OWNER: 110, TOLERANCE: 80}  # pixels; the tool tip says the rest


class NumericItem(QtGui.QTreeWidgetItem):
    """Sorts numbers as numbers."""

    def __lt__(self, other):
        column = self.treeWidget().sortColumn()
        a, b = (i.data(column, Qt.UserRole) for i in (self, other))
        if a is not None and b is not None:
            return a < b
        return self.text(column) < other.text(column)


def angular(symbol: str, known) -> bool:
    """Whether an error is an angle; False for the name of an effect.  known : the components of the machine."""
    return symbol in known and known[symbol].angular


# where the values of a row stand: all that may change from one result to the next
PLACES = tuple(
    [(column, role) for column in range(MEANING + 1) for role in (Qt.DisplayRole, Qt.ToolTipRole)]
    + [(column, Qt.UserRole) for column in (RANK, SHARE, FIRST, TOTAL, TOLERANCE)]
    + [(SHARE, BAR), (OWNER, Qt.UserRole + 2), (OWNER, Qt.DecorationRole)]
)


def _rows(machine, result) -> dict[tuple[str, int], list]:
    """Return (symbol, number of earlier rows with it) -> values of its row, in the order of PLACES; the largest share
    first.

    Only traced effects can share a name.
    """
    scale, shown, known = display.scale(result), display.values(result), components(machine)
    named = {s: (short_name(machine, s), meaning(machine, s, known)) for s in dict.fromkeys(result.Symbols)}
    shares = display.mean_of(result, ("First", "Total"))
    largest = max(shares, default=0.0)
    owners = {o: (body_name(machine, o), tuple(scale.colour(shown.get(o)))) for o in dict.fromkeys(result.Owners)}
    errors = sorted(
        zip(result.Symbols, result.Owners, result.Lower, result.Upper, result.Units, result.Distributions,
            result.First, result.Total, shares),
        key=lambda r: -round(r[8], 12),
    )  # fmt: skip
    rows, seen = {}, Counter()
    for rank, (symbol, owner, low, high, unit, law, first, total, share) in enumerate(errors, start=1):
        name, colour = owners[owner]
        tolerance = limits(low, high, unit, unit not in ("um", "mm", "nm"))
        texts = (str(rank), named[symbol][0], "", f"{total:.4f}", f"{first:.4f}", tolerance, name, named[symbol][1])
        tips = [*texts]
        tips[ERROR] = named[symbol][1]
        tips[TOLERANCE] += f", {distribution_name(law)}"
        values = [value for pair in zip(texts, tips) for value in pair]
        values += [float(rank), float(share), float(first), float(total), float(high - low)]
        rows[symbol, seen[symbol]] = [*values, (share, largest, colour), owner, colour]
        seen[symbol] += 1
    return rows


def _write(item, column: int, role, value) -> None:
    if role == Qt.DecorationRole:
        swatch = QtGui.QPixmap(12, 12)
        swatch.fill(qcolour(value))
        value = QtGui.QIcon(swatch)
    item.setData(column, role, value)


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
            "#", translate("Sens", "Error"), translate("Sens", "Share"), "Sᵀ", "S", translate("Sens", "Tolerance"),
            translate("Sens", "Component"), translate("Sens", "Meaning"),
        ])  # fmt: skip
        tips = {
            FIRST: translate("Sens", "First-order index: the share of the variance that the error has by itself"),
            TOTAL: translate(
                "Sens", "Total index: the share of the variance with all interactions; they add to more than 1"
            ),
            SHARE: translate(
                "Sens",
                "What the error contributes to the variance, (S + Sᵀ)/2: the shares add to 100 %. "
                "Work on the largest first",
            ),
        }
        for column, tip in tips.items():
            self.table.headerItem().setToolTip(column, tip)
        self._delegate = BarDelegate()
        self.table.setItemDelegateForColumn(SHARE, self._delegate)
        self.table.setSortingEnabled(True)
        self.table.sortByColumn(RANK, Qt.AscendingOrder)
        self.table.itemSelectionChanged.connect(self._selected)
        # what an error is stands beside its index: readable without scrolling in a narrow dock
        self.table.header().moveSection(self.table.header().visualIndex(MEANING), 3)
        copyable(self.table, "ranking.csv")
        self.filter = QtGui.QLineEdit()
        self.filter.setObjectName("SensFilter")
        self.filter.setClearButtonEnabled(True)
        self.filter.setPlaceholderText(translate("Sens", "Show only: Z, squareness, Spindle …"))
        self.filter.setToolTip(translate("Sens", "Shows the errors whose name, component or meaning has these words"))
        self.filter.textChanged.connect(self._filter)
        layout.addWidget(self.filter)
        layout.addWidget(self.table)
        self._quiet = False
        self._sized: tuple = ()  # the rows that the columns were made to fit
        self._items, self._rows = {}, {}  # key of `_rows` -> the row in the table; what is written in its PLACES

    def show_result(self, machine, result) -> None:
        """Show the errors of a result, or none.  What differs is written into the rows that are there."""
        rows = _rows(machine, result) if result is not None else {}
        self._quiet = True
        if rows.keys() != self._rows.keys():
            self._make_rows(rows)
        else:
            self._update_rows(rows)
        self._rows = rows
        self._filter()
        self._quiet = False
        if result is not None and self._sized != tuple(rows):
            self._sized = tuple(rows)
            for column in range(MEANING + 1):
                self.table.resizeColumnToContents(column)
            self.table.setColumnWidth(SHARE, 104)
            self.table.setColumnWidth(RANK, 36)
            for column, most in WIDEST.items():
                self.table.setColumnWidth(column, min(most, self.table.columnWidth(column)))

    def _filter(self, *_) -> None:
        """Hide the rows that do not have every word of the filter in their name, component or meaning."""
        words = self.filter.text().casefold().split()
        for item in self.items():
            text = " ".join(item.text(c) for c in (ERROR, OWNER, MEANING)).casefold()
            item.setHidden(not all(word in text for word in words))

    def forget(self) -> None:
        """Take all rows away, and with them what was chosen."""
        self._quiet = True
        self._make_rows({})
        self._rows = {}
        self._quiet = False

    def _make_rows(self, rows) -> None:
        kept = {i.text(ERROR) for i in self.table.selectedItems()}
        self.table.setSortingEnabled(False)
        self.table.clear()
        self._items = {key: NumericItem(self.table) for key in rows}
        for key, item in self._items.items():
            for column in (TOTAL, FIRST, RANK, TOLERANCE):
                item.setTextAlignment(column, Qt.AlignRight | Qt.AlignVCenter)
            for place, value in zip(PLACES, rows[key]):
                _write(item, *place, value)
        self.table.setSortingEnabled(True)
        for item in self._items.values():
            item.setSelected(item.text(ERROR) in kept)

    def _update_rows(self, rows) -> None:
        written = set()
        model = self.table.model()
        model.blockSignals(True)  # the columns are sorted and painted once, not after each cell
        try:
            for key, row in rows.items():
                for place, value, shown in zip(PLACES, row, self._rows[key]):
                    if value != shown:
                        _write(self._items[key], *place, value)
                        written.add(place[0])
        finally:
            model.blockSignals(False)
        if self.table.sortColumn() in written:
            self.table.sortByColumn(self.table.sortColumn(), self.table.header().sortIndicatorOrder())
        view, header = self.table.viewport(), self.table.header()
        for column in written:
            view.update(header.sectionViewportPosition(column), 0, header.sectionSize(column), view.height())

    def items(self):
        """Return the rows of the table."""
        return [self.table.topLevelItem(i) for i in range(self.table.topLevelItemCount())]

    def bodies(self) -> list[str]:
        """Bodies of the chosen rows, each once."""
        return list(dict.fromkeys(i.data(OWNER, Qt.UserRole + 2) for i in self.table.selectedItems()))

    def _selected(self):
        if not self._quiet:
            self.chosen.emit(self.bodies())

    def choose_error(self, symbol: str) -> None:
        """Choose the rows of an error or effect, without emitting."""
        self._quiet = True
        self.table.clearSelection()
        mine = [item for (name, _), item in self._items.items() if name == symbol]
        for item in mine:
            item.setSelected(True)
        if mine:
            self.table.scrollToItem(mine[0])
        self._quiet = False

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
