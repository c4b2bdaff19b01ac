# SPDX-License-Identifier: LGPL-2.1-or-later
"""The nominal geometry of a feature from its points, by least squares: point, line, circle, plane or cylinder.

Points are nominal, so the element that fits to within `FIT_MM` is the feature's; the departures of the part are small
beside it and are not fitted here.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..messages import Refused
from .units import um

FIT_MM = 2e-3  # a path is written to a thousandth; a nominal element fits it to within this
POINT, LINE, CIRCLE, PLANE, CYLINDER = "point", "line", "circle", "plane", "cylinder"


@dataclass(frozen=True)
class Element:
    """What the points of a feature lie on.

    kind : one of the five.  centre : (3,) centroid of a point, line or plane; centre of a circle; point of the axis of
    a cylinder, half way along its points.  axis : (3,) unit vector along a line or cylinder, across a plane or
    circle; zeros for a point.  radius : of a circle or cylinder, mm, else 0.  off : largest distance of a point, mm.
    """

    kind: str
    centre: np.ndarray
    axis: np.ndarray
    radius: float = 0.0
    off: float = 0.0

    def across(self) -> tuple[np.ndarray, np.ndarray]:
        """Two unit vectors square to the axis and to each other, right-handed with it."""
        least = np.eye(3)[int(np.argmin(np.round(np.abs(self.axis), 9)))]
        first = least - self.axis * (self.axis @ least)
        first /= np.linalg.norm(first)
        return first, np.cross(self.axis, first)

    def radial(self, points) -> np.ndarray:
        """(n, 3) unit vectors from the axis to the points."""
        out = np.asarray(points, dtype=float) - self.centre
        out = out - (out @ self.axis)[:, None] * self.axis
        return out / np.maximum(np.linalg.norm(out, axis=1), 1e-300)[:, None]


def _directions(points) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(centroid, sizes, principal directions as rows), the longest first."""
    centre = points.mean(axis=0)
    values, vectors = np.linalg.eigh((points - centre).T @ (points - centre) / len(points))
    return centre, np.sqrt(np.maximum(values[::-1], 0.0)), _signed(vectors.T[::-1])


def _signed(directions) -> np.ndarray:
    """Directions whose largest component is positive."""
    largest = np.take_along_axis(directions, np.abs(np.round(directions, 9)).argmax(axis=1)[:, None], axis=1)
    return directions * np.where(largest < 0, -1.0, 1.0)


def point(points) -> Element:
    """The middle of the points."""
    centre = points.mean(axis=0)
    return Element(POINT, centre, np.zeros(3), off=float(np.linalg.norm(points - centre, axis=1).max()))


def line(points) -> Element:
    """The least-squares line."""
    centre, _, directions = _directions(points)
    rest = (points - centre) @ directions[1:].T
    return Element(LINE, centre, directions[0], off=float(np.hypot(*rest.T).max()))


def plane(points) -> Element:
    """The least-squares plane."""
    centre, _, directions = _directions(points)
    return Element(PLANE, centre, directions[2], off=float(np.abs((points - centre) @ directions[2]).max()))


def _round(points, axis, kind) -> Element:
    """Circle or cylinder about an axis of known direction (algebraic fit, exact for exact points)."""
    made = Element(kind, np.zeros(3), axis)
    first, second = made.across()
    middle = points.mean(axis=0)
    x, y = (points - middle) @ first, (points - middle) @ second
    size = max(float(np.hypot(x, y).max()), 1e-300)
    x, y = x / size, y / size
    found, *_ = np.linalg.lstsq(np.stack([x, y, np.ones_like(x)], axis=1), x**2 + y**2, rcond=None)
    a, b = found[0] / 2, found[1] / 2
    radius = float(np.sqrt(max(found[2] + a * a + b * b, 0.0)))
    off = float(np.abs(np.hypot(x - a, y - b) - radius).max()) * size
    along = (points - middle) @ axis
    if kind == CIRCLE:
        off = max(off, float(np.abs(along).max()))
    centre = middle + size * (a * first + b * second) + axis * (along.max() + along.min()) / 2
    return Element(kind, centre, axis, radius * size, off)


def circle(points) -> Element:
    """The least-squares circle in the least-squares plane."""
    return _round(points, _directions(points)[2][2], CIRCLE)


def cylinder(points, normals=None) -> Element:
    """The cylinder.  Its axis is square to the normals where they are known, else along an axis of the machine or
    across the circles of the path, whichever fits."""
    candidates = [*np.eye(3), *_directions(points)[2]]
    if normals is not None:
        values, vectors = np.linalg.eigh(normals.T @ normals)
        if values[1] > 1e-6 * values[2]:
            candidates = [_signed(vectors.T[:1])[0], *candidates]
    return min((_round(points, axis, CYLINDER) for axis in candidates), key=lambda e: round(e.off, 6))


def recognise(points, normals=None) -> Element:
    """The simplest element on which all points lie to within `FIT_MM`; refuses points that lie on none.

    normals : (n, 3) of the surface where they are known: four points of a plane do not make a circle then.
    """
    points = np.asarray(points, dtype=float)
    found = point(points)
    if found.off <= FIT_MM:
        return found
    found = line(points)
    if found.off <= FIT_MM:
        return found
    flat = plane(points)
    if flat.off <= FIT_MM:
        ring = circle(points)
        along = normals is not None and np.abs(normals @ flat.axis).min() > 0.5
        if not along and len(points) > 4 and ring.off <= FIT_MM:
            return ring
        return flat
    if len(points) > 5:
        found = cylinder(points, normals)
        if found.off <= FIT_MM:
            return found
    raise Refused("feature-no-element", off=um(flat.off), limit=um(FIT_MM))


MAKERS = {POINT: point, LINE: line, CIRCLE: circle, PLANE: plane, CYLINDER: cylinder}
FEWEST = {POINT: 1, LINE: 2, CIRCLE: 3, PLANE: 3, CYLINDER: 6}


def made(kind: str, points, normals, where: str, for_what: str) -> Element:
    """The element `kind` of points (n, 3); refuses too few points, and points that do not lie on one.

    where, for_what : the feature and its kind, for the refusal.
    """
    points = np.asarray(points, dtype=float)
    count = len(np.unique(np.round(points, 6), axis=0))
    if count < FEWEST[kind]:
        raise Refused("feature-too-few-points", where, kind=for_what, count=count, fewest=FEWEST[kind])
    found = cylinder(points, normals) if kind == CYLINDER else MAKERS[kind](points)
    if not found.off <= FIT_MM:
        raise Refused("feature-not-on-element", where, kind=for_what, element=kind, off=um(found.off))
    return found
