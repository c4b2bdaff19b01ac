# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colour maps that colour-blind readers can distinguish, and the range of values that they show.

Viridis (van der Walt, Smith) and cividis (Nuñez, Anderton, Renslow 2018) as 17 anchors each, linear between them, and
for values with a sign Moreland's diverging map (2009), blue below zero and red above.  A
part without a value is grey.  Pure Python: a handful of parts needs no arrays.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

NO_DATA = (0.62, 0.62, 0.62)
_ANCHORS = {
    "viridis": "44015448186a472d7b4240863b528b33638d2c728e26828e21918c1fa08828ae803fbc735ec96284d44baddc30d8e219fde725",
    "cividis": "00224e002e6a1a386f32436d434e6c535a6d61656f6f70737d7c788c88789b9476aba072bcae6ccdbb63dec958f0d846fee838",
    "magma": "0000040a08221d114736106b51127c6a1c818326819c2e7fb73779d0416fe75263f56b5cfc8961fea772fec488fde2a3fcfdbf",
}
MAPS = tuple(_ANCHORS)
DIVERGING = "diverging"
_ANCHORS[DIVERGING] = (
    "3b4cc04d68d76282ea779af78db0fea3c2ffb8d0f9ccd9eeddddddecd3c5f5c4adf7b194f49a7bec7f63de604dcb3e38b40426"
)
_TABLES = {
    name: [tuple(int(text[i + k : i + k + 2], 16) / 255 for k in (0, 2, 4)) for i in range(0, len(text), 6)]
    for name, text in _ANCHORS.items()
}


def colour(fraction: float, name: str = "viridis") -> tuple[float, float, float]:
    """(r, g, b) in 0..1 at `fraction` of the map; clamped; grey for None and NaN."""
    if fraction is None or math.isnan(fraction):
        return NO_DATA
    table = _TABLES.get(name, _TABLES["viridis"])
    place = min(max(float(fraction), 0.0), 1.0) * (len(table) - 1)
    i = min(int(place), len(table) - 2)
    rest = place - i
    return tuple(a + (b - a) * rest for a, b in zip(table[i], table[i + 1]))


@dataclass(frozen=True)
class Scale:
    """A range of values and its colours.  Where lower == upper every value has the middle colour."""

    lower: float = 0.0
    upper: float = 1.0
    name: str = "viridis"

    def fraction(self, value) -> float | None:
        """Return the place of a value between the limits, 0 to 1 inside; None for no value."""
        if value is None or not math.isfinite(value):
            return None
        if not self.upper > self.lower:
            return 0.5
        return (value - self.lower) / (self.upper - self.lower)

    def colour(self, value) -> tuple[float, float, float]:
        """Return the colour (red, green, blue) of a value, 0 to 1; grey for no value."""
        return colour(self.fraction(value), self.name)

    def ticks(self, wanted: int = 5) -> list[float]:
        """Round values inside the range, its ends included."""
        if not self.upper > self.lower:
            return [self.lower]
        step = nice((self.upper - self.lower) / max(1, wanted), up=True)
        first = math.ceil(self.lower / step - 1e-9) * step
        inside = [first + i * step for i in range(int((self.upper - first) / step + 1e-9) + 1)]
        keep = [v for v in inside if min(abs(v - self.lower), abs(v - self.upper)) > 0.4 * step]
        return [self.lower, *keep, self.upper]


def nice(value: float, *, up: bool) -> float:
    """The next of 1, 2, 2.5, 5 x 10^n at or above (`up`), or below, a positive value."""
    if not value > 0 or not math.isfinite(value):
        return 1.0
    power = 10.0 ** math.floor(math.log10(value))
    steps = [s * power for s in (1, 2, 2.5, 5, 10)]
    if up:
        return next(s for s in steps if s >= value * (1 - 1e-9))
    return max(s for s in steps if s <= value * (1 + 1e-9))


def symmetric(values) -> Scale:
    """From minus to plus a round value at or above the largest size: zero has the neutral colour."""
    top = automatic([abs(v) for v in values if v is not None and math.isfinite(v)]).upper
    return Scale(-top, top, DIVERGING)


def automatic(values, name: str = "viridis") -> Scale:
    """From 0 to a round value at or above the largest finite one: comparable from machine to machine."""
    finite = [v for v in values if v is not None and math.isfinite(v)]
    top = max(finite, default=0.0)
    if top <= 0:
        return Scale(0.0, 1.0, name)
    power = 10.0 ** math.floor(math.log10(top))
    steps = [s * power for s in (1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10)]
    return Scale(0.0, next(s for s in steps if s >= top * (1 - 1e-9)), name)
