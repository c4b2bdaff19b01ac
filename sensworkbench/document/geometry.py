# SPDX-License-Identifier: LGPL-2.1-or-later
"""Directions and points out of coordinate systems, datums, edges, faces and parts, in document coordinates, mm."""

from __future__ import annotations

import contextlib

import FreeCAD as App
import Part

from ..messages import Message, Refused
from . import curves
from .paths import DATUM_TYPES, LINE_ALONG_X, LINE_ALONG_Z, PLANES, PartPath, leaves

LOCAL = {"X": App.Vector(1, 0, 0), "Y": App.Vector(0, 1, 0), "Z": App.Vector(0, 0, 1)}


def direction(where: PartPath, along: str, name: str) -> tuple[App.Vector, Message]:
    """(unit vector, where it comes from as a message) of the direction at a place.

    along : an entry of `objects.DIRECTION_CHOICES`.

    name : "X", "Y" or "Z", the axis that it is for: the local axis that a coordinate system or part gives by default.
    """
    with _sound(where):
        return _direction(where, along, name)


@contextlib.contextmanager
def _sound(where: PartPath):
    """Geometry that FreeCAD cannot evaluate is refused by name."""
    try:
        yield
    except (Part.OCCError, ArithmeticError) as error:
        raise Refused("geometry-not-evaluated", where.object.Label, object=repr(where.label), why=str(error)) from None


def _direction(where: PartPath, along: str, name: str):
    if along.startswith("Local "):
        return _local(where, along[-1])
    if where.element:
        return _of_shape(where, where.shape())
    kind = _real(where).TypeId
    if kind in LINE_ALONG_X:
        return _local(where, "X")
    if kind in LINE_ALONG_Z or kind in PLANES:
        return _local(where, "Z")
    if kind not in DATUM_TYPES:
        shape = where.shape()
        if shape is not None and len(shape.Edges) == 1 and not shape.Faces and curves.line(shape.Edges[0]) is not None:
            return _of_shape(where, shape.Edges[0])
    return _local(where, name)


def _local(where: PartPath, letter: str):
    return where.placement.Rotation.multVec(LOCAL[letter]), Message(
        "from-local", axis=letter, object=where.object.Label
    )


def _real(where: PartPath):
    obj = where.object
    return (obj.getLinkedObject(True) if hasattr(obj, "getLinkedObject") else obj) or obj


def _of_shape(where: PartPath, shape):
    kind = shape.ShapeType
    if kind == "Edge":
        along = curves.line(shape)
        if along is not None:
            return along, Message("from-along", place=where.label)
        curve = curves.curve(shape)
        if hasattr(curve, "Axis"):
            return App.Vector(curve.Axis).normalize(), Message("from-axis", place=where.label)
    if kind == "Face":
        normal, surface = curves.plane(shape), curves.surface(shape)
        if normal is not None:
            return normal, Message("from-normal", place=where.label)
        if hasattr(surface, "Axis"):
            return App.Vector(surface.Axis).normalize(), Message("from-axis", place=where.label)
    raise Refused("geometry-no-direction", where.object.Label, object=repr(where.label))


def point(where: PartPath, at: str) -> tuple[App.Vector, Message]:
    """(point, message where it comes from) at a place.  at : an entry of `objects.REFERENCE_CHOICES`."""
    with _sound(where):
        return _point(where, at)


def _point(where: PartPath, at: str):
    if at == "Placement":
        return where.placement.Base, Message("from-placement", object=where.object.Label)
    if at == "Centre of mass":
        found = centre_of_mass([where])
        if found is None:
            raise Refused("geometry-no-solid", where.object.Label, object=repr(where.object.Label))
        return found, Message("from-centre-of-mass", objects=[where.object.Label])
    if where.element:
        return _point_of_shape(where, where.shape())
    if _real(where).TypeId not in DATUM_TYPES:
        found = centre_of_mass([where])
        if found is not None:
            return found, Message("from-centre-of-mass", objects=[where.object.Label])
        shape = where.shape()
        if shape is not None and shape.ShapeType in ("Vertex", "Edge", "Wire") and len(shape.Edges) <= 1:
            return _point_of_shape(where, shape.Edges[0] if shape.Edges else shape)
    return where.placement.Base, Message("from-origin", object=where.object.Label)


def _point_of_shape(where: PartPath, shape):
    if shape.ShapeType == "Vertex":
        return shape.Point, Message("from-vertex", place=where.label)
    if shape.ShapeType == "Edge" and hasattr(curves.curve(shape), "Center"):
        return App.Vector(curves.curve(shape).Center), Message("from-centre", place=where.label)
    if hasattr(shape, "CenterOfMass"):
        return shape.CenterOfMass, Message("from-middle", place=where.label)
    raise Refused("geometry-no-point", where.object.Label, object=repr(where.label))


def centre_of_mass(where: list[PartPath]) -> App.Vector | None:
    """Centre of mass of all solids at or below the places, one density; None without solids."""
    total, mass = App.Vector(), 0.0
    for leaf in (leaf for w in where for leaf in leaves(w)):
        shape = leaf.shape()
        if shape is not None and shape.Solids:
            centre, volume = _mass(leaf, shape)
            total += centre * volume
            mass += volume
    return total * (1 / mass) if mass > 0 else None


def _mass(leaf: PartPath, shape) -> tuple[App.Vector, float]:
    """Return (centre, volume) of the solids of `shape`, which is at `leaf`.

    The result is kept for the geometry without its placement, so that moving a part does not integrate it again.
    """
    real = _real(leaf)
    key = (real.Document.Name, real.Name)
    known = _known_masses.get(key)
    if known is None or not known[0].isPartner(shape):
        solids = [(s.CenterOfMass, s.Volume) for s in shape.Solids]
        volume = sum(v for _, v in solids)
        centre = App.Vector()
        for middle, part in solids:
            centre += middle * (part / volume)
        if len(_known_masses) >= KNOWN_LIMIT:
            _known_masses.pop(next(iter(_known_masses)))
        known = _known_masses[key] = (shape, shape.Placement.inverse().multVec(centre), volume)
    return shape.Placement.multVec(known[1]), known[2]


KNOWN_LIMIT = 512
_known_masses: dict = {}  # (document, object) -> (shape, centre in the shape's own frame, volume)
