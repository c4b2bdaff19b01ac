# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels: what is typed reaches the document as one undo step; the table and the model are linked both ways."""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import pytest

from sensworkbench.core import workspace
from sensworkbench.core.objectives import MeanSquare
from sensworkbench.document import closed_loop, extract, factory, refresh, tables, told, tree
from sensworkbench.document.part_names import guess
from sensworkbench.gui import colormap, colours, display, pointers, review, settings
from sensworkbench.gui.qt import pump
from sensworkbench.gui.state import of as state_of
from sensworkbench.gui.task_jog import TaskJog
from sensworkbench.gui.task_machine import TaskMachine, new_machine
from sensworkbench.gui.task_tolerances import LAW, LOWER, UNIT, UPPER, edit_tolerances

from ..document import simulated
from .conftest import close_messages, differences, look, messages, run, screenshot, state
from .test_commands import click


@pytest.fixture(autouse=True)
def width():
    """Room for the task panel, as on a user's screen."""
    from sensworkbench.gui.qt import Qt, QtGui, main_window

    window = main_window()
    docks = [d for d in window.findChildren(QtGui.QDockWidget) if d.objectName() in ("Combo View", "Model")]
    if docks:
        window.resizeDocks(docks[:1], [400 if docks[0].objectName() == "Combo View" else 240], Qt.Horizontal)


def cell(panel, symbol, column):
    row = next(i for i, r in enumerate(panel.model.rows) if r.symbol == symbol)
    return panel.model.index(row, column)


# -- tolerances ------------------------------------------------------------------------------------------------------
def test_tolerances_with_comma_point_and_units(machine, machine_doc):
    run("Sens_Sensitivity")
    before, undos = state(machine_doc), machine_doc.UndoCount
    panel = edit_tolerances(machine)
    panel.model.setData(cell(panel, "EXX", LOWER), "-2,5")
    panel.model.setData(cell(panel, "EXX", UPPER), "7.5")
    panel.model.setData(cell(panel, "EAX", UNIT), "arcsec")
    panel.model.setData(cell(panel, "EAX", LOWER), "-1,5 arcsec")
    panel.model.setData(cell(panel, "EAX", UPPER), "10 µrad")
    panel.model.setData(cell(panel, "EAX", LAW), "triangular")
    screenshot("tolerances")
    click("Ok")
    found = tables.read_tolerances(machine)
    assert (found["EXX"].lower, found["EXX"].upper) == pytest.approx((-0.0025, 0.0075))
    assert (found["EAX"].lower, found["EAX"].upper) == pytest.approx((-1.5 * np.pi / 180 / 3600, 1e-5))
    assert found["EAX"].distribution == "triangular" and tables.read_units(machine)["EAX"] == "arcsec"
    assert machine_doc.UndoCount == undos + 1
    machine_doc.undo()
    pump(200)
    assert [d for d in differences(before, state(machine_doc)) if d.startswith("Tolerances")] == []


def test_what_cannot_be_read_holds_ok_back(machine, machine_doc):
    before = state(machine_doc)
    panel = edit_tolerances(machine)
    for symbol, column, text, word in (
        ("EXX", UPPER, "twelve", "not a number"), ("EAX", UPPER, "3 mm", "not that of an angle"),
        ("EYX", UPPER, "-9", "upper limit is below"),
    ):  # fmt: skip
        old = panel.model.data(cell(panel, symbol, column))
        panel.model.setData(cell(panel, symbol, column), text)
        assert word in panel.note.text()
        assert panel.accept() is False
        assert any(word in m for m in messages())
        close_messages()
        panel.model.setData(cell(panel, symbol, column), old)
    click("Cancel")
    assert differences(before, state(machine_doc)) == []


def test_tolerances_go_out_to_csv_and_come_back(machine, machine_doc, tmp_path):
    panel = edit_tolerances(machine)
    panel.model.setData(cell(panel, "ECZ", UPPER), "33")
    path = str(tmp_path / "t.csv")
    assert panel.write_file(path)
    panel.defaults()
    assert panel.model.data(cell(panel, "ECZ", UPPER)) == "20"
    assert panel.read_file(path)
    assert panel.model.data(cell(panel, "ECZ", UPPER)) == "33"
    (tmp_path / "bad.csv").write_text("symbol,lower,upper\nEQQ,1,2\n", encoding="utf-8")
    assert not panel.read_file(str(tmp_path / "bad.csv"))
    assert any("EQQ" in m and "line 2" in m for m in messages())
    close_messages()
    click("Cancel")


