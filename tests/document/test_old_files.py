# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents of every schema open with equal values, survive a FreeCAD without the add-on, and can be mended."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import FreeCAD as App
import numpy as np
import pytest

from sensworkbench.core.objectives import Signed
from sensworkbench.core.refusal import Refused
from sensworkbench.document import base, extract, objects, repair, results, tables, told, tree

from .blocks import golden_machine
from .stored import values

DATA = Path(__file__).resolve().parents[1] / "data"
FILES = sorted(DATA.glob("schema-*.FCStd"))


def expected(path) -> dict:
    return json.loads(path.with_suffix(".json").read_text(encoding="utf-8"))


def same(found, known, where=""):
    """Equal, numbers to what a float holds after it was written as text."""
    if isinstance(known, dict):
        for name in known:
            same(found[name], known[name], f"{where}.{name}")
    elif isinstance(known, list):
        assert len(found) == len(known), where
        for i, (a, b) in enumerate(zip(found, known)):
            same(a, b, f"{where}[{i}]")
    elif isinstance(known, float) and not isinstance(known, bool):
        assert found == pytest.approx(known, rel=1e-12, abs=1e-12), where
    elif isinstance(known, str) and where.endswith("Inputs"):
        assert bool(found) == bool(known), where
    elif isinstance(known, str) and where.rpartition(".")[2] in ("ReferenceFrom", "DirectionFrom", "Summary"):
        assert told.words(found) == told.words(known), where  # sentences before schema 3, then codes
    else:
        assert found == known, where


RENAMED = {"Fingerprint": "Inputs", "Basis": "Inputs", "Digest": "Sha256"}  # in schema 2


def migrated(stored: dict) -> dict:
    """The stored values of an object of an earlier schema, as the newest one holds them."""
    found = {RENAMED.get(name, name): value for name, value in stored.items()}
    if found["SchemaVersion"] == 1 and found["SensType"] == "Machine":
        found["Skew"] = {pair: str(found.pop(f"Skew{pair}")) for pair in ("XY", "XZ", "YZ")}
    if found["SchemaVersion"] < 3 and "Weights" in found:
        kind = "signed" if found.pop("Signed") else "mean_square"
        objective = {"name": kind, "output": found.pop("Output"), "weights": found.pop("Weights")}
        found["Objective"] = json.dumps(objective, sort_keys=True)
    if found["SchemaVersion"] == 1 and found["SensType"] == "Trace":
        found["Positions"] = [v for point in found["Positions"] for v in point]
    return found


def check(doc, known):
    ours = {o.Name: o for o in doc.Objects if base.kind_of(o)}
    assert set(ours) == set(known["objects"])
    for name, stored in known["objects"].items():
        assert base.alive(ours[name]), name
        current = values(ours[name])
        assert current["SchemaVersion"] == ours[name].Proxy.schema
        same(current, {k: v for k, v in migrated(stored).items() if k != "SchemaVersion"}, name)


@pytest.fixture
def opened(tmp_path, request):
    """Opens a copy of a file; the fixture closes what it opened."""
    documents = []

    def open_copy(path):
        copy = tmp_path / path.name
        if not copy.exists():
            shutil.copy(path, copy)
        documents.append(App.openDocument(str(copy)).Name)
        return App.getDocument(documents[-1])

    yield open_copy
    for name in documents:
        if name in App.listDocuments():
            App.closeDocument(name)


def test_every_released_schema_has_its_files():
    schemas = {int(p.name.split("-")[1]) for p in FILES}
    newest = max(c.schema for c in repair.CLASSES.values())
    assert schemas == set(range(1, newest + 1))
    assert all(p.stat().st_size < 100_000 for p in FILES)


@pytest.mark.parametrize("path", FILES, ids=lambda p: p.stem)
def test_a_file_of_an_earlier_schema_opens_with_equal_values(opened, path):
    known = expected(path)
    doc = opened(path)
    check(doc, known)
    machine = tree.machine_of(doc)
    assert extract.core_machine(machine).structure == known["structure"]
    arms = extract.core_machine(machine).lever_arms([[0.0, 0.0, 0.0], [10.0, -20.0, 30.0]])
    for body, arm in known["arms"].items():
        np.testing.assert_allclose(arms[body], arm, rtol=1e-9, atol=1e-9)
    doc.recompute()
    check(doc, known)
    found = tree.sensitivity_of(machine)
    assert machine.Problem == "" and not found.Stale
    before = list(found.Total)
    assert before == pytest.approx(list(results.compute(machine).Total), rel=1e-9, abs=1e-12)
    assert repair.examine(doc) == []


