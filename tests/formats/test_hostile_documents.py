# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD documents made to do harm are refused before FreeCAD sees them, and so are programs that are not FreeCAD."""

from __future__ import annotations

import io
import os
import time
import zipfile
from pathlib import Path

import pytest

from sensworkbench import cli
from sensworkbench.core.refusal import Refused
from sensworkbench.document import archive, handoff

GOOD = Path(__file__).resolve().parents[1] / "data" / "schema-1-plain.FCStd"
LAUGHS = '<!DOCTYPE d [<!ENTITY a "ha"><!ENTITY b "&a;&a;">]><Document>&b;</Document>'


def packed(path, members, compression=zipfile.ZIP_DEFLATED):
    with zipfile.ZipFile(path, "w", compression) as out:
        for name, data in members.items():
            out.writestr(name, data)
    return path


def damaged() -> bytes:
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as out:
        out.writestr("Document.xml", "<Document>" + "".join(f"<a{i}/>" for i in range(3000)) + "</Document>")
    data = bytearray(stream.getvalue())
    data[60:200] = bytes(b ^ 0x5A for b in data[60:200])
    return bytes(data)


DOCUMENTS = {
    "no xml": {"Document.xml": "no xml"},
    "no document": {"Other.xml": "<a/>"},
    "utf-32": {"Document.xml": '<?xml version="1.0" encoding="utf-32"?><Document/>'},
    "shift_jis": {"Document.xml": '<?xml version="1.0" encoding="shift_jis"?><Document/>'},
    "an unknown encoding": {"Document.xml": '<?xml version="1.0" encoding="martian"?><Document/>'},
    "billion laughs": {"Document.xml": LAUGHS},
    "an entity of outside": {
        "Document.xml": '<!DOCTYPE d [<!ENTITY x SYSTEM "file:///etc/passwd">]><Document>&x;</Document>'
    },
    "a deep tree": {"Document.xml": "<a>" * 100_000},
    "one long comment": {"Document.xml": "<Document><!--" + 50_000_000 * "x" + "--></Document>"},
    "a large view": {"Document.xml": "<Document/>", "GuiDocument.xml": 50_000_000 * " "},
    "a large shape": {"Document.xml": "<Document/>", "PartShape.brp": 50_000_000 * "0"},
}


@pytest.mark.parametrize("case", DOCUMENTS)
def test_a_hostile_document_is_refused_in_time(tmp_path, case):
    path = packed(tmp_path / "d.FCStd", DOCUMENTS[case])
    start = time.process_time()
    with pytest.raises(Refused) as refused:
        archive.read_contents(path)
    assert refused.value.code in ("document-not-one", "document-too-large")
    assert time.process_time() - start < 5


def test_a_long_token_takes_no_more_than_its_size(tmp_path):
    text = b"<Document><!--" + bytes(range(48, 58)) * 2_000_000 + b"--></Document>"
    path = packed(tmp_path / "d.FCStd", {"Document.xml": text}, zipfile.ZIP_STORED)
    start = time.process_time()
    assert archive.read_contents(path).types == {}
    assert time.process_time() - start < 5


@pytest.mark.parametrize("data", [b"", b"PK\3\4", GOOD.read_bytes()[:9_000], damaged()], ids=range(4))
def test_a_broken_archive_is_refused(tmp_path, data):
    (tmp_path / "d.FCStd").write_bytes(data)
    with pytest.raises(Refused):
        archive.read_contents(tmp_path / "d.FCStd")
    with pytest.raises(Refused):
        archive.check_whole(tmp_path / "d.FCStd")


def test_every_cut_of_a_document_is_refused_or_read(tmp_path):
    data = GOOD.read_bytes()
    whole = archive.read_contents(GOOD)
    assert whole.types and whole.modules
    archive.check_whole(GOOD)
    for end in range(0, len(data) - 100, max(1, len(data) // 60)):
        (tmp_path / "d.FCStd").write_bytes(data[:end])
        with pytest.raises(Refused):
            archive.read_contents(tmp_path / "d.FCStd")


def test_view_data_with_a_name_that_is_no_text_is_kept(tmp_path):
    view = b'<Document><a file="\xff"/><b file="Side"/></Document>'
    original = packed(tmp_path / "a.FCStd", {"Document.xml": "<Document/>", "GuiDocument.xml": view, "Side": "1"})
    saved = packed(tmp_path / "b.FCStd", {"Document.xml": "<Document/>", "Side": "2"})
    assert archive.keep_view(original, saved)
    with zipfile.ZipFile(saved) as found:
        assert found.read("GuiDocument.xml") == b'<Document><a file="\xff"/><b file="Side_1"/></Document>'
        assert (found.read("Side"), found.read("Side_1")) == (b"2", b"1")


@pytest.mark.parametrize(("program", "status"), [("/bin/true", 0), ("/bin/false", 1)])
def test_a_program_that_is_no_freecad_is_refused(tmp_path, monkeypatch, capfd, program, status):
    monkeypatch.setenv("SENS_FREECADCMD", program)
    with pytest.raises(Refused) as refused:
        handoff.run(["sensitivity", str(GOOD), "--out", str(tmp_path / "o")])
    assert refused.value.code == "freecad-did-nothing"
    assert cli.main(["sensitivity", str(GOOD), "--out", str(tmp_path / "o")]) == 2
    assert "SENS_FREECADCMD" in capfd.readouterr().err


def test_a_closed_stream_does_not_stop_the_hand_over(monkeypatch):
    monkeypatch.setattr("sys.stdout", None)
    monkeypatch.setattr("sys.__stdout__", None)
    monkeypatch.setenv("SENS_FREECADCMD", "/bin/false")
    with pytest.raises(Refused):
        handoff.run(["sensitivity"])


@pytest.mark.skipif(os.name != "posix", reason="paths are bytes on POSIX systems only")
def test_a_document_in_a_folder_whose_name_is_not_utf8_is_refused_for_its_path(tmp_path, monkeypatch):
    monkeypatch.setenv("SENS_FREECADCMD", "/bin/true")
    folder = os.fsencode(tmp_path) + b"/a\xff"
    os.mkdir(folder)
    path = os.fsdecode(folder + b"/m.FCStd")
    Path(path).write_bytes(GOOD.read_bytes())
    with pytest.raises(Refused) as refused:
        handoff.run(["sensitivity", path, "--out", str(tmp_path / "o")])
    assert refused.value.code == "document-path-not-utf8"
    refused.value.message.encode("utf-8")
