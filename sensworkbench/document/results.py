# SPDX-License-Identifier: LGPL-2.1-or-later
"""Indices in and out of the document: one `Result` per computation, written to and read from a Sensitivity object."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..core import workspace
from ..core.distributions import Tolerance
from ..core.machine import Machine
from ..messages import Refused
from . import told
from .base import put
from .extract import Survey, core_machine, objective, positions
from .factory import make_sensitivity
from .refresh import latest, refresh
from .staleness import result_inputs
from .tables import read_units
from .tree import sensitivity_of

PER_ERROR = {
    "First": "first", "Total": "total", "TotalMax": "total_max", "FirstWeighted": "first_vw",
    "TotalWeighted": "total_vw", "ComponentFirst": "component_first", "ComponentTotal": "component_total",
    "ComponentTotalMax": "component_total_max", "ComponentTotalWeighted": "component_total_vw",
}  # fmt: skip


@dataclass(frozen=True)
class Result:
    """What one computation gave: the indices, and what they were computed from.

    laws, units : tolerance of each error (mm, rad) and the unit in which it is shown, in the order of the indices.
    squareness : convention.  inputs : JSON of all that the indices depend on (`staleness.result_inputs`).
    """

    indices: workspace.Sensitivity
    laws: tuple[Tolerance, ...]
    units: tuple[str, ...]
    squareness: str
    inputs: str


def compute(machine, progress=None, *, estimate: bool = True):
    """Compute the indices as set on the machine and store them; returns the Sensitivity object.

    Refuses (nothing changed) what cannot be computed.  progress : as in `workspace.sensitivity`.
    """
    core = core_machine(machine)
    found = workspace.sensitivity(core, positions(machine, core), objective(machine), progress, estimate)
    return store(machine, found, core)


def compute_at_once(machine, limit: int):
    """`compute` on the survey of the last recompute and without an estimate, for live work.

    Returns None for more than `limit` positions.
    """
    seen = latest(machine)
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
    _check_finite(machine, found)
    _take_settings(machine, found)
    obj = sensitivity_of(machine) or make_sensitivity(machine)
    result = make_result(machine, found, core, seen)
    write(obj, result)
    if seen is None or machine.Inputs != result.inputs:
        refresh(machine, seen)
    return obj


def _check_finite(machine, found: workspace.Sensitivity) -> None:
    values = {name: getattr(found, attribute) for name, attribute in PER_ERROR.items()}
    values |= {"MeanSquare": found.mean_square, "Variance": found.variance}
    names = [name for name, numbers_ in values.items() if not np.all(np.isfinite(numbers_))]
    if names:
        raise Refused("indices-not-finite", machine.Label, names=names)


def make_result(machine, found: workspace.Sensitivity, core: Machine, seen: Survey | None = None) -> Result:
    """The `Result` of indices that were computed as set on the machine.  seen : the survey that `core` is from."""
    labels, columns, _, laws = workspace.error_table(core)
    units = read_units(machine)
    shown = tuple(units.get(label) or (core.component(c).unit if c else "1") for label, c in zip(labels, columns))
    inputs = result_inputs(machine, core, None if seen is None else seen.home_arms)
    return Result(found, tuple(laws), shown, core.squareness, inputs)


def write(obj, result: Result) -> None:
    """Store a result in a Sensitivity object."""
    found = result.indices
    put(obj, "Symbols", found.symbols)
    put(obj, "Owners", found.owners)
    put(obj, "Bodies", found.bodies)
    for name, attribute in PER_ERROR.items():
        put(obj, name, getattr(found, attribute))
    estimated = -1.0 if found.estimated_error is None else found.estimated_error
    put(obj, "Moments", [found.mean_square, found.variance, estimated])
    for name, value in zip(("MeanSquare", "Variance", "EstimatedError"), obj.Moments):
        put(obj, name, value)
    put(obj, "Objective", told.objective_text(found.objective))
    put(obj, "Aggregate", found.positions.kind)
    at = found.positions.kind == "at"
    put(obj, "Points", found.positions.q[0] if at else found.positions.counts)
    put(obj, "Squareness", result.squareness)
    put(obj, "Lower", [t.lower for t in result.laws])
    put(obj, "Upper", [t.upper for t in result.laws])
    put(obj, "Units", result.units)
    put(obj, "Distributions", [t.distribution for t in result.laws])
    put(obj, "WithoutExtent", found.without_extent)
    put(obj, "Inputs", result.inputs)
    put(obj, "Stale", False)


def _take_settings(machine, found: workspace.Sensitivity) -> None:
    put(machine, "Objective", told.objective_text(found.objective))
    put(machine, "Aggregate", found.positions.kind)
    counts = found.positions.counts
    if found.positions.kind == "at":
        put(machine, "At", found.positions.q[0])
    elif found.positions.kind in COUNTS and len(set(counts)) == 1:
        put(machine, COUNTS[found.positions.kind], int(counts[0]))


COUNTS = {"quadrature": "Order", "grid": "Grid"}  # kind of positions -> property of the machine that holds the number


def read(obj, core: Machine) -> Result:
    """The result that a Sensitivity object holds.  core : the machine, whose travel gives the positions."""
    points = list(obj.Points)
    if obj.Aggregate == "at":
        where = workspace.at(core, points)
    elif obj.Aggregate == "low_discrepancy":
        where = workspace.low_discrepancy(core, int(points[0]))
    else:
        where = (workspace.grid if obj.Aggregate == "grid" else workspace.quadrature)(core, [int(p) for p in points])
    indices = workspace.Sensitivity(
        symbols=tuple(obj.Symbols),
        owners=tuple(obj.Owners),
        bodies=tuple(obj.Bodies),
        without_extent=tuple(obj.WithoutExtent),
        mean_square=obj.MeanSquare,
        variance=obj.Variance,
        positions=where,
        objective=told.objective(obj.Objective),
        estimated_error=None if obj.EstimatedError < 0 else obj.EstimatedError,
        **{attribute: np.array(getattr(obj, name), dtype=float) for name, attribute in PER_ERROR.items()},
    )
    laws = tuple(Tolerance(*law) for law in zip(obj.Lower, obj.Upper, obj.Distributions))
    return Result(indices, laws, tuple(obj.Units), obj.Squareness, obj.Inputs)


def load(machine, obj) -> workspace.Sensitivity:
    """The stored indices as the core's `Sensitivity` (of the machine as it is now; see `Stale`)."""
    return read(obj, core_machine(machine)).indices
