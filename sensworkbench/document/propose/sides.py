# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which links carry the workpiece, and which the tool."""

from __future__ import annotations

import numpy as np

from . import words
from .found import State
from .links import Chains, Link
from .pinned import pins
from .speech import roles_of


def branches_of(links, bed) -> list[list[Link]]:
    """Return the chains of links that start at the bed, two at most."""
    branches = []
    for first in [k for k in links if k.inner == bed]:
        branch = [first]
        while (more := next((k for k in links if k.inner == branch[-1].outer), None)) is not None:
            branch.append(more)
        branches.append(branch)
    return branches[:2]


def sides_of(state: State, reading: Chains, branches, places, up, answers):
    """(workpiece side, tool side, how sure): by a person, by names, by where the upright axis is."""
    branches = [*branches, *[[] for _ in range(2 - len(branches))]]
    document = state.document

    def bodies(branch):
        return set().union(*[reading.bodies[k.outer] for k in branch]) if branch else set()

    tool, work = pins(document, answers, "tool"), pins(document, answers, "work")
    for pinned, order in ((tool, 1), (work, 0)):
        if pinned:
            hit = 0 if bodies(branches[0]) & pinned else 1
            first, second = branches[hit], branches[1 - hit]
            return (second, first, 1.0) if order else (first, second, 1.0)

    def score(branch):
        body = bodies(branch)
        roles = roles_of(places, document.units, body)
        own = {words.role(document.units[n].label) for n in body}
        value = (
            1.0 * bool(roles & {"tool", "toolpost", "quill"})
            + 0.4 * bool(own & {"tool"})
            + 0.5 * bool(roles & {"gantry"})
        )
        value -= 1.0 * bool(roles & {"work", "table", "knee"}) + (0.5 if not state.said.lathe else 0.0) * bool(
            roles & {"saddle"}
        )
        value += 0.25 * any(abs(k.u @ up) > 0.9 for k in branch) * (not state.said.lathe)
        return value

    one, two = score(branches[0]), score(branches[1])
    if not branches[1]:
        standing = roles_of(places, document.units, reading.bodies[reading.bed])
        one -= 0.5 * bool(standing & {"tool", "quill", "toolpost"}) - 0.2
        one -= 1.0 * (not state.said.lathe and _hangs_over(state, reading, branches[0][-1].outer, up))
        if one >= -0.2 or (len(branches[0]) > 2 and one >= -0.5):
            return [], branches[0], 0.9 if one > 0.5 else 0.6
        return branches[0], [], 0.85 if one < -0.7 else 0.6
    if not state.said.lathe and up[2] > 0.9:  # the tool is above the work; which end of x or y is up, nothing says
        heights = [_height(document, reading.bodies[b[-1].outer], up) for b in branches]
        one, two = one + 0.4 * (heights[0] > heights[1]), two + 0.4 * (heights[1] > heights[0])
    sure = min(1.0, 0.5 + 0.4 * abs(one - two))
    return (branches[1], branches[0], sure) if one > two else (branches[0], branches[1], sure)


def _hangs_over(state, reading: Chains, last: int, up) -> bool:
    """Whether something solid of the bed is above the middle of a body: a tool there, and work on the body."""
    boxes = np.array([state.document.units[n].box for n in reading.bodies[last]])
    middle, top = (boxes[:, :3].min(0) + boxes[:, 3:].max(0)) / 2, _top(boxes, up)
    rest = [k for k in range(3) if abs(up[k]) < 0.5]
    for n in reading.bodies[reading.bed] - state.minor:
        for solid in state.document.units[n].solids:
            low, high = solid.extent(up)
            over = np.all(solid.box[rest] < middle[rest]) and np.all(solid.box[[k + 3 for k in rest]] > middle[rest])
            if over and high - low > 0.04 * state.size and low > top - 0.02 * state.size:
                return True
    return False


def _top(boxes, up) -> float:
    return float(max((boxes[:, :3] @ up).max(), (boxes[:, 3:] @ up).max()))


def _height(document, body, up) -> float:
    """Height of the middle of a body, mm."""
    ends = [document.units[n].extent(up) for n in body]
    return (min(e[0] for e in ends) + max(e[1] for e in ends)) / 2 if ends else 0.0
