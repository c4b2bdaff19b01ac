# SPDX-License-Identifier: LGPL-2.1-or-later
"""Charts of the report of a part, as SVG; None where matplotlib is missing."""

from __future__ import annotations

import numpy as np

from sensworkbench.core.units import um
from sensworkbench.studies.part import PartResult, nominal_points
from sensworkbench.studies.part_features import FeatureFound

from .charts import INK, SERIES, _Drawing, available
from .html import Html

MOST_DRAWN = 2000
DEPARTURE = 0.12  # of the size of the feature, for the largest departure


def path_chart(result: PartResult, xlabel: str, alt: str) -> Html | None:
    """The length of the error over the points of the path; where only tolerances are known, expected and quantile."""
    if not available():
        return None
    rows = _some(np.arange(result.path.points))
    with _Drawing(8, 2.4, alt) as drawing:
        ax = drawing.axes()
        ax.plot(rows, um(result.size[rows]), color=SERIES[0], linewidth=0.9)
        if result.quantile is not None:
            ax.plot(rows, um(result.quantile[rows]), color=SERIES[1], linewidth=0.9)
        ax.set_ylim(bottom=0)
        ax.set_xlabel(xlabel)
        ax.set_ylabel("µm")
    return drawing.svg


def _some(rows) -> np.ndarray:
    """At most MOST_DRAWN of the rows."""
    return rows[np.unique(np.linspace(0, len(rows) - 1, MOST_DRAWN).astype(int))]


def shape_chart(result: PartResult, found: FeatureFound, alt: str) -> tuple[Html, float] | None:
    """(nominal and exaggerated actual shape in the two directions in which the feature is largest, exaggeration)."""
    if not available() or result.error is None:
        return None
    rows = _some(result.path.labels[found.feature.surface.name])
    points, error = nominal_points(result.machine, result.path, rows), result.error[rows]
    error = error - error.mean(axis=0)
    if len(points) < 2:
        return None
    centred = points - points.mean(axis=0)
    _, _, directions = np.linalg.svd(np.concatenate([centred, 1e-3 * error]), full_matrices=False)
    first, second = _drawn(directions)
    size = float(np.ptp(points @ first) + np.ptp(points @ second))
    largest = float(np.linalg.norm(error, axis=1).max())
    if largest <= 0 or size <= 0:
        return None
    times = float(f"{DEPARTURE * size / largest:.1g}")
    actual = points + times * error
    with _Drawing(4.6, 3.8, alt) as drawing:
        ax = drawing.axes()
        ax.plot(points @ first, points @ second, color=INK, alpha=0.35, linewidth=0.8)
        ax.plot(actual @ first, actual @ second, color=SERIES[1], linewidth=1.1)
        ax.set_aspect("equal", adjustable="datalim")
        ax.set_xlabel("mm")
    return drawing.svg, times


def _drawn(directions) -> tuple[np.ndarray, np.ndarray]:
    """The two directions of a drawing, each pointing along the axis of the machine that it is nearest to."""
    pair = [d * np.sign(d[np.argmax(np.abs(d))]) for d in directions[:2]]
    pair.sort(key=lambda d: int(np.argmax(np.abs(d))))
    return pair[0], pair[1]
