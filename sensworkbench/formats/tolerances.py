# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tolerances as a table of their own: CSV for a spreadsheet, JSON for a program, both with units.

CSV: `symbol, lower, upper, unit, distribution, sigma` (the last three may be missing: um or urad, uniform, none), `#`
lines are comments, a semicolon may separate the cells, a limit may carry its own unit ("12 arcsec").  JSON:
{"format": "sens-tolerances", "version": 1, "tolerances": {...}} with the entries of machine.json.
"""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Mapping
from pathlib import Path

from sensworkbench.core.distributions import Tolerance
from sensworkbench.core.errors import Component, component
from sensworkbench.core.refusal import Refused
from sensworkbench.core.units import parse as parse_quantity
from sensworkbench.core.units import shown

from .files import neutral, read_text, write_text
from .json_text import parse as parse_json
from .json_text import short
from .machine_json import tolerance_dict
from .machine_json import tolerances as from_json

FORMAT, VERSION = "sens-tolerances", 1
COLUMNS = ("symbol", "lower", "upper", "unit", "distribution", "sigma")
_SHOWN = 5  # further findings whose places one refusal lists
_LIMIT = 2 * 2**20


def load(path, known=component) -> dict[str, Tolerance]:
    """symbol -> Tolerance of a .csv or .json file.  Refuses with every finding's line and column.

    known : look-up of a symbol with its place among a machine's components; so in the functions below.
    """
    text = read_text(path, _LIMIT)
    if text.lstrip()[:1] in ("{", "["):
        return loads_json(text, str(path), known)
    return loads_csv(text, str(path), known)


def save(tolerances: Mapping[str, Tolerance], path, angle_unit: str = "urad") -> None:
    """Write .json, or CSV under any other ending, in one step."""
    dumps = dumps_json if Path(path).suffix.lower() == ".json" else dumps_csv
    write_text(path, dumps(tolerances, angle_unit))


def loads_json(text: str, name: str = "tolerances.json", known=component) -> dict[str, Tolerance]:
    """symbol -> Tolerance of a tolerance file, or of the tolerances in a machine file."""
    top = parse_json(text, name)
    kind = top.value.get("format") if isinstance(top.value, dict) else None
    if kind not in (FORMAT, "sens-machine"):
        raise top.refuse("json-not-tolerances", format=FORMAT)
    if kind == FORMAT:
        top.keys(("format", "version", "tolerances"), ("format", "version", "tolerances"))
        if isinstance(top.value["version"], bool) or top.value["version"] != VERSION:
            raise top["version"].refuse("json-version", version=short(top.value["version"]), known=[VERSION])
    elif "tolerances" not in top:
        raise top.refuse("machine-without-tolerances")
    return from_json(top["tolerances"], known)


def dumps_json(tolerances: Mapping[str, Tolerance], angle_unit: str = "urad") -> str:
    """The text of a tolerance file."""
    table = {s: tolerance_dict(s, t, _unit(component(s), angle_unit)) for s, t in tolerances.items()}
    data = {"format": FORMAT, "version": VERSION, "tolerances": table}
    return json.dumps(data, indent=1, ensure_ascii=False, allow_nan=False) + "\n"


def _unit(c: Component, angle_unit: str) -> str:
    return angle_unit if c.angular else "um"


def dumps_csv(tolerances: Mapping[str, Tolerance], angle_unit: str = "urad", known=component) -> str:
    """The table as CSV."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(COLUMNS)
    for symbol, tolerance in tolerances.items():
        row = tolerance_dict(symbol, tolerance, _unit(known(symbol), angle_unit), known) | {"symbol": neutral(symbol)}
        writer.writerow([row.get(c, "") for c in COLUMNS])
    return stream.getvalue()


