# SPDX-License-Identifier: LGPL-2.1-or-later
"""Placements -> lever arms: what the core needs to know of a machine, taken from where its parts stand.

The parts may stand away from home (`StandsAt` of each axis): a tool-side body is displaced by +q u of every axis up to
it, a workpiece-side one by -q u, and home is where they would be without.  Coordinates are the document's, mm.
"""

from __future__ import annotations

import json
from dataclasses import dataclass, replace

import FreeCAD as App
import numpy as np

from ..core import objectives, workspace
from ..core.drivers import Effect
from ..core.errors import AXES
from ..core.joints import linear
from ..core.machine import Machine
from ..messages import Refused
from . import geometry, joints
from .base import kind_of, numbers
from .paths import Place, place
from .tables import read_tolerances
from .tree import (  # noqa: F401 - finders, for callers that still ask here
    all_parts,
    bodies,
    body_label,
    effects_of,
    lookup,
    owner_of,
    part_index,
    parts_of,
)


# -- who carries what ------------------------------------------------------------------------------------------------
def source_owner(index, source: Place) -> str | None:
    """The body that carries a source, directly or through what it is attached to; None: it stands by itself."""
    body = lookup(index, source.key)
    if body is not None:
        return body
    obj = source.object
    if getattr(obj, "MapMode", "Deactivated") == "Deactivated":
        return None
    for name in ("AttachmentSupport", "Support"):
        for support, _ in getattr(obj, name, None) or ():
            body = source_owner(index, place((support, "")))
            if body is not None:
                return body
    return None


# -- chains ----------------------------------------------------------------------------------------------------------
def check_chains(machine, owners=None, parts=None) -> dict[str, object]:
    """Axis name -> axis object; refuses chains that are incomplete or name an axis twice."""
    owners = bodies(machine) if owners is None else owners
    parts = all_parts(machine, owners) if parts is None else parts
    chain = list(machine.WorkpieceChain) + list(machine.ToolChain)
    where = machine.Label
    for name in chain:
        if name not in AXES:
            raise Refused(f"unknown axis {name!r} in a chain", where, "Use X, Y and Z, from the bed outwards.")
        if chain.count(name) > 1:
            raise Refused(
                f"axis {name} stands twice in the chains", where, "Each axis carries the workpiece or the tool, once."
            )
    axes = {}
    for name in AXES:
        axis = owners.get(name)
        if name not in chain:
            raise Refused(
                f"the chain does not connect: axis {name} is in neither chain",
                where,
                "Name it in WorkpieceChain or ToolChain, from the bed outwards.",
            )
        if axis is None:
            raise Refused(
                f"the chain does not connect: axis {name} has no axis object",
                where,
                f"Add axis {name} and its carriage.",
            )
        if not parts[name]:
            raise Refused(
                f"the chain does not connect: {axis.Label!r} has no carriage", where, "Choose the parts that it moves."
            )
        axes[name] = axis
    return axes


def upstream(machine, body: str) -> tuple[int, list[str]]:
    """(sign, axes whose positions displace the body): +1 on the tool side, -1 on the workpiece side."""
    if body == "F":
        return 1, []
    for sign, chain, end in ((1, list(machine.ToolChain), "T"), (-1, list(machine.WorkpieceChain), "W")):
        if body == end:
            return sign, chain
        if body in chain:
            return sign, chain[: chain.index(body) + 1]
    return 1, []


def check_nesting(machine, index, parts=None) -> None:
    """Refuse a part inside the container of a body that does not carry it."""
    for body, group in (all_parts(machine) if parts is None else parts).items():
        for where in group:
            holder = lookup(index, where.key[:-1])
            if holder is None or holder == body:
                continue
            carriers = ["F", *upstream(machine, body)[1]] + ([body] if body in "TW" else [])
            if holder not in carriers:
                raise Refused(
                    f"{where.label!r} of {body_label(machine, body)} stands inside a part of "
                    f"{body_label(machine, holder)}, which does not carry it",
                    machine.Label,
                    "Move it out of that container in the tree, or correct the chains.",
                )


