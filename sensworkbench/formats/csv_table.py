# SPDX-License-Identifier: LGPL-2.1-or-later
"""Text tables: separator, comments, quoting and line numbers, before anything is known of what the columns mean.

The first row that is neither blank nor a comment holds the names.  Nothing is dropped: a row with the wrong number of
cells is refused with its line, and a cell that is no number is found again by line and column.  Time and memory grow
with the size of the text, however it is cut into rows and columns.
"""

from __future__ import annotations

import csv
import re
from array import array
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from sensworkbench.core.refusal import Refused

from .files import neutral, read_text
from .json_text import short

LIMIT = 512 * 2**20  # bytes
SEPARATORS = ("\t", ";", ",")
MAX_COLUMNS = 100_000
_CHUNK = 2**18  # characters that are cut into cells at a time
_SPECIAL = re.compile(r"^[,;\t ]*(?:#|\s|\Z)", re.MULTILINE)  # perhaps a comment, or a line without cells
_NOT_PLAIN = re.compile(r"[\"\s]")
_LONGEST = csv.field_size_limit()


class Cells(Sequence):
    """The cells of a table, column by column: `cells[j]` is the list of stripped texts of column j, made when asked.

    Held as long texts, a block of rows in each: a list of millions of short texts would take fifty times the file.
    """

    def __init__(self, width: int):
        self._blocks: tuple[list[str], ...] = tuple([] for _ in range(width))

    def add(self, rows: list[list[str]]) -> None:
        """Append rows, each as long as the table is wide."""
        for blocks, column in zip(self._blocks, zip(*rows, strict=True), strict=True):
            blocks.append("\n".join([cell.strip() for cell in column]))

    def add_plain(self, cells: list[str]) -> None:
        """Append rows whose cells follow each other and have no blanks about them."""
        for j, blocks in enumerate(self._blocks):
            blocks.append("\n".join(cells[j :: len(self._blocks)]))

    def __len__(self) -> int:
        return len(self._blocks)

    def __getitem__(self, column):
        return [cell for block in self.blocks(column) for cell in block]

    def blocks(self, column: int) -> Iterator[list[str]]:
        """The cells of a column, a block of rows at a time."""
        for block in self._blocks[column]:
            yield block.split("\n")

    def only(self, columns) -> Cells:
        """The cells of some columns."""
        found = Cells(0)
        found._blocks = tuple(self._blocks[j] for j in columns)
        return found

    def holds(self, column: int, mark: str) -> bool:
        """Whether a character stands anywhere in a column."""
        return any(mark in block for block in self._blocks[column])


@dataclass(frozen=True)
class Table:
    """names : the first row.  cells : column -> list of stripped texts.  line : (P,) line of every row in the file.

    comments : (line, text without "#") of every comment.  names_line : line of the names.  source : name for messages.
    """

    names: tuple[str, ...]
    cells: Cells
    line: np.ndarray
    comments: tuple[tuple[int, str], ...]
    names_line: int
    separator: str
    source: str

    @property
    def rows(self) -> int:
        """Number of rows."""
        return len(self.line)

    def place(self, row: int, column: int) -> str:
        """Return where a cell is, in words: file, line, column."""
        return f"{self.source}, line {int(self.line[row])}, column {column + 1} ({short(self.names[column])[1:-1]})"

    def comma(self, column: int) -> bool:
        """Whether the decimal sign of a column is a comma: the separator is none, and a cell holds one."""
        return self.separator != "," and self.cells.holds(column, ",")

    def text(self, column: int) -> list[str]:
        """Cells ready for float(): a decimal comma made a point where the separator is not a comma."""
        cells = self.cells[column]
        return [c.replace(",", ".") for c in cells] if self.comma(column) else cells

    def first_bad(self, column: int) -> int | None:
        """The first row whose cell is neither empty nor a number."""
        comma, row = self.comma(column), 0
        for block in self.cells.blocks(column):
            for cell in block:
                if cell and not is_number(cell.replace(",", ".") if comma else cell):
                    return row
                row += 1
        return None

    def numbers(self, column: int) -> np.ndarray:
        """(P,) the column as numbers, NaN where a cell is empty; refuses text with line and column."""
        comma = self.comma(column)
        if comma and self.cells.holds(column, "."):
            self._refuse_mixed(column)
        found, done = np.empty(self.rows), 0
        underscore = self.cells.holds(column, "_")  # Python reads 1_000 as a number; a file does not mean it
        for block in self.cells.blocks(column):
            try:
                if underscore:
                    raise ValueError
                if comma:
                    block = [c.replace(",", ".") for c in block]
                found[done : done + len(block)] = _floats(block)
            except ValueError:
                row = self.first_bad(column)
                cell = short(self.cells[column][row])
                raise Refused("cell-not-a-number", self.place(row, column), cell=cell) from None
            done += len(block)
        return found

    def _refuse_mixed(self, column: int) -> None:
        """Refuse a column in which some numbers have a decimal comma and others a point: one of them is no decimal."""
        cells = self.cells[column]
        both = [
            next((r for r, c in enumerate(cells) if mark in c and is_number(c.replace(",", "."))), None)
            for mark in ",."
        ]
        if None not in both:
            row = max(both)
            cell, other = (short(cells[r][:25]) for r in (row, min(both)))
            raise Refused("decimal-mixed", self.place(row, column), cell=cell, other=other)


