# SPDX-License-Identifier: LGPL-2.1-or-later
"""Errors at new places and conditions from a fitted, augmented machine.

The answer is in the frame of the readings: the fitted alignment of the set-up and the offset of a named run are
included unless they are left out on request.
"""

from __future__ import annotations

import numpy as np

from ..core.fitted import FittedModel
from ..core.machine import Machine
from ..core.refusal import Refused
from ..core.synthesis import omega
from .readings import Readings


def declared_values(machine: Machine, q) -> dict[str, np.ndarray]:
    """symbol -> (P,) mm or rad of the fitted declared errors at positions q (P, n), mm or rad."""
    fitted = machine.fitted or FittedModel()
    shown = {j.name: j.to_shown(q[:, i]) for i, j in enumerate(machine.joints)}
    return {s: fitted.values(s, shown[machine.component(s).body]) for s in fitted.symbols}


def needed_columns(machine: Machine) -> list[str]:
    """Columns that the enabled effects need."""
    names: list[str] = []
    for effect in machine.effects:
        if effect.enabled:
            names += effect.columns
    return list(dict.fromkeys(names))


def predict(machine: Machine, positions: Readings, alignment: bool = True, effects: bool = True) -> np.ndarray:
    """(P, 3) predicted error, mm, actual minus commanded in the machine frame.

    alignment : include the fitted alignment and run offsets.  effects : include the enabled effects; refuses when a
    column that one of them needs is missing, or where a result is not a finite number.
    """
    if machine.fitted is None:
        raise Refused("predict-no-fit", machine.name)
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
        parts += [(symbol, np.full(len(q), c.value)) for symbol, c in machine.fitted.alignment.items()]
        parts += _of_runs(machine.fitted, positions)
    if effects:
        for effect in machine.effects:
            if effect.enabled:
                parts.append((effect.component, effect.values(positions.columns)))
    out = np.zeros((len(q), 3))
    if parts:
        symbols = list(dict.fromkeys(s for s, _ in parts))
        total = {s: sum(v for name, v in parts if name == s) for s in symbols}
        matrix = omega(machine, symbols, q, positions.tool_offset)
        out += np.einsum("pan,pn->pa", matrix, np.stack([total[s] for s in symbols], axis=1))
    if alignment:
        for tool in machine.fitted.tools:
            if positions.tool_offset is not None:
                mask = np.abs(positions.tool_offset - np.asarray(tool.offset)).max(axis=1) < 1e-3
                out[mask] += np.asarray(tool.error)
    return out


def _of_runs(fitted: FittedModel, positions: Readings) -> list[tuple[str, np.ndarray]]:
    """(symbol, (P,)) what the runs that the positions name add to the alignment."""
    if positions.run is None:
        return []
    labels = np.array([str(r) for r in positions.run])
    return [
        (symbol, np.where(labels == label, constant.value, 0.0))
        for label in sorted(set(labels))
        for symbol, constant in fitted.runs.get(label, {}).items()
    ]


def extrapolated(machine: Machine, positions: Readings) -> np.ndarray:
    """(P,) where a place or a driver lies outside what the fit has seen (by more than 1 % of its range)."""
    fitted = machine.fitted or FittedModel()
    outside = np.zeros(positions.points, dtype=bool)
    for name, (low, high) in fitted.ranges.items():
        if name in positions.columns:
            slack = 0.01 * (high - low) + 1e-9
            v = positions.columns[name]
            outside |= (v < low - slack) | (v > high + slack)
    if fitted.tools or fitted.ranges:  # readings without tool columns were taken with the machine's own tool
        seen = np.array([t.offset for t in fitted.tools] or [(0.0, 0.0, 0.0)])
        tool = np.zeros((positions.points, 3)) if positions.tool_offset is None else positions.tool_offset
        outside |= np.abs(tool[:, None, :] - seen[None]).max(axis=2).min(axis=1) > 1e-3
    return outside
