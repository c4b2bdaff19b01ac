# SPDX-License-Identifier: LGPL-2.1-or-later
"""Messages are codes with fields: the tables are complete in every language, and the source uses no other code."""

from __future__ import annotations

import ast
import pickle
import re
from pathlib import Path

import pytest

from sensworkbench.messages import LANGUAGES, Message, Refused, tables

PACKAGE = Path(tables.__file__).resolve().parents[1]
CODE = re.compile(r"[a-z0-9]+(-[a-z0-9]+)+")
MAKERS = {"Message", "Refused", "refuse", "refused", "words"}


def codes_in(text: str):
    """(code, line) of every literal code that a source makes a message or a refusal of."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Call) and node.args and isinstance(node.args[0], ast.Constant):
            name = getattr(node.func, "id", getattr(node.func, "attr", ""))
            value = node.args[0].value
            if name in MAKERS and isinstance(value, str) and CODE.fullmatch(value):
                yield value, node.lineno


def both(value) -> tuple[str, str]:
    return (value, "") if isinstance(value, str) else value


def test_a_code_is_found_in_a_source():
    assert list(codes_in("raise Refused('machine-axes-parallel', where, a=1)")) == [("machine-axes-parallel", 1)]
    assert not list(codes_in("raise Refused('axes are parallel', where)"))


def test_every_code_in_the_source_has_a_sentence():
    missing = [
        f"{path.relative_to(PACKAGE)}:{line} {code}"
        for path in sorted(PACKAGE.rglob("*.py"))
        for code, line in codes_in(path.read_text(encoding="utf-8"))
        if not tables.known(code)
    ]
    assert not missing


def sentences_in(text: str):
    """(what, line) of every refusal or message that a source makes of a sentence instead of a code."""
    for node in ast.walk(ast.parse(text)):
        if (
            isinstance(node, ast.Call)
            and node.args
            and getattr(node.func, "id", getattr(node.func, "attr", "")) in MAKERS
        ):
            first = node.args[0]
            parts = first.values if isinstance(first, ast.JoinedStr) else [first]
            if any(isinstance(p, ast.Constant) and isinstance(p.value, str) and " " in p.value for p in parts):
                yield ast.unparse(first), node.lineno


def test_a_sentence_is_found_in_a_source():
    assert len(list(sentences_in("raise Refused(f'{x} is wrong', where)\nraise Refused('it is wrong')"))) == 2
    assert not list(sentences_in("raise Refused('machine-axes-parallel')\nraise Refused(found.code)"))


def test_nothing_is_refused_by_a_sentence():
    found = [
        f"{path.relative_to(PACKAGE)}:{line} {what}"
        for path in sorted(PACKAGE.rglob("*.py"))
        for what, line in sentences_in(path.read_text(encoding="utf-8"))
    ]
    assert not found


@pytest.mark.parametrize("language", [x for x in LANGUAGES if x != "en"])
def test_every_sentence_is_translated_with_the_same_fields(language):
    english, other = tables.table("en"), tables.table(language)
    assert sorted(set(english) - set(other)) == []
    assert sorted(set(other) - set(english)) == []
    for code, text in english.items():
        for a, b in zip(both(text), both(other[code])):
            assert tables.fields_of(a) == tables.fields_of(b), code
            assert bool(a) == bool(b), code


@pytest.mark.parametrize("language", LANGUAGES)
def test_codes_and_places_are_plain_names(language):
    for code, text in tables.table(language).items():
        assert CODE.fullmatch(code), code
        assert all(field.isidentifier() for part in both(text) for field in tables.fields_of(part)), code


def test_a_message_speaks_the_language_asked_for(monkeypatch):
    words = {"en": {"a-b": "{n:.1f} of {what}", "c-d": "c"}, "de": {"a-b": "{n:.1f} von {what}", "c-d": "see"}}
    monkeypatch.setattr(tables, "table", lambda language: words.get(language, {}))
    message = Message("a-b", n=2, what=Message("c-d"))
    assert str(message) == "2.0 of c"
    assert message.text("de") == "2.0 von see"
    assert message.text("ko") == "2.0 of c"
    assert message.to_dict() == {"code": "a-b", "text": "2.0 of c", "n": 2, "what": {"code": "c-d", "text": "c"}}
    assert pickle.loads(pickle.dumps(message)) == message


def test_a_refusal_says_where_what_and_what_to_do(monkeypatch):
    words = {"en": {"x-y": ["{v} is bad", "Give more than {v}."]}, "de": {"x-y": ["{v} ist schlecht", "Mehr als {v}."]}}
    monkeypatch.setattr(tables, "table", lambda language: words.get(language, {}))
    refused = Refused("x-y", "line 3", v=4).at("a.csv")
    assert refused.message == str(refused) == "a.csv: line 3: 4 is bad. Give more than 4."
    assert refused.text("de") == "a.csv: line 3: 4 ist schlecht. Mehr als 4."
    assert (refused.code, refused.where, refused.fields) == ("x-y", "a.csv: line 3", {"v": 4})
    assert pickle.loads(pickle.dumps(refused)).message == refused.message


def test_a_template_cannot_reach_into_a_value():
    with pytest.raises(ValueError):
        tables.fill("{v.__class__}", {"v": 1}, "en")
