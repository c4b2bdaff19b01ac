# SPDX-License-Identifier: LGPL-2.1-or-later
"""Named physical effects on top of the systematic scan: what a finding is called, how large it may be, what to check.

A finding that matches an entry carries its name; one that matches none is described by body, motion and driver.  The
sizes are those that machine builders report; they are stated for plausibility, not used to fit.
"""

from __future__ import annotations

from dataclasses import dataclass

from ..core.errors import BODY_NAMES, ROTATION, TRANSLATION, component
from .bank import DIRECTIONS, POSITIONS


@dataclass(frozen=True)
class Physical:
    """name, size (what is usual), check (what to look at on the machine), needs (columns; not testable without)."""

    name: str
    size: str
    check: str
    needs: tuple[str, ...] = ()


CATALOGUE = {
    "reversal": Physical("reversal error (backlash)", "1-20 um", "ball screw nut, coupling, guide preload", ("dir",)),
    "angular_reversal": Physical(
        "angular reversal error",
        "1-30 urad",
        "guide preload, drive offset from the guides",
        ("dir",),
    ),
    "windup": Physical(
        "position-dependent reversal (wind-up)",
        "1-10 um",
        "ball screw stiffness and preload along the travel",
        ("dir",),
    ),
    "following": Physical(
        "following error with feed and direction",
        "1-20 um",
        "servo gain, feed forward",
        ("dir", "feed"),
    ),
    "feed": Physical("error with feed", "1-20 um", "servo gain, feed forward", ("feed",)),
    "hysteresis": Physical("hysteresis of guide or drive", "1-5 um", "friction, cable chain, preload", ("x",)),
    "thermal_scale": Physical(
        "thermal expansion of a scale or screw",
        "5-25 um/(m K)",
        "scale temperature, screw cooling, expansion coefficient in the control",
        ("temp",),
    ),
    "thermal_bend": Physical(
        "thermal bending of the structure",
        "5-30 um/(m K)",
        "temperature difference front to back, coolant and sun on the casting",
        ("temp",),
    ),
    "thermal_shift": Physical("thermal displacement", "1-30 um", "heat sources beside the part that moves", ("temp",)),
    "spindle_growth": Physical("spindle growth", "10-60 um", "spindle cooling, warm-up cycle", ("t", "spindle")),
    "drift": Physical("drift in time", "1-20 um", "warm-up, fixture, foundation; log temperatures", ("t",)),
    "slip": Physical("sudden shift in time", "1-50 um", "clamping of workpiece, artefact, probe or tool", ("t",)),
    "cyclic": Physical(
        "cyclic error of screw or encoder",
        "1-10 um (screw)",
        "screw lead and bearing, encoder head",
        ("x",),
    ),
    "mass": Physical(
        "deflection under the moved mass",
        "1-10 um per 100 kg",
        "guide stiffness, levelling, load on the table",
        ("load",),
    ),
    "overhang": Physical("sag with overhang", "5-30 um", "weight compensation, ram and rail stiffness", ()),
    "cross": Physical(
        "carriage that another axis bends",
        "2-20 um",
        "stiffness of the guide that carries the other axis",
        (),
    ),
    "spindle": Physical(
        "displacement with spindle speed",
        "1-20 um",
        "spindle bearings, centrifugal growth",
        ("spindle",),
    ),
}


def physical(symbol: str, driver: str, shape: str) -> Physical | None:
    """The catalogue entry that a finding matches, or None."""
    c = component(symbol)
    parts = driver.split("*")
    kinds = {_kind(p) for p in parts}
    own = c.body.lower()
    if shape == "smooth":
        return None
    if shape == "hysteresis":
        return CATALOGUE["hysteresis"]
    if shape == "periodic":
        return CATALOGUE["cyclic"] if parts[0] == own or parts[0] in POSITIONS else None
    if kinds == {"dir"} and len(parts) == 1:
        return CATALOGUE["angular_reversal" if c.kind == ROTATION else "reversal"]
    if kinds == {"dir", "feed"}:
        return CATALOGUE["following"]
    if kinds == {"dir", "place"}:
        return CATALOGUE["windup"]
    if kinds == {"feed"}:
        return CATALOGUE["feed"]
    if kinds == {"temp", "place"} and len(parts) == 2:
        along = next(p for p in parts if p in POSITIONS)
        if c.kind == TRANSLATION and "xyz"[c.axis] == along:
            return CATALOGUE["thermal_scale"]
        return CATALOGUE["thermal_bend"]
    if kinds == {"temp", "place"} or (kinds == {"temp"} and c.angular):
        return CATALOGUE["thermal_bend"]
    if kinds == {"temp"}:
        return CATALOGUE["thermal_shift"]
    if "load" in kinds and kinds <= {"load", "place"}:
        return CATALOGUE["mass"]
    if "spindle" in kinds and kinds <= {"spindle"}:
        return CATALOGUE["spindle_growth" if shape == "lag" and c.axis == 2 else "spindle"]
    if kinds == {"t"} and shape == "step":
        return CATALOGUE["slip"]
    if kinds == {"t"} and shape in ("approach", "linear", "polynomial"):
        return CATALOGUE["spindle_growth" if shape == "approach" and symbol == "EZT" else "drift"]
    if kinds == {"place"} and shape in ("linear", "polynomial"):
        return CATALOGUE["overhang" if len(set(parts)) > 1 else "cross"]
    return None


def _kind(column: str) -> str:
    if column in POSITIONS:
        return "place"
    if column in DIRECTIONS:
        return "dir"
    return next((k for k in ("temp", "load", "feed", "spindle") if column.startswith(k)), column)


MOTION = {
    TRANSLATION: "shift along {}",
    ROTATION: "rotation about {}",
    "squareness": "tilt of the direction of motion about {}",
}


def describe(symbol: str, driver: str, shape: str) -> str:
    """A finding in words: its catalogue name with body and motion, or body, motion and driver."""
    c = component(symbol)
    motion = f"{BODY_NAMES[c.body]}, {MOTION[c.kind].format('XYZ'[c.axis])}"
    found = physical(symbol, driver, shape)
    driven = f"driven by {driver.replace('*', ' x ')}" + ("" if shape in ("linear", "reversal") else f" ({shape})")
    return f"{found.name}: {motion}, {driven}" if found else f"{motion}, {driven}"


def not_testable(columns) -> list[dict]:
    """Catalogue entries whose columns are not in the readings (or do not vary): {"effect", "needs"}."""
    out = []
    for entry in CATALOGUE.values():
        lacking = [n for n in entry.needs if not any(c == n or c.startswith(n + "_") for c in columns)]
        if lacking:
            names = {"dir": "dir_x, dir_y, dir_z", "temp": "temp_<name>_C", "load": "load_<name>_kg", "t": "t_s",
                     "feed": "feed_mm_min", "spindle": "spindle_rpm", "x": "x_mm"}  # fmt: skip
            out.append({"effect": entry.name, "needs": ", ".join(names[n] for n in lacking)})
    return out
