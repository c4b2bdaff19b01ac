# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a shape is, the table of all shapes, and a driver through a shape.

A shape with its parameters gives the columns (P, m) that the m coefficients of an effect multiply.  Everything that the
program needs to know of a shape is an attribute or a method of its class: no other module asks for a shape by its name.
A new shape is one class under `@register`, and its words in `messages/shapes/<name>.json`.  Rows are in time order
wherever a shape has memory.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar

import numpy as np

from ...messages import Message
from ...messages.tables import known
from ..driver import DIRECTIONS, POSITIONS, TIME, Driver
from ..parameters import Parameter
from ..refusal import Refused

SAMPLES = 513  # of a driver's range, to find the extremes of a shape over it

SHAPES: dict[str, type[Shape]] = {}


def register(cls: type[Shape]) -> type[Shape]:
    """Add a shape to `SHAPES`; refuses a name that is taken (ValueError: a defect of the program)."""
    if cls.name in SHAPES:
        raise ValueError(f"two shapes are called {cls.name!r}")
    SHAPES[cls.name] = cls
    return cls


def shape_class(name: str, where: str = "") -> type[Shape]:
    """The class of the shape called `name`; refuses an unknown name."""
    try:
        return SHAPES[name]
    except KeyError:
        raise Refused("shape-unknown", where, name=repr(name), known=list(SHAPES)) from None


# -- what a search looks over ----------------------------------------------------------------------------------------
class Varying:
    """The columns of some readings that vary, and what each is: what a shape's `scan` chooses its drivers from.

    columns : name -> (P,) values.  names : those that vary.
    """

    def __init__(self, columns: Mapping[str, np.ndarray], names: Sequence[str]):
        self.columns, self.names = columns, list(names)

    @cached_property
    def two_level(self) -> set[str]:
        """Return the columns with at most two values."""
        return {n for n in self.names if len(np.unique(self.columns[n])) <= 2}

    @cached_property
    def places(self) -> list[str]:
        """Return the columns that are positions."""
        return [n for n in POSITIONS if n in self.names]

    @cached_property
    def directions(self) -> list[str]:
        """Return the columns that are directions of approach."""
        return [n for n in DIRECTIONS if n in self.names]

    @cached_property
    def many_levels(self) -> list[str]:
        """Columns of more than four values, directions left out."""
        return [n for n in self.names if n not in DIRECTIONS and len(np.unique(self.columns[n])) > 4]

    @cached_property
    def remembered(self) -> list[str]:
        """Columns, neither places, directions nor time, that keep their value from one reading to the next.

        A lag of one that jumps is a trend in disguise.
        """
        rest = [n for n in self.names if n not in (*POSITIONS, *DIRECTIONS, TIME)]
        return [n for n in rest if float(np.mean(np.diff(self.columns[n]) ** 2)) < float(np.var(self.columns[n]))]

    def span(self, name: str) -> float:
        """Return the largest less the smallest value of a column."""
        return float(np.ptp(self.columns[name]))


