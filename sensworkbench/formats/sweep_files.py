# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of a sweep: its specification (JSON), the table of results, and what is kept after an interruption.

While a sweep runs, finished lines are appended to `results.partial.csv`, whose first line names the sweep; the finished
table takes its place in one step.
"""

from __future__ import annotations

import csv
import datetime
import hashlib
import io
import json
import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np

from sensworkbench import __version__
from sensworkbench.core.machine import Machine
from sensworkbench.core.refusal import Refused
from sensworkbench.studies.sweep import DESIGNS, Parameter, Sweep, check_output, place_of

from . import charts, html, machine_json, provenance
from .files import neutral, read_text
from .json_text import Node, parse
from .words import Words

PARTIAL, RESULTS = "results.partial.csv", "results.csv"
PARETO = "pareto.csv"
_KEYS = ("machine", "parameters", "design", "n", "seed", "outputs", "minimise")
SMALLER = ("mean_square", "rms", "worst_rms", "variance")  # outputs that are better if they are smaller
SHOWN = 400  # variants in the picture
MOST_FRONT = 2000  # variants of the Pareto front that are kept


def machine_of(data: dict) -> Machine:
    """The machine of plain data."""
    return machine_json.from_place(Node(data, (), {}, "variant"))


def load(path) -> Sweep:
    """The sweep of a specification; the machine's file is looked for beside it.  Refuses with the place."""
    top = parse(read_text(path, 16 * 2**20), str(path))
    top.keys(_KEYS, ("machine", "parameters", "outputs"))
    name, document, machine = top["machine"].string(), "", None
    if name.lower().endswith(".fcstd"):
        document = str(Path(path).parent / name)
        if not Path(document).is_file():
            raise top["machine"].refuse("input-missing")
        data = {"document": provenance.sha256(document)[0]}
        provenance.note_file(document)
    else:
        machine = machine_json.load(Path(path).parent / name)
        data = machine_json.to_dict(replace(machine, version=2, tolerances=machine.all_tolerances))
    design = top["design"].string(DESIGNS) if "design" in top else "full"
    count = top["n"].integer(1, 10_000_000) if "n" in top else 0
    if design in ("lhs", "sobol") and not count:
        raise top.refuse("sweep-without-count")
    parameters = tuple(_parameter(e, design, None if document else data) for e in top["parameters"].elements())
    if not parameters or len({p.path for p in parameters}) < len(parameters):
        raise top["parameters"].refuse("sweep-parameters")
    if design == "list" and len({len(p.values) for p in parameters}) > 1:
        raise top["parameters"].refuse("sweep-list-lengths")
    outputs = []
    for entry in top["outputs"].elements():
        try:
            outputs.append(entry.string() if document else check_output(entry.string(), machine))
        except Refused as refused:
            raise Refused(refused.code, entry.where, **refused.fields) from None
    if not outputs or len(set(outputs)) < len(outputs):
        raise top["outputs"].refuse("sweep-outputs")
    minimise = _minimise(top, parameters, outputs)
    seed = top["seed"].integer(0, 2**31) if "seed" in top else 0
    sweep = Sweep(data, parameters, design, count, seed, tuple(outputs), document, minimise)
    sweep.size()
    return sweep


def _minimise(top: Node, parameters, outputs) -> tuple[str, ...]:
    """What the Pareto front is of: parameters and outputs, with "-" before the name of one to be maximised."""
    if "minimise" not in top:
        return tuple(o for o in outputs if o in SMALLER)
    names = []
    for entry in top["minimise"].elements():
        name = entry.string()
        if name.removeprefix("-") not in (*outputs, *(p.path for p in parameters)):
            raise entry.refuse("sweep-minimise", name=name[:60])
        names.append(name)
    return tuple(names)


