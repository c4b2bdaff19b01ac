# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rivals: what the readings cannot tell from a finding, and the cheapest measurement that would.

A rival has a held-out error within two standard errors of the finding's, or loses less than 9 in chi-square after
refitting.  A more general shape of the same motion and columns always does, and is no rival but a padding.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..core.driver import DIRECTIONS, POSITIONS
from ..core.errors import component
from ..core.synthesis import omega
from . import evidence
from .design import ALL_SYMBOLS, declared_columns
from .scan import exact_gain
from .search import Candidate, handicap
from .tracer import RIVAL, Step, Tracer

HELD_OUT_RANGE = 16.0  # beyond this loss in chi-square block noise alone makes "within two standard errors" vacuous


@dataclass(frozen=True)
class Rival:
    candidate: Candidate
    loss: float  # of chi-square against the finding
    why: str
    same: bool  # the very same column


def _alike(a: str, b: str) -> bool:
    ca, cb = component(a), component(b)
    return a == b or (not ca.angular and not cb.angular and ca.axis == cb.axis)


def _place(c: Candidate) -> tuple[str, str]:
    return c.symbol, str(c.driver)


def _more_general(rival: Candidate, finding: Candidate) -> bool:
    """The same motion and columns through a shape with more freedom - but a warm-up is no padding of a trend."""
    if not _alike(rival.symbol, finding.symbol) or rival.shape.warm_up:
        return False
    freedom = lambda c: len(c.shape.fitted) + len(c.coefficients)  # noqa: E731
    return rival.driver.names == finding.driver.names and freedom(rival) > freedom(finding)


def rivals(tracer: Tracer, step: Step, others) -> list[Rival]:
    """Rivals of one finding beside the other effects, most physical first."""
    finding = step.candidate
    full = tracer.fit_with([*others, finding])
    rows = tracer.rows_with(full, others)
    columns = tracer.readings.columns
    pool: list[tuple[Candidate, float]] = []
    for c in step.pool:
        if c.key == finding.key:
            continue
        gain, coefficients, visible = exact_gain(rows, c.index, c.vectors(columns))
        loss = finding.gain - gain
        c = Candidate(c.symbol, c.regressor, gain, coefficients, visible, c.handicap)
        if loss < HELD_OUT_RANGE and not _more_general(c, finding):
            pool.append((c, loss))
    group = next((g for g in tracer.groups if finding.index in g), [])
    for i in group:  # bodies that move alike: nothing at the tool tells them apart
        if i != finding.index:
            symbol = ALL_SYMBOLS[i]
            mirror = replace(finding, symbol=symbol, handicap=handicap(symbol, finding.regressor))
            if all(c.key != mirror.key for c, _ in pool):
                pool.append((mirror, 0.0))
    if not pool:
        return []
    grams, base, mine = tracer.grams(full, others, [finding] + [c for c, _ in pool])
    reference = grams.held_out(base + mine[0])
    found: list[Rival] = []
    shown: list[tuple[Candidate, np.ndarray]] = []
    own = _trace_of(tracer, finding, rows)
    for (c, loss), place in sorted(zip(pool, mine[1:]), key=lambda item: (item[0][0].handicap, item[0][1])):
        trace = _trace_of(tracer, c, rows)
        if _cosine(own, trace) > 1 - 1e-9:
            found.append(Rival(c, 0.0, "leaves the same trace in these readings", True))
            continue
        if any(_cosine(trace, t) > 1 - 1e-9 or _place(c) == _place(s) for s, t in shown):
            continue  # one name for each trace, one shape for each component and driver
        if loss < RIVAL:
            why = f"explains as much but for {max(loss, 0.0):.1f} in chi-square"
        else:
            gain, error = evidence.gain_statistics(grams.held_out(base + place), reference)
            if gain > 2 * error:
                continue
            why = f"predicts left-out blocks as well (difference {gain:.1f} +- {error:.1f} in chi-square)"
        shown.append((c, trace))
        found.append(Rival(c, float(loss), why, False))
    return sorted(found, key=lambda r: (not r.same, r.candidate.handicap))


def _trace_of(tracer: Tracer, c: Candidate, rows) -> np.ndarray:
    """(R,) weighted, projected contribution of a candidate."""
    counts = np.diff(np.r_[rows.start, len(rows.residual)])
    x = rows.lever[:, c.index] * np.repeat(c.vectors(tracer.readings.columns) @ c.coefficients, counts)
    return x - rows.q @ (rows.q.T @ x)


def _cosine(a, b) -> float:
    size = float(np.linalg.norm(a) * np.linalg.norm(b))
    return float(a @ b) / size if size > 0 else 0.0


