# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one place where a proposal becomes a machine: script, command line and window all build it here.

A lump is taken apart, containers that belong to one body as a whole are named as wholes, directions are linked to edges
and faces of the parts where some lie right, so that they follow when parts are moved.
"""

from __future__ import annotations

import FreeCAD as App
import numpy as np
import Part

from ...messages import Refused
from .. import curves, factory
from ..imported import COMPOUNDS, split, whole_containers
from ..part_names import TOOL_POINT
from ..paths import PartPath, _is_datum, leaves, place
from .facets import Looker, skins
from .found import Axis, Found
from .reading import Unit

PARALLEL = 2e-4  # rad between a direction and the edge that it is linked to
MOST_EDGES = 400


def build(doc, found: Found, *, label: str = "Machine", tool_point=None, travel=None, blanks=()):
    """Make the Machine of a proposal in `doc`; returns the Machine object, whose Problem says what is still missing.

    tool_point, travel ({"X": (low, high)}) replace what is proposed.  blanks : names of axes that a person will fill.
    Refuses a proposal without axes or blanks; nothing is made then.  Opens no transaction.
    """
    if not found.axes and not blanks:
        raise Refused("propose-no-machine", doc.Label)
    places = _taken_apart(found)
    before = {o.Name for o in doc.Objects}
    machine = _built(doc, found, places, label, tool_point, travel or {}, [b for b in blanks if b not in found.axes])
    found.made = [o.Name for o in doc.Objects if o.Name not in before]
    return machine


def unbuild(doc, found: Found) -> None:
    """Take away again what `build` made of a proposal; parts of a lump that was taken apart stay."""
    for name in reversed(found.made):
        if doc.getObject(name) is not None:
            doc.removeObject(name)
    found.made = []


def _built(doc, found: Found, places, label, tool_point, travel, blanks):
    groups = {body: [places[u.key] for u in units] for body, units in found.bodies.items() if units}
    groups = whole_containers(groups)
    tool_point = tool_point or named_tool_point(doc) or _tool_point(doc, found, places)
    chains = found.workpiece_chain, [*found.tool_chain, *blanks]
    machine = factory.make_machine(doc, *chains, bed=groups.get("F", ()), tool_point=tool_point, label=label)
    for name, axis in found.axes.items():
        source, reverse = _direction(doc, found, axis, places)
        made = factory.make_axis(
            machine,
            name,
            groups.get(name, ()),
            travel=travel.get(name, axis.travel),
            direction=source,
            reverse=reverse,
            reference=axis.joint or reference_point(doc, name, axis.point),
        )
        if axis.joint is not None:
            _where_the_slider_stands(machine, made, groups.get(name, ()))
    for name in blanks:
        factory.make_axis(machine, name, groups.get(name, ()))
    for name in ("T", "W"):
        if groups.get(name):
            factory.make_body(machine, name, groups[name])
    doc.recompute()
    return machine


def _where_the_slider_stands(machine, axis, parts) -> None:
    from .. import joints

    stands = joints.position(machine, axis, list(parts))
    if stands is not None:
        axis.StandsAt = stands
        axis.Position = stands


# -- parts -----------------------------------------------------------------------------------------------------------
def _taken_apart(found: Found) -> dict[tuple, PartPath]:
    """Unit -> where it stands once lumps are taken apart."""
    units = [*(u for group in found.bodies.values() for u in group), *found.left_out]
    made = {u.key: u.where for u in units if u.number is None}
    made |= found.document.apart  # by an earlier answer
    lumps: dict[tuple, list[Unit]] = {}
    for unit in units:
        if unit.number is not None and unit.key not in made:
            lumps.setdefault(unit.where.key, []).append(unit)
    for group in lumps.values():
        obj = group[0].where.object
        parts = split(obj) if _has_solids(obj) else _skins(obj)
        boxes = np.array([_box(p, found.document.frame) for p in parts])
        for unit in group:
            made[unit.key] = place(parts[int(np.argmin(np.abs(boxes - unit.box).sum(1)))])
            found.document.apart[unit.key] = made[unit.key]
    return made


def _has_solids(obj) -> bool:
    return (obj.TypeId in COMPOUNDS and len(obj.Links) > 1) or len(curves.parts(obj.Shape, "Solids")) > 1


def _box(obj, frame) -> np.ndarray:
    """The box of a part in the frame in which the document was read."""
    where = PartPath(obj) if not obj.getParentGeoFeatureGroup() else place(obj)
    solids = [s.scaled(frame.scale) for s in Looker().solids(where.shape(), frame.turn)]
    boxes = np.array([s.box for s in solids]) if solids else np.full((1, 6), np.inf)
    return np.hstack([boxes[:, :3].min(0), boxes[:, 3:].max(0)])


def _skins(obj) -> list:
    """An object for each connected skin of a shape that calls itself one solid; the shape stays, hidden."""
    doc = obj.Document
    holder = doc.addObject("App::Part", f"{obj.Name}_parts")
    holder.Label = f"{obj.Label}, parts"
    made = []
    faces = curves.parts(obj.Shape, "Faces")
    for number, group in enumerate(skins(faces), 1):
        part = doc.addObject("Part::Feature", f"Solid{number:03d}")
        part.Label = f"{obj.Label} {number}"
        skin = Part.makeCompound([faces[i] for i in group])
        try:
            skin = Part.makeSolid(Part.makeShell([faces[i] for i in group]))
        except curves.FAILS:
            pass
        part.Shape = skin
        holder.addObject(part)
        made.append(part)
    if obj.ViewObject is not None:
        obj.ViewObject.Visibility = False
    doc.recompute()
    return made


# -- directions and points -------------------------------------------------------------------------------------------
def _direction(doc, found: Found, axis: Axis, places):
    """(source, reverse) for `make_axis`: the slider, an edge or a face along the axis, else a line that is added."""
    if axis.joint is not None:
        return axis.joint, axis.reverse
    units = ([axis.rail] if axis.rail is not None else []) + sorted(found.bodies[axis.name], key=lambda u: -u.bulk)[:6]
    u = App.Vector(*axis.u)
    for unit in units:
        source = along(places.get(unit.key, unit.where), u)
        if source is not None:
            return source
    line = doc.addObject("Part::Line", f"Direction{axis.name}")
    line.Label = f"Direction {axis.name} (proposed)"
    start = App.Vector(
        *(axis.point if axis.point is not None else found.document.frame.point(found.bodies[axis.name][0].box[:3]))
    )
    end = start + u * 100
    for name, value in zip(("X1", "Y1", "Z1", "X2", "Y2", "Z2"), (*start, *end)):
        setattr(line, name, value)
    line.recompute()
    return (line, "Edge1"), False


def along(where: PartPath, u: App.Vector, most: int | None = MOST_EDGES):
    """(link to the longest straight edge, or an axis of a cylinder, along u; whether to reverse it), or None.

    most : edges and faces of each part that are looked at, None: all.
    """
    for leaf in leaves(where)[:8]:
        shape = leaf.shape()
        if not curves.is_something(shape):
            continue
        best = None
        for n, edge in enumerate(curves.parts(shape, "Edges")[:most], 1):
            v = curves.line(edge)
            if v is not None and v.cross(u).Length < PARALLEL and (best is None or edge.Length > best[0]):
                best = (edge.Length, f"Edge{n}", v)
        if best is None:
            for n, face in enumerate(curves.parts(shape, "Faces")[:most], 1):
                kept = curves.surface(face)
                v = App.Vector(kept.Axis).normalize() if isinstance(kept, Part.Cylinder) else None
                if v is not None and v.cross(u).Length < PARALLEL and (best is None or face.Area > best[0]):
                    best = (face.Area, f"Face{n}", v)
        if best is not None:
            return (leaf.root, leaf.path + best[1]), best[2].dot(u) < 0
    return None


def reference_point(doc, name: str, at):
    """A vertex where the reference point of an axis is proposed, to be moved to the scale; None where none is."""
    if at is None:
        return None
    return _vertex(doc, f"Reference{name}", f"Reference {name} (proposed)", at)


def _vertex(doc, name: str, label: str, at):
    point = doc.addObject("Part::Vertex", name)
    point.Label = label
    point.Placement.Base = App.Vector(*at)
    return point, "Vertex1"


def named_tool_point(doc) -> PartPath | None:
    """A coordinate system, datum or point whose name says that it is the tool's tip, or None."""
    for obj in doc.Objects:
        if (_is_datum(obj) or obj.TypeId == "Part::Vertex") and TOOL_POINT.search(obj.Label):
            return place(obj)
    return None


