# SPDX-License-Identifier: LGPL-2.1-or-later
"""Words that reports share: sentences of one language, positions and units."""

from __future__ import annotations

from sensworkbench.core.joints import Joint
from sensworkbench.messages import Message

UNIT_SHOWN = {"um": "µm", "urad": "µrad", "arcsec": "arcsec", "mm": "mm", "rad": "rad"}


class Words:
    """Sentences of one language: `words("report-title", machine="M")` is the text of that message."""

    def __init__(self, language: str = "en"):
        self.language = language

    def __call__(self, code: str, **fields) -> str:
        return Message(code, **fields).text(self.language)

    def of(self, message: Message) -> str:
        """The text of a message."""
        return message.text(self.language)


def position_text(joints: tuple[Joint, ...], values) -> str:
    """`X 200, Y 150, Z -100 mm`, or `X 10 mm, C 30 deg` where the units differ; `values` in the joints' units."""
    units = {j.unit for j in joints}
    if len(units) == 1:
        return ", ".join(f"{j.name} {v:g}" for j, v in zip(joints, values)) + f" {units.pop()}"
    return ", ".join(f"{j.name} {v:g} {j.unit}" for j, v in zip(joints, values))


def minus(text: str) -> str:
    """`text` with minus signs in place of hyphens."""
    return text.replace("-", "−")
