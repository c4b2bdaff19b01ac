# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the tip of a tool when a person selects the tool: a click in the view selects a side face, not the tip.

For the side of a cylinder or cone, the tip is the middle of the rim that is farther from the tool's carrier.
"""

from __future__ import annotations

from dataclasses import dataclass

import FreeCAD as App
import Part

from ..core.refusal import Refused
from . import geometry
from .paths import PartPath, as_sub, leaves, place

NEAR = 1e-6  # mm between two points that are one


@dataclass(frozen=True)
class Tip:
    """link : value for the machine's ToolPoint.  point : where it is, mm, document coordinates.

    moved : an end was taken where a side was given.  beyond : mm that the tool reaches past the point, 0 at its end.
    """

    link: tuple
    point: App.Vector
    moved: bool = False
    beyond: float = 0.0


def tip(link, carrier: App.Vector | None = None, tool=()) -> Tip:
    """The tip that is meant by a link.

    carrier : a point of what carries the tool (its centre of mass), mm; None: the tool points down.  tool : the parts
    of the tool (`PartPath`), asked how far they reach.  Refuses what gives no point.
    """
    where = place(link)
    axis, at = _axis(where)
    if axis is None:
        return Tip(as_sub(where), geometry.point(where, "Automatic")[0])
    away = axis.dot(at - carrier) if carrier is not None else 0.0
    if (away if abs(away) > NEAR else -axis.z) < 0:
        axis = axis * -1
    rim = _far_rim(where, axis)
    chosen = where if rim is None else PartPath(where.root, where.path, rim)
    point = geometry.point(chosen, "Automatic")[0]
    reach = max((_reach(leaf, axis, point) for leaf in [PartPath(where.root, where.path), *_leaves(tool)]), default=0.0)
    return Tip(as_sub(chosen), point, rim is not None, max(0.0, reach))


def _leaves(parts):
    return [leaf for part in parts for leaf in leaves(part)]


def _axis(where: PartPath):
    """(unit vector, a point) of a round edge or a cylindrical or conical face; (None, None) for anything else."""
    shape = where.shape() if where.element else None
    try:
        if shape is not None and shape.ShapeType == "Edge" and isinstance(shape.Curve, Part.Circle):
            return App.Vector(shape.Curve.Axis).normalize(), App.Vector(shape.Curve.Center)
        if shape is not None and shape.ShapeType == "Face" and isinstance(shape.Surface, (Part.Cylinder, Part.Cone)):
            return App.Vector(shape.Surface.Axis).normalize(), shape.CenterOfMass
    except (TypeError, Part.OCCError):  # a curve or surface that FreeCAD has no name for
        pass
    return None, None


def _circles(edges):
    """(index from 1, centre, radius) of the circles among some edges."""
    for number, edge in enumerate(edges, start=1):
        try:
            curve = edge.Curve
        except (TypeError, Part.OCCError):
            continue
        if isinstance(curve, Part.Circle):
            yield number, App.Vector(curve.Center), curve.Radius


def _far_rim(where: PartPath, axis) -> str | None:
    """Element name of the circle that ends a round face in the direction of `axis`; None where there is none."""
    face = where.shape()
    if face.ShapeType != "Face":
        return None
    rims = [(centre, radius) for _, centre, radius in _circles(face.Edges)]
    if not rims:
        return None
    centre, radius = max(rims, key=lambda rim: axis.dot(rim[0]))
    whole = PartPath(where.root, where.path).shape()
    for number, other, size in _circles(whole.Edges if whole is not None else []):
        if (other - centre).Length < NEAR and abs(size - radius) < NEAR:
            return f"Edge{number}"
    return None


def _reach(leaf: PartPath, axis, point) -> float:
    """How far a part reaches past a point along `axis`, mm; negative where it ends before."""
    try:
        shape = leaf.shape()
    except Refused:
        return 0.0
    if shape is None or shape.isNull():
        return 0.0
    if max(abs(axis.x), abs(axis.y), abs(axis.z)) > 1 - 1e-9:  # square to the box: its sides are exact
        box = shape.BoundBox
        ends = [App.Vector(box.XMin, box.YMin, box.ZMin), App.Vector(box.XMax, box.YMax, box.ZMax)]
        return max(axis.dot(end - point) for end in ends)
    return max((axis.dot(v.Point - point) for v in shape.Vertexes), default=0.0)
