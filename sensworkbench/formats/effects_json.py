# SPDX-License-Identifier: LGPL-2.1-or-later
"""The "effects" part of machine.json: read into `core.effects.Effect` in mm, rad and internal units, and written.

Every parameter has a unit: another scale of the same kind is converted, another kind is refused with its place.  A
parameter without a unit counts in the unit that is written.  Version 1 states the range of the component under
`parameters.extent`, version 2 that of the driver under `extent` of the effect.
"""

from __future__ import annotations

import contextlib
import math
import re
from collections.abc import Iterator
from dataclasses import dataclass, replace

from sensworkbench.core.driver import DIRECTIONS, Driver, column_unit
from sensworkbench.core.effects import Effect, coefficient_unit, shown
from sensworkbench.core.errors import Component, component
from sensworkbench.core.machine import Machine
from sensworkbench.core.parameters import Parameter
from sensworkbench.core.refusal import Refused
from sensworkbench.core.shapes import Shape, shape_class
from sensworkbench.core.unit_text import KELVIN, ZERO, conversion, internal
from sensworkbench.core.unit_text import readings as unit_readings

from .json_text import Node, short

KEYS = ("name", "component", "driver", "shape", "parameters", "enabled")
REQUIRED = KEYS[:-1]


_UNKNOWN = re.compile(r"\(?(?P<name>[^\W\d_]+|%)\)?(\^[\d.]+)?")


# -- reading -----------------------------------------------------------------------------------------------------------
def read(place: Node, machine: Machine) -> tuple[Effect, ...]:
    """The effects of a parsed "effects" list.  machine : what they belong to (its effects do not count)."""
    found: list[Effect] = []
    units = joint_units(machine)
    for entry in place.elements():
        entry.keys(KEYS if machine.version == 1 else (*KEYS, "extent"), REQUIRED)
        name = entry["name"].string()
        if not name or any(e.name == name for e in found):
            raise Refused("effect-name-taken", entry["name"].where, name=short(name))
        c = machine.component(entry["component"].string(), entry["component"].where)
        found.append(_effect(entry, name, c, units))
        if machine.version > 1:
            found[-1] = _with_extent(found[-1], entry, machine)
    return tuple(found)


def joint_units(machine: Machine) -> dict[str, str]:
    """Position column of each joint -> its unit as a driver: mm or deg."""
    return {j.name.lower(): j.unit for j in machine.joints}


def of_parameters(
    name: str, symbol: str, driver: str, shape: str, parameters, enabled=True, where="effect", known=component
) -> Effect:
    """The effect of its parts as version 1 holds them, such as a document stores.

    where : stands in refusals.  known : look-up of a symbol with its place among a machine's components.
    """
    parts = {"driver": driver, "shape": shape, "parameters": parameters, "enabled": bool(enabled)}
    return _effect(Node(parts, (), {}, where), name, known(symbol, where), {})


def of_place(entry: Node, name: str, c: Component) -> Effect:
    """The effect of a place that holds "driver", "shape" and "parameters" as version 1 does, on a component."""
    return _effect(entry, name, c, {})


def _effect(entry: Node, name: str, c: Component, units) -> Effect:
    with _placed(entry["driver"]):
        driver, order = Driver.parse_in_order(entry["driver"].string())
    with _placed(entry["shape"]):
        cls = shape_class(entry["shape"].string())
    given = entry["parameters"]
    allowed = {"coefficient", "extent", *cls.parameters}
    parts = {}
    for key, parameter in given.members():
        if key not in allowed:
            raise Refused("parameter-unknown", parameter.where, shape=cls.name, name=key)
        parts[key] = _Numbers.of(parameter)
    shape, driver_unit, spread = _shape(given, cls, parts, driver, units)
    coefficients, u = (), None
    if "coefficient" in parts:
        numbers = parts["coefficient"]
        if len(numbers.values) != shape.size:
            raise Refused(
                "effect-coefficients-count", given["coefficient"].where, count=len(numbers.values), size=shape.size
            )
        scale, driver_unit = _coefficient_scale(numbers, c, shape, driver, driver_unit, units)
        coefficients = tuple(v * scale for v in numbers.values)
        u = None if numbers.u is None else tuple(None if v is None else v * scale for v in numbers.u)
    reach = None
    if "extent" in parts:
        numbers = parts["extent"]
        reach = numbers.pair(_scale(numbers, c.unit, "rad" if c.angular else "mm"))
    shape, coefficients, u = shape.in_order(order, coefficients, u)
    with _placed(given):
        return Effect(
            name=name,
            component=c.symbol,
            driver=driver,
            shape=shape,
            coefficients=coefficients,
            u=u,
            shape_u=spread,
            reach=reach,
            enabled=entry["enabled"].boolean() if "enabled" in entry else True,
            driver_unit=driver_unit,
        )


@contextlib.contextmanager
def _placed(place: Node) -> Iterator[None]:
    """What the core refuses gets its place in the file, unless it has one already."""
    try:
        yield
    except Refused as refused:
        raise refused if refused.where.startswith(place.name) and place.name else refused.at(place.where) from None


