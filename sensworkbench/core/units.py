# SPDX-License-Identifier: LGPL-2.1-or-later
"""Units in and out.  Inside, lengths are mm and angles rad; files and windows show um, urad or arcsec and mm.

FreeCAD's own unit parser cannot read urad or arcsec (and takes "1 µrad" for a bare 1), so angles are parsed here.
"""

from __future__ import annotations

import math
import re

from .refusal import Refused

ARCSEC = math.pi / 180 / 3600

LENGTH = {"mm": 1.0, "um": 1e-3, "µm": 1e-3, "μm": 1e-3, "nm": 1e-6, "m": 1e3, "cm": 10.0, "in": 25.4, "inch": 25.4}
ANGLE = {
    "rad": 1.0, "mrad": 1e-3, "urad": 1e-6, "µrad": 1e-6, "μrad": 1e-6, "nrad": 1e-9,
    "deg": math.pi / 180, "°": math.pi / 180, "arcmin": 60 * ARCSEC, "arcsec": ARCSEC, "″": ARCSEC,
}  # fmt: skip
# the same quantity per metre of travel is an angle too: squareness and slopes are often stated so
ANGLE |= {"um/m": 1e-6, "µm/m": 1e-6, "μm/m": 1e-6, "mm/m": 1e-3}

_NUMBER = re.compile(r"\s*([-+]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][-+]?\d+)?)\s*(.*?)\s*$")


def um(length):
    """A length in mm as a number of um."""
    return length * 1e3


def mm(length):
    """A length in um as a number of mm."""
    return length * 1e-3


def factor(unit: str, *, angular: bool, where: str = "") -> float:
    """Multiply a number in `unit` by this to get mm (or rad when `angular`)."""
    table = ANGLE if angular else LENGTH
    try:
        return table[unit.strip()]
    except (KeyError, AttributeError):
        raise Refused("unit-not-of-angle" if angular else "unit-not-of-length", where, unit=repr(unit)[:60]) from None


def parse(text: str, *, angular: bool, default_unit: str, where: str = "") -> float:
    """Read "12,5 µrad" or "3 um" (decimal comma or point; bare numbers are in `default_unit`) as mm or rad."""
    match = _NUMBER.match(text)
    if not match:
        raise Refused("quantity-not-a-number", where, text=repr(text)[:60], unit=default_unit)
    number, unit = match.groups()
    value = float(number.replace(",", ".")) * factor(unit or default_unit, angular=angular, where=where)
    if not math.isfinite(value):
        raise Refused("quantity-not-finite", where, text=repr(text)[:60])
    return value


def shown(value: float, unit: str, *, angular: bool) -> float:
    """`value` (mm or rad) as a number in `unit`."""
    return value / factor(unit, angular=angular)


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
