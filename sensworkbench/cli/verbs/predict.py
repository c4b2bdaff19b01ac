# SPDX-License-Identifier: LGPL-2.1-or-later
"""`predict MACHINE_AUGMENTED POSITIONS.csv --out FILE`: the error at new places and conditions."""

from __future__ import annotations

from sensworkbench.core.refusal import Refused
from sensworkbench.messages import Message

from .. import common

HELP = "the error at new places and conditions"
FILES = "a table"


def add(parser) -> None:
    common.add_machine(parser, metavar="MACHINE_AUGMENTED", help="what trace wrote")
    parser.add_argument("positions", metavar="POSITIONS.csv", help="the columns of measured.csv without readings")
    parser.add_argument("--out", metavar="FILE", required=True, help="the positions with ex_um … and u_ex_um …")
    common.add_mapping(parser)
    text = "leave out the fitted alignment and offsets"
    parser.add_argument("--no-alignment", action="store_true", help=text)


def run(arguments) -> int:
    from sensworkbench.formats import readings_csv
    from sensworkbench.studies.predict import PredictRequest, predict_study

    mapping = common.mapping(arguments)
    machine = common.load_machine(arguments.machine)
    positions = readings_csv.load_positions(arguments.positions, mapping, machine.joints)
    common.keep_inputs(arguments.out, arguments.positions, arguments.machine)
    try:
        found = predict_study(machine, positions, PredictRequest(alignment=not arguments.no_alignment))
    except Refused as refused:  # what is missing, is missing from this file
        place = arguments.positions if machine.fitted is not None else arguments.machine
        raise refused.at(str(place)) from None
    out, extrapolated = arguments.out, found.extrapolated
    readings_csv.save_predicted(out, arguments.positions, positions, found.error, extrapolated, mapping, found.u)
    if not found.u_known:
        common.say(str(Message("predict-no-uncertainty", machine=str(arguments.machine))))
    return common.say_paths([arguments.out])
