# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find which solids of a machine slide on which, from geometry alone: rails, screws, and the solids that touch them.

A long thin prism is a rail, a long cylinder a screw.  A solid that covers most of a rail is its seat and belongs to it;
a solid that touches it only over part of its length slides on it.  All other solids that touch are bolted together.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import FreeCAD as App

from . import curves
from .paths import Place

TOUCHING = 0.05  # mm
CLEARANCE = 0.15  # of a guide's width: what stands this close to it may slide on it
SLENDER = 8.0  # length over width of a rail, length over diameter of a screw
FULL = 0.4  # a rail fills this much of its box
SEAT = 0.6  # a seat covers this much of a rail
END = 0.2  # what holds a screw does so within this part of its length at either end
ROUND = 0.45  # a cylinder's face goes round at least this far, half of it in some files
LONG = 0.15  # a guide is at least this long, measured by the whole machine
PARALLEL = 0.02  # rad


@dataclass
class Piece:
    """One object with its solids, document coordinates."""

    where: Place
    solids: list
    boxes: list = field(default_factory=list)

    def __post_init__(self):
        self.boxes = [s.BoundBox for s in self.solids]

    @property
    def label(self) -> str:
        """Return the label of the part."""
        return self.where.object.Label

    @property
    def volume(self) -> float:
        """Return the volume of its solids, mm^3."""
        return sum(s.Volume for s in self.solids)

    @property
    def box(self):
        """Return the bounding box of its solids."""
        total = App.BoundBox()
        for box in self.boxes:
            total.add(box)
        return total


@dataclass(frozen=True, eq=False)
class Guide:
    """A rail or screw: solid `solid` of piece `piece`, along a unit vector, from `low` to `high` on it.  mm."""

    kind: str
    piece: int
    solid: int
    direction: App.Vector
    low: float
    high: float
    width: float

    @property
    def length(self) -> float:
        """Return the length, mm."""
        return self.high - self.low


@dataclass(frozen=True, eq=False)
class Sliding:
    """Piece `on` slides along `guide`, which it covers from `low` to `high`."""

    guide: Guide
    on: int
    low: float
    high: float


def extent(shape, u: App.Vector) -> tuple[float, float]:
    """Lowest and highest coordinate of a shape along the unit vector u (of its box; exact along an axis)."""
    box = shape.BoundBox
    corners = [App.Vector(x, y, z).dot(u) for x in (box.XMin, box.XMax) for y in (box.YMin, box.YMax)
               for z in (box.ZMin, box.ZMax)]  # fmt: skip
    return min(corners), max(corners)


# -- guides ----------------------------------------------------------------------------------------------------------
def guides(pieces: list[Piece]) -> list[Guide]:
    """All rails and screws, longest first."""
    total = App.BoundBox()
    for piece in pieces:
        total.add(piece.box)
    shortest = LONG * total.DiagonalLength / 3**0.5
    found = []
    for p, piece in enumerate(pieces):
        for s, solid in enumerate(piece.solids):
            guide = _screw(p, s, solid) or _rail(p, s, solid)
            if guide is not None and guide.length >= shortest:
                found.append(guide)
    return sorted(found, key=lambda g: -g.length)


def _rail(p: int, s: int, solid) -> Guide | None:
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
    return Guide("rail", p, s, u, box.ZMin, box.ZMax, wide)


def _screw(p: int, s: int, solid) -> Guide | None:
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
                best = Guide("screw", p, s, u, min(values), max(values), 2 * radius)
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


# -- contacts --------------------------------------------------------------------------------------------------------
@dataclass(frozen=True)
class Contact:
    """Two solids of different pieces that touch, or that are close to each other if one of them is a guide."""

    one: tuple[int, int]  # piece, solid
    other: tuple[int, int]
    gap: float  # mm


def contacts(pieces: list[Piece], found_guides: list[Guide], progress=None) -> list[Contact]:
    """Return all pairs of solids of different pieces that touch, and the solids close to a guide."""
    known = {(g.piece, g.solid): CLEARANCE * g.width for g in found_guides}
    flat = [(p, s, solid, box) for p, piece in enumerate(pieces)
            for s, (solid, box) in enumerate(zip(piece.solids, piece.boxes))]  # fmt: skip
    near = []
    for i, (p, s, solid, box) in enumerate(flat):
        for q, r, other, box_ in flat[:i]:
            if p == q:
                continue
            allowed = max(known.get((p, s), TOUCHING), known.get((q, r), TOUCHING))
            wide = App.BoundBox(box)
            wide.enlarge(2 * allowed)
            if wide.intersect(box_):
                near.append(((p, s), (q, r), solid, other, allowed))
    found = []
    for n, (one, other, solid, solid_, allowed) in enumerate(near):
        if progress is not None and progress(n, len(near)):
            break
        gap = solid.distToShape(solid_)[0]
        if gap <= allowed:
            found.append(Contact(one, other, gap))
    return found


def sort_contacts(pieces: list[Piece], found_guides: list[Guide], found: list[Contact]):
    """(pairs of pieces that are bolted together, what slides on what) out of all contacts."""
    known = {(g.piece, g.solid): g for g in found_guides}
    on_guide: dict[Guide, list] = {g: [] for g in found_guides}
    bolted, sliding = [], []
    for contact in found:
        guide, other = known.get(contact.one), contact.other
        back = known.get(contact.other)
        if guide is None or (back is not None and back.length > guide.length):
            guide, other = back, contact.one
        if guide is None:
            bolted.append((contact.one[0], contact.other[0]))
        else:
            solid = pieces[other[0]].solids[other[1]]
            on_guide[guide].append((other[0], *extent(solid, guide.direction), contact.gap))
    for guide, others in on_guide.items():
        most = max((_covered(guide, low, high) for _, low, high, gap in others if gap <= TOUCHING), default=0.0)
        for other, low, high, gap in others:
            if gap <= TOUCHING and _holds(guide, low, high, most):
                bolted.append((guide.piece, other))
            elif _covered(guide, low, high) < SEAT:
                sliding.append(Sliding(guide, other, max(low, guide.low), min(high, guide.high)))
    return bolted, sliding


def _covered(guide: Guide, low: float, high: float) -> float:
    return max(0.0, min(high, guide.high) - max(low, guide.low)) / guide.length


def _holds(guide: Guide, low: float, high: float, most: float) -> bool:
    """Whether what touches a guide from low to high carries it, or is bolted to it; most : the best covered share."""
    covered = _covered(guide, low, high)
    if covered >= SEAT and covered >= 0.95 * most:
        return True
    if guide.kind == "rail":
        return False
    margin = END * guide.length
    return low < guide.low + margin or high > guide.high - margin