# -- machine ---------------------------------------------------------------------------------------------------------
def loose_parts(doc):
    """A machine's parts without a machine, as somebody else would have drawn them."""
    made = {}
    for name, at in (
        ("Bed", (0, 0, -300)), ("Saddle Y", (0, 0, -200)), ("Table X", (0, 0, -120)), ("Headstock Z", (0, 200, 300)),
        ("Spindle", (0, 100, 200)), ("Workpiece", (0, 0, -50)),
    ):  # fmt: skip
        box = doc.addObject("Part::Box", name.replace(" ", ""))
        box.Label = name
        box.Length, box.Width, box.Height = 120, 100, 60
        box.Placement.Base = App.Vector(*at)
        made[name] = box
    tip = doc.addObject("PartDesign::CoordinateSystem", "TCP")
    tip.Label = "Tool tip"
    tip.Placement.Base = App.Vector(60, 150, 0)
    doc.recompute()
    look(doc)
    return made


def test_names_say_who_is_who():
    for label, body in (
        ("Bed", "F"), ("machine base", "F"), ("Saddle Y", "Y"), ("CarriageX", "X"), ("Z-Achse", "Z"), ("Spindel", "T"),
        ("Werkstück", "W"), ("X축", "X"), ("Headstock", "Z"), ("Table", "X"), ("y_slide", "Y"), ("Box", ""),
        ("Column (X)", "X"), ("Workpiece and vice", "W"), ("Ways Y", ""), ("Rail X1", ""), ("Spindle motor", ""),
    ):  # fmt: skip
        assert guess(label) == body, label


def test_machine_from_selection_proposes_and_is_one_undo_step(doc, workbench):
    loose_parts(doc)
    before, undos = state(doc), doc.UndoCount
    panel = new_machine(doc)
    pump(50)
    machine = tree.machine_of(doc)
    assert (list(machine.WorkpieceChain), list(machine.ToolChain)) == (["Y", "X"], ["Z"])
    assert [p.label for p in tree.parts_of(machine, "Z")] == ["Headstock Z"]
    assert not machine.Problem
    panel.table.setCurrentItem(panel.table.topLevelItem(3))
    screenshot("machine")
    click("Ok")
    assert doc.UndoCount == undos + 1 and tree.machine_of(doc).Structure == "XYFZ"
    made = state(doc)
    for _ in range(2):
        doc.undo()
        pump(50)
        assert differences(before, state(doc)) == []
        doc.redo()
        pump(50)
        assert [d for d in differences(made, state(doc)) if "Parts" in d or " is " in d] == []
        assert not tree.machine_of(doc).Problem


def test_machine_from_selection_cancelled_leaves_nothing(doc, workbench):
    loose_parts(doc)
    before, undos = state(doc), doc.UndoCount
    panel = new_machine(doc)
    assert isinstance(panel, TaskMachine)
    click("Cancel")
    assert differences(before, state(doc)) == [] and doc.UndoCount == undos


def test_a_document_without_parts_says_how_to_begin(doc, workbench):
    run("Sens_Machine")
    assert not Gui.Control.activeDialog() and not doc.Objects
    assert any("no parts" in m and "Example Machine" in m for m in messages())
    close_messages()


