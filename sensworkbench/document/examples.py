# SPDX-License-Identifier: LGPL-2.1-or-later
"""Example machines: an XYFZ vertical machining centre, an FXYZ gantry and a YFXZ travelling column.

Each is built from some twenty solids in one App::Part per body, complete with axes, scales as reference points, tool
point and the default tolerances.  Proportions and travels are those of machines of that size, of no maker's in
particular; x points right, y away from the operator, z up.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import FreeCAD as App
import Part

from ..core.machine import structure_chains
from ..messages import Refused
from . import factory
from .solids import (
    V,
    bearing,
    block,
    box,
    cone,
    cylinder,
    end_mill,
    motor,
    nut,
    prism,
    rail,
    ribbed_base,
    screw,
    slotted_table,
    tool_holder,
    tower,
    union,
    window,
    without,
)

CAST, PAINT, STEEL, GROUND = "#8a9a9c", "#d9dcd6", "#9fa6ad", "#c4c9ce"
SCREW, MOTOR, TOOL, WORK, DARK = "#b8b3a5", "#3b4046", "#d0a44c", "#6f93b5", "#565d63"

NAMES = {
    "XYFZ": "Vertical machining centre",
    "FXYZ": "Gantry machining centre",
    "YFXZ": "Travelling-column machine",
}


@dataclass
class _Body:
    """One rigid body: its App::Part and what is in it."""

    part: App.DocumentObject
    colours: dict[str, str] = field(default_factory=dict)

    def add(self, name, label, shape, colour):
        feature = self.part.Document.addObject("Part::Feature", name)
        feature.Label = label
        feature.Shape = shape
        self.part.addObject(feature)
        self.colours[feature.Name] = colour
        return feature

    def frame(self, name, label, at):
        """A coordinate system at a point, for references."""
        lcs = self.part.Document.addObject("PartDesign::CoordinateSystem", name)
        lcs.Label = label
        lcs.Placement.Base = V(*at)
        self.part.addObject(lcs)
        if App.GuiUp:
            lcs.ViewObject.Visibility = False
        return lcs


def make_example(doc, structure: str = "XYFZ"):
    """Build an example machine in a document and return its Machine; structures are the keys of `NAMES`."""
    builders = {"XYFZ": _machining_centre, "FXYZ": _gantry, "YFXZ": _travelling_column}
    if structure not in builders:
        raise Refused("example-unknown", "example", structure=repr(structure)[:60], known=list(builders))
    bodies, travel = builders[structure](doc)
    workpiece, tool = structure_chains(structure)
    machine = factory.make_machine(
        doc, workpiece, tool, bed=[bodies["F"].part], tool_point=bodies["T"].tip, label=NAMES[structure]
    )
    for name in (*workpiece, *tool):
        factory.make_axis(machine, name, [bodies[name].part], travel=travel[name], reference=bodies[name].scale)
    factory.make_body(machine, "T", [bodies["T"].part], reference=bodies["T"].nose)
    factory.make_body(machine, "W", [bodies["W"].part], reference=bodies["W"].datum)
    colours = {name: colour for body in bodies.values() for name, colour in body.colours.items()}
    machine.PartColours = colours
    if App.GuiUp:
        apply_colours(doc, colours)
    else:
        machine.ViewPending = True
    doc.recompute()
    return machine


def apply_colours(doc, colours) -> None:
    """Give the parts of a document their colours (object name -> "#rrggbb"), where there is a window."""
    for name, text in colours.items():
        obj = doc.getObject(name)
        if obj is not None and getattr(obj, "ViewObject", None) is not None:
            obj.ViewObject.ShapeColor = tuple(int(text[i : i + 2], 16) / 255.0 for i in (1, 3, 5))


def _bodies(doc, labels):
    found = {}
    for body, (name, label) in labels.items():
        part = doc.addObject("App::Part", name)
        part.Label = label
        found[body] = _Body(part)
    return found


# -- what the machines share -----------------------------------------------------------------------------------------
def _ways(lower, upper, axis, seats, span, centres, up="Z", sign=1):
    """Rails on `lower` and guide blocks on `upper`: one rail per seat, a block at each of `centres` on each."""
    rails = [rail(axis, seat, *span, up, sign) for seat in seats]
    lower.add(f"Ways{axis}", f"Ways {axis}", Part.makeCompound(rails), GROUND)
    return [block(axis, seat, c, up=up, sign=sign) for seat in seats for c in centres]


def _drive(lower, upper, axis, at, span, seat, nut_at, motor_at, blocks, up="Z", size=55.0):
    """Ball screw with bearings and motor on `lower`; its nut on `upper`, with the guide blocks."""
    shape = union(
        screw(axis, at, *span), bearing(axis, at, span[0] + 18, seat, up), bearing(axis, at, span[1] - 18, seat, up)
    )
    lower.add(f"Screw{axis}", f"Ball screw {axis}", shape, SCREW)
    drive = motor(axis, at, motor_at, 150 if motor_at >= span[1] else -150, size)
    lower.add(f"Motor{axis}", f"Servo motor {axis}", drive, MOTOR)
    upper.add(
        f"Blocks{axis}", f"Guide blocks and nut {axis}", Part.makeCompound([*blocks, nut(axis, at, nut_at)]), STEEL
    )


def _spindle(body, at, nose, tip, top, radius=62):
    """Spindle cartridge from `top` down to its nose, holder and end mill; frames at nose and tip."""
    x, y = at
    body.add(
        "SpindleNose",
        "Spindle",
        union(
            cylinder("Z", (x, y, 0), radius, nose + 40, top),
            cone("Z", (x, y, 0), radius * 0.72, radius, nose + 12, nose + 40),
            cylinder("Z", (x, y, 0), radius * 0.72, nose, nose + 12),
        ),
        GROUND,
    )
    body.add("ToolHolder", "Tool holder", tool_holder((x, y, 0), nose, nose - 62), DARK)
    body.add("EndMill", "End mill", end_mill((x, y, 0), tip, nose - 60), TOOL)
    body.nose = body.frame("SpindleFrame", "Spindle nose", (x, y, nose))
    body.tip = body.frame("ToolTip", "Tool point", (x, y, tip))


def _workpiece(body, top, x=0.0, y=0.0):
    """A machine vice on the table (z = top) with a milled part in its jaws."""
    vice = union(
        box((x - 150, x + 150), (y - 75, y + 75), (top, top + 34), radius=14),
        box((x - 110, x - 70), (y - 70, y + 70), (top + 33, top + 78)),
        box((x + 62, x + 102), (y - 70, y + 70), (top + 33, top + 78)),
        cylinder("X", (0, y, top + 54), 12, x + 100, x + 190),
    )
    body.add("Vice", "Machine vice", vice, DARK)
    part = without(
        box((x - 70, x + 62), (y - 52, y + 52), (top + 36, top + 98), radius=8),
        window("Z", (x - 44, x + 34), (y - 28, y + 28), top + 72, top + 99, 12),
        *(cylinder("Z", (x + dx, y + dy, 0), 5, top + 60, top + 99) for dx in (-58, 50) for dy in (-40, 40)),
    )
    body.add("Workpiece", "Workpiece", part, WORK)
    body.datum = body.frame("WorkpieceFrame", "Workpiece zero", (x, y, top))


def _column(body, name, label, x, y_front, depth, z, taper=60):
    """Ribbed column: wide foot, narrower top, openings through its sides and back, a cap."""
    middle = sum(x) / 2
    half = (x[1] - x[0]) / 2
    shape = tower((x, (y_front, y_front + depth)), ((x[0] + taper, x[1] - taper), (y_front, y_front + depth * 0.72)), z)
    height = z[1] - z[0]
    cuts = []
    for i in range(3):
        low = z[0] + height * (0.08 + 0.3 * i)
        high = low + height * 0.23
        back = y_front + depth * (0.86 - 0.11 * i)
        cuts.append(window("X", (y_front + depth * 0.3, back), (low, high), x[0] - 1, x[1] + 1, 36))
        inner = half * 0.55 - 12 * i
        cuts.append(
            window("Y", (middle - inner, middle + inner), (low, high), y_front + depth * 0.4, y_front + depth + 1, 30)
        )
    cap = box(
        (x[0] + taper - 14, x[1] - taper + 14), (y_front - 4, y_front + depth * 0.75), (z[1] - 2, z[1] + 34), radius=16
    )
    body.add(name, label, union(without(shape, *cuts), cap), PAINT)


def _head(body, z, y_back, y_front, half=165):
    """Headstock reaching from the column's guide blocks to the spindle: full section at the back, slim nose."""
    low, high = z
    profile = [
        (y_back, low + 10),
        (y_back - 90, low - 20),
        (y_front + 60, low),
        (y_front, low + 40),
        (y_front, high - 150),
        (y_front + 70, high - 60),
        (y_back - 70, high),
        (y_back, high),
    ]
    shape = prism("X", profile, -half, half)
    slim = [
        box((s * half - 70 * (s > 0), s * half + 70 * (s < 0)), (y_front - 1, y_front + 190), (low - 30, high + 1))
        for s in (-1, 1)
    ]
    pockets = [
        window("X", (y_front + 250, y_back - 70), (low + 90, high - 110), a, b, 30)
        for a, b in ((-half - 1, -half + 28), (half - 28, half + 1))
    ]
    bore = cylinder("Z", (0, 0, 0), 63, low - 30, low + 60)
    body.add("Headstock", "Headstock", without(shape, *slim, *pockets, bore), PAINT)