def loads_csv(text: str, name: str = "tolerances.csv", known=component) -> dict[str, Tolerance]:
    """symbol -> Tolerance of a table.  All findings are collected and refused together."""
    lines = [(n, line) for n, line in enumerate(text.splitlines(), start=1) if line.strip() and line.lstrip()[0] != "#"]
    if not lines:
        raise Refused("tolerance-table-empty", name, columns=list(COLUMNS))
    first, header = lines[0]
    mark = max(",;\t", key=header.count)
    names = [c.strip().lower() for c in _cells(header, mark, f"{name}, line {first}")]
    for column in names:
        if column not in COLUMNS:
            raise Refused("tolerance-column", f"{name}, line {first}", column=short(column), columns=list(COLUMNS))
        if names.count(column) > 1:
            raise Refused("tolerance-column-twice", f"{name}, line {first}", column=short(column))
    for column in COLUMNS[:3]:
        if column not in names:
            raise Refused("tolerance-column-missing", f"{name}, line {first}", column=column, columns=list(COLUMNS))
    found: dict[str, Tolerance] = {}
    findings: list[Refused] = []
    signs: dict[str, str] = {}
    for number, line in lines[1:]:
        where = f"{name}, line {number}"
        try:
            cells = _cells(line, mark, where)
            _check_decimals(names, cells, mark, where, signs)
            symbol, tolerance = _row(names, cells, where, known)
            if symbol in found:
                raise Refused("tolerance-twice", f"{where}, column symbol", symbol=symbol)
            found[symbol] = tolerance
        except Refused as refused:
            findings.append(refused)
    if findings:
        if len(findings) == 1:
            raise findings[0]
        places = [f.where.removeprefix(f"{name}, ") for f in findings[1 : _SHOWN + 1]]
        raise Refused("tolerance-findings", "", first=findings[0], count=len(findings) - 1, places=places)
    if not found:
        raise Refused("tolerance-none", name)
    return found


def _cells(line: str, mark: str, where: str) -> list[str]:
    try:
        return next(csv.reader([line], delimiter=mark), [])
    except csv.Error as error:
        raise Refused("table-cell", where, why=str(error)) from None


def _check_decimals(names, cells, mark: str, where: str, signs: dict[str, str]) -> None:
    """Refuse a comma in a number where commas separate the cells, and a file with both decimal signs.

    signs : decimal sign -> the first cell that has it, over the whole file.
    """
    for column, cell in zip(names, cells):
        if column in ("lower", "upper", "sigma"):
            for sign in ",.":
                if sign in cell:
                    if sign == mark:
                        raise Refused("decimal-comma", f"{where}, column {column}", cell=short(cell))
                    signs.setdefault(sign, cell)
            if len(signs) == 2:
                a, b = signs["."][:25], signs[","][:25]
                raise Refused("decimal-mixed", f"{where}, column {column}", cell=short(a), other=short(b))


def _row(names: list[str], cells: list[str], where: str, known) -> tuple[str, Tolerance]:
    if len(cells) > len(names):
        raise Refused("tolerance-cells", where, cells=len(cells), columns=len(names))
    row = dict.fromkeys(COLUMNS, "") | {n: c.strip() for n, c in zip(names, cells)}
    c = known(row["symbol"], f"{where}, column symbol")
    unit = row["unit"] or c.unit
    values: dict[str, float | None] = {"sigma": None}
    for column in ("lower", "upper", "sigma"):
        if row[column]:
            place = f"{where}, column {column}"
            values[column] = parse_quantity(row[column], angular=c.angular, default_unit=unit, where=place)
        elif column != "sigma":
            raise Refused("tolerance-limit-missing", f"{where}, column {column}", symbol=c.symbol, limit=column)
    if values["upper"] < values["lower"]:
        low, high = (shown(values[k], unit, angular=c.angular) for k in ("lower", "upper"))
        raise Refused("tolerance-limits-reversed", f"{where}, column upper", lower=low, upper=high)
    try:
        law = row["distribution"] or "uniform"
        return c.symbol, Tolerance(values["lower"], values["upper"], law, values["sigma"])
    except Refused as refused:
        column = next((c for c in ("distribution", "sigma") if refused.code.startswith(c)), "upper")
        raise Refused(refused.code, f"{where}, column {column}", **refused.fields) from None
