# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the tool ends up in the frame of the workpiece, by the exact product of 4x4 matrices, for any serial chain.

The first-order formula of the specification stands beside it, written from its text; the simulator's bounds use it, and
a test holds the two together.  Lengths mm, angles rad, errors in the ISO 230-1 sign (tool relative to workpiece).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

AXES = "XYZ"
BODIES = "XYZTW"
UNIT = {"X": np.array([1.0, 0.0, 0.0]), "Y": np.array([0.0, 1.0, 0.0]), "Z": np.array([0.0, 0.0, 1.0])}
COMPONENTS = tuple(f"E{motion}{body}" for body in BODIES for motion in "XYZABC")
SQUARENESS = ("C0Y", "B0Z", "A0Z")


@dataclass(frozen=True)
class Machine:
    """A chain, `code` from workpiece to tool with F for the bed, and where its reference points are at home, mm."""

    code: str
    reference: dict
    travel: dict
    tool_point: tuple

    @property
    def workpiece_chain(self) -> list[str]:
        """The workpiece's carriages, from the bed outwards."""
        return list(reversed(self.code.split("F")[0]))

    @property
    def tool_chain(self) -> list[str]:
        """The tool's carriages, from the bed outwards."""
        return list(self.code.split("F")[1])

    def as_dict(self) -> dict:
        """machine.json as the specification writes it."""
        return {
            "format": "sens-machine",
            "version": 1,
            "name": "machine",
            "workpiece_chain": self.workpiece_chain,
            "tool_chain": self.tool_chain,
            "axes": {
                k: {
                    "direction": UNIT[k].tolist(),
                    "travel": [float(v) for v in self.travel[k]],
                    "reference": [float(v) for v in self.reference[k]],
                }
                for k in AXES
            },
            "tool_point": [float(v) for v in self.tool_point],
            "declared": {f"E{m}{k}": {"shape": "polynomial", "degree": 3} for k in AXES for m in "XYZABC"},
        }


def from_dict(data: dict) -> Machine:
    """The machine of a machine.json (orthogonal axes, nothing but what the simulator writes)."""
    code = "".join(reversed(data["workpiece_chain"])) + "F" + "".join(data["tool_chain"])
    axes = data["axes"]
    return Machine(
        code, {k: axes[k]["reference"] for k in AXES}, {k: axes[k]["travel"] for k in AXES}, tuple(data["tool_point"])
    )


def _shift(vector: np.ndarray) -> np.ndarray:
    matrix = np.broadcast_to(np.eye(4), (len(vector), 4, 4)).copy()
    matrix[:, :3, 3] = vector
    return matrix


def _turn(angles: np.ndarray) -> np.ndarray:
    """Rotation matrices Rx Ry Rz of (N, 3) angles."""
    ca, cb, cc = np.cos(angles).T
    sa, sb, sc = np.sin(angles).T
    matrix = np.zeros((len(angles), 4, 4))
    matrix[:, 0, :3] = np.stack([cb * cc, -cb * sc, sb], axis=1)
    matrix[:, 1, :3] = np.stack([ca * sc + sa * sb * cc, ca * cc - sa * sb * sc, -sa * cb], axis=1)
    matrix[:, 2, :3] = np.stack([sa * sc - ca * sb * cc, sa * cc + ca * sb * sc, ca * cb], axis=1)
    matrix[:, 3, 3] = 1.0
    return matrix


def _motion(values: dict, body: str, count: int) -> tuple[np.ndarray, np.ndarray]:
    """(N, 3) displacements and rotations of one body, 0 where nothing is given."""
    take = lambda motions: np.stack(  # noqa: E731
        [np.broadcast_to(np.asarray(values.get(f"E{m}{body}", 0.0), dtype=float), count) for m in motions], axis=1
    )
    return take("XYZ"), take("ABC")


def _tilt(values: dict, axis: str, q: np.ndarray) -> np.ndarray:
    """(N, 3) displacement by squareness: q_k (s_k x u_k)."""
    s = {
        "X": (0.0, 0.0, 0.0),
        "Y": (0.0, 0.0, values.get("C0Y", 0.0)),
        "Z": (values.get("A0Z", 0.0), values.get("B0Z", 0.0), 0.0),
    }[axis]
    return q[:, None] * np.cross(np.asarray(s, dtype=float), UNIT[axis])


