# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every entry of a table and every limit on its edge, one by one: where a small fault would be seen by nothing else."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from sensworkbench.core import distributions, joints, objectives, shapes, shapley, unit_text, units, workspace
from sensworkbench.core.allocation import Grade, GradeCost, PowerCost
from sensworkbench.core.distributions import Tolerance
from sensworkbench.core.driver import Driver
from sensworkbench.core.effects import Effect
from sensworkbench.core.fitted import Constant, FittedModel, Series
from sensworkbench.core.machine import Machine, structure_chains
from sensworkbench.core.parameters import Evenly, Logarithmic, Reciprocal
from sensworkbench.core.refusal import Refused
from sensworkbench.core.shapes.base import Varying
from sensworkbench.core.shapes.functions import hysteresis, periods
from sensworkbench.core.shapes.memory import Hysteresis, Lag
from sensworkbench.core.shapes.plain import Linear, Polynomial, Power, Step
from sensworkbench.core.sources import Source
from sensworkbench.core.synthesis import exact_error, omega
from tests.core.support import c_frame, machine

ARC = math.pi / 180


# -- units -------------------------------------------------------------------------------------------------------------
LENGTHS = {"mm": 1, "um": 1e-3, "µm": 1e-3, "μm": 1e-3, "nm": 1e-6, "m": 1000, "cm": 10, "in": 25.4, "inch": 25.4}
ANGLES = {
    "rad": 1, "mrad": 1e-3, "urad": 1e-6, "µrad": 1e-6, "μrad": 1e-6, "nrad": 1e-9, "deg": ARC, "°": ARC,
    "arcmin": ARC / 60, "arcsec": ARC / 3600, "″": ARC / 3600, "um/m": 1e-6, "µm/m": 1e-6, "μm/m": 1e-6, "mm/m": 1e-3,
}  # fmt: skip
OTHERS = {
    "s": 1, "ms": 1e-3, "min": 60, "h": 3600, "K": 1, "C": 1, "°C": 1, "degC": 1, "F": 1 / 1.8, "°F": 1 / 1.8,
    "degF": 1 / 1.8, "kg": 1, "g": 1e-3, "lb": 0.45359237, "rpm": 1 / 60, "rps": 1, "Hz": 1, "1": 1,
}  # fmt: skip


def test_every_unit_of_length_and_angle_has_its_factor():
    assert units.LENGTH == pytest.approx(LENGTHS, rel=1e-15)
    assert units.ANGLE == pytest.approx(ANGLES, rel=1e-15)
    assert (units.um(2.5), units.mm(2.5)) == (2500.0, 0.0025)


def test_every_unit_in_words_has_its_factor_and_kind():
    want = LENGTHS | {k: v for k, v in ANGLES.items() if "/" not in k} | OTHERS
    assert {k: u.factor for k, u in unit_text.UNITS.items()} == pytest.approx(want, rel=1e-15)
    kinds = {"mm": "length", "arcsec": "angle", "h": "time", "degF": "temperature", "lb": "mass"}
    assert {k: dict(unit_text.UNITS[k].powers) for k in kinds} == {k: {v: 1.0} for k, v in kinds.items()}
    assert dict(unit_text.UNITS["rpm"].powers) == {"time": -1.0} and dict(unit_text.UNITS["1"].powers) == {}


@pytest.mark.parametrize(
    ("text", "wanted", "factor"),
    [("um/K", "mm/K", 1e-3), ("arcsec/F", "rad/K", ARC / 3600 * 1.8), ("m/min", "mm/s", 1000 / 60), ("1/rpm", "s", 60),
     ("um/m", "rad", 1e-6), ("mm^2", "um^2", 1e6)],
)  # fmt: skip
def test_units_are_converted(text, wanted, factor):
    assert unit_text.conversion(text, wanted) == pytest.approx(factor, rel=1e-12)


def test_a_unit_of_eighty_characters_is_read_and_one_of_eighty_one_is_not():
    text = "*".join(["1"] * 39) + "*mm"  # 80 characters
    assert len(text) == 80 and unit_text.conversion(text, "mm") == 1.0
    with pytest.raises(Refused):
        unit_text.conversion(text[:-2] + " mm", "mm")


