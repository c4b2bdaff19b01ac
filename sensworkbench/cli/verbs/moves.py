# SPDX-License-Identifier: LGPL-2.1-or-later
"""`moves MACHINE --out DIR`: where a scale, a guide or the tool should be, and in which order the axes."""

from __future__ import annotations

from .. import common

HELP = "where to move scales and guides, and the best order of the axes"
FILES = "`moves.json`, `moves.csv`, `report.html`"


def add(parser) -> None:
    common.add_machine(parser)
    common.add_out(parser)
    text = "how far each point may be moved: along x, y and z alike, or X,Y,Z (default 50)"
    parser.add_argument("--within", metavar="MM", type=common.box, default=50.0, help=text)
    text = "what each tolerance costs, as for allocate: moves are then worth money too"
    parser.add_argument("--costs", metavar="COSTS.csv", help=text)
    common.add_language(parser)


def run(arguments) -> int:
    from sensworkbench.formats import costs_csv, moves_json
    from sensworkbench.studies.moves import moves_study

    machine = common.load_machine(arguments.machine)
    costs = costs_csv.load(arguments.costs, machine) if arguments.costs else None
    result = moves_study(machine, arguments.within, costs)
    return common.write_study(arguments, "moves", moves_json.files(result, arguments.language))
