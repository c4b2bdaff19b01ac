# SPDX-License-Identifier: LGPL-2.1-or-later
"""A set of files changes as one: stopped or refused at every single operation there is the old set or the new one."""

from __future__ import annotations

import errno
import json
import os

import pytest

from sensworkbench.core.refusal import Refused
from sensworkbench.formats import file_sets, files, manifest, operations, provenance

OLD = {"a.json": '{"n": 1}\n', "b.csv": "n\n1\n", "gone.txt": "old\n", "sub/c.txt": "old\n"}
NEW = {"a.json": '{"n": 2}\n', "b.csv": "n\n2\n", "fresh.txt": "new\n", "sub/c.txt": "new\n"}


class Stopped(BaseException):
    """What a kill looks like from inside: nothing runs after it, so nothing of ours may catch it."""


class Injector(operations.Operations):
    """Counts operations, and at the chosen one fails (OSError) or is stopped, for good: all later ones stop too."""

    def __init__(self, at: int, how: str, after: bool = False):
        self.at, self.how, self.after, self.count, self.dead = at, how, after, 0, False

    def _do(self, name, *args):
        if name in ("lock", "unlock"):
            return getattr(operations.Operations, name)(self, *args)
        if self.dead:
            raise Stopped
        self.count += 1
        if self.count == self.at and not self.after:
            self._strike(name)
        done = getattr(operations.Operations, name)(self, *args)
        if self.count == self.at and self.after:
            self._strike(name)
        return done

    def _strike(self, name):
        if self.how == "kill":
            self.dead = True
            raise Stopped
        raise OSError(errno.ENOSPC, "No space left on device", name)


NAMES = ("make_folder", "write", "append", "flush", "replace", "link", "remove", "remove_folder", "lock", "unlock")
for _name in NAMES:
    setattr(Injector, _name, lambda self, *args, _name=_name: self._do(_name, *args))


def put(folder, texts, verb="try"):
    with file_sets.staged(folder, verb) as work:
        for name, text in texts.items():
            (work / name).parent.mkdir(exist_ok=True)
            files.write_text(work / name, text)


def seen(folder) -> dict[str, str]:
    """What a person sees in the folder: names without hidden ones, and texts."""
    found = (p for p in folder.rglob("*") if p.is_file())
    names = {p.relative_to(folder).as_posix(): p for p in found}
    return {n: p.read_text() for n, p in names.items() if not n.startswith(".sens-") and n != "manifest.json"}


def hidden(folder):
    return [p for p in folder.rglob(".sens-*")]


def count_of(folder) -> int:
    counter = Injector(0, "")
    with operations.replaced(counter):
        put(folder, NEW)
    return counter.count


def cases(tmp_path, existed):
    if existed:
        put(tmp_path / "count", OLD)
    return range(1, count_of(tmp_path / "count") + 1)


@pytest.mark.parametrize("existed", [True, False], ids=["old set", "no set"])
@pytest.mark.parametrize("after", [False, True], ids=["before", "after"])
def test_killed_at_every_operation_the_next_command_finds_one_whole_set(tmp_path, existed, after):
    outcomes = set()
    before = OLD if existed else {}
    for at in cases(tmp_path, existed):
        folder = tmp_path / f"k{at}"
        if existed:
            put(folder, OLD)
        with operations.replaced(Injector(at, "kill", after)), pytest.raises(Stopped):
            put(folder, NEW)
        file_sets.recover(folder)
        file_sets.recover(tmp_path)
        now = seen(folder)
        assert now in (before, NEW), (at, now)
        assert not hidden(tmp_path), at
        if now:
            whole(folder)
        outcomes.add(json.dumps(now))
    assert len(outcomes) == 2  # some of the kills come before the point of no return, some after


@pytest.mark.parametrize("existed", [True, False], ids=["old set", "no set"])
def test_refused_at_every_operation_nothing_is_changed(tmp_path, existed):
    refused = 0
    before = OLD if existed else {}
    for at in cases(tmp_path, existed):
        folder = tmp_path / f"f{at}"
        if existed:
            put(folder, OLD)
        try:
            with operations.replaced(Injector(at, "fail")):
                put(folder, NEW)
        except Refused as error:
            refused += 1
            assert error.code == "file-not-written"
            assert seen(folder) == before, at
            assert existed or not folder.exists()
            assert len(error.message) < 300 + len(str(folder))
        else:
            assert seen(folder) == NEW, at  # the fault hit the tidying up, or a second name that was not needed
        file_sets.recover(folder)
        file_sets.recover(tmp_path)
        assert not hidden(tmp_path), at
        if seen(folder):
            whole(folder)
    assert refused > 5


