# SPDX-License-Identifier: LGPL-2.1-or-later
"""All commands together: importing this module imports every module of the window, and with it every command.

Menu, toolbars and the table of the guide are made from the registry of `command`.
"""

from __future__ import annotations

import importlib
import os
import pkgutil

from .command import GROUPS, NEEDS, REGISTRY, Command, ordered
from .qt import translate

PACKAGE = __name__.rpartition(".")[0]

for _module in sorted(m.name for m in pkgutil.iter_modules([os.path.dirname(os.path.abspath(__file__))])):
    if f"{PACKAGE}.{_module}" != __name__:
        importlib.import_module(f"{PACKAGE}.{_module}")


def inside() -> set[str]:
    """Return the names of commands that are shown behind the button of another one."""
    return {name for c in REGISTRY.values() for name in getattr(c, "members", ())}


def shown() -> list[Command]:
    """The commands of the menu, in its order."""
    return [c for c in ordered() if c.name not in inside() and not c.hidden]


def toolbars() -> list[tuple[str, list[str]]]:
    """(title, names of commands) of each toolbar."""
    found = {group: [c.name for c in shown() if c.where.group == group and c.where.toolbar] for group in GROUPS}
    return [(translate("Workbench", GROUPS[g]), names) for g, names in found.items() if GROUPS[g] and names]


def menu() -> list[str]:
    """Names of commands, with "Separator" between the groups."""
    entries, last = [], None
    for one in shown():
        if last not in (None, one.where.group):
            entries.append("Separator")
        entries.append(one.name)
        last = one.where.group
    return entries


def context_menu() -> list[str]:
    """What the context menu of the 3D view offers."""
    return ["Sens_Sensitivity", "Sens_OriginalColours"] if NEEDS["machine"][0]() else []


def markdown() -> str:
    """Return the table of commands of the guide, in English."""
    lines = ["| command | what it does | needs | keys | section |", "|---|---|---|---|---|"]
    for one in ordered():
        if one.hidden or hasattr(one, "members"):
            continue
        title = one.menu_text.rstrip("…")
        lines.append(f"| {title} | {one.tip} | {NEEDS[one.needs][1]} | {one.keys} | {one.guide} |")
    return "\n".join(lines) + "\n"
