# SPDX-License-Identifier: LGPL-2.1-or-later
"""Propose a machine for a document: read, look, weigh, and say what is left to ask.  Changes nothing.

The order: parts and joints of the document; faces of its solids; what touches; what slides; bodies by a cut at the
guides, by the joints and by names; bed and chain; directions, letters, travel; confidence; questions.
"""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from itertools import permutations

import numpy as np

from ...core.workspace import Cancelled
from ...messages import Message
from . import bodies as grouping
from . import chain, words
from .chain import Evidence, Link, Reading
from .guides import grouped, touching
from .reading import SMALL, Document, Unit, read

SECONDS = 14.0  # at most, on a busy computer; a machine of two hundred parts takes two or three
LIMIT = 18.0  # by the clock, however many parts there are
ASSUMED_TRAVEL = 100.0  # mm to either side, where nothing says how far
LEAST = 0.3  # confidence below which an axis is asked for


@dataclass(frozen=True)
class Question:
    """One thing that only a person can settle.  name : key of `answers`.  kind : "part", "parts" or "choice".

    choices : (value, Message or text) of a choice.
    """

    name: str
    message: Message
    kind: str = "part"
    choices: tuple = ()


@dataclass
class Axis:
    """A proposed axis.  u : unit vector, document coordinates.  travel : mm.  evidence : the strongest first."""

    name: str
    u: np.ndarray
    travel: tuple[float, float]
    evidence: list[Message]
    confidence: float
    units: list[Unit]
    point: np.ndarray | None = None
    assumed: bool = False
    joint: object = None  # Place of a slider joint of the document
    reverse: bool = False
    rail: Unit | None = None


@dataclass
class Found:
    """What was found.  bodies : "F", axis names, "T", "W" -> parts.  kind : "serial", "parallel" or "unknown".

    complete : a machine can be made of it.  structure : workpiece to tool, such as "YFZX", or None.
    """

    kind: str = "unknown"
    complete: bool = False
    structure: str | None = None
    bodies: dict[str, list[Unit]] = field(default_factory=dict)
    workpiece_chain: list[str] = field(default_factory=list)
    tool_chain: list[str] = field(default_factory=list)
    axes: dict[str, Axis] = field(default_factory=dict)
    questions: list[Question] = field(default_factory=list)
    remarks: list[Message] = field(default_factory=list)
    left_out: list[Unit] = field(default_factory=list)
    reasons: dict[str, list[Message]] = field(default_factory=dict)
    confidence: dict[str, float] = field(default_factory=dict)  # of the bed, and of the sides
    seconds: float = 0.0
    document: Document | None = None
    state: object = None  # for `again`
    up: np.ndarray = field(default_factory=lambda: np.array([0.0, 0.0, 1.0]))
    lathe: bool = False
    made: list[str] = field(default_factory=list)  # names of the objects that `building.build` made of it


@dataclass
class _State:
    """What does not depend on answers, so that an answer is weighed at once."""

    document: Document
    title: str
    axes: np.ndarray
    size: float
    minor: set
    found: object
    guides: list
    said: chain.Words


def propose(doc, selection=(), answers=None, progress=None, seconds: float = SECONDS) -> Found:
    """What a document proposes.  selection : links of what is to be looked at; nothing: the whole document.

    answers : `Question.name` -> what a person said, which is never overruled.  progress(done, all) : called often; a
    true answer stops, and raises Cancelled.  seconds : for the look at shapes; the rest is bounded by it too.
    """
    start = time.monotonic()

    def watch(done, total):
        if progress is not None and progress(done, total):
            raise Cancelled
        return False

    document = read(doc, selection, 0.6 * seconds, lambda n, total: watch(0.5 * n, total))
    state = _look(document, doc.Label, watch, max(start + LIMIT - 1.0, time.monotonic() + 2.0))
    found = weigh(state, answers)
    found.seconds = time.monotonic() - start
    return found


def again(found: Found, answers) -> Found:
    """The same document weighed anew with what a person has said; takes no look at shapes."""
    start = time.monotonic()
    made = weigh(found.state, answers)
    made.seconds = time.monotonic() - start
    return made


def _look(document: Document, title: str, watch, until: float) -> _State:
    units = document.units
    boxes = np.array([u.box for u in units]) if units else np.zeros((1, 6))
    core = _core(boxes)
    size = float(np.linalg.norm(core[3:] - core[:3])) or 1.0
    minor = {n for n, u in enumerate(units) if u.hardware == "fastener" or (len(units) > 8 and u.size < SMALL * size)}
    axes = _axes(units, minor)
    found = touching(document, axes, minor, size, lambda n, total: watch(total + n, 2 * total), until)
    guides = grouped(found.slides, size)
    said = chain.speech(document, title)
    return _State(document, title, axes, size, minor, found, guides, said)


def _core(boxes: np.ndarray) -> np.ndarray:
    """The box around all, single things that stand far away left out."""
    return np.hstack([boxes[:, :3].min(0), boxes[:, 3:].max(0)])


