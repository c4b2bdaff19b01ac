# SPDX-License-Identifier: LGPL-2.1-or-later
"""report.html of a measuring plan: what it could find, what it could not, and what would make it better.

The words and numbers are those of plan.json.
"""

from __future__ import annotations

import datetime
from collections.abc import Mapping

from sensworkbench import __version__
from sensworkbench.closedloop import plan as planning
from sensworkbench.closedloop.settings import DEFAULT
from sensworkbench.core.shapes import SHAPES

from . import charts, html
from .html import Html
from .trace_html import driver_words, um, unit_words

SUGGESTED = "positions_suggested.csv"
_ROWS = 30  # of a long table
_COMPARED = (
    ("places", "Places", ""),
    ("readings", "Readings", ""),
    ("rank", "Parameters determined", ""),
    ("parameters", "Parameters in the declared model", ""),
    ("physical_effects_testable", "Named physical effects that could be found", ""),
    ("candidates_named_visible", "Candidates behind these names that would show", ""),
    ("median_detectable_um", "Median of the smallest rms that is found, µm", "um"),
    ("prediction_um", "Standard uncertainty of the predicted declared error, µm (3-D)", "um"),
    ("prediction_longer_tool_um", f"The same with a tool {planning.LONGER_MM:g} mm longer, µm", "um"),
    ("aliased_leads", "Usual screw leads that are aliased", ""),
    ("pure_error_dof", "Degrees of freedom of the pure error", ""),
)


def number_words(value, unit: str) -> str:
    """Return a number with its unit for a table; None is "not at all"."""
    if value is None:
        return "not at all"
    return f"{value:.2g} {unit}" if unit else f"{value:g}"


def plan_report(data: Mapping) -> str:
    """The page for the data of plan.json."""
    n, tools = data["numbers"], data["tools"]
    kind = "" if data["judged"] == "given" else " suggested"
    lead = (
        f"Of {n['parameters']} parameters of the declared model this plan determines {n['rank']}. "
        f"Of {len(data['effects'])} named physical effects it could find {n['physical_effects_testable']}"
    )
    lead += f"; {len(data['advice'])} changes would improve it." if data["advice"] else "; nothing tried improves it."
    median = n["median_detectable_um"]
    tiles = [
        (f"{n['rank']} of {n['parameters']}", "parameters determined"),
        (f"{n['physical_effects_testable']} of {len(data['effects'])}", "named physical effects that could be found"),
        ("–" if median is None else f"{um(median)} µm", f"rms found (median) at {data['noise_um']:g} µm noise"),
        (str(n["aliased_leads"]), f"of {len(data['periods'])} usual screw leads aliased"),
    ]
    parts = [
        html.join([html.paragraph(lead, lead=True), html.tiles(tiles)]),
        _advice(data),
        _comparison(data),
        _effects(data),
        _missing(data),
        _pairs(data),
        _periods(data),
        _identifiability(data),
        _remarks(data),
    ]
    return html.page(
        f"{data['machine']}: check of a{kind} measuring plan",
        f"{n['places']} places, {n['readings']} readings, {tools} tool{'s' if tools > 1 else ''}, "
        f"structure {data['structure']}. No reading has been taken.",
        *parts,
        footer=f"Sens Workbench {__version__}, {datetime.date.today().isoformat()}. Detected: beyond a family-wise p "
        f"of {DEFAULT.alpha:g} over {data['threshold']['candidates']} candidates with a chance of "
        f"{DEFAULT.power:.0%}, and above {DEFAULT.floor:g} of one reading's noise.",
    )


def _advice(data) -> Html:
    if not data["advice"]:
        return Html("")
    rows = [
        (
            html.join([html.element("b", _upper(a["do"])), *([". " + _upper(a["why"])] if a["why"] else [])]),
            a["improves"],
            number_words(a["before"], unit_words(a["unit"])),
            number_words(a["after"], unit_words(a["unit"])),
        )
        for a in data["advice"]
    ]
    words = "Each change was made to this plan, on its own and with as many readings, and the result judged again."
    table = html.table(["Change", "Number that it improves", "#Now", "#Then"], rows)
    return html.section("What would make this plan better", html.paragraph(words, soft=True), table)


def _upper(words: str) -> str:
    return words[:1].upper() + words[1:]


def _comparison(data) -> Html:
    if data["judged"] != "given" or data["suggested"] is None:
        return Html("")

    def cell(value, unit):
        return "not determined" if value is None else um(value) if unit else f"{value:g}"

    rows = [(w, cell(data["numbers"][k], u), cell(data["suggested"]["numbers"][k], u)) for k, w, u in _COMPARED]
    words = (
        f"{SUGGESTED}: places at random over the travel, approached from both sides, in random order, with a second "
        "tool length and a probe to the side, some of them visited again. Each further tool has an offset of its own "
        "in the model: more parameters from as many readings. Temperatures and other conditions are those "
        "of the given plan; log the real ones."
    )
    parts = [html.paragraph(words, soft=True), html.table(["", "#Given plan", "#Suggested plan"], rows)]
    return html.section("A plan that sees more", *parts)


