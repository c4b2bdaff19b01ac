# SPDX-License-Identifier: LGPL-2.1-or-later
"""A machine out of plain geometry: written to STEP as one compound, read back, split, and its bodies found again."""

from __future__ import annotations

import FreeCAD as App
import Part
import pytest

from sensworkbench.core.refusal import Refused
from sensworkbench.document import examples, factory, proposals, results, tree
from sensworkbench.document.imported import pieces_of, split
from sensworkbench.document.paths import leaves

from .blocks import block, close, point

V, P, R = App.Vector, App.Placement, App.Rotation


def middle(solid) -> tuple:
    return tuple(round(v, 1) + 0.0 for v in solid.CenterOfMass)


@pytest.fixture(scope="module")
def lumps(tmp_path_factory):
    """structure -> (STEP file of the example as one compound, middle of a solid -> body, what is known of it)."""
    made = {}

    def lump(structure):
        if structure not in made:
            doc = App.newDocument("SensTestExample")
            machine = examples.make_example(doc, structure)
            solids, truth = [], {}
            for body in "FXYZTW":
                for where in tree.parts_of(machine, body):
                    for leaf in leaves(where):
                        for solid in leaf.shape().Solids:
                            solids.append(solid)
                            truth[middle(solid)] = body
            path = str(tmp_path_factory.mktemp("step") / f"{structure}.step")
            Part.makeCompound(solids).exportStep(path)
            axes = {n: tree.axis_of(machine, n) for n in "XYZ"}
            known = {
                "tool": tuple(machine.FunctionalPoint),
                "chains": (list(machine.WorkpieceChain), list(machine.ToolChain)),
                "travel": {n: (a.TravelLower.Value, a.TravelUpper.Value) for n, a in axes.items()},
            }
            made[structure] = (path, truth, known)
            App.closeDocument(doc.Name)
        return made[structure]

    return lump


def read(doc, path, placement=None):
    obj = doc.addObject("Part::Feature", "Import")
    obj.Shape = Part.read(path)
    if placement is not None:
        obj.Placement = placement
    doc.recompute()
    return obj


def carried_by(machine, structure):
    """Who moves with whom once spindle and workpiece count as part of what carries them."""
    work, tool = machine["chains"]
    return {"T": tool[-1] if tool else "F", "W": work[-1] if work else "F"}


@pytest.mark.parametrize("structure", ["XYFZ", "FXYZ", "YFXZ"])
def test_a_machine_from_one_step_compound_is_the_machine_that_was_written(doc, lumps, structure):
    path, truth, known = lumps(structure)
    lump = read(doc, path)
    machine = proposals.machine_from_parts(doc, [lump])
    assert machine.Problem == ""
    assert (list(machine.WorkpieceChain), list(machine.ToolChain)) == known["chains"]
    assert close(machine.FunctionalPoint, known["tool"], 0.01)
    joined = carried_by(known, structure)
    seen = 0
    for body in "FXYZ":
        for where in tree.parts_of(machine, body):
            own = truth[middle(where.shape().Solids[0])]
            assert joined.get(own, own) == body, where.label
            seen += 1
    assert seen == len(truth)
    for name, u in zip("XYZ", ((1, 0, 0), (0, 1, 0), (0, 0, 1))):
        axis = tree.axis_of(machine, name)
        assert close(axis.Direction, u)
        low, high = known["travel"][name]
        assert axis.TravelLower.Value <= low < high <= axis.TravelUpper.Value, name  # the rails leave room for more
    found = results.compute(machine)
    assert not found.Stale and max(found.Total) > 0.05


def test_a_machine_that_stands_turned_is_found_too(doc, lumps):
    path, truth, known = lumps("FXYZ")
    turned = P(V(300, -200, 50), R(V(0, 0, 1), 90))
    machine = proposals.machine_from_parts(doc, [read(doc, path, turned)])
    assert machine.Problem == "" and list(machine.ToolChain) == ["Y", "X", "Z"]
    assert close(machine.FunctionalPoint, turned.multVec(V(*known["tool"])), 0.01)


def test_a_carriage_of_the_proposal_jogs_as_one(doc, lumps):
    path, truth, _ = lumps("FXYZ")
    from sensworkbench.document import jog

    machine = proposals.machine_from_parts(doc, [read(doc, path)])
    before = {p.key: p.placement.Base for b in "FXYZ" for p in tree.parts_of(machine, b)}
    jog.jog(machine, {"Y": 40})
    for body, step in (("F", 0), ("X", 0), ("Y", 40), ("Z", 40)):
        for part in tree.parts_of(machine, body):
            assert close(part.placement.Base - before[part.key], (0, step, 0)), part.label


# -- axes ------------------------------------------------------------------------------------------------------------
def box(doc, name, size, at=(0, 0, 0)):
    obj = doc.addObject("Part::Box", name)
    obj.Length, obj.Width, obj.Height = size
    obj.Placement.Base = V(*at)
    return obj


def test_rails_screws_and_long_edges_propose_the_axes(doc):
    plate = box(doc, "Plate", (900, 500, 100))
    rail = box(doc, "Rail", (800, 30, 30), (50, 100, 100))
    screw = doc.addObject("Part::Cylinder", "Screw")
    screw.Radius, screw.Height = 16, 450
    screw.Placement = P(V(450, 20, 150), R(V(1, 0, 0), -90))
    doc.recompute()
    found = proposals.propose_axes([plate, rail, screw])
    assert [(a.axis, tuple(round(abs(v), 9) for v in a.direction)) for a in found[:2]] == [
        ("X", (1, 0, 0)), ("Y", (0, 1, 0))]  # fmt: skip
    assert [(a.why.code, a.why.fields["part"]) for a in found[:2]] == [
        ("propose-suggested-rail", "Rail"), ("propose-suggested-screw", "Screw")]  # fmt: skip
    assert "'Rail'" in found[0].why.text("en") and "800 mm" in found[0].why.text("de")
    assert (found[0].length, found[1].length) == (pytest.approx(800), pytest.approx(450))


