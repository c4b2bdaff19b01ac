# SPDX-License-Identifier: LGPL-2.1-or-later
# ruff: noqa: E501 - tables that are read by column
"""Machines as unlike people draw them, of random sizes: printers, routers of tubes and wood, mills, cutters.

Each takes a `random.Random` and returns a `Kind`; `writers` puts it into a document, `spoilt` makes it worse.
"""

from __future__ import annotations

from . import bored, box, fused, profile, rod, vslot
from .fittings import bearing, block, dove, motor, rail, sbr_block, sbr_rail, tube, wheels
from .kinds import XYZ, Kind, Piece, Truth


def bed_slinger(r) -> Kind:
    """A printer of 2020 and 2040 profiles with V-wheels: the bed along y, the bar along z, the head along x."""
    w, d, h = r.randint(320, 420), r.randint(320, 440), r.randint(380, 500)
    p = [
        Piece("F", "2040 base left", box((-w / 2, -w / 2 + 40), (-d / 2, d / 2), (0, 20))),
        Piece("F", "2040 base right", box((w / 2 - 40, w / 2), (-d / 2, d / 2), (0, 20))),
    ]
    for y in (-d / 2 + 10, d / 2 - 10):
        p.append(Piece("F", "2020 cross", vslot("x", (0, y, 10), -w / 2 + 40, w / 2 - 40)))
    p.append(Piece("F", "Y extrusion 2040", vslot("y", (0, 0, 40), -d / 2, d / 2, 40)))
    for x in (-w / 2 + 30, w / 2 - 30):
        p.append(Piece("F", "Upright 2040", box((x - 10, x + 10), (30, 70), (20, h))))
    p.append(Piece("F", "Top 2020", vslot("x", (0, 50, h + 10), -w / 2 + 20, w / 2 - 20)))
    for x, sign in ((-20, -1), (20, 1)):
        p += [Piece("Y", "V wheel", s) for s in wheels((x + sign * 8, 0, 40), "y", 35, "z")]
    p.append(Piece("Y", "Bed carriage plate", box((-60, 60), (-70, 70), (68, 72))))
    p += [Piece("Y", "Bed spring", rod((x, y, 72), "z", 18, 5)) for x in (-50, 50) for y in (-60, 60)]
    p.append(Piece("Y", "Heated bed", box((-115, 115), (-115, 115), (90, 93))))
    z = 20 + 0.5 * h
    for x, sign in ((-w / 2 + 30, -1), (w / 2 - 30, 1)):
        for dy in (-28, 28):
            p += [Piece("Z", "V wheel", s) for s in wheels((x, 50 + dy, z), "z", 20, "x")]
        plate = x + sign * 16
        p.append(
            Piece(
                "Z",
                "Z plate",
                box((min(plate, plate + 4 * sign), max(plate, plate + 4 * sign)), (0, 100), (z - 40, z + 40)),
            )
        )
    p.append(Piece("Z", "X gantry 2020", vslot("x", (0, -10, z), -w / 2 + 6, w / 2 - 6)))
    p += [
        Piece("Z", "Gantry bracket", box((s * (w / 2 - 10) - 8, s * (w / 2 - 10) + 8), (0, 20), (z - 10, z + 10)))
        for s in (-1, 1)
    ]
    for dz in (-18, 18):
        p += [Piece("X", "V wheel", s) for s in wheels((20, -10, z + dz), "x", 22, "y")]
    p.append(Piece("X", "X carriage plate", box((-15, 55), (-26, -22), (z - 32, z + 32))))
    p.append(Piece("X", "Hotend fan shroud", box((0, 40), (-70, -26), (z - 25, z + 25))))
    p.append(Piece("X", "E3D nozzle", rod((20, -48, z - 45), "z", 20, 4)))
    p.append(Piece("F", "T8 leadscrew", rod((-w / 2 + 55, 50, 25), "z", h - 60, 4)))
    p.append(
        Piece("Z", "T8 nut", bored(rod((-w / 2 + 55, 50, z - 6), "z", 12, 9), (-w / 2 + 55, 50, z - 7), "z", 14, 4))
    )
    p.append(Piece("F", "Z stepper NEMA17", motor((-w / 2 + 55, 50, 25), "z", -40)))
    return Kind(Truth("YFZX", XYZ), p, {"F": "Frame", "Y": "Bed", "Z": "X gantry", "X": "Extruder carriage"})


def rod_printer(r) -> Kind:
    """A printer of smooth rods and printed parts: bed along y, two rods upright, two rods along x."""
    w, d, h = r.randint(360, 440), r.randint(340, 420), r.randint(360, 460)
    k, ry = 4, 0.5 * d
    p = [
        Piece(
            "F",
            "Frame plate",
            box((-w / 2, w / 2), (60, 66), (0, h)).cut(box((-w / 2 + 60, w / 2 - 60), (59, 67), (25, h - 60))),
        ),
    ]
    for y in (-ry, ry):
        p.append(Piece("F", "M10 threaded rod frame", rod((-w / 2 + 40, y, 20), "x", w - 80, 5)))
    for x in (-85, 85):
        for y in (-ry, ry):
            p.append(
                Piece(
                    "F",
                    "y-corner",
                    bored(
                        bored(box((x - 14, x + 14), (y - 14, y + 14), (5, 60)), (x, y - 15, 48), "y", 30, k),
                        (x - 15, y, 20),
                        "x",
                        30,
                        5,
                    ),
                )
            )
        p.append(Piece("F", "Y smooth rod 8mm", rod((x, -ry - 10, 48), "y", 2 * ry + 20, k)))
        p.append(Piece("F", "M10 threaded rod long", rod((x * 1.2 + (20 if x > 0 else -20), -ry, 32), "y", 2 * ry, 5)))
    for x, y in ((-85, 50), (-85, -50), (85, 0)):
        p.append(Piece("Y", "LM8UU", bored(rod((x, y - 12, 48), "y", 24, 7.5), (x, y - 13, 48), "y", 26, k)))
        p.append(
            Piece(
                "Y",
                "y bearing holder",
                bored(box((x - 12, x + 12), (y - 13, y + 13), (40, 60)), (x, y - 14, 48), "y", 28, 7.5),
            )
        )
    p.append(Piece("Y", "y carriage", box((-110, 110), (-110, 110), (60, 66))))
    p.append(Piece("Y", "Heatbed MK2", box((-107, 107), (-107, 107), (72, 75))))
    p += [Piece("Y", "Bed spacer M3", rod((x, y, 66), "z", 6, 4)) for x in (-100, 100) for y in (-100, 100)]
    z = 0.5 * h
    for s in (-1, 1):
        x = s * (w / 2 - 25)
        p.append(Piece("F", "z-axis-bottom", bored(box((x - 22, x + 22), (5, 60), (50, 62)), (x, 40, 49), "z", 14, k)))
        p.append(
            Piece("F", "z-axis-top", bored(box((x - 22, x + 22), (5, 60), (h - 14, h)), (x, 40, h - 15), "z", 16, k))
        )
        p.append(Piece("F", "Z smooth rod 8mm", rod((x, 40, 50), "z", h - 50, k)))
        p.append(Piece("F", "Z lead screw", rod((x - 17 * s, 40, 62), "z", h - 90, 4)))
        end = bored(box((x - 24, x + 24), (14, 58), (z - 30, z + 30)), (x, 40, z - 31), "z", 62, 7.5)
        for dz in (-22.5, 22.5):
            end = bored(end, (x - 25, 25, z + dz), "x", 50, k)
        p.append(
            Piece("Z", "x-end-idler" if s < 0 else "x-end-motor", bored(end, (x - 17 * s, 40, z - 31), "z", 62, 5))
        )
        for dz in (-24, 2):
            p.append(Piece("Z", "LM8UU", bored(rod((x, 40, z + dz), "z", 22, 7.5), (x, 40, z + dz - 1), "z", 24, k)))
    for dz in (-22.5, 22.5):
        p.append(Piece("Z", "X smooth rod 8mm", rod((-w / 2 + 10, 25, z + dz), "x", w - 20, k)))
        p.append(Piece("X", "LM8UU", bored(rod((-12, 25, z + dz), "x", 24, 7.5), (-13, 25, z + dz), "x", 26, k)))
    body = box((-30, 30), (8, 30), (z - 34, z + 34))
    for dz in (-22.5, 22.5):
        body = bored(body, (-31, 25, z + dz), "x", 62, 7.5)
    p.append(Piece("X", "x-carriage", body))
    p.append(Piece("X", "extruder body", box((-25, 25), (-40, 8), (z - 25, z + 35))))
    p.append(Piece("X", "hotend", rod((0, -15, z - 60), "z", 35, 8)))
    p.append(Piece("F", "PSU", box((w / 2 - 10, w / 2 + 40), (66, 170), (20, 220))))
    return Kind(Truth("YFZX", XYZ), p, {"F": "frame", "Y": "y-axis", "Z": "x-axis ends", "X": "x-carriage"})


