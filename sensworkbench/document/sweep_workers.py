# SPDX-License-Identifier: LGPL-2.1-or-later
"""Variants of a sweep judged by FreeCAD processes: each list of variants is handed to one, which ends with its answer.

Needs no FreeCAD in this process.
"""

from __future__ import annotations

import json
import tempfile
from pathlib import Path

from . import handoff


class WorkerEnded(Exception):
    """A process ended without an answer.  status : how."""

    def __init__(self, status: int):
        super().__init__(status)
        self.status = status


class WorkerJudge:
    """Judges variants of the sweep in the file `spec`, with a FreeCAD process for each list of them.

    Raises `WorkerEnded` where a process gives no answer.
    """

    def __init__(self, spec):
        self.spec = str(spec)

    def __call__(self, rows) -> list:
        with tempfile.TemporaryDirectory(prefix="sens-sweep-") as place:
            asked, answered = Path(place, "rows.json"), Path(place, "out")
            asked.write_text(json.dumps([list(row) for row in rows]), encoding="utf-8")
            status = handoff.run(["sweep", self.spec, "--out", str(answered), "--rows", str(asked)])
            if status or not answered.is_file():
                raise WorkerEnded(status)
            return [(found, words) for found, words in json.loads(answered.read_text(encoding="utf-8"))]
