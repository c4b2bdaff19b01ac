# SPDX-License-Identifier: LGPL-2.1-or-later
"""Strict JSON that knows where everything stands, so that a refusal can name the line and the path of its cause.

Against RFC 8259: duplicate keys, NaN, Infinity, numbers out of range, lone surrogates and trailing text are refused,
and so is nesting deeper than `DEPTH`.  `Node` walks through the result and refuses with file, line and path.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Mapping
from json.decoder import scanstring

from sensworkbench.core.refusal import Refused

DEPTH = 40
NUMBER_DIGITS = 400

_SPACE = re.compile(r"[ \t\n\r]*")
_NUMBER = re.compile(r"-?(?:0|[1-9]\d*)(\.\d+)?([eE][-+]?\d+)?")
_WORD = re.compile(r"[A-Za-z_][A-Za-z_0-9]*")
_WORDS = {"true": True, "false": False, "null": None}


class _Parser:
    def __init__(self, text: str, name: str):
        self.text, self.name = text, name
        self.lines: dict[tuple, int] = {}
        self._newlines = [m.start() for m in re.finditer("\n", text)]

    def line(self, at: int) -> int:
        from bisect import bisect_left

        return bisect_left(self._newlines, at) + 1

    def refuse(self, at: int, code: str, path: tuple = (), **fields):
        where = f"{self.name}, line {self.line(at)}"
        if path:
            where += f", {path_text(path)}"
        raise Refused(code, where, **fields)

    def space(self, at: int) -> int:
        return _SPACE.match(self.text, at).end()

    def value(self, at: int, path: tuple):
        """(value, end) of the value at `at`."""
        text = self.text
        if len(path) > DEPTH:
            self.refuse(at, "json-too-deep", path[:3], limit=DEPTH)
        self.lines[path] = self.line(at)
        here = text[at : at + 1]
        if here == "{":
            return self.object(at, path)
        if here == "[":
            return self.array(at, path)
        if here == '"':
            return self.string(at, path)
        match = _NUMBER.match(text, at)
        if match:
            return self.number(match, at, path), match.end()
        word = _WORD.match(text, at + (here == "-"))
        if word and here != "-" and word.group() in _WORDS:
            return _WORDS[word.group()], word.end()
        if word and word.group().lower() in ("nan", "infinity", "inf"):
            self.refuse(at, "json-not-a-number", path, word=f"{here if here == '-' else ''}{word.group()}")
        if here:
            self.refuse(at, "json-not-json", path, text=short(text[at : at + 20]))
        self.refuse(at, "json-ends", path)

    def number(self, match, at: int, path: tuple):
        digits = match.group()
        if len(digits) > NUMBER_DIGITS:
            self.refuse(at, "json-digits", path, count=len(digits))
        value = float(digits)
        if not math.isfinite(value):
            self.refuse(at, "json-range", path, number=digits[:20])
        if match.group(1) or match.group(2):
            return value
        return int(digits) if abs(value) < 2**53 else value

    def string(self, at: int, path: tuple):
        try:
            value, end = scanstring(self.text, at + 1, True)
        except json.JSONDecodeError as error:
            self.refuse(error.pos, "json-text", path, why=error.msg.lower())
        if any("\ud800" <= c <= "\udfff" for c in value):
            self.refuse(at, "json-half-character", path)
        return value, end

    def object(self, at: int, path: tuple):
        result: dict = {}
        at = self.space(at + 1)
        if self.text[at : at + 1] == "}":
            return result, at + 1
        while True:
            if self.text[at : at + 1] != '"':
                self.refuse(at, "json-name-missing", path)
            key, end = self.string(at, path)
            if key in result:
                first = self.lines[(*path, key)]
                self.refuse(at, "json-key-twice", (*path, key), key=short(key), line=first)
            end = self.space(end)
            if self.text[end : end + 1] != ":":
                self.refuse(end, "json-colon", path, key=short(key))
            result[key], end = self.value(self.space(end + 1), (*path, key))
            self.lines[(*path, key)] = self.line(at)
            at, closed = self.next(end, "}", path)
            if closed:
                return result, at

    def array(self, at: int, path: tuple):
        result: list = []
        at = self.space(at + 1)
        if self.text[at : at + 1] == "]":
            return result, at + 1
        while True:
            item, end = self.value(at, (*path, len(result)))
            result.append(item)
            at, closed = self.next(end, "]", path)
            if closed:
                return result, at

    def next(self, at: int, close: str, path: tuple) -> tuple[int, bool]:
        at = self.space(at)
        mark = self.text[at : at + 1]
        if mark == close:
            return at + 1, True
        if mark != ",":
            if mark:
                self.refuse(at, "json-comma", path, close=close)
            self.refuse(at, "json-ends", path)
        return self.space(at + 1), False


def short(value) -> str:
    """A value as it can stand in a message: quoted, and cut where it is long."""
    text = json.dumps(value, ensure_ascii=False) if isinstance(value, (str, int, float, bool, type(None))) else None
    if text is None:
        text = "an object" if isinstance(value, Mapping) else "a list"
    return text if len(text) <= 60 else text[:56] + '…"'


def path_text(path: tuple) -> str:
    """`axes.X.travel[1]` of ("axes", "X", "travel", 1)."""
    out = ""
    for step in path:
        out += (
            f"[{step}]"
            if isinstance(step, int)
            else ("." if out else "") + (step if len(step) <= 40 else step[:39] + "…")
        )
    return out


class Node:
    """A value of a parsed file together with where it stands.  The readers of the formats walk with it."""

    def __init__(self, value, path: tuple, lines: Mapping, name: str):
        self.value, self.path, self._lines, self.name = value, path, lines, name

    @property
    def where(self) -> str:
        """Return where the value is, in words: file, line, path."""
        line = self._lines.get(self.path)
        parts = [self.name] + ([f"line {line}"] if line else []) + ([path_text(self.path)] if self.path else [])
        return ", ".join(parts)

    def refuse(self, code: str, /, **fields) -> Refused:
        """The refusal to raise, `raise place.refuse(code, **fields)`: its place is this one's."""
        return Refused(code, self.where, **fields)

    def __contains__(self, key) -> bool:
        return key in self.value

    def __getitem__(self, key) -> Node:
        return Node(self.value[key], (*self.path, key), self._lines, self.name)

    def keys(self, allowed, required=()) -> list[str]:
        """The keys of an object without "x-" ones; refuses unknown keys (never "x-" ones) and missing ones."""
        if not isinstance(self.value, dict):
            raise self.refuse("json-object-expected", value=short(self.value))
        for key in self.value:
            if key not in allowed and not key.startswith("x-"):
                raise self[key].refuse("json-key-unknown", known=list(allowed))
        for key in required:
            if key not in self.value:
                raise self.refuse("json-key-missing", key=short(key))
        return [k for k in self.value if not k.startswith("x-")]

    def members(self) -> list[tuple[str, Node]]:
        """Name and place of every member of an object whose names are free."""
        if not isinstance(self.value, dict):
            raise self.refuse("json-object-expected", value=short(self.value))
        return [(k, self[k]) for k in self.value]

    def elements(self, count: int | None = None) -> list[Node]:
        """Return the places of the elements of a list; refuses another value or another length."""
        if not isinstance(self.value, list):
            raise self.refuse("json-list-expected", value=short(self.value))
        if count is not None and len(self.value) != count:
            raise self.refuse("json-list-length", count=len(self.value), wanted=count)
        return [self[i] for i in range(len(self.value))]

    def number(self) -> float:
        """Return a number; refuses another value."""
        if isinstance(self.value, bool) or not isinstance(self.value, (int, float)):
            raise self.refuse("json-number-expected", value=short(self.value))
        return float(self.value)

    def numbers(self, count: int | None = None) -> list[float]:
        """Return a list of numbers; refuses other values or another length."""
        return [e.number() for e in self.elements(count)]

    def integer(self, low: int, high: int) -> int:
        """Return a whole number from `low` to `high`; refuses another value."""
        if isinstance(self.value, bool) or not isinstance(self.value, int) or not low <= self.value <= high:
            raise self.refuse("json-integer-expected", value=short(self.value), low=low, high=high)
        return self.value

    def string(self, choices=None) -> str:
        """Return a text, one of `choices` if they are given; refuses another value."""
        if not isinstance(self.value, str):
            raise self.refuse("json-text-expected", value=short(self.value))
        if choices is not None and self.value not in choices:
            raise self.refuse("json-choice", value=short(self.value), known=list(choices))
        return self.value

    def boolean(self) -> bool:
        """Return true or false; refuses another value."""
        if not isinstance(self.value, bool):
            raise self.refuse("json-boolean-expected", value=short(self.value))
        return self.value


