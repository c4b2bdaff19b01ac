# SPDX-License-Identifier: LGPL-2.1-or-later
"""The remainder after the named effects: whether it has structure, where, and whether a smooth form of it predicts.

Free forms of any two columns test it, a surface locates and sizes it.  A located remainder is modelled, without a name,
if it predicts blocks left out.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..core.driver import TIME
from ..core.errors import component
from . import evidence
from .acceptance import beat, judge
from .design import ALL_SYMBOLS
from .freeform import FreeScan
from .noise import duration, slow_drift
from .problem import State, Step
from .search import ScoredTerm, scored, surface_candidate
from .surface import Surface, locate, separable, sharpen
from .unlogged import Unlogged, uneven_noise, unlogged_driver


@dataclass(frozen=True)
class Remainder:
    """What free forms still find: p, size (rms over noise), the strongest surface, its held-out gain (total, SE)."""

    p: float = 1.0
    size: float = 0.0
    structure: Surface | None = None
    gain: tuple[float, float] = (0.0, 0.0)


@dataclass(frozen=True)
class Rest:
    """All that is left beside the named effects.

    first : the test for structure.  smooth : forms that predict.  structured : it is above the floor.  hidden : a
    motion that nobody logged, or None.  drift : over how many readings what is left is alike, where that is no noise.
    dropped : what is beyond chance and above the floor, and was not accepted.
    """

    first: Remainder
    smooth: tuple[ScoredTerm, ...] = ()
    structured: bool = False
    hidden: Unlogged | None = None
    drift: int | None = None
    dropped: tuple[Step, ...] = ()


def _places(state: State) -> list[int]:
    """Components (indices) that a free form is tried on: one of each group that moves alike."""
    return [c for c in state.problem.component_indices if component(ALL_SYMBOLS[c]).kind != "squareness"]


def remainder(state: State, model) -> Remainder:
    """Return what is left after `model`: tests for structure and smooth forms of it."""
    s, p = state.settings, state.problem
    fitted = state.fit_with(model)
    rows = state.scanned(state.rows(fitted))
    places = _places(state)
    found, null = FreeScan(rows, p.scan_readings, p.names, places).best(state.signs)
    if not found:
        return Remainder()
    chance, score = found[0].p, found[0].score
    shifts = [c for c in places if not component(ALL_SYMBOLS[c]).angular]
    leading = list(dict.fromkeys([*shifts, *[f.component for f in found[:10]]]))[: s.located_components]
    best = locate(
        rows, p.scan_readings, p.names, leading if chance < s.suspicion or score > s.suspicion_score else shifts
    )
    if not best or best[0].evidence < s.detectable:
        return Remainder(chance, found[0].size(rows.used), None)
    top = best[0]
    if chance >= s.alpha:  # sign flips of a strong structure hide it: take it out of the null first
        clean = state.scanned(state.rows(state.fit_with([*model, surface_candidate(top)])))
        _, null = FreeScan(clean, p.scan_readings, p.names, places).best(state.signs)
        chance = min(chance, evidence.p_value(score, null))
        if top.evidence > s.certain:
            chance = min(chance, 1.0 / (len(null) + 1))
    size = float(np.sqrt(max(top.gain - top.freedom, 0.0) / rows.used))
    grams, base, mine = state.grams(fitted, model, [surface_candidate(top)])
    held = evidence.gain_statistics(grams.held_out(base), grams.held_out(base + mine[0]))
    return Remainder(chance, size, top, held)


def rest(state: State) -> Rest:
    """What the named effects leave: the test, smooth forms worth predicting with, and whether it is above the floor."""
    s = state.settings
    model = [step.candidate for step in state.named]
    beats = tuple(b.candidate for b in (beat(state, model, c) for c in model if c.shape.wave) if b is not None)
    model += beats
    first = remainder(state, model)
    dropped = _still_there(state, model)
    refused = [x for x in state.steps if x.refused is not None and state.significant(x) and x.size > s.floor]
    structured = (first.p < s.alpha and first.size > s.floor) or bool(refused) or bool(dropped) or bool(beats)
    if state.drifts:
        lasts = round(duration(max(state.memory.values())))
        drift = slow_drift(state.fit_with(model), state.problem.readings, s)
        forms = _modelled(state, model, replace(state, memory={}))
        lasting = (c for c in forms if _lasts(state, [*model, *forms], c))
        return Rest(first, (*beats, *lasting), True, None, drift or lasts, dropped)
    drift = slow_drift(state.fit_with(model), state.problem.readings, s)
    smooth: tuple[ScoredTerm, ...] = ()
    if structured or drift is not None:
        quiet, first = _relocated(state, model, first) if structured else (replace(state, memory={}), first)
        smooth = _modelled(state, model, quiet, first if structured else None)
    if structured:
        drift = slow_drift(state.fit_with([*model, *smooth]), state.problem.readings, s)
    hidden = None if structured else _unlogged(state, model)
    return Rest(first, (*beats, *smooth), structured or drift is not None, hidden, drift, dropped)


def _lasts(state: State, model, form: ScoredTerm) -> bool:
    """Does a form say something of later readings: is it of no time, or a warm-up that has settled at the end?

    A form of time follows a drift between the readings; beyond them it is held at its last value, which says nothing
    where the drift goes on.
    """
    columns = state.problem.readings.columns
    if TIME not in form.driver.columns:
        return True
    rows = state.rows_with(state.fit_with(model), [c for c in model if c is not form])
    motion = form.vectors(columns) @ scored(rows, form.symbol, form.regressor, columns).coefficients
    late = columns[TIME] >= columns[TIME].max() - state.settings.settled_last * np.ptp(columns[TIME])
    return float(np.ptp(motion[late])) <= state.settings.settled_range * float(np.ptp(motion))


def _modelled(state: State, model, quiet: State, first: Remainder | None = None) -> tuple[ScoredTerm, ...]:
    """Forms of what is left that predict readings left out, without a name; `first` : the first of them, if located.

    Structure that is in no model looks like memory of the noise, and whitening by it blurs the structure.  So forms are
    looked for under the memory of the state `quiet`, and as if nothing remembered.  Where noise remembers, short blocks
    left out are told by their neighbours: as many of the forms are taken as predict the blocks of the trace best,
    counted in plain errors, or none.
    """
    bare = replace(state, memory={})
    sets = [_forms(quiet, model, first)]
    if any(quiet.memory.values()):
        sets.append(_forms(bare, model))
    full = bare.fit_with([*model, *sets[-1]])
    best, least = (), np.inf
    for terms in sets:
        grams, base, mine = bare.grams(full, model, terms, block=state.row_block)
        least = min(least, float(grams.held_out(base).sum()))
        for k in range(len(terms)):
            error = float(grams.held_out(base + sum(mine[: k + 1], [])).sum())
            if error < least:
                best, least = terms[: k + 1], error
    return best


def _forms(state: State, model, found: Remainder | None = None) -> tuple[ScoredTerm, ...]:
    """Smooth forms beside `model`, one after another, that predict blocks left out; `found` : the first of them."""
    s = state.settings
    smooth: list[ScoredTerm] = []
    found = remainder(state, model) if found is None else found
    for _ in range(s.smooth_most):
        if found.structure is None or found.p >= s.alpha or found.size <= s.smooth_floor * s.floor:
            break
        best = _smooth(state, [*model, *smooth], found)
        if best is None:
            break
        smooth.append(best)
        found = remainder(state, [*model, *smooth])
    return tuple(smooth)


def _relocated(state: State, model, first: Remainder) -> tuple[State, Remainder]:
    """The state and the test with the memory that the noise has beside the structure, where that is less.

    Structure that is not in the model looks like memory, and whitening by it blurs the columns that it depends on.  So
    it is located as if nothing remembered; if the noise remembers less beside what is found, that story is the simpler
    one.  The decision that there is structure stays with the test that knows the larger memory.
    """
    if first.structure is None or not any(state.memory.values()):
        return state, first
    bare = replace(state, memory={})
    located = remainder(bare, model).structure
    if located is None:
        return state, first
    quiet = bare.heard(bare.fit_with([*model, surface_candidate(located)]))
    if all(quiet.memory.get(k, 0.0) >= v for k, v in state.memory.items()):
        return state, first
    again = remainder(quiet, model)
    if again.structure is None or again.p >= state.settings.alpha:
        return state, first
    return quiet, replace(again, p=max(again.p, first.p))


def _still_there(state: State, model) -> tuple[Step, ...]:
    """Of what was dropped on the way, that which is beyond chance and above the floor beside the final names."""
    known = {c.driver for c in model} | {step.candidate.driver for step in state.steps}
    out = []
    for step in state.dropped:
        if step.candidate.driver not in known:
            again = judge(state, model, step.candidate)
            if again.p < state.settings.alpha and again.clear and again.size > state.settings.floor:
                out.append(replace(again, refused=step.refused))
    return tuple(out)


def _smooth(state: State, model, rest: Remainder) -> ScoredTerm | None:
    """The located surface, if it predicts left-out blocks at all; sharpened once the noise beside it is known.

    Of the surface as located, sharpened, and as a product of two profiles, that which predicts left-out blocks best.
    """
    found, p = rest.structure, state.problem
    columns = p.scan_readings.columns
    for k in range(2):
        full = state.fit_with([*model, surface_candidate(found)])
        rows = state.scanned(state.rows_with(full, model))
        if k == 0:  # with the noise known, columns that are nearly alike can be told apart
            found = next(iter(locate(rows, p.scan_readings, p.names, _places(state))), found)
        found = sharpen(rows, columns, found)
    forms = [rest.structure, found]
    forms += [s for s in (separable(rows, columns, found),) if s is not None]
    terms = [surface_candidate(s) for s in forms]
    full = state.fit_with(model)
    grams, base, mine = state.grams(full, model, terms)
    without = grams.held_out(base)
    gains = [evidence.gain_statistics(without, grams.held_out(base + m)) for m in mine]
    best = max(range(len(terms)), key=lambda i: gains[i][0])
    return terms[best] if gains[best][0] > gains[best][1] else None


def _unlogged(state: State, model) -> Unlogged | None:
    """A body that moves from reading to reading, by a driver that nobody logged."""
    p, s = state.problem, state.settings
    rows, some = state.scanned(state.rows(state.fit_with(model))), p.scan_readings
    for found in (
        unlogged_driver(rows, s, seed=p.seed),
        uneven_noise(rows, some.q, some.kind, s, seed=p.seed),
    ):
        if found is not None and found.p < s.alpha and found.size > s.floor:
            return found
    return None
