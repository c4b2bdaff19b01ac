# SPDX-License-Identifier: LGPL-2.1-or-later
# ruff: noqa: E501 - tables that are read by column
"""Machines of plain parts, trees and links, that every version of FreeCAD can hold."""

from __future__ import annotations

import math

import FreeCAD as App
import Part

from . import Truth, V, add, block, bored, box, fused, offset_block, part, profile, rail, rod, vslot, wheel


def wooden_router(doc, folder, names=("Base", "Gantry", "Carriage", "Spindle")):
    """Four documents, four links: plywood base, gantry that straddles it, carriage in a channel, spindle on its slide."""

    def linked(name, shapes):
        own = App.newDocument(name)
        holder = part(own, name)
        for label, shape in shapes:
            add(own, label, shape, holder)
        own.recompute()
        own.saveAs(str(folder / f"{name}.FCStd"))
        link = doc.addObject("App::Link", name)
        link.LinkedObject = holder
        link.Label = name
        return own

    doc.saveAs(str(folder / f"{doc.Name}.FCStd"))
    made = [
        linked(names[0], [
            ("bottom", box((0, 600), (0, 900), (0, 18))), ("left side", box((0, 18), (0, 900), (18, 118))),
            ("right side", box((582, 600), (0, 900), (18, 118))), ("cross front", box((18, 582), (0, 18), (18, 100))),
            ("cross back", box((18, 582), (882, 900), (18, 100))),
            ("screw", rod((300, 20, 60), "y", 860, 6)),
        ]),
        linked(names[1], [
            ("left leg", fused(box((-18, 0), (300, 460), (60, 400)), box((0, 18), (300, 460), (118, 136)))),
            ("right leg", fused(box((600, 618), (300, 460), (60, 400)), box((582, 600), (300, 460), (118, 136)))),
            ("beam lower", box((0, 600), (380, 398), (240, 300))), ("beam upper", box((0, 600), (380, 398), (340, 400))),
            ("back", box((0, 600), (398, 416), (240, 400))),
        ]),
        linked(names[2], [
            ("plate", box((220, 380), (344, 362), (200, 440))), ("top runner", box((220, 380), (362, 398), (400, 418))),
            ("bottom runner", box((220, 380), (362, 398), (222, 240))),
            ("left way", profile([(230, 344), (250, 344), (246, 326), (226, 326)], "z", 160, 440)),
            ("right way", profile([(350, 344), (370, 344), (374, 326), (354, 326)], "z", 160, 440)),
        ]),
        linked(names[3], [
            ("slide", profile([(250, 344), (350, 344), (354, 326), (354, 310), (246, 310), (246, 326)], "z", 220, 380)),
            ("clamp", bored(box((265, 335), (220, 310), (250, 330)), (300, 265, 249), "z", 90, 32.5)),
            ("motor", rod((300, 265, 200), "z", 200, 32.5)), ("bit", rod((300, 265, 140), "z", 60, 3)),
        ]),
    ]  # fmt: skip
    doc.recompute()
    f, g, c, s = names
    return Truth("FYXZ", {"Y": (0, 1, 0), "X": (1, 0, 0), "Z": (0, 0, 1)},
                 {"F": {f}, "Y": {g}, "X": {c}, "Z": {s}}), made  # fmt: skip