def test_parts_directions_and_points_are_picked(doc, workbench):
    parts = loose_parts(doc)
    other = doc.addObject("Part::Box", "Slide")
    other.Placement = App.Placement(App.Vector(0, 0, 400), App.Rotation(App.Vector(0, 0, 1), 2))
    doc.recompute()
    panel = new_machine(doc)
    panel.table.setCurrentItem(panel.table.topLevelItem(1))
    assert panel.body == "X"
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(doc.Name, other.Name)
    panel.take.click()
    machine = tree.machine_of(doc)
    assert [p.object.Name for p in tree.parts_of(machine, "X")] == ["Slide"]
    axis = tree.axis_of(machine, "X")
    assert axis.Direction.y == pytest.approx(np.sin(np.radians(2)))
    assert "Not square" in panel.note.text()
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(doc.Name, parts["Bed"].Name, "Edge9")
    panel.direction.take.click()
    assert axis.DirectionSource[0] == parts["Bed"]
    assert "Edge9" in told.words(axis.DirectionFrom)
    panel.direction.reset.click()
    assert axis.DirectionSource is None
    panel.structure.setCurrentIndex(panel.structure.findData("FXYZ"))
    assert list(machine.ToolChain) == ["X", "Y", "Z"]
    panel.upper.setValue(321.0)
    assert axis.TravelUpper.Value == 321.0
    panel.clear.click()
    assert "has no carriage" in panel.note.text()
    assert panel.accept() is False
    close_messages()
    click("Cancel")
    assert not tree.machines(doc)


# -- jog -------------------------------------------------------------------------------------------------------------
def test_jog_moves_parts_and_is_one_undo_step(machine, machine_doc):
    run("Sens_Sensitivity")
    table = tree.parts_of(machine, "X")[0].object
    start, undos = App.Vector(table.Placement.Base), machine_doc.UndoCount
    panel = TaskJog(machine)
    Gui.Control.showDialog(panel)
    panel.numbers["X"].setValue(120.0)
    panel.numbers["Z"].setValue(60.0)
    pump(100)
    assert (table.Placement.Base - start).x == pytest.approx(-120.0)  # a table goes the other way
    assert tree.axis_of(machine, "X").Position.Value == 120.0
    assert panel.sliders["X"].value() > 500
    result = tree.sensitivity_of(machine)
    assert "At X 120.0, Y 0.0, Z 60.0 mm" in result.ViewObject.Proxy.legend._content[0].subtitle
    totals = {b: float(panel.table.item(i, 5).text()) for i, b in enumerate("XYZ")}
    scale = colormap.automatic(totals.values())
    for body, total in totals.items():
        shown = colours.shown_colour(colours.targets(machine)[body][0].obj)
        assert shown == pytest.approx(scale.colour(total), abs=0.02)
    screenshot("jog")
    click("Ok")
    assert machine_doc.UndoCount == undos + 1
    machine_doc.undo()
    pump(100)
    assert (table.Placement.Base - start).Length < 1e-9
    assert tree.axis_of(machine, "X").Position.Value == 0.0


def test_the_tool_goes_to_a_clicked_point_and_says_where_the_travel_ends(machine, machine_doc):
    panel = TaskJog(machine)
    Gui.Control.showDialog(panel)
    pump(60)
    core = extract.core_machine(machine)
    q = np.array([40.0, -30.0, -20.0])
    place = core.tool_position([q])[0]
    Gui.Selection.clearSelection()
    panel.to_point.click()
    assert panel.note.text() == "Click the place in the 3D view first."
    panel.go("X", 55.0)  # the table stands elsewhere: the point that is clicked has moved with it
    found = extract.survey(machine)
    leaf = pointers.paths.leaves(tree.parts_of(machine, "W")[0])[0]
    clicked = found.displacements["W"].multVec(App.Vector(*place))
    Gui.Selection.addSelection(machine_doc.Name, leaf.root.Name, f"{leaf.path}Face1", *clicked)
    panel.to_point.click()
    assert panel.note.text() == ""
    assert [panel.position[n] for n in core.names] == pytest.approx(q, abs=1e-3)
    tip = extract.survey(machine)
    assert tip.displacements["T"].multVec(machine.FunctionalPoint) == pytest.approx(
        tip.displacements["W"].multVec(App.Vector(*place)), abs=1e-3
    )
    assert panel.go_to(core, place + [0, 0, 5000.0]) > 1000
    click("Cancel")


