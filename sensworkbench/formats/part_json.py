# SPDX-License-Identifier: LGPL-2.1-or-later
"""part.json and its tables: what a part will look like, um and the coordinates of the path as it was written."""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping

import numpy as np

from sensworkbench.core.units import um
from sensworkbench.studies.part import PartResult, body_shares
from sensworkbench.studies.part_features import FeatureFound

from . import csv_table

FORMAT, VERSION = "sens-part", 1
MOST_ROWS = 10_000  # of points.csv
DIGITS = 9  # significant


def number(value: float | None) -> float | None:
    """A finite number with the digits that are written; None for anything else."""
    return None if value is None or not np.isfinite(value) else float(f"{value:.{DIGITS}g}")


def to_dict(result: PartResult, source: Mapping) -> dict:
    """The data of part.json.  source : what the reader of the path says: "path", "unread_words", "assumed", "settings",
    "correction" and "remarks" are kept."""
    path, size = result.path, result.size
    cuts = np.flatnonzero(path.cutting)
    cutting = cuts if len(cuts) else np.arange(path.points)
    worst = int(cutting[np.argmax(size[cutting])])
    data = {
        "format": FORMAT,
        "version": VERSION,
        "machine": result.machine.name,
        "path": source.get("path", ""),
        "errors": result.model,
        "settings": dict(source.get("settings", {})) | {"level": result.level},
        "points": path.points,
        "error": {
            "rms_um": number(um(np.sqrt((size[cutting] ** 2).mean()))),
            "p95_um": number(um(np.quantile(size[cutting], 0.95))),
            "max_um": number(um(size[worst])),
            "worst_at": place(result, worst),
            "worst_line": int(path.line[worst]),
        },
        "features": [feature_dict(result, f) for f in result.features],
        "outside_travel": [
            {"line": o.line, "joint": o.joint, "by": number(o.by), "unit": result.machine.joint(o.joint).unit,
             "at": written(result, o.at)}
            for o in result.outside
        ],
        "unread_words": [{"word": w, "line": line, "count": n} for w, line, n in source.get("unread_words", ())],
        "assumed": list(source.get("assumed", ())),
        "remarks": [m.to_dict() for m in (*source.get("remarks", ()), *result.remarks)],
    }  # fmt: skip
    if result.quantile is not None:
        data["error"] |= {
            "quantile_um": number(um(result.quantile[worst])),
            "quantile_error": number(result.quantile_error),
        }
    if source.get("correction"):
        data["correction"] = source["correction"]
    return data


def written(result: PartResult, position) -> list[float]:
    """A position in the coordinates and units of the path."""
    return [number(float(j.to_shown(v))) for j, v in zip(result.machine.joints, position)]


def place(result: PartResult, row: int) -> list[float]:
    """Where a point of the path is, in its own coordinates."""
    return written(result, result.path.written[row])


def feature_dict(result: PartResult, found: FeatureFound) -> dict:
    """One feature of part.json."""
    limit = found.feature.limit
    data = {
        "name": found.feature.name,
        "kind": found.feature.kind.name,
        "element": found.feature.surface.element.kind,
        "datum": None if found.feature.datum is None else found.feature.datum.name,
        "points": found.points,
        "value_um": number(um(found.value)),
        "u_um": None if found.u is None else number(um(found.u)),
        "limit_um": None if limit is None else number(um(limit)),
        "within": None if limit is None else bool(abs(found.value) <= limit),
        "least_squares_um": number(um(found.least_squares)),
        "rms_um": number(um(found.rms)),
    }
    if found.quantile is not None:
        data["quantile_um"] = number(um(found.quantile))
        data["within"] = None if limit is None else bool(found.quantile <= limit)
    data["shares"] = {label: float(f"{s:.13g}") for label, s in zip(result.labels, found.shares) if s != 0}
    data["body_shares"] = {b: number(s) for b, s in body_shares(result, found.shares).items()}
    data["worst_at"], data["worst_line"] = place(result, found.worst), int(result.path.line[found.worst])
    return data


def features_csv(data: Mapping) -> str:
    """features.csv: one row per feature, its largest shares in words."""
    rows = [
        ["name", "kind", "value_um", "u_um", "limit_um", "within", "least_squares_um", "rms_um", "points", "shares"]
    ]
    for f in data["features"]:
        ranked = sorted(f["shares"].items(), key=lambda item: -abs(item[1]))
        shares = "; ".join(f"{label} {share:.3f}" for label, share in ranked[:8])
        cells = [f[k] for k in rows[0][:-1]]
        rows.append([csv_table.safe_cell(str(c)) if c is not None else "" for c in (*cells, shares)])
    return _table(rows)


def points_csv(result: PartResult) -> str:
    """points.csv: the error at points of the path, every k-th where there are more than MOST_ROWS of them."""
    path = result.path
    rows = np.arange(path.points)
    if path.points > MOST_ROWS:
        rows = np.unique(
            np.concatenate([np.linspace(0, path.points - 1, MOST_ROWS).astype(int), [np.argmax(result.size)]])
        )
    names = ["line", *(f"{j.column}_{j.unit}" for j in result.machine.joints)]
    columns = [path.line[rows], *(j.to_shown(path.written[rows, i]) for i, j in enumerate(result.machine.joints))]
    if result.error is not None:
        names += ["ex_um", "ey_um", "ez_um"]
        columns += list(um(result.error[rows]).T)
    else:
        names += ["expected_um", "quantile_um"]
        columns += [um(result.expected[rows]), um(result.quantile[rows])]
    lines = [names, *([f"{v:d}", *(f"{x:.6g}" for x in rest)] for v, *rest in zip(*columns))]
    return _table(lines)


def _table(rows) -> str:
    stream = io.StringIO()
    csv.writer(stream, lineterminator="\n").writerows(rows)
    return stream.getvalue()
