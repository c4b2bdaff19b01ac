# SPDX-License-Identifier: LGPL-2.1-or-later
"""Jogging a machine whose carriages are held by slider joints: what a drag along the sliders does, to given positions.

The parts of a carriage, and all that it carries, move together along the slider; the assembly is solved then, and where
the sliders do not stand as asked everything goes back.  The caller opens the transaction.
"""

from __future__ import annotations

import math

import FreeCAD as App

from ..core.errors import AXES
from ..messages import Refused
from . import joints
from .extract import check_chains, directions, displacement, stands_at, survey
from .paths import Place
from .tree import axis_of, lookup

CLOSE = 1e-6  # mm


def held_by_sliders(machine) -> bool:
    """Whether all three axes take their direction from slider joints."""
    axes = [axis_of(machine, name) for name in AXES]
    return all(axis is not None and joints.joint_place(axis.DirectionSource) is not None for axis in axes)


def drive(machine, position: dict[str, float]) -> dict[str, float]:
    """Drive the named axes to `position` (mm) along their sliders; returns the position of all three.

    Refuses a position outside the travel, parts inside links, and what the assembly does not follow; the parts stand
    where they stood then.
    """
    axes, old = check_chains(machine), stands_at(machine)
    for name, value in position.items():
        low, high = axes[name].TravelLower.Value, axes[name].TravelUpper.Value
        if not (math.isfinite(value) and low - CLOSE <= value <= high + CLOSE):
            raise Refused(
                f"{value:g} mm is outside the travel {low:g} to {high:g} mm",
                axes[name].Label,
                "Stay inside the travel.",
            )
    new = old | {name: float(value) for name, value in position.items()}
    moves = _moves(machine, old, new)
    before = [(obj, App.Placement(obj.Placement)) for obj, _ in moves]
    for obj, shift in moves:
        obj.Placement = App.Placement(obj.Placement.Base + shift, obj.Placement.Rotation)
    solved = all(assembly.solve() == 0 for assembly in _assemblies(machine))
    stands = stands_at(machine)
    if solved and all(abs(stands[name] - new[name]) < CLOSE for name in AXES):
        machine.touch()
        return new
    for obj, placement in before:
        obj.Placement = placement
    off = [name for name in AXES if not abs(stands[name] - new[name]) < CLOSE] or list(AXES)
    labels = ", ".join(joints.joint_place(axes[name].DirectionSource).object.Label for name in off)
    raise Refused(
        f"the assembly does not let {labels} go to this position",
        machine.Label,
        "Look at the limits of its joints and at other joints that hold the carriage, or drag it in the assembly.",
    )


def _moves(machine, old, new) -> list[tuple]:
    """(object, shift in the coordinates that its Placement is written in) of all that has to move."""
    found = survey(machine)
    u, _ = directions(machine, check_chains(machine))
    riders = [(where, body) for body, parts in found.parts.items() for where in parts]
    riders += [(Place(source.root, source.path), body) for source, body in found.loose
               if not joints.is_joint(source.object)]  # fmt: skip
    known = {where.key: body for where, body in riders}
    moves = {}
    for where, body in riders:
        inner = lookup(known, where.key[:-1]) or "F"
        shift = _shift(machine, body, u, old, new) - _shift(machine, inner, u, old, new)
        if shift.Length == 0:
            continue
        link = next((o for o in where.chain[:-1] if o.isDerivedFrom("App::Link")), None)
        if link is not None or where.object.Document != machine.Document:
            raise Refused(
                f"{where.label!r} stands inside a link: its joints are in another assembly", machine.Label,
                "Drag it there, or make the link flexible.",
            )  # fmt: skip
        ground = next(
            (o for o in where.object.InList if joints.is_ground(o) and o.ObjectToGround == where.object), None
        )
        if ground is not None and joints.is_active(ground):
            raise Refused(
                f"{where.label!r} is grounded by {ground.Label!r}", machine.Label, "Ground the bed alone."
            )  # fmt: skip
        moves[where.key] = (where.object, where.parent_placement.Rotation.inverted().multVec(shift))
    return list(moves.values())


def _shift(machine, body: str, u, old, new) -> App.Vector:
    return displacement(machine, body, u, new) - displacement(machine, body, u, old)


def _assemblies(machine) -> list:
    """The assemblies whose sliders give the axes, each once."""
    found = {}
    for name in AXES:
        home = joints.home_of(joints.joint_place(axis_of(machine, name).DirectionSource).object)
        if hasattr(home, "solve"):
            found[home.Name] = home
    return list(found.values())
