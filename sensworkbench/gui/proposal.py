# SPDX-License-Identifier: LGPL-2.1-or-later
"""A first guess at a machine: who is the bed, who carries X, Y, Z, spindle and workpiece, and in which order.

Names of the parts (English, German, Korean) say who is who; what stands inside what in the tree says who carries whom.
It is only a proposal: the panel shows it and everything can be changed.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from ..core.errors import AXES
from ..document import paths
from ..document.base import kind_of
from ..document.part_names import TOOL_POINT, WORKPIECE_SIDE, guess


@dataclass
class Proposal:
    """Parts of each body ("F" bed, X, Y, Z, T, W) as links, and the chains from the bed outwards."""

    parts: dict[str, list] = field(default_factory=lambda: {b: [] for b in ("F", *AXES, "T", "W")})
    workpiece_chain: list[str] = field(default_factory=list)
    tool_chain: list[str] = field(default_factory=list)
    tool_point: tuple | None = None


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


def propose(doc, selection=()) -> Proposal:
    """From the selected parts, or from the whole document when nothing is selected."""
    found = Proposal()
    links = [s for s in selection if not kind_of(s[0])] or candidates(doc)
    for link in links:
        where = paths.place(link)
        if where is None or not hasattr(where.object, "Label"):
            continue
        body = guess(where.object.Label)
        if body and not _taken(found, where):
            found.parts[body].append((where.root, where.path))
    found.workpiece_chain, found.tool_chain = chains(found)
    found.tool_point = _tool_point(doc)
    return found


def _taken(found: Proposal, where) -> bool:
    return any(paths.place(link).key == where.key for links in found.parts.values() for link in links)


def _tool_point(doc):
    for obj in doc.Objects:
        if (paths._is_datum(obj) or obj.TypeId == "Part::Vertex") and TOOL_POINT.search(obj.Label):
            return (obj, "")
    return None


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


def selected_links() -> list[tuple]:
    """What is selected in the window, as links with the path from the topmost container."""
    import FreeCADGui as Gui

    links = []
    for item in Gui.Selection.getSelectionEx("", 0):
        links.extend((item.Object, sub) for sub in (item.SubElementNames or ("",)))
    return links