def core_xy(r) -> Kind:
    """A cube of 2020 profiles: the bed rises on rods and lead screws, bar and head run on MGN12, belts go round."""
    w, d, h = r.randint(380, 500), r.randint(380, 500), r.randint(400, 560)
    a, b = w / 2 - 10, d / 2 - 10
    p = [Piece("F", "Extrusion 2020", vslot("z", (x, y, 0), 0, h)) for x in (-a, a) for y in (-b, b)]
    for z in (10, h - 10):
        p += [Piece("F", "Extrusion 2020", vslot("x", (0, y, z), -a + 10, a - 10)) for y in (-b, b)]
        p += [Piece("F", "Extrusion 2020", vslot("y", (x, 0, z), -b + 10, b - 10)) for x in (-a, a)]
    y0, zt = r.randint(-60, 60), h
    for x in (-a, a):
        p.append(Piece("F", "MGN12 rail", rail("y", (x, 0, zt), -b + 20, b - 20, k=0.6)))
        p.append(Piece("Y", "MGN12H carriage", block("y", (x, 0, zt), y0, 22, k=0.6)))
        p.append(Piece("Y", "XY joiner", box((x - 22, x + 22), (y0 - 25, y0 + 25), (zt + 16.8, zt + 24))))
    p.append(Piece("Y", "X extrusion 2020", vslot("x", (0, y0, zt + 34), -a - 15, a + 15)))
    p.append(Piece("Y", "MGN12 rail X", rail("x", (0, y0, zt + 44), -a + 25, a - 25, k=0.6)))
    p.append(Piece("X", "MGN12H carriage X", block("x", (0, y0, zt + 44), 30, 22, k=0.6)))
    p.append(
        Piece(
            "X",
            "Toolhead mount",
            fused(
                box((5, 55), (y0 - 20, y0 + 20), (zt + 60.8, zt + 66)), box((5, 55), (y0 - 26, y0 - 20), (zt, zt + 66))
            ),
        )
    )
    p.append(Piece("X", "Hotend", rod((30, y0 - 40, zt - 40), "z", 60, 10)))
    p.append(
        Piece(
            "X",
            "Hotend clamp",
            bored(box((12, 48), (y0 - 55, y0 - 26), (zt, zt + 15)), (30, y0 - 40, zt - 1), "z", 17, 10),
        )
    )
    p += [Piece("F", "GT2 belt", box((x - 3, x + 3), (-b, b), (zt + 26, zt + 32))) for x in (-a + 40, a - 40)]
    zb = 0.45 * h
    for x in (-a + 30, a - 30):
        for y in (-60, 60):
            p.append(Piece("F", "Smooth rod 10mm", rod((x, y, 20), "z", h - 40, 5)))
            p.append(
                Piece(
                    "F", "Rod holder", bored(box((x - 15, x + 15), (y - 15, y + 15), (20, 34)), (x, y, 19), "z", 16, 5)
                )
            )
            p.append(
                Piece(
                    "F",
                    "Rod holder",
                    bored(
                        box((x - 20, x + 15) if x > 0 else (x - 15, x + 20), (y - 15, y + 15), (h - 34, h - 20)),
                        (x, y, h - 35),
                        "z",
                        16,
                        5,
                    ),
                )
            )
            p.append(Piece("Z", "LM10UU", bored(rod((x, y, zb - 15), "z", 29, 9.5), (x, y, zb - 16), "z", 31, 5)))
            p.append(
                Piece(
                    "Z",
                    "Bed bearing mount",
                    bored(box((x - 14, x + 14), (y - 16, y + 16), (zb - 10, zb + 10)), (x, y, zb - 11), "z", 22, 9.5),
                )
            )
        p.append(Piece("F", "Lead screw Tr8x8", rod((x, 0, 25), "z", h - 70, 4)))
        p.append(Piece("Z", "Lead screw nut", bored(rod((x, 0, zb - 8), "z", 16, 11), (x, 0, zb - 9), "z", 18, 4)))
        p.append(Piece("F", "NEMA17", motor((x, 0, 25), "z", -40)))
        p.append(Piece("Z", "Bed frame 2020 side", vslot("y", (x * 0.8, 0, zb + 20), -110, 110)))
        p.append(
            Piece(
                "Z",
                "Bed arm",
                box((min(x * 0.8, x) - 12, max(x * 0.8, x) + 12), (-80, 80), (zb + 10, zb + 10.001)).fuse(
                    box((min(x * 0.8, x) - 12, max(x * 0.8, x) + 12), (-80, 80), (zb + 4, zb + 10))
                ),
            )
        )
    p += [
        Piece("Z", "Bed frame 2020 cross", vslot("x", (0, y, zb + 20), -(a - 30) * 0.8 + 10, (a - 30) * 0.8 - 10))
        for y in (-70, 70)
    ]
    p.append(Piece("Z", "Print bed", box((-140, 140), (-140, 140), (zb + 30, zb + 36))))
    p.append(Piece("F", "Back panel", box((-a, a), (b + 10, b + 14), (0, h))))
    return Kind(Truth("ZFYX", XYZ), p, {"F": "Frame", "Y": "Y gantry", "X": "Print head", "Z": "Bed assembly"})