def test_a_number_is_shown_by_its_neighbour_where_only_that_reads_back():
    values = np.random.default_rng(0).uniform(1e-4, 1e-2, 3000)
    shown = [units.exactly_shown(v, 1e-3) for v in values]
    assert all(s is None or s * 1e-3 == v for s, v in zip(shown, values))


# -- machine -----------------------------------------------------------------------------------------------------------
def joint(name, direction=(1, 0, 0)):
    return joints.rotary(name, direction, (0, 0, 0))


def test_six_joints_are_a_machine_and_seven_are_not():
    names = ["A", "B", "C", "A1", "B1", "C1", "A2"]
    for count, good in ((6, True), (7, False)):
        some = tuple(joint(n, (0, 0, 1)) for n in names[:count])
        if good:
            assert Machine("six", (), names[:count], some, (0, 0, 1)).structure == "F" + "".join(names[:6])
            assert structure_chains("F" + "".join(names[:6])) == ((), tuple(names[:6]))
        else:
            with pytest.raises(Refused, match="7 axes"):
                Machine("seven", (), names[:count], some, (0, 0, 1))
            with pytest.raises(Refused):
                structure_chains("F" + "".join(names[:7]))


@pytest.mark.parametrize("code", ["FXTZ", "FXXZ", "FW", "UFX", "FX1X1"])
def test_a_structure_code_with_a_taken_name_or_one_twice_is_refused(code):
    with pytest.raises(Refused):
        structure_chains(code)


def test_a_direction_of_a_thousandth_too_much_is_refused():
    joints.linear("X", (1.0009, 0, 0), (0, 0, 0), (0, 1))
    with pytest.raises(Refused):
        joints.linear("X", (1.0012, 0, 0), (0, 0, 0), (0, 1))


@pytest.mark.parametrize(
    ("primary", "secondary"), [("X", "Y"), ("Y", "Z"), ("Z", "X"), ("Y", "X"), ("Z", "Y"), ("X", "Z")]
)
def test_any_two_axes_can_define_the_frame(primary, secondary):
    leaning = {"X": (0.9998, 0.02, 0), "Y": (0.01, 0.99995, 0), "Z": (0, 0.02, 0.9998)}
    unit = {k: np.array(v) / np.linalg.norm(v) for k, v in leaning.items()}
    m = replace(machine("XYFZ", directions=unit), frame_axes=(primary, secondary), version=2)
    first, second = "XYZ".index(primary), "XYZ".index(secondary)
    assert_allclose(m.frame[:, first], unit[primary], atol=1e-15)
    assert_allclose(np.linalg.det(m.frame), 1.0, rtol=1e-14)
    assert_allclose(m.frame.T @ m.frame, np.eye(3), atol=1e-15)
    assert m.frame[:, second] @ unit[secondary] > 0.999
    third = 3 - first - second
    assert m.frame[:, third] @ np.eye(3)[third] > 0.99  # right-handed machines stay so
    assert abs(m.frame[:, third] @ unit[primary]) < 1e-15 and abs(m.frame[:, third] @ unit[secondary]) < 1e-15


def test_lever_arms_in_the_axes_of_the_file():
    turn = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1.0]])
    turned = {k: turn[:, i] for i, k in enumerate("XYZ")}
    m = machine("FXYZ", (10, 20, -150), {"X": (1, 2, 3)}, directions=turned)
    q = (5.0, 6.0, 7.0)
    tip = np.array([10, 20, -150]) + turn @ q
    file, own = (m.lever_arms(q, frame=f) for f in ("file", "machine"))
    assert_allclose(file["X"][0], tip - (np.array([1, 2, 3]) + turn[:, 0] * 5), atol=1e-12)
    assert_allclose(own["X"][0], turn.T @ file["X"][0], atol=1e-12)


def test_the_exact_product_turns_by_the_whole_angle():
    """A rotation of .3 rad about z at a lever of 100 mm, with the cosine that first order leaves out."""
    m = machine("FXYZ", (100, 0, 0))
    position, turn = exact_error(m, {"ECZ": 0.3}, (0, 0, 0))
    assert_allclose(position[0], [100 * (math.cos(0.3) - 1), 100 * math.sin(0.3), 0], atol=1e-12)
    assert_allclose(turn[0], [0, 0, math.sin(0.3)], atol=1e-12)


