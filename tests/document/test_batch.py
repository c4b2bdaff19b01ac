# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verbs on a document without a window: what they write, what they keep, what they refuse, how they end."""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import FreeCAD as App
import numpy as np
import pytest

from sensworkbench.core import workspace
from sensworkbench.core.fitted import Constant, FittedModel
from sensworkbench.core.refusal import Refused
from sensworkbench.document import archive, batch, extract, handoff, results, tables, tree
from sensworkbench.formats.effects_json import of_parameters

from .blocks import golden_machine

ROOT = Path(__file__).resolve().parents[2]
VIEW = b"""<?xml version='1.0' encoding='utf-8'?>
<Document SchemaVersion="1"><ViewProviderData Count="1"><ViewProvider name="Bed"><Properties Count="1">
<Property name="DiffuseColor" type="App::PropertyColorList"><ColorList file="DiffuseColor"/></Property>
</Properties></ViewProvider></ViewProviderData></Document>"""
COLOURS = b"\x01\x00\x00\x00\x00\x00\xff\x00"


@pytest.fixture
def saved(doc, tmp_path):
    """A document with a machine, saved without a window."""
    golden_machine(doc, "XYFZ")
    path = tmp_path / "machine.FCStd"
    doc.saveCopy(str(path))
    return path


@pytest.fixture
def viewed(saved):
    """The same with view data, as a window saves it."""
    with zipfile.ZipFile(saved, "a") as out:
        out.writestr("GuiDocument.xml", VIEW)
        out.writestr("DiffuseColor", COLOURS)
        out.writestr("thumbnails/Thumbnail.png", b"\x89PNG")
    return saved


def digest(path):
    return hashlib.sha256(Path(path).read_bytes()).hexdigest()


def reopened(path, check):
    document = App.openDocument(str(path))
    try:
        return check(tree.machine_of(document))
    finally:
        App.closeDocument(document.Name)


def test_the_result_is_stored_in_a_copy_and_the_input_is_untouched(saved, tmp_path):
    before = digest(saved)
    core, opened = batch.load_machine(saved)
    with opened:
        found = workspace.sensitivity(core)
        target = batch.write_sensitivity(opened, tmp_path / "out" / "result.FCStd", found)
    assert digest(saved) == before
    assert sorted(p.name for p in target.parent.iterdir()) == ["result.FCStd"]  # no temporary or backup file stays

    def check(machine):
        obj = tree.sensitivity_of(machine)
        np.testing.assert_array_equal(obj.Total, found.total)
        np.testing.assert_array_equal(results.load(machine, obj).component_total, found.component_total)
        assert obj.Variance == found.variance and obj.MeanSquare == found.mean_square
        assert obj.Coloured and not obj.Stale
        assert machine.ViewPending  # there was no view data to keep
        assert machine.Document.Label == "result"
        machine.Document.recompute()
        assert not obj.Stale

    reopened(target, check)


def test_view_data_and_its_side_files_are_kept(viewed, tmp_path):
    core, opened = batch.load_machine(viewed)
    with opened:
        target = batch.write_sensitivity(opened, tmp_path / "result.FCStd", workspace.sensitivity(core))
    with zipfile.ZipFile(target) as saved:
        assert saved.testzip() is None
        assert saved.read("GuiDocument.xml") == VIEW and saved.read("DiffuseColor") == COLOURS
        assert saved.read("thumbnails/Thumbnail.png") == b"\x89PNG"
        assert len(saved.namelist()) == len(set(saved.namelist()))
    assert not reopened(target, lambda machine: machine.ViewPending)
    assert reopened(target, lambda machine: list(machine.Unseen)) == ["Sensitivity"]  # a window would hide it


def test_a_side_file_whose_name_the_document_takes_is_renamed(viewed, tmp_path):
    other = tmp_path / "other.FCStd"
    with zipfile.ZipFile(other, "w") as out:
        out.writestr("Document.xml", "<Document/>")
        out.writestr("DiffuseColor", b"of the document")
    assert archive.keep_view(viewed, other)
    with zipfile.ZipFile(other) as saved:
        assert saved.read("DiffuseColor") == b"of the document"
        assert saved.read("DiffuseColor_1") == COLOURS
        assert b'file="DiffuseColor_1"' in saved.read("GuiDocument.xml")


