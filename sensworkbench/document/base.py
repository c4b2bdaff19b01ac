# SPDX-License-Identifier: LGPL-2.1-or-later
"""What every object of ours shares: declared properties, plain values, saving, restoring, finding.

All state lives in properties; a proxy holds nothing.  Properties are declared once and the same table serves making
and restoring an object.  The window registers one function here that dresses an object; this module knows no window.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import FreeCAD as App

HIDDEN, OUTPUT = 4, 8  # attributes of FreeCAD's addProperty; an output does not touch its object
SHOWN, READ_ONLY, INVISIBLE = 0, 1, 2  # editor modes


@dataclass(frozen=True)
class Property:
    """One declared property: FreeCAD type without "App::Property", name, group, tooltip, value, attribute, mode."""

    kind: str
    name: str
    group: str
    tip: str
    value: object = None
    attribute: int = 0
    mode: int = SHOWN


def result(kind: str, name: str, tip: str, value=None) -> Property:
    """A property that the program writes: output, read-only in the editor."""
    return Property(kind, name, "Results", tip, value, OUTPUT, READ_ONLY)


def coded(name: str, tip: str) -> Property:
    """A sentence that the program writes as code and fields (`told`); the window shows it in its language."""
    return Property("String", name, "Results", tip, None, OUTPUT, INVISIBLE)


def internal(kind: str, name: str, tip: str, value=None) -> Property:
    """A property that the program keeps for itself: output, not shown."""
    return Property(kind, name, "Internal", tip, value, OUTPUT | HIDDEN, INVISIBLE)


def plain(value):
    """`value` with numpy arrays and numbers turned into lists and numbers, and mappings into dicts.

    FreeCAD and json store these; numpy values FreeCAD stores wrongly, or refuses."""
    if hasattr(value, "tolist"):  # not isinstance: this module is loaded at every start, and numpy is not
        return value.tolist()
    if isinstance(value, (list, tuple)):
        return type(value)(plain(v) for v in value)
    if hasattr(value, "items"):
        return {str(k): plain(v) for k, v in value.items()}
    return value


def put(obj, name: str, value) -> None:
    """Set a property from plain or numpy values; three numbers become a vector.  Writes only what differs."""
    value = plain(value)
    kind = obj.getTypeIdOfProperty(name)
    if kind == "App::PropertyVector" and not isinstance(value, App.Vector):
        value = App.Vector(*[float(v) for v in value])
    elif kind == "App::PropertyFloatList":
        value = [float(v) for v in value]
    elif kind == "App::PropertyIntegerList":
        value = [int(v) for v in value]
    elif kind == "App::PropertyStringList":
        value = [str(v) for v in value]
    elif kind == "App::PropertyMap":
        value = {str(k): str(v) for k, v in value.items()}
    if kind in _COMPARABLE and getattr(obj, name) == value:
        return
    if kind in _QUANTITIES and getattr(obj, name).Value == value:
        return
    setattr(obj, name, value)


_COMPARABLE = {
    "App::PropertyVector", "App::PropertyFloatList", "App::PropertyStringList", "App::PropertyString",
    "App::PropertyBool", "App::PropertyInteger", "App::PropertyFloat", "App::PropertyIntegerList", "App::PropertyMap",
    "App::PropertyEnumeration",
}  # fmt: skip
_QUANTITIES = {"App::PropertyDistance", "App::PropertyLength", "App::PropertyAngle"}


def numbers(vector) -> tuple[float, float, float]:
    """Return the components of a vector as a tuple."""
    return (vector.x, vector.y, vector.z)


class SensObject:
    """Base of the proxies.  Subclasses give `kind`, `schema`, `properties` and, where needed, `migrate`."""

    kind = ""
    schema = 1
    properties: tuple[Property, ...] = ()
    choices: dict[str, tuple[str, ...]] = {}  # enumerations: property -> values

    def __init__(self, obj):
        obj.Proxy = self
        self._declare(obj)
        obj.SensType = self.kind
        obj.SchemaVersion = self.schema

    def _declare(self, obj):
        """Add what is missing and set the editor modes (FreeCAD does not keep them)."""
        common = (
            internal("String", "SensType", "What this object is in Sens Workbench", self.kind),
            internal("Integer", "SchemaVersion", "Version of the properties of this object", self.schema),
        )
        for p in common + self.properties:
            if not hasattr(obj, p.name):
                obj.addProperty(f"App::Property{p.kind}", p.name, p.group, p.tip, p.attribute)
                if p.kind == "Enumeration":
                    setattr(obj, p.name, list(self.choices[p.name]))
                if p.value is not None:
                    put(obj, p.name, p.value)
            obj.setEditorMode(p.name, p.mode)

    def onDocumentRestored(self, obj):
        """Bring an older object up to date, one step per schema; runs on every open and changes nothing twice."""
        found = getattr(obj, "SchemaVersion", 0)
        self._declare(obj)
        for step in range(found, self.schema):
            self.migrate(obj, step)
        if obj.SchemaVersion < self.schema:
            obj.SchemaVersion = self.schema
        dress(obj)

    def migrate(self, obj, step: int) -> None:
        """From schema `step` to `step + 1`."""

    def renew(self, obj, old: str, new: str, read: Callable = lambda value: value) -> None:
        """Property `old` of an earlier schema becomes `new` (or the same name with another type).

        read : the stored value -> that of the new property.
        """
        kinds = {p.name: f"App::Property{p.kind}" for p in self.properties}
        if not hasattr(obj, old) or (old == new and obj.getTypeIdOfProperty(old) == kinds[new]):
            return
        value = read(getattr(obj, old))
        obj.removeProperty(old)
        self._declare(obj)
        put(obj, new, value)

    def dumps(self):
        return None

    def loads(self, state):
        return None

    def __getstate__(self):  # FreeCAD up to 0.21
        return None

    def __setstate__(self, state):
        return None


# -- the window's part -----------------------------------------------------------------------------------------------
_dresser: list[Callable] = []


def register_dresser(function: Callable) -> None:
    """`function(obj)` gives a new or restored object its view provider; the window calls this once when it starts."""
    _dresser[:] = [function]


def dress(obj) -> None:
    """Give an object its view provider, if there is a window."""
    if App.GuiUp and getattr(obj, "ViewObject", None) is not None:
        for function in _dresser:
            function(obj)


# -- finding ---------------------------------------------------------------------------------------------------------
def kind_of(obj) -> str:
    """ "Machine", "Axis", "Body", "Tolerances", "Sensitivity", "Effect", or "" for anything else."""
    return getattr(obj, "SensType", "") if hasattr(obj, "SchemaVersion") else ""


def alive(obj) -> bool:
    """False where the object was restored without its proxy (the add-on was missing)."""
    return isinstance(getattr(obj, "Proxy", None), SensObject)


def made_by_newer(obj) -> bool:
    """Whether an object of ours has a schema that this version does not know."""
    return kind_of(obj) != "" and alive(obj) and obj.SchemaVersion > obj.Proxy.schema


def members(group, kind: str) -> list:
    """Return the objects of a kind in a group."""
    return [o for o in group.Group if kind_of(o) == kind]


def quiet(obj) -> bool:
    """True while a change must not be answered: restoring, or undo and redo put values back."""
    document = obj.Document
    return (
        document is None
        or "Restore" in obj.State
        or getattr(document, "Restoring", False)
        or getattr(document, "Transacting", False)
    )
