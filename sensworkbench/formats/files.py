# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files in and out: read whole files with a limit, write one so that it is never half written.

Only regular files are read and written: a folder, a device, a pipe or a socket is refused before it is opened, and a
link to a file is followed.  A set of files that belong together is written by `file_sets`.
"""

from __future__ import annotations

import contextlib
import errno
import os
import secrets
import stat
import time
from pathlib import Path

from sensworkbench.core.refusal import Refused

from . import operations, provenance

TEXT_LIMIT = 16 * 2**20  # bytes
MARK = ".sens-"  # begins the name of everything that is there for a moment only
LEFT_AFTER = 3600.0  # seconds after which such a file was left behind by a run that was stopped
DISK = (errno.ENOSPC, errno.EDQUOT, errno.EROFS, errno.EFBIG, errno.EIO, errno.EACCES, errno.EPERM)
DISK += (errno.ENAMETOOLONG, errno.ENOTDIR, errno.EISDIR, errno.ENOTEMPTY, errno.EBUSY, errno.EEXIST, errno.ENODEV)


def reason(error: OSError) -> str:
    """The operating system's words for an error, without its number and path."""
    return (error.strerror or type(error).__name__).lower()


def read_bytes(path, limit: int, note: bool = True) -> bytes:
    """The bytes of a regular file, at most `limit`.  Refuses anything else.

    note : they become an input of the run; false for what a run reads only in order to change it.
    """
    name = str(path)
    try:
        # not to wait for the other end of a pipe
        handle = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0))
    except (OSError, ValueError) as error:
        if isinstance(error, OSError) and os.path.isdir(path):  # Windows opens no folder
            raise Refused("file-is-folder", name) from None
        words = reason(error) if isinstance(error, OSError) else str(error)
        raise Refused("file-not-read", name, why=words) from None
    try:
        mode, size = os.fstat(handle).st_mode, os.fstat(handle).st_size
        if not stat.S_ISREG(mode):
            raise Refused("file-is-folder" if stat.S_ISDIR(mode) else "file-is-device", name)
        with os.fdopen(handle, "rb", closefd=False) as stream:
            data = stream.read(min(limit, size) + 1)
            if size < len(data) <= limit:  # longer than it was said to be
                data += stream.read(limit + 1 - len(data))
    except OSError as error:
        raise Refused("file-not-read", name, why=reason(error)) from None
    finally:
        os.close(handle)
    if len(data) > limit:
        raise Refused("file-too-large", name, limit=f"{limit / 2**20:g}")
    if note:
        provenance.note_input(path, data)
    return data


def read_text(path, limit: int = TEXT_LIMIT) -> str:
    """The text of a UTF-8 file (a byte order mark is dropped).

    Refuses what is missing, no regular file, longer than `limit` bytes, or not UTF-8 (with the line of the first bad
    byte).
    """
    data = read_bytes(path, limit)
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        raise Refused("file-not-utf8", f"{path}, line {line}") from None


def target(path) -> Path:
    """The regular file, there or not, that a result named `path` is written to: a link is followed.

    Refuses an empty name, a folder, a device, a link that leads nowhere.
    """
    if not str(path) or str(path) == ".":
        raise Refused("out-empty", "--out")
    found = operations.absolute(path)
    if operations.kind(found) == "link":
        try:
            found = found.resolve(strict=False)
        except (OSError, RuntimeError):  # a circle of links
            raise Refused("out-link", str(path)) from None
    what = operations.kind(found)
    if what == "folder":
        raise Refused("file-is-folder", str(path))
    if what == "link":
        raise Refused("out-link", str(path))
    if what == "device":
        raise Refused("file-is-device", str(path))
    return found


def write_bytes(path, data: bytes) -> None:
    """Write `data` to `path` in one step: afterwards there is the old file or the new one, never a part."""
    act = operations.current()
    with contextlib.ExitStack() as stack:
        stack.enter_context(written(path))
        place = target(path)
        stack.enter_context(made_folders(place.parent))
        remove_left(place.parent)
        work = place.parent / f"{MARK}{secrets.token_hex(4)}.part"
        try:
            act.write(work, data)
            act.replace(work, place)
        except BaseException:
            with contextlib.suppress(OSError):
                act.remove(work)
            raise


def write_text(path, text: str) -> None:
    """`write_bytes` of UTF-8 text."""
    write_bytes(path, text.encode("utf-8"))


@contextlib.contextmanager
def written(path):
    """Turn what the disk refuses within the block into a refusal of the result `path`.

    A file in the hidden folder of a set is nothing that a user knows: the set names itself.
    """
    try:
        yield
    except OSError as error:
        hidden = any(part.startswith(MARK) for part in Path(path).parts)
        if hidden or (error.errno not in DISK and not isinstance(error, FileNotFoundError)):
            raise
        raise Refused("file-not-written", str(path), why=reason(error)) from None


@contextlib.contextmanager
def made_folders(folder: Path):
    """Make `folder` and its missing parents; if the block raises, remove the folders that were made."""
    act = operations.current()
    missing = []
    while not folder.exists():
        missing.append(folder)
        folder = folder.parent
    made = []
    try:
        for path in reversed(missing):
            act.make_folder(path)
            made.append(path)
        yield
    except BaseException:
        for path in reversed(made):
            with contextlib.suppress(OSError):
                act.remove_folder(path)
        raise


def remove_left(folder: Path) -> None:
    """Remove single files that an earlier run was writing to `folder` when it was stopped."""
    with contextlib.suppress(OSError), os.scandir(folder) as entries:
        for entry in entries:
            if entry.name.startswith(MARK) and entry.name.endswith(".part") and entry.is_file(follow_symlinks=False):
                if time.time() - entry.stat(follow_symlinks=False).st_mtime > LEFT_AFTER:
                    operations.current().remove(entry.path)


def neutral(text) -> str:
    """A text cell for CSV that no spreadsheet takes for a formula: = + - @, tab and return at its start get a quote."""
    text = str(text)
    return "'" + text if text[:1] in ("=", "+", "-", "@", "\t", "\r") else text
