# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shapes of drivers by their closed forms, and free forms that locate without naming."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from sensworkbench.closedloop.bank import useful_columns
from sensworkbench.closedloop.design import ALL_SYMBOLS
from sensworkbench.closedloop.freeform import FreeScan, free_form, subspace_gain
from sensworkbench.closedloop.naming import slow_columns
from sensworkbench.closedloop.problem import Problem, State
from sensworkbench.closedloop.remainder import remainder
from sensworkbench.closedloop.search import surface_candidate
from sensworkbench.closedloop.settings import DEFAULT
from sensworkbench.closedloop.surface import locate
from sensworkbench.core.driver import Driver
from sensworkbench.core.effects import Effect
from sensworkbench.core.refusal import Refused
from sensworkbench.core.shapes import Linear, Regressor, bump_features, hysteresis, lag

from .support import both, least_squares, measured, scattered, session

NOISE = 0.4e-3
UNEVEN = np.array([0.0, 3.0, 4.0, 60.0, 61.0, 200.0, 900.0, 900.0, 2500.0])


def shaped(shape: str, driver: str, columns: dict, **parameters) -> np.ndarray:
    return Regressor.make(driver, shape, **parameters).vectors(
        {k: np.asarray(v, dtype=float) for k, v in columns.items()}
    )


# -- memory ----------------------------------------------------------------------------------------------------------
def test_a_lag_follows_a_step_as_the_closed_form_says_however_the_rows_are_spaced():
    assert lag(np.full(9, 5.0), UNEVEN, 300.0) == pytest.approx(5 * (1 - np.exp(-UNEVEN / 300.0)), abs=1e-12)
    coming_back = lag(np.zeros(9), UNEVEN, 300.0, state0=2.0)
    assert coming_back == pytest.approx(2 * np.exp(-UNEVEN / 300.0), abs=1e-12)


def test_a_lag_solves_its_differential_equation():
    rng = np.random.default_rng(1)
    t = np.cumsum(rng.uniform(5, 60, 40))
    v = rng.normal(size=40)
    held = lambda now: v[min(int(np.searchsorted(t, now)), 39)]  # noqa: E731 - at its end value over each interval
    expected = [0.3]
    for a, b in zip(t[:-1], t[1:]):
        end = solve_ivp(
            lambda s, y, m=(a + b) / 2: (held(m) - y) / 120.0, (a, b), [expected[-1]], rtol=1e-10, atol=1e-12
        )
        expected.append(end.y[0, -1])
    assert lag(v, t, 120.0, 0.3) == pytest.approx(expected, abs=1e-7)


def test_a_lag_with_a_short_constant_is_its_driver_and_with_a_long_one_its_integral():
    v, t = np.array([0.0, 1.0, 4.0, -2.0]), np.array([0.0, 10.0, 20.0, 30.0])
    assert lag(v, t, 0.01) == pytest.approx(v, abs=1e-9)
    assert lag(v, t, 1e9) * 1e9 == pytest.approx([0, 10, 50, 30], rel=1e-6)


def test_a_lag_needs_time():
    with pytest.raises(Refused, match="'t'"):
        shaped("lag", "temp", {"temp": [1, 2]}, tau=3.0)


def test_hysteresis_is_the_play_of_a_drive_with_friction():
    way = np.array([0.0, 5.0, 5.5, 5.0, 4.0, 0.0, 9.0])
    assert hysteresis(way, 1.0) == pytest.approx([0, 1, 1, 0.5, -0.5, -1, 1])
    assert hysteresis(way + 100.0, 1.0) == pytest.approx(hysteresis(way, 1.0))  # where it stands does not matter
    assert hysteresis(np.repeat(way, 3), 1.0)[::3] == pytest.approx(hysteresis(way, 1.0))  # nor how fast it goes
    assert hysteresis(-way, 1.0) == pytest.approx(-hysteresis(way, 1.0))


