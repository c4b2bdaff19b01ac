# SPDX-License-Identifier: LGPL-2.1-or-later
"""With several documents open the review and its buttons belong to the one in front; pictures show index colours."""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui
import pytest

from sensworkbench.document import tree
from sensworkbench.document.examples import make_example
from sensworkbench.gui import colours, display, export, review, state
from sensworkbench.gui import messages as window
from sensworkbench.gui.qt import QtGui, pump

from .conftest import look, picture, run


@pytest.fixture
def two(machine):
    """The machine, reviewed, and another one whose document was made after it and stands in front."""
    run("Sens_Sensitivity")
    other = App.newDocument("mill")
    other.UndoMode = 1
    mill = make_example(other, "FXYZ")
    other.recompute()
    look(other)
    pump(100)
    return machine, mill


def button(name: str):
    return review.dock().findChild(QtGui.QPushButton, name)


def test_the_review_follows_the_document_in_front(two):
    machine, mill = two
    dock = review.dock()
    assert App.ActiveDocument == mill.Document
    assert dock.machine == mill and mill.Document.Label in dock.head.text()
    App.setActiveDocument(machine.Document.Name)
    pump(50)
    assert dock.machine == machine and machine.Document.Label in dock.head.text()
    assert len(dock.ranking.items()) == 24
    App.newDocument("Empty")
    pump(50)
    assert dock.machine is None and "No machine" in dock.head.text()


def test_the_machine_reviewed_last_in_a_document_is_shown_again(two):
    machine, mill = two
    second = make_example(mill.Document, "YFXZ")
    mill.Document.recompute()
    review.show(second)
    App.setActiveDocument(machine.Document.Name)
    pump(50)
    App.setActiveDocument(mill.Document.Name)
    pump(50)
    assert review.dock().machine == second


def test_the_buttons_work_on_the_machine_that_is_shown(two, monkeypatch, tmp_path):
    machine, mill = two
    dock = review.dock()
    run("Sens_Sensitivity")
    assert dock.machine == mill
    App.setActiveDocument(machine.Document.Name)
    pump(50)
    App.setActiveDocument(mill.Document.Name)  # the review has not turned yet: what it shows is what is meant
    written = []
    monkeypatch.setattr(window, "ask_folder", lambda _title: str(tmp_path))
    monkeypatch.setattr(export, "export", lambda chosen, folder: written.append(chosen) or [])
    assert dock.machine == machine
    button("Sens_Report").click()
    assert written == [machine] and App.ActiveDocument == machine.Document
    button("Sens_OriginalColours").click()
    pump(50)
    assert not tree.sensitivity_of(machine).Coloured and tree.sensitivity_of(mill).Coloured


def test_what_if_leaves_other_documents_alone(two):
    machine, mill = two
    App.setActiveDocument(machine.Document.Name)
    pump(50)
    undos = mill.Document.UndoCount
    tab = review.dock().what_if
    tab.change({"EAY": 0.5})
    tab.apply_button.click()
    pump(60)
    assert mill.Document.UndoCount == undos and machine.Document.UndoNames[0] == "Apply what-if"


def pixels(image):
    return bytes(image.convertToFormat(QtGui.QImage.Format_RGB32).constBits())


def test_a_picture_shows_index_colours_whatever_is_selected(machine, machine_doc):
    run("Sens_Sensitivity")
    look(machine_doc)
    plain = export.picture(machine_doc, 500, 400)
    with state.quietly(machine_doc):  # without the arrows that a click draws
        for body in "FXYZTW":
            for where in tree.parts_of(machine, body):
                Gui.Selection.addSelection(machine_doc.Name, where.root.Name, where.path)
    pump(50)
    chosen = [(s.Object.Name, s.SubElementNames) for s in Gui.Selection.getSelectionEx("", 0)]
    selected = export.picture(machine_doc, 500, 400)
    first, second = QtGui.QImage.fromData(plain), QtGui.QImage.fromData(selected)
    count = sum(a != b for a, b in zip(pixels(first), pixels(second)))
    assert count < 0.005 * len(pixels(first))  # two pictures of the same differ in a few points of their edges
    assert [(s.Object.Name, s.SubElementNames) for s in Gui.Selection.getSelectionEx("", 0)] == chosen


def coloured(image, colour) -> int:
    """How many points of a picture have the hue of a colour."""
    hue, count = QtGui.QColor.fromRgbF(*colour).hue(), 0
    for x in range(0, image.width(), 3):
        for y in range(0, image.height(), 3):
            pixel = image.pixelColor(x, y)
            count += pixel.saturation() > 60 and abs(pixel.hue() - hue) < 12
    return count


def test_asking_why_keeps_the_colour_of_the_index(machine, machine_doc):
    run("Sens_Sensitivity")
    dock = review.dock()
    result = tree.sensitivity_of(machine)
    wanted = display.scale(result).colour(display.values(result)["Z"])
    before = coloured(picture(machine_doc), wanted)
    dock.ranking.table.setCurrentItem(next(i for i in dock.ranking.items() if i.text(1) == "EAZ"))
    pump(30)
    arrows = machine.ViewObject.Proxy.arrows
    assert arrows.outlined and arrows.shown
    assert [o.Name for o in Gui.Selection.getSelection()] == [tree.axis_of(machine, "Z").Name]
    for target in colours.targets(machine)["Z"]:
        assert colours.shown_colour(target.obj) == pytest.approx(wanted, abs=0.01)
    assert coloured(picture(machine_doc), wanted) > 0.6 * before
    assert [i.text(1) for i in dock.ranking.table.selectedItems()] == ["EAZ"]
    Gui.Selection.clearSelection()
    pump(30)
    assert arrows.outlined == () and arrows.shown == ()


def test_the_state_of_a_document_goes_with_it(machine, machine_doc):
    run("Sens_Sensitivity")
    name = machine_doc.Name
    assert state.of(name).reviewed == machine.Name
    App.closeDocument(name)
    pump(30)
    assert state.of(name).reviewed == ""
