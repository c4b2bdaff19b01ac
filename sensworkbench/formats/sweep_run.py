# SPDX-License-Identifier: LGPL-2.1-or-later
"""A sweep from its judged variants to its files: rows as they come, then table, Pareto front and page as one set.

The command line and the window write through here, so that both write the same bytes.
"""

from __future__ import annotations

import contextlib
import csv
from collections.abc import Iterable
from pathlib import Path

from sensworkbench.studies.sweep import CHUNK, Sweep

from . import files, operations, study_files, sweep_files

LARGEST_CHUNK = 1000


def chunk_of(variants: int, workers: int) -> int:
    """Variants that a worker gets at a time: few enough that all have work to the end, and many enough that handing
    them out costs little (docs/sweeps.md)."""
    return max(CHUNK, min(LARGEST_CHUNK, variants // (8 * workers)))


def write(folder, sweep: Sweep, done: list[str], judged: Iterable, language: str = "en") -> tuple[list[Path], int]:
    """(paths of the files, number of refused variants).

    done : lines that an interrupted run of the same sweep has kept.  judged : (number, values, outputs or None, what
    was refused) of the others, in order.  What ends `judged` early leaves the lines so far, for another run to go on.
    """
    folder, act = Path(folder), operations.current()
    partial = folder / sweep_files.PARTIAL
    refused = sum(1 for row in done if next(csv.reader([row]))[-1])
    with contextlib.ExitStack() as stack:
        with files.written(folder):
            stack.enter_context(files.made_folders(folder))
        # in one step: what an earlier run kept is there until all of it stands in the new file
        files.write_text(partial, f"# {sweep_files.identity(sweep)}\n" + "".join(done))
        with partial.open("ab") as stream:
            for number, values, outputs, words in judged:
                with files.written(partial):
                    act.append(stream, sweep_files.line(sweep, number, values, outputs, words).encode("utf-8"))
                refused += outputs is None
        texts = sweep_files.summary(sweep, partial, language)
        extra = lambda work: sweep_files.write_results(sweep, partial, work / sweep_files.RESULTS)  # noqa: E731
        paths = study_files.write_set(folder, "sweep", texts, extra)
        with files.written(partial):
            act.remove(partial)
    return paths, refused
