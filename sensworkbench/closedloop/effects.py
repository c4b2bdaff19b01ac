# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a candidate with its fitted coefficients to the effect that a machine keeps."""

from __future__ import annotations

import numpy as np

from ..core import effects
from ..core.driver import Driver
from ..core.effects import Effect
from ..core.errors import component
from ..core.shapes import Shape


def coefficient_unit(symbol: str, shape: Shape, driver: Driver, units=None) -> str:
    """um or urad per what the coefficient multiplies.  units : column -> unit, of the readings."""
    return effects.coefficient_unit(component(symbol).unit, shape, driver.unit(units))


def to_effect(name: str, candidate, covariance, uncertainty, units=None, reach=None, extent=None) -> Effect:
    """The effect of a candidate.

    covariance (m, m) of its coefficients, mm² or rad²; uncertainty : parameter -> its standard uncertainty.
    units : column -> unit, of the readings.  reach : (lowest, highest) value of the component over the readings, mm or
    rad.  extent : (lowest, highest) value of its driver over them.
    """
    shape, coefficients, spread = candidate.shape.stored(candidate.coefficients, covariance)
    factor = component(candidate.symbol).from_shown(1.0)
    coefficients, u = (
        (np.asarray(v) / factor) * factor for v in (coefficients, np.sqrt(np.maximum(np.diag(spread), 0.0)))
    )  # what is written in um or urad reads back equal
    reach = None if reach is None else tuple((v / factor) * factor for v in reach)
    return Effect(
        name=name,
        component=candidate.symbol,
        driver=candidate.driver,
        shape=shape,
        coefficients=tuple(coefficients),
        u=tuple(u),
        shape_u=dict(uncertainty),
        reach=reach,
        extent=extent,
        driver_unit=candidate.driver.unit(units),
    )