def flying_gantry(r) -> Kind:
    """A cube whose bed stands: the bridge rises on four rails, a bar runs along y on it, the head along x."""
    w, h = r.randint(400, 480), r.randint(420, 520)
    a, z = w / 2 - 10, 0.55 * h
    p = [Piece("F", "2020 Z", vslot("z", (x, y, 0), 0, h)) for x in (-a, a) for y in (-a, a)]
    for q in (10, h - 10):
        p += [Piece("F", "2020 A", vslot("x", (0, y, q), -a + 10, a - 10)) for y in (-a, a)]
        p += [Piece("F", "2020 B", vslot("y", (x, 0, q), -a + 10, a - 10)) for x in (-a, a)]
    p.append(Piece("F", "2020 bed support", vslot("y", (-80, 0, 10), -a + 10, a - 10)))
    p.append(Piece("F", "2020 bed support", vslot("y", (80, 0, 10), -a + 10, a - 10)))
    p.append(Piece("F", "Build plate", box((-150, 150), (-150, 150), (20, 28))))
    for x in (-a, a):
        for y, sign in ((-a, 1), (a, -1)):
            p.append(Piece("F", "MGN9 Z", rail("z", (x, y + sign * 10, 0), 30, h - 30, "y", sign, k=0.45)))
            p.append(Piece("Z", "MGN9H Z", block("z", (x, y + sign * 10, 0), z, 20, "y", sign, k=0.45)))
            e = y + sign * (10 + 12.6)
            p.append(Piece("Z", "Z joint", box((x - 15, x + 15), tuple(sorted((e, e + sign * 14))), (z - 22, z + 22))))
    b = a - 10 - 12.6 - 14
    for x in (-a, a):
        p.append(Piece("Z", "2020 gantry side", vslot("y", (x, 0, z), -b, b)))
        sx = 1 if x < 0 else -1
        p.append(Piece("Z", "MGN9 Y", rail("y", (x + sx * 10, 0, z), -b + 20, b - 20, "x", sx, k=0.45)))
        p.append(Piece("Y", "MGN9H Y", block("y", (x + sx * 10, 0, z), 15, 20, "x", sx, k=0.45)))
        e = x + sx * 22.6
        p.append(Piece("Y", "XY joint", box(tuple(sorted((e, e + sx * 20))), (-15, 45), (z - 15, z + 15))))
    c = a - 42.6
    p.append(Piece("Y", "2020 X bar", vslot("x", (0, 15, z), -c, c)))
    p.append(Piece("Y", "MGN12 X", rail("x", (0, 5, z), -c + 15, c - 15, "y", -1, k=0.6)))
    p.append(Piece("X", "MGN12H X", block("x", (0, 5, z), -20, 22, "y", -1, k=0.6)))
    p.append(Piece("X", "Toolhead body", box((-45, 5), (-45, -11.8), (z - 40, z + 30))))
    p.append(Piece("X", "Nozzle", rod((-20, -30, z - 60), "z", 20, 4)))
    return Kind(Truth("FZYX", XYZ), p, {"F": "Frame", "Z": "Gantry", "Y": "X beam", "X": "Toolhead"})


def plywood_router(r) -> Kind:
    """A gantry router on supported round rails, its sides of plywood, with a torsion box."""
    w, d = r.randint(600, 900), r.randint(700, 1200)
    p = [Piece("F", "Torsion box", box((-w / 2, w / 2), (-d / 2, d / 2), (0, 80)))]
    x0, y0 = w / 2 - 40, r.randint(-150, 150)
    for s in (-1, 1):
        p.append(Piece("F", "SBR16 rail", sbr_rail("y", (s * x0, 0, 80), -d / 2 + 10, d / 2 - 10)))
        p += [Piece("Y", "SBR16UU", sbr_block("y", (s * x0, 0, 80), y0 + dy)) for dy in (-60, 60)]
        p.append(Piece("Y", "Gantry foot", box((s * x0 - 40, s * x0 + 40), (y0 - 90, y0 + 90), (125, 143))))
        side = s * (x0 + 22)
        p.append(Piece("Y", "Gantry side", box((side - 9, side + 9), (y0 - 90, y0 + 60), (143, 420))))
    in_ = x0 + 13
    p.append(Piece("Y", "Gantry beam front", box((-in_, in_), (y0 - 20, y0 - 2), (230, 400))))
    p.append(Piece("Y", "Gantry beam top", box((-in_, in_), (y0 - 2, y0 + 60), (382, 400))))
    for z in (255, 375):
        p.append(Piece("Y", "SBR16 rail", sbr_rail("x", (0, y0 - 20, z), -in_ + 10, in_ - 10, "y", -1)))
        p += [Piece("X", "SBR16UU", sbr_block("x", (0, y0 - 20, z), 40 + dx, "y", -1)) for dx in (-50, 50)]
    p.append(Piece("X", "X plate", box((-50, 130), (y0 - 83, y0 - 65), (220, 410))))
    for x in (-20, 100):
        p.append(Piece("X", "SBR12 rail", sbr_rail("z", (x, y0 - 83, 0), 225, 405, "y", -1, k=0.8)))
        p += [Piece("Z", "SBR12UU", sbr_block("z", (x, y0 - 83, 0), zz, "y", -1, k=0.8)) for zz in (275, 330)]
    f = y0 - 83 - 36
    p.append(Piece("Z", "Z plate", box((-45, 125), (f - 15, f), (240, 370))))
    p.append(Piece("Z", "Mount", bored(box((0, 80), (f - 95, f - 15), (280, 330)), (40, f - 55, 279), "z", 52, 26)))
    p.append(Piece("Z", "Router", rod((40, f - 55, 200), "z", 210, 26)))
    p.append(Piece("F", "SFU1605", rod((0, -d / 2 + 5, 100), "y", d - 10, 8)))
    p.append(
        Piece(
            "Y", "SFU1605 nut block", bored(box((-26, 26), (y0 - 40, y0 + 4), (82, 118)), (0, y0 - 41, 100), "y", 46, 8)
        )
    )
    p.append(Piece("Y", "Nut arm", box((-in_, in_), (y0 - 60, y0 + 60), (118, 125))))
    return Kind(
        Truth("FYXZ", XYZ, travel={"Y": d - 20 - 165, "X": 2 * in_ - 20 - 145}),
        p,
        {"F": "Base", "Y": "Gantry", "X": "X carriage", "Z": "Z axis"},
    )


