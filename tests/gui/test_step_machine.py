# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a STEP file to a ranking in the window: imported as a user does it, proposed with reasons, checked, computed."""

from __future__ import annotations

import time

import FreeCAD as App
import FreeCADGui as Gui
import Part
import pytest

from sensworkbench.core.workspace import Cancelled
from sensworkbench.document import examples, tree
from sensworkbench.document.paths import leaves
from sensworkbench.document.propose import engine
from sensworkbench.gui import looking, task_machine
from sensworkbench.gui.preferences import write_field
from sensworkbench.gui.qt import QtGui, main_window, pump

from ..document.machines.plain import wooden_router
from .conftest import differences, look, messages, run, screenshot, state
from .test_commands import click
from .test_panels import width  # noqa: F401 - room for the panel

BODIES = "FXYZTW"
TWO_MINUTES = 120


def middles(shape) -> list[tuple]:
    return [tuple(round(v, 1) + 0.0 for v in solid.CenterOfMass) for solid in shape.Solids]


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    """STEP files of the vertical machining centre - one compound, a tree of containers - and what is known of it."""
    import Import

    folder = tmp_path_factory.mktemp("step")
    doc = App.newDocument("Source")
    machine = examples.make_example(doc, "XYFZ")
    doc.recompute()
    shapes = {b: [(leaf.object.Label, leaf.shape()) for w in tree.parts_of(machine, b) for leaf in leaves(w)]
              for b in BODIES}  # fmt: skip
    known = {
        "body": {at: b for b in BODIES for _, s in shapes[b] for at in middles(s)},
        "tool": tuple(machine.FunctionalPoint),
        "travel": {n: (tree.axis_of(machine, n).TravelLower.Value, tree.axis_of(machine, n).TravelUpper.Value)
                   for n in "XYZ"},
    }  # fmt: skip
    Part.makeCompound([s for b in BODIES for _, s in shapes[b]]).exportStep(str(folder / "compound.step"))
    nested = App.newDocument("Tree")
    names = {"F": "Bed", "X": "Table X", "Y": "Saddle Y", "Z": "Headstock", "T": "Spindle", "W": "Workpiece"}
    tops = []
    for body in BODIES:
        holder = nested.addObject("App::Part", "Part")
        holder.Label = names[body]
        for label, shape in shapes[body]:
            part = nested.addObject("Part::Feature", "Solid")
            part.Label, part.Shape = label, shape
            holder.addObject(part)
        tops.append(holder)
    nested.recompute()
    Import.export(tops, str(folder / "tree.step"))
    nested.saveAs(str(folder / "tree.FCStd"))
    for name in (doc.Name, nested.Name):
        App.closeDocument(name)
    return folder, known


def insert(doc, path):
    """File > Import."""
    import ImportGui

    ImportGui.insert(str(path), doc.Name)
    doc.recompute()
    look(doc)
    pump(50)


def panel():
    """The parts of the open panel that a user looks at."""
    form = next(w for w in main_window().findChildren(QtGui.QWidget, "SensMachine") if w.isVisible())
    return form, form.findChild(QtGui.QLabel, "SensProposal"), form.findChild(QtGui.QTreeWidget, "SensBodies")


def bodies(machine) -> dict:
    """Middle of each solid -> the body that it belongs to."""
    return {at: b for b in BODIES for w in tree.parts_of(machine, b) for leaf in leaves(w)
            for at in middles(leaf.shape())}  # fmt: skip


