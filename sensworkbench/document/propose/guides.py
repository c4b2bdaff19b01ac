# SPDX-License-Identifier: LGPL-2.1-or-later
"""What slides on what: rails and blocks, shafts and bushings, profiles and wheels, dovetails, channels in wood.

Every contact that leaves a direction free is weighed by what the parts are called, by walls on both sides, and by the
room there is to travel; parallel rails of equal length and reach are one guide.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from .facets import Solid
from .reading import Document
from .touching import ALONG, PLAY, TOUCH, contact, freedoms, near_pairs, together

RIGID = {"motor", "support", "bearing", "drive", "fastener", "loose"}  # these hold, or turn; nothing slides on them
RAILS = {"rail", "shaft"}
RIDERS = {"block", "wheel", "nut"}
SLENDER = 6.0
SEAT = 0.62  # what covers more of a rail than this is its seat
PARALLEL = 0.9994  # cosine of 2 degrees


@dataclass
class Slide:
    """Solid `rider` = (unit, solid) slides along u on solid `rail`, from `low` to `high`; the rail reaches from
    `start` to `end`; mm along u.  weight : 0 to 1, how much speaks for it.  kind : of guide, a code."""

    rail: tuple[int, int]
    rider: tuple[int, int]
    u: np.ndarray
    weight: float
    kind: str
    low: float
    high: float
    start: float
    end: float

    @property
    def length(self) -> float:
        """Length over which it slides, mm."""
        return self.end - self.start


@dataclass
class Guide:
    """Slides that are one guide: their rails are on one body, their riders on another (or several along it)."""

    slides: list[Slide]

    @property
    def u(self) -> np.ndarray:
        """Unit vector of the slide with the largest weight."""
        return max(self.slides, key=lambda s: (s.weight, s.length)).u

    @property
    def weight(self) -> float:
        """Confidence that it is a guide, 0 to 0.97; more rails give more."""
        best = sorted((s.weight for s in self.slides), reverse=True)
        return min(0.97, best[0] + 0.05 * min(3, len({s.rail for s in self.slides}) - 1))

    @property
    def kind(self) -> str:
        """Kind of the slide with the largest weight."""
        return max(self.slides, key=lambda s: s.weight).kind

    @property
    def rails(self) -> set[int]:
        """Numbers of the units that are its rails."""
        return {s.rail[0] for s in self.slides}

    @property
    def riders(self) -> set[int]:
        """Numbers of the units that slide on it."""
        return {s.rider[0] for s in self.slides}

    @property
    def length(self) -> float:
        """Length of its longest slide, mm."""
        return max(s.length for s in self.slides)


@dataclass
class Touching:
    """All that touches: contacts of pairs of solids, and what may slide."""

    contacts: list = field(default_factory=list)
    slides: list[Slide] = field(default_factory=list)
    screws: list[Slide] = field(default_factory=list)
    cut_short: bool = False


def shape_of(solid, size: float) -> tuple[str, np.ndarray | None]:
    """("bar", direction) of a long thin solid, else ("", None).  size : of the machine, mm."""
    lengths = solid.size
    order = np.argsort(lengths)
    u = np.eye(3)[order[2]]
    if lengths[order[2]] >= 0.12 * size and lengths[order[2]] >= SLENDER * max(lengths[order[1]], 0.5):
        return "bar", u
    if len(solid.radii):  # a bar that stands askew
        best = int(np.argmax(np.linalg.norm(solid.round_boxes[:, 3:] - solid.round_boxes[:, :3], axis=1)))
        length = float(np.linalg.norm(solid.round_boxes[best, 3:] - solid.round_boxes[best, :3]))
        if solid.outside[best] and length > SLENDER * 2 * solid.radii[best] and length > 0.12 * size:
            if abs(solid.axes[best] @ u) < 0.99 and abs(np.abs(solid.axes[best]).max()) < 0.99:
                return "bar", solid.axes[best]
    return "", None


def is_round_bar(solid, u) -> bool:
    """Whether the section of a bar along u is that of a cylinder, not of a prism with rounded edges or bores."""
    if not len(solid.radii):
        return False
    width = float(np.max(solid.size - np.abs(u) * (solid.size @ np.abs(u))))
    along = solid.outside & (np.abs(solid.axes @ u) > 0.99)
    return bool(along.any()) and 2 * float(solid.radii[along].max()) > 0.6 * width


def touching(document: Document, axes: np.ndarray, minor: set[int], size: float, watch, until) -> Touching:
    """Examine all pairs of neighbours.  minor : units that are too small to count.  watch(done, all): true stops."""
    import time

    units = document.units
    flat = [(n, k) for n, u in enumerate(units) if n not in minor for k in range(len(u.solids))]
    found = Touching()
    if not flat:
        return found
    solids = [units[n].solids[k] for n, k in flat]
    plays = [_play(s, units[n].hardware, size) for s, (n, _) in zip(solids, flat)]
    reach = max(PLAY, *plays)
    pairs = near_pairs(np.array([s.box for s in solids]), np.array([n for n, _ in flat]), reach)
    pairs.sort(key=lambda p: -min(_diagonal(solids[p[0]]), _diagonal(solids[p[1]])))
    for number, (i, j) in enumerate(pairs):
        if number % 50 == 0:
            before = time.monotonic()
            stop = watch(number, len(pairs))
            until += time.monotonic() - before  # what others do meanwhile is no part of the look
            if stop or time.monotonic() > until:
                found.cut_short = True
                break
        one, other = flat[i], flat[j]
        kinds = {units[one[0]].hardware, units[other[0]].hardware}
        loose = bool(kinds & RAILS and kinds & RIDERS)
        wheeled = "wheel" in kinds
        touch = contact(solids[i], solids[j], one, other, PLAY if loose or wheeled else TOUCH)
        play = max(plays[i], plays[j])
        if (touch is None or not touch.touches) and play > TOUCH and not kinds & RIGID:
            near = contact(solids[i], solids[j], one, other, play)
            if near is not None and near.touches:
                _slides(units, near, solids[i], solids[j], axes, size, found)
        if touch is None:
            continue
        found.contacts.append(touch)
        if not kinds & RIGID:
            _slides(units, touch, solids[i], solids[j], axes, size, found)
    _between_units(units, axes, size, found)
    return found


def _between_units(units, axes, size: float, found: Touching) -> None:
    """Parts of several solids that hold each other by several of them: the legs of a bridge, the runners of a cart."""
    known = {frozenset((s.rail[0], s.rider[0])) for s in found.slides if s.weight >= 0.5}
    groups: dict[tuple[int, int], list] = {}
    for touch in found.contacts:
        if touch.touches:
            a, b = touch.one[0], touch.other[0]
            if a > b:
                touch = type(touch)(touch.other, touch.one, -touch.normals, touch.areas, touch.boxes,
                                    [(k[0], k[1], 1 - k[2], *k[3:]) for k in touch.bores], touch.overlap, touch.gap,
                                    touch.theirs, touch.ours,
                                    [(k[0], k[1], k[2], k[4], k[3]) for k in touch.shafts])  # fmt: skip
                a, b = b, a
            groups.setdefault((a, b), []).append(touch)
    for (a, b), group in groups.items():
        if len(group) > 1 and frozenset((a, b)) not in known and not {units[a].hardware, units[b].hardware} & RIGID:
            names = units[a].hardware, units[b].hardware
            touch = together(group)
            boxes = [Solid(units[n].box) for n in (a, b)]
            options = [_weighed(units, touch, *boxes, names, free, size) for free in freedoms(touch, axes)]
            best = max((s for s in options if s is not None), key=lambda s: s.weight, default=None)
            if best is not None and best.kind != "screw":
                found.slides.append(best)


def _play(solid, hardware: str, size: float) -> float:
    """How far from a bar something may stand that runs on it: makers' models leave a gap where the balls are."""
    if hardware not in ("", "rail") or not shape_of(solid, size)[0]:
        return 0.0
    return max(PLAY, 0.12 * float(np.sort(solid.size)[1]))


