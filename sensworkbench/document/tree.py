# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finding our objects in a document: machines, the axes, bodies, tables, results and readings of a machine.

Finders only look; `factory` and `traces` make.  So whoever asks need not import who makes.
"""

from __future__ import annotations

from ..core.errors import AXES
from ..messages import Message, Refused
from .base import kind_of, members
from .paths import PartPath, place, places

BED, ENDS = "F", ("T", "W")
GROUP, FEATURE = "App::DocumentObjectGroupPython", "App::FeaturePython"  # the types of our objects
BODY_LABELS = {"T": "Spindle and tool", "W": "Workpiece and fixture"}


# -- the objects of a machine ----------------------------------------------------------------------------------------
def machines(doc) -> list:
    """The machines of a document, in the order in which they were made."""
    return [o for o in doc.Objects if kind_of(o) == "Machine"]


def machine_of(doc):
    """The machine of a document; refuses when there is none, or several."""
    found = machines(doc)
    if not found:
        raise Refused("document-without-machine", doc.Label)
    if len(found) > 1:
        raise Refused("document-several-machines", doc.Label, machines=[o.Label for o in found])
    return found[0]


def bodies(machine) -> dict[str, object]:
    """Name of a joint, "T" or "W" -> its axis or body object, for those that there are."""
    found = {}
    for obj in machine.Group:
        kind = kind_of(obj)
        if kind in ("Axis", "Body"):
            found.setdefault(getattr(obj, kind), obj)
    return found


def joint_names(owners) -> tuple[str, ...]:
    """The names of the axis objects among `bodies`, in the order of the columns of q: X, Y, Z, then alphabetical."""
    return tuple(sorted((n for n, obj in owners.items() if kind_of(obj) == "Axis"), key=lambda n: (n not in AXES, n)))


def axis_of(machine, name: str):
    """The axis object of a joint, or None."""
    return next((o for o in members(machine, "Axis") if o.Axis == name), None)


def body_of(machine, name: str):
    """The object of a joint, of "T" or of "W", or None."""
    return axis_of(machine, name) or next((o for o in members(machine, "Body") if o.Body == name), None)


def tolerances_of(machine):
    """The tolerance table, or None."""
    return next(iter(members(machine, "Tolerances")), None)


def sensitivity_of(machine):
    """The newest result object, or None."""
    return next(iter(reversed(members(machine, "Sensitivity"))), None)


def effects_of(machine) -> list:
    """The effect objects of a machine, body by body."""
    owners = members(machine, "Axis") + members(machine, "Body")
    return [e for o in owners for e in members(o, "Effect")] + members(machine, "Effect")


def readings_of(machine) -> list:
    """The imported tables of readings."""
    return members(machine, "Readings")


def traces_of(machine) -> list:
    """The traces of all readings."""
    return members(machine, "Trace")


def trace_of(readings_obj):
    """The trace of a Readings object, or None."""
    return next((o for o in readings_obj.InList if kind_of(o) == "Trace" and o.Readings == readings_obj), None)


def added_effects(trace_obj) -> list:
    """The effect objects that were made from a trace and still exist."""
    found = [trace_obj.Document.getObject(name) for name in trace_obj.Added]
    return [o for o in found if o is not None and kind_of(o) == "Effect"]


def owner_machine(obj):
    """The machine that an axis, body, table, result or effect belongs to, or None."""
    for parent in obj.InList:
        if kind_of(parent) == "Machine":
            return parent
        if kind_of(parent) in ("Axis", "Body"):
            return owner_machine(parent)
    return None


def body_label(machine, body: str, owners=None) -> str | Message:
    """How messages call a body: the label of its object.  owners : what `bodies` returned, where the caller has it."""
    if body == BED:
        return Message("body-bed", machine=machine.Label)
    owner = (bodies(machine) if owners is None else owners).get(body)
    return owner.Label if owner else Message("body-without-object", body=body)


# -- the parts of a machine ------------------------------------------------------------------------------------------
def parts_of(machine, body: str) -> list[PartPath]:
    """The parts of a body: "F" (bed), the name of a joint, "T" or "W"."""
    if body == BED:
        return places(machine.Bed)
    owner = body_of(machine, body)
    return places(owner.Parts) if owner else []


def all_parts(machine, owners=None) -> dict[str, list[PartPath]]:
    """`parts_of` of every body: bed, joints, T, W.  owners : what `bodies` returned, where the caller has it."""
    owners = bodies(machine) if owners is None else owners
    links = {BED: machine.Bed} | {body: obj.Parts for body, obj in owners.items()}
    return {body: places(links.get(body, ())) for body in (BED, *joint_names(owners), *ENDS)}


def part_index(machine, parts=None, owners=None) -> dict[tuple, str]:
    """Occurrence of a part -> its body; refuses a part that is named in two bodies.

    parts, owners : what `all_parts` and `bodies` returned, where the caller has it.
    """
    index = {}
    for body, group in (all_parts(machine, owners) if parts is None else parts).items():
        for where in group:
            other = index.setdefault(where.key, body)
            if other != body:
                labels = [body_label(machine, b, owners) for b in (other, body)]
                raise Refused("part-in-two-bodies", machine.Label, part=where.label, one=labels[0], other=labels[1])
    return index


def lookup(index, key):
    """The value of the longest prefix of `key` in `index`, or None: what an occurrence belongs to.

    index : mapping from occurrence (`PartPath.key`) to a value.  A part belongs to whatever holds it most closely.
    """
    return next((index[key[:n]] for n in range(len(key), 0, -1) if key[:n] in index), None)


def owner_of(machine, obj, sub: str = "") -> str | None:
    """The body that a picked object (with the path of the selection) belongs to, or None."""
    return lookup(part_index(machine), place((obj, sub)).key)
