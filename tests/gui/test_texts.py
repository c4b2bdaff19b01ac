# SPDX-License-Identifier: LGPL-2.1-or-later
"""German and Korean are complete and are what the window shows; nothing runs on when the window is idle."""

from __future__ import annotations

import re
import runpy
from pathlib import Path

import FreeCADGui as Gui
import pytest

from sensworkbench.gui import files
from sensworkbench.gui.command import REGISTRY
from sensworkbench.gui.qt import QtCore, pump, translate

ROOT = Path(files.ROOT)
TOOL = runpy.run_path(str(ROOT / "resources" / "translations" / "update.py"))


@pytest.mark.parametrize("language", ["de", "ko"])
def test_every_text_is_translated_and_keeps_its_fields(language):
    table = TOOL["read"](ROOT / "resources" / "translations" / f"SensWorkbench_{language}.ts")
    for context, text, _ in TOOL["texts"]():
        assert table.get((context, text)), text
        fields = re.findall(r"\{\w*\}", text)
        assert sorted(re.findall(r"\{\w*\}", table[context, text])) == sorted(fields), text


def test_the_compiled_files_are_up_to_date():
    assert TOOL["main"](["--check"]) == 0


@pytest.mark.parametrize("language, word", [("de", "Sensitivität"), ("ko", "민감도")])
def test_qt_reads_the_compiled_files(language, word):
    translator = QtCore.QTranslator()
    assert translator.load(str(ROOT / "resources" / "translations" / f"SensWorkbench_{language}.qm"))
    assert translator.translate("Sens_Sensitivity", "Sensitivity") == word
    for context, text, _ in TOOL["texts"]():
        assert translator.translate(context, text), text


def test_the_commands_follow_the_language_of_the_window(workbench):
    Gui.setLocale("German")
    try:
        assert translate("Sens_Sensitivity", "Sensitivity") == "Sensitivität"
        assert REGISTRY["Sens_Sensitivity"].GetResources()["MenuText"] == "Sensitivität"
    finally:
        Gui.setLocale("English")
    assert translate("Sens_Sensitivity", "Sensitivity") == "Sensitivity"


def test_an_idle_window_does_nothing(machine, monkeypatch):
    from sensworkbench.gui import adopt, display

    pump(200)
    calls = []
    monkeypatch.setattr(display, "update", lambda result: calls.append("update"))
    monkeypatch.setattr(adopt, "adopt", lambda doc: calls.append("adopt"))
    pump(300)
    assert calls == []


def test_what_the_trace_says_is_known_in_the_language_of_the_window(workbench):
    from sensworkbench.closedloop.catalogue import CATALOGUE, describe
    from sensworkbench.gui import finding_words

    for entry in CATALOGUE.values():
        assert entry.name in finding_words.SAID and entry.check in finding_words.SAID
    sentence = "EAZ (order 1), A0Z and EZZ (order 1) cannot be told apart"
    found = {"name": describe("EAZ", "temp_column", "linear"), "component": "EAZ", "driver": "temp_column"}
    assert finding_words.said(sentence) == sentence and finding_words.effect_name(found) == found["name"]
    Gui.setLocale("German")
    try:
        assert finding_words.said(sentence) == "EAZ (order 1), A0Z and EZZ (order 1) sind nicht zu unterscheiden"
        assert finding_words.said("nothing beyond noise; short waves along the axes (roughness), not named") == (
            "nichts über das Rauschen hinaus; kurze Wellen entlang der Achsen (Rauheit), nicht benannt"
        )
        title = finding_words.effect_name(found)
        assert title == "thermische Biegung der Struktur: Kippen von Z um X, getrieben von temp_column"
        assert finding_words.said("a sentence that nobody knows") == "a sentence that nobody knows"
    finally:
        Gui.setLocale("English")
