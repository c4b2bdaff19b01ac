# SPDX-License-Identifier: LGPL-2.1-or-later
"""What only a person can settle, the most important first."""

from __future__ import annotations

from ...messages import Message
from .found import Found, Question, State
from .links import Chains, label_of


def ask_bodies(made: Found, state: State) -> None:
    """Ask for bed and bodies, where nothing shows what slides."""
    made.remarks.append(Message("propose-nothing-slides"))
    made.questions.append(Question("bed", Message("propose-ask-bed")))
    for name in "XYZ":
        made.questions.append(Question(f"body:{name}", Message("propose-ask-moves", axis=name), "parts"))


def ask(state: State, reading: Chains, made: Found, sure: float, answers) -> None:
    """What is left, the most important first; one is asked at a time."""

    def ask(name: str, message: Message, kind: str = "part", choices: tuple = ()) -> None:
        if name not in answers:
            made.questions.append(Question(name, message, kind, choices))

    if reading.bed_sure < 0.6 and "body:F" not in answers:
        ask("bed", Message("propose-ask-bed-is", part=label_of(state.document, reading.bodies[reading.bed])))
    missing = [a for a in "XYZ" if a not in made.axes]
    if len(made.axes) < 3 and not (state.said.lathe and len(made.axes) == 2) and not answers.get("enough"):
        used = [g for k in reading.links for g in k.guides]
        spare = next((g for g in state.guides if g not in used and g.weight > 0.3), None)
        message = Message("propose-ask-moves", axis=missing[0])
        if spare is not None:
            label = state.document.units[min(spare.rails)].label
            message = Message("propose-ask-rails", part=label, axis=missing[0])
        ask(f"body:{missing[0]}", message, "parts")
        choices = ((True, Message("propose-choice-yes")), (False, Message("propose-choice-no")))
        ask("enough", Message("propose-ask-enough", axes=", ".join(sorted(made.axes))), "choice", choices)
    if sure < 0.65 and "work" not in answers:
        ask("tool", Message("propose-ask-tool"))
    rows = state.document.frame.rows
    along = tuple((tuple(float(v) for v in a), Message("propose-choice-along", vector=_along(a))) for a in rows)
    for name, axis in made.axes.items():
        if axis.confidence < 0.5:
            label = max(made.bodies[name], key=lambda u: u.bulk).label
            ask(f"direction:{name}", Message("propose-ask-direction", part=label, axis=name), "choice", along)
        if axis.assumed and axis.joint is None:
            low, high = axis.travel
            ask(f"travel:{name}", Message("propose-ask-travel", axis=name, low=low, high=high), "travel")


def _along(a) -> str:
    return "(" + ", ".join(f"{v + 0.0:.3g}" for v in a) + ")"
