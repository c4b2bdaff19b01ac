# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies and the joints between them: by guides, by the document's own joints, by names; directions, order, letters.

Several readings of one document are made and the fullest that holds together is kept; what the others say counts for or
against it.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import permutations

import numpy as np

from . import words
from .guides import Guide, Slide
from .reading import Bond, Document

EVIDENCE_CAP = 0.97


@dataclass
class Evidence:
    """Something that speaks for a direction u of a joint.  code, fields : of the message that says it."""

    code: str
    weight: float
    u: np.ndarray | None = None
    fields: dict = field(default_factory=dict)


@dataclass
class Link:
    """Body `outer` moves on body `inner`."""

    inner: int
    outer: int
    evidence: list[Evidence] = field(default_factory=list)
    guides: list[Guide] = field(default_factory=list)
    slides: list[Slide] = field(default_factory=list)
    bond: Bond | None = None
    u: np.ndarray | None = None
    letter: str = ""
    confidence: float = 0.0
    margin: float = 1.0
    told: np.ndarray | None = None  # direction that a person has given
    told_letter: str = ""


@dataclass
class Reading:
    """Bodies (sets of unit numbers), the first of them the bed, and the links between them from the bed outwards."""

    bodies: list[set[int]]
    bed: int
    links: list[Link]
    source: str  # "joints", "guides" or "names"
    far: list[int] = field(default_factory=list)
    merged: list[tuple[int, int]] = field(default_factory=list)  # (outer, inner) of slides that are no machine axis
    bed_sure: float = 0.5

    def body_of(self, unit: int) -> int | None:
        """Return the number of the body that a unit belongs to, or None."""
        return next((b for b, body in enumerate(self.bodies) if unit in body), None)


# -- what kind of machine the names speak of -------------------------------------------------------------------------
@dataclass(frozen=True)
class Words:
    """What the names of a document say as a whole."""

    lathe: bool
    printer: bool
    delta: bool
    robot: bool
    rotary: tuple[str, ...]


def speech(document: Document, title: str = "") -> Words:
    """Return what the names in a document say together, such as whether they are those of a lathe."""
    labels = {*document.names, *(t for u in document.units for t in (*u.labels, u.source)), title}
    texts = {label: words.plain(label) for label in labels if label}
    said = " | ".join(texts.values())
    lathe = len({m.group(0) for m in words.LATHE.finditer(said)}) >= 2 or bool(
        words._words("lathe|drehbank|drehmaschine|modulathe").search(said))  # fmt: skip
    mill = sum(words.role(label) in ("gantry", "table") for label in labels)
    rotary = tuple(sorted(label for label, text in texts.items() if words.ROTARY.search(text)))[:6]
    return Words(
        lathe and not (mill > 2 and "lathe" not in said), bool(words.PRINTER.search(said)),
        bool(words.DELTA.search(said)), len({m.group(0) for m in words.ROBOT.finditer(said)}) >= 2, rotary,
    )  # fmt: skip


def place_of(document: Document, n: int, said: Words, common: set) -> tuple[str, str]:
    """(role, letter) of a unit: of the innermost container that states one, else its own.

    common : holders that hold nearly everything, whose names are the machine's.
    """
    unit = document.units[n]
    for holder, label in reversed(list(zip(unit.holders, unit.labels))):
        if holder in common or words.hardware(label):
            continue
        role, letter = words.role(label), words.letter(label)
        if role or letter:
            return _fitting(role, said), letter
    return _fitting(unit.own_role, said), unit.own_letter


def _fitting(role: str, said: Words) -> str:
    if said.printer and role == "bed":
        return "table"
    if role == "headstock":
        return "headstock" if said.lathe else "quill"
    if role == "chuck":
        return "headstock" if said.lathe else "work"
    if said.lathe and role in ("quill", "tool"):
        return "headstock" if role == "quill" else ""
    return role


def common_holders(document: Document, minor: set[int]) -> set:
    """Return the containers that hold most of the units, and therefore distinguish none."""
    counts: dict[tuple, int] = {}
    units = [u for n, u in enumerate(document.units) if n not in minor]
    for unit in units:
        for holder in unit.holders:
            counts[holder] = counts.get(holder, 0) + 1
    return {holder for holder, count in counts.items() if count > 0.7 * len(units)}


# -- readings --------------------------------------------------------------------------------------------------------
def tree(bodies, edges: dict[tuple[int, int], Link], bed: int) -> tuple[list[Link], list[tuple[int, int]]]:
    """Links from the bed outwards, the surest first; and what is reached a second time."""
    reached, made, again = {bed}, [], []
    waiting = dict(edges)
    while True:
        open_ = [pair for pair in waiting if (pair[0] in reached) != (pair[1] in reached)]
        if not open_:
            break
        pair = max(open_, key=lambda p: max((e.weight for e in waiting[p].evidence), default=0.0))
        link = waiting.pop(pair)
        inner, outer = pair if pair[0] in reached else pair[::-1]
        link.inner, link.outer = inner, outer
        reached.add(outer)
        made.append(link)
    for pair in waiting:
        if pair[0] in reached and pair[1] in reached:
            again.append(pair)
    return made, again


