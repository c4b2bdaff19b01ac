# SPDX-License-Identifier: LGPL-2.1-or-later
"""What could be known at best: the fit that knows each effect's form and must still estimate everything else, and the
other drivers and components that the same readings cannot tell from the true ones.
"""

from __future__ import annotations

import itertools

import numpy as np

from .effects import Effect, basis
from .kinematics import AXES, COMPONENTS, SQUARENESS, Machine, direction_of, levers, linear_error

DEGREE = 3
RANK_TOLERANCE = 1e-9


def declared_columns(machine: Machine, q, tool=0.0, run=None, runs=(), tools=()) -> np.ndarray:
    """(3N, p): 48 coefficients of the cubic errors, 3 squareness, 6 alignment, an offset per further run and tool."""
    arms, columns = levers(machine, q, tool), []
    for axis in AXES:
        low, high = machine.travel[axis]
        u = (2 * q[:, AXES.index(axis)] - low - high) / (high - low)
        powers = np.polynomial.legendre.legvander(u, DEGREE)
        for motion in "XYZABC":
            first = 2 if motion in AXES and motion != axis else 1
            way = direction_of(f"E{motion}{axis}", arms)
            columns += [way * powers[:, [n]] for n in range(first, DEGREE + 1)]
    columns += [linear_error(machine, q, {name: 1.0}, tool) for name in SQUARENESS]
    columns += [np.array(direction_of(f"E{motion}W", arms)) for motion in "XYZABC"]
    for label in runs[1:]:
        columns += [np.outer(run == label, unit).astype(float) for unit in np.eye(3)]
    for offset in tools[1:]:
        columns += [np.outer(np.all(tool == offset, axis=1), unit).astype(float) for unit in np.eye(3)]
    return np.stack(columns, axis=2).reshape(3 * len(q), -1)


def effect_columns(machine: Machine, effect: Effect, q, table, scale, tool=0.0, free=None) -> np.ndarray:
    """(3N, m) lever arm times driver."""
    way = direction_of(effect.component, levers(machine, q, tool))
    return (way[:, :, None] * basis(effect, table, scale, free)[:, None, :]).reshape(3 * len(q), -1)


def complement(columns: np.ndarray):
    """A function that projects (3N,) or (3N, m) off the span of the columns."""
    scaled = columns / np.maximum(np.linalg.norm(columns, axis=0), 1e-300)
    u, s, _ = np.linalg.svd(scaled, full_matrices=False)
    u = u[:, s > RANK_TOLERANCE * s[0]]
    return lambda v: v - u @ (u.T @ v)


def way_of(machine: Machine, component: str, q, tool=0.0) -> np.ndarray:
    """(N, 3) error per mm or rad of a component, squareness included."""
    if component in SQUARENESS:
        return linear_error(machine, q, {component: 1.0}, tool)
    return np.array(direction_of(component, levers(machine, q, tool)))


def left_over(machine, effects, said, measured, sigma: float) -> list[dict]:
    """How much of each true effect remains when what was said is fitted with its own nonlinear parameters.

    Per effect: `chi2` that remains, and its `share` of what the declared model leaves of the effect.
    """
    q, table, scale, tool, *labels = measured
    fixed = [declared_columns(machine, q, tool, *labels)]
    before = complement(fixed[0])
    for e in said:
        way = way_of(machine, e.component, q, tool)
        fixed.append((way[:, :, None] * basis(e, table, scale)[:, None, :]).reshape(3 * len(q), -1))
    after = complement(np.hstack(fixed))
    out = []
    for e in effects:
        signal = effect_columns(machine, e, q, table, scale, tool) @ e.coefficient
        left, whole = (float(np.sum(off(signal) ** 2)) for off in (after, before))
        out.append({"chi2": left / sigma**2, "share": left / whole})
    return out


