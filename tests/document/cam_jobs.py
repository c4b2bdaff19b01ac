# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job of FreeCAD's own CAM workbench, made by script on every version: a face, a contour, a pocket, a bore, holes."""

from __future__ import annotations

import importlib

import FreeCAD as App
import Part

V = App.Vector
SIZE, DEPTH = (120.0, 90.0, 50.0), 24.0  # of the plate; of its contour
HOLES = [(20.0, 20.0), (100.0, 20.0), (100.0, 70.0), (20.0, 70.0)]


def _module(new: str, old: str):
    """A module of CAM under its present name, or under that of FreeCAD 0.20."""
    try:
        return importlib.import_module(f"Path.{new}")
    except ImportError:
        return importlib.import_module(f"PathScripts.{old}")


def plate(at=(0.0, 0.0, 0.0)):
    """A plate with a foot: four drilled holes, a bore and a rectangular pocket with round corners."""
    x, y, z = SIZE
    shape = Part.makeBox(x, y, DEPTH, V(0, 0, z - DEPTH)).fuse(Part.makeBox(x + 30, y + 30, z - DEPTH, V(-15, -15, 0)))
    for hx, hy in HOLES:
        shape = shape.cut(Part.makeCylinder(4, 20, V(hx, hy, z - 20)))
    shape = shape.cut(Part.makeCylinder(16, 15, V(38, 45, z - 15)))
    pocket = Part.makeBox(32, 40, 8, V(66, 25, z - 8))
    upright = [e for e in pocket.Edges if abs(e.Vertexes[0].Z - e.Vertexes[-1].Z) > 1]
    shape = shape.cut(pocket.makeFillet(8, upright)).removeSplitter()
    shape.translate(V(*at))
    return shape


def make_job(document, at=(0.0, 0.0, 0.0)):
    """The plate and its job in a document; returns the job."""
    solid = document.addObject("Part::Feature", "Plate")
    solid.Shape = plate(at)
    document.recompute()
    job = _module("Main.Job", "PathJob").Create("Job", [solid], None)
    document.recompute()
    mill = job.Tools.Group[0]
    mill.Tool.Diameter = 10.0
    mill.HorizFeed, mill.VertFeed, mill.SpindleSpeed = "600 mm/min", "200 mm/min", 6000.0
    top, model = at[2] + SIZE[2], job.Model.Group[0]
    faces = list(enumerate(model.Shape.Faces, start=1))
    flat = lambda z: [f"Face{i}" for i, f in faces if f.BoundBox.ZLength < 1e-6 and abs(f.BoundBox.ZMax - z) < 1e-6]  # noqa: E731
    round_ = [f"Face{i}" for i, f in faces if "Cylinder" in f.Surface.TypeId and abs(f.Surface.Radius - 4) < 1e-6]
    face = _operation(job, "MillFace", "PathMillFace", "ObjectFace", mill, top + 1, top, [(model, flat(top))])
    contour = _operation(job, "Profile", "PathProfile", "ObjectProfile", mill, top, at[2] + SIZE[2] - DEPTH,
               [(model, flat(top))])  # fmt: skip
    contour.Side = "Outside"
    pocket = _operation(
        job, "PocketShape", "PathPocketShape", "ObjectPocket", mill, top, top - 8, [(model, flat(top - 8))]
    )
    bore = _operation(
        job, "PocketShape", "PathPocketShape", "ObjectPocket", mill, top, top - 15, [(model, flat(top - 15))]
    )
    holes = _operation(job, "Drilling", "PathDrilling", "ObjectDrilling", mill, top, top - 20, [(model, round_)])
    for operation, pattern in ((face, "ZigZag"), (pocket, "Offset"), (bore, "Offset")):
        operation.StepOver = 60  # per cent of the tool
        setattr(operation, "ClearingPattern" if hasattr(operation, "ClearingPattern") else "OffsetPattern", pattern)
    holes.ToolController = _drill(job)
    document.recompute()
    return job


def _drill(job):
    """A second tool, made after the operations: with two of them CAM asks which one an operation has."""
    drill = _module("Tool.Controller", "PathToolController").Create("Drill", toolNumber=2)
    job.Proxy.addToolController(drill)
    drill.Tool.Diameter = 8.0
    drill.HorizFeed, drill.VertFeed, drill.SpindleSpeed = "400 mm/min", "200 mm/min", 3000.0
    return drill


def _operation(job, new, old, kind, controller, start, final, base):
    """An operation of a job.  The `Create` of drilling asks for a window on FreeCAD 1.0: it is made by its class."""
    module = _module(f"Op.{new}", old)
    made = job.Document.addObject("Path::FeaturePython", new)
    made.Proxy = getattr(module, kind)(made, new, job)
    made.Base = base
    if made.ToolController is not controller:
        made.ToolController = controller
    for name, value in (("StartDepth", start), ("FinalDepth", final), ("StepDown", 10.0)):
        if hasattr(made, name):
            made.setExpression(name, None)
            setattr(made, name, value)
    if hasattr(made, "processHoles"):
        made.processHoles = False
    return made
