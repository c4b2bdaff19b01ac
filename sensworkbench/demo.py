# SPDX-License-Identifier: LGPL-2.1-or-later
"""The demonstration: an example machine as FreeCAD parts, coloured by its indices, then measured, traced and predicted.

FreeCAD builds and colours the document (in a window on a virtual display where there is one); everything else runs in
plain Python on what it left.  The readings are simulated with the exact matrix product and an effect that the machine
file does not declare.
"""

from __future__ import annotations

import contextlib
import csv
import importlib
import json
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from sensworkbench import demo_part
from sensworkbench.core.errors import AXES, FUNCTION_SYMBOLS, component
from sensworkbench.core.machine import Machine
from sensworkbench.core.refusal import Refused
from sensworkbench.core.synthesis import exact_error
from sensworkbench.core.units import um
from sensworkbench.formats import machine_json, readings_csv, study_files
from sensworkbench.formats.file_sets import staged
from sensworkbench.studies.predict import predict_study
from sensworkbench.studies.sensitivity import sensitivity_study
from sensworkbench.studies.trace import trace_study

ROOT = Path(__file__).resolve().parents[1]
DOCUMENT, PICTURES, LOOP = "machine.FCStd", ("view.png", "view_front.png"), "closed_loop"
BEND_URAD_PER_K = 6.0  # what the simulated machine does and its file does not say: the column bends with temperature
NOISE_UM = 0.4
TIMEOUT = 600  # seconds for FreeCAD

USER_CFG = """<?xml version="1.0" encoding="UTF-8" standalone="no" ?>
<FCParameters><FCParamGroup Name="Root"><FCParamGroup Name="BaseApp"><FCParamGroup Name="Preferences">
<FCParamGroup Name="General"><FCText Name="AutoloadModule">PartWorkbench</FCText><FCBool Name="ShowSplasher" Value="0"/>
</FCParamGroup><FCParamGroup Name="View"><FCBool Name="UseNavigationAnimations" Value="0"/>
</FCParamGroup></FCParamGroup></FCParamGroup></FCParamGroup></FCParameters>
"""

# run by FreeCAD; leaves the reason in a file, because a window has no stderr on every version
CODE = """
import json, os, sys, traceback
job = json.loads(os.environ["SENS_DEMO"])
def run():
    status = 1
    try:
        if job["root"] not in sys.path:
            sys.path.insert(0, job["root"])
        from sensworkbench import demo
        demo.build(job["folder"], job["structure"])
        status = 0
    except BaseException:
        with open(job["log"], "w", encoding="utf-8") as stream:
            traceback.print_exc(file=stream)
    sys.stdout.flush(); sys.stderr.flush()
    os._exit(status)
if job["window"]:
    from PySide import QtCore
    QtCore.QTimer.singleShot(500, run)
else:
    run()
"""


def run(folder, structure: str = "XYFZ", tell=None) -> list[Path]:
    """Make everything in `folder` and return the paths; `tell` is told what is going on, in words."""
    tell = tell or (lambda words: None)
    with staged(folder, "demo") as work:
        tell("building the machine in FreeCAD")
        if "FreeCAD" in sys.modules:
            build(work, structure)
        else:
            _build_in_freecad(work, structure)
        machine = machine_json.load(work / "machine.json")
        tell("computing the sensitivity indices")
        picture = work / PICTURES[0]
        study = sensitivity_study(machine)
        study_files.write_sensitivity(work, study, picture=picture.read_bytes() if picture.exists() else None)
        tell("measuring the simulated machine, tracing, predicting")
        for words in close_the_loop(machine, work / LOOP):
            tell(words)
        made = sorted(p.relative_to(work) for p in work.rglob("*") if p.is_file())
    return [Path(folder) / p for p in made]


