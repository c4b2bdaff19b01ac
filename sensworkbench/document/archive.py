# SPDX-License-Identifier: LGPL-2.1-or-later
"""The FCStd file as a zip: what it says before FreeCAD opens it, and the view data that a windowless save would drop.

FreeCAD without a window saves no GuiDocument.xml, and a document without it opens hidden and grey.  So the view data of
the original is put back into what was saved.  Needs no FreeCAD.
"""

from __future__ import annotations

import re
import zipfile
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

from ..core.refusal import Refused

DOCUMENT, VIEW, THUMBNAIL = "Document.xml", "GuiDocument.xml", "thumbnails/Thumbnail.png"
_FILE = re.compile(rb'(?<![\w:])file="([^"]+)"')


@dataclass(frozen=True)
class Contents:
    """What a document's file declares.

    types : object name -> type.  modules : object name -> module of its Python proxy.  has_view : whether there is view
    data.  shaped : names of the objects for which the file holds a shape that is not empty.
    """

    types: dict[str, str]
    modules: dict[str, str]
    has_view: bool
    shaped: frozenset[str] = frozenset()


def read_contents(path) -> Contents:
    """Read the declarations of an FCStd file; refuses what is no FreeCAD document."""
    types: dict[str, str] = {}
    modules: dict[str, str] = {}
    shapes: dict[str, str] = {}
    try:
        with zipfile.ZipFile(path) as archive:
            sizes = {info.filename: info.file_size for info in archive.infolist()}
            has_view = VIEW in sizes
            with archive.open(DOCUMENT) as stream:
                name = ""
                inside = shape = False
                for event, element in ElementTree.iterparse(stream, events=("start", "end")):
                    if event == "start":
                        if element.tag == "Object":
                            name = element.get("name", "")
                            if element.get("type"):
                                types[name] = element.get("type", "")
                        elif element.tag == "Property":
                            inside = element.get("type") == "App::PropertyPythonObject"
                            shape = element.get("name") == "Shape"
                        elif element.tag == "Part" and shape and element.get("file"):
                            shapes[name] = element.get("file", "")
                        elif element.tag == "Python" and inside and element.get("module"):
                            modules[name] = element.get("module", "")
                    elif element.tag == "Object":
                        element.clear()
    except (OSError, zipfile.BadZipFile, KeyError, ElementTree.ParseError, NotImplementedError, RuntimeError):
        raise Refused("is not a FreeCAD document", str(path), "Save it again in FreeCAD.") from None
    shaped = frozenset(name for name, file in shapes.items() if sizes.get(file, 0) > 0)
    return Contents(types, modules, has_view, shaped)


def keep_view(original, saved) -> bool:
    """Put the view data of `original` into `saved` (rewritten in place); False where there is none to keep."""
    with zipfile.ZipFile(original) as source:
        if VIEW not in source.namelist():
            return False
        view = source.read(VIEW)
        known = set(source.namelist())
        side = {name.decode(): name for name in _FILE.findall(view) if name.decode() in known}
        saved = Path(saved)
        work = saved.with_name(saved.name + ".part")
        try:
            with zipfile.ZipFile(saved) as target, zipfile.ZipFile(work, "w", zipfile.ZIP_DEFLATED) as out:
                taken = set(target.namelist()) - {VIEW, THUMBNAIL}
                for name in target.namelist():
                    if name in taken:
                        out.writestr(target.getinfo(name), target.read(name))
                renamed = {}
                for name in side:
                    renamed[name] = _free(name, taken | set(renamed.values()))
                for name, new in renamed.items():
                    if new != name:
                        view = view.replace(f'file="{name}"'.encode(), f'file="{new}"'.encode())
                out.writestr(VIEW, view)
                for name, new in renamed.items():
                    out.writestr(new, source.read(name))
                if THUMBNAIL in known:
                    out.writestr(THUMBNAIL, source.read(THUMBNAIL))
            work.replace(saved)
        finally:
            work.unlink(missing_ok=True)
    return True


def _free(name: str, taken: set[str]) -> str:
    new, i = name, 0
    while new in taken:
        i += 1
        new = f"{name}_{i}"
    return new
