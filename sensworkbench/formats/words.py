# SPDX-License-Identifier: LGPL-2.1-or-later
"""Words that reports share: sentences of one language, names of errors and bodies, positions and tolerances."""

from __future__ import annotations

from sensworkbench.core.errors import AXES, SQUARENESS, Component
from sensworkbench.core.joints import Joint
from sensworkbench.core.machine import Machine
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


def error_message(c: Component) -> Message:
    """What an error component is: `straightness of X along Y`."""
    fields = {"body": c.body, "axis": AXES[c.axis]}
    if c.kind == SQUARENESS:
        return Message("error-squareness", body=c.body, other=AXES[3 - c.axis - c.along])
    if c.line:
        return Message("error-axis-orientation" if c.angular else "error-axis-position", **fields)
    if c.body == "W":
        return Message("error-workpiece-rotation" if c.angular else "error-workpiece-shift", axis=fields["axis"])
    if c.body == "T":
        return Message("error-spindle-tilt" if c.angular else "error-spindle-shift", axis=fields["axis"])
    own = c.axis == c.along
    if c.angular:
        return Message("error-roll" if own else "error-tilt", **fields)
    return Message("error-positioning", body=c.body) if own else Message("error-straightness", **fields)


def body_message(machine: Machine, body: str) -> Message:
    """What a body is called: `X carriage`."""
    if body == "T":
        return Message("body-tool")
    if body == "W":
        return Message("body-workpiece")
    if body not in machine.names:
        return Message("body-source", name=body)
    return Message("body-carriage" if machine.joint(body).slides else "body-rotary", name=body)


def position_text(joints: tuple[Joint, ...], values) -> str:
    """`X 200, Y 150, Z -100 mm`, or `X 10 mm, C 30 deg` where the units differ; `values` in the joints' units."""
    units = {j.unit for j in joints}
    if len(units) == 1:
        return ", ".join(f"{j.name} {v:g}" for j, v in zip(joints, values)) + f" {units.pop()}"
    return ", ".join(f"{j.name} {v:g} {j.unit}" for j, v in zip(joints, values))


def minus(text: str) -> str:
    """`text` with minus signs in place of hyphens."""
    return text.replace("-", "−")
