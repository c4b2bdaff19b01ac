# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of a sweep: its specification (JSON), the table of results, and what is kept after an interruption.

While a sweep runs, finished lines are appended to `results.partial.csv`, whose first line names the sweep; the finished
table takes its place in one step.
"""

from __future__ import annotations

import csv
import hashlib
import io
import json
from dataclasses import replace
from pathlib import Path

from sensworkbench.core.machine import Machine
from sensworkbench.core.refusal import Refused
from sensworkbench.studies.sweep import DESIGNS, Parameter, Sweep, check_output, place_of

from . import machine_json
from .files import neutral, read_text
from .json_text import Place, parse

PARTIAL, RESULTS = "results.partial.csv", "results.csv"
_KEYS = ("machine", "parameters", "design", "n", "seed", "outputs")


def machine_of(data: dict) -> Machine:
    """The machine of plain data."""
    return machine_json.from_place(Place(data, (), {}, "variant"))


def load(path) -> Sweep:
    """The sweep of a specification; the machine's file is looked for beside it.  Refuses with the place."""
    top = parse(read_text(path, 16 * 2**20), str(path))
    top.keys(_KEYS, ("machine", "parameters", "outputs"))
    name = top["machine"].string()
    if name.lower().endswith(".fcstd"):
        raise top["machine"].refuse("sweep-of-document")
    machine = machine_json.load(Path(path).parent / name)
    data = machine_json.to_dict(replace(machine, version=2, tolerances=machine.all_tolerances))
    design = top["design"].string(DESIGNS) if "design" in top else "full"
    count = top["n"].integer(1, 10_000_000) if "n" in top else 0
    if design in ("lhs", "sobol") and not count:
        raise top.refuse("sweep-without-count")
    parameters = tuple(_parameter(e, design, data) for e in top["parameters"].elements())
    if not parameters or len({p.path for p in parameters}) < len(parameters):
        raise top["parameters"].refuse("sweep-parameters")
    if design == "list" and len({len(p.values) for p in parameters}) > 1:
        raise top["parameters"].refuse("sweep-list-lengths")
    outputs = []
    for entry in top["outputs"].elements():
        try:
            outputs.append(check_output(entry.string(), machine))
        except Refused as refused:
            raise Refused(refused.code, entry.where, **refused.fields) from None
    if not outputs or len(set(outputs)) < len(outputs):
        raise top["outputs"].refuse("sweep-outputs")
    seed = top["seed"].integer(0, 2**31) if "seed" in top else 0
    sweep = Sweep(data, parameters, design, count, seed, tuple(outputs))
    sweep.size()
    return sweep


def _parameter(entry: Place, design: str, data: dict) -> Parameter:
    entry.keys(("path", "values", "range"), ("path",))
    path = _spelled(entry["path"].string())
    try:
        place_of(data, path)
    except Refused as refused:
        raise Refused(refused.code, entry["path"].where, **refused.fields) from None
    if ("values" in entry) == ("range" in entry):
        raise entry.refuse("sweep-values-or-range")
    if "values" in entry:
        values = tuple(entry["values"].numbers())
        if not values:
            raise entry["values"].refuse("sweep-values-or-range")
        if design in ("lhs", "sobol"):
            raise entry["values"].refuse("sweep-range-wanted")
        return Parameter(path, values, min(values), max(values))
    numbers = entry["range"].numbers()
    if len(numbers) not in (2, 3) or not numbers[0] < numbers[1]:
        raise entry["range"].refuse("sweep-range")
    low, high = numbers[:2]
    if design in ("lhs", "sobol"):
        return Parameter(path, (), low, high)
    count = numbers[2] if len(numbers) == 3 else 0
    if count != int(count) or not 2 <= count <= 100_000:
        raise entry["range"].refuse("sweep-range")
    step = (high - low) / (count - 1)
    return Parameter(path, tuple(low + step * i for i in range(int(count))), low, high)


def _spelled(path: str) -> str:
    """A path of version 1, axes.X.reference.0, as that of version 2, joints.X.point.0."""
    steps = path.split(".")
    if steps[0] == "axes":
        steps = ["joints", *("point" if s == "reference" else s for s in steps[1:])]
    return ".".join(steps)


# -- results -----------------------------------------------------------------------------------------------------------
def header(sweep: Sweep) -> list[str]:
    """Names of the columns."""
    return ["variant", *(p.path for p in sweep.parameters), *sweep.outputs, "refused"]


def line(sweep: Sweep, number: int, values, outputs, words: str) -> str:
    """One line of the table; the shortest digits that read back equal."""
    stream = io.StringIO()
    shown = [repr(v) for v in outputs] if outputs is not None else [""] * len(sweep.outputs)
    row = [number, *(repr(float(v)) for v in values), *shown, neutral(words)]
    csv.writer(stream, lineterminator="\n").writerow(row)
    return stream.getvalue()


def identity(sweep: Sweep) -> str:
    """SHA-256 of everything that decides the results."""
    parts = [
        dict(sweep.data),
        [repr(p) for p in sweep.parameters],
        sweep.design,
        sweep.count,
        sweep.seed,
        sweep.outputs,
    ]
    return hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()


def kept(folder, sweep: Sweep) -> list[str]:
    """Whole lines of an interrupted run of the same sweep in `folder`."""
    path = Path(folder) / PARTIAL
    if not path.is_file():
        return []
    text = path.read_text(encoding="utf-8")
    first, _, rest = text.partition("\n")
    if first != f"# {identity(sweep)}":
        raise Refused("sweep-other", str(path))
    lines = rest.split("\n")[:-1]  # what follows the last line end was cut off
    good = []
    for number, row in enumerate(lines):
        if not row.startswith(f"{number},") or len(next(csv.reader([row]))) != len(header(sweep)):
            break
        good.append(row + "\n")
    return good
