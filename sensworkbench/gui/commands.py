# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands, in the order of the work: machine, tolerances, sensitivity, review, report.

A command is greyed where it cannot work; what it changes is one undo step; what is refused is one message.
"""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui

from ..core.refusal import Refused
from ..document import factory
from ..document.base import kind_of
from . import display, live, loop_commands, messages, settings
from .command import QT_TRANSLATE_NOOP, Command, busy, current_machine, machines
from .files import icon_path
from .qt import translate


class NewMachine(Command):
    name = "Sens_Machine"
    menu_text = QT_TRANSLATE_NOOP("Sens_Machine", "Machine from Selection…")
    tip = QT_TRANSLATE_NOOP(
        "Sens_Machine", "Makes a machine from parts: which is the bed, and which carries X, Y, Z, spindle and table"
    )
    needs_machine = False

    def ready(self):
        return App.ActiveDocument is not None

    def run(self):
        from .task_machine import new_machine

        new_machine(App.ActiveDocument)


class MachineFromAssembly(Command):
    name = "Sens_MachineFromAssembly"
    menu_text = QT_TRANSLATE_NOOP("Sens_MachineFromAssembly", "Machine from Assembly…")
    tip = QT_TRANSLATE_NOOP("Sens_MachineFromAssembly", "Makes a machine from an assembly: its sliders are the axes")
    needs_machine = False

    def ready(self):
        from .task_assembly import found

        return bool(found(App.ActiveDocument))

    def run(self):
        from .task_assembly import open_panel

        open_panel()


class EditMachine(Command):
    name = "Sens_EditMachine"
    menu_text = QT_TRANSLATE_NOOP("Sens_EditMachine", "Edit Machine…")
    tip = QT_TRANSLATE_NOOP("Sens_EditMachine", "Changes chains, carriages, directions, reference points and travel")

    def run(self):
        from .task_machine import edit_machine

        chosen = [o for o in Gui.Selection.getSelection() if kind_of(o) in ("Axis", "Body")]
        body = getattr(chosen[0], "Axis", None) or getattr(chosen[0], "Body", None) if chosen else None
        edit_machine(current_machine(), body)


class Repair(Command):
    name = "Sens_Repair"
    menu_text = QT_TRANSLATE_NOOP("Sens_Repair", "Repair Machine…")
    tip = QT_TRANSLATE_NOOP(
        "Sens_Repair", "Says what is wrong with the objects of a machine and mends what can be mended"
    )
    needs_machine = False

    def ready(self):
        from ..document.repair import present

        return present(App.ActiveDocument)

    def run(self):
        from .task_repair import open_panel

        open_panel(App.ActiveDocument)


class _Example(Command):
    needs_machine = False
    code = ""

    def run(self):
        from ..document.examples import make_example

        doc = App.ActiveDocument
        if doc is None or doc.Objects:
            doc = App.newDocument(translate("Sens", "Machine") + self.code)
        if messages.change(doc, self.menu_text, lambda: settings.give(make_example(doc, self.code))):
            view = Gui.getDocument(doc.Name).activeView()
            view.viewIsometric()
            view.fitAll()


class ExampleXYFZ(_Example):
    name, code = "Sens_ExampleXYFZ", "XYFZ"
    menu_text = QT_TRANSLATE_NOOP("Sens_ExampleXYFZ", "Vertical Machining Centre (XYFZ)")
    tip = QT_TRANSLATE_NOOP(
        "Sens_ExampleXYFZ", "Makes a machining centre: table on cross slides, spindle on the column"
    )


class ExampleFXYZ(_Example):
    name, code = "Sens_ExampleFXYZ", "FXYZ"
    menu_text = QT_TRANSLATE_NOOP("Sens_ExampleFXYZ", "Gantry (FXYZ)")
    tip = QT_TRANSLATE_NOOP("Sens_ExampleFXYZ", "Makes a gantry machine: the tool carries out all three motions")


class ExampleYFXZ(_Example):
    name, code = "Sens_ExampleYFXZ", "YFXZ"
    menu_text = QT_TRANSLATE_NOOP("Sens_ExampleYFXZ", "Travelling Column (YFXZ)")
    tip = QT_TRANSLATE_NOOP("Sens_ExampleYFXZ", "Makes a travelling-column machine: the table moves along Y")


class Examples:
    """The three examples behind one button."""

    name = "Sens_Example"

    def GetCommands(self):
        return (ExampleXYFZ.name, ExampleFXYZ.name, ExampleYFXZ.name)

    def GetDefaultCommand(self):
        return 0

    def GetResources(self):
        tip = translate("Sens_Example", "Makes an example machine in an empty or new document")
        return {
            "MenuText": translate("Sens_Example", "Example Machine"),
            "ToolTip": tip,
            "StatusTip": tip,
            "WhatsThis": self.name,
            "Pixmap": icon_path(self.name),
            "DropDownMenu": True,
        }

    def IsActive(self):
        return not busy()


class Tolerances(Command):
    name = "Sens_Tolerances"
    menu_text = QT_TRANSLATE_NOOP("Sens_Tolerances", "Tolerances…")
    tip = QT_TRANSLATE_NOOP("Sens_Tolerances", "Edits limits and distribution of every error in a table")

    def run(self):
        from .task_tolerances import edit_tolerances

        edit_tolerances(current_machine())


class Sensitivity(Command):
    name = "Sens_Sensitivity"
    menu_text = QT_TRANSLATE_NOOP("Sens_Sensitivity", "Sensitivity")
    tip = QT_TRANSLATE_NOOP(
        "Sens_Sensitivity", "Computes the indices of every error, colours the parts and shows the ranking"
    )

    def run(self):
        machine = current_machine()
        if messages.change(machine.Document, translate("Sens", "Sensitivity"), lambda: compute_and_colour(machine)):
            from . import review

            review.show(machine)


def compute_and_colour(machine):
    """Compute, store and show the indices of a machine; returns the result.  The caller opens the transaction."""
    machine.Document.recompute()
    result = live.compute(machine)
    result.Coloured = True
    display.update(result)
    return result


class Review(Command):
    name = "Sens_Review"
    menu_text = QT_TRANSLATE_NOOP("Sens_Review", "Review")
    tip = QT_TRANSLATE_NOOP("Sens_Review", "Shows the ranking, the components and what-if beside the model")

    def IsActive(self):
        return bool(machines())

    def Activated(self, index=0):
        from . import review

        try:
            review.show(current_machine())
        except Refused as error:
            messages.show(error.message)


class OriginalColours(Command):
    name = "Sens_OriginalColours"
    menu_text = QT_TRANSLATE_NOOP("Sens_OriginalColours", "Original Colours")
    tip = QT_TRANSLATE_NOOP("Sens_OriginalColours", "Gives every part the colours back that it had before")

    def IsActive(self):
        return any(r.Coloured for m in machines() if (r := factory.sensitivity_of(m)) is not None)

    def run(self):
        from .colours import restore

        machine = current_machine()
        result = factory.sensitivity_of(machine)
        if result is None or not result.Coloured:
            raise Refused("its parts have their own colours already", machine.Label)

        def change():
            restore(result)
            display.update(result)

        messages.change(machine.Document, translate("Sens", "Original colours"), change)


class Report(Command):
    name = "Sens_Report"
    menu_text = QT_TRANSLATE_NOOP("Sens_Report", "Export Report…")
    tip = QT_TRANSLATE_NOOP("Sens_Report", "Writes the ranking as HTML with a picture of the view, and as JSON and CSV")

    def IsActive(self):
        return any(factory.sensitivity_of(m) is not None for m in machines())

    def run(self):
        from .export import ask_and_export

        ask_and_export(current_machine())


class Jog(Command):
    name = "Sens_Jog"
    menu_text = QT_TRANSLATE_NOOP("Sens_Jog", "Jog…")
    tip = QT_TRANSLATE_NOOP("Sens_Jog", "Moves the axes and all they carry; shows the Abbe offsets as arrows")

    def run(self):
        from .task_jog import jog

        jog(current_machine())


class ErrorMap(Command):
    name = "Sens_ErrorMap"
    menu_text = QT_TRANSLATE_NOOP("Sens_ErrorMap", "Error Map")
    tip = QT_TRANSLATE_NOOP(
        "Sens_ErrorMap", "Shows the error over the workspace as coloured points or a slice, or hides it"
    )

    def IsActive(self):
        return any(factory.sensitivity_of(m) is not None for m in machines())

    def run(self):
        machine = current_machine()
        result = factory.sensitivity_of(machine)
        view = result.ViewObject

        def change():
            view.ShowErrorMap = not view.ShowErrorMap
            display.update(result)

        if messages.change(machine.Document, translate("Sens", "Error map"), change) and view.ShowErrorMap:
            messages.status(translate("Sens", "What the map shows is chosen in the review, under Settings"))


COMMANDS = (
    NewMachine, MachineFromAssembly, EditMachine, Repair, ExampleXYFZ, ExampleFXYZ, ExampleYFXZ, Examples, Tolerances,
    Sensitivity, Review, OriginalColours, ErrorMap, Jog, Report, *loop_commands.COMMANDS,
)  # fmt: skip

for _kind in COMMANDS:
    Gui.addCommand(_kind.name, _kind())


def toolbars() -> list[tuple[str, list[str]]]:
    return [
        (
            translate("Workbench", "Sens Machine"),
            ["Sens_Machine", "Sens_MachineFromAssembly", "Sens_Example", "Sens_EditMachine", "Sens_Tolerances"],
        ),
        (
            translate("Workbench", "Sens Analysis"),
            ["Sens_Sensitivity", "Sens_Review", "Sens_Jog", "Sens_ErrorMap", "Sens_OriginalColours", "Sens_Report"],
        ),
        (
            translate("Workbench", "Sens Closed Loop"),
            [
                "Sens_ImportReadings",
                "Sens_Trace",
                "Sens_AddEffect",
                "Sens_Residuals",
                "Sens_TraceReport",
                "Sens_Tables",
            ],
        ),
    ]


def menu() -> list[str]:
    return [
        "Sens_Machine", "Sens_MachineFromAssembly", "Sens_Example", "Sens_EditMachine", "Sens_Tolerances",
        "Sens_Repair", "Separator",
        "Sens_Sensitivity", "Sens_Review", "Sens_Jog", "Sens_ErrorMap", "Sens_OriginalColours", "Separator",
        "Sens_Report", "Separator",
        *loop_commands.names(),
    ]  # fmt: skip


def context_menu() -> list[str]:
    return ["Sens_Sensitivity", "Sens_OriginalColours"] if machines() else []
