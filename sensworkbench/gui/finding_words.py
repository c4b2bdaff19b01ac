# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sentences of a trace in the language of the window, from their codes (see `sensworkbench.messages`).

Traces of earlier versions have no codes; their English sentences are shown as they are.
"""

from __future__ import annotations

from ..formats import trace_json
from .messages import language


def said(data, key: str) -> str:
    """The sentence under `key` of an entry of trace.json."""
    return trace_json.text(data, key, language())


def all_said(data, key: str) -> list[str]:
    """The sentences under `key` of an entry of trace.json."""
    return trace_json.texts(data, key, language())
