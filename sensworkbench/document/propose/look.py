# SPDX-License-Identifier: LGPL-2.1-or-later
"""The look at a document: directions of the machine, what touches, what slides.  It does not depend on answers."""

from __future__ import annotations

import numpy as np

from .found import State
from .guides import grouped, touching
from .reading import SMALL, Document
from .rollers import find_wheels
from .speech import speech


def look(document: Document, title: str, watch, until: float) -> State:
    """What a document shows.  watch(done, all) : true stops.  until : by the clock, when to stop looking."""
    units = document.units
    boxes = np.array([u.box for u in units]) if units else np.zeros((1, 6))
    size = float(np.linalg.norm(boxes[:, 3:].max(0) - boxes[:, :3].min(0))) or 1.0
    find_wheels(document, size)
    minor = {n for n, u in enumerate(units) if u.hardware == "fastener" or _tiny(units, u, size)}
    axes = np.eye(3)  # the document is read in the frame of the machine
    found = touching(document, axes, minor, size, lambda n, total: watch(total + n, 2 * total), until)
    guides = grouped(found.slides, size)
    said = speech(document, title)
    return State(document, title, axes, size, minor, found, guides, said)


def _tiny(units, unit, size: float) -> bool:
    return len(units) > 8 and unit.size < SMALL * size and unit.hardware != "wheel"
