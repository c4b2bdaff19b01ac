# SPDX-License-Identifier: LGPL-2.1-or-later
"""Placements -> lever arms: what the core needs to know of a machine, taken from where its parts are.

The parts may be away from home (`StandsAt` of each axis): every body is displaced by the motions of the joints up to
it, and home is where it would be with all joints at 0.  Coordinates are the document's, mm.
"""

from __future__ import annotations

import json
import math
from dataclasses import dataclass, replace
from functools import cached_property

import FreeCAD as App
import numpy as np

from ..core import workspace
from ..core.effects import Effect
from ..core.errors import component
from ..core.joints import KINDS, LINEAR, Joint
from ..core.machine import Machine, check_chains
from ..core.objectives import Objective
from ..formats import effects_json, fitted_json, sources_json
from ..messages import Message, Refused
from . import geometry, joints, told
from .base import kind_of, made_by_newer, numbers
from .kinematics import displacements, is_shift, motion, moved_back
from .paths import PartPath, place
from .tables import read_tolerances
from .tree import (
    BED,
    ENDS,
    all_parts,
    bodies,
    body_label,
    effects_of,
    joint_names,
    lookup,
    part_index,
)


# -- who carries what ------------------------------------------------------------------------------------------------
def source_owner(index, source: PartPath) -> str | None:
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
def chain_axes(machine, owners, parts) -> dict[str, object]:
    """Joint name -> axis object; refuses chains that do not fit the axis objects, and axes without a carriage.

    owners, parts : what `tree.bodies` and `tree.all_parts` returned.
    """
    names = joint_names(owners)
    workpiece_chain, tool_chain = tuple(machine.WorkpieceChain), tuple(machine.ToolChain)
    for name in workpiece_chain + tool_chain:
        if name not in names:
            raise Refused("axis-object-missing", machine.Label, axis=name)
    check_chains(names, workpiece_chain, tool_chain, machine.Label)
    axes = {name: owners[name] for name in names}
    for name, axis in axes.items():
        if axis.Kind != LINEAR.name:
            raise Refused("axis-kind-not-in-documents", machine.Label, axis=axis.Label, kind=axis.Kind)
        if not parts[name]:
            raise Refused("axis-without-carriage", machine.Label, axis=axis.Label)
    return axes


def carriers_of(machine, body: str) -> list[str]:
    """The bodies that carry a body, itself among them, from the bed outwards."""
    for chain, end in ((list(machine.ToolChain), "T"), (list(machine.WorkpieceChain), "W")):
        if body == end:
            return [BED, *chain, end]
        if body in chain:
            return [BED, *chain[: chain.index(body) + 1]]
    return [BED]


def check_nesting(machine, index, parts, owners) -> None:
    """Refuse a part inside the container of a body that does not carry it."""
    for body, group in parts.items():
        for where in group:
            holder = lookup(index, where.key[:-1])
            if holder is not None and holder != body and holder not in carriers_of(machine, body):
                labels = {k: body_label(machine, b, owners) for k, b in (("body", body), ("holder", holder))}
                raise Refused("part-inside-another-body", machine.Label, part=where.label, **labels)


# -- the survey ------------------------------------------------------------------------------------------------------
@dataclass(frozen=True)
class Survey:
    """What the placements say at one moment: the core machine at home, and where everything comes from.

    Made once for each change and handed to whoever needs it; `refresh.latest` gives the last one.
    """

    core: Machine
    position: np.ndarray  # (n,) positions at which the parts are, mm or rad, in the order of core.names
    direction_from: dict[str, Message]
    reference_from: dict[str, Message]
    index: dict[tuple, str]  # occurrence of a part -> its body
    loose: tuple[tuple[PartPath, str], ...]  # (source that belongs to no part, body that names it)
    owners: dict[str, object]  # joint name, T, W -> axis or body object
    parts: dict[str, list[PartPath]]  # F, joint names, T, W -> the occurrences of its parts
    displacements: dict[str, App.Placement]  # F, joint names, T, W -> motion from home to where it is

    @cached_property
    def arms(self) -> dict[str, np.ndarray]:
        """(1, 3) lever arm of every body at `position`, machine frame, mm."""
        return self.core.lever_arms([self.position])

    @cached_property
    def home_arms(self) -> dict[str, np.ndarray]:
        """(1, 3) lever arm of every body with all joints at 0, machine frame, mm."""
        return self.core.lever_arms([[0.0] * len(self.core.joints)])

    @property
    def at(self) -> dict[str, float]:
        """Joint name -> position at which its parts are, mm or rad."""
        return dict(zip(self.core.names, self.position.tolist()))


@dataclass(frozen=True)
class _Found:
    """A direction or point where it is now, in document coordinates: source, value, and what it was taken from."""

    source: PartPath
    value: App.Vector
    words: Message


