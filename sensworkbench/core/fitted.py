# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a fit of readings gave to a machine: error functions, constants, alignment of the set-up, runs, tools, ranges.

Everything is in mm and rad; files and their units are read and written by `formats.machine_json` alone.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from .effects import Effect
from .errors import Component, component
from .shapes import to_domain

DECLARED, ALIGNMENT, RUN, TOOL, EFFECT = "declared", "alignment", "run", "tool", "effect"
DIGITS = 9  # of a number of the covariance in a file


@dataclass(frozen=True)
class Series:
    """An error function of one joint's position: a Legendre series.

    domain : (low, high) of the position, mm or degrees, mapped to [-1, 1].  coefficients : (n + 1,) of P_0 .. P_n,
    mm or rad.  u : (n + 1,) their standard uncertainties, None where not determined; empty: none is known.
    """

    domain: tuple[float, float]
    coefficients: tuple[float, ...]
    u: tuple[float | None, ...] = ()

    def __call__(self, q) -> np.ndarray:
        """The error (P,) at positions q (P,), mm or degrees."""
        return np.polynomial.legendre.legval(to_domain(q, self.domain), np.asarray(self.coefficients, dtype=float))

    @property
    def empty(self) -> bool:
        """Whether all coefficients are 0."""
        return not any(self.coefficients)

    def plus(self, constant: float) -> Series:
        """The series with `constant` added at every position; uncertainties stay."""
        return replace(self, coefficients=(self.coefficients[0] + constant, *self.coefficients[1:]))


@dataclass(frozen=True)
class Constant:
    """A constant error, mm or rad, with its standard uncertainty (None: not known or not determined)."""

    value: float
    u: float | None = None


@dataclass(frozen=True)
class ToolError:
    """What the readings with one tool showed in common: offset (3,) of the tool point and error (3,), mm."""

    offset: tuple[float, float, float]
    error: tuple[float, float, float]


@dataclass(frozen=True)
class OtherName:
    """An explanation that the readings cannot tell from an effect that was named.

    effect : it, with the coefficients of a fit that holds it instead.  weight : its probability.  changes : (n,) by
    which the parameters of the model change in that fit.
    """

    effect: Effect
    weight: float
    changes: tuple[float, ...]


@dataclass(frozen=True)
class Uncertainty:
    """Covariance of all that a fit found: factor times its transpose, and what the choice among names adds.

    parameters : (n,) keys: ("declared", "EXX", order), ("alignment", "EXW"), ("run", label, "EXW"), ("tool", number
    from 0, axis 0 to 2), ("effect", name, component, number of a coefficient from 0), ("effect", name, parameter of its
    shape).
    factor : n rows of at most k numbers, zeros at the end of a row left out; mm, rad and internal units of drivers.
    """

    parameters: tuple[tuple, ...]
    factor: tuple[tuple[float, ...], ...]
    others: tuple[OtherName, ...] = ()

    def matrix(self) -> np.ndarray:
        """(n, k) the factor."""
        width = max((len(r) for r in self.factor), default=1) or 1
        return np.array([[*row, *[0.0] * (width - len(row))] for row in self.factor]).reshape(-1, width)


def scale_of(key: tuple, known: Callable[..., Component] = component) -> float:
    """Unit, in a file, of the parameter of a key of `Uncertainty`: um 1e-3, urad 1e-6; 1 of a parameter of a shape.

    known : the look-up of a symbol among a machine's components.
    """
    place = {DECLARED: 1, ALIGNMENT: 1, RUN: 2, EFFECT: 2 if len(key) == 4 else None}.get(key[0])
    if place is None:
        return 1e-3 if key[0] == TOOL else 1.0
    return known(key[place]).from_shown(1.0)


def uncertainty_of(parameters, factor, others=()) -> Uncertainty:
    """The `Uncertainty` of a factor (n, k), rounded as a file holds it; zeros at the ends of its rows are left out."""
    scales = [scale_of(key) for key in parameters]
    rows = []
    for row, scale in zip(np.asarray(factor, dtype=float), scales):
        values = [float(f"{v / scale:.{DIGITS}g}") * scale for v in row.tolist()]
        while values and values[-1] == 0.0:
            values.pop()
        rows.append(tuple(values))
    others = [
        replace(o, changes=tuple(float(f"{v / s:.{DIGITS}g}") * s for v, s in zip(o.changes, scales))) for o in others
    ]
    return Uncertainty(tuple(parameters), tuple(rows), tuple(others))


@dataclass(frozen=True)
class FittedModel:
    """Fitted errors of a machine and of the set-up that measured it.

    series : error functions by symbol.  constants : squareness, and axis errors that were given as one number.
    alignment : of the set-up by symbol (EXW .. ECW).  runs : label -> symbol -> Constant, what each run adds to it.
    tools : per tool.  ranges : column -> (lowest, highest) of the readings.  covariance : name of the .npz file beside
    the machine's, or None.  uncertainty : covariance of all of it and of the effects of the machine, or None where it
    is not known.  extra : keys "x-..." of the file, kept.
    """

    series: Mapping[str, Series] = field(default_factory=dict)
    constants: Mapping[str, Constant] = field(default_factory=dict)
    alignment: Mapping[str, Constant] = field(default_factory=dict)
    runs: Mapping[str, Mapping[str, Constant]] = field(default_factory=dict)
    tools: tuple[ToolError, ...] = ()
    ranges: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    covariance: str | None = None
    uncertainty: Uncertainty | None = None
    extra: Mapping = field(default_factory=dict)

    @property
    def symbols(self) -> tuple[str, ...]:
        """The errors of the machine that have a fitted value, in the order in which they were given."""
        return (*self.series, *self.constants)

    def values(self, symbol: str, q) -> np.ndarray:
        """The error (P,) of `symbol` at positions q (P,) of its joint, mm or degrees; zero where nothing is fitted."""
        if symbol in self.series:
            return self.series[symbol](q)
        constant = self.constants.get(symbol)
        return np.full(len(q), 0.0 if constant is None else constant.value)

    def with_errors(self, changes: Mapping[str, Series | Constant | None]) -> FittedModel:
        """The model with some errors replaced (None: removed).

        The covariance belongs to the old values and is left out.
        """
        series = {s: v for s, v in self.series.items() if s not in changes}
        constants = {s: v for s, v in self.constants.items() if s not in changes}
        for symbol, value in changes.items():
            if isinstance(value, Series):
                series[symbol] = value
            elif value is not None:
                constants[symbol] = value
        return replace(self, series=series, constants=constants, covariance=None, uncertainty=None)
