# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a rotating cutter touches a face of the part: the point that cuts lies along the face's normal.

A cutter of radius R with corner radius r (0: flat end, R: ball) has, in the direction n out of the face, the support
point  p + r a - (R - r) h - r n,  p its tip, a its axis upwards, h the unit part of n across the axis.  It touches a
face where this point lies on it.  Planes and cylinders are exact; a cylinder that is not parallel to the axis of the
tool is solved by iteration.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from .elements import PLANE

TOUCH_MM = 0.02  # a path is written to a hundredth of this, and follows curved faces to about this
REACH = 2.0  # radii: how far up its side a cutter may touch a face that ends above its tip
RING = 16  # directions in which the end of a cutter is looked at where its middle is beside a plane
_PARALLEL = 1e-9
_STEPS = 40


@dataclass(frozen=True)
class Cutter:
    """radius, corner : mm.  drill : it makes holes only."""

    radius: float
    corner: float = 0.0
    drill: bool = False


@dataclass(frozen=True)
class Face:
    """A face of the part, mm.

    kind : PLANE or CYLINDER.  point, axis : (3,) a point on it and its outward normal, or a point on its axis and the
    axis.  radius : of a cylinder; sense : +1 where its outward normal points away from its axis, -1 of a bore.
    inside : (n, 3) points on the surface -> (n,) whether they lie within its edges.  corners : (2, 3) of its box.
    area : mm².  closed : of a cylinder, whether it goes all the way round.
    """

    name: str
    kind: str
    point: np.ndarray
    axis: np.ndarray
    radius: float = 0.0
    sense: int = 1
    inside: Callable[[np.ndarray], np.ndarray] = field(default=lambda p: np.ones(len(p), dtype=bool), repr=False)
    corners: np.ndarray = field(default_factory=lambda: np.array([[-1e9] * 3, [1e9] * 3]))
    area: float = 0.0
    closed: bool = True

    def heights(self, up) -> tuple[float, float]:
        """Lowest and highest place of the face along `up` (3,)."""
        ends = np.where(up > 0, self.corners[0], self.corners[1]), np.where(up > 0, self.corners[1], self.corners[0])
        return float(ends[0] @ up), float(ends[1] @ up)


@dataclass(frozen=True)
class Contact:
    """rows : (k,) of the tips that touch.  points : (k, 3) mm on the face.  normals : (k, 3) outward, NaN where a hole
    is made along its axis: `points` are those of the axis then, and `axial` is true."""

    rows: np.ndarray
    points: np.ndarray
    normals: np.ndarray
    axial: bool = False


def contact(face: Face, tips, cutter: Cutter, up, tolerance: float = TOUCH_MM) -> Contact:
    """Where a cutter touches a face.  tips : (n, 3) mm.  up : (3,) unit axis of the tool, from its tip upwards."""
    tips, up = np.asarray(tips, dtype=float), np.asarray(up, dtype=float)
    near = _near(face, tips, cutter, tolerance)
    if face.kind == PLANE:
        found = None if cutter.drill else _plane(face, tips[near], cutter, up, tolerance)
    elif np.abs(np.cross(face.axis, up)).max() < 1e-7:
        found = _upright(face, tips[near], cutter, up, tolerance)
    else:
        found = None if cutter.drill else _lying(face, tips[near], cutter, up, tolerance)
    if found is None:
        return Contact(np.empty(0, dtype=int), np.empty((0, 3)), np.empty((0, 3)))
    rows, points, normals, axial = found
    if not axial:
        keep = face.inside(points)
        rows, points, normals = rows[keep], points[keep], normals[keep]
    return Contact(near[rows], points, normals, axial)


def _near(face: Face, tips, cutter: Cutter, tolerance: float) -> np.ndarray:
    """Rows of the tips from which the face's box is within the cutter's reach."""
    margin = (1 + REACH) * cutter.radius + tolerance
    low, high = face.corners[0] - margin, face.corners[1] + margin
    return np.flatnonzero(((tips >= low) & (tips <= high)).all(axis=1))


def support(tips, normals, cutter: Cutter, up) -> np.ndarray:
    """(n, 3) point of the cutter that is first in the direction against `normals` (n, 3)."""
    across = normals - (normals @ up)[:, None] * up
    size = np.linalg.norm(across, axis=1)
    h = np.where(size[:, None] > _PARALLEL, across / np.maximum(size, _PARALLEL)[:, None], 0.0)
    return tips + cutter.corner * up - (cutter.radius - cutter.corner) * h - cutter.corner * normals