def _direction(axis, name: str, parts) -> _Found:
    """Unit direction of positive motion of an axis.  parts : of its carriage."""
    source = place(axis.DirectionSource) if axis.DirectionSource else parts[0]
    try:
        if joints.is_joint(source.object):
            vector, words = joints.direction(source), Message("from-slider", joint=source.object.Label)
        else:
            vector, words = geometry.direction(source, axis.DirectionAlong, name)
    except Refused as error:
        raise error.at(axis.Label) from None
    if axis.Reverse:
        return _Found(source, vector * -1.0, Message("from-reversed", what=words))
    return _Found(source, vector * 1.0, words)


def _reference(owner, parts) -> _Found:
    """Reference point of an axis or body object.  parts : its parts."""
    try:
        if not owner.ReferenceSource:
            return _Found(*_own_reference(parts, owner.ReferenceAt))
        source = place(owner.ReferenceSource)
        if joints.is_joint(source.object):
            side = joints.carried_side(source, parts)
            return _Found(source, joints.frame(source, side).Base, Message("from-joint", joint=source.object.Label))
        return _Found(source, *geometry.point(source, owner.ReferenceAt))
    except Refused as error:
        raise error.at(owner.Label) from None


def stands_at(machine, owners=None, parts=None) -> dict[str, float]:
    """Joint name -> position of its parts, mm or rad: as jogged, or as the slider of an assembly is."""
    owners = bodies(machine) if owners is None else owners
    parts = all_parts(machine, owners) if parts is None else parts
    found = {}
    for name in joint_names(owners):
        axis = owners[name]
        slid = joints.position(machine, axis, parts[name])
        if slid is None and not math.isfinite(axis.StandsAt):
            raise Refused("axis-position-not-finite", axis.Label)
        found[name] = KINDS[axis.Kind].to_internal * float(axis.StandsAt) if slid is None else slid
    return found


def current_position(machine) -> np.ndarray:
    """(n,) the positions of the joints at which the parts are, mm or rad; the order of the core machine's joints."""
    return np.array(list(stands_at(machine).values()))


def survey(machine) -> Survey:
    """Read the placements; refuses, naming the objects, what is not a serial machine."""
    if kind_of(machine) != "Machine":
        raise Refused("document-no-machine-object", machine.Label, name=machine.Label)
    for obj in (machine, *machine.Group):
        if made_by_newer(obj):
            found = {"found": obj.SchemaVersion, "known": obj.Proxy.schema}
            raise Refused("document-newer-schema", obj.Label, name=obj.Label, **found)
    owners = bodies(machine)
    parts = all_parts(machine, owners)
    axes = chain_axes(machine, owners, parts)
    index = part_index(machine, parts, owners)
    check_nesting(machine, index, parts, owners)
    q = stands_at(machine, owners, parts)
    ways = {name: _direction(axis, name, parts[name]) for name, axis in axes.items()}
    references = {
        body: _reference(owners[body], parts[body])
        for body in (*axes, *ENDS)
        if body in owners and (owners[body].ReferenceSource or parts[body])
    }
    at_home = {}

    def step(name, sign, found, carrier):
        """Motion of a joint, from the line along which it moves as that is with all joints at 0."""
        lines = []
        for seen in (ways[name], references[name]):
            owner = source_owner(index, seen.source)
            lines.append(found.get(owner, found[carrier]))  # own, loose or further out: as its carrier
        at_home[name] = _turned_back(lines[0], ways[name].value)
        point = moved_back(lines[1], App.Placement(references[name].value, App.Rotation())).Base
        return motion(KINDS[axes[name].Kind], at_home[name], point, sign * q[name])

    displaced = displacements(machine.WorkpieceChain, machine.ToolChain, step)
    loose = []

    def home(seen: _Found, named_by: str):
        owner = source_owner(index, seen.source)
        if owner is None:
            loose.append((seen.source, named_by))
            owner = named_by
        return numbers(moved_back(displaced[owner], App.Placement(seen.value, App.Rotation())).Base)

    points = {body: home(seen, body) for body, seen in references.items()}
    reference_from = {body: seen.words for body, seen in references.items()}
    direction_from = {name: seen.words for name, seen in ways.items()}
    if not machine.ToolPoint:
        raise Refused("tool-point-missing", machine.Label)
    source = place(machine.ToolPoint)
    tool_point = home(_Found(source, *geometry.point(source, "Automatic")), "T")
    core = _core(machine, axes, at_home, direction_from, points, tool_point)
    offsets = {name: numbers(axis.ReferenceOffset) for name, axis in axes.items()}
    for name, offset in offsets.items():
        if not all(math.isfinite(v) for v in offset):
            raise Refused("reference-offset-not-finite", axes[name].Label, value=str(list(offset)))
    for name, offset in offsets.items():
        if any(offset):
            try:
                core = with_offsets(core, {name: offset})
            except Refused as error:
                raise error.at(axes[name].Label) from None
            reference_from[name] = Message("from-moved", what=reference_from[name])
    position = np.array([q[name] for name in core.names])
    return Survey(core, position, direction_from, reference_from, index, tuple(loose), owners, parts, displaced)


