# SPDX-License-Identifier: LGPL-2.1-or-later
"""A fresh user home into which the add-on was cloned, and programs of FreeCAD that start in it."""

from __future__ import annotations

import dataclasses
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmarks"))

import startup  # noqa: E402

# what FreeCAD runs: `body` fills `said`, which becomes a file; any exception goes there too; the process ends
SCRIPT = """
import json, os, sys, traceback
said = {{}}
def run():
    try:
{body}
    except BaseException:
        said["exception"] = traceback.format_exc()
    with open({answer!r}, "w") as stream:
        json.dump(said, stream)
    os._exit(0)
import FreeCAD as App
if App.GuiUp:
    from PySide import QtCore
    QtCore.QTimer.singleShot(300, run)
else:
    run()
"""


@dataclasses.dataclass
class Ended:
    said: dict
    log: str


@dataclasses.dataclass
class Home:
    """A user home of FreeCAD."""

    folder: Path

    def run(self, body: str, gui: bool = False) -> Ended:
        """Start FreeCAD, run `body` in it; what it put into `said`, and all that was printed."""
        answer = self.folder / "answer.json"
        answer.unlink(missing_ok=True)
        script = self.folder / "job.py"
        indented = "\n".join(" " * 8 + line for line in body.strip("\n").splitlines())
        script.write_text(SCRIPT.format(body=indented, answer=str(answer)), encoding="utf-8")
        line = [startup.program(gui), str(script)]
        if gui:
            line = ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24", *line]
        environment = {k: v for k, v in os.environ.items() if k not in ("PYTHONPATH", "VIRTUAL_ENV")}
        environment["FREECAD_USER_HOME"] = str(self.folder)
        done = subprocess.run(
            line, env=environment, cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, text=True, errors="replace", timeout=300, check=False,
        )  # fmt: skip
        assert answer.exists(), done.stdout[-4000:]
        said = json.loads(answer.read_text(encoding="utf-8"))
        assert "exception" not in said, said["exception"] + done.stdout[-2000:]
        return Ended(said, done.stdout)


def make_home(folder: Path, addon: bool) -> Home:
    startup.make_home(folder, None)
    if addon:
        target = folder / "Mod" / "SensWorkbench"
        if (ROOT / ".git").is_dir():
            subprocess.run(["git", "clone", "-q", "--no-hardlinks", str(ROOT), str(target)], check=True, timeout=120)
        else:  # unpacked from an archive, or a work tree of a repository elsewhere
            shutil.copytree(ROOT, target, ignore=shutil.ignore_patterns(".venv", "build", "__pycache__"))
    return Home(folder)


@pytest.fixture(scope="session")
def home(tmp_path_factory):
    """With the add-on as a user gets it: cloned into a fresh Mod folder."""
    return make_home(tmp_path_factory.mktemp("home") / "user", addon=True)


@pytest.fixture(scope="session")
def bare_home(tmp_path_factory):
    """Without the add-on."""
    return make_home(tmp_path_factory.mktemp("bare") / "user", addon=False)