# -- tolerances and objectives -----------------------------------------------------------------------------------------
@pytest.mark.parametrize("ratio", [0.05, 0.5, 0.9, 0.99, 1.01, 1.5, 3.0])
def test_moments_of_a_truncated_normal_are_integrals_of_its_density(ratio):
    """ratio : half the width in standard deviations; the formula changes at 1."""
    law = Tolerance(-1.0, 3.0, "truncated_normal", 2.0 / ratio)
    nodes, weights = np.polynomial.legendre.leggauss(80)
    density = weights * np.exp(-((nodes * ratio) ** 2) / 2)
    density /= density.sum()
    want = [1.0, *((density * (2 * nodes) ** k).sum() for k in (2, 3, 4))]
    assert_allclose(law.moments, want, rtol=1e-13, atol=1e-15)


def test_limits_of_tolerances_and_weights_are_inclusive():
    assert Tolerance(-distributions.LARGEST, distributions.LARGEST).moments[0] == 0
    with pytest.raises(Refused):
        Tolerance(0, distributions.LARGEST * 1.0001)
    objectives.MeanSquare(weights=(objectives.LARGEST_WEIGHT, 1, 1))
    with pytest.raises(Refused):
        objectives.MeanSquare(weights=(objectives.LARGEST_WEIGHT * 1.0001, 1, 1))


def test_words_and_sizes_of_the_objectives():
    position, turn = objectives.MeanSquare(weights=(1, 2, 0)), objectives.Signed("orientation", (1, 0, -0.5))
    assert (position.formula, position.length_unit) == ("T4² + 2·T5²", "mm")
    assert (turn.formula, turn.length_unit) == ("R1 - 0.5·R3", "rad")
    assert position.size_shown(4e-6) == pytest.approx(2.0) and turn.size_shown(-3e-6) == pytest.approx(-3.0)
    assert objectives.MeanSquare("orientation").size_shown(4e-12) == pytest.approx(2.0)


@pytest.mark.parametrize("factor", [math.inf, math.nan, 2e6, -2e6])
def test_a_source_has_finite_and_plausible_factors(factor):
    Source("s", Tolerance(0, 1), {"EXX": 1e6})
    with pytest.raises(Refused):
        Source("s", Tolerance(0, 1), {"EXX": factor})


def test_an_orientation_objective_of_a_machine_on_which_nothing_turns_is_refused():
    shifts = {s: Tolerance(0, 0) for s in c_frame().all_tolerances} | {"EXX": Tolerance(-1e-3, 1e-3)}
    only = replace(c_frame(), tolerances=shifts)
    with pytest.raises(Refused):
        workspace.sensitivity(only, workspace.at(only, (0, 0, 0)), objectives.MeanSquare("orientation"))


def test_an_extent_that_is_not_finite_or_reversed_is_refused():
    for extent in ((0.0, math.inf), (-math.inf, 0.0), (math.nan, 1.0), (2.0, 1.0)):
        with pytest.raises(Refused):
            Effect("e", "EXX", "x", Linear(), (1.0,), extent=extent)
    assert Effect("e", "EXX", "x", Linear(), (1.0,), extent=(1.0, 1.0)).range == (1.0, 1.0)


def test_changed_fitted_errors_replace_the_old_ones_and_leave_the_rest():
    old = FittedModel(
        series={"EXX": Series((0, 1), (1.0,)), "EYX": Series((0, 1), (2.0,))},
        constants={"C0Y": Constant(3.0), "A0Z": Constant(4.0)},
    )
    new = old.with_errors({"EXX": Series((0, 2), (5.0,)), "B0Z": Constant(7.0), "A0Z": None})
    assert {k: v.coefficients for k, v in new.series.items()} == {"EXX": (5.0,), "EYX": (2.0,)}
    assert {k: v.value for k, v in new.constants.items()} == {"C0Y": 3.0, "B0Z": 7.0}
    assert new.values("EXX", [0.0, 1.0]).tolist() == [5.0, 5.0]
    assert new.values("B0Z", [0.0, 1.0]).tolist() == [7.0, 7.0] and new.values("EAX", [0.0]).tolist() == [0.0]


