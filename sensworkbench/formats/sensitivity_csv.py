# SPDX-License-Identifier: LGPL-2.1-or-later
"""sensitivity.csv: one line per error, the largest total index first; then effects without a rank."""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping

from .files import neutral

COLUMNS = (
    "rank", "symbol", "description", "owner", "lower", "upper", "unit", "distribution", "first", "total", "share",
    "total_max",
    "first_variance_weighted", "total_variance_weighted",
)  # fmt: skip


def dumps(data: Mapping) -> str:
    """The table of the data of sensitivity.json."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(COLUMNS)
    for rank, row in enumerate(data["errors"], start=1):
        cells = [rank] + [row[k] for k in COLUMNS[1:]]
        writer.writerow([neutral(c) if isinstance(c, str) else c for c in cells])
    for row in data.get("without_extent", ()):
        cells = {"symbol": row["effect"], "description": row["text"], "owner": row["owner"]}
        writer.writerow([neutral(cells.get(k, "")) for k in COLUMNS])
    return stream.getvalue()
