# SPDX-License-Identifier: LGPL-2.1-or-later
"""Between a traced candidate and the effect that is stored, shown and predicted with.

Coefficients are stored in um or urad per driver unit with their standard uncertainty; everything else that a shape
needs stands beside them, so that an effect can be evaluated from the file alone.
"""

from __future__ import annotations

import numpy as np

from ..core.drivers import Effect, driver_columns, effect_values
from ..core.errors import component
from ..core.refusal import Refused
from .bank import Shape
from .search import vectors_of

UNITS = {"x": "mm", "y": "mm", "z": "mm", "t": "s", "feed": "mm/min", "spindle": "rpm"}


def column_unit(name: str, units=None) -> str:
    """Unit of a driver column ("" where it has none)."""
    if units and units.get(name):
        return "K" if units[name] in ("C", "K") and name.startswith("temp_") else units[name]
    if name.startswith("temp_"):
        return "K"
    if name.startswith("load_"):
        return "kg"
    return UNITS.get(name, "")


def driver_unit(driver: str, units=None) -> str:
    """Unit of a driver: the product of its columns' units."""
    parts: dict[str, int] = {}
    for name in driver_columns(driver):
        unit = column_unit(name, units)
        if unit:
            parts[unit] = parts.get(unit, 0) + 1
    return "*".join(u if n == 1 else f"{u}^{n}" for u, n in parts.items())


def coefficient_unit(symbol: str, shape: str, driver: str, parameters, units=None) -> str:
    """um or urad per what the coefficient multiplies."""
    own = component(symbol).unit
    if shape in ("polynomial", "periodic", "approach", "step", "smooth", "reversal"):
        return own
    unit = driver_unit(driver, units)
    if not unit:
        return own
    if shape == "power":
        return f"{own}/({unit})^{parameters['exponent']:.4g}"
    return f"{own}/({unit})" if "*" in unit else f"{own}/{unit}"


PARAMETER_UNITS = {"tau": "s", "exponent": "", "degree": "", "bumps": ""}


def to_effect(name: str, candidate, covariance, uncertainty, units=None, extent=None) -> Effect:
    """An Effect of core.drivers from a candidate.

    covariance (m, m) of its coefficients, mm² or rad²; uncertainty : parameter -> standard uncertainty of τ, period ...
    extent : (lowest, highest) value of the component over the readings, um or urad.
    """
    c = component(candidate.symbol)
    scale = 1e6 if c.angular else 1e3
    shape = candidate.shape
    mix = shape.parameters.get("mix")
    heights = candidate.coefficients if mix is None else mix @ candidate.coefficients
    spread = covariance if mix is None else mix @ covariance @ mix.T
    values = [float(v) * scale for v in heights]
    errors = [float(v) * scale for v in np.sqrt(np.maximum(np.diag(spread), 0.0))]
    single = len(values) == 1
    parameters = {
        "coefficient": {
            "value": values[0] if single else values,
            "unit": coefficient_unit(candidate.symbol, shape.shape, shape.driver, shape.parameters, units),
            "u": errors[0] if single else errors,
        }
    }
    for key, value in shape.parameters.items():
        if key == "mix":
            continue
        if key == "domains":
            parameters[key] = {"value": [float(v) for d in value for v in d]}
            continue
        unit = PARAMETER_UNITS.get(key, driver_unit(shape.driver, units))
        entry = {"value": [float(v) for v in value] if isinstance(value, tuple) else float(value)}
        if unit:
            entry["unit"] = unit
        if key in uncertainty:
            entry["u"] = float(uncertainty[key])
        parameters[key] = entry
    if extent is not None:
        parameters["extent"] = {"value": [float(extent[0]), float(extent[1])], "unit": c.unit}
    return Effect(name, candidate.symbol, shape.driver, shape.shape, parameters, True)


def effect_motion(effect: Effect, columns) -> np.ndarray:
    """(P,) value of an effect's component, mm or rad; knows the smooth free form too."""
    if effect.shape != "smooth":
        return effect_values(effect, columns)
    flat = effect.parameter("domains")
    domains = tuple((flat[i], flat[i + 1]) for i in range(0, len(flat), 2))
    bumps = tuple(int(n) for n in np.atleast_1d(effect.parameter("bumps")))
    shape = Shape(effect.driver, "smooth", {"bumps": bumps, "domains": domains})
    for name in driver_columns(effect.driver):
        if name not in columns:
            raise Refused(f"column {name!r} is missing, and effect {effect.name!r} needs it", "", f"Add {name!r}.")
    scale = 1e-6 if component(effect.component).angular else 1e-3
    coefficient = np.atleast_1d(np.asarray(effect.parameter("coefficient"), dtype=float))
    return scale * (vectors_of(shape, columns) @ coefficient)
