# SPDX-License-Identifier: LGPL-2.1-or-later
"""Guess the body of a part from its name, in English, German and Korean.  Only ever a proposal."""

from __future__ import annotations

import re

# tried in this order: an axis letter says more than the kind of part
_LETTER = re.compile(
    r"(?:^|[^a-z])(?P<axis>[xyz])(?:[^a-z]|$|axis|achse|carriage|slide|schlitten|saddle|table|tisch|축)", re.I
)
_WORDS = (
    ("W", r"workpiece|work ?piece|werkst|vice|vise|fixture|spannvorr|\bblank\b|\bstock\b|공작물|고정구"),
    ("Z", r"headstock|spindle ?head|spindelkasten|quill|pinole|\bram\b|주축두"),
    ("T", r"spindle|spindel|\btool\b|werkzeug|cutter|fraeser|fräser|주축|공구"),
    ("F", r"\bbed\b|base|frame|column|bett|ständer|staender|gestell|베드|컬럼|foundation"),
    ("Y", r"saddle|cross ?slide|kreuzschlitten|새들"),
    ("X", r"table|tisch|gantry|bridge|portal|테이블"),
)
# named after the axis that they serve, not after the one that they ride on
_SERVES = re.compile(
    r"\bways?\b|rail|\bguides?\b|guideway|f(ü|ue)hrung|schiene|screw|gewinde|motor|scale|encoder|ma(ß|ss)stab|레일|나사|모터",
    re.I,
)
WORKPIECE_SIDE = re.compile(r"table|tisch|saddle|cross ?slide|kreuzschlitten|workpiece|pallet|테이블|새들", re.I)
TOOL_POINT = re.compile(r"tool.?(point|tip|centre|center)|\btcp\b|\btip\b|werkzeugspitze|공구", re.I)


def guess(label: str) -> str:
    """Return the body that a part of this name belongs to: F, X, Y, Z, T, W, or "" if the name does not show it.

    Rails, screws, motors and scales are often called by the letter of their axis but may belong to either side of it:
    "".
    """
    text = label.replace("_", " ").strip()
    text = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", text)  # CarriageX -> Carriage X
    text = re.sub(r"\d+$", "", text)
    if _SERVES.search(text):
        return ""
    words = [body for body, pattern in _WORDS[:1] if re.search(pattern, text, re.I)]
    if words:
        return words[0]
    match = _LETTER.search(text)
    if match:
        return match["axis"].upper()
    return next((body for body, pattern in _WORDS if re.search(pattern, text, re.I)), "")


def axis_letter(label: str) -> str:
    """X, Y or Z where the name states an axis by its letter, else ""."""
    match = _LETTER.search(re.sub(r"(?<=[a-z])(?=[A-Z])", " ", label.replace("_", " ")))
    return match["axis"].upper() if match else ""
