# SPDX-License-Identifier: LGPL-2.1-or-later
"""What holds for every machine: both kinds of joints in any order, 1 mm to 30 m, references up to a kilometre away."""

from __future__ import annotations

import itertools
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from sensworkbench.core import sobol, workspace
from sensworkbench.core.distributions import DISTRIBUTIONS, Tolerance, moments
from sensworkbench.core.joints import Joint, linear, rotary
from sensworkbench.core.machine import Machine
from sensworkbench.core.objectives import MeanSquare, Signed
from sensworkbench.core.synthesis import exact_error, omega, volumetric_error

MANY = settings(max_examples=60, deadline=None)
SEEDS = st.integers(0, 2**32 - 1)
NAMES = [
    ("X", "Y", "Z"),
    ("X", "Y", "Z", "C"),
    ("X", "Y", "Z", "A", "C"),
    ("X", "Y", "B"),
    ("Z", "X"),
    ("X", "Y", "Z", "X1"),
]
AXIS = {"X": 0, "Y": 1, "Z": 2, "A": 0, "B": 1, "C": 2, "X1": 0}


def random_machine(seed: int, laws: str = "even") -> Machine:
    """A right-handed machine.  laws : "even" (symmetric about zero), or "any"."""
    rng = np.random.default_rng(seed)
    names = NAMES[rng.integers(len(NAMES))]
    size = 10 ** rng.uniform(0, np.log10(30_000))
    far = size if rng.random() < 0.5 else 1e6
    joints = []
    for name in names:
        direction = np.eye(3)[AXIS[name]] + 0.02 * rng.uniform(-1, 1, 3)
        direction /= np.linalg.norm(direction)
        point = rng.uniform(-far, far, 3)
        if name in "ABC":
            joints.append(rotary(name, tuple(direction), tuple(point), (-1.5, 2.0)))
        else:
            low = rng.uniform(-size, 0)
            joints.append(linear(name, tuple(direction), tuple(point), (low, low + size)))
    order = list(rng.permutation(names))
    cut = rng.integers(len(order) + 1)
    m = Machine(
        "random", order[:cut], order[cut:], tuple(joints), tuple(rng.uniform(-size, size, 3)),
        tuple(rng.uniform(-size, size, 3)), tuple(rng.uniform(-size, size, 3)),
        squareness=str(rng.choice(["direction", "carried"])), version=2,
    )  # fmt: skip
    tolerances = {}
    for c in m.components:
        width = 10 ** rng.uniform(-1, 1) * (1e-5 if c.angular else 1e-5 * size)
        middle = 0.0 if laws == "even" else width * rng.uniform(-1, 1)
        law = str(rng.choice([d for d in DISTRIBUTIONS if d != "point"]))
        tolerances[c.symbol] = Tolerance(middle - width, middle + width, law)
    return replace(m, tolerances=tolerances)


def place(m: Machine, seed: int) -> np.ndarray:
    low, high = m.travel.T
    return np.random.default_rng(seed + 1).uniform(low, high, (1, len(m.names)))


def found(m: Machine, q, objective=MeanSquare()):
    return workspace.sensitivity(m, workspace.at(m, q), objective)


def same(one, other, rtol=1e-7, scale=1.0):
    for key in ("first", "total", "component_first", "component_total"):
        assert_allclose(getattr(one, key), getattr(other, key), rtol=rtol, atol=1e-10, err_msg=key)
    assert other.mean_square == pytest.approx(one.mean_square * scale**2, rel=rtol)
    assert other.variance == pytest.approx(one.variance * scale**4, rel=rtol)


def changed(m: Machine, points, directions=None, travels=None) -> Machine:
    """The machine with another place of every point, and other directions and travels of its joints."""
    directions, travels = directions or {}, travels or {}
    joints = tuple(
        Joint(j.name, j.kind, tuple(directions.get(j.name, j.direction)), tuple(points(j.point)),
              travels.get(j.name, j.travel)) for j in m.joints
    )  # fmt: skip
    ends = {k: tuple(points(getattr(m, k))) for k in ("tool_point", "spindle_reference", "workpiece_reference")}
    return replace(m, joints=joints, **ends)


@MANY
@given(SEEDS)
def test_nothing_depends_on_where_the_machine_stands(seed):
    m = random_machine(seed, "any")
    q = place(m, seed)
    turn = Rotation.random(random_state=seed % 2**31).as_matrix()
    shift = np.random.default_rng(seed).uniform(-1e4, 1e4, 3)
    other = changed(m, lambda p: turn @ np.array(p) + shift, {j.name: turn @ np.array(j.direction) for j in m.joints})
    if len([j for j in m.joints if j.slides]) >= 2:  # else the frame is that of the file, which does not turn
        same(found(m, q), found(other, q), rtol=1e-6)


