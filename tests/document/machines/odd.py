# SPDX-License-Identifier: LGPL-2.1-or-later
# ruff: noqa: E501 - tables that are read by column
"""What is no serial machine with three linear axes, and what is no machine at all."""

from __future__ import annotations

import math

import Part

from . import V, add, bored, box, part, rod, vslot
from .kinds import KINDS


def _strut(start, end, radius=3):
    return Part.makeCylinder(radius, (end - start).Length, start, end - start)


def _at(radius, angle, z=0.0):
    return V(radius * math.cos(math.radians(angle)), radius * math.sin(math.radians(angle)), z)


def linear_delta(doc, names=True):
    """Three upright rods in pairs, a carriage on each, six arms, a platform."""
    n = iter(range(1000, 2000))
    label = (lambda text: text) if names else (lambda text: str(next(n)))
    for k in range(3):
        a = 90 + 120 * k
        at = _at(160, a)
        for s in (-20, 20):
            p = at + _at(s, a + 90)
            add(doc, label("Rod 8x600"), rod((p.x, p.y, 0), "z", 600, 4))
        add(doc, label("Slider"), Part.makeCylinder(35, 40, at + V(0, 0, 350)))
        for s in (-15, 15):
            add(doc, label("Rod arm"), _strut(_at(140, a, 360) + _at(s, a + 90), _at(25, a, 150) + _at(s, a + 90)))
    add(doc, label("Platform"), Part.makeCylinder(40, 10, V(0, 0, 140)))
    add(doc, label("Bottom plate"), Part.makeCylinder(200, 12, V(0, 0, -12)))
    add(doc, label("Top plate"), Part.makeCylinder(200, 12, V(0, 0, 600)))


def rotary_delta(doc, names=True):
    """Three motors at the top, an upper arm on each, two rods from it to a platform."""
    n = iter(range(1000, 2000))
    label = (lambda text: text) if names else (lambda text: str(next(n)))
    add(doc, label("Top"), Part.makeCylinder(150, 20, V(0, 0, 500)))
    for k in range(3):
        a = 120 * k
        add(doc, label("Motor"), Part.makeCylinder(20, 40, _at(100, a, 480) - _at(20, a + 90), _at(1, a + 90)))
        elbow = _at(220, a, 400)
        add(doc, label("Upper arm"), _strut(_at(100, a, 480), elbow, 8))
        for s in (-20, 20):
            add(doc, label("Rod"), _strut(elbow + _at(s, a + 90), _at(40, a, 150) + _at(s, a + 90)))
    add(doc, label("Effector" if names else "x"), Part.makeCylinder(50, 10, V(0, 0, 140)))


def hexapod(doc, names=True):
    """A plate on six legs."""
    add(doc, "Base" if names else "1", Part.makeCylinder(200, 20))
    add(doc, "Platform" if names else "2", Part.makeCylinder(120, 15, V(0, 0, 300)))
    for k in range(6):
        below, above = 60 * k + (20 if k % 2 else -20), 60 * (k + k % 2) + (-12 if k % 2 else 12)
        add(doc, "Leg" if names else str(10 + k), _strut(_at(170, below, 20), _at(100, above, 300), 8))


def arm(doc, names=True):
    """Six turning joints, drawn as boxes and drums."""
    rows = (("Base", rod((0, 0, 0), "z", 120, 110)), ("Link 1", rod((0, 0, 120), "z", 90, 90)), ("Link 2", box((-45, 45), (-100, -40), (150, 560))),
            ("Link 3", rod((0, -40, 520), "y", 110, 55)), ("Link 4", box((40, 430), (-35, 35), (480, 560))), ("Link 5", rod((450, -45, 520), "y", 90, 40)),
            ("Link 6", rod((490, 0, 520), "x", 30, 30)))  # fmt: skip
    for n, (label, shape) in enumerate(rows):
        add(doc, label if names else f"Body{n:03d}", shape)


def scara(doc, names=True):
    """Two turning arms and a shaft that slides."""
    rows = (("Robot base", rod((0, 0, 0), "z", 250, 80)), ("Arm J1", box((-60, 300), (-60, 60), (250, 310))), ("Arm J2", box((200, 560), (-50, 50), (310, 370))),
            ("Shaft J3", rod((520, 0, 150), "z", 400, 10)), ("Gripper J4", rod((520, 0, 120), "z", 30, 25)))  # fmt: skip
    for n, (label, shape) in enumerate(rows):
        add(doc, label if names else f"Body{n:03d}", shape)


def bench(doc):
    """A welded table with drawers: nothing of it is a machine."""
    for x in (0, 900):
        for y in (0, 500):
            add(doc, "Leg", box((x, x + 40), (y, y + 40), (0, 800)))
    add(doc, "Top", box((-20, 960), (-20, 560), (800, 840)))
    for z in (300, 500):
        add(doc, "Drawer", box((40, 900), (0, 540), (z, z + 150)).cut(box((50, 890), (10, 530), (z + 10, z + 150))))
        for x in (40, 890):
            add(doc, "Runner", box((x, x + 10), (0, 540), (z - 10, z)))


def engine(doc):
    """A crankshaft, a piston in its bore, a block: it slides, and is no machine tool."""
    block = bored(box((-100, 100), (-100, 100), (0, 300)), (0, 0, 100), "z", 200, 40)
    for label, shape in (("Block", block), ("Piston", rod((0, 0, 200), "z", 60, 40)), ("Rod", box((-8, 8), (-8, 8), (60, 210))),
                         ("Crankshaft", rod((-150, 0, 50), "x", 300, 20)), ("Flywheel", rod((150, 0, 50), "x", 20, 120))):  # fmt: skip
        add(doc, label, shape)


def shelf(doc):
    """A rack of profiles, as the frame of anything."""
    for x in (0, 400):
        for y in (0, 300):
            add(doc, "2020 profile", vslot("z", (x, y, 0), 0, 900))
    for z in (20, 450, 880):
        for y in (0, 300):
            add(doc, "2020 profile", vslot("x", (0, y, z), 10, 390))
        add(doc, "Board", box((-10, 410), (-10, 310), (z + 10, z + 22)))


def inches(doc):
    """A router drawn in inches in a file that says mm."""
    kind = KINDS["gantry"]()
    for body, name in kind.bodies.items():
        holder = part(doc, name)
        for piece in kind.of(body):
            shape = piece.shape.copy()
            shape.scale(1 / 25.4)
            add(doc, piece.label, shape, holder)
    return kind


PARALLEL = {"linear_delta": linear_delta, "rotary_delta": rotary_delta, "hexapod": hexapod}
JOINTED = {"arm": arm, "scara": scara}
NOTHING = {"bench": bench, "engine": engine, "shelf": shelf}
