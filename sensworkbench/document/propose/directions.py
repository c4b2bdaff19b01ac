# SPDX-License-Identifier: LGPL-2.1-or-later
"""Directions in which something may move, for a person to choose from where too few axes were found.

A long thin prism is a rail, a long cylinder a screw; where they show fewer than three directions, the longest straight
edges are taken.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import permutations

import FreeCAD as App

from ...core.errors import AXES
from ...messages import Refused
from .. import curves
from ..imported import Piece, pieces_of
from .building import along

SLENDER = 8.0  # length over width of a rail, length over diameter of a screw
FULL = 0.4  # a rail fills this much of its box
ROUND = 0.45  # a cylinder's face goes round at least this far, half of it in some files
LONG = 0.15  # a guide is at least this long, measured by the whole machine
PARALLEL = 0.02  # rad
UNIT = {name: App.Vector(*[float(k == i) for k in range(3)]) for i, name in enumerate(AXES)}


@dataclass
class AxisProposal:
    """A direction in which something may move.  source : (object, path with element) for `make_axis(direction=...)`.

    direction : unit vector, document coordinates.  axis : the letter that fits best, "" for all but three.
    length : of its guide, mm.  score : the lengths of all guides in this direction, mm.  why : in words.
    """

    axis: str
    direction: App.Vector
    source: tuple
    reverse: bool
    length: float
    score: float
    why: str


@dataclass(frozen=True, eq=False)
class Guide:
    """A rail or screw of piece number `piece`, along a unit vector.  length : mm."""

    kind: str
    piece: int
    direction: App.Vector
    length: float


def propose_axes(objects) -> list[AxisProposal]:
    """Directions of motion that the geometry of the objects suggests, best first; changes nothing.

    From rails and screws; where there are fewer than three directions, from the longest straight edges.  At most one
    proposal per direction; X, Y and Z are given to the three best that are not parallel.  Refuses objects without
    solids.
    """
    pieces = pieces_of(objects)
    if not pieces:
        raise Refused("proposal-no-solids", "selection")
    clusters: list[list] = []  # [direction, score, longest, piece, why]
    for guide in guides(pieces):
        _count(clusters, guide.direction, guide.length, guide.length, guide.piece, guide.kind)
    if len(clusters) < 3:
        for p, piece in enumerate(pieces):
            for solid in piece.solids:
                edge = longest_edge(solid)
                if edge is not None:
                    _count(clusters, _along(edge), 1e-3 * edge.Length, edge.Length, p, "longest edge")
    clusters.sort(key=lambda c: -c[1])
    linked = [(c, found) for c in clusters if (found := along(pieces[c[3]].where, c[0], None)) is not None]
    letters = _letters([c[0] for c, _ in linked[:3]])
    return [
        AxisProposal(letter, u, source, reverse, length, score, f"{why} {pieces[p].label!r}")
        for ((u, score, length, p, why), (source, reverse)), letter in zip(linked, letters + [""] * len(linked))
    ]


def _count(clusters, u, score, length, p, why) -> None:
    for cluster in clusters:
        if cluster[0].cross(u).Length < PARALLEL:
            cluster[1] += score
            return
    clusters.append([u, score, length, p, why])


def _letters(directions) -> list[str]:
    """X, Y, Z for up to three directions, each as near to its document axis as can be."""
    best = max(
        permutations(AXES, len(directions)),
        key=lambda order: sum(abs(u.dot(UNIT[a])) for u, a in zip(directions, order)),
    )
    return list(best)


# -- guides ----------------------------------------------------------------------------------------------------------
def guides(pieces: list[Piece]) -> list[Guide]:
    """All rails and screws, longest first."""
    total = App.BoundBox()
    for piece in pieces:
        total.add(piece.box)
    shortest = LONG * total.DiagonalLength / 3**0.5
    found = []
    for p, piece in enumerate(pieces):
        for solid in piece.solids:
            guide = _screw(p, solid) or _rail(p, solid)
            if guide is not None and guide.length >= shortest:
                found.append(guide)
    return sorted(found, key=lambda g: -g.length)


def _rail(p: int, solid) -> Guide | None:
    edge = longest_edge(solid)
    if edge is None:
        return None
    u = _along(edge)
    turned = solid.copy()
    turned.rotate(App.Vector(), *_to_z(u))
    box = turned.BoundBox
    wide = max(box.XLength, box.YLength)
    if wide <= 0 or box.ZLength < SLENDER * wide:
        return None
    if solid.Volume < FULL * box.XLength * box.YLength * box.ZLength:
        return None
    return Guide("rail", p, u, box.ZLength)


def _screw(p: int, solid) -> Guide | None:
    best = None
    for face in curves.parts(solid, "Faces"):
        found = curves.cylinder(face)
        if found is not None and found[3]:
            _, axis, radius, _ = found
            u = _signed(axis)
            values = [v.Point.dot(u) for v in face.Vertexes]
            length = max(values) - min(values) if values else 0.0
            if face.Area < ROUND * 2 * math.pi * radius * length:  # a rounded edge
                continue
            if length >= SLENDER * 2 * radius and (best is None or length > best.length):
                best = Guide("screw", p, u, length)
    return best


def longest_edge(shape):
    """The longest straight edge, or None."""
    straight = [e for e in curves.parts(shape, "Edges") if curves.line(e) is not None]
    return max(straight, key=lambda e: e.Length, default=None)


def _along(edge) -> App.Vector:
    return _signed(curves.line(edge))


def _signed(u: App.Vector) -> App.Vector:
    """The same line, pointing to where its largest coordinate grows."""
    return u if max(u, key=abs) > 0 else u * -1.0


def _to_z(u: App.Vector) -> tuple[App.Vector, float]:
    """Axis and angle in degrees that turn u to z; that keeps the coordinate along u as z."""
    turn = App.Rotation(u, App.Vector(0, 0, 1))
    return turn.Axis, math.degrees(turn.Angle)
