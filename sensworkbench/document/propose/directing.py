# SPDX-License-Identifier: LGPL-2.1-or-later
"""The direction of each link: what guides, contacts, names and shapes vote for, and how sure that is."""

from __future__ import annotations

from itertools import permutations

import numpy as np

from . import words
from .guides import Guide, shape_of
from .links import EVIDENCE_CAP, Chains, Evidence, Link
from .reading import Document
from .speech import Words, roles_of


def direct(document: Document, reading: Chains, places, axes, up, said: Words, slides, size: float) -> None:
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


VOTED = {"propose-evidence-" + w for w in ("contact", "inside", "room", "upright", "level", "letter", "screw")}


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
        beam = "gantry" in roles_of(places, units, outer)  # its own rails are the next one's
        votes += inner_guides(document, inner, outer, axes, size, (0.1, 0.4) if beam else (0.5, 0.2))
        votes += _room(document, inner, outer, axes)
    elif all(e.u is None or e.code != "propose-evidence-guide" for e in votes):
        for guide in link.guides:
            votes.append(guide_evidence(document, guide))
    votes += _screws(document, inner, outer, axes)
    roles = roles_of(places, units, outer)
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


def guide_evidence(document, guide: Guide) -> Evidence:
    """Return what a guide says of the direction of its link."""
    units = document.units
    best = max(guide.slides, key=lambda s: s.weight)
    fields = {"part": units[best.rail[0]].label, "other": units[best.rider[0]].label,
              "count": len({s.rail for s in guide.slides})}  # fmt: skip
    return Evidence(f"propose-evidence-{guide.kind}", guide.weight, guide.u, fields)


def inner_guides(document, inner, outer, axes, size, shares=(0.5, 0.2)) -> list[Evidence]:
    """Rods and rails inside the parts themselves: an object that is a whole sub-assembly shows where it slides."""
    votes = []
    for body, share in zip((outer, inner), shares):
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


def _screws(document, inner, outer, axes) -> list[Evidence]:
    """A screw that one body holds, and a nut of the other on it, or the other's parts around it: along the screw."""
    votes: dict[int, Evidence] = {}
    for own, other in ((inner, outer), (outer, inner)):
        for n in own:
            screw = document.units[n]
            if screw.hardware != "screw":
                continue
            size = screw.box[3:] - screw.box[:3]
            k = int(np.argmax(np.abs(axes @ np.eye(3)[int(np.argmax(size))])))
            if size.max() < 5 * np.sort(size)[1]:
                continue
            around = [m for m in other if _around(document.units[m].box, screw.box)]
            if around:
                nut = any(document.units[m].hardware == "nut" for m in around)
                weight = 0.45 if nut else 0.2
                if k not in votes or votes[k].weight < weight:
                    votes[k] = Evidence("propose-evidence-screw", weight, axes[k], {"part": screw.label})
    return list(votes.values())


def _around(box, screw) -> bool:
    """Whether a box is threaded on a screw: around its line, and shorter than it."""
    size = screw[3:] - screw[:3]
    k = int(np.argmax(size))
    rest = [i for i in range(3) if i != k]
    middle = ((screw[3:] + screw[:3]) / 2)[rest]
    over = np.all(box[rest] < middle) and np.all(box[[i + 3 for i in rest]] > middle)
    return bool(over and box[k] > screw[k] and box[k + 3] < screw[k + 3])


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
