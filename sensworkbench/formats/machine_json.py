# SPDX-License-Identifier: LGPL-2.1-or-later
"""machine.json: a machine with its chains, axes, tolerances, declared and fitted errors and traced effects.

Reading is strict: what is not understood is refused with file, line and path, never skipped, except keys that begin
with "x-", which are kept.  Lengths are mm; tolerances carry their own unit.  A machine that is written and read again
is equal to the first.
"""

from __future__ import annotations

import json
from dataclasses import replace

from sensworkbench.core.distributions import DISTRIBUTIONS, Tolerance
from sensworkbench.core.errors import AXES, component
from sensworkbench.core.joints import KINDS, Joint, linear
from sensworkbench.core.machine import SQUARENESS_CONVENTIONS, Machine
from sensworkbench.core.units import exactly_shown, factor

from . import effects_json, fitted_json, sources_json
from .files import read_text, write_text
from .fitted_json import MAX_DEGREE, symbols, unit_scale
from .json_text import Node, parse, short
from .sources_json import refused_at

FORMAT, VERSIONS = "sens-machine", (1, 2)

_KEYS = (
    "format", "version", "name", "workpiece_chain", "tool_chain", "tool_point", "spindle_reference",
    "workpiece_reference", "squareness", "tolerances", "declared", "fitted", "effects", "sources",
)  # fmt: skip
_REQUIRED = ("format", "version", "workpiece_chain", "tool_chain", "tool_point")


def load(path) -> Machine:
    """Read a machine.  Refuses with the file, line and path of what is wrong."""
    return loads(read_text(path), str(path))


def loads(text: str, name: str = "machine.json") -> Machine:
    """The machine in `text`; `name` stands in refusals."""
    return from_place(parse(text, name))


def from_place(top: Node) -> Machine:
    """The machine in a parsed file."""
    if not isinstance(top.value, dict) or top.value.get("format") != FORMAT:
        raise top.refuse("json-not-a-machine", format=FORMAT)
    version = top.value.get("version")
    if "version" in top and (isinstance(version, bool) or version not in VERSIONS):
        raise top["version"].refuse("json-version", version=short(version), known=list(VERSIONS))
    joints, more = ("axes", ()) if version == 1 else ("joints", ("frame",))
    top.keys((*_KEYS, joints, *more), (*_REQUIRED, joints))
    given = {key: tuple(top[key].numbers(3)) for key in ("spindle_reference", "workpiece_reference") if key in top}
    with refused_at(top):
        bare = Machine(
            name=top["name"].string() if "name" in top else "machine",
            workpiece_chain=_chain(top["workpiece_chain"], version),
            tool_chain=_chain(top["tool_chain"], version),
            joints=_axes(top["axes"]) if version == 1 else _joints(top["joints"]),
            tool_point=tuple(top["tool_point"].numbers(3)),
            squareness=top["squareness"].string(SQUARENESS_CONVENTIONS) if "squareness" in top else "direction",
            extra={k: v for k, v in top.value.items() if k.startswith("x-")},
            frame_axes=_frame(top["frame"]) if "frame" in top else None,
            version=version,
            **given,
        )
    return replace(
        bare,
        tolerances=tolerances(top["tolerances"], bare.component) if "tolerances" in top else {},
        declared=_declared(top["declared"], bare) if "declared" in top else {},
        fitted=fitted_json.read(top["fitted"], bare.component) if "fitted" in top else None,
        effects=effects_json.read(top["effects"], bare) if "effects" in top else (),
        sources=sources_json.read(top["sources"], bare) if "sources" in top else (),
    )


def _chain(place: Node, version: int) -> tuple[str, ...]:
    return tuple(e.string(AXES if version == 1 else None) for e in place.elements())


def _axes(place: Node) -> tuple[Joint, ...]:
    """The joints of version 1: X, Y and Z, linear."""
    place.keys(AXES, AXES)
    found = []
    for name in AXES:
        entry = place[name]
        entry.keys(("direction", "reference", "travel"), ("direction", "reference", "travel"))
        with refused_at(entry):
            found.append(
                linear(
                    name,
                    tuple(entry["direction"].numbers(3)),
                    tuple(entry["reference"].numbers(3)),
                    tuple(entry["travel"].numbers(2)),
                )
            )
    return tuple(found)


def _joints(place: Node) -> tuple[Joint, ...]:
    """The joints of version 2, in the order of the file."""
    found = []
    for entry in place.elements():
        keys = ("name", "kind", "direction", "point", "travel", "unit")
        entry.keys(keys, ("name", "kind", "direction", "point", "travel"))
        name, kind = entry["name"].string(), KINDS[entry["kind"].string(tuple(KINDS))]
        unit = entry["unit"].string() if "unit" in entry else kind.unit
        scale = factor(unit, angular=kind.angular, where=entry["unit"].where if "unit" in entry else entry.where)
        travel = None
        if entry.value["travel"] is not None:
            travel = tuple(v * scale for v in entry["travel"].numbers(2))
        elif not kind.may_be_endless:
            raise entry["travel"].refuse("travel-linear-endless")
        with refused_at(entry):
            found.append(
                Joint(name, kind, tuple(entry["direction"].numbers(3)), tuple(entry["point"].numbers(3)), travel)
            )
    return tuple(found)