def test_one_compound_becomes_a_machine_in_two_minutes(doc, workbench, files):
    folder, known = files
    start, actions = time.monotonic(), 0
    insert(doc, folder / "compound.step")
    actions += 1
    imported, undos = state(doc), doc.UndoCount
    run("Sens_Machine")
    actions += 1
    form, note, table = panel()
    machine = tree.machine_of(doc)
    assert not machine.Problem and machine.Structure == "XYFZ"
    assert "check everything" in note.text() and "Not looked at yet" in note.text()
    screenshot("step-proposed")
    for row in range(4):
        table.setCurrentItem(table.topLevelItem(row))
        actions += 1
        pump(20)
    assert "Not looked at yet" not in note.text()
    for piece in ("holds the long bar", "% sure", "travel: as far as"):
        assert piece in note.text()
    lit = {at for s in Gui.Selection.getSelectionEx() for at in middles(s.Object.Shape)}
    assert lit == {at for at, body in bodies(machine).items() if body == "Z"}
    screenshot("step-checked")
    click("Ok")
    actions += 1
    assert Gui.Selection.getSelectionEx() == []
    run("Sens_Sensitivity")
    actions += 1
    took = time.monotonic() - start
    screenshot("step-ranking")
    assert messages() == [] and took < TWO_MINUTES and actions == 8
    joined = {"T": "Z", "W": "X"}
    assert bodies(machine) == {at: joined.get(b, b) for at, b in known["body"].items()}
    assert tuple(machine.FunctionalPoint) == pytest.approx(known["tool"], abs=0.01)
    for name in "XYZ":
        axis = tree.axis_of(machine, name)
        low, high = known["travel"][name]
        assert axis.TravelLower.Value <= low < high <= axis.TravelUpper.Value
        assert "Reference" in axis.ReferenceSource[0].Label
        box = App.BoundBox()
        for where in tree.parts_of(machine, name):
            for leaf in leaves(where):
                box.add(leaf.shape().BoundBox)
        assert box.isInside(axis.ReferencePoint)
    doc.undo()
    doc.undo()
    pump(100)
    assert doc.UndoCount == undos and differences(imported, state(doc)) == []


def test_a_tree_keeps_its_names_and_takes_directions_and_travel_from_its_rails(doc, workbench, files):
    folder, known = files
    insert(doc, folder / "tree.step")
    run("Sens_Machine")
    _, note, table = panel()
    machine = tree.machine_of(doc)
    assert not machine.Problem and machine.Structure == "XYFZ"
    flat = not any(o.Label == "Spindle" for o in doc.Objects)  # FreeCAD 0.20 writes no containers
    joined = {"T": "Z", "W": "X"} if flat else {}
    assert bodies(machine) == {at: joined.get(b, b) for at, b in known["body"].items()}
    for name in "XYZ":
        axis = tree.axis_of(machine, name)
        low, high = known["travel"][name]
        assert axis.TravelLower.Value <= low < high <= axis.TravelUpper.Value
        assert axis.DirectionSource is not None and abs(axis.Direction["XYZ".index(name)]) == pytest.approx(1)
    assert "disagree" not in note.text()
    table.setCurrentItem(table.topLevelItem(2))
    pump(20)
    assert flat or "its name says Y" in note.text()
    screenshot("step-tree")
    click("Cancel")
    assert not tree.machines(doc)


def test_where_names_and_contacts_disagree_the_note_says_which_parts(doc, workbench, files):
    doc = App.openDocument(str(files[0] / "tree.FCStd"))  # FreeCAD 0.20 writes no containers into STEP files
    column = next(o for o in doc.Objects if o.Label == "Column")
    saddle = next(o for o in doc.Objects if o.Label == "Saddle Y")
    column.getParentGeoFeatureGroup().removeObject(column)
    saddle.addObject(column)
    doc.recompute()
    found = engine.propose(doc)
    assert [m.fields["parts"] for m in found.remarks if m.code == "propose-disagree"] == ["'Column'"]


def test_what_the_user_chooses_is_no_longer_called_a_proposal(doc, workbench, files):
    insert(doc, files[0] / "compound.step")
    shown = task_machine.new_machine(doc)
    shown.table.setCurrentItem(shown.table.topLevelItem(1))
    assert "travel: as far as" in shown.guess.text()
    shown.upper.setValue(100.0)
    assert "travel:" not in shown.guess.text() and "holds the long bar" in shown.guess.text()
    assert shown.guess.answers["travel:X"][1] == 100.0
    shown.reverse.setChecked(not shown.reverse.isChecked())
    assert "holds the long bar" not in shown.guess.text()
    shown.clear.click()
    assert "•" not in shown.guess.text()
    click("Cancel")
    assert not tree.machines(doc)


