# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands that compute and show the indices of a machine, and have no panel of their own."""

from __future__ import annotations

from ..core.refusal import Refused
from ..document import tree
from . import display, messages, review, state
from .colours import restore
from .command import Command, Where, command
from .current import current_machine
from .qt import QT_TRANSLATE_NOOP, translate


@command
class Sensitivity(Command):
    name = "Sens_Sensitivity"
    keys = "Y, S"
    menu_text = QT_TRANSLATE_NOOP("Sens_Sensitivity", "Sensitivity")
    tip = QT_TRANSLATE_NOOP(
        "Sens_Sensitivity", "Computes the indices of every error, colours the parts and shows the ranking"
    )
    guide = "3. Sensitivity"
    where = Where("analysis", 10, tree=("Machine", "Sensitivity"))

    def run(self):
        machine = current_machine()
        state.of(machine.Document).ranges.clear()  # the colours are taken anew
        if messages.change(
            machine.Document, translate("Sens", "Sensitivity"), lambda: display.compute_and_colour(machine)
        ):
            review.show(machine)


@command
class Review(Command):
    name = "Sens_Review"
    keys = "Y, R"
    menu_text = QT_TRANSLATE_NOOP("Sens_Review", "Review")
    tip = QT_TRANSLATE_NOOP("Sens_Review", "Shows the ranking, the components and what-if beside the model")
    guide, beside = "3. Sensitivity", True
    where = Where("analysis", 20, double=("Sensitivity",))

    def run(self):
        review.show(current_machine())


@command
class ErrorMap(Command):
    name = "Sens_ErrorMap"
    keys = "Y, M"
    menu_text = QT_TRANSLATE_NOOP("Sens_ErrorMap", "Error Map")
    tip = QT_TRANSLATE_NOOP(
        "Sens_ErrorMap", "Shows the error over the workspace as coloured points or a slice, or hides it"
    )
    needs, guide = "result", "6. The error over the workspace"
    where = Where("analysis", 40)

    def run(self):
        machine = current_machine()
        result = tree.sensitivity_of(machine)
        view = result.ViewObject

        def change():
            view.ShowErrorMap = not view.ShowErrorMap
            display.update(result)

        if messages.change(machine.Document, translate("Sens", "Error map"), change) and view.ShowErrorMap:
            messages.status(translate("Sens", "What the map shows is chosen in the review, under Settings"))


@command
class OriginalColours(Command):
    name = "Sens_OriginalColours"
    keys = "Y, O"
    menu_text = QT_TRANSLATE_NOOP("Sens_OriginalColours", "Original Colours")
    tip = QT_TRANSLATE_NOOP(
        "Sens_OriginalColours",
        "Gives every part the colours back that it had before, or shows those of the result again",
    )
    needs, guide = "result", "3. Sensitivity"
    where = Where("analysis", 50, tree=("Sensitivity",))

    def run(self):
        machine = current_machine()
        result = tree.sensitivity_of(machine)
        if result is None:
            raise Refused("gui-no-result", machine.Label)

        def change():
            if result.Coloured:
                restore(result)
            else:
                result.Coloured = True
            display.update(result)

        messages.change(machine.Document, translate("Sens", "Original colours"), change)
