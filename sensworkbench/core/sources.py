# SPDX-License-Identifier: LGPL-2.1-or-later
"""Errors that come from one cause: a source S with a law, and the factors by which errors follow it, X = mu + L S.

One rail gives straightness and pitch; one temperature lengthens three scales.  The sources are independent, so Y stays
a quadratic form in them, A' = LᵀAL, and every exact formula for independent inputs holds for S unchanged.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ..messages import Refused
from .distributions import Tolerance

LARGEST_FACTOR = 1e6  # mm or rad per unit of the source


@dataclass(frozen=True)
class Source:
    """A common cause of several errors.

    name : of its own.  law : of the pure number S.  factors : symbol -> mm or rad of the error per unit of S.
    """

    name: str
    law: Tolerance
    factors: Mapping[str, float]

    def __post_init__(self):
        where = f"source {self.name}"
        if not isinstance(self.name, str) or not self.name.strip():
            raise Refused("source-without-name", "sources")
        if not self.factors:
            raise Refused("source-without-factors", where)
        for symbol, factor in self.factors.items():
            if not math.isfinite(factor) or abs(factor) > LARGEST_FACTOR:
                raise Refused("source-factor-invalid", where, symbol=symbol, factor=factor)


@dataclass(frozen=True)
class ErrorTable:
    """Everything that varies: n independent inputs, and how the errors follow them.

    labels (n): symbol, or name of an effect or source.  columns (n): the symbol of each input ("" for a source).
    owners (n): the body that an input belongs to; a source that moves several bodies belongs to itself.  laws (n).
    symbols (m): the errors whose columns of Omega are used.  mixing : (m, n) error per unit of each input, or None
    where every input is one error.  without_extent : effects that no range is known of, which take no part.
    """

    labels: tuple[str, ...]
    columns: tuple[str, ...]
    owners: tuple[str, ...]
    laws: tuple[Tolerance, ...]
    symbols: tuple[str, ...]
    mixing: np.ndarray | None = None
    without_extent: tuple[str, ...] = ()

    def __iter__(self):
        """labels, columns, owners, laws: what is asked for together most often."""
        return iter((list(self.labels), list(self.columns), list(self.owners), list(self.laws)))

    def mixed(self, omega: np.ndarray) -> np.ndarray:
        """(P, 3, n) coefficients of the inputs from (P, 3, m) of the errors."""
        if self.mixing is None:
            return omega
        positions_last = np.einsum("anp,nk->akp", omega.transpose(1, 2, 0), self.mixing)
        return positions_last.transpose(2, 0, 1)


def mixing_matrix(columns, sources) -> tuple[tuple[str, ...], np.ndarray | None]:
    """(symbols, mixing) of inputs that are one error each, `columns`, followed by `sources`; see `ErrorTable`."""
    if not sources:
        return tuple(columns), None
    symbols = list(dict.fromkeys([*columns, *(s for source in sources for s in source.factors)]))
    at = {s: i for i, s in enumerate(symbols)}
    mixing = np.zeros((len(symbols), len(columns) + len(sources)))
    for j, symbol in enumerate(columns):
        mixing[at[symbol], j] = 1.0
    for j, source in enumerate(sources, start=len(columns)):
        for symbol, factor in source.factors.items():
            mixing[at[symbol], j] = factor
    return tuple(symbols), mixing