def test_where_the_geometry_shows_no_machine_the_panel_says_so_and_suggests_directions(doc, workbench):
    for i, size in enumerate(((900, 60, 50), (60, 700, 50), (60, 50, 600), (200, 200, 200))):
        part = doc.addObject("Part::Feature", "Solid")
        part.Shape = Part.makeBox(*size, App.Vector(0, 0, 1000 * i))
    doc.recompute()
    look(doc)
    shown = task_machine.new_machine(doc)
    assert "does not show which part is which" in shown.guess.text()
    assert "Nothing shows which part slides on which" in shown.guess.text()
    assert shown.suggested.count() > 3
    assert "has no carriage" in shown.note.text() or "no parts" in shown.note.text()
    screenshot("step-no-machine")
    shown.table.setCurrentItem(shown.table.topLevelItem(1))
    shown.suggested.setCurrentIndex(1)
    shown.suggested.activated.emit(1)
    assert tree.axis_of(shown.machine, "X").DirectionSource is not None
    click("Cancel")


def test_looking_for_contacts_can_be_stopped_and_leaves_nothing(doc, workbench, files, monkeypatch):
    insert(doc, files[0] / "compound.step")
    before, undos = state(doc), doc.UndoCount

    def stop(doc, selection, progress, early):
        assert progress(0, 10) is False
        raise Cancelled

    monkeypatch.setattr(engine, "propose", stop)
    run("Sens_Machine")
    assert not Gui.Control.activeDialog() and messages() == []
    assert differences(before, state(doc)) == [] and doc.UndoCount == undos


def during_the_look(monkeypatch, act):
    """The panel opens at once, and `act(panel)` is done as soon as the names are read."""
    monkeypatch.setattr(looking, "PATIENCE", 0.0)
    monkeypatch.setattr(looking, "TURN", 0.0)
    monkeypatch.setattr(looking, "SHARE", 0.0)
    read = looking.Look.read

    def then(self, names):
        read(self, names)
        act(self.panel)

    monkeypatch.setattr(looking.Look, "read", then)


def test_the_panel_is_used_while_shapes_are_looked_at_and_what_is_chosen_stays(doc, workbench, tmp_path, monkeypatch):
    wooden_router(doc, tmp_path)
    App.setActiveDocument(doc.Name)
    look(doc)
    seen = []

    def act(shown):
        assert shown.guess.looking.isVisible() and shown.form.isVisible()
        screenshot("machine-looking")
        seen.append(shown.guess.proposal.found.structure)
        shown.table.setCurrentItem(shown.table.topLevelItem(1 + shown.names.index("X")))
        shown.upper.setValue(77.0)
        write_field(shown.squareness, "carried")

    during_the_look(monkeypatch, act)
    shown = task_machine.new_machine(doc)
    assert seen and not shown.guess.looking.isVisible()
    assert shown.machine.Structure == "FYXZ" and shown.guess.proposal.found.axes["Y"].confidence > 0.5
    assert tree.axis_of(shown.machine, "X").TravelUpper.Value == 77.0 and shown.body == "X"
    assert shown.machine.Squareness == "carried" and len(tree.machines(doc)) == 1
    click("Cancel")
    assert not tree.machines(doc)


def test_cancel_in_the_bar_keeps_what_names_say(doc, workbench, tmp_path, monkeypatch):
    wooden_router(doc, tmp_path)
    App.setActiveDocument(doc.Name)
    during_the_look(monkeypatch, lambda shown: shown.form.findChild(QtGui.QPushButton, "SensStopLooking").click())
    shown = task_machine.new_machine(doc)
    assert shown is not None and not shown.guess.looking.isVisible()
    assert [w.label for w in tree.parts_of(shown.machine, "F")] == ["Base"]
    click("Cancel")


def test_a_panel_closed_during_the_look_leaves_nothing(doc, workbench, tmp_path, monkeypatch):
    wooden_router(doc, tmp_path)
    App.setActiveDocument(doc.Name)
    before = state(doc)
    during_the_look(monkeypatch, lambda shown: click("Cancel"))
    assert task_machine.new_machine(doc) is None
    assert differences(before, state(doc)) == []