def test_hysteresis_saturates_at_its_width_and_becomes_reversal_where_it_is_narrow():
    way = np.concatenate([np.linspace(0, 100, 51), np.linspace(98, 0, 50)])
    assert np.abs(hysteresis(way, 7.0)).max() == 7.0
    assert hysteresis(way, 0.01)[1:] / 0.01 == pytest.approx(np.sign(np.diff(way)))


# -- shapes without memory -------------------------------------------------------------------------------------------
def test_approach_step_power_and_period_by_their_formulas():
    t = np.array([0.0, 10.0, 20.0])
    assert shaped("approach", "t", {"t": t}, tau=10.0)[:, 0] == pytest.approx([0, 1 - 1 / math.e, 1 - math.exp(-2)])
    assert shaped("step", "t", {"t": t}, at=10.0)[:, 0].tolist() == [0, 0, 1]  # strictly beyond the instant
    v = np.array([-4.0, 0.0, 9.0])
    assert shaped("power", "v", {"v": v}, exponent=0.5)[:, 0] == pytest.approx([-2, 0, 3])
    assert shaped("periodic", "v", {"v": v}, period=36.0) == pytest.approx(
        np.stack([np.sin(v * math.pi / 18), np.cos(v * math.pi / 18)], axis=1)
    )
    assert shaped("polynomial", "v", {"v": [10, 15, 20]}, degree=2, domain=[10, 20]) == pytest.approx(
        np.array([[-1, 1], [0, -0.5], [1, 1]])
    )


def test_a_product_of_columns_is_their_product_and_a_missing_column_is_refused_by_name():
    columns = {"x": np.array([1.0, 2.0]), "temp_a": np.array([3.0, -4.0])}
    assert Driver.parse("temp_a*x").values(columns).tolist() == [3, -8]
    with pytest.raises(Refused, match="temp_b"):
        Driver.parse("temp_b*x").values(columns)


def test_coefficients_are_mm_or_rad_per_driver_unit():
    assert Effect("e", "EXX", "temp", Linear(), (3e-3,)).values({"temp": np.array([2.0])}) == pytest.approx([6e-3])


# -- free forms ------------------------------------------------------------------------------------------------------
def test_a_free_form_holds_every_polynomial_of_its_columns_and_no_constant():
    rng = np.random.default_rng(0)
    columns = {"a": rng.uniform(-3, 5, 200), "b": rng.uniform(100, 200, 200)}
    vectors = free_form(columns, ("a", "b"), 4).vectors
    target = columns["a"] * (columns["b"] - 140) ** 3 + columns["a"] ** 4
    _, left = least_squares(np.column_stack([vectors, np.ones(200)]), target)
    assert left < 1e-16 * (target @ target)
    assert least_squares(vectors, np.ones(200))[1] > 1.0


def test_a_free_form_is_held_at_the_edge_of_what_it_was_made_for():
    columns = {"a": np.linspace(0, 1, 30)}
    form = free_form(columns, ("a",), 5)
    beyond = free_form({"a": np.array([1.0, 7.0, -3.0, 0.0])}, ("a",), 5, form.domains).vectors
    assert beyond[0] == pytest.approx(beyond[1]) and beyond[2] == pytest.approx(beyond[3])


def test_columns_of_few_levels_get_few_orders():
    assert free_form({"d": np.array([-1.0, 1.0] * 20)}, ("d",), 9).vectors.shape[1] == 1


def test_bumps_cover_their_domain_smoothly_and_are_held_beyond_it():
    x = np.linspace(0, 1, 200)
    features = bump_features({"a": x}, ("a",), (13,), ((0.0, 1.0),))
    target = np.sin(5 * x)
    _, left = least_squares(features, target)
    assert left < 1e-4 * (target @ target)  # within one per cent
    outside = bump_features({"a": np.array([1.0, 4.0])}, ("a",), (8,), ((0.0, 1.0),))
    assert outside[0] == pytest.approx(outside[1])


