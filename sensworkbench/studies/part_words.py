# SPDX-License-Identifier: LGPL-2.1-or-later
"""Who makes a feature, as it may be said: shares of a value that is smaller than its own uncertainty mean nothing."""

from __future__ import annotations

from .part import FITTED, PartResult
from .part_features import FeatureFound

LARGEST = 2.0  # share beyond which contributions nearly cancel and shares of the rest are not worth saying
NOTHING_MM = 1e-7


def unsure(result: PartResult, found: FeatureFound) -> str:
    """Code of the message why no shares are said of a feature, or "": it is smaller than its uncertainty, or its
    contributions nearly cancel."""
    if result.model != FITTED:
        return ""
    if abs(found.value) < NOTHING_MM or (found.u is not None and abs(found.value) < found.u):
        return "part-below-uncertainty"
    if len(found.shares) and abs(found.shares).max() > LARGEST:
        return "part-contributions-cancel"
    return ""
