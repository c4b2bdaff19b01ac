# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run pytest inside FreeCAD, headless or in a window, with the true exit status on every version.

    python3 tests/run_in_freecad.py [--gui] PYTEST-ARGS...

The add-on is linked into the Mod folder of a throw-away user home (FreeCAD restores Python objects only from there).  A
window opens on a private X server without start page, splash or animation.  SENS_FREECADCMD and SENS_FREECAD name
the programs where they are not on the path.

SENS_SCREEN is the size of that server's screen (default 1280x1024).  SENS_THEME, light or dark, gives the window the
theme that FreeCAD 1.0 and later have on a first start (default: none, as FreeCAD 0.20); QT_SCALE_FACTOR is Qt's own.

A run that hangs ends as a failure with the stacks of all threads: when no test has begun or ended for SENS_TEST_QUIET
seconds (default 300), or after SENS_TEST_TIMEOUT seconds (default 1500).
"""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import sysconfig
import tempfile
import xml.etree.ElementTree as ET
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
import faulthandler, json, os, sys, time, traceback
sys.stdout, sys.stderr = sys.__stdout__, sys.__stderr__
class Watch:
    # a thread of faulthandler's own, which needs neither Python nor the event loop, writes the stacks and ends FreeCAD
    def __init__(self):
        self.log = os.dup(2)  # pytest redirects file descriptor 2 while a test runs
        self.quiet, limit = float(os.environ["SENS_TEST_QUIET"]), float(os.environ["SENS_TEST_LIMIT"])
        self.end = time.monotonic() + limit
        self.again()
    def again(self):
        seconds = max(1.0, min(self.quiet, self.end - time.monotonic()))
        faulthandler.dump_traceback_later(seconds, exit=True, file=self.log)
    def pytest_runtest_logstart(self, nodeid, location):
        self.again()
    def pytest_runtest_logreport(self, report):
        self.again()
    def pytest_unconfigure(self, config):
        self.again()
watch = Watch()
open(os.environ["SENS_TEST_BEGAN"], "w").close()
def run():
    status = 3
    try:
        try:
            import hypothesis, pytest
        except ImportError:
            sys.path.append(os.environ["SENS_TEST_PACKAGES"])
            import pytest
        # FreeCAD 1.0 leaves an import finder of the old kind behind, which pytest's importlib mode stumbles over
        sys.meta_path[:] = [finder for finder in sys.meta_path if hasattr(finder, "find_spec")]
        root = os.environ["SENS_TEST_ROOT"]
        os.chdir(root)
        if root not in sys.path:
            sys.path.insert(0, root)
        status = int(pytest.main(json.loads(os.environ["SENS_TEST_ARGS"]), plugins=[watch]))
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


def themed(theme: str) -> str:
    """The settings of a first start with FreeCAD's own light or dark theme; the plain ones where it has none."""
    root = ET.fromstring(USER_CFG)
    name = f"FreeCAD {theme.capitalize()}"
    for share in ("/usr/share/freecad", "/usr/lib/freecad/share"):
        pack = Path(share) / "Gui" / "PreferencePacks" / name / f"{name}.cfg"
        if theme and pack.is_file():
            merge(root, ET.parse(pack).getroot())
    return ET.tostring(root, encoding="unicode", xml_declaration=True)


def merge(into: ET.Element, other: ET.Element) -> None:
    """Put the groups and values of one tree of settings into another; what is there stays."""
    known = {(child.tag, child.get("Name")): child for child in into}
    for child in other:
        mine = known.get((child.tag, child.get("Name")))
        if mine is None:
            into.append(child)
        elif child.tag == "FCParamGroup":
            merge(mine, child)


def make_home(folder: Path) -> None:
    (folder / "Mod").mkdir()
    (folder / "Mod" / "SensWorkbench").symlink_to(ROOT)
    (folder / "user.cfg").write_text(themed(os.environ.get("SENS_THEME", "")), encoding="utf-8")
    (folder / "run.py").write_text(RUNNER, encoding="utf-8")


def finish(process: subprocess.Popen, began: Path, quiet: float, limit: float) -> int:
    """The exit status of a run; one that neither began within `quiet` s nor ended itself after `limit` s is killed."""
    try:
        try:
            return process.wait(min(quiet, limit))
        except subprocess.TimeoutExpired:
            if not began.exists():
                print(f"FreeCAD has not begun a test after {min(quiet, limit):g} s", file=sys.stderr)
                return 124
        try:
            return process.wait(max(0.0, limit - quiet) + 30)  # FreeCAD ends itself at the limit, and says where it was
        except subprocess.TimeoutExpired:
            print(f"no end after {limit:g} s", file=sys.stderr)
            return 124
    finally:
        if process.poll() is None:
            kill_all(process)


def kill_all(process: subprocess.Popen) -> None:
    """End a run with everything it has started, FreeCAD and X server too."""
    if hasattr(os, "killpg"):
        os.killpg(process.pid, signal.SIGTERM)
        try:
            process.wait(5)
        except subprocess.TimeoutExpired:
            pass
        try:
            os.killpg(process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
    else:
        process.kill()
    process.wait()


def main(argv: list[str]) -> int:
    gui = "--gui" in argv
    arguments = [a for a in argv if a != "--gui"] or ["-q", "tests/document"]
    command = program(gui)
    quiet = float(os.environ.get("SENS_TEST_QUIET", "300"))
    limit = float(os.environ.get("SENS_TEST_TIMEOUT", "1500"))
    with tempfile.TemporaryDirectory(prefix="sens-home-", ignore_cleanup_errors=True) as name:
        home = Path(name)
        make_home(home)
        environment = dict(
            os.environ,
            FREECAD_USER_HOME=str(home),
            SENS_TEST_GUI="1" if gui else "0",
            SENS_TEST_ROOT=str(ROOT),
            SENS_TEST_ARGS=json.dumps(arguments),
            SENS_TEST_PACKAGES=sysconfig.get_paths()["purelib"],
            SENS_TEST_BEGAN=str(home / "began"),
            SENS_TEST_QUIET=str(quiet),
            SENS_TEST_LIMIT=str(limit),
        )
        line = [command, str(home / "run.py")]
        if gui:
            line = ["xvfb-run", "-a", "-s", f"-screen 0 {os.environ.get('SENS_SCREEN', '1280x1024')}x24", *line]
        signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))  # by way of `finish`, which ends FreeCAD too
        process = subprocess.Popen(line, env=environment, cwd=ROOT, start_new_session=True)
        return finish(process, home / "began", quiet, limit)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