@dataclass(frozen=True)
class _Numbers:
    """A parameter as written: values, u (None: not stated), unit ("" : none stated), and its place."""

    values: tuple[float, ...]
    u: tuple[float | None, ...] | None
    unit: str
    place: Node

    @classmethod
    def of(cls, place: Node) -> _Numbers:
        """A number, a list of numbers, or {"value", "unit", "u"} of them."""
        if not isinstance(place.value, dict):
            return cls(_numbers(place), None, "", place)
        place.keys(("value", "unit", "u"), ("value",))
        values = _numbers(place["value"])
        u = None
        if "u" in place:
            listed = isinstance(place.value["value"], list) and place.value["u"] is not None
            u = tuple(_uncertainty(e) for e in (place["u"].elements(len(values)) if listed else [place["u"]]))
        return cls(values, u, place["unit"].string() if "unit" in place else "", place)

    @property
    def unit_where(self) -> str:
        stated = isinstance(self.place.value, dict) and "unit" in self.place
        return (self.place["unit"] if stated else self.place).where

    def pair(self, scale: float, offset: float = 0.0) -> tuple[float, float]:
        """Two values, lowest and highest."""
        if len(self.values) != 2:
            raise Refused("parameter-count", self.place.where, name="extent", count=len(self.values), size=2)
        low, high = (v * scale + offset for v in self.values)
        if low > high:
            raise Refused("effect-extent-reversed", self.place.where, low=low, high=high)
        return low, high


def _numbers(place: Node) -> tuple[float, ...]:
    values = tuple(place.numbers()) if isinstance(place.value, list) else (place.number(),)
    if not values or not all(map(math.isfinite, values)):
        raise Refused("parameter-not-finite", place.where, name=str(place.path[-1]) if place.path else "")
    return values


def _uncertainty(place: Node) -> float | None:
    if place.value is None:
        return None
    value = place.number()
    if not (value >= 0 and math.isfinite(value)):
        raise Refused("uncertainty-negative", place.where)
    return value


def _scale(numbers: _Numbers, default: str, wanted: str) -> float:
    """Factor from the stated unit (or `default`) to `wanted`."""
    return conversion(numbers.unit or default, wanted, numbers.unit_where)


def _shape(place: Node, cls, parts, driver: Driver, units) -> tuple[Shape, str | None, dict[str, float]]:
    """(the shape, the driver's unit or None where nothing tells it yet, standard uncertainties of its parameters)."""
    driver_unit = driver.unit(units) if driver.known(units) else None
    values, spread = {}, {}
    for name, parameter in cls.parameters.items():
        if name not in parts:
            continue
        numbers = parts[name]
        wanted = parameter.unit_of(driver, driver_unit)
        if wanted is None:  # nothing tells the unit of an unknown column but what is written here
            wanted = driver_unit = _internal_of(numbers)
        scale, offset = _parameter_scale(numbers, parameter, wanted, driver)
        with _placed(numbers.place):
            values[name] = parameter.of_numbers([v * scale + offset for v in numbers.values])
        if parameter.size == 1 and numbers.u is not None:
            spread[name] = None if numbers.u[0] is None else numbers.u[0] * scale
    if "degree" in cls.parameters and "degree" not in values and "coefficient" in parts:
        values["degree"] = len(parts["coefficient"].values)
    with _placed(place):
        return cls(**values), driver_unit, spread


def _parameter_scale(numbers: _Numbers, parameter: Parameter, wanted: str, driver: Driver) -> tuple[float, float]:
    """(factor, offset) from the stated unit to the internal one; degrees of a temperature count from 20 degC."""
    unit = numbers.unit
    if parameter.absolute and wanted == "K" and unit in ZERO:
        return KELVIN[unit], -ZERO[unit] * KELVIN[unit]
    return _scale(numbers, wanted, wanted), 0.0


def _internal_of(numbers: _Numbers) -> str:
    """The internal unit of what a stated unit measures; the unit itself where it is none that is known."""
    found = [text for unit in unit_readings(numbers.unit) if (text := internal(unit)) is not None]
    if not found:
        raise Refused("unit-unknown", numbers.unit_where, unit=numbers.unit[:60], wanted="mm, s, K, kg")
    return found[0]


def _coefficient_scale(numbers: _Numbers, c: Component, shape: Shape, driver: Driver, driver_unit, units):
    """(factor to mm or rad per unit of the driver, unit of the driver)."""
    base = "rad" if c.angular else "mm"
    if driver_unit is None and shape.unit_power:
        return _per_unknown(numbers, base, c, shape, driver, units)
    unit = driver_unit or ""
    default, wanted = (coefficient_unit(b, shape, unit) for b in (c.unit, base))
    return _scale(numbers, default, wanted), driver_unit


