# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fitted error functions of a machine with their uncertainty, and the decision against its tolerances.

Decision rule (JCGM 106:2012, 8.3): guarded acceptance with a guard band of U = k u on either side of both limits.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..core.fitted import DECLARED
from ..core.machine import Machine
from ..core.propagation import propagated
from ..core.shapes import legendre

K = 2.0  # coverage factor
POINTS = 61
CONFORMS, FAILS, OPEN, UNKNOWN = "conforms", "fails", "open", "not-determined"


@dataclass(frozen=True)
class ErrorRow:
    """One declared error over its travel, mm or rad.

    place (P,): position, mm.  value, u (P,); u is NaN where it is not known.  orders : Legendre order -> (coefficient,
    u or None).  limits : of its tolerance.  decision : CONFORMS, FAILS, OPEN or UNKNOWN.
    """

    symbol: str
    angular: bool
    place: np.ndarray
    value: np.ndarray
    u: np.ndarray
    orders: dict[int, tuple[float, float | None]]
    limits: tuple[float, float] | None
    decision: str

    @property
    def determined(self) -> bool:
        """Whether the readings determine it wholly."""
        return self.decision != UNKNOWN

    @property
    def largest(self) -> tuple[float, float, float]:
        """(position, value, u) where its size is largest."""
        i = int(np.argmax(np.abs(self.value)))
        return float(self.place[i]), float(self.value[i]), float(self.u[i])


def error_rows(machine: Machine) -> list[ErrorRow]:
    """Every declared error of a fitted machine, in the order in which its axes are declared; [] without a fit."""
    fitted = machine.fitted
    if fitted is None:
        return []
    tolerances = machine.all_tolerances
    known = fitted.uncertainty
    factor = None if known is None else known.matrix()
    at = {} if known is None else {key: i for i, key in enumerate(known.parameters)}
    out = []
    for symbol in fitted.symbols:
        c = machine.component(symbol)
        series, constant = fitted.series.get(symbol), fitted.constants.get(symbol)
        if series is not None:
            place = np.linspace(*series.domain, POINTS)
            basis = legendre(place, len(series.coefficients) - 1, series.domain, start=0)
            coefficients, own = series.coefficients, series.u or (None,) * len(series.coefficients)
            orders = {k: (v, own[k]) for k, v in enumerate(coefficients) if (DECLARED, symbol, k) in at or v}
        else:
            place, basis = np.zeros(1), np.ones((1, 1))
            coefficients, orders = (constant.value,), {0: (constant.value, constant.u)}
        value = basis @ np.array(coefficients)
        rows = [at.get((DECLARED, symbol, k)) for k in range(basis.shape[1])]
        u = np.full(len(place), np.nan)
        if factor is not None and any(r is not None for r in rows):
            wide = np.stack([np.zeros(factor.shape[1]) if r is None else factor[r] for r in rows])
            u = propagated(basis, wide)
        elif series is None and constant.u is not None:
            u = np.array([constant.u])
        tolerance = tolerances.get(symbol)
        limits = None if tolerance is None else (tolerance.lower, tolerance.upper)
        told = bool(orders) and all(v is not None for _, v in orders.values()) and np.isfinite(u).all()
        out.append(ErrorRow(symbol, c.angular, place, value, u, orders, limits, _decision(value, u, limits, told)))
    return out


def _decision(value, u, limits, determined: bool) -> str:
    if not determined or limits is None:
        return UNKNOWN if not determined else OPEN
    low, high = limits
    wide = K * u
    if (value - wide >= low).all() and (value + wide <= high).all():
        return CONFORMS
    return FAILS if (value - wide > high).any() or (value + wide < low).any() else OPEN
