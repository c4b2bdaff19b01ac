# SPDX-License-Identifier: LGPL-2.1-or-later
"""report.html of a sensitivity study: which component spoils the accuracy, for the desk and for the customer.

Its numbers are those of sensitivity.json; its words are messages, in the language that is asked for.
"""

from __future__ import annotations

import datetime
import math

from sensworkbench import __version__
from sensworkbench.core.machine import Machine
from sensworkbench.messages import Message
from sensworkbench.studies.sensitivity import SensitivityResult, kind_message

from . import charts, html, sensitivity_json
from .html import Html
from .words import UNIT_SHOWN, Words, minus, position_text

_ORDINARY_SKEW_DEG = 1e-6


def sensitivity_report(
    study: SensitivityResult, angle_unit: str = "urad", picture: bytes | None = None, language: str = "en"
) -> str:
    """The page of a sensitivity study.  picture : PNG of the coloured machine.  language : of the words."""
    return _Report(study, angle_unit, Words(language)).page(picture)


def index(value: float | None) -> str:
    """An index with four decimals; a dash for one that the objective does not have."""
    return "–" if value is None else f"{value:.4f}"


class _Report:
    """The sections of one page.  data : of sensitivity.json.  words : the language."""

    def __init__(self, study: SensitivityResult, angle_unit: str, words: Words):
        self.study, self.words = study, words
        self.machine: Machine = study.machine
        self.data = sensitivity_json.to_dict(study, angle_unit)
        self.titles = {row["symbol"]: row["title"] for row in sensitivity_json.limits(study.machine, angle_unit)}

    def page(self, picture: bytes | None) -> str:
        words, data = self.words, self.data
        parts = [self.summary()]
        if picture is not None:
            parts.append(html.picture(picture, words("report-picture-alt"), words("report-picture")))
        parts += [self.components(), self.ranking(), self.lever_arms(), self.finding(), self.eq18(), self.settings()]
        name, structure = data["machine"]["name"], data["machine"]["structure"]
        objective = data["settings"]["objective"]
        return html.page(
            words("report-title", machine=name),
            words("report-subtitle", structure=structure, objective=objective, where=self.where()),
            *parts,
            footer=words("report-footer", version=__version__, date=datetime.date.today().isoformat()),
            language=words.language,
        )

    # -- words ---------------------------------------------------------------------------------------------------------
    def where(self) -> str:
        """Where the indices were taken."""
        kind, points = self.data["aggregate"], self.data["points"]
        if kind == "at":
            return self.words("where-at", position=position_text(self.machine.joints, points))
        counts = str(points) if kind == "low_discrepancy" else " × ".join(str(c) for c in points)
        if kind == "grid":
            return self.words("where-grid", counts=counts)
        if kind == "quadrature":
            return self.words("where-quadrature", counts=counts)
        return self.words("where-low-discrepancy", counts=counts)

    def error(self, symbol: str) -> str:
        """What an error of the table is."""
        return self.words.of(self.titles[symbol])

    def body(self, body: str) -> str:
        return self.words.of(self.machine.body_title(body))

    def tolerance(self, row: dict, law: bool = True) -> str:
        """`±20 µrad` or `−1 … 3 µm`, with the distribution where it is not uniform."""
        unit = UNIT_SHOWN.get(row["unit"], row["unit"])
        if row["lower"] == -row["upper"]:
            text = f"±{row['upper']:g} {unit}"
        else:
            text = minus(f"{row['lower']:g} … {row['upper']:g} {unit}")
        if row["distribution"] == "uniform" or not law:
            return text
        return f"{text}, {self.words('law-' + row['distribution'].replace('_', '-'))}"

    # -- sections ------------------------------------------------------------------------------------------------------
    def summary(self) -> Html:
        words, data = self.words, self.data
        worst, error = data["components"][0], data["errors"][0]
        direct = sum(e["first"] for e in data["errors"])
        symbol, meaning = error["symbol"], self.error(error["symbol"])
        leading = words("report-tile-component", total=worst["total"])
        largest = words("report-tile-error", meaning=meaning, tolerance=self.tolerance(error), total=error["total"])
        tiles = [(html.body_label(worst["body"], self.body(worst["body"])), leading), (symbol, largest)]
        square = data["mean_square_um2"]
        if square is not None:
            tiles.append((f"{math.sqrt(square):.2f} µm", words("report-tile-rms")))
        else:
            found = self.study.sensitivity
            size = found.objective.size_shown(found.mean_square)
            unit = "µm" if found.objective.length_unit == "mm" else "µrad"
            tiles.append((f"{size:.2f} {unit}", f"Y = {found.objective.formula}"))
        tiles.append((f"{direct:.0%}", words("report-tile-direct")))
        lead = words(
            "report-lead",
            body=self.body(worst["body"]),
            total=worst["total"],
            symbol=symbol,
            meaning=meaning,
            owner=self.body(error["owner"]),
        )
        parts = [html.paragraph(lead, lead=True), html.tiles(tiles)]
        if direct < 0.5:
            parts.append(html.paragraph(words("report-interaction"), soft=True))
        return html.join(parts)

    def components(self) -> Html:
        words, rows = self.words, self.data["components"]
        largest = max(r["total"] for r in rows)
        chart = charts.bar_chart(
            [self.body(r["body"]) for r in rows],
            [r["first"] for r in rows],
            [r["total"] for r in rows],
            [html.body_colour(r["body"]) for r in rows],
            self._maximum(rows),
            xlabel=words("report-components-axis"),
            alt=words("report-components-alt"),
            words=self.marks(),
        )
        heads = [words("column-component"), "#S", "#Sᵀ", f"#{words('column-share')}"]
        heads += [f"#{words('column-largest')}", f"#{words('column-weighted')}"]
        cells = [
            (
                html.body_label(r["body"], self.body(r["body"])),
                *(index(r[k]) for k in ("first", "total", "share", "total_max", "total_variance_weighted")),
                html.meter(r["total"], r["first"], largest),
            )
            for r in rows
        ]
        table = html.table([*heads, ""], cells)
        explained = html.paragraph(words("report-components-words"), soft=True)
        return html.section(words("report-components"), explained, *_figure(chart), table)

    def marks(self) -> tuple[str, str, str]:
        """What the parts of a bar are."""
        return self.words("chart-first"), self.words("chart-total"), self.words("chart-largest")

    def _maximum(self, rows) -> list[float] | None:
        return None if self.data["aggregate"] == "at" else [r["total_max"] for r in rows]

    def ranking(self) -> Html:
        words = self.words
        rows = [r for r in self.data["errors"] if r["total"] > 0 or r["upper"] != r["lower"]]
        still = len(self.data["errors"]) - len(rows)
        largest = max(r["total"] for r in rows)
        owners = [
            b
            for b in (*self.machine.bodies, *(s.name for s in self.machine.sources))
            if any(r["owner"] == b for r in rows)
        ]
        chart = charts.bar_chart(
            [f"{r['symbol']}   {self.tolerance(r, law=False)}" for r in rows],
            [r["first"] for r in rows],
            [r["total"] for r in rows],
            [html.body_colour(r["owner"]) for r in rows],
            self._maximum(rows),
            legend={self.body(b): html.body_colour(b) for b in owners},
            xlabel=words("report-ranking-axis"),
            alt=words("report-ranking-alt"),
            words=self.marks(),
        )
        heads = ["#", words("column-error"), words("column-meaning"), f"#{words('column-tolerance')}", "#S", "#Sᵀ"]
        heads += [f"#{words('column-share')}", f"#{words('column-largest')}", words("column-owner"), ""]
        cells = [
            (
                i,
                r["symbol"],
                self.error(r["symbol"]),
                self.tolerance(r),
                *(index(r[k]) for k in ("first", "total", "share", "total_max")),
                html.body_label(r["owner"]),
                html.meter(r["total"], r["first"], largest),
            )
            for i, r in enumerate(rows, start=1)
        ]
        note = [html.paragraph(words("report-ranking-still", count=still), soft=True)] if still else []
        note += [
            html.note(words("report-ranking-without-extent", effect=row["effect"], why=Message(row["code"])))
            for row in self.data["without_extent"]
        ]
        return html.section(words("report-ranking"), *_figure(chart), html.table(heads, cells), *note)

    def lever_arms(self) -> Html:
        words, arms = self.words, self.data["lever_arms_mm"]
        position = position_text(self.machine.joints, arms["position"])
        rows = [
            (
                html.body_label(b, self.body(b)),
                *(minus(f"{v:.3f}") for v in arms[b]),
                f"{math.hypot(*arms[b]):.1f}",
            )
            for b in self.machine.bodies
        ]
        skew = {k: v for k, v in self.data["skew_deg"].items() if abs(v) > _ORDINARY_SKEW_DEG}
        pairs = ", ".join(f"{k[0]}-{k[1]} {v:+.4f}°" for k, v in skew.items())
        notes = [html.note(words("report-skew", pairs=pairs))] if skew else []
        notes += [html.note(words.of(m)) for m in self.study.remarks]
        heads = [words("column-body"), "#x, mm", "#y, mm", "#z, mm", f"#{words('column-length')}"]
        explained = html.paragraph(words("report-arms-words", position=position), soft=True)
        return html.section(words("report-arms"), explained, html.table(heads, rows), *notes)

    def finding(self) -> Html:
        words, both = self.words, self.study.conventions
        used = self.machine.squareness
        used_here = words("report-used-here")
        names = {c: f'"{c}"{" " + used_here if c == used else ""}' for c in both}
        stated = "; ".join(f'"{c}": {self._convention(c)}' for c in both)
        columns = [f"#Sᵀ, {names[c]}" for c in both]
        kinds = list(next(iter(both.values())).kinds)
        rows = [(words.of(kind_message(k)), *(index(both[c].kinds[k].total) for c in both)) for k in kinds]
        table = html.table([words("column-kind"), *columns], rows, words("report-finding-table"))
        totals = {c: dict(zip(v.sensitivity.symbols, v.sensitivity.total.tolist())) for c, v in both.items()}
        leading = [s for c in both for s in self.data["squareness_conventions"][c]["largest"]]
        shown = list(dict.fromkeys([*leading, *(s for s in self.machine.line_symbols if s in totals[used])]))
        chart = charts.grouped_bars(
            shown,
            {names[c]: [totals[c][s] for s in shown] for c in both},
            xlabel=words("report-finding-axis"),
            alt=words("report-finding-alt"),
        )
        if chart is None:
            cells = [(s, *(index(totals[c][s]) for c in both)) for s in shown]
            leaders = [html.table([words("column-error"), *columns], cells)]
        else:
            leaders = _figure(chart, words("report-finding-figure"))
        verdicts = [
            html.paragraph(
                words("report-finding-verdict", convention=names[c], finding=" ".join(map(words.of, v.finding)))
            )
            for c, v in both.items()
        ]
        explained = html.paragraph(words("report-finding-words", conventions=stated))
        return html.section(words("report-finding"), explained, table, *leaders, *verdicts)

    def _convention(self, name: str) -> str:
        return self.words("convention-carried") if name == "carried" else self.words("convention-direction")

    def eq18(self) -> Html:
        words, paper = self.words, self.data["paper_eq18"]
        if paper is None:
            return Html("")
        order = sorted(range(len(paper["symbols"])), key=lambda i: -paper["total"][i])
        rows = [(paper["symbols"][i], index(paper["total"][i]), index(paper["as_printed"][i])) for i in order[:6]]
        shown = [j.to_shown(v) for j, v in zip(self.machine.joints, paper["position"])]
        explained = html.paragraph(
            words(
                "report-eq18-words",
                dropped=paper["variance_um4_eq15a"],
                exact=paper["variance_um4"],
                position=position_text(self.machine.joints, shown),
            ),
            soft=True,
        )
        heads = [words("column-error"), f"#{words('column-exact')}", f"#{words('column-printed')}"]
        return html.section(words("report-eq18"), explained, html.table(heads, rows))

    def settings(self) -> Html:
        words, data = self.words, self.data
        s = data["settings"]
        output = words("output-orientation") if s["output"] == "orientation" else words("output-position")
        pairs = [
            (words("setting-objective"), f"Y = {s['objective']} ({output})"),
            (words("setting-positions"), self.where()),
            (words("setting-travel"), self._travel()),
            (words("setting-squareness"), f'"{s["squareness"]}": {self._convention(s["squareness"])}'),
            (words("setting-names"), "ISO 230-1, ISO 230-7"),
            (words("setting-sign"), words("setting-sign-words")),
            (words("setting-frame"), words("setting-frame-words")),
            (words("setting-arm"), words("setting-arm-words")),
            (words("setting-model"), words("setting-model-words")),
            ("S", data["conventions"]["first"]),
            ("Sᵀ", words("setting-total-words")),
        ]
        if data["estimated_error"] is not None:
            size = f"{data['estimated_error']:.1e}"
            pairs.insert(2, (words("setting-error"), words("setting-error-words", size=size)))
        for key, value in data.items():
            if value is not None and key.startswith(("mean_", "variance_")):
                name = "E[Y]" if key.startswith("mean") else "V(Y)"
                unit = key.rpartition("_")[2].replace("urad", "µrad").replace("um", "µm")
                unit = unit.replace("2", "²").replace("4", "⁴")
                pairs.append((name, f"{value:.6g} {unit}"))
        return html.section(words("report-settings"), html.facts(pairs))

    def _travel(self) -> str:
        words = []
        for j in self.machine.joints:
            span = (
                self.words("travel-endless")
                if j.travel is None
                else minus("{:g} … {:g}".format(*map(j.to_shown, j.travel)))
            )
            words.append(f"{j.name} {span} {j.unit}")
        return ", ".join(words)


def _figure(chart: Html | None, caption: str = "") -> list[Html]:
    return [] if chart is None else [html.figure(chart, caption)]
