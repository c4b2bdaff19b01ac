# SPDX-License-Identifier: LGPL-2.1-or-later
"""Trace: from readings to verdict - is anything left, where does it live, what is it, and what would tell.

The words are those of the specification: nothing_to_explain, explained, partly_explained, unexplained.  A name is given
only where the data defend it; everything else is located, sized and left unnamed.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from ..core.driver import TIME
from ..core.machine import Machine
from ..core.refusal import Refused
from ..core.workspace import Cancelled
from .fit import fit
from .freeform import free_regressor
from .naming import slow_columns
from .outcome import Outcome
from .readings import Readings
from .report import TraceReport
from .scan import exact_gain
from .search import Candidate, surface_candidate
from .signs import LEAST, checkable, flipped_directions, likelihood, turned
from .surface import separable, sharpen
from .tracer import ALPHA, FLOOR, Remainder, Step, Tracer
from .unlogged import Unlogged, uneven_noise, unlogged_driver

NOTHING, EXPLAINED, PARTLY, UNEXPLAINED = "nothing_to_explain", "explained", "partly_explained", "unexplained"
FEW = 12  # readings, at least


def trace(
    machine: Machine,
    readings: Readings,
    *,
    seed: int = 0,
    permutations: int = 199,
    floor: float = FLOOR,
    progress: Callable[[float, str], bool] | None = None,
) -> Outcome:
    """Fit the declared model, find what is left, trace it, add it, and judge before and after.

    permutations : sign flips behind each p.  floor : structure below this share of one reading's noise is not named.
    progress : told (fraction, words); a false return cancels.  Refuses when there are too few readings to fit anything.
    """
    tell = progress or (lambda fraction, words: True)
    readings = without_known_effects(machine, readings)
    if readings.rows < FEW:
        raise Refused(f"{readings.rows} readings are too few", "readings", f"Give at least {FEW}.")
    tracer = Tracer(machine, readings, seed=seed, permutations=permutations, floor=floor)
    declared = tracer.fit_with([])
    if declared.dof < 5:
        raise Refused(
            f"{readings.rows} readings cannot determine {declared.basis.rank} parameters and leave anything to test",
            "readings",
            "Measure more places, or declare fewer errors.",
        )
    if not tell(0.05, "declared model fitted"):
        raise Cancelled("cancelled")
    flipped = _settled_signs(tracer, flipped_directions(machine, readings, declared), tell)
    if not flipped:
        tracer.add_effects(tell)
        flipped = _simpler_signs(tracer)
        if flipped:
            tracer.steps = []
        tracer.review()
    named = _consistent(tracer)
    doubtful = any(s.refused and s.significant for s in tracer.steps) and not tracer.coloured
    several = len(tracer.steps) > 1 and not tracer.coloured  # one after another may not be the best together
    if (doubtful or several) and tracer.rescue(tell):
        named = _consistent(tracer)
    tracer.polish(named)
    smooth, remainder, structured = _remainder(tracer, named)
    if structured and named and not tracer.coloured and _pieces(tracer, named):
        named = [s for s in named if not s.refused]
        tracer.polish(named)
        smooth, remainder, structured = _remainder(tracer, named)
    if not tell(0.75, "what is left is tested"):
        raise Cancelled("cancelled")
    hidden = None if structured else _unlogged(tracer, [*[s.candidate for s in named], *smooth])
    verdict = _verdict(tracer, named, structured, hidden)
    return TraceReport(tracer, declared, named, smooth, remainder, structured, hidden, verdict, flipped).outcome(tell)


def _settled_signs(tracer: Tracer, suspected: list[int], tell) -> list[int]:
    """The suspected direction, if turning its sign explains the readings with less than effects alone do.

    A turned sign looks like effects and a strong effect like a turned sign: both stories are told to their end.
    """
    for kind in suspected:
        scores = []
        for readings in (tracer.readings, turned(tracer.readings, kind)):
            t = Tracer(tracer.machine, readings, seed=tracer.seed, permutations=tracer.permutations, floor=tracer.floor)
            t.add_effects(tell)
            scores.append(likelihood(readings, t.fit_with(t.candidates)) - LEAST * len(t.steps))
        if scores[1] > scores[0] + LEAST:
            return [kind]
    return []


def _simpler_signs(tracer: Tracer) -> list[int]:
    """The direction that, read with its sign turned, makes some of the effects needless.  Too weak to be seen beside an
    effect at first, a turned sign is otherwise traced as effects of its own."""
    found = tracer.candidates
    score = likelihood(tracer.readings, tracer.fit_with(found)) - LEAST * len(found)
    best, flipped = score + LEAST / 2, []
    for kind in checkable(tracer.readings) if found else []:
        readings = turned(tracer.readings, kind)

        def with_(effects, readings=readings):
            return likelihood(readings, fit(tracer.design, readings, tracer.columns_of(effects)))

        kept, value = list(found), with_(found)
        while kept and value > best:
            fewer = [[k for k in kept if k is not c] for c in kept]
            values = [with_(rest) for rest in fewer]
            i = int(np.argmax(values))
            if value - values[i] > LEAST:
                break
            kept, value = fewer[i], values[i]
        if value - LEAST * len(kept) > best:
            best, flipped = value - LEAST * len(kept), [kind]
    return flipped


def without_known_effects(machine: Machine, readings: Readings) -> Readings:
    """Readings less what the machine's own enabled effects predict: they are known, and traced no second time."""
    known = [e for e in machine.effects if e.enabled]
    if not known:
        return readings
    from ..core.synthesis import omega

    matrix = omega(machine, [e.component for e in known], readings.q, readings.tool_offset)
    motion = np.stack([e.values(readings.columns) for e in known], axis=1)
    vectors = np.einsum("pan,pn->pa", matrix, motion)
    return replace(readings, value=readings.value - np.einsum("ra,ra->r", vectors[readings.point], readings.sense))