def mill_tree(doc, german=True):
    """A knee mill with dovetails, as a STEP file brings it: a tree of parts, every solid called Solid."""
    names = ("Ständer", "Konsole", "Kreuzschlitten", "Tisch", "Fräskopf") if german else (
        "Column", "Knee", "Saddle", "Table", "Head")  # fmt: skip
    top = part(doc, "Fräsmaschine")
    column, knee, saddle, table, head = (part(doc, n, top) for n in names)
    dove = [(-50, 0), (50, 0), (70, 30), (-70, 30)]
    add(doc, "Solid", box((-150, 150), (0, 300), (0, 1200)), column)
    way = profile([(x, -y) for x, y in dove], "z", 150, 750)
    add(doc, "Solid001", way, column)
    add(doc, "Solid002", box((-250, 250), (-500, 400), (-60, 0)), column)
    add(
        doc,
        "Solid003",
        box((-60, 60), (-500, -300), (1000, 1200)).fuse(box((-60, 60), (-300, 300), (1000, 1200))),
        column,
    )
    body = box((-120, 120), (-450, 0), (300, 480)).cut(profile([(x, -y) for x, y in dove], "z", 299, 481))
    add(doc, "Solid004", body, knee)
    add(doc, "Solid005", profile([(x, 480 + y) for x, y in dove], "y", -450, -60), knee)
    add(
        doc,
        "Solid006",
        box((-130, 130), (-380, -180), (480, 560)).cut(profile([(x, 480 + y) for x, y in dove], "y", -381, -179)),
        saddle,
    )
    add(doc, "Solid007", profile([(-280 + y, 560 + z) for y, z in dove], "x", -130, 130), saddle)
    add(
        doc,
        "Solid008",
        box((-450, 450), (-380, -180), (560, 620)).cut(profile([(-280 + y, 560 + z) for y, z in dove], "x", -451, 451)),
        table,
    )
    add(doc, "Solid009", box((-60, 60), (-420, -300), (820, 1000)), head)
    add(doc, "Solid010", rod((0, -360, 760), "z", 60, 30), head)
    doc.recompute()
    return Truth("XYZF", {"X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)},
                 {"F": {"Solid", "Solid001"}, "Z": {"Solid004"}, "Y": {"Solid006"}, "X": {"Solid008"}})  # fmt: skip


def lathe(doc, folder=None, spline=False, screws=0):
    """A CNC lathe of links to parts that stand in the document; its spindle lies along the document's x."""
    library = part(doc, "Library")

    def link(label, shape):
        own = add(doc, label + "_src", shape, library)
        made = doc.addObject("App::Link", "L")
        made.LinkedObject, made.Label = own, label
        return made

    shape = (lambda s: s.toNurbs()) if spline else (lambda s: s)
    link("Bed", shape(box((-100, 900), (-120, 120), (0, 80))))
    link("Headstock", shape(bored(box((-100, 80), (-110, 110), (80, 300)), (-101, 0, 200), "x", 200, 60)))
    link("Spindle80", rod((-120, 0, 200), "x", 230, 60))
    link("Chuck160", rod((110, 0, 200), "x", 60, 80))
    for y, tail in ((-90, "1"), (90, "2")):
        link(f"HGR20-780 {tail}", shape(rail("x", (0, y, 80), 90, 870)))
        for n, x in enumerate((300, 400)):
            link(f"HGH20CA{tail}{n}", shape(block("x", (0, y, 80), x)))
        link(f"HGH20CA{tail}5", shape(block("x", (0, y, 80), 800)))
    link("Carriage plate", box((260, 440), (-120, 120), (108, 128)))
    link("Tailstock", box((760, 840), (-120, 120), (108, 260)))
    for x, tail in ((290, "1"), (410, "2")):
        link(f"HGR15-240 {tail}", shape(rail("y", (x, 0, 128), -120, 120)))
        link(f"HGW15CC{tail}1", shape(block("y", (x, 0, 128), -40, 25)))
        link(f"HGW15CC{tail}2", shape(block("y", (x, 0, 128), 40, 25)))
    link("Cross slide", box((260, 440), (-90, 90), (156, 172)))
    link("Toolpost", box((320, 380), (-80, -20), (172, 230)))
    link("SFU1605-700", rod((95, 0, 95), "x", 780, 8))
    link("DFU1605 nut", bored(box((330, 370), (-20, 20), (82, 108)), (329, 0, 95), "x", 42, 8))
    doc.recompute()
    return Truth("FZX", {"Z": (1, 0, 0), "X": (0, 1, 0)}, {"F": {"Bed", "Headstock"}, "Z": {"Carriage plate"},
                 "X": {"Cross slide"}}, {"Z": 780 - 160, "X": 240 - 130})  # fmt: skip


def extrusions(doc, screws=0, mesh=False):
    """A bridge of 2040 profiles on V-wheels: two rails along y, a beam along x, a Z with a lead screw and two shafts."""
    frame, bridge, cart, tool = (part(doc, n) for n in ("Frame", "Y Gantry", "X Cart", "Z Assembly"))
    for x in (0, 500):
        add(doc, "V-Slot 2040 800", vslot("y", (x, 0, 50), -400, 400), frame)
    for y in (-390, 390):
        add(doc, "V-Slot 2020 480", vslot("x", (0, y, 30), 0, 500), frame)
    for x, sign in ((0, -1), (500, 1)):
        face = x + sign * 14
        add(doc, "Gantry Plate", box(tuple(sorted((face, face + sign * 6))), (-60, 60), (20, 160)), bridge)
        for y in (-40, 40):
            for z in (72, 28):
                add(doc, "V-Wheel", wheel((x + sign * 7, y, z), "x"), bridge)
    add(doc, "V-Slot 2040 500", vslot("x", (0, 0, 140), -14, 514), bridge)
    add(doc, "Cart Plate", box((200, 300), (-20, -14), (80, 200)), cart)
    for x in (220, 280):
        for z in (162, 118):
            add(doc, "V-Wheel", wheel((x, -7, z), "y"), cart)
    add(
        doc,
        "Shaft Support SK8 top",
        bored(bored(box((205, 295), (-60, -20), (200, 215)), (225, -40, 199), "z", 20, 4), (275, -40, 199), "z", 20, 4),
        cart,
    )
    add(
        doc,
        "Shaft Support SK8 low",
        bored(bored(box((205, 295), (-60, -20), (20, 35)), (225, -40, 19), "z", 20, 4), (275, -40, 19), "z", 20, 4),
        cart,
    )
    add(doc, "Plate strut", box((205, 295), (-20, -14), (20, 80)), cart)
    for x in (225, 275):
        add(doc, "Smooth Rod 8x195", rod((x, -40, 20), "z", 195, 4), cart)
        add(doc, "LM8UU", bored(rod((x, -40, 100), "z", 24, 7.5), (x, -40, 99), "z", 30, 4), tool)
    hold = box((205, 295), (-90, -32), (98, 126))
    for x in (225, 275):
        hold = bored(hold, (x, -40, 97), "z", 40, 7.5)
    add(doc, "Spindle Mount", bored(hold, (250, -70, 97), "z", 40, 15), tool)
    add(doc, "Spindle", rod((250, -70, 60), "z", 110, 15), tool)
    for i in range(screws):
        bolt = Part.makeCylinder(2, 8, V(0, 0, 0)).fuse(Part.makeCylinder(3.5, 3, V(0, 0, 8))) if i == 0 else bolt  # noqa: F821
        made = add(doc, "M4x8 Screw", bolt, (frame, bridge, cart, tool)[i % 4])
        made.Placement.Base = V(*((500 * ((i * 7) % 10) / 10, -380 + 0.76 * i, 60), (-18, -50 + (i % 100), 30 + i / 12),
                                  (205 + i % 90, -20, 85 + i / 10), (210 + i % 80, -92, 100 + i / 60))[i % 4])  # fmt: skip
    if mesh:
        import MeshPart

        for name, label in (("Spindle", "Spindle"), ("Cart Plate", "Cart Plate")):
            old = next(o for o in doc.Objects if o.Label == name)
            new = doc.addObject("Mesh::Feature", "Mesh")
            new.Mesh = MeshPart.meshFromShape(Shape=old.Shape, LinearDeflection=0.2)
            old.getParentGeoFeatureGroup().addObject(new)
            doc.removeObject(old.Name)
            new.Label = label
    doc.recompute()
    return Truth("FYXZ", {"Y": (0, 1, 0), "X": (1, 0, 0), "Z": (0, 0, 1)},
                 {"F": {"V-Slot 2040 800"}, "Y": {"Gantry Plate", "V-Slot 2040 500"}, "X": {"Cart Plate"},
                  "Z": {"Spindle Mount"}})  # fmt: skip


def printer(doc):
    """A printer as a2plus leaves it where a2plus is not installed: four objects, each many solids in one skin list."""

    def whole(label, *shapes):
        obj = doc.addObject("Part::FeaturePython", "b_" + label)
        obj.Label = label
        obj.addProperty("App::PropertyString", "objectType").objectType = "a2pPart"
        obj.Shape = Part.makeCompound(list(shapes))
        return obj

    frame = [vslot("y", (x, 0, 0), -200, 200) for x in (-100, 100)]
    frame += [vslot("x", (0, y, -20), -110, 110) for y in (-190, 190)]
    frame += [vslot("z", (x, 20, 0), 10, 400) for x in (-160, 160)] + [vslot("x", (0, 20, 410), -170, 170)]
    frame += [vslot("x", (0, 20, 0), -170, -110), vslot("x", (0, 20, 0), 110, 170)]
    bed = [rod((x, -180, 25), "y", 360, 4) for x in (-60, 60)] + [box((-110, 110), (-110, 110), (45, 48))]
    bed += [bored(box((x - 17, x + 17), (y - 15, y + 15), (12, 45)), (x, y - 16, 25), "y", 32, 7.5)
            for x in (-60, 60) for y in (-60, 60)]  # fmt: skip
    z = [rod((x, 0, 30), "z", 350, 4) for x in (-140, 140)]
    z += [bored(box((x - 15, x + 15), (-20, 20), (180, 230)), (x, 0, 179), "z", 60, 7.5) for x in (-140, 140)]
    x = [rod((-140, -10, h), "x", 280, 4) for h in (190, 220)] + [box((-25, 25), (-40, -22), (160, 240))]
    x += [rod((0, -31, 130), "z", 40, 6)]
    whole("full_frame", *frame)
    whole("y_axis_assembly", *bed)
    whole("z_axis_assembly", *z)
    whole("x_axis_assembly", *x)
    for n, (a, b) in enumerate(
        (("full_frame", "y_axis_assembly"), ("full_frame", "z_axis_assembly"), ("z_axis_assembly", "x_axis_assembly"))
    ):
        con = doc.addObject("App::FeaturePython", f"planeCoincident_{n:03d}")
        for prop, value in (
            ("Object1", "b_" + a),
            ("Object2", "b_" + b),
            ("SubElement1", "Face1"),
            ("SubElement2", "Face1"),
        ):
            con.addProperty("App::PropertyString", prop)
            setattr(con, prop, value)
    doc.recompute()
    return Truth("YFZX", {"Y": (0, 1, 0), "X": (1, 0, 0), "Z": (0, 0, 1)},
                 {"F": {"full_frame"}, "Y": {"y_axis_assembly"}, "Z": {"z_axis_assembly"}, "X": {"x_axis_assembly"}})  # fmt: skip


def c_frame(doc, offset=False):
    """One compound of seven nameless solids: a C-frame with its rails fused on, table on saddle, head on the column."""
    bed = fused(box((-200, 200), (-500, 200), (0, 100)), box((-150, 150), (0, 200), (100, 900)),
                rail("y", (-100, 0, 100), -480, -20), rail("y", (100, 0, 100), -480, -20),
                rail("z", (-100, 0, 0), 400, 880, "y", -1), rail("z", (100, 0, 0), 400, 880, "y", -1))  # fmt: skip
    saddle = fused(box((-160, 160), (-360, -160), (128, 160)), *(block("y", (x, 0, 100), y) for x in (-100, 100) for y in (-320, -200)),
                   rail("x", (0, -320, 160), -160, 160), rail("x", (0, -200, 160), -160, 160))  # fmt: skip
    table = fused(
        box((-300, 300), (-380, -140), (188, 220)),
        *(block("x", (0, y, 160), x) for y in (-320, -200) for x in (-80, 80)),
    )
    head = fused(
        box((-150, 150), (-300, -28), (560, 760)),
        *(block("z", (x, 0, 0), z, 30, "y", -1) for x in (-100, 100) for z in (600, 720)),
    )
    spindle = fused(rod((0, -220, 480), "z", 80, 45), rod((0, -220, 420), "z", 60, 8))
    solids = [bed, saddle, table, head, spindle]
    if offset:
        made = offset_block()
        made.translate(V(-20, -260, 220))
        solids += [made, Part.makeSphere(15, V(60, -260, 235))]
    add(doc, "Import", Part.makeCompound(solids))
    doc.recompute()
    return Truth("XYFZ", {"X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}, {}, {"Y": 460, "X": 320, "Z": 480})


def delta(doc):
    """Three towers, three carriages, six arms, one effector."""
    for k in range(3):
        a = math.radians(90 + 120 * k)
        x, y = 150 * math.cos(a), 150 * math.sin(a)
        add(doc, f"Tower {'ABC'[k]}", vslot("z", (x, y, 0), 0, 600))
        add(
            doc,
            f"Carriage {'ABC'[k]}",
            bored(box((x - 20, x + 20), (y - 20, y + 20), (350, 390)), (x, y, 349), "z", 50, 14.5),
        )
        for s in (-15, 15):
            start = V(x * 0.85 - s * math.sin(a), y * 0.85 + s * math.cos(a), 360)
            end = V(25 * math.cos(a) - s * math.sin(a), 25 * math.sin(a) + s * math.cos(a), 150)
            add(doc, "Arm", Part.makeCylinder(3, (end - start).Length, start, end - start))
    add(doc, "Effector", Part.makeCylinder(35, 10, V(0, 0, 140)))
    add(doc, "Base", Part.makeCylinder(200, 12, V(0, 0, -12)))
    add(doc, "Hotend", rod((0, 0, 90), "z", 50, 6))
    doc.recompute()
    return Truth(None, kind="parallel")


def robot(doc):
    """A jointed arm: nothing in it moves along a line."""
    add(doc, "Robot base", rod((0, 0, 0), "z", 100, 100))
    add(doc, "Shoulder J1", rod((0, 0, 100), "z", 80, 80))
    add(doc, "Upper arm J2", box((-40, 40), (-30, 30), (180, 520)))
    add(doc, "Elbow J3", rod((-60, 0, 520), "x", 120, 50))
    add(doc, "Forearm J4", box((40, 420), (-30, 30), (490, 550)))
    add(doc, "Wrist J5", rod((450, -40, 520), "y", 80, 35))
    add(doc, "Gripper", box((480, 560), (-20, 20), (500, 540)))
    doc.recompute()
    return Truth(None)


def portal(doc, language="fr"):
    """A portal mill whose table moves: French names, App::Parts, profile rails, a rotary table on the table."""
    names = {"fr": ("Bâti", "Table X", "Portique", "Chariot Y", "Broche Z"), "ko": ("베드", "X축 테이블", "컬럼", "Y축 새들", "Z축 주축두"),
             "zh": ("床身", "X轴工作台", "立柱", "Y轴滑座", "Z轴主轴箱"), "it": ("Basamento", "Tavola X", "Portale", "Carrello Y", "Testa Z"),
             "es": ("Bastidor", "Mesa X", "Puente", "Carro Y", "Cabezal Z")}[language]  # fmt: skip
    bed, table, bridge, cross, head = (part(doc, n) for n in names)
    add(doc, "a", box((-700, 700), (-300, 300), (0, 200)), bed)
    for y in (-200, 200):
        add(doc, "b", rail("x", (0, y, 200), -650, 650), bed)
        for x in (-200, 200):
            add(doc, "c", block("x", (0, y, 200), x), table)
    add(doc, "d", box((-300, 300), (-250, 250), (228, 270)), table)
    add(doc, "Plateau tournant" if language == "fr" else "Rotary table", rod((0, 0, 270), "z", 40, 120), table)
    add(
        doc,
        "e",
        fused(
            box((300, 420), (-420, -300), (0, 800)),
            box((300, 420), (300, 420), (0, 800)),
            box((300, 420), (-420, 420), (600, 800)),
        ),
        bridge,
    )
    for z in (640, 760):
        add(doc, "f", rail("y", (300, 0, z), -400, 400, "x", -1), bridge)
        for y in (-60, 60):
            add(doc, "g", block("y", (300, 0, z), y, 30, "x", -1), cross)
    add(doc, "h", box((240, 272), (-120, 120), (560, 820)), cross)
    for y in (-80, 80):
        add(doc, "i", rail("z", (240, y, 0), 520, 820, "x", -1), cross)
        for z in (620, 720):
            add(doc, "j", block("z", (240, y, 0), z, 30, "x", -1), head)
    add(doc, "k", box((180, 212), (-110, 110), (580, 760)), head)
    add(doc, "l", rod((140, 0, 500), "z", 260, 40), head)
    doc.recompute()
    return Truth("XFYZ", {"X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)},
                 {"F": {"a", "e"}, "X": {"d"}, "Y": {"h"}, "Z": {"k"}},
                 {"X": 1300 - 460, "Y": 800 - 180, "Z": 300 - 160})  # fmt: skip
