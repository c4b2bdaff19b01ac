# SPDX-License-Identifier: LGPL-2.1-or-later
"""report.html of a trace: the verdict, the error before and after, each finding with its evidence and its rivals.

The words and numbers are those of trace.json; the pictures are drawn from the residuals of the readings.
"""

from __future__ import annotations

import datetime
from collections.abc import Mapping

import numpy as np

from sensworkbench import __version__
from sensworkbench.core.driver import Driver
from sensworkbench.core.errors import COMPONENTS, component
from sensworkbench.studies.trace import component_values, point_vectors

from . import charts, html, trace_json
from .html import Html

STAGES = {
    "uncorrected": "Uncorrected (set-up aligned)",
    "declared": "Declared model",
    "augmented": "With the traced effects",
}
VERDICTS = {
    "nothing_to_explain": (
        "Nothing to explain",
        "The declared errors account for the readings down to their noise, or to below the floor.",
    ),
    "explained": ("Explained", "What remains after the named effects is below the floor."),
    "partly_explained": (
        "Partly explained",
        "Something is named, but more is left than noise, or its driver was not logged.",
    ),
    "unexplained": (
        "Unexplained",
        "There is structure that the declared model lacks, and no name survives the tests.",
    ),
}
_UNITS = (("urad", "µrad"), ("um", "µm"), ("_", " "))
_SHOWN = 12


def unit_words(unit: str) -> str:
    """`µrad/K` of `urad/K`."""
    for plain, shown in _UNITS:
        unit = unit.replace(plain, shown)
    return unit


def trace_report(data: Mapping, outcome=None) -> str:
    """The page for the data of trace.json; outcome : the `TraceEvidence` that its pictures are drawn from, or None."""
    data = trace_json.attached(data)
    title, words = VERDICTS[data["verdict"]]
    structure = "" if outcome is None else f" Structure {outcome.machine.structure} (workpiece to tool, F: bed)."
    name = "Readings" if outcome is None else outcome.machine.name
    parts = [
        _summary(data, title, words),
        _findings(data, outcome),
        _before_and_after(data, outcome),
        _remainder(data),
        _next(data),
        _sensitivity_shift(data),
        _parameters(data),
        _limits(data),
        _readings(data),
    ]
    return html.page(
        f"{name}: {title.lower()}",
        f"Fit of the declared errors, search for what they lack, and the error before and after.{structure}",
        *parts,
        footer=f"Sens Workbench {__version__}, {datetime.date.today().isoformat()}. Seed {data.get('seed', 0)}, "
        f"{data.get('permutations', '')} permutations, floor {data['floor']:g} of one reading's noise.",
    )


def um(value) -> str:
    """A length in um with sense in its digits, or a dash."""
    return "–" if value is None else f"{value:.3g}" if abs(value) < 100 else f"{value:.0f}"


def _summary(data, title, words) -> Html:
    error = data["error"]
    held = {stage: error[stage]["held_out"]["rms_um"] for stage in STAGES}
    tiles = [(title, words)]
    tiles += [(f"{um(held[s])} µm", f"{STAGES[s]}: rms on readings that took no part") for s in STAGES]
    named = [e for e in data["effects"] if e["driver"] != "unlogged"]
    lead = words
    if named:
        listed = "; ".join(f"{e['name']} ({e['component']})" for e in named)
        lead = f"{words} Found: {listed}."
    return html.join([html.paragraph(lead, lead=True), html.tiles(tiles)])


def driver_words(driver: str) -> str:
    """`temp_column × y` of `temp_column*y`."""
    return Driver.of(driver).words()


def parameter_words(entry) -> str:
    """`−8.98 ± 0.02 µrad/K`."""
    if not isinstance(entry, Mapping):
        return f"{entry:.4g}" if isinstance(entry, (int, float)) else str(entry)
    values, spread = entry["value"], entry.get("u")
    several = isinstance(values, (list, tuple))
    values = list(values) if several else [values]
    spread = list(spread) if isinstance(spread, (list, tuple)) else [spread] * len(values) if not several else []
    spread += [None] * (len(values) - len(spread))
    words = [f"{v:.4g}" + ("" if u is None else f" ± {u:.2g}") for v, u in zip(values, spread)]
    if len(words) > 6:
        words = [*words[:6], f"… {len(words)} in all"]
    return (", ".join(words) + " " + unit_words(entry.get("unit", ""))).replace("-", "−").strip()


