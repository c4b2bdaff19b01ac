# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which parts the answers of a person name."""

from __future__ import annotations

from .found import State
from .reading import Document, Unit


def pins(document: Document, answers, name: str) -> set[int]:
    """Numbers of the units that an answer names: units, keys, labels or links."""
    value = answers.get(name)
    if value is None:
        return set()
    from ..paths import place

    found: set[int] = set()
    items = [value] if isinstance(value, str) or not isinstance(value, (list, set)) else value
    for item in items:
        if isinstance(item, Unit):
            found |= {n for n, u in enumerate(document.units) if u.key == item.key}
        elif isinstance(item, str):
            found |= {n for n, u in enumerate(document.units) if u.label == item}
        else:
            where = place(item)
            key = where.key if where is not None else ()
            for n, unit in enumerate(document.units):
                own = document.apart[unit.key].key if unit.key in document.apart else unit.where.key
                if key and (own[: len(key)] == key or key[: len(own)] == own):
                    found.add(n)
    return found


def forced(state: State, answers) -> list[tuple[set[int], str]]:
    """(units, body) that a person has given: "body:X" -> parts."""
    return [(pins(state.document, answers, k), k[5:]) for k in answers if k.startswith("body:")]
