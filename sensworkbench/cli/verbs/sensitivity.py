# SPDX-License-Identifier: LGPL-2.1-or-later
"""`sensitivity MACHINE --out DIR`: exact indices of every error and component."""

from __future__ import annotations

from .. import common

HELP = "exact sensitivity indices of every error and component"
FILES = "`sensitivity.json`, `.csv`, `report.html`"
OPTIONS = ("at", "grid", "quadrature", "weights", "output", "signed", "squareness", "tolerances", "angle_unit")


def add(parser) -> None:
    common.add_machine(parser)
    parser.add_argument("--out", metavar="DIR", required=True, help="folder for sensitivity.json, .csv and report.html")
    where = parser.add_mutually_exclusive_group()
    where.add_argument("--at", metavar="X,Y,Z", type=common.triple, help="at one position, mm")
    text = "mean over a grid of N (or NX,NY,NZ) positions per axis"
    where.add_argument("--grid", metavar="N", type=common.counts, help=text)
    text = "mean by Gauss-Legendre quadrature (default, 8)"
    where.add_argument("--quadrature", metavar="N", type=common.counts, help=text)
    text = "weights of the three components (default 1,1,1)"
    parser.add_argument("--weights", metavar="WX,WY,WZ", type=common.triple, help=text)
    text = "what is judged (default: position)"
    parser.add_argument("--output", choices=("position", "orientation"), help=text)
    text = "the weighted sum of the components instead of their squares"
    parser.add_argument("--signed", action="store_true", help=text)
    text = "convention, in place of the machine's own"
    parser.add_argument("--squareness", choices=("direction", "carried"), help=text)
    text = "tolerances (.csv or .json) in place of the machine's own"
    parser.add_argument("--tolerances", metavar="FILE", help=text)
    text = "unit of angles in the results"
    parser.add_argument("--angle-unit", choices=("urad", "arcsec"), default="urad", help=text)
    parser.add_argument("--picture", metavar="PNG", help="picture of the machine for the report")


def run(arguments) -> int:
    from sensworkbench.formats import machine_json, runs

    picture = runs.read_picture(arguments.picture) if arguments.picture else None
    options = runs.Options(**{n: getattr(arguments, n) for n in OPTIONS})
    if common.is_document(arguments.machine):
        paths = common.batch().sensitivity(arguments.machine, arguments.out, options, picture)
    else:
        machine, result = runs.compute(machine_json.load(arguments.machine), options)
        paths = runs.write(arguments.out, machine, result, arguments.angle_unit, picture)
    return common.say_paths(paths)
