# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scan scores every candidate exactly as a refit would, and its p-values are fair where nothing is to find."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy import stats

from benchmarks.study_designs import null
from sensworkbench.closedloop import evidence
from sensworkbench.closedloop.bank import bank, log_tail
from sensworkbench.closedloop.design import ALL_SYMBOLS
from sensworkbench.closedloop.freeform import normal_score
from sensworkbench.closedloop.problem import Problem, State
from sensworkbench.closedloop.remainder import remainder
from sensworkbench.closedloop.scan import Rows, Scanner, exact_gain
from sensworkbench.closedloop.search import ScoredTerm, handicap
from sensworkbench.closedloop.settings import DEFAULT, TraceSettings
from sensworkbench.closedloop.trace import trace
from sensworkbench.core.shapes import Regressor
from tests.simulator import make_case

from .support import both, from_case, least_squares, measured, scattered, session

NOISE = 0.4e-3


@pytest.fixture(scope="module")
def scanned():
    """A case with outliers, roughness, runs or tools: its tracer, declared fit, rows and scanner."""
    case = make_case(20001, "thermal_scale", 2, "XYFZ", "lines", count=240, with_rivals=False)
    machine, readings, _ = from_case(case)
    tracer = State(Problem(machine, readings, permutations=19))
    fitted = tracer.fit_with([])
    rows = tracer.rows(fitted)
    return tracer, fitted, rows, Scanner(rows, tracer.problem.bank, columns=readings.columns)


def refitted_gain(tracer, fitted, symbol: int, vectors) -> tuple[float, np.ndarray]:
    """Drop of chi-square and coefficients when the candidate's columns join, by refitting everything."""
    weighted = tracer.problem.design.matrix * fitted.weight[:, None]
    y = tracer.problem.readings.value * fitted.weight
    columns = tracer.problem.design.lever[:, [symbol]] * vectors[tracer.problem.readings.point] * fitted.weight[:, None]
    _, without = least_squares(weighted, y)
    solution, with_ = least_squares(np.hstack([weighted, columns]), y)
    return without - with_, solution[weighted.shape[1] :]


def drawn(scanned, count: int, width: int, seed: int):
    """Random (component, bank entry) of a width that the readings can see."""
    tracer, _, rows, scanner = scanned
    rng = np.random.default_rng(seed)
    found = []
    while len(found) < count:
        k, c = int(rng.integers(len(tracer.problem.bank))), int(rng.integers(len(ALL_SYMBOLS)))
        if tracer.problem.bank[k].size == width and scanner.visible[k, c] > DEFAULT.scan_visible:
            found.append((k, c))
    return found


@pytest.mark.parametrize(("width", "count"), [(1, 150), (2, 60)])
def test_the_gain_of_a_candidate_is_the_drop_of_chi_square_of_a_refit(scanned, width, count):
    tracer, fitted, rows, _ = scanned
    for k, c in drawn(scanned, count, width, width):
        vectors = tracer.problem.bank[k].vectors(tracer.problem.readings.columns)
        gain, coefficients, _ = exact_gain(rows, c, vectors)
        expected, solution = refitted_gain(tracer, fitted, c, vectors)
        assert gain == pytest.approx(expected, rel=1e-6, abs=1e-6 * fitted.chi2), tracer.problem.bank[k]
        if width == 1:
            assert coefficients == pytest.approx(solution, rel=1e-4)


def test_the_gain_beside_other_effects_is_that_of_a_refit_with_them(scanned):
    tracer, fitted, _, _ = scanned
    other = ScoredTerm("EXX", Regressor.make("temp_scale_x*x", "linear"), 0.0, np.zeros(0), 1.0, 0.0)
    rows = tracer.rows_with(fitted, [other])
    weighted = np.hstack([tracer.problem.design.matrix, tracer.problem.columns_of([other])]) * fitted.weight[:, None]
    y = tracer.problem.readings.value * fitted.weight
    for k, c in drawn(scanned, 25, 1, 7):
        vectors = tracer.problem.bank[k].vectors(tracer.problem.readings.columns)
        column = tracer.problem.design.lever[:, [c]] * vectors[tracer.problem.readings.point] * fitted.weight[:, None]
        drop = least_squares(weighted, y)[1] - least_squares(np.hstack([weighted, column]), y)[1]
        gain, _, visible = exact_gain(rows, c, vectors)
        if visible > DEFAULT.scan_visible:
            assert gain == pytest.approx(drop, rel=1e-6, abs=1e-6 * fitted.chi2)


