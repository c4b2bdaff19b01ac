# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tool path of a document: the operations of a CAM job, or other Path objects, written as a program; its tools, and
the faces of the job's model.

FreeCAD's Path objects hold G-code in mm, with feeds in mm/s, in the coordinates of the document.  Where the machine
stands in the same document, the work offset follows: a place is reached when the tool point is there.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

import FreeCAD as App
import numpy as np

from ..core.contact import Cutter, Face
from ..core.machine import Machine
from ..core.refusal import Refused
from ..formats import provenance
from ..formats.gcode import Tool
from ..formats.part_files import Given
from . import part_faces

_FEEDS = ("G1", "G01", "G2", "G02", "G3", "G03", "G73", "G81", "G82", "G83", "G84", "G85", "G86", "G88", "G89")
MM_S = 60.0  # mm/min


@dataclass(frozen=True)
class CamPath:
    """text : the program.  tools : number -> Tool.  operations : label -> first and last N word.  cutters : number ->
    shape, of tools whose shape is known.  faces : of the model; `models` : the objects that they belong to."""

    text: str
    tools: Mapping[int, Tool] = field(default_factory=dict)
    operations: Mapping[str, tuple[int, int]] = field(default_factory=dict)
    cutters: Mapping[int, Cutter] = field(default_factory=dict)
    faces: tuple[Face, ...] = ()
    models: tuple = ()


def load(path, model: str = "") -> CamPath:
    """The tool path of a document's file.  model : label of the solid that is made, "" for that of the job."""
    if not Path(path).is_file():
        raise Refused("document-file-missing", str(path))
    provenance.note_file(path)
    already = {d.Name for d in App.listDocuments().values()}
    try:
        document = App.openDocument(str(Path(path).absolute()))
    except Exception as error:  # noqa: BLE001 - FreeCAD raises whatever the damaged part makes it raise
        raise Refused("document-cannot-be-opened", str(path), reason=str(error).strip()) from None
    try:
        return of_document(document, model)
    except Refused as refused:
        raise refused.at(str(path)) from None
    finally:
        if document.Name not in already:
            App.closeDocument(document.Name)


def has_path(document) -> bool:
    """Whether a document holds a tool path, asked without computing anything."""
    return any(getattr(o, "Path", None) is not None and hasattr(o.Path, "Commands") for o in document.Objects)


def of_document(document, model: str = "") -> CamPath:
    """The tool path of an open document: that of its one job, else of all its Path objects in their order.

    model : label of the solid that is made, "" for that of the job.
    """
    jobs = [o for o in document.Objects if hasattr(o, "Operations") and hasattr(o, "PostProcessor")]
    if len(jobs) > 1:
        raise Refused("cam-several-jobs", jobs=[j.Label for j in jobs])
    if jobs:
        found = [o for o in jobs[0].Operations.Group if getattr(o, "Active", True)]
    else:
        found = [o for o in document.Objects if getattr(o, "Path", None) is not None and _commands(o)]
    lines, tools, operations, cutters = ["G21 G90 G17 G54"], {}, {}, {}
    number, tool = 0, None
    for operation in found:
        controller = getattr(operation, "ToolController", None)
        if controller is not None:
            now = int(controller.ToolNumber)
            bit = getattr(controller, "Tool", None)
            radius = float(getattr(bit, "Diameter", 0.0)) / 2
            shape = part_faces.cutter(bit, radius)
            tools[now] = Tool(0.0, radius or None, shape is not None and shape.corner == radius > 0)
            if shape is not None:
                cutters[now] = shape
            if now != tool:
                lines.append(f"T{now} M6")
                tool = now
        first = number + 1
        for command in _commands(operation):
            text = _block(command)
            if text:
                number += 1
                lines.append(f"N{number} {text}")
        if number >= first:
            operations[operation.Label] = (first, number)
    if not operations:
        raise Refused("cam-no-path", document.Label)
    models = part_faces.models(document, jobs[0] if jobs else None, model)
    return CamPath("\n".join(lines) + "\n", tools, operations, cutters, part_faces.faces(models), models)


def _commands(operation) -> list:
    path = getattr(operation, "Path", None)
    return list(getattr(path, "Commands", ()))


def _block(command) -> str:
    """The block of a command; empty for a comment."""
    name = command.Name.strip()
    if not name or name.startswith("("):
        return ""
    words = [name]
    for letter, value in command.Parameters.items():
        if letter == "F":
            if name not in _FEEDS:
                continue
            value = value * MM_S
        words.append(f"{letter}{value:.6f}".rstrip("0").rstrip("."))
    return " ".join(words)


def given(found: CamPath, machine: Machine | None) -> Given:
    """The path as a part study takes it.  machine : that of the same document, else None."""
    place = None if machine is None else offset(machine)
    return Given(found.text.encode("latin-1", "replace"), place, found.tools, found.faces, found.cutters)


def offset(machine: Machine) -> tuple[float, ...]:
    """The work offset of paths in the coordinates of the machine's document, per joint, mm.

    Refuses machines whose X, Y, Z are not along those of the document.
    """
    directions = {"X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}
    along = [j.name in directions and np.abs(np.subtract(j.direction, directions[j.name])).max() < 1e-6
             for j in machine.joints]  # fmt: skip
    if not all(along):
        raise Refused("cam-offset-unknown", machine.name)
    return tuple(-machine.tool_point["XYZ".index(j.name)] for j in machine.joints)