def tube_router(r) -> Kind:
    """A router of conduit tubes: printed corners, rollers on bearings, two crossing beams that share one core."""
    a, q, h = r.randint(280, 420), r.choice((11.5, 12.5, 12.7, 15.0)), r.randint(120, 200)
    p = []
    for x in (-a, a):
        for y in (-a, a):
            corner = bored(
                bored(box((x - 24, x + 24), (y - 24, y + 24), (h - 30, h + 62)), (x - 25, y, h), "x", 50, q),
                (x, y - 25, h + 32),
                "y",
                50,
                q,
            )
            p += [
                Piece("F", "Corner", corner),
                Piece("F", "Leg tube", tube((x, y, 0), "z", h - 30, q)),
                Piece("F", "Foot", box((x - 30, x + 30), (y - 30, y + 30), (-12, 0))),
            ]
    p += [Piece("F", "Conduit X", tube((-a - 20, y, h), "x", 2 * a + 40, q)) for y in (-a, a)]
    p += [Piece("F", "Conduit Y", tube((x, -a - 20, h + 32), "y", 2 * a + 40, q)) for x in (-a, a)]
    x0, y0 = r.randint(-90, 90), r.randint(-90, 90)
    for y in (-a, a):  # rollers on the tubes along x carry the beam along y
        body = bored(box((x0 - 40, x0 + 40), (y - 26, y + 26), (h - 28, h + 52)), (x0 - 41, y, h), "x", 82, q + 5)
        p.append(Piece("X", "Roller", bored(body, (x0, y - 27, h + 32), "y", 54, q)))
        for dx in (-30, 30):
            p += [Piece("X", "Bearing 608", bearing((x0 + dx, y, h + s * (q + 11)), "y", 11)) for s in (-1, 1)]
    p.append(Piece("X", "Beam tube Y", tube((x0, -a - 25, h + 32), "y", 2 * a + 50, q)))
    for x in (-a, a):
        body = bored(box((x - 26, x + 26), (y0 - 40, y0 + 40), (h - 22, h + 60)), (x, y0 - 41, h + 32), "y", 82, q + 5)
        p.append(Piece("Y", "Roller", bored(body, (x - 27, y0, h), "x", 54, q)))
        for dy in (-30, 30):
            p += [Piece("Y", "Bearing 608", bearing((x, y0 + dy, h + 32 + s * (q + 11)), "x", 11)) for s in (-1, 1)]
    p.append(Piece("Y", "Beam tube X", tube((-a - 25, y0, h), "x", 2 * a + 50, q)))
    core = bored(
        bored(box((x0 - 45, x0 + 45), (y0 - 45, y0 + 45), (h - 30, h + 62)), (x0 - 46, y0, h), "x", 92, q + 5),
        (x0, y0 - 46, h + 32),
        "y",
        92,
        q + 5,
    )
    zs = [(x0 - 33, y0 - 33), (x0 + 33, y0 - 33)]
    for zx, zy in zs:
        core = bored(core, (zx, zy, h - 31), "z", 94, min(q, 10) + 0.2)
    p.append(Piece("Y", "Core", core))
    for dx in (-30, 30):
        p += [Piece("Y", "Bearing 608", bearing((x0 + dx, y0, h + s * (q + 11)), "y", 11)) for s in (-1, 1)]
        p += [Piece("Y", "Bearing 608", bearing((x0, y0 + dx, h + 32 + s * (q + 11)), "x", 11)) for s in (-1, 1)]
    p += [Piece("Z", "Z tube", tube((zx, zy, h - 120), "z", 320, min(q, 10))) for zx, zy in zs]
    plate = box((x0 - 50, x0 + 50), (y0 - 50, y0 - 15), (h - 130, h - 100))
    for zx, zy in zs:
        plate = bored(plate, (zx, zy, h - 120), "z", 21, min(q, 10))
    p.append(Piece("Z", "Tool mount", bored(plate, (x0, y0 - 33, h - 131), "z", 32, 18)))
    p.append(Piece("Z", "Dremel", rod((x0, y0 - 33, h - 190), "z", 150, 18)))
    return Kind(
        Truth("FXYZ", XYZ, either=("FYXZ",)),
        p,
        {"F": "Frame", "X": "X rollers", "Y": "Y rollers and core", "Z": "Z tool"},
    )


def steel_router(r) -> Kind:
    """A gantry router welded of square tube with profile rails, its screws and motors, nut housings and supports."""
    w, d, s = r.randint(700, 1000), r.randint(900, 1400), r.choice((50, 60))
    p = [
        Piece(
            "F",
            "Tube 50x50 long",
            fused(
                box((x - s / 2, x + s / 2), (-d / 2, d / 2), (0, s)),
                box((x - s / 2, x + s / 2), (-d / 2, d / 2), (s, s + 6)),
            ),
        )
        for x in (-w / 2, w / 2)
    ]
    p += [
        Piece("F", "Tube 50x50 cross", box((-w / 2 + s / 2, w / 2 - s / 2), (y - s / 2, y + s / 2), (0, s)))
        for y in (-d / 2 + s, 0, d / 2 - s)
    ]
    z0, y0 = s + 6, r.randint(-200, 200)
    for x in (-w / 2, w / 2):
        p.append(Piece("F", f"HGR20-{d - 60}", rail("y", (x, 0, z0), -d / 2 + 30, d / 2 - 30)))
        p += [Piece("Y", "HGH20CA", block("y", (x, 0, z0), y0 + dy)) for dy in (-90, 90)]
        p.append(Piece("Y", "Roller plate", box((x - 50, x + 50), (y0 - 130, y0 + 130), (z0 + 28, z0 + 38))))
        p.append(Piece("Y", "Riser", box((x - s / 2, x + s / 2), (y0 - s, y0 + s), (z0 + 38, z0 + 138))))
        sx = x - (45 if x > 0 else -45)
        p.append(Piece("F", "SFU1610", rod((sx, -d / 2, z0 + 12), "y", d, 8)))
        p.append(
            Piece(
                "F",
                "BK12",
                bored(
                    box((sx - 20, sx + 20), (-d / 2, -d / 2 + 25), (s, z0 + 34)), (sx, -d / 2 - 1, z0 + 12), "y", 27, 8
                ),
            )
        )
        p.append(
            Piece(
                "Y",
                "DSG16H nut housing",
                bored(
                    box((sx - 20, sx + 20), (y0 - 20, y0 + 20), (z0 - 8, z0 + 28)), (sx, y0 - 21, z0 + 12), "y", 42, 8
                ),
            )
        )
        p.append(Piece("F", "NEMA23", motor((sx, -d / 2, z0 + 12), "y", -56, 28)))
    b = z0 + 138
    p.append(Piece("Y", "Beam 100x50", box((-w / 2 - s / 2, w / 2 + s / 2), (y0 - s / 2, y0 + s / 2), (b, b + 100))))
    for z in (b + 15, b + 85):
        p.append(Piece("Y", "HGR20-X", rail("x", (0, y0 - s / 2, z), -w / 2 + 20, w / 2 - 20, "y", -1)))
        p += [Piece("X", "HGH20CA", block("x", (0, y0 - s / 2, z), -30 + dx, 30, "y", -1)) for dx in (-60, 60)]
    f = y0 - s / 2 - 28
    p.append(Piece("X", "X back plate", box((-130, 70), (f - 12, f), (b - 20, b + 180))))
    for x in (-100, 40):
        p.append(Piece("X", "HGR15 Z", rail("z", (x, f - 12, 0), b - 20, b + 180, "y", -1, k=0.8)))
        p += [Piece("Z", "HGH15CA", block("z", (x, f - 12, 0), zz, 24, "y", -1, k=0.8)) for zz in (b + 20, b + 90)]
    g = f - 12 - 22.4
    p.append(Piece("Z", "Z front plate", box((-120, 60), (g - 12, g), (b - 30, b + 130))))
    p.append(
        Piece(
            "Z",
            "Spindle clamp 80",
            bored(box((-80, 20), (g - 112, g - 12), (b, b + 70)), (-30, g - 62, b - 1), "z", 72, 40),
        )
    )
    p.append(Piece("Z", "Spindle 2.2kW", rod((-30, g - 62, b - 90), "z", 250, 40)))
    p.append(Piece("F", "Spoilboard MDF", box((-w / 2 + 80, w / 2 - 80), (-d / 2 + 20, d / 2 - 20), (s, s + 18))))
    return Kind(Truth("FYXZ", XYZ), p, {"F": "Frame", "Y": "Gantry", "X": "X axis", "Z": "Z axis"})


