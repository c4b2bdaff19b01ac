# SPDX-License-Identifier: LGPL-2.1-or-later
"""Preferences among equal explanations: a declared table, in units of chi-square.

If several explanations fit the readings equally well, that with the smallest sum of costs is named and the others are
its rivals; a cost of 2 corresponds to odds of e.  The data overrule it: a gain of chi-square counts against it one to
one.  The order is that of the machine builder: the body's own axis first, a logged column before time, the simpler
shape, fewer factors.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from ..core.driver import POSITIONS, TIME
from ..core.errors import ROTATION, SQUARENESS, TRANSLATION, Component, component
from ..core.shapes import Regressor
from ..messages import Message


@dataclass(frozen=True)
class Rule:
    """One preference.  code : of its sentence.  cost : chi-square each time it applies; below zero: preferred.

    times : how often it applies to a component and a driver through a shape.
    """

    code: str
    cost: float
    times: Callable[[Component, Regressor], float]

    @property
    def why(self) -> Message:
        """Why the rule prefers one explanation to another, in words."""
        return Message(self.code)


def _along(c: Component) -> str:
    return "XYZ"[c.axis]


def _growth(c: Component, r: Regressor) -> bool:
    return r.shape.settles and c.kind == TRANSLATION and not r.driver.axes


def _slipped(r: Regressor) -> bool:
    return r.shape.sudden and r.driver.columns == (TIME,)


def _own(c: Component, r: Regressor) -> bool:
    return c.kind == TRANSLATION and _along(c) == c.body and r.driver.axes == {c.body}


PRIOR: tuple[Rule, ...] = (
    Rule("prior-parameter", 7.0, lambda c, r: r.shape.complexity),
    Rule("prior-shape", 1.0, lambda c, r: r.shape.prior),
    Rule("prior-factor", 2.0, lambda c, r: r.driver.factors - 1),
    Rule("prior-time", 2.0, lambda c, r: TIME in r.driver),
    Rule("prior-repeated", 0.5, lambda c, r: r.driver.repeats),
    Rule("prior-expansion", 8.0, lambda c, r: r.shape.series and r.driver.columns[0].startswith("temp_")),
    Rule("prior-squareness", 3.5, lambda c, r: c.kind == SQUARENESS),
    Rule("prior-other-axis", 3.0, lambda c, r: bool(r.driver.axes) and c.body not in r.driver.axes),
    Rule(
        "prior-two-axes",
        1.0,
        lambda c, r: len(r.driver.axes) > 1 and bool(set(r.driver.columns) - set(POSITIONS)),
    ),
    Rule("prior-tool", 0.6, lambda c, r: c.body == "T" and not (_growth(c, r) and c.axis == 2)),
    Rule("prior-workpiece", 0.8, lambda c, r: c.body == "W" and not _slipped(r)),
    Rule("prior-carriage", 0.5, lambda c, r: c.body not in "TW" and (_growth(c, r) or _slipped(r))),
    Rule("prior-tilt", 0.7, lambda c, r: c.kind == ROTATION and not r.driver.axes),
    Rule("prior-across", 0.3, lambda c, r: c.kind == TRANSLATION and _along(c) != c.body),
    Rule("prior-itself", -3.0, _own),
    Rule(
        "prior-roll",
        0.05,
        lambda c, r: c.kind == ROTATION and _along(c) in r.driver.axes and c.body in r.driver.axes,
    ),
    Rule("prior-order", 0.01, lambda c, r: "XYZTW".find(c.body)),
)


def handicap(symbol: str, regressor: Regressor) -> float:
    """Sum of the costs of `PRIOR` for a component and a driver through a shape, in units of chi-square."""
    c = component(symbol)
    return round(float(sum(rule.cost * rule.times(c, regressor) for rule in PRIOR)), 9)  # sums of the same costs tie
