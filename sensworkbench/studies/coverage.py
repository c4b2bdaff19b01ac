# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a format can express of a machine's fitted errors and effects, why not the rest, and what error remains.

`after_compensation` gives the machine with the covered errors taken out: the same predictor then answers what error a
controller that runs the tables still makes.  Linear interpolation between table points is judged by the writers.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Protocol

from ..core.effects import Effect
from ..core.errors import AXES, ENDS, ROTATION, TRANSLATION, Component
from ..core.machine import Machine
from ..messages import Message
from .fitted_errors import as_direction, present, with_fitted


class Holder(Protocol):
    """A format as this study sees it: what it can hold."""

    def holds(self, item: Item) -> Message | None:
        """Why it cannot hold an item; None where it can."""


@dataclass(frozen=True)
class Coverage:
    """symbols : fitted errors that are covered.  effects : names of effects that are.  missing : (name, reason)."""

    symbols: tuple[str, ...]
    effects: tuple[str, ...]
    missing: tuple[tuple[str, Message], ...]


@dataclass(frozen=True)
class Drive:
    """What a position table would be looked up by: axes of position, and the axis whose direction matters ("" none)."""

    axes: tuple[str, ...]
    direction: str = ""


@dataclass(frozen=True)
class Item:
    """What a table is asked to hold: a component that is a function of positions and of a direction of travel.

    component : the error.  axes : joints whose positions it depends on.  direction : the joint whose direction of
    travel matters ("" none).  output : the linear axis that moves along it ("" none).  declared : whether it is a
    fitted error rather than an effect.  obstacle : why no table of linear axes X, Y, Z can hold it, or None.
    """

    component: Component
    axes: tuple[str, ...]
    direction: str = ""
    output: str = ""
    declared: bool = False
    obstacle: Message | None = None

    @property
    def inputs(self) -> tuple[str, ...]:
        """The joints whose position or direction it depends on."""
        return tuple(dict.fromkeys((*self.axes, self.direction) if self.direction else self.axes))


def table_axes(machine: Machine) -> tuple[str, ...]:
    """The joints that tables of controllers know: linear X, Y, Z."""
    return tuple(j.name for j in machine.joints if j.slides and j.name in AXES)


def along(machine: Machine, axis: int) -> str:
    """The linear axis X, Y or Z that moves along an axis of the machine frame ("" none)."""
    found = [k for k in table_axes(machine) if machine.component(f"EX{k}").along == axis]
    return found[0] if found else ""


def drive(machine: Machine, effect: Effect) -> Drive | Message:
    """The table arguments of an effect, or the reason why no table of positions can hold it."""
    columns = effect.driver.columns
    position = {j.column: j.name for j in machine.joints}
    direction = {f"dir_{j.column}": j.name for j in machine.joints}
    foreign = sorted(c for c in set(columns) if c not in position and c not in direction)
    if foreign:
        return Message("table-foreign-column", columns=foreign)
    directions = [c for c in columns if c in direction]
    axes = tuple(sorted({position[c] for c in columns if c in position}))
    if directions:
        if len(directions) > 1 or not effect.shape.proportional:
            return Message("table-one-direction")
        return Drive(axes, direction[directions[0]])
    if not effect.shape.tabulable:
        return Message("table-shape", shape=effect.shape.name)
    return Drive(axes)


def item_of(machine: Machine, symbol: str, at: Drive, declared: bool) -> Item:
    """An error of a machine as a format is asked for it."""
    c = machine.component(symbol)
    output = along(machine, c.axis)
    return Item(c, at.axes, at.direction, output, declared, _obstacle(machine, c, at, output))


def _obstacle(machine: Machine, c: Component, at: Drive, output: str) -> Message | None:
    """Why tables of linear axes X, Y, Z cannot hold it; None where they can."""
    if c.body in ENDS:
        return Message("table-no-axis-error")
    known = table_axes(machine)
    for name in dict.fromkeys((c.body, *at.axes, *([at.direction] if at.direction else []))):
        if name not in known:
            return Message("table-axis-unknown" if machine.joint(name).slides else "table-rotary", axis=name)
    for chain in (machine.workpiece_chain, machine.tool_chain):
        below = chain[: chain.index(c.body)] if c.body in chain else ()
        carrier = next((k for k in below if not machine.joint(k).slides), None)
        if carrier is not None:
            return Message("table-rides", axis=carrier)
    if c.kind == TRANSLATION and not output:
        return Message("table-no-axis-along", axis=AXES[c.axis])
    return None


def on_lines(machine: Machine, symbol: str, at: Drive) -> bool:
    """Whether tables of the whole error along lines through a point follow it there, though not elsewhere."""
    item = item_of(machine, symbol, at, False)
    return item.obstacle is None and (item.component.kind != TRANSLATION or len(item.inputs) > 1)


def expressible(machine: Machine, holder: Holder, through=None) -> Coverage:
    """What a format can hold of the fitted errors and the enabled effects, and the reason for each that it cannot.

    through : a value per joint, mm or rad, of axis tables that hold the whole error along lines; rotations are then
    held there only, which their reason says.
    """
    machine = as_direction(machine)
    symbols, effects, missing = [], [], []
    for symbol in present(machine):
        why = holder.holds(item_of(machine, symbol, Drive((machine.component(symbol).body,)), True))
        if why is not None:
            missing.append((symbol, why))
        else:
            symbols.append(symbol)
    for effect in machine.effects:
        if not effect.enabled:
            continue
        at = drive(machine, effect)
        why = at if isinstance(at, Message) else holder.holds(item_of(machine, effect.component, at, False))
        if why is not None:
            missing.append((effect.name, why))
        else:
            effects.append(effect.name)
    if through is not None:
        missing = _on_the_lines(machine, holder, through, missing)
    return Coverage(tuple(symbols), tuple(effects), tuple(missing))


def _on_the_lines(machine: Machine, holder: Holder, through, missing):
    """`missing` with the reasons of what is held on lines through a position only."""
    shown = ", ".join(f"{j.name} {j.to_shown(v):g} {j.unit}" for j, v in zip(machine.joints, through))
    there = Message("table-on-lines", position=shown)
    turned = set()
    for effect in machine.effects:
        at = drive(machine, effect)
        if isinstance(at, Drive) and on_lines(machine, effect.component, at) and _reaches(machine, holder, effect, at):
            turned.add(effect.name)
    for symbol in (s for s, _ in missing if s in machine.declared_symbols):
        c = machine.component(symbol)
        if c.kind == ROTATION and on_lines(machine, symbol, Drive((c.body,))):
            turned.add(symbol)
    return [(name, there if name in turned else why) for name, why in missing]


def _reaches(machine: Machine, holder: Holder, effect: Effect, at: Drive) -> bool:
    """Whether one of an effect's inputs alone could shift the axis along its component."""
    c = machine.component(effect.component)
    if c.kind != TRANSLATION:
        return True
    inputs = item_of(machine, effect.component, at, False).inputs
    return any(holder.holds(item_of(machine, effect.component, Drive((k,)), False)) is None for k in inputs)


def after_compensation(machine: Machine, holder: Holder) -> Machine:
    """The machine that is left when a controller applies the tables: covered errors and effects are taken out.

    Squareness is stated as a tilt of direction in the result.  Declared functions and tolerances stay.
    """
    coverage = expressible(machine, holder)
    machine = as_direction(machine)
    effects = [replace(e, enabled=False) if e.name in coverage.effects else e for e in machine.effects]
    return with_fitted(machine, dict.fromkeys(coverage.symbols), effects)
