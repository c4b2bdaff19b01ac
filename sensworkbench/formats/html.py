# SPDX-License-Identifier: LGPL-2.1-or-later
"""Building blocks of the HTML reports: one self-contained page, for the screen (light and dark) and for paper.

Every helper returns `Html`; whatever is not `Html` is text and is escaped where it is put in, so that no name from a
user's file can become markup.  Nothing is loaded from anywhere.
"""

from __future__ import annotations

import base64
import html
from collections.abc import Sequence

BODY_COLOURS = {"X": "#3b82c4", "Y": "#e0812b", "Z": "#3a9d5d", "T": "#9467bd", "W": "#a08a2f"}
_FURTHER_COLOURS = {"A": "#c05780", "B": "#2a9d9d", "C": "#8c6d46", "U": "#6f8fc9", "V": "#d8a25e", "R": "#b04a3a"}

_STYLE = """
:root { color-scheme: light dark; --ink: #1d2530; --soft: #5a6675; --line: #d5dbe3; --paper: #ffffff; --tint: #f3f6f9;
  --mark: #1f5f99; --bar: #9dbfdf; --warn: #9a5b00; }
@media (prefers-color-scheme: dark) { :root { --ink: #e4e9ef; --soft: #9aa7b5; --line: #37424f; --paper: #161b21;
  --tint: #1f262e; --mark: #7db4e6; --bar: #34587a; --warn: #f0b45a; } }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 66rem; padding: 2rem 1.5rem 4rem; background: var(--paper); color: var(--ink);
  font: 16px/1.55 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; }
header { border-bottom: 3px solid var(--mark); margin-bottom: 1.5rem; padding-bottom: .8rem; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: 0 0 .3rem; }
h2 { font-size: 1.25rem; margin: 2.6rem 0 .6rem; }
h3 { font-size: 1.02rem; margin: 1.6rem 0 .4rem; }
p { margin: .5rem 0; max-width: 48rem; }
.soft, figcaption, caption { color: var(--soft); }
.lead { font-size: 1.08rem; }
.tiles { display: flex; flex-wrap: wrap; gap: .8rem; margin: 1.2rem 0; }
.tile { flex: 1 1 11rem; background: var(--tint); border: 1px solid var(--line); border-radius: .5rem;
  padding: .7rem .9rem; }
.tile b { display: block; font-size: 1.4rem; line-height: 1.25; overflow-wrap: anywhere; }
.tile span { color: var(--soft); font-size: .85rem; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-size: .92rem; font-variant-numeric: tabular-nums; }
caption { text-align: left; font-size: .9rem; padding-bottom: .3rem; }
th, td { padding: .28rem .55rem; border-bottom: 1px solid var(--line); text-align: left; vertical-align: top; }
thead th { border-bottom: 2px solid var(--line); color: var(--soft); font-weight: 600; white-space: nowrap; }
.n { text-align: right; white-space: nowrap; }
.meter { min-width: 7rem; }
.meter i { display: block; height: .62rem; margin-top: .42rem; background: var(--bar); border-radius: 2px; }
.meter i i { margin-top: 0; background: var(--mark); }
.dot { display: inline-block; width: .7rem; height: .7rem; border-radius: 50%; margin-right: .35rem; }
figure { margin: 1rem 0; }
figure svg, figure img { max-width: 100%; height: auto; display: block; }
figure svg { width: 100%; }
figure img { border: 1px solid var(--line); border-radius: .4rem; background: #ffffff; }
figcaption { font-size: .9rem; margin-top: .3rem; max-width: 48rem; }
dl { display: grid; grid-template-columns: minmax(9rem, max-content) 1fr; gap: .25rem 1.2rem; font-size: .95rem; }
dt { color: var(--soft); } dd { margin: 0; overflow-wrap: anywhere; }
.note { border-left: 4px solid var(--warn); background: var(--tint); padding: .5rem .9rem; margin: 1rem 0;
  max-width: 50rem; }
footer { margin-top: 3rem; border-top: 1px solid var(--line); padding-top: .6rem; color: var(--soft);
  font-size: .85rem; }
@media print { :root { color-scheme: light; --ink: #000; --soft: #444; --line: #bbb; --paper: #fff; --tint: #f6f6f6;
  --mark: #1f5f99; --bar: #9dbfdf; --warn: #9a5b00; }
  body { max-width: none; padding: 0; font-size: 10pt; } h2 { break-after: avoid; }
  figure, tr, .tiles, .note, .short { break-inside: avoid; } .wide { overflow: visible; }
  table { font-size: 8pt; } th, td { padding: .1rem .35rem; } .meter { min-width: 4rem; }
  .meter i { margin-top: .2rem; }
  figure img { max-height: 100mm; width: auto; } h2 { margin-top: 1.6rem; } .tile b { font-size: 1.1rem; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; } }
@page { margin: 16mm 14mm; }
"""


