# SPDX-License-Identifier: LGPL-2.1-or-later
"""Units of products and quotients in words: `um/(K*mm)`, `urad/(mm/min)`, `mm^2`, `arcsec/K`.

A unit is a factor to the internal unit of its kind (mm, rad, s, K, kg; 1/s for rotations) and the powers of these.
Temperatures are differences.
"""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Mapping
from dataclasses import dataclass, field

from .refusal import Refused
from .units import ANGLE, LENGTH

LONGEST = 80  # characters
TIME = {"s": 1.0, "ms": 1e-3, "min": 60.0, "h": 3600.0}
KELVIN = {"K": 1.0, "C": 1.0, "°C": 1.0, "degC": 1.0, "F": 5 / 9, "°F": 5 / 9, "degF": 5 / 9}
MASS = {"kg": 1.0, "g": 1e-3, "lb": 0.45359237}
TURNS = {"rpm": 1 / 60, "rps": 1.0, "Hz": 1.0}
ZERO = {"C": 20.0, "°C": 20.0, "degC": 20.0, "F": 68.0, "°F": 68.0, "degF": 68.0}  # what is 20 degC on such a scale


@dataclass(frozen=True)
class Unit:
    """factor : to internal units.  powers : kind ("length", "angle", "time", "temperature", "mass") -> power."""

    factor: float = 1.0
    powers: Mapping[str, float] = field(default_factory=dict)

    def times(self, other: Unit, sign: int = 1) -> Unit:
        """Return the product of two units; sign -1: the quotient."""
        powers = dict(self.powers)
        for kind, power in other.powers.items():
            powers[kind] = powers.get(kind, 0.0) + sign * power
        return Unit(self.factor * other.factor**sign, {k: p for k, p in powers.items() if abs(p) > 1e-9})

    def power(self, exponent: float) -> Unit:
        """Return the unit raised to a power."""
        return Unit(self.factor**exponent, {k: p * exponent for k, p in self.powers.items()})

    def same_kind(self, other: Unit) -> bool:
        """Whether both measure the same; powers that were written with four digits count as equal."""
        kinds = {*self.powers, *other.powers}
        return all(abs(self.powers.get(k, 0.0) - other.powers.get(k, 0.0)) < 2e-3 for k in kinds)


UNITS = {"1": Unit()}
UNITS |= {name: Unit(f, {"angle": 1.0}) for name, f in ANGLE.items() if "/" not in name}
for _table, _kind, _power in (
    (LENGTH, "length", 1.0), (TIME, "time", 1.0), (KELVIN, "temperature", 1.0), (MASS, "mass", 1.0),
    (TURNS, "time", -1.0),
):  # fmt: skip
    UNITS |= {name: Unit(f, {_kind: _power}) for name, f in _table.items()}

_TOKEN = re.compile(r"\s*(\^\s*-?\d+(?:\.\d*)?|[*/()·]|1(?![\d.])|[^\W\d_]+|°[CF]?|″)")


def _tokens(text: str) -> list[str] | None:
    if len(text) > LONGEST:
        return None
    found, at = [], 0
    text = text.strip()
    while at < len(text):
        match = _TOKEN.match(text, at)
        if match is None:
            return None
        found.append("*" if match.group(1) == "·" else match.group(1))
        at = match.end()
    return found


class _Parser:
    """One reading of the tokens of a unit; `right`: a/b/c is a/(b/c), else (a/b)/c.  `failed` where it is none."""

    def __init__(self, tokens: list[str], right: bool):
        self.tokens, self.right, self.at, self.failed = tokens, right, 0, False

    def next(self) -> str:
        return self.tokens[self.at] if self.at < len(self.tokens) else ""

    def quotient(self) -> Unit:
        value = self.product()
        while self.next() == "/" and not self.failed:
            self.at += 1
            value = value.times(self.quotient() if self.right else self.product(), -1)
        return value

    def product(self) -> Unit:
        value = self.factor()
        while self.next() == "*" and not self.failed:
            self.at += 1
            value = value.times(self.factor())
        return value

    def factor(self) -> Unit:
        word = self.next()
        self.at += 1
        if word == "(":
            value = self.quotient()
            self.failed |= self.next() != ")"
            self.at += 1
        elif word in UNITS:
            value = UNITS[word]
        else:
            self.failed = True
            return Unit()
        if self.next().startswith("^"):
            exponent = float(self.next()[1:])
            self.at += 1
            self.failed |= not abs(exponent) <= 20
            value = Unit() if self.failed else value.power(exponent)
        return value


def readings(text: str) -> list[Unit]:
    """What a text can mean as a unit: a quotient of quotients has two readings; [] where it is none."""
    if not text.strip():
        return [Unit()]
    tokens, found = _tokens(text), []
    for right in (True, False) if tokens else ():
        parser = _Parser(tokens, right)
        unit = parser.quotient()
        if not parser.failed and parser.at == len(tokens) and math.isfinite(unit.factor) and unit.factor > 0:
            found.append(unit)
    return found


# internal units of what a column can hold, by kind
INTERNAL = ("mm", "rad", "s", "K", "kg", "mm/min", "rpm")


def internal(unit: Unit) -> str | None:
    """The internal unit of what `unit` measures, as a text; None where columns hold nothing of that kind."""
    if not unit.powers:
        return ""
    return next((text for text in INTERNAL if readings(text)[0].same_kind(unit)), None)


def conversion(text: str, wanted: str, where: str = "") -> float:
    """Multiply a number in the unit `text` by this to have it in the unit `wanted`.

    A length over a length stands for an angle.  Refuses what is no unit and a unit of another kind.
    """
    found = readings(text)
    for unit, aim in itertools.product(found, readings(wanted)):
        if unit.same_kind(aim) or unit.times(Unit(1.0, {"angle": 1.0})).same_kind(aim):
            ratio = unit.factor / aim.factor
            near = round(ratio, 15)  # 1e-3 / 1e-6 and the like are whole
            return near if near and abs(near - ratio) <= 4e-16 * abs(ratio) else ratio
    code = "unit-of-another-kind" if found else "unit-unknown"
    raise Refused(code, where, unit=text[:60], wanted=wanted or "1")
