# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that says before measuring what a plan will know: the standard uncertainty of every declared error, and
what one more tool length, run or sensor would buy.

The places come from a table, or are suggested; the study is `studies.plan`.
"""

from __future__ import annotations

import json
from pathlib import Path

from ..core.refusal import Refused
from ..formats import json_text, plan_html, plan_json, study_files, trace_json
from ..studies.plan import FEWEST, MOST, PlanRequest, plan_study
from . import messages
from .command import Command, Where, command
from .current import current_machine
from .panel import rows as form_rows
from .preferences import combo, number_box, read_field, write_field
from .qt import QT_TRANSLATE_NOOP, QtGui, translate
from .task_study import StudyPanel, add_row, fit_columns, opened, table
from .texts import error_meaning, unit_sign

CHANGES = ("tool", "run", "sensor")
SUGGEST, TABLE = "suggest", "table"
USUAL = 120  # places of a suggested plan


class TaskPlan(StudyPanel):
    """The panel; `path` is the table of places that was chosen, "" without one."""

    study, name, icon = "plan", "SensPlan", "Sens_Plan"
    guide = "8. Close the loop: readings in, the missing effect out"

    def headline(self) -> str:
        return translate("Sens", "Plan the measurement")

    # -- the form ----------------------------------------------------------------------------------------------------
    def asked(self):
        self.path = ""
        rows = form_rows()
        self.source = combo([
            (SUGGEST, translate("Sens", "suggested")), (TABLE, translate("Sens", "from a table")),
        ])  # fmt: skip
        self.source.setToolTip(translate("Sens", "The table has the columns of the readings, without readings"))
        self.count = QtGui.QSpinBox()
        self.count.setRange(FEWEST, MOST)
        self.count.setValue(USUAL)
        self.file = QtGui.QToolButton()
        self.file.setText(translate("Sens", "From file…"))
        self.file.clicked.connect(self.ask_file)
        row = QtGui.QHBoxLayout()
        row.addWidget(self.source, 1)
        row.addWidget(self.count)
        row.addWidget(self.file)
        rows.addRow(translate("Sens", "Places"), row)
        self.noise = number_box(0.001, 1000, 3, 0.1, " µm")
        self.noise.setValue(1.0)
        self.noise.setToolTip(translate("Sens", "Standard uncertainty of one reading"))
        rows.addRow(translate("Sens", "Noise"), self.noise)
        self.source.currentIndexChanged.connect(self._source_chosen)
        self.count.valueChanged.connect(self.forget)
        self.noise.valueChanged.connect(self.forget)
        self._fields()
        return rows

    def _fields(self) -> None:
        suggested = read_field(self.source) == SUGGEST
        self.count.setVisible(suggested)
        self.file.setVisible(not suggested)
        name = Path(self.path).name
        self.file.setText((name if len(name) < 22 else name[:20] + "…") or translate("Sens", "From file…"))
        self.file.setToolTip(self.path)

    def _source_chosen(self, *_) -> None:
        self._fields()
        self.forget()

    def tables(self):
        self.tabs = QtGui.QTabWidget()
        self.tabs.setObjectName("SensPlanTabs")
        heads = [
            translate("Sens", "Error"), translate("Sens", "u"), translate("Sens", "+ tool"),
            translate("Sens", "+ run"), translate("Sens", "+ sensor"), translate("Sens", "Meaning"),
        ]  # fmt: skip
        self.errors = table("SensPlanned", heads, "plan.csv")
        tips = (
            translate("Sens", "Standard uncertainty of the error's function, rms over the travel"),
            translate("Sens", "The same if every place is measured again with a tool of another length"),
            translate("Sens", "The same if every place is measured again in another run"),
            translate("Sens", "The same if every place is measured in the directions that the plan lacks"),
        )
        for column, tip in enumerate(tips, start=1):
            self.errors.headerItem().setToolTip(column, tip)
        heads = [translate("Sens", "What to do"), translate("Sens", "Now"), translate("Sens", "Then")]
        self.advice = table("SensAdvice", heads, "advice.csv")
        self.advice.setWordWrap(True)
        self.advice.setUniformRowHeights(False)
        self.tabs.addTab(self.errors, translate("Sens", "Uncertainties"))
        self.tabs.addTab(self.advice, translate("Sens", "Better"))
        return self.tabs

    # -- the study ---------------------------------------------------------------------------------------------------
    def settings(self) -> dict:
        return {
            "source": read_field(self.source), "positions": self.path, "suggest": self.count.value(),
            "noise_um": self.noise.value(),
        }  # fmt: skip

    def show_settings(self, settings: dict) -> None:
        self.path = str(settings.get("positions", ""))
        write_field(self.source, settings.get("source", SUGGEST))
        self.count.setValue(int(settings.get("suggest", USUAL)))
        self.noise.setValue(float(settings.get("noise_um", 1.0)))
        self._fields()

    def ask_file(self, *_) -> None:
        """Ask for a table of places."""
        path = messages.ask_open(translate("Sens", "Places of the plan"), "CSV (*.csv)")
        if path:
            self.load_places(path)

    def load_places(self, path) -> None:
        """Take the places of a table; a refusal is shown, and what was chosen before stays."""
        try:
            plan_json.load(path, self.noise.value(), None, self.core.joints)
        except Refused as error:
            messages.show(messages.words(error))
            return
        self.path = str(path)
        write_field(self.source, TABLE)
        self._fields()
        self.forget()

    def work(self):
        core, noise, count = self.core, self.noise.value(), self.count.value()
        readings = None
        if read_field(self.source) == TABLE:
            if not self.path:
                raise Refused("plan-missing", "plan")
            readings, count = plan_json.load(self.path, noise, None, core.joints), None
        request = PlanRequest(noise, count)

        def work(progress):
            found = plan_study(core, readings, request)
            found.errors  # noqa: B018 - computed here, where nobody waits for it
            return found

        return work, translate("Sens", "Looking at the plan")

    def plain(self, found) -> dict:
        return json.loads(json_text.dumps(plan_json.to_dict(found)))

    def files(self, found) -> dict:
        return study_files.plan_files(found, messages.language())

    # -- what was found ----------------------------------------------------------------------------------------------
    def clear(self) -> None:
        self.errors.clear()
        self.advice.clear()

    def fill(self, data: dict) -> None:
        known = {c.symbol: c for c in self.core.components}
        there = [c for c in CHANGES if data["errors"] and f"u_another_{c}" in data["errors"][0]]
        for entry in data["errors"]:
            unit = unit_sign(entry["unit"])
            numbers = [entry["u"], *(entry.get(f"u_another_{c}") for c in CHANGES)]
            texts = [self._number(v, unit) for v in numbers]
            values = {i: 1e9 if v is None else v for i, v in enumerate(numbers, start=1)}
            symbol = entry["symbol"]
            item = add_row(self.errors, (symbol, *texts, error_meaning(symbol, known)), values, symbol)
            for column, value in enumerate(numbers[1:], start=2):
                better = value is not None and (numbers[0] is None or value < 0.75 * numbers[0])
                font = item.font(column)
                font.setBold(better)
                item.setFont(column, font)
        for column, change in enumerate(CHANGES, start=2):
            self.errors.setColumnHidden(column, change not in there)
        fit_columns(self.errors, {0: 60, 5: 150})
        language = messages.language()
        for entry in data["advice"]:
            unit = unit_sign(entry["unit"])
            before, after = (plan_html.number_words(entry[k], unit, language) for k in ("before", "after"))
            words = [trace_json.text(entry, "do", language), trace_json.text(entry, "improves", language)]
            why = trace_json.text(entry, "why", language) if entry["why"] else ""
            add_row(
                self.advice, (words[0], before, after), key=words[0], tips={0: "\n".join(filter(None, [*words, why]))}
            )
        fit_columns(self.advice, {0: 220})
        self.tabs.setTabEnabled(1, bool(data["advice"]))

    def _number(self, value, unit: str) -> str:
        return translate("Sens", "not determined") if value is None else f"{value:.2g} {unit}"

    def invitation(self) -> str:
        return translate("Sens", "Says, before anything is measured, how well each declared error will be known.")

    def words(self, data: dict) -> str:
        n = data["numbers"]
        words = translate("Sens", "{places} places: {rank} of {parameters} parameters are determined.")
        lines = [words.format(places=n["places"], rank=n["rank"], parameters=n["parameters"])]
        if n["median_detectable_um"] is not None:
            words = translate("Sens", "An effect of {size} µm rms is found (median of those that could be).")
            lines.append(words.format(size=f"{n['median_detectable_um']:.2g}"))
        if data["advice"]:
            words = translate("Sens", "{n} changes would make the plan better.")
            lines.append(words.format(n=len(data["advice"])))
        return " ".join(lines)


def open_panel(machine) -> TaskPlan:
    """Open the panel for a machine."""
    return opened(TaskPlan(machine))


@command
class PlanMeasurement(Command):
    name = "Sens_Plan"
    menu_text = QT_TRANSLATE_NOOP("Sens_Plan", "Plan Measurement…")
    tip = QT_TRANSLATE_NOOP("Sens_Plan", "Says how well each declared error will be known, before anything is measured")
    guide = TaskPlan.guide
    where = Where("loop", 5, tree=("Machine",))

    def run(self):
        open_panel(current_machine())
