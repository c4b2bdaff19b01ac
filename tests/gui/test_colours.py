# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parts take the colour of their component's total index, in the object and in the picture, and get theirs back."""

from __future__ import annotations

import colorsys
import os
import shutil
import zipfile

import FreeCAD as App
import pytest

from sensworkbench.document import factory, tree
from sensworkbench.gui import colours, display
from sensworkbench.gui.colormap import MAPS, NO_DATA, Scale, automatic, colour
from sensworkbench.gui.qt import QtGui, pump

from .conftest import differences, look, picture, run, state


def result_of(doc):
    return tree.sensitivity_of(tree.machine_of(doc))


def hues(image) -> list[int]:
    """How many clearly coloured pixels have each hue in degrees."""
    count = [0] * 360
    for x in range(0, image.width(), 3):
        for y in range(0, image.height(), 3):
            c = QtGui.QColor(image.pixel(x, y))
            if c.saturation() > 60 and 40 < c.value():
                count[c.hue() % 360] += 1
    return count


def near(count, rgb, width=9) -> int:
    """Pixels whose hue is within `width` degrees of a colour's."""
    hue = int(colorsys.rgb_to_hsv(*rgb)[0] * 360)
    return sum(count[(hue + d) % 360] for d in range(-width, width + 1))


def test_every_part_has_the_colour_of_its_component(machine, machine_doc):
    doc = machine_doc
    run("Sens_Sensitivity")
    result = result_of(doc)
    values, scale = display.values(result), display.scale(result)
    assert set(values) == {"X", "Y", "Z", "T"}
    for body, group in colours.targets(machine).items():
        assert group, body
        wanted = scale.colour(values[body]) if body in values else NO_DATA
        for target in group:
            shown = colours.shown_colour(target.obj)
            assert shown == pytest.approx(wanted, abs=0.005), target.obj.Label


def test_the_saved_picture_shows_these_colours(machine, machine_doc):
    doc = machine_doc
    before = hues(picture(doc))
    run("Sens_Sensitivity")
    result = result_of(doc)
    result.ViewObject.ShowLegend = False
    after = hues(picture(doc))
    values, scale = display.values(result), display.scale(result)
    for body in ("X", "Y", "Z"):
        rgb = scale.colour(values[body])
        assert near(after, rgb) > near(before, rgb) + 50, (body, near(before, rgb), near(after, rgb))


def test_undo_redo_and_original_colours(machine, machine_doc):
    doc = machine_doc
    face_by_face = next(t.obj for t in colours.targets(machine)["X"] if len(t.obj.Shape.Faces) > 3)
    count = len(face_by_face.Shape.Faces)
    face_by_face.ViewObject.DiffuseColor = [(1.0, i / count, 0.0) for i in range(count)]
    pump(20)
    before = state(doc)
    run("Sens_Sensitivity")
    coloured = state(doc)
    assert differences(before, coloured)
    doc.undo()
    pump(60)
    assert differences(before, state(doc)) == []
    doc.redo()
    pump(60)
    assert [d for d in differences(coloured, state(doc)) if "look" in d] == []
    run("Sens_OriginalColours")
    looks = [d for d in differences(before, state(doc)) if ".look" in d]
    assert looks == []
    assert not result_of(doc).Coloured
    doc.undo()
    pump(60)
    assert [d for d in differences(coloured, state(doc)) if ".look" in d] == []


def test_everything_is_there_after_closing_and_reopening(machine, machine_doc, tmp_path):
    doc = machine_doc
    before = {t.obj.Name: colours.read(t.obj) for g in colours.targets(machine).values() for t in g}
    run("Sens_Sensitivity")
    shown = {n: colours.shown_colour(doc.getObject(n)) for n in before}
    path = str(tmp_path / "machine.FCStd")
    doc.saveAs(path)
    App.closeDocument(doc.Name)
    again = App.openDocument(path)
    pump(150)
    for name, rgb in shown.items():
        assert colours.shown_colour(again.getObject(name)) == pytest.approx(rgb, abs=0.01), name
    result = result_of(again)
    assert result.ViewObject.Proxy.legend.shown
    run("Sens_OriginalColours")
    for name, data in before.items():
        now = colours.read(again.getObject(name))
        assert now["colour"] == pytest.approx(data["colour"], abs=0.005), name


