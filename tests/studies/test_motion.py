# SPDX-License-Identifier: LGPL-2.1-or-later
"""How an error moves the machine, for showing: bodies, sides and the tool's answer, worked by hand."""

from __future__ import annotations

import json

import numpy as np
import pytest

from sensworkbench.core.refusal import Refused
from sensworkbench.formats import machine_json
from sensworkbench.studies.motion import carried, motion, movable
from tests.formats.support import ROOT, golden


@pytest.fixture
def mill():
    """XYFZ: table X on saddle Y, head Z."""
    return machine_json.load(ROOT / "resources" / "examples" / "vertical_machining_centre.json")


def test_a_body_moves_with_all_that_it_carries(mill):
    assert carried(mill, "Y") == ("Y", "X", "W") and carried(mill, "X") == ("X", "W")
    assert carried(mill, "Z") == ("Z", "T") and carried(mill, "T") == ("T",)


def test_roll_over_a_lever_arm_is_answered_by_the_cross_product(mill):
    """EAZ: r from the reference (215, 430, 700) to the tool point (0, 0, 320); (e, 0, 0) x r = (0, -e rz, e ry)."""
    found = motion(mill, "EAZ", [0, 0, 0])
    value = 20e-6
    assert found.value == pytest.approx(value) and found.turn == pytest.approx([value, 0, 0])
    assert found.answer == pytest.approx([0, -value * (320 - 700), value * (0 - 430)])
    assert not found.shift.any() and not found.slide.any()


def test_a_table_moves_against_the_sign_of_its_error(mill):
    found = motion(mill, "EZX", [0, 0, 0])
    assert found.shift == pytest.approx([0, 0, -5e-3]) and found.answer == pytest.approx([0, 0, 5e-3])


def test_squareness_is_shown_along_the_travel(mill):
    """A0Z: Z moves up by 200 mm at the end, and the tool by A0Z x (0, 0, 200) along -y."""
    found = motion(mill, "A0Z", [0, 0, 50])
    assert found.slide == pytest.approx([0, 0, 200])
    assert found.shift == pytest.approx([0, -200 * 20e-6, 0]) and found.answer == pytest.approx(found.shift)


def test_fitted_functions_and_effects_have_their_own_sizes():
    parameters = {"coefficient": {"value": 2.0, "unit": "urad/K"}, "extent": {"value": [-6, 9], "unit": "urad"}}
    effect = {"name": "bend", "component": "EAZ", "driver": "temp_column", "shape": "linear", "parameters": parameters}
    fitted = {"EXX": {"basis": "legendre", "domain": [-300, 300], "coefficients": [0, 7], "unit": "um"}}
    model = machine_json.loads(json.dumps(golden(fitted=fitted, effects=[effect | {"enabled": True}])), "m")
    sizes = movable(model)
    assert sizes["EXX"] == pytest.approx(7e-3) and sizes["bend"] == pytest.approx(9e-6)
    assert motion(model, "bend", np.zeros(3)).symbol == "EAZ"
    with pytest.raises(Refused):
        motion(model, "EXW", np.zeros(3))


def along(model, q, **columns):
    from sensworkbench.closedloop.readings import Readings
    from sensworkbench.studies.part_path import of_points

    q = np.asarray(q, dtype=float)
    place = dict(zip("xyz", q.T)) | {k: np.asarray(v, dtype=float) for k, v in columns.items()}
    return of_points(model, Readings.from_vectors(q, np.full((len(q), 3), np.nan), place), None, {})


def test_a_fitted_error_goes_along_a_path_as_its_function():
    """EXX = 7 um q/300: its value and the tool's answer follow the position of X; moments are equal in time."""
    from sensworkbench.studies.motion import course

    fitted = {"EXX": {"basis": "legendre", "domain": [-300, 300], "coefficients": [0, 7], "unit": "um"}}
    model = machine_json.loads(json.dumps(golden(fitted=fitted)), "m")
    x = np.concatenate([np.linspace(-300, 0, 11), np.linspace(0, 300, 301)[1:]])
    t = np.concatenate([np.linspace(0, 50, 11), np.linspace(50, 100, 301)[1:]])
    found = course(model, "EXX", along(model, np.stack([x, 0 * x, 0 * x], 1), t=t), 21)
    assert found.t == pytest.approx(np.linspace(0, 100, 21), abs=0.2)
    assert found.value == pytest.approx(7e-3 * found.q[:, 0] / 300)
    size = 7e-3 * np.abs(found.q[:, 0]) / 300
    assert np.linalg.norm(found.answer, axis=1) == pytest.approx(size, abs=1e-12)
    assert np.ptp(found.place[:, 0]) == pytest.approx(600)
    with pytest.raises(Refused) as refused:
        course(model, "EAZ", along(model, [[0, 0, 0.0], [1, 0, 0]]), 5)
    assert refused.value.code == "motion-no-course"


def test_a_traced_effect_goes_over_time_as_its_driver():
    parameters = {"coefficient": {"value": 2.0, "unit": "urad/K"}, "extent": {"value": [-6, 9], "unit": "urad"}}
    effect = {"name": "bend", "component": "EAZ", "driver": "temp_column", "shape": "linear", "parameters": parameters,
              "enabled": True}  # fmt: skip
    from sensworkbench.studies.motion import course

    model = machine_json.loads(json.dumps(golden(effects=[effect])), "m")
    t = np.linspace(0, 3600, 61)
    path = along(model, np.zeros((61, 3)), t=t, temp_column=20 + t / 1200)
    found = course(model, "bend", path, 13)
    assert np.diff(found.value) == pytest.approx(np.full(12, 2e-6 * 3 / 12), rel=1e-6)
