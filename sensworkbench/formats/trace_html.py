# SPDX-License-Identifier: LGPL-2.1-or-later
"""report.html of a trace: the verdict, the error before and after, each finding with its evidence and its rivals.

The numbers are those of trace.json; its sentences and the page's own are shown in the language that is asked for.  The
pictures are drawn from the residuals of the readings.
"""

from __future__ import annotations

import datetime
from collections.abc import Mapping

import numpy as np

from sensworkbench import __version__
from sensworkbench.core.driver import Driver
from sensworkbench.core.errors import COMPONENTS, component
from sensworkbench.messages import Message
from sensworkbench.messages.tables import known
from sensworkbench.studies.trace import component_values, point_vectors

from . import charts, html, trace_json, trace_laboratory
from .html import Html
from .trace_json import VERDICTS
from .trace_laboratory import K
from .words import Words

STAGES = {
    "uncorrected": Message("tr-stage-uncorrected"),
    "declared": Message("tr-stage-declared"),
    "augmented": Message("tr-stage-augmented"),
}
UNLOGGED = "unlogged"  # the driver of a motion that nobody logged
_UNITS = (("urad", "µrad"), ("um", "µm"), ("_", " "))
_SHOWN = 12


def unit_words(unit: str) -> str:
    """`µrad/K` of `urad/K`."""
    for plain, shown in _UNITS:
        unit = unit.replace(plain, shown)
    return unit


def um(value) -> str:
    """A length in um with sense in its digits, or a dash."""
    return "–" if value is None else f"{value:.3g}" if abs(value) < 100 else f"{value:.0f}"


def expanded_um(entry: Mapping) -> str:
    """`5.22 ± 0.05`: amplitude of an effect with its expanded uncertainty, where that is known."""
    u = entry.get("amplitude_u_um")
    return um(entry["amplitude_um"]) + ("" if u is None else f" ± {K * u:.2g} (k = {K:g})")


def driver_words(driver: str) -> str:
    """`temp_column × y` of `temp_column*y`."""
    return Driver.of(driver).words()


def shape_words(name: str, words: Words) -> str:
    """What a shape is called."""
    code = f"shape-{name}"
    return words(code) if known(code) else name


def parameter_title(key: str) -> Message | None:
    """What a parameter of an effect in trace.json is: `tr-parameter-<key>`; None where that has no words."""
    code = f"tr-parameter-{key}"
    return Message(code) if known(code) else None


def parameter_words(entry, words: Words | None = None) -> str:
    """`−8.98 ± 0.05 µrad/K (k = 2)`: with the expanded uncertainty; words : the language, English if not given."""
    if not isinstance(entry, Mapping):
        return f"{entry:.4g}" if isinstance(entry, (int, float)) else str(entry)
    values, spread = entry["value"], entry.get("u")
    several = isinstance(values, (list, tuple))
    values = list(values) if several else [values]
    spread = list(spread) if isinstance(spread, (list, tuple)) else [spread] * len(values) if not several else []
    spread += [None] * (len(values) - len(spread))
    expanded = [None if u is None else K * u for u in spread]
    shown = [f"{v:.4g}" + ("" if u is None else f" ± {u:.2g}") for v, u in zip(values, expanded)]
    if len(shown) > 6:
        shown = [*shown[:6], (words or Words())("tr-in-all", count=len(shown))]
    text = (", ".join(shown) + " " + unit_words(entry.get("unit", ""))).replace("-", "−").strip()
    return text if all(u is None for u in spread) else f"{text} (k = {K:g})"


def trace_report(data: Mapping, outcome=None, language: str = "en", motion=()) -> str:
    """The page for the data of trace.json.

    outcome : the `TraceEvidence` that its pictures are drawn from, or None.  language : of the words; a sentence of the
    data that has no code stays as it is.  motion : pictures (GIF or PNG) of how the first effect moves the machine.
    """
    return _Report(data, outcome, Words(language), motion).page()


