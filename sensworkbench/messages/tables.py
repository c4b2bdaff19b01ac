# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sentences: `<language>/<domain>.json`, each a table of code -> template; the words of one named effect,
objective or shape are one file for all languages (`effects/<key>.json` ...): language -> code -> template.

A template is a text with `{field}` places; a refusal's is a pair [what was found, what to do about it], of which the
second may be empty.  A code stands in one domain only.  English is complete; a code that another language lacks is
shown in English (a test fails then).
"""

from __future__ import annotations

import json
import string
from functools import cache
from pathlib import Path

LONGEST = 120  # characters of a text that a sentence repeats
LANGUAGES = ("en", "de", "ko")
NOUNS = ("effects", "objectives", "shapes")  # folders with one file for each, all languages in it
_FOLDER = Path(__file__).parent


@cache
def table(language: str) -> dict[str, str | tuple[str, str]]:
    """code -> template of every file in `language`; raises ValueError where a code is in two files."""
    found: dict[str, str | tuple[str, str]] = {}
    for folder in (language, *NOUNS):
        for path in sorted((_FOLDER / folder).glob("*.json")):
            table = json.loads(path.read_text(encoding="utf-8"))
            for code, value in (table if folder == language else table.get(language, {})).items():
                if code in found:
                    raise ValueError(f"message {code!r} is in two files of {language!r}; the second is {path.name}")
                found[code] = value if isinstance(value, str) else tuple(value)
    return found


def known(code: str) -> bool:
    """Whether `code` has an English template."""
    return code in table("en")


def template(code: str, language: str = "en") -> str | tuple[str, str]:
    """The template of `code` in `language`, else in English; raises KeyError for an unknown code."""
    if language in LANGUAGES and code in table(language):
        return table(language)[code]
    return table("en")[code]


def fields_of(text: str) -> set[str]:
    """Names of the places in a template."""
    return {name for _, name, _, _ in string.Formatter().parse(text) if name is not None}


class Filler(string.Formatter):
    """Fills a template.  Only plain names are places: no attribute and no item of a value can be reached."""

    def __init__(self, language: str):
        self.language = language

    def get_field(self, field_name, args, kwargs):
        if not field_name.isidentifier():
            raise ValueError(f"{field_name!r} is not a plain name")
        return kwargs[field_name], field_name

    def format_field(self, value, format_spec):
        if hasattr(value, "code") and hasattr(value, "text"):  # a message within a message
            value = value.text(self.language)
        elif isinstance(value, str) and len(value) > LONGEST:  # a cell of somebody's file, say
            value = value[: LONGEST - 1] + "…"
        elif isinstance(value, (list, tuple)):
            return ", ".join(self.format_field(v, format_spec) for v in value)
        return super().format_field(value, format_spec)


def fill(text: str, fields, language: str) -> str:
    """`text` with its places filled from `fields`."""
    return Filler(language).vformat(text, (), fields)
