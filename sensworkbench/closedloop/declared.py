# SPDX-License-Identifier: LGPL-2.1-or-later
"""The declared fit alone: errors that the machine declares, fitted to the readings, before any search.

Parameters that the readings do not determine get no value; combinations that they cannot distinguish are reported.
"""

from __future__ import annotations

from dataclasses import replace
from statistics import NormalDist

import numpy as np

from ..core.machine import Machine
from ..core.synthesis import omega
from ..core.units import um
from ..messages import Refused
from . import scores
from .design import Term, design, run_labels
from .fit import Fit, basis, fit, null_space
from .freeform import f_score
from .readings import Readings
from .settings import DEFAULT, TraceSettings


def without_known_effects(machine: Machine, readings: Readings) -> Readings:
    """Readings less what the machine's own enabled effects predict: they are known, and traced no second time."""
    known = [e for e in machine.effects if e.enabled]
    if not known:
        return readings
    matrix = omega(machine, [e.component for e in known], readings.q, readings.tool_offset)
    motion = np.stack([e.values(readings.columns) for e in known], axis=1)
    vectors = np.einsum("pan,pn->pa", matrix, motion)
    return replace(readings, value=readings.value - np.einsum("ra,ra->r", vectors[readings.point], readings.sense))


def aligned(machine: Machine, readings: Readings, settings: TraceSettings = DEFAULT) -> Readings:
    """The readings with their alignment settled: as their file says, else by what they show.

    An offset of each run is fitted; where the runs' tilts differ beyond chance, each run gets its own alignment.
    Refuses an alignment per run of readings that have no runs.
    """
    runs = run_labels(readings)
    if readings.alignment and readings.alignment != "once" and len(runs) == 0:
        raise Refused("alignment-without-runs", "readings", alignment=readings.alignment)
    if readings.alignment:
        return readings
    if len(runs) < 2:
        return replace(readings, alignment="once")
    shifted, tilted = (replace(readings, alignment=a) for a in ("offset per run", "per run"))
    plain = fit(design(machine, shifted), shifted, settings=settings)
    weight = plain.weight  # of both: a fit with many parameters takes the noise of one direction along
    wide = basis(design(machine, tilted).matrix * weight[:, None])
    dof = int(np.count_nonzero(weight)) - wide.rank
    dims = wide.rank - plain.basis.rank
    if dof < settings.least_dof or dims < 1:
        return shifted
    y = readings.value * weight
    left = float(((y - wide.ortho @ (wide.ortho.T @ y)) ** 2).sum())
    limit = NormalDist().inv_cdf(1 - settings.tilt)
    return tilted if f_score(plain.chi2 - left, dims, left, dof) > limit else shifted


def too_few(code: str, found: Fit, readings: Readings) -> Refused:
    """The refusal `code` of readings that do not determine the parameters; where runs of one place make them so many,
    that is said instead.
    """
    fields = {"count": readings.rows, "rank": found.basis.rank}
    if readings.run is not None and readings.alignment != "once":
        count = np.unique([str(r) for r in readings.run], return_counts=True)[1]
        single = int((count == 1).sum())
        if single > len(count) / 2:
            return Refused("fit-runs-of-one", "readings", single=single, runs=len(count), **fields)
    return Refused(code, "readings", **fields)


def declared_fit(machine: Machine, readings: Readings) -> Fit:
    """Robust weighted least squares of the declared errors; the machine's own enabled effects are taken off first.

    Refuses where there are fewer readings than it takes to determine anything.
    """
    readings = aligned(machine, without_known_effects(machine, readings))
    terms = design(machine, readings)
    found = fit(terms, readings)
    if found.dof < 1:
        raise too_few("fit-few-for-model", found, readings)
    return found


def fit_summary(found: Fit, readings: Readings) -> dict:
    """The fit in numbers: rms before and after (um), noise, rank, null space (messages), outliers, parameters.

    parameters : (title, value or None, standard uncertainty or None, unit); title : a symbol or a message;
    None where it is not determined.
    """
    terms = found.design.terms
    used = found.weight > 0
    errors = np.sqrt(np.maximum(np.diag(found.covariance), 0.0))
    parameters = []
    for i, term in enumerate(terms):
        scale, unit = _scale(term)
        known = bool(found.determined[i])
        value, u = (float(found.coefficients[i]) * scale, float(errors[i]) * scale) if known else (None, None)
        parameters.append((term.title, value, u, unit))
    points = np.unique(readings.point[found.outliers])
    lines = readings.line if readings.line is not None else np.zeros(readings.points, dtype=int)
    return {
        "points": readings.points,
        "rows": readings.rows,
        "columns": len(terms),
        "rank": int(found.basis.rank),
        "condition": float(found.basis.condition),
        "null_space": null_space(found, readings),
        "rms": scores.metrics(um(found.residual), readings, used),
        "noise_um": {"xyz*"[kind]: um(sigma) for kind, sigma in found.noise.items()},
        "outliers": [{"line": int(lines[p]), "position_mm": readings.q[p].tolist()} for p in points],
        "parameters": parameters,
    }


def _scale(term: Term) -> tuple[float, str]:
    return (1e6, "urad") if term.angular else (1e3, "um")
