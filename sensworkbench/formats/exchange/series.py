# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fitted error functions of a machine as Legendre series in mm and rad, and back into the file's um and urad.

`coefficients[k]` multiplies P_k of the axis position mapped from `domain` to [-1, 1].  Declared functions have
coefficient 0 at P_0; tables of other systems may carry a constant, which matters for angles.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from sensworkbench.core.drivers import Effect, to_domain
from sensworkbench.core.errors import DECLARED_SYMBOLS, SQUARENESS, SQUARENESS_SYMBOLS, component
from sensworkbench.core.machine import Machine
from sensworkbench.core.units import factor


@dataclass(frozen=True)
class Series:
    """domain : (low, high) mm.  coefficients : (n + 1,) of P_0 .. P_n, mm or rad."""

    domain: tuple[float, float]
    coefficients: tuple[float, ...]

    def __call__(self, q) -> np.ndarray:
        return np.polynomial.legendre.legval(to_domain(q, self.domain), np.asarray(self.coefficients, dtype=float))

    @property
    def empty(self) -> bool:
        return not any(self.coefficients)

    def plus(self, constant: float) -> Series:
        return replace(self, coefficients=(self.coefficients[0] + constant, *self.coefficients[1:]))


def _number(entry, symbol: str) -> float:
    """A fitted constant in mm or rad: a number in um or urad, or {"value", "unit"}."""
    c = component(symbol)
    value, unit = (entry["value"], entry.get("unit", c.unit)) if isinstance(entry, Mapping) else (entry, c.unit)
    return float(value) * factor(unit, angular=c.angular)


def series(machine: Machine, symbol: str) -> Series:
    """The fitted function of an axis error (a zero series where nothing is fitted)."""
    entry = (machine.fitted or {}).get(symbol)
    body = component(symbol).body
    domain = machine.axes[body].travel
    if entry is None:
        return Series(domain, (0.0,))
    if isinstance(entry, Mapping) and "coefficients" in entry:
        scale = factor(entry["unit"], angular=component(symbol).angular)
        coefficients = tuple(float(v) * scale for v in entry["coefficients"]) or (0.0,)
        return Series(tuple(float(v) for v in entry["domain"]), coefficients)
    return Series(domain, (_number(entry, symbol),))


def squareness(machine: Machine, symbol: str) -> float:
    """The fitted squareness error, rad."""
    entry = (machine.fitted or {}).get(symbol)
    return 0.0 if entry is None else _number(entry, symbol)


def entry(symbol: str, value) -> dict:
    """A Series, or a number in rad for squareness, as it stands under "fitted"."""
    c = component(symbol)
    scale = 1 / factor(c.unit, angular=c.angular)
    if c.kind == SQUARENESS:
        return {"value": value * scale, "unit": c.unit}
    coefficients = [v * scale for v in value.coefficients]
    return {"basis": "legendre", "domain": list(value.domain), "coefficients": coefficients, "unit": c.unit}


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
    fitted = dict(machine.fitted or {})
    fitted.pop("covariance", None)
    for symbol, value in changes.items():
        fitted.pop(symbol, None)
        if value is not None:
            fitted[symbol] = entry(symbol, value)
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
    parameters = dict(effect.parameters)
    given = parameters["coefficient"]
    value = np.multiply(sign, given["value"] if isinstance(given, Mapping) else given).tolist()
    parameters["coefficient"] = {**given, "value": value} if isinstance(given, Mapping) else value
    return replace(
        effect, name=f"{effect.name} (carried)", component=CARRIED_AS[effect.component], parameters=parameters
    )
