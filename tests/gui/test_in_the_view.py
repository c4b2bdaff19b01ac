# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mouse in the 3D view, as real events to its window: a legend is dragged, a place of the error map is read."""

from __future__ import annotations

import numpy as np
import pytest

from sensworkbench.core import workspace
from sensworkbench.document import extract, tree
from sensworkbench.gui import display, review
from sensworkbench.gui.qt import Qt, QtCore, QtGui, main_window, pump

from .conftest import look, run, screenshot


def viewport():
    """The widget that FreeCAD draws the scene into and takes mouse events from."""
    import FreeCADGui as Gui

    sub = main_window().centralWidget().activeSubWindow()
    view = Gui.activeDocument().activeView()
    found = [w for w in sub.findChildren(QtGui.QWidget) if "OpenGL" in w.metaObject().className()]
    found = found or [w for w in sub.findChildren(QtGui.QAbstractScrollArea)]
    widget = max(found, key=lambda w: w.width() * w.height())
    return getattr(widget, "viewport", lambda: widget)() if hasattr(widget, "viewport") else widget, view.getSize()


def mouse(widget, kind, x, y, size, button, buttons):
    """One event at pixels from the lower left of the view, as Coin counts them."""
    ratio = size[0] / widget.width()
    local = QtCore.QPointF(x / ratio, widget.height() - 1 - y / ratio)
    at = QtCore.QPointF(widget.mapToGlobal(local.toPoint()))
    event = QtGui.QMouseEvent(kind, local, at, button, buttons, Qt.NoModifier)
    QtGui.QApplication.sendEvent(widget, event)
    pump(10)


def press(x, y, *way):
    """Press at a place, move along `way`, let go at its end."""
    widget, size = viewport()
    kinds = QtCore.QEvent
    mouse(widget, kinds.MouseMove, x, y, size, Qt.NoButton, Qt.NoButton)
    mouse(widget, kinds.MouseButtonPress, x, y, size, Qt.LeftButton, Qt.LeftButton)
    for x, y in way:
        mouse(widget, kinds.MouseMove, x, y, size, Qt.NoButton, Qt.LeftButton)
    mouse(widget, kinds.MouseButtonRelease, x, y, size, Qt.LeftButton, Qt.NoButton)


@pytest.fixture
def result(machine, machine_doc):
    run("Sens_Sensitivity")
    review.hide()
    pump(100)
    look(machine_doc)
    pump(200)
    return tree.sensitivity_of(machine)


def test_the_legend_is_dragged_and_a_click_puts_it_back(result):
    legend = result.ViewObject.Proxy.legend
    before = legend.box()
    x, y = (before[0] + before[2]) / 2, (before[1] + before[3]) / 2
    press(x, y, (x + 40, y - 30), (x + 120, y - 90))
    after = legend.box()
    screenshot("legend-dragged")
    assert np.allclose(np.subtract(after, before), [120, -90, 120, -90], atol=2)
    assert tuple(result.ViewObject.LegendPlace)[:2] == pytest.approx(legend.offset)
    display.update(result)
    assert legend.box() == pytest.approx(after)
    press((after[0] + after[2]) / 2, (after[1] + after[3]) / 2)
    assert legend.box() == pytest.approx(before) and tuple(result.ViewObject.LegendPlace)[:2] == (0, 0)


def test_no_part_of_the_legend_leaves_the_view(result):
    legend = result.ViewObject.Proxy.legend
    box = legend.box()
    x, y = (box[0] + box[2]) / 2, (box[1] + box[3]) / 2
    press(x, y, (x - 3000, y + 3000))
    left, _, _, high = legend.box()
    assert left == pytest.approx(0, abs=1) and high == pytest.approx(legend._pixels[1], abs=1)


def test_a_click_beside_the_legend_moves_it_not(result):
    legend = result.ViewObject.Proxy.legend
    box = legend.box()
    press(box[2] + 30, box[1] - 30, (box[2] + 90, box[1] - 60))
    assert legend.box() == pytest.approx(box)


@pytest.mark.parametrize("form", ["Points", "Slice Z"])
def test_a_click_on_the_error_map_says_position_and_error(machine, result, form):
    view = result.ViewObject
    view.ErrorMapAs, view.ShowErrorMap = form, True
    pump(300)
    drawn = view.Proxy.map
    places = drawn.drawn[0]
    size = viewport()[1]
    scene = np.array([look(machine.Document).getPointOnScreen(*map(float, p)) for p in places])
    pump(100)
    middle = int(np.argmin(np.hypot(scene[:, 0] - size[0] / 2, scene[:, 1] - size[1] / 2)))
    press(*map(float, scene[middle]))
    screenshot("error-map-picked-" + form.replace(" ", "-"))
    assert drawn.picked is not None and len(drawn.mark.shown) == 1
    core = extract.core_machine(machine)
    q = [drawn.picked[name] for name in core.names]
    found = workspace.sensitivity(core, workspace.at(core, q), extract.objective(machine), estimate=False)
    error = 1000 * np.sqrt(found.mean_square)
    assert f"{error:.1f} µm" in drawn.mark.shown[0].text
    at = core.tool_position([q])[0]
    where = look(machine.Document).getPointOnScreen(*map(float, at))
    assert np.hypot(*np.subtract(where, scene[middle])) < 20
    view.ShowErrorMap = False
    pump(100)
    assert drawn.picked is None and drawn.mark.shown == ()
