# SPDX-License-Identifier: LGPL-2.1-or-later
"""The declared fit: unbiased with honest uncertainties, robust to gross outliers, fair to rows an effect explains."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy import stats

from sensworkbench.closedloop.declared import aligned
from sensworkbench.closedloop.design import ALL_SYMBOLS, design
from sensworkbench.closedloop.fit import correlation, fit
from sensworkbench.closedloop.noise import memory_of
from sensworkbench.closedloop.readings import Readings
from sensworkbench.closedloop.settings import DEFAULT
from sensworkbench.closedloop.trace import trace

from .support import both, least_squares, measured, scattered, session

NOISE = 0.4e-3  # mm
TOOLS = np.array([(0.0, 0.0, 0.0), (80.0, 0.0, -60.0), (0.0, 80.0, -120.0)])


def noisy(count=300, seed=0, **more):
    simulated, machine = both("XYFZ", (10, -20, -150))
    return machine, measured(simulated, scattered(count, seed), noise=NOISE, seed=seed, **more)


def spoiled(readings: Readings, seed: int, share: float = 0.02) -> tuple[Readings, np.ndarray]:
    """Readings with gross errors of 10 to 40 sigma on some rows."""
    rng = np.random.default_rng(seed)
    rows = rng.random(readings.rows) < share
    gross = NOISE * rng.uniform(10, 40, readings.rows) * rng.choice([-1.0, 1.0], readings.rows)
    return replace(readings, value=readings.value + rows * gross), rows


def test_the_fit_is_the_weighted_least_squares_solution_where_there_are_no_outliers():
    machine, readings = noisy(u=NOISE)
    found = fit(design(machine, readings), readings)
    assert not found.outliers.any()
    _, left = least_squares(found.design.matrix * found.weight[:, None], readings.value * found.weight)
    assert found.chi2 == pytest.approx(left, rel=1e-9)
    assert found.chi2 == pytest.approx(found.dof, rel=1e-6)  # the noise is scaled to what is left


def test_parameters_scatter_about_the_truth_as_their_covariance_says():
    simulated, machine = both("XYFZ", (10, -20, -150))
    q = np.concatenate([scattered(60, 1)] * 3)
    tool = np.repeat(TOOLS, 60, axis=0)
    clean = measured(simulated, q, seed=1, tool=tool)
    model = design(machine, clean)
    truth, left = least_squares(model.matrix, clean.value)
    assert np.sqrt(left / clean.rows) < 20e-6  # the first-order model holds the exact product
    scores = []
    for seed in range(12):
        noise = NOISE * np.random.default_rng(seed).normal(size=clean.rows)
        found = fit(model, replace(clean, value=clean.value + noise))
        assert found.determined.all()
        scores.append((found.coefficients - truth) / np.sqrt(np.diag(found.covariance)))
    scores = np.concatenate(scores)
    assert np.mean(scores) == pytest.approx(0, abs=0.15)
    assert np.std(scores) == pytest.approx(1, rel=0.12)
    assert np.abs(scores).max() < 5


def test_noise_is_estimated_for_each_direction_of_sensing():
    machine, readings = noisy(600)
    rng = np.random.default_rng(9)
    sigma = np.array([0.2e-3, 0.5e-3, 1.5e-3])
    simulated, _ = both("XYFZ", (10, -20, -150))
    clean = measured(simulated, readings.q)
    found = fit(design(machine, clean), replace(clean, value=clean.value + sigma[clean.kind] * rng.normal(size=1800)))
    assert [found.noise[k] for k in range(3)] == pytest.approx(sigma, rel=0.1)


def test_a_stated_uncertainty_that_is_wrong_is_noticed_and_scaled():
    machine, readings = noisy(400)
    for factor in (0.4, 1.0, 2.5):
        found = fit(design(machine, readings), replace(readings, u=np.full(readings.rows, factor * NOISE)))
        assert np.mean(list(found.noise.values())) == pytest.approx(NOISE, rel=0.06)


def test_readings_that_state_less_noise_weigh_more():
    machine, readings = noisy(400)
    u = np.where(np.arange(400) % 2, 0.1e-3, 1.0e-3)
    simulated, _ = both("XYFZ", (10, -20, -150))
    clean = measured(simulated, readings.q)
    rng = np.random.default_rng(3)
    stated = replace(clean, u=u[clean.point], value=clean.value + u[clean.point] * rng.normal(size=clean.rows))
    found = fit(design(machine, stated), stated)
    ratio = found.sigma[clean.point % 2 == 0].mean() / found.sigma[clean.point % 2 == 1].mean()
    assert ratio == pytest.approx(10, rel=1e-6)
    shift = found.design.matrix @ found.coefficients - clean.value
    unweighted = fit(found.design, replace(stated, u=np.full(clean.rows, np.nan)))
    loose = found.design.matrix @ unweighted.coefficients - clean.value
    assert np.sqrt((shift**2).mean()) < 0.5 * np.sqrt((loose**2).mean())


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_gross_outliers_are_found_and_hardly_anything_else(seed):
    machine, readings = noisy(300, seed)
    bad, rows = spoiled(readings, seed)
    found = fit(design(machine, bad), bad)
    assert rows.sum() >= 10
    assert found.outliers[rows].all()
    assert (found.outliers & ~rows).sum() <= 1
    assert not found.weight[found.outliers].any()
    clean = fit(found.design, readings)
    assert np.sqrt(((found.residual - clean.residual)[~rows] ** 2).mean()) < 0.1 * NOISE
    assert np.mean(list(found.noise.values())) == pytest.approx(NOISE, rel=0.08)


def test_rows_that_an_effect_explains_are_admitted_again():
    simulated, machine = both("XYFZ", (10, -20, -150))
    q = scattered(300, 5)
    hit = np.zeros(300)
    hit[::40] = 1.0  # a load that stands on the table for eight readings
    readings = measured(simulated, q, {"EZX": 30 * NOISE * hit}, {"load_table": hit}, NOISE, seed=5)
    before = fit(design(machine, readings), readings)
    lifted = (readings.kind == 2) & (hit[readings.point] > 0)
    assert before.outliers[lifted].all()
    column = before.design.lever[:, [ALL_SYMBOLS.index("EZX")]] * hit[readings.point, None]
    after = fit(before.design, readings, column, before)
    assert not after.outliers[lifted].any()
    assert after.coefficients[-1] == pytest.approx(30 * NOISE, abs=4 * np.sqrt(after.covariance[-1, -1]))
    assert after.extra == 1


def test_what_crowds_is_structure_and_stays():
    machine, readings = noisy(400)
    shift = np.where((readings.point < 80) & (readings.kind == 0), 10 * NOISE, 0.0)  # the first fifth stood elsewhere
    found = fit(design(machine, readings), replace(readings, value=readings.value + shift))
    assert not found.outliers.any()
    both_, rows = spoiled(replace(readings, value=readings.value + shift), 3, 0.004)
    rows &= np.abs(both_.value - readings.value - shift) > 30 * NOISE  # the grossest still show
    found = fit(design(machine, both_), both_)
    assert rows.sum() >= 2 and found.outliers[rows].all() and found.outliers.sum() < 10


def test_outliers_stay_out_when_an_effect_joins_that_does_not_explain_them():
    machine, readings = noisy(300, 6, columns=session(300, 6))
    bad, rows = spoiled(readings, 6)
    model = design(machine, bad)
    column = model.lever[:, [ALL_SYMBOLS.index("EAZ")]] * readings.columns["temp_column"][readings.point, None]
    assert fit(model, bad, column).outliers[rows].all()


def test_runs_and_tools_have_offsets_of_their_own():
    simulated, machine = both("XYFZ", (10, -20, -150))
    q = scattered(360, 7)
    run, tool = np.arange(360) // 120 + 1, TOOLS[np.arange(360) % 3]
    jump = {1: np.zeros(3), 2: np.array([5e-3, -2e-3, 1e-3]), 3: np.array([-4e-3, 3e-3, 6e-3])}
    readings = measured(simulated, q, noise=NOISE, seed=7, tool=tool, run=run)
    moved = np.stack([jump[int(r)] for r in run])
    wrong_length = np.where((np.arange(360) % 3 == 2)[:, None], [1e-3, 2e-3, -3e-3], 0.0)
    readings = replace(readings, value=readings.value + (moved + wrong_length).ravel())
    found = fit(design(machine, readings), readings)
    assert np.mean(list(found.noise.values())) == pytest.approx(NOISE, rel=0.06)
    u = np.sqrt(np.diag(found.covariance))
    for i, term in enumerate(found.design.terms):
        if term.group == "run":
            assert found.determined[i]
            assert found.coefficients[i] == pytest.approx(jump[int(term.symbol)][term.order], abs=4 * u[i])
    assert sum(t.group == "run" for t in found.design.terms) == sum(t.group == "tool" for t in found.design.terms) == 6


def test_readings_along_a_direction_fit_the_same_machine_as_vectors():
    simulated, machine = both("XYFZ", (10, -20, -150))
    vectors = measured(simulated, scattered(200, 8), noise=NOISE, seed=8, u=NOISE)
    turned = np.linalg.qr(np.random.default_rng(8).normal(size=(200, 3, 3)))[0]  # three directions at each point
    along = np.einsum("pkc,pc->pk", turned, vectors.value.reshape(-1, 3)).ravel()
    rows = replace(vectors, sense=turned.reshape(-1, 3), value=along, kind=np.full(600, 3))
    one, other = (fit(design(machine, r), r) for r in (vectors, replace(vectors, kind=np.full(600, 3))))
    laser = fit(design(machine, rows), rows)
    assert laser.chi2 == pytest.approx(other.chi2, rel=1e-8)
    assert laser.coefficients[laser.determined] == pytest.approx(other.coefficients[other.determined], abs=1e-9)
    assert np.array_equal(laser.determined, one.determined)


def test_one_reading_a_point_is_enough():
    simulated, machine = both("XYFZ", (10, -20, -150))
    full = measured(simulated, scattered(900, 10), noise=NOISE, seed=10)
    unit = np.random.default_rng(10).normal(size=(900, 3))
    unit /= np.linalg.norm(unit, axis=1, keepdims=True)
    value = (unit * full.value.reshape(-1, 3)).sum(axis=1)
    none = np.full(900, np.nan)
    laser = replace(full, point=np.arange(900), sense=unit, value=value, u=none, kind=np.full(900, 3))
    found = fit(design(machine, laser), laser)
    assert found.noise == pytest.approx({3: NOISE}, rel=0.06)
    assert stats.kstest(found.residual * found.weight, "norm").pvalue > 0.01


def test_a_transient_is_no_outlier():
    machine, readings = noisy(400, 4)
    early = np.exp(-np.arange(readings.points) / 6.0) * 60 * NOISE  # a warm-up of twenty readings, then nothing
    slow = replace(readings, value=readings.value + early[readings.point] * (readings.kind == 2))
    spike = slow.value.copy()
    spike[slow.point == 200] += 40 * NOISE
    found = fit(design(machine, slow), replace(slow, value=spike))
    assert not found.outliers[readings.point < 20].any()
    assert found.outliers[readings.point == 200].all()


def test_the_memory_of_noise_is_taken_from_each_direction_and_modelled():
    machine, readings = noisy(400, 6)
    rng = np.random.default_rng(8)
    value = readings.value.copy()
    rows = np.flatnonzero(readings.kind == 2)
    noise = rng.normal(size=len(rows)) * NOISE
    for i in range(1, len(rows)):
        noise[i] = 0.8 * noise[i - 1] + 0.6 * noise[i]
    value[rows] += 3 * noise
    remembering = replace(readings, value=value)
    plain = fit(design(machine, remembering), remembering)
    memory = correlation(plain, remembering, DEFAULT)
    assert memory[2] == pytest.approx(0.75, abs=0.12) and memory[0] == memory[1] == 0.0
    found = fit(plain.design, remembering, memory=memory)
    white = found.white(found.residual)[rows]
    assert abs(white[1:] @ white[:-1]) / (white @ white) < 0.15


def test_whitening_and_its_transpose_and_inverse_belong_together():
    _, readings = noisy(30, 1)
    memory = memory_of(readings, {0: 0.5, 1: 0.0, 2: 0.9}, np.random.default_rng(1).random(readings.rows) > 0.1)
    rng = np.random.default_rng(2)
    x, y = rng.normal(size=(2, readings.rows))
    assert memory.forward(x) @ y == pytest.approx(x @ memory.back(y), rel=1e-12)
    assert memory.solve(memory.forward(x)) == pytest.approx(x, abs=1e-12)
    dense = memory.forward(np.eye(readings.rows))
    inverse = dense.T @ dense
    assert np.diag(inverse) == pytest.approx(memory.diagonal, rel=1e-12)
    rows, before, entry = memory.neighbours
    assert inverse[rows, before] == pytest.approx(entry, rel=1e-12, abs=1e-15)


def test_the_order_of_readings_without_time_does_not_matter():
    machine, readings = noisy(200, seed=5, u=NOISE)
    order = np.random.default_rng(6).permutation(readings.points)
    rows = (3 * order[:, None] + np.arange(3)).ravel()  # three readings at each place
    assert (readings.point == np.repeat(np.arange(readings.points), 3)).all()
    shuffled = replace(
        readings,
        q=readings.q[order],
        value=readings.value[rows],
        columns={k: v[order] for k, v in readings.columns.items()},
        tool_offset=None if readings.tool_offset is None else readings.tool_offset[order],
    )
    one, other = (fit(design(machine, r), r) for r in (readings, shuffled))
    assert other.residual == pytest.approx(one.residual[rows], abs=1e-12)
    assert other.chi2 == pytest.approx(one.chi2, rel=1e-9)
    assert (other.outliers == one.outliers[rows]).all()


def test_runs_of_two_places_show_no_tilts_of_their_own():
    """With as many parameters as readings the noise of a direction vanishes; a tilt is judged by the other model's."""
    simulated, machine = both()
    found = []
    for seed in range(8):
        readings = measured(simulated, scattered(120, seed), noise=0.4e-3, seed=seed)
        readings = replace(readings, run=np.repeat(np.arange(60), 2).astype(str))
        found.append(aligned(machine, readings).alignment)
    assert found.count("offset per run") >= 7


def test_a_machine_that_declares_nothing_is_aligned_and_traced():
    """A rigid machine: nothing but the set-up is fitted, and the errors that it has are what is left."""
    simulated, machine = both("FXYZ", (10, -20, -150))
    readings = measured(simulated, scattered(120, 4), columns=session(120, 4), noise=NOISE, seed=4)
    nothing = replace(machine, declared=dict.fromkeys(machine.declared_symbols, 0))
    quiet = replace(readings, value=np.random.default_rng(4).normal(0.0, NOISE, readings.rows))
    assert trace(nothing, quiet, seed=4).verdict == "nothing_to_explain"
    assert trace(nothing, readings, seed=4).verdict != "nothing_to_explain"