def test_a_document_computed_without_a_window_shows_its_colours(machine, machine_doc, tmp_path):
    doc = machine_doc
    from sensworkbench.document import results

    results.compute(machine)
    result = result_of(doc)
    result.Coloured = True
    machine.ViewPending = True
    machine.PartColours = {t.obj.Name: "#336699" for t in colours.targets(machine)["X"]}
    path, bare = str(tmp_path / "full.FCStd"), str(tmp_path / "bare.FCStd")
    doc.saveAs(path)
    App.closeDocument(doc.Name)
    with zipfile.ZipFile(path) as source, zipfile.ZipFile(bare, "w") as target:
        for entry in source.infolist():  # what freecadcmd leaves out
            if not entry.filename.startswith(
                ("GuiDocument", "ShapeAppearance", "DiffuseColor", "LineColor", "PointColor")
            ):
                target.writestr(entry, source.read(entry.filename))
    again = App.openDocument(bare)
    pump(200)
    machine = tree.machine_of(again)
    result = result_of(again)
    values, scale = display.values(result), display.scale(result)
    for body in ("X", "Y", "Z"):
        for target in colours.targets(machine)[body]:
            assert target.obj.ViewObject.Visibility, target.obj.Label
            wanted = scale.colour(values[body])
            assert colours.shown_colour(target.obj) == pytest.approx(wanted, abs=0.01), target.obj.Label
    assert result.ViewObject.Proxy.legend.shown and result.ViewObject.Visibility
    assert not machine.ViewPending
    run("Sens_OriginalColours")
    for target in colours.targets(machine)["X"]:
        assert colours.shown_colour(target.obj) == pytest.approx((0.2, 0.4, 0.6), abs=0.005)
    shutil.rmtree(tmp_path, ignore_errors=True)


