# SPDX-License-Identifier: LGPL-2.1-or-later
"""Etalon exchange format, "Vendor" variant, as ISG and Beckhoff describe it (296430091): blocks `[EXX]` with
`Gridpoints = { position value ... }` and `[C0Y]` with `VALUE = ...`; `//` comments.

Values are errors in mm and rad, positions in mm.
"""

from __future__ import annotations

import re

import numpy as np

from sensworkbench.messages import Message, Refused
from sensworkbench.studies.error_tables import ErrorTable, ErrorTables, remark

from ...json_text import short
from .. import parameters
from ..base import Components
from ..numbers import finite

_BLOCK = re.compile(r"\[\s*(\w+)\s*\]$")
_VALUE = re.compile(r"VALUE\s*=\s*(\S+)$", re.IGNORECASE)
_GRID = re.compile(r"Gridpoints\s*=\s*\{\s*(.*)$", re.IGNORECASE)


class Etalon(Components):
    """Error parameters over the axis's own position."""

    name, title, sign = "etalon", "Etalon exchange format", "sign-etalon"
    file = "errors_etalon.txt"

    def holds(self, item):
        why = super().holds(item)
        if why is None and not item.declared and (item.component.line or item.axes != (item.component.body,)):
            return Message("table-own-position")
        return why

    def dumps(self, tables, title):
        return dumps(tables, title)

    def read(self, text, source):
        return loads(text, source)


FORMAT = Etalon()


def loads(text: str, source: str = "Etalon file") -> ErrorTables:
    """The tables in `text`; refuses unknown parameters and anything else that is not the format, with the line."""
    functions, constants, remarks = [], {}, []
    for name, line, value, rows in _blocks(text, source):
        kind = parameters.kind(name)
        if kind == "unknown":
            raise Refused("table-parameter-unknown", f"{source}, line {line}", name=short(name))
        if kind in ("rotary", "kinematic"):
            remarks.append(remark(f"parameter-ignored-{kind}", line, "warning", name=name[:20]))
        elif kind == "constant" and value is not None:
            constants[name] = (value, line)
        elif kind == "function" and rows:
            points, values = np.array(rows).T
            if len(np.unique(points)) < len(points):
                raise Refused("parameter-position-twice", f"{source}, line {line}", name=name[:20])
            functions.append(ErrorTable(name, (name[2],), points[:, None], values))
        else:
            wanted = "Gridpoints" if kind == "function" else "VALUE"
            raise Refused("etalon-without", f"{source}, line {line}", name=name[:20], wanted=wanted)
    if not functions and not constants:
        raise Refused("tables-empty", source, title=FORMAT.title)
    angles, notes = parameters.squareness_of(constants)
    return ErrorTables(tuple(functions), angles, tuple(remarks + notes))


def _blocks(text: str, source: str):
    """(name, line, VALUE or None, rows of Gridpoints) of every block."""
    found: dict[str, list] = {}
    current, inside = None, False
    for number, line in enumerate(text.splitlines(), start=1):
        bare = line.split("//", 1)[0].strip()
        where = f"{source}, line {number}"
        block, value, grid = _BLOCK.match(bare), _VALUE.match(bare), _GRID.match(bare)
        if not bare:
            continue
        if block and not inside:
            name = block.group(1).upper()
            if name in found:
                raise Refused("etalon-block-twice", where, name=name[:20])
            current = found[name] = [name, number, None, []]
        elif current is None:
            raise Refused("etalon-before-block", where, text=short(bare))
        elif value and not inside:
            current[2] = finite(value.group(1), where)
        elif grid and not inside:
            inside, bare = True, grid.group(1)
            inside = _rows(bare, current[3], where)
        elif inside:
            inside = _rows(bare, current[3], where)
        elif current[0] in found and parameters.kind(current[0]) in ("rotary", "kinematic", "unknown"):
            continue
        else:
            raise Refused("etalon-neither", where, text=short(bare))
    if inside:
        raise Refused("etalon-open", source)
    return [tuple(b) for b in found.values()]


def _rows(text: str, rows: list, where: str) -> bool:
    """Add "position value" to `rows`; False once the closing brace has come."""
    body, brace, rest = text.partition("}")
    if rest.strip():
        raise Refused("etalon-behind-brace", where, text=short(rest.strip()))
    cells = body.replace(",", " ").split()
    if cells:
        if len(cells) != 2:
            raise Refused("etalon-not-a-pair", where, text=short(body.strip()))
        rows.append((finite(cells[0], where), finite(cells[1], where)))
    return not brace


def dumps(tables: ErrorTables, title: str = "") -> str:
    """The exchange text of `tables`; a table of more than one argument is refused."""
    lines = [f"// {title}"] if title else []
    lines += ["// errors (actual - nominal, tool relative to workpiece), ISO 230-1; mm, rad"]
    for name in sorted(tables.constants):
        lines += [f"[{name}]", f"VALUE = {tables.constants[name]:.12f}"]
    for table in tables.tables:
        if table.arguments != (table.symbol[2],):
            raise Refused("etalon-other-arguments", "Etalon file", symbol=table.symbol, arguments=list(table.arguments))
        lines += [f"[{table.symbol}]", "Gridpoints = {"]
        lines += [f"    {p:.6f} {v:.12f}" for p, v in zip(table.points[:, 0], table.values, strict=True)]
        lines += [f"}}  // end of {table.symbol}"]
    return "\n".join(lines) + "\n"
