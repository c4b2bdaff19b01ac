# SPDX-License-Identifier: LGPL-2.1-or-later
"""report.html of a sensitivity run: which component spoils the accuracy, for the desk and for the customer.

It is written from the data of sensitivity.json alone, so the report never says more than the file.
"""

from __future__ import annotations

import datetime
import math

from sensworkbench import __version__
from sensworkbench.core.errors import BODY_NAMES

from . import charts, html
from .html import Html

UNIT_SHOWN = {"um": "µm", "urad": "µrad", "arcsec": "arcsec", "mm": "mm", "rad": "rad"}
_LAWS = {
    "uniform": "uniform",
    "normal": "normal",
    "truncated_normal": "truncated normal",
    "triangular": "triangular",
    "u_shaped": "U-shaped",
    "point": "constant",
}


def sensitivity_report(data: dict, picture: bytes | None = None) -> str:
    """The page for the data of sensitivity.json; picture: PNG of the coloured machine."""
    machine = data["machine"]
    parts = [_summary(data)]
    if picture is not None:
        parts.append(
            html.picture(
                picture,
                "The machine with its parts coloured by total index",
                "The parts in the colour of their component's total index Sᵀ.",
            )
        )
    parts += [_components(data), _ranking(data), _lever_arms(data), _finding(data), _eq18(data), _settings(data)]
    return html.page(
        f"{machine['name']}: sensitivity of the volumetric error",
        f"Structure {machine['structure']} (workpiece to tool, F: bed). Y = {data['settings']['objective']}, "
        f"{where_words(data)}.",
        *parts,
        footer=f"Sens Workbench {__version__}, {datetime.date.today().isoformat()}. The indices are exact for the "
        "stated tolerances and first-order model; nothing is sampled.",
    )


def where_words(data: dict) -> str:
    """Where the indices were taken."""
    if data["aggregate"] == "at":
        return "at X {:g}, Y {:g}, Z {:g} mm".format(*data["points"])
    counts = " × ".join(str(c) for c in data["points"])
    if data["aggregate"] == "grid":
        return f"mean over a grid of {counts} positions"
    return f"mean over the travel (Gauss-Legendre quadrature, {counts} positions)"


def index(value: float) -> str:
    """An index with four decimals."""
    return f"{value:.4f}"


def tolerance(row: dict) -> str:
    """`±20 µrad` or `-1 … 3 µm`, with the distribution where it is not uniform."""
    unit = UNIT_SHOWN.get(row["unit"], row["unit"])
    if row["lower"] == -row["upper"]:
        words = f"±{row['upper']:g} {unit}"
    else:
        words = f"{row['lower']:g} … {row['upper']:g} {unit}".replace("-", "−")
    return words if row["distribution"] == "uniform" else f"{words}, {_LAWS[row['distribution']]}"


def _summary(data: dict) -> Html:
    worst, error = data["components"][0], data["errors"][0]
    direct = sum(e["first"] for e in data["errors"])
    tiles = [
        (
            html.body_label(worst["body"], worst["name"]),
            f"component with the largest total index, Sᵀ = {worst['total']:.3f}",
        ),
        (error["symbol"], f"largest error: {error['description']}, {tolerance(error)}, Sᵀ = {error['total']:.3f}"),
    ]
    square = data["mean_square_um2"]
    if square is not None:
        tiles.append((f"{math.sqrt(square):.2f} µm", "rms volumetric error, the root of E[Y]"))
    tiles.append((f"{direct:.0%}", "of the variance from single errors alone (ΣS); the rest is interaction"))
    words = html.paragraph(
        f"Of all components the {worst['name']} spoils the accuracy most: with all its errors held at their means, "
        f"{worst['total']:.0%} of the variance of Y would be gone. The single error that matters most is "
        f"{error['symbol']} ({error['description']}), owned by the {BODY_NAMES[error['owner']]}.",
        lead=True,
    )
    parts = [words, html.tiles(tiles)]
    if direct < 0.5:
        parts.append(
            html.paragraph(
                "Most of the variance is interaction, so S alone misleads: read S (what an error does by itself) and "
                "Sᵀ (what would go if it were held at its mean) side by side.",
                soft=True,
            )
        )
    return html.join(parts)


