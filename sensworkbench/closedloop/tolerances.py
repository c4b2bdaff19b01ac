# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the machine's tolerances say of an explanation: how far the declared errors beside it lie outside them.

The tolerances are the prior of the declared errors.  Explanations that the readings cannot distinguish differ in the
declared errors that they need.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..messages import Message
from .design import Term
from .fit import Fit
from .problem import State
from .search import ScoredTerm
from .uncertainty import expected

WEAK = 1e4  # times their deviations: tolerances that decide only what the readings leave open


@dataclass(frozen=True)
class Plausible:
    """How the tolerances see explanations of the same readings, the first of which is the effect.

    terms (n) of the declared model.  value (K, n): the errors beside each, mm or rad.  score (K, n): the same less the
    means of the tolerances, over their standard deviations `deviation` (n,); 0 for the alignment.  cost (K,): by which
    chi-square plus the sum of squared scores is larger, at its minimum, than the smallest chi-square alone.
    """

    terms: tuple[Term, ...]
    value: np.ndarray
    score: np.ndarray
    deviation: np.ndarray
    cost: np.ndarray

    def far(self, k: int, why: Message) -> Message:
        """The reason `why` of explanation k, with the error that lies farther outside than beside the effect."""
        i = int(np.argmax(self.score[k] ** 2 - self.score[0] ** 2))
        scale, unit = (1e6, "urad") if self.terms[i].angular else (1e3, "um")
        value, limit = float(self.value[k, i]) * scale, 2 * float(self.deviation[i]) * scale
        return Message("rival-far", why=why, error=self.terms[i].title, value=value, limit=limit, unit=unit)


def plausible(state: State, full: Fit, others, finding: ScoredTerm, candidates) -> Plausible:
    """How the tolerances see `finding` and the candidates that explain the same; full : the fit of others and finding.

    An error that lies outside its tolerance by every explanation counts against none: its deviation is then the
    smallest of its values.
    """
    problem, terms = state.problem, full.design.terms
    n = len(terms)
    mean, deviation = expected(problem.machine, full.design)
    declared = np.array([t.group == "declared" for t in terms])
    base = full.white(full.design.matrix)
    known = problem.columns_of(others)
    sizes = [0 if known is None else known.shape[1], *(c.shape.size for c in (finding, *candidates))]
    parts = [] if known is None else [known]
    more = full.white(np.concatenate([*parts, problem.columns_of([finding, *candidates])], axis=1))
    at = n + np.cumsum(sizes)
    blocks = [list(range(a, b)) for a, b in zip(at[:-1], at[1:])]
    first = n + sizes[0]
    left = full.white(full.residual)  # with the effect in it, about the errors as they were fitted
    left = left + more[:, sizes[0] : sizes[0] + sizes[1]] @ full.coefficients[first : first + sizes[1]]
    across = base.T @ more
    gram = np.block([[base.T @ base, across], [across.T, more.T @ more]])
    right = np.concatenate([base.T @ left, more.T @ left])
    alike = state.inflation(full, finding, margin=0.0)
    gram, right = gram / alike, right / alike
    start = full.coefficients[:n] - mean

    def beside(columns, spread) -> tuple[np.ndarray, float]:
        """((n,) the errors less their means, the smallest chi-square with the tolerances' sum, but for a constant)."""
        use = [*range(first), *columns]
        a, b = gram[np.ix_(use, use)].copy(), right[use].copy()
        a[range(n), range(n)] += 1 / spread**2
        b[:n] -= start / spread**2
        size = np.sqrt(np.maximum(np.diag(a), 1e-300))
        step = np.linalg.lstsq(a / np.outer(size, size), b / size, rcond=1e-14)[0] / size
        return start + step[:n], float(((start / spread) ** 2).sum() - b @ step)

    loose = [beside(columns, deviation * WEAK) for columns in blocks]
    least = np.abs([errors for errors, _ in loose]).min(axis=0)
    wide = np.where(declared, np.maximum(deviation, least), deviation * WEAK)
    found = [beside(columns, wide) for columns in blocks]
    errors = np.array([e for e, _ in found])
    cost = np.array([tight - free for (_, tight), (_, free) in zip(found, loose)])
    return Plausible(tuple(terms), errors + mean, np.where(declared, errors / wide, 0.0), wide, cost)
