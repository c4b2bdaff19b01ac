# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fitted errors of a machine as the tables of other systems need them: a series for every axis error.

Declared functions have coefficient 0 at P_0; tables of other systems may carry a constant, which matters for angles.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from ..core.effects import Effect
from ..core.errors import SQUARENESS
from ..core.fitted import Constant, FittedModel, Series
from ..core.machine import Machine
from ..messages import Refused


def series(machine: Machine, symbol: str) -> Series:
    """The fitted function of an axis error (a zero series where nothing is fitted)."""
    fitted = machine.fitted or FittedModel()
    if symbol in fitted.series:
        return fitted.series[symbol]
    constant = fitted.constants.get(symbol)
    joint = machine.joint(machine.component(symbol).body)
    domain = tuple(joint.to_shown(v) for v in joint.span)
    return Series(domain, (0.0 if constant is None else constant.value,))


def line_error(machine: Machine, symbol: str) -> float:
    """The fitted error of an axis line (squareness, position, orientation), rad or mm."""
    constant = (machine.fitted or FittedModel()).constants.get(symbol)
    return 0.0 if constant is None else constant.value


def present(machine: Machine) -> tuple[str, ...]:
    """The declared errors that have a fitted value other than zero."""
    return tuple(
        s
        for s in machine.declared_symbols
        if (line_error(machine, s) if machine.component(s).line else not series(machine, s).empty)
    )


def with_fitted(machine: Machine, changes: Mapping[str, Series | float | None], effects=None) -> Machine:
    """The machine with some fitted errors replaced (None: removed) and, if given, other effects.

    The covariance belongs to the old values and is left out.
    """
    fitted = (machine.fitted or FittedModel()).with_errors(
        {s: Constant(v) if isinstance(v, float) else v for s, v in changes.items()}
    )
    return replace(machine, fitted=fitted, effects=machine.effects if effects is None else tuple(effects))


def carried_as(machine: Machine, symbol: str) -> str:
    """The rotation that a carried squareness is beside the tilt of direction: `ECY` of `C0Y`."""
    c = machine.component(symbol)
    return f"E{c.symbol[0]}{c.body}"


def squareness_symbols(machine: Machine) -> tuple[str, ...]:
    """The squareness errors of a machine."""
    return tuple(s for s in machine.line_symbols if machine.component(s).kind == SQUARENESS)


def as_direction(machine: Machine) -> Machine:
    """The same machine with squareness as a tilt of direction only (ISO 230-1).

    A carried squareness s of axis k also turns what the axis carries: that is a constant rotation of body k by s on
    the tool side and by -s on the workpiece side.  Nothing is lost.  Refuses fitted errors of rotary axis lines that
    are carried: they turn with the axis, and no constant says the same.
    """
    if machine.squareness == "direction":
        return machine
    lines = squareness_symbols(machine)
    for symbol in machine.line_symbols:
        driven = line_error(machine, symbol) or any(e.component == symbol for e in machine.effects)
        if symbol not in lines and driven:
            raise Refused("carried-rotary-line", machine.name, symbol=symbol)
    changes = {}
    for symbol in lines:
        value = line_error(machine, symbol)
        if value:
            rotation = carried_as(machine, symbol)
            changes[rotation] = series(machine, rotation).plus(machine.side(machine.component(symbol).body) * value)
    effects = []
    for effect in machine.effects:
        effects.append(effect)
        if effect.component in lines:
            side = machine.side(machine.component(effect.component).body)
            effects.append(_turned(effect, side, carried_as(machine, effect.component)))
    return replace(with_fitted(machine, changes, effects), squareness="direction")


def _turned(effect: Effect, sign: int, component: str) -> Effect:
    reach = None if effect.reach is None else tuple(sorted(sign * v for v in effect.reach))
    return replace(
        effect,
        name=f"{effect.name} (carried)",
        component=component,
        coefficients=tuple(sign * v for v in effect.coefficients),
        reach=reach,
    )
