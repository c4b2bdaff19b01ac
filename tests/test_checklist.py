# SPDX-License-Identifier: LGPL-2.1-or-later
"""docs/checklist.md says which test holds which requirement; here: that it has all rows, and that the tests exist."""

from __future__ import annotations

import ast
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


def rows() -> dict[int, str]:
    text = (ROOT / "docs" / "checklist.md").read_text(encoding="utf-8")
    found = re.findall(r"^\| (\d+) \| [^|]+ \| ([^|]+) \|$", text, re.MULTILINE)
    return {int(number): held for number, held in found}


def names(path: Path) -> set[str]:
    tree = ast.parse(path.read_text(encoding="utf-8"))
    return {n.name for n in ast.walk(tree) if isinstance(n, ast.FunctionDef)}


def test_every_requirement_is_there_once():
    assert list(rows()) == list(range(1, 51))


def test_every_requirement_is_held_by_a_test_or_a_program_that_exists():
    missing = []
    for number, held in rows().items():
        quoted = [q for q in re.findall(r"`([^`]+)`", held) if "/" in q]
        assert quoted, f"row {number} names nothing"
        for entry in quoted:
            file, _, test = entry.partition("::")
            path = ROOT / file
            if not path.exists() or (test and test not in names(path)):
                missing.append(f"row {number}: {entry}")
    assert missing == []