# -- inside FreeCAD ----------------------------------------------------------------------------------------------------
def build(folder, structure: str) -> None:
    """Inside FreeCAD: the example as parts with its indices, coloured and pictured where there is a window."""
    import FreeCAD as App

    examples = importlib.import_module("sensworkbench.document.examples")
    extract = importlib.import_module("sensworkbench.document.extract")
    folder = Path(folder)
    doc = App.newDocument("Machine")
    machine = examples.make_example(doc, structure)
    doc.recompute()
    if App.GuiUp:
        display = importlib.import_module("sensworkbench.gui.display")
        display.compute_and_colour(machine)
        _take_pictures(doc, folder)
    else:
        found = importlib.import_module("sensworkbench.document.results").compute(machine)
        found.Coloured = True
    machine_json.save(extract.core_machine(machine), folder / "machine.json")
    doc.saveAs(str(folder / DOCUMENT))
    App.closeDocument(doc.Name)


def _take_pictures(doc, folder: Path) -> None:
    export = importlib.import_module("sensworkbench.gui.export")
    view = export.view_of(doc)
    for name, look in zip(PICTURES, ("viewIsometric", "viewFront")):
        getattr(view, look)()
        view.fitAll()
        (folder / name).write_bytes(export.picture(doc))
    view.viewIsometric()
    view.fitAll()


# -- FreeCAD from outside ----------------------------------------------------------------------------------------------
def _window_command() -> list[str] | None:
    """How to start FreeCAD with a window here, or None: a virtual display first, else the user's own."""
    program = next((p for p in (os.environ.get("SENS_FREECAD"), "freecad", "FreeCAD") if p and shutil.which(p)), None)
    if program is None or not (ROOT / "InitGui.py").exists():
        return None
    if shutil.which("xvfb-run") and shutil.which("xauth"):
        return ["xvfb-run", "-a", "-s", "-screen 0 1600x1200x24", program]
    return [program] if os.environ.get("DISPLAY") else None


@contextlib.contextmanager
def _home(work: Path) -> Iterator[Path]:
    """A home for FreeCAD with this workbench, in the hidden folder of the run: after a kill, it goes with that."""
    with contextlib.ExitStack() as stack:
        for place in (work.parent, None):  # where a disk knows no links, the folder for temporary files
            home = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="sens-demo-", dir=place)))
            (home / "Mod").mkdir()
            try:
                (home / "Mod" / "SensWorkbench").symlink_to(ROOT)
                break
            except OSError:
                if place is None:
                    raise
        yield home


def _build_in_freecad(work: Path, structure: str) -> None:
    window = _window_command()
    command = window or [importlib.import_module("sensworkbench.document.handoff").freecadcmd()]
    with _home(work) as home:
        (home / "user.cfg").write_text(USER_CFG, encoding="utf-8")
        script, log = home / "demo.py", home / "demo.log"
        script.write_text(CODE, encoding="utf-8")
        job = {"folder": str(work), "structure": structure, "root": str(ROOT), "log": str(log), "window": bool(window)}
        environment = dict(os.environ, FREECAD_USER_HOME=str(home), SENS_DEMO=json.dumps(job))
        try:
            status = subprocess.run(
                [*command, str(script)],
                env=environment,
                timeout=TIMEOUT,
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
            ).returncode
        except subprocess.TimeoutExpired:
            raise Refused("demo-timeout", "demo", seconds=TIMEOUT) from None
        if status != 0:
            reason = log.read_text(encoding="utf-8") if log.exists() else ""
            raise RuntimeError(f"FreeCAD ended with status {status} while building the example\n{reason}")


# -- the closed loop ---------------------------------------------------------------------------------------------------
def simulated_errors(machine: Machine, rng) -> dict:
    """symbol -> function of the programmed position (P,) of its axis: the declared errors of a well-kept machine."""
    errors = {}
    for symbol in FUNCTION_SYMBOLS:
        c = component(symbol)
        low, high = machine.axes[c.body].travel
        straightness = not c.angular and AXES[c.axis] != c.body
        start = 2 if straightness else 1
        size = (6e-6 if c.angular else 2.5e-3) * rng.normal(size=4 - start) / np.arange(1, 5 - start)
        coefficients = np.concatenate([np.zeros(start), size])
        errors[symbol] = (AXES.index(c.body), low, high, coefficients)
    return errors


