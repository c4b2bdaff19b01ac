# SPDX-License-Identifier: LGPL-2.1-or-later
"""A first guess at a machine: who is the bed, who carries X, Y, Z, spindle and workpiece, in which order and direction.

Names of the parts (English, German, Korean) say who is who, what stands inside what in the tree says who carries whom.
Parts that came as plain shapes, from a STEP file, are looked at as well: rails, screws, and what touches them.  It is
only a proposal, with a reason for each piece of it: the panel shows it and everything can be changed.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import Part

from ..core.errors import AXES
from ..core.refusal import Refused
from ..document import factory, imported, paths, proposals
from ..document.base import kind_of
from ..document.part_names import WORKPIECE_SIDE, guess

BODIES = ("F", *AXES, "T", "W")


@dataclass
class Proposal:
    """Parts of each body ("F" bed, X, Y, Z, T, W) as links, the chains from the bed outwards, and what geometry adds.

    reasons : body, "structure" or "tool point" -> why, in words; empty where nothing but names was looked at.
    directions : all that the geometry suggests, best first.  geometry : whether rails and screws said who is who.
    """

    parts: dict[str, list] = field(default_factory=lambda: {b: [] for b in BODIES})
    workpiece_chain: list[str] = field(default_factory=list)
    tool_chain: list[str] = field(default_factory=list)
    tool_point: tuple | None = None
    axes: dict[str, proposals.AxisProposal] = field(default_factory=dict)
    travel: dict[str, tuple[float, float]] = field(default_factory=dict)
    references: dict = field(default_factory=dict)
    reasons: dict[str, str] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)
    directions: list[proposals.AxisProposal] = field(default_factory=list)
    geometry: bool = False


def candidates(doc) -> list[tuple]:
    """Parts of a document that could be bodies: top-level containers, links and shapes, and containers inside them."""
    found = []
    for obj in doc.Objects:
        if kind_of(obj) or not _part_like(obj):
            continue
        outer = paths.container_of(obj)
        if outer is None or obj.isDerivedFrom("App::Part") or obj.isDerivedFrom("App::Link"):
            found.append((obj, ""))
    return found


def _part_like(obj) -> bool:
    if obj.isDerivedFrom("App::Part") or obj.isDerivedFrom("App::Link"):
        return True
    if paths._is_datum(obj) or not hasattr(obj, "Shape"):
        return False
    used = any(hasattr(parent, "Shape") and not hasattr(parent, "Group") for parent in obj.InList)
    return not used and not obj.Shape.isNull() and bool(obj.Shape.Solids)


# -- names -----------------------------------------------------------------------------------------------------------
def propose(doc, selection=()) -> Proposal:
    """What the names say of the selected parts, or of the whole document when nothing is selected.  Changes nothing."""
    found = Proposal()
    for link in _links(doc, selection):
        where = paths.place(link)
        if where is None or not hasattr(where.object, "Label"):
            continue
        body = guess(where.object.Label)
        if body and not _taken(found, where):
            found.parts[body].append((where.root, where.path))
    found.workpiece_chain, found.tool_chain = chains(found)
    found.tool_point = _tool_point(doc)
    return found


def _links(doc, selection) -> list:
    return [s for s in selection if not kind_of(s[0])] or candidates(doc)


def _taken(found: Proposal, where) -> bool:
    return any(paths.place(link).key == where.key for links in found.parts.values() for link in links)


def _tool_point(doc):
    found = proposals.named_tool_point(doc)
    return None if found is None else (found.root, found.path)


def chains(found: Proposal) -> tuple[list[str], list[str]]:
    """(workpiece chain, tool chain) of a proposal: by nesting in the tree where it says something, else by names."""
    keys = {b: [paths.place(link).key for link in links] for b, links in found.parts.items()}

    def inside(inner: str, outer: str) -> bool:
        return any(len(a) > len(b) and a[: len(b)] == b for a in keys[inner] for b in keys[outer])

    labels = {b: " ".join(paths.place(link).object.Label for link in links) for b, links in found.parts.items()}
    side = {}
    for name in AXES:
        if inside("W", name):
            side[name] = "workpiece"
        elif inside("T", name):
            side[name] = "tool"
        else:
            side[name] = "workpiece" if WORKPIECE_SIDE.search(labels[name]) else "tool"

    def ordered(names, default):
        return sorted(names, key=lambda n: (sum(inside(n, m) for m in names if m != n), default.index(n)))

    workpiece = ordered([n for n in AXES if side[n] == "workpiece"], "YXZ")
    return workpiece, ordered([n for n in AXES if side[n] == "tool"], "XYZ")


# -- geometry --------------------------------------------------------------------------------------------------------
def examine(doc, selection=(), progress=None) -> Proposal:
    """The proposal for a panel: by names, and for plain shapes by rails, screws and contacts as well.

    A compound that hides the parts is taken apart: the caller opens the transaction.  progress : see
    `proposals.propose_machine`; what it raises comes through.
    """
    links = _links(doc, selection)
    tops = [link for link in links if (w := paths.place(link)) is not None and not _inside_another(w, links)]
    named = propose(doc, selection)
    pieces = imported.pieces_of(tops)
    complete = all(named.parts[b] for b in ("F", *AXES))
    if not pieces or (complete and not _plain(pieces)):
        return named
    unnamed = _unnamed(named, pieces)
    complete = complete and not unnamed
    parts = imported.apart(tops)
    try:
        found = proposals.propose_machine(parts, progress)
    except (Refused, Part.OCCError) as error:
        return _directions_only(named, parts, error, unnamed)
    return _merged(named, found, complete)


def _inside_another(where, links) -> bool:
    return any((o := paths.place(link)) is not None and len(o.key) < len(where.key) and
               where.key[: len(o.key)] == o.key for link in links)  # fmt: skip


def _plain(pieces) -> bool:
    """Whether all parts are bare shapes, as an import leaves them."""
    real = [p.where.object.getLinkedObject(True) for p in pieces]
    return all(o.TypeId == "Part::Feature" or o.TypeId in imported.COMPOUNDS for o in real)


def _unnamed(named: Proposal, pieces) -> list[str]:
    """Labels of the pieces that belong to no part whose name says anything."""
    known = {paths.place(link).key for links in named.parts.values() for link in links}
    return [p.label for p in pieces
            if not any(p.where.key[:n] in known for n in range(1, len(p.where.key) + 1))]  # fmt: skip


def _directions_only(named: Proposal, parts, error, unnamed: list[str]) -> Proposal:
    """Where no carriages were found: the directions of the best guides and edges, each with its reason."""
    named.notes.append(getattr(error, "what", None) or str(error))
    if unnamed and any(named.parts.values()):
        few = ", ".join(repr(label) for label in unnamed[:3]) + (" …" if len(unnamed) > 3 else "")
        named.notes.append(f"{len(unnamed)} parts belong to no component yet: {few}")
    try:
        named.directions = proposals.propose_axes(parts)
    except Refused:
        return named
    named.axes = {a.axis: a for a in named.directions if a.axis}
    named.reasons = {name: f"direction: {a.why}" for name, a in named.axes.items()}
    _by_name(named)
    return named


def _merged(named: Proposal, found: proposals.MachineProposal, complete: bool) -> Proposal:
    """Geometry says who slides on whom; where the names are complete they say who is who, and letters follow them."""
    letters = {name: name for name in AXES}
    if complete:
        letters = _letters(named, found)
    if letters is None:
        named.notes.append("names and rails do not agree on what X, Y and Z carry: the parts follow the names")
        letters = {name: name for name in AXES}
        chain = (named.workpiece_chain, named.tool_chain)
    else:
        chain = tuple([letters[n] for n in chain] for chain in (found.workpiece_chain, found.tool_chain))
    made = Proposal(
        workpiece_chain=chain[0], tool_chain=chain[1], tool_point=named.tool_point or found.tool_point,
        axes={letters[n]: replace(a, axis=letters[n]) for n, a in found.axes.items()},
        travel={letters[n]: t for n, t in found.travel.items()},
        references={letters[n]: r for n, r in found.references.items()},
        reasons={letters.get(n, n): why for n, why in found.reasons.items()},
        notes=named.notes + found.notes, directions=found.directions, geometry=True,
    )  # fmt: skip
    made.reasons["structure"] = "what slides on what, from the bed outwards"
    if named.tool_point:
        made.reasons["tool point"] = f"its name, {named.tool_point[0].Label!r}"
    if complete:
        made.parts = named.parts
        _by_name(made)
        made.notes += _disputed(named, found, letters)
    else:
        made.parts |= {body: [(w.root, w.path) for w in where] for body, where in found.parts.items()}
        for body in ("T", "W"):
            if made.parts[body]:
                made.reasons[body] = "its name"
    return made


def _disputed(named: Proposal, found, letters) -> list[str]:
    """What the names put into another body than the contacts do (spindle and workpiece apart), as a note."""
    by_name = {leaf.key: body for body, links in named.parts.items() for link in links
               for leaf in paths.leaves(paths.place(link))}  # fmt: skip
    labels = [leaf.label for body in ("F", *AXES) for where in found.parts[body] for leaf in paths.leaves(where)
              if by_name.get(leaf.key, "T") not in ("T", "W", letters.get(body, body))]  # fmt: skip
    few = ", ".join(repr(label) for label in labels[:3]) + (" …" if len(labels) > 3 else "")
    return [f"names and contacts disagree on {few}: the names are followed"] if labels else []


def _by_name(found: Proposal) -> None:
    for body, links in found.parts.items():
        if links:
            words = f"parts: the name {paths.place(links[0]).object.Label!r}"
            found.reasons[body] = "; ".join(filter(None, [words, found.reasons.get(body, "") if body in AXES else ""]))


def _letters(named: Proposal, found) -> dict[str, str] | None:
    """Letter in the geometry -> letter by name, from the parts that both have; None where they do not agree."""

    def leaves(links):
        return {leaf.key for link in links for leaf in paths.leaves(paths.place(link))}

    by_name = {name: leaves(named.parts[name]) for name in AXES}
    letters = {}
    for name in AXES:
        own = leaves(found.parts[name])
        letters[name] = max(AXES, key=lambda n: len(own & by_name[n]))
        if not own & by_name[letters[name]]:
            return None
    return letters if sorted(letters.values()) == sorted(AXES) else None


# -- making ----------------------------------------------------------------------------------------------------------
def make(doc, found: Proposal, label: str):
    """The machine of a proposal.  Opens no transaction."""
    machine = factory.make_machine(
        doc, found.workpiece_chain, found.tool_chain, bed=found.parts["F"], tool_point=found.tool_point, label=label
    )
    for name in AXES:
        axis, more = found.axes.get(name), {}
        if axis is not None:
            more = {"direction": axis.source, "reverse": axis.reverse}
        if name in found.travel:
            more["travel"] = found.travel[name]
        if name in found.references:
            more["reference"] = proposals.reference_point(doc, name, found.references[name])
        factory.make_axis(machine, name, found.parts[name], **more)
    for name in ("T", "W"):
        factory.make_body(machine, name, found.parts[name])
    return machine


def selected_links() -> list[tuple]:
    """What is selected in the window, as links with the path from the topmost container."""
    import FreeCADGui as Gui

    links = []
    for item in Gui.Selection.getSelectionEx("", 0):
        links.extend((item.Object, sub) for sub in (item.SubElementNames or ("",)))
    return links