def _body(displacement, rotation, pivot) -> np.ndarray:
    """A small motion: turn about `pivot`, then shift."""
    pivot = np.broadcast_to(np.asarray(pivot, dtype=float), displacement.shape)
    return _shift(displacement + pivot) @ _turn(rotation) @ _shift(-pivot)


def exact_error(machine: Machine, q, values: dict, tool_offset=0.0) -> np.ndarray:
    """(N, 3) mm: actual minus commanded tool position in the workpiece frame.

    q : (N, 3) programmed positions.  values : component -> number or (N,), mm or rad; squareness are numbers.
    tool_offset : functional point minus tool_point, (3,) or (N, 3).
    """
    q = np.asarray(q, dtype=float)
    count = len(q)
    point = np.asarray(machine.tool_point, dtype=float) + np.broadcast_to(tool_offset, (count, 3))
    tool = np.broadcast_to(np.eye(4), (count, 4, 4))
    for axis in machine.tool_chain:
        along = q[:, AXES.index(axis)]
        displacement, rotation = _motion(values, axis, count)
        displacement = displacement + _tilt(values, axis, along) + along[:, None] * UNIT[axis]
        tool = tool @ _body(displacement, rotation, machine.reference[axis])
    tool = tool @ _body(*_motion(values, "T", count), machine.tool_point)
    work = np.broadcast_to(np.eye(4), (count, 4, 4))
    for axis in machine.workpiece_chain:
        along = q[:, AXES.index(axis)]
        displacement, rotation = _motion(values, axis, count)
        displacement = displacement + _tilt(values, axis, along) + along[:, None] * UNIT[axis]
        # a table that goes the other way: its motion is the inverse of the tool's equivalent motion about a point that
        # rides on it, so the error keeps the sign "tool relative to workpiece"
        pivot = np.broadcast_to(np.asarray(machine.reference[axis], dtype=float), displacement.shape)
        work = work @ _shift(pivot - displacement) @ _turn(rotation).swapaxes(1, 2) @ _shift(-pivot)
    displacement, rotation = _motion(values, "W", count)
    work = work @ _shift(-displacement) @ _turn(rotation).swapaxes(1, 2)
    homogeneous = np.concatenate([point, np.ones((count, 1))], axis=1)[:, :, None]
    actual = np.linalg.solve(work, tool @ homogeneous)[:, :3, 0]
    return actual - (point + q)


def levers(machine: Machine, q, tool_offset=0.0) -> dict:
    """Body -> (N, 3): functional point minus reference, both where they are at q."""
    q = np.asarray(q, dtype=float)
    point = np.asarray(machine.tool_point, dtype=float) + np.broadcast_to(tool_offset, q.shape)
    arms = {"W": point + q, "T": point - np.asarray(machine.tool_point)}
    step = {k: q[:, [AXES.index(k)]] * UNIT[k] for k in AXES}
    for place, axis in enumerate(machine.tool_chain):
        beyond = sum((step[j] for j in machine.tool_chain[place + 1 :]), np.zeros_like(q))
        arms[axis] = point + beyond - np.asarray(machine.reference[axis])
    on_tool = sum((step[j] for j in machine.tool_chain), np.zeros_like(q))
    for place, axis in enumerate(machine.workpiece_chain):
        below = sum((step[j] for j in machine.workpiece_chain[: place + 1]), np.zeros_like(q))
        arms[axis] = point + on_tool + below - np.asarray(machine.reference[axis])
    return arms


def direction_of(component: str, arms: dict) -> np.ndarray:
    """(N, 3) the error that one mm or one rad of the component makes, to first order."""
    arm = arms[component[2]]
    if component[1] in AXES:
        return np.broadcast_to(UNIT[component[1]], arm.shape)
    return np.cross(UNIT["XYZ"["ABC".index(component[1])]], arm)


def linear_error(machine: Machine, q, values: dict, tool_offset=0.0) -> np.ndarray:
    """The first-order formula of the specification, section 3."""
    q = np.asarray(q, dtype=float)
    arms = levers(machine, q, tool_offset)
    total = sum(_tilt(values, k, q[:, AXES.index(k)]) for k in AXES)
    for name in COMPONENTS:
        if name in values:
            total = total + np.broadcast_to(values[name], len(q))[:, None] * direction_of(name, arms)
    return total
