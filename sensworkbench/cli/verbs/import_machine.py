# SPDX-License-Identifier: LGPL-2.1-or-later
"""`import-machine MACHINE.fcm --out FILE`: a machine file of FreeCAD's CAM workbench into machine.json."""

from __future__ import annotations

from .. import common

HELP = "a FreeCAD CAM machine file into machine.json"
FILES = "`machine.json`"


def add(parser) -> None:
    parser.add_argument("source", metavar="MACHINE.fcm", help="a machine file of FreeCAD's CAM workbench")
    text = "mm (default 0,0,0)"
    parser.add_argument("--tool-point", metavar="X,Y,Z", type=common.triple, default=(0.0, 0.0, 0.0), help=text)
    parser.add_argument("--out", metavar="FILE", required=True, help="the machine.json")


def run(arguments) -> int:
    from sensworkbench.formats import machine_json
    from sensworkbench.formats.exchange import convert
    from sensworkbench.formats.file_sets import staged_file

    machine, remarks = convert.import_machine(arguments.source, arguments.tool_point)
    common.keep_inputs(arguments.out, arguments.source)
    with staged_file(arguments.out) as work:
        machine_json.save(machine, work)
    for finding in remarks:
        common.say(f"{finding.severity}: {finding.message}")
    return common.say_paths([arguments.out])
