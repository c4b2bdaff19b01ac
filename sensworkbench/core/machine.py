# SPDX-License-Identifier: LGPL-2.1-or-later
"""A machine tool: its chains, joints and reference points, and from them poses and lever arms (Abbe offsets).

Chains run from the bed outwards.  A tool-side joint moves by +q, a workpiece-side one by -q (q: programmed position).
Everything derived here is in the *machine frame*: x along the X axis, y along Y as far as it is square to X, z square
to both (the joints that define it may be named).  That frame turns with the machine, so indices do not depend on how
it stands.
"""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from ..messages import Message
from .distributions import Tolerance, paper_tolerance_of
from .effects import Effect
from .errors import AXES, ENDS, Component, components_of, find
from .fitted import FittedModel
from .joints import Joint, Pose, identity, vector
from .refusal import Refused
from .sources import Source

MAX_SKEW_DEG = 5.0
MOST_JOINTS = 6
SQUARENESS_CONVENTIONS = ("direction", "carried")
_PARALLEL_DEG = 1.0


@dataclass(frozen=True)
class Machine:
    """Chains, joints, points and what is known of the errors.

    workpiece_chain, tool_chain : names of joints from the bed outwards.  joints : every joint of the chains; their
    order is that of the columns of q (a mapping name -> Joint is taken in the order X, Y, Z, others).  tool_point :
    the functional point with all joints at 0.  spindle_reference, workpiece_reference : to what T and W errors refer
    (default: the tool point; the origin).  squareness : "direction" (ISO 230-1: only the axis line is displaced) or
    "carried" (the displacement also moves what the joint carries).  frame_axes : names of the primary and the
    secondary joint that define the machine frame (default: X and Y, else the first two linear joints that are not
    parallel). tolerances : symbol -> Tolerance as given.  declared : symbol -> polynomial degree of the declared error
    function (0: not declared; errors of axis lines 1 or 0).  fitted : what a fit of readings gave, or None.  effects :
    traced effects. extra : the file's "x-" keys, kept.  version : of the file it was read from, and is written as.
    sources : causes that several errors follow.
    """

    name: str
    workpiece_chain: tuple[str, ...]
    tool_chain: tuple[str, ...]
    joints: tuple[Joint, ...]
    tool_point: tuple[float, float, float]
    spindle_reference: tuple[float, float, float] | None = None
    workpiece_reference: tuple[float, float, float] | None = None
    squareness: str = "direction"
    tolerances: Mapping[str, Tolerance] = field(default_factory=dict)
    declared: Mapping[str, int] = field(default_factory=dict)
    fitted: FittedModel | None = None
    effects: tuple[Effect, ...] = ()
    extra: Mapping = field(default_factory=dict)
    frame_axes: tuple[str, str] | None = None
    version: int = 1
    sources: tuple[Source, ...] = ()

    def __post_init__(self):
        put = lambda name, value: object.__setattr__(self, name, value)  # noqa: E731 - frozen dataclass
        joints = self.joints
        if isinstance(joints, Mapping):
            order = {k: i for i, k in enumerate(AXES)}
            joints = sorted(joints.values(), key=lambda j: order.get(j.name, len(AXES)))
        put("joints", tuple(joints))
        put("workpiece_chain", tuple(self.workpiece_chain))
        put("tool_chain", tuple(self.tool_chain))
        put("effects", tuple(self.effects))
        put("sources", tuple(self.sources))
        put("tool_point", vector(self.tool_point, "tool_point"))
        for name in ("spindle_reference", "workpiece_reference"):
            if getattr(self, name) is not None:
                put(name, vector(getattr(self, name), name))
        if self.squareness not in SQUARENESS_CONVENTIONS:
            raise Refused("squareness-convention-unknown", "squareness", value=repr(self.squareness)[:60])
        check_chains(self.names, self.workpiece_chain, self.tool_chain)
        self._check_directions()
        if self.frame_axes is not None:
            put("frame_axes", tuple(self.frame_axes))
            self._check_frame()
        self._check_sources()

    def _check_sources(self):
        names = [s.name for s in self.sources]
        for source in self.sources:
            if names.count(source.name) > 1 or source.name in self.bodies or source.name in self._table:
                raise Refused("source-name-taken", "sources", name=source.name)
            for symbol in source.factors:
                self.component(symbol, f"source {source.name}")

    def _check_directions(self):
        for a, b in itertools.combinations([j for j in self.joints if j.name in AXES and j.slides], 2):
            angle, where = _angle_deg(a, b), f"axes {a.name}, {b.name}, direction"
            if angle < _PARALLEL_DEG:
                raise Refused("machine-axes-parallel", where, a=a.name, b=b.name)
            if 90 - angle > MAX_SKEW_DEG:
                raise Refused("machine-axes-not-square", where, a=a.name, b=b.name, angle=angle, limit=MAX_SKEW_DEG)

    def _check_frame(self):
        if len(self.frame_axes) != 2 or len(set(self.frame_axes)) != 2 or set(self.frame_axes) - set(self.names):
            raise Refused("frame-axes-unknown", "frame", value=list(map(str, self.frame_axes)), known=list(self.names))
        if _angle_deg(*(self.joint(k) for k in self.frame_axes)) < _PARALLEL_DEG:
            raise Refused("machine-axes-parallel", "frame", a=self.frame_axes[0], b=self.frame_axes[1])

    # -- names ---------------------------------------------------------------------------------------------------
    @property
    def names(self) -> tuple[str, ...]:
        """Names of the joints, in the order of the columns of q."""
        return tuple(j.name for j in self.joints)

    @property
    def bodies(self) -> tuple[str, ...]:
        """What can move: the body of each joint, the spindle with its tool (T), the workpiece with its fixture (W)."""
        return (*self.names, *ENDS)

    @cached_property
    def axes(self) -> dict[str, Joint]:
        """name -> joint."""
        return {j.name: j for j in self.joints}

    def joint(self, name: str) -> Joint:
        """The joint of that name; KeyError where there is none."""
        return self.axes[name]

    def body_title(self, body: str) -> Message:
        """What a body, or the name of a source, is called: `X carriage`."""
        if body == "T":
            return Message("body-tool")
        if body == "W":
            return Message("body-workpiece")
        if body not in self.names:
            return Message("body-source", name=body)
        return Message("body-carriage" if self.joint(body).slides else "body-rotary", name=body)

    @property
    def structure(self) -> str:
        """The structure code from workpiece to tool with F for the bed: `FXYZ`, `YFXZ`, `XYFZ`."""
        return "".join(reversed(self.workpiece_chain)) + "F" + "".join(self.tool_chain)

    @property
    def skew_deg(self) -> dict[str, float]:
        """Departure of each pair of linear X, Y, Z from 90 degrees, as designed: {"XY": .., "XZ": .., "YZ": ..}."""
        lines = [j for j in self.joints if j.name in AXES and j.slides]
        return {
            a.name + b.name: math.degrees(math.acos(float(np.clip(np.dot(a.direction, b.direction), -1, 1)))) - 90
            for a, b in itertools.combinations(lines, 2)
        }

    @property
    def travel(self) -> np.ndarray:
        """(n, 2) lowest and highest position of each joint, mm or rad; of an endless one, one turn about 0."""
        return np.array([j.span for j in self.joints])

    # -- errors --------------------------------------------------------------------------------------------------
    @cached_property
    def components(self) -> tuple[Component, ...]:
        """Every error component: motions of each body, then errors of the axis lines."""
        return components_of((j.name, j.kind, self._along[j.name], self._fixed.get(j.name, ())) for j in self.joints)

    @cached_property
    def _table(self) -> dict[str, Component]:
        return {c.symbol: c for c in self.components}

    def component(self, symbol, where: str = "") -> Component:
        """The component of an ISO name or alias; refuses one that this machine has not."""
        return find(self._table, symbol, where)

    @property
    def function_symbols(self) -> tuple[str, ...]:
        """Errors that are functions of their own joint's position: six motions of each joint."""
        return tuple(c.symbol for c in self.components if c.body not in ENDS and not c.line)

    @property
    def line_symbols(self) -> tuple[str, ...]:
        """Errors of the axis lines: squareness, position and orientation."""
        return tuple(c.symbol for c in self.components if c.line)

    @property
    def declared_symbols(self) -> tuple[str, ...]:
        """Errors that the declared model may hold."""
        return self.function_symbols + self.line_symbols

    @property
    def all_tolerances(self) -> dict[str, Tolerance]:
        """The tolerances given, and for the rest of a linear joint and the spindle those of the paper (none for rotary
        joints and for errors that follow a source, which take part where a tolerance is given)."""
        usual = {}
        followed = {self.component(s).symbol for source in self.sources for s in source.factors}
        for symbol in (*self.function_symbols, *self.line_symbols, "EXT", "EYT", "EZT"):
            c = self._table[symbol]
            if symbol not in followed and (c.body in ENDS or self.axes[c.body].slides):
                usual[symbol] = paper_tolerance_of(c)
        given = {self.component(s).symbol: t for s, t in self.tolerances.items()}
        more = {c.symbol: given[c.symbol] for c in self.components if c.symbol in given and c.symbol not in usual}
        return {s: given.get(s, t) for s, t in usual.items()} | more

    # -- frame ---------------------------------------------------------------------------------------------------
    @cached_property
    def _frame_joints(self) -> tuple[Joint, Joint] | None:
        """Primary and secondary joint, or None where the frame of the file is taken."""
        if self.frame_axes is not None:
            return self.axes[self.frame_axes[0]], self.axes[self.frame_axes[1]]
        lines = [j for j in self.joints if j.slides]
        named = {j.name: j for j in lines}
        if "X" in named and "Y" in named:
            return named["X"], named["Y"]
        pairs = itertools.combinations(lines, 2)
        return next(((a, b) for a, b in pairs if _angle_deg(a, b) >= _PARALLEL_DEG), None)

    @cached_property
    def _frame_letters(self) -> tuple[int, int]:
        """Frame axes that the primary and the secondary joint define, by their letters (U1 as X, V as Y, W1 as Z)."""
        first, second = ("XYZ".find(j.name[0].translate(_PARALLELS)) for j in self._frame_joints)
        if first < 0:
            first = next(i for i in range(3) if i != second)
        if second < 0 or second == first:
            second = next(i for i in range(3) if i != first)
        return first, second

    @cached_property
    def frame(self) -> np.ndarray:
        """(3, 3) unit vectors of the machine frame as columns, in file coordinates; right-handed, read-only.

        The primary and the secondary joint define it, as in ISO 230-1 X and Y do.  Where the directions form a
        left-handed triad (one axis counts backwards) the signs nearest to the file's own frame are taken.
        """
        if self._frame_joints is None:
            frame = np.eye(3)
        else:
            frame = self._frame_of(*self._frame_joints, *self._frame_letters)
        frame.setflags(write=False)
        return frame

    def _frame_of(self, primary: Joint, secondary: Joint, first: int, second: int) -> np.ndarray:
        x = np.array(primary.direction)
        y = np.array(secondary.direction)
        y = y - x * (x @ y)
        y /= np.linalg.norm(y)
        third = 3 - first - second
        even = (first, second, third) in ((0, 1, 2), (1, 2, 0), (2, 0, 1))
        z = np.cross(x, y) if even else np.cross(y, x)
        frame = np.empty((3, 3))
        frame[:, first], frame[:, second], frame[:, third] = x, y, z
        if self._counts_backwards(third, z):
            signs = np.ones((4, 3))
            signs[:, [first, second]] = list(itertools.product((1, -1), repeat=2))
            signs[:, third] = signs[:, first] * signs[:, second]
            frame = max((frame * s for s in signs), key=np.trace)
        return frame

    def _counts_backwards(self, third: int, z: np.ndarray) -> bool:
        """Whether the linear joint of the third frame axis points against z, which completes a right-handed triad."""
        last = next((j for j in self.joints if j.name == "XYZ"[third] and j.slides), None)
        return last is not None and z @ np.array(last.direction) <= 0

    @property
    def left_handed(self) -> bool:
        """Whether the positive directions of X, Y and Z form a left-handed triad; see `frame`."""
        if self._frame_joints is None:
            return False
        first, second = self._frame_letters
        directions = np.zeros((3, 3))
        for axis, joint in zip((first, second), self._frame_joints):
            directions[axis] = joint.direction
        third = 3 - first - second
        directions[third] = np.cross(directions[(third + 1) % 3], directions[(third + 2) % 3])
        return self._counts_backwards(third, directions[third])

    @cached_property
    def _along(self) -> dict[str, int]:
        """The frame axis nearest to each joint's direction, the earliest of X, Y, Z among equals."""
        return {k: int(np.argmax(np.round(np.abs(u), 9))) for k, u in self.directions.items()}

    @cached_property
    def _fixed(self) -> dict[str, tuple[int, ...]]:
        """Rotations of axis lines that define the frame: of the primary joint all, of the secondary that about it."""
        if self._frame_joints is None:
            return {}
        (primary, secondary), (first, _) = self._frame_joints, self._frame_letters
        return {primary.name: (0, 1, 2), secondary.name: (first,)}

    def _in_frame(self, point) -> np.ndarray:
        return self.frame.T @ np.asarray(point, dtype=float)

    @cached_property
    def directions(self) -> dict[str, np.ndarray]:
        """Unit direction of each joint in the machine frame."""
        return {j.name: self._in_frame(j.direction) for j in self.joints}

    @cached_property
    def references(self) -> dict[str, np.ndarray]:
        """Point of every body to which its errors refer, all joints at 0, in the machine frame."""
        ends = {
            "T": self.tool_point if self.spindle_reference is None else self.spindle_reference,
            "W": (0.0, 0.0, 0.0) if self.workpiece_reference is None else self.workpiece_reference,
        }
        return {j.name: self._in_frame(j.point) for j in self.joints} | {k: self._in_frame(p) for k, p in ends.items()}

    def side(self, body: str) -> int:
        """+1 for a tool-side body, -1 for a workpiece-side one."""
        return -1 if body == "W" or body in self.workpiece_chain else 1

    # -- kinematics ----------------------------------------------------------------------------------------------
    def positions(self, q) -> np.ndarray:
        """(P, n) programmed positions from (P, n), (n,) or a flat sequence; mm or rad, in the order of `names`."""
        return np.asarray(q, dtype=float).reshape(-1, len(self.joints))

    def steps(self, q) -> dict[str, Pose]:
        """Nominal motion of each joint at q (P, n), in the frame of what carries it with all joints at 0."""
        q, found = self.positions(q), {}
        for i, j in enumerate(self.joints):
            found[j.name] = j.kind.motion(self.directions[j.name], self.references[j.name], self.side(j.name) * q[:, i])
        return found

    def carriers(self, q, steps=None) -> dict[str, Pose]:
        """Nominal pose of what carries each body at q (P, n), in the machine frame: of the joint before, and for T and
        W of the last joint of their chain."""
        steps = self.steps(q) if steps is None else steps
        found = {}
        for chain, end in ((self.tool_chain, "T"), (self.workpiece_chain, "W")):
            pose = identity(len(self.positions(q)))
            for name in chain:
                found[name] = pose
                pose = pose.then(steps[name])
            found[end] = pose
        return found

    def tool_position(self, q, tool_offset=None) -> np.ndarray:
        """(P, 3) nominal place of the functional point over the workpiece, in the frame of the file, mm.

        The workpiece is taken where it is with all joints at 0.  tool_offset : (3,) or (P, 3), machine frame.
        """
        ends = self.carriers(q)
        tip = ends["T"].move(self._tool_point(tool_offset))
        return (self.frame @ ends["W"].back(tip - ends["W"].shift)).T

    def _tool_point(self, tool_offset) -> np.ndarray:
        """(3,) or (3, P) functional point with all joints at 0, machine frame."""
        point = self._in_frame(self.tool_point)
        if tool_offset is None:
            return point
        return point[:, None] + np.asarray(tool_offset, dtype=float).reshape(-1, 3).T

    # -- lever arms ----------------------------------------------------------------------------------------------
    def lever_arms(self, q, tool_offset=None, frame: str = "machine") -> dict[str, np.ndarray]:
        """Abbe offset of every body at every position: functional point minus reference point, both where they are.

        q : (P, n) programmed positions, mm or rad.  tool_offset : (3,) or (P, 3), functional point minus the declared
        tool point with all joints at 0, mm.  Returns body -> (P, 3) mm, in the axes of what carries the joint, which
        linear joints leave parallel to the machine frame (`frame="file"`: in the axes of the file).
        """
        steps = self.steps(q)
        carriers, references = self.carriers(q, steps), self.references
        tip = carriers["T"].move(self._tool_point(tool_offset))
        arms = {}
        for body in self.bodies:
            here = references[body][:, None] if body in ENDS else steps[body].move(references[body])
            arm = tip - carriers[body].move(here)
            arm = self.frame @ arm if frame == "file" else carriers[body].back(arm)
            arms[body] = np.array(np.broadcast_to(arm, tip.shape)).T
        return arms

    def declared_degree(self, symbol: str) -> int:
        """Degree of the declared function of an error (default 3); 1 or 0 for an error of an axis line."""
        if symbol in self.declared:
            return self.declared[symbol]
        return 1 if self.component(symbol).line else 3


