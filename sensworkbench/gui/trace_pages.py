# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a trace found, as pages to read in the panel: verdict, findings, error before and after, what to do next, fit.

The words and numbers are those of trace.json.  Every text from a file is escaped before it becomes part of a page.
"""

from __future__ import annotations

from html import escape

import numpy as np

from ..core.errors import COMPONENTS, component
from ..formats import trace_html
from ..formats.trace_html import driver_words, parameter_words, shape_words, um, unit_words
from ..formats.words import Words
from ..messages import Message
from ..studies.trace import component_values, point_vectors
from . import plots
from .finding_words import all_said, language, said
from .messages import words
from .qt import Qt, QtCore, QtGui, translate
from .texts import body_name, error_meaning, fixed, length_unit

PAGES = ("Result", "Findings", "BeforeAfter", "Next", "Fit")
_COLOURS = {
    "nothing_to_explain": "#3f7d3a", "explained": "#3f7d3a", "partly_explained": "#b36b00", "unexplained": "#a32a2a",
}  # fmt: skip


class Page(QtGui.QTextBrowser):
    """A page whose pictures are painted anew when its width changes.

    `fill` is a function of the page that returns its HTML; it may call `picture`.
    """

    def __init__(self, name: str):
        super().__init__()
        self.setObjectName(f"SensTrace{name}")
        self.setFrameShape(QtGui.QFrame.NoFrame)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarAsNeeded)
        self.setMinimumWidth(240)
        self.document().setDocumentMargin(8)
        self.fill, self._width, self._pictures = None, 0, 0

    def show_page(self, fill) -> None:
        """Show what `fill` returns; it is called again when the width changes."""
        self.fill = fill
        self._paint()

    def _paint(self):
        self._width = self.viewport().width()
        self._pictures = 0
        self.clear()
        if self.fill is not None:
            self.setHtml(self.fill(self))

    def picture(self, paint) -> str:
        """An <img> of the QImage that `paint(width)` returns."""
        self._pictures += 1
        name = f"chart{self._pictures}"
        image = paint(max(260, min(self._width - 24, 640)))
        self.document().addResource(QtGui.QTextDocument.ImageResource, QtCore.QUrl(name), image)
        return f'<p><img src="{name}" width="{image.width()}" height="{image.height()}"></p>'

    def resizeEvent(self, event):
        super().resizeEvent(event)
        if self._pictures and abs(self.viewport().width() - self._width) > 12:
            self._paint()


# -- pieces of HTML ----------------------------------------------------------------------------------------------------
def heading(text: str) -> str:
    """Return a heading as HTML."""
    return f'<p style="margin-top:10px;margin-bottom:2px"><b>{escape(text)}</b></p>'


def paragraph(text: str) -> str:
    """Return a paragraph as HTML."""
    return f'<p style="margin-top:2px;margin-bottom:6px">{escape(text)}</p>'


def bullets(items) -> str:
    """Return a list as HTML."""
    return (
        "<ul style='margin-top:0px;margin-left:-22px'>" + "".join(f"<li>{escape(str(i))}</li>" for i in items) + "</ul>"
    )


def table(head, rows) -> str:
    """Cells are texts; those of a column whose head starts with # are numbers, at the right."""
    right = [str(h).startswith("#") for h in head]
    align = ['align="right"' if r else 'align="left"' for r in right]
    cells = "".join(f"<th {a}>{_cell(str(h).lstrip('#'), 6)}</th>" for h, a in zip(head, align))
    lines = [f"<tr>{cells}</tr>"]
    for row in rows:
        lines.append("<tr>" + "".join(f"<td {a} valign='top'>{_cell(c)}</td>" for c, a in zip(row, align)) + "</tr>")
    return "<table cellspacing='0' cellpadding='3' width='100%'>" + "".join(lines) + "</table>"


def _cell(text, short: int = 14) -> str:
    """A text of fewer letters than `short` stays in one line: Qt breaks words where a column is narrow."""
    shown = escape(str(text))
    return f"<p style='white-space:nowrap; margin:0'>{shown}</p>" if len(str(text)) < short else shown


def facts(pairs) -> str:
    """Return a table of (name, value) pairs as HTML."""
    lines = [
        f"<tr><td valign='top' width='34%'>{escape(k)}</td><td valign='top'><b>{escape(str(v))}</b></td></tr>"
        for k, v in pairs
    ]
    return "<table cellspacing='0' cellpadding='2' width='100%'>" + "".join(lines) + "</table>"


# -- words -------------------------------------------------------------------------------------------------------------
def verdict(name: str) -> tuple[str, str]:
    """(title, sentence) of a verdict."""
    title, sentence = trace_html.VERDICTS[name]
    return words(title), words(sentence)


