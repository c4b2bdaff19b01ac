# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is wrong with the objects of a document, and mending what can be mended without guessing.

An object that was saved where the add-on was missing has lost its Python class but kept its data; lists and settings
may have been edited or cut off.  `examine` only looks; `repair` mends and says what is left for the user to do.
"""

from __future__ import annotations

import json
import math
from dataclasses import dataclass

from ..core.errors import AXES, COMPONENTS, canonical
from ..messages import Refused
from . import closed_loop, objects, studies, tables
from .base import SensObject, alive, dress, kind_of, made_by_newer, members, numbers, put
from .factory import make_tolerances
from .paths import place, places
from .refresh import components, refresh
from .tree import bodies, machines, owner_machine, tolerances_of

CLASSES = {
    c.kind: c
    for module in (objects, closed_loop, studies)
    for c in vars(module).values()
    if isinstance(c, type) and issubclass(c, SensObject) and c.kind
}
_TYPES = ("App::DocumentObjectGroupPython", "App::FeaturePython")
RESULT_LISTS = (
    ("Symbols", "Owners", "First", "Total", "TotalMax", "FirstWeighted", "TotalWeighted", "Lower", "Upper", "Units",
     "Distributions"),
    ("Bodies", "ComponentFirst", "ComponentTotal", "ComponentTotalMax", "ComponentTotalWeighted"),
)  # fmt: skip


@dataclass(frozen=True)
class Problem:
    """One thing that is wrong with an object, and whether `repair` mends it.

    refusal : what is wrong, and what `repair` does or the user has to do; its `where` is a property, or "".
    """

    obj: object
    refusal: Refused
    mendable: bool

    @property
    def what(self) -> str:
        """What is wrong, in English."""
        return f"{self.refusal.where}: {self.refusal.what}" if self.refusal.where else self.refusal.what

    @property
    def do(self) -> str:
        """What `repair` does, or the user has to do, in English."""
        return self.refusal.do

    @property
    def message(self) -> str:
        """Object, what is wrong and what to do, in English."""
        return self.text()

    def text(self, language: str = "en") -> str:
        """Object, what is wrong and what to do, in `language`."""
        return f"{self.obj.Label}: {self.refusal.text(language)}"


def examine(doc) -> list[Problem]:
    """All that is wrong with our objects in a document; nothing is changed."""
    return [problem for obj in doc.Objects if _ours(obj) for problem in _examine(obj)]


def present(doc) -> bool:
    """Whether a document holds objects of ours, sound or not; cheap enough to be asked whenever a menu is updated."""
    return doc is not None and any(_ours(obj) for kind in _TYPES for obj in doc.findObjects(kind))


def examine_object(obj) -> list[Problem]:
    """All that is wrong with one object; nothing for one that is not ours."""
    return list(_examine(obj)) if _ours(obj) else []


def repair(doc) -> list[Problem]:
    """Mend what can be mended; returns what was found (see `Problem.mendable`).  Opens no transaction.

    Values that are there are kept; properties that are missing take their defaults; rows of the tolerance table that
    are not whole take the paper's values; results that are not whole are marked stale.
    """
    found = examine(doc)
    for problem in found:
        if problem.mendable:
            _mend(problem.obj)
    for machine in machines(doc):
        if tolerances_of(machine) is None:
            make_tolerances(machine)
        refresh(machine)
    doc.recompute()
    return found


def _ours(obj) -> bool:
    return getattr(obj, "SensType", "") in CLASSES or isinstance(getattr(obj, "Proxy", None), SensObject)


def _kind(obj) -> str:
    return getattr(obj, "SensType", "") or obj.Proxy.kind


# -- looking ---------------------------------------------------------------------------------------------------------
def _examine(obj):
    cls = CLASSES[_kind(obj)]
    if not alive(obj):
        yield Problem(obj, Refused("problem-without-class"), True)
    elif obj.Proxy.kind != cls.kind:
        yield Problem(obj, Refused("problem-wrong-class", called=cls.kind, found=obj.Proxy.kind), False)
        return
    if made_by_newer(obj):
        newer = Refused("problem-newer-schema", found=obj.SchemaVersion, known=cls.schema)
        yield Problem(obj, newer, False)
        return
    missing = [p.name for p in cls.properties if not hasattr(obj, p.name)]
    if missing or kind_of(obj) == "":
        yield Problem(obj, Refused("problem-missing-properties", names=missing or ["SensType"]), True)
    older = getattr(obj, "SchemaVersion", cls.schema) < cls.schema  # what differs is brought up to date
    for p in cls.properties:
        if not older and p.name not in missing and obj.getTypeIdOfProperty(p.name) != f"App::Property{p.kind}":
            was = obj.getTypeIdOfProperty(p.name).replace("App::Property", "")
            yield Problem(obj, Refused("problem-property-type", name=p.name, found=was, wanted=p.kind), False)
    look = {"Machine": _machine, "Axis": _axis, "Body": _body, "Tolerances": _table, "Sensitivity": _result,
            "Effect": _effect, "Study": _study}.get(cls.kind)  # fmt: skip
    if look is not None and not missing:
        yield from look(obj)


def _machine(obj):
    if tolerances_of(obj) is None:
        yield Problem(obj, Refused("problem-no-tolerance-table"), True)
    found = [(getattr(o, kind, ""), o) for kind in ("Axis", "Body") for o in members(obj, kind)]
    for name in sorted({name for name, _ in found}):
        same = [o for other, o in found if other == name]
        if len(same) > 1:
            what = Refused("problem-body-repeated", body=name, count=len(same), machine=obj.Label)
            yield Problem(same[-1], what, False)
    for name in ("Fitted", "Extra", "Sources"):
        yield from _json(obj, name)
    if len(obj.HomeObjects) != len(obj.HomePlacements):
        yield Problem(obj, Refused("problem-home-incomplete"), True)
    yield from _links(obj, "Bed", obj.Bed)
    if obj.ToolPoint:
        yield from _links(obj, "ToolPoint", [obj.ToolPoint])
    else:
        yield Problem(obj, Refused("problem-no-tool-point"), False)


def _study(obj):
    for name in ("Settings", "Data"):
        yield from _json(obj, name)


def _axis(obj):
    if not all(math.isfinite(v) for v in numbers(obj.ReferenceOffset)):
        yield Problem(obj, Refused("problem-number-not-finite", name="ReferenceOffset"), False)
    if owner_machine(obj) is None:
        yield Problem(obj, Refused("problem-no-machine"), False)
    if not places(obj.Parts):
        yield Problem(obj, Refused("problem-no-carriage"), False)
    yield from _sources(obj, "DirectionSource", "ReferenceSource")


def _body(obj):
    if owner_machine(obj) is None:
        yield Problem(obj, Refused("problem-no-machine"), False)
    yield from _sources(obj, "ReferenceSource")


def _sources(obj, *names):
    yield from _links(obj, "Parts", obj.Parts)
    for name in names:
        if getattr(obj, name):
            yield from _links(obj, name, [getattr(obj, name)])


def _links(obj, name, links):
    for link in links:
        try:
            found = [place(link)] if name != "Parts" and name != "Bed" else places([link])
            for where in found:
                where.chain  # noqa: B018 - refuses a dead path
                if where.element:
                    where.shape()
        except Refused as error:
            yield Problem(obj, Refused(error.code, name, **error.fields), False)


def _table(obj):
    columns = [list(getattr(obj, name)) for name in tables.COLUMNS]
    if len({len(c) for c in columns}) > 1:
        yield Problem(obj, Refused("problem-table-uneven"), True)
    known = _symbols(owner_machine(obj))
    for symbol in obj.Symbols:
        if canonical(symbol) not in known:
            yield Problem(obj, Refused("problem-row-unknown", symbol=symbol), True)


def _result(obj):
    for names in RESULT_LISTS:
        if len({len(getattr(obj, name)) for name in names}) > 1:
            yield Problem(obj, Refused("problem-result-uneven"), True)


def _effect(obj):
    yield from _json(obj, "Parameters")
    if canonical(obj.Component) not in _symbols(owner_machine(obj)):
        yield Problem(obj, Refused("problem-component-unknown", symbol=obj.Component), False)


def _json(obj, name):
    text = getattr(obj, name)
    if text:
        try:
            json.loads(text)
        except ValueError:
            yield Problem(obj, Refused("problem-no-json", name=name), False)


def _symbols(machine) -> set[str]:
    """Names of the errors of axes X, Y, Z, and of the machine where it can be computed."""
    try:
        return set(COMPONENTS) | set(components(machine))
    except AttributeError:  # no machine, or one that lost its properties
        return set(COMPONENTS)


# -- mending ---------------------------------------------------------------------------------------------------------
def _mend(obj) -> None:
    cls = CLASSES[_kind(obj)]
    if not alive(obj):
        proxy = cls.__new__(cls)
        obj.Proxy = proxy
    obj.Proxy.onDocumentRestored(obj)
    if obj.SensType != cls.kind:
        obj.SensType = cls.kind
    dress(obj)
    if cls.kind == "Tolerances":
        _mend_table(obj)
    elif cls.kind == "Sensitivity" and any(len({len(getattr(obj, n)) for n in names}) > 1 for names in RESULT_LISTS):
        for names in RESULT_LISTS:
            for name in names:
                put(obj, name, [])
        put(obj, "Inputs", "")
        put(obj, "Stale", True)
    elif cls.kind == "Machine" and len(obj.HomeObjects) != len(obj.HomePlacements):
        obj.HomeObjects, obj.HomePlacements = [], []
        for axis in members(obj, "Axis"):
            axis.StandsAt = 0.0
            axis.Position = 0.0


def _mend_table(obj) -> None:
    rows, known = [], _symbols(owner_machine(obj))
    for row in zip(*[list(getattr(obj, name)) for name in tables.COLUMNS]):
        if canonical(row[0]) in known:
            rows.append(row)
    for k, name in enumerate(tables.COLUMNS):
        put(obj, name, [row[k] for row in rows])
    machine = owner_machine(obj)
    if machine is not None and set(AXES) <= set(bodies(machine)):  # of another machine, rows may be missing
        tables.write_tolerances(obj, tables.read_tolerances(machine))
