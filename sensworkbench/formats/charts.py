# SPDX-License-Identifier: LGPL-2.1-or-later
"""Charts as SVG for the reports, drawn by matplotlib's object interface where matplotlib is installed.

Without matplotlib `available()` is false and the functions return None; the reports then show tables.  Text and lines
take the colour of the page around them, so a chart reads on light and dark ground.
"""

from __future__ import annotations

import functools
import importlib
import io
import itertools
import re
import warnings
from collections.abc import Mapping, Sequence

import numpy as np

from .html import Html, text

INK = "#010203"  # stands for the page's own text colour; becomes currentColor
SERIES = ("#3b82c4", "#e0812b", "#3a9d5d", "#9467bd", "#a08a2f", "#c44e5c")
_RC = {
    "svg.fonttype": "none",
    "svg.hashsalt": "sensworkbench",
    "font.family": "sans-serif",
    "font.size": 9.5,
    "text.color": INK,
    "axes.edgecolor": INK,
    "axes.labelcolor": INK,
    "xtick.color": INK,
    "ytick.color": INK,
    "axes.facecolor": "none",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.linewidth": 0.6,
    "figure.facecolor": "none",
    "legend.frameon": False,
    "text.parse_math": False,
}
_ABOVE = {"loc": "lower left", "bbox_to_anchor": (0, 1), "ncol": 4, "fontsize": 8.5, "borderaxespad": 0.2}

_numbers = itertools.count(1)  # makes the ids of every chart in a page its own


@functools.cache
def available() -> bool:
    """Whether matplotlib is installed and can be loaded (a copy built for another numpy cannot)."""
    try:
        importlib.import_module("matplotlib.backends.backend_svg")
    except (ImportError, AttributeError, OSError, RuntimeError):
        return False
    return True


class _Drawing:
    """A figure that becomes inline SVG: `with _Drawing(8, 3, "what it shows") as d: d.axes(1, 1) ...; d.svg`."""

    def __init__(self, width: float, height: float, alt: str):
        from matplotlib import rc_context
        from matplotlib.figure import Figure

        self._context = rc_context({k: v for k, v in _RC.items() if k in _known()})
        self._make = lambda: Figure(figsize=(width, height), layout="constrained")
        self.alt, self.svg = alt, Html("")

    def __enter__(self):
        from matplotlib.backends.backend_svg import FigureCanvasSVG

        self._context.__enter__()
        self.figure = self._make()
        FigureCanvasSVG(self.figure)
        return self

    def axes(self, rows: int = 1, columns: int = 1, **options):
        return self.figure.subplots(rows, columns, **options)

    def __exit__(self, *error):
        try:
            if error[0] is None:
                stream = io.StringIO()
                with warnings.catch_warnings():  # text stays text: the reader's own fonts show it
                    warnings.filterwarnings("ignore", message="Glyph .* missing from")
                    self.figure.savefig(stream, format="svg", metadata={"Date": None, "Creator": None})
                self.svg = _inline(stream.getvalue(), self.alt)
        finally:
            self._context.__exit__(*error)
        return False


def _known():
    from matplotlib import rcParams

    return rcParams


def _inline(svg: str, alt: str) -> Html:
    """matplotlib's file as an element of a page: no prologue, ids of its own, the page's ink."""
    svg = svg[svg.index("<svg") :]
    svg = re.sub(r"<metadata>.*?</metadata>\s*", "", svg, flags=re.DOTALL)
    svg = re.sub(r' d="[^"]*"', _hundredths, svg)
    svg = svg.replace(INK, "currentColor")
    mark = f"c{next(_numbers)}-"
    svg = re.sub(r'\bid="', f'id="{mark}', svg)
    svg = re.sub(r"url\(#", f"url(#{mark}", svg)
    svg = re.sub(r'(?:xlink:)?href="#', f'href="#{mark}', svg)
    svg = re.sub(r'(?:xlink:)href="data:', 'href="data:', svg)
    svg = re.sub(r' xmlns(?::xlink)?="[^"]*"', "", svg)
    svg = re.sub(r"font-family: [^;\"]*|'DejaVu Sans'(, [^;\"]*)?", lambda m: _family(m.group()), svg)
    return Html(svg.replace("<svg ", f'<svg role="img" aria-label="{text(alt)}" ', 1).strip())


