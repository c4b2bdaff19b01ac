# SPDX-License-Identifier: LGPL-2.1-or-later
"""The evidence of a column that is constant within each run lies between runs: whole runs are exchanged.

Under the hypothesis that such a column drives nothing, its values could have belonged to any of the runs.  The largest
score over all terms that hold such a column is computed for every exchange (or for a sample of them) in the same way
as for the values as they were; its rank is the p (exchangeability blocks: Winkler et al. 2015; permuted regressors:
Draper and Stoneman 1966).
"""

from __future__ import annotations

import itertools
import math

import numpy as np

from .problem import State
from .scan import Scanner
from .search import ScoredTerm


def constant_in_runs(readings) -> tuple[str, ...]:
    """The columns that vary between runs and never within one."""
    if readings.run is None:
        return ()
    labels = np.array([str(r) for r in readings.run])
    masks = [labels == label for label in sorted(set(labels.tolist()))]
    if len(masks) < 2:
        return ()
    out = []
    for name, v in readings.columns.items():
        size = 1e-9 * max(1.0, float(np.abs(v).max(initial=0.0)))
        if np.ptp(v) > size and all(np.ptp(v[m]) <= size for m in masks):
            out.append(name)
    return tuple(out)


def exchanges(runs: int, count: int, seed: int, all_up_to: int) -> tuple[list[tuple[int, ...]], bool]:
    """(orders of the runs, that of the readings first; whether they are all there are)."""
    identity = tuple(range(runs))
    if math.factorial(runs) <= all_up_to:
        rest = [p for p in itertools.permutations(identity) if p != identity]
        return [identity, *rest], True
    rng = np.random.default_rng(seed + 3)
    return [identity, *(tuple(rng.permutation(runs).tolist()) for _ in range(count))], False


def between_runs(state: State, others, best: ScoredTerm) -> tuple[float, int, bool] | None:
    """(p, number of exchanges, whether all were made) of a term with a column that is constant within runs, or None.

    p is never below one over the number of exchanges, so that two or three runs prove nothing.
    """
    problem = state.problem
    readings = problem.readings
    fixed = constant_in_runs(readings)
    if not set(best.driver.columns) & set(fixed):
        return None
    labels = np.array([str(r) for r in readings.run])
    names, run = np.unique(labels, return_inverse=True)
    first = np.array([int(np.argmax(run == i)) for i in range(len(names))])
    orders, exact = exchanges(len(names), problem.permutations, problem.seed, state.settings.all_exchanges)
    family = [r for r in problem.bank if set(r.driver.columns) & set(fixed) and not r.shape.wave]
    if best.regressor not in family:
        family.append(best.regressor)
    rows = state.scanned(state.rows(state.fit_with(others)))
    wholes = Scanner.wholes(family, readings.columns, problem.middle, problem.thin)
    largest = []
    for order in orders:
        columns = dict(readings.columns)
        for name in fixed:
            columns[name] = columns[name][first][list(order)][run]
        v = Scanner.regressors(family, columns, problem.thin)
        scanner = Scanner(rows, family, problem.component_indices, v, wholes=wholes)
        largest.append(float(scanner.scores().tail.max()))
    beyond = int(np.count_nonzero(np.array(largest) >= largest[0] * (1 - 1e-9)))
    return beyond / len(largest), len(largest), exact
