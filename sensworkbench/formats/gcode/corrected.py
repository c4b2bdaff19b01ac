# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program with other points: blocks that move are written anew, everything else stays byte for byte.

A block keeps its number, feed, tool, comment and other words; its axis words (and the centre of an arc) are replaced by
lines to the new points, the first of them in its own line.  What ends a block (M0, M5, M9, M30 ...) goes to the last.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sensworkbench.core.toolpath import RAPID

from .program import Program
from .words import words

DECIMALS = {1.0: 4, 25.4: 6}  # of a coordinate, by the unit of the program
_AT_END = {0, 1, 2, 5, 9, 30, 60}


def kept(program: Program) -> np.ndarray:
    """(M,) moves that are not written anew: in machine coordinates, and holes that are repeated or relative."""
    holes = np.zeros(len(program.moves), dtype=bool)
    rows = np.flatnonzero(program.cycle)
    if len(rows):
        blocks, count = np.unique(program.moves.block[rows[program.moves.kind[rows] != RAPID]], return_counts=True)
        single = blocks[count <= 2]  # one hole: into it at feed, and perhaps out of it
        holes[rows] = ~np.isin(program.moves.block[rows], single) | program.incremental[rows]
    return program.machine_frame | holes


def written(program: Program, points: Sequence[np.ndarray]) -> bytes:
    """The program with the ends (k, J) of the pieces of each move, mm, in its own units and words."""
    moves, stays = program.moves, kept(program)
    text, out, at = program.text, [], 0
    commanded: np.ndarray | None = None
    order = np.arange(len(moves))
    cuts = np.flatnonzero(np.diff(moves.block, prepend=-1))
    for rows in np.split(order, cuts[1:]):
        begin, end = program.lines[moves.block[rows[0]] - 1]
        line = text[begin:end]
        if stays[rows].any():
            commanded = moves.end[rows[-1]].copy()
            continue
        if program.cycle[rows[0]]:
            new, commanded = _hole(program, rows, line, points), moves.end[rows[-1]].copy()
        else:
            new, commanded = _block(program, rows[0], line, points[rows[0]], commanded)
        out += [text[at:begin], new]
        at = end
    out.append(text[at:])
    return "".join(out).encode("latin-1")


def _coordinates(program: Program, m: int, point, commanded) -> tuple[str, np.ndarray]:
    """(words X, Y, Z, where the controller then is) of one point."""
    scale, shift = program.scale[m], program.moves.shift[m]
    decimals, found = DECIMALS.get(float(scale), 6), []
    reached = np.array(point, dtype=float)
    for letter, j in zip("XYZ", program.moves.xyz):
        base = commanded[j] if program.incremental[m] else shift[j]
        value = round((point[j] - base) / scale, decimals)
        reached[j] = base + value * scale
        found.append(f"{letter}{_number(value, decimals)}")
    return " ".join(found), reached


def _number(value: float, decimals: int) -> str:
    text = f"{value:.{decimals}f}".rstrip("0")
    return "0." if text in ("-0.", "0.") else text


def _block(program: Program, m: int, line: str, points, commanded) -> tuple[str, np.ndarray]:
    moves = program.moves
    if commanded is None:
        commanded = np.array(moves.begin[m], dtype=float)
    lines = []
    for point in points:
        coordinates, commanded = _coordinates(program, m, point, commanded)
        lines.append(coordinates)
    found, _, _ = words(line, program.source)
    arc = {"I", "J", "K", "R", "P"} if moves.sweep[m] != 0 else set()
    gone, ends = [], []
    for word in found:
        motion = word.letter == "G" and word.value in (0, 1, 2, 3)
        if word.letter in {"X", "Y", "Z"} | arc or motion:
            gone.append(word)
        elif len(points) > 1 and word.letter == "M" and word.value in _AT_END:
            gone.append(word)
            ends.append(word.text)
    first = "G0" if moves.kind[m] == RAPID else "G1"
    ending = "\r" if line.endswith("\r") else ""
    lines[0] = _replaced(line.removesuffix("\r") if ending else line, gone, f"{first} {lines[0]}")
    if ends:
        lines[-1] += " " + " ".join(ends)
    return (ending + "\n").join(lines) + ending, commanded


def _replaced(line: str, gone, new: str) -> str:
    """The line without the words `gone`, and with `new` where the first of them stood."""
    if not gone:
        return line + (" " if line and not line.endswith(" ") else "") + new
    out, at = [], 0
    for i, word in enumerate(gone):
        out.append(line[at : word.begin])
        at = word.end
        if i == 0:
            out.append(new)
        elif not out[-1].strip():  # nothing but blanks between two words that go
            out[-1] = ""
    rest = line[at:]
    joins = out[-1][-1:].isspace() if out[-1] else False
    if rest and not rest[0].isspace() and not joins:
        rest = " " + rest
    return ("".join(out) + (rest.lstrip(" ") if joins else rest)).rstrip(" ")


def _hole(program: Program, rows, line: str, points) -> str:
    """The block of a drilling cycle with its place moved as the bottom of the hole is."""
    moves = program.moves
    feed = rows[moves.kind[rows] != RAPID][0]
    point = points[feed][-1]
    coordinates, _ = _coordinates(program, feed, point, moves.end[feed])
    x, y, _ = coordinates.split(" ")
    found, _, _ = words(line, program.source)
    gone = [w for w in found if w.letter in "XY"]
    return _replaced(line, gone, f"{x} {y}") if gone else line
