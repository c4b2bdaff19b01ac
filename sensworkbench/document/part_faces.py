# SPDX-License-Identifier: LGPL-2.1-or-later
"""The faces of a solid and the shapes of a job's tools, as the search for what a path cuts wants them.

Planes and cylinders are taken; other faces (cones, free forms) are left alone.  Everything is in document coordinates.
"""

from __future__ import annotations

import math
from pathlib import PurePosixPath

import numpy as np

from ..core.contact import Cutter, Face
from ..core.elements import CYLINDER, PLANE
from ..core.refusal import Refused

_DRILLS = ("drill", "reamer", "center", "centre", "spot")
_OTHERS = ("vbit", "v-bit", "chamfer", "dovetail", "taper", "probe", "thread", "tap", "engrav", "saw", "countersink")
MOST_MODELS = 20


# -- tools -------------------------------------------------------------------------------------------------------------
def cutter(bit, radius: float) -> Cutter | None:
    """The shape of a tool bit; None where it is none of those whose contact is known."""
    name = _shape_name(bit)
    if not radius > 0 or any(word in name for word in _OTHERS):
        return None
    if any(word in name for word in _DRILLS):
        return Cutter(radius, drill=True)
    if "ball" in name:
        return Cutter(radius, radius)
    corner = float(getattr(bit, "CornerRadius", 0.0) or 0.0)
    flat = float(getattr(bit, "FlatRadius", 0.0) or 0.0)
    if not corner and ("bull" in name or "tor" in name) and 0 < flat < radius:
        corner = radius - flat
    return Cutter(radius, min(corner, radius))


def _shape_name(bit) -> str:
    for key in ("ShapeType", "ShapeID", "ShapeName", "BitShape", "ToolType"):
        text = str(getattr(bit, key, "") or "")
        if text:
            return PurePosixPath(text.replace("\\", "/")).stem.lower()
    return ""


# -- faces -------------------------------------------------------------------------------------------------------------
def models(document, job, label: str = "") -> tuple:
    """The objects whose faces are judged: those with the label, else the model of the job; none without either."""
    if label:
        found = [o for o in document.Objects if label in (o.Label, o.Name) and _solid(o)]
        if not found:
            known = [o.Label for o in reversed(document.Objects) if _solid(o)][:MOST_MODELS]  # the latest first
            raise Refused("part-model-unknown", document.Label, name=label[:60], known=known)
        return tuple(found[:1])
    group = getattr(getattr(job, "Model", None), "Group", None) or ()
    return tuple(o for o in group if _solid(o))[:MOST_MODELS]


def _solid(obj) -> bool:
    if not (obj.isDerivedFrom("Part::Feature") or obj.isDerivedFrom("App::Link")):
        return False
    shape = getattr(obj, "Shape", None)
    return shape is not None and hasattr(shape, "Faces") and not shape.isNull() and bool(shape.Faces)


def shape_of(obj):
    """A copy of an object's shape where it stands in the document."""
    shape = obj.Shape.copy()
    if hasattr(obj, "getGlobalPlacement"):
        shape.Placement = obj.getGlobalPlacement()
    return shape


def named_faces(objects) -> list[tuple[str, object]]:
    """(name, face) of all faces; the name has the object's label in front where there are several objects."""
    found = []
    for obj in objects:
        prefix = f"{obj.Label}." if len(objects) > 1 else ""
        found += [(f"{prefix}Face{i}", face) for i, face in enumerate(shape_of(obj).Faces, start=1)]
    return found


def faces(objects) -> tuple[Face, ...]:
    """The planes and cylinders among the faces of objects."""
    made = (_face(name, face) for name, face in named_faces(objects))
    return tuple(f for f in made if f is not None)


def _face(name: str, face) -> Face | None:
    kind = getattr(face.Surface, "TypeId", "")
    middle, corners = _domain(face)
    point, normal = _array(face.valueAt(*middle)), _array(face.normalAt(*middle))
    if kind == "Part::GeomPlane":
        return Face(name, PLANE, point, normal, inside=_inside(face), corners=corners, area=face.Area)
    if kind != "Part::GeomCylinder":
        return None
    surface = face.Surface
    centre, axis = _array(surface.Center), _array(surface.Axis)
    sense = 1 if float((point - centre) @ normal) > 0 else -1
    turn = face.ParameterRange[1] - face.ParameterRange[0]
    closed = turn > 2 * math.pi - 1e-6
    return Face(name, CYLINDER, centre, axis, float(surface.Radius), sense, _inside(face), corners, face.Area, closed)


def _domain(face) -> tuple[tuple[float, float], np.ndarray]:
    """((u, v) in the middle of a face's parameters, (2, 3) corners of its box)."""
    u0, u1, v0, v1 = face.ParameterRange
    box = face.BoundBox
    corners = np.array([[box.XMin, box.YMin, box.ZMin], [box.XMax, box.YMax, box.ZMax]])
    return ((u0 + u1) / 2, (v0 + v1) / 2), corners


def _array(vector) -> np.ndarray:
    return np.array([vector.x, vector.y, vector.z])


def _inside(face):
    """(n, 3) points on the surface of a face -> (n,) whether they lie within its edges."""
    import FreeCAD as App

    surface, (u0, u1, *_) = face.Surface, face.ParameterRange
    turns = (0.0,) if surface.TypeId == "Part::GeomPlane" else (0.0, 2 * math.pi, -2 * math.pi)

    def inside(points) -> np.ndarray:
        found = np.zeros(len(points), dtype=bool)
        for i, point in enumerate(points.tolist()):
            u, v = surface.parameter(App.Vector(*point))
            found[i] = any(u0 - 1e-9 <= u + t <= u1 + 1e-9 and face.isPartOfDomain(u + t, v) for t in turns)
        return found

    return inside
