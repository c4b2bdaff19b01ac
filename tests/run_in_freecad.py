# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run pytest inside FreeCAD, headless or in a window, with the true exit status on every version.

    python3 tests/run_in_freecad.py [--gui] PYTEST-ARGS...

The add-on is linked into the Mod folder of a throw-away user home (FreeCAD restores Python objects only from there).  A
window opens on a private X server without start page, splash or animation.  SENS_FREECADCMD and SENS_FREECAD name
the programs where they are not on the path; SENS_TEST_TIMEOUT limits a run (seconds, default 1800).
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import sysconfig
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

USER_CFG = """<?xml version="1.0" encoding="UTF-8" standalone="no" ?>
<FCParameters><FCParamGroup Name="Root"><FCParamGroup Name="BaseApp"><FCParamGroup Name="Preferences">
<FCParamGroup Name="General"><FCText Name="AutoloadModule">PartWorkbench</FCText><FCBool Name="ShowSplasher" Value="0"/>
</FCParamGroup><FCParamGroup Name="View"><FCBool Name="UseNavigationAnimations" Value="0"/>
</FCParamGroup></FCParamGroup></FCParamGroup></FCParamGroup></FCParameters>
"""

# run by FreeCAD itself; ends the process with pytest's status, which no other way out does on all versions
RUNNER = """
import json, os, sys, traceback
sys.stdout, sys.stderr = sys.__stdout__, sys.__stderr__
def run():
    status = 3
    try:
        try:
            import pytest
        except ImportError:
            sys.path.append(os.environ["SENS_TEST_PACKAGES"])
            import pytest
        # FreeCAD 1.0 leaves an import finder of the old kind behind, which pytest's importlib mode stumbles over
        sys.meta_path[:] = [finder for finder in sys.meta_path if hasattr(finder, "find_spec")]
        root = os.environ["SENS_TEST_ROOT"]
        os.chdir(root)
        if root not in sys.path:
            sys.path.insert(0, root)
        status = int(pytest.main(json.loads(os.environ["SENS_TEST_ARGS"])))
    except BaseException:
        traceback.print_exc()
    sys.stdout.flush(); sys.stderr.flush()
    os._exit(status)
if os.environ["SENS_TEST_GUI"] == "1":
    from PySide import QtCore
    QtCore.QTimer.singleShot(0, run)
else:
    run()
"""


def program(gui: bool) -> str:
    """FreeCAD's executable, from the environment or the path."""
    names = ("freecad", "FreeCAD") if gui else ("freecadcmd", "FreeCADCmd", "freecad.cmd")
    for name in (os.environ.get("SENS_FREECAD" if gui else "SENS_FREECADCMD"), *names):
        found = name and shutil.which(name)
        if found:
            return found
    sys.exit(f"{names[0]} is not on the path; set {'SENS_FREECAD' if gui else 'SENS_FREECADCMD'}")


def make_home(folder: Path) -> None:
    (folder / "Mod").mkdir()
    (folder / "Mod" / "SensWorkbench").symlink_to(ROOT)
    (folder / "user.cfg").write_text(USER_CFG, encoding="utf-8")
    (folder / "run.py").write_text(RUNNER, encoding="utf-8")


def main(argv: list[str]) -> int:
    gui = "--gui" in argv
    arguments = [a for a in argv if a != "--gui"] or ["-q", "tests/document"]
    command = program(gui)
    with tempfile.TemporaryDirectory(prefix="sens-home-") as name:
        home = Path(name)
        make_home(home)
        environment = dict(
            os.environ,
            FREECAD_USER_HOME=str(home),
            SENS_TEST_GUI="1" if gui else "0",
            SENS_TEST_ROOT=str(ROOT),
            SENS_TEST_ARGS=json.dumps(arguments),
            SENS_TEST_PACKAGES=sysconfig.get_paths()["purelib"],
        )
        line = [command, str(home / "run.py")]
        if gui:
            line = ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24", *line]
        timeout = float(os.environ.get("SENS_TEST_TIMEOUT", "1800"))
        try:
            return subprocess.run(line, env=environment, cwd=ROOT, timeout=timeout).returncode
        except subprocess.TimeoutExpired:
            print(f"no end after {timeout:g} s: {' '.join(line)}", file=sys.stderr)
            return 124


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
