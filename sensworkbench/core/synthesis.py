# SPDX-License-Identifier: LGPL-2.1-or-later
"""Error synthesis: component x lever arm -> columns of Omega, the only place where Omega is made.

First order (Park & Yang 2012 eq. 1; ISO 230-1 and 230-7 signs, tool relative to workpiece).  With G the nominal pose of
what carries a joint, s = +1 on the tool side and -1 on the workpiece side and xi its unit twist:
a motion of its body is Ad(G) of the unit twist at its reference point where that now is; an error eta of its axis line
is s Ad(G) (eta - Ad(exp(s q xi)) eta), or s Ad(G) eta where squareness is "carried"; and every column is seen from the
workpiece, Ad(G_W^-1), at the functional point.  For linear joints X, Y, Z this is
T = sum_k [d_k + e_k x r_k] + sum_k q_k (s_k x u_k) + d_T + e_T x r_T + d_W + e_W x r_W.
The exact product of transformation matrices is computed here as well, as the reference of the tests; second-order
coupling is about 2 nm on usual machines.
"""

from __future__ import annotations

import numpy as np

from .errors import ENDS, Component
from .joints import Pose, cross, identity
from .machine import Machine

POSITION, ORIENTATION = "position", "orientation"


def omega(machine: Machine, symbols, q, tool_offset=None, output: str = POSITION) -> np.ndarray:
    """(P, 3, n) coefficients of the errors `symbols` in T4..T6 (or R1..R3 with output="orientation").

    q : (P, joints) programmed positions, mm or rad, in the order of `machine.names`.  tool_offset : None, (3,) or (P,
    3), mm.  Columns are mm per mm, mm per rad, rad per rad, in the frame of the workpiece.  The memory layout is
    position-last (a view of (3, n, P)), which is what `sobol` reads fastest.
    """
    q = machine.positions(q)
    parts = [machine.component(s) for s in symbols]
    out = np.zeros((3, len(parts), len(q)))
    levers = _Levers(machine, q, tool_offset)
    for j, c in enumerate(parts):
        if not c.line and c.angular and output == POSITION and levers.still(c.body):  # the usual case, without products
            a, b = (c.axis + 1) % 3, (c.axis + 2) % 3
            arm = levers.arm(c.body)
            np.negative(arm[b], out=out[a, j, :])
            out[b, j, :] = arm[a]
            continue
        column = levers.line(c, output) if c.line else levers.motion(c, output)
        if column is not None:
            out[:, j, :] = column
    return out.transpose(2, 0, 1)


class _Levers:
    """Poses, reference points and the functional point at every position; columns of single components."""

    def __init__(self, machine: Machine, q: np.ndarray, tool_offset):
        self.machine, self.shape = machine, (3, len(q))
        self.steps = machine.steps(q)
        self.carriers = machine.carriers(q, self.steps)
        self.tip = self.carriers["T"].move(machine._tool_point(tool_offset))
        self.workpiece = self.carriers["W"]
        self._arms: dict[str, np.ndarray] = {}

    def still(self, body: str) -> bool:
        """Whether what carries the body, and the workpiece, stay parallel to the machine frame."""
        return self.carriers[body].rotation is None and self.workpiece.rotation is None

    def _unit(self, c: Component) -> np.ndarray:
        """The component's unit vector, in the machine frame: (3,), or (3, P) where something before it turns."""
        return self.carriers[c.body].turn(np.eye(3)[c.axis])

    def _now(self, body: str) -> np.ndarray:
        """(3, P) or (3, 1) reference point where it now is, in the machine frame."""
        reference, carrier = self.machine.references[body], self.carriers[body]
        return carrier.move(reference if body in ENDS else self.steps[body].move(reference))

    def arm(self, body: str) -> np.ndarray:
        """(3, P) functional point less the reference point of the body, in the machine frame."""
        if body not in self._arms:
            self._arms[body] = self.tip - self._now(body)
        return self._arms[body]

    def motion(self, c: Component, output: str):
        """Column of a motion of a body, (3, P) or (3, 1); None where it is zero."""
        unit = self._unit(c)
        if output == ORIENTATION:
            return self._seen(unit) if c.angular else None
        return self._seen(cross(unit, self.arm(c.body)) if c.angular else unit)

    def line(self, c: Component, output: str):
        """Column of an error of an axis line, (3, P) or (3, 1); None where it is zero."""
        machine, carrier, step = self.machine, self.carriers[c.body], self.steps[c.body]
        side, carried = machine.side(c.body), machine.squareness == "carried"
        unit = self._unit(c)
        turned = None  # the unit as the joint's own motion leaves it: a linear joint leaves it alone
        if not carried and step.rotation is not None:
            turned = carrier.turn(step.turn(np.eye(3)[c.axis]))
        if output == ORIENTATION or not c.angular:
            if c.angular == (output != ORIENTATION):  # a shift of the line turns nothing
                return None
            if carried:
                return self._seen(side * unit)
            return None if turned is None else self._seen(side * (_column(unit) - turned))
        moved = self._now(c.body) - carrier.move(machine.references[c.body])
        column = side * cross(unit, moved)
        if carried:
            column = column + side * cross(unit, self.arm(c.body))
        elif turned is not None:
            column = column + side * cross(_column(unit) - turned, self.arm(c.body))
        return self._seen(column)

    def _seen(self, vector) -> np.ndarray:
        """`vector` in the frame of the workpiece."""
        if self.workpiece.rotation is None:
            return _column(vector)
        return self.workpiece.back(np.broadcast_to(_column(vector), self.shape))


