# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which solids touch, and in which directions what touches can slide, from their flat and round faces alone.

Two flat faces that look at each other and overlap are a contact, and so are a shaft and the bore around it.  Two parts
can slide along u where no contact looks along u; a channel around a tongue, or a bore around a shaft, guides.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

TOUCH = 0.35  # mm between faces that touch
SUNK = 1.2  # mm that one face may lie behind the other: fits, glue, rounding
PLAY = 1.5  # mm between a guide and what runs on it
ALONG = 0.03  # cosine: what looks this little along a direction does not bar it
MOST_FLATS = 160  # faces of one solid that are compared with another's


@dataclass
class Contact:
    """Contact of two solids: normals (k, 3) of the faces of `one`, their areas in mm2 and boxes (k, 6).

    bores : (axis, radius, which of the two is inside, area, box) of a shaft in a bore.
    overlap : share of the smaller box that lies in the other's.
    """

    one: tuple[int, int]  # unit, solid
    other: tuple[int, int]
    normals: np.ndarray
    areas: np.ndarray
    boxes: np.ndarray
    bores: list = field(default_factory=list)
    overlap: float = 0.0
    gap: float = 0.0
    ours: np.ndarray = field(default_factory=lambda: np.zeros((0, 6)))  # boxes of the whole faces in contact: of `one`
    theirs: np.ndarray = field(default_factory=lambda: np.zeros((0, 6)))  # and of `other`, in the order of `normals`
    shafts: list = field(
        default_factory=list
    )  # (axis, point, radius, box of the face of `one`, of `other`) of each bore

    @property
    def area(self) -> float:
        """Area in contact, mm²."""
        return float(self.areas.sum()) + sum(b[3] for b in self.bores)

    @property
    def touches(self) -> bool:
        """Whether the two units touch at all."""
        return len(self.areas) > 0 or bool(self.bores)


def together(contacts: list[Contact]) -> Contact:
    """The contacts of two units as one.  All have the same unit first."""
    first = max(contacts, key=lambda c: c.area)
    return Contact(
        first.one,
        first.other,
        np.vstack([c.normals for c in contacts]),
        np.concatenate([c.areas for c in contacts]),
        np.vstack([c.boxes for c in contacts]),
        [b for c in contacts for b in c.bores],
        ours=np.vstack([c.ours for c in contacts]),
        theirs=np.vstack([c.theirs for c in contacts]),
        shafts=[s for c in contacts for s in c.shafts],
    )


def near_pairs(boxes: np.ndarray, owner: np.ndarray, reach: float) -> list[tuple[int, int]]:
    """Pairs of solids of different units whose boxes come closer than `reach`."""
    found = []
    low, high = boxes[:, :3] - reach / 2, boxes[:, 3:] + reach / 2
    order = np.argsort(low[:, 0])
    sorted_low = low[order, 0]
    for position, i in enumerate(order):
        end = np.searchsorted(sorted_low, high[i, 0], side="right")
        others = order[position + 1 : end]
        if len(others):
            hit = np.all((low[others] <= high[i]) & (high[others] >= low[i]), axis=1) & (owner[others] != owner[i])
            found += [(int(i), int(j)) for j in others[hit]]
    return found


def contact(a, b, one, other, allowed: float) -> Contact | None:
    """The contact of two solids; None where they neither touch nor overlap.  allowed : gap in mm that still counts."""
    low = np.maximum(a.box[:3], b.box[:3])
    high = np.minimum(a.box[3:], b.box[3:])
    window = np.hstack([low - allowed - 0.5, high + allowed + 0.5])
    made = Contact(one, other, np.zeros((0, 3)), np.zeros(0), np.zeros((0, 6)))
    _flats(a, b, window, made, allowed)
    _rounds(a, b, window, made, allowed)
    shared = np.maximum(high - low, 0.0)
    small = min(np.prod(np.maximum(a.size, 0.1)), np.prod(np.maximum(b.size, 0.1)))
    made.overlap = float(np.prod(shared) / small)
    made.gap = float(np.linalg.norm(np.maximum(low - high, 0.0)))
    return made if made.touches or made.gap <= allowed else None


def _inside(boxes: np.ndarray, window: np.ndarray) -> np.ndarray:
    return np.all((boxes[:, :3] <= window[3:]) & (boxes[:, 3:] >= window[:3]), axis=1)


def _flats(a, b, window, made: Contact, allowed: float) -> None:
    ia, ib = (np.flatnonzero(_inside(s.plane_boxes, window)) if len(s.offsets) else np.zeros(0, int) for s in (a, b))
    if not len(ia) or not len(ib):
        return
    ia, ib = (_largest(s, i) for s, i in ((a, ia), (b, ib)))
    facing = a.planes[ia] @ b.planes[ib].T < -0.9995
    depth = a.offsets[ia][:, None] + b.offsets[ib][None, :]
    close = (depth > -allowed) & (depth < max(allowed, SUNK))
    for i, j in zip(*np.nonzero(facing & close)):
        p, q = a.plane_boxes[ia[i]], b.plane_boxes[ib[j]]
        low, high = np.maximum(p[:3], q[:3]), np.minimum(p[3:], q[3:])
        shared = high - low
        if np.any(shared < -allowed):
            continue
        shared = np.sort(np.maximum(shared, 0.0))
        area = shared[1] * shared[2]
        if area < 1.0:
            continue
        made.normals = np.vstack([made.normals, a.planes[ia[i]]])
        made.areas = np.append(made.areas, area)
        made.boxes = np.vstack([made.boxes, np.hstack([np.minimum(low, high), np.maximum(low, high)])])
        made.ours, made.theirs = np.vstack([made.ours, p]), np.vstack([made.theirs, q])


