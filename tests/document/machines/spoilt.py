# SPDX-License-Identifier: LGPL-2.1-or-later
# ruff: noqa: E501 - tables that are read by column
"""More ways in which people put machines into documents, and what makes their files harder to read."""

from __future__ import annotations

import random

import FreeCAD as App
import Part

from . import V, add, box, part, rod
from .kinds import Kind, Piece

WORDS = {
    "fr": {"Frame": "Châssis", "Base": "Bâti", "Bed": "Banc", "Table": "Table", "Gantry": "Portique", "Carriage": "Chariot", "Head": "Tête", "Saddle": "Chariot transversal", "Column": "Colonne", "Knee": "Console", "Spindle head": "Tête de broche", "Tool": "Outil"},
    "es": {"Frame": "Bastidor", "Base": "Base", "Bed": "Bancada", "Table": "Mesa", "Gantry": "Puente", "Carriage": "Carro", "Head": "Cabezal", "Saddle": "Carro transversal", "Column": "Columna", "Knee": "Consola", "Spindle head": "Cabezal", "Tool": "Herramienta"},
    "zh": {"Frame": "机架", "Base": "底座", "Bed": "床身", "Table": "工作台", "Gantry": "龙门", "Carriage": "滑座", "Head": "主轴箱", "Saddle": "床鞍", "Column": "立柱", "Knee": "升降台", "Spindle head": "主轴箱", "Tool": "刀具"},
    "ru": {"Frame": "Рама", "Base": "Основание", "Bed": "Станина", "Table": "Стол", "Gantry": "Портал", "Carriage": "Каретка", "Head": "Головка", "Saddle": "Салазки", "Column": "Колонна", "Knee": "Консоль", "Spindle head": "Шпиндельная бабка", "Tool": "Инструмент"},
    "ja": {"Frame": "フレーム", "Base": "ベース", "Bed": "ベッド", "Table": "テーブル", "Gantry": "ガントリー", "Carriage": "キャリッジ", "Head": "主軸頭", "Saddle": "サドル", "Column": "コラム", "Knee": "ニー", "Spindle head": "主軸頭", "Tool": "工具"},
}  # fmt: skip
PIECE = {"fr": "Pièce", "es": "Pieza", "zh": "零件", "ru": "Деталь", "ja": "部品"}


def _language(code):
    def write(doc, kind: Kind, folder=None):
        top = part(doc, "Assemblage" if code == "fr" else "A")
        n = 0
        for body, name in kind.bodies.items():
            best = max((w for w in WORDS[code] if w.lower() in name.lower()), key=len, default="")
            holder = part(
                doc,
                WORDS[code].get(best, f"{PIECE[code]} {body}" if len(body) == 1 and body != "F" else PIECE[code]),
                top,
            )
            for piece in kind.of(body):
                n += 1
                add(doc, f"{PIECE[code]} {n}", piece.shape, holder)

    write.__name__ = code
    return write


def imported(doc, kind: Kind, folder=None):
    """As STEP without names brings it: one level, names of FreeCAD's own, in the order of a stranger."""
    pieces = list(kind.pieces)
    random.Random(5).shuffle(pieces)
    for n, piece in enumerate(pieces):
        add(doc, ("Solid", f"Part__Feature{n:03d}", "COMPOUND", f"SOLID{n:03d}")[n % 4], piece.shape)


def scattered(doc, kind: Kind, folder=None):
    """Parts by their names, each .15 mm beside its place in all three directions: gaps and overlaps."""
    r = random.Random(11)
    for piece in kind.pieces:
        obj = add(doc, piece.label, piece.shape)
        obj.Placement.Base = V(*(r.uniform(-0.15, 0.15) for _ in range(3)))


def scattered_nameless(doc, kind: Kind, folder=None):
    """`scattered` without names."""
    scattered(doc, kind)
    for n, obj in enumerate(doc.Objects):
        obj.Label = f"Body{n:03d}"


def decorated(doc, kind: Kind, folder=None):
    """By names, with feet, panels, a cable chain, a control box, cables and two hundred screws."""
    for piece in kind.pieces:
        add(doc, piece.label, piece.shape)
    dressed(doc, kind)


def decorated_nameless(doc, kind: Kind, folder=None):
    """`decorated` with numbers for names; what is decoration bears none either."""
    decorated(doc, kind)
    for n, obj in enumerate(doc.Objects):
        obj.Label = f"Part {n:03d}"