def test_a_router_of_four_links_takes_eight_clicks_and_moves_before_anything_is_computed(doc, workbench, tmp_path):
    wooden_router(doc, tmp_path, ("PartA", "PartB", "PartC", "PartD"))
    App.setActiveDocument(doc.Name)
    look(doc)
    shown = task_machine.new_machine(doc)
    clicks = 1
    while shown.guess.asked is not None:
        assert shown.guess.asked.name == "tool" and shown.guess.armed
        screenshot("machine-question")
        Gui.Selection.addSelection(doc.Name, "PartD", doc.getObject("PartD").LinkedObject.Group[0].Name + ".Face1")
        pump(50)
        clicks += 1
    before = {n: doc.getObject(n).Placement.Base for n in ("PartA", "PartB", "PartC", "PartD")}
    shown.table.setCurrentItem(shown.table.topLevelItem(1 + shown.names.index("Y")))
    clicks += 1
    shown.trial.slider.setSliderDown(True)
    shown.trial.slider.setValue(shown.trial.slider.maximum())
    clicks += 1
    moved = {n: doc.getObject(n).Placement.Base - at for n, at in before.items()}
    screenshot("machine-moves")
    assert moved["PartA"].Length == 0 and all(moved[n].y > 100 for n in ("PartB", "PartC", "PartD"))
    shown.trial.slider.setSliderDown(False)
    assert all((doc.getObject(n).Placement.Base - at).Length < 1e-9 for n, at in before.items())
    click("Ok")
    clicks += 1
    machine = tree.machine_of(doc)
    assert machine.Structure == "FYXZ" and not machine.Problem and clicks <= 8
    assert all((doc.getObject(n).Placement.Base - at).Length < 1e-9 for n, at in before.items())


def test_all_axes_play_one_after_the_other_and_stand_where_they_stood(doc, workbench, tmp_path, monkeypatch):
    wooden_router(doc, tmp_path)
    App.setActiveDocument(doc.Name)
    shown = task_machine.new_machine(doc)
    reached = {}
    move = shown.trial.move

    def watch(position):
        for name, value in position.items():
            low, high = reached.get(name, (value, value))
            reached[name] = min(low, value), max(high, value)
        return move(position)

    monkeypatch.setattr(shown.trial, "move", watch)
    shown.trial.all.click()
    start = time.monotonic()
    while shown.trial._timer.isActive() and time.monotonic() - start < 60:
        pump(50)
    for name in "XYZ":
        axis = tree.axis_of(shown.machine, name)
        assert reached[name] == pytest.approx((axis.TravelLower.Value, axis.TravelUpper.Value), rel=0.02)
        assert axis.Position.Value == 0.0
    click("Cancel")


def test_parts_that_were_drawn_here_are_proposed_by_their_names_and_never_called_sure(doc, workbench):
    from .test_panels import loose_parts

    loose_parts(doc)
    shown = task_machine.new_machine(doc)
    found = shown.guess.proposal.found
    assert found.structure == "XYFZ" and max(a.confidence for a in found.axes.values()) < 0.75
    assert not shown.guess.isHidden() and shown.suggested.isHidden()
    click("Cancel")


def test_questions_are_answered_one_at_a_time_and_the_rest_is_weighed_anew(doc, workbench):
    for label, at, size in (("a", (0, 0, 0), (900, 600, 100)), ("b", (100, 50, 100), (200, 500, 80)),
                            ("c", (120, 200, 180), (160, 160, 80)),
                            ("d", (150, 220, 260), (100, 100, 300))):  # fmt: skip
        part = doc.addObject("Part::Feature", label.upper())
        part.Label, part.Shape = label, Part.makeBox(*size, App.Vector(*at))
    doc.recompute()
    look(doc)
    shown = task_machine.new_machine(doc)
    clicks = 1
    asked = []
    while shown.guess.asked is not None and shown.guess.asked.name.startswith(("bed", "body")):
        name = shown.guess.asked.name
        asked.append(name)
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(doc.Name, {"bed": "A", "body:X": "B", "body:Y": "C", "body:Z": "D"}[name], "Face1")
        pump(20)
        clicks += 1
        if name == "body:X":  # the same again, after it was taken back
            shown.guess.findChild(QtGui.QPushButton, "SensUndoAnswer").click()
            assert shown.guess.asked.name == "body:X"
            Gui.Selection.addSelection(doc.Name, "B", "Face1")
            pump(20)
    assert asked == ["bed", "body:X", "body:Y", "body:Z"] and clicks <= 12
    machine = tree.machine_of(doc)
    assert machine.Structure == "FXYZ" and [o.Label for o, _ in machine.Bed] == ["a"]
    assert [w.label for w in tree.parts_of(machine, "Z")] == ["d"]
    screenshot("step-questions")
    click("Cancel")
    assert not tree.machines(doc) and len(doc.Objects) == 4
