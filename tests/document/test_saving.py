# SPDX-License-Identifier: LGPL-2.1-or-later
"""All that is stored comes back equal; older objects are brought up to date; tables and effects keep their meaning."""

from __future__ import annotations

import json

import FreeCAD as App
import numpy as np
import pytest

from sensworkbench.core import distributions, workspace
from sensworkbench.core import machine as core
from sensworkbench.core.joints import linear
from sensworkbench.core.objectives import Signed
from sensworkbench.core.refusal import Refused
from sensworkbench.document import base, extract, factory, jog, objects, results, tables, told, tree
from sensworkbench.formats.effects_json import of_parameters

from .blocks import REFERENCES, TOOL, close, golden_machine

EFFECT = of_parameters(
    "column tilts with temperature", "EAZ", "temp_column", "linear",
    {"coefficient": {"value": 2.5, "unit": "urad/K", "u": 0.1}, "extent": {"value": [-5.0, 12.5]}},
)  # fmt: skip
PROXIES = [c for c in vars(objects).values() if isinstance(c, type) and issubclass(c, base.SensObject) and c.kind]


def everything(doc):
    machine = golden_machine(doc, "YFXZ")
    factory.make_effect(machine, EFFECT)
    factory.set_tolerances(machine, {"EAX": distributions.Tolerance(-5e-6, 9e-6, "normal", 2e-6)}, {"EAX": "arcsec"})
    machine.Declared = {"EXX": "5"}
    machine.Extra = json.dumps({"x-maker": "someone"})
    results.compute(machine)
    jog.jog(machine, {"X": 12, "Z": -7})
    doc.recompute()
    return machine


def values(obj):
    """Every stored value of an object in a form that can be compared."""
    found = {}
    for name in obj.PropertiesList:
        if name in ("Proxy", "Group", "ExpressionEngine", "Visibility") or name.startswith("_"):
            continue
        value = getattr(obj, name)
        if name in ("Parts", "Bed"):
            value = [(o.Name, tuple(subs)) for o, subs in value]
        elif name.endswith("Source") or name == "ToolPoint":
            value = value and (value[0].Name, tuple(value[1]))
        elif name == "HomePlacements":
            value = [list(p.toMatrix().A) for p in value]
        elif isinstance(value, App.Vector):
            value = tuple(value)
        elif hasattr(value, "Value"):
            value = value.Value
        found[name] = value
    return found


def test_a_document_with_every_kind_of_object_comes_back_equal(doc, tmp_path):
    everything(doc)
    ours = {o.Name: base.kind_of(o) for o in doc.Objects if base.kind_of(o)}
    assert set(ours.values()) == {p.kind for p in PROXIES}
    before = {name: values(doc.getObject(name)) for name in ours}
    path = str(tmp_path / "all.FCStd")
    doc.saveCopy(path)
    again = App.openDocument(path)
    try:
        for name, kind in ours.items():
            obj = again.getObject(name)
            assert base.alive(obj) and obj.Proxy.kind == kind
            assert values(obj) == before[name], name
            assert "Touched" not in obj.State
        machine = tree.machine_of(again)
        modes = {n: machine.getEditorMode(n) for n in ("Structure", "Inputs", "Squareness")}
        assert modes == {"Structure": ["ReadOnly"], "Inputs": ["Hidden"], "Squareness": []}
        again.recompute()
        assert {name: values(again.getObject(name)) for name in ours} == before
        jog.home(machine)
        assert close(again.getObject("CarriageX").Placement.Base, REFERENCES["X"])
    finally:
        App.closeDocument(again.Name)


@pytest.mark.parametrize("proxy", PROXIES, ids=lambda p: p.kind)
def test_proxies_hold_nothing(proxy):
    empty = proxy.__new__(proxy)
    assert empty.dumps() is None and empty.__getstate__() is None
    assert empty.loads(None) is None and empty.__setstate__(None) is None
    assert not vars(empty)
    assert proxy.__module__ == "sensworkbench.document.objects"  # stored in users' files


