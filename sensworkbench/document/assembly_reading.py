# SPDX-License-Identifier: LGPL-2.1-or-later
"""Read the joints of an assembly: bodies, the sliders between them from the grounded part outwards, and loose parts.

Parts connected by fixed joints form a body, sliders connect bodies, and a part that only turns on a body (spindle,
screw) moves with it.  Sub-assemblies and links to assemblies are followed; those without a slider count as one part.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from ..core.refusal import Refused
from . import joints
from .base import kind_of
from .paths import PartPath, _is_datum, _is_folder, leaves, place
from .tree import lookup

RIDING = ("Revolute", "Cylindrical", "Ball")  # hold a part on its carrier, whatever it turns by
PARALLEL = 1e-6


@dataclass
class Group:
    """Parts that fixed joints make one body."""

    parts: list[PartPath] = field(default_factory=list)
    grounded: bool = False

    @property
    def label(self) -> str:
        """Return the labels of the parts, separated by commas."""
        return ", ".join(p.object.Label for p in self.parts)


@dataclass
class Slider:
    """One axis of the machine: its joint, and the bodies inside and outside of it, seen from the bed."""

    joint: PartPath
    inner: int
    outer: int
    side: int  # of the joint that moves outwards
    axis: str = ""


@dataclass
class AssemblyModel:
    """Model of an assembly: bodies, sliders in chain order per branch from the bed, parts held by nothing, remarks."""

    assembly: PartPath
    groups: list[Group]
    bed: int
    branches: list[list[Slider]]
    left_out: list[PartPath] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)

    @property
    def sliders(self) -> list[Slider]:
        """Return the sliders of all branches."""
        return [s for branch in self.branches for s in branch]


def assemblies(doc) -> list:
    """Return the assemblies, and links to assemblies, at the top level of a document."""
    return [o for o in doc.Objects if joints.is_assembly(joints.linked(o)) and not o.getParentGeoFeatureGroup()]


# -- reading ---------------------------------------------------------------------------------------------------------
def read(assembly) -> AssemblyModel:
    """Read the joints of an assembly (or of a link to one); refuses by name what is no serial three-axis machine."""
    where = place(assembly)
    real = joints.linked(where.object) if where is not None else None
    if not joints.is_assembly(real):
        label = where.object.Label if where is not None else "nothing"
        raise Refused("assembly-none", label, object=repr(label))
    parts, found = [], []
    _walk(where, parts, found)
    if not parts:
        raise Refused("assembly-empty", where.object.Label, object=repr(where.object.Label))
    return _Reader(where, parts, found).reading()


def _walk(where: PartPath, parts: list[PartPath], found: list[PartPath]) -> None:
    """Collect the parts of an assembly and its joints, those of sub-assemblies with sliders included."""
    for obj in _content(where):
        inner = where.child(obj)
        real = joints.linked(obj)
        if joints.is_joint(obj) or joints.is_ground(obj):
            found.append(inner)
        elif joints.is_assembly(real) and _has_slider(real) and not _is_rigid(real):
            _walk(inner, parts, found)
        elif _is_part(obj, inner):
            parts.append(inner)


def _content(where: PartPath):
    seen = set()
    stack = list(joints.linked(where.object).Group)
    while stack:
        obj = stack.pop(0)
        if obj is None or obj.Name in seen:
            continue
        seen.add(obj.Name)
        if _is_folder(obj):
            stack.extend(obj.Group)
        else:
            yield obj


def _is_rigid(assembly) -> bool:
    """Whether it is a link to an assembly whose joints the solver holds still; a flexible one has its own joints."""
    return bool(getattr(assembly, "Rigid", False))


def _has_slider(assembly) -> bool:
    for obj in assembly.OutListRecursive:
        if joints.is_joint(obj) and obj.JointType == joints.SLIDER and joints.is_active(obj):
            return True
    return False


def _is_part(obj, where: PartPath) -> bool:
    if _is_datum(obj) or kind_of(obj) or obj.TypeId.startswith("Assembly::"):
        return joints.is_assembly(joints.linked(obj)) and bool(leaves(where))
    return hasattr(obj, "Placement") and bool(leaves(where))


class _Reader:
    """Turns parts and joints into bodies and a tree of sliders."""

    def __init__(self, where: PartPath, parts: list[PartPath], found: list[PartPath]):
        self.where, self.parts = where, parts
        self.label = where.object.Label
        self.index = {p.key: i for i, p in enumerate(parts)}
        self.active = [j for j in found if joints.is_active(j.object)]
        self.group_of = list(range(len(parts)))

    def part(self, joint: PartPath, side: int) -> int | None:
        """Number of the part that a side of a joint refers to; None where it is no part of this assembly."""
        outer = joints.assembly_place(joint)
        path = outer.path + joints.below(joints.reference(joint.object, side), joints.home_of(joint.object))
        return self.number(PartPath(outer.root, path))

    def number(self, where: PartPath) -> int | None:
        return lookup(self.index, where.key)

    def reading(self) -> AssemblyModel:
        pairs = self._pairs()
        for joint, one, other in pairs:
            if joint.object.JointType == "Fixed":
                self._merge(one, other)
        self._merge_grounded()
        numbers = {g: k for k, g in enumerate(dict.fromkeys(self.group_of))}
        groups = [Group() for _ in numbers]
        for i, part in enumerate(self.parts):
            groups[numbers[self.group_of[i]]].parts.append(part)
        bed = numbers[self.group_of[self.grounded[0]]]
        groups[bed].grounded = True
        edges = [(j, numbers[self.group_of[a]], numbers[self.group_of[b]]) for j, a, b in pairs]
        sliders = self._unique([e for e in edges if e[0].object.JointType == joints.SLIDER and e[1] != e[2]])
        branches = self._branches(groups, sliders, bed)
        result = AssemblyModel(self.where, groups, bed, branches)
        self._riders(result, edges)
        return result

    def _pairs(self):
        found = []
        for joint in self.active:
            if not joints.is_joint(joint.object):
                continue
            ends = [self.part(joint, side) for side in (1, 2)]
            if None not in ends and ends[0] != ends[1]:
                found.append((joint, *ends))
        return found

    def _merge(self, one: int, other: int) -> None:
        keep, gone = self.group_of[one], self.group_of[other]
        self.group_of = [keep if g == gone else g for g in self.group_of]

    def _merge_grounded(self) -> None:
        grounds = [g for g in self.active if joints.is_ground(g.object)]
        top = [g for g in grounds if joints.assembly_place(g).key == self.where.key]
        self.grounded = []
        for ground in top or grounds:
            target = ground.object.ObjectToGround
            if target is None:
                continue
            outer = joints.assembly_place(ground)
            path = outer.path + joints.below(place((target, "")), joints.home_of(ground.object))
            inside = PartPath(outer.root, path)
            number = self.number(inside)
            if number is not None:
                self.grounded.append(number)
            else:  # a sub-assembly that is walked: what stands on the ground inside of it
                self.grounded += self._ground_inside(inside, grounds)
        if not self.grounded:
            raise Refused("assembly-not-grounded", self.label)
        for number in self.grounded[1:]:
            self._merge(self.grounded[0], number)

    def _ground_inside(self, where: PartPath, grounds) -> list[int]:
        found = []
        for ground in grounds:
            outer = joints.assembly_place(ground)
            target = ground.object.ObjectToGround
            if outer.key[: len(where.key)] == where.key and target is not None:
                path = outer.path + joints.below(place((target, "")), joints.home_of(ground.object))
                number = self.number(PartPath(outer.root, path))
                if number is not None:
                    found.append(number)
        linked = getattr(joints.linked(where.object), "LinkedObject", None)
        if not found and linked is not None:  # a flexible link copies the joints, but not what is grounded
            fixed = [j.ObjectToGround for j in linked.OutListRecursive if joints.is_ground(j)]
            found = [self.number(where.child(o)) for o in _content(where) if getattr(o, "LinkedObject", None) in fixed]
        return [number for number in found if number is not None]

    def _unique(self, sliders):
        """Two parallel sliders between the same bodies guide one axis."""
        kept = []
        for joint, one, other in sliders:
            u = joints.direction(joint)
            for known, a, b in kept:
                if {a, b} == {one, other}:
                    if joints.direction(known).cross(u).Length < PARALLEL:
                        break
                    raise Refused(
                        "assembly-two-directions",
                        self.label,
                        one=repr(known.object.Label),
                        other=repr(joint.object.Label),
                    )
            else:
                kept.append((joint, one, other))
        return kept

    def _branches(self, groups, sliders, bed) -> list[list[Slider]]:
        rigid = [p.object.Label for p in self.parts if _is_rigid(p.object) and _has_slider(p.object)]
        if len(sliders) < 3 and rigid:
            raise Refused("assembly-rigid", self.label, assemblies=[repr(r) for r in rigid])
        if not sliders:
            raise Refused("assembly-no-slider", self.label)
        if len(sliders) != 3:
            names = ", ".join(repr(s[0].object.Label) for s in sliders)
            more = len(sliders) > 3
            raise Refused(
                "assembly-sliders-more" if more else "assembly-sliders-fewer",
                self.label,
                count=len(sliders),
                names=names,
            )
        waiting, reached, tree = list(sliders), {bed}, []
        while waiting:
            step = next((s for s in waiting if (s[1] in reached) != (s[2] in reached)), None)
            if step is None:
                closed = [s for s in waiting if s[1] in reached]
                joint = (closed or waiting)[0][0].object
                raise Refused(
                    "assembly-slider-loop" if closed else "assembly-slider-loose", self.label, slider=repr(joint.Label)
                )
            waiting.remove(step)
            joint, one, other = step
            outer_side = 2 if one in reached else 1
            inner, outer = (one, other) if outer_side == 2 else (other, one)
            reached.add(outer)
            tree.append(Slider(joint, inner, outer, outer_side))
        return _chains(tree, groups, bed, self.label)

    def _riders(self, result: AssemblyModel, edges) -> None:
        """What is held on a body by a joint that only lets it turn rides on it; the rest is left out, by name."""
        moving = {result.bed, *(s.outer for s in result.sliders)}
        carrier = {g: g for g in moving}
        grown = True
        while grown:
            grown = False
            for joint, one, other in edges:
                if joint.object.JointType in RIDING and (one in carrier) != (other in carrier):
                    inner, outer = (one, other) if one in carrier else (other, one)
                    carrier[outer] = carrier[inner]
                    result.groups[carrier[inner]].parts += result.groups[outer].parts
                    grown = True
        for number, group in enumerate(result.groups):
            if number not in carrier:
                result.left_out += group.parts
        if result.left_out:
            names = ", ".join(repr(p.object.Label) for p in result.left_out)
            result.notes.append(f"No joint holds {names}: left out of the machine.")


def _chains(tree: list[Slider], groups, bed: int, label: str) -> list[list[Slider]]:
    """Branches from the bed; refuses more than two, and a fork."""
    branches = [[s] for s in tree if s.inner == bed]
    if len(branches) > 2:
        names = ", ".join(repr(b[0].joint.object.Label) for b in branches)
        raise Refused("assembly-three-on-bed", label, names=names)
    for branch in branches:
        while True:
            following = [s for s in tree if s.inner == branch[-1].outer]
            if len(following) > 1:
                names = ", ".join(repr(s.joint.object.Label) for s in following)
                raise Refused("assembly-carries-two", label, part=repr(groups[branch[-1].outer].label), names=names)
            if not following:
                break
            branch.append(following[0])
    return branches
