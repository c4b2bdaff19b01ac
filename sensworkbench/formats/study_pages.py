# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the files of the smaller studies share: the head of their JSON, their tables as CSV, the frame of their page."""

from __future__ import annotations

import csv
import datetime
import io
from collections.abc import Iterable, Sequence

from sensworkbench import __version__
from sensworkbench.core.machine import Machine

from . import html
from .words import Words


def head(name: str, version: int, machine: Machine) -> dict:
    """The first keys of a study's JSON file: format, version, machine."""
    return {
        "format": name,
        "version": version,
        "machine": {"name": machine.name, "structure": machine.structure},
    }


def table(columns: Sequence[str], rows: Iterable[Sequence]) -> str:
    """A table as CSV, lines ended by a line feed."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows(rows)
    return stream.getvalue()


def page(words: Words, title: str, subtitle: str, *parts) -> str:
    """A page with the usual foot, in the language of `words`."""
    foot = words("report-footer", version=__version__, date=datetime.date.today().isoformat())
    return html.page(title, subtitle, *parts, footer=foot, language=words.language)
