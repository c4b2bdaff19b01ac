# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shapes that machine tools are made of: ribbed castings, linear ways with their blocks, ball screws, motors, tables.

All in mm, in the coordinates of the machine; an axis is named by its letter.  Used by the example machines.
"""

from __future__ import annotations

import FreeCAD as App
import Part

V = App.Vector
UNIT = {"X": V(1, 0, 0), "Y": V(0, 1, 0), "Z": V(0, 0, 1)}


def box(x, y, z, radius: float = 0.0, along: str = "Z"):
    """Block over the ranges x, y, z = (low, high); edges along an axis rounded by `radius`."""
    shape = Part.makeBox(x[1] - x[0], y[1] - y[0], z[1] - z[0], V(x[0], y[0], z[0]))
    if radius:
        index = "XYZ".index(along)
        edges = [e for e in shape.Edges if abs(abs(e.tangentAt(e.FirstParameter)[index]) - 1) < 1e-9]
        shape = shape.makeFillet(radius, edges)
    return shape


def cylinder(along: str, centre, radius: float, low: float, high: float):
    """Cylinder along an axis through `centre` (its coordinate along the axis is ignored) from `low` to `high`."""
    base = V(*centre)
    setattr(base, along.lower(), low)
    return Part.makeCylinder(radius, high - low, base, UNIT[along])


def cone(along: str, centre, radius_low: float, radius_high: float, low: float, high: float):
    """Return a truncated cone between `low` and `high` along an axis."""
    base = V(*centre)
    setattr(base, along.lower(), low)
    return Part.makeCone(radius_low, radius_high, high - low, base, UNIT[along])


def prism(along: str, outline, low: float, high: float):
    """Extruded outline.  outline : points in the plane across the axis: (y, z) for X, (x, z) for Y, (x, y) for Z."""
    place = {"X": lambda a, b: V(low, a, b), "Y": lambda a, b: V(a, low, b), "Z": lambda a, b: V(a, b, low)}[along]
    points = [place(a, b) for a, b in outline]
    return Part.Face(Part.makePolygon([*points, points[0]])).extrude(UNIT[along] * (high - low))


def tower(bottom, top, z):
    """Column over two rectangles ((x0, x1), (y0, y1)) at z[0] and z[1]."""
    wires = []
    for (x, y), height in ((bottom, z[0]), (top, z[1])):
        corners = [V(x[0], y[0], height), V(x[1], y[0], height), V(x[1], y[1], height), V(x[0], y[1], height)]
        wires.append(Part.makePolygon([*corners, corners[0]]))
    return Part.makeLoft(wires, True, True)


def union(*shapes):
    """Return one solid made of several."""
    return shapes[0].multiFuse(list(shapes[1:])).removeSplitter() if len(shapes) > 1 else shapes[0]


def without(shape, *cuts):
    """Return a solid with others cut out of it."""
    return shape.cut(Part.makeCompound(list(cuts)))


def window(along: str, a, b, low: float, high: float, radius: float):
    """A rounded opening through a wall, to be cut: ranges a, b across the axis as in `prism`, from low to high."""
    ranges = {"X": ((low, high), a, b), "Y": (a, (low, high), b), "Z": (a, b, (low, high))}[along]
    return box(*ranges, radius=radius, along=along)


# -- linear ways -----------------------------------------------------------------------------------------------------
_RAIL = [
    (-17, 0),
    (17, 0),
    (17, 14),
    (12, 18),
    (12, 24),
    (17, 28),
    (17, 38),
    (-17, 38),
    (-17, 28),
    (-12, 24),
    (-12, 18),
    (-17, 14),
]
_BLOCK = [(-42, 8), (-20, 8), (-20, 42), (20, 42), (20, 8), (42, 8), (42, 52), (36, 58), (-36, 58), (-42, 52)]


def _section(along: str, outline, at, up: str, sign: int):
    """Outline (across, up) placed at a point `at` on the mounting surface, as points for `prism`."""
    order = {"X": "YZ", "Y": "XZ", "Z": "XY"}[along]
    centre = dict(zip("XYZ", at))
    across = order.replace(up, "")
    points = []
    for a, h in outline:
        place = {across: centre[across] + a, up: centre[up] + sign * h}
        points.append((place[order[0]], place[order[1]]))
    return points


def rail(along: str, at, low: float, high: float, up: str = "Z", sign: int = 1):
    """Return a profiled rail on a surface: `at` is a point of its seat, `up` and `sign` the side on which it
    projects.
    """
    shape = prism(along, _section(along, _RAIL, at, up, sign), low, high)
    holes, count = [], max(2, int((high - low) // 120))
    for i in range(count):
        centre = dict(zip("XYZ", at))
        centre[along] = low + (high - low) * (i + 0.5) / count
        start = V(*centre.values()) + UNIT[up] * (sign * 26)
        holes.append(Part.makeCylinder(7, 14, start, UNIT[up] * sign))
    return without(shape, *holes)


def block(along: str, at, centre: float, half: float = 45.0, up: str = "Z", sign: int = 1):
    """Return a guide block on the rail whose seat is at `at`, with its middle at `centre` along the axis, 58 mm
    above the seat.
    """
    return prism(along, _section(along, _BLOCK, at, up, sign), centre - half, centre + half)


# -- drives ----------------------------------------------------------------------------------------------------------
def screw(along: str, at, low: float, high: float, radius: float = 16.0):
    """Ball screw: thread between journals, with rounded grooves hinted at by its two diameters."""
    body = cylinder(along, at, radius, low + 40, high - 40)
    return union(body, cylinder(along, at, radius * 0.7, low, high))


def nut(along: str, at, centre: float, radius: float = 32.0):
    """Ball nut with its flange; bored for the screw."""
    shape = union(
        cylinder(along, at, radius * 0.78, centre - 55, centre + 40),
        cylinder(along, at, radius, centre + 25, centre + 40),
    )
    return without(shape, cylinder(along, at, radius * 0.5, centre - 60, centre + 60))


def bearing(along: str, at, centre: float, seat: float, up: str = "Z", half: float = 22.0):
    """Pillow block of a screw at `at`, standing on a surface whose coordinate along `up` is `seat`."""
    ranges = {n: (v - 36, v + 36) for n, v in zip("XYZ", at)}
    ranges[along] = (centre - half, centre + half)
    level = dict(zip("XYZ", at))[up]
    ranges[up] = (min(seat, level - 20), max(seat, level + 20))
    return without(box(*ranges.values()), cylinder(along, at, 14, centre - half - 1, centre + half + 1))


def motor(along: str, at, start: float, length: float, size: float = 55.0):
    """Servo motor from `start` (negative length: to the other side): flange, body and connector."""
    low, high = sorted((start, start + length))
    ranges = {n: (v - size, v + size) for n, v in zip("XYZ", at)}
    ranges[along] = (low, high)
    body = box(*ranges.values(), radius=size * 0.3, along=along)
    flange = {n: (v - size - 6, v + size + 6) for n, v in zip("XYZ", at)}
    flange[along] = (start, start + 14) if length > 0 else (start - 14, start)
    return union(body, box(*flange.values()))


# -- tables and tools ------------------------------------------------------------------------------------------------
def slotted_table(x, y, z, slots: int = 5, along: str = "X"):
    """Table with T-slots along an axis, a chamfered rim and a hollow underside."""
    shape = box(x, y, z, radius=12)
    width = (y if along == "X" else x)[1] - (y if along == "X" else x)[0]
    middle = sum(y if along == "X" else x) / 2
    run = x if along == "X" else y
    profile = [(-9, 1), (9, 1), (9, -22), (17, -22), (17, -36), (-17, -36), (-17, -22), (-9, -22)]
    cuts = []
    for i in range(slots):
        a = middle + width * ((i + 0.5) / slots - 0.5)
        cuts.append(prism(along, [(a + p, z[1] + h) for p, h in profile], run[0] - 1, run[1] + 1))
    return without(shape, *cuts)


def tool_holder(at, nose: float, bottom: float):
    """Taper holder with its gripper flange below the spindle nose (z = nose) down to `bottom`."""
    length = nose - bottom
    return union(
        cylinder("Z", at, 31, nose - 20, nose),
        cylinder("Z", at, 26, nose - 34, nose - 20),
        cone("Z", at, 17, 24, bottom, bottom + length - 34),
    )


def end_mill(at, tip: float, top: float, radius: float = 8.0):
    """End mill from its tip up to the holder: fluted end, plain shank."""
    fluted = cylinder("Z", at, radius, tip, tip + 26)
    flutes = []
    for i in range(3):
        offset = App.Rotation(V(0, 0, 1), 120 * i).multVec(V(radius, 0, 0))
        flutes.append(cylinder("Z", (at[0] + offset.x, at[1] + offset.y, 0), radius * 0.45, tip - 1, tip + 24))
    return union(without(fluted, *flutes), cylinder("Z", at, radius, tip + 25.5, top))


def ribbed_base(x, y, z, pockets, wall: float = 40.0):
    """Casting with rounded corners and pockets in its sides.

    pockets : (along, a, b) openings right through the casting, rounded, as in `window`.
    """
    shape = box(x, y, z, radius=wall)
    ranges = {"X": x, "Y": y, "Z": z}
    cuts = [
        window(n, a, b, ranges[n][0] - 1, ranges[n][1] + 1, min(a[1] - a[0], b[1] - b[0]) / 3) for n, a, b in pockets
    ]
    return without(shape, *cuts)
