# SPDX-License-Identifier: LGPL-2.1-or-later
"""Between a traced candidate and the effect that is stored, shown and predicted with.

Coefficients are stored in um or urad per driver unit with their standard uncertainty; everything else that a shape
needs stands beside them, so that an effect can be evaluated from the file alone.
"""

from __future__ import annotations

import numpy as np

from ..core.driver import Driver
from ..core.drivers import Effect, effect_values
from ..core.errors import component
from ..core.shapes import Shape


def coefficient_unit(symbol: str, shape: Shape, driver: Driver, units=None) -> str:
    """um or urad per what the coefficient multiplies."""
    own, unit, power = component(symbol).unit, driver.unit(units), shape.unit_power
    if not unit or not power:
        return own
    if power != 1:
        return f"{own}/({unit})^{power:.4g}"
    return f"{own}/({unit})" if "*" in unit else f"{own}/{unit}"


PARAMETER_UNITS = {"tau": "s", "exponent": "", "degree": "", "bumps": ""}


def to_effect(name: str, candidate, covariance, uncertainty, units=None, extent=None) -> Effect:
    """An Effect of core.drivers from a candidate.

    covariance (m, m) of its coefficients, mm² or rad²; uncertainty : parameter -> standard uncertainty of τ, period ...
    extent : (lowest, highest) value of the component over the readings, um or urad.
    """
    c = component(candidate.symbol)
    scale = 1e6 if c.angular else 1e3
    driver = candidate.driver
    shape, heights, spread = candidate.shape.stored(candidate.coefficients, covariance)
    values = [float(v) * scale for v in heights]
    errors = [float(v) * scale for v in np.sqrt(np.maximum(np.diag(spread), 0.0))]
    single = len(values) == 1
    parameters = {
        "coefficient": {
            "value": values[0] if single else values,
            "unit": coefficient_unit(candidate.symbol, shape, driver, units),
            "u": errors[0] if single else errors,
        }
    }
    for key, parameter in shape.parameters.items():
        numbers = [float(v) for v in parameter.numbers(shape.values[key])]
        if shape.values[key] == parameter.default:
            continue
        entry = {"value": numbers[0] if parameter.size == 1 else numbers}
        unit = PARAMETER_UNITS.get(key, driver.unit(units))
        if unit and key != "domains":
            entry["unit"] = unit
        if key in uncertainty:
            entry["u"] = float(uncertainty[key])
        parameters[key] = entry
    if extent is not None:
        parameters["extent"] = {"value": [float(extent[0]), float(extent[1])], "unit": c.unit}
    return Effect(name, candidate.symbol, str(driver), shape.name, parameters, True)


def effect_motion(effect: Effect, columns) -> np.ndarray:
    """(P,) value of an effect's component, mm or rad."""
    return effect_values(effect, columns)