def solve(columns: np.ndarray, values: np.ndarray) -> np.ndarray:
    size = np.maximum(np.linalg.norm(columns, axis=0), 1e-300)
    return np.linalg.lstsq(columns / size, values, rcond=RANK_TOLERANCE)[0] / size


def oracle_prediction(machine, effects, measured, reading, fresh, keep) -> np.ndarray:
    """(M, 3) mm predicted at the fresh places by the fit that knows the effects' forms.

    measured, fresh : (q, table, scale, tool, run, runs, tools).  reading : (N, 3) mm.  keep : (N,): no outlier.
    """
    q, table, scale, tool, *labels = measured
    fixed = declared_columns(machine, q, tool, *labels)
    rows = np.repeat(keep, 3)
    value = reading.ravel()[rows]
    free = [dict(e.free) for e in effects]

    def design(free):
        return [effect_columns(machine, e, q, table, scale, tool, f) for e, f in zip(effects, free)]

    def misfit(free):
        columns = np.hstack([fixed, *design(free)])[rows]
        return float(np.sum((value - columns @ solve(columns, value)) ** 2))

    for e, f in zip(effects, free):  # an instant has no derivative: look at every gap near it
        if e.shape == "step":
            gaps = (table["t"][1:] + table["t"][:-1]) / 2
            near = gaps[np.argsort(np.abs(gaps - f["at"]))[:25]]
            cost = []
            for at in near:
                f["at"] = float(at)
                cost.append(misfit(free))
            f["at"] = float(near[int(np.argmin(cost))])
    smooth = [(i, name) for i, e in enumerate(effects) for name in e.free if e.shape != "step"]
    for _ in range(8 if smooth else 0):
        blocks = design(free)
        columns = np.hstack([fixed, *blocks])[rows]
        best = solve(columns, value)
        parts = np.split(best[fixed.shape[1] :], np.cumsum([b.shape[1] for b in blocks])[:-1])
        slopes = []
        for i, name in smooth:
            step = 1e-4 * max(abs(free[i][name]), 1e-3)
            moved = {**free[i], name: free[i][name] + step}
            after = effect_columns(machine, effects[i], q, table, scale, tool, moved)
            slopes.append(((after - blocks[i]) @ parts[i] / step)[rows])
        joint = np.column_stack([columns, *slopes])
        move = solve(joint, value)[-len(smooth) :]
        here, length = misfit(free), 1.0
        while length > 1e-3:
            trial = [dict(f) for f in free]
            for (i, name), d in zip(smooth, move):
                limit = 0.3 * max(abs(free[i][name]), 0.1)
                trial[i][name] += float(np.clip(length * d, -limit, limit))
            if misfit(trial) <= here:
                break
            length /= 2
        else:
            break
        free = trial
    columns = np.hstack([fixed, *design(free)])
    best = solve(columns[rows], value)
    q, table, scale, tool, *labels = fresh
    ahead = [declared_columns(machine, q, tool, *labels)]
    ahead += [effect_columns(machine, e, q, table, scale, tool, f) for e, f in zip(effects, free)]
    return (np.hstack(ahead) @ best).reshape(-1, 3)


