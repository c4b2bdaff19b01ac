# SPDX-License-Identifier: LGPL-2.1-or-later
"""The flat and round faces of a solid as arrays, in bounded time: all that contacts and guides are read from.

A solid is one connected skin: a fusion or an a2plus part that holds many is taken apart.  Equal shapes are looked at
once.  What takes too long is sampled, and said to be.  Meshes give their flat regions.
"""

from __future__ import annotations

import time
from dataclasses import dataclass, field

import FreeCAD as App
import numpy as np
import Part

from .. import curves

MOST_FACES = 700  # of one shape; of more every n-th is looked at
SECONDS = 0.8  # for one shape
MOST_TRIANGLES = 60000
MOST_SKINS = 400  # of one object


@dataclass
class Solid:
    """One connected skin.  Planes: normal, offset n·x, box; cylinders: point, axis, radius, outside, box; in mm.

    box : (6,) low and high corner.  planes (n, 3), offsets (n,), plane_boxes (n, 6), areas (n,);
    points (m, 3), axes (m, 3), radii (m,), outside (m,), round_boxes (m, 6).
    """

    box: np.ndarray
    planes: np.ndarray = field(default_factory=lambda: np.zeros((0, 3)))
    offsets: np.ndarray = field(default_factory=lambda: np.zeros(0))
    plane_boxes: np.ndarray = field(default_factory=lambda: np.zeros((0, 6)))
    points: np.ndarray = field(default_factory=lambda: np.zeros((0, 3)))
    axes: np.ndarray = field(default_factory=lambda: np.zeros((0, 3)))
    radii: np.ndarray = field(default_factory=lambda: np.zeros(0))
    outside: np.ndarray = field(default_factory=lambda: np.zeros(0, bool))
    round_boxes: np.ndarray = field(default_factory=lambda: np.zeros((0, 6)))
    faces: int = 0
    sampled: bool = False

    @property
    def size(self) -> np.ndarray:
        """(3,) extent of its bounding box, mm."""
        return self.box[3:] - self.box[:3]

    def placed(self, placement: App.Placement) -> Solid:
        """The same solid where a placement puts it."""
        matrix = placement.toMatrix()
        values = np.array(matrix.A).reshape(4, 4)
        turn, shift = values[:3, :3], values[:3, 3]
        planes = self.planes @ turn.T
        return Solid(
            _turned(self.box[None], turn, shift)[0], planes, self.offsets + planes @ shift,
            _turned(self.plane_boxes, turn, shift), self.points @ turn.T + shift, self.axes @ turn.T, self.radii,
            self.outside, _turned(self.round_boxes, turn, shift), self.faces, self.sampled,
        )  # fmt: skip

    def scaled(self, k: float) -> Solid:
        """The same solid, k times as large."""
        return Solid(
            self.box * k, self.planes, self.offsets * k, self.plane_boxes * k, self.points * k, self.axes,
            self.radii * k, self.outside, self.round_boxes * k, self.faces, self.sampled,
        )  # fmt: skip

    def extent(self, u: np.ndarray) -> tuple[float, float]:
        """Lowest and highest coordinate along the unit vector u, of the box: exact along its axes."""
        middle, half = (self.box[3:] + self.box[:3]) / 2, (self.box[3:] - self.box[:3]) / 2
        at, reach = float(middle @ u), float(half @ np.abs(u))
        return at - reach, at + reach


def _is_square(placement: App.Placement) -> bool:
    """Whether a placement takes axes to axes."""
    turn = np.array(placement.toMatrix().A).reshape(4, 4)[:3, :3]
    return bool(np.all(np.abs(turn).max(1) > 0.999999))


def _turned(boxes: np.ndarray, turn: np.ndarray, shift: np.ndarray) -> np.ndarray:
    middle, half = (boxes[:, 3:] + boxes[:, :3]) / 2, (boxes[:, 3:] - boxes[:, :3]) / 2
    middle, half = middle @ turn.T + shift, half @ np.abs(turn).T
    return np.hstack([middle - half, middle + half])


