# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a component or error points at in the view: its axis of motion, reference point and Abbe offset, as arrows."""

from __future__ import annotations

from contextlib import suppress

import FreeCAD as App
import Part

from ..core.refusal import Refused
from ..document import geometry, paths, refresh, tree
from ..document.base import kind_of
from . import state
from .arrows import AXIS_COLOURS, OFFSET_COLOUR, POINT_COLOUR, TOOL_COLOUR, Arrow
from .qt import translate
from .texts import body_name, length, point_text, span_text

UP = App.Vector(-1, 1, 2)  # upwards on the screen in the isometric view
OTHER_COLOUR = (0.45, 0.40, 0.15)  # of axes of other names
BODY_COLOURS = {**AXIS_COLOURS, "T": (0.45, 0.25, 0.65), "W": (0.35, 0.35, 0.35)}


def arrows(machine, bodies, *, detail: bool = True, offsets: bool = True) -> list[Arrow]:
    """Arrows for the given bodies (X, Y, Z, T, W); empty where the machine cannot be computed.

    detail : with the axis of motion and the components of the offset, for one body or a few.  offsets : with the
    reference points and Abbe offsets.
    """
    if machine.Problem:
        return []
    try:
        displaced = refresh.latest(machine).displacements
    except Refused:
        return []
    found = []
    for body in bodies:
        obj = tree.body_of(machine, body)
        if obj is None:
            continue
        start = displaced[body].multVec(obj.ReferencePoint)
        offset = obj.AbbeOffset
        name = body_name(machine, body)
        colour = BODY_COLOURS.get(body, OTHER_COLOUR)
        if kind_of(obj) == "Axis" and detail:
            low, high = obj.TravelLower.Value, obj.TravelUpper.Value
            here = obj.Position.Value
            sign = -1 if body in machine.WorkpieceChain else 1
            a = start + obj.Direction * (sign * (low - here))
            b = start + obj.Direction * (sign * (high - here))
            text = f"{name}: {span_text(low, high)}"
            if sign < 0:  # the carriage of a workpiece goes the other way than the tool on it
                text += "\n" + translate("Sens", "for +{name} the table moves to −{name}").format(name=body)
            higher = 1.0 if (b - a).dot(UP) >= 0 else 0.0  # that of the reference point stands below it
            higher = higher if offsets else 1.0  # several axes side by side: their tips are farthest apart
            found.append(Arrow(tuple(a), tuple(b), colour, text, higher))
        if not offsets:
            continue
        text = translate("Sens", "Reference {name}").format(name=name)
        if offset.Length < 1e-6:
            found.append(Arrow(tuple(start), tuple(start), POINT_COLOUR, text, below=True))
            continue
        found.append(Arrow(tuple(start), tuple(start), POINT_COLOUR, text if detail else "", below=True))
        local = [getattr(obj, f"AbbeOffset{k}").Value for k in "XYZ"]
        words = translate("Sens", "Abbe offset {name}: {length}").format(name=name, length=length(offset.Length))
        if detail:
            words += "\n" + point_text(local)
        else:
            words = f"{name}: {length(offset.Length)}"
        found.append(Arrow(tuple(start), tuple(start + offset), OFFSET_COLOUR, words, 0.5))
    return found


def extent(machine) -> float:
    """Return a length that represents the size of the machine, mm."""
    box = App.BoundBox()
    for group in tree.all_parts(machine).values():
        for where in group:
            for leaf in paths.leaves(where):
                shape = leaf.shape()
                if shape is not None and not shape.isNull():
                    box.add(shape.BoundBox)
    return box.DiagonalLength if box.isValid() else 1000.0


def tool_mark(machine) -> list[Arrow]:
    """A mark where the tool point is now; none where it is not chosen or cannot be found."""
    try:
        where = paths.place(machine.ToolPoint) if machine.ToolPoint else None
        point = None if where is None else geometry.point(where, "Automatic")[0]
    except Refused:
        return []
    if point is None:
        return []
    text = translate("Sens", "Tool point") + "\n" + point_text(point)
    return [Arrow(tuple(point), tuple(point), TOOL_COLOUR, text, below=True)]


