# SPDX-License-Identifier: LGPL-2.1-or-later
"""Joints of a machine, linear and rotary, as unit twists; poses of what they carry, as products of exponentials.

This is the only place that knows the two kinds apart.  Arrays are (3, P) or (3, 3, P), positions last; a rotation that
is the same at every position, because nothing before it turns, is None (the identity).  The calculus of twists: Murray,
Li & Sastry, A Mathematical Introduction to Robotic Manipulation (1994), ch. 2-3.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass

import numpy as np

from ..messages import Refused

TAKEN = ("F", "T", "W", "U")  # the bed, the tool, the workpiece; U alone is kept free
NAME = re.compile(r"[A-Z][0-9]?")
FURTHEST_MM = 1e7  # ten kilometres: no machine is larger, and fourth powers stay finite
MOST_TURNS = 1000
SQUARENESS, AXIS_POSITION, AXIS_ORIENTATION = "squareness", "axis position", "axis orientation"


def cross(a, b) -> np.ndarray:
    """(3, P) cross product of (3,) or (3, P) arrays."""
    return np.stack([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


@dataclass(frozen=True)
class Pose:
    """A rigid motion x -> R x + t at P positions.  rotation : (3, 3, P), or None for the identity.  shift : (3, P)."""

    rotation: np.ndarray | None
    shift: np.ndarray

    def turn(self, vector) -> np.ndarray:
        """(3, P) or (3,) `vector` (a direction) turned."""
        if self.rotation is None:
            return np.asarray(vector)
        if np.ndim(vector) == 1:
            return np.einsum("abp,b->ap", self.rotation, vector)
        return np.einsum("abp,bp->ap", self.rotation, vector)

    def back(self, vector) -> np.ndarray:
        """(3, P) or (3,) `vector` turned the other way."""
        if self.rotation is None:
            return np.asarray(vector)
        return np.einsum("bap,bp->ap", self.rotation, np.broadcast_to(_column(vector), self.shift.shape))

    def move(self, point) -> np.ndarray:
        """(3, P) `point` (3,) or (3, P) moved."""
        return _column(self.turn(point)) + self.shift

    def then(self, inner: Pose) -> Pose:
        """This motion after `inner`: x -> self(inner(x))."""
        if self.rotation is None:
            rotation = inner.rotation
        elif inner.rotation is None:
            rotation = self.rotation
        else:
            rotation = np.einsum("abp,bcp->acp", self.rotation, inner.rotation)
        return Pose(rotation, self.move(inner.shift))


def _column(vector) -> np.ndarray:
    vector = np.asarray(vector, dtype=float)
    return vector[:, None] if vector.ndim == 1 else vector


def identity(count: int) -> Pose:
    """The motion that moves nothing, at `count` positions."""
    return Pose(None, np.zeros((3, count)))


class JointKind:
    """What a kind of joint is: its name, unit, unit twist and finite motion, and which errors its axis line has."""

    name: str
    unit: str  # in which positions are written
    to_internal: float  # mm or rad per that unit
    angular: bool
    may_be_endless: bool

    def __reduce__(self):
        return kind_named, (self.name,)  # a copy is the same kind

    def twist(self, direction, point) -> np.ndarray:
        """(6,) unit twist (v, w) of motion along or about the line through `point`."""
        raise NotImplementedError

    def motion(self, direction, point, q) -> Pose:
        """exp(q twist) at positions q (P,), mm or rad."""
        raise NotImplementedError

    def line_errors(self, along: int, fixed: tuple[int, ...]) -> list[tuple[str, int]]:
        """(SQUARENESS, AXIS_POSITION or AXIS_ORIENTATION; axis) of the errors of its axis line, whose nearest frame
        axis is `along`.  fixed : rotations about these axes define the frame and are no errors."""
        raise NotImplementedError


class _Linear(JointKind):
    name, unit, to_internal, angular, may_be_endless = "linear", "mm", 1.0, False, False

    def twist(self, direction, point):
        return np.concatenate([direction, np.zeros(3)])

    def motion(self, direction, point, q):
        return Pose(None, np.multiply.outer(np.asarray(direction, dtype=float), q))

    def line_errors(self, along, fixed):
        return [(SQUARENESS, axis) for axis in range(3) if axis != along and axis not in fixed]


class _Rotary(JointKind):
    name, unit, to_internal, angular, may_be_endless = "rotary", "deg", math.pi / 180, True, True

    def twist(self, direction, point):
        return np.concatenate([np.cross(point, direction), direction])

    def motion(self, direction, point, q):
        rotation = rotation_about(direction, q)
        point = np.asarray(point, dtype=float)
        return Pose(rotation, point[:, None] - np.einsum("abp,b->ap", rotation, point))

    def line_errors(self, along, fixed):
        across = [axis for axis in range(3) if axis != along]
        return [(kind, axis) for kind in (AXIS_POSITION, AXIS_ORIENTATION) for axis in across]


LINEAR, ROTARY = _Linear(), _Rotary()
KINDS: dict[str, JointKind] = {k.name: k for k in (LINEAR, ROTARY)}


def kind_named(name: str) -> JointKind:
    """The kind called "linear" or "rotary"; raises KeyError for others."""
    return KINDS[name]


def rotation_about(direction, angle) -> np.ndarray:
    """(3, 3, P) rotations by `angle` (P,) rad about the unit vector `direction` (Rodrigues)."""
    x, y, z = (float(v) for v in direction)
    hat = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    angle = np.asarray(angle, dtype=float)
    return (
        np.eye(3)[:, :, None] + np.multiply.outer(hat, np.sin(angle)) + np.multiply.outer(hat @ hat, 1 - np.cos(angle))
    )


def vector(value, where: str) -> tuple[float, float, float]:
    """Three finite numbers as a tuple; refuses anything else."""
    try:
        x = tuple(float(v) for v in value)
    except (TypeError, ValueError):
        x = ()
    if len(x) != 3 or any(isinstance(v, (bool, str)) for v in value):
        raise Refused("vector-not-three-numbers", where, value=repr(value)[:60])
    if not all(math.isfinite(v) for v in x):
        raise Refused("vector-not-finite", where, value=str(list(x)))
    if max(abs(v) for v in x) > FURTHEST_MM:
        raise Refused("vector-too-long", where, value=max(abs(v) for v in x), limit=FURTHEST_MM)
    return x


def check_name(name, where: str = "") -> None:
    """Refuse what is not a capital letter and at most one digit, and the names that bodies have already."""
    if not isinstance(name, str) or not NAME.fullmatch(name):
        raise Refused("joint-name-invalid", where, name=repr(name)[:60])
    if name in TAKEN:
        raise Refused("joint-name-taken", where, name=name)


@dataclass(frozen=True)
class Joint:
    """One joint.

    name : a capital letter and at most one digit.  kind : LINEAR or ROTARY (or its name).  direction : unit vector of
    positive motion, or of the axis of positive rotation.  point : the point to which its error motions refer, with all
    joints at 0 (rotary: a point on its axis).  travel : (lowest, highest) programmed position, mm or rad; None for an
    endless rotary joint.  In the frame of the file.
    """

    name: str
    kind: JointKind
    direction: tuple[float, float, float]
    point: tuple[float, float, float]
    travel: tuple[float, float] | None

    def __post_init__(self):
        put = lambda name, value: object.__setattr__(self, name, value)  # noqa: E731 - frozen dataclass
        where = f"axis {str(self.name)[:20]}"
        check_name(self.name, where)
        if isinstance(self.kind, str):
            if self.kind not in KINDS:
                raise Refused("joint-kind-unknown", where, kind=repr(self.kind)[:60], known=list(KINDS))
            put("kind", KINDS[self.kind])
        put("direction", vector(self.direction, f"{where}, direction"))
        put("point", vector(self.point, f"{where}, reference"))
        length = math.sqrt(sum(v * v for v in self.direction))
        if abs(length - 1) > 1e-3:
            raise Refused("direction-not-unit", f"{where}, direction", value=str(list(self.direction)), length=length)
        if abs(length - 1) > 1e-15:  # a unit vector stays as it is, to the last bit
            put("direction", tuple(v / length for v in self.direction))
        if self.travel is None and self.kind.may_be_endless:
            return
        put("travel", self._checked_travel(f"{where}, travel"))

    def _checked_travel(self, where: str) -> tuple[float, float]:
        try:
            low, high = (float(v) for v in self.travel)
        except (TypeError, ValueError):
            raise Refused("travel-not-two-numbers", where, value=repr(self.travel)[:60], unit=self.unit) from None
        if not (math.isfinite(low) and math.isfinite(high)):
            raise Refused("travel-not-finite", where, unit=self.unit)
        shown = {"low": self.to_shown(low), "high": self.to_shown(high), "unit": self.unit}
        if not low < high:
            raise Refused("travel-without-length", where, **shown)
        if max(abs(low), abs(high)) > (FURTHEST_MM if self.unit == "mm" else 2 * math.pi * MOST_TURNS):
            raise Refused("travel-too-long", where, **shown)
        return low, high

    # -- units and columns -------------------------------------------------------------------------------------------
    @property
    def unit(self) -> str:
        """The unit in which its positions are written: mm or deg."""
        return self.kind.unit

    def to_shown(self, q):
        """Positions q (mm or rad) in its unit."""
        return q / self.kind.to_internal

    def from_shown(self, q):
        """Positions q in its unit, as mm or rad."""
        return q * self.kind.to_internal

    @property
    def slides(self) -> bool:
        """Whether it is linear."""
        return self.kind is LINEAR

    @property
    def column(self) -> str:
        """Name of its positions as a driver: the name in lower case."""
        return self.name.lower()

    @property
    def reference(self) -> tuple[float, float, float]:
        """`point`, under its name in files of version 1."""
        return self.point

    @property
    def span(self) -> tuple[float, float]:
        """The travel, or one turn about 0 for an endless joint; mm or rad."""
        return (-math.pi, math.pi) if self.travel is None else self.travel

    # -- geometry ----------------------------------------------------------------------------------------------------
    @property
    def twist(self) -> np.ndarray:
        """(6,) unit twist (v, w) in the frame of the file."""
        return self.kind.twist(np.array(self.direction), np.array(self.point))


def linear(name, direction, point, travel) -> Joint:
    """A linear joint; see `Joint`.  travel in mm."""
    return Joint(name, LINEAR, direction, point, travel)


def rotary(name, direction, point, travel=None) -> Joint:
    """A rotary joint; see `Joint`.  travel in rad, None: endless."""
    return Joint(name, ROTARY, direction, point, travel)
