# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which body is the bed, and the links from it outwards: at most three, in at most two branches."""

from __future__ import annotations

import numpy as np

from . import words
from .bodies import Graph
from .found import State
from .links import Chains, Link
from .pinned import pins
from .reading import Document
from .speech import Words, places_all, roles_of


def tree(bodies, edges: dict[tuple[int, int], Link], bed: int) -> tuple[list[Link], list[tuple[int, int]]]:
    """Links from the bed outwards, the surest first; and what is reached a second time."""
    reached, made, again = {bed}, [], []
    waiting = dict(edges)
    while True:
        open_ = [pair for pair in waiting if (pair[0] in reached) != (pair[1] in reached)]
        if not open_:
            break
        pair = max(open_, key=lambda p: max((e.weight for e in waiting[p].evidence), default=0.0))
        link = waiting.pop(pair)
        inner, outer = pair if pair[0] in reached else pair[::-1]
        link.inner, link.outer = inner, outer
        reached.add(outer)
        made.append(link)
    for pair in waiting:
        if pair[0] in reached and pair[1] in reached:
            again.append(pair)
    return made, again


def bed_scores(document: Document, bodies, places, up, said: Words, pinned: set[int]) -> list[float]:
    """How much speaks for each body to be the bed."""
    units = document.units
    lows = [min((units[n].extent(up)[0] for n in body), default=1e9) for body in bodies]
    highs = [max((units[n].extent(up)[1] for n in body), default=-1e9) for body in bodies]
    bulk = [sum(units[n].bulk for n in body) for body in bodies]
    spread = [_footprint(units, body, up) for body in bodies]
    floor, height = min(lows), max(1e-6, max(highs) - min(lows))
    scores = []
    for b, body in enumerate(bodies):
        score = 1.0 * bulk[b] / max(1e-9, sum(bulk)) + 0.5 * (1 - (lows[b] - floor) / height)
        score += 0.3 * spread[b] / max(1e-9, max(spread))
        weights = {n: units[n].bulk for n in body}
        total = sum(weights.values()) or 1.0
        fixed = sum(w for n, w in weights.items() if places[n][0] in words.FIXED) / total
        carries = {"table"} if lows[b] - floor < 0.02 * height and spread[b] > 0.9 * max(spread) else set()
        moving = sum(w for n, w in weights.items() if places[n][0] in words.MOVING - carries or places[n][1]) / total
        score += 1.2 * fixed - 0.8 * moving
        score += 0.5 * any(places[n][0] in ("bed", "base") for n in body)
        if document.grounded & body:
            score += 3.0
        if pinned & body:
            score += 100.0
        scores.append(score)
    return scores


def rooted(state, parts, edges, places, up, answers, source, far) -> Chains | None:
    """Return the reading in which the most likely body is the bed, at most three links outwards from it."""
    document = state.document
    inside = sorted({b for pair in edges for b in pair})
    scores = bed_scores(document, parts, places_all(document, places), up, state.said,
                              pins(document, answers, "bed") | pins(document, answers, "body:F"))  # fmt: skip
    degree = {b: sum(b in pair for pair in edges) for b in inside}
    ranked = sorted(inside, key=lambda b: -(scores[b] + 0.15 * min(2, degree[b])))
    bed = ranked[0]
    while (island := _island(edges, bed)) and source != "names":
        root = max(island, key=lambda b: scores[b] + _holds(state, parts[b], edges, b))
        edges = _joined(edges, root, bed)
        parts[bed] |= parts[root]
        parts[root] = set()
    links, again = tree(parts, edges, bed)
    for pair in again:
        _crossing(parts, links, pair, edges[pair])
    reading = Chains(parts, bed, links, source, far)
    reading.bed_sure = min(0.95, 0.5 + 0.4 * (scores[bed] - scores[ranked[1]])) if len(ranked) > 1 else 0.5
    reached = {bed, *(k.outer for k in links)}
    for b in range(len(parts)):  # what nothing reaches stands on the bed
        if b not in reached and parts[b]:
            reading.merged.append((b, bed))
            parts[bed] |= parts[b]
            parts[b] = set()
    _prune(state, reading, places, answers)
    return reading


def _crossing(parts, links: list[Link], pair, closing: Link) -> None:
    """Two beams that cross, and a core on both: the second beam moves with the core, as one body with it.

    Its guides close a loop in which every two opposite links are parallel.  Where the second beam and the core are one
    body already, it stands on the first beam.
    """
    for core, beam in (pair, pair[::-1]):
        one, other = (next((k for k in links if k.outer == b), None) for b in (core, beam))
        if one is None or other is None or one.inner != other.inner:
            continue
        if not (one.guides and other.guides and closing.guides):
            continue
        if abs(closing.guides[0].u @ one.guides[0].u) > 0.99 and abs(closing.guides[0].u @ other.guides[0].u) < 0.1:
            one.inner = beam
            return
    for core, beam in (pair, pair[::-1]):
        second = next((k for k in links if k.outer == core), None)
        first = next((k for k in links if second is not None and k.outer == second.inner), None)
        other = next((k for k in links if k.outer == beam), None)
        if first is None or other is None or other.inner != first.inner or other is first:
            continue
        if any(k.inner == beam for k in links) or not all(k.guides for k in (first, second, other, closing)):
            continue
        u, v, w, z = (k.guides[0].u for k in (first, second, other, closing))
        if abs(u @ z) > 0.99 and abs(v @ w) > 0.99 and abs(u @ v) < 0.1:
            parts[core] |= parts[beam]
            parts[beam] = set()
            links.remove(other)
            return


