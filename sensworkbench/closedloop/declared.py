# SPDX-License-Identifier: LGPL-2.1-or-later
"""The declared fit alone: what the readings say of the errors that the machine declares, before anything is searched.

No value is given for what the readings do not determine; what they cannot tell apart is said in words.
"""

from __future__ import annotations

import numpy as np

from ..core.errors import component
from ..core.machine import Machine
from ..core.refusal import Refused
from . import outcome
from .design import Term, design, tool_labels
from .fit import Fit, fit, null_space_words
from .readings import Readings
from .trace import without_known_effects


def declared_fit(machine: Machine, readings: Readings) -> Fit:
    """Robust weighted least squares of the declared errors; the machine's own enabled effects are taken off first.

    Refuses where there are fewer readings than it takes to determine anything.
    """
    readings = without_known_effects(machine, readings)
    terms = design(machine, readings)
    found = fit(terms, readings)
    if found.dof < 1:
        raise Refused(
            f"{readings.rows} readings cannot determine {found.basis.rank} parameters",
            "readings",
            "Measure more places, or declare fewer errors.",
        )
    return found


def fit_summary(found: Fit, readings: Readings) -> dict:
    """The fit in numbers and words: rms before and after (um), noise, rank, null space, outliers, parameters.

    parameters : (label, value or None, standard uncertainty or None, unit); None where it is not determined.
    """
    terms = found.design.terms
    used = found.weight > 0
    errors = np.sqrt(np.maximum(np.diag(found.covariance), 0.0))
    parameters = []
    for i, term in enumerate(terms):
        scale, unit = _scale(term)
        known = bool(found.determined[i])
        value, u = (float(found.coefficients[i]) * scale, float(errors[i]) * scale) if known else (None, None)
        parameters.append((term.label, value, u, unit))
    points = np.unique(readings.point[found.outliers])
    lines = readings.line if readings.line is not None else np.zeros(readings.points, dtype=int)
    return {
        "points": readings.points,
        "rows": readings.rows,
        "columns": len(terms),
        "rank": int(found.basis.rank),
        "condition": float(found.basis.condition),
        "null_space": null_space_words(found, max(1, len(tool_labels(readings)))),
        "rms": outcome.metrics(found.residual * 1e3, readings, used),
        "noise_um": {"xyz*"[kind]: sigma * 1e3 for kind, sigma in found.noise.items()},
        "outliers": [{"line": int(lines[p]), "position_mm": readings.q[p].tolist()} for p in points],
        "parameters": parameters,
    }


def _scale(term: Term) -> tuple[float, str]:
    if term.group in ("run", "tool") or not component(term.symbol).angular:
        return 1e3, "um"
    return 1e6, "urad"
