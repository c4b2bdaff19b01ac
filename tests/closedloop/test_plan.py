# SPDX-License-Identifier: LGPL-2.1-or-later
"""A measuring plan says beforehand what readings will show: shares, sizes, pairs and periods hold once it is run."""

from __future__ import annotations

import numpy as np
import pytest

from sensworkbench.closedloop import plan_advice
from sensworkbench.closedloop.design import ALL_SYMBOLS, declared_columns
from sensworkbench.closedloop.fit import fit, null_space
from sensworkbench.closedloop.plan import (
    LEADS,
    Plan,
    alias_frequencies,
    as_readings,
    bodies_alike,
    pairs_in_words,
    plain,
)
from sensworkbench.closedloop.readings import Readings
from sensworkbench.closedloop.settings import DEFAULT
from sensworkbench.core.refusal import Refused
from sensworkbench.core.synthesis import omega
from tests.simulator import kinematics

from .support import APART, both, grid, least_squares, measured, scattered, session

NOISE = 0.5e-3
SIMULATED, MACHINE = both("XYFZ", (10.0, -20.0, -150.0), APART)


def planned(q, columns=None, noise=NOISE, **more) -> Plan:
    return Plan(MACHINE, as_readings(Readings.from_vectors(q, np.zeros_like(q), columns, **more), noise))


@pytest.fixture(scope="module")
def scattered_plan():
    return planned(scattered(260, 3), session(260, 3))


def some(plan, count, seed):
    visible = [c for c in plan.candidates if not c.hidden and c.shape.size == 1 and not c.shape.play]
    return [visible[i] for i in np.random.default_rng(seed).choice(len(visible), count, replace=False)]


def test_the_visible_share_is_what_least_squares_leaves_of_the_candidate(scattered_plan):
    plan = scattered_plan
    for c in some(plan, 25, 1):
        lever = plan.design.lever[:, ALL_SYMBOLS.index(c.symbol)]
        column = lever * c.regressor.vectors(plan.readings.columns)[plan.readings.point, 0]
        _, left = least_squares(plan.design.matrix, column)
        assert c.visible == pytest.approx(left / (column @ column), rel=1e-6, abs=1e-9), c


def test_an_effect_of_the_smallest_size_gives_just_the_gain_that_is_asked_for(scattered_plan):
    plan = scattered_plan
    q, columns = plan.readings.q, plan.readings.columns
    for c in some(plan, 12, 2):
        if c.symbol in kinematics.SQUARENESS:  # the simulator's are constant
            continue
        motion = c.regressor.vectors(columns)[:, 0] * c.coefficient * (1e-6 if c.symbol[1] in "ABC0" else 1e-3)
        readings = measured(SIMULATED, q, {c.symbol: motion}, columns, size=0.0)
        _, without = least_squares(plan.design.matrix / NOISE, readings.value / NOISE)
        assert without == pytest.approx(plan.threshold, rel=2e-3), c
        rms = 1e3 * np.sqrt((readings.value**2).sum() / readings.points)
        assert rms == pytest.approx(c.amplitude_um, rel=2e-3), c


def test_rank_and_null_space_are_those_of_a_fit_of_readings_at_these_places():
    for tools in (None, [[0, 0, 0], [0, 0, -100], [80, 0, 0]]):
        q = scattered(200, 5)
        offset = None if tools is None else np.resize(np.array(tools, dtype=float), q.shape)
        plan = planned(q, tool_offset=offset)
        readings = measured(SIMULATED, q, noise=NOISE, tool=0.0 if offset is None else offset)
        fitted = fit(plan.design, readings)
        assert plan.rank == fitted.basis.rank
        assert plan.null_space == null_space(fitted, plan.readings)
        assert len(plan.null_space) == plan.parameters - plan.rank
        assert bool(plan.null_space) == (tools is None)


