# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of fitted errors and the decision rule, against numbers worked by hand."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest

from sensworkbench.core.fitted import Constant, FittedModel, Series, uncertainty_of
from sensworkbench.formats import machine_json
from sensworkbench.studies.error_report import CONFORMS, FAILS, OPEN, UNKNOWN, error_rows
from tests.formats.support import golden


def rows(**changes):
    machine = machine_json.loads(json.dumps(golden()))
    travel = machine.axes["X"].travel
    parameters = [("declared", "EYX", 2), ("declared", "EYX", 3), ("declared", "C0Y", 0)]
    fields = {
        "series": {"EYX": Series(travel, (0.0, 0.0, 2e-3, 1e-3), (0.0, 0.0, 0.3e-3, 0.4e-3))},
        "constants": {"C0Y": Constant(30e-6, 1e-6)},
        "uncertainty": uncertainty_of(parameters, np.diag([0.3e-3, 0.4e-3, 1e-6])),
    } | changes  # fmt: skip
    return {r.symbol: r for r in error_rows(replace(machine, fitted=FittedModel(**fields)))}


def test_the_largest_value_has_the_uncertainty_of_its_place():
    """At the end of the travel P2 = P3 = 1: 3 um, u = hypot(0.3, 0.4) = 0.5 um; limits of +-5 um: conforms."""
    row = rows()["EYX"]
    place, value, u = row.largest
    assert (value, u) == (pytest.approx(3e-3), pytest.approx(0.5e-3)) and place == row.place[-1]
    assert row.decision == CONFORMS


@pytest.mark.parametrize(
    ("value", "u", "decision"),
    [(30e-6, 1e-6, FAILS), (21e-6, 1e-6, OPEN), (19e-6, 1e-6, OPEN), (17.9e-6, 1e-6, CONFORMS), (22.1e-6, 1e-6, FAILS)],
)
def test_a_guard_band_of_two_u_decides(value, u, decision):
    """C0Y within +-20 urad: inside by U = 2 urad conforms, outside by as much does not, in between nothing is said."""
    assert rows(constants={"C0Y": Constant(value, u)})["C0Y"].decision == decision


def test_what_is_not_determined_is_not_decided():
    found = rows(constants={"C0Y": Constant(1e-6, None)})
    assert found["C0Y"].decision == UNKNOWN
    assert error_rows(machine_json.loads(json.dumps(golden()))) == []
