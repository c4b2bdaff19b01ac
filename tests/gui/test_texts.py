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
    from sensworkbench.closedloop.catalogue import describe
    from sensworkbench.core.driver import Driver
    from sensworkbench.core.shapes import Linear
    from sensworkbench.formats import trace_json
    from sensworkbench.gui.finding_words import all_said, said
    from sensworkbench.messages import Message

    undetermined = Message("null-alike", names=["EAZ (order 1)", "A0Z"], last="EZZ (order 1)")
    data = trace_json.said("name", describe("EAZ", Driver(("temp_column",)), Linear()))
    data |= trace_json.said_all("null_space", [undetermined])
    english = "EAZ (order 1), A0Z and EZZ (order 1) cannot be told apart"
    assert all_said(data, "null_space") == [english] and said(data, "name") == data["name"]
    Gui.setLocale("German")
    try:
        assert all_said(data, "null_space") == ["EAZ (order 1), A0Z und EZZ (order 1) sind nicht zu unterscheiden"]
        assert said(data, "name") != data["name"]
        assert said({"name": "a trace of an earlier version"}, "name") == "a trace of an earlier version"
    finally:
        Gui.setLocale("English")
