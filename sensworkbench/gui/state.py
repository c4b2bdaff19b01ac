# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the window remembers of a document while it is open: one object per document, dropped when it is closed.

Nothing here is stored in files, and no other module of the window keeps anything between two calls.
"""

from __future__ import annotations

from contextlib import contextmanager
from dataclasses import dataclass, field


@dataclass
class DocumentState:
    """reviewed : name of the machine that the review showed last.  panel : the task panel that works on the document.

    sizes : machine -> its extent in mm, to which arrows are matched.  answering : machines whose indices are about to
    be computed again.  adopting : the document is about to be taken over.  examined : it was looked at for damage.
    ranges : result, and result with its inputs -> upper end of its automatic colours.
    scenarios : machine -> what-if scenarios that are kept.
    quiet : above zero while the program itself selects, which chooses nothing.
    """

    reviewed: str = ""
    panel: object = None
    sizes: dict[str, float] = field(default_factory=dict)
    ranges: dict[str, float] = field(default_factory=dict)
    scenarios: dict[str, list] = field(default_factory=dict)
    answering: set[str] = field(default_factory=set)
    adopting: bool = False
    examined: bool = False
    quiet: int = 0


_states: dict[str, DocumentState] = {}


def of(document) -> DocumentState:
    """The state of a document (or of the document with this name)."""
    return _states.setdefault(document if isinstance(document, str) else document.Name, DocumentState())


def known() -> list[DocumentState]:
    """The states of all documents that have one."""
    return list(_states.values())


def forget(name: str) -> None:
    """The document was closed."""
    _states.pop(name, None)


@contextmanager
def quietly(document):
    """What is selected inside is not the user's choice."""
    found = of(document)
    found.quiet += 1
    try:
        yield
    finally:
        found.quiet -= 1
