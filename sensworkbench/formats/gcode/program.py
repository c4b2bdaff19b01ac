# SPDX-License-Identifier: LGPL-2.1-or-later
"""A G-code program becomes moves of a machine's joints (`core.toolpath.Moves`).

What the program does not say is never guessed: an unknown beginning, an arc without centre, cutting without feed and a
work coordinate system without offset are refused.  Words without a meaning here are listed with line and count; words
that would move the machine otherwise than is read here (rotations, polar coordinates, subprograms, parameters) are
refused.  One pass, so time grows with the size of the file.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from sensworkbench.core.joints import Joint
from sensworkbench.core.refusal import Refused
from sensworkbench.core.toolpath import ARC, LINE, RAPID, Moves
from sensworkbench.messages import Message

from ..files import read_bytes
from ..json_text import short
from .words import words

LIMIT = 256 * 2**20  # bytes
MOST_BLOCKS = 2_000_000
MOST_REPEATS = 10_000  # of a drilling cycle
ARC_MM = 0.02  # radii at the two ends of an arc may differ by this: programs are rounded
_FULL = 1e-7  # mm: ends of an arc that are one point

# groups of G words that are understood; values times 10, so that 90.1 is a whole number
_MOTION = {0: RAPID, 10: LINE, 20: ARC, 30: ARC}
_PLANES = {170: 2, 180: 1, 190: 0}
_OFFSETS = {540: "G54", 550: "G55", 560: "G56", 570: "G57", 580: "G58", 590: "G59"}
_OFFSETS |= {591: "G59.1", 592: "G59.2", 593: "G59.3"}
_CYCLES = {730, 810, 820, 830, 840, 850, 860, 880, 890}
_FEED_BACK = {840, 850, 890}  # cycles that leave the hole at feed
_PLAIN = {40, 90, 100, 150, 200, 210, 280, 300, 400, 410, 420, 430, 490, 500, 530, 610, 640, 690, 800, 900, 901, 910}
_PLAIN |= {911, 940, 970, 980, 990}
_KNOWN = {*_MOTION, *_PLANES, *_OFFSETS, *_CYCLES, *_PLAIN}
_MOVES_OTHERWISE = {50, 51, 52, 53, 60, 61, 62, 63, 70, 71, 120, 121, 130, 131, 160, 330, 331, 340, 350, 360}
_MOVES_OTHERWISE |= {411, 412, 413, 421, 422, 431, 434, 435, 440, 450, 460, 470, 480, 501, 510, 511, 520, 531, 541, 542}
_MOVES_OTHERWISE |= {650, 660, 661, 670, 680, 681, 682, 683, 700, 710, 720, 740, 750, 760, 770, 780, 790, 870}
_MOVES_OTHERWISE |= {920, 921, 922, 923, 930, 950, 310, 311, 312, 370, 383, 384, 382, 385}
_MOVES_OTHERWISE -= {51}  # G5.1 Q.. (smoothing) changes no path; G5 and G5.2 do
_M_KNOWN = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 30, 48, 49, 60}
_M_CALLS = {96, 97, 98, 99, 198}
_AXES = "XYZABCUVW"


@dataclass(frozen=True)
class Tool:
    """length : mm by which its tip stands beyond the machine's tool point; None: not stated.  radius : of its edge,
    mm, None: not stated.  ball : whether its end is a half sphere."""

    length: float | None = None
    radius: float | None = None
    ball: bool = False


@dataclass(frozen=True)
class Settings:
    """What a program needs besides its text.  offsets : "G54" -> mm (rad) per joint.  tools : number -> Tool."""

    offsets: Mapping[str, tuple[float, ...]] = field(default_factory=dict)
    tools: Mapping[int, Tool] = field(default_factory=dict)


@dataclass(frozen=True)
class Program:
    """moves : of the machine.  lines : (B, 2) first and last byte + 1 of every line.  scale, incremental, machine_frame
    : (M,) how the block of each move states its end: mm per unit, relative, and in the machine's coordinates.  cycle
    : (M,) whether a cycle made it.  number : (M,) N word of the block, -1 without one.  tool : (M,) in the spindle.
    unread : (word, first line, count).  assumed : G words that hold because none of their group was read.  comments :
    (line, text).  text : of the file, one character a byte.
    """

    source: str
    text: str
    moves: Moves
    lines: np.ndarray
    scale: np.ndarray
    incremental: np.ndarray
    machine_frame: np.ndarray
    cycle: np.ndarray
    number: np.ndarray
    tool: np.ndarray
    unread: tuple[tuple[str, int, int], ...]
    assumed: tuple[str, ...]
    remarks: tuple[Message, ...]
    comments: tuple[tuple[int, str], ...]


def load(path, joints: tuple[Joint, ...], settings: Settings = Settings()) -> Program:
    """The program in a file.  joints : of the machine."""
    return loads(read_bytes(path, LIMIT), str(path), joints, settings)


def loads(data: bytes, source: str, joints: tuple[Joint, ...], settings: Settings = Settings()) -> Program:
    """The program in bytes; see `load`."""
    reader = _Reader(source, joints, settings)
    text = data.decode("latin-1")
    bounds, at = [], 0
    for number, line in enumerate(text.split("\n"), start=1):
        if number > MOST_BLOCKS:
            raise Refused("gcode-too-long", source, limit=MOST_BLOCKS)
        bounds.append((at, at + len(line)))
        at += len(line) + 1
        if line and not line.isspace():
            reader.block(number, line)
    if not reader.rows:
        raise Refused("gcode-no-moves", source)
    return reader.program(text, np.array(bounds))


class _Reader:
    """The state of a controller, as far as it decides the path."""

    def __init__(self, source: str, joints: tuple[Joint, ...], settings: Settings):
        self.source, self.joints = source, joints
        self.letters = {j.name: i for i, j in enumerate(joints) if len(j.name) == 1}
        self.turns = [j.kind.angular for j in joints]
        self.xyz = tuple(self.letters.get(k, -1) if self._slides(k) else -1 for k in "XYZ")
        self.offsets, self.tools = dict(settings.offsets), dict(settings.tools)
        self.motion: int | None = None
        self.plane, self.scale, self.incremental, self.arc_absolute = 2, 1.0, False, False
        self.system, self.length, self.side, self.radius = "G54", 0.0, 0, 0.0
        self.entering = False
        self.feed, self.spindle, self.tool, self.next_tool = math.nan, 0.0, 0, 0
        self.cycle: dict | None = None
        self.back_to_r = False
        self.at: list[float | None] = [None] * len(joints)
        self.rows: list[tuple] = []
        self.unread: dict[str, list[int]] = {}
        self.remarks: dict[tuple[str, int], int] = {}
        self.stated: set[str] = set()
        self.comments: list[tuple[int, str]] = []
        self.where, self.line, self.number, self.ended = "", 0, -1, False

    def _slides(self, name: str) -> bool:
        return name in self.letters and not self.turns[self.letters[name]]

    # -- one block ---------------------------------------------------------------------------------------------------
    def block(self, line: int, text: str) -> None:
        """Read one line."""
        self.line, self.where, self.number = line, f"{self.source}, line {line}", -1
        found, marks, comment = words(text, self.where)
        if comment:
            self.comments.append((line, comment))
        for mark in marks:
            self._list(mark)
        if self.ended or not found:
            return
        values: dict[str, float] = {}
        codes: list[int] = []
        stops: list[int] = []
        for word in found:
            if word.letter == "G":
                self._code(word, codes)
            elif word.letter == "M":
                self._auxiliary(word, stops)
            elif word.letter == "O":
                if len(found) > 1:
                    raise Refused("gcode-subprogram", self.where, word=word.text)
                self._list(word.text)
            elif word.letter in values:
                raise Refused("gcode-word-twice", self.where, letter=word.letter)
            else:
                values[word.letter] = word.value
        if "N" in values:
            self.number = int(values.pop("N"))
        self._run(codes, values, stops)
        for letter in values:  # what nothing has taken
            text = next(w.text for w in found if w.letter == letter)
            self._list(text if letter not in "PQLK" else letter)

    def _list(self, word: str) -> None:
        if word in self.unread or len(self.unread) < 1000:
            self.unread.setdefault(word, [self.line, 0])[1] += 1

    def _code(self, word, codes) -> None:
        tenths = round(word.value * 10)
        if abs(tenths / 10 - word.value) > 1e-9 or tenths < 0 or tenths not in _KNOWN:
            if tenths in _MOVES_OTHERWISE and abs(tenths / 10 - word.value) < 1e-9:
                raise Refused("gcode-moves-otherwise", self.where, word=word.text)
            self._list(word.text)
            return
        codes.append(tenths)

    def _auxiliary(self, word, stops) -> None:
        code = round(word.value)
        if code in _M_CALLS and code == word.value:
            raise Refused("gcode-subprogram", self.where, word=word.text)
        if code not in _M_KNOWN or code != word.value:
            self._list(word.text)
            return
        stops.append(code)

    def _run(self, codes: list[int], values: dict[str, float], stops: list[int]) -> None:
        """Set the modes of a block, then do what it does."""
        if "F" in values:
            self.feed = values.pop("F") * (25.4 if self._inches(codes) else 1.0)
        if "S" in values:
            self.spindle = values.pop("S")
        if "T" in values:
            self.next_tool = int(values.pop("T"))
        if 6 in stops:
            self.tool = self.next_tool
        if 640 in codes:  # how closely the controller follows the path
            values.pop("P", None)
            values.pop("Q", None)
        only_once = [c for c in codes if c in (40, 90, 100, 280, 300, 530)]
        for code in codes:
            self._mode(code, values)
        if 40 in only_once:
            self._dwell(values)
        elif 100 in only_once:
            self._offset_in_program(values)
        elif 280 in only_once or 300 in only_once:
            self._home(values)
        elif any(letter in values for letter in (*_AXES, "I", "J", "K", "R")) or (
            self.cycle is not None and any(c in _CYCLES for c in codes)
        ):
            self._move(values, 530 in only_once)
        if 2 in stops or 30 in stops:
            self.ended = True

    def _inches(self, codes) -> bool:
        if 200 in codes or 210 in codes:
            return 200 in codes
        return self.scale != 1.0

    def _mode(self, code: int, values: dict[str, float]) -> None:
        if code in _MOTION:
            self.motion, self.cycle = code, None
        elif code in _PLANES:
            self.plane = _PLANES[code]
            self.stated.add("plane")
        elif code in (200, 210):
            self.scale = 25.4 if code == 200 else 1.0
            self.stated.add("unit")
        elif code in (900, 910):
            self.incremental = code == 910
            self.stated.add("distance")
        elif code in (901, 911):
            self.arc_absolute = code == 901
        elif code in _OFFSETS:
            self.system = _OFFSETS[code]
            self.stated.add("system")
        elif code in (430, 490):
            self._tool_length(code == 430, values)
        elif code in (400, 410, 420):
            self._cutter(code, values)
        elif code in (980, 990):
            self.back_to_r = code == 990
        elif code == 800:
            self.cycle = None
        elif code in _CYCLES:
            self.cycle = {"code": code, "initial": None}

    def _tool_length(self, on: bool, values) -> None:
        number = int(values.pop("H", self.tool)) if on else 0
        tool = self.tools.get(number, Tool())
        if on and tool.length is None:
            self.remarks.setdefault(("part-tool-length", number), self.line)
        self.length = (tool.length or 0.0) if on else 0.0

    def _cutter(self, code: int, values) -> None:
        if code == 400:
            self.side, self.radius = 0, 0.0
            return
        number = int(values.pop("D", self.tool))
        tool = self.tools.get(number, Tool())
        if tool.radius is None:
            raise Refused("gcode-cutter-without-radius", self.where, tool=number)
        self.entering = self.side == 0
        self.side, self.radius = (1 if code == 410 else -1), tool.radius

    def _offset_in_program(self, values) -> None:
        """G10 L2 P1 X.. Y.. Z..: the offset of G54 and so on."""
        kind, number = values.pop("L", None), int(values.pop("P", 0))
        if kind != 2 or not 1 <= number <= 9:
            raise Refused("gcode-moves-otherwise", self.where, word="G10")
        name = list(_OFFSETS.values())[number - 1]
        old = self.offsets.get(name, (0.0,) * len(self.joints))
        new = list(old)
        for letter in _AXES:
            if letter in values and letter in self.letters:
                i = self.letters[letter]
                new[i] = self._size(i, values.pop(letter)) + (old[i] if self.incremental else 0.0)
        self.offsets[name] = tuple(new)

    def _dwell(self, values) -> None:
        seconds = values.pop("P", None)
        seconds = values.pop("X", values.pop("U", 0.0)) if seconds is None else seconds
        self.remarks.setdefault(("part-dwell", 0), self.line)
        if self.rows and 0 <= seconds < 1e6:
            row = list(self.rows[-1])
            row[_DWELL] += seconds
            self.rows[-1] = tuple(row)

    def _home(self, values) -> None:
        """G28, G30: the reference position is the machine's own, so the axes' positions are not known then."""
        named = [letter for letter in _AXES if letter in values and letter in self.letters]
        for letter in [letter for letter in _AXES if letter in values]:
            values.pop(letter)
        for letter in named or self.letters:
            self.at[self.letters[letter]] = None

    # -- motion ------------------------------------------------------------------------------------------------------
    def _size(self, i: int, value: float) -> float:
        return math.radians(value) if self.turns[i] else value * self.scale

    def _shift(self, machine_frame: bool) -> list[float]:
        """Position less the coordinates of the program, per joint."""
        if machine_frame:
            return [0.0] * len(self.joints)
        if self.system not in self.offsets:
            raise Refused("gcode-no-work-offset", self.where, system=self.system)
        shift = list(self.offsets[self.system])
        if self.length and self.xyz[2] >= 0:
            shift[self.xyz[2]] += self.length
        return shift

    def _targets(self, values, machine_frame: bool) -> tuple[list[float | None], list[float]]:
        shift, end = self._shift(machine_frame), list(self.at)
        for letter in _AXES:
            if letter not in values:
                continue
            value = values[letter]
            if letter not in self.letters:
                if value != 0.0 or letter in "XYZ":
                    raise Refused("gcode-axis-missing", self.where, letter=letter, known=list(self.letters))
                continue
            values.pop(letter)
            i = self.letters[letter]
            size = self._size(i, value)
            if self.incremental and not machine_frame:
                if self.at[i] is None:
                    raise Refused("gcode-place-unknown", self.where, axis=letter)
                end[i] = self.at[i] + size
            else:
                end[i] = size + shift[i]
        return end, shift

    def _move(self, values, machine_frame: bool) -> None:
        if self.cycle is not None:
            self._drill(values)
            return
        if self.motion is None:
            raise Refused("gcode-no-motion", self.where)
        end, shift = self._targets(values, machine_frame)
        kind = _MOTION[self.motion]
        centre, sweep = (0.0, 0.0, 0.0), 0.0
        if kind == ARC:
            centre, sweep = self._arc(values, end, shift)
        elif end == self.at and self.rows:
            return
        self._add(kind, end, shift, centre, sweep, machine_frame)

    def _add(self, kind, end, shift, centre=(0.0, 0.0, 0.0), sweep=0.0, machine_frame=False, cycle=False) -> None:
        known = None not in self.at
        if kind != RAPID:
            if not known:
                axis = self.joints[self.at.index(None)].name
                raise Refused("gcode-place-unknown", self.where, axis=axis)
            if not self.feed > 0:
                raise Refused("gcode-no-feed", self.where)
        if None in end:
            self.at = end  # a rapid of some axes, before the others are known
            return
        begin = self.at if known else end
        row = (kind, begin, end, known, centre, self.plane, sweep, self.feed if kind != RAPID else math.nan, 0.0)
        row += (self.spindle, self.line, shift, self.length, self.side, self.radius)
        row += (not self.entering and kind != RAPID, self.scale, self.incremental, machine_frame, cycle)
        self.rows.append((*row, self.number, self.tool))
        if kind != RAPID or self.side:
            self.entering = False
        self.at = list(end)

    def _arc(self, values, end, shift) -> tuple[tuple, float]:
        """(centre along X, Y, Z, angle) of the arc from here to `end`."""
        a, b = ((1, 2), (2, 0), (0, 1))[self.plane]
        i, j = self.xyz[a], self.xyz[b]
        if i < 0 or j < 0:
            raise Refused("gcode-axis-missing", self.where, letter="XYZ"[a if i < 0 else b], known=list(self.letters))
        if self.at[i] is None or self.at[j] is None:
            raise Refused("gcode-place-unknown", self.where, axis="XYZ"[a if self.at[i] is None else b])
        clockwise = self.motion == 20
        begin, goal = (self.at[i], self.at[j]), (end[i], end[j])
        full = math.dist(begin, goal) < _FULL
        turns = int(values.pop("P", 1)) if 1 <= values.get("P", 1) <= 1000 else 1
        if "R" in values and "IJK"[a] not in values and "IJK"[b] not in values:
            middle = self._by_radius(values.pop("R") * self.scale, begin, goal, clockwise, full)
        else:
            given = [values.pop("IJK"[k], None) for k in (a, b)]
            if given[0] is None and given[1] is None:
                raise Refused("gcode-arc-without-centre", self.where, words=f"{'IJK'[a]}, {'IJK'[b]}")
            parts = [0.0 if g is None else g * self.scale for g in given]
            if self.arc_absolute:
                if None in given:
                    raise Refused("gcode-arc-without-centre", self.where, words=f"{'IJK'[a]}, {'IJK'[b]}")
                middle = parts[0] + shift[i], parts[1] + shift[j]
            else:
                middle = begin[0] + parts[0], begin[1] + parts[1]
        radii = math.dist(begin, middle), math.dist(goal, middle)
        if radii[0] < _FULL or abs(radii[0] - radii[1]) > ARC_MM:
            raise Refused("gcode-arc-radii", self.where, first=radii[0], last=radii[1], limit=ARC_MM)
        if self.side and self.side * (-1 if clockwise else 1) > 0 and self.radius >= radii[0]:
            raise Refused("gcode-cutter-too-large", self.where, radius=self.radius, arc=radii[0])
        start = math.atan2(begin[1] - middle[1], begin[0] - middle[0])
        stop = math.atan2(goal[1] - middle[1], goal[0] - middle[0])
        sweep = 2 * math.pi if full else (stop - start) % (2 * math.pi)
        if clockwise:
            sweep = -2 * math.pi if full else sweep - 2 * math.pi
        sweep += math.copysign(2 * math.pi * (turns - 1), sweep)
        centre = [0.0, 0.0, 0.0]
        centre[a], centre[b] = middle
        return tuple(centre), sweep

    def _by_radius(self, radius, begin, goal, clockwise: bool, full: bool) -> tuple[float, float]:
        chord = math.dist(begin, goal)
        if full or radius == 0 or chord / 2 > abs(radius) + ARC_MM:
            raise Refused("gcode-arc-radius", self.where, radius=radius, chord=chord)
        height = math.sqrt(max(radius * radius - chord * chord / 4, 0.0))
        left = 1.0 if (radius > 0) != clockwise else -1.0
        x, y = (goal[0] - begin[0]) / chord, (goal[1] - begin[1]) / chord
        return (begin[0] + goal[0]) / 2 - left * height * y, (begin[1] + goal[1]) / 2 + left * height * x

    def _drill(self, values) -> None:
        """One hole, or `L` of them with G91: rapid across, rapid to R, feed to Z, back."""
        if self.plane != 2 or self.xyz[2] < 0:
            raise Refused("gcode-cycle-plane", self.where)
        cycle, z = self.cycle, self.xyz[2]
        shift = self._shift(False)
        if self.at[z] is None:
            raise Refused("gcode-place-unknown", self.where, axis="Z")
        if cycle["initial"] is None:
            cycle["initial"] = self.at[z]
        if "R" in values:
            r = values.pop("R") * self.scale
            cycle["r"] = self.at[z] + r if self.incremental else r + shift[z]
        if "Z" in values:
            depth = values.pop("Z") * self.scale
            if "r" not in cycle:
                raise Refused("gcode-cycle-incomplete", self.where, words="R")
            cycle["z"] = cycle["r"] + depth if self.incremental else depth + shift[z]
        if "r" not in cycle or "z" not in cycle:
            raise Refused("gcode-cycle-incomplete", self.where, words="R, Z")
        repeats = values.pop("L", 1.0)
        repeats = int(values.pop("K", repeats))
        cycle["dwell"] = values.pop("P", cycle.get("dwell", 0.0))
        for letter in "QIJ":
            values.pop(letter, None)
        if not 0 <= repeats <= MOST_REPEATS:
            raise Refused("gcode-cycle-repeats", self.where, count=repeats, limit=MOST_REPEATS)
        across = {k: values.pop(k) for k in list(values) if k in _AXES}
        for _ in range(repeats):
            end, _ = self._targets(dict(across), False)
            self._add(RAPID, end, shift, cycle=True)
            steps = [(RAPID, cycle["r"]), (LINE, cycle["z"])]
            steps += [(LINE, cycle["r"])] if cycle["code"] in _FEED_BACK else []
            steps += [(RAPID, cycle["r"] if self.back_to_r else max(cycle["initial"], cycle["r"]))]
            for kind, height in steps:
                place = list(self.at)
                place[z] = height
                if place != self.at:
                    self._add(kind, place, shift, cycle=True)

    # -- the result --------------------------------------------------------------------------------------------------
    def program(self, text: str, lines: np.ndarray) -> Program:
        """Everything that was read."""
        columns = list(zip(*self.rows))
        array = lambda i, kind=float: np.array(columns[i], dtype=kind)  # noqa: E731
        moves = Moves(
            kind=array(0, int), begin=array(1), end=array(2), known=array(3, bool), centre=array(4),
            plane=array(5, int), sweep=array(6), feed=array(7), dwell=array(8), spindle=array(9), block=array(10, int),
            shift=array(11), length=array(12), side=array(13, int), radius=array(14), surface=array(15, bool),
            xyz=self.xyz,
        )  # fmt: skip
        groups = {"unit": "G21", "distance": "G90", "plane": "G17", "system": "G54"}
        return Program(
            source=self.source,
            text=text,
            moves=moves,
            lines=lines,
            scale=array(16),
            incremental=array(17, bool),
            machine_frame=array(18, bool),
            cycle=array(19, bool),
            number=array(20, int),
            tool=array(21, int),
            unread=tuple((short(w)[1:-1], line, count) for w, (line, count) in self.unread.items()),
            assumed=tuple(code for group, code in groups.items() if group not in self.stated),
            remarks=tuple(Message(code, number=number, line=line) for (code, number), line in self.remarks.items()),
            comments=tuple(self.comments),
        )


_DWELL = 8
