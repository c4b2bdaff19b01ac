# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of a study of limits: limits.json, contributions.csv and a page."""

from __future__ import annotations

from sensworkbench.studies.limits import LimitsResult

from . import html, json_text, study_pages
from .files import neutral
from .words import Words, position_text

FORMAT, VERSION = "sens-limits", 1


def to_dict(result: LimitsResult) -> dict:
    """limits.json as plain data; um, places in mm and deg."""
    machine = result.machine
    return {
        **study_pages.head(FORMAT, VERSION, machine),
        "level": result.level,
        "method": "computed" if result.computed else "sampled",
        "quantile_um": result.quantile,
        "quantile_error_um": result.error,
        "beyond": [{"limit_um": r, "probability": p, "error": e} for r, p, e in result.beyond],
        "worst": {"quantile_um": result.worst, "at": _at(result)},
        "errors": [{"symbol": c.name, "contribution": c.value} for c in result.errors],
        "components": [{"body": c.name, "contribution": c.value} for c in result.components],
        "figures": [{"name": f.name, "median_um": f.median, "quantile_um": f.upper} for f in result.figures],
    }


def _at(result: LimitsResult) -> list[float]:
    return [float(f"{j.to_shown(float(v)):.12g}") for j, v in zip(result.machine.joints, result.worst_at)]


def contributions_csv(result: LimitsResult) -> str:
    """Contribution of every error and component to the quantile."""
    kinds = (("component", result.components), ("error", result.errors))
    rows = [(kind, neutral(c.name), f"{c.value:.9g}") for kind, found in kinds for c in found]
    return study_pages.table(["kind", "name", "contribution"], rows)


def report(result: LimitsResult, language: str = "en") -> str:
    """The page: the quantile, what makes it, the probability of each limit, the figures of a measured machine."""
    words, machine = Words(language), result.machine
    level = f"{100 * result.level:g}"
    tiles = [
        (f"{result.quantile:.3g} µm", words("limits-quantile", level=level)),
        (f"{result.worst:.3g} µm", words("limits-worst", at=position_text(machine.joints, _at(result)))),
        *((f"{100 * p:.3g} %", words("limits-beyond", limit=r)) for r, p, _ in result.beyond),
    ]
    how = "limits-computed" if result.computed else "limits-sampled"
    largest = max((c.value for c in result.errors), default=1.0)
    of_errors = [
        (c.name, _error_words(words, machine, c.name), f"{100 * c.value:.1f} %", html.meter(c.value, c.value, largest))
        for c in result.errors
        if c.value > 5e-4
    ]
    most = max((c.value for c in result.components), default=1.0)
    of_components = [
        (
            html.body_label(c.name, words.of(machine.body_title(c.name))),
            f"{100 * c.value:.1f} %",
            html.meter(c.value, c.value, most),
        )
        for c in result.components
    ]
    share = f"#{words('limits-contribution')}"
    parts = [
        html.paragraph(words("limits-lead", level=level, quantile=result.quantile), lead=True),
        html.tiles(tiles),
        html.paragraph(words(how, error=result.error), soft=True),
        html.section(
            words("limits-components"),
            html.paragraph(words("limits-contribution-words"), soft=True),
            html.table([words("column-component"), share, ""], of_components),
        ),
        html.section(
            words("limits-errors"), html.table([words("column-error"), words("column-meaning"), share, ""], of_errors)
        ),
    ]
    if result.figures:
        rows = [(f.name, f"{f.median:.3g} µm", f"{f.upper:.3g} µm") for f in result.figures]
        heads = [words("limits-figure"), f"#{words('limits-median')}", f"#{level} %"]
        explained = html.paragraph(words("limits-figures-words"), soft=True)
        parts.append(html.section(words("limits-figures"), explained, html.table(heads, rows)))
    return study_pages.page(
        words,
        words("limits-title", machine=machine.name),
        words("limits-subtitle", level=level),
        *parts,
    )


def _error_words(words: Words, machine, name: str) -> str:
    symbols = {c.symbol for c in machine.components}
    return words.of(machine.component(name).title) if name in symbols else name


def files(result: LimitsResult, language: str = "en") -> dict[str, str]:
    """Name -> text of every file of the set."""
    return {
        "limits.json": json_text.dumps(to_dict(result)),
        "contributions.csv": contributions_csv(result),
        "report.html": report(result, language),
    }