def knee_mill(r) -> Kind:
    """A turret mill: knee, saddle and table on dovetails; a ram on top, a quill in the head."""
    k = r.uniform(0.8, 1.3)
    d = [(-50 * k, 0), (50 * k, 0), (68 * k, 28 * k), (-68 * k, 28 * k)]
    h, zk, ys = 1100 * k, r.randint(350, 480) * k, r.randint(-330, -260) * k

    def out(points):
        return [(x, -z) for x, z in points]

    col = box((-140 * k, 140 * k), (0, 320 * k), (0, h))
    p = [
        Piece("F", "Base casting", box((-260 * k, 260 * k), (-560 * k, 360 * k), (-70 * k, 0))),
        Piece("F", "Column", fused(col, profile(out(d), "z", 120 * k, 820 * k))),
    ]
    knee = box((-130 * k, 130 * k), (-480 * k, 0), (zk, zk + 170 * k)).cut(profile(out(d), "z", zk - 1, zk + 171 * k))
    zt = zk + 170 * k
    p.append(Piece("Z", "Knee", fused(knee, dove("y", (0, 0, zt), d, -480 * k, -80 * k))))
    p.append(Piece("Z", "Elevating screw", rod((0, -300 * k, 0), "z", zk, 20 * k)))
    e = [(-45 * k, 0), (45 * k, 0), (60 * k, 24 * k), (-60 * k, 24 * k)]
    saddle = box((-140 * k, 140 * k), (ys - 110 * k, ys + 110 * k), (zt, zt + 80 * k)).cut(
        dove("y", (0, 0, zt), d, ys - 111 * k, ys + 111 * k)
    )
    zs = zt + 80 * k
    p.append(Piece("Y", "Saddle", fused(saddle, dove("x", (0, ys, zs), e, -140 * k, 140 * k))))
    table = box((-480 * k, 480 * k), (ys - 110 * k, ys + 110 * k), (zs, zs + 65 * k)).cut(
        dove("x", (0, ys, zs), e, -481 * k, 481 * k)
    )
    for y in (-60, 0, 60):
        table = table.cut(box((-481 * k, 481 * k), (ys + (y - 7) * k, ys + (y + 7) * k), (zs + 45 * k, zs + 66 * k)))
    p.append(Piece("X", "Table", table))
    p += [Piece("X", "Handwheel", rod((x, ys, zs + 30 * k), "x", 25 * k, 60 * k)) for x in (-510 * k, 485 * k)]
    p.append(Piece("X", "Vise", box((-80 * k, 80 * k), (ys - 50 * k, ys + 50 * k), (zs + 65 * k, zs + 130 * k))))
    p.append(Piece("F", "Ram", box((-90 * k, 90 * k), (-420 * k, 300 * k), (h, h + 160 * k))))
    yq = -480 * k
    p.append(
        Piece(
            "F",
            "Mill head",
            bored(
                box((-100 * k, 100 * k), (yq - 60 * k, yq + 60 * k), (h - 120 * k, h + 300 * k)),
                (0, yq, h - 121 * k),
                "z",
                300 * k,
                42 * k,
            ),
        )
    )
    p.append(Piece("F", "Quill", rod((0, yq, h - 200 * k), "z", 320 * k, 42 * k)))
    p.append(Piece("F", "Head motor", rod((0, yq, h + 300 * k), "z", 180 * k, 70 * k)))
    return Kind(Truth("XYZF", XYZ, either=("XYFZ",)), p, {"F": "Column", "Z": "Knee", "Y": "Saddle", "X": "Table"})


def c_frame(r) -> Kind:
    """A small mill of plates: cross table on rails below, the head on a column with rails."""
    w, h, y0 = r.randint(180, 260), r.randint(420, 600), r.randint(-30, 30)
    p = [
        Piece("F", "Bottom plate", box((-w, w), (-260, 200), (0, 25))),
        Piece("F", "Back plate", box((-w * 0.6, w * 0.6), (150, 175), (25, h))),
    ]
    p += [
        Piece("F", "Gusset", profile([(175, 25), (175, 300), (200, 25)], "x", x, x + 12)) for x in (-w * 0.5, w * 0.4)
    ]
    for x in (-90, 90):
        p.append(Piece("F", "Rail 15", rail("y", (x, 0, 25), -250, 120, k=0.8)))
        p += [Piece("Y", "Block 15", block("y", (x, 0, 25), y0 - 60 + dy, 24, k=0.8)) for dy in (-50, 50)]
    p.append(Piece("Y", "Middle plate", box((-130, 130), (y0 - 150, y0 + 30), (47.4, 62.4))))
    for y in (-120, 0):
        p.append(Piece("Y", "Rail 15", rail("x", (0, y0 + y, 62.4), -130, 130, k=0.8)))
        p += [Piece("X", "Block 15", block("x", (0, y0 + y, 62.4), dx, 24, k=0.8)) for dx in (-45, 45)]
    p.append(Piece("X", "Top plate", box((-200, 200), (y0 - 150, y0 + 30), (84.8, 104.8))))
    z0 = h - 170
    for x in (-60, 60):
        p.append(Piece("F", "Rail 15", rail("z", (x, 150, 0), 180, h - 10, "y", -1, k=0.8)))
        p += [Piece("Z", "Block 15", block("z", (x, 150, 0), z0 + dz, 24, "y", -1, k=0.8)) for dz in (-40, 40)]
    f = 150 - 22.4
    p.append(Piece("Z", "Head plate", box((-85, 85), (f - 16, f), (z0 - 80, z0 + 80))))
    p.append(
        Piece("Z", "Clamp", bored(box((-45, 45), (f - 116, f - 16), (z0 - 60, z0)), (0, f - 66, z0 - 61), "z", 62, 32))
    )
    p.append(Piece("Z", "Motor spindle", rod((0, f - 66, z0 - 130), "z", 220, 32)))
    return Kind(Truth("XYFZ", XYZ), p, {"F": "Base", "Y": "Saddle", "X": "Table", "Z": "Head"})


