# SPDX-License-Identifier: LGPL-2.1-or-later
"""Features of a part (ISO 1101): from the small departures of their points to value, derivative and shares.

Each kind makes linear maps once, from its nominal element: the departure of each point, the columns that its standard
leaves free (size, position, rotation), and the place of the whole feature.  A form or orientation value is the width of
the minimum zone of the departures; position and distance follow from the place by least squares.  Everything is linear
in the errors, mm and rad: departures of 10 um on a part of 100 mm neglect less than 1e-3 um.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from ..messages import Refused
from . import elements
from .elements import CIRCLE, CYLINDER, LINE, PLANE, POINT, Element
from .minimum_zone import independent, smallest_tube, smallest_zone

FORM, ORIENTATION, PLACE = "form", "orientation", "place"


@dataclass(frozen=True)
class Kind:
    """A kind of tolerance.

    group : form, orientation or place.  elements : element -> fewest points that determine it.  datum : whether it
    refers to another feature ("needed", "may", "").
    """

    name: str
    group: str
    elements: Mapping[str, int]
    datum: str = ""


KINDS = {
    k.name: k
    for k in (
        Kind("straightness", FORM, {LINE: 3}),
        Kind("flatness", FORM, {PLANE: 4}),
        Kind("roundness", FORM, {CIRCLE: 4}),
        Kind("cylindricity", FORM, {CYLINDER: 6}),
        Kind("parallelism", ORIENTATION, {LINE: 2, PLANE: 3, CYLINDER: 6}, "needed"),
        Kind("perpendicularity", ORIENTATION, {LINE: 2, PLANE: 3, CYLINDER: 6}, "needed"),
        Kind("position", PLACE, {POINT: 1, LINE: 2, CIRCLE: 3, PLANE: 3, CYLINDER: 6}, "may"),
        Kind("distance", PLACE, {POINT: 1, LINE: 2, CIRCLE: 3, PLANE: 3, CYLINDER: 6}, "needed"),
    )
}
USUAL = {POINT: "position", LINE: "straightness", CIRCLE: "roundness", PLANE: "flatness", CYLINDER: "cylindricity"}
_ALONG = {"parallelism": 1.0, "perpendicularity": 0.0}
_ANGLE = 0.05  # rad: features that are further from parallel or square than this are not meant


@dataclass(frozen=True)
class Surface:
    """The nominal points of a feature and what follows from them.

    points : (n, 3) mm.  normals : (n, 3) outward unit vectors, or None where they are not known (a line, a point): its
    departures then have two directions (a line) or three (a point).  directions : (n, 3, m) of these departures.
    columns : (n m, p) that the element itself leaves free: its place, size and rotation.
    """

    name: str
    element: Element
    points: np.ndarray
    normals: np.ndarray | None
    directions: np.ndarray = field(repr=False)
    columns: np.ndarray = field(repr=False)

    @property
    def width(self) -> int:
        """Number of departures of each point."""
        return self.directions.shape[2]

    def departures(self, error, rows=slice(None)) -> np.ndarray:
        """Departures (k m, ...) of errors (k, 3, ...), mm, of the points `rows`: along the surface's normals."""
        found = np.einsum("kam,ka...->km...", self.directions[rows], error)
        return found.reshape(found.shape[0] * found.shape[1], *found.shape[2:])

    @property
    def place(self) -> np.ndarray:
        """(3, p) displacement of the whole element by the coefficients of `columns`."""
        kind, (first, second) = self.element.kind, self.element.across() if self.element.axis.any() else (None, None)
        out = np.zeros((3, self.columns.shape[1]))
        if kind == POINT:
            out[:, :3] = np.eye(3)
        elif kind in (CIRCLE, CYLINDER):
            out[:, 1], out[:, 2] = first, second
        elif self.width == 2:
            out[:, 0], out[:, 2] = first, second
        else:
            out[:, 0] = self._normal
        return out

    @property
    def _normal(self) -> np.ndarray:
        mean = self.normals.mean(axis=0)
        return mean / np.linalg.norm(mean)

    @property
    def tilt(self) -> tuple[np.ndarray, np.ndarray]:
        """(turn (3, p), free (3, f)): small rotation of the element by the coefficients of `columns`, rad, and the
        directions about which it is not determined."""
        kind, axis = self.element.kind, self.element.axis
        out = np.zeros((3, self.columns.shape[1]))
        if kind == PLANE:
            first, second = self.element.across()
            n = self._normal
            out[:, 1], out[:, 2] = np.cross(first, n), np.cross(second, n)
            return out, axis[:, None]
        if kind == CYLINDER:
            first, second = self.element.across()
            out[:, 3], out[:, 4] = np.cross(axis, first), np.cross(axis, second)
            return out, axis[:, None]
        if kind == LINE and self.width == 2:
            first, second = self.element.across()
            out[:, 1], out[:, 3] = np.cross(axis, first), np.cross(axis, second)
            return out, axis[:, None]
        if kind == LINE:
            about = np.cross(axis, self._normal)
            out[:, 1] = about
            return out, np.stack([axis, self._normal], axis=1)
        raise Refused("feature-datum-without-direction", f"feature {self.name!r}", element=kind)


