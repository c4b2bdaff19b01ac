# SPDX-License-Identifier: LGPL-2.1-or-later
"""The "fitted" part of machine.json: read into a `core.fitted.FittedModel` in mm and rad, and written in um and urad.

What a fit stores beside the errors (`x-tools`, `x-ranges`, `x-uncertainty`) is checked like everything else; other "x-"
keys are kept.  A model that was read from a file is equal to itself after it was written and read again.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Mapping

from sensworkbench.core.errors import Component, component
from sensworkbench.core.fitted import Constant, FittedModel, Series, ToolError
from sensworkbench.core.units import factor

from . import uncertainty_json
from .json_text import Node, parse, short

Known = Callable[..., Component]
MAX_DEGREE = 30
SHIFTS = ("EXW", "EYW", "EZW")
_OFFSET, _ERROR = "offset_mm", "error_um"


def symbols(place: Node, known: Known = component):
    """(Component, place) of every member; aliases are understood, the same error under two names is refused.

    known : the look-up of a symbol with its place, of a machine's components.
    """
    seen = {}
    for key, entry in place.members():
        if key.startswith("x-"):
            raise entry.refuse("json-extra-here", key=short(key))
        c = known(key, entry.where)
        if c.symbol in seen:
            raise entry.refuse("component-twice", key=short(key), other=short(seen[c.symbol]))
        seen[c.symbol] = key
        yield c, entry


def unit_scale(entry: Node, c: Component) -> float:
    """Factor to mm or rad of the entry's unit; um or urad where it states none."""
    if "unit" not in entry:
        return factor(c.unit, angular=c.angular)
    return factor(entry["unit"].string(), angular=c.angular, where=entry["unit"].where)


# -- reading ---------------------------------------------------------------------------------------------------------
def read(place: Node, known: Known = component) -> FittedModel:
    """The model of a parsed "fitted" object.  Refuses with the place of what is wrong.  known : see `symbols`."""
    series: dict[str, Series] = {}
    constants: dict[str, Constant] = {}
    more: dict = {}
    extra: dict = {}
    for key, entry in place.members():
        if key == "alignment":
            more[key] = {c.symbol: _constant(value, c) for c, value in symbols(entry, known)}
        elif key == "runs":
            more[key] = {label: _run(value, known) for label, value in entry.members()}
        elif key == "covariance":
            more[key] = _file_name(entry)
        elif key == "x-tools":
            more["tools"] = tuple(_tool(e) for e in entry.elements())
        elif key == "x-ranges":
            more["ranges"] = {name: _range(value) for name, value in entry.members()}
        elif key == uncertainty_json.KEY:
            more["uncertainty"] = uncertainty_json.read(entry, known)
        elif key.startswith("x-"):
            extra[key] = entry.value
        else:
            c = known(key, entry.where)
            if c.symbol in series or c.symbol in constants:
                raise entry.refuse("component-two-names", key=short(key))
            if not c.line and isinstance(entry.value, dict) and "coefficients" in entry:
                series[c.symbol] = _series(entry, c)
            else:
                constants[c.symbol] = _constant(entry, c)
    return FittedModel(series=series, constants=constants, extra=extra, **more)


def loads(text: str, name: str, known: Known = component) -> FittedModel | None:
    """The model in a text ("" or null: None); `name` stands in refusals.  known : see `symbols`."""
    if not text.strip():
        return None
    place = parse(text, name)
    return None if place.value is None else read(place, known)


def _series(entry: Node, c: Component) -> Series:
    entry.keys(("basis", "domain", "coefficients", "unit", "u"), ("basis", "domain", "coefficients", "unit"))
    entry["basis"].string(("legendre",))
    low, high = entry["domain"].numbers(2)
    if not high - low > 1e-9:
        raise entry["domain"].refuse("domain-without-length", low=low, high=high)
    scale = unit_scale(entry, c)
    coefficients = entry["coefficients"].numbers()
    if not 1 <= len(coefficients) <= MAX_DEGREE + 1:
        raise entry["coefficients"].refuse("coefficients-count", count=len(coefficients), most=MAX_DEGREE + 1)
    u = ()
    if "u" in entry and entry.value["u"] is not None:
        u = tuple(_uncertainty(e, scale) for e in entry["u"].elements(len(coefficients)))
    return Series((low, high), tuple(_scaled(v, scale, entry["coefficients"]) for v in coefficients), u)


