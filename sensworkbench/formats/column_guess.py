# SPDX-License-Identifier: LGPL-2.1-or-later
"""Guess what the columns of a foreign table are, and propose a mapping.

The proposal is for a person to correct; nothing is imported by it.  `Pos X [mm]` becomes `x_mm`, `Temp Column (°C)`
`temp_column_C`, `Error Y µm` `ey_um`; a column that is not recognised remains a driver with its own name.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from sensworkbench.core.refusal import Refused

from . import column_names
from .column_names import BASES, FAMILIES, KINDS
from .json_text import short

DRIVER, IGNORE = "driver", "ignore"
# what a column may be, in the order in which a list shows them; families take a name
CHOICES = (*BASES, *FAMILIES, DRIVER, IGNORE)
_UNIT = re.compile(r"[\[(]([^\])]*)[\])]\s*$")
_PLAIN = {
    "°c": "C", "degc": "C", "c": "C", "k": "K", "°f": "F", "f": "F", "µm": "um", "μm": "um", "um": "um", "mm": "mm",
    "nm": "nm", "m": "m", "in": "in", "s": "s", "sec": "s", "ms": "ms", "min": "min", "h": "h", "kg": "kg", "g": "g",
    "rpm": "rpm", "1/min": "rpm", "mm/min": "mm_min", "m/min": "m_min", "mm/s": "mm_s", "": "",
}  # fmt: skip
_AXIS = re.compile(r"(?:^|[\s_.-])([xyz])(?:$|[\s_.-])")
_WORDS = (  # the first that fits, in words of the name in lower case; {a} is the axis
    ("t", r"time|zeit|uhrzeit|시간|elapsed"),
    ("temp_", r"temp"),
    ("load_", r"load|mass|weight|last|gewicht"),
    ("feed", r"feed|vorschub"),
    ("spindle", r"spindle|spindel|rpm|drehzahl"),
    ("u", r"uncert|unsicher|sigma"),
    ("run", r"^(run|lauf|cycle|series)(\s*(no|nr|number)?\.?)?$"),
    ("tool_d{a}", r"tool|werkzeug"),
    ("dir_{a}", r"dir|approach|richtung"),
    ("n{a}", r"normal|vector|vektor"),
    ("e{a}", r"err|dev|abweich|fehler|diff|resid|^d[xyz]$|delta"),
    ("{a}", r"pos|axis|achse|nominal|target|soll|programmed|^[xyz]$|coord"),
    ("reading", r"reading|displacement|messwert|measured"),
)


@dataclass(frozen=True)
class Guess:
    """kind : one of CHOICES.  name : what follows a prefix ("column" of temp_column).  unit : suffix, or ""."""

    kind: str
    name: str = ""
    unit: str = ""

    @property
    def column(self) -> str:
        """The column's name in our grammar; "" for a driver that keeps its own name and for what is ignored."""
        if self.kind in (DRIVER, IGNORE):
            return ""
        base = self.kind + self.name if self.kind in FAMILIES else self.kind
        return f"{base}_{self.unit}" if self.unit else base


def units_of(kind: str) -> tuple[str, ...]:
    """Units that a kind of column may have, the usual one first; () where it has none."""
    quantity = FAMILIES.get(kind) or BASES.get(kind, "none")
    usual = "um" if kind in ("ex", "ey", "ez", "reading", "u") else ""
    names = [n for n in KINDS[quantity][0] if n and not n.startswith(("deg", "°"))]
    names = [n for n in names if n.isascii()]
    return tuple(sorted(names, key=lambda n: n != usual)) if usual else tuple(names)


def slug(text: str) -> str:
    """A name for a family's column from the words of a header."""
    found = re.sub(r"[^0-9a-zA-Z\u00c0-\uffff]+", "_", text.strip().lower()).strip("_")
    return found or "1"


def guess(written: str) -> Guess:
    """What the column named `written` probably is; a name of our own grammar is taken at its word."""
    try:
        own = column_names.parse(written)
    except Refused:
        own = None
    if own is not None and own.known:
        family = next((f for f in FAMILIES if own.base.startswith(f)), "")
        return Guess(family, own.base[len(family) :], own.suffix) if family else Guess(own.base, "", own.suffix)
    match = _UNIT.search(written)
    words = written[: match.start()] if match else written
    unit = _PLAIN.get(match.group(1).strip().lower(), "") if match else ""
    if not match:
        parts = words.rsplit(None, 1)
        if len(parts) == 2 and _PLAIN.get(parts[1].lower()):
            words, unit = parts[0], _PLAIN[parts[1].lower()]
    low = words.strip().lower()
    axis = _AXIS.search(low) or re.match(r"^d?([xyz])$", low)
    for kind, pattern in _WORDS:
        if not re.search(pattern, low) or ("{a}" in kind and not axis):
            continue
        kind = kind.format(a=axis.group(1) if axis else "")
        name = slug(re.sub(r"temperature|temperatur|temp|load|last", " ", low)) if kind in FAMILIES else ""
        return Guess(kind, name, unit if unit in units_of(kind) else (units_of(kind) or ("",))[0])
    return Guess(DRIVER)


def guesses(names: Sequence[str]) -> list[Guess]:
    """A guess for each column; where two are taken for the same, the later stays a driver."""
    taken: set[str] = set()
    found = []
    for written in names:
        one = guess(written)
        base = one.kind + one.name
        if one.kind not in (DRIVER, IGNORE) and base in taken:
            one = Guess(DRIVER)
        taken.add(base)
        found.append(one)
    return found


def mapping(names: Sequence[str], found: Sequence[Guess], constants: Mapping[str, float], answers: Mapping) -> dict:
    """The mapping (see `readings_conventions.load_mapping`) for columns `names` taken as `found`.

    constants : our name with unit -> number, for what the table lacks.  answers : question -> answer.
    """
    table: dict = dict(constants)
    for written, one in zip(names, found):
        if one.column and one.column != written:
            if one.column in table:
                raise Refused("columns-taken-twice", written, column=short(one.column))
            table[one.column] = written
    ignored = [w for w, one in zip(names, found) if one.kind == IGNORE and w]
    if ignored:
        table["ignore"] = ignored
    if answers:
        table["header"] = dict(answers)
    return table


def from_mapping(names: Sequence[str], table: Mapping) -> tuple[list[Guess], dict[str, float], dict[str, str]]:
    """(what each column is taken as, constants, answers) from which `mapping` makes `table` again."""
    ignored, answers = set(table.get("ignore", ())), dict(table.get("header", {}))
    constants = {k: float(v) for k, v in table.items() if isinstance(v, (int, float))}
    ours = {v: k for k, v in table.items() if isinstance(v, str)}
    found = []
    for written in names:
        one = guess(ours.get(written, written))
        if written in ignored:
            one = Guess(IGNORE)
        elif written not in ours and one.column != written:
            one = Guess(DRIVER)
        found.append(one)
    return found, constants, answers
