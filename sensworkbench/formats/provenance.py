# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a run was made from: its verb and words, and the SHA-256 of every file that it has read.

The command line opens a run; whoever reads a file notes it; the manifest of the results states it.  The sum is that of
the bytes that were used, so that a file that changes while the run goes on is found by `verify`.
"""

from __future__ import annotations

import contextlib
import hashlib
from collections.abc import Iterator, Sequence
from contextvars import ContextVar
from dataclasses import dataclass, field
from pathlib import Path


@dataclass(frozen=True)
class Input:
    """A file that was read.  path : as it was named.  sha256 : of its bytes.  bytes : their number."""

    path: str
    sha256: str
    bytes: int


@dataclass
class Run:
    """One run.  verb : of the command line.  command : its words without --out.  seed : of what is random, or None."""

    verb: str
    command: tuple[str, ...] = ()
    seed: int | None = None
    inputs: dict[str, Input] = field(default_factory=dict)


_run: ContextVar[Run | None] = ContextVar("run", default=None)


def current() -> Run | None:
    """The run that goes on, or None."""
    return _run.get()


@contextlib.contextmanager
def running(verb: str, command: Sequence[str] = (), seed: int | None = None) -> Iterator[Run]:
    """The run of the block: what is read within it becomes an input of what is written within it."""
    run = Run(verb, tuple(command), seed)
    token = _run.set(run)
    try:
        yield run
    finally:
        _run.reset(token)


def note_input(path, data: bytes) -> None:
    """Record that `data` was read from `path` and will be used."""
    run = current()
    if run is not None and str(path) not in run.inputs:
        run.inputs[str(path)] = Input(str(path), hashlib.sha256(data).hexdigest(), len(data))


def note_file(path) -> None:
    """Record that the file `path` is read by other means (a FreeCAD document)."""
    run = current()
    if run is not None and str(path) not in run.inputs:
        digest, count = sha256(path)
        run.inputs[str(path)] = Input(str(path), digest, count)


def sha256(path) -> tuple[str, int]:
    """(SHA-256, number of bytes) of a file."""
    digest, count = hashlib.sha256(), 0
    with open(Path(path), "rb") as stream:
        while block := stream.read(2**20):
            digest.update(block)
            count += len(block)
    return digest.hexdigest(), count


def without_out(words: Sequence[str]) -> tuple[str, ...]:
    """The words of a command line without --out and its value."""
    kept: list[str] = []
    words = list(words)
    while words:
        word = words.pop(0)
        if word == "--out":
            del words[:1]
        elif not word.startswith("--out="):
            kept.append(word)
    return tuple(kept)