def test_a_drag_surveys_the_machine_once_per_step_and_computes_nothing_for_the_workspace(
    machine, machine_doc, monkeypatch
):
    run("Sens_Sensitivity")
    panel = TaskJog(machine)
    Gui.Control.showDialog(panel)
    pump(60)
    surveys, computed = [], []
    real_survey, real_indices = refresh.survey, workspace.sensitivity
    monkeypatch.setattr(refresh, "survey", lambda m: surveys.append(m) or real_survey(m))
    monkeypatch.setattr(workspace, "sensitivity", lambda *a, **k: computed.append(len(a[1].q)) or real_indices(*a, **k))
    for x in (10.0, 20.0, 30.0):
        panel.numbers["X"].setValue(x)
        pump(60)
    assert 3 <= len(surveys) <= 6 and computed and set(computed) == {1}
    click("Cancel")


def test_the_review_gives_way_to_a_panel_that_would_cover_the_model(machine, machine_doc):
    run("Sens_Sensitivity")
    run("Sens_Jog")
    assert review.dock().isVisible() != review._overlaid()
    screenshot("jog-room")
    click("Cancel")
    pump(400)
    assert review.dock().isVisible()


def test_jog_cancelled_puts_the_parts_back(machine, machine_doc):
    run("Sens_Sensitivity")
    pump(50)
    before = state(machine_doc)
    panel = TaskJog(machine)
    Gui.Control.showDialog(panel)
    panel.sliders["Y"].setValue(900)
    panel.sliders["Z"].setValue(100)
    pump(100)
    assert differences(before, state(machine_doc))
    click("Cancel")
    assert differences(before, state(machine_doc)) == []


# -- review ----------------------------------------------------------------------------------------------------------
def test_the_ranking_lists_every_error_largest_first(machine, machine_doc):
    run("Sens_Sensitivity")
    found = review.dock().ranking
    result = tree.sensitivity_of(machine)
    texts = [[i.text(c) for c in range(8)] for i in found.items()]
    assert len(texts) == len(result.Symbols) == 24
    shares = dict(zip(result.Symbols, (np.array(result.First) + result.Total) / 2))
    assert sum(shares.values()) == pytest.approx(1, abs=1e-9)
    assert [t[1] for t in texts][0] == max(shares, key=shares.get)
    assert [shares[t[1]] for t in texts] == sorted(shares.values(), reverse=True)
    assert "±20 µrad" in next(t for t in texts if t[1] == "EAX") and "±5 µm" in next(t for t in texts if t[1] == "EYX")
    screenshot("review")


def test_choosing_an_error_lights_up_its_parts_and_shows_arrows(machine, machine_doc):
    run("Sens_Sensitivity")
    dock = review.dock()
    item = next(i for i in dock.ranking.items() if i.text(1) == "EAZ")
    dock.ranking.table.setCurrentItem(item)
    pump(30)
    assert Gui.Selection.getSelection() == [tree.axis_of(machine, "Z")]  # in the tree; the parts are outlined
    outline = np.array([p for line in machine.ViewObject.Proxy.arrows.outlined for p in line])
    box = App.BoundBox()
    for leaf in pointers.paths.leaves(tree.parts_of(machine, "Z")[0]):
        box.add(leaf.shape().BoundBox)
    assert outline.min(axis=0) == pytest.approx([box.XMin, box.YMin, box.ZMin], abs=3)
    assert outline.max(axis=0) == pytest.approx([box.XMax, box.YMax, box.ZMax], abs=3)
    arrows = machine.ViewObject.Proxy.arrows.shown
    texts = " ".join(a.text for a in arrows)
    offset = tree.axis_of(machine, "Z").AbbeOffset
    assert f"{offset.Length:.1f} mm" in texts and "Reference" in texts and "…" in texts
    lever = next(a for a in arrows if "Abbe" in a.text)
    assert np.subtract(lever.end, lever.start) == pytest.approx(tuple(offset))
    screenshot("linked")
    Gui.Selection.clearSelection()
    pump(30)
    assert machine.ViewObject.Proxy.arrows.shown == ()


def test_clicking_a_part_chooses_its_errors(machine, machine_doc):
    run("Sens_Sensitivity")
    where = tree.parts_of(machine, "Y")[0]
    leaf = pointers.paths.leaves(where)[0]
    Gui.Selection.addSelection(machine_doc.Name, leaf.root.Name, leaf.path + "Face1")
    pump(30)
    rows = [i.text(1) for i in review.dock().ranking.table.selectedItems()]
    assert sorted(rows) == ["C0Y", "EAY", "EBY", "ECY", "EXY", "EYY", "EZY"]
    assert any("Abbe" in a.text for a in machine.ViewObject.Proxy.arrows.shown)


