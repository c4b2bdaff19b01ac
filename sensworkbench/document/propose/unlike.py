# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is no serial machine with linear axes: a delta, a hexapod, a jointed arm.  It is said in words."""

from __future__ import annotations

import numpy as np

from ...messages import Message
from .found import Found, Question, State


def no_serial(state: State, made: Found, answers) -> bool:
    """Delta, hexapod, robot arm: said in words."""
    if answers.get("kind") == "serial":
        return False
    said, document = state.said, state.document
    sliders = [b for b in document.bonds if b.kind == "slider"]
    askew = _askew(state)
    towers = _towers(state)
    guided = max((g.weight for g in state.guides), default=0.0)
    parallel = (said.delta and (askew >= 3 or towers >= 3)) or (askew >= 6 and towers >= 3)
    jointed = not sliders and guided < 0.85 and ((said.robot and guided < 0.6) or document.rotary_joints >= 4)
    if parallel or (said.delta and not sliders and guided <= 0.6):
        made.kind = "parallel"
        made.remarks.append(Message("propose-delta", struts=askew, towers=towers))
    elif jointed:
        made.kind = "serial"
        made.remarks.append(Message("propose-robot", joints=document.rotary_joints))
    else:
        return False
    made.questions.append(Question("kind", Message("propose-ask-kind"), "choice", (
        ("none", Message("propose-choice-none")), ("serial", Message("propose-choice-serial")))))  # fmt: skip
    return True


def _askew(state: State) -> int:
    """Long thin parts along none of the machine's directions."""
    count = 0
    for n, unit in enumerate(state.document.units):
        if n in state.minor:
            continue
        for solid in unit.solids[:20]:
            if not len(solid.radii):
                continue
            lengths = np.linalg.norm(solid.round_boxes[:, 3:] - solid.round_boxes[:, :3], axis=1)
            k = int(np.argmax(np.where(solid.outside, lengths, 0)))
            if solid.outside[k] and lengths[k] > 8 * solid.radii[k] and lengths[k] > 0.12 * state.size:
                lean = np.abs(state.axes @ solid.axes[k]).max()
                count += bool(lean < 0.985)
    return count


def _towers(state: State) -> int:
    """How many upright guides stand round a middle at about 120 degrees to each other."""
    best = 0
    for a in state.axes:
        at = []
        for n, unit in enumerate(state.document.units):
            if n in state.minor or unit.hardware in ("screw", "fastener"):
                continue
            for solid in unit.solids[:20]:
                length = float(solid.size @ np.abs(a))
                across = solid.size - np.abs(a) * length
                if length > 0.3 * state.size and length > 5 * across.max():
                    middle = (solid.box[3:] + solid.box[:3]) / 2
                    at.append(middle - a * (middle @ a))
        if len(at) < 3:
            continue
        at = np.array(at)
        spokes = at - at.mean(0)
        radii = np.linalg.norm(spokes, axis=1)
        spokes = spokes[radii > 0.5 * radii.max()]
        spokes /= np.linalg.norm(spokes, axis=1)[:, None]
        clusters: list = []
        for s in spokes:
            if not any(s @ c > 0.85 for c in clusters):
                clusters.append(s)
        if len(clusters) == 3 and all(-0.7 < clusters[i] @ clusters[j] < -0.3 for i in range(3) for j in range(i)):
            best = 3
    return best
