# SPDX-License-Identifier: LGPL-2.1-or-later
"""X, Y and Z: as names say, else by direction; on a lathe along and across the spindle."""

from __future__ import annotations

from itertools import permutations

import numpy as np

from . import words
from .found import State
from .links import Chains, Link


def give_letters(state: State, reading: Chains, links, places, up) -> None:
    """X, Y, Z for each link: as names say, else by direction (on a lathe along and across the spindle)."""
    stated = [_stated(state, link, reading, places) for link in links]
    named = [a for a in stated if a]
    if len(set(named)) == len(named) == len(links) and not any(k.told_letter for k in links):
        for link, letter in zip(links, stated):
            link.letter = letter
        return
    cost = {}
    z = _spindle(state, places) if state.said.lathe else up
    if z is None:  # a lathe whose spindle is not seen: the carriage runs along it, the cross slide on the carriage
        z = next((k.u for k in links if any(m.inner == k.outer for m in links)), up)
    level = [a for a in state.axes if abs(a @ z) < 0.5]
    level.sort(key=lambda a: -abs(a[0]) - 0.1 * abs(a[1]))
    target = {"Z": z, "X": level[0], "Y": level[1] if len(level) > 1 else np.cross(z, level[0])}
    if state.said.lathe and len(links) == 2:
        across = next((k.u for k in links if abs(k.u @ z) < 0.5), level[0])
        target["X"], target["Y"] = across, np.cross(z, across)
    for i, link in enumerate(links):
        for letter in "XYZ":
            cost[i, letter] = abs(link.u @ target[letter]) + (
                0.8 if stated[i] == letter and named.count(letter) == 1 else 0.0
            )
    for i, link in enumerate(links):
        if link.told_letter:
            cost[i, link.told_letter] += 9.0
    best = max(permutations("XYZ", len(links)), key=lambda o: sum(cost[i, a] for i, a in enumerate(o)))
    for link, letter in zip(links, best):
        link.letter = letter


def _stated(state: State, link: Link, reading: Chains, places) -> str:
    """The letter that the joint's name, or most of the moving body's names, state."""
    if link.bond is not None and words.letter(link.bond.label):
        return words.letter(link.bond.label)
    votes: dict[str, float] = {}
    for n in reading.bodies[link.outer]:
        letter = places.get(n, ("", ""))[1]
        if letter:
            votes[letter] = votes.get(letter, 0.0) + state.document.units[n].bulk
    best = max(votes, key=votes.get, default="")
    return best if best and votes[best] > 0.7 * sum(votes.values()) else ""


def _spindle(state: State, places):
    """The direction of a lathe's spindle: that of the largest cylinders of what is called spindle, chuck or head."""
    share = np.zeros(3)
    for n, (role, _) in places.items():
        unit = state.document.units[n]
        if role == "headstock" or words.role(unit.label) in ("tool", "chuck", "headstock"):
            for solid in unit.solids[:5]:
                if len(solid.radii):
                    weight = solid.radii * np.linalg.norm(solid.round_boxes[:, 3:] - solid.round_boxes[:, :3], axis=1)
                    share += [weight[np.abs(solid.axes @ a) > 0.99].sum() for a in state.axes]
    return state.axes[int(np.argmax(share))] if share.sum() > 0 else None
