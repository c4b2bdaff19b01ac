# SPDX-License-Identifier: LGPL-2.1-or-later
"""A three-axis machine tool: its chains, axes and reference points, and from them the lever arms (Abbe offsets).

Chains run from the bed outwards.  A tool-side carriage moves by +q u, a workpiece-side one by -q u (q: programmed
position, u: direction).  Everything derived here is in the *machine frame*: x along the X axis, y along Y as far as
it is square to X, z square to both.  That frame turns with the machine, so indices do not depend on how it stands.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from .distributions import Tolerance, with_defaults
from .drivers import Effect
from .errors import AXES, BODIES
from .fitted import FittedModel
from .refusal import Refused

MAX_SKEW_DEG = 5.0
SQUARENESS_CONVENTIONS = ("direction", "carried")


def _vector(value, where: str) -> tuple[float, float, float]:
    try:
        x = tuple(float(v) for v in value)
    except (TypeError, ValueError):
        x = ()
    if len(x) != 3 or any(isinstance(v, (bool, str)) for v in value):
        raise Refused(f"{value!r} is not a vector of three numbers", where, "Write [x, y, z] in mm.")
    if not all(math.isfinite(v) for v in x):
        raise Refused(f"{list(x)} is not finite", where, "Give finite numbers.")
    return x


@dataclass(frozen=True)
class Axis:
    """One linear axis.

    direction : unit vector of positive motion.  reference : the point of its moving body to which its error motions
    refer, with all axes at 0.  travel : (lowest, highest) programmed position.  mm, in the frame of the file.
    """

    name: str
    direction: tuple[float, float, float]
    reference: tuple[float, float, float]
    travel: tuple[float, float]

    def __post_init__(self):
        where = f"axis {self.name}"
        if self.name not in AXES:
            raise Refused(f"unknown axis {self.name!r}", where, "Axes are X, Y and Z.")
        object.__setattr__(self, "direction", _vector(self.direction, f"{where}, direction"))
        object.__setattr__(self, "reference", _vector(self.reference, f"{where}, reference"))
        length = math.sqrt(sum(v * v for v in self.direction))
        if abs(length - 1) > 1e-3:
            raise Refused(
                f"direction {list(self.direction)} has length {length:g}",
                f"{where}, direction",
                "Give a unit vector.",
            )
        if abs(length - 1) > 1e-15:  # a unit vector stays as it is, to the last bit
            object.__setattr__(self, "direction", tuple(v / length for v in self.direction))
        try:
            low, high = (float(v) for v in self.travel)
        except (TypeError, ValueError):
            raise Refused(f"{self.travel!r} is not [lowest, highest]", f"{where}, travel") from None
        if not (math.isfinite(low) and math.isfinite(high)):
            raise Refused("travel is not finite", f"{where}, travel", "Give finite limits in mm.")
        if not low < high:
            raise Refused(
                f"travel from {low:g} to {high:g} mm has no length",
                f"{where}, travel",
                "The second limit must be above the first.",
            )
        object.__setattr__(self, "travel", (low, high))


@dataclass(frozen=True)
class Machine:
    """Chains, axes, points and what is known of the errors.

    workpiece_chain, tool_chain : axis names from the bed outwards.  tool_point : the functional point with all axes at
    0.  spindle_reference, workpiece_reference : to what T and W errors refer (default: the tool point; the origin).
    squareness : "direction" (ISO 230-1: only the direction of motion tilts) or "carried" (the guide's rotation also
    turns what it carries).  tolerances : symbol -> Tolerance as given (the rest takes the paper's).
    declared : symbol -> polynomial degree of the declared error function (0: not declared; squareness 1 or 0).
    fitted : what a fit of readings gave, or None.  effects : traced effects.
    extra : the file's "x-" keys, kept.
    """

    name: str
    workpiece_chain: tuple[str, ...]
    tool_chain: tuple[str, ...]
    axes: Mapping[str, Axis]
    tool_point: tuple[float, float, float]
    spindle_reference: tuple[float, float, float] | None = None
    workpiece_reference: tuple[float, float, float] | None = None
    squareness: str = "direction"
    tolerances: Mapping[str, Tolerance] = field(default_factory=dict)
    declared: Mapping[str, int] = field(default_factory=dict)
    fitted: FittedModel | None = None
    effects: tuple[Effect, ...] = ()
    extra: Mapping = field(default_factory=dict)

    def __post_init__(self):
        put = lambda name, value: object.__setattr__(self, name, value)  # noqa: E731 - frozen dataclass
        put("workpiece_chain", tuple(self.workpiece_chain))
        put("tool_chain", tuple(self.tool_chain))
        put("effects", tuple(self.effects))
        put("tool_point", _vector(self.tool_point, "tool_point"))
        for name in ("spindle_reference", "workpiece_reference"):
            if getattr(self, name) is not None:
                put(name, _vector(getattr(self, name), name))
        if self.squareness not in SQUARENESS_CONVENTIONS:
            raise Refused(
                f"unknown convention {self.squareness!r}", "squareness", 'Use "direction" (ISO 230-1) or "carried".'
            )
        chain = self.workpiece_chain + self.tool_chain
        for name in chain:
            if name not in AXES:
                raise Refused(f"unknown axis {name!r} in a chain", "workpiece_chain / tool_chain", "Use X, Y and Z.")
            if chain.count(name) > 1:
                raise Refused(
                    f"axis {name} stands twice in the chains",
                    "workpiece_chain / tool_chain",
                    "Each carriage belongs to one place: the workpiece side or the tool side.",
                )
        for name in AXES:
            if name not in chain:
                raise Refused(
                    f"axis {name} is in neither chain", "workpiece_chain / tool_chain", "Name each of X, Y, Z once."
                )
            if name not in self.axes:
                raise Refused(f"axis {name} is missing", "axes", "Describe X, Y and Z.")
        self._check_directions()

    def _check_directions(self):
        for a, b in itertools.combinations(AXES, 2):
            cosine = abs(float(np.dot(self.axes[a].direction, self.axes[b].direction)))
            angle = math.degrees(math.acos(min(1.0, cosine)))
            if angle < 1.0:
                raise Refused(f"axes {a} and {b} are parallel", f"axes {a}, {b}, direction", "Correct one direction.")
            if 90 - angle > MAX_SKEW_DEG:
                raise Refused(
                    f"axes {a} and {b} stand at {angle:.2f} degrees; more than {MAX_SKEW_DEG:g} from square",
                    f"axes {a}, {b}, direction",
                    "Correct one direction, or choose another placement to take it from.",
                )

    # -- names ---------------------------------------------------------------------------------------------------
    @property
    def structure(self) -> str:
        """The structure code from workpiece to tool with F for the bed: `FXYZ`, `YFXZ`, `XYFZ`."""
        return "".join(reversed(self.workpiece_chain)) + "F" + "".join(self.tool_chain)

    @property
    def skew_deg(self) -> dict[str, float]:
        """Departure of each pair of directions from 90 degrees, as designed: {"XY": .., "XZ": .., "YZ": ..}."""
        u = {k: np.array(self.axes[k].direction) for k in AXES}
        return {
            a + b: math.degrees(math.acos(float(np.clip(u[a] @ u[b], -1, 1)))) - 90
            for a, b in itertools.combinations(AXES, 2)
        }

    @property
    def all_tolerances(self) -> dict[str, Tolerance]:
        return with_defaults(dict(self.tolerances))

    @property
    def travel(self) -> np.ndarray:
        """(3, 2) lowest and highest position of X, Y, Z."""
        return np.array([self.axes[k].travel for k in AXES])

    # -- frame ---------------------------------------------------------------------------------------------------
    @cached_property
    def frame(self) -> np.ndarray:
        """(3, 3) unit vectors of the machine frame as columns, in file coordinates; right-handed, read-only.

        X is primary and Y secondary, as in ISO 230-1.  Where the directions form a left-handed triad (one axis counts
        backwards) the signs nearest to the file's own frame are taken.
        """
        x = np.array(self.axes["X"].direction)
        y = np.array(self.axes["Y"].direction)
        y = y - x * (x @ y)
        y /= np.linalg.norm(y)
        z = np.cross(x, y)
        frame = np.column_stack([x, y, z])
        if z @ np.array(self.axes["Z"].direction) <= 0:
            signs = itertools.product((1, -1), repeat=2)
            frame = max((np.column_stack([sx * x, sy * y, sx * sy * z]) for sx, sy in signs), key=np.trace)
        frame.setflags(write=False)
        return frame

    def _in_frame(self, vector) -> np.ndarray:
        return self.frame.T @ np.asarray(vector, dtype=float)

    @property
    def directions(self) -> dict[str, np.ndarray]:
        """Unit direction of each axis in the machine frame."""
        rotation = self.frame.T
        return {k: rotation @ np.array(self.axes[k].direction) for k in AXES}

    def side(self, body: str) -> int:
        """+1 for a tool-side body, -1 for a workpiece-side one."""
        return -1 if body == "W" or body in self.workpiece_chain else 1

    # -- lever arms ----------------------------------------------------------------------------------------------
    def lever_arms(self, q, tool_offset=None, frame: str = "machine") -> dict[str, np.ndarray]:
        """Abbe offset of every body at every position: functional point minus reference point, both where they are.

        q : (P, 3) programmed positions, mm.  tool_offset : (3,) or (P, 3), functional point minus the declared tool
        point, mm.  Returns body -> (P, 3) mm for X, Y, Z, T, W, in the machine frame (`frame="file"`: in the file's).

        For k on the tool side the axes beyond k displace the tool point only; for k on the workpiece side the tool-side
        axes move the point and the axes up to k move the reference the other way.
        """
        q = np.asarray(q, dtype=float).reshape(-1, 3)
        rotation, u = self.frame.T, self.directions
        step = {k: q[:, [i]] * u[k] for i, k in enumerate(AXES)}  # programmed displacement along each axis
        point = np.broadcast_to(rotation @ np.array(self.tool_point), q.shape)
        if tool_offset is not None:
            point = point + np.asarray(tool_offset, dtype=float).reshape(-1, 3)
        arms = {}
        carried = point
        for k in reversed(self.tool_chain):  # from the tool inwards: what lies beyond k moves the point
            arms[k] = carried - rotation @ np.array(self.axes[k].reference)
            carried = carried + step[k]
        for k in self.workpiece_chain:  # from the bed outwards, each including its own travel
            carried = carried + step[k]
            arms[k] = carried - rotation @ np.array(self.axes[k].reference)
        spindle = self.tool_point if self.spindle_reference is None else self.spindle_reference
        workpiece = (0.0, 0.0, 0.0) if self.workpiece_reference is None else self.workpiece_reference
        arms["T"] = point - rotation @ np.array(spindle)
        arms["W"] = carried - rotation @ np.array(workpiece)
        if frame == "file":
            return {b: arms[b] @ rotation for b in BODIES}
        return {b: arms[b] for b in BODIES}

    def declared_degree(self, symbol: str) -> int:
        """Degree of the declared function of an axis error (default 3), 1 or 0 for squareness."""
        if symbol in self.declared:
            return self.declared[symbol]
        return 1 if symbol[1] == "0" else 3


def structure_chains(code: str) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """(workpiece_chain, tool_chain) of a structure code such as `XYFZ` (workpiece -> tool, F for the bed)."""
    text = code.strip().upper()
    if sorted(text) != sorted("FXYZ"):
        raise Refused(
            f"{code!r} is not a structure code", "structure", "Write F for the bed and X, Y, Z once, such as XYFZ."
        )
    left, right = text.split("F")
    return tuple(reversed(left)), tuple(right)
