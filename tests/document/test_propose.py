# SPDX-License-Identifier: LGPL-2.1-or-later
# ruff: noqa: E501
"""Machines of unlike kinds and hostile shapes: the right chain, directions, travels, in time, and never too sure."""

from __future__ import annotations

import time

import FreeCAD as App
import numpy as np
import Part
import pytest

from sensworkbench.core.workspace import Cancelled
from sensworkbench.document.propose import engine, words

from .machines import plain

MACHINES = {
    "wooden router of four documents": lambda doc, folder: plain.wooden_router(doc, folder),
    "the same, named A to D": lambda doc, folder: plain.wooden_router(doc, folder, ("PartA", "PartB", "PartC", "PartD")),
    "knee mill with dovetails, German": lambda doc, folder: plain.mill_tree(doc),
    "knee mill with dovetails, English": lambda doc, folder: plain.mill_tree(doc, False),
    "lathe of links": lambda doc, folder: plain.lathe(doc),
    "lathe of splines": lambda doc, folder: plain.lathe(doc, spline=True),
    "bridge of profiles on wheels": lambda doc, folder: plain.extrusions(doc),
    "bridge with parts as meshes": lambda doc, folder: plain.extrusions(doc, mesh=True),
    "bridge with a thousand screws": lambda doc, folder: plain.extrusions(doc, 1000),
    "printer whose bed moves": lambda doc, folder: plain.printer(doc),
    "C-frame, one compound of fusions": lambda doc, folder: plain.c_frame(doc),
    "C-frame with an offset curve and a ball": lambda doc, folder: plain.c_frame(doc, True),
    "portal mill, French": lambda doc, folder: plain.portal(doc, "fr"),
    "portal mill, Korean": lambda doc, folder: plain.portal(doc, "ko"),
    "portal mill, Chinese": lambda doc, folder: plain.portal(doc, "zh"),
    "portal mill, Italian": lambda doc, folder: plain.portal(doc, "it"),
    "portal mill, Spanish": lambda doc, folder: plain.portal(doc, "es"),
    "delta": lambda doc, folder: plain.delta(doc),
    "jointed arm": lambda doc, folder: plain.robot(doc),
}  # fmt: skip


@pytest.fixture
def build(doc, tmp_path):
    """Builds a machine in `doc`, and closes the documents that it needed."""
    before = set(App.listDocuments())

    def make(builder):
        made = builder(doc, tmp_path)
        return made[0] if isinstance(made, tuple) else made

    yield make
    for name in set(App.listDocuments()) - before:
        App.closeDocument(name)


@pytest.mark.parametrize("name", MACHINES)
def test_the_chain_of_a_machine_is_found(doc, build, name):
    truth = build(MACHINES[name])
    objects = [o.Name for o in doc.Objects]
    start = time.monotonic()
    found = engine.propose(doc)
    took = time.monotonic() - start
    assert took < (10 if len(objects) < 300 else 20)
    assert [o.Name for o in doc.Objects] == objects
    assert (found.kind, found.structure) == (truth.kind, truth.structure)
    assert found.complete == (truth.structure is not None)
    if truth.structure is None:
        assert found.remarks[0].code in ("propose-delta", "propose-robot") and not found.axes
        return
    assert sorted(found.axes) == sorted(truth.axes)
    for axis, u in truth.axes.items():
        assert abs(np.dot(found.axes[axis].u, u)) > 0.9999, axis
        assert 0.3 < found.axes[axis].confidence < 1 and found.axes[axis].evidence
    for body, labels in truth.bodies.items():
        got = {u.labels[-1] for u in found.bodies[body]}
        assert labels <= got, body
    for axis, length in truth.travel.items():
        if not name.startswith("C-frame"):
            assert np.ptp(found.axes[axis].travel) == pytest.approx(length, abs=0.5), axis
    units = [u.key for body in found.bodies.values() for u in body]
    assert len(units) == len(set(units))


def test_what_is_not_clear_is_never_called_sure(doc):
    """Blocks on blocks, with names that mislead: whatever is proposed stays below .8."""
    for label, at, size in (("X table", (0, 0, 0), (300, 300, 50)), ("Y table", (0, 0, 50), (200, 200, 50)),
                            ("Z plate", (0, 0, 100), (100, 100, 50)), ("base", (0, 0, 150), (90, 90, 20))):  # fmt: skip
        obj = doc.addObject("Part::Feature", "B")
        obj.Label, obj.Shape = label, Part.makeBox(*size, App.Vector(*at))
    found = engine.propose(doc)
    assert all(a.confidence <= 0.8 for a in found.axes.values())
    assert found.questions


