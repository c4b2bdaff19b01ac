# SPDX-License-Identifier: LGPL-2.1-or-later
"""How an error or effect moves the machine, for showing: which bodies move, about what, how far, and the tool's answer.

Everything is in the frame of the file, mm and rad, for the value of the error that its tolerance, its fitted function
or the range of its effect gives.  A body on the workpiece side moves against the sign of its error (tool relative to
workpiece).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ..core.driver import TIME
from ..core.machine import Machine
from ..core.refusal import Refused
from ..core.synthesis import omega
from ..core.toolpath import ToolPath
from .part_errors import FittedErrors

SAMPLES = 201  # of a fitted function over the travel


@dataclass(frozen=True)
class Motion:
    """body : whose error it is.  bodies : what moves: it and all it carries.  value : mm or rad, the largest size.

    turn, shift : (3,) rotation about the reference point of the body, rad, and displacement, mm, of the bodies for
    `value`.  slide : (3,) mm, of an error of a linear axis line: half of the travel, along which the bodies move while
    they are displaced in proportion; zeros else.  answer : (3,) mm, displacement of the tool relative to the workpiece
    for `value` (at the end of the slide).
    """

    label: str
    symbol: str
    body: str
    bodies: tuple[str, ...]
    value: float
    turn: np.ndarray
    shift: np.ndarray
    slide: np.ndarray
    answer: np.ndarray


def movable(machine: Machine) -> Mapping[str, float]:
    """Label of each error and enabled effect -> its largest size, mm or rad; those of size zero are left out.

    Fitted errors count with the largest value of their function, others with their tolerance.
    """
    found = {}
    for symbol, tolerance in machine.all_tolerances.items():
        found[symbol] = max(abs(tolerance.lower), abs(tolerance.upper))
    if machine.fitted is not None:
        for symbol in machine.fitted.symbols:
            joint = machine.joint(machine.component(symbol).body)
            place = joint.to_shown(np.linspace(*joint.span, SAMPLES))
            found[symbol] = float(np.abs(machine.fitted.values(symbol, place)).max())
    for effect in machine.effects:
        if effect.enabled and effect.range is not None:
            found[effect.name] = max(abs(v) for v in effect.range)
    return {label: size for label, size in found.items() if size > 0}


def carried(machine: Machine, body: str) -> tuple[str, ...]:
    """A body and all that it carries, outwards."""
    for chain, end in ((machine.workpiece_chain, "W"), (machine.tool_chain, "T")):
        if body in chain:
            return (*chain[chain.index(body) :], end)
    return (body,)


def motion(machine: Machine, label: str, q) -> Motion:
    """How the error or effect `label` moves the machine at positions q (n,) mm or rad.

    Refuses a label that is not `movable`, and errors of the axis line of a rotary joint.
    """
    sizes = movable(machine)
    if label not in sizes:
        raise Refused("motion-unknown", machine.name, label=label[:60])
    effects = {e.name: e for e in machine.effects}
    symbol = effects[label].component if label in effects else label
    c, value = machine.component(symbol), sizes[label]
    side = machine.side(c.body)
    q = np.array(q, dtype=float).reshape(1, -1)
    axis = machine.frame[:, c.axis]
    turn = shift = slide = np.zeros(3)
    if c.line:
        joint = machine.joint(c.body)
        if not joint.slides or not c.angular:
            raise Refused("motion-of-rotary-line", machine.name, label=label[:60])
        low, high = joint.span
        half = (high - low) / 2
        slide = side * half * np.array(joint.direction)
        shift = half * value * side * np.cross(axis, joint.direction)
        q[0, machine.names.index(c.body)] = half
    elif c.angular:
        turn = side * value * axis
    else:
        shift = side * value * axis
    column = omega(machine, [symbol], q)[0, :, 0]
    return Motion(
        label, symbol, c.body, carried(machine, c.body), value, turn, shift, slide, machine.frame @ column * value
    )


@dataclass(frozen=True)
class Course:
    """How an error or effect goes on along a path or over readings: F moments.

    at : (F,) rows.  q : (F, J) positions, mm or rad.  t : (F,) s, or None where no time is known.  value : (F,) mm or
    rad.  answer : (F, 3) mm, displacement of the tool relative to the workpiece.  place : (F, 3) mm, nominal place of
    the point that cuts, over the workpiece.  All in the frame of the file.
    """

    at: np.ndarray
    q: np.ndarray
    t: np.ndarray | None
    value: np.ndarray
    answer: np.ndarray
    place: np.ndarray


def course(machine: Machine, label: str, path: ToolPath, moments: int) -> Course:
    """The fitted error or traced effect `label` at `moments` rows of a path, equally spaced in time where it is known.

    Refuses errors of which only a tolerance is known, and a path that lacks the columns of the effects.
    """
    errors = FittedErrors(machine, path)
    if label not in errors.labels:
        raise Refused("motion-no-course", machine.name, label=label[:60])
    k = errors.labels.index(label)
    t = path.columns.get(TIME)
    if t is None or not np.isfinite(t).all() or not np.ptp(t) > 0:
        at, t = np.linspace(0, path.points - 1, moments).round().astype(int), None
    else:
        order = np.argsort(t, kind="stable")
        at = order[np.searchsorted(t[order], np.linspace(t.min(), t.max(), moments)).clip(0, path.points - 1)]
    made = errors.functions[k]
    value = made.values(at) @ made.coefficients
    column = omega(machine, [made.symbol], path.q[at], path.contact[at])[:, :, 0]
    answer = (column * value[:, None]) @ machine.frame.T
    return Course(at, path.q[at], None if t is None else t[at], value, answer,
                  machine.tool_position(path.q[at], path.contact[at]))  # fmt: skip
