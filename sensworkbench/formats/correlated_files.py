# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of a study of correlated errors: a covariance is read from CSV; JSON, CSV and a page are written.

covariance.csv: the first row holds the word `symbol` and the names of the errors, every further row a name and its row
of the matrix, in products of um and urad.
"""

from __future__ import annotations

import numpy as np

from sensworkbench.core.machine import Machine
from sensworkbench.core.refusal import Refused
from sensworkbench.core.shapley import checked_covariance
from sensworkbench.core.units import um
from sensworkbench.studies.correlated import CorrelatedResult, Share

from . import csv_table, html, json_text, study_pages
from .files import neutral
from .words import Words

FORMAT, VERSION = "sens-correlated", 1
MOST_ERRORS = 200


def load(path, machine: Machine) -> tuple[tuple[str, ...], np.ndarray]:
    """(symbols, covariance in mm and rad).  Refuses with line and column, and a matrix that is no covariance."""
    table = csv_table.read(path)
    names = [n.strip() for n in table.names]
    where = f"{table.source}, line {table.names_line}"
    if not names or names[0].lower() != "symbol" or len(names) < 2:
        raise Refused("covariance-head", where)
    if len(names) > MOST_ERRORS + 1:
        raise Refused("covariance-too-large", where, count=len(names) - 1, most=MOST_ERRORS)
    components = [machine.component(n, where) for n in names[1:]]
    symbols = tuple(c.symbol for c in components)
    if len(set(symbols)) < len(symbols):
        twice = next(s for s in symbols if symbols.count(s) > 1)
        raise Refused("covariance-twice", where, symbol=twice)
    rows = [
        machine.component(n, f"{table.source}, line {int(line)}").symbol for n, line in zip(table.cells[0], table.line)
    ]
    if sorted(rows) != sorted(symbols):
        raise Refused("covariance-rows", table.source, rows=rows[:10], columns=list(symbols[:10]))
    values = np.column_stack([table.numbers(j) for j in range(1, len(names))])
    scale = np.array([c.from_shown(1.0) for c in components])
    order = [rows.index(s) for s in symbols]
    return symbols, checked_covariance(values[order] * np.outer(scale, scale), len(symbols), table.source)


def to_dict(result: CorrelatedResult) -> dict:
    """correlated.json as plain data."""
    return {
        **study_pages.head(FORMAT, VERSION, result.machine),
        "inputs": "fit" if result.of_fit else "tolerances",
        "mean_square_um2": um(um(result.mean_square)),
        "variance_um4": um(um(um(um(result.variance)))),
        "components": [{"body": s.name, **_shares(s)} for s in result.components],
        "blocks": [{"errors": list(names), "share": share} for names, share in result.blocks],
        "errors": [{"symbol": s.name, **_shares(s)} for s in result.errors],
    }


def _shares(share: Share) -> dict:
    return {"share": share.share, "first": share.first, "total": share.total}


def shares_csv(result: CorrelatedResult) -> str:
    """Share of every component, block and error."""
    kinds = (("component", result.components), ("error", result.errors))
    rows = [
        (kind, neutral(s.name), *(f"{v:.9g}" for v in (s.share, s.first, s.total)))
        for kind, found in kinds
        for s in found
    ]
    rows += [("block", neutral(" ".join(names)), f"{share:.9g}", "", "") for names, share in result.blocks]
    return study_pages.table(["kind", "name", "share", "first", "total"], rows)


def _numbers(share: Share) -> list[str]:
    return [f"{v:.9g}" for v in (share.share, share.first, share.total)]


def report(result: CorrelatedResult, language: str = "en") -> str:
    """The page: shares of components, of blocks and of errors."""
    words, machine = Words(language), result.machine
    first = result.components[0]
    tiles = [
        (f"{um(result.mean_square**0.5):.3g} µm", words("correlated-rms")),
        (f"{100 * first.share:.0f} %", words.of(machine.body_title(first.name))),
    ]
    share = f"#{words('column-share')}"
    largest = max(s.share for s in result.components)
    of_components = [
        (
            html.body_label(s.name, words.of(machine.body_title(s.name))),
            *(f"{100 * v:.1f} %" for v in (s.share, s.first, s.total)),
            html.meter(max(s.share, 0.0), max(s.share, 0.0), largest),
        )
        for s in result.components
    ]
    heads = [words("column-component"), share, "#S", "#Sᵀ", ""]
    parts = [
        html.tiles(tiles),
        html.paragraph(words("correlated-of-fit" if result.of_fit else "correlated-of-tolerances"), soft=True),
        html.section(
            words("correlated-components"),
            html.paragraph(words("correlated-words"), soft=True),
            html.table(heads, of_components),
        ),
    ]
    blocks = [(", ".join(names), f"{100 * value:.1f} %") for names, value in result.blocks if len(names) > 1]
    if blocks:
        parts.append(
            html.section(words("correlated-blocks"), html.table([words("correlated-errors-of"), share], blocks))
        )
    if result.errors:
        rows = [(s.name, *(f"{100 * v:.1f} %" for v in (s.share, s.first, s.total))) for s in result.errors]
        parts.append(
            html.section(words("correlated-errors"), html.table([words("column-error"), share, "#S", "#Sᵀ"], rows))
        )
    return study_pages.page(
        words,
        words("correlated-title", machine=machine.name),
        words("correlated-subtitle"),
        *parts,
    )


def files(result: CorrelatedResult, language: str = "en") -> dict[str, str]:
    """Name -> text of every file of the set."""
    return {
        "correlated.json": json_text.dumps(to_dict(result)),
        "correlated.csv": shares_csv(result),
        "report.html": report(result, language),
    }