@pytest.fixture(scope="module")
def odd():
    """A column that twists with time and place as no shape of the catalogue does; and the same machine without."""
    simulated, machine = both("XYFZ", (10, -20, -150))
    q, columns = scattered(400, 4), session(400, 4)
    u = columns["t"] / columns["t"][-1]
    twist = 4 * NOISE * np.sin(4 * u) * np.cos(q[:, 1] / 100.0)
    readings = measured(simulated, q, {"EZY": twist}, columns, NOISE, seed=4)
    quiet = measured(simulated, q, {}, columns, NOISE, seed=4)
    tracers = [State(Problem(machine, r, permutations=99)) for r in (readings, quiet)]
    return (*tracers, twist)


def test_the_gain_of_a_free_form_is_the_drop_of_chi_square_of_a_refit(odd):
    tracer = odd[0]
    fitted = tracer.fit_with([])
    rows = tracer.rows(fitted)
    weighted, y = tracer.problem.design.matrix * fitted.weight[:, None], tracer.problem.readings.value * fitted.weight
    for symbol, names in (("EZY", ("t", "y")), ("EAX", ("temp_column",)), ("EBZ", ("dir_x", "temp_ambient"))):
        order = DEFAULT.free_line if len(names) == 1 else DEFAULT.free_more
        vectors = free_form(tracer.problem.readings.columns, names, order).vectors
        c = ALL_SYMBOLS.index(symbol)
        gain, dims = subspace_gain(rows, c, vectors)
        columns = tracer.problem.design.lever[:, [c]] * vectors[tracer.problem.readings.point] * fitted.weight[:, None]
        drop = least_squares(weighted, y)[1] - least_squares(np.hstack([weighted, columns]), y)[1]
        assert gain == pytest.approx(drop, rel=0.02, abs=3.0)  # hardly visible directions are left out
        assert 0 < dims <= vectors.shape[1]


def test_free_forms_of_two_columns_locate_a_shape_that_no_catalogue_holds(odd):
    tracer = odd[0]
    found, null = FreeScan(tracer.rows(tracer.fit_with([])), tracer.problem.readings).best(tracer.signs)
    assert found[0].columns == ("y", "t")
    assert found[0].p == 0.01 and found[0].score > null.max()
    rest = remainder(tracer, [])
    assert set(rest.structure.columns) == {"t", "y"}
    assert rest.structure.evidence > DEFAULT.detectable and rest.gain[0] > 2 * rest.gain[1]
    assert surface_candidate(rest.structure).symbol == "EZY"
    fitted = tracer.fit_with([])
    lever = tracer.problem.design.lever[:, ALL_SYMBOLS.index("EZY")]
    twist = odd[2][tracer.problem.readings.point] * lever * fitted.weight
    shown = twist - fitted.basis.ortho @ (fitted.basis.ortho.T @ twist)  # the declared model imitates a part of it
    assert rest.size == pytest.approx(np.sqrt((shown**2).mean()), rel=0.2)


def test_free_forms_find_nothing_in_noise(odd):
    tracer = odd[1]
    rest = remainder(tracer, [])
    assert rest.p > 0.01 and rest.structure is None


def test_a_surface_weighs_width_by_evidence(odd):
    tracer = odd[0]
    rows = tracer.rows(tracer.fit_with([]))
    places = [ALL_SYMBOLS.index(s) for s in ("EXW", "EYW", "EZW")]
    found = locate(rows, tracer.problem.readings, useful_columns(tracer.problem.readings), places)
    assert [s.evidence for s in found] == sorted((s.evidence for s in found), reverse=True)
    assert ALL_SYMBOLS[found[0].component] == "EZW"
    assert found[0].freedom < 0.5 * found[0].gain


def test_slow_columns_are_those_that_time_could_stand_in_for():
    columns = session(300) | {"x": np.linspace(0, 1, 300)}
    assert slow_columns(columns, list(columns)) == ["temp_column", "temp_ambient"]
