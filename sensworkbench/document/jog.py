# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moving the joints: a carriage and all that it carries, in one go, always computed from where the parts are at home.

What a joint does is `kinematics`; here it becomes the Placement of each object.  Parts that something else drives (an
expression, an attachment, a joint of an assembly) are refused and nothing moves.  The caller opens the transaction.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import FreeCAD as App

from ..core.joints import KINDS
from ..messages import Refused
from . import kinematics
from .extract import survey
from .paths import PartPath
from .tree import BED, body_label, lookup, owner_machine

CLOSE = 1e-7  # mm: a part this close to where jogging left it has not been moved by hand


def jog(machine, position: dict[str, float]) -> dict[str, float]:
    """Drive joints to `position` (name -> mm or rad); returns the position of all.  Refuses before anything moves."""
    found = survey(machine)
    new = found.at | checked(found, position)
    steps = _steps(machine, found, new)
    homes = dict(zip(machine.HomeObjects, machine.HomePlacements))
    away_names, away_placements = [], []
    for step in steps:
        home = _home(step, homes.get(step.obj.Name))
        target = kinematics.moved(step.new, home)
        if not _coincide(step.obj.Placement, target, 0.0):
            step.obj.Placement = target
        if not kinematics.is_still(step.new):
            away_names.append(step.obj.Name)
            away_placements.append(home)
    machine.HomeObjects = away_names
    machine.HomePlacements = away_placements
    for joint in found.core.joints:
        axis, shown = found.owners[joint.name], float(joint.to_shown(new[joint.name]))
        axis.StandsAt = shown
        if axis.Position.Value != shown:
            axis.Position = shown
    machine.touch()
    return new


def home(machine) -> None:
    """All joints to 0 (or the end of travel next to it)."""
    joints = survey(machine).core.joints
    jog(machine, {j.name: min(max(0.0, j.span[0]), j.span[1]) for j in joints})


def position_edited(axis) -> None:
    """Answer a new Position: jog there, or say why not and put the old one back."""
    value = axis.Position.Value
    machine = owner_machine(axis)
    if machine is None or value == axis.StandsAt or getattr(axis.Document, "Recomputing", False):
        return
    try:
        jog(machine, {axis.Axis: value * KINDS[axis.Kind].to_internal})
    except Refused as error:
        axis.Position = float(axis.StandsAt)
        App.Console.PrintError(f"{error.message}\n")


def checked(found, position: dict[str, float], close: float = CLOSE) -> dict[str, float]:
    """`position` as numbers; refuses unknown joints and what is outside the travel by more than `close`.

    found : `Survey`.  position : joint name -> mm or rad.
    """
    for name, value in position.items():
        if name not in found.core.names:
            raise Refused("jog-axis-unknown", "jog", axis=str(name), known=list(found.core.names))
        joint = found.core.joint(name)
        low, high = joint.span
        if not (math.isfinite(value) and low - close <= value <= high + close):
            shown = {k: joint.to_shown(float(v)) for k, v in (("value", value), ("low", low), ("high", high))}
            raise Refused("jog-outside-travel", found.owners[name].Label, **shown, unit=joint.unit)
    return {name: float(value) for name, value in position.items()}


@dataclass(frozen=True)
class _Step:
    """One object with its displacement from home, old and new, in the coordinates its Placement is written in."""

    obj: App.DocumentObject
    old: App.Placement
    new: App.Placement


def _steps(machine, found, new) -> list[_Step]:
    riders = [(where, body) for body, parts in found.parts.items() for where in parts]
    before, after = found.displacements, kinematics.of_machine(found.core, new)
    known = dict(found.index)
    for source, body in found.loose:
        whole = PartPath(source.root, source.path)
        other = known.setdefault(whole.key, body)
        if other != body:
            labels = [body_label(machine, b, found.owners) for b in (other, body)]
            raise Refused("jog-reference-of-two", machine.Label, part=whole.label, one=labels[0], other=labels[1])
        riders.append((whole, body))
    steps = {}
    for where, body in riders:
        carrier = lookup(known, where.key[:-1]) or BED
        if body == carrier:
            continue
        container = kinematics.moved_back(before[carrier], where.parent_placement)  # with all joints at 0
        old, now = (
            kinematics.seen_from(kinematics.relative(at[body], at[carrier]), container) for at in (before, after)
        )
        if _coincide(old, now, 0.0):
            if kinematics.is_still(old):
                continue
        else:
            _check_movable(machine, where)
        steps[where.key] = _Step(where.object, old, now)
    return list(steps.values())


def _home(step: _Step, stored: App.Placement | None) -> App.Placement:
    """Where the object is at home: as stored, unless it was moved by hand since."""
    now = step.obj.Placement
    if stored is not None and _coincide(now, kinematics.moved(step.old, stored), CLOSE):
        return stored
    return kinematics.moved_back(step.old, now)


def _coincide(a: App.Placement, b: App.Placement, tolerance: float) -> bool:
    if (a.Base - b.Base).Length > tolerance:
        return False
    return all(abs(p - q) <= max(tolerance, 1e-12) for p, q in zip(a.Rotation.Q, b.Rotation.Q))


# -- what must not be moved ------------------------------------------------------------------------------------------
def _check_movable(machine, where: PartPath) -> None:
    obj, label = where.object, where.object.Label
    chain = where.chain

    def refuse(code, **fields):
        return Refused(code, machine.Label, part=label, **fields)

    for outer in chain[:-1]:
        if outer.isDerivedFrom("App::Link"):
            raise refuse("jog-part-inside-link", link=outer.Label)
    if obj.Document != machine.Document:
        raise refuse("jog-part-in-another-document")
    if not hasattr(obj, "Placement"):
        raise refuse("jog-part-without-placement")
    for path, expression in obj.ExpressionEngine:
        if path.lstrip(".").startswith(("Placement", "LinkPlacement", "AttachmentOffset")):
            raise refuse("jog-part-driven-by-expression", expression=expression)
    if getattr(obj, "MapMode", "Deactivated") != "Deactivated":
        raise refuse("jog-part-attached")
    joint = _joint_of(obj)
    if joint is not None:
        raise refuse("jog-part-held-by-joint", joint=joint.Label)


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
