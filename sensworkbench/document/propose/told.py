# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a person has said of parts: pins, bodies that were given, and how those carry each other."""

from __future__ import annotations

from .found import State
from .links import Chains, Evidence, Link, most_common
from .pinned import pins


def as_told(state: State, reading: Chains | None, answers) -> Chains | None:
    """The reading with the bodies that a person has given: `body:X` -> parts that move as axis X."""
    document = state.document
    told = [(name[5:], pins(document, answers, name)) for name in answers if name.startswith("body:")]
    told = [(letter, units) for letter, units in told if letter in "XYZ" and units]
    if not told:
        return reading
    if reading is None:
        reading = Chains([set(range(len(document.units)))], 0, [], "person")
    new = []
    for letter, units in told:
        home = most_common(
            [reading.body_of(n) for n in sorted(units) if reading.body_of(n) is not None] or [reading.bed]
        )
        link = next((k for k in reading.links if k.outer == home), None)
        bulk = sum(document.units[n].bulk for n in units & reading.bodies[home])
        whole = sum(document.units[n].bulk for n in reading.bodies[home])
        if link is None or link.told_letter or (len(reading.links) < 3 and bulk < 0.5 * whole):
            link = Link(home, len(reading.bodies))  # a body of its own, carried by what it was taken for
            reading.bodies.append(set())
            reading.links.append(link)
            new.append(link)
        for body in reading.bodies:
            body -= units
        reading.bodies[link.outer] |= units
        link.told_letter = letter
        link.evidence.append(Evidence("propose-evidence-person", 0.9))
    reading.links = [k for k in reading.links if reading.bodies[k.outer]]
    _nest(state, reading, [k for k in new if k in reading.links])
    return reading


def _nest(state: State, reading: Chains, new: list[Link]) -> None:
    """Bodies that a person took out of one body carry each other where they touch, from that body outwards."""
    owner = {n: b for b, body in enumerate(reading.bodies) for n in body}
    areas: dict[tuple[int, int], float] = {}
    for touch in state.found.contacts:
        pair = owner.get(touch.one[0]), owner.get(touch.other[0])
        if None not in pair:
            for a, b in (pair, pair[::-1]):
                areas[a, b] = areas.get((a, b), 0.0) + touch.area + 1.0
    waiting = list(new)
    while waiting:
        outside = {k.outer for k in waiting}
        ready = [k.inner for k in waiting if k.inner not in outside]
        reached = {*ready, *(k.outer for k in new if k not in waiting)} or {reading.bed}
        link, inner = max(
            ((k, b) for k in waiting for b in reached), key=lambda kb: areas.get((kb[0].outer, kb[1]), 0.0)
        )
        if areas.get((link.outer, inner)):
            link.inner = inner
        waiting.remove(link)