def moving_column(r) -> Kind:
    """The table runs along x on the bed, the column along y, the head along z on the column."""
    w, h = r.randint(500, 700), r.randint(700, 950)
    p = [Piece("F", "Bed", fused(box((-w, w), (-400, 0), (0, 150)), box((-250, 250), (0, 600), (0, 150))))]
    for y in (-320, -80):
        p.append(Piece("F", "Linear rail", rail("x", (0, y, 150), -w + 20, w - 20, k=1.4)))
        p += [Piece("X", "Rail carriage", block("x", (0, y, 150), x, 50, k=1.4)) for x in (-150, 180)]
    p.append(Piece("X", "Table", box((-350, 380), (-380, -20), (150 + 39.2, 240))))
    for x in (-180, 180):
        p.append(Piece("F", "Linear rail", rail("y", (x, 0, 150), 20, 590, k=1.4)))
        p += [Piece("Y", "Rail carriage", block("y", (x, 0, 150), y, 50, k=1.4)) for y in (230, 420)]
    p.append(Piece("Y", "Column", box((-230, 230), (170, 480), (150 + 39.2, h))))
    for x in (-120, 120):
        p.append(Piece("Y", "Linear rail", rail("z", (x, 170, 0), 330, h - 20, "y", -1, k=1.4)))
        p += [Piece("Z", "Rail carriage", block("z", (x, 170, 0), h - 200 + z, 50, "y", -1, k=1.4)) for z in (-90, 60)]
    f = 170 - 39.2
    p.append(
        Piece(
            "Z",
            "Spindle head",
            bored(box((-150, 150), (f - 330, f), (h - 360, h - 60)), (0, f - 220, h - 361), "z", 302, 60),
        )
    )
    p.append(Piece("Z", "Spindle", rod((0, f - 220, h - 420), "z", 360, 60)))
    return Kind(Truth("XFYZ", XYZ), p, {"F": "Bed", "X": "Table", "Y": "Column", "Z": "Spindle head"})


def low_rods(r) -> Kind:
    """A desk router of printed blocks whose holes run on rods with play, a screw beside each pair."""
    w, d = r.randint(260, 380), r.randint(300, 420)
    g = r.choice((0.1, 0.2, 0.3))
    p = []
    for y in (-d / 2, d / 2):
        end = box((-w / 2, w / 2), (y - 9, y + 9), (0, 80))
        for x in (-w / 2 + 30, w / 2 - 30):
            end = bored(end, (x, y - 10, 50), "y", 20, 6)
        p.append(Piece("F", "end panel", end))
    p.append(Piece("F", "floor", box((-w / 2, w / 2), (-d / 2 + 9, d / 2 - 9), (0, 12))))
    y0 = r.randint(-60, 60)
    for x in (-w / 2 + 30, w / 2 - 30):
        p.append(Piece("F", "Ø12 rod", rod((x, -d / 2 - 9, 50), "y", d + 18, 6)))
        side = bored(box((x - 16, x + 16), (y0 - 40, y0 + 40), (34, 300)), (x, y0 - 41, 50), "y", 82, 6 + g)
        for z in (200, 270):
            side = bored(side, (x - 17, y0, z), "x", 34, 5)
        p.append(Piece("Y", "printed side", side))
    for z in (200, 270):
        p.append(Piece("Y", "Ø10 rod", rod((-w / 2 + 14, y0, z), "x", w - 28, 5)))
    p.append(Piece("F", "screw Tr10", rod((0, -d / 2, 30), "y", d, 5)))
    p.append(
        Piece(
            "Y",
            "bottom tie",
            box((-w / 2 + 46, w / 2 - 46), (y0 - 15, y0 + 15), (34, 60)).cut(rod((0, y0 - 16, 30), "y", 32, 7)),
        )
    )
    c = box((-35, 35), (y0 - 16, y0 + 16), (182, 288))
    for z in (200, 270):
        c = bored(c, (-36, y0, z), "x", 72, 5 + g)
    c = fused(c, box((-35, 35), (y0 - 56, y0 - 16), (182, 196)), box((-35, 35), (y0 - 56, y0 - 16), (274, 288)))
    for x in (-24, 24):
        c = bored(c, (x, y0 - 40, 181), "z", 108, 4)
    p.append(Piece("X", "middle printed block", c))
    p += [Piece("X", "Ø8 rod", rod((x, y0 - 40, 182), "z", 106, 4)) for x in (-24, 24)]
    t = box((-34, 34), (y0 - 58, y0 - 28), (215, 250))
    for x in (-24, 24):
        t = bored(t, (x, y0 - 40, 214), "z", 37, 4 + g)
    t = fused(t, box((-22, 22), (y0 - 105, y0 - 58), (215, 250)))
    p.append(Piece("Z", "tool block", bored(t, (0, y0 - 82, 214), "z", 37, 16)))
    p.append(Piece("Z", "grinder", rod((0, y0 - 82, 150), "z", 150, 16)))
    return Kind(Truth("FYXZ", XYZ), p, {"F": "Base", "Y": "Gantry", "X": "Carriage", "Z": "Tool"})


def laser(r) -> Kind:
    """A laser cutter: a bar on V-wheels along y, a cart on V-wheels along x; two axes."""
    w, d = r.randint(450, 700), r.randint(450, 650)
    p = [Piece("F", "Extrusion 2040", box((x - 10, x + 10), (-d / 2, d / 2), (0, 40))) for x in (-w / 2, w / 2)]
    p += [
        Piece("F", "Extrusion 2040", box((-w / 2 + 10, w / 2 - 10), (y - 10, y + 10), (0, 40)))
        for y in (-d / 2 + 10, d / 2 - 10)
    ]
    for s in (-1, 1):
        x = s * w / 2
        for dz in (-28, 28):
            p += [Piece("Y", "Mini V wheel", q) for q in wheels((x, 30, 20 + dz), "y", 25, "x")]
        e = x + s * 14
        p.append(Piece("Y", "Gantry plate", box(tuple(sorted((e, e + s * 4))), (-25, 85), (-20, 90))))
    p.append(Piece("Y", "Extrusion 2020 X", vslot("x", (0, 30, 70), -w / 2 - 14, w / 2 + 14)))
    for dz in (-18, 18):
        p += [Piece("X", "Mini V wheel", q) for q in wheels((-40, 30, 70 + dz), "x", 20, "y")]
    p.append(Piece("X", "Laser plate", box((-75, -5), (12, 16), (40, 100))))
    p.append(Piece("X", "Laser module", box((-58, -22), (-30, 12), (20, 110))))
    return Kind(Truth(None, {"X": (1, 0, 0), "Y": (0, 1, 0)}), p, {"F": "Frame", "Y": "Gantry", "X": "Laser head"})


