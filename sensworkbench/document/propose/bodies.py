# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which parts move together: a graph of what touches and belongs together, cut where guides say that things slide.

Belts, bellows, screws and sloppy joints bridge guides in real files; a cut of least weight between the rails of a guide
and what rides on them separates the two sides all the same.
"""

from __future__ import annotations

from collections import deque

import numpy as np

from .guides import RIDERS, Guide, Touching
from .reading import Document

SURE = 0.5  # weight of a guide that is cut


class Graph:
    """An undirected graph with weights; nodes are units and, as negative numbers, containers."""

    def __init__(self):
        self.edges: dict[int, dict[int, float]] = {}

    def add(self, a: int, b: int, weight: float) -> None:
        """Strengthen the edge between two units by `weight`."""
        if a == b or weight <= 0:
            return
        for p, q in ((a, b), (b, a)):
            row = self.edges.setdefault(p, {})
            row[q] = row.get(q, 0.0) + weight

    def remove(self, a: int, b: int) -> None:
        """Remove the edge between two units."""
        self.edges.get(a, {}).pop(b, None)
        self.edges.get(b, {}).pop(a, None)

    def reach(self, start) -> set[int]:
        """Return the units that are connected with those of `start`, these included."""
        seen, waiting = set(start), list(start)
        while waiting:
            for other in self.edges.get(waiting.pop(), ()):
                if other not in seen:
                    seen.add(other)
                    waiting.append(other)
        return seen

    def cut(self, source: set[int], sink: set[int], limit: int = 400) -> float:
        """Remove the edges of least weight that separate source from sink; returns their weight."""
        if source & sink:
            return 0.0
        flow: dict[tuple[int, int], float] = {}
        total = 0.0
        for _ in range(limit):
            path = self._path(source, sink, flow)
            if path is None:
                break
            step = min(self.edges[a][b] - flow.get((a, b), 0.0) for a, b in zip(path, path[1:]))
            for a, b in zip(path, path[1:]):
                flow[a, b] = flow.get((a, b), 0.0) + step
                flow[b, a] = flow.get((b, a), 0.0) - step
            total += step
        side = self._residual(source, flow)
        for a in list(side):
            for b in list(self.edges.get(a, ())):
                if b not in side:
                    self.remove(a, b)
        return total

    def _path(self, source, sink, flow):
        before: dict[int, int | None] = {s: None for s in source}
        waiting = deque(source)
        while waiting:
            a = waiting.popleft()
            for b, weight in self.edges.get(a, {}).items():
                if b not in before and weight - flow.get((a, b), 0.0) > 1e-9:
                    before[b] = a
                    if b in sink:
                        path = [b]
                        while before[path[-1]] is not None:
                            path.append(before[path[-1]])
                        return path[::-1]
                    waiting.append(b)
        return None

    def _residual(self, source, flow) -> set[int]:
        seen, waiting = set(source), list(source)
        while waiting:
            a = waiting.pop()
            for b, weight in self.edges.get(a, {}).items():
                if b not in seen and weight - flow.get((a, b), 0.0) > 1e-9:
                    seen.add(b)
                    waiting.append(b)
        return seen


def graph(document: Document, found: Touching, guides: list[Guide], minor: set[int], size: float) -> Graph:
    """What holds together: contacts, bonds of the document, common containers."""
    units = document.units
    sliding = {frozenset((s.rail[0], s.rider[0])) for g in guides if g.weight >= SURE for s in g.slides}
    made = Graph()
    for touch in found.contacts:
        a, b = touch.one[0], touch.other[0]
        if frozenset((a, b)) in sliding:
            continue
        kinds = {units[a].hardware, units[b].hardware}
        if kinds >= {"screw", "nut"} or ("wheel" in kinds and "extrusion" in kinds):
            continue
        if kinds & {"rail", "shaft"} and kinds & RIDERS:
            continue
        if not touch.touches:
            continue
        weight = min(3.0, 0.3 + 12 * touch.area**0.5 / size)
        if "loose" in kinds:
            weight *= 0.05
        if "screw" in kinds:
            weight *= 0.4
        made.add(a, b, weight)
    touching = {frozenset((c.one[0], c.other[0])) for c in found.contacts if c.touches}
    for bond in document.bonds:
        pair = frozenset((bond.one, bond.other))
        if bond.kind == "slider" or pair in sliding:
            continue
        if bond.kind == "placed" and pair not in touching:
            continue  # what only places a part, and does not touch it, does not hold it
        made.add(bond.one, bond.other, {"fixed": 4.0, "turning": 2.0}.get(bond.kind, bond.weight))
    for bond in document.bonds:
        if bond.kind == "placed" and not (made.edges.get(bond.one) and made.edges.get(bond.other)):
            made.add(bond.one, bond.other, 0.05 * bond.weight)
    _wheels(units, made, minor)
    _containers(units, made, minor)
    return made


def _wheels(units, made: Graph, minor: set[int]) -> None:
    """A wheel is held by the plate that its axle points at; spacers between the two are rarely drawn."""
    plates = [n for n, u in enumerate(units) if n not in minor and u.hardware in ("", "block", "support")]
    if not plates:
        return
    boxes = np.array([units[n].box for n in plates])
    for n, unit in enumerate(units):
        if unit.hardware != "wheel" or n in minor:
            continue
        box = unit.box
        size, middle = box[3:] - box[:3], (box[3:] + box[:3]) / 2
        k = int(np.argmin(size))
        rest = [i for i in range(3) if i != k]
        over = np.all((boxes[:, rest] <= middle[rest]) & (boxes[:, [i + 3 for i in rest]] >= middle[rest]), axis=1)
        gap = np.maximum(0.0, np.maximum(boxes[:, k] - box[k + 3], box[k] - boxes[:, k + 3]))
        near = np.where(over, gap, np.inf)
        if near.min() < 1.5 * size.max():
            made.add(n, plates[int(np.argmin(near))], 2.0)


def _containers(units, made: Graph, minor: set[int]) -> None:
    from . import words

    members: dict[tuple, list[int]] = {}
    labels: dict[tuple, str] = {}
    for n, unit in enumerate(units):
        for holder, label in zip(unit.holders, unit.labels):
            members.setdefault(holder, []).append(n)
            labels[holder] = label
    big = sum(1 for n in range(len(units)) if n not in minor)
    for number, (holder, numbers) in enumerate(members.items(), 1):
        inside = [n for n in numbers if n not in minor]
        if len(inside) < 2 or len(inside) > 0.7 * big:
            continue
        named = words.role(labels[holder]) or words.letter(labels[holder])
        for n in inside:
            made.add(n, -number, 0.7 if named else 0.3)


def separate(document: Document, made: Graph, guides: list[Guide]) -> list[Guide]:
    """Cut the graph at every sure guide; returns those that separate two sides."""
    used = []
    for guide in guides:
        if guide.weight >= SURE and guide.rails - guide.riders and guide.riders - guide.rails:
            made.cut(guide.rails - guide.riders, guide.riders - guide.rails)
            used.append(guide)
    _bundled(made, used)
    for guide in used:
        made.cut(guide.rails - guide.riders, guide.riders - guide.rails)
    return used


def _bundled(made: Graph, used: list[Guide]) -> None:
    """The rails of one guide are on one body, and riders side by side are one carriage, unless that joins what
    another guide separates.
    """
    home: dict[int, int] = {}
    for n in {n for g in used for n in g.rails | g.riders}:
        if n not in home:
            for m in made.reach([n]):
                home[m] = n

    def joins(a: int, b: int) -> bool:
        pair = {home[a], home[b]}
        for guide in used:
            rails = {home[n] for n in guide.rails - guide.riders} & pair
            riders = {home[n] for n in guide.riders - guide.rails} & pair
            if rails and riders and rails != riders:
                return True
        return False

    for guide in used:
        rails = sorted(guide.rails - guide.riders)
        for a, b in (*zip(rails, rails[1:]), *((rails[0], r) for r in rails[2:]), *_side_by_side(guide)):
            if home[a] == home[b] or not joins(a, b):
                made.add(a, b, 3.0)
                old, new = home[b], home[a]
                for n in home if old != new else ():
                    home[n] = new if home[n] == old else home[n]


def _side_by_side(guide: Guide):
    """Riders on different rails that cover the same piece of them: one carriage."""
    slides = guide.slides
    for i, s in enumerate(slides):
        for t in slides[:i]:
            if s.rail != t.rail and s.rider[0] != t.rider[0]:
                shared = min(s.high, t.high) - max(s.low, t.low)
                if shared > 0.5 * min(s.high - s.low, t.high - t.low):
                    yield s.rider[0], t.rider[0]


def components(made: Graph, numbers: list[int]) -> list[set[int]]:
    """Sets of units that hang together."""
    left, found = set(numbers), []
    while left:
        body = {n for n in made.reach([next(iter(left))]) if n in left}
        found.append(body)
        left -= body
    return found


def adopt(
    document: Document,
    bodies: list[set[int]],
    keep: list[bool],
    found: Touching,
    minor,
    size: float,
    bed: int | None = None,
) -> list[int]:
    """Give every part outside the kept bodies to the one that it touches most, else the nearest; returns what is far.

    bodies : changed in place.  keep : which of them are bodies of the machine.  bed : the one that stands; what
    encloses most of the machine, and touches nothing, stands too.
    """
    units = document.units
    owner = {n: b for b, body in enumerate(bodies) if keep[b] for n in body}
    pulls: dict[int, dict[int, float]] = {}
    for touch in found.contacts:
        a, b = touch.one[0], touch.other[0]
        weight = touch.area + 1.0
        if not touch.touches:  # castings that stand in one another
            weight += touch.overlap * min(units[a].size, units[b].size) ** 2 * 0.2
        pulls.setdefault(a, {})[b] = pulls.get(a, {}).get(b, 0.0) + weight
        pulls.setdefault(b, {})[a] = pulls.get(b, {}).get(a, 0.0) + weight
    for bond in document.bonds:
        if bond.kind in ("fixed", "turning"):
            for a, b in ((bond.one, bond.other), (bond.other, bond.one)):
                pulls.setdefault(a, {})[b] = pulls.get(a, {}).get(b, 0.0) + 1e5
    groups = [body for b, body in enumerate(bodies) if not keep[b]] + [{n} for n in minor]
    groups = [{n for n in g if n not in owner} for g in groups]
    waiting, far = [g for g in groups if g], []
    grown = True
    while waiting and grown:
        grown = False
        for group in list(waiting):
            votes: dict[int, float] = {}
            for n in group:
                for other, weight in pulls.get(n, {}).items():
                    if other in owner:
                        votes[owner[other]] = votes.get(owner[other], 0.0) + weight
            if votes:
                best = max(votes, key=votes.get)
                for n in group:
                    owner[n] = best
                waiting.remove(group)
                grown = True
    if waiting:
        owned = list(owner)
        boxes = np.array([units[n].box for n in owned]) if owned else np.zeros((0, 6))
        for group in waiting:
            if not len(owned):
                far += sorted(group)
                continue
            box = np.array([units[n].box for n in group])
            low, high = box[:, :3].min(0), box[:, 3:].max(0)
            gaps = np.linalg.norm(np.maximum(0, np.maximum(boxes[:, :3] - high, low - boxes[:, 3:])), axis=1)
            if bed is not None and np.linalg.norm(high - low) > 0.5 * size:
                for n in group:
                    owner[n] = bed
                continue
            near = np.flatnonzero(gaps <= gaps.min() + 1e-9)
            home = min((owned[k] for k in near), key=lambda n: units[n].size)
            if gaps.min() > 0.25 * size:
                far += sorted(group)
                continue
            for n in group:
                owner[n] = owner[home]
    for body in bodies:
        body.clear()
    for n, b in owner.items():
        bodies[b].add(n)
    return far
