# SPDX-License-Identifier: LGPL-2.1-or-later
"""The error components: every one is a small rigid motion of one body (ISO 230-1 and 230-7 names, Park & Yang's as
aliases).

A component is a motion of a body - what a joint carries, the spindle with its tool (T) or the workpiece with its
fixture (W) - along or about one of the machine's axes, or an error of the axis line of a joint: the squareness of a
linear one, position and orientation of a rotary one.  What *drives* a component is not decided here; see `driver`.
"""

from __future__ import annotations

from dataclasses import dataclass

from ..messages import Message, Refused
from . import units
from .joints import AXIS_ORIENTATION, AXIS_POSITION, LINEAR, SQUARENESS

AXES = ("X", "Y", "Z")
ENDS = ("T", "W")  # the bodies that are no joint's: spindle and tool, workpiece and fixture
BODIES = (*AXES, *ENDS)
TRANSLATION, ROTATION = "translation", "rotation"
LINE_KINDS = (SQUARENESS, AXIS_POSITION, AXIS_ORIENTATION)


@dataclass(frozen=True)
class Component:
    """One error component.

    symbol : ISO name (`EAX`, `C0Y`, `X0C`).  body : name of the joint, or T, W.  kind : translation, rotation, or an
    error of the axis line: squareness, axis position, axis orientation.  axis : 0, 1, 2 - the machine axis along or
    about which it moves.  along : the machine axis nearest to the joint's direction (-1 for T and W).  alias : the
    paper's name ("" where it has none).
    """

    symbol: str
    body: str
    kind: str
    axis: int
    alias: str = ""
    along: int = -1

    @property
    def line(self) -> bool:
        """Whether it is an error of an axis line, rather than a motion of a body."""
        return self.kind in LINE_KINDS

    @property
    def angular(self) -> bool:
        """Whether it is an angle (rad), rather than a length (mm)."""
        return self.kind not in (TRANSLATION, AXIS_POSITION)

    @property
    def unit(self) -> str:
        """The unit it is shown and exchanged in."""
        return "urad" if self.angular else "um"

    def to_shown(self, value):
        """`value` (mm or rad) in `unit`."""
        return value * (1e6 if self.angular else 1e3)

    def from_shown(self, value):
        """`value` in `unit` as mm or rad."""
        return value * (1e-6 if self.angular else 1e-3)

    def from_unit(self, value, unit: str, where: str = ""):
        """`value` in any unit of its kind as mm or rad; refuses a unit of another kind."""
        return value * units.factor(unit, angular=self.angular, where=where)

    @property
    def title(self) -> Message:
        """What it is: `straightness of X along Y`."""
        fields = {"body": self.body, "axis": AXES[self.axis]}
        if self.kind == SQUARENESS:
            return Message("error-squareness", body=self.body, other=square_to(self))
        if self.line:
            return Message("error-axis-orientation" if self.angular else "error-axis-position", **fields)
        if self.body == "W":
            return Message("error-workpiece-rotation" if self.angular else "error-workpiece-shift", axis=fields["axis"])
        if self.body == "T":
            return Message("error-spindle-tilt" if self.angular else "error-spindle-shift", axis=fields["axis"])
        own = self.axis == self.along
        if self.angular:  # roll is about the direction of travel; the others are pitch and yaw of the carriage
            return Message("error-roll" if own else "error-tilt", **fields)
        return Message("error-positioning", body=self.body) if own else Message("error-straightness", **fields)


def square_to(c: Component) -> str:
    """The axis to which a squareness is measured: square to the joint's own and to the axis of the tilt."""
    return AXES[3 - c.axis - c.along]


def components_of(joints) -> tuple[Component, ...]:
    """All components of a machine: motions of each joint's body, of T and W, then the errors of the axis lines.

    joints : (name, kind, along, fixed) of each: the frame axis nearest to its direction, and the rotations of its line
    that define the frame.
    """
    found: list[Component] = []
    described = list(joints)
    for body, along in [*((name, along) for name, _, along, _ in described), ("T", -1), ("W", -1)]:
        known = body in BODIES
        for i, letter in enumerate("XYZ"):
            alias = f"delta_{letter.lower()}{body.lower()}" if known and body != "W" else ""
            found.append(Component(f"E{letter}{body}", body, TRANSLATION, i, alias, along))
        for i, letter in enumerate("ABC"):
            alias = f"epsilon_{'xyz'[i]}{body.lower()}" if body in AXES else ""
            found.append(Component(f"E{letter}{body}", body, ROTATION, i, alias, along))
    for name, kind, along, fixed in described:
        for words, axis in kind.line_errors(along, fixed):
            symbol = f"{('XYZ' if words == AXIS_POSITION else 'ABC')[axis]}0{name}"
            found.append(Component(symbol, name, words, axis, _SQUARENESS_ALIASES.get(symbol, ""), along))
    return tuple(found)


_SQUARENESS_ALIASES = {"C0Y": "s_xy", "A0Z": "s_yz", "B0Z": "s_xz"}

# the machine of three square linear axes X, Y, Z, whose names the formats and the paper speak
COMPONENTS: dict[str, Component] = {
    c.symbol: c for c in components_of([("X", LINEAR, 0, (0, 1, 2)), ("Y", LINEAR, 1, (0,)), ("Z", LINEAR, 2, ())])
}
SQUARENESS_SYMBOLS = ("C0Y", "A0Z", "B0Z")
FUNCTION_SYMBOLS = tuple(s for s, c in COMPONENTS.items() if c.body in AXES and not c.line)  # the 18
DECLARED_SYMBOLS = FUNCTION_SYMBOLS + SQUARENESS_SYMBOLS  # the 21
PAPER_SYMBOLS = DECLARED_SYMBOLS + ("EXT", "EYT", "EZT")  # the 24 of Park & Yang's example


def _aliases() -> dict[str, str]:
    table = {c.alias.upper(): s for s, c in COMPONENTS.items() if c.alias}
    for name in AXES:
        table[f"{name}T"] = f"E{name}T"
    for long, greek in (("DELTA_", "Δ_"), ("EPSILON_", "Ε_")):  # upper case of δ_ and ε_
        table |= {k.replace(long, greek): v for k, v in list(table.items()) if k.startswith(long)}
    table |= {"E_C(0X)Y": "C0Y", "E_A(0Y)Z": "A0Z", "E_B(0X)Z": "B0Z"}
    return table


_ALIASES = _aliases()


def canonical(symbol) -> str:
    """Return the ISO name of a symbol or alias: `E_C0Y` and `s_xy` are `C0Y`.  Does not check that the error exists."""
    key = str(symbol).strip().upper()
    key = _ALIASES.get(key, key)
    return key[2:] if key.startswith("E_") else key


def find(table, symbol, where: str = "") -> Component:
    """The component of an ISO name or alias in `table` (symbol -> Component); refuses one that is not there."""
    found = table.get(canonical(symbol))
    if found is None:
        known = [s for s, c in table.items() if not c.line]
        lines = [s for s, c in table.items() if c.line]
        raise Refused("component-unknown", where, symbol=repr(symbol)[:60], first=known[0], last=known[-1], lines=lines)
    return found


def component(symbol, where: str = "") -> Component:
    """The component of an ISO name or alias on a machine of three linear axes X, Y, Z; refuses unknown names."""
    return find(COMPONENTS, symbol, where)
