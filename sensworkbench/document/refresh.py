# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a recompute of a machine writes: directions, reference points and Abbe offsets, and whether results are stale.

Only output properties are written, so a recompute never causes another one; placements are never touched.
"""

from __future__ import annotations

from ..core.errors import COMPONENTS, Component
from ..messages import Message, Refused
from . import told
from .base import alive, members, put
from .extract import Survey, survey
from .joints import position
from .paths import PartPath
from .staleness import TOLERANCE, mark_results, mark_studies, mark_traces, result_inputs
from .tree import all_parts, part_index, parts_of


def refresh(machine, seen: Survey | None = None) -> Survey | None:
    """Write the results of a machine's objects; a refusal goes to its Problem.  Returns the survey, or None.

    seen : a survey that the caller has just made, since when nothing has moved; default: one is made.
    """
    _keep(machine, None)
    try:
        follow(machine)
        found = survey(machine) if seen is None else seen
        _check_positions(machine, found)
    except Refused as error:
        put(machine, "Problem", error.message)
        mark_results(machine, "")
        mark_studies(machine, None)
        _keep(machine, None, error)
        return None
    core = found.core
    put(machine, "Problem", "")
    put(machine, "Structure", core.structure)
    put(machine, "FunctionalPoint", core.tool_point)
    put(machine, "Skew", core.skew_deg)
    for body, obj in found.owners.items():
        arm = found.arms[body][0]
        put(obj, "ReferencePoint", _reference(core, body))
        usual = Message("from-functional-point" if body == "T" else "from-document-origin")
        put(obj, "ReferenceFrom", told.dumps(found.reference_from.get(body, usual)))
        put(obj, "AbbeOffset", core.frame @ arm)
        for letter, value in zip("XYZ", arm):
            put(obj, f"AbbeOffset{letter}", float(value))
    for name in core.names:
        put(found.owners[name], "Direction", core.joint(name).direction)
        put(found.owners[name], "DirectionFrom", told.dumps(found.direction_from[name]))
    inputs = result_inputs(machine, core, found.home_arms)
    put(machine, "Inputs", inputs)
    mark_results(machine, inputs)
    mark_studies(machine, core, found.home_arms)
    mark_traces(machine, core, found.home_arms)
    _keep(machine, found)
    return found


def _keep(machine, found: Survey | None, refusal: Refused | None = None) -> None:
    if alive(machine):
        machine.Proxy.survey, machine.Proxy.refusal = found, refusal


def _reference(core, body: str):
    """Reference point of a body with all joints at 0, document coordinates."""
    ends = {"T": core.spindle_reference or core.tool_point, "W": core.workpiece_reference or (0.0, 0.0, 0.0)}
    return ends[body] if body in ends else core.joint(body).point


def problem_text(machine, language: str = "en") -> str:
    """Why a machine cannot be computed, in `language`; English where it was not recomputed since the file was opened.

    "" where it can be computed.
    """
    refusal = machine.Proxy.refusal if alive(machine) else None
    return refusal.text(language) if refusal is not None and machine.Problem else machine.Problem


def latest(machine) -> Survey:
    """The survey of the last recompute where nothing has been touched since, else a new one; refuses as `survey`."""
    kept = machine.Proxy.survey if alive(machine) else None
    if kept is not None and not any("Touched" in o.State for o in (machine, *machine.OutListRecursive)):
        return kept
    return survey(machine)


def components(machine) -> dict[str, Component]:
    """symbol -> error component of a machine; those of axes X, Y, Z where it cannot be computed."""
    try:
        return {c.symbol: c for c in latest(machine).core.components}
    except Refused:
        return dict(COMPONENTS)


def parts_and_index(machine) -> tuple[dict[str, list[PartPath]], dict[tuple, str]]:
    """(body -> its parts, occurrence of a part -> its body), also of a machine that cannot be computed."""
    try:
        found = latest(machine)
    except Refused:
        parts = all_parts(machine)
        return parts, part_index(machine, parts)
    return found.parts, found.index


def _check_positions(machine, found: Survey):
    for joint in found.core.joints:
        axis = found.owners[joint.name]
        wanted, actual = axis.Position.Value, axis.StandsAt
        if abs(wanted - actual) > TOLERANCE:
            fields = {"wanted": wanted, "actual": actual, "unit": joint.unit}
            raise Refused("position-not-reached", machine.Label, axis=axis.Label, **fields)


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
