# SPDX-License-Identifier: LGPL-2.1-or-later
"""Labelled arrows in the 3D view: axes of motion, reference points, Abbe offsets with their length in mm.

They are drawn in front of the parts, in document coordinates, and neither picked nor counted when the view is fitted.
"""

from __future__ import annotations

from dataclasses import dataclass

from pivy import coin

from .legend import unbounded
from .picture import label, set_image

AXIS_COLOURS = {"X": (0.83, 0.18, 0.16), "Y": (0.16, 0.58, 0.22), "Z": (0.12, 0.40, 0.84)}
OFFSET_COLOUR = (0.93, 0.50, 0.05)
POINT_COLOUR = (0.55, 0.15, 0.65)
TOOL_COLOUR = (0.05, 0.05, 0.05)
OUTLINE_COLOUR = (0.80, 0.10, 0.40)


@dataclass(frozen=True)
class Arrow:
    """An arrow from `start` to `end` (mm, document coordinates), or a point if they coincide.

    `text` is placed at the share `at` of the length, above and to the right (with `below`: below).
    """

    start: tuple[float, float, float]
    end: tuple[float, float, float]
    colour: tuple[float, float, float]
    text: str = ""
    at: float = 0.5
    head: bool = True
    below: bool = False


def _shaft(start, end, colour, head: bool, thickness: float):
    node = coin.SoSeparator()
    material = coin.SoMaterial()
    material.diffuseColor = colour
    material.emissiveColor = tuple(0.6 * c for c in colour)
    node.addChild(material)
    a, b = coin.SbVec3f(*start), coin.SbVec3f(*end)
    along = b - a
    length = along.length()
    if length < 1e-9:
        spot = coin.SoTranslation()
        spot.translation = a
        ball = coin.SoSphere()
        ball.radius = 2.2 * thickness
        node.addChild(spot)
        node.addChild(ball)
        return node
    move = coin.SoTransform()
    move.translation = a
    move.rotation = coin.SbRotation(coin.SbVec3f(0, 1, 0), along)
    node.addChild(move)
    tip = min(7 * thickness, 0.4 * length) if head else 0.0
    body = coin.SoTranslation()
    body.translation = (0, (length - tip) / 2, 0)
    rod = coin.SoCylinder()
    rod.radius, rod.height = thickness, length - tip
    node.addChild(body)
    node.addChild(rod)
    if head:
        up = coin.SoTranslation()
        up.translation = (0, length / 2, 0)
        cone = coin.SoCone()
        cone.bottomRadius, cone.height = 2.6 * thickness, tip
        node.addChild(up)
        node.addChild(cone)
    return node


def _text(arrow: Arrow):
    node = coin.SoSeparator()
    place = coin.SoTranslation()
    place.translation = tuple(a + (b - a) * arrow.at for a, b in zip(arrow.start, arrow.end))
    image = coin.SoImage()
    image.horAlignment = coin.SoImage.LEFT
    image.vertAlignment = coin.SoImage.TOP if arrow.below else coin.SoImage.BOTTOM
    set_image(image, label(arrow.text, arrow.colour))
    node.addChild(place)
    node.addChild(image)
    return node


class Arrows:
    """The arrows' nodes, and outlines of parts.  `root` goes into the scene graph; `show` replaces what is drawn."""

    def __init__(self):
        self.root = unbounded()
        self._note = coin.SoAnnotation()
        style = coin.SoPickStyle()
        style.style = coin.SoPickStyle.UNPICKABLE
        self._content, self._lines = coin.SoSeparator(), coin.SoSeparator()
        for child in (style, coin.SoResetTransform(), self._content):
            self._note.addChild(child)
        around = coin.SoSeparator()  # not in front: the outline of a part hides behind others as the part does
        for child in (style, coin.SoResetTransform(), self._lines):
            around.addChild(child)
        self.root.addChild(around)
        self.root.addChild(self._note)
        self.shown: tuple[Arrow, ...] = ()
        self.outlined: tuple = ()
        self._drawn: dict = {}  # (arrow, thickness) -> its nodes

    def show(self, arrows, size: float) -> None:
        """size : extent of the machine in mm, to which the thickness of the arrows is matched."""
        arrows = tuple(arrows)
        if arrows == self.shown:
            return
        self.shown = arrows
        self._content.removeAllChildren()
        thickness = max(size, 1.0) / 260
        kept, self._drawn = self._drawn, {}
        for arrow in arrows:  # what stays where it was keeps its nodes
            nodes = kept.get((arrow, thickness))
            if nodes is None:
                shaft = _shaft(arrow.start, arrow.end, arrow.colour, arrow.head, thickness)
                nodes = (shaft, _text(arrow) if arrow.text else None)
            self._drawn[arrow, thickness] = nodes
            self._content.addChild(nodes[0])
        for _, text in self._drawn.values():  # the texts last, in front of every arrow
            if text is not None:
                self._content.addChild(text)

    def outline(self, lines) -> None:
        """Draw lines, each a sequence of points (mm, document coordinates); none takes all away."""
        lines = tuple(tuple(tuple(p) for p in line) for line in lines)
        if lines == self.outlined:
            return
        self.outlined = lines
        self._lines.removeAllChildren()
        if not lines:
            return
        flat = coin.SoLightModel()
        flat.model = coin.SoLightModel.BASE_COLOR
        coordinates, shape = coin.SoCoordinate3(), coin.SoLineSet()
        points = [p for line in lines for p in line]
        coordinates.point.setValues(0, len(points), points)
        shape.numVertices.setValues(0, len(lines), [len(line) for line in lines])
        style, material = coin.SoDrawStyle(), coin.SoMaterial()
        style.lineWidth = 3.0
        material.diffuseColor = OUTLINE_COLOUR
        for child in (flat, style, material, coordinates, shape):
            self._lines.addChild(child)

    def clear(self) -> None:
        """Remove all arrows and outlines."""
        self.show((), 1.0)
        self.outline(())
