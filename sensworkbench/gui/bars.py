# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bars painted by Qt: Sᵀ with S inside it in a table's cell, and the components with their errors stacked."""

from __future__ import annotations

from .qt import Qt, QtCore, QtGui, Signal, translate

BAR = Qt.UserRole + 1  # (share, largest, (r, g, b)) of a cell


def qcolour(rgb, alpha: float = 1.0):
    """Return a QColor of red, green, blue and alpha in 0 to 1."""
    return QtGui.QColor.fromRgbF(*[min(max(float(c), 0.0), 1.0) for c in rgb], alpha)


def percent(share: float) -> str:
    """A share in per cent, with one decimal."""
    return f"{100 * share:.1f} %"


class BarDelegate(QtGui.QStyledItemDelegate):
    """Paints a share as a bar, and in per cent."""

    def paint(self, pen, option, index):
        data = index.data(BAR)
        if data is None:
            super().paint(pen, option, index)
            return
        share, largest, colour = data
        pen.save()
        if option.state & QtGui.QStyle.State_Selected:
            pen.fillRect(option.rect, option.palette.highlight())
        box = QtCore.QRectF(option.rect).adjusted(3, 4, -3, -4)
        width = max(0.0, box.width() - 54)
        scale = width / largest if largest > 0 else 0.0
        pen.setPen(QtGui.QPen(QtGui.QColor(90, 100, 110), 0.8))
        pen.setBrush(qcolour(colour))
        pen.drawRect(QtCore.QRectF(box.x(), box.y(), max(1.0, share * scale), box.height()))
        selected = option.state & QtGui.QStyle.State_Selected
        role = QtGui.QPalette.HighlightedText if selected else QtGui.QPalette.Text
        pen.setPen(option.palette.color(role))
        pen.drawText(option.rect.adjusted(0, 0, -6, 0), Qt.AlignRight | Qt.AlignVCenter, percent(share))
        pen.restore()

    def sizeHint(self, option, index):
        return QtCore.QSize(150, 24)


class ComponentBars(QtGui.QWidget):
    """One block per component: its share of the variance, and below it the shares of its errors side by side.

    `picked` is emitted with the body letter when a block is clicked.
    """

    picked = Signal(str)
    BLOCK = 62

    def __init__(self, parent=None):
        super().__init__(parent)
        self.blocks = []  # (body, name, share, first, total, colour, [(symbol, share)])
        self.chosen = ""
        self.setMinimumWidth(240)
        self.setMouseTracking(True)

    def show_blocks(self, blocks) -> None:
        """Show one bar for each block (a component with its errors)."""
        self.blocks = list(blocks)
        self.setMinimumHeight(self.BLOCK * len(self.blocks) + 46)
        self.update()

    def choose(self, body: str) -> None:
        """Mark the bar of a body as selected."""
        self.chosen = body
        self.update()

    def block_at(self, y: float):
        """Return the block at height `y` (pixels), or None."""
        i = int((y - 6) // self.BLOCK)
        return self.blocks[i] if 0 <= i < len(self.blocks) else None

    def mousePressEvent(self, event):
        block = self.block_at(event.pos().y())
        if block is not None:
            self.picked.emit(block[0])

    def paintEvent(self, _event):
        pen = QtGui.QPainter(self)
        pen.setRenderHint(QtGui.QPainter.Antialiasing, True)
        palette = self.palette()
        ink = palette.color(QtGui.QPalette.WindowText)
        left, right = 10, 62
        width = self.width() - left - right
        top = max([block[2] for block in self.blocks], default=1.0)
        scale = width / top if top > 0 else 0.0
        font = QtGui.QFont(self.font())
        small = QtGui.QFont(font)
        small.setPointSizeF(max(6.5, font.pointSizeF() * 0.8))
        for i, (body, name, share, first, total, colour, errors) in enumerate(self.blocks):
            y = 6 + i * self.BLOCK
            if body == self.chosen:
                shade = QtGui.QColor(palette.color(QtGui.QPalette.Highlight))
                shade.setAlpha(50)
                pen.fillRect(QtCore.QRectF(2, y - 2, self.width() - 4, self.BLOCK - 2), shade)
            font.setBold(True)
            pen.setFont(font)
            pen.setPen(ink)
            box = QtCore.QRectF(left, y, width + right - left, 18)
            pen.drawText(box, Qt.AlignLeft | Qt.AlignVCenter, name)
            font.setBold(False)
            pen.setFont(small)
            pen.drawText(box, Qt.AlignRight | Qt.AlignVCenter, f"S {first:.3f}   Sᵀ {total:.3f}")
            pen.setFont(font)
            pen.setPen(QtGui.QPen(ink, 0.6))
            pen.setBrush(qcolour(colour))
            pen.drawRect(QtCore.QRectF(left, y + 19, max(1.0, share * scale), 15))
            pen.setPen(ink)
            pen.drawText(
                QtCore.QRectF(left + share * scale + 5, y + 19, right, 15),
                Qt.AlignLeft | Qt.AlignVCenter,
                percent(share),
            )
            self._stack(pen, small, ink, left, y + 38, scale, colour, errors)
        y = 8 + len(self.blocks) * self.BLOCK
        pen.setFont(small)
        pen.setPen(ink)
        text = translate(
            "Sens", "Bar: share of the component in the variance. Below: the shares of its errors, which add to it."
        )
        pen.drawText(QtCore.QRectF(left, y, self.width() - 2 * left, 34), Qt.AlignLeft | Qt.TextWordWrap, text)
        pen.end()

    @staticmethod
    def _stack(pen, font, ink, x, y, scale, colour, errors):
        pen.setFont(font)
        for j, (symbol, value) in enumerate(errors):
            width = value * scale
            shade = qcolour(colour).lighter(118 if j % 2 else 140)
            pen.setPen(QtGui.QPen(QtGui.QColor(90, 100, 110), 0.6))
            pen.setBrush(shade)
            box = QtCore.QRectF(x, y, width, 14)
            pen.drawRect(box)
            if width > 26:
                pen.setPen(QtGui.QColor(15, 20, 25) if shade.lightness() > 110 else QtGui.QColor(245, 245, 245))
                pen.drawText(box, Qt.AlignCenter, symbol)
            x += width