def _tool_point(doc, found: Found, places):
    """The centre of the lowest round edge about the upright axis on the tool, else a point that is added."""
    last = found.tool_chain[-1] if found.tool_chain else "F"
    units = found.bodies.get("T") or found.bodies.get(last)
    if not units or not found.axes:
        return None
    up, best = found.up, None
    inner = found.document.frame.inward(up)  # parts are known in the frame of the machine
    for unit in sorted(units, key=lambda u: u.extent(inner)[0])[:12]:
        for leaf in leaves(places.get(unit.key, unit.where))[:6]:
            for n, edge in enumerate(curves.parts(leaf.shape(), "Edges")[:2000], 1):
                circle = curves.circle(edge)
                if circle is not None and abs(App.Vector(circle.Axis).dot(App.Vector(*up))) > 0.999:
                    key = (round(App.Vector(circle.Center).dot(App.Vector(*up)), 3), -circle.Radius)
                    if best is None or key < best[0]:
                        best = (key, (leaf.root, f"{leaf.path}Edge{n}"))
    if best is not None and not found.lathe:
        return best[1]
    boxes = np.array([u.box for u in units])
    low, high = boxes[:, :3].min(0), boxes[:, 3:].max(0)
    at = (low + high) / 2
    if found.lathe and found.bodies.get("W"):
        other = np.array([u.box for u in found.bodies["W"]])
        at = np.clip((other[:, :3].min(0) + other[:, 3:].max(0)) / 2, low, high)
    else:
        at = at - inner * (at @ inner) + inner * min(low @ inner, high @ inner)
    return _vertex(doc, "ToolPoint", "Tool point (proposed)", found.document.frame.point(at))
