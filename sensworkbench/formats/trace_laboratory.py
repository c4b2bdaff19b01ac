# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a laboratory signs in the report of a trace: records, conditions of the fit, fitted errors with their expanded
uncertainty and the decision against the tolerances, figures of ISO 230, and the budget of uncertainty.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from sensworkbench.core.propagation import coverage_factor
from sensworkbench.studies import error_report, iso230

from . import charts, html, provenance
from .html import Html
from .words import UNIT_SHOWN, Words, minus

K = error_report.K
MOST_LINES = 24
SOURCES = ("noise", "alignment", "instrument", "expansion", "temperature", "undetermined", "rivals")


def number(value, digits: int = 3) -> str:
    """A number with sense in its digits, a dash where there is none."""
    if value is None or not math.isfinite(value):
        return "–"
    return minus(f"{value:.{digits}g}" if abs(value) < 10**digits else f"{value:.0f}")


def records(data: Mapping, words: Words) -> Html:
    """Machine, instrument, session, and the sums of the files that were read; lines to fill in by hand where empty."""
    stated = data.get("records", {})
    needed = ("machine", "serial", "instrument", "certificate", "operator", "date", "environment")
    keys = [*needed, *(k for k in stated if k not in needed)]
    pairs = [(words(f"lab-record-{k.replace('_', '-')}"), stated.get(k, "________________")) for k in keys]
    parts = [html.facts(pairs)]
    run = provenance.current()
    if run is not None and run.inputs:
        rows = [(i.path.replace("\\", "/").rsplit("/", 1)[-1], i.sha256, f"{i.bytes}") for i in run.inputs.values()]
        heads = [words("lab-column-file"), "SHA-256", f"#{words('lab-column-bytes')}"]
        parts.append(html.table(heads, rows, words("lab-inputs")))
    parts.append(html.paragraph(words("lab-signature"), soft=True))
    return html.section(words("lab-records"), *parts)


def conditions(data: Mapping, outcome, words: Words) -> Html:
    """Under which conditions the fit was made: each computed from the readings."""
    readings, noise, known = outcome.readings, data["noise"], data["identifiability"]
    runs = 0 if readings.run is None else len(set(map(str, readings.run)))
    items = [
        words("lab-fit-readings", rows=readings.rows, points=readings.points, outliers=len(data.get("outliers", ()))),
        words("lab-fit-rank", rank=known["rank"], columns=known["columns"], condition=known["condition"]),
        words(f"lab-fit-alignment-{(data.get('alignment') or 'once').replace(' ', '-').replace('_', '-')}", runs=runs),
    ]
    per = ", ".join(f"{k} {number(v)} µm" for k, v in noise.get("per_direction_um", {}).items())
    if per:
        items.append(words("lab-fit-noise", noise=per))
    ratio = noise.get("chi2_per_dof") or {}
    items.append(
        words("lab-fit-chi2", ratio=", ".join(f"{k} {v:.2f}" for k, v in ratio.items()))
        if ratio
        else words("lab-fit-chi2-none")
    )
    items.append(
        words("lab-fit-repeats", pure=noise["pure_error_um"], residual=noise["residual_um"])
        if noise["pure_error_um"] is not None
        else words("lab-fit-repeats-none")
    )
    memory = ", ".join(f"{k} {minus(f'{v:.2f}')}" for k, v in noise.get("memory", {}).items())
    if memory:
        items.append(words("lab-fit-memory", memory=memory))
    items += [words(code, **fields) for code, fields in noise_changes(outcome)]
    return html.section(words("lab-conditions"), html.element("ul", *(html.element("li", i) for i in items)))


def noise_changes(outcome) -> list[tuple[str, dict]]:
    """(message, fields) on whether the size of the residuals changes with time and with each place.

    The correlation of the logarithms of the residuals' sizes with a column, over its standard error 1/sqrt(N).
    """
    readings, residual = outcome.readings, np.asarray(outcome.residuals["augmented"])
    use = np.asarray(outcome.residuals.get("used", np.ones(len(residual), bool)), dtype=bool) & (residual != 0)
    size = np.log(np.abs(residual[use]))
    out = []
    for name in ("t", "x", "y", "z"):
        v = readings.columns.get(name)
        if v is None or np.ptp(v) == 0 or use.sum() < 20:
            continue
        r = float(np.corrcoef(v[readings.point][use], size)[0, 1])
        score = r * math.sqrt(use.sum())
        slope = float(np.polyfit((v[readings.point][use] - v.min()) / np.ptp(v), size, 1)[0])
        code = "lab-fit-change" if abs(score) > 3 else "lab-fit-no-change"
        out.append((code, {"column": name, "ratio": math.exp(slope), "score": abs(score)}))
    return out