def parse(text: str, name: str = "text") -> Node:
    """Parse strictly; the result's `value` is plain Python data.  Refuses with `name`, line and path.

    Python's own parser, which is fast, does the work where it finds nothing; what it stumbles over is read again by the
    one above, which knows where everything stands.
    """
    if not text.strip(" \t\n\r"):
        raise Refused("json-empty", name)
    try:
        deep = _depth(text) > DEPTH
        if not deep and not _half_characters(text):
            return Node(_FAST.decode(text), (), _Lines(text), name)
    except (_NotPlain, ValueError, RecursionError):
        pass
    if deep and len(text) > SLOW_LIMIT:
        raise Refused("json-too-deep", name, limit=DEPTH)
    if len(text) > SLOW_LIMIT:
        _refuse_large(text, name)
    return _parse_slowly(text, name)


def _parse_slowly(text: str, name: str) -> Node:
    parser = _Parser(text, name)
    value, end = parser.value(parser.space(0), ())
    end = parser.space(end)
    if end != len(text):
        parser.refuse(end, "json-trailing")
    return Node(value, (), parser.lines, name)


SLOW_LIMIT = 2**20  # characters that the parser with places is asked for


class _NotPlain(ValueError):
    """Found by the fast parser: a file that the slow one refuses.  text : what to look for."""

    def __init__(self, code: str, text: str, **fields):
        super().__init__(code)
        self.code, self.text, self.fields = code, text, fields


