# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parameter names of ISG and Etalon files: ISO 230-1 component errors, position errors, and what a 3-axis machine
has no use for.

Position errors are stated redundantly: every axis may have three angles and three offsets.  Only angles between axes
matter; a rotation of all of them together is the set-up's alignment.
"""

from __future__ import annotations

import re

from sensworkbench.closedloop.readings import Remark
from sensworkbench.core.errors import FUNCTION_SYMBOLS
from sensworkbench.studies.error_tables import remark

FUNCTION = re.compile(r"E[XYZABC][XYZABC]$")
POSITION_ERROR = re.compile(r"[XYZABC]0[XYZABC]$")
KINEMATIC = re.compile(r"(?:P0|N0|ID|LN|P[XYZ]|V[XYZ])[XYZABC]$")


def kind(name: str) -> str:
    """ "function", "constant", "rotary" (an axis that is not here), "kinematic" or "unknown"."""
    if name in FUNCTION_SYMBOLS:
        return "function"
    if FUNCTION.match(name):
        return "rotary"
    if POSITION_ERROR.match(name):
        return "constant" if name[2] in "XYZ" else "rotary"
    return "kinematic" if KINEMATIC.match(name) else "unknown"


def squareness_of(position_errors: dict[str, tuple[float, int]]) -> tuple[dict[str, float], list[Remark]]:
    """C0Y, A0Z, B0Z (rad) of redundant position errors name -> (value, line); X primary, Y secondary.

    The common rotation (A0Y, B0X, C0X) is taken out; a rotation about the axis's own direction tilts nothing.
    """
    remarks = []
    value = {k: v for k, (v, _) in position_errors.items()}
    for name, (v, line) in position_errors.items():
        if v and name[0] in "XYZ":
            remarks.append(remark("offset-ignored", line, name=name))
        if v and name in ("A0X", "B0Y", "C0Z"):
            remarks.append(remark("rotation-ignored", line, name=name, axis=name[2]))
    common = {"C0Y": "C0X", "B0Z": "B0X", "A0Z": "A0Y"}
    if any(value.get(k) for k in common.values()):
        lines = [position_errors[k][1] for k in common.values() if value.get(k)]
        remarks.append(remark("alignment-removed", min(lines)))
    angles = {s: value.get(s, 0.0) - value.get(r, 0.0) for s, r in common.items() if s in value or value.get(r)}
    return angles, remarks
