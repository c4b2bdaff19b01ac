# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the view providers of all our objects share: an icon, a double click, a context menu out of the commands."""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui

from ..document.base import alive, kind_of
from ..document.repair import examine_object
from .command import REGISTRY, offered
from .files import icon_path, tree_icon
from .qt import QtGui, translate

DAMAGED, REPAIR = "Sens_Damaged", "Sens_Repair"


class ViewProviderSens:
    """Base: an icon, a double click that opens the panel, a context menu, nothing stored."""

    icon = "Sens_Machine"

    def __init__(self, vobj):
        vobj.Proxy = self

    def attach(self, vobj):
        self.name = (vobj.Object.Document.Name, vobj.Object.Name)

    @property
    def object(self):
        """The document object, or None where it is gone."""
        document, name = getattr(self, "name", ("", ""))
        if document not in App.listDocuments():
            return None
        return App.getDocument(document).getObject(name)

    def getIcon(self):
        obj = self.object
        return tree_icon(self.icon if obj is None or alive(obj) else DAMAGED)

    def entries(self, obj) -> list[str]:
        """Names of the commands in the context menu of an object; a damaged one offers its repair as well.

        The first is that of the double click: the repair where something can be mended.
        """
        names = [c.name for c in offered(kind_of(obj))]
        damaged = examine_object(obj)
        if any(finding.mendable for finding in damaged):
            return [REPAIR, *names]
        return [*names, *([REPAIR] if damaged else [])]

    def setupContextMenu(self, vobj, menu):
        for name in self.entries(vobj.Object):
            text = translate(name, REGISTRY[name].menu_text)
            action = QtGui.QAction(QtGui.QIcon(icon_path(REGISTRY[name].icon or name)), text, menu)
            action.triggered.connect(_runner(name, vobj.Object))
            menu.addAction(action)

    def doubleClicked(self, vobj):
        entries = self.entries(vobj.Object)
        if not entries:
            return False
        _runner(entries[0], vobj.Object)()
        return True

    def dumps(self):
        return None

    def loads(self, state):
        return None

    def __getstate__(self):  # FreeCAD up to 0.21
        return None

    def __setstate__(self, state):
        return None


def _runner(name: str, obj):
    def run(*_):
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(obj)
        Gui.runCommand(name, 0)

    return run
