# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies by the joints of an assembly: fixed and turning ones hold together, sliders are axes."""

from __future__ import annotations

from . import bodies as grouping
from .found import State
from .links import Chains, Evidence, Link
from .rooting import rooted


def by_joints(state: State, places, up, answers) -> Chains | None:
    """Bodies by the joints of an assembly: fixed and turning ones hold together, sliders are axes."""
    document = state.document
    sliders = [b for b in document.bonds if b.kind == "slider"]
    if not sliders:
        return None
    held = grouping.Graph()
    for bond in document.bonds:
        if bond.kind in ("fixed", "turning"):
            held.add(bond.one, bond.other, 1.0)
    grounded = sorted(document.grounded)
    for a, b in zip(grounded, grounded[1:]):
        held.add(a, b, 1.0)
    joined = {n for b in document.bonds for n in (b.one, b.other)} | document.grounded
    parts = grouping.components(held, sorted(joined))
    owner = {n: b for b, body in enumerate(parts) for n in body}
    edges: dict[tuple[int, int], Link] = {}
    for bond in sliders:
        a, b = owner[bond.one], owner[bond.other]
        if a == b:
            continue
        pair = (min(a, b), max(a, b))
        link = edges.setdefault(pair, Link(*pair))
        if link.bond is None:
            link.bond = bond
            link.evidence.append(Evidence("propose-evidence-slider", 0.95, bond.u, {"part": bond.label}))
    if not edges:
        return None
    others = [{n} for n in range(len(document.units)) if n not in owner]
    keep = [True] * len(parts) + [False] * len(others)
    parts += others
    used = {b for pair in edges for b in pair}
    keep = [k and b in used for b, k in enumerate(keep)]
    far = grouping.adopt(document, parts, keep, state.found, state.minor, state.size)
    return rooted(state, parts, edges, places, up, answers, "joints", far)
