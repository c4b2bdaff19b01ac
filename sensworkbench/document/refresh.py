# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a recompute of a machine writes: directions, reference points and Abbe offsets, and whether results are stale.

Only output properties are written, so a recompute never causes another one; placements are never touched.
"""

from __future__ import annotations

import json
import math

from ..core.errors import AXES, BODIES
from ..core.machine import Machine
from ..core.refusal import Refused
from . import closed_loop
from .base import members, numbers, put
from .extract import Survey, survey
from .joints import follow

TOLERANCE = 1e-6  # mm, and relative: below this nothing has changed


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
        _mark_stale(machine, "")
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
    digest = fingerprint(machine, core)
    put(machine, "Fingerprint", digest)
    _mark_stale(machine, digest)
    closed_loop.mark_stale(machine, core)
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


def _mark_stale(machine, digest: str):
    for result in members(machine, "Sensitivity"):
        put(result, "Stale", not same(result.Fingerprint, digest))


# -- fingerprint -----------------------------------------------------------------------------------------------------
def fingerprint(machine, core: Machine) -> str:
    """JSON of all that the indices depend on, in the machine's own frame: moving or turning it all changes nothing."""
    arms = core.lever_arms([[0.0, 0.0, 0.0]])
    words = [core.structure, core.squareness, machine.Output, bool(machine.Signed), machine.Aggregate]
    values = [*numbers(machine.Weights), *(v for b in BODIES for v in arms[b][0].tolist())]
    for name in AXES:
        values += [*core.directions[name].tolist(), *core.axes[name].travel]
    values += {"quadrature": [machine.Order], "grid": [machine.Grid], "at": numbers(machine.At)}[machine.Aggregate]
    for symbol, t in core.all_tolerances.items():
        words += [symbol, t.distribution]
        values += [t.lower * 1e3, t.upper * 1e3, (t.sigma or 0.0) * 1e3]
    for effect in core.effects:
        if effect.enabled:
            words.append([effect.name, effect.component, effect.driver, effect.shape, dict(effect.parameters)])
    return json.dumps([words, values], sort_keys=True)


def same(one: str, other: str) -> bool:
    """Whether two fingerprints describe the same machine, rounding apart."""
    if not one or not other:
        return False
    (words, values), (words_, values_) = json.loads(one), json.loads(other)
    return (
        words == words_
        and len(values) == len(values_)
        and all(math.isclose(a, b, rel_tol=1e-9, abs_tol=1e-9 if abs(a) < 1e-3 else TOLERANCE)
                for a, b in zip(values, values_))
    )  # fmt: skip