def surface(name: str, points, normals=None, element: Element | None = None) -> Surface:
    """The surface of nominal points (n, 3) mm; normals (n, 3) outward unit vectors where they are known."""
    points = np.asarray(points, dtype=float)
    if element is None:
        try:
            element = elements.recognise(points, normals)
        except Refused as refused:
            raise refused.at(f"feature {name!r}") from None
    n, kind = len(points), element.kind
    if kind in (CIRCLE, CYLINDER):
        radial = element.radial(points)
        inside = normals is not None and float((normals * radial).sum()) < 0
        normals = -radial if inside else radial
    elif kind == PLANE:
        inside = normals is not None and float((normals @ element.axis).sum()) < 0
        normals = np.tile(-element.axis if inside else element.axis, (n, 1))
    elif kind == POINT:
        normals = None
    ones, rest = np.ones(n), points - element.centre
    if kind == POINT:
        directions, columns = np.tile(np.eye(3), (n, 1, 1)), np.tile(np.eye(3), (n, 1))
    elif normals is None:  # a line of which only the tool's tip is known
        first, second = element.across()
        directions = np.tile(np.stack([first, second], axis=1), (n, 1, 1))
        s = rest @ element.axis
        columns = np.kron(np.stack([ones, s], axis=1), np.eye(2))[:, [0, 2, 1, 3]]
    else:
        directions = normals[:, :, None]
        columns = _columns(element, rest, normals)
    return Surface(name, element, points, normals, directions, columns)


def _columns(element: Element, rest, normals) -> np.ndarray:
    ones = np.ones(len(rest))
    if element.kind == LINE:
        return np.stack([ones, rest @ element.axis], axis=1)
    first, second = element.across()
    if element.kind == PLANE:
        return np.stack([ones, rest @ first, rest @ second], axis=1)
    cos, sin, height = normals @ first, normals @ second, rest @ element.axis
    columns = [ones, cos, sin]
    if element.kind == CYLINDER:
        columns += [height * cos, height * sin]
    return np.stack(columns, axis=1)


def _rotations(surface: Surface, about) -> np.ndarray:
    """(n m, k) departures by unit rotations about the directions (3, k) through the middle of the surface."""
    arms = surface.points - surface.element.centre
    moved = np.stack([np.cross(a, arms) for a in about.T], axis=2) if about.shape[1] else np.zeros((len(arms), 3, 0))
    return surface.departures(moved)


@dataclass(frozen=True)
class Feature:
    """A tolerance of a surface, perhaps with a datum.

    free : (n m, f) columns that the tolerance leaves free.  own : (p, 3 or f') maps; see `judge`.
    """

    name: str
    kind: Kind
    surface: Surface
    datum: Surface | None = None
    limit: float | None = None
    tilting: np.ndarray | None = None  # (n m, 3) departures by unit rotations of the datum
    free: np.ndarray | None = None
    along: np.ndarray | None = None  # (3, k) directions that the place is judged in


def feature(name: str, kind: str, surface: Surface, datum: Surface | None = None, limit: float | None = None):
    """The `Feature` of a surface.

    Refuses an unknown kind, an element that the kind is not for, too few points, a datum that is missing or stands
    otherwise than the kind says.  limit : mm, or None.
    """
    where = f"feature {name!r}"
    if kind not in KINDS:
        raise Refused("feature-kind-unknown", where, kind=repr(kind)[:60], known=list(KINDS))
    known, element = KINDS[kind], surface.element
    if element.kind not in known.elements:
        raise Refused("feature-element", where, kind=kind, element=element.kind, known=list(known.elements))
    count, fewest = len(np.unique(np.round(surface.points, 6), axis=0)), known.elements[element.kind]
    if count < fewest:
        raise Refused("feature-too-few-points", where, kind=kind, count=count, fewest=fewest)
    if known.group == FORM and independent(surface.columns)[0].shape[1] < surface.columns.shape[1]:
        raise Refused("feature-too-few-points", where, kind=kind, count=count, fewest=fewest)  # all in a line, say
    if known.datum == "needed" and datum is None:
        raise Refused("feature-without-datum", where, kind=kind)
    tilting, free, along = None, surface.columns, None
    if known.group == ORIENTATION:
        _check_angle(where, kind, surface, datum)
        _, loose = datum.tilt
        tilting = _rotations(surface, np.eye(3))
        own = surface.columns[:, :1] if surface.width == 1 else surface.columns[:, [0, 2]]
        if element.kind == CYLINDER:
            own = surface.columns[:, :3]
        free = np.concatenate([own, _rotations(surface, loose)], axis=1)
    elif known.group == PLACE:
        free, along = surface.columns, _judged(where, kind, surface, datum)
    return Feature(name, known, surface, datum if known.datum else None, limit, tilting, free, along)