def _hundredths(path: re.Match) -> str:
    """Coordinates of a path to a hundredth of a point: half the size of a page of arrows."""
    return re.sub(r"-?\d+\.\d{3,}", lambda m: f"{float(m.group()):.2f}".rstrip("0").rstrip("."), path.group())


def _family(found: str) -> str:
    return "font-family: system-ui, sans-serif" if found.startswith("font-family") else "system-ui, sans-serif"


def _cut(labels, length: int = 34) -> list[str]:
    """Labels that leave the chart its room."""
    return [t if len(t) <= length else t[: length - 1] + "…" for t in map(str, labels)]


def _grid(ax, axis: str):
    ax.grid(visible=True, axis=axis, color=INK, alpha=0.15, linewidth=0.6)
    ax.set_axisbelow(True)


def bar_chart(
    labels: Sequence[str],
    first: Sequence[float],
    total: Sequence[float],
    colours: Sequence[str],
    maximum: Sequence[float] | None = None,
    legend: Mapping[str, str] | None = None,
    xlabel: str = "",
    alt: str = "",
    words: tuple[str, str, str] = ("S", "Sᵀ", "max Sᵀ"),
) -> Html | None:
    """Ranking: per label one bar `total` long in its colour, the `first` part of it solid, a tick at `maximum`.

    legend : name -> colour.  words : for the solid part, the bar and the tick.  SVG, or None without matplotlib.
    """
    if not available():
        return None
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    y = np.arange(len(labels))
    with _Drawing(8.6, 1.15 + 0.245 * len(labels), alt) as drawing:
        ax = drawing.axes()
        ax.barh(y, total, height=0.7, color=list(colours), alpha=0.42, linewidth=0)
        ax.barh(y, first, height=0.7, color=list(colours), linewidth=0)
        if maximum is not None:
            ax.plot(maximum, y, linestyle="none", marker="|", markersize=9, markeredgewidth=1.4, color=INK)
        ax.set_yticks(y, _cut(labels))
        ax.invert_yaxis()
        ax.margins(y=0.01)
        ax.set_xlim(0, max(1e-9, 1.05 * max([*total, *(maximum if maximum is not None else [0.0])])))
        ax.tick_params(axis="y", length=0)
        ax.spines["left"].set_visible(False)
        ax.set_xlabel(xlabel)
        _grid(ax, "x")
        marks = [
            Patch(facecolor=INK, alpha=0.9, label=words[0]),
            Patch(facecolor=INK, alpha=0.35, label=words[1]),
        ]
        if maximum is not None:
            marks.append(Line2D([], [], linestyle="none", marker="|", markersize=9, color=INK, label=words[2]))
        marks += [Patch(facecolor=c, label=n) for n, c in (legend or {}).items()]
        ax.legend(handles=marks, **_ABOVE)
    return drawing.svg


def grouped_bars(
    labels: Sequence[str], series: Mapping[str, Sequence[float]], xlabel: str = "", alt: str = ""
) -> Html | None:
    """Bars side by side: one group per label, one bar per series."""
    if not available():
        return None
    y = np.arange(len(labels))
    height = 0.8 / max(1, len(series))
    with _Drawing(8.6, 0.9 + (0.14 + 0.15 * len(series)) * len(labels), alt) as drawing:
        ax = drawing.axes()
        for i, (name, values) in enumerate(series.items()):
            ax.barh(
                y + (i - (len(series) - 1) / 2) * height,
                values,
                height * 0.92,
                color=SERIES[i % 6],
                label=_cut([name])[0],
            )
        ax.set_yticks(y, _cut(labels))
        ax.invert_yaxis()
        ax.margins(y=0.01)
        ax.tick_params(axis="y", length=0)
        ax.spines["left"].set_visible(False)
        ax.set_xlabel(xlabel)
        _grid(ax, "x")
        ax.legend(**_ABOVE)
    return drawing.svg


