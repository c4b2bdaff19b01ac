# SPDX-License-Identifier: LGPL-2.1-or-later
"""Functions that make the document objects; scripts, tests, commands and batch runs all use these.

Each returns the object, works without a window, and opens no transaction (a command does that around it).  What finds
objects is in `tree`.
"""

from __future__ import annotations

import json
from dataclasses import replace

from ..core.distributions import with_defaults
from ..core.effects import Effect
from ..core.errors import AXES, component
from ..core.joints import check_name
from ..formats import effects_json
from ..messages import Refused
from . import objects
from .base import dress, put
from .paths import as_links, as_sub
from .refresh import latest
from .tables import write_tolerances
from .tree import (
    BODY_LABELS,
    FEATURE,
    GROUP,
    axis_of,
    body_of,
    tolerances_of,
)


def _new(doc, kind: str, proxy, name: str, label: str | None):
    obj = doc.addObject(kind, name)
    proxy(obj)
    obj.Label = label or name
    dress(obj)
    return obj


def make_machine(
    doc, workpiece_chain=(), tool_chain=(), *, bed=(), tool_point=None, squareness="direction", label="Machine"
):
    """A machine with an empty tolerance table.  Chains from the bed outwards, such as ["Y", "X"] and ["Z"].

    bed : parts, each an object, or (top object, "Path.To.Part.").  tool_point : object, or (object, "Path.Vertex1").
    Where one of `make_axis` is missing `machine.Problem` says so.
    """
    machine = _new(doc, GROUP, objects.MachineObject, "Machine", label)
    put(machine, "WorkpieceChain", list(workpiece_chain))
    put(machine, "ToolChain", list(tool_chain))
    machine.Squareness = squareness
    machine.Bed = as_links(bed)
    machine.ToolPoint = as_sub(tool_point)
    make_tolerances(machine)
    return machine


def make_axis(
    machine, name, parts=(), *, travel=(-100.0, 100.0), direction=None, along="Automatic", reverse=False,
    reference=None, reference_at="Automatic",
):  # fmt: skip
    """A linear axis of a machine.  name : a capital letter and at most one digit.  parts : the carriage.

    direction, reference : sources, None for the parts' own.
    along : "Automatic", "Local X", "Local Y" or "Local Z".  reference_at : "Automatic", "Placement", "Centre of mass".
    """
    check_name(name, machine.Label)
    if axis_of(machine, name) is not None:
        raise Refused("axis-exists", machine.Label, axis=name)
    axis = _new(machine.Document, GROUP, objects.AxisObject, f"Axis{name}", f"Axis {name}")
    axis.Axis = name
    axis.Parts = as_links(parts)
    axis.DirectionSource = as_sub(direction)
    axis.DirectionAlong = along
    axis.Reverse = bool(reverse)
    axis.ReferenceSource = as_sub(reference)
    axis.ReferenceAt = reference_at
    axis.TravelLower, axis.TravelUpper = float(travel[0]), float(travel[1])
    machine.addObject(axis)
    return axis


def make_body(machine, name, parts=(), *, reference=None, reference_at="Automatic"):
    """The spindle with its tool ("T") or the workpiece with its fixture ("W") of a machine."""
    if name not in BODY_LABELS:
        raise Refused("body-unknown", machine.Label, body=name)
    if body_of(machine, name) is not None:
        raise Refused("body-exists", machine.Label, body=name)
    body = _new(machine.Document, GROUP, objects.BodyObject, f"Body{name}", BODY_LABELS[name])
    body.Body = name
    body.Parts = as_links(parts)
    body.ReferenceSource = as_sub(reference)
    body.ReferenceAt = reference_at
    machine.addObject(body)
    return body


def make_tolerances(machine):
    """The tolerance table; for axes X, Y, Z filled with the paper's values."""
    table = _new(machine.Document, FEATURE, objects.TolerancesObject, "Tolerances", None)
    machine.addObject(table)
    if set(AXES) <= {*machine.WorkpieceChain, *machine.ToolChain} or not (machine.WorkpieceChain or machine.ToolChain):
        write_tolerances(table, {})  # of another machine, errors that are not listed take the usual limits too
    return table


def set_tolerances(machine, tolerances, units=None) -> None:
    """`tables.write_tolerances` to the machine's table, made where there is none."""
    write_tolerances(tolerances_of(machine) or make_tolerances(machine), tolerances, units, _core(machine))


def with_usual(machine, tolerances: dict) -> dict:
    """`tolerances` (symbol -> Tolerance), and the usual ones for the other errors of a machine."""
    core = _core(machine)
    return with_defaults(tolerances) if core is None else replace(core, tolerances=tolerances).all_tolerances


def _core(machine):
    """The core machine, or None where the machine cannot be computed (yet)."""
    try:
        return latest(machine).core
    except Refused:
        return None


def make_sensitivity(machine, label="Sensitivity"):
    """An empty result object; `results.compute` fills it."""
    found = _new(machine.Document, FEATURE, objects.SensitivityObject, "Sensitivity", label)
    machine.addObject(found)
    return found


def make_effect(machine, effect: Effect):
    """An effect object under the body whose component it drives."""
    core = _core(machine)
    c = (component if core is None else core.component)(effect.component)
    body = c.body
    owner = body_of(machine, body)
    if owner is None:
        owner = make_body(machine, body) if body in BODY_LABELS else None
    if owner is None:
        raise Refused("axis-missing-for-effect", machine.Label, axis=body)
    obj = _new(machine.Document, FEATURE, objects.EffectObject, "Effect", effect.name)
    obj.Component, obj.Driver, obj.Shape = effect.component, str(effect.driver), effect.shape.name
    obj.Parameters = json.dumps(effects_json.parameters(effect, c), sort_keys=True)
    put(obj, "Extent", effect.extent or ())
    obj.Enabled = bool(effect.enabled)
    owner.addObject(obj)
    return obj
