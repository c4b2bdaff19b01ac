# SPDX-License-Identifier: LGPL-2.1-or-later
"""What differs between two files of results: numbers beyond a tolerance, and everything else that is not equal."""

from __future__ import annotations

import csv
import json
import math
import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np

RELATIVE, ABSOLUTE = 1e-9, 1e-12  # numbers that differ by less are equal: another processor adds in another order
NOT_COMPARED = (".fcstd", ".png")  # hold times and pixels of their own; their sums tell whether they are whole
_DRAWING = re.compile(r"<svg.*?</svg>", re.DOTALL)


def differences(before, now, most: int = 5) -> list[str]:
    """What differs between the file `before` and the newly computed `now`, in words, at most `most` places."""
    before, now = Path(before), Path(now)
    suffix = before.suffix.lower()
    if suffix in NOT_COMPARED:
        return []
    compare = {".json": _json, ".csv": _table, ".npz": _arrays, ".html": _page}.get(suffix, _text)
    found = []
    for words in compare(before, now):
        found.append(words)
        if len(found) == most:
            break
    return found


def equal_numbers(a: float, b: float) -> bool:
    """Whether two numbers agree within the tolerance; not finite ones agree where they are the same."""
    if math.isfinite(a) and math.isfinite(b):
        return abs(a - b) <= ABSOLUTE + RELATIVE * max(abs(a), abs(b))
    return a == b or (math.isnan(a) and math.isnan(b))


def _json(before: Path, now: Path) -> Iterator[str]:
    yield from _values(*(json.loads(p.read_text(encoding="utf-8")) for p in (before, now)), "")


def _values(a, b, path: str) -> Iterator[str]:
    plain = (int, float)
    if isinstance(a, plain) and isinstance(b, plain) and not isinstance(a, bool) and not isinstance(b, bool):
        if not equal_numbers(a, b):
            yield f"{path}: {a!r} is now {b!r}"
    elif isinstance(a, dict) and isinstance(b, dict):
        for key in [*a, *(k for k in b if k not in a)]:
            place = f"{path}.{key}" if path else str(key)
            if key not in a:
                yield f"{place}: is new"
            elif key not in b:
                yield f"{place}: is gone"
            else:
                yield from _values(a[key], b[key], place)
    elif isinstance(a, list) and isinstance(b, list):
        if len(a) != len(b):
            yield f"{path}: {len(a)} entries are now {len(b)}"
        for i, (x, y) in enumerate(zip(a, b)):
            yield from _values(x, y, f"{path}[{i}]")
    elif a != b or type(a) is not type(b):
        yield f"{path}: {_short(a)} is now {_short(b)}"


def _short(value) -> str:
    text = json.dumps(value, ensure_ascii=False)
    return text if len(text) <= 60 else text[:59] + "…"


def _table(before: Path, now: Path) -> Iterator[str]:
    rows = [list(csv.reader(p.read_text(encoding="utf-8").splitlines())) for p in (before, now)]
    if len(rows[0]) != len(rows[1]):
        yield f"{len(rows[0])} rows are now {len(rows[1])}"
    for line, (a, b) in enumerate(zip(*rows), start=1):
        if len(a) != len(b):
            yield f"line {line}: {len(a)} cells are now {len(b)}"
        for column, (x, y) in enumerate(zip(a, b), start=1):
            if x != y and not _equal_cells(x, y):
                yield f"line {line}, column {column}: {_short(x)} is now {_short(y)}"


def _equal_cells(x: str, y: str) -> bool:
    try:
        return equal_numbers(float(x), float(y))
    except ValueError:
        return False


def _arrays(before: Path, now: Path) -> Iterator[str]:
    with np.load(before, allow_pickle=False) as a, np.load(now, allow_pickle=False) as b:
        for name in sorted({*a.files, *b.files}):
            if name not in a.files or name not in b.files:
                yield f"{name}: is {'new' if name in b.files else 'gone'}"
            elif a[name].shape != b[name].shape:
                yield f"{name}: shape {a[name].shape} is now {b[name].shape}"
            elif a[name].dtype.kind == "f":
                x, y = a[name], b[name]
                scale = float(np.abs(x).max(initial=0.0))
                if not np.allclose(x, y, rtol=1e-6, atol=1e-9 * scale, equal_nan=True):
                    yield f"{name}: differs by {float(np.abs(x - y).max()):.3g}"
            elif not np.array_equal(a[name], b[name]):
                yield f"{name}: differs"


def _page(before: Path, now: Path) -> Iterator[str]:
    """Pages without their drawings, whose numbers stand in the tables."""
    yield from _lines(*(_DRAWING.sub("", p.read_text(encoding="utf-8")) for p in (before, now)))


def _text(before: Path, now: Path) -> Iterator[str]:
    yield from _lines(*(p.read_text(encoding="utf-8", errors="replace") for p in (before, now)))


def _lines(a: str, b: str) -> Iterator[str]:
    rows = a.splitlines(), b.splitlines()
    for line, (x, y) in enumerate(zip(*rows), start=1):
        if x != y:
            yield f"line {line} differs"
    if len(rows[0]) != len(rows[1]):
        yield f"{len(rows[0])} lines are now {len(rows[1])}"
