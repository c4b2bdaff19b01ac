# SPDX-License-Identifier: LGPL-2.1-or-later
"""Features from the faces of a solid: which points of a path cut which face, and what is judged of it.

A point that touches several faces (the wall and the bottom of a pocket) becomes one point for each of them, with the
point of contact and the normal of the face; a point that touches none keeps the tip.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..core.contact import TOUCH_MM, Contact, Cutter, Face, contact
from ..core.elements import CYLINDER, PLANE, POINT
from ..core.machine import Machine
from ..core.refusal import Refused
from ..core.toolpath import ToolPath
from ..core.workspace import Cancelled
from ..messages import Message
from .part import FeatureRequest, features_on

MOST_POINTS = 4000  # of one face: more points of a path than these are thinned
ALIKE_MM = 1e-3  # radii of the holes of a pattern
_PARALLEL = 1e-4  # rad


@dataclass(frozen=True)
class Faced:
    """path : with a label for each face that is cut.  faces : those, the largest first.  axial : names of the holes of
    which only the axis is known.  features : what is judged where nothing else is asked.  remarks : of faces of which
    nothing can be judged, and of none at all."""

    path: ToolPath
    faces: tuple[Face, ...]
    axial: frozenset[str]
    features: tuple[FeatureRequest, ...]
    remarks: tuple[Message, ...] = ()


def tips_of(machine: Machine, path: ToolPath, xyz) -> tuple[np.ndarray, np.ndarray]:
    """((P, 3) tip in the coordinates of the program, (3, 3) directions of X, Y, Z in the machine frame as rows)."""
    if min(xyz) < 0 or not all(j.slides for j in machine.joints):
        raise Refused("part-faces-axes", machine.name, known=list(machine.names))
    directions = np.stack([machine.directions[k] for k in "XYZ"])
    beside = (path.tip - path.contact) @ np.linalg.inv(directions)
    return path.written[:, list(xyz)] + beside, directions


def on_faces(
    machine: Machine,
    path: ToolPath,
    faces: Sequence[Face],
    cutters: Mapping[int, Cutter],
    tool: np.ndarray,
    xyz: Sequence[int],
    tolerance: float = TOUCH_MM,
    progress: Callable[[float], bool] | None = None,
) -> Faced:
    """The path with its points assigned to the faces that they cut.

    faces : in the coordinates of the program, mm.  cutters : tool number -> its shape; tools without one touch nothing.
    tool : (P,) number of the tool at each point.  xyz : columns of the joints X, Y, Z.  progress : called with the part
    done; a false answer cancels.  Refuses machines without X, Y, Z, and those with rotary joints.
    """
    tips, directions = tips_of(machine, path, xyz)
    up = np.array([0.0, 0.0, 1.0])
    found: list[tuple[Face, Contact]] = []
    steps = [(face, number) for face in faces for number in cutters]
    for i, (face, number) in enumerate(steps):
        if progress is not None and not progress(i / len(steps)):
            raise Cancelled("cancelled")
        rows = np.flatnonzero(path.cutting & (tool == number))
        rows = _thinned(face, rows, tips, cutters[number])
        one = contact(face, tips[rows], cutters[number], up, tolerance)
        if len(one.rows):
            found.append((face, replace(one, rows=rows[one.rows])))
    return _assigned(machine, path, tips, directions, found)


def _thinned(face: Face, rows, tips, cutter: Cutter) -> np.ndarray:
    """At most 8 MOST_POINTS of the rows that are near the face: the search for its edges is slow."""
    margin = 3 * cutter.radius + 1.0
    near = ((tips[rows] >= face.corners[0] - margin) & (tips[rows] <= face.corners[1] + margin)).all(axis=1)
    rows = rows[near]
    return rows[:: max(1, len(rows) // (8 * MOST_POINTS))]


def _assigned(machine, path: ToolPath, tips, directions, found) -> Faced:
    by_face: dict[str, list[tuple[Face, Contact]]] = {}
    for face, one in found:
        by_face.setdefault(face.name, []).append((face, one))
    touched, parts, axial = [], [], set()
    for name, group in by_face.items():
        walls = [c for _, c in group if not c.axial]
        if not walls:
            axial.add(name)
        chosen = walls or [c for _, c in group]  # a bore that is milled after drilling is judged by its wall
        rows, points, normals = (np.concatenate([getattr(c, k) for c in chosen]) for k in ("rows", "points", "normals"))
        pick = np.argsort(rows, kind="stable")
        pick = pick[:: max(1, len(pick) // MOST_POINTS)]
        touched.append(group[0][0])
        parts.append((rows[pick], points[pick], normals[pick]))
    touched_order = sorted(range(len(touched)), key=lambda i: -touched[i].area)
    path = _repeated(path, tips, directions, parts, [f.name for f in touched])
    faces = tuple(touched[i] for i in touched_order)
    features, remarks = _usual(machine, path, faces, axial)
    if not faces:
        remarks.append(Message("part-faces-none", limit=TOUCH_MM))
    return Faced(path, faces, frozenset(axial), tuple(features), tuple(remarks))


def _repeated(path: ToolPath, tips, directions, parts, names) -> ToolPath:
    """The path with one point for each contact; points that other features are made of stay besides."""
    count = path.points
    contacts = np.concatenate([p[0] for p in parts]) if parts else np.empty(0, dtype=int)
    stays = np.ones(count, dtype=bool)
    stays[contacts] = False
    for rows in path.labels.values():
        stays[rows] = True
    own = np.flatnonzero(stays)
    source = np.concatenate([own, contacts])
    order = np.argsort(source, kind="stable")
    new = np.empty(len(order), dtype=int)
    new[order] = np.arange(len(order))
    source = source[order]
    normal, place = path.normal[source], path.contact[source]
    labels, at = {}, len(own)
    where = np.full(count, -1)
    where[own] = new[: len(own)]
    for name, rows in path.labels.items():
        labels[name] = where[rows]
    for name, (rows, points, normals) in zip(names, parts):
        here = new[at : at + len(rows)]
        at += len(rows)
        normal[here] = normals @ directions
        place[here] = path.tip[rows] + (points - tips[rows]) @ directions
        labels[name] = here
    taken = {k: getattr(path, k)[source] for k in ("q", "line", "cutting", "tip", "written")}
    for name in ("move", "fraction"):
        values = getattr(path, name)
        taken[name] = None if values is None else values[source]
    columns = {name: values[source] for name, values in path.columns.items()}
    return ToolPath(normal=normal, contact=place, columns=columns, labels=labels, **taken)


def _usual(machine, path: ToolPath, faces, axial) -> tuple[list[FeatureRequest], list[Message]]:
    """The form of every face but rounded corners and drilled holes; planes and bores to the largest plane; the holes of
    a pattern to its first one."""
    asked, skipped, made = [], [], {}
    for face in (f for f in faces if f.closed):  # nobody draws a tolerance at the rounded corner of a pocket
        try:
            made[face.name] = features_on(machine, path, [FeatureRequest(face.name)])[0].surface.element
        except Refused:  # too few points, or parts of it that lie on no element
            skipped.append(face.name)
            continue
        if made[face.name].kind == POINT:
            del made[face.name]
            skipped.append(face.name)
            continue
        if face.name in axial:  # the axis of a drilled hole: its place is judged, not how straight it is
            continue
        asked.append(FeatureRequest(face.name))
    more = []
    datum = next((f.name for f in faces if f.name in made and made[f.name].kind == PLANE), None)
    if datum is not None:
        for name, element in made.items():
            more += [] if name == datum else _to_datum(name, element, datum, made[datum])
    for group in _patterns(faces, made, axial):
        for name in group[1:]:
            more += [
                FeatureRequest(f"{name} to {group[0]}, {k}", k, group[0], label=name) for k in ("position", "distance")
            ]
    for one in more:
        try:
            features_on(machine, path, [one])
        except Refused:
            continue
        asked.append(one)
    return asked, [Message("part-faces-skipped", names=skipped)] if skipped else []


def _to_datum(name: str, element, datum: str, plane) -> list[FeatureRequest]:
    if element.kind not in (PLANE, CYLINDER):
        return []
    cosine = abs(float(element.axis @ plane.axis))
    along, across = cosine > np.cos(_PARALLEL), cosine < np.sin(_PARALLEL)
    if not (along or across):
        return []
    kinds = ["parallelism"] if (element.kind == PLANE) == along else ["perpendicularity"]
    if element.kind == PLANE and along:
        kinds.append("distance")
    return [FeatureRequest(f"{name} to {datum}, {k}", k, datum, label=name) for k in kinds]


def _patterns(faces, made, axial) -> list[list[str]]:
    """Names of the bores of equal radius and direction, two or more in each group, in the order of their names."""
    groups: list[list[Face]] = []
    bores = [f for f in faces if f.kind == CYLINDER and f.sense < 0 and f.name in made]
    for face in sorted(bores, key=lambda f: (len(f.name), f.name)):
        for group in groups:
            first = group[0]
            alike = abs(first.radius - face.radius) < ALIKE_MM and (first.name in axial) == (face.name in axial)
            if alike and np.linalg.norm(np.cross(first.axis, face.axis)) < _PARALLEL:
                across = face.point - first.point
                if np.linalg.norm(across - (across @ first.axis) * first.axis) > ALIKE_MM:
                    group.append(face)
                break
        else:
            groups.append([face])
    return [[f.name for f in group] for group in groups if len(group) > 1]