def test_the_stated_uncertainty_of_a_prediction_is_the_scatter_of_predictions():
    q = scattered(150, 6)
    offset = np.resize(np.array([[0, 0, 0], [0, 0, -100], [80, 0, 0]], dtype=float), q.shape)
    plan = planned(q, tool_offset=offset)
    stated, lost = plan.prediction_um()
    assert lost == 0
    inverse = np.linalg.pinv(plan.design.matrix / np.linalg.norm(plan.design.matrix, axis=0))
    noise = NOISE * np.random.default_rng(7).normal(size=(plan.readings.rows, 300))
    theta = inverse @ noise / np.linalg.norm(plan.design.matrix, axis=0)[:, None]
    places = grid(4)
    keep = [i for i, t in enumerate(plan.design.terms) if t.group in ("declared", "alignment")]
    terms = [plan.design.terms[i] for i in keep]
    values = np.stack(
        [
            declared_columns(MACHINE, [t], places)[:, 0] if t.group == "declared" else np.ones(len(places))
            for t in terms
        ],
        axis=1,
    )
    error = np.einsum("pan,pn,nk->pak", omega(MACHINE, [t.symbol for t in terms], places), values, theta[keep])
    assert stated == pytest.approx(1e3 * np.sqrt((error**2).sum(axis=1).mean()), rel=0.05)


def test_with_one_tool_an_error_at_another_length_is_not_determined(scattered_plan):
    assert scattered_plan.prediction_um()[0] > 0
    value, lost = scattered_plan.prediction_um(100.0)
    assert value is None and lost > 0


def test_a_reversal_hides_in_runs_of_one_direction_and_shows_in_mixed_ones():
    q = scattered(240, 8)
    run = np.repeat(["1", "2"], 120)
    one_way = planned(q, {"dir_x": np.where(run == "1", 1.0, -1.0)}, run=run)
    mixed = planned(q, {"dir_x": np.random.default_rng(8).choice([-1.0, 1.0], 240)}, run=run)
    name = {c.symbol: c for c in one_way.named if c.regressor.key == ("dir_x", "reversal")}
    assert name["EXX"].hidden and name["EXX"].coefficient is None
    assert one_way.smallest_um("reversal") is None
    assert {c.symbol: c for c in mixed.named if c.shape.name == "reversal"}["EXX"].visible > 0.9
    assert mixed.smallest_um("reversal") < 0.5


def test_an_axis_error_driven_by_its_own_position_is_declared_and_no_candidate(scattered_plan):
    assert not [c for c in scattered_plan.candidates if (c.symbol, *c.regressor.key) == ("EXX", "x", "linear")]
    assert [c for c in scattered_plan.candidates if (c.symbol, *c.regressor.key) == ("EAX", "y", "linear")]


def test_bodies_that_move_alike_stand_together(scattered_plan):
    assert ["EXX", "EXY", "EXZ", "EXT", "EXW"] == sorted(
        next(g for g in bodies_alike(scattered_plan) if "EXX" in g), key="EXX EXY EXZ EXT EXW".split().index
    )
    c = next(c for c in scattered_plan.named if c.regressor.key == ("dir_x", "reversal") and c.symbol[1] == "X")
    assert c.symbol == "EXX" and set(c.alike) == {"EXY", "EXZ", "EXT", "EXW"}


def test_two_temperatures_that_run_together_are_named_as_a_pair_and_independent_ones_are_not():
    q, t = scattered(200, 9), np.linspace(0, 1, 200)
    wave, other = np.sin(9 * t), np.cos(23 * t)
    together = planned(q, {"temp_a": wave, "temp_b": 0.6 * wave + 0.01 * other})
    apart = planned(q, {"temp_a": wave, "temp_b": other})

    def pairs(plan):
        return {
            frozenset((str(a.driver), str(b.driver)))
            for a, b, _ in plan.confused()
            if a.symbol == b.symbol and a.driver.factors == 1
        }

    assert frozenset(("temp_a", "temp_b")) in pairs(together)
    assert frozenset(("temp_a", "temp_b")) not in pairs(apart)
    words = next(p for p in pairs_in_words(together.confused()) if p["drivers"] == ["temp_a", "temp_b"])
    assert words["cosine"] > 0.95 and words["count"] >= len(words["components"]) > 5


