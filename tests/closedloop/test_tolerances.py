# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names among equals: the machine's tolerances on its declared errors go before the order of names."""

from __future__ import annotations

import json

import numpy as np
import pytest

from sensworkbench.closedloop.readings import Readings
from sensworkbench.closedloop.trace import trace
from sensworkbench.core.distributions import Tolerance
from sensworkbench.formats import machine_json
from tests.simulator import kinematics

from .support import ORIGIN, TRAVEL, scattered

SIGMA = 0.4e-3
TOOL = (60.0, -45.0, -180.0)


def crossed(symbol, driver, size, seed, tolerances=None):
    """(machine, trace) of 200 places: declared errors within the paper's tolerances, and `symbol` by a product."""
    rng = np.random.default_rng(seed)
    simulated = kinematics.Machine("FXYZ", ORIGIN, TRAVEL, TOOL)
    q = scattered(200, seed)
    values = {name: float(rng.uniform(-1, 1)) * 12e-6 for name in kinematics.SQUARENESS}
    for axis in "XYZ":
        u = q[:, "XYZ".index(axis)] / 300
        for motion in "XYZABC":
            limit = 20e-6 if motion in "ABC" else 1e-3 if motion == axis else 5e-3
            orders = [k for k in (1, 2, 3) if k > 1 or motion in "ABC" or motion == axis]
            part = np.zeros(4)
            part[orders] = limit / 2 * rng.normal(size=len(orders)) / np.sqrt(len(orders))
            values[f"E{motion}{axis}"] = np.polynomial.legendre.legval(u, part)
    table = dict(zip("xyz", q.T))
    values[symbol] = values[symbol] + size * np.prod([table[n] / 300 for n in driver.split("*")], axis=0)
    error = kinematics.linear_error(simulated, q, values) + SIGMA * rng.normal(size=q.shape)
    data = simulated.as_dict()
    if tolerances:
        data["tolerances"] = tolerances
    machine = machine_json.loads(json.dumps(data))
    columns = {"t": 10.0 * np.arange(200), "temp_column": np.sin(np.arange(200) / 31.0)}
    return machine, trace(machine, Readings.from_vectors(q, error, columns), seed=1)


def names(result):
    return [(e.effect.component, str(e.effect.driver)) for e in result.effects]


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_crosstalk_is_named_by_what_leaves_the_declared_errors_within_their_tolerances(seed):
    machine, result = crossed("EZZ", "x*z", 6e-3, seed)
    assert names(result) == [("EZZ", "x*z")]
    fitted = result.machine.fitted.series["EBX"]
    assert abs(fitted.coefficients[1]) < 20e-6  # by EBZ it would be 6e-3 / 300 / .06 = 330 urad


def test_the_report_says_that_the_tolerances_decide_and_what_the_rivals_would_need():
    _, result = crossed("EZZ", "x*z", 6e-3, 1)
    [effect] = result.effects
    assert effect.note.code == "finding-by-tolerances"
    far = {(r.component, r.driver): r.why for r in result.effects[0].rivals if r.why.code == "rival-far"}
    why = far["EBZ", "x*z"]
    assert str(why.fields["error"]) == "EXX (order 1)" and why.fields["unit"] == "um"
    assert abs(why.fields["value"]) > 5 * why.fields["limit"] > 5
    assert "EXX (order 1)" in why.text("en") and "Toleranz" in why.text("de")


def test_tolerances_that_every_explanation_breaks_decide_nothing_by_themselves():
    narrow = {
        f"E{m}{k}": {"lower": -1e-3, "upper": 1e-3, "unit": "urad" if m in "ABC" else "um", "distribution": "uniform"}
        for k in "XYZ"
        for m in "XYZABC"
    }
    _, wide = crossed("EZZ", "x*z", 6e-3, 1)
    _, result = crossed("EZZ", "x*z", 6e-3, 1, narrow)
    assert names(result) == names(wide)
    assert isinstance(result.machine.all_tolerances["EXX"], Tolerance)


def test_a_rival_that_the_tolerances_speak_against_adds_nothing_to_the_uncertainty():
    _, result = crossed("EZZ", "x*z", 6e-3, 1)
    u = result.machine.fitted.series["EBX"].u[1]
    assert 0 < u < 5e-6
