# SPDX-License-Identifier: LGPL-2.1-or-later
"""The left mouse button on what is drawn in front of the scene: it is dragged to another place, or clicked."""

from __future__ import annotations

import numpy as np
from pivy import coin

STILL = 4  # pixels that the mouse may move in a click


def _pixels(pair) -> tuple[int, int]:
    """The two numbers of Coin's vector of short integers, whose getValue() is a bare pointer in newer pivy."""
    return int(pair[0]), int(pair[1])


class Drag:
    """A picture that is dragged.  `node` goes into the scene graph.

    inside(x, y) : whether the picture is there, in pixels from the lower left.  moved(dx, dy) : pixels since the last
    call.  dropped(moved) : the button is up; false where it was only clicked.
    """

    def __init__(self, inside, moved, dropped):
        self._inside, self._moved, self._dropped = inside, moved, dropped
        self._last, self._far = None, 0
        self.node = coin.SoEventCallback()
        self.node.addEventCallback(coin.SoMouseButtonEvent.getClassTypeId(), self._button)
        self.node.addEventCallback(coin.SoLocation2Event.getClassTypeId(), self._motion)

    def _button(self, _data, node) -> None:
        event = node.getEvent()
        if event.getButton() != coin.SoMouseButtonEvent.BUTTON1:
            return
        x, y = _pixels(event.getPosition())
        if event.getState() == coin.SoButtonEvent.DOWN:
            if self._inside(x, y):
                self._last, self._far = (x, y), 0
                node.grabEvents()
                node.setHandled()
        elif self._last is not None:
            self._last = None
            node.releaseEvents()
            node.setHandled()
            self._dropped(self._far > STILL)

    def _motion(self, _data, node) -> None:
        if self._last is None:
            return
        x, y = _pixels(node.getEvent().getPosition())
        dx, dy = x - self._last[0], y - self._last[1]
        self._last, self._far = (x, y), self._far + abs(dx) + abs(dy)
        node.setHandled()
        if dx or dy:
            self._moved(dx, dy)


class Click:
    """The button goes down in the view, which is left to all others too.

    clicked(x, y, project) : pixels from the lower left; project((P, 3) points) gives (P, 3): pixels and depth.
    """

    def __init__(self, clicked):
        self._clicked = clicked
        self.node = coin.SoEventCallback()
        self.node.addEventCallback(coin.SoMouseButtonEvent.getClassTypeId(), self._button)

    def _button(self, _data, node) -> None:
        event = node.getEvent()  # FreeCAD hands on only that the button goes down: what follows is its selection
        if event.getButton() != coin.SoMouseButtonEvent.BUTTON1 or event.getState() != coin.SoButtonEvent.DOWN:
            return
        at = _pixels(event.getPosition())
        state = node.getAction().getState()
        matrix = np.array(coin.SoViewVolumeElement.get(state).getMatrix().getValue())
        width, height = _pixels(coin.SoViewportRegionElement.get(state).getViewportSizePixels())

        def project(points):
            flat = np.hstack([points, np.ones((len(points), 1))]) @ matrix
            flat = flat[:, :3] / flat[:, 3:]
            return np.column_stack([(flat[:, 0] + 1) * width / 2, (flat[:, 1] + 1) * height / 2, flat[:, 2]])

        self._clicked(at[0], at[1], project)