# -- what would tell them apart ------------------------------------------------------------------------------------
def _conditions(tracer: Tracer, a: Candidate, b: Candidate):
    """Feasible measurements, cheapest first: (words, q, columns, tool offset)."""
    readings = tracer.readings
    q, columns = readings.q, dict(readings.columns)
    tool = np.zeros(3) if readings.tool_offset is None else readings.tool_offset
    rng = np.random.default_rng(tracer.seed)
    drivers = set(a.regressor.columns) | set(b.regressor.columns)
    used = [n for n in tracer.names if n in drivers]
    turned = [n for n in DIRECTIONS if n in columns]
    if turned:
        yield (
            "repeat the readings with the approach direction reversed",
            q,
            columns | {n: -columns[n] for n in turned},
            tool,
        )
    order = rng.permutation(len(q))
    moved = {n: (columns[n][order] if n in POSITIONS else columns[n]) for n in columns}
    yield "repeat the same places in random order", q[order], moved, tool
    low, high = tracer.machine.travel.T
    fresh = low + (high - low) * rng.random(q.shape)
    placed = columns | {n: fresh[:, i] for i, n in enumerate(POSITIONS)}
    yield "measure at scattered places that stand on no regular grid", fresh, placed, tool
    for name in used:
        if name.startswith("load_"):
            shift = max(float(np.ptp(columns[name])), 100.0)
            yield f"repeat with {shift:.0f} kg more on {name[5:]}", q, columns | {name: columns[name] + shift}, tool
        elif name in ("feed", "spindle"):
            yield f"repeat at twice the {name}", q, columns | {name: 2 * columns[name]}, tool
    for name in used:
        if name.startswith("temp_"):
            words = f"warm {name[5:]} alone by 3 K and repeat"
            yield words, q, columns | {name: columns[name] + 3.0}, tool
    if "t" in used:
        span = float(np.ptp(columns["t"]))
        yield (
            "repeat after as long again, with the temperatures as they were",
            q,
            columns | {"t": columns["t"] + span},
            tool,
        )
    yield "repeat with a tool 150 mm longer", q, columns, tool - np.array([0.0, 0.0, 150.0])
    yield "repeat with the probe 100 mm to the side in x", q, columns, tool + np.array([100.0, 0.0, 0.0])
    yield "repeat with the probe 100 mm to the side in y", q, columns, tool + np.array([0.0, 100.0, 0.0])


def _prediction(tracer: Tracer, fitted, candidates, q, columns, tool) -> np.ndarray:
    """(P, 3) mm predicted by a fit with its candidates, alignment included, run and tool offsets left out."""
    machine = tracer.machine
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


def separating_measurement(tracer: Tracer, finding: Candidate, rival: Rival, others) -> dict:
    """The cheapest further measurement that would separate a finding from a rival: SPEC's `next_measurements` entry."""
    c = rival.candidate
    sigma = float(np.mean(list(tracer.fit_with([*others, finding]).noise.values())))
    a = tracer.fit_with([*others, finding])
    b = tracer.fit_with([*others, c])
    best = ("", 0.0)
    for words, q, columns, tool in _conditions(tracer, finding, c):
        difference = _prediction(tracer, a, [*others, finding], q, columns, tool)
        difference = difference - _prediction(tracer, b, [*others, c], q, columns, tool)
        difference -= difference.mean(axis=0)  # a new set-up is aligned again
        size = float(np.sqrt((difference**2).sum(axis=1)).max())
        if size > 1.5 * best[1]:
            best = (words, size)
        if size > 4 * sigma:
            best = (words, size)
            break
    words, size = best
    if size < 0.5 * sigma:
        bodies = sorted({component(finding.symbol).body, component(c.symbol).body})
        words = (
            f"no reading at the tool separates them: watch the bodies {' and '.join(bodies)} with a displacement "
            "sensor or an autocollimator"
            if len(bodies) > 1
            else "change one of the columns alone: they went together in all readings"
        )
        size = tracer.amplitude_um(finding) * 1e-3
    return {
        "separates": [_words(finding), _words(c)],
        "do": words,
        "predicted_difference_um": size * 1e3,
    }


def _words(c: Candidate) -> str:
    return f"{c.symbol} by {c.driver}" + ("" if c.shape.proportional else f" ({c.shape.name})")


def aliases(tracer: Tracer, finding: Candidate, others) -> list[float]:
    """Periods (mm) that the readings cannot tell from a periodic finding's own: they lose less than 9 in chi-square."""
    period = finding.shape.period
    full = tracer.fit_with([*others, finding])
    rows = tracer.rows_with(full, others)
    columns = tracer.readings.columns
    values = np.unique(np.round(finding.driver.values(columns), 4))
    span = float(np.ptp(values))
    gaps = np.diff(values)
    trial = [r.shape.period for r in tracer.bank if r.key == finding.regressor.key]
    if float(np.ptp(gaps)) < 0.02 * float(gaps.mean()):  # one regular grid: every fold is an alias
        step = float(gaps.mean())
        trial += [1 / abs(sign / period + n / step) for n in range(1, 6) for sign in (1, -1)]
    frequency = np.array(sorted({1 / p for p in trial if p > 0.5}))
    fine = [f + d / span for f in frequency for d in (-0.16, 0.0, 0.16)]
    found: list[tuple[float, float]] = []
    for f in fine:
        if f <= 0 or abs(f - 1 / period) < 1.0 / span:
            continue
        gain, _, _ = exact_gain(rows, finding.index, finding.regressor.having(period=1 / f).vectors(columns))
        if finding.gain - gain < RIVAL:
            found.append((1 / f, gain))
    best: list[float] = []
    for p, _ in sorted(found, key=lambda item: -item[1]):
        if all(abs(1 / p - 1 / q) > 1.0 / span for q in best):
            best.append(float(p))
    return best[:8]