# -- the base --------------------------------------------------------------------------------------------------------
class Shape:
    """A shape with its parameters.  Two of one class and equal parameters are equal.

    Class attributes: `name` (in files); `parameters` (name -> Parameter, collected from the class); `prior` (chi-square
    by which a simpler shape goes first, or, below zero, this one); and what is true of it:
    `needs_time` (the column t takes part); `memory` (the order of the rows matters, so it is no function of its
    driver); `proportional` (in proportion to its driver); `wave` (repeats along its driver; its parameter is `period`);
    `sudden` (jumps); `warm_up` (what every machine does after the start); `settles` (tends to a final value); `play`
    (follows with play, and holds the reversal of the same axis); `series` (terms of higher and higher order); `free`
    (follows anything: locates, never names); `tabulable` (a table over positions can hold it); `compared` (a plan looks
    for effects that it could not tell from one of this shape); `scanned` (stands in the bank, with at most two
    coefficients; else it is tried beside the leaders of a search).
    """

    name: ClassVar[str] = ""
    parameters: ClassVar[dict[str, Parameter]] = {}
    prior: ClassVar[float] = 0.0
    needs_time: ClassVar[bool] = False
    memory: ClassVar[bool] = False
    proportional: ClassVar[bool] = False
    wave: ClassVar[bool] = False
    sudden: ClassVar[bool] = False
    warm_up: ClassVar[bool] = False
    settles: ClassVar[bool] = False
    play: ClassVar[bool] = False
    series: ClassVar[bool] = False
    free: ClassVar[bool] = False
    tabulable: ClassVar[bool] = False
    compared: ClassVar[bool] = True
    scanned: ClassVar[bool] = True

    def __init_subclass__(cls, **kwargs):
        super().__init_subclass__(**kwargs)
        cls.parameters = {k: v for c in reversed(cls.__mro__) for k, v in vars(c).items() if isinstance(v, Parameter)}

    def __init__(self, **values):
        """values : of the parameters, in internal units.  Refuses one that is missing, unknown or out of bounds."""
        kept = {}
        for name, parameter in self.parameters.items():
            value = values.pop(name, parameter.default)
            if value is None:
                raise Refused("parameter-missing", shape=self.name, name=name)
            kept[name] = parameter.check(value)
        for name in values:
            raise Refused("parameter-unknown", shape=self.name, name=name)
        self.values = kept

    def __eq__(self, other) -> bool:
        return type(self) is type(other) and self.values == other.values

    def __hash__(self) -> int:
        return hash((type(self), tuple(self.values.items())))

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{k}={v!r}' for k, v in self.values.items())})"

    def having(self, **changes) -> Shape:
        """The same shape with some parameters changed."""
        return type(self)(**{**self.values, **changes})

    # -- what it is --------------------------------------------------------------------------------------------------
    @property
    def size(self) -> int:
        """Number of coefficients m."""
        return 1

    @classmethod
    def title(cls) -> Message:
        """The shape's name for a reader: `shape-<name>` of `messages/shapes/<name>.json`, else the name itself."""
        code = f"shape-{cls.name}"
        return Message(code) if known(code) else Message("shape-other", name=cls.name)

    @property
    def fitted(self) -> tuple[str, ...]:
        """The parameters that are found by a search."""
        return tuple(n for n, p in self.parameters.items() if p.search is not None)

    @property
    def complexity(self) -> int:
        """Numbers fitted beyond a first coefficient."""
        return len(self.fitted) + max(self.size - 1, 0)

    @property
    def words(self) -> Message:
        """The shape's name for a reader."""
        return self.title()

    @property
    def saturation(self) -> float | None:
        """What its columns saturate at, in the driver's unit; None where they do not."""
        return None

    @property
    def unit_power(self) -> float:
        """Power of the driver's unit in its columns: a coefficient is um or urad per that."""
        return 0.0

    def columns(self, driver: Driver) -> tuple[str, ...]:
        """The columns of the readings that it needs with this driver."""
        return driver.names if not self.needs_time or TIME in driver else (*driver.names, TIME)

    def check_driver(self, driver: Driver) -> None:
        """Refuse a driver that the shape cannot have."""

    def in_order(self, order: Sequence[int], coefficients, u) -> tuple[Shape, tuple, tuple | None]:
        """(shape, coefficients, u) for a driver whose columns are taken in the order of these numbers.

        Only a shape over the columns, rather than over their product, changes.
        """
        return self, coefficients, u

    # -- what it computes --------------------------------------------------------------------------------------------
    def basis(self, v: np.ndarray, t: np.ndarray | None) -> np.ndarray:
        """(P, m) its columns for driver values v (P,); t (P,) seconds where it needs time, else None."""
        raise NotImplementedError

    def vectors(self, driver: Driver, columns: Mapping[str, np.ndarray], where: str = "") -> np.ndarray:
        """(P, m) its columns for a driver; refuses where one of the columns that it needs is missing."""
        v = driver.values(columns, where)
        return self.basis(v, Driver((TIME,)).values(columns, where) if self.needs_time else None)

    def extremes(self, coefficients, low: float, high: float) -> tuple[float, float]:
        """Lowest and highest value of the basis times `coefficients` (m,) while its driver is in [low, high]."""
        values = self.basis(np.linspace(low, high, SAMPLES), None) @ np.asarray(coefficients, dtype=float)
        return float(values.min()), float(values.max())

    # -- how it is searched ------------------------------------------------------------------------------------------
    @classmethod
    def scan(cls, seen: Varying) -> Iterator[tuple[Driver, Shape]]:
        """Drivers and starts of its unknown parameters for a search; nothing where it is only given."""
        return iter(())

    def joined(self, driver: Driver, other: Shape, other_driver: Driver, columns) -> tuple[Driver, Shape] | None:
        """One driver and shape for this and another on the same component that are parts of one; None for others."""
        return None

    def stored(self, coefficients, covariance) -> tuple[Shape, np.ndarray, np.ndarray]:
        """(shape, coefficients (m,), covariance (m, m)) as an effect keeps them after a fit."""
        return self, coefficients, covariance


@dataclass(frozen=True)
class Regressor:
    """A driver through a shape: columns that the coefficients of an effect multiply."""

    driver: Driver
    shape: Shape

    @classmethod
    def make(cls, driver, name: str, **parameters) -> Regressor:
        """Of a driver (or its text) and the name and parameters of a shape."""
        return cls(Driver.of(driver), shape_class(name)(**parameters))

    @property
    def columns(self) -> tuple[str, ...]:
        """The columns of the readings that it needs."""
        return self.shape.columns(self.driver)

    @property
    def size(self) -> int:
        """Number of columns, m."""
        return self.shape.size

    @property
    def key(self) -> tuple[str, str]:
        """Text of the driver and name of the shape: the same for all values of the parameters."""
        return str(self.driver), self.shape.name

    def vectors(self, columns, where: str = "") -> np.ndarray:
        """(P, m) its columns."""
        return self.shape.vectors(self.driver, columns, where)

    def having(self, **changes) -> Regressor:
        """Return the same driver with other parameters of the shape."""
        return Regressor(self.driver, self.shape.having(**changes))

    def slope(self, columns, coefficients, name: str, step: float) -> np.ndarray:
        """(P,) change of its columns times `coefficients` (m,) per unit of the parameter `name`, over a step to either
        side; a parameter that has a lower limit stays above it.
        """
        parameter, value = self.shape.parameters[name], self.shape.values[name]
        limit = parameter.least if parameter.above is None else parameter.above
        low, high = value - step, value + step
        if low <= limit:
            low = (value + limit) / 2
        high = min(high, parameter.most)
        ends = [self.having(**{name: v}).vectors(columns) @ np.asarray(coefficients) for v in (low, high)]
        return (ends[1] - ends[0]) / (high - low)

    def joined(self, other: Regressor, columns) -> Regressor | None:
        """One for two that are parts of one, or None."""
        for a, b in ((self, other), (other, self)):
            found = a.shape.joined(a.driver, b.shape, b.driver, columns)
            if found is not None:
                return Regressor(*found)
        return None
