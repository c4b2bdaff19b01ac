# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a plan promises of the declared errors is what fits of simulated readings scatter by."""

from __future__ import annotations

import numpy as np
import pytest

from sensworkbench.closedloop.design import declared_columns, declared_terms, design
from sensworkbench.closedloop.plan import as_readings
from sensworkbench.closedloop.plan_uncertainty import joined, planned_errors
from sensworkbench.closedloop.readings import Readings
from sensworkbench.formats import machine_json
from tests.formats.support import ROOT

VMC = machine_json.load(ROOT / "resources" / "examples" / "vertical_machining_centre.json")
NOISE = 0.5e-3


def places(count: int, seed: int = 1, tools: bool = False) -> Readings:
    rng = np.random.default_rng(seed)
    q = rng.uniform(*VMC.travel.T, (count, 3))
    made = Readings.from_vectors(q, np.zeros((count, 3)), {})
    if tools:
        made = Readings(**{**made.__dict__, "tool_offset": np.eye(3)[rng.integers(0, 3, count)] * -80.0})
    return made


def test_the_stated_uncertainty_is_the_scatter_of_fits():
    plan = as_readings(places(120, tools=True), NOISE)
    found = {e.symbol: e.u for e in planned_errors(VMC, plan)}
    made, declared = design(VMC, plan), declared_terms(VMC)
    functions = declared_columns(VMC, declared, np.linspace(*VMC.travel.T, 21))
    rng, rows = np.random.default_rng(7), plan.rows
    noise = rng.normal(scale=NOISE, size=(rows, 400))
    fitted = np.linalg.lstsq(made.matrix, noise, rcond=1e-10)[0]
    checked = 0
    for symbol in ("EXX", "EYX", "ECX", "EAY", "C0Y", "EZZ"):
        at = [i for i, t in enumerate(declared) if t.symbol == symbol]
        scatter = np.sqrt(np.square(functions[:, at] @ fitted[at]).mean())
        if found[symbol] is not None:
            assert found[symbol] == pytest.approx(scatter, rel=0.12), symbol
            checked += 1
    assert checked >= 5


def test_once_more_halves_the_variance_and_a_tool_shows_what_one_tool_hides():
    one = as_readings(places(100), NOISE)
    found = {e.symbol: e for e in planned_errors(VMC, one)}
    assert "sensor" not in found["EXX"].more
    assert found["EXX"].more["run"] <= found["EXX"].u / np.sqrt(2) * (1 + 1e-6)
    shown = [s for s, e in found.items() if e.u is None and e.more["tool"] is not None]
    lost = [s for s, e in found.items() if e.u is not None and e.more["tool"] is None]
    assert shown and not lost


def test_a_sensor_for_the_directions_that_are_missing_is_judged():
    plan = as_readings(places(100), NOISE, directions=(0,))
    found = {e.symbol: e for e in planned_errors(VMC, plan)}
    assert found["EYX"].u is None and found["EYX"].more["run"] is None and found["EYX"].more["sensor"] is not None


def test_joined_tables_hold_both():
    one, other = places(5), places(7, 2)
    both = joined(one, other)
    assert both.points == 12 and both.rows == one.rows + other.rows and both.point.max() == 11
