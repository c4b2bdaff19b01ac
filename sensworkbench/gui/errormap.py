# SPDX-License-Identifier: LGPL-2.1-or-later
"""The expected volumetric error over the workspace as coloured points, with a legend of its own in µm.

Each point stands where the tool point is relative to the workpiece at that position; its colour is the root of the mean
square E[Y] there.  The points carry the legend's scale from the smallest to the largest value.
"""

from __future__ import annotations

import numpy as np
from pivy import coin

from ..core import sobol
from ..core.distributions import moments
from ..core.errors import AXES
from ..core.synthesis import omega
from ..core.workspace import error_table
from ..core.workspace import grid as grid_positions
from ..document import extract
from .colormap import Scale
from .legend import Legend, LegendText, unbounded
from .qt import translate

COUNT = 7  # points per axis


def rms(core, objective, count: int = COUNT) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(positions (P, 3) mm, tool point relative to the workpiece (P, 3) mm in document coordinates, sqrt E[Y] (P,))."""
    q = grid_positions(core, count).q
    _, columns, _, laws = error_table(core)
    matrix = omega(core, columns, q, output=objective.output)
    law = moments(laws)
    if objective.signed:
        mean_square = sobol.signed_indices(matrix, law, objective.weights)
        value = np.sqrt(mean_square.variance + mean_square.mean**2)
    else:
        value = np.sqrt(sobol.indices(matrix, law, objective.weights).mean)
    step = sum(q[:, [i]] * np.array(core.axes[k].direction) for i, k in enumerate(AXES))
    return q, np.array(core.tool_point) + step, value


class ErrorMap:
    """The map's nodes.  `root` goes into the scene graph; `show` computes and fills it, `hide` empties it."""

    def __init__(self):
        self.root = coin.SoGroup()
        group = unbounded()
        note = coin.SoSeparator()
        style = coin.SoPickStyle()
        style.style = coin.SoPickStyle.UNPICKABLE
        flat = coin.SoLightModel()
        flat.model = coin.SoLightModel.BASE_COLOR
        draw = coin.SoDrawStyle()
        draw.pointSize = 9.0
        self._material = coin.SoMaterial()
        binding = coin.SoMaterialBinding()
        binding.value = coin.SoMaterialBinding.PER_VERTEX
        self._coordinates = coin.SoCoordinate3()
        self._points = coin.SoPointSet()
        for child in (style, coin.SoResetTransform(), flat, draw, self._material, binding, self._coordinates):
            note.addChild(child)
        note.addChild(self._points)
        self._switch = coin.SoSwitch()
        self._switch.addChild(note)
        self._switch.whichChild = coin.SO_SWITCH_NONE
        group.addChild(self._switch)
        self.root.addChild(group)
        self.legend = Legend()
        self.root.addChild(self.legend.root)

    @property
    def shown(self) -> bool:
        return self._switch.whichChild.getValue() == 0

    def show(self, machine, colour_map: str, corner: str) -> None:
        core, objective = extract.core_machine(machine), extract.objective(machine)
        _, where, value = rms(core, objective)
        factor, unit = (1e3, "µm") if objective.output == "position" else (1e6, "µrad")
        value = value * factor
        scale = Scale(float(value.min()), float(value.max()), colour_map)
        self._coordinates.point.setValues(0, len(where), [tuple(p) for p in where.tolist()])
        colours = [scale.colour(v) for v in value.tolist()]
        self._material.diffuseColor.setValues(0, len(colours), colours)
        self._points.numPoints = len(where)
        self._switch.whichChild = 0
        text = LegendText(
            translate("Sens", "Expected error √E[Y]"), unit, translate("Sens", "tool point over the workspace")
        )
        self.legend.show(text, scale, corner)

    def hide(self) -> None:
        self._switch.whichChild = coin.SO_SWITCH_NONE
        self.legend.hide()
