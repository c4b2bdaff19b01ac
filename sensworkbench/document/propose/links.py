# SPDX-License-Identifier: LGPL-2.1-or-later
"""A reading of a document: bodies, the links between them, and what speaks for each link."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from .guides import Guide, Slide
from .reading import Bond, Document

EVIDENCE_CAP = 0.97


@dataclass
class Evidence:
    """Something that speaks for a direction u of a joint.  code, fields : of the message that says it."""

    code: str
    weight: float
    u: np.ndarray | None = None
    fields: dict = field(default_factory=dict)


@dataclass
class Link:
    """Body `outer` moves on body `inner`."""

    inner: int
    outer: int
    evidence: list[Evidence] = field(default_factory=list)
    guides: list[Guide] = field(default_factory=list)
    slides: list[Slide] = field(default_factory=list)
    bond: Bond | None = None
    u: np.ndarray | None = None
    letter: str = ""
    confidence: float = 0.0
    margin: float = 1.0
    told: np.ndarray | None = None  # direction that a person has given
    told_letter: str = ""


@dataclass
class Chains:
    """Bodies (sets of unit numbers), the first of them the bed, and the links between them from the bed outwards."""

    bodies: list[set[int]]
    bed: int
    links: list[Link]
    source: str  # "joints", "guides" or "names"
    far: list[int] = field(default_factory=list)
    merged: list[tuple[int, int]] = field(default_factory=list)  # (outer, inner) of slides that are no machine axis
    bed_sure: float = 0.5

    def body_of(self, unit: int) -> int | None:
        """Return the number of the body that a unit belongs to, or None."""
        return next((b for b, body in enumerate(self.bodies) if unit in body), None)


def label_of(document: Document, body) -> str:
    """Return the label of the bulkiest unit of a body, "" where it has none."""
    if not body:
        return ""
    return document.units[max(body, key=lambda n: document.units[n].bulk)].label


def most_common(values):
    """Return the value that occurs most often."""
    return max(set(values), key=values.count)
