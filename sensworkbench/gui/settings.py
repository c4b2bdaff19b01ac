# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user's preferences (Edit > Preferences > Sens): one table of names and defaults, for the page and the code."""

from __future__ import annotations

import FreeCAD as App

PATH = "User parameter:BaseApp/Preferences/Mod/SensWorkbench"

# name: (default, meaning)
DEFAULTS = {
    "ColourMap": "viridis",
    "ColourBy": "Share",
    "AutomaticRange": True,
    "RangeLower": 0.0,
    "RangeUpper": 1.0,
    "LegendCorner": "Upper left",
    "AngleUnit": "urad",
    "Aggregate": "quadrature",
    "Order": 8,
    "Grid": 5,
    "Live": True,
}


def _group():
    return App.ParamGet(PATH)


def get(name: str):
    """The preference, or its default."""
    default, group = DEFAULTS[name], _group()
    if isinstance(default, bool):
        return group.GetBool(name, default)
    if isinstance(default, int):
        return group.GetInt(name, default)
    if isinstance(default, float):
        return group.GetFloat(name, default)
    return group.GetString(name, default)


def put(name: str, value) -> None:
    """Store a preference; its type is that of the default."""
    default, group = DEFAULTS[name], _group()
    if isinstance(default, bool):
        group.SetBool(name, bool(value))
    elif isinstance(default, int):
        group.SetInt(name, int(value))
    elif isinstance(default, float):
        group.SetFloat(name, float(value))
    else:
        group.SetString(name, str(value))


def give(machine) -> None:
    """Give a new machine the preferred positions."""
    machine.Aggregate, machine.Order, machine.Grid = (get(name) for name in ("Aggregate", "Order", "Grid"))


def length_unit() -> tuple[str, float]:
    """(unit, mm in it) in which FreeCAD's preferences want lengths: mm, or in where they are not metric."""
    unit = App.Units.Quantity("100 mm").getUserPreferred()[2]
    return ("in", 25.4) if unit in ("in", '"', "'", "ft", "thou", "mil") or '"' in unit or "'" in unit else ("mm", 1.0)
