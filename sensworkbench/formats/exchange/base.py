# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a format is: its name, what it holds of a machine's errors, and how it is written and read.

Three kinds: tables that shift one axis by the position of one axis (`AxisTables`), tables of error components over
positions (`Components`), and files that describe a machine (`MachineFile`).  A new format is a module in `known`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from sensworkbench.closedloop.readings import Remark
from sensworkbench.core.errors import SQUARENESS, TRANSLATION
from sensworkbench.core.machine import Machine
from sensworkbench.core.units import um
from sensworkbench.messages import Message, Refused
from sensworkbench.studies.axis_tables import AxisTable, axis_tables
from sensworkbench.studies.coverage import Coverage, Item, expressible
from sensworkbench.studies.error_tables import ErrorTables, sampled


@dataclass(frozen=True)
class Written:
    """files : name -> text.  coverage : None of a machine file.  notes : about this conversion.  tables : of axes."""

    format: Format
    files: Mapping[str, str]
    coverage: Coverage | None = None
    notes: tuple[Message, ...] = ()
    tables: Mapping[tuple[str, str], AxisTable] | None = None


class Format:
    """Base of all formats.

    name : as in `--to`; that of the module.  title : what it is called, in English.  sign : code of the message about
    its signs ("" none).  writes, reads_errors, reads_machine : what it can do.  places : whether `through` and
    `positions` have a meaning for it.
    """

    name = ""
    title = ""
    sign = ""
    writes = False
    reads_errors = False
    reads_machine = False
    takes_through = False
    takes_positions = False

    def holds(self, item: Item) -> Message | None:
        """Why the format cannot hold an item; None where it can."""
        return Message("table-no-errors")

    def write(self, machine: Machine, **options) -> Written:
        """The files of a machine as texts; refuses where nothing of it can be held."""
        raise Refused("format-not-written", self.name, title=self.title)

    def read(self, text: str, source: str) -> ErrorTables:
        """The error tables in a text; refuses what is not this format, with the line."""
        raise Refused("format-not-read", self.name, title=self.title)

    def read_machine(self, text: str, source: str, tool_point) -> tuple[Machine, tuple[Remark, ...]]:
        """The machine in a text, and what it leaves open."""
        raise Refused("format-not-read", self.name, title=self.title)

    def _nothing(self, machine: Machine, coverage: Coverage) -> Refused:
        if not coverage.missing:
            return Refused("format-nothing-fitted", machine.name, title=self.title)
        name, why = coverage.missing[0]
        return Refused("format-holds-nothing", machine.name, title=self.title, name=name, why=why)


class AxisTables(Format):
    """Tables that shift one linear axis by the position of one linear axis.

    limit : points of a table.  A subclass gives `shifts` and `files`.
    """

    writes = takes_through = takes_positions = True
    limit = 256

    def shifts(self, source: str, output: str, reverses: bool) -> Message | None:
        """Why the controller has no table that shifts `output` by the position (and direction) of `source`."""
        return None

    def files(self, tables: Mapping[tuple[str, str], AxisTable], **options) -> dict[str, str]:
        """File name -> text of the tables (source axis, output axis) -> table."""
        raise NotImplementedError

    def holds(self, item: Item) -> Message | None:
        c = item.component
        if item.obstacle is not None:
            return item.obstacle
        if item.declared and c.kind == SQUARENESS:  # a tilt of one axis shifts the others by its position
            return self.shifts(c.body, "", False)
        if c.kind != TRANSLATION:
            return Message("table-no-rotation")
        if len(item.inputs) != 1:
            return Message("table-one-axis")
        return self.shifts(*item.inputs, item.output, bool(item.direction))

    def write(self, machine: Machine, through="middle", **options) -> Written:
        """The tables.  through : a value per joint, mm or rad, or "middle" of the travel: the tables hold the whole
        error along the lines of the axes through it; None: the translations of the model only.  Lines do not depend
        on how a fit shares an error between a translation and a rotation that the readings could not tell apart."""
        point = _position(machine, through)
        coverage = expressible(machine, self, point)
        tables = axis_tables(machine, coverage, self, point)
        if not tables:
            raise self._nothing(machine, coverage)
        files = self.files(tables, **options)
        notes = [Message(self.sign)] if self.sign else []
        for (source, output), t in tables.items():
            step, size = float(t.position[1] - t.position[0]), um(t.interpolation)
            count = len(t.position)
            notes.append(
                Message("note-axis-table", source=source, output=output, count=count, step=step, interpolation=size)
            )
        return Written(self, files, coverage, (*notes, *common_notes(machine)), tables)