_SHORT = 12  # rows of a table that stays on one sheet of paper


class Html(str):
    """Text that is markup already."""

    __slots__ = ()


def text(value) -> Html:
    """`value` as markup: itself when it is `Html`, escaped otherwise."""
    return value if isinstance(value, Html) else Html(html.escape(str(value), quote=True))


def join(parts, between: str = "") -> Html:
    """Return the parts as one piece of markup; texts are escaped."""
    return Html(text(between).join(text(p) for p in parts))


def element(tag: str, *content, **attributes) -> Html:
    """Return `<tag ...>content</tag>`; `class_` and `data_x` become the attributes `class` and `data-x`."""
    pairs = "".join(f' {k.rstrip("_").replace("_", "-")}="{text(v)}"' for k, v in attributes.items() if v is not None)
    return Html(f"<{tag}{pairs}>{join(content)}</{tag}>")


def paragraph(*content, soft: bool = False, lead: bool = False) -> Html:
    """Return a `<p>`.  soft : in grey.  lead : larger, for a result."""
    return element("p", *content, class_="soft" if soft else "lead" if lead else None)


def section(title: str, *content) -> Html:
    """Return a `<section>` with a heading."""
    return element("section", element("h2", title), *content)


def note(*content) -> Html:
    """A remark that the reader must not miss."""
    return element("div", *content, class_="note")


def tiles(pairs: Sequence[tuple]) -> Html:
    """Large numbers side by side: (value, what it is)."""
    return element(
        "div", *(element("div", element("b", v), element("span", w), class_="tile") for v, w in pairs), class_="tiles"
    )


def facts(pairs: Sequence[tuple]) -> Html:
    """A list of names and values."""
    return element("dl", *(join([element("dt", k), element("dd", v)]) for k, v in pairs))


def table(columns: Sequence[str], rows: Sequence[Sequence], caption: str = "") -> Html:
    """A table.  A column whose name begins with "#" is numeric (right-aligned); the mark itself is not shown."""
    numeric = [c.startswith("#") for c in columns]
    head = [
        element("th", c.removeprefix("#"), class_="n" if n else None, scope="col") for c, n in zip(columns, numeric)
    ]
    body = [
        element("tr", *(element("td", cell, class_="n" if n else None) for cell, n in zip(row, numeric)))
        for row in rows
    ]
    parts = [element("caption", caption)] if caption else []
    parts += [element("thead", element("tr", *head)), element("tbody", *body)]
    return element("div", element("table", *parts), class_="wide short" if len(rows) <= _SHORT else "wide")


def meter(total: float, first: float = 0.0, largest: float = 1.0) -> Html:
    """A bar for a table cell: `total` long, with `first` of it marked, on a scale that ends at `largest`."""
    whole = max(0.0, min(1.0, total / largest if largest > 0 else 0.0))
    part = max(0.0, min(1.0, first / total if total > 0 else 0.0))
    inner = element("i", style=f"width:{part * 100:.1f}%")
    return element("div", element("i", inner, style=f"width:{whole * 100:.1f}%"), class_="meter")


def dot(colour: str, label) -> Html:
    """`label` behind a dot of `colour`."""
    return join([element("span", class_="dot", style=f"background:{colour}"), label])


def body_colour(body: str) -> str:
    """Return the colour of a body in charts and tables; bodies whose names have the same first letter share one."""
    known = BODY_COLOURS | _FURTHER_COLOURS
    return known.get(body) or known.get(body[:1], "#888888")


def body_label(body: str, name: str | None = None) -> Html:
    """A component's letter (or name) behind its colour."""
    return dot(body_colour(body), name or body)


def figure(content: Html, caption: str = "") -> Html:
    """Return a `<figure>` with an optional caption."""
    return element("figure", content, *([element("figcaption", caption)] if caption else []))


def picture(png: bytes, alt: str, caption: str = "") -> Html:
    """A PNG picture inside the page."""
    data, kind = base64.b64encode(png).decode("ascii"), "gif" if png[:3] == b"GIF" else "png"
    return figure(Html(f'<img alt="{text(alt)}" src="data:image/{kind};base64,{data}"/>'), caption)


def page(title: str, subtitle: str, *content, footer: str = "", language: str = "en") -> str:
    """A whole HTML document that loads nothing from anywhere.  It is well-formed XML too."""
    body = join(
        [
            element("header", element("h1", title), element("div", subtitle, class_="soft")),
            element("main", *content),
            *([element("footer", footer)] if footer else []),
        ]
    )
    return (
        f'<!DOCTYPE html>\n<html lang="{text(language)}">\n<head>\n<meta charset="utf-8"/>\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1"/>\n'
        f"<title>{text(title)}</title>\n<style>{_STYLE}</style>\n</head>\n<body>\n{body}\n</body>\n</html>\n"
    )
