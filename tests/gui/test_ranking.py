# SPDX-License-Identifier: LGPL-2.1-or-later
"""The ranking follows a change in place: same rows, new values, what was chosen and where it was scrolled kept."""

from __future__ import annotations

import pytest

from sensworkbench.document import factory, tables, tree
from sensworkbench.gui import ranking, review
from sensworkbench.gui.qt import Qt, pump

from .conftest import run


def widen(machine, **factors):
    """Other tolerances, computed and shown."""
    table = tables.read_tolerances(machine)
    factory.set_tolerances(machine, table | {s: table[s].scaled(f) for s, f in factors.items()})
    machine.touch()
    machine.Document.recompute()
    pump(60)


def contents(shown):
    """Everything that the rows show, from top to bottom; of icons the colour."""
    rows = []
    for item in shown.items():
        values = [item.data(column, role) for column, role in ranking.PLACES if role != Qt.DecorationRole]
        rows.append([*values, item.icon(ranking.OWNER).pixmap(12, 12).toImage().pixel(6, 6)])
    return rows


@pytest.fixture
def shown(machine):
    run("Sens_Sensitivity")
    return review.dock().ranking


def test_values_written_in_place_are_those_of_a_new_table(machine, shown):
    before = contents(shown)
    for factors in ({"EAY": 0.3}, {"EAY": 10.0, "EXX": 4.0}):
        widen(machine, **factors)
        fresh = ranking.Ranking()
        fresh.show_result(machine, tree.sensitivity_of(machine))
        assert contents(shown) == contents(fresh) != before
        before = contents(shown)


def test_rows_stay_chosen_and_the_table_scrolled_while_their_order_changes(machine, shown):
    shown.table.setFixedHeight(160)
    try:
        pump(30)
        last = shown.items()[-1]
        symbols = [i.text(ranking.ERROR) for i in shown.items()]
        shown.table.setCurrentItem(last)
        pump(30)
        place = shown.table.verticalScrollBar().value()
        assert place > 0
        chosen = []
        shown.chosen.connect(lambda bodies: chosen.append(bodies))
        widen(machine, **{symbols[0]: 0.1, symbols[5]: 3.0})
        after = [i.text(ranking.ERROR) for i in shown.items()]
        assert after != symbols and sorted(after) == sorted(symbols)
        assert [i.text(ranking.RANK) for i in shown.items()] == [str(k + 1) for k in range(len(symbols))]
        assert [i.text(ranking.ERROR) for i in shown.table.selectedItems()] == [last.text(ranking.ERROR)]
        assert shown.table.verticalScrollBar().value() == place
        assert chosen == []  # nothing was chosen anew
    finally:
        shown.table.setMinimumHeight(0)
        shown.table.setMaximumHeight(16777215)


def test_another_order_of_the_columns_is_kept(machine, shown):
    shown.table.sortByColumn(ranking.TOLERANCE, Qt.DescendingOrder)
    try:
        widen(machine, EXX=7.0, EBY=3.0)
        widths = [i.data(ranking.TOLERANCE, Qt.UserRole) for i in shown.items()]
        assert widths == sorted(widths, reverse=True)
    finally:
        shown.table.sortByColumn(ranking.RANK, Qt.AscendingOrder)


def test_rows_come_and_go_with_their_errors(machine, shown):
    assert len(shown.items()) == 24
    shown.show_result(machine, None)
    assert shown.items() == []
    shown.show_result(machine, tree.sensitivity_of(machine))
    assert len(shown.items()) == 24


def test_errors_of_one_name_have_a_row_each(machine, shown):
    class Twins:
        Symbols = ["effect"] * 24

        def __getattr__(self, name):
            return getattr(tree.sensitivity_of(machine), name)

    shown.show_result(machine, Twins())
    assert [i.text(ranking.RANK) for i in shown.items()] == [str(k + 1) for k in range(24)]
    assert {i.text(ranking.ERROR) for i in shown.items()} == {"effect"}


def test_the_filter_shows_the_errors_of_an_axis_or_of_a_kind(machine, shown):
    seen = lambda: {i.text(ranking.ERROR) for i in shown.items() if not i.isHidden()}  # noqa: E731
    everything = seen()
    try:
        shown.filter.setText("squareness")
        assert seen() == {"C0Y", "B0Z", "A0Z"}
        shown.filter.setText("squareness Z")
        assert seen() == {"B0Z", "A0Z"}
        widen(machine, EXX=2.0)
        assert seen() == {"B0Z", "A0Z"}  # it stays while values change
        shown.filter.setText("nothing has this")
        assert seen() == set()
    finally:
        shown.filter.clear()
    assert seen() == everything