@pytest.mark.parametrize("path", FILES, ids=lambda p: p.stem)
def test_opening_twice_migrates_nothing_twice(opened, path, tmp_path):
    doc = opened(path)
    again = tmp_path / "again.FCStd"
    doc.saveAs(str(again))
    App.closeDocument(doc.Name)
    check(opened(again), expected(path))


# -- without the add-on ----------------------------------------------------------------------------------------------
WITHOUT = """
import os, sys
import FreeCAD as App
doc = App.openDocument(os.environ["SENS_IN"])
assert "sensworkbench" not in sys.modules
doc.getObject("Bed").Label = "Bed, renamed without the add-on"
doc.recompute()
doc.saveAs(os.environ["SENS_OUT"])
sys.stdout.flush()
os._exit(0)
"""


def freecadcmd() -> str:
    for name in (os.environ.get("SENS_FREECADCMD"), "freecadcmd", "FreeCADCmd"):
        if name and shutil.which(name):
            return shutil.which(name)
    pytest.fail("freecadcmd is not on the path")


def in_freecad(script: str, tmp_path, **more) -> str:
    home = tmp_path / "home"
    (home / "Mod").mkdir(parents=True)
    (tmp_path / "job.py").write_text(script, encoding="utf-8")
    environment = {k: v for k, v in os.environ.items() if not k.startswith("PYTHON")}
    environment |= {"FREECAD_USER_HOME": str(home), **{k: str(v) for k, v in more.items()}}
    done = subprocess.run(
        [freecadcmd(), str(tmp_path / "job.py")], env=environment, cwd=tmp_path, timeout=120, text=True,
        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, errors="replace", check=False,
    )  # fmt: skip
    return done.stdout


@pytest.mark.parametrize("path", FILES, ids=lambda p: p.stem)
def test_a_document_saved_where_the_add_on_is_missing_keeps_its_data(opened, path, tmp_path):
    out = tmp_path / "without.FCStd"
    log = in_freecad(WITHOUT, tmp_path, SENS_IN=path, SENS_OUT=out)
    assert out.exists(), log
    doc = opened(out)
    assert doc.getObject("Bed").Label.startswith("Bed, renamed")
    known = expected(path)
    for name, stored in known["objects"].items():
        same(values(doc.getObject(name)), stored, name)
    found = repair.repair(doc)
    lost = {f.obj.Name for f in found}
    assert lost == set() or lost == set(known["objects"]), "all of them or none"
    assert all(f.mendable for f in found)
    check(doc, known)
    assert repair.examine(doc) == []
    machine = tree.machine_of(doc)
    machine.touch()
    doc.recompute()
    assert machine.Problem == "" and not tree.sensitivity_of(machine).Stale


WITH = """
import os, sys
sys.path.insert(0, os.environ["SENS_ROOT"])
import sensworkbench.document.objects
import FreeCAD as App
doc = App.openDocument(os.environ["SENS_IN"])
doc.recompute()
print("opened", len(doc.Objects))
sys.stdout.flush()
os._exit(0)
"""


@pytest.mark.parametrize("path", FILES, ids=lambda p: p.stem)
def test_a_file_opens_without_a_window_and_without_a_complaint(path, tmp_path):
    log = in_freecad(WITH, tmp_path, SENS_IN=path, SENS_ROOT=DATA.parents[1])
    assert "opened" in log
    wrong = [line for line in log.splitlines() if any(w in line for w in ("Traceback", "Error", "failed", "blocked"))]
    assert wrong == []


# -- damage ----------------------------------------------------------------------------------------------------------
@pytest.fixture
def machine(doc):
    made = golden_machine(doc)
    results.compute(made)
    doc.recompute()
    return made


def problems(doc):
    """(label of the object, code) of everything that is wrong."""
    return {(p.obj.Label, p.refusal.code) for p in repair.examine(doc)}


