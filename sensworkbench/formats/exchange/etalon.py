# SPDX-License-Identifier: LGPL-2.1-or-later
"""Etalon exchange format, "Vendor" variant, as ISG and Beckhoff describe it (296430091): blocks `[EXX]` with
`Gridpoints = { position value ... }` and `[C0Y]` with `VALUE = ...`; `//` comments.

Values are errors in mm and rad, positions in mm.
"""

from __future__ import annotations

import re

import numpy as np

from sensworkbench.closedloop.readings import Finding
from sensworkbench.core.refusal import Refused

from ..json_text import short
from . import parameters
from .numbers import finite
from .tables import ErrorTable, ErrorTables

_BLOCK = re.compile(r"\[\s*(\w+)\s*\]$")
_VALUE = re.compile(r"VALUE\s*=\s*(\S+)$", re.IGNORECASE)
_GRID = re.compile(r"Gridpoints\s*=\s*\{\s*(.*)$", re.IGNORECASE)


def loads(text: str, source: str = "Etalon file") -> ErrorTables:
    """The tables in `text`; refuses unknown parameters and anything else that is not the format, with the line."""
    functions, constants, findings = [], {}, []
    for name, line, value, rows in _blocks(text, source):
        kind = parameters.kind(name)
        if kind == "unknown":
            raise Refused(
                f"unknown parameter {short(name)}", f"{source}, line {line}", "Use ISO 230-1 names such as EXX."
            )
        if kind in ("rotary", "kinematic"):
            what = "belongs to a rotary axis" if kind == "rotary" else "describes kinematics"
            findings.append(Finding("warning", "parameter-ignored", f"{name} {what}: not used", line))
        elif kind == "constant" and value is not None:
            constants[name] = (value, line)
        elif kind == "function" and rows:
            points, values = np.array(rows).T
            if len(np.unique(points)) < len(points):
                raise Refused(f"{name} has two values at one position", f"{source}, line {line}", "Keep one.")
            functions.append(ErrorTable(name, (name[2],), points[:, None], values))
        else:
            wanted = "Gridpoints" if kind == "function" else "VALUE"
            raise Refused(f"[{name[:20]}] has no {wanted}", f"{source}, line {line}", f"Give {wanted}.")
    if not functions and not constants:
        raise Refused("the file holds no error of a linear axis", source, "Is it an Etalon exchange file?")
    angles, notes = parameters.squareness_of(constants)
    return ErrorTables(tuple(functions), angles, tuple(findings + notes))


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
                raise Refused(f"[{name[:20]}] stands twice", where, "Keep one.")
            current = found[name] = [name, number, None, []]
        elif current is None:
            raise Refused(
                f"{short(bare)} stands before the first [parameter]", where, "Begin with a block such as [EXX]."
            )
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
            raise Refused(f"{short(bare)} is neither VALUE nor Gridpoints", where, "Write one of these.")
    if inside:
        raise Refused("the file ends inside Gridpoints", source, "Close it with }.")
    return [tuple(b) for b in found.values()]


def _rows(text: str, rows: list, where: str) -> bool:
    """Add "position value" to `rows`; False once the closing brace has come."""
    body, brace, rest = text.partition("}")
    if rest.strip():
        raise Refused(f"{short(rest.strip())} behind the closing brace", where, "Begin a new line.")
    cells = body.replace(",", " ").split()
    if cells:
        if len(cells) != 2:
            raise Refused(f"{short(body.strip())} is not a position and a value", where, "Write two numbers.")
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
            raise Refused(f"{table.symbol} depends on {', '.join(table.arguments)}", "Etalon file")
        lines += [f"[{table.symbol}]", "Gridpoints = {"]
        lines += [f"    {p:.6f} {v:.12f}" for p, v in zip(table.points[:, 0], table.values, strict=True)]
        lines += [f"}}  // end of {table.symbol}"]
    return "\n".join(lines) + "\n"
