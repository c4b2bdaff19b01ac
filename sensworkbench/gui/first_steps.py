# SPDX-License-Identifier: LGPL-2.1-or-later
"""How to begin, where there is no machine yet: under Tasks, as in FreeCAD's own workbenches, and in the status bar.

It is gone as soon as there is a machine, for on newer versions Tasks lie over the 3D view.
"""

from __future__ import annotations

import FreeCADGui as Gui

from . import messages
from .command import after_command
from .current import machines
from .qt import translate


class Begin:
    """The box that FreeCAD shows under Tasks while `shouldShow` (a task watcher)."""

    commands = ("Sens_Machine", "Sens_ExampleXYFZ", "Sens_ExampleFXYZ", "Sens_ExampleYFXZ")

    def __init__(self):
        self.title, self.icon = translate("Sens", "Begin with a machine"), messages.icon("SensWorkbench")
        self.commands = list(self.commands)

    def shouldShow(self) -> bool:
        return not machines()


def show() -> None:
    """Offer the first steps; called when the workbench is entered."""
    Gui.Control.addTaskWatcher([Begin()])
    if not machines():
        words = translate("Sens", "Begin with Sens > Example Machine, or Machine from Selection… on your own parts")
        messages.status(words)


def hide() -> None:
    """Offer nothing; called when the workbench is left."""
    Gui.Control.clearTaskWatcher()


@after_command
def update() -> None:
    """Let FreeCAD ask again what is to be shown, which it does not do by itself after a command."""
    if Gui.activeWorkbench().name() == "SensWorkbench" and not Gui.Control.activeDialog():
        Gui.Control.addTaskWatcher([Begin()])
