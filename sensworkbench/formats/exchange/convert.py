# SPDX-License-Identifier: LGPL-2.1-or-later
"""One call per direction: a machine's errors into the files of another system with a statement of what they cannot
hold, and tables of another system into a machine.  Formats are named as in `known.names()`.
"""

from __future__ import annotations

from pathlib import Path

from sensworkbench.closedloop.readings import Readings, Remark
from sensworkbench.core.machine import Machine
from sensworkbench.messages import LANGUAGES, Message, Refused
from sensworkbench.studies import coverage, remaining
from sensworkbench.studies.error_tables import Approximation, Convention, merged, to_machine

from ..files import read_text
from ..study_files import write_set
from ..words import Words
from . import known
from .base import Written, line

STATEMENT = "statement.txt"


def write(machine: Machine, name: str, **options) -> Written:
    """The files of a machine in the format `name`, as texts.

    Options: through (formats of axis tables; see `base.AxisTables.write`); linuxcnc file_type; heidenhain style;
    siemens axis_names, measuring_system, reference, cec_sign; fcm base (text of a file to keep the rest of).
    """
    return known.get(name).write(machine, **options)


def expressible(machine: Machine, name: str, through=None) -> coverage.Coverage:
    """What the format `name` can hold of the fitted errors and effects, and the reasons for the rest."""
    return coverage.expressible(machine, known.get(name), through)


def after_compensation(machine: Machine, name: str) -> Machine:
    """The machine that is left when a controller applies the tables of the format `name`."""
    return coverage.after_compensation(machine, known.get(name))


def statement(machine: Machine, written: Written, positions: Readings | None = None, language: str = "en") -> str:
    """What the files hold and what they do not, in words, with the predicted error at `positions` (default: the
    workspace, whose grid knows no temperature, time or load)."""
    words = Words(language)
    title, c = written.format.title, written.coverage
    lines = [words("statement-title", title=title, machine=line(machine.name), structure=machine.structure), ""]
    if c is not None:
        none = words("statement-none")
        lines.append(words("statement-errors", symbols=", ".join(c.symbols) or none))
        lines.append(words("statement-effects", names=", ".join(c.effects) or none))
        lines += ["", words("statement-missing") if c.missing else words("statement-all")]
        reasons = dict.fromkeys(why for _, why in c.missing)
        lines += [f"  {', '.join(n for n, w in c.missing if w == why)}: {words.of(why)}." for why in reasons]
        figures = remaining.remaining(machine, written.format, positions, written.tables)
        lines += ["", *_figures(words, figures, positions), ""]
    return "\n".join([*lines, *map(words.of, written.notes)]) + "\n"


def _figures(words: Words, r: remaining.Remaining, positions: Readings | None):
    where = Message("statement-workspace") if positions is None else Message("statement-places", count=positions.points)
    yield words("statement-part" if r.left_out else "statement-predicted", where=where)
    yield "  " + words("statement-before", rms=r.rms_before_um, largest=r.max_before_um)
    yield "  " + words("statement-after", rms=r.rms_after_um, largest=r.max_after_um)
    if r.left_out:
        yield words("statement-left-out", names=list(r.left_out))


def convert(
    machine: Machine, name: str, outdir, positions: Readings | None = None, language: str = "en", **options
) -> Written:
    """Write the files of the format `name` and `statement.txt` into `outdir`, all of them or none.

    positions : places and conditions at which the statement predicts the error that is left (default: the workspace).
    Files of an earlier conversion to this folder that the new one lacks are removed.
    """
    if language not in LANGUAGES:
        raise Refused("language-unknown", "--language", language=repr(language)[:60], known=list(LANGUAGES))
    written = write(machine, name, **options)
    files = dict(written.files) | {STATEMENT: statement(machine, written, positions, language)}
    write_set(outdir, "convert", files)
    return written


def import_errors(
    machine: Machine, name: str, *paths, degree: int = 3, convention: Convention | None = None
) -> tuple[Machine, tuple[Approximation, ...], tuple[Remark, ...]]:
    """The machine with the error tables of files as its fitted errors; see `error_tables.to_machine`."""
    found = known.get(name, "--from")
    if not found.reads_errors:
        raise Refused("format-not-read", "--from", title=found.title)
    tables = merged([found.read(read_text(p), str(p)) for p in paths])
    return to_machine(machine, tables, degree, convention)


def import_machine(path, tool_point=(0.0, 0.0, 0.0), name: str = "fcm") -> tuple[Machine, tuple[Remark, ...]]:
    """The machine of a machine file of another system."""
    return known.get(name).read_machine(read_text(path), str(Path(path)), tool_point)
