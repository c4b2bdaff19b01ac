# SPDX-License-Identifier: LGPL-2.1-or-later
"""Joints of FreeCAD's Assembly workbench as geometry: the parts they connect, their frames, the position of a slider.

Everything is read from the joints' properties along paths, so it needs no Assembly module and is valid for links to
assemblies in other documents.  1.0 writes references from the assembly, 1.1 from the component; both are read.
"""

from __future__ import annotations

import FreeCAD as App

from ..messages import Refused
from .paths import PartPath, _is_folder, place

SLIDER = "Slider"
Z = App.Vector(0, 0, 1)


def is_joint(obj) -> bool:
    """Whether an object is a joint between two parts."""
    return hasattr(obj, "JointType") and hasattr(obj, "Reference1") and hasattr(obj, "Placement1")


def is_ground(obj) -> bool:
    """Whether an object grounds a part."""
    return hasattr(obj, "ObjectToGround")


def is_active(obj) -> bool:
    """Neither suppressed (1.1) nor deactivated (1.0)."""
    return not getattr(obj, "Suppressed", False) and getattr(obj, "Activated", True)


def is_assembly(obj) -> bool:
    """Whether an object is an assembly or a link to one."""
    return obj is not None and obj.TypeId in ("Assembly::AssemblyObject", "Assembly::AssemblyLink")


def linked(obj):
    """What a link leads to in the end, else the object itself."""
    return (obj.getLinkedObject(True) if hasattr(obj, "getLinkedObject") else obj) or obj


def home_of(joint):
    """The assembly that holds a joint; refuses a joint that is nowhere."""
    outer = joint.getParentGeoFeatureGroup() if hasattr(joint, "getParentGeoFeatureGroup") else None
    if outer is None:
        outer = next((o for o in joint.InListRecursive if is_assembly(o)), None)
    if outer is None:
        raise Refused("assembly-joint-alone", joint.Label, joint=joint.Label)
    return outer


def reference(joint, side: int) -> PartPath:
    """The geometry that side 1 or 2 of a joint refers to, as a place in the assembly's own document."""
    value = getattr(joint, f"Reference{side}")
    if not value or value[0] is None or not value[1]:
        raise Refused("assembly-joint-lost-part", joint.Label, joint=joint.Label, side=side)
    found = place((value[0], value[1][0] if not isinstance(value[1], str) else value[1]))
    names = [n for n in found.path.split(".") if n]
    for i, obj in enumerate(found.chain):
        if obj.isDerivedFrom("PartDesign::Body"):  # a feature of a body counts as the body
            return PartPath(found.root, ".".join(names[:i]) + "." if i else "")
    return found


def below(where: PartPath, assembly) -> str:
    """The part of a place's path below `assembly`."""
    names = [n for n in where.path.split(".") if n]
    for i, obj in enumerate(where.chain):
        if obj == assembly or linked(obj) == assembly:
            return "".join(f"{n}." for n in names[i:])
    raise Refused("assembly-part-elsewhere", assembly.Label, part=where.label, assembly=assembly.Label)


def assembly_place(where: PartPath) -> PartPath:
    """Return the assembly occurrence that contains the joint at `where`."""
    names = [n for n in where.path.split(".") if n][:-1]
    chain = where.chain[:-1]
    while chain and _is_folder(chain[-1]):
        chain.pop()
        names.pop()
    return PartPath(where.root, "".join(f"{n}." for n in names))


def frame(where: PartPath, side: int) -> App.Placement:
    """Frame of side 1 or 2 of the joint at `where`, document coordinates.  Its z is the axis of a slider."""
    joint = where.object
    at = reference(joint, side)
    assembly = home_of(joint)
    outer = place((assembly, "")).placement
    inner = outer.inverse() * PartPath(at.root, at.path).placement * getattr(joint, f"Placement{side}")
    return assembly_place(where).placement * inner


def distance(where: PartPath) -> float:
    """Return the signed distance of side 2 of the slider at `where` from side 1 along the slider's axis, mm."""
    return (frame(where, 1).inverse() * frame(where, 2)).Base.z


def direction(where: PartPath) -> App.Vector:
    """Unit vector of the slider at `where`, document coordinates; refuses a joint that is no slider."""
    joint = where.object
    if joint.JointType != SLIDER:
        raise Refused("assembly-joint-no-slider", joint.Label, joint=joint.Label, kind=joint.JointType)
    if not is_active(joint):
        raise Refused("assembly-joint-off", joint.Label, joint=joint.Label)
    return frame(where, 1).Rotation.multVec(Z)


def carried_side(where: PartPath, parts: list[PartPath]) -> int:
    """Which side of the joint at `where` moves with `parts` (a carriage): 1 or 2."""
    joint, outer = where.object, assembly_place(where)
    keys = [p.key for p in parts]
    for side in (2, 1):
        path = outer.path + below(reference(joint, side), home_of(joint))
        key = PartPath(outer.root, path).key
        if any(key[: len(k)] == k for k in keys):
            return side
    raise Refused("assembly-joint-of-another", joint.Label, joint=joint.Label)


def joint_place(source) -> PartPath | None:
    """The place of the joint that a DirectionSource or ReferenceSource names, or None where it names something else."""
    found = place(source) if source else None
    return found if found is not None and not found.element and is_joint(found.object) else None


def position(machine, axis, parts: list[PartPath]) -> float | None:
    """Return the position of the slider that gives an axis its direction, in the axis's own sense, mm; None without
    a slider.
    """
    where = joint_place(axis.DirectionSource)
    if where is None:
        return None
    sense = 1.0 if carried_side(where, parts) == 2 else -1.0
    if axis.Reverse:
        sense = -sense
    if axis.Axis in list(machine.WorkpieceChain):
        sense = -sense
    return sense * distance(where) + 0.0
