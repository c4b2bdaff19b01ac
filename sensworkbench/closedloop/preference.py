# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which of several equal explanations gets the name: first that beside which the declared errors keep their tolerances.

An explanation that the readings cannot distinguish from another, but that needs declared errors far outside their
tolerances, stands behind it.  Where the tolerances do not decide, the order of `prior` does.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from .acceptance import review
from .fit import Fit
from .problem import State, Step
from .rivals import more_general
from .scan import exact_gain
from .search import ScoredTerm
from .tolerances import plausible


def equals(state: State, step: Step, others, full: Fit) -> list[tuple[ScoredTerm, float]]:
    """(explanation, its loss of chi-square) of all that the readings cannot tell from an effect, refitted.

    full : the fit of others and the effect.
    """
    finding, columns = step.candidate, state.problem.readings.columns
    rows = state.rows_with(full, others)
    alike = state.inflation(full, finding, margin=0.0)
    out = []
    for c in step.pool:
        if c.key == finding.key or more_general(c, finding):
            continue
        gain, coefficients, visible = exact_gain(rows, c.index, c.vectors(columns))
        loss = (finding.gain - gain) / alike
        if loss < state.settings.rival:
            out.append((replace(c, gain=gain, coefficients=coefficients, visible=visible), float(loss)))
    return out


def ahead(state: State, step: Step, others) -> list[ScoredTerm]:
    """The equals of a named effect that go before it by the machine's tolerances, the first of them first.

    Such a one has a smaller chi-square, with the penalty of the tolerances, by more than `tolerance_margin`; those
    within it of the best stand in the order of `prior`.  (A chi-square without the penalty that is smaller than the
    effect's does not count: the effect was chosen in spite of it.)
    """
    full, margin = state.fit_with([*others, step.candidate]), state.settings.tolerance_margin
    around = equals(state, step, others, full)
    if not around:
        return []
    cost = plausible(state, full, others, step.candidate, [c for c, _ in around]).cost
    total = np.array([max(loss, 0.0) for _, loss in around]) + cost[1:]
    limit = min(float(total.min()) + margin, float(cost[0]) - margin)
    return sorted((c for (c, _), t in zip(around, total) if t <= limit), key=lambda c: (-c.score, c.key))


def preferred(state: State) -> State:
    """The state with each name that the tolerances speak against exchanged for an equal that may carry one."""
    for i in range(len(state.steps)):
        step = state.steps[i]
        if step.refused is not None:
            continue
        others = [s.candidate for s in state.named if s is not step]
        for c in ahead(state, step, others)[: state.settings.tries]:
            named = (*state.steps[:i], replace(step, candidate=c), *state.steps[i + 1 :])
            tried = review(replace(state, steps=named))
            if tried.steps[i].refused is None and len(tried.named) == len(state.named):
                state = tried
                break
    return state
