# SPDX-License-Identifier: LGPL-2.1-or-later
"""Evidence for one effect in a model: family-wise p, size, gain on blocks left out, half-samples, and its name.

An effect is accepted on a family-wise p over everything scanned, a size above the floor and a gain on whole blocks left
out; it keeps its name only if half-samples select it again and no free form of its own columns fits better.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..messages import Message
from . import evidence
from .bank import log_tail
from .fit import Fit
from .freeform import normal_tail
from .naming import beyond, stand_in, stands_out
from .problem import State, Step
from .scan import exact_gain
from .search import ScoredTerm, same_place


def judge(state: State, others, best: ScoredTerm) -> Step:
    """Return family-wise p, size and held-out gain of `best`, added to the model of `others`."""
    columns = state.problem.readings.columns
    full = state.fit_with([*others, best])
    gain, coefficients, visible = exact_gain(state.rows_with(full, others), best.index, best.vectors(columns))
    null = state.scanner(state.rows(full)).null_maxima(state.signs)
    tail = float(log_tail(np.array(gain), 1)) if len(coefficients) == 1 else normal_tail(gain, len(coefficients))
    used = max(int(np.count_nonzero(full.weight)), 1)
    grams, base, mine = state.grams(full, others, [best])
    held = evidence.gain_statistics(grams.held_out(base), grams.held_out(base + mine[0]))
    found = replace(best, gain=gain, coefficients=coefficients, visible=visible)
    return Step(found, evidence.p_value(tail, null), float(np.sqrt(gain / used)), held)


def selection(state: State, others, best: ScoredTerm, pool) -> float:
    """Return the share of half-samples of blocks that select `best`, or a candidate that all readings together hardly
    distinguish from it.

    This tests whether half of the readings give the same explanation, not whether they distinguish rivals.
    """
    s = state.settings
    full = state.fit_with([*others, best])
    pool = [best] + [c for c in pool if c.key != best.key][:40]
    grams, base, mine = state.grams(full, others, pool)
    cost = np.array([c.handicap for c in pool])
    everything = grams.gains(base, mine, np.arange(grams.count))
    alike = (everything - cost > everything[0] - cost[0] - s.class_range) | (everything > everything[0] - s.rival)
    rng = np.random.default_rng(state.problem.seed + 1)
    hits = 0
    for _ in range(s.halves):
        use = rng.permutation(grams.count)[: grams.count // 2]
        score = grams.gains(base, mine, use) - cost
        hits += bool(score[0] > 0 and (alike[int(np.argmax(score))] or score[0] > score.max() - s.rival))
    return hits / s.halves


def is_line(state: State, others, candidate: ScoredTerm) -> bool:
    """Return whether a period exceeds the other waves, with no free form of waves fitting better, as the lead of a
    screw does.
    """
    full = state.fit_with([*others, candidate])
    rows, p = state.rows(full), state.problem
    if not stands_out(state.scanned(rows), candidate, state.scanner(rows), state.settings):
        return False
    used = int(np.count_nonzero(full.weight))
    return beyond(rows, candidate, p.readings.columns, p.names, used, settings=state.settings) is None


def review(state: State) -> State:
    """Evaluate every effect in the model of all the others, and test whether it may be named."""
    state = state.heard(state.fit_with(state.candidates))
    steps = list(state.steps)
    for i, step in enumerate(steps):
        others = [s.candidate for j, s in enumerate(steps) if j != i]
        again = judge(state, others, step.candidate)
        again = replace(again, pool=step.pool, selection=selection(state, others, again.candidate, step.pool))
        beside = [s.candidate for s in (*steps[:i], again, *steps[i + 1 :])]
        steps[i] = replace(again, refused=_refusal(state, again, others, state.fit_with(beside)))
    return replace(state, steps=tuple(steps))


def _refusal(state: State, step: Step, others, full: Fit) -> Message | None:
    c, p, s = step.candidate, state.problem, state.settings
    if not state.passes(step):
        return Message("refused-beside-others")
    if step.selection < s.selection:
        return Message("refused-selection", share=step.selection)
    rows = state.rows_with(full, [*(o for o in others if not same_place(o, c)), c])
    used = int(np.count_nonzero(full.weight))
    table = p.readings.columns
    reason = stand_in(c, others, table, p.names) or beyond(rows, c, table, p.names, used, settings=s)
    size = 1e3 * p.amplitude(c)
    if reason is None and size > s.largest_um:
        return Message("refused-size", size=size)
    return reason
