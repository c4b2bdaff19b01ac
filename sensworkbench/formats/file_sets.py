# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that belong together change together: a folder holds the whole old set or the whole new one.

The files of a run are made in a hidden folder, read back, and then moved.  Where the result's folder did not exist, the
hidden one takes its name in one step.  Into a folder that exists no system moves several files in one step: a journal
says what is to be moved, and whoever comes next (a command that writes there, or `verify`) finishes what a stopped run
left, before anything else; a move that the disk refuses is undone.  `manifest.json`, moved last, names the files of
each set with their sums, so that a reader knows which set is whole.
"""

from __future__ import annotations

import contextlib
import json
import os
import re
import secrets
import signal
import threading
import time
from collections.abc import Iterator
from pathlib import Path

from sensworkbench.core.refusal import Refused

from . import file_checks, files, manifest, operations, provenance

JOURNAL, UNDO, NEW, OLD = "journal.json", "undo.json", "new", "old"
HIDDEN = re.compile(re.escape(files.MARK) + "[0-9a-f]{8}")
MOVING = 60.0  # seconds that moving may take at most, where no lock tells whether a run goes on
PATIENCE = 30.0  # seconds to wait for another run that moves its files into the same folder


@contextlib.contextmanager
def staged(folder, verb: str = "") -> Iterator[Path]:
    """A folder for the files of a set; they appear in `folder` when the block ends well, and with them its manifest.

    When the block raises, `folder` is as it was (and is not made if it did not exist).  verb : names the set, by
    default that of the run.  Files of the folder's earlier set of this verb that the new one lacks are removed;
    others stay.  Refuses a folder that cannot be written, and files that are not whole.
    """
    with _set(folder, None, verb) as work:
        yield work


@contextlib.contextmanager
def staged_file(path, verb: str = "") -> Iterator[Path]:
    """Yield a temporary path for one result; it is renamed to `path`, with its manifest, if the block ends without an
    error.
    """
    with files.written(path):
        place = files.target(path)
    with _set(place.parent, place.name, verb, shown=path) as work:
        yield work / place.name


@contextlib.contextmanager
def _set(folder, name: str | None, verb: str, shown=None) -> Iterator[Path]:
    if not str(folder):
        raise Refused("out-empty", "--out")
    shown = folder if shown is None else shown
    run = provenance.current()
    verb = verb or (run.verb if run else "")
    with contextlib.ExitStack() as stack:
        stack.enter_context(files.written(shown))
        place = _folder(folder)
        exists = operations.kind(place) == "folder"
        outer = place if exists else place.parent
        stack.enter_context(files.made_folders(outer))
        recover(place)
        recover(place.parent)
        work = _Work(outer)
        try:
            yield work.new
            work.seal(verb, name)
            with _uninterrupted():
                work.move_in(place, verb, name)
        finally:
            work.leave()


def _folder(folder) -> Path:
    """The folder, there or not, links followed; refuses what is something else."""
    place = operations.absolute(folder)
    if operations.kind(place) == "link":
        try:
            place = place.resolve(strict=False)
        except (OSError, RuntimeError):
            raise Refused("out-link", str(folder)) from None
    what = operations.kind(place)
    if what == "link":
        raise Refused("out-link", str(folder))
    if what in ("file", "device"):
        raise Refused("out-not-a-folder", str(folder))
    return place


class _Work:
    """The hidden folder of one set: `new` holds what is to be moved, `old` what was in its place."""

    def __init__(self, outer: Path):
        act = operations.current()
        self.path = outer / f"{files.MARK}{secrets.token_hex(4)}"
        self.new = self.path / NEW
        self.keep = False
        with _locked(outer):
            act.make_folder(self.path)
            self.lock = act.lock(self.path)
        try:
            act.make_folder(self.new)
        except BaseException:
            self.leave()
            raise

    def seal(self, verb: str, name: str | None) -> None:
        """Read everything back, and put the manifest beside it."""
        found = _files_below(self.new)
        if name is not None:
            found = [f for f in found if f == name]
        for relative in found:
            operations.current().flush(self.new / relative)
            file_checks.check(self.new / relative, relative)
        self.stated = manifest.made(verb, self.new, found, name)

    def move_in(self, place: Path, verb: str, name: str | None) -> None:
        """Give the new files their names: all, or none and OSError."""
        act = operations.current()
        if operations.kind(place) == "":
            self._write_manifest(self.stated, name)
            try:
                act.replace(self.new, place)
                return
            except OSError:
                if operations.kind(place) != "folder":  # nobody else made it
                    raise
            act.remove(self.new / manifest.name_of(name))
        with _locked(place):
            _recover(place, self.path)
            merged, stale = manifest.merged(place, self.stated, name)
            self._write_manifest(merged, name)
            moves = _files_below(self.new)
            last = manifest.name_of(name)
            moves = [m for m in moves if m != last] + [m for m in moves if m == last]
            for relative in (*moves, *stale):
                _check_target(place, relative)
            journal = {
                "place": os.path.relpath(place, self.path),
                "moves": [{"name": m, "existed": operations.kind(place / m) == "file"} for m in moves],
                "stale": stale,
            }
            act.make_folder(self.path / OLD)
            act.write(self.path / "journal.part", json.dumps(journal).encode())
            act.replace(self.path / "journal.part", self.path / JOURNAL)
            try:
                _forward(self.path, place, journal)
            except BaseException:
                self.keep = True  # should the way back fail too, the journal tells the next command
                act.replace(self.path / JOURNAL, self.path / UNDO)
                _back(self.path, place, journal)
                self.keep = False
                raise

    def _write_manifest(self, stated: dict, name: str | None) -> None:
        path = self.new / manifest.name_of(name)
        if operations.kind(path) == "file":
            operations.current().remove(path)
        operations.current().write(path, manifest.dumps(stated).encode())

    def leave(self) -> None:
        """Remove the hidden folder; what cannot be removed now, the next command removes."""
        try:
            if not self.keep:
                with contextlib.suppress(OSError):
                    _remove_work(self.path)
        finally:
            if self.lock is not None:
                operations.current().unlock(self.lock)


def _files_below(folder: Path) -> list[str]:
    """Names, with / between folders, of all regular files below a folder, sorted."""
    found = (p for p in folder.rglob("*") if operations.kind(p) == "file")
    return sorted(p.relative_to(folder).as_posix() for p in found)


def _check_target(place: Path, relative: str) -> None:
    """Refuse a name that something else than a file of its own has, before anything is moved."""
    path = place
    for step in Path(relative).parts[:-1]:
        path = path / step
        if operations.kind(path) not in ("", "folder"):
            raise Refused("out-not-a-folder", str(path))
    what = operations.kind(place / relative)
    if what not in ("", "file"):
        code = {"folder": "file-is-folder", "link": "out-link-in-set", "device": "file-is-device"}[what]
        raise Refused(code, str(place / relative))


# -- moving ------------------------------------------------------------------------------------------------------------
def _forward(work: Path, place: Path, journal: dict) -> None:
    """Carry out the moves of the journal that are not done yet; the manifest is moved last."""
    act = operations.current()
    for name in journal["stale"]:
        if operations.kind(place / name) == "file" and not os.path.lexists(work / OLD / name):
            _make_parents(work / OLD, name)
            act.replace(place / name, work / OLD / name)
    for move in journal["moves"]:
        source, goal, kept = work / NEW / move["name"], place / move["name"], work / OLD / move["name"]
        if operations.kind(source) != "file":
            continue
        _make_parents(place, move["name"])
        if move["existed"] and not os.path.lexists(kept):
            _make_parents(work / OLD, move["name"])
            try:
                act.link(goal, kept)
            except OSError:  # no second names here: for a moment there is no file
                act.replace(goal, kept)
        act.replace(source, goal)


def _back(work: Path, place: Path, journal: dict) -> None:
    """Undo what was done of the journal."""
    act = operations.current()
    for move in reversed(journal["moves"]):
        source, goal, kept = work / NEW / move["name"], place / move["name"], work / OLD / move["name"]
        if operations.kind(kept) == "file":
            act.replace(kept, goal)
        elif not move["existed"] and operations.kind(source) == "" and operations.kind(goal) == "file":
            act.replace(goal, source)
        for parent in list(Path(move["name"]).parents)[:-1]:
            if not move["existed"]:
                with contextlib.suppress(OSError):
                    act.remove_folder(place / parent)
    for name in journal["stale"]:
        if operations.kind(work / OLD / name) == "file":
            act.replace(work / OLD / name, place / name)


def _make_parents(folder: Path, relative: str) -> None:
    for step in reversed(list(Path(relative).parents)[:-1]):
        if operations.kind(folder / step) == "":
            operations.current().make_folder(folder / step)


def _remove_work(path: Path) -> None:
    """Remove a hidden folder, its journal first: without one it is rubbish, with one it is a promise."""
    for name in (JOURNAL, UNDO):
        if operations.kind(path / name):
            operations.current().remove(path / name)
    operations.remove_tree(path)


# -- what a stopped run left -------------------------------------------------------------------------------------------
def recover(folder) -> None:
    """Finish or undo what a stopped run left in `folder`, and remove its hidden files.  Other runs are left alone."""
    folder = Path(folder)
    with contextlib.suppress(FileNotFoundError, NotADirectoryError, PermissionError):
        if any(map(HIDDEN.fullmatch, os.listdir(folder))):
            with _locked(folder):
                _recover(folder, None)


def pending(folder) -> bool:
    """Whether a stopped run left moves to be finished or undone in `folder`."""
    with contextlib.suppress(OSError):
        works = [Path(folder, n) for n in os.listdir(folder) if HIDDEN.fullmatch(n)]
        return any(operations.kind(w / j) for w in works for j in (JOURNAL, UNDO))
    return False


def _recover(folder: Path, mine: Path | None) -> None:
    act = operations.current()
    for name in sorted(os.listdir(folder)):
        work = folder / name
        if not HIDDEN.fullmatch(name) or operations.kind(work) != "folder" or work == mine:
            continue
        moving = any(operations.kind(work / j) for j in (JOURNAL, UNDO))
        lock = act.lock(work)
        if lock is None or (
            lock == -1 and time.time() - work.stat().st_mtime < (MOVING if moving else files.LEFT_AFTER)
        ):
            continue  # a run that goes on, or may go on
        try:
            for file, move in ((JOURNAL, _forward), (UNDO, _back)):
                if operations.kind(work / file) == "file":
                    place, journal = _read_journal(work / file, folder)
                    move(work, place, journal)
            _remove_work(work)
        finally:
            act.unlock(lock)


def _read_journal(path: Path, folder: Path) -> tuple[Path, dict]:
    """(folder of the results, journal); refuses one that would reach outside: it is a file like any other."""
    try:
        journal = json.loads(path.read_bytes())
        moves = [{"name": str(m["name"]), "existed": bool(m["existed"])} for m in journal["moves"]]
        stale = [str(name) for name in journal["stale"]]
        place = Path(os.path.normpath(path.parent / str(journal["place"])))
    except (ValueError, KeyError, TypeError, RecursionError):
        raise Refused("journal-damaged", str(path)) from None
    names = [m["name"] for m in moves] + stale
    inside = place == folder or place.parent == folder and operations.kind(place) == "folder"
    if not inside or not all(manifest.is_plain(name) for name in names):
        raise Refused("journal-damaged", str(path))
    for name in names:
        _check_target(place, name)
    return place, {"moves": moves, "stale": stale}


# -- one at a time -----------------------------------------------------------------------------------------------------
@contextlib.contextmanager
def _locked(folder: Path):
    """Hold `folder` against other runs that move files into it."""
    act = operations.current()
    end = time.monotonic() + PATIENCE
    while (lock := act.lock(folder)) is None:
        if time.monotonic() > end:
            raise Refused("out-busy", str(folder))
        time.sleep(0.02)
    try:
        yield
    finally:
        act.unlock(lock)


@contextlib.contextmanager
def _uninterrupted():
    """Hold Ctrl-C back until the end of the block; only the main thread receives it."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    came = []
    before = signal.getsignal(signal.SIGINT)
    if before is None:  # set by something that is not Python
        yield
        return
    signal.signal(signal.SIGINT, lambda *_: came.append(True))
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
        if came:
            raise KeyboardInterrupt