def _parameter(entry: Node, design: str, data: dict | None) -> Parameter:
    """data : of the machine's file; None where the path is that of a document, which FreeCAD alone can check."""
    entry.keys(("path", "values", "range"), ("path",))
    path = entry["path"].string() if data is None else _spelled(entry["path"].string())
    if data is not None:
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
    try:
        text = path.read_text(encoding="utf-8")
    except UnicodeDecodeError:
        raise Refused("sweep-other", str(path)) from None
    first, ended, rest = text.partition("\n")
    if not ended and f"# {identity(sweep)}".startswith(first):
        return []  # stopped before anything was kept
    if first != f"# {identity(sweep)}":
        raise Refused("sweep-other", str(path))
    lines = rest.split("\n")[:-1]  # what follows the last line end was cut off
    good = []
    for number, row in enumerate(lines):
        if not row.startswith(f"{number},") or len(next(csv.reader([row]))) != len(header(sweep)):
            break
        good.append(row + "\n")
    return good


# -- what is shown of all of them --------------------------------------------------------------------------------------
def _lines(partial):
    """The finished rows of a table that is being written, as lists of cells, one at a time."""
    with open(partial, encoding="utf-8", newline="") as stream:
        next(stream)
        yield from csv.reader(stream)


def write_results(sweep: Sweep, partial, path) -> None:
    """Write the table of results, of any length, from what was kept while it was made."""
    with open(partial, encoding="utf-8", newline="") as source, open(path, "w", encoding="utf-8", newline="\n") as out:
        next(source)
        csv.writer(out, lineterminator="\n").writerow(header(sweep))
        shutil.copyfileobj(source, out)


def front(sweep: Sweep, rows) -> list[list[str]]:
    """Rows that no other row beats in everything that is to be minimised, in the order of the design.

    Equal rows stay together.  At most MOST_FRONT are kept; memory does not grow with the number of rows.
    """
    names = header(sweep)
    places = [(names.index(n.removeprefix("-")), -1.0 if n.startswith("-") else 1.0) for n in sweep.minimise]
    kept: list[list[str]] = []
    values = np.zeros((0, len(places)))
    for row in rows:
        if row[-1] or not places:
            continue
        mine = np.array([sign * float(row[at]) for at, sign in places])
        worse = (values >= mine).all(axis=1) & (values > mine).any(axis=1)
        if len(values) and ((values <= mine).all(axis=1) & (values < mine).any(axis=1)).any():
            continue
        if worse.any():
            kept = [r for r, w in zip(kept, worse) if not w]
            values = values[~worse]
        if len(kept) < MOST_FRONT:
            kept.append(row)
            values = np.vstack([values, mine])
    return kept


def summary(sweep: Sweep, partial, language: str = "en") -> dict[str, str]:
    """The Pareto front and a page with parallel coordinates, of the rows that were kept in `partial`."""
    best = front(sweep, _lines(partial))
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(header(sweep)[:-1])
    writer.writerows(row[:-1] for row in best)
    return {PARETO: stream.getvalue(), "report.html": _report(sweep, partial, best, language)}


def _report(sweep: Sweep, partial, best, language: str) -> str:
    words, names = Words(language), header(sweep)[1:-1]
    step = max(1, sweep.size() // SHOWN)
    chosen, refused = [], 0
    for number, row in enumerate(_lines(partial)):
        refused += bool(row[-1])
        if not row[-1] and number % step == 0:
            chosen.append([float(v) for v in row[1:-1]])
    marked = [[float(v) for v in row[1:-1]] for row in best[:SHOWN]]
    chart = charts.parallel_chart(names, chosen, marked, words("sweep-all"), words("sweep-front"), words("sweep-alt"))
    tiles = [(f"{sweep.size():,}", words("sweep-variants")), (str(len(best)), words("sweep-on-front"))]
    if refused:
        tiles.append((str(refused), words("sweep-refused")))
    parts = [html.tiles(tiles)]
    if chart is not None:
        parts.append(html.section(words("sweep-picture"), html.figure(chart, words("sweep-picture-words"))))
    if best:
        listed = ", ".join(sweep.minimise)
        rows = [[row[0], *(f"{float(v):.5g}" for v in row[1:-1])] for row in best[:40]]
        table = html.table([words("sweep-variant"), *(f"#{n}" for n in names)], rows)
        explained = html.paragraph(words("sweep-front-words", names=listed), soft=True)
        parts.append(html.section(words("sweep-front"), explained, table))
    return html.page(
        words("sweep-title"),
        words("sweep-subtitle", design=sweep.design),
        *parts,
        footer=words("report-footer", version=__version__, date=datetime.date.today().isoformat()),
        language=language,
    )
