# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far an axis goes: limits of a joint, what its guide leaves, or the gap between stops."""

from __future__ import annotations

import numpy as np

from ...messages import Message
from .found import ASSUMED_TRAVEL, State
from .guides import shape_of
from .links import Chains, Link


def travel_of(state: State, reading: Chains, link: Link, u, on_work: bool):
    """((low, high), reference point, whether assumed, in words): as far as what slides stays on what it slides on."""
    document = state.document
    outer = reading.bodies[link.outer]
    sense = -1.0 if on_work else 1.0
    if link.bond is not None:
        limits = link.bond.limits
        direction = float(np.sign(link.bond.u @ u) or 1.0) * (1.0 if link.bond.other in outer else -1.0) * sense
        stands = link.bond.stands * direction
        if limits is not None:
            low, high = sorted(direction * v for v in limits)
            return (low, high), None, False, Message("propose-travel-joint", part=link.bond.label)
        return (stands - ASSUMED_TRAVEL, stands + ASSUMED_TRAVEL), None, True, Message("propose-travel-assumed")
    slides = [s for g in link.guides for s in g.slides if g.weight >= 0.5] or [
        s for s in link.slides if abs(s.u @ u) > 0.99 and s.weight > 0.2]  # fmt: skip
    rails: dict[tuple, list] = {}
    for s in slides:
        if s.rail[0] in outer or s.rider[0] in outer:
            rails.setdefault(s.rail, []).append(s)
    before, after, boxes = [], [], []
    for rail, group in rails.items():
        down = min(s.low for s in group) - group[0].start
        ahead = group[0].end - max(s.high for s in group)
        if rail[0] in outer:  # the rail is what moves
            down, ahead = ahead, down
        if group[0].u @ u < 0:
            down, ahead = ahead, down
        before.append(down)
        after.append(ahead)
        boxes += [document.units[s.rider[0]].solids[s.rider[1]].box for s in group]
    point = None
    if boxes:
        boxes = np.array(boxes)
        point = (boxes[:, :3].min(0) + boxes[:, 3:].max(0)) / 2
    k = document.frame.scale
    if before and min(before) + min(after) > 1.0:
        low, high = -min(before) / k, min(after) / k
        ends = (low, high) if not on_work else (-high, -low)
        return (ends[0] + 0.0, ends[1] + 0.0), point, False, Message("propose-travel-guide", length=ends[1] - ends[0])
    inner = reading.bodies[link.inner]
    part = _by_part(document, inner, outer, u)
    if part is not None:
        unit, (down, ahead) = part
        ends = (-down / k, ahead / k) if not on_work else (-ahead / k, down / k)
        why = Message("propose-travel-part", part=unit.label, length=ends[1] - ends[0])
        return (ends[0] + 0.0, ends[1] + 0.0), point, True, why
    lows = [min(document.units[n].extent(u)[0] for n in b) for b in (inner, outer)]
    highs = [max(document.units[n].extent(u)[1] for n in b) for b in (inner, outer)]
    down, ahead = lows[1] - lows[0], highs[0] - highs[1]
    if down >= 0 and ahead >= 0 and down + ahead > 5:
        ends = (-down / k, ahead / k) if not on_work else (-ahead / k, down / k)
        return (ends[0] + 0.0, ends[1] + 0.0), point, True, Message("propose-travel-gap", length=ends[1] - ends[0])
    return (-ASSUMED_TRAVEL, ASSUMED_TRAVEL), point, True, Message("propose-travel-assumed")


def _by_part(document, inner, outer, u):
    """(rail, shaft or screw, (room below, room above)) of the one that one body has along u, whose blocks or nuts the
    other has, and that leaves least; None where there is none.

    A length that the part number states replaces the drawn one.
    """
    best = None
    for own, other, moves in ((inner, outer, False), (outer, inner, True)):
        riders = [n for n in other if document.units[n].hardware in ("block", "nut")]
        if not riders:
            continue
        low = min(document.units[n].extent(u)[0] for n in riders)
        high = max(document.units[n].extent(u)[1] for n in riders)
        for n in own:
            unit = document.units[n]
            if unit.hardware not in ("rail", "shaft", "screw"):
                continue
            start, end = unit.extent(u)
            drawn = end - start
            if not any(shape_of(s, 0.0)[0] and float(s.size @ np.abs(u)) > 0.9 * drawn for s in unit.solids):
                continue
            stated = (unit.stated_length or 0.0) * document.frame.scale
            spare = (stated - drawn) / 2 if 0.5 * drawn < stated < 2 * drawn else 0.0
            room = (low - start + spare, end - high + spare)
            if min(room) >= 0 and sum(room) > 5 and (best is None or sum(room) < sum(best[1])):
                best = unit, (room[::-1] if moves else room)
    return best