def _axes(units, minor) -> np.ndarray:
    """The three directions that most flat faces look along, as rows; the document's own unless they are clearly not."""
    normals, weights = [], []
    for n, unit in enumerate(units):
        if n in minor:
            continue
        for solid in unit.solids:
            if len(solid.offsets):
                sizes = np.sort(solid.plane_boxes[:, 3:] - solid.plane_boxes[:, :3], axis=1)
                normals.append(solid.planes)
                weights.append(sizes[:, 1] * sizes[:, 2])
    if not normals:
        return np.eye(3)
    normals, weights = np.vstack(normals), np.concatenate(weights) + 1e-6
    straight = np.abs(normals).max(1) > 0.9995
    if weights[straight].sum() > 0.4 * weights.sum():
        return np.eye(3)
    first = _heaviest(normals, weights)
    across = np.abs(normals @ first) < 0.02
    if not across.any():
        return np.eye(3)
    second = _heaviest(normals[across], weights[across])
    second -= first * (second @ first)
    second /= np.linalg.norm(second)
    rows = np.array([first, second, np.cross(first, second)])
    order = max(permutations(range(3)), key=lambda o: sum(abs(rows[o[k]][k]) for k in range(3)))
    rows = rows[list(order)]
    return rows * np.sign(np.diag(rows) + 1e-12)[:, None]


def _heaviest(normals, weights):
    best = max(range(min(len(normals), 200)), key=lambda i: weights[np.abs(normals @ normals[i]) > 0.9995].sum())
    return normals[best] * (1.0 if normals[best][np.argmax(np.abs(normals[best]))] > 0 else -1.0)


# -- weighing --------------------------------------------------------------------------------------------------------
def weigh(state: _State, answers=None) -> Found:
    """What the look at a document means, with the answers of a person."""
    answers = dict(answers or {})
    document, said = state.document, state.said
    made = Found(document=document, state=state)
    if document.sampled:
        made.remarks.append(Message("propose-sampled", count=document.sampled))
    if state.found.cut_short:
        made.remarks.append(Message("propose-cut-short"))
    if len(document.units) < 2:
        made.remarks.append(Message("propose-too-few", count=len(document.units)))
        made.questions.append(Question("parts", Message("propose-ask-parts"), "parts"))
        return made
    common = chain.common_holders(document, state.minor)
    places = {n: chain.place_of(document, n, said, common) for n in range(len(document.units)) if n not in state.minor}
    if _no_serial(state, made, answers):
        return made
    up = _up(state, places, answers)
    made.up, made.lathe = up, said.lathe
    reading = _as_told(state, _best(state, places, up, answers), answers)
    if reading is None:
        _named_bodies(made, state, places)
        _ask_bodies(made, state)
        return made
    chain.direct(document, reading, places, state.axes, up, said, state.found.slides, state.size)
    _lead(state, reading, places, up, made, answers)
    return made


def _no_serial(state: _State, made: Found, answers) -> bool:
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


def _askew(state: _State) -> int:
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


def _towers(state: _State) -> int:
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


def _up(state: _State, places, answers) -> np.ndarray:
    """The upright direction: the document's z, unless the names of Z parts or the spindle say otherwise."""
    document, axes = state.document, state.axes
    score = np.array([0.9 * abs(a[2]) for a in axes])
    for guide in state.guides:
        letters = {places[n][1] for n in guide.riders if n in places} - {""}
        roles = {places[n][0] for n in guide.riders if n in places}
        if guide.weight > 0.5 and (letters == {"Z"} or roles & {"quill", "knee"}) and not state.said.lathe:
            score += np.abs(axes @ guide.u) * 0.8 * (np.abs(axes @ guide.u) > 0.9)
    for name in "XYZ":
        body = [n for n, (_, letter) in places.items() if letter == name]
        if body and len(body) < 0.5 * len(places):
            for e in chain._inner_guides(document, [], body, axes, state.size):
                hit = np.abs(axes @ e.u) > 0.9
                score += (0.9 if name == "Z" else -0.6) * hit * e.weight * 2
    if not state.said.lathe:
        for n, (role, _) in places.items():
            unit = document.units[n]
            if role == "tool":
                for solid in unit.solids[:5]:
                    if len(solid.radii):
                        weight = solid.radii * np.linalg.norm(
                            solid.round_boxes[:, 3:] - solid.round_boxes[:, :3], axis=1
                        )
                        share = np.array([weight[np.abs(solid.axes @ a) > 0.99].sum() for a in axes])
                        if share.sum() > 0:
                            score += 0.5 * share / share.sum() / max(1, min(5, len(unit.solids)))
                break
    k = int(np.argmax(score))
    up = axes[k]
    return up if up[np.argmax(np.abs(up))] > 0 else -up


