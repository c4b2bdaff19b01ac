# SPDX-License-Identifier: LGPL-2.1-or-later
"""A sensitivity run from its options to its files; the command line and the batch run on a document share it.

Everything is computed before the first file is made, and all files of a run appear together or not at all.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from sensworkbench.core import workspace
from sensworkbench.core.machine import Machine
from sensworkbench.core.objectives import Objective, objective
from sensworkbench.core.refusal import Refused
from sensworkbench.core.workspace import Sensitivity

from . import report, sensitivity_out, tolerances
from .file_sets import staged
from .files import read_bytes, write_text

PICTURE_LIMIT = 64 * 2**20  # bytes


@dataclass(frozen=True)
class Options:
    """What a sensitivity run is asked for; None: the machine's own, or the default.

    at : (x, y, z) mm.  grid, quadrature : positions per axis, an int or three.  weights, output, signed : objective.
    squareness : convention.  tolerances : a file that overrides the machine's.  angle_unit : "urad" or "arcsec".
    """

    at: tuple[float, float, float] | None = None
    grid: int | tuple[int, int, int] | None = None
    quadrature: int | tuple[int, int, int] | None = None
    weights: tuple[float, float, float] | None = None
    output: str | None = None
    signed: bool = False
    squareness: str | None = None
    tolerances: str | None = None
    angle_unit: str = "urad"

    def machine(self, machine: Machine) -> Machine:
        """The machine with this run's squareness convention and tolerances."""
        if self.squareness:
            machine = replace(machine, squareness=self.squareness)
        if self.tolerances:
            machine = replace(machine, tolerances=dict(machine.tolerances) | tolerances.load(self.tolerances))
        return machine

    def objective(self, default: Objective | None = None) -> Objective:
        """The objective of this run; what is not asked for is the default's."""
        default = default or objective()
        return objective(self.output or default.output, self.weights or default.weights, self.signed or default.signed)

    def positions(self, machine: Machine, default: workspace.Positions | None = None) -> workspace.Positions:
        """The positions of this run; where none are asked for the default's, or the quadrature over the travel."""
        if self.at is not None:
            return workspace.at(machine, self.at)
        if self.grid is not None:
            return workspace.grid(machine, self.grid)
        if self.quadrature is not None or default is None:
            return workspace.quadrature(machine, self.quadrature or workspace.DEFAULT_ORDER)
        return default


def compute(machine: Machine, options: Options = Options()) -> tuple[Machine, Sensitivity]:
    """(machine as it was judged, its indices)."""
    machine = options.machine(machine)
    return machine, workspace.sensitivity(machine, options.positions(machine), options.objective())


def write(
    folder,
    machine: Machine,
    result: Sensitivity,
    angle_unit: str = "urad",
    picture: bytes | None = None,
    extra: Callable[[Path], None] | None = None,
) -> list[Path]:
    """Write sensitivity.json, sensitivity.csv and report.html to `folder` together; returns their paths.

    picture : PNG of the machine for the report.  extra : called with the temporary folder to add files that belong to
    the run (a document, pictures); they appear with the others.
    """
    data = sensitivity_out.to_dict(machine, result, angle_unit)
    texts = {
        "sensitivity.json": sensitivity_out.dumps(data),
        "sensitivity.csv": sensitivity_out.csv_text(data),
        "report.html": report.sensitivity_report(data, picture),
    }
    with staged(folder, "sensitivity") as work:
        for name, text in texts.items():
            write_text(work / name, text)
        if extra is not None:
            extra(work)
        names = sorted(str(p.relative_to(work)) for p in work.rglob("*") if p.is_file() and p.name not in texts)
    return [Path(folder) / name for name in [*texts, *names]]


def read_picture(path) -> bytes:
    """The bytes of a PNG file; refuses anything else."""
    data = read_bytes(path, PICTURE_LIMIT)
    if not data.startswith(b"\x89PNG\r\n\x1a\n"):
        raise Refused("is not a PNG picture", str(path), "Save the picture as PNG.")
    return data
