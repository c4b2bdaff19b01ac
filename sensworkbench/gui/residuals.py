# SPDX-License-Identifier: LGPL-2.1-or-later
"""Residuals of the readings as arrows in the workspace, before and after, on one scale; view providers of readings and
traces.

Each arrow begins where the functional point is relative to the workpiece; a key gives its length in µm.  View provider
names are stored in users' files and must not change; what is shown is a view property, so it is saved and undone.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from pivy import coin

from ..core.refusal import Refused
from ..document import closed_loop, extract, tree
from .arrows import Arrow, Arrows
from .legend import Legend
from .looks import CORNERS
from .picture import blank, font, painter, plate, text_width
from .plots import AFTER, BEFORE
from .qt import Qt, QtCore, QtGui, later, translate
from .viewprovider_base import ViewProviderSens

OFF, SHOW_BEFORE, SHOW_AFTER, BOTH = "Off", "Before", "After", "Before and after"
CHOICES = (OFF, SHOW_BEFORE, SHOW_AFTER, BOTH)
LIMIT = 500  # arrows of a kind at most, evenly chosen
LONGEST = 0.35  # of the extent of the places: the longest arrow
_SIDES = 8


# -- geometry ----------------------------------------------------------------------------------------------------------
def places(core, q, tool_offset=None) -> np.ndarray:
    """(P, 3) mm, document coordinates: the functional point relative to the workpiece at positions q (P, n)."""
    return core.tool_position(q, None if tool_offset is None or not len(tool_offset) else tool_offset)


def mesh(starts, ends, thickness: float) -> tuple[np.ndarray, np.ndarray]:
    """Vertices (V, 3) and face indices (-1 ends a face) of arrows from `starts` to `ends`, (N, 3) mm each."""
    along = ends - starts
    length = np.linalg.norm(along, axis=1)
    keep = length > 1e-9
    starts, along, length = starts[keep], along[keep], length[keep, None]
    if not len(starts):
        return np.zeros((0, 3)), np.zeros(0, dtype=int)
    d = along / length
    other = np.where(np.abs(d[:, [2]]) < 0.9, [[0.0, 0.0, 1.0]], [[1.0, 0.0, 0.0]])
    u = np.cross(d, other)
    u /= np.linalg.norm(u, axis=1, keepdims=True)
    v = np.cross(d, u)
    angle = 2 * np.pi * np.arange(_SIDES) / _SIDES
    ring = u[:, None] * np.cos(angle)[None, :, None] + v[:, None] * np.sin(angle)[None, :, None]
    thin = np.minimum(thickness, length / 8)[:, None]
    neck = starts + d * (length - np.minimum(8 * thickness, 0.45 * length))
    parts = [starts[:, None] + thin * ring, neck[:, None] + thin * ring, neck[:, None] + 2.8 * thin * ring]
    points = np.concatenate([*parts, (starts + along)[:, None]], axis=1)
    i, k = np.arange(_SIDES), (np.arange(_SIDES) + 1) % _SIDES
    end, tip = np.full(_SIDES, -1), np.full(_SIDES, 3 * _SIDES)
    shaft = np.stack([i, k, k + _SIDES, i + _SIDES, end], axis=1)
    head = np.stack([i + 2 * _SIDES, k + 2 * _SIDES, tip, end], axis=1)
    back = np.append(i[::-1] + 2 * _SIDES, -1)
    one = np.concatenate([shaft.ravel(), head.ravel(), back])
    shift = (np.arange(len(points)) * points.shape[1])[:, None]
    faces = np.where(one[None, :] < 0, -1, one[None, :] + shift)
    return points.reshape(-1, 3), faces.ravel()


def round_length(value: float) -> float:
    """The largest of 1, 2, 5 times a power of ten that is not above `value`."""
    if not value > 0:
        return 0.0
    power = 10.0 ** np.floor(np.log10(value))
    return float(max(m * power for m in (1, 2, 5) if m * power <= value * (1 + 1e-9)))


@dataclass(frozen=True)
class Series:
    """One set of residuals as the key lists it."""

    name: str
    colour: tuple[float, float, float]
    rms: float
    largest: float


@dataclass(frozen=True)
class Key:
    """Texts of the key: title, scale in words, the series."""

    title: str
    lines: tuple[str, ...]
    series: tuple[Series, ...]
    short: bool = False
    marks: tuple = ()

    def compact(self) -> Key:
        """The same for a narrow view: the largest values and the scale in words are left out."""
        return replace(self, lines=(), short=True)


def paint_key(key: Key, size: float = 1.0):
    """The key as a QImage; size 1 is for a view about 760 pixels high."""
    big, small = font(14 * size, bold=True), font(12 * size)
    line = QtGui.QFontMetrics(small).height() * 1.15
    words = translate("Sens", "{name}: rms {rms} µm, largest {largest} µm")
    if key.short:
        words = translate("Sens", "{name}: rms {rms} µm")
    texts = [words.format(name=s.name, rms=f"{s.rms:.3g}", largest=f"{s.largest:.3g}") for s in key.series]
    pad, mark = 10 * size, 34 * size
    wide = [text_width(big, key.title)] + [text_width(small, t) + mark for t in texts]
    width = max(wide + [text_width(small, t) for t in key.lines]) + 2 * pad
    title = QtGui.QFontMetrics(big).height() * 1.15
    height = title + line * (len(texts) + len(key.lines)) + 1.6 * pad
    image = blank(width, height)
    pen = painter(image)
    plate(pen, image.width(), image.height())
    ink = QtGui.QColor(25, 32, 40)
    pen.setPen(ink)
    pen.setFont(big)
    y = 0.7 * pad
    pen.drawText(QtCore.QRectF(pad, y, width, title), Qt.AlignLeft | Qt.AlignVCenter, key.title)
    y += title
    pen.setFont(small)
    for s, text in zip(key.series, texts):
        middle, shade = y + line / 2, QtGui.QColor.fromRgbF(*s.colour)
        pen.setPen(QtGui.QPen(shade, 2.5 * size))
        pen.drawLine(QtCore.QPointF(pad, middle), QtCore.QPointF(pad + 16 * size, middle))
        pen.setPen(Qt.NoPen)
        pen.setBrush(shade)
        tip = [(pad + 15 * size, -4.5 * size), (pad + 26 * size, 0.0), (pad + 15 * size, 4.5 * size)]
        pen.drawPolygon(QtGui.QPolygonF([QtCore.QPointF(x, middle + dy) for x, dy in tip]))
        pen.setPen(ink)
        pen.drawText(QtCore.QRectF(pad + mark, y, width, line), Qt.AlignLeft | Qt.AlignVCenter, text)
        y += line
    for text in key.lines:
        pen.drawText(QtCore.QRectF(pad, y, width, line), Qt.AlignLeft | Qt.AlignVCenter, text)
        y += line
    pen.end()
    return image


class _KeyLegend(Legend):
    """The legend's place and size in the view, with the key painted in it."""

    paint = staticmethod(lambda key, scale, size: paint_key(key, size))