def stage(name: str) -> str:
    """Return the name of a stage of the correction, in words."""
    return words(trace_html.STAGES[name])


def short_stages() -> list[tuple[str, str]]:
    """(stage, a name that fits a narrow table)."""
    return [
        ("uncorrected", translate("Sens", "uncorrected")), ("declared", translate("Sens", "declared")),
        ("augmented", translate("Sens", "with effects")),
    ]  # fmt: skip


def parameter_name(key: str) -> str:
    """What a parameter of an effect is, in words."""
    title = trace_html.parameter_title(key)
    return key if title is None else words(title)


def result_page(report, machine=None):
    """Verdict, what was found, and the error of held-out readings at each stage."""

    def fill(page: Page) -> str:
        title, sentence = verdict(report["verdict"])
        colour = _COLOURS[report["verdict"]]
        parts = [
            f'<p style="margin-bottom:2px"><span style="color:{colour};font-size:large"><b>{escape(title)}</b></span>'
            f"</p>{paragraph(sentence)}"
        ]
        for e in report["effects"]:
            parts.append(heading(said(e, "name")))
            parts.append(paragraph(_finding_sentence(e, machine)))
        rows = [
            (stage(s), *(um(report["error"][s]["held_out"][k]) for k in ("rms_um", "p95_um", "max_um")))
            for s in trace_html.STAGES
        ]
        parts.append(heading(translate("Sens", "Error on readings that took no part in the fit, µm")))
        head = ["", "#rms", "#95 %", "#" + translate("Sens", "largest")]
        parts.append(table(head, rows))
        parts.append(heading(translate("Sens", "What is left")))
        rest, noise = report.get("remainder", {}), report["noise"]
        left = "; ".join(all_said(rest, "words")) if "words_messages" in rest else rest.get("words", "")
        line = translate("Sens", "Noise of one reading {noise} µm").format(noise=um(noise["residual_um"]))
        if noise["stated_um"] is not None:
            line += translate("Sens", ", stated {stated} µm").format(stated=um(noise["stated_um"]))
        if noise["pure_error_um"] is not None:
            line += translate("Sens", ", from repeats {pure} µm").format(pure=um(noise["pure_error_um"]))
        parts.append(paragraph(f"{left[:1].upper()}{left[1:]}. {line}." if left else f"{line}."))
        if report["depends_on"]:
            listed = ", ".join(f"{d['column']} (p = {d['p']:.2g})" for d in report["depends_on"])
            parts.append(
                paragraph(
                    translate("Sens", "What the declared errors leave depends on {columns}.").format(columns=listed)
                )
            )
        return "".join(parts)

    return fill


def _finding_sentence(e, machine) -> str:
    owner = component(e["component"]).body if e["component"] in COMPONENTS else ""
    who = body_name(machine, owner) if owner else e["component"]
    what = translate("Sens", "{symbol} of {body}, driven by {driver}: {size} µm rms over the readings").format(
        symbol=e["component"], body=who, driver=driver_words(e["driver"]), size=um(e["amplitude_um"])
    )
    value = e["parameters"].get("coefficient")
    told = f"{what}; {parameter_words(value, Words(language()))}" if value else what
    count = len(e["rivals"])
    if count:
        told += "; " + translate("Sens", "rivals that these readings cannot tell from it: {n}").format(n=count)
    return told + "."


def _candidates(entries) -> list[tuple]:
    """Component, driver, shape and reason of rivals or refused names."""
    spoken = Words(language())
    return [
        (r["component"], driver_words(r["driver"]), shape_words(r["shape"], spoken), said(r, "why")) for r in entries
    ]