def test_a_disk_that_fails_for_good_during_the_moves_is_sorted_out_by_the_next_command(tmp_path):
    class Worse(Injector):
        def _strike(self, name):
            self.at += 1  # and at the next one again
            raise OSError(errno.EIO, "Input/output error", name)

    results = set()
    for at in cases(tmp_path, True):
        folder = tmp_path / f"w{at}"
        put(folder, OLD)
        with operations.replaced(Worse(at, "fail")), pytest.raises((Refused, OSError)):
            put(folder, NEW)
            raise Refused("file-not-written", "", why="the fault hit the tidying up")
        file_sets.recover(folder)
        assert seen(folder) in (OLD, NEW), at
        assert not hidden(tmp_path), at
        whole(folder)
        results.add(len(seen(folder)))
    assert results


def whole(folder):
    """Every file that the manifest names is there with its sum."""
    stated = manifest.load(folder / "manifest.json")
    for entry in stated["sets"]:
        for file in entry["files"]:
            assert provenance.sha256(folder / file["name"]) == (file["sha256"], file["bytes"])
    assert {f["name"] for e in stated["sets"] for f in e["files"]} == set(seen(folder))


# -- what belongs together ---------------------------------------------------------------------------------------------
def test_files_of_an_earlier_set_of_the_verb_go_with_it_and_no_others(tmp_path):
    folder = tmp_path / "o"
    put(folder, OLD)
    (folder / "mine.txt").write_text("mine")
    put(folder, {"report.html": "<html></html>"}, "other")
    put(folder, NEW)
    assert seen(folder) == NEW | {"mine.txt": "mine", "report.html": "<html></html>"}
    assert {s["verb"] for s in manifest.load(folder / "manifest.json")["sets"]} == {"try", "other"}


def test_a_left_file_that_somebody_changed_stays(tmp_path):
    put(tmp_path / "o", OLD)
    (tmp_path / "o" / "gone.txt").write_text("edited")
    put(tmp_path / "o", NEW)
    assert seen(tmp_path / "o")["gone.txt"] == "edited"


def test_a_file_of_another_verb_that_is_written_over_is_named(tmp_path):
    put(tmp_path / "o", {"report.html": "<html></html>", "a.json": "{}"}, "one")
    put(tmp_path / "o", {"report.html": "<html> </html>"}, "two")
    one, two = manifest.load(tmp_path / "o" / "manifest.json")["sets"]
    assert [f["name"] for f in one["files"]] == ["a.json"] and one["written_over"] == ["report.html"]
    assert [f["name"] for f in two["files"]] == ["report.html"]


def test_the_manifest_names_the_run_and_what_it_read(tmp_path):
    (tmp_path / "in.txt").write_text("given")
    with provenance.running("try", ("try", "in.txt"), seed=7):
        assert files.read_text(tmp_path / "in.txt") == "given"
        put(tmp_path / "o", NEW)
    (entry,) = manifest.load(tmp_path / "o" / "manifest.json")["sets"]
    assert (entry["command"], entry["seed"]) == (["try", "in.txt"], 7)
    (given,) = entry["inputs"]
    assert (given["sha256"], given["bytes"]) == provenance.sha256(tmp_path / "in.txt")


@pytest.mark.parametrize("words", [["a", "--out", "x", "b"], ["a", "--out=x", "b"], ["a", "b", "--out"]])
def test_the_place_of_the_result_is_no_part_of_the_command(words):
    assert provenance.without_out(words) == ("a", "b")


@pytest.mark.parametrize(
    "text",
    [
        "",
        "[]",
        '{"format": "sens-manifest", "version": 2, "sets": []}',
        '{"format": "sens-manifest", "version": 1, "sets": [{}]}',
        *(
            json.dumps({"format": "sens-manifest", "version": 1, "sets": [
                {"verb": "", "made_by": "", "command": [], "inputs": [],
                 "files": [{"name": name, "sha256": 64 * "0", "bytes": 1}]}]})
            for name in ("../x", "/etc/passwd", "a/../../b", "", ".sens-00000000/new", "c:\\x")
        ),
    ],
)  # fmt: skip
def test_a_manifest_that_reaches_out_is_refused(text):
    with pytest.raises(Refused):
        manifest.loads(text)


@pytest.mark.parametrize("name", ["../victim", "/etc/passwd", "link/victim"])
def test_a_journal_that_reaches_out_is_refused(tmp_path, name):
    (tmp_path / "victim").write_text("mine")
    folder = tmp_path / "o"
    work = folder / ".sens-01234567"
    (work / "new" / "link").mkdir(parents=True)
    (folder / "link").symlink_to(tmp_path)
    (work / "new" / "link" / "victim").write_text("bad")
    (work / "journal.json").write_text(
        json.dumps({"place": "..", "moves": [{"name": name, "existed": True}], "stale": ["link/victim"]})
    )
    with pytest.raises(Refused):
        file_sets.recover(folder)
    assert (tmp_path / "victim").read_text() == "mine"


# -- places that cannot be written -------------------------------------------------------------------------------------
def test_a_name_that_a_folder_has_is_refused_before_anything_moves(tmp_path):
    put(tmp_path / "o", OLD)
    (tmp_path / "o" / "fresh.txt").mkdir()
    with pytest.raises(Refused) as refused:
        put(tmp_path / "o", NEW)
    assert refused.value.code == "file-is-folder"
    assert seen(tmp_path / "o") == OLD and not hidden(tmp_path)


