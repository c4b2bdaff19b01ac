# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files in and out: read whole texts with a limit, write so that nothing is ever half written.

A single file goes to a temporary name beside its place and is then moved over it.  A folder of results is built in a
temporary folder first and moved file by file once all of it is there.
"""

from __future__ import annotations

import contextlib
import os
import shutil
import tempfile
from collections.abc import Iterator
from pathlib import Path

from sensworkbench.core.refusal import Refused

TEXT_LIMIT = 16 * 2**20  # bytes


def reason(error: OSError) -> str:
    """The operating system's words for an error, without its number and path."""
    return (error.strerror or type(error).__name__).lower()


def read_text(path, limit: int = TEXT_LIMIT) -> str:
    """The text of a UTF-8 file (a byte order mark is dropped).

    Refuses what is missing, a folder, longer than `limit` bytes, or not UTF-8 (with the line of the first bad byte).
    """
    path = Path(path)
    try:
        if path.is_dir():
            raise Refused("this is a folder, not a file", str(path))
        with open(path, "rb") as stream:
            data = stream.read(limit + 1)
    except (OSError, ValueError) as error:
        words = reason(error) if isinstance(error, OSError) else str(error)
        raise Refused(f"cannot be read: {words}", str(path), "Check the name and the permissions.") from None
    if len(data) > limit:
        raise Refused(f"is larger than {limit / 2**20:g} MiB", str(path), "Is this the right file?")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        raise Refused("is not UTF-8 text", f"{path}, line {line}", "Save it as UTF-8.") from None


def write_bytes(path, data: bytes) -> None:
    """Write `data` to `path` in one step: afterwards there is the old file or the new one, never a part."""
    path = Path(path)
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        handle, temporary = tempfile.mkstemp(prefix=f".{path.name}.", dir=path.parent)
    except OSError as error:
        raise Refused(f"cannot be written: {reason(error)}", str(path), "Choose another place.") from None
    try:
        with os.fdopen(handle, "wb") as stream:
            stream.write(data)
        os.chmod(temporary, 0o666 & ~_umask())
        os.replace(temporary, path)
    except OSError as error:
        raise Refused(f"cannot be written: {reason(error)}", str(path), "Choose another place.") from None
    finally:
        with contextlib.suppress(FileNotFoundError):
            os.unlink(temporary)


def write_text(path, text: str) -> None:
    """`write_bytes` of UTF-8 text."""
    write_bytes(path, text.encode("utf-8"))


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask


@contextlib.contextmanager
def staged(folder) -> Iterator[Path]:
    """A temporary folder beside `folder`; what is written there is moved into `folder` when the block ends well.

    When the block raises, `folder` is as it was (and is not made if it did not exist).  Files of the same name are
    replaced, others are left alone.
    """
    folder = Path(folder)
    if folder.exists() and not folder.is_dir():
        raise Refused("there is a file of this name already", str(folder), "Name a folder for the results.")
    made = []  # folders that this call had to make, outermost last
    parent = folder.absolute().parent
    try:
        while not parent.exists():
            made.append(parent)
            parent = parent.parent
        folder.absolute().parent.mkdir(parents=True, exist_ok=True)
        work = Path(tempfile.mkdtemp(prefix=f".{folder.name or 'out'}.", dir=folder.absolute().parent))
    except OSError as error:
        raise Refused(f"cannot be written: {reason(error)}", str(folder), "Choose another place.") from None
    done = False
    try:
        yield work
        try:
            _move_in(work, folder)
        except OSError as error:
            raise Refused(f"cannot be written: {reason(error)}", str(folder), "Choose another place.") from None
        done = True
    finally:
        shutil.rmtree(work, ignore_errors=True)
        if not done:
            for path in made:
                with contextlib.suppress(OSError):
                    path.rmdir()


def _move_in(work: Path, folder: Path) -> None:
    folder.mkdir(exist_ok=True)
    for source in sorted(work.rglob("*")):
        target = folder / source.relative_to(work)
        if source.is_dir():
            target.mkdir(exist_ok=True)
        else:
            os.replace(source, target)


def neutral(text) -> str:
    """A text cell for CSV that no spreadsheet takes for a formula: = + - @, tab and return at its start get a quote."""
    text = str(text)
    return "'" + text if text[:1] in ("=", "+", "-", "@", "\t", "\r") else text
