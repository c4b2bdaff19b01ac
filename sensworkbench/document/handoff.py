# SPDX-License-Identifier: LGPL-2.1-or-later
"""From plain Python into FreeCAD: run one verb of the command line inside freecadcmd, with its true exit status.

freecadcmd given a script file ends with 0 whatever happened, refuses options, and opens files that it finds among the
arguments; given code with -c it does none of that.  So the arguments travel in the environment.  Needs no FreeCAD.
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

# What FreeCAD runs.  Loading our objects before a document is opened is what lets FreeCAD restore them, add-on or not.
# The verb's own output goes to the caller's streams; FreeCAD's banner and progress go nowhere.
CODE = """
import json, os, runpy, sys, traceback
status = 1
try:
    job = json.loads(os.environ.pop("SENS_HANDOFF"))
    sys.path.insert(0, job["root"])
    streams = [os.fdopen(fd, "w", encoding="utf-8", errors="replace") for fd in job["streams"]]
    sys.stdout, sys.stderr = streams or (sys.__stdout__, sys.__stderr__)
    sys.argv = ["sensworkbench"] + job["argv"]
    import sensworkbench.document.objects
    runpy.run_module("sensworkbench", run_name="__main__", alter_sys=True)
    status = 0
except SystemExit as end:
    status = end.code if isinstance(end.code, int) else 0 if end.code is None else 1
except BaseException:
    traceback.print_exc()
sys.stdout.flush(); sys.stderr.flush()
os._exit(status)
"""


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
    environment = dict(os.environ, SENS_HANDOFF=json.dumps(job))
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
            if status not in (0, 1, 2):
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
