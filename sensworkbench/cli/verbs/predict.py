# SPDX-License-Identifier: LGPL-2.1-or-later
"""`predict MACHINE_AUGMENTED POSITIONS.csv --out FILE`: the error at new places and conditions."""

from __future__ import annotations

from sensworkbench.core.refusal import Refused

from .. import common

HELP = "the error at new places and conditions"
FILES = "a table"


def add(parser) -> None:
    common.add_machine(parser, metavar="MACHINE_AUGMENTED", help="what trace wrote")
    parser.add_argument("positions", metavar="POSITIONS.csv", help="the columns of measured.csv without readings")
    parser.add_argument("--out", metavar="FILE", required=True, help="the positions with ex_um, ey_um, ez_um")
    common.add_mapping(parser)
    text = "leave out the fitted alignment and offsets"
    parser.add_argument("--no-alignment", action="store_true", help=text)


def run(arguments) -> int:
    from sensworkbench.closedloop import predict
    from sensworkbench.formats import readings_csv

    mapping = common.mapping(arguments)
    machine = common.load_machine(arguments.machine)
    positions = readings_csv.load_positions(arguments.positions, mapping, machine.joints)
    common.keep_inputs(arguments.out, arguments.positions, arguments.machine)
    try:
        error = predict.predict(machine, positions, alignment=not arguments.no_alignment)
    except Refused as refused:  # what is missing, is missing from this file
        place = arguments.positions if machine.fitted is not None else arguments.machine
        raise refused.at(str(place)) from None
    outside = predict.extrapolated(machine, positions)
    readings_csv.save_predicted(arguments.out, arguments.positions, positions, error, outside, mapping)
    return common.say_paths([arguments.out])