def test_a_property_that_an_older_file_lacks_is_added_once(doc):
    machine = golden_machine(doc)
    machine.Objective = judged = told.objective_text(Signed(weights=(1, 2, 0)))
    machine.removeProperty("Order")
    machine.SchemaVersion = 0
    for _ in range(2):
        machine.Proxy.onDocumentRestored(machine)
        assert machine.Order == workspace.DEFAULT_ORDER
        assert machine.SchemaVersion == objects.MachineObject.schema
        assert machine.Objective == judged
        assert machine.getEditorMode("Structure") == ["ReadOnly"]


def test_numpy_values_are_stored_as_they_are(doc):
    found = factory.make_sensitivity(golden_machine(doc))
    base.put(found, "Total", np.array([0, 0.5, 1.0]))
    base.put(found, "MeanSquare", np.float64(0.25))
    base.put(found, "Stale", np.bool_(True))
    base.put(found, "Moments", np.array([1, 0, 2]))
    assert list(found.Total) == [0, 0.5, 1.0] and found.MeanSquare == 0.25 and found.Stale is True
    assert list(found.Moments) == [1, 0, 2]


def test_the_document_and_the_file_describe_the_same_machine(doc):
    machine = golden_machine(doc, "XYFZ")
    x, y, z = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
    given = core.Machine(
        "Golden", ("Y", "X"), ("Z",),
        {n: linear(n, u, REFERENCES[n], (-300, 300)) for n, u in zip("XYZ", (x, y, z))}, TOOL,
    )  # fmt: skip
    found = extract.core_machine(machine)
    assert found.structure == given.structure and close(found.tool_point, given.tool_point)
    q = np.array([[200.0, 150, -100], [-30, 10, 5]])
    for body in "XYZ":
        np.testing.assert_allclose(found.lever_arms(q)[body], given.lever_arms(q)[body], atol=1e-9)
    np.testing.assert_allclose(
        workspace.sensitivity(found).total, workspace.sensitivity(given).total, rtol=1e-12, atol=1e-15
    )


def test_tolerances_come_back_as_given_with_their_units(doc):
    machine = golden_machine(doc)
    given = {
        "EXX": distributions.Tolerance(-1e-3, 3e-3, "triangular"),
        "ECW": distributions.Tolerance(-5e-6, 5e-6, "truncated_normal", 2e-6),
    }
    factory.set_tolerances(machine, given, {"ECW": "arcsec"})
    found = tables.read_tolerances(machine)
    assert found["EXX"] == given["EXX"] and found["ECW"] == given["ECW"]
    assert found["EAX"] == distributions.paper_tolerance("EAX")
    assert tables.read_units(machine)["ECW"] == "arcsec" and tables.read_units(machine)["EXX"] == "um"
    with pytest.raises(Refused):
        factory.set_tolerances(machine, given, {"EXX": "arcsec"})


def test_a_damaged_table_is_refused_by_name(doc):
    machine = golden_machine(doc)
    tree.tolerances_of(machine).Lower = [0.0]
    doc.recompute()
    assert "Tolerances" in machine.Problem


def test_an_effect_stands_under_its_body_and_counts_while_it_is_enabled(doc):
    machine = golden_machine(doc)
    plain = results.compute(machine)
    assert EFFECT.name not in plain.Symbols
    effect = factory.make_effect(machine, EFFECT)
    assert effect in tree.axis_of(machine, "Z").Group
    assert tree.owner_machine(effect) == machine
    assert extract.core_effect(effect) == EFFECT
    doc.recompute()
    found = results.compute(machine)
    assert found.Owners[list(found.Symbols).index(EFFECT.name)] == "Z"
    assert found.Total[list(found.Symbols).index(EFFECT.name)] > 0
    effect.Enabled = False
    doc.recompute()
    assert found.Stale
    assert EFFECT.name not in results.compute(machine).Symbols


def test_effects_of_the_spindle_and_the_workpiece_find_their_bodies(doc):
    machine = golden_machine(doc)
    for component, body in (("EZT", "T"), ("EXW", "W")):
        effect = factory.make_effect(machine, of_parameters(component, component, "t", "linear", {"coefficient": 1.0}))
        assert effect in tree.body_of(machine, body).Group


def test_making_an_axis_twice_is_refused(doc):
    machine = golden_machine(doc)
    with pytest.raises(Refused, match="exists already"):
        factory.make_axis(machine, "X")