def test_components_and_settings(machine, machine_doc):
    run("Sens_Sensitivity")
    dock = review.dock()
    result = tree.sensitivity_of(machine)
    assert [b[0] for b in dock.bars.blocks][0] == max(
        zip(np.add(result.ComponentFirst, result.ComponentTotal), result.Bodies)
    )[1]
    for block in dock.bars.blocks:  # the shares of its errors add to that of the component
        assert sum(v for _, v in block[6]) == pytest.approx(block[2], abs=1e-9)
    dock.tabs.setCurrentIndex(1)
    dock.bars.picked.emit("X")
    screenshot("components")
    dock.tabs.setCurrentIndex(3)
    dock.settings.objective.weights[2].setValue(0.0)
    dock.settings.compute()
    pump(50)
    assert extract.objective(machine).weights == (1.0, 1.0, 0.0) and not result.Stale
    dock.settings.automatic.setChecked(False)
    dock.settings.upper.setValue(0.9)
    pump(30)
    assert display.scale(result).upper == pytest.approx(0.9)
    dock.settings.colour_map.setCurrentIndex(1)
    screenshot("settings")
    assert display.scale(result).name == "cividis"
    dock.tabs.setCurrentIndex(0)


def test_what_if_changes_nothing_until_apply(machine, machine_doc):
    run("Sens_Sensitivity")
    before, undos = state(machine_doc), machine_doc.UndoCount
    dock = review.dock()
    tab = dock.what_if
    dock.tabs.setCurrentIndex(2)
    tab.change({"EAY": 0.5, "EBY": 0.0})
    screenshot("what-if")
    then = dict(zip(tab.then.symbols, tab.then.total))
    assert then["EBY"] == 0.0
    tab.keep()
    kept = tab.then.mean_square
    tab.change({"EAY": 2.0})
    tab.keep()
    assert [s.changes["EAY"] for s in tab.scenarios.kept] == [0.5, 2.0]
    tab.allowed.setValue(tab.scenarios.kept[0].size + 0.1)
    assert [tab.scenarios.topLevelItem(i).text(2) for i in range(2)] == ["passes", "fails"]
    screenshot("what-if-kept")
    tab.try_scenario(tab.scenarios.kept[0])
    assert tab.then.mean_square == pytest.approx(kept) and tab.changes == {"EAY": 0.5, "EBY": 0.0}
    tab.allowed.setValue(0.0)
    assert differences(before, state(machine_doc)) == [] and machine_doc.UndoCount == undos
    tab.apply_button.click()
    pump(60)
    result = tree.sensitivity_of(machine)
    assert dict(zip(result.Symbols, result.Total)) == pytest.approx(then, abs=1e-9)
    assert tables.read_tolerances(machine)["EAY"].upper == pytest.approx(10e-6)
    assert machine_doc.UndoCount == undos + 1
    machine_doc.undo()
    pump(200)
    assert differences(before, state(machine_doc)) == []
    dock.tabs.setCurrentIndex(0)