def _largest(solid, numbers):
    if len(numbers) <= MOST_FLATS:
        return numbers
    boxes = solid.plane_boxes[numbers]
    return numbers[np.argsort(-np.linalg.norm(boxes[:, 3:] - boxes[:, :3], axis=1))[:MOST_FLATS]]


def _rounds(a, b, window, made: Contact, allowed: float) -> None:
    ia, ib = (np.flatnonzero(_inside(s.round_boxes, window)) if len(s.radii) else np.zeros(0, int) for s in (a, b))
    ia, ib = ia[:MOST_FLATS], ib[:MOST_FLATS]
    if not len(ia) or not len(ib):
        return
    parallel = np.abs(a.axes[ia] @ b.axes[ib].T) > 0.9995
    fits = np.abs(a.radii[ia][:, None] - b.radii[ib][None, :]) < np.maximum(allowed, 0.03 * a.radii[ia])[:, None]
    opposite = a.outside[ia][:, None] != b.outside[ib][None, :]
    for i, j in zip(*np.nonzero(parallel & fits & opposite)):
        i, j = ia[i], ib[j]
        axis = a.axes[i]
        across = b.points[j] - a.points[i]
        if np.linalg.norm(across - axis * (across @ axis)) > max(allowed, 0.3):
            continue
        p, q = a.round_boxes[i], b.round_boxes[j]
        low, high = np.maximum(p[:3], q[:3]), np.minimum(p[3:], q[3:])
        length = float(np.abs(high - low) @ np.abs(axis)) if np.all(high - low > -allowed) else 0.0
        if length < 1.0:
            continue
        inner = 0 if a.outside[i] else 1
        made.shafts.append((axis, a.points[i], float(a.radii[i]), p, q))
        known = next((n for n, k in enumerate(made.bores) if abs(k[0] @ axis) > 0.9995), None)
        entry = (axis, float(a.radii[i]), inner, 3.0 * float(a.radii[i]) * length, np.hstack([low, high]))
        if known is None:
            made.bores.append(entry)
        elif entry[3] > made.bores[known][3]:
            made.bores[known] = entry


# -- what can slide --------------------------------------------------------------------------------------------------
@dataclass
class Freedom:
    """A direction in which a contact lets its two solids slide.  guided : walls on both sides, or a bore.

    barred : share of the contact's area that looks along u.  length : of the contact along u, mm.  width : across.
    """

    u: np.ndarray
    guided: bool
    walls: int
    barred: float
    length: float
    width: float


def freedoms(found: Contact, axes: np.ndarray) -> list[Freedom]:
    """Directions in which the solids of a contact could slide.  axes (3, 3): the directions of the machine, as rows."""
    made = []
    candidates = [b[0] for b in found.bores] or []
    if len(found.areas):
        first = found.normals[int(np.argmax(found.areas))]
        crosses = np.cross(first, found.normals)
        good = np.linalg.norm(crosses, axis=1) > 0.3
        if good.any():
            best = int(np.argmax(found.areas * good))
            candidates.append(crosses[best] / np.linalg.norm(crosses[best]))
        candidates += [u for u in axes if abs(u @ first) < ALONG]
    for u in candidates:
        if any(abs(u @ f.u) > 0.999 for f in made):
            continue
        made.append(_freedom(found, u))
    return made


def _freedom(found: Contact, u) -> Freedom:
    along = np.abs(found.normals @ u) if len(found.areas) else np.zeros(0)
    barred = float(found.areas[along > ALONG].sum()) / max(found.area, 1e-9)
    free = along <= ALONG
    normals, areas = found.normals[free], found.areas[free]
    guided = any(abs(b[0] @ u) > 0.999 for b in found.bores)
    walls = 0
    if len(areas):
        opposed = normals @ normals.T < -0.3
        weight = np.minimum(areas[:, None], areas[None, :])
        guided = guided or bool((opposed & (weight > 0.02 * areas.sum())).any())
        kinds: list = []
        for normal, area in zip(normals, areas):
            if area > 0.02 * areas.sum() and not any(normal @ k > 0.98 for k in kinds):
                kinds.append(normal)
        walls = len(kinds)
    boxes = [*found.boxes[free], *(b[4] for b in found.bores if abs(b[0] @ u) > 0.999)]
    if not boxes:
        return Freedom(u, guided, walls, barred, 0.0, 0.0)
    boxes = np.array(boxes)
    low, high = boxes[:, :3].min(0), boxes[:, 3:].max(0)
    size = high - low
    length = float(size @ np.abs(u))
    across = size - np.abs(u) * length
    return Freedom(u, guided, walls, barred, length, float(np.max(np.abs(across))))