# -- XYFZ ------------------------------------------------------------------------------------------------------------
def _machining_centre(doc):
    """C-frame: X table on Y saddle in front of a fixed column that carries the headstock.  Table top at z = 0."""
    b = _bodies(
        doc,
        {
            "F": ("Frame", "Bed and column"),
            "Y": ("Saddle", "Saddle (Y)"),
            "X": ("Table", "Table (X)"),
            "Z": ("Head", "Headstock (Z)"),
            "T": ("Spindle", "Spindle and tool"),
            "W": ("Fixture", "Workpiece and vice"),
        },
    )
    frame, saddle, table, head = b["F"], b["Y"], b["X"], b["Z"]
    base = ribbed_base(
        (-400, 400),
        (-560, 960),
        (-760, -400),
        [
            ("X", (-440, -120), (-690, -480)),
            ("X", (-40, 280), (-690, -480)),
            ("X", (420, 820), (-690, -480)),
            ("Y", (-290, -40), (-690, -500)),
            ("Y", (40, 290), (-690, -500)),
        ],
    )
    feet = [cylinder("Z", (x, y, 0), 55, -800, -755) for x in (-330, 330) for y in (-490, 200, 890)]
    frame.add("Bed", "Bed casting", union(base, *feet), CAST)
    _column(frame, "Column", "Column", (-330, 330), 480, 470, (-402, 1240))
    blocks = _ways(frame, saddle, "Y", [(-250, 0, -400), (250, 0, -400)], (-450, 450), (-165, 165))
    _drive(frame, saddle, "Y", (0, 0, -364), (-470, 450), -400, 0, -470, blocks)
    blocks = _ways(frame, head, "Z", [(-190, 480, 0), (190, 480, 0)], (190, 1230), (530, 890), up="Y", sign=-1)
    _drive(frame, head, "Z", (0, 444, 0), (180, 1240), 480, 700, 1275, blocks, up="Y")
    magazine = union(
        cylinder("X", (0, 560, 800), 235, -560, -470),
        cylinder("X", (0, 560, 800), 70, -470, -250),
        *(
            cylinder(
                "X",
                (
                    0,
                    560 + 185 * App.Rotation(V(1, 0, 0), 30 * i).multVec(V(0, 1, 0)).y,
                    800 + 185 * App.Rotation(V(1, 0, 0), 30 * i).multVec(V(0, 1, 0)).z,
                ),
                38,
                -600,
                -555,
            )
            for i in range(12)
        ),
    )
    frame.add("Magazine", "Tool magazine", magazine, DARK)

    wings = prism("Y", [(-480, -170), (480, -170), (480, -215), (340, -342), (-340, -342), (-480, -215)], -215, 215)
    wings = without(
        wings,
        *(window("Z", a, (-115, -45), -240, -160, 25) for a in ((-430, -60), (60, 430))),
        *(window("Z", a, (45, 115), -240, -160, 25) for a in ((-430, -60), (60, 430))),
    )
    wings = without(wings, box((-481, 481), (-45, 45), (-188, -169)))  # the screw's channel
    saddle.add("SaddleCasting", "Saddle casting", wings, CAST)
    blocks = _ways(saddle, table, "X", [(0, -150, -170), (0, 150, -170)], (-480, 480), (-180, 180))
    _drive(saddle, table, "X", (0, 0, -152), (-480, 480), -188, 0, 480, blocks, size=33.0)
    saddle.scale = saddle.frame("ScaleY", "Read head Y", (290, 0, -330))

    table.add("TableTop", "Table", slotted_table((-450, 450), (-215, 215), (-112, 0)), STEEL)
    table.scale = table.frame("ScaleX", "Read head X", (0, -200, -120))

    _head(head, (470, 960), 422, -110)
    head.add(
        "SpindleMotor",
        "Spindle motor",
        union(cylinder("Z", (0, 40, 0), 92, 860, 1130), cylinder("Z", (0, 40, 0), 78, 1130, 1150)),
        MOTOR,
    )
    head.scale = head.frame("ScaleZ", "Read head Z", (215, 430, 700))
    _spindle(b["T"], (0, 0), 430, 320, 520)
    _workpiece(b["W"], 0)
    return b, {"X": (-250.0, 250.0), "Y": (-200.0, 200.0), "Z": (-200.0, 200.0)}