def scatter(
    x, series: Mapping[str, Sequence[float]], xlabel: str = "", ylabel: str = "", line=None, alt: str = ""
) -> Html | None:
    """Points of one or more series over `x`; `line` = (x, y) is drawn through them."""
    if not available():
        return None
    with _Drawing(8.6, 3.4, alt) as drawing:
        ax = drawing.axes()
        size = 14 if len(x) < 500 else 5
        for i, (name, values) in enumerate(series.items()):
            ax.scatter(
                x, values, s=size, color=SERIES[i % 6], alpha=0.6, linewidths=0, label=name, rasterized=len(x) > 4000
            )
        if line is not None:
            ax.plot(*line, color=INK, linewidth=1.4)
        ax.axhline(0, color=INK, linewidth=0.6, alpha=0.5)
        ax.set_xlabel(xlabel)
        ax.set_ylabel(ylabel)
        _grid(ax, "both")
        if len(series) > 1:
            ax.legend(**_ABOVE)
    return drawing.svg


def bands(groups, xlabel: str, *ylabels: str, alt: str = "") -> Html | None:
    """Curves with bands, one panel for each group: (name, x (P,), value (P,), half width of the band (P,)) each."""
    if not available():
        return None
    with _Drawing(8.6, 3.0, alt) as drawing:
        panels = np.atleast_1d(drawing.axes(1, len(groups)))
        for ax, group, label in zip(panels, groups, ylabels):
            for i, (name, x, value, wide) in enumerate(group):
                ax.fill_between(x, value - wide, value + wide, color=SERIES[i % 6], alpha=0.2, linewidth=0)
                ax.plot(x, value, color=SERIES[i % 6], linewidth=1.5, label=name)
            ax.axhline(0, color=INK, linewidth=0.6, alpha=0.5)
            ax.set_xlabel(xlabel)
            ax.set_ylabel(label)
            _grid(ax, "both")
            if group:
                ax.legend(**_ABOVE)
    return drawing.svg


def histogram(
    series: Mapping[str, Sequence[float]], xlabel: str = "", bins: int = 40, alt: str = "", ylabel: str = "points"
) -> Html | None:
    """Histograms of several series over common bins, drawn as steps."""
    if not available():
        return None
    values = [np.asarray(v, dtype=float) for v in series.values()]
    top = max((float(v.max()) for v in values if v.size), default=1.0) or 1.0
    low = min((float(v.min()) for v in values if v.size), default=0.0)
    edges = np.linspace(min(0.0, low), top, bins + 1)
    with _Drawing(8.6, 3.0, alt) as drawing:
        ax = drawing.axes()
        for i, (name, v) in enumerate(zip(series, values)):
            ax.hist(v, edges, histtype="stepfilled", color=SERIES[i % 6], alpha=0.25, linewidth=0)
            ax.hist(v, edges, histtype="step", color=SERIES[i % 6], linewidth=1.5, label=_cut([name])[0])
        ax.set_xlabel(xlabel)
        ax.set_ylabel(ylabel)
        _grid(ax, "y")
        ax.legend(**_ABOVE)
    return drawing.svg