def aliases(machine, effect, measured, sigma: float, shortest: float = 3.0) -> list[float]:
    """Other periods, mm, that fit a periodic effect as well (expected chi-square lost < 9): the plan aliases it."""
    q, table, scale, tool, *labels = measured
    off = complement(declared_columns(machine, q, tool, *labels))
    target = off(effect_columns(machine, effect, q, table, scale, tool) @ effect.coefficient)
    v = table[effect.driver]
    span, true = float(np.ptp(v)), 1 / effect.free["period"]
    others = np.arange(1 / (2 * span), 1 / shortest, 1 / (6 * span))
    # an alias stands at a combination of the sampling frequency and the true one: refine every near miss
    way = way_of(machine, effect.component, q, tool)

    def lost(frequency):
        angle = 2 * np.pi * frequency * v
        block = np.stack([np.sin(angle), np.cos(angle)], axis=1)
        block = off((way[:, :, None] * block[:, None, :]).reshape(3 * len(q), -1))
        gram = block.T @ block
        if np.linalg.cond(gram) > 1e10:
            block = block[:, [int(np.argmax(np.diag(gram)))]]
            gram = block.T @ block
        right = block.T @ target
        return float(target @ target - right @ np.linalg.solve(gram, right)) / sigma**2

    first = np.array([lost(f) for f in others])
    found: list[float] = []
    for i in np.argsort(first)[:40]:
        near = others[i] + np.linspace(-1, 1, 13) / (6 * span)
        best = min(near, key=lost)
        best = min(best + np.linspace(-1, 1, 21) / (72 * span), key=lost)
        apart = abs(best - true) * span > 0.7 and all(abs(best - 1 / p) * span > 0.7 for p in found)
        if apart and best > 0 and lost(best) < 9:
            found.append(1 / float(best))
    return found


def lookalikes(machine, effects, measured, sigma: float) -> list[dict]:
    """Per effect: what has the same trace (`equals`) and what the readings cannot tell from it (`rivals`).

    Candidates: every component of every body with the effect's own driver and shape, and every component with any
    column or product of two.  Expected chi-square lost by the candidate, after refitting, < .01 % of the effect's:
    equal; < 9: rival.
    """
    q, table, scale, tool, *labels = measured
    fixed = declared_columns(machine, q, tool, *labels)
    signals = [effect_columns(machine, e, q, table, scale, tool) @ e.coefficient for e in effects]
    everything = COMPONENTS + SQUARENESS
    ways = np.stack([way_of(machine, c, q, tool) for c in everything], axis=2)
    active = [n for n, v in table.items() if np.ptp(v) > 0]
    answers = []
    for i, effect in enumerate(effects):
        rest = [s[:, None] for j, s in enumerate(signals) if j != i]
        off = complement(np.hstack([fixed, *rest]))
        target = off(signals[i])
        strength = float(target @ target)
        equals, rivals = [], []

        def weigh(block, name, driver, shape, off=off, target=target, strength=strength, equals=equals, rivals=rivals):
            size = np.linalg.norm(block)
            block = off(block)
            if np.linalg.norm(block) < 1e-6 * size:
                return
            left = target - block @ np.linalg.lstsq(block, target, rcond=1e-9)[0]
            lost = float(left @ left)
            entry = {"component": name, "driver": driver, "shape": shape}
            if lost < 1e-4 * strength:
                equals.append(entry)
            elif lost / sigma**2 < 9:
                rivals.append(entry)

        shape = "linear" if effect.shape == "reversal" else effect.shape
        own = basis(effect, table, scale)
        for j, name in enumerate(everything):
            weigh((ways[:, :, [j]] * own[:, None, :]).reshape(3 * len(q), -1), name, effect.driver, effect.shape)
        for names in itertools.chain(*(itertools.combinations_with_replacement(active, n) for n in (1, 2))):
            driver = "*".join(sorted(names))
            if (driver, "linear") == (effect.driver, shape):
                continue
            v = np.prod([table[n] for n in names], axis=0)
            block = (ways * v[:, None, None]).reshape(3 * len(q), -1)
            size = np.linalg.norm(block, axis=0)
            block = off(block / np.maximum(size, 1e-300))
            norm = np.linalg.norm(block, axis=0)
            with np.errstate(divide="ignore", invalid="ignore"):
                lost = np.where(norm > 1e-6, strength - (block.T @ target) ** 2 / norm**2, np.inf)
            for j in np.flatnonzero((lost < 1e-4 * strength) | (lost / sigma**2 < 9)):
                entry = {"component": everything[j], "driver": driver, "shape": "linear"}
                (equals if lost[j] < 1e-4 * strength else rivals).append(entry)
        answers.append({"equals": equals, "rivals": rivals})
    return answers