def _diagonal(solid) -> float:
    return float(np.linalg.norm(solid.size))


def _slides(units, touch, a, b, axes, size: float, found: Touching) -> None:
    names = units[touch.one[0]].hardware, units[touch.other[0]].hardware
    if "wheel" in names and any(n in ("extrusion", "rail", "shaft", "") for n in names):
        _wheel(units, touch, a, b, names, size, found)
        return
    if not touch.touches:
        if set(names) & RAILS and "block" in names:
            _along_bar(units, touch, a, b, names, size, found, 0.7)
        return
    best = None
    for free in freedoms(touch, axes):
        slide = _weighed(units, touch, a, b, names, free, size)
        if slide is not None and (best is None or slide.weight > best.weight):
            best = slide
    if best is None:
        if set(names) & RAILS and "block" in names:
            _along_bar(units, touch, a, b, names, size, found, 0.75)
        return
    (found.screws if best.kind == "screw" else found.slides).append(best)


def _along_bar(units, touch, a, b, names, size, found, weight: float) -> None:
    """Rail and block by their names, whatever their faces say: along the rail."""
    rail_first = names[0] in RAILS
    rail = a if rail_first else b
    kind, u = shape_of(rail, size)
    if u is None:
        return
    slide = _slide(touch, rail_first, u, weight, "rail-named", a, b)
    if slide is not None and (slide.high - slide.low) < SEAT * slide.length:
        found.slides.append(slide)