# -- readings --------------------------------------------------------------------------------------------------------
def _best(state: _State, places, up, answers) -> Reading | None:
    joints = _by_joints(state, places, up, answers)
    if joints is not None and len(joints.links) >= 2:
        return joints
    guides = _by_guides(state, places, up, answers)
    names = chain.by_names(state.document, state.found, places, state.minor, state.size, state.said, up, answers)
    options = [r for r in (joints, guides, names) if r is not None and r.links]
    if not options:
        return None

    def value(r: Reading) -> float:
        count = min(3, len(r.links))
        if r.source == "guides":
            sure = sum(max((g.weight for g in k.guides), default=0.0) for k in r.links[:3])
            return sure + 0.1 * count
        if r.source == "joints":
            return 1.0 * count
        return 0.62 * count - (0.4 if len(r.links) > 3 else 0.0)

    return max(options, key=value)


def _pins(document: Document, answers, name: str) -> set[int]:
    """Numbers of the units that an answer names: units, keys, labels or links."""
    value = answers.get(name)
    if value is None:
        return set()
    from ..paths import place

    found: set[int] = set()
    items = [value] if isinstance(value, str) or not isinstance(value, (list, set)) else value
    for item in items:
        if isinstance(item, Unit):
            found |= {n for n, u in enumerate(document.units) if u.key == item.key}
        elif isinstance(item, str):
            found |= {n for n, u in enumerate(document.units) if u.label == item}
        else:
            where = place(item)
            key = where.key if where is not None else ()
            for n, unit in enumerate(document.units):
                own = document.apart[unit.key].key if unit.key in document.apart else unit.where.key
                if key and (own[: len(key)] == key or key[: len(own)] == own):
                    found.add(n)
    return found


def _forced(state: _State, answers) -> list[tuple[set[int], str]]:
    """(units, body) that a person has given: "body:X" -> parts."""
    return [(_pins(state.document, answers, k), k[5:]) for k in answers if k.startswith("body:")]


def _by_guides(state: _State, places, up, answers) -> Reading | None:
    document = state.document
    used_graph = grouping.graph(document, state.found, state.guides, state.minor, state.size)
    for units, _ in _forced(state, answers):
        numbers = sorted(units)
        for a, b in zip(numbers, numbers[1:]):
            used_graph.add(a, b, 50.0)
    used = grouping.separate(document, used_graph, state.guides)
    numbers = [n for n in range(len(document.units)) if n not in state.minor]
    parts = grouping.components(used_graph, numbers)
    _gather(parts, used)
    _join_islands(document, parts, used, state.found)
    owner = {n: b for b, body in enumerate(parts) for n in body}
    edges: dict[tuple[int, int], Link] = {}
    for guide in used:
        rail = _most([owner[n] for n in guide.rails if n in owner])
        for rider in {owner[n] for n in guide.riders if n in owner}:
            if rider == rail:
                continue
            pair = (min(rail, rider), max(rail, rider))
            link = edges.setdefault(pair, Link(*pair))
            if not link.guides or abs(link.guides[0].u @ guide.u) > 0.99:
                link.guides.append(guide)
                link.evidence.append(chain._guide_evidence(document, guide))
    if not edges:
        return None
    keep = [any(b in pair for pair in edges) for b in range(len(parts))]
    far = grouping.adopt(document, parts, keep, state.found, state.minor, state.size)
    return _rooted(state, parts, edges, places, up, answers, "guides", far)


def _gather(parts: list[set[int]], used) -> None:
    """A block or nut that nothing else touches goes with what runs next to it on the same guide."""
    busy: dict[int, int] = {}
    for guide in used:
        for n in guide.rails | guide.riders:
            busy[n] = busy.get(n, 0) + 1
    for guide in used:
        riders = [b for b, body in enumerate(parts) if body & guide.riders]
        lone = [b for b in riders if parts[b] <= guide.riders and all(busy[n] == 1 for n in parts[b])]
        if len(riders) < 2 or not lone:
            continue
        homes = [b for b in riders if b not in lone] or lone[:1]
        for b in lone:
            if b in homes:
                continue
            low, high = _span(guide, parts[b])

            def away(home, low=low, high=high, guide=guide):
                start, end = _span(guide, parts[home])
                return max(start - high, low - end, 0.0)

            home = min(homes, key=away)
            parts[home] |= parts[b]
            parts[b] = set()
    parts[:] = [body for body in parts if body]


def _join_islands(document: Document, parts: list[set[int]], used, found) -> None:
    """Castings that stand in one another without a common face: the bodies that overlap most are one."""
    for _ in range(12):
        owner = {n: b for b, body in enumerate(parts) for n in body}
        links = grouping.Graph()
        for guide in used:
            rail = _most([owner[n] for n in guide.rails if n in owner])
            for rider in {owner[n] for n in guide.riders if n in owner}:
                links.add(rail, rider, 1.0)
        island = {}
        for b in list(links.edges):
            if b not in island:
                for c in links.reach([b]):
                    island[c] = b
        best = None
        for touch in found.contacts:
            a, b = owner.get(touch.one[0]), owner.get(touch.other[0])
            if a is None or b is None or island.get(a) == island.get(b) or a not in island or b not in island:
                continue
            one, other = document.units[touch.one[0]], document.units[touch.other[0]]
            if {one.hardware, other.hardware} & {"loose", "fastener", "screw"}:
                continue
            score = touch.overlap * min(one.size, other.size) + touch.area**0.5
            if best is None or score > best[0]:
                best = (score, a, b)
        if best is None:
            return
        _, a, b = best
        parts[a] |= parts[b]
        parts[b] = set()
    parts[:] = [body for body in parts if body]


