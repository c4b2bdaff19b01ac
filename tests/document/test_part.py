# SPDX-License-Identifier: LGPL-2.1-or-later
"""`part` with a document: its Path objects are the program, and where the machine stands there too, the work offset."""

from __future__ import annotations

import json

import FreeCAD as App
import Path
import pytest

from sensworkbench.cli.program import main
from sensworkbench.core.refusal import Refused
from sensworkbench.document import cam_path, examples, extract
from sensworkbench.formats import machine_json

CIRCLE = [
    ("G0", {"X": 40.0, "Y": 0.0, "Z": 340.0}),
    ("G1", {"X": 40.0, "Y": 0.0, "Z": 310.0, "F": 5.0}),
    ("G3", {"X": 40.0, "Y": 0.0, "Z": 310.0, "I": -40.0, "J": 0.0, "F": 10.0}),
    ("G0", {"Z": 340.0}),
]


def path_object(document, name="Circle", commands=CIRCLE):
    made = document.addObject("Path::Feature", name)
    made.Path = Path.Path([Path.Command(*c) for c in commands])
    return made


@pytest.fixture
def document():
    doc = App.newDocument("Job")
    name = doc.Name
    yield doc
    if name in App.listDocuments():  # the command line may have opened, and closed, the same file
        App.closeDocument(name)


def test_path_objects_are_a_program_with_feeds_in_mm_per_minute(document):
    path_object(document)
    found = cam_path.of_document(document)
    assert found.operations == {"Circle": (1, 4)}
    assert "N2 G1 " in found.text and " F300" in found.text and " F600" in found.text


def test_a_document_without_a_path_is_refused(document):
    with pytest.raises(Refused) as refused:
        cam_path.of_document(document)
    assert refused.value.code == "cam-no-path"


def test_a_document_stands_in_for_the_machine_and_the_job(document, tmp_path):
    machine = examples.make_example(document, "XYFZ")
    path_object(document)
    document.recompute()
    core = extract.core_machine(machine)
    place = cam_path.offset(core)
    assert place == tuple(-v for v in core.tool_point)
    document.saveAs(str(tmp_path / "job.FCStd"))
    features = {"format": "sens-features", "version": 1,
                "features": [{"name": "c", "kind": "roundness", "blocks": [3, 3]}]}  # fmt: skip
    (tmp_path / "features.json").write_text(json.dumps(features), encoding="utf-8")
    words = ["--features", str(tmp_path / "features.json"), "--out", str(tmp_path / "out")]
    assert main(["part", str(tmp_path / "job.FCStd"), *words]) == 0
    data = json.loads((tmp_path / "out" / "part.json").read_text(encoding="utf-8"))
    assert data["features"][0]["points"] > 64 and data["outside_travel"] == []
    machine_json.save(core, tmp_path / "machine.json")
    both = ["part", str(tmp_path / "machine.json"), str(tmp_path / "job.FCStd"), *words]
    assert main(both) == 2  # where the work is on the machine, nobody has said
    offset = "G54=" + ",".join(f"{v:g}" for v in place)
    assert main([*both, "--work-offset", offset]) == 0
    again = json.loads((tmp_path / "out" / "part.json").read_text(encoding="utf-8"))
    assert again["features"][0]["value_um"] == pytest.approx(data["features"][0]["value_um"], rel=1e-6)
