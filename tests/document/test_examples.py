# SPDX-License-Identifier: LGPL-2.1-or-later
"""The example machines are machines: sound solids, ways long enough for the travel, nothing in the way."""

from __future__ import annotations

import itertools

import FreeCAD as App
import pytest

from sensworkbench.core.refusal import Refused
from sensworkbench.document import examples, extract, jog, paths, results, tree


@pytest.fixture(params=list(examples.NAMES), scope="module")
def built(request):
    document = App.newDocument("Example")
    yield request.param, examples.make_example(document, request.param)
    App.closeDocument(document.Name)


@pytest.fixture
def example(built):
    structure, machine = built
    assert machine.Structure == structure
    yield machine
    jog.home(machine)


def leaves(machine):
    return {b: [l for p in tree.parts_of(machine, b) for l in paths.leaves(p)] for b in "FXYZTW"}


def ends(machine):
    axes = [tree.axis_of(machine, n) for n in "XYZ"]
    limits = [(a.TravelLower.Value, a.TravelUpper.Value) for a in axes]
    return [dict(zip("XYZ", corner)) for corner in itertools.product(*limits)]


def test_an_example_is_a_computed_machine_of_sound_solids(example):
    assert example.Problem == ""
    parts = [leaf for body in leaves(example).values() for leaf in body]
    assert 10 <= len(parts) <= 25
    for leaf in parts:
        shape = leaf.shape()
        assert shape.isValid() and shape.Solids and all(s.Volume > 1000 for s in shape.Solids), leaf.label
    labels = [leaf.object.Label for leaf in parts]
    assert len(set(labels)) == len(labels)
    assert set(example.PartColours) == {leaf.object.Name for leaf in parts}
    found = results.compute(example)
    assert found.EstimatedError < 1e-5 and max(found.Total) > 0.05


def test_guide_blocks_stay_on_their_ways_over_the_whole_travel(example):
    index = {axis: "XYZ".index(axis) for axis in "XYZ"}
    for corner in ends(example):
        jog.jog(example, corner)
        named = {leaf.object.Name: leaf.shape() for body in leaves(example).values() for leaf in body}
        for axis, i in index.items():
            ways = named[f"Ways{axis}"].BoundBox
            blocks = named[f"Blocks{axis}"].BoundBox
            way, on_it = ((b.XMin, b.YMin, b.ZMin, b.XMax, b.YMax, b.ZMax) for b in (ways, blocks))
            assert way[i] <= on_it[i] and on_it[i + 3] <= way[i + 3], (axis, corner)


def test_bodies_do_not_run_into_each_other_at_the_ends_of_travel(example):
    for corner in ends(example):
        jog.jog(example, corner)
        solids = [(b, l.label, s) for b, parts in leaves(example).items() for l in parts for s in l.shape().Solids]
        for (b1, name1, s1), (b2, name2, s2) in itertools.combinations(solids, 2):
            if b1 != b2 and s1.BoundBox.intersect(s2.BoundBox):
                assert s1.common(s2).Volume < 1, (name1, name2, corner)


def test_the_tool_reaches_the_workpiece_and_clears_the_table(example):
    low = tree.axis_of(example, "Z").TravelLower.Value
    jog.jog(example, {"Z": low})
    tip = extract.place(example.ToolPoint).placement.Base
    top = max(leaf.shape().BoundBox.ZMax for leaf in leaves(example)["W"])
    assert tip.z > top - 100 and tip.z > 0  # the table's top is at 0
    assert abs(tip.x - tree.parts_of(example, "W")[0].placement.Base.x) < 100


def test_an_unknown_structure_is_refused(doc):
    with pytest.raises(Refused, match="XYFZ, FXYZ, YFXZ"):
        examples.make_example(doc, "XZFY")
