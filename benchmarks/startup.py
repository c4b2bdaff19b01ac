# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the add-on adds to FreeCAD's own start: processor and wall time with and without it, and the modules it loads.

    python3 benchmarks/startup.py [--gui] [--runs 15]

Runs alternate and the medians are compared, so that a busy machine disturbs both alike.  Aim: at most 3 %, no numpy.
SENS_FREECADCMD and SENS_FREECAD name the programs where they are not on the path.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
AIM = 3.0  # percent

# what FreeCAD runs when it has started: the modules that are loaded; ends the process
SCRIPT = """
import json, os, sys
def end():
    with open(os.environ["SENS_STARTUP_MODULES"], "w") as stream:
        json.dump(sorted(sys.modules), stream)
    os._exit(0)
import FreeCAD
if FreeCAD.GuiUp:
    from PySide import QtCore
    QtCore.QTimer.singleShot(200, end)  # what the add-on has left for the first idle moment has run by then
else:
    end()
"""

USER_CFG = """<?xml version="1.0" encoding="UTF-8" standalone="no" ?>
<FCParameters><FCParamGroup Name="Root"><FCParamGroup Name="BaseApp"><FCParamGroup Name="Preferences">
<FCParamGroup Name="General"><FCText Name="AutoloadModule">PartWorkbench</FCText><FCBool Name="ShowSplasher" Value="0"/>
</FCParamGroup></FCParamGroup></FCParamGroup></FCParamGroup></FCParameters>
"""


def program(gui: bool) -> str:
    """FreeCAD's executable; ends the program where there is none."""
    variable, names = ("SENS_FREECAD", ("freecad", "FreeCAD")) if gui else (
        "SENS_FREECADCMD", ("freecadcmd", "FreeCADCmd"))  # fmt: skip
    for name in (os.environ.get(variable), *names):
        found = name and shutil.which(name)
        if found:
            return found
    sys.exit(f"{names[0]} is not on the path; set {variable}")


def make_home(folder: Path, addon: Path | None) -> Path:
    """A user home with the add-on, or without one."""
    (folder / "Mod").mkdir(parents=True)
    (folder / "user.cfg").write_text(USER_CFG, encoding="utf-8")
    (folder / "run.py").write_text(SCRIPT, encoding="utf-8")
    if addon is not None:
        (folder / "Mod" / "SensWorkbench").symlink_to(addon)
    return folder


@contextlib.contextmanager
def screen(gui: bool):
    """The environment with a private X server, where a window is wanted."""
    if not gui:
        yield dict(os.environ)
        return
    read, write = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(write), "-screen", "0", "1280x1024x24", "-nolisten", "tcp"],
        pass_fds=[write], stderr=subprocess.DEVNULL,
    )  # fmt: skip
    os.close(write)
    try:
        with os.fdopen(read) as stream:
            number = stream.readline().strip()
        yield dict(os.environ, DISPLAY=f":{number}")
    finally:
        server.terminate()
        server.wait()


def start(home: Path, gui: bool, environment: dict) -> tuple[float, float, set[str]]:
    """One start of FreeCAD: (wall seconds, processor seconds, loaded modules)."""
    modules = home / "modules.json"
    environment = dict(environment, FREECAD_USER_HOME=str(home), SENS_STARTUP_MODULES=str(modules))
    began = time.perf_counter()
    child = subprocess.Popen(
        [program(gui), str(home / "run.py")], env=environment, cwd=home, stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
    )  # fmt: skip
    _, status, usage = os.wait4(child.pid, 0)
    wall = time.perf_counter() - began
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode:
        sys.exit(f"FreeCAD ended with status {child.returncode}")
    return wall, usage.ru_utime + usage.ru_stime, set(json.loads(modules.read_text(encoding="utf-8")))


def measure(gui: bool, runs: int, addon: Path = ROOT) -> dict:
    """Medians of `runs` starts each: seconds without and with the add-on, percent added, modules that it loads."""
    with tempfile.TemporaryDirectory(prefix="sens-startup-") as folder, screen(gui) as environment:
        homes = [make_home(Path(folder) / name, addon if name == "with" else None) for name in ("without", "with")]
        loaded = [start(home, gui, environment)[2] for home in homes]  # also warms the caches
        taken: list[list] = [[], []]
        for i in range(runs):
            for which in (0, 1) if i % 2 else (1, 0):
                taken[which].append(start(homes[which], gui, environment)[:2])
    wall, cpu = ([statistics.median(t[k] for t in taken[w]) for w in (0, 1)] for k in (0, 1))
    return {
        "wall_s": wall, "cpu_s": cpu, "wall_percent": 100 * (wall[1] / wall[0] - 1),
        "cpu_percent": 100 * (cpu[1] / cpu[0] - 1), "modules": sorted(loaded[1] - loaded[0]),
    }  # fmt: skip


def main(argv: list[str]) -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--gui", action="store_true", help="with a window under Xvfb")
    parser.add_argument("--runs", type=int, default=15, help="starts with and without the add-on, each (default 15)")
    options = parser.parse_args(argv)
    found = measure(options.gui, options.runs)
    for name, label in (("wall", "wall time"), ("cpu", "processor time")):
        without, with_ = found[f"{name}_s"]
        print(f"{label}: {without:.3f} s without, {with_:.3f} s with the add-on: {found[f'{name}_percent']:+.1f} %")
    print("modules that the add-on loads:", ", ".join(found["modules"]) or "none")
    return 0 if found["cpu_percent"] <= AIM else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
