# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of a study of moves: moves.json, moves.csv and a page."""

from __future__ import annotations

from sensworkbench.core.units import um
from sensworkbench.studies.moves import (
    SPINDLE,
    TOOL,
    WORKPIECE,
    Change,
    MovesResult,
    PointMoves,
    box_text,
    per_mm_percent,
    per_um2,
    um2,
)

from . import html, json_text, study_pages
from .words import Words

FORMAT, VERSION = "sens-moves", 1
MOST_ORDERS = 12  # that the page shows


def to_dict(result: MovesResult) -> dict:
    """moves.json as plain data; mm, um, per mm or per deg."""
    machine = result.machine
    step = None
    if result.step is not None:
        step = {"symbol": result.step.symbol, "cost_per_um2": per_um2(result.step.price)}
    return {
        **study_pages.head(FORMAT, VERSION, machine),
        "mean_square_um2": um2(result.mean_square),
        "rms_um": um(result.mean_square**0.5),
        "within_mm": result.within[0] if len(set(result.within)) == 1 else list(result.within),
        "points": [_point(result, p) for p in result.points],
        "travel": [_travel(result, t) for t in result.travel],
        "together": {
            "moves_mm": {n: [_tidy(v) for v in m] for n, m in result.together.items()},
            "rms_um": um(result.rms_together),
        },
        "orders": [{"structure": o.structure, "rms_um": um(o.rms)} for o in result.orders],
        "tolerance": step,
    }


def _tidy(value: float) -> float:
    return float(f"{value:.12g}") + 0.0


def _point(result: MovesResult, point: PointMoves) -> dict:
    found = {
        "name": point.name,
        "at_mm": [_tidy(v) for v in point.at],
        "per_mm": {axis: _change(result, c) for axis, c in zip("xyz", point.changes)},
        "best_move_mm": [_tidy(v) for v in point.best],
        "best_rms_um": um(point.rms_best),
    }
    if point.worth is not None:
        found["worth_per_mm"] = [float(v) for v in point.worth]
    return found


def _travel(result: MovesResult, travel) -> dict:
    joint = result.machine.joint(travel.name)
    ends = {"low": travel.low, "high": travel.high}
    scale = joint.from_shown(1.0)  # per deg
    return {
        "joint": travel.name,
        "unit": joint.unit,
        **{end: _change(result, change, scale) for end, change in ends.items()},
    }


def _change(result: MovesResult, change: Change, scale: float = 1.0) -> dict:
    return {
        "mean_square_um2": um2(change.mean_square) * scale,
        "percent": per_mm_percent(result, change) * scale,
        "variance_um4": um2(um2(change.variance)) * scale,
        "shares": {b: v * scale for b, v in change.shares.items()},
    }


COLUMNS = ("point", "axis", "mean_square_um2_per_mm", "percent_per_mm", "best_move_mm", "worth_per_mm")


def moves_csv(result: MovesResult) -> str:
    """One line per point and direction."""
    rows = []
    for p in result.points:
        for i, axis in enumerate("xyz"):
            worth = "" if p.worth is None else f"{p.worth[i]:.6g}"
            cells = [um2(p.changes[i].mean_square), per_mm_percent(result, p.changes[i]), p.best[i]]
            rows.append((p.name, axis, *(f"{v:.9g}" for v in cells), worth))
    return study_pages.table(COLUMNS, rows)


def report(result: MovesResult, language: str = "en") -> str:
    """The page: what each point's move changes, the best places within the box, and the orders of the axes."""
    words, machine = Words(language), result.machine
    rms = um(result.mean_square**0.5)
    best, room = min(result.points, key=lambda p: p.rms_best), box_text(result.within)
    tiles = [
        (f"{rms:.3g} µm", words("moves-rms")),
        (f"{um(best.rms_best):.3g} µm", words("moves-best", point=_name(words, best.name), within=room)),
        (f"{um(result.rms_together):.3g} µm", words("moves-together", within=room)),
    ]
    if result.orders:
        first = result.orders[0]
        tiles.append((f"{um(first.rms):.3g} µm", words("moves-best-order", structure=first.structure)))
    heads = [
        words("moves-point"),
        *(f"#∂/∂{a}" for a in "xyz"),
        f"#{words('moves-best-move')}",
        f"#{words('column-rms')}",
    ]
    rows = []
    for p in sorted(result.points, key=lambda p: p.rms_best):
        cells = [f"{per_mm_percent(result, c):+.3f} %" for c in p.changes]
        move = ", ".join(f"{v:+.0f}" if v else "0" for v in p.best)
        row = [_name(words, p.name), *cells, f"({move}) mm", f"{um(p.rms_best):.3g} µm"]
        if p.worth is not None:
            row.append(f"{max(p.worth):.3g}")
        rows.append(row)
    if result.step is not None:
        heads.append(f"#{words('moves-worth')}")
    parts = [
        html.tiles(tiles),
        html.section(
            words("moves-points"), html.paragraph(words("moves-points-words"), soft=True), html.table(heads, rows)
        ),
    ]
    if result.step is not None:
        text = words("moves-worth-words", symbol=result.step.symbol, price=per_um2(result.step.price))
        parts.append(html.paragraph(text, soft=True))
    travel = [
        (
            t.name,
            *(f"{per_mm_percent(result, c) * machine.joint(t.name).from_shown(1.0):+.3f} %" for c in (t.low, t.high)),
            machine.joint(t.name).unit,
        )
        for t in result.travel
    ]
    if travel:
        heads = [words("moves-joint"), f"#{words('moves-low')}", f"#{words('moves-high')}", words("moves-per")]
        explained = html.paragraph(words("moves-travel-words"), soft=True)
        parts.append(html.section(words("moves-travel"), explained, html.table(heads, travel)))
    if result.orders:
        shown = [
            (o.structure, f"{um(o.rms):.3g} µm", f"{100 * (o.rms**2 / result.mean_square - 1):+.1f} %")
            for o in result.orders[:MOST_ORDERS]
        ]
        heads = [words("moves-structure"), f"#{words('column-rms')}", f"#{words('moves-change')}"]
        explained = html.paragraph(words("moves-orders-words", count=len(result.orders)), soft=True)
        parts.append(html.section(words("moves-orders"), explained, html.table(heads, shown)))
    return study_pages.page(
        words,
        words("moves-title", machine=machine.name),
        words("moves-subtitle"),
        *parts,
    )


def _name(words: Words, name: str) -> str:
    known = {TOOL: "moves-tool", SPINDLE: "moves-spindle", WORKPIECE: "moves-workpiece"}
    return words(known[name]) if name in known else words("moves-of-joint", name=name)


def files(result: MovesResult, language: str = "en") -> dict[str, str]:
    """Name -> text of every file of the set."""
    return {
        "moves.json": json_text.dumps(to_dict(result)),
        "moves.csv": moves_csv(result),
        "report.html": report(result, language),
    }
