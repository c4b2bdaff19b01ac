# SPDX-License-Identifier: LGPL-2.1-or-later
"""What happens when FreeCAD's window starts: languages, preference page, and an eye on documents.

Nothing heavy is imported here; the rest of the package is loaded when a document holds one of our objects, or the
workbench is used.
"""

from __future__ import annotations

import FreeCAD as App

from .files import icon_path, translations
from .qt import later, translate

__all__ = ["begin", "icon_path", "translate"]

_observer: list = []


def begin() -> None:
    """Register everything once."""
    import FreeCADGui as Gui

    if _observer:
        return
    Gui.addLanguagePath(translations())
    if hasattr(Gui, "updateLocale"):
        Gui.updateLocale()
    Gui.addIconPath(icon_path("").rsplit("/", 1)[0])
    from .preferences import PreferencePage

    Gui.addPreferencePage(PreferencePage, "Sens")
    _observer.append(Observer())
    App.addDocumentObserver(_observer[0])
    later(_ready)


def _ready() -> None:
    """Once the window stands: new objects get their view providers; documents that are open already are adopted."""
    from ..document.base import register_dresser
    from .viewproviders import dress

    register_dresser(dress)
    for name in list(App.listDocuments()):
        adopt_soon(App.getDocument(name))


def adopt_soon(doc) -> None:
    """Dress a document that holds our objects, from the event loop."""
    name = doc.Name

    def adopt():
        if name not in App.listDocuments():
            return
        document = App.getDocument(name)
        if any(hasattr(o, "SensType") for o in document.Objects):
            from .adopt import adopt as run

            run(document)

    later(adopt)


class Observer:
    """Sees documents open, and undo and redo."""

    def slotFinishRestoreDocument(self, doc):
        adopt_soon(doc)

    def slotUndoDocument(self, doc):
        self._settle(doc)

    def slotRedoDocument(self, doc):
        self._settle(doc)

    @staticmethod
    def _settle(doc):
        import sys

        if "sensworkbench.gui.adopt" in sys.modules or any(hasattr(o, "SensType") for o in doc.Objects):
            from .adopt import settle

            settle(doc.Name)
