# SPDX-License-Identifier: LGPL-2.1-or-later
"""What freecadcmd runs for `handoff.run`: one verb of the command line, ending the process with its exit status.

Loading our objects before a document is opened is what lets FreeCAD restore them, installed as an add-on or not.  The
verb's own output goes to the caller's streams; FreeCAD's banner and progress stay out of it.
"""

from __future__ import annotations

import json
import os
import runpy
import sys
import traceback


def run() -> int:
    """Run the job that the environment holds; returns the exit status."""
    job = json.loads(os.environ.pop("SENS_HANDOFF"))
    sys.path.insert(0, job["root"])
    streams = [os.fdopen(fd, "w", encoding="utf-8", errors="replace") for fd in job["streams"]]
    sys.stdout, sys.stderr = streams or (sys.__stdout__, sys.__stderr__)
    sys.argv = ["sensworkbench", *job["argv"]]
    try:
        import sensworkbench.document.closed_loop
        import sensworkbench.document.objects  # noqa: F401

        runpy.run_module("sensworkbench", run_name="__main__", alter_sys=True)
    except SystemExit as end:
        return end.code if isinstance(end.code, int) else int(end.code is not None)
    except KeyboardInterrupt:
        return 130
    except BaseException:  # noqa: BLE001 - whatever it is, the caller must see it and get a true status
        traceback.print_exc()
        return 1
    return 0


if "SENS_HANDOFF" in os.environ:
    answer = json.loads(os.environ["SENS_HANDOFF"])["answer"]
    status = run()
    for stream in (sys.stdout, sys.stderr):
        try:
            stream.flush()
        except (OSError, ValueError):  # nobody reads it any more
            pass
    if answer >= 0:
        os.write(answer, b"+")
    os._exit(status)
