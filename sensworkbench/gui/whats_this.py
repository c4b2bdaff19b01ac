# SPDX-License-Identifier: LGPL-2.1-or-later
"""What's This on a command of ours.  Made when FreeCAD starts, so guide and commands are imported only when asked."""

from __future__ import annotations

from .qt import QtCore


class WhatsThis(QtCore.QObject):
    """What's This on one of our commands shows its section of the guide, not a page of FreeCAD's wiki."""

    def __init__(self, window):
        super().__init__(window)
        window.installEventFilter(self)

    def eventFilter(self, watched, event):
        if event.type() == QtCore.QEvent.WhatsThisClicked and event.href().startswith("Sens_"):
            from .command import REGISTRY
            from .guide import show

            if event.href() in REGISTRY:
                show(REGISTRY[event.href()].guide)
                return True
        return False
