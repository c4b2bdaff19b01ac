# SPDX-License-Identifier: LGPL-2.1-or-later
"""The error components: every one is a small rigid motion of one body (ISO 230-1 names, Park & Yang's as aliases).

A component is a translation or a rotation about one of the machine's axes of one body: a carriage (X, Y, Z), the
spindle with its tool (T) or the workpiece with its fixture (W).  The three squareness errors tilt the direction of
motion of Y and Z.  What *drives* a component is not decided here; see `drivers`.
"""

from __future__ import annotations

from dataclasses import dataclass

from .refusal import Refused

AXES = ("X", "Y", "Z")
BODIES = ("X", "Y", "Z", "T", "W")
TRANSLATION, ROTATION, SQUARENESS = "translation", "rotation", "squareness"

BODY_NAMES = {
    "X": "X carriage",
    "Y": "Y carriage",
    "Z": "Z carriage",
    "T": "spindle and tool",
    "W": "workpiece and fixture",
}


@dataclass(frozen=True)
class Component:
    """One error component.

    symbol : ISO 230-1 name (`EAX`, `C0Y`).  body : who moves.  kind : translation, rotation or squareness.
    axis : 0, 1, 2 - the machine axis along or about which it moves.  alias : the paper's name ("" where it has none).
    """

    symbol: str
    body: str
    kind: str
    axis: int
    alias: str = ""

    @property
    def angular(self) -> bool:
        return self.kind != TRANSLATION

    @property
    def unit(self) -> str:
        """The unit it is shown and exchanged in."""
        return "urad" if self.angular else "um"

    @property
    def description(self) -> str:
        if self.kind == SQUARENESS:
            return f"squareness of {self.body} to {'Y' if self.symbol == 'A0Z' else 'X'}"
        along = AXES[self.axis]
        if self.body == "W":
            return f"workpiece {'rotation about' if self.angular else 'shift along'} {along}"
        if self.body == "T":
            return f"spindle {'tilt about' if self.angular else 'shift along'} {along}"
        if self.angular:
            # roll is about the direction of travel; the others are pitch and yaw of the carriage
            name = "roll" if along == self.body else "tilt"
            return f"{name} of {self.body} about {along}"
        return f"{'positioning' if along == self.body else 'straightness'} of {self.body}" + (
            "" if along == self.body else f" along {along}"
        )


def _all() -> dict[str, Component]:
    found = {}
    for body in BODIES:
        low = body.lower()
        for i, name in enumerate("XYZ"):
            alias = f"delta_{name.lower()}{low}" if body != "W" else ""
            found[f"E{name}{body}"] = Component(f"E{name}{body}", body, TRANSLATION, i, alias)
        for i, name in enumerate("ABC"):
            alias = f"epsilon_{'xyz'[i]}{low}" if body in AXES else ""
            found[f"E{name}{body}"] = Component(f"E{name}{body}", body, ROTATION, i, alias)
    for symbol, body, i, alias in (("C0Y", "Y", 2, "s_xy"), ("A0Z", "Z", 0, "s_yz"), ("B0Z", "Z", 1, "s_xz")):
        found[symbol] = Component(symbol, body, SQUARENESS, i, alias)
    return found


COMPONENTS: dict[str, Component] = _all()
SQUARENESS_SYMBOLS = ("C0Y", "A0Z", "B0Z")
FUNCTION_SYMBOLS = tuple(s for s, c in COMPONENTS.items() if c.body in AXES and c.kind != SQUARENESS)  # the 18
DECLARED_SYMBOLS = FUNCTION_SYMBOLS + SQUARENESS_SYMBOLS  # the 21
PAPER_SYMBOLS = DECLARED_SYMBOLS + ("EXT", "EYT", "EZT")  # the 24 of Park & Yang's example


def _aliases() -> dict[str, str]:
    table = {c.alias.upper(): s for s, c in COMPONENTS.items() if c.alias}
    for name in ("X", "Y", "Z"):
        table[f"{name}T"] = f"E{name}T"
    for long, greek in (("DELTA_", "Δ_"), ("EPSILON_", "Ε_")):  # upper case of δ_ and ε_
        table |= {k.replace(long, greek): v for k, v in list(table.items()) if k.startswith(long)}
    for symbol in SQUARENESS_SYMBOLS:
        table[f"E_{symbol}"] = symbol
    table |= {"E_C(0X)Y": "C0Y", "E_A(0Y)Z": "A0Z", "E_B(0X)Z": "B0Z"}
    return table


_ALIASES = _aliases()


def component(symbol: str, where: str = "") -> Component:
    """The component of an ISO 230-1 name or one of its aliases; refuses unknown names."""
    key = str(symbol).strip().upper()
    key = _ALIASES.get(key, key)
    try:
        return COMPONENTS[key]
    except KeyError:
        raise Refused(
            f"unknown error {symbol!r}",
            where,
            "Use ISO 230-1 names: EXX ... ECZ, C0Y, A0Z, B0Z, EXT ... ECT, EXW ... ECW.",
        ) from None
