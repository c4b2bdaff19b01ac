# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a file of readings may state about itself: the sign questions, and which of its columns is which.

The questions are those that every exchange of machine errors must answer; a file answers them in comments above the
names (`# sign: compensation`), a mapping file does it for tables that cannot be edited.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping

from sensworkbench.core.refusal import Refused

from . import column_names
from .files import read_text

# question -> answers; the first is what is assumed where a file says nothing
ANSWERS = {
    "sign": ("error", "compensation"),
    "frame": ("tool_relative_to_workpiece", "table"),
    "positions": ("programmed", "table"),
    "angles": ("active", "passive"),
    "squareness": ("direction", "carried"),
    "squareness_sign": ("right_handed", "larger_than_90"),
}
NOT_IN_READINGS = {
    "angles": "readings hold displacements only, so nothing is converted",
    "squareness": "readings hold displacements only; the machine's own setting decides",
    "squareness_sign": "readings hold displacements only, so nothing is converted",
}
_ANSWER = re.compile(r"([A-Za-z_][A-Za-z_ ]*?)\s*[:=]\s*(.+)$")


def question(text: str) -> str:
    """The question that a comment answers, "" where it is an ordinary comment."""
    match = _ANSWER.match(text)
    key = match.group(1).strip().lower().replace(" ", "_") if match else ""
    return key if key in ANSWERS else ""


def read_answers(comments, header: Mapping, names_line: int, source: str) -> dict[str, tuple[tuple[str, ...], int]]:
    """question -> ((answer, axes...), line): of a mapping's `header` and of `comments` (line, text)."""
    stated = [(f"{k}: {v}", 0) for k, v in header.items()]
    for text, _ in stated:
        if not question(text):
            raise Refused(f"{text!r} answers no question", "mapping, header", f"Questions are {', '.join(ANSWERS)}.")
    answers: dict[str, tuple[tuple[str, ...], int]] = {}
    for text, line in stated + [(text, line) for line, text in comments]:
        key = question(text)
        if not key:
            continue
        where = f"{source}, line {line}" if line else "mapping, header"
        said = _ANSWER.match(text).group(2)
        word, *axes = said.strip().lower().replace("-", "_").replace(",", " ").split()
        if word not in ANSWERS[key] or (axes and not (key == "positions" and set(axes) <= set("xyz"))):
            raise Refused(f"{said!r} is no answer to {key!r}", where, f"Write {' or '.join(ANSWERS[key])}.")
        if line > names_line:
            raise Refused(f"{key!r} is stated behind the names", where, "Move it above the row of names.")
        if key in answers:
            if answers[key][0] != (word, *axes):
                raise Refused(f"{key!r} is answered twice, differently", where, "Keep one answer.")
            continue
        answers[key] = ((word, *axes), line)
    return answers


def load_mapping(path) -> dict:
    """A mapping file: JSON, {"x_mm": "Pos X [mm]", "z_mm": 0, "ignore": ["Remark"], "header": {"sign": "error"}}."""
    name = str(path)
    try:
        found = json.loads(read_text(path))
    except json.JSONDecodeError as error:
        raise Refused(error.msg, f"{name}, line {error.lineno}, column {error.colno}", "Correct the JSON.") from None
    return check_mapping(found, name)


def check_mapping(mapping, where: str = "mapping") -> dict:
    """`mapping` if it is well formed: our name -> their name or a constant, "ignore" -> names, "header" -> answers."""
    if not isinstance(mapping, Mapping):
        raise Refused("a mapping is an object of names", where, 'Write {"x_mm": "their name", ...}.')
    for key, value in mapping.items():
        if key == "ignore":
            good = isinstance(value, (list, tuple)) and all(isinstance(v, str) for v in value)
        elif key == "header":
            good = isinstance(value, Mapping) and all(isinstance(v, str) for v in value.values())
        else:
            column_names.parse(key, where)
            good = isinstance(value, str) or (isinstance(value, (int, float)) and not isinstance(value, bool))
        if not good:
            raise Refused(f"{value!r} cannot stand for {key!r}", where, "Give a column's name or a number.")
    return dict(mapping)
