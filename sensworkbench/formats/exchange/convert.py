# SPDX-License-Identifier: LGPL-2.1-or-later
"""One call per direction: a machine's errors into the files of another system with a statement of what they cannot
hold, and tables of another system into a machine.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from sensworkbench.closedloop.readings import Finding, Readings
from sensworkbench.core.machine import Machine
from sensworkbench.core.refusal import Refused

from ..file_sets import staged
from ..files import read_text, write_text
from . import etalon, fcm, heidenhain, isg, linuxcnc, siemens
from .axis_tables import axis_tables
from .coverage import FORMATS, Coverage, after_compensation, expressible
from .remaining import Remaining, remaining
from .tables import Approximation, Convention, merged, sampled, to_machine

__all__ = [
    "FORMATS_OUT", "FORMATS_IN", "Written", "convert", "write", "statement", "import_errors", "import_machine",
    "expressible", "after_compensation", "remaining",
]  # fmt: skip

FORMATS_OUT = (*FORMATS, "fcm")
FORMATS_IN = ("isg", "etalon", "fcm")
AXIS_WRITERS = {"linuxcnc": linuxcnc, "heidenhain": heidenhain, "siemens": siemens}
SIGNS = {
    "isg": "Values are errors (actual - nominal, tool relative to workpiece) in mm and rad; the controller subtracts "
    "them. It corrects the tool's position, not its orientation.",
    "etalon": "Values are errors (actual - nominal, tool relative to workpiece) in mm and rad.",
    "linuxcnc": "mm. Type 0 states actual positions, nominal + error; type 1 states trims, -error. BACKLASH of these "
    "joints is ignored by the controller.",
    "heidenhain": "Values are errors in mm, positive where the travel is too long; BACKLASH is the own axis's error in "
    "the negative direction. The sign was read from a manual, not tried on a controller: check one point.",
    "siemens": "Values are errors in mm: a positive value moves the axis in the negative direction (ENC_COMP, from the "
    "function manual). The same sign is assumed for CEC and was not confirmed: check one point.",
}


@dataclass(frozen=True)
class Written:
    """files : name -> text.  coverage : None for fcm.  notes : sentences about this conversion.  tables : of axes."""

    format: str
    files: dict[str, str]
    coverage: Coverage | None
    notes: tuple[str, ...] = field(default=())
    tables: dict | None = None


def write(machine: Machine, fmt: str, **options) -> Written:
    """Return the files of format `fmt` as texts.

    Options: linuxcnc file_type; heidenhain style; siemens axis_names, measuring_system, reference, cec_sign; fcm base
    (text of a file of which everything else is kept).  Axis tables take `through`: with a position, (x, y, z) mm or
    "middle" of the travel (the default), they hold the whole error along the lines of the axes through it; with None
    they hold only the translations of the model.  Lines are the better choice: they do not depend on how a fit divided
    an error between a translation and a rotation that the readings could not distinguish.
    """
    if fmt == "fcm":
        notes = tuple(f"Not held: {what}." for what in fcm.lost(machine))
        return Written(fmt, {"machine.fcm": fcm.dumps(machine, **options)}, None, notes)
    if fmt not in FORMATS:
        raise Refused(f"unknown format {fmt!r}", "format", f"Use one of {', '.join(FORMATS_OUT)}.")
    through = _position(machine, options.pop("through", "middle")) if fmt in AXIS_WRITERS else None
    coverage = expressible(machine, fmt, through)
    tables = axis_tables(machine, coverage, AXIS_WRITERS[fmt].LIMIT, through) if fmt in AXIS_WRITERS else None
    if not tables and not (tables is None and (coverage.symbols or coverage.effects)):
        why = f"; {coverage.missing[0][0]}: {coverage.missing[0][1]}" if coverage.missing else ""
        do = "Fit readings first (trace), or choose another format."
        raise Refused(f"nothing in this machine can be written as {FORMATS[fmt]}{why}", machine.name, do)
    notes = [SIGNS[fmt]]
    if fmt in AXIS_WRITERS:
        files = AXIS_WRITERS[fmt].files(tables, **options)
        for (source, output), t in tables.items():
            text = f"{output} by {source}: {len(t.position)} points every {t.position[1] - t.position[0]:g} mm"
            notes.append(f"{text}, interpolation error {t.interpolation * 1e3:.3f} um.")
    else:
        parametric = sampled(machine, coverage)
        module = {"isg": isg, "etalon": etalon}[fmt]
        name = "errors_isg.csv" if fmt == "isg" else "errors_etalon.txt"
        files = {name: module.dumps(parametric, f"machine {_line(machine.name)}", **options)}
        records = sum(len(t.values) for t in parametric.tables)
        notes.append(
            f"{len(parametric.tables)} tables with {records} values, and {len(parametric.constants)} constants."
        )
        for t in parametric.tables:
            if t.interpolation > (2e-7 if t.symbol[1] in "ABC0" else 2e-4):
                unit = "urad" if t.symbol[1] in "ABC0" else "um"
                size = t.interpolation * (1e6 if unit == "urad" else 1e3)
                notes.append(f"{t.symbol}: interpolation error {size:.3f} {unit}.")
    if machine.squareness == "carried":
        notes.append("Squareness carried to later links is written as tilt of direction plus constant rotations.")
    if machine.fitted is not None and machine.fitted.alignment:
        notes.append("The alignment of the measuring set-up is not part of the tables.")
    return Written(fmt, files, coverage, tuple(notes), tables)


def _position(machine: Machine, through) -> tuple[float, float, float] | None:
    if through is None:
        return None
    if through == "middle":
        return tuple(float(v) for v in machine.travel.mean(axis=1))
    try:
        x, y, z = (float(v) for v in through)
    except (TypeError, ValueError):
        raise Refused(f"{through!r} is no position", "through", 'Give x, y, z in mm, or "middle".') from None
    return x, y, z


def _line(text: str) -> str:
    return " ".join(text.split())


def statement(machine: Machine, written: Written, positions: Readings | None = None) -> str:
    """What the files hold and what they do not, in words, with the predicted error at `positions` (default: the
    workspace, whose grid knows no temperature, time or load)."""
    title = FORMATS.get(written.format, "FreeCAD CAM machine")
    lines = [f"{title}, from machine {_line(machine.name)} ({machine.structure})", ""]
    c = written.coverage
    if c is not None:
        lines += ["Covered errors: " + (", ".join(c.symbols) or "none")]
        lines += ["Covered effects: " + (", ".join(c.effects) or "none")]
        lines += ["", "Not covered:" if c.missing else "Everything is covered."]
        reasons = dict.fromkeys(why for _, why in c.missing)
        lines += [f"  {', '.join(n for n, w in c.missing if w == why)}: {why}." for why in reasons]
        figures = remaining(machine, written.format, positions, written.tables)
        lines += ["", *_figures(figures, positions), ""]
    return "\n".join([*lines, *written.notes]) + "\n"


def _figures(r: Remaining, positions: Readings | None):
    workspace = "over the workspace, both directions of approach"
    where = workspace if positions is None else f"at the {positions.points} places given"
    part = "What positions alone decide of the predicted error" if r.left_out else "Predicted error"
    yield f"{part} {where} (length of the error vector about its mean):"
    yield f"  before compensation: rms {r.rms_before_um:.2f} um, largest {r.max_before_um:.2f} um"
    yield f"  after compensation:  rms {r.rms_after_um:.2f} um, largest {r.max_after_um:.2f} um"
    if r.left_out:
        yield "To both figures this adds, in full, before and after; how much depends on conditions that a grid of the"
        yield f"workspace does not know: {', '.join(r.left_out)}."
        yield "With --positions, a table of places and their conditions, it is in the figures."


def convert(machine: Machine, fmt: str, outdir, positions: Readings | None = None, **options) -> Written:
    """Write the files of `fmt` and `statement.txt` into `outdir`, all of them or none.

    positions : places and conditions at which the statement predicts the error that is left (default: the workspace).
    """
    written = write(machine, fmt, **options)
    said = statement(machine, written, positions)
    with staged(outdir, "convert") as folder:
        for name, text in written.files.items():
            write_text(folder / name, text)
        write_text(folder / "statement.txt", said)
    return written


def import_errors(
    machine: Machine, fmt: str, *paths, degree: int = 3, convention: Convention | None = None
) -> tuple[Machine, tuple[Approximation, ...], tuple[Finding, ...]]:
    """The machine with the error tables of ISG or Etalon files as its fitted errors; see `tables.to_machine`."""
    if fmt not in ("isg", "etalon"):
        raise Refused(f"error tables of format {fmt!r} cannot be read", "format", "Use isg or etalon.")
    module = isg if fmt == "isg" else etalon
    return to_machine(machine, merged([module.loads(read_text(p), str(p)) for p in paths]), degree, convention)


def import_machine(path, tool_point=(0.0, 0.0, 0.0)) -> tuple[Machine, tuple[Finding, ...]]:
    """The machine of a FreeCAD CAM machine file."""
    return fcm.loads(read_text(path), str(Path(path)), tool_point)
