# SPDX-License-Identifier: LGPL-2.1-or-later
"""machine.json: a machine with its chains, axes, tolerances, declared and fitted errors and traced effects.

Reading is strict: what is not understood is refused with file, line and path, never skipped, except keys that begin
with "x-", which are kept.  Lengths are mm; tolerances carry their own unit.  A machine that is written and read again
is equal to the first.
"""

from __future__ import annotations

import contextlib
import json
import math

from sensworkbench.core.distributions import DISTRIBUTIONS, Tolerance
from sensworkbench.core.drivers import SHAPES, Effect
from sensworkbench.core.errors import AXES, DECLARED_SYMBOLS, SQUARENESS, component
from sensworkbench.core.joints import Joint, linear
from sensworkbench.core.machine import SQUARENESS_CONVENTIONS, Machine
from sensworkbench.core.refusal import Refused
from sensworkbench.core.units import factor

from . import fitted_json
from .files import read_text, write_text
from .fitted_json import MAX_DEGREE, symbols, unit_scale
from .json_text import Place, parse, short

FORMAT, VERSION = "sens-machine", 1

_KEYS = (
    "format", "version", "name", "workpiece_chain", "tool_chain", "axes", "tool_point", "spindle_reference",
    "workpiece_reference", "squareness", "tolerances", "declared", "fitted", "effects",
)  # fmt: skip
_REQUIRED = ("format", "version", "workpiece_chain", "tool_chain", "axes", "tool_point")


def load(path) -> Machine:
    """Read a machine.  Refuses with the file, line and path of what is wrong."""
    return loads(read_text(path), str(path))


def loads(text: str, name: str = "machine.json") -> Machine:
    """The machine in `text`; `name` stands in refusals."""
    return from_place(parse(text, name))


def from_place(top: Place) -> Machine:
    """The machine in a parsed file."""
    if not isinstance(top.value, dict) or top.value.get("format") != FORMAT:
        raise top.refuse("this is not a machine", f'A machine file is an object with "format": "{FORMAT}".')
    if "version" in top and top.value["version"] != VERSION:
        raise top["version"].refuse(f"version {short(top.value['version'])} is not known", f"Known is {VERSION}.")
    top.keys(_KEYS, _REQUIRED)
    axes = _axes(top["axes"])
    given = {key: tuple(top[key].numbers(3)) for key in ("spindle_reference", "workpiece_reference") if key in top}
    with _refused_at(top):
        return Machine(
            name=top["name"].string() if "name" in top else "machine",
            workpiece_chain=_chain(top["workpiece_chain"]),
            tool_chain=_chain(top["tool_chain"]),
            joints=axes,
            tool_point=tuple(top["tool_point"].numbers(3)),
            squareness=top["squareness"].string(SQUARENESS_CONVENTIONS) if "squareness" in top else "direction",
            tolerances=tolerances(top["tolerances"]) if "tolerances" in top else {},
            declared=_declared(top["declared"]) if "declared" in top else {},
            fitted=fitted_json.read(top["fitted"]) if "fitted" in top else None,
            effects=_effects(top["effects"]) if "effects" in top else (),
            extra={k: v for k, v in top.value.items() if k.startswith("x-")},
            **given,
        )


@contextlib.contextmanager
def _refused_at(place: Place):
    """What the core refuses gets its place in the file, unless it names one already."""
    try:
        yield
    except Refused as refused:
        if refused.where.startswith(place.name):
            raise
        member = refused.where.rpartition(", ")[2]
        if isinstance(place.value, dict) and member in place.value:
            raise place[member].refuse(refused.what, refused.do) from None
        raise refused.at(place.where) from None


def _chain(place: Place) -> tuple[str, ...]:
    return tuple(e.string(AXES) for e in place.elements())


def _axes(place: Place) -> dict[str, Joint]:
    place.keys(AXES, AXES)
    found = {}
    for name in AXES:
        entry = place[name]
        entry.keys(("direction", "reference", "travel"), ("direction", "reference", "travel"))
        with _refused_at(entry):
            found[name] = linear(
                name,
                tuple(entry["direction"].numbers(3)),
                tuple(entry["reference"].numbers(3)),
                tuple(entry["travel"].numbers(2)),
            )
    return found


def tolerances(place: Place) -> dict[str, Tolerance]:
    """symbol -> Tolerance of an object of {"lower", "upper", "unit", "distribution", "sigma"}."""
    found = {}
    for symbol, entry in symbols(place):
        entry.keys(("lower", "upper", "unit", "distribution", "sigma"), ("lower", "upper"))
        scale = unit_scale(entry, symbol)
        lower, upper = entry["lower"].number(), entry["upper"].number()
        if upper < lower:
            raise entry["upper"].refuse(
                f"upper limit {upper:g} is below lower limit {lower:g}", "Exchange the two limits."
            )
        with _refused_at(entry):
            found[symbol] = Tolerance(
                lower * scale,
                upper * scale,
                entry["distribution"].string(DISTRIBUTIONS) if "distribution" in entry else "uniform",
                entry["sigma"].number() * scale if "sigma" in entry else None,
            )
    return found


