# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of ISO 230-2, -3, -4 and -6 against numbers worked by hand."""

from __future__ import annotations

import numpy as np
import pytest

from sensworkbench.closedloop.readings import Readings
from sensworkbench.studies.iso230 import circles, circular, drift, fixed_place, lines, positioning

# five targets, two approaches from each side, um: mean +- 1 (so s = sqrt(2)); up to the right of the axis
UP = [(1, 3), (2, 4), (3, 5), (4, 6), (5, 7)]  # means 2 3 4 5 6
DOWN = [(0, 2), (-1, 1), (-2, 0), (1, 3), (2, 4)]  # means 1 0 -1 2 3
PLACES = [0.0, 100.0, 200.0, 300.0, 400.0]


def approaches():
    rows = [(x, v, 1) for x, own in zip(PLACES, UP) for v in own]
    rows += [(x, v, -1) for x, own in zip(PLACES, DOWN) for v in own]
    return (np.array(c, dtype=float) for c in zip(*rows))


def test_positioning_by_hand():
    """B_i = 1 3 5 3 3; E = 6 - (-1); R_i = 4 s = 5.657, and 2 s + 2 s + |B_i| = 5.657 + 5 at the third; A = 7 + 4 s."""
    x, v, side = approaches()
    found = positioning(x, v * 1e-3, side)
    four_s = 4 * np.sqrt(2) * 1e-3
    assert (found.targets, found.runs, found.bidirectional) == (5, 2, True)
    assert found.reversal == pytest.approx(5e-3) and found.mean_reversal == pytest.approx(3e-3)
    assert found.systematic == pytest.approx(7e-3) and found.mean_systematic == pytest.approx(3e-3)
    assert found.repeatability == pytest.approx(four_s + 5e-3)
    assert found.accuracy == pytest.approx(7e-3 + four_s)


def test_positioning_from_one_side_has_no_reversal_and_single_runs_no_repeatability():
    x, v, side = approaches()
    one = side > 0
    found = positioning(x[one], v[one] * 1e-3, side[one])
    assert found.reversal is None and found.systematic == pytest.approx(4e-3)
    assert found.repeatability == pytest.approx(4 * np.sqrt(2) * 1e-3)
    single = positioning(PLACES, np.arange(5) * 1e-3, np.ones(5))
    assert single.accuracy is None and single.repeatability is None and single.systematic == pytest.approx(4e-3)
    assert positioning(PLACES[:4], np.arange(4) * 1e-3, np.ones(4)) is None


def test_a_line_and_a_diagonal_are_found_among_readings():
    """Out and back twice with overrun; the deviation rises 1 um per 100 mm, plus 4 um on the way back."""
    for way in (np.array([1.0, 0, 0]), np.array([0.6, 0.8, 0.0])):
        stops = np.array([-50, 0, 100, 200, 300, 400, 450, 400, 300, 200, 100, 0] * 2, dtype=float)
        q = stops[:, None] * way
        back = np.r_[False, np.diff(stops) < 0]
        error = (stops * 1e-5 + 4e-3 * back)[:, None] * way
        [line] = lines(Readings.from_vectors(q, error))
        assert line.diagonal == (way[1] > 0) and line.direction == pytest.approx(tuple(way))
        figures = line.figures
        assert figures.targets == 5 and figures.bidirectional and figures.runs == 2
        assert figures.reversal == pytest.approx(4e-3) and figures.repeatability == pytest.approx(4e-3)
        assert figures.systematic == figures.accuracy == pytest.approx(8e-3)
    assert lines(Readings.from_vectors(np.random.default_rng(0).uniform(-1, 1, (50, 3)), np.zeros((50, 3)))) == []


def test_a_reading_across_the_line_is_no_positioning():
    q = np.zeros((14, 3))
    q[:, 0] = np.arange(14) * 10.0
    across = np.full((14, 3), np.nan)
    across[:, 1] = 1e-3
    assert lines(Readings.from_vectors(q, across)) == []


def test_circle_by_hand():
    """An ellipse of 10 um between its axes, 3 um eccentric: G leaves the eccentricity out, F holds it."""
    angle = np.linspace(0, 2 * np.pi, 360, endpoint=False)
    radial = 5e-3 * np.cos(2 * angle) + 3e-3 * np.cos(angle)
    found = circular(angle, radial, np.ones(360), 100.0)
    assert found.deviation[1] == pytest.approx(10e-3, rel=1e-3)
    assert found.most == pytest.approx(8e-3)
    q = np.stack([100 * np.cos(angle), 100 * np.sin(angle), np.full(360, 7.0)], axis=1)
    error = radial[:, None] * np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    [again] = circles(Readings.from_vectors(q, error))
    assert again.radius == pytest.approx(100.0) and again.deviation[1] == pytest.approx(10e-3, rel=1e-3)


def test_drift_by_hand():
    t = np.arange(0, 7201, 600.0)
    found = drift(t, t * 1e-6, np.full(len(t), "z"))
    assert found.hours == 2.0 and found.whole == {"z": pytest.approx(7.2e-3)}
    assert found.first_hour == {"z": pytest.approx(3.6e-3)}
    still = Readings.from_vectors(
        np.zeros((13, 3)), np.outer(t * 1e-6, [0, 0, 1.0]), {**dict(zip("xyz", np.zeros((3, 13)))), "t": t}
    )
    assert fixed_place(still).whole["z"] == pytest.approx(7.2e-3)