def _span(guide, body) -> tuple[float, float]:
    slides = [s for s in guide.slides if s.rider[0] in body]
    return min(s.low for s in slides), max(s.high for s in slides)


def _most(values):
    return max(set(values), key=values.count)


def _rooted(state, parts, edges, places, up, answers, source, far) -> Reading | None:
    document = state.document
    inside = sorted({b for pair in edges for b in pair})
    scores = chain.bed_scores(document, parts, places_all(document, places), up, state.said,
                              _pins(document, answers, "bed") | _pins(document, answers, "body:F"))  # fmt: skip
    degree = {b: sum(b in pair for pair in edges) for b in inside}
    ranked = sorted(inside, key=lambda b: -(scores[b] + 0.15 * min(2, degree[b])))
    bed = ranked[0]
    links, again = chain.tree(parts, edges, bed)
    reading = Reading(parts, bed, links, source, far)
    reading.bed_sure = min(0.95, 0.5 + 0.4 * (scores[bed] - scores[ranked[1]])) if len(ranked) > 1 else 0.5
    reached = {bed, *(k.outer for k in links)}
    for b in range(len(parts)):  # islands with guides of their own, and what nothing reaches, stand on the bed
        if b not in reached and parts[b]:
            reading.merged.append((b, bed))
            parts[bed] |= parts[b]
            parts[b] = set()
    _prune(state, reading, places, answers)
    return reading


def places_all(document, places):
    """Return a place for every unit: that given, or ("", "")."""
    return {n: places.get(n, ("", "")) for n in range(len(document.units))}


def _prune(state: _State, reading: Reading, places, answers) -> None:
    """At most three links in at most two branches: what else slides (a tailstock, a door) goes to what carries it."""
    tools = {n for n, (role, _) in places.items() if role in ("tool", "toolpost", "quill")} | _pins(
        state.document, answers, "tool")  # fmt: skip

    def depth(link):
        below = [k for k in reading.links if k.inner == link.outer]
        return 1 + max((depth(k) for k in below), default=0)

    def worth(link):
        body, below = set(reading.bodies[link.outer]), [link]
        for k in below:
            body |= reading.bodies[k.outer]
            below += [n for n in reading.links if n.inner == k.outer]
        roles = chain._roles(places, state.document.units, body)
        value = depth(link) + 0.8 * bool(body & tools) + 0.3 * bool(roles & words.MOVING)
        value += 0.4 * bool({places.get(n, ("", ""))[1] for n in body} - {""})
        value -= 2.0 * bool(roles & {"tailstock"}) * (not body & tools)
        return value + 0.3 * max((e.weight for e in link.evidence), default=0)

    for _ in range(30):
        outer = {}
        for link in reading.links:
            outer.setdefault(link.inner, []).append(link)
        crowded = [(b, ks) for b, ks in outer.items() if len(ks) > (2 if b == reading.bed else 1)]
        tails = [
            k
            for k in reading.links
            if "tailstock" in chain._roles(places, state.document.units, reading.bodies[k.outer])
            and not reading.bodies[k.outer] & tools
        ]
        over = [k for k in reading.links if depth(k) == 1] if len(reading.links) > 3 else []
        if tails:
            drop = tails[0]
        elif crowded:
            drop = min(crowded[0][1], key=worth)
        elif over:
            drop = min(over, key=worth)
        else:
            return
        _swallow(reading, drop)


def _swallow(reading: Reading, link: Link) -> None:
    """What moves along a link belongs to what carries it."""
    for below in [k for k in reading.links if k.inner == link.outer]:
        _swallow(reading, below)
    reading.bodies[link.inner] |= reading.bodies[link.outer]
    reading.bodies[link.outer] = set()
    reading.links.remove(link)
    reading.merged.append((link.outer, link.inner))


def _by_joints(state: _State, places, up, answers) -> Reading | None:
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
    return _rooted(state, parts, edges, places, up, answers, "joints", far)


def _as_told(state: _State, reading: Reading | None, answers) -> Reading | None:
    """The reading with the bodies that a person has given: `body:X` -> parts that move as axis X."""
    document = state.document
    told = [(name[5:], _pins(document, answers, name)) for name in answers if name.startswith("body:")]
    told = [(letter, units) for letter, units in told if letter in "XYZ" and units]
    if not told:
        return reading
    if reading is None:
        reading = Reading([set(range(len(document.units)))], 0, [], "person")
    new = []
    for letter, units in told:
        home = _most([reading.body_of(n) for n in sorted(units) if reading.body_of(n) is not None] or [reading.bed])
        link = next((k for k in reading.links if k.outer == home), None)
        bulk = sum(document.units[n].bulk for n in units & reading.bodies[home])
        whole = sum(document.units[n].bulk for n in reading.bodies[home])
        if link is None or link.told_letter or (len(reading.links) < 3 and bulk < 0.5 * whole):
            link = Link(home, len(reading.bodies))  # a body of its own, carried by what it was taken for
            reading.bodies.append(set())
            reading.links.append(link)
            new.append(link)
        for body in reading.bodies:
            body -= units
        reading.bodies[link.outer] |= units
        link.told_letter = letter
        link.evidence.append(Evidence("propose-evidence-person", 0.9))
    reading.links = [k for k in reading.links if reading.bodies[k.outer]]
    _nest(state, reading, [k for k in new if k in reading.links])
    return reading


