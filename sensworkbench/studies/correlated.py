# SPDX-License-Identifier: LGPL-2.1-or-later
"""The study of correlated errors: what each component contributes to V(Y) if errors vary together.

The inputs are normal with a covariance: of tolerances (one rail gives straightness and pitch), or of the parameters of
a fit, whose remaining uncertainty is then divided among components.  Shares are Shapley effects (`core.shapley`), mean
over the workspace.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..core import workspace
from ..core.fitted import DECLARED
from ..core.machine import Machine
from ..core.refusal import Refused
from ..core.shapes import legendre
from ..core.shapley import MOST_GROUPS, checked_covariance, gaussian_shares
from ..core.synthesis import omega
from ..core.workspace import Cancelled, Positions, error_table

Progress = Callable[[float], bool]


@dataclass(frozen=True)
class Share:
    """A group of inputs.  share : of V(Y), adding to one over the groups; first, total : V(E[Y|X_g])/V and
    1 - V(E[Y|X_~g])/V, which need not be in order where inputs are correlated."""

    name: str
    share: float
    first: float
    total: float


@dataclass(frozen=True)
class CorrelatedResult:
    """components : shares of the bodies.  blocks : (names of the errors, share) of each set of errors that vary
    together and independently of all others.  errors : shares of single errors in their block, of blocks that can be
    enumerated; they add up to the share of the block.  mean_square (mm²), variance (mm⁴): of Y, mean over the
    workspace.  of_fit : whether the inputs are the parameters of a fit."""

    machine: Machine
    components: tuple[Share, ...]
    blocks: tuple[tuple[tuple[str, ...], float], ...]
    errors: tuple[Share, ...]
    mean_square: float
    variance: float
    of_fit: bool


@dataclass(frozen=True)
class Inputs:
    """labels, owners (n): of the inputs; mean (n,), covariance (n, n): mm and rad; columns (P, 3, n): mm per unit."""

    labels: tuple[str, ...]
    owners: tuple[str, ...]
    mean: np.ndarray
    covariance: np.ndarray
    columns: np.ndarray


def of_tolerances(machine: Machine, symbols: Sequence[str], covariance, where: Positions) -> Inputs:
    """The errors of the machine; those of `symbols` with `covariance` (mm, rad), the others independent as they are.

    All are taken as normal, with the mean and variance of their laws.
    """
    table = error_table(machine)
    law = np.array([one.moments for one in table.laws], dtype=float).reshape(-1, 4)
    whole = np.diag(law[:, 1])
    at = []
    for symbol in symbols:
        if symbol not in table.labels:
            raise Refused("covariance-of-no-error", "covariance", symbol=str(symbol)[:40])
        at.append(table.labels.index(symbol))
    whole[np.ix_(at, at)] = checked_covariance(covariance, len(at))
    columns = table.mixed(omega(machine, table.symbols, where.q))
    return Inputs(table.labels, table.owners, law[:, 0], whole, columns)


def of_fit(machine: Machine, where: Positions) -> Inputs:
    """The parameters of the declared errors as a fit knows them: mean 0, the covariance that the machine's file holds.

    Inputs of one error stand together under its name.  Refuses a machine without the covariance of a fit.
    """
    known = None if machine.fitted is None else machine.fitted.uncertainty
    if known is None:
        raise Refused("correlated-no-fit", machine.name)
    fitted = machine.fitted
    keep = [
        i
        for i, key in enumerate(known.parameters)
        if key[0] == DECLARED and (key[1] in fitted.series or key[1] in fitted.constants)
    ]
    factor = known.matrix()[keep]
    symbols = [known.parameters[i][1] for i in keep]
    columns = omega(machine, symbols, where.q)
    for j, i in enumerate(keep):
        _, symbol, order = known.parameters[i]
        if symbol in fitted.series:
            joint = machine.joint(machine.component(symbol).body)
            place = joint.to_shown(where.q[:, machine.names.index(joint.name)])
            function = legendre(place, order, fitted.series[symbol].domain, start=order)[:, 0]
            columns[:, :, j] *= function[:, None]
    owners = tuple(machine.component(s).body for s in symbols)
    return Inputs(tuple(symbols), owners, np.zeros(len(keep)), factor @ factor.T, columns)


def correlated_study(
    machine: Machine,
    covariance: tuple[Sequence[str], np.ndarray] | None = None,
    progress: Progress | None = None,
) -> CorrelatedResult:
    """Shares of components, blocks and errors.

    covariance : (symbols, matrix in mm and rad) of errors that vary together; None takes that of the machine's fit.
    progress : called with the part done; false cancels.  Refuses a matrix that is no covariance, with a remedy.
    """
    where = workspace.few_positions(machine)
    inputs = of_fit(machine, where) if covariance is None else of_tolerances(machine, *covariance, where)
    tell = progress or (lambda part: True)
    bodies = list(dict.fromkeys(inputs.owners))
    groups = [[i for i, o in enumerate(inputs.owners) if o == b] for b in bodies]
    found = gaussian_shares(inputs.columns, inputs.mean, inputs.covariance, groups)
    mean, variance = float(where.weights @ found.mean), float(where.weights @ found.variance)
    if variance <= 0:
        raise Refused("objective-nothing-varies", "covariance")
    components = _shares(bodies, found, where)
    if not tell(0.3):
        raise Cancelled("cancelled")
    blocks = independent_blocks(inputs.covariance)
    names = [tuple(dict.fromkeys(inputs.labels[i] for i in block)) for block in blocks]
    of_blocks, errors = [], []
    for number, (block, members) in enumerate(zip(blocks, names)):
        share, singles = _block(inputs, block, members, where)
        of_blocks.append((members, share))
        errors += singles
        if not tell(0.3 + 0.7 * (number + 1) / len(blocks)):
            raise Cancelled("cancelled")
    return CorrelatedResult(
        machine,
        components,
        tuple(sorted(of_blocks, key=lambda b: -b[1])),
        tuple(sorted(errors, key=lambda s: -s.share)),
        mean,
        variance,
        covariance is None,
    )


def _shares(names, found, where: Positions) -> tuple[Share, ...]:
    table = [where.weights @ part for part in (found.shares, found.first, found.total)]
    rows = [Share(n, float(s), float(f), float(t)) for n, s, f, t in zip(names, *table)]
    return tuple(sorted(rows, key=lambda s: -s.share))


def independent_blocks(covariance: np.ndarray) -> list[list[int]]:
    """The smallest sets of inputs that are independent of each other; inputs that do not vary belong to none."""
    left = [i for i in range(len(covariance)) if covariance[i, i] > 0]
    blocks = []
    while left:
        block, edge = [], [left[0]]
        while edge:
            i = edge.pop()
            if i in left:
                left.remove(i)
                block.append(i)
                edge += [j for j in left if covariance[i, j] != 0]
        blocks.append(sorted(block))
    return blocks


def _block(inputs: Inputs, block: list[int], members, where: Positions) -> tuple[float, list[Share]]:
    """(share of the block, shares of its errors; none of a block that is too large to be enumerated)."""
    rest = [i for i in range(len(inputs.labels)) if i not in block]
    more = [rest] if rest else []

    of_block = float(where.weights @ _gaussian(inputs, [block, *more]).shares[:, 0])
    if len(members) + len(more) > MOST_GROUPS:
        return of_block, []
    groups = [[i for i in block if inputs.labels[i] == name] for name in members]
    found = _gaussian(inputs, [*groups, *more], len(groups) if rest else None)
    return of_block, list(_shares(members, _first(found, len(members)), where))


def _gaussian(inputs: Inputs, groups, beside: int | None = None):
    return gaussian_shares(inputs.columns, inputs.mean, inputs.covariance, groups, beside=beside)


def _first(found, count: int):
    """The shares of the first `count` groups."""
    return type(found)(
        found.shares[:, :count], found.first[:, :count], found.total[:, :count], found.mean, found.variance
    )


def share_of(shares: Sequence[Share]) -> Mapping[str, float]:
    """name -> share."""
    return {s.name: s.share for s in shares}
