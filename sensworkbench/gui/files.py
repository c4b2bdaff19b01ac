# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the add-on's own files are: icons, translations, examples."""

from __future__ import annotations

import functools
import os

import sensworkbench

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(sensworkbench.__file__)))
RESOURCES = os.path.join(ROOT, "resources")


def icon_path(name: str) -> str:
    """Return the path of an icon, by its name without `.svg`."""
    return os.path.join(RESOURCES, "icons", f"{name}.svg")


def translations() -> str:
    """Return the folder of the compiled translations."""
    return os.path.join(RESOURCES, "translations")


def tree_icon(name: str) -> str:
    """What a view provider's getIcon returns: the icon's file, or its registered name where Qt cannot read SVG files.

    FreeCAD's tree loads icons through Qt's image plugins, and some Qt 6 installations lack the one for SVG; FreeCAD's
    own reader, which the toolbars use, is always there.
    """
    from .qt import QtGui

    path = icon_path(name)
    if any(bytes(f.data() if hasattr(f, "data") else f) == b"svg" for f in QtGui.QImageReader.supportedImageFormats()):
        return path
    return _registered_icon(name) or path


@functools.cache
def _registered_icon(name: str) -> str:
    """The name under which FreeCAD knows an icon as a picture of points, "" where it cannot paint it."""
    import FreeCADGui as Gui

    from .qt import QtCore

    icon = Gui.getIcon(icon_path(name)) if hasattr(Gui, "getIcon") else None
    if icon is None or icon.isNull():
        return ""
    data = QtCore.QByteArray()
    buffer = QtCore.QBuffer(data)
    buffer.open(QtCore.QIODevice.WriteOnly)
    icon.pixmap(64, 64).save(buffer, "PNG")
    buffer.close()
    Gui.addIcon(f"SensTree_{name}", bytes(data.data()), "PNG")
    return f"SensTree_{name}"
