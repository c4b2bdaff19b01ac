# SPDX-License-Identifier: LGPL-2.1-or-later
"""Saves the documents of the present schema that tests/document/test_old_files.py opens for ever after.

    freecadcmd -c "import runpy; runpy.run_path('tests/data/make_schema_files.py', run_name='__main__')"

Run it, with the oldest FreeCAD that is supported, once per new schema, before that is released; files of earlier
schemas are never written again.  Beside each document stands what it held, as JSON.
"""

from __future__ import annotations

import json
import sys
import tempfile
from pathlib import Path

HERE = Path.cwd() / "tests" / "data"
sys.path.insert(0, str(Path.cwd()))

import FreeCAD as App  # noqa: E402

from sensworkbench.closedloop.trace import trace  # noqa: E402
from sensworkbench.core import distributions  # noqa: E402
from sensworkbench.core.objectives import MeanSquare  # noqa: E402
from sensworkbench.document import closed_loop, extract, factory, jog, results, told  # noqa: E402
from sensworkbench.document.base import kind_of  # noqa: E402
from sensworkbench.formats import readings_csv  # noqa: E402
from sensworkbench.formats.effects_json import of_parameters  # noqa: E402
from tests.document import simulated  # noqa: E402
from tests.document.blocks import TURNED, golden_machine  # noqa: E402
from tests.document.stored import values  # noqa: E402

SCHEMA = 3


def plain_machine(doc):
    """An XYFZ machine with results, nothing else set."""
    machine = golden_machine(doc)
    results.compute(machine)
    return machine


def full_machine(doc):
    """A YFXZ machine in a moved container: effects, tolerances, settings, results, axes away from home."""
    holder = doc.addObject("App::Part", "Holder")
    holder.Placement = TURNED
    machine = golden_machine(doc, "YFXZ", parent=holder)
    parameters = {"coefficient": {"value": 2.5, "unit": "urad/K", "u": 0.1}}
    effect = of_parameters("column tilts with temperature", "EAZ", "temp_column", "linear", parameters)
    factory.make_effect(machine, effect)
    given = {"EAX": distributions.Tolerance(-5e-6, 9e-6, "normal", 2e-6)}
    factory.set_tolerances(machine, given, {"EAX": "arcsec"})
    machine.Declared = {"EXX": "5"}
    machine.Extra = json.dumps({"x-maker": "someone"})
    machine.Squareness = "carried"
    machine.Objective = told.objective_text(MeanSquare(weights=(1, 2, 0.5)))
    machine.Aggregate, machine.At = "at", [10, -20, 30]
    results.compute(machine)
    jog.jog(machine, {"X": 12, "Z": -7})
    doc.recompute()
    return machine


def traced_machine(doc):
    """An XYFZ machine with readings, their trace, and the effects that were found."""
    machine = golden_machine(doc)
    core = extract.core_machine(machine)
    with tempfile.TemporaryDirectory() as folder:
        measured = simulated.write(Path(folder) / "measured.csv", simulated.table(core))
        table = closed_loop.make_readings(machine, measured)
        found = closed_loop.make_trace(machine, table, trace(core, readings_csv.load(measured)), core)
    if closed_loop.can_add(found):
        closed_loop.add_effects(found)
    results.compute(machine)
    return machine


def expected(doc, machine) -> dict:
    """All that our objects store, and the arms that the core makes of it."""
    core = extract.core_machine(machine)
    arms = core.lever_arms([[0.0, 0.0, 0.0], [10.0, -20.0, 30.0]])
    return {
        "schema": SCHEMA,
        "objects": {o.Name: values(o) for o in doc.Objects if kind_of(o)},
        "arms": {body: a.tolist() for body, a in arms.items()},
        "structure": core.structure,
    }


def main():
    for name, make in (("plain", plain_machine), ("full", full_machine), ("traced", traced_machine)):
        doc = App.newDocument(f"schema_{SCHEMA}_{name}")
        doc.Label = f"schema-{SCHEMA}-{name}"
        machine = make(doc)
        doc.recompute()
        path = HERE / f"schema-{SCHEMA}-{name}.FCStd"
        data = expected(doc, machine)
        path.unlink(missing_ok=True)
        doc.saveAs(str(path))
        text = json.dumps(data, separators=(",", ":"), sort_keys=True)
        path.with_suffix(".json").write_text(text + "\n", encoding="utf-8")
        App.closeDocument(doc.Name)


if __name__ == "__main__":
    main()