def simulate(
    machine: Machine, errors: dict, squareness: dict, q, temperature, bend: bool = True, tool_offset=None
) -> np.ndarray:
    """(P, 3) mm by the exact product of matrices; with `bend` the Z carriage tilts about X with the column's heat."""
    values = {}
    for symbol, (axis, low, high, coefficients) in errors.items():
        v = (2 * q[:, axis] - low - high) / (high - low)
        values[symbol] = np.polynomial.legendre.legval(v, coefficients)
    values |= squareness
    if bend:
        values["EAZ"] = values["EAZ"] + BEND_URAD_PER_K * 1e-6 * temperature
    return exact_error(machine, values, q, tool_offset)[0]


def close_the_loop(machine: Machine, folder: Path, seed: int = 20) -> list[str]:
    """Simulate readings with an undeclared effect, trace them, predict new ones; returns what came out, in words."""
    rng = np.random.default_rng(seed)
    errors = simulated_errors(machine, rng)
    squareness = {s: float(v) for s, v in zip(("C0Y", "A0Z", "B0Z"), rng.normal(size=3) * 10e-6)}
    low, high = machine.travel.T

    def conditions(count, start):
        t = start + 9.0 * np.arange(count)
        column = 4.0 * (1 - np.exp(-t / 2400)) + 0.8 * np.sin(t / 500)
        return low + (high - low) * rng.random((count, 3)), t, column, 0.6 * np.sin(t / 4000)

    with staged(folder) as work:
        names = ["x_mm", "y_mm", "z_mm", "t_s", "temp_column_C", "temp_ambient_C"]
        q, t, column, ambient = conditions(700, 0.0)
        error = um(simulate(machine, errors, squareness, q, column)) + NOISE_UM * rng.normal(size=q.shape)
        rows = np.column_stack([q, t, 20 + column, 20 + ambient])
        answers = ["sign: error", "frame: tool_relative_to_workpiece"]
        _write_table(
            work / "measured.csv", answers, [*names, "ex_um", "ey_um", "ez_um"], np.column_stack([rows, error])
        )
        new = conditions(200, 1500.0)
        _write_table(work / "positions.csv", [], names, np.column_stack([new[0], new[1], 20 + new[2], 20 + new[3]]))
        outcome = trace_study(machine, readings_csv.load(work / "measured.csv"))
        study_files.write_trace(work, outcome)
        positions = readings_csv.load_positions(work / "positions.csv")
        found = predict_study(outcome.machine, positions)
        files = work / "predicted.csv", work / "positions.csv"
        readings_csv.save_predicted(*files, positions, found.error, found.extrapolated, u=found.u)
        truth = simulate(machine, errors, squareness, new[0], new[2])
        part = demo_part.make(
            outcome.machine,
            work / "part",
            lambda p: simulate(machine, errors, squareness, p.q, p.columns["temp_column"], tool_offset=p.contact),
        )
    held = {k: v.held_out["rms_um"] for k, v in outcome.error.items()}
    off = float(np.sqrt((um(found.error - truth) ** 2).sum(axis=1).mean()))
    named = [f"found: {e.effect.component} driven by {e.effect.driver}: {e.effect.name}" for e in outcome.effects]
    return [
        f"simulated: EAZ driven by temp_column, {BEND_URAD_PER_K:g} urad/K; verdict: {outcome.verdict}",
        *named,
        "rms of held-out readings: uncorrected {uncorrected:.2f}, declared model {declared:.2f}, with the effect "
        "{augmented:.2f} um".format(**held),
        f"prediction at 200 new places: {off:.2f} um rms from the truth",
        *part,
    ]


def _write_table(path: Path, answers, names, rows) -> None:
    with open(path, "w", encoding="utf-8", newline="") as stream:
        stream.writelines(f"# {a}\n" for a in answers)
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(names)
        writer.writerows([f"{v:.4f}" for v in row] for row in rows)
