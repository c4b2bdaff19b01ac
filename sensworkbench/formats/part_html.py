# SPDX-License-Identifier: LGPL-2.1-or-later
"""report.html of a part: its features, who makes them, and what of the program was not read.

Its numbers are those of part.json; its words are messages, in the language that is asked for.
"""

from __future__ import annotations

import datetime
from collections.abc import Mapping, Sequence

from sensworkbench import __version__
from sensworkbench.messages import Message
from sensworkbench.studies.part import CHECKED, PartResult
from sensworkbench.studies.part_features import DRAWS
from sensworkbench.studies.part_words import unsure

from . import html, part_charts
from .html import Html
from .words import Words, position_text

_ROWS = 12  # of a table of shares
_SHOWN = 5e-4  # a share below it is 0.000
_BLOCKS = 30


def part_report(
    data: Mapping, result: PartResult, language: str = "en", picture: bytes | None = None, motion: Sequence[bytes] = ()
) -> str:
    """The page for the data of part.json and its result.  language : of the words.  picture : PNG of the part, and
    motion : GIF or PNG stills of how the machine moves, where there is a window."""
    return _Report(data, result, Words(language), picture, motion).page()


def micrometres(value) -> str:
    """A number of um for a table; empty where there is none."""
    return "" if value is None else f"{value:.3g}" if abs(value) < 100 else f"{value:.0f}"


