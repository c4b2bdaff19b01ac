# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fitted errors of a machine as the tables of other systems need them: a series for every axis error.

Declared functions have coefficient 0 at P_0; tables of other systems may carry a constant, which matters for angles.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from sensworkbench.core.effects import Effect
from sensworkbench.core.errors import DECLARED_SYMBOLS, SQUARENESS_SYMBOLS, component
from sensworkbench.core.fitted import Constant, FittedModel, Series
from sensworkbench.core.machine import Machine

__all__ = ["CARRIED_AS", "Series", "as_direction", "present", "series", "squareness", "with_fitted"]


def series(machine: Machine, symbol: str) -> Series:
    """The fitted function of an axis error (a zero series where nothing is fitted)."""
    fitted = machine.fitted or FittedModel()
    if symbol in fitted.series:
        return fitted.series[symbol]
    constant = fitted.constants.get(symbol)
    return Series(machine.axes[component(symbol).body].travel, (0.0 if constant is None else constant.value,))


def squareness(machine: Machine, symbol: str) -> float:
    """The fitted squareness error, rad."""
    constant = (machine.fitted or FittedModel()).constants.get(symbol)
    return 0.0 if constant is None else constant.value


def present(machine: Machine) -> tuple[str, ...]:
    """The declared errors that have a fitted value other than zero."""
    return tuple(
        s
        for s in DECLARED_SYMBOLS
        if (squareness(machine, s) if s in SQUARENESS_SYMBOLS else not series(machine, s).empty)
    )


def with_fitted(machine: Machine, changes: Mapping[str, Series | float | None], effects=None) -> Machine:
    """The machine with some fitted errors replaced (None: removed) and, if given, other effects.

    The covariance belongs to the old values and is left out.
    """
    fitted = (machine.fitted or FittedModel()).with_errors(
        {s: Constant(v) if isinstance(v, float) else v for s, v in changes.items()}
    )
    return replace(machine, fitted=fitted, effects=machine.effects if effects is None else tuple(effects))


CARRIED_AS = {"C0Y": "ECY", "A0Z": "EAZ", "B0Z": "EBZ"}


def as_direction(machine: Machine) -> Machine:
    """The same machine with squareness as a tilt of direction only (ISO 230-1).

    A carried squareness s of axis k also turns what the axis carries: that is a constant rotation of body k by s on
    the tool side and by -s on the workpiece side.  Nothing is lost.
    """
    if machine.squareness == "direction":
        return machine
    changes = {}
    for symbol, rotation in CARRIED_AS.items():
        value = squareness(machine, symbol)
        if value:
            changes[rotation] = series(machine, rotation).plus(machine.side(symbol[2]) * value)
    effects = []
    for effect in machine.effects:
        effects.append(effect)
        if effect.component in CARRIED_AS:
            effects.append(_turned(effect, machine.side(effect.component[2])))
    return replace(with_fitted(machine, changes, effects), squareness="direction")


def _turned(effect: Effect, sign: int) -> Effect:
    reach = None if effect.reach is None else tuple(sorted(sign * v for v in effect.reach))
    return replace(
        effect,
        name=f"{effect.name} (carried)",
        component=CARRIED_AS[effect.component],
        coefficients=tuple(sign * v for v in effect.coefficients),
        reach=reach,
    )
