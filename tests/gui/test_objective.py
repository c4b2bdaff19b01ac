# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is judged, and stored sentences: any registered objective is offered with its fields, and stays in the file."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import ClassVar

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import pytest

from sensworkbench.core import objectives, workspace
from sensworkbench.document import extract, results, told, tree
from sensworkbench.gui import messages as window
from sensworkbench.gui import objective_form, review
from sensworkbench.gui.qt import pump

from .conftest import run, screenshot


@dataclass(frozen=True)
class Penalty(objectives.MeanSquare):
    """The mean square with every component's weight raised to a power: a stand-in for an objective of somebody else."""

    exponent: float = 1.0
    strict: bool = False

    name: ClassVar[str] = "test_penalty"

    def indices(self, omega, law):
        return objectives.sobol.indices(omega, law, [w**self.exponent for w in self.weights])

    def group_indices(self, omega, law, groups):
        return objectives.sobol.group_indices(omega, law, groups, [w**self.exponent for w in self.weights])


@pytest.fixture
def registered():
    objectives.register(Penalty)
    yield Penalty
    del objectives.OBJECTIVES[Penalty.name]


@pytest.fixture
def settings_page(registered, machine):
    """The settings of the review, made while the objective is registered."""
    dock = review.existing()
    if dock is not None:
        dock.setParent(None)
        dock.deleteLater()
        pump(30)
    run("Sens_Sensitivity")
    yield review.dock().settings
    run("Sens_Review")
    found = review.existing()
    found.close()
    found.setParent(None)
    found.deleteLater()
    pump(30)


def test_a_registered_objective_is_offered_with_its_fields_and_computed(settings_page, machine, machine_doc, tmp_path):
    form = settings_page.objective
    names = [form.name.itemData(i) for i in range(form.name.count())]
    assert names == list(objectives.OBJECTIVES) and "test_penalty" in names
    form.name.setCurrentIndex(names.index("test_penalty"))
    assert list(form.own) == ["exponent", "strict"]
    form.weights[0].setValue(3.0)
    form.own["exponent"].setValue(2.0)
    form.own["strict"].setChecked(True)
    wanted = Penalty(weights=(3.0, 1.0, 1.0), exponent=2.0, strict=True)
    assert form.objective() == wanted
    settings_page.compute()
    pump(60)
    review.dock().tabs.setCurrentIndex(3)
    screenshot("settings-objective")
    result = tree.sensitivity_of(machine)
    assert told.objective(result.Objective) == extract.objective(machine) == wanted
    core = extract.core_machine(machine)
    known = workspace.sensitivity(core, extract.positions(machine, core), wanted)
    np.testing.assert_allclose(list(result.Total), known.total, rtol=1e-12)
    assert results.load(machine, result).objective == wanted
    form.name.setCurrentIndex(0)
    assert form.own == {}
    settings_page.show_machine(machine, result)
    assert form.objective() == wanted


def test_an_objective_that_is_not_registered_here_is_said_and_nothing_is_lost(machine, machine_doc):
    run("Sens_Sensitivity")
    result = tree.sensitivity_of(machine)
    text = json.dumps({"name": "of_somebody_else", "output": "position", "weights": [1, 1, 1]})
    result.Objective = machine.Objective = text
    machine_doc.recompute()
    review.show(machine)
    pump(60)
    assert "of_somebody_else" in review.dock().head.text()
    assert machine.Objective == text


def test_every_objective_of_the_program_has_words_in_every_language():
    from sensworkbench.messages.tables import table

    for name in objectives.OBJECTIVES:
        for language in ("en", "de", "ko"):
            assert f"objective-name-{name.replace('_', '-')}" in table(language)
    assert objective_form.words("objective-name-none", "no_words_yet") == "No words yet"


def test_what_a_document_says_follows_the_language_of_the_window(machine):
    axis = tree.axis_of(machine, "Z")
    body = tree.body_of(machine, "T")
    english = told.words(axis.ReferenceFrom)
    assert english.startswith("origin of ") and window.stored(axis.ReferenceFrom) == english
    Gui.setLocale("German")
    try:
        assert window.stored(axis.ReferenceFrom).startswith("Ursprung von ")
        assert window.stored(body.ReferenceFrom) != told.words(body.ReferenceFrom)
        assert window.stored("centre of mass of Column") == "centre of mass of Column"  # an earlier version wrote it
    finally:
        Gui.setLocale("English")
    assert App.ActiveDocument is not None
