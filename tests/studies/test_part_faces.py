# SPDX-License-Identifier: LGPL-2.1-or-later
"""Features from faces: a program, the faces of a block, and closed forms of what squareness and scales make of them."""

from __future__ import annotations

import numpy as np
import pytest

from sensworkbench.core.contact import Cutter, Face
from sensworkbench.core.elements import CYLINDER, PLANE
from sensworkbench.core.refusal import Refused
from sensworkbench.core.workspace import Cancelled
from sensworkbench.formats import part_files

from .test_part import machine

UP = np.array([0.0, 0.0, 1.0])
PROGRAM = b"""G21 G90 G17 G54 F500
T1 M6
G0 X0 Y0 Z50
G0 X-56 Y-46
G0 Z-10
G1 Y46
G1 X56
G1 Y-46
G1 X-56
G0 Z50
G0 X34 Y0
G0 Z-10
G3 I-34
G0 Z-5
G3 I-34
G0 Z50
T2 M6
G0 X-20 Y30
G81 X-20 Y30 Z-8 R2
X20 Y-30
G80
"""


def inside(low, high):
    return lambda p: ((p >= np.array(low) - 1e-6) & (p <= np.array(high) + 1e-6)).all(axis=1)


def wall(name, normal, low, high):
    point = np.where(np.array(normal) > 0, high, low).astype(float)
    box = np.array([low, high], dtype=float)
    return Face(name, PLANE, point, np.array(normal, dtype=float), inside=inside(low, high), corners=box,
                area=float(np.prod([b - a for a, b in zip(low, high) if b > a])))  # fmt: skip


def round_(name, centre, radius, low, high):
    x, y = centre
    box = np.array([[x - radius, y - radius, low], [x + radius, y + radius, high]])
    return Face(
        name, CYLINDER, np.array([x, y, 0.0]), UP, radius, -1, inside(*box), box, 2 * np.pi * radius * (high - low)
    )


FACES = (
    wall("left", (-1, 0, 0), (-50, -40, -20), (-50, 40, 0)),
    wall("right", (1, 0, 0), (50, -40, -20), (50, 40, 0)),
    wall("back", (0, 1, 0), (-50, 40, -20), (50, 40, 0)),
    wall("far away", (0, 1, 0), (-50, 60, -20), (50, 60, 0)),
    round_("bore", (0, 0), 40.0, -10.0, 0.0),
    round_("hole 1", (-20, 30), 3.0, -8.0, 0.0),
    round_("hole 2", (20, -30), 3.0, -8.0, 0.0),
)
CUTTERS = {1: Cutter(6.0), 2: Cutter(3.0, drill=True)}


def job(model, **more):
    given = part_files.Given(PROGRAM, (0.0, 0.0, 0.0), {}, FACES, CUTTERS)
    return part_files.read(model, "block.nc", part_files.Options(**more), given)


def test_each_point_is_the_point_of_contact_of_its_face():
    made = job(machine(C0Y=20))
    assert [f.name for f in made.faced.faces] == ["bore", "back", "left", "right", "hole 1", "hole 2"]
    path = made.path
    from sensworkbench.studies.part import nominal_points

    left = path.labels["left"]
    assert np.unique(path.normal[left], axis=0).tolist() == [[-1, 0, 0]]
    assert nominal_points(made.machine, path, left)[:, 0] == pytest.approx(-50 * np.ones(len(left)))
    bore = nominal_points(made.machine, path, path.labels["bore"])
    assert np.hypot(*bore.T[:2]) == pytest.approx(40 * np.ones(len(bore)), abs=1e-9)
    assert made.faced.axial == {"hole 1", "hole 2"}


