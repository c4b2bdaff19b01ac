# SPDX-License-Identifier: LGPL-2.1-or-later
"""A shape is one class: a class that is made here is scanned, fitted, named, written, read, predicted and planned."""

from __future__ import annotations

import numpy as np
import pytest

from sensworkbench.closedloop import plan as planning
from sensworkbench.closedloop.bank import bank
from sensworkbench.closedloop.predict import predict
from sensworkbench.closedloop.trace import trace
from sensworkbench.core.driver import Driver
from sensworkbench.core.parameters import Logarithmic, Parameter
from sensworkbench.core.shapes import SHAPES, Shape, register
from sensworkbench.formats import machine_json

from .support import both, measured, scattered, session

NOISE, WIDTH, HEIGHT = 0.4e-3, 0.3, 30e-6


@pytest.fixture(scope="module")
def bell():
    """A shape that nothing else in the program knows; it is gone after the test."""

    @register
    class Bell(Shape):
        """exp(-(v/width)^2 / 2)"""

        name = "bell"
        width = Parameter(above=0.0, search=Logarithmic(2.5))

        def basis(self, v, t):
            return np.exp(-((v / self.width) ** 2) / 2)[:, None]

        @classmethod
        def scan(cls, seen):
            for name in seen.many_levels:
                if name.startswith("temp_"):
                    for part in (4, 8, 16, 32):
                        yield Driver((name,)), cls(width=seen.span(name) / part)

    yield Bell
    del SHAPES["bell"]


@pytest.fixture(scope="module")
def traced(bell):
    """(readings, the motion in them, the outcome of their trace)."""
    simulated, machine = both("XYFZ", (10, -20, -150))
    q, columns = scattered(400, 6), session(400, 6)
    motion = HEIGHT * np.exp(-((columns["temp_column"] / WIDTH) ** 2) / 2)
    readings = measured(simulated, q, {"EAZ": motion}, columns, NOISE, seed=6)
    return readings, motion, trace(machine, readings, seed=1)


def test_it_is_scanned(bell, traced):
    readings, _, _ = traced
    found = [r for r in bank(readings) if isinstance(r.shape, bell)]
    assert {str(r.driver) for r in found} == {"temp_column", "temp_ambient"} and len(found) == 8


def test_it_is_fitted_and_named(traced):
    _, motion, outcome = traced
    [effect] = outcome.machine.effects
    assert (effect.component, str(effect.driver), effect.shape.name) == ("EAZ", "temp_column", "bell")
    assert effect.shape.width == pytest.approx(WIDTH, rel=0.1)
    assert effect.coefficients[0] == pytest.approx(HEIGHT, rel=0.1)
    assert effect.shape_u["width"] < 0.1 * WIDTH
    assert "bell" in effect.name


def test_it_is_written_and_read(bell, traced):
    _, _, outcome = traced
    text = machine_json.dumps(outcome.machine)
    assert '"width"' in text and '"unit": "K"' in text
    [again] = machine_json.loads(text).effects
    assert again.shape == outcome.machine.effects[0].shape and isinstance(again.shape, bell)
    assert machine_json.dumps(machine_json.loads(text)) == text


def test_it_is_predicted(traced):
    readings, motion, outcome = traced
    again = machine_json.loads(machine_json.dumps(outcome.machine))
    with_, without = predict(again, readings), predict(again, readings, effects=False)
    assert again.effects[0].values(readings.columns) == pytest.approx(motion, abs=0.15 * HEIGHT)
    assert np.abs(with_ - without).max() > 5 * NOISE


def test_it_is_planned(bell, traced):
    readings, _, outcome = traced
    plan = planning.Plan(outcome.machine, planning.as_readings(readings, NOISE))
    assert any(isinstance(c.shape, bell) and not c.hidden for c in plan.candidates)