def findings_page(report, outcome=None):
    """Each finding with its parameters, evidence, chart and rivals; then what was significant but not named."""

    def fill(page: Page) -> str:
        parts = []
        if not report["effects"]:
            parts.append(paragraph(translate("Sens", "No effect is named.")))
        for number, e in enumerate(report["effects"], start=1):
            what = error_meaning(e["component"])
            pairs = [
                (translate("Sens", "Component"), f"{e['component']}, {what}"),
                (translate("Sens", "Driver"), driver_words(e["driver"])),
                (translate("Sens", "Shape"), shape_words(e["shape"], Words(language()))),
                *(
                    (parameter_name(k), parameter_words(v, Words(language())))
                    for k, v in e["parameters"].items()
                    if k != "domains"
                ),
                (translate("Sens", "Size"), f"{um(e['amplitude_um'])} µm rms"),
                (translate("Sens", "Chance by noise alone"), f"p = {e['p_familywise']:.2g}"),
                (translate("Sens", "Found again in half-samples"), f"{e['selection_frequency']:.0%}"),
            ]
            if e.get("usual_size"):
                pairs.append((translate("Sens", "Usual size"), unit_words(said(e, "usual_size"))))
            if e.get("check"):
                pairs.append((translate("Sens", "Check on the machine"), said(e, "check")))
            parts += [heading(f"{number}. {said(e, 'name')}"), facts(pairs)]
            if e.get("note"):
                parts.append(paragraph(said(e, "note")))
            parts.append(_driver_chart(page, e, outcome))
            if e["rivals"]:
                rows = _candidates(e["rivals"])
                head = [translate("Sens", "Rival"), translate("Sens", "Driver"), translate("Sens", "Shape"),
                        translate("Sens", "Why it remains")]  # fmt: skip
                parts += [
                    paragraph(translate("Sens", "These readings cannot tell it from its rivals:")),
                    table(head, rows),
                ]
            else:
                parts.append(paragraph(translate("Sens", "No rival: nothing else that was searched explains as much.")))
        if report.get("refused_names"):
            refused = report["refused_names"]
            rows = _candidates(refused)
            parts.append(heading(translate("Sens", "Significant, but not named")))
            head = [translate("Sens", "Component"), translate("Sens", "Driver"), translate("Sens", "Shape"),
                    translate("Sens", "Why it carries no name")]  # fmt: skip
            parts.append(table(head, rows))
        return "".join(parts)

    return fill


def _driver_chart(page: Page, entry, outcome) -> str:
    if outcome is None:
        return ""
    effect = next((e for e in outcome.machine.effects if e.name == entry["name"]), None)
    if effect is None:
        return ""
    x, asked, fitted = component_values(effect, outcome)
    if not len(x):
        return ""
    single = not effect.shape.memory and effect.driver.factors == 1
    names = (translate("Sens", "readings"), translate("Sens", "effect as fitted"))
    ylabel = f"{effect.component}, {unit_words(component(effect.component).unit)}"
    shown = page.picture(
        lambda width: plots.driver(
            width, x, asked, fitted, single, names, _driver_label(effect, outcome), ylabel, page.palette()
        )
    )
    note = translate(
        "Sens", "Each point: the value that a reading asks of the component when everything else is taken away."
    )
    return shown + paragraph(note)


def _driver_label(effect, outcome) -> str:
    units = [u for u in (outcome.readings.units.get(str(effect.driver), ""),) if u]
    if effect.driver.kinds == {"temp"} and effect.driver.factors == 1:
        return translate("Sens", "{driver}, K from 20 °C").format(driver=driver_words(effect.driver))
    return driver_words(effect.driver) + (f", {units[0]}" if units else "")


def before_after_page(report, outcome=None):
    """The table of the error at each stage, the histogram, shifts of parameters and of the sensitivity."""

    def fill(page: Page) -> str:
        head = ["", "#rms", "#95 %", "#max", "#x", "#y", "#z"]
        parts = []
        for part, title in (
            ("held_out", translate("Sens", "3-D error of readings that took no part in the fit, µm")),
            ("in_sample", translate("Sens", "The same for the readings of the fit, µm")),
        ):
            rows = []
            for s, name in short_stages():
                m = report["error"][s][part]
                each = [um(m.get(f"rms_{a}_um")) for a in "xyz"]
                rows.append((name, um(m["rms_um"]), um(m["p95_um"]), um(m["max_um"]), *each))
            parts += [heading(title), table(head, rows)]
        span = report["error"]["augmented"]["held_out"].get("rms_interval_um")
        before = report["error"]["declared"]["held_out"].get("rms_interval_um")
        if span and before:
            span_words = translate(
                "Sens", "95 % interval of the held-out rms: {a} … {b} µm before, {c} … {d} µm after."
            )
            parts.append(paragraph(span_words.format(a=um(before[0]), b=um(before[1]), c=um(span[0]), d=um(span[1]))))
        if outcome is not None:
            sizes = [np.linalg.norm(point_vectors(outcome, f"{s}_held_out"), axis=1) for s in ("declared", "augmented")]
            names = (translate("Sens", "before"), translate("Sens", "after"))
            label = translate("Sens", "error of a held-out point, µm")
            parts.append(
                page.picture(
                    lambda width: plots.histogram(
                        width, *sizes, names, label, translate("Sens", "points"), page.palette()
                    )
                )
            )
        shifts = report.get("parameter_shifts", [])[:8]
        if shifts and report["effects"]:
            rows = [
                (
                    said(s, "parameter"),
                    f"{s['before']:.3g}",
                    f"{s['after']:.3g}",
                    f"{s['u']:.2g}",
                    unit_words(s["unit"]),
                )
                for s in shifts
            ]
            parts.append(heading(translate("Sens", "Declared errors that moved when the effects joined")))
            head = [translate("Sens", "Parameter"), "#" + translate("Sens", "before"), "#" + translate("Sens", "after"),
                    "#" + translate("Sens", "uncertainty"), ""]  # fmt: skip
            parts.append(table(head, rows))
        ranking = [r for r in report["sensitivity_shift"] if r.get("after") is not None][:6]
        if ranking and report["effects"]:
            rows = [
                (r["symbol"], "–" if r["before"] is None else f"{r['before']:.3f}", f"{r['after']:.3f}")
                for r in ranking
            ]
            parts.append(heading(translate("Sens", "Total index Sᵀ with the effects in the machine")))
            head = [translate("Sens", "Error"), "#" + translate("Sens", "before"), "#" + translate("Sens", "after")]
            parts.append(table(head, rows))
        return "".join(parts)

    return fill


