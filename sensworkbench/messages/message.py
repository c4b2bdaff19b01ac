# SPDX-License-Identifier: LGPL-2.1-or-later
"""`Message`, a code with values, and `Refused`, the one exception for input that cannot be accepted.

Everything that reads or checks user data raises `Refused`: what, where, and what to do.  The command line turns it into
exit status 2 and one message; a task panel shows the same message.  Any other exception is a defect of the program.
"""

from __future__ import annotations

from collections.abc import Mapping

from . import tables


class Message:
    """A code and its values; equal where both are equal.

    code : key of the tables.  fields : values by name: numbers, texts, messages, or lists of these.
    """

    __slots__ = ("code", "fields")

    def __init__(self, code: str, **fields):
        object.__setattr__(self, "code", code)
        object.__setattr__(self, "fields", fields)

    def __setattr__(self, name, value):
        raise AttributeError("a message does not change")

    def text(self, language: str = "en") -> str:
        """The sentence in `language` (English where that lacks it)."""
        found = tables.template(self.code, language)
        parts = (found,) if isinstance(found, str) else found
        return " ".join(tables.fill(p, self.fields, language) for p in parts if p)

    def to_dict(self) -> dict:
        """Plain data for a JSON file: code, English text and the fields."""
        return {"code": self.code, "text": self.text()} | {k: _plain(v) for k, v in self.fields.items()}

    @classmethod
    def from_dict(cls, data: Mapping) -> Message:
        """The message of its plain data, messages within it too.  Raises KeyError where there is no code."""
        return cls(data["code"], **{k: _read(v) for k, v in data.items() if k not in ("code", "text")})

    def __str__(self) -> str:
        return self.text()

    def __repr__(self) -> str:
        return f"Message({self.code!r}, {', '.join(f'{k}={v!r}' for k, v in self.fields.items())})"

    def __eq__(self, other) -> bool:
        return isinstance(other, Message) and (self.code, self.fields) == (other.code, other.fields)

    def __hash__(self) -> int:
        return hash((self.code, repr(sorted(self.fields.items(), key=lambda item: item[0]))))

    def __reduce__(self):
        return _restored, (self.code, self.fields)


def _restored(code: str, fields: Mapping) -> Message:
    return Message(code, **fields)


def _read(value):
    if isinstance(value, Mapping) and "code" in value and "text" in value:
        return Message.from_dict(value)
    return [_read(v) for v in value] if isinstance(value, list) else value


def _plain(value):
    if isinstance(value, Message):
        return value.to_dict()
    if isinstance(value, (list, tuple, set, frozenset)):
        return [_plain(v) for v in value]
    if isinstance(value, Mapping):
        return {str(k): _plain(v) for k, v in value.items()}
    if hasattr(value, "tolist"):  # a number or an array of numpy
        return value.tolist()
    return value


class Refused(ValueError):
    """Input was refused.

    code : key of the tables, whose template is a pair (what was found, what to do).  where : file, line, column, or
    object and property ("" where unknown).  fields : the values of the template.
    """

    def __init__(self, code: str, where: str = "", /, **fields):
        self.code, self.where, self.fields = code, where, fields
        super().__init__(self.message)

    def _parts(self, language: str) -> tuple[str, str]:
        found = tables.template(self.code, language)
        what, do = (found, "") if isinstance(found, str) else found
        return tables.fill(what, self.fields, language), tables.fill(do, self.fields, language)

    @property
    def what(self) -> str:
        """The finding, one sentence, in English."""
        return self._parts("en")[0]

    @property
    def do(self) -> str:
        """What the user can do about it, in English ("" where `what` says it already)."""
        return self._parts("en")[1]

    @property
    def message(self) -> str:
        """Where, what and what to do, in English."""
        return self.text()

    def text(self, language: str = "en") -> str:
        """Where, what and what to do, in `language`."""
        what, do = self._parts(language)
        text = f"{self.where}: {what}" if self.where else what
        text = text.rstrip()
        if not text.endswith((".", "!", "?")):
            text += "."
        return f"{text} {do}".rstrip()

    def at(self, where: str) -> Refused:
        """The same refusal with an outer place put before its own (a file's path, say)."""
        inner = f"{where}: {self.where}" if self.where else where
        return Refused(self.code, inner, **self.fields)

    def __reduce__(self):
        return _raised, (self.code, self.where, self.fields)


def _raised(code, where, fields) -> Refused:
    return Refused(code, where, **fields)