def _raised(face: Face, points, tips, cutter: Cutter, up) -> np.ndarray:
    """Points on a wall, moved up the side of the cutter to the face's lower edge where they are below it."""
    low, high = face.heights(up)
    height = points @ up
    to = np.clip(height, low, max(high, low))
    lifted = points + (to - height)[:, None] * up
    reach = (lifted - tips) @ up <= REACH * cutter.radius + cutter.corner
    return np.where(((to >= height - 1e-9) & reach)[:, None], lifted, points)


def _plane(face: Face, tips, cutter: Cutter, up, tolerance: float):
    n = face.axis
    rise = float(n @ up)
    if rise < -1e-7:
        return None  # it looks down: no cutter from above touches it
    normals = np.tile(n, (len(tips), 1))
    points = support(tips, normals, cutter, up)
    off = (points - face.point) @ n
    rows = np.flatnonzero(np.abs(off) <= tolerance)
    points = points[rows] - off[rows, None] * n
    if abs(rise) < 1e-7:
        points = _raised(face, points, tips[rows], cutter, up)
    elif rise > 1 - 1e-12 and cutter.radius > cutter.corner and len(rows):
        beside = np.flatnonzero(~face.inside(points))
        points[beside] = _under_the_end(face, points[beside], cutter, n)
    return rows, points, normals[rows], False


def _under_the_end(face: Face, points, cutter: Cutter, n) -> np.ndarray:
    """Points of a plane below the flat of a cutter whose middle is beside it, where there is one; else as they are."""
    first = np.cross(n, np.eye(3)[int(np.argmin(np.abs(n)))])
    first /= np.linalg.norm(first)
    second, out = np.cross(n, first), points.copy()
    left = np.arange(len(points))
    for share in (0.98, 0.5):
        for k in range(RING):
            angle = 2 * np.pi * k / RING
            arm = share * (cutter.radius - cutter.corner) * (np.cos(angle) * first + np.sin(angle) * second)
            if not len(left):
                return out
            hit = face.inside(points[left] + arm)
            out[left[hit]] = points[left[hit]] + arm
            left = left[~hit]
    return out


def _from_axis(face: Face, points) -> tuple[np.ndarray, np.ndarray]:
    """((n, 3) unit vectors from the axis, (n,) distances)."""
    rest = points - face.point
    rest = rest - (rest @ face.axis)[:, None] * face.axis
    size = np.linalg.norm(rest, axis=1)
    return rest / np.maximum(size, 1e-12)[:, None], size


def _upright(face: Face, tips, cutter: Cutter, up, tolerance: float):
    """A cylinder parallel to the tool: its wall is milled, or the whole hole is made along its axis."""
    out, size = _from_axis(face, tips)
    low, high = face.heights(up)
    if face.sense < 0 and abs(cutter.radius - face.radius) <= tolerance:
        rows = np.flatnonzero(size <= tolerance)
        points = tips[rows] - (out * size[:, None])[rows]
        height = points @ up
        within = (height >= low - 1e-6) & (height <= high + 1e-6)
        return rows[within], points[within], np.full((int(within.sum()), 3), np.nan), True
    if cutter.drill:
        return None
    rows = np.flatnonzero(np.abs(size - face.radius - face.sense * cutter.radius) <= tolerance)
    points = tips[rows] + (face.radius - size[rows])[:, None] * out[rows] + cutter.corner * up
    points = _raised(face, points, tips[rows], cutter, up)
    return rows, points, face.sense * out[rows], False


def _lying(face: Face, tips, cutter: Cutter, up, tolerance: float):
    """A cylinder across the tool, or inclined: the normal at the point of contact by iteration (exact for a ball)."""
    n = face.sense * _from_axis(face, tips + cutter.corner * up)[0]
    for _ in range(1 if cutter.corner == cutter.radius else _STEPS):
        n = face.sense * _from_axis(face, support(tips, n, cutter, up) + cutter.corner * n)[0]
    points = support(tips, n, cutter, up)
    out, size = _from_axis(face, points)
    rows = np.flatnonzero((np.abs(size - face.radius) <= tolerance) & (n @ up > -1e-7))
    points = points[rows] + (face.radius - size[rows])[:, None] * out[rows]
    return rows, points, n[rows], False
