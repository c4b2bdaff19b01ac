# SPDX-License-Identifier: LGPL-2.1-or-later
"""features.json: which blocks of a program make which feature, and what a program does not say (offsets, tools).

In a program a comment `(feature: NAME, KIND)` begins a feature as well, and `(feature: end)` or the next one ends it.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from sensworkbench.core.features import KINDS
from sensworkbench.core.refusal import Refused
from sensworkbench.core.toolpath import RAPID
from sensworkbench.core.units import mm
from sensworkbench.studies.part import FeatureRequest

from . import json_text
from .files import read_text
from .gcode import Program, Settings, Tool

FORMAT, VERSION = "sens-features", 1
SYSTEMS = ("G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3")
LARGEST_MM = 1e7
MOST_LINE = 10**9
MOST_FEATURES = 1000
_MARK = re.compile(r"feature\s*:\s*([^,]*?)\s*(?:,\s*(\w+)\s*)?$", re.IGNORECASE)


@dataclass(frozen=True)
class FeatureFile:
    """features : what is judged.  ranges : label -> ("line" or "block", first, last) of the points of each.  settings :
    offsets (mm, deg as written; see `settings_for`) and tools."""

    features: tuple[FeatureRequest, ...] = ()
    ranges: Mapping[str, tuple[tuple[str, int, int], ...]] = field(default_factory=dict)
    offsets: Mapping[str, tuple[float, ...]] = field(default_factory=dict)
    tools: Mapping[int, Tool] = field(default_factory=dict)


def load(path, joints) -> FeatureFile:
    """The features of a file; joints : of the machine, whose offsets it may hold."""
    return loads(read_text(path), str(path), joints)


def loads(text: str, name: str, joints) -> FeatureFile:
    """The features in a text; see `load`."""
    top = json_text.parse(text, name)
    top.keys(("format", "version", "work_offsets", "tools", "features"), ("format", "version"))
    top["format"].string([FORMAT])
    top["version"].integer(1, VERSION)
    offsets, tools = {}, {}
    if "work_offsets" in top:
        place = top["work_offsets"]
        place.keys(SYSTEMS)
        for system, values in place.members():
            if not system.startswith("x-"):
                numbers = values.numbers(len(joints))
                if not all(abs(v) <= LARGEST_MM for v in numbers):
                    raise values.refuse("number-too-large", value=str(max(numbers, key=abs)), column=system,
                                        limit=LARGEST_MM, unit="mm")  # fmt: skip
                offsets[system] = tuple(float(j.from_shown(v)) for j, v in zip(joints, numbers))
    if "tools" in top:
        for number, place in top["tools"].members():
            if not (number.isascii() and number.isdigit() and len(number) < 7):
                raise place.refuse("features-tool-number", number=json_text.short(number))
            tools[int(number)] = _tool(place)
    features, ranges = [], {}
    if "features" in top:
        for place in top["features"].elements():
            _feature(place, features, ranges)
    return FeatureFile(tuple(features), ranges, offsets, tools)


def _tool(place) -> Tool:
    place.keys(("length_mm", "radius_mm", "end"))
    sizes = {}
    for key in ("length_mm", "radius_mm"):
        if key in place:
            value = place[key].number()
            if not abs(value) < 1e4 or (key == "radius_mm" and value < 0):
                raise place[key].refuse("features-tool-size", key=key, value=value)
            sizes[key.removesuffix("_mm")] = value
    ball = "end" in place and place["end"].string(["flat", "ball"]) == "ball"
    return Tool(ball=ball, **sizes)


def _feature(place, features: list, ranges: dict) -> None:
    place.keys(("name", "kind", "of", "lines", "blocks", "datum", "limit_um"), ("name",))
    name = place["name"].string()
    if not name.strip() or any(f.name == name for f in features) or len(features) >= MOST_FEATURES:
        raise place["name"].refuse("features-name", name=json_text.short(name))
    texts = {key: place[key].string() for key in ("datum", "of") if key in place}
    kind = place["kind"].string(list(KINDS)) if "kind" in place else None
    limit = None
    if "limit_um" in place:
        limit = place["limit_um"].number()
        if not 0 < limit < 1e9:
            raise place["limit_um"].refuse("feature-limit", limit=limit)
        limit = mm(limit)
    found = []
    for key, what in (("lines", "line"), ("blocks", "block")):
        if key in place:
            parts = place[key].elements()
            pairs = [place[key]] if parts and not isinstance(parts[0].value, list) else parts
            for pair in pairs:
                first, last = (e.integer(0, MOST_LINE) for e in pair.elements(2))
                found.append((what, first, last))
    if found:
        ranges[name] = tuple(found)
    features.append(FeatureRequest(name, kind, texts.get("datum"), limit, texts.get("of")))


def settings_for(file: FeatureFile, offsets: Mapping[str, tuple[float, ...]], tools: Mapping[int, Tool]) -> Settings:
    """What a program needs, of a file and of the command line, which comes before."""
    return Settings(dict(file.offsets) | dict(offsets), dict(file.tools) | dict(tools))


def of_program(program: Program, file: FeatureFile) -> tuple[tuple[FeatureRequest, ...], dict[str, np.ndarray]]:
    """(features, label -> rows of the moves) of the file and of the comments of a program."""
    marked, kinds = _marked(program)
    moves = program.moves
    rows = dict(marked)
    for name, parts in file.ranges.items():
        chosen = np.zeros(len(moves), dtype=bool)
        for what, first, last in parts:
            numbers = moves.block if what == "line" else program.number
            chosen |= (numbers >= first) & (numbers <= last)
        rows[name] = np.flatnonzero(chosen & (moves.kind != RAPID))
    features = list(file.features)
    named = {f.points for f in features} | {f.name for f in features}
    features += [FeatureRequest(name, kinds[name]) for name in marked if name not in named]
    return tuple(features), rows


def _marked(program: Program) -> tuple[dict[str, np.ndarray], dict[str, str | None]]:
    """(name -> rows of moves, name -> kind) by the comments of the program."""
    marks = []
    for line, text in program.comments:
        match = _MARK.match(text)
        if match and match.group(1):
            marks.append((line, *match.groups()))
    rows: dict[str, list] = {}
    kinds: dict[str, str | None] = {}
    for (line, name, kind), following in zip(marks, [*(m[0] for m in marks[1:]), math.inf]):
        if name.lower() == "end":
            continue
        if kind is not None and kind.lower() not in KINDS:
            where = f"{program.source}, line {line}"
            raise Refused("feature-kind-unknown", where, kind=repr(kind)[:60], known=list(KINDS))
        kinds.setdefault(name, None if kind is None else kind.lower())
        begin, end = np.searchsorted(program.moves.block, [line, min(following, MOST_LINE)], side="left")
        rows.setdefault(name, []).extend(range(int(begin), int(end)))
        if len(rows) > MOST_FEATURES:
            raise Refused("features-name", f"{program.source}, line {line}", name=json_text.short(name))
    cuts = program.moves.kind != RAPID
    return {name: np.array([r for r in found if cuts[r]], dtype=int) for name, found in rows.items()}, kinds


def of_points(file: FeatureFile, labels: dict, features: tuple, lines) -> tuple[tuple[FeatureRequest, ...], dict]:
    """(features, label -> rows) of the file and of the columns of a table of points.  lines : (P,) of its rows."""
    labels = dict(labels)
    for name, parts in file.ranges.items():
        chosen = np.zeros(len(lines), dtype=bool)
        for _, first, last in parts:
            chosen |= (lines >= first) & (lines <= last)
        labels[name] = np.flatnonzero(chosen)
    named = {f.points for f in file.features} | {f.name for f in file.features}
    return (*file.features, *(f for f in features if f.name not in named)), labels