def test_a_scale_is_moved_in_mind_then_in_the_document(machine, machine_doc):
    run("Sens_Sensitivity")
    before, undos = state(machine_doc), machine_doc.UndoCount
    dock = review.dock()
    tab = dock.what_if
    dock.tabs.setCurrentIndex(2)
    axis = tree.axis_of(machine, "Y")
    reference, offset = App.Vector(axis.ReferencePoint), App.Vector(axis.AbbeOffset)
    tab.axis.setCurrentIndex(1)
    tab.shift[2].setValue(150.0)  # nearer to the tool
    then = dict(zip(tab.then.symbols, tab.then.total))
    result = tree.sensitivity_of(machine)
    assert then["EBY"] < dict(zip(result.Symbols, result.Total))["EBY"]  # a shorter arm, a smaller index
    assert "scale of Y moved by x 0.0   y 0.0   z 150.0 mm" in tab.summary.text()
    rows = [tab.table.topLevelItem(i) for i in range(tab.table.topLevelItemCount())]
    assert {r.text(0) for r in rows if r.text(1) == "scale moved"} == {s for s, o in zip(result.Symbols, result.Owners)
                                                                       if o == "Y"}  # fmt: skip
    screenshot("what-if-scale")
    tab.axis.setCurrentIndex(0)
    assert [b.value() for b in tab.shift] == [0.0, 0.0, 0.0]
    assert differences(before, state(machine_doc)) == [] and machine_doc.UndoCount == undos
    tab.apply_button.click()
    pump(60)
    assert tuple(axis.ReferenceOffset) == (0.0, 0.0, 150.0)
    assert axis.ReferencePoint - reference == App.Vector(0, 0, 150)
    assert axis.AbbeOffset - offset == App.Vector(0, 0, -150)
    assert told.words(axis.ReferenceFrom).endswith("moved")
    assert dict(zip(result.Symbols, result.Total)) == pytest.approx(then, abs=1e-9)
    assert machine_doc.UndoCount == undos + 1
    assert tab.moved == {} and not tab.apply_button.isEnabled()
    machine_doc.undo()
    pump(200)
    assert differences(before, state(machine_doc)) == []
    dock.tabs.setCurrentIndex(0)


def test_a_changed_tolerance_recolours_at_once(machine, machine_doc):
    run("Sens_Sensitivity")
    result = tree.sensitivity_of(machine)
    old = list(result.ComponentTotal)
    found = tables.read_tolerances(machine)
    machine_doc.openTransaction("edit")
    factory.set_tolerances(machine, found | {s: t.scaled(0.1) for s, t in found.items() if s in ("EAY", "EBY", "ECY")})
    machine.touch()
    machine_doc.recompute()
    machine_doc.commitTransaction()
    pump(200)
    assert not result.Stale
    assert list(result.ComponentTotal) != old


def test_live_can_be_switched_off(machine, machine_doc):
    run("Sens_Sensitivity")
    settings.put("Live", False)
    try:
        tree.axis_of(machine, "X").TravelUpper = 111.0
        machine_doc.recompute()
        pump(100)
        result = tree.sensitivity_of(machine)
        assert result.Stale
        assert "Out of date" in display.legend_text(machine, result).subtitle
    finally:
        settings.put("Live", True)


def test_error_map_of_points(machine, machine_doc):
    run("Sens_Sensitivity")
    undos = machine_doc.UndoCount
    run("Sens_ErrorMap")
    assert machine_doc.UndoCount == undos + 1
    result = tree.sensitivity_of(machine)
    drawn = result.ViewObject.Proxy.map
    assert drawn.shown and drawn.legend.shown
    _, scale, text = drawn.drawn
    assert text.unit == "µm" and "√E[Y]" in text.title
    assert scale.lower < 1e3 * np.sqrt(result.MeanSquare) < scale.upper  # the mean lies between the extremes
    screenshot("error-map")
    run("Sens_Sensitivity")
    assert drawn.shown  # it survives a computation
    run("Sens_ErrorMap")
    assert not drawn.shown and not drawn.legend.shown


def test_error_map_as_a_slice_that_slides(machine, machine_doc):
    run("Sens_Sensitivity")
    settings_tab = review.dock().settings
    review.dock().tabs.setCurrentIndex(3)
    view = tree.sensitivity_of(machine).ViewObject
    drawn = view.Proxy.map
    settings_tab.map.setChecked(True)
    settings_tab.map_as.setCurrentIndex(settings_tab.map_as.findData("Slice Z"))
    pump(30)
    assert view.ErrorMapAs == "Slice Z" and settings_tab.map_slider.isEnabled()
    expected = drawn.drawn[1].upper
    settings_tab.map_shows.setCurrentIndex(settings_tab.map_shows.findData("Upper estimate"))
    pump(30)
    assert drawn.drawn[1].upper > 1.2 * expected and "2√V(Y)" in drawn.drawn[2].title
    undos = machine_doc.UndoCount
    settings_tab.map_slider.setSliderDown(True)
    for step in (20, 60, 150):
        settings_tab.map_slider.setSliderPosition(step)
    axis = tree.axis_of(machine, "Z")
    low, high = axis.TravelLower.Value, axis.TravelUpper.Value
    wanted = low + (high - low) * 150 / 200
    heights = drawn.drawn[0][:, 2].tolist()
    tip = machine.FunctionalPoint.z
    assert heights == pytest.approx([tip + wanted] * len(heights), abs=0.1)
    assert machine_doc.UndoCount == undos  # nothing is written while it slides
    settings_tab.map_slider.setSliderDown(False)
    pump(30)
    assert view.ErrorMapAt.Value == pytest.approx(wanted, abs=0.1) and machine_doc.UndoCount == undos + 1
    screenshot("error-map-slice")
    settings_tab.map.setChecked(False)
    assert not drawn.shown
    review.dock().tabs.setCurrentIndex(0)