def _per_unknown(numbers: _Numbers, base: str, c: Component, shape: Shape, driver: Driver, units) -> tuple[float, str]:
    """The same where the names of some columns do not tell their unit: then what is written after "/" is it."""
    top, slash, below = (part.strip() for part in (numbers.unit or c.unit).partition("/"))
    try:
        scale = conversion(top, base)
    except Refused as refused:
        raise refused.at(numbers.unit_where) from None
    if not slash:
        return scale, ""
    known = Driver(tuple(n for n in driver.columns if column_unit(n, units) is not None) or driver.columns[:1])
    stated = known.unit(units) if all(column_unit(n, units) is not None for n in known.columns) else ""
    for unit in unit_readings(below):
        unit = unit.power(1 / shape.unit_power)
        rest = unit.times(unit_readings(stated)[0], -1)
        text = internal(rest)
        if text is not None:
            per = "*".join(t for t in (stated, text) if t)
            return scale / (unit.factor / unit_readings(per)[0].factor) ** shape.unit_power, per
    unknown = _UNKNOWN.fullmatch(below)  # a unit that this program does not know: the column is as written
    if unknown is None or unit_readings(unknown["name"]):
        wanted = coefficient_unit(c.unit, shape, stated or "?")
        raise Refused("unit-of-another-kind", numbers.unit_where, unit=numbers.unit[:60], wanted=wanted)
    return scale, unknown["name"]


def _with_extent(effect: Effect, entry: Node, machine: Machine) -> Effect:
    """Version 2: with the range of its driver, which only a joint position or a direction need not state."""
    parameters = entry["parameters"]
    if effect.reach is not None:
        raise Refused("effect-extent-place", parameters["extent"].where)
    if not effect.coefficients:
        raise Refused("effect-without-coefficient", parameters.where)
    if "extent" not in entry:
        extent = natural_extent(effect.driver, machine)
        if extent is None:
            raise Refused("effect-extent-missing", entry.where, driver=str(effect.driver))
        return replace(effect, extent=extent)
    if entry["extent"].value is None:
        return effect
    numbers = _Numbers.of(entry["extent"])
    wanted = effect.driver_unit or ""
    scale, offset = _parameter_scale(numbers, Parameter(absolute=True), wanted, effect.driver)
    return replace(effect, extent=numbers.pair(scale, offset))


def natural_extent(driver: Driver, machine: Machine) -> tuple[float, float] | None:
    """Range of a driver that is one joint position (its travel) or one direction; None for any other."""
    if driver.factors != 1:
        return None
    [name] = driver.columns
    if name in DIRECTIONS or name in {f"dir_{j.name.lower()}" for j in machine.joints}:
        return -1.0, 1.0
    joint = next((j for j in machine.joints if j.name.lower() == name), None)
    return None if joint is None else tuple(joint.to_shown(v) for v in joint.span)


# -- writing -----------------------------------------------------------------------------------------------------------
def parameters(effect: Effect, c: Component) -> dict:
    """The parameters of an effect as version 1 holds them."""
    return {name: numbers.to_dict() for name, numbers in shown(effect, c).items()}


def to_list(machine: Machine, version: int) -> list[dict]:
    """The effects of a machine as plain data; refuses where version 2 needs the range of a driver that is not known."""
    return [_to_dict(e, machine, version) for e in machine.effects]


def _to_dict(effect: Effect, machine: Machine, version: int) -> dict:
    c = machine.component(effect.component)
    if version == 1 and effect.reach is None:
        effect = replace(effect, reach=effect.range)
    data = {
        "name": effect.name,
        "component": effect.component,
        "driver": str(effect.driver),
        "shape": effect.shape.name,
        "parameters": parameters(effect if version == 1 else replace(effect, reach=None), c),
        "enabled": effect.enabled,
    }
    if version > 1:
        extent = driver_extent(effect, machine)
        if extent is None or extent != natural_extent(effect.driver, machine):
            data["extent"] = None if extent is None else {"value": list(extent)} | (
                {"unit": effect.driver_unit} if effect.driver_unit else {}
            )  # fmt: skip
    return data


def driver_extent(effect: Effect, machine: Machine) -> tuple[float, float] | None:
    """Range of an effect's driver: as stated, from that of its component, or of what the readings of a fit held."""
    if effect.extent is not None:
        return effect.extent
    if effect.reach is not None and effect.shape.proportional and effect.coefficients and effect.coefficients[0]:
        ends = [v / effect.coefficients[0] for v in effect.reach]
        return min(ends), max(ends)
    ranges = machine.fitted.ranges if machine.fitted is not None else {}
    if effect.reach is not None and all(n in ranges for n in effect.driver.columns):
        low, high = 1.0, 1.0
        for name in effect.driver.columns:
            products = [a * b for a in (low, high) for b in ranges[name]]
            low, high = min(products), max(products)
        return low, high
    natural = natural_extent(effect.driver, machine)
    if effect.reach is not None and natural is None:
        raise Refused("effect-extent-missing", f"effect {effect.name!r}", driver=str(effect.driver))
    return None if effect.reach is None else natural
