# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a change to the repainted window, beside setting the same colours with nothing computed.

    python3 benchmarks/recolour.py [--machine XYFZ] [--grid 11] [--runs 25] [--review]

Opens FreeCAD on a private X server with an example machine, coloured and with its legend, judged at grid³ positions.
A change is a jog (one axis), a moved part (its lever arms change, so all indices do) or another tolerance; it ends when
a frame with the new colours is in the window.  --review shows the review beside the model.  Aim: 50 ms.  Xvfb draws by
software (no graphics card), so drawing costs more than on a user's machine; the share that only draws is printed as its
own row.  SENS_FREECAD names the program.
"""

from __future__ import annotations

import argparse
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
AIM_MS = 50.0

USER_CFG = """<?xml version="1.0" encoding="UTF-8" standalone="no" ?>
<FCParameters><FCParamGroup Name="Root"><FCParamGroup Name="BaseApp"><FCParamGroup Name="Preferences">
<FCParamGroup Name="General"><FCText Name="AutoloadModule">PartWorkbench</FCText><FCBool Name="ShowSplasher" Value="0"/>
</FCParamGroup><FCParamGroup Name="View"><FCBool Name="UseNavigationAnimations" Value="0"/>
</FCParamGroup></FCParamGroup></FCParamGroup></FCParamGroup></FCParameters>
"""

# what FreeCAD runs when its window stands
SCRIPT = """
import os, sys, traceback
sys.stdout, sys.stderr = sys.__stdout__, sys.__stderr__
def run():
    try:
        sys.path.insert(0, os.environ["SENS_RECOLOUR_ROOT"])
        from benchmarks import recolour
        recolour.measure()
        status = 0
    except BaseException:
        traceback.print_exc()
        status = 1
    sys.stdout.flush(); sys.stderr.flush()
    os._exit(status)
from PySide import QtCore
QtCore.QTimer.singleShot(300, run)
"""


# -- inside FreeCAD --------------------------------------------------------------------------------------------------
class Window:
    """The machine in a window, and a count of the frames that were drawn."""

    def __init__(self, code: str, grid: int, beside: bool = False):
        import FreeCAD as App
        import FreeCADGui as Gui
        from pivy import coin

        from sensworkbench.document.examples import make_example
        from sensworkbench.gui import colours, display, messages, qt, review

        self.pump = qt.pump
        Gui.activateWorkbench("SensWorkbench")
        self.doc = App.newDocument("Recolour")
        self.doc.UndoMode = 1
        self.machine = make_example(self.doc, code)
        self.machine.Aggregate, self.machine.Grid = "grid", grid
        view = Gui.getDocument(self.doc.Name).activeView()
        view.viewIsometric()
        view.fitAll()
        messages.change(self.doc, "Sensitivity", lambda: display.compute_and_colour(self.machine))
        if beside:
            review.show(self.machine)
        self._parts = [t.obj for group in colours.targets(self.machine).values() for t in group]
        self.frames = 0
        watch = coin.SoCallback()
        watch.setCallback(self._drawn, None)
        view.getSceneGraph().addChild(watch)
        self.swaps = 0
        drawn_by = _drawing_widget()
        drawn_by.frameSwapped.connect(self._swapped)
        self._keep = (view, watch, drawn_by)
        self.pump(600)

    def _drawn(self, _data, action):
        from pivy import coin

        if action.isOfType(coin.SoGLRenderAction.getClassTypeId()):
            self.frames += 1

    def _swapped(self):
        self.swaps += 1

    @property
    def result(self):
        from sensworkbench.document import tree

        return tree.sensitivity_of(self.machine)

    def look(self):
        """The colours of all parts."""
        from sensworkbench.gui import colours

        return [colours.shown_colour(obj) for obj in self._parts]

    def timed(self, change, limit: float = 5.0) -> float:
        """Milliseconds from `change` until a frame with the new colours is in the window, the result not stale."""
        from PySide import QtGui

        before, coloured = self.look(), False
        start = time.perf_counter()
        change()
        while time.perf_counter() < start + limit:
            frames, swaps = self.frames, self.swaps
            QtGui.QApplication.processEvents()
            if not coloured:
                coloured = self.frames > frames and not self.result.Stale and self.look() != before
            if coloured and self.swaps > swaps:
                taken = 1e3 * (time.perf_counter() - start)
                self.pump(400)  # what is still waiting belongs to this change, not to the next
                return taken
        raise RuntimeError("no frame with new colours")


def _drawing_widget():
    """The OpenGL widget that shows the document's view: it tells when its picture is in the window."""
    import FreeCADGui as Gui
    from PySide import QtGui

    found = [w for w in Gui.getMainWindow().findChildren(QtGui.QOpenGLWidget) if w.isVisible()]
    if len(found) != 1:
        raise RuntimeError(f"{len(found)} drawing widgets in the window instead of one")
    return found[0]