def test_preferences_show_and_store_what_the_code_uses(workbench):
    from sensworkbench.gui.preferences import PreferencePage, read_field

    page = PreferencePage()
    page.loadSettings()
    for name, field in page._fields.items():
        assert read_field(field) == settings.get(name) == settings.DEFAULTS[name], name
    page.order.setValue(6)
    page.saveSettings()
    assert settings.get("Order") == 6
    settings.put("Order", settings.DEFAULTS["Order"])


def test_every_preference_is_honoured(workbench):
    wanted = {
        "ColourMap": "cividis", "ColourBy": "Largest", "AutomaticRange": False, "RangeLower": 0.1, "RangeUpper": 0.7,
        "LegendCorner": "Lower right", "AngleUnit": "arcsec", "Aggregate": "grid", "Order": 6, "Grid": 4, "Live": False,
    }  # fmt: skip
    assert set(wanted) == set(settings.DEFAULTS)
    try:
        for name, value in wanted.items():
            settings.put(name, value)
        run("Sens_ExampleXYFZ")
        machine = tree.machine_of(App.ActiveDocument)
        assert (machine.Aggregate, machine.Order, machine.Grid) == ("grid", 6, 4)
        machine.Objective = told.objective_text(MeanSquare("orientation"))
        run("Sens_Sensitivity")
        run("Sens_ErrorMap")
        result = tree.sensitivity_of(machine)
        assert list(result.Points) == [4, 4, 4]
        scale = display.scale(result)
        assert (scale.lower, scale.upper, scale.name) == (0.1, 0.7, "cividis")
        assert display.values(result) == dict(zip(result.Bodies, result.ComponentTotalMax))
        proxy = result.ViewObject.Proxy
        assert proxy.legend._content[2] == "Lower right"
        assert proxy.map.drawn[2].unit == "″"
        mean = np.sqrt(result.MeanSquare) * 180 * 3600 / np.pi
        assert f"{mean:.3g} ″" in review.dock().head.text() and f"{mean:.3g} ″" in review.dock().what_if.summary.text()
        machine.Document.removeObject(tree.tolerances_of(machine).Name)
        panel = edit_tolerances(machine)
        assert panel.model.data(cell(panel, "EAX", UNIT)) == "″"
        click("Cancel")
        tree.axis_of(machine, "X").TravelUpper = 99.0
        machine.Document.recompute()
        pump(60)
        assert result.Stale
    finally:
        for name, value in settings.DEFAULTS.items():
            settings.put(name, value)
        for name in list(App.listDocuments()):
            App.closeDocument(name)


def test_the_review_is_readable_on_a_dark_theme(machine, machine_doc):
    from sensworkbench.gui.qt import QtGui, main_window

    application = QtGui.QApplication.instance()
    light, roles = QtGui.QPalette(application.palette()), QtGui.QPalette
    night = QtGui.QPalette(light)
    for role in (roles.Window, roles.Base, roles.AlternateBase, roles.Button):
        night.setColor(role, QtGui.QColor(42, 44, 48))
    for role in (roles.WindowText, roles.Text, roles.ButtonText):
        night.setColor(role, QtGui.QColor(230, 232, 235))
    application.setPalette(night)
    main_window().setStyleSheet("QWidget { background-color: #2a2c30; color: #e6e8eb }")  # how FreeCAD's themes do it
    try:
        run("Sens_Sensitivity")
        dock = review.dock()
        for tab in range(3):
            dock.tabs.setCurrentIndex(tab)
            screenshot(f"dark-{tab}")
            image = dock.tabs.currentWidget().grab().toImage()
            values = [QtGui.QColor(image.pixel(x, y)).value() for x in range(0, image.width(), 2)
                      for y in range(0, image.height(), 2)]  # fmt: skip
            assert sum(v < 90 for v in values) > 0.5 * len(values)  # a dark ground
            assert sum(v > 180 for v in values) > 200  # and light writing on it
        dock.tabs.setCurrentIndex(0)
    finally:
        main_window().setStyleSheet("")
        application.setPalette(light)