def _turned_back(motion: App.Placement, vector: App.Vector) -> App.Vector:
    return vector if is_shift(motion) else motion.Rotation.inverted().multVec(vector)


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
        return parts[0], parts[0].placement.Base, Message("from-placement", object=parts[0].object.Label)
    found = geometry.centre_of_mass(parts)
    if found is not None:
        return parts[0], found, Message("from-centre-of-mass", objects=[p.object.Label for p in parts])
    return parts[0], *geometry.point(parts[0], at)


def _core(machine, axes, directions, direction_from, points, tool_point) -> Machine:
    described = []
    for name, axis in axes.items():
        kind = KINDS[axis.Kind]
        travel = tuple(kind.to_internal * limit.Value for limit in (axis.TravelLower, axis.TravelUpper))
        try:
            described.append(Joint(name, kind, numbers(directions[name]), points[name], travel))
        except Refused as error:
            raise error.at(axis.Label) from None
    try:
        core = Machine(
            name=machine.Label,
            workpiece_chain=tuple(machine.WorkpieceChain),
            tool_chain=tuple(machine.ToolChain),
            joints=tuple(described),
            tool_point=tool_point,
            spindle_reference=points.get("T"),
            workpiece_reference=points.get("W"),
            squareness=machine.Squareness,
            declared=_declared(machine),
            fitted=_fitted(machine),
            extra=_json(machine, "Extra", {}),
        )
        effects = tuple(core_effect(e, core.component) for e in effects_of(machine))
        sources = sources_json.loads(machine.Sources, f"{machine.Label}, Sources", core)
        return replace(core, tolerances=read_tolerances(machine, core), effects=effects, sources=sources)
    except Refused as error:
        if error.code in DIRECTION_CODES:  # name the objects that the directions come from
            sources = [
                Message("from-of-axis", axis=axes[n].Label, what=direction_from[n])
                for n in (error.fields["a"], error.fields["b"])
            ]
            raise Refused(DIRECTION_CODES[error.code], machine.Label, **error.fields, sources=sources) from None
        raise error.at(machine.Label) from None


DIRECTION_CODES = {"machine-axes-parallel": "directions-parallel", "machine-axes-not-square": "directions-not-square"}


def _fitted(machine):
    return fitted_json.loads(machine.Fitted, f"{machine.Label}, Fitted")


def _declared(machine) -> dict[str, int]:
    found = {}
    for symbol, degree in dict(machine.Declared).items():
        try:
            found[symbol] = int(degree)
        except ValueError:
            raise Refused("declared-degree-not-a-number", machine.Label, symbol=symbol, value=repr(degree)) from None
    return found


def _json(obj, name, default):
    text = getattr(obj, name)
    if not text:
        return default
    try:
        return json.loads(text)
    except ValueError:
        raise Refused("document-no-json", obj.Label, name=name) from None


def core_effect(obj, known=component) -> Effect:
    """The core's Effect of an effect object.  known : look-up of a symbol among the machine's components."""
    parameters = _json(obj, "Parameters", {})
    effect = effects_json.of_parameters(
        obj.Label, obj.Component, obj.Driver, obj.Shape, parameters, obj.Enabled, obj.Label, known
    )
    extent = tuple(obj.Extent)
    if len(extent) not in (0, 2):
        raise Refused("effect-extent-count", f"{obj.Label}, Extent", count=len(extent))
    return replace(effect, extent=extent) if extent else effect


# -- what the rest of the program asks for ---------------------------------------------------------------------------
def core_machine(machine) -> Machine:
    """The machine with all axes at home, in document coordinates, mm; refuses with the names of the objects."""
    return survey(machine).core


def objective(machine) -> Objective:
    """What is judged, as set on the machine."""
    try:
        return told.objective(machine.Objective)
    except Refused as error:
        raise error.at(machine.Label) from None


def positions(machine, core: Machine) -> workspace.Positions:
    """Where the indices are taken, as set on the machine."""
    try:
        if machine.Aggregate == "at":
            return workspace.at(core, list(machine.At) or [0.0] * len(core.joints))
        if machine.Aggregate == "grid":
            return workspace.grid(core, machine.Grid)
        if machine.Aggregate == "low_discrepancy":
            return workspace.low_discrepancy(core)
        return workspace.quadrature(core, machine.Order)
    except Refused as error:
        raise Refused(error.code, f"{machine.Label}, {machine.Aggregate}", **error.fields) from None
