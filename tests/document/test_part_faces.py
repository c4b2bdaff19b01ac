# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job of FreeCAD's CAM workbench: the faces of its model that the path cuts become features."""

from __future__ import annotations

import json

import FreeCAD as App
import numpy as np
import Part
import pytest

from sensworkbench.cli.program import main
from sensworkbench.core.refusal import Refused
from sensworkbench.document import cam_path, examples, extract, part_faces
from sensworkbench.formats import part_files
from sensworkbench.studies.part import nominal_points

from .cam_jobs import HOLES, make_job

AT = (-60.0, -45.0, 98.0)  # on the workpiece of the example
TOP = AT[2] + 50


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A folder with a document that holds the example and a job."""
    made = tmp_path_factory.mktemp("job")
    document = App.newDocument("CamJob")
    examples.make_example(document, "XYFZ")
    make_job(document, AT)
    document.recompute()
    document.saveAs(str(made / "job.FCStd"))
    App.closeDocument(document.Name)
    return made


@pytest.fixture
def document(folder):
    found = App.openDocument(str(folder / "job.FCStd"))
    name = found.Name
    yield found
    if name in App.listDocuments():
        App.closeDocument(name)


def job_of(document, **more):
    machine = extract.core_machine(next(o for o in document.Objects if o.Label == "Vertical machining centre"))
    return part_files.read(
        machine, "job.FCStd", part_files.Options(**more), cam_path.given(cam_path.of_document(document), machine)
    )


def named(document, place, radius=None):
    """The name of the model's face through a place, of a radius where one is given."""
    found = cam_path.of_document(document)
    for name, face in part_faces.named_faces(found.models):
        if radius is not None and abs(getattr(face.Surface, "Radius", -1) - radius) > 1e-6:
            continue
        if face.distToShape(Part.Vertex(*place))[0] < 1e-6:
            return name
    raise AssertionError(place)


def test_the_points_lie_on_the_faces_that_the_tools_make(document):
    made = job_of(document)
    path, names = made.path, [f.name for f in made.faced.faces]
    shapes = dict(part_faces.named_faces(cam_path.of_document(document).models))
    for name in names:
        if name in made.faced.axial:
            continue
        points = nominal_points(made.machine, path, path.labels[name])
        assert max(shapes[name].distToShape(Part.Vertex(*p))[0] for p in points[:: max(1, len(points) // 20)]) < 1e-6
    top = named(document, (AT[0] + 60, AT[1] + 45, TOP))
    bore = named(document, (AT[0] + 38 + 16, AT[1] + 45, TOP - 7), 16)
    left = named(document, (AT[0], AT[1] + 45, TOP - 12))
    faced = len(document.getObject("MillFace").Path.Commands) > 5  # FreeCAD 1.0 mills no face without a window
    assert {bore, left} <= set(names) and (top in names) == faced
    assert np.unique(np.round(path.normal[path.labels[left]], 9), axis=0).tolist() == [[-1, 0, 0]]
    holes = [named(document, (AT[0] + x + 4, AT[1] + y, TOP - 10), 4) for x, y in HOLES]
    assert made.faced.axial == set(holes)
    assert not faced or len(path.labels[top]) > 300
    assert len(path.labels[bore]) > 60


def test_features_and_their_report_come_without_a_table(folder, document, tmp_path):
    App.closeDocument(document.Name)
    assert main(["part", str(folder / "job.FCStd"), "--out", str(tmp_path / "out"), "--limit", "20"]) == 0
    data = json.loads((tmp_path / "out" / "part.json").read_text(encoding="utf-8"))
    kinds = {f["kind"] for f in data["features"]}
    assert {"flatness", "cylindricity", "parallelism", "perpendicularity", "position", "distance"} <= kinds
    assert data["outside_travel"] == [] and all(f["limit_um"] == 20 for f in data["features"])
    for f in data["features"]:
        assert sum(f["shares"].values()) == pytest.approx(1, abs=1e-9) or not f["shares"]


def test_another_solid_may_be_named_and_an_unknown_one_is_refused(document):
    found = cam_path.of_document(document, "Plate")
    assert [m.Label for m in found.models] == ["Plate"] and len(found.faces) > 20
    with pytest.raises(Refused) as refused:
        cam_path.of_document(document, "No such part")
    assert refused.value.code == "part-model-unknown" and "Plate" in refused.value.fields["known"]


def test_tools_are_known_by_their_shape():
    class Bit:
        pass

    def bit(**values):
        made = Bit()
        for k, v in values.items():
            setattr(made, k, v)
        return made

    known = [
        ({"ShapeName": "endmill"}, (0.0, False)),
        ({"ShapeType": "ballend"}, (5.0, False)),
        ({"BitShape": "/x/Shape/drill.fcstd"}, (0.0, True)),
        ({"ShapeName": "bullnose", "FlatRadius": 3.0}, (2.0, False)),
        ({"ShapeType": "Bullnose", "CornerRadius": 1.5}, (1.5, False)),
    ]
    for values, (corner, drill) in known:
        found = part_faces.cutter(bit(**values), 5.0)
        assert (found.corner, found.drill) == (corner, drill), values
    assert part_faces.cutter(bit(ShapeName="v-bit"), 5.0) is None and part_faces.cutter(bit(), 0.0) is None
