# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a recompute of a machine writes: directions, reference points and Abbe offsets, and whether results are stale.

Only output properties are written, so a recompute never causes another one; placements are never touched.
"""

from __future__ import annotations

from ..core.errors import AXES, BODIES
from ..core.machine import Machine
from ..messages import Refused
from .base import members, put
from .extract import Survey, survey
from .joints import position
from .staleness import TOLERANCE, mark_results, mark_traces, result_inputs
from .tree import parts_of


def refresh(machine, seen: Survey | None = None) -> Survey | None:
    """Write the results of a machine's objects; a refusal goes to its Problem.  Returns the survey, or None.

    seen : a survey that the caller has just made, since when nothing has moved; default: one is made.
    """
    try:
        follow(machine)
        found = survey(machine) if seen is None else seen
        _check_positions(machine, found.owners)
    except Refused as error:
        put(machine, "Problem", error.message)
        mark_results(machine, "")
        return None
    core = found.core
    put(machine, "Problem", "")
    put(machine, "Structure", core.structure)
    put(machine, "FunctionalPoint", core.tool_point)
    for pair, angle in core.skew_deg.items():
        put(machine, f"Skew{pair}", angle)
    local = core.lever_arms(found.position)
    arms = {body: arm @ core.frame.T for body, arm in local.items()}
    for body in BODIES:
        obj = found.owners.get(body)
        if obj is None:
            continue
        put(obj, "ReferencePoint", _reference(core, body))
        put(obj, "ReferenceFrom", found.reference_from.get(body, "functional point" if body == "T" else "origin"))
        put(obj, "AbbeOffset", arms[body][0])
        for name, value in zip(AXES, local[body][0]):
            _put_length(obj, f"AbbeOffset{name}", float(value))
        if body in AXES:
            put(obj, "Direction", core.axes[body].direction)
            put(obj, "DirectionFrom", found.direction_from[body])
    inputs = result_inputs(machine, core)
    put(machine, "Fingerprint", inputs)
    mark_results(machine, inputs)
    mark_traces(machine, core)
    return found


def _reference(core: Machine, body: str):
    if body in AXES:
        return core.axes[body].reference
    if body == "T":
        return core.spindle_reference or core.tool_point
    return core.workpiece_reference or (0.0, 0.0, 0.0)


def _put_length(obj, name, value):
    if getattr(obj, name).Value != value:
        setattr(obj, name, value)


def _check_positions(machine, owners):
    for name in AXES:
        axis = owners[name]
        if abs(axis.Position.Value - axis.StandsAt) > TOLERANCE:
            raise Refused(
                f"{axis.Label!r} is to stand at {axis.Position.Value:g} mm but stands at {axis.StandsAt:g} mm",
                machine.Label,
                "Jog it (a position driven by an expression cannot move parts).",
            )


def follow(machine) -> None:
    """Take over where the solver or a drag has put the carriages that sliders hold."""
    for axis in members(machine, "Axis"):
        stands = position(machine, axis, parts_of(machine, axis.Axis))
        if stands is None:
            continue
        if abs(stands - axis.StandsAt) > 1e-9 or axis.Position.Value != axis.StandsAt:
            axis.StandsAt = stands
            axis.Position = stands
            axis.purgeTouched()
