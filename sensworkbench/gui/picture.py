# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small pictures painted by Qt and put into the 3D scene: the legend and the labels of arrows.

Qt paints any script crisply; Coin's SoImage shows it pixel for pixel, in the window and in saved images alike.
"""

from __future__ import annotations

from pivy import coin

from .qt import QtCore, QtGui


def set_image(node, image) -> None:
    """Put a QImage into an SoImage (or SoTexture2) node."""
    upright = QtGui.QTransform().scale(1, -1)  # Coin counts rows from below
    picture = image.transformed(upright).convertToFormat(QtGui.QImage.Format_RGBA8888)
    width, height = picture.width(), picture.height()
    node.image.setValue(coin.SbVec2s(width, height), 4, bytes(picture.constBits())[: 4 * width * height])


def blank(width: float, height: float):
    """Return a transparent image of this size, pixels."""
    image = QtGui.QImage(max(1, int(width)), max(1, int(height)), QtGui.QImage.Format_ARGB32_Premultiplied)
    image.fill(0)
    return image


def font(pixels: float, *, bold: bool = False):
    """Return the application's font at a height in pixels."""
    found = QtGui.QFont(QtGui.QApplication.font())
    found.setPixelSize(max(6, int(round(pixels))))
    found.setBold(bold)
    return found


def text_width(letters, text: str) -> int:
    """Width in pixels; Qt 5 and 6 name it differently from older ones, this one they share."""
    return QtGui.QFontMetrics(letters).boundingRect(text).width() + 2


def painter(image):
    """Return a painter on an image, with smooth lines and text."""
    pen = QtGui.QPainter(image)
    pen.setRenderHint(QtGui.QPainter.Antialiasing, True)
    pen.setRenderHint(QtGui.QPainter.TextAntialiasing, True)
    return pen


def plate(pen, width: float, height: float) -> None:
    """Draw a pale rounded plate with a thin edge; text on it is readable on light and on dark backgrounds."""
    pen.setPen(QtGui.QPen(QtGui.QColor(70, 80, 90, 200), 1))
    pen.setBrush(QtGui.QColor(250, 251, 252, 235))
    pen.drawRoundedRect(QtCore.QRectF(0.5, 0.5, width - 1, height - 1), 5, 5)


def label(text: str, colour, pixels: float = 11):
    """A label on its plate with a bar of `colour` (r, g, b in 0..1) at the left."""
    letters = font(pixels, bold=True)
    lines = text.split("\n")
    line = QtGui.QFontMetrics(letters).height()
    width = max(text_width(letters, t) for t in lines) + 20
    height = line * len(lines) + 6
    image = blank(width, height)
    pen = painter(image)
    plate(pen, width, height)
    pen.fillRect(QtCore.QRectF(4, 4, 4, height - 8), QtGui.QColor.fromRgbF(*colour))
    pen.setFont(letters)
    pen.setPen(QtGui.QColor(25, 32, 40))
    for i, t in enumerate(lines):
        box = QtCore.QRectF(12, 3 + i * line, width - 14, line)
        pen.drawText(box, QtCore.Qt.AlignVCenter | QtCore.Qt.AlignLeft, t)
    pen.end()
    return image
