# SPDX-License-Identifier: LGPL-2.1-or-later
"""costs.csv: what a tolerance costs.

Rows of `symbol, kind, c, k, lower, upper` (kind `power`: c / w^k for a half width w from lower to upper) and of
`symbol, kind, grade, w, cost` (kind `grades`, one row per grade); w in um or urad.  A catalogue of grades
(`grade_catalogue`) is read too.
"""

from __future__ import annotations

import math

from sensworkbench.core.allocation import Cost, Grade, GradeCost, PowerCost
from sensworkbench.core.machine import Machine
from sensworkbench.core.refusal import Refused

from . import csv_table, grade_catalogue

COLUMNS = ("symbol", "kind", "c", "k", "lower", "upper", "grade", "w", "cost")
KINDS = ("power", "grades")
_LIMIT = 1e12


def load_all(paths, machine: Machine) -> dict[str, Cost]:
    """The costs of several files: of an error that stands in more than one, those of the first."""
    found: dict[str, Cost] = {}
    for path in paths:
        found = load(path, machine) | found
    return found


def unpriced(path, machine: Machine) -> bool:
    """Whether a file is a catalogue of grades with costs that are relative to the present tolerances."""
    table = csv_table.read(grade_catalogue.place(path))
    return grade_catalogue.is_catalogue(table) and grade_catalogue.costs(table, machine)[1]


def load(path, machine: Machine) -> dict[str, Cost]:
    """symbol -> cost, widths in mm or rad.  Refuses with line and column of what is wrong."""
    table = csv_table.read(grade_catalogue.place(path))
    if grade_catalogue.is_catalogue(table):
        return grade_catalogue.costs(table, machine)[0]
    names = [n.strip().lower() for n in table.names]
    for name in names:
        if name not in COLUMNS or names.count(name) > 1:
            raise Refused("cost-column", f"{table.source}, line {table.names_line}", column=name[:60], known=COLUMNS)
    for needed in ("symbol", "kind"):
        if needed not in names:
            raise Refused("cost-column-missing", f"{table.source}, line {table.names_line}", column=needed)
    cells = {name: table.cells[j] for j, name in enumerate(names)}
    found: dict[str, Cost] = {}
    grades: dict[str, list[Grade]] = {}
    for row, line in enumerate(table.line):
        where = f"{table.source}, line {int(line)}"
        c = machine.component(cells["symbol"][row], f"{where}, column symbol")
        kind = cells["kind"][row].strip().lower()
        if kind not in KINDS:
            raise Refused("cost-kind", f"{where}, column kind", kind=repr(kind)[:60], known=list(KINDS))

        def number(column, row=row, where=where):
            text = cells[column][row] if column in cells else ""
            try:
                value = float(text)
            except ValueError:
                value = math.nan
            if "_" in text or not abs(value) < _LIMIT:
                raise Refused("cost-not-a-number", f"{where}, column {column}", text=repr(text)[:60])
            return value

        if c.symbol in found or (kind == "power" and c.symbol in grades):
            raise Refused("cost-twice", where, symbol=c.symbol)
        try:
            if kind == "power":
                k, one = number("k"), c.from_shown(1.0)
                size = number("c") * one**k  # c / w^k with w in mm or rad
                found[c.symbol] = PowerCost(size, k, c.from_shown(number("lower")), c.from_shown(number("upper")))
            else:
                name = cells["grade"][row].strip() if "grade" in cells else ""
                grade = Grade(name or str(len(grades.get(c.symbol, [])) + 1), c.from_shown(number("w")), number("cost"))
                GradeCost((grade,))  # checked where it stands
                grades.setdefault(c.symbol, []).append(grade)
        except Refused as refused:
            raise refused if refused.where else refused.at(where) from None
        except OverflowError:
            raise Refused("cost-not-a-number", f"{where}, column k", text=repr(cells["k"][row])[:60]) from None
    found |= {symbol: GradeCost(tuple(rows)) for symbol, rows in grades.items()}
    if not found:
        raise Refused("cost-none", table.source)
    return found
