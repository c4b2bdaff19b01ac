# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies by what the parts are called, where guides show too little."""

from __future__ import annotations

import numpy as np

from . import words
from .bodies import adopt
from .links import Chains, Evidence, Link
from .reading import Document
from .rooting import tree
from .speech import Words, roles_of


def by_names(document: Document, found, places, minor, size: float, said: Words, up, answers) -> Chains | None:
    """Bodies by what the parts are called; None where the names say too little."""
    units = document.units
    nodes: dict[str, set[int]] = {}
    for n, (role, letter) in places.items():
        if units[n].hardware and units[n].hardware not in ("extrusion", "block"):
            if len(units[n].holders) == 0 or (not role and not letter):
                continue
        name = letter or ("F" if role in words.FIXED else role)
        if name:
            nodes.setdefault(name, set()).add(n)
    if said.lathe and "toolpost" in nodes and "saddle" in nodes:
        nodes["saddle"] |= nodes.pop("toolpost")
    if "work" in nodes and "table" in nodes:
        nodes["table"] |= nodes.pop("work")
    elif "work" in nodes and len(nodes) > 3 and len([a for a in "XYZ" if a in nodes]) < 3:
        nodes.setdefault("F", set()).update(nodes.pop("work"))
    if "tool" in nodes and "quill" in nodes:
        nodes["quill"] |= nodes.pop("tool")
    letters = [a for a in "XYZ" if a in nodes]
    if "tool" in nodes and ("Z" in letters or len(nodes) > 4):
        host = "Z" if "Z" in nodes else next((r for r in ("carriage", "gantry") if r in nodes), None)
        if host:
            nodes[host] |= nodes.pop("tool")
    if "quill" in nodes and "Z" in nodes:
        nodes["Z"] |= nodes.pop("quill")
    if len(letters) == 3:  # the letters name the axes; all else belongs to one of them, or to the bed
        for role in [r for r in nodes if r not in (*letters, "F")]:
            nodes[_host(document, nodes, role, letters, found, places)] |= nodes.pop(role)
    if "F" not in nodes:
        rest = {n for n in range(len(units)) if n not in minor and not any(n in s for s in nodes.values())}
        rest = {n for n in rest if not units[n].hardware or units[n].hardware == "extrusion"}
        if not rest:
            return None
        nodes["F"] = {max(rest, key=lambda n: units[n].bulk)}
    if len(nodes) < 2:
        return None
    names = ["F", *(k for k in nodes if k != "F")]
    bodies = [set(nodes[k]) for k in names]
    others = [{n} for n in range(len(units)) if n not in minor and not any(n in b for b in bodies)]
    bodies += others
    far = adopt(document, bodies, [True] * len(names) + [False] * len(others), found, minor, size)
    bodies = bodies[: len(names)]
    edges = {}
    tokens = [{k, *roles_of(places, units, nodes[k])} for k in names]
    strength = _strength(document, bodies, found, size)
    for i in range(len(names)):
        for j in range(i):
            prior = max(_prior(tokens[i], tokens[j]), _prior(tokens[j], tokens[i]))
            value = prior + strength[i, j]
            if value > 0.3:
                edges[j, i] = Link(j, i, [Evidence("propose-evidence-touch", value)])
    links, _ = tree(bodies, edges, 0)
    for link in links:
        label = _name(document, bodies[link.outer], nodes[names[link.outer]])
        link.evidence = [Evidence("propose-evidence-name", 0.3, None, {"part": label})]
    return Chains(bodies, 0, links, "names", far)


def _host(document, nodes, role, letters, found, places) -> str:
    """Which of X, Y, Z or the bed something belongs to: what it touches, else Z for a tool, the table for work."""
    pulls = {k: 0.0 for k in (*letters, "F") if k in nodes}
    for touch in found.contacts:
        for a, b in ((touch.one[0], touch.other[0]), (touch.other[0], touch.one[0])):
            if a in nodes[role]:
                for k in pulls:
                    if b in nodes[k]:
                        pulls[k] += touch.area + 1
    if max(pulls.values()) > 0:
        return max(pulls, key=pulls.get)
    tables = [k for k in letters if "table" in roles_of(places, document.units, nodes[k])]
    return tables[0] if role == "work" and tables else "Z"


def _name(document: Document, body, own) -> str:
    best = max(own or body, key=lambda n: document.units[n].bulk)
    unit = document.units[best]
    return next((t for t in (unit.label, *reversed(unit.labels)) if words.role(t) or words.letter(t)), unit.label)


PRIOR = {
    ("F", "gantry"): 1.0, ("F", "saddle"): 1.0, ("F", "knee"): 1.0, ("knee", "saddle"): 1.4, ("saddle", "table"): 1.4,
    ("knee", "table"): 0.8, ("F", "table"): 0.8, ("F", "quill"): 0.7, ("gantry", "carriage"): 1.4,
    ("carriage", "quill"): 1.2,
    ("carriage", "tool"): 1.0, ("gantry", "quill"): 0.6, ("gantry", "tool"): 0.5, ("F", "carriage"): 0.4,
    ("F", "tool"): 0.2,
    ("carriage", "saddle"): 1.2, ("saddle", "toolpost"): 1.0, ("carriage", "toolpost"): 0.8, ("F", "X"): 0.4,
    ("F", "Y"): 0.4,
    ("F", "Z"): 0.4, ("X", "Z"): 0.5, ("Y", "X"): 0.4, ("X", "Y"): 0.4, ("X", "tool"): 0.6, ("gantry", "X"): 1.0,
    ("gantry", "Z"): 0.8, ("carriage", "Z"): 1.0, ("Z", "X"): 0.4, ("Y", "Z"): 0.4, ("Z", "Y"): 0.3,
    ("Y", "gantry"): 0.4,
}  # fmt: skip


def _prior(inner: set[str], outer: set[str]) -> float:
    return max((PRIOR.get((a, b), 0.0) for a in inner for b in outer), default=0.0)


def _strength(document: Document, bodies, found, size: float) -> np.ndarray:
    """How strongly bodies touch: 0 where they are apart, up to about 1.5."""
    count = len(bodies)
    areas = np.zeros((count, count))
    near = np.zeros((count, count))
    owner = {n: b for b, body in enumerate(bodies) for n in body}
    for touch in found.contacts:
        a, b = owner.get(touch.one[0]), owner.get(touch.other[0])
        if a is not None and b is not None and a != b:
            areas[a, b] += touch.area
            near[a, b] = max(near[a, b], 0.25)
    areas += areas.T
    near = np.maximum(near, near.T)
    for bond in document.bonds:
        a, b = owner.get(bond.one), owner.get(bond.other)
        if a is not None and b is not None and a != b:
            near[a, b] = near[b, a] = max(near[a, b], 0.9)
    boxes = []
    for body in bodies:
        box = np.array([document.units[n].box for n in body])
        boxes.append(np.hstack([box[:, :3].min(0), box[:, 3:].max(0)]) if len(box) else np.zeros(6))
    for i in range(count):
        for j in range(i):
            gap = np.linalg.norm(np.maximum(0, np.maximum(boxes[i][:3] - boxes[j][3:], boxes[j][:3] - boxes[i][3:])))
            if gap < 0.05 * size:
                near[i, j] = near[j, i] = max(near[i, j], 0.1)
    return near + 0.6 * np.sqrt(areas / max(areas.max(), 1e-9)) * (areas > 0)
