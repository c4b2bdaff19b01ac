# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which direction of the machine is upright."""

from __future__ import annotations

import numpy as np

from .directing import inner_guides
from .found import State


def upright(state: State, places) -> tuple[np.ndarray, float]:
    """(upright direction, how sure from 0 to 1): the document's z, unless names, tool or table say otherwise."""
    document, axes = state.document, state.axes
    score = np.array([0.9 * abs(a[2]) for a in axes])
    for guide in state.guides:
        letters = {places[n][1] for n in guide.riders if n in places} - {""}
        roles = {places[n][0] for n in guide.riders if n in places}
        if guide.weight > 0.5 and (letters == {"Z"} or roles & {"quill", "knee"}) and not state.said.lathe:
            score += np.abs(axes @ guide.u) * 1.0 * (np.abs(axes @ guide.u) > 0.9)
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
    """(3,) share of the large thin parts called table, bed or base that are thin along each axis: those lie flat."""
    total = np.zeros(3)
    for unit in document.units:
        if unit.role in ("table", "bed", "base", "work") and not unit.hardware:
            for solid in unit.solids[:20]:
                order = np.argsort(solid.size)
                if solid.size[order[0]] < 0.3 * solid.size[order[1]]:
                    total[order[0]] += solid.size[order[1]] * solid.size[order[2]]
    return total / total.sum() if total.sum() > 0 else total
