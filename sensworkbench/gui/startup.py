# SPDX-License-Identifier: LGPL-2.1-or-later
"""What happens when FreeCAD's window starts: languages, preference page, and an eye on documents.

Nothing heavy is imported here; the rest of the package is loaded when a document holds one of our objects, or the
workbench is used.
"""

from __future__ import annotations

import FreeCAD as App

from . import state
from .files import icon_path, translations
from .qt import later, main_window, translate

__all__ = ["begin", "icon_path", "translate"]


def begin() -> None:
    """Register everything; called once, by InitGui."""
    import FreeCADGui as Gui

    Gui.addLanguagePath(translations())
    if hasattr(Gui, "updateLocale"):
        Gui.updateLocale()
    Gui.addIconPath(icon_path("").rsplit("/", 1)[0])
    from .preferences import PreferencePage

    Gui.addPreferencePage(PreferencePage, "Sens")
    App.addDocumentObserver(Observer())
    later(_ready)


def _ready() -> None:
    """When the window exists: give view providers to objects that are made or restored, and adopt open documents."""
    from ..document.base import register_dresser

    def made_or_restored(obj):
        from . import commands  # noqa: F401 - context menus and double clicks need them
        from .viewproviders import dress

        dress(obj)
        adopt_soon(obj.Document)

    register_dresser(made_or_restored)
    from .whats_this import WhatsThis

    WhatsThis(main_window())
    for name in list(App.listDocuments()):
        adopt_soon(App.getDocument(name))


def adopt_soon(doc) -> None:
    """Take over a document that holds our objects, once, when the event loop is idle."""
    name = doc.Name
    if state.of(name).adopting:
        return
    state.of(name).adopting = True

    def adopt():
        if name not in App.listDocuments():
            state.forget(name)
            return
        state.of(name).adopting = False
        document = App.getDocument(name)
        if any(hasattr(o, "SensType") for o in document.Objects):
            from .adopt import adopt as run

            run(document)

    later(adopt)


_EMPTY = {"App::PropertyXLinkSub": None, "App::PropertyXLink": None, "App::PropertyXLinkSubList": []}


def look_soon(doc) -> None:
    """Report once, when a document with damaged objects of ours has been opened, how they can be repaired."""
    name = doc.Name
    if state.of(name).examined:
        return
    state.of(name).examined = True

    def look():
        document = App.getDocument(name) if name in App.listDocuments() else None
        if document is None:
            state.forget(name)
        elif getattr(document, "Restoring", False):
            later(look, 20)
        elif document.FileName and any(hasattr(o, "SensType") for o in document.Objects):
            from .task_repair import announce

            announce(document)

    later(look)


class Observer:
    """Observes opening, undo and redo of documents; undamaged objects report themselves when they are restored."""

    def slotActivateDocument(self, doc):
        look_soon(doc)

    def slotDeletedDocument(self, doc):
        from . import panel

        panel.document_gone(doc.Name)
        state.forget(doc.Name)

    def slotDeletedObject(self, obj):
        # FreeCAD 1.0 cannot undo the making of an object whose links it has yet to take back ("invalid container", and
        # a crash later); what is emptied here, redo fills again
        if "SensType" in obj.PropertiesList and getattr(obj.Document, "Transacting", False):
            for name in obj.PropertiesList:
                kind = obj.getTypeIdOfProperty(name)
                if kind in _EMPTY:
                    setattr(obj, name, _EMPTY[kind])

    def slotUndoDocument(self, doc):
        self._settle(doc)

    def slotRedoDocument(self, doc):
        self._settle(doc)

    @staticmethod
    def _settle(doc):
        from . import panel

        panel.undone(doc.Name)
        if any(hasattr(o, "SensType") for o in doc.Objects):
            from .adopt import settle

            settle(doc.Name)
