# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which direction of the machine is upright."""

from __future__ import annotations

import numpy as np

from . import words
from .directing import inner_guides
from .found import State


def upright(state: State, places) -> tuple[np.ndarray, float]:
    """(upright direction, how sure from 0 to 1): the document's z, unless names, tool or table say otherwise."""
    document, axes = state.document, state.axes
    score = np.array([0.9 * abs(a[2]) for a in axes])
    for guide in state.guides:
        letters = {places[n][1] for n in guide.riders if n in places} - {""}
        roles = {places[n][0] for n in guide.riders if n in places}
        weight = 1.0 if letters == {"Z"} or roles & {"quill", "knee"} else 0.0
        if weight and _runs_level(document, guide.riders):
            weight = 0.5  # the head of a printer or of a laser runs level as often
        if guide.weight > 0.5 and weight and not state.said.lathe:
            score += np.abs(axes @ guide.u) * weight * (np.abs(axes @ guide.u) > 0.9)
    for name in "XYZ":
        body = [n for n, (_, letter) in places.items() if letter == name]
        if body and len(body) < 0.5 * len(places):
            for e in inner_guides(document, [], body, axes, state.size):
                hit = np.abs(axes @ e.u) > 0.9
                score += (0.9 if name == "Z" else -0.6) * hit * e.weight * 2
    if not state.said.lathe:
        score += 0.65 * _tool_axis(document, places, axes) + 0.65 * _lying(document, axes)
    order = np.argsort(-score)
    up = axes[int(order[0])]
    sure = 1.0 - float(score[order[1]]) / max(1e-9, float(score[order[0]]))
    return (up if up[np.argmax(np.abs(up))] > 0 else -up), sure


def _runs_level(document, riders) -> bool:
    """Whether riders, or what stands in one container with them, are called the head of a printer, laser or plotter."""
    holders = {document.units[n].holders[-1] for n in riders if document.units[n].holders}
    for n, unit in enumerate(document.units):
        if n in riders or (unit.holders and unit.holders[-1] in holders):
            if any(words.LEVEL_HEAD.search(words.plain(t)) for t in unit.labels):
                return True
    return False


def _tool_axis(document, places, axes) -> np.ndarray:
    """(3,) share of the round faces of what is called a tool or spindle that lie along each axis, 0 without one."""
    for n, unit in enumerate(document.units):
        if "tool" not in (places.get(n, ("", ""))[0], unit.own_role):
            continue
        total = np.zeros(3)
        for solid in unit.solids[:5]:
            if len(solid.radii):
                weight = solid.radii * np.linalg.norm(solid.round_boxes[:, 3:] - solid.round_boxes[:, :3], axis=1)
                total += [weight[np.abs(solid.axes @ a) > 0.99].sum() for a in axes]
        if total.sum() > 0:
            return total / total.sum() / max(1, min(5, len(unit.solids)))
    return np.zeros(3)


def _lying(document, axes) -> np.ndarray:
    """(3,) share of the large thin parts called table, bed or work that are thin along each axis: those lie flat.

    What is called base counts too where it is the outermost there is along the axis; a frame may be an upright plate.
    """
    total = np.zeros(3)
    boxes = np.array([u.box for u in document.units])
    if not len(boxes):
        return total
    ends = boxes[:, :3].min(0), boxes[:, 3:].max(0)
    size = ends[1] - ends[0]
    for unit in document.units:
        role = unit.own_role or (unit.role if unit.role != "base" else "")
        if role in ("table", "bed", "base", "work") and not unit.hardware:
            for solid in unit.solids[:20]:
                order = np.argsort(solid.size)
                k = order[0]
                outermost = min(solid.box[k] - ends[0][k], ends[1][k] - solid.box[k + 3]) < 0.05 * size[k]
                if solid.size[k] < 0.3 * solid.size[order[1]] and (role != "base" or outermost):
                    total[k] += solid.size[order[1]] * solid.size[order[2]]
    return total / total.sum() if total.sum() > 0 else total
