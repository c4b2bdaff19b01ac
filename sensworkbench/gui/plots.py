# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small charts painted by Qt for the trace panel: residual against its driver, and histograms before and after.

They need no plotting library, follow the window's colours and are as wide as the panel.
"""

from __future__ import annotations

import numpy as np

from .picture import blank, font, painter, text_width
from .qt import Qt, QtCore, QtGui

BEFORE, AFTER, FITTED = (0.88, 0.45, 0.12), (0.16, 0.47, 0.77), (0.75, 0.16, 0.20)
_LEFT, _RIGHT, _TOP, _BOTTOM = 50, 10, 24, 36


def ticks(low: float, high: float, count: int = 5) -> list[float]:
    """About `count` round numbers from `low` to `high`."""
    span = high - low
    if not span > 0 or not np.isfinite(span):
        return [low]
    step = 10.0 ** np.floor(np.log10(span / count))
    step *= next((m for m in (1, 2, 5) if span / (step * m) <= count), 10)
    first = np.ceil(low / step - 1e-9)
    last = np.floor(high / step + 1e-9)
    return [float(step * k) + 0.0 for k in np.arange(first, last + 1)]


class Plot:
    """A frame with axes; colours are those of `palette`.  Coordinates are data units."""

    def __init__(self, width: int, height: int, xlim, ylim, xlabel: str, ylabel: str, palette, legend=()):
        self.image = blank(width, height)
        self.pen = painter(self.image)
        self.ink = palette.color(QtGui.QPalette.Text)
        self.xlim, self.ylim = _widened(*xlim), _widened(*ylim)
        self.box = QtCore.QRectF(_LEFT, _TOP, width - _LEFT - _RIGHT, height - _TOP - _BOTTOM)
        self._axes(xlabel, ylabel)
        self._legend(legend)

    def at(self, x, y):
        """Return the point of the image (pixels) at x, y of the axes."""
        (x0, x1), (y0, y1) = self.xlim, self.ylim
        return QtCore.QPointF(
            self.box.left() + self.box.width() * (x - x0) / (x1 - x0),
            self.box.bottom() - self.box.height() * (y - y0) / (y1 - y0),
        )

    def _axes(self, xlabel, ylabel):
        pen, box = self.pen, self.box
        letters = font(11)
        pen.setFont(letters)
        faint = QtGui.QColor(self.ink)
        faint.setAlpha(40)
        for value in ticks(*self.xlim, count=max(2, int(box.width() // 60))):
            p = self.at(value, self.ylim[0])
            pen.setPen(QtGui.QPen(faint, 1))
            pen.drawLine(p, QtCore.QPointF(p.x(), box.top()))
            pen.setPen(self.ink)
            pen.drawText(QtCore.QRectF(p.x() - 40, box.bottom() + 2, 80, 15), Qt.AlignCenter, f"{value:.4g}")
        for value in ticks(*self.ylim, count=4):
            p = self.at(self.xlim[0], value)
            pen.setPen(QtGui.QPen(faint, 1))
            pen.drawLine(p, QtCore.QPointF(box.right(), p.y()))
            pen.setPen(self.ink)
            pen.drawText(QtCore.QRectF(0, p.y() - 8, _LEFT - 5, 16), Qt.AlignRight | Qt.AlignVCenter, f"{value:.4g}")
        pen.setPen(QtGui.QPen(self.ink, 1))
        pen.setBrush(Qt.NoBrush)
        pen.drawRect(box)
        pen.drawText(QtCore.QRectF(box.left(), box.bottom() + 17, box.width(), 17), Qt.AlignCenter, xlabel)
        pen.drawText(QtCore.QRectF(2, 2, box.width(), 17), Qt.AlignLeft | Qt.AlignVCenter, ylabel)

    def _legend(self, entries):
        letters = font(11)
        self.pen.setFont(letters)
        x = self.box.right()
        for name, colour in reversed(list(entries)):
            width = text_width(letters, name)
            x -= width
            self.pen.setPen(self.ink)
            self.pen.drawText(QtCore.QRectF(x, 2, width, 17), Qt.AlignLeft | Qt.AlignVCenter, name)
            x -= 14
            self.pen.fillRect(QtCore.QRectF(x, 6, 10, 10), QtGui.QColor.fromRgbF(*colour))
            x -= 10

    def dots(self, x, y, colour, size: float = 3.0):
        """Draw a point at every (x, y)."""
        shade = QtGui.QColor.fromRgbF(*colour)
        shade.setAlpha(150)
        self.pen.setPen(Qt.NoPen)
        self.pen.setBrush(shade)
        for a, b in zip(np.asarray(x).tolist(), np.asarray(y).tolist()):
            self.pen.drawEllipse(self.at(a, b), size / 2, size / 2)

    def line(self, x, y, colour, width: float = 2.0):
        """Draw a line through the points (x, y)."""
        self.pen.setPen(QtGui.QPen(QtGui.QColor.fromRgbF(*colour), width))
        self.pen.setBrush(Qt.NoBrush)
        self.pen.drawPolyline(
            QtGui.QPolygonF([self.at(a, b) for a, b in zip(np.asarray(x).tolist(), np.asarray(y).tolist())])
        )

    def steps(self, edges, counts, colour):
        """A histogram as a filled step."""
        points = [self.at(edges[0], 0.0)]
        for low, high, count in zip(edges[:-1].tolist(), edges[1:].tolist(), counts.tolist()):
            points += [self.at(low, count), self.at(high, count)]
        points.append(self.at(edges[-1], 0.0))
        shade = QtGui.QColor.fromRgbF(*colour)
        self.pen.setPen(QtGui.QPen(shade, 1.6))
        shade = QtGui.QColor(shade)
        shade.setAlpha(70)
        self.pen.setBrush(shade)
        self.pen.drawPolygon(QtGui.QPolygonF(points))

    def done(self):
        """Finish drawing; return the image."""
        self.pen.end()
        return self.image


def _widened(low: float, high: float) -> tuple[float, float]:
    if not (np.isfinite(low) and np.isfinite(high)):
        return 0.0, 1.0
    margin = 0.04 * (high - low) or 0.5 * abs(low) or 1.0
    return (low if low == 0 else low - margin), high + margin


def histogram(width, before, after, names, xlabel, ylabel, palette):
    """Sizes before and after, (P,) each, over common bins; a QImage."""
    top = float(max(before.max(initial=0.0), after.max(initial=0.0))) or 1.0
    edges = np.linspace(0.0, top, 31)
    counts = [np.histogram(v, edges)[0] for v in (before, after)]
    highest = float(max(c.max() for c in counts)) or 1.0
    legend = list(zip(names, (BEFORE, AFTER)))
    plot = Plot(width, 190, (0.0, top), (0.0, highest), xlabel, ylabel, palette, legend)
    for count, colour in zip(counts, (BEFORE, AFTER)):
        plot.steps(edges, count, colour)
    return plot.done()


def driver(width, x, asked, fitted, single_valued: bool, names, xlabel, ylabel, palette, limit: int = 3000):
    """What the readings ask of a component against its driver, and the effect as fitted; a QImage.

    x, asked, fitted : (P,).  single_valued : the effect is a function of x, so it is drawn as a line.
    """
    pick = np.unique(np.linspace(0, len(x) - 1, min(limit, len(x))).round().astype(int))
    x, asked, fitted = x[pick], asked[pick], fitted[pick]
    low, high = np.percentile(asked, [0.5, 99.5])
    values = np.concatenate([fitted, [low, high]])
    legend = list(zip(names, (BEFORE, FITTED)))
    plot = Plot(
        width, 220, (float(x.min()), float(x.max())), (float(values.min()), float(values.max())), xlabel, ylabel,
        palette, legend,
    )  # fmt: skip
    plot.pen.setClipRect(plot.box)
    plot.dots(x, asked, BEFORE)
    if single_valued:
        order = np.argsort(x, kind="stable")
        plot.line(x[order], fitted[order], FITTED)
    else:
        plot.dots(x, fitted, FITTED)
    return plot.done()


def parallel(width: int, height: int, names, rows, marked, chosen, legend, palette, most: int = 600):
    """Parallel coordinates: one line per row over one upright axis per name, each on its own scale; a QImage.

    rows : (P, n) numbers.  marked, chosen : (P,) whether a row is drawn on top, in a second or third colour.  legend :
    the three words.  Of rows that are neither at most `most` are drawn, evenly chosen.
    """
    rows, marked, chosen = np.asarray(rows, dtype=float), np.asarray(marked, bool), np.asarray(chosen, bool)
    image = blank(width, height)
    pen = painter(image)
    letters = font(11)
    pen.setFont(letters)
    ink = palette.color(QtGui.QPalette.Text)
    line = QtGui.QFontMetrics(letters).height()
    low, high = rows.min(axis=0), rows.max(axis=0)
    span = np.where(high > low, high - low, 1.0)
    share = np.where(high > low, (rows - low) / span, 0.5)
    edge = 34.0
    x = np.linspace(edge, width - edge, len(names)) if len(names) > 1 else np.array([width / 2])
    top, bottom = 2.4 * line + 4, height - 3.2 * line - 4
    plain = np.flatnonzero(~(marked | chosen))
    plain = (
        plain[np.unique(np.linspace(0, len(plain) - 1, min(most, len(plain))).round().astype(int))]
        if len(plain)
        else plain
    )

    def draw(which, colour, alpha, thick):
        shade = QtGui.QColor.fromRgbF(*colour)
        shade.setAlpha(alpha)
        pen.setPen(QtGui.QPen(shade, thick))
        for row in which:
            y = bottom - (bottom - top) * share[row]
            pen.drawPolyline(QtGui.QPolygonF([QtCore.QPointF(a, b) for a, b in zip(x.tolist(), y.tolist())]))

    draw(plain, AFTER, 70, 1.0)
    draw(np.flatnonzero(marked & ~chosen), BEFORE, 220, 1.8)
    draw(np.flatnonzero(chosen), FITTED, 255, 2.6)
    gap = float(x[1] - x[0]) if len(x) > 1 else float(width)
    for i, name in enumerate(names):
        pen.setPen(QtGui.QPen(ink, 1))
        pen.drawLine(QtCore.QPointF(x[i], top), QtCore.QPointF(x[i], bottom))
        box = QtCore.QRectF(x[i] - gap / 2, top - line - 1, gap, line)
        pen.drawText(box, Qt.AlignCenter, f"{high[i]:.4g}")
        pen.drawText(box.translated(0, bottom - top + line + 2), Qt.AlignCenter, f"{low[i]:.4g}")
        wide = min(1.9 * gap, width - 4.0)
        left = min(max(x[i] - wide / 2, 2.0), width - wide - 2)
        below = QtCore.QRectF(left, bottom + line * (1.15 + i % 2), wide, line)  # two lines, so that names have room
        cut = QtGui.QFontMetrics(letters).elidedText(name, Qt.ElideLeft, int(wide))
        pen.drawText(below, Qt.AlignCenter, cut)
    at = 4.0
    for word, colour, there in zip(legend, (AFTER, BEFORE, FITTED), (True, marked.any(), chosen.any())):
        if there:
            pen.fillRect(QtCore.QRectF(at, 5, 10, 10), QtGui.QColor.fromRgbF(*colour))
            pen.setPen(ink)
            pen.drawText(QtCore.QRectF(at + 14, 0, 200, line + 4), Qt.AlignLeft | Qt.AlignVCenter, word)
            at += 26 + text_width(letters, word)
    pen.end()
    return image


def dots_table(width: int, height: int, rows, columns, sizes, marked, unit: str, palette):
    """Which row has which column: a dot whose area is the size, with the number beside it; a QImage.

    rows, columns : names.  sizes : (rows, columns), None where there is nothing.  marked : (columns) drawn in a second
    colour.  unit : of the sizes.  Rows that have no room are counted in the last line.
    """
    image = blank(width, height)
    pen = painter(image)
    letters = font(11)
    pen.setFont(letters)
    ink = palette.color(QtGui.QPalette.Text)
    metrics = QtGui.QFontMetrics(letters)
    line = metrics.height()
    left = min(0.35 * width, max([text_width(letters, r) for r in rows], default=0) + 10.0)
    gap = (width - left) / max(1, len(columns))
    top = line * (2.3 if len(columns) > 2 else 1.3) + 6
    step = max(line + 4.0, min(34.0, (height - top - 4) / max(1, len(rows))))
    room = int((height - top) // step)
    shown = rows if len(rows) <= room else rows[: max(1, room - 1)]
    largest = max((v for row in sizes for v in row if v is not None), default=1.0)
    faint = QtGui.QColor(ink)
    faint.setAlpha(40)
    pen.setPen(ink)
    for j, name in enumerate(columns):
        wide = gap * (1.9 if len(columns) > 2 else 1.0)
        at = min(max(left + gap * (j + 0.5) - wide / 2, left - 20), width - wide)
        box = QtCore.QRectF(at, 3 + line * (j % 2 if len(columns) > 2 else 0), wide, line)
        pen.drawText(box, Qt.AlignCenter, metrics.elidedText(name, Qt.ElideRight, int(wide)))
    for i, name in enumerate(shown):
        y = top + step * (i + 0.5)
        pen.setPen(QtGui.QPen(faint, 1))
        pen.drawLine(QtCore.QPointF(left, y), QtCore.QPointF(width, y))
        pen.setPen(ink)
        cut = metrics.elidedText(name, Qt.ElideMiddle, int(left) - 8)
        pen.drawText(QtCore.QRectF(2, y - line / 2, left - 8, line), Qt.AlignLeft | Qt.AlignVCenter, cut)
        for j, size in enumerate(sizes[i]):
            if size is None:
                continue
            radius = max(2.5, 0.42 * min(step, gap / 2) * np.sqrt(size / largest))
            x = left + gap * (j + 0.3)
            pen.setPen(Qt.NoPen)
            pen.setBrush(QtGui.QColor.fromRgbF(*(FITTED if marked[j] else AFTER)))
            pen.drawEllipse(QtCore.QPointF(x, y), radius, radius)
            pen.setPen(ink)
            box = QtCore.QRectF(x + radius + 4, y - line / 2, gap, line)
            pen.drawText(box, Qt.AlignLeft | Qt.AlignVCenter, f"{size:.2g} {unit}" if gap > 70 else f"{size:.2g}")
    if len(shown) < len(rows):
        pen.drawText(QtCore.QRectF(2, height - line - 2, width, line), Qt.AlignLeft, f"… + {len(rows) - len(shown)}")
    pen.end()
    return image
