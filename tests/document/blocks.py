# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small machines of plain blocks whose lever arms can be worked out by hand."""

from __future__ import annotations

import FreeCAD as App

from sensworkbench.core.machine import structure_chains
from sensworkbench.document import factory

V, P, R = App.Vector, App.Placement, App.Rotation
TURNED = P(V(1200, -340, 75), R(V(1, 2, 3), 37))
# the reference points of SPEC's second golden example
REFERENCES = {"X": (30, -180, 200), "Y": (-60, -200, 100), "Z": (15, 100, 600)}
TOOL = (10, -20, -150)


def block(doc, name, at=(0, 0, 0), size=20, parent=None):
    box = doc.addObject("Part::Box", name)
    box.Length = box.Width = box.Height = size
    box.Placement.Base = V(*at)
    if parent is not None:
        parent.addObject(box)
    return box


def point(doc, name, at, parent=None):
    """A free coordinate system."""
    lcs = doc.addObject("PartDesign::CoordinateSystem", name)
    lcs.Placement.Base = V(*at)
    if parent is not None:
        parent.addObject(lcs)
    return lcs


def golden_machine(doc, code="XYFZ", parent=None, references=REFERENCES, tool=TOOL, travel=(-300, 300)):
    """SPEC's golden machine from blocks and coordinate systems; `parent`: an App::Part that holds all of it."""
    workpiece, tool_side = structure_chains(code)
    bed = block(doc, "Bed", (0, 0, -500), parent=parent)
    machine = factory.make_machine(
        doc, workpiece, tool_side, bed=[bed], tool_point=point(doc, "Tip", tool, parent), label="Golden"
    )
    for name in "XYZ":
        carriage = block(doc, f"Carriage{name}", references[name], parent=parent)
        factory.make_axis(
            machine, name, [carriage], travel=travel, reference=point(doc, f"Ref{name}", references[name], parent)
        )
    factory.make_body(machine, "T", [block(doc, "Spindle", tool, parent=parent)])
    factory.make_body(machine, "W", [block(doc, "Part", (0, 0, -400), parent=parent)])
    doc.recompute()
    return machine


def close(a, b, tolerance=1e-9):
    return (V(*a) - V(*b)).Length <= tolerance