def _nest(state: _State, reading: Reading, new: list[Link]) -> None:
    """Bodies that a person took out of one body carry each other where they touch, from that body outwards."""
    owner = {n: b for b, body in enumerate(reading.bodies) for n in body}
    areas: dict[tuple[int, int], float] = {}
    for touch in state.found.contacts:
        pair = owner.get(touch.one[0]), owner.get(touch.other[0])
        if None not in pair:
            for a, b in (pair, pair[::-1]):
                areas[a, b] = areas.get((a, b), 0.0) + touch.area + 1.0
    waiting = list(new)
    while waiting:
        outside = {k.outer for k in waiting}
        ready = [k.inner for k in waiting if k.inner not in outside]
        reached = {*ready, *(k.outer for k in new if k not in waiting)} or {reading.bed}
        link, inner = max(
            ((k, b) for k in waiting for b in reached), key=lambda kb: areas.get((kb[0].outer, kb[1]), 0.0)
        )
        if areas.get((link.outer, inner)):
            link.inner = inner
        waiting.remove(link)


# -- from links to a machine -----------------------------------------------------------------------------------------
def _lead(state: _State, reading: Reading, places, up, made: Found, answers) -> None:
    document = state.document
    made.kind = "serial"
    links = [k for k in reading.links if k.confidence >= LEAST or k.told_letter]
    weak = [k for k in reading.links if k not in links]
    for link in sorted(weak, key=lambda k: -_depth(reading, k)):
        if any(k.inner == link.outer for k in reading.links):
            links.append(link)
        else:
            made.remarks.append(Message("propose-weak", part=_label(document, reading.bodies[link.outer])))
            _swallow(reading, link)
    links = [k for k in reading.links if k in links]
    if not links:
        _ask_bodies(made, state)
        return
    _call(state, reading, links, places, up)
    told = [k for k in links if f"direction:{k.letter}" in answers]
    if told:
        for link in told:
            link.told = np.array(answers[f"direction:{link.letter}"], float)
        chain.direct(document, reading, places, state.axes, up, state.said, state.found.slides, state.size)
    branches = _branches(links, reading.bed)
    work, tool, sure = _sides(state, reading, branches, places, up, answers)
    for n in reading.far:
        made.left_out.append(document.units[n])
    made.workpiece_chain = [k.letter for k in work]
    made.tool_chain = [k.letter for k in tool]
    made.structure = "".join(reversed(made.workpiece_chain)) + "F" + "".join(made.tool_chain)
    made.bodies["F"] = [document.units[n] for n in sorted(reading.bodies[reading.bed])]
    made.confidence = {"bed": reading.bed_sure, "sides": sure}
    made.reasons["F"] = [_bed_reason(state, reading, places)]
    for branch, on_work in ((work, True), (tool, False)):
        for link in branch:
            made.axes[link.letter] = _axis(state, reading, link, on_work, made, answers)
            made.bodies[link.letter] = [document.units[n] for n in sorted(reading.bodies[link.outer])]
    _ends(state, reading, work, tool, places, made)
    whole = reading.bed_sure * 0.5 + 0.5
    agree = _agreement(state, reading, places, tool, work)
    for axis in made.axes.values():
        value = axis.confidence * (0.75 + 0.25 * whole) * (0.85 + 0.15 * sure)
        if reading.source == "names":
            value = min(value, 0.72)
        elif reading.source == "guides":
            value = min(value, 0.9 if agree else 0.78)
        if len(made.axes) < 2 or (len(made.axes) == 2 and not state.said.lathe):
            value = min(value, 0.7)
        axis.confidence = round(float(value), 3)
    disputed = _disputed(document, places, made)
    if disputed:
        made.remarks.append(Message("propose-disagree", parts=", ".join(disputed[:3]) + (" …" if disputed[3:] else "")))
    if state.said.rotary:
        made.remarks.append(Message("propose-rotary", parts=", ".join(state.said.rotary)))
    made.complete = bool(made.axes) and (len(made.axes) == 3 or (state.said.lathe and len(made.axes) == 2))
    if answers.get("enough"):
        made.complete = True
    _ask(state, reading, made, sure, answers)


def _depth(reading, link) -> int:
    before = next((k for k in reading.links if k.outer == link.inner), None)
    return 1 + (_depth(reading, before) if before is not None else 0)


