# SPDX-License-Identifier: LGPL-2.1-or-later
"""`plan MACHINE [POSITIONS.csv] --out DIR`: what a measuring plan could find, before anything is measured."""

from __future__ import annotations

from pathlib import Path

from sensworkbench.messages import Refused

from .. import common

HELP = "what a measuring plan could find, before measuring"
FILES = "`plan.json`, `report.html`, `candidates.csv`, `positions_suggested.csv`"

SMALLEST_NOISE_UM = 1e-6  # a picometre; far below, sums of weights overflow


def add(parser) -> None:
    common.add_machine(parser)
    text = "planned places and conditions; optional with --suggest"
    parser.add_argument("positions", metavar="POSITIONS.csv", nargs="?", help=text)
    text = "folder for plan.json, report.html, candidates.csv"
    parser.add_argument("--out", metavar="DIR", required=True, help=text)
    text = "of one reading, um (default 1)"
    parser.add_argument("--noise", metavar="UM", type=common.positive, default=1.0, help=text)
    text = "write positions_suggested.csv with N places"
    parser.add_argument("--suggest", metavar="N", type=common.whole, help=text)
    text = "of the suggested plan (default 0)"
    parser.add_argument("--seed", metavar="N", type=common.whole, default=0, help=text)
    common.add_mapping(parser)
    common.add_language(parser)


def run(arguments) -> int:
    if arguments.positions is None and arguments.suggest is None:
        raise Refused("plan-missing", "plan")
    if arguments.noise < SMALLEST_NOISE_UM:
        raise Refused(
            "uncertainty-too-small", "--noise", value=f"{arguments.noise:g} um", limit=SMALLEST_NOISE_UM * 1e-3
        )
    from sensworkbench.formats import plan_html, plan_json, study_files
    from sensworkbench.studies.plan import PlanRequest, plan_study

    readings, mapping = None, common.mapping(arguments)
    machine = common.load_machine(arguments.machine)
    if arguments.positions is not None:
        readings = plan_json.load(arguments.positions, arguments.noise, mapping, machine.joints)
        common.keep_inputs(Path(arguments.out) / plan_html.SUGGESTED, arguments.positions)
    request = PlanRequest(arguments.noise, arguments.suggest, arguments.seed)
    try:
        with common.rows_of(arguments.positions):
            study = plan_study(machine, readings, request)
    except Refused as refused:
        if refused.code == "plan-few-readings" and arguments.positions is not None:
            raise refused.at(arguments.positions) from None
        raise
    paths = study_files.write_plan(arguments.out, study, arguments.language)
    for line in plan_json.summary(plan_json.to_dict(study)):
        common.say(line)
    return common.say_paths(paths)
