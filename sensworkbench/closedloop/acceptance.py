# SPDX-License-Identifier: LGPL-2.1-or-later
"""Evidence for one effect in a model: family-wise p, size, gain on blocks left out, half-samples, and its name.

An effect is accepted on a family-wise p over everything scanned, a size above the floor and a gain on whole blocks left
out; it keeps its name only if half-samples select it again and no free form of its own columns fits better.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..core.driver import TIME
from ..core.units import um
from ..messages import Message
from . import evidence
from .bank import log_tail
from .exchange import between_runs
from .fit import Fit
from .freeform import normal_tail
from .naming import beyond, stand_in, stands_out
from .noise import slow_drift
from .problem import State, Step
from .scan import free_of_scale
from .search import ScoredTerm, refine, same_place, scored, search


def judge(state: State, others, best: ScoredTerm) -> Step:
    """Family-wise p, size and held-out gain of `best` beside `others`."""
    columns = state.problem.readings.columns
    full = state.fit_with([*others, best])
    found = scored(state.rows_with(full, others), best.symbol, best.regressor, columns)
    gain, coefficients = found.gain, found.coefficients
    null = state.scanner(state.rows(full)).null_maxima(state.signs)
    tail = tail_of(full, gain, len(coefficients))
    tail = min(tail, _on_the_grid(state, full, others, found))
    used = max(int(np.count_nonzero(full.weight)), 1)
    grams, base, mine = state.grams(full, others, [best], within=True)
    held = _held_out(grams, base, base + mine[0])
    p, runs = evidence.p_value(tail, null), None
    doubtful = p <= state.settings.doubtful and tail < state.settings.doubtless * float(null.max())
    if doubtful or full.dof < state.settings.crowded * full.basis.rank:
        p = max(p, _p_without(state, others, found))
    if p < state.settings.alpha:
        runs = between_runs(state, others, found)
        p = p if runs is None else max(p, runs[0])
    if state.drifts:
        p = max(p, _beside_a_drift(state, others, full, found))
    clear = tail > state.settings.unlogged_margin * float(null.max())
    return Step(found, p, float(np.sqrt(gain / used)), held, runs=None if runs is None else runs[1:], clear=clear)


def _held_out(grams, base, with_it) -> tuple[float, float]:
    """(total gain on blocks left out, its standard error).

    Errors of blocks left out are judged as they are, and with a shift of each block taken out: far ends of a polynomial
    of the declared model shift whole blocks, whatever the effect.  Where most of the error is what the other blocks
    cannot tell of a block at all, its tilt and such far ends, it is judged without that, too.  The clearest counts.
    """
    plain, told = grams.held_out(base), grams.held_out_told(base, base)
    gains = [
        evidence.gain_statistics(plain, grams.held_out(with_it)),
        evidence.gain_statistics(grams.held_out_within(base), grams.held_out_within(with_it)),
    ]
    if float(plain.sum()) > 2 * float(told.sum()):
        gains.append(evidence.gain_statistics(told, grams.held_out_told(with_it, base)))
    return max(gains, key=lambda g: g[0] / max(g[1], 1e-300))


def _p_without(state: State, others, best: ScoredTerm) -> float:
    """Family-wise p where data and null have the noise, weights and outliers of the fit without `best`.

    Weights and outliers of a fit that holds the best of thousands of candidates look better for it than they are: what
    disagrees with it counts less.  With few readings to a parameter it takes much of the noise along, too.
    """
    without = state.fit_with(others)
    rows = state.rows(without)
    gain = scored(rows, best.symbol, best.regressor, state.problem.readings.columns).gain
    left = max(float(rows.residual @ rows.residual) - gain, 1e-300)
    dims = len(best.coefficients)
    gain = float(free_of_scale(gain, left, without.dof - dims, dims))
    tail = float(log_tail(np.array(gain), 1)) if dims == 1 else normal_tail(gain, dims)
    return evidence.p_value(tail, state.scanner(rows).null_maxima(state.signs))


def tail_of(full: Fit, gain: float, dims: int) -> float:
    """-log10 of the tail of a gain in the noise that readings without it would show; `full` : the fit with it."""
    gain = float(free_of_scale(gain, full.chi2, full.dof, dims))
    return float(log_tail(np.array(gain), 1)) if dims == 1 else normal_tail(gain, dims)


def _beside_a_drift(state: State, others, full: Fit, best: ScoredTerm) -> float:
    """Family-wise p of `best` beside a drift that no fit whitens; `full` : the fit with it.  The smaller of two.

    Two things that drift go together by chance (Granger and Newbold 1974).  Either the effect shows from reading to
    reading, where the drift is all but differenced; or its gain is beyond chance when divided by the number of readings
    that count as one, at the upper limit of the correlation that `full` leaves.
    """
    if beside_drift(state, best):
        return 1.0
    longest = {k: state.settings.differenced if state.modelled[k] != phi else phi for k, phi in state.memory.items()}
    by_steps = judge(replace(state, whitened=True, memory=longest), others, best).p
    if best.shape.sudden or by_steps < state.settings.alpha:
        return by_steps
    gain, dims = best.gain / state.inflation(full, best), len(best.coefficients)
    tail = normal_tail(gain, dims) if dims > 1 else float(log_tail(np.array(gain), 1))
    return min(by_steps, len(state.problem.bank) * len(state.problem.groups) * 10.0**-tail)


def beside_drift(state: State, c: ScoredTerm) -> bool:
    """Is it a function of time, no jump, beside a drift?  A drift is one too, so that nothing proves another.

    A lag that is longer than the record is the integral of its column over time.
    """
    time = state.problem.readings.columns.get(TIME)
    endless = time is not None and c.shape.values.get("tau", 0.0) > float(np.ptp(time))
    return state.drifts and (endless or (TIME in c.driver.columns and not c.shape.sudden))


def _on_the_grid(state: State, full: Fit, others, best: ScoredTerm) -> float:
    """The largest score that the scan gives this driver and shape; infinite where it does not stand in the bank.

    Data and null take the same road: the null is the largest score on the grid, so the parameters of what is judged are
    not refined for its p either.
    """
    if not best.shape.fitted:
        return np.inf
    members = [k for k, r in enumerate(state.problem.bank) if r.key == best.regressor.key]
    place = next((i for i, g in enumerate(state.problem.groups) if best.index in g), None)
    if not members or place is None:
        return np.inf
    scores = state.scanner(state.rows_with(full, others)).scores()
    at = max(members, key=lambda k: scores.tail[k, place])
    return tail_of(full, float(scores.gain[at, place]), state.problem.bank[at].size)


def selection(state: State, others, best: ScoredTerm, pool) -> float:
    """Return the share of half-samples of blocks that select `best`, or a candidate that all readings together hardly
    distinguish from it.

    This tests whether half of the readings give the same explanation, not whether they distinguish rivals.
    """
    s = state.settings
    full = state.fit_with([*others, best])
    pool = [best] + [c for c in pool if c.key != best.key][: s.pool]
    grams, base, mine = state.grams(full, others, pool)
    cost = np.array([c.handicap for c in pool])
    everything = grams.gains(base, mine, np.arange(grams.count))
    alike = (everything - cost > everything[0] - cost[0] - s.class_range) | (everything > everything[0] - s.rival)
    rng = np.random.default_rng(state.problem.seed + 1)
    hits = 0
    for _ in range(s.halves):
        use = rng.permutation(grams.count)[: grams.count // 2]
        if state.drifts:  # chi-square counts readings that are alike as independent: it must predict the other half
            hits += grams.half_gain(base, mine[0], use) > 0
            continue
        score = grams.gains(base, mine, use) - cost
        hits += bool(score[0] > 0 and (alike[int(np.argmax(score))] or score[0] > score.max() - s.rival))
    return hits / s.halves


def is_line(state: State, others, candidate: ScoredTerm) -> bool:
    """Return whether a period exceeds the other waves, with no free form of waves fitting better, as the lead of a
    screw does.
    """
    full = state.fit_with([*others, candidate])
    rows, p = state.rows(full), state.problem
    scanner = state.scanner(rows)
    if not stands_out(state.scanned(rows), candidate, scanner, p.readings.columns, state.settings) and _waves_left(
        state, scanner
    ):
        return False
    used = int(np.count_nonzero(full.weight))
    return beyond(rows, candidate, p.readings.columns, p.names, used, settings=state.settings) is None


def _waves_left(state: State, scanner) -> bool:
    """Are there more waves beside the model than noise makes?  Then it is roughness; else a weak line stands alone."""
    waves = np.flatnonzero([r.shape.wave for r in scanner.shapes])
    strongest = float(scanner.scores().tail[waves].max())
    return evidence.p_value(strongest, scanner.null_maxima(state.signs)) < state.settings.waves_left


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


def proved(state: State) -> State:
    """Refuse names that rest on nothing but slow changes, where something slow that nobody logged is left.

    What wanders goes together with any other slow thing by chance (Granger and Newbold 1974), however well noise of
    short memory is whitened.  Beside it an effect must show from reading to reading.
    """
    named = [s.candidate for s in state.named]
    if state.drifts or not named:
        return state
    p, s = state.problem, state.settings
    if slow_drift(state.fit_with(named), p.readings, s, s.memory_least, s.wander_score) is None:
        return state
    by_steps = replace(state, whitened=True, memory=dict.fromkeys(np.unique(p.readings.kind).tolist(), s.differenced))
    steps = list(state.steps)
    for i, step in enumerate(steps):
        others = [c for c in named if c is not step.candidate]
        if step.refused is None and judge(by_steps, others, step.candidate).p >= s.alpha:
            steps[i] = replace(step, refused=Message("refused-wandering"))
    return replace(state, steps=tuple(steps))


def line_beside(state: State, forms) -> State:
    """The state with a period named beside smooth `forms` of what is left, or as it was.

    Long waves, where an axis is declared with too low a degree, hide a screw, look like roughness, and like memory of
    the noise.  Beside a form of them a line is judged as any other effect is.
    """
    p, s = state.problem, state.settings
    others = [*(step.candidate for step in state.named), *forms]
    quiet = state.heard(state.fit_with(others))
    rows = quiet.rows(quiet.fit_with(others))
    found = search(rows, p.readings, quiet.scanner(rows), p.names, p.groups)
    if not found or not found[0].shape.wave or len(state.named) >= s.most_effects:
        return state
    step = judge(quiet, others, found[0])
    if not quiet.passes(step) or not is_line(quiet, others, step.candidate):
        return state
    step = replace(step, pool=tuple(found), selection=selection(quiet, others, step.candidate, found))
    if _refusal(quiet, step, others, quiet.fit_with([*others, step.candidate]), forms) is not None:
        return state
    return replace(quiet, steps=(*state.steps, step))


def beat(state: State, others, wave: ScoredTerm) -> Step | None:
    """What the height and phase of a named `wave` change along its travel, as a second wave that the travel cannot tell
    from it; None where that is no more than chance, or below the floor.
    """
    p = state.problem
    rows = state.rows(state.fit_with(others))
    span = float(np.ptp(wave.driver.values(p.readings.columns)))
    near = [r for r in p.bank if r.driver == wave.driver and r.shape.wave and not r.shape.resolved(wave.shape, span)]
    terms = [scored(rows, wave.symbol, r, p.readings.columns) for r in near if r != wave.regressor]
    if not terms:
        return None
    best = refine(rows, max(terms, key=lambda c: c.gain), p.readings.columns)
    step = judge(state, others, best)
    return step if state.passes(step) else None


def _refusal(state: State, step: Step, others, full: Fit, forms=()) -> Message | None:
    c, p, s = step.candidate, state.problem, state.settings
    if not state.passes(step):
        return Message("refused-beside-others")
    if step.selection < s.selection:
        return Message("refused-selection", share=step.selection)
    rows = state.rows_with(full, [*(o for o in others if o in forms or not same_place(o, c)), c])
    used = int(np.count_nonzero(full.weight))
    table = p.readings.columns
    reason = stand_in(c, others, table, p.names, s) or beyond(
        rows, c, table, p.names, used, settings=s, inflation=state.inflation(full, c)
    )
    size = um(p.amplitude(c))
    if reason is None and size > s.largest_um:
        return Message("refused-size", size=size)
    return reason
