# SPDX-License-Identifier: LGPL-2.1-or-later
# ruff: noqa: E501 - tables that are read by column
"""Ways in which people put the pieces of a machine into a document."""

from __future__ import annotations

import FreeCAD as App
import Part

from . import V, add, part
from .kinds import Kind

GERMAN = {"Base": "Grundplatte", "Gantry": "Portal", "Carriage": "Schlitten", "Spindle head": "Spindelkopf", "Frame": "Rahmen",
          "Table": "Tisch", "Tool holder": "Werkzeughalter", "Column": "Ständer", "Saddle": "Kreuzschlitten", "Head": "Kopf",
          "Bed": "Bett", "Headstock": "Spindelkasten", "Cross slide": "Querschlitten", "Cart": "Wagen", "Tool": "Werkzeug",
          "Y axis": "Y-Achse", "X axis": "X-Achse", "Z bed": "Z-Achse Heizbett"}  # fmt: skip


def flat(doc, kind: Kind, folder=None):
    """All parts at the top level, by their names."""
    for piece in kind.pieces:
        add(doc, piece.label, piece.shape)


def numbers(doc, kind: Kind, folder=None):
    """All parts at the top level, with numbers for names."""
    for n, piece in enumerate(kind.pieces):
        add(doc, f"{4711 + 13 * n}", piece.shape)


def tree(doc, kind: Kind, folder=None, names=None):
    """A container for each body, by its English name."""
    top = part(doc, "Machine")
    for body, name in kind.bodies.items():
        holder = part(doc, (names or {}).get(name, name), top)
        for piece in kind.of(body):
            add(doc, piece.label, piece.shape, holder)


def german(doc, kind: Kind, folder=None):
    """A container for each body, by its German name."""
    tree(doc, kind, names=GERMAN)


def nameless_tree(doc, kind: Kind, folder=None):
    """As a STEP file brings it: containers with numbers, solids called Solid."""
    top = part(doc, "Assembly 1")
    for n, body in enumerate(kind.bodies):
        holder = part(doc, f"A{n + 1:03d}", top)
        for piece in kind.of(body):
            add(doc, "SOLID", piece.shape, holder)


def compound(doc, kind: Kind, folder=None):
    """One compound of all solids, without a name."""
    add(doc, "Import", Part.makeCompound([p.shape for p in kind.pieces]))


def lumps(doc, kind: Kind, folder=None):
    """One compound for each body, by its name."""
    for body, name in kind.bodies.items():
        add(doc, name, Part.makeCompound([p.shape for p in kind.of(body)]))


def fusions(doc, kind: Kind, folder=None):
    """Each body fused, without a name."""
    for body in kind.bodies:
        shapes = [p.shape for p in kind.of(body)]
        add(doc, "Fusion", shapes[0].multiFuse(shapes[1:]) if len(shapes) > 1 else shapes[0])


def links(doc, kind: Kind, folder=None):
    """A link for each part, to a hidden library."""
    library = part(doc, "Library")
    library.Visibility = False
    for piece in kind.pieces:
        own = add(doc, piece.label + " source", piece.shape, library)
        link = doc.addObject("App::Link", "L")
        link.LinkedObject, link.Label = own, piece.label


def documents(doc, kind: Kind, folder):
    """A document for each body, linked into one."""
    doc.saveAs(str(folder / "whole.FCStd"))
    for body, name in kind.bodies.items():
        own = App.newDocument(f"Sens{name.replace(' ', '')}")
        holder = part(own, name)
        for piece in kind.of(body):
            add(own, piece.label, piece.shape, holder)
        own.recompute()
        own.saveAs(str(folder / f"{name}.FCStd"))
        link = doc.addObject("App::Link", name.replace(" ", ""))
        link.LinkedObject, link.Label = holder, name


def turned(doc, kind: Kind, folder=None):
    """A tree that stands askew in the document: every placement is turned."""
    top = part(doc, "Machine")
    for body, name in kind.bodies.items():
        holder = part(doc, name, top)
        for piece in kind.of(body):
            add(doc, piece.label, piece.shape, holder)
    top.Placement = App.Placement(V(300, -200, 50), TURNS["turned"])


def baked(doc, kind: Kind, folder=None):
    """Parts whose own coordinates are askew, as a STEP file of a turned assembly has them."""
    for piece in kind.pieces:
        matrix = App.Placement(V(), TURNS["baked"]).toMatrix()
        add(doc, piece.label, piece.shape.transformGeometry(matrix))


def yup(doc, kind: Kind, folder=None):
    """A tree with y upwards."""
    tree(doc, kind)
    next(o for o in doc.Objects if o.Label == "Machine").Placement.Rotation = TURNS["yup"]


def ydown(doc, kind: Kind, folder=None):
    """A tree that hangs upside down, with -y upwards."""
    tree(doc, kind)
    next(o for o in doc.Objects if o.Label == "Machine").Placement.Rotation = TURNS["ydown"]