# -- FXYZ ------------------------------------------------------------------------------------------------------------
def _gantry(doc):
    """Bridge type: a beam travels along X on two walls, a carriage along Y on the beam, a ram along Z in it."""
    b = _bodies(
        doc,
        {
            "F": ("Frame", "Bed and walls"),
            "X": ("Bridge", "Bridge (X)"),
            "Y": ("Carriage", "Carriage (Y)"),
            "Z": ("Ram", "Ram (Z)"),
            "T": ("Spindle", "Spindle and tool"),
            "W": ("Fixture", "Workpiece and vice"),
        },
    )
    frame, bridge, carriage, ram = b["F"], b["X"], b["Y"], b["Z"]
    base = ribbed_base(
        (-980, 980),
        (-520, 520),
        (-480, -110),
        [("Y", (a, a + 380), (-410, -190)) for a in (-900, -420, 60, 520)]
        + [("X", (-420, -60), (-400, -200)), ("X", (60, 420), (-400, -200))],
    )
    frame.add("Bed", "Bed casting", base, CAST)
    frame.add("TableTop", "Table", slotted_table((-900, 900), (-470, 470), (-112, 0), slots=7), STEEL)
    for side, name in ((-1, "Right"), (1, "Left")):
        y = sorted((side * 560, side * 720))
        wall = ribbed_base(
            (-1180, 980), y, (-480, 560), [("Y", (a, a + 370), (-60, 420)) for a in (-1080, -580, -80, 420)], wall=30
        )
        foot = box((-1180, 980), sorted((side * 515, side * 760)), (-480, -380), radius=20)
        frame.add(f"Wall{name}", f"{name} wall", union(wall, foot), PAINT)
    blocks = _ways(frame, bridge, "X", [(0, -640, 560), (0, 640, 560)], (-1160, 960), (-530, -170))
    _drive(frame, bridge, "X", (0, -775, 480), (-1160, 960), -720, -350, -1160, blocks, up="Y")

    beam = without(
        box((-500, -200), (-740, 740), (700, 1060), radius=24, along="Y"),
        window("Y", (-455, -245), (745, 1015), -741, 741, 30),
        *(window("Z", (-430, -270), (y, y + 220), 690, 1070, 40) for y in (-560, -280, 60, 340)),
    )
    bridge.add("Beam", "Cross beam", beam, PAINT)
    for side, name in ((-1, "Right"), (1, "Left")):
        y = sorted((side * 560, side * 725))
        truck = prism("Y", [(-600, 618), (-100, 618), (-100, 650), (-200, 702), (-500, 702), (-600, 650)], *y)
        if side < 0:  # the arm that takes the ball nut
            truck = union(
                truck, box((-395, -305), (-812, -724), (618, 660)), box((-395, -305), (-812, -738), (500, 630))
            )
            truck = without(truck, cylinder("X", (0, -775, 480), 30, -400, -300))
        bridge.add(f"Truck{name}", f"{name} end truck", truck, CAST)
    blocks = _ways(bridge, carriage, "Y", [(-200, 0, 760), (-200, 0, 1000)], (-660, 660), (-150, 150), up="X")
    _drive(bridge, carriage, "Y", (-160, 0, 880), (-660, 660), -200, 0, 660, blocks, up="X", size=34.0)
    bridge.scale = bridge.frame("ScaleX", "Read head X", (-350, -700, 600))

    slide = without(
        box((-142, -92), (-210, 210), (680, 1090), radius=30, along="X"),
        window("X", (-50, 50), (1010, 1070), -150, -90, 20),
    )
    carriage.add("Slide", "Carriage", slide, CAST)
    guides = [block("Z", (-34, y, 0), c, up="X", sign=-1) for y in (-75, 75) for c in (760, 1010)]
    carriage.add("BlocksZ", "Guide blocks Z", Part.makeCompound(guides), STEEL)
    carriage.add("MotorZ", "Servo motor Z", motor("Z", (-117, 0, 0), 1090, 170, 38), MOTOR)
    carriage.scale = carriage.frame("ScaleY", "Read head Y", (-160, 0, 700))

    ram.add(
        "RamCasting",
        "Ram",
        without(
            box((-34, 146), (-110, 110), (450, 1370), radius=22),
            window("Z", (10, 102), (-66, 66), 700, 1371, 20),
            cylinder("Z", (56, 0, 0), 71, 449, 650),
        ),
        PAINT,
    )
    ways = [rail("Z", (-34, y, 0), 500, 1330, up="X", sign=-1) for y in (-75, 75)]
    ram.add("WaysZ", "Ways Z", Part.makeCompound(ways), GROUND)
    ram.scale = ram.frame("ScaleZ", "Read head Z", (-40, 100, 880))
    _spindle(b["T"], (56, 0), 410, 300, 640, radius=70)
    _workpiece(b["W"], 0, 56)
    return b, {"X": (-500.0, 500.0), "Y": (-400.0, 400.0), "Z": (-190.0, 190.0)}


