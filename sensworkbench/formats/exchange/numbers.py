# SPDX-License-Identifier: LGPL-2.1-or-later
"""A number in a table of another system, as a person would read it."""

from __future__ import annotations

import math

from sensworkbench.messages import Refused

from ..json_text import short

LARGEST = 1e7  # mm or rad: ten kilometres


def finite(text: str, where: str) -> float:
    """The number that a cell holds; refuses words, 1_000, what is not finite, and what no machine has."""
    try:
        if "_" in text:  # Python alone would take it
            raise ValueError
        value = float(text)
    except ValueError:
        raise Refused("cell-not-a-number", where, cell=short(text)) from None
    if not math.isfinite(value):
        raise Refused("cell-not-finite", where, cell=short(text))
    if abs(value) > LARGEST:
        raise Refused("number-too-large", where, value=short(text), column="mm, rad", limit=LARGEST, unit="mm")
    return value
