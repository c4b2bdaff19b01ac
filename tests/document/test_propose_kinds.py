# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ten kinds of machines, each written in every way in which people write documents: right, in time, not too sure."""

from __future__ import annotations

import importlib.util
import time

import FreeCAD as App
import numpy as np
import pytest

from sensworkbench.document.propose import engine

from .machines import joined, kinds, writers

HAS_JOINTS = importlib.util.find_spec("UtilsAssembly") is not None  # FreeCAD 1.0 and later
WRITERS = {**writers.WRITERS, **(joined.JOINED if HAS_JOINTS else {})}
SAID_BY_NOTHING = {  # a lathe without names is no lathe; y is not up where no name says so; wheels without names
    ("slant_lathe", "numbers"), ("slant_lathe", "nameless_tree"), ("slant_lathe", "compound"),
    ("slant_lathe", "fusions"), ("slant_lathe", "sliders"), ("wheeled", "numbers"), ("wheeled", "nameless_tree"),
    ("wheeled", "compound"),    ("wheeled", "fusions"), ("stage", "yup"), ("plotter", "yup"), ("wheeled", "yup"),
}  # fmt: skip


def right(kind: kinds.Kind, found, turn) -> bool:
    """Whether structure (where there is one) and all directions are those of the machine, turned as the document is."""
    if kind.truth.structure is None:
        if found.complete:
            return False
    elif found.structure != kind.truth.structure:
        return False
    true = {axis: np.array(tuple(turn.multVec(App.Vector(*u)))) for axis, u in kind.truth.axes.items()}
    return sorted(found.axes) == sorted(true) and all(abs(found.axes[a].u @ u) > 0.9999 for a, u in true.items())


@pytest.mark.parametrize("writer", WRITERS)
def test_every_kind_is_found_however_it_is_written(writer, tmp_path):
    wrong, too_sure, slow = [], [], []
    before = set(App.listDocuments())
    for name, make in kinds.KINDS.items():
        kind, folder = make(), tmp_path / name
        folder.mkdir()
        doc = App.newDocument("SensTestKind")
        try:
            WRITERS[writer](doc, kind, folder)
            doc.recompute()
            began = time.process_time()
            found = engine.propose(doc)
            took = time.process_time() - began
        finally:
            for other in set(App.listDocuments()) - before:
                App.closeDocument(other)
        if took > 10:
            slow.append(name)
        if not right(kind, found, writers.TURNS.get(writer, App.Rotation())):
            too_sure += [(name, axis) for axis, a in found.axes.items() if a.confidence > 0.8]
            wrong.append(name)
    assert slow == [] and too_sure == []
    assert [n for n in wrong if (n, writer) not in SAID_BY_NOTHING] == []
