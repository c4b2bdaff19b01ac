# SPDX-License-Identifier: LGPL-2.1-or-later
"""An installation as a user has it: a clone in the Mod folder, FreeCAD started, the workbench there, a machine."""

from __future__ import annotations

import ast
import builtins
import os
import subprocess
import sys

import pytest
import startup

from .conftest import ROOT

QUIET = ("Traceback", "Error", "error:", "exception", "blocked import")


def complaints(log: str) -> list[str]:
    return [line for line in log.splitlines() if any(word in line for word in QUIET)]


COMPUTE = """
from sensworkbench.document import examples, factory, results
doc = App.newDocument("Demo")
machine = examples.make_example(doc, "XYFZ")
found = results.compute(machine)
said["problem"] = machine.Problem
said["total"] = list(found.Total)
said["stale"] = bool(found.Stale)
import sensworkbench
said["where"] = sensworkbench.__file__
path = os.path.join(App.ConfigGet("UserAppData") or ".", "demo.FCStd")
doc.saveAs(path)
said["path"] = path
"""


def test_headless_the_add_on_is_found_and_a_machine_is_computed(home):
    ended = home.run(COMPUTE + 'said["tests"] = list(App.__unit_test__)')
    said = ended.said
    assert said["where"].startswith(str(home.folder / "Mod" / "SensWorkbench"))
    assert "sensworkbench.document.selftest" in said["tests"]
    assert said["problem"] == "" and said["stale"] is False
    assert len(said["total"]) > 20 and max(said["total"]) > 0.05
    assert complaints(ended.log) == []


def test_in_a_window_the_workbench_is_registered_and_a_machine_is_computed(home):
    body = """
import FreeCADGui as Gui
said["workbenches"] = sorted(Gui.listWorkbenches())
Gui.activateWorkbench("SensWorkbench")
said["active"] = Gui.activeWorkbench().name()
said["commands"] = [c for c in Gui.listCommands() if c.startswith("Sens_")]
said["menus"] = Gui.activeWorkbench().listMenus()
said["toolbars"] = Gui.activeWorkbench().listToolbars()
"""
    ended = home.run(body + COMPUTE, gui=True)
    said = ended.said
    assert "SensWorkbench" in said["workbenches"] and said["active"] == "SensWorkbench"
    assert len(said["commands"]) > 5 and said["toolbars"]
    assert any("Sens" in menu for menu in said["menus"])
    assert said["problem"] == "" and said["stale"] is False and max(said["total"]) > 0.05
    assert said["where"].startswith(str(home.folder))
    assert [c for c in complaints(ended.log) if "libGL" not in c] == []


def test_the_manifest_reads_in_freecad(home):
    body = """
m = App.Metadata(os.path.join(App.ConfigGet("UserAppData"), "Mod", "SensWorkbench", "package.xml"))
said.update(name=m.Name, version=str(m.Version), classes=[w.Classname for w in m.Content["workbench"]],
            urls=sorted(u["type"] for u in m.Urls), licence=[l["name"] for l in m.License], icon=m.Icon)
"""
    said = home.run(body).said
    assert said["name"] == "Sens Workbench" and said["version"].startswith("0.1")
    assert said["classes"] == ["SensWorkbench"]
    # "discussion" is younger than 0.20, which reads it as a website
    assert {"bugtracker", "documentation", "readme", "repository", "website"} <= set(said["urls"])
    assert len(said["urls"]) == 6
    assert said["licence"] == ["LGPL-2.1-or-later"]
    assert (home.folder / "Mod" / "SensWorkbench" / said["icon"]).is_file()


def test_init_runs_where_its_file_is_not_known(home):
    """FreeCAD executes the text of Init.py: `__file__` is not defined there."""
    body = """
before = list(App.__unit_test__)
with open(os.path.join(App.ConfigGet("UserAppData"), "Mod", "SensWorkbench", "Init.py")) as stream:
    text = stream.read()
exec(compile(text, "Init.py", "exec"), {})
said["added"] = list(App.__unit_test__)[len(before):]
"""
    assert home.run(body).said["added"] == ["sensworkbench.document.selftest"]