def check_chains(names, workpiece_chain, tool_chain, where: str = "workpiece_chain / tool_chain") -> None:
    """Refuse chains that do not name each of 1 to MOST_JOINTS joints once.  where : what refusals call the chains."""
    chain = (*workpiece_chain, *tool_chain)
    for name in names:
        if names.count(name) > 1:
            raise Refused("machine-joint-twice", "joints", name=name)
    if not 1 <= len(names) <= MOST_JOINTS:
        raise Refused("machine-joint-count", "joints", count=len(names), most=MOST_JOINTS)
    for name in chain:
        if name not in names:
            raise Refused("chain-joint-unknown", where, name=repr(name)[:60], known=list(names))
        if chain.count(name) > 1:
            raise Refused("chain-joint-twice", where, name=name)
    for name in names:
        if name not in chain:
            raise Refused("chain-joint-missing", where, name=name)


_PARALLELS = str.maketrans("UVW", "XYZ")  # secondary linear axes are parallel to X, Y, Z (ISO 841)


def _angle_deg(a: Joint, b: Joint) -> float:
    """Angle between two directions, sense apart, 0 to 90 degrees."""
    return math.degrees(math.acos(min(1.0, abs(float(np.dot(a.direction, b.direction))))))


def structure_chains(code: str) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """(workpiece_chain, tool_chain) of a structure code such as `XYFZ` (workpiece -> tool, F for the bed)."""
    text = code.strip().upper()
    names = re.findall("[A-Z][0-9]?", text)
    joints = [n for n in names if n != "F"]
    whole = "".join(names) == text and names.count("F") == 1 and 1 <= len(joints) <= MOST_JOINTS
    if not whole or len(set(joints)) < len(joints) or set(joints) & {"T", "W", "U"}:
        raise Refused("structure-code-invalid", "structure", code=repr(code)[:60])
    left, right = names[: names.index("F")], names[names.index("F") + 1 :]
    return tuple(reversed(left)), tuple(right)
