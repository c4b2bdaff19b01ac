# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part as a shape: error vectors and signed departures of its faces between the points at which they are cut.

Between the points of a path values are weighted by the inverse square of the distance to the nearest ones.  Of
tolerances there is no sign: the expected size is shown, and one possible part is drawn for its shape.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..core.refusal import Refused
from .part import PartResult, nominal_points
from .part_errors import TolerancedErrors, chunks

NEAREST, MOST = 6, 1200  # points of a face between which is interpolated
DRAWN, DRAWS = 3, 16  # which draw of how many is shown as a possible part


@dataclass(frozen=True)
class FaceField:
    """Points (n, 3) mm of a face that are cut, in document coordinates; error (n, 3) mm there; value (n,) mm: the
    error along the outward normal, or its length; signed : which of the two.  axial : of a drilled hole, whose points
    are those of its axis."""

    name: str
    points: np.ndarray
    error: np.ndarray
    value: np.ndarray
    signed: bool
    axial: bool = False

    def wall(self, places) -> np.ndarray:
        """(m,) mm, signed error of the wall of a drilled hole at places (m, 3) on it: the hole moves as its axis does,
        and its outward normal points to the axis."""
        moved, _ = self.at(places)
        rows = np.argmin(((places[:, None, :] - self.points[None]) ** 2).sum(axis=2), axis=1)
        inwards = self.points[rows] - places
        along = self.points[-1] - self.points[0]
        if np.linalg.norm(along) > 0:
            along = along / np.linalg.norm(along)
            inwards = inwards - (inwards @ along)[:, None] * along
        return (moved * inwards).sum(axis=1) / np.maximum(np.linalg.norm(inwards, axis=1), 1e-12)

    def at(self, places) -> tuple[np.ndarray, np.ndarray]:
        """((m, 3) error, (m,) value) at places (m, 3)."""
        both = np.concatenate([self.error, self.value[:, None]], axis=1)
        out = np.empty((len(places), 4))
        count = min(NEAREST, len(self.points))
        for rows in chunks(np.arange(len(places)), 2000):
            apart = ((places[rows, None, :] - self.points[None]) ** 2).sum(axis=2)
            near = np.argpartition(apart, count - 1, axis=1)[:, :count]
            weight = 1 / (np.take_along_axis(apart, near, axis=1) + 1e-6)
            out[rows] = (weight[:, :, None] * both[near]).sum(axis=1) / weight.sum(axis=1)[:, None]
        return out[:, :3], out[:, 3]

    @property
    def worst(self) -> int:
        """Row of the largest size."""
        return int(np.argmax(np.abs(self.value)))


def face_fields(result: PartResult, names, error=None, path=None) -> dict[str, FaceField]:
    """The fields of the faces `names` of a result.  error, path : (P, 3) mm along another path with the same labels (a
    corrected one), in place of the result's own."""
    path = result.path if path is None else path
    error = result.error if error is None else error
    drawn = None if error is not None else TolerancedErrors(result.machine, path)
    factors = None if drawn is None else drawn.draws(DRAWS)[DRAWN]
    back = result.machine.frame.T
    found = {}
    for name in names:
        rows = path.labels.get(name)
        if rows is None or not len(rows):
            raise Refused("feature-without-points", f"feature {name!r}")
        rows = rows[np.unique(np.linspace(0, len(rows) - 1, MOST).astype(int))]
        points = nominal_points(result.machine, path, rows)
        if error is not None:
            moved, normal = error[rows], path.normal[rows]
            known = np.isfinite(normal).all(axis=1)
            signed = bool(known.any())
            value = (moved * np.nan_to_num(normal)).sum(axis=1) if signed else np.linalg.norm(moved, axis=1)
        else:
            moved, value, signed = (
                drawn.columns(rows) @ factors + drawn.means(rows).sum(axis=2),
                result.expected[rows],
                False,
            )
        axial = error is not None and not signed
        found[name] = FaceField(name, points @ back, moved @ back, value, signed, axial)
    return found


def together(fields) -> FaceField:
    """One field of several faces, less their mean displacement: a part keeps its edges, and where it stands is not its
    shape."""
    fields = list(fields)
    thin = max(1, sum(len(f.points) for f in fields) // (3 * MOST))
    points, error, value = (
        np.concatenate([getattr(f, k)[::thin] for f in fields]) for k in ("points", "error", "value")
    )
    return FaceField("", points, error - error.mean(axis=0), value, False)
