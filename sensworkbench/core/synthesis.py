# SPDX-License-Identifier: LGPL-2.1-or-later
"""Error synthesis: component x lever arm -> columns of Omega, the only place where Omega is made.

First order (Park & Yang 2012 eq. 1; ISO 230-1 signs, tool relative to workpiece, in the machine frame):
T = sum_k [d_k + e_k x r_k] + sum_k q_k (s_k x u_k) + d_T + e_T x r_T + d_W + e_W x r_W.  The exact product of
transformation matrices stands beside it as the reference; second-order coupling is about 2 nm on usual machines.
"""

from __future__ import annotations

import numpy as np

from .errors import AXES, SQUARENESS, TRANSLATION, component
from .machine import Machine

POSITION, ORIENTATION = "position", "orientation"


def omega(machine: Machine, symbols, q, tool_offset=None, output: str = POSITION) -> np.ndarray:
    """(P, 3, n) coefficients of the errors `symbols` in T4..T6 (or R1..R3 with output="orientation").

    q : (P, 3) programmed positions, mm.  tool_offset : None, (3,) or (P, 3), mm.  Columns are mm per mm, mm per rad,
    rad per rad.  The memory layout is position-last (a view of (3, n, P)), which is what `sobol` reads fastest.
    """
    q = np.asarray(q, dtype=float).reshape(-1, 3)
    parts = [component(s) for s in symbols]
    arms = machine.lever_arms(q, tool_offset) if output == POSITION else {}
    u = machine.directions
    out = np.zeros((3, len(parts), len(q)))
    for j, c in enumerate(parts):
        turn = np.zeros(3)
        turn[c.axis] = 1.0
        if output == POSITION:
            out[:, j, :] = _translation(machine, c, turn, arms, q, u).T
        elif c.kind != TRANSLATION and (c.kind != SQUARENESS or machine.squareness == "carried"):
            sign = machine.side(c.body) if c.kind == SQUARENESS else 1
            out[:, j, :] = (sign * turn)[:, None]
    return out.transpose(2, 0, 1)


def _translation(machine, c, turn, arms, q, u):
    if c.kind == TRANSLATION:
        return np.broadcast_to(turn, q.shape)
    if c.kind != SQUARENESS:
        return np.cross(turn, arms[c.body])
    column = q[:, [AXES.index(c.body)]] * np.cross(turn, u[c.body])
    if machine.squareness == "carried":
        column = column + machine.side(c.body) * np.cross(turn, arms[c.body])
    return column


def volumetric_error(machine: Machine, values, q, tool_offset=None, output: str = POSITION) -> np.ndarray:
    """(P, 3) linear volumetric error (mm, or rad) of `values`: symbol -> scalar or (P,) in mm or rad."""
    q = np.asarray(q, dtype=float).reshape(-1, 3)
    symbols = list(values)
    x = np.stack([np.broadcast_to(np.asarray(values[s], dtype=float), len(q)) for s in symbols], axis=1)
    return np.einsum("pan,pn->pa", omega(machine, symbols, q, tool_offset, output), x)


# -- the exact reference ---------------------------------------------------------------------------------------------
def _rotation(e: np.ndarray) -> np.ndarray:
    """(P, 3, 3) rotation matrices of rotation vectors (P, 3), Rodrigues."""
    angle = np.linalg.norm(e, axis=1)[:, None, None]
    k = np.zeros((len(e), 3, 3))
    k[:, 0, 1], k[:, 0, 2], k[:, 1, 2] = -e[:, 2], e[:, 1], -e[:, 0]
    k -= k.transpose(0, 2, 1)
    return np.eye(3) + np.sinc(angle / np.pi) * k + 0.5 * np.sinc(angle / 2 / np.pi) ** 2 * (k @ k)


def _transform(rotation, translation) -> np.ndarray:
    out = np.zeros((len(translation), 4, 4))
    out[:, :3, :3], out[:, :3, 3], out[:, 3, 3] = rotation, translation, 1.0
    return out


def _about(point, e, d) -> np.ndarray:
    """Rigid motion: turn by e about `point` and shift by d."""
    rotation = _rotation(e)
    return _transform(rotation, d + point - np.einsum("pij,pj->pi", rotation, np.broadcast_to(point, d.shape)))


def exact_error(machine: Machine, values, q, tool_offset=None) -> tuple[np.ndarray, np.ndarray]:
    """Volumetric error by the exact product of homogeneous transformation matrices.

    values : symbol -> scalar or (P,) in mm or rad.  Returns (T, R): (P, 3) mm and (P, 3) rad, actual minus commanded
    tool pose in the workpiece frame.
    """
    q = np.asarray(q, dtype=float).reshape(-1, 3)
    count = len(q)
    frame, u = machine.frame.T, machine.directions
    known = {component(s).symbol: np.broadcast_to(np.asarray(v, dtype=float), count) for s, v in values.items()}

    def motion(body, kind):  # (P, 3) the body's translations, rotations or squareness turns
        out = np.zeros((count, 3))
        for symbol, value in known.items():
            c = component(symbol)
            if c.body == body and c.kind == kind:
                out[:, c.axis] = value
        return out

    def body_error(body, reference):
        return _about(frame @ np.array(reference), motion(body, "rotation"), motion(body, "translation"))

    def guide(k, sign, true):
        i = AXES.index(k)
        step = sign * q[:, [i]] * u[k]
        if not true:
            return _transform(np.eye(3), step)
        s = motion(k, SQUARENESS)
        shift = _transform(np.eye(3), np.einsum("pij,pj->pi", _rotation(s), step))
        if machine.squareness == "carried":
            shift = shift @ _about(frame @ np.array(machine.axes[k].reference), s, np.zeros((count, 3)))
        return shift

    def chain(true):
        tool = workpiece = np.broadcast_to(np.eye(4), (count, 4, 4))
        for k in machine.tool_chain:
            tool = tool @ guide(k, 1, true)
            if true:
                tool = tool @ body_error(k, machine.axes[k].reference)
        for k in machine.workpiece_chain:
            workpiece = workpiece @ guide(k, -1, true)
            if true:  # ISO sign: the error is that of the tool relative to the table, so the table moves the other way
                workpiece = workpiece @ np.linalg.inv(body_error(k, machine.axes[k].reference))
        if true:
            spindle = machine.tool_point if machine.spindle_reference is None else machine.spindle_reference
            fixture = (0.0, 0.0, 0.0) if machine.workpiece_reference is None else machine.workpiece_reference
            tool = tool @ body_error("T", spindle)
            workpiece = workpiece @ np.linalg.inv(body_error("W", fixture))
        return np.linalg.inv(workpiece) @ tool

    point = np.ones((count, 4))
    point[:, :3] = frame @ np.array(machine.tool_point)
    if tool_offset is not None:
        point[:, :3] += np.asarray(tool_offset, dtype=float).reshape(-1, 3)
    actual, nominal = chain(True), chain(False)
    position = np.einsum("pij,pj->pi", actual - nominal, point)[:, :3]
    turn = actual[:, :3, :3]
    skew = (turn - turn.transpose(0, 2, 1)) / 2
    return position, np.stack([skew[:, 2, 1], skew[:, 0, 2], skew[:, 1, 0]], axis=1)
