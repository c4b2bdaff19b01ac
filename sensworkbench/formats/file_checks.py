# SPDX-License-Identifier: LGPL-2.1-or-later
"""Written files read back before they take their names: JSON and tables finite and complete, archives whole.

A disk that is full, or a library that reports no error, must not hand over a file that nobody can read.
"""

from __future__ import annotations

import csv
import json
import math
import zipfile
import zlib
from pathlib import Path

from sensworkbench.core.refusal import Refused

from . import machine_json


def check(path, name: str) -> None:
    """Refuse the file at `path`, to be known as `name`, if it is not whole; kinds that are not known pass."""
    path = Path(path)
    suffix = path.suffix.lower()
    try:
        if suffix == ".json":
            _check_json(path.read_text(encoding="utf-8"), name)
        elif suffix == ".csv":
            _check_table(path, name)
        elif suffix in (".npz", ".fcstd", ".zip"):
            with zipfile.ZipFile(path) as archive:
                if archive.testzip() is not None:
                    raise Refused("written-not-whole", name)
        elif suffix == ".html":
            if not path.read_text(encoding="utf-8").rstrip().endswith("</html>"):
                raise Refused("written-not-whole", name)
        elif suffix == ".png":
            if not path.read_bytes()[-8:].startswith(b"IEND"):
                raise Refused("written-not-whole", name)
    except (zipfile.BadZipFile, zlib.error, UnicodeDecodeError, EOFError, NotImplementedError, RuntimeError):
        raise Refused("written-not-whole", name) from None


def _check_json(text: str, name: str) -> None:
    def refuse(word):
        raise Refused("written-not-finite", name, value=word)

    def number(word):
        value = float(word)
        return value if math.isfinite(value) else refuse(word)

    try:
        found = json.loads(text, parse_constant=refuse, parse_float=number)
    except json.JSONDecodeError:
        raise Refused("written-not-whole", name) from None
    if isinstance(found, dict) and found.get("format") == machine_json.FORMAT:
        machine_json.loads(text, name)


def _check_table(path: Path, name: str) -> None:
    """A column that holds nothing but numbers holds finite ones."""
    texts: set[int] = set()
    bad: dict[int, str] = {}
    with open(path, encoding="utf-8", newline="") as stream:
        rows = csv.reader(line for line in stream if not line.startswith("#"))
        next(rows, None)
        for row in rows:
            for j, cell in enumerate(row):
                try:
                    if cell and j not in texts and not math.isfinite(float(cell)):
                        bad[j] = cell
                except ValueError:
                    texts.add(j)
    for j in bad.keys() - texts:
        raise Refused("written-not-finite", name, value=bad[j])
