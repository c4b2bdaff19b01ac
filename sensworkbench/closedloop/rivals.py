# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rivals: explanations that the readings cannot distinguish from an effect, and the least expensive measurement that
would.

A rival has a held-out error within two standard errors of the effect's, or loses less than 9 in chi-square after
refitting.  A more general shape of the same motion and columns always does, and is not listed as a rival.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..core.driver import DIRECTIONS, POSITIONS
from ..core.errors import component
from ..core.synthesis import omega
from ..messages import Message
from . import evidence
from .design import ALL_SYMBOLS, declared_columns
from .problem import State, Step
from .result import NextMeasurement, Rival
from .scan import exact_gain
from .search import ScoredTerm, handicap
from .tolerances import plausible

SAME_TRACE = 1 - 1e-9  # cosine of two columns, projected


def _alike(a: str, b: str) -> bool:
    ca, cb = component(a), component(b)
    return a == b or (not ca.angular and not cb.angular and ca.axis == cb.axis)


def _place(c: ScoredTerm) -> tuple[str, str]:
    return c.symbol, str(c.driver)


def more_general(rival: ScoredTerm, finding: ScoredTerm) -> bool:
    """The same motion and columns through a shape with more freedom - but a warm-up is no padding of a trend."""
    if not _alike(rival.symbol, finding.symbol) or rival.shape.warm_up:
        return False
    freedom = lambda c: len(c.shape.fitted) + len(c.coefficients)  # noqa: E731
    return rival.driver.names == finding.driver.names and freedom(rival) > freedom(finding)


def rivals(state: State, step: Step, others) -> list[tuple[Rival, ScoredTerm]]:
    """Return the rivals of one effect in the model of the others, the physically most plausible first.

    The handicap of a rival's term holds what the machine's tolerances say against it (see `tolerances`).
    """
    finding, settings, problem = step.candidate, state.settings, state.problem
    full = state.fit_with([*others, finding])
    rows = state.rows_with(full, others)
    columns = problem.readings.columns
    alike = state.inflation(full, finding, margin=0.0)  # beside a drift so many readings count as one
    pool: list[tuple[ScoredTerm, float]] = []
    for c in step.pool:
        if c.key == finding.key:
            continue
        gain, coefficients, visible = exact_gain(rows, c.index, c.vectors(columns))
        loss = (finding.gain - gain) / alike
        c = replace(c, gain=gain, coefficients=coefficients, visible=visible)
        if loss < settings.rival_range and not more_general(c, finding):
            pool.append((c, loss))
    group = next((g for g in problem.groups if finding.index in g), [])
    for i in group:  # bodies that move alike: nothing at the tool tells them apart
        if i != finding.index:
            symbol = ALL_SYMBOLS[i]
            mirror = replace(finding, symbol=symbol, handicap=handicap(symbol, finding.regressor))
            if all(c.key != mirror.key for c, _ in pool):
                pool.append((mirror, 0.0))
    if not pool:
        return []
    seen = plausible(state, full, others, finding, [c for c, _ in pool])
    against = dict(zip((c.key for c, _ in pool), np.maximum(seen.cost[1:] - seen.cost[0], 0.0).tolist()))
    number = {c.key: k for k, (c, _) in enumerate(pool, start=1)}
    pool = [(replace(c, handicap=c.handicap + against[c.key]), loss) for c, loss in pool]
    grams, base, mine = state.grams(full, others, [finding] + [c for c, _ in pool])
    reference = grams.held_out(base + mine[0])
    found: list[tuple[Rival, ScoredTerm]] = []
    shown: list[tuple[ScoredTerm, np.ndarray]] = []
    own = _trace_of(finding, rows, columns)

    def put(c: ScoredTerm, loss: float, why: Message, same: bool):
        if against[c.key] > settings.tolerance_margin:
            why = seen.far(number[c.key], why)
        found.append((Rival(c.symbol, str(c.driver), c.shape.name, float(loss), why, same), c))

    for (c, loss), place in sorted(zip(pool, mine[1:]), key=lambda item: (item[0][0].handicap, item[0][1])):
        trace = _trace_of(c, rows, columns)
        if _cosine(own, trace) > SAME_TRACE:
            put(c, 0.0, Message("rival-same-trace"), True)
            continue
        if any(_cosine(trace, t) > SAME_TRACE or _place(c) == _place(s) for s, t in shown):
            continue  # one name for each trace, one shape for each component and driver
        if loss < settings.rival:
            why = Message("rival-as-much", loss=max(loss, 0.0))
        else:
            gain, error = evidence.gain_statistics(grams.held_out(base + place), reference)
            if gain > settings.rival_errors * error:
                continue
            why = Message("rival-predicts", gain=gain, error=error)
        shown.append((c, trace))
        put(c, loss, why, False)
    return sorted(found, key=lambda r: (not r[0].same, r[1].handicap))