@pytest.mark.parametrize("width", [1, 2])
def test_all_scores_at_once_are_the_scores_one_by_one(scanned, width):
    tracer, _, rows, scanner = scanned
    scores = scanner.scores()
    compared = 0
    for k, c in drawn(scanned, 300, width, 10 + width):
        vectors = tracer.problem.bank[k].vectors(tracer.problem.readings.columns)
        gain, _, visible = exact_gain(rows, c, vectors)
        if width == 2:  # nearly one column: scored as one, never above the truth
            across, squares, *_ = rows.per_point(c)
            gram = (vectors * squares[:, None]).T @ vectors - (vectors.T @ across) @ (across.T @ vectors)
            if gram[0, 1] ** 2 > 0.998 * gram[0, 0] * gram[1, 1]:
                assert scores.gain[k, c] <= gain * (1 + 1e-6) + 1e-6
                continue
        assert scores.gain[k, c] == pytest.approx(gain, rel=1e-6, abs=1e-6)
        assert scores.visible[k, c] == pytest.approx(visible, rel=1e-6, abs=1e-9)
        compared += 1
    assert compared > 150


def test_components_that_the_model_holds_already_gain_nothing(scanned):
    tracer, _, _, scanner = scanned
    linear_x = next(k for k, s in enumerate(tracer.problem.bank) if s.key == ("x", "linear"))
    scores = scanner.scores()
    assert scores.visible[linear_x, ALL_SYMBOLS.index("EXX")] < 1e-6
    assert scores.tail[linear_x, ALL_SYMBOLS.index("EXX")] == 0


def test_the_tail_is_that_of_chi_square():
    gain = np.array([1e-3, 0.5, 2.0, 10.0, 50.0, 400.0])
    assert log_tail(gain, 2) == pytest.approx(-stats.chi2.logsf(gain, 2) / np.log(10), rel=1e-9)
    assert log_tail(gain, 1) == pytest.approx(-stats.chi2.logsf(gain, 1) / np.log(10), rel=0.05, abs=0.03)
    for dims in (3, 14, 40):
        level = stats.chi2.isf([0.3, 1e-2, 1e-5], dims)
        assert normal_score(level, dims) == pytest.approx(stats.norm.isf([0.3, 1e-2, 1e-5]), rel=0.04)


def test_a_bank_speaks_of_every_column_that_varies_and_of_no_other():
    simulated, _ = both()
    columns = session(120) | {"feed": np.full(120, 2000.0)}
    readings = measured(simulated, scattered(120), columns=columns)
    shapes = bank(readings)
    spoken = {c for s in shapes for c in s.driver.columns}
    assert spoken == {"x", "y", "z", "t", "dir_x", "temp_column", "temp_ambient"}
    kinds = {s.shape.name for s in shapes}
    assert kinds == {"linear", "reversal", "periodic", "approach", "step", "lag", "power", "hysteresis"}
    assert len(set(shapes)) == len(shapes)
    assert all(list(s.driver.columns) == sorted(s.driver.columns) for s in shapes)


@pytest.mark.parametrize(
    ("plain", "behind"),
    [
        (("EXX", Regressor.make("temp_scale_x*x", "linear")), ("EXX", Regressor.make("t*x", "linear"))),
        (("EXX", Regressor.make("dir_x", "reversal")), ("EXY", Regressor.make("dir_x", "reversal"))),
        (("EXY", Regressor.make("temp_column*y", "linear")), ("C0Y", Regressor.make("temp_column", "linear"))),
        (
            ("EAZ", Regressor.make("temp_column", "linear")),
            ("EAZ", Regressor.make("temp_column", "power", exponent=2.0)),
        ),
        (("EZT", Regressor.make("t", "approach", tau=9.0)), ("EXT", Regressor.make("t", "approach", tau=9.0))),
        (("EZW", Regressor.make("t", "step", at=9.0)), ("EZZ", Regressor.make("t", "step", at=9.0))),
        (("EXX", Regressor.make("dir_x*x", "linear")), ("EXX", Regressor.make("dir_x*feed*x", "linear"))),
    ],
)
def test_among_equals_the_canonical_name_comes_first(plain, behind):
    assert handicap(*plain) < handicap(*behind)


# -- multiplicity ----------------------------------------------------------------------------------------------------
@pytest.fixture(scope="module")
def plain():
    """A small bank on a plan of 150 places, to be scanned many times."""
    simulated, machine = both("FXYZ", (10, -20, -150))
    readings = measured(simulated, scattered(150, 3), columns=session(150, 3), noise=NOISE, seed=3)
    tracer = State(Problem(machine, readings, permutations=99))
    return tracer, tracer.rows(tracer.fit_with([])), tracer.problem.bank[::9]


def of_unit_noise(rows, residual):
    """The residual over the noise that it shows: gains are free of scale, as the F statistic is."""
    return residual * np.sqrt((rows.used - rows.ortho.shape[1]) / (residual**2).sum())


