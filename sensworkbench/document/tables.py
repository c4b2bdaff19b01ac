# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tolerance table of a machine, between the document's lists and the core's `Tolerance`s (mm and rad)."""

from __future__ import annotations

from dataclasses import replace

from ..core.distributions import Tolerance, with_defaults
from ..core.errors import COMPONENTS, canonical, find
from ..core.machine import Machine
from ..core.units import factor
from ..messages import Refused
from .base import put
from .tree import tolerances_of

COLUMNS = ("Symbols", "Lower", "Upper", "Units", "Distributions", "Sigmas")


def read_tolerances(machine, core: Machine | None = None) -> dict[str, Tolerance]:
    """symbol -> Tolerance as stored; empty without a table.  Refuses a damaged table.

    core : the machine, whose errors are meant; rows for axes X, Y, Z that it has not are left out.  Default: a machine
    of X, Y and Z.
    """
    own = COMPONENTS if core is None else {c.symbol: c for c in core.components}
    table = tolerances_of(machine)
    if table is None:
        return {}
    columns = [list(getattr(table, name)) for name in COLUMNS]
    if len({len(c) for c in columns}) > 1:
        raise Refused("tolerance-table-uneven", table.Label)
    found = {}
    for symbol, lower, upper, _, distribution, sigma in zip(*columns):
        key = canonical(symbol)
        if key not in own and key in COMPONENTS:
            continue
        key = find(own, symbol, table.Label).symbol
        try:
            found[key] = Tolerance(lower, upper, distribution, sigma if sigma > 0 else None)
        except Refused as error:
            raise error.at(f"{table.Label}, {key}") from None
    return found


def read_units(machine) -> dict[str, str]:
    """symbol -> unit in which the limits are shown."""
    return _units(tolerances_of(machine))


def _units(table) -> dict[str, str]:
    return dict(zip(table.Symbols, table.Units)) if table else {}


def write_tolerances(
    table, tolerances: dict[str, Tolerance], units: dict[str, str] | None = None, core: Machine | None = None
) -> None:
    """Store `tolerances` in a Tolerances object.

    Errors that are not given take the usual limits.  units : symbol -> unit in which an error is shown; default: the
    unit that the table has already, else um or urad.  core : as in `read_tolerances`.
    """
    own = COMPONENTS if core is None else {c.symbol: c for c in core.components}
    units = {**_units(table), **(units or {})}
    given = {find(own, s).symbol: t for s, t in tolerances.items()}
    full = with_defaults(given) if core is None else replace(core, tolerances=given).all_tolerances
    shown = [units.get(s) or own[s].unit for s in full]
    for symbol, unit in zip(full, shown):
        factor(unit, angular=own[symbol].angular, where=symbol)
    put(table, "Symbols", list(full))
    put(table, "Lower", [t.lower for t in full.values()])
    put(table, "Upper", [t.upper for t in full.values()])
    put(table, "Units", shown)
    put(table, "Distributions", [t.distribution for t in full.values()])
    put(table, "Sigmas", [t.sigma or 0.0 for t in full.values()])
