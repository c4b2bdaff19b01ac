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
            raise Refused(f"there is no program {stated!r}", "SENS_FREECADCMD", "Name freecadcmd with its folder.")
        return found
    for name in NAMES:
        found = shutil.which(name)
        if found:
            return found
    raise Refused(
        "a FreeCAD document needs FreeCAD, and freecadcmd is not on the path",
        "FreeCAD",
        "Install FreeCAD, or set SENS_FREECADCMD to its freecadcmd.",
    )


def run(argv: Sequence[str]) -> int:
    """Run `python -m sensworkbench ARGV` inside FreeCAD, with the user's own add-ons; returns its exit status."""
    program = freecadcmd()
    shared = os.name == "posix"  # elsewhere a child cannot be given streams, and FreeCAD's chatter stays in between
    streams = [os.dup(stream.fileno()) for stream in _streams()] if shared else []
    job = {"argv": [str(a) for a in argv], "root": str(ROOT), "streams": streams}
    script = Path(__file__).with_name("inside.py")
    environment = dict(os.environ, SENS_HANDOFF=json.dumps(job), SENS_HANDOFF_SCRIPT=str(script))
    try:
        with tempfile.TemporaryFile() as chatter:
            status = subprocess.run(
                [program, "-c", CODE],
                env=environment,
                pass_fds=streams,
                stdin=subprocess.DEVNULL,
                stdout=chatter if shared else None,
                stderr=chatter if shared else None,
            ).returncode
            if status not in (0, 1, 2, 130):
                chatter.seek(0)
                tail = chatter.read()[-2000:].decode(errors="replace").strip()
                sys.stderr.write(f"FreeCAD ended with status {status}.\n{tail}\n")
                return 1
            return status
    finally:
        for stream in streams:
            os.close(stream)


def _streams():
    """Streams with a descriptor: the current ones, or the original ones where those were replaced."""
    for now, original in ((sys.stdout, sys.__stdout__), (sys.stderr, sys.__stderr__)):
        now.flush()
        try:
            now.fileno()
        except (AttributeError, OSError, ValueError):
            now = original
        yield now
