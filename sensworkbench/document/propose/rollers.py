# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wheels without names: equal short rollers on both sides of a long bar, turning across it, run along it.

So do V-wheels in the grooves of a profile, and ball bearings on a tube.  Idlers of belts stand on one side only.
"""

from __future__ import annotations

import re

import numpy as np

from .guides import is_round_bar, shape_of
from .reading import Document

ENGAGED = (0.2, 1.35)  # distance of a wheel's middle from a profile, as a share of its radius
TANGENT = 1.5  # mm between what is called a bearing and the tube that it runs on
TUBE = re.compile(r"tube|pipe|rohr", re.I)
BARS = ("", "extrusion", "rail", "shaft")


def roller(solid) -> int | None:
    """Number of the axis that a short body of revolution turns about; None for anything else."""
    size = solid.size
    for k in range(3):
        i, j = (n for n in range(3) if n != k)
        if abs(size[i] - size[j]) > 0.04 * size[i] or size[k] > 1.2 * size[i] or not len(solid.radii):
            continue
        middle = (solid.box[3:] + solid.box[:3]) / 2
        along = np.abs(solid.axes[:, k]) > 0.99
        centred = np.abs(solid.points[:, [i, j]] - middle[[i, j]]).max(1) < 0.05 * size[i]
        flats = np.abs(solid.planes[:, k]) < 0.5 if len(solid.offsets) else np.zeros(0, bool)
        wide = (solid.plane_boxes[:, 3:] - solid.plane_boxes[:, :3]).max(1) > 0.3 * size[i] if len(flats) else flats
        if (along & centred).any() and not (flats & wide).any():
            return k
    return None


def _straight(solid, size: float) -> bool:
    """Whether a solid is a bar, round over its whole length."""
    kind, u = shape_of(solid, size)
    return bool(kind) and is_round_bar(solid, u)


def _is_block(solid) -> bool:
    """Whether a solid has wide flat faces across all three directions, as no wheel has."""
    if not len(solid.offsets) or not len(solid.radii):  # of a mesh, nothing is known of its bore
        return False
    wide = (solid.plane_boxes[:, 3:] - solid.plane_boxes[:, :3]).max(1) > 0.3 * solid.size.max()
    return bool(np.all((np.abs(solid.planes[wide]) > 0.99).any(0))) if wide.any() else False


def find_wheels(document: Document, size: float) -> set[int]:
    """Numbers of the units that are wheels by their shape and place; they are called so from here on.

    What is called tube, and is straight, is no hose; what is called roller, and is a block, holds rollers.
    """
    units = document.units
    for unit in units:
        if unit.hardware == "loose" and TUBE.search(unit.label) and all(_straight(s, size) for s in unit.solids):
            unit.hardware = ""
    bars, wheels = [], []
    for n, unit in enumerate(units):
        if len(unit.solids) != 1:
            continue
        solid = unit.solids[0]
        if unit.hardware == "wheel" and _is_block(solid):
            unit.hardware = ""  # a holder of rollers, by its shape
        if unit.hardware in ("", "bearing") and unit.size < 0.15 * size and (k := roller(solid)) is not None:
            wheels.append((n, k, solid))
        elif unit.hardware in BARS:
            kind, u = shape_of(solid, size)
            if kind and np.abs(u).max() > 0.999:
                bars.append((solid.box, int(np.argmax(np.abs(u)))))
    found: set[int] = set()
    if len(wheels) < 2:
        return found
    boxes = np.array([s.box for _, _, s in wheels])
    middles, sizes = (boxes[:, 3:] + boxes[:, :3]) / 2, boxes[:, 3:] - boxes[:, :3]
    axes = np.array([k for _, k, _ in wheels])
    named = np.array([units[n].hardware == "bearing" for n, _, _ in wheels])
    for box, i in bars:
        for k in (n for n in range(3) if n != i):
            j = 3 - i - k
            radius = sizes[:, j] / 2
            inside = (axes == k) & (middles[:, i] > box[i]) & (middles[:, i] < box[i + 3])
            inside &= (boxes[:, k] < box[k + 3]) & (boxes[:, k + 3] > box[k])
            inside &= radius < 0.15 * (box[i + 3] - box[i])
            above, below = middles[:, j] - box[j + 3], box[j] - middles[:, j]
            sides = []
            for away in (above, below):
                near = np.where(named, np.abs(away - radius) < TANGENT,
                                (away > ENGAGED[0] * radius) & (away < ENGAGED[1] * radius))  # fmt: skip
                sides.append(inside & near)
            for a in np.flatnonzero(sides[0]):
                same = np.abs(sizes - sizes[a]).max(1) < 0.02 * sizes[a].max()
                if (sides[1] & same).any():
                    found |= {wheels[m][0] for m in np.flatnonzero((sides[0] | sides[1]) & same)}
    for n in found:
        units[n].hardware = "wheel"
    return found
