# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the names of a document say: the kind of machine as a whole, and the place of each part."""

from __future__ import annotations

from dataclasses import dataclass

from . import words
from .reading import Document


@dataclass(frozen=True)
class Words:
    """What the names of a document say as a whole."""

    lathe: bool
    printer: bool
    delta: bool
    robot: bool
    rotary: tuple[str, ...]


def speech(document: Document, title: str = "") -> Words:
    """Return what the names in a document say together, such as whether they are those of a lathe."""
    labels = {*document.names, *(t for u in document.units for t in (*u.labels, u.source)), title}
    texts = {label: words.plain(label) for label in labels if label}
    said = " | ".join(texts.values())
    lathe = len({m.group(0) for m in words.LATHE.finditer(said)}) >= 2 or bool(
        words._words("lathe|drehbank|drehmaschine|modulathe").search(said))  # fmt: skip
    lathe = lathe or bool(words.CROSS_SLIDE.search(said)) and not words.MILL.search(said)
    mill = sum(words.role(label) in ("gantry", "table") for label in labels)
    rotary = tuple(sorted(label for label, text in texts.items() if words.ROTARY.search(text)))[:6]
    return Words(
        lathe and not (mill > 2 and "lathe" not in said), bool(words.PRINTER.search(said)),
        bool(words.DELTA.search(said)), len({m.group(0) for m in words.ROBOT.finditer(said)}) >= 2, rotary,
    )  # fmt: skip


def place_of(document: Document, n: int, said: Words, common: set) -> tuple[str, str]:
    """(role, letter) of a unit: of the innermost container that states one, else its own.

    common : holders that hold nearly everything, whose names are the machine's.
    """
    unit = document.units[n]
    for holder, label in reversed(list(zip(unit.holders, unit.labels))):
        if holder in common or words.hardware(label):
            continue
        role, letter = words.role(label), words.letter(label)
        if role or letter:
            return _fitting(role, said), letter
    return _fitting(unit.own_role, said), unit.own_letter


def _fitting(role: str, said: Words) -> str:
    if said.printer and role == "bed":
        return "table"
    if role == "headstock":
        return "headstock" if said.lathe else "quill"
    if role == "chuck":
        return "headstock" if said.lathe else "work"
    if said.lathe and role in ("quill", "tool"):
        return "headstock" if role == "quill" else ""
    return role


def common_holders(document: Document, minor: set[int]) -> set:
    """Return the containers that hold most of the units, and therefore distinguish none."""
    counts: dict[tuple, int] = {}
    units = [u for n, u in enumerate(document.units) if n not in minor]
    for unit in units:
        for holder in unit.holders:
            counts[holder] = counts.get(holder, 0) + 1
    return {holder for holder, count in counts.items() if count > 0.7 * len(units)}


def places_all(document, places):
    """Return a place for every unit: that given, or ("", "")."""
    return {n: places.get(n, ("", "")) for n in range(len(document.units))}


def roles_of(places, units, body) -> set[str]:
    """Return the roles that the names of a body state, small parts without weight."""
    total = sum(units[n].bulk for n in body) or 1.0
    share: dict[str, float] = {}
    for n in body:
        role = places.get(n, ("", ""))[0]
        if role:
            share[role] = share.get(role, 0.0) + units[n].bulk / total
    return {
        role
        for role, s in share.items()
        if s > 0.1 or role in ("quill", "gantry", "saddle", "knee", "table", "tool", "toolpost")
    }
