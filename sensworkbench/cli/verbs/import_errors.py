# SPDX-License-Identifier: LGPL-2.1-or-later
"""`import-errors MACHINE TABLE ... --from FORMAT --out FILE`: error tables of a controller into a machine."""

from __future__ import annotations

from .. import common

HELP = "error tables of a controller into a machine"
FILES = "`machine.json`"


def add(parser) -> None:
    parser.add_argument("machine", metavar="MACHINE", help="machine.json whose errors the tables state")
    parser.add_argument("tables", metavar="TABLE", nargs="+", help="one or more files")
    parser.add_argument("--from", metavar="FORMAT", dest="source", required=True, help=common.format_names())
    parser.add_argument("--out", metavar="FILE", required=True, help="the machine.json with these fitted errors")
    text = "of the fitted functions (default 3)"
    parser.add_argument("--degree", metavar="N", type=common.whole, default=3, help=text)


def run(arguments) -> int:
    from sensworkbench.formats import machine_json
    from sensworkbench.formats.exchange import convert
    from sensworkbench.formats.file_sets import staged_file

    machine = machine_json.load(arguments.machine)
    found, quality, remarks = convert.import_errors(
        machine, arguments.source, *arguments.tables, degree=arguments.degree
    )
    common.keep_inputs(arguments.out, arguments.machine, *arguments.tables)
    with staged_file(arguments.out) as work:
        machine_json.save(found, work)
    for finding in remarks:
        common.say(f"{finding.severity}: {finding.message}")
    for table in quality:
        size = f"{table.rms:.3f} {table.unit} rms, {table.largest:.3f} at most"
        common.say(f"{table.symbol}: differs from the table by {size}")
    return common.say_paths([arguments.out])