def dressed(doc, kind: Kind):
    whole = App.BoundBox()
    for piece in kind.pieces:
        whole.add(piece.shape.BoundBox)
    x0, x1, y0, y1, z0, z1 = whole.XMin, whole.XMax, whole.YMin, whole.YMax, whole.ZMin, whole.ZMax
    for x in (x0 + 20, x1 - 20):
        for y in (y0 + 20, y1 - 20):
            add(doc, "Rubber foot", rod((x, y, z0 - 20), "z", 20, 15))
    for name, ranges in (("Enclosure left", ((x0 - 30, x0 - 26), (y0, y1), (z0, z1 + 80))), ("Enclosure right", ((x1 + 26, x1 + 30), (y0, y1), (z0, z1 + 80))),
                         ("Enclosure top", ((x0 - 30, x1 + 30), (y0, y1), (z1 + 80, z1 + 84)))):  # fmt: skip
        add(doc, name, box(*ranges))
    add(doc, "Control box", box((x1 + 30, x1 + 110), (y0, y0 + 200), (z0, z0 + 160)))
    moving = [p for p in kind.pieces if p.body != "F"]
    fixed = max(kind.of("F"), key=lambda p: p.shape.BoundBox.DiagonalLength).shape.BoundBox
    for body in [b for b in kind.bodies if b != "F"][:2]:
        other = max(kind.of(body), key=lambda p: p.shape.BoundBox.DiagonalLength).shape.BoundBox
        a, b = fixed.Center, other.Center
        add(doc, "Cable chain", box(*(tuple(sorted((p, q if abs(p - q) > 12 else p + 12))) for p, q in zip(a, b))))
    r = random.Random(3)
    for n in range(200):
        piece = r.choice(kind.pieces if n % 2 else moving).shape.BoundBox
        at = [r.uniform(lo, hi) for lo, hi in ((piece.XMin, piece.XMax), (piece.YMin, piece.YMax))]
        add(doc, f"M4x12 {n}", rod((*at, piece.ZMax - 8), "z", 12, 2))


def link_arrays(doc, kind: Kind, folder=None):
    """Equal parts of a body are one array of links; a LinkGroup holds each body."""
    for body, name in kind.bodies.items():
        members, groups = [], {}
        for piece in kind.of(body):
            groups.setdefault(
                (piece.label, round(piece.shape.Volume, 1), round(piece.shape.BoundBox.XLength, 2)), []
            ).append(piece)
        for (label, *_), pieces in groups.items():
            first = pieces[0].shape
            own = add(doc, f"{label} def", first)
            own.Visibility = False
            link = doc.addObject("App::Link", "L")
            link.LinkedObject, link.Label = own, label
            centre = first.BoundBox.Center
            if len(pieces) > 1:
                link.ElementCount = len(pieces)
                for element, piece in zip(link.ElementList, pieces):
                    element.Placement = App.Placement(piece.shape.BoundBox.Center - centre, App.Rotation())
            members.append(link)
        group = doc.addObject("App::LinkGroup", "G")
        group.Label, group.ElementList = name, members


def nested(doc, kind: Kind, folder=None):
    """Parts in parts in parts, each with a placement of its own."""
    top = part(doc, "Machine")
    top.Placement = App.Placement(V(100, 50, 0), App.Rotation())
    for n, (body, name) in enumerate(kind.bodies.items()):
        outer = part(doc, name, top)
        outer.Placement = App.Placement(V(10 * n, -20, 5), App.Rotation(V(0, 0, 1), 90 * (n % 2)))
        inner = part(doc, f"Sub {n}", outer)
        inner.Placement = App.Placement(V(0, 30, -7), App.Rotation())
        back = (top.Placement * outer.Placement * inner.Placement).inverse() * top.Placement
        for piece in kind.of(body):
            add(doc, piece.label, piece.shape, inner).Placement = back


def turned_nameless(doc, kind: Kind, folder=None):
    """One level, no names, all turned by 30 degrees about z in their placements."""
    for n, piece in enumerate(kind.pieces):
        obj = add(doc, f"Part__Feature{n:03d}", piece.shape)
        obj.Placement = App.Placement(V(50, 80, 0), App.Rotation(V(0, 0, 1), 30))


def named_bodies_only(doc, kind: Kind, folder=None):
    """A compound for each body whose name says little: "Assembly 1", a letter, "part"."""
    for n, body in enumerate(kind.bodies):
        add(doc, f"sub-assembly {n}", Part.makeCompound([p.shape for p in kind.of(body)]))


def no_spindle(doc, kind: Kind, folder=None):
    """A tree by body names, in which neither the tool nor the work is called anything."""
    top = part(doc, "CNC")
    for body, name in kind.bodies.items():
        holder = part(doc, name, top)
        for n, piece in enumerate(kind.of(body)):
            add(doc, f"item {n}", piece.shape, holder)


SPOILT = {f.__name__: f for f in (
    imported, scattered, scattered_nameless, decorated, decorated_nameless, link_arrays, nested, turned_nameless, named_bodies_only,
    no_spindle, *(_language(c) for c in WORDS))}  # fmt: skip
TURNED = {"turned_nameless": App.Rotation(V(0, 0, 1), 30)}

__all__ = ["SPOILT", "TURNED", "Piece"]
