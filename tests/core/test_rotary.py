# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machines with rotary joints: Omega against central differences of an exact matrix product that is written here.

The product follows the definition of SPEC section 6 with 4x4 matrix exponentials and knows nothing of the package but
the machine's data.  Errors of a workpiece-side joint are of the tool relative to the workpiece; axis lines are
displaced physically.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.linalg import expm

from sensworkbench.core import synthesis, workspace
from sensworkbench.core.distributions import Tolerance
from sensworkbench.core.joints import Joint, linear, rotary
from sensworkbench.core.machine import Machine
from sensworkbench.core.refusal import Refused
from tests.core.support import UM, URAD

TRAVEL = {"X": (-300.0, 300.0), "Y": (-200.0, 200.0), "Z": (-250.0, 50.0)}
E = np.eye(3)


def unit(v):
    return tuple(np.asarray(v, dtype=float) / np.linalg.norm(v))


def machine(code, rotaries, **more) -> Machine:
    """X, Y, Z, a little out of square, and rotary joints `name -> (direction, point)`; F stands for the bed."""
    rng = np.random.default_rng(len(code))
    joints = [
        linear(k, unit(E[i] + 0.01 * rng.uniform(-1, 1, 3)), rng.uniform(-400, 400, 3), TRAVEL[k])
        for i, k in enumerate("XYZ")
    ]
    joints += [rotary(k, unit(u), p, (-2.0, 2.0)) for k, (u, p) in rotaries.items()]
    table, tool = code.split("F")
    return Machine(
        code, tuple(reversed(table)), tuple(tool), joints, (20.0, -10.0, 150.0),
        spindle_reference=(5.0, 3.0, 260.0), workpiece_reference=(-40.0, 25.0, -60.0), **more,
    )  # fmt: skip


LAYOUTS = {
    "table-table": ("CAFXYZ", {"A": (E[0], (3, 40, -30)), "C": (E[2], (-15, 10, 0))}),
    "head-head": ("XFYZCB", {"C": (E[2], (10, -20, 300)), "B": (E[1], (12, 0, 280))}),
    "head-table": ("CXFYZB", {"C": (E[2], (-30, 10, 0)), "B": (E[1], (0, 5, 250))}),
    "skewed axes": ("CBFXYZ", {"B": ((0, 1, 1), (5, -20, 10)), "C": ((0.1, -0.05, 1), (0, 30, 0))}),
    "table on the tool side of nothing": ("ZYXCAF", {"A": (E[0], (0, 0, -50)), "C": (E[2], (20, 0, 0))}),
    "inclined head": ("YXFZCA", {"C": (E[2], (0, 0, 300)), "A": ((1, 0, 1), (10, -5, 270))}),
}
CONVENTIONS = ("direction", "carried")


# -- the exact product, from the definition --------------------------------------------------------------------------
def hat(twist):
    v, w = twist[:3], twist[3:]
    return np.array([[0, -w[2], w[1], v[0]], [w[2], 0, -w[0], v[1]], [-w[1], w[0], 0, v[2]], [0, 0, 0, 0]])


def move(twist):
    return expm(hat(np.asarray(twist, dtype=float)))


def turn_about(point, w):
    return np.concatenate([np.cross(point, w), w])


