# SPDX-License-Identifier: LGPL-2.1-or-later
"""A lathe of two axes in the window: panels, review, colours and map are those of its own axes."""

from __future__ import annotations

import numpy as np
import pytest

from sensworkbench.document import extract, factory, results, tree
from sensworkbench.gui import errormap, pointers, residuals, review, texts
from sensworkbench.gui.qt import pump
from sensworkbench.gui.task_jog import TaskJog
from sensworkbench.gui.task_machine import TaskMachine
from sensworkbench.gui.task_tolerances import TaskTolerances
from tests.document.test_other_machines import lathe_of


@pytest.fixture
def lathe(doc):
    machine = lathe_of(doc)
    results.compute(machine)
    return machine


def test_the_jog_panel_moves_both_axes(lathe):
    panel = TaskJog(lathe)
    assert list(panel.sliders) == ["X", "Z"]
    panel.go("Z", 40.0)
    assert lathe.Document.getObject("SlideX").Placement.Base.z == pytest.approx(90 + 40)
    rows = [panel.table.item(i, 0).text() for i in range(panel.table.rowCount())]
    assert rows == ["Axis X", "Axis Z", "Spindle and tool", "Workpiece and fixture"]
    assert panel.table.item(0, 5).text() not in ("", "–")
    panel.go_home()
    assert extract.current_position(lathe).tolist() == [0, 0]
    panel.leave()
    lathe.Document.abortTransaction()


def test_the_tolerance_panel_lists_the_errors_of_its_axes_and_writes_them(lathe):
    panel = TaskTolerances(lathe)
    symbols = [row.symbol for row in panel.model.rows]
    assert set(symbols) == {c.symbol for c in extract.core_machine(lathe).components}
    row = panel.model.rows[symbols.index("EXZ")]
    row.enter(2, "12.5")
    tolerances, units = panel.model.result()
    factory.set_tolerances(lathe, tolerances, units)
    assert extract.core_machine(lathe).tolerances["EXZ"].upper == pytest.approx(0.0125)
    panel.leave()


def test_the_machine_panel_shows_its_components(lathe):
    panel = TaskMachine(lathe, "Z")
    assert panel.bodies == ("F", "X", "Z", "T", "W")
    assert panel.structure.itemData(panel.structure.currentIndex()) == "FZX"
    assert panel.note.text() == "" and "Abbe" in panel.found.text()
    pointers.clear(lathe)


def test_the_review_shows_it(lathe):
    shown = review.show(lathe)
    pump(200)
    try:
        assert [shown.settings.at[i].prefix() for i in (0, 1)] == ["X ", "Z "]
        assert not any(box.isVisibleTo(shown.settings) for box in shown.settings.at[2:])
        assert [shown.what_if.axis.itemData(i) for i in range(shown.what_if.axis.count())] == ["X", "Z"]
        shown.what_if.move_scale("Z", (0.0, 50.0, 0.0))
        shown.what_if.reset()
        assert texts.positions_text(tree.sensitivity_of(lathe)) == "Over the workspace, 8×8 positions"
        lathe.Aggregate, lathe.At = "at", [10.0, 20.0]
        assert texts.positions_text(results.compute(lathe)) == "At X 10, Z 20 mm"
    finally:
        review.hide()


def test_the_review_offers_the_slices_of_its_axes(lathe):
    shown = review.show(lathe)
    pump(100)
    try:
        offered = [shown.settings.map_as.itemText(i) for i in range(shown.settings.map_as.count())]
        assert offered == ["Points", "Slice at X", "Slice at Z"]
        shown.settings.map.setChecked(True)
        shown.settings.map_as.setCurrentIndex(2)
        pump(60)
        view = tree.sensitivity_of(lathe).ViewObject
        assert view.ErrorMapAs == "Slice Z" and shown.settings.map_slider.isEnabled()
    finally:
        review.hide()


def test_arrows_places_and_the_map_are_those_of_its_axes(lathe):
    found = pointers.arrows(lathe, ["X", "Z", "T"])
    assert len(found) >= 6
    core = extract.core_machine(lathe)
    assert errormap.positions(core).shape[1] == 2
    where = residuals.places(core, [[5.0, 7.0]])
    assert where.tolist() == [[45.0, 0.0, 17.0]]
    drawn = tree.sensitivity_of(lathe).ViewObject.Proxy.map
    drawn.show(lathe, "viridis", "Upper left", form="Slice Y")  # it has no such axis: points
    assert drawn.shown and len(drawn.drawn[0]) == 49
    drawn.show(lathe, "viridis", "Upper left", form="Slice X", at=10.0)
    places, scale, text = drawn.drawn
    assert len(places) == 25 and np.ptp(places[:, 0]) < 1e-3 and "X = 10.0 mm" in text.note
    assert scale.lower < scale.upper
    drawn.hide()