def test_without_rails_the_longest_edges_propose_the_axes(doc):
    parts = [box(doc, "Bed", (700, 300, 200)), box(doc, "Slide", (200, 400, 150), (0, 0, 200)),
             box(doc, "Head", (180, 160, 500), (0, 0, 400))]  # fmt: skip
    doc.recompute()
    found = proposals.propose_axes(parts)
    assert sorted(a.axis for a in found[:3]) == ["X", "Y", "Z"]
    assert all(a.why.code == "propose-suggested-side" for a in found)


def test_a_proposed_source_gives_the_proposed_direction(doc):
    parts = [box(doc, f"Block{n}", size) for n, size in enumerate(((500, 20, 30), (20, 400, 30), (20, 30, 450)))]
    for part in parts:
        part.Placement = P(V(10, 20, 30), R(V(1, 2, 3), 25)).multiply(part.Placement)
    doc.recompute()
    tip = point(doc, "Tip", (0, 0, 0))
    machine = factory.make_machine(doc, ["Y", "X"], ["Z"], bed=[block(doc, "Bed")], tool_point=tip)
    found = proposals.propose_axes(parts)
    for a in found[:3]:
        factory.make_axis(machine, a.axis, [block(doc, f"C{a.axis}")], direction=a.source, reverse=a.reverse)
    doc.recompute()
    assert machine.Problem == ""
    for a in found[:3]:
        assert close(tree.axis_of(machine, a.axis).Direction, a.direction, 1e-9)


# -- parts -----------------------------------------------------------------------------------------------------------
def test_splitting_keeps_every_solid_where_it_is(doc):
    holder = doc.addObject("App::Part", "Holder")
    holder.Placement = P(V(5, 6, 7), R(V(0, 0, 1), 30))
    lump = doc.addObject("Part::Feature", "Lump")
    lump.Shape = Part.makeCompound([Part.makeBox(10, 20, 30, V(100 * i, 0, 0)) for i in range(3)])
    lump.Placement = P(V(1, 2, 3), R(V(1, 0, 0), 45))
    holder.addObject(lump)
    doc.recompute()
    before = sorted(middle(s) for p in pieces_of([lump]) for s in p.solids)
    parts = split(lump)
    assert len(parts) == 3 and len(lump.Shape.Solids) == 3
    assert sorted(middle(s) for p in pieces_of(parts) for s in p.solids) == before
    with pytest.raises(Refused, match="Lump 1"):
        split(parts[0])


def test_a_rounded_edge_and_a_bore_are_no_screws(doc):
    bored = Part.makeBox(100, 100, 800).cut(Part.makeCylinder(10, 800, V(50, 50, 0)))
    bored = bored.makeFillet(8, [e for e in bored.Edges if e.Length == pytest.approx(800) and len(e.Vertexes) == 2][:1])
    obj = doc.addObject("Part::Feature", "Ram")
    obj.Shape = bored
    assert proposals.propose_axes([obj])[0].why.code == "propose-suggested-rail"  # long enough to be one


# -- refusals --------------------------------------------------------------------------------------------------------
def test_what_shows_no_machine_is_refused_and_nothing_is_made(doc):
    parts = [box(doc, f"Block{i}", (100, 100, 100), (0, 0, 100 * i)) for i in range(5)]
    tip = point(doc, "P", (0, 0, 0))
    doc.recompute()
    before = [o.Name for o in doc.Objects]
    for objects, reason in ((parts, "propose-nothing-slides"), (parts[:1], "propose-too-few"),
                            (tip, "propose-too-few")):  # fmt: skip
        with pytest.raises(Refused) as refused:
            proposals.machine_from_parts(doc, objects)
        assert (refused.value.code, refused.value.fields["reason"].code) == ("propose-incomplete", reason)
    with pytest.raises(Refused) as refused:
        proposals.propose_axes([tip])
    assert refused.value.code == "proposal-no-solids"
    assert [o.Name for o in doc.Objects] == before


def test_one_axis_is_no_machine_and_what_is_missing_is_asked(doc):
    bed = box(doc, "Bed", (1000, 300, 100))
    rails = [box(doc, "Rail HGR20-900", (900, 20, 20), (50, y, 100)) for y in (50, 230)]
    blocks = [box(doc, "Block HGH20CA", (70, 44, 25), (x, y - 12, 105)) for x in (200, 400) for y in (50, 230)]
    plate = box(doc, "Plate", (400, 300, 30), (150, 0, 130))
    doc.recompute()
    before = [o.Name for o in doc.Objects]
    parts = [bed, *rails, *blocks, plate]
    with pytest.raises(Refused) as refused:
        proposals.machine_from_parts(doc, parts)
    assert refused.value.code == "propose-incomplete" and refused.value.fields["reason"].code.startswith("propose-ask-")
    assert [o.Name for o in doc.Objects] == before
    machine = proposals.machine_from_parts(doc, parts, answers={"enough": True}, travel={"X": (-10, 20)})
    axis = tree.axis_of(machine, "X")
    assert (axis.TravelLower.Value, axis.TravelUpper.Value) == (-10, 20)
    assert close(axis.Direction, (1, 0, 0)) and plate in [w.object for w in tree.parts_of(machine, "X")]