def _trace_of(c: ScoredTerm, rows, columns) -> np.ndarray:
    """(R,) whitened, projected contribution of a candidate."""
    x = rows.white(rows.lever[:, c.index] * (c.vectors(columns) @ c.coefficients)[rows.point])
    return x - rows.ortho @ (rows.ortho.T @ x)


def _cosine(a, b) -> float:
    size = float(np.linalg.norm(a) * np.linalg.norm(b))
    return float(a @ b) / size if size > 0 else 0.0


# -- what would tell them apart ----------------------------------------------------------------------------------------
def _conditions(state: State, a: ScoredTerm, b: ScoredTerm):
    """Feasible measurements, cheapest first: (message, q, columns, tool offset)."""
    problem = state.problem
    readings = problem.readings
    q, columns = readings.q, dict(readings.columns)
    tool = np.zeros(3) if readings.tool_offset is None else readings.tool_offset
    rng = np.random.default_rng(problem.seed)
    drivers = set(a.regressor.columns) | set(b.regressor.columns)
    used = [n for n in problem.names if n in drivers]
    turned = [n for n in DIRECTIONS if n in columns]
    if turned:
        yield Message("do-reverse"), q, columns | {n: -columns[n] for n in turned}, tool
    order = rng.permutation(len(q))
    moved = {n: (columns[n][order] if n in POSITIONS else columns[n]) for n in columns}
    yield Message("do-random-order"), q[order], moved, tool
    low, high = problem.machine.travel.T
    fresh = low + (high - low) * rng.random(q.shape)
    placed = columns | {n.lower(): fresh[:, i] for i, n in enumerate(problem.machine.names)}
    yield Message("do-scattered"), fresh, placed, tool
    for name in used:
        if name.startswith("load_"):
            shift = max(float(np.ptp(columns[name])), 100.0)
            yield Message("do-load", mass=shift, on=name[5:]), q, columns | {name: columns[name] + shift}, tool
        elif name in ("feed", "spindle"):
            yield Message("do-twice", column=name), q, columns | {name: 2 * columns[name]}, tool
    for name in used:
        if name.startswith("temp_"):
            yield Message("do-warm", what=name[5:], kelvin=3), q, columns | {name: columns[name] + 3.0}, tool
    if "t" in used:
        yield Message("do-later"), q, columns | {"t": columns["t"] + float(np.ptp(columns["t"]))}, tool
    yield Message("do-longer-tool", mm=150), q, columns, tool - np.array([0.0, 0.0, 150.0])
    yield Message("do-probe-aside", mm=100, axis="x"), q, columns, tool + np.array([100.0, 0.0, 0.0])
    yield Message("do-probe-aside", mm=100, axis="y"), q, columns, tool + np.array([0.0, 100.0, 0.0])


