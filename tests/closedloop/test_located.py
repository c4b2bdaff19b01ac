# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is located is modelled, named or not; the error of a screw is one line, whatever else its axis does."""

from __future__ import annotations

import json

import numpy as np
import pytest

from sensworkbench.closedloop.predict import predict
from sensworkbench.closedloop.readings import Readings
from sensworkbench.closedloop.trace import trace
from sensworkbench.formats import machine_json
from tests.closedloop.support import from_case, rms_um
from tests.simulator import make_case


def stage(error, q, columns, declared: dict, length: float = 300.0):
    """A machine of three axes, of which only `declared` errors are declared, and its readings (P, 3) mm."""
    symbols = [f"E{a}{b}" for a in "XYZABC" for b in "XYZ"] + ["C0Y", "B0Z", "A0Z"]
    content = {
        "format": "sens-machine",
        "version": 1,
        "name": "stage",
        "workpiece_chain": [],
        "tool_chain": ["X", "Y", "Z"],
        "axes": {
            k: {"direction": list(d), "reference": [0, 0, 0], "travel": [0, length]}
            for k, d in zip("XYZ", np.eye(3).tolist())
        },
        "tool_point": [0, 0, 0],
        "declared": {s: {"shape": "none"} for s in symbols} | declared,
    }
    return machine_json.loads(json.dumps(content)), Readings.from_vectors(q, error, columns)


def pitch(seed: int, degree: int):
    """A pitch table along x: long waves, and a screw whose error of `period` mm grows and shifts along the travel."""
    rng = np.random.default_rng(seed)
    x = np.arange(0.0, 360.0, 1.6)
    period = float(rng.uniform(4.5, 9.0))
    height = 1.3e-3 * (1 + 0.6 * x / 360)
    error = height * np.sin(2 * np.pi * x / period + 1.5 * x / 360)
    for n in (1, 2):
        error = error + 5e-3 / n * np.sin(2 * np.pi * n * x / 360 + rng.uniform(0, 6))
    error = error + 0.35e-3 * rng.normal(size=len(x)) + 2e-4 * x
    full = np.full((len(x), 3), np.nan)
    full[:, 0] = error
    q = np.column_stack([x, 0 * x, 0 * x])
    return (*stage(full, q, {"x": x}, {"EXX": {"shape": "polynomial", "degree": degree}}, 360.0), period)


@pytest.mark.parametrize("degree", [3, 12])
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_screw_is_one_line_beside_long_waves(seed, degree):
    machine, readings, period = pitch(seed, degree)
    found = trace(machine, readings, seed=seed)
    assert [(e.effect.component, str(e.effect.driver), e.effect.shape.name) for e in found.effects] == [
        ("EXX", "x", "periodic")
    ]
    assert found.effects[0].effect.shape.values["period"] == pytest.approx(period, rel=1.5 * period / 360)
    assert found.verdict != "unexplained"
    assert found.error["augmented"].in_sample["rms_um"] < 0.8


def warm_up(seed: int):
    """Height over one place: a fast climb in the first minutes, a slow one with the frame; noise of memory .9."""
    rng = np.random.default_rng(seed)
    t = 30.0 * np.arange(480)
    frame = 5 + 9 * (1 - np.exp(-t / 4500)) + 0.05 * rng.normal(size=len(t))
    bed = 10 + 50 * (1 - np.exp(-t / 240)) + 0.3 * rng.normal(size=len(t))
    noise = rng.normal(size=len(t))
    for i in range(1, len(t)):
        noise[i] = 0.9 * noise[i - 1] + np.sqrt(1 - 0.9**2) * noise[i]
    climb = 70e-3 * (1 - np.exp(-t / 330)) * (1 + 0.3 * np.exp(-t / 900)) + 1.1e-3 * (frame - 5)
    full = np.full((len(t), 3), np.nan)
    full[:, 2] = climb + 1.5e-3 * noise
    columns = {"t": t, "temp_frame": frame, "temp_bed": bed}
    declared = {f"E{a}{b}": {"shape": "polynomial", "degree": 3} for a in "XYZABC" for b in "XYZ"}
    return stage(full, np.zeros((len(t), 3)), columns, declared)


def test_a_climb_of_some_minutes_is_modelled_beside_correlated_noise():
    """Most of the climb lies in the first block of readings, so that leaving it out may leave too little of it."""
    modelled = 0
    for seed in (1, 2, 3, 4):
        found = trace(*warm_up(seed), seed=seed)
        before, after = (found.error[k] for k in ("declared", "augmented"))
        assert not found.outliers
        assert after.held_out["rms_um"] <= 1.001 * before.held_out["rms_um"]
        modelled += after.in_sample["rms_um"] < 0.35 * before.in_sample["rms_um"]
    assert modelled >= 3


def wanders(seed: int):
    """Height over one place that goes on rising until the end, with a room that has nothing to do with it."""
    rng = np.random.default_rng(seed)
    t = 60.0 * np.arange(400)
    full = np.full((len(t), 3), np.nan)
    full[:, 2] = 20e-3 * t / t[-1] * (1 + 0.3 * np.sin(t / 3000)) + 0.4e-3 * rng.normal(size=len(t))
    columns = {"t": t, "temp_room": 20 + 0.02 * np.cumsum(rng.normal(size=len(t)))}
    declared = {f"E{a}{b}": {"shape": "polynomial", "degree": 3} for a in "XYZABC" for b in "XYZ"}
    return stage(full, np.zeros((len(t), 3)), columns, declared)


@pytest.mark.parametrize("seed", (1, 2, 3))
def test_a_drift_that_goes_on_is_told_and_not_held_beyond_its_end(seed):
    """A form of time would follow it to .4 um, and be wrong by all of it for the next session."""
    found = trace(*wanders(seed), seed=seed)
    assert found.verdict == "unexplained" and not found.effects
    assert found.error["augmented"].in_sample["rms_um"] == found.error["declared"].in_sample["rms_um"]


@pytest.mark.parametrize(("kind", "seed"), [("saturating", 3), ("delayed", 8)])
def test_a_shape_that_no_catalogue_holds_is_modelled_where_it_is_located(kind, seed):
    """Slow columns that are nearly alike, and a structure as slow as noise of long memory."""
    case = make_case(seed, kind, 1, plan="grid", count=230, extras=False, with_rivals=False)
    machine, readings, positions = from_case(case)
    found = trace(machine, readings, seed=seed)
    error, plain = (
        rms_um(predict(found.machine, positions, effects=effects) - case.fresh_truth / 1e3) for effects in (True, False)
    )
    assert error < 0.35 * plain