def test_the_copy_takes_the_tolerances_and_convention_that_were_computed(saved, tmp_path):
    core, opened = batch.load_machine(saved)
    with opened:
        from dataclasses import replace

        changed = replace(core, squareness="carried", tolerances={"EAX": core.all_tolerances["EAX"].scaled(0.5)})
        target = batch.write_sensitivity(opened, tmp_path / "r.FCStd", workspace.sensitivity(changed), changed)

    def check(machine):
        assert machine.Squareness == "carried" and not tree.sensitivity_of(machine).Stale
        assert tables.read_tolerances(machine)["EAX"].upper == pytest.approx(10e-6)

    reopened(target, check)


def test_fitted_errors_and_effects_are_written_under_their_bodies(saved, tmp_path):
    from dataclasses import replace

    core, opened = batch.load_machine(saved)
    opened.close()
    effect = of_parameters(
        "growth", "EZT", "t", "approach", {"coefficient": {"value": 12.0, "unit": "um"}, "tau": {"value": 900}}
    )
    fitted = FittedModel(constants={"C0Y": Constant(3e-6, 2e-7)})
    augmented = replace(core, fitted=fitted, effects=(effect,), declared={"EXX": 5})
    target = batch.write_augmented(saved, tmp_path / "machine_augmented.FCStd", augmented)
    batch.write_augmented(target, tmp_path / "again.FCStd", augmented)

    def check(machine):
        assert [e.Label for e in tree.effects_of(machine)] == ["growth"]
        back = extract.core_machine(machine)
        assert back.effects == (effect,) and back.fitted == fitted and back.declared == {"EXX": 5}

    reopened(target, check)
    reopened(tmp_path / "again.FCStd", check)


def test_writing_over_the_input_is_refused(saved):
    core, opened = batch.load_machine(saved)
    with opened, pytest.raises(Refused, match="its own input"):
        batch.write_sensitivity(opened, saved, workspace.sensitivity(core))


def test_objects_of_a_missing_add_on_are_named_and_nothing_is_written(saved, tmp_path):
    with zipfile.ZipFile(saved) as source:
        text = source.read("Document.xml").decode()
    assert text.count("sensworkbench.document.objects") > 5
    spoilt = tmp_path / "spoilt.FCStd"
    ours = 'module="sensworkbench.document.objects" class="BodyObject"'
    text = text.replace(ours, 'module="gearworld.wheel" class="Wheel"')
    with zipfile.ZipFile(saved) as source, zipfile.ZipFile(spoilt, "w") as out:
        for name in source.namelist():
            out.writestr(name, text if name == "Document.xml" else source.read(name))
    with pytest.raises(Refused) as refusal:
        batch.load_machine(spoilt)
    assert (refusal.value.code, refusal.value.fields["addons"]) == ("document-addon-missing", ["gearworld"])
    assert "Spindle and tool" in refusal.value.message


def test_a_type_that_this_freecad_does_not_know_is_refused(saved, tmp_path):
    with zipfile.ZipFile(saved) as source:
        text = source.read("Document.xml").decode()
        strange = tmp_path / "strange.FCStd"
        with zipfile.ZipFile(strange, "w") as out:
            for name in source.namelist():
                changed = text.replace('type="Part::Box" name="Bed"', 'type="Quantum::Box" name="Bed"')
                out.writestr(name, changed if name == "Document.xml" else source.read(name))
    with pytest.raises(Refused, match="Quantum::Box"):
        batch.load_machine(strange)


