# SPDX-License-Identifier: LGPL-2.1-or-later
"""`convert MACHINE --to FORMAT --out DIR`: fitted errors into the tables of a controller."""

from __future__ import annotations

from pathlib import Path

from sensworkbench.messages import Refused

from .. import common

HELP = "fitted errors into the tables of a controller"
FILES = "tables, `statement.txt`"


def add(parser) -> None:
    text = "machine.json with fitted errors, or an .FCStd document that holds one"
    common.add_machine(parser, help=text)
    parser.add_argument("--to", metavar="FORMAT", required=True, help=common.format_names())
    parser.add_argument("--out", metavar="DIR", required=True, help="folder for the tables and statement.txt")
    text = "axis tables hold the error on lines through this, a value per joint, mm or deg (middle)"
    parser.add_argument("--through", metavar="X,Y,Z", type=common.numbers, help=text)
    text = "places and conditions for the predicted error (default: the workspace)"
    parser.add_argument("--positions", metavar="CSV", help=text)
    common.add_language(parser, "statement.txt")


def run(arguments) -> int:
    from sensworkbench.formats import readings_csv
    from sensworkbench.formats.exchange import convert, known

    form = known.get(arguments.to, "--to")
    options = {}
    for name, taken in (("through", form.takes_through), ("positions", form.takes_positions)):
        if getattr(arguments, name) is not None and not taken:
            raise Refused("option-without-meaning", f"--{name}", option=f"--{name}", format=form.name)
    machine = common.load_machine(arguments.machine)
    if arguments.through is not None:
        values = arguments.through
        if len(values) == len(machine.joints):
            values = tuple(j.from_shown(v) for j, v in zip(machine.joints, values))
        options["through"] = values
    if arguments.positions is not None:
        options["positions"] = readings_csv.load_positions(arguments.positions, joints=machine.joints)
    written = convert.convert(machine, form.name, arguments.out, language=arguments.language, **options)
    for note in written.notes:
        common.say(note.text())
    return common.say_paths(Path(arguments.out) / name for name in [*written.files, convert.STATEMENT])
