# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of docs/formats.md about exchange formats, made by asking every format."""

from __future__ import annotations

from sensworkbench.core.errors import COMPONENTS
from sensworkbench.messages import Message
from sensworkbench.studies.coverage import Item

from . import known

ASKED = {
    "EXX, EYY, EZZ": Item(COMPONENTS["EXX"], ("X",), output="X", declared=True),
    "straightness": Item(COMPONENTS["EYX"], ("X",), output="Y", declared=True),
    "angles": Item(COMPONENTS["EAX"], ("X",), output="X", declared=True),
    "squareness": Item(COMPONENTS["C0Y"], ("Y",), output="Z", declared=True),
    "reversal of an axis along itself": Item(COMPONENTS["EXX"], (), "X", "X"),
    "reversal across (EYX by dir_x)": Item(COMPONENTS["EYX"], (), "X", "Y"),
    "shift by another axis's position": Item(COMPONENTS["EXX"], ("Y",), output="X"),
    "any error by products of positions (x·z sag)": Item(COMPONENTS["EZX"], ("X", "Z"), output="Z"),
    "errors of rotary axes": Item(COMPONENTS["EXX"], ("C",), obstacle=Message("table-rotary", axis="C")),
}


def formats_table() -> str:
    """What every format is, and whether it is written and read."""
    rows = [("format", "what it is", "written", "read"), ("---",) * 4]
    for f in known.every():
        read = "errors" if f.reads_errors else "machine" if f.reads_machine else ""
        rows.append((f"`{f.name}`", f.title, "yes" if f.writes else "", read))
    return _table(rows)


def holds_table() -> str:
    """What every format of errors can hold."""
    formats = [f for f in known.every() if f.takes_positions]
    rows = [("can hold", *(f"`{f.name}`" for f in formats)), ("---",) * (len(formats) + 1)]
    rows += [(words, *("" if f.holds(item) else "yes" for f in formats)) for words, item in ASKED.items()]
    return _table(rows)


def _table(rows) -> str:
    return "\n".join(f"| {' | '.join(row)} |" for row in rows)
