# SPDX-License-Identifier: LGPL-2.1-or-later
"""Traces of noise that is not ideal: it remembers, is uneven, drifts, or the set-up differs from run to run."""

from __future__ import annotations

import numpy as np
import pytest

from sensworkbench.closedloop.declared import aligned
from sensworkbench.closedloop.exchange import constant_in_runs, exchanges
from sensworkbench.closedloop.readings import Readings
from sensworkbench.closedloop.settings import DEFAULT, TraceSettings
from sensworkbench.closedloop.trace import trace
from sensworkbench.core.refusal import Refused
from tests.simulator import kinematics

from .support import both, declared_values, grid, measured, scattered, session

NOISE = 0.4e-3
COUNT = 180


def autoregressive(rng, count: int, phi: float) -> np.ndarray:
    noise = rng.normal(size=(count, 3))
    for i in range(1, count):
        noise[i] = phi * noise[i - 1] + np.sqrt(1 - phi**2) * noise[i]
    return noise


def traced(q, noise, seed, effect=None, **more):
    """The trace of a machine whose declared errors are all there is, but for `effect`, beside this noise (units: 1)."""
    simulated, machine = both("XYFZ", (10, -20, -150))
    values = declared_values(simulated, q, seed)
    columns = session(len(q), seed)
    for name, v in (effect(columns) if effect else {}).items():
        values[name] = values[name] + v
    error = kinematics.exact_error(simulated, q, values, 0.0) + NOISE * noise
    return trace(machine, Readings.from_vectors(q, error, columns, **more), seed=seed)


def test_noise_that_remembers_is_no_structure():
    found = [
        traced(grid(6)[:COUNT], autoregressive(np.random.default_rng(seed), COUNT, 0.6), seed) for seed in (1, 2, 3, 4)
    ]
    assert all(f.effects == () for f in found)
    assert (
        sum(f.verdict == "nothing_to_explain" for f in found) >= 2
    )  # not all: what an estimated memory leaves can still look like structure
    assert all(max(f.noise.modelled.values()) > 0.3 for f in found)
    assert all("noise-remembers" in {m.code for m in f.noise.remarks} for f in found)


def test_a_product_is_named_beside_noise_that_remembers():
    q = scattered(COUNT, 3)
    noise = autoregressive(np.random.default_rng(3), COUNT, 0.5)
    found = traced(q, noise, 3, lambda c: {"EAZ": 3e-8 * c["temp_column"] * q[:, 1]})
    assert found.verdict == "explained"
    assert [(e.effect.component, str(e.effect.driver)) for e in found.effects] == [("EAZ", "temp_column*y")]


@pytest.mark.parametrize("seed", [1, 2])
def test_uneven_noise_is_no_motion_of_a_body(seed):
    q = scattered(COUNT, seed)
    noise = np.random.default_rng(seed).normal(size=(COUNT, 3)) * (1 + 2 * (q[:, [0]] + 300) / 600)
    found = traced(q, noise, seed)
    assert (found.verdict, found.effects, found.hidden) == ("nothing_to_explain", (), None)


def test_a_drift_in_one_direction_that_nobody_logged_is_not_nothing():
    rng = np.random.default_rng(2)
    noise = rng.normal(size=(COUNT, 3))
    drift = np.cumsum(rng.normal(size=COUNT))
    noise[:, 2] += 15 * (drift - drift.mean()) / drift.std()
    found = traced(scattered(COUNT, 2), noise, 2)
    assert found.verdict in ("unexplained", "partly_explained")
    if found.verdict == "unexplained":
        assert "left-drift" in {m.code for m in found.left.words}


# -- runs --------------------------------------------------------------------------------------------------------------
def meshes(runs: int, bow: bool, seed: int = 1):
    """Bed meshes of a printer that levels itself before each: an offset, a tilt and one temperature per mesh."""
    rng = np.random.default_rng([seed, 5])
    _, machine = both("XYFZ", (0, 0, 0), travel={k: (0.0, 350.0) for k in "XYZ"})
    line = np.linspace(20, 330, 11)
    one = np.array([(x, y, 0.0) for y in line for x in line])
    q = np.tile(one, (runs, 1))
    run, temperature = (np.repeat(v, len(one)) for v in (np.arange(1, runs + 1), np.linspace(-1, 30, runs)))
    u, v = ((q[:, i] - 175) / 175 for i in (0, 1))
    set_up = rng.normal(size=(runs, 3))[run - 1] * [0.05, 0.03, 0.03]
    height = 0.012 * u**2 + set_up[:, 0] + set_up[:, 1] * u + set_up[:, 2] * v + 5e-3 * rng.normal(size=len(q))
    if bow:
        height -= 1.8e-3 * temperature * u**2
    error = np.full((len(q), 3), np.nan)
    error[:, 2] = height
    return machine, Readings.from_vectors(q, error, {"temp_frame": temperature}, run=run)


