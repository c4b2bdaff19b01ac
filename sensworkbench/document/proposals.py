# SPDX-License-Identifier: LGPL-2.1-or-later
"""A machine proposed from plain geometry, for assemblies without sliders and machines that came as STEP files.

Rails and screws give the directions, what slides on them gives the bodies and their order, names decide where geometry
cannot.  A proposal changes nothing; `machine_from_parts` makes the machine of it, and everything can be changed then.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import permutations

import FreeCAD as App
import Part

from ..core.errors import AXES
from ..core.refusal import Refused
from . import contacts, curves, factory
from .contacts import Guide, Piece
from .imported import apart, is_one_lump, pieces_of, split, whole_containers  # noqa: F401 - part of this module's face
from .part_names import TOOL_POINT, WORKPIECE_SIDE, guess
from .paths import Place, _is_datum, place

NEAR = 5.0  # mm: what stands this close to a body, and slides on nothing, belongs to it
ASSUMED_TRAVEL = 100.0  # mm to either side, where no rail says how far
UNIT = {name: App.Vector(*[float(k == i) for k in range(3)]) for i, name in enumerate(AXES)}


@dataclass
class AxisProposal:
    """A direction in which something may move.  source : (object, path with element) for `make_axis(direction=...)`.

    direction : unit vector, document coordinates.  axis : the letter that fits best.  length : of its guide, mm.
    score : the lengths of all guides in this direction, mm.  why : in words.
    """

    axis: str
    direction: App.Vector
    source: tuple
    reverse: bool
    length: float
    score: float
    why: str


@dataclass
class MachineProposal:
    """Parts of the bed ("F") and of each carriage, chains from the bed outwards, axes, travels in mm, and points.

    T and W have parts where names tell spindle and workpiece.  notes : what is uncertain.
    """

    parts: dict[str, list[Place]]
    workpiece_chain: list[str]
    tool_chain: list[str]
    axes: dict[str, AxisProposal]
    travel: dict[str, tuple[float, float]]
    tool_point: tuple | None
    left_out: list[Place] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    references: dict[str, App.Vector] = field(default_factory=dict)  # mm, document coordinates
    reasons: dict[str, str] = field(default_factory=dict)  # body ("F", "X" ...) or "tool point": why, in words
    directions: list[AxisProposal] = field(default_factory=list)  # all that were found, best first


# -- axes ------------------------------------------------------------------------------------------------------------
def propose_axes(objects) -> list[AxisProposal]:
    """Directions of motion that the geometry of the objects suggests, best first.

    From rails and screws; where there are fewer than three directions, from the longest straight edges.  At most one
    proposal per direction; X, Y and Z are given to the three best that are not parallel.
    """
    return _axes(pieces_of(objects), None)


def _axes(pieces: list[Piece], found: list[Guide] | None) -> list[AxisProposal]:
    if not pieces:
        raise Refused("proposal-no-solids", "selection")
    found = contacts.guides(pieces) if found is None else found
    clusters: list[list] = []  # [direction, score, longest, piece, why]
    for guide in found:
        _count(clusters, guide.direction, guide.length, guide.length, guide.piece, guide.kind, pieces)
    if len(clusters) < 3:
        for p, piece in enumerate(pieces):
            for solid in piece.solids:
                edge = contacts.longest_edge(solid)
                if edge is not None:
                    u = contacts._along(edge)
                    _count(clusters, u, 1e-3 * edge.Length, edge.Length, p, "longest edge", pieces)
    clusters.sort(key=lambda c: -c[1])
    letters = _letters([c[0] for c in clusters[:3]])
    proposals = []
    for cluster, letter in zip(clusters, letters + [""] * len(clusters)):
        u, score, length, p, why = cluster
        source, reverse = _source(pieces[p], u)
        proposals.append(AxisProposal(letter, u, source, reverse, length, score, f"{why} {pieces[p].label!r}"))
    return proposals


def _count(clusters, u, score, length, p, why, pieces) -> None:
    for cluster in clusters:
        if cluster[0].cross(u).Length < contacts.PARALLEL:
            cluster[1] += score
            return
    clusters.append([u, score, length, p, why])


def _letters(directions) -> list[str]:
    """X, Y, Z for up to three directions, each as near to its document axis as can be."""
    best = max(
        permutations(AXES, len(directions)),
        key=lambda order: sum(abs(u.dot(UNIT[a])) for u, a in zip(directions, order)),
    )
    return list(best)


def _source(piece: Piece, u: App.Vector) -> tuple[tuple, bool]:
    """(link to an edge or cylinder of the piece along u, whether it has to be reversed)."""
    shape = piece.where.shape()
    edges = [(e.Length, f"Edge{n}", u_) for n, e in enumerate(shape.Edges, 1) if (u_ := curves.line(e)) is not None]
    faces = [(f.Area, f"Face{n}", App.Vector(curves.surface(f).Axis)) for n, f in enumerate(shape.Faces, 1)
             if isinstance(curves.surface(f), Part.Cylinder)]  # fmt: skip
    for candidates in (edges, faces):
        fitting = [c for c in candidates if c[2].cross(u).Length < contacts.PARALLEL * c[2].Length]
        if fitting:
            _, element, v = max(fitting, key=lambda c: c[0])
            return (piece.where.root, piece.where.path + element), v.dot(u) < 0
    raise Refused("proposal-no-edge", piece.label, object=repr(piece.label))


# -- the whole machine -----------------------------------------------------------------------------------------------
def propose_machine(objects, progress=None) -> MachineProposal:
    """Bed, carriages, chains, axes, travels and tool point that the geometry suggests; changes nothing.

    objects : the parts (objects or links), one object per part: `split` a compound first.  progress : called with
    (done, all) after each pair of neighbours that is examined; a true answer stops, and what is known is refused.
    Refuses where the rails do not show three carriages in a row; `propose_axes` may still help then.
    """
    pieces = pieces_of(objects)
    if len(pieces) < 4:
        raise Refused("proposal-too-few-parts", "selection", count=len(pieces))
    found = contacts.guides(pieces)
    stopped: list[bool] = []
    pairs = contacts.contacts(pieces, found, _watched(progress, stopped))
    if stopped:
        raise Refused("proposal-stopped", "selection")
    bolted, sliding = contacts.sort_contacts(pieces, found, pairs)
    body = _bodies(len(pieces), bolted)
    edges = _by_rails(body, sliding)
    left_out = _adopt_loose(pieces, body, edges)
    return _Builder(pieces, body, edges, sliding, left_out).proposal(_axes(pieces, found))


def _watched(progress, stopped: list):
    if progress is None:
        return None

    def watch(done, total):
        if progress(done, total):
            stopped.append(True)
        return bool(stopped)

    return watch


def _bodies(n: int, bolted) -> list[int]:
    body = list(range(n))
    for p, q in bolted:
        keep, gone = body[p], body[q]
        body = [keep if b == gone else b for b in body]
    return body


def _edges(body, sliding) -> dict[tuple[int, int], list]:
    """Pair of bodies -> slidings between them."""
    edges: dict[tuple[int, int], list] = {}
    for s in sliding:
        a, b = body[s.guide.piece], body[s.on]
        if a != b:
            edges.setdefault((min(a, b), max(a, b)), []).append(s)
    return edges


def _by_rails(body, sliding):
    """Edges by rails where there are three of those; a nut that touches nothing but its screw rides along then."""
    edges = _edges(body, [s for s in sliding if s.guide.kind == "rail"])
    if len(edges) < 3:
        return _edges(body, sliding)
    main = {b for pair in edges for b in pair}
    for s in sliding:
        alone, inner = body[s.on], body[s.guide.piece]
        for pair, found in edges.items():
            if alone not in main and inner in pair and found[0].guide.direction.cross(s.guide.direction).Length < 0.02:
                other = pair[0] if pair[1] == inner else pair[1]
                body[:] = [other if b == alone else b for b in body]
                break
    return edges


def _adopt_loose(pieces, body, edges) -> list[int]:
    """Bodies that nothing slides on join the one they stand next to; returns the pieces that stand next to none."""
    main = {b for pair in edges for b in pair}
    left = []
    for b in sorted(set(body) - main):
        members = [p for p in range(len(pieces)) if body[p] == b]
        others = [q for q in range(len(pieces)) if body[q] in main]
        gap, q = min(((_gap(pieces[p], pieces[q]), q) for p in members for q in others), default=(NEAR, None))
        if gap >= NEAR:
            left += members
            continue
        for p in members:
            body[p] = body[q]
    return left


def _gap(one: Piece, other: Piece) -> float:
    """Distance of two pieces, mm; `NEAR` where it is that or more."""
    near = NEAR
    for solid, box in zip(one.solids, one.boxes):
        wide = App.BoundBox(box)
        wide.enlarge(NEAR)
        for solid_, box_ in zip(other.solids, other.boxes):
            if wide.intersect(box_):
                near = min(near, solid.distToShape(solid_)[0])
    return near


class _Builder:
    """Orders bodies into chains and names them."""

    def __init__(self, pieces, body, edges, sliding, left_out):
        self.pieces, self.body, self.edges, self.left_out = pieces, body, edges, left_out
        self.notes = []

    def members(self, b: int) -> list[Piece]:
        return [p for p, n in zip(self.pieces, self.body) if n == b]

    def proposal(self, axes: list[AxisProposal]) -> MachineProposal:
        if len(self.edges) != 3 or len({b for pair in self.edges for b in pair}) != 4:
            raise Refused("proposal-not-in-a-row", "selection", count=len(self.edges))
        directions = {pair: max(found, key=lambda s: s.guide.length).guide.direction
                      for pair, found in self.edges.items()}  # fmt: skip
        letter = dict(zip(directions, _letters(list(directions.values()))))
        bed = self._bed()
        branches = self._branches(bed, letter)
        work, tool = self._sides(branches)
        parts = {"F": [p.where for p in self.members(bed)]}
        by_axis, travel = {}, {}
        references, reasons = {}, {"F": f"what stands lowest and carries the others, {len(parts['F'])} parts"}
        for branch, on_work in ((work, True), (tool, False)):
            for pair, outer in branch:
                name = letter[pair]
                parts[name] = [p.where for p in self.members(outer)]
                by_axis[name] = self._axis(name, directions[pair], pair, axes)
                travel[name], limits = self._travel(pair, outer, by_axis[name].direction, on_work)
                references[name], middle = self._reference(pair)
                reasons[name] = f"direction: {by_axis[name].why}; reference: {middle}; travel: {limits}"
        for p in self.left_out:
            self.notes.append(f"{self.pieces[p].label!r} touches nothing: left out.")
        tip, reasons["tool point"] = self._tool_point(tool[-1][1] if tool else bed)
        return MachineProposal(
            _with_ends(parts, work, tool, letter), [letter[pair] for pair, _ in work],
            [letter[pair] for pair, _ in tool], by_axis, travel, tip,
            [self.pieces[p].where for p in self.left_out], self.notes, references, reasons, axes,
        )  # fmt: skip

    def _bed(self) -> int:
        bodies = sorted({b for pair in self.edges for b in pair})
        named = [b for b in bodies if any(guess(p.label) == "F" for p in self.members(b))]
        lowest = min(min(p.box.ZMin for p in self.members(b)) for b in bodies)
        height = max(max(p.box.ZMax for p in self.members(b)) for b in bodies) - lowest
        standing = [b for b in bodies if min(p.box.ZMin for p in self.members(b)) < lowest + 0.05 * height]
        return max(named if len(named) == 1 else standing, key=lambda b: sum(p.volume for p in self.members(b)))

    def _branches(self, bed: int, letter) -> list[list]:
        waiting = dict(self.edges)
        branches, ends = [], [(bed, None)]
        while ends:
            inner, branch = ends.pop(0)
            following = [pair for pair in waiting if inner in pair]
            if len(following) > (2 if inner == bed else 1):
                raise Refused("proposal-carries-two", "selection")
            for pair in following:
                del waiting[pair]
                outer = pair[0] if pair[1] == inner else pair[1]
                if branch is None:
                    branches.append([(pair, outer)])
                    ends.append((outer, branches[-1]))
                else:
                    branch.append((pair, outer))
                    ends.append((outer, branch))
        if waiting:
            raise Refused("proposal-slides-on-two", "selection")
        return branches

    def _sides(self, branches):
        branches = [*branches, *[[] for _ in range(2 - len(branches))]]

        def score(branch):
            labels = [p.label for _, outer in branch for p in self.members(outer)]
            return sum((guess(t) in ("T", "Z")) - bool(WORKPIECE_SIDE.search(t)) for t in labels)

        if score(branches[0]) == score(branches[1]):
            upright = [any(abs(max(self.edges[pair], key=lambda s: s.guide.length).guide.direction.z) > 0.7
                           for pair, _ in branch) for branch in branches]  # fmt: skip
            first = upright[0] if upright[0] != upright[1] else len(branches[0]) >= len(branches[1])
        else:
            first = score(branches[0]) > score(branches[1])
        return (branches[1], branches[0]) if first else (branches[0], branches[1])

    def _axis(self, name, u, pair, axes) -> AxisProposal:
        guide = max(self.edges[pair], key=lambda s: s.guide.length).guide
        u = u if u.dot(UNIT[name]) >= 0 else u * -1.0
        source, reverse = _source(self.pieces[guide.piece], u)
        score = sum(a.score for a in axes if a.direction.cross(u).Length < contacts.PARALLEL)
        why = f"{guide.kind} {self.pieces[guide.piece].label!r}"
        return AxisProposal(name, u, source, reverse, guide.length, score, why)

    def _reference(self, pair) -> tuple[App.Vector, str]:
        """The middle of all that slides on the rails (or the screw) between two bodies, and how it was found."""
        kind = max(self.edges[pair], key=lambda s: (s.guide.kind == "rail", s.guide.length)).guide.kind
        riders = {s.on for s in self.edges[pair] if s.guide.kind == kind}
        total = App.BoundBox()
        for p in riders:
            total.add(self.pieces[p].box)
        names = ", ".join(repr(self.pieces[p].label) for p in sorted(riders)[:2]) + (" …" if len(riders) > 2 else "")
        return total.Center, f"the middle of what slides on the {kind}s: {names}"

    def _travel(self, pair, outer: int, u: App.Vector, on_work: bool) -> tuple[tuple[float, float], str]:
        """As far as what slides stays on every rail, and how it was found."""
        low, high = [], []
        rails: dict[Guide, list] = {}
        for s in self.edges[pair]:
            if s.guide.kind == "rail":
                rails.setdefault(s.guide, []).append(s)
        for guide, riders in rails.items():
            before = min(s.low for s in riders) - guide.low
            after = guide.high - max(s.high for s in riders)
            if self.body[guide.piece] == outer:  # the rail is what moves
                before, after = after, before
            if guide.direction.dot(u) < 0:
                before, after = after, before
            low.append(-before)
            high.append(after)
        if not low or max(low) >= min(high):
            label = self.members(outer)[0].label
            self.notes.append(f"No rail says how far {label!r} goes: {ASSUMED_TRAVEL:g} mm to either side is assumed.")
            return (-ASSUMED_TRAVEL, ASSUMED_TRAVEL), "assumed"
        ends = (max(low), min(high))
        return (-ends[1], -ends[0]) if on_work else ends, "as far as the blocks stay on the rails"

    def _tool_point(self, body: int) -> tuple[tuple | None, str]:
        """The centre of the lowest round edge about the vertical on the body that carries the tool, and in words."""
        best = None
        for piece in self.members(body):
            shape = piece.where.shape()
            for n, edge in enumerate(shape.Edges, 1):
                circle = curves.circle(edge)
                if circle is not None and abs(circle.Axis.z) > 0.999:
                    key = (round(circle.Center.z, 3), -circle.Radius)
                    if best is None or key < best[0]:
                        best = (key, (piece.where.root, f"{piece.where.path}Edge{n}"), piece.label)
        if best is None:
            return None, "no round edge about the vertical: take the tool's tip by hand"
        return best[1], f"the lowest round edge on the side of the tool, of {best[2]!r}"


def _with_ends(parts: dict[str, list[Place]], work, tool, letter) -> dict[str, list[Place]]:
    """Spindle (T) and workpiece (W) out of the last carriages, where their names say so; whole containers as such."""
    for body, branch in (("W", work), ("T", tool)):
        last = letter[branch[-1][0]] if branch else "F"
        named = [where for where in parts[last] if _named(where, body)]
        if named and len(named) < len(parts[last]):
            parts[body] = named
            parts[last] = [where for where in parts[last] if where not in named]
    return whole_containers(parts)


def _named(where: Place, body: str) -> bool:
    """Whether the name of a part, or of the innermost container whose name says anything, is that of a body."""
    return next((g for o in reversed(where.chain) if (g := guess(o.Label))), "") == body


def machine_from_parts(doc, objects, *, proposal: MachineProposal | None = None, tool_point=None, travel=None,
                       label="Machine"):  # fmt: skip
    """Make a Machine from what `propose_machine` says about the objects (or from a proposal); returns the Machine.

    One compound is split into parts first.  tool_point, travel ({"X": (low, high)}) replace what is proposed.
    Refuses, with nothing made, where the geometry does not show a machine.  Opens no transaction.
    """
    if proposal is None:
        proposal = propose_machine(apart(objects))
    tool_point = tool_point or named_tool_point(doc) or proposal.tool_point
    machine = factory.make_machine(
        doc, proposal.workpiece_chain, proposal.tool_chain, bed=proposal.parts["F"], tool_point=tool_point, label=label
    )
    for name in AXES:
        axis = proposal.axes[name]
        factory.make_axis(
            machine, name, proposal.parts[name], travel=(travel or {}).get(name, proposal.travel[name]),
            direction=axis.source, reverse=axis.reverse,
            reference=reference_point(doc, name, proposal.references.get(name)),
        )  # fmt: skip
    for name in ("T", "W"):
        if proposal.parts.get(name):
            factory.make_body(machine, name, proposal.parts[name])
    for note in proposal.notes:
        App.Console.PrintWarning(f"{machine.Label}: {note}\n")
    doc.recompute()
    return machine


def reference_point(doc, name: str, at: App.Vector | None):
    """A vertex where the reference point of an axis is proposed, to be moved to the scale; None where none is."""
    if at is None:
        return None
    point = doc.addObject("Part::Vertex", f"Reference{name}")
    point.Label = f"Reference {name} (proposed)"
    point.Placement.Base = at
    return point, "Vertex1"


def named_tool_point(doc):
    """A coordinate system, datum or point whose name says that it is the tool's tip, or None."""
    for obj in doc.Objects:
        if (_is_datum(obj) or obj.TypeId == "Part::Vertex") and TOOL_POINT.search(obj.Label):
            return place(obj)
    return None