# -- positions ---------------------------------------------------------------------------------------------------------
def test_so_many_positions_and_no_more():
    m = c_frame()
    assert len(workspace.quadrature(m, (2000, 1000, 1)).q) == 2_000_000
    for counts in ((2001, 1, 1), (2000, 1001, 1)):
        with pytest.raises(Refused):
            workspace.quadrature(m, counts)
    with pytest.raises(Refused):
        workspace.low_discrepancy(m, 2_000_008)


def test_a_low_discrepancy_set_is_a_halton_set_in_shifted_copies():
    m = c_frame()
    found = workspace.low_discrepancy(m, 8 * 5)
    low, high = m.travel.T
    unit = (found.q - low) / (high - low)
    halton = {
        2: [1 / 2, 1 / 4, 3 / 4, 1 / 8, 5 / 8],
        3: [1 / 3, 2 / 3, 1 / 9, 4 / 9, 7 / 9],
        5: [0.2, 0.4, 0.6, 0.8, 0.04],
    }
    for axis, base in enumerate((2, 3, 5)):
        copies = unit[:, axis].reshape(8, 5)
        shift = (copies - halton[base]) % 1.0
        assert_allclose(shift, np.broadcast_to(shift[:, :1], shift.shape), atol=1e-12)
        assert len(np.unique(np.round(shift[:, 0], 9))) == 8
    assert ((unit >= 0) & (unit < 1)).all() and found.weights.sum() == pytest.approx(1.0)


def test_the_order_of_a_default_quadrature_fits_what_is_affordable():
    def of(linear, turning):
        some = [joints.linear(k, d, (0, 0, 0), (0, 100)) for k, d in zip("XYZ", np.eye(3))][:linear]
        some += [joints.rotary(k, (0, 0, 1), (0, 0, 0), (-1, 1)) for k in ("A", "B", "C", "A1", "B1", "C1")[:turning]]
        m = Machine("m", (), [j.name for j in some], tuple(some), (1, 2, 3))
        return workspace.default_order(m)

    assert of(3, 0) == (8, 8, 8) and of(2, 1) == (8, 8, 32)
    assert of(3, 1) == (8, 8, 8, 32)  # 8**3 * 32 = 16384, up to 40000
    assert of(3, 2) == (8, 8, 8, 8, 8)
    assert of(0, 3) == (32, 32, 32) and of(0, 4) == (12, 12, 12, 12)


def test_a_position_a_thousand_travels_away_is_refused():
    m = c_frame()  # X from -400 to 400
    workspace.at(m, (1.19e6, 0, 0))
    with pytest.raises(Refused):
        workspace.at(m, (1.21e6, 0, 0))
    assert workspace.at(m, (0, 0, 0)).counts == (1, 1, 1)


# -- shares ------------------------------------------------------------------------------------------------------------
def test_a_covariance_that_is_none_is_refused_with_its_place():
    good = np.diag([1.0, 2.0, 3.0])
    assert_allclose(shapley.checked_covariance(good, 3), good)
    skew = good.copy()
    skew[0, 2] = 0.5
    with pytest.raises(Refused) as refused:
        shapley.checked_covariance(skew, 3)
    assert {refused.value.fields["row"], refused.value.fields["column"]} == {1, 3}
    nearly = good.copy()
    nearly[0, 1], nearly[1, 0] = 0.5, 0.5 + 1e-10
    assert shapley.checked_covariance(nearly, 3)[0, 1] == pytest.approx(0.5 + 0.5e-10, abs=1e-14)
    assert shapley.checked_covariance(np.zeros((2, 2)), 2).tolist() == [[0, 0], [0, 0]]
    with pytest.raises(Refused):
        shapley.checked_covariance(np.array([[1, 0.9, 0.9], [0.9, 1, -0.9], [0.9, -0.9, 1]]), 3)


def test_thirteen_groups_are_too_many_for_shares():
    rng = np.random.default_rng(0)
    with pytest.raises(Refused):
        shapley.gaussian_shares(rng.normal(size=(3, 13)), np.zeros(13), np.eye(13), [[i] for i in range(13)])


