# SPDX-License-Identifier: LGPL-2.1-or-later
"""Registers Sens Workbench with FreeCAD's window.  FreeCAD executes this file's text: there is no __file__, and names
of this file are not visible inside the methods, so everything is imported where it is used."""

import FreeCADGui as Gui


class SensWorkbench(Gui.Workbench):
    """The workbench: menus and toolbars in the order of the work."""

    def __init__(self):
        from sensworkbench.gui import startup

        self.__class__.Icon = startup.icon_path("SensWorkbench")
        self.__class__.MenuText = "Sens"
        self.__class__.ToolTip = startup.translate(
            "Workbench", "Shows which component of a machine tool spoils its accuracy, from its Abbe offsets"
        )

    def Initialize(self):
        from sensworkbench.gui import commands

        for title, names in commands.toolbars():
            self.appendToolbar(title, names)
        self.appendMenu("Sens", commands.menu())

    def Activated(self):
        from sensworkbench.gui import first_steps, review

        first_steps.show()
        review.workbench_activated()

    def Deactivated(self):
        from sensworkbench.gui import first_steps

        first_steps.hide()

    def ContextMenu(self, recipient):
        from sensworkbench.gui import commands

        self.appendContextMenu("Sens", commands.context_menu())

    def GetClassName(self):
        return "Gui::PythonWorkbench"


def _start():
    from sensworkbench.gui import startup

    startup.begin()


Gui.addWorkbench(SensWorkbench())
_start()
del _start