def bed_scores(document: Document, bodies, places, up, said: Words, pinned: set[int]) -> list[float]:
    """How much speaks for each body to be the bed."""
    units = document.units
    lows = [min((units[n].extent(up)[0] for n in body), default=1e9) for body in bodies]
    highs = [max((units[n].extent(up)[1] for n in body), default=-1e9) for body in bodies]
    bulk = [sum(units[n].bulk for n in body) for body in bodies]
    floor, height = min(lows), max(1e-6, max(highs) - min(lows))
    scores = []
    for b, body in enumerate(bodies):
        score = 1.0 * bulk[b] / max(1e-9, sum(bulk)) + 0.5 * (1 - (lows[b] - floor) / height)
        weights = {n: units[n].bulk for n in body}
        total = sum(weights.values()) or 1.0
        fixed = sum(w for n, w in weights.items() if places[n][0] in words.FIXED) / total
        moving = sum(w for n, w in weights.items() if places[n][0] in words.MOVING or places[n][1]) / total
        score += 1.2 * fixed - 0.8 * moving
        score += 0.5 * any(places[n][0] in ("bed", "base") for n in body)
        if document.grounded & body:
            score += 3.0
        if pinned & body:
            score += 100.0
        scores.append(score)
    return scores


def by_names(document: Document, found, places, minor, size: float, said: Words, up, answers) -> Reading | None:
    """Bodies by what the parts are called; None where the names say too little."""
    from .bodies import adopt

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
    tokens = [{k, *_roles(places, units, nodes[k])} for k in names]
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
    return Reading(bodies, 0, links, "names", far)


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
    tables = [k for k in letters if "table" in _roles(places, document.units, nodes[k])]
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


# -- directions ------------------------------------------------------------------------------------------------------
def direct(document: Document, reading: Reading, places, axes, up, said: Words, slides, size: float) -> None:
    """Give each link its direction: what guides, contacts, names and shapes vote for, no two alike where possible."""
    rows = []
    for link in reading.links:
        votes = _votes(document, reading, link, places, axes, up, said, slides, size)
        rows.append(votes)
    count = len(reading.links)
    if not count:
        return
    table = np.array([[sum(e.weight for e in votes if e.u is not None and abs(e.u @ a) > 0.9) for a in axes]
                      for votes in rows])  # fmt: skip
    skew = [next((e.u for e in votes if e.weight >= 0.5 and e.u is not None and np.abs(axes @ e.u).max() < 0.9), None)
            for votes in rows]  # fmt: skip
    orders = list(permutations(range(3), count)) if count <= 3 else [tuple(np.argmax(table, axis=1))]
    values = [sum(table[i, k] for i, k in enumerate(order)) for order in orders]
    best = orders[int(np.argmax(values))]
    free = tuple(int(k) for k in np.argmax(table, axis=1))
    for i, link in enumerate(reading.links):
        alternatives = [v for order, v in zip(orders, values) if order[i] != best[i]]
        link.margin = float(max(values) - max(alternatives)) if alternatives else float(table[i, best[i]])
        sure = bool(link.guides or link.bond) and table[i, free[i]] > 0.8 and free[i] != best[i]
        pick = free[i] if sure else best[i]
        if skew[i] is not None and table[i, pick] < 0.5:
            link.u = skew[i]
        else:
            along = [e.u for e in rows[i] if e.u is not None and e.weight >= 0.5 and abs(e.u @ axes[pick]) > 0.99]
            link.u = along[0] if along else axes[pick]
        link.evidence = [e for e in rows[i] if e.u is None or abs(e.u @ link.u) > 0.9]
        against = [e for e in rows[i] if e.u is not None and abs(e.u @ link.u) < 0.9]
        link.confidence = _confidence(link, against)


VOTED = {"propose-evidence-" + w for w in ("contact", "inside", "room", "upright", "level", "letter")}


