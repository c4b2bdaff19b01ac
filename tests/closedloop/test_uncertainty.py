# SPDX-License-Identifier: LGPL-2.1-or-later
"""Standard uncertainties: those of fits and predictions are the scatter of repeated measurements, made here."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from sensworkbench.closedloop import scores
from sensworkbench.closedloop.design import declared_terms, design
from sensworkbench.closedloop.effects import to_effect
from sensworkbench.closedloop.estimates import Estimates
from sensworkbench.closedloop.fit import fit
from sensworkbench.closedloop.predict import predict, uncertainty
from sensworkbench.closedloop.problem import Problem, State
from sensworkbench.closedloop.readings import Readings
from sensworkbench.closedloop.search import ScoredTerm, refine
from sensworkbench.closedloop.trace import trace
from sensworkbench.closedloop.uncertainty import expected, settled, spread, triangle, with_effects
from sensworkbench.core.fitted import Uncertainty
from sensworkbench.core.shapes import Regressor
from sensworkbench.formats import machine_json, readings_csv, trace_json
from sensworkbench.studies.predict import predict_study

from .support import both, grid, measured, scattered, session

NOISE = 0.5e-3


def remembered(rng, count: int, phi: float) -> np.ndarray:
    """(count, 3) noise of variance 1 whose successive values are correlated by phi."""
    out = rng.normal(size=(count, 3))
    for i in range(1, count):
        out[i] = phi * out[i - 1] + np.sqrt(1 - phi**2) * out[i]
    return out


def with_noise(readings: Readings, noise) -> Readings:
    return replace(readings, value=readings.value + noise.ravel())


def machine_of(state: State, term: ScoredTerm | None):
    """The machine as `trace` would keep it with one effect, and the estimates."""
    model = [] if term is None else [term]
    problem = state.problem
    full = settled(state.fit_with(model), problem.machine, problem.readings, problem.columns_of(model))
    model = [replace(term, coefficients=full.coefficients[len(full.design.terms) :])] if model else []
    estimates = Estimates(state, full, tuple(model))
    effects = [
        to_effect(f"effect {i}", c, estimates.coefficient_covariance(i), estimates.parameter_u(i))
        for i, c in enumerate(model)
    ]  # fmt: skip
    stored = estimates.stored(effects, [])
    return scores.fitted_machine(
        problem.machine, full, problem.readings, effects, estimates.term_u(stored), stored
    ), estimates


@pytest.mark.parametrize("phi", [0.0, 0.15, 0.6])
def test_coefficients_scatter_as_their_uncertainty_says_whether_or_not_the_noise_remembers(phi):
    simulated, machine = both()
    q = grid(5)  # in the order of the grid
    clean = measured(simulated, q)
    plan = design(machine, clean)
    truth, rng, score = fit(plan, clean).coefficients, np.random.default_rng(4), []
    for _ in range(60):
        noisy = with_noise(clean, NOISE * remembered(rng, len(q), phi))
        found = fit(plan, noisy)  # ordinary least squares: the memory is in the uncertainty, not in the weights
        u = spread(found, noisy).u
        score.append(((found.coefficients - truth) / u)[np.isfinite(u)])
    share = float((np.abs(score) < 2).mean())
    assert 0.93 < share < 0.97, share


@pytest.mark.parametrize(
    "regressor",
    [Regressor.make("t", "approach", tau=700.0), Regressor.make("temp_column", "lag", tau=300.0)],
    ids=["approach", "lag"],
)
def test_parameters_and_predictions_scatter_as_their_uncertainty_says(regressor):
    simulated, machine = both()
    q, columns = scattered(120, 7), session(120, 7)
    gain = 4e-3 if regressor.shape.name == "approach" else 1.5e-3
    clean = measured(simulated, q, {"EZT": gain * regressor.vectors(columns)[:, 0]}, columns)
    places = Readings.from_vectors(scattered(40, 8), np.full((40, 3), np.nan), {k: v[:40] for k, v in columns.items()})
    truth = predict(
        machine_of(
            State(Problem(machine, clean, permutations=9)), ScoredTerm("EZT", regressor, 0.0, np.zeros(0), 1, 0)
        )[0],
        places,
    )
    rng, scores_of, inside = np.random.default_rng(5), [], []
    for _ in range(60):
        noisy = with_noise(clean, NOISE * rng.normal(size=(120, 3)))
        state = State(Problem(machine, noisy, permutations=9))
        term = ScoredTerm("EZT", regressor, 0.0, np.zeros(0), 1.0, 0.0)
        rows = state.rows_with(state.fit_with([term]), [])
        term = refine(rows, term, noisy.columns, 30)
        found, _ = machine_of(state, term)
        effect = found.effects[0]
        scores_of.append(
            (
                (effect.coefficients[0] - gain) / effect.u[0],
                (effect.shape.tau - regressor.shape.tau) / effect.shape_u["tau"],
            )
        )
        inside.append((predict(found, places) - truth) / uncertainty(found, places))
    assert 0.85 < np.std(scores_of, axis=0).min() and np.std(scores_of, axis=0).max() < 1.2
    assert 0.93 < (np.abs(inside) < 2).mean() < 0.97


def test_what_no_reading_shows_has_the_uncertainty_that_its_tolerance_leaves():
    """One tool cannot show EAZ, EBZ, ECZ; a longer one shows them, as far as their limits let them go."""
    simulated, machine = both(tool_point=(0.0, 0.0, 0.0))
    q = scattered(150, 3)
    terms, (mean, deviation) = declared_terms(machine), expected(machine, design(machine, measured(simulated, q)))
    rng, inside, size = np.random.default_rng(6), [], []
    longer = Readings.from_vectors(q[:30], np.full((30, 3), np.nan), tool_offset=np.tile((0.0, 0.0, -150.0), (30, 1)))
    plan, far = (
        design(machine, r)
        for r in (
            measured(simulated, q),
            replace(
                longer,
                point=np.repeat(np.arange(30), 3),
                sense=np.tile(np.eye(3), (30, 1)),
                value=np.zeros(90),
                u=np.full(90, np.nan),
                kind=np.tile(np.arange(3), 30),
            ),
        )
    )
    for _ in range(40):
        theta = np.zeros(len(plan.terms))
        theta[: len(terms)] = (mean + deviation * rng.normal(size=len(mean)))[: len(terms)]
        error = (plan.matrix @ theta).reshape(-1, 3) + NOISE * rng.normal(size=q.shape)
        found, _ = machine_of(State(Problem(machine, Readings.from_vectors(q, error), permutations=9)), None)
        u = uncertainty(found, longer)
        inside.append((predict(found, longer) - (far.matrix @ theta).reshape(-1, 3)) / u)
        size.append(u)
    assert 0.93 < (np.abs(inside) < 2).mean() < 0.97
    assert np.median(size) > 2 * NOISE  # 150 mm times angles of 20 urad: no small matter


def test_the_open_directions_are_settled_as_the_most_probable_by_the_tolerances():
    """Against the textbook form: of all solutions of least squares that with the smallest Mahalanobis distance."""
    simulated, machine = both(tool_point=(0.0, 0.0, 0.0))
    readings = measured(simulated, scattered(150, 3), noise=NOISE)
    plan = design(machine, readings)
    found = fit(plan, readings)
    again = settled(found, machine, readings)
    assert plan.matrix @ again.coefficients == pytest.approx(plan.matrix @ found.coefficients, abs=1e-10)
    mean, deviation = with_effects(expected(machine, plan), 0)
    weighed = plan.matrix * deviation
    u, s, vt = np.linalg.svd(weighed, full_matrices=False)
    keep = s > 1e-9 * s[0]
    least = deviation * (vt[keep].T @ ((u[:, keep].T @ (plan.matrix @ (found.coefficients - mean))) / s[keep])) + mean
    assert again.coefficients == pytest.approx(least, abs=1e-7)


def test_a_file_carries_the_covariance_and_one_without_it_predicts_without(tmp_path):
    simulated, machine = both()
    q, columns = scattered(150, 7), session(150, 7)
    regressor = Regressor.make("temp_column", "linear")
    readings = measured(simulated, q, {"EXX": 2e-3 * columns["temp_column"]}, columns, NOISE)
    found, estimates = machine_of(
        State(Problem(machine, readings, permutations=9)), ScoredTerm("EXX", regressor, 0.0, np.zeros(0), 1.0, 0.0)
    )
    again = machine_json.loads(machine_json.dumps(found))
    assert isinstance(again.fitted.uncertainty, Uncertainty) and again.fitted.uncertainty == found.fitted.uncertainty
    assert uncertainty(again, readings) == pytest.approx(uncertainty(found, readings), rel=1e-12)
    whole = estimates.spread.factor
    factor = again.fitted.uncertainty.matrix()
    assert factor @ factor.T == pytest.approx(whole @ whole.T, rel=1e-6, abs=1e-18)
    # by hand: the variance of a prediction is j C jᵀ, with j the rows of the design
    plan = np.concatenate(
        [design(machine, readings).matrix, State(Problem(machine, readings)).problem.columns_of(estimates.model)],
        axis=1,
    )
    by_hand = np.sqrt(np.einsum("ri,ij,rj->r", plan, whole @ whole.T, plan))
    assert uncertainty(found, readings).ravel() == pytest.approx(by_hand, rel=1e-6)
    old = replace(found, fitted=replace(found.fitted, uncertainty=None))
    positions = replace(readings, run=None)
    study = predict_study(old, positions)
    assert uncertainty(old, readings) is None and np.isnan(study.u).all() and not study.u_known
    assert predict_study(found, positions).u_known
    table = tmp_path / "positions.csv"
    table.write_text("x_mm,y_mm,z_mm\n1,2,3\n", encoding="utf-8")
    places, out = readings_csv.load_positions(table), tmp_path / "predicted.csv"
    readings_csv.save_predicted(out, table, places, np.zeros((1, 3)), [False], u=np.array([[1e-3, np.nan, 2e-3]]))
    assert out.read_text(encoding="utf-8").splitlines() == [
        "x_mm,y_mm,z_mm,ex_um,ey_um,ez_um,u_ex_um,u_ey_um,u_ez_um,extrapolated",
        "1,2,3,0.000000,0.000000,0.000000,1.000000,,2.000000,0",
    ]
    assert readings_csv.load(out).points == 1  # a prediction reads back: its uncertainty drives nothing
    assert "u_ex" not in readings_csv.load_positions(out).columns


def test_the_instant_of_a_step_is_known_to_a_gap_of_the_readings():
    """A step far above the noise lies between two readings: a uniform law over the gap, gap / sqrt(12)."""
    simulated, machine = both()
    q, columns = scattered(150, 7), session(150, 7)
    regressor = Regressor.make("t", "step", at=705.0)
    readings = measured(simulated, q, {"EZW": 20e-3 * regressor.vectors(columns)[:, 0]}, columns, NOISE)
    state = State(Problem(machine, readings, permutations=9))
    found, _ = machine_of(state, ScoredTerm("EZW", regressor, 0.0, np.zeros(0), 1.0, 0.0))
    assert found.effects[0].shape_u["at"] == pytest.approx(10 / np.sqrt(12), rel=1e-6)
    small = measured(simulated, q, {"EZW": 0.4e-3 * regressor.vectors(columns)[:, 0]}, columns, NOISE)
    state = State(Problem(machine, small, permutations=9))
    found, _ = machine_of(state, ScoredTerm("EZW", regressor, 0.0, np.zeros(0), 1.0, 0.0))
    assert found.effects[0].shape_u["at"] > 10  # a small one could lie several readings away


def test_a_triangle_holds_the_same_covariance():
    factor = np.random.default_rng(0).normal(size=(7, 5)) * [1e-6, 1, 1e3, 1, 1e-9]
    half = triangle(factor)
    assert half @ half.T == pytest.approx(factor @ factor.T, rel=1e-9)
    assert not half[:5][np.triu_indices(5, 1)].any()


# -- budget ------------------------------------------------------------------------------------------------------------
def outcome_of(records):
    """A trace of readings in six runs, with records of instrument and temperature."""
    simulated, machine = both()
    q, columns = scattered(180, 7), session(180, 7)
    bend = {"EAZ": 12e-6 * columns["temp_column"]}
    run = np.arange(180) // 30
    readings = measured(simulated, q, bend, columns, NOISE, tool=0.0, run=run)
    return trace(machine, replace(readings, records=records), permutations=199)


def test_the_budget_is_the_mean_variance_of_the_predictions_and_names_its_sources():
    result = outcome_of({"u_scale_um_m": "2", "expansion_um_m_k": "11.5", "u_temperature_k": "0.1"})
    lines = {b.source: b.variance for b in result.budget}
    assert set(lines) == {"noise", "alignment", "instrument", "temperature", "undetermined", "rivals"}
    u = uncertainty(result.machine, result.readings)
    assert sum(lines.values()) == pytest.approx((u**2).sum(axis=1).mean(), rel=0.02)
    # by hand: a scale off by u moves every place by u times its distance from the middle
    place = result.readings.q - result.readings.q.mean(axis=0)
    assert lines["instrument"] == pytest.approx((2e-6) ** 2 * (place**2).sum(axis=1).mean(), rel=0.05)
    assert lines["temperature"] == pytest.approx(lines["instrument"] * (11.5 * 0.1 / 2) ** 2, rel=1e-6)
    assert lines["undetermined"] < 1e-4 * lines["noise"]  # at places and with the tool of the readings
    error = trace_json.to_dict(result)["error"]["augmented"]["left_out"]
    assert error["by"] == "runs" and error["number"] == 6 and error["coverage"] == pytest.approx(6 / 7)
    assert 0.5 < error["lowest_um"] / (1e3 * NOISE * np.sqrt(3)) < error["highest_um"] / (1e3 * NOISE * np.sqrt(3)) < 2


def test_what_the_file_does_not_state_is_in_no_budget():
    assert {b.source for b in outcome_of({}).budget} == {"noise", "alignment", "undetermined", "rivals"}