@pytest.mark.skipif(os.name != "posix", reason="links and pipes of POSIX")
def test_links_and_devices_are_refused_or_followed(tmp_path):
    (tmp_path / "o").mkdir()
    os.mkfifo(tmp_path / "o" / "a.json")
    with pytest.raises(Refused) as refused:
        put(tmp_path / "o", NEW)
    assert refused.value.code == "file-is-device"
    (tmp_path / "o" / "a.json").unlink()
    (tmp_path / "far").write_text("far")
    (tmp_path / "o" / "a.json").symlink_to(tmp_path / "far")
    with pytest.raises(Refused) as refused:
        put(tmp_path / "o", NEW)
    assert refused.value.code == "out-link-in-set"
    (tmp_path / "o" / "a.json").unlink()
    (tmp_path / "alias").symlink_to(tmp_path / "o")
    put(tmp_path / "alias", NEW)  # a link to a folder is that folder
    assert (tmp_path / "alias").is_symlink() and seen(tmp_path / "o") == NEW
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    for act in (lambda: files.read_text(pipe), lambda: files.write_text(pipe, "x"), lambda: put(pipe, NEW)):
        with pytest.raises(Refused):
            act()


@pytest.mark.skipif(os.name != "posix", reason="links of POSIX")
def test_one_file_is_written_through_a_link(tmp_path):
    (tmp_path / "far").write_text("old")
    (tmp_path / "near").symlink_to(tmp_path / "far")
    files.write_text(tmp_path / "near", "new")
    assert (tmp_path / "near").is_symlink() and (tmp_path / "far").read_text() == "new"
    (tmp_path / "round").symlink_to(tmp_path / "about")
    (tmp_path / "about").symlink_to(tmp_path / "round")
    with pytest.raises(Refused) as refused:
        files.write_text(tmp_path / "round", "new")
    assert refused.value.code == "out-link" and (tmp_path / "round").is_symlink()


def test_an_empty_name_is_refused(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for act in (lambda: put("", NEW), lambda: files.write_text("", "x")):
        with pytest.raises(Refused) as refused:
            act()
        assert refused.value.code == "out-empty"
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("length", [200, 245, 255])
def test_names_as_long_as_the_disk_takes_them(tmp_path, length):
    name = length * "n"
    files.write_text(tmp_path / name, "x")
    with file_sets.staged_file(tmp_path / (length * "m"), "try") as work:
        files.write_text(work, "x")
    assert (tmp_path / name).read_text() == (tmp_path / (length * "m")).read_text() == "x"


def test_what_a_stopped_run_left_is_removed_by_the_next_one(tmp_path):
    (tmp_path / ".sens-0123abcd" / "new").mkdir(parents=True)
    (tmp_path / ".sens-0123abcd" / "new" / "a").write_text("half")
    (tmp_path / ".sens-mine").mkdir()
    old = tmp_path / ".sens-0123abcd.part"
    old.write_text("half")
    os.utime(old, (0, 0))
    files.write_text(tmp_path / "x", "x")
    put(tmp_path / "o", NEW)
    assert {p.name for p in tmp_path.iterdir()} == {"x", "o", ".sens-mine"}


def test_another_run_that_goes_on_is_left_alone(tmp_path):
    folder = tmp_path / "o"
    put(folder, OLD)
    with file_sets.staged(folder, "slow") as slow:
        files.write_text(slow / "s.txt", "slow")
        put(folder, NEW)
        assert slow.is_dir()
    assert seen(folder) == NEW | {"s.txt": "slow"}
    assert {s["verb"] for s in manifest.load(folder / "manifest.json")["sets"]} == {"try", "slow"}


# -- what was written is read back -------------------------------------------------------------------------------------
@pytest.mark.parametrize(
    ("name", "data"),
    [
        ("a.json", b'{"n": NaN}'),
        ("a.json", b'{"n": 1e999}'),
        ("a.json", b'{"n": 1'),
        ("a.json", b'{"format": "sens-machine", "version": 1}'),
        ("a.csv", b"a,b\n1,2\n3,nan\n"),
        ("a.csv", b"a,b\n1,2\n-inf,4\n"),
        ("a.npz", b"PK no zip"),
        ("a.FCStd", b""),
        ("a.html", b"<html><body>"),
        ("a.png", b"\x89PNG\r\n\x1a\n"),
    ],
)
def test_a_file_that_is_not_whole_never_takes_its_name(tmp_path, name, data):
    put(tmp_path / "o", {name: ""} if name.endswith(".txt") else OLD)
    with pytest.raises(Refused), file_sets.staged(tmp_path / "o", "try") as work:
        files.write_bytes(work / name, data)
    assert seen(tmp_path / "o") == OLD and not hidden(tmp_path)


def test_texts_in_a_table_may_be_called_anything(tmp_path):
    put(tmp_path / "o", {"a.csv": "mood,n\nnan,1\ngood,2\n"})
