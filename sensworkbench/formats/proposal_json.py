# SPDX-License-Identifier: LGPL-2.1-or-later
"""`proposal.json`: what a document proposes as a machine, with evidence, confidence and what is left to ask.

`{"format":"sens-proposal","version":1,...}`; lengths in mm, words in English.
"""

from __future__ import annotations

import json
import math
from dataclasses import dataclass

from ..messages import Message

FORMAT, VERSION = "sens-proposal", 1


@dataclass(frozen=True)
class ProposedAxis:
    """direction : unit vector, document coordinates.  travel : (low, high) in mm.  confidence : 0 to 1."""

    kind: str
    direction: tuple[float, float, float]
    travel: tuple[float, float]
    evidence: tuple[Message, ...]
    confidence: float


@dataclass(frozen=True)
class Proposal:
    """bodies : "F", axis names, "T", "W" -> labels of parts.  structure : "YFZX" or None.  questions : what is left.

    kind : "serial", "parallel" or "unknown".  complete : a machine can be made of it.  seconds : it took.
    """

    complete: bool
    kind: str
    structure: str | None
    bodies: dict[str, tuple[str, ...]]
    axes: dict[str, ProposedAxis]
    questions: tuple[Message, ...]
    remarks: tuple[Message, ...]
    seconds: float


def to_dict(proposal: Proposal) -> dict:
    """The JSON object of a proposal."""
    return {
        "format": FORMAT,
        "version": VERSION,
        "complete": proposal.complete,
        "kind": proposal.kind,
        "structure": proposal.structure,
        "bodies": {body: list(labels) for body, labels in proposal.bodies.items()},
        "axes": {
            name: {
                "kind": axis.kind,
                "direction": [_number(v, 9) for v in axis.direction],
                "travel": [_number(v, 4) for v in axis.travel],
                "evidence": [str(m) for m in axis.evidence],
                "confidence": _number(axis.confidence, 3),
            }
            for name, axis in proposal.axes.items()
        },
        "questions": [str(m) for m in proposal.questions],
        "remarks": [str(m) for m in proposal.remarks],
        "seconds": _number(proposal.seconds, 2),
    }


def _number(value: float, digits: int) -> float:
    value = float(value)
    if not math.isfinite(value):
        raise ValueError(f"{value} in a proposal")
    return round(value, digits) + 0.0


def dumps(proposal: Proposal) -> str:
    """The text of proposal.json."""
    return json.dumps(to_dict(proposal), indent=1, ensure_ascii=False) + "\n"
