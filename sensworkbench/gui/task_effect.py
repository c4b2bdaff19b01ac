# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of a traced effect: what it is, how it depends on its driver, and whether it takes part.

The tree shows an effect that is off with a closed eye.
"""

from __future__ import annotations

import json

from ..core.refusal import Refused
from ..document import tree
from ..formats.trace_html import driver_words, parameter_words
from ..formats.words import Words
from . import messages
from .command import Command, Where, command
from .current import selected
from .panel import Panel
from .panel import rows as form_rows
from .panel import show as show_panel
from .qt import QT_TRANSLATE_NOOP, QtGui, translate
from .texts import error_meaning
from .trace_pages import parameter_name


class TaskEffect(Panel):
    """The panel; OK writes whether the effect takes part, as one undo step."""

    guide = "8. Close the loop: readings in, the missing effect out"

    def __init__(self, effect):
        self.effect = effect
        self.make_form("SensEffect", effect.Label, "Sens_Effect")
        page = QtGui.QVBoxLayout(self.form)
        rows = form_rows()
        what = f"{effect.Component}, {error_meaning(effect.Component)}"
        for title, text in (
            (translate("Sens", "Component"), what),
            (translate("Sens", "Driver"), driver_words(effect.Driver)),
            (translate("Sens", "Shape"), effect.Shape),
            *parameters(effect.Parameters),
        ):
            label = QtGui.QLabel(text)
            label.setWordWrap(True)
            rows.addRow(title, label)
        page.addLayout(rows)
        self.enabled = QtGui.QCheckBox(translate("Sens", "Takes part in the errors of the machine"))
        self.enabled.setChecked(bool(effect.Enabled))
        page.addWidget(self.enabled)
        page.addStretch(1)

    def accept(self):
        wanted = self.enabled.isChecked()
        if wanted != self.effect.Enabled and not switch(self.effect, wanted):
            return False
        self.close()
        return True


def parameters(text: str) -> list[tuple[str, str]]:
    """(name, value with unit and uncertainty) of the parameters of an effect, in words."""
    try:
        found = json.loads(text or "{}")
    except ValueError:
        return []
    words = Words(messages.language())
    return [(parameter_name(k), parameter_words(v, words)) for k, v in found.items() if k != "domains"]


def switch(effect, enabled: bool) -> bool:
    """Let an effect take part or not, as one undo step."""
    machine = tree.owner_machine(effect)

    def change():
        effect.Enabled = enabled
        machine.touch()

    return messages.change(effect.Document, translate("Sens", "Effect on or off"), change)


@command
class Effect(Command):
    name = "Sens_Effect"
    menu_text = QT_TRANSLATE_NOOP("Sens_Effect", "Effect…")
    tip = QT_TRANSLATE_NOOP("Sens_Effect", "Shows what an effect is, and whether it takes part in the errors")
    needs, guide, hidden = "effect", TaskEffect.guide, True
    where = Where("loop", 45, toolbar=False, double=("Effect",))

    def run(self):
        effect = selected("Effect")
        if effect is None:
            raise Refused("gui-no-effect-selected")
        show_panel(TaskEffect(effect), effect.Document)


@command
class SwitchEffect(Command):
    name = "Sens_SwitchEffect"
    menu_text = QT_TRANSLATE_NOOP("Sens_SwitchEffect", "Effect On or Off")
    tip = QT_TRANSLATE_NOOP("Sens_SwitchEffect", "Switches the selected effect off, or on again")
    needs, guide, hidden = "effect", TaskEffect.guide, True
    where = Where("loop", 50, toolbar=False, tree=("Effect",))

    def run(self):
        effect = selected("Effect")
        if effect is None:
            raise Refused("gui-no-effect-selected")
        switch(effect, not effect.Enabled)