def exact_pose(m: Machine, errors, q):
    """Pose of the tool in the workpiece; errors : (body, "motion" or "line") -> (6,) shift and turn in frame axes."""
    frame = m.frame
    value = dict(zip(m.names, q))
    nothing = np.zeros(6)

    def displacement(e, point):  # turn about the point, and shift, written in the axes of the frame
        shift, turn = frame @ e[:3], frame @ e[3:]
        return move([*shift, 0, 0, 0]) @ move(turn_about(point, turn))

    def chain(names, side, end, reference):
        pose = np.eye(4)
        for name in names:
            j = m.joint(name)
            u, p = np.array(j.direction), np.array(j.point)
            twist = np.concatenate([np.cross(p, u), u]) if j.unit == "deg" else np.concatenate([u, np.zeros(3)])
            step = move(side * value[name] * twist)
            line = displacement(errors.get((name, "line"), nothing), p)
            now = (step @ [*p, 1])[:3]
            motion = displacement(errors.get((name, "motion"), nothing), now)
            if side < 0:  # of the tool relative to the table: the table moves the other way
                motion = np.linalg.inv(motion)
            true = line @ step if m.squareness == "carried" else line @ step @ np.linalg.inv(line)
            pose = pose @ motion @ true
        end_motion = displacement(errors.get((end, "motion"), nothing), np.array(reference))
        return pose @ (end_motion if side > 0 else np.linalg.inv(end_motion))

    workpiece = chain(m.workpiece_chain, -1, "W", m.workpiece_reference)
    tool = chain(m.tool_chain, 1, "T", m.spindle_reference)
    return np.linalg.inv(workpiece) @ tool


def difference(m: Machine, c, q, step):
    """(T, R) central difference of the exact product in one component."""
    which = (c.body, "line" if c.line else "motion")
    poses = []
    for sign in (1, -1):
        e = np.zeros(6)
        e[c.axis + (3 if c.angular else 0)] = sign * step
        poses.append(exact_pose(m, {which: e}, q))
    tip = np.array([*m.tool_point, 1.0])
    nominal = exact_pose(m, {}, q)
    turn = (poses[0] - poses[1])[:3, :3] @ nominal[:3, :3].T / (2 * step)
    position = m.frame.T @ ((poses[0] - poses[1]) @ tip)[:3] / (2 * step)
    return position, m.frame.T @ np.array([turn[2, 1], turn[0, 2], turn[1, 0]])


@pytest.mark.parametrize("convention", CONVENTIONS)
@pytest.mark.parametrize("layout", LAYOUTS)
def test_omega_is_the_derivative_of_the_exact_product(layout, convention):
    m = machine(*LAYOUTS[layout], squareness=convention)
    rng = np.random.default_rng(5)
    low, high = m.travel.T
    q = low + (high - low) * rng.random((3, 5))
    symbols = [c.symbol for c in m.components]
    found = {output: synthesis.omega(m, symbols, q, output=output) for output in ("position", "orientation")}
    for i, c in enumerate(m.components):
        for p in range(len(q)):
            # the step's own error: third order, (1e-4)² of the lever of a metre, plus rounding of a metre over 1e-4
            position, orientation = difference(m, c, q[p], 1e-4)
            assert_allclose(found["position"][p, :, i], position, atol=5e-6, err_msg=c.symbol)
            assert_allclose(found["orientation"][p, :, i], orientation, atol=1e-8, err_msg=c.symbol)
    assert np.abs(found["position"]).max() > 100


@pytest.mark.parametrize("convention", CONVENTIONS)
@pytest.mark.parametrize("layout", LAYOUTS)
def test_the_library_product_is_that_product_to_second_order_and_omega_its_first(layout, convention):
    m = machine(*LAYOUTS[layout], squareness=convention)
    rng = np.random.default_rng(6)
    q = np.array([[120.0, -80.0, -50.0, 0.7, -1.1]])
    values = {c.symbol: rng.normal() * (20 * URAD if c.angular else 5 * UM) for c in m.components}
    exact, turned = synthesis.exact_error(m, values, q)
    first = synthesis.volumetric_error(m, values, q)
    assert_allclose(exact, first, atol=5e-6)  # 2 nm on usual machines; here all errors at once, with levers of 600 mm
    assert_allclose(turned, synthesis.volumetric_error(m, values, q, output="orientation"), atol=1e-8)
    errors = {}
    for symbol, value in values.items():
        c = m.component(symbol)
        errors.setdefault((c.body, "line" if c.line else "motion"), np.zeros(6))[c.axis + 3 * c.angular] = value
    tip = np.array([*m.tool_point, 1.0])
    position = m.frame.T @ ((exact_pose(m, errors, q[0]) - exact_pose(m, {}, q[0])) @ tip)[:3]
    assert_allclose(exact[0], position, atol=1e-6)  # the order of turn and shift within a body is second order


