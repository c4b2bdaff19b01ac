# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of an allocation: allocation.json, tolerances.csv (for --tolerances), front.csv and a page to sign."""

from __future__ import annotations

import csv
import datetime
import io

from sensworkbench import __version__
from sensworkbench.studies.allocation import AllocationResult

from . import html, json_text, machine_json, tolerances
from .words import Words

FORMAT, VERSION = "sens-allocation", 1


def to_dict(result: AllocationResult) -> dict:
    """allocation.json as plain data; half widths in um and urad."""
    machine, found = result.machine, result.allocation
    errors = []
    for choice in result.choices:
        c = machine.component(choice.symbol)
        errors.append({
            "symbol": c.symbol,
            "unit": c.unit,
            "half_width_before": _shown(c, choice.before),
            "half_width_after": _shown(c, choice.after),
            "grade": choice.grade or None,
            "cost": choice.cost,
        })  # fmt: skip
    level = {"level": result.target.level} if result.target.kind == "quantile" else {}
    quantiles = {}
    if result.quantile_um is not None:
        quantiles = {"quantile_um": dict(zip(("before", "after"), result.quantile_um))}
        if result.normal_bound is not None:
            quantiles["bound_if_normal"] = result.normal_bound
    return {
        "format": FORMAT,
        "version": VERSION,
        "target": {"kind": result.target.kind, "value": result.target.value} | level,
        "cost": found.cost,
        "bound": found.bound,
        "gap": found.gap,
        "errors": errors,
        "rms_um": {"before": result.rms_before_um, "after": result.rms_after_um},
        "worst_rms_um": {"before": result.worst_before_um, "after": result.worst_after_um},
        "machine": {"name": machine.name, "structure": machine.structure},
    } | quantiles


def _shown(c, law) -> float:
    return float(f"{c.to_shown((law.upper - law.lower) / 2):.12g}")


def front_csv(result: AllocationResult) -> str:
    """Target, cost and bound, one line each."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(["rms_um", "cost", "bound"])
    writer.writerows([f"{p.rms_um:.9g}", f"{p.cost:.9g}", f"{p.bound:.9g}"] for p in result.front)
    return stream.getvalue()


def report(result: AllocationResult, language: str = "en") -> str:
    """The page: what the target costs, every tolerance before and after, and what a looser or tighter target costs."""
    words, data, machine = Words(language), to_dict(result), result.machine
    tiles = [
        (f"{data['cost']:.4g}", words("allocation-cost")),
        (f"{data['rms_um']['before']:.3g} → {data['rms_um']['after']:.3g} µm", words("allocation-rms")),
        (f"{data['worst_rms_um']['before']:.3g} → {data['worst_rms_um']['after']:.3g} µm", words("allocation-worst")),
    ]
    if "quantile_um" in data:
        change = f"{data['quantile_um']['before']:.3g} → {data['quantile_um']['after']:.3g} µm"
        tiles.append((change, words("allocation-quantile", level=100 * result.target.level)))
    lead = words("allocation-lead", cost=data["cost"], gap=100 * max(data["gap"], 0.0))
    if "bound_if_normal" in data and data["bound_if_normal"] > data["bound"]:
        lead += " " + words("allocation-if-normal", bound=data["bound_if_normal"])
    rows = [
        (
            e["symbol"],
            words.of(machine.component(e["symbol"]).title),
            f"±{e['half_width_before']:.4g} {_unit(e)}",
            f"±{e['half_width_after']:.4g} {_unit(e)}",
            e["grade"] or "–",
            f"{e['cost']:.4g}",
        )
        for e in sorted(data["errors"], key=lambda e: -e["cost"])
    ]
    heads = [words("column-error"), words("column-meaning"), f"#{words('column-before')}", f"#{words('column-after')}"]
    heads += [words("column-grade"), f"#{words('column-cost')}"]
    steps = result.front[:: max(1, len(result.front) // 10)]
    front = [(f"{p.rms_um:.3g}", f"{p.cost:.4g}", f"{p.bound:.4g}") for p in steps]
    return html.page(
        words("allocation-title", machine=machine.name),
        words(
            f"allocation-target-{result.target.kind.replace('_', '-')}",
            value=result.target.value,
            level=100 * result.target.level,
        ),
        html.paragraph(lead, lead=True),
        html.tiles(tiles),
        html.section(words("allocation-table"), html.table(heads, rows)),
        html.section(
            words("allocation-front"),
            html.paragraph(words("allocation-front-words"), soft=True),
            html.table([f"#{words('column-rms')}", f"#{words('column-cost')}", f"#{words('column-bound')}"], front),
        ),
        footer=words("report-footer", version=__version__, date=datetime.date.today().isoformat()),
        language=language,
    )


def _unit(entry: dict) -> str:
    return "µrad" if entry["unit"] == "urad" else "µm"


def files(result: AllocationResult, language: str = "en") -> dict[str, str]:
    """Name -> text of every file of the set."""
    allocated = {c.symbol: c.after for c in result.choices}
    return {
        "allocation.json": json_text.dumps(to_dict(result)),
        "tolerances.csv": tolerances.dumps_csv(allocated, known=result.machine.component),
        "front.csv": front_csv(result),
        "machine.json": machine_json.dumps(result.machine),
        "report.html": report(result, language),
    }