def _declared(place: Place) -> dict[str, int]:
    found = {}
    for symbol, entry in symbols(place):
        entry.keys(("shape", "degree"), ("shape",))
        if entry["shape"].string(("polynomial", "none")) == "none":
            found[symbol] = 0
            continue
        if symbol not in DECLARED_SYMBOLS:
            raise entry.refuse(
                f"{symbol} has no declared function", "Only the errors of the three axes are declared functions."
            )
        degree = entry["degree"].integer(0, MAX_DEGREE) if "degree" in entry else 3
        found[symbol] = min(degree, 1) if component(symbol).kind == SQUARENESS else degree
    return found


def _uncertainties(place: Place, count: int) -> None:
    for e in place.elements(count):
        if e.value is not None and e.number() < 0:
            raise e.refuse("a standard uncertainty is not negative")


def _value(place: Place) -> None:
    """A number, or {"value", "unit", "u"} where value is a number or a list of numbers and u may be null."""
    if not isinstance(place.value, dict):
        place.number()
        return
    place.keys(("value", "unit", "u"), ("value",))
    value = place["value"]
    count = len(value.numbers()) if isinstance(value.value, list) else None
    if count is None:
        value.number()
    if "unit" in place:
        place["unit"].string()
    if "u" in place and place.value["u"] is not None:
        if count is None:
            if place["u"].number() < 0:
                raise place["u"].refuse("a standard uncertainty is not negative")
        else:
            _uncertainties(place["u"], count)


def _effects(place: Place) -> tuple[Effect, ...]:
    found: list[Effect] = []
    for entry in place.elements():
        keys = ("name", "component", "driver", "shape", "parameters", "enabled")
        entry.keys(keys, ("name", "component", "driver", "shape", "parameters"))
        name = entry["name"].string()
        if not name or any(e.name == name for e in found):
            raise entry["name"].refuse(f"{short(name)} is empty or names another effect too", "Give each its own name.")
        driver = entry["driver"].string()
        if not all(part.strip() == part and part for part in driver.split("*")):
            raise entry["driver"].refuse(f"{short(driver)} is not column names joined by *")
        parameters = entry["parameters"]
        for _, parameter in parameters.members():
            if isinstance(parameter.value, list):
                parameter.numbers()
            else:
                _value(parameter)
        found.append(
            Effect(
                name=name,
                component=component(entry["component"].string(), entry["component"].where).symbol,
                driver=driver,
                shape=entry["shape"].string(tuple(SHAPES)),
                parameters=parameters.value,
                enabled=entry["enabled"].boolean() if "enabled" in entry else True,
            )
        )
    return tuple(found)


# -- writing ---------------------------------------------------------------------------------------------------------
def to_dict(machine: Machine) -> dict:
    """The machine as plain data, as it stands in the file."""
    data: dict = {
        "format": FORMAT,
        "version": VERSION,
        "name": machine.name,
        "workpiece_chain": list(machine.workpiece_chain),
        "tool_chain": list(machine.tool_chain),
        "axes": {
            k: {
                "direction": list(machine.axes[k].direction),
                "reference": list(machine.axes[k].reference),
                "travel": list(machine.axes[k].travel),
            }
            for k in AXES
        },
        "tool_point": list(machine.tool_point),
    }
    for key in ("spindle_reference", "workpiece_reference"):
        if getattr(machine, key) is not None:
            data[key] = list(getattr(machine, key))
    data["squareness"] = machine.squareness
    if machine.tolerances:
        data["tolerances"] = {s: tolerance_dict(s, t) for s, t in machine.tolerances.items()}
    if machine.declared:
        data["declared"] = {
            s: {"shape": "polynomial", "degree": d} if d else {"shape": "none"} for s, d in machine.declared.items()
        }
    if machine.fitted is not None:
        data["fitted"] = fitted_json.to_dict(machine.fitted)
    if machine.effects:
        data["effects"] = [
            {
                "name": e.name,
                "component": e.component,
                "driver": e.driver,
                "shape": e.shape,
                "parameters": dict(e.parameters),
                "enabled": e.enabled,
            }
            for e in machine.effects
        ]
    return data | dict(machine.extra)


def dumps(machine: Machine) -> str:
    """The text of machine.json; `loads` of it is equal to `machine`."""
    return json.dumps(to_dict(machine), indent=1, ensure_ascii=False, allow_nan=False) + "\n"


def save(machine: Machine, path) -> None:
    """Write machine.json in one step."""
    write_text(path, dumps(machine))


def tolerance_dict(symbol: str, tolerance: Tolerance, unit: str | None = None) -> dict:
    """A tolerance as it stands in the file, in um or urad (or `unit`); mm or rad where only that reads back equal."""
    angular = component(symbol).angular
    unit = unit or component(symbol).unit
    values = {"lower": tolerance.lower, "upper": tolerance.upper}
    if tolerance.sigma is not None:
        values["sigma"] = tolerance.sigma
    shown = {k: exactly_shown(v, factor(unit, angular=angular)) for k, v in values.items()}
    if any(v is None for v in shown.values()):
        unit, shown = ("rad" if angular else "mm"), values
    return shown | {"unit": unit, "distribution": tolerance.distribution}


def exactly_shown(value: float, scale: float) -> float | None:
    """The number that times `scale` is `value` again to the last bit, the shortest found; None where there is none."""
    guess = value / scale
    for candidate in (
        round(guess, 6),
        round(guess, 9),
        guess,
        math.nextafter(guess, math.inf),
        math.nextafter(guess, -math.inf),
    ):
        if candidate * scale == value:
            return candidate
    return None
