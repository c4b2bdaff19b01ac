# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD CAM machine files (*.fcm, version 1): the three linear axes, their chains, directions, joints and limits.

The schema is that of FreeCAD's src/Mod/CAM/Machine/models/machine.py.  Such a file holds neither tool point nor errors.
Its lengths are millimetres whatever its `units` say: CAM's editor converts what it shows, not what it stores.  `joint`
is written as {"origin", "axis"}: FreeCAD takes the list form, which it writes itself, for a direction as soon as the
origin is not zero.
"""

from __future__ import annotations

import json
import math
from collections.abc import Mapping

from sensworkbench.closedloop.readings import Remark
from sensworkbench.core import joints
from sensworkbench.core.errors import AXES
from sensworkbench.core.machine import Machine
from sensworkbench.messages import Message, Refused
from sensworkbench.studies.error_tables import remark

from ...json_text import Node, parse, short
from ..base import MachineFile

UNITS = ("metric", "imperial")
IDENTITY = ([0, 0, 0], [0, 0, 0, 1])
ROLES = {"table_linear": "workpiece", "head_linear": "tool"}


class Fcm(MachineFile):
    """Axes, chains and limits; no errors."""

    name, title = "fcm", "FreeCAD CAM machine"
    file = "machine.fcm"
    reads_machine = True

    def machine_text(self, machine, base: str | None = None):
        return dumps(machine, base)

    def lost(self, machine):
        return lost(machine)

    def read_machine(self, text, source, tool_point):
        return loads(text, source, tool_point)


FORMAT = Fcm()


def loads(text: str, source: str = "machine.fcm", tool_point=(0.0, 0.0, 0.0)) -> tuple[Machine, tuple[Remark, ...]]:
    """The machine in `text`, and what the file leaves open."""
    top = parse(text, source)
    if not isinstance(top.value, dict):
        raise top.refuse("fcm-no-machine")
    if top.value.get("version", 1) != 1:
        raise top["version"].refuse("fcm-version", version=short(top.value["version"]))
    place = top["machine"] if "machine" in top else top
    if not isinstance(place.value, dict) or not isinstance(place.value.get("axes"), dict):
        raise place.refuse("fcm-no-axes")
    units = place.value.get("units", "metric")
    if units not in UNITS:
        raise place["units"].refuse("fcm-units", units=short(units))
    remarks = []
    if units == "imperial":
        remarks.append(remark("fcm-imperial", 0, "warning"))
    _base_frame(place, remarks)
    linear: dict[str, Mapping] = {}
    parents: dict[str, str | None] = {}
    for name, entry in place["axes"].members():
        if not isinstance(entry.value, dict):
            raise entry.refuse("fcm-axis-no-object")
        if name.upper() in parents:
            raise entry.refuse("fcm-axis-twice", name=short(name))
        parents[name.upper()] = _parent(entry)
        if entry.value.get("type", "linear") != "linear":
            remarks.append(remark("fcm-axis-rotary", 0, "warning", name=name))
        elif name.upper() in AXES:
            linear[name.upper()] = _axis(name, entry)
        else:
            remarks.append(remark("fcm-axis-other", 0, "warning", name=name))
    for name in AXES:
        if name not in linear:
            raise place["axes"].refuse("fcm-axis-missing", name=name)
    chains = {side: _chain(linear, parents, side, remarks) for side in ("workpiece", "tool")}
    if tuple(tool_point) == (0.0, 0.0, 0.0):
        remarks.append(remark("fcm-tool-point", 0, "warning"))
    if all(a["origin"] == (0.0, 0.0, 0.0) for a in linear.values()):
        remarks.append(remark("fcm-reference-points", 0, "warning"))
    machine = Machine(
        name=str(place.value.get("name", "machine")),
        workpiece_chain=chains["workpiece"],
        tool_chain=chains["tool"],
        joints={k: joints.linear(k, a["direction"], a["origin"], a["travel"]) for k, a in linear.items()},
        tool_point=tuple(float(v) for v in tool_point),
    )
    return machine, tuple(remarks)


def _base_frame(place: Node, remarks) -> None:
    frame = place.value.get("kinematics") or {}
    frame = frame.get("base_frame") or {} if isinstance(frame, dict) else {}
    if isinstance(frame, dict) and any(
        frame.get(key, same) != same for key, same in zip(("origin", "orientation_quaternion"), IDENTITY)
    ):
        remarks.append(remark("fcm-base-frame", 0, "warning"))


def _parent(entry: Node) -> str | None:
    parent = entry.value.get("parent")
    return parent.upper() if isinstance(parent, str) else None


def _axis(name: str, entry: Node) -> dict:
    role = entry.value.get("role", "table_linear")
    if not isinstance(role, str) or role not in ROLES:
        raise entry["role"].refuse("fcm-role", role=short(role), known=list(ROLES))
    origin, direction = _joint(entry)
    limits = entry["limits"] if "limits" in entry else None
    if limits is not None and not isinstance(limits.value, dict):
        raise limits.refuse("fcm-no-limits", value=short(limits.value))
    low = limits["min"].number() if limits is not None and "min" in limits else 0.0
    high = limits["max"].number() if limits is not None and "max" in limits else 1000.0
    if not low < high:
        raise entry.refuse("fcm-limits", low=low, high=high)
    return {
        "side": ROLES[role],
        "origin": origin,
        "direction": direction,
        "travel": (low, high),
        "sequence": entry["sequence"].number() if "sequence" in entry else 0,
    }


def _joint(entry: Node):
    """(origin, unit direction); both spellings of `joint`, and either order of the list."""
    if "joint" not in entry:
        raise entry.refuse("fcm-no-joint")
    joint = entry["joint"]
    if isinstance(joint.value, dict):
        joint.keys(("origin", "axis"), ("origin", "axis"))
        origin, axis = joint["origin"].numbers(3), joint["axis"].numbers(3)
    else:
        first, second = (e.numbers(3) for e in joint.elements(2))
        # the newer order is origin, axis; the older one the other way round: only the axis has length 1
        older = math.hypot(*second) < 1e-6 or (abs(math.hypot(*first) - 1) < 1e-6 < abs(math.hypot(*second) - 1))
        origin, axis = (second, first) if older else (first, second)
    length = math.hypot(*axis)
    if length < 1e-6:
        raise joint.refuse("fcm-no-direction")
    return tuple(origin), tuple(v / length for v in axis)


def _chain(linear, parents, side: str, remarks) -> tuple[str, ...]:
    """Axes of one side from the bed outwards: a parent carries its children; then by sequence, then as listed."""
    names = [k for k, a in linear.items() if a["side"] == side]

    def depth(name):
        seen, level = set(), 0
        while name in parents and name not in seen:
            seen.add(name)
            name, level = parents[name], level + 1
        return level

    keys = {k: (depth(k), linear[k]["sequence"]) for k in names}
    if len(set(keys.values())) < len(names):
        remarks.append(remark("fcm-chain-order", 0, "warning", names=names))
    return tuple(sorted(names, key=lambda k: keys[k]))


def dumps(machine: Machine, base: str | None = None, source: str = "machine.fcm") -> str:
    """The machine as *.fcm; with `base`, the text of an existing file, only its linear axes and name are replaced."""
    data = parse(base, source).value if base is not None else _fresh()
    if not isinstance(data, dict) or not isinstance(data.get("machine", {}), dict):
        raise Refused("fcm-no-machine", source)
    place = data.setdefault("machine", {})
    axes = place.setdefault("axes", {})
    for chain, side in ((machine.workpiece_chain, "table"), (machine.tool_chain, "head")):
        for i, k in enumerate(chain):
            joint = machine.joint(k)
            low, high = (joint.to_shown(v) for v in joint.span)
            axes[k] = {
                "max_velocity": 10000,
                **(axes.get(k) or {}),
                "type": joint.kind.name,
                "role": f"{side}_{joint.kind.name}",
                "parent": chain[i - 1] if i else None,
                "sequence": i,
                "joint": {"origin": list(joint.point), "axis": list(joint.direction)},
                "limits": {"min": low, "max": high},
            }
    place["name"] = machine.name
    return json.dumps(data, indent=4, ensure_ascii=False, allow_nan=False) + "\n"


def _fresh() -> dict:
    toolhead = {
        "name": "Spindle",
        "toolhead_type": "rotary",
        "max_power_kw": 0,
        "max_rpm": 0,
        "min_rpm": 0,
        "tool_change": "manual",
    }
    machine = {"name": "", "manufacturer": "", "description": "", "units": "metric", "axes": {}}
    return {"machine": machine | {"toolheads": [toolhead]}, "version": 1}


def lost(machine: Machine) -> tuple[Message, ...]:
    """What of the machine a *.fcm cannot hold."""
    out = [Message("held-not-points")]
    if machine.tolerances:
        out.append(Message("held-not-tolerances"))
    if machine.fitted is not None:
        out.append(Message("held-not-fitted"))
    if machine.effects:
        out.append(Message("held-not-effects"))
    return tuple(out)
