# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machine files against the class of FreeCAD's own CAM module: it loads what is written here, and the other way round.

FreeCAD up to 1.1 has no such class.  SENS_CAM names a folder that holds CAM's `Machine` package of a newer FreeCAD.
"""

from __future__ import annotations

import json
import os
import sys

import pytest

from sensworkbench.core.joints import linear
from sensworkbench.core.machine import Machine
from sensworkbench.formats.exchange.convert import convert, import_machine

pytestmark = pytest.mark.needs("cam-machines")
if os.environ.get("SENS_CAM"):
    sys.path.append(os.environ["SENS_CAM"])
try:
    from Machine.models import machine as CAM
except ImportError:
    CAM = None
CHAINS = [((), ("X", "Y", "Z")), (("Y", "X"), ("Z",)), (("X",), ("Y", "Z")), (("Z", "Y", "X"), ())]


def machine_of(chains, name="Mill, ü") -> Machine:
    axes = {
        k: linear(k, d, r, t)
        for k, d, r, t in (
            ("X", (0.8, 0.6, 0), (1.5, 2, 3), (-100, 250)),
            ("Y", (0.6, -0.8, 0), (4, -5, 6), (0, 300)),
            ("Z", (0, 0, 1), (0, 0, 1), (-400, -10)),  # a reference point as long as a direction
        )
    }
    return Machine(name, *chains, axes, tool_point=(1, 2, 3))


def loaded(path):
    return CAM.Machine.from_dict(json.loads(path.read_text(encoding="utf-8")))


@pytest.mark.parametrize("chains", CHAINS)
def test_cam_loads_the_axes_as_they_were_written(tmp_path, chains):
    known = machine_of(chains)
    convert(known, "fcm", tmp_path)
    found = loaded(tmp_path / "machine.fcm")
    assert found.name == known.name and found.configuration_units == "metric"
    assert found.machine_type == "xyz" and not found.rotary_axes and len(found.toolheads) == 1
    assert found.validate_kinematic_chain() == []
    for name, axis in known.axes.items():
        cams = found.linear_axes[name]
        assert tuple(cams.direction_vector) == pytest.approx(axis.direction)
        assert tuple(cams.joint_origin) == axis.reference
        assert (cams.min_limit, cams.max_limit) == axis.travel
        side = "head_linear" if name in known.tool_chain else "table_linear"
        assert cams.role.value == side
    for chain in chains:
        if chain:
            assert found.get_axis_chain(chain[-1]) == list(chain)


@pytest.mark.parametrize("chains", CHAINS)
def test_what_cam_saved_again_is_the_machine_that_was_written(tmp_path, chains):
    known = machine_of(chains)
    convert(known, "fcm", tmp_path)
    loaded(tmp_path / "machine.fcm").save(tmp_path / "cam.fcm")
    found, remarks = import_machine(tmp_path / "cam.fcm", tool_point=known.tool_point)
    assert (found.workpiece_chain, found.tool_chain) == (known.workpiece_chain, known.tool_chain)
    for name, axis in known.axes.items():
        assert found.axes[name].direction == pytest.approx(axis.direction)
        assert (found.axes[name].reference, found.axes[name].travel) == (axis.reference, axis.travel)
    assert remarks == ()


def test_a_machine_that_cam_made_is_read(tmp_path):
    made = CAM.Machine.create_3axis_config()
    made.linear_axes["X"].max_limit = 510
    made.save(tmp_path / "own.fcm")
    found, remarks = import_machine(tmp_path / "own.fcm")
    assert set(found.workpiece_chain) == {"X", "Y"} and found.tool_chain == ("Z",)
    assert found.axes["X"].travel == (0, 510) and found.axes["Y"].travel == (0, 1000)
    assert found.axes["Z"].direction == (0, 0, 1)
    assert {f.code for f in remarks} == {"fcm-chain-order", "fcm-tool-point", "fcm-reference-points"}


def test_nothing_that_is_written_is_ignored_by_cam(tmp_path):
    """Every key of our file stands, under its own name, in what CAM writes of the machine that it loaded."""
    convert(machine_of(CHAINS[1]), "fcm", tmp_path)
    written = json.loads((tmp_path / "machine.fcm").read_text(encoding="utf-8"))
    again = CAM.Machine.from_dict(written).to_dict()

    def keys(node, known, where=""):
        if isinstance(node, dict) and isinstance(known, dict):
            return [w for k, v in node.items() for w in
                    ([f"{where}.{k}"] if k not in known else keys(v, known[k], f"{where}.{k}"))]  # fmt: skip
        if isinstance(node, list) and isinstance(known, list) and len(node) == len(known):
            return [w for a, b in zip(node, known) for w in keys(a, b, where)]
        return []

    assert keys(written, again) == []