def test_a_sound_document_has_no_findings(machine):
    assert repair.examine(machine.Document) == []
    assert repair.repair(machine.Document) == []


def test_an_object_without_its_class_is_named_and_works_again(machine):
    axis = tree.axis_of(machine, "X")
    kept = values(axis)
    axis.Proxy = None
    assert not base.alive(axis) and ("Axis X", "problem-without-class") in problems(machine.Document)
    repair.repair(machine.Document)
    assert base.alive(axis) and values(axis) == kept
    axis.Position = 25.0
    assert machine.Document.getObject("CarriageX").Placement.Base.x == pytest.approx(30 - 25)


def test_missing_properties_and_a_missing_table_are_made_anew(machine):
    machine.Objective = judged = told.objective_text(Signed(weights=(1, 2, 3)))
    machine.removeProperty("Order")
    machine.Document.removeObject(tree.tolerances_of(machine).Name)
    found = [p.refusal for p in repair.examine(machine.Document) if p.obj == machine]
    assert ["Order"] in [r.fields.get("names") for r in found]
    repair.repair(machine.Document)
    assert machine.Order == 8 and machine.Objective == judged
    assert tree.tolerances_of(machine) is not None and machine.Problem == ""
    assert repair.examine(machine.Document) == []


def test_a_table_that_was_cut_off_keeps_its_whole_rows(machine):
    table = tree.tolerances_of(machine)
    lower = list(table.Lower)
    lower[0] = -1.0
    table.Lower = lower[:5]
    table.Symbols = ["EXX", "NOSUCH", *list(table.Symbols)[2:]]
    kept = list(table.Upper)[0]
    machine.Document.recompute()
    assert machine.Problem != ""
    repair.repair(machine.Document)
    read = tables.read_tolerances(machine)
    assert (read["EXX"].lower, read["EXX"].upper) == (-1.0, kept)
    assert machine.Problem == "" and repair.examine(machine.Document) == []


def test_a_result_that_was_cut_off_is_marked_stale(machine):
    found = tree.sensitivity_of(machine)
    found.Total = [0.5]
    assert ("Sensitivity", "problem-result-uneven") in problems(machine.Document)
    repair.repair(machine.Document)
    assert found.Stale and repair.examine(machine.Document) == []
    assert not results.compute(machine).Stale and len(found.Total) > 20


def test_what_only_the_user_can_mend_is_said_by_name_and_left_alone(machine):
    doc = machine.Document
    doc.removeObject("CarriageY")
    doc.removeObject("Tip")
    machine.Fitted = "{half"
    assert problems(doc) == {
        ("Axis Y", "problem-no-carriage"), (machine.Label, "problem-no-tool-point"), (machine.Label, "problem-no-json"),
    }  # fmt: skip
    before = {o.Name for o in doc.Objects}
    left = repair.repair(doc)
    assert left and not any(f.mendable for f in left)
    assert {o.Name for o in doc.Objects} == before and machine.Fitted == "{half"
    assert "Axis Y" in machine.Problem


def test_a_property_of_a_wrong_type_is_named(machine):
    machine.removeProperty("Grid")
    machine.addProperty("App::PropertyString", "Grid", "Objective", "")
    found = repair.examine(machine.Document)
    assert [(p.refusal.code, p.refusal.fields["name"], p.mendable) for p in found] == [
        ("problem-property-type", "Grid", False)
    ]


def test_two_axes_of_one_name_and_an_axis_of_no_machine_are_named(machine):
    doc = machine.Document
    tree.axis_of(machine, "Y").Axis = "X"
    machine.removeObject(tree.axis_of(machine, "Z"))
    assert {"problem-body-repeated", "problem-no-machine"} <= {code for _, code in problems(doc)}
    with pytest.raises(Refused):
        extract.core_machine(machine)


def test_every_kind_of_object_can_be_mended():
    classes = [c for c in vars(objects).values() if isinstance(c, type) and issubclass(c, base.SensObject)]
    kinds = {c.kind for c in classes if c.kind}
    assert kinds <= set(repair.CLASSES)
    assert sys.modules[repair.CLASSES["Machine"].__module__] is objects
