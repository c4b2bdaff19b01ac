# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run one verb of the command line inside freecadcmd, from plain Python, with its true exit status.

freecadcmd given a script file ends with 0 whatever happened, refuses options, and opens files that it finds among the
arguments; given code with -c it does none of that.  Therefore the arguments are passed in the environment.  Needs no
FreeCAD.
"""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

from ..core.refusal import Refused

NAMES = ("freecadcmd", "FreeCADCmd", "freecad.cmd", "freecadcmd-daily")
ROOT = Path(__file__).resolve().parents[2]

# What FreeCAD is told.  Short on purpose: 1.1 takes code of more than 255 characters for a file name, and dies of it.
CODE = "import os, runpy; runpy.run_path(os.environ['SENS_HANDOFF_SCRIPT'])"


def freecadcmd() -> str:
    """FreeCAD's command-line program: SENS_FREECADCMD, or the path; refuses when there is none."""
    stated = os.environ.get("SENS_FREECADCMD")
    if stated:
        found = shutil.which(stated)
        if not found:
            raise Refused("freecad-no-program", "SENS_FREECADCMD", program=repr(stated))
        return found
    for name in NAMES:
        found = shutil.which(name)
        if found:
            return found
    raise Refused("freecad-missing", "FreeCAD")


def run(argv: Sequence[str]) -> int:
    """Run `python -m sensworkbench ARGV` inside FreeCAD, with the user's own add-ons; returns its exit status."""
    for word in argv:
        _check_path(str(word))
    program = freecadcmd()
    shared = os.name == "posix"  # elsewhere a child cannot be given streams, and FreeCAD's chatter stays in between
    streams = list(_streams()) if shared else []
    heard, told = os.pipe() if shared else (-1, -1)  # through which the verb says that it is FreeCAD that runs it
    job = {"argv": [str(a) for a in argv], "root": str(ROOT), "streams": streams, "answer": told}
    script = Path(__file__).with_name("inside.py")
    environment = dict(os.environ, SENS_HANDOFF=json.dumps(job), SENS_HANDOFF_SCRIPT=str(script))
    try:
        with tempfile.TemporaryFile() as chatter:
            status = subprocess.run(
                [program, "-c", CODE],
                env=environment,
                pass_fds=[*streams, told] if shared else (),
                stdin=subprocess.DEVNULL,
                stdout=chatter if shared else None,
                stderr=chatter if shared else None,
            ).returncode
            if status == -signal.SIGINT:
                raise KeyboardInterrupt
            if shared and status in (0, 1, 2, 130):
                os.close(told)
                told = -1
                if not os.read(heard, 1):
                    raise Refused("freecad-did-nothing", program)
            if status not in (0, 1, 2, 130):
                chatter.seek(0)
                tail = chatter.read()[-2000:].decode(errors="replace").strip()
                sys.stderr.write(f"FreeCAD ended with status {status}.\n{tail}\n")
                return 1
            return status
    finally:
        for handle in (*streams, heard, told):
            if handle >= 0:
                os.close(handle)


def _check_path(word: str) -> None:
    """Refuse a document in a folder whose name is not UTF-8, which FreeCAD cannot open."""
    if word.lower().endswith(".fcstd"):
        path = os.path.abspath(word)
        try:
            path.encode("utf-8")
        except UnicodeEncodeError:
            raise Refused("document-path-not-utf8", os.fsencode(path).decode("utf-8", "replace")) from None


def _streams():
    """Descriptors of the current streams, of the original ones where those were replaced, else of nowhere."""
    for now, original in ((sys.stdout, sys.__stdout__), (sys.stderr, sys.__stderr__)):
        for stream in (now, original):
            try:
                stream.flush()
                handle = os.dup(stream.fileno())
                break
            except (AttributeError, OSError, ValueError):  # closed, or no file
                continue
        else:
            handle = os.open(os.devnull, os.O_WRONLY)
        yield handle
