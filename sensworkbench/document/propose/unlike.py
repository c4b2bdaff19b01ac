# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is no serial machine with linear axes: a delta, a hexapod, a jointed arm.  It is said in words."""

from __future__ import annotations

import numpy as np

from ...messages import Message
from .bodies import Graph, components
from .found import Found, Question, State
from .reading import Document


def no_serial(state: State, made: Found, answers) -> bool:
    """Delta, hexapod, robot arm: said in words."""
    if answers.get("kind") == "serial":
        return False
    said, document = state.said, state.document
    sliders = [b for b in document.bonds if b.kind == "slider"]
    struts = _struts(state)
    askew = len(struts)
    towers = _towers(state)
    guided = max((g.weight for g in state.guides), default=0.0)
    parallel = (said.delta and (askew >= 3 or towers >= 3)) or (askew >= 6 and towers >= 3)
    parallel = parallel or (guided < 0.6 and askew >= 6 and _three_fold(struts))
    jointed = not sliders and guided < 0.6 and (said.robot or _turning_chain(document) >= 3)
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


def _struts(state: State) -> np.ndarray:
    """(n, 3) middles of the long thin parts that lie along none of the machine's directions."""
    found = []
    for n, unit in enumerate(state.document.units):
        if n in state.minor:
            continue
        for solid in unit.solids[:20]:
            u, length = _long_way(solid)
            if u is not None and length > 0.12 * state.size and np.abs(state.axes @ u).max() < 0.985:
                found.append((solid.box[3:] + solid.box[:3]) / 2)
    return np.array(found).reshape(-1, 3)


def _long_way(solid):
    """(direction, length in mm) of a long thin solid that is round or a prism; (None, 0) of any other."""
    if len(solid.radii):
        lengths = np.linalg.norm(solid.round_boxes[:, 3:] - solid.round_boxes[:, :3], axis=1)
        k = int(np.argmax(np.where(solid.outside, lengths, 0)))
        if solid.outside[k] and lengths[k] > 8 * solid.radii[k]:
            return solid.axes[k], float(lengths[k])
    if 4 <= len(solid.offsets) <= 12:
        sizes = np.sort(solid.plane_boxes[:, 3:] - solid.plane_boxes[:, :3], axis=1)
        order = np.argsort(-sizes[:, 2])[:4]
        crosses = np.cross(solid.planes[order[0]], solid.planes[order[1:]])
        lengths = np.linalg.norm(crosses, axis=1)
        if lengths.max() > 0.3:
            u = crosses[int(np.argmax(lengths))] / lengths.max()
            reach = float(np.linalg.norm(solid.size))
            ends = np.abs(solid.planes @ u) > 0.95
            heights = solid.offsets[ends] * np.sign(solid.planes[ends] @ u)
            length = float(np.ptp(heights)) if ends.sum() > 1 else 0.0
            if length > 0.9 * reach:
                return u, length
    return None, 0.0


def _three_fold(struts: np.ndarray) -> bool:
    """Whether the middles of the struts come to lie on each other when they are turned by a third of a turn."""
    centre = struts.mean(0)
    for k in range(3):
        rest = [i for i in range(3) if i != k]
        spokes = (struts - centre)[:, rest]
        radius = float(np.linalg.norm(spokes, axis=1).max())
        c, s = -0.5, 3**0.5 / 2
        turned = spokes @ np.array([[c, s], [-s, c]])
        apart = np.linalg.norm(turned[:, None] - spokes[None], axis=2).min(1)
        if radius > 1.0 and float(apart.max()) < 0.12 * radius:
            return True
    return False


def _turning_chain(document: Document) -> int:
    """The length of the longest chain of turning joints, one part after another: an arm, not a row of pulleys."""
    held = Graph()
    for bond in document.bonds:
        if bond.kind == "fixed":
            held.add(bond.one, bond.other, 1.0)
    numbers = sorted({n for b in document.bonds for n in (b.one, b.other)})
    owner = {n: k for k, body in enumerate(components(held, numbers)) for n in body}
    turns: dict[int, set[int]] = {}
    for bond in document.bonds:
        a, b = owner[bond.one], owner[bond.other]
        if bond.kind == "turning" and a != b:
            turns.setdefault(a, set()).add(b)
            turns.setdefault(b, set()).add(a)

    def farthest(start):
        seen, waiting = {start: 0}, [start]
        for node in waiting:
            for other in turns.get(node, ()):
                if other not in seen:
                    seen[other] = seen[node] + 1
                    waiting.append(other)
        return max(seen, key=seen.get), max(seen.values())

    return max((farthest(farthest(node)[0])[1] for node in turns), default=0)


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