def _frame(place: Node) -> tuple[str, str]:
    place.keys(("primary", "secondary"), ("primary", "secondary"))
    return place["primary"].string(), place["secondary"].string()


def tolerances(place: Node, known=component) -> dict[str, Tolerance]:
    """symbol -> Tolerance of an object of {"lower", "upper", "unit", "distribution", "sigma"}.

    known : look-up of a symbol with its place among a machine's components.
    """
    found = {}
    for c, entry in symbols(place, known):
        entry.keys(("lower", "upper", "unit", "distribution", "sigma"), ("lower", "upper"))
        scale = unit_scale(entry, c)
        lower, upper = entry["lower"].number(), entry["upper"].number()
        if upper < lower:
            raise entry["upper"].refuse("tolerance-limits-reversed", lower=lower, upper=upper)
        with refused_at(entry):
            found[c.symbol] = Tolerance(
                lower * scale,
                upper * scale,
                entry["distribution"].string(DISTRIBUTIONS) if "distribution" in entry else "uniform",
                entry["sigma"].number() * scale if "sigma" in entry else None,
            )
    return found


def _declared(place: Node, machine: Machine) -> dict[str, int]:
    found = {}
    for c, entry in symbols(place, machine.component):
        entry.keys(("shape", "degree"), ("shape",))
        if entry["shape"].string(("polynomial", "none")) == "none":
            found[c.symbol] = 0
            continue
        if c.symbol not in machine.declared_symbols:
            raise entry.refuse("component-not-declared", symbol=c.symbol)
        degree = entry["degree"].integer(0, MAX_DEGREE) if "degree" in entry else 3
        found[c.symbol] = min(degree, 1) if c.line else degree
    return found


# -- writing ---------------------------------------------------------------------------------------------------------
def to_dict(machine: Machine) -> dict:
    """The machine as plain data, as it stands in the file."""
    version = written_version(machine)
    data: dict = {
        "format": FORMAT,
        "version": version,
        "name": machine.name,
        "workpiece_chain": list(machine.workpiece_chain),
        "tool_chain": list(machine.tool_chain),
    }
    if version == 1:
        data["axes"] = {
            j.name: {"direction": list(j.direction), "reference": list(j.point), "travel": list(j.travel)}
            for j in machine.joints
        }
    else:
        data["joints"] = [_joint_dict(j) for j in machine.joints]
        if machine.frame_axes is not None:
            data["frame"] = dict(zip(("primary", "secondary"), machine.frame_axes))
    data["tool_point"] = list(machine.tool_point)
    for key in ("spindle_reference", "workpiece_reference"):
        if getattr(machine, key) is not None:
            data[key] = list(getattr(machine, key))
    data["squareness"] = machine.squareness
    if machine.tolerances:
        data["tolerances"] = {s: tolerance_dict(s, t, known=machine.component) for s, t in machine.tolerances.items()}
    if machine.declared:
        data["declared"] = {
            s: {"shape": "polynomial", "degree": d} if d else {"shape": "none"} for s, d in machine.declared.items()
        }
    if machine.sources:
        data["sources"] = [sources_json.to_dict(s, machine) for s in machine.sources]
    if machine.fitted is not None:
        data["fitted"] = fitted_json.to_dict(machine.fitted, machine.component)
    if machine.effects:
        data["effects"] = effects_json.to_list(machine, version)
    return data | dict(machine.extra)


def written_version(machine: Machine) -> int:
    """The version of the file that the machine is written as: that it was read from, or 2 where 1 cannot hold it."""
    plain = machine.names == AXES and all(j.slides for j in machine.joints) and machine.frame_axes is None
    return machine.version if plain else VERSIONS[-1]


def _joint_dict(joint: Joint) -> dict:
    data = {"name": joint.name, "kind": joint.kind.name, "direction": list(joint.direction), "point": list(joint.point)}
    if joint.travel is None:
        return data | {"travel": None, "unit": joint.unit}
    shown = [exactly_shown(v, joint.from_shown(1.0)) for v in joint.travel]
    if None in shown:  # only radians read back equal
        return data | {"travel": list(joint.travel), "unit": "rad"}
    return data | {"travel": shown, "unit": joint.unit}


def dumps(machine: Machine) -> str:
    """The text of machine.json; `loads` of it is equal to `machine`."""
    return json.dumps(to_dict(machine), indent=1, ensure_ascii=False, allow_nan=False) + "\n"


def save(machine: Machine, path) -> None:
    """Write machine.json in one step."""
    write_text(path, dumps(machine))


def tolerance_dict(symbol: str, tolerance: Tolerance, unit: str | None = None, known=component) -> dict:
    """A tolerance as it stands in the file, in um or urad (or `unit`); mm or rad where only that reads back equal.

    known : look-up of a symbol among a machine's components.
    """
    c = known(symbol)
    angular, unit = c.angular, unit or c.unit
    values = {"lower": tolerance.lower, "upper": tolerance.upper}
    if tolerance.sigma is not None:
        values["sigma"] = tolerance.sigma
    shown = {k: exactly_shown(v, factor(unit, angular=angular)) for k, v in values.items()}
    if any(v is None for v in shown.values()):
        unit, shown = ("rad" if angular else "mm"), values
    return shown | {"unit": unit, "distribution": tolerance.distribution}
