# SPDX-License-Identifier: LGPL-2.1-or-later
"""How joints displace bodies, as FreeCAD placements in document coordinates.

`core.joints` says how a joint moves; nothing here asks whether it is linear or rotary.  A displacement is the motion
from where a body is with all joints at 0 to where it is.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import FreeCAD as App
import numpy as np

from ..core.joints import JointKind, Pose
from .tree import BED, ENDS


def placement(pose: Pose) -> App.Placement:
    """The placement of a pose at one position."""
    base = App.Vector(*pose.shift[:, 0].tolist())
    if pose.rotation is None:
        return App.Placement(base, App.Rotation())
    rows = np.eye(4)
    rows[:3, :3] = pose.rotation[:, :, 0]
    return App.Placement(base, App.Placement(App.Matrix(*rows.ravel().tolist())).Rotation)


def motion(kind: JointKind, direction, point, q: float) -> App.Placement:
    """Motion of one joint from 0 to q (mm or rad) along or about the line through `point`.  direction : unit vector."""
    return placement(kind.motion(np.array(tuple(direction)), np.array(tuple(point)), np.array([float(q)])))


def displacements(
    workpiece_chain: Sequence[str], tool_chain: Sequence[str], step: Callable[[str, int, dict, str], App.Placement]
) -> dict[str, App.Placement]:
    """Displacement of every body: bed, joints, T, W.

    step(name, sign, found, carrier) : motion of a joint as it would be with what carries it at home; sign +1 on the
    tool side, -1 on the workpiece side (there q counts the other way); found : displacements so far, of the body
    `carrier` that carries the joint among them.
    """
    found = {BED: App.Placement()}
    for sign, chain, end in ((1, tool_chain, ENDS[0]), (-1, workpiece_chain, ENDS[1])):
        carrier = BED
        for name in chain:
            found[name] = found[carrier] * step(name, sign, found, carrier)
            carrier = name
        found[end] = found[carrier]
    return found


def of_machine(core, q: dict[str, float]) -> dict[str, App.Placement]:
    """`displacements` of a core machine at positions q (joint -> mm or rad)."""

    def step(name, sign, found, carrier):
        joint = core.joint(name)
        return motion(joint.kind, joint.direction, joint.point, sign * q[name])

    return displacements(core.workpiece_chain, core.tool_chain, step)


def is_shift(motion: App.Placement) -> bool:
    """Whether a motion turns nothing; then it is applied by adding, exactly."""
    return motion.Rotation.Q == (0.0, 0.0, 0.0, 1.0)


def moved(motion: App.Placement, where: App.Placement) -> App.Placement:
    """A placement after a motion."""
    if is_shift(motion):
        return App.Placement(where.Base + motion.Base, where.Rotation)
    return motion * where


def moved_back(motion: App.Placement, where: App.Placement) -> App.Placement:
    """A placement before a motion."""
    if is_shift(motion):
        return App.Placement(where.Base - motion.Base, where.Rotation)
    return motion.inverse() * where


def relative(motion: App.Placement, carrier: App.Placement) -> App.Placement:
    """The motion as it is seen from a carrier that is displaced itself."""
    if is_shift(motion) and is_shift(carrier):
        return App.Placement(motion.Base - carrier.Base, App.Rotation())
    return carrier.inverse() * motion


def relative_to_now(after: App.Placement, before: App.Placement) -> App.Placement:
    """The motion from one displacement of a body to another, in document coordinates."""
    if is_shift(after) and is_shift(before):
        return App.Placement(after.Base - before.Base, App.Rotation())
    return after * before.inverse()


def seen_from(motion: App.Placement, frame: App.Placement) -> App.Placement:
    """A motion in the coordinates of `frame` (a container, with all joints at 0)."""
    if is_shift(motion):
        return App.Placement(frame.Rotation.inverted().multVec(motion.Base), App.Rotation())
    return frame.inverse() * motion * frame


def is_still(motion: App.Placement) -> bool:
    """Whether a motion moves nothing at all."""
    return is_shift(motion) and motion.Base.Length == 0
