# SPDX-License-Identifier: LGPL-2.1-or-later
"""report.html of a measuring plan: what it could find, what it could not, and what would make it better.

Its numbers are those of plan.json; its words are messages, in the language that is asked for.
"""

from __future__ import annotations

import datetime
from collections.abc import Mapping

from sensworkbench import __version__
from sensworkbench.closedloop import plan as planning
from sensworkbench.closedloop.settings import DEFAULT
from sensworkbench.core.shapes import SHAPES
from sensworkbench.messages import Message

from . import charts, html, trace_json
from .html import Html
from .trace_html import driver_words, um, unit_words
from .words import Words

SUGGESTED = "positions_suggested.csv"
_ROWS = 30  # of a long table
_COMPARED = (
    ("places", Message("plan-row-places"), ""),
    ("readings", Message("plan-row-readings"), ""),
    ("rank", Message("plan-row-rank"), ""),
    ("parameters", Message("plan-row-parameters"), ""),
    ("physical_effects_testable", Message("plan-row-effects"), ""),
    ("candidates_named_visible", Message("plan-row-candidates"), ""),
    ("median_detectable_um", Message("plan-row-median"), "um"),
    ("prediction_um", Message("plan-row-prediction"), "um"),
    ("prediction_longer_tool_um", Message("plan-row-longer", length=planning.LONGER_MM), "um"),
    ("aliased_leads", Message("plan-row-aliased"), ""),
    ("pure_error_dof", Message("plan-row-repeats"), ""),
)


def number_words(value, unit: str, language: str = "en") -> str:
    """Return a number with its unit for a table; None is "not at all"."""
    if value is None:
        return Message("plan-not-at-all").text(language)
    return f"{value:.2g} {unit}" if unit else f"{value:g}"


def plan_report(data: Mapping, language: str = "en") -> str:
    """The page for the data of plan.json.  language : of the words."""
    return _Report(data, Words(language)).page()


