# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD CAM machine files: both spellings of a joint, millimetres throughout, nothing else touched."""

from __future__ import annotations

import json

import pytest

from sensworkbench.core.errors import AXES
from sensworkbench.core.joints import linear
from sensworkbench.core.machine import Machine
from sensworkbench.core.refusal import Refused
from sensworkbench.formats.exchange.convert import convert, import_machine
from sensworkbench.formats.exchange.known import fcm
from sensworkbench.messages import Message


def axis(role, direction, limits=(0, 500), **more):
    return {
        "type": "linear",
        "role": role,
        "parent": None,
        "sequence": 0,
        "joint": {"origin": [0, 0, 0], "axis": direction},
        "limits": {"min": limits[0], "max": limits[1]},
        "max_velocity": 18000,
        **more,
    }


def mill(**more):
    """The layout of FreeCAD's own example of a vertical machining centre with a rotary table."""
    rotary = {"type": "rotary", "role": "table_rotary", "joint": {"origin": [0, 0, 0], "axis": [0, 0, 1]}}
    axes = {
        "X": axis("table_linear", [1, 0, 0], (0, 510)),
        "Y": axis("table_linear", [0, 1, 0], (0, 360)),
        "Z": axis("head_linear", [0, 0, 1], (0, 410)),
        "A": rotary | {"parent": None, "limits": {"min": 0, "max": 360}},
    }
    machine = {"axes": axes, "name": "mill", "manufacturer": "", "units": "metric", "toolheads": []}
    return {"freecad_version": "1.2.0", "machine": machine | more, "output": {"units": "metric"}, "version": 1}


def read(data, **kwargs):
    return fcm.loads(json.dumps(data), **kwargs)


def test_roles_make_the_chains_and_limits_the_travel():
    machine, remarks = read(mill())
    assert set(machine.workpiece_chain) == {"X", "Y"} and machine.tool_chain == ("Z",)
    assert machine.axes["X"].travel == (0, 510) and machine.name == "mill"
    codes = {f.code for f in remarks}
    assert {"fcm-axis-rotary", "fcm-chain-order", "fcm-tool-point", "fcm-reference-points"} <= codes


def test_a_parent_carries_its_child():
    data = mill()
    data["machine"]["axes"]["X"]["parent"] = "Y"
    machine, remarks = read(data)
    assert machine.workpiece_chain == ("Y", "X") and machine.structure == "XYFZ"
    assert "fcm-chain-order" not in {f.code for f in remarks}
    data["machine"]["axes"]["X"]["parent"] = None
    data["machine"]["axes"]["X"]["sequence"] = 1
    assert read(data)[0].workpiece_chain == ("Y", "X")


@pytest.mark.parametrize(
    "joint",
    [
        {"origin": [10, 20, 30], "axis": [0, 0, 2]},
        [[10, 20, 30], [0, 0, 1]],
        [[0, 0, 1], [10, 20, 30]],
    ],
)
def test_both_spellings_and_orders_of_a_joint(joint):
    data = mill()
    data["machine"]["axes"]["Z"]["joint"] = joint
    z = read(data)[0].axes["Z"]
    assert z.reference == (10, 20, 30) and z.direction == (0, 0, 1)


def test_a_file_in_inches_still_holds_millimetres():
    """CAM's editor divides by 25.4 where it shows a limit and multiplies where one is typed: the file is metric."""
    data = mill(units="imperial")
    data["machine"]["axes"]["X"]["joint"]["origin"] = [1, 2, 3]
    machine, remarks = read(data)
    assert machine.axes["X"].travel == (0, 510) and machine.axes["X"].reference == (1, 2, 3)
    assert "fcm-imperial" in {f.code for f in remarks} and "fcm-imperial" not in {f.code for f in read(mill())[1]}
    back = json.loads(fcm.dumps(machine, base=json.dumps(data)))["machine"]
    assert back["units"] == "imperial"
    assert back["axes"]["X"]["limits"]["max"] == 510 and back["axes"]["X"]["joint"]["origin"] == [1, 2, 3]


