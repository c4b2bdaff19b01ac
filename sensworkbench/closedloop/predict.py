# SPDX-License-Identifier: LGPL-2.1-or-later
"""Errors at new places and conditions from a fitted, augmented machine.

The answer is in the frame of the readings: the fitted alignment of the set-up and the offset of a named run are
included unless they are left out on request.
"""

from __future__ import annotations

import numpy as np

from ..core.fitted import ALIGNMENT, DECLARED, EFFECT, RUN, FittedModel
from ..core.machine import Machine
from ..core.refusal import Refused
from ..core.shapes import Regressor, legendre
from ..core.synthesis import omega
from .readings import Readings
from .settings import DEFAULT, TraceSettings


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


def predict(
    machine: Machine,
    positions: Readings,
    alignment: bool = True,
    effects: bool = True,
    settings: TraceSettings = DEFAULT,
) -> np.ndarray:
    """(P, 3) predicted error, mm, actual minus commanded in the machine frame.

    alignment : include the fitted alignment and run offsets.  effects : include the enabled effects; refuses when a
    column that one of them needs is missing, or where a result is not a finite number.  settings : of the trace.
    """
    if machine.fitted is None:
        raise Refused("predict-no-fit", machine.name)
    with np.errstate(all="ignore"):
        out = _predicted(machine, positions, alignment, effects, settings)
    bad = ~np.isfinite(out).all(axis=1)
    if bad.any():
        row = int(np.argmax(bad))
        raise Refused("predicted-not-finite", f"row {row}" if positions.line is None else f"line {positions.line[row]}")
    return out


def _predicted(machine: Machine, positions: Readings, alignment: bool, effects: bool, settings) -> np.ndarray:
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
                mask = np.abs(positions.tool_offset - np.asarray(tool.offset)).max(axis=1) < settings.same_tool
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


CHUNK = 2000  # points at a time


def uncertainty(
    machine: Machine, positions: Readings, alignment: bool = True, settings: TraceSettings = DEFAULT
) -> np.ndarray | None:
    """(P, 3) standard uncertainty of what `predict` gives, mm, correlations kept; None where none is known.

    It is that of the systematic error: a new reading scatters about it by its own noise besides.  A rival whose columns
    the positions lack takes no part.
    """
    known = None if machine.fitted is None else machine.fitted.uncertainty
    if known is None:
        return None
    factor = known.matrix()
    at = {key: i for i, key in enumerate(known.parameters)}
    step = dict(zip(known.parameters, np.sqrt((factor**2).sum(axis=1)).tolist()))
    effects = {e.name: e for e in machine.effects if e.enabled}
    columns: list[tuple[int, str | int, np.ndarray]] = []  # of each parameter: symbol or axis, and what it multiplies
    for key, i in at.items():
        columns += [(i, *part) for part in _part(machine, key, positions, alignment, effects, step[key], settings)]
    others = [o for o in known.others if set(o.effect.columns) <= set(positions.columns)]
    own = [(o.effect.component, np.sqrt(o.weight) * o.effect.values(positions.columns)) for o in others]
    own += _apart(effects.values(), {key[1] for key in at if key[0] == EFFECT}, positions)
    symbols = list(dict.fromkeys([s for _, s, _ in columns if isinstance(s, str)] + [s for s, _ in own]))
    changes = [np.sqrt(o.weight) * np.array(o.changes) for o in others]
    changes += [np.zeros(len(factor))] * (len(own) - len(others))
    wide = np.column_stack([factor, *changes])
    out = np.empty((positions.points, 3))
    for begin in range(0, positions.points, CHUNK):
        some = slice(begin, begin + CHUNK)
        tool = None if positions.tool_offset is None else positions.tool_offset[some]
        matrix = omega(machine, symbols, positions.q[some], tool)
        total = np.zeros((*matrix.shape[:2], wide.shape[1]))
        where = {s: j for j, s in enumerate(symbols)}
        for symbol in symbols:
            mine = [(i, v[some]) for i, s, v in columns if s == symbol]
            if mine:
                motion = np.stack([v for _, v in mine], axis=1) @ wide[[i for i, _ in mine]]
                total += matrix[:, :, where[symbol], None] * motion[:, None, :]
        for i, axis, v in columns:
            if not isinstance(axis, str):
                total[:, axis] += v[some, None] * wide[i]
        for j, (symbol, v) in enumerate(own, start=factor.shape[1]):
            total[:, :, j] += matrix[:, :, where[symbol]] * v[some, None]
        out[some] = np.sqrt((total**2).sum(axis=2))
    return out


def _apart(effects, known: set[str], positions: Readings) -> list[tuple[str, np.ndarray]]:
    """(component, (P,) uncertainty) by each coefficient of effects that the covariance lacks, such as earlier ones."""
    out = []
    for effect in effects:
        if effect.name not in known and effect.u is not None:
            vectors = effect.shape.vectors(effect.driver, positions.columns)
            out += [(effect.component, vectors[:, j] * u) for j, u in enumerate(effect.u) if u]
    return out


def _part(machine: Machine, key, positions: Readings, alignment: bool, effects, step: float, settings: TraceSettings):
    """(symbol, or axis of a shift at the tool; (P,) what a parameter of the covariance multiplies), none or one."""
    group, count = key[0], positions.points
    if group == DECLARED:
        symbol, order = key[1:]
        series = machine.fitted.series.get(symbol)
        if series is None:
            return [(symbol, np.ones(count))] if symbol in machine.fitted.constants else []
        joint = machine.joint(machine.component(symbol).body)
        place = joint.to_shown(positions.q[:, machine.names.index(joint.name)])
        return [(symbol, legendre(place, order, series.domain, start=order)[:, 0])]
    if group == EFFECT:
        effect = effects.get(key[1])
        if effect is None:
            return []
        regressor = Regressor(effect.driver, effect.shape)
        if len(key) == 4:
            return [(effect.component, regressor.vectors(positions.columns)[:, key[3]])]
        limit = 0.3 * abs(effect.shape.values[key[2]])
        step = min(step, limit) if limit > 0 and not effect.shape.sudden else step
        slope = regressor.slope(positions.columns, effect.coefficients, key[2], max(step, 1e-12))
        return [(effect.component, slope)]
    if not alignment:
        return []
    if group == ALIGNMENT:
        return [(key[1], np.ones(count))]
    if group == RUN:
        if positions.run is None:
            return []
        return [(key[2], (np.array([str(r) for r in positions.run]) == key[1]).astype(float))]
    if positions.tool_offset is None or key[1] >= len(machine.fitted.tools):
        return []
    offset = np.asarray(machine.fitted.tools[key[1]].offset)
    return [(key[2], (np.abs(positions.tool_offset - offset).max(axis=1) < settings.same_tool).astype(float))]


def extrapolated(machine: Machine, positions: Readings, settings: TraceSettings = DEFAULT) -> np.ndarray:
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
        outside |= np.abs(tool[:, None, :] - seen[None]).max(axis=2).min(axis=1) > settings.same_tool
    return outside
