# SPDX-License-Identifier: LGPL-2.1-or-later
"""Readings, traces and effects in the document: what is imported, found and added is there again after saving."""

from __future__ import annotations

import hashlib
import json
import subprocess
import sys
from pathlib import Path

import FreeCAD as App
import numpy as np
import pytest

from sensworkbench.closedloop.declared import declared_fit, fit_summary
from sensworkbench.closedloop.predict import predict
from sensworkbench.closedloop.trace import trace
from sensworkbench.core.refusal import Refused
from sensworkbench.document import closed_loop, extract, results, told, tree
from sensworkbench.document.examples import make_example
from sensworkbench.formats import readings_csv, study_files, trace_json

from . import simulated

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def machine(doc):
    found = make_example(doc, "XYFZ")
    doc.recompute()
    return found


@pytest.fixture
def measured(machine, tmp_path):
    return simulated.write(tmp_path / "measured.csv", simulated.table(extract.core_machine(machine)))


_outcomes = {}


@pytest.fixture
def traced(machine, measured):
    """(readings object, trace object): traced once for all tests, since the machine is the same."""
    core = extract.core_machine(machine)
    if not _outcomes:
        _outcomes["one"] = trace(core, readings_csv.load(measured))
    table = closed_loop.make_readings(machine, measured)
    return table, closed_loop.make_trace(machine, table, _outcomes["one"], core)


def again(doc, path):
    """The document saved, closed and opened again; its machine."""
    doc.saveCopy(str(path))
    return App.openDocument(str(path))


def test_readings_are_kept_as_they_were_imported(machine, measured, tmp_path):
    table = closed_loop.make_readings(machine, measured)
    digest = hashlib.sha256(measured.read_bytes()).hexdigest()
    expected = readings_csv.load(measured)
    measured.unlink()  # the document has its own copy
    opened = again(machine.Document, tmp_path / "kept.FCStd")
    try:
        found = opened.getObject(table.Name)
        assert tree.readings_of(tree.machine_of(opened)) == [found]
        assert (found.Source, found.Points, found.Rows, found.Sha256) == ("measured.csv", 160, 480, digest)
        assert "temp_column (K)" in found.Columns
        assert any("derived" in f for f in found.Findings)
        np.testing.assert_array_equal(closed_loop.read(found).value, expected.value)
    finally:
        App.closeDocument(opened.Name)


def test_a_foreign_table_is_read_by_its_mapping(machine, tmp_path):
    rows = simulated.table(extract.core_machine(machine))
    rows[:, 6:] *= -1  # compensation values
    names = ("Pos X", "Pos Y", "Pos Z", "Zeit", "T1", "T2", "dX", "dY", "dZ")
    path = simulated.write(tmp_path / "foreign.csv", rows, names, answers=())
    mapping = dict(zip(simulated.NAMES, names)) | {"header": {"sign": "compensation"}}
    with pytest.raises(Refused, match="x_mm is missing"):
        closed_loop.make_readings(machine, path)
    assert not tree.readings_of(machine)
    table = closed_loop.make_readings(machine, path, mapping)
    plain = simulated.write(tmp_path / "plain.csv", rows * np.r_[np.ones(6), -np.ones(3)])
    np.testing.assert_allclose(closed_loop.read(table).value, readings_csv.load(plain).value)


def test_the_declared_fit_says_what_it_cannot_tell(machine, measured):
    readings = readings_csv.load(measured)
    found = fit_summary(declared_fit(extract.core_machine(machine), readings), readings)
    assert found["rank"] < found["columns"] and found["null_space"]
    assert {m.code for m in found["null_space"]} <= {"null-unseen-tool", "null-alike-tool"}
    unknown = [label for label, value, _, _ in found["parameters"] if value is None]
    assert unknown and all(any(str(u).split(" (")[0] in str(m) for m in found["null_space"]) for u in unknown)
    # the column bends by 6 urad/K and nobody declared that
    assert found["rms"]["rms_um"] > 2 * 0.4 * np.sqrt(3)


def test_the_declared_fit_names_an_outlier_by_its_line(machine, tmp_path):
    rows = simulated.table(extract.core_machine(machine), bend=False)
    rows[40, 7] += 80.0
    readings = readings_csv.load(simulated.write(tmp_path / "measured.csv", rows))
    found = fit_summary(declared_fit(extract.core_machine(machine), readings), readings)
    assert [o["line"] for o in found["outliers"]] == [40 + 5]  # three answers and the names stand above


def test_a_trace_is_there_again_after_saving(machine, traced, tmp_path):
    table, found = traced
    opened = again(machine.Document, tmp_path / "traced.FCStd")
    try:
        same = opened.getObject(found.Name)
        assert same.Verdict == "explained" and not same.Stale
        assert same.Readings == opened.getObject(table.Name)
        assert "EAZ driven by temp_column" in told.words(same.Summary)
        outcome = closed_loop.evidence_of(same)
        assert closed_loop.report_of(same) == json.loads(json.dumps(trace_json.to_dict(_outcomes["one"])))
        for name, series in _outcomes["one"].residuals.items():
            np.testing.assert_allclose(outcome.residuals[name], series, rtol=1e-12)
        np.testing.assert_allclose(outcome.covariance[1], _outcomes["one"].covariance[1], rtol=1e-12)
        before, after = (np.linalg.norm([tuple(v) for v in vectors], axis=1) for vectors in (same.Before, same.After))
        assert np.sqrt((after**2).mean()) < 0.4 * np.sqrt((before**2).mean())
        files = {p.name for p in study_files.write_saved_trace(tmp_path / "out", closed_loop.report_of(same), outcome)}
        assert files == {"trace.json", "report.html", "machine_augmented.json", "covariance.npz"}
    finally:
        App.closeDocument(opened.Name)