# -- the survey ------------------------------------------------------------------------------------------------------
@dataclass(frozen=True)
class Survey:
    """What the placements say: the core machine at home, where things come from, which sources stand by themselves."""

    core: Machine
    position: np.ndarray  # (3,) where the parts stand
    direction_from: dict[str, str]
    reference_from: dict[str, str]
    index: dict[tuple, str]
    loose: tuple[tuple[Place, str], ...]  # (source, body that names it)
    owners: dict[str, object]  # X, Y, Z, T, W -> axis or body object
    parts: dict[str, list[Place]]  # F, X, Y, Z, T, W -> where its parts stand
    directions: dict[str, App.Vector]  # unit vectors of the axes


def directions(machine, axes, parts=None) -> tuple[dict[str, App.Vector], dict[str, str]]:
    """Unit direction of every axis and what it was taken from."""
    found, words = {}, {}
    for name, axis in axes.items():
        carriage = parts_of(machine, name) if parts is None else parts[name]
        source = place(axis.DirectionSource) if axis.DirectionSource else carriage[0]
        try:
            if joints.is_joint(source.object):
                vector, words[name] = joints.direction(source), f"slider {source.object.Label}"
            else:
                vector, words[name] = geometry.direction(source, axis.DirectionAlong, name)
        except Refused as error:
            raise error.at(axis.Label) from None
        found[name] = vector * (-1.0 if axis.Reverse else 1.0)
        if axis.Reverse:
            words[name] += ", reversed"
    return found, words


def displacement(machine, body: str, u: dict[str, App.Vector], q: dict[str, float]) -> App.Vector:
    """How far a body stands from home at position q (axis name -> mm)."""
    sign, axes = upstream(machine, body)
    total = App.Vector()
    for name in axes:
        total += u[name] * (sign * q[name])
    return total


def stands_at(machine, owners=None, parts=None) -> dict[str, float]:
    """Axis name -> position at which its parts stand: as jogged, or as the slider of an assembly stands."""
    owners = bodies(machine) if owners is None else owners
    found = {}
    for name in AXES:
        axis = owners.get(name)
        if axis is not None:
            slid = joints.position(machine, axis, parts_of(machine, name) if parts is None else parts[name])
            found[name] = float(axis.StandsAt) if slid is None else slid
    return found


def current_position(machine) -> np.ndarray:
    """(3,) the position of X, Y, Z at which the parts stand."""
    found = stands_at(machine)
    return np.array([found.get(name, 0.0) for name in AXES])


def survey(machine) -> Survey:
    """Read the placements; refuses, naming the objects, what is no serial three-axis machine."""
    if kind_of(machine) != "Machine":
        raise Refused(f"{machine.Label!r} is no machine", machine.Label, "Select a machine.")
    owners = bodies(machine)
    parts = all_parts(machine, owners)
    axes = check_chains(machine, owners, parts)
    index = part_index(machine, parts)
    check_nesting(machine, index, parts)
    u, direction_from = directions(machine, axes, parts)
    q = stands_at(machine, owners, parts)
    loose, points, reference_from = [], {}, {}

    def home(source: Place, vector: App.Vector, named_by: str):
        owner = source_owner(index, source)
        if owner is None:
            loose.append((source, named_by))
            owner = named_by
        return numbers(vector - displacement(machine, owner, u, q))

    for body in ("X", "Y", "Z", "T", "W"):
        owner = owners.get(body)
        if owner is None or not (owner.ReferenceSource or parts[body]):
            continue
        try:
            if owner.ReferenceSource:
                source = place(owner.ReferenceSource)
                if joints.is_joint(source.object):
                    side = joints.carried_side(source, parts[body])
                    vector, words = joints.frame(source, side).Base, f"joint {source.object.Label}"
                else:
                    vector, words = geometry.point(source, owner.ReferenceAt)
            else:
                source, vector, words = _own_reference(parts[body], owner.ReferenceAt)
        except Refused as error:
            raise error.at(owner.Label) from None
        points[body], reference_from[body] = home(source, vector, body), words
    if not machine.ToolPoint:
        raise Refused(
            "the tool point is missing", machine.Label, "Choose a coordinate system, vertex or edge at the tool's tip."
        )
    source = place(machine.ToolPoint)
    vector, _ = geometry.point(source, "Automatic")
    core = _core(machine, axes, u, direction_from, points, home(source, vector, "T"))
    offsets = {name: numbers(axis.ReferenceOffset) for name, axis in axes.items() if axis.ReferenceOffset.Length > 0}
    if offsets:
        core = with_offsets(core, offsets)
        reference_from |= {name: reference_from[name] + ", moved" for name in offsets}
    position = np.array([q[name] for name in AXES])
    return Survey(core, position, direction_from, reference_from, index, tuple(loose), owners, parts, u)


