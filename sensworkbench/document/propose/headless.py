# SPDX-License-Identifier: LGPL-2.1-or-later
"""The verb `propose` on a document: proposal.json always, machine.json and machine.FCStd where it is complete.

The document itself is never saved.  Objects of add-ons that are missing are looked at by their shapes all the same.
"""

from __future__ import annotations

from pathlib import Path

import FreeCAD as App

from ...formats import machine_json, proposal_json
from ...formats.file_sets import staged
from ...formats.files import write_text
from ...messages import Message, Refused
from .. import batch
from ..archive import read_contents
from ..extract import core_machine
from . import building, engine
from .found import Found


def typed(found: Found) -> proposal_json.Proposal:
    """The proposal as `proposal.json` holds it."""
    return proposal_json.Proposal(
        found.complete,
        found.kind,
        found.structure,
        {body: tuple(u.label for u in units) for body, units in found.bodies.items()},
        {
            name: proposal_json.ProposedAxis("linear", tuple(a.u), a.travel, tuple(a.evidence), a.confidence)
            for name, a in found.axes.items()
        },
        tuple(q.message for q in found.questions),
        tuple(found.remarks),
        found.seconds,
    )


def propose(path, folder, answers=None) -> list[Path]:
    """Write the proposal of the document `path` into `folder`; returns the paths.  Refuses a file that is no document.

    answers : name of a question -> label of a part, list of labels, choice or numbers.
    """
    path = Path(path)
    if not path.is_file():
        raise Refused("document-file-missing", str(path))
    contents = read_contents(path)
    before = set(App.listDocuments())
    try:
        document = App.openDocument(str(path.absolute()))
    except Exception as error:  # noqa: BLE001 - FreeCAD raises whatever the damaged part makes it raise
        batch._close_new(before)
        raise Refused("document-cannot-be-opened", str(path), reason=str(error).strip()) from None
    try:
        found = engine.propose(document, answers=answers)
        lost = sorted({m.split(".")[0] for name, m in contents.modules.items()
                       if getattr(document.getObject(name), "Proxy", None) is None})  # fmt: skip
        if lost:
            found.remarks.append(Message("propose-proxies-lost", addons=", ".join(lost)))
        with staged(folder, "propose") as work:
            machine = _machine(document, found, path.stem)
            if machine is not None:
                machine_json.save(core_machine(machine), work / "machine.json")
                opened = batch.Opened(path, document, machine, contents)
                batch.save_copy(opened, work / "machine.FCStd")
            write_text(work / "proposal.json", proposal_json.dumps(typed(found)))
            names = sorted(p.name for p in work.iterdir() if p.is_file() and not p.name.startswith("."))
        return [Path(folder) / name for name in names]
    finally:
        batch._close_new(before)


def _machine(document, found: Found, label: str):
    """The machine of a complete proposal, or None where it cannot be computed; what is wrong becomes a remark."""
    if not found.complete:
        return None
    try:
        machine = building.build(document, found, label=label)
        core_machine(machine)
    except Refused as error:
        found.remarks.append(Message("propose-build-problem", problem=error.message))
        return None
    return machine
