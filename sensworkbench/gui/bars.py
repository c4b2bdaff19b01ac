# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bars painted by Qt: Sᵀ with S inside it in a table's cell, and the components with their errors stacked."""

from __future__ import annotations

from .qt import Qt, QtCore, QtGui, Signal, translate

BAR = Qt.UserRole + 1  # (first, total, largest, (r, g, b)) of a cell


def qcolour(rgb, alpha: float = 1.0):
    """Return a QColor of red, green, blue and alpha in 0 to 1."""
    return QtGui.QColor.fromRgbF(*[min(max(float(c), 0.0), 1.0) for c in rgb], alpha)


class BarDelegate(QtGui.QStyledItemDelegate):
    """Paints the total index as a bar, the first-order index as a darker one inside it, and the number."""

    def paint(self, pen, option, index):
        data = index.data(BAR)
        if data is None:
            super().paint(pen, option, index)
            return
        first, total, largest, colour = data
        pen.save()
        if option.state & QtGui.QStyle.State_Selected:
            pen.fillRect(option.rect, option.palette.highlight())
        box = QtCore.QRectF(option.rect).adjusted(3, 4, -3, -4)
        width = max(0.0, box.width() - 54)
        scale = width / largest if largest > 0 else 0.0
        pen.setPen(QtGui.QPen(QtGui.QColor(90, 100, 110), 0.8))
        pen.setBrush(qcolour(colour))
        pen.drawRect(QtCore.QRectF(box.x(), box.y(), max(1.0, total * scale), box.height()))
        if first > 0:
            pen.setPen(Qt.NoPen)
            pen.setBrush(QtGui.QColor(20, 25, 30, 150))
            height = box.height() * 0.4
            pen.drawRect(QtCore.QRectF(box.x(), box.center().y() - height / 2, max(1.0, first * scale), height))
        selected = option.state & QtGui.QStyle.State_Selected
        role = QtGui.QPalette.HighlightedText if selected else QtGui.QPalette.Text
        pen.setPen(option.palette.color(role))
        pen.drawText(option.rect.adjusted(0, 0, -6, 0), Qt.AlignRight | Qt.AlignVCenter, f"{total:.4f}")
        pen.restore()

    def sizeHint(self, option, index):
        return QtCore.QSize(150, 24)


class ComponentBars(QtGui.QWidget):
    """One block per component: S and Sᵀ of the component, below them the Sᵀ of its errors side by side.

    `picked` is emitted with the body letter when a block is clicked.
    """

    picked = Signal(str)
    BLOCK = 62

    def __init__(self, parent=None):
        super().__init__(parent)
        self.blocks = []  # (body, name, first, total, colour, [(symbol, total)])
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
        top = max([t for *_, t, _, _ in self.blocks] + [sum(v for _, v in b[5]) for b in self.blocks], default=1.0)
        scale = width / top if top > 0 else 0.0
        font = QtGui.QFont(self.font())
        small = QtGui.QFont(font)
        small.setPointSizeF(max(6.5, font.pointSizeF() * 0.8))
        for i, (body, name, first, total, colour, errors) in enumerate(self.blocks):
            y = 6 + i * self.BLOCK
            if body == self.chosen:
                shade = QtGui.QColor(palette.color(QtGui.QPalette.Highlight))
                shade.setAlpha(50)
                pen.fillRect(QtCore.QRectF(2, y - 2, self.width() - 4, self.BLOCK - 2), shade)
            font.setBold(True)
            pen.setFont(font)
            pen.setPen(ink)
            pen.drawText(QtCore.QRectF(left, y, width + right, 18), Qt.AlignLeft | Qt.AlignVCenter, name)
            font.setBold(False)
            pen.setFont(font)
            pen.setPen(QtGui.QPen(ink, 0.6))
            pen.setBrush(qcolour(colour))
            pen.drawRect(QtCore.QRectF(left, y + 19, max(1.0, total * scale), 15))
            pen.setPen(Qt.NoPen)
            pen.setBrush(QtGui.QColor(20, 25, 30, 150))
            pen.drawRect(QtCore.QRectF(left, y + 24, max(1.0, first * scale), 5))
            pen.setPen(ink)
            pen.drawText(
                QtCore.QRectF(left + total * scale + 5, y + 19, right, 15),
                Qt.AlignLeft | Qt.AlignVCenter,
                f"{total:.3f}",
            )
            self._stack(pen, small, ink, left, y + 38, scale, colour, errors)
        y = 8 + len(self.blocks) * self.BLOCK
        pen.setFont(small)
        pen.setPen(ink)
        text = translate("Sens", "Bar: Sᵀ of the component; dark: S. Below: Sᵀ of its errors, one after the other.")
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