def splines(doc, kind: Kind, folder=None):
    """Every surface is a spline."""
    for piece in kind.pieces:
        add(doc, piece.label, piece.shape.toNurbs())


def meshes(doc, kind: Kind, folder=None):
    """Nothing but meshes."""
    import MeshPart

    for piece in kind.pieces:
        made = doc.addObject("Mesh::Feature", "Mesh")
        made.Mesh = MeshPart.meshFromShape(Shape=piece.shape, LinearDeflection=0.1)
        made.Label = piece.label


def mirrored(doc, kind: Kind, folder=None):
    """Where a part stands to the left and to the right, the right one is the mirror image of the left one."""
    left = {}
    for piece in kind.pieces:
        box = piece.shape.BoundBox
        twin = left.get(
            (piece.body, round(-box.Center.x, 3), round(box.Center.y, 3), round(box.Center.z, 3), round(box.XLength, 3))
        )
        if twin is not None and abs(box.Center.x) > 1:
            obj = doc.addObject("Part::Mirroring", "Mirror")
            obj.Source, obj.Normal, obj.Label = twin, V(1, 0, 0), f"{twin.Label} (Mirror #1)"
            continue
        key = (
            piece.body,
            round(box.Center.x, 3),
            round(box.Center.y, 3),
            round(box.Center.z, 3),
            round(box.XLength, 3),
        )
        left[key] = add(doc, piece.label, piece.shape)


def doubled(doc, kind: Kind, folder=None):
    """With hidden older copies of half of the parts, somewhat beside their place."""
    tree(doc, kind)
    for piece in kind.pieces[::2]:
        shape = piece.shape.copy()
        shape.translate(V(37, 11, 5))
        add(doc, piece.label + " old", shape).Visibility = False


def a2plus(doc, kind: Kind, folder=None):
    """Parts of a2plus whose add-on is not there, tied by constraints of several kinds."""
    names = []
    for piece in kind.pieces:
        obj = doc.addObject("Part::FeaturePython", "b_part")
        obj.addProperty("App::PropertyString", "objectType").objectType = "a2pPart"
        obj.addProperty("App::PropertyBool", "fixedPosition").fixedPosition = not names
        obj.Label, obj.Shape = piece.label + "_001", piece.shape
        names.append((obj, piece.body))
    kinds = ("axisCoincident", "planeCoincident", "planesParallel", "circularEdge")
    for n, ((a, _), (b, _)) in enumerate(zip(names, names[1:])):
        con = doc.addObject("App::FeaturePython", f"{kinds[n % 4]}_{n:03d}")
        for name, value in (
            ("Object1", a.Name),
            ("Object2", b.Name),
            ("SubElement1", "Face1"),
            ("SubElement2", "Face1"),
            ("Type", "plane"),
        ):
            con.addProperty("App::PropertyString", name)
            setattr(con, name, value)


def assembly4(doc, kind: Kind, folder=None):
    """Links in an Assembly4 model, each attached by a coordinate system to the one that carries it."""
    model = part(doc, "Assembly")
    model.addProperty("App::PropertyString", "AssemblyType").AssemblyType = "Part::Link"
    model.Type = "Assembly"
    store = doc.addObject("App::DocumentObjectGroup", "Parts")
    origin = doc.addObject("PartDesign::CoordinateSystem", "LCS_Origin")
    model.addObject(origin)
    group = doc.addObject("App::DocumentObjectGroup", "Constraints")
    model.addObject(group)
    order = ["F", *[b for b in (kind.truth.structure or "FYX").replace("F", "")]]
    for body, name in kind.bodies.items():
        own = part(doc, f"{name} part")
        own.addObject(doc.addObject("PartDesign::CoordinateSystem", f"LCS_{body}"))
        for piece in kind.of(body):
            add(doc, piece.label, piece.shape, own)
        store.addObject(own)
        own.Visibility = False
        link = doc.addObject("App::Link", f"Link_{body}")
        link.LinkedObject, link.Label = own, name
        for prop in ("AssemblyType", "AttachedBy", "AttachedTo", "SolverId"):
            link.addProperty("App::PropertyString", prop)
        link.AttachedBy = "#LCS_Origin"
        before = order[max(0, order.index(body) - 1)] if body in order else "F"
        link.AttachedTo = "Parent Assembly#LCS_Origin" if body == "F" else f"Link_{before}#LCS_{body}"
        link.SolverId = "Asm4EE"
        model.addObject(link)


WRITERS = {f.__name__: f for f in (
    flat, numbers, tree, german, nameless_tree, compound, lumps, fusions, links, documents, turned, baked, yup, ydown, splines, meshes,
    mirrored, doubled, a2plus, assembly4)}  # fmt: skip
TURNS = {  # how a writer turns the machine
    "turned": App.Rotation(V(0, 0, 1), 31), "baked": App.Rotation(V(0.2, 0.1, 1), 27), "yup": App.Rotation(V(1, 0, 0), -90),
    "ydown": App.Rotation(V(1, 0, 0), 90),
}  # fmt: skip
