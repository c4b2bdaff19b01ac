# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a proposal becomes: a machine that moves within the travel that was found, and the files of the verb."""

from __future__ import annotations

import hashlib
import json

import FreeCAD as App
import numpy as np
import pytest

from sensworkbench.cli.verbs import propose as verb
from sensworkbench.core.refusal import Refused
from sensworkbench.document import jog, results, tree
from sensworkbench.document.propose import building, engine, headless
from sensworkbench.formats import machine_json

from .blocks import close
from .machines import plain


@pytest.mark.parametrize("name", ["portal", "lathe", "c_frame", "extrusions", "mill_tree", "printer"])
def test_the_machine_of_a_proposal_moves_and_computes(doc, name):
    truth = getattr(plain, name)(doc)
    found = engine.propose(doc)
    machine = building.build(doc, found)
    assert machine.Problem == "" and machine.Structure == truth.structure
    for axis, u in truth.axes.items():
        obj = tree.axis_of(machine, axis)
        assert abs(np.dot(obj.Direction, u)) > 0.9999999
        low, high = found.axes[axis].travel
        assert (obj.TravelLower.Value, obj.TravelUpper.Value) == (pytest.approx(low), pytest.approx(high))
    moving = {axis: tree.parts_of(machine, axis)[0] for axis in truth.axes}
    before = {axis: where.placement.Base for axis, where in moving.items()}
    first = (list(machine.ToolChain) or list(machine.WorkpieceChain))[0]
    step = 0.5 * found.axes[first].travel[1]
    jog.jog(machine, {first: step})
    sense = 1.0 if first in machine.ToolChain else -1.0
    u = tree.axis_of(machine, first).Direction
    assert close(moving[first].placement.Base - before[first], u * (sense * step), 1e-6)
    with pytest.raises(Refused):
        jog.jog(machine, {first: found.axes[first].travel[1] + 1})
    if len(truth.axes) == 3:
        assert max(results.compute(machine).Total) > 0.05


def test_a_proposal_without_axes_makes_nothing(doc):
    plain.robot(doc)
    before = [o.Name for o in doc.Objects]
    with pytest.raises(Refused) as refused:
        building.build(doc, engine.propose(doc))
    assert refused.value.code == "propose-no-machine" and [o.Name for o in doc.Objects] == before


@pytest.fixture
def saved(tmp_path):
    def save(builder):
        doc = App.newDocument("SensTestSource")
        builder(doc)
        path = tmp_path / "source.FCStd"
        doc.saveAs(str(path))
        App.closeDocument(doc.Name)
        return path

    return save


def test_the_verb_writes_the_proposal_and_the_machine_and_leaves_the_document(saved, tmp_path):
    path = saved(plain.portal)
    before = hashlib.sha256(path.read_bytes()).digest()
    written = headless.propose(path, tmp_path / "out")
    assert {p.name for p in written} >= {"proposal.json", "machine.json", "machine.FCStd"}
    assert hashlib.sha256(path.read_bytes()).digest() == before
    got = json.loads((tmp_path / "out" / "proposal.json").read_text(encoding="utf-8"))
    assert (got["format"], got["version"], got["complete"], got["kind"]) == ("sens-proposal", 1, True, "serial")
    assert got["structure"] == "XFYZ" and set(got["axes"]) == {"X", "Y", "Z"}
    for axis in got["axes"].values():
        assert axis["kind"] == "linear" and len(axis["direction"]) == 3 and len(axis["travel"]) == 2
        assert 0 <= axis["confidence"] <= 1 and all(isinstance(w, str) and w for w in axis["evidence"])
    assert "d" in got["bodies"]["X"] and got["questions"] == [] and got["seconds"] >= 0
    assert any("Plateau tournant" in text for text in got["remarks"])
    machine = machine_json.load(tmp_path / "out" / "machine.json")
    assert machine.workpiece_chain == ("X",) and machine.tool_chain == ("Y", "Z")
    copy = App.openDocument(str(tmp_path / "out" / "machine.FCStd"))
    assert tree.machine_of(copy).Problem == ""
    App.closeDocument(copy.Name)


def test_what_is_no_machine_is_written_too(saved, tmp_path):
    written = headless.propose(saved(plain.delta), tmp_path / "out")
    assert [p.name for p in written if p.suffix == ".json" and p.name != "manifest.json"] == ["proposal.json"]
    got = json.loads((tmp_path / "out" / "proposal.json").read_text(encoding="utf-8"))
    assert (got["complete"], got["kind"], got["structure"], got["axes"]) == (False, "parallel", None, {})
    assert "parallel machine" in got["remarks"][0] and got["questions"]


def test_answers_of_a_file_are_followed(saved, tmp_path):
    path = saved(plain.portal)
    answers = tmp_path / "answers.json"
    answers.write_text('{"travel:X": [-100, 50], "direction:Y": [0, 1, 0]}')
    headless.propose(path, tmp_path / "out", verb._answers(answers))
    got = json.loads((tmp_path / "out" / "proposal.json").read_text(encoding="utf-8"))
    assert got["axes"]["X"]["travel"] == [-100.0, 50.0] and "as you said" in got["axes"]["Y"]["evidence"]
    answers.write_text("[1]")
    with pytest.raises(Refused) as refused:
        verb._answers(answers)
    assert refused.value.code == "propose-answers-unread"


def test_a_file_that_is_no_document_is_refused(tmp_path):
    broken = tmp_path / "broken.FCStd"
    broken.write_bytes(b"no document")
    for path in (broken, tmp_path / "missing.FCStd"):
        with pytest.raises(Refused):
            headless.propose(path, tmp_path / "out")
    assert not (tmp_path / "out").exists()
