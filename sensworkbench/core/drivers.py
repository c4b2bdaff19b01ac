# SPDX-License-Identifier: LGPL-2.1-or-later
"""What drives an error component: a column of the readings, or a product of columns, through a shape.

Every error is component x driver.  The declared errors are driven by their own axis position; an effect is a component
with another driver.  Driver values are mm, seconds, kelvin from 20 degC, directions -1/0/+1, and others as written.
Rows are in time order wherever a shape has memory.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from .driver import Driver
from .refusal import Refused
from .shapes import SHAPES as SHAPES
from .shapes import Regressor, hysteresis, lag, legendre, shape_class, to_domain

__all__ = ["Effect", "hysteresis", "lag", "legendre", "to_domain"]


@dataclass(frozen=True)
class Effect:
    """One component with a driver that the declared model lacks.

    component : ISO symbol.  driver : column names joined by "*" (sorted).  shape : one of SHAPES.
    parameters : name -> {"value", "unit", "u"}; "coefficient" is a number or a list (um or urad per driver unit),
    the rest are the shape's own (`tau`, `period`, `at`, `exponent`, `domain`, `state0`).
    """

    name: str
    component: str
    driver: str
    shape: str
    parameters: Mapping = field(default_factory=dict)
    enabled: bool = True

    def parameter(self, key: str, default=None):
        entry = self.parameters.get(key)
        if entry is None:
            if default is None:
                raise Refused(f"effect {self.name!r} has no {key!r}", f"effects, {self.name}, parameters")
            return default
        return entry["value"] if isinstance(entry, Mapping) else entry


def driver_name(columns) -> str:
    """Canonical name of a product of columns: sorted, joined by "*"."""
    return "*".join(sorted(columns))


def driver_columns(driver: str) -> tuple[str, ...]:
    return tuple(driver.split("*"))


def driver_values(driver: str, columns: Mapping[str, np.ndarray], where: str = "") -> np.ndarray:
    """(P,) the product of the named columns; refuses a column that is not there."""
    value = None
    for name in driver_columns(driver):
        if name not in columns:
            raise Refused(
                f"column {name!r} is missing, and driver {driver!r} needs it", where, f"Add a column for {name!r}."
            )
        value = columns[name] if value is None else value * columns[name]
    return np.asarray(value, dtype=float)


def shape_basis(effect: Effect, columns: Mapping[str, np.ndarray], where: str = "") -> np.ndarray:
    """(P, m) the columns that an effect's coefficients multiply, before lever arms."""
    where = where or f"effect {effect.name!r}"
    shape = shape_class(effect.shape, where)
    kept = {k: v["value"] if isinstance(v, Mapping) else v for k, v in effect.parameters.items()}
    for key, parameter in shape.parameters.items():
        if key in kept and isinstance(kept[key], list):
            kept[key] = parameter.of_numbers(kept[key])
    if "degree" in shape.parameters:
        kept.setdefault("degree", len(np.atleast_1d(effect.parameter("coefficient", [0.0]))))
    regressor = Regressor(Driver.parse(effect.driver), shape(**{k: kept[k] for k in shape.parameters if k in kept}))
    return regressor.vectors(columns, where)


def effect_values(effect: Effect, columns: Mapping[str, np.ndarray], where: str = "") -> np.ndarray:
    """(P,) the value of the effect's component: mm or rad."""
    from .errors import component

    scale = 1e-6 if component(effect.component).angular else 1e-3  # coefficients are in urad or um
    basis = shape_basis(effect, columns, where)
    coefficient = np.atleast_1d(np.asarray(effect.parameter("coefficient"), dtype=float))
    if coefficient.size != basis.shape[1]:
        raise Refused(
            f"{coefficient.size} coefficients for a shape with {basis.shape[1]}", where or f"effect {effect.name!r}"
        )
    return scale * (basis @ coefficient)