class _Report:
    """The sections of one page.  data : of trace.json.  words : the language."""

    def __init__(self, data: Mapping, outcome, words: Words, motion=()):
        self.data, self.outcome, self.words, self.motion = data, outcome, words, motion

    def page(self) -> str:
        words, data, outcome = self.words, self.data, self.outcome
        title = words.of(VERDICTS[data["verdict"]][0])
        subtitle = words("tr-subtitle")
        if outcome is not None:
            subtitle += " " + words("tr-structure", structure=outcome.machine.structure)
        name = words("tr-readings") if outcome is None else outcome.machine.name
        parts = [
            self.summary(),
            self.findings(),
            self.moving(),
            self.before_and_after(),
            self.remainder(),
            self.next(),
            self.sensitivity_shift(),
            self.parameters(),
            *self.laboratory(),
            self.limits(),
            self.readings(),
            trace_laboratory.records(data, words),
        ]
        footer = words(
            "tr-footer",
            version=__version__,
            date=datetime.date.today().isoformat(),
            seed=data.get("seed", 0),
            permutations=data.get("permutations", ""),
            floor=data["floor"],
        )
        return html.page(f"{name}: {title.lower()}", subtitle, *parts, footer=footer, language=words.language)

    # -- words ---------------------------------------------------------------------------------------------------------
    def said(self, entry: Mapping, key: str) -> str:
        """The sentence under `key` of an entry; the English one as it stands in the data."""
        return entry.get(key) or "" if self.words.language == "en" else trace_json.text(entry, key, self.words.language)

    def all_said(self, entry: Mapping, key: str) -> list[str]:
        """The sentences under `key` of an entry; the English ones as they stand in the data."""
        if self.words.language == "en" or f"{key}_messages" not in entry:
            found = entry.get(key) or ()
            return [found] if isinstance(found, str) else [str(v) for v in found]
        return trace_json.texts(entry, key, self.words.language)

    def driver(self, driver: str) -> str:
        """`temp_column × y`; in words where nothing was logged."""
        if not driver.startswith(UNLOGGED):
            return driver_words(driver)
        place = [name for name in Driver.parse(driver).columns if name != UNLOGGED]
        return " × ".join([self.words("tr-driver-unlogged"), *place])

    def parameter(self, key: str) -> str:
        """The name of an effect's parameter."""
        title = parameter_title(key)
        return key.capitalize() if title is None else self.words.of(title)

    def p(self, p: float) -> str:
        """A p-value, or that it is below what so few permutations can show."""
        count = self.data.get("permutations")
        if count and p <= 1.0001 / (count + 1):
            return self.words("tr-p-smallest", p=p, count=count)
        return f"{p:.2g}"

    def rows(self, entries) -> list[tuple]:
        """Component, driver, shape and reason of rivals or refused names."""
        return [
            (r["component"], self.driver(r["driver"]), shape_words(r["shape"], self.words), self.said(r, "why"))
            for r in entries
        ]

    def heads(self, reason: str) -> list[str]:
        """The columns of `rows`; reason : the last of them."""
        words = self.words
        return [words("tr-component"), words("tr-driver"), words("tr-shape"), reason]

    def laboratory(self) -> list[Html]:
        """Fitted errors, figures of ISO 230, budget and conditions."""
        if self.outcome is None:
            return [trace_laboratory.budget(self.data, self.words)]
        return [
            trace_laboratory.errors(self.outcome, self.words),
            trace_laboratory.standards(self.outcome, self.words),
            trace_laboratory.budget(self.data, self.words),
            trace_laboratory.conditions(self.data, self.outcome, self.words),
        ]

    # -- sections ------------------------------------------------------------------------------------------------------
    def summary(self) -> Html:
        words, data = self.words, self.data
        title, lead = map(words.of, VERDICTS[data["verdict"]])
        tiles = [(title, lead)]
        for stage, name in STAGES.items():
            rms = um(data["error"][stage]["held_out"]["rms_um"])
            tiles.append((f"{rms} µm", words("tr-tile-stage", stage=name)))
        named = [e for e in data["effects"] if e["driver"] != UNLOGGED]
        if named:
            listed = "; ".join(f"{self.said(e, 'name')} ({e['component']})" for e in named)
            lead = f"{lead} {words('tr-found')} {listed}."
        return html.join([html.paragraph(lead, lead=True), html.tiles(tiles)])

    def findings(self) -> Html:
        words, data = self.words, self.data
        if not data["effects"]:
            return Html("")
        parts = []
        for number, e in enumerate(data["effects"], start=1):
            symbol = e["component"]
            what = words.of(COMPONENTS[symbol].title) if symbol in COMPONENTS else symbol
            pairs = [
                (words("tr-component"), f"{symbol}, {what}"),
                (words("tr-driver"), self.driver(e["driver"])),
                (words("tr-shape"), shape_words(e["shape"], words)),
                *((self.parameter(k), parameter_words(v, words)) for k, v in e["parameters"].items()),
                (words("tr-amplitude"), words("tr-amplitude-value", um=expanded_um(e))),
                (words("tr-familywise"), self.p(e["p_familywise"])),
                (words("tr-selection"), f"{e['selection_frequency']:.0%}"),
            ]
            if e.get("usual_size"):
                pairs.append((words("tr-usual-size"), unit_words(self.said(e, "usual_size"))))
            if e.get("check"):
                pairs.append((words("tr-check"), self.said(e, "check")))
            parts += [html.element("h3", f"{number}. {self.said(e, 'name')}"), html.facts(pairs)]
            if e.get("note"):
                parts.append(html.note(self.said(e, "note")))
            chart = self.driver_chart(e)
            if chart is not None:
                parts.append(html.figure(chart, words("tr-chart-caption")))
            if e["rivals"]:
                heads = self.heads(words("tr-column-why-remains"))
                parts.append(html.table(heads, self.rows(e["rivals"]), words("tr-rivals")))
            else:
                parts.append(html.paragraph(words("tr-no-rival"), soft=True))
        return html.section(words("tr-findings"), *parts)

    def driver_chart(self, entry) -> Html | None:
        words, outcome = self.words, self.outcome
        if outcome is None or not charts.available():
            return None
        effect = next((e for e in outcome.machine.effects if e.name == entry["name"]), None)
        if effect is None:
            return None
        driver, asked, fitted = component_values(effect, outcome)
        if len(driver) == 0:
            return None
        unit = unit_words(component(effect.component).unit)
        order = np.argsort(driver, kind="stable")
        single_valued = not effect.shape.memory
        series = {words("tr-chart-asked"): asked}
        if not single_valued:
            series[words("tr-chart-fitted")] = fitted
        line = (driver[order], fitted[order]) if single_valued else None
        label = driver_words(effect.driver)
        per = effect.driver_unit
        if per:
            label += f", {unit_words(per)}" + (f" {words('tr-above-reference')}" if per == "K" else "")
        alt = words("tr-chart-alt", component=effect.component, driver=label)
        return charts.scatter(driver, series, label, f"{effect.component}, {unit}", line=line, alt=alt)

    def before_and_after(self) -> Html:
        words, outcome, error = self.words, self.outcome, self.data["error"]
        names = {stage: words.of(name) for stage, name in STAGES.items()}
        kinds = {"in_sample": words("tr-part-in-sample"), "held_out": words("tr-part-held-out")}
        rows = []
        for stage, name in names.items():
            for part, kind in kinds.items():
                m = error[stage][part]
                low, high = m.get("rms_interval_um", (None, None))
                span = "" if low is None else f"{um(low)} … {um(high)}"
                each = [um(m.get(f"rms_{a}_um")) for a in "xyz"]
                rows.append((name, kind, um(m["rms_um"]), span, um(m["p95_um"]), um(m["max_um"]), *each))
        columns = [
            words("tr-column-model"),
            words("tr-column-readings"),
            f"#{words('tr-column-rms')}",
            f"#{words('tr-column-interval')}",
            f"#{words('tr-column-percentile')}",
            f"#{words('tr-column-largest')}",
            *(f"#{words('tr-column-rms-along', axis=a)}" for a in "xyz"),
        ]
        parts = [html.table(columns, rows, words("tr-error-caption"))]
        parts.append(trace_laboratory.left_out(self.data, words))
        note = self.said(error, "note")
        if note:
            parts.append(html.paragraph(note[:1].upper() + note[1:] + ".", soft=True))
        if outcome is not None and charts.available():
            before, after = point_vectors(outcome, "declared_held_out"), point_vectors(outcome, "augmented_held_out")
            histogram = charts.histogram(
                {
                    names["declared"]: np.linalg.norm(before, axis=1),
                    names["augmented"]: np.linalg.norm(after, axis=1),
                },
                words("tr-chart-histogram-axis"),
                alt=words("tr-chart-histogram-alt"),
                ylabel=words("tr-chart-points"),
            )
            parts.append(html.figure(histogram, words("tr-chart-histogram")))
            views = charts.arrows(
                outcome.readings.q,
                {names["declared"]: before, names["augmented"]: after},
                alt=words("tr-chart-arrows-alt"),
            )
            parts.append(html.figure(views, words("tr-chart-arrows")))
        return html.section(words("tr-error"), *parts)

    def remainder(self) -> Html:
        words, data = self.words, self.data
        noise, rest = data["noise"], data.get("remainder", {})
        stated, pure = noise["stated_um"], noise["pure_error_um"]
        pairs = [
            (words("tr-noise-stated"), words("tr-not-stated") if stated is None else f"{um(stated)} µm"),
            (words("tr-noise-pure"), words("tr-no-repeats") if pure is None else f"{um(pure)} µm"),
            (words("tr-noise-residual"), f"{um(noise['residual_um'])} µm"),
        ]
        if rest:
            pairs.append((words("tr-left"), "; ".join(self.all_said(rest, "words"))))
            if rest.get("p") is not None:
                pairs.append((words("tr-left-p"), self.p(rest["p"])))
        if data["depends_on"]:
            listed = [words("tr-depends-on-item", column=d["column"], p=self.p(d["p"])) for d in data["depends_on"]]
            pairs.append((words("tr-depends-on"), ", ".join(listed)))
        parts = [html.facts(pairs)]
        if noise.get("remarks"):
            parts.append(_bullets(self.all_said(noise, "remarks")))
        if data.get("refused_names"):
            heads = self.heads(words("tr-column-why-unnamed"))
            parts.append(html.table(heads, self.rows(data["refused_names"]), words("tr-unnamed")))
        return html.section(words("tr-noise"), *parts)

    def moving(self) -> Html:
        words = self.words
        pictures = [html.picture(one, words("part-motion-alt"), words("tr-motion-caption")) for one in self.motion]
        return html.section(words("part-motion-alt"), *pictures) if pictures else Html("")

    def next(self) -> Html:
        words, planned = self.words, self.data["next_measurements"]
        if not planned:
            return Html("")
        rows = [
            (" / ".join(self.all_said(m, "separates")), self.said(m, "do"), um(m["predicted_difference_um"]))
            for m in planned
        ]
        heads = [words("tr-column-separates"), words("tr-column-do"), f"#{words('tr-column-difference')}"]
        return html.section(words("tr-next"), html.table(heads, rows))

    def sensitivity_shift(self) -> Html:
        words = self.words
        rows = [r for r in self.data["sensitivity_shift"] if r.get("after") is not None][:10]
        if not self.data["effects"] or not rows:
            return Html("")
        names = {e["name"]: self.said(e, "name") for e in self.data["effects"]}
        cells = [
            (
                names.get(r["symbol"], r["symbol"]),
                "–" if r["before"] is None else f"{r['before']:.4f}",
                f"{r['after']:.4f}",
                html.meter(r["after"], 0, max(x["after"] for x in rows)),
            )
            for r in rows
        ]
        heads = [words("tr-column-error"), f"#{words('tr-column-before')}", f"#{words('tr-column-after')}", ""]
        explained = html.paragraph(words("tr-sensitivity-words"), soft=True)
        return html.section(words("tr-sensitivity"), explained, html.table(heads, cells))

    def parameters(self) -> Html:
        words, shifts = self.words, self.data.get("parameter_shifts", [])
        if not shifts:
            return Html("")
        rows = [
            (
                self.said(s, "parameter"),
                f"{s['before']:.3g}",
                f"{s['after']:.3g}",
                f"{s['u']:.2g}",
                unit_words(s["unit"]),
            )
            for s in shifts[:_SHOWN]
        ]
        left = len(shifts) - _SHOWN
        more = [html.paragraph(words("tr-more", count=left), soft=True)] if left > 0 else []
        heads = [
            words("tr-column-parameter"),
            f"#{words('tr-column-before')}",
            f"#{words('tr-column-after')}",
            f"#{words('tr-column-uncertainty')}",
            words("tr-column-unit"),
        ]
        return html.section(words("tr-shifts"), html.table(heads, rows), *more)

    def null_space(self, known):
        """The sentences on what is not determined, those with the same advice together."""
        sentences = self.all_said(known, "null_space")
        codes = [m["code"] for m in known.get("null_space_messages", ())] or [""] * len(sentences)
        for code in dict.fromkeys(codes):
            yield _bullets(s for s, own in zip(sentences, codes) if own == code)

    def guarantee(self, entry: Mapping) -> str:
        """How often a name is given to nothing, and under which conditions."""
        by = [
            self.words(f"tr-guarantee-{b['exchange']}{'-all' if b['exact'] else ''}", count=b["number"])
            for b in entry["by"]
        ]
        conditions = "; ".join(self.all_said(entry, "conditions"))
        return f"{self.words('tr-guarantee', rate=entry['rate'], by=by)} {conditions}."

    def limits(self) -> Html:
        words, data = self.words, self.data
        known = data["identifiability"]
        parts = [html.paragraph(words("tr-determined", columns=known["columns"], rank=known["rank"]))]
        if known["null_space"]:
            parts += [html.element("h3", words("tr-not-told-apart")), *self.null_space(known)]
        if data["not_testable"]:
            rows = [(self.said(t, "effect"), t["needs"]) for t in data["not_testable"]]
            parts.append(html.table([words("tr-column-not-testable"), words("tr-column-needs")], rows))
        if data.get("guarantee"):
            parts.append(html.paragraph(self.guarantee(data["guarantee"])))
        if data["not_identifiable"]:
            parts += [html.element("h3", words("tr-hidden")), _bullets(self.all_said(data, "not_identifiable"))]
        return html.section(words("tr-limits"), *parts)

    def readings(self) -> Html:
        words, data = self.words, self.data
        parts = []
        outliers = data.get("outliers", [])
        if outliers:
            parts.append(html.paragraph(words("tr-outliers", count=len(outliers))))
        notes = []
        for f in data.get("findings", []):
            line = f"{words('line-one', shown=f['line'])}: " if f.get("line") else ""
            notes.append(line + self.said(f, "message"))
        if notes:
            parts.append(_bullets(notes[:40]))
        return html.section(words("tr-remarks"), *parts) if parts else Html("")


def _bullets(items) -> Html:
    return html.element("ul", *(html.element("li", i) for i in items))