class ResidualArrows:
    """The arrows' nodes.  `root` goes into the scene graph; `show` fills it, `hide` empties it."""

    def __init__(self):
        self.root = coin.SoGroup()
        note = coin.SoAnnotation()
        style = coin.SoPickStyle()
        style.style = coin.SoPickStyle.UNPICKABLE
        flat = coin.SoLightModel()
        flat.model = coin.SoLightModel.BASE_COLOR
        self._content = coin.SoSeparator()
        for child in (style, coin.SoResetTransform(), flat, self._content):
            note.addChild(child)
        self.root.addChild(note)  # with an extent, so that the view can be fitted to a selected trace
        self.reference = Arrows()
        self.root.addChild(self.reference.root)
        self.key = _KeyLegend()
        self.root.addChild(self.key.root)
        self.counts: dict[str, int] = {}

    def hide(self) -> None:
        """Remove the arrows and their key."""
        self._content.removeAllChildren()
        self.reference.clear()
        self.key.hide()
        self.counts = {}

    def show(self, where, vectors: dict[str, np.ndarray], what: str, directions, corner: str) -> None:
        """where (P, 3) mm, vectors: "Before", "After" -> (P, 3) um, both in document coordinates; what: of CHOICES.

        directions : (3, 3) unit vectors of X, Y, Z as rows, along the first of which the reference arrow lies.
        """
        self._content.removeAllChildren()
        self.counts = {}
        pick = np.unique(np.linspace(0, len(where) - 1, min(LIMIT, len(where))).round().astype(int))
        span = float(np.ptp(where, axis=0).max()) or 1.0
        longest = max(float(np.linalg.norm(v, axis=1).max(initial=0.0)) for v in vectors.values()) or 1.0
        scale = LONGEST * span / longest  # mm in the view per um, the same for both
        thickness = span / 170
        series = []
        names = {SHOW_BEFORE: translate("Sens", "Declared errors corrected"),
                 SHOW_AFTER: translate("Sens", "With the found effects")}  # fmt: skip
        for kind, colour in ((SHOW_BEFORE, BEFORE), (SHOW_AFTER, AFTER)):
            if what not in (kind, BOTH):
                continue
            points, faces = mesh(where[pick], where[pick] + scale * vectors[kind][pick], thickness)
            if len(points):
                self._content.addChild(_faces(points, faces, colour))
            size = np.linalg.norm(vectors[kind], axis=1)
            size = size[size > 0]
            self.counts[kind] = int((np.linalg.norm(vectors[kind][pick], axis=1) > 0).sum())
            rms = float(np.sqrt((size**2).mean())) if len(size) else 0.0
            series.append(Series(names[kind], colour, rms, float(size.max(initial=0.0))))
        reference = round_length(longest)
        start = _corner(where, directions)
        end = start + directions[0] * scale * reference
        ink = (0.72, 0.10, 0.45)
        text = f"{reference:g} µm"
        self.reference.show([Arrow(tuple(start.tolist()), tuple(end.tolist()), ink, text, 1.0)], span * 1.6)
        lines = [translate("Sens", "Arrows {times} times as long as the error").format(times=_thousands(scale * 1e3))]
        shown = max(self.counts.values(), default=0)
        if shown < len(where):
            lines.append(translate("Sens", "{shown} of {all} places").format(shown=shown, all=len(where)))
        title = translate("Sens", "Residual of held-out readings")
        self.key.show(Key(title, tuple(lines), tuple(series)), None, corner)


