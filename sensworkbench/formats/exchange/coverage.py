# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a format can express of a machine's fitted errors and effects, why not the rest, and what error remains.

`after_compensation` gives the machine with the covered errors taken out: the same predictor then answers what error a
controller that runs the tables still makes.  Linear interpolation between table points is judged by the writers.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from sensworkbench.core.effects import Effect
from sensworkbench.core.errors import AXES, COMPONENTS, ROTATION, SQUARENESS, TRANSLATION, component
from sensworkbench.core.machine import Machine
from sensworkbench.core.refusal import Refused

from .series import as_direction, present, with_fitted

FORMATS = {
    "isg": "ISG CSV (Beckhoff TF5280)",
    "etalon": "Etalon exchange format",
    "linuxcnc": "LinuxCNC COMP_FILE",
    "heidenhain": "Heidenhain .COM",
    "siemens": "Siemens ENC_COMP and CEC",
}
POSITION = {"x": "X", "y": "Y", "z": "Z"}
DIRECTION = {"dir_x": "X", "dir_y": "Y", "dir_z": "Z"}


@dataclass(frozen=True)
class Coverage:
    """symbols : fitted errors that are covered.  effects : names of effects that are.  missing : (name, reason)."""

    format: str
    symbols: tuple[str, ...]
    effects: tuple[str, ...]
    missing: tuple[tuple[str, str], ...]


@dataclass(frozen=True)
class Drive:
    """What a position table would be looked up by: axes of position, and the axis whose direction matters ("" none)."""

    axes: tuple[str, ...]
    direction: str = ""


def drive(effect: Effect) -> Drive | str:
    """The table arguments of an effect, or the reason why no table of positions can hold it."""
    columns = effect.driver.columns
    foreign = sorted(c for c in set(columns) if c not in POSITION and c not in DIRECTION)
    if foreign:
        return f"a controller table does not know {', '.join(foreign)}"
    directions = [c for c in columns if c in DIRECTION]
    axes = tuple(sorted({POSITION[c] for c in columns if c in POSITION}))
    if directions:
        if len(directions) > 1 or not effect.shape.proportional:
            return "a table knows one direction of travel, and only in proportion"
        return Drive(axes, DIRECTION[directions[0]])
    if not effect.shape.tabulable:
        return f"a table of positions cannot hold the shape {effect.shape.name!r}"
    return Drive(axes)


def check_format(fmt: str) -> str:
    """Return `fmt`; refuses a name that is no exchange format."""
    if fmt not in FORMATS:
        raise Refused(f"unknown format {fmt!r}", "format", f"Use one of {', '.join(FORMATS)}.")
    return fmt


def _parametric(fmt: str, symbol: str, at: Drive) -> str:
    """Why ISG or Etalon tables cannot hold a component driven so ("" if they can)."""
    c = component(symbol)
    if c.body not in AXES:
        return "it is no error of an axis"
    if at.direction:
        return "the tables do not know the direction of travel"
    if fmt == "etalon" and (c.kind == SQUARENESS or set(at.axes) != {c.body}):
        return "a table depends on the axis's own position only"
    return ""


def _axis_table(fmt: str, symbol: str, at: Drive) -> str:
    """Why a table that shifts one axis by the position of one axis cannot hold it ("" if it can)."""
    c = component(symbol)
    if c.kind != TRANSLATION:
        return "tables that shift an axis cannot follow a rotation, whose effect depends on the other axes and the tool"
    along = AXES[c.axis]
    inputs = set(at.axes) | ({at.direction} - {""})
    if len(inputs) != 1:
        return "a table depends on the position of one axis"
    return line_obstacle(fmt, *inputs, along, bool(at.direction))


def line_obstacle(fmt: str, source: str, output: str, reverses: bool) -> str:
    """Why the controller has no table that shifts `output` by the position (and direction) of `source`."""
    if fmt == "linuxcnc" and source != output:
        return "a table shifts an axis by its own position only"
    if fmt == "heidenhain" and reverses and source != output:
        return "the table knows the direction of travel only for the axis's own shift"
    return ""


def _on_lines(fmt: str, symbol: str, at: Drive) -> bool:
    """Whether tables of the whole error along lines through a point follow it there, though not elsewhere."""
    c = component(symbol)
    inputs = set(at.axes) | ({at.direction} - {""})
    return c.kind != TRANSLATION or (len(inputs) > 1 and (fmt != "linuxcnc" or AXES[c.axis] in inputs))


def obstacle(fmt: str, symbol: str, at: Drive) -> str:
    """Return why `fmt` cannot hold the component `symbol` driven by `at`; "" if it can."""
    rule = _parametric if fmt in ("isg", "etalon") else _axis_table
    return rule(fmt, symbol, at)


def _declared_obstacle(fmt: str, symbol: str) -> str:
    c = component(symbol)
    if c.kind == SQUARENESS:
        return "a table shifts an axis by its own position only" if fmt == "linuxcnc" else ""
    return obstacle(fmt, symbol, Drive((c.body,)))


def expressible(machine: Machine, fmt: str, through=None) -> Coverage:
    """What `fmt` can hold of the fitted errors and the enabled effects, and the reason for each that it cannot.

    through : position of axis tables that hold the whole error along lines; rotations are then held there only, which
    their reason says.
    """
    check_format(fmt)
    machine = as_direction(machine)
    symbols, effects, missing = [], [], []
    for symbol in present(machine):
        why = _declared_obstacle(fmt, symbol)
        if why:
            missing.append((symbol, why))
        else:
            symbols.append(symbol)
    for effect in machine.effects:
        if not effect.enabled:
            continue
        at = drive(effect)
        why = at if isinstance(at, str) else obstacle(fmt, effect.component, at)
        if why:
            missing.append((effect.name, why))
        else:
            effects.append(effect.name)
    if through is not None and fmt not in ("isg", "etalon"):
        there = "held only along the lines of the axes through ({:g}, {:g}, {:g}) mm".format(*through)
        turned = {
            e.name for e in machine.effects if isinstance(d := drive(e), Drive) and _on_lines(fmt, e.component, d)
        }
        turned |= {s for s, _ in missing if s in COMPONENTS and COMPONENTS[s].kind == ROTATION}
        missing = [(name, there if name in turned else why) for name, why in missing]
    return Coverage(fmt, tuple(symbols), tuple(effects), tuple(missing))


def after_compensation(machine: Machine, fmt: str) -> Machine:
    """The machine that is left when a controller applies the tables: covered errors and effects are taken out.

    Squareness is stated as a tilt of direction in the result.  Declared functions and tolerances stay.
    """
    coverage = expressible(machine, fmt)
    machine = as_direction(machine)
    effects = [replace(e, enabled=False) if e.name in coverage.effects else e for e in machine.effects]
    return with_fitted(machine, dict.fromkeys(coverage.symbols), effects)
