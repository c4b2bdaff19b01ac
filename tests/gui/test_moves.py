# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that says where to move what: the numbers of the study, arrows where a move helps, one click to apply."""

from __future__ import annotations

import numpy as np
import pytest

from sensworkbench.document import extract, studies, tree
from sensworkbench.formats import moves_json
from sensworkbench.gui import messages as window
from sensworkbench.gui import move_arrows, task_moves
from sensworkbench.gui.files import RESOURCES
from sensworkbench.gui.qt import pump
from sensworkbench.gui.task_study import KEY
from sensworkbench.studies.moves import TOOL, mean_square, moved, moves_study

from .conftest import close_messages, differences, messages, screenshot, state, study


@pytest.fixture
def panel(machine, machine_doc):
    with study(task_moves.open_panel, machine) as made:
        yield made


def choose(panel, tab: int, key):
    panel.tabs.setCurrentIndex(tab)
    view = panel.tabs.widget(tab)
    view.clearSelection()
    item = next(i for i in rows(view) if i.data(0, KEY) == key)
    item.setSelected(True)
    view.scrollToItem(item)
    pump(30)
    return item


def rows(view):
    return [view.topLevelItem(i) for i in range(view.topLevelItemCount())]


def test_it_shows_what_the_study_finds_and_the_document_keeps_it(panel, machine, machine_doc):
    undos = machine_doc.UndoCount
    assert panel.compute()
    known = moves_json.to_dict(moves_study(extract.core_machine(machine), 50.0))
    shown = {i.data(0, KEY): i for i in rows(panel.slopes)}
    for point in known["points"]:
        for letter in "xyz":
            slope = point["per_mm"][letter]["percent"]
            assert shown[(point["name"], letter)].text(task_moves.PERCENT).replace("−", "-") in (
                f"{-abs(slope):.3f}", "0.000")  # fmt: skip
            if abs(slope) > 1e-3:
                assert shown[(point["name"], letter)].text(task_moves.WAY) == ("−" if slope > 0 else "+") + letter
    best = {i.data(0, KEY): i for i in rows(panel.best)}
    for point in known["points"]:
        assert best[point["name"]].text(4) == f"{point['best_rms_um']:.2f}"
    assert len(rows(panel.orders)) == 24
    assert machine_doc.UndoCount == undos + 1  # the study is one undo step
    obj = studies.study_of(machine, "moves")
    assert obj in machine.Group and not obj.Stale and studies.read(obj)[1] == panel.data
    panel.slopes.clearSelection()
    pump(50)
    screenshot("moves")
    choose(panel, 0, ("Y", "z"))
    screenshot("moves-slope")
    choose(panel, 1, task_moves.ALL)
    screenshot("moves-best")


def test_the_arrows_point_where_a_move_helps(panel, machine):
    panel.compute()
    arrows = machine.ViewObject.Proxy.arrows.shown
    assert len(arrows) >= 4
    core = extract.core_machine(machine)
    where = move_arrows.places(machine)
    for point in panel.data["points"]:
        at = tuple(where[point["name"]][0])
        arrow = next((a for a in arrows if a.start == at and a.end != at), None)
        if arrow is None:
            continue
        way = np.subtract(arrow.end, arrow.start)
        step = way / np.linalg.norm(way)
        assert mean_square(moved(core, {point["name"]: step})) < mean_square(core)
    choose(panel, 0, ("Z", "y"))
    (one,) = machine.ViewObject.Proxy.arrows.shown
    assert one.start == tuple(where["Z"][0]) and np.count_nonzero(np.subtract(one.end, one.start)) == 1
    choose(panel, 1, "Z")
    assert len(machine.ViewObject.Proxy.arrows.outlined) == 12  # the edges of the box
    panel.close()
    assert not machine.ViewObject.Proxy.arrows.shown and not machine.ViewObject.Proxy.arrows.outlined


def test_one_click_moves_a_reference_point_and_one_puts_it_back(panel, machine, machine_doc):
    for box, value in zip(panel.sides, (0, 0, 30)):
        box.setValue(value)
    panel.compute()
    choose(panel, 1, "Z")
    before, undos = state(machine_doc), machine_doc.UndoCount
    known = {p["name"]: p for p in panel.data["points"]}["Z"]
    assert known["best_move_mm"][:2] == [0, 0] and abs(known["best_move_mm"][2]) == 30
    panel.apply_button.click()
    pump(60)
    assert machine_doc.UndoCount == undos + 1
    assert tuple(tree.axis_of(machine, "Z").ReferenceOffset) == pytest.approx(known["best_move_mm"])
    assert tree.sensitivity_of(machine).MeanSquare * 1e6 == pytest.approx(known["best_rms_um"] ** 2, rel=1e-9)
    assert studies.study_of(machine, "moves").Stale and "changed since" in panel.summary.text()
    panel.undo_button.click()
    pump(100)
    assert differences(before, state(machine_doc)) == []
    assert not studies.study_of(machine, "moves").Stale and "changed since" not in panel.summary.text()


def test_what_the_document_cannot_hold_is_said(panel, machine, machine_doc):
    panel.compute()
    before = state(machine_doc)
    for tab, key, words in ((1, TOOL, "takes this point from a part"), (2, "FXYZ", "Edit Machine")):
        choose(panel, tab, key)
        panel.apply()
        assert words in messages()[-1]
        close_messages()
    assert differences(before, state(machine_doc)) == []


def test_prices_give_a_move_its_worth(panel, monkeypatch, tmp_path):
    panel.compute()
    assert panel.slopes.isColumnHidden(task_moves.WORTH)
    panel.load_costs(f"{RESOURCES}/examples/costs.csv")
    panel.compute()
    assert not panel.slopes.isColumnHidden(task_moves.WORTH) and "cost least" in panel.summary.text()
    monkeypatch.setattr(window, "ask_folder", lambda _title: str(tmp_path))
    assert {p.name for p in panel.ask_report()} == {"moves.json", "moves.csv", "report.html"}
    close_messages()


def test_a_panel_that_is_opened_again_shows_what_was_found(panel, machine):
    panel.compute()
    shown = panel.summary.text()
    panel.close()
    pump(60)
    again = task_moves.open_panel(machine)
    pump(60)
    assert again.summary.text() == shown and again.found is None and len(rows(again.orders)) == 24
    again.sides[0].setValue(12)  # another question
    assert again.data is None and not rows(again.best)


def test_cancelling_leaves_nothing(panel, machine, machine_doc, monkeypatch):
    before = state(machine_doc)

    def cancelled(function, title):
        function(lambda part: False)

    monkeypatch.setattr(task_moves.StudyPanel.compute.__globals__["live"], "in_background", cancelled)
    assert not panel.compute()
    assert differences(before, state(machine_doc)) == [] and "ancel" in panel.summary.text()