def _components(data: dict) -> Html:
    rows = data["components"]
    largest = max(r["total"] for r in rows)
    chart = charts.bar_chart(
        [r["name"] for r in rows],
        [r["first"] for r in rows],
        [r["total"] for r in rows],
        [html.BODY_COLOURS[r["body"]] for r in rows],
        _maximum(data, rows),
        xlabel="index of the component",
        alt="First-order and total index of every component",
    )
    table = html.table(
        ["Component", "#S", "#Sᵀ", "#Largest Sᵀ", "#Sᵀ, variance-weighted", ""],
        [
            (
                html.body_label(r["body"], r["name"]),
                index(r["first"]),
                index(r["total"]),
                index(r["total_max"]),
                index(r["total_variance_weighted"]),
                html.meter(r["total"], r["first"], largest),
            )
            for r in rows
        ],
    )
    words = html.paragraph(
        "S: share of the variance from the component's own errors alone. Sᵀ: share that any of its errors touches, "
        "counted once - not the sum of its errors' totals, because interactions between its errors are shared.",
        soft=True,
    )
    return html.section("Components", words, *_figure(chart), table)


def _maximum(data: dict, rows) -> list[float] | None:
    return None if data["aggregate"] == "at" else [r["total_max"] for r in rows]


def _figure(chart: Html | None, caption: str = "") -> list[Html]:
    return [] if chart is None else [html.figure(chart, caption)]


def _ranking(data: dict) -> Html:
    rows = [r for r in data["errors"] if r["total"] > 0 or r["upper"] != r["lower"]]
    still = len(data["errors"]) - len(rows)
    largest = max(r["total"] for r in rows)
    chart = charts.bar_chart(
        [f"{r['symbol']}   {tolerance(r).partition(',')[0]}" for r in rows],
        [r["first"] for r in rows],
        [r["total"] for r in rows],
        [html.BODY_COLOURS[r["owner"]] for r in rows],
        _maximum(data, rows),
        legend={BODY_NAMES[b]: html.BODY_COLOURS[b] for b in BODY_NAMES if any(r["owner"] == b for r in rows)},
        xlabel="sensitivity index",
        alt="Ranking of the errors by total index",
    )
    table = html.table(
        ["#", "Error", "What it is", "#Tolerance", "#S", "#Sᵀ", "#Largest Sᵀ", "Owner", ""],
        [
            (
                i,
                r["symbol"],
                r["description"],
                tolerance(r),
                index(r["first"]),
                index(r["total"]),
                index(r["total_max"]),
                html.body_label(r["owner"]),
                html.meter(r["total"], r["first"], largest),
            )
            for i, r in enumerate(rows, start=1)
        ],
    )
    words = [html.paragraph(f"{still} errors with no tolerance are left out.", soft=True)] if still else []
    return html.section("Ranking of the errors", *_figure(chart), table, *words)


def _lever_arms(data: dict) -> Html:
    arms = data["lever_arms_mm"]
    q = arms["position"]
    where = "at X {:g}, Y {:g}, Z {:g} mm".format(*q)
    rows = [
        (
            html.body_label(b, BODY_NAMES[b]),
            *(f"{v:.3f}".replace("-", "−") for v in arms[b]),
            f"{math.hypot(*arms[b]):.1f}",
        )
        for b in BODY_NAMES
    ]
    words = html.paragraph(
        f"Functional point minus the reference point of each body, both where they are {where}, in the machine frame. "
        "An angle multiplies its lever arm: 10 µrad at 500 mm move the tool by 5 µm.",
        soft=True,
    )
    skew = {k: v for k, v in data["skew_deg"].items() if abs(v) > 1e-6}
    notes = []
    if skew:
        pairs = ", ".join(f"{k[0]}-{k[1]} {v:+.4f}°" for k, v in skew.items())
        notes.append(html.note(f"The directions are not square to each other by design: {pairs}."))
    return html.section(
        "Abbe offsets", words, html.table(["Body", "#x, mm", "#y, mm", "#z, mm", "#Length, mm"], rows), *notes
    )


