# SPDX-License-Identifier: LGPL-2.1-or-later
"""A path as a table of points, and the table of conditions along a path.

The columns of a path are those of positions (docs/formats.md) with, where they are known, `feature` (a name), `kind`,
`datum`, `limit_um` of the feature, and the outward normal `nx, ny, nz` of the surface.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from sensworkbench.closedloop.readings import Readings
from sensworkbench.core.driver import TIME
from sensworkbench.core.refusal import Refused
from sensworkbench.core.units import mm
from sensworkbench.studies.part import FeatureRequest
from sensworkbench.studies.part_path import BLOCK, Conditions

from . import column_names, csv_table, readings_csv
from .column_names import NORMAL
from .csv_table import Table
from .json_text import short

OWN = ("feature", "kind", "datum", "limit_um", *NORMAL)
NEARLY_UNIT = 1e-2


@dataclass(frozen=True)
class PathPoints:
    """positions : without readings.  normal : (P, 3) outward unit vectors, NaN where not known, or None.  labels :
    feature -> rows.  features : what the table says of them."""

    positions: Readings
    normal: np.ndarray | None
    labels: Mapping[str, np.ndarray]
    features: tuple[FeatureRequest, ...]


def load(path, joints) -> PathPoints:
    """The points of a table; joints : of the machine."""
    table = csv_table.read(path)
    at = {name: j for j, name in enumerate(table.names) if name in OWN}
    for name in at:
        if table.names.count(name) > 1:
            raise Refused("readings-column-twice", f"{table.source}, line {table.names_line}", column=name)
    rest = [j for j in range(len(table.names)) if j not in at.values()]
    plain = replace(table, names=tuple(table.names[j] for j in rest), cells=table.cells.only(rest))
    positions = readings_csv.positions_of(plain, None, joints)
    order = np.searchsorted(table.line, positions.line)  # rows may have been put in the order of time
    normal = _normals(table, at)
    labels, features = _features(table, at)
    place = np.empty(table.rows, dtype=int)
    place[order] = np.arange(table.rows)
    return PathPoints(
        positions,
        None if normal is None else normal[order],
        {name: np.sort(place[rows]) for name, rows in labels.items()},
        features,
    )


def _normals(table: Table, at) -> np.ndarray | None:
    present = [n for n in NORMAL if n in at]
    if not present:
        return None
    if len(present) < 3:
        raise Refused("readings-without-vector", f"{table.source}, line {table.names_line}")
    normal = np.stack([table.numbers(at[n]) for n in NORMAL], axis=1)
    length = np.sqrt((np.clip(normal, -10, 10) ** 2).sum(axis=1))
    bad = ~np.isnan(length) & ~(np.abs(length - 1) < NEARLY_UNIT)
    if bad.any():
        row = int(np.argmax(bad))
        where = f"{table.source}, line {int(table.line[row])}, columns nx, ny, nz"
        raise Refused("readings-vector-not-unit", where, length=float(length[row]))
    return normal / length[:, None]


def _features(table: Table, at) -> tuple[dict[str, np.ndarray], tuple[FeatureRequest, ...]]:
    if "feature" not in at:
        return {}, ()
    names = np.array(table.cells[at["feature"]], dtype=str)
    rows_of = {str(n): np.flatnonzero(names == n) for n in dict.fromkeys(names.tolist()) if n}
    limits = table.numbers(at["limit_um"]) if "limit_um" in at else np.full(table.rows, np.nan)
    texts = {key: np.array(table.cells[at[key]], dtype=str) for key in ("kind", "datum") if key in at}
    found = []
    for name, rows in rows_of.items():
        said = {key: _one(table, rows, values, key) for key, values in texts.items()}
        limit = limits[rows][np.isfinite(limits[rows])]
        if len(limit) and (np.ptp(limit) > 0 or not 0 < limit[0] < 1e9):
            raise Refused("feature-limit", f"feature {name!r}", limit=float(limit[0]))
        found.append(FeatureRequest(name, limit=float(mm(limit[0])) if len(limit) else None, **said))
    return rows_of, tuple(found)


def _one(table: Table, rows, values, key: str) -> str | None:
    """What the rows of a feature say of it: one text, or nothing."""
    said = [v for v in dict.fromkeys(values[rows].tolist()) if v]
    if len(said) > 1:
        row = next(r for r in rows if values[r] == said[1])
        raise Refused("feature-said-twice", f"{table.source}, line {int(table.line[row])}", column=key, values=said[:3])
    return said[0] if said else None


def load_conditions(path, joints) -> Conditions:
    """The conditions in a table: a column `t_s` (or `block`: lines of the program), and condition columns."""
    table = csv_table.read(path)
    where = f"{table.source}, line {table.names_line}"
    kinds = tuple((j.column, j.kind.angular) for j in joints)
    columns, by, at = {}, None, None
    if table.rows == 0:
        raise Refused("readings-no-rows", table.source)
    for j, written in enumerate(table.names):
        name = column_names.parse(written, f"{where}, column {j + 1}", kinds)
        values = name.convert(table.numbers(j))
        if not np.isfinite(values).all():
            raise Refused("readings-cell-empty", table.place(int(np.argmin(np.isfinite(values))), j))
        if name.base in (TIME, BLOCK):
            if by is not None:
                raise Refused("conditions-two-orders", where)
            by, at = name.base, values
        elif name.base in columns:
            raise Refused("readings-column-twice", where, column=short(name.base))
        else:
            columns[name.base] = values
    if by is None:
        raise Refused("conditions-without-order", where)
    if (np.diff(at) <= 0).any():
        raise Refused(
            "conditions-not-in-order", f"{table.source}, line {int(table.line[np.argmax(np.diff(at) <= 0) + 1])}"
        )
    if not columns:
        raise Refused("conditions-without-columns", where)
    return Conditions(at, by, columns)


def held(text: str, joints) -> tuple[str, float]:
    """(name, value in internal units) of `temp_column_C=24`."""
    written, _, number = text.partition("=")
    where = f"--hold {text[:60]}"
    name = column_names.parse(written.strip(), where, tuple((j.column, j.kind.angular) for j in joints))
    if not csv_table.is_number(number.strip()) or not np.isfinite(float(number)):
        raise Refused("cell-not-a-number", where, cell=short(number))
    return name.base, float(name.convert(np.array([float(number)]))[0])
