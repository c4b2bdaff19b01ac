# SPDX-License-Identifier: LGPL-2.1-or-later
"""The "x-uncertainty" of a fitted machine: covariance of all that the fit found, compact (see docs/formats.md).

{"parameters": [["declared", "EXX", 1], ["alignment", "EXW"], ["run", "2", "EXW"], ["tool", 0, 2],
["effect", NAME, "EAZ", 0], ["effect", NAME, "tau"]], "factor": [[...], ...], "others": [{"component", "driver",
"shape", "parameters", "weight", "changes"}]}.  The covariance is factor times its transpose, rows filled up with zeros,
in um and urad (of a coefficient: over the unit of its driver) and in mm, s, K ... of parameters of shapes.
"""

from __future__ import annotations

from collections.abc import Callable

from sensworkbench.core.effects import shown
from sensworkbench.core.errors import Component, component
from sensworkbench.core.fitted import (
    ALIGNMENT,
    DECLARED,
    DIGITS,
    EFFECT,
    RUN,
    TOOL,
    OtherName,
    Uncertainty,
    scale_of,
)

from . import effects_json
from .json_text import Node

KEY = "x-uncertainty"
GROUPS = (DECLARED, ALIGNMENT, RUN, TOOL, EFFECT)
MOST = 5000  # parameters
Known = Callable[..., Component]


def _short(value: float) -> float:
    return float(f"{value:.{DIGITS}g}")


# -- reading -----------------------------------------------------------------------------------------------------------
def read(place: Node, known: Known = component) -> Uncertainty:
    """The uncertainty of a parsed object; refuses with the place of what is wrong."""
    place.keys(("parameters", "factor", "others"), ("parameters", "factor"))
    keys = tuple(_key(e, known) for e in place["parameters"].elements())
    if len(keys) > MOST:
        raise place["parameters"].refuse("uncertainty-parameters-many", count=len(keys), most=MOST)
    scales = [scale_of(key, known) for key in keys]
    factor = []
    for entry, scale in zip(place["factor"].elements(len(keys)), scales):
        row = entry.numbers() if entry.value else []
        if len(row) > MOST:
            raise entry.refuse("uncertainty-parameters-many", count=len(row), most=MOST)
        factor.append(tuple(_finite(v, entry) * scale for v in row))
    others = tuple(_other(e, scales, known) for e in place["others"].elements()) if "others" in place else ()
    return Uncertainty(keys, tuple(factor), others)


def _finite(value: float, place: Node) -> float:
    if not abs(value) <= 1e15:
        raise place.refuse("error-size-implausible", value=value)
    return float(value)


def _key(place: Node, known: Known) -> tuple:
    parts = list(place.elements())
    group = parts[0].string(GROUPS) if parts else place.string(GROUPS)
    sizes = {DECLARED: (3,), ALIGNMENT: (2,), RUN: (3,), TOOL: (3,), EFFECT: (3, 4)}[group]
    if len(parts) not in sizes:
        raise place.refuse("uncertainty-key", group=group)
    if group == DECLARED:
        return group, known(parts[1].string(), parts[1].where).symbol, parts[2].integer(0, 30)
    if group == ALIGNMENT:
        return group, known(parts[1].string(), parts[1].where).symbol
    if group == RUN:
        return group, parts[1].string(), known(parts[2].string(), parts[2].where).symbol
    if group == TOOL:
        return group, parts[1].integer(0, MOST), parts[2].integer(0, 2)
    if len(parts) == 3:
        return group, parts[1].string(), parts[2].string()
    return group, parts[1].string(), known(parts[2].string(), parts[2].where).symbol, parts[3].integer(0, MOST)


def _other(place: Node, scales, known: Known) -> OtherName:
    keys = ("component", "driver", "shape", "parameters", "weight", "changes")
    place.keys(keys, keys)
    c = known(place["component"].string(), place["component"].where)
    effect = effects_json.of_place(place, f"{c.symbol} by {place['driver'].string()}", c)
    weight = place["weight"].number()
    if not 0 <= weight <= 1:
        raise place["weight"].refuse("uncertainty-weight")
    changes = [_finite(e.number(), e) * s for e, s in zip(place["changes"].elements(len(scales)), scales)]
    return OtherName(effect, weight, tuple(changes))


# -- writing -----------------------------------------------------------------------------------------------------------
def to_dict(model: Uncertainty, known: Known = component) -> dict:
    """The uncertainty as it stands in the file."""
    scales = [scale_of(key, known) for key in model.parameters]
    out: dict = {
        "parameters": [list(key) for key in model.parameters],
        "factor": [[_short(v / s) for v in row] for row, s in zip(model.factor, scales)],
    }
    if model.others:
        out["others"] = [_other_dict(o, scales, known) for o in model.others]
    return out


def _other_dict(other: OtherName, scales, known: Known) -> dict:
    e = other.effect
    return {
        "component": e.component,
        "driver": str(e.driver),
        "shape": e.shape.name,
        "parameters": {name: numbers.to_dict() for name, numbers in shown(e, known(e.component)).items()},
        "weight": other.weight,
        "changes": [_short(v / s) for v, s in zip(other.changes, scales)],
    }