def test_the_family_wise_p_is_uniform_where_there_is_nothing(plain):
    tracer, rows, shapes = plain
    rng = np.random.default_rng(5)
    p = []
    for trial in range(60):
        noise = rng.normal(size=len(rows.residual))
        noise -= rows.ortho @ (rows.ortho.T @ noise)
        scanner = Scanner(
            Rows(rows.lever, noise, rows.start, rows.ortho), shapes, columns=tracer.problem.readings.columns
        )
        signs = evidence.flips(tracer.block, 99, trial)[:, tracer.row_block]
        observed = scanner.scores(of_unit_noise(rows, noise)).tail.max()
        p.append(evidence.p_value(float(observed), scanner.null_maxima(signs)))
    assert stats.kstest(p, "uniform").pvalue > 0.01
    assert np.mean(np.array(p) <= 0.05) <= 0.12
    assert min(p) >= 0.01  # never below one in a hundred with 99 flips


def test_flipped_residuals_vary_as_the_noise_where_the_leverage_is_high(plain):
    """Of a candidate that rests on some rows of high leverage the null is as wide as what noise gives it."""
    _, rows, _ = plain
    rng = np.random.default_rng(8)
    count = len(rows.residual)
    far = np.arange(count) < 80
    model, _ = np.linalg.qr(rng.normal(size=(count, 40)) * np.where(far, 10.0, 1.0)[:, None])
    candidate = np.where(far, rng.normal(size=count), 0.0)
    candidate -= model @ (model.T @ candidate)
    candidate /= np.linalg.norm(candidate)
    assert candidate**2 @ (model**2).sum(axis=1) > 0.4  # beside .09 of a mean row
    widths = []
    for _ in range(300):
        noise = rng.normal(size=count)
        noise -= model @ (model.T @ noise)
        signs = rng.choice([-1.0, 1.0], size=(20, count))
        widths.append(np.mean((Rows(rows.lever, noise, rows.start, model).flipped(signs) @ candidate) ** 2))
    assert np.mean(widths) == pytest.approx(1.0, abs=0.06)


@pytest.mark.parametrize(("design", "seed"), [("outliers", 300007), ("radius", 310023), ("heavy", 310029)])
def test_a_fit_that_holds_a_candidate_gives_no_weights_that_prove_it(design, seed):
    """What disagrees with the best of thousands of candidates counts less beside it: these three had a name once."""
    case = null(design, seed)
    found = trace(case.machine, case.readings, seed=seed)
    assert found.verdict == "nothing_to_explain" and not found.effects


@pytest.mark.parametrize("seed", range(3))
def test_few_readings_of_noise_hold_nothing(seed):
    """35 places for 57 parameters: the best of thousands of candidates takes half of the noise along."""
    simulated, machine = both("FXYZ", (10, -20, -150))
    readings = measured(simulated, scattered(35, seed), columns=session(35, seed), noise=NOISE, seed=seed)
    found = trace(machine, readings, seed=seed)
    assert found.verdict == "nothing_to_explain" and not found.effects


def test_an_effect_that_is_there_is_beyond_every_flip(plain):
    tracer, rows, shapes = plain
    column = (
        rows.lever[:, ALL_SYMBOLS.index("EAZ")]
        * tracer.problem.readings.columns["temp_column"][tracer.problem.readings.point]
    )
    noise = np.random.default_rng(6).normal(size=len(column))
    noise -= rows.ortho @ (rows.ortho.T @ noise)
    effect = column - rows.ortho @ (rows.ortho.T @ column)
    planted = noise + effect * 10.0 / np.linalg.norm(effect)  # chi-square of about 100
    with_ = Scanner(Rows(rows.lever, planted, rows.start, rows.ortho), shapes, columns=tracer.problem.readings.columns)
    without = Scanner(Rows(rows.lever, noise, rows.start, rows.ortho), shapes, columns=tracer.problem.readings.columns)
    assert evidence.p_value(float(with_.scores().tail.max()), without.null_maxima(tracer.signs)) == 0.01


def test_the_null_maxima_are_the_maxima_of_scores_under_flipped_residuals(plain):
    tracer, rows, shapes = plain
    scanner = Scanner(rows, shapes, columns=tracer.problem.readings.columns)
    few = tracer.signs[:4]
    one_by_one = [scanner.scores(of_unit_noise(rows, r)).tail.max() for r in rows.flipped(few)]
    assert scanner.null_maxima(few) == pytest.approx(one_by_one, rel=1e-3)


