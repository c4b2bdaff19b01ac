# SPDX-License-Identifier: LGPL-2.1-or-later
"""The driver of an effect: a column of the readings, or a product of columns.

Driver values are mm, seconds, kelvin from 20 degC, kg, mm/min, revolutions per minute, directions -1/0/+1, degrees of a
rotary joint, and others as written.  A driver is a value: two drivers of the same columns are equal, in any order.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np

from .refusal import Refused

TIME = "t"
POSITIONS = ("x", "y", "z")
DIRECTIONS = ("dir_x", "dir_y", "dir_z")
MOST_FACTORS = 6  # of a product; the search goes up to three

UNITS = {"x": "mm", "y": "mm", "z": "mm", TIME: "s", "feed": "mm/min", "spindle": "rpm"} | dict.fromkeys(DIRECTIONS, "")
FAMILIES = {"temp_": "K", "load_": "kg"}


def column_unit(name: str, units: Mapping[str, str] | None = None) -> str | None:
    """Return the internal unit of a driver column: "" if it has none, None if its name does not determine it.

    units : column -> unit where that is known from elsewhere (readings, the joints of a machine); takes precedence.
    """
    if units and units.get(name):
        return "K" if units[name] == "C" and name.startswith("temp_") else units[name]
    for prefix, unit in FAMILIES.items():
        if name.startswith(prefix):
            return unit
    return UNITS.get(name)


def column_kind(name: str) -> str:
    """What a column holds: "place", "dir", "temp", "load", "feed", "spindle", "t", or its own name."""
    if name in POSITIONS:
        return "place"
    if name in DIRECTIONS:
        return "dir"
    return next((k for k in ("temp", "load", "feed", "spindle") if name.startswith(k)), name)


@dataclass(frozen=True, order=True)
class Driver:
    """A product of columns.  columns : their names, sorted; a name that occurs twice is a square.

    Refuses no columns, more than `MOST_FACTORS`, and names that are empty, contain "*" or begin or end with a blank.
    """

    columns: tuple[str, ...]

    def __post_init__(self):
        columns = tuple(sorted(self.columns))
        for name in columns:
            if not isinstance(name, str) or not name or name != name.strip() or "*" in name:
                raise Refused("driver-column-name", name=repr(name))
        if not 1 <= len(columns) <= MOST_FACTORS:
            raise Refused("driver-factors", count=len(columns), most=MOST_FACTORS)
        object.__setattr__(self, "columns", columns)

    @classmethod
    def parse(cls, text: str, where: str = "") -> Driver:
        """The driver in `text`, column names joined by "*"."""
        try:
            return cls(tuple(text.split("*")))
        except Refused as refused:
            raise refused.at(where) if where else refused from None

    @classmethod
    def parse_in_order(cls, text: str) -> tuple[Driver, list[int]]:
        """(the driver in `text`, the place in the text of each of its sorted columns)."""
        names = text.split("*")
        return cls.parse(text), sorted(range(len(names)), key=names.__getitem__)

    @classmethod
    def of(cls, columns: Driver | str | Iterable[str]) -> Driver:
        """A driver of itself, of its text, or of column names."""
        if isinstance(columns, Driver):
            return columns
        return cls.parse(columns) if isinstance(columns, str) else cls(tuple(columns))

    def __str__(self) -> str:
        return "*".join(self.columns)

    def __contains__(self, name: str) -> bool:
        return name in self.columns

    @property
    def names(self) -> tuple[str, ...]:
        """The columns, each once."""
        return tuple(dict.fromkeys(self.columns))

    @property
    def factors(self) -> int:
        """Number of factors of the product."""
        return len(self.columns)

    @property
    def repeats(self) -> bool:
        """Whether a column occurs in it more than once."""
        return len(self.names) < self.factors

    @property
    def kinds(self) -> frozenset[str]:
        """What its columns hold (see `column_kind`)."""
        return frozenset(column_kind(n) for n in self.columns)

    @property
    def axes(self) -> frozenset[str]:
        """The machine axes named in it: x, dir_x and temp_scale_x name X."""
        ends = (n.rsplit("_", 1)[-1] for n in self.columns)
        return frozenset(e.upper() for e in ends if e in POSITIONS)

    def words(self, sign: str = "×") -> str:
        """Its columns for a reader: `temp_column × y`."""
        return f" {sign} ".join(self.columns)

    def values(self, columns: Mapping[str, np.ndarray], where: str = "") -> np.ndarray:
        """(P,) product of its columns; refuses where one is not in `columns`."""
        value = None
        for name in self.columns:
            if name not in columns:
                raise Refused("driver-column-missing", where, column=name, driver=str(self))
            value = columns[name] if value is None else value * columns[name]
        return np.asarray(value, dtype=float)

    def unit(self, units: Mapping[str, str] | None = None) -> str:
        """Unit of the product, such as `K*mm` or `mm^2`; "" where no column has one (unknown ones count as none)."""
        parts: dict[str, int] = {}
        for name in self.columns:
            unit = column_unit(name, units)
            if unit:
                parts[unit] = parts.get(unit, 0) + 1
        return "*".join(u if n == 1 else f"{u}^{n}" for u, n in parts.items())

    def known(self, units: Mapping[str, str] | None = None) -> bool:
        """Whether the units of all its columns are known."""
        return all(column_unit(n, units) is not None for n in self.columns)