def _thousands(value: float) -> str:
    return f"{float(f'{value:.2g}'):,.0f}".replace(",", " ")


def _corner(where, directions) -> np.ndarray:
    """The corner of the places' box where all three axes are lowest, a little outside."""
    local = where @ np.linalg.inv(directions)
    low = local.min(axis=0) - 0.06 * np.ptp(local, axis=0)
    return low @ directions


def _faces(points, faces, colour):
    node = coin.SoSeparator()
    hints = coin.SoShapeHints()
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    material = coin.SoMaterial()
    material.diffuseColor = colour
    coordinates = coin.SoCoordinate3()
    coordinates.point.setValues(0, len(points), points.tolist())
    shape = coin.SoIndexedFaceSet()
    shape.coordIndex.setValues(0, len(faces), faces.tolist())
    for child in (hints, material, coordinates, shape):
        node.addChild(child)
    return node


# -- in the tree -------------------------------------------------------------------------------------------------------
class ViewProviderReadings(ViewProviderSens):
    """Imported readings: a double click opens the fit."""

    icon = "Sens_ImportReadings"


class ViewProviderTrace(ViewProviderSens):
    """View of a trace: a double click opens its panel; its view properties choose which residuals are drawn."""

    icon = "Sens_Trace"

    def __init__(self, vobj):
        super().__init__(vobj)
        self.declare(vobj)

    def declare(self, vobj):
        """Add the view properties that a trace of an earlier version lacks."""
        for name, tip, choices, value in (
            ("ShowResiduals", "Residuals of the readings as arrows in the workspace", CHOICES, OFF),
            ("KeyCorner", "Where the key stands", CORNERS, "Lower left"),
        ):
            if not hasattr(vobj, name):
                vobj.addProperty("App::PropertyEnumeration", name, "Residuals", tip)
                setattr(vobj, name, list(choices))
                setattr(vobj, name, value)

    def attach(self, vobj):
        super().attach(vobj)
        self.arrows = ResidualArrows()
        self._waiting = False
        vobj.addDisplayMode(self.arrows.root, "Residuals")
        self.schedule()

    def getDisplayModes(self, vobj):
        return ["Residuals"]

    def getDefaultDisplayMode(self):
        return "Residuals"

    def setDisplayMode(self, mode):
        return mode

    def updateData(self, obj, prop):
        if prop in ("Before", "After", "Positions"):
            self.schedule()

    def onChanged(self, vobj, prop):
        if prop in ("ShowResiduals", "KeyCorner", "Visibility"):
            self.schedule()

    def schedule(self):
        """Draw once the present change is over."""
        if not getattr(self, "_waiting", False):
            self._waiting = True
            later(self._update)

    def _update(self):
        self._waiting = False
        obj = self.object
        if obj is not None and obj.ViewObject is not None:
            update(obj)


PROVIDERS = {"Readings": ViewProviderReadings, "Trace": ViewProviderTrace}


def dress(obj, kind: str) -> None:
    """Give a Readings or Trace object its view provider where it has none."""
    view = obj.ViewObject
    if not isinstance(getattr(view, "Proxy", None), ViewProviderSens):
        PROVIDERS[kind](view)
    elif kind == "Trace":
        view.Proxy.declare(view)


def update(obj) -> None:
    """Draw the residuals of a trace according to its view property."""
    view = obj.ViewObject
    proxy = view.Proxy
    if not isinstance(proxy, ViewProviderTrace) or not hasattr(view, "ShowResiduals"):
        return
    machine = tree.owner_machine(obj)
    if machine is None or view.ShowResiduals == OFF or not len(obj.Positions) or not view.Visibility:
        proxy.arrows.hide()
        return
    try:
        core = extract.core_machine(machine)
    except Refused:  # the machine's Problem says what is wrong
        proxy.arrows.hide()
        return
    rows = {name: np.array([tuple(v) for v in getattr(obj, name)]) for name in ("Before", "After")}
    where = places(core, *closed_loop.positions_of(obj))
    vectors = {name: rows[name] @ core.frame.T for name in (SHOW_BEFORE, SHOW_AFTER)}
    directions = core.frame.T
    proxy.arrows.show(where, vectors, view.ShowResiduals, directions, view.KeyCorner)