def _floats(block: list[str]) -> np.ndarray:
    """The numbers of cells, NaN of an empty one."""
    if "" in block:
        return np.array([float(c) if c else np.nan for c in block])
    return np.fromiter(map(float, block), float, len(block))


def is_number(text: str) -> bool:
    """Whether a text can be read as a number."""
    try:
        float(text)
    except ValueError:
        return False
    return "_" not in text


def parse(text: str, source: str) -> Table:
    """The table in `text`; refuses an empty file, ragged rows and cells that run over the end of a line."""
    if "\0" in text:
        raise Refused("table-binary", f"{source}, line {text.count(chr(10), 0, text.index(chr(0))) + 1}")
    if "\r" in text:
        text = text.replace("\r\n", "\n").replace("\r", "\n")
    comments: list[tuple[int, str]] = []
    numbers = array("q")
    names, separator, cells = (), ",", Cells(0)
    for lines, where in _chunks(text, comments):
        if not names:
            separator = next((s for s in SEPARATORS if s in lines[0]), ",")
        elif plain := _plain_cells(lines, separator, len(names)):
            cells.add_plain(plain)
            numbers.extend(where)
            continue
        rows = _rows(lines, where, separator, source)
        if not names:
            names = tuple(name.strip() for name in rows.pop(0))
            if len(names) > MAX_COLUMNS:
                raise Refused("table-too-wide", f"{source}, line {where[0]}", columns=len(names), limit=MAX_COLUMNS)
            cells = Cells(len(names))
        if set(map(len, rows)) - {len(names)}:
            i, row = next((i, r) for i, r in enumerate(rows, start=len(lines) - len(rows)) if len(r) != len(names))
            raise Refused("table-ragged", f"{source}, line {where[i]}", cells=len(row), columns=len(names))
        if rows:
            cells.add(rows)
        numbers.extend(where)
    if not names:
        raise Refused("table-empty", source)
    line = np.array(numbers[1:], dtype=int)
    return Table(names, cells, line, tuple(comments), numbers[0], separator, source)


def _chunks(text: str, comments: list) -> Iterator[tuple[list[str], Sequence[int]]]:
    """(lines that are rows, their numbers), a piece of the text at a time; comments are put aside."""
    number, start = 1, 0
    while start <= len(text):
        end = text.find("\n", start + _CHUNK)
        end = len(text) if end < 0 else end
        lines = text[start:end].split("\n")
        where: Sequence[int] = range(number, number + len(lines))
        special = _SPECIAL.search(text, start, end)
        number, start = number + len(lines), end + 1
        if special:
            kept = []
            for n, line in zip(where, lines):
                bare = line.strip()
                if bare.startswith("#"):
                    comments.append((n, bare.lstrip("#").strip()))
                elif bare.strip(",;\t "):
                    kept.append((n, line))
            if not kept:
                continue
            where, lines = zip(*kept)
        yield list(lines), where


def _plain_cells(lines: list[str], separator: str, width: int) -> list[str]:
    """The cells of lines one after another where nothing but separators has a meaning; else none.

    Millions of short rows: a list for each of them would take most of the time.
    """
    if max(map(len, lines)) > _LONGEST or {line.count(separator) for line in lines} != {width - 1}:
        return []
    joined = separator.join(lines)
    if _NOT_PLAIN.search(joined if separator != "\t" else joined.replace("\t", ",")):
        return []
    return joined.split(separator)


def _rows(lines: list[str], where: Sequence[int], separator: str, source: str) -> list[list[str]]:
    """The cells of every line; refuses a quoted cell that runs over the end of its line."""
    reader = csv.reader([*lines, ""], delimiter=separator, skipinitialspace=True)  # an open quote takes the last line
    rows: list[list[str]] = []
    try:
        rows.extend(reader)
    except csv.Error as error:
        raise Refused("table-cell", f"{source}, line {where[min(len(rows), len(where) - 1)]}", why=str(error)) from None
    if len(rows) != len(lines) + 1:
        counted = csv.reader([*lines, ""], delimiter=separator, skipinitialspace=True)
        at = next(i for i, _ in enumerate(counted) if counted.line_num != i + 1)
        raise Refused("cell-over-line-end", f"{source}, line {where[at]}")
    rows.pop()
    return rows


def read(path) -> Table:
    """Return the table in a file; refuses a file that is too large or is no table."""
    return parse(read_text(path, limit=LIMIT), str(path))


def safe_cell(text: str) -> str:
    """`text` as a cell: a text that a spreadsheet would take for a formula is neutralised, a number stays."""
    return text if is_number(text.replace(",", ".")) else neutral(text)
