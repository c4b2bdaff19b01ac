# SPDX-License-Identifier: LGPL-2.1-or-later
"""Objectives: numbers computed from the volumetric error, with their indices, registered by name.

An objective is one class: how its indices are computed, the unit of its mean, and its words.  No other module depends
on which objective it is.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import ClassVar

import numpy as np

from ..messages import Refused
from . import limits, sobol
from .distributions import Moments
from .synthesis import ORIENTATION, POSITION


@dataclass(frozen=True)
class Objective:
    """Base of all objectives: components of T (output "position") or R ("orientation"), with their weights.

    weights : (3,), not all zero.  Subclasses give `name`, the indices, and how the mean is shown.
    """

    output: str = POSITION
    weights: tuple[float, float, float] = (1.0, 1.0, 1.0)

    name: ClassVar[str] = ""
    power: ClassVar[int] = 2  # of a length (an angle) in the unit of Y
    signed: ClassVar[bool] = False  # whether Y has a sign
    has_shares: ClassVar[bool] = True  # whether (S + S^T) / 2 is a share of a variance
    order: ClassVar[int | None] = None  # positions per joint where the usual number would take long

    def __post_init__(self):
        if self.output not in (POSITION, ORIENTATION):
            raise Refused("objective-output-unknown", "objective", output=repr(self.output)[:60])
        try:
            weights = tuple(float(w) for w in self.weights)
        except (TypeError, ValueError):
            weights = ()
        if len(weights) != 3 or not np.all(np.isfinite(weights)) or not any(weights):
            raise Refused("objective-weights-invalid", "objective", weights=str(self.weights)[:60])
        if max(abs(w) for w in weights) > LARGEST_WEIGHT:
            raise Refused("objective-weights-too-large", "objective", limit=LARGEST_WEIGHT)
        object.__setattr__(self, "weights", weights)

    # -- what a subclass gives ---------------------------------------------------------------------------------------
    def indices(self, omega: np.ndarray, law: Moments) -> sobol.Indices:
        """Indices of every error.  omega : (P, 3, n)."""
        raise NotImplementedError

    def group_indices(self, omega: np.ndarray, law: Moments, groups) -> sobol.Indices:
        """Indices of groups of errors (lists of columns)."""
        raise NotImplementedError

    def expected(self, found: sobol.Indices) -> np.ndarray:
        """(P,) the expected size of the error behind Y, from its mean and variance; mm (rad)."""
        raise NotImplementedError

    def upper(self, found: sobol.Indices) -> np.ndarray:
        """(P,) an upper estimate of the size: Y two of its standard deviations above its mean; mm (rad)."""
        raise NotImplementedError

    def size_shown(self, mean: float) -> float:
        """The mean as a length in um (or an angle in urad)."""
        raise NotImplementedError

    @property
    def formula(self) -> str:
        """Y in symbols."""
        raise NotImplementedError

    @property
    def conventions(self) -> dict[str, str]:
        """What indices mean where that is not V(E[Y|X_i])/V(Y): entries of the conventions that files state."""
        return {}

    # -- files -------------------------------------------------------------------------------------------------------
    def to_json(self) -> dict:
        """Return plain data from which `from_json` makes an equal objective: its name and all of its fields."""
        own = {f.name: getattr(self, f.name) for f in fields(self)}
        return {"name": self.name} | {k: list(v) if isinstance(v, tuple) else v for k, v in own.items()}

    @property
    def length_unit(self) -> str:
        """Unit of a component of the error: mm or rad."""
        return "mm" if self.output == POSITION else "rad"

    def _terms(self, square: str) -> list[str]:
        names = ("T4", "T5", "T6") if self.output == POSITION else ("R1", "R2", "R3")
        return [(f"{w:g}·" if w != 1 else "") + f"{n}{square}" for n, w in zip(names, self.weights) if w]

    def _scale(self) -> float:
        return 1e3 if self.output == POSITION else 1e6


LARGEST_WEIGHT = 1e12
PER_PLACE = 16_384  # machines that a quantile is sampled from at each place
OBJECTIVES: dict[str, type[Objective]] = {}


def register(cls: type[Objective]) -> type[Objective]:
    """Make an objective known by its `name`."""
    OBJECTIVES[cls.name] = cls
    return cls


@register
@dataclass(frozen=True)
class MeanSquare(Objective):
    """Y = sum_a w_a T_a² (Park & Yang 2012 eq. 14); weights not negative."""

    name: ClassVar[str] = "mean_square"

    def __post_init__(self):
        super().__post_init__()
        if min(self.weights) < 0:
            raise Refused("objective-weights-negative", "objective", weights=str(list(self.weights)))

    def indices(self, omega, law):
        return sobol.indices(omega, law, self.weights)

    def group_indices(self, omega, law, groups):
        return sobol.group_indices(omega, law, groups, self.weights)

    def expected(self, found):
        return np.sqrt(found.mean)

    def upper(self, found):
        return np.sqrt(found.mean + 2 * np.sqrt(found.variance))

    def size_shown(self, mean):
        return float(np.sqrt(mean)) * self._scale()

    @property
    def formula(self):
        return " + ".join(self._terms("²"))


@register
@dataclass(frozen=True)
class Signed(Objective):
    """Y = sum_a w_a T_a: one direction of the error with its sign; S = S^T, and they add to one."""

    name: ClassVar[str] = "signed"
    power: ClassVar[int] = 1
    signed: ClassVar[bool] = True

    def indices(self, omega, law):
        return sobol.signed_indices(omega, law, self.weights)

    def group_indices(self, omega, law, groups):
        return sobol.signed_group_indices(omega, law, groups, self.weights)

    def expected(self, found):
        return np.sqrt(found.variance + found.mean**2)

    def upper(self, found):
        return np.abs(found.mean) + 2 * np.sqrt(found.variance)

    def size_shown(self, mean):
        return float(mean) * self._scale()

    @property
    def formula(self):
        return " + ".join(self._terms("")).replace("+ -", "- ")


@register
@dataclass(frozen=True)
class Quantile(Objective):
    """The value that |T| does not exceed with probability `level` over random machines; weights not negative.

    A quantile is no random number, so it has contributions in place of indices: by how many per cent it grows if an
    error grows by one per cent (see `limits`).  They add to one and stand for S and S^T; there are no shares.  Where
    laws are not normal, machines are sampled: a contribution then has a standard error of about .005.
    """

    name: ClassVar[str] = "quantile"
    power: ClassVar[int] = 1
    has_shares: ClassVar[bool] = False
    order: ClassVar[int | None] = 4
    level: float = 0.95

    def __post_init__(self):
        super().__post_init__()
        if min(self.weights) < 0:
            raise Refused("objective-weights-negative", "objective", weights=str(list(self.weights)))
        if isinstance(self.level, bool) or not isinstance(self.level, (int, float)) or not 0.01 <= self.level <= 0.9999:
            raise Refused("objective-level", "objective", level=repr(self.level)[:40])

    def indices(self, omega, law):
        omega = np.asarray(omega) * np.sqrt(self.weights)[:, None]
        machines = None if limits.normal(law.laws) else limits.sample(law.laws, PER_PLACE)
        found = [limits.RandomError(o, law.laws, machines=machines).quantile(self.level, error=False) for o in omega]
        parts, value = np.array([f.contributions for f in found]), np.array([f.value for f in found])
        return sobol.Indices(parts, parts.copy(), value, value**2)

    def group_indices(self, omega, law, groups):
        found = self.indices(omega, law)
        parts = np.stack([found.first[:, list(g)].sum(axis=1) for g in groups], axis=1)
        return sobol.Indices(parts, parts.copy(), found.mean, found.variance)

    def expected(self, found):
        return found.mean

    def upper(self, found):
        return found.mean

    def size_shown(self, mean):
        return float(mean) * self._scale()

    @property
    def formula(self):
        return f"Q{self.level:g}(√({' + '.join(self._terms('²'))}))"

    @property
    def conventions(self):
        by = "d ln Y / d ln(tolerance and mean of X_i)"
        return {"first": by, "total": by, "share": "none: a quantile has no variance", "component_total": "their sum"}


def objective(output: str = POSITION, weights=(1.0, 1.0, 1.0), signed: bool = False) -> Objective:
    """The mean square of the weighted components, or with `signed` their weighted sum."""
    return (Signed if signed else MeanSquare)(output, tuple(weights))


def from_json(data: dict) -> Objective:
    """Return the objective described by plain data; refuses a name that is not registered."""
    fields = dict(data)
    name = fields.pop("name", "mean_square")
    if name not in OBJECTIVES:
        raise Refused("objective-unknown", "objective", name=repr(name)[:60], known=list(OBJECTIVES))
    try:
        return OBJECTIVES[name](**{k: tuple(v) if isinstance(v, list) else v for k, v in fields.items()})
    except TypeError:
        raise Refused("objective-fields-unknown", "objective", name=name, fields=list(fields)[:5]) from None
