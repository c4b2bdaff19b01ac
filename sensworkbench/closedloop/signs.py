# SPDX-License-Identifier: LGPL-2.1-or-later
"""A direction of sensing with the wrong sign: found before anything is traced, because effects would absorb it.

The components of an error share the carriages' rotations, so one direction read with the opposite sign spoils the fit
of all three.  A direction that shares none (x on a gantry whose x motion nothing else sees) cannot be checked so.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..core.machine import Machine
from ..messages import Message
from .design import design
from .fit import Fit, fit
from .problem import State
from .readings import Readings
from .settings import TraceSettings
from .stages import Tell, add_effects


def likelihood(readings: Readings, fitted: Fit) -> float:
    """Log-likelihood of a fit whose noise is estimated for each direction of sensing, up to a constant."""
    kinds, counts = np.unique(readings.kind, return_counts=True)
    return -sum(n * np.log(fitted.noise[k]) for k, n in zip(kinds.tolist(), counts.tolist(), strict=True))


def turned(readings: Readings, kind: int) -> Readings:
    """The readings with one direction of sensing read with the opposite sign."""
    return replace(readings, value=np.where(readings.kind == kind, -readings.value, readings.value))


def checkable(readings: Readings) -> list[int]:
    """The directions of sensing that can be held against each other: all three, or none."""
    kinds = np.unique(readings.kind).tolist()
    return kinds if kinds == [0, 1, 2] else []


def flipped_directions(machine: Machine, readings: Readings, declared: Fit, settings: TraceSettings) -> list[int]:
    """Directions of sensing (0, 1, 2) that fit the declared model much better with their sign turned; one at most.

    A strong undeclared effect can look the same: what effects explain on either side must still decide.
    """
    kinds = checkable(readings)
    if not kinds:
        return []
    reference = likelihood(readings, declared)
    gains = {}
    for kind in kinds:
        other = turned(readings, kind)
        gains[kind] = likelihood(other, fit(design(machine, other), other, settings=settings)) - reference
    best = max(gains, key=lambda k: gains[k])
    return [best] if gains[best] > max(settings.sign_gain, settings.sign_share * readings.rows) else []


def settled_signs(state: State, suspected: list[int], tell: Tell) -> list[int]:
    """Return the suspected direction, if turning its sign explains the readings with less than effects alone do.

    A turned sign looks like effects and a strong effect like a turned sign: both explanations are evaluated completely.
    """
    p, least = state.problem, state.settings.sign_gain
    for kind in suspected:
        scores = []
        for readings in (p.readings, turned(p.readings, kind)):
            story = add_effects(State(replace(p, readings=readings)), tell)
            scores.append(likelihood(readings, story.fit_with(story.candidates)) - least * len(story.steps))
        if scores[1] > scores[0] + least:
            return [kind]
    return []


def simpler_signs(state: State) -> list[int]:
    """Return the direction that, with its sign turned, makes some of the effects unnecessary.

    A turned sign that is hidden by a strong effect would otherwise be traced as effects of its own.
    """
    p, least, found = state.problem, state.settings.sign_gain, state.candidates
    score = likelihood(p.readings, state.fit_with(found)) - least * len(found)
    best, flipped = score + least / 2, []
    for kind in checkable(p.readings) if found else []:
        readings = turned(p.readings, kind)

        def with_(effects, readings=readings):
            return likelihood(readings, fit(p.design, readings, p.columns_of(effects), settings=p.settings))

        kept, value = list(found), with_(found)
        while kept and value > best:
            fewer = [[k for k in kept if k is not c] for c in kept]
            values = [with_(rest) for rest in fewer]
            i = int(np.argmax(values))
            if value - values[i] > least:
                break
            kept, value = fewer[i], values[i]
        if value - least * len(kept) > best:
            best, flipped = value - least * len(kept), [kind]
    return flipped


def flipped_remark(kind: int) -> Message:
    """The remark that a direction of sensing seems to be read with the opposite sign."""
    return Message("flipped-sign", direction=f"e{'xyz'[kind]}")
