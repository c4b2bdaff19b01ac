# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rewrite the tables of the documentation that are made from registries: `python tools/tables.py`.

A table stands between `<!-- NAME -->` and `<!-- /NAME -->`; what makes it is listed in TABLES.
"""

from __future__ import annotations

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from sensworkbench.cli import program  # noqa: E402
from sensworkbench.formats.exchange import tables  # noqa: E402

TABLES = {
    ("docs/command-line.md", "verbs"): program.table,
    ("docs/formats.md", "formats"): tables.formats_table,
    ("docs/formats.md", "holds"): tables.holds_table,
}


def main() -> None:
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
