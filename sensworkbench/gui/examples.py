# SPDX-License-Identifier: LGPL-2.1-or-later
"""The three example machines, behind one button."""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui

from ..document.examples import make_example
from . import messages, settings
from .command import Command, Where, busy, command
from .qt import QT_TRANSLATE_NOOP, translate


class _Example(Command):
    needs, guide = "nothing", "1. A machine"
    code = ""

    def run(self):
        doc = App.ActiveDocument
        if doc is None or doc.Objects:
            doc = App.newDocument(translate("Sens", "Machine") + self.code)
        if messages.change(
            doc, translate(self.name, self.menu_text), lambda: settings.give(make_example(doc, self.code))
        ):
            view = Gui.getDocument(doc.Name).activeView()
            view.viewIsometric()
            view.fitAll()


@command
class ExampleXYFZ(_Example):
    name, code = "Sens_ExampleXYFZ", "XYFZ"
    menu_text = QT_TRANSLATE_NOOP("Sens_ExampleXYFZ", "Vertical Machining Centre (XYFZ)")
    tip = QT_TRANSLATE_NOOP(
        "Sens_ExampleXYFZ", "Makes a machining centre: table on cross slides, spindle on the column"
    )
    where = Where("machine", 31, toolbar=False)


@command
class ExampleFXYZ(_Example):
    name, code = "Sens_ExampleFXYZ", "FXYZ"
    menu_text = QT_TRANSLATE_NOOP("Sens_ExampleFXYZ", "Gantry (FXYZ)")
    tip = QT_TRANSLATE_NOOP("Sens_ExampleFXYZ", "Makes a gantry machine: the tool carries out all three motions")
    where = Where("machine", 32, toolbar=False)


@command
class ExampleYFXZ(_Example):
    name, code = "Sens_ExampleYFXZ", "YFXZ"
    menu_text = QT_TRANSLATE_NOOP("Sens_ExampleYFXZ", "Travelling Column (YFXZ)")
    tip = QT_TRANSLATE_NOOP("Sens_ExampleYFXZ", "Makes a travelling-column machine: the table moves along Y")
    where = Where("machine", 33, toolbar=False)


@command
class Examples(Command):
    name = "Sens_Example"
    menu_text = QT_TRANSLATE_NOOP("Sens_Example", "Example Machine")
    tip = QT_TRANSLATE_NOOP("Sens_Example", "Makes an example machine in an empty or new document")
    needs, guide = "nothing", "1. A machine"
    where = Where("machine", 30)
    members = (ExampleXYFZ.name, ExampleFXYZ.name, ExampleYFXZ.name)

    def GetCommands(self):
        return self.members

    def GetDefaultCommand(self):
        return 0

    def GetResources(self):
        return super().GetResources() | {"DropDownMenu": True}

    def IsActive(self):
        return not busy()
