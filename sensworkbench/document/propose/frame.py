# SPDX-License-Identifier: LGPL-2.1-or-later
"""The frame in which a machine is looked at: along its own directions, and of a usual size.

Boxes along the axes are exact only where the machine lies along them, and gaps in mm mean something only where the
file is in mm.  A machine that stands askew in its document, or that is drawn in inches or metres, is turned and scaled
first.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import permutations

import FreeCAD as App
import numpy as np

STRAIGHT = 0.9995  # cosine: what looks this much along an axis of the document lies along it
TINY = 100.0  # mm: a whole machine that is smaller is drawn in another unit, or is small; either way it is scaled
USUAL = 1000.0  # mm


@dataclass(frozen=True)
class Frame:
    """rows : (3, 3) the machine's directions in the document, as rows.  scale : mm of the frame for 1 mm drawn."""

    rows: np.ndarray = field(default_factory=lambda: np.eye(3))
    scale: float = 1.0

    @property
    def is_document(self) -> bool:
        """Whether it is the document's own frame."""
        return self.scale == 1.0 and bool(np.all(self.rows == np.eye(3)))

    @property
    def turn(self) -> App.Placement:
        """The placement that takes the document into the directions of the frame."""
        matrix = App.Matrix(*[v for row in self.rows for v in (*row, 0.0)], 0.0, 0.0, 0.0, 1.0)
        return App.Placement(matrix)

    def inward(self, u) -> np.ndarray:
        """A direction of the document, in the frame."""
        return self.rows @ np.asarray(u, float)

    def outward(self, u) -> np.ndarray:
        """A direction of the frame, in the document."""
        return np.asarray(u, float) @ self.rows

    def point(self, at) -> np.ndarray | None:
        """A point of the frame, in the document, mm."""
        return None if at is None else self.outward(at) / self.scale


def machine_axes(units, minor=()) -> np.ndarray:
    """The three directions that most flat faces look along, as rows; the document's own unless they are clearly not.

    The k-th row is the one nearest to the k-th axis of the document.
    """
    normals, weights = [], []
    for n, unit in enumerate(units):
        if n in minor:
            continue
        for solid in unit.solids:
            if len(solid.offsets):
                sizes = np.sort(solid.plane_boxes[:, 3:] - solid.plane_boxes[:, :3], axis=1)
                normals.append(solid.planes)
                weights.append(sizes[:, 1] * sizes[:, 2])
    if not normals:
        return np.eye(3)
    normals, weights = np.vstack(normals), np.concatenate(weights) + 1e-6
    weights = weights * np.where(np.abs(normals).max(1) > STRAIGHT, 2.0, 1.0)
    first = _heaviest(normals, weights)
    across = np.abs(normals @ first) < 0.02
    if not across.any():
        return np.eye(3)
    second = _heaviest(normals[across], weights[across])
    second = second - first * (second @ first)
    second /= np.linalg.norm(second)
    rows = np.array([first, second, np.cross(first, second)])
    order = max(permutations(range(3)), key=lambda o: sum(abs(rows[o[k]][k]) for k in range(3)))
    rows = rows[list(order)]
    if np.abs(np.diag(rows)).min() > STRAIGHT:
        return np.eye(3)
    rows = rows * np.sign(np.diag(rows) + 1e-12)[:, None]
    if np.linalg.det(rows) < 0:
        rows[int(np.argmin(np.abs(np.diag(rows))))] *= -1
    return rows


def _heaviest(normals, weights):
    """The direction of the heaviest bundle of normals, its mean."""
    some = np.argsort(-weights)[:200]
    best = max(some, key=lambda i: weights[np.abs(normals @ normals[i]) > STRAIGHT].sum())
    lead = normals[best]
    hit = np.abs(normals @ lead) > STRAIGHT
    mean = (normals[hit] * (np.sign(normals[hit] @ lead) * weights[hit])[:, None]).sum(0)
    mean /= np.linalg.norm(mean)
    return mean * (1.0 if mean[np.argmax(np.abs(mean))] > 0 else -1.0)


def frame_of(units, minor=()) -> Frame:
    """The frame in which these units are best looked at."""
    rows = machine_axes(units, minor)
    boxes = np.array([u.box for u in units]) if units else np.zeros((1, 6))
    size = float(np.linalg.norm(boxes[:, 3:].max(0) - boxes[:, :3].min(0)))
    return Frame(rows, USUAL / size if 0 < size < TINY else 1.0)