def errors(outcome, words: Words) -> Html:
    """Table and curves of the fitted errors with U (k = 2) and the decision by the guarded rule."""
    rows = error_report.error_rows(outcome.machine)
    if not rows:
        return Html("")
    cells = []
    for row in rows:
        scale, unit = (1e6, "µrad") if row.angular else (1e3, "µm")
        place, value, u = row.largest
        told = row.determined
        low, high = row.limits or (math.nan, math.nan)
        orders = ", ".join(
            f"P{k}: " + ("–" if s is None else f"{number(v * scale)} ± {number(K * s * scale, 2)}")
            for k, (v, s) in row.orders.items()
        )
        some = any(s is not None for _, s in row.orders.values())
        cells.append(
            (
                row.symbol,
                orders if some else words("lab-not-determined"),
                number(value * scale) if told else "–",
                number(K * u * scale, 2) if told else "–",
                "–" if len(row.place) == 1 or not told else number(place),
                f"{number(low * scale)} … {number(high * scale)}",
                unit,
                words(f"lab-decision-{row.decision}"),
            )
        )
    heads = [
        words("lab-column-error"),
        words("lab-column-coefficients"),
        f"#{words('lab-column-largest')}",
        f"#{words('lab-column-expanded')}",
        f"#{words('lab-column-at')}",
        words("lab-column-limits"),
        words("lab-column-unit"),
        words("lab-column-decision"),
    ]
    parts = [html.table(heads, cells, words("lab-errors-caption")), html.paragraph(words("lab-rule", k=K), soft=True)]
    for axis in outcome.machine.names:
        shown = [r for r in rows if r.determined and len(r.place) > 1 and r.symbol.endswith(axis)]
        groups = [
            [(r.symbol, r.place, r.value * scale, K * r.u * scale) for r in shown if r.angular == angular]
            for angular, scale in ((False, 1e3), (True, 1e6))
        ]
        if any(groups) and charts.available():
            labels = (f"{axis}, {UNIT_SHOWN['mm']}", UNIT_SHOWN["um"], UNIT_SHOWN["urad"])
            chart = charts.bands(groups, *labels, alt=words("lab-curves-alt", axis=axis))
            parts.append(html.figure(chart, words("lab-curves", axis=axis)))
    return html.section(words("lab-errors"), *parts)


def standards(outcome, words: Words) -> Html:
    """Figures of ISO 230 that the readings hold; nothing where they hold none."""
    readings, parts = outcome.readings, []
    found = iso230.lines(readings)
    if found:
        rows = []
        for line in found[:MOST_LINES]:
            f = line.figures
            way = ", ".join(f"{v:.3g}" for v in line.direction)
            own = (f.accuracy, f.repeatability, f.systematic, f.reversal, f.mean_reversal, f.mean_systematic)
            rows.append(
                (
                    words("lab-iso-diagonal") if line.diagonal else words("lab-iso-axis"),
                    minus(f"({way})"),
                    f"{f.targets} × {f.runs}",
                    *(number(None if v is None else v * 1e3) for v in own),
                )
            )
        heads = [words("lab-column-line"), words("lab-column-direction"), f"#{words('lab-column-targets')}"]
        heads += [f"#{name}, µm" for name in ("A", "R", "E", "B", "B̄", "M")]
        parts.append(html.table(heads, rows, words("lab-iso-positioning")))
        if min(line.figures.runs for line in found) < iso230.STANDARD_RUNS:
            parts.append(html.paragraph(words("lab-iso-few", runs=iso230.STANDARD_RUNS), soft=True))
    for circle in iso230.circles(readings):
        each = ", ".join(f"G({'+' if s > 0 else '−'}) {number(v * 1e3)} µm" for s, v in circle.deviation.items())
        f_values = {"least": number(circle.least * 1e3), "most": number(circle.most * 1e3)}
        parts.append(html.paragraph(words("lab-iso-circle", radius=circle.radius, each=each, **f_values)))
    drift = iso230.fixed_place(readings)
    if drift is not None:
        each = (drift.whole, drift.first_hour)
        whole, hour = (", ".join(f"{k} {number(v * 1e3)} µm" for k, v in d.items()) for d in each)
        parts.append(html.paragraph(words("lab-iso-drift", hours=drift.hours, whole=whole, hour=hour)))
    return html.section(words("lab-iso"), *parts) if parts else Html("")


def budget(data: Mapping, words: Words) -> Html:
    """The budget of the mean predicted error; what the file does not state is said to be missing."""
    lines = data.get("budget") or []
    if not lines:
        return Html("")
    total = sum(b["variance_um2"] for b in lines)
    rows = [
        (
            words(f"lab-source-{b['source']}") if b["source"] in SOURCES else b["source"],
            number(math.sqrt(b["variance_um2"])),
            number(b["variance_um2"]),
            f"{b['variance_um2'] / total:.0%}" if total > 0 else "–",
        )
        for b in lines
    ]
    u = math.sqrt(total)
    rows.append((words("lab-source-total"), number(u), number(total), "100%"))
    heads = [words("lab-column-source"), "#u, µm", "#u², µm²", f"#{words('lab-column-share')}"]
    stated = {b["source"] for b in lines}
    missing = [words(f"lab-source-{s}") for s in ("instrument", "expansion", "temperature") if s not in stated]
    parts = [html.paragraph(words("lab-budget-words"), soft=True), html.table(heads, rows)]
    parts.append(html.paragraph(words("lab-budget-expanded", expanded=K * u, k=K, p=100 * _probability())))
    if missing:
        parts.append(html.paragraph(words("lab-budget-missing", sources=missing), soft=True))
    return html.section(words("lab-budget"), *parts)


def _probability() -> float:
    """Coverage of K for a normal law."""
    low, high = 0.5, 0.9999
    for _ in range(40):
        middle = (low + high) / 2
        low, high = (middle, high) if coverage_factor(middle) < K else (low, middle)
    return low


def left_out(data: Mapping, words: Words) -> Html:
    """The error of each run, or block, by a fit of all others, with the coverage that so many can give."""
    after = data["error"]["augmented"].get("left_out")
    before = data["error"]["declared"].get("left_out")
    if not after or not before:
        return Html("")
    return html.paragraph(
        words(
            f"lab-left-out-{after['by']}",
            count=after["number"],
            low=after["lowest_um"],
            high=after["highest_um"],
            before=before["highest_um"],
            coverage=100 * after["coverage"],
        )
    )
