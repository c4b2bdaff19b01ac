# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of a trace: trace.json, report.html, machine_augmented.json and the covariance of the fit beside it.

They appear together or not at all; the batch run on a document adds machine_augmented.FCStd to them.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np

from sensworkbench.closedloop.outcome import Outcome
from sensworkbench.core.machine import Machine

from . import machine_json, sensitivity_out, trace_report
from .file_sets import staged
from .files import write_text

COVARIANCE = "covariance.npz"


def augmented(outcome: Outcome) -> Machine:
    """The augmented machine with the name of its covariance file."""
    return replace(outcome.machine, fitted=replace(outcome.machine.fitted, covariance=COVARIANCE))


def write(folder, outcome: Outcome, extra: Callable[[Path, Machine], None] | None = None) -> list[Path]:
    """Write a trace to `folder`; returns the paths.

    extra : called with the temporary folder and the augmented machine to add files that appear with the others.
    """
    machine = augmented(outcome)
    texts = {
        "trace.json": sensitivity_out.dumps(outcome.report),
        "report.html": trace_report.trace_report(outcome.report, outcome),
        "machine_augmented.json": machine_json.dumps(machine),
    }
    names, matrix = outcome.covariance
    with staged(folder, "trace") as work:
        for name, text in texts.items():
            write_text(work / name, text)
        with open(work / COVARIANCE, "wb") as stream:
            np.savez_compressed(
                stream, parameters=np.array(names, dtype=str), covariance=np.asarray(matrix, dtype=float)
            )
        if extra is not None:
            extra(work, machine)
        others = sorted(str(p.relative_to(work)) for p in work.rglob("*") if p.is_file() and p.name not in texts)
    return [Path(folder) / name for name in [*texts, *others]]
