# SPDX-License-Identifier: LGPL-2.1-or-later
"""The FCStd file as a zip: what it says before FreeCAD opens it, and the view data that a windowless save would drop.

FreeCAD without a window saves no GuiDocument.xml, and a document without it opens hidden and grey.  So the view data of
the original is put back into what was saved.  Needs no FreeCAD.
"""

from __future__ import annotations

import re
import zipfile
import zlib
from dataclasses import dataclass
from pathlib import Path
from xml.parsers import expat

from ..core.refusal import Refused

DOCUMENT, VIEW, THUMBNAIL = "Document.xml", "GuiDocument.xml", "thumbnails/Thumbnail.png"
MAX_MEMBERS = 200_000
MAX_TEXT, MAX_MEMBER = 2**28, 2**32  # bytes: of the two XML texts, of any other member
SMALL, MAX_RATIO = 2**20, 200  # bytes from which a member may be this much larger than packed
MAX_DEPTH = 200  # of nested elements
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
    """Read the declarations of an FCStd file; refuses what is no FreeCAD document, and what would unpack without end.

    Nothing that the document holds is executed or imported; entities and document types are refused.
    """
    try:
        with zipfile.ZipFile(path) as archive:
            _check_sizes(archive, path)
            types, modules, shapes = _declared(_member(archive, DOCUMENT))
            sizes = {info.filename: info.file_size for info in archive.infolist()}
            shaped = frozenset(name for name, file in shapes.items() if sizes.get(file, 0) > 0)
            return Contents(types, modules, VIEW in sizes, shaped)
    except (OSError, zipfile.BadZipFile, zlib.error, EOFError, KeyError, expat.ExpatError):
        raise Refused("document-not-one", str(path)) from None
    except (NotImplementedError, RuntimeError, ValueError, LookupError, MemoryError) as error:
        if isinstance(error, Refused):
            raise
        raise Refused("document-not-one", str(path)) from None  # a packing or an encoding that is not supported


def check_whole(path) -> None:
    """Refuse an archive that was just written and cannot be read back (a disk that is full)."""
    try:
        with zipfile.ZipFile(path) as archive:
            whole = archive.testzip() is None and DOCUMENT in archive.namelist()
    except (OSError, zipfile.BadZipFile, zlib.error, EOFError, RuntimeError):
        whole = False
    if not whole:
        raise Refused("written-not-whole", str(path))


def _check_sizes(archive: zipfile.ZipFile, path) -> None:
    """Refuse before unpacking: too many members, or one that is far larger than what it is packed into."""
    members = archive.infolist()
    if len(members) > MAX_MEMBERS:
        raise Refused("document-too-large", str(path), name=f"{len(members)} members")
    for member in members:
        bomb = member.file_size > SMALL and member.file_size > MAX_RATIO * max(member.compress_size, 1)
        text = member.filename in (DOCUMENT, VIEW)
        if bomb or member.file_size > (MAX_TEXT if text else MAX_MEMBER):
            raise Refused("document-too-large", str(path), name=member.filename[:60])


def _member(archive: zipfile.ZipFile, name: str) -> bytes:
    """A member, of no more bytes than it declares."""
    size = archive.getinfo(name).file_size
    with archive.open(name) as stream:
        data = stream.read(size + 1)
    if len(data) > size:
        raise zipfile.BadZipFile
    return data


def _declared(text: bytes) -> tuple[dict[str, str], dict[str, str], dict[str, str]]:
    """(object -> type, object -> module of its Python proxy, object -> file of its shape) of a Document.xml."""
    types: dict[str, str] = {}
    modules: dict[str, str] = {}
    shapes: dict[str, str] = {}
    name, inside, shape, depth = "", False, False, 0

    def start(tag, attributes):
        nonlocal name, inside, shape, depth
        depth += 1
        if depth > MAX_DEPTH:
            raise zipfile.BadZipFile
        if tag == "Object":
            name = attributes.get("name", "")
            if attributes.get("type"):
                types[name] = attributes["type"]
        elif tag == "Property":
            inside = attributes.get("type") == "App::PropertyPythonObject"
            shape = attributes.get("name") == "Shape"
        elif tag == "Part" and shape and attributes.get("file"):
            shapes[name] = attributes["file"]
        elif tag == "Python" and inside and attributes.get("module"):
            modules[name] = attributes["module"]

    def end(_):
        nonlocal depth
        depth -= 1

    def refuse(*_):
        raise zipfile.BadZipFile

    parser = expat.ParserCreate()
    parser.StartElementHandler, parser.EndElementHandler, parser.StartDoctypeDeclHandler = start, end, refuse
    parser.Parse(text, True)  # all at once: in pieces, one long token takes time with the square of its length
    return types, modules, shapes


def keep_view(original, saved) -> bool:
    """Put the view data of `original` into `saved` (rewritten in place); False where there is none to keep."""
    with zipfile.ZipFile(original) as source:
        if VIEW not in source.namelist():
            return False
        view = _member(source, VIEW)
        known = set(source.namelist())
        side = [n for n in dict.fromkeys(m.decode("utf-8", "replace") for m in _FILE.findall(view)) if n in known]
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
                out.writestr(VIEW, _FILE.sub(lambda m: _with_name(m, renamed), view))
                for name, new in renamed.items():
                    out.writestr(new, source.read(name))
                if THUMBNAIL in known:
                    out.writestr(THUMBNAIL, source.read(THUMBNAIL))
            work.replace(saved)
        finally:
            work.unlink(missing_ok=True)
    return True


def _with_name(found: re.Match, renamed: dict[str, str]) -> bytes:
    name = found.group(1).decode("utf-8", "replace")
    return b'file="' + renamed[name].encode() + b'"' if name in renamed else found.group()


def _free(name: str, taken: set[str]) -> str:
    new, i = name, 0
    while new in taken:
        i += 1
        new = f"{name}_{i}"
    return new
