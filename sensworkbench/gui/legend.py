# SPDX-License-Identifier: LGPL-2.1-or-later
"""The legend in the 3D view: title, colour bar, range, unit, ticks, what is grey.

It is part of the scene graph (an SoAnnotation with its own camera), so it appears in every view of the document and in
saved images.  It has no extent of its own: fitting the view and picking ignore it.
"""

from __future__ import annotations

import functools
import textwrap
from dataclasses import dataclass, field, replace

import FreeCAD as App
from pivy import coin

from .colormap import NO_DATA, Scale, colour
from .dragging import Drag
from .picture import blank, font, painter, plate, set_image, text_width
from .qt import Qt, QtCore, QtGui

REFERENCE_WIDTH, REFERENCE_HEIGHT = 1000.0, 760.0  # pixels of a view in which the legend has its natural size
SMALLEST = 0.75  # smaller letters cannot be read


@dataclass(frozen=True)
class LegendText:
    """Texts of the legend.  marks : (name, value) of each coloured component, shown next to the bar.

    short, note : title and last line of the small legend that narrow views have (note: what must not be left out).
    """

    title: str
    unit: str = ""
    subtitle: str = ""
    no_data: str = ""
    marks: tuple[tuple[str, float], ...] = field(default_factory=tuple)
    short: str = ""
    note: str = ""

    def narrow(self) -> LegendText:
        """The same with its title in two lines, and below it only what must not be left out."""
        title = "\n".join(textwrap.wrap(self.title, len(self.title) // 2 + 4))
        return replace(self, title=title, subtitle=self.note)

    def compact(self) -> LegendText:
        """The same in few words: symbol, bar and the first letters of the components."""
        marks = tuple((name if len(name) <= 9 else name[:8] + "…", value) for name, value in self.marks)
        return LegendText(self.short or self.title, self.unit, self.note, "", marks)


def number(value: float) -> str:
    """A number as the legend shows it: three significant digits, no exponent for usual sizes."""
    if value == 0:
        return "0"
    return f"{value:.3g}" if 1e-3 <= abs(value) < 1e5 else f"{value:.2e}"


def paint(text: LegendText, scale: Scale, size: float = 1.0):
    """The legend as a QImage; size 1 is for a view about 760 pixels high."""
    big, small = font(14 * size, bold=True), font(12 * size)
    line = QtGui.QFontMetrics(small).height()
    head = [(big, t) for t in text.title.split("\n")] + [(small, t) for t in text.subtitle.split("\n") if t]
    bar_height, bar_width, pad = 190 * size, 22 * size, 10 * size
    ticks = scale.ticks(5)
    unit = f" {text.unit}" if text.unit else ""
    labels = [number(v) + unit for v in ticks]
    left_width = max(text_width(small, t) for t in labels) + 8 * size
    marks = _spread([(scale.fraction(v), name, v) for name, v in text.marks], bar_height, line)
    right_width = max([text_width(small, f"{n}  {number(v)}") for _, _, n, v in marks], default=0) + 16 * size
    wide = [left_width + bar_width + right_width, text_width(small, text.no_data) + line]
    width = max(wide + [text_width(f, t) for f, t in head]) + 2 * pad
    head_height = sum(QtGui.QFontMetrics(f).height() for f, _ in head)
    foot = line + 8 * size if text.no_data else 0
    height = pad + head_height + line + bar_height + line * 0.7 + foot + pad * 0.6
    image = blank(width, height)
    pen = painter(image)
    plate(pen, image.width(), image.height())
    ink = QtGui.QColor(25, 32, 40)
    pen.setPen(ink)
    y = pad * 0.8
    for letters, t in head:
        pen.setFont(letters)
        h = QtGui.QFontMetrics(letters).height()
        pen.drawText(QtCore.QRectF(pad, y, width, h), Qt.AlignLeft | Qt.AlignVCenter, t)
        y += h
    top, left = y + line * 0.6, pad + left_width
    _bar(pen, QtCore.QRectF(left, top, bar_width, bar_height), scale)
    pen.setFont(small)
    for v, t in zip(ticks, labels):
        ty = top + bar_height * (1 - min(max(scale.fraction(v), 0.0), 1.0))
        pen.setPen(QtGui.QPen(ink, max(1.0, size)))
        pen.drawLine(QtCore.QPointF(left - 4 * size, ty), QtCore.QPointF(left, ty))
        pen.drawText(QtCore.QRectF(pad, ty - line / 2, left_width - 7 * size, line), Qt.AlignRight | Qt.AlignVCenter, t)
    for at, shown, name, value in marks:
        ay, sy = top + bar_height * (1 - at), top + shown
        pen.setPen(QtGui.QPen(ink, max(1.0, size)))
        pen.drawLine(QtCore.QPointF(left + bar_width, ay), QtCore.QPointF(left + bar_width + 9 * size, sy))
        pen.drawText(
            QtCore.QRectF(left + bar_width + 12 * size, sy - line / 2, right_width, line),
            Qt.AlignLeft | Qt.AlignVCenter, f"{name}  {number(value)}",
        )  # fmt: skip
    if text.no_data:
        fy = height - foot - pad * 0.3
        pen.fillRect(QtCore.QRectF(pad, fy + 2, line - 4, line - 4), QtGui.QColor.fromRgbF(*NO_DATA))
        pen.setPen(ink)
        pen.drawText(QtCore.QRectF(pad + line, fy, width, line), Qt.AlignLeft | Qt.AlignVCenter, text.no_data)
    pen.end()
    return image


def _bar(pen, box, scale: Scale) -> None:
    pen.drawImage(box, _ramp(scale.name, int(box.height()), bool(scale.upper > scale.lower)))
    pen.setPen(QtGui.QPen(QtGui.QColor(25, 32, 40), 1))
    pen.setBrush(Qt.NoBrush)
    pen.drawRect(box)


@functools.lru_cache(maxsize=16)
def _ramp(name: str, steps: int, rising: bool):
    """The colours of a bar from top to bottom, as an image one pixel wide."""
    image = QtGui.QImage(1, max(1, steps), QtGui.QImage.Format_ARGB32_Premultiplied)
    for i in range(image.height()):
        f = 1 - (i + 0.5) / image.height() if rising else 0.5
        image.setPixelColor(0, i, QtGui.QColor.fromRgbF(*colour(f, name)))
    return image


def _spread(marks, height: float, line: float):
    """(fraction, shown offset from the top, name, value), pushed apart so that the texts do not overlap."""
    known = sorted(((f, n, v) for f, n, v in marks if f is not None), reverse=True)
    places = [height * (1 - min(max(f, 0.0), 1.0)) for f, _, _ in known]
    for i in range(1, len(places)):
        places[i] = max(places[i], places[i - 1] + line)
    limit = height + line * 0.4
    for i in reversed(range(len(places))):
        places[i] = min(places[i], limit)
        limit = places[i] - line
    return [(min(max(f, 0.0), 1.0), p, n, v) for (f, n, v), p in zip(known, places)]


def unbounded():
    """A group whose content has no extent: fitting the view ignores it."""
    kind = coin.SoType.fromName("SoSkipBoundingGroup")
    return kind.createInstance() if not kind.isBad() else coin.SoGroup()


class Legend:
    """The legend's nodes.  `root` goes into the scene graph; `show` fills it, `hide` empties it.

    It is dragged with the left mouse button, and a click puts it back into its corner.  offset : how far it was
    dragged, in halves of the view's width and height.  placed(offset) : called when it was dragged or put back.

    `paint` may be another function of (text, scale, size); its text then has `marks` and `compact()` too.
    """

    paint = staticmethod(paint)

    def __init__(self):
        self._content = None
        self._size = None
        self._pixels = (int(REFERENCE_WIDTH), int(REFERENCE_HEIGHT))
        self._painted = None
        self.root = unbounded()
        note = coin.SoAnnotation()
        note.renderCaching = coin.SoSeparator.OFF
        style = coin.SoPickStyle()
        style.style = coin.SoPickStyle.UNPICKABLE
        note.addChild(style)
        note.addChild(coin.SoResetTransform())
        camera = coin.SoOrthographicCamera()
        camera.viewportMapping = coin.SoCamera.LEAVE_ALONE
        camera.position = (0, 0, 1)
        camera.height = 2.0
        camera.nearDistance, camera.farDistance = 0.1, 10.0
        note.addChild(camera)
        # the view's size is only known while it is drawn; a saved image may be larger than the window
        self._watch = coin.SoCallback()
        self._watch.setCallback(self._drawn, None)
        note.addChild(self._watch)
        place = coin.SoTranslation()
        place.translation = (-0.975, 0.93, 0)
        note.addChild(place)
        self._image = coin.SoImage()
        self._image.horAlignment = coin.SoImage.LEFT
        self._image.vertAlignment = coin.SoImage.TOP
        self._switch = coin.SoSwitch()
        self._switch.whichChild = coin.SO_SWITCH_NONE
        self._switch.addChild(self._image)
        note.addChild(self._switch)
        self._place = place
        self._drag = Drag(self._inside, self._moved, self._dropped)
        note.addChild(self._drag.node)
        self.root.addChild(note)
        self.offset, self.placed = (0.0, 0.0), None

    @property
    def shown(self) -> bool:
        """Whether the legend is visible."""
        return self._content is not None

    def show(self, text: LegendText, scale: Scale, corner: str = "Upper left") -> None:
        """Show the legend of a scale in a corner of the view."""
        if (text, scale, corner) == self._content:
            return
        self._content = (text, scale, corner)
        right, low = "right" in corner, "Lower" in corner
        self._image.horAlignment = coin.SoImage.RIGHT if right else coin.SoImage.LEFT
        self._image.vertAlignment = coin.SoImage.BOTTOM if low else coin.SoImage.TOP
        self._repaint()
        self._switch.whichChild = 0

    def hide(self) -> None:
        """Hide the legend."""
        self._content = None
        self._switch.whichChild = coin.SO_SWITCH_NONE

    def _repaint(self) -> None:
        """Paint for the size of the view: as large as it may be without covering a third of it in width."""
        text, scale, corner = self._content
        width, height = self._pixels
        fit = min(width / REFERENCE_WIDTH, height / REFERENCE_HEIGHT)
        self._size = min(max(round(fit * 8) / 8, SMALLEST), 6.0)
        image = self.paint(text, scale, self._size)
        for smaller in (getattr(text, "narrow", text.compact), text.compact):
            if image.width() > width / 3:
                image = self.paint(smaller(), scale, self._size)
        if image.width() > width / 3:
            image = self.paint(replace(text.compact(), marks=()), scale, self._size)
        set_image(self._image, image)
        self.covers = (image.width(), image.height())
        below = 2 * _cube(corner) / height
        right, low = "right" in corner, "Lower" in corner
        self._corner = (0.975 if right else -0.975, -0.93 + below if low else 0.93 - below)
        self._put()
        self._painted = (self._content, self._pixels)

    def _put(self) -> None:
        """Place the picture, no part of it outside the view."""
        (width, height), (wide, high) = self._pixels, self.covers
        right, low = "right" in self._content[2], "Lower" in self._content[2]
        wide, high = 2 * wide / width, 2 * high / height
        x, y = (c + d for c, d in zip(self._corner, self.offset))
        x = max(min(x, 1.0), wide - 1.0) if right else min(max(x, -1.0), 1.0 - wide)
        y = min(max(y, -1.0), 1.0 - high) if low else max(min(y, 1.0), high - 1.0)
        self._place.translation = (x, y, 0)

    def drag_to(self, offset: tuple[float, float]) -> None:
        """Stand so far from the corner, in halves of the view's width and height."""
        if tuple(offset) != self.offset:
            self.offset = (float(offset[0]), float(offset[1]))
            if self._content is not None and self._painted is not None:
                self._put()

    def box(self) -> tuple[float, float, float, float]:
        """Left, lower, right and upper edge in the view, pixels from its lower left."""
        (width, height), (wide, high) = self._pixels, self.covers
        x, y, _ = self._place.translation.getValue().getValue()
        x, y = (x + 1) * width / 2, (y + 1) * height / 2
        left = x - wide if "right" in self._content[2] else x
        low = y if "Lower" in self._content[2] else y - high
        return left, low, left + wide, low + high

    def _inside(self, x: float, y: float) -> bool:
        if self._content is None or self._painted is None:
            return False
        left, low, right, high = self.box()
        return left <= x <= right and low <= y <= high

    def _moved(self, dx: float, dy: float) -> None:
        width, height = self._pixels
        self.drag_to((self.offset[0] + 2 * dx / width, self.offset[1] + 2 * dy / height))

    def _dropped(self, moved: bool) -> None:
        if moved:  # what was dragged past the edge stays at the edge
            x, y, _ = self._place.translation.getValue().getValue()
            self.offset = (x - self._corner[0], y - self._corner[1])
        else:
            self.drag_to((0.0, 0.0))
        if self.placed is not None:
            self.placed(self.offset)

    def _drawn(self, _data, action) -> None:
        """Called while the scene is traversed: fit the picture to the size of the view or of the saved image."""
        if self._content is None or not action.isOfType(coin.SoGLRenderAction.getClassTypeId()):
            return
        found = coin.SoViewportRegionElement.get(action.getState()).getViewportSizePixels()
        self._pixels = (int(found[0]), int(found[1]))
        if self._painted != (self._content, self._pixels):
            nodes = (self._image, self._place)
            notify = [node.enableNotify(False) for node in nodes]
            self._repaint()
            for node, value in zip(nodes, notify):
                node.enableNotify(value)


def _cube(corner: str) -> float:
    """Return the pixels that FreeCAD's navigation cube takes in a corner of the view, 0 if it is in another corner."""
    group = App.ParamGet("User parameter:BaseApp/Preferences/NaviCube")
    shown = App.ParamGet("User parameter:BaseApp/Preferences/View").GetBool("ShowNaviCube", True)
    where = ("Upper left", "Upper right", "Lower left", "Lower right")[group.GetInt("CornerNaviCube", 1) % 4]
    return 1.2 * group.GetInt("CubeSize", 132) if shown and where == corner else 0.0