def _label(document: Document, body) -> str:
    if not body:
        return ""
    return document.units[max(body, key=lambda n: document.units[n].bulk)].label


def _branches(links, bed) -> list[list[Link]]:
    branches = []
    for first in [k for k in links if k.inner == bed]:
        branch = [first]
        while (more := next((k for k in links if k.inner == branch[-1].outer), None)) is not None:
            branch.append(more)
        branches.append(branch)
    return branches[:2]


def _call(state: _State, reading: Reading, links, places, up) -> None:
    """X, Y, Z for each link: as names say, else by direction (on a lathe along and across the spindle)."""
    stated = [_stated(state, link, reading, places) for link in links]
    named = [a for a in stated if a]
    if len(set(named)) == len(named) == len(links) and not any(k.told_letter for k in links):
        for link, letter in zip(links, stated):
            link.letter = letter
        return
    cost = {}
    z = _spindle(state, places) if state.said.lathe else up
    z = up if z is None else z
    level = [a for a in state.axes if abs(a @ z) < 0.5]
    level.sort(key=lambda a: -abs(a[0]) - 0.1 * abs(a[1]))
    target = {"Z": z, "X": level[0], "Y": level[1] if len(level) > 1 else np.cross(z, level[0])}
    if state.said.lathe and len(links) == 2:
        across = next((k.u for k in links if abs(k.u @ z) < 0.5), level[0])
        target["X"], target["Y"] = across, np.cross(z, across)
    for i, link in enumerate(links):
        for letter in "XYZ":
            cost[i, letter] = abs(link.u @ target[letter]) + (
                0.8 if stated[i] == letter and named.count(letter) == 1 else 0.0
            )
    for i, link in enumerate(links):
        if link.told_letter:
            cost[i, link.told_letter] += 9.0
    best = max(permutations("XYZ", len(links)), key=lambda o: sum(cost[i, a] for i, a in enumerate(o)))
    for link, letter in zip(links, best):
        link.letter = letter


def _stated(state: _State, link: Link, reading: Reading, places) -> str:
    """The letter that the joint's name, or most of the moving body's names, state."""
    if link.bond is not None and words.letter(link.bond.label):
        return words.letter(link.bond.label)
    votes: dict[str, float] = {}
    for n in reading.bodies[link.outer]:
        letter = places.get(n, ("", ""))[1]
        if letter:
            votes[letter] = votes.get(letter, 0.0) + state.document.units[n].bulk
    best = max(votes, key=votes.get, default="")
    return best if best and votes[best] > 0.7 * sum(votes.values()) else ""


def _spindle(state: _State, places):
    """The direction of a lathe's spindle: that of the largest cylinders of what is called spindle, chuck or head."""
    share = np.zeros(3)
    for n, (role, _) in places.items():
        unit = state.document.units[n]
        if role == "headstock" or words.role(unit.label) in ("tool", "chuck", "headstock"):
            for solid in unit.solids[:5]:
                if len(solid.radii):
                    weight = solid.radii * np.linalg.norm(solid.round_boxes[:, 3:] - solid.round_boxes[:, :3], axis=1)
                    share += [weight[np.abs(solid.axes @ a) > 0.99].sum() for a in state.axes]
    return state.axes[int(np.argmax(share))] if share.sum() > 0 else None


def _sides(state: _State, reading: Reading, branches, places, up, answers):
    """(workpiece side, tool side, how sure): by a person, by names, by where the upright axis is."""
    branches = [*branches, *[[] for _ in range(2 - len(branches))]]
    document = state.document

    def bodies(branch):
        return set().union(*[reading.bodies[k.outer] for k in branch]) if branch else set()

    tool, work = _pins(document, answers, "tool"), _pins(document, answers, "work")
    for pinned, order in ((tool, 1), (work, 0)):
        if pinned:
            hit = 0 if bodies(branches[0]) & pinned else 1
            first, second = branches[hit], branches[1 - hit]
            return (second, first, 1.0) if order else (first, second, 1.0)

    def score(branch):
        body = bodies(branch)
        roles = chain._roles(places, document.units, body)
        own = {words.role(document.units[n].label) for n in body}
        value = (
            1.0 * bool(roles & {"tool", "toolpost", "quill"})
            + 0.4 * bool(own & {"tool"})
            + 0.5 * bool(roles & {"gantry"})
        )
        value -= 1.0 * bool(roles & {"work", "table", "knee"}) + (0.5 if not state.said.lathe else 0.0) * bool(
            roles & {"saddle"}
        )
        value += 0.35 * any(abs(k.u @ up) > 0.9 for k in branch) * (not state.said.lathe)
        return value

    one, two = score(branches[0]), score(branches[1])
    if not branches[1]:
        standing = chain._roles(places, document.units, reading.bodies[reading.bed])
        one -= 0.5 * bool(standing & {"tool", "quill", "toolpost"}) - 0.2
        if one >= -0.2 or (len(branches[0]) > 2 and one >= -0.5):
            return [], branches[0], 0.9 if one > 0.5 else 0.6
        return branches[0], [], 0.85 if one < -0.7 else 0.6
    sure = min(1.0, 0.5 + 0.4 * abs(one - two))
    if one == two:
        tops = [max((document.units[n].extent(up)[1] for n in bodies(b)), default=0.0) for b in branches]
        one, two = tops
    return (branches[1], branches[0], sure) if one > two else (branches[0], branches[1], sure)