def test_shares_where_nothing_varies_are_zero():
    found = shapley.gaussian_shares(np.ones((3, 2)), np.zeros(2), np.zeros((2, 2)), [[0], [1]])
    assert found.shares.tolist() == [[0, 0]] and found.variance.tolist() == [0] and found.total.tolist() == [[0, 0]]


# -- costs -------------------------------------------------------------------------------------------------------------
def test_costs_on_their_edges():
    PowerCost(0.0, 1.0, 0.5, 0.5)
    for wrong in ((-1, 1, 0.5, 1), (1, 0, 0.5, 1), (1, 1, 0, 1), (1, 1, 2, 1), (1, 1, 1, math.inf)):
        with pytest.raises(Refused):
            PowerCost(*wrong)
    grades = GradeCost((Grade("b", 2.0, 1.0), Grade("a", 1.0, 5.0)))
    assert [g.w for g in grades.grades] == [1.0, 2.0]
    for wrong in (Grade("c", 0.0, 1.0), Grade("c", math.inf, 1.0), Grade("c", 1.0, math.inf)):
        with pytest.raises(Refused):
            GradeCost((Grade("a", 1.0, 5.0), wrong))


# -- shapes and their searches -----------------------------------------------------------------------------------------
def test_where_parameters_are_searched():
    log = Logarithmic(2.0, starts=(0.01, 1.0, 3), longest=1.5)
    assert log.further_starts(100.0) == pytest.approx([1.0, 10.0, 100.0]) and Logarithmic(2.0).further_starts(1) == []
    assert np.exp(log.bounds(10.0, 1.0, None)) == pytest.approx([5.0, 20.0])
    assert np.exp(log.bounds(10.0, 1.0, 8.0)) == pytest.approx([5.0, 12.0])  # 1.5 spans of time at most
    assert np.exp(log.bounds(10.0, 1.0, 2.0)) == pytest.approx([5.0, 10.0])  # but not below the start
    assert log.step(10.0, 1.0) == pytest.approx(0.2)
    period = Reciprocal(0.5)
    assert period.forth(4.0) == 0.25 and period.bounds(10.0, 100.0, None) == pytest.approx((0.095, 0.105))
    assert period.step(10.0, 100.0) == pytest.approx(0.02)
    even = Evenly(0.5, 0.6, 0.25)
    assert even.bounds(2.0, 1, None) == (1.5, 2.6) and even.bounds(0.5, 1, None) == (0.25, 1.1)
    assert even.step(3.0, 1) == pytest.approx(0.06)


def test_parameters_on_their_edges():
    assert Power(exponent=20.0).exponent == 20.0
    with pytest.raises(Refused):
        Power(exponent=20.001)
    for tau in (0.0, -1.0, math.inf, "a"):
        with pytest.raises(Refused):
            Lag(tau=tau)
    for domain in (5, (1.0, 1.0), (2.0, 1.0), (1.0, 1.0 + 1e-10), (0.0, 1e-160), (1.0,), (1, 2, 3)):
        with pytest.raises(Refused):
            Polynomial(degree=2, domain=domain)
    assert Polynomial(degree=2, domain=(1.0, 1.0 + 1e-8)).domain == (1.0, 1.0 + 1e-8)
    with pytest.raises(Refused):
        Polynomial(degree=31, domain=(0.0, 1.0))
    assert Polynomial(degree=30, domain=(0.0, 1.0)).degree == 30


def test_periods_that_can_be_seen():
    regular = np.arange(0, 101, 5.0)  # every 5 mm over 100 mm
    found = periods(regular)
    assert found[0] == pytest.approx(250.0) and found[-1] == pytest.approx(10.0)
    assert len(found) == int((1 / 10 - 0.4 / 100) * 100 * 3)
    assert np.ptp(np.diff(1 / np.array(found))) < 1e-12  # evenly in frequency
    uneven = np.array([0, 3, 11, 20, 33, 50, 71, 100, 400.0])
    found = periods(uneven)
    assert found[0] == pytest.approx(320.0) and found[-1] == pytest.approx(2.5)
    assert len(found) == int((1 / 2.5 - 1.25 / 400) * 400 * 3)
    far = periods(np.cumsum(np.random.default_rng(0).uniform(1, 9, 3000)))  # a 300th of the span is the shortest
    assert far[0] / far[-1] == pytest.approx(300 / 1.25)
    assert len(periods(np.arange(3000.0))) == 900
    assert periods(np.arange(5.0)) == [] and len(periods(np.arange(6.0))) > 0


