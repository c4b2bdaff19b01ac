# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that says where a scale, a guide or the tool should be: what a millimetre is worth, and the best places.

Derivatives, best places within a box and orders of the axes come from the study `studies.moves`.  The document changes
only with Apply, which moves the reference point of an axis; what the document takes from a part stays, and is said.
"""

from __future__ import annotations

from pathlib import Path

import FreeCAD as App
import numpy as np

from ..document import tree
from ..formats import moves_json
from ..studies.moves import TOOL, moves_study
from . import display, messages, move_arrows, pointers, state
from .command import Command, Where, command
from .current import current_machine
from .move_arrows import BODIES, point_name
from .panel import rows as form_rows
from .preferences import number_box
from .prices import Prices
from .qt import QT_TRANSLATE_NOOP, QtGui, translate
from .task_study import KEY, StudyPanel, add_row, fit_columns, opened, table
from .texts import fixed, length, length_unit

WHAT, WAY, PERCENT, UM, WORTH = range(5)  # columns of the first table
ALL = "*"  # the row of all points together


class TaskMoves(Prices, StudyPanel):
    """The panel; `costs` are the prices of a file, None without one."""

    study, name, icon, guide = "moves", "SensMoves", "Sens_Moves", "4. What if"

    def headline(self) -> str:
        return translate("Sens", "Where to move")

    # -- the form ----------------------------------------------------------------------------------------------------
    def asked(self):
        self.costs, self.undo_name = None, ""
        unit, self.mm = length_unit()
        rows, row = form_rows(), QtGui.QHBoxLayout()
        self.sides = [number_box(0, 1e5, 1 if unit == "mm" else 3, 10 if unit == "mm" else 0.5) for _ in range(3)]
        for letter, box in zip("xyz", self.sides):
            box.setPrefix(f"{letter} ± ")
            box.setValue(50.0 / self.mm if unit == "mm" else 2.0)
            box.setButtonSymbols(QtGui.QAbstractSpinBox.NoButtons)
            box.setKeyboardTracking(False)
            box.setToolTip(translate("Sens", "How far a point may be moved from where it is; the view shows this box"))
            box.valueChanged.connect(self.forget)
            row.addWidget(box, 1)
        row.addWidget(QtGui.QLabel(unit))
        rows.addRow(translate("Sens", "Room"), row)
        self.prices = QtGui.QLabel(translate("Sens", "none: moves are shown without their worth"))
        self.prices.setWordWrap(True)
        load = QtGui.QToolButton()
        load.setText(translate("Sens", "From file…"))
        load.setToolTip(translate("Sens", "Reads prices: symbol, kind, c, k, lower, upper, or grades (see Allocation)"))
        load.clicked.connect(self.ask_costs)
        row = QtGui.QHBoxLayout()
        row.addWidget(self.prices, 1)
        row.addWidget(load)
        rows.addRow(translate("Sens", "Cost"), row)
        return rows

    def tables(self):
        self.tabs = QtGui.QTabWidget()
        self.tabs.setObjectName("SensMovesTabs")
        unit = length_unit()[0]
        heads = [translate("Sens", "Point"), translate("Sens", "To"), f"%/{unit}", f"µm/{unit}",
                 f"{translate('Sens', 'Cost')}/{unit}"]  # fmt: skip
        self.slopes = table("SensSlopes", heads, "moves.csv", self._chosen, PERCENT)
        heads = [translate("Sens", "Point"), "x", "y", "z", translate("Sens", "rms, µm"), translate("Sens", "Change")]
        self.best = table("SensBest", heads, "best-places.csv", self._chosen)
        heads = [translate("Sens", "Structure"), translate("Sens", "rms, µm"), translate("Sens", "Change")]
        self.orders = table("SensOrders", heads, "orders.csv", self._chosen)
        for view, title in (
            (self.slopes, translate("Sens", "One millimetre") if unit == "mm" else translate("Sens", "One inch")),
            (self.best, translate("Sens", "Best places")), (self.orders, translate("Sens", "Order of the axes")),
        ):  # fmt: skip
            self.tabs.addTab(view, title)
        self.tabs.currentChanged.connect(self._chosen)
        return self.tabs

    def buttons(self):
        return [
            (translate("Sens", "Apply"), translate("Sens", "Moves the chosen reference points, one undo step"),
             self.apply, "apply_button"),
            (translate("Sens", "Undo"), translate("Sens", "Puts the reference points back"), self.undo, "undo_button"),
        ]  # fmt: skip

    # -- the study ---------------------------------------------------------------------------------------------------
    def room(self) -> list[float]:
        """Half sides of the box, mm."""
        return [box.value() * self.mm for box in self.sides]

    def settings(self) -> dict:
        return {"within_mm": self.room(), "costs": self.costs_path}

    def show_settings(self, settings: dict) -> None:
        for box, value in zip(self.sides, settings.get("within_mm", [])):
            box.setValue(value / self.mm)
        path = settings.get("costs")
        if path and Path(path).is_file():
            self.load_costs(path)

    def work(self):
        core, room, costs = self.core, self.room(), self.costs
        return (lambda progress: moves_study(core, room, costs, progress)), translate("Sens", "Moving every point")

    def plain(self, found) -> dict:
        return moves_json.to_dict(found)

    def files(self, found) -> dict:
        return moves_json.files(found, messages.language())

    # -- what was found ----------------------------------------------------------------------------------------------
    def clear(self) -> None:
        for view in (self.slopes, self.best, self.orders):
            view.clear()

    def fill(self, data: dict) -> None:
        self._fill_slopes(data)
        before = data["mean_square_um2"]
        for point in sorted(data["points"], key=lambda p: p["best_rms_um"]):
            self._best_row(point_name(self.machine, point["name"]), point["name"], point["best_move_mm"],
                           point["best_rms_um"], before)  # fmt: skip
        together = data["together"]
        words = translate("Sens", "All but the tool")
        self._best_row(words, ALL, None, together["rms_um"], before)
        now = data["machine"]["structure"]
        for order in data["orders"]:
            change = 100 * (order["rms_um"] ** 2 / before - 1)
            texts = (order["structure"], f"{order['rms_um']:.2f}", f"{_tidy(change, 1)} %")
            add_row(self.orders, texts, {1: order["rms_um"], 2: change}, order["structure"],
                    bold=order["structure"] == now)  # fmt: skip
        for view in (self.slopes, self.best, self.orders):
            fit_columns(view, {0: 132})
        self.tabs.setTabEnabled(2, bool(data["orders"]))

    def _fill_slopes(self, data: dict) -> None:
        rms = data["rms_um"]
        self.slopes.setSortingEnabled(False)
        for point in data["points"]:
            for i, letter in enumerate("xyz"):
                slope = point["per_mm"][letter]
                worth = point["worth_per_mm"][i] if "worth_per_mm" in point else None
                way = "−" if slope["percent"] > 0 else "+"
                self._slope_row(point_name(self.machine, point["name"]), f"{way}{letter}", slope, rms, worth,
                                (point["name"], letter))  # fmt: skip
        for entry in data["travel"]:
            for end, words in (
                ("low", translate("Sens", "{name}, lower end")),
                ("high", translate("Sens", "{name}, upper end")),
            ):
                slope = entry[end]
                way = "−" if slope["percent"] > 0 else "+"
                name = words.format(name=point_name(self.machine, entry["joint"]))
                self._slope_row(name, way, slope, rms, None, (entry["joint"], ""))
        self.slopes.setSortingEnabled(True)
        self.slopes.setColumnHidden(WORTH, data["tolerance"] is None)

    def _slope_row(self, name, way, slope, rms, worth, key) -> None:
        """One row: what a move by one unit of length towards `way` saves."""
        percent = -abs(slope["percent"]) * self.mm
        um = -abs(slope["mean_square_um2"]) / (2 * rms) * self.mm
        still = abs(percent) < 5e-7
        texts = [name, "–" if still else way, _tidy(percent, 3), _tidy(um, 4), ""]
        values = {PERCENT: abs(percent), UM: abs(um)}
        if worth is not None:
            texts[WORTH], values[WORTH] = f"{worth * self.mm:.3g}", worth
        add_row(self.slopes, texts, values, key)

    def _best_row(self, name, key, move, rms, before) -> None:
        change = 100 * (rms**2 / before - 1)
        digits = 0 if self.mm == 1 else 2
        shifts = ["", "", ""] if move is None else [_tidy(v / self.mm, digits, plus=True) for v in move]
        values = {4: rms, 5: change} | ({} if move is None else {i + 1: v for i, v in enumerate(move)})
        item = add_row(self.best, (name, *shifts, f"{rms:.2f}", f"{_tidy(change, 1)} %"), values, key,
                       bold=key == ALL)  # fmt: skip
        if key == ALL:
            item.setToolTip(0, translate("Sens", "Every point at its best place when all of them move; click to see"))

    def invitation(self) -> str:
        return translate(
            "Sens", "Says what a move of each scale, guide block and of the tool by one millimetre is worth, "
            "and where each is best within the room."
        )  # fmt: skip

    def words(self, data: dict) -> str:
        best = min(data["points"], key=lambda p: p["best_rms_um"] if p["name"] != TOOL else np.inf)
        words = translate("Sens", "rms {now} µm; best single move: {name}, {then} µm; all but the tool: {all} µm.")
        text = words.format(now=f"{data['rms_um']:.3g}", name=point_name(self.machine, best["name"]),
                            then=f"{best['best_rms_um']:.3g}", all=f"{data['together']['rms_um']:.3g}")  # fmt: skip
        step = data["tolerance"]
        if step is not None:
            words = translate("Sens", "The same would cost least at the tolerance of {symbol}: {price} per µm².")
            text += " " + words.format(symbol=step["symbol"], price=f"{step['cost_per_um2']:.3g}")
        return text

    # -- the view ----------------------------------------------------------------------------------------------------
    def chosen_key(self):
        """What the selected row of the table in front is about, or None."""
        items = self.tabs.currentWidget().selectedItems()
        return items[0].data(0, KEY) if items else None

    def moves(self) -> dict:
        """name of a point -> (3,) mm, as chosen under Best places: one point, or all but the tool."""
        key = self.chosen_key()
        if self.data is None or self.tabs.currentWidget() is not self.best or key is None:
            return {}
        if key == ALL:
            return dict(self.data["together"]["moves_mm"])
        return {p["name"]: p["best_move_mm"] for p in self.data["points"] if p["name"] == key}

    def _chosen(self, *_) -> None:
        self.enable()
        self.point()

    def point(self) -> None:
        """Arrows of the chosen row, or of all points; the box of the points whose best place is shown."""
        proxy = self.machine.ViewObject.Proxy
        if not hasattr(proxy, "arrows"):
            return
        sizes = state.of(self.document).sizes
        size = sizes.setdefault(self.machine.Name, pointers.extent(self.machine))
        key, front, lines = self.chosen_key(), self.tabs.currentWidget(), []
        if self.data is None:
            found = []
        elif front is self.best and key is not None:
            moves = self.moves()
            found = move_arrows.move_arrows(self.machine, moves, length)
            lines = move_arrows.box_lines(self.machine, moves, self.room())
        elif front is self.slopes and key is not None and not key[1]:
            found = pointers.arrows(self.machine, [key[0]])
        else:
            only = key if front is self.slopes and key is not None else ("", "")
            found = move_arrows.gradient_arrows(self.machine, self.data["points"], size, *only)
        proxy.arrows.show(found, size)
        proxy.arrows.outline(lines)

    # -- the document ------------------------------------------------------------------------------------------------
    def enable(self) -> None:
        self.apply_button.setEnabled(self.data is not None and self.chosen_key() is not None)
        self.undo_button.setEnabled(self._applied())

    def _applied(self) -> bool:
        """Whether the last step of the document is that of Apply."""
        names = self.document.UndoNames
        return bool(self.undo_name) and bool(names) and names[0] == self.undo_name

    def apply(self, *_) -> None:
        """Move the reference points of the chosen row: one undo step; or say why the document cannot hold it."""
        why = self._cannot()
        if why:
            messages.show(why)
            return
        machine, frame = self.machine, np.array(self.core.frame)
        moves = {n: v for n, v in self.moves().items() if n not in BODIES}
        name = translate("Sens", "Move reference points")

        def change():
            for axis, move in moves.items():
                tree.axis_of(machine, axis).ReferenceOffset += App.Vector(*(frame.T @ np.array(move)).tolist())
            machine.touch()
            self.document.recompute()
            result = tree.sensitivity_of(machine)
            if result is not None and result.Coloured:
                display.compute_and_colour(machine)

        if self.change(name, change):
            self.undo_name = name
            self.recall()
            left = [point_name(machine, n) for n in self.moves() if n in BODIES]
            said = translate("Sens", "The reference points are moved; Undo puts them back")
            if left:
                said += ". " + translate("Sens", "Not moved, because it belongs to a part: {names}")
                said = said.format(names=", ".join(left))
            messages.status(said)
        self.enable()

    def _cannot(self) -> str:
        """Why the chosen row cannot be applied; "" where it can."""
        front = self.tabs.currentWidget()
        if front is self.orders:
            return translate(
                "Sens", "The order of the axes is how the parts carry each other: rebuild the parts, then choose the "
                "structure in Edit Machine."
            )  # fmt: skip
        if front is self.slopes:
            return translate("Sens", "Choose a row under Best places: a slope says which way, not how far.")
        moves = self.moves()
        if all(n in BODIES for n in moves):
            return translate(
                "Sens", "The document takes this point from a part. Move the part, or choose another point in Edit "
                "Machine; the results follow."
            )  # fmt: skip
        if not any(np.any(v) for n, v in moves.items() if n not in BODIES):
            return translate("Sens", "This point is at its best place already.")
        return ""

    def undo(self, *_) -> None:
        """Take the step of Apply back."""
        if self._applied():
            self.document.undo()
            self.document.recompute()
            self.look_again()
            self.recall()
        self.enable()


def _tidy(value: float, digits: int, plus: bool = False) -> str:
    """A number with so many decimals, a minus sign in place of a hyphen, and with `plus` a plus sign."""
    text = fixed(value, digits)
    if plus and float(text) > 0:
        text = f"+{text}"
    return text.replace("-", "−")


def open_panel(machine) -> TaskMoves:
    """Open the panel for a machine."""
    return opened(TaskMoves(machine))


@command
class Moves(Command):
    name = "Sens_Moves"
    study = "moves"
    keys = "Y, W"
    menu_text = QT_TRANSLATE_NOOP("Sens_Moves", "Where to Move…")
    tip = QT_TRANSLATE_NOOP("Sens_Moves", "Says what moving a scale, guide block or the tool by a millimetre is worth")
    guide = TaskMoves.guide
    where = Where("analysis", 62, tree=("Machine",))

    def run(self):
        open_panel(current_machine())
