# SPDX-License-Identifier: LGPL-2.1-or-later
"""`sweep SPEC.json --out DIR`: one machine in many variants, in one table."""

from __future__ import annotations

import argparse
import contextlib
import importlib
import json
from collections.abc import Iterator
from pathlib import Path

from sensworkbench.core.refusal import Refused

from .. import common, executors

HELP = "one machine in many variants, in one table"
FILES = "`results.csv`, `pareto.csv`, `report.html`"
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
    from sensworkbench.formats import sweep_files, sweep_run

    executors.check_workers(arguments)
    sweep = sweep_files.load(arguments.spec)
    if arguments.rows:
        return _judge_rows(sweep, arguments.rows, arguments.out)
    folder = Path(arguments.out)
    common.keep_inputs(folder / sweep_files.RESULTS, arguments.spec)
    done = sweep_files.kept(folder, sweep) if arguments.resume else []
    with contextlib.ExitStack() as stack:
        judged = _rows(arguments, sweep, len(done), stack)
        paths, refused = sweep_run.write(folder, sweep, done, judged, arguments.language)
    if refused:
        common.say(f"{refused} of {sweep.size()} variants were refused; the last column of the table says why")
    return common.say_paths(paths)


def _rows(arguments, sweep, start: int, stack: contextlib.ExitStack) -> Iterator:
    """The judged variants from number `start` on; what must be closed afterwards goes on `stack`."""
    from sensworkbench.formats import sweep_run
    from sensworkbench.studies.sweep import run_sweep

    if not sweep.document:
        executor, workers = stack.enter_context(executors.executor(arguments))
        chunk = sweep_run.chunk_of(sweep.size() - start, workers)
        return run_sweep(sweep, _file_judge(sweep), executor, workers, start, chunk=chunk)
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


def _file_judge(sweep):
    from sensworkbench.formats import sweep_files
    from sensworkbench.studies.sweep import FileJudge

    return FileJudge(sweep_files.machine_of, sweep.data, sweep.paths, sweep.outputs)


class _InFreeCAD:
    """Judges variants, each list of them in a FreeCAD process of its own; a process that fails ends the verb."""

    def __init__(self, spec: str):
        module = importlib.import_module("sensworkbench.document.sweep_workers")
        self.judge, self.ended = module.WorkerJudge(spec), module.WorkerEnded

    def __call__(self, rows) -> list:
        try:
            return self.judge(rows)
        except self.ended as ended:
            if ended.status == common.INTERRUPTED:
                raise KeyboardInterrupt from None
            raise SystemExit(ended.status or common.DEFECT) from None


def _judge_rows(sweep, asked: str, answered: str) -> int:
    """Judge the variants of the file `asked` inside FreeCAD and write what was found to `answered`."""
    rows = [tuple(map(float, row)) for row in json.loads(Path(asked).read_text(encoding="utf-8"))]
    if sweep.document:
        with contextlib.closing(_document_judge(sweep)) as judge:
            found = judge(rows)
    else:
        found = _file_judge(sweep)(rows)
    Path(answered).write_text(json.dumps(found), encoding="utf-8")
    return common.DONE