def _finding(data: dict) -> Html:
    both = data["squareness_conventions"]
    used = data["settings"]["squareness"]
    names = {c: f'"{c}"{" (used here)" if c == used else ""}' for c in both}
    kinds = list(next(iter(both.values()))["kinds"])
    words = html.paragraph(
        "Park and Yang (2012) found that squareness and angular errors dominate through the Abbe offsets, and that "
        "linear displacement and the spindle hardly matter. Their finding rests on the convention for squareness, "
        "so both are shown for this machine: ",
        html.join([f'"{c}": {v["words"]}' for c, v in both.items()], "; "),
        ".",
    )
    rows = [(kind, *(index(both[c]["kinds"][kind]["total"]) for c in both)) for kind in kinds]
    table = html.table(
        ["Kind of error", *(f"#Sᵀ, {names[c]}" for c in both)], rows, "Total index of all errors of a kind together"
    )
    shown = list(dict.fromkeys(s for c in both for s in both[c]["largest"]))
    shown += [s for s in ("C0Y", "A0Z", "B0Z") if s not in shown and s in both[used]["total"]]
    chart = charts.grouped_bars(
        shown,
        {names[c]: [both[c]["total"][s] for s in shown] for c in both},
        xlabel="total index Sᵀ",
        alt="Total index of the leading errors under both squareness conventions",
    )
    if chart is None:
        fallback = [
            html.table(
                ["Error", *(f"#Sᵀ, {names[c]}" for c in both)],
                [(s, *(index(both[c]["total"][s]) for c in both)) for s in shown],
            )
        ]
    else:
        fallback = _figure(chart, "The errors that lead under either convention, and the three squareness errors.")
    verdicts = [html.paragraph(f"With squareness as {names[c]}: {both[c]['finding']}") for c in both]
    return html.section("The paper's finding, under both squareness conventions", words, table, *fallback, *verdicts)


def _eq18(data: dict) -> Html:
    paper = data["paper_eq18"]
    if paper is None:
        return Html("")
    order = sorted(range(len(paper["symbols"])), key=lambda i: -paper["total"][i])
    rows = [(paper["symbols"][i], index(paper["total"][i]), index(paper["as_printed"][i])) for i in order[:6]]
    words = html.paragraph(
        "For comparison only. Eq. (18) as printed puts the variance of E(Y|X_j) where that of E(Y|X_~j) belongs, so it "
        "gives the total index of everything but X_j: close to 1 for every error, in reversed order. Eq. (15a) also "
        f"drops the covariances of T4², T5², T6²: V(Y) would be {paper['variance_um4_eq15a']:.4g} µm⁴ instead of "
        f"{paper['variance_um4']:.4g} µm⁴. ",
        "Position: X {:g}, Y {:g}, Z {:g} mm.".format(*paper["position"]),
        soft=True,
    )
    return html.section("Eq. (18) as printed", words, html.table(["Error", "#Sᵀ, exact", "#Eq. (18) as printed"], rows))


def _settings(data: dict) -> Html:
    s, c = data["settings"], data["conventions"]
    travel = ", ".join(f"{a} {low:g} … {high:g}" for a, (low, high) in zip("XYZ", s["travel_mm"])).replace("-", "−")
    pairs = [
        ("Objective", f"Y = {s['objective']} ({s['output']})"),
        ("Positions", where_words(data)),
        ("Travel, mm", travel),
        ("Squareness", f'"{s["squareness"]}": {c["squareness"]}'),
        ("Names", c["names"]),
        ("Sign", c["sign"]),
        ("Frame", c["frame"]),
        ("Abbe offset", c["lever_arm"]),
        ("Model", c["model"]),
        ("S", c["first"]),
        ("Sᵀ", c["total"]),
    ]
    if data["estimated_error"] is not None:
        pairs.insert(2, ("Error of the quadrature", f"{data['estimated_error']:.1e} (difference from two orders less)"))
    for key, value in data.items():
        if value is not None and key.startswith(("mean_", "variance_")):
            name = "E[Y]" if key.startswith("mean") else "V(Y)"
            unit = key.rpartition("_")[2].replace("urad", "µrad").replace("um", "µm")
            unit = unit.replace("2", "²").replace("4", "⁴")
            pairs.append((name, f"{value:.6g} {unit}"))
    return html.section("Settings and conventions", html.facts(pairs))
