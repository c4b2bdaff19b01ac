# SPDX-License-Identifier: LGPL-2.1-or-later
"""Text tables: separator, comments, quoting and line numbers, before anything is known of what the columns mean.

The first row that is neither blank nor a comment holds the names.  Nothing is dropped: a row with the wrong number of
cells is refused with its line, and a cell that is no number is found again by line and column.
"""

from __future__ import annotations

import csv
from dataclasses import dataclass

import numpy as np

from sensworkbench.core.refusal import Refused

from .files import neutral, read_text

LIMIT = 512 * 2**20  # bytes
SEPARATORS = ("\t", ";", ",")


@dataclass(frozen=True)
class Table:
    """names : the first row.  cells : column -> list of stripped texts.  line : (P,) line of every row in the file.

    comments : (line, text without "#") of every comment.  names_line : line of the names.  source : name for messages.
    """

    names: tuple[str, ...]
    cells: tuple[list[str], ...]
    line: np.ndarray
    comments: tuple[tuple[int, str], ...]
    names_line: int
    separator: str
    source: str

    @property
    def rows(self) -> int:
        return len(self.line)

    def place(self, row: int, column: int) -> str:
        return f"{self.source}, line {int(self.line[row])}, column {column + 1} ({self.names[column]})"

    def text(self, column: int) -> list[str]:
        """Cells ready for float(): a decimal comma made a point where the separator is not a comma."""
        cells = self.cells[column]
        if self.separator != "," and any("," in c for c in cells):
            return [c.replace(",", ".") for c in cells]
        return cells

    def first_bad(self, column: int) -> int | None:
        """The first row whose cell is neither empty nor a number."""
        for row, cell in enumerate(self.text(column)):
            if cell and not is_number(cell):
                return row
        return None

    def numbers(self, column: int) -> np.ndarray:
        """(P,) the column as numbers, NaN where a cell is empty; refuses text with line and column."""
        cells = self.text(column)
        try:
            if any("_" in c for c in cells):  # Python reads 1_000 as a number; a file does not mean it
                raise ValueError
            return np.array([c or "nan" for c in cells], dtype=object).astype(float)
        except ValueError:
            row = self.first_bad(column)
            raise Refused(
                f"{self.cells[column][row]!r} is not a number", self.place(row, column), "Correct or empty the cell."
            ) from None


def is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return "_" not in text


def parse(text: str, source: str) -> Table:
    """The table in `text`; refuses an empty file, ragged rows and cells that run over the end of a line."""
    if "\0" in text:
        line = text.count("\n", 0, text.index("\0")) + 1
        raise Refused("the file holds binary data", f"{source}, line {line}", "Export it as a text table.")
    kept, numbers, comments = [], [], []
    for number, line in enumerate(text.replace("\r\n", "\n").replace("\r", "\n").split("\n"), start=1):
        bare = line.strip()
        if bare.startswith("#"):
            comments.append((number, bare.lstrip("#").strip()))
        elif bare.strip(",;\t "):
            kept.append(line)
            numbers.append(number)
    if not kept:
        raise Refused(
            "the file holds no row of names", source, "The first row names the columns, such as x_mm,y_mm,z_mm."
        )
    separator = next((s for s in SEPARATORS if s in kept[0]), ",")
    rows = _split(kept, numbers, separator, source)
    names = tuple(name.strip() for name in rows[0])
    width = len(names)
    for row, number in zip(rows, numbers, strict=True):
        if len(row) != width:
            raise Refused(
                f"{len(row)} cells in a table of {width} columns",
                f"{source}, line {number}",
                "Every row needs one cell per column; quote a cell that holds the separator.",
            )
    columns = tuple([cell.strip() for cell in column] for column in zip(*rows[1:], strict=True))
    return Table(
        names=names,
        cells=columns or tuple([] for _ in names),
        line=np.array(numbers[1:], dtype=int),
        comments=tuple(comments),
        names_line=numbers[0],
        separator=separator,
        source=source,
    )


def _split(kept, numbers, separator, source):
    reader = csv.reader(kept, delimiter=separator, skipinitialspace=True)
    rows = []
    try:
        for row in reader:
            rows.append(row)
            if reader.line_num != len(rows):
                raise Refused(
                    "a quoted cell runs over the end of the line",
                    f"{source}, line {numbers[len(rows) - 1]}",
                    "Close the quotation mark on the same line.",
                )
    except csv.Error as error:
        raise Refused(str(error), f"{source}, line {numbers[min(len(rows), len(numbers) - 1)]}") from None
    return rows


def read(path) -> Table:
    return parse(read_text(path, limit=LIMIT), str(path))


def safe_cell(text: str) -> str:
    """`text` as a cell: a text that a spreadsheet would take for a formula is neutralised, a number stays."""
    return text if is_number(text.replace(",", ".")) else neutral(text)
