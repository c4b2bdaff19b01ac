# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the tool is, seen from the workpiece, with one error at work; and the derivative by that error.

The finite motion is followed point by point, and differentiated by a central difference with the step 1e-25 at 80
digits: the truncation error is below 1e-40 of a column, the rounding error below 1e-50.
"""

from __future__ import annotations

import json
from functools import lru_cache
from pathlib import Path

from mpmath import mp, mpf

mp.dps = 80
STEP = mpf(10) ** -25
LETTERS = "XYZABC"
PARALLEL = {"U": "X", "V": "Y", "W": "Z"}


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def add(a, b, factor=1):
    return [x + factor * y for x, y in zip(a, b)]


def unit(a):
    length = mp.sqrt(dot(a, a))
    return [x / length for x in a]


@lru_cache(maxsize=4096)
def _cosine_and_sine(angle, digits):
    return mp.cos(angle), mp.sin(angle)


def turned(x, axis, angle, about):
    """The point x turned by an angle about the line through `about` along the unit vector `axis` (Rodrigues)."""
    v = add(x, about, -1)
    c, s = _cosine_and_sine(angle, mp.dps)
    along = dot(axis, v) * (1 - c)
    w = cross(axis, v)
    return [about[i] + c * v[i] + s * w[i] + along * axis[i] for i in range(3)]


class Joint:
    """A joint in the machine frame.  Positions in mm or deg."""

    def __init__(self, data, into):
        self.name, self.linear = data["name"], data["kind"] == "linear"
        self.direction, self.point = into(unit(data["direction"])), into(data["point"])

    def move(self, x, q):
        """The point x after a motion by q."""
        if self.linear:
            return add(x, self.direction, q)
        return turned(x, self.direction, q * mp.pi / 180, self.point)


class Machine:
    """A machine.json of version 1 or 2, read with all its decimal digits, in the machine frame."""

    def __init__(self, path):
        data = json.loads(Path(path).read_text(encoding="utf-8"), parse_float=mpf, parse_int=mpf)
        joints = data.get("joints")
        if joints is None:
            joints = [
                {"name": k, "kind": "linear", "direction": a["direction"], "point": a["reference"],
                 "travel": a["travel"]}
                for k, a in ((k, data["axes"][k]) for k in "XYZ")
            ]  # fmt: skip
        self.data = data
        self._find_frame(joints, data.get("frame"))
        self.joints = {j["name"]: Joint(j, self.into) for j in joints}
        self.names = list(self.joints)
        self.travel = [j["travel"] or [mpf(-180), mpf(180)] for j in joints]  # of an endless joint one turn
        self.endless = [j["travel"] is None for j in joints]
        self.tool_chain, self.workpiece_chain = data["tool_chain"], data["workpiece_chain"]
        self.tip = self.into(data["tool_point"])
        self.ends = {
            "T": self.into(data.get("spindle_reference", data["tool_point"])),
            "W": self.into(data.get("workpiece_reference", [0, 0, 0])),
        }
        self.carried = data.get("squareness", "direction") == "carried"

    def _find_frame(self, joints, named):
        """The machine frame: along the primary joint, along the secondary as far as it is square to it, right-handed.

        Of a left-handed triad see `_turn_back`.  Primary and secondary are X and Y, or the first two linear joints that
        are not parallel; with fewer linear joints the frame is that of the file.
        """
        lines = [j for j in joints if j["kind"] == "linear"]
        by_name = {j["name"]: j for j in joints}
        pair = None
        if named:
            pair = by_name[named["primary"]], by_name[named["secondary"]]
        elif "X" in by_name and "Y" in by_name and by_name["X"] in lines and by_name["Y"] in lines:
            pair = by_name["X"], by_name["Y"]
        else:
            for i, a in enumerate(lines):
                for b in lines[i + 1 :]:
                    across = cross(unit(a["direction"]), unit(b["direction"]))
                    if pair is None and mp.sqrt(dot(across, across)) > mp.sin(mp.pi / 180):
                        pair = a, b
        self.primary = self.secondary = None
        self.frame = [[mpf(i == j) for j in range(3)] for i in range(3)]  # rows: the axes of the frame
        if pair is None:
            return
        self.primary, self.secondary = (j["name"] for j in pair)
        first, second = ("XYZ".index(PARALLEL.get(n[0], n[0])) for n in (self.primary, self.secondary))
        self.first = first
        x = unit(pair[0]["direction"])
        y = unit(add(pair[1]["direction"], x, -dot(x, pair[1]["direction"])))
        third = 3 - first - second
        z = cross(x, y) if (first, second, third) in ((0, 1, 2), (1, 2, 0), (2, 0, 1)) else cross(y, x)
        self.frame[first], self.frame[second], self.frame[third] = x, y, z
        for j in lines:
            if j["name"] == "XYZ"[third] and dot(z, unit(j["direction"])) <= 0:
                self._turn_back()

    def _turn_back(self):
        """Of a left-handed triad: a right-handed frame along the same lines, nearest to that of the file.

        Two axes change their sense or none; nearest: the sum of the cosines between the axes of the same letter.
        """
        choices = []
        for unchanged in (None, 0, 1, 2):
            signs = [1 if unchanged in (None, i) else -1 for i in range(3)]
            choices.append((sum(s * self.frame[i][i] for i, s in enumerate(signs)), signs))
        choices.sort(reverse=True)
        if choices[0][0] - choices[1][0] < mpf(1) / 100:
            raise ValueError("two frames are equally near to that of the file")
        self.frame = [[s * v for v in row] for s, row in zip(choices[0][1], self.frame)]

    def into(self, v):
        """A vector of the file in the machine frame."""
        return [dot(row, v) for row in self.frame]

    def symbols(self):
        """Every error: six motions of each joint and of T and W, then those of the axis lines."""
        found = [f"E{a}{body}" for body in (*self.names, "T", "W") for a in LETTERS]
        for name, joint in self.joints.items():
            size = [abs(round(float(v), 9)) for v in joint.direction]
            across = [a for a in range(3) if a != size.index(max(size))]
            if not joint.linear:
                found += [f"{LETTERS[a]}0{name}" for a in across] + [f"{LETTERS[a + 3]}0{name}" for a in across]
            elif name == self.secondary:
                found += [f"{LETTERS[a + 3]}0{name}" for a in across if a != self.first]
            elif name != self.primary:
                found += [f"{LETTERS[a + 3]}0{name}" for a in across]
        return found

    def seen(self, x, q, symbol=None, size=mpf(0)):
        """The point x of the tool (with all joints at 0), seen from the workpiece, with one error of that size.

        x is carried outwards to inwards: by the tool, by the joints of the tool chain from the last to the first, then
        back through the workpiece chain from the first joint to the last, and by the workpiece.
        """
        axis, kind, body = None, None, None
        if symbol:
            body = symbol[2:]
            axis, kind = LETTERS.index(symbol[1] if symbol[0] == "E" else symbol[0]), symbol[0] == "E"
        position = dict(zip(self.names, q))

        def displaced(point, about, amount):
            along = [mpf(i == axis % 3) for i in range(3)]
            return add(point, along, amount) if axis < 3 else turned(point, along, amount, about)

        if body == "T":
            x = displaced(x, self.ends["T"], size)
        for name in reversed(self.tool_chain):
            joint, p = self.joints[name], position[name]
            if name != body:
                x = joint.move(x, p)
            elif kind:  # a motion of the body, about its reference where that now is
                x = displaced(joint.move(x, p), joint.move(joint.point, p), size)
            else:  # the axis line is displaced, and unless that is carried, what it carries is put back
                x = x if self.carried else displaced(x, joint.point, -size)
                x = displaced(joint.move(x, p), joint.point, size)
        for name in self.workpiece_chain:  # the table moves by -p, so its inverse moves by p
            joint, p = self.joints[name], position[name]
            if name != body:
                x = joint.move(x, p)
            elif kind:  # ISO sign: the table moves the other way, and its inverse this way
                x = joint.move(displaced(x, joint.move(joint.point, -p), size), p)
            else:
                x = joint.move(displaced(x, joint.point, -size), p)
                x = x if self.carried else displaced(x, joint.point, size)
        return displaced(x, self.ends["W"], size) if body == "W" else x

    def column(self, symbol, q):
        """(position, orientation): derivatives by the error, mm per mm or rad, rad per rad; 3 numbers each."""
        corners = [self.tip, *(add(self.tip, [mpf(i == k) for i in range(3)]) for k in range(3))]
        plus, minus = ([self.seen(x, q, symbol, s * STEP) for x in corners] for s in (1, -1))
        slope = [[(a - b) / (2 * STEP) for a, b in zip(p, m)] for p, m in zip(plus, minus)]
        now = [self.seen(x, q) for x in corners]
        edges = [add(n, now[0], -1) for n in now[1:]]  # the tool's axes, seen from the workpiece
        turns = [add(s, slope[0], -1) for s in slope[1:]]
        spin = [[sum(turns[k][i] * edges[k][j] for k in range(3)) for j in range(3)] for i in range(3)]
        turn = [(spin[2][1] - spin[1][2]) / 2, (spin[0][2] - spin[2][0]) / 2, (spin[1][0] - spin[0][1]) / 2]
        return slope[0], turn
