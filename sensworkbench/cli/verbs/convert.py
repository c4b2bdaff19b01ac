# SPDX-License-Identifier: LGPL-2.1-or-later
"""`convert MACHINE --to FORMAT --out DIR`: fitted errors into the tables of a controller."""

from __future__ import annotations

from pathlib import Path

from sensworkbench.core.refusal import Refused

from .. import common

HELP = "fitted errors into the tables of a controller"
FILES = "tables, `statement.txt`"


def add(parser) -> None:
    text = "machine.json with fitted errors, or an .FCStd document that holds one"
    common.add_machine(parser, help=text)
    text = "isg, etalon, linuxcnc, heidenhain, siemens or fcm"
    parser.add_argument("--to", metavar="FORMAT", required=True, help=text)
    parser.add_argument("--out", metavar="DIR", required=True, help="folder for the tables and statement.txt")
    text = "axis tables hold the error on lines through this (middle)"
    parser.add_argument("--through", metavar="X,Y,Z", type=common.triple, help=text)
    text = "places and conditions for the predicted error (default: the workspace)"
    parser.add_argument("--positions", metavar="CSV", help=text)


def run(arguments) -> int:
    from sensworkbench.formats import readings_csv
    from sensworkbench.formats.exchange import convert

    if arguments.to not in convert.FORMATS_OUT:
        raise Refused(f"unknown format {arguments.to!r}", "--to", f"Use one of {', '.join(convert.FORMATS_OUT)}.")
    options = {}
    if arguments.through is not None:
        if arguments.to not in convert.AXIS_WRITERS:
            raise Refused(f"--through has no meaning for {arguments.to}", "--through", "Leave it out.")
        options["through"] = arguments.through
    if arguments.positions is not None:
        if arguments.to == "fcm":
            raise Refused("--positions has no meaning for fcm", "--positions", "Leave it out.")
        options["positions"] = readings_csv.load_positions(arguments.positions)
    machine = common.load_machine(arguments.machine)
    written = convert.convert(machine, arguments.to, arguments.out, **options)
    for note in written.notes:
        common.say(note)
    return common.say_paths(Path(arguments.out) / name for name in [*written.files, "statement.txt"])
