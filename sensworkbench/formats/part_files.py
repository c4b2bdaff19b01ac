# SPDX-License-Identifier: LGPL-2.1-or-later
"""A part study from its files to its files: path, features and conditions are read, results are written as one set."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from sensworkbench.closedloop.readings import Readings
from sensworkbench.core.contact import Cutter, Face
from sensworkbench.core.machine import Machine
from sensworkbench.core.refusal import Refused
from sensworkbench.core.toolpath import STEP_MM, ToolPath
from sensworkbench.core.units import mm, um
from sensworkbench.messages import Message
from sensworkbench.studies.part import FeatureRequest, PartRequest, PartResult, features_on, part_study
from sensworkbench.studies.part_correct import (
    LIMIT_MM,
    TOLERANCE_MM,
    Correction,
    correction,
    known_uncertainty,
    value_under,
)
from sensworkbench.studies.part_faces import Faced, on_faces
from sensworkbench.studies.part_path import RAPID_MM_MIN, Conditions, of_moves, of_points
from sensworkbench.studies.remaining import remaining

from . import csv_table, features_json, gcode, json_text, part_json, path_csv, study_files
from .exchange import known
from .exchange.base import AxisTables, Components
from .file_sets import staged_file
from .files import write_bytes

NAMES = ("part.json", "features.csv", "points.csv", "report.html")
TABLES = (".csv", ".tsv", ".txt")
MOST_TABLED = 3000  # points at which tables of controllers are judged


@dataclass(frozen=True)
class Options:
    """What the command line says; texts as they are written there.  features, conditions : files, or None."""

    features: str | None = None
    conditions: str | None = None
    held: tuple[str, ...] = ()
    limits: tuple[str, ...] = ()
    offsets: tuple[str, ...] = ()
    tools: tuple[str, ...] = ()
    step: float = STEP_MM
    errors: str | None = None
    rapid: float = RAPID_MM_MIN
    correct: str | None = None
    correct_tolerance: float = TOLERANCE_MM
    correct_limit: float = LIMIT_MM


@dataclass(frozen=True)
class Job:
    """Everything a part study needs.  program : of a G-code path, else None.  source : for part.json.  faced : the
    faces of a solid that the path cuts; assign : a path -> the same with its points on these faces."""

    machine: Machine
    path: ToolPath
    request: PartRequest
    conditions: Conditions
    options: Options
    program: gcode.Program | None = None
    source: dict = field(default_factory=dict)
    faced: Faced | None = None
    assign: Callable[[ToolPath], ToolPath] | None = None


@dataclass(frozen=True)
class Given:
    """A program from a document.  data : its bytes.  offset : of G54 per joint, or None.  tools : number -> Tool.

    faces : of the solid that is made, in the coordinates of the program.  cutters : tool number -> its shape.
    """

    data: bytes
    offset: tuple[float, ...] | None = None
    tools: Mapping[int, gcode.Tool] = field(default_factory=dict)
    faces: tuple[Face, ...] = ()
    cutters: Mapping[int, Cutter] = field(default_factory=dict)


def read(
    machine: Machine,
    path,
    options: Options = Options(),
    given: Given | None = None,
    progress: Callable[[float], bool] | None = None,
) -> Job:
    """The job of the files that are named; refuses what cannot be understood.  given : in place of the path's file.

    progress : called with the part done of the search for faces; a false answer cancels.
    """
    joints = machine.joints
    file = features_json.load(options.features, joints) if options.features else features_json.FeatureFile()
    conditions = path_csv.load_conditions(options.conditions, joints) if options.conditions else Conditions()
    held = dict(path_csv.held(text, joints) for text in options.held)
    conditions = replace(conditions, held=held)
    limits = [_limit(text) for text in options.limits]
    source: dict = {"path": Path(path).name}
    faced = assign = None
    if Path(path).suffix.lower() in TABLES:
        points = path_csv.load(path, joints)
        features, labels = features_json.of_points(file, points.labels, points.features, points.positions.line)
        made, program = of_points(machine, points.positions, points.normal, labels, conditions), None
        source["remarks"] = [f.message for f in points.positions.remarks if not isinstance(f.message, str)]
    else:
        offsets = dict(_offset(text, joints) for text in options.offsets)
        tools = dict(_tool(text) for text in options.tools)
        if given is None:
            program = gcode.load(path, joints, features_json.settings_for(file, offsets, tools))
        else:
            known = {} if given.offset is None else {"G54": given.offset}
            file = replace(file, offsets=known | dict(file.offsets), tools=dict(given.tools) | dict(file.tools))
            settings = features_json.settings_for(file, offsets, tools)
            program = gcode.loads(given.data, Path(path).name, joints, settings)
        features, rows = features_json.of_program(program, file)
        made, step = of_moves(machine, program.moves, conditions, rows, options.step, rapid=options.rapid)
        source |= {"unread_words": program.unread, "assumed": program.assumed, "remarks": program.remarks}
        source["settings"] = {"step_mm": part_json.number(step), "rapid_mm_min": options.rapid}
        if given is not None and given.faces:
            cutters = _cutters(given, program, settings.tools)

            def faced_of(one: ToolPath, progress=None) -> Faced:
                xyz = program.moves.xyz
                return on_faces(machine, one, given.faces, cutters, program.tool[one.move], xyz, progress=progress)

            faced = faced_of(made, progress)
            made, assign = faced.path, lambda one: faced_of(one).path
            features = features or faced.features
            source["remarks"] = [*program.remarks, *faced.remarks]
    request = PartRequest(_limited(features, limits), errors=options.errors)
    return Job(machine, made, request, conditions, options, program, source, faced, assign)


def _cutters(given: Given, program: gcode.Program, tools: Mapping[int, gcode.Tool]) -> dict[int, Cutter]:
    """Tool number -> its shape: of the document, unless the features file or the command line states a radius."""
    found = dict(given.cutters)
    for number, tool in tools.items():
        if tool.radius and tool != given.tools.get(number):
            old = given.cutters.get(number, Cutter(tool.radius))
            corner = tool.radius if tool.ball else min(old.corner, tool.radius)
            found[number] = Cutter(tool.radius, corner, old.drill)
    used = set(program.tool.tolist())
    return {number: cutter for number, cutter in found.items() if number in used}


def _limited(features, limits) -> tuple[FeatureRequest, ...]:
    """The features with the limits of the command line: of all, then of single ones."""
    found = list(features)
    for name, limit in sorted(limits, key=lambda pair: pair[0] is not None):
        if name is not None and not found:
            raise Refused("feature-none", "--limit", name=json_text.short(name))
        if name is not None and all(f.name != name for f in found):
            raise Refused("feature-unknown", "--limit", name=json_text.short(name), known=[f.name for f in found][:20])
        found = [replace(f, limit=limit) if name in (None, f.name) else f for f in found]
    return tuple(found)


def _numbers(text: str, where: str, count: int) -> list[float]:
    parts = text.split(",")
    if len(parts) != count or not all(csv_table.is_number(p.strip()) and np.isfinite(float(p)) for p in parts):
        raise Refused("part-option-numbers", where, text=text[:60], count=count)
    return [float(p) for p in parts]


def _limit(text: str) -> tuple[str | None, float]:
    name, sign, number = text.rpartition("=")
    value = _numbers(number, f"--limit {text[:60]}", 1)[0]
    if not 0 < value < 1e9:
        raise Refused("feature-limit", f"--limit {text[:60]}", limit=value)
    return (name if sign else None), mm(value)


def _offset(text: str, joints) -> tuple[str, tuple[float, ...]]:
    system, _, rest = text.partition("=")
    where = f"--work-offset {text[:60]}"
    if system.upper() not in features_json.SYSTEMS:
        raise Refused("part-option-system", where, known=list(features_json.SYSTEMS))
    values = _numbers(rest, where, len(joints))
    return system.upper(), tuple(float(j.from_shown(v)) for j, v in zip(joints, values))


def _tool(text: str) -> tuple[int, gcode.Tool]:
    number, _, rest = text.partition("=")
    where = f"--tool {text[:60]}"
    length, radius = _numbers(rest, where, 2)
    if not (number.isascii() and number.isdigit() and len(number) < 7):
        raise Refused("features-tool-number", where, number=json_text.short(number))
    if radius < 0 or max(radius, abs(length)) > 1e4:
        raise Refused("features-tool-size", where, key="radius", value=radius)
    return int(number), gcode.Tool(length, radius)


def judged(job: Job, progress=None) -> PartResult:
    """The outcome of a job."""
    return part_study(job.machine, job.path, job.request, progress)


def outside_words(result: PartResult) -> str:
    """In English, how many blocks leave the travel, and by how much the first one does."""
    first = result.outside[0]
    fields = {"line": first.line, "joint": first.joint, "by": first.by, "unit": result.machine.joint(first.joint).unit}
    return Message("part-outside-some", count=len({o.line for o in result.outside}), **fields).text()


def correction_of(job: Job) -> Correction:
    """The correction of a job's program; refuses points in place of a program, and tolerances in place of errors."""
    if job.program is None:
        raise Refused("part-correct-table", "--correct")
    if job.options.errors == "tolerances":
        raise Refused("part-correct-errors", "--correct")
    program, path, options = job.program, job.path, job.options
    of_faces = () if job.faced is None else [f.name for f in job.faced.faces]
    labels = {name: np.unique(path.move[rows]) for name, rows in path.labels.items() if name not in of_faces}
    sizes = options.correct_tolerance, options.correct_limit
    return correction(
        job.machine, program.moves, gcode.kept(program), job.conditions, *sizes, labels, options.rapid, job.assign
    )