# -- names ------------------------------------------------------------------------------------------------------------
def test_line_errors_have_the_names_of_iso_230_7():
    m = machine(*LAYOUTS["table-table"])
    assert {"X0C", "Y0C", "A0C", "B0C", "Y0A", "Z0A", "B0A", "C0A", "C0Y", "A0Z", "B0Z"} == set(m.line_symbols)
    assert len(m.components) == 6 * 7 + 3 + 8
    assert str(m.component("E_X0C").title) == "axis position of C along X"
    assert str(m.component("EAC").title) == "tilt of C about X" and str(m.component("ECC").title) == "roll of C about Z"
    assert (m.component("X0C").unit, m.component("A0C").unit) == ("um", "urad")


def test_an_inclined_axis_is_named_by_the_earliest_of_its_nearest_frame_axes():
    joints = [linear(k, E[i], (0, 0, 0), TRAVEL[k]) for i, k in enumerate("XYZ")]
    m = Machine("m", ("B",), ("X", "Y", "Z"), [*joints, rotary("B", unit((0, 1, 1)), (0, 0, 0))], (0, 0, 0))
    assert {s for s in m.line_symbols if s.endswith("B")} == {"X0B", "Z0B", "A0B", "C0B"}  # nearest: Y


def test_the_frame_follows_the_letters_of_the_joints_that_define_it():
    """A lathe: X primary, Z secondary; z stays along Z, and the squareness of Z to X is left as B0Z."""
    lathe = Machine(
        "lathe", (), ("Z", "X"),
        [linear("X", (0, 0, 1), (0, 0, 0), (0, 100)), linear("Z", (1, 0, 0), (0, 0, 0), (0, 400))], (0, 0, 0),
    )  # fmt: skip
    assert_allclose(lathe.directions["X"], (1, 0, 0), atol=1e-15)
    assert_allclose(lathe.directions["Z"], (0, 0, 1), atol=1e-15)
    assert np.linalg.det(lathe.frame) == pytest.approx(1)
    assert lathe.line_symbols == ("B0Z",) and lathe.structure == "FZX"
    assert [str(c.title) for c in lathe.components if c.symbol in ("EXX", "EZZ")] == [
        "positioning of X", "positioning of Z",
    ]  # fmt: skip


def test_a_stated_frame_exchanges_what_is_an_error_and_what_defines():
    joints = [linear(k, E[i], (0, 0, 0), (0, 100)) for i, k in enumerate("XYZ")]
    m = Machine("m", (), ("X", "Y", "Z"), joints, (0, 0, 0), frame_axes=("Z", "X"))
    assert set(m.line_symbols) == {"B0X", "A0Y", "C0Y"}
    with pytest.raises(Refused) as refused:
        Machine("m", (), ("X", "Y", "Z"), joints, (0, 0, 0), frame_axes=("Z", "C"))
    assert refused.value.code == "frame-axes-unknown"


@pytest.mark.parametrize(
    "name, code",
    [("T", "joint-name-taken"), ("U", "joint-name-taken"), ("x", "joint-name-invalid"), ("X12", "joint-name-invalid")],
)
def test_names_that_are_taken_or_no_names(name, code):
    with pytest.raises(Refused) as refused:
        rotary(name, (0, 0, 1), (0, 0, 0))
    assert refused.value.code == code


def test_a_linear_joint_is_not_endless_and_a_kind_is_known():
    with pytest.raises(Refused):
        Joint("X", "linear", (1, 0, 0), (0, 0, 0), None)
    with pytest.raises(Refused) as refused:
        Joint("X", "screw", (1, 0, 0), (0, 0, 0), (0, 1))
    assert refused.value.code == "joint-kind-unknown"


