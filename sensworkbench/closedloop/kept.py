# SPDX-License-Identifier: LGPL-2.1-or-later
"""What was computed once and is asked for again: fits, weighted rows and scanners, as far as memory allows."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from typing import TypeVar

T = TypeVar("T")
MOST = 256 * 2**20  # bytes of the arrays that are kept; a large table keeps its last fit or two
MOST_AT_THE_END = 64 * 2**20  # where a result is made, which needs room of its own


class Kept:
    """Values by key, the least recently used forgotten first.  `size` of a value is what it adds, in bytes."""

    def __init__(self, most: int = MOST):
        self.most, self.total = most, 0
        self.values: dict[Hashable, tuple[object, int]] = {}

    def get(self, key: Hashable | None, make: Callable[[], T], size: Callable[[T], int]) -> T:
        """The value of `key`; None is a key that is never kept."""
        if key is None:
            return make()
        found = self.values.pop(key, None)
        if found is None:
            value = make()
            found = value, size(value)
            self.total += found[1]
        self.values[key] = found
        self.trim(self.most, 1)
        return found[0]

    def trim(self, most: int, least: int = 0) -> None:
        """Forget the least recently used beyond `most` bytes, but for `least` values."""
        while self.total > most and len(self.values) > least:
            oldest = next(iter(self.values))
            self.total -= self.values.pop(oldest)[1]
