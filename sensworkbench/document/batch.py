# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents without a window: open, find the machine, store results in a copy that keeps its looks.

A document whose foreign objects did not come back whole is refused, because saving it would lose them.  The input is
never written; the copy appears at once and complete, or not at all.
"""

from __future__ import annotations

import contextlib
import os
import tempfile
from dataclasses import dataclass
from pathlib import Path

import FreeCAD as App

from ..core.machine import Machine
from ..core.workspace import Sensitivity
from ..formats import fitted_json, provenance, study_files
from ..messages import Message, Refused
from ..studies.sensitivity import SensitivityRequest, sensitivity_study
from . import (
    closed_loop,  # noqa: F401 - as objects
    objects,  # noqa: F401 - FreeCAD restores proxies only from modules that it knows, or that are loaded
    results,
    tables,
)
from .archive import Contents, check_whole, keep_view, read_contents
from .base import kind_of, put
from .extract import core_machine, objective, positions
from .factory import make_effect, set_tolerances
from .refresh import refresh
from .tree import effects_of, machine_of


@dataclass
class Opened:
    """A document opened for a batch run.  `machine`: its Machine object.  `close()` forgets it without saving."""

    path: Path
    document: App.Document
    machine: App.DocumentObject
    contents: Contents

    def close(self) -> None:
        """Close the document."""
        if self.document.Name in App.listDocuments():
            App.closeDocument(self.document.Name)

    def __enter__(self) -> Opened:
        return self

    def __exit__(self, *_) -> None:
        self.close()


def open_document(path) -> Opened:
    """Open an FCStd file and find its machine.  Refuses, naming add-ons and objects."""
    path = Path(path)
    if not path.is_file():
        raise Refused("document-file-missing", str(path))
    contents = read_contents(path)
    provenance.note_file(path)
    before = set(App.listDocuments())
    try:
        document = App.openDocument(str(path.absolute()))
    except Exception as error:  # noqa: BLE001 - FreeCAD raises whatever the damaged part makes it raise
        _close_new(before)
        raise Refused("document-cannot-be-opened", str(path), reason=str(error).strip()) from None
    try:
        _check_restored(document, contents, path)
        try:
            machine = machine_of(document)
        except Refused as error:
            raise Refused(error.code, str(path), **error.fields) from None
    except Refused:
        _close_new(before)
        raise
    return Opened(path, document, machine, contents)


def _close_new(before) -> None:
    for name in set(App.listDocuments()) - before:
        App.closeDocument(name)


def _check_restored(document, contents: Contents, path) -> None:
    lost = [f"{n} ({t})" for n, t in contents.types.items() if document.getObject(n) is None]
    if lost:
        raise Refused("document-types-unknown", str(path), objects=_some(lost))
    blocked: dict[str, list[str]] = {}
    for name, module in contents.modules.items():
        obj = document.getObject(name)
        if getattr(obj, "Proxy", None) is None:
            blocked.setdefault(module, []).append(obj.Label)
    if blocked:
        what = [Message("document-objects-of-module", objects=_some(x), module=module) for module, x in blocked.items()]
        addons = sorted({module.split(".")[1 if module.startswith("freecad.") else 0] for module in blocked})
        raise Refused("document-addon-missing", str(path), objects=what, addons=addons)
    shapeless = [document.getObject(name) for name in sorted(contents.shaped)]
    parts = [obj.Label for obj in shapeless if getattr(obj, "Shape", None) is None or obj.Shape.isNull()]
    if parts:
        raise Refused("document-solid-lost", str(path), parts=_some(parts))


def _some(names) -> list | Message:
    """The first five of many names."""
    return names if len(names) <= 5 else Message("document-names-and-more", names=names[:5], count=len(names) - 5)


def load_machine(path) -> tuple[Machine, Opened]:
    """(core machine at home, the opened document).  Close the second when done; refuses as `open_document`."""
    opened = open_document(path)
    try:
        return core_machine(opened.machine), opened
    except Refused as error:
        opened.close()
        raise error.at(str(path)) from None


@contextlib.contextmanager
def _source(source):
    if isinstance(source, Opened):
        yield source
    else:
        with open_document(source) as opened:
            yield opened


def sensitivity(
    path,
    folder,
    request: SensitivityRequest = SensitivityRequest(),
    angle_unit: str = "urad",
    picture: bytes | None = None,
    language: str = "en",
) -> list[Path]:
    """The verb `sensitivity` on a document: tables, report and DIR/sensitivity.FCStd appear together in `folder`.

    What `request` leaves open (objective, positions) is as set in the document.  Returns the paths.
    """
    core, opened = load_machine(path)
    with opened:
        where = positions(opened.machine, request.machine(core))
        study = sensitivity_study(core, request, objective=objective(opened.machine), positions=where)

        def add_document(work: Path):
            write_sensitivity(opened, work / "sensitivity.FCStd", study.sensitivity, study.machine)

        if (Path(folder) / "sensitivity.FCStd").exists() and (Path(folder) / "sensitivity.FCStd").samefile(path):
            raise Refused("document-result-is-input", str(path))
        return study_files.write_sensitivity(folder, study, angle_unit, picture, add_document, language)


def write_sensitivity(source, path_out, result: Sensitivity, machine: Machine | None = None) -> Path:
    """Write a copy of a document with the indices stored, to be coloured when it is opened in the window.

    source : path or `Opened`.  machine : the core machine that was computed, where its tolerances or squareness differ
    from the document's; the copy then takes those.
    """
    with _source(source) as opened:
        obj = opened.machine
        if machine is not None:
            _take_model(obj, machine)
        found = results.store(obj, result, machine or core_machine(obj))
        put(found, "Coloured", True)
        return save_copy(opened, path_out)


def write_augmented(source, path_out, machine: Machine) -> Path:
    """Write a copy with what tracing found: fitted errors, declared degrees, and the effects under their bodies."""
    with _source(source) as opened:
        obj = opened.machine
        _take_model(obj, machine)
        obj.Declared = {symbol: str(int(degree)) for symbol, degree in machine.declared.items()}
        put(obj, "Fitted", fitted_json.dumps(machine.fitted))
        for old in effects_of(obj):
            opened.document.removeObject(old.Name)
        for effect in machine.effects:
            make_effect(obj, effect)
        refresh(obj)
        return save_copy(opened, path_out)


def _take_model(obj, machine: Machine) -> None:
    if obj.Squareness != machine.squareness:
        obj.Squareness = machine.squareness
    if dict(machine.tolerances) != tables.read_tolerances(obj):
        set_tolerances(obj, dict(machine.tolerances))


def save_copy(opened: Opened, path_out) -> Path:
    """Save the opened document as `path_out`, whole or not at all, with the view data of the original.

    Without view data in the original the machine is marked `ViewPending`: the window shows and colours it on opening.
    With it, objects that were added are listed in `Unseen`, because a window hides what has no view data.
    """
    path_out = Path(path_out)
    if path_out.exists() and path_out.samefile(opened.path):
        raise Refused("document-result-is-input", str(path_out))
    put(opened.machine, "ViewPending", not opened.contents.has_view)
    added = {o.Name for o in opened.document.Objects if kind_of(o)} - set(opened.contents.types)
    put(opened.machine, "Unseen", sorted(added | set(opened.machine.Unseen)) if opened.contents.has_view else [])
    try:
        path_out.parent.mkdir(parents=True, exist_ok=True)
        handle, name = tempfile.mkstemp(prefix=f".{path_out.stem}-", suffix=".FCStd", dir=path_out.parent)
    except OSError as error:
        reason = error.strerror or str(error)
        raise Refused("document-cannot-be-written", str(path_out), reason=reason) from None
    os.close(handle)
    work = Path(name)
    try:
        # not saveCopy: links to other documents are stored relative to the file, and only saveAs adapts them
        opened.document.saveAs(str(work))
        opened.document.Label = path_out.stem
        opened.document.save()
        keep_view(opened.path, work)
        check_whole(work)
        work.chmod(0o666 & ~_umask())
        work.replace(path_out)
    finally:
        for left in work.parent.glob(f"{work.stem}*"):
            left.unlink()
    return path_out


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
