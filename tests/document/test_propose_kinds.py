# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ten kinds of machines, each written in every way in which people write documents: right, in time, not too sure."""

from __future__ import annotations

import importlib.util
import random
import time

import FreeCAD as App
import numpy as np
import pytest

from sensworkbench.document.propose import engine

from .machines import add, bored, box, joined, kinds, odd, part, rod, spoilt, unlike, writers

HAS_JOINTS = importlib.util.find_spec("UtilsAssembly") is not None  # FreeCAD 1.0 and later
WRITERS = {**writers.WRITERS, **(joined.JOINED if HAS_JOINTS else {})}
SAID_BY_NOTHING = {  # a lathe without names is no lathe; y is not up where no name says so; wheels without names
    ("slant_lathe", "numbers"), ("slant_lathe", "nameless_tree"), ("slant_lathe", "compound"),
    ("slant_lathe", "fusions"), ("slant_lathe", "sliders"), ("wheeled", "numbers"), ("wheeled", "nameless_tree"),
    ("wheeled", "compound"), ("wheeled", "fusions"),
    *((kind, way) for kind in ("stage", "plotter", "wheeled") for way in ("yup", "ydown")),
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


UNLIKE_WAYS = {**writers.WRITERS, **spoilt.SPOILT}
ASKED = {
    ("plywood_router", "numbers"),
    ("way_lathe", "numbers"),
    ("wheel_on_board", "numbers"),
}  # shapes say too little

MISREAD = {("rod_printer", "numbers"), ("tube_router", "link_arrays")}  # wrong as yet, and never sure of it


@pytest.mark.parametrize("way", ["flat", "numbers", "decorated", "link_arrays"])
@pytest.mark.parametrize("name", unlike.UNLIKE)
def test_unlike_machines_of_random_sizes_are_found_by_names_or_by_shapes(doc, tmp_path, name, way):
    kind = unlike.UNLIKE[name](random.Random(1000 + len(name)))
    UNLIKE_WAYS[way](doc, kind, tmp_path)
    doc.recompute()
    found = engine.propose(doc)
    if (name, way) in MISREAD:
        assert all(axis.confidence <= 0.8 for axis in found.axes.values())
        return
    if (name, way) in ASKED:
        assert not found.complete and found.questions
        return
    assert (
        (found.structure in (kind.truth.structure, *kind.truth.either)) if kind.truth.structure else not found.complete
    )
    assert sorted(found.axes) == sorted(kind.truth.axes)
    assert all(abs(found.axes[a].u @ np.array(u)) > 0.999 for a, u in kind.truth.axes.items())


@pytest.mark.parametrize("names", [True, False])
@pytest.mark.parametrize("name", odd.PARALLEL)
def test_a_parallel_machine_is_refused_in_words_with_and_without_names(doc, name, names):
    odd.PARALLEL[name](doc, names)
    doc.recompute()
    found = engine.propose(doc)
    assert (found.kind, found.complete, found.axes) == ("parallel", False, {})
    assert found.remarks[0].code == "propose-delta" and found.questions[0].name == "kind"


@pytest.mark.parametrize("names", [True, False])
@pytest.mark.parametrize("name", odd.JOINTED)
def test_a_jointed_arm_is_no_machine_of_linear_axes(doc, name, names):
    odd.JOINTED[name](doc, names)
    doc.recompute()
    found = engine.propose(doc)
    assert not found.axes and not found.complete
    assert found.remarks[0].code == ("propose-robot" if names else "propose-nothing-slides")


@pytest.mark.parametrize("name", odd.NOTHING)
def test_furniture_and_engines_are_no_machines(doc, name):
    odd.NOTHING[name](doc)
    doc.recompute()
    assert not engine.propose(doc).complete


def test_a_machine_drawn_in_inches_is_found_with_its_travels_as_drawn(doc):
    kind = odd.inches(doc)
    doc.recompute()
    found = engine.propose(doc)
    assert right(kind, found, App.Rotation())
    for axis, length in kind.truth.travel.items():
        assert np.ptp(found.axes[axis].travel) == pytest.approx(length / 25.4, rel=0.01)


def test_a_part_number_says_the_travel_where_rail_and_block_do_not_touch(doc):
    base, table, head = (part(doc, n) for n in ("Base", "Y Table", "Z Head"))
    add(doc, "Slab", box((-300, 300), (-400, 400), (0, 50)), base)
    add(doc, "HGR20-600", box((-10, 10), (-200, 200), (50, 68)), base)  # drawn short
    add(doc, "SFU1605-650", rod((60, -380, 75), "y", 760, 8), base)
    add(doc, "Board", box((-200, 200), (-60, 60), (120, 140)), table)
    add(doc, "HGH20CA", box((-20, 20), (-40, 40), (75, 119)), table)
    add(doc, "SFU1605 nut", bored(box((40, 80), (-20, 20), (60, 118)), (60, -21, 75), "y", 42, 9), table)
    add(doc, "Spindle", rod((0, 0, 200), "z", 150, 30), head)
    doc.recompute()
    found = engine.propose(doc)
    axis = found.axes["Y"]
    said = {m.code: m.fields for m in axis.evidence}
    assert abs(axis.u[1]) == 1 and said["propose-evidence-screw"]["part"] == "SFU1605-650"
    assert said["propose-travel-part"]["part"] == "HGR20-600"
    assert np.ptp(axis.travel) == pytest.approx(600 - 80)