def arrows(q, series: Mapping[str, np.ndarray], unit: str = "µm", limit: int = 300, alt: str = "") -> Html | None:
    """Vectors at places in three views (XY, XZ, YZ), one row per series, all on one scale.

    q : (P, 3) mm.  series : name -> (P, 3) in `unit`.  At most `limit` places are drawn, evenly chosen.
    """
    if not available():
        return None
    q = np.asarray(q, dtype=float)
    keep = np.unique(np.linspace(0, len(q) - 1, min(limit, len(q))).round().astype(int)) if len(q) else np.arange(0)
    q = q[keep]
    vectors = {k: np.asarray(v, dtype=float)[keep] for k, v in series.items()}
    longest = max((float(np.linalg.norm(v, axis=1).max()) for v in vectors.values() if len(v)), default=1.0) or 1.0
    span = float(np.ptp(q, axis=0).max()) if len(q) else 1.0
    scale = 0.16 * (span or 1.0) / longest  # mm of paper per unit
    key = float(f"{longest / 2:.1g}")
    with _Drawing(8.6, 3.1 * len(vectors) + 0.2, alt) as drawing:
        grid = drawing.axes(len(vectors), 3, squeeze=False)
        for row, (name, v), colour in zip(grid, vectors.items(), SERIES):
            for ax, (i, j) in zip(row, ((0, 1), (0, 2), (1, 2))):
                some = np.hypot(v[:, i], v[:, j]) > 0
                ax.plot(q[:, i], q[:, j], linestyle="none", marker=".", markersize=1.5, color=INK, alpha=0.4)
                if some.any():
                    at, by = q[some][:, [i, j]].T, v[some][:, [i, j]].T
                    drawn = ax.quiver(
                        *at, *by, color=colour, angles="xy", scale_units="xy", scale=1 / scale, width=0.006
                    )
                    if ax is row[2]:
                        ax.quiverkey(drawn, 0.8, 1.04, key, f"{key:g} {unit}", labelpos="E", coordinates="axes")
                ax.set_aspect("equal", adjustable="datalim")
                ax.margins(0.3)
                ax.set_xlabel(f"{'XYZ'[i]}, mm")
                ax.set_ylabel(f"{'XYZ'[j]}, mm")
                _grid(ax, "both")
            row[0].set_title(name, loc="left", fontsize=10)
    return drawing.svg


def parallel_chart(
    names: Sequence[str],
    rows: Sequence[Sequence[float]],
    marked: Sequence[Sequence[float]],
    all_words: str,
    marked_words: str,
    alt: str = "",
) -> Html | None:
    """Parallel coordinates: one line per row over one upright axis per name, each on its own scale; `marked` on top.

    Returns SVG, or None without matplotlib or without rows.
    """
    if not available() or not len(rows) or len(names) < 2:
        return None
    from matplotlib.collections import LineCollection
    from matplotlib.lines import Line2D

    every = np.array([*rows, *marked], dtype=float)
    low, high = every.min(axis=0), every.max(axis=0)
    span = np.where(high > low, high - low, 1.0)
    x = np.arange(len(names))

    def lines(values):
        scaled = (np.array(values, dtype=float) - low) / span
        return [np.column_stack([x, np.where(high > low, row, 0.5)]) for row in scaled]

    with _Drawing(8.6, 3.6, alt) as drawing:
        ax = drawing.axes()
        ax.add_collection(LineCollection(lines(rows), colors=SERIES[0], alpha=0.25, linewidths=0.7))
        if len(marked):
            ax.add_collection(LineCollection(lines(marked), colors=SERIES[1], alpha=0.9, linewidths=1.3))
        for i in x:
            ax.axvline(i, color=INK, linewidth=0.6, alpha=0.6)
            ax.text(i, 1.02, f"{high[i]:.4g}", ha="center", va="bottom", fontsize=8)
            ax.text(i, -0.02, f"{low[i]:.4g}", ha="center", va="top", fontsize=8)
        ax.set_xlim(-0.3, len(names) - 0.7)
        ax.set_ylim(-0.1, 1.1)
        ax.set_xticks(x, _cut(names, 22), fontsize=8.5)
        ax.set_yticks([])
        for side in ("left", "bottom"):
            ax.spines[side].set_visible(False)
        ax.tick_params(axis="x", length=0)
        marks = [Line2D([], [], color=SERIES[0], label=all_words)]
        if len(marked):
            marks.append(Line2D([], [], color=SERIES[1], label=marked_words))
        ax.legend(handles=marks, **_ABOVE)
    return drawing.svg
