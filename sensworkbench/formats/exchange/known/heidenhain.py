# SPDX-License-Identifier: LGPL-2.1-or-later
"""Heidenhain axis-error tables (*.COM), one per causing axis, in the columns that the technical manuals describe.

A column named after an axis holds the error of that axis when the causing axis is at AXISPOS (Z = F(Y): sag).
Values are errors, positive where the travel is too long, as the manuals define the linear axis error; BACKLASH holds
the own axis's value in the negative direction.  Made from manual pages (MANUALplus 620 p. 716-718, TNC 407 p. 151-156);
no file of Heidenhain's was at hand.
"""

from __future__ import annotations

import numpy as np

from sensworkbench.core.errors import AXES
from sensworkbench.messages import Message, Refused
from sensworkbench.studies.axis_tables import AxisTable

from ..base import AxisTables

STYLES = ("tnc640", "itnc530")


class Heidenhain(AxisTables):
    """`AXIS_X.COM` ... and config.cma that assigns them."""

    name, title, sign = "heidenhain", "Heidenhain .COM", "sign-heidenhain"
    limit = 256

    def shifts(self, source, output, reverses):
        return Message("table-direction-own") if reverses and source != output else None

    def files(self, tables, style: str = "tnc640"):
        return files(tables, style)


FORMAT = Heidenhain()


def files(tables: dict[tuple[str, str], AxisTable], style: str = "tnc640") -> dict[str, str]:
    """File name -> text of the tables, and of config.cma that assigns them."""
    if style not in STYLES:
        raise Refused("heidenhain-style", "Heidenhain", style=repr(style)[:60], known=list(STYLES))
    out, used = {}, []
    for source in AXES:
        group = {o: tables[s, o] for s, o in tables if s == source}
        if not group:
            continue
        name = f"AXIS_{source}.COM" if style == "tnc640" else f"AXIS-{source}.COM"
        out[name] = _tnc640(name, source, group) if style == "tnc640" else _itnc530(name, group)
        used.append((source, name.removesuffix(".COM")))
    if style == "tnc640" and used:
        out["config.cma"] = _cma(used)
    return out


def _position(group) -> np.ndarray:
    """The finest of the group's positions; the others are interpolated to it, within their own stated error."""
    return max((t.position for t in group.values()), key=len)


def _values(table: AxisTable, position, which: str) -> np.ndarray:
    return np.interp(position, table.position, getattr(table, which))


def _tnc640(name: str, source: str, group) -> str:
    position = _position(group)
    columns = [o for o in AXES if o in group]
    own = group.get(source)
    reverses = own is not None and own.reverses
    head = ["NR", "AXISPOS"] + (["BACKLASH"] if reverses else []) + columns
    rows = []
    for i, q in enumerate(position):
        cells = [str(i), f"{q:.4f}"]
        if reverses:
            cells.append(f"{_values(own, position, 'minus')[i]:.5f}")
        rows.append(cells + [f"{_values(group[o], position, 'plus')[i]:.5f}" for o in columns])
    lines = [f"BEGIN {name} MM", _row(head), *(_row(r) for r in rows), "[END]"]
    return "\n".join(lines) + "\n"


def _itnc530(name: str, group) -> str:
    position = _position(group)
    columns = [o for o in AXES if o in group]
    if any(group[o].reverses for o in columns):
        raise Refused("heidenhain-direction", name)
    step = position[1] - position[0]
    numbers = {o: AXES.index(o) + 1 for o in columns}
    lines = [f"BEGIN {name}  DATUM:{position[0]:+.4f} DISTANCE:{step:.4f}"]
    lines.append(_row(["NR", *(f"{numbers[o]}=F()" for o in columns)]))
    for i in range(len(position)):
        lines.append(_row([str(i), *(f"{_values(group[o], position, 'plus')[i]:+.4f}" for o in columns)]))
    return "\n".join([*lines, "[END]"]) + "\n"


def _cma(used) -> str:
    head = ["NR", "ACTIVE", *(axis for axis, _ in used)]
    lines = ["BEGIN config.cma", _row(head), _row(["0", "*", *(name for _, name in used)]), "[END]"]
    return "\n".join(lines) + "\n"


def _row(cells) -> str:
    return cells[0].ljust(5) + "".join(c.ljust(12) for c in cells[1:]).rstrip()
