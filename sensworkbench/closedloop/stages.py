# SPDX-License-Identifier: LGPL-2.1-or-later
"""The stages of a trace: functions from a state to the next one.

Their order is in `trace`; what counts as evidence is in `acceptance`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from ..core.driver import TIME
from ..core.shapes import Linear, Regressor
from ..core.workspace import Cancelled
from ..messages import Message
from . import evidence
from .acceptance import is_line, judge, review
from .design import ALL_SYMBOLS
from .freeform import free_regressor
from .naming import slow_columns
from .prior import handicap
from .problem import State, Step
from .remainder import remainder
from .scan import exact_gain
from .search import ScoredTerm, merged, refine, search, surface_candidate, tried_beside

Tell = Callable[[float, str], bool]


# -- adding effects ----------------------------------------------------------------------------------------------------
def add_effects(state: State, tell: Tell) -> State:
    """Add effects one after another; after each addition all effects are evaluated again."""
    for number in range(len(state.steps), state.settings.most_effects):
        if not tell(0.1 + 0.15 * number, f"scanning for effect {number + 1}"):
            raise Cancelled("cancelled")
        state, step = _next(state)
        if step is None:
            return state
        state = settle(replace(state, steps=(*state.steps, step)))
        together = _merged(state)
        if together is not None:
            state = settle(together)
    return state


def _found(state: State, others) -> list[ScoredTerm]:
    rows, p = state.rows(state.fit_with(others)), state.problem
    return search(rows, p.readings, state.scanner(rows), p.names, p.groups)


def _next(state: State) -> tuple[State, Step | None]:
    """The next effect that passes, or None.

    The memory of the noise is taken from what the leader leaves; where there is any, the search is done again under it.
    """
    others = state.candidates
    found = _found(state, others)
    if found:
        heard = state.heard(state.fit_with([*others, found[0]]))
        if any(heard.memory.values()) or any(state.memory.values()):
            found = _found(heard, others)
            if found:
                heard = heard.heard(heard.fit_with([*others, found[0]]))
        state = heard
    if state.remembers:
        found = _by_left_out_blocks(state, others, found)
    tried: set = set()
    lines = True
    for best in found:
        if (best.shape.wave and not lines) or best.driver in tried:
            continue
        if len(tried) == state.settings.tries:
            return state, None
        step = judge(state, *_together(state, others, best))
        state = state.logged(
            f"{' '.join(best.key)} {best.shape.values}: gain {step.candidate.gain:.1f}, p {step.p:.4f}, "
            f"size {step.size:.2f}, held out {step.gain[0]:.1f} +- {step.gain[1]:.1f}"
        )
        if best.shape.wave and step.p < state.settings.alpha and not is_line(state, others, step.candidate):
            state = replace(state, roughness=(*state.roughness, step.candidate))
            state = _drop(state, step, Message("refused-roughness"))
            lines = False
            continue
        tried.add(best.driver)
        if state.passes(step):
            return state, replace(step, pool=tuple(found))
        if not step.p < state.settings.alpha:
            if state.drifts and not others:  # the strongest may be the drift: it proves nothing, and ends no search
                continue
            return state, None
        if step.size > state.settings.floor:
            state = _drop(state, step, Message("refused-held-out", gain=step.gain[0], error=step.gain[1]))
        else:
            state = _drop(state, step, Message("refused-small", size=step.size))
    return state, None


def _together(state: State, others, best: ScoredTerm) -> tuple[list[ScoredTerm], ScoredTerm]:
    """The others and `best` as they are judged: beside a drift at their best parameters together.

    What is left, and how long it lasts, depends on them there.
    """
    if not state.drifts or not others:
        return others, best
    *beside, last = settle(replace(state, steps=(*state.steps, Step(best)))).candidates
    return beside, last


def _drop(state: State, step: Step, why: Message) -> State:
    """The state with a term that was beyond chance and is not accepted; one entry for each component and driver."""
    same = lambda s: s.candidate.key == step.candidate.key  # noqa: E731
    kept = tuple(s for s in state.dropped if not same(s))
    return replace(state, dropped=(*kept, replace(step, refused=why)))


def _by_left_out_blocks(state: State, others, found) -> list[ScoredTerm]:
    """The candidates ordered by long blocks left out; of those within half a standard error of the best, the simplest.

    Beside a drift: of those that explain all but the same as that, the best by penalised chi-square at the effective
    number of readings.

    Where noise remembers, slow columns and time imitate each other and the noise; a fit to some hours that predicts the
    others does not.
    """
    some = found[: state.settings.pool]
    if len(some) < 2:
        return found
    grams, base, mine = state.grams(state.fit_with(others), others, some)
    errors = [grams.held_out(base + m) for m in mine]
    totals = np.array([e.sum() for e in errors])
    best = int(np.argmin(totals))
    near = [i for i in range(len(some)) if evidence.no_worse(errors[i], errors[best], state.settings.as_good)]
    near.sort(key=lambda i: (some[i].handicap, totals[i]))
    if state.drifts:  # chi-square counts readings that are alike as independent: penalised at the number that are
        first = some[near[0]]
        full = state.fit_with([*others, first])
        rows, alike = state.rows_with(full, others), state.inflation(full, first, margin=0.0)
        gain = np.array([exact_gain(rows, c.index, c.vectors(state.problem.readings.columns))[0] for c in some])
        least = max(state.settings.nearly * gain[near[0]], gain[near[0]] - state.settings.rival * alike)
        close = [i for i in range(len(some)) if gain[i] >= least]
        close.sort(key=lambda i: some[i].handicap - gain[i] / alike)
        near = [*close, *(i for i in near if i not in close)]
    return [some[i] for i in [*near, *(i for i in np.argsort(totals) if i not in near)]]


def settle(state: State) -> State:
    """Look again at each effect with the others in the model; exchange it where another explains more."""
    p, s = state.problem, state.settings
    for _ in range(s.rounds):
        changed = False
        for i, step in enumerate(state.steps):
            others = [s.candidate for j, s in enumerate(state.steps) if j != i]
            rows = state.rows_with(state.fit_with(state.candidates), others)
            if state.remembers:  # chosen by blocks left out; only its parameters settle
                better = refine(rows, step.candidate, p.readings.columns)
                changed |= better.gain > step.candidate.gain + s.settled
                better = replace(step, candidate=better)
                state = replace(state, steps=(*state.steps[:i], better, *state.steps[i + 1 :]))
                continue
            found = search(rows, p.readings, state.scanner(rows), p.names, p.groups)
            if not step.candidate.shape.wave:
                found = [c for c in found if not c.shape.wave or not state.roughness]
            if not found:
                continue
            changed |= found[0].key != step.candidate.key
            better = replace(step, candidate=found[0], pool=tuple(found))
            state = replace(state, steps=(*state.steps[:i], better, *state.steps[i + 1 :]))
        if not changed:
            break
    return state


def _merged(state: State) -> State | None:
    """The state with one effect for two that are parts of one, or None."""
    for i, a in enumerate(state.steps):
        for b in state.steps[i + 1 :]:
            one = merged(a.candidate, b.candidate, state.problem.readings.columns)
            if one is not None:
                steps = [replace(a, candidate=one) if s is a else s for s in state.steps if s is not b]
                return replace(state, steps=tuple(steps))
    return None


def polish(state: State) -> State:
    """Refit the parameters of the named effects together, without the other candidates, as the final model holds
    them.
    """
    for _ in range(state.settings.rounds):
        moved = False
        for i, step in enumerate(state.steps):
            if step.refused is not None:
                continue
            others = [s.candidate for s in state.named if s is not step]
            rows = state.rows_with(state.fit_with([*others, step.candidate]), others)
            better = refine(rows, step.candidate, state.problem.readings.columns)
            moved |= better.gain > step.candidate.gain + state.settings.polished
            state = replace(state, steps=(*state.steps[:i], replace(step, candidate=better), *state.steps[i + 1 :]))
        if not moved:
            break
    return state


# -- second thoughts ---------------------------------------------------------------------------------------------------
def rescue(state: State, tell: Tell) -> State:
    """Where names are in doubt, or one was found after another: try the best pairs and the wider shapes together.

    A refused leader may be a compromise between two effects, or one term of a series.  The state comes back as it was
    unless all that is found then keeps its name.
    """
    s, p = state.settings, state.problem
    doubtful = any(step.refused is not None and state.significant(step) for step in state.steps)
    if not doubtful and len(state.steps) < 2:
        return state
    full = state.fit_with(state.candidates)
    rows = state.rows_with(full, [])
    leaders: list[ScoredTerm] = []
    for c in search(rows, p.readings, state.scanner(rows), p.names, p.groups):
        alike = [o for o in leaders if o.shape.name == c.shape.name]
        if len(alike) < s.leaders and all(o.driver != c.driver for o in alike):
            leaders.append(c)
    own = {c.key for c in state.candidates}
    left = state.rows_with(full, state.candidates).residual
    now = float(rows.residual @ rows.residual - left @ left) - sum(c.handicap for c in state.candidates)
    best: tuple[float, list[ScoredTerm]] = (now + s.certain, [])
    shaped = tried_beside(rows, [ALL_SYMBOLS[c] for c in p.component_indices], p.readings.columns, p.names)
    for c in [*leaders, *shaped]:
        if c.key not in own and c.score > best[0]:
            best = (c.score, [c])
    least = best[0] + s.certain if best[1] else now + (s.certain if len(state.steps) < 2 else s.rival)
    for first in leaders:
        beside = state.rows_with(full, [first])
        found = search(beside, p.readings, state.scanner(beside), p.names, p.groups, keep=s.found_second)
        if found and first.score + found[0].score > least:
            least = first.score + found[0].score
            best = (least, [first, found[0]])
    if not best[1]:
        return state
    tried = settle(replace(state, steps=tuple(Step(c) for c in best[1])))
    tried = review(add_effects(tried, tell))
    return state if any(step.refused is not None for step in tried.steps) else tried


def straightened(state: State, tell: Tell) -> State:
    """Where a curve of a temperature was refused because expansion is proportional: try the proportional part.

    Beside noise that remembers a curve may follow what is not the temperature's.  The state comes back as it was unless
    the proportional part keeps its name; then the search goes on beside it.
    """
    tried = state
    for step in state.steps:
        if getattr(step.refused, "code", None) == "refused-bent":
            c = step.candidate
            line = Regressor(c.driver, Linear())
            proportional = replace(c, regressor=line, handicap=handicap(c.symbol, line))
            tried = replace(tried, steps=tuple(Step(proportional) if s is step else s for s in tried.steps))
    if tried is state:
        return state
    tried = review(tried)
    if any(step.refused is not None for step in tried.steps):
        return state
    more = review(add_effects(tried, tell))
    return tried if any(step.refused is not None for step in more.steps) else more


def consistent(state: State) -> State:
    """Refuse names that fail together with those that are refused already.

    A refused effect is part of something else: the rest is evaluated again with a free form in its place, so that
    further parts of the same cause fail too.
    """
    p = state.problem
    for _ in range(len(state.steps) + 1):
        refused = [s for s in state.steps if s.refused is not None]
        if not refused or not state.named:
            return state
        stand_ins = []
        for s in refused:
            parts = s.candidate.driver.names[:2]
            slow = slow_columns(p.readings.columns, parts, state.settings)
            if slow and TIME in p.names:
                parts = tuple(dict.fromkeys(TIME if n in slow else n for n in parts))
            form = free_regressor(parts, p.readings.columns, state.settings.free_refused)
            stand_ins.append(ScoredTerm(s.candidate.symbol, form, 0.0, np.zeros(0), 1.0, 0.0))
        before = state
        for s in before.named:
            others = [n.candidate for n in before.named if n is not s] + stand_ins
            full = state.fit_with([*others, s.candidate])
            gain, _, _ = _gain(state, full, others, s.candidate)
            if gain < state.settings.piece * s.candidate.gain:
                state = _refuse(state, s, Message("refused-free-form-of-refused"))
        if state is before:
            return state
    return state


def without_pieces(state: State) -> State:
    """Refuse names that are pieces of the structure that is left.

    With the name taken out, a surface of other columns explains what it explained.
    """
    for step in state.named:
        c = step.candidate
        others = [s.candidate for s in state.named if s is not step]
        surface = remainder(state, others).structure
        if surface is None or set(surface.columns) <= set(c.driver.columns):
            continue
        beside = [*others, surface_candidate(surface)]
        full = state.fit_with([*beside, c])
        gain, alone = _gain(state, full, beside, c)[0], _gain(state, full, others, c)[0]
        if gain < state.settings.piece * alone:
            state = _refuse(state, step, Message("refused-piece", columns=list(surface.columns)))
    return state


def _gain(state: State, full, others, c: ScoredTerm):
    return exact_gain(state.rows_with(full, others), c.index, c.vectors(state.problem.readings.columns))


def _refuse(state: State, step: Step, why: Message) -> State:
    same = lambda s: s.candidate is step.candidate  # noqa: E731
    return replace(state, steps=tuple(replace(s, refused=why) if same(s) else s for s in state.steps))
