# SPDX-License-Identifier: LGPL-2.1-or-later
"""Simulated cases, each traced once in a session however many tests ask."""

from __future__ import annotations

import pytest

from sensworkbench.closedloop.predict import predict
from sensworkbench.closedloop.trace import trace
from tests.simulator import make_case

from .support import from_case


@pytest.fixture(scope="session")
def simulated():
    """simulated(seed, kind, level, structure, plan, count) -> (outcome of the trace, prediction (P, 3) mm, case)."""
    kept = {}

    def traced(seed, kind, level, structure, plan, count):
        key = (seed, kind, level, structure, plan, count)
        if key not in kept:
            case = make_case(seed, kind, level, structure, plan, count=count, extras=False)
            machine, readings, positions = from_case(case)
            outcome = trace(machine, readings, seed=seed)
            kept[key] = outcome, predict(outcome.machine, positions), case
        return kept[key]

    return traced