def test_pairs_are_those_whose_projected_traces_are_parallel(scattered_plan):
    plan = scattered_plan
    a, b, stated = plan.confused()[0]
    left = []
    for c in (a, b):
        column = (
            plan.design.lever[:, ALL_SYMBOLS.index(c.symbol)]
            * c.regressor.vectors(plan.readings.columns)[plan.readings.point, 0]
        )
        size = np.linalg.norm(plan.design.matrix, axis=0)
        m = plan.design.matrix / np.where(size > 0, size, 1)
        left.append(column - m @ np.linalg.lstsq(m, column, rcond=1e-9)[0])
    assert left[0] @ left[1] / np.linalg.norm(left[0]) / np.linalg.norm(left[1]) == pytest.approx(stated, abs=1e-6)


def test_on_a_regular_grid_each_lead_has_the_alias_that_its_step_makes():
    leads = {(p.axis, p.lead): p for p in planned(grid(13)).leads}  # 13 places 50 mm apart
    for lead in LEADS:
        found = leads["x", lead].alias
        folded = abs(50 / lead - round(50 / lead))
        assert found == (np.inf if folded < 1e-9 else pytest.approx(50 / folded, rel=1e-3)), lead
        x = grid(13)[:, 0]
        if np.isfinite(found):  # a sine of the lead is at these places a sine of the alias
            base = np.stack([np.sin(2 * np.pi * x / found), np.cos(2 * np.pi * x / found)], axis=1)
            wave = np.sin(2 * np.pi * x / lead + 0.4)
            assert least_squares(base, wave)[1] < 1e-3 * (wave @ wave)
        else:
            assert np.ptp(np.sin(2 * np.pi * x / lead + 0.4)) < 1e-9


def test_places_at_random_have_no_alias():
    assert len(alias_frequencies(scattered(200, 4)[:, 0])) == 0
    assert not planned(scattered(200, 4)).aliased


def test_what_needs_a_column_that_is_not_planned_is_not_testable():
    plan = planned(scattered(100, 2))
    needs = {str(effect): columns for effect, columns in plan.not_testable}
    assert "dir_x" in needs["reversal error (backlash)"] and "t_s" in needs["drift in time"]
    testable = {entry.name for entry, found in plan.physical() if found}
    assert not testable & set(needs)


def test_repeats_are_counted_with_their_tool():
    q = np.concatenate([scattered(60, 1)] * 2)
    assert planned(q).repeats == (60, 180)
    assert planned(q, tool_offset=np.repeat([[0.0, 0, 0], [0, 0, -50]], 60, axis=0)).repeats == (0, 0)


def test_advice_states_the_number_that_the_changed_plan_has():
    plan = planned(grid(6))
    advice = {a.do.code.removeprefix("plan-do-"): a for a in plan_advice.advise(plan)}
    assert {"tools", "directions", "irregular", "random-order-time", "temperatures"} <= set(advice)
    tools = advice["tools"]
    assert tools.do.fields == {"length": plan_advice.tool_length(MACHINE), "side": plan_advice.SIDE_MM}
    changed = Plan(MACHINE, plan_advice.with_tools(MACHINE, plan.readings, np.random.default_rng(5)))
    assert (tools.before, tools.after) == (len(plan.null_space), len(changed.null_space))
    assert tools.before > tools.after
    mixed = Plan(MACHINE, plan_advice.with_directions(plan.readings, np.random.default_rng(6)))
    assert advice["directions"].before is None
    assert advice["directions"].after == pytest.approx(mixed.smallest_um("reversal"), rel=0.1)
    assert (advice["irregular"].before, advice["irregular"].after) == (len(plan.aliased), 0)