def _bed_reason(state: _State, reading: Reading, places) -> Message:
    document, body = state.document, reading.bodies[reading.bed]
    if document.grounded & body:
        return Message("propose-bed-grounded", part=document.units[min(document.grounded & body)].label)
    named = [n for n in body if places.get(n, ("", ""))[0] in words.FIXED]
    if named:
        return Message("propose-bed-name", part=document.units[max(named, key=lambda n: document.units[n].bulk)].label,
                       count=len(body))  # fmt: skip
    return Message("propose-bed-shape", count=len(body))


def _disputed(document: Document, places, made: Found) -> list[str]:
    """Labels of parts whose names state another axis than the one that they move with."""
    body = {u.key: name for name, units in made.bodies.items() for u in units}
    labels = []
    for n, (_, letter) in places.items():
        unit = document.units[n]
        got = body.get(unit.key)
        if letter and not unit.hardware and got in ("F", *"XYZ") and got != letter and letter in made.axes:
            labels.append(repr(unit.label))
    return labels


def _agreement(state: _State, reading: Reading, places, tool, work) -> bool:
    """Whether names say the same as the guides: what is called fixed stands, what is called moving moves."""
    units = state.document.units
    moved = set().union(*[reading.bodies[k.outer] for k in reading.links]) if reading.links else set()
    wrong = right = 0.0
    for n, (role, letter) in places.items():
        if units[n].hardware:
            continue
        moving = role in words.MOVING or bool(letter)
        if role in words.FIXED or moving:
            fits = (n in moved) == moving
            right, wrong = right + fits * units[n].bulk, wrong + (not fits) * units[n].bulk
    ends = reading.bodies[tool[-1].outer] if tool else reading.bodies[reading.bed]
    tools = [n for n, (role, _) in places.items() if role in ("tool", "toolpost")]
    if tools and not any(n in ends for n in tools):
        return False
    return right > 0 and wrong <= 0.15 * right


def _axis(state: _State, reading: Reading, link: Link, on_work: bool, made: Found, answers) -> Axis:
    document = state.document
    u = np.array(link.u, float)
    u = u if u[np.argmax(np.abs(u))] > 0 else -u
    spoken = [Message(e.code, **e.fields) for e in sorted(link.evidence, key=lambda e: -e.weight) if e.weight > 0.05]
    messages = list(dict.fromkeys(spoken))[:6]
    if not messages:
        messages = [Message("propose-evidence-order")]
    travel, point, assumed, why = _travel(state, reading, link, u, on_work)
    messages.append(why)
    rail = None
    slides = [s for g in link.guides for s in g.slides] or [s for s in link.slides if abs(s.u @ u) > 0.99]
    if slides:
        rail = document.units[max(slides, key=lambda s: (s.weight, s.length)).rail[0]]
    made_axis = Axis(link.letter, u, travel, messages, link.confidence, [], point, assumed, rail=rail)
    if link.bond is not None:
        made_axis.joint = link.bond.joint
        made_axis.reverse = float(link.bond.u @ u) < 0
    stated = answers.get(f"travel:{link.letter}")
    if stated is not None:
        made_axis.travel, made_axis.assumed = (float(stated[0]), float(stated[1])), False
    return made_axis


def _travel(state: _State, reading: Reading, link: Link, u, on_work: bool):
    """((low, high), reference point, whether assumed, in words): as far as what slides stays on what it slides on."""
    document = state.document
    outer = reading.bodies[link.outer]
    sense = -1.0 if on_work else 1.0
    if link.bond is not None:
        limits = link.bond.limits
        direction = float(np.sign(link.bond.u @ u) or 1.0) * (1.0 if link.bond.other in outer else -1.0) * sense
        stands = link.bond.stands * direction
        if limits is not None:
            low, high = sorted(direction * v for v in limits)
            return (low, high), None, False, Message("propose-travel-joint", part=link.bond.label)
        return (stands - ASSUMED_TRAVEL, stands + ASSUMED_TRAVEL), None, True, Message("propose-travel-assumed")
    slides = [s for g in link.guides for s in g.slides if g.weight >= 0.5] or [
        s for s in link.slides if abs(s.u @ u) > 0.99 and s.weight > 0.2]  # fmt: skip
    rails: dict[tuple, list] = {}
    for s in slides:
        if s.rail[0] in outer or s.rider[0] in outer:
            rails.setdefault(s.rail, []).append(s)
    before, after, boxes = [], [], []
    for rail, group in rails.items():
        down = min(s.low for s in group) - group[0].start
        ahead = group[0].end - max(s.high for s in group)
        if rail[0] in outer:  # the rail is what moves
            down, ahead = ahead, down
        if group[0].u @ u < 0:
            down, ahead = ahead, down
        before.append(down)
        after.append(ahead)
        boxes += [document.units[s.rider[0]].solids[s.rider[1]].box for s in group]
    point = None
    if boxes:
        boxes = np.array(boxes)
        point = (boxes[:, :3].min(0) + boxes[:, 3:].max(0)) / 2
    if before and min(before) + min(after) > 1.0:
        low, high = -min(before), min(after)
        ends = (low, high) if not on_work else (-high, -low)
        return (ends[0] + 0.0, ends[1] + 0.0), point, False, Message("propose-travel-guide", length=ends[1] - ends[0])
    inner = reading.bodies[link.inner]
    lows = [min(document.units[n].extent(u)[0] for n in b) for b in (inner, outer)]
    highs = [max(document.units[n].extent(u)[1] for n in b) for b in (inner, outer)]
    down, ahead = lows[1] - lows[0], highs[0] - highs[1]
    if down >= 0 and ahead >= 0 and down + ahead > 5:
        ends = (-down, ahead) if not on_work else (-ahead, down)
        return (ends[0] + 0.0, ends[1] + 0.0), point, True, Message("propose-travel-gap", length=down + ahead)
    return (-ASSUMED_TRAVEL, ASSUMED_TRAVEL), point, True, Message("propose-travel-assumed")