def _column(vector) -> np.ndarray:
    return vector[:, None] if vector.ndim == 1 else vector


def volumetric_error(machine: Machine, values, q, tool_offset=None, output: str = POSITION) -> np.ndarray:
    """(P, 3) linear volumetric error (mm, or rad) of `values`: symbol -> scalar or (P,) in mm or rad."""
    q = machine.positions(q)
    symbols = list(values)
    x = np.stack([np.broadcast_to(np.asarray(values[s], dtype=float), len(q)) for s in symbols], axis=1)
    return np.einsum("pan,pn->pa", omega(machine, symbols, q, tool_offset, output), x)


# -- the exact reference ---------------------------------------------------------------------------------------------
def _displacement(turn: np.ndarray, shift: np.ndarray, point) -> Pose:
    """Rigid motion: turn by the rotation vectors `turn` (3, P) about `point` and shift by `shift` (3, P)."""
    angle = np.linalg.norm(turn, axis=0)
    k = np.zeros((3, *turn.shape))
    k[0, 1], k[0, 2], k[1, 2] = -turn[2], turn[1], -turn[0]
    k -= k.transpose(1, 0, 2)
    square = np.einsum("abp,bcp->acp", k, k)
    rotation = np.eye(3)[:, :, None] + np.sinc(angle / np.pi) * k + 0.5 * np.sinc(angle / 2 / np.pi) ** 2 * square
    point = _column(np.asarray(point, dtype=float))
    return Pose(rotation, shift + point - np.einsum("abp,bp->ap", rotation, np.broadcast_to(point, shift.shape)))


def _inverse(pose: Pose) -> Pose:
    if pose.rotation is None:
        return Pose(None, -pose.shift)
    return Pose(pose.rotation.transpose(1, 0, 2), -pose.back(pose.shift))


def exact_error(machine: Machine, values, q, tool_offset=None) -> tuple[np.ndarray, np.ndarray]:
    """Volumetric error by the exact product of homogeneous transformation matrices.

    values : symbol -> scalar or (P,) in mm or rad.  Returns (T, R): (P, 3) mm and (P, 3) rad, actual minus commanded
    tool pose in the workpiece frame.
    """
    q = machine.positions(q)
    count = len(q)
    references, steps = machine.references, machine.steps(q)
    known = {machine.component(s): np.broadcast_to(np.asarray(v, dtype=float), count) for s, v in values.items()}

    def displaced(body, line) -> Pose:
        """The errors of a body or, with `line`, of its joint's axis line, about its reference with all joints at 0."""
        turn, shift = np.zeros((3, count)), np.zeros((3, count))
        for c, value in known.items():
            if c.body == body and c.line == line:
                (turn if c.angular else shift)[c.axis] = value
        if not line and body not in ENDS and steps[body].rotation is not None:  # in the axes of what carries the joint
            turn, shift = steps[body].back(turn), steps[body].back(shift)
        return _displacement(turn, shift, references[body])

    def chain(names, end, side) -> Pose:
        pose = identity(count)
        for name in names:
            line = displaced(name, True)
            pose = pose.then(line).then(steps[name])
            if machine.squareness == "direction":
                pose = pose.then(_inverse(line))
            motion = displaced(
                name, False
            )  # ISO sign: of the tool relative to the table, so a table moves the other way
            pose = pose.then(motion if side > 0 else _inverse(motion))
        motion = displaced(end, False)
        return pose.then(motion if side > 0 else _inverse(motion))

    ends = machine.carriers(q, steps)
    nominal = _inverse(ends["W"]).then(ends["T"])
    actual = _inverse(chain(machine.workpiece_chain, "W", -1)).then(chain(machine.tool_chain, "T", 1))
    point = machine._tool_point(tool_offset)
    position = actual.move(point) - nominal.move(point)
    turn = actual.then(_inverse(nominal)).rotation
    skew = (turn - turn.transpose(1, 0, 2)) / 2
    return position.T, np.stack([skew[2, 1], skew[0, 2], skew[1, 0]], axis=1)
