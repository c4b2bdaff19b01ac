# SPDX-License-Identifier: LGPL-2.1-or-later
"""`part MACHINE PATH --out DIR`: what a part will look like, and which component makes it so."""

from __future__ import annotations

from sensworkbench.core.refusal import Refused

from .. import common

HELP = "what a part will look like, and which component makes it so"
FILES = "`part.json`, `features.csv`, `points.csv`, `report.html`; a corrected program"


def add(parser) -> None:
    common.add_machine(parser)
    text = "the tool path: a G-code program, a table (.csv) of points, or a document with a CAM job (default: MACHINE)"
    parser.add_argument("path", metavar="PATH", nargs="?", default="", help=text)
    parser.set_defaults(documents=(*parser.get_default("documents"), "path"))
    parser.add_argument("--out", metavar="DIR", required=True, help="folder for the results")
    text = "label of the solid that is made, in the document (default: the model of the job): its faces become features"
    parser.add_argument("--model", metavar="LABEL", default="", help=text)
    parser.add_argument("--features", metavar="FILE", help="features.json: features, work offsets, tools")
    parser.add_argument("--conditions", metavar="FILE", help="table of conditions along the path")
    text = "a condition that keeps one value, such as temp_column_C=24"
    parser.add_argument("--hold", metavar="NAME=VALUE", action="append", default=[], help=text)
    text = "limit of the features, um, or of one, NAME=UM"
    parser.add_argument("--limit", metavar="UM", action="append", default=[], help=text)
    text = "work offset, a value per joint, mm or deg: G54=100,-50,0"
    parser.add_argument("--work-offset", metavar="G54=X,Y,Z", action="append", default=[], help=text)
    text = "length beyond the machine's tool point and radius of a tool, mm: 1=0,5"
    parser.add_argument("--tool", metavar="N=LENGTH,RADIUS", action="append", default=[], help=text)
    text = "distance of the points of a program, mm (default 1)"
    parser.add_argument("--step", metavar="MM", type=common.positive, default=1.0, help=text)
    text = "what the machine's errors are taken from (default: fitted, where anything is)"
    parser.add_argument("--errors", choices=("fitted", "tolerances"), help=text)
    text = "speed of rapids, mm/min, for the time (default 10000)"
    parser.add_argument("--rapid", metavar="MM_MIN", type=common.positive, default=10_000.0, help=text)
    text = "write the program with its points moved against the predicted error"
    parser.add_argument("--correct", metavar="OUT.nc", help=text)
    text = "largest shift of a point, um (default 100)"
    parser.add_argument("--correct-limit", metavar="UM", type=common.positive, default=100.0, help=text)
    text = "by which lines may miss arcs and the corrected path, um (default 0.2)"
    parser.add_argument("--correct-tolerance", metavar="UM", type=common.positive, default=0.2, help=text)
    common.add_language(parser)


def _of_document(arguments, machine):
    """The program of a document that was given as the path, or None."""
    if not common.is_document(arguments.path):
        if arguments.model:
            raise Refused("part-model-without-document", "--model")
        return None
    from sensworkbench.document import cam_path

    found = cam_path.load(arguments.path, arguments.model)
    together = common.is_document(arguments.machine) and common.same_file(arguments.machine, arguments.path)
    return cam_path.given(found, machine if together else None)


def run(arguments) -> int:
    import sys
    from pathlib import Path

    from sensworkbench.core.units import mm
    from sensworkbench.formats import part_files

    if not arguments.path and common.is_document(arguments.machine):
        arguments.path = arguments.machine
    if not arguments.path:
        raise Refused("part-no-path", "PATH")
    machine = common.load_machine(arguments.machine)
    folder = Path(arguments.out)
    given = [arguments.machine, arguments.path, arguments.features, arguments.conditions]
    for name in part_files.NAMES:
        common.keep_inputs(folder / name, *(g for g in given if g))
    if arguments.correct:
        common.keep_inputs(arguments.correct, *(g for g in given if g))
    options = part_files.Options(
        features=arguments.features,
        conditions=arguments.conditions,
        held=tuple(arguments.hold),
        limits=tuple(arguments.limit),
        offsets=tuple(arguments.work_offset),
        tools=tuple(arguments.tool),
        step=arguments.step,
        errors=arguments.errors,
        rapid=arguments.rapid,
        correct=arguments.correct,
        correct_tolerance=mm(arguments.correct_tolerance),
        correct_limit=mm(arguments.correct_limit),
    )
    try:
        job = part_files.read(machine, arguments.path, options, _of_document(arguments, machine))
        result = part_files.judged(job)
    except Refused as refused:
        raise (refused.at(arguments.path) if refused.where.startswith("line ") else refused) from None
    paths = part_files.write(folder, job, result, arguments.language)
    if result.outside:
        common.say(part_files.outside_words(result), sys.stderr)
    return common.say_paths(paths)
