# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sources in the document: declared, replaced, removed; in indices, files and staleness as in machine.json."""

from __future__ import annotations

from dataclasses import replace

import FreeCAD as App
import pytest

from sensworkbench.core import workspace
from sensworkbench.core.distributions import Tolerance
from sensworkbench.core.refusal import Refused
from sensworkbench.core.sources import Source
from sensworkbench.document import base, extract, refresh, results, sources, studies, tables, tree
from sensworkbench.studies.limits import limits_study

from .blocks import golden_machine

RAIL = Source("rail", Tolerance(-1, 1), {"EZX": 3e-3, "EBX": -12e-6})


@pytest.fixture
def machine(doc):
    found = golden_machine(doc, "XYFZ")
    doc.recompute()
    return found


def test_a_source_is_that_of_the_core(machine, doc):
    before = extract.core_machine(machine)
    sources.declare(machine, RAIL)
    doc.recompute()
    core = extract.core_machine(machine)
    assert core.sources == (RAIL,)
    known = replace(before, sources=(RAIL,))
    known = replace(known, tolerances={s: t for s, t in before.tolerances.items() if s not in RAIL.factors})
    assert dict(core.all_tolerances) == dict(known.all_tolerances) and "EZX" not in core.all_tolerances
    obj = results.compute(machine)
    found = workspace.sensitivity(known, extract.positions(machine, known), extract.objective(machine))
    assert list(obj.Symbols) == list(found.symbols) and "rail" in obj.Symbols
    assert list(obj.Total) == pytest.approx(found.total.tolist(), rel=1e-9)
    assert obj.Units[list(obj.Symbols).index("rail")] == "1"
    assert results.load(machine, obj).component_share.sum() == pytest.approx(1)


def test_errors_may_keep_a_part_of_their_own(machine, doc):
    own = tables.read_tolerances(machine)["EZX"]
    sources.declare(machine, RAIL, own=True)
    doc.recompute()
    assert tables.read_tolerances(machine)["EZX"] == own
    assert extract.core_machine(machine).all_tolerances["EZX"] == own


def test_removing_gives_tolerances_of_the_same_width_back(machine, doc):
    normal = Source("heat", Tolerance(-2, 6, "normal", 1.5), {"EXX": 2e-3, "EAY": -5e-6})
    sources.declare(machine, normal)
    doc.recompute()
    sources.remove(machine, "heat")
    doc.recompute()
    found = tables.read_tolerances(machine)
    assert machine.Sources == "" and extract.core_machine(machine).sources == ()
    for symbol, known in (("EXX", (-4e-3, 12e-3, 3e-3)), ("EAY", (-30e-6, 10e-6, 7.5e-6))):
        law = found[symbol]
        assert (law.lower, law.upper, law.sigma) == pytest.approx(known) and law.distribution == "normal"


def test_replacing_frees_what_no_longer_follows(machine, doc):
    sources.declare(machine, RAIL)
    doc.recompute()
    sources.declare(machine, Source("bed", Tolerance(-1, 1), {"EBX": 8e-6}), "rail")
    doc.recompute()
    assert [s.name for s in extract.core_machine(machine).sources] == ["bed"]
    law = tables.read_tolerances(machine)["EZX"]
    assert (law.lower, law.upper) == pytest.approx((-3e-3, 3e-3))
    assert "EBX" not in tables.read_tolerances(machine)


def test_refusals_change_nothing(machine, doc):
    for wrong in (Source("EXX", Tolerance(-1, 1), {"EXX": 1e-3}), Source("a", Tolerance(-1, 1), {"EXC": 1e-3})):
        with pytest.raises(Refused):
            sources.declare(machine, wrong)
    with pytest.raises(Refused):
        sources.remove(machine, "nothing")
    assert machine.Sources == "" and "EXX" in tables.read_tolerances(machine)


def test_results_and_studies_become_stale_and_survive_saving(machine, doc, tmp_path):
    sources.declare(machine, RAIL)
    doc.recompute()
    result, core = results.compute(machine), extract.core_machine(machine)
    kept = studies.store(machine, "limits", {"level": 0.9}, {"found": 1}, core)
    refresh.refresh(machine)
    assert not result.Stale and not kept.Stale
    doc.saveCopy(str(tmp_path / "sources.FCStd"))
    again = App.openDocument(str(tmp_path / "sources.FCStd"))
    try:
        found = tree.machine_of(again)
        assert extract.core_machine(found).sources == (RAIL,)
        obj = studies.study_of(found, "limits")
        assert base.alive(obj) and studies.read(obj) == ({"level": 0.9}, {"found": 1})
        refresh.refresh(found)
        assert not obj.Stale and not tree.sensitivity_of(found).Stale
        sources.declare(found, Source("rail", RAIL.law, {"EZX": 3e-3, "EBX": -13e-6}), "rail")
        again.recompute()
        assert obj.Stale and tree.sensitivity_of(found).Stale
        assert "rail" in {c.name for c in limits_study(extract.core_machine(found)).errors}
    finally:
        App.closeDocument(again.Name)