def _holds(state, body, edges, b: int) -> float:
    """How much of an island of guides looks like what stands on the bed: it is large, and holds rails."""
    units, guides = state.document.units, [g for pair, k in edges.items() if b in pair for g in k.guides]
    boxes = np.array([units[n].box for n in body])
    reach = float(np.linalg.norm(boxes[:, 3:].max(0) - boxes[:, :3].min(0))) / state.size if len(boxes) else 0.0
    rails = [bool(g.rails & body) and not g.riders & body for g in guides]
    return 0.5 * reach + 0.5 * (sum(rails) / len(rails) if rails else 0.0)


def _island(edges, bed: int) -> set[int]:
    """Some bodies that hang together by guides, but not with the bed; the largest such set."""
    made = Graph()
    for a, b in edges:
        made.add(a, b, 1.0)
    left = {b for pair in edges for b in pair} - made.reach([bed])
    islands = []
    while left:
        islands.append(made.reach([next(iter(left))]))
        left -= islands[-1]
    return max(islands, key=len, default=set())


def _joined(edges: dict[tuple[int, int], Link], one: int, other: int) -> dict[tuple[int, int], Link]:
    """The edges with body `one` as a piece of body `other`."""
    made: dict[tuple[int, int], Link] = {}
    for pair, link in edges.items():
        a, b = (other if n == one else n for n in pair)
        if a == b:
            continue
        new = (min(a, b), max(a, b))
        link.inner, link.outer = new
        made.setdefault(new, link)
    return made


def _prune(state: State, reading: Chains, places, answers) -> None:
    """At most three links in at most two branches: what else slides (a tailstock, a door) goes to what carries it."""
    tools = {n for n, (role, _) in places.items() if role in ("tool", "toolpost", "quill")} | pins(
        state.document, answers, "tool")  # fmt: skip

    def depth(link):
        below = [k for k in reading.links if k.inner == link.outer]
        return 1 + max((depth(k) for k in below), default=0)

    def worth(link):
        body, below = set(reading.bodies[link.outer]), [link]
        for k in below:
            body |= reading.bodies[k.outer]
            below += [n for n in reading.links if n.inner == k.outer]
        roles = roles_of(places, state.document.units, body)
        value = depth(link) + 0.8 * bool(body & tools) + 0.3 * bool(roles & words.MOVING)
        value += 0.4 * bool({places.get(n, ("", ""))[1] for n in body} - {""})
        value -= 2.0 * bool(roles & {"tailstock"}) * (not body & tools)
        return value + 0.3 * max((e.weight for e in link.evidence), default=0)

    for _ in range(30):
        outer = {}
        for link in reading.links:
            outer.setdefault(link.inner, []).append(link)
        crowded = [(b, ks) for b, ks in outer.items() if len(ks) > (2 if b == reading.bed else 1)]
        tails = [
            k
            for k in reading.links
            if "tailstock" in roles_of(places, state.document.units, reading.bodies[k.outer])
            and not reading.bodies[k.outer] & tools
        ]
        over = [k for k in reading.links if depth(k) == 1] if len(reading.links) > 3 else []
        if tails:
            drop = tails[0]
        elif crowded:
            drop = min(crowded[0][1], key=worth)
        elif over:
            drop = min(over, key=worth)
        else:
            return
        swallow(reading, drop)


def contract(reading: Chains, link: Link) -> None:
    """What moves along a link belongs to what carries it, and carries on what it carried."""
    for below in reading.links:
        if below.inner == link.outer:
            below.inner = link.inner
    reading.bodies[link.inner] |= reading.bodies[link.outer]
    reading.bodies[link.outer] = set()
    reading.links.remove(link)
    reading.merged.append((link.outer, link.inner))


def swallow(reading: Chains, link: Link) -> None:
    """What moves along a link belongs to what carries it."""
    for below in [k for k in reading.links if k.inner == link.outer]:
        swallow(reading, below)
    reading.bodies[link.inner] |= reading.bodies[link.outer]
    reading.bodies[link.outer] = set()
    reading.links.remove(link)
    reading.merged.append((link.outer, link.inner))


def _footprint(units, body, up) -> float:
    """Area of the box around a body, seen from above, mm²."""
    boxes = np.array([units[n].box for n in body])
    if not len(boxes):
        return 0.0
    size = boxes[:, 3:].max(0) - boxes[:, :3].min(0)
    across = size[np.abs(up) < 0.5]
    return float(np.prod(across)) if len(across) else 0.0