class Components(Format):
    """Tables of error components over positions of the axes.  file : name of the file.  A subclass gives `dumps`."""

    writes = takes_positions = reads_errors = True
    file = ""

    def dumps(self, tables: ErrorTables, title: str) -> str:
        """The text of the tables."""
        raise NotImplementedError

    def holds(self, item: Item) -> Message | None:
        c = item.component
        if item.obstacle is not None:
            return item.obstacle
        if item.declared and c.kind == SQUARENESS:
            return None
        if item.direction:
            return Message("table-no-direction")
        return None

    def write(self, machine: Machine) -> Written:
        coverage = expressible(machine, self)
        if not coverage.symbols and not coverage.effects:
            raise self._nothing(machine, coverage)
        tables = sampled(machine, coverage)
        values = sum(len(t.values) for t in tables.tables)
        counts = {"tables": len(tables.tables), "values": values, "constants": len(tables.constants)}
        notes = [*([Message(self.sign)] if self.sign else []), Message("note-components", **counts)]
        for t in tables.tables:
            c = machine.component(t.symbol)
            size = c.to_shown(t.interpolation)
            if size > 0.2:
                notes.append(Message("note-interpolation", symbol=t.symbol, size=size, unit=c.unit))
        text = self.dumps(tables, f"machine {line(machine.name)}")
        return Written(self, {self.file: text}, coverage, (*notes, *common_notes(machine)))


class MachineFile(Format):
    """Files that describe a machine.  A subclass gives `machine_text`, `lost`, and `file`."""

    writes = True
    file = ""

    def machine_text(self, machine: Machine, **options) -> str:
        """The text of the machine."""
        raise NotImplementedError

    def lost(self, machine: Machine) -> tuple[Message, ...]:
        """What of the machine the file does not hold."""
        return ()

    def write(self, machine: Machine, **options) -> Written:
        notes = tuple(Message("note-not-held", what=what) for what in self.lost(machine))
        return Written(self, {self.file: self.machine_text(machine, **options)}, None, notes)


def common_notes(machine: Machine) -> list[Message]:
    """What is said of every table."""
    notes = []
    if machine.squareness == "carried":
        notes.append(Message("note-squareness-carried"))
    if machine.fitted is not None and machine.fitted.alignment:
        notes.append(Message("note-alignment"))
    return notes


def line(text: str) -> str:
    """A text on one line."""
    return " ".join(text.split())


def _position(machine: Machine, through) -> tuple[float, ...] | None:
    if through is None:
        return None
    if isinstance(through, str) and through == "middle":  # of linear joints; rotary ones stand at 0
        middle = machine.travel.mean(axis=1)
        return tuple(float(v) if j.slides else 0.0 for j, v in zip(machine.joints, middle))
    try:
        values = tuple(float(v) for v in through)
    except (TypeError, ValueError):
        values = ()
    if len(values) != len(machine.joints):
        raise Refused("through-count", "--through", value=repr(through)[:60], names=list(machine.names))
    for joint, value in zip(machine.joints, values):
        low, high = joint.span
        if not low <= value <= high:  # also where it is not a number
            shown = {k: joint.to_shown(v) for k, v in (("value", value), ("low", low), ("high", high))}
            raise Refused("through-outside", "--through", name=joint.name, unit=joint.unit, **shown)
    return values