def corrected(job: Job) -> tuple[bytes, dict]:
    """(the corrected program, what part.json says of it)."""
    found, program, options = correction_of(job), job.program, job.options
    stays, cuts = gcode.kept(program), found.path.cutting
    rms = lambda e: part_json.number(um(np.sqrt((e[cuts] ** 2).sum(axis=1).mean())))  # noqa: E731
    features, uncertainty = [], known_uncertainty(job.machine, job.path)
    for f in features_on(job.machine, found.path, job.request.features):
        sizes = [part_json.number(um(value_under(f, found.path, e))) for e in (found.before, found.after)]
        features.append({"name": f.name, "before_um": sizes[0], "after_um": sizes[1]})
    said = {
        "file": Path(options.correct or "").name,
        "tolerance_um": part_json.number(um(options.correct_tolerance)),
        "limit_um": part_json.number(um(options.correct_limit)),
        "blocks": len(np.unique(program.moves.block[~stays])),
        "segments": found.pieces,
        "largest_um": part_json.number(um(found.largest)),
        "clipped": found.clipped,
        "before_um": rms(found.before),
        "after_um": rms(found.after),
        "uncertainty_um": None if uncertainty is None else part_json.number(um(uncertainty)),
        "tables": _tables(job),
        "features": features,
    }
    return gcode.written(program, found.points), said