def test_squareness_shows_in_walls_and_bore_by_closed_forms(tmp_path):
    """The tool is carried along the leaning axis as it is: a bore is out of round by the circle of its middle."""
    phi = 20e-6
    text = ('{"format": "sens-features", "version": 1, "features": [{"name": "round", "of": "bore"},'
            '{"name": "square", "of": "right", "kind": "perpendicularity", "datum": "back"}]}')  # fmt: skip
    (tmp_path / "f.json").write_text(text, encoding="utf-8")
    bore, walls = part_files.judged(job(machine(C0Y=20), features=str(tmp_path / "f.json"))).features
    assert bore.value == pytest.approx(34 * phi, rel=1e-6) and bore.feature.kind.name == "cylindricity"
    assert walls.value == pytest.approx(80 * phi, rel=1e-6)  # the wall is 80 long


def test_a_scale_changes_the_distance_of_the_holes_of_a_pattern():
    scale = 30e-6
    found = {
        f.feature.name: f for f in part_files.judged(job(machine(EXX=([-300, 300], [0, 300 * scale / 1e-3])))).features
    }
    length = np.hypot(40, 60)
    assert found["hole 2 to hole 1, distance"].value == pytest.approx(scale * 40 * 40 / length, rel=1e-6)
    assert found["hole 2 to hole 1, position"].value == pytest.approx(2 * scale * 40, rel=1e-6)


def test_features_of_a_file_name_faces(tmp_path):
    text = ('{"format": "sens-features", "version": 1, "features": ['
            '{"name": "the bore", "of": "bore", "kind": "cylindricity"},'
            '{"name": "walls", "of": "right", "kind": "parallelism", "datum": "left", "limit_um": 5}]}')  # fmt: skip
    (tmp_path / "f.json").write_text(text, encoding="utf-8")
    found = part_files.judged(job(machine(C0Y=20), features=str(tmp_path / "f.json"))).features
    assert [f.feature.name for f in found] == ["the bore", "walls"]
    (tmp_path / "f.json").write_text(text.replace('"of": "right"', '"of": "far away"'), encoding="utf-8")
    with pytest.raises(Refused) as refused:
        part_files.judged(job(machine(C0Y=20), features=str(tmp_path / "f.json")))
    assert refused.value.code == "feature-without-points"


def test_the_correction_is_judged_on_the_same_faces(tmp_path):
    made = job(machine(C0Y=20), correct=str(tmp_path / "out.nc"))
    _, said = part_files.corrected(made)
    assert said["features"] and all(abs(f["after_um"]) < 0.3 for f in said["features"])
    assert max(abs(f["before_um"]) for f in said["features"]) > 0.7


def test_a_search_can_be_cancelled():
    given = part_files.Given(PROGRAM, (0.0, 0.0, 0.0), {}, FACES, CUTTERS)
    with pytest.raises(Cancelled):
        part_files.read(machine(C0Y=20), "block.nc", given=given, progress=lambda part: False)


def test_a_path_that_cuts_no_face_says_so():
    given = part_files.Given(PROGRAM, (0.0, 0.0, 0.0), {}, FACES[3:4], CUTTERS)
    made = part_files.read(machine(C0Y=20), "block.nc", given=given)
    assert made.faced.faces == () and "part-faces-none" in [m.code for m in made.source["remarks"]]


def test_the_wall_of_a_drilled_hole_moves_as_its_axis():
    """EXX = 30e-6 x: hole 1 at x = -20 moves by -0.6 um; its wall at +x looks to -x, so material is left there."""
    from sensworkbench.studies.part_shape import face_fields

    made = job(machine(EXX=([-300, 300], [0, 9.0])))
    fields = face_fields(part_files.judged(made), [f.name for f in made.faced.faces])
    hole, right = fields["hole 1"], fields["right"]
    assert hole.axial and hole.value == pytest.approx(np.full(len(hole.value), 0.6e-3))
    assert hole.wall(np.array([[-17.0, 30, -4], [-23, 30, -4], [-20, 33, -4]])) == pytest.approx([0.6e-3, -0.6e-3, 0])
    assert right.signed and right.value == pytest.approx(np.full(len(right.value), 30e-6 * 56))  # the tool's middle