def show(machine, bodies, *, detail: bool = True, tool: bool = False, offsets: bool = True) -> None:
    """Draw the arrows of some bodies, and with `tool` the mark of the tool point; nothing to draw clears the view."""
    proxy = machine.ViewObject.Proxy
    if not hasattr(proxy, "arrows"):
        return
    bodies = [b for b in bodies if b != "F"]
    mark = tool_mark(machine) if tool else []
    if not bodies and not mark:
        proxy.arrows.clear()
        return
    sizes = state.of(machine.Document).sizes
    if machine.Name not in sizes:
        sizes[machine.Name] = extent(machine)
    proxy.arrows.outline(())
    proxy.arrows.show([*arrows(machine, bodies, detail=detail, offsets=offsets), *mark], sizes[machine.Name])


def clear(machine) -> None:
    """Remove the arrows of a machine from the view."""
    try:
        proxy = machine.ViewObject.Proxy
    except (ReferenceError, NameError, RuntimeError):  # the machine or its document is gone, and its arrows with it
        return
    if hasattr(proxy, "arrows"):
        proxy.arrows.clear()


def point_at(machine, bodies) -> None:
    """Draw the arrows of some bodies and the outlines of their parts, and select their objects in the tree.

    The parts themselves are not selected: they keep the colour of their index.
    """
    import FreeCADGui as Gui

    Gui.Selection.clearSelection(machine.Document.Name)
    for body in bodies:
        obj = tree.body_of(machine, body)
        if obj is not None:
            Gui.Selection.addSelection(obj)
    show(machine, bodies)
    if hasattr(machine.ViewObject.Proxy, "arrows"):
        machine.ViewObject.Proxy.arrows.outline(outlines(machine, bodies))


MOST_EDGES = 600  # of a part whose edges are drawn; one with more is shown by its bounding box


def outlines_of(shapes) -> list:
    """The edges of shapes as lines, each a list of points (mm)."""
    return [line for shape in shapes for line in _edges(shape)]


def outlines(machine, bodies) -> list:
    """The edges of the parts of some bodies as lines, each a list of points (mm, document coordinates)."""
    lines = []
    for body in bodies:
        for where in tree.parts_of(machine, body):
            for leaf in paths.leaves(where):
                shape = leaf.shape()
                if shape is not None and not shape.isNull():
                    lines += _edges(shape)
    return lines


def _edges(shape) -> list:
    size = shape.BoundBox.DiagonalLength
    edges = shape.Edges
    if len(edges) <= MOST_EDGES:
        with suppress(Part.OCCError, RuntimeError, ArithmeticError):  # a broken curve: the box is always there
            return [[tuple(p) for p in edge.discretize(Deflection=max(1e-3, size / 400))] for edge in edges
                    if not edge.Degenerated]  # fmt: skip
    box = shape.BoundBox
    low, high = (box.XMin, box.YMin, box.ZMin), (box.XMax, box.YMax, box.ZMax)
    corners = [[(low, high)[i >> k & 1][k] for k in range(3)] for i in range(8)]
    return [[corners[i], corners[i | 1 << k]] for i in range(8) for k in range(3) if not i >> k & 1]


def select_parts(machine, bodies) -> None:
    """Light up the parts of some bodies through FreeCAD's selection."""
    import FreeCADGui as Gui

    Gui.Selection.clearSelection()
    for body in bodies:
        for where in tree.parts_of(machine, body):
            Gui.Selection.addSelection(where.root.Document.Name, where.root.Name, where.path)


def forget(machine) -> None:
    """Measure the machine again when its arrows are drawn next."""
    state.of(machine.Document).sizes.pop(machine.Name, None)
