# SPDX-License-Identifier: LGPL-2.1-or-later
"""predicted.csv: the columns of a positions file as they stand, with the predicted error beside every row.

Separator and decimal sign stay those of the positions file, so that the result opens wherever that one did.
"""

from __future__ import annotations

import numpy as np

from sensworkbench.closedloop.readings import Readings
from sensworkbench.core.refusal import Refused
from sensworkbench.core.units import um

from . import column_names, csv_table
from .column_names import ERROR, PREDICTED_U
from .file_sets import staged_file
from .files import write_text
from .readings_conventions import question


def save_predicted(path, source, positions: Readings, error, extrapolated=None, mapping=None, u=None) -> None:
    """The table `source` (a POSITIONS file) with ex_um, ey_um, ez_um behind, in the order of that file, atomically.

    positions : what `load_positions(source)` gave.  error : (P, 3) mm, in the order of `positions` (actual minus
    commanded).  u : (P, 3) mm its standard uncertainty, written as u_ex_um, u_ey_um, u_ez_um; NaN: an empty cell; None:
    no such columns.  extrapolated : (P,) truth, written as 0 or 1.  Separator and decimal sign stay those of the file.
    """
    table = csv_table.read(source)
    error = np.asarray(error, dtype=float)
    if error.shape != (table.rows, 3) or not np.array_equal(np.sort(positions.line), table.line):
        raise Refused("predictions-of-another-file", table.source)
    order = np.argsort(positions.line)
    decimal_comma = any(_has_decimal_comma(table, j) for j in range(len(table.names)))
    number = (lambda v: f"{v:.6f}".replace(".", ",")) if decimal_comma else (lambda v: f"{v:.6f}")
    ours = {v: k for k, v in (mapping or {}).items() if isinstance(v, str)}
    results = {*ERROR, *PREDICTED_U, "extrapolated"}
    names = [ours.get(name, name) for name in table.names]
    kept = [j for j, n in enumerate(names) if n and column_names.parse(n).base not in results]
    header = [csv_table.safe_cell(names[j]) for j in kept] + ["ex_um", "ey_um", "ez_um"]
    columns = [[csv_table.safe_cell(c) for c in table.cells[j]] for j in kept]
    for key, value in (mapping or {}).items():
        if isinstance(value, (int, float)) and column_names.parse(key).base not in results:
            header.insert(len(kept), key)
            columns.append([f"{value:g}".replace(".", ",") if decimal_comma else f"{value:g}"] * table.rows)
    columns += [[number(v) for v in um(error[order, i])] for i in range(3)]
    if u is not None:
        header += [f"{name}_um" for name in PREDICTED_U]
        values = um(np.asarray(u, dtype=float)[order])
        columns += [["" if np.isnan(v) else number(v) for v in values[:, i]] for i in range(3)]
    if extrapolated is not None:
        header.append("extrapolated")
        columns.append([str(int(v)) for v in np.asarray(extrapolated, dtype=bool)[order]])
    lines = [f"# {text}" for _, text in table.comments if question(text) == "positions"]
    lines += [
        table.separator.join(_quoted(c, table.separator) for c in row) for row in (header, *zip(*columns, strict=True))
    ]
    with staged_file(path, "predict") as work:
        write_text(work, "\n".join(lines) + "\n")


def _has_decimal_comma(table: csv_table.Table, column: int) -> bool:
    """Whether a cell of the column is a number with a decimal comma."""
    if not table.comma(column):
        return False
    cells = (c for block in table.cells.blocks(column) for c in block if "," in c)
    return any(csv_table.is_number(c.replace(",", ".")) for c in cells)


def _quoted(cell: str, separator: str) -> str:
    return '"' + cell.replace('"', '""') + '"' if separator in cell or '"' in cell else cell