def _prediction(state: State, fitted, candidates, q, columns, tool) -> np.ndarray:
    """(P, 3) mm predicted by a fit with its candidates, alignment included, run and tool offsets left out."""
    machine = state.problem.machine
    terms = [t for t in fitted.design.terms if t.group in ("declared", "alignment")]
    keep = [i for i, t in enumerate(fitted.design.terms) if t.group in ("declared", "alignment")]
    values = declared_columns(machine, [t if t.group == "declared" else replace(t, order=0) for t in terms], q)
    symbols = [t.symbol for t in terms]
    out = np.einsum("pan,pn->pa", omega(machine, symbols, q, tool), values * fitted.coefficients[keep])
    at = len(fitted.design.terms)
    for c in candidates:
        v = c.vectors(columns)
        motion = v @ fitted.coefficients[at : at + v.shape[1]]
        at += v.shape[1]
        out += omega(machine, [c.symbol], q, tool)[:, :, 0] * motion[:, None]
    return out


def _seen(readings, vectors) -> np.ndarray:
    """(P,) size of vectors (P, 3) along the directions in which each point was read."""
    along = np.einsum("ra,ra->r", vectors[readings.point], readings.sense)
    return np.sqrt(np.bincount(readings.point, weights=along**2, minlength=readings.points))


def separating_measurement(state: State, finding: ScoredTerm, rival: ScoredTerm, others) -> NextMeasurement:
    """The cheapest further measurement that would separate a finding from a rival, sensed as the readings were."""
    problem, s = state.problem, state.settings
    a, b = state.fit_with([*others, finding]), state.fit_with([*others, rival])
    sigma = float(np.mean(list(a.noise.values())))
    best: tuple[Message | None, float] = (None, 0.0)
    for do, q, columns, tool in _conditions(state, finding, rival):
        difference = _prediction(state, a, [*others, finding], q, columns, tool)
        difference = difference - _prediction(state, b, [*others, rival], q, columns, tool)
        difference -= difference.mean(axis=0)  # a new set-up is aligned again
        size = float(_seen(problem.readings, difference).max())
        if size > s.next_better * best[1]:
            best = (do, size)
        if size > s.next_clear * sigma:
            best = (do, size)
            break
    do, size = best
    if do is None or size < s.next_least * sigma:
        bodies = sorted({component(finding.symbol).body, component(rival.symbol).body})
        do = Message("do-watch-bodies", bodies=bodies) if len(bodies) > 1 else Message("do-change-one")
        size = problem.amplitude(finding)
    return NextMeasurement((driven_by(finding), driven_by(rival)), do, size)


def driven_by(c: ScoredTerm) -> Message:
    """`EZX by x*z` of a term, with its shape where that is not in proportion."""
    if c.shape.proportional:
        return Message("driven-by", component=c.symbol, driver=str(c.driver))
    return Message("driven-by-shaped", component=c.symbol, driver=str(c.driver), shape=c.shape.words)


def aliases(state: State, finding: ScoredTerm, others) -> list[float]:
    """Return periods (mm) that the readings cannot distinguish from that of a periodic effect: they lose less than a
    rival does.
    """
    period, s = finding.shape.period, state.settings
    rows = state.rows_with(state.fit_with([*others, finding]), others)
    columns = state.problem.readings.columns
    values = np.unique(np.round(finding.driver.values(columns), 4))
    span = float(np.ptp(values))
    gaps = np.diff(values)
    trial = [r.shape.period for r in state.problem.bank if r.key == finding.regressor.key]
    if float(np.ptp(gaps)) < s.regular * float(gaps.mean()):  # one regular grid: every fold is an alias
        step = float(gaps.mean())
        trial += [1 / abs(sign / period + n / step) for n in range(1, 6) for sign in (1, -1)]
    frequency = np.array(sorted({1 / p for p in trial if p > s.alias_shortest}))
    fine = [f + d / span for f in frequency for d in (-0.16, 0.0, 0.16)]
    found: list[tuple[float, float]] = []
    for f in fine:
        if f <= 0 or abs(f - 1 / period) < 1.0 / span:
            continue
        gain, _, _ = exact_gain(rows, finding.index, finding.regressor.having(period=1 / f).vectors(columns))
        if finding.gain - gain < s.rival:
            found.append((1 / f, gain))
    best: list[float] = []
    for p, _ in sorted(found, key=lambda item: -item[1]):
        if all(abs(1 / p - 1 / q) > 1.0 / span for q in best):
            best.append(float(p))
    return best[: s.aliases]
