# SPDX-License-Identifier: LGPL-2.1-or-later
"""The demonstration's part: a test piece predicted by the traced machine, machined, corrected, and machined again.

The machine that cuts is the simulated one, by the exact matrix product, which the traced machine has only seen through
its readings.
"""

from __future__ import annotations

import csv
from collections.abc import Callable
from pathlib import Path

import numpy as np

from sensworkbench.core.machine import Machine
from sensworkbench.core.toolpath import ToolPath
from sensworkbench.core.units import um
from sensworkbench.formats import part_files
from sensworkbench.studies.part import features_on
from sensworkbench.studies.part_correct import left_by, value_under

EXAMPLE = Path(__file__).resolve().parents[1] / "resources" / "examples" / "part"
PROGRAM, FEATURES, CORRECTED = "test_piece.nc", "features.json", "test_piece_corrected.nc"
CONDITIONS, AGAIN = "conditions.csv", "measured_again.csv"
SHOWN = ("circle", "left to front", "centre bore to top", "bore 3")


def make(machine: Machine, folder: Path, truth: Callable[[ToolPath], np.ndarray]) -> list[str]:
    """Write the part to a new `folder`; returns what came out, in words.

    machine : traced.  truth : (P, 3) mm error of the simulated machine along a path.
    """
    folder.mkdir()
    conditions = folder / CONDITIONS
    minutes = np.arange(0, 61, 2.0)
    column = 20 + 4 * (1 - np.exp(-60 * minutes / 2400))
    rows = "".join(f"{60 * t:.0f},{c:.3f},20\n" for t, c in zip(minutes, column))
    conditions.write_text("t_s,temp_column_C,temp_ambient_C\n" + rows, encoding="utf-8", newline="\n")
    options = part_files.Options(
        features=str(EXAMPLE / FEATURES), conditions=str(conditions), correct=str(folder / CORRECTED)
    )
    job = part_files.read(machine, EXAMPLE / PROGRAM, options)
    result = part_files.judged(job)
    part_files.write(folder, job, result)
    correction = part_files.correction_of(job)
    path = correction.path
    before, after = left_by(truth, machine, job.program.moves, path, correction.points, correction.fractions)
    table, words = [["feature", "kind", "predicted_um", "u_um", "machined_um", "machined_corrected_um"]], []
    for made, predicted in zip(features_on(machine, path, job.request.features), result.features):
        values = [value_under(made, path, e) for e in (before, after)]
        numbers = [predicted.value, predicted.u or 0.0, *values]
        table.append([made.name, made.kind.name, *(f"{um(v):.3f}" for v in numbers)])
        if made.name in SHOWN:
            text = "part, {} ({}): predicted {:.1f} um, machined {:.1f} um, with the corrected program {:.1f} um"
            words.append(text.format(made.name, made.kind.name, um(predicted.value), *map(um, values)))
    with open(folder / AGAIN, "w", encoding="utf-8", newline="") as stream:
        csv.writer(stream, lineterminator="\n").writerows(table)
    cuts = path.cutting
    sizes = [um(np.sqrt((e[cuts] ** 2).sum(axis=1).mean())) for e in (before, after)]
    words.append("part: error along the path {:.1f} um rms, with the corrected program {:.2f} um".format(*sizes))
    return words
