# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which body is the bed, and the links from it outwards: at most three, in at most two branches."""

from __future__ import annotations

import numpy as np

from . import words
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
        moving = sum(w for n, w in weights.items() if places[n][0] in words.MOVING or places[n][1]) / total
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
    links, again = tree(parts, edges, bed)
    reading = Chains(parts, bed, links, source, far)
    reading.bed_sure = min(0.95, 0.5 + 0.4 * (scores[bed] - scores[ranked[1]])) if len(ranked) > 1 else 0.5
    reached = {bed, *(k.outer for k in links)}
    for b in range(len(parts)):  # islands with guides of their own, and what nothing reaches, stand on the bed
        if b not in reached and parts[b]:
            reading.merged.append((b, bed))
            parts[bed] |= parts[b]
            parts[b] = set()
    _prune(state, reading, places, answers)
    return reading


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
