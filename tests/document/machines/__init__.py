# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machines of unlike kinds, made by script as people make them, each with what is true of it.

A builder fills a document and returns a `Truth`.  None of them knows how the proposal works.
"""

# ruff: noqa: E501
from __future__ import annotations

from dataclasses import dataclass, field

import FreeCAD as App
import Part

V = App.Vector


@dataclass
class Truth:
    """structure: workpiece to tool, or None where there is no machine.  axes: name -> unit vector (sign free).
    bodies: body -> labels of some of its parts.  travel: name -> length in mm that the guides leave, at most."""

    structure: str | None
    axes: dict[str, tuple] = field(default_factory=dict)
    bodies: dict[str, set[str]] = field(default_factory=dict)
    travel: dict[str, float] = field(default_factory=dict)
    kind: str = "serial"
    either: tuple[str, ...] = ()  # other structures that are as right


def box(x, y, z):
    """Block over the ranges x, y, z = (low, high)."""
    return Part.makeBox(x[1] - x[0], y[1] - y[0], z[1] - z[0], V(x[0], y[0], z[0]))


def rod(at, along, length, radius):
    u = {"x": V(1, 0, 0), "y": V(0, 1, 0), "z": V(0, 0, 1)}[along]
    return Part.makeCylinder(radius, length, V(*at), u)


def bored(shape, at, along, length, radius):
    return shape.cut(rod(at, along, length, radius))


def profile(points, along, low, high):
    """Outline in the plane across an axis - (y, z) for x, (x, z) for y, (x, y) for z - drawn from low to high."""
    place = {"x": lambda a, b: V(low, a, b), "y": lambda a, b: V(a, low, b), "z": lambda a, b: V(a, b, low)}[along]
    u = {"x": V(1, 0, 0), "y": V(0, 1, 0), "z": V(0, 0, 1)}[along]
    wire = [place(*p) for p in points]
    return Part.Face(Part.makePolygon([*wire, wire[0]])).extrude(u * (high - low))


def fused(*shapes):
    return shapes[0].multiFuse(list(shapes[1:])) if len(shapes) > 1 else shapes[0]


def add(doc, label, shape, holder=None, kind="Part::Feature"):
    obj = doc.addObject(kind, "P")
    obj.Label = label
    obj.Shape = shape
    if holder is not None:
        holder.addObject(obj)
    return obj


def part(doc, label, holder=None):
    obj = doc.addObject("App::Part", "Part")
    obj.Label = label
    if holder is not None:
        holder.addObject(obj)
    return obj


# rails and blocks as makers' files have them: a waisted rail with holes, a block over it ------------------------------
RAIL = [
    (-10, 0),
    (10, 0),
    (10, 6),
    (7, 9),
    (7, 12),
    (10, 15),
    (10, 18),
    (-10, 18),
    (-10, 15),
    (-7, 12),
    (-7, 9),
    (-10, 6),
]
BLOCK = [(-22, 4), (-10.1, 4), (-10.1, 18.4), (10.1, 18.4), (10.1, 4), (22, 4), (22, 28), (-22, 28)]


def section(points, along, at, up, sign=1):
    """Outline (across, height) at a point on the seat, for `profile`; up: the axis that height counts along."""
    order = {"x": "yz", "y": "xz", "z": "xy"}[along]
    centre = dict(zip("xyz", at))
    across = order.replace(up, "")
    made = []
    for a, h in points:
        p = {across: centre[across] + a, up: centre[up] + sign * h}
        made.append((p[order[0]], p[order[1]]))
    return made


def rail(along, at, low, high, up="z", sign=1):
    return profile(section(RAIL, along, at, up, sign), along, low, high)


def block(along, at, centre, half=30, up="z", sign=1):
    return profile(section(BLOCK, along, at, up, sign), along, centre - half, centre + half)


def vslot(along, at, low, high, size=20):
    """An aluminium profile with a groove in each side."""
    h, g, d = size / 2, size * 0.15, size * 0.3
    points = [(-h, -h), (-g, -h), (-g, -h + d), (g, -h + d), (g, -h), (h, -h), (h, -g), (h - d, -g), (h - d, g), (h, g), (h, h),
              (g, h), (g, h - d), (-g, h - d), (-g, h), (-h, h), (-h, g), (-h + d, g), (-h + d, -g), (-h, -g)]  # fmt: skip
    order = {"x": "yz", "y": "xz", "z": "xy"}[along]
    centre = dict(zip("xyz", at))
    return profile([(a + centre[order[0]], b + centre[order[1]]) for a, b in points], along, low, high)


def wheel(at, axis, radius=12):
    """A V-wheel: two cones on one axle."""
    u = {"x": V(1, 0, 0), "y": V(0, 1, 0), "z": V(0, 0, 1)}[axis]
    shape = Part.makeCone(radius - 4, radius, 5, V(*at) - u * 5, u).fuse(
        Part.makeCone(radius, radius - 4, 5, V(*at), u)
    )
    return shape.cut(Part.makeCylinder(2.5, 12, V(*at) - u * 6, u))


def wave(offset: float = 0.0):
    """An edge along a spline, or along a curve at a distance from it."""
    spline = Part.BSplineCurve()
    spline.interpolate([V(0, 0, 0), V(10, 2, 0), V(20, 0, 0), V(30, 5, 0)])
    return (Part.OffsetCurve(spline, offset, V(0, 0, 1)) if offset else spline).toShape()


def offset_block():
    """A block one of whose walls lies on an offset curve."""
    side = wave(2.0)
    ends = [v.Point for v in side.Vertexes]
    others = [Part.makeLine(a, b) for a, b in ((ends[1], V(30, -40, 0)), (V(30, -40, 0), V(0, -40, 0)),
                                               (V(0, -40, 0), ends[0]))]  # fmt: skip
    return Part.Face(Part.Wire(Part.__sortEdges__([side, *others]))).extrude(V(0, 0, 20))
