# SPDX-License-Identifier: LGPL-2.1-or-later
"""`trace MACHINE MEASURED.csv --out DIR`: what the readings show that the model lacks."""

from __future__ import annotations

from pathlib import Path

from sensworkbench.messages import Refused

from .. import common

HELP = "from readings to the effect that the model lacks"
FILES = "`trace.json`, `report.html`, `machine_augmented.json` (`.FCStd`), `covariance.npz`"
ALIGNMENTS = {"once": "once", "offset-per-run": "offset per run", "per-run": "per run"}  # option -> as in a header
AUGMENTED = "machine_augmented.FCStd"


def add(parser) -> None:
    common.add_machine(parser)
    parser.add_argument("readings", metavar="MEASURED.csv", help="what was measured")
    text = "folder for trace.json, report.html, machine_augmented.*"
    parser.add_argument("--out", metavar="DIR", required=True, help=text)
    common.add_mapping(parser)
    text = "of the permutations (default 0)"
    parser.add_argument("--seed", metavar="N", type=common.whole, default=0, help=text)
    text = "behind each p (default 199)"
    parser.add_argument("--permutations", metavar="N", type=common.whole, default=199, help=text)
    text = "of the set-up, in place of what the header of MEASURED.csv says (default: as it says, else by the readings)"
    parser.add_argument("--alignment", choices=tuple(ALIGNMENTS), default="", help=text)
    common.add_language(parser)


def run(arguments) -> int:
    from sensworkbench.formats import machine_json, readings_csv, study_files
    from sensworkbench.studies.trace import TraceRequest, trace_study

    mapping = common.mapping(arguments)

    def traced(machine):
        readings = readings_csv.load(arguments.readings, mapping, machine.joints)
        with common.rows_of(arguments.readings):
            alignment = ALIGNMENTS.get(arguments.alignment, "")
            return trace_study(machine, readings, TraceRequest(arguments.seed, arguments.permutations, alignment))

    if not common.is_document(arguments.machine):
        outcome = traced(machine_json.load(arguments.machine))
        paths = study_files.write_trace(arguments.out, outcome, language=arguments.language)
    else:
        batch = common.batch()
        machine, opened = batch.load_machine(arguments.machine)
        with opened:
            outcome = traced(machine)

            def add_document(work, augmented):
                batch.write_augmented(opened, work / AUGMENTED, augmented)

            if common.same_file(Path(arguments.out) / AUGMENTED, arguments.machine):
                raise Refused("out-is-input-folder", arguments.machine)
            paths = study_files.write_trace(arguments.out, outcome, add_document, arguments.language)
    common.say(outcome.verdict)
    for found in outcome.effects:
        common.say(f"  {found.effect.component} driven by {found.effect.driver}: {found.effect.name}")
    if outcome.hidden:
        common.say(f"  {outcome.hidden.title}")
    return common.say_paths(paths)