class _Report:
    """The sections of one page."""

    def __init__(self, data: Mapping, result: PartResult, words: Words, picture=None, motion=()):
        self.data, self.result, self.words = data, result, words
        self.picture, self.motion = picture, motion
        self.unsure = {f.feature.name: unsure(result, f) for f in result.features}
        self.tolerances = data["errors"] == "tolerances"

    def page(self) -> str:
        words, data = self.words, self.data
        machine = data["machine"]
        return html.page(
            words("part-title", path=data["path"]),
            words("part-subtitle-tolerances" if self.tolerances else "part-subtitle", machine=machine),
            self.summary(),
            self.pictures(),
            self.features(),
            *(self.feature(f, g) for f, g in zip(data["features"], self.result.features)),
            self.corrected(),
            self.path(),
            self.outside(),
            self.unread(),
            self.remarks(),
            footer=f"Sens Workbench {__version__}, {datetime.date.today().isoformat()}.",
            language=words.language,
        )

    def summary(self) -> Html:
        words, data = self.words, self.data
        tiles = [
            (f"{micrometres(data['error']['rms_um'])} µm", words("part-tile-rms")),
            (f"{micrometres(data['error']['max_um'])} µm", words("part-tile-max")),
        ]
        judged = [f["within"] for f in data["features"] if f["within"] is not None]
        if judged:
            tiles.append((f"{sum(judged)} / {len(judged)}", words("part-tile-within")))
        if data["outside_travel"]:
            blocks = len({o["line"] for o in data["outside_travel"]})
            tiles.append((str(blocks), words("part-tile-outside")))
        return html.tiles(tiles)

    def pictures(self) -> Html:
        words, parts = self.words, []
        if self.picture is not None:
            parts.append(html.picture(self.picture, words("part-view-alt"), words("part-view-caption")))
        parts += [html.picture(still, words("part-motion-alt"), words("part-motion-caption")) for still in self.motion]
        return html.section(words("part-view-alt"), *parts) if parts else Html("")

    def who(self, feature: Mapping, count: int = 2) -> str:
        if self.unsure[feature["name"]]:
            return self.words(self.unsure[feature["name"]])
        ranked = sorted(feature["shares"].items(), key=lambda item: -item[1])[:count]
        return ", ".join(f"{label} {share:.0%}" for label, share in ranked)

    def features(self) -> Html:
        words, data = self.words, self.data
        if not data["features"]:
            return html.paragraph(words("part-no-features"), soft=True)
        columns = [words("part-column-feature"), words("part-column-kind"), "#" + words("part-column-value") + " µm",
                   "#u µm"]  # fmt: skip
        columns += ["#" + words("part-column-quantile", level=data["settings"]["level"])] if self.tolerances else []
        columns += ["#" + words("part-column-limit"), "", words("part-column-who")]
        rows = []
        for f in data["features"]:
            verdict = "" if f["within"] is None else words("part-verdict-in" if f["within"] else "part-verdict-out")
            row = [f["name"], f["kind"], micrometres(f["value_um"]), micrometres(f["u_um"])]
            row += [micrometres(f["quantile_um"])] if self.tolerances else []
            rows.append([*row, micrometres(f["limit_um"]), verdict, self.who(f)])
        code = "part-features-words-tolerances" if self.tolerances else "part-features-words"
        about = html.paragraph(words(code, draws=DRAWS), soft=True)
        return html.section(words("part-features"), html.table(columns, rows), about)

    def feature(self, data: Mapping, found) -> Html:
        words = self.words
        large = [item for item in data["shares"].items() if abs(item[1]) >= _SHOWN]
        ranked = sorted(large, key=lambda item: -abs(item[1]))[:_ROWS]
        owner = dict(zip(self.result.labels, self.result.owners))
        largest = max([abs(s) for _, s in ranked], default=1.0)
        rows = [
            [html.body_label(owner[label], label), f"{share:.3f}", html.meter(abs(share), abs(share), largest)]
            for label, share in ranked
        ]
        parts = []
        drawn = part_charts.shape_chart(self.result, found, words("part-shape-alt", feature=data["name"]))
        if drawn is not None:
            parts.append(html.figure(drawn[0], words("part-shape-caption", times=drawn[1])))
        columns = [words("part-column-error"), "#" + words("part-column-share"), ""]
        if self.unsure[data["name"]]:
            parts.append(html.paragraph(words(self.unsure[data["name"]]), soft=True))
        else:
            parts.append(html.table(columns, rows, words("part-shares-words", feature=data["name"])))
        place = position_text(self.result.machine.joints, data["worst_at"])
        where = f"{words('part-column-where')} {place} ({words('part-column-line')} {data['worst_line']})"
        parts.append(html.paragraph(where, soft=True))
        title = f"{data['name']}: {data['kind']} {micrometres(data['value_um'])} µm"
        return html.section(title, *parts)

    def corrected(self) -> Html:
        words, said = self.words, self.data.get("correction")
        if not said:
            return Html("")
        fields = {k: said[k] for k in ("file", "blocks", "segments")}
        sizes = {k: said[f"{k}_um"] for k in ("tolerance", "largest", "before", "after")}
        parts = [html.paragraph(words("part-corrected-words", **fields, **sizes))]
        if said["uncertainty_um"] is not None:
            parts.append(html.paragraph(words("part-corrected-fitted", u=said["uncertainty_um"])))
        if said["clipped"]:
            text = words("part-corrected-clipped", count=said["clipped"], limit=said["limit_um"])
            parts.append(html.note(text))
        columns = [words("part-column-feature"), "#" + words("part-column-before") + " µm",
                   "#" + words("part-column-after") + " µm"]  # fmt: skip
        rows = [[f["name"], micrometres(f["before_um"]), micrometres(f["after_um"])] for f in said["features"]]
        parts += [html.table(columns, rows)] if rows else []
        if said["tables"]:
            columns = [words("part-column-format"), "#" + words("part-column-left") + " µm"]
            rows = [[t["format"], micrometres(t["after_um"])] for t in said["tables"]]
            title = words("part-corrected-tables", before=said["tables"][0]["before_um"])
            parts.append(html.table(columns, rows, title))
        return html.section(words("part-corrected"), *parts)

    def path(self) -> Html:
        words = self.words
        chart = part_charts.path_chart(self.result, words("part-point-number"), words("part-path-alt"))
        if chart is None:
            return Html("")
        return html.figure(chart, words("part-path-caption"))

    def outside(self) -> Html:
        words, found = self.words, self.data["outside_travel"]
        if not found:
            return Html("")
        columns = ["#" + words("part-column-line"), words("part-column-joint"), "#" + words("part-column-by")]
        rows = [[str(o["line"]), o["joint"], f"{o['by']:.4g} {o['unit']}"] for o in found[:_BLOCKS]]
        return html.section(words("part-outside"), html.table(columns, rows))

    def unread(self) -> Html:
        words, found = self.words, self.data["unread_words"]
        if not found:
            return Html("")
        columns = [words("part-column-word"), "#" + words("part-column-line"), "#" + words("part-column-count")]
        rows = [[u["word"], str(u["line"]), str(u["count"])] for u in found[:_BLOCKS]]
        about = html.paragraph(words("part-unread-words"), soft=True)
        return html.section(words("part-unread"), html.table(columns, rows), about)

    def remarks(self) -> Html:
        words, data = self.words, self.data
        texts = [
            Message(m["code"], **{k: v for k, v in m.items() if k not in ("code", "text")}).text(words.language)
            for m in data["remarks"]
        ]
        if data["assumed"]:
            texts.append(words("part-assumed", codes=data["assumed"]))
        if self.tolerances and data["error"]["quantile_error"] is not None:
            texts.append(words("part-quantile-error", places=CHECKED, error=data["error"]["quantile_error"]))
        if not texts:
            return Html("")
        return html.section(words("part-remarks"), *(html.paragraph(t) for t in texts))