def test_play_starts_at_the_first_value():
    assert hysteresis([5.0, 5.0, 6.0, 9.0, 8.0], 1.0).tolist() == [0.0, 0.0, 1.0, 1.0, 0.0]
    assert hysteresis([], 1.0).tolist() == []


def test_the_range_of_a_shape_with_memory():
    assert Hysteresis(width=2.0).extremes((3.0,), 0.0, 1.0) == (-3.0, 3.0)
    assert Hysteresis(width=2.0).extremes((-3.0,), 0.0, 10.0) == (-6.0, 6.0)
    assert Lag(tau=1.0).extremes((2.0,), 1.0, 3.0) == (0.0, 6.0)


def varying(**columns):
    return Varying({k: np.asarray(v, dtype=float) for k, v in columns.items()}, list(columns))


def test_what_a_column_is():
    t = np.arange(20.0)
    seen = varying(x=t, two=t % 2, three=t % 3, many=t, jumps=(t * 7919) % 11, dir_x=np.sign(np.sin(t)), t=t)
    assert seen.two_level == {"two"} and seen.many_levels == ["x", "many", "jumps", "t"]
    assert seen.remembered == ["many"] and seen.places == ["x"] and seen.directions == ["dir_x"]


def found(cls, seen):
    return [(str(driver), shape) for driver, shape in cls.scan(seen)]


def test_what_is_scanned():
    t = np.arange(40.0)
    seen = varying(x=t, load=t % 3, temp_a=t**2, t=t, on=t % 2, dir_x=np.sign(np.sin(t)))
    linear = [d for d, _ in found(Linear, seen)]
    assert "x*x" in linear and "temp_a*temp_a" in linear and "on*on" not in linear and "dir_x" not in linear
    assert "dir_x*dir_x" not in linear and "load*load" in linear and "t*temp_a" not in linear
    steps = found(Step, seen)
    assert {d for d, _ in steps} == {"x", "t"}
    assert sum(d == "x" for d, _ in steps) == 23 and sum(d == "t" for d, _ in steps) == 47
    powers = found(Power, seen)
    assert {d for d, _ in powers} == {"temp_a", "t", "load"}
    assert [s.exponent for d, s in powers if d == "load"] == [0.5, 1.5, 2.0, 3.0]
    assert {(d, s.degree) for d, s in found(Polynomial, seen)} == {(d, n) for d in ("x", "temp_a", "t") for n in (2, 3)}
    widths = [s.width for d, s in found(Hysteresis, seen) if d == "x"]
    assert widths == pytest.approx([39 / 200, 39 / 50, 39 / 20, 39 / 8])
    lags = [s.tau for d, s in found(Lag, seen) if d == "temp_a"]
    assert lags == pytest.approx(np.geomspace(0.39, 58.5, 12))


def test_two_powers_of_one_column_are_a_polynomial_and_others_are_not():
    columns = {"x": np.array([-1.0, 3.0]), "y": np.array([0.0, 1.0])}
    driver, shape = Linear().joined(Driver(("x",)), Linear(), Driver(("x", "x")), columns)
    assert str(driver) == "x" and (shape.degree, shape.domain) == (2, (-1.0, 3.0))
    assert Linear().joined(Driver(("x",)), Linear(), Driver(("y",)), columns) is None
    assert Linear().joined(Driver(("x",)), Power(exponent=2.0), Driver(("x",)), columns) is None


def test_shapes_that_remember_are_those_with_memory():
    assert {n for n, s in shapes.SHAPES.items() if s.memory} == {"lag", "hysteresis"}


