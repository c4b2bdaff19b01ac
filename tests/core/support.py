# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machines to test with, and the slow, obvious references that the fast formulas are held against.

The references are written from the definitions (an explicit matrix A; homogeneous matrices from matrix exponentials),
never from the code under test.
"""

from __future__ import annotations

import itertools

import numpy as np
from scipy.linalg import expm

from sensworkbench.core.distributions import Moments, Tolerance
from sensworkbench.core.errors import AXES
from sensworkbench.core.joints import linear
from sensworkbench.core.machine import Machine, structure_chains

UM, URAD = 1e-3, 1e-6
CONVENTIONS = ("direction", "carried")
CHAINS = [  # every serial chain of three axes: 6 orders x 4 places of the bed
    "".join(order[:split]) + "F" + "".join(order[split:])
    for order in itertools.permutations(AXES)
    for split in range(4)
]
TRAVEL = {"X": (-300.0, 300.0), "Y": (-200.0, 200.0), "Z": (-250.0, 50.0)}


def machine(
    code="FXYZ",
    tool_point=(0.0, 0.0, -150.0),
    references=None,
    squareness="direction",
    directions=None,
    travel=None,
    **more,
) -> Machine:
    """A machine from its structure code; references at 0 and square axes unless said."""
    references, travel = references or {}, travel or TRAVEL
    directions = dict(zip(AXES, np.eye(3))) | (directions or {})
    workpiece_chain, tool_chain = structure_chains(code)
    axes = {k: linear(k, tuple(directions[k]), references.get(k, (0.0, 0.0, 0.0)), travel[k]) for k in AXES}
    return Machine(code, workpiece_chain, tool_chain, axes, tool_point, squareness=squareness, **more)


def c_frame(**changes) -> Machine:
    """A vertical machining centre with a C frame: table X on saddle Y, head Z on the column behind the table."""
    return machine(
        **{
            "code": "XYFZ",
            "tool_point": (0, 0, -150),
            "references": {"X": (0, 0, -500), "Y": (0, 0, -700), "Z": (0, 500, 200)},
            "travel": {"X": (-400, 400), "Y": (-250, 250), "Z": (-500, 0)},
        }
        | changes
    )


def random_machine(rng, code: str, squareness: str, skew_deg=3.0) -> Machine:
    """Random references, tool point and fixture; axes a little out of square."""
    directions = {}
    for k, u in zip(AXES, np.eye(3)):
        tilted = u + np.radians(skew_deg) / 4 * rng.uniform(-1, 1, 3)
        directions[k] = tilted / np.linalg.norm(tilted)
    return machine(
        code,
        tool_point=rng.uniform(-200, 200, 3),
        references={k: rng.uniform(-400, 400, 3) for k in AXES},
        squareness=squareness,
        directions=directions,
        spindle_reference=rng.uniform(-200, 200, 3),
        workpiece_reference=rng.uniform(-200, 200, 3),
    )


def turned(machine: Machine, rotation, shift) -> Machine:
    """The same machine standing elsewhere: every point and direction turned by `rotation` and shifted."""
    from dataclasses import replace

    def point(p):
        return tuple(rotation @ np.array(p) + shift)

    joints = [
        replace(a, direction=tuple(rotation @ np.array(a.direction)), point=point(a.point)) for a in machine.joints
    ]
    spindle, fixture = machine.spindle_reference, machine.workpiece_reference
    return replace(
        machine,
        joints=joints,
        tool_point=point(machine.tool_point),
        spindle_reference=None if spindle is None else point(spindle),
        workpiece_reference=point((0.0, 0.0, 0.0) if fixture is None else fixture),
    )


# -- the exact product of matrices, from matrix exponentials --
def _shift(d):
    out = np.eye(4)
    out[:3, 3] = d
    return out


def _turn(e, about=(0.0, 0.0, 0.0)):
    generator = np.zeros((4, 4))
    generator[:3, :3] = [[0, -e[2], e[1]], [e[2], 0, -e[0]], [-e[1], e[0], 0]]
    about = np.asarray(about)
    return _shift(about) @ expm(generator) @ _shift(-about)


def matrix_product_error(m: Machine, values, q, tool_offset=(0.0, 0.0, 0.0)):
    """(T, R): error of the functional point (mm) and of the orientation (rad) at one position, by matrices.

    For machines whose frame is that of the file.  ISO signs: errors are of the tool against the workpiece, so a
    table-side carriage that shows the error `e` has itself moved by its inverse.
    """
    value = values.get
    u = {k: m.frame.T @ np.array(m.axes[k].direction) for k in AXES}

    def local(p):
        return m.frame.T @ np.array(p)

    def error(body, reference):
        turn = [value(f"E{a}{body}", 0.0) for a in "ABC"]
        return _shift([value(f"E{a}{body}", 0.0) for a in "XYZ"]) @ _turn(turn, local(reference))

    def slide(k, sign, real):
        s = np.array([value("A0Z", 0.0), value("B0Z", 0.0), 0.0] if k == "Z" else [0.0, 0.0, value("C0Y", 0.0)])
        s = s * (real and k != "X")
        tilted = (_turn(s) @ np.append(u[k], 1.0))[:3]
        step = _shift(sign * q[AXES.index(k)] * tilted)
        return step @ _turn(s, local(m.axes[k].reference)) if m.squareness == "carried" else step

    def pose(real):
        tool, table = np.eye(4), np.eye(4)
        for k in m.tool_chain:
            tool = tool @ slide(k, 1, real)
            tool = tool @ error(k, m.axes[k].reference) if real else tool
        for k in m.workpiece_chain:
            table = table @ slide(k, -1, real)
            table = table @ np.linalg.inv(error(k, m.axes[k].reference)) if real else table
        if real:
            tool = tool @ error("T", m.tool_point if m.spindle_reference is None else m.spindle_reference)
            table = table @ np.linalg.inv(error("W", m.workpiece_reference or (0.0, 0.0, 0.0)))
        return np.linalg.inv(table) @ tool

    functional = np.append(local(m.tool_point) + np.asarray(tool_offset), 1.0)
    real, nominal = pose(True), pose(False)
    r = real[:3, :3]
    skew = (r - r.T) / 2
    return ((real - nominal) @ functional)[:3], np.array([skew[2, 1], skew[0, 2], skew[1, 0]])


# -- the variance decomposition with every V_i and V_ij written out --
def decomposition(omega, law: Moments, weights=(1.0, 1.0, 1.0)):
    """(V_i (n,), V_ij (n, n) symmetric with a zero diagonal, E[Y]) at one position, from the explicit matrix A."""
    a = omega.T @ np.diag(weights) @ omega
    b = 2 * a @ law.mean
    d = np.diag(a)
    single = b**2 * law.var + d**2 * (law.fourth - law.var**2) + 2 * b * d * law.third
    pair = 4 * a**2 * np.outer(law.var, law.var)
    np.fill_diagonal(pair, 0)
    return single, pair, law.mean @ a @ law.mean + d @ law.var


def random_law(rng, n, skewed=True) -> Moments:
    """Moments of exponential-like inputs, so that the third moment and every mean matter."""
    scale = rng.uniform(0.2, 2.0, n)
    if not skewed:
        return Moments(np.zeros(n), scale**2, np.zeros(n), 1.8 * scale**4)
    sign = rng.choice([-1.0, 1.0], n)
    return Moments(rng.normal(size=n), scale**2, sign * 2 * scale**3, 9 * scale**4)


def uniform(lower, upper):
    return [Tolerance(float(a), float(b)) for a, b in zip(lower, upper)]
