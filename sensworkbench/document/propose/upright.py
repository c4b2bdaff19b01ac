# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which direction of the machine is upright."""

from __future__ import annotations

import numpy as np

from .directing import inner_guides
from .found import State


def upright(state: State, places, answers) -> np.ndarray:
    """The upright direction: the document's z, unless the names of Z parts or the spindle say otherwise."""
    document, axes = state.document, state.axes
    score = np.array([0.9 * abs(a[2]) for a in axes])
    for guide in state.guides:
        letters = {places[n][1] for n in guide.riders if n in places} - {""}
        roles = {places[n][0] for n in guide.riders if n in places}
        if guide.weight > 0.5 and (letters == {"Z"} or roles & {"quill", "knee"}) and not state.said.lathe:
            score += np.abs(axes @ guide.u) * 0.8 * (np.abs(axes @ guide.u) > 0.9)
    for name in "XYZ":
        body = [n for n, (_, letter) in places.items() if letter == name]
        if body and len(body) < 0.5 * len(places):
            for e in inner_guides(document, [], body, axes, state.size):
                hit = np.abs(axes @ e.u) > 0.9
                score += (0.9 if name == "Z" else -0.6) * hit * e.weight * 2
    if not state.said.lathe:
        for n, (role, _) in places.items():
            unit = document.units[n]
            if role == "tool":
                for solid in unit.solids[:5]:
                    if len(solid.radii):
                        weight = solid.radii * np.linalg.norm(
                            solid.round_boxes[:, 3:] - solid.round_boxes[:, :3], axis=1
                        )
                        share = np.array([weight[np.abs(solid.axes @ a) > 0.99].sum() for a in axes])
                        if share.sum() > 0:
                            score += 0.5 * share / share.sum() / max(1, min(5, len(unit.solids)))
                break
    k = int(np.argmax(score))
    up = axes[k]
    return up if up[np.argmax(np.abs(up))] > 0 else -up