def p_words(p: float, data) -> str:
    """A p-value, or that it is below what so few permutations can show."""
    count = data.get("permutations")
    if count and p <= 1.0001 / (count + 1):
        return f"≤ {p:.2g} (the smallest that {count} permutations can show)"
    return f"{p:.2g}"


def _findings(data, outcome) -> Html:
    if not data["effects"]:
        return Html("")
    parts = []
    for number, e in enumerate(data["effects"], start=1):
        what = COMPONENTS[e["component"]].description if e["component"] in COMPONENTS else e["component"]
        pairs = [
            ("Component", f"{e['component']}, {what}"),
            ("Driver", driver_words(e["driver"])),
            ("Shape", e["shape"]),
            *((k.capitalize(), parameter_words(v)) for k, v in e["parameters"].items()),
            ("Amplitude", f"{um(e['amplitude_um'])} µm (3-D rms over the readings)"),
            ("Family-wise p", p_words(e["p_familywise"], data)),
            ("Found again in half-samples", f"{e['selection_frequency']:.0%}"),
        ]
        if e.get("usual_size"):
            pairs.append(("Usual size", unit_words(e["usual_size"])))
        if e.get("check"):
            pairs.append(("Check on the machine", e["check"]))
        parts += [html.element("h3", f"{number}. {e['name']}"), html.facts(pairs)]
        if e.get("note"):
            parts.append(html.note(e["note"]))
        chart = _driver_chart(e, outcome)
        if chart is not None:
            caption = (
                "Each point: the component's value that its reading asks for, after everything else is taken away; "
                "line: the effect as fitted. Readings with a short lever arm are left out."
            )
            parts.append(html.figure(chart, caption))
        if e["rivals"]:
            rows = [(r["component"], driver_words(r["driver"]), r["shape"], r["why"]) for r in e["rivals"]]
            caption = "Rivals: what these readings cannot tell from the finding"
            parts.append(html.table(["Component", "Driver", "Shape", "Why it remains"], rows, caption))
        else:
            parts.append(
                html.paragraph("No rival: nothing else that was searched explains these readings as well.", soft=True)
            )
    return html.section("Findings", *parts)


def _driver_chart(entry, outcome) -> Html | None:
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
    series = {"asked for by the readings": asked}
    if not single_valued:
        series["effect as fitted"] = fitted
    line = (driver[order], fitted[order]) if single_valued else None
    label = driver_words(effect.driver)
    per = effect.driver_unit
    if per:
        label += f", {unit_words(per)}" + (" above 20 °C" if per == "K" else "")
    alt = f"{effect.component} against {label}"
    return charts.scatter(driver, series, label, f"{effect.component}, {unit}", line=line, alt=alt)


def _before_and_after(data, outcome) -> Html:
    error = data["error"]
    rows = []
    for stage, words in STAGES.items():
        for part, name in (("in_sample", "in sample"), ("held_out", "held out")):
            m = error[stage][part]
            low, high = m.get("rms_interval_um", (None, None))
            span = "" if low is None else f"{um(low)} … {um(high)}"
            each = [um(m.get(f"rms_{a}_um")) for a in "xyz"]
            rows.append((words, name, um(m["rms_um"]), span, um(m["p95_um"]), um(m["max_um"]), *each))
    columns = [
        "Model",
        "Readings",
        "#rms",
        "#95 % interval",
        "#95th percentile",
        "#Largest",
        "#rms x",
        "#rms y",
        "#rms z",
    ]
    parts = [html.table(columns, rows, "3-D error of the points, µm; the last three: per direction of sensing")]
    if error.get("note"):
        parts.append(html.paragraph(error["note"][:1].upper() + error["note"][1:] + ".", soft=True))
    if outcome is not None and charts.available():
        before, after = point_vectors(outcome, "declared_held_out"), point_vectors(outcome, "augmented_held_out")
        sizes = {
            STAGES["declared"]: np.linalg.norm(before, axis=1),
            STAGES["augmented"]: np.linalg.norm(after, axis=1),
        }
        alt = "Error of the points before and after"
        parts.append(html.figure(charts.histogram(sizes, "error of a held-out point, µm", alt=alt), "Held-out points."))
        views = charts.arrows(
            outcome.readings.q,
            {STAGES["declared"]: before, STAGES["augmented"]: after},
            alt="Residual vectors in the workspace before and after",
        )
        parts.append(html.figure(views, "Residual of held-out points in the workspace, both on one scale."))
    return html.section("Error before and after", *parts)


