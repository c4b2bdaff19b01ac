# SPDX-License-Identifier: LGPL-2.1-or-later
"""`sweep SPEC.json --out DIR`: one machine in many variants, in one table."""

from __future__ import annotations

import csv
import io
from pathlib import Path

from .. import common, executors

HELP = "one machine in many variants, in one table"
FILES = "`results.csv`"


def add(parser) -> None:
    parser.add_argument("spec", metavar="SPEC.json", help="machine, parameters, design and outputs")
    parser.add_argument("--out", metavar="DIR", required=True, help="folder for results.csv")
    executors.add_workers(parser, "judge variants")
    text = "go on where an interrupted run of the same sweep in DIR ended"
    parser.add_argument("--resume", action="store_true", help=text)


def run(arguments) -> int:
    from sensworkbench.formats import study_files, sweep_files
    from sensworkbench.studies.sweep import run_sweep

    executors.check_workers(arguments)
    sweep = sweep_files.load(arguments.spec)
    folder = Path(arguments.out)
    common.keep_inputs(folder / sweep_files.RESULTS, arguments.spec)
    done = sweep_files.kept(folder, sweep) if arguments.resume else []
    folder.mkdir(parents=True, exist_ok=True)
    partial = folder / sweep_files.PARTIAL
    refused = sum(1 for row in done if next(csv.reader([row]))[-1])
    with partial.open("w", encoding="utf-8", newline="\n") as stream:
        stream.write(f"# {sweep_files.identity(sweep)}\n" + "".join(done))
        with executors.executor(arguments) as (executor, workers):
            rows = run_sweep(sweep, sweep_files.machine_of, executor, workers, len(done))
            for number, values, outputs, words in rows:
                stream.write(sweep_files.line(sweep, number, values, outputs, words))
                stream.flush()
                refused += outputs is None
    head = io.StringIO()
    csv.writer(head, lineterminator="\n").writerow(sweep_files.header(sweep))
    with partial.open(encoding="utf-8", newline="") as stream:
        next(stream)
        text = head.getvalue() + stream.read()
    paths = study_files.write_set(folder, "sweep", {sweep_files.RESULTS: text})
    partial.unlink()
    if refused:
        common.say(f"{refused} of {sweep.size()} variants were refused; the last column of the table says why")
    return common.say_paths(paths)
