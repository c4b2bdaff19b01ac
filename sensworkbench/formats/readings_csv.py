# SPDX-License-Identifier: LGPL-2.1-or-later
"""measured.csv and positions.csv: a text table becomes `Readings`, and predicted errors become a table again.

Nothing is dropped silently: what is converted, assumed, derived, left out or suspicious is a `Remark` with its line,
and what cannot be understood is refused with file, line and column.  The grammar is described in docs/formats.md.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from sensworkbench.closedloop.readings import Readings, Remark
from sensworkbench.core.joints import Joint, linear
from sensworkbench.core.refusal import Refused
from sensworkbench.messages import Message

from . import column_names, csv_table
from .column_names import DIRECTION, ERROR, NORMAL, PREDICTED_U, TOOL
from .csv_table import Table
from .json_text import short
from .predicted_csv import save_predicted
from .readings_conventions import ANSWERS, NOT_IN_READINGS, check_mapping, load_mapping, read_answers
from .readings_order import approach_directions, backwards, time_order
from .readings_records import read_records

__all__ = [
    "load",
    "load_positions",
    "positions_of",
    "load_mapping",
    "check_mapping",
    "save_predicted",
    "approach_directions",
]

THREE_AXES = tuple(linear(k, u, (0, 0, 0), (0, 1)) for k, u in zip("XYZ", ((1, 0, 0), (0, 1, 0), (0, 0, 1))))
HUGE_MM = 10.0  # an error beyond this is more likely a position or a wrong unit
FEW_ROWS = 12
NOT_DRIVERS = frozenset((*ERROR, *NORMAL, *PREDICTED_U, "reading", "u"))
MAX_GAPS = 0.1  # a driver with more empty cells than this is left out as a column, otherwise its empty rows are


def load(path, mapping=None, joints=THREE_AXES) -> Readings:
    """Readings of a measured.csv; `mapping` as `load_mapping` returns, for a file with other column names.

    joints : the machine's joints (default: linear X, Y, Z), whose positions are the columns <name>_mm or <name>_deg.
    """
    return _Reader(csv_table.read(path), mapping, tuple(joints)).readings()


def load_positions(path, mapping=None, joints=THREE_AXES) -> Readings:
    """Places and conditions without readings (R = 0 rows); every row of the file is kept.  joints : as in `load`."""
    return _Reader(csv_table.read(path), mapping, tuple(joints)).positions()


def positions_of(table: Table, mapping=None, joints=THREE_AXES) -> Readings:
    """As `load_positions`, of a table that was read already."""
    return _Reader(table, mapping, tuple(joints)).positions()


@dataclass
class _Reader:
    """One file on its way to `Readings`: names, then answers, then numbers, then order and directions."""

    table: Table
    mapping: Mapping | None = None
    joints: tuple[Joint, ...] = THREE_AXES

    def __post_init__(self):
        self.places = tuple(j.column for j in self.joints)
        self.directions = tuple(f"dir_{name}" for name in self.places)
        self.kinds = tuple((j.column, j.kind.angular) for j in self.joints)
        self.remarks: list[Remark] = []
        self.values: dict[str, np.ndarray] = {}
        self.units: dict[str, str] = {}
        self.categories: dict[str, np.ndarray] = {}
        self.run = None
        self.answers: dict[str, tuple[str, int]] = {}
        self.records: dict[str, str] = {}
        self.column_of: dict[str, int] = {}
        self.commas: dict[bool, int] = {}  # decimal comma or point -> the first column that has it

    # -- the two results -----------------------------------------------------------------------------------------
    def readings(self) -> Readings:
        self._read(measured=True)
        count = self.table.rows
        sensed = self._own_vectors()
        error = [self.values.get(n, np.full(count, np.nan)) for n in ERROR]
        self._sign_of_readings(error, sensed)
        value = np.stack([*error, sensed], axis=1)
        sense = np.zeros((count, 4, 3))
        sense[:, :3] = np.eye(3)
        if np.isfinite(sensed).any():
            sense[:, 3] = np.stack([self.values[n] for n in NORMAL], axis=1)
        keep = self._kept_rows(value)
        value, sense = value[keep], sense[keep]
        given = np.isfinite(value)
        if given.sum() < FEW_ROWS:
            self._note("warning", "few-readings", count=int(given.sum()))
        if np.abs(value[given]).max() > HUGE_MM:
            row = int(np.argmax(np.nanmax(np.abs(np.where(given, value, 0)), axis=1)))
            line = int(self.table.line[keep][row])
            self._note("warning", "huge-reading", line, limit=HUGE_MM)
        point, kind = np.nonzero(given)
        u = self.values.get("u", np.full(count, np.nan))[keep]
        if "u" not in self.values:
            self._note("info", "no-uncertainty")
        return self._finish(
            keep, derive=True, point=point, sense=sense[given], value=value[given], u=u[point], kind=kind
        )

    def positions(self) -> Readings:
        self._read(measured=False)
        if self.table.rows == 0:
            raise Refused("readings-no-positions", self.table.source)
        none = np.empty(0, dtype=int)
        everything = np.ones(self.table.rows, dtype=bool)
        for base in self._drivers():
            self._refuse_empty(base)
        return self._finish(
            everything, derive=False, point=none, sense=np.empty((0, 3)), value=np.empty(0), u=np.empty(0), kind=none
        )

    # -- names and answers ---------------------------------------------------------------------------------------
    def _note(self, severity: str, code: str, line: int = 0, said: str = "", **fields) -> None:
        """Add a remark.  fields : of its message, whose code is "remark-" and `said`, or else `code`."""
        self.remarks.append(Remark(severity, code, Message(f"remark-{said or code}", **fields), line))

    def _read(self, measured: bool) -> None:
        table = self.table
        mapping = check_mapping(self.mapping) if self.mapping else {}
        ignored = set(mapping.pop("ignore", ()))
        header = mapping.pop("header", {})
        theirs = {v: k for k, v in mapping.items() if isinstance(v, str)}
        for name in (*theirs, *ignored):
            if name not in table.names:
                raise Refused(
                    "mapping-column-missing",
                    f"{table.source}, line {table.names_line}",
                    column=short(name),
                    known=_some_names(table.names),
                )
        self._read_answers(header)
        for j, written in enumerate(table.names):
            if written in ignored:
                self._note("info", "ignored-column", table.names_line, column=short(written))
                continue
            self._read_column(j, theirs.get(written, written), measured)
        for key, value in mapping.items():
            if not isinstance(value, str):
                name = column_names.parse(key, joints=self.kinds)
                self._refuse_twice(name.base, f"mapping, {key}")
                values = name.convert(np.full(table.rows, float(value)))
                self._refuse_large(name, values, lambda _, key=key: f"mapping, {key}")
                self.values[name.base], self.units[name.base] = values, name.unit
        for joint, base in zip(self.joints, self.places):
            if base not in self.values:
                columns = [f"{j.column}_{j.unit}" for j in self.joints]
                where = f"{table.source}, line {table.names_line}"
                raise Refused("readings-position-missing", where, column=f"{base}_{joint.unit}", needed=columns)
            self._refuse_empty(base)
        if measured and table.rows == 0:
            raise Refused("readings-no-rows", table.source)
        self._check_decimals()
        self._positions_answer()
        self._check_directions()

    def _check_decimals(self) -> None:
        if len(self.commas) == 2:
            names = [short(self.table.names[self.commas[comma]]) for comma in (True, False)]
            self._note("warning", "decimal-signs", self.table.names_line, commas=names[0], points=names[1])

    def _read_answers(self, header: Mapping) -> None:
        table = self.table
        self.answers = read_answers(table.comments, header, table.names_line, table.source)
        self.records = read_records(table.comments, header, table.names_line, table.source)
        for key, code in NOT_IN_READINGS.items():
            if self._answer(key)[0] != ANSWERS[key][0]:
                why = Message(code)
                fields = {"question": key, "answer": self._answer(key)[0]}
                self._note("info", "convention-noted", self.answers[key][1], why=why, **fields)

    def _answer(self, key: str) -> tuple[str, ...]:
        return self.answers[key][0] if key in self.answers else (ANSWERS[key][0],)

    def _refuse_twice(self, base: str, where: str) -> None:
        if base in self.values or base in self.categories or (base == "run" and self.run is not None):
            raise Refused("readings-column-twice", where, column=short(base))

    def _read_column(self, j: int, written: str, measured: bool) -> None:
        table = self.table
        where = f"{table.source}, line {table.names_line}, column {j + 1}"
        if not written:
            if any(table.cells[j]):
                raise Refused("readings-column-without-name", where)
            return
        name = column_names.parse(written, where, self.kinds)
        base = name.base
        self._refuse_twice(base, f"{where} ({written})")
        self.column_of[base] = j
        if base == "run":
            self.run = np.array(table.cells[j], dtype=str)
            self._report_empty(base, [not c for c in table.cells[j]], "empty-run")
            return
        if base in PREDICTED_U or (not measured and base in (*ERROR, *NORMAL, "reading", "u")):
            self._note("info", "reading-ignored", table.names_line, column=short(written))
            return
        if name.kind == "unknown" and self._is_category(j, written):
            self.categories[base] = np.array(table.cells[j], dtype=str)
            return
        values = table.numbers(j)
        if table.comma(j) or table.cells.holds(j, "."):
            self.commas.setdefault(table.comma(j), j)
        with np.errstate(over="ignore"):
            values = name.convert(values)
        self._refuse_infinite(j, values, nan_is_empty=base in (*ERROR, "reading", "u"))
        self._refuse_large(name, values, lambda row: table.place(row, j))
        if table.rows and np.isnan(values).all() and base not in self.places:
            self._note("warning", "empty-column", table.names_line, column=short(written))
            return
        self.values[base], self.units[base] = values, name.unit
        if not name.known:
            fields = {"column": short(written), "driver": short(base)}
            if name.unit:
                self._note("info", "unknown-column", table.names_line, unit=name.unit, **fields)
            else:
                self._note("info", "unknown-column", table.names_line, "unknown-column-unit", **fields)

    def _is_category(self, j: int, written: str) -> bool:
        row = self.table.first_bad(j)
        if row is None:
            return False
        text = self.table.text(j)
        numbers = sum(1 for c in text if csv_table.is_number(c))
        if numbers > 0.5 * len(text):
            raise Refused(
                "readings-not-a-number", self.table.place(row, j), cell=short(self.table.cells[j][row]), count=numbers
            )
        self._note("info", "category", self.table.names_line, column=short(written))
        return True

    def _refuse_infinite(self, j: int, values: np.ndarray, nan_is_empty: bool) -> None:
        table = self.table
        bad = np.isinf(values)
        empty = np.flatnonzero(np.isnan(values))
        cells = table.cells[j] if empty.size else []
        written = [r for r in empty if cells[r]]
        if nan_is_empty and written:
            lines = _lines(table.line[written])
            fields = {"column": short(table.names[j]), "cell": short(table.cells[j][written[0]])}
            self._note("warning", "nan-reading", int(table.line[written[0]]), lines=lines, **fields)
        elif written:
            bad[written] = True
        if bad.any():
            row = int(np.argmax(bad))
            raise Refused("readings-not-finite", table.place(row, j), cell=short(table.cells[j][row]))

    def _refuse_large(self, name: column_names.Name, values: np.ndarray, place) -> None:
        limit = column_names.LARGEST_LENGTH if name.kind == "length" and name.known else column_names.LARGEST
        bad = np.abs(values) > limit  # false where a cell is empty
        if bad.any():
            row = int(np.argmax(bad))
            written = f"{values[row]:g}"
            raise Refused("number-too-large", place(row), value=written, column=name.base, limit=limit, unit=name.unit)

    def _refuse_empty(self, base: str) -> None:
        missing = np.isnan(self.values[base])
        if missing.any():
            row = int(np.argmax(missing))
            raise Refused("readings-cell-empty", self.table.place(row, self.column_of[base]))

    def _report_empty(self, base: str, missing, said: str) -> None:
        rows = np.flatnonzero(missing)
        if rows.size:
            lines, column = self.table.line[rows], short(self.table.names[self.column_of[base]])
            self._note("warning", "empty-cell", int(lines[0]), said, column=column, lines=_lines(lines))

    # -- conventions ---------------------------------------------------------------------------------------------
    def _positions_answer(self) -> None:
        word, *axes = self._answer("positions")
        if word == "programmed":
            return
        line = self.answers["positions"][1]
        if not axes:
            raise Refused("readings-positions-of-which", f"{self.table.source}, line {line}")
        for a in axes:
            self.values[a] = -self.values[a]
            if f"dir_{a}" in self.values:
                self.values[f"dir_{a}"] = -self.values[f"dir_{a}"]
        self._note("info", "positions-converted", line, axes=[a.upper() for a in axes])

    def _check_directions(self) -> None:
        for base in (*DIRECTION, *self.directions):
            if base in self.values:
                values = self.values[base]
                bad = np.isfinite(values) & ~np.isin(values, (-1.0, 0.0, 1.0))
                if bad.any():
                    row = int(np.argmax(bad))
                    j = self.column_of.get(base)
                    where = self.table.place(row, j) if j is not None else f"mapping, {base}"
                    raise Refused("readings-no-direction", where, value=float(values[row]))

    def _sign_of_readings(self, error, sensed) -> None:
        turned = []
        if self._answer("sign")[0] == "compensation":
            turned.append("sign")
        if self._answer("frame")[0] == "table":
            turned.append("frame")
        for key in turned:
            self._note("info", "sign-converted", self.answers[key][1], f"{key}-converted")
        if "sign" not in self.answers or "frame" not in self.answers:
            self._note("info", "sign-assumed")
        if len(turned) == 1:
            for values in (*error, sensed):
                np.negative(values, out=values)

    def _own_vectors(self) -> np.ndarray:
        """(P,) readings along nx, ny, nz, NaN where there is none; the vectors are checked and made unit vectors."""
        table = self.table
        present = [n for n in NORMAL if n in self.values]
        if "reading" not in self.values:
            if present:
                self._note("warning", "direction-without-reading", table.names_line)
            return np.full(table.rows, np.nan)
        if len(present) < 3:
            raise Refused("readings-without-vector", f"{table.source}, line {table.names_line}")
        reading = self.values["reading"].copy()
        n = np.stack([self.values[a] for a in NORMAL], axis=1)
        length = np.sqrt((n**2).sum(axis=1))
        bad = np.isfinite(reading) & ~(np.abs(length - 1) < 1e-2)
        if bad.any():
            row = int(np.argmax(bad))
            raise Refused(
                "readings-vector-not-unit",
                f"{table.source}, line {int(table.line[row])}, columns nx, ny, nz",
                length=float(length[row]),
            )
        off = np.isfinite(reading) & (np.abs(length - 1) > 1e-6)
        if off.any():
            line = int(table.line[np.argmax(off)])
            self._note("info", "direction-scaled", line, count=int(off.sum()))
        for i, a in enumerate(NORMAL):
            self.values[a] = n[:, i] / np.where(length > 0, length, 1.0)
        return reading

    # -- rows ----------------------------------------------------------------------------------------------------
    def _drivers(self) -> list[str]:
        return [b for b in self.values if b not in self.places and b not in NOT_DRIVERS]

    def _kept_rows(self, value: np.ndarray) -> np.ndarray:
        keep = np.isfinite(value).any(axis=1)
        if not keep.any():
            raise Refused("readings-none", self.table.source)
        if not keep.all():
            lines = self.table.line[~keep]
            self._note("warning", "no-reading", int(lines[0]), lines=_lines(lines))
        for base in self._drivers():
            missing = np.isnan(self.values[base])
            if not missing.any():
                continue
            if base in TOOL:
                self._refuse_empty(base)
            if missing.sum() > MAX_GAPS * len(missing):
                self._report_empty(base, missing, "empty-column-left-out")
                del self.values[base]
            else:
                self._report_empty(base, missing, "empty-rows-left-out")
                keep &= ~missing
        if not keep.any():
            raise Refused("readings-no-whole-row", self.table.source)
        u = self.values.get("u")
        if u is not None and np.any(u <= 0):
            row = int(np.argmax(u <= 0))
            raise Refused(
                "readings-uncertainty-zero",
                self.table.place(row, self.column_of["u"]) if "u" in self.column_of else "mapping, u",
            )
        if u is not None and np.any(u < column_names.SMALLEST_UNCERTAINTY):
            row = int(np.argmax(u < column_names.SMALLEST_UNCERTAINTY))
            where = self.table.place(row, self.column_of["u"]) if "u" in self.column_of else "mapping, u"
            limit = column_names.SMALLEST_UNCERTAINTY
            raise Refused("uncertainty-too-small", where, value=f"{u[row]:g}", limit=limit)
        return keep

    def _finish(self, keep, derive, point, sense, value, u, kind) -> Readings:
        rows = slice(None) if keep.all() else keep  # a view where every row is kept: tables have millions of rows
        columns = {b: v[rows] for b, v in self.values.items() if b in self.places or b not in NOT_DRIVERS}
        tool = [columns.pop(a, None) for a in TOOL]
        has_tool = any(a is not None for a in tool)
        categories = {k: v[rows] for k, v in self.categories.items()}
        run = None if self.run is None else self.run[rows]
        line = self.table.line[rows]
        tool = np.stack([np.zeros(len(line)) if a is None else a for a in tool], axis=1) if has_tool else None
        order, said = time_order(columns.get("t"), run)
        if order is not None:
            back = backwards(columns["t"])
            self._note("warning", "time-order", int(line[back[0] + 1]), said, count=len(back))
            columns = {k: v[order] for k, v in columns.items()}
            categories = {k: v[order] for k, v in categories.items()}
            run = None if run is None else run[order]
            tool, line = tool[order] if has_tool else None, line[order]
            place = np.empty_like(order)
            place[order] = np.arange(len(order))
            rows = np.argsort(place[point], kind="stable")
            point, sense, value, u, kind = place[point][rows], sense[rows], value[rows], u[rows], kind[rows]
        if derive:
            self._derive_directions(columns)
        return Readings(
            q=np.stack([j.from_shown(columns[a]) for j, a in zip(self.joints, self.places)], axis=1),
            point=point,
            sense=sense,
            value=value,
            u=u,
            kind=kind,
            columns=columns,
            units={b: self.units.get(b, "") for b in columns},
            categories=categories,
            run=run,
            tool_offset=tool,
            line=line,
            remarks=tuple(self.remarks),
            alignment=self._alignment(),
            records=self.records,
        )

    def _alignment(self) -> str:
        """Of the set-up, as the file states it, or ""."""
        word = self._answer("alignment")[0]
        return "" if word == "not_stated" else word.replace("_", " ")

    def _derive_directions(self, columns: dict) -> None:
        derived = []
        for a in self.places:
            if f"dir_{a}" in columns or f"dir_{a}" in self.values:
                continue
            direction = approach_directions(columns[a])
            if direction.any():
                columns[f"dir_{a}"] = direction
                self.units[f"dir_{a}"] = ""
                derived.append(f"dir_{a}")
        if derived:
            order = Message("order-of-time" if "t" in columns else "order-of-file")
            self._note("info", "direction-derived", columns=derived, order=order)


def _some_names(names) -> str:
    """Some of the names of a table, as they can stand in a message."""
    given = [n if len(n) <= 20 else n[:19] + "…" for n in names if n]
    return ", ".join(given[:6]) + (f" and {len(given) - 6} more" if len(given) > 6 else "")


def _lines(lines) -> Message:
    shown = [int(v) for v in lines[:5]]
    if len(lines) > 5:
        return Message("lines-and-more", shown=shown, more=len(lines) - 5)
    return Message("line-one" if len(lines) == 1 else "lines-few", shown=shown)
