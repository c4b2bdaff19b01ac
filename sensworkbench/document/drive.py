# SPDX-License-Identifier: LGPL-2.1-or-later
"""Jogging a machine whose carriages are held by slider joints: what a drag along the sliders does, to given positions.

The parts of a carriage, and all that it carries, move together along the slider; the assembly is solved then, and where
the sliders are not as asked everything goes back.  The caller opens the transaction.
"""

from __future__ import annotations

import FreeCAD as App

from ..messages import Refused
from . import joints, kinematics
from .extract import stands_at, survey
from .jog import checked
from .paths import PartPath
from .tree import BED, bodies, joint_names, lookup

CLOSE = 1e-6  # mm


def held_by_sliders(machine) -> bool:
    """Whether all axes take their direction from slider joints."""
    owners = bodies(machine)
    names = joint_names(owners)
    return bool(names) and all(joints.joint_place(owners[n].DirectionSource) is not None for n in names)


def drive(machine, position: dict[str, float]) -> dict[str, float]:
    """Drive joints to `position` (name -> mm) along their sliders; returns the position of all.

    Refuses a position outside the travel, parts inside links, and what the assembly does not follow; the parts are
    where they were then.
    """
    found = survey(machine)
    new = found.at | checked(found, position, CLOSE)
    moves = _moves(machine, found, new)
    before = [(obj, App.Placement(obj.Placement)) for obj, _ in moves]
    for obj, move in moves:
        obj.Placement = kinematics.moved(move, obj.Placement)
    sliders = {name: joints.joint_place(found.owners[name].DirectionSource) for name in found.core.names}
    solved = all(assembly.solve() == 0 for assembly in _assemblies(sliders))
    stands = stands_at(machine)
    off = [name for name in new if not abs(stands[name] - new[name]) < CLOSE]
    if solved and not off:
        machine.touch()
        return new
    for obj, placement in before:
        obj.Placement = placement
    names = [sliders[name].object.Label for name in off or new]
    raise Refused("drive-not-followed", machine.Label, joints=names)


def _moves(machine, found, new) -> list[tuple]:
    """(object, motion in the coordinates that its Placement is written in) of all that has to move."""
    riders = [(where, body) for body, parts in found.parts.items() for where in parts]
    riders += [(PartPath(source.root, source.path), body) for source, body in found.loose
               if not joints.is_joint(source.object)]  # fmt: skip
    known = {where.key: body for where, body in riders}
    after = kinematics.of_machine(found.core, new)
    change = {body: kinematics.relative_to_now(after[body], found.displacements[body]) for body in after}
    moves = {}
    for where, body in riders:
        carrier = lookup(known, where.key[:-1]) or BED
        move = kinematics.relative(change[body], change[carrier])
        if kinematics.is_still(move):
            continue
        link = next((o for o in where.chain[:-1] if o.isDerivedFrom("App::Link")), None)
        if link is not None or where.object.Document != machine.Document:
            raise Refused("drive-part-inside-link", machine.Label, part=where.label)
        ground = next(
            (o for o in where.object.InList if joints.is_ground(o) and o.ObjectToGround == where.object), None
        )
        if ground is not None and joints.is_active(ground):
            raise Refused("drive-part-grounded", machine.Label, part=where.label, joint=ground.Label)
        moves[where.key] = (where.object, kinematics.seen_from(move, where.parent_placement))
    return list(moves.values())


def _assemblies(sliders) -> list:
    """The assemblies that hold the sliders, each once.  sliders : joint name -> place of its slider."""
    found = {}
    for where in sliders.values():
        home = joints.home_of(where.object)
        if hasattr(home, "solve"):
            found[home.Name] = home
    return list(found.values())