def test_columns_of_a_component_of_the_workpiece_and_tool_that_turns_nothing():
    m = machine("FXYZ")
    assert not omega(m, ["EXT", "EYW", "EXX"], (1, 2, 3), output="orientation").any()


# -- more of the machine -----------------------------------------------------------------------------------------------
def test_unit_twists():
    assert joints.linear("X", (0, 0.6, 0.8), (1, 2, 3), (0, 1)).twist.tolist() == [0, 0.6, 0.8, 0, 0, 0]
    assert joints.rotary("C", (0, 0, 1), (1, 2, 3)).twist.tolist() == [2, -1, 0, 0, 0, 1]  # p x u, u


def test_points_and_travels_on_their_edges():
    assert joints.vector((1e7, 0, 0), "") == (1e7, 0, 0)
    turns = 2 * math.pi * joints.MOST_TURNS
    assert joints.rotary("C", (0, 0, 1), (0, 0, 0), (0, turns)).travel == (0, turns)
    joints.linear("X", (1, 0, 0), (0, 0, 0), (-1e7, 1e7))
    for make in (
        lambda: joints.vector((1.0001e7, 0, 0), ""),
        lambda: joints.rotary("C", (0, 0, 1), (0, 0, 0), (0, turns + 6.3)),
        lambda: joints.linear("X", (1, 0, 0), (0, 0, 0), (-1.0001e7, 0)),
    ):
        with pytest.raises(Refused):
            make()
    assert joints.MOST_TURNS == 1000
    assert joints.rotary("C", (0, 0, 1), (0, 0, 0)).to_shown(math.pi) == pytest.approx(180)


@pytest.mark.parametrize(
    ("names", "frame", "letters"),
    [
        (("X", "X1"), None, (0, 1)),
        (("Y", "Y1"), None, (1, 0)),
        (("C", "X"), ("C", "X"), (1, 0)),
        (("X", "C"), ("X", "C"), (0, 1)),
    ],
)
def test_a_frame_of_joints_whose_letters_do_not_tell_takes_the_first_axis_that_is_free(names, frame, letters):
    some = tuple(
        (joints.rotary if n in "ABC" else joints.linear)(n, d, (0, 0, 0), (-1, 1)) for n, d in zip(names, np.eye(3))
    )
    m = Machine("m", (), names, some, (0, 0, 1), frame_axes=frame, version=2)
    for axis, direction in zip(letters, np.eye(3)):
        assert_allclose(m.frame[:, axis], direction, atol=1e-15)
    assert np.linalg.det(m.frame) == pytest.approx(1.0)


def test_values_and_aliases_of_components():
    m = c_frame()
    length, angle = m.component("EYX"), m.component("A0Z")
    assert (length.to_shown(0.002), angle.to_shown(3e-6)) == (2.0, pytest.approx(3.0))
    assert (length.from_shown(2.0), angle.from_shown(3.0)) == (0.002, pytest.approx(3e-6))
    aliases = {"delta_xx": "EXX", "DELTA_ZT": "EZT", "δ_yz": "EYZ", "epsilon_xz": "EAZ", "ε_yx": "EBX", "s_xy": "C0Y"}
    assert {k: m.component(k).symbol for k in aliases} == aliases
    with pytest.raises(Refused) as refused:
        m.component("EXQ")
    assert refused.value.fields["first"] == "EXX" and "C0Y" in refused.value.fields["lines"]


@pytest.mark.parametrize("name", ["", "  ", None, 5])
def test_a_source_has_a_name(name):
    with pytest.raises(Refused):
        Source(name, Tolerance(0, 1), {"EXX": 1.0})


def test_an_effect_holds_what_it_was_given():
    made = Effect("e", "EXX", "temp_a", Linear(), (2.0,), (0.5,), extent=(np.float64(1), 3), reach=[0, np.float64(2)])
    assert made.driver_unit == "K" and made.extent == (1.0, 3.0) and made.reach == (0.0, 2.0) and made.u == (0.5,)
    assert type(made.extent[0]) is float and type(made.u[0]) is float
    with pytest.raises(Refused):
        Effect("e", "EXX", "temp_a", Linear(), (2.0,), (0.5, 0.5))
    with pytest.raises(Refused):
        Effect("e", "EXX", "temp_a", Linear(), (2.0, 1.0))