def _tables(job: Job) -> list[dict]:
    """What the tables of each controller would leave at the cutting points, as rms beside a constant shift."""
    path = job.path
    rows = np.flatnonzero(path.cutting)
    rows = rows[np.unique(np.linspace(0, len(rows) - 1, MOST_TABLED).astype(int))]
    columns = {name: values[rows] for name, values in path.columns.items()}
    none = np.full((len(rows), 3), np.nan)
    places = Readings.from_vectors(path.q[rows], none, columns, tool_offset=path.contact[rows])
    found = []
    for name in known.names():
        form = known.get(name)
        if not (form.writes and isinstance(form, (AxisTables, Components))):
            continue
        try:
            left = remaining(job.machine, form, places)
        except Refused:
            continue
        found.append({"format": name, "before_um": part_json.number(left.rms_before_um),
                      "after_um": part_json.number(left.rms_after_um)})  # fmt: skip
    return found


def files(
    job: Job,
    result: PartResult,
    language: str = "en",
    correction: dict | None = None,
    picture: bytes | None = None,
    motion: Sequence[bytes] = (),
) -> dict:
    """Name -> text of the files of a part.  picture : PNG of the part in the window; motion : GIF, or PNG stills."""
    from . import part_html

    source = job.source if correction is None else job.source | {"correction": correction}
    data = part_json.to_dict(result, source)
    return {
        "part.json": json_text.dumps(data),
        "features.csv": part_json.features_csv(data),
        "points.csv": part_json.points_csv(result),
        "report.html": part_html.part_report(data, result, language, picture, motion),
    }


def write(folder, job: Job, result: PartResult, language: str = "en") -> list[Path]:
    """Write the files of a part as one set, and the corrected program where one is asked for; returns their paths."""
    if job.options.correct is None:
        return study_files.write_set(folder, "part", files(job, result, language))
    program, said = corrected(job)
    target, made = Path(job.options.correct), files(job, result, language, said)
    if target.parent.resolve() == Path(folder).resolve():
        return study_files.write_set(folder, "part", made | {target.name: program})
    with staged_file(target, "part --correct") as work:
        write_bytes(work, program)
        paths = study_files.write_set(folder, "part", made)
    return [*paths, target]
