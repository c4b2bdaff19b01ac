# SPDX-License-Identifier: LGPL-2.1-or-later
"""What drives an error component: a column of the readings, or a product of columns, through a shape.

Every error is component x driver.  The declared errors are driven by their own axis position; an effect is a component
with another driver.  Driver values are mm, seconds, kelvin from 20 degC, directions -1/0/+1, and others as written.
Rows are in time order wherever a shape has memory.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from .refusal import Refused

SHAPES = ("linear", "polynomial", "reversal", "periodic", "approach", "step", "lag", "power", "hysteresis", "smooth")


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


def to_domain(v, domain) -> np.ndarray:
    """Map [lo, hi] to [-1, 1]."""
    low, high = domain
    return (2 * np.asarray(v, dtype=float) - low - high) / (high - low)


def legendre(v, degree: int, domain, start: int = 1) -> np.ndarray:
    """(P, degree - start + 1) Legendre P_start .. P_degree of v mapped from `domain` to [-1, 1]."""
    return np.polynomial.legendre.legvander(to_domain(v, domain), degree)[:, start:]


def lag(v, t, tau: float, state0: float = 0.0) -> np.ndarray:
    """First-order lag y' = (v - y)/tau, rows in time order, v held over each interval at its end value.

    v, t : (P,).  y = state0 at the first row.  A row whose time does not advance keeps the state.
    """
    v, t = np.asarray(v, dtype=float), np.asarray(t, dtype=float)
    keep = np.exp(-np.maximum(np.diff(t), 0.0) / tau)
    y = np.empty_like(v)
    state = float(state0)
    y[0] = state
    for i, k in enumerate(keep.tolist(), start=1):
        state = v[i] + (state - v[i]) * k
        y[i] = state
    return y


def hysteresis(v, width: float) -> np.ndarray:
    """Play (backlash) operator of half-width `width` on v, minus v: what a drive with friction loses, in units of v.

    The output starts at 0 and follows v with play; the difference saturates at +-width after each reversal.
    """
    v = np.asarray(v, dtype=float)
    y = np.empty_like(v)
    state = v[0]
    for i, x in enumerate(v.tolist()):
        state = min(max(state, x - width), x + width)
        y[i] = x - state
    return y


def shape_basis(effect: Effect, columns: Mapping[str, np.ndarray], where: str = "") -> np.ndarray:
    """(P, m) the columns that an effect's coefficients multiply, before lever arms."""
    where = where or f"effect {effect.name!r}"
    v = driver_values(effect.driver, columns, where)
    shape = effect.shape
    if shape in ("linear", "reversal"):
        return v[:, None]
    if shape == "polynomial":
        degree = int(effect.parameter("degree", len(np.atleast_1d(effect.parameter("coefficient", [0.0])))))
        return legendre(v, degree, effect.parameter("domain"))
    if shape == "periodic":
        phase = 2 * math.pi * v / effect.parameter("period")
        return np.column_stack([np.sin(phase), np.cos(phase)])
    if shape == "approach":
        return (1 - np.exp(-v / effect.parameter("tau")))[:, None]
    if shape == "step":
        return (v > effect.parameter("at")).astype(float)[:, None]
    if shape == "lag":
        t = driver_values("t", columns, where)
        return lag(v, t, effect.parameter("tau"), effect.parameter("state0", 0.0))[:, None]
    if shape == "power":
        return (np.sign(v) * np.abs(v) ** effect.parameter("exponent"))[:, None]
    if shape == "hysteresis":
        return hysteresis(v, effect.parameter("width"))[:, None]
    raise Refused(f"unknown shape {shape!r}", where, f"Use one of {', '.join(SHAPES)}.")


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