# -- YFXZ ------------------------------------------------------------------------------------------------------------
def _travelling_column(doc):
    """T-shaped bed: the column with its headstock travels along X behind, the table along Y in front."""
    b = _bodies(
        doc,
        {
            "F": ("Frame", "Bed"),
            "Y": ("Table", "Table (Y)"),
            "X": ("ColumnSlide", "Column (X)"),
            "Z": ("Head", "Headstock (Z)"),
            "T": ("Spindle", "Spindle and tool"),
            "W": ("Fixture", "Workpiece and vice"),
        },
    )
    frame, table, column, head = b["F"], b["Y"], b["X"], b["Z"]
    rear = ribbed_base(
        (-900, 900),
        (470, 1080),
        (-640, -330),
        [("Y", (a, a + 340), (-580, -410)) for a in (-840, -420, 80, 500)] + [("X", (560, 990), (-580, -410))],
    )
    front = ribbed_base(
        (-330, 330),
        (-640, 480),
        (-640, -210),
        [("X", (-560, -240), (-570, -300)), ("X", (-160, 160), (-570, -300)), ("Y", (-230, 230), (-560, -300))],
        wall=30,
    )
    frame.add("RearBed", "Column bed (X)", rear, CAST)
    frame.add("FrontBed", "Table bed (Y)", front, CAST)
    blocks = _ways(frame, column, "X", [(0, 560, -330), (0, 990, -330)], (-890, 890), (-215, 215))
    _drive(frame, column, "X", (0, 775, -294), (-880, 880), -330, 0, 880, blocks)
    blocks = _ways(frame, table, "Y", [(-220, 0, -210), (220, 0, -210)], (-560, 460), (-170, 170))
    _drive(frame, table, "Y", (0, 0, -174), (-570, 450), -210, 0, -570, blocks)

    column.add("ColumnFoot", "Column slide", ribbed_base((-340, 340), (500, 1050), (-272, -170), [], wall=30), CAST)
    _column(column, "Column", "Column", (-300, 300), 500, 500, (-172, 1220), taper=50)
    blocks = _ways(column, head, "Z", [(-180, 500, 0), (180, 500, 0)], (130, 1200), (480, 840), up="Y", sign=-1)
    _drive(column, head, "Z", (0, 464, 0), (120, 1210), 500, 650, 1245, blocks, up="Y")
    column.scale = column.frame("ScaleX", "Read head X", (0, 1040, -300))

    apron = without(
        box((-290, 290), (-235, 235), (-152, -110), radius=20), window("Z", (-160, 160), (-150, 150), -160, -100, 40)
    )
    table.add("TableSlide", "Table slide", apron, CAST)
    table.add("TableTop", "Table", slotted_table((-420, 420), (-250, 250), (-112, 0), slots=6), STEEL)
    table.scale = table.frame("ScaleY", "Read head Y", (270, 0, -150))

    _head(head, (420, 910), 442, -110)
    head.add(
        "SpindleMotor",
        "Spindle motor",
        union(cylinder("Z", (0, 40, 0), 92, 810, 1080), cylinder("Z", (0, 40, 0), 78, 1080, 1100)),
        MOTOR,
    )
    head.scale = head.frame("ScaleZ", "Read head Z", (205, 450, 650))
    _spindle(b["T"], (0, 0), 380, 270, 470)
    _workpiece(b["W"], 0)
    return b, {"X": (-500.0, 500.0), "Y": (-220.0, 220.0), "Z": (-165.0, 240.0)}
