# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command that switches a traced effect off and on."""

from __future__ import annotations

from ..core.refusal import Refused
from ..document import factory
from . import messages
from .command import Command, Where, command
from .current import selected
from .qt import QT_TRANSLATE_NOOP, translate


@command
class SwitchEffect(Command):
    name = "Sens_SwitchEffect"
    menu_text = QT_TRANSLATE_NOOP("Sens_SwitchEffect", "Effect On or Off")
    tip = QT_TRANSLATE_NOOP("Sens_SwitchEffect", "Switches the selected effect off, or on again")
    needs, guide, hidden = "effect", "8. Close the loop: readings in, the missing effect out", True
    where = Where("loop", 50, toolbar=False, double=("Effect",))

    def run(self):
        effect = selected("Effect")
        if effect is None:
            raise Refused(translate("Sens", "no effect is selected"))
        machine = factory.owner_machine(effect)

        def change():
            effect.Enabled = not effect.Enabled
            machine.touch()

        messages.change(effect.Document, translate("Sens", "Effect on or off"), change)
