# SPDX-License-Identifier: LGPL-2.1-or-later
# ruff: noqa: E501 - tables that are read by column
"""Kinds of machines as lists of pieces, each with the body that it belongs to, for `writers` to put into documents."""

from __future__ import annotations

from dataclasses import dataclass

from . import Truth, block, bored, box, fused, profile, rail, rod, vslot, wheel


@dataclass
class Piece:
    """A part: the body that it belongs to, its name, its shape."""

    body: str
    label: str
    shape: object


@dataclass
class Kind:
    """A machine: what is true of it, its pieces, the English names of its bodies."""

    truth: Truth
    pieces: list[Piece]
    bodies: dict[str, str]

    def of(self, body: str) -> list[Piece]:
        """The pieces of one body."""
        return [p for p in self.pieces if p.body == body]


XYZ = {"X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}


def gantry() -> Kind:
    """A router: profile rails along y on the base, a bridge on them, rails along x on its beam, rails along z on the carriage."""
    p = [Piece("F", "Base plate", box((-400, 400), (-600, 600), (0, 60)))]
    for x, tail in ((-350, "L"), (350, "R")):
        p.append(Piece("F", f"Side {tail}", box((x - 30, x + 30), (-600, 600), (60, 160))))
        p.append(Piece("F", f"HGR20-1100 {tail}", rail("y", (x, 0, 160), -550, 550)))
        for n, y in enumerate((-70, 70)):
            p.append(Piece("Y", f"HGH20CA {tail}{n}", block("y", (x, 0, 160), y)))
        p.append(Piece("Y", f"Gantry side {tail}", box((x - 30, x + 30), (-110, 110), (188, 460))))
    p.append(
        Piece("Y", "Gantry beam", box((-380, 380), (-40, 40), (320, 460)).cut(box((-320, 320), (-30, 30), (330, 450))))
    )
    for z, tail in ((345, "low"), (435, "top")):
        p.append(Piece("Y", f"HGR15-700 {tail}", rail("x", (0, -40, z), -350, 350, "y", -1)))
        for n, x in enumerate((-60, 60)):
            p.append(Piece("X", f"HGH15CA {tail}{n}", block("x", (0, -40, z), x, 28, "y", -1)))
    p.append(Piece("X", "X carriage plate", box((-100, 100), (-80, -68), (310, 480))))
    for x, tail in ((-60, "l"), (60, "r")):
        p.append(Piece("X", f"MGN15R-170 {tail}", rail("z", (x, -80, 0), 310, 480, "y", -1)))
        p.append(Piece("Z", f"MGN15H {tail}", block("z", (x, -80, 0), 380, 25, "y", -1)))
    p.append(Piece("Z", "Z plate", box((-90, 90), (-120, -108), (330, 430))))
    p.append(
        Piece("Z", "Spindle clamp", bored(box((-50, 50), (-210, -120), (350, 410)), (0, -165, 349), "z", 70, 32.5))
    )
    p.append(Piece("Z", "Spindle 65", rod((0, -165, 250), "z", 200, 32.5)))
    return Kind(Truth("FYXZ", XYZ, travel={"Y": 1100 - 200, "X": 700 - 176, "Z": 170 - 50}), p,
                {"F": "Base", "Y": "Gantry", "X": "Carriage", "Z": "Spindle head"})  # fmt: skip


def moving_table() -> Kind:
    """A fixed bridge over a table that moves along y on round rods; x and z on rods with bushings."""
    p = [Piece("F", "Bottom", box((-300, 300), (-400, 400), (0, 18)))]
    for y in (-391, 391):
        p.append(Piece("F", "End board", box((-300, 300), (min(y - 9, y + 9), max(y - 9, y + 9)), (18, 90))))
    for x in (-120, 120):
        p.append(Piece("F", "Rod 16x764", rod((x, -382, 60), "y", 764, 8)))
        for y in (-90, 90):
            hold = bored(box((x - 22, x + 22), (y - 22, y + 22), (42, 85)), (x, y - 23, 60), "y", 46, 8)
            p.append(Piece("Y", "SC16UU", hold))
    p.append(Piece("Y", "Table board", box((-200, 200), (-180, 180), (85, 103))))
    for x in (-291, 291):
        p.append(Piece("F", "Upright", box((x - 9, x + 9), (-60, 60), (18, 400))))
    for z in (250, 370):
        p.append(Piece("F", "Rod 16x564", rod((-282, -20, z), "x", 564, 8)))
        for x in (-45, 45):
            hold = bored(box((x - 22, x + 22), (-42, 5), (z - 22, z + 22)), (x - 23, -20, z), "x", 46, 8)
            p.append(Piece("X", "SC16UU", hold))
    p.append(Piece("X", "Back board", box((-80, 80), (-60, -42), (190, 430))))
    for z in (195, 415):
        p.append(Piece("X", "Bracket", box((-80, 80), (-110, -60), (z - 5, z + 5))))
    for x in (-50, 50):
        p.append(Piece("X", "Rod 12x210", rod((x, -85, 200), "z", 210, 6)))
        p.append(Piece("Z", "LM12UU", bored(rod((x, -85, 280), "z", 60, 11), (x, -85, 279), "z", 62, 6)))
    hold = box((-75, 75), (-150, -70), (280, 340))
    for x in (-50, 50):
        hold = bored(hold, (x, -85, 279), "z", 62, 11)
    p.append(Piece("Z", "Router holder", bored(hold, (0, -118, 279), "z", 62, 28)))
    p.append(Piece("Z", "Router", rod((0, -118, 200), "z", 200, 28)))
    return Kind(Truth("YFXZ", XYZ), p, {"F": "Frame", "Y": "Table", "X": "Carriage", "Z": "Tool holder"})


def bench_mill() -> Kind:
    """A small mill of castings: base, saddle on a dovetail, table on the saddle, head on the column's dovetail."""
    d = [(-40, 0), (40, 0), (56, 24), (-56, 24)]
    p = [Piece("F", "Casting A", box((-90, 90), (-250, 160), (0, 120)).fuse(profile([(x, 120 + z) for x, z in d], "y", -250, 0))),
         Piece("F", "Casting B", box((-70, 70), (20, 160), (120, 700)).fuse(profile([(x, 20 - y) for x, y in d], "z", 200, 690)))]  # fmt: skip
    saddle = box((-100, 100), (-190, -70), (120, 190)).cut(profile([(x, 120 + z) for x, z in d], "y", -191, -69))
    p.append(Piece("Y", "Casting C", saddle.fuse(profile([(-130 + y, 190 + z) for y, z in d], "x", -100, 100))))
    p.append(
        Piece(
            "X",
            "Casting D",
            box((-250, 250), (-200, -60), (190, 250)).cut(profile([(-130 + y, 190 + z) for y, z in d], "x", -251, 251)),
        )
    )
    head = box((-80, 80), (-190, 20), (430, 600)).cut(profile([(x, 20 - y) for x, y in d], "z", 429, 601))
    p += [
        Piece("Z", "Casting E", bored(head, (0, -130, 429), "z", 180, 35)),
        Piece("Z", "Quill tube", rod((0, -130, 380), "z", 230, 35)),
    ]
    return Kind(Truth("XYFZ", XYZ), p, {"F": "Column", "Y": "Saddle", "X": "Table", "Z": "Head"})


def corexy() -> Kind:
    """A printer: the bed rises on rods, a bar moves along y on rails, the head on the bar."""
    p = []
    for x in (-200, 200):
        for y in (-200, 200):
            p.append(Piece("F", "2020 extrusion 480", vslot("z", (x, y, 0), 0, 480)))
        for z in (10, 470):
            p.append(Piece("F", "2020 extrusion 380", vslot("y", (x, 0, z), -190, 190)))
    for y in (-200, 200):
        for z in (10, 470):
            p.append(Piece("F", "2020 extrusion 380", vslot("x", (0, y, z), -190, 190)))
    for x in (-200, 200):
        p.append(
            Piece(
                "F",
                "MGN12R-350",
                rail("y", (x - (1 if x > 0 else -1) * 10, 0, 470), -175, 175, "x", -1 if x > 0 else 1),
            )
        )
        p.append(
            Piece("Y", "MGN12H", block("y", (x - (1 if x > 0 else -1) * 10, 0, 470), 20, 22, "x", -1 if x > 0 else 1))
        )
    p.append(Piece("Y", "XY joint left", box((-162, -130), (-5, 45), (445, 495))))
    p.append(Piece("Y", "XY joint right", box((130, 162), (-5, 45), (445, 495))))
    p.append(Piece("Y", "X bar", box((-130, 130), (10, 30), (460, 480))))
    p.append(Piece("Y", "MGN9R-250", rail("x", (0, 10, 470), -125, 125, "y", -1)))
    p.append(Piece("X", "MGN9H", block("x", (0, 10, 470), 0, 20, "y", -1)))
    p.append(Piece("X", "Toolhead", box((-25, 25), (-50, -18), (430, 500))))
    p.append(Piece("X", "Hotend nozzle", rod((0, -34, 400), "z", 30, 5)))
    for x in (-120, 120):
        p.append(Piece("F", "Smooth rod 10x460", rod((x, 190, 10), "z", 460, 5)))
        p.append(Piece("F", "Rod mount", bored(box((x - 20, x + 20), (170, 210), (0, 20)), (x, 190, 10), "z", 12, 5)))
        p.append(Piece("Z", "LM10UU", bored(rod((x, 190, 180), "z", 55, 9.5), (x, 190, 179), "z", 57, 5)))
        p.append(
            Piece("Z", "Bed arm", bored(box((x - 15, x + 15), (-120, 205), (200, 215)), (x, 190, 199), "z", 20, 9.5))
        )
    p.append(Piece("Z", "Heatbed", box((-150, 150), (-150, 150), (215, 220))))
    return Kind(Truth("ZFYX", XYZ, either=("ZFYX",)), p, {"F": "Frame", "Y": "Y axis", "X": "X axis", "Z": "Z bed"})


def wheeled() -> Kind:
    """A bridge of aluminium profiles on V-wheels; nothing is called rail."""
    p = []
    for x in (0, 500):
        p.append(Piece("F", "Profile 20x40 800", vslot("y", (x, 0, 50), -400, 400)))
    for y in (-390, 390):
        p.append(Piece("F", "Profile 20x20 480", vslot("x", (0, y, 30), 0, 500)))
    for x, sign in ((0, -1), (500, 1)):
        face = x + sign * 14
        p.append(Piece("Y", "End plate", box(tuple(sorted((face, face + sign * 6))), (-60, 60), (20, 160))))
        for y in (-40, 40):
            for z in (72, 28):
                p.append(Piece("Y", "V-Wheel", wheel((x + sign * 7, y, z), "x")))
    p.append(Piece("Y", "Profile 20x40 500", vslot("x", (0, 0, 140), -14, 514)))
    p.append(Piece("X", "Cart plate", box((200, 300), (-20, -14), (20, 200))))
    for x in (220, 280):
        for z in (162, 118):
            p.append(Piece("X", "V-Wheel", wheel((x, -7, z), "y")))
    p.append(Piece("X", "MGN12R-180", rail("z", (250, -20, 0), 20, 200, "y", -1)))
    p.append(Piece("Z", "MGN12H", block("z", (250, -20, 0), 120, 22, "y", -1)))
    p.append(Piece("Z", "Tool plate", box((210, 290), (-60, -48), (90, 160))))
    p.append(Piece("Z", "Router motor", rod((250, -90, 60), "z", 120, 30)))
    return Kind(Truth("FYXZ", XYZ), p, {"F": "Frame", "Y": "Gantry", "X": "Cart", "Z": "Tool"})


def vertical_center() -> Kind:
    """A machining centre: table on saddle on bed, head on the column, all on profile rails, with screws and motors."""
    p = [
        Piece("F", "Bed casting", box((-300, 300), (-600, 500), (0, 250))),
        Piece("F", "Column casting", box((-250, 250), (150, 500), (250, 1500))),
    ]
    for x in (-200, 200):
        p.append(Piece("F", "LM rail SHS35 y", rail("y", (x, 0, 250), -560, 100)))
        for y in (-380, -120):
            p.append(Piece("Y", "SHS35C", block("y", (x, 0, 250), y, 60)))
        p.append(Piece("F", "LM rail SHS35 z", rail("z", (x, 150, 0), 600, 1450, "y", -1)))
        for z in (900, 1120):
            p.append(Piece("Z", "SHS35C", block("z", (x, 150, 0), z, 60, "y", -1)))
    p.append(Piece("Y", "Saddle casting", box((-450, 450), (-460, -60), (278, 350))))
    for y in (-400, -120):
        p.append(Piece("Y", "LM rail SHS35 x", rail("x", (0, y, 350), -440, 440)))
        for x in (-150, 150):
            p.append(Piece("X", "SHS35C", block("x", (0, y, 350), x, 60)))
    p.append(Piece("X", "Table casting", box((-500, 500), (-480, -40), (378, 450))))
    p.append(
        Piece(
            "Z", "Headstock casting", box((-230, 230), (-400, 122), (850, 1180)).cut(rod((0, -260, 849), "z", 340, 80))
        )
    )
    p.append(Piece("Z", "Spindle", rod((0, -260, 780), "z", 400, 80)))
    p.append(Piece("F", "Ballscrew y", rod((0, -560, 268), "y", 680, 10)))
    p.append(Piece("Y", "Ballscrew x", rod((-440, -260, 366), "x", 880, 10)))
    p.append(Piece("F", "Motor y", box((-60, 60), (-700, -600), (180, 320))))
    return Kind(Truth("XYFZ", XYZ, travel={"X": 880 - 420, "Y": 660 - 380, "Z": 850 - 340}), p,
                {"F": "Bed", "Y": "Saddle", "X": "Table", "Z": "Headstock"})  # fmt: skip


def slant_lathe() -> Kind:
    """A lathe along x: bed, headstock, chuck; the carriage on dovetails along x, the cross slide along y."""
    d = [(-50, 0), (50, 0), (66, 24), (-66, 24)]
    p = [Piece("F", "Lathe bed", box((-450, 450), (-90, 90), (0, 120)).fuse(profile([(y, 120 + z) for y, z in d], "x", -250, 450))),
         Piece("F", "Headstock", bored(box((-450, -270), (-90, 90), (120, 320)), (-451, 0, 230), "x", 190, 45)),
         Piece("F", "Spindle bore", rod((-460, 0, 230), "x", 220, 45)), Piece("F", "Chuck", rod((-240, 0, 230), "x", 50, 70))]  # fmt: skip
    carriage = box((-60, 80), (-100, 100), (120, 175)).cut(profile([(y, 120 + z) for y, z in d], "x", -61, 81))
    e = [(-25, 0), (25, 0), (36, 16), (-36, 16)]
    p.append(Piece("Z", "Carriage", carriage.fuse(profile([(10 + x, 175 + z) for x, z in e], "y", -100, 100))))
    p.append(
        Piece(
            "X",
            "Cross slide",
            box((-45, 65), (-60, 30), (175, 210)).cut(profile([(10 + x, 175 + z) for x, z in e], "y", -61, 31)),
        )
    )
    p.append(Piece("X", "Tool post", box((-25, 45), (-50, 10), (210, 260))))
    p.append(Piece("F", "Leadscrew", rod((-260, -105, 90), "x", 700, 8)))
    return Kind(Truth("FZX", {"Z": (1, 0, 0), "X": (0, 1, 0)}), p, {"F": "Bed", "Z": "Carriage", "X": "Cross slide"})


def trunnion() -> Kind:
    """Five axes: a table that tilts and turns on a table along x; y and z carry the spindle."""
    base = vertical_center()
    p = [q for q in base.pieces if q.label not in ("Spindle",)] + [
        Piece("Z", "Spindle", rod((0, -260, 780), "z", 400, 80))
    ]
    p += [Piece("X", "Trunnion support", box((x - 20, x + 20), (-350, -170), (450, 600))) for x in (-300, 300)]
    p.append(Piece("A", "Trunnion A axis", fused(box((-270, 270), (-340, -180), (470, 500)), rod((-320, -260, 560), "x", 50, 30), rod((270, -260, 560), "x", 50, 30),
                                                 box((-280, -260), (-300, -220), (480, 590)), box((260, 280), (-300, -220), (480, 590)))))  # fmt: skip
    p.append(Piece("C", "Rotary table C axis", rod((0, -260, 500), "z", 30, 75)))
    return Kind(Truth("XYFZ", XYZ), p, {**base.bodies, "A": "Trunnion", "C": "Rotary table"})


def stage() -> Kind:
    """One axis: a plate on a rail."""
    p = [Piece("F", "Base profile", box((-40, 40), (-300, 300), (0, 20))), Piece("F", "MGN12R-500", rail("y", (0, 0, 20), -250, 250)),
         Piece("Y", "MGN12H", block("y", (0, 0, 20), 0)), Piece("Y", "Plate", box((-50, 50), (-40, 40), (48, 58))),
         Piece("F", "NEMA17", box((-21, 21), (-350, -300), (5, 47)))]  # fmt: skip
    return Kind(Truth(None, {"Y": (0, 1, 0)}), p, {"F": "Base", "Y": "Carriage"})


def plotter() -> Kind:
    """Two axes: x on y, without a third."""
    p = [Piece("F", "Board", box((-400, 400), (-300, 300), (0, 18)))]
    for x in (-350, 350):
        p += [
            Piece("F", "MGN12R-500", rail("y", (x, 0, 18), -250, 250)),
            Piece("Y", "MGN12H", block("y", (x, 0, 18), 0)),
        ]
    p.append(Piece("Y", "Cross beam", box((-380, 380), (-25, 25), (46, 86))))
    p += [Piece("Y", "MGN9R-600", rail("x", (0, 0, 86), -300, 300)), Piece("X", "MGN9H", block("x", (0, 0, 86), 0))]
    p.append(Piece("X", "Pen holder", box((-30, 30), (-60, 30), (114, 124))))
    return Kind(Truth(None, {"X": (1, 0, 0), "Y": (0, 1, 0)}), p, {"F": "Base", "Y": "Beam", "X": "Head"})


KINDS = {
    f.__name__: f
    for f in (gantry, moving_table, bench_mill, corexy, wheeled, vertical_center, slant_lathe, trunnion, stage, plotter)
}
