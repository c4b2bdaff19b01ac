# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies by a cut at the guides: what holds together on both sides of what slides."""

from __future__ import annotations

from . import bodies as grouping
from .directing import guide_evidence
from .found import State
from .links import Chains, Link, most_common
from .pinned import forced, pins
from .reading import Document
from .rooting import bed_scores, rooted
from .speech import places_all

STANDS_IN = 0.01  # share of the smaller box in the larger one, from which two castings stand in one another


def by_guides(state: State, places, up, answers) -> Chains | None:
    """Return the reading that follows from a cut at every sure guide, or None where there is none."""
    document = state.document
    used_graph = grouping.graph(document, state.found, state.guides, state.minor, state.size)
    for units, _ in forced(state, answers):
        numbers = sorted(units)
        for a, b in zip(numbers, numbers[1:]):
            used_graph.add(a, b, 50.0)
    used = grouping.separate(document, used_graph, state.guides)
    numbers = [n for n in range(len(document.units)) if n not in state.minor]
    parts = grouping.components(used_graph, numbers)
    _gather(parts, used)
    used = _driven(parts, used)
    _join_islands(document, parts, used, state.found)
    owner = {n: b for b, body in enumerate(parts) for n in body}
    edges: dict[tuple[int, int], Link] = {}
    for guide in used:
        rails: dict[int, list[int]] = {}
        for s in guide.slides:
            if s.rail[0] in owner and s.rider[0] in owner:
                rails.setdefault(owner[s.rider[0]], []).append(owner[s.rail[0]])
        for rider, homes in rails.items():
            rail = most_common(homes)
            if rider == rail:
                continue
            pair = (min(rail, rider), max(rail, rider))
            link = edges.setdefault(pair, Link(*pair))
            if not link.guides or abs(link.guides[0].u @ guide.u) > 0.99:
                link.guides.append(guide)
                link.evidence.append(guide_evidence(document, guide))
    if not edges:
        return None
    keep = [any(b in pair for pair in edges) for b in range(len(parts))]
    told = pins(document, answers, "bed") | pins(document, answers, "body:F")
    scores = bed_scores(document, parts, places_all(document, places), up, state.said, told)
    bed = max((b for b in range(len(parts)) if keep[b]), key=lambda b: scores[b])
    far = grouping.adopt(document, parts, keep, state.found, state.minor, state.size, bed)
    return rooted(state, parts, edges, places, up, answers, "guides", far)


def _gather(parts: list[set[int]], used) -> None:
    """A block or nut that nothing else touches goes with what runs next to it on the same guide."""
    busy: dict[int, int] = {}
    for guide in used:
        for n in guide.rails | guide.riders:
            busy[n] = busy.get(n, 0) + 1
    for guide in used:
        riders = [b for b, body in enumerate(parts) if body & guide.riders]
        lone = [b for b in riders if parts[b] <= guide.riders and all(busy[n] == 1 for n in parts[b])]
        if len(riders) < 2 or not lone:
            continue
        homes = [b for b in riders if b not in lone] or lone[:1]
        for b in lone:
            if b in homes:
                continue
            low, high = _span(guide, parts[b])

            def away(home, low=low, high=high, guide=guide):
                start, end = _span(guide, parts[home])
                return max(start - high, low - end, 0.0)

            home = min(homes, key=away)
            parts[home] |= parts[b]
            parts[b] = set()
    parts[:] = [body for body in parts if body]


def _driven(parts: list[set[int]], used) -> list:
    """The guides without those of one rod beside a better guide of its direction, on which nothing stands but a nut.

    The rod goes with the rails of that guide, and the nut with what runs on them.
    """
    kept = [g for g in used if not _held_by_riders(parts, g)]
    for guide in kept[:]:
        if len(guide.rails) > 1 or guide.kind not in ("rail-shape", "rail-named", "bore"):
            continue
        owner = {n: b for b, body in enumerate(parts) for n in body}
        nuts = {owner[n] for n in guide.riders if n in owner}
        if not nuts or not all(parts[b] <= guide.riders for b in nuts):
            continue
        low, high = min(s.low for s in guide.slides), max(s.high for s in guide.slides)
        others = [g for g in kept if g is not guide and abs(g.u @ guide.u) > 0.99 and not g.riders & guide.riders
                  and (len(g.rails) > 1 or g.weight > guide.weight)]  # fmt: skip
        near = [g for g in others if min(s.low for s in g.slides) < high and max(s.high for s in g.slides) > low]
        if not near:
            continue
        best = max(near, key=lambda g: g.weight)
        ride, stand = (most_common([owner[n] for n in side if n in owner]) for side in (best.riders, best.rails))
        rod = owner.get(next(iter(guide.rails)))
        moves = [(b, ride) for b in nuts] + ([(rod, stand)] if rod is not None and len(parts[rod]) < 4 else [])
        for b, home in moves:
            if b not in (ride, stand):
                parts[home] |= parts[b]
                parts[b] = set()
        kept.remove(guide)
    parts[:] = [body for body in parts if body]
    return kept


def _held_by_riders(parts: list[set[int]], guide) -> bool:
    """Whether rods that nothing else holds stand in blocks near both of their ends: ties of a frame, and no guide.

    Rods and blocks are one body then.
    """
    if guide.kind not in ("rail-shape", "bore"):
        return False
    owner = {n: b for b, body in enumerate(parts) for n in body}
    rods, blocks = ({owner[n] for n in side if n in owner} for side in (guide.rails, guide.riders))
    if any(not parts[b] <= guide.rails for b in rods):
        return False
    for rail in {s.rail for s in guide.slides}:
        slides = [s for s in guide.slides if s.rail == rail]
        if len(slides) < 2 or max(s.high for s in slides) - min(s.low for s in slides) < 0.45 * slides[0].length:
            return False
    first, *rest = sorted(rods | blocks)
    for b in rest:
        parts[first] |= parts[b]
        parts[b] = set()
    return True


def _join_islands(document: Document, parts: list[set[int]], used, found) -> None:
    """Castings that stand in one another without a common face: the bodies that overlap most are one."""
    for _ in range(12):
        owner = {n: b for b, body in enumerate(parts) for n in body}
        links = grouping.Graph()
        for guide in used:
            rail = most_common([owner[n] for n in guide.rails if n in owner])
            for rider in {owner[n] for n in guide.riders if n in owner}:
                links.add(rail, rider, 1.0)
        island = {}
        for b in list(links.edges):
            if b not in island:
                for c in links.reach([b]):
                    island[c] = b
        best = None
        for touch in found.contacts:
            a, b = owner.get(touch.one[0]), owner.get(touch.other[0])
            if a is None or b is None or island.get(a) == island.get(b) or a not in island or b not in island:
                continue
            one, other = document.units[touch.one[0]], document.units[touch.other[0]]
            if {one.hardware, other.hardware} & {"loose", "fastener", "screw"}:
                continue
            if touch.overlap < STANDS_IN and not touch.touches:
                continue
            score = touch.overlap * min(one.size, other.size) + touch.area**0.5
            if best is None or score > best[0]:
                best = (score, a, b)
        if best is None:
            return
        _, a, b = best
        parts[a] |= parts[b]
        parts[b] = set()
    parts[:] = [body for body in parts if body]


def _span(guide, body) -> tuple[float, float]:
    slides = [s for s in guide.slides if s.rider[0] in body]
    return min(s.low for s in slides), max(s.high for s in slides)
