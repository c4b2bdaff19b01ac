# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moving the axes: a carriage and all that it carries, in one go, always computed from where the parts stand at home.

A tool-side body moves by +q u, a workpiece-side one by -q u.  Parts that something else drives (an expression, an
attachment, a joint) are refused and nothing moves.  The caller opens the transaction.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import FreeCAD as App

from ..core.errors import AXES
from ..messages import Refused
from .extract import check_chains, displacement, survey
from .paths import Place
from .tree import lookup, owner_machine

CLOSE = 1e-7  # mm: a part this close to where jogging left it has not been moved by hand


def jog(machine, position: dict[str, float]) -> dict[str, float]:
    """Drive the named axes to `position` (mm); returns the position of all three.  Refuses before anything moves."""
    found = survey(machine)
    axes = {name: found.owners[name] for name in AXES}
    old = dict(zip(AXES, found.position.tolist()))
    new = old | {name: _within_travel(axes, name, value) for name, value in position.items()}
    steps = _steps(machine, found, old, new)
    homes = dict(zip(machine.HomeObjects, machine.HomePlacements))
    away_names, away_placements = [], []
    for step in steps:
        home = _home(step, homes.get(step.obj.Name))
        target = App.Placement(home.Base + step.new, home.Rotation)
        if not _coincide(step.obj.Placement, target, 0.0):
            step.obj.Placement = target
        if step.new.Length > 0:
            away_names.append(step.obj.Name)
            away_placements.append(home)
    machine.HomeObjects = away_names
    machine.HomePlacements = away_placements
    for name, axis in axes.items():
        axis.StandsAt = float(new[name])
        if axis.Position.Value != new[name]:
            axis.Position = float(new[name])
    machine.touch()
    return new


def home(machine) -> None:
    """All axes to 0 (or the end of travel next to it)."""
    axes = check_chains(machine)
    jog(machine, {n: min(max(0.0, a.TravelLower.Value), a.TravelUpper.Value) for n, a in axes.items()})


def position_edited(axis) -> None:
    """Answer a new Position: jog there, or say why not and put the old one back."""
    value = axis.Position.Value
    machine = owner_machine(axis)
    if machine is None or value == axis.StandsAt or getattr(axis.Document, "Recomputing", False):
        return
    try:
        jog(machine, {axis.Axis: value})
    except Refused as error:
        axis.Position = float(axis.StandsAt)
        App.Console.PrintError(f"{error.message}\n")


def _within_travel(axes, name, value) -> float:
    if name not in AXES:
        raise Refused(f"unknown axis {name!r}", "jog", "Axes are X, Y and Z.")
    axis, value = axes[name], float(value)
    low, high = axis.TravelLower.Value, axis.TravelUpper.Value
    if not (math.isfinite(value) and low - CLOSE <= value <= high + CLOSE):
        raise Refused(
            f"{value:g} mm is outside the travel {low:g} to {high:g} mm", axis.Label, "Stay inside the travel."
        )
    return value


@dataclass(frozen=True)
class _Step:
    """One object with its displacement from home, old and new, in the coordinates its Placement is written in."""

    obj: App.DocumentObject
    old: App.Vector
    new: App.Vector


def _steps(machine, found, old, new) -> list[_Step]:
    riders = [(where, body) for body, parts in found.parts.items() for where in parts]
    shifts = {body: [displacement(machine, body, found.directions, q) for q in (old, new)] for body in found.parts}
    known = dict(found.index)
    for source, body in found.loose:
        whole = Place(source.root, source.path)
        other = known.setdefault(whole.key, body)
        if other != body:
            raise Refused(
                f"{whole.label!r} is a reference of {other} and of {body} but part of neither",
                machine.Label,
                "Make it part of one body, or give each body its own reference.",
            )
        riders.append((whole, body))
    steps = {}
    for where, body in riders:
        carrier = lookup(known, where.key[:-1]) or "F"
        if body == carrier:
            continue
        turn = where.parent_placement.Rotation.inverted()
        shift = [turn.multVec(own - carried) for own, carried in zip(shifts[body], shifts[carrier])]
        if shift[0] == shift[1]:
            if shift[0].Length == 0:
                continue
        else:
            _check_movable(machine, where)
        steps[where.key] = _Step(where.object, *shift)
    return list(steps.values())


def _home(step: _Step, stored: App.Placement | None) -> App.Placement:
    """Where the object stands at home: as stored, unless it was moved by hand since."""
    now = step.obj.Placement
    if stored is not None:
        expected = App.Placement(stored.Base + step.old, stored.Rotation)
        if _coincide(now, expected, CLOSE):
            return stored
    return App.Placement(now.Base - step.old, now.Rotation)


def _coincide(a: App.Placement, b: App.Placement, tolerance: float) -> bool:
    if (a.Base - b.Base).Length > tolerance:
        return False
    return all(abs(p - q) <= max(tolerance, 1e-12) for p, q in zip(a.Rotation.Q, b.Rotation.Q))


# -- what must not be moved ------------------------------------------------------------------------------------------
def _check_movable(machine, where: Place) -> None:
    obj, label = where.object, where.object.Label
    chain = where.chain

    def refuse(what, do):
        raise Refused(f"{label!r} {what}", machine.Label, do)

    for outer in chain[:-1]:
        if outer.isDerivedFrom("App::Link"):
            refuse(
                f"stands inside the link {outer.Label!r}: moving it would move it in every copy",
                f"Name {outer.Label!r} itself as the carriage, or copy the parts into this machine.",
            )
    if obj.Document != machine.Document:
        refuse("is in another document", "Bring it here with a link, and choose the link.")
    if not hasattr(obj, "Placement"):
        refuse("has no placement", "Choose a part that can be moved.")
    for path, expression in obj.ExpressionEngine:
        if path.lstrip(".").startswith(("Placement", "LinkPlacement", "AttachmentOffset")):
            refuse(f"is driven by the expression {expression!r}", "Remove the expression from its Placement.")
    if getattr(obj, "MapMode", "Deactivated") != "Deactivated":
        refuse("is attached to other geometry", "Detach it, or choose what it is attached to.")
    joint = _joint_of(obj)
    if joint is not None:
        refuse(f"is held by the joint {joint.Label!r}", "Drive it in the assembly, or suppress the joint.")


def _joint_of(obj):
    """An active assembly joint that holds the object, or None."""
    for joint in obj.Document.Objects:
        if hasattr(joint, "ObjectToGround"):
            if joint.ObjectToGround == obj:
                return joint
        elif hasattr(joint, "JointType") and hasattr(joint, "Reference1"):
            if getattr(joint, "Suppressed", False) or not getattr(joint, "Activated", True):
                continue
            for reference in (joint.Reference1, joint.Reference2):
                if reference and _refers(reference, obj):
                    return joint
    return None


def _refers(reference, obj) -> bool:
    root, subs = reference[0], reference[1]
    subs = [subs] if isinstance(subs, str) else subs
    return root == obj or any(obj.Name in sub.split(".")[:-1] for sub in subs)
