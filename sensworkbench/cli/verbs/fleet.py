# SPDX-License-Identifier: LGPL-2.1-or-later
"""`fleet DIR --out DIR`: the records of many machines, and which effect recurs on which machine."""

from __future__ import annotations

from .. import common, executors

HELP = "trace the records of many machines: which effect recurs on which machine"
FILES = "`fleet.json`, `fleet.csv`, `report.html`"


def add(parser) -> None:
    text = "a folder with one folder per machine, each with machine.json and measured.csv"
    parser.add_argument("fleet", metavar="DIR", help=text)
    parser.add_argument("--out", metavar="DIR", required=True, help="folder for fleet.json, fleet.csv and report.html")
    text = "share of false names among those that stand (default 0.05)"
    parser.add_argument("--rate", metavar="R", type=common.positive, default=0.05, help=text)
    parser.add_argument("--seed", metavar="N", type=common.whole, default=0, help="of the permutations (default 0)")
    text = "behind each p (default: grows with the number of machines)"
    parser.add_argument("--permutations", metavar="N", type=common.whole, help=text)
    executors.add_workers(parser, "trace records")
    common.add_language(parser)


def run(arguments) -> int:
    from sensworkbench.formats import fleet_files, study_files
    from sensworkbench.studies.fleet import fleet_study

    executors.check_workers(arguments)
    names = fleet_files.members(arguments.fleet)
    read = fleet_files.Reader(str(arguments.fleet))
    with executors.executor(arguments) as (executor, workers):
        if executor is not None:
            read.note_inputs(names)
        told = _Told(len(names))
        result = fleet_study(names, read, executor, arguments.rate, arguments.seed, arguments.permutations, told)
    paths = study_files.write_set(arguments.out, "fleet", fleet_files.files(result, arguments.language))
    bad = sum(bool(m.refused) for m in result.members)
    if bad:
        common.say(f"{bad} of {len(names)} records were refused; the table says why")
    for effect in result.recurring:
        machines = ", ".join(effect.machines)
        common.say(f"{effect.component} driven by {effect.driver} ({effect.shape}): {machines}")
    return common.say_paths(paths)


class _Told:
    """Says how many records are done, one line each."""

    def __init__(self, count: int):
        self.count, self.said = count, 0

    def __call__(self, part: float) -> bool:
        done = int(part * self.count + 1e-9)
        if done > self.said:
            self.said = done
            common.say(f"{done} of {self.count} records")
        return True
