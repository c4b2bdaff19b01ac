# SPDX-License-Identifier: LGPL-2.1-or-later
"""The volumetric error over the workspace, as coloured points or as a slice, with a legend of its own in µm.

Each point is drawn where the tool point is relative to the workpiece at that position.  Its colour is the root of the
mean square, √E[Y], or the upper estimate √(E[Y] + 2 √V(Y)): Y two of its standard deviations above its mean.
The legend runs from the smallest to the largest value of the workspace, for slices too.  A click on the map shows the
position of the axes there, and the error.
"""

from __future__ import annotations

import numpy as np
from pivy import coin

from ..document import extract, tree
from ..document.base import kind_of
from ..studies.error_map import FINE, map_errors, map_positions
from .arrows import POINT_COLOUR, Arrow, Arrows
from .colormap import Scale
from .dragging import Click
from .legend import Legend, LegendText, unbounded
from .looks import MAP_SHOWS, POINTS, sliced
from .qt import translate
from .texts import fixed, length, position_words, shown_unit

EXPECTED, WORST = MAP_SHOWS
NEAR = 14  # pixels from a point of the map that a click may be


def positions(core, form: str = POINTS, at: float = 0.0) -> np.ndarray:
    """(P, n) positions of the axes: a grid over the travel, or a slice with one axis at `at` (mm)."""
    return map_positions(core, None if form == POINTS else core.names.index(sliced(form)), at)