def _remainder(data) -> Html:
    noise, rest = data["noise"], data.get("remainder", {})
    pairs = [
        ("Stated uncertainty", "not stated" if noise["stated_um"] is None else f"{um(noise['stated_um'])} µm"),
        (
            "Pure error from repeats",
            "no repeats" if noise["pure_error_um"] is None else f"{um(noise['pure_error_um'])} µm",
        ),
        ("Residual of one reading", f"{um(noise['residual_um'])} µm"),
    ]
    if rest:
        pairs.append(("What is left", rest["words"]))
        if rest.get("p") is not None:
            pairs.append(("p that it is noise", p_words(rest["p"], data)))
    if data["depends_on"]:
        listed = ", ".join(f"{d['column']} (p: {p_words(d['p'], data)})" for d in data["depends_on"])
        pairs.append(("The residual of the declared model depends on", listed))
    parts = [html.facts(pairs)]
    if data.get("refused_names"):
        rows = [(r["component"], driver_words(r["driver"]), r["shape"], r["why"]) for r in data["refused_names"]]
        caption = "Significant, but not named"
        parts.append(html.table(["Component", "Driver", "Shape", "Why it carries no name"], rows, caption))
    return html.section("Noise and what remains", *parts)


def _next(data) -> Html:
    if not data["next_measurements"]:
        return Html("")
    rows = [
        (" / ".join(str(s) for s in m["separates"]), m["do"], um(m["predicted_difference_um"]))
        for m in data["next_measurements"]
    ]
    return html.section("What to measure next", html.table(["Separates", "Do", "#Predicted difference, µm"], rows))


def _sensitivity_shift(data) -> Html:
    rows = [r for r in data["sensitivity_shift"] if r.get("after") is not None][:10]
    if not data["effects"] or not rows:
        return Html("")
    cells = [
        (
            r["symbol"],
            "–" if r["before"] is None else f"{r['before']:.4f}",
            f"{r['after']:.4f}",
            html.meter(r["after"], 0, max(x["after"] for x in rows)),
        )
        for r in rows
    ]
    return html.section(
        "Sensitivity with the traced effects in it",
        html.paragraph(
            "Total index Sᵀ over the workspace; an effect varies as far as it did in the readings.", soft=True
        ),
        html.table(["Error", "#Before", "#After", ""], cells),
    )


def _parameters(data) -> Html:
    shifts = data.get("parameter_shifts", [])
    if not shifts:
        return Html("")
    rows = [
        (s["parameter"], f"{s['before']:.3g}", f"{s['after']:.3g}", f"{s['u']:.2g}", unit_words(s["unit"]))
        for s in shifts[:_SHOWN]
    ]
    more = (
        [html.paragraph(f"… and {len(shifts) - _SHOWN} more in trace.json.", soft=True)] if len(shifts) > _SHOWN else []
    )
    table = html.table(["Parameter", "#Before", "#After", "#Standard uncertainty", "Unit"], rows)
    return html.section("Declared errors that moved when the effects joined", table, *more)


def _bullets(items) -> Html:
    return html.element("ul", *(html.element("li", i) for i in items))


def _null_space(known):
    """The sentences on what is not determined, those with the same advice together."""
    sentences = trace_json.texts(known, "null_space")
    codes = [m["code"] for m in known.get("null_space_messages", ())] or [""] * len(sentences)
    for code in dict.fromkeys(codes):
        yield _bullets(s for s, own in zip(sentences, codes) if own == code)


def _limits(data) -> Html:
    known = data["identifiability"]
    parts = [
        html.paragraph(
            f"Of {known['columns']} parameters the plan determines {known['rank']}. No value is given for the others."
        )
    ]
    if known["null_space"]:
        parts += [html.element("h3", "Not told apart by this plan"), *_null_space(known)]
    if data["not_testable"]:
        rows = [(t["effect"], t["needs"]) for t in data["not_testable"]]
        parts.append(html.table(["Not testable", "Needs a column"], rows))
    if data["not_identifiable"]:
        parts += [html.element("h3", "Hidden by the declared model in this plan"), _bullets(data["not_identifiable"])]
    return html.section("What these readings cannot tell", *parts)


def _readings(data) -> Html:
    parts = []
    outliers = data.get("outliers", [])
    if outliers:
        parts.append(html.paragraph(f"{len(outliers)} gross outliers were found and left out; trace.json lists them."))
    notes = [f"line {f['line']}: {f['message']}" if f.get("line") else f["message"] for f in data.get("findings", [])]
    if notes:
        parts.append(_bullets(notes[:40]))
    return html.section("Remarks on the readings", *parts) if parts else Html("")