def _constant(place: Node, c: Component) -> Constant:
    """A number in um or urad, or {"value", "unit", "u"} where u may be null."""
    if not isinstance(place.value, dict):
        return Constant(_scaled(place.number(), factor(c.unit, angular=c.angular), place))
    place.keys(("value", "unit", "u"), ("value",))
    scale = unit_scale(place, c)
    u = _uncertainty(place["u"], scale) if "u" in place else None
    return Constant(_scaled(place["value"].number(), scale, place["value"]), u)


def _scaled(value: float, scale: float, place: Node) -> float:
    if not math.isfinite(value) or abs(value * scale) > 1e9:
        raise place.refuse("error-size-implausible", value=value)
    return value * scale


def _uncertainty(place: Node, scale: float) -> float | None:
    if place.value is None:
        return None
    if place.number() < 0:
        raise place.refuse("uncertainty-negative")
    return _scaled(place.number(), scale, place)


def _run(place: Node, known: Known) -> dict[str, Constant]:
    """[ex, ey, ez] in um, or symbol -> value as under "alignment"."""
    if isinstance(place.value, dict):
        return {c.symbol: _constant(value, c) for c, value in symbols(place, known)}
    return {symbol: Constant(_scaled(e.number(), 1e-3, e)) for symbol, e in zip(SHIFTS, place.elements(3), strict=True)}


def _tool(place: Node) -> ToolError:
    place.keys((_OFFSET, _ERROR), (_OFFSET, _ERROR))
    error = tuple(_scaled(e.number(), 1e-3, e) for e in place[_ERROR].elements(3))
    return ToolError(tuple(place[_OFFSET].numbers(3)), error)


def _range(place: Node) -> tuple[float, float]:
    low, high = place.numbers(2)
    if low > high:
        raise place.refuse("range-reversed", low=low, high=high)
    return low, high


def _file_name(entry: Node) -> str:
    name = entry.string()
    if not name or any(c in name for c in "/\\:\0") or not name.endswith(".npz"):
        raise entry.refuse("covariance-file-name", name=short(name))
    return name


# -- writing ---------------------------------------------------------------------------------------------------------
def to_dict(model: FittedModel, known: Known = component) -> dict:
    """The model as it stands in the file, in um and urad.  known : see `symbols`."""
    out: dict = {}
    for symbol, s in model.series.items():
        scale, unit = _unit(known(symbol))
        out[symbol] = {
            "basis": "legendre",
            "domain": list(s.domain),
            "coefficients": [shown(v, scale) for v in s.coefficients],
            "unit": unit,
        }
        if s.u:
            out[symbol]["u"] = [None if v is None else shown(v, scale) for v in s.u]
    out |= {symbol: _constant_dict(known(symbol), value) for symbol, value in model.constants.items()}
    if model.alignment:
        out["alignment"] = {symbol: _constant_dict(known(symbol), value) for symbol, value in model.alignment.items()}
    if model.runs:
        out["runs"] = {label: _run_entry(run, known) for label, run in model.runs.items()}
    if model.tools:
        out["x-tools"] = [{_OFFSET: list(t.offset), _ERROR: [shown(v, 1e-3) for v in t.error]} for t in model.tools]
    if model.ranges:
        out["x-ranges"] = {name: list(r) for name, r in model.ranges.items()}
    if model.covariance is not None:
        out["covariance"] = model.covariance
    if model.uncertainty is not None:
        out[uncertainty_json.KEY] = uncertainty_json.to_dict(model.uncertainty, known)
    return out | dict(model.extra)


def dumps(model: FittedModel | None, known: Known = component) -> str:
    """One line of JSON ("" for None).  known : see `symbols`."""
    return "" if model is None else json.dumps(to_dict(model, known), allow_nan=False)


def _unit(c: Component) -> tuple[float, str]:
    return factor(c.unit, angular=c.angular), c.unit


def _constant_dict(c: Component, found: Constant) -> dict:
    scale, unit = _unit(c)
    return {"value": shown(found.value, scale), "unit": unit, "u": None if found.u is None else shown(found.u, scale)}


def _run_entry(run: Mapping[str, Constant], known: Known):
    if set(run) <= set(SHIFTS) and all(c.u is None for c in run.values()):
        return [shown(run[s].value, 1e-3) if s in run else 0.0 for s in SHIFTS]
    return {symbol: _constant_dict(known(symbol), value) for symbol, value in run.items()}


def shown(value: float, scale: float) -> float:
    """The number that, times `scale`, reads back as `value` exactly if there is one, else the nearest."""
    guess = value / scale
    for number in (guess, value * (1 / scale), math.nextafter(guess, math.inf), math.nextafter(guess, -math.inf)):
        if number * scale == value:
            return number
    return guess
