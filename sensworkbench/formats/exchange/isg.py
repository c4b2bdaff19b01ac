# SPDX-License-Identifier: LGPL-2.1-or-later
"""ISG CSV, the error tables of ISG kernels and Beckhoff TF5280 (format pages read: isg-stuttgart.de 296429067,
296423819, 296426379).

Blank-separated columns under a header of argument and parameter names, `//` comments, `#` before a further table.
Values are errors in mm and rad by ISO 230-1, positions in mm.
"""

from __future__ import annotations

import numpy as np

from sensworkbench.closedloop.readings import Finding
from sensworkbench.core.refusal import Refused

from ..json_text import short
from . import parameters
from .numbers import finite
from .tables import ErrorTable, ErrorTables

ARGUMENTS = "XYZABC"


def loads(text: str, source: str = "ISG CSV") -> ErrorTables:
    """The tables in `text`; refuses unknown parameters, ragged rows and text where a number belongs, with the line."""
    functions, constants, findings, seen = [], {}, [], {}
    for block in _blocks(text):
        _read_block(block, source, functions, constants, findings, seen)
    if not functions and not constants:
        raise Refused("the file holds no error of a linear axis", source, "Is it an ISG CSV table?")
    angles, notes = parameters.squareness_of(constants)
    return ErrorTables(tuple(functions), angles, tuple(findings + notes))


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


def _read_block(block, source, functions, constants, findings, seen) -> None:
    if not block:
        return
    head, names = block[0]
    names = [n.upper() for n in names]
    arguments = [n for n in names if len(n) == 1 and n in ARGUMENTS]
    for n in names:
        if n not in arguments and parameters.kind(n) == "unknown":
            raise Refused(f"unknown parameter {short(n)}", f"{source}, line {head}", "Use ISO 230-1 names such as EXX.")
        if names.count(n) > 1:
            raise Refused(f"column {n!r} stands twice", f"{source}, line {head}", "Keep one.")
    if len(block) == 1:
        raise Refused("a header without values", f"{source}, line {head}", "Give at least one row.")
    rows = np.array([_numbers(cells, len(names), f"{source}, line {line}") for line, cells in block[1:]])
    points = rows[:, [names.index(a) for a in arguments]]
    if len(np.unique(points, axis=0)) < len(points) and arguments:
        raise Refused("two rows for one position", f"{source}, line {head} ff.", "Keep one.")
    for j, n in enumerate(names):
        if n in arguments:
            continue
        if n in seen:
            raise Refused(f"{n} is given twice", f"{source}, lines {seen[n]} and {head}", "Keep one table.")
        seen[n] = head
        kind = parameters.kind(n)
        if kind in ("rotary", "kinematic"):
            what = "belongs to a rotary axis" if kind == "rotary" else "describes kinematics"
            findings.append(Finding("warning", "parameter-ignored", f"{n} {what}: not used", head))
        elif set(arguments) - set("XYZ"):
            text = f"{n} depends on a rotary axis: not used"
            findings.append(Finding("warning", "parameter-ignored", text, head))
        elif arguments and (kind == "function" or n in ("C0Y", "A0Z", "B0Z")):
            functions.append(ErrorTable(n, tuple(arguments), points, rows[:, j]))
        elif len(rows) == 1 and kind == "constant":
            constants[n] = (float(rows[0, j]), head)
        else:
            raise Refused(
                f"{n} has no argument it could depend on", f"{source}, line {head}", "Add a column X, Y or Z."
            )


def _numbers(cells, count: int, where: str) -> list[float]:
    if len(cells) != count:
        raise Refused(f"{len(cells)} values under {count} names", where, "Every row needs one value per column.")
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
