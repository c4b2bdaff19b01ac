# SPDX-License-Identifier: LGPL-2.1-or-later
"""Trace: from readings to a verdict - is anything left, on which body, what is it, and which measurement would decide.

The words are those of the specification: nothing_to_explain, explained, partly_explained, unexplained.  A name is given
only if the data support it; everything else is located, sized and left unnamed.  The order of the algorithm is the
body of `trace`; each line is a stage, a function from a state to the next one.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from ..core.driver import TIME
from ..core.machine import Machine
from ..core.workspace import Cancelled
from ..messages import Refused
from .acceptance import line_beside, proved, review
from .checks import contradicted
from .declared import aligned, too_few, without_known_effects
from .design import check_three_axes
from .fit import Fit
from .kept import MOST_AT_THE_END
from .preference import preferred
from .problem import Problem, State
from .readings import Readings
from .remainder import Rest, rest
from .report import result
from .result import EXPLAINED, NOTHING, PARTLY, UNEXPLAINED, TraceResult
from .settings import DEFAULT, TraceSettings
from .signs import flipped_directions, settled_signs, simpler_signs
from .stages import add_effects, consistent, polish, rescue, straightened, without_pieces


def trace(
    machine: Machine,
    readings: Readings,
    *,
    seed: int = 0,
    permutations: int = 199,
    settings: TraceSettings = DEFAULT,
    floor: float | None = None,
    progress: Callable[[float, str], bool] | None = None,
) -> TraceResult:
    """Fit the declared model, trace what remains, add the effects that are found, and compare the error before and
    after.

    permutations : number of sign flips for each p.  floor : replaces that of the settings.  progress : called with
    (fraction, words); a false return cancels.  Refuses when there are too few readings to fit anything.
    """
    tell = progress or (lambda fraction, words: True)
    if floor is not None:
        settings = replace(settings, floor=floor)
    check_three_axes(machine)
    if readings.rows < settings.least_readings:
        raise Refused("trace-few-readings", "readings", count=readings.rows, least=settings.least_readings)
    readings = aligned(machine, without_known_effects(machine, readings), settings)
    state = State(Problem(machine, readings, settings, seed, permutations))
    declared = state.fit_with([])
    if declared.dof < settings.least_dof:
        raise too_few("trace-few-for-model", declared, readings)
    _tell(tell, 0.05, "declared model fitted")

    flipped = settled_signs(state, flipped_directions(machine, readings, declared, settings), tell)
    if not flipped:
        state = add_effects(state, tell)
        flipped = simpler_signs(state)
    if flipped:
        state = replace(state, steps=())  # a turned sign looks like effects: it is settled before anything is named
    state = straightened(review(state), tell)
    state = consistent(state)
    state = consistent(rescue(state, tell))
    state = proved(polish(preferred(state)))
    left = rest(state)
    if left.structured and not state.drifts:  # any surface of slow columns fits a drift
        whole = without_pieces(state)
        if whole is not state:
            state = polish(whole)
            left = rest(state)
    if left.smooth:
        further = line_beside(state, left.smooth)
        if further is not state:
            state, left = further, rest(further)
    _tell(tell, 0.75, "what is left is tested")
    full = state.fit_with([*(s.candidate for s in state.named), *left.smooth])
    state.problem.kept.trim(MOST_AT_THE_END)
    return result(state, declared, full, left, verdict(state, left, full), flipped, tell)


def _tell(tell, fraction: float, words: str) -> None:
    if not tell(fraction, words):
        raise Cancelled("cancelled")


def verdict(state: State, left: Rest, full: Fit) -> str:
    """The verdict on what is named and what is left; `full` : the fit of the final model.

    A trend of time stands in for a column that was not logged, and is no explanation; a warm-up or an instant is.  More
    scatter than the stated uncertainty allows withholds `explained`.  What was found beyond chance and above the floor
    and then dropped is structure.
    """
    more = contradicted(full, state.problem.readings, state.settings)
    stand_in = any(
        TIME in s.candidate.driver and not (s.candidate.shape.warm_up or s.candidate.shape.sudden) for s in state.named
    )
    if state.named:
        return PARTLY if left.structured or left.hidden or stand_in or more else EXPLAINED
    if left.structured:
        return UNEXPLAINED
    return PARTLY if left.hidden else NOTHING
