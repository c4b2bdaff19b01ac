# SPDX-License-Identifier: LGPL-2.1-or-later
"""`sweep SPEC.json --out DIR`: one machine in many variants, in one table."""

from __future__ import annotations

import argparse
import contextlib
import csv
import importlib
import json
import tempfile
from collections.abc import Iterator
from pathlib import Path

from sensworkbench.core.refusal import Refused

from .. import common, executors

HELP = "one machine in many variants, in one table"
FILES = "`results.csv`, `pareto.csv`, `report.html`"
ROWS = "rows.json"
LARGEST_CHUNK = 1000
FEWEST, MOST = 16, 256  # variants that one FreeCAD judges before it ends


def add(parser) -> None:
    parser.add_argument("spec", metavar="SPEC.json", help="machine, parameters, design and outputs")
    parser.add_argument("--out", metavar="DIR", required=True, help="folder for results.csv")
    executors.add_workers(parser, "judge variants")
    text = "go on where an interrupted run of the same sweep in DIR ended"
    parser.add_argument("--resume", action="store_true", help=text)
    common.add_language(parser)
    parser.add_argument("--rows", metavar="FILE", help=argparse.SUPPRESS)


def run(arguments) -> int:
    from sensworkbench.formats import study_files, sweep_files

    executors.check_workers(arguments)
    sweep = sweep_files.load(arguments.spec)
    if arguments.rows:
        return _judge_rows(sweep, arguments.rows, arguments.out)
    folder = Path(arguments.out)
    common.keep_inputs(folder / sweep_files.RESULTS, arguments.spec)
    done = sweep_files.kept(folder, sweep) if arguments.resume else []
    with contextlib.ExitStack() as stack:
        judged = _rows(arguments, sweep, len(done), stack)
        folder.mkdir(parents=True, exist_ok=True)
        partial = folder / sweep_files.PARTIAL
        refused = sum(1 for row in done if next(csv.reader([row]))[-1])
        with partial.open("w", encoding="utf-8", newline="\n") as stream:
            stream.write(f"# {sweep_files.identity(sweep)}\n" + "".join(done))
            stream.flush()
            for number, values, outputs, words in judged:
                stream.write(sweep_files.line(sweep, number, values, outputs, words))
                stream.flush()
                refused += outputs is None
    files = sweep_files.summary(sweep, partial, arguments.language)
    extra = lambda work: sweep_files.write_results(sweep, partial, work / sweep_files.RESULTS)  # noqa: E731
    paths = study_files.write_set(folder, "sweep", files, extra)
    partial.unlink()
    if refused:
        common.say(f"{refused} of {sweep.size()} variants were refused; the last column of the table says why")
    return common.say_paths(paths)


def chunk_of(variants: int, workers: int) -> int:
    """Variants that a worker gets at a time: few enough that all have work to the end, and many enough that handing
    them out costs little (docs/sweeps.md)."""
    from sensworkbench.studies.sweep import CHUNK

    return max(CHUNK, min(LARGEST_CHUNK, variants // (8 * workers)))


def _rows(arguments, sweep, start: int, stack: contextlib.ExitStack) -> Iterator:
    """The judged variants from number `start` on; what must be closed afterwards goes on `stack`."""
    from sensworkbench.formats import sweep_files
    from sensworkbench.studies.sweep import FileJudge, run_sweep

    if not sweep.document:
        executor, workers = stack.enter_context(executors.executor(arguments))
        judge = FileJudge(sweep_files.machine_of, sweep.data, sweep.paths, sweep.outputs)
        return run_sweep(sweep, judge, executor, workers, start, chunk=chunk_of(sweep.size() - start, workers))
    if arguments.scheduler:
        raise Refused("sweep-document-cluster", "--scheduler")
    if common.in_freecad():
        judge = _document_judge(sweep)
        stack.callback(judge.close)
        return run_sweep(sweep, judge, None, 1, start)
    from concurrent.futures import ThreadPoolExecutor

    judge = _InFreeCAD(str(arguments.spec))
    judge([])  # the document and the paths are checked before anything is written
    pool = stack.enter_context(ThreadPoolExecutor(arguments.workers))
    chunk = max(FEWEST, min(MOST, -(-(sweep.size() - start) // (4 * arguments.workers))))
    return run_sweep(sweep, judge, pool, arguments.workers, start, chunk=chunk)


def _document_judge(sweep):
    module = importlib.import_module("sensworkbench.document.sweeping")
    return module.DocumentJudge(sweep.document, sweep.paths, sweep.outputs)


class _InFreeCAD:
    """Judges variants of a document, each list of them in a FreeCAD process of its own."""

    def __init__(self, spec: str):
        self.spec = spec

    def __call__(self, rows) -> list:
        handoff = importlib.import_module("sensworkbench.document.handoff")
        with tempfile.TemporaryDirectory(prefix="sens-sweep-") as place:
            asked, answered = Path(place, ROWS), Path(place, "out")
            asked.write_text(json.dumps([list(row) for row in rows]), encoding="utf-8")
            status = handoff.run(["sweep", self.spec, "--out", str(answered), "--rows", str(asked)])
            if status == common.INTERRUPTED:
                raise KeyboardInterrupt
            if status != common.DONE or not answered.is_file():
                raise SystemExit(status or common.DEFECT)
            return [(found, words) for found, words in json.loads(answered.read_text(encoding="utf-8"))]


def _judge_rows(sweep, asked: str, answered: str) -> int:
    """Judge the variants of the file `asked` inside FreeCAD and write what was found to `answered`."""
    rows = json.loads(Path(asked).read_text(encoding="utf-8"))
    judge = _document_judge(sweep)
    try:
        found = judge([tuple(map(float, row)) for row in rows])
    finally:
        judge.close()
    Path(answered).write_text(json.dumps(found), encoding="utf-8")
    return common.DONE
