# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where scales, guide blocks and tool want to go, as arrows in the view: the longer, the more a move changes.

Everything is drawn where the parts stand now; moves are in the axes of the document with all joints at 0.
"""

from __future__ import annotations

import itertools

import FreeCAD as App

from ..core.refusal import Refused
from ..document import refresh, tree
from ..studies.moves import SPINDLE, TOOL, WORKPIECE
from .arrows import OFFSET_COLOUR, TOOL_COLOUR, Arrow
from .pointers import BODY_COLOURS, OTHER_COLOUR
from .qt import translate
from .texts import body_name, fixed

BODIES = {TOOL: "T", SPINDLE: "T", WORKPIECE: "W"}
BEST_COLOUR = (0.10, 0.55, 0.30)
LONGEST = 0.22  # of the extent of the machine
LEAST = 0.02  # of the largest derivative: a smaller one is shown as a point


def point_name(machine, name: str) -> str:
    """What a point of a study of moves is called."""
    known = {
        TOOL: translate("Sens", "Tool point"),
        SPINDLE: translate("Sens", "Spindle reference"),
        WORKPIECE: translate("Sens", "Workpiece reference"),
    }
    return known.get(name) or body_name(machine, name)


def places(machine) -> dict:
    """name of a point -> (its place now, how its body is displaced); empty where the machine cannot be computed."""
    try:
        displaced = refresh.latest(machine).displacements
    except Refused:
        return {}
    found = {}
    for name in (*tree.joint_names(tree.bodies(machine)), TOOL, SPINDLE, WORKPIECE):
        body = BODIES.get(name, name)
        obj = tree.body_of(machine, body)
        if name != TOOL and obj is None:
            continue
        home = machine.FunctionalPoint if name == TOOL else obj.ReferencePoint
        found[name] = (displaced[body].multVec(home), displaced[body])
    return found


def slopes(point: dict) -> App.Vector:
    """Change of the mean square per mm along x, y and z, per cent."""
    return App.Vector(*[point["per_mm"][a]["percent"] for a in "xyz"])


def gradient_arrows(machine, points, size: float, only: str = "", along: str = "") -> list[Arrow]:
    """An arrow at every point in the direction in which a move lowers the mean square fastest.

    points : of moves.json.  size : extent of the machine, mm.  only : name of the one point to show; along : "x", "y"
    or "z", the one direction.
    """
    where, arrows = places(machine), []
    largest = max((slopes(p).Length for p in points), default=0.0)
    for point in points:
        name = point["name"]
        if name not in where or (only and name != only) or largest <= 0:
            continue
        way = slopes(point) * -1.0
        if along:
            way = App.Vector(*[v if a == along else 0.0 for a, v in zip("xyz", way)])
        at, displaced = where[name]
        colour = TOOL_COLOUR if name == TOOL else BODY_COLOURS.get(BODIES.get(name, name), OTHER_COLOUR)
        words = f"{point_name(machine, name)}: −{fixed(way.Length, 3)} %/mm"
        if way.Length < LEAST * largest:
            if only:
                words = f"{point_name(machine, name)}: 0 %/mm"
                arrows.append(Arrow(tuple(at), tuple(at), colour, words, below=True))
            continue
        turned = displaced.Rotation.multVec(way)
        end = at + turned * (LONGEST * size / largest)
        arrows.append(Arrow(tuple(at), tuple(end), colour, words, 0.0, below=True))
    return arrows


def move_arrows(machine, moves, length) -> list[Arrow]:
    """An arrow from every point to its best place.  moves : name -> (3,) mm.  length : mm -> its text."""
    where, arrows = places(machine), []
    for name, move in moves.items():
        move = App.Vector(*move)
        if name in where and move.Length > 1e-9:
            at, displaced = where[name]
            words = translate("Sens", "{name}: best place, {length} away")
            words = words.format(name=point_name(machine, name), length=length(move.Length))
            end = at + displaced.Rotation.multVec(move)
            arrows.append(Arrow(tuple(at), tuple(end), BEST_COLOUR if len(moves) == 1 else OFFSET_COLOUR, words, 1.0))
    return arrows


def box_lines(machine, names, sides) -> list:
    """The edges of the box within which each of some points may move.  sides : half sides, mm."""
    where, lines = places(machine), []
    for name in names:
        if name not in where:
            continue
        at, displaced = where[name]
        corners = {
            signs: tuple(at + displaced.Rotation.multVec(App.Vector(*[s * v for s, v in zip(signs, sides)])))
            for signs in itertools.product((-1, 1), repeat=3)
        }
        for one, other in itertools.combinations(corners, 2):
            if sum(a != b for a, b in zip(one, other)) == 1:
                lines.append([corners[one], corners[other]])
    return lines
