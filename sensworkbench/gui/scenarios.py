# SPDX-License-Identifier: LGPL-2.1-or-later
"""What-if scenarios that are kept beside each other: a list under the what-if table, as long as the document is open.

A row says what the scenario makes of the error; choosing it puts its changes back into the what-if page.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from .copying import copyable
from .qt import Qt, QtGui, Signal, translate


@dataclass(frozen=True)
class Scenario:
    """changes : symbol -> factor of its tolerance.  moved : axis -> shift of its scale, mm.  weights : of the
    objective.  size, unit : its error.  words : its changes in words."""

    changes: dict[str, float] = field(default_factory=dict)
    moved: dict[str, tuple[float, float, float]] = field(default_factory=dict)
    weights: tuple[float, float, float] = (1.0, 1.0, 1.0)
    size: float = 0.0
    unit: str = "µm"
    words: str = ""


class ScenarioList(QtGui.QTreeWidget):
    """The list.  `asked` is emitted with the scenario of a row that is double-clicked, or on which Enter is pressed."""

    asked = Signal(object)

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setObjectName("SensScenarios")
        self.setRootIsDecorated(False)
        self.setAlternatingRowColors(True)
        self.setHeaderLabels([translate("Sens", "Kept"), translate("Sens", "Error"), "", translate("Sens", "Changes")])
        self.setToolTip(translate("Sens", "Double click: try it again. Delete: remove it from the list"))
        self.setMaximumHeight(118)
        self.itemActivated.connect(lambda item, _column: self.asked.emit(item.data(0, Qt.UserRole)))
        copyable(self, "scenarios.csv")
        self.kept: list[Scenario] = []
        self.setVisible(False)

    def show_scenarios(self, kept: list[Scenario], allowed: float = 0.0) -> None:
        """Show the scenarios of a machine (the list itself: what is removed here is removed there).

        allowed : greatest error in µm, 0 for none.
        """
        self.kept = kept
        self.clear()
        for number, one in enumerate(kept):
            verdict = ""
            if allowed > 0 and one.unit == "µm":
                verdict = translate("Sens", "passes") if one.size <= allowed else translate("Sens", "fails")
            item = QtGui.QTreeWidgetItem(self, [letter(number), f"{one.size:.3g} {one.unit}", verdict, one.words])
            item.setData(0, Qt.UserRole, one)
            item.setTextAlignment(1, Qt.AlignRight | Qt.AlignVCenter)
            item.setToolTip(3, one.words)
        for column in range(3):
            self.resizeColumnToContents(column)
        self.setVisible(bool(kept))

    def keyPressEvent(self, event):
        if event.key() == Qt.Key_Delete and self.selectedIndexes():
            for row in sorted({i.row() for i in self.selectedIndexes()}, reverse=True):
                del self.kept[row]
                self.takeTopLevelItem(row)
            self.setVisible(bool(self.kept))
            return
        super().keyPressEvent(event)


def letter(number: int) -> str:
    """A, B, … Z, A2, B2 … of the first, second … scenario."""
    return "ABCDEFGHIJKLMNOPQRSTUVWXYZ"[number % 26] + ("" if number < 26 else str(number // 26 + 1))
