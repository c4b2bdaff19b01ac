# SPDX-License-Identifier: LGPL-2.1-or-later
"""Errors at new places and conditions from a fitted, augmented machine.

The answer is in the frame of the readings: the fitted alignment of the set-up and the offset of a named run are
included unless they are left out on request.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ..core.drivers import driver_columns, driver_values, to_domain
from ..core.errors import AXES, component
from ..core.machine import Machine
from ..core.refusal import Refused
from ..core.synthesis import omega
from ..core.units import factor
from .effects import effect_motion
from .readings import Readings


def _constant(entry, symbol: str) -> float:
    c = component(symbol)
    value, unit = (entry["value"], entry.get("unit", c.unit)) if isinstance(entry, Mapping) else (entry, c.unit)
    return float(value) * factor(unit, angular=c.angular)


def declared_values(machine: Machine, q) -> dict[str, np.ndarray]:
    """symbol -> (P,) mm or rad of the fitted declared errors at positions q (P, 3)."""
    values = {}
    for symbol, entry in (machine.fitted or {}).items():
        if symbol in ("alignment", "runs", "covariance") or symbol.startswith("x-"):
            continue
        c = component(symbol)
        if isinstance(entry, Mapping) and "coefficients" in entry:
            v = to_domain(q[:, AXES.index(c.body)], entry["domain"])
            scale = factor(entry["unit"], angular=c.angular)
            values[symbol] = scale * np.polynomial.legendre.legval(v, np.asarray(entry["coefficients"], dtype=float))
        else:
            values[symbol] = np.full(len(q), _constant(entry, symbol))
    return values


def needed_columns(machine: Machine) -> list[str]:
    """Columns that the enabled effects need."""
    names: list[str] = []
    for effect in machine.effects:
        if effect.enabled:
            names += driver_columns(effect.driver) + (("t",) if effect.shape == "lag" else ())
    return list(dict.fromkeys(names))


def predict(machine: Machine, positions: Readings, alignment: bool = True, effects: bool = True) -> np.ndarray:
    """(P, 3) predicted error, mm, actual minus commanded in the machine frame.

    alignment : include the fitted alignment and run offsets.  effects : include the enabled effects; refuses when a
    column that one of them needs is missing, or where a result is not a finite number.
    """
    if machine.fitted is None:
        raise Refused(
            "this machine has no fitted errors",
            machine.name,
            "Run trace first, and predict from its machine_augmented.",
        )
    with np.errstate(all="ignore"):
        out = _predicted(machine, positions, alignment, effects)
    bad = ~np.isfinite(out).all(axis=1)
    if bad.any():
        row = int(np.argmax(bad))
        raise Refused("predicted-not-finite", f"row {row}" if positions.line is None else f"line {positions.line[row]}")
    return out


def _predicted(machine: Machine, positions: Readings, alignment: bool, effects: bool) -> np.ndarray:
    q = positions.q
    parts: list[tuple[str, np.ndarray]] = list(declared_values(machine, q).items())
    if alignment:
        for symbol, entry in machine.fitted.get("alignment", {}).items():
            parts.append((symbol, np.full(len(q), _constant(entry, symbol))))
    if effects:
        for effect in machine.effects:
            if effect.enabled:
                parts.append((effect.component, effect_motion(effect, positions.columns)))
    out = np.zeros((len(q), 3))
    if parts:
        symbols = list(dict.fromkeys(s for s, _ in parts))
        total = {s: sum(v for name, v in parts if name == s) for s in symbols}
        matrix = omega(machine, symbols, q, positions.tool_offset)
        out += np.einsum("pan,pn->pa", matrix, np.stack([total[s] for s in symbols], axis=1))
    if alignment:
        if positions.run is not None:
            offsets = machine.fitted.get("runs", {})
            for label in {str(r) for r in positions.run}:
                if label in offsets:
                    mask = np.array([str(r) == label for r in positions.run])
                    out[mask] += 1e-3 * np.asarray(offsets[label], dtype=float)
        for tool in machine.fitted.get("x-tools", ()):
            if positions.tool_offset is not None:
                mask = np.abs(positions.tool_offset - np.asarray(tool["offset_mm"])).max(axis=1) < 1e-3
                out[mask] += 1e-3 * np.asarray(tool["error_um"], dtype=float)
    return out


def extrapolated(machine: Machine, positions: Readings) -> np.ndarray:
    """(P,) where a place or a driver lies outside what the fit has seen (by more than 1 % of its range)."""
    ranges = (machine.fitted or {}).get("x-ranges", {})
    outside = np.zeros(positions.points, dtype=bool)
    for name, (low, high) in ranges.items():
        if name in positions.columns:
            slack = 0.01 * (high - low) + 1e-9
            v = positions.columns[name]
            outside |= (v < low - slack) | (v > high + slack)
    known = (machine.fitted or {}).get("x-tools")
    if known and positions.tool_offset is not None:
        seen = np.array([t["offset_mm"] for t in known])
        gap = np.abs(positions.tool_offset[:, None, :] - seen[None]).max(axis=2).min(axis=1)
        outside |= gap > 1e-3
    return outside


def driver_extent(effect, columns) -> tuple[float, float]:
    """Smallest and largest value of an effect's driver."""
    v = driver_values(effect.driver, columns)
    return float(v.min()), float(v.max())