def _checked_int(digits: str):
    if len(digits) > NUMBER_DIGITS:
        raise _NotPlain("json-digits", digits, count=len(digits))
    value = float(digits)
    if not math.isfinite(value):
        raise _NotPlain("json-range", digits, number=digits[:20])
    return int(digits) if abs(value) < 2**53 else value


def _checked_float(digits: str) -> float:
    if len(digits) > NUMBER_DIGITS:
        raise _NotPlain("json-digits", digits, count=len(digits))
    value = float(digits)
    if not math.isfinite(value):
        raise _NotPlain("json-range", digits, number=digits[:20])
    return value


def _no_constant(word: str):
    raise _NotPlain("json-not-a-number", word, word=word)


def _unequal_keys(pairs: list) -> dict:
    found = dict(pairs)
    if len(found) < len(pairs):
        seen: set[str] = set()
        key = next(k for k, _ in pairs if k in seen or seen.add(k))
        raise _NotPlain("json-key-twice", json.dumps(key, ensure_ascii=False), key=short(key), line="?")
    return found


_FAST = json.JSONDecoder(
    object_pairs_hook=_unequal_keys, parse_int=_checked_int, parse_float=_checked_float, parse_constant=_no_constant
)
_BRACKET = re.compile(r'[\[\]{}]|"[^"\\]*(?:\\.[^"\\]*)*"', re.DOTALL)
_PAIR = re.compile(r"\\u[dD][89abAB][0-9a-fA-F]{2}\\u[dD][c-fC-F][0-9a-fA-F]{2}")


def _depth(text: str) -> int:
    """How deep a text nests, as far as `DEPTH` and one more."""
    depth = deepest = 0
    for match in _BRACKET.finditer(text):
        mark = match.group()
        if mark in "[{":
            depth += 1
            if depth > deepest:
                deepest = depth
                if deepest > DEPTH:
                    break
        elif mark in "]}":
            depth -= 1
    return deepest


def _half_characters(text: str) -> bool:
    """Whether half of a pair of escapes may stand alone."""
    return any(half in text and half in _PAIR.sub("", text) for half in ("\\ud", "\\uD"))


def _refuse_large(text: str, name: str) -> None:
    """Refuse a long text that the fast parser did not take, with the line of the cause."""
    try:
        _FAST.decode(text)
    except _NotPlain as found:
        at = text.find(found.text)
        if found.code == "json-key-twice":
            line = text.count("\n", 0, at) + 1
            found.fields["line"] = line
            at = text.find(found.text, at + 1)
        raise Refused(found.code, f"{name}, line {text.count(chr(10), 0, max(at, 0)) + 1}", **found.fields) from None
    except json.JSONDecodeError as error:
        raise Refused("json-syntax", f"{name}, line {error.lineno}", why=error.msg.lower()) from None
    except (ValueError, RecursionError):
        pass
    raise Refused("json-too-large", name, limit=f"{SLOW_LIMIT / 2**20:g}")


class _Lines:
    """The line of a path in a text that the fast parser has read, found when it is asked for."""

    def __init__(self, text: str):
        self._text = text

    def get(self, path: tuple):
        """The line in which the value at `path` begins (of a member of an object, its name), or None."""
        text, at = self._text, _SPACE.match(self._text, 0).end()
        start = at
        try:
            for step in path:
                start, at = _member(text, at, step)
        except (KeyError, IndexError, ValueError):
            return None
        return text.count("\n", 0, start) + 1


def _member(text: str, at: int, step) -> tuple[int, int]:
    """(where member `step` of the object or list at `at` begins, where its value does)."""
    position, count = _SPACE.match(text, at + 1).end(), 0
    while True:
        start = position
        if text[at] == "{":
            key, position = scanstring(text, position + 1, True)
            position = _SPACE.match(text, _SPACE.match(text, position).end() + 1).end()
        else:
            key = count
        if key == step:
            return start, position
        _, position = _FAST.raw_decode(text, position)
        position = _SPACE.match(text, position).end()
        if text[position] != ",":
            raise KeyError(step)
        position, count = _SPACE.match(text, position + 1).end(), count + 1


def dumps(data: Mapping) -> str:
    """The text of a result file; raises ValueError for NaN and infinity, which JSON cannot hold."""
    return json.dumps(data, indent=1, ensure_ascii=False, allow_nan=False) + "\n"