def _effects(data) -> Html:
    rows = []
    for e in data["effects"]:
        p = e["plainest"]
        if p is None:
            continue
        least = "hidden" if p["smallest"] is None else _size_words(p["smallest"])
        rows.append(
            (
                e["name"],
                f"{p['component']} by {driver_words(p['driver'])}"
                + ("" if SHAPES[p["shape"]].proportional else f" ({p['shape']})"),
                f"{p['visible_share']:.0%}",
                html.meter(p["visible_share"], p["visible_share"]),
                least,
                um(p["smallest_um"]),
                unit_words(e["usual_size"]),
                f"{e['visible']} of {e['candidates']}",
            )
        )
    columns = ["Effect", "Plainest candidate", "#Visible", "", "#Smallest found", "#rms, µm", "Usual size", "#Shown"]
    words = (
        "Visible: the share of the effect that the declared model cannot imitate on these places; below "
        f"{DEFAULT.visible:.0%} it is hidden. Smallest found: the coefficient, and the rms at the tool over the "
        f"readings, that would be detected at {data['noise_um']:g} µm noise. Shown: candidates (component × driver × "
        "shape) under this name that would show; candidates.csv lists every one, with those that have no name."
    )
    parts = [html.paragraph(words, soft=True), html.table(columns, rows)]
    chart = _chart(data)
    if chart is not None:
        parts.append(html.figure(chart, "Share of each named effect's plainest candidate that would show."))
    return html.section("What could be found", *parts)


def _size_words(entry) -> str:
    value, unit = entry["value"], entry["unit"]
    for power in (3, 2, 1):  # per metre reads better than per millimetre
        for tail in (f"mm^{power}", f"mm^{power})") if power > 1 else ("mm", "mm)"):
            if unit.endswith(tail):
                value, unit = value * 1e3**power, unit.removesuffix(tail) + tail.replace("mm", "m")
                return f"{value:.3g} {unit_words(unit)}"
    return f"{value:.3g} {unit_words(unit)}"


def _chart(data) -> Html | None:
    if data["judged"] != "given" or data["suggested"] is None or not charts.available():
        return None
    then = {e["name"]: e for e in data["suggested"]["effects"]}
    share = lambda e: 0.0 if e["plainest"] is None else e["plainest"]["visible_share"]  # noqa: E731
    names = [e["name"] for e in data["effects"] if share(e) > 0 or share(then[e["name"]]) > 0]
    given = {e["name"]: share(e) for e in data["effects"]}
    series = {"given plan": [given[n] for n in names], "suggested plan": [share(then[n]) for n in names]}
    return charts.grouped_bars(names, series, "visible share", alt="Visible share of each effect in both plans")


def _missing(data) -> Html:
    parts = []
    if data["not_testable"]:
        rows = [(t["effect"], t["needs"]) for t in data["not_testable"]]
        parts.append(html.table(["Not testable", "Needs a column that varies"], rows))
    hidden: dict[str, list[str]] = {}
    for c in data["hidden"]:
        hidden.setdefault(c["name"], []).append(f"{c['component']} by {driver_words(c['driver'])}")
    if hidden:
        rows = [(k, "; ".join(v[:12]) + (f" … {len(v)} in all" if len(v) > 12 else "")) for k, v in hidden.items()]
        parts.append(html.table(["Hidden by the declared model", "Candidates"], rows))
    return html.section("What could not be found", *parts) if parts else Html("")


def _pairs(data) -> Html:
    if not data["confused"]:
        return html.section("What could not be told apart", html.paragraph("No pair of named candidates."))
    rows = [
        (
            _listed([driver_words(d) for d in p["drivers"]]),
            _listed(p["components"]),
            _listed(p["effects"], 3),
            f"{p['cosine']:.3f}",
            p["count"],
        )
        for p in data["confused"][:_ROWS]
    ]
    words = (
        f"Pairs of named candidates whose traces in these readings, beside the declared model, have a |cosine| above "
        f"{DEFAULT.same:g}. With strong evidence even .996 is told apart, so this is for planning only."
    )
    parts = [
        html.paragraph(words, soft=True),
        html.table(["Drivers", "Components", "Effects", "#Least |cosine|", "#Pairs"], rows),
    ]
    if len(data["confused"]) > _ROWS:
        parts.append(html.paragraph(f"… and {len(data['confused']) - _ROWS} more in plan.json.", soft=True))
    return html.section("What could not be told apart", *parts)


def _listed(words, most: int = 4) -> str:
    return ", ".join(words[:most]) + (f" … {len(words)} in all" if len(words) > most else "")


def _periods(data) -> Html:
    rows = [
        (
            p["axis"].upper(),
            f"{p['lead_mm']:g}",
            f"{p['visible']:.0%}",
            "a constant" if p["looks_like_mm"] == "constant" else f"a period of {p['looks_like_mm']:.4g} mm",
        )
        for p in data["periods"]
        if p["looks_like_mm"] is not None
    ]
    if not rows:
        words = "No alias: the spacing of the places tells the usual screw leads from every other period."
        return html.section("Periods", html.paragraph(words))
    table = html.table(["Axis", "#Screw lead, mm", "#Visible", "Looks in this plan like"], rows)
    return html.section("Periods", html.paragraph("The places stand on a regular grid.", soft=True), table)


def _identifiability(data) -> Html:
    known = data["identifiability"]
    bullets = lambda items: html.element("ul", *(html.element("li", i) for i in items))  # noqa: E731
    parts = []
    if known["null_space"]:
        parts += [html.element("h3", "Not told apart by this plan"), bullets(known["null_space"])]
    else:
        parts.append(html.paragraph("Every parameter of the declared model is determined."))
    if known["move_alike"]:
        words = "Whatever the plan, no reading at the tool tells these apart (only their drivers do): "
        listed = "; ".join(", ".join(g) for g in known["move_alike"])
        parts.append(html.paragraph(words + listed + "."))
    if known["no_reading_shows"]:
        parts.append(html.paragraph(f"No reading shows {', '.join(known['no_reading_shows'])}."))
    return html.section("The declared model", *parts)


def _remarks(data) -> Html:
    notes = [f"line {f['line']}: {f['message']}" if f["line"] else f["message"] for f in data["findings"]]
    if not notes:
        return Html("")
    return html.section("Remarks on the table", html.element("ul", *(html.element("li", t) for t in notes[:40])))