def test_what_is_constant_within_runs_is_proved_between_them():
    machine, readings = meshes(7, bow=True)
    found = trace(machine, readings, seed=1)
    assert found.alignment == "per run" and found.verdict == "explained"
    [named] = found.effects
    listed = {(named.effect.component, str(named.effect.driver))} | {(r.component, r.driver) for r in named.rivals}
    assert ("EZX", "temp_frame*x*x") in listed
    assert ("runs", 200, False) in found.guarantee.by
    tilts = found.machine.fitted.runs["2"]
    assert set(tilts) == {"EXW", "EYW", "EZW", "EAW", "EBW", "ECW"} and tilts["EAW"].value != 0


@pytest.mark.parametrize("runs", [2, 3])
def test_two_or_three_runs_name_nothing(runs):
    machine, readings = meshes(runs, bow=True)
    found = trace(machine, readings, seed=1)
    assert found.effects == () and found.verdict != "explained"


def test_meshes_that_differ_in_their_set_up_only_hold_nothing():
    machine, readings = meshes(7, bow=False)
    assert trace(machine, readings, seed=1).verdict == "nothing_to_explain"


def test_the_alignment_is_as_stated_or_as_the_runs_show():
    from dataclasses import replace

    machine, readings = meshes(3, bow=False)
    assert aligned(machine, readings).alignment == "per run"
    for stated in ("once", "offset per run", "per run"):
        assert aligned(machine, replace(readings, alignment=stated)).alignment == stated
    assert aligned(machine, replace(readings, run=None)).alignment == "once"
    with pytest.raises(Refused) as refused:
        aligned(machine, replace(readings, run=None, alignment="per run"))
    assert refused.value.code == "alignment-without-runs"


def test_exchanges_of_few_runs_are_all_made():
    orders, exact = exchanges(4, 199, 0, DEFAULT.all_exchanges)
    assert exact and len(set(orders)) == 24 and orders[0] == (0, 1, 2, 3)
    orders, exact = exchanges(9, 199, 0, DEFAULT.all_exchanges)
    assert not exact and len(orders) == 200 and orders[0] == tuple(range(9))


def test_columns_that_vary_between_runs_only_are_found():
    _, readings = meshes(3, bow=False)
    assert constant_in_runs(readings) == ("temp_frame",)


def test_every_setting_has_a_unit_and_a_reason():
    table = TraceSettings.table()
    assert len(table) == len({name for name, *_ in table}) > 30
    assert all(unit and reason and getattr(DEFAULT, name) == value for name, value, unit, reason in table)


# -- readings without noise --------------------------------------------------------------------------------------------
def exact(extra=None, count=150, seed=5):
    """(machine, readings) of the linear model without noise; extra : symbol -> function of the columns, mm or rad."""
    simulated, machine = both()
    q, columns = scattered(count, seed), session(count, 1)
    values = declared_values(simulated, q, 2)
    for symbol, motion in (extra or {}).items():
        values[symbol] = values.get(symbol, 0.0) + motion(columns)
    return machine, Readings.from_vectors(q, kinematics.linear_error(simulated, q, values), columns)


def test_readings_that_the_declared_model_gives_exactly_hold_nothing_to_explain():
    assert trace(*exact()).verdict == "nothing_to_explain"


def test_products_of_errors_in_readings_without_noise_are_no_structure():
    simulated, machine = both()
    readings = measured(simulated, scattered(80, 3), columns=session(80, 1), noise=0.0, seed=2)
    assert trace(machine, readings).verdict == "nothing_to_explain"


@pytest.mark.parametrize("columns", [session(50, 1), None], ids=["logged", "bare"])
def test_one_place_read_fifty_times_alike_holds_nothing_to_explain(columns):
    _, machine = both()
    readings = Readings.from_vectors(np.tile([[100.0, 50.0, -20.0]], (50, 1)), np.full((50, 3), 5e-3), columns)
    result = trace(machine, readings)
    assert (result.verdict, result.noise.remarks) == ("nothing_to_explain", ())


def test_an_exact_effect_without_noise_is_named():
    result = trace(*exact({"EAX": lambda c: 8e-6 * c["temp_column"]}))
    assert result.verdict == "explained"
    assert [(e.effect.component, str(e.effect.driver)) for e in result.effects] == [("EAX", "temp_column")]
    [coefficient] = result.effects[0].effect.coefficients
    assert coefficient == pytest.approx(8e-6, rel=1e-6)


def test_a_sine_on_one_axis_alone_is_named_on_the_body_that_moves():
    _, machine = both()
    x = 5.0 * np.arange(80) - 200
    error = np.full((80, 3), np.nan)
    error[:, 0] = np.round(np.sin(np.arange(80)), 6) * 1e-3
    result = trace(machine, Readings.from_vectors(np.stack([x, 0 * x, 0 * x - 200], axis=1), error))
    assert [(e.effect.component, e.effect.shape.name) for e in result.effects] == [("EXX", "periodic")]
