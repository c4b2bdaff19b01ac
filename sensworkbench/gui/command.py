# SPDX-License-Identifier: LGPL-2.1-or-later
"""Base class of all commands, and their registry.

A command is defined in the module of its panel.  Class attributes give everything about it: texts, place in menu,
toolbar and context menus, what it needs, its section of the guide, its keys.  `@command` enters it into REGISTRY;
menus, toolbars, context menus, the table in the guide and the tests are made from there.
"""

from __future__ import annotations

from dataclasses import dataclass

import FreeCAD as App
import FreeCADGui as Gui

from ..core.refusal import Refused
from ..document import closed_loop
from . import current, messages
from .files import icon_path
from .qt import QT_TRANSLATE_NOOP, busy_cursor, translate

# group of the menu -> title of its toolbar, in the order of the work
GROUPS = {
    "machine": QT_TRANSLATE_NOOP("Workbench", "Sens Machine"),
    "analysis": QT_TRANSLATE_NOOP("Workbench", "Sens Analysis"),
    "files": "",
    "loop": QT_TRANSLATE_NOOP("Workbench", "Sens Closed Loop"),
    "help": "",
}

# what a command needs in the active document -> (is it there?, words for the guide); asked often, so cheap
NEEDS = {
    "nothing": (lambda: True, ""),
    "document": (lambda: App.ActiveDocument is not None, "a document"),
    "machine": (lambda: bool(current.machines()), "a machine"),
    "result": (lambda: bool(current.results()), "a computed result"),
    "readings": (lambda: bool(current.tables()), "readings"),
    "trace": (lambda: bool(current.traces()), "a trace"),
    "effects found": (lambda: any(closed_loop.can_add(t) for t in current.traces()), "a trace that named an effect"),
    "effect": (lambda: bool(current.machines()) and current.selected("Effect") is not None, "a selected effect"),
    "fitted": (lambda: any(m.Fitted for m in current.machines()), "fitted errors"),
}

REGISTRY: dict[str, Command] = {}
AFTER: list = []  # functions that are called after every command, such as those that make room for a panel


def busy() -> bool:
    """True while a task panel is open."""
    return bool(Gui.Control.activeDialog())


@dataclass(frozen=True)
class Where:
    """group : of GROUPS.  rank : order in its group.  toolbar : whether it has a button there.

    tree : kinds of objects whose context menu offers it.  double : those on which a double click runs it.
    """

    group: str
    rank: int
    toolbar: bool = True
    tree: tuple[str, ...] = ()
    double: tuple[str, ...] = ()


class Command:
    """A command: texts, icon and place from class attributes; active when ready and no panel is open.

    needs : of NEEDS.  guide : the heading of its section in docs/guide.md.  keys : its shortcut.  icon : file, where it
    is not that of the name.  beside : it can be used while a panel is open.  hidden : only in context menus.
    """

    name, menu_text, tip, icon, keys, guide = "", "", "", "", "", ""
    needs = "machine"
    where: Where | None = None
    beside = False
    hidden = False

    def GetResources(self):
        text = translate(self.name, self.menu_text)
        tip = translate(self.name, self.tip)
        found = {"MenuText": text, "ToolTip": tip, "StatusTip": tip, "WhatsThis": self.name}
        found["Pixmap"] = icon_path(self.icon or self.name)
        if self.keys:
            found["Accel"] = self.keys
        return found

    def IsActive(self):
        return (self.beside or not busy()) and self.ready()

    def ready(self) -> bool:
        """Whether the command could work in the active document.  Asked often, so it must be cheap."""
        return NEEDS[self.needs][0]()

    def Activated(self, index=0):
        if busy() and not self.beside:
            messages.show(translate("Sens", "Another panel is open. Close it first."))
            return
        try:
            with busy_cursor():
                self.run()
        except Refused as error:
            messages.refused(error, App.ActiveDocument)
        except Exception as error:  # noqa: BLE001 - a defect: said where the person looks
            messages.stopped(error, translate(self.name, self.menu_text).rstrip("…"))
        for function in AFTER:
            function()

    def run(self):
        """Do the work; refuses what cannot be done."""
        raise NotImplementedError


def command(kind):
    """Enter a class of commands into REGISTRY and make it known to FreeCAD."""
    REGISTRY[kind.name] = made = kind()
    Gui.addCommand(kind.name, made)
    return kind


def after_command(function):
    """Call a function after every command."""
    AFTER.append(function)
    return function


def ordered() -> list[Command]:
    """All commands in the order of the menu."""
    groups = list(GROUPS)
    return sorted(REGISTRY.values(), key=lambda c: (groups.index(c.where.group), c.where.rank))


def offered(kind: str) -> list[Command]:
    """The commands in the context menu of an object of a kind; the one of its double click comes first."""
    found = [c for c in ordered() if kind in c.where.tree or kind in c.where.double]
    return sorted(found, key=lambda c: kind not in c.where.double)
