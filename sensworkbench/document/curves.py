# SPDX-License-Identifier: LGPL-2.1-or-later
"""Asking edges and faces what they are, without ever raising.

OpenCASCADE holds more than FreeCAD can name: `edge.Curve` raises TypeError on the degenerated edges of a sphere, kinds
differ between versions, a damaged face raises OCCError, and a null shape ends the program with a segmentation fault.
Every function here answers None (or an empty list) where there is nothing to know.
"""

from __future__ import annotations

import math

import FreeCAD as App
import Part

STRAIGHT = 1e-6  # of its length: what an edge may bend and still be straight
SAME = 1e-4  # rad, and part of a radius: what sampled normals may differ on a plane or a cylinder
FAILS = (TypeError, ValueError, AttributeError, RuntimeError, NotImplementedError, ArithmeticError, Part.OCCError)


def is_something(shape) -> bool:
    """Whether it is a shape that holds anything; all else about a null shape is better not asked."""
    try:
        return isinstance(shape, Part.Shape) and not shape.isNull()
    except FAILS:
        return False


def curve(edge):
    """The curve of an edge, or None where it has none that FreeCAD can name."""
    try:
        return None if not is_something(edge) or edge.Degenerated else edge.Curve
    except FAILS:
        return None


def surface(face):
    """The surface of a face, or None where it has none that FreeCAD can name."""
    try:
        return face.Surface if is_something(face) else None
    except FAILS:
        return None


def parts(shape, kind: str) -> list:
    """The `kind` ("Solids", "Shells", "Faces", "Edges", "Vertexes") of a shape; an empty list where there are none."""
    try:
        return list(getattr(shape, kind)) if is_something(shape) else []
    except FAILS:
        return []


def box(shape):
    """The bounding box of a shape, or None where it has none, or one that is endless."""
    try:
        found = shape.BoundBox if is_something(shape) else None
    except FAILS:
        return None
    if found is None or not found.isValid() or not math.isfinite(found.DiagonalLength) or found.DiagonalLength > 1e9:
        return None
    return found


def number(shape, name: str) -> float:
    """Return a property such as "Length", "Area" or "Volume" of a shape; 0 if FreeCAD cannot compute it."""
    try:
        value = float(getattr(shape, name)) if is_something(shape) else 0.0
    except FAILS:
        return 0.0
    return value if math.isfinite(value) and abs(value) < 1e30 else 0.0


def centre_of_mass(shape):
    """The centre of mass of a shape, or None."""
    try:
        found = shape.CenterOfMass if is_something(shape) else None
    except FAILS:
        return None
    return found if found is not None and math.isfinite(found.Length) else None


def line(edge) -> App.Vector | None:
    """Unit vector along an edge that is straight, whatever kind of curve it lies on; else None."""
    known = curve(edge)
    if known is None:
        return None
    try:
        if not isinstance(known, (Part.Line, Part.LineSegment)):
            if isinstance(known, (Part.Circle, Part.Ellipse)):
                return None
            ends = [edge.valueAt(p) for p in edge.ParameterRange]
            if (ends[1] - ends[0]).Length < (1 - STRAIGHT) * edge.Length or edge.Length < 1e-6:
                return None
            return (ends[1] - ends[0]).normalize()
        along = edge.tangentAt(edge.FirstParameter)
        return along.normalize() if along.Length > 0 else None
    except FAILS:
        return None


def circle(edge):
    """The circle that an edge lies on, or None."""
    known = curve(edge)
    return known if isinstance(known, Part.Circle) else None


def plane(face) -> App.Vector | None:
    """Outward unit normal of a face that is flat, whatever kind of surface it lies on; else None."""
    known = surface(face)
    if known is None or isinstance(known, (Part.Cylinder, Part.Cone, Part.Sphere, Part.Toroid)):
        return None
    normals = [n for _, n in _samples(face, 1 if isinstance(known, Part.Plane) else 3)]
    if not normals or any((n - normals[0]).Length > SAME for n in normals):
        return None
    return normals[0]


def cylinder(face) -> tuple[App.Vector, App.Vector, float, bool] | None:
    """(point on the axis, unit vector, radius, whether it is the outside) of a cylindrical face; else None.

    A cylinder that was converted to another kind of surface is known by its normals.
    """
    known = surface(face)
    if known is None or isinstance(known, (Part.Plane, Part.Cone, Part.Sphere, Part.Toroid)):
        return None
    samples = _samples(face, 1 if isinstance(known, Part.Cylinder) else 3)
    if not samples:
        return None
    try:
        if isinstance(known, Part.Cylinder):
            centre, axis, radius = App.Vector(known.Center), App.Vector(known.Axis).normalize(), float(known.Radius)
        else:
            found = _round(samples)
            if found is None:
                return None
            centre, axis, radius = found
    except FAILS:
        return None
    point, normal = samples[0]
    radial = point - centre
    radial -= axis * radial.dot(axis)
    return centre, axis, radius, normal.dot(radial) > 0


def _samples(face, count: int) -> list[tuple[App.Vector, App.Vector]]:
    """(point, outward normal) at count x count places of a face."""
    try:
        u0, u1, v0, v1 = face.ParameterRange
        if not all(math.isfinite(v) and abs(v) < 1e12 for v in (u0, u1, v0, v1)):
            return []
        at = [(i + 0.5) / count for i in range(count)]
        return [(face.valueAt(u0 + (u1 - u0) * a, v0 + (v1 - v0) * b),
                 face.normalAt(u0 + (u1 - u0) * a, v0 + (v1 - v0) * b)) for a in at for b in at]  # fmt: skip
    except FAILS:
        return []


def _round(samples):
    """(centre, axis, radius) of the cylinder that points with these normals lie on, or None."""
    axis = max((a.cross(b) for _, a in samples for _, b in samples), key=lambda c: c.Length)
    if axis.Length < 0.05:
        return None
    axis.normalize()
    if any(abs(n.dot(axis)) > SAME for _, n in samples):
        return None
    (p, n), (q, m) = max(((s, t) for s in samples for t in samples), key=lambda st: st[0][1].cross(st[1][1]).Length)
    across = q - p
    across -= axis * across.dot(axis)
    radius = across.Length / (n - m).Length
    for sign in (-1.0, 1.0):  # the normal points away from the axis, or to it
        centre = p + n * (sign * radius)
        gaps = [x - centre for x, _ in samples]
        if all(abs((g - axis * g.dot(axis)).Length - radius) < 100 * SAME * radius for g in gaps):
            return centre, axis, radius
    return None
