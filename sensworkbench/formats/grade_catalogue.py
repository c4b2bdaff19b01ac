# SPDX-License-Identifier: LGPL-2.1-or-later
"""A catalogue of grades: what guides, screws and scales of each grade may deviate over a travel, and where that is
printed.

Rows of `family,grade,from_mm,to_mm,w_um,per_mm,cost,source`.  A family belongs to errors of every linear joint; a grade
is offered where its row holds for the travel of the joint.  An empty cost is relative to the machine: 1 for the present
half width of an error, and twice as much for half of it.
"""

from __future__ import annotations

import math
from pathlib import Path

from sensworkbench.core.allocation import Cost, Grade, GradeCost
from sensworkbench.core.machine import Machine
from sensworkbench.core.refusal import Refused
from sensworkbench.core.units import mm

from . import csv_table

SHIPPED = Path(__file__).resolve().parents[2] / "resources" / "catalogue" / "grades.csv"
NAME = "catalogue"  # what --costs takes for the file that comes with the program
COLUMNS = ("family", "grade", "from_mm", "to_mm", "w_um", "per_mm", "cost", "source")
FAMILIES = {"guide": "straightness", "screw": "positioning", "scale": "positioning"}
_LIMIT = 1e12


def place(path) -> Path:
    """The file that is meant: that of the program for the word `catalogue`, unless there is a file of this name."""
    return SHIPPED if str(path) == NAME and not Path(path).exists() else Path(path)


def is_catalogue(table: csv_table.Table) -> bool:
    """Whether a table is one of grades, by its columns."""
    return "family" in [n.strip().lower() for n in table.names]


def costs(table: csv_table.Table, machine: Machine) -> tuple[dict[str, Cost], bool]:
    """(symbol -> its grades, widths in mm; whether any cost is relative).  Refuses with line and column."""
    names = [n.strip().lower() for n in table.names]
    for name in names:
        if name not in COLUMNS or names.count(name) > 1:
            raise Refused("cost-column", f"{table.source}, line {table.names_line}", column=name[:60], known=COLUMNS)
    for needed in COLUMNS:
        if needed not in names:
            raise Refused("cost-column-missing", f"{table.source}, line {table.names_line}", column=needed)
    cells = {name: table.cells[j] for j, name in enumerate(names)}
    present = machine.all_tolerances
    grades: dict[str, list[Grade]] = {}
    relative = False
    for row, line in enumerate(table.line):
        where = f"{table.source}, line {int(line)}"
        family = cells["family"][row].strip().lower()
        if family not in FAMILIES:
            raise Refused("cost-kind", f"{where}, column family", kind=repr(family)[:60], known=list(FAMILIES))
        low, high, w = (_number(cells, row, where, name) for name in ("from_mm", "to_mm", "w_um"))
        per, price = (_number(cells, row, where, name, empty=True) for name in ("per_mm", "cost"))
        if not (0 <= low < high and w > 0 and (per is None or per > 0)):
            raise Refused("cost-grades-invalid", where)
        for symbol, length in _errors(machine, FAMILIES[family]):
            law = present.get(symbol)
            half = 0.0 if law is None else (law.upper - law.lower) / 2
            if not low < length <= high or half <= 0:
                continue
            width = mm(w) * (1.0 if per is None else length / per)
            relative = relative or price is None
            name = f"{family} {cells['grade'][row].strip()}"
            grades.setdefault(symbol, []).append(Grade(name, width, half / width if price is None else price))
    if not grades:
        raise Refused("cost-none", table.source)
    return {symbol: GradeCost(tuple(found)) for symbol, found in grades.items()}, relative


def _errors(machine: Machine, kind: str):
    """(symbol, travel in mm) of the straightness or positioning errors of every linear joint."""
    for joint in machine.joints:
        if not joint.slides or joint.travel is None:
            continue
        length = float(joint.travel[1] - joint.travel[0])
        own = int(max(range(3), key=lambda i: abs(joint.direction[i])))
        for i, axis in enumerate("XYZ"):
            symbol = f"E{axis}{joint.name}"
            if (i == own) == (kind == "positioning") and symbol in machine.all_tolerances:
                yield symbol, length


def _number(cells, row: int, where: str, column: str, empty: bool = False) -> float | None:
    text = cells[column][row].strip()
    if empty and not text:
        return None
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if "_" in text or not abs(value) < _LIMIT:
        raise Refused("cost-not-a-number", f"{where}, column {column}", text=repr(text)[:60])
    return value
