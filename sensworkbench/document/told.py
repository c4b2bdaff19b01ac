# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts that properties hold as JSON: a message with its code and fields, an objective with its name and fields.

Documents of earlier versions hold English sentences in the same properties; they are shown as they are.
"""

from __future__ import annotations

import json

from ..core import objectives
from ..messages import Message, Refused


def dumps(message: Message) -> str:
    """The text that a property holds for a message: JSON of code, English text and fields."""
    return json.dumps(message.to_dict(), ensure_ascii=False, sort_keys=True)


def words(text: str, language: str = "en") -> str:
    """The sentence of a property that `dumps` has written, in `language`; any other text as it is."""
    data = _json(text)
    if not isinstance(data, dict) or "code" not in data:
        return text
    try:
        return Message.from_dict(data).text(language)
    except (KeyError, ValueError):  # of a later version
        return str(data.get("text", text))


def objective_text(objective: objectives.Objective) -> str:
    """The text that a property holds for an objective: JSON of its name and fields."""
    return json.dumps(objective.to_json(), sort_keys=True)


def objective(text: str) -> objectives.Objective:
    """The objective of a property that `objective_text` has written; refuses what no registered objective can read."""
    data = _json(text)
    if not isinstance(data, dict):
        raise Refused("objective-text", "Objective", text=text[:60])
    return objectives.from_json(data)


def has_shares(text: str) -> bool:
    """Whether the indices of an objective are shares of a variance; True where it is not registered."""
    try:
        return objective(text).has_shares
    except Refused:
        return True


def objective_data(text: str):
    """What `objective` would read, for comparison: plain data, or the text where it is no objective."""
    try:
        return objective(text).to_json()
    except Refused:
        return text


def _json(text: str):
    """What a JSON object in a text holds, None where the text is another."""
    if not text.startswith("{"):
        return None
    try:
        return json.loads(text)
    except ValueError:
        return None