def test_initgui_runs_where_its_file_is_not_known(home):
    body = """
import FreeCADGui as Gui
Gui.removeWorkbench("SensWorkbench")
said["between"] = "SensWorkbench" in Gui.listWorkbenches()
with open(os.path.join(App.ConfigGet("UserAppData"), "Mod", "SensWorkbench", "InitGui.py")) as stream:
    text = stream.read()
exec(compile(text, "InitGui.py", "exec"), {})
said["after"] = "SensWorkbench" in Gui.listWorkbenches()
Gui.activateWorkbench("SensWorkbench")
said["active"] = Gui.activeWorkbench().name()
"""
    said = home.run(body, gui=True).said
    assert (said["between"], said["after"], said["active"]) == (False, True, "SensWorkbench")


def free_names(function: ast.AST) -> set[str]:
    """Names that a method reads and does not bind itself."""
    read = {n.id for n in ast.walk(function) if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Load)}
    bound = {n.id for n in ast.walk(function) if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store)}
    bound |= {a.arg for n in ast.walk(function) if isinstance(n, ast.arguments) for a in n.args}
    bound |= {
        (a.asname or a.name).split(".")[0]
        for n in ast.walk(function) if isinstance(n, (ast.Import, ast.ImportFrom)) for a in n.names
    }  # fmt: skip
    return read - bound - set(dir(builtins))


@pytest.mark.parametrize("name", ["Init.py", "InitGui.py"])
def test_nothing_relies_on_names_that_freecad_hides(name):
    """Names of InitGui.py are not visible in its methods, and neither file knows where it is."""
    tree = ast.parse((ROOT / name).read_text(encoding="utf-8"))
    assert "__file__" not in {n.id for n in ast.walk(tree) if isinstance(n, ast.Name)}
    methods = [m for c in ast.walk(tree) if isinstance(c, ast.ClassDef) for m in c.body
               if isinstance(m, ast.FunctionDef)]  # fmt: skip
    assert methods or name == "Init.py"
    assert {m.name: free_names(m) for m in methods if free_names(m)} == {}


@pytest.mark.parametrize("gui", [False, True], ids=["headless", "window"])
def test_start_up_loads_nothing_heavy(home, bare_home, gui):
    with startup.screen(gui) as environment:
        without, with_ = (startup.start(h.folder, gui, environment)[2] for h in (bare_home, home))
    added = with_ - without
    assert not {m for m in added if m.split(".")[0] in ("numpy", "matplotlib", "scipy", "pivy", "Part")}
    ours = {m for m in added if m.startswith("sensworkbench")}
    assert not {m for m in ours if m.split(".")[1:2] in (["core"], ["closedloop"], ["formats"])}
    assert bool(ours) is gui


def bare(tmp_path, *words, **environment):
    """The command line run by a Python that has none of its packages, numpy included; returns the ended process."""
    machine = ROOT / "resources" / "examples" / "gantry.json"
    command = [sys.executable, "-S", "-m", "sensworkbench", *words[:1], str(machine), *words[1:]]
    environment = {**os.environ, "PYTHONPATH": str(ROOT), **environment}
    return subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, timeout=300)


def test_where_a_python_has_no_numpy_the_command_runs_on_freecads(tmp_path):
    ended = bare(tmp_path, "sensitivity", "--out", "review")
    assert ended.returncode == 0 and ended.stderr == ""
    assert sorted(p.name for p in (tmp_path / "review").iterdir()) == [
        "manifest.json",
        "report.html",
        "sensitivity.csv",
        "sensitivity.json",
    ]
    assert bare(tmp_path, "sensitivity", "--weights", "0,0,0", "--out", "none").returncode == 2
    assert not (tmp_path / "none").exists()


def test_without_numpy_and_without_freecad_it_says_what_is_missing(tmp_path):
    ended = bare(tmp_path, "sensitivity", "--out", "review", PATH=str(tmp_path), SENS_FREECADCMD="")
    assert ended.returncode == 2 and "numpy is missing" in ended.stderr and len(ended.stderr.splitlines()) == 1
    assert "Traceback" not in ended.stderr and not (tmp_path / "review").exists()