def measure() -> None:
    """Time each kind of change and write the milliseconds as JSON."""
    import FreeCADGui as Gui

    from sensworkbench.document import factory, tables, tree
    from sensworkbench.gui import colours
    from sensworkbench.gui.task_jog import TaskJog

    settings = json.loads(os.environ["SENS_RECOLOUR"])
    runs = settings["runs"]
    window = Window(settings["machine"], settings["grid"], settings["review"])
    doc, machine = window.doc, window.machine
    targets = [t.obj for body, group in colours.targets(machine).items() if body != "F" for t in group]
    shades = ((0.2, 0.4, 0.6), (0.6, 0.5, 0.2))

    def only_colours(i):
        for obj in targets:
            colours.paint(obj, shades[i % 2])

    only = [window.timed(lambda i=i: only_colours(i)) for i in range(runs)]

    part = tree.parts_of(machine, "Z")[0].object

    def move(i):
        place = part.Placement.copy()
        place.Base.x += 40 if i % 2 else -40
        doc.openTransaction("Move")
        part.Placement = place
        doc.recompute()
        doc.commitTransaction()

    moved = [window.timed(lambda i=i: move(i)) for i in range(runs)]

    table = tables.read_tolerances(machine)

    def tolerance(i):
        doc.openTransaction("Tolerance")
        factory.set_tolerances(machine, table | {"EAY": table["EAY"].scaled(0.5 if i % 2 == 0 else 1.0)})
        machine.touch()
        doc.recompute()
        doc.commitTransaction()

    edited = [window.timed(lambda i=i: tolerance(i)) for i in range(runs)]

    panel = TaskJog(machine)
    Gui.Control.showDialog(panel)
    window.pump(300)

    def jog(i):
        name = "XYZ"[i % 3]
        low, high = panel.numbers[name].minimum(), panel.numbers[name].maximum()
        panel.numbers[name].setValue(low + (high - low) * (0.25 + 0.5 * ((i * 7) % 11) / 11))

    jogged = [window.timed(lambda i=i: jog(i)) for i in range(1, runs + 1)]
    panel.reject()
    found = {"colours only": only, "jog": jogged, "moved part": moved, "tolerance": edited}
    Path(os.environ["SENS_RECOLOUR_OUT"]).write_text(json.dumps({"parts": len(targets), "ms": found}))


# -- outside -----------------------------------------------------------------------------------------------------------
def program() -> str:
    """FreeCAD's executable; ends the program where there is none."""
    for name in (os.environ.get("SENS_FREECAD"), "freecad", "FreeCAD"):
        found = name and shutil.which(name)
        if found:
            return found
    sys.exit("freecad is not on the path; set SENS_FREECAD")


def run(machine: str, grid: int, runs: int, review: bool = False) -> dict:
    """Measure in a window of its own; refuses by RuntimeError where FreeCAD failed."""
    with tempfile.TemporaryDirectory(prefix="sens-recolour-") as name:
        home = Path(name)
        (home / "Mod").mkdir()
        (home / "Mod" / "SensWorkbench").symlink_to(ROOT)
        (home / "user.cfg").write_text(USER_CFG, encoding="utf-8")
        (home / "run.py").write_text(SCRIPT, encoding="utf-8")
        out = home / "times.json"
        environment = dict(
            os.environ,
            FREECAD_USER_HOME=str(home),
            LIBGL_ALWAYS_SOFTWARE="1",
            SENS_RECOLOUR_ROOT=str(ROOT),
            SENS_RECOLOUR_OUT=str(out),
            SENS_RECOLOUR=json.dumps({"machine": machine, "grid": grid, "runs": runs, "review": review}),
        )
        line = ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24", program(), str(home / "run.py")]
        subprocess.run(line, env=environment, cwd=ROOT, timeout=600, check=False)
        if not out.exists():
            raise RuntimeError("FreeCAD ended without a result")
        return json.loads(out.read_text(encoding="utf-8"))


def main(argv: list[str]) -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--machine", default="XYFZ", choices=("XYFZ", "FXYZ", "YFXZ"))
    parser.add_argument("--grid", type=int, default=11, help="positions per axis")
    parser.add_argument("--runs", type=int, default=25)
    parser.add_argument("--review", action="store_true", help="with the review beside the model")
    options = parser.parse_args(argv)
    found = run(options.machine, options.grid, options.runs, options.review)
    base = statistics.median(found["ms"]["colours only"])
    print(f"{options.machine}, {found['parts']} coloured parts, {options.grid}³ positions, {options.runs} runs each; "
          f"software GL, load {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores")  # fmt: skip
    print(f"{'from change to repaint':<24}{'median ms':>11}{'fastest':>9}{'slowest':>9}{'ratio':>8}")
    for name, times in found["ms"].items():
        middle = statistics.median(times)
        print(f"{name:<24}{middle:>11.1f}{min(times):>9.1f}{max(times):>9.1f}{middle / base:>8.2f}")
    worst = max(statistics.median(t) for t in found["ms"].values())
    print(f"aim {AIM_MS:g} ms: {'reached' if worst <= AIM_MS else 'missed'} (largest median {worst:.1f} ms)")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
