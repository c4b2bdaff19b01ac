# SPDX-License-Identifier: LGPL-2.1-or-later
"""Named physical effects on top of the systematic scan: what a finding is called, how large it may be, what to check.

A finding takes the name of the first entry of `CATALOGUE` that matches it; one that matches none is described by body,
motion and driver.  The sizes are those that machine builders report; they are stated for plausibility, not used to fit.
A new effect is one entry and one file, `messages/effects/<key>.json`: its words `effect-<key>`, `-size` and `-check` in
all languages, and what is `meant` by it, examples (component, driver, shape, parameters) that must carry its name.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from ..core.driver import POSITIONS, Driver
from ..core.errors import ROTATION, SQUARENESS, TRANSLATION, Component, component
from ..core.shapes import Shape
from ..messages import Message

NEEDED = {  # kind of column -> its names in a file
    "dir": "dir_x, dir_y, dir_z",
    "temp": "temp_<name>_C",
    "load": "load_<name>_kg",
    "t": "t_s",
    "feed": "feed_mm_min",
    "spindle": "spindle_rpm",
    "x": "x_mm",
}


@dataclass(frozen=True)
class Physical:
    """A named effect.

    key : its name in code and messages.  matches : whether a component with a driver and a shape is this effect, given
    that no entry before it is.  needs : kinds of columns that it cannot be tested without (keys of `NEEDED`).
    """

    key: str
    matches: Callable[[Component, Driver, Shape], bool]
    needs: tuple[str, ...] = ()

    @property
    def name(self) -> Message:
        """What the effect is called."""
        return Message(f"effect-{self.key}")

    @property
    def size(self) -> Message:
        """What is usual."""
        return Message(f"effect-{self.key}-size")

    @property
    def check(self) -> Message:
        """What to look at on the machine."""
        return Message(f"effect-{self.key}-check")


def _driven_by(*kinds: str) -> Callable[[Component, Driver, Shape], bool]:
    return lambda c, driver, shape: driver.kinds == set(kinds)


def _scale(c: Component, driver: Driver, shape: Shape) -> bool:
    """A shift along the axis whose place multiplies the temperature."""
    if driver.kinds != {"temp", "place"} or driver.factors != 2 or c.kind != TRANSLATION:
        return False
    return POSITIONS[c.axis] in driver


def _bend(c: Component, driver: Driver, shape: Shape) -> bool:
    return driver.kinds == {"temp", "place"} or (driver.kinds == {"temp"} and c.angular)


def _growth(c: Component, driver: Driver, shape: Shape) -> bool:
    """Along Z: with a memory of the speed, or of the spindle with the time since the start."""
    if not (shape.settles and c.axis == 2):
        return False
    return driver.kinds == {"spindle"} or (driver.kinds == {"t"} and c.body == "T" and c.kind == TRANSLATION)


def _drift(c: Component, driver: Driver, shape: Shape) -> bool:
    return driver.kinds == {"t"} and (shape.warm_up or shape.proportional or shape.series)


def _places(c: Component, driver: Driver, shape: Shape) -> bool:
    return driver.kinds == {"place"} and (shape.proportional or shape.series)


# the order is the order of precedence
_ENTRIES = (
    Physical("hysteresis", lambda c, driver, shape: shape.play, ("x",)),
    Physical("cyclic", lambda c, driver, shape: shape.wave and driver.columns[0] in POSITIONS, ("x",)),
    Physical(
        "angular-reversal",
        lambda c, driver, shape: driver.kinds == {"dir"} and driver.factors == 1 and c.kind == ROTATION,
        ("dir",),
    ),
    Physical("reversal", lambda c, driver, shape: driver.kinds == {"dir"} and driver.factors == 1, ("dir",)),
    Physical("windup", _driven_by("dir", "place"), ("dir",)),
    Physical("following", _driven_by("dir", "feed"), ("dir", "feed")),
    Physical("feed", _driven_by("feed"), ("feed",)),
    Physical("thermal-scale", _scale, ("temp",)),
    Physical("thermal-bend", _bend, ("temp",)),
    Physical("thermal-shift", _driven_by("temp"), ("temp",)),
    Physical("spindle-growth", _growth, ("t", "spindle")),
    Physical("drift", _drift, ("t",)),
    Physical("slip", lambda c, driver, shape: driver.kinds == {"t"} and shape.sudden, ("t",)),
    Physical("mass", lambda c, driver, shape: {"load"} <= driver.kinds <= {"load", "place"}, ("load",)),
    Physical("overhang", lambda c, driver, shape: _places(c, driver, shape) and len(driver.names) > 1),
    Physical("cross", _places),
    Physical("spindle", _driven_by("spindle"), ("spindle",)),
)
CATALOGUE = {entry.key: entry for entry in _ENTRIES}


def physical(symbol: str, driver: Driver, shape: Shape) -> Physical | None:
    """The catalogue entry that a finding matches, or None; a free form matches none."""
    if shape.free:
        return None
    c = component(symbol)
    return next((entry for entry in CATALOGUE.values() if entry.matches(c, driver, shape)), None)


MOTION = {TRANSLATION: "effect-motion-shift", ROTATION: "effect-motion-rotation", SQUARENESS: "effect-motion-tilt"}
ENDS = {"T": "effect-body-tool", "W": "effect-body-workpiece"}


def motion_words(symbol: str) -> Message:
    """Which body moves and how: "Z carriage, rotation about X"."""
    c = component(symbol)
    body = Message(ENDS.get(c.body, "effect-body-carriage"), name=c.body)
    return Message(MOTION[c.kind], body=body, axis="XYZ"[c.axis])


def describe(symbol: str, driver: Driver, shape: Shape) -> Message:
    """A finding in words: its catalogue name with body and motion, or body, motion and driver."""
    fields = {"motion": motion_words(symbol), "driver": driver.words("x")}
    found = physical(symbol, driver, shape)
    code = "effect-unnamed" if found is None else "effect-named"
    if found is not None:
        fields["effect"] = found.name
    if not shape.proportional:
        return Message(f"{code}-shaped", **fields, shape=shape.words)
    return Message(code, **fields)


def not_testable(columns) -> tuple[tuple[Message, str], ...]:
    """(name, columns that it needs) of entries whose columns are not in the readings, or do not vary."""
    out = []
    for entry in CATALOGUE.values():
        lacking = [n for n in entry.needs if not any(c == n or c.startswith(n + "_") for c in columns)]
        if lacking:
            out.append((entry.name, ", ".join(NEEDED[n] for n in lacking)))
    return tuple(out)