@MANY
@given(SEEDS)
def test_no_joint_needs_to_count_in_a_certain_direction(seed):
    m = random_machine(seed)
    q = place(m, seed)
    before = found(m, q)
    for i, j in enumerate(m.joints):
        low, high = j.travel
        other = changed(m, lambda p: p, {j.name: -np.array(j.direction)}, {j.name: (-high, -low)})
        there = q.copy()
        there[0, i] *= -1
        same(before, found(other, there))


@MANY
@given(SEEDS, st.floats(-3, 3))
def test_the_unit_of_length_does_not_matter(seed, power):
    m = random_machine(seed, "any")
    q, scale = place(m, seed), 10.0**power
    if max(max(abs(v) for v in j.point) for j in m.joints) * scale > 5e6:
        scale = 1 / scale
    longer = changed(
        m, lambda p: scale * np.array(p), None,
        {j.name: tuple(scale * v for v in j.travel) for j in m.joints if j.slides},
    )  # fmt: skip
    laws = {
        s: t if m.component(s).angular else Tolerance(t.lower * scale, t.upper * scale, t.distribution)
        for s, t in m.tolerances.items()
    }
    there = q * [scale if j.slides else 1.0 for j in m.joints]
    same(found(m, q), found(replace(longer, tolerances=laws), there), scale=scale)


@MANY
@given(SEEDS)
def test_indices_of_independent_errors_are_ordered_and_add_up(seed):
    m = random_machine(seed, "any")
    matrix = omega(m, list(m.tolerances), place(m, seed))
    rng = np.random.default_rng(seed)
    some = np.sort(rng.choice(len(m.tolerances), 8, replace=False))
    matrix, laws = matrix[:, :, some], moments([list(m.tolerances.values())[i] for i in some])
    if not (matrix**2 @ laws.var).sum() > 0:
        return
    weights = rng.uniform(0.1, 2, 3)
    one = sobol.indices(matrix, laws, weights)
    assert (one.first <= one.total + 1e-12).all() and (one.first >= -1e-12).all() and (one.total <= 1 + 1e-12).all()
    pairs = list(itertools.combinations(range(8), 2))
    two = sobol.group_indices(matrix, laws, pairs, weights).first[0]
    interactions = [v - one.first[0, i] - one.first[0, j] for v, (i, j) in zip(two, pairs)]
    assert min(interactions) > -1e-12
    assert one.first.sum() + sum(interactions) == pytest.approx(1.0, abs=1e-11)
    nested = [list(range(k)) for k in range(1, 9)]
    grown = sobol.group_indices(matrix, laws, nested, weights)
    assert (np.diff(grown.first[0]) > -1e-12).all() and (np.diff(grown.total[0]) > -1e-12).all()
    assert grown.first[0, -1] == pytest.approx(1.0, abs=1e-12) == grown.total[0, -1]
    rest = [[i for i in range(8) if i not in g] for g in nested[:-1]]
    others = sobol.group_indices(matrix, laws, rest, weights)
    assert_allclose(grown.total[0, :-1], 1 - others.first[0], atol=1e-11)  # the definition of the total index


@MANY
@given(SEEDS, st.booleans())
def test_shares_add_up_to_one(seed, signed):
    m = random_machine(seed, "any")
    here = found(m, place(m, seed), Signed(weights=(1, -0.5, 0.25)) if signed else MeanSquare())
    assert here.share.sum() == pytest.approx(1.0, abs=1e-10)
    assert here.component_share.sum() == pytest.approx(1.0, abs=1e-10)
    assert (here.share >= -1e-12).all()


@MANY
@given(SEEDS)
def test_the_exact_product_differs_by_second_order_only(seed):
    """Twice the errors, four times the difference: what is left of the first order would double only."""
    m = random_machine(seed)
    q, rng = place(m, seed), np.random.default_rng(seed)
    reach = 1 + max(np.abs(arm).max() for arm in m.lever_arms(q).values()) + np.abs(q).max()
    errors = {c.symbol: rng.uniform(-1, 1) * (1e-4 if c.angular else 1e-4 * reach) for c in m.components}

    def left(scale):
        values = {s: scale * v for s, v in errors.items()}
        position, turn = exact_error(m, values, q)
        return np.hstack([
            (position - volumetric_error(m, values, q)) / reach,
            turn - volumetric_error(m, values, q, output="orientation"),
        ])  # fmt: skip

    once, twice = left(1.0), left(2.0)
    assert_allclose(twice, 4 * once, atol=2e-9)  # third order: (44 errors of 2e-4) cubed, and rounding
    assert np.abs(once).max() < (len(errors) * 1e-4) ** 2