def next_page(report):
    """What to measure next, and what these readings cannot tell."""

    def fill(page: Page) -> str:
        parts = []
        if report["next_measurements"]:
            parts.append(heading(translate("Sens", "What to measure next")))
            for m in report["next_measurements"]:
                doing = translate("Sens", "{do} (predicted difference {size} µm)").format(
                    do=said(m, "do"), size=um(m["predicted_difference_um"])
                )
                separates = " / ".join(all_said(m, "separates"))
                doing = doing[:1].upper() + doing[1:]
                told = translate("Sens", "Tells apart: {what}").format(what=separates)
                parts.append(f"{paragraph(doing)}<p><i>{escape(told)}</i></p>")
        else:
            parts.append(paragraph(translate("Sens", "No further measurement is needed to tell the findings apart.")))
        if report["not_testable"]:
            parts.append(heading(translate("Sens", "Not testable: a column is missing")))
            head = [translate("Sens", "Effect"), translate("Sens", "Needs")]
            parts.append(table(head, [(said(t, "effect"), t["needs"]) for t in report["not_testable"]]))
        if report["not_identifiable"]:
            parts.append(heading(translate("Sens", "Hidden by the declared errors in this plan")))
            parts.append(bullets(all_said(report, "not_identifiable")))
        return "".join(parts)

    return fill


def fit_page(fit):
    """The declared fit as `closedloop.declared.fit_summary` gives it."""

    def fill(page: Page) -> str:
        rms = fit["rms"]
        noise = ", ".join(f"{'' if k == '*' else k + ' '}{um(v)}" for k, v in fit["noise_um"].items())
        pairs = [
            (translate("Sens", "Readings"), translate("Sens", "{rows} at {points} places").format(**fit)),
            (
                translate("Sens", "Error that remains"),
                translate("Sens", "{rms} µm rms, largest {largest} µm").format(
                    rms=um(rms["rms_um"]), largest=um(rms["max_um"])
                ),
            ),
            (translate("Sens", "Scatter of one reading, µm"), noise),
            (
                translate("Sens", "Parameters"),
                translate("Sens", "{rank} of {columns} are determined").format(**fit),
            ),
            (translate("Sens", "Condition"), f"{fit['condition']:.3g}"),
            (translate("Sens", "Gross outliers"), str(len(fit["outliers"]))),
        ]
        parts = [heading(translate("Sens", "Fit of the declared errors alone")), facts(pairs)]
        if fit["null_space"]:
            parts.append(heading(translate("Sens", "Not told apart by this plan")))
            parts.append(bullets(m.text(language()) for m in fit["null_space"]))
        if fit["outliers"]:
            unit, size = length_unit()
            digits = 3 if unit == "mm" else 5
            rows = [
                (o["line"] or "–", *(fixed(v / size, digits) for v in o["position_mm"])) for o in fit["outliers"][:30]
            ]
            parts.append(heading(translate("Sens", "Gross outliers, left out")))
            parts.append(table(["#" + translate("Sens", "Line"), *(f"#{k} / {unit}" for k in "XYZ")], rows))
        rows = [
            (
                words(title) if isinstance(title, Message) else title,
                "–" if value is None else f"{value:.3g}",
                "" if u is None else f"± {u:.2g}",
                unit_words(unit),
            )
            for title, value, u, unit in fit["parameters"]
        ]
        parts.append(heading(translate("Sens", "Parameters (–: not determined)")))
        parts.append(table([translate("Sens", "Parameter"), "#" + translate("Sens", "Value"), "#u", ""], rows))
        return "".join(parts)

    return fill
