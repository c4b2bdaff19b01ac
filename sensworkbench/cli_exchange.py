# SPDX-License-Identifier: LGPL-2.1-or-later
"""The verbs of the command line that exchange files with other systems: convert, import-errors, import-machine.

Their rules are those of `cli`: files appear whole or not at all, and no input is ever overwritten.
"""

from __future__ import annotations

from pathlib import Path

from sensworkbench.core.refusal import Refused


def add(verbs, triple, whole) -> None:
    """Add these verbs to the grammar.  triple, whole : types of arguments, X,Y,Z and a whole number."""
    verb = verbs.add_parser("convert", help="fitted errors into the tables of a controller", allow_abbrev=False)
    verb.add_argument(
        "machine", metavar="MACHINE", help="machine.json with fitted errors, or an .FCStd document that holds one"
    )
    verb.add_argument("--to", metavar="FORMAT", required=True, help="isg, etalon, linuxcnc, heidenhain, siemens or fcm")
    verb.add_argument("--out", metavar="DIR", required=True, help="folder for the tables and statement.txt")
    verb.add_argument(
        "--through", metavar="X,Y,Z", type=triple, help="axis tables hold the error on lines through this (middle)"
    )
    verb.add_argument(
        "--positions", metavar="CSV", help="places and conditions for the predicted error (default: the workspace)"
    )
    verb.set_defaults(run=_convert)

    verb = verbs.add_parser("import-errors", help="error tables of a controller into a machine", allow_abbrev=False)
    verb.add_argument("machine", metavar="MACHINE", help="machine.json whose errors the tables state")
    verb.add_argument("tables", metavar="TABLE", nargs="+", help="one or more files")
    verb.add_argument("--from", metavar="FORMAT", dest="source", required=True, help="isg or etalon")
    verb.add_argument("--out", metavar="FILE", required=True, help="the machine.json with these fitted errors")
    verb.add_argument("--degree", metavar="N", type=whole, default=3, help="of the fitted functions (default 3)")
    verb.set_defaults(run=_import_errors)

    verb = verbs.add_parser("import-machine", help="a FreeCAD CAM machine file into machine.json", allow_abbrev=False)
    verb.add_argument("source", metavar="MACHINE.fcm", help="a machine file of FreeCAD's CAM workbench")
    verb.add_argument("--tool-point", metavar="X,Y,Z", type=triple, default=(0.0, 0.0, 0.0), help="mm (default 0,0,0)")
    verb.add_argument("--out", metavar="FILE", required=True, help="the machine.json")
    verb.set_defaults(run=_import_machine)


def _convert(arguments) -> int:
    from sensworkbench import cli

    if cli.is_document(arguments.machine) and not cli.in_freecad():
        return cli.hand_over(arguments)
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
    machine = cli.load_machine(arguments.machine)
    written = convert.convert(machine, arguments.to, arguments.out, **options)
    for note in written.notes:
        cli.say(note)
    for name in [*written.files, "statement.txt"]:
        cli.say(str(Path(arguments.out) / name))
    return cli.DONE


def _import_errors(arguments) -> int:
    from sensworkbench import cli
    from sensworkbench.formats import machine_json
    from sensworkbench.formats.exchange import convert

    machine = machine_json.load(arguments.machine)
    found, quality, findings = convert.import_errors(
        machine, arguments.source, *arguments.tables, degree=arguments.degree
    )
    cli.keep_inputs(arguments.out, arguments.machine, *arguments.tables)
    machine_json.save(found, arguments.out)
    for finding in findings:
        cli.say(f"{finding.severity}: {finding.message}")
    for table in quality:
        cli.say(
            f"{table.symbol}: differs from the table by {table.rms:.3f} {table.unit} rms, {table.largest:.3f} at most"
        )
    cli.say(str(arguments.out))
    return cli.DONE


def _import_machine(arguments) -> int:
    from sensworkbench import cli
    from sensworkbench.formats import machine_json
    from sensworkbench.formats.exchange import convert

    machine, findings = convert.import_machine(arguments.source, arguments.tool_point)
    cli.keep_inputs(arguments.out, arguments.source)
    machine_json.save(machine, arguments.out)
    for finding in findings:
        cli.say(f"{finding.severity}: {finding.message}")
    cli.say(str(arguments.out))
    return cli.DONE