def _wheel(units, touch, a, b, names, size, found) -> None:
    bar_first = names[1] == "wheel"
    bar, wheel = (a, b) if bar_first else (b, a)
    lengths = bar.size
    order = np.argsort(lengths)
    if lengths[order[2]] < 2.0 * lengths[order[1]]:
        _on_board(touch, bar_first, bar, wheel, a, b, found)
        return
    if lengths[order[2]] < 3 * _diagonal(wheel):
        return
    slide = _slide(touch, bar_first, np.eye(3)[order[2]], 0.55, "wheels", a, b)
    if slide is not None:
        axis = wheel.axes[int(np.argmax(wheel.radii))] if len(wheel.radii) else None
        if axis is not None and abs(axis @ slide.u) > 0.5:
            return
        slide.weight = 0.85 if names[0 if bar_first else 1] in ("extrusion", "rail") else 0.6
        found.slides.append(slide)


def _on_board(touch, board_first: bool, board, wheel, a, b, found) -> None:
    """A wheel that stands on a board rolls across its axle."""
    if not len(wheel.radii):
        return
    axis = np.abs(wheel.axes[int(np.argmax(wheel.radii))])
    middle = (wheel.box[3:] + wheel.box[:3]) / 2
    away = np.maximum(middle - board.box[3:], board.box[:3] - middle)
    j = int(np.argmax(away))
    radius = float(wheel.size[j]) / 2
    if axis.max() < 0.999 or axis[j] > 0.5 or abs(away[j] - radius) > PLAY:
        return
    u = np.eye(3)[3 - j - int(np.argmax(axis))]
    if float(board.size @ u) < 6 * radius:
        return
    slide = _slide(touch, board_first, u, 0.6, "wheels", a, b)
    if slide is not None:
        found.slides.append(slide)


def _slide(touch, rail_first: bool, u, weight: float, kind: str, a, b, spans=None) -> Slide | None:
    """The slide of b on a (or of a on b) along u.  spans : from where to where each of the two guides, if known."""
    rail, rider = (a, b) if rail_first else (b, a)
    keys = (touch.one, touch.other) if rail_first else (touch.other, touch.one)
    one, other = spans or (a.extent(u), b.extent(u))
    (start, end), (low, high) = (one, other) if rail_first else (other, one)
    if u[np.argmax(np.abs(u))] < 0:
        u, (start, end), (low, high) = -u, (-end, -start), (-high, -low)
    if end - start <= 0 or high <= start or low >= end:
        return None
    return Slide(*keys, u, weight, kind, max(low, start), min(high, end), start, end)


