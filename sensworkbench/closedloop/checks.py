# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks of a fit that a signed result needs: noise against what was stated, repeats, memory, and the guarantee.

More scatter than stated contradicts the stated uncertainty or the model, and withholds `explained`; less is a remark.
"""

from __future__ import annotations

from statistics import NormalDist

import numpy as np

from ..core.units import mm, um
from ..messages import Message
from . import scores
from .design import run_labels
from .fit import Fit
from .freeform import normal_score
from .noise import lagged
from .problem import State
from .readings import Readings
from .result import Guarantee, NoiseSummary
from .settings import TraceSettings

NAMES = "xyz*"  # of the directions of sensing; *: along a reading's own vector


def stated_ratios(fitted: Fit, readings: Readings, settings: TraceSettings) -> dict[str, tuple[float, int]]:
    """direction -> (chi-square per degree of freedom against the stated uncertainty, degrees of freedom).

    Each direction gets its share of the degrees of freedom by its rows.  Empty where no uncertainty is stated.
    """
    used = (fitted.weight > 0) & np.isfinite(readings.u) & (readings.u > 0)
    out = {}
    share = fitted.dof / max(int(np.count_nonzero(fitted.weight)), 1)
    for kind in np.unique(readings.kind[used]).tolist():
        rows = used & (readings.kind == kind)
        dof = share * np.count_nonzero(rows)
        if dof >= settings.least_direction:
            chi2 = float(((fitted.residual[rows] / readings.u[rows]) ** 2).sum())
            out[NAMES[kind]] = (chi2 / dof, int(dof))
    return out


def contradicted(fitted: Fit, readings: Readings, settings: TraceSettings) -> dict[str, float]:
    """direction -> ratio of chi-square where the readings scatter more than stated beyond chance and beyond a tenth.

    The limit of chance is the normal score of chi-square at `settings.misfit`.
    """
    found, limit = stated_ratios(fitted, readings, settings), _misfit(settings)
    return {k: r for k, (r, n) in found.items() if r > settings.misfit_ratio and normal_score(r * n, n) > limit}


def _misfit(settings: TraceSettings) -> float:
    return NormalDist().inv_cdf(1 - settings.misfit)


def noise_summary(fitted: Fit, readings: Readings, residual_um, settings: TraceSettings) -> NoiseSummary:
    """Noise as stated, from repeats and as it shows, with a remark for everything that does not agree."""
    used = fitted.weight > 0
    stated = readings.u[used & np.isfinite(readings.u)]
    pure = scores.replicates(readings, residual_um, used, settings)
    memory = {NAMES[k]: v for k, v in lagged(fitted, readings, 1).items()}
    modelled = {}
    if fitted.memory is not None:
        for kind in np.unique(readings.kind).tolist():
            rows = (readings.kind == kind) & (fitted.memory.before >= 0)
            modelled[NAMES[kind]] = float(fitted.memory.phi[rows].max(initial=0.0))
    ratios = stated_ratios(fitted, readings, settings)
    remarks = []
    more = contradicted(fitted, readings, settings)
    for name, (ratio, dof) in ratios.items():
        if name in more:
            remarks.append(Message("noise-more-than-stated", direction=name, ratio=ratio, dof=dof))
        elif ratio < 1 / settings.misfit_ratio and normal_score(ratio * dof, dof) < -_misfit(settings):
            remarks.append(Message("noise-less-than-stated", direction=name, ratio=ratio, dof=dof))
    remarks += [Message("noise-remembers", direction=k, correlation=v) for k, v in modelled.items() if v > 0]
    residual = float(np.sqrt(np.mean([v**2 for v in fitted.noise.values()])))
    if pure is not None and residual > settings.repeats_ratio * mm(pure):
        remarks.append(Message("noise-more-than-repeats", residual=um(residual), pure=pure))
    return NoiseSummary(
        stated=float(np.sqrt((stated**2).mean())) if len(stated) else None,
        pure=None if pure is None else mm(pure),
        residual=residual,
        direction={NAMES[k]: v for k, v in fitted.noise.items()},
        memory=memory,
        modelled=modelled,
        ratio={k: r for k, (r, _) in ratios.items()},
        remarks=tuple(remarks),
    )


def guarantee(state: State) -> Guarantee:
    """What the chance of a false name rests on: the exchanges that were made and their conditions."""
    conditions = [Message("guarantee-symmetric"), Message("guarantee-blocks", count=int(state.block.max()) + 1)]
    if any(state.memory.values()):
        conditions.append(Message("guarantee-memory"))
    by = [("rows", state.problem.permutations, False)]
    runs = [s.runs for s in state.steps if s.runs is not None]
    if runs:
        by.append(("runs", *min(runs)))
        conditions.append(Message("guarantee-runs", count=len(run_labels(state.problem.readings))))
    return Guarantee(state.settings.alpha, tuple(by), tuple(conditions))