# -- whole blocks left out -------------------------------------------------------------------------------------------
@pytest.fixture(scope="module")
def columns_in_blocks():
    rng = np.random.default_rng(0)
    x = rng.normal(size=(120, 9)) * 10.0 ** rng.integers(-3, 3, 9)
    x[:, 8] = 2 * x[:, 1] - 1e3 * x[:, 0]  # not determined
    return x, rng.normal(size=120), np.repeat(np.arange(10), 12)


def test_held_out_errors_are_those_of_explicit_refits(columns_in_blocks):
    x, y, block = columns_in_blocks
    grams = evidence.BlockGrams(x, y, block)
    for columns in (list(range(9)), [0, 1, 2, 3], [4, 7, 8]):
        found = grams.held_out(columns)
        for b in range(10):
            beta, _ = least_squares(x[np.ix_(block != b, columns)], y[block != b])
            error = y[block == b] - x[np.ix_(block == b, columns)] @ beta
            assert found[b] == pytest.approx(error @ error, rel=1e-6)


def test_coefficients_without_a_block_predict_as_explicit_refits_do(columns_in_blocks):
    x, y, block = columns_in_blocks
    for b, beta in enumerate(evidence.BlockGrams(x, y, block).left_out_coefficients()):
        expected, _ = least_squares(x[block != b], y[block != b])
        assert x[block == b] @ beta == pytest.approx(x[block == b] @ expected, abs=1e-7)


def test_gains_on_half_of_the_blocks_are_those_of_explicit_refits(columns_in_blocks):
    x, y, block = columns_in_blocks
    grams = evidence.BlockGrams(x, y, block)
    use = np.array([0, 3, 4, 8, 9])
    rows = np.isin(block, use)
    found = grams.gains([0, 1, 2, 8], [[3], [4, 5], [6]], use)
    _, without = least_squares(x[np.ix_(rows, [0, 1, 2, 8])], y[rows])
    for gain, more in zip(found, [[3], [4, 5], [6]]):
        _, with_ = least_squares(x[np.ix_(rows, [0, 1, 2, 8, *more])], y[rows])
        assert gain == pytest.approx(without - with_, rel=1e-6)


def test_blocks_are_consecutive_and_stay_inside_a_run():
    simulated, _ = both()
    run = np.repeat([1, 2, 3], [50, 20, 80])
    block = evidence.blocks(measured(simulated, scattered(150), run=run))
    assert np.all(np.diff(block) >= 0) and set(np.diff(block)) == {0, 1}
    assert all(len(set(run[block == b])) == 1 for b in range(block.max() + 1))
    assert np.bincount(block).min() >= 4
    signs = evidence.flips(block, 50, 1)
    assert signs.shape == (50, block.max() + 1)  # one sign for a whole block
    assert set(np.unique(signs)) == {-1.0, 1.0}


def test_a_p_value_counts_the_observed_one_among_the_flips():
    assert evidence.p_value(3.0, np.array([1.0, 2.0, 2.5])) == 0.25
    assert evidence.p_value(2.0, np.array([1.0, 2.0, 2.5])) == 0.75


def test_the_shift_of_a_candidate_between_bodies_does_not_change_its_gain(scanned):
    tracer, _, rows, _ = scanned
    vectors = Regressor.make("temp_column", "linear").vectors(tracer.problem.readings.columns)
    gains = [exact_gain(rows, ALL_SYMBOLS.index(s), vectors)[0] for s in ("EXX", "EXY", "EXZ", "EXT", "EXW")]
    assert gains == pytest.approx([gains[0]] * 5, rel=1e-9)
    assert replace(rows).per_point(0)[2].shape == (tracer.problem.readings.points,)


def test_some_of_the_points_alone_are_a_model_of_their_own(scanned):
    _, _, rows, _ = scanned
    some = rows.thinned(np.arange(0, len(rows.start), 3))
    assert len(some.start) == len(range(0, len(rows.start), 3)) and some.ortho.shape[1] <= rows.ortho.shape[1]
    assert some.ortho.T @ some.ortho == pytest.approx(np.eye(some.ortho.shape[1]), abs=1e-12)
    assert np.abs(some.ortho.T @ some.residual).max() < 1e-9 * np.linalg.norm(some.residual)


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_nothing_is_left_of_noise_where_a_scan_looks_at_some_points_only(seed):
    simulated, machine = both("XYFZ", (10, -20, 400))
    columns = session(900, seed)
    bend = {"EAZ": 5e-6 * columns["temp_column"]}
    readings = measured(simulated, scattered(900, seed), bend, columns, NOISE, seed=seed)
    tracer = State(Problem(machine, readings, TraceSettings(scanned=100), seed))
    found = ScoredTerm("EAZ", Regressor.make("temp_column", "linear"), 0.0, np.zeros(1), 1.0, 0.0)
    assert tracer.problem.thin is not None and remainder(tracer, [found]).p > 0.01