# -- closed forms -----------------------------------------------------------------------------------------------------
def table(**more):
    return Machine("rotary table", ("C",), (), [rotary("C", (0, 0, 1), (0, 0, 0))], (100.0, 0.0, 50.0), **more)


def test_a_rotary_table_alone_moves_its_error_once_a_turn():
    """The axis lies 10 um off in x: seen from the table the error is (1 - R(-q))ᵀ-like, a circle through the origin."""
    m = table()
    angles = np.linspace(-math.pi, math.pi, 7)[:, None]
    found = synthesis.omega(m, ["X0C"], angles)[:, :, 0]
    assert_allclose(np.linalg.norm(found, axis=1), 2 * np.abs(np.sin(angles[:, 0] / 2)), atol=1e-12)
    # axial motion of the table is an axial error at every angle, and a tilt shows by the radius
    assert_allclose(synthesis.omega(m, ["EZC"], angles)[:, :, 0], np.tile([0, 0, 1], (7, 1)), atol=1e-12)


def test_positions_over_the_workpiece_follow_the_table():
    """With the table turned by +90 degrees (it moves by -q) a fixed tool at x = 100 is over another place of it."""
    place = table().tool_position(np.array([[math.pi / 2]]))[0]
    assert_allclose(place, (0, 100, 50), atol=1e-12)


def test_tolerances_of_rotary_joints_are_zero_unless_stated():
    m = machine(*LAYOUTS["table-table"])
    assert not any(m.component(s).body in "AC" for s in m.all_tolerances)
    some = Machine(**{**vars_of(m), "tolerances": {"A0C": Tolerance(-20 * URAD, 20 * URAD)}})
    assert "A0C" in some.all_tolerances and "EAC" not in some.all_tolerances


def vars_of(m):
    return {f: getattr(m, f) for f in m.__dataclass_fields__}


# -- workspace --------------------------------------------------------------------------------------------------------
def test_five_joints_use_quadrature_and_six_a_low_discrepancy_set_that_states_its_error():
    five = Machine(**{**vars_of(machine(*LAYOUTS["table-table"])), "tolerances": {"A0C": Tolerance(-1e-4, 1e-4)}})
    assert workspace.default_positions(five).counts == (8,) * 5
    six = machine("CAFXYZB", {"A": (E[0], (0, 0, 0)), "C": (E[2], (0, 0, 0)), "B": (E[1], (0, 0, 200))})
    positions = workspace.default_positions(six)
    assert positions.kind == "low_discrepancy" and positions.q.shape == (positions.counts[0], 6)
    found = workspace.sensitivity(six, positions)
    exact = workspace.sensitivity(six, workspace.quadrature(six, 6), estimate=False)
    assert 0 < found.estimated_error < 2e-3
    assert np.abs(found.total - exact.total).max() <= found.estimated_error


def test_an_endless_table_is_integrated_to_many_digits_in_equal_steps():
    """What repeats itself after a turn converges faster than any power: 32 steps where Gauss needs hundreds."""
    m = table(tolerances={s: Tolerance(-5 * UM, 5 * UM) for s in ("X0C", "Y0C", "EZC")})
    found = workspace.sensitivity(m)
    exact = workspace.sensitivity(m, workspace.quadrature(m, 512), estimate=False)
    assert found.positions.counts == (32,)
    assert np.abs(found.total - exact.total).max() <= max(found.estimated_error, 1e-13) < 1e-6


def test_low_discrepancy_agrees_with_quadrature_on_a_machine_that_both_can_do():
    m = machine("XYFZ", {})
    sampled = workspace.sensitivity(m, workspace.low_discrepancy(m))
    exact = workspace.sensitivity(m, workspace.quadrature(m, 8))
    assert np.abs(sampled.total - exact.total).max() <= sampled.estimated_error < 1e-3