def test_found_effects_join_the_machine_and_leave_it_again(machine, traced):
    doc = machine.Document
    before = results.compute(machine)
    names, fitted = list(before.Symbols), machine.Fitted
    doc.recompute()
    doc.openTransaction("Add")
    made = closed_loop.add_effects(traced[1])
    doc.recompute()
    doc.commitTransaction()
    assert [(e.Component, e.Driver) for e in made] == [("EAZ", "temp_column")]
    assert made[0] in tree.axis_of(machine, "Z").Group
    coefficient = json.loads(made[0].Parameters)["coefficient"]
    assert coefficient["value"] == pytest.approx(simulated.COEFFICIENT, abs=4 * coefficient["u"])
    assert before.Stale and not traced[1].Stale
    after = results.compute(machine)
    assert set(after.Symbols) - set(names) == {made[0].Label}
    assert after.Total[list(after.Symbols).index(made[0].Label)] > 0.01
    doc.recompute()
    made[0].Enabled = False
    doc.recompute()
    assert after.Stale and not traced[1].Stale
    assert list(results.compute(machine).Symbols) == names
    with pytest.raises(Refused, match="added already"):
        closed_loop.add_effects(traced[1])
    closed_loop.remove_effects(traced[1])
    doc.recompute()
    assert not tree.effects_of(machine) and machine.Fitted == fitted
    assert closed_loop.can_add(traced[1])


def test_undo_takes_the_effects_and_the_fit_back(machine, traced):
    doc, fitted = machine.Document, machine.Fitted
    doc.recompute()
    doc.openTransaction("Add")
    closed_loop.add_effects(traced[1])
    doc.recompute()
    doc.commitTransaction()
    doc.undo()
    assert not tree.effects_of(machine) and machine.Fitted == fitted and not tree.added_effects(traced[1])
    doc.redo()
    assert [e.Component for e in tree.effects_of(machine)] == ["EAZ"]
    assert tree.added_effects(traced[1]) == tree.effects_of(machine)


def test_the_document_predicts_as_the_augmented_machine_does(machine, traced):
    closed_loop.add_effects(traced[1])
    machine.Document.recompute()
    readings = closed_loop.read(traced[0])
    np.testing.assert_allclose(
        predict(extract.core_machine(machine), readings), predict(_outcomes["one"].machine, readings), atol=1e-9
    )


def test_a_trace_of_a_machine_that_changed_says_so(machine, traced):
    assert not traced[1].Stale
    tree.axis_of(machine, "Z").TravelUpper = tree.axis_of(machine, "Z").TravelUpper.Value + 10
    machine.Document.recompute()
    assert traced[1].Stale and not closed_loop.can_add(traced[1])
    with pytest.raises(Refused, match="has changed"):
        closed_loop.add_effects(traced[1])


def test_a_trace_whose_readings_were_deleted_is_refused(machine, traced):
    machine.Document.removeObject(traced[0].Name)
    machine.Document.recompute()
    with pytest.raises(Refused, match="readings were deleted"):
        closed_loop.evidence_of(traced[1])


# -- the command line on a document ------------------------------------------------------------------------------------
def command(*arguments):
    return subprocess.run(
        [sys.executable if "python" in Path(sys.executable).name else "python3", "-m", "sensworkbench", *arguments],
        cwd=ROOT, capture_output=True, text=True, timeout=300,
    )  # fmt: skip


def test_trace_and_predict_on_a_document_from_the_command_line(machine, measured, tmp_path):
    path, out = tmp_path / "machine.FCStd", tmp_path / "out"
    machine.Document.saveCopy(str(path))
    digest = hashlib.sha256(path.read_bytes()).hexdigest()
    done = command("trace", str(path), str(measured), "--out", str(out))
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines()[0] == "explained"
    assert {"trace.json", "report.html", "machine_augmented.FCStd"} <= {p.name for p in out.iterdir()}
    assert hashlib.sha256(path.read_bytes()).hexdigest() == digest
    opened = App.openDocument(str(out / "machine_augmented.FCStd"))
    try:
        effects = tree.effects_of(tree.machine_of(opened))
        assert [(e.Component, e.Driver, e.Enabled) for e in effects] == [("EAZ", "temp_column", True)]
    finally:
        App.closeDocument(opened.Name)
    written = tmp_path / "predicted.csv"
    done = command("predict", str(out / "machine_augmented.FCStd"), str(measured), "--out", str(written))
    assert done.returncode == 0, done.stderr
    rows = [line for line in written.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    error = np.genfromtxt(rows, delimiter=",", names=True)
    asked = readings_csv.load(measured).value.reshape(-1, 3) * 1e3
    told = np.stack([error[n] for n in ("ex_um", "ey_um", "ez_um")], axis=1)
    assert np.sqrt(((told - asked) ** 2).sum(axis=1).mean()) < 1.5 * 0.4 * np.sqrt(3)