# -- the panel and its document ----------------------------------------------------------------------------------------
@pytest.mark.parametrize("command", ["Sens_Jog", "Sens_EditMachine", "Sens_Tolerances"])
def test_a_panel_is_closed_with_its_document(machine, machine_doc, command):
    run(command)
    App.closeDocument(machine_doc.Name)
    pump(100)
    assert not Gui.Control.activeDialog()


def test_the_trace_panel_is_closed_with_its_document(machine, machine_doc, tmp_path):
    rows = simulated.table(extract.core_machine(machine))
    closed_loop.make_readings(machine, simulated.write(tmp_path / "measured.csv", rows))
    run("Sens_Fit")
    App.closeDocument(machine_doc.Name)
    pump(100)
    assert not Gui.Control.activeDialog()


def test_another_documents_panel_stays_open(machine, machine_doc):
    other = App.newDocument("Other")
    App.setActiveDocument(machine_doc.Name)
    run("Sens_Tolerances")
    App.closeDocument(other.Name)
    pump(100)
    assert Gui.Control.activeDialog()
    click("Cancel")


@pytest.mark.parametrize("command", ["Sens_Jog", "Sens_EditMachine"])
def test_undo_ends_a_panel_that_holds_a_transaction(machine, machine_doc, command):
    run("Sens_Sensitivity")
    before = state(machine_doc)
    run(command)
    if command == "Sens_Jog":
        state_of(machine_doc).panel.go("X", 100.0)
        assert tree.axis_of(machine, "X").Position.Value == pytest.approx(100.0)
    else:
        machine.Squareness = "carried"
    machine_doc.undo()
    pump(200)
    assert not Gui.Control.activeDialog()
    assert differences(before, state(machine_doc)) == []


@pytest.mark.needs("panel-dock")
def test_a_panel_is_wide_enough_for_its_buttons(machine, machine_doc):
    from sensworkbench.gui.qt import Qt, QtGui, main_window

    docks = [d for d in main_window().findChildren(QtGui.QDockWidget) if d.objectName() == "Combo View"]
    main_window().resizeDocks(docks, [230], Qt.Horizontal)
    pump(50)
    run("Sens_Tolerances")
    pump(50)
    box = next(b for b in main_window().findChildren(QtGui.QDialogButtonBox) if b.isVisible())
    cancel = box.button(QtGui.QDialogButtonBox.Cancel)
    assert cancel.visibleRegion().boundingRect().width() == cancel.width()
    click("Cancel")


def test_the_legend_of_a_narrow_view_keeps_its_title(workbench):
    from dataclasses import replace

    from sensworkbench.gui.legend import Legend, LegendText, paint

    text = LegendText("Total index Sᵀ of the component", "", "squareness tilts the direction of motion (ISO 230-1)",
                      "no index", (("Axis X", 0.47), ("Spindle and tool", 0.02)), "Sᵀ")  # fmt: skip
    assert text.narrow().title.split() == text.title.split()
    forms = (text, text.narrow(), text.compact(), replace(text.compact(), marks=()))
    scale, legend, found = colormap.automatic([0.47, 0.02], "viridis"), Legend(), []
    legend.show(text, scale)
    for width in range(1400, 150, -25):
        legend._pixels = (width, 620)
        legend._repaint()
        sizes = [(image.width(), image.height()) for image in (paint(f, scale, legend._size) for f in forms)]
        first = next((i for i, size in enumerate(sizes) if size[0] <= width / 3), 3)
        assert legend.covers == sizes[first]  # as many words as a third of the view has room for
        found.append(first)
    assert {0, 1, 3} <= set(found)
