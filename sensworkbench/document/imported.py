# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parts of a machine as a STEP import leaves them: one compound, many loose solids, or a tree of containers.

Everything with solids is a piece; a compound that hides the parts is taken apart, and the compound stays, hidden.
"""

from __future__ import annotations

from dataclasses import dataclass

import FreeCAD as App

from ..core.refusal import Refused
from .paths import PartPath, leaves, places

COMPOUNDS = ("Part::Compound", "Part::Compound2")


@dataclass
class Piece:
    """One object with its solids, document coordinates."""

    where: PartPath
    solids: list

    @property
    def label(self) -> str:
        """Return the label of the part."""
        return self.where.object.Label

    @property
    def box(self):
        """Return the bounding box of its solids."""
        total = App.BoundBox()
        for solid in self.solids:
            total.add(solid.BoundBox)
        return total


def pieces_of(objects) -> list[Piece]:
    """Everything with solids at or below the objects (objects or links), each once."""
    found = {}
    for where in places(objects if isinstance(objects, (list, tuple)) else [objects]):
        for leaf in leaves(where):
            shape = leaf.shape()
            if leaf.key not in found and shape is not None and shape.Solids:
                found[leaf.key] = Piece(leaf, shape.Solids)
    return [p for p in found.values() if not _repeats(p.where.object, {q.where.object for q in found.values()})]


def _repeats(obj, others) -> bool:
    """Whether an object is a compound of others that are there themselves."""
    return obj.TypeId in COMPOUNDS and bool(obj.Links) and all(link in others for link in obj.Links)


def split(obj) -> list:
    """Give each solid of a compound an object of its own, in an App::Part at the place of the compound; return them.

    A compound of other objects (as FreeCAD up to 0.21 imports STEP files) already has them: they are shown instead.
    The compound remains, hidden.  Refuses an object with fewer than two solids.  Opens no transaction.
    """
    if obj.TypeId in COMPOUNDS and len(obj.Links) > 1 and obj.Placement.isIdentity():
        parts = sorted(obj.Links, key=lambda part: part.ID)  # the import lists them in no order
        _show(parts, obj)
        return parts
    solids = obj.Shape.Solids if hasattr(obj, "Shape") else []
    if len(solids) < 2:
        raise Refused("import-too-few-solids", obj.Label, object=repr(obj.Label), count=len(solids))
    doc, outer = obj.Document, obj.getParentGeoFeatureGroup()
    holder = doc.addObject("App::Part", f"{obj.Name}_parts")
    holder.Label = f"{obj.Label}, parts"
    if outer is not None:
        outer.addObject(holder)
    made = []
    for number, solid in enumerate(solids, 1):
        part = doc.addObject("Part::Feature", f"Solid{number:03d}")
        part.Label = f"{obj.Label} {number}"
        part.Shape = solid
        holder.addObject(part)
        made.append(part)
    _show(made, obj)
    doc.recompute()
    return made


def _show(parts, lump) -> None:
    if getattr(lump, "ViewObject", None) is None:
        return
    for part in parts:
        if part not in getattr(lump, "Links", ()) and hasattr(lump.ViewObject, "ShapeColor"):
            part.ViewObject.ShapeColor = lump.ViewObject.ShapeColor
        part.ViewObject.Visibility = True
    lump.ViewObject.Visibility = False


def whole_containers(groups: dict[str, list[PartPath]]) -> dict[str, list[PartPath]]:
    """The same groups of places, with a container in place of its parts where all of them are in one group.

    groups : body -> places of single parts.  A container that holds everything stays apart.
    """
    bodies: dict[tuple, set] = {}
    for body, members in groups.items():
        for where in members:
            for outer in _outer(where):
                bodies.setdefault(outer.key, set()).add(body)
    made = {}
    for body, members in groups.items():
        found = [next((o for o in _outer(where) if bodies[o.key] == {body}), where) for where in members]
        made[body] = list({where.key: where for where in found}.values())
    return made


def _outer(where: PartPath) -> list[PartPath]:
    """Return the containers of a place, from the outermost one inwards."""
    names = where.path.rstrip(".").split(".") if where.path else []
    found = [PartPath(where.root, ".".join(names[:n]) + "." if n else "") for n in range(len(names))]
    return [
        place for place in found if place.object.isDerivedFrom("App::Part") or place.object.isDerivedFrom("App::Link")
    ]
