# SPDX-License-Identifier: LGPL-2.1-or-later
"""Assemblies of plain blocks with slider joints that move nothing when they are made, for FreeCAD 1.0 and 1.1."""

from __future__ import annotations

import FreeCAD as App

from .blocks import block, point

V, P, R = App.Vector, App.Placement, App.Rotation
PLACES = {"Bed": (0, 0, -500), "Saddle": (-60, -200, 100), "Table": (30, -180, 200), "Head": (15, 100, 600)}
TIP = (10, -20, -150)
# joint: (inner, outer, origin, direction)
SLIDERS = {
    "Slider Y": ("Bed", "Saddle", (-60, -200, 100), (0, 1, 0)),
    "Slider X": ("Saddle", "Table", (30, -180, 200), (1, 0, 0)),
    "Slider Z": ("Bed", "Head", (15, 100, 600), (0, 0, 1)),
}


def new_assembly(doc, name="Assembly", parent=None):
    if parent is None:
        assembly = doc.addObject("Assembly::AssemblyObject", name)
    else:
        assembly = parent.newObject("Assembly::AssemblyObject", name)
    assembly.Type = "Assembly"
    assembly.newObject("Assembly::JointGroup", "Joints")
    return assembly


def group_of(assembly):
    return next(o for o in assembly.Group if o.TypeId == "Assembly::JointGroup")


def ground(assembly, part):
    import JointObject

    joint = group_of(assembly).newObject("App::FeaturePython", "Grounded")
    JointObject.GroundedJoint(joint, part)
    if App.GuiUp:
        JointObject.ViewProviderGroundedJoint(joint.ViewObject)
    return joint


def reference(assembly, component, inside=""):
    """inside: the path below the component, such as "Part.Box."."""
    import UtilsAssembly

    if hasattr(UtilsAssembly, "getComponentReference"):
        return [component, [inside, inside]]
    return [assembly, [path_of(assembly, component) + inside] * 2]


def path_of(assembly, component) -> str:
    """The path of a component, which may be inside a flexible link."""
    outer = component.getParentGeoFeatureGroup()
    return ("" if outer == assembly else path_of(assembly, outer)) + f"{component.Name}."


def join(assembly, kind, name, one, other, origin=(0, 0, 0), direction=(0, 0, 1), inside=("", "")):
    """A joint at an origin along a direction, in the assembly's coordinates."""
    import JointObject

    joint = group_of(assembly).newObject("App::FeaturePython", "Joint")
    JointObject.Joint(joint, JointObject.JointTypes.index(kind))
    if App.GuiUp:
        JointObject.ViewProviderJoint(joint.ViewObject)
    joint.Label = name
    joint.Detach1 = joint.Detach2 = True
    frame = P(V(*origin), R(V(0, 0, 1), V(*direction)))
    outer = assembly.Placement
    for side, part in enumerate((one, other), 1):
        path = path_of(assembly, part) + inside[side - 1]
        stands = outer.inverse() * assembly.getSubObject(path, retType=3)
        setattr(joint, f"Placement{side}", stands.inverse() * frame)
    joint.Reference1 = reference(assembly, one, inside[0])
    joint.Reference2 = reference(assembly, other, inside[1])
    return joint


def limit(joint, low, high):
    joint.EnableLengthMin = joint.EnableLengthMax = True
    joint.LengthMin, joint.LengthMax = low, high


def slider_machine(doc, assembly=None, parts=None, sliders=SLIDERS, limits=None):
    """The golden machine of `blocks` as an assembly; returns (assembly, parts by name, joints by label)."""
    assembly = assembly or new_assembly(doc)
    parts = dict(parts or {})
    for name, at in PLACES.items():
        if name not in parts:
            parts[name] = block(doc, name, at, parent=assembly)
    doc.recompute()
    ground(assembly, parts["Bed"])
    made = {}
    for name, (one, other, origin, direction) in sliders.items():
        made[name] = join(assembly, "Slider", name, parts[one], parts[other], origin, direction)
        limit(made[name], *(limits or {}).get(name, (-300, 300)))
    doc.recompute()
    return assembly, parts, made


def tip(doc, part_or_assembly):
    return point(doc, "Tip", TIP, part_or_assembly)
