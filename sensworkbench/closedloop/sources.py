# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sources of uncertainty that are common to all readings, as their file states them, and the budget of predictions.

A calibration of the instrument, the expansion of artefact or scale and its temperature change every reading in
proportion to the place (JCGM 100, 4.3 and 5.2): what they do to the parameters goes through the same fit.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..core.fitted import EFFECT
from ..core.machine import Machine
from .predict import uncertainty
from .readings import Readings

INSTRUMENT, EXPANSION, TEMPERATURE = "instrument", "expansion", "temperature"
MOST_PLACES = 400


def common_sources(readings: Readings) -> dict[str, np.ndarray]:
    """source -> (R,) mm what one standard uncertainty of it does to each reading; only what the file states.

    Records: `u_scale_um_m` of the instrument; `u_expansion_um_m_k` of artefact or scale, which counts by the
    temperature above 20 degC; `expansion_um_m_k` with `u_temperature_k`.
    """
    stated = readings.records
    place = readings.q - readings.q.mean(axis=0)
    along = np.einsum("ra,ra->r", place[readings.point, :3], readings.sense)
    out = {}
    if stated.get("u_scale_um_m"):
        out[INSTRUMENT] = 1e-6 * float(stated["u_scale_um_m"]) * along
    if stated.get("u_expansion_um_m_k"):
        out[EXPANSION] = 1e-6 * float(stated["u_expansion_um_m_k"]) * _above_20(readings)[readings.point] * along
    if stated.get("expansion_um_m_k") and stated.get("u_temperature_k"):
        out[TEMPERATURE] = 1e-6 * float(stated["expansion_um_m_k"]) * float(stated["u_temperature_k"]) * along
    return {name: field for name, field in out.items() if np.any(field)}


def _above_20(readings: Readings) -> np.ndarray:
    """(P,) temperature above 20 degC: as stated for the artefact, else the mean of the logged ones, else 0."""
    if "temperature_c" in readings.records:
        return np.full(readings.points, float(readings.records["temperature_c"]) - 20.0)
    logged = [v for name, v in readings.columns.items() if name.startswith("temp_")]
    return np.mean(logged, axis=0) if logged else np.zeros(readings.points)


@dataclass(frozen=True)
class BudgetLine:
    """One source of the uncertainty of the mean predicted error.  variance : mm2, the three directions together."""

    source: str
    variance: float


def budget(machine: Machine, readings: Readings, parts) -> tuple[BudgetLine, ...]:
    """The sources of the mean variance of the predicted 3-D error over the places of the readings, set-up included.

    parts : source -> `Uncertainty`, see `Estimates.parts`.
    """
    some = np.unique(np.linspace(0, readings.points - 1, MOST_PLACES).astype(int))
    found = {}
    for source, part in parts.items():
        named = {key[1] for key in part.parameters if key[0] == EFFECT}  # earlier effects are not of this trace
        traced = tuple(e for e in machine.effects if e.name in named)
        own = replace(machine, fitted=replace(machine.fitted, uncertainty=part), effects=traced)
        found[source] = float((uncertainty(own, readings)[some] ** 2).sum(axis=1).mean())
    found["alignment"] = max(found.pop("noise and alignment") - found["noise"], 0.0)
    least = 1e-12 * sum(found.values())  # below it is rounding
    found = {source: v if v > least else 0.0 for source, v in found.items()}
    order = sorted(found, key=lambda name: (name not in ("noise", "alignment"), -found[name]))
    return tuple(BudgetLine(source, found[source]) for source in order)