def title(objective, what: str) -> str:
    """Return the title of the map's legend."""
    if objective.signed:
        return (translate("Sens", "Upper estimate |E[Y]| + 2√V(Y)") if what == WORST
                else translate("Sens", "Expected error √(E[Y]² + V(Y))"))  # fmt: skip
    if what == WORST:
        return translate("Sens", "Upper estimate √(E[Y] + 2√V(Y))")
    return translate("Sens", "Expected error √E[Y]")


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
        sides = coin.SoShapeHints()  # a slice is seen from both sides
        sides.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        sides.shapeType = coin.SoShapeHints.UNKNOWN_SHAPE_TYPE
        self._material = coin.SoMaterial()
        binding = coin.SoMaterialBinding()
        binding.value = coin.SoMaterialBinding.PER_VERTEX
        self._coordinates = coin.SoCoordinate3()
        self._points = coin.SoPointSet()
        self._mesh = coin.SoQuadMesh()
        self._mesh.verticesPerRow = self._mesh.verticesPerColumn = FINE
        self._form = coin.SoSwitch()
        self._form.addChild(self._points)
        self._form.addChild(self._mesh)
        for child in (style, coin.SoResetTransform(), flat, draw, sides, self._material, binding, self._coordinates):
            note.addChild(child)
        note.addChild(self._form)
        self._switch = coin.SoSwitch()
        self._switch.addChild(note)
        self._switch.whichChild = coin.SO_SWITCH_NONE
        group.addChild(self._switch)
        self.root.addChild(group)
        self.legend, self.mark = Legend(), Arrows()
        self.root.addChild(self.legend.root)
        self.root.addChild(self.mark.root)
        self.root.addChild(Click(self._clicked).node)
        self.picked = None  # position of the axes (mm) that was clicked last
        self._values = np.zeros(0), "", [], np.zeros((0, 0))  # value, unit, names of the axes, positions
        self._key = self._whole = None
        self._ends = (0.0, 0.0)

    @property
    def shown(self) -> bool:
        """Whether the map is visible."""
        return self._switch.whichChild.getValue() == 0

    def show(self, machine, colour_map: str, corner: str, what: str = EXPECTED, form: str = POINTS,
             at: float = 0.0) -> None:  # fmt: skip
        """Compute and draw; what : `MAP_SHOWS`, form : `MAP_FORMS`, at : position of the sliced axis in mm."""
        axes = [obj for obj in tree.bodies(machine).values() if kind_of(obj) == "Axis"]
        if sliced(form) not in [axis.Axis for axis in axes] or len(axes) < 2:
            form = POINTS  # of another machine
        stands = [tuple(machine.FunctionalPoint), *(tuple(axis.Direction) for axis in axes)]
        key = (
            machine.Inputs,
            shown_unit(extract.objective(machine).output),
            machine.Objective,
            *stands,
            colour_map,
            what,
            form,
            at,
        )
        if key != self._key:
            core, objective = extract.core_machine(machine), extract.objective(machine)
            q = positions(core, form, at)
            if form != POINTS:
                at = float(q[0, core.names.index(sliced(form))])
            value = map_errors(core, objective, q, upper=what == WORST)
            whole = (key[:-4], what)
            if whole != self._whole:  # one scale for the workspace: a slice that moves can be compared with the last
                self._whole, everywhere = whole, map_errors(core, objective, positions(core), upper=what == WORST)
                self._ends = float(everywhere.min()), float(everywhere.max())
            self.unpick()
            self._fill(core.tool_position(q), value, objective, colour_map, what, form, at)
            unit, factor = shown_unit(objective.output)
            self._values = value * factor, unit, list(core.names), q
            self._key = key if machine.Inputs else None
        self._switch.whichChild = 0
        self.legend.show(self._text, self._scale, corner)

    def _fill(self, where, value, objective, colour_map, what, form, at) -> None:
        unit, factor = shown_unit(objective.output)
        value = value * factor
        low, high = (end * factor for end in self._ends)
        self._scale = scale = Scale(min(low, float(value.min())), max(high, float(value.max())), colour_map)
        colours = [scale.colour(v) for v in value.tolist()]
        self._coordinates.point.setNum(len(where))
        self._coordinates.point.setValues(0, len(where), [tuple(p) for p in where.tolist()])
        self._material.diffuseColor.setNum(len(colours))
        self._material.diffuseColor.setValues(0, len(colours), colours)
        self._points.numPoints = len(where)
        self._form.whichChild = 1 if form != POINTS and len(where) == FINE * FINE else 0  # a line is drawn as points
        words = translate("Sens", "tool point over the workspace")
        if form != POINTS:
            words = translate("Sens", "slice at {axis} = {position}").format(axis=sliced(form), position=length(at))
        short = "√E[Y]" if what == EXPECTED else "E + 2σ"
        note = "" if form == POINTS else f"{sliced(form)} = {length(at)}"
        self._text = LegendText(title(objective, what), unit, words, short=short, note=note)

    def _clicked(self, x: float, y: float, project) -> None:
        """A click in the view: the point of the map there, the nearest to the eye, is marked and said."""
        if not self.shown or not len(self._values[0]):
            return
        places = self.drawn[0]
        seen = project(places)
        far = np.hypot(seen[:, 0] - x, seen[:, 1] - y)
        near = np.flatnonzero(far < max(NEAR, far.min() + 3 if self._form.whichChild.getValue() else 0))
        near = near[far[near] < 4 * NEAR]
        if not len(near):
            self.unpick()
            return
        best = near[np.argmin(far[near])] if self._form.whichChild.getValue() else near[np.argmin(seen[near, 2])]
        values, unit, names, q = self._values
        self.picked = dict(zip(names, q[best].tolist()))
        where = position_words({name: fixed(v, 1) for name, v in self.picked.items()})
        text = f"{where}\n{fixed(float(values[best]), 1)} {unit}"
        at = tuple(places[best].tolist())
        extent = float(np.linalg.norm(np.ptp(places, axis=0)))
        self.mark.show([Arrow(at, at, POINT_COLOUR, text, below=True)], extent)

    def unpick(self) -> None:
        """Take the mark of a click away."""
        self.picked = None
        self.mark.clear()

    @property
    def drawn(self) -> tuple[np.ndarray, Scale, LegendText]:
        """What is drawn: (P, 3) places, the scale of the colours, and the words of the legend."""
        places = np.array([tuple(p.getValue()) for p in self._coordinates.point.getValues()])
        return places, self._scale, self._text

    def hide(self) -> None:
        """Hide the map and its legend."""
        self._switch.whichChild = coin.SO_SWITCH_NONE
        self.legend.hide()
        self.unpick()
