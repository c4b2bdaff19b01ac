# SPDX-License-Identifier: LGPL-2.1-or-later
"""Directions in which something may move, for a person to choose from where too few axes were found.

They come from what the proposal has read anyway: long thin solids are rails or screws; where those show fewer than
three directions, the longest sides of the other solids are taken.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import permutations

import FreeCAD as App
import numpy as np

from ...core.errors import AXES
from ...messages import Message, Refused
from ..paths import PartPath, place
from .building import along
from .guides import is_round_bar, shape_of
from .reading import Document, read_parts

PARALLEL = 0.9998  # cosine of about one degree
LONG = 0.15  # a guide is at least this long, measured by the whole


@dataclass
class AxisProposal:
    """A direction in which something may move.  source : (object, path with element) for `make_axis(direction=...)`.

    direction : unit vector, document coordinates.  axis : the letter that fits best, "" for all but three.
    length : of its guide, mm.  score : the lengths of all guides in this direction, mm.  why : a message.
    """

    axis: str
    direction: App.Vector
    source: tuple
    reverse: bool
    length: float
    score: float
    why: Message


@dataclass
class _Way:
    """What shows one direction: u in the frame of the machine, the longest of its guides, the sum of all."""

    u: np.ndarray
    where: PartPath
    label: str
    kind: str
    length: float
    score: float


def propose_axes(objects) -> list[AxisProposal]:
    """Directions of motion that the shapes of the objects suggest, best first; changes nothing.

    From rails and screws; where there are fewer than three directions, from the longest sides.  At most one proposal
    per direction; X, Y and Z are given to the three best that are not parallel.  Refuses objects without solids.
    """
    chosen = [w for o in (objects if isinstance(objects, (list, tuple)) else [objects]) if (w := place(o)) is not None]
    document = read_parts(chosen)
    if not document.units:
        raise Refused("proposal-no-solids", "selection")
    return suggested(document)


def suggested(document: Document) -> list[AxisProposal]:
    """The directions that a document suggests, of which the shapes were looked at already."""
    boxes = np.array([u.box for u in document.units])
    size = float(np.linalg.norm(boxes[:, 3:].max(0) - boxes[:, :3].min(0)))
    ways: list[_Way] = []
    for unit in document.units:
        for solid in unit.solids:
            kind, u = shape_of(solid, size)
            length = float(solid.size @ np.abs(u)) if kind else 0.0
            if length >= LONG * size / 3**0.5:
                is_round = is_round_bar(solid, u) and unit.hardware != "rail"
                _count(ways, _Way(u, unit.where, unit.label, "screw" if is_round else "rail", length, length))
    if len(ways) < 3:
        for unit in document.units:
            for solid in unit.solids:
                k = int(np.argmax(solid.size))
                length = float(solid.size[k])
                _count(ways, _Way(np.eye(3)[k], unit.where, unit.label, "side", length, 1e-3 * length))
    frame, made = document.frame, []
    for way in sorted(ways, key=lambda w: -w.score):
        u = App.Vector(*frame.outward(way.u))
        u = u if max(u, key=abs) > 0 else u * -1.0
        source = along(way.where, u, None)
        if source is not None:
            why = Message("propose-suggested-" + way.kind, part=way.label, length=way.length / frame.scale)
            made.append(AxisProposal("", u, *source, way.length / frame.scale, way.score / frame.scale, why))
    for proposal, letter in zip(made, _letters([p.direction for p in made[:3]])):
        proposal.axis = letter
    return made


def _count(ways: list[_Way], new: _Way) -> None:
    for way in ways:
        if abs(way.u @ new.u) > PARALLEL:
            way.score += new.score
            if new.length > way.length and new.kind == way.kind:
                way.where, way.label, way.length = new.where, new.label, new.length
            return
    ways.append(new)


def _letters(directions) -> list[str]:
    """X, Y, Z for up to three directions, each as near to its document axis as can be."""
    best = max(
        permutations(range(3), len(directions)),
        key=lambda order: sum(abs(u[k]) for u, k in zip(directions, order)),
    )
    return [AXES[k] for k in best]
