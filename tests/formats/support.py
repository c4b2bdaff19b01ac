# SPDX-License-Identifier: LGPL-2.1-or-later
"""A machine file to spoil, and the command line as a user meets it: a process of its own, FreeCAD out of reach."""

from __future__ import annotations

import copy
import json
import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

GOLDEN = {
    "format": "sens-machine",
    "version": 1,
    "name": "golden",
    "workpiece_chain": [],
    "tool_chain": ["X", "Y", "Z"],
    "axes": {
        "X": {"direction": [1, 0, 0], "reference": [0, 0, 0], "travel": [-300, 300]},
        "Y": {"direction": [0, 1, 0], "reference": [0, 0, 0], "travel": [-200, 200]},
        "Z": {"direction": [0, 0, 1], "reference": [0, 0, 0], "travel": [-250, 50]},
    },
    "tool_point": [0, 0, -150],
}

# sitecustomize of the processes under test: whatever asks for FreeCAD fails as where it is not installed
_BLOCK = """
import sys
class Block:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in ("FreeCAD", "FreeCADGui", "Part", "PySide", "pivy"):
            raise ModuleNotFoundError("blocked: " + name)
sys.meta_path.insert(0, Block())
"""


def golden(**changes) -> dict:
    """The machine of the specification's golden numbers as plain data; `axes__X__travel=[0, 1]` changes a member."""
    data = copy.deepcopy(GOLDEN)
    for path, value in changes.items():
        *steps, last = path.split("__")
        place = data
        for step in steps:
            place = place.setdefault(step, {})
        place[last] = value
    return data


def write(path: Path, data) -> Path:
    path.write_text(data if isinstance(data, str) else json.dumps(data, indent=1), encoding="utf-8")
    return path


def command(*words, cwd, block: Path | None = None, **environment) -> subprocess.CompletedProcess:
    """`python -m sensworkbench WORDS` in folder `cwd`.  block : a folder for the import block."""
    path = [str(ROOT)]
    if block is not None:
        (block / "sitecustomize.py").write_text(_BLOCK, encoding="utf-8")
        path.insert(0, str(block))
    variables = dict(os.environ, PYTHONPATH=os.pathsep.join(path), OMP_NUM_THREADS="1") | environment
    line = [sys.executable, "-m", "sensworkbench", *map(str, words)]
    return subprocess.run(line, cwd=cwd, env=variables, capture_output=True, text=True, timeout=120, encoding="utf-8")