def test_a_damaged_solid_is_refused_by_name_instead_of_lost_in_the_copy(saved, tmp_path):
    damaged = tmp_path / "damaged.FCStd"
    with zipfile.ZipFile(saved) as source, zipfile.ZipFile(damaged, "w") as out:
        shapes = {i.filename for i in source.infolist() if i.filename.endswith(".brp") and i.file_size}
        assert shapes
        for name in source.namelist():
            out.writestr(name, b"garbage" if name == min(shapes) else source.read(name))
    before = set(App.listDocuments())
    with pytest.raises(Refused) as refusal:
        batch.load_machine(damaged)
    assert refusal.value.code == "document-solid-lost"
    assert [label for label in refusal.value.fields["parts"] if label] and str(damaged) in refusal.value.message
    assert set(App.listDocuments()) == before


def test_documents_are_closed_again_when_refused(doc, tmp_path):
    doc.addObject("Part::Box", "Lonely")
    path = tmp_path / "no_machine.FCStd"
    doc.saveCopy(str(path))
    before = set(App.listDocuments())
    with pytest.raises(Refused, match="holds no machine"):
        batch.load_machine(path)
    assert set(App.listDocuments()) == before


# -- as a process ----------------------------------------------------------------------------------------------------
@pytest.fixture
def command(tmp_path, monkeypatch):
    """`python -m sensworkbench ...` from plain Python, which finds freecadcmd by itself."""
    python = shutil.which("python3") or sys.executable

    def run(*argv, **environment):
        return subprocess.run(
            [python, "-m", "sensworkbench", *map(str, argv)], cwd=tmp_path, capture_output=True, text=True, timeout=120,
            env=dict(os.environ, PYTHONPATH=str(ROOT), **environment),
        )  # fmt: skip

    return run


def test_the_verb_on_a_document_from_plain_python(command, viewed, tmp_path):
    done = command("sensitivity", viewed, "--out", tmp_path / "out", "--at=-10,5,3")
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    written = [Path(line).name for line in done.stdout.splitlines()]
    assert written == ["sensitivity.json", "sensitivity.csv", "report.html", "sensitivity.FCStd"]
    data = json.loads((tmp_path / "out" / "sensitivity.json").read_text())
    assert data["aggregate"] == "at" and data["points"] == [-10, 5, 3]
    with zipfile.ZipFile(tmp_path / "out" / "sensitivity.FCStd") as saved:
        assert saved.read("GuiDocument.xml") == VIEW
    totals = {e["symbol"]: e["total"] for e in data["errors"]}

    def check(machine):
        obj = tree.sensitivity_of(machine)
        assert machine.Aggregate == "at"
        for symbol, total in zip(obj.Symbols, obj.Total):
            assert total == pytest.approx(totals[symbol], rel=1e-9, abs=1e-12)

    reopened(tmp_path / "out" / "sensitivity.FCStd", check)


def test_a_refusal_inside_freecad_ends_with_status_two_and_one_message(command, doc, tmp_path):
    machine = golden_machine(doc)
    machine.ToolPoint = None
    path = tmp_path / "no_tool.FCStd"
    doc.saveCopy(str(path))
    done = command("sensitivity", path, "--out", tmp_path / "out")
    assert done.returncode == 2
    assert "tool point is missing" in done.stderr and "Traceback" not in done.stderr
    assert len(done.stderr.strip().splitlines()) == 1 and done.stdout == ""
    assert not (tmp_path / "out").exists()


def test_without_freecad_the_message_says_what_to_install(command, saved, tmp_path):
    done = command("sensitivity", saved, "--out", tmp_path / "out", SENS_FREECADCMD="no-such-program")
    assert done.returncode == 2 and "SENS_FREECADCMD" in done.stderr


def test_a_freecad_that_dies_is_a_defect_not_a_refusal(command, saved, tmp_path):
    crash = tmp_path / "crash.sh"
    crash.write_text("#!/bin/sh\nkill -SEGV $$\n")
    crash.chmod(0o755)
    done = command("sensitivity", saved, "--out", tmp_path / "out", SENS_FREECADCMD=str(crash))
    assert done.returncode == 1 and "FreeCAD ended" in done.stderr


def test_freecadcmd_is_found(monkeypatch):
    monkeypatch.delenv("SENS_FREECADCMD", raising=False)
    assert Path(handoff.freecadcmd()).is_file()