def test_what_the_file_leaves_out_is_what_cam_takes():
    data = mill()
    for key in ("limits", "role", "parent", "sequence", "type"):
        data["machine"]["axes"]["X"].pop(key)
    machine, _ = read(data)
    assert machine.axes["X"].travel == (0, 1000) and "X" in machine.workpiece_chain


def test_an_axis_that_a_rotary_axis_carries_stands_outside_what_carries_that():
    data = mill()
    data["machine"]["axes"]["A"]["parent"] = "Y"
    data["machine"]["axes"]["X"]["parent"] = "A"
    machine, remarks = read(data)
    assert machine.workpiece_chain == ("Y", "X")
    assert "fcm-chain-order" not in {f.code for f in remarks}


def test_a_base_frame_that_stands_elsewhere_is_said():
    frame = {"base_frame": {"origin": [0, 0, 800], "orientation_quaternion": [0, 0, 0, 1]}}
    assert "fcm-base-frame" in {f.code for f in read(mill(kinematics=frame))[1]}
    frame["base_frame"]["origin"] = [0, 0, 0]
    assert "fcm-base-frame" not in {f.code for f in read(mill(kinematics=frame))[1]}


@pytest.mark.parametrize("chains", [((), ("X", "Y", "Z")), (("Y", "X"), ("Z",)), (("X",), ("Y", "Z"))])
def test_a_machine_that_is_written_and_read_again_keeps_its_kinematics(tmp_path, chains):
    axes = {
        k: linear(k, d, r, t)
        for k, d, r, t in (
            ("X", (1, 0, 0), (1.5, 2, 3), (-100, 250)),
            ("Y", (0, -1, 0), (4, 5, 6), (0, 300)),
            ("Z", (0, 0, 1), (7, 8, 9), (-400, -10)),
        )
    }
    machine = Machine("m", *chains, axes, tool_point=(1, 2, 3))
    written = convert(machine, "fcm", tmp_path)
    assert Message("note-not-held", what=Message("held-not-points")) in written.notes
    again, remarks = import_machine(tmp_path / "machine.fcm", tool_point=(1, 2, 3))
    assert again == machine
    assert not remarks


def test_writing_into_an_existing_file_changes_its_linear_axes_only():
    data = mill()
    data["postprocessor"] = {"file_name": "fanuc"}
    machine, _ = read(data)
    back = json.loads(fcm.dumps(machine, base=json.dumps(data)))
    assert {k: back[k] for k in ("postprocessor", "output", "version", "freecad_version")} == {
        k: data[k] for k in ("postprocessor", "output", "version", "freecad_version")
    }
    assert back["machine"]["axes"]["A"] == data["machine"]["axes"]["A"]
    assert back["machine"]["axes"]["X"]["max_velocity"] == 18000
    assert set(back["machine"]["axes"]) == {*AXES, "A"}


@pytest.mark.parametrize(
    ("change", "what"),
    [
        (lambda d: d.pop("machine"), "no axes"),
        (lambda d: d.update(version=2), "version"),
        (lambda d: d["machine"].update(units="furlongs"), "furlongs"),
        (lambda d: d["machine"]["axes"].pop("Y"), "axis Y is missing"),
        (lambda d: d["machine"]["axes"]["X"].update(role="table_rotary"), "role"),
        (lambda d: d["machine"]["axes"]["X"].pop("joint"), "no joint"),
        (lambda d: d["machine"]["axes"]["X"]["joint"].update(axis=[0, 0, 0]), "no direction"),
        (lambda d: d["machine"]["axes"]["X"]["limits"].update(max=-1), "no length"),
        (lambda d: d["machine"]["axes"]["X"]["limits"].update(max="far"), "line 1"),
    ],
)
def test_a_file_that_is_no_three_axis_machine_is_refused(change, what):
    data = mill()
    change(data)
    with pytest.raises(Refused, match=what):
        read(data)
