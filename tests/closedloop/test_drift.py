# SPDX-License-Identifier: LGPL-2.1-or-later
"""Slow columns beside a drift that nobody logged: on a machine that stands still, and where the set-up wanders."""

from __future__ import annotations

import numpy as np
import pytest

from benchmarks.study_designs import null
from sensworkbench.closedloop.readings import Readings
from sensworkbench.closedloop.trace import trace
from sensworkbench.core.joints import linear
from sensworkbench.core.machine import Machine

COUNT = 600


def standing(seed: int, effect: float, phi: float):
    """Readings along z at one place, every minute: `effect` mm per degree of a column beside noise of memory phi."""
    rng = np.random.default_rng(seed)
    joints = {k: linear(k, tuple(np.eye(3)[i]), (0.0, 0.0, 0.0), (-300.0, 300.0)) for i, k in enumerate("XYZ")}
    t = 60.0 * np.arange(COUNT)
    columns = {"t": t, "temp_a": 4 * np.sin(t / 2100) + 2 * np.sin(t / 730), "temp_b": 3 * (1 - np.exp(-t / 9000))}
    noise = rng.normal(size=COUNT)
    for i in range(1, COUNT):
        noise[i] = phi * noise[i - 1] + np.sqrt(max(1 - phi**2, 1e-3)) * noise[i]
    error = np.full((COUNT, 3), np.nan)
    error[:, 2] = effect * columns["temp_a"] + 1e-3 * noise
    machine = Machine("fixed spindle", ("X",), ("Y", "Z"), joints, (0.0, 0.0, 0.0))
    return machine, Readings.from_vectors(np.zeros((COUNT, 3)), error, columns)


@pytest.mark.parametrize("seed", [1, 2, 3, 4])
@pytest.mark.parametrize("phi", [0.97, 1.0])
def test_a_drift_beside_slow_columns_gets_no_name(seed, phi):
    found = trace(*standing(seed, 0.0, phi), seed=seed)
    assert found.effects == () and found.verdict != "explained"


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_temperature_is_named_beside_a_drift_and_what_is_left_is_said(seed):
    found = trace(*standing(seed, 2e-3, 0.97), seed=seed)
    assert {str(e.effect.driver) for e in found.effects} == {"temp_a"}
    assert found.verdict == "partly_explained"


def shop(seed: int):
    """Four hours over one place: the height follows the room, 23 to 25 degrees; a sensor warms up; memory .97."""
    rng = np.random.default_rng(seed)
    t = 36.0 * np.arange(400)
    room = 3 + 2.2 * (1 - np.exp(-t / 6000)) + 2.5e-3 * np.cumsum(rng.normal(size=len(t)))
    sensor = 10 + 4 * (1 - np.exp(-t / 2500)) + 0.03 * rng.normal(size=len(t))
    noise = rng.normal(size=len(t))
    for i in range(1, len(t)):
        noise[i] = 0.97 * noise[i - 1] + np.sqrt(1 - 0.97**2) * noise[i]
    error = np.full((len(t), 3), np.nan)
    error[:, 2] = -3.5e-3 * room + 0.25e-3 * noise
    joints = {k: linear(k, tuple(np.eye(3)[i]), (0.0, 0.0, 0.0), (-300.0, 300.0)) for i, k in enumerate("XYZ")}
    columns = {"t": t, "temp_room": np.round(room, 2), "temp_sensor": np.round(sensor, 2)}
    machine = Machine("fixed sensor", ("X",), ("Y", "Z"), joints, (0.0, 0.0, 0.0))
    return machine, Readings.from_vectors(np.zeros((len(t), 3)), error, columns)


def test_a_room_far_from_20_degrees_is_named_however_well_time_and_lags_follow():
    named = []
    for seed in (1, 3, 5, 8):
        found = trace(*shop(seed), seed=seed)
        named += [(str(e.effect.driver), e.effect.shape.name) for e in found.effects]
    assert named.count(("temp_room", "linear")) >= 3 and len(named) <= 4


@pytest.mark.parametrize("seed", [200001, 200003])
def test_a_set_up_that_wanders_is_no_temperature(seed):
    """A random walk in each direction that nobody logged, beside columns that walk at random: no name holds."""
    case = null("wandering", seed)
    found = trace(case.machine, case.readings, seed=seed)
    assert not found.effects and found.verdict == "unexplained"
    assert any(r.why.code == "refused-wandering" for r in found.refused)
