# SPDX-License-Identifier: LGPL-2.1-or-later
"""The catalogue of physical effects: each entry names what it is meant for, has its words, and has its precedence."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from sensworkbench.closedloop.catalogue import CATALOGUE, NEEDED, describe, not_testable, physical
from sensworkbench.core.driver import Driver
from sensworkbench.core.shapes import Smooth, shape_class
from sensworkbench.messages import LANGUAGES, tables

FILES = Path(tables.__file__).parent / "effects"
MEANT = {p.stem: json.loads(p.read_text(encoding="utf-8"))["meant"] for p in FILES.glob("*.json")}
NAMELESS = [
    ("EXX", "t*x", "linear", {}),
    ("EXX", "t", "power", {"exponent": 2.0}),
    ("EXX", "gap", "linear", {}),
    ("EXX", "x", "step", {"at": 3.0}),
    ("EXX", "load_table*temp_a", "linear", {}),
    ("EXX", "temp_a", "smooth", {"bumps": (4,), "domains": ((0.0, 1.0),)}),
]


def found(symbol, driver, shape, parameters):
    return physical(symbol, Driver.parse(driver), shape_class(shape)(**parameters))


@pytest.mark.parametrize("key", CATALOGUE)
def test_an_entry_names_what_it_is_meant_for(key):
    assert MEANT[key]
    for example in MEANT[key]:
        assert found(*example) is CATALOGUE[key], example


@pytest.mark.parametrize("example", NAMELESS)
def test_what_is_no_known_effect_has_no_name(example):
    assert found(*example) is None


@pytest.mark.parametrize("key", CATALOGUE)
def test_an_entry_has_its_words_in_every_language(key):
    entry = CATALOGUE[key]
    for message in (entry.name, entry.size, entry.check):
        texts = [message.text(language) for language in LANGUAGES]
        assert all(texts)
    assert len({entry.name.text(language) for language in LANGUAGES}) == len(LANGUAGES)
    assert set(entry.needs) <= set(NEEDED)


def test_an_entry_gives_way_to_those_before_it():
    """A carriage bent by another axis also matches what only one of the two places makes of it."""
    order = list(CATALOGUE)
    both = [e.key for e in CATALOGUE.values() if e.matches(*_parts("EAY", "x*z", "linear"))]
    assert both == ["overhang", "cross"] and order.index("overhang") < order.index("cross")
    assert found("EAY", "x*z", "linear", {}).key == "overhang"


def _parts(symbol, driver, shape):
    from sensworkbench.core.errors import component

    return component(symbol), Driver.parse(driver), shape_class(shape)()


def test_a_finding_is_described_in_three_languages():
    words = describe("EAZ", Driver.parse("temp_column"), shape_class("linear")())
    assert str(words) == "thermal bending of the structure: Z carriage, rotation about X, driven by temp_column"
    assert words.text("de").startswith("thermische Biegung der Struktur: ") and words.text("ko") != str(words)
    period = describe("EXX", Driver.parse("x"), shape_class("periodic")(period=5.0))
    assert str(period).endswith("driven by x (periodic)") and period.text("de").endswith("(periodisch)")
    form = Smooth(bumps=(4, 4), domains=((0, 1), (0, 1)))
    assert (
        str(describe("EYT", Driver.parse("x*t"), form)) == "spindle and tool, shift along Y, driven by t x x (smooth)"
    )


def test_entries_without_their_columns_cannot_be_tested():
    lacking = dict(not_testable(["x", "temp_a", "t"]))
    assert str(CATALOGUE["reversal"].name) in {str(name) for name in lacking}
    assert {needs for name, needs in not_testable(["x", "t", "spindle"]) if str(name) == "thermal displacement"} == {
        "temp_<name>_C"
    }
    assert "drift in time" not in {str(name) for name in lacking}
