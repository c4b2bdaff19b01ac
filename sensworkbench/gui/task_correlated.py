# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of tolerances that vary together: sources that several errors follow, and shares for a covariance.

A source is declared, changed or removed as one undo step; its share stands in the ranking.  A covariance is read from a
file, or is that of the machine's fit: its shares say which further measurement helps most (`studies.correlated`).
"""

from __future__ import annotations

import hashlib
from dataclasses import replace
from pathlib import Path

from ..core.distributions import DISTRIBUTIONS, Tolerance
from ..core.refusal import Refused
from ..core.sources import Source
from ..core.units import parse
from ..document import closed_loop, refresh, sources, tree
from ..formats import correlated_files
from ..studies.correlated import correlated_study
from . import display, messages, pointers
from .command import Command, Where, command
from .current import current_machine
from .panel import rows as form_rows
from .preferences import combo, read_field, write_field
from .qt import QT_TRANSLATE_NOOP, Qt, QtGui, translate
from .task_study import KEY, StudyPanel, add_row, fit_columns, opened, table, with_bars
from .texts import body_name, distribution_name, error_meaning, plain, unit_sign

NAME, LAW, FOLLOW, SHARE = range(4)  # columns of the table of sources
ERROR, FACTOR, MEANING = range(3)  # of the table of factors
PART = 1  # column of the shares of a covariance
BAR_COLOUR = (0.13, 0.57, 0.55)


class TaskCorrelated(StudyPanel):
    """The panel; `covariance` is what was read from a file, None for that of the fit."""

    study, name, icon, guide = "correlated", "SensCorrelated", "Sens_Correlated", "2. Tolerances"

    def headline(self) -> str:
        return translate("Sens", "Correlated tolerances")

    # -- the form ----------------------------------------------------------------------------------------------------
    def asked(self):
        self.covariance, self.path, self.edited = None, "", ""
        return QtGui.QVBoxLayout()  # what is asked stands in the tabs

    def tables(self):
        self.tabs = QtGui.QTabWidget()
        self.tabs.setObjectName("SensCorrelatedTabs")
        self.tabs.addTab(self._sources_page(), translate("Sens", "Sources"))
        self.tabs.addTab(self._covariance_page(), translate("Sens", "Covariance"))
        self.tabs.currentChanged.connect(self._turned)
        return self.tabs

    def _sources_page(self):
        page = QtGui.QWidget()
        column = QtGui.QVBoxLayout(page)
        column.setContentsMargins(4, 6, 4, 4)
        heads = [translate("Sens", "Source"), translate("Sens", "Law"), translate("Sens", "Errors"),
                 translate("Sens", "Share")]  # fmt: skip
        self.list = table("SensSources", heads, "sources.csv", self._chosen)
        self.list.setFixedHeight(84)
        column.addWidget(self.list)
        rows, row = form_rows(), QtGui.QHBoxLayout()
        self.title = QtGui.QLineEdit()
        self.title.setPlaceholderText(translate("Sens", "such as rail of Y"))
        rows.addRow(translate("Sens", "Name"), self.title)
        self.law = combo([(d, distribution_name(d)) for d in DISTRIBUTIONS if d != "point"])
        self.ends = [QtGui.QLineEdit("-1"), QtGui.QLineEdit("1")]
        row.addWidget(self.law, 2)
        for box, words in zip(self.ends, (translate("Sens", "from"), translate("Sens", "to"))):
            box.setMinimumWidth(36)
            box.setToolTip(translate("Sens", "Limits of the source, a pure number; each error is its factor times it"))
            row.addWidget(QtGui.QLabel(words))
            row.addWidget(box, 1)
        rows.addRow(translate("Sens", "Law"), row)
        column.addLayout(rows)
        heads = [translate("Sens", "Error"), translate("Sens", "Factor"), translate("Sens", "Meaning")]
        self.factors = table("SensFactors", heads, "factors.csv", self.point)
        self.factors.setToolTip(
            translate("Sens", "Tick the errors that follow the source; double click a factor to change it")
        )
        self.factors.itemChanged.connect(self._ticked)
        self.factors.itemDoubleClicked.connect(lambda item, _column: self.factors.editItem(item, FACTOR))
        self.factors.setEditTriggers(QtGui.QAbstractItemView.NoEditTriggers)
        column.addWidget(self.factors, 1)
        self.own = QtGui.QCheckBox(translate("Sens", "Each error keeps its own tolerance besides"))
        self.own.setToolTip(translate("Sens", "Otherwise the source takes the place of the tolerances of its errors"))
        column.addWidget(self.own)
        row = QtGui.QHBoxLayout()
        for text, tip, run, attribute in (
            (translate("Sens", "New"), translate("Sens", "Empties the fields for another source"),
             self.new, "new_button"),
            (translate("Sens", "Declare"), translate("Sens", "Lets the errors follow the source, one undo step"),
             self.declare, "declare_button"),
            (translate("Sens", "Remove"), translate("Sens", "Takes the source away, one undo step; its errors get "
             "tolerances of the same width"), self.remove, "remove_button"),
        ):  # fmt: skip
            button = QtGui.QPushButton(text)
            button.setToolTip(tip)
            button.clicked.connect(run)
            setattr(self, attribute, button)
            row.addWidget(button)
        column.addLayout(row)
        return page

    def _covariance_page(self):
        page = QtGui.QWidget()
        column = QtGui.QVBoxLayout(page)
        column.setContentsMargins(4, 6, 4, 4)
        row = QtGui.QHBoxLayout()
        self.given = QtGui.QLabel()
        self.given.setWordWrap(True)
        load = QtGui.QToolButton()
        load.setText(translate("Sens", "From file…"))
        load.setToolTip(
            translate("Sens", "Reads a covariance: names of errors in the first row and column, µm and µrad")
        )
        load.clicked.connect(self.ask_covariance)
        self.fit_button = QtGui.QToolButton()
        self.fit_button.setText(translate("Sens", "Of the fit"))
        self.fit_button.setToolTip(translate("Sens", "Takes what the last fit leaves uncertain"))
        self.fit_button.clicked.connect(self.of_fit)
        for widget, stretch in ((self.given, 1), (load, 0), (self.fit_button, 0)):
            row.addWidget(widget, stretch)
        column.addLayout(row)
        heads = [translate("Sens", "What"), translate("Sens", "Share"), "S", "Sᵀ"]
        self.shares = table("SensShares", heads, "correlated.csv", self.point)
        with_bars(self.shares, PART)
        column.addWidget(self.shares, 1)
        return page

    def _turned(self, *_) -> None:
        self._say()
        self._enable()

    # -- sources -----------------------------------------------------------------------------------------------------
    def recall(self) -> None:
        self._list_sources()
        self._say_given()
        super().recall()

    def _list_sources(self) -> None:
        """The declared sources with their shares; the fields show the one that is edited."""
        self.quiet = True
        result = tree.sensitivity_of(self.machine)
        shares = {}
        if result is not None and not result.Stale:
            shares = dict(zip(result.Symbols, display.mean_of(result, ("First", "Total"))))
        self.list.clear()
        for source in self.core.sources:
            share = shares.get(source.name)
            law = source.law
            words = f"{distribution_name(law.distribution)}, {plain(law.lower)} … {plain(law.upper)}"
            texts = (source.name, words, ", ".join(source.factors), "–" if share is None else f"{100 * share:.1f} %")
            item = add_row(self.list, texts, {} if share is None else {SHARE: share}, source.name)
            item.setSelected(source.name == self.edited)
        fit_columns(self.list, {NAME: 110, LAW: 120, FOLLOW: 120})
        self.quiet = False
        self._show_source(next((s for s in self.core.sources if s.name == self.edited), None))

    def _show_source(self, source: Source | None) -> None:
        """Fill the fields with a source, or empty them."""
        self.quiet = True
        self.edited = "" if source is None else source.name
        self.title.setText(self.edited)
        write_field(self.law, "uniform" if source is None else source.law.distribution)
        for box, value in zip(self.ends, (-1.0, 1.0) if source is None else (source.law.lower, source.law.upper)):
            box.setText(plain(value))
        self.factors.clear()
        followed = {} if source is None else source.factors
        for c in sorted(self.core.components, key=lambda c: c.symbol not in followed):  # those that follow come first
            item = add_row(self.factors, (c.symbol, "", error_meaning(c.symbol, {c.symbol: c})), (), c.symbol)
            item.setFlags(item.flags() | Qt.ItemIsUserCheckable | Qt.ItemIsEditable)
            factor = followed.get(c.symbol)
            item.setCheckState(ERROR, Qt.Unchecked if factor is None else Qt.Checked)
            if factor is not None:
                item.setText(FACTOR, self._shown(c, factor))
        fit_columns(self.factors, {MEANING: 190})
        self.factors.setColumnWidth(FACTOR, 84)
        laws = self.core.all_tolerances
        self.own.setChecked(source is not None and any(self._varies(laws.get(s)) for s in source.factors))
        self.quiet = False
        self.remove_button.setEnabled(source is not None)
        self.declare_button.setText(
            translate("Sens", "Declare") if source is None else translate("Sens", "Change")
        )  # fmt: skip

    @staticmethod
    def _varies(law) -> bool:
        return law is not None and law.upper > law.lower

    @staticmethod
    def _shown(c, factor: float) -> str:
        return f"{plain(c.to_shown(factor))} {unit_sign(c.unit)}"

    def _chosen(self) -> None:
        if self.quiet:
            return
        items = self.list.selectedItems()
        name = items[0].data(0, KEY) if items else ""
        self._show_source(next((s for s in self.core.sources if s.name == name), None))
        self.point()

    def _ticked(self, item, column: int) -> None:
        """A ticked error takes half the width of its tolerance as its factor; a typed factor ticks it."""
        if self.quiet:
            return
        self.quiet = True
        c = self.core.component(item.data(0, KEY))
        if column == ERROR:
            ticked = item.checkState(ERROR) == Qt.Checked
            if ticked and not item.text(FACTOR):
                law = self.core.all_tolerances.get(c.symbol)
                half = (law.upper - law.lower) / 2 if self._varies(law) else c.from_shown(1.0)
                item.setText(FACTOR, self._shown(c, half))
            elif not ticked:
                item.setText(FACTOR, "")
        elif column == FACTOR:
            item.setCheckState(ERROR, Qt.Checked if item.text(FACTOR).strip() else Qt.Unchecked)
        self.quiet = False

    def source(self) -> Source:
        """The source of the fields; refuses what cannot be read, with its place."""
        factors = {}
        for i in range(self.factors.topLevelItemCount()):
            item = self.factors.topLevelItem(i)
            if item.checkState(ERROR) == Qt.Checked:
                c = self.core.component(item.data(0, KEY))
                factors[c.symbol] = parse(item.text(FACTOR), angular=c.angular, default_unit=c.unit, where=c.symbol)
        ends = [
            parse(box.text(), angular=False, default_unit="mm", where=translate("Sens", "Law")) for box in self.ends
        ]
        law = read_field(self.law)
        if ends[1] < ends[0]:
            raise Refused("gui-limits-reversed", translate("Sens", "Law"))
        return Source(self.title.text().strip(), Tolerance(*ends, law), factors)

    def new(self, *_) -> None:
        """Empty the fields."""
        self.list.clearSelection()
        self._show_source(None)
        self.title.setFocus()

    def declare(self, *_) -> bool:
        """Write the source of the fields to the machine: one undo step; whether it went through."""
        try:
            source = self.source()
        except Refused as error:
            messages.show(messages.words(error))
            return False
        edited, own = self.edited, self.own.isChecked()

        def change():
            sources.declare(self.machine, source, edited, own=own)
            self._ranked()

        if not self.change(translate("Sens", "Declare source"), change):
            return False
        self.edited = source.name
        self.recall()
        words = translate("Sens", "{name} is declared; its share stands in the ranking")
        messages.status(words.format(name=source.name))
        return True

    def remove(self, *_) -> None:
        """Take the chosen source away: one undo step."""
        name = self.edited

        def change():
            sources.remove(self.machine, name)
            self._ranked()

        if name and self.change(translate("Sens", "Remove source"), change):
            self.edited = ""
            self.recall()

    def _ranked(self) -> None:
        """Compute the ranking again where the machine shows one."""
        self.document.recompute()
        result = tree.sensitivity_of(self.machine)
        if result is not None and result.Coloured:
            display.compute_and_colour(self.machine)

    # -- the covariance ----------------------------------------------------------------------------------------------
    def ask_covariance(self, *_) -> None:
        """Ask for a file of a covariance and read it."""
        path = messages.ask_open(translate("Sens", "Covariance of errors"), "CSV (*.csv)")
        if path:
            self.load_covariance(path)

    def load_covariance(self, path) -> None:
        """Take the covariance of a file; a matrix that is none is refused with the nearest remedy, nothing changes."""
        try:
            self.covariance = correlated_files.load(path, self.core)
        except Refused as error:
            messages.show(messages.words(error))
            return
        self.path = str(path)
        self._say_given()
        self.forget()

    def of_fit(self, *_) -> None:
        """Take the covariance of the machine's fit."""
        self.covariance, self.path = None, ""
        self._say_given()
        self.forget()

    def fitted(self):
        """The fitted errors of the machine, or of its newest trace, whose covariance is known; None without."""
        found = [self.core.fitted]
        for trace in reversed(tree.traces_of(self.machine)):
            try:
                found.append(None if trace.Stale else closed_loop.augmented(trace).fitted)
            except Refused:  # a damaged trace
                continue
        return next((f for f in found if f is not None and f.uncertainty is not None), None)

    def _has_fit(self) -> bool:
        return self.fitted() is not None

    def _say_given(self) -> None:
        if self.path:
            text = Path(self.path).name
        elif self._has_fit():
            text = translate("Sens", "of the fit: what remains uncertain")
        else:
            text = translate("Sens", "none: read a file, or fit readings first")
        self.given.setText(text)
        self.given.setToolTip(self.path)
        self.fit_button.setEnabled(self._has_fit())

    def settings(self) -> dict:
        return {"covariance": self.path, "fit": "" if self.path else self._fit_key()}

    def _fit_key(self) -> str:
        """What tells one fit from another."""
        fitted = self.fitted()
        known = None if fitted is None else fitted.uncertainty.matrix()
        return "none" if known is None else hashlib.sha256(known.tobytes()).hexdigest()

    def outdated(self, settings: dict) -> bool:
        return bool(settings.get("fit")) and settings["fit"] != self._fit_key()

    def show_settings(self, settings: dict) -> None:
        path = settings.get("covariance", "")
        if path and Path(path).is_file():
            self.load_covariance(path)

    def compute(self, *_) -> bool:
        """On the page of sources: the ranking with their shares; else the study of the covariance."""
        if self.tabs.currentIndex() == 1:
            return super().compute()
        done = messages.change(self.document, translate("Sens", "Sensitivity"),
                               lambda: display.compute_and_colour(self.machine))  # fmt: skip
        self.look_again()
        self.recall()
        return done

    def work(self):
        core, given = self.core, self.covariance
        if given is None:
            core = replace(core, fitted=self.fitted())
        return (lambda progress: correlated_study(core, given, progress)), translate("Sens", "Shares of the components")

    def plain(self, found) -> dict:
        return correlated_files.to_dict(found)

    def files(self, found) -> dict:
        return correlated_files.files(found, messages.language())

    def ask_report(self, *_) -> list:
        """As for every study; the report is that of the covariance."""
        self.tabs.setCurrentIndex(1)
        return super().ask_report()

    # -- what was found ----------------------------------------------------------------------------------------------
    def clear(self) -> None:
        self.shares.clear()

    def fill(self, data: dict) -> None:
        largest = max((s["share"] for s in data["components"]), default=1.0)
        for row in data["components"]:
            self._row(body_name(self.machine, row["body"]), row, row["body"], largest, bold=True)
        for block in data["blocks"]:
            if len(block["errors"]) > 1:
                self._row(", ".join(block["errors"]), block, "", largest)
        for row in data["errors"]:
            self._row(row["symbol"], row, self.core.component(row["symbol"]).body, largest)
        fit_columns(self.shares, {0: 150})
        self.shares.setColumnWidth(PART, 130)

    def _row(self, name, row, body, largest, bold=False) -> None:
        texts = (name, "", *(f"{row[k]:.3f}" if k in row else "" for k in ("first", "total")))
        values = {PART: row["share"]} | {i: row[k] for i, k in ((2, "first"), (3, "total")) if k in row}
        add_row(self.shares, texts, values, body, bold=bold,
                bar=(PART, max(row["share"], 0.0), largest, BAR_COLOUR))  # fmt: skip

    def invitation(self) -> str:
        if self.tabs.currentIndex() == 0:
            return self._of_sources()
        return translate(
            "Sens", "Shares of the components when errors vary together. With the covariance of a fit they say which "
            "further measurement helps most."
        )  # fmt: skip

    def words(self, data: dict) -> str:
        if self.tabs.currentIndex() == 0:
            return self._of_sources()
        first = data["components"][0]
        fields = {"name": body_name(self.machine, first["body"]), "part": f"{100 * first['share']:.0f}"}
        if data["inputs"] == "fit":
            words = translate("Sens", "Measure {name} further: it holds {part} % of what remains uncertain. "
                              "rms of that: {rms} µm.")  # fmt: skip
        else:
            words = translate("Sens", "{name} makes {part} % of the variance. rms over the workspace: {rms} µm.")
        return words.format(rms=f"{data['mean_square_um2'] ** 0.5:.3g}", **fields)

    def _of_sources(self) -> str:
        """What the page of sources says."""
        count = len(self.core.sources)
        if not count:
            return translate(
                "Sens", "Errors that come from one cause follow a source: one rail gives straightness and pitch, one "
                "temperature lengthens three scales."
            )  # fmt: skip
        return translate("Sens", "Sources: {n}. Compute gives their shares in the ranking.").format(n=count)

    def _say(self) -> None:
        if self.data is not None:
            self.summary.setText(self.words(self.data))
        else:
            self.summary.setText(self.invitation())

    def enable(self) -> None:
        front = self.tabs.currentIndex()
        self.report_button.setEnabled(self.data is not None and front == 1)

    def point(self, *_) -> None:
        """The bodies of the chosen row are pointed at in the view."""
        if self.quiet:
            return
        known = refresh.components(self.machine)
        view = self.shares if self.tabs.currentIndex() == 1 else self.factors
        keys = [item.data(0, KEY) for item in view.selectedItems()]
        bodies = [known[k].body if k in known else k for k in keys]
        if view is self.factors and not bodies:
            chosen = next((s for s in self.core.sources if s.name == self.edited), None)
            bodies = [] if chosen is None else [known[s].body for s in chosen.factors if s in known]
        bodies = [b for b in dict.fromkeys(bodies) if tree.body_of(self.machine, b) is not None]
        pointers.show(self.machine, bodies, detail=len(bodies) == 1)


def open_panel(machine) -> TaskCorrelated:
    """Open the panel for a machine."""
    return opened(TaskCorrelated(machine))


@command
class Correlated(Command):
    name = "Sens_Correlated"
    study = "correlated"
    keys = "Y, U"
    menu_text = QT_TRANSLATE_NOOP("Sens_Correlated", "Correlated Tolerances…")
    tip = QT_TRANSLATE_NOOP("Sens_Correlated", "Declares errors that come from one cause, and shares for a covariance")
    guide = TaskCorrelated.guide
    where = Where("machine", 55, tree=("Machine", "Tolerances"))

    def run(self):
        open_panel(current_machine())