def pen_plotter(r) -> Kind:
    """A plotter: a cart along x on two long rods, an arm of two rods along y through it; two axes."""
    w, a = r.randint(450, 600), r.randint(330, 420)
    p = []
    for x in (-w / 2, w / 2):
        end = box((x - 15, x + 15), (-40, 40), (0, 50))
        for y in (-24, 24):
            end = bored(end, (x - 16, y, 25), "x", 32, 4)
        p.append(Piece("F", "end", end))
    p += [Piece("F", "long rod", rod((-w / 2, y, 25), "x", w, 4)) for y in (-24, 24)]
    c = box((-40, 40), (-44, 44), (8, 80))
    for y in (-24, 24):
        c = bored(c, (-41, y, 25), "x", 82, 7.5)
        p.append(Piece("X", "LM8UU", bored(rod((-12, y, 25), "x", 24, 7.5), (-13, y, 25), "x", 26, 4)))
    for x in (-22, 22):
        c = bored(c, (x, -45, 62), "y", 90, 7.5)
        p.append(Piece("X", "LM8UU", bored(rod((x, -12, 62), "y", 24, 7.5), (x, -13, 62), "y", 26, 4)))
        p.append(Piece("Y", "arm rod", rod((x, -a / 2 - 60, 62), "y", a, 4)))
    p.append(Piece("X", "cart", c))
    for y, label in ((-a / 2 - 60, "pen holder"), (a / 2 - 75, "rear arm end")):
        e = box((-34, 34), (y, y + 15), (48, 78))
        for x in (-22, 22):
            e = bored(e, (x, y - 1, 62), "y", 17, 4)
        p.append(Piece("Y", label, e))
    p.append(Piece("Y", "pen", rod((0, -a / 2 - 66, 10), "z", 120, 5)))
    return Kind(Truth(None, {"X": (1, 0, 0), "Y": (0, 1, 0)}), p, {"F": "Base", "X": "Cart", "Y": "Arm"})


def fixed_bridge(r) -> Kind:
    """A fixed bridge of plates over a table on rails along y; carriage along x, slide along z, with ball screws."""
    w, d = r.randint(260, 380), r.randint(420, 600)
    p = [Piece("F", "Base plate", box((-w - 40, w + 40), (-d / 2, d / 2), (0, 30)))]
    p += [
        Piece("F", "Bridge column", box((s * (w + 25) - 15, s * (w + 25) + 15), (20, 120), (30, 520))) for s in (-1, 1)
    ]
    p.append(Piece("F", "Bridge beam", box((-w - 10, w + 10), (50, 100), (320, 500))))
    y0 = r.randint(-70, 50)
    for x in (-w * 0.55, w * 0.55):
        p.append(Piece("F", "HIWIN HGR20R", rail("y", (x, 0, 30), -d / 2 + 10, d / 2 - 10)))
        p += [Piece("Y", "HIWIN HGH20", block("y", (x, 0, 30), y0 + dy)) for dy in (-75, 75)]
    p.append(Piece("Y", "T-slot table", box((-w * 0.85, w * 0.85), (y0 - 150, y0 + 150), (58, 83))))
    p.append(Piece("F", "SFU1204", rod((0, -d / 2, 44), "y", d, 6)))
    p.append(
        Piece("Y", "SFU1204 nut", bored(box((-18, 18), (y0 - 20, y0 + 20), (31, 58)), (0, y0 - 21, 44), "y", 42, 6))
    )
    for z in (350, 470):
        p.append(Piece("F", "HIWIN HGR20R", rail("x", (0, 50, z), -w, w, "y", -1)))
        p += [Piece("X", "HIWIN HGH20", block("x", (0, 50, z), -20 + dx, 30, "y", -1)) for dx in (-50, 50)]
    p.append(Piece("X", "Carriage plate", box((-120, 80), (7, 22), (320, 540))))
    for x in (-85, 45):
        p.append(Piece("X", "HGR15R", rail("z", (x, 7, 0), 325, 535, "y", -1, k=0.8)))
        p += [Piece("Z", "HGH15", block("z", (x, 7, 0), 400 + dz, 24, "y", -1, k=0.8)) for dz in (-40, 40)]
    g = 7 - 22.4
    p.append(Piece("Z", "Spindle plate", box((-110, 70), (g - 15, g), (330, 470))))
    p.append(
        Piece(
            "Z",
            "Spindle mount",
            bored(box((-65, 25), (g - 105, g - 15), (360, 420)), (-20, g - 60, 359), "z", 62, 32.5),
        )
    )
    p.append(Piece("Z", "Spindle", rod((-20, g - 60, 270), "z", 230, 32.5)))
    return Kind(Truth("YFXZ", XYZ), p, {"F": "Frame", "Y": "Table", "X": "X carriage", "Z": "Z slide"})


def fourth_axis(r) -> Kind:
    """`fixed_bridge` with a turning chuck and its tailstock on the table."""
    base = fixed_bridge(r)
    box_ = next(q.shape.BoundBox for q in base.pieces if q.label == "T-slot table")
    y, z = box_.Center.y, box_.ZMax
    base.pieces += [Piece("Y", "Rotary axis housing", bored(box((-150, -80), (y - 50, y + 50), (z, z + 110)), (-151, y, z + 60), "x", 72, 25)),
                    Piece("A", "A axis chuck", fused(rod((-150, y, z + 60), "x", 70, 25), rod((-80, y, z + 60), "x", 40, 40))),
                    Piece("Y", "Tailstock", box((100, 140), (y - 30, y + 30), (z, z + 90)))]  # fmt: skip
    return Kind(base.truth, base.pieces, {**base.bodies, "A": "Rotary chuck"})


def hot_wire(r) -> Kind:
    """A foam cutter: on each side a cart along x with a slide along z; the wire is between.  No serial machine."""
    w, d = r.randint(300, 450), r.randint(600, 800)
    p = [Piece("F", "Table", box((-w - 80, w + 80), (-d / 2, d / 2), (-20, 0)))]
    for s, side in ((-1, "left"), (1, "right")):
        x = s * w
        p.append(Piece("F", f"Rail Y {side}", rail("y", (x, 0, 0), -d / 2 + 20, d / 2 - 20)))
        p.append(Piece(f"Y{side}", f"Block Y {side}", block("y", (x, 0, 0), 40)))
        p.append(Piece(f"Y{side}", f"Tower {side}", box((x - 20, x + 20), (20, 60), (28, 450))))
        p.append(Piece(f"Y{side}", f"Rail Z {side}", rail("z", (x, 20, 0), 60, 440, "y", -1)))
        p.append(Piece(f"Z{side}", f"Block Z {side}", block("z", (x, 20, 0), 220, 30, "y", -1)))
        p.append(Piece(f"Z{side}", f"Wire holder {side}", box((x - 15, x + 15), (-38, -8), (205, 235))))
    p.append(Piece("Zleft", "Wire", rod((-w, -24, 220), "x", 2 * w, 0.4)))
    return Kind(
        Truth(None, {"Y": (0, 1, 0), "Z": (0, 0, 1)}),
        p,
        {"F": "Table", "Yleft": "Left tower", "Zleft": "Left slide", "Yright": "Right tower", "Zright": "Right slide"},
    )