def _consistent(tracer: Tracer) -> list[Step]:
    """The steps that keep their names.  A refused one is a piece of something else: the rest is judged again with a
    free form in its place, so that further pieces of the same thing fall too."""
    for _ in range(len(tracer.steps) + 1):
        refused = [s for s in tracer.steps if s.refused]
        named = [s for s in tracer.steps if not s.refused]
        if not refused or not named or tracer.coloured:
            return named
        stand_in = []
        for s in refused:
            parts = s.candidate.driver.names[:2]
            slow = slow_columns(tracer.readings.columns, parts)
            if slow and TIME in tracer.names:
                parts = tuple(dict.fromkeys(TIME if p in slow else p for p in parts))
            form = free_regressor(parts, tracer.readings.columns, 8)
            stand_in.append(Candidate(s.candidate.symbol, form, 0.0, np.zeros(0), 1.0, 0.0))
        changed = False
        for s in named:
            others = [n.candidate for n in named if n is not s] + stand_in
            full = tracer.fit_with([*others, s.candidate])
            vectors = s.candidate.vectors(tracer.readings.columns)
            gain, _, _ = exact_gain(tracer.rows_with(full, others), s.candidate.index, vectors)
            if gain < 0.4 * s.candidate.gain:
                s.refused = "a free form in the place of a refused finding explains most of it"
                changed = True
        if not changed:
            return named
    return named


def _pieces(tracer: Tracer, named) -> bool:
    """Refuse names that are pieces of the structure that is left: with the name taken out, a surface of other columns
    explains what it explained.  True if any was refused."""
    found = False
    for step in named:
        c = step.candidate
        others = [s.candidate for s in named if s is not step and not s.refused]
        surface = tracer.remainder(others).structure
        if surface is None or set(surface.columns) <= set(c.driver.columns):
            continue
        beside = [*others, surface_candidate(surface)]
        full = tracer.fit_with([*beside, c])
        gain, _, _ = exact_gain(tracer.rows_with(full, beside), c.index, c.vectors(tracer.readings.columns))
        alone = exact_gain(tracer.rows_with(full, others), c.index, c.vectors(tracer.readings.columns))[0]
        if gain < 0.4 * alone:
            columns = " and ".join(surface.columns)
            step.refused = f"a smooth surface over {columns} explains it and more: it is a piece of another shape"
            found = True
    return found


def _remainder(tracer: Tracer, named) -> tuple[list[Candidate], Remainder, bool]:
    """What is left beside the named effects: smooth free forms worth predicting with, the first test, and whether it is
    structure above the floor."""
    model = [s.candidate for s in named]
    first = tracer.remainder(model)
    structured = first.p < ALPHA and first.size > tracer.floor
    refused = [s for s in tracer.steps if s.refused and s.significant and s.size > tracer.floor]
    structured = structured or bool(refused)
    smooth: list[Candidate] = []
    if tracer.coloured:  # nothing smooth can be told from noise that remembers, and none would predict
        return smooth, first, tracer.colour**0.5 > tracer.floor
    rest = first
    for _ in range(3):
        if not (structured and rest.structure is not None and rest.p < ALPHA and rest.size > 0.5 * tracer.floor):
            break
        best = _smooth(tracer, [*model, *smooth], rest)
        if best is None:
            break
        smooth.append(best)
        rest = tracer.remainder([*model, *smooth])
    return smooth, first, structured


def _smooth(tracer: Tracer, model, rest: Remainder) -> Candidate | None:
    """The located surface, if it predicts left-out blocks at all; sharpened once the noise beside it is known."""
    if rest.gain[0] <= rest.gain[1]:
        return None
    found = rest.structure
    for _ in range(2):
        full = tracer.fit_with([*model, surface_candidate(found)])
        rows = tracer.scanned(tracer.rows_with(full, model))
        found = sharpen(rows, tracer.scan_readings.columns, found)
    return surface_candidate(separable(rows, tracer.scan_readings.columns, found) or found)


def _unlogged(tracer: Tracer, model) -> Unlogged | None:
    rows = tracer.rows(tracer.fit_with(model))
    readings = tracer.readings
    for found in (
        unlogged_driver(rows, seed=tracer.seed),
        uneven_noise(rows, readings.q, readings.kind, seed=tracer.seed),
    ):
        if found is not None and found.p < ALPHA and found.size > tracer.floor:
            return found
    return None


def _verdict(tracer: Tracer, named, structured: bool, hidden) -> str:
    stand_in = any(TIME in s.candidate.driver and _vague_time(s.candidate) for s in named)
    if named:
        return PARTLY if structured or hidden or stand_in else EXPLAINED
    if structured:
        return UNEXPLAINED
    return PARTLY if hidden else NOTHING


def _vague_time(c: Candidate) -> bool:
    """Time as a mere stand-in: a trend or power of time, rather than an approach or an instant."""
    return not (c.shape.warm_up or c.shape.sudden)
