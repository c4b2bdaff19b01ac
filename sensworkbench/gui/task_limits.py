# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that says how large the error may become: quantiles, P(|error| > limit), V_XYZ and the diagonals.

Everything comes from the study `studies.limits`; a limit that is typed passes or fails every figure.
"""

from __future__ import annotations

import FreeCAD as App

from ..core.refusal import Refused
from ..document import refresh, tree
from ..formats import limits_json
from ..formats.words import Words, position_text
from ..studies.limits import diagonals, limits_study
from . import messages, pointers, state
from .arrows import Arrow
from .command import Command, Where, command
from .current import current_machine
from .panel import rows as form_rows
from .preferences import number_box
from .qt import QT_TRANSLATE_NOOP, QtGui, translate
from .task_study import KEY, StudyPanel, add_row, fit_columns, opened, table, with_bars
from .texts import body_name, error_unit, fixed, meaning

FIGURE, LEVEL, JUDGED, HALF = range(4)  # columns of the first table
NAME, PART, MEANING = range(3)  # columns of the second one
QUANTILE, WORST = "quantile", "worst"  # keys of rows; the others are the names of figures
PASSES, FAILS, PLACE_COLOUR = "#3f7d3a", "#c0392b", (0.75, 0.22, 0.17)
BAR_COLOUR = (0.13, 0.57, 0.55)


class TaskLimits(StudyPanel):
    """The panel."""

    study, name, icon, guide = "limits", "SensLimits", "Sens_Limits", "4. What if"

    def headline(self) -> str:
        return translate("Sens", "Limits of the error")

    # -- the form ----------------------------------------------------------------------------------------------------
    def asked(self):
        self.unit, self.um = error_unit()
        rows = form_rows()
        self.level = number_box(1, 99.99, 2, 1, " %")
        self.level.setValue(95)
        self.level.setKeyboardTracking(False)
        self.level.setToolTip(translate("Sens", "The part of all errors, or of all machines, that is below a figure"))
        self.level.valueChanged.connect(self.forget)
        self.allowed = number_box(0, 1e6, 1, 1.0, f" {self.unit}")
        self.allowed.setSpecialValueText("–")
        self.allowed.setKeyboardTracking(False)
        self.allowed.setToolTip(translate("Sens", "The largest error that is allowed; each figure passes or fails it"))
        self.allowed.valueChanged.connect(self.forget)
        rows.addRow(translate("Sens", "Probability"), self.level)
        rows.addRow(translate("Sens", "Allowed"), self.allowed)
        return rows

    def tables(self):
        self.tabs = QtGui.QTabWidget()
        self.tabs.setObjectName("SensLimitsTabs")
        heads = [translate("Sens", "Figure"), "", translate("Sens", "Judged"), ""]
        self.figures = table("SensFigures", heads, "limits.csv", self.point)
        heads = [translate("Sens", "Error"), translate("Sens", "Contribution"), translate("Sens", "Meaning")]
        self.makers = table("SensMakers", heads, "contributions.csv", self.point)
        with_bars(self.makers, PART)
        self.tabs.addTab(self.figures, translate("Sens", "Figures"))
        self.tabs.addTab(self.makers, translate("Sens", "What makes it large"))
        self.tabs.currentChanged.connect(self.point)
        return self.tabs

    # -- the study ---------------------------------------------------------------------------------------------------
    def settings(self) -> dict:
        limit = self.allowed.value() * self.um
        return {"level": self.level.value() / 100, "limit_um": limit if limit > 0 else None}

    def show_settings(self, settings: dict) -> None:
        self.level.setValue(100 * settings["level"])
        self.allowed.setValue((settings["limit_um"] or 0.0) / self.um)

    def work(self):
        core, asked = self.core, self.settings()
        allowed = () if asked["limit_um"] is None else (asked["limit_um"],)
        words = translate("Sens", "Errors of random machines")
        return (lambda progress: limits_study(core, asked["level"], allowed, progress)), words

    def plain(self, found) -> dict:
        return limits_json.to_dict(found)

    def files(self, found) -> dict:
        return limits_json.files(found, messages.language())

    # -- what was found ----------------------------------------------------------------------------------------------
    def clear(self) -> None:
        self.figures.clear()
        self.makers.clear()

    def fill(self, data: dict) -> None:
        level = f"{100 * data['level']:g} %"
        self.figures.headerItem().setText(LEVEL, f"{level}, {self.unit}")
        self.figures.headerItem().setText(HALF, f"{translate('Sens', 'Median')}, {self.unit}")
        tip = translate("Sens", "At a random place of the workspace of a random machine within the tolerances")
        self._figure(translate("Sens", "All errors"), QUANTILE, None, data["quantile_um"], tip)
        self._figure(translate("Sens", "Worst place"), WORST, None, data["worst"]["quantile_um"], self._place(data))
        for figure in data["figures"]:
            self._figure(figure["name"], figure["name"], figure["median_um"], figure["quantile_um"],
                         figure_words(figure["name"]))  # fmt: skip
        largest = max((c["contribution"] for c in data["components"]), default=1.0)
        for row in data["components"]:
            name = body_name(self.machine, row["body"])
            add_row(self.makers, (name, "", translate("Sens", "Component")), {PART: row["contribution"]}, row["body"],
                    bold=True, bar=(PART, row["contribution"], largest, BAR_COLOUR))  # fmt: skip
        known = {c.symbol: c for c in self.core.components}
        for row in data["errors"]:
            symbol, value = row["symbol"], row["contribution"]
            if value > 5e-4:
                owner = known[symbol].body if symbol in known else ""
                words = meaning(self.machine, symbol, known) if symbol in known else symbol
                add_row(self.makers, (symbol, "", words), {PART: value}, owner,
                        bar=(PART, value, largest, BAR_COLOUR))  # fmt: skip
        fit_columns(self.figures, {FIGURE: 130})
        fit_columns(self.makers, {NAME: 110, MEANING: 160})
        self.makers.setColumnWidth(PART, 140)

    def _figure(self, name, key, median, value, tip) -> None:
        limit = self.allowed.value() * self.um
        judged, colour = "", None
        if limit > 0:
            judged = translate("Sens", "passes") if value <= limit else translate("Sens", "fails")
            colour = PASSES if value <= limit else FAILS
        texts = (name, self._size(value), judged, "" if median is None else self._size(median))
        values = {LEVEL: value} | ({} if median is None else {HALF: median})
        item = add_row(self.figures, texts, values, key, bold=key in (QUANTILE, WORST, "V_XYZ", "E_D"),
                       tips={FIGURE: f"{name}: {tip}"})  # fmt: skip
        if colour:
            item.setForeground(JUDGED, QtGui.QBrush(QtGui.QColor(colour)))

    def _size(self, um: float) -> str:
        """An error in the unit of the panel, without it."""
        return fixed(um / self.um, 1 if self.um == 1 else 0)

    def _place(self, data: dict) -> str:
        return position_text(self.core.joints, data["worst"]["at"])

    def invitation(self) -> str:
        return translate(
            "Sens", "Says how large the error of a machine within these tolerances may become, how often it exceeds a "
            "limit, and what makes it large."
        )  # fmt: skip

    def words(self, data: dict) -> str:
        size = f"{self._size(data['quantile_um'])} {self.unit}"
        words = translate(
            "Sens", "{level} % of all errors are below <b>{size}</b>; at the worst place ({place}) {worst}."
        )
        worst = f"{self._size(data['worst']['quantile_um'])} {self.unit}"
        lines = [words.format(level=f"{100 * data['level']:g}", size=size, place=self._place(data), worst=worst)]
        for beyond in data["beyond"]:
            words = translate("Sens", "{part} % ± {error} of all errors exceed {limit}: the {level} % error {judged}.")
            good = data["quantile_um"] <= beyond["limit_um"]
            judged = translate("Sens", "passes") if good else translate("Sens", "fails")
            judged = f"<b style='color:{PASSES if good else FAILS}'>{judged}</b>"
            lines.append(words.format(
                part=f"{100 * beyond['probability']:.3g}", error=f"{100 * beyond['error']:.1g}", judged=judged,
                limit=f"{beyond['limit_um'] / self.um:g} {self.unit}", level=f"{100 * data['level']:g}",
            ))  # fmt: skip
        code = "limits-computed" if data["method"] == "computed" else "limits-sampled"
        lines.append(f"<i>{Words(messages.language())(code, error=data['quantile_error_um'])}</i>")
        return " ".join(lines)

    # -- the view ----------------------------------------------------------------------------------------------------
    def point(self, *_) -> None:
        """Draw the worst place, the diagonal of the chosen row, or what the chosen error or component points at."""
        proxy = self.machine.ViewObject.Proxy
        if not hasattr(proxy, "arrows"):
            return
        sizes = state.of(self.document).sizes
        size = sizes.setdefault(self.machine.Name, pointers.extent(self.machine))
        items = self.tabs.currentWidget().selectedItems()
        key = items[0].data(0, KEY) if items else None
        arrows = []
        if self.data is not None and self.tabs.currentWidget() is self.makers:
            bodies = [key] if key and tree.body_of(self.machine, key) is not None else []
            arrows = pointers.arrows(self.machine, bodies)
        elif self.data is not None:
            arrows = self._place_arrows(key)
        proxy.arrows.show(arrows, size)

    def _place_arrows(self, key) -> list[Arrow]:
        """The diagonal of a figure, or the worst place."""
        core = self.core
        lines = list(diagonals(core))
        if key in (f"D{i}" for i in range(1, len(lines) + 1)):
            ends = self._tool(lines[int(key[1:]) - 1])
            return [Arrow(*ends, PLACE_COLOUR, f"{key}: {self._shown(key)}", 0.5)]
        if key in (None, WORST, QUANTILE):
            at = [j.from_shown(v) for j, v in zip(core.joints, self.data["worst"]["at"])]
            (place,) = self._tool([at])
            words = (
                translate("Sens", "Worst place: {size}").format(size=self._shown(WORST)) + "\n" + self._place(self.data)
            )
            return [Arrow(place, place, PLACE_COLOUR, words, below=True)]
        return []

    def _tool(self, q) -> list[tuple]:
        """Places of the tool point over the workpiece where it is now, at positions q of the joints."""
        try:
            displaced = refresh.latest(self.machine).displacements["W"]
        except Refused:
            return []
        return [tuple(displaced.multVec(App.Vector(*p))) for p in self.core.tool_position(q).tolist()]

    def _shown(self, key: str) -> str:
        figures = {f["name"]: f["quantile_um"] for f in self.data["figures"]}
        value = self.data["worst"]["quantile_um"] if key == WORST else figures[key]
        return f"{self._size(value)} {self.unit}"


def figure_words(name: str) -> str:
    """What a figure of a measured machine is."""
    known = {
        "V_XYZ": translate("Sens", "the largest of V_X, V_Y and V_Z (ISO 230-1)"),
        "E_D": translate("Sens", "the largest of the diagonal deviations (ISO 230-6)"),
    }
    if name in known:
        return known[name]
    if name.startswith("V_"):
        words = translate("Sens", "range over the workspace of the error along {axis} (ISO 230-1)")
        return words.format(axis=name[2:])
    return translate("Sens", "range of the deviation along this body diagonal (ISO 230-6); click to see it")


def open_panel(machine) -> TaskLimits:
    """Open the panel for a machine."""
    return opened(TaskLimits(machine))


@command
class Limits(Command):
    name = "Sens_Limits"
    study = "limits"
    keys = "Y, L"
    menu_text = QT_TRANSLATE_NOOP("Sens_Limits", "Limits of the Error…")
    tip = QT_TRANSLATE_NOOP("Sens_Limits", "Says how large the error may become, and how often it exceeds a limit")
    guide = TaskLimits.guide
    where = Where("analysis", 64, tree=("Machine",))

    def run(self):
        open_panel(current_machine())
