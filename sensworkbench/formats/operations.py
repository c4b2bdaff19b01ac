# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the file layer asks of the operating system, in one object that tests replace to fail or stop at any call.

Each method does one thing and raises OSError; nothing else in `files` and `file_sets` changes the disk.
"""

from __future__ import annotations

import contextlib
import os
import stat
from pathlib import Path

try:
    import fcntl
except ImportError:  # not POSIX: nothing is locked, see `lock`
    fcntl = None


class Operations:
    """The operations on this computer's disk."""

    def make_folder(self, path) -> None:
        """Make the folder `path`."""
        os.mkdir(path)

    def write(self, path, data: bytes) -> None:
        """Make the new file `path` and have it on the disk; refuses to write through what exists."""
        with open(path, "xb") as stream:
            stream.write(data)
            stream.flush()
            os.fsync(stream.fileno())

    def append(self, stream, data: bytes) -> None:
        """Add `data` to a binary file that is open for it, so that a process that ends here has written it."""
        stream.write(data)
        stream.flush()

    def flush(self, path) -> None:
        """Have what was written to a file on the disk."""
        handle = os.open(path, os.O_RDWR)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)

    def replace(self, source, target) -> None:
        """Give `source` the name `target`, in place of what has it, in one step."""
        os.replace(source, target)

    def link(self, source, target) -> None:
        """A second name for a file."""
        os.link(source, target)

    def remove(self, path) -> None:
        """Remove the file `path`."""
        os.unlink(path)

    def remove_folder(self, path) -> None:
        """Remove the empty folder `path`."""
        os.rmdir(path)

    def lock(self, path) -> int | None:
        """Hold a folder until `unlock`, or until the process ends.

        Returns a handle, -1 where folders cannot be locked here, None while another process holds it.
        """
        if fcntl is None:
            return -1
        handle = os.open(path, os.O_RDONLY)
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            os.close(handle)
            return None
        except OSError:  # a file system without locks
            os.close(handle)
            return -1
        return handle

    def unlock(self, handle: int) -> None:
        """Release what `lock` returned."""
        if handle >= 0:
            os.close(handle)


_operations = Operations()


def current() -> Operations:
    """The operations in use."""
    return _operations


@contextlib.contextmanager
def replaced(other: Operations):
    """Use `other` within the block (tests)."""
    global _operations
    before, _operations = _operations, other
    try:
        yield other
    finally:
        _operations = before


def remove_tree(path) -> None:
    """Remove a folder with everything in it; links are removed, never followed."""
    with os.scandir(path) as entries:
        found = sorted(entries, key=lambda e: e.name)
    for entry in found:
        if entry.is_dir(follow_symlinks=False):
            remove_tree(entry.path)
        else:
            current().remove(entry.path)
    current().remove_folder(path)


def kind(path) -> str:
    """What a path names, links not followed: "" nothing, "file", "folder", "link", or "device" (pipes, sockets too)."""
    try:
        mode = os.lstat(path).st_mode
    except (FileNotFoundError, NotADirectoryError):
        return ""
    if stat.S_ISREG(mode):
        return "file"
    if stat.S_ISDIR(mode):
        return "folder"
    return "link" if stat.S_ISLNK(mode) else "device"


def absolute(path) -> Path:
    """The path from the root, links in its folders followed, its own name not."""
    path = Path(os.path.abspath(path))
    return Path(os.path.realpath(path.parent)) / path.name if path.name else path
