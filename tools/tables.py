# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rewrite what is made from registries: tables of the documentation, lists of shapes in the JSON schemas.

`python tools/tables.py`.  A table is between `<!-- NAME -->` and `<!-- /NAME -->`; what makes it is listed in TABLES.
"""

from __future__ import annotations

import json
import re
import sys
import textwrap
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from sensworkbench.cli import program  # noqa: E402
from sensworkbench.core.shapes import SHAPES  # noqa: E402
from sensworkbench.formats.exchange import tables  # noqa: E402

TABLES = {
    ("docs/command-line.md", "verbs"): program.table,
    ("docs/formats.md", "formats"): tables.formats_table,
    ("docs/formats.md", "holds"): tables.holds_table,
}


def shape_rules() -> str:
    """The schema of an effect's parameters, one rule for each shape: those it may have, and those it must have."""
    rules = []
    for name, shape in SHAPES.items():
        of = {"propertyNames": {"enum": ["coefficient", "extent", *shape.parameters]}}
        needed = [
            n for n, p in shape.parameters.items() if p.default is None and n != "degree"
        ]  # follows from the count
        condition = json.dumps({"properties": {"shape": {"const": name}}})
        own = json.dumps(of | ({"required": needed} if needed else {}))
        rules.append(
            f'    {{\n     "if": {condition},\n     "then": {{\n      "properties": {{\n       "parameters": {own}'
            "\n      }\n     }\n    }"
        )
    return ",\n".join(rules)


def schema(text: str) -> str:
    """A schema with its lists of shapes as they are now: each "enum" of shapes, and the rules of their parameters."""

    def shapes(found) -> str:
        indent = " " * (len(found.group(1)) + 1)
        more = [name for name in ("random",) if f'"{name}"' in found.group(2)]
        listed = textwrap.fill(json.dumps([*SHAPES, *more])[1:-1], 118, initial_indent=indent, subsequent_indent=indent)
        return f'{found.group(1)}"enum": [\n{listed}\n{found.group(1)}]'

    text = re.sub(r'^( +)"enum": \[([^]]*"hysteresis"[^]]*)\]', shapes, text, flags=re.MULTILINE)
    rules = re.compile(r'("description": "which parameters each shape has",\n   "allOf": \[\n).*?(\n   \])', re.DOTALL)
    return rules.sub(lambda found: found.group(1) + shape_rules() + found.group(2), text)


def main() -> None:
    for path in sorted((ROOT / "resources" / "schemas").glob("*.json")):
        path.write_text(schema(path.read_text(encoding="utf-8")), encoding="utf-8")
    for (page, name), make in TABLES.items():
        path = ROOT / page
        begin, end = f"<!-- {name} -->\n", f"\n<!-- /{name} -->"
        text = path.read_text(encoding="utf-8")
        if text.count(begin) != 1 or text.count(end) != 1:
            sys.exit(f"{page} has no place for the table {name!r}")
        before, _, rest = text.partition(begin)
        text = before + begin + make() + end + rest.partition(end)[2]
        path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