# -- means over positions ----------------------------------------------------------------------------------------------
def test_means_and_largest_values_are_those_of_the_single_positions():
    m = replace(c_frame(), tolerances={"EXX": Tolerance(0, 0.02), "EAX": Tolerance(-1e-5, 4e-5, "triangular")})
    where = workspace.grid(m, (2, 3, 2))
    whole = workspace.sensitivity(m, where)
    each = [workspace.sensitivity(m, workspace.at(m, q)) for q in where.q]
    assert whole.estimated_error is None and len(each) == 12

    def table(key):
        return np.array([getattr(one, key) for one in each])

    for key in ("first", "total", "component_first", "component_total", "mean_square", "variance"):
        assert_allclose(getattr(whole, key), table(key).mean(axis=0), rtol=1e-12, atol=1e-16)
    assert_allclose(whole.total_max, table("total").max(axis=0), rtol=1e-12)
    assert_allclose(whole.component_total_max, table("component_total").max(axis=0), rtol=1e-12)
    v = table("variance")[:, None]
    for key, weighted in (("first", "first_vw"), ("total", "total_vw"), ("component_total", "component_total_vw")):
        assert_allclose(getattr(whole, weighted), (v * table(key)).sum(axis=0) / v.sum(), rtol=1e-12, atol=1e-16)


def test_estimated_errors():
    m = c_frame()
    assert workspace.sensitivity(m, workspace.quadrature(m, 1)).estimated_error is None
    found_ = workspace.sensitivity(m, workspace.quadrature(m, (3, 1, 1)))
    other = workspace.sensitivity(m, workspace.quadrature(m, (1, 1, 1)))
    assert found_.estimated_error == pytest.approx(np.abs(found_.total - other.total).max(), rel=1e-12)
    where = workspace.low_discrepancy(m, 80)
    found_ = workspace.sensitivity(m, where)
    copies = [
        workspace.sensitivity(m, workspace.Positions(q, np.full(10, 0.1), (10,), "grid")).total
        for q in where.q.reshape(8, 10, 3)
    ]
    assert found_.estimated_error == pytest.approx(3 * (np.std(copies, axis=0, ddof=1) / np.sqrt(8)).max(), rel=1e-9)


def test_a_position_has_a_value_per_joint():
    with pytest.raises(Refused):
        workspace.at(c_frame(), (1, 2))
    endless = Machine("t", ("C",), (), (joints.rotary("C", (0, 0, 1), (0, 0, 0)),), (100, 0, 0))
    turn = workspace.quadrature(endless, 4)
    assert_allclose(turn.q[:, 0], np.array([-3, -1, 1, 3]) * math.pi / 4, atol=1e-15)
    assert_allclose(turn.weights, 0.25)


def test_objectives_of_files():
    made = objectives.from_json({"name": "signed", "output": "orientation", "weights": [1, 0, -1]})
    assert made == objectives.Signed("orientation", (1.0, 0.0, -1.0)) and objectives.from_json(made.to_json()) == made
    for wrong in ({"name": "none"}, {"more": 1}, {"weights": [1, 2]}, {"weights": [1, -1, 0]}, {"output": "x"}):
        with pytest.raises(Refused):
            objectives.from_json(wrong)


def test_groups_that_are_no_partition_have_no_shares():
    for groups in ([[0], [1]], [[0, 1], [1, 2]], [[0, 1, 2, 3]]):
        with pytest.raises(Refused):
            shapley.gaussian_shares(np.ones((3, 3)), np.zeros(3), np.eye(3), groups)
    found_ = shapley.gaussian_shares(np.eye(3), np.zeros(3), np.diag([1.0, 4.0, 9.0]), [[i] for i in range(12)][:3])
    want = np.array([1.0, 16.0, 81.0])  # V(X²) of independent normal X is 2 sigma⁴
    assert_allclose(found_.shares[0], want / want.sum(), rtol=1e-12)
    assert_allclose(found_.total[0], want / want.sum(), rtol=1e-12)
    assert found_.variance[0] == pytest.approx(2 * want.sum()) and found_.mean[0] == pytest.approx(14.0)