def _spans(touch, u, a, b, names) -> tuple:
    """From where to where along u each of two solids guides: its faces in contact, of a catalogue part all of it.

    Castings and fusions are longer than their ways.
    """
    free = np.abs(touch.normals @ u) <= ALONG if len(touch.areas) else np.zeros(0, bool)
    round_ = [s for s in touch.shafts if abs(s[0] @ u) > 0.999]
    found = []
    for solid, name, boxes, k in ((a, names[0], touch.ours, 3), (b, names[1], touch.theirs, 4)):
        boxes = (
            np.vstack([boxes[free], *(s[k][None] for s in round_)]) if len(boxes) else np.array([s[k] for s in round_])
        )
        if name in RAILS | RIDERS or not len(boxes):
            found.append(solid.extent(u))
            continue
        middle, half = (boxes[:, 3:] + boxes[:, :3]) / 2 @ u, (boxes[:, 3:] - boxes[:, :3]) / 2 @ np.abs(u)
        found.append((float((middle - half).min()), float((middle + half).max())))
    return tuple(found)


def _shafts(touch, free) -> bool:
    """Whether several shafts side by side stand in bores, and more so than faces across bar the way."""
    lines, area = [], 0.0
    for axis, point, radius, ours, theirs in touch.shafts:
        if abs(axis @ free.u) > 0.999:
            across = point - free.u * (point @ free.u)
            shared = np.minimum(ours[3:], theirs[3:]) - np.maximum(ours[:3], theirs[:3])
            area += 3.0 * radius * max(0.0, float(shared @ np.abs(free.u)))
            if all(np.linalg.norm(across - other) > 2 * radius for other in lines):
                lines.append(across)
    return len(lines) >= 2 and free.barred * touch.area < 0.6 * area


def _ways(touch, u, rail_first: bool, size: float) -> bool:
    """Whether the rail's faces in contact are long and narrow along u: ways, even where two of them are far apart."""
    free = np.abs(touch.normals @ u) <= ALONG if len(touch.areas) else np.zeros(0, bool)
    boxes = (touch.ours if rail_first else touch.theirs)[free]
    if len(boxes) < 2:
        return False
    sizes = boxes[:, 3:] - boxes[:, :3]
    lengths = sizes @ np.abs(u)
    widths = (sizes * (1 - np.abs(u))).max(1)
    narrow = (lengths > SLENDER * widths) & (widths < 0.05 * size)
    return int((narrow & (lengths > 0.08 * size)).sum()) >= 2


def _is_round(normals) -> bool:
    """Whether walls are the facets of something round, as in a mesh."""
    kinds: list = []
    for normal in normals:
        if not any(normal @ k > 0.996 for k in kinds):
            kinds.append(normal)
            if len(kinds) > 8:
                return True
    return False


def _undercut(touch, u) -> bool:
    """Whether what slides along u is held down by slanting walls, as in a dovetail."""
    free = np.abs(touch.normals @ u) <= ALONG if len(touch.areas) else np.zeros(0, bool)
    if free.sum() < 2:
        return False
    normals, areas = touch.normals[free], touch.areas[free]
    if _is_round(normals):
        return False
    lean = normals @ normals[int(np.argmax(areas))]
    slant = (lean < -0.15) & (lean > -0.95)
    return bool(slant.any()) and float(areas[slant].sum()) > 0.05 * float(areas.sum())


