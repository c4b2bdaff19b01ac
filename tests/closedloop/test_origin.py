# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nothing depends on the origin, of effects without a place in their driver, nor on the names of runs."""

from __future__ import annotations

import json
from dataclasses import replace
from functools import lru_cache

import numpy as np
import pytest

from sensworkbench.closedloop.readings import Readings
from sensworkbench.closedloop.trace import trace
from sensworkbench.formats import machine_json
from tests.simulator import kinematics

from .support import APART, TRAVEL, declared_values, scattered, session

COUNT = 160
TOOL = (60.0, -45.0, -180.0)
CASES = {
    "bend": ("EAX", lambda c: 6e-6 * c["temp_column"]),
    "backlash": ("EYY", lambda c: 1e-3 * c["dir_y"]),
    "none": (None, None),
}


def moved_machine(shift):
    """FXYZ, every coordinate `shift` (3,) mm larger; bodies and tool are where they were."""
    data = kinematics.Machine("FXYZ", APART, TRAVEL, TOOL).as_dict()
    passed = np.array(shift, dtype=float)
    for i, axis in enumerate("XYZ"):
        passed[i] = 0.0  # the place of an axis counts for the references of the bodies that it carries
        entry = data["axes"][axis]
        entry["reference"] = (np.array(entry["reference"]) + passed).tolist()
        entry["travel"] = (np.array(entry["travel"]) + shift[i]).tolist()
    data["workpiece_reference"] = list(shift)
    return machine_json.loads(json.dumps(data))


@lru_cache(None)
def traced(case: str, shift: tuple[float, float, float]):
    simulated = kinematics.Machine("FXYZ", APART, TRAVEL, TOOL)
    q = scattered(COUNT, 7)
    columns = session(COUNT, 3)
    columns["dir_y"] = np.random.default_rng(9).choice([-1.0, 1.0], COUNT)
    values = declared_values(simulated, q, 4)
    symbol, motion = CASES[case]
    if symbol:
        values[symbol] = values[symbol] + motion(columns | dict(zip("xyz", q.T)))
    noise = 0.4e-3 * np.random.default_rng(11).normal(size=q.shape)
    error = kinematics.linear_error(simulated, q, values) + noise
    readings = Readings.from_vectors(q + np.array(shift), error, columns)
    return trace(moved_machine(shift), readings, seed=1)


def said(result):
    names = [(e.effect.component, str(e.effect.driver), e.effect.shape.name, e.p) for e in result.effects]
    return result.verdict, names, [(r.component, r.driver, r.p) for r in result.refused]


@pytest.mark.parametrize("shift", [(100.0, -100.0, 100.0), (10_000.0, 10_000.0, -10_000.0)], ids=["100 mm", "10 m"])
@pytest.mark.parametrize("case", CASES)
def test_moving_the_coordinates_with_the_machine_changes_no_verdict_name_or_p(case, shift):
    assert said(traced(case, shift)) == said(traced(case, (0.0, 0.0, 0.0)))


def test_the_names_of_the_runs_change_nothing():
    simulated = kinematics.Machine("FXYZ", APART, TRAVEL, TOOL)
    q = scattered(COUNT, 7)
    values = declared_values(simulated, q, 4)
    columns = session(COUNT, 3)
    values["EAX"] = values["EAX"] + 6e-6 * columns["temp_column"]
    noise = 0.4e-3 * np.random.default_rng(11).normal(size=q.shape)
    plain = Readings.from_vectors(q, kinematics.linear_error(simulated, q, values) + noise, columns)
    machine = moved_machine((0.0, 0.0, 0.0))
    number = np.arange(COUNT) * 4 // COUNT
    found = [
        said(trace(machine, replace(plain, run=np.array(labels)[number]), seed=1))
        for labels in (["1", "2", "3", "4"], ["d", "a", "c", "b"])
    ]
    assert found[0] == found[1]
