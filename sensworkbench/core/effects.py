# SPDX-License-Identifier: LGPL-2.1-or-later
"""An effect: a component of a machine with a driver and a shape that the declared model lacks.

Everything is in mm, rad and the driver's internal unit; units and spellings of files are read and written by
`formats.effects_json` alone.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from .driver import Driver
from .refusal import Refused
from .shapes import Shape
from .units import exactly_shown

LARGEST = 1e15  # of a coefficient, in mm or rad per unit of the driver


@dataclass(frozen=True)
class Effect:
    """One component with a driver and a shape.

    component : symbol.  driver : a `Driver`, or its text.  coefficients : (m,) mm or rad per unit of the driver (to the
    power `shape.unit_power`); empty where they are not known.  u : (m,) their standard uncertainties, or
    None; each is None where it is not known.
    shape_u : parameter -> standard uncertainty.  extent : (lowest, highest) value of the driver, or None.
    reach : (lowest, highest) value of the component, mm or rad, where that is what is known, or None.
    driver_unit : internal unit of the driver (default: what the names of its columns tell).

    Refuses a wrong number of coefficients, and numbers that are not finite or absurdly large.
    """

    name: str
    component: str
    driver: Driver
    shape: Shape
    coefficients: tuple[float, ...] = ()
    u: tuple[float | None, ...] | None = None
    shape_u: Mapping[str, float | None] = field(default_factory=dict)
    extent: tuple[float, float] | None = None
    reach: tuple[float, float] | None = None
    enabled: bool = True
    driver_unit: str | None = None

    def __post_init__(self):
        put = lambda name, value: object.__setattr__(self, name, value)  # noqa: E731 - frozen dataclass
        where = f"effect {self.name!r}"
        put("driver", Driver.of(self.driver))
        self.shape.check_driver(self.driver)
        coefficients = tuple(float(v) for v in np.atleast_1d(np.asarray(self.coefficients, dtype=float)))
        put("coefficients", coefficients)
        if coefficients and len(coefficients) != self.shape.size:
            raise Refused("effect-coefficients-count", where, count=len(coefficients), size=self.shape.size)
        if not all(abs(v) <= LARGEST for v in coefficients):
            raise Refused("effect-coefficient-too-large", where)
        if self.u is not None:
            put("u", tuple(None if v is None else float(v) for v in self.u))
            if not any(v is not None for v in self.u):
                put("u", (None,) * len(coefficients))
            if len(self.u) != len(coefficients):
                raise Refused("effect-coefficients-count", where, count=len(self.u), size=len(coefficients))
        for key in ("extent", "reach"):
            value = getattr(self, key)
            if value is not None:
                low, high = (float(v) for v in value)
                if not (math.isfinite(low) and math.isfinite(high) and low <= high):
                    raise Refused("effect-extent-reversed", where, low=low, high=high)
                put(key, (low, high))
        if self.driver_unit is None:
            put("driver_unit", self.driver.unit())

    @property
    def columns(self) -> tuple[str, ...]:
        """The columns of the readings that it needs."""
        return self.shape.columns(self.driver)

    def values(self, columns: Mapping[str, np.ndarray], where: str = "") -> np.ndarray:
        """(P,) value of its component, mm or rad; refuses where a column or the coefficients are missing."""
        where = where or f"effect {self.name!r}"
        if not self.coefficients:
            raise Refused("effect-without-coefficient", where)
        return self.shape.vectors(self.driver, columns, where) @ np.asarray(self.coefficients)

    @property
    def range(self) -> tuple[float, float] | None:
        """(lowest, highest) value of its component, mm or rad: as stated, or over the extent of its driver.

        None where neither is known: then it cannot be ranked.
        """
        if self.reach is not None:
            return self.reach
        if self.extent is None or not self.coefficients:
            return None
        return self.shape.extremes(self.coefficients, *self.extent)


@dataclass(frozen=True)
class Shown:
    """Numbers in the unit that they are shown and written in: values, unit ("" none), u (None: not known)."""

    values: tuple[float, ...]
    unit: str = ""
    u: tuple[float | None, ...] | None = None
    listed: bool = False  # a list, even of one number

    def to_dict(self) -> dict:
        """{"value", "unit", "u"}, as in files: a number, or a list."""
        out = {"value": list(self.values) if self.listed else self.values[0]}
        if self.unit:
            out["unit"] = self.unit
        if self.u is not None:
            out["u"] = list(self.u) if self.listed else self.u[0]
        return out


def shown(effect: Effect, component, exact: bool = True) -> dict[str, Shown]:
    """parameter -> numbers as shown: "coefficient", those of the shape, and "extent": the range of the component.

    component : of the machine, with `unit` and `angular`.  exact : reads back equal to the last bit, in um or urad, or
    else in mm or rad; otherwise always in um or urad.
    """
    out = {}
    if effect.coefficients:
        known = [v for v in (effect.u or ()) if v is not None]
        base, factor, number = _unit(component, (*effect.coefficients, *known), exact)
        unit = coefficient_unit(base, effect.shape, effect.driver_unit)
        several = len(effect.coefficients) > 1
        values = tuple(number(v, factor) for v in effect.coefficients)
        u = None if effect.u is None else tuple(None if v is None else number(v, factor) for v in effect.u)
        out["coefficient"] = Shown(values, unit, u, several)
    for name, parameter in effect.shape.parameters.items():
        value = effect.shape.values[name]
        if parameter.default is not None and value == parameter.default:
            continue
        unit = parameter.unit_of(effect.driver, effect.driver_unit)
        numbers = tuple(float(v) for v in parameter.numbers(value))
        out[name] = Shown(
            numbers, unit, (effect.shape_u[name],) if name in effect.shape_u else None, parameter.size != 1
        )
    if effect.reach is not None:
        unit, factor, number = _unit(component, effect.reach, exact)
        out["extent"] = Shown(tuple(number(v, factor) for v in effect.reach), unit, None, True)
    return out


def _unit(component, values, exact: bool):
    """(unit, factor, function of a value and the factor) in which numbers are shown; see `shown`."""
    if exact:
        return (*_exact_unit(component, values), exactly_shown)
    return component.unit, component.from_shown(1.0), lambda value, factor: value / factor


def _exact_unit(component, values) -> tuple[str, float]:
    """(unit, its factor): um or urad where every value reads back equal in it, else mm or rad."""
    factor = component.from_shown(1.0)
    if all(exactly_shown(v, factor) is not None for v in values):
        return component.unit, factor
    return ("rad" if component.angular else "mm"), 1.0


def coefficient_unit(base: str, shape: Shape, driver_unit: str) -> str:
    """Unit of a coefficient: `base` (such as um), over the driver's unit where the shape carries it.

    driver_unit : such as `K*mm`, or "".
    """
    power = shape.unit_power
    if not driver_unit or not power:
        return base
    if power != 1:
        return f"{base}/({driver_unit})^{power:.4g}"
    return f"{base}/({driver_unit})" if "*" in driver_unit or "/" in driver_unit else f"{base}/{driver_unit}"
