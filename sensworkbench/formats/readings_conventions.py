# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a file of readings may state about itself: the sign questions, and which of its columns is which.

The questions are those that every exchange of machine errors must answer; a file answers them in comments above the
names (`# sign: compensation`), a mapping file does it for tables that cannot be edited.
"""

from __future__ import annotations

from collections.abc import Mapping

from sensworkbench.core.refusal import Refused

from . import column_names, json_text, readings_records
from .files import read_text
from .json_text import short

# question -> answers; the first is what is assumed where a file says nothing
ANSWERS = {
    "sign": ("error", "compensation"),
    "frame": ("tool_relative_to_workpiece", "table"),
    "positions": ("programmed", "table"),
    "angles": ("active", "passive"),
    "squareness": ("direction", "carried"),
    "squareness_sign": ("right_handed", "larger_than_90"),
    "alignment": ("not_stated", "once", "offset_per_run", "per_run"),  # of the set-up: see SPEC of readings
}
NOT_IN_READINGS = {
    "angles": "convention-nothing-converted",
    "squareness": "convention-machine-decides",
    "squareness_sign": "convention-nothing-converted",
}
LONGEST = max(len(key) for key in ANSWERS)


def _statement(text: str) -> tuple[str, str]:
    """(question, answer) of a comment, cut at its first colon or equals sign; ("", "") where it answers none."""
    cut = min((at for at in (text.find(":"), text.find("=")) if at >= 0), default=-1)
    name, said = text[: max(cut, 0)].strip(), text[cut + 1 :].strip()
    key = name.lower().replace(" ", "_") if len(name) <= LONGEST else ""
    return (key, said) if key in ANSWERS and said else ("", "")


def question(text: str) -> str:
    """The question that a comment answers, "" where it is an ordinary comment."""
    return _statement(text)[0]


def read_answers(comments, header: Mapping, names_line: int, source: str) -> dict[str, tuple[tuple[str, ...], int]]:
    """question -> ((answer, axes...), line): of a mapping's `header` and of `comments` (line, text)."""
    stated = [(f"{k}: {v}", 0) for k, v in header.items()]
    for text, _ in stated:
        if not question(text) and not readings_records.statement(text)[0]:
            known = [*ANSWERS, *readings_records.KEYS]
            raise Refused(
                "statement-unknown",
                "mapping, header",
                text=short(text),
                known=[*known[:12], *(["…"] if len(known) > 12 else [])],
            )
    answers: dict[str, tuple[tuple[str, ...], int]] = {}
    for text, line in stated + [(text, line) for line, text in comments]:
        key, said = _statement(text)
        if not key:
            continue
        where = f"{source}, line {line}" if line else "mapping, header"
        word, *axes = said.lower().replace("-", "_").replace(",", " ").split() or [""]
        if key == "alignment":
            word, axes = "_".join([word, *axes]), []
        if word not in ANSWERS[key] or (axes and not (key == "positions" and set(axes) <= set("xyz"))):
            raise Refused("statement-answer", where, text=short(said), key=key, known=list(ANSWERS[key]))
        if line > names_line:
            raise Refused("statement-behind-names", where, key=key)
        if key in answers:
            if answers[key][0] != (word, *axes):
                raise Refused("statement-twice", where, key=key)
            continue
        answers[key] = ((word, *axes), line)
    return answers


def load_mapping(path) -> dict:
    """A mapping file: JSON, {"x_mm": "Pos X [mm]", "z_mm": 0, "ignore": ["Remark"], "header": {"sign": "error"}}."""
    place = json_text.parse(read_text(path), str(path))
    return check_mapping(place.value, str(path))


def check_mapping(mapping, where: str = "mapping") -> dict:
    """`mapping` if it is well formed: our name -> their name or a constant, "ignore" -> names, "header" -> answers."""
    if not isinstance(mapping, Mapping):
        raise Refused("mapping-not-an-object", where)
    for key, value in mapping.items():
        if key == "ignore":
            if not isinstance(value, (list, tuple)) or not all(isinstance(v, str) for v in value):
                raise Refused("mapping-ignore", where)
        elif key == "header":
            if not isinstance(value, Mapping) or not all(isinstance(v, str) for v in value.values()):
                raise Refused("mapping-header", where)
        else:
            column_names.parse(key, where)
            number = isinstance(value, (int, float)) and not isinstance(value, bool)
            if not isinstance(value, str) and not (number and abs(value) <= column_names.LARGEST):
                raise Refused("mapping-value", where, value=short(value), key=short(key), limit=column_names.LARGEST)
    return dict(mapping)
