# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a proposal is: the machine that was found, what speaks for it, and the questions that are left."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from ...messages import Message
from .reading import Document, Unit
from .speech import Words

ASSUMED_TRAVEL = 100.0  # mm to either side, where nothing says how far


LEAST = 0.3  # confidence below which an axis is asked for


@dataclass(frozen=True)
class Question:
    """One thing that only a person can settle.  name : key of `answers`.  kind : "part", "parts" or "choice".

    choices : (value, Message or text) of a choice.
    """

    name: str
    message: Message
    kind: str = "part"
    choices: tuple = ()


@dataclass
class Axis:
    """A proposed axis.  u : unit vector, document coordinates.  travel : mm.  evidence : the strongest first."""

    name: str
    u: np.ndarray
    travel: tuple[float, float]
    evidence: list[Message]
    confidence: float
    units: list[Unit]
    point: np.ndarray | None = None
    assumed: bool = False
    joint: object = None  # PartPath of a slider joint of the document
    reverse: bool = False
    rail: Unit | None = None


@dataclass
class Found:
    """What was found.  bodies : "F", axis names, "T", "W" -> parts.  kind : "serial", "parallel" or "unknown".

    complete : a machine can be made of it.  structure : workpiece to tool, such as "YFZX", or None.
    """

    kind: str = "unknown"
    complete: bool = False
    structure: str | None = None
    bodies: dict[str, list[Unit]] = field(default_factory=dict)
    workpiece_chain: list[str] = field(default_factory=list)
    tool_chain: list[str] = field(default_factory=list)
    axes: dict[str, Axis] = field(default_factory=dict)
    questions: list[Question] = field(default_factory=list)
    remarks: list[Message] = field(default_factory=list)
    left_out: list[Unit] = field(default_factory=list)
    reasons: dict[str, list[Message]] = field(default_factory=dict)
    confidence: dict[str, float] = field(default_factory=dict)  # of the bed, and of the sides
    seconds: float = 0.0
    document: Document | None = None
    state: object = None  # for `again`
    up: np.ndarray = field(default_factory=lambda: np.array([0.0, 0.0, 1.0]))
    lathe: bool = False
    made: list[str] = field(default_factory=list)  # names of the objects that `building.build` made of it


@dataclass
class State:
    """What does not depend on answers, so that an answer is weighed at once."""

    document: Document
    title: str
    axes: np.ndarray
    size: float
    minor: set
    found: object
    guides: list
    said: Words
