# SPDX-License-Identifier: LGPL-2.1-or-later
"""A machine from parts, for scripts: `propose.engine` looks at them, `propose.building` makes what it found."""

from __future__ import annotations

from ..messages import Refused
from .paths import places
from .propose import building, engine
from .propose.suggestions import AxisProposal, propose_axes

__all__ = ["AxisProposal", "machine_from_parts", "propose_axes"]


def machine_from_parts(doc, objects, *, answers=None, tool_point=None, travel=None, label="Machine"):
    """Make the Machine that the objects show; returns the Machine.

    objects : its parts, or the compound that holds them, which is taken apart; empty: the whole document.  answers :
    `Question.name` -> what a person says, as in `engine.propose`.  tool_point, travel ({"X": (low, high)}, mm) replace
    what is proposed.  Refuses, with nothing made, where not all axes are found.  Opens no transaction.
    """
    found = engine.propose(doc, places(objects if isinstance(objects, (list, tuple)) else [objects]), answers)
    if not found.complete:
        open_ = [q.message for q in found.questions]
        reasons = (open_ + found.remarks) if found.axes else (found.remarks + open_)
        raise Refused("propose-incomplete", "selection", reason=reasons[0])
    return building.build(doc, found, label=label, tool_point=tool_point, travel=travel)
