# SPDX-License-Identifier: LGPL-2.1-or-later
"""The names of columns of readings: a base name with the unit as suffix, and how its numbers become internal ones.

`temp_column_C` is the driver `temp_column` in kelvin from 20 degC; `spindle_rpm` is `spindle`.  A known base name with
an unknown unit is refused.  A name that nobody knows stays a candidate driver; a unit that is plain at its end is
converted and taken off, so that `gap_um` and `gap_mm` are the same driver.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np

from sensworkbench.core.refusal import Refused
from sensworkbench.core.units import ANGLE, LENGTH

from .json_text import short

MASS = {"kg": 1.0, "g": 1e-3, "t": 1e3, "lb": 0.45359237}
TIME = {"s": 1.0, "ms": 1e-3, "min": 60.0, "h": 3600.0}
TEMPERATURE = {"C": (1.0, -20.0), "K": (1.0, -293.15), "F": (5 / 9, -32 * 5 / 9 - 20.0)}
TEMPERATURE |= {"degC": TEMPERATURE["C"], "°C": TEMPERATURE["C"], "degF": TEMPERATURE["F"], "°F": TEMPERATURE["F"]}
SPEED = {"mm_min": 1.0, "m_min": 1e3, "mm_s": 60.0, "m_s": 6e4, "um_s": 0.06, "in_min": 25.4, "in_s": 1524.0}
ROTATION = {"rpm": 1.0, "1_min": 1.0, "rps": 60.0, "1_s": 60.0, "Hz": 60.0, "rad_s": 30 / np.pi, "deg_s": 1 / 6}
NONE = {"": 1.0}
LARGEST = 1e15  # no column holds a number beyond this, in its internal unit
LARGEST_LENGTH = 1e7  # mm: ten kilometres
SMALLEST_UNCERTAINTY = 1e-12  # mm

# kind -> (unit suffixes, the internal unit)
KINDS = {
    "length": (LENGTH, "mm"),
    "angle": (ANGLE, "rad"),
    "time": (TIME, "s"),
    "temperature": (TEMPERATURE, "K"),
    "mass": (MASS, "kg"),
    "speed": (SPEED, "mm/min"),
    "rotation": (ROTATION, "rpm"),
    "turn": ({unit: size / ANGLE["deg"] for unit, size in ANGLE.items()}, "deg"),
    "none": (NONE, ""),
}
POSITION = ("x", "y", "z")
ERROR = ("ex", "ey", "ez")
PREDICTED_U = ("u_ex", "u_ey", "u_ez")  # of a prediction
NORMAL = ("nx", "ny", "nz")
DIRECTION = ("dir_x", "dir_y", "dir_z")
TOOL = ("tool_dx", "tool_dy", "tool_dz")
BASES = dict.fromkeys((*POSITION, *ERROR, *PREDICTED_U, *TOOL, "reading", "u"), "length")
BASES |= dict.fromkeys((*NORMAL, *DIRECTION, "run"), "none")
BASES |= {"t": "time", "feed": "speed", "spindle": "rotation"}
FAMILIES = {"temp_": "temperature", "load_": "mass"}
EXAMPLE = {
    "length": "mm or um",
    "time": "s or min",
    "temperature": "C, K or F",
    "mass": "kg",
    "speed": "mm_min or m_min",
}
EXAMPLE |= {"rotation": "rpm or 1_s", "turn": "deg"}
# at the end of an unknown name only suffixes that mean nothing but a unit count: not m, g, t, h, F, in, min, 1_s
PLAIN = {
    "length": ("mm", "um", "µm", "μm", "nm", "cm"),
    "angle": ("rad", "mrad", "urad", "µrad", "μrad", "nrad", "deg", "arcmin", "arcsec"),
    "time": ("s", "ms"),
    "temperature": ("C", "K", "degC", "°C", "degF", "°F"),
    "mass": ("kg", "lb"),
    "speed": ("mm_min", "m_min", "mm_s", "m_s", "um_s"),
    "rotation": ("rpm", "rps", "rad_s"),
}


_PLAIN_KINDS = {suffix: kind for kind, group in PLAIN.items() for suffix in group}  # none has two underscores


@dataclass(frozen=True)
class Name:
    """base : name without unit.  kind : quantity.  suffix : as written.  unit : internal one.  known : ours or not."""

    base: str
    kind: str
    suffix: str
    unit: str
    known: bool

    def convert(self, values: np.ndarray) -> np.ndarray:
        """Return values of the column in internal units."""
        if self.kind == "unknown":
            return values
        factor = KINDS[self.kind][0][self.suffix]
        scale, offset = factor if isinstance(factor, tuple) else (factor, 0.0)
        if scale == 1.0:
            return values + offset if offset else values
        return values * scale + offset


def _plain(text: str):
    """(base, kind, suffix) of an unknown name that ends in a unit that can be nothing else, the longest first."""
    parts = text.rsplit("_", 2)
    for suffix in ("_".join(parts[-2:]), parts[-1]) if len(parts) == 3 else parts[1:]:
        if suffix in _PLAIN_KINDS:
            base = text[: -len(suffix) - 1]
            return (base, _PLAIN_KINDS[suffix], suffix) if base else None
    return None


@cache
def bases_with(joints: tuple[tuple[str, bool], ...]) -> dict[str, str]:
    """base name -> kind, with the positions and directions of these joints: (column, whether it is an angle)."""
    more = {name: "turn" if angular else "length" for name, angular in joints}
    return BASES | more | {f"dir_{name}": "none" for name, _ in joints}


def parse(text: str, where: str = "", joints: tuple[tuple[str, bool], ...] = ()) -> Name:
    """What a column's name says; refuses a known base name whose unit is missing or unknown.

    joints : (column, whether it is an angle) of a machine's joints, beside x, y and z.
    """
    bases = bases_with(joints)
    for prefix, kind in FAMILIES.items():
        if text.startswith(prefix):
            base, _, suffix = text.rpartition("_")
            if base + "_" == prefix or base == prefix.rstrip("_") or suffix not in KINDS[kind][0]:
                raise _unit_refused(text, kind, where)
            return Name(base, kind, suffix, KINDS[kind][1], True)
    if text in bases and bases[text] == "none":
        return Name(text, "none", "", "", True)
    parts = text.split("_", 2)
    for base in ("_".join(parts[:2]), parts[0]) if len(parts) > 1 else parts:  # the longest first; none has three parts
        if base in bases:
            kind, suffix = bases[base], text[len(base) + 1 :]
            if kind == "none" and base == "run":
                break  # run_id and the like are names of their own
            if suffix in KINDS[kind][0]:
                return Name(base, kind, suffix, KINDS[kind][1], True)
            plain = _plain(text)
            places = (*POSITION, *(name for name, _ in joints))
            if plain and plain[0] != base and base in ("spindle", "feed", "t", *places):
                break  # spindle_temp_C, x_nut_C: another name that begins like a known one
            raise _unit_refused(text, kind, where)
    plain = _plain(text)
    if plain and plain[0] not in bases:
        base, kind, suffix = plain
        return Name(base, kind, suffix, KINDS[kind][1], False)
    return Name(text, "unknown", "", "", False)


def _unit_refused(text: str, kind: str, where: str) -> Refused:
    wanted = EXAMPLE.get(kind)
    if wanted is None:
        return Refused("column-takes-no-unit", where, column=short(text))
    return Refused("column-unit-unknown", where, column=short(text), wanted=wanted)