def test_random_order_moves_places_and_keeps_the_conditions_of_each_moment():
    q = grid(5)
    columns = {"t": 10.0 * np.arange(125), "temp_a": np.linspace(0, 3, 125), "dir_x": np.resize([1.0, -1.0], 125)}
    before = planned(q, columns).readings
    after = plan_advice.in_random_order(before, np.random.default_rng(1))
    assert np.array_equal(after.columns["t"], before.columns["t"])
    assert np.array_equal(after.columns["temp_a"], before.columns["temp_a"])
    rows = lambda r: {(*p, d) for p, d in zip(r.q.tolist(), r.columns["dir_x"].tolist())}  # noqa: E731
    assert rows(after) == rows(before) and not np.array_equal(after.q, before.q)
    assert np.array_equal(after.columns["x"], after.q[:, 0])


def test_a_suggested_plan_has_what_the_advice_asks_for_and_sees_more_than_a_grid():
    given = planned(grid(6))
    suggested = Plan(MACHINE, plan_advice.suggest(MACHINE, 216, NOISE, given.readings, seed=4))
    q = suggested.readings.q
    low, high = MACHINE.travel.T
    assert len(q) == 216 and (q >= low).all() and (q <= high).all()
    assert suggested.null_space == [] and suggested.aliased == [] and suggested.repeats[1] >= 30
    for name in ("dir_x", "dir_y", "dir_z"):
        assert set(suggested.readings.columns[name]) == {-1.0, 1.0}
    assert len(np.unique(suggested.readings.tool_offset, axis=0)) == 3
    before, after = given.numbers(), suggested.numbers()
    assert after["physical_effects_testable"] > before["physical_effects_testable"]
    assert after["prediction_longer_tool_um"] < 2 and before["prediction_longer_tool_um"] is None
    before, after = ({a.do.code.removeprefix("plan-do-") for a in plan_advice.advise(p)} for p in (given, suggested))
    done = {"tools", "directions", "time", "random-order", "random-order-time", "irregular"}
    assert before & done and not after & done


def test_the_same_seed_suggests_the_same_plan():
    plans = [plan_advice.suggest(MACHINE, 80, NOISE, seed=s).q for s in (1, 1, 2)]
    assert np.array_equal(plans[0], plans[1]) and not np.array_equal(plans[0], plans[2])


def test_suggested_conditions_are_those_of_the_given_session():
    given = planned(scattered(100, 1), {"t": 20.0 * np.arange(100), "temp_a": np.linspace(-1, 4, 100)})
    suggested = plan_advice.suggest(MACHINE, 200, NOISE, given.readings)
    assert (suggested.columns["t"][0], suggested.columns["t"][-1]) == (0.0, 1980.0)
    assert np.allclose(suggested.columns["temp_a"], np.interp(suggested.columns["t"], [0, 1980], [-1, 4]), atol=0.06)


def test_single_directions_and_sensing_vectors_are_planned_too():
    q = scattered(120, 2)
    positions = Readings.from_vectors(q, np.zeros_like(q), session(120))
    assert as_readings(positions, NOISE, directions=(2,)).rows == 120
    n = np.random.default_rng(3).normal(size=q.shape)
    n /= np.linalg.norm(n, axis=1)[:, None]
    along = Plan(MACHINE, as_readings(positions, NOISE, normals=n))
    full = Plan(MACHINE, as_readings(positions, NOISE))
    assert along.readings.rows == 120 and np.allclose(along.readings.sense, n)
    pick = lambda p: next(c for c in p.named if (c.symbol, str(c.driver)) == ("EXX", "dir_x"))  # noqa: E731
    assert DEFAULT.visible < pick(along).visible < pick(full).visible


def test_the_plain_candidates_of_an_effect_come_first(scattered_plan):
    for _, found in scattered_plan.physical():
        if found:
            assert plain(found)[0] is found[0]
            assert all(c.handicap >= plain(found)[-1].handicap for c in found[len(plain(found)) :])


def test_too_few_readings_are_refused():
    with pytest.raises(Refused, match="too few"):
        planned(scattered(3, 1))