@pytest.mark.parametrize("count", [0, 1])
def test_next_to_nothing_is_a_question_not_an_error(doc, count):
    for _ in range(count):
        doc.addObject("Part::Box", "Box")
    doc.recompute()
    found = engine.propose(doc)
    assert not found.complete and found.kind == "unknown" and found.questions[0].name == "parts"


def test_cancel_stops_at_once(doc):
    plain.extrusions(doc)
    with pytest.raises(Cancelled):
        engine.propose(doc, progress=lambda done, total: done > 3)


# -- the person's word -----------------------------------------------------------------------------------------------
def test_an_answer_is_weighed_at_once_and_never_overruled(doc):
    plain.portal(doc, "fr")
    found = engine.propose(doc)
    start = time.monotonic()
    bridge = next(u for u in found.bodies["F"] if u.labels[-1] == "e")
    told = engine.again(found, {"tool": next(u for u in found.bodies["X"] if u.labels[-1] == "d")})
    assert told.structure == "ZYFX" and time.monotonic() - start < 1
    told = engine.again(found, {"bed": bridge, "travel:X": (-10, 20), "direction:Z": (0, 0, 1)})
    assert bridge in told.bodies["F"] and told.axes["X"].travel == (-10.0, 20.0)
    told = engine.again(found, {"kind": "serial", "direction:Y": (1, 0, 0)})
    assert abs(told.axes["Y"].u[0]) == 1 and not any(q.name == "direction:Y" for q in told.questions)


def test_parts_that_a_person_gives_to_an_axis_are_that_axis(doc):
    for label, at, size in (("a", (0, 0, 0), (900, 600, 100)), ("b", (100, 50, 100), (200, 500, 80)),
                            ("c", (120, 200, 180), (160, 160, 80)), ("d", (150, 220, 260), (100, 100, 300))):  # fmt: skip
        obj = doc.addObject("Part::Feature", "B")
        obj.Label, obj.Shape = label, Part.makeBox(*size, App.Vector(*at))
    found = engine.propose(doc)
    assert not found.complete
    answers = {"bed": "a"}
    for axis, label in (("X", "b"), ("Y", "c"), ("Z", "d")):
        answers[f"body:{axis}"] = [label]
        found = engine.again(found, answers)
        assert [u.label for u in found.bodies[axis]] == [label]
        assert not any(q.name in answers for q in found.questions)
    assert found.complete and [u.label for u in found.bodies["F"]] == ["a"]


# -- names -----------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("label, role, kind, letter, length", [
    ("X-Achse_Schlitten", "carriage", "", "X", None), ("Kreuzschlitten", "saddle", "", "", None), ("Fräskopf", "quill", "", "", None),
    ("HGR20-600", "", "rail", "", 600), ("HGH20CA001", "", "block", "", None), ("MGN12H", "", "block", "", None), ("MGN12R-300", "", "rail", "", 300),
    ("SBR16UU", "", "block", "", None), ("LM8UU", "", "block", "", None), ("SFU1605-700", "", "screw", "", 700), ("BK12", "", "support", "", None),
    ("2040 V-Slot 500", "", "extrusion", "", 500), ("M5x20", "", "fastener", "", None), ("주축", "tool", "", "", None), ("X축", "", "", "X", None),
    ("立柱", "column", "", "", None), ("工作台", "table", "", "", None), ("Portique", "gantry", "", "", None), ("Bâti", "base", "", "", None),
    ("Basamento", "base", "", "", None), ("Bancada", "bed", "", "", None), ("Husillo de bolas", "", "screw", "", None), ("gongzuotai", "table", "", "", None),
    ("y_axis_assembly_001", "", "", "Y", None), ("ベッド", "bed", "", "", None), ("Handwheel", "", "drive", "", None), ("Bracket", "", "", "", None),
])  # fmt: skip
def test_names_of_parts(label, role, kind, letter, length):
    got = (words.role(label), words.hardware(label), words.letter(label), words.length(label))
    assert got == (role, kind, letter, length)


def test_time_that_a_caller_takes_between_steps_is_not_taken_from_the_look(doc, tmp_path):
    import time

    plain.wooden_router(doc, tmp_path)
    whole = engine.propose(doc)
    waits = []

    def wait(*_):
        waits.append(time.sleep(0.6 if len(waits) < 4 else 0.0))

    found = engine.propose(doc, progress=wait, early=lambda make: time.sleep(1.0), seconds=1.0)
    assert sum(w is None for w in waits) > 3 and found.seconds < 4 * 0.6
    assert (found.structure, found.document.sampled) == (whole.structure, 0) == ("FYXZ", 0)
    assert [found.axes[a].confidence for a in "XYZ"] == [whole.axes[a].confidence for a in "XYZ"]