def _ends(state: _State, reading: Reading, work, tool, places, made: Found) -> None:
    """Spindle and workpiece out of the last bodies, where their names say so."""
    document = state.document
    for name, branch, roles in (("T", tool, {"tool", "toolpost"}), ("W", work, {"work"})):
        if state.said.lathe and name == "W":
            roles = {"chuck", "work"}
        last = branch[-1].letter if branch else "F"
        body = reading.bodies[branch[-1].outer] if branch else reading.bodies[reading.bed]
        own = [n for n in sorted(body) if not document.units[n].hardware and (
            words.role(document.units[n].label) in roles or places.get(n, ("", ""))[0] in roles)]  # fmt: skip
        if own and len(own) < len(body):
            made.bodies[name] = [document.units[n] for n in own]
            made.bodies[last] = [u for u in made.bodies[last] if u not in made.bodies[name]]


def _named_bodies(made: Found, state: _State, places) -> None:
    """Where nothing shows what slides: the parts whose names say what they are."""
    for n, (role, letter) in places.items():
        body = letter or {"tool": "T", "work": "W"}.get(role, "F" if role in words.FIXED else "")
        if body:
            made.bodies.setdefault(body, []).append(state.document.units[n])


# -- questions -------------------------------------------------------------------------------------------------------
def _ask_bodies(made: Found, state: _State) -> None:
    made.remarks.append(Message("propose-nothing-slides"))
    made.questions.append(Question("bed", Message("propose-ask-bed")))
    for name in "XYZ":
        made.questions.append(Question(f"body:{name}", Message("propose-ask-moves", axis=name), "parts"))


def _ask(state: _State, reading: Reading, made: Found, sure: float, answers) -> None:
    """What is left, the most important first; one is asked at a time."""

    def ask(name: str, message: Message, kind: str = "part", choices: tuple = ()) -> None:
        if name not in answers:
            made.questions.append(Question(name, message, kind, choices))

    if reading.bed_sure < 0.6 and "body:F" not in answers:
        ask("bed", Message("propose-ask-bed-is", part=_label(state.document, reading.bodies[reading.bed])))
    missing = [a for a in "XYZ" if a not in made.axes]
    if len(made.axes) < 3 and not (state.said.lathe and len(made.axes) == 2) and not answers.get("enough"):
        used = [g for k in reading.links for g in k.guides]
        spare = next((g for g in state.guides if g not in used and g.weight > 0.3), None)
        message = Message("propose-ask-moves", axis=missing[0])
        if spare is not None:
            label = state.document.units[min(spare.rails)].label
            message = Message("propose-ask-rails", part=label, axis=missing[0])
        ask(f"body:{missing[0]}", message, "parts")
        choices = ((True, Message("propose-choice-yes")), (False, Message("propose-choice-no")))
        ask("enough", Message("propose-ask-enough", axes=", ".join(sorted(made.axes))), "choice", choices)
    if sure < 0.65 and "work" not in answers:
        ask("tool", Message("propose-ask-tool"))
    along = tuple((tuple(float(v) for v in a), Message("propose-choice-along", vector=_along(a))) for a in state.axes)
    for name, axis in made.axes.items():
        if axis.confidence < 0.5:
            label = max(made.bodies[name], key=lambda u: u.bulk).label
            ask(f"direction:{name}", Message("propose-ask-direction", part=label, axis=name), "choice", along)
        if axis.assumed and axis.joint is None:
            low, high = axis.travel
            ask(f"travel:{name}", Message("propose-ask-travel", axis=name, low=low, high=high), "travel")


def _along(a) -> str:
    return "(" + ", ".join(f"{v + 0.0:.3g}" for v in a) + ")"
