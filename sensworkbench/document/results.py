# SPDX-License-Identifier: LGPL-2.1-or-later
"""Indices in and out of the document: compute, store in a Sensitivity object, read back."""

from __future__ import annotations

import numpy as np

from ..core import objectives, workspace
from ..core.errors import component
from ..core.machine import Machine
from .base import numbers, put
from .extract import Survey, core_machine, objective, positions, survey
from .factory import make_sensitivity
from .refresh import refresh
from .staleness import result_inputs
from .tables import read_units
from .tree import sensitivity_of

PER_ERROR = {
    "First": "first", "Total": "total", "TotalMax": "total_max", "FirstWeighted": "first_vw",
    "TotalWeighted": "total_vw", "ComponentFirst": "component_first", "ComponentTotal": "component_total",
    "ComponentTotalMax": "component_total_max", "ComponentTotalWeighted": "component_total_vw",
}  # fmt: skip


def compute(machine, progress=None, *, estimate: bool = True):
    """Compute the indices as set on the machine and store them; returns the Sensitivity object.

    Refuses (nothing changed) what cannot be computed.  progress : as in `workspace.sensitivity`.
    """
    core = core_machine(machine)
    found = workspace.sensitivity(core, positions(machine, core), objective(machine), progress, estimate)
    return store(machine, found, core)


def compute_at_once(machine, limit: int):
    """`compute` on one survey and without an estimate, for live work; None for more than `limit` positions."""
    seen = survey(machine)
    where = positions(machine, seen.core)
    if len(where.q) > limit:
        return None
    found = workspace.sensitivity(seen.core, where, objective(machine), estimate=False)
    return store(machine, found, seen.core, seen)


def store(machine, found: workspace.Sensitivity, core: Machine, seen: Survey | None = None):
    """Write indices to the machine's Sensitivity object (made where there is none) and return it.

    The settings on the machine become those of the result, so that it is not stale.
    seen : the survey that `core` is from, where nothing has moved since; default: the machine is surveyed again, and
    what has moved in between leaves the result stale.
    """
    _take_settings(machine, found)
    obj = sensitivity_of(machine) or make_sensitivity(machine)
    labels, columns, owners, laws = workspace.error_table(core)
    units = read_units(machine)
    put(obj, "Symbols", found.symbols)
    put(obj, "Owners", found.owners)
    put(obj, "Bodies", found.bodies)
    for name, attribute in PER_ERROR.items():
        put(obj, name, getattr(found, attribute))
    estimated = -1.0 if found.estimated_error is None else found.estimated_error
    put(obj, "Moments", [found.mean_square, found.variance, estimated])
    for name, value in zip(("MeanSquare", "Variance", "EstimatedError"), obj.Moments):
        put(obj, name, value)
    put(obj, "Output", found.objective.output)
    put(obj, "Weights", found.objective.weights)
    put(obj, "Signed", bool(found.objective.signed))
    put(obj, "Aggregate", found.positions.kind)
    at = found.positions.kind == "at"
    put(obj, "Points", found.positions.q[0] if at else found.positions.counts)
    put(obj, "Squareness", core.squareness)
    put(obj, "Lower", [t.lower for t in laws])
    put(obj, "Upper", [t.upper for t in laws])
    put(obj, "Units", [units.get(label) or component(c).unit for label, c in zip(labels, columns)])
    put(obj, "Distributions", [t.distribution for t in laws])
    put(obj, "Fingerprint", result_inputs(machine, core))
    put(obj, "Stale", False)
    refresh(machine, seen)
    return obj


def _take_settings(machine, found: workspace.Sensitivity) -> None:
    for name, value in (("Output", found.objective.output), ("Aggregate", found.positions.kind)):
        if getattr(machine, name) != value:
            setattr(machine, name, value)
    put(machine, "Weights", found.objective.weights)
    put(machine, "Signed", bool(found.objective.signed))
    counts = found.positions.counts
    if found.positions.kind == "at":
        put(machine, "At", found.positions.q[0])
    elif len(set(counts)) == 1:
        put(machine, "Order" if found.positions.kind == "quadrature" else "Grid", int(counts[0]))


def load(machine, obj) -> workspace.Sensitivity:
    """The stored indices as the core's `Sensitivity` (of the machine as it is now; see `Stale`)."""
    core = core_machine(machine)
    points = list(obj.Points)
    if obj.Aggregate == "at":
        where = workspace.at(core, points)
    else:
        where = (workspace.grid if obj.Aggregate == "grid" else workspace.quadrature)(core, [int(p) for p in points])
    return workspace.Sensitivity(
        symbols=tuple(obj.Symbols),
        owners=tuple(obj.Owners),
        bodies=tuple(obj.Bodies),
        mean_square=obj.MeanSquare,
        variance=obj.Variance,
        positions=where,
        objective=objectives.objective(obj.Output, numbers(obj.Weights), bool(obj.Signed)),
        estimated_error=None if obj.EstimatedError < 0 else obj.EstimatedError,
        **{attribute: np.array(getattr(obj, name), dtype=float) for name, attribute in PER_ERROR.items()},
    )