class _Report:
    """The sections of one page.  data : of plan.json.  words : the language."""

    def __init__(self, data: Mapping, words: Words):
        self.data, self.words = data, words

    def page(self) -> str:
        words, data, n = self.words, self.data, self.data["numbers"]
        given = data["judged"] == "given"
        title = words("plan-title" if given else "plan-title-suggested", machine=data["machine"])
        size = {"places": n["places"], "readings": n["readings"], "tools": data["tools"]}
        parts = [
            self.summary(),
            self.advice(),
            self.comparison(),
            self.errors(),
            self.effects(),
            self.missing(),
            self.pairs(),
            self.periods(),
            self.identifiability(),
            self.remarks(),
        ]
        found = words(
            "plan-footer",
            alpha=DEFAULT.alpha,
            candidates=data["threshold"]["candidates"],
            power=DEFAULT.power,
            floor=DEFAULT.floor,
        )
        return html.page(
            title,
            words("plan-subtitle" if data["tools"] > 1 else "plan-subtitle-tool", structure=data["structure"], **size),
            *parts,
            footer=f"Sens Workbench {__version__}, {datetime.date.today().isoformat()}. {found}",
            language=words.language,
        )

    # -- words ---------------------------------------------------------------------------------------------------------
    def said(self, entry: Mapping, key: str) -> str:
        """The sentence under `key` of an entry of the data."""
        return trace_json.text(entry, key, self.words.language)

    def driven(self, entry: Mapping, shaped: bool = False) -> str:
        """`EXX by temp_x × x (polynomial)`; the shape where it is asked for and is not a plain proportion."""
        fields = {"component": entry["component"], "driver": driver_words(entry["driver"])}
        shape = SHAPES[entry["shape"]]
        if shaped and not shape.proportional:
            return self.words("driven-by-shaped", **fields, shape=shape.title or entry["shape"])
        return self.words("driven-by", **fields)

    def listed(self, names, most: int = 4, between: str = ", ") -> str:
        """The first `most` of the names, and how many there are where there are more."""
        shown = between.join(names[:most])
        return f"{shown} {self.words('plan-in-all', count=len(names))}" if len(names) > most else shown

    # -- sections ------------------------------------------------------------------------------------------------------
    def summary(self) -> Html:
        words, data, n = self.words, self.data, self.data["numbers"]
        median, found = n["median_detectable_um"], n["physical_effects_testable"]
        lead = words(
            "plan-lead" if data["advice"] else "plan-lead-best",
            parameters=n["parameters"],
            rank=n["rank"],
            effects=len(data["effects"]),
            found=found,
            changes=len(data["advice"]),
        )
        tiles = [
            (words("plan-count-of", count=n["rank"], total=n["parameters"]), words("plan-tile-determined")),
            (words("plan-count-of", count=found, total=len(data["effects"])), words("plan-tile-effects")),
            ("–" if median is None else f"{um(median)} µm", words("plan-tile-median", noise=data["noise_um"])),
            (str(n["aliased_leads"]), words("plan-tile-aliased", count=len(data["periods"]))),
        ]
        return html.join([html.paragraph(lead, lead=True), html.tiles(tiles)])

    def advice(self) -> Html:
        words = self.words
        if not self.data["advice"]:
            return Html("")
        rows = []
        for a in self.data["advice"]:
            why = [". " + _upper(self.said(a, "why"))] if a["why"] else []
            numbers = [number_words(a[k], unit_words(a["unit"]), words.language) for k in ("before", "after")]
            change = html.join([html.element("b", _upper(self.said(a, "do"))), *why])
            rows.append((change, self.said(a, "improves"), *numbers))
        columns = [
            words("plan-column-change"),
            words("plan-column-improves"),
            "#" + words("plan-column-now"),
            "#" + words("plan-column-then"),
        ]
        explained = html.paragraph(words("plan-better-words"), soft=True)
        return html.section(words("plan-better"), explained, html.table(columns, rows))

    def comparison(self) -> Html:
        words, data = self.words, self.data
        if data["judged"] != "given" or data["suggested"] is None:
            return Html("")

        def cell(value, unit):
            return words("plan-not-determined") if value is None else um(value) if unit else f"{value:g}"

        given, then = data["numbers"], data["suggested"]["numbers"]
        rows = [(words.of(m), cell(given[k], unit), cell(then[k], unit)) for k, m, unit in _COMPARED]
        columns = ["", "#" + words("plan-column-given"), "#" + words("plan-column-suggested")]
        explained = html.paragraph(words("plan-more-words", file=SUGGESTED), soft=True)
        return html.section(words("plan-more"), explained, html.table(columns, rows))

    def errors(self) -> Html:
        words, rows = self.words, self.data["errors"]
        if not rows:
            return Html("")
        changes = [c for c in ("tool", "run", "sensor") if f"u_another_{c}" in rows[0]]

        def cell(row, key):
            unit = "µrad" if row["unit"] == "urad" else "µm"
            return words("plan-not-determined") if row[key] is None else f"{row[key]:.2g} {unit}"

        cells = [(r["symbol"], cell(r, "u"), *(cell(r, f"u_another_{c}") for c in changes)) for r in rows]
        heads = [words("column-error"), f"#{words('plan-error-u')}", *(f"#{words(f'plan-error-{c}')}" for c in changes)]
        explained = html.paragraph(words("plan-errors-words"), soft=True)
        return html.section(words("plan-errors"), explained, html.table(heads, cells))

    def effects(self) -> Html:
        words, rows = self.words, []
        for e in self.data["effects"]:
            p = e["plainest"]
            if p is None:
                continue
            least = words("plan-size-hidden") if p["smallest"] is None else _size_words(p["smallest"])
            rows.append(
                (
                    self.said(e, "name"),
                    self.driven(p, shaped=True),
                    f"{p['visible_share']:.0%}",
                    html.meter(p["visible_share"], p["visible_share"]),
                    least,
                    um(p["smallest_um"]),
                    unit_words(self.said(e, "usual_size")),
                    words("plan-count-of", count=e["visible"], total=e["candidates"]),
                )
            )
        columns = [
            words("plan-column-effect"),
            words("plan-column-plainest"),
            "#" + words("plan-column-visible"),
            "",
            "#" + words("plan-column-smallest"),
            "#" + words("plan-column-rms"),
            words("plan-column-usual"),
            "#" + words("plan-column-shown"),
        ]
        explained = words("plan-found-words", visible=DEFAULT.visible, noise=self.data["noise_um"])
        parts = [html.paragraph(explained, soft=True), html.table(columns, rows)]
        chart = self.chart()
        if chart is not None:
            parts.append(html.figure(chart, words("plan-chart-caption")))
        return html.section(words("plan-found"), *parts)

    def chart(self) -> Html | None:
        words, data = self.words, self.data
        if data["judged"] != "given" or data["suggested"] is None or not charts.available():
            return None
        share = lambda e: 0.0 if e["plainest"] is None else e["plainest"]["visible_share"]  # noqa: E731
        then = {e["name"]: share(e) for e in data["suggested"]["effects"]}
        kept = [e for e in data["effects"] if share(e) > 0 or then[e["name"]] > 0]
        series = {
            words("plan-chart-given"): [share(e) for e in kept],
            words("plan-chart-suggested"): [then[e["name"]] for e in kept],
        }
        names = [self.said(e, "name") for e in kept]
        return charts.grouped_bars(names, series, words("plan-chart-share"), alt=words("plan-chart-alt"))

    def missing(self) -> Html:
        words, data, parts = self.words, self.data, []
        if data["not_testable"]:
            rows = [(self.said(t, "effect"), t["needs"]) for t in data["not_testable"]]
            parts.append(html.table([words("plan-column-not-testable"), words("plan-column-needs")], rows))
        hidden: dict[str, list[str]] = {}
        for c in data["hidden"]:
            hidden.setdefault(self.said(c, "name"), []).append(self.driven(c))
        if hidden:
            rows = [(name, self.listed(found, 12, "; ")) for name, found in hidden.items()]
            parts.append(html.table([words("plan-column-hidden"), words("plan-column-candidates")], rows))
        return html.section(words("plan-not-found"), *parts) if parts else Html("")

    def pairs(self) -> Html:
        words, confused = self.words, self.data["confused"]
        if not confused:
            return html.section(words("plan-alike"), html.paragraph(words("plan-alike-none")))
        rows = [
            (
                self.listed([driver_words(d) for d in p["drivers"]]),
                self.listed(p["components"]),
                self.listed(trace_json.texts(p, "effects", words.language), 3),
                f"{p['cosine']:.3f}",
                p["count"],
            )
            for p in confused[:_ROWS]
        ]
        columns = [
            words("plan-column-drivers"),
            words("plan-column-components"),
            words("plan-column-effects"),
            "#" + words("plan-column-cosine"),
            "#" + words("plan-column-pairs"),
        ]
        parts = [html.paragraph(words("plan-alike-words", same=DEFAULT.same), soft=True), html.table(columns, rows)]
        if len(confused) > _ROWS:
            parts.append(html.paragraph(words("plan-more-in-file", count=len(confused) - _ROWS), soft=True))
        return html.section(words("plan-alike"), *parts)

    def periods(self) -> Html:
        words = self.words

        def looks(period):
            return words("plan-looks-constant") if period == "constant" else words("plan-looks-period", period=period)

        rows = [
            (p["axis"].upper(), f"{p['lead_mm']:g}", f"{p['visible']:.0%}", looks(p["looks_like_mm"]))
            for p in self.data["periods"]
            if p["looks_like_mm"] is not None
        ]
        if not rows:
            return html.section(words("plan-periods"), html.paragraph(words("plan-periods-none")))
        columns = [
            words("plan-column-axis"),
            "#" + words("plan-column-lead"),
            "#" + words("plan-column-visible"),
            words("plan-column-looks"),
        ]
        explained = html.paragraph(words("plan-periods-grid"), soft=True)
        return html.section(words("plan-periods"), explained, html.table(columns, rows))

    def identifiability(self) -> Html:
        words, known, parts = self.words, self.data["identifiability"], []
        if known["null_space"]:
            sentences = trace_json.texts(known, "null_space", words.language)
            parts += [html.element("h3", words("plan-undetermined")), _bullets(sentences)]
        else:
            parts.append(html.paragraph(words("plan-all-determined")))
        if known["move_alike"]:
            groups = "; ".join(", ".join(g) for g in known["move_alike"])
            parts.append(html.paragraph(f"{words('plan-move-alike')} {groups}."))
        if known["no_reading_shows"]:
            parts.append(html.paragraph(words("plan-unseen", names=known["no_reading_shows"])))
        return html.section(words("plan-declared"), *parts)

    def remarks(self) -> Html:
        notes = []
        for f in self.data["findings"]:
            remark = self.said(f, "message")
            notes.append(f"{self.words('plan-remark-line', line=f['line'])} {remark}" if f["line"] else remark)
        return html.section(self.words("plan-remarks"), _bullets(notes[:40])) if notes else Html("")


def _bullets(items) -> Html:
    return html.element("ul", *(html.element("li", i) for i in items))


def _upper(words: str) -> str:
    return words[:1].upper() + words[1:]


def _size_words(entry) -> str:
    value, unit = entry["value"], entry["unit"]
    for power in (3, 2, 1):  # per metre reads better than per millimetre
        for tail in (f"mm^{power}", f"mm^{power})") if power > 1 else ("mm", "mm)"):
            if unit.endswith(tail):
                value, unit = value * 1e3**power, unit.removesuffix(tail) + tail.replace("mm", "m")
                return f"{value:.3g} {unit_words(unit)}"
    return f"{value:.3g} {unit_words(unit)}"
