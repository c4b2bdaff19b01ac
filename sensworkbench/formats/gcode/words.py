# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words of a block of G-code: letters with numbers; comments apart.

The text of a file is read as Latin-1, one character for each byte, so that places in it are places in the file.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

from sensworkbench.core.refusal import Refused

from ..json_text import short

LONGEST_LINE = 4096
_TOKEN = re.compile(
    r"[ \t\r\f\v]*(?:([A-Za-z])[ \t]*([-+]?[ \t]*(?:\d+\.?\d*|\.\d+))|\(([^()]*)\)|;(.*)|(%)|(/\d?)|(\S))",
)
_EXPRESSION = frozenset("#[]=<>*")
LARGEST = 1e7


@dataclass(frozen=True)
class Word:
    """letter (upper case) and value; begin, end : its place in the line."""

    letter: str
    value: float
    begin: int
    end: int
    text: str


def words(line: str, where: str) -> tuple[list[Word], list[str], str]:
    """(words, marks that are no words, comment) of a line.

    Refuses expressions and parameters, whose values only a controller knows, and characters that begin nothing.
    """
    if len(line) > LONGEST_LINE:
        raise Refused("gcode-line-too-long", where, limit=LONGEST_LINE)
    found, marks, remarks = [], [], []
    at = 0
    for match in _tokens(line):
        at = match.end()
        letter, number, comment, rest, percent, skip, other = match.groups()
        if letter:
            value = float(number.replace(" ", "").replace("\t", ""))
            if abs(value) > LARGEST:
                raise Refused("gcode-number-too-large", where, word=short(match.group().strip()), limit=LARGEST)
            begin = match.start(1)
            found.append(Word(letter.upper(), value, begin, at, f"{letter.upper()}{number}"))
        elif comment is not None or rest is not None:
            remarks.append((comment if comment is not None else rest).strip())
        elif skip:
            marks.append(skip)
        elif other:
            if other in _EXPRESSION or (other.isalpha() and _EXPRESSION & set(line[at : at + 2])):
                raise Refused("gcode-expression", where, text=short(line[match.start() :].strip()[:40]))
            if other.upper() == "O" or other == "(" or not other.isalpha():
                raise Refused("gcode-character", where, text=short(line[match.start() :].strip()[:40]))
            raise Refused("gcode-word-without-number", where, word=other.upper())
    return found, marks, " ".join(remarks)


def _tokens(line: str) -> Iterator[re.Match]:
    at = 0
    while (match := _TOKEN.match(line, at)) is not None:
        yield match
        at = match.end()
