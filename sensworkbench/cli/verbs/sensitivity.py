# SPDX-License-Identifier: LGPL-2.1-or-later
"""`sensitivity MACHINE --out DIR`: exact indices of every error and component."""

from __future__ import annotations

from .. import common

HELP = "exact sensitivity indices of every error and component"
FILES = "`sensitivity.json`, `.csv`, `report.html`"
OPTIONS = ("at", "grid", "quadrature", "low_discrepancy", "squareness")


def add(parser) -> None:
    common.add_machine(parser)
    parser.add_argument("--out", metavar="DIR", required=True, help="folder for sensitivity.json, .csv and report.html")
    where = parser.add_mutually_exclusive_group()
    text = "at one position: a value per joint in the order of the file, mm or deg"
    where.add_argument("--at", metavar="X,Y,Z", type=common.numbers, help=text)
    text = "mean over a grid of N (or NX,NY,NZ) positions per joint"
    where.add_argument("--grid", metavar="N", type=common.counts, help=text)
    text = "mean by Gauss-Legendre quadrature (default, 8)"
    where.add_argument("--quadrature", metavar="N", type=common.counts, help=text)
    text = "mean over a low-discrepancy set of N positions (default for six joints)"
    where.add_argument("--low-discrepancy", metavar="N", type=common.whole, help=text)
    text = "weights of the three components (default 1,1,1)"
    parser.add_argument("--weights", metavar="WX,WY,WZ", type=common.triple, help=text)
    text = "what is judged (default: position)"
    parser.add_argument("--output", choices=("position", "orientation"), help=text)
    text = "mean_square (default) or another objective by name; NAME:FIELD=NUMBER,... sets its fields"
    parser.add_argument("--objective", metavar="NAME", type=common.objective, default={}, help=text)
    text = "the weighted sum of the components instead of their squares: --objective signed"
    parser.add_argument("--signed", dest="objective", action="store_const", const={"name": "signed"}, help=text)
    text = "convention, in place of the machine's own"
    parser.add_argument("--squareness", choices=("direction", "carried"), help=text)
    text = "tolerances (.csv or .json) in place of the machine's own"
    parser.add_argument("--tolerances", metavar="FILE", help=text)
    text = "unit of angles in the results"
    parser.add_argument("--angle-unit", choices=("urad", "arcsec"), default="urad", help=text)
    common.add_language(parser)
    parser.add_argument("--picture", metavar="PNG", help="picture of the machine for the report")


def run(arguments) -> int:
    from sensworkbench.formats import machine_json, study_files, tolerances
    from sensworkbench.studies.sensitivity import SensitivityRequest, sensitivity_study

    picture = study_files.read_picture(arguments.picture) if arguments.picture else None
    given = tolerances.load(arguments.tolerances) if arguments.tolerances else None
    judged = dict(arguments.objective)
    judged |= {n: getattr(arguments, n) for n in ("weights", "output") if getattr(arguments, n) is not None}
    options = {n: getattr(arguments, n) for n in OPTIONS}
    request = SensitivityRequest(objective=judged, tolerances=given, **options)
    unit, language = arguments.angle_unit, arguments.language
    if common.is_document(arguments.machine):
        paths = common.batch().sensitivity(arguments.machine, arguments.out, request, unit, picture, language)
    else:
        study = sensitivity_study(machine_json.load(arguments.machine), request)
        for remark in study.remarks:
            common.say(f"warning: {remark.text()}")
        paths = study_files.write_sensitivity(arguments.out, study, unit, picture, language=language)
    return common.say_paths(paths)