def _votes(document, reading, link, places, axes, up, said, slides, size) -> list[Evidence]:
    units = document.units
    votes = [e for e in link.evidence if e.code not in VOTED]
    if link.told is not None:
        votes.append(Evidence("propose-evidence-person", 4.0, link.told / np.linalg.norm(link.told)))
    inner, outer = reading.bodies[link.inner], reading.bodies[link.outer]
    between = [
        s
        for s in slides
        if (s.rail[0] in inner and s.rider[0] in outer) or (s.rail[0] in outer and s.rider[0] in inner)
    ]
    link.slides = between
    if not link.guides:
        for a in axes:
            own = sorted((s for s in between if abs(s.u @ a) > 0.99), key=lambda s: -s.weight)
            if own and own[0].weight > 0.12:
                fields = {"part": units[own[0].rail[0]].label, "other": units[own[0].rider[0]].label}
                votes.append(
                    Evidence(
                        "propose-evidence-contact", min(0.75, own[0].weight + 0.04 * len(own[1:4])), own[0].u, fields
                    )
                )
        votes += _inner_guides(document, inner, outer, axes, size)
        votes += _room(document, inner, outer, axes)
    elif all(e.u is None or e.code != "propose-evidence-guide" for e in votes):
        for guide in link.guides:
            votes.append(_guide_evidence(document, guide))
    roles = _roles(places, units, outer)
    letters = {places[n][1] for n in outer if places.get(n, ("", ""))[1]}
    if roles & words.VERTICAL or (roles & {"tool"} and not roles & words.LEVEL and not said.lathe):
        votes.append(Evidence("propose-evidence-upright", 0.35, up))
    elif roles & {"gantry", "saddle", "table"} and not said.lathe:
        for a in axes:
            if abs(a @ up) < 0.5:
                votes.append(Evidence("propose-evidence-level", 0.15, a))
    if len(letters) == 1:
        k = "XYZ".index(next(iter(letters)))
        order = _document_order(axes, up)
        votes.append(Evidence("propose-evidence-letter", 0.3, axes[order[k]], {"letter": "XYZ"[k]}))
    return votes


def _document_order(axes, up) -> list[int]:
    """Numbers of the axes that would be called X, Y and Z."""
    z = int(np.argmax(np.abs(axes @ up)))
    rest = [k for k in range(3) if k != z]
    rest.sort(key=lambda k: -abs(axes[k][0]))
    return [*rest, z]


def _roles(places, units, body) -> set[str]:
    total = sum(units[n].bulk for n in body) or 1.0
    share: dict[str, float] = {}
    for n in body:
        role = places.get(n, ("", ""))[0]
        if role:
            share[role] = share.get(role, 0.0) + units[n].bulk / total
    return {
        role
        for role, s in share.items()
        if s > 0.1 or role in ("quill", "gantry", "saddle", "knee", "table", "tool", "toolpost")
    }


def _guide_evidence(document, guide: Guide) -> Evidence:
    units = document.units
    best = max(guide.slides, key=lambda s: s.weight)
    fields = {"part": units[best.rail[0]].label, "other": units[best.rider[0]].label,
              "count": len({s.rail for s in guide.slides})}  # fmt: skip
    return Evidence(f"propose-evidence-{guide.kind}", guide.weight, guide.u, fields)


def _inner_guides(document, inner, outer, axes, size) -> list[Evidence]:
    """Rods and rails inside the parts themselves: an object that is a whole sub-assembly shows where it slides."""
    from .guides import shape_of

    votes = []
    for body, share in ((outer, 0.5), (inner, 0.2)):
        lengths, label = np.zeros(3), ["", "", ""]
        for n in body:
            unit = document.units[n]
            if unit.hardware in ("extrusion", "screw"):
                continue
            for solid in unit.solids:
                kind, u = shape_of(solid, size)
                if not kind:
                    continue
                round_ = len(solid.radii) > 0 and len(solid.offsets) <= 6
                hit = np.abs(axes @ u) > 0.99
                lengths[hit] += float(solid.size @ np.abs(u)) * (
                    1.0 if round_ or unit.hardware in ("rail", "shaft") else 0.4
                )
                for k in np.flatnonzero(hit):
                    label[k] = unit.label
        if lengths.sum() > 0:
            k = int(np.argmax(lengths))
            votes.append(
                Evidence("propose-evidence-inside", share * lengths[k] / lengths.sum(), axes[k], {"part": label[k]})
            )
    return votes


def _room(document, inner, outer, axes) -> list[Evidence]:
    """Along which a body is short and what it stands on is long, there it may travel."""
    ratios = []
    for a in axes:
        low = min(document.units[n].extent(a)[0] for n in inner), min(document.units[n].extent(a)[0] for n in outer)
        high = max(document.units[n].extent(a)[1] for n in inner), max(document.units[n].extent(a)[1] for n in outer)
        long, short = high[0] - low[0], high[1] - low[1]
        inside = min(high) - max(low) > 0.5 * short
        ratios.append((1 - short / long) if inside and long > short else 0.0)
    order = np.argsort(ratios)
    if ratios[order[2]] - ratios[order[1]] > 0.15:
        return [Evidence("propose-evidence-room", 0.3 * ratios[order[2]], axes[order[2]])]
    return [Evidence("propose-evidence-room", 0.15 * r, a) for a, r in zip(axes, ratios) if r > 0.2]


def _confidence(link: Link, against) -> float:
    doubt, kinds = 1.0, set()
    for e in sorted(link.evidence, key=lambda e: -e.weight):
        if e.code in kinds:
            continue
        kinds.add(e.code)
        doubt *= 1 - 0.85 * min(1.0, e.weight)
    value = 1 - doubt
    for e in against:
        if e.code != "propose-evidence-level":
            value *= 1 - 0.35 * min(1.0, e.weight)
    if link.margin < 0.15:
        value *= 0.6
    elif link.margin < 0.35:
        value *= 0.85
    return float(min(EVIDENCE_CAP, value))