class Looker:
    """Looks at shapes, each once, within a time for all.  sampled : how many were looked at in part only.

    seconds : of the processor, so that a busy computer sees the same; nearly twice as much by the clock, not more.
    """

    def __init__(self, seconds: float = 8.0):
        self.until, self.deadline = time.thread_time() + seconds, time.monotonic() + 1.9 * seconds
        self.known: dict[tuple, list] = {}
        self.sampled = 0

    def wait(self, function):
        """Call function() and return its answer; the time that it takes is not time of looking."""
        thread, clock = time.thread_time(), time.monotonic()
        answer = function()
        self.until += time.thread_time() - thread
        self.deadline += time.monotonic() - clock
        return answer

    def solids(self, shape, turn: App.Placement | None = None) -> list[Solid]:
        """The solids of a shape, in its own place, seen in the frame that `turn` leads to.

        A shape that stands askew is looked at as it stands, so that its boxes are tight.
        """
        if not curves.is_something(shape):
            return []
        try:
            placement = shape.Placement if turn is None else turn.multiply(shape.Placement)
            bare = Part.Shape(shape)
            bare.Placement = App.Placement()
            key = bare.hashCode()
            stands = App.Placement() if _is_square(placement) else App.Placement(App.Vector(), placement.Rotation)
            askew = tuple(round(v, 5) for v in stands.Rotation.Q)
            known = self.known.setdefault((key, askew), [])
            found = next((solids for other, solids in known if other.isPartner(bare)), None)
            if found is None:
                seen = Part.Shape(bare)
                seen.Placement = stands
                found = self._look(seen)
                self.sampled += any(s.sampled for s in found)
                known.append((bare, found))
            rest = placement.multiply(stands.inverse())
        except curves.FAILS:
            return []
        return [s.placed(rest) for s in found]

    def _look(self, shape) -> list[Solid]:
        faces = curves.parts(shape, "Faces")
        if not faces:
            return []
        hurry = time.thread_time() > self.until or time.monotonic() > self.deadline
        if hurry or len(faces) > 20 * MOST_FACES:
            box = curves.box(shape)
            return [] if box is None else [Solid(_array(box), faces=len(faces), sampled=True)]
        groups = skins(faces)
        if len(groups) > MOST_SKINS:
            groups = sorted(groups, key=len, reverse=True)[:MOST_SKINS]
        total = sum(map(len, groups))
        share = max(1, -(-total // (8 * MOST_FACES)))  # of a lump of many solids
        end = min(self.until, time.thread_time() + SECONDS * (1 + min(5.0, 0.2 * len(groups))))
        steps = [max(share if len(group) > 40 else 1, -(-len(group) // MOST_FACES)) for group in groups]
        found = [_solid([faces[i] for i in group], step, end) for group, step in zip(groups, steps)]
        return [s for s in found if s is not None]


def skins(faces) -> list[list[int]]:
    """Numbers of the faces that hang together by shared edges, each group a skin."""
    group = list(range(len(faces)))

    def root(i):
        while group[i] != i:
            group[i] = group[group[i]]
            i = group[i]
        return i

    seen: dict[int, int] = {}
    for i, face in enumerate(faces):
        for edge in curves.parts(face, "Edges"):
            other = seen.setdefault(edge.hashCode(), i)
            if other != i:
                group[root(i)] = root(other)
    made: dict[int, list[int]] = {}
    for i in range(len(faces)):
        made.setdefault(root(i), []).append(i)
    return list(made.values())


def _array(box) -> np.ndarray:
    return np.array([box.XMin, box.YMin, box.ZMin, box.XMax, box.YMax, box.ZMax])


def _solid(faces, step: int, end: float) -> Solid | None:
    boxes, planes, rounds, sampled = [], [], [], step > 1
    for n, face in enumerate(faces):
        box = curves.box(face)
        if box is None:
            continue
        box = _array(box)
        boxes.append(box)
        if step > 1 and n % step:
            continue
        if time.thread_time() > end:
            sampled = True
            continue
        normal = curves.plane(face)
        if normal is not None:
            try:
                u0, u1, v0, v1 = face.ParameterRange
                point = face.valueAt((u0 + u1) / 2, (v0 + v1) / 2)
            except curves.FAILS:
                continue
            planes.append((tuple(normal), normal.dot(point), box))
            continue
        found = curves.cylinder(face)
        if found is not None:
            rounds.append((tuple(found[0]), tuple(found[1]), found[2], found[3], box))
    if not boxes:
        return None
    boxes = np.array(boxes)
    return _made(np.hstack([boxes[:, :3].min(0), boxes[:, 3:].max(0)]), planes, rounds, len(faces), sampled)


def _made(box, planes, rounds, count: int, sampled: bool) -> Solid:
    made = Solid(box, faces=count, sampled=sampled)
    if planes:
        made.planes = np.array([p[0] for p in planes])
        made.offsets = np.array([p[1] for p in planes])
        made.plane_boxes = np.array([p[2] for p in planes])
    if rounds:
        made.points = np.array([r[0] for r in rounds])
        made.axes = np.array([r[1] for r in rounds])
        made.radii = np.array([r[2] for r in rounds])
        made.outside = np.array([r[3] for r in rounds], bool)
        made.round_boxes = np.array([r[4] for r in rounds])
    return made


def of_mesh(mesh) -> list[Solid]:
    """One solid of the flat regions of a mesh, in document coordinates."""
    try:
        points, triangles = mesh.Topology
        corners = np.array([tuple(p) for p in points], float)
        numbers = np.array(triangles, int)
    except curves.FAILS:
        return []
    if not len(corners) or not len(numbers):
        return []
    box = np.hstack([corners.min(0), corners.max(0)])
    sampled = len(numbers) > MOST_TRIANGLES
    if sampled:
        numbers = numbers[:: -(-len(numbers) // MOST_TRIANGLES)]
    a, b, c = (corners[numbers[:, k]] for k in range(3))
    normals = np.cross(b - a, c - a)
    twice = np.linalg.norm(normals, axis=1)
    good = twice > 1e-9
    normals, a, b, c, twice = normals[good] / twice[good][:, None], a[good], b[good], c[good], twice[good]
    offsets = np.einsum("ij,ij->i", normals, a)
    size = float(np.linalg.norm(box[3:] - box[:3]))
    keys = np.round(np.hstack([normals * 200, offsets[:, None] / max(1e-9, 2e-4 * size)])).astype(int)
    _, group = np.unique(keys, axis=0, return_inverse=True)
    group = np.asarray(group).ravel()
    areas = np.bincount(group, twice / 2)
    planes = []
    for g in np.argsort(-areas)[:120]:
        if areas[g] < 1e-4 * size**2:
            break
        inside = group == g
        xyz = np.vstack([a[inside], b[inside], c[inside]])
        first = int(np.argmax(inside))
        planes.append((tuple(normals[first]), offsets[first], np.hstack([xyz.min(0), xyz.max(0)])))
    return [_made(box, planes, [], len(numbers), sampled)]
