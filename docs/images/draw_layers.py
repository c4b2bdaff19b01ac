# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw docs/images/layers.svg, the picture of the architecture page: `python3 docs/images/draw_layers.py`."""

from __future__ import annotations

from pathlib import Path

WIDTH, BOX, GAP = 860, 56, 22
LAYERS = [  # name, needs, content, colour
    ("gui", "FreeCAD with a window", "commands, panels, view providers, colours, legend", "#d8e4f5"),
    ("document", "FreeCAD", "objects in the document, placements, proposals, results, batch", "#d8e4f5"),
    (
        "formats",
        "numpy; charts: matplotlib",
        "readers and writers, conversion of units, exchange formats",
        "#e2efd9",
    ),
    ("studies", "numpy", "request → result: sensitivity, plan, trace, predict, convert, error map", "#e2efd9"),
    ("closedloop", "numpy", "readings, fit, scan, acceptance, rivals, prediction, plans", "#fdf0d5"),
    ("core", "numpy", "joints, machine, errors, shapes, Ω, indices, objectives", "#fdf0d5"),
    ("messages", "nothing", "codes with fields; sentences in English, German, Korean", "#eee8f3"),
]


def draw() -> str:
    """Return the picture as SVG: a box for each layer, arrows in the direction of imports, the command line beside."""
    height = len(LAYERS) * (BOX + GAP) + 40
    left, inner = 150, WIDTH - 170
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" '
        'font-family="sans-serif" font-size="15">',
        "<title>The layers of Sens Workbench; imports point downwards</title>",
        f'<rect width="{WIDTH}" height="{height}" fill="#ffffff"/>',
    ]
    tops = [20 + i * (BOX + GAP) for i in range(len(LAYERS))]
    for (name, needs, content, colour), top in zip(LAYERS, tops):
        parts += [
            f'<rect x="{left}" y="{top}" width="{inner}" height="{BOX}" rx="6" fill="{colour}" stroke="#666"/>',
            f'<text x="{left + 14}" y="{top + 23}" font-weight="bold" fill="#111">{name}</text>',
            f'<text x="{left + inner - 14}" y="{top + 23}" text-anchor="end" fill="#555" font-size="13">{needs}</text>',
            f'<text x="{left + 14}" y="{top + 44}" fill="#222" font-size="14">{content}</text>',
        ]
    for top in tops[:-1]:
        x, y = left + inner / 2, top + BOX
        parts.append(f'<path d="M{x} {y} V{y + GAP - 8}" stroke="#444" stroke-width="1.6"/>')
        parts.append(f'<path d="M{x} {y + GAP} l-5 -9 h10 z" fill="#444"/>')
    first, last = tops[1], tops[-1] + BOX
    parts += [
        f'<rect x="14" y="{first}" width="92" height="{last - first}" rx="6" fill="#f2f2f2" stroke="#666"/>',
        f'<text x="60" y="{first + 24}" text-anchor="middle" font-weight="bold" fill="#111">cli</text>',
        f'<text x="60" y="{first + 46}" text-anchor="middle" fill="#222" font-size="13">one module</text>',
        f'<text x="60" y="{first + 63}" text-anchor="middle" fill="#222" font-size="13">per verb</text>',
    ]
    for i, top in enumerate(tops[1:-1], 1):
        y = top + BOX / 2
        dash = ' stroke-dasharray="5 4"' if i == 1 else ""
        parts.append(f'<path d="M106 {y} H{left - 8}" stroke="#444" stroke-width="1.6"{dash}/>')
        parts.append(f'<path d="M{left} {y} l-9 -5 v10 z" fill="#444"/>')
    parts.append("</svg>")
    return "\n".join(parts) + "\n"


if __name__ == "__main__":
    (Path(__file__).parent / "layers.svg").write_text(draw(), encoding="utf-8")
