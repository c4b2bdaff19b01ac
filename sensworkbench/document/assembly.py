# SPDX-License-Identifier: LGPL-2.1-or-later
"""A machine out of an assembly: the grounded part is the bed, three sliders are the axes, their order is the chain.

Directions, reference points and positions stay linked to the sliders, so that what the solver moves is followed.
Where there are no sliders the axes are proposed from the geometry (`propose`).
"""

from __future__ import annotations

from itertools import permutations

import FreeCAD as App

from ..core.errors import AXES
from ..core.refusal import Refused
from . import factory, joints
from .assembly_reading import AssemblyModel, Slider, assemblies, read
from .part_names import TOOL_POINT, WORKPIECE_SIDE, axis_letter, guess
from .paths import PartPath, _is_datum, leaves, place

__all__ = ["AssemblyModel", "Slider", "assemblies", "machine_from_assembly", "name_axes", "read", "sides"]

ASSUMED_TRAVEL = 100.0  # mm to either side, where a slider states no limits


def name_axes(reading: AssemblyModel, names: dict | None = None) -> None:
    """Give each slider its axis: as stated (joint or its name -> "X"), by the letter in its name, else by direction."""
    sliders, stated = reading.sliders, {}
    for joint, axis in (names or {}).items():
        stated[getattr(joint, "Name", joint)] = axis
    for slider in sliders:
        joint = slider.joint.object
        slider.axis = stated.get(joint.Name) or stated.get(joint.Label) or ""
    letters = [s.axis or axis_letter(s.joint.object.Label) for s in sliders]
    if sorted(letters) != list(AXES):
        along = [[abs(v) for v in joints.direction(s.joint)] for s in sliders]
        orders = [o for o in permutations(AXES) if all(s.axis in ("", a) for s, a in zip(sliders, o))]
        if not orders:
            raise Refused("assembly-axis-twice", reading.assembly.label)
        letters = max(orders, key=lambda o: sum(row[AXES.index(a)] for row, a in zip(along, o)))
    for slider, letter in zip(sliders, letters):
        slider.axis = letter


def sides(reading: AssemblyModel, workpiece=None, tool=None) -> tuple[list[Slider], list[Slider]]:
    """(workpiece side, tool side): by a part that the caller names (object or link), else by the parts' names."""
    branches = [*reading.branches, *[[] for _ in range(2 - len(reading.branches))]]

    def branch_of(link) -> int:
        where = place(link)
        for k, branch in enumerate(branches):
            bodies = [s.outer for s in branch] or [reading.bed]
            for number in bodies:
                for part in reading.groups[number].parts:
                    if where.key[: len(part.key)] == part.key:
                        return k
        raise Refused(
            "assembly-part-moves-not",
            reading.assembly.label,
            part=repr(where.label),
            assembly=repr(reading.assembly.label),
        )

    if tool is not None:
        k = branch_of(tool)
        return branches[1 - k], branches[k]
    if workpiece is not None:
        k = branch_of(workpiece)
        return branches[k], branches[1 - k]

    def score(branch) -> int:
        text = [p.object.Label for s in branch for p in reading.groups[s.outer].parts]
        text += [leaf.object.Label for s in branch for p in reading.groups[s.outer].parts for leaf in leaves(p)]
        return sum((guess(t) in ("T", "Z")) - bool(WORKPIECE_SIDE.search(t)) for t in text)

    if score(branches[0]) != score(branches[1]):
        first = score(branches[0]) > score(branches[1])
    else:  # the tool is where the vertical axis is, the longer branch where there is only one
        first = "Z" in [s.axis for s in branches[0]] or not branches[1]
    return (branches[1], branches[0]) if first else (branches[0], branches[1])


def machine_from_assembly(
    doc, assembly, *, workpiece=None, tool=None, tool_point=None, names=None, travel=None, label=None
):
    """Make a Machine in `doc` from an assembly with a grounded part and three sliders; returns the Machine object.

    assembly : Assembly, or a link to one (also in another document), or a `AssemblyModel`.
    workpiece, tool : a part (object or link) on the side that carries the workpiece, or the tool; None: proposed from
    names.  tool_point : as in `make_machine`; None: a coordinate system named so, else the machine's Problem asks for
    it.  names : joint -> "X", "Y" or "Z"; None: from the joints' names or directions.  travel : axis -> (low, high) mm;
    None: the limits of the slider, else 100 mm to either side.  Positions count as the sliders' own distances do.
    Refuses by name what is no serial three-axis machine; nothing is made then.  Opens no transaction.
    """
    reading = assembly if isinstance(assembly, AssemblyModel) else read(assembly)
    name_axes(reading, names)
    work_side, tool_side = sides(reading, workpiece, tool)
    described = {}
    for slider in reading.sliders:
        reverse = joints.direction(slider.joint)[AXES.index(slider.axis)] < 0
        described[slider.axis] = (slider, reverse, _travel(reading, slider, reverse, slider in work_side, travel))
    if tool_point is None:
        tool_point = _tool_point(reading, tool_side)
    machine = factory.make_machine(
        doc,
        [s.axis for s in work_side],
        [s.axis for s in tool_side],
        bed=reading.groups[reading.bed].parts,
        tool_point=tool_point,
        label=label or reading.assembly.label,
    )
    for name in AXES:
        slider, reverse, limits = described[name]
        axis = factory.make_axis(
            machine, name, reading.groups[slider.outer].parts, travel=limits, direction=slider.joint, reverse=reverse,
            reference=slider.joint,
        )  # fmt: skip
        axis.StandsAt = joints.position(machine, axis, reading.groups[slider.outer].parts)
        axis.Position = axis.StandsAt
    for note in reading.notes:
        App.Console.PrintWarning(f"{machine.Label}: {note}\n")
    doc.recompute()
    return machine


def _travel(reading: AssemblyModel, slider: Slider, reverse: bool, on_work_side: bool, stated) -> tuple[float, float]:
    if stated and slider.axis in stated:
        return tuple(float(v) for v in stated[slider.axis])
    joint = slider.joint.object
    sense = (1.0 if slider.side == 2 else -1.0) * (-1.0 if reverse else 1.0) * (-1.0 if on_work_side else 1.0)
    stands = sense * joints.distance(slider.joint)
    limits = []
    for end in ("Min", "Max"):
        value = getattr(joint, f"Length{end}", 0.0)
        limits.append(float(getattr(value, "Value", value)) if getattr(joint, f"EnableLength{end}", False) else None)
    if None in limits or limits[0] >= limits[1]:
        reading.notes.append(
            f"slider {joint.Label!r} states no limits: {ASSUMED_TRAVEL:g} mm to either side of where axis "
            f"{slider.axis} stands is assumed."
        )
        return stands - ASSUMED_TRAVEL, stands + ASSUMED_TRAVEL
    return tuple(sorted(sense * v for v in limits))


def _tool_point(reading: AssemblyModel, tool_side: list[Slider]) -> PartPath | None:
    """A coordinate system or datum called tool point, TCP or tip on the body that carries the tool."""
    for part in reading.groups[tool_side[-1].outer if tool_side else reading.bed].parts:
        for where in _everything(part):
            if _is_datum(where.object) and TOOL_POINT.search(where.object.Label):
                return where
    return None


def _everything(where: PartPath):
    yield where
    for obj in getattr(joints.linked(where.object), "Group", None) or ():
        if obj is not None:
            yield from _everything(where.child(obj))