@pytest.mark.parametrize("background", ["White", "Black"])
def test_the_legend_stands_in_the_saved_picture(machine, machine_doc, background):
    doc = machine_doc
    run("Sens_Sensitivity")
    result = result_of(doc)
    with_legend = picture(doc, background=background)
    result.ViewObject.ShowLegend = False
    pump(30)
    without = picture(doc, background=background)

    def pale(image):
        """Pixels of the legend's plate in the upper left quarter."""
        total = 0
        for x in range(0, image.width() // 3, 2):
            for y in range(0, image.height() // 2, 2):
                c = QtGui.QColor(image.pixel(x, y))
                total += 200 < c.red() < 253 and abs(c.red() - c.blue()) < 12
        return total

    assert pale(with_legend) > pale(without) + 1000
    scale = display.scale(result)
    bar = hues(with_legend)
    for fraction in (0.05, 0.5, 0.98):
        assert near(bar, colour(fraction, scale.name), 12) > 5


def test_the_legend_is_redrawn_larger_for_a_large_picture(machine, machine_doc):
    doc = machine_doc
    run("Sens_Sensitivity")
    legend = result_of(doc).ViewObject.Proxy.legend
    picture(doc, 800, 600)
    small = legend._size
    picture(doc, 2000, 1520)
    assert legend._size > 1.5 * small


@pytest.mark.parametrize("width, height", [(1200, 800), (700, 800), (420, 800), (300, 500)])
@pytest.mark.parametrize("corner", ["Upper left", "Upper right"])
def test_the_legend_leaves_room_for_the_model_and_the_navigation_cube(machine, machine_doc, width, height, corner):
    run("Sens_Sensitivity")
    result = result_of(machine_doc)
    result.ViewObject.LegendCorner = corner
    result.ViewObject.ShowErrorMap = True
    pump(30)
    picture(machine_doc, width, height)
    for legend in (result.ViewObject.Proxy.legend, result.ViewObject.Proxy.map.legend):
        assert legend._pixels == (width, height)
        assert legend.covers[0] <= width / 3 + 1 and legend.covers[0] * legend.covers[1] < width * height / 3
    top = (1 - result.ViewObject.Proxy.legend._place.translation.getValue()[1]) / 2 * height
    assert (top > 132) == (corner == "Upper right")


def test_a_manual_range_sticks(machine, machine_doc):
    doc = machine_doc
    run("Sens_Sensitivity")
    view = result_of(doc).ViewObject
    view.AutomaticRange = False
    view.RangeLower, view.RangeUpper = 0.1, 0.9
    run("Sens_Sensitivity")
    scale = display.scale(result_of(doc))
    assert (scale.lower, scale.upper) == (0.1, 0.9)


def test_a_link_is_coloured_alone_and_restored(doc, workbench):
    from sensworkbench.core.machine import structure_chains

    workpiece, tool = structure_chains("XYFZ")
    box = doc.addObject("Part::Box", "Box")
    links = {}
    for i, name in enumerate("XYZ"):
        link = doc.addObject("App::Link", f"Copy{name}")
        link.LinkedObject = box
        link.Placement.Base = App.Vector(50 * (i + 1), 20 * i, 10)
        links[name] = link
    machine = factory.make_machine(doc, workpiece, tool, tool_point=box)
    for name, link in links.items():
        factory.make_axis(machine, name, [link])
    doc.recompute()
    look(doc)
    own = colours.read(box)
    before = {n: colours.read(link) for n, link in links.items()}
    run("Sens_Sensitivity")
    result = result_of(doc)
    values, scale = display.values(result), display.scale(result)
    for name, link in links.items():
        assert link.ViewObject.OverrideMaterial
        assert colours.shown_colour(link) == pytest.approx(scale.colour(values[name]), abs=0.005)
    assert colours.read(box) == own
    run("Sens_OriginalColours")
    assert {n: colours.read(link) for n, link in links.items()} == before


def test_deleting_the_result_gives_the_colours_back(machine, machine_doc):
    doc = machine_doc
    before = {t.obj.Name: colours.read(t.obj) for g in colours.targets(machine).values() for t in g}
    run("Sens_Sensitivity")
    import FreeCADGui as Gui

    result = result_of(doc)
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(result)
    run("Std_Delete")
    assert tree.sensitivity_of(machine) is None
    for name, data in before.items():
        assert colours.read(doc.getObject(name))["colour"] == pytest.approx(data["colour"], abs=0.005)


def test_colour_maps():
    for name in MAPS:
        light = [0.2126 * r + 0.7152 * g + 0.0722 * b for r, g, b in (colour(i / 50, name) for i in range(51))]
        assert all(b > a - 1e-9 for a, b in zip(light, light[1:])), name  # readable without colour vision, too
    assert colour(float("nan")) == NO_DATA == colour(None)
    assert colour(-1.0) == colour(0.0) and colour(2.0) == colour(1.0)
    assert Scale(0.3, 0.3).colour(0.3) == colour(0.5)
    assert automatic([0.41, 0.2]) == Scale(0.0, 0.5) and automatic([]) == Scale(0.0, 1.0)
    assert Scale(0.0, 0.5).ticks()[0] == 0.0 and Scale(0.0, 0.5).ticks()[-1] == 0.5


def test_a_picture_can_be_saved_from_any_folder(machine, tmp_path):
    from sensworkbench.gui import export

    run("Sens_Sensitivity")
    paths = export.export(machine, tmp_path / "report")
    assert {p.name for p in paths} == {"report.html", "sensitivity.json", "sensitivity.csv", "view.png"}
    assert all(os.path.getsize(p) > 200 for p in paths)
    assert "data:image/png" in (tmp_path / "report" / "report.html").read_text(encoding="utf-8")


def test_what_is_posted_comes_before_a_picture_that_was_asked_for_earlier(workbench):
    from sensworkbench.gui.qt import soon

    order = []

    class Watched(QtGui.QWidget):
        def paintEvent(self, _event):
            order.append("painted")

    window = Watched()
    window.resize(120, 80)
    window.show()
    pump(200)
    assert order
    order.clear()
    window.update()
    soon(lambda: order.append("posted"))
    pump(100)
    window.close()
    assert order == ["posted", "painted"]