def with_offsets(core: Machine, offsets: dict[str, tuple[float, float, float]]) -> Machine:
    """The machine with the reference points (scales) of some axes moved: axis -> mm along the machine's X, Y, Z."""
    joints = list(core.joints)
    for i, joint in enumerate(joints):
        if joint.name in offsets:
            moved = np.array(joint.point) + core.frame @ np.array(offsets[joint.name], dtype=float)
            joints[i] = replace(joint, point=tuple(moved.tolist()))
    return replace(core, joints=tuple(joints))


def _own_reference(parts, at):
    if at == "Placement":
        return parts[0], parts[0].placement.Base, f"placement of {parts[0].object.Label}"
    found = geometry.centre_of_mass(parts)
    if found is not None:
        return parts[0], found, "centre of mass of " + ", ".join(p.object.Label for p in parts)
    return parts[0], *geometry.point(parts[0], at)


def _core(machine, axes, u, direction_from, points, tool_point) -> Machine:
    described = {}
    for name, axis in axes.items():
        travel = (axis.TravelLower.Value, axis.TravelUpper.Value)
        try:
            described[name] = linear(name, numbers(u[name]), points[name], travel)
        except Refused as error:
            raise error.at(axis.Label) from None
    try:
        return Machine(
            name=machine.Label,
            workpiece_chain=tuple(machine.WorkpieceChain),
            tool_chain=tuple(machine.ToolChain),
            joints=described,
            tool_point=tool_point,
            spindle_reference=points.get("T"),
            workpiece_reference=points.get("W"),
            squareness=machine.Squareness,
            tolerances=read_tolerances(machine),
            declared=_declared(machine),
            fitted=_fitted(machine),
            effects=tuple(core_effect(e) for e in effects_of(machine)),
            extra=_json(machine, "Extra", {}),
        )
    except Refused as error:
        if "direction" in error.where:  # name the objects that the directions come from
            named = [n for n in AXES if n in error.where.split("direction")[0].replace(",", " ").split()]
            sources = "; ".join(f"{axes[n].Label}: {direction_from[n]}" for n in named)
            raise Refused(f"{error.what} ({sources})", machine.Label, error.do) from None
        raise error.at(machine.Label) from None


def _fitted(machine):
    from ..formats import fitted_json

    return fitted_json.loads(machine.Fitted, f"{machine.Label}, Fitted")


def _declared(machine) -> dict[str, int]:
    try:
        return {symbol: int(degree) for symbol, degree in dict(machine.Declared).items()}
    except ValueError:
        raise Refused("a degree in Declared is no whole number", machine.Label, "Write 0, 1, 2 or 3.") from None


def _json(obj, name, default):
    text = getattr(obj, name)
    if not text:
        return default
    try:
        return json.loads(text)
    except ValueError:
        raise Refused(f"{name} holds no JSON", obj.Label, "Fit or import it again.") from None


def core_effect(obj) -> Effect:
    """The core's Effect of an effect object."""
    parameters = _json(obj, "Parameters", {})
    return Effect(obj.Label, obj.Component, obj.Driver, obj.Shape, parameters, bool(obj.Enabled))


# -- what the rest of the program asks for ---------------------------------------------------------------------------
def core_machine(machine) -> Machine:
    """The machine with all axes at home, in document coordinates, mm; refuses with the names of the objects."""
    return survey(machine).core


def objective(machine) -> objectives.Objective:
    """What is judged, as set on the machine."""
    try:
        return objectives.objective(machine.Output, numbers(machine.Weights), bool(machine.Signed))
    except Refused as error:
        raise error.at(machine.Label) from None


def positions(machine, core: Machine) -> workspace.Positions:
    """Where the indices are taken, as set on the machine."""
    try:
        if machine.Aggregate == "at":
            return workspace.at(core, numbers(machine.At))
        if machine.Aggregate == "grid":
            return workspace.grid(core, machine.Grid)
        return workspace.quadrature(core, machine.Order)
    except Refused as error:
        raise error.at(machine.Label) from None