def _check_angle(where, kind, surface, datum) -> None:
    a, b = (s.element.axis for s in (surface, datum))
    across = [s.element.kind in (PLANE, CIRCLE) for s in (surface, datum)]
    cosine = abs(float(a @ b))
    wanted = _ALONG[kind] if across[0] == across[1] else 1.0 - _ALONG[kind]
    angle = np.arccos(min(1.0, cosine)) if wanted else np.arcsin(min(1.0, cosine))
    if angle > _ANGLE:
        raise Refused("feature-not-so", where, kind=kind, datum=datum.name, angle=float(np.degrees(angle)))


def _judged(where, kind, surface, datum) -> np.ndarray:
    """(3, k) directions in which the place is judged: those in which it is determined, or the one of a distance."""
    u, sizes, _ = np.linalg.svd(surface.place, full_matrices=False)
    known = u[:, sizes > 1e-9]
    if kind != "distance":
        return known
    between = surface.element.centre - datum.element.centre
    if surface.element.kind == PLANE or datum.element.kind == PLANE:
        between = next(s for s in (surface, datum) if s.element.kind == PLANE)._normal * np.sign(
            between @ next(s for s in (surface, datum) if s.element.kind == PLANE)._normal or 1.0
        )
    elif surface.element.kind == datum.element.kind == CYLINDER:
        between = known @ (known.T @ between)
    length = np.linalg.norm(between)
    if length < 1e-6:
        raise Refused("feature-no-distance", where, datum=datum.name)
    return (between / length)[:, None]


@dataclass(frozen=True)
class Judged:
    """value : mm (a distance has a sign).  points, weights : rows and derivative of the value by their departures, of
    a zone; direction : (3,) derivative of the value by the place, of position and distance.  least_squares : the
    value by the least-squares element.  worst : row of the surface's point where the departure is largest."""

    value: float
    least_squares: float
    worst: int
    points: np.ndarray | None = None
    weights: np.ndarray | None = None
    direction: np.ndarray | None = None


def remainder(found: Feature, departures, turn=None) -> np.ndarray:
    """Departures (n m,) less the rotation `turn` (3,) of the datum, rad; the free columns remain."""
    return departures if found.tilting is None else departures - found.tilting @ turn


def judge(found: Feature, departures, turn=None, place=None) -> Judged:
    """The value of a feature from the departures (n m,) of its surface.

    turn : (3,) rotation of the datum, rad (orientation).  place : (3,) of the surface less that of its datum, mm
    (position, distance).
    """
    d = remainder(found, departures, turn)
    m = found.surface.width
    c, *_ = np.linalg.lstsq(found.free, d, rcond=None)
    rest = d - found.free @ c
    sizes = np.linalg.norm(rest.reshape(-1, m), axis=1)
    worst = int(np.argmax(sizes))
    if found.kind.group == PLACE:
        worst = int(np.argmax(np.linalg.norm(d.reshape(-1, m), axis=1)))
        moved = found.along.T @ place
        if found.kind.name == "distance":
            return Judged(float(moved[0]), float(moved[0]), worst, direction=found.along[:, 0])
        length = float(np.linalg.norm(moved))
        direction = found.along @ (moved / length) if length > 0 else found.along[:, 0]
        return Judged(2 * length, 2 * length, worst, direction=2 * direction)
    least = float(np.ptp(rest)) if m == 1 else 2 * float(sizes.max())
    if m == 2:
        zone = smallest_tube(found.free[::2, : found.free.shape[1]][:, _first_half(found.free)], d.reshape(-1, 2))
    else:
        zone = smallest_zone(found.free, d)
    return Judged(zone.width, least, worst, zone.points, zone.weights)


def _first_half(free) -> np.ndarray:
    """Columns that move the first direction of a line only; the second has the same ones."""
    return np.flatnonzero(np.abs(free[::2]).any(axis=0) & ~np.abs(free[1::2]).any(axis=0))


def coefficients(surface: Surface, departures) -> np.ndarray:
    """(p, ...) least-squares coefficients of the surface's own columns in departures (n m, ...)."""
    found, *_ = np.linalg.lstsq(surface.columns, departures, rcond=None)
    return found