def _weighed(units, touch, a, b, names, free, size: float) -> Slide | None:
    """The slide that a free direction means, with its weight, or None."""
    spans = _spans(touch, free.u, a, b, names)
    (la, ha), (lb, hb) = spans
    long_first = ha - la >= hb - lb
    rider_first = names[0] in RIDERS and names[1] not in RIDERS
    if names[1] in RIDERS and names[0] not in RIDERS:
        long_first = True
    elif rider_first:
        long_first = False
    elif names[0] in RAILS and names[1] not in RAILS:
        long_first = True
    elif names[1] in RAILS and names[0] not in RAILS:
        long_first = False
    slide = _slide(touch, long_first, free.u, 0.0, "contact", a, b, spans)
    if slide is None:
        return None
    rail, rider = (a, b) if long_first else (b, a)
    rail_name, rider_name = names if long_first else names[::-1]
    cover = (slide.high - slide.low) / slide.length
    bar, along = shape_of(rail, size)
    is_bar = bar and abs(along @ free.u) > 0.99
    if _shafts(touch, free) and not rail_name and not rider_name and cover < SEAT and slide.length > 0.1 * size:
        slide.weight, slide.kind = 0.72, "bore"
        return slide
    if free.barred > 0.25:
        return None
    clear = 1.0 if free.barred < 0.02 else 0.6
    if "screw" in names:
        if rider_name == "nut" and rail_name == "screw":
            slide.weight, slide.kind = 0.35, "screw"
            return slide
        return None
    if rail_name in RAILS and rider_name == "block":
        if cover > SEAT or not (is_bar or slide.length > 2.5 * (slide.high - slide.low)):
            return None
        slide.weight, slide.kind = 0.92 * clear, "rail-named"
        return slide
    if rail_name in RAILS and not rider_name:
        if cover > SEAT or not is_bar:
            return None
        at_end = min(slide.low - slide.start, slide.end - slide.high) < 0.06 * slide.length
        bored = any(abs(k[0] @ free.u) > 0.999 for k in touch.bores)
        if bored and at_end:
            return None
        slide.weight, slide.kind = (0.68 if free.guided else 0.3) * clear * (0.6 if at_end else 1), "rail-named"
        return slide
    if rider_name in ("block",) and not rail_name and free.guided and is_bar and cover < SEAT:
        slide.weight, slide.kind = 0.75 * clear, "rail-shape"
        return slide
    if rail_name or rider_name:
        return None
    if is_bar and cover < SEAT and free.guided and free.walls != 1:
        at_end = min(slide.low - slide.start, slide.end - slide.high) < 0.04 * slide.length
        bored = any(abs(k[0] @ free.u) > 0.999 for k in touch.bores)
        if at_end and bored:
            return None
        slide.weight, slide.kind = 0.72 * clear, "rail-shape"
        return slide
    rider_length = slide.high - slide.low
    room = 1 - rider_length / slide.length
    bored = any(abs(k[0] @ free.u) > 0.999 for k in touch.bores)
    sides = touch.normals[np.abs(touch.normals @ free.u) <= ALONG] if len(touch.areas) else touch.normals
    if not bored and _is_round(sides):  # a shaft in a bore, drawn as facets
        bored = True
    undercut = _undercut(touch, free.u) and not bored
    if undercut and room > 0.1 and free.length > 0.5 * free.width and free.length > 0.03 * size:
        slide.weight, slide.kind = clear * min(0.72, 0.45 + 0.5 * room), "dovetail"
        return slide
    if not free.guided or free.length < 0.03 * size or (touch.bores and free.length < 2 * touch.bores[0][1]):
        return None
    if free.length < 1.2 * free.width and free.length < 0.12 * size and not _ways(touch, free.u, long_first, size):
        return None
    slide.kind = "dovetail" if free.walls >= 3 else "channel"
    slide.weight = clear * min(0.66, 0.25 + 0.6 * max(0.0, room) + 0.06 * min(free.walls, 4))
    if bored:
        slide.kind, slide.weight = "bore", slide.weight * 0.6
    return slide


def grouped(slides: list[Slide], size: float) -> list[Guide]:
    """The guides that slides belong to, the surest first."""
    groups: list[list[Slide]] = []
    for slide in sorted(slides, key=lambda s: -s.weight):
        home = None
        for group in groups:
            if any(_together(slide, other, size) for other in group):
                if home is None:
                    group.append(slide)
                    home = group
                else:
                    home += group
                    group.clear()
        if home is None:
            groups.append([slide])
    made = [Guide(g) for g in groups if g]
    return sorted(made, key=lambda g: -(g.weight + 0.1 * min(1.0, g.length / size)))


def _together(a: Slide, b: Slide, size: float) -> bool:
    if abs(a.u @ b.u) < PARALLEL:
        return False
    if a.rail == b.rail or a.rider == b.rider:
        return True
    if a.rail[0] == b.rail[0] and a.rider[0] == b.rider[0]:
        return True
    if a.kind != b.kind and {a.kind, b.kind} & {"dovetail", "channel", "bore"}:
        return False
    if abs(a.length - b.length) > 0.1 * max(a.length, b.length):
        return False
    shared = min(a.end, b.end) - max(a.start, b.start)
    if shared < 0.85 * min(a.length, b.length):
        return False
    return a.kind in ("rail-named", "rail-shape", "wheels") and a.kind == b.kind
