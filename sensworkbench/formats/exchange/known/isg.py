# SPDX-License-Identifier: LGPL-2.1-or-later
"""ISG CSV, the error tables of ISG kernels and Beckhoff TF5280 (format pages read: isg-stuttgart.de 296429067,
296423819, 296426379).

Blank-separated columns under a header of argument and parameter names, `//` comments, `#` before a further table.
Values are errors in mm and rad by ISO 230-1, positions in mm.
"""

from __future__ import annotations

import numpy as np

from sensworkbench.messages import Refused
from sensworkbench.studies.error_tables import ErrorTable, ErrorTables, remark

from ...json_text import short
from .. import parameters
from ..base import Components
from ..numbers import finite

ARGUMENTS = "XYZABC"


class Isg(Components):
    """Error parameters over one, two or three positions."""

    name, title, sign = "isg", "ISG CSV (Beckhoff TF5280)", "sign-isg"
    file = "errors_isg.csv"

    def dumps(self, tables, title):
        return dumps(tables, title)

    def read(self, text, source):
        return loads(text, source)


FORMAT = Isg()


def loads(text: str, source: str = "ISG CSV") -> ErrorTables:
    """The tables in `text`; refuses unknown parameters, ragged rows and text where a number belongs, with the line."""
    functions, constants, remarks, seen = [], {}, [], {}
    for block in _blocks(text):
        _read_block(block, source, functions, constants, remarks, seen)
    if not functions and not constants:
        raise Refused("tables-empty", source, title=FORMAT.title)
    angles, notes = parameters.squareness_of(constants)
    return ErrorTables(tuple(functions), angles, tuple(remarks + notes))


def _blocks(text: str):
    block: list[tuple[int, list[str]]] = []
    for number, line in enumerate(text.splitlines(), start=1):
        bare = line.split("//", 1)[0].strip()
        if bare.startswith("#"):
            yield block
            block, bare = [], ""  # what stands behind the break is no header
        if bare:
            block.append((number, bare.replace(";", " ").replace(",", " ").split()))
    yield block


def _read_block(block, source, functions, constants, remarks, seen) -> None:
    if not block:
        return
    head, names = block[0]
    names = [n.upper() for n in names]
    arguments = [n for n in names if len(n) == 1 and n in ARGUMENTS]
    for n in names:
        if n not in arguments and parameters.kind(n) == "unknown":
            raise Refused("table-parameter-unknown", f"{source}, line {head}", name=short(n))
        if names.count(n) > 1:
            raise Refused("table-column-twice", f"{source}, line {head}", name=short(n))
    if len(block) == 1:
        raise Refused("table-without-rows", f"{source}, line {head}")
    rows = np.array([_numbers(cells, len(names), f"{source}, line {line}") for line, cells in block[1:]])
    points = rows[:, [names.index(a) for a in arguments]]
    if len(np.unique(points, axis=0)) < len(points) and arguments:
        raise Refused("table-rows-twice", f"{source}, line {head} ff.")
    for j, n in enumerate(names):
        if n in arguments:
            continue
        if n in seen:
            raise Refused("parameter-twice", f"{source}, lines {seen[n]} and {head}", name=n)
        seen[n] = head
        kind = parameters.kind(n)
        if kind in ("rotary", "kinematic"):
            remarks.append(remark(f"parameter-ignored-{kind}", head, "warning", name=n))
        elif set(arguments) - set("XYZ"):
            remarks.append(remark("parameter-ignored-argument", head, "warning", name=n))
        elif arguments and (kind == "function" or n in ("C0Y", "A0Z", "B0Z")):
            functions.append(ErrorTable(n, tuple(arguments), points, rows[:, j]))
        elif len(rows) == 1 and kind == "constant":
            constants[n] = (float(rows[0, j]), head)
        else:
            raise Refused("parameter-without-argument", f"{source}, line {head}", name=n)


def _numbers(cells, count: int, where: str) -> list[float]:
    if len(cells) != count:
        raise Refused("table-row-ragged", where, values=len(cells), names=count)
    return [finite(c, where) for c in cells]


def dumps(tables: ErrorTables, title: str = "") -> str:
    """ISG CSV of `tables`: the position errors first, then one block per set of arguments and positions."""
    lines = [f"// {title}"] if title else []
    lines += ["// errors (actual - nominal, tool relative to workpiece), ISO 230-1; mm, rad"]
    blocks: list[list[str]] = []
    if tables.constants:
        names = sorted(tables.constants)
        blocks.append([_row(names), _row([_angle(tables.constants[n]) for n in names])])
    grouped: dict[tuple, list[ErrorTable]] = {}
    for table in tables.tables:
        grouped.setdefault((table.arguments, table.points.tobytes()), []).append(table)
    for (arguments, _), group in grouped.items():
        block = [_row([*arguments, *(t.symbol for t in group)])]
        for i, point in enumerate(group[0].points):
            block.append(_row([*(f"{v:.6f}" for v in point), *(f"{t.values[i]:.12g}" for t in group)]))
        blocks.append(block)
    return "\n".join(lines) + "\n" + "\n#\n".join("\n".join(b) for b in blocks) + "\n"


def _angle(value: float) -> str:
    return f"{value:.12g}"


def _row(cells) -> str:
    return " ".join(f"{c:>16}" for c in cells).strip()
