# SPDX-License-Identifier: LGPL-2.1-or-later
"""An augmented machine predicts, from its file alone, what its fit said - whatever the shape of its effects."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from sensworkbench.closedloop import scores
from sensworkbench.closedloop.design import ALL_SYMBOLS
from sensworkbench.closedloop.effects import to_effect
from sensworkbench.closedloop.estimates import Estimates
from sensworkbench.closedloop.predict import extrapolated, needed_columns, predict
from sensworkbench.closedloop.problem import Problem, State
from sensworkbench.closedloop.readings import Readings
from sensworkbench.closedloop.search import ScoredTerm, surface_candidate
from sensworkbench.closedloop.surface import surface
from sensworkbench.core.fitted import Constant, FittedModel
from sensworkbench.core.refusal import Refused
from sensworkbench.core.shapes import Regressor
from sensworkbench.formats import machine_json

from .support import APART, both, measured, scattered, session

NOISE = 0.3e-3
TOOLS = np.array([(0.0, 0.0, 0.0), (70.0, 0.0, -60.0), (0.0, 70.0, -120.0)])
SHAPES = {
    "linear": ("EAZ", Regressor.make("temp_column", "linear")),
    "product": ("EXX", Regressor.make("temp_column*x", "linear")),
    "square": ("EXX", Regressor.make("temp_column*x*x", "linear")),
    "reversal": ("EXX", Regressor.make("dir_x", "reversal")),
    "polynomial": ("EYZ", Regressor.make("temp_ambient", "polynomial", degree=3, domain=(-1.0, 1.0))),
    "periodic": ("EXX", Regressor.make("x", "periodic", period=47.3)),
    "approach": ("EZT", Regressor.make("t", "approach", tau=800.0)),
    "step": ("EZW", Regressor.make("t", "step", at=905.0)),
    "lag": ("EBY", Regressor.make("temp_column", "lag", tau=300.0)),
    "power": ("EBZ", Regressor.make("temp_column", "power", exponent=2.5)),
    "hysteresis": ("EYY", Regressor.make("y", "hysteresis", width=20.0)),
    "squareness": ("C0Y", Regressor.make("temp_ambient", "linear")),
}


@pytest.fixture(scope="module")
def tracer() -> State:
    """Readings with three tools in three runs; effects are fitted to them whether they are there or not."""
    simulated, machine = both("XYFZ", (10, -20, -150), APART)
    q = scattered(270, 2)
    columns = session(270, 2)
    tool, run = TOOLS[np.arange(270) % 3], np.arange(270) // 90 + 1
    bend = {"EAZ": 6e-6 * columns["temp_column"], "EYY": 2e-3 * np.sin(q[:, 0] / 80) * columns["temp_ambient"]}
    readings = measured(simulated, q, bend, columns, NOISE, seed=2, tool=tool, run=run)
    return State(Problem(machine, readings, permutations=9))


def augmented(tracer: State, candidates):
    """The machine with these candidates fitted as effects, and what that fit says of its own readings, (R,) mm."""
    full = tracer.fit_with(candidates)
    at, effects = len(full.design.terms), []
    for i, c in enumerate(candidates):
        m = c.vectors(tracer.problem.readings.columns).shape[1]
        block = slice(at, at + m)
        at += m
        fitted = replace(c, coefficients=full.coefficients[block])
        effects.append(
            to_effect(f"effect {i}", fitted, full.covariance[block, block], {}, tracer.problem.readings.units)
        )
    machine = scores.fitted_machine(tracer.problem.machine, full, tracer.problem.readings, effects)
    extra = tracer.problem.columns_of(candidates)
    x = full.design.matrix if extra is None else np.hstack([full.design.matrix, extra])
    return machine, x @ full.coefficients


def candidate(name) -> ScoredTerm:
    symbol, shape = SHAPES[name]
    return ScoredTerm(symbol, shape, 0.0, np.zeros(0), 1.0, 0.0)


def smooth(tracer: State) -> ScoredTerm:
    """A smooth surface over x and the ambient temperature that shifts the saddle along y."""
    fitted = tracer.fit_with([])
    found = surface(
        tracer.rows(fitted), tracer.problem.readings.columns, ALL_SYMBOLS.index("EYY"), ("x", "temp_ambient"), (8, 8)
    )
    return surface_candidate(found)


def along(readings: Readings, vectors) -> np.ndarray:
    return np.einsum("ra,ra->r", vectors[readings.point], readings.sense)


@pytest.mark.parametrize("name", [*SHAPES, "smooth"])
def test_the_file_predicts_what_the_fit_says(tracer, name):
    candidates = [smooth(tracer) if name == "smooth" else candidate(name)]
    machine, said = augmented(tracer, candidates)
    again = machine_json.loads(machine_json.dumps(machine))
    predicted = along(tracer.problem.readings, predict(again, tracer.problem.readings))
    assert predicted == pytest.approx(said, abs=1e-8)  # mm: a hundredth of a nanometre
    assert np.ptp(again.effects[0].values(tracer.problem.readings.columns)) > 0


def test_all_effects_at_once_predict_together(tracer):
    candidates = [candidate(n) for n in SHAPES if n not in ("lag", "power")] + [smooth(tracer)]
    machine, said = augmented(tracer, candidates)
    again = machine_json.loads(machine_json.dumps(machine))
    assert along(tracer.problem.readings, predict(again, tracer.problem.readings)) == pytest.approx(said, abs=1e-7)


@pytest.mark.parametrize("name", [*SHAPES, "smooth"])
def test_an_augmented_machine_comes_back_from_its_file_as_it_was(tracer, name):
    machine, _ = augmented(tracer, [smooth(tracer) if name == "smooth" else candidate(name)])
    text = machine_json.dumps(machine)
    again = machine_json.loads(text)
    assert machine_json.dumps(again) == text
    assert [e.component for e in again.effects] == [e.component for e in machine.effects]
    assert again.effects == machine_json.loads(text).effects


def test_an_effect_that_is_switched_off_takes_no_part(tracer):
    machine, _ = augmented(tracer, [candidate("linear")])
    off = replace(machine, effects=tuple(replace(e, enabled=False) for e in machine.effects))
    plain = predict(machine, tracer.problem.readings, effects=False)
    assert predict(off, tracer.problem.readings) == pytest.approx(plain)
    assert np.abs(predict(machine, tracer.problem.readings) - plain).max() > 1e-4
    assert needed_columns(machine) == ["temp_column"] and needed_columns(off) == []


def test_the_alignment_and_the_offsets_of_runs_and_tools_belong_to_the_set_up(tracer):
    machine, _ = augmented(tracer, [])
    q = scattered(5, 9)
    at = Readings.from_vectors(q, np.full((5, 3), np.nan), session(5, 9))
    first, second = (predict(machine, replace(at, run=np.full(5, label))) for label in (1, 2))
    assert second - first == pytest.approx(np.tile([c.value for c in machine.fitted.runs["2"].values()], (5, 1)))
    assert predict(machine, at) == pytest.approx(first)  # no run named: as the first
    bare = predict(machine, replace(at, run=np.full(5, 2)), alignment=False)
    assert bare == pytest.approx(predict(machine, at, alignment=False))
    longer = replace(at, tool_offset=np.tile(TOOLS[2], (5, 1)))
    known = predict(machine, longer) - predict(machine, longer, alignment=False)
    rigid = predict(machine, at) - predict(machine, at, alignment=False)
    assert np.abs(known - rigid).max() > 1e-6  # the offset of that tool joins


def test_a_missing_column_is_refused_by_name(tracer):
    for name, column in (("linear", "temp_column"), ("lag", "t"), ("hysteresis", "y"), ("smooth", "temp_ambient")):
        machine, _ = augmented(tracer, [smooth(tracer) if name == "smooth" else candidate(name)])
        short = {k: v for k, v in tracer.problem.readings.columns.items() if k != column}
        with pytest.raises(Refused, match=column):
            predict(machine, replace(tracer.problem.readings, columns=short))


def test_a_machine_without_a_fit_predicts_nothing(tracer):
    with pytest.raises(Refused, match="no fitted errors"):
        predict(tracer.problem.machine, tracer.problem.readings)


def test_outside_what_the_fit_has_seen_is_marked(tracer):
    machine, _ = augmented(tracer, [candidate("linear")])
    inside = tracer.problem.readings
    assert not extrapolated(machine, inside).any()
    warm = {**inside.columns, "temp_column": inside.columns["temp_column"] + np.where(np.arange(270) == 7, 9.0, 0.0)}
    assert np.flatnonzero(extrapolated(machine, replace(inside, columns=warm))).tolist() == [7]
    far = {**inside.columns, "x": inside.columns["x"] - np.where(np.arange(270) == 3, 700.0, 0.0)}
    assert np.flatnonzero(extrapolated(machine, replace(inside, columns=far))).tolist() == [3]
    tool = np.array(inside.tool_offset)
    tool[11] = (0.0, 0.0, -300.0)
    assert np.flatnonzero(extrapolated(machine, replace(inside, tool_offset=tool))).tolist() == [11]


def test_uncertainties_are_stored_for_what_is_determined_and_for_nothing_else():
    simulated, machine = both("FXYZ", (0, 0, 0))
    readings = measured(simulated, scattered(200, 3), columns=session(200, 3), noise=NOISE, seed=3)
    tracer = State(Problem(machine, readings, permutations=9))
    fitted, _ = augmented(tracer, [])
    assert all(u is None for u in fitted.fitted.series["EAZ"].u[1:])  # no lever arm: nothing printed for it
    assert all(u > 0 for u in fitted.fitted.series["EAX"].u[1:])
    full = tracer.fit_with([])
    names, covariance = scores.covariance_table(Estimates(tracer, full, ()).stored([], []))
    at, hidden = (names.index(f"declared {symbol} (order 1)") for symbol in ("EAX", "EAZ"))
    assert np.sqrt(covariance[at, at]) == pytest.approx(1e6 * fitted.fitted.series["EAX"].u[1], rel=0.2)  # white noise
    limits = machine.all_tolerances["EAZ"]  # of what no reading shows, only the tolerance is known
    assert np.sqrt(covariance[hidden, hidden]) == pytest.approx(1e6 * np.sqrt(limits.moments[1]), rel=1e-6)


def test_a_tool_that_no_reading_had_is_marked():
    simulated, machine = both("FXYZ", (0, 0, 0))
    readings = measured(simulated, scattered(200, 3), columns=session(200, 3), noise=NOISE, seed=3)
    fitted, _ = augmented(State(Problem(machine, readings, permutations=9)), [])
    at = Readings.from_vectors(readings.q[:2], np.full((2, 3), np.nan))
    assert not extrapolated(fitted, at).any()
    longer = replace(at, tool_offset=np.array([[0.0, 0.0, 0.0], [0.0, 0.0, -150.0]]))
    assert extrapolated(fitted, longer).tolist() == [False, True]
    imported = replace(machine, fitted=FittedModel(constants={"C0Y": Constant(1e-6)}))  # nobody knows with which tool
    assert not extrapolated(imported, longer).any()
