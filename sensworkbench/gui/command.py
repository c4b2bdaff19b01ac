# SPDX-License-Identifier: LGPL-2.1-or-later
"""What every command shares: its texts and icon, when it is greyed, and how a refusal becomes one message."""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui

from ..core.refusal import Refused
from ..document import factory
from ..document.base import kind_of
from . import messages
from .files import icon_path
from .qt import translate


def QT_TRANSLATE_NOOP(context, text):  # the name that lupdate looks for
    return text


# -- what commands work on -------------------------------------------------------------------------------------------
def machines() -> list:
    """The machines of the active document; cheap enough to be asked whenever a menu is updated."""
    doc = App.ActiveDocument
    if doc is None:
        return []
    return [o for o in doc.findObjects("App::DocumentObjectGroup") if kind_of(o) == "Machine"]


def current_machine():
    """The selected machine (or that of the selected axis, table or result), else the only one; refuses otherwise."""
    for obj in Gui.Selection.getSelection():
        machine = obj if kind_of(obj) == "Machine" else factory.owner_machine(obj) if kind_of(obj) else None
        if machine is not None:
            return machine
    return factory.machine_of(App.ActiveDocument)


def busy() -> bool:
    """True while a task panel is open."""
    return bool(Gui.Control.activeDialog())


class Command:
    """Base: texts and icon from class attributes, active when ready and no panel is open, refusals shown."""

    name, menu_text, tip, icon, keys = "", "", "", "", ""
    needs_machine = True

    def GetResources(self):
        text = translate(self.name, self.menu_text)
        tip = translate(self.name, self.tip)
        found = {"MenuText": text, "ToolTip": tip, "StatusTip": tip, "WhatsThis": self.name}
        found["Pixmap"] = icon_path(self.icon or self.name)
        if self.keys:
            found["Accel"] = self.keys
        return found

    def IsActive(self):
        return not busy() and self.ready()

    def ready(self) -> bool:
        """Could the command work in the active document?  Asked often, so it must be cheap."""
        return not self.needs_machine or bool(machines())

    def Activated(self, index=0):
        if busy():
            messages.show(translate("Sens", "Another panel is open. Close it first."))
            return
        try:
            self.run()
        except Refused as error:
            messages.refused(error, App.ActiveDocument)
        if busy():
            from . import review

            review.make_room()
        else:
            from . import first_steps

            first_steps.update()

    def run(self):
        raise NotImplementedError