def way_lathe(r) -> Kind:
    """A lathe on V-ways: carriage along the bed, cross slide on a dovetail, compound and tool post on it."""
    k = r.uniform(0.8, 1.4)
    ways = [
        (-70, 0),
        (70, 0),
        (70, 40),
        (55, 40),
        (45, 52),
        (35, 40),
        (-30, 40),
        (-30, 48),
        (-60, 48),
        (-60, 40),
        (-70, 40),
    ]
    ways = [(y * k, 100 * k + z * k) for y, z in ways]
    length = r.randint(700, 1000) * k
    p = [Piece("F", "Bed", fused(box((0, length), (-70 * k, 70 * k), (0, 100 * k)), profile(ways, "x", 0, length)))]
    p.append(
        Piece(
            "F",
            "Headstock",
            bored(box((0, 190 * k), (-80 * k, 80 * k), (152 * k, 330 * k)), (-1, 0, 260 * k), "x", 192 * k, 35 * k),
        )
    )
    p += [
        Piece("F", "Spindle", rod((-20 * k, 0, 260 * k), "x", 230 * k, 35 * k)),
        Piece("F", "3 jaw chuck", rod((210 * k, 0, 260 * k), "x", 60 * k, 75 * k)),
    ]
    x0 = r.randint(380, 480) * k
    saddle = box((x0 - 70 * k, x0 + 70 * k), (-100 * k, 100 * k), (140 * k, 185 * k)).cut(
        profile(ways, "x", x0 - 71 * k, x0 + 71 * k)
    )
    e = [(-30 * k, 0), (30 * k, 0), (42 * k, 16 * k), (-42 * k, 16 * k)]
    p.append(Piece("Z", "Saddle", fused(saddle, dove("y", (x0, 0, 185 * k), e, -100 * k, 100 * k))))
    p.append(Piece("Z", "Apron", box((x0 - 70 * k, x0 + 70 * k), (-130 * k, -100 * k), (30 * k, 185 * k))))
    p.append(
        Piece(
            "X",
            "Cross slide",
            box((x0 - 52 * k, x0 + 52 * k), (-80 * k, 60 * k), (185 * k, 225 * k)).cut(
                dove("y", (x0, 0, 185 * k), e, -81 * k, 61 * k)
            ),
        )
    )
    p.append(Piece("X", "Compound rest", box((x0 - 30 * k, x0 + 70 * k), (-30 * k, 30 * k), (225 * k, 250 * k))))
    p.append(Piece("X", "Tool post", box((x0 - 25 * k, x0 + 25 * k), (-25 * k, 25 * k), (250 * k, 290 * k))))
    p.append(Piece("F", "Lead screw", rod((190 * k, -115 * k, 60 * k), "x", length - 220 * k, 8 * k)))
    p.append(Piece("F", "Tailstock", box((length - 150 * k, length - 40 * k), (-60 * k, 60 * k), (148 * k, 300 * k))))
    return Kind(
        Truth("FZX", {"Z": (1, 0, 0), "X": (0, 1, 0)}), p, {"F": "Lathe bed", "Z": "Carriage", "X": "Cross slide"}
    )


def wheel_on_board(r) -> Kind:
    """A gantry that drives on the edges of a board, rises as a whole on rods, and carries a cart on two tubes."""
    w, d, q = r.randint(600, 800), r.randint(700, 1000), 12.7
    p = [Piece("F", "Table top", box((-w / 2, w / 2), (-d / 2, d / 2), (0, 30)))]
    z, y0 = 170, r.randint(-100, 100)
    for s in (-1, 1):
        x = s * (w / 2 - 40)
        plate = box((x - 12, x + 12), (y0 - 90, y0 + 90), (45, 330))
        p.append(Piece("Y", "Side plate", plate))
        p += [Piece("Y", "Skate wheel", rod((x - 12, y0 + dy, 55), "x", 24, 25)) for dy in (-70, 70)]
        for dy in (-60, 60):
            p.append(Piece("Y", "Z rod 10mm", rod((x - s * 24, y0 + dy, 60), "z", 260, 5)))
            p += [
                Piece(
                    "Y",
                    "Rod holder",
                    bored(
                        box(tuple(sorted((x - s * 12, x - s * 34))), (y0 + dy - 10, y0 + dy + 10), (zz, zz + 10)),
                        (x - s * 24, y0 + dy, zz - 1),
                        "z",
                        12,
                        5,
                    ),
                )
                for zz in (60, 310)
            ]
        slide = box(tuple(sorted((x - s * 13, x - s * 60))), (y0 - 80, y0 + 80), (z - 40, z + 40))
        for dy in (-60, 60):
            slide = bored(slide, (x - s * 24, y0 + dy, z - 41), "z", 82, 5)
        for dy in (-30, 30):
            slide = bored(slide, (x - 61, y0 + dy, z), "x", 122, q)
        p.append(Piece("Z", "Lift block", slide))
    a = w / 2 - 40 - 20
    p += [Piece("Z", "Conduit", tube((-a, y0 + dy, z), "x", 2 * a, q)) for dy in (-30, 30)]
    cart = box((-60, 60), (y0 - 60, y0 + 60), (z - 30, z + 30))
    for dy in (-30, 30):
        cart = bored(cart, (-61, y0 + dy, z), "x", 122, q + 0.2)
    p.append(Piece("X", "Cart", cart))
    p.append(Piece("X", "Router", rod((0, y0 - 90, z - 90), "z", 180, 30)))
    p.append(
        Piece(
            "X",
            "Router mount",
            bored(box((-40, 40), (y0 - 125, y0 - 60), (z - 20, z + 20)), (0, y0 - 90, z - 21), "z", 42, 30),
        )
    )
    return Kind(Truth("FYZX", XYZ), p, {"F": "Table", "Y": "Trucks", "Z": "Gantry lift", "X": "Tool cart"})


UNLIKE = {f.__name__: f for f in (
    bed_slinger, rod_printer, core_xy, flying_gantry, plywood_router, tube_router, steel_router, knee_mill, c_frame, moving_column,
    low_rods, laser, pen_plotter, fixed_bridge, fourth_axis, hot_wire, way_lathe, wheel_on_board)}  # fmt: skip
