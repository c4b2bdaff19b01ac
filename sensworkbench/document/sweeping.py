# SPDX-License-Identifier: LGPL-2.1-or-later
"""Variants of a document: cells of a spreadsheet and properties take other values, FreeCAD recomputes, the machine is
judged.  The document is never saved.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from ..messages import Refused
from ..studies.sweep import Judged, check_output, judged
from .batch import open_document
from .extract import core_machine

PLACEMENT = ("x", "y", "z")
_CELL = re.compile(r"[A-Za-z]{1,2}[0-9]{1,5}")
_UNIT = re.compile(r"=?\s*[-+0-9.,eE]+\s*([^\d\s].*)?")


class DocumentJudge:
    """Judges variants of one open document; close it with `close`.

    paths : OBJECT.CELL, OBJECT.PROPERTY or OBJECT.Placement.Base.x, objects by name or label.  outputs : as in
    `studies.sweep.Sweep`.  Refuses paths that lead nowhere, or to what an expression decides, and unknown outputs.
    """

    def __init__(self, path, paths: Sequence[str], outputs: Sequence[str]):
        self.opened = open_document(path)
        try:
            self.places = [place(self.opened.document, p) for p in paths]
            machine = core_machine(self.opened.machine)
            self.outputs = [check_output(name, machine) for name in outputs]
        except Refused:
            self.close()
            raise

    def __call__(self, rows) -> list[Judged]:
        return [self._judged(values) for values in rows]

    def _judged(self, values) -> Judged:
        document = self.opened.document
        try:
            for put, value in zip(self.places, values):
                put(float(value))
            document.recompute()
            broken = [o.Label for o in document.Objects if "Invalid" in o.State]
            if broken:
                raise Refused("sweep-recompute", objects=broken[:5])
            return judged(core_machine(self.opened.machine), self.outputs), ""
        except Refused as refused:
            return None, refused.message
        except Exception as error:  # noqa: BLE001 - FreeCAD raises whatever a value makes it raise
            return None, Refused("sweep-recompute", objects=[str(error).strip()[:120]]).message

    def close(self) -> None:
        """Close the document without saving it."""
        self.opened.close()


def value(document, path: str) -> float:
    """The number that stands where `path` leads; 0 where it cannot be read."""
    obj, rest = _object(document, path)
    try:
        found = obj.getPropertyByName(rest) if rest in obj.PropertiesList else None
        if found is None and obj.isDerivedFrom("Spreadsheet::Sheet"):
            found = obj.get(rest)
        if found is None:
            found = obj
            for step in rest.split("."):
                found = getattr(found, step)
        return float(getattr(found, "Value", found))
    except (AttributeError, TypeError, ValueError):
        return 0.0


def _object(document, path: str):
    """(object, the rest of the path) of a path; refuses one that names no object."""
    name, _, rest = path.partition(".")
    obj = document.getObject(name) or next((o for o in document.Objects if o.Label == name), None)
    if obj is None or not rest:
        raise Refused("sweep-object", "parameters", path=path[:80], object=name[:40])
    return obj, rest


def place(document, path: str):
    """A function that puts a number where `path` leads."""
    obj, rest = _object(document, path)
    if obj.isDerivedFrom("Spreadsheet::Sheet") and rest not in obj.PropertiesList:
        return _cell(obj, rest, path)
    if obj.isDerivedFrom("Spreadsheet::Sheet") and obj.getCellFromAlias(rest):
        return _cell(obj, rest, path)
    return _property(obj, rest, path)


def _cell(sheet, name: str, path: str):
    cell = sheet.getCellFromAlias(name) or (name.upper() if _CELL.fullmatch(name) else None)
    if cell is None:
        raise Refused("sweep-cell", "parameters", path=path[:80], cell=name[:40])
    content = sheet.getContents(cell)
    found = _UNIT.fullmatch(content.lstrip("'"))
    if not found:
        raise Refused("sweep-no-value", "parameters", path=path[:80])
    unit = (found.group(1) or "").strip()
    return lambda value: sheet.set(cell, f"={value!r} {unit}" if unit else repr(value))


def _property(obj, rest: str, path: str):
    top = rest.split(".")[0]
    if top not in obj.PropertiesList:
        raise Refused("sweep-property", "parameters", path=path[:80], property=top[:40])
    decided = [str(e[0]).lstrip(".") for e in obj.ExpressionEngine]
    if any(e in (rest, top) or rest.startswith(e + ".") for e in decided):
        raise Refused("sweep-expression", "parameters", path=path[:80])
    if rest.startswith("Placement.Base.") and rest.rpartition(".")[2] in PLACEMENT:
        axis = rest.rpartition(".")[2]

        def put(value: float):
            placement, base = obj.Placement, obj.Placement.Base
            setattr(base, axis, value)
            placement.Base = base
            obj.Placement = placement

        return put
    value = getattr(obj, top)
    if rest != top or isinstance(value, (bool, str)) or not _is_number(value):
        raise Refused("sweep-no-value", "parameters", path=path[:80])
    kind = type(value)
    return lambda number: setattr(obj, top, int(number) if kind is int else number)


def _is_number(value) -> bool:
    try:
        float(value)
    except (TypeError, ValueError):
        return False
    return True
